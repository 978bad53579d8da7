//! Settings: one struct per concern, with the units in the names. `config/default.toml` is generated from the doc comments
//! and defaults of this file. A test fails if they differ and names the command that writes the file again.
//!
//! Flags take precedence over the environment, the environment over the file, and the file over the defaults. A setting
//! `[section] key` is also read from `PLATEAU_SECTION__KEY`; four of them have short names too (`PLATEAU_LISTEN`,
//! `_DATA`, `_DATABASE`, `_WORKERS`).

mod memory;

use plateau_engine::limits::Limits;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::path::PathBuf;
use toml::{Table, Value};

/// All settings.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Config {
    pub http: HttpConfig,
    pub store: StoreConfig,
    pub jobs: JobsConfig,
    pub limits: LimitsConfig,
    pub auth: AuthConfig,
    pub webhooks: WebhooksConfig,
    pub log: LogConfig,
}

/// Settings of the listener, of its connections and of request bodies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct HttpConfig {
    /// Address and port of the listener. Port 0 picks a free port.
    pub listen: SocketAddr,
    /// Longest wait that `Prefer: wait` can ask for. A longer one is cut to it.
    pub wait_max_s: u64,
    /// Time from a ready connection to the last header of a request. After it the connection is closed, so an unused
    /// one stays open for as long.
    pub header_timeout_ms: u64,
    /// Time for a request's body. After it the answer is 408.
    pub body_timeout_ms: u64,
    /// Lowest rate of a request's body. A slower one is answered with 408. 0 means no lowest rate.
    pub body_rate_bytes_per_s: u64,
    /// Period over which the rate of a body is measured, and so the longest pause of a client.
    pub body_rate_grace_ms: u64,
    /// Lowest rate at which a client may take an answer. The connection of a slower one is closed. 0 means no lowest
    /// rate.
    pub answer_rate_bytes_per_s: u64,
    /// Period over which the rate of an answer is measured. Only the time counts in which the server waits for the
    /// client.
    pub answer_rate_grace_ms: u64,
    /// Interval of the comments that keep event streams open through proxies.
    pub event_keep_alive_ms: u64,
    /// Time between the end of readiness and the closing of the listener. Set it to the load balancer's checking
    /// interval.
    pub shutdown_notice_ms: u64,
    /// Time for running jobs to end after a shutdown was asked for, and for open requests after the notice.
    pub shutdown_grace_ms: u64,
    /// Number of connections that may be open at once. If the system allows fewer file descriptors, the number is lower,
    /// and the log says so. A further connection replaces the one that has been idle for longest; if none is idle, its requests wait for a second and are then answered with 503. Health checks are always
    /// answered.
    pub connections: usize,
    /// Share of `connections` that the open requests of one key may take. Without keys it is the share of one client's
    /// address, or of the proxy's. A further request is answered with 429.
    pub requests_share_percent: u32,
    /// Memory for the bodies of all clients while they are read, without the first 16 KiB of each.
    pub bodies_in_flight_bytes: usize,
    /// Share of `bodies_in_flight_bytes` that the bodies of one key may take. Without keys it is the share of one
    /// client's address, or of the proxy's.
    pub bodies_share_percent: u32,
    /// Host names other than localhost that a server on a loopback address answers to, such as a proxy's upstream name.
    pub hosts: Vec<String>,
    /// Origins whose pages may use this server from a browser (`https://site.example`), or `*` for every origin. Pages
    /// of other origins cannot change anything on this server.
    pub cors_origins: Vec<String>,
    /// Path below which a proxy serves this server (`/plateau`), which the proxy may remove or keep. Every link begins
    /// with it, so workers need the same value.
    pub public_base_path: String,
    /// Memory for a cache of files that were made from results, of up to 256 KiB each.
    pub files_kept_bytes: usize,
    /// Disk space in `store.data` for files above 256 KiB that were made from results. If all of them are being
    /// downloaded, a further one is answered with 503.
    pub files_disk_bytes: u64,
    /// Whether long answers are compressed with gzip for clients that accept it. Turn it off if a proxy does
    /// it.
    pub compression: bool,
    /// Whether `/` shows the studio, the page on which curves are drawn and results are looked at.
    pub studio: bool,
    /// Whether `/mcp` offers this server as tools for language models (Model Context Protocol). `plateau mcp` needs no
    /// setting.
    pub mcp: bool,
    /// Whether `/hops` offers components for Hops in Grasshopper, which posts to `/solve` and `/hops/solve`.
    pub hops: bool,
    /// Longest time for which a component of Hops waits for its job, which is then cancelled. Hops itself gives up
    /// after 100 s.
    pub hops_wait_s: u64,
    /// Address of a separate listener for `/metrics` that needs no API key; `plateau worker` has it too. If empty, the
    /// main listener serves `/metrics`.
    pub metrics_listen: String,
}

