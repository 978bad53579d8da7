//! Access to the server: keys, ownership, shares of the queue, foreign origins and foreign hosts.

use crate::app::{self, MINIMAL, RULED, TestApp, is_built, small_film};
use crate::hold::until;
use crate::sources::{ENLARGEMENTS, enlargement};
use reqwest::{Method, RequestBuilder, StatusCode};
use serde_json::Value;
use tempfile::TempDir;

/// A server with the keys of `alice` and `bob`.
struct Guarded {
    app: TestApp,
    alice: String,
    bob: String,
    secrets: TempDir,
}

pub async fn new_key(name: &str) -> (String, String) {
    let output = app::binary().args(["key", "new", name]).output().await.expect("the binary runs");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let value = |line: &str| line.split_once(':').expect("a label").1.trim().to_owned();
    let lines: Vec<_> = text.lines().map(value).collect();
    (lines[0].clone(), lines[1].clone())
}

impl Guarded {
    async fn start(environment: &[(&str, &str)]) -> Self {
        let secrets = tempfile::tempdir().expect("a temporary folder");
        let ((alice, first), (bob, second)) = (new_key("alice").await, new_key("bob").await);
        let file = secrets.path().join("keys");
        std::fs::write(&file, format!("# keys of this test\n{first}\n{second}\n")).expect("the file can be written");
        let file = file.display().to_string();
        let environment: Vec<_> =
            environment.iter().copied().chain([("PLATEAU_AUTH__KEYS_FILE", file.as_str())]).collect();
        Self { app: TestApp::start_with(&environment).await, alice, bob, secrets }
    }

    fn request(&self, key: &str, method: Method, path: &str) -> RequestBuilder {
        self.app.request(method, path).bearer_auth(key)
    }

    async fn status(&self, key: &str, method: Method, path: &str) -> StatusCode {
        self.request(key, method, path).send().await.expect("an answer").status()
    }

    async fn solve(&self, key: &str, path: &str, body: &Value) -> Value {
        let request = self.request(key, Method::POST, path).header("prefer", "wait=60").json(body);
        let job: Value = request.send().await.expect("an answer").json().await.expect("JSON");
        assert_eq!(job["status"], "succeeded", "{job:#}");
        job
    }
}

#[tokio::test]
async fn a_key_is_needed_for_all_but_the_public_pages() {
    let guarded = Guarded::start(&[]).await;
    let app = &guarded.app;
    for path in
        ["/", "/openapi.json", "/docs", "/health/live", "/health/ready"].into_iter().filter(|path| is_built(path))
    {
        assert_eq!(app.get(path).await.status(), StatusCode::OK, "{path}");
    }
    for path in ["/v1/jobs", "/v1/limits", "/v1/objectives", "/metrics", "/v1/nothing"] {
        let response = app.get(path).await;
        assert_eq!(response.status(), StatusCode::UNAUTHORIZED, "{path}");
        assert_eq!(response.headers()["www-authenticate"], "Bearer");
        assert_eq!(response.headers()["content-type"], "application/problem+json");
        assert_ne!(guarded.status(&guarded.alice, Method::GET, path).await, StatusCode::UNAUTHORIZED, "{path}");
    }
    // The body of a request without a key is not read.
    let response = app.request(Method::POST, RULED).body("not JSON").send().await.unwrap();
    assert_eq!(response.status(), StatusCode::UNAUTHORIZED);
    for wrong in ["plateau_0", "", &guarded.alice[..guarded.alice.len() - 1]] {
        assert_eq!(guarded.status(wrong, Method::GET, "/v1/jobs").await, StatusCode::UNAUTHORIZED);
    }
}

