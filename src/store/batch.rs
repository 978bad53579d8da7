//! Batches: jobs that were submitted together. Each is a job like any other; the batch says which they are. A batch is gone
//! when its last job is.

use std::sync::Arc;

use super::engine::Result;
use super::queue::{NewJob, Submitted, bounded, drop_request, ending, submit};
use super::record::{COLUMNS, JobRow, Status};
use super::sql::{Connection, Row, Value};
use super::{Store, StoreError, milliseconds};

/// A batch to be. Its jobs are put on disk together or not at all; their own idempotency keys are not used.
#[derive(Debug, Clone)]
pub struct NewBatch {
    /// Unique, sorting by time.
    pub id: String,
    pub owner: Option<String>,
    /// Unique per owner for as long as the batch is kept.
    pub idempotency_key: Option<String>,
    /// What a second submission with the same idempotency key is compared by.
    pub body_hash: [u8; 32],
    /// Told once every job has ended.
    pub callback_url: Option<String>,
    pub jobs: Vec<NewJob>,
}

/// What became of a batch's submission.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SubmittedBatch {
    Created(BatchRow),
    /// The batch that the same idempotency key and body made before.
    Existing(BatchRow),
    /// The idempotency key was used with another body.
    KeyConflict,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BatchRow {
    pub id: String,
    pub created_at_ms: i64,
    /// Jobs at submission; some may have been removed since.
    pub size: i64,
    /// In the order of the submission.
    pub jobs: Vec<BatchJob>,
}

/// A job of a batch, in short.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BatchJob {
    pub index: i64,
    pub id: String,
    pub kind: String,
    pub status: Status,
    pub finished_at_ms: Option<i64>,
}

/// What became of a batch's id.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BatchLookup {
    Found(BatchRow),
    /// It was there; its time has run out.
    Expired,
    /// Never there, deleted, or another owner's.
    Missing,
}

const JOBS: &str = "SELECT batch_index, id, kind, status, finished_at FROM jobs WHERE batch = $1 ORDER BY batch_index";

impl BatchJob {
    fn read(row: &Row) -> Result<Self> {
        Ok(Self {
            index: row.int(0)?,
            id: row.text(1)?,
            kind: row.text(2)?,
            status: row.text(3)?.parse()?,
            finished_at_ms: row.optional_int(4)?,
        })
    }
}

impl Store {
    /// Puts a batch on disk, whole. Refuses with `QueueFull` if not all of its jobs find a place in the queue.
    pub async fn submit_batch(&self, batch: NewBatch) -> Result<SubmittedBatch> {
        let (store, batch) = (self.clone(), Arc::new(batch));
        let submitted = self
            .inner
            .engine
            .write(move |connection| {
                let (store, batch) = (store.clone(), Arc::clone(&batch));
                Box::pin(async move {
                    if let Some(earlier) = earlier_batch(connection, &batch).await? {
                        return Ok(earlier);
                    }
                    let text = "INSERT INTO batches (id, owner, created_at, size, idempotency_key, body_hash, \
                                callback_url) VALUES ($1, $2, now_ms(), $3, $4, $5, $6)";
                    let values = vec![
                        batch.id.as_str().into(),
                        batch.owner.as_deref().unwrap_or_default().into(),
                        bounded(batch.jobs.len() as u64).into(),
                        batch.idempotency_key.clone().into(),
                        batch.body_hash.as_slice().into(),
                        batch.callback_url.clone().into(),
                    ];
                    connection.execute(text, values).await?;
                    for (index, job) in batch.jobs.iter().enumerate() {
                        let place = Some((batch.id.as_str(), bounded(index as u64)));
                        match submit(connection, job, place, store.options()).await? {
                            Submitted::Created(_) => {}
                            Submitted::Existing(_) | Submitted::KeyConflict => {
                                return Err(StoreError::Internal("a batch's job with a key of its own".into()));
                            }
                        }
                    }
                    let row = read(connection, &batch.id, batch.owner.as_deref()).await?;
                    let row = row.ok_or_else(|| StoreError::Internal("a batch vanished in its transaction".into()))?;
                    Ok(SubmittedBatch::Created(row))
                })
            })
            .await?;
        if matches!(submitted, SubmittedBatch::Created(_)) {
            self.inner.changes.work();
        }
        Ok(submitted)
    }

    pub async fn batch(&self, id: &str, owner: Option<&str>) -> Result<BatchLookup> {
        let engine = &self.inner.engine;
        let key: Vec<Value> = vec![id.into(), owner.unwrap_or_default().into()];
        if let Some(row) = engine.row(BATCH, key.clone()).await? {
            let jobs = engine.rows(JOBS, vec![id.into()]).await?;
            let jobs = jobs.iter().map(BatchJob::read).collect::<Result<Vec<_>>>()?;
            if !jobs.is_empty() {
                return Ok(BatchLookup::Found(batch_row(id, &row, jobs)?));
            }
            return Ok(BatchLookup::Expired);
        }
        let gone = "SELECT 1 FROM expired_jobs WHERE id = $1 AND ($2 = '' OR owner = $2)";
        Ok(if engine.row(gone, key).await?.is_some() { BatchLookup::Expired } else { BatchLookup::Missing })
    }

