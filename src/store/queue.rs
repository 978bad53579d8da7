//! The queue: submit, claim, renew, progress, finish, cancel, hand back, and what happens to lost leases.
//!
//! Fairness is start-time fair queueing (Goyal, Vin & Cheng 1996) with every job counted alike. A job's `turn` is one
//! more than the later of its owner's last waiting turn and the turn before the one served next; the lowest turn is
//! claimed first, older jobs first among equals. An owner who queues a thousand jobs gets a thousand turns in a row, so
//! the single job of another owner comes right after the job served next. With one owner this is first come, first
//! served.

use std::sync::{Arc, PoisonError};
use std::time::{Duration, Instant};

use sha2::{Digest, Sha256};

use super::engine::Result;
use super::files::Prepared;
use super::record::{COLUMNS, EventId, JobRow, Lookup, Status, StatusEvent};
use super::sql::{Connection, Row, Value};
use super::{Store, StoreError, StoreOptions, milliseconds};

/// Tries to put a result where an equal one may come and go.
const KEEP_TRIES: usize = 3;
/// In the column `reusable`, of a job whose result no later one may take: not even the 1 that is added for a result that could be
/// taken otherwise makes 1 of it.
const NEVER_REUSABLE: i64 = -1;
/// How long it is taken as known that no job waits, unless one is heard of.
const IDLE_KNOWN: Duration = Duration::from_millis(25);

/// A job to be.
#[derive(Debug, Clone)]
pub struct NewJob {
    /// Unique, sorting by time.
    pub id: String,
    pub kind: String,
    pub owner: Option<String>,
    /// What a worker is given. A job that was solved before it was put on disk need not have it.
    pub request: Vec<u8>,
    /// Hash of the request: equal requests have equal hashes.
    pub request_hash: [u8; 32],
    /// Unique per owner and kind for as long as the job is kept.
    pub idempotency_key: Option<String>,
    /// What a second submission with the same idempotency key is compared by; without a key anything.
    pub body_hash: [u8; 32],
    /// JSON array.
    pub warnings: String,
    /// Told once the job has ended.
    pub callback_url: Option<String>,
    /// True if a kept result of the same owner, request and result version may be taken instead of solving again, and this
    /// one's may be taken later.
    pub reuse: bool,
}

/// What became of a submission.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Submitted {
    /// A new job: queued, or succeeded at once with a shared result.
    Created(Box<JobRow>),
    /// The job that the same idempotency key and body made before.
    Existing(Box<JobRow>),
    /// The idempotency key was used with another body.
    KeyConflict,
}

/// A job that the claimer now works on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claimed {
    pub id: String,
    pub kind: String,
    pub owner: Option<String>,
    pub request: Vec<u8>,
    /// JSON array of the warnings at submission.
    pub warnings: String,
    pub attempt: i64,
    /// How long it waited since it was submitted.
    pub waited_ms: i64,
}

/// How long ago a job that is on its way to the disk was submitted and begun, by this process's clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Begun {
    pub submitted_ms: i64,
    pub started_ms: i64,
}

/// How a worker stands with its job.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Renewed {
    Held,
    /// The client does not want the result any more.
    Cancelled,
    /// The lease ran out and the job moved on, or it was deleted.
    Lost,
}

/// How an attempt ended. Texts are JSON.
#[derive(Debug, Clone)]
pub enum Outcome {
    Succeeded {
        statistics: String,
        warnings: String,
        artefact: Vec<u8>,
        /// Equal for equal bytes only.
        artefact_hash: [u8; 32],
        /// True if the same request always gives this result, so that later jobs may share it.
        reusable: bool,
    },
    Failed {
        error: String,
    },
    Cancelled,
}

/// The line that a change of status adds to the history, with the values after the change.
fn history(attempt: &str, status: Status) -> String {
    format!("history || {attempt} || ' ' || (sequence + 1) || ' {} ' || now_ms() || '\n'", status.name())
}

/// Assignments that end a job, but for what only success has. `$2` is the retention.
pub(super) fn ending(status: Status) -> String {
    format!(
        "status = '{}', sequence = sequence + 1, finished_at = now_ms(), expires_at = now_ms() + $2, \
         worker = NULL, lease_until = NULL, history = {}",
        status.name(),
        history("attempt", status)
    )
}

