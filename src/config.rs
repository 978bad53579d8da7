//! One struct per concern, units in names. The defaults stand in `config/default.toml`; a test holds the two together.
//!
//! Flags beat environment beats file beats defaults. A setting `[section] key` is also read from `PLATEAU_SECTION__KEY`;
//! the four that everybody needs have short names of their own (`PLATEAU_LISTEN`, `_DATA`, `_DATABASE`, `_WORKERS`).

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::path::PathBuf;
use toml::{Table, Value};

/// Everything that can be set.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
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

/// The listener and what a connection may cost.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct HttpConfig {
    /// Port 0 picks a free one.
    pub listen: SocketAddr,
    /// Longest `Prefer: wait`; a longer wish is cut to this.
    pub wait_max_s: u64,
    /// A client that has not sent its request's headers after this is dropped.
    pub header_timeout_ms: u64,
    /// A client that has not sent its request's body after this is answered 408.
    pub body_timeout_ms: u64,
    /// A comment goes down every event stream this often, so that proxies keep it open.
    pub event_keep_alive_ms: u64,
    /// How long open requests may go on after a shutdown was asked for.
    pub shutdown_grace_ms: u64,
    /// Connections served at once; further ones wait in the listener's backlog.
    pub connections: usize,
    /// Bytes of request bodies in flight, all clients together.
    pub bodies_in_flight_bytes: usize,
    /// Names besides localhost that a server on a loopback address answers to (a proxy's upstream name).
    pub hosts: Vec<String>,
    /// Origins whose pages may use this server from a browser (`https://site.example`); `*` for all.
    pub cors_origins: Vec<String>,
    /// What a proxy puts before this server's paths (`/plateau`), kept or taken off on the way: links begin with it.
    pub public_base_path: String,
    /// Memory for files that were converted lately (meshes in a format, flat patterns).
    pub files_kept_bytes: usize,
    /// Where `/metrics` is answered, without a key and there alone; empty: with everything else. `plateau worker` has it too.
    pub metrics_listen: String,
}

impl Default for HttpConfig {
    fn default() -> Self {
        Self {
            listen: SocketAddr::from(([127, 0, 0, 1], 8080)),
            wait_max_s: 60,
            header_timeout_ms: 10_000,
            body_timeout_ms: 30_000,
            event_keep_alive_ms: 15_000,
            shutdown_grace_ms: 10_000,
            connections: 4096,
            bodies_in_flight_bytes: 256 << 20,
            hosts: Vec::new(),
            cors_origins: Vec::new(),
            public_base_path: String::new(),
            files_kept_bytes: 64 << 20,
            metrics_listen: String::new(),
        }
    }
}

/// Where jobs and results are kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct StoreConfig {
    /// Folder of the embedded store; created if missing.
    pub data: PathBuf,
    /// Empty: SQLite in the data folder. Else `sqlite://…` or `postgres://…`.
    pub database: String,
    /// Where results larger than `inline_bytes` go: a folder, or `s3://BUCKET/PREFIX` (region, endpoint and credentials from
    /// `AWS_…`); empty: `results` in the data folder with SQLite, the database itself with PostgreSQL. Every process on one
    /// database must see the same place.
    pub results: String,
    /// Results up to this size are kept in the database.
    pub inline_bytes: usize,
    /// Bytes that all results together may take (on SQLite also the database); the oldest beyond them expire early. 0: any.
    pub max_bytes: u64,
    /// Finished jobs that are kept at most; the oldest beyond them expire early.
    pub max_jobs: u64,
    /// Connections to PostgreSQL of one process; one more listens.
    pub connections: u32,
}

impl Default for StoreConfig {
    fn default() -> Self {
        Self {
            data: PathBuf::from("./data"),
            database: String::new(),
            results: String::new(),
            inline_bytes: 1 << 20,
            max_bytes: 0,
            max_jobs: 100_000,
            connections: 10,
        }
    }
}

