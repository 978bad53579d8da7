//! Callback URLs: messages are sent over TLS, signed and retried, and never go to private addresses.

use crate::app::{self, MINIMAL, RULED, TestApp, pointers, problem, small_film};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use hmac::{Hmac, KeyInit, Mac};
use reqwest::Method;
use serde_json::{Value, json};
use sha2::Sha256;
use std::collections::HashMap;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader};
use tokio::net::TcpListener;
use tokio::sync::mpsc;
use tokio_rustls::TlsAcceptor;
use tokio_rustls::rustls::ServerConfig;
use tokio_rustls::rustls::crypto::ring;
use tokio_rustls::rustls::pki_types::PrivateKeyDer;

const SECRET: &str = "whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw";
/// Time that is longer than any step takes, so that only a defect exceeds it.
const TOO_LONG: Duration = Duration::from_secs(30);

/// A request as the receiver got it.
struct Received {
    target: String,
    headers: HashMap<String, String>,
    body: String,
}

impl Received {
    fn json(&self) -> Value {
        serde_json::from_str(&self.body).unwrap()
    }

    /// Verifies the signature as a receiver's library does.
    fn is_signed_with(&self, secret: &str) -> bool {
        let key = BASE64.decode(secret.strip_prefix("whsec_").unwrap()).unwrap();
        let mut mac = Hmac::<Sha256>::new_from_slice(&key).unwrap();
        let header = |name: &str| &self.headers[name];
        mac.update(format!("{}.{}.{}", header("webhook-id"), header("webhook-timestamp"), self.body).as_bytes());
        *header("webhook-signature") == format!("v1,{}", BASE64.encode(mac.finalize().into_bytes()))
    }
}

/// An HTTPS server for `localhost` that sends the given responses in turn and then repeats the last one.
struct Receiver {
    url: String,
    folder: TempDir,
    received: mpsc::UnboundedReceiver<Received>,
}

impl Receiver {
    async fn start(answers: &'static [&'static str]) -> Self {
        let certified = rcgen::generate_simple_self_signed(["localhost".into()]).unwrap();
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("roots.pem"), certified.cert.pem()).unwrap();
        std::fs::write(folder.path().join("secret"), SECRET).unwrap();
        let key = PrivateKeyDer::try_from(certified.signing_key.serialize_der()).unwrap();
        let provider = Arc::new(ring::default_provider());
        let config = ServerConfig::builder_with_provider(provider).with_safe_default_protocol_versions().unwrap();
        let config = config.with_no_client_auth().with_single_cert(vec![certified.cert.der().clone()], key).unwrap();
        let acceptor = TlsAcceptor::from(Arc::new(config));
        let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
        let url = format!("https://localhost:{}/hook?for=test", listener.local_addr().unwrap().port());
        let (sender, received) = mpsc::unbounded_channel();
        tokio::spawn(async move {
            let mut count = 0;
            loop {
                let (stream, _) = listener.accept().await.unwrap();
                let Ok(stream) = acceptor.accept(stream).await else { continue };
                let mut stream = BufReader::new(stream);
                let mut lines = Vec::new();
                loop {
                    let mut line = String::new();
                    stream.read_line(&mut line).await.unwrap();
                    if line.trim().is_empty() {
                        break;
                    }
                    lines.push(line.trim().to_owned());
                }
                let pairs = lines[1..].iter().map(|line| line.split_once(':').unwrap());
                let headers: HashMap<_, _> =
                    pairs.map(|(name, value)| (name.to_lowercase(), value.trim().to_owned())).collect();
                let mut body = vec![0; headers["content-length"].parse().unwrap()];
                stream.read_exact(&mut body).await.unwrap();
                let answer = answers[count.min(answers.len() - 1)];
                count += 1;
                let _ = stream.write_all(format!("HTTP/1.1 {answer}\r\ncontent-length: 0\r\n\r\n").as_bytes()).await;
                let _ = stream.flush().await;
                let body = String::from_utf8(body).unwrap();
                let _ = sender.send(Received { target: lines[0].clone(), headers, body });
            }
        });
        Self { url, folder, received }
    }

    fn file(&self, name: &str) -> String {
        self.folder.path().join(name).display().to_string()
    }

    async fn app(&self, more: &[(&str, &str)]) -> TestApp {
        let (secret, roots) = (self.file("secret"), self.file("roots.pem"));
        let settings = [
            ("PLATEAU_WEBHOOKS__SECRET_FILE", secret.as_str()),
            ("PLATEAU_WEBHOOKS__ALLOWED_NETWORKS", "127.0.0.0/8,::1/128"),
            ("PLATEAU_WEBHOOKS__RETRY_MS", "1"),
            // The timeout is so long that no attempt fails because the machine is busy.
            ("PLATEAU_WEBHOOKS__TIMEOUT_MS", "60000"),
            ("SSL_CERT_FILE", roots.as_str()),
        ];
        TestApp::start_with(&[&settings, more].concat()).await
    }

    async fn next(&mut self) -> Received {
        tokio::time::timeout(TOO_LONG, self.received.recv())
            .await
            .expect("a message in time")
            .expect("the receiver runs")
    }
}

