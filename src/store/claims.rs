//! Claims: a worker claims a job with an attempt number and a lease, renews the lease, reports progress, and ends the
//! attempt or hands the job back. Every write by a worker carries the attempt number and changes nothing once the job
//! has moved on.

use std::time::Duration;

use serde_json::json;

use super::history::{ending, history_line};
use super::jobs::{Outcome, Sharing, release_source};
use super::queue::{Order, Preference};
use super::results::{self, Prepared};
use super::tx::{Row, Tx};
use super::value::Value;
use super::{Result, StoreError, StoreOptions, limit, milliseconds};
use crate::status::Status;

/// A job that the claimer now works on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claimed {
    pub id: String,
    pub kind: String,
    pub owner: Option<String>,
    pub request: Vec<u8>,
    /// Name of the result from which the request begins.
    pub source: Option<Vec<u8>>,
    pub attempt: i64,
    /// Time since the job was submitted.
    pub waited_ms: i64,
    /// Estimate of the memory that solving takes.
    pub memory_bytes: u64,
}

/// Result of renewing a lease or reporting progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Renewed {
    Held,
    /// The job was cancelled.
    Cancelled,
    /// The lease ran out and the job moved on, or the job was deleted.
    Lost,
}

/// SQL condition for running jobs whose lease has run out. `$1` is the longest lease, in ms, that this process may
/// judge (see `contact.rs`). A lease that ends more than twice its length in the future was given by a clock that
/// has since been set back, so it counts as run out too. Smaller steps back do no harm.
const LEASE_EXPIRED: &str =
    "status = 'running' AND ((lease_until <= now_ms() AND lease_ms <= $1) OR lease_until > now_ms() + 2 * lease_ms)";

/// Largest number of lost leases that one transaction handles.
const RECOVERY_STEP: i64 = 100;

/// Number of jobs that may be claimed before a job that does not fit into the free memory. After that many, memory is
/// left free until the job fits.
const MAX_OVERTAKEN: i64 = 16;

/// Limits on the memory of a job that a worker may claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Room {
    /// Number of bytes that the worker's process has left for jobs.
    pub free_bytes: u64,
    /// Largest number of bytes of a job that this worker solves.
    pub most_bytes: u64,
}

impl Room {
    /// Room for every job.
    pub const ANY: Self = Self { free_bytes: u64::MAX, most_bytes: u64::MAX };

    fn bytes(self) -> i64 {
        limit(self.free_bytes.min(self.most_bytes))
    }
}

/// SQL condition for waiting jobs that no worker could read for too long. `$1` is the patience in ms.
const UNREAD_FOR_TOO_LONG: &str = "status = 'queued' AND unread_since <= now_ms() - $1";

/// Returns two flags: whether jobs are to be recovered, because a lease of at most `lease_max_ms` has run out or no
/// worker could read a job for too long; and whether a queued job fits into `room`.
pub(super) fn pending_work(
    tx: &mut Tx<'_>,
    lease_max_ms: i64,
    room: Room,
    preference: &Preference,
    options: &StoreOptions,
) -> Result<(bool, bool)> {
    let lost = format!("SELECT 1 FROM jobs WHERE {LEASE_EXPIRED} LIMIT 1");
    let unread = format!("SELECT 1 FROM jobs WHERE {UNREAD_FOR_TOO_LONG} LIMIT 1");
    let due = tx.exists(&lost, &[lease_max_ms.into()])?
        || tx.exists(&unread, &[milliseconds(options.unread_patience).into()])?;
    let order = preference.order(tx, "$3", "$2");
    let waiting = format!("SELECT 1 FROM jobs WHERE {} AND memory_bytes <= $1 LIMIT 1", order.waiting);
    Ok((due, tx.exists(&waiting, &[room.bytes().into(), (&order.except).into()])?))
}

