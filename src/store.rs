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
//!   lost: its worker renews it after the outage ([`contact`]). If another process could reach the database and took the
//!   job over meanwhile, the loss is taken back when the worker returns.
//!
//! The caller chooses identifiers, which must sort by time (ULID) because lists are ordered by them. Times are
//! milliseconds since 1970 by the database's clock. An owner is the name of an API key; a server without keys has no
//! owners. Functions that take an `owner` see only that owner's jobs, or every job if `owner` is `None`.
//!
//! Each operation is a plain function on a transaction ([`tx::Tx`]) in the module of its subject. [`Store`] lists all
//! operations and runs each on the engine's own threads ([`sqlite`], [`postgres`]).

mod ballast;
mod batches;
#[cfg(feature = "s3")]
mod bucket;
mod callbacks;
mod claims;
mod contact;
mod files;
mod jobs;
mod leaders;
mod migrations;
mod pool;
mod postgres;
mod queue;
mod results;
mod retention;
mod sqlite;
mod tls;
mod tx;
mod watch;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use tokio::sync::watch as signal;

use ballast::Ballast;
pub use batches::{BatchJob, BatchLookup, BatchRow, NewBatch, SubmittedBatch};
pub use callbacks::{Attempted, Busy, Callback, CallbackRow, Delivery, Subject};
pub use claims::{Claimed, Renewed, Room};
use contact::Contact;
use files::Files;
pub use jobs::{EventId, Filter, JobRow, Lookup, NewJob, Outcome, Solved, StatusEvent, Submitted};
pub use postgres::redacted;
pub use results::Artefact;
use results::{Prepared, ResultRow};
pub use retention::Swept;
use tx::{AfterCommit, Tx};
use watch::Changes;
pub use watch::JobWatch;

const URL_FORMS: &str = "expected sqlite://PATH or postgres://USER@HOST/DATABASE";

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
    /// Length of the leases that this process asks for.
    pub lease: Duration,
    /// Time for which a job and its mesh are kept after the job ended.
    pub retention: Duration,
    /// Time for which the identifier of an expired job is remembered.
    pub expired_retention: Duration,
    /// Number of finished jobs that are kept. If there are more, the oldest expire early.
    pub max_jobs: u64,
    /// Number of bytes that all results together may take. If they take more than four fifths of it, the oldest finished
    /// jobs expire early. On SQLite this also limits the size of the database itself in the same way, so that many small
    /// results do not fill it.
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
}

