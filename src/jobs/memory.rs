//! Memory budget that all running solvers share. A solver that would exceed it waits until others have ended.

use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

/// Interval at which a waiting solver checks whether its job was cancelled or its deadline has passed.
const CHECK_INTERVAL: Duration = Duration::from_millis(50);

#[derive(Debug)]
pub struct MemoryBudget {
    total_bytes: u64,
    used_bytes: Mutex<u64>,
    freed: Condvar,
}

/// Share of the budget, which is returned when dropped.
#[derive(Debug)]
pub struct Share<'b> {
    budget: &'b MemoryBudget,
    bytes: u64,
}

impl MemoryBudget {
    #[must_use]
    pub fn new(total_bytes: u64) -> Self {
        Self { total_bytes, used_bytes: Mutex::new(0), freed: Condvar::new() }
    }

    /// Waits on this thread until `bytes` are free, and reserves them. A request for more than the whole budget
    /// reserves the whole budget. Returns `None` if the memory is not free and `wanted` returns false.
    pub fn share(&self, bytes: u64, wanted: impl Fn() -> bool) -> Option<Share<'_>> {
        let bytes = bytes.min(self.total_bytes);
        let mut used = self.used_bytes.lock().unwrap_or_else(PoisonError::into_inner);
        while *used > self.total_bytes - bytes {
            if !wanted() {
                return None;
            }
            used = self.freed.wait_timeout(used, CHECK_INTERVAL).unwrap_or_else(PoisonError::into_inner).0;
        }
        *used += bytes;
        Some(Share { budget: self, bytes })
    }
}

impl Drop for Share<'_> {
    fn drop(&mut self) {
        *self.budget.used_bytes.lock().unwrap_or_else(PoisonError::into_inner) -= self.bytes;
        self.budget.freed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU64, Ordering};

    #[test]
    fn shares_never_exceed_the_budget() {
        let budget = MemoryBudget::new(10);
        let (running, peak) = (AtomicU64::new(0), AtomicU64::new(0));
        std::thread::scope(|scope| {
            for thread in 0..4 {
                let (budget, running, peak) = (&budget, &running, &peak);
                scope.spawn(move || {
                    for round in 0..50 {
                        let bytes = 1 + (thread + round) % 7;
                        let share = budget.share(bytes, || true).expect("always wanted");
                        peak.fetch_max(running.fetch_add(bytes, Ordering::SeqCst) + bytes, Ordering::SeqCst);
                        running.fetch_sub(bytes, Ordering::SeqCst);
                        drop(share);
                    }
                });
            }
        });
        assert!((1..=10).contains(&peak.load(Ordering::SeqCst)));
        assert_eq!(*budget.used_bytes.lock().unwrap(), 0);
    }

    #[test]
    fn waiting_for_a_share_ends_when_it_is_no_longer_wanted() {
        let budget = MemoryBudget::new(10);
        let held = budget.share(1_000, || true).expect("a request for more than the budget reserves all of it");
        assert!(budget.share(1, || false).is_none());
        drop(held);
        assert!(budget.share(10, || false).is_some());
    }
}
