//! Connection between a solver's thread and its attempt: progress goes out, and a cancel goes in.

use plateau_forms::report::Progress;
use plateau_forms::solved::Signal;
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// State that a running solver shares with its attempt.
#[derive(Debug)]
pub struct Line {
    stop: AtomicBool,
    deadline: Instant,
    latest: Mutex<Option<Progress>>,
}

impl Line {
    #[must_use]
    pub fn new(deadline: Duration) -> Self {
        Self { stop: AtomicBool::new(false), deadline: Instant::now() + deadline, latest: Mutex::new(None) }
    }

    /// Asks the solver to stop without a result.
    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// Returns the current instruction to the solver.
    #[must_use]
    pub fn signal(&self) -> Signal {
        if self.stop.load(Ordering::Relaxed) {
            Signal::Cancel
        } else if Instant::now() >= self.deadline {
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
pub struct Running(Mutex<HashMap<String, Arc<Line>>>);

impl Running {
    fn lines(&self) -> std::sync::MutexGuard<'_, HashMap<String, Arc<Line>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn insert(&self, id: &str, line: Arc<Line>) {
        self.lines().insert(id.into(), line);
    }

    /// Removes a solver. If another attempt at the same job is registered, it stays.
    pub fn remove(&self, id: &str, line: &Arc<Line>) {
        let mut lines = self.lines();
        if lines.get(id).is_some_and(|current| Arc::ptr_eq(current, line)) {
            lines.remove(id);
        }
    }

    /// Asks the job's solver to stop, if it runs in this process.
    pub fn cancel(&self, id: &str) {
        if let Some(line) = self.lines().get(id) {
            line.stop();
        }
    }
}
