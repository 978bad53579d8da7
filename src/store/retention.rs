//! Results, deletion and expiry.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use super::engine::Result;
use super::sql::{Connection, Value};
use super::{Store, StoreError, milliseconds};

/// Rows that one transaction of the sweep removes, so that it never holds up other writes for long. Afterwards it rests as long as
/// that took.
const SWEEP_STEP: usize = 50;
/// Jobs that are expired at once to get below the byte budget.
const EVICTION_STEP: usize = 10;
/// Results without a job that are looked for at once.
const ORPHANS_STEP: usize = 200;
/// How often a sweep that removed something gives some space back.
const SHRINK_STEPS: usize = 20;
const LONGEST_REST: Duration = Duration::from_millis(100);

/// A stored result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Artefact {
    /// Names `bytes`: never the same for others.
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
        let due = "SELECT id, artefact FROM jobs WHERE expires_at <= now_ms() ORDER BY expires_at LIMIT $1 \
                   /* skip locked */";
        self.expire_all(due, Vec::new(), &mut swept).await?;
        // The newest of those that are too many is looked for once, and without keeping a write waiting.
        let max_jobs = i64::try_from(self.inner.options.max_jobs).unwrap_or(i64::MAX);
        let newest = "SELECT expires_at, id FROM jobs WHERE expires_at IS NOT NULL ORDER BY expires_at DESC, id DESC \
                      LIMIT 1 OFFSET $1";
        if let Some(row) = self.inner.engine.row(newest, vec![max_jobs.into()]).await? {
            let surplus = "SELECT id, artefact FROM jobs \
                           WHERE expires_at <= $2 AND (expires_at < $2 OR id <= $3) ORDER BY expires_at, id LIMIT $1 \
                           /* skip locked */";
            self.expire_all(surplus, vec![row.int(0)?.into(), row.text(1)?.into()], &mut swept).await?;
        }
        self.sweep_batches().await?;
        self.forget().await?;
        if let Some(max_bytes) = self.inner.options.max_bytes {
            self.evict(i64::try_from(max_bytes / 10 * 8).unwrap_or(i64::MAX), &mut swept).await?;
        }
        self.remove_orphans(&mut swept).await?;
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
            for _ in 0..SHRINK_STEPS {
                let begun = Instant::now();
                self.inner.engine.shrink().await?;
                rest(begun).await;
            }
        }
        Ok(swept)
    }

    /// Forgets jobs that expired long ago.
    async fn forget(&self) -> Result<()> {
        let age = milliseconds(self.inner.options.expired_retention);
        let oldest = "DELETE FROM expired_jobs WHERE id IN (SELECT id FROM expired_jobs \
                      WHERE expired_at < now_ms() - $1 ORDER BY expired_at LIMIT $2)";
        loop {
            let begun = Instant::now();
            let forgotten = self
                .inner
                .engine
                .write(move |connection| {
                    let values = vec![age.into(), step(SWEEP_STEP)];
                    Box::pin(async move { connection.execute(oldest, values).await })
                })
                .await?;
            if forgotten < SWEEP_STEP as u64 {
                return Ok(());
            }
            rest(begun).await;
        }
    }

    /// Expires the oldest jobs until the results of the others have no more than these bytes.
    async fn evict(&self, max_bytes: i64, swept: &mut Swept) -> Result<()> {
        let oldest = "SELECT id, artefact FROM jobs WHERE artefact IS NOT NULL AND expires_at IS NOT NULL \
                      ORDER BY expires_at, id LIMIT $1 /* skip locked */";
        loop {
            // All results are looked through, so not after every step.
            let mut surplus = self.result_bytes().await?.saturating_sub(max_bytes);
            if surplus <= 0 {
                return Ok(());
            }
            while surplus > 0 {
                let begun = Instant::now();
                let (count, bytes) = self.expire(oldest, vec![step(EVICTION_STEP)], swept).await?;
                if count == 0 {
                    return Ok(());
                }
                surplus -= bytes;
                rest(begun).await;
            }
        }
    }

    /// Removes results that no job has: of jobs that were deleted, or that expired when the result was young.
    async fn remove_orphans(&self, swept: &mut Swept) -> Result<()> {
        // Indexes alone answer this: a result's row is long.
        let some = "SELECT hash FROM artefacts WHERE hash > $1 AND NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = hash) \
                    ORDER BY hash LIMIT $2";
        let mut last = Vec::new();
        loop {
            let rows = self.inner.engine.rows(some, vec![last.as_slice().into(), step(ORPHANS_STEP)]).await?;
            let hashes = rows.iter().map(|row| row.bytes(0)).collect::<Result<Vec<_>>>()?;
            for some in hashes.chunks(SWEEP_STEP) {
                let (begun, some, age) = (Instant::now(), some.to_vec(), self.inner.options.orphan_age);
                let write = self.inner.engine.write(move |connection| {
                    let some = some.clone();
                    Box::pin(async move {
                        let mut removed = Vec::new();
                        for hash in some {
                            removed.extend(remove_result(connection, &hash, age).await?);
                        }
                        Ok(removed)
                    })
                });
                self.removed(write.await?, swept).await;
                rest(begun).await;
            }
            match hashes.last() {
                Some(hash) if hashes.len() == ORPHANS_STEP => last.clone_from(hash),
                _ => return Ok(()),
            }
        }
    }

    /// Counts removed results and removes their files.
    async fn removed(&self, results: Vec<Option<String>>, swept: &mut Swept) {
        swept.artefacts += results.len() as u64;
        if let Some(files) = &self.inner.files {
            for file in results.into_iter().flatten() {
                files.remove(file).await;
            }
        }
    }

    /// Bytes of the results that jobs have.
    async fn result_bytes(&self) -> Result<i64> {
        let text = "SELECT CAST(coalesce(sum(size), 0) AS BIGINT) FROM artefacts \
                    WHERE EXISTS (SELECT 1 FROM jobs WHERE artefact = hash)";
        Ok(self.inner.engine.row(text, Vec::new()).await?.map(|row| row.int(0)).transpose()?.unwrap_or(0))
    }

    /// Expires every job that `select` names; `$1` is how many at once, `values` follow.
    async fn expire_all(&self, select: &'static str, values: Vec<Value>, swept: &mut Swept) -> Result<()> {
        let values = [vec![step(SWEEP_STEP)], values].concat();
        loop {
            let begun = Instant::now();
            let (count, _) = self.expire(select, values.clone(), swept).await?;
            // Fewer may only say that another instance has locked some.
            if count == 0 {
                return Ok(());
            }
            rest(begun).await;
        }
    }

    /// Moves the jobs that `select` names, with their artefacts, from the jobs to the expired ones. Gives their number, and the
    /// bytes of the results that no job has now.
    async fn expire(&self, select: &'static str, values: Vec<Value>, swept: &mut Swept) -> Result<(usize, i64)> {
        let age = self.inner.options.orphan_age;
        let (ids, bytes, removed) = self
            .inner
            .engine
            .write(move |connection| {
                let values = values.clone();
                Box::pin(async move {
                    let (mut ids, mut results) = (Vec::new(), BTreeSet::new());
                    for row in connection.rows(select, values).await? {
                        let id = row.text(0)?;
                        let remember = "INSERT INTO expired_jobs (id, owner, expired_at) \
                                        SELECT id, owner, now_ms() FROM jobs WHERE id = $1 ON CONFLICT DO NOTHING";
                        connection.execute(remember, vec![id.as_str().into()]).await?;
                        connection.execute("DELETE FROM jobs WHERE id = $1", vec![id.as_str().into()]).await?;
                        ids.push(id);
                        results.extend(row.optional_bytes(1)?);
                    }
                    let (mut bytes, mut removed) = (0, Vec::new());
                    let size = "SELECT size FROM artefacts \
                                WHERE hash = $1 AND NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = $1)";
                    for hash in results {
                        if let Some(row) = connection.row(size, vec![hash.as_slice().into()]).await? {
                            bytes += row.int(0)?;
                            removed.extend(remove_result(connection, &hash, age).await?);
                        }
                    }
                    Ok((ids, bytes, removed))
                })
            })
            .await?;
        for id in &ids {
            self.inner.changes.changed(id);
        }
        swept.expired += ids.len() as u64;
        self.removed(removed, swept).await;
        Ok((ids.len(), bytes))
    }
}

fn step(rows: usize) -> Value {
    i64::try_from(rows).unwrap_or(i64::MAX).into()
}

/// Lets other writes through for as long as one took.
async fn rest(begun: Instant) {
    tokio::time::sleep(begun.elapsed().min(LONGEST_REST)).await;
}

/// Removes a result that no job has, unless one took it lately: that job may not be visible yet. Gives its file, if it had one.
async fn remove_result(
    connection: &mut Connection<'_>,
    hash: &[u8],
    orphan_age: Duration,
) -> Result<Option<Option<String>>> {
    let text = "DELETE FROM artefacts WHERE hash = $1 AND touched_at <= now_ms() - $2 \
                AND NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = $1) RETURNING file";
    let row = connection.row(text, vec![hash.into(), milliseconds(orphan_age).into()]).await?;
    row.map(|row| row.optional_text(0)).transpose()
}
