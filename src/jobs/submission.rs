//! Submits jobs. A body is read and checked, then stored, and only then acknowledged.
//!
//! A small job whose client waits is solved on the thread that read it, and job and result are stored in one write.
//! This costs one disk sync instead of three. Nothing is promised before that write, because the client has no answer
//! yet. If the process dies before the write, the submission leaves no trace, as if the process had died while it read
//! the body.

use super::attempt::{Attempt, End};
use super::{Jobs, JobsError, view};
use crate::store::{NewBatch, NewJob, Solved, StoreError, Submitted as Stored, SubmittedBatch as StoredBatch};
use crate::telemetry::metric;
use crate::wire::batch::{Batch, BatchRequest};
use crate::wire::envelope::{Cache, Envelope};
use crate::wire::incoming::Incoming;
use crate::wire::job::Job;
use bytes::Bytes;
use plateau_forms::body::{Body, Field};
use plateau_forms::common::Point;
use plateau_forms::json::integral;
use plateau_forms::kind::Kind;
use plateau_forms::rejection::{FieldError, Rejection};
use plateau_forms::request::Request;
use serde_json::{Map, Value};
use sha2::{Digest, Sha256};
use std::time::Instant;

/// Size in bytes up to which bodies are parsed on the async threads. Larger bodies go to the converters.
const INLINE_BYTES: usize = 16 << 10;

/// Result of submitting a job or a batch.
#[derive(Debug)]
pub enum Submitted<T> {
    /// The submission created a job or batch, which is on disk.
    Created(T),
    /// An earlier submission with the same idempotency key and body created it.
    Existing(T),
}

/// A job that was submitted, and what its client asked of it.
#[derive(Debug)]
pub struct Accepted {
    pub submitted: Submitted<Job>,
    /// Cancel the job if the client goes away while it waits.
    pub cancel_on_disconnect: bool,
}

/// The client that submits a job.
#[derive(Debug)]
pub struct Submitter {
    pub owner: Option<String>,
    pub idempotency_key: Option<String>,
}

/// A job whose request has not been serialized yet. A job that is solved at once is never serialized.
struct Submission {
    job: NewJob,
    body: Body,
}

impl Submission {
    /// Returns the job with its request in the form that a worker reads.
    fn written(mut self) -> Result<NewJob, JobsError> {
        self.job.request = serde_json::to_vec(&self.body).map_err(|error| JobsError::Internal(error.to_string()))?;
        Ok(self.job)
    }
}

pub(super) async fn job(
    jobs: &Jobs,
    kind: Kind,
    body: Bytes,
    from: Submitter,
    waited_for: bool,
) -> Result<Accepted, JobsError> {
    let mut cancel_on_disconnect = false;
    let submitted = read_and_store(jobs, kind, body, from, waited_for, &mut cancel_on_disconnect).await;
    count(kind.name(), &submitted);
    Ok(Accepted { submitted: submitted?, cancel_on_disconnect })
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
    let read = move || {
        let Incoming { request, envelope, body } = Incoming::read(kind, &body, &limits).map_err(JobsError::Rejected)?;
        let waits = envelope.cancel_on_disconnect;
        Ok::<_, JobsError>((submission(&request, envelope, body, from), request, waits))
    };
    let (submission, request, waits) = if inline { read()? } else { jobs.off_runtime(read).await?? };
    check_callback(jobs, "", submission.job.callback_url.as_deref())?;
    *cancel_on_disconnect = waits;
    if *cancel_on_disconnect && !waited_for {
        return Err(invalid("/cancel_on_disconnect", "needs a request that waits: send `Prefer: wait=N`"));
    }
    store(jobs, submission, &request, submitted_at, inline, waited_for).await
}

async fn store(
    jobs: &Jobs,
    submission: Submission,
    request: &Request,
    submitted_at: Instant,
    inline: bool,
    waited_for: bool,
) -> Result<Submitted<Job>, JobsError> {
    if waited_for && let Some((attempt, solved)) = solve_here(jobs, &submission.job, request, submitted_at) {
        let status = solved.outcome.status();
        let stored = jobs.store().submit_solved(submission.job, solved).await;
        // If the submission was refused, or if an equal submission was stored first, this result is not used.
        let created = matches!(stored, Ok(Stored::Created(..)));
        attempt.end(if created { End::Finished(status) } else { End::Dropped });
        return answer(jobs, stored);
    }
    let job = if inline { submission.written()? } else { jobs.off_runtime(|| submission.written()).await?? };
    answer(jobs, jobs.store().submit(job).await)
}

/// Solves a small job on this thread if a solver's slot is free at once. A free slot also means that no job waits for a
/// solver of this process, except for jobs that wait for memory. A quick job needs a few megabytes at most, which the
/// budget does not count.
fn solve_here(jobs: &Jobs, job: &NewJob, request: &Request, submitted_at: Instant) -> Option<(Attempt, Solved)> {
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
    let attempt = Attempt::begin(jobs, &job.id, &job.kind, 1, waited_ms);
    // Only a cancelled job has no outcome, and a client cannot cancel this job because it does not know the identifier
    // yet.
    let outcome = attempt.solve(request)?;
    let (submitted_ms, started_ms) = (milliseconds(submitted_at.elapsed()), milliseconds(started_at.elapsed()));
    Some((attempt, Solved { outcome, submitted_ms, started_ms }))
}

