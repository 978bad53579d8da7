//! More connections than the server allows.

use crate::app::{MINIMAL, TestApp, small_film};
use serde_json::Value;
use std::time::Duration;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;

const CONNECTIONS: usize = 8;

async fn start(workers: &str) -> TestApp {
    TestApp::start_with(&[
        ("PLATEAU_WORKERS", workers),
        ("PLATEAU_HTTP__CONNECTIONS", &CONNECTIONS.to_string()),
        // The timeout is so long that no connection ends by itself during the test.
        ("PLATEAU_HTTP__HEADER_TIMEOUT_MS", "600000"),
        ("PLATEAU_HTTP__REQUESTS_SHARE_PERCENT", "100"),
    ])
    .await
}

async fn connect(app: &TestApp) -> TcpStream {
    TcpStream::connect(app.url.strip_prefix("http://").unwrap()).await.unwrap()
}

/// Sends a request on this connection. Returns false if the server closes it.
async fn ask(stream: &mut TcpStream) -> bool {
    stream.write_all(b"GET /health/live HTTP/1.1\r\nHost: localhost\r\n\r\n").await.unwrap();
    let mut answer = Vec::new();
    let mut piece = [0; 4096];
    while !answer.ends_with(b"}") {
        match stream.read(&mut piece).await {
            Ok(0) | Err(_) => return false,
            Ok(read) => answer.extend_from_slice(&piece[..read]),
        }
    }
    answer.starts_with(b"HTTP/1.1 200 ")
}

async fn is_closed(stream: &mut TcpStream) -> bool {
    !matches!(stream.read(&mut [0; 16]).await, Ok(read) if read > 0)
}

#[tokio::test]
async fn a_new_connection_replaces_the_longest_idle_one() {
    let app = start("0").await;
    // The first connection has sent nothing, the second has sent half a request, and the others have been answered.
    let mut silent = connect(&app).await;
    let mut half = connect(&app).await;
    half.write_all(b"GET /health/live HTTP/1.1\r\nHost:").await.unwrap();
    let mut answered = Vec::new();
    for _ in 2..CONNECTIONS {
        let mut stream = connect(&app).await;
        assert!(ask(&mut stream).await);
        answered.push(stream);
    }
    // The HTTP client of this test has not connected yet, so three new connections replace three old ones.
    let mut newcomers = Vec::new();
    for _ in 0..3 {
        let mut stream = connect(&app).await;
        assert!(ask(&mut stream).await);
        newcomers.push(stream);
    }
    assert!(is_closed(&mut silent).await && is_closed(&mut half).await);
    assert!(is_closed(&mut answered[0]).await);
    for stream in answered[1..].iter_mut().chain(&mut newcomers) {
        assert!(ask(stream).await, "a connection was closed that was not the longest idle one");
    }
}

/// Opens a stream of events that has begun.
async fn watch(app: &TestApp, events: &str) -> TcpStream {
    let mut stream = connect(app).await;
    let request = format!("GET {events} HTTP/1.1\r\nHost: localhost\r\n\r\n");
    stream.write_all(request.as_bytes()).await.unwrap();
    assert!(stream.read(&mut [0; 64]).await.unwrap() > 0);
    stream
}

#[tokio::test]
async fn health_is_answered_while_every_connection_is_in_use() {
    /// Time that is longer than any step takes, so that only a defect exceeds it.
    const TOO_LONG: Duration = Duration::from_secs(30);
    let app = start("0").await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let events = job["links"]["events"].as_str().unwrap();
    let mut watchers = Vec::new();
    for _ in 0..CONNECTIONS {
        watchers.push(watch(&app, events).await);
    }
    for _ in 0..3 {
        let healthy = async { ask(&mut connect(&app).await).await };
        assert!(tokio::time::timeout(TOO_LONG, healthy).await.expect("an answer"));
    }
    // Another request waits for a second and is then told to come back.
    let refused = tokio::time::timeout(TOO_LONG, app.get("/v1/jobs")).await.expect("an answer");
    assert_eq!(refused.headers()["connection"], "close");
    assert!(refused.headers().contains_key("retry-after"));
    crate::app::problem(refused, 503).await;
    drop(watchers.pop());
    assert_eq!(app.get("/v1/jobs").await.status(), 200);
}

#[tokio::test]
async fn a_connection_that_is_being_answered_is_not_dropped() {
    let app = start("0").await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let events = job["links"]["events"].as_str().unwrap();
    let mut watchers = Vec::new();
    for _ in 0..CONNECTIONS - 1 {
        watchers.push(watch(&app, events).await);
    }
    // A single connection is left for all of the following, one after the other.
    for _ in 0..20 {
        assert!(ask(&mut connect(&app).await).await);
    }
    let cancel = format!("{}{}", app.url, job["links"]["cancel"].as_str().unwrap());
    crate::app::client().post(cancel).send().await.unwrap();
    for mut stream in watchers {
        let mut text = String::new();
        while !text.contains("cancelled") {
            let mut piece = [0; 4096];
            let read = stream.read(&mut piece).await.unwrap();
            assert!(read > 0, "a watcher was dropped");
            text.push_str(&String::from_utf8_lossy(&piece[..read]));
        }
    }
}
