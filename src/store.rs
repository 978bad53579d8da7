//! The store: jobs, their queue and their results as rows and bytes, in SQLite (embedded) or PostgreSQL (shared).
//!
//! It knows no geometry and no HTTP. What it promises:
//!
//! - A write that returned `Ok` is on disk, whole; one that returned an error changed nothing.
//! - A job is worked by one attempt at a time. `claim` gives an attempt number and a lease in the database's own time;
//!   every later write by the worker carries that number and changes nothing once the job has moved on, so a result is
//!   visible exactly once, however late a stalled worker wakes up.
//! - A lease that runs out puts the job back to its old place in the queue, up to `max_attempts` lost leases; then the
//!   job fails and its error says what happened to each attempt.
//!
//! Ids are chosen by the caller and must sort by time (ULID), because lists are ordered by them. Times are milliseconds
//! since 1970 by the database's clock. An owner is the name of an API key; without keys there is none. Functions that
//! take an `owner` see only that owner's jobs if one is given and every job otherwise.

mod batch;
#[cfg(feature = "s3")]
mod bucket;
mod callback;
mod engine;
mod files;
mod queue;
mod record;
mod retention;
mod sql;
mod sqlite;
mod watch;

use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use tokio::sync::watch as signal;

pub use batch::{BatchJob, BatchLookup, BatchRow, NewBatch, SubmittedBatch};
pub use callback::{Callback, Subject};
use engine::{Engine, Result};
use files::Files;
pub use queue::{Begun, Claimed, NewJob, Outcome, Renewed, Submitted};
pub use record::{EventId, Filter, JobRow, Lookup, Status, StatusEvent};
pub use retention::{Artefact, Counts, Swept};
pub use sql::redacted;
use watch::Changes;
pub use watch::JobWatch;

/// What a store may do; the defaults suit one machine.
#[derive(Debug, Clone)]
pub struct StoreOptions {
    /// Jobs that may wait in the queue, all owners together.
    pub queue_limit: u64,
    /// Jobs of one owner that may wait in the queue.
    pub owner_queue_limit: u64,
    /// Leases of one job that may run out before it fails.
    pub max_attempts: u32,
    /// How long a job and its mesh are kept after it ended.
    pub retention: Duration,
    /// How long an expired job is remembered as such.
    pub expired_retention: Duration,
    /// Ended jobs that are kept at most; the oldest beyond them expire early.
    pub max_jobs: u64,
    /// Bytes that all results together may take; the oldest ended jobs beyond them expire early. On SQLite the database
    /// itself does not grow beyond it either.
    pub max_bytes: Option<u64>,
    /// Where results larger than `inline_bytes` go: a folder or `s3://BUCKET/PREFIX`; into the database if there is neither.
    /// Every instance that shares the database must see the same place.
    pub results: Option<String>,
    /// Results up to this size are kept in the database.
    pub inline_bytes: usize,
    /// How long a result that no job has is left alone; longer than any transaction takes.
    pub orphan_age: Duration,
    /// Names the code that computes results: results are shared only within one version.
    pub result_version: String,
    /// Connections to PostgreSQL; one more listens for changes.
    pub connections: u32,
    /// How often watched jobs and the queue are looked at without having been told of a change.
    pub poll_interval: Duration,
}

impl Default for StoreOptions {
    fn default() -> Self {
        Self {
            queue_limit: 1000,
            owner_queue_limit: 1000,
            max_attempts: 5,
            retention: Duration::from_secs(7 * 24 * 3600),
            expired_retention: Duration::from_secs(30 * 24 * 3600),
            max_jobs: 100_000,
            max_bytes: None,
            results: None,
            inline_bytes: 1 << 20,
            orphan_age: Duration::from_secs(60),
            result_version: env!("CARGO_PKG_VERSION").into(),
            connections: 10,
            poll_interval: Duration::from_secs(1),
        }
    }
}

