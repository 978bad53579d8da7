//! Processes of the real program on one database.

use crate::hold::{self, Hold};
use reqwest::{Client, Response, StatusCode};
use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;
use tempfile::TempDir;
use tokio::io::{AsyncBufReadExt, BufReader};
use tokio::process::{Child, Command};

/// A process, which is killed when this value is dropped.
pub struct Process {
    child: Child,
    /// Base URL of its HTTP server. Empty for a worker.
    pub url: String,
}

/// State that the processes share.
pub struct Cluster {
    database: String,
    /// Keeps the data folder of an embedded store.
    _folder: TempDir,
    data: String,
    settings: Vec<(&'static str, String)>,
    /// Holds the jobs of all processes at a stage.
    pub hold: Hold,
}

impl Cluster {
    /// Uses `database`, or a new embedded store.
    pub fn new(database: Option<String>) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let data = folder.path().join("data").display().to_string();
        let hold = Hold::new(&folder.path().join("hold"));
        Self { database: database.unwrap_or_default(), _folder: folder, data, settings: Vec::new(), hold }
    }

    /// Adds a setting for every process started from now on.
    pub fn set(mut self, name: &'static str, value: impl ToString) -> Self {
        self.settings.push((name, value.to_string()));
        self
    }

    fn command(&self, role: &str, workers: usize) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_plateau"));
        command.env_clear().kill_on_drop(true).args([role, "--listen", "127.0.0.1:0", "--data", &self.data]);
        command.args(["--database", &self.database, "--workers", &workers.to_string()]);
        command.env("PLATEAU_LOG__LEVEL", std::env::var("PLATEAU_TEST_LOG").unwrap_or("error".into()));
        command.env(hold::VARIABLE, &self.hold.folder);
        command.envs(self.settings.iter().map(|(name, value)| (name, value)));
        command
    }

    /// Folder of the embedded store, or of the results beside another database.
    pub fn data(&self) -> &Path {
        Path::new(&self.data)
    }

    /// Starts `plateau serve` with this number of workers.
    pub async fn serve(&self, workers: usize) -> Process {
        let mut child = self.command("serve", workers).stdout(Stdio::piped()).spawn().expect("the binary starts");
        let stdout = child.stdout.take().expect("standard output is piped");
        let line = BufReader::new(stdout).lines().next_line().await.expect("a readable line").expect("a first line");
        let url = line.strip_prefix("listening on ").expect("the first line says where").to_owned();
        Process { child, url }
    }

    /// Starts `plateau worker` with this number of workers.
    pub fn worker(&self, workers: usize) -> Process {
        let child = self.command("worker", workers).stdout(Stdio::null()).spawn().expect("the binary starts");
        Process { child, url: String::new() }
    }
}

impl Process {
    /// Sends SIGKILL, so that no handler runs and nothing is flushed.
    pub async fn kill(&mut self) {
        self.child.kill().await.expect("the process dies");
    }

    /// Sends SIGKILL to the processes of its large jobs, and returns their number.
    pub fn kill_children(&self) -> usize {
        let children = hold::children_of(self.child.id().expect("the process runs"));
        let ids = children.into_iter().filter_map(|id| Pid::from_raw(id.cast_signed()));
        ids.filter(|id| kill_process(*id, Signal::KILL).is_ok()).count()
    }

    /// Sends SIGTERM.
    pub async fn terminate(&self) {
        let id = self.child.id().expect("the process runs").to_string();
        assert!(Command::new("kill").args(["-TERM", &id]).status().await.expect("kill runs").success());
    }

    /// Returns true if the process has ended.
    pub fn has_ended(&mut self) -> bool {
        self.child.try_wait().expect("the process is a child").is_some()
    }

    /// Waits for the end of the process after `terminate`.
    pub async fn ended(&mut self) -> std::process::ExitStatus {
        self.child.wait().await.expect("an exit status")
    }

    pub async fn get(&self, client: &Client, path: &str) -> Response {
        client.get(format!("{}{path}", self.url)).send().await.expect("an answer")
    }

    pub async fn get_json(&self, client: &Client, path: &str) -> Value {
        let response = self.get(client, path).await;
        assert_eq!(response.status(), StatusCode::OK, "{path}");
        response.json().await.expect("JSON")
    }

    /// Posts a request and returns the accepted job.
    pub async fn post(&self, client: &Client, body: &Value) -> Value {
        let to = format!("{}{}", self.url, path(body));
        let response = client.post(to).json(body).send().await.expect("an answer");
        assert_eq!(response.status(), StatusCode::ACCEPTED);
        response.json().await.expect("JSON")
    }

    /// Waits until the job has ended, and returns it.
    pub async fn ended_job(&self, client: &Client, id: &str) -> Value {
        for _ in 0..30 {
            let request = client.get(format!("{}/v1/jobs/{id}", self.url)).header("prefer", "wait=10");
            let job: Value = request.send().await.expect("an answer").json().await.expect("JSON");
            if !["queued", "running"].contains(&job["status"].as_str().expect("a status")) {
                return job;
            }
        }
        panic!("job {id} does not end");
    }
}

/// Returns the path to which a request is posted.
pub fn path(body: &Value) -> &'static str {
    if body.get("boundaries").is_some() { "/v1/minimal-surfaces" } else { "/v1/ruled-surfaces" }
}

/// Returns a film of about this number of triangles on a frame of four segments. Each `variant` is a different request,
/// and none reuses a kept result.
pub fn film(triangles: usize, variant: usize) -> Value {
    let height = 0.1 + variant as f64 * 0.01;
    let frame = [[0.0, 0.0, 0.0], [1.0, 0.0, height], [1.0, 1.0, 0.0], [0.0, 1.0, height]];
    json!({ "boundaries": [frame], "resolution": { "triangles": triangles }, "cache": "bypass" })
}

pub fn client() -> Client {
    // The TLS library of the client needs a cryptography provider. Installing it fails if it has already been
    // installed.
    let _ = rustls::crypto::ring::default_provider().install_default();
    Client::builder().timeout(Duration::from_secs(60)).build().expect("a client")
}

/// Returns a strip of `n` × `n` grid cells. Each `variant` is a different request, and none reuses a kept result.
pub fn strip(n: usize, variant: usize) -> Value {
    let rail = |y: f64, phase: f64| -> Vec<[f64; 3]> {
        (0..n)
            .map(|k| k as f64 / n as f64)
            .map(|t| [10.0 * t, y + (9.0 * t + phase).sin(), (7.0 * t).cos() + variant as f64 * 0.01])
            .collect()
    };
    json!({ "directrices": [rail(0.0, 0.0), rail(4.0, 1.0)], "objective": "minimal_area", "cache": "bypass" })
}
