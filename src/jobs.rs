//! Jobs: what is submitted, what becomes of it, and the workers that see to it.
//!
//! A job's life: `queued` -> `running` -> `succeeded` | `failed` | `cancelled`; a queued or running job may be cancelled at
//! once, and a running one whose worker died goes back to `queued`. The store makes every transition, in one transaction each;
//! this module decides which.

pub(crate) mod batch;
pub(crate) mod callbacks;
pub(crate) mod converters;
pub(crate) mod events;
pub(crate) mod express;
pub(crate) mod files;
pub(crate) mod memory;
pub mod progress;
pub(crate) mod queue;
pub mod solve;
pub(crate) mod worker;

use crate::config::Config;
use crate::export::archive::Defect;
use crate::export::{Archive, Error as ExportError};
use crate::store::{
    Counts, Filter as StoredFilter, JobRow, JobWatch, Lookup, Status as StoredStatus, Store, StoreError,
};
use crate::telemetry::metric;
use crate::webhook::Sender;
use crate::wire::job::{Job, JobError, JobList, JobSummary, JobWarning, Links, Progress, Status};
use crate::wire::{Kind, Rejection};
use converters::Converters;
use express::Waiting;
use files::{File, Files};
use memory::MemoryBudget;
use progress::Running;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::value::RawValue;
use std::sync::Arc;
use std::time::{Duration, SystemTime};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};

/// Why `jobs` did not do as asked.
#[derive(Debug)]
pub enum JobsError {
    /// The body is not a request that can be worked on.
    Rejected(Rejection),
    /// The queue, or the owner's share of it, is full.
    QueueFull {
        own: bool,
    },
    /// The idempotency key was used with another body.
    KeyConflict,
    NotFound,
    /// There is no such batch, or it is another owner's.
    NoBatch,
    Expired,
    /// The job has not succeeded, or its kind has no such file.
    NoMesh(Status),
    /// Only open ruled surfaces have a flat pattern.
    NoPattern,
    /// More than one file can hold, and what to do instead.
    TooMuch(String),
    /// The mesh cannot be written in the format.
    Unwritable(ExportError),
    /// The store cannot take or give anything now.
    Unavailable(String),
    /// A defect.
    Internal(String),
}

impl From<StoreError> for JobsError {
    fn from(error: StoreError) -> Self {
        match error {
            StoreError::QueueFull { own } => Self::QueueFull { own },
            StoreError::NoSpace(text) | StoreError::Unavailable(text) | StoreError::Contended(text) => {
                tracing::warn!(error = %text, "the store is unavailable");
                Self::Unavailable("the store cannot be reached or is full; try again".into())
            }
            other => {
                tracing::error!(error = %other, "the store failed");
                Self::Internal("the store failed".into())
            }
        }
    }
}

impl From<Defect> for JobsError {
    fn from(defect: Defect) -> Self {
        tracing::error!(error = %defect, "a stored mesh cannot be read");
        Self::Internal("a stored mesh cannot be read".into())
    }
}

/// Which jobs a list shows; all by default.
#[derive(Clone, Debug, Default)]
pub struct Filter {
    pub status: Option<Status>,
    pub kind: Option<Kind>,
    pub idempotency_key: Option<String>,
}

/// More than the process has memory for.
const MOST_UNDER_WAY: u32 = 1 << 24;

/// A handle of the jobs; clones share it.
#[derive(Clone, Debug)]
pub struct Jobs(Arc<Inner>);

#[derive(Debug)]
struct Inner {
    store: Store,
    config: Arc<Config>,
    /// Jobs that run in this process.
    running: Running,
    shutdown: watch::Sender<bool>,
    memory: MemoryBudget,
    converters: Converters,
    /// What conversions made lately.
    files: Files,
    /// One for each solver that may run in this process at once; whoever waits for one gets it in turn.
    slots: Arc<Semaphore>,
    solvers: usize,
    /// Workers and attempts that a shutdown waits for.
    under_way: Arc<Semaphore>,
    waiting: Waiting,
    /// Names this process in attempts.
    process: String,
    /// Who tells callback URLs, if anybody does.
    webhooks: Option<Arc<Sender>>,
}

