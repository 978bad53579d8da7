//! Submits jobs. A body is read and checked, then stored, and only then acknowledged.
//!
//! A small job whose client waits is solved on the thread that read it, and job and result are stored in one write.
//! This costs one disk sync instead of three. Nothing is promised before that write, because the client has no answer
//! yet. If the process dies before the write, the submission leaves no trace, as if the process had died while it read
//! the body.

use super::attempt::{Attempt, AttemptEnd, Start};
use super::sources::Sources;
use super::{Jobs, JobsError, view};
use crate::config::LimitsConfig;
use crate::store::{Addition, BatchAddition, EarlyEnd, NewBatch, NewJob, StoreError};
use crate::telemetry::metric;
use crate::wire::batch::{Batch, BatchRequest};
use crate::wire::envelope::Cache;
use crate::wire::incoming::{CheckedJob, Incoming};
use crate::wire::job::Job;
use bytes::Bytes;
use plateau_engine::kind::Kind;
use plateau_engine::limits::{refuse_too_many_values, refuse_too_much_as_values};
use plateau_engine::request::Request;
use plateau_strict_json::json;
use plateau_strict_json::rejection::{FieldError, Rejection};
use serde_json::{Map, Value};
use sha2::{Digest, Sha256};
use std::io::{self, Write};
use std::time::Instant;

/// Size in bytes up to which bodies are parsed on the async threads. Larger bodies go to the converters.
const INLINE_BYTES: usize = 16 << 10;

/// Result of submitting a job or a batch.
#[derive(Debug)]
pub enum Submitted<T> {
    /// The submission created a job or batch, which is on disk.
    Created(T),
    /// An earlier submission with the same idempotency key and body created the job or batch.
    Existing(T),
}

/// A job that was submitted, and the options that concern the connection of its client.
#[derive(Debug)]
pub struct Submission {
    pub submitted: Submitted<Job>,
    /// True if the job must be cancelled when the client goes away while it waits for the end.
    pub cancel_on_disconnect: bool,
}

/// The client that submits a job.
#[derive(Debug)]
pub struct Submitter {
    pub owner: Option<String>,
    pub idempotency_key: Option<String>,
}

impl Jobs {
    /// Reads a body and stores the job. If `waited_for` is true, the client waits for the end, and a small job may be
    /// solved during the submission.
    ///
    /// # Errors
    /// Returns [`JobsError::Rejected`] with every offending value, [`JobsError::QueueFull`], [`JobsError::KeyConflict`]
    /// or an error of the store.
    pub async fn submit(
        &self,
        kind: Kind,
        body: Bytes,
        from: Submitter,
        waited_for: bool,
    ) -> Result<Submission, JobsError> {
        let mut cancel_on_disconnect = false;
        let submitted = read_and_store(self, kind, body, from, waited_for, &mut cancel_on_disconnect).await;
        count(kind.name(), &submitted);
        Ok(Submission { submitted: submitted?, cancel_on_disconnect })
    }

    /// Reads a batch's body and stores all of its jobs, or none of them.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::submit`].
    pub async fn submit_batch(&self, body: Bytes, from: Submitter) -> Result<Submitted<Batch>, JobsError> {
        let submitted = read_and_store_batch(self, body, from).await;
        count("batch", &submitted);
        submitted
    }
}