fn answer(jobs: &Jobs, stored: Result<Stored, StoreError>) -> Result<Submitted<Job>, JobsError> {
    match stored? {
        Stored::Created(row, superseded) => {
            jobs.superseded(&superseded);
            tracing::info!(job_id = %row.id, kind = row.kind, "submitted");
            Ok(Submitted::Created(jobs.view(&row)?))
        }
        Stored::Existing(row) => Ok(Submitted::Existing(jobs.view(&row)?)),
        Stored::KeyConflict => Err(JobsError::KeyConflict),
    }
}

pub(super) async fn batch(jobs: &Jobs, body: Bytes, from: Submitter) -> Result<Submitted<Batch>, JobsError> {
    let submitted = read_and_store_batch(jobs, body, from).await;
    count("batch", &submitted);
    submitted
}

async fn read_and_store_batch(jobs: &Jobs, body: Bytes, from: Submitter) -> Result<Submitted<Batch>, JobsError> {
    let limits = jobs.config().limits.clone();
    let read = move || BatchRequest::read(&body, &limits).map_err(JobsError::Rejected);
    let BatchRequest { requests, callback_url, value } = jobs.off_runtime(read).await??;
    check_callback(jobs, "", callback_url.as_deref())?;
    let body_hash = hash(&value.into(), &Map::new());
    let Submitter { owner, idempotency_key } = from;
    let mut new_jobs = Vec::with_capacity(requests.len());
    for (index, Incoming { request, envelope, body }) in requests.into_iter().enumerate() {
        check_callback(jobs, &format!("/requests/{index}"), envelope.callback_url.as_deref())?;
        for (name, given) in
            [("supersede", envelope.supersede.is_some()), ("cancel_on_disconnect", envelope.cancel_on_disconnect)]
        {
            if given {
                return Err(invalid(&format!("/requests/{index}/{name}"), "is not allowed in a batch"));
            }
        }
        let from = Submitter { owner: owner.clone(), idempotency_key: None };
        new_jobs.push(submission(&request, envelope, body, from).written()?);
    }
    let id = ulid::Ulid::generate().to_string();
    let batch = NewBatch { id, owner, idempotency_key, body_hash, callback_url, jobs: new_jobs };
    let base = &jobs.config().http.public_base_path;
    match jobs.store().submit_batch(batch).await? {
        StoredBatch::Created(row) => {
            tracing::info!(batch_id = %row.id, jobs = row.size, "submitted a batch");
            Ok(Submitted::Created(view::batch(base, &row)?))
        }
        StoredBatch::Existing(row) => Ok(Submitted::Existing(view::batch(base, &row)?)),
        StoredBatch::KeyConflict => Err(JobsError::KeyConflict),
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
        Err(JobsError::Rejected(_) | JobsError::KeyConflict) => "rejected",
        Err(_) => "failed",
    };
    metrics::counter!(metric::SUBMISSIONS, "kind" => kind, "outcome" => outcome).increment(1);
}

fn milliseconds(duration: std::time::Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX)
}

/// Returns the hash of a body and of the members that were taken out of it. The order of the keys does not change the
/// hash, and numbers are compared as f64.
fn hash(body: &Body, members: &Map<String, Value>) -> [u8; 32] {
    let mut bytes = Vec::new();
    match body.fields() {
        None => write(body.outline(), &mut bytes),
        Some(fields) => {
            tagged(7, fields.len() as u64, &mut bytes);
            for (name, field) in fields {
                write_text(name, &mut bytes);
                match field {
                    Field::Value(value) => write(value, &mut bytes),
                    Field::Points(polylines) => write_polylines(polylines, &mut bytes),
                }
            }
        }
    }
    for (name, member) in members {
        write_text(name, &mut bytes);
        write(member, &mut bytes);
    }
    Sha256::digest(bytes).into()
}

fn tagged(tag: u8, value: u64, out: &mut Vec<u8>) {
    out.push(tag);
    out.extend_from_slice(&value.to_le_bytes());
}

fn write_text(text: &str, out: &mut Vec<u8>) {
    tagged(5, text.len() as u64, out);
    out.extend_from_slice(text.as_bytes());
}

/// Writes polylines exactly as [`write`] writes the same arrays in a value.
fn write_polylines(polylines: &[Vec<Point>], out: &mut Vec<u8>) {
    tagged(6, polylines.len() as u64, out);
    for polyline in polylines {
        tagged(6, polyline.len() as u64, out);
        for point in polyline {
            tagged(6, point.len() as u64, out);
            for &coordinate in point {
                match integral(coordinate) {
                    Some(integer) => tagged(2, integer as u64, out),
                    None => tagged(4, coordinate.to_bits(), out),
                }
            }
        }
    }
}