impl Default for StoreOptions {
    fn default() -> Self {
        Self {
            queue_limit: 1000,
            owner_queue_limit: 1000,
            max_attempts: 5,
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
    /// Returns true if the same operation may succeed later although nobody changes anything.
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

/// Handle of a store. Clones share one store.
#[derive(Debug, Clone)]
pub struct Store {
    inner: Arc<Inner>,
}

#[derive(Debug)]
struct Inner {
    engine: Engine,
    options: Arc<StoreOptions>,
    changes: Changes,
    files: Option<Files>,
    ballast: Ballast,
    contact: Contact,
    /// Name of this instance among those that share the database.
    instance: String,
    /// True if the last write found no space.
    full: AtomicBool,
    /// True if the last result file could not be written.
    results_refused: AtomicBool,
}

#[derive(Debug)]
enum Engine {
    Sqlite(sqlite::Database),
    Postgres(Arc<postgres::Database>),
}

/// Opening, closing and health.
impl Store {
    /// Opens `sqlite://PATH` (created if missing) or `postgres://USER@HOST/DATABASE` and migrates its tables. Must be
    /// called inside a tokio runtime, which then also runs the store's own tasks.
    pub async fn open(url: &str, options: StoreOptions) -> Result<Self> {
        let files = options.results.as_deref().map(Files::open).transpose()?;
        let is_postgres = url.starts_with("postgres://") || url.starts_with("postgresql://");
        if !is_postgres && !url.starts_with("sqlite:") {
            return Err(StoreError::Url(URL_FORMS.into()));
        }
        let (engine, ballast) = if is_postgres {
            let database = postgres::Database::open(url, &options).await?;
            (Engine::Postgres(Arc::new(database)), Ballast::new("".as_ref(), 0))
        } else {
            let ballast = Ballast::new(&sqlite::path(url)?, options.ballast_bytes);
            let database = match sqlite::Database::open(url, &options).await {
                Err(StoreError::NoSpace(_)) => {
                    ballast.give_up();
                    ballast.give_up_rest();
                    sqlite::Database::open(url, &options).await?
                }
                opened => opened?,
            };
            ballast.restore();
            (Engine::Sqlite(database), ballast)
        };
        let changes = Changes::new(&engine, options.poll_interval)?;
        let contact = Contact::new(options.lease, !is_postgres);
        let store = Self {
            inner: Arc::new(Inner {
                engine,
                options: Arc::new(options),
                changes,
                files,
                ballast,
                contact,
                instance: ulid::Ulid::generate().to_string(),
                full: AtomicBool::new(false),
                results_refused: AtomicBool::new(false),
            }),
        };
        store.probe_results().await;
        Ok(store)
    }

    /// Checks the form of a database's URL and of the place of its results (empty for the default), without reaching either.
    pub fn check_places(url: &str, results: &str) -> Result<()> {
        if url.starts_with("postgres://") || url.starts_with("postgresql://") {
            postgres::check_url(url)?;
        } else if url.starts_with("sqlite:") {
            let path = sqlite::path(url)?;
            let above = path.ancestors().skip(1).find(|folder| folder.exists());
            if let Some(file) = above.filter(|above| !above.is_dir()) {
                return Err(StoreError::Url(format!("{} is not a folder", file.display())));
            }
        } else {
            return Err(StoreError::Url(URL_FORMS.into()));
        }
        Files::check(results)
    }

    /// Waits for running writes, then closes every connection. Later calls fail with `Unavailable`.
    pub async fn close(&self) {
        match &self.inner.engine {
            Engine::Sqlite(database) => database.close().await,
            Engine::Postgres(database) => {
                let instance = self.inner.instance.clone();
                // If this fails, another instance leads after a while.
                let _ = self.write(move |tx| leaders::leave(tx, &instance)).await;
                database.close().await;
            }
        }
    }

    /// Returns `Ok` if the database answers and takes new jobs and results.
    pub async fn check(&self) -> Result<()> {
        self.read(|tx| tx.exists("SELECT 1", &[])).await?;
        if let Engine::Sqlite(database) = &self.inner.engine {
            database.check_writer()?;
        }
        self.check_room_for_results()
    }

    /// Returns an error if the last write of a job or a result failed because of missing space or missing result
    /// storage. Workers claim no job meanwhile, because they could not store its result.
    pub fn check_room_for_results(&self) -> Result<()> {
        if self.inner.full.load(Ordering::Relaxed) || self.inner.ballast.is_given_up() {
            return Err(StoreError::NoSpace("the disk is full".into()));
        }
        if self.inner.results_refused.load(Ordering::Relaxed) {
            return Err(StoreError::Unavailable("results cannot be written to store.results".into()));
        }
        Ok(())
    }

    /// Checks whether result files can be written, and logs an error if they cannot.
    pub async fn probe_results(&self) {
        let Some(files) = &self.inner.files else { return };
        let probed = files.probe().await;
        let refused = self.inner.results_refused.swap(probed.is_err(), Ordering::Relaxed);
        match probed {
            Err(error) => tracing::error!(%error, "results cannot be written to store.results; no job is started"),
            Ok(()) if refused => tracing::info!("results can be written again"),
            Ok(()) => {}
        }
    }

    /// Returns a signal that changes whenever a job may have become claimable, on this instance or (PostgreSQL) any
    /// other. A worker that found no job waits for this signal or for the poll interval, whichever comes first.
    pub fn work_signal(&self) -> signal::Receiver<u64> {
        self.inner.changes.work_signal()
    }

    pub fn options(&self) -> &StoreOptions {
        &self.inner.options
    }

    fn changes(&self) -> &Changes {
        &self.inner.changes
    }

    fn files(&self) -> Option<&Files> {
        self.inner.files.as_ref()
    }

    /// Runs `work` in a transaction. If this returns `Ok`, all of it is durable; if it returns an error, none of it
    /// happened. The exception is a connection lost during the commit, after which the outcome is unknown. `work` may
    /// run more than once, so it must not act outside the database.
    async fn write<T: Send + 'static>(&self, work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static) -> Result<T> {
        let written = match &self.inner.engine {
            Engine::Sqlite(database) => database.write(work).await,
            Engine::Postgres(database) => database.write(work).await,
        };
        self.inner.contact.note(&written, true);
        match &written {
            Ok(_) => self.inner.full.store(false, Ordering::Relaxed),
            Err(StoreError::NoSpace(_)) => {
                self.inner.full.store(true, Ordering::Relaxed);
                self.inner.ballast.give_up();
            }
            Err(_) => {}
        }
        let (value, after_commit) = written?;
        self.publish(after_commit).await;
        Ok(value)
    }

    async fn publish(&self, after_commit: AfterCommit) {
        self.inner.changes.publish(&after_commit);
        if let Some(files) = &self.inner.files {
            for file in after_commit.unneeded_files {
                files.remove(file).await;
            }
        }
    }

    /// Runs `work`, which must only read.
    async fn read<T: Send + 'static>(&self, work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static) -> Result<T> {
        let read = match &self.inner.engine {
            Engine::Sqlite(database) => database.read(work).await,
            Engine::Postgres(database) => database.read(work).await,
        };
        self.inner.contact.note(&read, false);
        read
    }

    /// Same as [`Store::write`], for work that also needs the options.
    async fn write_with<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>, &StoreOptions) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let options = Arc::clone(&self.inner.options);
        self.write(move |tx| work(tx, &options)).await
    }

    /// Fails while the ballast is given up, so that new jobs do not take the space that accepted jobs need.
    fn check_ballast(&self) -> Result<()> {
        if self.inner.ballast.is_given_up() {
            return Err(StoreError::NoSpace("the disk is full".into()));
        }
        Ok(())
    }

    /// Names the result, and writes its file if it is too large for the database.
    async fn prepare(&self, id: &str, attempt: i64, outcome: &Outcome) -> Result<Option<Prepared>> {
        let Outcome::Succeeded { artefact, artefact_hash, .. } = outcome else { return Ok(None) };
        let mut prepared = Prepared { hash: results::name(artefact, *artefact_hash), file: None };
        if let Some(files) = &self.inner.files
            && artefact.len() > self.inner.options.inline_bytes
        {
            let file = format!("{id}-{attempt}");
            let written = files.write(&file, artefact).await;
            self.inner.results_refused.store(written.is_err(), Ordering::Relaxed);
            if matches!(written, Err(StoreError::NoSpace(_))) {
                self.inner.ballast.give_up();
            }
            written?;
            prepared.file = Some(file);
        }
        Ok(Some(prepared))
    }
}