async fn read_and_store(
    jobs: &Jobs,
    kind: Kind,
    body: Bytes,
    from: Submitter,
    waited_for: bool,
    cancel_on_disconnect: &mut bool,
) -> Result<Submitted<Job>, JobsError> {
    let submitted_at = Instant::now();
    let limits = jobs.config().limits.clone();
    let inline = body.len() <= INLINE_BYTES;
    // The source of a request is read from the store, for which a thread of the runtime must not wait.
    let inline = inline && !kind.has_source();
    // A repetition is answered although its source may be gone, so the hash of its body does not depend on the source.
    let mut body_hash = None;
    if kind.has_source()
        && let Some(key) = &from.idempotency_key
    {
        let (body, limits) = (body.clone(), limits.clone());
        body_hash = jobs.off_runtime(move || hash_of_body(&body, &limits)).await?;
        if let Some(hash) = body_hash
            && let Some(earlier) = jobs.store().earlier_job(from.owner.as_deref(), kind.name(), key, hash).await?
        {
            return answer(jobs, Ok(earlier));
        }
    }
    let sources = Sources::new(jobs, from.owner.clone());
    let read = move || {
        let read = Incoming::read(kind, &body, &|id| sources.find(id), &limits);
        let Incoming { request, envelope, text } = read.map_err(|rejection| sources.refused(rejection))?;
        let waits = envelope.cancel_on_disconnect;
        let job = new_job(CheckedJob::of(&request, envelope, text), from);
        let job = NewJob { body_hash: body_hash.unwrap_or(job.body_hash), ..job };
        Ok::<_, JobsError>((job, request, waits))
    };
    let (job, request, waits) = if inline { read()? } else { jobs.off_runtime(read).await?? };
    check_callback(jobs, "", job.callback_url.as_deref())?;
    *cancel_on_disconnect = waits;
    if *cancel_on_disconnect && !waited_for {
        return Err(invalid("/cancel_on_disconnect", "needs a request that waits: send `Prefer: wait=N`"));
    }
    store(jobs, job, &request, submitted_at, waited_for).await
}

async fn store(
    jobs: &Jobs,
    job: NewJob,
    request: &Request,
    submitted_at: Instant,
    waited_for: bool,
) -> Result<Submitted<Job>, JobsError> {
    if waited_for && let Some((attempt, solved)) = solve_here(jobs, &job, request, submitted_at) {
        let end = AttemptEnd::of(&solved.outcome);
        let stored = jobs.store().add_ended_job(job, solved).await;
        // If the submission was refused, or if an equal submission was stored first, this result is not used.
        let created = matches!(stored, Ok(Addition::Created(..)));
        attempt.end(if created { end } else { AttemptEnd::Dropped });
        return answer(jobs, stored);
    }
    answer(jobs, jobs.store().add_job(job).await)
}

/// Solves a small job on this thread if a solver's slot is free at once. A free slot also means that no job waits for a
/// solver of this process, except for jobs that wait for memory. A quick job needs a few megabytes at most, which the
/// budget does not count.
fn solve_here(jobs: &Jobs, job: &NewJob, request: &Request, submitted_at: Instant) -> Option<(Attempt, EarlyEnd)> {
    if !request.quick || jobs.is_shutting_down() {
        return None;
    }
    #[cfg(feature = "test-hooks")]
    if crate::test_hooks::holds(&job.kind) {
        return None;
    }
    let _slot = jobs.slots().try_acquire_owned().ok()?;
    let started_at = Instant::now();
    let waited_ms = milliseconds(started_at - submitted_at);
    let start = Start {
        id: &job.id,
        kind: &job.kind,
        owner: job.owner.as_deref(),
        attempt: 1,
        waited_ms,
        memory_bytes: job.memory_bytes,
    };
    let attempt = Attempt::begin(jobs, start);
    // Only a cancelled job has no outcome, and a client cannot cancel this job because it does not know the identifier
    // yet.
    let outcome = attempt.solve(request, &job.request_hash)?;
    let (submitted_ms, started_ms) = (milliseconds(submitted_at.elapsed()), milliseconds(started_at.elapsed()));
    Some((attempt, EarlyEnd { outcome, submitted_ms, started_ms }))
}

fn answer(jobs: &Jobs, stored: Result<Addition, StoreError>) -> Result<Submitted<Job>, JobsError> {
    match stored? {
        Addition::Created(row, superseded) => {
            jobs.superseded(&superseded);
            tracing::info!(job_id = %row.id, kind = row.kind, "submitted");
            Ok(Submitted::Created(jobs.view(&row)?))
        }
        Addition::Existing(row) => Ok(Submitted::Existing(jobs.view(&row)?)),
        Addition::KeyConflict => Err(JobsError::KeyConflict),
    }
}

