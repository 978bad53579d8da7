//! Large results in an S3-compatible bucket.

use crate::app::{MINIMAL, TestApp, small_film};
use crate::hold::until;
use axum::Router;
use axum::body::Bytes;
use axum::extract::{Request, State};
use axum::http::{HeaderMap, Method, StatusCode};
use axum::response::{IntoResponse, Response};
use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

/// A small S3 server with PUT, GET and DELETE by path. It accepts requests that are signed with the name of the right
/// key.
#[derive(Clone, Default)]
struct Bucket {
    objects: Arc<Mutex<BTreeMap<String, Bytes>>>,
    refuses: Arc<Mutex<bool>>,
}

impl Bucket {
    async fn start() -> (Self, String) {
        let bucket = Self::default();
        let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
        let url = format!("http://{}", listener.local_addr().unwrap());
        let routes = Router::new().fallback(answer).with_state(bucket.clone());
        tokio::spawn(async move { axum::serve(listener, routes).await });
        (bucket, url)
    }

    /// Returns the names of the results' objects. The server's probe object may exist at any time and is left out.
    fn names(&self) -> Vec<String> {
        let objects = self.objects.lock().unwrap();
        objects.keys().filter(|name| !name.contains("/probe-")).cloned().collect()
    }
}

fn is_signed(headers: &HeaderMap) -> bool {
    let value = headers.get("authorization").and_then(|value| value.to_str().ok()).unwrap_or_default();
    value.starts_with("AWS4-HMAC-SHA256 Credential=test-key/") && value.contains("/eu-test-1/s3/aws4_request")
}

async fn answer(State(bucket): State<Bucket>, request: Request) -> Response {
    let (parts, body) = request.into_parts();
    let body = axum::body::to_bytes(body, 1 << 30).await.unwrap();
    let path = parts.uri.path().to_owned();
    if !is_signed(&parts.headers) || *bucket.refuses.lock().unwrap() {
        return StatusCode::FORBIDDEN.into_response();
    }
    let mut objects = bucket.objects.lock().unwrap();
    match parts.method {
        Method::PUT => {
            objects.insert(path, body);
            [("etag", "\"1\"")].into_response()
        }
        Method::GET => match objects.get(&path) {
            Some(body) => {
                ([("etag", "\"1\""), ("last-modified", "Sat, 21 Nov 2026 00:00:00 GMT")], body.clone()).into_response()
            }
            None => StatusCode::NOT_FOUND.into_response(),
        },
        Method::DELETE => {
            objects.remove(&path);
            StatusCode::NO_CONTENT.into_response()
        }
        _ => StatusCode::METHOD_NOT_ALLOWED.into_response(),
    }
}

async fn start(url: &str) -> TestApp {
    let settings = [
        ("PLATEAU_STORE__RESULTS", "s3://plateau/results/of-ours"),
        ("PLATEAU_STORE__INLINE_BYTES", "100"),
        ("AWS_ENDPOINT_URL", url),
        ("AWS_ALLOW_HTTP", "true"),
        ("AWS_REGION", "eu-test-1"),
        ("AWS_ACCESS_KEY_ID", "test-key"),
        ("AWS_SECRET_ACCESS_KEY", "test-secret"),
    ];
    TestApp::start_with(&settings).await
}

/// Waits until the server's readiness is `ready`.
async fn until_ready(app: &TestApp, ready: bool) {
    until("the readiness changes", async || (app.get("/health/ready").await.status() == 200) == ready).await;
}

#[tokio::test]
async fn large_results_are_objects_and_a_bucket_that_refuses_costs_no_attempt() {
    let (bucket, url) = Bucket::start().await;
    let app = start(&url).await;
    let job = app.solve(MINIMAL, &small_film(0.3)).await;
    let expected = format!("/plateau/results/of-ours/{}-1", job["id"].as_str().unwrap());
    assert_eq!(bucket.names(), [expected]);
    assert!(!app.folder.path().join("data/results").exists());
    let mesh = app.get(job["links"]["mesh"].as_str().unwrap()).await;
    assert_eq!(mesh.status(), 200);
    assert_eq!(&mesh.bytes().await.unwrap()[..4], b"glTF");

    *bucket.refuses.lock().unwrap() = true;
    let held: Value = app.post(MINIMAL, &small_film(0.4)).await.json().await.unwrap();
    until_ready(&app, false).await;
    let path = held["links"]["self"].as_str().unwrap();
    assert_eq!(app.get_json(path).await["status"], "running");
    // Other jobs are accepted but not started.
    let waiting: Value = app.post(MINIMAL, &small_film(0.5)).await.json().await.unwrap();
    *bucket.refuses.lock().unwrap() = false;
    for job in [&held, &waiting] {
        let wait = app.request(Method::GET, job["links"]["self"].as_str().unwrap()).header("prefer", "wait=60");
        let ended: Value = wait.send().await.unwrap().json().await.unwrap();
        assert_eq!(ended["status"], "succeeded", "{ended:#}");
        let events = app.get(job["links"]["events"].as_str().unwrap()).await.text().await.unwrap();
        assert!(events.contains("id: 1.") && !events.contains("id: 2."), "the job needed only one attempt: {events}");
    }
    until_ready(&app, true).await;
    assert_eq!(bucket.names().len(), 3);
}

#[tokio::test]
async fn a_bucket_that_refuses_writes_is_detected_at_the_start() {
    let (bucket, url) = Bucket::start().await;
    *bucket.refuses.lock().unwrap() = true;
    let app = start(&url).await;
    until_ready(&app, false).await;
    let job: Value = app.post(MINIMAL, &small_film(0.4)).await.json().await.unwrap();
    let path = job["links"]["self"].as_str().unwrap();
    assert_eq!(app.get_json(path).await["status"], "queued");
    *bucket.refuses.lock().unwrap() = false;
    until_ready(&app, true).await;
    let ended: Value =
        app.request(Method::GET, path).header("prefer", "wait=60").send().await.unwrap().json().await.unwrap();
    assert_eq!(ended["status"], "succeeded");
}
