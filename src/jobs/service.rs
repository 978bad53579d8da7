//! Every operation on jobs. Operations that take more than a few lines are implemented in the modules named in the
//! imports.

use super::batch::BatchMeshes;
use super::handle::count_cancelled;
use super::reading::{found, found_batch};
use super::{Jobs, JobsError, Selection, batch, callbacks, view, worker};
use crate::status::{CancelReason, Status};
use crate::store::{Filter, Subject};
use crate::wire::batch::Batch;
use crate::wire::callback::Callbacks;
use crate::wire::job::{Job, JobList};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;

/// Start of the workers.
impl Jobs {
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

    /// Adds the child processes to the metrics of this process.
    pub fn note_usage_of_children(&self) {
        self.children().note_usage();
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
}

/// Operations on a single job.
impl Jobs {
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

    /// Returns one page of an owner's jobs, newest first, or of all jobs if `owner` is `None`. Jobs whose rows cannot
    /// be read are left out and logged.
    ///
    /// # Errors
    /// Returns an error of the store.
    pub async fn list(
        &self,
        owner: Option<&str>,
        selection: Selection,
        limit: u32,
        cursor: Option<&str>,
        with_statistics: bool,
    ) -> Result<JobList, JobsError> {
        let filter = Filter {
            owner: owner.map(str::to_owned),
            kind: selection.kind.map(|kind| kind.name().into()),
            statuses: selection.statuses,
            idempotency_key: selection.idempotency_key,
            label: selection.label,
            batch: selection.batch,
            created_after_ms: selection.created_after_ms,
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

    /// Sends the message to a job's callback URL again, or at once if an attempt is due later. The message of a job
    /// that has not ended is still sent at the end.
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
    pub async fn cancel(&self, id: &str, owner: Option<&str>, because: CancelReason) -> Result<Job, JobsError> {
        let before = found(self.0.store.get(id, owner).await?)?;
        let job = self.view(&*found(self.0.store.cancel(id, owner, because).await?)?)?;
        if job.status == Status::Cancelled {
            self.0.running.cancel(id);
            if !before.status.is_final() {
                count_cancelled(job.kind.name());
            }
        }
        Ok(job)
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
}

/// Batches.
impl Jobs {
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
        let batch = self.view_batch(&found_batch(lookup)?);
        let cancelled_now = batch.jobs.iter().filter(|job| cancelled.contains(&job.id));
        cancelled_now.for_each(|job| count_cancelled(job.kind.name()));
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
            if let Err(error) = jobs.cancel(&id, owner.as_deref(), CancelReason::Disconnected).await {
                tracing::warn!(?error, job_id = id, "a job whose client went away was not cancelled");
            }
        });
    }
}
