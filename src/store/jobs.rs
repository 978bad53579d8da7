//! Rows of jobs: submission, reading, cancelling and deleting.

use sha2::{Digest, Sha256};

use super::callbacks::host_of;
use super::history::{EventId, StatusEvent, ending, read_history, read_status};
use super::queue;
use super::results::{self, Prepared};
use super::tx::{Row, Tx};
use super::value::Value;
use super::{Result, StoreError, StoreOptions, limit, milliseconds};
use crate::status::{CancelReason, Status};

/// A job that has not been stored yet.
#[derive(Debug, Clone)]
pub struct NewJob {
    /// Unique identifier that sorts by time.
    pub id: String,
    pub kind: String,
    pub owner: Option<String>,
    /// Body that a worker reads. It is kept as long as the job.
    pub request: Vec<u8>,
    /// Name of the result from which the request begins. The result is kept until the job has ended.
    pub source: Option<Vec<u8>>,
    /// Hash of the request. Equal requests have equal hashes.
    pub request_hash: [u8; 32],
    /// Unique per owner and kind for as long as the job is kept.
    pub idempotency_key: Option<String>,
    /// Hash that is compared with a later submission of the same idempotency key. It is not used without a key.
    pub body_hash: [u8; 32],
    /// Receives a message once the job has ended.
    pub callback_url: Option<String>,
    /// Name of the job for people.
    pub label: Option<String>,
    /// Fields of the client as JSON text.
    pub metadata: Option<String>,
    /// Key of a series of jobs of which only the newest counts.
    pub supersede: Option<String>,
    /// Estimate of the memory that solving takes.
    pub memory_bytes: u64,
    /// True if this job may reuse a kept result of the same owner, request and result version, and if later jobs may
    /// reuse this job's result.
    pub reuse: bool,
}

/// Result of adding a job.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Addition {
    /// The job is new. It is queued, or has already ended. The list has the older jobs of its series, which are now
    /// cancelled.
    Created(Box<JobRow>, Vec<JobRow>),
    /// An earlier submission with the same idempotency key and body created this job.
    Existing(Box<JobRow>),
    /// The idempotency key was used with another body.
    KeyConflict,
}

/// How an attempt ended. The texts are JSON.
#[derive(Debug, Clone)]
pub enum Outcome {
    Succeeded {
        statistics: String,
        /// Figures of the statistics that lists show.
        summary: String,
        warnings: String,
        artefact: Vec<u8>,
        /// Hash that is equal only for equal bytes.
        artefact_hash: [u8; 32],
        /// True if the same request always gives this result, so that later jobs may reuse it.
        reusable: bool,
    },
    Failed {
        error: String,
    },
}

impl Outcome {
    /// Returns the status of a job that ended with this outcome.
    #[must_use]
    pub fn status(&self) -> Status {
        match self {
            Self::Succeeded { .. } => Status::Succeeded,
            Self::Failed { .. } => Status::Failed,
        }
    }
}

/// End of a job that was solved before it was stored, with the times since its submission and its start by this
/// process's clock.
#[derive(Debug, Clone)]
pub struct EarlyEnd {
    pub outcome: Outcome,
    pub submitted_ms: i64,
    pub started_ms: i64,
}

/// Seed of the hash that gives each series its advisory lock in PostgreSQL. The seed keeps these locks apart from other
/// uses of advisory locks.
const SERIES_LOCKS: i64 = 7_019_839_176;

/// Permission for later equal requests to reuse a job's result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sharing {
    /// The client allows the reuse, but the job has no result yet.
    Undecided,
    Allowed,
    /// The client bypassed the cache, or the result depends on more than the request.
    Refused,
}

impl Sharing {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Undecided => "undecided",
            Self::Allowed => "allowed",
            Self::Refused => "refused",
        }
    }
}

/// Batch of a job, and the job's index in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct BatchPlace<'b> {
    pub(super) batch: &'b str,
    pub(super) index: i64,
}

