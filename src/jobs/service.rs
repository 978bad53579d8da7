//! Every operation on jobs. Operations that take more than a few lines are implemented in the modules named in the
//! imports.

use super::batch::BatchMeshes;
use super::converters::{Converters, Length, Reservation};
use super::files::{File, Files};
use super::memory::MemoryBudget;
use super::progress::Running;
use super::submission::{self, Accepted, Submitted, Submitter};
use super::{Filter, JobsError, batch, callbacks, view, worker};
use crate::config::Config;
use crate::status::Status;
use crate::store::{Artefact, BatchLookup, BatchRow, Filter as StoredFilter, JobRow, JobWatch, Lookup, Store, Subject};
use crate::telemetry::metric;
use crate::webhook::Sender;
use crate::wire::batch::Batch;
use crate::wire::callback::Callbacks;
use crate::wire::job::{Job, JobList};
use bytes::Bytes;
use plateau_archive::{Archive, Defect};
use plateau_forms::kind::Kind;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};

/// Upper bound of the workers and attempts of one process. Memory runs out long before this number.
const MAX_UNDER_WAY: u32 = 1 << 24;

/// Handle of the job service. Clones share one service.
#[derive(Clone, Debug)]
pub struct Jobs(Arc<Inner>);

#[derive(Debug)]
struct Inner {
    store: Store,
    config: Arc<Config>,
    /// Solvers that run in this process.
    running: Running,
    shutdown: watch::Sender<bool>,
    memory: MemoryBudget,
    converters: Converters,
    /// Files that conversions have made.
    files: Files,
    /// One permit for each solver that may run in this process at once. Permits are given out in the order of requests.
    slots: Arc<Semaphore>,
    solvers: usize,
    /// One permit for each worker and attempt that a shutdown waits for.
    under_way: Arc<Semaphore>,
    /// Name of this process in the records of attempts.
    process: String,
    /// Sender of messages to callback URLs. `None` if webhooks are off.
    webhooks: Option<Arc<Sender>>,
}

/// Start and shutdown.
impl Jobs {
    /// Returns the service, whose workers do not run yet.
    ///
    /// # Errors
    /// Fails if the system cannot start the threads for conversions.
    pub fn new(store: Store, config: Arc<Config>, webhooks: Option<Sender>) -> std::io::Result<Self> {
        let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let solvers = config.jobs.workers.unwrap_or(cores);
        Ok(Self(Arc::new(Inner {
            memory: MemoryBudget::new(config.solver_memory_bytes()),
            files: Files::new(
                config.http.files_kept_bytes,
                config.http.files_disk_bytes,
                vec![config.store.data.clone(), std::env::temp_dir()],
            ),
            store,
            config,
            webhooks: webhooks.map(Arc::new),
            slots: Arc::new(Semaphore::new(solvers)),
            solvers,
            under_way: Arc::new(Semaphore::new(MAX_UNDER_WAY as usize)),
            process: ulid::Ulid::generate().to_string(),
            running: Running::default(),
            shutdown: watch::Sender::new(false),
            converters: Converters::start(cores.max(2))?,
        })))
    }

    /// Starts the workers of this process. They end after a shutdown was asked for.
    pub fn spawn_workers(&self) {
        for number in 0..self.0.solvers {
            tokio::spawn(worker::run(self.clone(), format!("{}/{number}", self.0.process), self.slots(), u64::MAX));
        }
        let slots = Arc::new(Semaphore::new(self.0.config.small_workers()));
        for number in 0..self.0.config.small_workers() {
            let name = format!("{}/small{number}", self.0.process);
            tokio::spawn(worker::run(self.clone(), name, slots.clone(), worker::SMALL_BYTES));
        }
    }

    /// Returns the number of solvers that may run in this process at once.
    #[must_use]
    pub fn solvers(&self) -> usize {
        self.0.solvers
    }

    /// Asks for a shutdown. No job is claimed from now on, and running jobs get the grace time before they are handed
    /// back.
    pub fn shut_down(&self) {
        self.0.shutdown.send_replace(true);
    }

    #[must_use]
    pub fn is_shutting_down(&self) -> bool {
        *self.0.shutdown.borrow()
    }