/// Jobs.
impl Store {
    /// Fails with `QueueFull` if the queue has no room for another job of this owner.
    pub async fn check_room(&self, owner: Option<&str>) -> Result<()> {
        let (options, owner) = (Arc::clone(&self.inner.options), owner.map(str::to_owned));
        self.read(move |tx| queue::check_room(tx, owner.as_deref(), &options)).await
    }

    /// Stores a job, and cancels the older jobs of its series in the same transaction. Fails with `QueueFull` if the queue or the owner's share of it is full. A job that reuses a kept
    /// result is exempt.
    pub async fn submit(&self, job: NewJob) -> Result<Submitted> {
        self.check_ballast()?;
        self.write_with(move |tx, options| jobs::submit(tx, &job, None, None, options)).await
    }

    /// Stores a job that this process has already solved. Submission and end are one write, so they become visible
    /// together.
    pub async fn submit_solved(&self, job: NewJob, solved: Solved) -> Result<Submitted> {
        self.check_ballast()?;
        let result = self.prepare(&job.id, 1, &solved.outcome).await?;
        let submit = move |tx: &mut Tx<'_>, options: &StoreOptions| {
            jobs::submit(tx, &job, None, Some((&solved, result.as_ref())), options)
        };
        self.write_with(submit).await
    }

    pub async fn get(&self, id: &str, owner: Option<&str>) -> Result<Lookup> {
        let (id, owner) = owned(id, owner);
        self.read(move |tx| jobs::get(tx, &id, owner.as_deref())).await
    }

    /// Returns at most `page` jobs, newest first, and the cursor of the next page if there is one. A cursor is the last
    /// identifier of the previous page, so jobs that come or go between pages neither repeat nor hide others.
    pub async fn list(&self, filter: Filter, page: u32, cursor: Option<&str>) -> Result<(Vec<JobRow>, Option<String>)> {
        let cursor = cursor.map(str::to_owned);
        self.read(move |tx| jobs::list(tx, &filter, page, cursor.as_deref())).await
    }

    /// Cancels a queued or running job at once. Returns a finished job unchanged. The worker learns of the cancel by
    /// its next renewal or by watching the job.
    pub async fn cancel(&self, id: &str, owner: Option<&str>) -> Result<Lookup> {
        let (id, owner) = owned(id, owner);
        self.write_with(move |tx, options| jobs::cancel(tx, &id, owner.as_deref(), options)).await
    }

    /// Removes a job, whatever its status. The next sweep removes its result unless another job shares it. Returns
    /// false if the job does not exist.
    pub async fn delete(&self, id: &str, owner: Option<&str>) -> Result<bool> {
        let (id, owner) = owned(id, owner);
        self.write(move |tx| jobs::delete(tx, &id, owner.as_deref())).await
    }

    /// Returns the number of jobs that wait.
    pub async fn queue_length(&self) -> Result<i64> {
        self.read(queue::length).await
    }
}