/// Claims the first job in the queue for which there is room. It may overtake a job that does not fit into the free
/// memory, but only [`MAX_OVERTAKEN`] jobs may.
pub(super) fn claim(
    tx: &mut Tx<'_>,
    worker: &str,
    lease: Duration,
    room: Room,
    preference: &Preference,
) -> Result<Option<Claimed>> {
    let order = preference.order(tx, "$4", "$5");
    let (waiting, columns) = (&order.waiting, order.columns());
    let first = format!("SELECT id FROM jobs WHERE {waiting} ORDER BY {columns} LIMIT 1 /* skip locked */");
    if let Some(claimed) = claim_chosen(tx, &first, worker, lease, room, &order)? {
        return Ok(Some(claimed));
    }
    let rank = if order.rank.is_empty() { "CAST(0 AS BIGINT)" } else { &order.rank };
    let fitting = |selected: &str| {
        format!(
            "SELECT {selected} FROM jobs WHERE {waiting} AND memory_bytes <= $3 \
             ORDER BY {columns} LIMIT 1 /* skip locked */"
        )
    };
    let values: [Value<'_>; 5] =
        [0.into(), 0.into(), room.bytes().into(), (&order.later_owners).into(), (&order.except).into()];
    let Some(row) = tx.row(&fitting(&format!("id, turn, {rank} AS rank")), &values)? else { return Ok(None) };
    let (id, turn): (String, i64) = (row.get("id")?, row.get("turn")?);
    let ahead = if order.rank.is_empty() {
        "(turn, id) < ($2, $1)".to_owned()
    } else {
        format!("({rank}, turn, id) < ($6, $2, $1)")
    };
    let too_large = format!(
        "SELECT id, overtaken FROM jobs WHERE {waiting} AND memory_bytes > $3 AND {ahead} \
         ORDER BY {columns} LIMIT 1 /* skip locked */"
    );
    let values = [
        (&id).into(),
        turn.into(),
        limit(room.free_bytes).into(),
        (&order.later_owners).into(),
        (&order.except).into(),
        row.get::<i64>("rank")?.into(),
    ];
    let overtaken = tx.row(&too_large, &values)?;
    if let Some(row) = overtaken {
        if row.get::<i64>("overtaken")? >= MAX_OVERTAKEN {
            return Ok(None);
        }
        let overtaken: String = row.get("id")?;
        tx.execute("UPDATE jobs SET overtaken = overtaken + 1 WHERE id = $1", &[(&overtaken).into()])?;
    }
    claim_chosen(tx, &fitting("id"), worker, lease, room, &order)
}

/// Columns of a claimed job that [`claimed`] reads.
const CLAIMED: &str = "id, kind, owner, attempt, memory_bytes, now_ms() - created_at AS waited";

/// Claims the job that the query `chosen` selects, if the job fits into `room` (`$3`).
fn claim_chosen(
    tx: &mut Tx<'_>,
    chosen: &str,
    worker: &str,
    lease: Duration,
    room: Room,
    order: &Order,
) -> Result<Option<Claimed>> {
    let text = format!(
        "UPDATE jobs SET status = 'running', attempt = attempt + 1, sequence = sequence + 1, worker = $1, \
         lease_until = now_ms() + $2, lease_ms = $2, started_at = now_ms(), progress = NULL, progress_sequence = 0, \
         history = {} \
         WHERE id = ({chosen}) AND memory_bytes <= $3 \
         RETURNING {CLAIMED}",
        history_line("(attempt + 1)", Status::Running)
    );
    let values = [
        worker.into(),
        milliseconds(lease).into(),
        room.bytes().into(),
        (&order.later_owners).into(),
        (&order.except).into(),
    ];
    let Some(row) = tx.row(&text, &values)? else { return Ok(None) };
    claimed(tx, &row).map(Some)
}

/// Returns the running job that was claimed under the name `worker`, if there is one, and extends its lease.
pub(super) fn claimed_by(tx: &mut Tx<'_>, worker: &str, lease: Duration) -> Result<Option<Claimed>> {
    let text = format!(
        "UPDATE jobs SET lease_until = now_ms() + $2, lease_ms = $2 WHERE worker = $1 AND status = 'running' \
         RETURNING {CLAIMED}"
    );
    let Some(row) = tx.row(&text, &[worker.into(), milliseconds(lease).into()])? else { return Ok(None) };
    claimed(tx, &row).map(Some)
}

fn claimed(tx: &mut Tx<'_>, row: &Row) -> Result<Claimed> {
    let id: String = row.get("id")?;
    let request = tx
        .row("SELECT body, source FROM requests WHERE job_id = $1", &[(&id).into()])?
        .ok_or_else(|| StoreError::Internal(format!("job {id} has no request")))?;
    tx.changed(&id);
    Ok(Claimed {
        id,
        kind: row.get("kind")?,
        owner: row.owner()?,
        request: request.get("body")?,
        source: request.get("source")?,
        attempt: row.get("attempt")?,
        waited_ms: row.get::<i64>("waited")?.max(0),
        memory_bytes: row.get::<i64>("memory_bytes")?.unsigned_abs(),
    })
}

/// Extends the lease if the worker still holds the job.
pub(super) fn renew(tx: &mut Tx<'_>, id: &str, attempt: i64, lease: Duration) -> Result<Renewed> {
    let text = "UPDATE jobs SET lease_until = now_ms() + $3, lease_ms = $3 \
                WHERE id = $1 AND attempt = $2 AND status = 'running'";
    update_if_held(tx, text, id, attempt, milliseconds(lease).into())
}

/// Stores the latest progress (JSON text) if the worker still holds the job.
pub(super) fn progress(tx: &mut Tx<'_>, id: &str, attempt: i64, progress: &str) -> Result<Renewed> {
    let text = "UPDATE jobs SET progress = $3, sequence = sequence + 1, progress_sequence = sequence + 1 \
                WHERE id = $1 AND attempt = $2 AND status = 'running'";
    let renewed = update_if_held(tx, text, id, attempt, progress.into())?;
    if renewed == Renewed::Held {
        tx.changed(id);
    }
    Ok(renewed)
}

/// Runs an update that applies only while the worker holds the job.
fn update_if_held(tx: &mut Tx<'_>, text: &str, id: &str, attempt: i64, value: Value<'_>) -> Result<Renewed> {
    if tx.execute(text, &[id.into(), attempt.into(), value])? > 0 {
        return Ok(Renewed::Held);
    }
    take_back_loss(tx, id, attempt)?;
    let cancelled = "SELECT 1 FROM jobs WHERE id = $1 AND attempt = $2 AND status = 'cancelled'";
    Ok(if tx.exists(cancelled, &[id.into(), attempt.into()])? { Renewed::Cancelled } else { Renewed::Lost })
}

/// Ends the attempt. If an earlier call has already stored this outcome, changes nothing and returns true: the
/// connection may have been lost after the commit, so that the worker did not learn of it. If the worker had lost the
/// job, changes nothing and returns false.
pub(super) fn finish(
    tx: &mut Tx<'_>,
    id: &str,
    attempt: i64,
    outcome: &Outcome,
    result: Option<&Prepared>,
    options: &StoreOptions,
) -> Result<bool> {
    let retention = milliseconds(options.retention);
    let fence = "WHERE id = $1 AND attempt = $3 AND status = 'running'";
    let changed = match (outcome, result) {
        (Outcome::Succeeded { statistics, summary, warnings, reusable, .. }, Some(result)) => {
            let text = format!(
                "UPDATE jobs SET {}, statistics = $4, warnings = $5, artefact = $6, summary = $8, \
                 sharing = CASE sharing WHEN 'undecided' THEN $7 ELSE sharing END {fence}",
                ending(Status::Succeeded)
            );
            let sharing = if *reusable { Sharing::Allowed } else { Sharing::Refused };
            let values = [
                id.into(),
                retention.into(),
                attempt.into(),
                statistics.into(),
                warnings.into(),
                (&result.hash).into(),
                sharing.name().into(),
                summary.into(),
            ];
            tx.execute(&text, &values)?
        }
        (Outcome::Succeeded { .. }, None) => {
            return Err(StoreError::Internal("a success without a prepared result".into()));
        }
        (Outcome::Failed { error }, _) => {
            let text = format!("UPDATE jobs SET {}, error = $4 {fence}", ending(Status::Failed));
            tx.execute(&text, &[id.into(), retention.into(), attempt.into(), error.into()])?
        }
    };
    if changed == 0 {
        // A repeated call uses the same file name, so a row may already name this file. Then the file is kept.
        let file = result.and_then(|result| result.file.as_deref());
        if let Some(file) = file
            && !results::is_named(tx, file)?
        {
            tx.drop_file(Some(file.to_owned()));
        }
        take_back_loss(tx, id, attempt)?;
        return has_ended_with(tx, id, attempt, outcome, result);
    }
    if let (Outcome::Succeeded { artefact, .. }, Some(result)) = (outcome, result) {
        results::keep(tx, result, artefact)?;
    }
    release_source(tx, id)?;
    tx.changed(id);
    Ok(true)
}

/// Returns true if the attempt with the number `attempt` has ended with this outcome.
fn has_ended_with(
    tx: &mut Tx<'_>,
    id: &str,
    attempt: i64,
    outcome: &Outcome,
    result: Option<&Prepared>,
) -> Result<bool> {
    let text = "SELECT error, artefact FROM jobs WHERE id = $1 AND attempt = $2 AND status = $3";
    let Some(row) = tx.row(text, &[id.into(), attempt.into(), outcome.status().name().into()])? else {
        return Ok(false);
    };
    Ok(match outcome {
        Outcome::Succeeded { .. } => {
            let stored: Option<Vec<u8>> = row.get("artefact")?;
            stored.zip(result).is_some_and(|(name, result)| results::have_equal_bytes(&name, &result.hash))
        }
        Outcome::Failed { error } => row.get::<Option<String>>("error")?.as_ref() == Some(error),
    })
}

/// SQL assignments that put a running job back to its old place in the queue.
fn requeueing() -> String {
    format!(
        "status = 'queued', sequence = sequence + 1, worker = NULL, lease_until = NULL, started_at = NULL, \
         history = {}",
        history_line("attempt", Status::Queued)
    )
}

/// Puts a running job back into the queue without counting a lost lease. Returns false if the worker had lost the job.
pub(super) fn hand_back(tx: &mut Tx<'_>, id: &str, attempt: i64) -> Result<bool> {
    let text = format!("UPDATE jobs SET {} WHERE id = $1 AND attempt = $2 AND status = 'running'", requeueing());
    if tx.execute(&text, &[id.into(), attempt.into()])? == 0 {
        return Ok(false);
    }
    tx.changed(id);
    tx.work_available();
    Ok(true)
}

/// Same as [`hand_back`], for a job whose request the worker's version cannot read. If no other worker can read it in
/// time, the job fails with `error` (JSON text).
pub(super) fn hand_back_unread(tx: &mut Tx<'_>, id: &str, attempt: i64, error: &str) -> Result<bool> {
    let text = "UPDATE jobs SET unread_since = coalesce(unread_since, now_ms()), unread_error = $3 \
                WHERE id = $1 AND attempt = $2 AND status = 'running'";
    tx.execute(text, &[id.into(), attempt.into(), error.into()])?;
    hand_back(tx, id, attempt)
}

/// Jobs that have lost their workers, or that no worker could read.
#[derive(Debug, Default)]
pub(super) struct Recovered {
    /// Number of these jobs.
    pub jobs: usize,
    /// Those of them that have failed.
    pub failed: Vec<FailedJob>,
}

/// A job that has failed without a worker.
#[derive(Debug)]
pub struct FailedJob {
    pub id: String,
    pub kind: String,
    /// The error as JSON text.
    pub error: String,
}

/// Fails jobs that no worker could read for too long.
fn fail_unread(tx: &mut Tx<'_>, options: &StoreOptions) -> Result<Vec<FailedJob>> {
    let text = format!(
        "UPDATE jobs SET {}, error = unread_error WHERE {UNREAD_FOR_TOO_LONG} RETURNING id, kind, error",
        ending(Status::Failed)
    );
    let values = [milliseconds(options.unread_patience).into(), milliseconds(options.retention).into()];
    let mut failed = Vec::new();
    for row in &tx.rows(&text, &values)? {
        let job = FailedJob { id: row.get("id")?, kind: row.get("kind")?, error: row.get("error")? };
        release_source(tx, &job.id)?;
        tx.changed(&job.id);
        failed.push(job);
    }
    Ok(failed)
}

/// Beginning of the line that describes the loss of an attempt.
fn loss_of(attempt: i64) -> String {
    format!("attempt {attempt} on ")
}

/// Takes back the recorded loss of an attempt whose worker turns out to be alive. That worker could not reach the
/// database while its lease ran out. The job stays with the attempt that took it over.
fn take_back_loss(tx: &mut Tx<'_>, id: &str, attempt: i64) -> Result<()> {
    let text = "SELECT losses FROM jobs WHERE id = $1 AND lost_leases > 0 AND status IN ('queued', 'running')";
    let Some(row) = tx.row(text, &[id.into()])? else { return Ok(()) };
    let (losses, lost) = (row.get::<String>("losses")?, loss_of(attempt));
    let others: String = losses.split_inclusive('\n').filter(|line| !line.starts_with(&lost)).collect();
    if others == losses {
        return Ok(());
    }
    // The comparison leaves the losses alone if they have changed since they were read.
    let text = "UPDATE jobs SET lost_leases = lost_leases - 1, losses = $3 WHERE id = $1 AND losses = $2";
    tx.execute(text, &[id.into(), (&losses).into(), (&others).into()]).map(|_| ())
}

/// Puts jobs whose lease of at most `lease_max_ms` has run out back into the queue. A job whose lease has run out too
/// often fails instead, and so does a job that no worker could read for too long.
///
/// `outage_ms` is the time since the last outage of the database ended, if this process has seen one. A worker that has
/// not renewed its lease since then may have been stopped because of the outage, so its loss is not counted.
pub(super) fn recover(
    tx: &mut Tx<'_>,
    lease_max_ms: i64,
    outage_ms: Option<i64>,
    options: &StoreOptions,
) -> Result<Recovered> {
    let mut failed = Vec::new();
    let lost = tx.rows(
        &format!(
            "SELECT id, kind, attempt, lost_leases, worker, progress, losses, now_ms() - started_at AS ran, \
             now_ms() - lease_until + lease_ms AS silent \
             FROM jobs WHERE {LEASE_EXPIRED} ORDER BY lease_until LIMIT $2 /* skip locked */"
        ),
        &[lease_max_ms.into(), RECOVERY_STEP.into()],
    )?;
    for row in &lost {
        let (id, attempt): (String, i64) = (row.get("id")?, row.get("attempt")?);
        if outage_ms.is_some_and(|ended| row.get::<i64>("silent").is_ok_and(|silent| silent > ended)) {
            hand_back(tx, &id, attempt)?;
            continue;
        }
        let count = row.get::<i64>("lost_leases")? + 1;
        let losses = format!(
            "{}{}{} was lost after at most {:.1} s, last progress {}\n",
            row.get::<String>("losses")?,
            loss_of(attempt),
            row.get::<Option<String>>("worker")?.as_deref().unwrap_or("an unknown worker"),
            row.get::<i64>("ran")?.max(0) as f64 / 1000.0,
            row.get::<Option<String>>("progress")?.as_deref().unwrap_or("none")
        );
        let fence = "WHERE id = $1 AND attempt = $3";
        if count < i64::from(options.max_attempts) {
            let text = format!("UPDATE jobs SET {}, lost_leases = $2, losses = $4 {fence}", requeueing());
            tx.execute(&text, &[(&id).into(), count.into(), attempt.into(), (&losses).into()])?;
            tx.work_available();
        } else {
            let error = workers_lost(count, &losses);
            let text = format!(
                "UPDATE jobs SET {}, lost_leases = $4, losses = $5, error = $6 {fence}",
                ending(Status::Failed)
            );
            let retention = milliseconds(options.retention);
            let values =
                [(&id).into(), retention.into(), attempt.into(), count.into(), (&losses).into(), (&error).into()];
            tx.execute(&text, &values)?;
            release_source(tx, &id)?;
            failed.push(FailedJob { id: id.clone(), kind: row.get("kind")?, error });
        }
        tx.changed(&id);
    }
    let unread = fail_unread(tx, options)?;
    let jobs = lost.len() + unread.len();
    failed.extend(unread);
    Ok(Recovered { jobs, failed })
}

/// Returns the error, as JSON text, of a job whose workers keep dying.
fn workers_lost(count: i64, losses: &str) -> String {
    let error = json!({
        "type": "/problems/worker-lost",
        "title": "The workers of this job died",
        "detail": format!(
            "{count} workers in a row stopped without an answer while solving this job, so it is not tried \
             again. Ask for fewer triangles or iterations, or tell the operator:\n{losses}"
        ),
        "errors": [],
    });
    error.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::job::JobFailure;
    use plateau_engine::report::SolveError;

    #[test]
    fn the_error_of_lost_workers_is_the_one_of_the_catalogue() {
        let error: SolveError = serde_json::from_str(&workers_lost(3, "first\nsecond")).unwrap();
        let expected = JobFailure::WorkerLost.error(error.detail.clone(), Vec::new());
        assert_eq!(error, expected);
    }
}