    /// Waits until a shutdown was asked for.
    pub async fn shutdown(&self) {
        // Waiting cannot fail, because `self` owns the sender.
        let _ = self.0.shutdown.subscribe().wait_for(|down| *down).await;
    }

    /// Waits until a shutdown was asked for and every worker and attempt has ended or was handed back.
    pub async fn idle(&self) {
        self.shutdown().await;
        // Acquiring cannot fail, because the semaphore is never closed.
        let _ = self.0.under_way.acquire_many(MAX_UNDER_WAY).await;
    }
}

/// Health.
impl Jobs {
    /// Checks that the store answers.
    ///
    /// # Errors
    /// Returns [`JobsError::Unavailable`] if the store does not answer, or takes no jobs or no results.
    pub async fn check_store(&self) -> Result<(), JobsError> {
        Ok(self.0.store.check().await?)
    }

    /// Returns the number of jobs that wait.
    ///
    /// # Errors
    /// Returns an error of the store.
    pub async fn queue_length(&self) -> Result<i64, JobsError> {
        Ok(self.0.store.queue_length().await?)
    }
}

/// Submitting.
impl Jobs {
    /// Fails early if the queue has no room for another job of this owner, so that the body need not be read. The
    /// submission checks again and decides.
    ///
    /// # Errors
    /// Returns [`JobsError::QueueFull`] or an error of the store.
    pub async fn check_room(&self, owner: Option<&str>) -> Result<(), JobsError> {
        Ok(self.0.store.check_room(owner).await?)
    }

    /// Reads a body and stores the job. If `waited_for` is true, the client waits for the end, and a small job may be
    /// solved during the submission.
    ///
    /// Returns [`JobsError::Rejected`] with every offending value, [`JobsError::QueueFull`], [`JobsError::KeyConflict`]
    /// or an error of the store.
    pub async fn submit(
        &self,
        kind: Kind,
        body: Bytes,
        from: Submitter,
        waited_for: bool,
    ) -> Result<Accepted, JobsError> {
        submission::job(self, kind, body, from, waited_for).await
    }

    /// Reads a batch's body and stores all of its jobs, or none of them.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::submit`].
    pub async fn submit_batch(&self, body: Bytes, from: Submitter) -> Result<Submitted<Batch>, JobsError> {
        submission::batch(self, body, from).await
    }
}

/// One job.
impl Jobs {
    /// Returns a job.
    ///
    /// # Errors
    /// Returns [`JobsError::NotFound`], [`JobsError::Expired`] or an error of the store.
    pub async fn get(&self, id: &str, owner: Option<&str>) -> Result<Job, JobsError> {
        self.view(&*found(self.0.store.get(id, owner).await?)?)
    }

    /// Waits until the job ends, the wait is over or a shutdown begins, and then returns the job.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`], including [`JobsError::NotFound`] if the job is deleted during the wait.
    pub async fn wait(&self, id: &str, owner: Option<&str>, wait: Duration) -> Result<Job, JobsError> {
        let mut watch = self.watch(id, owner).await?;
        tokio::select! {
            ended = watch.ended() => self.view(&*ended.ok_or(JobsError::NotFound)?),
            () = tokio::time::sleep(wait) => self.get(id, owner).await,
            () = self.shutdown() => self.get(id, owner).await,
        }
    }

    /// Returns a watch that follows the changes of a job.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`].
    pub(super) async fn watch(&self, id: &str, owner: Option<&str>) -> Result<JobWatch, JobsError> {
        self.0.store.watch(id, owner).await?.map_err(|lookup| match lookup {
            Lookup::Expired => JobsError::Expired,
            Lookup::Found(_) | Lookup::Missing => JobsError::NotFound,
        })
    }

    /// Returns one page of an owner's jobs, newest first, or of all jobs if `owner` is `None`. Jobs whose rows cannot
    /// be read are left out and logged.
    ///
    /// # Errors
    /// Returns an error of the store.
    pub async fn list(
        &self,
        owner: Option<&str>,
        filter: Filter,
        limit: u32,
        cursor: Option<&str>,
        with_statistics: bool,
    ) -> Result<JobList, JobsError> {
        let filter = StoredFilter {
            owner: owner.map(str::to_owned),
            kind: filter.kind.map(|kind| kind.name().into()),
            status: filter.status,
            idempotency_key: filter.idempotency_key,
            statistics: with_statistics,
        };
        let (rows, next_cursor) = self.0.store.list(filter, limit, cursor).await?;
        let base = &self.0.config.http.public_base_path;
        let jobs = rows.iter().filter_map(|row| view::listed(base, row)).collect();
        Ok(JobList { jobs, next_cursor })
    }