/// Results.
impl Store {
    /// Returns the result of a succeeded job. Returns `None` for any other identifier and for a discarded result.
    pub async fn artefact(&self, id: &str, owner: Option<&str>) -> Result<Option<Artefact>> {
        let (id, owner) = owned(id, owner);
        self.result(move |tx| results::find(tx, &id, owner.as_deref())).await
    }

    /// Returns the result of a name. Returns `None` for a result that was removed or discarded.
    pub async fn artefact_named(&self, name: &[u8]) -> Result<Option<Artefact>> {
        let name = name.to_vec();
        self.result(move |tx| results::named(tx, &name)).await
    }

    async fn result(
        &self,
        find: impl Fn(&mut Tx<'_>) -> Result<Option<ResultRow>> + Clone + Send + 'static,
    ) -> Result<Option<Artefact>> {
        let mut missing = None;
        loop {
            let Some(row) = self.read(find.clone()).await? else { return Ok(None) };
            let bytes = match (row.bytes, &row.file, &self.inner.files) {
                (Some(bytes), _, _) => Some(bytes),
                (None, Some(file), Some(files)) => files.read(file).await?,
                (None, file, _) => {
                    let text = format!("the result is in file {file:?} but store.results is not set");
                    return Err(StoreError::Unavailable(text));
                }
            };
            match bytes {
                Some(bytes) => return Ok(Some(Artefact { hash: row.hash, bytes, touched_at: row.touched_at })),
                // Another write may have given the row a new file since the row was read.
                None if row.file != missing => missing = row.file,
                None => {
                    self.write(move |tx| results::stop_sharing(tx, &row.hash)).await?;
                    let file = missing.unwrap_or_default();
                    return Err(StoreError::Unavailable(format!("the result's file {file} is missing")));
                }
            }
        }
    }

    /// Removes a result whose bytes are damaged. Its jobs keep everything else, and the next equal request is solved
    /// again.
    pub async fn discard(&self, artefact: &Artefact) -> Result<()> {
        let (hash, touched_at) = (artefact.hash.clone(), artefact.touched_at);
        self.write(move |tx| results::discard(tx, &hash, touched_at)).await
    }
}

/// Workers.
impl Store {
    /// Claims the job whose turn it is for the time `lease`. Returns `None` if no job waits. Jobs whose lease ran out
    /// go back to the queue first.
    pub async fn claim(&self, worker: &str, lease: Duration) -> Result<Option<Claimed>> {
        self.claim_within(worker, lease, Room::ANY).await
    }

    /// Same as [`Store::claim`], for a worker with this room. Jobs that fit may overtake a job that does not fit into the
    /// free memory, but only a limited number of them. After that nothing is claimed until the job fits.
    pub async fn claim_within(&self, worker: &str, lease: Duration, room: Room) -> Result<Option<Claimed>> {
        // Idle workers only read, so that they do not occupy SQLite's one writer.
        let (recovered, waiting) = self.recover_for(room).await?;
        if recovered == 0 && !waiting {
            return Ok(None);
        }
        let worker = worker.to_owned();
        self.write(move |tx| claims::claim(tx, &worker, lease, room)).await
    }