/// Row of a job, without its request and its mesh. `metadata`, `progress`, `statistics`, `summary`, `warnings` and
/// `error` are JSON texts as they were stored.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JobRow {
    pub id: String,
    pub kind: String,
    pub owner: Option<String>,
    pub status: Status,
    pub label: Option<String>,
    pub metadata: Option<String>,
    pub attempt: i64,
    pub sequence: i64,
    pub created_at_ms: i64,
    /// Start of the current attempt.
    pub started_at_ms: Option<i64>,
    pub finished_at_ms: Option<i64>,
    pub expires_at_ms: Option<i64>,
    pub progress: Option<String>,
    /// Value of `sequence` when `progress` was written, or 0 without progress.
    pub progress_sequence: i64,
    /// `None` if there are none, or if the list was requested without statistics.
    pub statistics: Option<String>,
    pub summary: Option<String>,
    pub warnings: String,
    pub error: Option<String>,
    /// Hash of the stored result, which is equal only for equal bytes.
    pub artefact: Option<Vec<u8>>,
    /// Batch that the job belongs to.
    pub batch: Option<String>,
    pub cancelled_because: Option<CancelReason>,
    /// Job that took the place of this one in its series.
    pub successor: Option<String>,
    /// True if the job's request is kept. It is not if the job ended under a version that dropped requests.
    pub has_request: bool,
    /// Every change of status so far, oldest first.
    pub history: Vec<StatusEvent>,
}

/// Columns that [`JobRow::read`] reads.
pub(super) const COLUMNS: &str = "id, kind, owner, status, attempt, sequence, created_at, started_at, finished_at, \
     expires_at, progress, progress_sequence, statistics, summary, warnings, error, artefact, history, label, metadata, \
     batch, cancelled_because, successor, request_bytes";

impl JobRow {
    pub(super) fn read(row: &Row) -> Result<Self> {
        Ok(Self {
            id: row.get("id")?,
            kind: row.get("kind")?,
            owner: row.owner()?,
            status: read_status(row)?,
            label: row.get("label")?,
            metadata: row.get("metadata")?,
            attempt: row.get("attempt")?,
            sequence: row.get("sequence")?,
            created_at_ms: row.get("created_at")?,
            started_at_ms: row.get("started_at")?,
            finished_at_ms: row.get("finished_at")?,
            expires_at_ms: row.get("expires_at")?,
            progress: row.get("progress")?,
            progress_sequence: row.get("progress_sequence")?,
            statistics: row.get("statistics")?,
            summary: row.get("summary")?,
            warnings: row.get("warnings")?,
            error: row.get("error")?,
            artefact: row.get("artefact")?,
            batch: row.get("batch")?,
            cancelled_because: row
                .get::<Option<String>>("cancelled_because")?
                .and_then(|name| CancelReason::from_name(&name)),
            successor: row.get("successor")?,
            has_request: row.get::<i64>("request_bytes")? > 0,
            history: read_history(&row.get::<String>("history")?)?,
        })
    }

    /// Returns the row of a job that enters the queue at `now_ms`, as part of the batch `batch` if one is given.
    fn queued(job: &NewJob, batch: Option<&str>, now_ms: i64) -> Self {
        Self {
            id: job.id.clone(),
            kind: job.kind.clone(),
            owner: job.owner.clone(),
            status: Status::Queued,
            label: job.label.clone(),
            metadata: job.metadata.clone(),
            attempt: 0,
            sequence: 1,
            created_at_ms: now_ms,
            started_at_ms: None,
            finished_at_ms: None,
            expires_at_ms: None,
            progress: None,
            progress_sequence: 0,
            statistics: None,
            summary: None,
            warnings: "[]".into(),
            error: None,
            artefact: None,
            batch: batch.map(str::to_owned),
            cancelled_because: None,
            successor: None,
            has_request: !job.request.is_empty(),
            history: vec![StatusEvent::new(0, 1, Status::Queued, now_ms)],
        }
    }

    /// Returns the latest point of the job's life.
    #[must_use]
    pub fn event_id(&self) -> EventId {
        EventId { attempt: self.attempt, sequence: self.sequence }
    }

