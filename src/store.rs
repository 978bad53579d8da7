//! The store keeps jobs, their queue and their results as rows and bytes, in SQLite (embedded) or PostgreSQL (shared).
//!
//! It knows no geometry and no HTTP. It promises:
//!
//! - A write that returned `Ok` is on disk as a whole. A write that returned an error changed nothing.
//! - A job is worked on by one attempt at a time. `claim` gives an attempt number and a lease, measured by the
//!   database's clock. Every later write by the worker carries that number and changes nothing once the job has moved
//!   on. A result is therefore visible exactly once, however late a stalled worker wakes up.
//! - A lease that runs out puts the job back to its old place in the queue. After `max_attempts` lost leases the job
//!   fails, and its error describes each attempt. A lease that ran out because the database could not be reached is not
//!   lost: its worker renews it after the outage ([`contact`]). If another process could reach the database and took
//!   the job over meanwhile, the loss is taken back when the worker returns.
//!
//! The caller chooses identifiers, which must sort by time (ULID) because lists are ordered by them. Times are
//! milliseconds since 1970 by the database's clock. An owner is the name of an API key; a server without keys has no
//! owners. Functions that take an `owner` see only that owner's jobs, or every job if `owner` is `None`.
//!
//! Each operation is a plain function on a transaction ([`tx::Tx`]) in the module of its subject. [`operations`] lists
//! all of them and runs each on the engine's own threads ([`sqlite`], [`postgres`]).

mod ballast;
mod batches;
#[cfg(feature = "s3")]
mod bucket;
mod callbacks;
mod changes;
mod claims;
mod engine;
mod files;
mod handle;
mod history;
mod jobs;
mod leaders;
mod migrations;
mod operations;
mod outage;
mod pool;
#[cfg(feature = "postgres")]
mod postgres;
#[cfg(not(feature = "postgres"))]
#[path = "store/no_postgres.rs"]
mod postgres;
mod queue;
mod redact;
mod results;
mod retention;
#[cfg(feature = "postgres")]
mod session;
#[cfg(not(feature = "postgres"))]
#[path = "store/no_session.rs"]
mod session;
mod sqlite;
#[cfg(feature = "postgres")]
mod tls;
mod tx;
mod value;
mod watch;

use std::time::Duration;

pub use batches::{BatchAddition, BatchJob, BatchLookup, BatchRow, NewBatch};
pub use callbacks::{Attempted, Busy, Callback, CallbackRow, Delivery, Subject};
pub use claims::{Claimed, FailedJob, Renewed, Room};
pub use handle::Store;
pub use history::{EventId, StatusEvent};
pub use jobs::{Addition, EarlyEnd, Filter, JobRow, Lookup, NewJob, Outcome};
pub use queue::{Preference, WaitingOwner};
pub use redact::redacted;
pub use results::Artefact;
pub use retention::Swept;
pub use watch::JobWatch;

pub(crate) type Result<T> = std::result::Result<T, StoreError>;

/// Settings of a store. The defaults suit one machine.
#[derive(Debug, Clone)]
pub struct StoreOptions {
    /// Number of jobs of all owners together that may wait in the queue.
    pub queue_limit: u64,
    /// Number of jobs of one owner that may wait in the queue.
    pub owner_queue_limit: u64,
    /// Number of leases of one job that may run out before it fails.
    pub max_attempts: u32,
    /// Time for which a job waits for a worker that can read its request, after another worker could not.
    pub unread_patience: Duration,
    /// Length of the leases that this process asks for.
    pub lease: Duration,
    /// Time for which a job and its mesh are kept after the job ended.
    pub retention: Duration,
    /// Time for which the identifier of an expired job is remembered.
    pub expired_retention: Duration,
    /// Number of finished jobs that are kept. If there are more, the oldest expire early.
    pub max_jobs: u64,
    /// Number of bytes that all results together may take. If they take more than four fifths of it, the oldest
    /// finished jobs expire early. On SQLite this also limits the size of the database itself in the same way, so that
    /// many small results do not fill it.
    pub max_bytes: Option<u64>,
    /// Storage of results larger than `inline_bytes`: a folder or `s3://BUCKET/PREFIX`. If `None`, large results go
    /// into the database. Every instance that shares the database must see the same storage.
    pub results: Option<String>,
    /// Largest size in bytes of a result that is kept in the database.
    pub inline_bytes: usize,
    /// Minimum age at which a result without a job is removed. It must be longer than any transaction.
    pub orphan_age: Duration,
    /// Version of the code that computes results. Results are shared only within one version.
    pub result_version: String,
    /// Number of connections to PostgreSQL. One more connection listens for changes.
    pub connections: u32,
    /// Interval at which watched jobs and the queue are read again without a notification.
    pub poll_interval: Duration,
    /// Size of the ballast file beside an SQLite database, whose space is given up when the disk is full. 0 means no
    /// ballast. Three quarters of it must be larger than the write-ahead log.
    pub ballast_bytes: u64,
    /// Logs and counts a job that has failed because its workers died or could not read its request.
    pub note_failed: fn(&FailedJob),
}

impl Default for StoreOptions {
    fn default() -> Self {
        Self {
            queue_limit: 1000,
            owner_queue_limit: 1000,
            max_attempts: 5,
            unread_patience: Duration::from_secs(3600),
            lease: Duration::from_secs(15),
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
            ballast_bytes: 0,
            note_failed: |_| {},
        }
    }
}

/// Error of a store operation.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StoreError {
    /// The queue is full. `own` is true if only the owner's share of it is full.
    #[error("the queue is full")]
    QueueFull { own: bool },
    /// The disk or the database's budget is full.
    #[error("no space left for the database: {0}")]
    NoSpace(String),
    /// The database cannot be reached or did not answer in time. Trying again later may help.
    #[error("the database is unavailable: {0}")]
    Unavailable(String),
    /// The database does not let this program in with the settings that it has: a wrong password,
    /// an unknown database, or no agreement on encryption.
    #[error("the database refuses the connection: {0}")]
    Refused(String),
    /// The transaction lost against concurrent transactions in every try.
    #[error("the database is contended: {0}")]
    Contended(String),
    #[error("invalid database URL: {0}")]
    Url(String),
    #[error("migrating the database: {0}")]
    Migration(String),
    /// A defect: the engine refused a statement, or a row cannot be read.
    #[error("database error: {0}")]
    Internal(String),
}

impl StoreError {
    /// Returns true if the failure may be temporary, so that the same operation may succeed later without a change of
    /// settings.
    #[must_use]
    pub fn may_pass(&self) -> bool {
        match self {
            Self::QueueFull { .. } | Self::NoSpace(_) | Self::Unavailable(_) | Self::Contended(_) => true,
            Self::Refused(_) | Self::Url(_) | Self::Migration(_) | Self::Internal(_) => false,
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

fn owned(id: &str, owner: Option<&str>) -> (String, Option<String>) {
    (id.to_owned(), owner.map(str::to_owned))
}

fn milliseconds(duration: Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX / 4).min(i64::MAX / 4)
}

/// Converts a count to the integer type of the database. A count beyond its range becomes the largest integer.
fn limit(value: u64) -> i64 {
    i64::try_from(value).unwrap_or(i64::MAX)
}