impl Jobs {
    #[must_use]
    pub fn new(store: Store, config: Arc<Config>, webhooks: Option<Sender>) -> Self {
        let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let solvers = config.jobs.workers.unwrap_or(cores);
        let memory = MemoryBudget::new(config.jobs.memory_bytes);
        let files = Files::new(config.http.files_kept_bytes);
        Self(Arc::new(Inner {
            store,
            config,
            memory,
            files,
            webhooks: webhooks.map(Arc::new),
            slots: Arc::new(Semaphore::new(solvers)),
            solvers,
            under_way: Arc::new(Semaphore::new(MOST_UNDER_WAY as usize)),
            waiting: Waiting::default(),
            process: ulid::Ulid::generate().to_string(),
            running: Running::default(),
            shutdown: watch::Sender::new(false),
            converters: Converters::new(cores.max(2)),
        }))
    }

    /// No new claims from now on; running jobs get the grace time and are then handed back.
    pub fn shut_down(&self) {
        self.0.shutdown.send_replace(true);
    }

    #[must_use]
    pub fn is_shutting_down(&self) -> bool {
        *self.0.shutdown.borrow()
    }

    /// Starts the workers of this process; they end after a shutdown was asked for.
    pub fn spawn_workers(&self) {
        for number in 0..self.0.solvers {
            tokio::spawn(worker::run(self.clone(), format!("{}/{number}", self.0.process)));
        }
    }

    /// How many solvers may run in this process at once.
    #[must_use]
    pub fn solvers(&self) -> usize {
        self.0.solvers
    }

    /// Resolves when a shutdown was asked for and no worker or attempt is left: each has ended or was handed back.
    pub async fn idle(&self) {
        self.shutdown().await;
        // The semaphore is never closed; an error would only say that there is nothing to wait for.
        let _ = self.0.under_way.acquire_many(MOST_UNDER_WAY).await;
    }

    /// Something that a shutdown waits for.
    fn under_way(&self) -> Option<OwnedSemaphorePermit> {
        self.0.under_way.clone().try_acquire_owned().ok()
    }

    /// Resolves once a shutdown was asked for.
    pub async fn shutdown(&self) {
        // The sender lives as long as `self`.
        let _ = self.0.shutdown.subscribe().wait_for(|down| *down).await;
    }

    /// # Errors
    /// [`JobsError::Unavailable`] if the store does not answer.
    pub async fn check_store(&self) -> Result<(), JobsError> {
        if self.0.store.is_full() {
            return Err(JobsError::Unavailable("the store is full".into()));
        }
        Ok(self.0.store.ping().await?)
    }

    /// Whether one more job of this owner would find a place in the queue, so that a body need not be read in vain. The
    /// submission itself decides. True if no job waits at all.
    ///
    /// # Errors
    /// [`JobsError::QueueFull`], or as the store.
    pub async fn check_room(&self, owner: Option<&str>) -> Result<bool, JobsError> {
        Ok(self.0.store.check_room(owner).await?)
    }

    /// # Errors
    /// As the store.
    pub async fn counts(&self) -> Result<Counts, JobsError> {
        Ok(self.0.store.counts().await?)
    }

    /// # Errors
    /// [`JobsError::NotFound`] or [`JobsError::Expired`], else as the store.
    pub async fn get(&self, id: &str, owner: Option<&str>) -> Result<Job, JobsError> {
        self.view(&*found(self.0.store.get(id, owner).await?)?)
    }

    /// The job as it is when it ends, when the wait is over or when a shutdown begins, whichever is first.
    ///
    /// # Errors
    /// As [`Jobs::get`]; [`JobsError::NotFound`] too if the job is deleted meanwhile.
    pub async fn wait(&self, id: &str, owner: Option<&str>, wait: Duration) -> Result<Job, JobsError> {
        let mut watch = self.watch(id, owner).await?;
        tokio::select! {
            ended = watch.ended() => self.view(&*ended.ok_or(JobsError::NotFound)?),
            () = tokio::time::sleep(wait) => self.get(id, owner).await,
            () = self.shutdown() => self.get(id, owner).await,
        }
    }

    /// # Errors
    /// As [`Jobs::get`].
    async fn watch(&self, id: &str, owner: Option<&str>) -> Result<JobWatch, JobsError> {
        self.0.store.watch(id, owner).await?.map_err(|lookup| match lookup {
            Lookup::Expired => JobsError::Expired,
            Lookup::Found(_) | Lookup::Missing => JobsError::NotFound,
        })
    }

