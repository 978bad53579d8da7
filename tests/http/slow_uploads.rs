//! Clients that send their bodies slowly: the server ends their requests, and other clients do not wait for them.

use crate::app::{MINIMAL, TestApp, small_film};
use reqwest::Method;
use std::time::Duration;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio::sync::watch;

/// Number of uploads. Their declared lengths add up to the whole default budget.
const UPLOADS: usize = 8;
/// Time that is longer than any step takes, so that only a defect exceeds it.
const TOO_LONG: Duration = Duration::from_secs(30);
/// Time limits so long that no upload ends by itself during the test, in milliseconds.
const NEVER: [(&str, &str); 1] = [("PLATEAU_HTTP__BODY_TIMEOUT_MS", "600000")];

/// Sends the head of a POST and waits until the server asks for its body, so that the upload has begun for the server.
async fn begin(app: &TestApp, headers: &str) -> TcpStream {
    let mut stream = TcpStream::connect(app.url.strip_prefix("http://").unwrap()).await.unwrap();
    let head = format!(
        "POST {MINIMAL} HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n\
         Expect: 100-continue\r\n{headers}\r\n"
    );
    stream.write_all(head.as_bytes()).await.unwrap();
    let mut asked = String::new();
    while !asked.ends_with("\r\n\r\n") {
        asked.push(char::from(stream.read_u8().await.expect("the server asks for the body")));
    }
    assert!(asked.starts_with("HTTP/1.1 100 "), "{asked}");
    stream
}

/// Returns the text of a request for a film, of exactly `bytes` bytes.
fn padded(height: f64, bytes: usize) -> String {
    let film = small_film(height).to_string();
    let padding = " ".repeat(bytes - film.len());
    film + &padding
}

async fn in_time<T>(what: impl Future<Output = T>) -> T {
    tokio::time::timeout(TOO_LONG, what).await.expect("nobody waits for a slow upload")
}

#[tokio::test]
async fn a_post_does_not_wait_for_slow_uploads() {
    let app = TestApp::start_with(&[&[("PLATEAU_WORKERS", "0")], &NEVER[..]].concat()).await;
    let mut slow = Vec::new();
    for _ in 0..UPLOADS {
        let mut stream = in_time(begin(&app, "Content-Length: 33554432\r\n")).await;
        stream.write_all(b"{").await.unwrap();
        slow.push(stream);
    }
    for (height, bytes) in [(0.1, 1000), (0.2, 2 << 20)] {
        let post = app.request(Method::POST, MINIMAL).header("content-type", "application/json");
        let answer = in_time(post.body(padded(height, bytes)).send()).await.unwrap();
        assert_eq!(answer.status(), 202, "{bytes} bytes");
    }
}

#[tokio::test]
async fn the_uploads_of_one_key_leave_room_for_others_and_end() {
    const MIB: usize = 1 << 20;
    let secrets = tempfile::tempdir().unwrap();
    let ((alice, first), (bob, second)) = (crate::access::new_key("alice").await, crate::access::new_key("bob").await);
    let keys = secrets.path().join("keys");
    std::fs::write(&keys, format!("{first}\n{second}\n")).unwrap();
    let settings = [
        ("PLATEAU_WORKERS", "0"),
        ("PLATEAU_AUTH__KEYS_FILE", keys.to_str().unwrap()),
        ("PLATEAU_LIMITS__BODY_BYTES", "1048576"),
        ("PLATEAU_HTTP__BODIES_IN_FLIGHT_BYTES", "8388608"),
    ];
    let app = TestApp::start_with(&[&settings, &NEVER[..]].concat()).await;
    // Alice sends all but the last byte of eight bodies, as far as the server reads them.
    let (last_byte, may_end) = watch::channel(false);
    let mut uploads = Vec::new();
    for number in 0..UPLOADS {
        let headers = format!("Content-Length: {MIB}\r\nAuthorization: Bearer {alice}\r\nConnection: close\r\n");
        let mut stream = in_time(begin(&app, &headers)).await;
        let mut may_end = may_end.clone();
        uploads.push(tokio::spawn(async move {
            let body = padded(number as f64, MIB);
            stream.write_all(&body.as_bytes()[..MIB - 1]).await.unwrap();
            may_end.wait_for(|may_end| *may_end).await.unwrap();
            stream.write_all(b" ").await.unwrap();
            let mut answer = String::new();
            stream.read_to_string(&mut answer).await.unwrap();
            answer
        }));
    }
    let post = app.request(Method::POST, MINIMAL).bearer_auth(bob).header("content-type", "application/json");
    assert_eq!(in_time(post.body(padded(0.5, MIB)).send()).await.unwrap().status(), 202);
    // Uploads that wait for room do not block each other for ever.
    last_byte.send(true).unwrap();
    for upload in uploads {
        let answer = in_time(upload).await.unwrap();
        assert!(answer.starts_with("HTTP/1.1 202 "), "{answer}");
    }
}

#[tokio::test]
async fn a_body_below_the_lowest_rate_is_408() {
    let app = TestApp::start_with(&[
        ("PLATEAU_HTTP__BODY_TIMEOUT_MS", "600000"),
        ("PLATEAU_HTTP__BODY_RATE_BYTES_PER_S", "100000"),
        ("PLATEAU_HTTP__BODY_RATE_GRACE_MS", "100"),
    ])
    .await;
    let lengths = [("Content-Length: 33554432\r\n", " "), ("Transfer-Encoding: chunked\r\n", "1\r\n \r\n")];
    let mut uploads = Vec::new();
    for (length, byte) in lengths.into_iter().cycle().take(UPLOADS) {
        let mut stream = in_time(begin(&app, length)).await;
        uploads.push(tokio::spawn(async move {
            let mut answer = Vec::new();
            loop {
                // Sends a byte every 20 ms until the server closes the connection.
                match tokio::time::timeout(Duration::from_millis(20), stream.read_buf(&mut answer)).await {
                    Ok(Ok(0) | Err(_)) => return String::from_utf8(answer).unwrap(),
                    Ok(Ok(_)) => {}
                    Err(_) => drop(stream.write_all(byte.as_bytes()).await),
                }
            }
        }));
    }
    for upload in uploads {
        let answer = in_time(upload).await.unwrap();
        assert!(answer.starts_with("HTTP/1.1 408 "), "{answer}");
        for part in ["application/problem+json", "connection: close", "/problems/body-timeout", "100000 bytes a second"]
        {
            assert!(answer.contains(part), "{part} is not in {answer}");
        }
    }
    assert_eq!(app.get("/problems/body-timeout").await.status(), 200);
}