#[tokio::test]
async fn a_key_never_sees_jobs_of_another_by_any_route() {
    let guarded = Guarded::start(&[]).await;
    let (alice, bob) = (&guarded.alice, &guarded.bob);
    let strip = app::example("wavy-strip");
    let job = guarded.solve(alice, RULED, &strip).await;
    let own = job["links"]["self"].as_str().unwrap().to_owned();
    for (method, path) in [
        (Method::GET, own.clone()),
        (Method::GET, format!("{own}/mesh")),
        (Method::GET, format!("{own}/pattern")),
        (Method::GET, format!("{own}/events")),
        (Method::POST, format!("{own}/cancel")),
        (Method::DELETE, own.clone()),
    ] {
        assert_eq!(guarded.status(bob, method.clone(), &path).await, StatusCode::NOT_FOUND, "{method} {path}");
    }
    let waiting = guarded.request(bob, Method::GET, &own).header("prefer", "wait=1").send().await.unwrap();
    assert_eq!(waiting.status(), StatusCode::NOT_FOUND);
    let list = async |key: &str| -> usize {
        let response = guarded.request(key, Method::GET, "/v1/jobs").send().await.unwrap();
        response.json::<Value>().await.unwrap()["jobs"].as_array().unwrap().len()
    };
    assert_eq!((list(alice).await, list(bob).await), (1, 0));
    assert_eq!(guarded.status(alice, Method::GET, &format!("{own}/mesh")).await, StatusCode::OK);

    // Batches are hidden from other keys too.
    let request = guarded.request(alice, Method::POST, "/v1/batches").header("prefer", "wait=60");
    let request = request.json(&serde_json::json!({ "requests": [strip] }));
    let batch: Value = request.send().await.unwrap().json().await.unwrap();
    assert_eq!(batch["status"], "succeeded", "{batch:#}");
    let of_alice = batch["links"]["self"].as_str().unwrap();
    for (method, path) in [
        (Method::GET, of_alice.to_owned()),
        (Method::GET, format!("{of_alice}/meshes")),
        (Method::GET, format!("{of_alice}/meshes?format=glb")),
        (Method::POST, format!("{of_alice}/cancel")),
        (Method::DELETE, of_alice.to_owned()),
    ] {
        assert_eq!(guarded.status(bob, method.clone(), &path).await, StatusCode::NOT_FOUND, "{method} {path}");
    }
    assert_eq!(guarded.status(alice, Method::DELETE, of_alice).await, StatusCode::NO_CONTENT);

    // Each key has its own idempotency keys.
    let post = async |key: &str, body: &Value| {
        let request = guarded.request(key, Method::POST, MINIMAL).header("idempotency-key", "one").json(body);
        request.send().await.unwrap()
    };
    let first: Value = post(alice, &small_film(0.1)).await.json().await.unwrap();
    let second = post(bob, &small_film(0.2)).await;
    assert_eq!(second.status(), StatusCode::ACCEPTED);
    assert_ne!(second.json::<Value>().await.unwrap()["id"], first["id"]);
    assert_eq!(post(alice, &small_film(0.2)).await.status(), StatusCode::UNPROCESSABLE_ENTITY);

    // A request cannot begin with the result of another key.
    for (key, status) in [(alice, 202), (bob, 404)] {
        let request = guarded.request(key, Method::POST, ENLARGEMENTS).json(&enlargement(&job, 2.0));
        assert_eq!(request.send().await.unwrap().status().as_u16(), status);
    }

    // A request reuses only results of its own key.
    let repeated = guarded.request(alice, Method::POST, RULED).json(&strip).send().await.unwrap();
    assert_eq!(repeated.json::<Value>().await.unwrap()["status"], "succeeded");
    let anew = guarded.request(bob, Method::POST, RULED).json(&strip).send().await.unwrap();
    assert_eq!(anew.json::<Value>().await.unwrap()["status"], "queued");
}