    /// Returns what became of the message to a job's callback URL.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`].
    pub async fn callbacks(&self, id: &str, owner: Option<&str>) -> Result<Callbacks, JobsError> {
        self.callbacks_of(Subject::Job, id, owner).await
    }

    /// Sends the message to a job's callback URL again, or at once if an attempt is due later. The message of a job that has
    /// not ended is still sent at the end.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`], and [`JobsError::NoCallback`] if the request named no URL.
    pub async fn send_callback_again(&self, id: &str, owner: Option<&str>) -> Result<Callbacks, JobsError> {
        self.send_again(Subject::Job, id, owner).await
    }

    /// Returns what became of the message to a batch's callback URL.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::batch`].
    pub async fn batch_callbacks(&self, id: &str, owner: Option<&str>) -> Result<Callbacks, JobsError> {
        self.callbacks_of(Subject::Batch, id, owner).await
    }

    /// Does for a batch what [`Jobs::send_callback_again`] does for a job.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::batch`], and [`JobsError::NoCallback`] if the request named no URL.
    pub async fn send_batch_callback_again(&self, id: &str, owner: Option<&str>) -> Result<Callbacks, JobsError> {
        self.send_again(Subject::Batch, id, owner).await
    }

    async fn callbacks_of(&self, of: Subject, id: &str, owner: Option<&str>) -> Result<Callbacks, JobsError> {
        match self.0.store.callback(of, id, owner).await? {
            Some(row) => Ok(callbacks::view(row)),
            None => Err(self.missing(of, id, owner).await),
        }
    }

    async fn send_again(&self, of: Subject, id: &str, owner: Option<&str>) -> Result<Callbacks, JobsError> {
        let due = self.0.store.send_callback_again(of, id, owner).await?;
        let callbacks = self.callbacks_of(of, id, owner).await?;
        if due { Ok(callbacks) } else { Err(JobsError::NoCallback) }
    }

    /// Returns the error for a job or batch without a row.
    async fn missing(&self, of: Subject, id: &str, owner: Option<&str>) -> JobsError {
        let found = match of {
            Subject::Job => self.get(id, owner).await.map(drop).and(Err(JobsError::NotFound)),
            Subject::Batch => self.batch(id, owner).await.map(drop).and(Err(JobsError::NoBatch)),
        };
        found.map_or_else(|error| error, |()| JobsError::NotFound)
    }

    /// Cancels a queued or running job at once. Returns a finished job unchanged.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`].
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

    /// Stops the solvers of jobs that a newer job of their series has cancelled, and counts the jobs.
    pub(super) fn superseded(&self, cancelled: &[JobRow]) {
        for job in cancelled {
            self.0.running.cancel(&job.id);
            Kind::from_name(&job.kind).into_iter().for_each(count_cancelled);
        }
    }

    /// Returns a guard that cancels a job when it is dropped, unless it was told to keep the job.
    #[must_use]
    pub fn cancel_on_drop(&self, id: &str, owner: Option<&str>) -> CancelOnDrop {
        CancelOnDrop { jobs: self.clone(), job: Some((id.to_owned(), owner.map(str::to_owned))) }
    }

    /// Cancels a job if needed, and removes it with its mesh.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`].
    pub async fn delete(&self, id: &str, owner: Option<&str>) -> Result<(), JobsError> {
        if self.0.store.delete(id, owner).await? {
            self.0.running.cancel(id);
            return Ok(());
        }
        found(self.0.store.get(id, owner).await?).and(Err(JobsError::NotFound))
    }

