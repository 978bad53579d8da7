//! Results, deletion and expiry.

use std::collections::BTreeSet;

use super::engine::Result;
use super::sql::Value;
use super::{Store, StoreError, milliseconds};

/// Jobs that one transaction of the sweep removes, so that it never holds up other writes for long.
const SWEEP_STEP: i64 = 200;
/// Jobs that are expired at once to get below the byte budget.
const EVICTION_STEP: i64 = 10;

/// A stored result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Artefact {
    /// SHA-256 of `bytes`.
    pub hash: Vec<u8>,
    pub bytes: Vec<u8>,
}

/// What waits and what runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    pub queued: i64,
    pub running: i64,
    /// Age of the longest waiting job; 0 without one.
    pub longest_wait_ms: i64,
}

/// What a sweep did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Swept {
    /// Jobs that expired.
    pub expired: u64,
    /// Results that belonged to no job any more.
    pub artefacts: u64,
    /// Result files that no job ever took, because their worker died before it could say so.
    pub files: u64,
    /// Jobs whose lease had run out.
    pub recovered: usize,
}

impl Store {
    /// The result of a job that succeeded; `None` for any other id.
    pub async fn artefact(&self, id: &str, owner: Option<&str>) -> Result<Option<Artefact>> {
        let text = "SELECT artefacts.hash, artefacts.body, artefacts.file \
                    FROM jobs JOIN artefacts ON artefacts.hash = jobs.artefact \
                    WHERE jobs.id = $1 AND ($2 = '' OR jobs.owner = $2)";
        let row = self.inner.engine.row(text, vec![id.into(), owner.unwrap_or_default().into()]).await?;
        let Some(row) = row else { return Ok(None) };
        let bytes = match (row.optional_bytes(1)?, row.optional_text(2)?) {
            (Some(bytes), _) => bytes,
            (None, Some(file)) => {
                let files = self.inner.files.as_ref().ok_or_else(|| {
                    StoreError::Unavailable(format!("the result is in file {file} but store.results is not set"))
                })?;
                files.read(&file).await?
            }
            (None, None) => return Err(StoreError::Internal(format!("the result of job {id} has no bytes"))),
        };
        Ok(Some(Artefact { hash: row.bytes(0)?, bytes }))
    }

    /// Removes a job, whatever its status; its result goes with the next sweep unless another job shares it. False if
    /// there was none.
    pub async fn delete(&self, id: &str, owner: Option<&str>) -> Result<bool> {
        let values: Vec<Value> = vec![id.into(), owner.unwrap_or_default().into()];
        let deleted = self
            .inner
            .engine
            .write(move |connection| {
                let values = values.clone();
                Box::pin(async move {
                    let key = values[..1].to_vec();
                    let text = "DELETE FROM jobs WHERE id = $1 AND ($2 = '' OR owner = $2)";
                    if connection.execute(text, values).await? == 0 {
                        return Ok(false);
                    }
                    connection.execute("DELETE FROM requests WHERE job_id = $1", key).await?;
                    Ok(true)
                })
            })
            .await?;
        if deleted {
            self.inner.changes.changed(id);
        }
        Ok(deleted)
    }

    pub async fn counts(&self) -> Result<Counts> {
        let text = "SELECT (SELECT count(*) FROM jobs WHERE status = 'queued'), \
                    (SELECT count(*) FROM jobs WHERE status = 'running'), \
                    (SELECT coalesce(now_ms() - min(created_at), 0) FROM jobs WHERE status = 'queued')";
        let row = self.inner.engine.row(text, Vec::new()).await?;
        let row = row.ok_or_else(|| StoreError::Internal("a SELECT without FROM gave no row".into()))?;
        Ok(Counts { queued: row.int(0)?, running: row.int(1)?, longest_wait_ms: row.int(2)?.max(0) })
    }

