//! Shares of the owners in the solvers of this process.
//!
//! A free solver goes to the owner with the fewest running jobs, and among equals to the one whose jobs ran for the
//! shortest time of late. With one solver, owners thus take turns by time. Solvers that no other owner asks for may all
//! run the jobs of one owner. If another owner then has to wait, the latest of these jobs is handed back to the queue,
//! unless that would leave its owner with fewer solvers than the other.

use super::memory::MemoryBudget;
use super::progress::SolverLink;
use crate::store::WaitingOwner;
use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Time in which the time for which an owner's jobs ran counts half. It is as long as the default time limit of a job.
const HALF_LIFE: Duration = Duration::from_secs(600);
/// Owners whose jobs ran for less are equal.
const LEAST: Duration = Duration::from_millis(10);

/// Solvers that run in this process, by job identifier, and the time for which the jobs of each owner ran.
#[derive(Debug, Default)]
pub struct Running(Mutex<State>);

#[derive(Debug, Default)]
struct State {
    solvers: HashMap<String, Solver>,
    used: BTreeMap<String, Used>,
}

#[derive(Debug, Clone)]
struct Solver {
    link: Arc<SolverLink>,
    /// Empty without keys.
    owner: String,
    memory_bytes: u64,
    started: Instant,
}

/// Time for which an owner's jobs ran, as it counted at a moment.
#[derive(Debug, Clone, Copy)]
struct Used {
    time: Duration,
    at: Instant,
}

impl Used {
    fn at(self, now: Instant) -> Duration {
        let halves = now.saturating_duration_since(self.at).as_secs_f64() / HALF_LIFE.as_secs_f64();
        self.time.mul_f64(0.5_f64.powf(halves))
    }
}

impl State {
    fn running(&self) -> BTreeMap<&str, usize> {
        let mut running = BTreeMap::new();
        for solver in self.solvers.values() {
            *running.entry(solver.owner.as_str()).or_insert(0) += 1;
        }
        running
    }

    /// Returns the owners who come after those without running jobs and without use, in the order of their turns.
    fn later_owners(&self, now: Instant) -> Vec<String> {
        let running = self.running();
        let mut later: BTreeMap<&str, (usize, Duration)> =
            running.iter().map(|(owner, count)| (*owner, (*count, Duration::ZERO))).collect();
        for (owner, used) in &self.used {
            let time = used.at(now);
            if time >= LEAST || running.contains_key(owner.as_str()) {
                later.entry(owner).or_default().1 = time;
            }
        }
        let mut later: Vec<_> = later.into_iter().collect();
        later.sort_by_key(|(owner, turn)| (*turn, *owner));
        later.into_iter().map(|(owner, _)| owner.to_owned()).collect()
    }

    /// Returns the solver whose job makes room for a waiting owner, if there is one.
    fn to_hand_back(&self, waiting: &[WaitingOwner], memory: &MemoryBudget) -> Option<&Solver> {
        let running = self.running();
        let (owner, most) = running.iter().max_by_key(|(_, count)| **count)?;
        let victims = self.solvers.values().filter(|solver| solver.owner == **owner);
        let victim = victims.filter(|solver| !solver.link.is_asked_to_end()).max_by_key(|solver| solver.started)?;
        let free = memory.free_bytes().saturating_add(victim.memory_bytes);
        let has_less = |one: &WaitingOwner| running.get(one.owner.as_str()).copied().unwrap_or(0) + 2 <= *most;
        waiting.iter().any(|one| has_less(one) && one.memory_bytes <= free).then_some(victim)
    }
}

impl Running {
    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn insert(&self, id: &str, link: Arc<SolverLink>, owner: Option<&str>, memory_bytes: u64) {
        let owner = owner.unwrap_or_default().to_owned();
        let solver = Solver { link, owner, memory_bytes, started: Instant::now() };
        self.state().solvers.insert(id.into(), solver);
    }