async fn read_and_store_batch(jobs: &Jobs, body: Bytes, from: Submitter) -> Result<Submitted<Batch>, JobsError> {
    let limits = jobs.config().limits.clone();
    let sources = Sources::new(jobs, from.owner.clone());
    let read = move || {
        let read = BatchRequest::read(&body, &|id| sources.find(id), &limits);
        read.map_err(|rejection| sources.refused_batch(rejection))
    };
    let BatchRequest { requests, callback_url, hash: body_hash } = jobs.off_runtime(read).await??;
    check_callback(jobs, "", callback_url.as_deref())?;
    let Submitter { owner, idempotency_key } = from;
    let mut new_jobs = Vec::with_capacity(requests.len());
    for (index, request) in requests.into_iter().enumerate() {
        let envelope = &request.envelope;
        check_callback(jobs, &format!("/requests/{index}"), envelope.callback_url.as_deref())?;
        for (name, given) in
            [("supersede", envelope.supersede.is_some()), ("cancel_on_disconnect", envelope.cancel_on_disconnect)]
        {
            if given {
                return Err(invalid(&format!("/requests/{index}/{name}"), "is not allowed in a batch"));
            }
        }
        let from = Submitter { owner: owner.clone(), idempotency_key: None };
        new_jobs.push(new_job(request, from));
    }
    let id = ulid::Ulid::generate().to_string();
    let batch = NewBatch { id, owner, idempotency_key, body_hash, callback_url, jobs: new_jobs };
    let base = &jobs.config().http.public_base_path;
    match jobs.store().add_batch(batch).await? {
        BatchAddition::Created(row) => {
            tracing::info!(batch_id = %row.id, jobs = row.size, "submitted a batch");
            Ok(Submitted::Created(view::batch(base, &row)))
        }
        BatchAddition::Existing(row) => Ok(Submitted::Existing(view::batch(base, &row))),
        BatchAddition::KeyConflict => Err(JobsError::KeyConflict),
    }
}

/// Returns `Rejected` if webhooks are off, or if messages cannot be sent to the callback URL.
fn check_callback(jobs: &Jobs, pointer: &str, url: Option<&str>) -> Result<(), JobsError> {
    let Some(url) = url else { return Ok(()) };
    let checked = match jobs.webhooks() {
        Some(sender) => sender.check(url),
        None => Err("cannot be used because webhooks are off on this server"),
    };
    checked.map_err(|reason| invalid(&format!("{pointer}/callback_url"), reason))
}

fn invalid(pointer: &str, detail: impl Into<String>) -> JobsError {
    JobsError::Rejected(Rejection::Invalid(vec![FieldError::new(pointer, detail)]))
}

fn count<T>(kind: &'static str, submitted: &Result<Submitted<T>, JobsError>) {
    let outcome = match submitted {
        Ok(Submitted::Created(_)) => "created",
        Ok(Submitted::Existing(_)) => "repeated",
        Err(JobsError::QueueFull { .. }) => "queue_full",
        Err(JobsError::Rejected(_) | JobsError::NoSource { .. } | JobsError::KeyConflict) => "rejected",
        Err(_) => "failed",
    };
    metrics::counter!(metric::SUBMISSIONS, "kind" => kind, "outcome" => outcome).increment(1);
}

fn milliseconds(duration: std::time::Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX)
}

/// Returns the hash of a body. The keys of a map are sorted, and integral numbers are integers (see `json::parse`).
/// Returns `None` for a body that is not JSON or would take too much memory as JSON values.
pub(crate) fn hash_of_body(body: &[u8], limits: &LimitsConfig) -> Option<[u8; 32]> {
    refuse_too_many_values(body, &limits.requests()).ok()?;
    refuse_too_much_as_values(body).ok()?;
    let value = json::parse(body).ok()?;
    let mut hasher = HashWriter(Sha256::new());
    // A JSON value is always written as the same text, and writing it here cannot fail.
    serde_json::to_writer(&mut hasher, &value).ok()?;
    Some(hasher.0.finalize().into())
}

/// A writer that hashes the bytes and keeps none of them, so that a long text is in memory only once.
struct HashWriter(Sha256);

