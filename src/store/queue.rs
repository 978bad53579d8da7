//! The queue of waiting jobs: its limits and its order.
//!
//! Fairness is start-time fair queueing (Goyal, Vin & Cheng 1996) with equal cost for every job. The job with the
//! lowest `turn` is claimed first, and among equal turns the older job. A new job's turn is the larger of two numbers:
//! the turn that is being served, and the last turn of its owner's waiting and running jobs plus one. The turn that is
//! being served is the latest one of the running jobs, or the first one of the waiting jobs if that is lower or no job
//! runs. An owner who queues a thousand jobs gets a thousand turns in a row. While the first of them runs, the single
//! job of another owner gets the same turn as that job, so it is served next. With one owner this is first come, first
//! served.
//!
//! A worker may change this order by [`Preference`]: it knows how many jobs of each owner run in its process, and for
//! how long they ran.

use super::tx::{Row, Tx};
use super::{Result, StoreError, StoreOptions, limit, milliseconds};
use serde_json::json;
use std::time::Duration;

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
        "SELECT {WAITING}, (SELECT min(turn) FROM jobs WHERE status = 'queued') AS first_waiting, \
         (SELECT max(turn) FROM jobs WHERE status = 'running') AS last_running, \
         (SELECT max(turn) FROM jobs WHERE status = 'queued' AND owner = $1) AS last_own_waiting, \
         (SELECT max(turn) FROM jobs WHERE status = 'running' AND owner = $1) AS last_own_running"
    );
    let row = row_with_room(tx, &text, owner, options)?;
    let turn = |column: &str| row.get::<Option<i64>>(column);
    let served = match (turn("first_waiting")?, turn("last_running")?) {
        (Some(waiting), Some(running)) => waiting.min(running),
        (one, other) => one.or(other).unwrap_or(1),
    };
    let last_own = turn("last_own_waiting")?.max(turn("last_own_running")?);
    Ok(served.max(last_own.map_or(1, |last| last + 1)))
}

/// Jobs that a worker prefers or leaves out, for reasons that only its process knows.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Preference {
    /// Owners whose jobs come after those of all other owners. Among them the earlier ones come first.
    pub later_owners: Vec<String>,
    /// Identifiers of jobs that are not claimed.
    pub except: Vec<String>,
}

/// SQL of the order of the queue for a worker.
#[derive(Debug)]
pub(super) struct Order {
    /// Condition for the jobs that may be claimed.
    pub waiting: String,
    /// Expression for the rank of the job's owner. Empty if all owners have the same rank.
    pub rank: String,
    pub later_owners: String,
    pub except: String,
}

impl Preference {
    /// Returns the order of the queue. The parameter `owners` of a statement has [`Order::later_owners`], and the
    /// parameter `except` has [`Order::except`].
    pub(super) fn order(&self, tx: &Tx<'_>, owners: &str, except: &str) -> Order {
        let waiting = match (self.except.is_empty(), tx.is_postgres()) {
            (true, _) => "status = 'queued'".into(),
            (false, true) => {
                format!("status = 'queued' AND id NOT IN (SELECT jsonb_array_elements_text(CAST({except} AS jsonb)))")
            }
            (false, false) => format!("status = 'queued' AND id NOT IN (SELECT value FROM json_each({except}))"),
        };
        let rank = match (self.later_owners.is_empty(), tx.is_postgres()) {
            (true, _) => String::new(),
            (false, true) => format!(
                "coalesce(CAST(array_position(ARRAY(SELECT jsonb_array_elements_text(CAST({owners} AS jsonb))), owner) \
                 AS BIGINT), 0)"
            ),
            (false, false) => format!("coalesce((SELECT key + 1 FROM json_each({owners}) WHERE value = owner), 0)"),
        };
        Order {
            waiting,
            rank,
            later_owners: json!(self.later_owners).to_string(),
            except: json!(self.except).to_string(),
        }
    }
}

impl Order {
    /// Returns the columns by which the queue is sorted.
    pub(super) fn columns(&self) -> String {
        if self.rank.is_empty() { "turn, id".into() } else { format!("{}, turn, id", self.rank) }
    }
}

/// An owner whose jobs wait, and the least memory that one of them takes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WaitingOwner {
    pub owner: String,
    pub memory_bytes: u64,
}

/// Returns the owners with jobs that were submitted at least `age` ago and wait.
pub(super) fn waiting_owners(tx: &mut Tx<'_>, age: Duration) -> Result<Vec<WaitingOwner>> {
    let text = "SELECT owner, min(memory_bytes) AS memory_bytes FROM jobs \
                WHERE status = 'queued' AND created_at <= now_ms() - $1 GROUP BY owner";
    let rows = tx.rows(text, &[milliseconds(age).into()])?;
    let read = |row: &Row| {
        Ok(WaitingOwner { owner: row.get("owner")?, memory_bytes: row.get::<i64>("memory_bytes")?.unsigned_abs() })
    };
    rows.iter().map(read).collect()
}

/// Returns the number of jobs that wait.
pub(super) fn length(tx: &mut Tx<'_>) -> Result<i64> {
    tx.one("SELECT count(*) AS queued FROM jobs WHERE status = 'queued'", &[])?.get("queued")
}