    /// Removes a solver, and counts the time for which it ran. If another attempt at the same job is registered, it
    /// stays.
    pub fn remove(&self, id: &str, link: &Arc<SolverLink>) {
        let mut state = self.state();
        let State { solvers, used } = &mut *state;
        if !solvers.get(id).is_some_and(|solver| Arc::ptr_eq(&solver.link, link)) {
            return;
        }
        if let Some(solver) = solvers.remove(id) {
            let now = Instant::now();
            // Owners whose use counts for nothing are forgotten, so that the map stays as small as the number of active
            // owners.
            used.retain(|_, used| used.at(now) >= LEAST);
            let before = used.get(&solver.owner).map_or(Duration::ZERO, |used| used.at(now));
            let time = before.saturating_add(now.saturating_duration_since(solver.started));
            used.insert(solver.owner, Used { time, at: now });
        }
    }

    /// Asks the job's solver to stop, if it runs in this process.
    pub fn cancel(&self, id: &str) {
        if let Some(solver) = self.state().solvers.get(id) {
            solver.link.stop();
        }
    }

    /// Returns the owners who come after all others when a solver is free.
    #[must_use]
    pub fn later_owners(&self) -> Vec<String> {
        self.state().later_owners(Instant::now())
    }

    /// Returns true if an owner runs so many jobs that another owner may take one of their solvers.
    #[must_use]
    pub fn may_hand_back(&self) -> bool {
        self.state().running().values().any(|count| *count >= 2)
    }

    /// Hands a job back to the queue whose owner has more than their share while one of these owners waits.
    pub fn make_room(&self, waiting: &[WaitingOwner], memory: &MemoryBudget) {
        if let Some(solver) = self.state().to_hand_back(waiting, memory) {
            solver.link.hand_back();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn started(state: &mut State, id: &str, owner: &str, ago_s: u64) {
        let link = Arc::new(SolverLink::new(Duration::from_secs(60)));
        let started = Instant::now().checked_sub(Duration::from_secs(ago_s)).unwrap();
        let solver = Solver { link, owner: owner.into(), memory_bytes: 10, started };
        state.solvers.insert(id.into(), solver);
    }

    #[test]
    fn owners_come_in_the_order_of_their_running_jobs_and_then_of_their_time() {
        let mut state = State::default();
        let now = Instant::now();
        for (owner, seconds) in [("long", 91.0), ("short", 0.3), ("hardly", 0.001)] {
            state.used.insert(owner.into(), Used { time: Duration::from_secs_f64(seconds), at: now });
        }
        assert_eq!(state.later_owners(now), ["short", "long"]);
        started(&mut state, "1", "short", 0);
        started(&mut state, "2", "new", 0);
        started(&mut state, "3", "new", 0);
        assert_eq!(state.later_owners(now), ["long", "short", "new"]);
        // After 150 half-lives no use counts.
        state.solvers.clear();
        assert!(state.later_owners(now + 150 * HALF_LIFE).is_empty());
    }

    #[test]
    fn only_a_job_beyond_the_share_makes_room_and_the_latest_one_does() {
        let memory = MemoryBudget::new(100);
        let _used = memory.reserve(95).unwrap();
        let waiting = |owner: &str, memory_bytes: u64| [WaitingOwner { owner: owner.into(), memory_bytes }];
        let mut state = State::default();
        started(&mut state, "old", "alice", 9);
        assert!(state.to_hand_back(&waiting("bob", 1), &memory).is_none(), "alice has her share");
        started(&mut state, "new", "alice", 1);
        let chosen = |state: &State, waiting: &[WaitingOwner]| {
            let chosen = state.to_hand_back(waiting, &memory)?;
            state.solvers.iter().find(|(_, solver)| Arc::ptr_eq(&solver.link, &chosen.link)).map(|(id, _)| id.clone())
        };
        assert_eq!(chosen(&state, &waiting("bob", 1)).as_deref(), Some("new"));
        assert_eq!(chosen(&state, &waiting("bob", 15)).as_deref(), Some("new"), "15 bytes are free then");
        assert_eq!(chosen(&state, &waiting("bob", 16)), None, "bob's job would not fit");
        assert_eq!(chosen(&state, &waiting("alice", 1)), None);
        started(&mut state, "other", "bob", 0);
        assert_eq!(chosen(&state, &waiting("bob", 1)), None, "each has a share");
        assert_eq!(chosen(&state, &waiting("carol", 1)).as_deref(), Some("new"));
        state.solvers["new"].link.hand_back();
        assert_eq!(chosen(&state, &waiting("carol", 1)).as_deref(), Some("old"));
    }
}