/// Returns the output of `plateau key webhooks` for a key.
async fn secret_of(receiver: &Receiver, name: &[&str]) -> String {
    let mut command = app::binary();
    command.env("PLATEAU_WEBHOOKS__SECRET_FILE", receiver.file("secret")).args(["key", "webhooks"]).args(name);
    String::from_utf8(command.output().await.unwrap().stdout).unwrap().trim().to_owned()
}

fn film(url: &str) -> Value {
    let mut film = small_film(0.3);
    film["callback_url"] = url.into();
    film
}

/// Waits until the metrics count `count` callbacks with this outcome.
async fn until_counted(app: &TestApp, outcome: &str, count: u32) {
    let expected = format!("plateau_callbacks_total{{outcome=\"{outcome}\"}} {count}");
    let started = Instant::now();
    loop {
        let metrics = app.get("/metrics").await.text().await.unwrap();
        if metrics.contains(&expected) {
            return;
        }
        let found: Vec<&str> = metrics.lines().filter(|line| line.contains("plateau_callbacks_total{")).collect();
        assert!(started.elapsed() < TOO_LONG, "{expected}: {found:?}");
        tokio::task::yield_now().await;
    }
}

#[tokio::test]
async fn a_signed_message_is_repeated_until_the_receiver_accepts_it() {
    let mut receiver =
        Receiver::start(&["500 Oops", "302 Found\r\nlocation: https://localhost/", "204 No Content"]).await;
    let app = receiver.app(&[]).await;
    assert_eq!(app.get_json("/v1/limits").await["webhooks"], true);
    let job = app.solve(MINIMAL, &film(&receiver.url)).await;
    let secret = secret_of(&receiver, &[]).await;
    for _ in 0..3 {
        let message = receiver.next().await;
        assert_eq!(message.target, "POST /hook?for=test HTTP/1.1");
        assert_eq!(message.headers["webhook-id"], job["id"].as_str().unwrap());
        assert!(message.is_signed_with(&secret));
        let body = message.json();
        assert_eq!((&body["type"], &body["timestamp"]), (&json!("job.succeeded"), &job["finished_at"]));
        assert_eq!(
            body["data"],
            json!({ "id": job["id"], "kind": "minimal_surface", "status": "succeeded", "links": job["links"] })
        );
    }
    until_counted(&app, "delivered", 1).await;
    until_counted(&app, "failed", 2).await;
    assert!(receiver.received.try_recv().is_err(), "an accepted message must not be repeated");
    // A job that reuses a kept result sends its message too, because the URL is not part of the request's hash.
    let again: Value = app.post(MINIMAL, &film(&receiver.url)).await.json().await.unwrap();
    assert_eq!(again["status"], "succeeded");
    assert_eq!(receiver.next().await.json()["data"]["id"], again["id"]);
}