/// Workers, the queue, and how long things may take.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct JobsConfig {
    /// Solvers that run at once; absent: one a core; 0: none in this process.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub workers: Option<usize>,
    /// Jobs that may wait; one more is answered 429.
    pub queue_length: usize,
    /// A solver that has not ended after this returns what it has reached.
    pub deadline_ms: u64,
    /// A worker that has not renewed its claim for this long has lost it.
    pub lease_ms: u64,
    /// A job that took this many workers down fails.
    pub attempts_max: u32,
    /// Progress is written to the store at most this often.
    pub progress_interval_ms: u64,
    /// Memory that running solvers may take together, by estimate; a job that would exceed it waits for others to end.
    pub memory_bytes: u64,
    /// Finished jobs and their meshes are removed after this; 0: never.
    pub retention_s: u64,
}

impl Default for JobsConfig {
    fn default() -> Self {
        Self {
            workers: None,
            queue_length: 1000,
            deadline_ms: 600_000,
            lease_ms: 15_000,
            attempts_max: 5,
            progress_interval_ms: 250,
            memory_bytes: 8 << 30,
            retention_s: 7 * 24 * 3600,
        }
    }
}

/// What one request may ask for. `GET /v1/limits` shows them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct LimitsConfig {
    /// Bytes of a request's body.
    pub body_bytes: usize,
    /// Points of all polylines of a request.
    pub points: usize,
    /// Triangles of a minimal surface or a uniform mesh.
    pub triangles: usize,
    /// Cells of the grids of all strips of a ruled surface (points of one directrix × points of the next).
    pub grid_cells: u64,
    /// Largest `max_iterations`.
    pub iterations: u32,
    /// Memory that solving one request may take, by estimate.
    pub memory_bytes: u64,
    /// Requests of one batch.
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

/// API keys. `plateau key new NAME` makes one.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct AuthConfig {
    /// SHA-256 of each key, as 64 hex digits, by the key's name. Without any key everybody may do everything.
    pub keys: BTreeMap<String, String>,
    /// A secrets file with one `NAME SHA256` a line; empty: none.
    pub keys_file: PathBuf,
    /// Requests a minute that each key may make; 0: any number.
    pub requests_per_minute: u32,
    /// How much of the queue one key may fill.
    pub queue_share_percent: u32,
    /// Whether to listen on other than loopback addresses without keys.
    pub open_without_keys: bool,
}

impl Default for AuthConfig {
    fn default() -> Self {
        Self {
            keys: BTreeMap::new(),
            keys_file: PathBuf::new(),
            requests_per_minute: 0,
            queue_share_percent: 50,
            open_without_keys: false,
        }
    }
}

// Not even a digest belongs into a log.
impl std::fmt::Debug for AuthConfig {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("AuthConfig").field("keys", &self.keys.len()).finish_non_exhaustive()
    }
}

/// Telling a client's URL that its job or batch has ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct WebhooksConfig {
    /// A file with `whsec_` and 24 to 64 random bytes in base64, from which each key's signing secret is derived
    /// (`plateau key webhooks NAME` prints it); empty: requests may not name a `callback_url`.
    pub secret_file: PathBuf,
    /// Networks (`10.1.0.0/16`) that may be told although they are not public.
    pub allowed_networks: Vec<String>,
    /// How long one attempt may take, resolving the name included.
    pub timeout_ms: u64,
    /// Pause after the first attempt that failed; each further one is four times as long, a day at most.
    pub retry_ms: u64,
    /// Attempts before a message is given up.
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

/// Logs on standard error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct LogConfig {
    /// tracing's filter syntax: `info`, `plateau=debug,sqlx=warn`.
    pub level: String,
    pub format: LogFormat,
}

