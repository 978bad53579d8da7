//! `Prefer: wait` on POST and GET.

use crate::app::{MINIMAL, RULED, TestApp, large_strip, small_film};
use reqwest::Method;
use serde_json::Value;

#[tokio::test]
async fn a_request_without_a_wait_is_answered_with_202() {
    let app = TestApp::start().await;
    let response = app.post(MINIMAL, &small_film(0.4)).await;
    assert_eq!(response.status(), 202);
    assert!(response.headers().contains_key("retry-after"));
    assert!(!response.headers().contains_key("preference-applied"));
    let location = response.headers()["location"].to_str().unwrap().to_owned();
    let job: Value = response.json().await.unwrap();
    assert_eq!(job["links"]["self"], location.as_str());
    let waited = app.request(Method::GET, &location).header("prefer", "wait=60").send().await.unwrap();
    assert_eq!(waited.headers()["preference-applied"], "wait=60");
    let job: Value = waited.json().await.unwrap();
    assert_eq!((job["status"].as_str(), job["progress"]["fraction"].as_f64()), (Some("succeeded"), Some(1.0)));
    for field in ["created_at", "started_at", "finished_at", "expires_at"] {
        assert!(job[field].as_str().unwrap().ends_with('Z'), "{field}");
    }
}

#[tokio::test]
async fn a_wait_that_ends_before_the_job_is_answered_with_202() {
    let app = TestApp::start().await;
    let request = app.request(Method::POST, RULED).header("prefer", "wait=0").json(&large_strip(2000));
    let response = request.send().await.unwrap();
    assert_eq!(
        (response.status().as_u16(), response.headers()["preference-applied"].to_str().unwrap()),
        (202, "wait=0")
    );
}

#[tokio::test]
async fn a_wait_beyond_the_servers_limit_is_cut_and_an_invalid_one_is_ignored() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__WAIT_MAX_S", "5")]).await;
    let post = |preference: &'static str, height: f64| {
        app.request(Method::POST, MINIMAL).header("prefer", preference).json(&small_film(height)).send()
    };
    let response = post("wait=100000", 0.5).await.unwrap();
    assert_eq!(
        (response.status().as_u16(), response.headers()["preference-applied"].to_str().unwrap()),
        (200, "wait=5")
    );
    let response = post("wait=soon", 0.6).await.unwrap();
    assert_eq!(response.status(), 202);
    assert!(!response.headers().contains_key("preference-applied"));
}