    /// Returns the job that an earlier claim under this name has claimed, if it did, with a new lease. A worker asks this
    /// after a claim that failed, because the claim may have been committed although its answer was lost. The name must
    /// belong to one claim only.
    pub async fn claimed_by(&self, worker: &str, lease: Duration) -> Result<Option<Claimed>> {
        let worker = worker.to_owned();
        self.write(move |tx| claims::claimed_by(tx, &worker, lease)).await
    }

    /// Extends the lease if the worker still holds the job.
    pub async fn renew(&self, id: &str, attempt: i64, lease: Duration) -> Result<Renewed> {
        let id = id.to_owned();
        self.write(move |tx| claims::renew(tx, &id, attempt, lease)).await
    }

    /// Stores the latest progress (JSON text) if the worker still holds the job.
    pub async fn progress(&self, id: &str, attempt: i64, progress: &str) -> Result<Renewed> {
        let (id, progress) = (id.to_owned(), progress.to_owned());
        self.write(move |tx| claims::progress(tx, &id, attempt, &progress)).await
    }

    /// Ends the attempt. The outcome and the new status become visible together. Returns true also if an earlier call has
    /// already stored this outcome, so that a worker may repeat a call whose answer was lost. If the worker had lost the
    /// job, changes nothing and returns false.
    pub async fn finish(&self, id: &str, attempt: i64, outcome: Arc<Outcome>) -> Result<bool> {
        if self.inner.ballast.is_gone() {
            return Err(StoreError::NoSpace("the disk is full".into()));
        }
        let result = self.prepare(id, attempt, &outcome).await?;
        let id = id.to_owned();
        let finish = move |tx: &mut Tx<'_>, options: &StoreOptions| {
            claims::finish(tx, &id, attempt, &outcome, result.as_ref(), options)
        };
        self.write_with(finish).await
    }

    /// Puts a running job back to its old place in the queue without counting a lost lease. Returns false if the worker
    /// had lost the job.
    pub async fn hand_back(&self, id: &str, attempt: i64) -> Result<bool> {
        let id = id.to_owned();
        self.write(move |tx| claims::hand_back(tx, &id, attempt)).await
    }
}

/// Batches.
impl Store {
    /// Stores a batch as a whole. Fails with `QueueFull` if the queue has no room for all of its jobs.
    pub async fn submit_batch(&self, batch: NewBatch) -> Result<SubmittedBatch> {
        self.check_ballast()?;
        self.write_with(move |tx, options| batches::submit(tx, &batch, options)).await
    }

    pub async fn batch(&self, id: &str, owner: Option<&str>) -> Result<BatchLookup> {
        let (id, owner) = owned(id, owner);
        self.read(move |tx| batches::get(tx, &id, owner.as_deref())).await
    }

    /// Returns the complete rows of a batch's jobs, in the order of the submission.
    pub async fn batch_jobs(&self, id: &str) -> Result<Vec<(i64, JobRow)>> {
        let id = id.to_owned();
        self.read(move |tx| batches::jobs_of(tx, &id)).await
    }

    /// Cancels every job of a batch that has not ended. Returns the batch and the identifiers of the jobs that it
    /// cancelled.
    pub async fn cancel_batch(&self, id: &str, owner: Option<&str>) -> Result<(BatchLookup, Vec<String>)> {
        let (id, owner) = owned(id, owner);
        self.write_with(move |tx, options| batches::cancel(tx, &id, owner.as_deref(), options)).await
    }

    /// Removes a batch with its jobs, whatever their status. Returns the identifiers of the jobs, or `None` if the
    /// batch does not exist.
    pub async fn delete_batch(&self, id: &str, owner: Option<&str>) -> Result<Option<Vec<String>>> {
        let (id, owner) = owned(id, owner);
        self.write(move |tx| batches::delete(tx, &id, owner.as_deref())).await
    }
}

/// Callbacks.
impl Store {
    /// Claims a callback that is due, counts an attempt, and keeps it from other claimers for the time `lease`. If the
    /// claimer dies, the callback is due again after the lease. A message may therefore arrive twice, but it is not
    /// lost. Callbacks of `busy` owners and hosts are passed over.
    pub async fn claim_callback(&self, lease: Duration, busy: &Busy) -> Result<Option<Callback>> {
        let (asked, busy) = (busy.clone(), busy.clone());
        if !self.read(move |tx| callbacks::any_due(tx, &asked)).await? {
            return Ok(None);
        }
        self.write(move |tx| callbacks::claim(tx, lease, &busy)).await
    }