    /// Returns the status changes after `last`, oldest first, or all changes if `last` is `None`.
    pub fn events_since(&self, last: Option<EventId>) -> impl Iterator<Item = &StatusEvent> {
        self.history.iter().filter(move |event| last.is_none_or(|last| event.id > last))
    }

    /// Returns the latest progress if it is newer than `last`.
    #[must_use]
    pub fn progress_since(&self, last: Option<EventId>) -> Option<(EventId, &str)> {
        let id = EventId { attempt: self.attempt, sequence: self.progress_sequence };
        let progress = self.progress.as_deref()?;
        last.is_none_or(|last| id > last).then_some((id, progress))
    }
}

/// Result of looking up a job.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Lookup {
    Found(Box<JobRow>),
    /// The job existed and has expired.
    Expired,
    /// The job never existed, was deleted, or belongs to another owner.
    Missing,
}

/// Selection of the jobs in a list. The default selects all jobs.
#[derive(Debug, Clone, Default)]
pub struct Filter {
    pub owner: Option<String>,
    pub kind: Option<String>,
    /// States of the jobs. An empty list selects jobs in every state.
    pub statuses: Vec<Status>,
    pub idempotency_key: Option<String>,
    pub label: Option<String>,
    pub batch: Option<String>,
    /// Time after which the jobs were submitted.
    pub created_after_ms: Option<i64>,
    /// True if the rows come with their statistics.
    pub statistics: bool,
}

/// Stores a job, as part of a batch if `place` is given. The first of these cases that applies decides: an earlier
/// submission with the same idempotency key is returned; a kept result is reused; the job has already been solved; the
/// job is queued.
pub(super) fn add(
    tx: &mut Tx<'_>,
    job: &NewJob,
    place: Option<BatchPlace<'_>>,
    solved: Option<(&EarlyEnd, Option<&Prepared>)>,
    options: &StoreOptions,
) -> Result<Addition> {
    let prepared = solved.and_then(|(_, result)| result);
    if let Some(key) = &job.idempotency_key
        && let Some(earlier) = earlier_job(tx, job.owner.as_deref(), &job.kind, key, &job.body_hash)?
    {
        tx.drop_file(prepared.and_then(|result| result.file.clone()));
        return Ok(earlier);
    }
    let superseded = match &job.supersede {
        Some(series) => supersede(tx, job, series, options)?,
        None => Vec::new(),
    };
    let content = content_hash(&options.result_version, &job.kind, &job.request_hash);
    let now_ms = tx.now_ms()?;
    let expires_at_ms = now_ms.saturating_add(milliseconds(options.retention));
    let queued = JobRow::queued(job, place.map(|place| place.batch), now_ms);
    let mut turn = 0;
    let (row, sharing) = if job.reuse
        && let Some(shared) = shared_result(tx, job, &content)?
    {
        (ended_with(shared, queued, now_ms, expires_at_ms), Sharing::Allowed)
    } else if let Some((solved, result)) = solved {
        (ended_as(solved, result, queued, now_ms, expires_at_ms), solved.sharing(job))
    } else {
        turn = queue::next_turn(tx, job.owner.as_deref(), options)?;
        (queued, if job.reuse { Sharing::Undecided } else { Sharing::Refused })
    };
    match solved {
        Some((EarlyEnd { outcome: Outcome::Succeeded { artefact, .. }, .. }, Some(result))) if row.attempt == 1 => {
            results::keep(tx, result, artefact)?;
        }
        // The job reuses a kept result, so the new result is dropped.
        _ => tx.drop_file(prepared.and_then(|result| result.file.clone())),
    }
    insert(tx, job, &row, turn, sharing, place, &content)?;
    keep_request(tx, job, row.status)?;
    if row.status == Status::Queued {
        tx.work_available();
    }
    Ok(Addition::Created(Box::new(row), superseded))
}

