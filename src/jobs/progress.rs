//! Between a solver's thread and the rest: progress out, cancel in.

use crate::wire::job::Progress;
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// What a solver is told at each of its looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    Continue,
    /// Stop: nobody wants the result any more.
    Cancel,
    /// Stop, and return the best result so far.
    Deadline,
}

/// What one running solver shares with its worker.
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

    /// Asks the solver to stop and return nothing.
    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// What the solver is to do, asked at each of its looks.
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

    /// The progress since the last call, if there was any.
    #[must_use]
    pub fn take(&self) -> Option<Progress> {
        self.latest.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// The solvers that run in this process, by job id.
#[derive(Debug, Default)]
pub struct Running(Mutex<HashMap<String, Arc<Line>>>);

impl Running {
    fn lines(&self) -> std::sync::MutexGuard<'_, HashMap<String, Arc<Line>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn insert(&self, id: &str, line: Arc<Line>) {
        self.lines().insert(id.into(), line);
    }

    /// Forgets a solver; another attempt of the same job is left alone.
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
