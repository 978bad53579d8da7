//! Submitting: a body is read and checked, then put on disk, and only then acknowledged.

use super::{Jobs, JobsError, view};
use crate::store::{NewJob, Submitted as Stored};
use crate::telemetry::metric;
use crate::wire::job::Job;
use crate::wire::{Kind, Request};
use bytes::Bytes;
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
        // The canonical form (keys sorted, numbers as f64 prints them) is what is stored and what equality means.
        let read = move || -> Result<Vec<u8>, JobsError> {
            let (_, value) = Request::read(kind, &body, &limits).map_err(JobsError::Rejected)?;
            serde_json::to_vec(&value).map_err(|error| JobsError::Internal(error.to_string()))
        };
        let request = if inline { read()? } else { self.off_runtime(read).await?? };
        let job = NewJob {
            id: ulid::Ulid::generate().to_string(),
            kind: kind.name().into(),
            owner,
            body_hash: Sha256::digest(&request).into(),
            request,
            idempotency_key,
            warnings: "[]".into(),
            reuse: true,
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
