//! Workers: each claims one job after the other. What an attempt found is stored while the next one is claimed and
//! solved, so that the disk keeps no solver waiting.

use super::{Jobs, attempt};
use std::time::Duration;

/// The stack of the runtime's threads, which solvers run on, and of the converters. They may recurse (sparse orderings,
/// Delaunay walks), and address space is cheap.
pub const STACK_BYTES: usize = 64 << 20;
/// Time after which a worker looks for a job although it was told of none.
const IDLE_POLL: Duration = Duration::from_secs(1);

/// Works until a shutdown is asked for. Any number of workers may run, here and in other processes.
pub(super) async fn run(jobs: Jobs, name: String) {
    let Some(_working) = jobs.under_way() else { return };
    let lease = Duration::from_millis(jobs.config().jobs.lease_ms);
    let mut work = jobs.store().work_signal();
    loop {
        // Submissions that are solved at once take turns with the jobs of the queue.
        let Ok(slot) = jobs.slots().acquire_owned().await else { return };
        if jobs.is_shutting_down() {
            return;
        }
        work.borrow_and_update();
        // A job is not started while its result could not be stored.
        let claimed = match jobs.store().check_room_for_results() {
            Ok(()) => jobs.store().claim(&name, lease).await,
            Err(_) => Ok(None),
        };
        match claimed {
            Ok(Some(claimed)) => {
                tokio::spawn(attempt::run(jobs.clone(), claimed, slot));
                continue;
            }
            Ok(None) => {}
            Err(error) => tracing::warn!(%error, worker = %name, "cannot claim a job"),
        }
        drop(slot);
        tokio::select! {
            _ = work.changed() => {}
            () = tokio::time::sleep(IDLE_POLL) => {}
            () = jobs.shutdown() => {}
        }
    }
}
