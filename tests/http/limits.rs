//! Limits: a full queue and slow clients.

use crate::app::{MINIMAL, TestApp, problem, small_film};

#[tokio::test]
async fn a_full_queue_is_429_with_retry_after_until_there_is_room() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_JOBS__QUEUE_LENGTH", "3")]).await;
    let mut links = Vec::new();
    for k in 0..3 {
        let response = app.post(MINIMAL, &small_film(f64::from(k))).await;
        assert_eq!(response.status(), 202);
        links.push(response.headers()["location"].to_str().unwrap().to_owned());
    }
    let full = app.post(MINIMAL, &small_film(9.0)).await;
    assert!(full.headers().contains_key("retry-after"));
    problem(full, 429).await;
    app.request(reqwest::Method::DELETE, &links[0]).send().await.unwrap();
    assert_eq!(app.post(MINIMAL, &small_film(9.0)).await.status(), 202);
}

#[tokio::test]
async fn a_body_that_is_sent_too_slowly_is_408() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__BODY_TIMEOUT_MS", "100")]).await;
    let never = futures_util::stream::pending::<Result<Vec<u8>, std::io::Error>>();
    let request = app.request(reqwest::Method::POST, MINIMAL).header("content-type", "application/json");
    problem(request.body(reqwest::Body::wrap_stream(never)).send().await.unwrap(), 408).await;
}