    /// Expires ended jobs whose time is up or that exceed `max_jobs` or four fifths of `max_bytes`, forgets the oldest expired ones, removes results
    /// that no job has, and recovers lost leases. Any number of instances may sweep at once.
    pub async fn sweep(&self) -> Result<Swept> {
        let mut swept = Swept { recovered: self.recover().await?, ..Swept::default() };
        let expired = "SELECT id FROM jobs WHERE expires_at <= now_ms() ORDER BY expires_at LIMIT $1 /* skip locked */";
        while let count @ 1.. = self.expire(expired, vec![SWEEP_STEP.into()]).await? {
            swept.expired += count;
        }
        let max_jobs = i64::try_from(self.inner.options.max_jobs).unwrap_or(i64::MAX);
        let surplus = "SELECT id FROM jobs WHERE expires_at IS NOT NULL ORDER BY expires_at DESC LIMIT $1 OFFSET $2";
        while let count @ 1.. = self.expire(surplus, vec![SWEEP_STEP.into(), max_jobs.into()]).await? {
            swept.expired += count;
        }
        self.sweep_batches().await?;
        let forget = "DELETE FROM expired_jobs WHERE expired_at < now_ms() - $1";
        self.change(forget, vec![milliseconds(self.inner.options.expired_retention).into()]).await?;
        if let Some(max_bytes) = self.inner.options.max_bytes {
            let max_bytes = i64::try_from(max_bytes / 10 * 8).unwrap_or(i64::MAX);
            let oldest = "SELECT id FROM jobs WHERE artefact IS NOT NULL AND expires_at IS NOT NULL \
                          ORDER BY expires_at, id LIMIT $1 /* skip locked */";
            while self.result_bytes().await? > max_bytes {
                let count = self.expire(oldest, vec![EVICTION_STEP.into()]).await?;
                if count == 0 {
                    break;
                }
                swept.expired += count;
            }
        }
        let orphan_age = milliseconds(self.inner.options.orphan_age);
        let orphans = "DELETE FROM artefacts WHERE hash IN (SELECT hash FROM artefacts \
                       WHERE touched_at <= now_ms() - $1 \
                       AND NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = hash) LIMIT $2) \
                       AND touched_at <= now_ms() - $1 RETURNING file";
        loop {
            let rows = self.returning(orphans, vec![orphan_age.into(), SWEEP_STEP.into()]).await?;
            if rows.is_empty() {
                break;
            }
            swept.artefacts += rows.len() as u64;
            if let Some(files) = &self.inner.files {
                for file in rows.into_iter().flatten() {
                    files.remove(file).await;
                }
            }
        }
        if let Some(files) = &self.inner.files {
            let old = files.older_than(self.inner.options.orphan_age).await?;
            let rows = self.inner.engine.rows("SELECT file FROM artefacts WHERE file IS NOT NULL", Vec::new()).await?;
            let known = rows.iter().map(|row| row.text(0)).collect::<Result<BTreeSet<_>>>()?;
            for file in old.into_iter().filter(|file| !known.contains(file)) {
                files.remove(file).await;
                swept.files += 1;
            }
        }
        if swept.expired > 0 || swept.artefacts > 0 {
            self.inner.engine.shrink().await?;
        }
        Ok(swept)
    }

    /// Bytes of the results that jobs have.
    async fn result_bytes(&self) -> Result<i64> {
        let text = "SELECT CAST(coalesce(sum(size), 0) AS BIGINT) FROM artefacts \
                    WHERE EXISTS (SELECT 1 FROM jobs WHERE artefact = hash)";
        Ok(self.inner.engine.row(text, Vec::new()).await?.map(|row| row.int(0)).transpose()?.unwrap_or(0))
    }

    /// Runs a change and returns the first column, a text, of what it returns.
    async fn returning(&self, text: &'static str, values: Vec<Value>) -> Result<Vec<Option<String>>> {
        self.inner
            .engine
            .write(move |connection| {
                let values = values.clone();
                Box::pin(async move {
                    let rows = connection.rows(text, values).await?;
                    rows.iter().map(|row| row.optional_text(0)).collect()
                })
            })
            .await
    }

    /// Moves the jobs that `select` names from the jobs to the expired ones.
    async fn expire(&self, select: &'static str, values: Vec<Value>) -> Result<u64> {
        let ids = self
            .inner
            .engine
            .write(move |connection| {
                let values = values.clone();
                Box::pin(async move {
                    let mut ids = Vec::new();
                    for row in connection.rows(select, values).await? {
                        let id = row.text(0)?;
                        let remember = "INSERT INTO expired_jobs (id, owner, expired_at) \
                                        SELECT id, owner, now_ms() FROM jobs WHERE id = $1 ON CONFLICT DO NOTHING";
                        connection.execute(remember, vec![id.as_str().into()]).await?;
                        connection.execute("DELETE FROM jobs WHERE id = $1", vec![id.as_str().into()]).await?;
                        ids.push(id);
                    }
                    Ok(ids)
                })
            })
            .await?;
        for id in &ids {
            self.inner.changes.changed(id);
        }
        Ok(ids.len() as u64)
    }

    async fn change(&self, text: &'static str, values: Vec<Value>) -> Result<u64> {
        self.inner
            .engine
            .write(move |connection| {
                let values = values.clone();
                Box::pin(async move { connection.execute(text, values).await })
            })
            .await
    }
}
