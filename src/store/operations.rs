//! Every operation of the store. Each method runs a function of another module (`jobs`, `claims`, `batches`, ...) in a
//! transaction.

use std::sync::Arc;
use std::time::Duration;

use super::batches::{BatchAddition, BatchLookup, NewBatch};
use super::callbacks::{Busy, Callback, CallbackRow, Delivery, Subject};
use super::claims::{Claimed, Renewed, Room};
use super::engine::Engine;
use super::handle::Store;
use super::jobs::{Addition, EarlyEnd, Filter, JobRow, Lookup, NewJob, Outcome};
use super::queue::{Preference, WaitingOwner};
use super::results::{Artefact, ResultRow};
use super::retention::Swept;
use super::tx::Tx;
use super::{
    Result, StoreError, StoreOptions, batches, callbacks, claims, jobs, leaders, milliseconds, owned, queue, results,
    retention,
};
use crate::status::CancelReason;

/// Jobs.
impl Store {
    /// Fails with `QueueFull` if the queue has no room for another job of this owner.
    pub async fn check_room(&self, owner: Option<&str>) -> Result<()> {
        let (options, owner) = (Arc::clone(&self.inner.options), owner.map(str::to_owned));
        self.read(move |tx| queue::check_room(tx, owner.as_deref(), &options)).await
    }

    /// Stores a job, and cancels the older jobs of its series in the same transaction. Fails with `QueueFull` if the
    /// queue or the owner's share of it is full. A job that reuses a kept result is exempt.
    pub async fn add_job(&self, job: NewJob) -> Result<Addition> {
        self.check_ballast()?;
        self.submit(move |tx, options| jobs::add(tx, &job, None, None, options)).await
    }

