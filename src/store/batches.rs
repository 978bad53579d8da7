//! Batches: jobs that were submitted together. Each is an ordinary job whose row names its batch. A batch disappears
//! with its last job.

use super::callbacks::host_of;
use super::history::{ending, read_status};
use super::jobs::{self, Addition, BatchPlace, COLUMNS, JobRow, NewJob, drop_request, release_source};
use super::tx::{Row, Tx};
use super::{Result, StoreError, StoreOptions, limit, milliseconds};
use crate::status::{CancelReason, Status};

/// A batch that has not been stored yet. Its jobs are stored together or not at all, and must have no idempotency keys
/// of their own.
#[derive(Debug, Clone)]
pub struct NewBatch {
    /// Unique identifier that sorts by time.
    pub id: String,
    pub owner: Option<String>,
    /// Unique per owner for as long as the batch is kept.
    pub idempotency_key: Option<String>,
    /// Hash that is compared with a later submission of the same idempotency key.
    pub body_hash: [u8; 32],
    /// Receives a message once every job has ended.
    pub callback_url: Option<String>,
    pub jobs: Vec<NewJob>,
}

/// Result of submitting a batch.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BatchAddition {
    Created(BatchRow),
    /// An earlier submission with the same idempotency key and body created this batch.
    Existing(BatchRow),
    /// The idempotency key was used with another body.
    KeyConflict,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BatchRow {
    pub id: String,
    pub created_at_ms: i64,
    /// Number of jobs at submission; some may have been removed since.
    pub size: i64,
    /// Jobs in the order of the submission.
    pub jobs: Vec<BatchJob>,
}

/// Short form of a job of a batch.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BatchJob {
    pub index: i64,
    pub id: String,
    pub kind: String,
    pub status: Status,
    pub finished_at_ms: Option<i64>,
    /// True if the job's request is kept.
    pub has_request: bool,
}

/// Result of looking up a batch.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BatchLookup {
    Found(BatchRow),
    /// The batch existed and has expired.
    Expired,
    /// The batch never existed, was deleted, or belongs to another owner.
    Missing,
}

impl BatchJob {
    fn read(row: &Row) -> Result<Self> {
        Ok(Self {
            index: row.get("batch_index")?,
            id: row.get("id")?,
            kind: row.get("kind")?,
            status: read_status(row)?,
            finished_at_ms: row.get("finished_at")?,
            has_request: row.get::<i64>("request_bytes")? > 0,
        })
    }
}

/// Stores a batch as a whole. Fails with `QueueFull` if the queue has no room for all of its jobs.
pub(super) fn add(tx: &mut Tx<'_>, batch: &NewBatch, options: &StoreOptions) -> Result<BatchAddition> {
    let owner = batch.owner.as_deref();
    if let Some(earlier) = earlier_batch(tx, batch)? {
        return Ok(earlier);
    }
    let now_ms = tx.now_ms()?;
    tx.insert(
        "batches",
        &[
            ("id", (&batch.id).into()),
            ("owner", owner.unwrap_or_default().into()),
            ("created_at", now_ms.into()),
            ("size", limit(batch.jobs.len() as u64).into()),
            ("idempotency_key", batch.idempotency_key.as_deref().into()),
            ("body_hash", (&batch.body_hash).into()),
            ("callback_url", batch.callback_url.as_deref().into()),
            ("callback_host", batch.callback_url.as_deref().map(host_of).as_deref().into()),
        ],
    )?;
    for (index, job) in batch.jobs.iter().enumerate() {
        let place = BatchPlace { batch: &batch.id, index: limit(index as u64) };
        let Addition::Created(..) = jobs::add(tx, job, Some(place), None, options)? else {
            return Err(StoreError::Internal("a job of a batch has an idempotency key of its own".into()));
        };
    }
    match find(tx, &batch.id, owner)? {
        Some(row) => Ok(BatchAddition::Created(row)),
        None => Err(StoreError::Internal("a batch vanished in its transaction".into())),
    }
}

fn earlier_batch(tx: &mut Tx<'_>, batch: &NewBatch) -> Result<Option<BatchAddition>> {
    let Some(key) = &batch.idempotency_key else { return Ok(None) };
    let owner = batch.owner.as_deref();
    let text = "SELECT id, body_hash FROM batches WHERE owner = $1 AND idempotency_key = $2";
    let Some(row) = tx.row(text, &[owner.unwrap_or_default().into(), key.into()])? else { return Ok(None) };
    if row.get::<Vec<u8>>("body_hash")? != batch.body_hash {
        return Ok(Some(BatchAddition::KeyConflict));
    }
    Ok(find(tx, &row.get::<String>("id")?, owner)?.map(BatchAddition::Existing))
}