    /// Returns a file made from a succeeded job's mesh. The conversion runs outside the async threads, and the number
    /// of conversions at once is limited. Files are cached, so that range requests, revalidations and many readers cost
    /// one conversion. `format` identifies what `convert` does.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`] and of `convert`, [`JobsError::NoMesh`] unless the job has succeeded, and
    /// [`JobsError::Lost`] if its mesh was damaged.
    pub async fn convert(
        &self,
        id: &str,
        owner: Option<&str>,
        format: impl Into<String> + Send,
        convert: impl FnOnce(&Archive) -> Result<Vec<u8>, JobsError> + Send + 'static,
    ) -> Result<File, JobsError> {
        let row = found(self.0.store.get(id, owner).await?)?;
        if row.status != Status::Succeeded {
            return Err(JobsError::NoMesh(row.status));
        }
        let key = (row.artefact.unwrap_or_default(), format.into());
        if let Some(file) = self.0.files.get(&key) {
            return Ok(file);
        }
        let thread = self.reserve_converter(owner, length(row.statistics.as_deref())).await?;
        // Another conversion may have made the file while this one waited.
        if let Some(file) = self.0.files.get(&key) {
            return Ok(file);
        }
        let artefact = self.0.store.artefact(id, owner).await?.ok_or(JobsError::Lost)?;
        let service = self.clone();
        let run = move || match Archive::from_bytes(&artefact.bytes) {
            Ok(archive) => Ok(convert(&archive).and_then(|bytes| service.files().file(bytes))),
            Err(defect) => Err((defect, artefact)),
        };
        let file = match thread.run(run).await? {
            Ok(converted) => converted?,
            Err((defect, artefact)) => return Err(self.unreadable(&defect, &artefact).await),
        };
        metrics::counter!(metric::CONVERSIONS).increment(1);
        self.0.files.put(key, file.clone());
        Ok(file)
    }
}

/// Batches.
impl Jobs {
    /// Returns a batch.
    ///
    /// # Errors
    /// Returns [`JobsError::NoBatch`], [`JobsError::Expired`] or an error of the store.
    pub async fn batch(&self, id: &str, owner: Option<&str>) -> Result<Batch, JobsError> {
        self.view_batch(&found_batch(self.0.store.batch(id, owner).await?)?)
    }

    /// Waits until the last job of the batch ends, the wait is over or a shutdown begins, and then returns the batch.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::batch`].
    pub async fn wait_for_batch(&self, id: &str, owner: Option<&str>, wait: Duration) -> Result<Batch, JobsError> {
        let row = found_batch(self.0.store.batch(id, owner).await?)?;
        let all = async {
            for job in row.jobs.iter().filter(|job| !job.status.is_final()) {
                // The wait skips jobs that were deleted meanwhile.
                if let Ok(mut watch) = self.watch(&job.id, owner).await {
                    watch.ended().await;
                }
            }
        };
        tokio::select! {
            () = all => {}
            () = tokio::time::sleep(wait) => {}
            () = self.shutdown() => {}
        }
        self.batch(id, owner).await
    }

    /// Cancels every job of a batch that has not ended.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::batch`].
    pub async fn cancel_batch(&self, id: &str, owner: Option<&str>) -> Result<Batch, JobsError> {
        let (lookup, cancelled) = self.0.store.cancel_batch(id, owner).await?;
        cancelled.iter().for_each(|id| self.0.running.cancel(id));
        let batch = self.view_batch(&found_batch(lookup)?)?;
        let cancelled_now = batch.jobs.iter().filter(|job| cancelled.contains(&job.id));
        cancelled_now.for_each(|job| count_cancelled(job.kind));
        Ok(batch)
    }

    /// Removes a batch with its jobs and their meshes.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::batch`].
    pub async fn delete_batch(&self, id: &str, owner: Option<&str>) -> Result<(), JobsError> {
        if let Some(jobs) = self.0.store.delete_batch(id, owner).await? {
            jobs.iter().for_each(|id| self.0.running.cancel(id));
            return Ok(());
        }
        found_batch(self.0.store.batch(id, owner).await?).and(Err(JobsError::NoBatch))
    }

    /// Returns every mesh of a batch that has ended, ready to be put into one file.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::batch`], and [`JobsError::NoMesh`] unless every job has ended and at least one has
    /// succeeded.
    pub async fn batch_meshes(&self, id: &str, owner: Option<&str>) -> Result<BatchMeshes, JobsError> {
        let row = found_batch(self.0.store.batch(id, owner).await?)?;
        batch::meshes(self, &row).await
    }
}

