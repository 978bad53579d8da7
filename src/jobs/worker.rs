//! Workers, each of which claims one job after the other. An attempt stores its outcome while the worker already claims
//! and solves the next job, so that solvers do not wait for the disk.

use super::{Jobs, attempt};
use crate::store::{Claimed, Preference, Room, StoreError};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;

/// Longest interval at which an idle worker looks for a job without having been notified of one. It looks at least
/// three times in a lease, because the store takes a longer pause for an outage.
const IDLE_POLL: Duration = Duration::from_secs(1);

/// Largest memory of the jobs that a worker for small jobs claims, by estimate. Films of 16,000 triangles and tensile
/// structures of 3,000 take this much, and some seconds.
pub(super) const SMALL_BYTES: u64 = 16 << 20;

/// Claims jobs of at most `most_bytes` until a shutdown is asked for. Any number of workers may run in this process and
/// in others. A solver runs with a permit of `slots`.
pub(super) async fn run(jobs: Jobs, name: String, slots: Arc<Semaphore>, most_bytes: u64) {
    let Some(_working) = jobs.under_way() else { return };
    let lease = Duration::from_millis(jobs.config().jobs.lease_ms);
    let mut work = jobs.store().work_signal();
    // Each claim has a name of its own, by which it is found if its answer is lost.
    let (mut number, mut uncertain) = (0_u64, false);
    let claim_name = |number: u64| format!("{name}/{number}");
    let mut memory = jobs.memory().changes();
    loop {
        // Submissions that are solved at once take the same slots as jobs from the queue.
        let Ok(slot) = slots.clone().acquire_owned().await else { return };
        if jobs.is_shutting_down() {
            if uncertain && let Ok(Some(claimed)) = jobs.store().claimed_by(&claim_name(number), lease).await {
                // If this fails too, the lease runs out.
                let _ = jobs.store().hand_back(&claimed.id, claimed.attempt).await;
            }
            return;
        }
        work.borrow_and_update();
        memory.borrow_and_update();
        // No job is started while the store could not take its result.
        let claimed = match jobs.store().check_room_for_results() {
            Ok(()) => {
                let room = Room { free_bytes: jobs.memory().free_bytes(), most_bytes };
                let claimed = claim(&jobs, &claim_name(number), lease, uncertain, room).await;
                uncertain = claimed.is_err();
                claimed
            }
            Err(_) => Ok(None),
        };
        match claimed {
            Ok(Some(claimed)) => {
                number += 1;
                match jobs.memory().reserve(claimed.memory_bytes) {
                    Some(share) => drop(tokio::spawn(attempt::run(jobs.clone(), claimed, slot, share))),
                    // Another worker has taken the memory since this worker looked.
                    None => attempt::hand_back(&jobs, &claimed).await,
                }
                continue;
            }
            Ok(None) => {}
            Err(error) => tracing::warn!(%error, worker = %name, "cannot claim a job"),
        }
        drop(slot);
        tokio::select! {
            _ = work.changed() => {}
            _ = memory.changed() => {}
            () = tokio::time::sleep(IDLE_POLL.min(lease / 3)) => {}
            () = jobs.shutdown() => {}
        }
    }
}

/// Interval at which waiting owners are looked for.
const ROOM_INTERVAL: Duration = Duration::from_millis(250);
/// Time for which an owner waits before a job of another owner is handed back.
const ROOM_PATIENCE: Duration = Duration::from_millis(500);

/// Hands jobs back whose owner has more than their share of the solvers while others wait. Never returns.
pub(crate) async fn make_room(jobs: Jobs) {
    if !jobs.config().has_owners() {
        return std::future::pending().await;
    }
    loop {
        tokio::time::sleep(ROOM_INTERVAL).await;
        if jobs.slots().available_permits() > 0 || !jobs.running().may_hand_back() {
            continue;
        }
        match jobs.store().waiting_owners(ROOM_PATIENCE).await {
            Ok(waiting) => jobs.running().make_room(&waiting, jobs.memory()),
            Err(error) => tracing::warn!(%error, "cannot look for waiting owners"),
        }
    }
}

/// Returns which jobs a worker of this process takes first and which it leaves out.
fn preference(jobs: &Jobs) -> Preference {
    let later_owners = if jobs.config().has_owners() { jobs.running().later_owners() } else { Vec::new() };
    Preference { later_owners, except: jobs.unread() }
}

/// Claims a job. If `uncertain`, an earlier claim under this name has failed, but may have been committed although its
/// answer was lost. In that case the job of that claim is returned first.
async fn claim(
    jobs: &Jobs,
    name: &str,
    lease: Duration,
    uncertain: bool,
    room: Room,
) -> Result<Option<Claimed>, StoreError> {
    if uncertain && let Some(claimed) = jobs.store().claimed_by(name, lease).await? {
        return Ok(Some(claimed));
    }
    jobs.store().claim_within(name, lease, room, preference(jobs)).await
}