impl Default for HttpConfig {
    fn default() -> Self {
        Self {
            listen: SocketAddr::from(([127, 0, 0, 1], 8080)),
            wait_max_s: 60,
            header_timeout_ms: 10_000,
            body_timeout_ms: 30_000,
            body_rate_bytes_per_s: 1024,
            body_rate_grace_ms: 5000,
            answer_rate_bytes_per_s: 8192,
            answer_rate_grace_ms: 10_000,
            event_keep_alive_ms: 15_000,
            shutdown_notice_ms: 1000,
            shutdown_grace_ms: 10_000,
            connections: 4096,
            requests_share_percent: 25,
            bodies_in_flight_bytes: 256 << 20,
            bodies_share_percent: 50,
            hosts: Vec::new(),
            cors_origins: Vec::new(),
            public_base_path: String::new(),
            files_kept_bytes: 64 << 20,
            files_disk_bytes: 4 << 30,
            compression: true,
            studio: cfg!(feature = "studio"),
            mcp: false,
            hops: cfg!(feature = "hops"),
            hops_wait_s: 90,
            metrics_listen: String::new(),
        }
    }
}

/// Storage of jobs and results.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct StoreConfig {
    /// Folder of the embedded store, which is created if it does not exist.
    pub data: PathBuf,
    /// URL of the database: `sqlite://PATH`, or `postgres://USER@HOST/DATABASE` with `sslmode` and `sslrootcert` as
    /// parameters. If empty, SQLite in the data folder.
    pub database: String,
    /// Storage of results larger than `inline_bytes`, the same for every process: a folder, or `s3://BUCKET/PREFIX`
    /// (needs the cargo feature `s3`). If empty, the folder `results` in the data folder with SQLite, and the database
    /// itself with PostgreSQL.
    pub results: String,
    /// Largest result that is kept in the database.
    pub inline_bytes: usize,
    /// Number of bytes that all results and the requests of finished jobs together may take, with SQLite including the
    /// database file. Beyond four fifths of it the oldest jobs of the keys with the largest results and requests expire
    /// early. 0 means no limit.
    pub max_bytes: u64,
    /// Number of finished jobs that are kept. Beyond it the oldest jobs of the keys with the most jobs expire early.
    pub max_jobs: u64,
    /// Number of connections to PostgreSQL of one process, which opens one more for notifications.
    pub connections: u32,
}

impl Default for StoreConfig {
    fn default() -> Self {
        Self {
            data: PathBuf::from("./data"),
            database: String::new(),
            results: String::new(),
            inline_bytes: 1 << 20,
            max_bytes: 20 << 30,
            max_jobs: 100_000,
            connections: 10,
        }
    }
}

