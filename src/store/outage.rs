//! Measures how long this process has been in contact with the database without a break.
//!
//! A lease that runs out says that a worker died only if the worker could have renewed it. After an outage of the
//! database every lease has run out, and the workers need a moment to renew theirs. A process therefore counts a lease
//! as lost only if its own contact has lasted for the length of the lease.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::StoreError;

#[derive(Debug)]
pub(super) struct OutageTracker {
    /// Longest pause between two answers that does not count as a break. A lease is renewed three times in its length,
    /// so every outage that lets a lease run out is longer than half of it.
    pause: Duration,
    state: Mutex<State>,
}

#[derive(Debug, Clone, Copy)]
struct State {
    /// Start of the contact. `None` if no other process uses the database, so that there was no outage before the
    /// start.
    since: Option<Instant>,
    last: Instant,
    /// End of the last break that began with a failed operation.
    restored: Option<Instant>,
    /// True from a failed operation to the next successful write. Reads do not end it, because a full disk can be read.
    broken: bool,
}

impl OutageTracker {
    /// `alone` says that no other process uses the database.
    pub(super) fn new(lease: Duration, alone: bool) -> Self {
        let now = Instant::now();
        let state = State { since: (!alone).then_some(now), last: now, restored: None, broken: false };
        Self { pause: if alone { Duration::MAX } else { lease / 2 }, state: Mutex::new(state) }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        // No thread panics while it holds the lock.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes the end of a read or a write.
    pub(super) fn note<T>(&self, ended: &Result<T, StoreError>, is_write: bool) {
        self.note_at(Instant::now(), ended.as_ref().err(), is_write);
    }

    fn note_at(&self, now: Instant, error: Option<&StoreError>, is_write: bool) {
        let mut state = self.state();
        match error {
            Some(StoreError::Unavailable(_) | StoreError::Refused(_) | StoreError::NoSpace(_)) => state.broken = true,
            _ if state.broken && !is_write => {}
            _ => {
                if state.broken || now.saturating_duration_since(state.last) > self.pause {
                    state.since = Some(now);
                }
                if state.broken {
                    state.restored = Some(now);
                }
                state.broken = false;
                state.last = now;
            }
        }
    }

    /// Returns true if the last operation failed, so that only a successful write shows that the contact is back.
    pub(super) fn is_broken(&self) -> bool {
        self.state().broken
    }

    /// Returns the time since the end of the last outage that this process has seen.
    pub(super) fn since_outage(&self) -> Option<Duration> {
        self.state().restored.map(|restored| restored.elapsed())
    }

    /// Returns the length of the unbroken contact.
    pub(super) fn unbroken(&self) -> Duration {
        self.unbroken_at(Instant::now())
    }

    fn unbroken_at(&self, now: Instant) -> Duration {
        let state = *self.state();
        if state.broken || now.saturating_duration_since(state.last) > self.pause {
            return Duration::ZERO;
        }
        state.since.map_or(Duration::MAX, |since| now.saturating_duration_since(since))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_or_a_long_pause_ends_the_contact_and_a_write_begins_it_again() {
        let contact = OutageTracker::new(Duration::from_secs(10), false);
        let start = contact.state().last;
        let at = |s: u64| start + Duration::from_secs(s);
        let unbroken_s = |s: u64| contact.unbroken_at(at(s)).as_secs();
        contact.note_at(at(4), None, false);
        assert_eq!((unbroken_s(4), unbroken_s(8), unbroken_s(10)), (4, 8, 0));
        // Nothing was heard for 6 s, more than half of a lease.
        contact.note_at(at(10), None, false);
        assert_eq!((unbroken_s(10), unbroken_s(13)), (0, 3));
        contact.note_at(at(13), Some(&StoreError::QueueFull { own: true }), true);
        assert_eq!(unbroken_s(13), 3, "an answer of the database");
        contact.note_at(at(14), Some(&StoreError::Unavailable("gone".into())), false);
        contact.note_at(at(15), None, false);
        assert!(contact.is_broken() && unbroken_s(15) == 0, "a read does not show that writes work");
        contact.note_at(at(16), None, true);
        assert_eq!((contact.is_broken(), unbroken_s(16), unbroken_s(18)), (false, 0, 2));
    }

    #[test]
    fn a_process_that_is_alone_had_no_outage_before_its_start() {
        let contact = OutageTracker::new(Duration::from_secs(10), true);
        let start = contact.state().last;
        assert_eq!(contact.unbroken_at(start + Duration::from_secs(3600)), Duration::MAX);
        contact.note_at(start, Some(&StoreError::NoSpace("full".into())), true);
        contact.note_at(start + Duration::from_secs(5), None, true);
        assert_eq!(contact.unbroken_at(start + Duration::from_secs(7)), Duration::from_secs(2));
    }
}
