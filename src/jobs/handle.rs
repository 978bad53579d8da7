//! The handle of the job service: its start, its shutdown, and what its modules share.

use super::children::Children;
use super::converters::{Converters, Length};
use super::files::FileCache;
use super::memory::MemoryBudget;
use super::shares::Running;
use super::{JobsError, view};
use crate::config::Config;
use crate::store::{BatchRow, Claimed, JobRow, Store};
use crate::telemetry::metric;
use crate::webhook::Sender;
use crate::wire::batch::Batch;
use crate::wire::job::Job;
use std::collections::VecDeque;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};

/// Upper bound of the workers and attempts of one process. Memory runs out long before this number.
const MAX_UNDER_WAY: u32 = 1 << 24;

/// Number of jobs that this process could not read and remembers. It is as large as the default length of the queue.
const MAX_UNREAD: usize = 1000;

/// Handle of the job service. Clones share one service.
#[derive(Clone, Debug)]
pub struct Jobs(pub(super) Arc<Inner>);

#[derive(Debug)]
pub(super) struct Inner {
    pub(super) store: Store,
    pub(super) config: Arc<Config>,
    /// Solvers that run in this process.
    pub(super) running: Running,
    /// Jobs whose requests this process could not read.
    unread: Mutex<VecDeque<String>>,
    pub(super) shutdown: watch::Sender<bool>,
    pub(super) memory: MemoryBudget,
    pub(super) converters: Converters,
    /// Cache of the files that conversions have made.
    pub(super) files: FileCache,
    /// Permits of the solvers that may run in this process at once. They are given out in the order of requests.
    pub(super) slots: Arc<Semaphore>,
    pub(super) solvers: usize,
    /// Number of solvers that were given up because they did not answer, and that have not ended since.
    pub(super) unresponsive: AtomicUsize,
    /// Slots that solvers keep after they were given up.
    kept_slots: Mutex<Vec<OwnedSemaphorePermit>>,
    children: Children,
    /// Permits of the workers and attempts that a shutdown waits for.
    pub(super) under_way: Arc<Semaphore>,
    /// Name of this process in the records of attempts.
    pub(super) process: String,
    /// Sender of messages to callback URLs. `None` if webhooks are off.
    pub(super) webhooks: Option<Arc<Sender>>,
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
            files: FileCache::new(
                config.http.files_kept_bytes,
                config.http.files_disk_bytes,
                vec![config.store.data.clone(), std::env::temp_dir()],
            ),
            store,
            config,
            webhooks: webhooks.map(Arc::new),
            slots: Arc::new(Semaphore::new(solvers)),
            solvers,
            unresponsive: AtomicUsize::new(0),
            kept_slots: Mutex::default(),
            children: Children::new(),
            under_way: Arc::new(Semaphore::new(MAX_UNDER_WAY as usize)),
            process: ulid::Ulid::generate().to_string(),
            running: Running::default(),
            unread: Mutex::default(),
            shutdown: watch::Sender::new(false),
            converters: Converters::start(cores.max(2))?,
        })))
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

    /// Returns the number of solvers that were given up because they did not answer, and that have not ended since.
    #[must_use]
    pub fn unresponsive(&self) -> usize {
        self.0.unresponsive.load(Ordering::Relaxed)
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

/// Access for the other modules of `jobs`.
impl Jobs {
    /// Stops the solvers of jobs that a newer job of their series has cancelled, and counts the jobs.
    pub(super) fn superseded(&self, cancelled: &[JobRow]) {
        for job in cancelled {
            self.0.running.cancel(&job.id);
            count_cancelled(&job.kind);
        }
    }

    pub(super) fn store(&self) -> &Store {
        &self.0.store
    }

    pub(super) fn config(&self) -> &Config {
        &self.0.config
    }

    pub(super) fn running(&self) -> &Running {
        &self.0.running
    }

    /// Returns the jobs whose requests this process could not read.
    pub(super) fn unread(&self) -> Vec<String> {
        self.0.unread.lock().unwrap_or_else(PoisonError::into_inner).iter().cloned().collect()
    }

    /// Remembers a job whose request this process cannot read, so that it does not claim the job again.
    pub(super) fn cannot_read(&self, id: &str) {
        let mut unread = self.0.unread.lock().unwrap_or_else(PoisonError::into_inner);
        if unread.len() == MAX_UNREAD {
            unread.pop_front();
        }
        unread.push_back(id.to_owned());
    }

    /// Returns true if the job is to be solved in a child process. Large jobs are, and so are jobs whose earlier
    /// attempt did not end, because it may have ended its process. After too many threads were given up, every job is.
    pub(super) fn solves_in_a_child(&self, job: &Claimed) -> bool {
        let is_risky = job.memory_bytes > self.0.config.jobs.thread_bytes || job.attempt > 1;
        self.0.children.possible && (is_risky || self.has_too_many_unresponsive())
    }

    pub(super) fn children(&self) -> &Children {
        &self.0.children
    }

    fn has_too_many_unresponsive(&self) -> bool {
        self.unresponsive() >= self.0.config.jobs.unresponsive_max
    }

    /// Counts a solver that is given up, and returns its slot. If there are too many and the next one cannot run in a
    /// child either, the solver keeps its slot, so that the number of threads stays bounded.
    pub(super) fn give_up_solver(&self, slot: OwnedSemaphorePermit) -> Option<OwnedSemaphorePermit> {
        let keeps_its_slot = self.has_too_many_unresponsive() && !self.0.children.possible;
        self.0.unresponsive.fetch_add(1, Ordering::Relaxed);
        metrics::gauge!(metric::UNRESPONSIVE).increment(1.0);
        if keeps_its_slot {
            tracing::error!(solvers = self.unresponsive(), "too many solvers do not answer; this one keeps its slot");
            self.kept_slots().push(slot);
            return None;
        }
        Some(slot)
    }

    /// Counts a solver that was given up and has ended nevertheless.
    pub(super) fn solver_came_back(&self) {
        self.0.unresponsive.fetch_sub(1, Ordering::Relaxed);
        metrics::gauge!(metric::UNRESPONSIVE).decrement(1.0);
        drop(self.kept_slots().pop());
    }

    fn kept_slots(&self) -> MutexGuard<'_, Vec<OwnedSemaphorePermit>> {
        self.0.kept_slots.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn memory(&self) -> &MemoryBudget {
        &self.0.memory
    }

    pub(super) fn files(&self) -> &FileCache {
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

    pub(super) fn view_batch(&self, row: &BatchRow) -> Batch {
        view::batch(&self.0.config.http.public_base_path, row)
    }

    pub(super) fn converters(&self) -> &Converters {
        &self.0.converters
    }

    /// Runs a computation of some tenths of a second at most on a converter's thread, so that it does not stall the
    /// async runtime.
    pub async fn off_runtime<T: Send + 'static>(
        &self,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<T, JobsError> {
        self.converters().reserve(None, Length::Short).await?.run(work).await
    }
}

/// Counts a job that this process has cancelled.
pub(super) fn count_cancelled(kind: &str) {
    metrics::counter!(metric::JOBS, "kind" => kind.to_owned(), "status" => "cancelled").increment(1);
}