    /// Stores a job that this process has already solved. Submission and end are one write, so they become visible
    /// together.
    pub async fn add_ended_job(&self, job: NewJob, solved: EarlyEnd) -> Result<Addition> {
        self.check_ballast()?;
        let result = self.prepare(&job.id, 1, &solved.outcome).await?;
        let submit = move |tx: &mut Tx<'_>, options: &StoreOptions| {
            jobs::add(tx, &job, None, Some((&solved, result.as_ref())), options)
        };
        self.submit(submit).await
    }

    /// Runs a write that stores jobs, and notes whether the database took them.
    async fn submit<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>, &StoreOptions) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let submitted = self.write_with(work).await;
        self.note_submission(&submitted);
        submitted
    }

    /// Returns what [`Store::add_job`] would return for a repeated idempotency key, or `None` for a new one.
    pub async fn earlier_job(
        &self,
        owner: Option<&str>,
        kind: &'static str,
        key: &str,
        body_hash: [u8; 32],
    ) -> Result<Option<Addition>> {
        let (key, owner) = owned(key, owner);
        self.read(move |tx| jobs::earlier_job(tx, owner.as_deref(), kind, &key, &body_hash)).await
    }

    pub async fn get(&self, id: &str, owner: Option<&str>) -> Result<Lookup> {
        let (id, owner) = owned(id, owner);
        self.read(move |tx| jobs::get(tx, &id, owner.as_deref())).await
    }

    /// Returns the kind and the request of a job, or `None` if there is no such job or its request is not kept.
    pub async fn request(&self, id: &str, owner: Option<&str>) -> Result<Option<(String, Vec<u8>)>> {
        let (id, owner) = owned(id, owner);
        self.read(move |tx| jobs::request(tx, &id, owner.as_deref())).await
    }

    /// Returns at most `page` jobs, newest first, and the cursor of the next page if there is one. A cursor is the last
    /// identifier of the previous page, so jobs that come or go between pages neither repeat nor hide others.
    pub async fn list(&self, filter: Filter, page: u32, cursor: Option<&str>) -> Result<(Vec<JobRow>, Option<String>)> {
        let cursor = cursor.map(str::to_owned);
        self.read(move |tx| jobs::list(tx, &filter, page, cursor.as_deref())).await
    }

    /// Cancels a queued or running job at once. Returns a finished job unchanged. The worker learns of the cancel by
    /// its next renewal or by watching the job.
    pub async fn cancel(&self, id: &str, owner: Option<&str>, because: CancelReason) -> Result<Lookup> {
        let (id, owner) = owned(id, owner);
        self.write_with(move |tx, options| jobs::cancel(tx, &id, owner.as_deref(), because, options)).await
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

    /// Returns the result with this name. Returns `None` for a result that was removed or discarded.
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
    /// Claims, for the time `lease`, the job whose turn it is. Returns `None` if no job waits. Jobs whose lease ran out
    /// go back to the queue first.
    pub async fn claim(&self, worker: &str, lease: Duration) -> Result<Option<Claimed>> {
        self.claim_within(worker, lease, Room::ANY, Preference::default()).await
    }

    /// Same as [`Store::claim`], for a worker whose memory is limited to `room` and that has a preference. If the first
    /// job in the queue does not fit into the free memory, a limited number of jobs may overtake it. Then nothing is
    /// claimed until that job fits.
    pub async fn claim_within(
        &self,
        worker: &str,
        lease: Duration,
        room: Room,
        preference: Preference,
    ) -> Result<Option<Claimed>> {
        // Idle workers only read, because SQLite has one writer.
        let (recovered, waiting) = self.recover_for(room, preference.clone()).await?;
        if recovered == 0 && !waiting {
            return Ok(None);
        }
        let worker = worker.to_owned();
        self.write(move |tx| claims::claim(tx, &worker, lease, room, &preference)).await
    }

    /// Returns the running job that was claimed under the name `worker`, with a new lease, or `None`. A worker calls
    /// this after a failed claim, because the claim may be committed although the answer was lost. Each claim needs its
    /// own name.
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

    /// Ends the attempt. The outcome and the new status become visible together. Returns true also if an earlier call
    /// has already stored this outcome, so that a worker may repeat a call whose answer was lost. If the worker had
    /// lost the job, changes nothing and returns false.
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

/// Sharing of the workers.
impl Store {
    /// Same as [`Store::hand_back`], for a job whose request the worker's version cannot read. If no other worker can
    /// read it within [`StoreOptions::unread_patience`], the job fails with `error` (JSON text).
    pub async fn hand_back_unread(&self, id: &str, attempt: i64, error: &str) -> Result<bool> {
        let (id, error) = (id.to_owned(), error.to_owned());
        self.write(move |tx| claims::hand_back_unread(tx, &id, attempt, &error)).await
    }

    /// Returns the owners with jobs that were submitted at least `age` ago and wait.
    pub async fn waiting_owners(&self, age: Duration) -> Result<Vec<WaitingOwner>> {
        self.read(move |tx| queue::waiting_owners(tx, age)).await
    }
}

/// Batches.
impl Store {
    /// Stores a batch as a whole. Fails with `QueueFull` if the queue has no room for all of its jobs.
    pub async fn add_batch(&self, batch: NewBatch) -> Result<BatchAddition> {
        self.check_ballast()?;
        self.submit(move |tx, options| batches::add(tx, &batch, options)).await
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

    /// Settles a callback that was delivered or is given up. The URL stays, so that the message can be sent again.
    pub async fn settle_callback(&self, callback: &Callback, delivery: Delivery) -> Result<()> {
        let callback = callback.clone();
        self.write(move |tx| callbacks::settle(tx, &callback, delivery)).await
    }

    /// Returns the callback of a job or batch, or `None` if there is no such job or batch.
    pub async fn callback(&self, subject: Subject, id: &str, owner: Option<&str>) -> Result<Option<CallbackRow>> {
        let (id, owner) = owned(id, owner);
        self.read(move |tx| callbacks::find(tx, subject, &id, owner.as_deref())).await
    }

    /// Makes the callback of a job or batch due at once. A settled callback gets all of its attempts again. The
    /// callback of a job or batch that has not ended is still sent only after the end. Returns false if there is no
    /// callback.
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
    /// Returns true if this instance must sweep the database that several instances share: it swept last, or the
    /// instance that swept last has been silent for `length`. Only one instance sweeps, because a sweep lists the whole
    /// storage of results.
    pub async fn leads_the_sweep(&self, length: Duration) -> Result<bool> {
        if matches!(self.inner.engine, Engine::Sqlite(_)) {
            return Ok(true);
        }
        let instance = self.inner.instance.clone();
        self.write(move |tx| leaders::take(tx, "sweep", &instance, length)).await
    }

    /// Expires finished jobs whose time is up or that exceed `max_jobs` or four fifths of `max_bytes`. Then deletes the
    /// oldest expired identifiers, removes results without a job and recovers lost leases. Any number of instances may
    /// sweep at once. On a full disk the sweep uses the space of the ballast, and then restores as much of the ballast
    /// as the disk has space for.
    pub async fn sweep(&self) -> Result<Swept> {
        let Engine::Sqlite(database) = &self.inner.engine else { return self.sweep_once().await };
        if !self.inner.ballast.is_given_up() {
            return self.sweep_once().await;
        }
        self.inner.ballast.give_up_rest();
        let swept = async {
            // The log is copied first, because its space is then free for what the sweep writes.
            database.cut_log().await?;
            let swept = self.sweep_once().await?;
            retention::shrink_all(self).await?;
            database.cut_log().await?;
            Ok(swept)
        };
        let swept = swept.await;
        self.inner.ballast.restore();
        swept
    }

    async fn sweep_once(&self) -> Result<Swept> {
        let recovered = self.recover().await?.0;
        retention::sweep(self, recovered).await
    }

    /// Puts jobs whose lease has run out back into the queue, or fails them. Fails jobs that no worker could read for
    /// too long. A lease that may have run out because of
    /// an outage of the database is left alone until its worker has had time to renew it. Returns the number of jobs
    /// that were recovered, and whether a job waits. Every process calls this more often than half of a lease, because
    /// a long pause looks like an outage.
    pub async fn recover(&self) -> Result<(usize, bool)> {
        self.recover_for(Room::ANY, Preference::default()).await
    }

    /// Same as [`Store::recover`], but the second value says whether a job waits that fits into `room` and is not left
    /// out by the preference.
    async fn recover_for(&self, room: Room, preference: Preference) -> Result<(usize, bool)> {
        if self.inner.contact.is_broken() {
            self.write_row().await?;
        }
        let lease_max_ms = milliseconds(self.inner.contact.unbroken());
        let options = Arc::clone(&self.inner.options);
        let pending = move |tx: &mut Tx<'_>| claims::pending_work(tx, lease_max_ms, room, &preference, &options);
        let (lost, waiting) = self.read(pending).await?;
        if !lost {
            return Ok((0, waiting));
        }
        let outage_ms = self.inner.contact.since_outage().map(milliseconds);
        let recovered =
            self.write_with(move |tx, options| claims::recover(tx, lease_max_ms, outage_ms, options)).await?;
        recovered.failed.iter().for_each(self.inner.options.note_failed);
        Ok((recovered.jobs, waiting))
    }
}