/// Why the store did not do as asked.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StoreError {
    /// The queue holds as many jobs as it may; `own` if it is the owner's share that is used up.
    #[error("the queue is full")]
    QueueFull { own: bool },
    /// The disk or the database's budget is full.
    #[error("no space left for the database: {0}")]
    NoSpace(String),
    /// The database cannot be reached or did not answer in time; trying again later may help.
    #[error("the database is unavailable: {0}")]
    Unavailable(String),
    /// Another transaction kept winning.
    #[error("the database is contended: {0}")]
    Contended(String),
    #[error("invalid database URL: {0}")]
    Url(String),
    #[error("migrating the database: {0}")]
    Migration(String),
    /// A defect: a statement the engine refused, or a row that does not read back.
    #[error("database error: {0}")]
    Internal(String),
}

impl From<sqlx::Error> for StoreError {
    fn from(error: sqlx::Error) -> Self {
        let text = error.to_string();
        match &error {
            sqlx::Error::Database(database) => match database.code().as_deref() {
                // disk_full.
                Some("53100") => Self::NoSpace(text),
                // serialization_failure, deadlock_detected, unique_violation.
                Some("40001" | "40P01" | "23505") => Self::Contended(text),
                // Connection, resource and operator classes.
                Some(code) if code.len() == 5 && ["08", "53", "57", "58"].contains(&&code[..2]) => {
                    Self::Unavailable(text)
                }
                _ => Self::Internal(text),
            },
            sqlx::Error::Io(_)
            | sqlx::Error::Tls(_)
            | sqlx::Error::Protocol(_)
            | sqlx::Error::PoolTimedOut
            | sqlx::Error::PoolClosed
            | sqlx::Error::WorkerCrashed => Self::Unavailable(text),
            _ => Self::Internal(text),
        }
    }
}

impl From<rusqlite::Error> for StoreError {
    fn from(error: rusqlite::Error) -> Self {
        use rusqlite::ErrorCode::{DatabaseBusy, DatabaseLocked, DiskFull, SystemIoFailure};
        let text = error.to_string();
        match error.sqlite_error_code() {
            Some(DiskFull) => Self::NoSpace(text),
            Some(DatabaseBusy | DatabaseLocked | SystemIoFailure) => Self::Unavailable(text),
            _ => Self::Internal(text),
        }
    }
}

impl From<std::io::Error> for StoreError {
    fn from(error: std::io::Error) -> Self {
        match error.kind() {
            std::io::ErrorKind::StorageFull | std::io::ErrorKind::QuotaExceeded => Self::NoSpace(error.to_string()),
            _ => Self::Unavailable(error.to_string()),
        }
    }
}

/// A handle of the store; clones share it.
#[derive(Debug, Clone)]
pub struct Store {
    inner: Arc<Inner>,
}

#[derive(Debug)]
struct Inner {
    engine: Engine,
    options: StoreOptions,
    changes: Changes,
    files: Option<Files>,
    /// When it was last seen that no job waits, and how often work had been heard of then.
    idle: Mutex<Option<(Instant, u64)>>,
}

impl Store {
    /// Opens `sqlite://PATH` (created if missing) or `postgres://USER@HOST/DATABASE` and brings its tables up to date.
    /// Must run inside a tokio runtime, which then also runs the store's own tasks.
    pub async fn open(url: &str, options: StoreOptions) -> Result<Self> {
        let files = options.results.as_deref().map(Files::open).transpose()?;
        let engine = Engine::open(url, &options).await?;
        let changes = Changes::new(&engine, options.poll_interval);
        Ok(Self { inner: Arc::new(Inner { engine, options, changes, files, idle: Mutex::default() }) })
    }

    /// Waits for writes under way, then closes every connection. Later calls fail as `Unavailable`.
    pub async fn close(&self) {
        self.inner.changes.stop();
        self.inner.engine.close().await;
    }

    /// Ok if the database answers.
    pub async fn ping(&self) -> Result<()> {
        self.inner.engine.rows("SELECT 1", Vec::new()).await.map(|_| ())
    }

    /// Changes whenever a job may have become claimable, on this instance or (PostgreSQL) any other. A worker that found
    /// nothing waits for this or for the poll interval, whichever is first.
    pub fn work_signal(&self) -> signal::Receiver<u64> {
        self.inner.changes.work_signal()
    }

    /// True while the last write found no space.
    pub fn is_full(&self) -> bool {
        self.inner.engine.is_full()
    }

    pub fn options(&self) -> &StoreOptions {
        &self.inner.options
    }
}

fn milliseconds(duration: Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX / 4).min(i64::MAX / 4)
}