/// Writes a value in its only encoding. The keys are sorted already, and integral numbers are integers (see
/// `json::parse`).
fn write(value: &Value, out: &mut Vec<u8>) {
    match value {
        Value::Null => out.push(0),
        Value::Bool(value) => out.extend_from_slice(&[1, u8::from(*value)]),
        Value::Number(value) => {
            let (tag, bits) = match (value.as_i64(), value.as_u64()) {
                (Some(value), _) => (2, value as u64),
                (None, Some(value)) => (3, value),
                (None, None) => (4, value.as_f64().unwrap_or_default().to_bits()),
            };
            tagged(tag, bits, out);
        }
        Value::String(text) => write_text(text, out),
        Value::Array(items) => {
            tagged(6, items.len() as u64, out);
            items.iter().for_each(|item| write(item, out));
        }
        Value::Object(fields) => {
            tagged(7, fields.len() as u64, out);
            for (name, field) in fields {
                write_text(name, out);
                write(field, out);
            }
        }
    }
}

/// Returns the submission of a request that was read from `body`.
fn submission(request: &Request, envelope: Envelope, mut body: Body, from: Submitter) -> Submission {
    let Submitter { owner, idempotency_key } = from;
    // The hash is only compared between submissions with an idempotency key.
    let body_hash = if idempotency_key.is_some() { hash(&body, &envelope.members) } else { [0; 32] };
    // The kind is compared beside the hash, and a body whose path names the kind may leave it out.
    body.take("kind");
    let job = NewJob {
        id: ulid::Ulid::generate().to_string(),
        kind: request.kind().name().into(),
        owner,
        request: Vec::new(),
        request_hash: hash(&body, &Map::new()),
        body_hash,
        idempotency_key,
        callback_url: envelope.callback_url,
        label: envelope.label,
        metadata: envelope.metadata,
        supersede: envelope.supersede,
        memory_bytes: request.memory_bytes,
        reuse: envelope.cache == Cache::Reuse,
    };
    Submission { job, body }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_forms::json::parse;
    use plateau_forms::kinds::ruled_surface;

    #[test]
    fn a_body_has_the_same_hash_whether_its_points_were_read_apart_or_not() {
        let body =
            br#"{"up": "y", "directrices": [[[0, 1.0, -0.0], [1.5, 2e3, 1e30], [1, 2, 3], [0.1, -7, 9007199254740991]],
            [[0, 5, 0], [4, 5, 1], [4, 5, 2], [5, 5, 9]]], "normals": null, "cache": "bypass"}"#;
        let limits = crate::config::LimitsConfig::default();
        let Incoming { request, envelope, body: read } = Incoming::read(ruled_surface::KIND, body, &limits).unwrap();
        assert_eq!(read.lists().len(), 1);
        let mut whole = Body::from(parse(body).unwrap());
        whole.take("cache");
        let none = Map::new();
        assert_eq!(hash(&read, &none), hash(&whole, &none));
        assert_ne!(hash(&read, &envelope.members), hash(&read, &none));
        let from = || Submitter { owner: None, idempotency_key: None };
        let [apart, together] = [read, whole].map(|body| submission(&request, envelope.clone(), body, from()));
        assert_eq!(apart.job.request_hash, together.job.request_hash);
        let stored = [apart, together].map(|job| parse(&job.written().unwrap().request).unwrap());
        assert_eq!(stored[0], stored[1]);
        assert!(stored[0].get("cache").is_none() && stored[0]["directrices"][0][3][1] == -7);
    }

    #[test]
    fn equal_bodies_have_equal_hashes_and_different_bodies_different_ones() {
        let of = |text: &str| hash(&parse(text.as_bytes()).unwrap().into(), &Map::new());
        for (one, other) in [
            (r#"{"a":1,"b":[2,3]}"#, r#"{ "b": [2.0, 3e0], "a": 1.00 }"#),
            (r#"{"a":0.1}"#, r#"{"a":1e-1}"#),
            (r#""\u0041""#, r#""A""#),
        ] {
            assert_eq!(of(one), of(other), "{one} {other}");
        }
        let different = [
            "null",
            "false",
            "true",
            "0",
            "-0.0",
            "1",
            "-1",
            "0.1",
            "0.2",
            "9223372036854775808",
            "1e300",
            "\"\"",
            "\"a\"",
            "[]",
            "{}",
            "[[]]",
            "[[],[]]",
            "[[[]]]",
            "[1,2]",
            "[[1],2]",
            "[12]",
            "{\"a\":1}",
            "{\"a\":{}}",
            "{\"b\":1}",
            "[\"a\",1]",
            "{\"a\":[1,2]}",
            "{\"a\":[1],\"b\":2}",
            "\"a1\"",
        ];
        let hashes: std::collections::BTreeSet<_> = different.iter().map(|text| of(text)).collect();
        assert_eq!(hashes.len(), different.len());
    }
}
