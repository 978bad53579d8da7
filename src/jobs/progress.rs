//! Connection between a solver's thread and its attempt: progress goes out, and a cancel goes in.

use plateau_engine::report::Progress;
use plateau_engine::solved::Signal;
use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

/// State that a running solver shares with its attempt.
#[derive(Debug)]
pub struct SolverLink {
    started: Instant,
    deadline: Instant,
    stopped: OnceLock<Instant>,
    /// Time of the solver's last look at the signal, in milliseconds since the start.
    looked_ms: AtomicU64,
    latest: Mutex<Option<Progress>>,
}

impl SolverLink {
    #[must_use]
    pub fn new(deadline: Duration) -> Self {
        let started = Instant::now();
        Self {
            started,
            deadline: started + deadline,
            stopped: OnceLock::new(),
            looked_ms: AtomicU64::new(0),
            latest: Mutex::new(None),
        }
    }

    /// Asks the solver to stop without a result.
    pub fn stop(&self) {
        self.stopped.get_or_init(Instant::now);
    }

    /// Returns the time since the solver was asked to end, by a stop or by its deadline.
    #[must_use]
    pub fn asked_to_end_for(&self) -> Option<Duration> {
        let deadline = Some(self.deadline).filter(|deadline| *deadline <= Instant::now());
        let asked = [self.stopped.get().copied(), deadline].into_iter().flatten().min();
        asked.map(|asked| asked.elapsed())
    }

    /// Returns the time since the solver last looked at the signal, or since its start.
    #[must_use]
    pub fn not_looked_for(&self) -> Duration {
        let looked = Duration::from_millis(self.looked_ms.load(Ordering::Relaxed));
        self.started.elapsed().saturating_sub(looked)
    }

    /// Returns the current instruction to the solver.
    #[must_use]
    pub fn signal(&self) -> Signal {
        let now = Instant::now();
        let elapsed_ms = now.duration_since(self.started).as_millis();
        // A job does not run for 2^64 milliseconds.
        self.looked_ms.store(elapsed_ms as u64, Ordering::Relaxed);
        if self.stopped.get().is_some() {
            Signal::Cancel
        } else if now >= self.deadline {
            Signal::Deadline
        } else {
            Signal::Continue
        }
    }

    pub fn report(&self, progress: Progress) {
        *self.latest.lock().unwrap_or_else(PoisonError::into_inner) = Some(progress);
    }

    /// Whether the latest progress has been taken.
    #[cfg(feature = "test-hooks")]
    #[must_use]
    pub fn is_taken(&self) -> bool {
        self.latest.lock().unwrap_or_else(PoisonError::into_inner).is_none()
    }

    /// Returns the latest progress if there was any since the last call.
    #[must_use]
    pub fn take(&self) -> Option<Progress> {
        self.latest.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// Solvers that run in this process, by job identifier.
#[derive(Debug, Default)]
pub struct Running(Mutex<HashMap<String, Arc<SolverLink>>>);

impl Running {
    fn links(&self) -> std::sync::MutexGuard<'_, HashMap<String, Arc<SolverLink>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn insert(&self, id: &str, link: Arc<SolverLink>) {
        self.links().insert(id.into(), link);
    }

    /// Removes a solver. If another attempt at the same job is registered, it stays.
    pub fn remove(&self, id: &str, link: &Arc<SolverLink>) {
        let mut links = self.links();
        if links.get(id).is_some_and(|current| Arc::ptr_eq(current, link)) {
            links.remove(id);
        }
    }

    /// Asks the job's solver to stop, if it runs in this process.
    pub fn cancel(&self, id: &str) {
        if let Some(link) = self.links().get(id) {
            link.stop();
        }
    }
}