#[tokio::test]
async fn a_key_that_floods_the_queue_neither_fills_it_nor_starves_others() {
    let settings = [("PLATEAU_WORKERS", "1"), ("PLATEAU_JOBS__QUEUE_LENGTH", "20")];
    let guarded = Guarded::start(&settings).await;
    let (alice, bob) = (&guarded.alice, &guarded.bob);
    guarded.app.hold.at("claimed.minimal_surface");
    let mut accepted = 0;
    let refused = loop {
        let film = small_film(0.1 + f64::from(accepted) * 0.001);
        let response = guarded.request(alice, Method::POST, MINIMAL).json(&film).send().await.unwrap();
        if response.status() != StatusCode::ACCEPTED {
            break response;
        }
        accepted += 1;
        if accepted == 1 {
            // The worker takes the first job out of the queue.
            guarded.app.hold.reached_by("claimed", 1).await;
        }
    };
    assert_eq!(refused.status(), StatusCode::TOO_MANY_REQUESTS);
    assert!(refused.headers().contains_key("retry-after"));
    assert_eq!(accepted, 1 + 10, "one job that runs, and half of the queue");
    let posted = guarded.request(bob, Method::POST, RULED).json(&app::example("wavy-strip")).send().await.unwrap();
    let mut strip: Value = posted.json().await.unwrap();
    guarded.app.hold.release("claimed.minimal_surface");
    while strip["status"] != "succeeded" {
        let this = strip["links"]["self"].as_str().unwrap().to_owned();
        strip = guarded
            .request(bob, Method::GET, &this)
            .header("prefer", "wait=60")
            .send()
            .await
            .unwrap()
            .json()
            .await
            .unwrap();
    }
    let list = async |status: &str| {
        let path = format!("/v1/jobs?status={status}&limit=200");
        let page = guarded.request(alice, Method::GET, &path).send().await.unwrap().json::<Value>().await.unwrap();
        page["jobs"].as_array().unwrap().clone()
    };
    until("all jobs of alice end", async || list("succeeded").await.len() == accepted as usize).await;
    let begun = strip["started_at"].as_str().unwrap();
    let later = list("succeeded").await.iter().filter(|job| job["started_at"].as_str().unwrap() > begun).count();
    assert!(later > 5, "bob's job must be among the next few, but only {later} of alice's began later");
}

#[tokio::test]
async fn the_requests_of_a_key_are_limited_per_minute() {
    let guarded = Guarded::start(&[("PLATEAU_AUTH__REQUESTS_PER_MINUTE", "3")]).await;
    let (alice, bob) = (&guarded.alice, &guarded.bob);
    let text = |response: &reqwest::Response, name: &str| response.headers()[name].to_str().unwrap().to_owned();
    for left in [2, 1, 0] {
        let response = guarded.request(alice, Method::GET, "/v1/limits").send().await.unwrap();
        assert_eq!(response.status(), StatusCode::OK);
        assert_eq!(text(&response, "ratelimit-policy"), "\"requests\";q=3;w=60");
        assert!(text(&response, "ratelimit").starts_with(&format!("\"requests\";r={left};t=")));
    }
    let refused = guarded.request(alice, Method::GET, "/v1/limits").send().await.unwrap();
    assert_eq!(refused.status(), StatusCode::TOO_MANY_REQUESTS);
    let retry_after_s: u64 = refused.headers()["retry-after"].to_str().unwrap().parse().unwrap();
    assert!((1..=20).contains(&retry_after_s));
    assert_eq!(text(&refused, "ratelimit"), format!("\"requests\";r=0;t={retry_after_s}"));
    assert_eq!(guarded.status(bob, Method::GET, "/v1/limits").await, StatusCode::OK);
}

#[tokio::test]
async fn pages_of_named_origins_may_use_the_server() {
    let guarded = Guarded::start(&[("PLATEAU_HTTP__CORS_ORIGINS", "https://a.example, https://b.example")]).await;
    let preflight = async |origin: &str| {
        let request = guarded.app.request(Method::OPTIONS, RULED).header("origin", origin);
        let request = request.header("access-control-request-method", "POST");
        request.header("access-control-request-headers", "authorization,content-type,prefer").send().await.unwrap()
    };
    let response = preflight("https://b.example").await;
    assert_eq!(response.status(), StatusCode::OK);
    assert_eq!(response.headers()["access-control-allow-origin"], "https://b.example");
    assert!(response.headers()["access-control-allow-headers"].to_str().unwrap().contains("authorization"));
    assert!(!preflight("https://c.example").await.headers().contains_key("access-control-allow-origin"));
    let request = guarded.request(&guarded.alice, Method::GET, "/v1/jobs").header("origin", "https://a.example");
    let response = request.send().await.unwrap();
    let exposed = response.headers()["access-control-expose-headers"].to_str().unwrap().to_lowercase();
    for name in [
        "content-disposition",
        "content-range",
        "location",
        "link",
        "retry-after",
        "preference-applied",
        "etag",
        "x-request-id",
        "ratelimit",
    ] {
        assert!(exposed.contains(name), "{exposed}");
    }
    let plain = TestApp::start().await;
    let request = plain.request(Method::OPTIONS, "/v1/jobs").header("origin", "https://a.example");
    assert_eq!(request.send().await.unwrap().status(), StatusCode::METHOD_NOT_ALLOWED);
}