impl Store {
    /// Puts a job on disk. Refuses with `QueueFull` if the queue or the owner's share of it is full; a job that takes a
    /// kept result does not count.
    pub async fn submit(&self, job: NewJob) -> Result<Submitted> {
        let (store, job) = (self.clone(), Arc::new(job));
        let submitted = self
            .inner
            .engine
            .write(move |connection| {
                let (store, job) = (store.clone(), Arc::clone(&job));
                Box::pin(async move { submit(connection, &job, None, store.options()).await })
            })
            .await?;
        if let Submitted::Created(job) = &submitted
            && job.status == Status::Queued
        {
            self.inner.changes.work();
        }
        Ok(submitted)
    }

    /// `QueueFull` if one more job of this owner would find no place; else whether no job waits at all, as known a moment ago.
    pub async fn check_room(&self, owner: Option<&str>) -> Result<bool> {
        let idle = || self.inner.idle.lock().unwrap_or_else(PoisonError::into_inner);
        let work = self.inner.changes.work_so_far();
        // Where nothing waited lately, mostly nothing waits. One asks, and the others take its word of before meanwhile.
        let asks = match &mut *idle() {
            Some((at, known)) if *known == work => {
                let asks = at.elapsed() >= IDLE_KNOWN;
                if asks {
                    *at = Instant::now();
                }
                Some(asks)
            }
            _ => None,
        };
        if asks == Some(false) {
            return Ok(true);
        }
        let any = "SELECT 1 FROM jobs WHERE status = 'queued' LIMIT 1";
        if asks.is_some() && matches!(self.inner.engine.row(any, Vec::new()).await, Ok(None)) {
            return Ok(true);
        }
        *idle() = None;
        let options = &self.inner.options;
        let (limit, owner_limit) = (bounded(options.queue_limit), bounded(options.owner_queue_limit));
        let text = format!("SELECT {ROOM}");
        let values = vec![owner.unwrap_or_default().into(), limit.into(), owner_limit.into()];
        let row = self.inner.engine.row(&text, values).await?;
        let Some(row) = row else { return Ok(false) };
        let nothing_waits = row.int(0)? == 0;
        *idle() = nothing_waits.then(|| (Instant::now(), work));
        refuse_if_full(&row, limit, owner_limit)?;
        Ok(nothing_waits)
    }

    /// True if submitting this job would give an earlier one, or a new one with a kept result.
    pub async fn has_answer(&self, job: &NewJob) -> Result<bool> {
        if let Some(key) = &job.idempotency_key {
            let text = "SELECT 1 FROM jobs WHERE owner = $1 AND kind = $2 AND idempotency_key = $3";
            let values = vec![owner_column(job), job.kind.as_str().into(), key.as_str().into()];
            if self.inner.engine.row(text, values).await?.is_some() {
                return Ok(true);
            }
        }
        if !job.reuse {
            return Ok(false);
        }
        let content = content_hash(&self.inner.options.result_version, &job.kind, &job.request_hash);
        let text = "SELECT 1 FROM jobs WHERE owner = $1 AND content_hash = $2 AND reusable = 1 LIMIT 1";
        let values = vec![owner_column(job), content.as_slice().into()];
        Ok(self.inner.engine.row(text, values).await?.is_some())
    }

    /// Puts a job on disk that this process has begun to work on already, as its first attempt with a lease. It takes no
    /// place in the queue.
    pub async fn submit_begun(&self, job: NewJob, worker: &str, lease: Duration, begun: Begun) -> Result<Submitted> {
        let (store, job, worker) = (self.clone(), Arc::new(job), worker.to_owned());
        self.inner
            .engine
            .write(move |connection| {
                let (store, job, worker) = (store.clone(), Arc::clone(&job), worker.clone());
                Box::pin(async move {
                    if let Some(earlier) = earlier_submission(connection, &job).await? {
                        return Ok(earlier);
                    }
                    let content = content_hash(&store.options().result_version, &job.kind, &job.request_hash);
                    let text = format!(
                        "INSERT INTO jobs (id, kind, owner, status, attempt, sequence, turn, {BEGUN_COLUMNS}, history, \
                         worker, lease_until, reusable) VALUES ($1, $2, $3, 'running', 1, 2, 0, {BEGUN_VALUES}, \
                         {BEGUN_HISTORY}, $11, now_ms() + $12, $13) RETURNING {COLUMNS}"
                    );
                    let mut values = begun_values(&job, &content, begun);
                    values.extend([worker.into(), milliseconds(lease).into(), not_yet_reusable(&job)]);
                    let row = inserted(connection.row(&text, values).await?)?;
                    let values = vec![job.id.as_str().into(), job.request.as_slice().into()];
                    connection.execute("INSERT INTO requests (job_id, body) VALUES ($1, $2)", values).await?;
                    Ok(Submitted::Created(Box::new(row)))
                })
            })
            .await
    }

