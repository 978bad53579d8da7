//! The limits that the system sets to the process, and what the log says.

use crate::app::{TestApp, client, example};
use crate::hold::until;
use serde_json::{Value, json};
use std::path::Path;
use std::process::Stdio;
use std::sync::{Arc, Mutex};
use tokio::io::{AsyncBufReadExt, BufReader};
use tokio::process::{Child, Command};

/// A server that a shell has started with limits, and what it has logged.
struct Limited {
    url: String,
    log: Arc<Mutex<String>>,
    _child: Child,
}

impl Limited {
    /// Starts a server after the shell has run `limits`. Returns what it wrote to standard error if it did not start.
    async fn start(folder: &Path, limits: &str, environment: &[(&str, &str)]) -> Result<Self, String> {
        let mut child = Command::new("sh")
            .args(["-c", &format!("{limits}; exec \"$0\" \"$@\""), env!("CARGO_BIN_EXE_plateau")])
            .args(["--listen", "127.0.0.1:0", "--data"])
            .arg(folder)
            .env_clear()
            .envs(environment.iter().copied())
            .kill_on_drop(true)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let log = Arc::new(Mutex::new(String::new()));
        let (written, stderr) = (log.clone(), child.stderr.take().unwrap());
        let reading = tokio::spawn(async move {
            let mut lines = BufReader::new(stderr).lines();
            while let Ok(Some(line)) = lines.next_line().await {
                let mut log = written.lock().unwrap();
                log.push_str(&line);
                log.push('\n');
            }
        });
        let stdout = child.stdout.take().unwrap();
        let Some(line) = BufReader::new(stdout).lines().next_line().await.unwrap() else {
            let _ = reading.await;
            return Err(log.lock().unwrap().clone());
        };
        let url = line.strip_prefix("listening on ").unwrap().to_owned();
        Ok(Self { url, log, _child: child })
    }

    fn log(&self) -> String {
        self.log.lock().unwrap().clone()
    }

    async fn metric(&self, name: &str) -> f64 {
        let text = client().get(format!("{}/metrics", self.url)).send().await.unwrap().text().await.unwrap();
        let line = text.lines().find(|line| line.starts_with(&format!("{name} "))).unwrap_or_default();
        line.rsplit(' ').next().unwrap().parse().unwrap()
    }
}

#[tokio::test]
async fn the_limit_of_descriptors_is_raised_or_fewer_connections_are_taken() {
    let folder = tempfile::tempdir().unwrap();
    let server = Limited::start(&folder.path().join("a"), "ulimit -Sn 300", &[]).await.unwrap();
    assert!(server.metric("process_max_fds").await >= 4096.0 + 200.0);
    assert!(!server.log().contains("ulimit"), "{}", server.log());
    let server = Limited::start(&folder.path().join("b"), "ulimit -n 300", &[]).await.unwrap();
    assert_eq!(server.metric("process_max_fds").await as u64, 300);
    until("the warning", async || {
        server.log().contains("fewer connections are taken connections=150") || server.log().contains("connections=150")
    })
    .await;
}

/// A server whose address space is limited starts, or ends with a message.
#[tokio::test]
async fn a_limit_of_the_address_space_causes_no_panic() {
    let folder = tempfile::tempdir().unwrap();
    let environment = [("PLATEAU_JOBS__WORKERS", "1")];
    for mebibytes in [8192, 1024, 512, 256] {
        let limits = format!("ulimit -v {}", mebibytes * 1024);
        match Limited::start(&folder.path().join(mebibytes.to_string()), &limits, &environment).await {
            Ok(server) => {
                let body = example("two-rails");
                let post = client().post(format!("{}/v1/ruled-surfaces", server.url)).header("prefer", "wait=60");
                let answer = post.json(&body).send().await.unwrap();
                let job: Value = answer.json().await.unwrap();
                assert_eq!(job["status"], "succeeded", "{mebibytes} MiB: {job:#}");
                assert!(!server.log().contains("panicked"), "{mebibytes} MiB: {}", server.log());
            }
            Err(log) => {
                assert!(mebibytes <= 1024, "{mebibytes} MiB: {log}");
                assert!(
                    log.starts_with("plateau: the limit of the address space (ulimit -v)"),
                    "{mebibytes} MiB: {log}"
                );
            }
        }
    }
}

#[tokio::test]
async fn a_keys_file_without_keys_is_named_in_the_log() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("keys");
    std::fs::write(&file, "# none yet\n").unwrap();
    let environment = [("PLATEAU_AUTH__KEYS_FILE", file.to_str().unwrap())];
    let server = Limited::start(&folder.path().join("data"), "true", &environment).await.unwrap();
    until("the warning", async || server.log().contains("auth.keys_file has no keys")).await;
}

/// The libraries of MCP and PostgreSQL would log bodies at this level.
#[tokio::test]
async fn no_body_is_ever_logged() {
    let folder = tempfile::tempdir().unwrap();
    let has_mcp = cfg!(feature = "mcp");
    let environment = [("PLATEAU_LOG__LEVEL", "trace"), ("PLATEAU_HTTP__MCP", if has_mcp { "true" } else { "false" })];
    let server = Limited::start(&folder.path().join("data"), "true", &environment).await.unwrap();
    let mut request = example("two-rails");
    request["kind"] = "ruled_surface".into();
    request["label"] = "a-secret-label".into();
    let call = json!({ "jsonrpc": "2.0", "id": 1, "method": "tools/call",
        "params": { "name": "solve", "arguments": { "request": request, "wait_s": 60 } } });
    let (path, body) = if has_mcp { ("/mcp", call) } else { ("/v1/ruled-surfaces", request) };
    let post = client().post(format!("{}{path}", server.url)).header("accept", "application/json, text/event-stream");
    let answer = post.header("prefer", "wait=60").json(&body).send().await.unwrap();
    assert!(answer.text().await.unwrap().contains("a-secret-label"), "the job has the label");
    until("the answer is logged", async || server.log().contains("answered")).await;
    let log = server.log();
    assert!(!log.contains("a-secret-label"), "{}", log.lines().find(|line| line.contains("a-secret-label")).unwrap());
}

