//! Budget for the request bodies in memory. A body takes its share of it as its bytes arrive, whatever its header
//! declares.
//!
//! A body that finds no room waits until another one is dropped. Bodies never wait for each other
//! in a circle: a part of the budget that holds the largest body is kept in reserve, and one body
//! at a time may use it. That body can always be read to its end. Each owner's part of the budget
//! has such a reserve too. Only the body that holds its owner's reserve may take the reserve of the
//! whole budget.

use std::collections::HashMap;
use std::mem;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::Notify;

/// Budget for bodies, shared by all requests.
#[derive(Debug)]
pub struct Budget {
    /// Number of bytes that all bodies together may take.
    limit: usize,
    /// Number of bytes that the bodies of one owner may take. It is at least `largest`.
    owner_limit: usize,
    /// Size of the largest body in bytes.
    largest: usize,
    taken: Mutex<Taken>,
    /// Wakes the bodies that wait for room.
    given_back: Notify,
}

#[derive(Debug, Default)]
struct Taken {
    all: Account,
    /// Accounts of the owners who have taken anything.
    owners: HashMap<String, Account>,
}

#[derive(Debug, Default)]
struct Account {
    bytes: usize,
    /// True while a body holds this account's reserve.
    reserve_held: bool,
}

/// Share of one body in the budget. It is given back when it is dropped.
#[derive(Debug)]
pub struct Share {
    budget: Arc<Budget>,
    owner: String,
    bytes: usize,
    holds_owner_reserve: bool,
    holds_reserve: bool,
}

impl Budget {
    /// Returns a budget of `limit` bytes for bodies of at most `largest` bytes. One owner may take
    /// `owner_percent` of it, and in any case one body.
    #[must_use]
    pub fn new(limit: usize, owner_percent: u32, largest: usize) -> Self {
        let owner_limit = (limit as u64 * u64::from(owner_percent) / 100) as usize;
        let (taken, given_back) = (Mutex::default(), Notify::new());
        Self { limit, owner_limit: owner_limit.max(largest), largest, taken, given_back }
    }

    /// Returns an empty share for a body of this owner.
    #[must_use]
    pub fn share(self: &Arc<Self>, owner: String) -> Share {
        Share { budget: self.clone(), owner, bytes: 0, holds_owner_reserve: false, holds_reserve: false }
    }

    fn taken(&self) -> MutexGuard<'_, Taken> {
        self.taken.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Share {
    /// Waits until the share can have `bytes` bytes in total, which must be at most the size of the largest body.
    pub async fn grow_to(&mut self, bytes: usize) {
        let budget = self.budget.clone();
        loop {
            // Waiting begins before the attempt. Bytes that are given back after the attempt then end
            // the wait.
            let given_back = budget.given_back.notified();
            if self.try_grow_to(bytes) {
                return;
            }
            given_back.await;
        }
    }

    fn try_grow_to(&mut self, bytes: usize) -> bool {
        let budget = &self.budget;
        let more = bytes.saturating_sub(self.bytes);
        let mut taken = budget.taken();
        let Taken { all, owners } = &mut *taken;
        let own = owners.entry(self.owner.clone()).or_default();
        let fits = |account: &Account, limit: usize| account.bytes + more <= limit.saturating_sub(budget.largest);
        let needs_reserve = !self.holds_reserve && !fits(all, budget.limit);
        if !self.holds_owner_reserve && (needs_reserve || !fits(own, budget.owner_limit)) {
            self.holds_owner_reserve = !mem::replace(&mut own.reserve_held, true);
            if !self.holds_owner_reserve {
                return false;
            }
        }
        if needs_reserve {
            self.holds_reserve = !mem::replace(&mut all.reserve_held, true);
            if !self.holds_reserve {
                return false;
            }
        }
        own.bytes += more;
        all.bytes += more;
        self.bytes += more;
        true
    }
}

impl Drop for Share {
    fn drop(&mut self) {
        let mut taken = self.budget.taken();
        let Taken { all, owners } = &mut *taken;
        all.bytes -= self.bytes;
        all.reserve_held &= !self.holds_reserve;
        if let Some(own) = owners.get_mut(&self.owner) {
            own.bytes -= self.bytes;
            own.reserve_held &= !self.holds_owner_reserve;
            if own.bytes == 0 && !own.reserve_held {
                owners.remove(&self.owner);
            }
        }
        drop(taken);
        self.budget.given_back.notify_waiters();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::FutureExt;
    use futures_util::future::join_all;
    use std::time::Duration;

    /// A budget of 100 bytes for bodies of at most 10 bytes, of which one owner may take 50.
    fn budget() -> Arc<Budget> {
        Arc::new(Budget::new(100, 50, 10))
    }

    /// Returns the shares of up to `count` bodies of 10 bytes, until one has to wait.
    fn fill(budget: &Arc<Budget>, owner: &str, count: usize) -> Vec<Share> {
        let shares = (0..count).map(|_| budget.share(owner.into()));
        shares.map_while(|mut share| share.try_grow_to(10).then_some(share)).collect()
    }

    #[test]
    fn one_owner_leaves_room_for_another() {
        let budget = budget();
        let alice = fill(&budget, "alice", 20);
        assert_eq!(alice.len(), 5);
        let bob = fill(&budget, "bob", 20);
        assert_eq!(bob.len(), 5);
        assert_eq!(fill(&budget, "carol", 1).len(), 0);
        drop(alice);
        // Bob's last body holds the reserve of the whole budget.
        assert_eq!(fill(&budget, "carol", 20).len(), 4);
        drop(bob);
        let taken = budget.taken();
        assert!(taken.owners.is_empty() && taken.all.bytes == 0 && !taken.all.reserve_held, "{taken:?}");
    }

    #[test]
    fn a_waiting_body_goes_on_when_another_one_is_dropped() {
        let budget = budget();
        let mut taken = fill(&budget, "alice", 5);
        let mut share = budget.share("alice".into());
        let mut waiting = Box::pin(share.grow_to(1));
        assert!(waiting.as_mut().now_or_never().is_none());
        taken.pop();
        assert!(waiting.as_mut().now_or_never().is_some());
    }

    #[test]
    fn a_budget_of_one_body_takes_one_after_the_other() {
        let budget = Arc::new(Budget::new(10, 1, 10));
        let first = fill(&budget, "alice", 2);
        assert_eq!((first.len(), fill(&budget, "bob", 2).len()), (1, 0));
        drop(first);
        assert_eq!(fill(&budget, "bob", 2).len(), 1);
    }

    #[tokio::test]
    async fn bodies_that_grow_at_the_same_time_all_end() {
        let budget = budget();
        let read = async |number: usize| {
            let mut share = budget.share(format!("owner {}", number % 3));
            for bytes in 1..=10 {
                share.grow_to(bytes).await;
                let taken = budget.taken().all.bytes;
                assert!(taken <= 100, "{taken}");
                tokio::task::yield_now().await;
            }
        };
        // The time limit is so long that only bodies that wait for each other exceed it.
        let all = tokio::time::timeout(Duration::from_secs(30), join_all((0..60).map(read))).await;
        assert!(all.is_ok(), "bodies wait for each other: {budget:?}");
    }
}
