//! The handle of a store: opening, closing, health, and the two ways to run a transaction.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use tokio::sync::watch as signal;

use super::ballast::Ballast;
use super::changes::Changes;
use super::engine::Engine;
use super::files::ResultStorage;
use super::jobs::{self, Outcome};
use super::outage::OutageTracker;
use super::results::{self, Prepared};
use super::session::Server;
use super::tx::{AfterCommit, Tx};
use super::{Result, StoreError, StoreOptions, leaders, postgres, sqlite};

/// Time for which a successful write shows that the database takes writes.
const PROVEN: Duration = Duration::from_secs(2);

const URL_FORMS: &str = "expected sqlite://PATH or postgres://USER@HOST/DATABASE";

/// Handle of a store. Clones share one store.
#[derive(Debug, Clone)]
pub struct Store {
    pub(super) inner: Arc<Inner>,
}

#[derive(Debug)]
pub(super) struct Inner {
    pub(super) engine: Engine,
    pub(super) options: Arc<StoreOptions>,
    pub(super) changes: Changes,
    pub(super) files: Option<ResultStorage>,
    pub(super) ballast: Ballast,
    pub(super) contact: OutageTracker,
    /// Name of this instance among those that share the database.
    pub(super) instance: String,
    /// True if the last write found no space.
    pub(super) full: AtomicBool,
    /// True if the last result file could not be written.
    pub(super) results_refused: AtomicBool,
    /// True if the last submission failed because of the database.
    pub(super) submissions_refused: AtomicBool,
    /// Time of the last successful write.
    written_at: Mutex<Instant>,
    /// Held while a write is tried for [`Store::check`], so that many checks at once try one.
    probing: tokio::sync::Mutex<()>,
}

/// Opening, closing and health.
impl Store {
    /// Opens `sqlite://PATH` (created if missing) or `postgres://USER@HOST/DATABASE` and migrates its tables. Must be
    /// called inside a tokio runtime, which then also runs the store's own tasks.
    pub async fn open(url: &str, options: StoreOptions) -> Result<Self> {
        let files = options.results.as_deref().map(ResultStorage::open).transpose()?;
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
        let contact = OutageTracker::new(options.lease, !is_postgres);
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
                submissions_refused: AtomicBool::new(false),
                written_at: Mutex::new(Instant::now()),
                probing: tokio::sync::Mutex::default(),
            }),
        };
        store.probe_results().await;
        Ok(store)
    }

    /// Checks the form of a database's URL and of the place of its results (empty for the default). It connects to
    /// neither of them.
    pub fn check_places(url: &str, results: &str) -> Result<()> {
        if url.starts_with("postgres://") || url.starts_with("postgresql://") {
            Server::at(url)?;
        } else if url.starts_with("sqlite:") {
            let path = sqlite::path(url)?;
            let above = path.ancestors().skip(1).find(|folder| folder.exists());
            if let Some(file) = above.filter(|above| !above.is_dir()) {
                return Err(StoreError::Url(format!("{} is not a folder", file.display())));
            }
        } else {
            return Err(StoreError::Url(URL_FORMS.into()));
        }
        ResultStorage::check(results)
    }

    /// Waits for running writes, then closes every connection. Later calls fail with `Unavailable`.
    pub async fn close(&self) {
        match &self.inner.engine {
            Engine::Sqlite(database) => database.close().await,
            Engine::Postgres(database) => {
                let instance = self.inner.instance.clone();
                // If this fails, another instance takes over the tasks of this instance when its hold on them expires.
                let _ = self.write(move |tx| leaders::leave(tx, &instance)).await;
                database.close().await;
            }
        }
    }

    /// Returns `Ok` if the database answers and takes new jobs and results. If nothing was written lately, tries a
    /// write. After a submission that the database did not take, tries to store a job and takes it back.
    pub async fn check(&self) -> Result<()> {
        self.read(|tx| tx.exists("SELECT 1", &[])).await?;
        if let Engine::Sqlite(database) = &self.inner.engine {
            database.check_writer()?;
        }
        self.check_room_for_results()?;
        let _alone = self.inner.probing.lock().await;
        if self.inner.submissions_refused.load(Ordering::Relaxed) {
            let probed = self.write_with(jobs::probe).await;
            self.note_submission(&probed);
            probed
        } else if self.inner.contact.is_broken() || self.written_ago() > PROVEN {
            self.write_row().await
        } else {
            Ok(())
        }
    }

    /// Writes a row of its own, to test whether the database takes writes. A transaction without a change would not
    /// reach the disk.
    pub(super) async fn write_row(&self) -> Result<()> {
        let instance = self.inner.instance.clone();
        self.write(move |tx| leaders::take(tx, "probe", &instance, Duration::ZERO).map(drop)).await
    }

    fn written_ago(&self) -> Duration {
        self.inner.written_at.lock().unwrap_or_else(PoisonError::into_inner).elapsed()
    }

    /// Notes whether the database took a submission.
    pub(super) fn note_submission<T>(&self, submitted: &Result<T>) {
        match submitted {
            Ok(_) => self.inner.submissions_refused.store(false, Ordering::Relaxed),
            Err(StoreError::QueueFull { .. } | StoreError::Contended(_)) => {}
            Err(_) => self.inner.submissions_refused.store(true, Ordering::Relaxed),
        }
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

    pub(super) fn changes(&self) -> &Changes {
        &self.inner.changes
    }

    pub(super) fn files(&self) -> Option<&ResultStorage> {
        self.inner.files.as_ref()
    }

    /// Runs `work` in a transaction. If this returns `Ok`, all of it is durable; if it returns an error, none of it
    /// happened. The exception is a connection lost during the commit, after which the outcome is unknown. `work` may
    /// run more than once, so it must not act outside the database.
    pub(super) async fn write<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let written = match &self.inner.engine {
            Engine::Sqlite(database) => database.write(work).await,
            Engine::Postgres(database) => database.write(work).await,
        };
        self.inner.contact.note(&written, true);
        match &written {
            Ok(_) => {
                self.inner.full.store(false, Ordering::Relaxed);
                *self.inner.written_at.lock().unwrap_or_else(PoisonError::into_inner) = Instant::now();
            }
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
    pub(super) async fn read<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let read = match &self.inner.engine {
            Engine::Sqlite(database) => database.read(work).await,
            Engine::Postgres(database) => database.read(work).await,
        };
        self.inner.contact.note(&read, false);
        read
    }

    /// Same as [`Store::write`], for work that also needs the options.
    pub(super) async fn write_with<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>, &StoreOptions) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let options = Arc::clone(&self.inner.options);
        self.write(move |tx| work(tx, &options)).await
    }

    /// Fails while the ballast is given up, so that new jobs do not take the space that accepted jobs need.
    pub(super) fn check_ballast(&self) -> Result<()> {
        if self.inner.ballast.is_given_up() {
            return Err(StoreError::NoSpace("the disk is full".into()));
        }
        Ok(())
    }

    /// Computes the name of a successful result. Writes the result to a file if it is too large for the database.
    pub(super) async fn prepare(&self, id: &str, attempt: i64, outcome: &Outcome) -> Result<Option<Prepared>> {
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