    /// Settles a callback that was delivered or is given up. Its URL stays, so that it can be sent again.
    pub async fn settle_callback(&self, callback: &Callback, delivery: Delivery) -> Result<()> {
        let callback = callback.clone();
        self.write(move |tx| callbacks::settle(tx, &callback, delivery)).await
    }

    /// Returns the callback of a job or batch, or `None` if there is no such job or batch.
    pub async fn callback(&self, subject: Subject, id: &str, owner: Option<&str>) -> Result<Option<CallbackRow>> {
        let (id, owner) = owned(id, owner);
        self.read(move |tx| callbacks::find(tx, subject, &id, owner.as_deref())).await
    }

    /// Makes the callback of a job or batch due at once, with all of its attempts if it was settled. A callback that is due
    /// only later, because its job or batch has not ended, stays so. Returns false if there is none.
    pub async fn send_callback_again(&self, subject: Subject, id: &str, owner: Option<&str>) -> Result<bool> {
        let (id, owner) = owned(id, owner);
        self.write(move |tx| callbacks::send_again(tx, subject, &id, owner.as_deref())).await
    }

    /// Makes a callback due again after `pause`, because its attempt failed.
    pub async fn put_off_callback(&self, callback: &Callback, pause: Duration) -> Result<()> {
        let callback = callback.clone();
        self.write(move |tx| callbacks::put_off(tx, &callback, pause)).await
    }
}

/// Retention.
impl Store {
    /// Returns true if this instance shall sweep for all that share the database, because it did so last or because the one
    /// that did has been silent for the time `length`. Without this, every instance would list the whole storage of results.
    pub async fn leads_the_sweep(&self, length: Duration) -> Result<bool> {
        if matches!(self.inner.engine, Engine::Sqlite(_)) {
            return Ok(true);
        }
        let instance = self.inner.instance.clone();
        self.write(move |tx| leaders::take(tx, "sweep", &instance, length)).await
    }

    /// Expires finished jobs whose time is up or that exceed `max_jobs` or four fifths of `max_bytes`. Then deletes the
    /// oldest expired identifiers, removes results without a job and recovers lost leases. Any number of instances may
    /// sweep at once. On a full disk the sweep uses the space of the ballast, and then restores as much of the ballast as
    /// the disk has space for.
    pub async fn sweep(&self) -> Result<Swept> {
        let Engine::Sqlite(database) = &self.inner.engine else { return retention::sweep(self).await };
        if !self.inner.ballast.is_given_up() {
            return retention::sweep(self).await;
        }
        self.inner.ballast.give_up_rest();
        let swept = async {
            // The log is copied first, because its space is then free for what the sweep writes.
            database.cut_log().await?;
            let swept = retention::sweep(self).await?;
            retention::shrink_all(self).await?;
            database.cut_log().await?;
            Ok(swept)
        };
        let swept = swept.await;
        self.inner.ballast.restore();
        swept
    }

    /// Puts jobs whose lease has run out back into the queue, or fails them. A lease that may have run out because of an
    /// outage of the database is left alone until its worker has had time to renew it. Returns the number of jobs that were
    /// recovered, and whether a job waits. Every process calls this more often than half of a lease, because a long pause
    /// looks like an outage.
    pub async fn recover(&self) -> Result<(usize, bool)> {
        self.recover_for(Room::ANY).await
    }

    /// Same as [`Store::recover`], for a worker that looks for jobs for which it has room.
    async fn recover_for(&self, room: Room) -> Result<(usize, bool)> {
        if self.inner.contact.is_broken() {
            self.write(|_| Ok(())).await?;
        }
        let lease_max_ms = milliseconds(self.inner.contact.unbroken());
        let (lost, waiting) = self.read(move |tx| claims::pending_work(tx, lease_max_ms, room)).await?;
        if !lost {
            return Ok((0, waiting));
        }
        let recovered = self.write_with(move |tx, options| claims::recover(tx, lease_max_ms, options)).await?;
        Ok((recovered, waiting))
    }
}

fn owned(id: &str, owner: Option<&str>) -> (String, Option<String>) {
    (id.to_owned(), owner.map(str::to_owned))
}

fn milliseconds(duration: Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX / 4).min(i64::MAX / 4)
}