    /// Cancels every job of a batch that has not ended. Gives the batch, and the ids of the jobs it cancelled.
    pub async fn cancel_batch(&self, id: &str, owner: Option<&str>) -> Result<(BatchLookup, Vec<String>)> {
        let text = format!(
            "UPDATE jobs SET {} WHERE batch = $1 AND ($3 = '' OR owner = $3) AND status IN ('queued', 'running') \
             RETURNING id",
            ending(Status::Cancelled)
        );
        let retention = milliseconds(self.inner.options.retention);
        let values: Vec<Value> = vec![id.into(), retention.into(), owner.unwrap_or_default().into()];
        let cancelled = self
            .inner
            .engine
            .write(move |connection| {
                let (text, values) = (text.clone(), values.clone());
                Box::pin(async move {
                    let mut ids = Vec::new();
                    for row in connection.rows(&text, values).await? {
                        ids.push(row.text(0)?);
                    }
                    for id in &ids {
                        drop_request(connection, id).await?;
                    }
                    Ok(ids)
                })
            })
            .await?;
        for id in &cancelled {
            self.inner.changes.changed(id);
        }
        Ok((self.batch(id, owner).await?, cancelled))
    }

    /// Removes a batch with its jobs, whatever their status. Gives the ids of the jobs; `None` if there was no such batch.
    pub async fn delete_batch(&self, id: &str, owner: Option<&str>) -> Result<Option<Vec<String>>> {
        let values: Vec<Value> = vec![id.into(), owner.unwrap_or_default().into()];
        let deleted = self
            .inner
            .engine
            .write(move |connection| {
                let values = values.clone();
                Box::pin(async move {
                    let key = values[..1].to_vec();
                    let text = "DELETE FROM batches WHERE id = $1 AND ($2 = '' OR owner = $2)";
                    if connection.execute(text, values).await? == 0 {
                        return Ok(None);
                    }
                    let mut ids = Vec::new();
                    for row in connection.rows("DELETE FROM jobs WHERE batch = $1 RETURNING id", key).await? {
                        let id = row.text(0)?;
                        drop_request(connection, &id).await?;
                        ids.push(id);
                    }
                    Ok(Some(ids))
                })
            })
            .await?;
        for id in deleted.iter().flatten() {
            self.inner.changes.changed(id);
        }
        Ok(deleted)
    }

    /// The jobs of a batch with all that is known of them, in the order of the submission.
    pub async fn batch_jobs(&self, id: &str) -> Result<Vec<(i64, JobRow)>> {
        let text = format!("SELECT {COLUMNS}, batch_index FROM jobs WHERE batch = $1 ORDER BY batch_index");
        let rows = self.inner.engine.rows(&text, vec![id.into()]).await?;
        rows.iter().map(|row| Ok((row.int(17)?, JobRow::read(row)?))).collect()
    }

    /// Remembers batches without jobs as expired.
    pub(super) async fn sweep_batches(&self) -> Result<()> {
        self.inner
            .engine
            .write(|connection| {
                Box::pin(async move {
                    let empty = "SELECT id FROM batches WHERE NOT EXISTS (SELECT 1 FROM jobs WHERE batch = batches.id) \
                                 LIMIT 200 /* skip locked */";
                    for row in connection.rows(empty, Vec::new()).await? {
                        let id = row.text(0)?;
                        let remember = "INSERT INTO expired_jobs (id, owner, expired_at) \
                                        SELECT id, owner, now_ms() FROM batches WHERE id = $1 ON CONFLICT DO NOTHING";
                        connection.execute(remember, vec![id.as_str().into()]).await?;
                        connection.execute("DELETE FROM batches WHERE id = $1", vec![id.as_str().into()]).await?;
                    }
                    Ok(())
                })
            })
            .await
    }
}

const BATCH: &str = "SELECT created_at, size FROM batches WHERE id = $1 AND ($2 = '' OR owner = $2)";

fn batch_row(id: &str, row: &Row, jobs: Vec<BatchJob>) -> Result<BatchRow> {
    Ok(BatchRow { id: id.to_owned(), created_at_ms: row.int(0)?, size: row.int(1)?, jobs })
}

async fn read(connection: &mut Connection<'_>, id: &str, owner: Option<&str>) -> Result<Option<BatchRow>> {
    let key = vec![id.into(), owner.unwrap_or_default().into()];
    let Some(row) = connection.row(BATCH, key).await? else { return Ok(None) };
    let jobs = connection.rows(JOBS, vec![id.into()]).await?;
    batch_row(id, &row, jobs.iter().map(BatchJob::read).collect::<Result<_>>()?).map(Some)
}

async fn earlier_batch(connection: &mut Connection<'_>, batch: &NewBatch) -> Result<Option<SubmittedBatch>> {
    let Some(key) = &batch.idempotency_key else { return Ok(None) };
    let owner = batch.owner.as_deref();
    let text = "SELECT id, body_hash FROM batches WHERE owner = $1 AND idempotency_key = $2";
    let values = vec![owner.unwrap_or_default().into(), key.as_str().into()];
    let Some(row) = connection.row(text, values).await? else { return Ok(None) };
    if row.bytes(1)? != batch.body_hash {
        return Ok(Some(SubmittedBatch::KeyConflict));
    }
    Ok(read(connection, &row.text(0)?, owner).await?.map(SubmittedBatch::Existing))
}