impl EarlyEnd {
    fn sharing(&self, job: &NewJob) -> Sharing {
        match self.outcome {
            Outcome::Succeeded { reusable: true, .. } if job.reuse => Sharing::Allowed,
            Outcome::Succeeded { .. } | Outcome::Failed { .. } => Sharing::Refused,
        }
    }
}

/// Returns a hash that identifies the work. Jobs with equal hashes have equal results.
fn content_hash(version: &str, kind: &str, request_hash: &[u8; 32]) -> [u8; 32] {
    let mut hash = Sha256::new();
    for part in [version.as_bytes(), kind.as_bytes(), request_hash] {
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    hash.finalize().into()
}

fn owner_column(job: &NewJob) -> Value<'_> {
    job.owner.as_deref().unwrap_or_default().into()
}

/// Looks for an earlier submission with the idempotency key `key`. If there is one, returns the answer to a repeated
/// submission: the existing job, or a conflict if the body differs.
pub(super) fn earlier_job(
    tx: &mut Tx<'_>,
    owner: Option<&str>,
    kind: &str,
    key: &str,
    body_hash: &[u8; 32],
) -> Result<Option<Addition>> {
    let text = format!("SELECT {COLUMNS}, body_hash FROM jobs WHERE owner = $1 AND kind = $2 AND idempotency_key = $3");
    let Some(row) = tx.row(&text, &[owner.unwrap_or_default().into(), kind.into(), key.into()])? else {
        return Ok(None);
    };
    let same = row.get::<Vec<u8>>("body_hash")? == body_hash;
    Ok(Some(if same { Addition::Existing(Box::new(JobRow::read(&row)?)) } else { Addition::KeyConflict }))
}

/// Returns the newest job of the same owner and content whose result may be reused, if there is one.
fn shared_result(tx: &mut Tx<'_>, job: &NewJob, content: &[u8; 32]) -> Result<Option<JobRow>> {
    let text = format!(
        "SELECT {COLUMNS} FROM jobs WHERE owner = $1 AND content_hash = $2 AND sharing = 'allowed' \
         ORDER BY id DESC LIMIT 1"
    );
    let Some(row) = tx.row(&text, &[owner_column(job), content.into()])? else { return Ok(None) };
    let row = JobRow::read(&row)?;
    // The sweep leaves recently touched results alone, so the result stays until this transaction is visible.
    let exists = results::touch(tx, row.artefact.as_deref().unwrap_or_default())?;
    Ok(exists.then_some(row))
}

/// Returns the row of a job that reuses the result of another job and ends at once.
fn ended_with(other: JobRow, queued: JobRow, now_ms: i64, expires_at_ms: i64) -> JobRow {
    JobRow {
        status: Status::Succeeded,
        sequence: 3,
        started_at_ms: Some(now_ms),
        finished_at_ms: Some(now_ms),
        expires_at_ms: Some(expires_at_ms),
        progress_sequence: 2,
        progress: other.progress,
        statistics: other.statistics,
        summary: other.summary,
        warnings: other.warnings,
        artefact: other.artefact,
        history: vec![
            StatusEvent::new(0, 1, Status::Queued, now_ms),
            StatusEvent::new(0, 3, Status::Succeeded, now_ms),
        ],
        ..queued
    }
}

/// Returns the row of a job that was solved before it was stored.
fn ended_as(solved: &EarlyEnd, result: Option<&Prepared>, queued: JobRow, now_ms: i64, expires_at_ms: i64) -> JobRow {
    let (created_at_ms, started_at_ms) = (now_ms - solved.submitted_ms, now_ms - solved.started_ms);
    let row = JobRow {
        attempt: 1,
        sequence: 3,
        created_at_ms,
        started_at_ms: Some(started_at_ms),
        finished_at_ms: Some(now_ms),
        expires_at_ms: Some(expires_at_ms),
        artefact: result.map(|result| result.hash.to_vec()),
        ..queued
    };
    let row = match &solved.outcome {
        Outcome::Succeeded { statistics, summary, warnings, .. } => JobRow {
            status: Status::Succeeded,
            statistics: Some(statistics.clone()),
            summary: Some(summary.clone()),
            warnings: warnings.clone(),
            ..row
        },
        Outcome::Failed { error } => JobRow { status: Status::Failed, error: Some(error.clone()), ..row },
    };
    let history = vec![
        StatusEvent::new(0, 1, Status::Queued, created_at_ms),
        StatusEvent::new(1, 2, Status::Running, started_at_ms),
        StatusEvent::new(1, 3, row.status, now_ms),
    ];
    JobRow { history, ..row }
}