    /// Puts a job on disk that this process has solved already, without its request, which nobody needs any more: submission and
    /// end are one write, visible together.
    pub async fn submit_ended(&self, job: NewJob, outcome: Outcome, begun: Begun) -> Result<Submitted> {
        let result = match &outcome {
            Outcome::Succeeded { artefact, artefact_hash, .. } => {
                Some(self.prepare(&job.id, 1, artefact, *artefact_hash).await?)
            }
            Outcome::Failed { .. } | Outcome::Cancelled => None,
        };
        let file = result.as_ref().and_then(|result| result.file.clone());
        let (store, ending) = (self.clone(), Arc::new((job, outcome, result)));
        let submitted = self
            .inner
            .engine
            .write(move |connection| {
                let (store, ending) = (store.clone(), Arc::clone(&ending));
                Box::pin(async move {
                    let (job, outcome, result) = &*ending;
                    submit_ended(connection, job, outcome, result.as_ref(), begun, store.options()).await
                })
            })
            .await;
        let used = submitted.as_ref().ok().and_then(|(_, used)| used.clone());
        if let (Some(files), Some(file)) = (&self.inner.files, file)
            && submitted.is_ok()
            && used.as_ref() != Some(&file)
        {
            files.remove(file).await;
        }
        Ok(submitted?.0)
    }

    /// Takes the job whose turn it is, if any, for `lease`. Jobs whose lease ran out go back to the queue first.
    pub async fn claim(&self, worker: &str, lease: Duration) -> Result<Option<Claimed>> {
        self.recover().await?;
        let text = format!(
            "UPDATE jobs SET status = 'running', attempt = attempt + 1, sequence = sequence + 1, worker = $1, \
             lease_until = now_ms() + $2, started_at = now_ms(), progress = NULL, progress_sequence = 0, history = {} \
             WHERE id = (SELECT id FROM jobs WHERE status = 'queued' ORDER BY turn, id LIMIT 1 /* skip locked */) \
             RETURNING id, kind, owner, warnings, attempt, now_ms() - created_at",
            history("(attempt + 1)", Status::Running)
        );
        if self.inner.engine.row("SELECT 1 FROM jobs WHERE status = 'queued' LIMIT 1", Vec::new()).await?.is_none() {
            return Ok(None);
        }
        let values: Vec<Value> = vec![worker.into(), milliseconds(lease).into()];
        let claimed = self
            .inner
            .engine
            .write(move |connection| {
                let (text, values) = (text.clone(), values.clone());
                Box::pin(async move {
                    let Some(row) = connection.row(&text, values).await? else { return Ok(None) };
                    let id = row.text(0)?;
                    let body = connection
                        .row("SELECT body FROM requests WHERE job_id = $1", vec![id.as_str().into()])
                        .await?
                        .ok_or_else(|| StoreError::Internal(format!("job {id} has no request")))?;
                    let owner = row.text(2)?;
                    Ok(Some(Claimed {
                        kind: row.text(1)?,
                        owner: (!owner.is_empty()).then_some(owner),
                        request: body.bytes(0)?,
                        warnings: row.text(3)?,
                        attempt: row.int(4)?,
                        waited_ms: row.int(5)?.max(0),
                        id,
                    }))
                })
            })
            .await?;
        if let Some(claimed) = &claimed {
            self.inner.changes.changed(&claimed.id);
        }
        Ok(claimed)
    }

    /// Extends the lease if the worker still holds the job.
    pub async fn renew(&self, id: &str, attempt: i64, lease: Duration) -> Result<Renewed> {
        let text = "UPDATE jobs SET lease_until = now_ms() + $3 WHERE id = $1 AND attempt = $2 AND status = 'running'";
        self.hold(text, vec![id.into(), attempt.into(), milliseconds(lease).into()]).await
    }

    /// Stores the latest progress (JSON) if the worker still holds the job.
    pub async fn progress(&self, id: &str, attempt: i64, progress: &str) -> Result<Renewed> {
        let text = "UPDATE jobs SET progress = $3, sequence = sequence + 1, progress_sequence = sequence + 1 \
                    WHERE id = $1 AND attempt = $2 AND status = 'running'";
        let renewed = self.hold(text, vec![id.into(), attempt.into(), progress.into()]).await?;
        if renewed == Renewed::Held {
            self.inner.changes.changed(id);
        }
        Ok(renewed)
    }

