//! The only way in which tests start a server.

use crate::hold::{self, Hold};
use reqwest::{Method, RequestBuilder, Response, StatusCode};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::Stdio;
use tempfile::TempDir;
use tokio::io::{AsyncBufReadExt, BufReader};
use tokio::process::{Child, Command};

pub struct TestApp {
    pub url: String,
    pub folder: TempDir,
    pub client: reqwest::Client,
    /// Holds the jobs of this server at a stage.
    pub hold: Hold,
    child: Child,
}

pub fn binary() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plateau"));
    command.env_clear().kill_on_drop(true);
    command
}

/// Returns a client. Its TLS library needs a cryptography provider, which is installed once per process.
pub fn client() -> reqwest::Client {
    client_builder().build().expect("a client")
}

pub fn client_builder() -> reqwest::ClientBuilder {
    // Installing fails if the provider has already been installed.
    let _ = rustls::crypto::ring::default_provider().install_default();
    // A server closes connections that are idle for long, and a request that is on its way then has no answer.
    reqwest::Client::builder().pool_idle_timeout(std::time::Duration::from_secs(5))
}

pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

impl TestApp {
    pub async fn start() -> Self {
        Self::start_with(&[]).await
    }

    /// Starts a server with environment variables in addition to the defaults.
    pub async fn start_with(environment: &[(&str, &str)]) -> Self {
        Self::start_in(tempfile::tempdir().expect("a temporary folder"), environment).await
    }

    pub async fn start_in(folder: TempDir, environment: &[(&str, &str)]) -> Self {
        Self::start_program(binary(), folder, environment).await
    }

    pub async fn start_program(mut program: Command, folder: TempDir, environment: &[(&str, &str)]) -> Self {
        let hold = Hold::new(&folder.path().join("hold"));
        let mut child = program
            .args(["--listen", "127.0.0.1:0", "--data"])
            .arg(folder.path().join("data"))
            .env("PLATEAU_LOG__LEVEL", "warn")
            .env("PLATEAU_HTTP__SHUTDOWN_NOTICE_MS", "0")
            .env(hold::VARIABLE, &hold.folder)
            .envs(environment.iter().copied())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the binary starts");
        let stdout = child.stdout.take().expect("standard output is piped");
        let line = BufReader::new(stdout).lines().next_line().await.expect("a first line").expect("a first line");
        let url = line.strip_prefix("listening on ").expect("the first line says where").to_owned();
        Self { url, folder, client: client(), hold, child }
    }

    pub fn request(&self, method: Method, path: &str) -> RequestBuilder {
        self.client.request(method, format!("{}{path}", self.url))
    }

    pub async fn get(&self, path: &str) -> Response {
        self.request(Method::GET, path).send().await.expect("an answer")
    }

    pub async fn get_json(&self, path: &str) -> Value {
        let response = self.get(path).await;
        assert_eq!(response.status(), StatusCode::OK, "{path}");
        response.json().await.expect("JSON")
    }

    pub async fn post(&self, path: &str, body: &Value) -> Response {
        self.request(Method::POST, path).json(body).send().await.expect("an answer")
    }

    pub async fn post_waiting(&self, path: &str, body: &Value) -> Response {
        self.request(Method::POST, path).header("prefer", "wait=60").json(body).send().await.expect("an answer")
    }

    /// Posts a request, waits for the job's end, and fails unless the job has succeeded.
    pub async fn solve(&self, path: &str, body: &Value) -> Value {
        let job: Value = self.post_waiting(path, body).await.json().await.expect("JSON");
        let job = self.ended(job).await;
        assert_eq!(job["status"], "succeeded", "{job:#}");
        job
    }

    /// Waits for a job's end without a time limit.
    pub async fn ended(&self, mut job: Value) -> Value {
        while ["queued", "running"].contains(&job["status"].as_str().expect("a job")) {
            let this = job["links"]["self"].as_str().expect("a link");
            let waiting = self.request(Method::GET, this).header("prefer", "wait=60").send();
            job = waiting.await.expect("an answer").json().await.expect("JSON");
        }
        job
    }

    /// Waits until the server has counted this number of submitted films. From then on the server notices if the client
    /// that waits for the last film goes away.
    pub async fn submitted(&self, count: usize) {
        let line = format!("plateau_submissions_total{{kind=\"minimal_surface\",outcome=\"created\"}} {count}");
        let counted = async || self.get("/metrics").await.text().await.expect("text").lines().any(|one| one == line);
        hold::until(&line, counted).await;
    }

    /// Returns the processes of the server's large jobs.
    #[cfg(feature = "test-hooks")]
    pub fn children(&self) -> Vec<u32> {
        hold::children_of(self.child.id().expect("the server runs"))
    }

    /// Waits until the server has one child process, and returns it.
    #[cfg(feature = "test-hooks")]
    pub async fn only_child(&self) -> u32 {
        hold::until("one child runs", async || self.children().len() == 1).await;
        self.children()[0]
    }

    /// Returns the resident memory of the server in bytes.
    pub fn memory(&self) -> u64 {
        self.memory_as("VmRSS:")
    }

    /// Returns the largest resident memory of the server since [`TestApp::forget_peak`] in bytes.
    pub fn peak_memory(&self) -> u64 {
        self.memory_as("VmHWM:")
    }

    /// Makes the present memory of the server the largest one so far.
    pub fn forget_peak(&self) {
        let id = self.child.id().expect("the server runs");
        std::fs::write(format!("/proc/{id}/clear_refs"), "5").expect("procfs");
    }