impl Write for HashWriter {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Returns the hash of a request's text and of the members that were taken out of it. Equal requests have equal hashes,
/// because a JSON value is always written as the same text.
fn hash(text: &[u8], members: &Map<String, Value>) -> [u8; 32] {
    let mut hasher = Sha256::new_with_prefix(text);
    if !members.is_empty() {
        hasher.update(Value::Object(members.clone()).to_string());
    }
    hasher.finalize().into()
}

/// Returns the job of a request that was read.
fn new_job(request: CheckedJob, from: Submitter) -> NewJob {
    let CheckedJob { kind, memory_bytes, source, envelope, text } = request;
    let Submitter { owner, idempotency_key } = from;
    // The hash is only compared between submissions with an idempotency key.
    let body_hash = if idempotency_key.is_some() { hash(&text, &envelope.members) } else { [0; 32] };
    NewJob {
        id: ulid::Ulid::generate().to_string(),
        kind: kind.name().into(),
        owner,
        request_hash: hash(&text, &Map::new()),
        request: text,
        source,
        body_hash,
        idempotency_key,
        callback_url: envelope.callback_url,
        label: envelope.label,
        metadata: envelope.metadata,
        supersede: envelope.supersede,
        memory_bytes,
        reuse: envelope.cache == Cache::Reuse,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_engine::kinds::ruled_surface;
    use plateau_engine::source::no_jobs;

    fn job(body: &str, key: Option<&str>) -> NewJob {
        let limits = LimitsConfig::default();
        let Incoming { request, envelope, text } =
            Incoming::read(ruled_surface::KIND, body.as_bytes(), &no_jobs, &limits)
                .unwrap_or_else(|error| panic!("{body}: {error:?}"));
        let from = Submitter { owner: None, idempotency_key: key.map(Into::into) };
        new_job(CheckedJob::of(&request, envelope, text), from)
    }

    const RAILS: &str = r#""directrices": [[[0, 1, -0.0], [1.5, 2e3, 1e30]], [[0, 5, 0], [4, 5, 1]]]"#;

    #[test]
    fn requests_that_mean_the_same_have_one_hash() {
        let plain = job(&format!("{{{RAILS}}}"), None);
        for other in [
            format!(r#"{{"units": "m", "up": "z", {RAILS}}}"#),
            format!(r#"{{{RAILS}, "kind": "ruled_surface", "normals": null, "label": "a", "cache": "bypass"}}"#),
            format!(
                r#"{{"objective": "minimal_area", "closed": false, {RAILS}, "convexity_tolerance_deg": 0.000001}}"#
            ),
            format!(
                "{{{}}}",
                RAILS.replace("1.5", "15e-1").replace("[0, 5, 0]", "[0.0, 5.0, 0e1]").replace("2e3", "2000")
            ),
        ] {
            let other = job(&other, None);
            assert_eq!(String::from_utf8_lossy(&other.request), String::from_utf8_lossy(&plain.request));
            assert_eq!(other.request_hash, plain.request_hash);
        }
        for other in [
            format!(r#"{{"units": "mm", {RAILS}}}"#),
            format!("{{{}}}", RAILS.replace("-0.0", "0")),
            format!("{{{}}}", RAILS.replace("1.5", "1.5000000000000002")),
            format!(r#"{{"sampling": {{"by": "arc_length", "samples": 2050.0}}, {RAILS}}}"#),
        ] {
            assert_ne!(job(&other, None).request_hash, plain.request_hash, "{other}");
        }
    }

    #[test]
    fn what_a_request_says_of_its_job_counts_for_its_idempotency_key_only() {
        let [plain, labelled] =
            ["", r#", "label": "a", "metadata": {"b": 1}"#].map(|more| job(&format!("{{{RAILS}{more}}}"), Some("k")));
        assert_eq!(plain.request_hash, labelled.request_hash);
        assert_ne!(plain.body_hash, labelled.body_hash);
        let reordered = job(&format!(r#"{{"metadata": {{"b": 1.0}}, {RAILS}, "label": "a"}}"#), Some("k"));
        assert_eq!(reordered.body_hash, labelled.body_hash);
    }
}