    /// An update by the attempt that `values` begin with (id, attempt).
    async fn hold(&self, text: &'static str, values: Vec<Value>) -> Result<Renewed> {
        self.inner
            .engine
            .write(move |connection| {
                let values = values.clone();
                Box::pin(async move {
                    let key = values[..2].to_vec();
                    if connection.execute(text, values).await? > 0 {
                        return Ok(Renewed::Held);
                    }
                    let cancelled = "SELECT 1 FROM jobs WHERE id = $1 AND attempt = $2 AND status = 'cancelled'";
                    Ok(match connection.row(cancelled, key).await? {
                        Some(_) => Renewed::Cancelled,
                        None => Renewed::Lost,
                    })
                })
            })
            .await
    }

    /// Ends the attempt: the outcome and the new status are visible together or not at all. False, and nothing changed,
    /// if the worker had lost the job.
    pub async fn finish(&self, id: &str, attempt: i64, outcome: Outcome) -> Result<bool> {
        let retention = milliseconds(self.inner.options.retention);
        let key: Vec<Value> = vec![id.into(), retention.into(), attempt.into()];
        // Hashed and written here, so that the one writer of SQLite need not wait for it.
        let result = match &outcome {
            Outcome::Succeeded { artefact, artefact_hash, .. } => {
                Some(self.prepare(id, attempt, artefact, *artefact_hash).await?)
            }
            Outcome::Failed { .. } | Outcome::Cancelled => None,
        };
        let file = result.as_ref().and_then(|result| result.file.clone());
        let ending = Arc::new((outcome, result));
        let ended = self
            .inner
            .engine
            .write(move |connection| {
                let (key, ending) = (key.clone(), Arc::clone(&ending));
                Box::pin(async move { finish(connection, key, &ending.0, ending.1.as_ref()).await })
            })
            .await;
        let (finished, used) = ended.clone().unwrap_or_default();
        if let (Some(files), Some(file)) = (&self.inner.files, file)
            && ended.is_ok()
            && used.as_ref() != Some(&file)
        {
            files.remove(file).await;
        }
        ended?;
        if finished {
            self.inner.changes.changed(id);
        }
        Ok(finished)
    }

    /// Gives a running job back to the queue, at its old place, without counting a lost lease. False if the worker had
    /// lost it.
    pub async fn hand_back(&self, id: &str, attempt: i64) -> Result<bool> {
        let text = format!("UPDATE jobs SET {} WHERE id = $1 AND attempt = $2 AND status = 'running'", requeueing());
        let values: Vec<Value> = vec![id.into(), attempt.into()];
        let handed_back = self
            .inner
            .engine
            .write(move |connection| {
                let (text, values) = (text.clone(), values.clone());
                Box::pin(async move { Ok(connection.execute(&text, values).await? > 0) })
            })
            .await?;
        if handed_back {
            self.inner.changes.changed(id);
            self.inner.changes.work();
        }
        Ok(handed_back)
    }

    /// Cancels a queued or running job at once; any other is returned unchanged. The worker learns of it by its next
    /// renewal or by watching the job.
    pub async fn cancel(&self, id: &str, owner: Option<&str>) -> Result<Lookup> {
        let text = format!(
            "UPDATE jobs SET {} WHERE id = $1 AND ($3 = '' OR owner = $3) AND status IN ('queued', 'running') \
             RETURNING {COLUMNS}",
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
                    let Some(row) = connection.row(&text, values).await? else { return Ok(None) };
                    let job = JobRow::read(&row)?;
                    drop_request(connection, &job.id).await?;
                    Ok(Some(job))
                })
            })
            .await?;
        match cancelled {
            Some(job) => {
                self.inner.changes.changed(id);
                Ok(Lookup::Found(Box::new(job)))
            }
            None => self.get(id, owner).await,
        }
    }

    /// Puts jobs whose lease ran out back into the queue, or fails them if that happened too often. Returns how many it
    /// touched.
    pub(super) async fn recover(&self) -> Result<usize> {
        let some = "SELECT 1 FROM jobs WHERE status = 'running' AND lease_until <= now_ms() LIMIT 1";
        if self.inner.engine.row(some, Vec::new()).await?.is_none() {
            return Ok(0);
        }
        let retention = milliseconds(self.inner.options.retention);
        let max_attempts = i64::from(self.inner.options.max_attempts);
        let touched = self
            .inner
            .engine
            .write(move |connection| Box::pin(async move { recover(connection, retention, max_attempts).await }))
            .await?;
        for id in &touched {
            self.inner.changes.changed(id);
        }
        if !touched.is_empty() {
            self.inner.changes.work();
        }
        Ok(touched.len())
    }
}

