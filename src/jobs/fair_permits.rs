//! Permits that are given to the waiting owners in turn.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::oneshot;

/// A number of permits. If several owners wait, they get one permit each in turn, however many permits an owner waits
/// for.
#[derive(Debug)]
pub struct FairPermits(Mutex<State>);

#[derive(Debug)]
struct State {
    free: usize,
    /// Owners who wait. The first one has the next turn.
    lines: VecDeque<(String, VecDeque<oneshot::Sender<FairPermit>>)>,
}

/// A permit, which is returned when dropped.
#[derive(Debug)]
pub struct FairPermit(Option<Arc<FairPermits>>);

impl FairPermits {
    #[must_use]
    pub fn new(permits: usize) -> Self {
        Self(Mutex::new(State { free: permits, lines: VecDeque::new() }))
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for a permit. Returns `None` only if the process is ending.
    pub async fn take(self: &Arc<Self>, owner: &str) -> Option<FairPermit> {
        let turn = {
            let mut state = self.state();
            if state.free > 0 {
                state.free -= 1;
                return Some(FairPermit(Some(self.clone())));
            }
            let (waiter, turn) = oneshot::channel();
            match state.lines.iter_mut().find(|(name, _)| name == owner) {
                Some((_, line)) => line.push_back(waiter),
                None => state.lines.push_back((owner.to_owned(), VecDeque::from([waiter]))),
            }
            turn
        };
        turn.await.ok()
    }

    /// Gives a returned permit to the owner who has the next turn.
    fn pass_on(self: &Arc<Self>) {
        let mut state = self.state();
        while let Some((owner, mut line)) = state.lines.pop_front() {
            let waiter = line.pop_front();
            if !line.is_empty() {
                state.lines.push_back((owner, line));
            }
            // A permit may reach a waiter that goes away at the same moment. The permit then comes back when it is
            // dropped.
            match waiter.map(|waiter| waiter.send(FairPermit(Some(self.clone())))) {
                Some(Ok(())) => return,
                // The waiter has gone away. Its permit is void, because it must not come back while the state is
                // locked.
                Some(Err(mut turn)) => turn.0 = None,
                None => {}
            }
        }
        state.free += 1;
    }
}

impl Drop for FairPermit {
    fn drop(&mut self) {
        if let Some(turns) = self.0.take() {
            turns.pass_on();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::FutureExt;

    #[tokio::test]
    async fn owners_get_permits_in_turn() {
        let turns = Arc::new(FairPermits::new(1));
        let mut held = turns.take("alice").await.unwrap();
        let mut waiting: Vec<_> = ["alice", "alice", "alice", "bob", "bob", "carol"]
            .map(|owner| (owner, Box::pin(turns.take(owner))))
            .into_iter()
            .collect();
        for (_, wait) in &mut waiting {
            assert!(wait.now_or_never().is_none());
        }
        let mut order = Vec::new();
        while !waiting.is_empty() {
            drop(held);
            let ready = waiting
                .iter_mut()
                .enumerate()
                .find_map(|(index, (_, wait))| Some((index, wait.now_or_never()?.unwrap())));
            let (index, turn) = ready.expect("a permit is free");
            order.push(waiting.remove(index).0);
            held = turn;
        }
        assert_eq!(order, ["alice", "bob", "carol", "alice", "bob", "alice"]);
    }

    #[tokio::test]
    async fn a_permit_of_a_waiter_that_went_away_is_not_lost() {
        let turns = Arc::new(FairPermits::new(1));
        let held = turns.take("alice").await.unwrap();
        let mut gone = Box::pin(turns.take("bob"));
        assert!((&mut gone).now_or_never().is_none());
        drop(gone);
        let mut late = Box::pin(turns.take("carol"));
        assert!((&mut late).now_or_never().is_none());
        drop(held);
        // The permit has been sent, but its waiter goes away without taking it.
        drop(late);
        assert!(turns.take("dave").now_or_never().is_some());
    }
}