#[tokio::test]
async fn messages_about_a_cancelled_job_and_a_batch_are_signed_with_the_secret_of_their_key() {
    let mut receiver = Receiver::start(&["200 OK"]).await;
    let (key, line) = crate::access::new_key("alice").await;
    std::fs::write(receiver.file("keys"), line).unwrap();
    let keys = receiver.file("keys");
    let app = receiver
        .app(&[("PLATEAU_AUTH__KEYS_FILE", &keys), ("PLATEAU_WORKERS", "1"), ("PLATEAU_HTTP__METRICS_LISTEN", "")])
        .await;
    let secret = secret_of(&receiver, &["alice"]).await;
    assert_ne!(secret, secret_of(&receiver, &["bob"]).await);

    app.hold.at("claimed.ruled_surface");
    let mut strip = app::example("two-rails");
    strip["callback_url"] = receiver.url.as_str().into();
    let post = |path: &str, body: &Value| app.request(Method::POST, path).bearer_auth(&key).json(body).send();
    let job: Value = post(RULED, &strip).await.unwrap().json().await.unwrap();
    post(job["links"]["cancel"].as_str().unwrap(), &json!(null)).await.unwrap();
    let message = receiver.next().await;
    assert_eq!(message.json()["type"], "job.cancelled");
    assert!(message.is_signed_with(&secret));

    let mut film = small_film(0.4);
    film["kind"] = "minimal_surface".into();
    let batch: Value = post("/v1/batches", &json!({ "requests": [film], "callback_url": receiver.url }))
        .await
        .unwrap()
        .json()
        .await
        .unwrap();
    let message = receiver.next().await;
    let body = message.json();
    assert_eq!((&body["type"], &body["data"]["id"]), (&json!("batch.succeeded"), &batch["id"]), "{body:#}");
    assert_eq!(body["data"]["counts"]["succeeded"], 1);
    assert!(message.is_signed_with(&secret));
}

#[tokio::test]
async fn a_message_that_is_refused_or_fails_too_often_is_given_up() {
    let mut receiver = Receiver::start(&["410 Gone", "500 Oops"]).await;
    let app = receiver.app(&[("PLATEAU_WEBHOOKS__ATTEMPTS_MAX", "2")]).await;
    app.solve(MINIMAL, &film(&receiver.url)).await;
    until_counted(&app, "unwanted", 1).await;
    let mut other = film(&receiver.url);
    other["cache"] = "bypass".into();
    app.solve(MINIMAL, &other).await;
    until_counted(&app, "failed", 1).await;
    until_counted(&app, "given_up", 1).await;
    for _ in 0..3 {
        receiver.next().await;
    }
    assert!(receiver.received.try_recv().is_err());
}

#[tokio::test]
async fn a_receiver_that_never_answers_does_not_delay_the_messages_to_others() {
    let mut receiver = Receiver::start(&["200 OK"]).await;
    let app = receiver.app(&[]).await;
    // Connections are accepted by the operating system, and nobody answers. An attempt lasts 60 s.
    let silent = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let url = format!("https://localhost:{}/", silent.local_addr().unwrap().port());
    app.solve(MINIMAL, &film(&url)).await;
    for _ in 0..40 {
        assert_eq!(app.post(MINIMAL, &film(&url)).await.status(), 202);
    }
    let job: Value = app.post(MINIMAL, &film(&receiver.url)).await.json().await.unwrap();
    assert_eq!(receiver.next().await.json()["data"]["id"], job["id"]);
}

#[tokio::test]
async fn a_callback_has_a_log_and_is_sent_again_on_request() {
    let mut receiver = Receiver::start(&["500 Oops", "410 Gone", "200 OK"]).await;
    let app = receiver.app(&[]).await;
    let job = app.solve(MINIMAL, &film(&receiver.url)).await;
    let path = format!("{}/callbacks", job["links"]["self"].as_str().unwrap());
    let outcomes = async || {
        let callbacks = app.get_json(&path).await;
        assert_eq!(callbacks["callback_url"], receiver.url.as_str());
        let outcomes = callbacks["deliveries"].as_array().unwrap().iter().map(|one| one["outcome"].clone());
        (callbacks["pending"].clone(), Value::from_iter(outcomes))
    };
    crate::hold::until("the message is settled", async || outcomes().await.0 == false).await;
    assert_eq!(outcomes().await.1, json!(["failed", "unwanted"]));
    let again = app.request(Method::POST, &path).send().await.unwrap();
    assert_eq!(again.status(), 202);
    assert_eq!(again.json::<Value>().await.unwrap()["pending"], true);
    crate::hold::until("the message is delivered", async || outcomes().await.0 == false).await;
    assert_eq!(outcomes().await.1, json!(["failed", "unwanted", "delivered"]));
    for _ in 0..3 {
        assert_eq!(receiver.next().await.json()["data"]["id"], job["id"]);
    }

    let without = app.solve(MINIMAL, &small_film(0.5)).await;
    let path = format!("{}/callbacks", without["links"]["self"].as_str().unwrap());
    let nothing = json!({ "callback_url": null, "pending": false, "next_attempt_at": null, "deliveries": [] });
    assert_eq!(app.get_json(&path).await, nothing);
    problem(app.request(Method::POST, &path).send().await.unwrap(), 409).await;
    for path in ["/v1/jobs/01J00000000000000000000000/callbacks", "/v1/batches/01J00000000000000000000000/callbacks"] {
        problem(app.get(path).await, 404).await;
        problem(app.request(Method::POST, path).send().await.unwrap(), 404).await;
    }
    let mut named = small_film(0.5);
    named["kind"] = "minimal_surface".into();
    let batch = json!({ "requests": [named], "callback_url": receiver.url });
    let batch: Value = app.post("/v1/batches", &batch).await.json().await.unwrap();
    let path = format!("{}/callbacks", batch["links"]["self"].as_str().unwrap());
    assert_eq!(receiver.next().await.json()["data"]["id"], batch["id"]);
    let pending = async || app.get_json(&path).await["pending"] == true;
    crate::hold::until("the batch's message is delivered", async || !pending().await).await;
    assert_eq!(app.request(Method::POST, &path).send().await.unwrap().status(), 202);
    assert_eq!(receiver.next().await.json()["data"]["id"], batch["id"]);
}