/// Settings of the workers and the queue, and time limits.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct JobsConfig {
    /// Number of solvers that run at once. If absent, one for each core. 0 means that this process solves no jobs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub workers: Option<usize>,
    /// Number of further solvers for jobs of at most 16 MiB of memory, which then do not wait for long jobs. If absent,
    /// 1 if `jobs.workers` is absent too, and otherwise 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub small_workers: Option<usize>,
    /// Number of jobs that may wait. A further submission is answered with 429.
    pub queue_length: usize,
    /// Time limit of a solver, which then returns the best mesh that it has reached.
    pub deadline_ms: u64,
    /// Largest memory of the jobs that run on a thread of this process, by estimate. A larger job, and each further
    /// attempt at a job, runs in a process of its own, whose memory the system limits. Without `/proc` every job runs
    /// on a thread.
    pub thread_bytes: u64,
    /// Time for a solver to end after its deadline, and for a thread also after a cancel, which kills a process at
    /// once. After it the job fails as `unresponsive`, and the solver's process is killed, or its thread is given up
    /// and replaced.
    pub unresponsive_ms: u64,
    /// Number of given-up threads at which every further job runs in a process of its own. Without `/proc`, a thread
    /// beyond this number is not replaced.
    pub unresponsive_max: usize,
    /// Time for which a worker owns a job without renewing its claim. After it another worker may take the job.
    pub lease_ms: u64,
    /// Number of workers that may die while they solve one job. After that many the job fails.
    pub attempts_max: u32,
    /// Time for which a job waits for a worker that can read its request, after a worker of another version or with lower
    /// limits could not. After it the job fails as `refused`.
    pub unread_s: u64,
    /// Shortest interval between two writes of a job's progress.
    pub progress_interval_ms: u64,
    /// Memory that all running solvers together may take, by estimate. A job that would exceed it stays queued, and up
    /// to 16 smaller jobs pass it. If absent, three quarters of the memory of the container (cgroup) or of the machine,
    /// whichever is less.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub memory_bytes: Option<u64>,
    /// Time after which a finished job and its mesh are removed. 0 means never.
    pub retention_s: u64,
}

impl Default for JobsConfig {
    fn default() -> Self {
        Self {
            workers: None,
            small_workers: None,
            queue_length: 1000,
            deadline_ms: 600_000,
            thread_bytes: 8 << 20,
            unresponsive_ms: 30_000,
            unresponsive_max: 4,
            lease_ms: 15_000,
            attempts_max: 5,
            unread_s: 3600,
            progress_interval_ms: 250,
            memory_bytes: None,
            retention_s: 7 * 24 * 3600,
        }
    }
}

/// Limits of one request. `GET /v1/limits` shows them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct LimitsConfig {
    /// Largest body of a request.
    pub body_bytes: usize,
    /// Number of points of all polylines of a request.
    pub points: usize,
    /// Number of triangles of a minimal surface or a uniform mesh.
    pub triangles: usize,
    /// Number of cells of all strips of a ruled surface: one for each pair of a point of one directrix and a point of
    /// the next.
    pub grid_cells: u64,
    /// Largest `max_iterations` of a request.
    pub iterations: u32,
    /// Memory for solving one request, by estimate. A server with workers accepts no request for more than
    /// `jobs.memory_bytes`.
    pub memory_bytes: u64,
    /// Number of requests of one batch.
    pub batch_requests: usize,
}

impl Default for LimitsConfig {
    fn default() -> Self {
        Self {
            body_bytes: 32 << 20,
            points: 200_000,
            triangles: 2_000_000,
            grid_cells: 2_000_000_000,
            iterations: 1_000_000,
            memory_bytes: 4 << 30,
            batch_requests: 100,
        }
    }
}

impl LimitsConfig {
    /// Returns the limits of one request.
    #[must_use]
    pub fn requests(&self) -> Limits {
        let Self { points, triangles, grid_cells, iterations, memory_bytes, .. } = *self;
        Limits { points, triangles, grid_cells, iterations, memory_bytes }
    }
}