fn find(tx: &mut Tx<'_>, id: &str, owner: Option<&str>) -> Result<Option<BatchRow>> {
    let text = "SELECT created_at, size FROM batches WHERE id = $1 AND ($2 = '' OR owner = $2)";
    let Some(row) = tx.row(text, &[id.into(), owner.unwrap_or_default().into()])? else { return Ok(None) };
    let jobs = "SELECT batch_index, id, kind, status, finished_at, request_bytes FROM jobs \
                WHERE batch = $1 ORDER BY batch_index";
    let jobs = tx.rows(jobs, &[id.into()])?;
    Ok(Some(BatchRow {
        id: id.to_owned(),
        created_at_ms: row.get("created_at")?,
        size: row.get("size")?,
        jobs: jobs.iter().map(BatchJob::read).collect::<Result<_>>()?,
    }))
}

pub(super) fn get(tx: &mut Tx<'_>, id: &str, owner: Option<&str>) -> Result<BatchLookup> {
    match find(tx, id, owner)? {
        // The last job is gone, but the sweep has not removed the batch yet.
        Some(batch) if batch.jobs.is_empty() => return Ok(BatchLookup::Expired),
        Some(batch) => return Ok(BatchLookup::Found(batch)),
        None => {}
    }
    let gone = "SELECT 1 FROM expired_jobs WHERE id = $1 AND ($2 = '' OR owner = $2)";
    let expired = tx.exists(gone, &[id.into(), owner.unwrap_or_default().into()])?;
    Ok(if expired { BatchLookup::Expired } else { BatchLookup::Missing })
}

/// Cancels every job of a batch that has not ended. Returns the batch and the identifiers of the jobs that it
/// cancelled.
pub(super) fn cancel(
    tx: &mut Tx<'_>,
    id: &str,
    owner: Option<&str>,
    options: &StoreOptions,
) -> Result<(BatchLookup, Vec<String>)> {
    let text = format!(
        "UPDATE jobs SET {}, cancelled_because = $4 WHERE batch = $1 AND ($3 = '' OR owner = $3) AND status IN ('queued', 'running') \
         RETURNING id",
        ending(Status::Cancelled)
    );
    let values = [
        id.into(),
        milliseconds(options.retention).into(),
        owner.unwrap_or_default().into(),
        CancelReason::Client.name().into(),
    ];
    let cancelled = ids_of(&tx.rows(&text, &values)?)?;
    for id in &cancelled {
        release_source(tx, id)?;
        tx.changed(id);
    }
    Ok((get(tx, id, owner)?, cancelled))
}

/// Removes a batch with its jobs, whatever their status. Returns the identifiers of the jobs, or `None` if the batch
/// does not exist.
pub(super) fn delete(tx: &mut Tx<'_>, id: &str, owner: Option<&str>) -> Result<Option<Vec<String>>> {
    let text = "DELETE FROM batches WHERE id = $1 AND ($2 = '' OR owner = $2)";
    if tx.execute(text, &[id.into(), owner.unwrap_or_default().into()])? == 0 {
        return Ok(None);
    }
    let removed = ids_of(&tx.rows("DELETE FROM jobs WHERE batch = $1 RETURNING id", &[id.into()])?)?;
    for id in &removed {
        drop_request(tx, id)?;
        tx.changed(id);
    }
    Ok(Some(removed))
}

fn ids_of(rows: &[Row]) -> Result<Vec<String>> {
    rows.iter().map(|row| row.get("id")).collect()
}

/// Returns the complete rows of a batch's jobs, in the order of the submission.
pub(super) fn jobs_of(tx: &mut Tx<'_>, id: &str) -> Result<Vec<(i64, JobRow)>> {
    let text = format!("SELECT {COLUMNS}, batch_index FROM jobs WHERE batch = $1 ORDER BY batch_index");
    let rows = tx.rows(&text, &[id.into()])?;
    rows.iter().map(|row| Ok((row.get("batch_index")?, JobRow::read(row)?))).collect()
}

/// Moves batches without jobs to the expired identifiers.
pub(super) fn forget_empty(tx: &mut Tx<'_>) -> Result<()> {
    let empty = "SELECT id FROM batches WHERE NOT EXISTS (SELECT 1 FROM jobs WHERE batch = batches.id) \
                 LIMIT 200 /* skip locked */";
    for row in tx.rows(empty, &[])? {
        let id: String = row.get("id")?;
        let remember = "INSERT INTO expired_jobs (id, owner, expired_at) \
                        SELECT id, owner, now_ms() FROM batches WHERE id = $1 ON CONFLICT DO NOTHING";
        tx.execute(remember, &[(&id).into()])?;
        tx.execute("DELETE FROM batches WHERE id = $1", &[(&id).into()])?;
    }
    Ok(())
}
