//! The studio's files as the server gives them out; `scripts/studio.test.mjs` drives the page itself.

use crate::app::{TestApp, problem};
use reqwest::{Method, header};

#[tokio::test]
async fn the_page_finds_every_file_that_it_names() {
    let app = TestApp::start().await;
    let mut wanted = vec!["/".to_owned()];
    let mut seen = Vec::new();
    while let Some(path) = wanted.pop() {
        if seen.contains(&path) {
            continue;
        }
        let response = app.get(&path).await;
        assert_eq!(response.status(), 200, "{path}");
        let expected = match path.rsplit('.').next().unwrap() {
            "js" => "text/javascript; charset=utf-8",
            "css" => "text/css; charset=utf-8",
            "svg" => "image/svg+xml",
            _ => "text/html; charset=utf-8",
        };
        assert_eq!(response.headers()[header::CONTENT_TYPE], expected, "{path}");
        assert!(
            response.headers()[header::CONTENT_SECURITY_POLICY].to_str().unwrap().starts_with("default-src 'self'")
        );
        let text = response.text().await.unwrap();
        let named = text.split(['"', '\'']).filter_map(|word| {
            let file = word.strip_prefix("studio/").or_else(|| word.strip_prefix("./"))?;
            file.contains('.').then(|| format!("/studio/{file}"))
        });
        wanted.extend(named);
        seen.push(path);
    }
    assert!(seen.len() > 10, "{seen:?}");
}

#[tokio::test]
async fn a_file_that_has_not_changed_is_not_sent_again() {
    let app = TestApp::start().await;
    let tag = app.get("/studio/main.js").await.headers()[header::ETAG].clone();
    let again = app.request(Method::GET, "/studio/main.js").header(header::IF_NONE_MATCH, &tag).send().await.unwrap();
    assert_eq!((again.status().as_u16(), again.headers()[header::ETAG].clone()), (304, tag));
    assert!(again.bytes().await.unwrap().is_empty());
}

#[tokio::test]
async fn other_files_are_not_found() {
    let app = TestApp::start().await;
    for path in ["/studio/nothing.js", "/studio/index.html%2f", "/studio/..%2fCargo.toml", "/studio/"] {
        problem(app.get(path).await, 404).await;
    }
}