#[tokio::test]
async fn a_failed_job_is_logged_and_counted_with_its_type() {
    let folder = tempfile::tempdir().unwrap();
    let environment = [("PLATEAU_JOBS__DEADLINE_MS", "1"), ("PLATEAU_TEST_DELAY_MS", "1000")];
    let server = Limited::start(&folder.path().join("data"), "true", &environment).await.unwrap();
    let counted = async |series: &str| {
        let text = client().get(format!("{}/metrics", server.url)).send().await.unwrap().text().await.unwrap();
        text.lines().any(|line| line == series)
    };
    assert!(counted("plateau_audit_failures_total{kind=\"cable_net\"} 0").await, "present before the first failure");
    let film = crate::app::small_film(0.1);
    let post = client().post(format!("{}/v1/minimal-surfaces", server.url)).header("prefer", "wait=60").json(&film);
    let job: Value = post.send().await.unwrap().json().await.unwrap();
    assert_eq!(job["error"]["type"], "/problems/deadline", "{job:#}");
    assert!(counted("plateau_job_failures_total{kind=\"minimal_surface\",type=\"deadline\"} 1").await);
    let logged = |log: String| {
        log.lines()
            .any(|line| line.contains("ended") && line.contains("error_type=\"deadline\"") && line.contains("detail="))
    };
    until("the failure is logged", async || logged(server.log())).await;
}

#[tokio::test]
async fn a_job_whose_worker_was_killed_is_logged_and_counted_as_failed() {
    let settings = [("PLATEAU_WORKERS", "1"), ("PLATEAU_JOBS__LEASE_MS", "1000"), ("PLATEAU_JOBS__ATTEMPTS_MAX", "1")];
    let app = TestApp::start_with(&settings).await;
    app.hold.at("claimed");
    let job: Value = app.post(crate::app::MINIMAL, &crate::app::small_film(0.3)).await.json().await.unwrap();
    let id = job["id"].as_str().unwrap();
    app.hold.reached("claimed", id).await;
    let folder = app.kill().await;
    let server = Limited::start(&folder.path().join("data"), "true", &settings).await.unwrap();
    let get = async |path: &str| client().get(format!("{}{path}", server.url)).send().await.unwrap();
    let state = async || get(job["links"]["self"].as_str().unwrap()).await.json::<Value>().await.unwrap();
    until("the job has failed", async || state().await["status"] == "failed").await;
    assert_eq!(state().await["error"]["type"], "/problems/worker-lost");
    let logged =
        |line: &str| ["without a worker", id, "error_type=\"worker-lost\""].iter().all(|part| line.contains(part));
    until("the failure is logged", async || server.log().lines().any(logged)).await;
    let metrics = get("/metrics").await.text().await.unwrap();
    for series in [
        "plateau_job_failures_total{kind=\"minimal_surface\",type=\"worker-lost\"} 1",
        "plateau_jobs_total{kind=\"minimal_surface\",status=\"failed\"} 1",
    ] {
        assert!(metrics.lines().any(|line| line == series), "{series}");
    }
}

/// Pages of the database are overwritten, so that nothing can be stored.
#[tokio::test]
async fn a_server_whose_database_is_damaged_is_not_ready_and_answers_503() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    for height in [0.1, 0.2, 0.3] {
        assert_eq!(app.post(crate::app::MINIMAL, &crate::app::small_film(height)).await.status(), 202);
    }
    let (_, folder) = app.stop().await;
    let path = folder.path().join("data/plateau.sqlite");
    let number = |text: &str| -> usize {
        rusqlite::Connection::open(&path).unwrap().query_row(text, [], |row| row.get::<_, i64>(0)).unwrap() as usize
    };
    let page = number("SELECT rootpage FROM sqlite_schema WHERE name = 'jobs_by_id'");
    let size = number("PRAGMA page_size");
    let mut bytes = std::fs::read(&path).unwrap();
    bytes[(page - 1) * size..page * size].fill(0xA5);
    std::fs::write(&path, bytes).unwrap();
    let app = TestApp::start_in(folder, &[("PLATEAU_WORKERS", "0")]).await;
    let refused = app.post(crate::app::MINIMAL, &crate::app::small_film(0.4)).await;
    assert!(refused.headers().contains_key("retry-after"));
    crate::app::problem(refused, 503).await;
    crate::app::problem(app.get("/health/ready").await, 503).await;
    assert_eq!(app.get("/health/live").await.status(), 200);
}

/// A disk that refuses writes is noticed although nothing is submitted.
#[tokio::test]
async fn a_server_that_cannot_write_is_not_ready() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    assert_eq!(app.get("/health/ready").await.status(), 200);
    // The table of the probe is gone, as far as writes are concerned.
    let path = app.folder.path().join("data/plateau.sqlite");
    let change = |text: &str| rusqlite::Connection::open(&path).unwrap().execute_batch(text).unwrap();
    change(
        "CREATE TRIGGER dead BEFORE UPDATE ON leaders BEGIN SELECT raise(ABORT, 'dead'); END;
        CREATE TRIGGER gone BEFORE INSERT ON leaders BEGIN SELECT raise(ABORT, 'dead'); END",
    );
    until("readiness is off", async || app.get("/health/ready").await.status() != 200).await;
    change("DROP TRIGGER dead; DROP TRIGGER gone");
    until("readiness is on", async || app.get("/health/ready").await.status() == 200).await;
}
