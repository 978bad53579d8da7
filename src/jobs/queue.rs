//! Submitting: a body is read and checked, then put on disk, and only then acknowledged.

use super::{Jobs, JobsError};
use crate::store::{NewJob, StoreError, Submitted as Stored};
use crate::telemetry::metric;
use crate::wire::common::Cache;
use crate::wire::job::Job;
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
            let (request, value) = Request::read(kind, &body, &limits).map_err(JobsError::Rejected)?;
            let job = new_job(&request, value, owner, idempotency_key)?;
            Ok::<_, JobsError>((job, request))
        };
        let (job, request) = if inline { read()? } else { self.off_runtime(read).await?? };
        self.check_callback("", job.callback_url.as_deref())?;
        if at_once && let Some(slot) = self.solver_at_once(&job).await? {
            return self.solve_at_once(job, request, submitted_at, slot).await;
        }
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

fn canonical(value: &Value) -> Result<Vec<u8>, JobsError> {
    serde_json::to_vec(value).map_err(|error| JobsError::Internal(error.to_string()))
}

/// What equality of bodies means: keys sorted, numbers as f64 prints them.
pub(super) fn hash(value: &Value) -> Result<[u8; 32], JobsError> {
    Ok(Sha256::digest(canonical(value)?).into())
}

/// What the store keeps of a request that was read from `value`: its canonical form without what does not change the result.
pub(super) fn new_job(
    request: &Request,
    mut value: Value,
    owner: Option<String>,
    idempotency_key: Option<String>,
) -> Result<NewJob, JobsError> {
    // Without a key nothing is compared with it.
    let body_hash = if idempotency_key.is_some() { hash(&value)? } else { [0; 32] };
    if let Some(fields) = value.as_object_mut() {
        for name in ["kind", "cache", "callback_url"] {
            fields.remove(name);
        }
    }
    Ok(NewJob {
        id: ulid::Ulid::generate().to_string(),
        kind: request.kind().name().into(),
        owner,
        request: canonical(&value)?,
        body_hash,
        idempotency_key,
        warnings: "[]".into(),
        callback_url: request.callback_url().map(str::to_owned),
        reuse: request.cache() == Cache::Reuse,
    })
}