    /// One page of an owner's jobs, newest first; of everybody's without an owner.
    ///
    /// # Errors
    /// As the store.
    pub async fn list(
        &self,
        owner: Option<&str>,
        filter: Filter,
        limit: u32,
        cursor: Option<&str>,
    ) -> Result<JobList, JobsError> {
        let filter = StoredFilter {
            owner: owner.map(str::to_owned),
            kind: filter.kind.map(|kind| kind.name().into()),
            status: filter.status.map(stored_status),
            idempotency_key: filter.idempotency_key,
        };
        let (rows, next_cursor) = self.0.store.list(&filter, limit, cursor).await?;
        let jobs = rows.iter().map(|row| self.view(row).map(JobSummary::from)).collect::<Result<_, _>>()?;
        Ok(JobList { jobs, next_cursor })
    }

    /// Cancels a queued or running job at once; any other is returned unchanged.
    ///
    /// # Errors
    /// As [`Jobs::get`].
    pub async fn cancel(&self, id: &str, owner: Option<&str>) -> Result<Job, JobsError> {
        let before = found(self.0.store.get(id, owner).await?)?;
        let job = self.view(&*found(self.0.store.cancel(id, owner).await?)?)?;
        if job.status == Status::Cancelled {
            self.0.running.cancel(id);
            if !before.status.is_final() {
                count_cancelled(job.kind);
            }
        }
        Ok(job)
    }

    /// Cancels a job if needed, and removes it with its mesh.
    ///
    /// # Errors
    /// As [`Jobs::get`].
    pub async fn delete(&self, id: &str, owner: Option<&str>) -> Result<(), JobsError> {
        if self.0.store.delete(id, owner).await? {
            self.0.running.cancel(id);
            return Ok(());
        }
        Err(match self.0.store.get(id, owner).await? {
            Lookup::Expired => JobsError::Expired,
            Lookup::Found(_) | Lookup::Missing => JobsError::NotFound,
        })
    }

    /// A file made from a succeeded job's mesh, off the async threads, a bounded number at once. Files are kept for a while,
    /// so that ranges, revalidations and many readers cost one conversion. `format` names what `convert` does.
    ///
    /// # Errors
    /// As [`Jobs::get`]; [`JobsError::NoMesh`] unless the job has succeeded; what `convert` says.
    pub async fn convert(
        &self,
        id: &str,
        owner: Option<&str>,
        format: &'static str,
        convert: impl FnOnce(&Archive) -> Result<Vec<u8>, JobsError> + Send + 'static,
    ) -> Result<File, JobsError> {
        let row = found(self.0.store.get(id, owner).await?)?;
        let status = status(&row);
        if status != Status::Succeeded {
            return Err(JobsError::NoMesh(status));
        }
        let key = (row.artefact.unwrap_or_default(), format);
        if let Some(file) = self.0.files.get(&key) {
            return Ok(file);
        }
        let place = self.0.converters.place().await?;
        // Somebody else's conversion may have ended while this one waited.
        if let Some(file) = self.0.files.get(&key) {
            return Ok(file);
        }
        let artefact = self.0.store.artefact(id, owner).await?.ok_or(JobsError::NotFound)?;
        let converted = place.run(move || convert(&Archive::from_bytes(&artefact.bytes)?).map(File::new)).await??;
        self.0.files.put(key, converted.clone());
        Ok(converted)
    }

    /// Runs something that computes for more than a moment where it stalls nobody.
    async fn off_runtime<T: Send + 'static>(&self, work: impl FnOnce() -> T + Send + 'static) -> Result<T, JobsError> {
        self.0.converters.place().await?.run(work).await
    }
}

/// Counts a job that was cancelled here.
fn count_cancelled(kind: Kind) {
    metrics::counter!(metric::JOBS, "kind" => kind.name(), "status" => "cancelled").increment(1);
}

fn found(lookup: Lookup) -> Result<Box<JobRow>, JobsError> {
    match lookup {
        Lookup::Found(row) => Ok(row),
        Lookup::Expired => Err(JobsError::Expired),
        Lookup::Missing => Err(JobsError::NotFound),
    }
}

fn status(row: &JobRow) -> Status {
    wire_status(row.status)
}