/// API keys. `plateau key new NAME` creates one.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct AuthConfig {
    /// SHA-256 of each key as 64 hex digits, by the key's name. A time in UTC may follow, until which the key is valid:
    /// `"SHA256 2026-12-31T00:00:00Z"`, and scopes as in the keys file. A second key of the name follows after a comma.
    /// Without a key here or in the keys file every client may do everything.
    pub keys: BTreeMap<String, String>,
    /// Path of a file with a line `NAME SHA256` for each key, as `plateau key new NAME` prints it. An end and scopes may
    /// follow: `NAME SHA256 2026-12-31T00:00:00Z submit read`. With `submit` a key may submit, cancel and delete jobs,
    /// with `read` read jobs and the catalogue, with `metrics` read `/metrics`; MCP and Hops need the first two. Without
    /// scopes a key may do everything. A name may have two keys. The file is read again within seconds when it changes.
    pub keys_file: PathBuf,
    /// Number of requests of each key in a minute. 0 means no limit.
    pub requests_per_minute: u32,
    /// Number of unknown keys that one address, or a proxy's, may present in a minute. Further ones are answered with
    /// 429. Known keys are admitted all the same. 0 means no limit.
    pub failures_per_minute: u32,
    /// Share of the queue that the jobs of one key may fill.
    pub queue_share_percent: u32,
    /// Whether a server without keys may listen on an address that is not a loopback address.
    pub open_without_keys: bool,
}

impl Default for AuthConfig {
    fn default() -> Self {
        Self {
            keys: BTreeMap::new(),
            keys_file: PathBuf::new(),
            requests_per_minute: 0,
            failures_per_minute: 60,
            queue_share_percent: 50,
            open_without_keys: false,
        }
    }
}

// Logs must not contain digests.
impl std::fmt::Debug for AuthConfig {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("AuthConfig").field("keys", &self.keys.len()).finish_non_exhaustive()
    }
}

/// Webhooks: messages to a client's URL when its job or batch has ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct WebhooksConfig {
    /// Path of a file with `whsec_` and 24 to 64 random bytes in base64, from which each key's signing secret is
    /// derived. A second line may have the secret before it. If empty, requests may not name a `callback_url`.
    pub secret_file: PathBuf,
    /// Networks to which messages may be sent although they are not public, such as `10.1.0.0/16`.
    pub allowed_networks: Vec<String>,
    /// Time limit of one delivery, including the lookup of the host name.
    pub timeout_ms: u64,
    /// Pause after the first failed delivery. Each further pause is four times as long, up to a day.
    pub retry_ms: u64,
    /// Number of deliveries after which a message is given up.
    pub attempts_max: u32,
}

impl Default for WebhooksConfig {
    fn default() -> Self {
        Self {
            secret_file: PathBuf::new(),
            allowed_networks: Vec::new(),
            timeout_ms: 5000,
            retry_ms: 5000,
            attempts_max: 9,
        }
    }
}

/// Logs, which go to standard error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct LogConfig {
    /// Least severe level that is logged (`error`, `warn`, `info`, `debug`, `trace` or `off`), or a list of levels for
    /// parts of the program: `info,plateau::jobs=debug,hyper=warn`.
    pub level: String,
    /// Form of a log line: `text` or `json`.
    pub format: LogFormat,
}