fn insert(
    tx: &mut Tx<'_>,
    job: &NewJob,
    row: &JobRow,
    turn: i64,
    sharing: Sharing,
    place: Option<BatchPlace<'_>>,
    content: &[u8; 32],
) -> Result<()> {
    let history: String = row.history.iter().map(StatusEvent::line).collect();
    tx.insert(
        "jobs",
        &[
            ("id", row.id.as_str().into()),
            ("kind", row.kind.as_str().into()),
            ("owner", owner_column(job)),
            ("status", row.status.name().into()),
            ("attempt", row.attempt.into()),
            ("sequence", row.sequence.into()),
            ("turn", turn.into()),
            ("created_at", row.created_at_ms.into()),
            ("started_at", row.started_at_ms.into()),
            ("finished_at", row.finished_at_ms.into()),
            ("expires_at", row.expires_at_ms.into()),
            ("progress", row.progress.as_deref().into()),
            ("progress_sequence", row.progress_sequence.into()),
            ("statistics", row.statistics.as_deref().into()),
            ("summary", row.summary.as_deref().into()),
            ("warnings", row.warnings.as_str().into()),
            ("error", row.error.as_deref().into()),
            ("artefact", row.artefact.as_deref().into()),
            ("history", history.as_str().into()),
            ("idempotency_key", job.idempotency_key.as_deref().into()),
            ("body_hash", (&job.body_hash).into()),
            ("content_hash", content.into()),
            ("sharing", sharing.name().into()),
            ("callback_url", job.callback_url.as_deref().into()),
            ("callback_host", job.callback_url.as_deref().map(host_of).as_deref().into()),
            ("label", job.label.as_deref().into()),
            ("metadata", job.metadata.as_deref().into()),
            ("supersede", job.supersede.as_deref().into()),
            ("memory_bytes", limit(job.memory_bytes).into()),
            ("request_bytes", limit(job.request.len() as u64).into()),
            ("batch", row.batch.as_deref().into()),
            ("batch_index", place.map_or(0, |place| place.index).into()),
        ],
    )
}

pub(super) fn get(tx: &mut Tx<'_>, id: &str, owner: Option<&str>) -> Result<Lookup> {
    let text = format!("SELECT {COLUMNS} FROM jobs WHERE id = $1 AND ($2 = '' OR owner = $2)");
    let key = [id.into(), owner.unwrap_or_default().into()];
    if let Some(row) = tx.row(&text, &key)? {
        return Ok(Lookup::Found(Box::new(JobRow::read(&row)?)));
    }
    let gone = "SELECT 1 FROM expired_jobs WHERE id = $1 AND ($2 = '' OR owner = $2)";
    Ok(if tx.exists(gone, &key)? { Lookup::Expired } else { Lookup::Missing })
}

/// Returns an identifier that is smaller than those of all jobs that were submitted after a time. Lists then need not
/// read the rows of older jobs. Identifiers have the time of the process that made them, which may differ from the
/// database's clock. A day is more than clocks differ.
fn earliest_id(after_ms: i64) -> String {
    const MARGIN_MS: u64 = 24 * 3600 * 1000;
    ulid::Ulid::from_parts(u64::try_from(after_ms).unwrap_or(0).saturating_sub(MARGIN_MS), 0).to_string()
}

