//! `Idempotency-Key`: sending a request again creates no second job.

use crate::app::{MINIMAL, TestApp, problem, small_film};
use reqwest::{Method, Response};
use serde_json::Value;

async fn post(app: &TestApp, key: &str, height: f64) -> Response {
    app.request(Method::POST, MINIMAL).header("idempotency-key", key).json(&small_film(height)).send().await.unwrap()
}

#[tokio::test]
async fn the_same_key_and_body_give_the_same_job_in_its_current_state() {
    let app = TestApp::start().await;
    let first: Value = post(&app, "k1", 0.11).await.json().await.unwrap();
    let waited = app.request(Method::GET, first["links"]["self"].as_str().unwrap()).header("prefer", "wait=60");
    let ended: Value = waited.send().await.unwrap().json().await.unwrap();
    let again = post(&app, "k1", 0.11).await;
    assert_eq!(again.status(), 200);
    assert_eq!(again.json::<Value>().await.unwrap(), ended);
    let other: Value = post(&app, "k2", 0.11).await.json().await.unwrap();
    assert_ne!(other["id"], first["id"]);
}

#[tokio::test]
async fn the_same_key_with_another_body_is_422() {
    let app = TestApp::start().await;
    post(&app, "k", 0.11).await;
    let conflict = problem(post(&app, "k", 0.12).await, 422).await;
    assert_eq!(conflict["type"], "/problems/idempotency-key-conflict");
}
