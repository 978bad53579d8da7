//! Connection between a solver's thread and its attempt: progress goes out, and a cancel goes in.

use plateau_engine::report::Progress;
use plateau_engine::solved::Signal;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::Notify;

/// State that a running solver shares with its attempt.
#[derive(Debug)]
pub struct SolverLink {
    started: Instant,
    deadline: Instant,
    stopped: OnceLock<Instant>,
    /// Wakes the task that waits for a stop.
    stop: Notify,
    /// True if the solver was stopped to make room for the job of another owner.
    hands_back: AtomicBool,
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
            stop: Notify::new(),
            hands_back: AtomicBool::new(false),
            looked_ms: AtomicU64::new(0),
            latest: Mutex::new(None),
        }
    }

    /// Asks the solver to stop without a result.
    pub fn stop(&self) {
        self.stopped.get_or_init(Instant::now);
        self.stop.notify_one();
    }

    /// Waits until the solver is asked to stop. One task may wait.
    pub async fn stopped(&self) {
        while !self.is_asked_to_end() {
            self.stop.notified().await;
        }
    }

    /// Returns the time until the deadline.
    #[must_use]
    pub fn remaining(&self) -> Duration {
        self.deadline.saturating_duration_since(Instant::now())
    }

    /// Asks the solver to stop, after which its job goes back to the queue.
    pub fn hand_back(&self) {
        self.hands_back.store(true, Ordering::Relaxed);
        self.stop();
    }

    /// Returns true if the job goes back to the queue when its solver has stopped without a result.
    #[must_use]
    pub fn hands_back(&self) -> bool {
        self.hands_back.load(Ordering::Relaxed)
    }

    /// Returns true if the solver was asked to end.
    #[must_use]
    pub fn is_asked_to_end(&self) -> bool {
        self.stopped.get().is_some()
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
