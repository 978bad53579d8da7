//! Memory budget that all running solvers share. A worker claims only jobs that fit into its free part.

use std::sync::Arc;
use tokio::sync::watch;

/// Handle of a budget. Clones share it.
#[derive(Clone, Debug)]
pub struct MemoryBudget {
    total_bytes: u64,
    used_bytes: Arc<watch::Sender<u64>>,
}

/// Share of the budget, which is returned when dropped.
#[derive(Debug)]
pub struct Share {
    budget: MemoryBudget,
    bytes: u64,
}

impl MemoryBudget {
    #[must_use]
    pub fn new(total_bytes: u64) -> Self {
        Self { total_bytes, used_bytes: Arc::new(watch::Sender::new(0)) }
    }

    /// Returns the largest number of bytes that [`MemoryBudget::reserve`] would give. While nothing is reserved, there
    /// is no limit, so that a job for more than the whole budget runs alone.
    #[must_use]
    pub fn free_bytes(&self) -> u64 {
        self.free_beside(*self.used_bytes.borrow())
    }

    fn free_beside(&self, used: u64) -> u64 {
        if used == 0 { u64::MAX } else { self.total_bytes.saturating_sub(used) }
    }

    /// Reserves `bytes`, or returns `None` if they are not free.
    #[must_use]
    pub fn reserve(&self, bytes: u64) -> Option<Share> {
        let reserved = self.used_bytes.send_if_modified(|used| {
            let fits = bytes <= self.free_beside(*used);
            if fits {
                *used = used.saturating_add(bytes);
            }
            fits
        });
        reserved.then(|| Share { budget: self.clone(), bytes })
    }

    /// Returns a signal that changes whenever memory is reserved or returned.
    #[must_use]
    pub fn changes(&self) -> watch::Receiver<u64> {
        self.used_bytes.subscribe()
    }
}

impl Share {
    /// Raises the share to `bytes`, even beyond the budget. This is for a job whose stored estimate was made by a
    /// version that estimated less.
    pub fn raise_to(&mut self, bytes: u64) {
        let more = bytes.saturating_sub(self.bytes);
        self.budget.used_bytes.send_modify(|used| *used = used.saturating_add(more));
        self.bytes = self.bytes.saturating_add(more);
    }
}

impl Drop for Share {
    fn drop(&mut self) {
        self.budget.used_bytes.send_modify(|used| *used = used.saturating_sub(self.bytes));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_never_exceed_the_budget_unless_one_job_needs_more_than_all_of_it() {
        let budget = MemoryBudget::new(10);
        let first = budget.reserve(7).unwrap();
        assert_eq!(budget.free_bytes(), 3);
        assert!(budget.reserve(4).is_none());
        let second = budget.reserve(3).unwrap();
        assert_eq!(budget.free_bytes(), 0);
        drop(first);
        assert!(budget.reserve(8).is_none(), "only one share is returned");
        drop(second);
        let alone = budget.reserve(1000).unwrap();
        assert!(budget.reserve(1).is_none());
        drop(alone);
        assert_eq!(budget.free_bytes(), u64::MAX);
    }

    #[test]
    fn a_raised_share_counts_in_full_and_is_returned_in_full() {
        let budget = MemoryBudget::new(10);
        let (mut raised, other) = (budget.reserve(2).unwrap(), budget.reserve(3).unwrap());
        raised.raise_to(20);
        raised.raise_to(1);
        assert_eq!(*budget.changes().borrow(), 23);
        drop(other);
        assert_eq!(budget.free_bytes(), 0);
        drop(raised);
        assert_eq!(*budget.changes().borrow(), 0);
    }
}