#[tokio::test]
async fn a_loopback_server_answers_to_loopback_names_only() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__HOSTS", "plateau.test")]).await;
    for (host, status) in [
        ("localhost", StatusCode::OK),
        ("plateau.test:80", StatusCode::OK),
        ("evil.test", StatusCode::MISDIRECTED_REQUEST),
        ("10.0.0.1:8080", StatusCode::MISDIRECTED_REQUEST),
    ] {
        let response = app.request(Method::GET, "/v1/jobs").header("host", host).send().await.unwrap();
        assert_eq!(response.status(), status, "{host}");
    }
}

#[tokio::test]
async fn a_server_without_keys_listens_only_on_loopback_addresses() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data");
    let mut command = app::binary();
    command.args(["--listen", "0.0.0.0:0", "--data"]).arg(&data);
    let output = command.output().await.unwrap();
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("auth.keys_file") && message.contains("auth.open_without_keys"), "{message}");
    assert!(!data.exists(), "the data folder was not created");
}

#[tokio::test]
async fn changes_of_the_keys_file_take_effect() {
    // The test asks with unknown keys more often than clients may.
    let guarded = Guarded::start(&[("PLATEAU_AUTH__FAILURES_PER_MINUTE", "0")]).await;
    let (carol, line) = new_key("carol").await;
    assert_eq!(guarded.status(&carol, Method::GET, "/v1/jobs").await, StatusCode::UNAUTHORIZED);
    std::fs::write(guarded.secrets.path().join("keys"), format!("{line}\n")).unwrap();
    // The server checks the file once a second.
    let status = async || guarded.status(&carol, Method::GET, "/v1/jobs").await;
    until("carol's key is known", async || status().await == StatusCode::OK).await;
    assert_eq!(guarded.status(&guarded.alice, Method::GET, "/v1/jobs").await, StatusCode::UNAUTHORIZED);
    // Without any key in the file, every request is refused.
    std::fs::write(guarded.secrets.path().join("keys"), "").unwrap();
    until("no key is known", async || status().await == StatusCode::UNAUTHORIZED).await;
    assert_eq!(guarded.app.get("/v1/jobs").await.status(), StatusCode::UNAUTHORIZED);
}

#[tokio::test]
async fn requests_of_a_foreign_page_cannot_change_anything() {
    let app =
        TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_HTTP__CORS_ORIGINS", "https://cad.example")]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let this = job["links"]["self"].as_str().unwrap();
    let cancel = job["links"]["cancel"].as_str().unwrap();
    let foreign = [("origin", "https://evil.example"), ("sec-fetch-site", "cross-site"), ("origin", "null")];
    for (method, path) in
        [(Method::POST, cancel), (Method::DELETE, this), (Method::POST, MINIMAL), (Method::POST, "/v1/batches")]
    {
        for (name, value) in foreign {
            let response = app.request(method.clone(), path).header(name, value).send().await.unwrap();
            let refused = app::problem(response, 403).await;
            assert_eq!(refused["type"], "/problems/foreign-page", "{method} {path} {name}: {value}");
        }
    }
    assert_eq!(app.get_json(this).await["status"], "queued");
    // A foreign page may read. The server's own pages, pages of allowed origins and other programs may also change
    // things.
    let look = app.request(Method::GET, this).header("sec-fetch-site", "cross-site").send().await.unwrap();
    assert_eq!(look.status(), StatusCode::OK);
    let own = app.url.clone();
    for (name, value) in
        [("origin", own.as_str()), ("sec-fetch-site", "same-origin"), ("origin", "https://cad.example")]
    {
        let response = app.request(Method::POST, cancel).header(name, value).send().await.unwrap();
        assert_eq!(response.status(), StatusCode::OK, "{name}: {value}");
    }
}