impl Default for LogConfig {
    fn default() -> Self {
        Self { level: "info".into(), format: LogFormat::Text }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LogFormat {
    Text,
    Json,
}

impl Config {
    /// Merges the layers and checks the result.
    ///
    /// `environment` is every variable of the process; only `PLATEAU_SECTION__KEY` ones are read here.
    ///
    /// # Errors
    /// A message that names the setting, and where it came from where that is known.
    pub fn load(
        file: Option<&PathBuf>,
        environment: impl Iterator<Item = (String, String)>,
        flags: Table,
    ) -> Result<Self, String> {
        let mut merged = Table::try_from(Self::default()).map_err(|error| error.to_string())?;
        if let Some(path) = file {
            let text =
                std::fs::read_to_string(path).map_err(|error| format!("config file {}: {error}", path.display()))?;
            let table: Table = text.parse().map_err(|error| format!("config file {}: {error}", path.display()))?;
            // Checked alone first, so that a wrong key or type is said to be the file's.
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
        let config = Self::deserialize(merged).map_err(|error| error.to_string())?;
        config.check()?;
        Ok(config)
    }

    fn check(&self) -> Result<(), String> {
        let at_least_one = [
            ("jobs.queue_length", self.jobs.queue_length as u64),
            ("jobs.deadline_ms", self.jobs.deadline_ms),
            ("jobs.attempts_max", u64::from(self.jobs.attempts_max)),
            ("http.header_timeout_ms", self.http.header_timeout_ms),
            ("http.body_timeout_ms", self.http.body_timeout_ms),
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
        ];
        if let Some((name, _)) = at_least_one.iter().find(|(_, value)| *value == 0) {
            return Err(format!("{name} must be at least 1"));
        }
        if !(1..=100).contains(&self.auth.queue_share_percent) {
            return Err("auth.queue_share_percent must be from 1 to 100".into());
        }
        if self.jobs.lease_ms < 1000 {
            return Err("jobs.lease_ms must be at least 1000: a claim is renewed three times in it".into());
        }
        if self.jobs.memory_bytes < self.limits.memory_bytes {
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

    /// The database's URL: as configured, else SQLite in the data folder.
    #[must_use]
    pub fn database_url(&self) -> String {
        if self.store.database.is_empty() {
            format!("sqlite://{}", self.store.data.join("plateau.sqlite").display())
        } else {
            self.store.database.clone()
        }
    }
}

/// Nothing, or segments of characters that need no escape.
fn is_base_path(path: &str) -> bool {
    let plain = |segment: &str| {
        !segment.is_empty()
            && ![".", ".."].contains(&segment)
            && segment.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"-._~".contains(&byte))
    };
    path.is_empty() || path.strip_prefix('/').is_some_and(|rest| rest.split('/').all(plain))
}

/// An environment variable's text as a value of the type that the setting has.
fn parse_value(current: Option<&Value>, text: &str) -> Value {
    match current {
        Some(Value::String(_)) => Value::String(text.into()),
        // Lists are written with commas: none of ours has one inside an element.
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

    fn variables(pairs: &[(&str, &str)]) -> impl Iterator<Item = (String, String)> {
        pairs.iter().map(|(name, value)| ((*name).into(), (*value).into())).collect::<Vec<_>>().into_iter()
    }

    #[test]
    fn the_default_file_says_what_default_says() {
        let text = include_str!("../config/default.toml");
        let parsed: Config = toml::from_str(text).expect("config/default.toml parses");
        assert_eq!(parsed, Config::default());
        // Every setting stands in the file (a missing one would silently be the default).
        let in_file: Table = text.parse().unwrap();
        assert_eq!(in_file, Table::try_from(Config::default()).unwrap(), "config/default.toml must list every setting");
    }

    #[test]
    fn the_operators_table_has_every_setting() {
        let text = include_str!("../docs/OPERATIONS.md");
        for (section, settings) in Table::try_from(Config::default()).unwrap() {
            for name in settings.as_table().unwrap().keys().filter(|name| *name != "keys") {
                assert!(text.contains(&format!("| `{section}.{name}` |")), "{section}.{name} is not in the table");
            }
        }
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
    fn a_wrong_setting_is_named() {
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