#[tokio::test]
async fn a_receiver_with_an_untrusted_certificate_gets_no_message() {
    let mut stranger = Receiver::start(&["200 OK"]).await;
    let trusted = Receiver::start(&["200 OK"]).await;
    let app = trusted.app(&[("PLATEAU_WEBHOOKS__ATTEMPTS_MAX", "1")]).await;
    app.solve(MINIMAL, &film(&stranger.url)).await;
    until_counted(&app, "given_up", 1).await;
    assert!(stranger.received.try_recv().is_err());
}

#[tokio::test]
async fn a_name_that_resolves_to_a_private_address_gets_no_message() {
    let mut receiver = Receiver::start(&["200 OK"]).await;
    let settings = [("PLATEAU_WEBHOOKS__ALLOWED_NETWORKS", "10.0.0.0/8"), ("PLATEAU_WEBHOOKS__ATTEMPTS_MAX", "1")];
    let app = receiver.app(&settings).await;
    // The request is accepted because the name is resolved only at the attempt. It then resolves to this machine.
    app.solve(MINIMAL, &film(&receiver.url)).await;
    until_counted(&app, "given_up", 1).await;
    assert!(receiver.received.try_recv().is_err());
    for inside in ["https://127.0.0.1/", "https://[::1]/", "http://example.org/", "https://169.254.169.254/latest"] {
        let refused = problem(app.post(MINIMAL, &film(inside)).await, 422).await;
        assert_eq!(pointers(&refused), ["/callback_url"], "{inside}");
    }
    let batch = json!({ "requests": [{ "kind": "minimal_surface", "callback_url": "https://10.0.0.1/",
        "boundaries": small_film(0.1)["boundaries"],
        "resolution": { "triangles": 10 } }, { "kind": "minimal_surface", "callback_url": "https://127.0.0.1/",
        "boundaries": small_film(0.1)["boundaries"], "resolution": { "triangles": 10 } }] });
    let refused = problem(app.post("/v1/batches", &batch).await, 422).await;
    assert_eq!(pointers(&refused), ["/requests/1/callback_url"]);
}

#[tokio::test]
async fn a_callback_may_go_to_a_host_name_outside_ascii() {
    let receiver = Receiver::start(&["200 OK"]).await;
    let app = receiver.app(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_WEBHOOKS__ALLOWED_NETWORKS", "10.0.0.0/8")]).await;
    assert_eq!(app.post(MINIMAL, &film("https://b\u{fc}cher.example/hook")).await.status(), 202);
    // Full-width digits are other notations of the ordinary ones.
    let refused = problem(app.post(MINIMAL, &film("https://\u{ff11}\u{ff12}\u{ff17}.0.0.1/")).await, 422).await;
    assert_eq!(pointers(&refused), ["/callback_url"]);
    assert!(refused["detail"].as_str().unwrap().contains("not public"), "{refused:#}");
}

#[tokio::test]
async fn webhooks_are_off_without_a_secret_file() {
    let app = TestApp::start().await;
    assert_eq!(app.get_json("/v1/limits").await["webhooks"], false);
    let refused = problem(app.post(MINIMAL, &film("https://example.org/")).await, 422).await;
    assert_eq!(pointers(&refused), ["/callback_url"]);
}