#[tokio::test]
async fn a_request_with_two_hosts_is_refused() {
    use tokio::io::{AsyncReadExt, AsyncWriteExt};
    let app = TestApp::start().await;
    for (hosts, status) in [("Host: localhost\r\nHost: evil.test", "400"), ("Host: localhost", "200")] {
        let mut stream = tokio::net::TcpStream::connect(app.url.strip_prefix("http://").unwrap()).await.unwrap();
        let request = format!("GET /health/live HTTP/1.1\r\n{hosts}\r\nConnection: close\r\n\r\n");
        stream.write_all(request.as_bytes()).await.unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).await.unwrap();
        assert!(answer.starts_with(&format!("HTTP/1.1 {status} ")), "{hosts}: {answer}");
    }
}

/// A batch of one key holds every solver. The film of another key is solved although none of the batch's jobs ends.
#[tokio::test]
async fn a_key_with_many_jobs_makes_room_for_a_job_of_another_key() {
    let guarded = Guarded::start(&[("PLATEAU_WORKERS", "2"), ("PLATEAU_JOBS__ATTEMPTS_MAX", "1")]).await;
    let (app, alice, bob) = (&guarded.app, &guarded.alice, &guarded.bob);
    app.hold.at("claimed.uniform_mesh");
    let lattices: Vec<Value> = (0..20)
        .map(|number| {
            let mut lattice = app::example("floor-fewest-nodes");
            lattice["kind"] = "uniform_mesh".into();
            lattice["label"] = format!("{number}").into();
            lattice["cache"] = "bypass".into();
            lattice
        })
        .collect();
    let posted = guarded.request(alice, Method::POST, "/v1/batches").json(&serde_json::json!({ "requests": lattices }));
    let batch: Value = posted.send().await.unwrap().json().await.unwrap();
    app.hold.reached_by("claimed", 2).await;
    let film = guarded.solve(bob, MINIMAL, &small_film(0.3)).await;
    assert_eq!(film["status"], "succeeded");
    // The batch gets both solvers back, and the job that made room has lost no attempt.
    app.hold.reached_by("claimed", 2).await;
    app.hold.release("claimed.uniform_mesh");
    let this = batch["links"]["self"].as_str().unwrap();
    let ended = guarded.request(alice, Method::GET, this).header("prefer", "wait=60").send().await.unwrap();
    let ended: Value = ended.json().await.unwrap();
    assert_eq!(ended["counts"]["succeeded"], 20, "{:#}", ended["counts"]);
}

#[tokio::test]
async fn a_key_is_replaced_without_a_gap() {
    let secrets = tempfile::tempdir().unwrap();
    let file = secrets.path().join("keys");
    let ((old, old_line), (new, new_line)) = (new_key("alice").await, new_key("alice").await);
    std::fs::write(&file, format!("{old_line}\n{new_line}\n")).unwrap();
    let app =
        TestApp::start_with(&[("PLATEAU_AUTH__KEYS_FILE", file.to_str().unwrap()), ("PLATEAU_WORKERS", "0")]).await;
    let ask = async |key: &str, path: &str| app.request(Method::GET, path).bearer_auth(key).send().await.unwrap();
    let posted = app.request(Method::POST, MINIMAL).bearer_auth(&old).json(&small_film(0.1)).send().await.unwrap();
    let job: Value = posted.json().await.unwrap();
    // Both keys have the same jobs.
    let this = job["links"]["self"].as_str().unwrap();
    assert_eq!((ask(&old, this).await.status(), ask(&new, this).await.status()), (StatusCode::OK, StatusCode::OK));
    std::fs::write(&file, format!("{old_line} 2020-01-01T00:00:00Z\n{new_line}\n")).unwrap();
    until("the old key has ended", async || ask(&old, this).await.status() == StatusCode::UNAUTHORIZED).await;
    assert_eq!(ask(&new, this).await.status(), StatusCode::OK);
}

