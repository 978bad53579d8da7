//! Submitting: a body is read and checked, then put on disk, and only then acknowledged.

use super::{Jobs, JobsError};
use crate::store::{NewJob, StoreError, Submitted as Stored};
use crate::telemetry::metric;
use crate::wire::body::{Body, Field};
use crate::wire::common::{Cache, Point};

use crate::wire::job::Job;
use crate::wire::json::integral;
use crate::wire::{Kind, Request};
use bytes::Bytes;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::time::Instant;

/// Bodies above this are parsed off the async threads.
const INLINE_BYTES: usize = 16 << 10;

/// What became of a submission.
#[derive(Debug)]
pub enum Submitted {
    /// A job that did not exist before, on disk.
    Created(Job),
    /// The job that the same idempotency key and body made before.
    Existing(Job),
}

impl Jobs {
    /// Reads a body and puts the job on disk. `at_once`: the client waits and no job is in the queue, so that it may be solved
    /// on the way.
    ///
    /// # Errors
    /// [`JobsError::Rejected`] names every offending value; [`JobsError::QueueFull`], [`JobsError::KeyConflict`], or as the store.
    pub async fn submit(
        &self,
        kind: Kind,
        body: Bytes,
        owner: Option<String>,
        idempotency_key: Option<String>,
        at_once: bool,
    ) -> Result<Submitted, JobsError> {
        let outcome = self.submit_unmetered(kind, body, owner, idempotency_key, at_once).await;
        let label = label(outcome.as_ref().map(|submitted| matches!(submitted, Submitted::Created(_))));
        metrics::counter!(metric::SUBMISSIONS, "kind" => kind.name(), "outcome" => label).increment(1);
        outcome
    }

    async fn submit_unmetered(
        &self,
        kind: Kind,
        body: Bytes,
        owner: Option<String>,
        idempotency_key: Option<String>,
        at_once: bool,
    ) -> Result<Submitted, JobsError> {
        let submitted_at = Instant::now();
        let limits = self.0.config.limits.clone();
        let inline = body.len() <= INLINE_BYTES;
        let read = move || {
            let (request, body) = Request::read(kind, &body, &limits).map_err(JobsError::Rejected)?;
            let submission = new_job(&request, body, owner, idempotency_key);
            Ok::<_, JobsError>((submission, request))
        };
        let (submission, request) = if inline { read()? } else { self.off_runtime(read).await?? };
        self.check_callback("", submission.job.callback_url.as_deref())?;
        if at_once && let Some(slot) = self.solver_at_once(&submission.job).await? {
            return self.solve_at_once(submission, request, submitted_at, slot).await;
        }
        let job = if inline { submission.stored()? } else { self.off_runtime(|| submission.stored()).await?? };
        self.submitted(self.0.store.submit(job).await)
    }

    /// What the store says of a submission, as a client sees it.
    pub(super) fn submitted(&self, stored: Result<Stored, StoreError>) -> Result<Submitted, JobsError> {
        match stored? {
            Stored::Created(row) => {
                tracing::info!(job_id = %row.id, kind = row.kind, "submitted");
                Ok(Submitted::Created(self.view(&row)?))
            }
            Stored::Existing(row) => Ok(Submitted::Existing(self.view(&row)?)),
            Stored::KeyConflict => Err(JobsError::KeyConflict),
        }
    }
}

/// A submission's outcome in the metrics; `Ok(true)` is a new job.
pub(super) fn label(outcome: Result<bool, &JobsError>) -> &'static str {
    match outcome {
        Ok(true) => "created",
        Ok(false) => "repeated",
        Err(JobsError::QueueFull { .. }) => "queue_full",
        Err(JobsError::Rejected(_) | JobsError::KeyConflict) => "rejected",
        Err(_) => "failed",
    }
}

/// A job to be, whose request has not been written out yet: one that is solved at once never needs it.
#[derive(Debug)]
pub(super) struct Submission {
    pub(super) job: NewJob,
    body: Body,
}

impl Submission {
    /// With its request as the store keeps it, for a worker.
    pub(super) fn stored(mut self) -> Result<NewJob, JobsError> {
        self.job.request = serde_json::to_vec(&self.body).map_err(|error| JobsError::Internal(error.to_string()))?;
        Ok(self.job)
    }
}

/// What equality of bodies means: the order of keys does not count, and numbers are what they are in f64.
pub(super) fn hash(body: &Body) -> [u8; 32] {
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

/// As the same arrays of arrays in a value.
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

/// One encoding for each value. Keys are sorted already, and integral numbers are integers (`json::parse`).
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

/// A request that was read from `body`, without what does not change the result.
pub(super) fn new_job(
    request: &Request,
    mut body: Body,
    owner: Option<String>,
    idempotency_key: Option<String>,
) -> Submission {
    // Without a key nothing is compared with it.
    let body_hash = if idempotency_key.is_some() { hash(&body) } else { [0; 32] };
    for name in ["kind", "cache", "callback_url"] {
        body.remove(name);
    }
    let job = NewJob {
        id: ulid::Ulid::generate().to_string(),
        kind: request.kind().name().into(),
        owner,
        request: Vec::new(),
        request_hash: hash(&body),
        body_hash,
        idempotency_key,
        warnings: "[]".into(),
        callback_url: request.callback_url().map(str::to_owned),
        reuse: request.cache() == Cache::Reuse,
    };
    Submission { job, body }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::json::parse;

    #[test]
    fn points_read_apart_hash_as_in_the_value() {
        let body =
            br#"{"up": "y", "directrices": [[[0, 1.0, -0.0], [1.5, 2e3, 1e30], [1, 2, 3], [0.1, -7, 9007199254740991]],
            [[0, 5, 0], [4, 5, 1], [4, 5, 2], [5, 5, 9]]], "normals": null, "cache": "bypass"}"#;
        let limits = crate::config::LimitsConfig::default();
        let (request, read) = Request::read(Kind::RuledSurface, body, &limits).unwrap();
        assert_eq!(read.lists().len(), 1);
        let whole = Body::from(parse(body).unwrap());
        assert_eq!(hash(&read), hash(&whole));
        let [apart, together] = [read, whole].map(|body| new_job(&request, body, None, None));
        assert_eq!(apart.job.request_hash, together.job.request_hash);
        let stored = [apart, together].map(|job| parse(&job.stored().unwrap().request).unwrap());
        assert_eq!(stored[0], stored[1]);
        assert!(stored[0].get("cache").is_none() && stored[0]["directrices"][0][3][1] == -7);
    }

    #[test]
    fn equal_bodies_have_equal_hashes_and_others_do_not() {
        let of = |text: &str| hash(&parse(text.as_bytes()).unwrap().into());
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
