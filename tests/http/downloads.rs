//! Downloads by slow readers, and limits of the open requests of each client.

use crate::access::new_key;
use crate::app::{MINIMAL, TestApp, problem, small_film};
use crate::hold::until;
use futures_util::StreamExt;
use reqwest::Method;
use serde_json::Value;
use std::time::Duration;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpSocket, TcpStream};

/// Starts a server whose cache in memory holds no large file, and solves a film. Returns the path of its mesh as OBJ
/// and the length of this file.
async fn start(environment: &[(&str, &str)]) -> (TestApp, String, u64) {
    let app = TestApp::start_with(&[&[("PLATEAU_HTTP__FILES_KEPT_BYTES", "1000000")], environment].concat()).await;
    let mut film = small_film(0.1);
    film["resolution"]["triangles"] = 60_000.into();
    let job = app.solve(MINIMAL, &film).await;
    let path = format!("{}?format=obj", job["links"]["mesh"].as_str().unwrap());
    let length = app.get(&path).await.bytes().await.unwrap().len() as u64;
    assert!(length > 2_000_000, "{length}");
    (app, path, length)
}

/// Asks for a file and reads its first bytes only. The receive buffer is small, so that the rest stays with the server.
async fn read_slowly(app: &TestApp, path: &str) -> TcpStream {
    let socket = TcpSocket::new_v4().unwrap();
    socket.set_recv_buffer_size(4096).unwrap();
    let mut stream = socket.connect(app.url.strip_prefix("http://").unwrap().parse().unwrap()).await.unwrap();
    stream.write_all(format!("GET {path} HTTP/1.1\r\nHost: localhost\r\n\r\n").as_bytes()).await.unwrap();
    let mut head = [0; 512];
    stream.read_exact(&mut head).await.unwrap();
    assert!(head.starts_with(b"HTTP/1.1 200 "));
    stream
}

#[tokio::test]
async fn slow_readers_of_a_large_file_take_little_memory() {
    const READERS: u64 = 100;
    let (app, path, length) = start(&[]).await;
    let before = app.memory();
    let mut readers = Vec::new();
    for _ in 0..READERS {
        readers.push(read_slowly(&app, &path).await);
    }
    let each = app.memory().saturating_sub(before) / READERS;
    println!("{each} bytes for each reader of {length} bytes");
    assert!(each < length / 4, "{each} bytes for each reader of {length} bytes");
}

#[tokio::test]
async fn the_ranges_of_a_large_file_need_one_conversion() {
    let (app, path, length) = start(&[]).await;
    let whole = app.get(&path).await.bytes().await.unwrap();
    let mut joined = Vec::new();
    for first in (0..length).step_by(300_000) {
        let range = format!("bytes={first}-{}", first + 299_999);
        let part = app.request(Method::GET, &path).header("range", range).send().await.unwrap();
        assert_eq!(part.status(), 206);
        joined.extend_from_slice(&part.bytes().await.unwrap());
    }
    assert!(joined == whole);
    let metrics = app.get("/metrics").await.text().await.unwrap();
    assert!(metrics.contains("\nplateau_conversions_total 1\n"), "{metrics}");
}

#[tokio::test]
async fn a_reader_below_the_lowest_rate_is_cut_off() {
    let settings =
        [("PLATEAU_HTTP__ANSWER_RATE_BYTES_PER_S", "1000000000"), ("PLATEAU_HTTP__ANSWER_RATE_GRACE_MS", "100")];
    let (app, path, length) = {
        // The film is fetched from a server without a lowest rate, because this rate is above any client's.
        let (app, path, length) = start(&[]).await;
        let (_, folder) = app.stop().await;
        (TestApp::start_in(folder, &settings).await, path, length)
    };
    let mut reader = read_slowly(&app, &path).await;
    let mut received = 0;
    // The server closes the connection although this reader goes on.
    loop {
        match reader.read(&mut [0; 256]).await {
            Ok(0) | Err(_) => break,
            Ok(count) => received += count as u64,
        }
        tokio::time::sleep(Duration::from_millis(1)).await;
    }
    assert!(received < length, "{received} of {length}");
}

#[tokio::test]
async fn one_client_cannot_open_every_stream() {
    let secrets = tempfile::tempdir().unwrap();
    let ((alice, first), (bob, second)) = (new_key("alice").await, new_key("bob").await);
    let keys = secrets.path().join("keys");
    std::fs::write(&keys, format!("{first}\n{second}\n")).unwrap();
    let app = TestApp::start_with(&[
        ("PLATEAU_WORKERS", "0"),
        ("PLATEAU_AUTH__KEYS_FILE", keys.to_str().unwrap()),
        ("PLATEAU_HTTP__CONNECTIONS", "16"),
        ("PLATEAU_HTTP__REQUESTS_SHARE_PERCENT", "25"),
    ])
    .await;
    let submit = async |key: &str| -> Value {
        let post = app.request(Method::POST, MINIMAL).bearer_auth(key).json(&small_film(0.1));
        post.send().await.unwrap().json().await.unwrap()
    };
    let open = async |key: &str, job: &Value| {
        let path = job["links"]["events"].as_str().unwrap();
        app.request(Method::GET, path).bearer_auth(key).send().await.unwrap()
    };
    let (hers, his) = (submit(&alice).await, submit(&bob).await);
    let mut streams = Vec::new();
    for _ in 0..4 {
        let stream = open(&alice, &hers).await;
        assert_eq!(stream.status(), 200);
        streams.push(stream);
    }
    let refused = open(&alice, &hers).await;
    assert!(refused.headers().contains_key("retry-after"));
    assert!(problem(refused, 429).await["type"].as_str().unwrap().ends_with("/too-many-open-requests"));
    assert_eq!(open(&bob, &his).await.status(), 200);
    drop(streams.pop());
    // The server notices within a moment that the stream is closed.
    until("a free place", async || open(&alice, &hers).await.status() == 200).await;
}

#[tokio::test]
async fn a_removed_key_ends_its_streams_and_waits() {
    let secrets = tempfile::tempdir().unwrap();
    let ((alice, first), (bob, second)) = (new_key("alice").await, new_key("bob").await);
    let keys = secrets.path().join("keys");
    std::fs::write(&keys, format!("{first}\n{second}\n")).unwrap();
    let app =
        TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_AUTH__KEYS_FILE", keys.to_str().unwrap())]).await;
    let post = app.request(Method::POST, MINIMAL).bearer_auth(&alice).json(&small_film(0.1)).send().await.unwrap();
    let job: Value = post.json().await.unwrap();
    let this = job["links"]["self"].as_str().unwrap();
    let stream = app.request(Method::GET, &format!("{this}/events")).bearer_auth(&alice).send().await.unwrap();
    let mut stream = stream.bytes_stream();
    assert!(stream.next().await.unwrap().is_ok());
    let wait = app.request(Method::GET, this).bearer_auth(&alice).header("prefer", "wait=60").send();
    let wait = tokio::spawn(wait);
    // A new file is put into the place of the old one, as editors and Kubernetes do.
    let next = secrets.path().join("next");
    std::fs::write(&next, format!("{second}\n")).unwrap();
    std::fs::rename(&next, &keys).unwrap();
    while stream.next().await.is_some_and(|piece| piece.is_ok()) {}
    // The wait has ended long before its time, or it began after the removal.
    assert_eq!(wait.await.unwrap().unwrap().status(), 401);
    assert_eq!(app.request(Method::GET, "/v1/jobs").bearer_auth(&bob).send().await.unwrap().status(), 200);
}