/// Puts a job on disk, as part of a batch if it has a place in one.
pub(super) async fn submit(
    connection: &mut Connection<'_>,
    job: &NewJob,
    place: Option<(&str, i64)>,
    options: &StoreOptions,
) -> Result<Submitted> {
    if let Some(earlier) = earlier_submission(connection, job).await? {
        return Ok(earlier);
    }
    let content = content_hash(&options.result_version, &job.kind, &job.request_hash);
    if job.reuse
        && let Some(row) = share_result(connection, job, place, &content, milliseconds(options.retention)).await?
    {
        return Ok(Submitted::Created(Box::new(row)));
    }
    let limits = (bounded(options.queue_limit), bounded(options.owner_queue_limit));
    let turn = next_turn(connection, job, limits.0, limits.1).await?;
    insert(connection, job, place, &content, turn).await.map(|row| Submitted::Created(Box::new(row)))
}

/// The columns of a job's batch and its place in it.
fn place_values(place: Option<(&str, i64)>) -> [Value; 2] {
    [place.map(|(batch, _)| batch.to_owned()).into(), place.map_or(0, |(_, index)| index).into()]
}

pub(super) fn bounded(limit: u64) -> i64 {
    i64::try_from(limit).unwrap_or(i64::MAX)
}

fn content_hash(version: &str, kind: &str, request_hash: &[u8; 32]) -> [u8; 32] {
    let mut hash = Sha256::new();
    for part in [version.as_bytes(), kind.as_bytes(), request_hash] {
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    hash.finalize().into()
}

fn owner_column(job: &NewJob) -> Value {
    job.owner.as_deref().unwrap_or_default().into()
}

async fn earlier_submission(connection: &mut Connection<'_>, job: &NewJob) -> Result<Option<Submitted>> {
    let Some(key) = &job.idempotency_key else { return Ok(None) };
    let text = format!("SELECT {COLUMNS}, body_hash FROM jobs WHERE owner = $1 AND kind = $2 AND idempotency_key = $3");
    let values = vec![owner_column(job), job.kind.as_str().into(), key.as_str().into()];
    let Some(row) = connection.row(&text, values).await? else { return Ok(None) };
    let same = row.bytes(17)? == job.body_hash;
    Ok(Some(if same { Submitted::Existing(Box::new(JobRow::read(&row)?)) } else { Submitted::KeyConflict }))
}

/// How many jobs wait, in all and of the owner `$1`, counted no further than the limits `$2` and `$3`.
const ROOM: &str = "(SELECT count(*) FROM (SELECT 1 FROM jobs WHERE status = 'queued' LIMIT $2) AS waiting), \
     (SELECT count(*) FROM (SELECT 1 FROM jobs WHERE status = 'queued' AND owner = $1 LIMIT $3) AS own)";

fn refuse_if_full(row: &Row, limit: i64, owner_limit: i64) -> Result<()> {
    if row.int(0)? >= limit {
        return Err(StoreError::QueueFull { own: false });
    }
    if row.int(1)? >= owner_limit {
        return Err(StoreError::QueueFull { own: true });
    }
    Ok(())
}

/// The first free turn for the job's owner.
async fn next_turn(connection: &mut Connection<'_>, job: &NewJob, limit: i64, owner_limit: i64) -> Result<i64> {
    let text = format!(
        "SELECT {ROOM}, (SELECT min(turn) FROM jobs WHERE status = 'queued'), \
         (SELECT max(turn) FROM jobs WHERE status = 'queued' AND owner = $1)"
    );
    let row = connection
        .row(&text, vec![owner_column(job), limit.into(), owner_limit.into()])
        .await?
        .ok_or_else(|| StoreError::Internal("a SELECT without FROM gave no row".into()))?;
    refuse_if_full(&row, limit, owner_limit)?;
    let served_next = row.optional_int(2)?.unwrap_or(1);
    Ok(served_next.max(row.optional_int(3)?.map_or(1, |last| last + 1)))
}

async fn insert(
    connection: &mut Connection<'_>,
    job: &NewJob,
    place: Option<(&str, i64)>,
    content: &[u8],
    turn: i64,
) -> Result<JobRow> {
    let text = format!(
        "INSERT INTO jobs (id, kind, owner, status, attempt, sequence, turn, created_at, idempotency_key, body_hash, \
         content_hash, history, warnings, callback_url, batch, batch_index, reusable) \
         VALUES ($1, $2, $3, 'queued', 0, 1, $4, now_ms(), $5, $6, $7, '0 1 queued ' || now_ms() || '\n', $8, $9, $10, \
         $11, $12) \
         RETURNING {COLUMNS}"
    );
    let [batch, index] = place_values(place);
    let values = vec![
        job.id.as_str().into(),
        job.kind.as_str().into(),
        owner_column(job),
        turn.into(),
        job.idempotency_key.clone().into(),
        job.body_hash.as_slice().into(),
        content.into(),
        job.warnings.as_str().into(),
        job.callback_url.clone().into(),
        batch,
        index,
        not_yet_reusable(job),
    ];
    let row = inserted(connection.row(&text, values).await?)?;
    let values = vec![job.id.as_str().into(), job.request.as_slice().into()];
    connection.execute("INSERT INTO requests (job_id, body) VALUES ($1, $2)", values).await?;
    Ok(row)
}

/// The column `reusable` of a job without a result.
fn not_yet_reusable(job: &NewJob) -> Value {
    (if job.reuse { 0 } else { NEVER_REUSABLE }).into()
}

/// What a job that was begun before it was on disk is inserted with; the values are those of `begun_values`.
const BEGUN_COLUMNS: &str = "created_at, started_at, idempotency_key, body_hash, content_hash, warnings, callback_url";
const BEGUN_VALUES: &str = "now_ms() - $4, now_ms() - $5, $6, $7, $8, $9, $10";
const BEGUN_HISTORY: &str = "'0 1 queued ' || (now_ms() - $4) || '\n1 2 running ' || (now_ms() - $5) || '\n'";

fn begun_values(job: &NewJob, content: &[u8], begun: Begun) -> Vec<Value> {
    vec![
        job.id.as_str().into(),
        job.kind.as_str().into(),
        owner_column(job),
        begun.submitted_ms.into(),
        begun.started_ms.into(),
        job.idempotency_key.clone().into(),
        job.body_hash.as_slice().into(),
        content.into(),
        job.warnings.as_str().into(),
        job.callback_url.clone().into(),
    ]
}

/// As `finish`, of a job that is not on disk yet.
async fn submit_ended(
    connection: &mut Connection<'_>,
    job: &NewJob,
    outcome: &Outcome,
    result: Option<&Prepared>,
    begun: Begun,
    options: &StoreOptions,
) -> Result<(Submitted, Option<String>)> {
    if let Some(earlier) = earlier_submission(connection, job).await? {
        return Ok((earlier, None));
    }
    let content = content_hash(&options.result_version, &job.kind, &job.request_hash);
    let (status, reusable) = match outcome {
        Outcome::Succeeded { reusable, .. } => (Status::Succeeded, *reusable && job.reuse),
        Outcome::Failed { .. } => (Status::Failed, false),
        Outcome::Cancelled => (Status::Cancelled, false),
    };
    let (statistics, warnings, error) = match outcome {
        Outcome::Succeeded { statistics, warnings, .. } => (Some(statistics.clone()), warnings.clone(), None),
        Outcome::Failed { error } => (None, job.warnings.clone(), Some(error.clone())),
        Outcome::Cancelled => (None, job.warnings.clone(), None),
    };
    let file = keep(connection, outcome, result).await?;
    // Asked for apart: a statement that returns rows keeps a journal of its own on SQLite.
    let now = connection.row("SELECT now_ms()", Vec::new()).await?;
    let now = now.ok_or_else(|| StoreError::Internal("a SELECT without FROM gave no row".into()))?.int(0)?;
    let (created_at, started_at) = (now - begun.submitted_ms, now - begun.started_ms);
    let event = |attempt, sequence, status, at_ms| StatusEvent { id: EventId { attempt, sequence }, status, at_ms };
    let row = JobRow {
        id: job.id.clone(),
        kind: job.kind.clone(),
        owner: job.owner.clone(),
        status,
        attempt: 1,
        sequence: 3,
        created_at_ms: created_at,
        started_at_ms: Some(started_at),
        finished_at_ms: Some(now),
        expires_at_ms: Some(now + milliseconds(options.retention)),
        progress: None,
        progress_sequence: 0,
        statistics,
        warnings,
        error,
        artefact: result.map(|result| result.hash.to_vec()),
        history: vec![
            event(0, 1, Status::Queued, created_at),
            event(1, 2, Status::Running, started_at),
            event(1, 3, status, now),
        ],
    };
    let text = "INSERT INTO jobs (id, kind, owner, status, attempt, sequence, turn, created_at, started_at, finished_at, \
                expires_at, history, idempotency_key, body_hash, content_hash, warnings, callback_url, statistics, error, \
                artefact, reusable) \
                VALUES ($1, $2, $3, $4, $5, $6, 0, $7, $8, $9, $10, $11, $12, $13, $14, $15, $16, $17, $18, $19, $20)";
    let values = vec![
        row.id.as_str().into(),
        row.kind.as_str().into(),
        owner_column(job),
        status.name().into(),
        row.attempt.into(),
        row.sequence.into(),
        created_at.into(),
        started_at.into(),
        now.into(),
        (now + milliseconds(options.retention)).into(),
        row.history.iter().map(StatusEvent::line).collect::<String>().into(),
        job.idempotency_key.clone().into(),
        job.body_hash.as_slice().into(),
        content.as_slice().into(),
        row.warnings.as_str().into(),
        job.callback_url.clone().into(),
        row.statistics.clone().into(),
        row.error.clone().into(),
        Value::OptionalBytes(row.artefact.clone()),
        i64::from(reusable).into(),
    ];
    connection.execute(text, values).await?;
    Ok((Submitted::Created(Box::new(row)), file))
}

/// Puts a success's result where jobs find it; gives the file that holds it, which may be an earlier one with the same bytes.
async fn keep(connection: &mut Connection<'_>, outcome: &Outcome, result: Option<&Prepared>) -> Result<Option<String>> {
    let (Outcome::Succeeded { artefact, .. }, Some(result)) = (outcome, result) else { return Ok(None) };
    let insert = "INSERT INTO artefacts (hash, size, touched_at, file, body) VALUES ($1, $2, now_ms(), $3, $4) \
                  ON CONFLICT (hash) DO NOTHING";
    let touch = "UPDATE artefacts SET touched_at = now_ms() WHERE hash = $1 RETURNING file";
    for _ in 0..KEEP_TRIES {
        let values = vec![
            result.hash.as_slice().into(),
            bounded(artefact.len() as u64).into(),
            result.file.clone().into(),
            Value::OptionalBytes(result.file.is_none().then(|| artefact.clone())),
        ];
        if connection.execute(insert, values).await? > 0 {
            return Ok(result.file.clone());
        }
        if let Some(row) = connection.row(touch, vec![result.hash.as_slice().into()]).await? {
            return row.optional_text(0);
        }
        // Swept away in between.
    }
    Err(StoreError::Contended("a result came and went".into()))
}

fn inserted(row: Option<Row>) -> Result<JobRow> {
    JobRow::read(&row.ok_or_else(|| StoreError::Internal("an INSERT returned no row".into()))?)
}

/// Makes the job an ended one with the result of an earlier job of the same content, if there is one.
async fn share_result(
    connection: &mut Connection<'_>,
    job: &NewJob,
    place: Option<(&str, i64)>,
    content: &[u8],
    retention: i64,
) -> Result<Option<JobRow>> {
    let find = "SELECT id, artefact FROM jobs WHERE owner = $1 AND content_hash = $2 AND reusable = 1 \
                ORDER BY id DESC LIMIT 1";
    let Some(found) = connection.row(find, vec![owner_column(job), content.into()]).await? else { return Ok(None) };
    if !touch(connection, &found.bytes(1)?).await? {
        return Ok(None);
    }
    let text = format!(
        "INSERT INTO jobs (id, kind, owner, status, attempt, sequence, turn, created_at, started_at, finished_at, \
         expires_at, idempotency_key, body_hash, content_hash, reusable, history, warnings, statistics, artefact, \
         progress, progress_sequence, callback_url, batch, batch_index) \
         SELECT $1, kind, owner, status, 0, 3, 0, now_ms(), now_ms(), now_ms(), now_ms() + $2, $3, $4, content_hash, 1, \
         '0 1 queued ' || now_ms() || '\n0 3 succeeded ' || now_ms() || '\n', warnings, statistics, artefact, \
         progress, 2, $6, $7, $8 FROM jobs WHERE id = $5 RETURNING {COLUMNS}"
    );
    let [batch, index] = place_values(place);
    let values = vec![
        job.id.as_str().into(),
        retention.into(),
        job.idempotency_key.clone().into(),
        job.body_hash.as_slice().into(),
        found.text(0)?.into(),
        job.callback_url.clone().into(),
        batch,
        index,
    ];
    inserted(connection.row(&text, values).await?).map(Some)
}

/// Marks an artefact as just taken, so that the sweep leaves it alone until this transaction is visible. False if it is
/// not there.
async fn touch(connection: &mut Connection<'_>, hash: &[u8]) -> Result<bool> {
    let text = "UPDATE artefacts SET touched_at = now_ms() WHERE hash = $1";
    Ok(connection.execute(text, vec![hash.into()]).await? > 0)
}

pub(super) async fn drop_request(connection: &mut Connection<'_>, id: &str) -> Result<()> {
    connection.execute("DELETE FROM requests WHERE job_id = $1", vec![id.into()]).await?;
    Ok(())
}

/// `key` is id, retention and attempt. True if the attempt ended the job, and the file that the result is in if any.
async fn finish(
    connection: &mut Connection<'_>,
    key: Vec<Value>,
    outcome: &Outcome,
    result: Option<&Prepared>,
) -> Result<(bool, Option<String>)> {
    let id = key[..1].to_vec();
    let fence = "WHERE id = $1 AND attempt = $3 AND status = 'running'";
    let mut values = key;
    let (status, text) = match (outcome, result) {
        (Outcome::Succeeded { statistics, warnings, reusable, .. }, Some(result)) => {
            values.extend([
                statistics.as_str().into(),
                warnings.as_str().into(),
                result.hash.as_slice().into(),
                i64::from(*reusable).into(),
            ]);
            (Status::Succeeded, ", statistics = $4, warnings = $5, artefact = $6, reusable = reusable + $7")
        }
        (Outcome::Succeeded { .. }, None) => {
            return Err(StoreError::Internal("a success without a prepared result".into()));
        }
        (Outcome::Failed { error }, _) => {
            values.push(error.as_str().into());
            (Status::Failed, ", error = $4")
        }
        (Outcome::Cancelled, _) => (Status::Cancelled, ""),
    };
    if connection.execute(&format!("UPDATE jobs SET {}{text} {fence}", ending(status)), values).await? == 0 {
        return Ok((false, None));
    }
    let file = keep(connection, outcome, result).await?;
    connection.execute("DELETE FROM requests WHERE job_id = $1", id).await?;
    Ok((true, file))
}

/// Assignments that put a running job back into the queue.
fn requeueing() -> String {
    format!(
        "status = 'queued', sequence = sequence + 1, worker = NULL, lease_until = NULL, started_at = NULL, \
         history = {}",
        history("attempt", Status::Queued)
    )
}

async fn recover(connection: &mut Connection<'_>, retention: i64, max_attempts: i64) -> Result<Vec<String>> {
    let lost = connection
        .rows(
            "SELECT id, attempt, lost_leases + 1, worker, progress, losses, now_ms() - started_at FROM jobs \
             WHERE status = 'running' AND lease_until <= now_ms() ORDER BY lease_until LIMIT 100 /* skip locked */",
            Vec::new(),
        )
        .await?;
    let mut touched = Vec::with_capacity(lost.len());
    for row in lost {
        let (id, attempt, count) = (row.text(0)?, row.int(1)?, row.int(2)?);
        let losses = format!(
            "{}attempt {attempt} on {} was lost after at most {:.1} s, last progress {}\n",
            row.text(5)?,
            row.optional_text(3)?.as_deref().unwrap_or("an unknown worker"),
            row.int(6)? as f64 / 1000.0,
            row.optional_text(4)?.as_deref().unwrap_or("none")
        );
        let fence = "WHERE id = $1 AND attempt = $3";
        if count < max_attempts {
            let text = format!("UPDATE jobs SET {}, lost_leases = $2, losses = $4 {fence}", requeueing());
            let values = vec![id.as_str().into(), count.into(), attempt.into(), losses.as_str().into()];
            connection.execute(&text, values).await?;
        } else {
            let error = serde_json::json!({
                "type": "worker_lost",
                "title": "The workers of this job died",
                "detail": format!(
                    "{count} workers in a row stopped without an answer while solving this job, so it is not tried \
                     again. Ask for fewer triangles or iterations, or tell the operator:\n{losses}"
                ),
                "errors": [],
            });
            let text = format!(
                "UPDATE jobs SET {}, lost_leases = $4, losses = $5, error = $6 {fence}",
                ending(Status::Failed)
            );
            let values = vec![
                id.as_str().into(),
                retention.into(),
                attempt.into(),
                count.into(),
                losses.as_str().into(),
                error.to_string().as_str().into(),
            ];
            connection.execute(&text, values).await?;
            drop_request(connection, &id).await?;
        }
        touched.push(id);
    }
    Ok(touched)
}