/// Access for the other modules of `jobs`.
impl Jobs {
    pub(super) fn store(&self) -> &Store {
        &self.0.store
    }

    pub(super) fn config(&self) -> &Config {
        &self.0.config
    }

    pub(super) fn running(&self) -> &Running {
        &self.0.running
    }

    pub(super) fn memory(&self) -> &MemoryBudget {
        &self.0.memory
    }

    pub(super) fn files(&self) -> &Files {
        &self.0.files
    }

    pub(super) fn slots(&self) -> Arc<Semaphore> {
        self.0.slots.clone()
    }

    pub(super) fn webhooks(&self) -> Option<&Arc<Sender>> {
        self.0.webhooks.as_ref()
    }

    /// Returns a permit that makes a shutdown wait until it is dropped.
    pub(super) fn under_way(&self) -> Option<OwnedSemaphorePermit> {
        self.0.under_way.clone().try_acquire_owned().ok()
    }

    /// Returns a row in the form that clients see.
    ///
    /// # Errors
    /// Returns [`JobsError::Internal`] if this version cannot read the row.
    pub(super) fn view(&self, row: &JobRow) -> Result<Job, JobsError> {
        view::job(&self.0.config.http.public_base_path, row)
    }

    fn view_batch(&self, row: &BatchRow) -> Result<Batch, JobsError> {
        view::batch(&self.0.config.http.public_base_path, row)
    }

    /// Waits for a converter's thread and reserves it.
    pub(super) async fn reserve_converter(
        &self,
        owner: Option<&str>,
        length: Length,
    ) -> Result<Reservation<'_>, JobsError> {
        self.0.converters.reserve(owner, length).await
    }

    /// Runs a computation of some tenths of a second at most on a converter's thread, so that it does not stall the async
    /// runtime.
    pub async fn off_runtime<T: Send + 'static>(
        &self,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<T, JobsError> {
        self.reserve_converter(None, Length::Short).await?.run(work).await
    }

    /// Returns the error for a stored mesh that cannot be read. If the mesh is damaged, it is removed, so that the next
    /// equal request is solved again instead of reusing it.
    pub(super) async fn unreadable(&self, defect: &Defect, artefact: &Artefact) -> JobsError {
        tracing::error!(error = %defect, "a stored mesh cannot be read");
        if !matches!(defect, Defect::Magic | Defect::Checksum) {
            return JobsError::Internal("a stored mesh cannot be read".into());
        }
        match self.0.store.discard(artefact).await {
            Ok(()) => JobsError::Lost,
            Err(error) => error.into(),
        }
    }
}

/// Cancels a job when it is dropped.
#[derive(Debug)]
pub struct CancelOnDrop {
    jobs: Jobs,
    job: Option<(String, Option<String>)>,
}

impl CancelOnDrop {
    /// Keeps the job.
    pub fn keep(mut self) {
        self.job = None;
    }
}

impl Drop for CancelOnDrop {
    fn drop(&mut self) {
        let Some((id, owner)) = self.job.take() else { return };
        let jobs = self.jobs.clone();
        tokio::spawn(async move {
            if let Err(error) = jobs.cancel(&id, owner.as_deref()).await {
                tracing::warn!(?error, job_id = id, "a job whose client went away was not cancelled");
            }
        });
    }
}

/// Returns how long converting a mesh with these statistics takes.
fn length(statistics: Option<&str>) -> Length {
    /// Largest number of triangles of a mesh that is converted in some tenths of a second.
    const SHORT_TRIANGLES: u64 = 20_000;
    #[derive(serde::Deserialize)]
    struct Size {
        triangles: Option<u64>,
    }
    let size = statistics.and_then(|text| serde_json::from_str::<Size>(text).ok());
    match size.and_then(|size| size.triangles) {
        Some(triangles) if triangles > SHORT_TRIANGLES => Length::Long,
        _ => Length::Short,
    }
}

/// Counts a job that this process has cancelled.
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

fn found_batch(lookup: BatchLookup) -> Result<BatchRow, JobsError> {
    match lookup {
        BatchLookup::Found(row) => Ok(row),
        BatchLookup::Expired => Err(JobsError::Expired),
        BatchLookup::Missing => Err(JobsError::NoBatch),
    }
}