impl Default for LogConfig {
    fn default() -> Self {
        Self { level: "info".into(), format: LogFormat::Text }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum LogFormat {
    Text,
    Json,
}

impl Config {
    /// Returns the defaults of `plateau mcp`. The program is a part of its user's assistant: it takes any free port of
    /// this machine, and no load balancer has to notice that it stops.
    #[must_use]
    pub fn of_mcp() -> Self {
        let http = HttpConfig {
            listen: SocketAddr::from(([127, 0, 0, 1], 0)),
            shutdown_notice_ms: 0,
            ..HttpConfig::default()
        };
        Self { http, ..Self::default() }
    }

    /// Merges the layers and checks the result.
    ///
    /// `environment` is every variable of the process; only `PLATEAU_SECTION__KEY` ones are read here.
    ///
    /// # Errors
    /// Returns a message that names the setting and, if known, the file or variable that it came from.
    pub fn load(
        file: Option<&PathBuf>,
        environment: impl Iterator<Item = (String, String)>,
        flags: Table,
    ) -> Result<Self, String> {
        Self::default().overlaid(file, environment, flags)
    }

    /// Same as [`Config::load`], with these settings in place of the defaults.
    ///
    /// # Errors
    /// Returns the errors of [`Config::load`].
    pub fn overlaid(
        self,
        file: Option<&PathBuf>,
        environment: impl Iterator<Item = (String, String)>,
        flags: Table,
    ) -> Result<Self, String> {
        let mut merged = Table::try_from(self).map_err(|error| error.to_string())?;
        if let Some(path) = file {
            let text =
                std::fs::read_to_string(path).map_err(|error| format!("config file {}: {error}", path.display()))?;
            let table: Table = text.parse().map_err(|error| format!("config file {}: {error}", path.display()))?;
            // The file is checked alone first, so that the message names the file if a key or type is wrong.
            Self::deserialize(table.clone()).map_err(|error| format!("config file {}: {error}", path.display()))?;
            merge(&mut merged, table);
        }
        let mut variables: Vec<_> = environment.collect();
        variables.sort();
        for (name, text) in variables {
            let Some((section, key)) = name.strip_prefix("PLATEAU_").and_then(|rest| rest.split_once("__")) else {
                continue;
            };
            let (section, key) = (section.to_lowercase(), key.to_lowercase());
            let value = parse_value(merged.get(&section).and_then(|table| table.get(&key)), &text);
            let mut layer = Table::new();
            layer.insert(section, Value::Table(Table::from_iter([(key, value)])));
            Self::deserialize(layer.clone()).map_err(|error| format!("environment variable {name}: {error}"))?;
            merge(&mut merged, layer);
        }
        merge(&mut merged, flags);
        let mut config = Self::deserialize(merged).map_err(|error| error.to_string())?;
        config.check()?;
        if config.jobs.workers != Some(0) {
            config.limits.memory_bytes = config.limits.memory_bytes.min(config.solver_memory_bytes());
        }
        Ok(config)
    }

    fn check(&self) -> Result<(), String> {
        let at_least_one = [
            ("jobs.queue_length", self.jobs.queue_length as u64),
            ("jobs.deadline_ms", self.jobs.deadline_ms),
            ("jobs.attempts_max", u64::from(self.jobs.attempts_max)),
            ("http.header_timeout_ms", self.http.header_timeout_ms),
            ("http.body_timeout_ms", self.http.body_timeout_ms),
            ("http.body_rate_grace_ms", self.http.body_rate_grace_ms),
            ("http.answer_rate_grace_ms", self.http.answer_rate_grace_ms),
            ("http.event_keep_alive_ms", self.http.event_keep_alive_ms),
            ("http.connections", self.http.connections as u64),
            ("limits.body_bytes", self.limits.body_bytes as u64),
            ("limits.points", self.limits.points as u64),
            ("limits.triangles", self.limits.triangles as u64),
            ("limits.grid_cells", self.limits.grid_cells),
            ("limits.batch_requests", self.limits.batch_requests as u64),
            ("webhooks.attempts_max", u64::from(self.webhooks.attempts_max)),
            ("webhooks.timeout_ms", self.webhooks.timeout_ms),
            ("webhooks.retry_ms", self.webhooks.retry_ms),
            ("limits.iterations", u64::from(self.limits.iterations)),
            ("jobs.unresponsive_max", self.jobs.unresponsive_max as u64),
        ];
        if let Some((name, _)) = at_least_one.iter().find(|(_, value)| *value == 0) {
            return Err(format!("{name} must be at least 1"));
        }
        let percentages = [
            ("auth.queue_share_percent", self.auth.queue_share_percent),
            ("http.requests_share_percent", self.http.requests_share_percent),
            ("http.bodies_share_percent", self.http.bodies_share_percent),
        ];
        if let Some((name, _)) = percentages.iter().find(|(_, value)| !(1..=100).contains(value)) {
            return Err(format!("{name} must be from 1 to 100"));
        }
        let parts = [
            ("studio", self.http.studio, cfg!(feature = "studio")),
            ("mcp", self.http.mcp, cfg!(feature = "mcp")),
            ("hops", self.http.hops, cfg!(feature = "hops")),
        ];
        if let Some((part, ..)) = parts.iter().find(|(_, wanted, built)| *wanted && !built) {
            return Err(format!("http.{part}: this program was built without the feature {part}"));
        }
        if self.jobs.lease_ms < 1000 {
            return Err("jobs.lease_ms must be at least 1000: a claim is renewed three times in it".into());
        }
        if self.jobs.memory_bytes.is_some_and(|bytes| bytes < self.limits.memory_bytes) {
            return Err("jobs.memory_bytes must be at least limits.memory_bytes".into());
        }
        if self.store.connections < 2 {
            return Err("store.connections must be at least 2".into());
        }
        if !self.http.metrics_listen.is_empty() && self.http.metrics_listen.parse::<SocketAddr>().is_err() {
            return Err("http.metrics_listen must be ADDRESS:PORT or empty".into());
        }
        if !is_base_path(&self.http.public_base_path) {
            return Err(
                "http.public_base_path must be empty or like /plateau: no slash at its end, letters, digits, and -._~ \
                        between the slashes"
                    .into(),
            );
        }
        if self.http.bodies_in_flight_bytes < self.limits.body_bytes {
            return Err("http.bodies_in_flight_bytes must be at least limits.body_bytes".into());
        }
        Ok(())
    }

    /// Returns true if jobs may belong to several keys. A server with a keys file has several owners even if the file
    /// is empty, because keys may be added to it later.
    #[must_use]
    pub fn has_owners(&self) -> bool {
        !self.auth.keys.is_empty() || !self.auth.keys_file.as_os_str().is_empty()
    }

    /// Returns the number of jobs of one owner that may wait in the queue.
    #[must_use]
    pub fn owner_queue_length(&self) -> usize {
        let share = self.jobs.queue_length.saturating_mul(self.auth.queue_share_percent as usize).div_ceil(100);
        if self.has_owners() { share } else { self.jobs.queue_length }
    }

    /// Returns `jobs.small_workers`, or its default.
    #[must_use]
    pub fn small_workers(&self) -> usize {
        self.jobs.small_workers.unwrap_or(usize::from(self.jobs.workers.is_none()))
    }

    /// Returns the number of requests that one client may have open.
    #[must_use]
    pub fn open_requests(&self) -> usize {
        (self.http.connections.saturating_mul(self.http.requests_share_percent as usize) / 100).max(1)
    }

    /// Returns `jobs.memory_bytes`, or its default on this machine.
    #[must_use]
    pub fn solver_memory_bytes(&self) -> u64 {
        // Assumed number of bytes if the size of the memory is not known, for example outside Linux. Most machines have
        // more.
        const UNKNOWN: u64 = 8 << 30;
        self.jobs.memory_bytes.unwrap_or_else(|| memory::limit_bytes().map_or(UNKNOWN, |bytes| bytes / 4 * 3))
    }

    /// Returns the configured URL of the database, or the URL of SQLite in the data folder.
    #[must_use]
    pub fn database_url(&self) -> String {
        if self.store.database.is_empty() {
            format!("sqlite://{}", self.store.data.join("plateau.sqlite").display())
        } else {
            self.store.database.clone()
        }
    }
}

/// Returns true for an empty path, or for segments of characters that need no escape.
fn is_base_path(path: &str) -> bool {
    let plain = |segment: &str| {
        !segment.is_empty()
            && ![".", ".."].contains(&segment)
            && segment.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"-._~".contains(&byte))
    };
    path.is_empty() || path.strip_prefix('/').is_some_and(|rest| rest.split('/').all(plain))
}

/// Parses an environment variable's text as the type of the current value.
fn parse_value(current: Option<&Value>, text: &str) -> Value {
    match current {
        Some(Value::String(_)) => Value::String(text.into()),
        // Elements of a list are separated by commas, because no element contains one.
        Some(Value::Array(_)) => {
            let elements = text.split(',').map(str::trim).filter(|element| !element.is_empty());
            Value::Array(elements.map(|element| Value::String(element.into())).collect())
        }
        _ => text
            .parse::<i64>()
            .map(Value::Integer)
            .or_else(|_| text.parse::<bool>().map(Value::Boolean))
            .unwrap_or_else(|_| Value::String(text.into())),
    }
}

fn merge(base: &mut Table, layer: Table) {
    for (key, value) in layer {
        match (base.get_mut(&key), value) {
            (Some(Value::Table(base)), Value::Table(layer)) => merge(base, layer),
            (_, value) => {
                base.insert(key, value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use schemars::generate::SchemaSettings;

    fn variables(pairs: &[(&str, &str)]) -> impl Iterator<Item = (String, String)> {
        pairs.iter().map(|(name, value)| ((*name).into(), (*value).into())).collect::<Vec<_>>().into_iter()
    }

    const DEFAULT_FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/config/default.toml");
    /// The command that writes the file again.
    const REFRESH: &str = "PLATEAU_WRITE=1 cargo test --lib config";

    /// Documentation of a struct of settings: its name in the file, its own text, and the name and text of each
    /// setting.
    struct Section {
        name: String,
        doc: String,
        settings: Vec<(String, String)>,
    }

    /// Reads the sections from the doc comments, in the order of the fields.
    fn sections() -> Vec<Section> {
        let jobs =
            JobsConfig { workers: Some(0), small_workers: Some(0), memory_bytes: Some(0), ..JobsConfig::default() };
        let every = Table::try_from(Config { jobs, ..Config::default() }).unwrap();
        let inline = SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true);
        let schema = inline.into_generator().into_root_schema_for::<Config>().to_value();
        let doc = |of: &serde_json::Value| of["description"].as_str().unwrap_or_default().replace('\n', " ");
        let section = |(name, settings): (&String, &Value)| {
            let schema = &schema["properties"][name];
            let names = settings.as_table().unwrap().keys();
            let settings = names.map(|name| (name.clone(), doc(&schema["properties"][name]))).collect();
            Section { name: name.clone(), doc: doc(schema), settings }
        };
        every.iter().map(section).collect()
    }

    /// Returns `text` as comment lines of at most 120 columns.
    fn comment(text: &str) -> String {
        let mut lines = vec![String::from("#")];
        for word in text.split(' ') {
            if lines.last().is_some_and(|line| line.chars().count() + 1 + word.chars().count() > 120) {
                lines.push(String::from("#"));
            }
            if let Some(line) = lines.last_mut() {
                line.push(' ');
                line.push_str(word);
            }
        }
        lines.join("\n") + "\n"
    }

    fn default_file(sections: &[Section], defaults: &Table) -> String {
        let mut text = comment(&format!(
            "Every setting with its default. Copy only the settings that you change. Flags take precedence over the \
             environment (PLATEAU_SECTION__KEY), and the environment over this file. Written by: {REFRESH}"
        ));
        for Section { name: section, doc, settings } in sections {
            text.push_str(&format!("\n{}[{section}]\n", comment(doc)));
            let mut tables = String::new();
            for (name, doc) in settings {
                match defaults[section].get(name) {
                    Some(Value::Table(_)) => tables.push_str(&format!("\n{}[{section}.{name}]\n", comment(doc))),
                    Some(value) => text.push_str(&format!("{}{name} = {value}\n", comment(doc))),
                    None => {
                        let example: u64 = if name.ends_with("_bytes") { 8 << 30 } else { 2 };
                        text.push_str(&format!("{}# {name} = {example}\n", comment(doc)));
                    }
                }
            }
            text.push_str(&tables);
        }
        text
    }

    #[test]
    fn the_default_file_comes_from_the_doc_comments() {
        let sections = sections();
        // The file says what a build with every part does.
        let mut every_part = Config::default();
        (every_part.http.studio, every_part.http.hops) = (true, true);
        let defaults = Table::try_from(&every_part).unwrap();
        for Section { name, doc, settings } in &sections {
            assert!(
                doc.ends_with('.') && settings.iter().all(|(_, doc)| doc.ends_with('.')),
                "{name} has no sentences"
            );
            let known = settings.iter().filter(|(setting, _)| defaults[name].get(setting).is_some()).count();
            assert_eq!(known, defaults[name].as_table().unwrap().len(), "a setting of {name} was not found");
        }
        assert_eq!(sections.len(), defaults.len());
        let file = default_file(&sections, &defaults);
        assert_eq!(toml::from_str::<Config>(&file).unwrap(), every_part);
        if std::env::var_os("PLATEAU_WRITE").is_some() {
            std::fs::write(DEFAULT_FILE, &file).unwrap();
        }
        assert!(
            std::fs::read_to_string(DEFAULT_FILE).unwrap() == file,
            "{DEFAULT_FILE} is not what the doc comments of src/config.rs say; write it again: {REFRESH}"
        );
    }

    #[test]
    fn a_comment_is_wrapped_at_120_columns() {
        let text = comment(&["word"; 60].join(" "));
        assert!(text.lines().count() == 3 && text.lines().all(|line| line.len() <= 120 && line.starts_with("# word")));
    }

    #[test]
    fn flags_beat_environment_beats_file() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("plateau.toml");
        std::fs::write(&file, "[jobs]\nqueue_length = 5\ndeadline_ms = 7\n[log]\nlevel = \"warn\"").unwrap();
        let flags: Table = "[log]\nlevel = \"debug\"".parse().unwrap();
        let environment =
            variables(&[("PLATEAU_JOBS__QUEUE_LENGTH", "6"), ("PLATEAU_LOG__LEVEL", "error"), ("PATH", "x")]);
        let config = Config::load(Some(&file), environment, flags).unwrap();
        assert_eq!((config.jobs.queue_length, config.jobs.deadline_ms, config.log.level.as_str()), (6, 7, "debug"));
    }

    #[test]
    fn an_error_message_names_the_wrong_setting() {
        let error = Config::load(None, variables(&[("PLATEAU_JOBS__QUEUE_LENGTH", "many")]), Table::new()).unwrap_err();
        assert!(error.contains("PLATEAU_JOBS__QUEUE_LENGTH"), "{error}");
        let error = Config::load(None, variables(&[("PLATEAU_JOBS__QUEUE", "1")]), Table::new()).unwrap_err();
        assert!(error.contains("PLATEAU_JOBS__QUEUE") && error.contains("unknown field"), "{error}");
        let error = Config::load(None, variables(&[("PLATEAU_JOBS__QUEUE_LENGTH", "0")]), Table::new()).unwrap_err();
        assert!(error.contains("jobs.queue_length"), "{error}");
        for path in ["plateau", "/", "/a/", "//a", "/a/../b", "/a?b", "/a b"] {
            let error =
                Config::load(None, variables(&[("PLATEAU_HTTP__PUBLIC_BASE_PATH", path)]), Table::new()).unwrap_err();
            assert!(error.contains("http.public_base_path"), "{path}: {error}");
        }
        Config::load(None, variables(&[("PLATEAU_HTTP__PUBLIC_BASE_PATH", "/a/b-1")]), Table::new()).unwrap();
    }
}