/// Returns at most `page` jobs, newest first, and the cursor of the next page if there is one. A row that cannot be
/// read is left out and logged.
pub(super) fn list(
    tx: &mut Tx<'_>,
    filter: &Filter,
    page: u32,
    cursor: Option<&str>,
) -> Result<(Vec<JobRow>, Option<String>)> {
    let mut values: Vec<Value<'_>> = vec![(i64::from(page) + 1).into()];
    let mut conditions: Vec<String> = Vec::new();
    let earliest = filter.created_after_ms.map(earliest_id);
    for (condition, value) in [
        ("owner =", filter.owner.as_deref()),
        ("kind =", filter.kind.as_deref()),
        ("idempotency_key =", filter.idempotency_key.as_deref()),
        ("label =", filter.label.as_deref()),
        ("batch =", filter.batch.as_deref()),
        ("id >=", earliest.as_deref()),
        ("id <", cursor),
    ] {
        if let Some(value) = value {
            values.push(value.into());
            conditions.push(format!("{condition} ${}", values.len()));
        }
    }
    if let Some(after_ms) = filter.created_after_ms {
        values.push(after_ms.into());
        conditions.push(format!("created_at > ${}", values.len()));
    }
    if !filter.statuses.is_empty() {
        let first = values.len() + 1;
        values.extend(filter.statuses.iter().map(|status| Value::from(status.name())));
        let places: Vec<String> = (first..=values.len()).map(|number| format!("${number}")).collect();
        conditions.push(match &places[..] {
            [only] => format!("status = {only}"),
            several => format!("status IN ({})", several.join(", ")),
        });
    }
    let conditions = if conditions.is_empty() { String::new() } else { format!("WHERE {}", conditions.join(" AND ")) };
    let columns = if filter.statistics {
        COLUMNS.to_owned()
    } else {
        COLUMNS.replace(" statistics,", " CAST(NULL AS TEXT) AS statistics,")
    };
    let text = format!("SELECT {columns} FROM jobs {conditions} ORDER BY id DESC LIMIT $1");
    let rows = tx.rows(&text, &values)?;
    let shown = &rows[..rows.len().min(page as usize)];
    let next = if rows.len() > shown.len() { shown.last().map(|row| row.get("id")).transpose()? } else { None };
    let read = |row: &Row| match JobRow::read(row) {
        Ok(job) => Some(job),
        Err(error) => {
            let id: String = row.get("id").unwrap_or_default();
            tracing::error!(%error, id, "a job's row cannot be read");
            None
        }
    };
    Ok((shown.iter().filter_map(read).collect(), next))
}

/// Cancels a queued or running job. Returns a finished job unchanged.
pub(super) fn cancel(
    tx: &mut Tx<'_>,
    id: &str,
    owner: Option<&str>,
    because: CancelReason,
    options: &StoreOptions,
) -> Result<Lookup> {
    let text = format!(
        "UPDATE jobs SET {}, cancelled_because = $4 WHERE id = $1 AND ($3 = '' OR owner = $3) AND status IN ('queued', 'running') \
         RETURNING {COLUMNS}",
        ending(Status::Cancelled)
    );
    let values =
        [id.into(), milliseconds(options.retention).into(), owner.unwrap_or_default().into(), because.name().into()];
    let Some(row) = tx.row(&text, &values)? else { return get(tx, id, owner) };
    release_source(tx, id)?;
    tx.changed(id);
    Ok(Lookup::Found(Box::new(JobRow::read(&row)?)))
}