#[tokio::test]
async fn a_key_may_do_only_what_its_scopes_name() {
    let secrets = tempfile::tempdir().unwrap();
    let file = secrets.path().join("keys");
    let [(submitter, first), (reader, second), (scraper, third)] =
        [new_key("office").await, new_key("office").await, new_key("monitor").await];
    std::fs::write(&file, format!("{first} submit\n{second} 2999-12-31T00:00:00Z read\n{third} metrics\n")).unwrap();
    let app = TestApp::start_with(&[
        ("PLATEAU_AUTH__KEYS_FILE", file.to_str().unwrap()),
        ("PLATEAU_WORKERS", "0"),
        ("PLATEAU_HTTP__MCP", if cfg!(feature = "mcp") { "true" } else { "false" }),
    ])
    .await;
    let posted =
        app.request(Method::POST, MINIMAL).bearer_auth(&submitter).json(&small_film(0.1)).send().await.unwrap();
    assert_eq!(posted.status(), StatusCode::ACCEPTED);
    let job: Value = posted.json().await.unwrap();
    let link = |name: &str| job["links"][name].as_str().unwrap().to_owned();
    let (this, cancel) = (link("self"), link("cancel"));
    let requests = [
        (Method::GET, this.as_str(), "read"),
        (Method::GET, "/v1/jobs", "read"),
        (Method::GET, "/v1/limits", "read"),
        (Method::POST, cancel.as_str(), "submit"),
        (Method::DELETE, this.as_str(), "submit"),
        (Method::GET, "/metrics", "metrics"),
    ];
    for (method, path, needed) in requests {
        // The key with the scope comes last, because it changes the job.
        let mut keys = [("submit", &submitter), ("read", &reader), ("metrics", &scraper)];
        keys.sort_by_key(|(scope, _)| *scope == needed);
        for (scope, key) in keys {
            let answer = app.request(method.clone(), path).bearer_auth(key).send().await.unwrap();
            if scope == needed {
                assert!(answer.status().is_success(), "{method} {path} with {scope}: {}", answer.status());
                continue;
            }
            let challenge = format!("Bearer error=\"insufficient_scope\", scope=\"{needed}\"");
            assert_eq!(answer.headers()["www-authenticate"], challenge.as_str(), "{method} {path} with {scope}");
            let refused = app::problem(answer, 403).await;
            assert_eq!(refused["type"], "/problems/insufficient-scope", "{method} {path} with {scope}");
        }
    }
    // A message of another protocol may do both, so it needs both scopes.
    for path in ["/mcp", "/solve", "/hops/solve"].into_iter().filter(|path| is_built(path)) {
        for key in [&submitter, &reader] {
            let answer = app.request(Method::POST, path).bearer_auth(key).json(&serde_json::json!({})).send().await;
            assert!(answer.unwrap().text().await.unwrap().contains("does not have the scope"), "{path}");
        }
    }
    // A scope that is taken away counts within seconds.
    std::fs::write(&file, format!("{first} submit\n{second} metrics\n")).unwrap();
    let status = async |path: &str| app.request(Method::GET, path).bearer_auth(&reader).send().await.unwrap().status();
    until("the reader may not read", async || status("/v1/jobs").await == StatusCode::FORBIDDEN).await;
    assert_eq!(status("/metrics").await, StatusCode::OK);
}

#[tokio::test]
async fn unknown_keys_of_an_address_are_throttled_and_known_keys_are_not() {
    let guarded = Guarded::start(&[("PLATEAU_AUTH__FAILURES_PER_MINUTE", "5")]).await;
    let guess =
        async || guarded.app.request(Method::GET, "/v1/jobs").bearer_auth("plateau_guess").send().await.unwrap();
    for _ in 0..5 {
        assert_eq!(guess().await.status(), StatusCode::UNAUTHORIZED);
    }
    let refused = guess().await;
    let retry_after_s: u64 = refused.headers()["retry-after"].to_str().unwrap().parse().unwrap();
    assert!((1..=12).contains(&retry_after_s), "{retry_after_s}");
    assert_eq!(app::problem(refused, 429).await["type"], "/problems/too-many-failures");
    assert_eq!(guarded.status(&guarded.alice, Method::GET, "/v1/jobs").await, StatusCode::OK);
    assert_eq!(guarded.app.get("/v1/jobs").await.status(), StatusCode::UNAUTHORIZED, "no key is no guess");
    let metrics = guarded.request(&guarded.alice, Method::GET, "/metrics").send().await.unwrap().text().await.unwrap();
    assert!(metrics.contains("plateau_auth_failures_total 6\n"), "{metrics}");
}