    fn memory_as(&self, name: &str) -> u64 {
        let id = self.child.id().expect("the server runs");
        let status = std::fs::read_to_string(format!("/proc/{id}/status")).expect("procfs");
        let line = status.lines().find(|line| line.starts_with(name)).expect("a line of this name");
        line.split_whitespace().nth(1).expect("a number").parse::<u64>().expect("a number") * 1024
    }

    /// Sends SIGTERM.
    pub async fn terminate(&self) {
        let id = self.child.id().expect("the server runs").to_string();
        assert!(Command::new("kill").args(["-TERM", &id]).status().await.expect("kill").success());
    }

    /// Sends SIGTERM and returns the exit status.
    pub async fn stop(self) -> (std::process::ExitStatus, TempDir) {
        self.terminate().await;
        self.exited().await
    }

    /// Waits for a server that was told to stop, and returns its exit status.
    pub async fn exited(mut self) -> (std::process::ExitStatus, TempDir) {
        (self.child.wait().await.expect("an exit status"), self.folder)
    }

    /// Sends SIGKILL.
    pub async fn kill(mut self) -> TempDir {
        self.child.kill().await.expect("the server dies");
        self.folder
    }
}

pub const MINIMAL: &str = "/v1/minimal-surfaces";
pub const RULED: &str = "/v1/ruled-surfaces";
pub const UNIFORM: &str = "/v1/uniform-meshes";
pub const TENSILE: &str = "/v1/tensile-structures";
pub const CABLE_NETS: &str = "/v1/cable-nets";

pub fn example(name: &str) -> Value {
    let text = std::fs::read_to_string(root().join(format!("api/examples/{name}.json"))).expect("the example's file");
    serde_json::from_str(&text).expect("JSON")
}

/// The names of the examples that this build of the program takes.
pub fn example_names() -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(root().join("api/examples"))
        .expect("the folder")
        .map(|entry| Path::new(&entry.expect("an entry").file_name()).file_stem().unwrap().to_str().unwrap().to_owned())
        .filter(|name| cfg!(feature = "certificates") || example(name).get("certify").is_none())
        .collect();
    names.sort();
    names
}

pub fn path_of(kind: &str) -> &'static str {
    match kind {
        "minimal_surface" => MINIMAL,
        "ruled_surface" => RULED,
        "uniform_mesh" => UNIFORM,
        "tensile_structure" => TENSILE,
        "cable_net" => CABLE_NETS,
        other => panic!("unknown kind {other}"),
    }
}

/// Returns a film on a square with two opposite corners lifted by `height`. It is small and quick to solve, and each
/// height is a different request.
pub fn small_film(height: f64) -> Value {
    json!({ "boundaries": [[[0, 0, 0], [1, 0, height], [1, 1, 0], [0, 1, height]]],
        "resolution": { "triangles": 100 } })
}

/// Returns a strip with a grid of `n` × `n` cells.
pub fn large_strip(n: usize) -> Value {
    let rail = |y: f64, phase: f64| -> Vec<[f64; 3]> {
        (0..n).map(|k| k as f64 / n as f64).map(|t| [10.0 * t, y + (9.0 * t + phase).sin(), (7.0 * t).cos()]).collect()
    };
    json!({ "directrices": [rail(0.0, 0.0), rail(4.0, 1.0)], "objective": "minimal_bending_energy" })
}

/// Returns a film whose solver does not end, because its tolerances are below the rounding of the area. It is for tests
/// of the solver's own checks of the cancel signal. Other tests hold a job with [`TestApp::hold`].
pub fn endless_film(height: f64) -> Value {
    let mut film = small_film(height);
    film["solver"] = "vertex_relaxation".into();
    film["resolution"]["triangles"] = 20_000.into();
    film["tolerance"] = 1e-15.into();
    film["area_tolerance"] = 1e-15.into();
    film["max_iterations"] = 1_000_000.into();
    film
}

/// Returns false for the path of a part that this build leaves out.
pub fn is_built(path: &str) -> bool {
    match path {
        "/" => cfg!(feature = "studio"),
        _ if path.starts_with("/studio/") => cfg!(feature = "studio"),
        "/hops" | "/solve" => cfg!(feature = "hops"),
        _ if path.starts_with("/hops/") => cfg!(feature = "hops"),
        "/mcp" => cfg!(feature = "mcp"),
        _ => true,
    }
}

/// Asserts that a response is a problem document of this status, and returns the document.
pub async fn problem(response: Response, status: u16) -> Value {
    let path = response.url().path().to_owned();
    assert_eq!(response.status().as_u16(), status, "{path}");
    assert_eq!(response.headers()["content-type"], "application/problem+json");
    assert!(response.headers().contains_key("x-request-id"));
    let problem: Value = response.json().await.expect("JSON");
    assert_eq!(problem["status"], status);
    assert_eq!(problem["instance"], path);
    assert!(problem["type"].as_str().is_some_and(|kind| kind.contains("/problems/")));
    assert!(problem["title"].is_string() && problem["detail"].is_string());
    problem
}

/// Returns the pointers of a problem's errors.
pub fn pointers(problem: &Value) -> Vec<&str> {
    problem["errors"]
        .as_array()
        .map_or(Vec::new(), |errors| errors.iter().map(|error| error["pointer"].as_str().expect("a pointer")).collect())
}
