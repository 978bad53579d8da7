//! Submitting: a body is read and checked, then put on disk, and only then acknowledged.

use super::{Jobs, JobsError, view};
use crate::config::LimitsConfig;
use crate::store::{NewJob, Submitted as Stored};
use crate::telemetry::metric;
use crate::wire::common::Cache;
use crate::wire::job::Job;
use crate::wire::{Kind, Request};
use bytes::Bytes;
use serde_json::Value;
use sha2::{Digest, Sha256};

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
    /// Reads a body and puts the job on disk.
    ///
    /// # Errors
    /// [`JobsError::Rejected`] names every offending value; [`JobsError::QueueFull`], [`JobsError::KeyConflict`], or as the store.
    pub async fn submit(
        &self,
        kind: Kind,
        body: Bytes,
        owner: Option<String>,
        idempotency_key: Option<String>,
    ) -> Result<Submitted, JobsError> {
        let outcome = self.submit_unmetered(kind, body, owner, idempotency_key).await;
        let label = match &outcome {
            Ok(Submitted::Created(_)) => "created",
            Ok(Submitted::Existing(_)) => "repeated",
            Err(JobsError::QueueFull { .. }) => "queue_full",
            Err(JobsError::Rejected(_) | JobsError::KeyConflict) => "rejected",
            Err(_) => "failed",
        };
        metrics::counter!(metric::SUBMISSIONS, "kind" => kind.name(), "outcome" => label).increment(1);
        outcome
    }

    async fn submit_unmetered(
        &self,
        kind: Kind,
        body: Bytes,
        owner: Option<String>,
        idempotency_key: Option<String>,
    ) -> Result<Submitted, JobsError> {
        let limits = self.0.config.limits.clone();
        let inline = body.len() <= INLINE_BYTES;
        let read = move || Read::of(kind, &body, &limits);
        let Read { request, body_hash, reuse } = if inline { read()? } else { self.off_runtime(read).await?? };
        let job = NewJob {
            id: ulid::Ulid::generate().to_string(),
            kind: kind.name().into(),
            owner,
            request,
            body_hash,
            idempotency_key,
            warnings: "[]".into(),
            reuse,
        };
        match self.0.store.submit(job).await? {
            Stored::Created(row) => {
                tracing::info!(job_id = %row.id, kind = kind.name(), "submitted");
                Ok(Submitted::Created(view(&row)?))
            }
            Stored::Existing(row) => Ok(Submitted::Existing(view(&row)?)),
            Stored::KeyConflict => Err(JobsError::KeyConflict),
        }
    }
}

/// What the store needs of a body.
struct Read {
    /// The canonical form: keys sorted, numbers as f64 prints them, without what does not change the result. It is what is
    /// stored and what equality means.
    request: Vec<u8>,
    body_hash: [u8; 32],
    reuse: bool,
}

impl Read {
    fn of(kind: Kind, body: &[u8], limits: &LimitsConfig) -> Result<Self, JobsError> {
        let (request, mut value) = Request::read(kind, body, limits).map_err(JobsError::Rejected)?;
        let bytes = |value: &Value| serde_json::to_vec(value).map_err(|error| JobsError::Internal(error.to_string()));
        let body_hash = Sha256::digest(bytes(&value)?).into();
        if let Some(fields) = value.as_object_mut() {
            fields.remove("kind");
            fields.remove("cache");
        }
        Ok(Self { request: bytes(&value)?, body_hash, reuse: request.cache() == Cache::Reuse })
    }
}
