//! The queue of waiting jobs: its limits and its order.
//!
//! Fairness is start-time fair queueing (Goyal, Vin & Cheng 1996) with equal cost for every job. The job with the
//! lowest `turn` is claimed first, and among equal turns the older job. A new job's turn is the larger of two numbers:
//! the turn that is served next, and the last waiting turn of its owner plus one. An owner who queues a thousand jobs
//! gets a thousand turns in a row, so the single job of another owner is served right after the job that is served
//! next. With one owner this is first come, first served.

use super::tx::{Row, Tx};
use super::{Result, StoreError, StoreOptions, limit};

/// SQL for the number of waiting jobs in total and of the owner `$1`. Counting stops at the limits `$2` and `$3`.
const WAITING: &str = "(SELECT count(*) FROM (SELECT 1 FROM jobs WHERE status = 'queued' LIMIT $2) AS a) AS waiting, \
     (SELECT count(*) FROM (SELECT 1 FROM jobs WHERE status = 'queued' AND owner = $1 LIMIT $3) AS b) AS own";

/// Runs a query that has the columns of [`WAITING`]. Fails with `QueueFull` if the queue has no room for another job of
/// this owner.
fn row_with_room(tx: &mut Tx<'_>, query: &str, owner: Option<&str>, options: &StoreOptions) -> Result<Row> {
    let (most, most_own) = (limit(options.queue_limit), limit(options.owner_queue_limit));
    let row = tx.one(query, &[owner.unwrap_or_default().into(), most.into(), most_own.into()])?;
    if row.get::<i64>("waiting")? >= most {
        return Err(StoreError::QueueFull { own: false });
    }
    if row.get::<i64>("own")? >= most_own {
        return Err(StoreError::QueueFull { own: true });
    }
    Ok(row)
}

/// Fails with `QueueFull` if the queue has no room for another job of this owner.
pub(super) fn check_room(tx: &mut Tx<'_>, owner: Option<&str>, options: &StoreOptions) -> Result<()> {
    row_with_room(tx, &format!("SELECT {WAITING}"), owner, options).map(drop)
}

/// Returns the first free turn for the owner. Fails with `QueueFull` if there is no room.
pub(super) fn next_turn(tx: &mut Tx<'_>, owner: Option<&str>, options: &StoreOptions) -> Result<i64> {
    let text = format!(
        "SELECT {WAITING}, (SELECT min(turn) FROM jobs WHERE status = 'queued') AS served_next, \
         (SELECT max(turn) FROM jobs WHERE status = 'queued' AND owner = $1) AS last_own"
    );
    let row = row_with_room(tx, &text, owner, options)?;
    let served_next = row.get::<Option<i64>>("served_next")?.unwrap_or(1);
    Ok(served_next.max(row.get::<Option<i64>>("last_own")?.map_or(1, |last| last + 1)))
}

/// Returns the number of jobs that wait.
pub(super) fn length(tx: &mut Tx<'_>) -> Result<i64> {
    tx.one("SELECT count(*) AS queued FROM jobs WHERE status = 'queued'", &[])?.get("queued")
}