fn wire_status(status: StoredStatus) -> Status {
    use StoredStatus as Stored;
    match status {
        Stored::Queued => Status::Queued,
        Stored::Running => Status::Running,
        Stored::Succeeded => Status::Succeeded,
        Stored::Failed => Status::Failed,
        Stored::Cancelled => Status::Cancelled,
    }
}

fn stored_status(status: Status) -> StoredStatus {
    use StoredStatus as Stored;
    match status {
        Status::Queued => Stored::Queued,
        Status::Running => Stored::Running,
        Status::Succeeded => Stored::Succeeded,
        Status::Failed => Stored::Failed,
        Status::Cancelled => Stored::Cancelled,
    }
}

impl Jobs {
    /// A row as a client sees it.
    ///
    /// # Errors
    /// [`JobsError::Internal`] if the row holds what this version does not know.
    fn view(&self, row: &JobRow) -> Result<Job, JobsError> {
        view(&self.0.config.http.public_base_path, row)
    }
}

fn view(base: &str, row: &JobRow) -> Result<Job, JobsError> {
    let unreadable = |what: &str| JobsError::Internal(format!("the stored job's {what} cannot be read"));
    let kind = Kind::from_name(&row.kind).ok_or_else(|| unreadable("kind"))?;
    let status = status(row);
    let statistics = row.statistics.as_deref();
    let figures: Option<Figures> = read(statistics).map_err(|()| unreadable("statistics"))?;
    let progress: Option<Progress> = read(row.progress.as_deref()).map_err(|()| unreadable("progress"))?;
    let warnings: Vec<JobWarning> = read(Some(&row.warnings)).map_err(|()| unreadable("warnings"))?.unwrap_or_default();
    let mut error: Option<JobError> = read(row.error.as_deref()).map_err(|()| unreadable("error"))?;
    if let Some(error) = &mut error {
        error.kind.insert_str(0, base);
    }
    let progress = match (status, figures) {
        (Status::Succeeded, Some(figures)) => figures.progress(),
        _ => progress.unwrap_or_else(|| Progress { phase: status.name().into(), ..Progress::default() }),
    };
    Ok(Job {
        links: Links::of(base, &row.id, kind, status),
        id: row.id.clone(),
        kind,
        status,
        created_at: timestamp(row.created_at_ms),
        started_at: row.started_at_ms.map(timestamp),
        finished_at: row.finished_at_ms.map(timestamp),
        expires_at: row.expires_at_ms.map(timestamp),
        progress,
        // Read above, so it is JSON.
        statistics: statistics.and_then(|text| RawValue::from_string(text.to_owned()).ok()),
        warnings,
        error,
    })
}

/// What statistics of any kind say of the way to the result, where they do.
#[derive(Debug, Deserialize)]
struct Figures {
    iterations: Option<u64>,
    objective_value: Option<f64>,
    residual: Option<f64>,
}

impl Figures {
    /// The last word on progress.
    fn progress(&self) -> Progress {
        Progress {
            fraction: 1.0,
            phase: "finished".into(),
            iteration: self.iterations.unwrap_or(0),
            objective_value: self.objective_value,
            residual: self.residual,
        }
    }
}

fn read<T: DeserializeOwned>(text: Option<&str>) -> Result<Option<T>, ()> {
    text.map(|text| serde_json::from_str(text).map_err(|_| ())).transpose()
}

/// Milliseconds since 1970 as RFC 3339 in UTC. Times outside the years 1970 to 9999 become the nearest one inside.
fn timestamp(at_ms: i64) -> String {
    const LAST_MS: u64 = 253_402_300_799_999;
    let since_1970 = Duration::from_millis(u64::try_from(at_ms).unwrap_or(0).min(LAST_MS));
    humantime::format_rfc3339_millis(SystemTime::UNIX_EPOCH + since_1970).to_string()
}

#[cfg(test)]
mod tests {
    use super::timestamp;

    #[test]
    fn timestamps_are_rfc_3339_in_utc_and_stay_within_four_digits_of_year() {
        assert_eq!(timestamp(1_700_000_000_123), "2023-11-14T22:13:20.123Z");
        assert_eq!(timestamp(0), "1970-01-01T00:00:00.000Z");
        assert_eq!(timestamp(-1), "1970-01-01T00:00:00.000Z");
        assert_eq!(timestamp(i64::MAX), "9999-12-31T23:59:59.999Z");
    }
}
