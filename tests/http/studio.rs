//! The studio's files as the server sends them. `scripts/studio` tests the page itself.

use crate::app::{TestApp, problem};
use reqwest::{Method, header};

#[tokio::test]
async fn the_server_has_every_file_that_the_page_names() {
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
            "woff2" => "font/woff2",
            "webp" => "image/webp",
            "txt" => "text/plain; charset=utf-8",
            _ => "text/html; charset=utf-8",
        };
        assert_eq!(response.headers()[header::CONTENT_TYPE], expected, "{path}");
        assert!(
            response.headers()[header::CONTENT_SECURITY_POLICY].to_str().unwrap().starts_with("default-src 'self'")
        );
        assert_eq!(response.headers()[header::X_CONTENT_TYPE_OPTIONS], "nosniff");
        let is_text = expected.starts_with("text/html") || expected.starts_with("text/css");
        let bytes = response.bytes().await.unwrap();
        if is_text {
            let text = std::str::from_utf8(&bytes).unwrap();
            let named = text.split(['"', '\'', '(', ')']).filter_map(|word| {
                let file = word.strip_prefix("studio/").unwrap_or(word);
                let ending = file.rsplit_once('.')?.1;
                let is_file =
                    ["js", "css", "svg", "woff2", "webp", "txt"].contains(&ending) && !file.contains(['/', ' ']);
                is_file.then(|| format!("/studio/{file}"))
            });
            wanted.extend(named);
        }
        seen.push(path);
    }
    assert!(seen.len() >= 7, "{seen:?}");
}

#[tokio::test]
async fn a_file_that_has_not_changed_is_not_sent_again() {
    let app = TestApp::start().await;
    let tag = app.get("/studio/studio.js").await.headers()[header::ETAG].clone();
    let again = app.request(Method::GET, "/studio/studio.js").header(header::IF_NONE_MATCH, &tag).send().await.unwrap();
    assert_eq!((again.status().as_u16(), again.headers()[header::ETAG].clone()), (304, tag));
    assert!(again.bytes().await.unwrap().is_empty());
}

/// Checks that the page may share memory with the worker of its solvers, and that their modules have the media type
/// with which browsers compile them while they load.
#[tokio::test]
async fn the_page_is_isolated_and_has_the_modules_of_its_solvers() {
    let app = TestApp::start().await;
    for path in ["/", "/studio/worker.js"] {
        let headers = app.get(path).await.headers().clone();
        assert_eq!(headers["cross-origin-opener-policy"], "same-origin", "{path}");
        assert_eq!(headers["cross-origin-embedder-policy"], "require-corp", "{path}");
    }
    for path in ["/studio/shapes.wasm", "/studio/structures.wasm"] {
        let response = app.get(path).await;
        assert_eq!(response.status(), 200, "{path}");
        assert_eq!(response.headers()[header::CONTENT_TYPE], "application/wasm", "{path}");
        assert!(response.bytes().await.unwrap().starts_with(b"\0asm"), "{path}");
    }
}

/// Checks that any site may show the embedded view in a frame, and that no site may do so with the editing page.
#[tokio::test]
async fn only_the_embedded_view_may_be_framed() {
    let app = TestApp::start().await;
    let policy = async |path: &str| {
        let response = app.get(path).await;
        response.headers()[header::CONTENT_SECURITY_POLICY].to_str().unwrap().to_owned()
    };
    assert!(policy("/").await.ends_with("frame-ancestors 'none'"));
    assert!(policy("/studio/embed.html").await.ends_with("frame-ancestors *"));
}

#[tokio::test]
async fn other_files_are_not_found() {
    let app = TestApp::start().await;
    for path in ["/studio/nothing.js", "/studio/index.html%2f", "/studio/..%2fCargo.toml", "/studio/"] {
        problem(app.get(path).await, 404).await;
    }
}

#[tokio::test]
async fn an_operator_turns_the_studio_off() {
    let off = TestApp::start_with(&[("PLATEAU_HTTP__STUDIO", "false")]).await;
    for path in ["/", "/studio/studio.js"] {
        let problem = problem(off.get(path).await, 404).await;
        assert!(problem["detail"].as_str().unwrap().contains("http.studio"), "{path}: {problem}");
    }
    assert_eq!(off.get("/docs/").await.status(), 200);
}