/// Cancels the owner's jobs of a series that have not ended, and returns them. The newer job `successor` is stored in
/// the same transaction, so the order of the commits decides which job is the newest, not the clocks of the machines
/// that made the identifiers.
fn supersede(tx: &mut Tx<'_>, successor: &NewJob, series: &str, options: &StoreOptions) -> Result<Vec<JobRow>> {
    let owner = successor.owner.as_deref().unwrap_or_default();
    if tx.is_postgres() {
        // Without this lock, two simultaneous submissions of a series would not see each other's job.
        let lock = "SELECT pg_advisory_xact_lock(hashtextextended($1, $2))";
        tx.rows(lock, &[format!("{owner}\n{series}").as_str().into(), SERIES_LOCKS.into()])?;
    }
    let text = format!(
        "UPDATE jobs SET {}, cancelled_because = $4, successor = $5 \
         WHERE owner = $1 AND supersede = $3 AND finished_at IS NULL RETURNING {COLUMNS}",
        ending(Status::Cancelled)
    );
    let values = [
        owner.into(),
        milliseconds(options.retention).into(),
        series.into(),
        CancelReason::Superseded.name().into(),
        successor.id.as_str().into(),
    ];
    let rows = tx.rows(&text, &values)?;
    let cancelled: Vec<JobRow> = rows.iter().map(JobRow::read).collect::<Result<_>>()?;
    for job in &cancelled {
        release_source(tx, &job.id)?;
        tx.changed(&job.id);
    }
    Ok(cancelled)
}

/// Removes a job, whatever its status. Returns false if the job does not exist.
pub(super) fn delete(tx: &mut Tx<'_>, id: &str, owner: Option<&str>) -> Result<bool> {
    let text = "DELETE FROM jobs WHERE id = $1 AND ($2 = '' OR owner = $2)";
    if tx.execute(text, &[id.into(), owner.unwrap_or_default().into()])? == 0 {
        return Ok(false);
    }
    drop_request(tx, id)?;
    tx.changed(id);
    Ok(true)
}

/// Stores the request of a job with this status. A job that has ended does not need its source any more.
fn keep_request(tx: &mut Tx<'_>, job: &NewJob, status: Status) -> Result<()> {
    let source = job.source.as_deref().filter(|_| !status.is_final());
    // The sweep leaves recently touched results alone, so the result stays until this transaction is visible.
    if let Some(source) = source
        && !results::touch(tx, source)?
    {
        return Err(StoreError::Contended("the result from which the request begins has just been removed".into()));
    }
    let columns =
        [("job_id", job.id.as_str().into()), ("body", job.request.as_slice().into()), ("source", source.into())];
    tx.insert("requests", &columns)
}

/// Returns the kind and the request of a job, or `None` if there is no such job or its request is not kept.
pub(super) fn request(tx: &mut Tx<'_>, id: &str, owner: Option<&str>) -> Result<Option<(String, Vec<u8>)>> {
    let text = "SELECT kind, body FROM jobs JOIN requests ON job_id = id WHERE id = $1 AND ($2 = '' OR owner = $2)";
    let row = tx.row(text, &[id.into(), owner.unwrap_or_default().into()])?;
    row.map(|row| Ok((row.get("kind")?, row.get("body")?))).transpose()
}

/// Stores a job with a request and takes it back, to test whether the database takes jobs.
pub(super) fn probe(tx: &mut Tx<'_>, options: &StoreOptions) -> Result<()> {
    let job = NewJob {
        id: ulid::Ulid::generate().to_string(),
        kind: "probe".into(),
        owner: None,
        request: b"{}".to_vec(),
        source: None,
        request_hash: [0; 32],
        idempotency_key: None,
        body_hash: [0; 32],
        callback_url: None,
        label: None,
        metadata: None,
        supersede: None,
        memory_bytes: 0,
        reuse: false,
    };
    match add(tx, &job, None, None, options) {
        Ok(_) => delete(tx, &job.id, None).map(drop),
        // A full queue is an answer of the database, but nothing was written.
        Err(StoreError::QueueFull { .. }) => Ok(()),
        Err(error) => Err(error),
    }
}

/// Lets the result go from which the request of a job began that has ended.
pub(super) fn release_source(tx: &mut Tx<'_>, id: &str) -> Result<()> {
    let text = "UPDATE requests SET source = NULL WHERE job_id = $1 AND source IS NOT NULL";
    tx.execute(text, &[id.into()]).map(|_| ())
}

/// Deletes the request of a job that is removed.
pub(super) fn drop_request(tx: &mut Tx<'_>, id: &str) -> Result<()> {
    tx.execute("DELETE FROM requests WHERE job_id = $1", &[id.into()]).map(|_| ())
}
