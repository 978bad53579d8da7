//! Batches: many requests taken at once, each a job like any other, with one status and one file of all their meshes.

use super::files::File;
use super::{Jobs, JobsError, timestamp};
use crate::export::zip::Zip;
use crate::export::{Archive, MeshFormat, gltf};
use crate::store::{BatchLookup, BatchRow, JobRow, NewBatch, SubmittedBatch};
use crate::telemetry::metric;
use crate::wire::batch::{Batch, BatchCounts, BatchJob, BatchLinks, BatchRequest};
use crate::wire::job::Status;
use crate::wire::{FieldError, Kind, Rejection};
use bytes::Bytes;
use futures_util::stream::{self, Stream};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::collections::VecDeque;
use std::time::Duration;

/// What became of a batch's submission.
#[derive(Debug)]
pub enum Submitted {
    /// A batch that did not exist before, on disk.
    Created(Batch),
    /// The batch that the same idempotency key and body made before.
    Existing(Batch),
}

/// Triangles that one archive may hold: at 200 bytes each, the largest that any format takes, they are what a ZIP can address.
const ARCHIVE_TRIANGLES: u64 = 20_000_000;

impl Jobs {
    /// Reads a batch's body and puts its jobs on disk, all or none.
    ///
    /// # Errors
    /// As [`Jobs::submit`].
    pub async fn submit_batch(
        &self,
        body: Bytes,
        owner: Option<String>,
        idempotency_key: Option<String>,
    ) -> Result<Submitted, JobsError> {
        let outcome = self.submit_batch_unmetered(body, owner, idempotency_key).await;
        let label = super::queue::label(outcome.as_ref().map(|submitted| matches!(submitted, Submitted::Created(_))));
        metrics::counter!(metric::SUBMISSIONS, "kind" => "batch", "outcome" => label).increment(1);
        outcome
    }

    async fn submit_batch_unmetered(
        &self,
        body: Bytes,
        owner: Option<String>,
        idempotency_key: Option<String>,
    ) -> Result<Submitted, JobsError> {
        let limits = self.0.config.limits.clone();
        let read = move || BatchRequest::read(&body, &limits).map_err(JobsError::Rejected);
        let BatchRequest { requests, callback_url, value } = self.off_runtime(read).await??;
        self.check_callback("", callback_url.as_deref())?;
        let body_hash = super::queue::hash(&value.into());
        let mut jobs = Vec::with_capacity(requests.len());
        for (index, (request, value)) in requests.into_iter().enumerate() {
            self.check_callback(&format!("/requests/{index}"), request.callback_url())?;
            jobs.push(super::queue::new_job(&request, value.into(), owner.clone(), None).stored()?);
        }
        let id = ulid::Ulid::generate().to_string();
        match self.0.store.submit_batch(NewBatch { id, owner, idempotency_key, body_hash, callback_url, jobs }).await? {
            SubmittedBatch::Created(row) => {
                tracing::info!(batch_id = %row.id, jobs = row.size, "submitted a batch");
                Ok(Submitted::Created(self.view_batch(&row)?))
            }
            SubmittedBatch::Existing(row) => Ok(Submitted::Existing(self.view_batch(&row)?)),
            SubmittedBatch::KeyConflict => Err(JobsError::KeyConflict),
        }
    }

    /// `Rejected` if a callback URL cannot be told, or nobody can.
    pub(super) fn check_callback(&self, pointer: &str, url: Option<&str>) -> Result<(), JobsError> {
        let Some(url) = url else { return Ok(()) };
        let checked = match &self.0.webhooks {
            Some(sender) => sender.check(url),
            None => Err("cannot be told: webhooks are off on this server"),
        };
        checked.map_err(|what| {
            JobsError::Rejected(Rejection::Invalid(vec![FieldError::new(format!("{pointer}/callback_url"), what)]))
        })
    }

    /// # Errors
    /// [`JobsError::NoBatch`] or [`JobsError::Expired`], else as the store.
    pub async fn batch(&self, id: &str, owner: Option<&str>) -> Result<Batch, JobsError> {
        self.view_batch(&found(self.0.store.batch(id, owner).await?)?)
    }

    /// The batch as it is when its last job ends, when the wait is over or when a shutdown begins, whichever is first.
    ///
    /// # Errors
    /// As [`Jobs::batch`].
    pub async fn wait_for_batch(&self, id: &str, owner: Option<&str>, wait: Duration) -> Result<Batch, JobsError> {
        let row = found(self.0.store.batch(id, owner).await?)?;
        let all = async {
            for job in row.jobs.iter().filter(|job| !job.status.is_final()) {
                // One that was deleted meanwhile is not waited for.
                if let Ok(mut watch) = self.watch(&job.id, owner).await {
                    watch.ended().await;
                }
            }
        };
        tokio::select! {
            () = all => {}
            () = tokio::time::sleep(wait) => {}
            () = self.shutdown() => {}
        }
        self.batch(id, owner).await
    }

    /// Cancels every job of a batch that has not ended.
    ///
    /// # Errors
    /// As [`Jobs::batch`].
    pub async fn cancel_batch(&self, id: &str, owner: Option<&str>) -> Result<Batch, JobsError> {
        let (lookup, cancelled) = self.0.store.cancel_batch(id, owner).await?;
        cancelled.iter().for_each(|id| self.0.running.cancel(id));
        let batch = self.view_batch(&found(lookup)?)?;
        let cancelled_now = batch.jobs.iter().filter(|job| cancelled.contains(&job.id));
        cancelled_now.for_each(|job| super::count_cancelled(job.kind));
        Ok(batch)
    }

    /// Removes a batch with its jobs and their meshes.
    ///
    /// # Errors
    /// As [`Jobs::batch`].
    pub async fn delete_batch(&self, id: &str, owner: Option<&str>) -> Result<(), JobsError> {
        if let Some(jobs) = self.0.store.delete_batch(id, owner).await? {
            jobs.iter().for_each(|id| self.0.running.cancel(id));
            return Ok(());
        }
        found(self.0.store.batch(id, owner).await?).and(Err(JobsError::NoBatch))
    }

    fn view_batch(&self, row: &BatchRow) -> Result<Batch, JobsError> {
        let base = &self.0.config.http.public_base_path;
        let jobs = row.jobs.iter().map(|job| {
            let kind =
                Kind::from_name(&job.kind).ok_or_else(|| JobsError::Internal("an unknown kind of job".into()))?;
            let status = super::wire_status(job.status);
            Ok(BatchJob {
                index: job.index.unsigned_abs(),
                id: job.id.clone(),
                kind,
                status,
                links: crate::wire::job::Links::of(base, &job.id, kind, status),
            })
        });
        let counts = BatchCounts::of(row.jobs.iter().map(|job| super::wire_status(job.status)));
        let finished_at_ms = row.jobs.iter().map(|job| job.finished_at_ms).max().flatten();
        Ok(Batch {
            id: row.id.clone(),
            status: counts.status(),
            created_at: timestamp(row.created_at_ms),
            finished_at: finished_at_ms.filter(|_| counts.status().is_final()).map(timestamp),
            counts,
            jobs: jobs.collect::<Result<_, JobsError>>()?,
            links: BatchLinks::of(base, &row.id),
        })
    }

    /// Every mesh of a batch that has ended, to be put into one file.
    ///
    /// # Errors
    /// As [`Jobs::batch`]; [`JobsError::NoMesh`] unless every job has ended and one has succeeded.
    pub async fn batch_meshes(&self, id: &str, owner: Option<&str>) -> Result<BatchMeshes, JobsError> {
        let row = found(self.0.store.batch(id, owner).await?)?;
        let counts = BatchCounts::of(row.jobs.iter().map(|job| super::wire_status(job.status)));
        if !counts.status().is_final() || counts.succeeded == 0 {
            return Err(JobsError::NoMesh(counts.status()));
        }
        let rows = self.0.store.batch_jobs(id).await?;
        let statistics = |row: &JobRow| {
            let unreadable = |()| JobsError::Internal("the stored job's statistics cannot be read".into());
            super::read(row.statistics.as_deref()).map_err(unreadable)
        };
        let jobs = rows.into_iter().map(|(index, row)| Ok((index, statistics(&row)?, row)));
        let jobs: Vec<(i64, Option<Value>, JobRow)> = jobs.collect::<Result<_, JobsError>>()?;
        let triangles = jobs.iter().filter_map(|(_, statistics, _)| statistics.as_ref()?["triangles"].as_u64()).sum();
        Ok(BatchMeshes { service: self.clone(), id: id.to_owned(), triangles, jobs })
    }
}

fn found(lookup: BatchLookup) -> Result<BatchRow, JobsError> {
    match lookup {
        BatchLookup::Found(row) => Ok(row),
        BatchLookup::Expired => Err(JobsError::Expired),
        BatchLookup::Missing => Err(JobsError::NoBatch),
    }
}

/// The jobs of an ended batch.
#[derive(Debug)]
pub struct BatchMeshes {
    service: Jobs,
    id: String,
    triangles: u64,
    jobs: Vec<(i64, Option<Value>, JobRow)>,
}

/// The name of a job's part in the scene, and of its file in the archive without the ending.
fn part_name(index: i64, kind: &str) -> String {
    format!("{index:04}-{kind}")
}

impl BatchMeshes {
    /// Names what a file made of this holds: equal tags, equal bytes.
    #[must_use]
    pub fn tag(&self, format: &str) -> String {
        let mut hash = Sha256::new();
        hash.update(format!("{} {format} {}\n", env!("CARGO_PKG_VERSION"), self.id));
        for (index, _, row) in &self.jobs {
            hash.update(format!("{index} {} {}\n", row.id, row.status));
            hash.update(row.artefact.as_deref().unwrap_or_default());
        }
        hash.finalize().iter().take(16).map(|byte| format!("{byte:02x}")).collect()
    }

    fn refuse_more_than(&self, most: u64, instead: &str) -> Result<(), JobsError> {
        if self.triangles <= most {
            return Ok(());
        }
        let has = self.triangles;
        Err(JobsError::TooMuch(format!("the meshes have {has} triangles, and one file takes {most}; {instead}")))
    }

    /// All meshes in one scene, each where its coordinates say.
    ///
    /// # Errors
    /// [`JobsError::TooMuch`], [`JobsError::Unwritable`], or as the store.
    pub async fn scene(self) -> Result<File, JobsError> {
        self.refuse_more_than(self.service.0.config.limits.triangles as u64, "take the ZIP")?;
        let mut parts = Vec::new();
        for (index, _, row) in &self.jobs {
            if let Some(artefact) = self.service.0.store.artefact(&row.id, None).await? {
                parts.push((part_name(*index, &row.kind), artefact.bytes));
            }
        }
        let title = format!("batch {}", self.id);
        let write = move || {
            let parts = parts.into_iter().map(|(name, bytes)| Ok((name, Archive::from_bytes(&bytes)?)));
            let parts: Vec<_> = parts.collect::<Result<_, JobsError>>()?;
            gltf::to_glb_scene(&title, &parts).map(File::new).map_err(JobsError::Unwritable)
        };
        self.service.off_runtime(write).await?
    }

    /// A ZIP of all meshes and of what is known of every job (`batch.json`, last), made as it is read: one mesh at a time is in
    /// memory.
    ///
    /// # Errors
    /// [`JobsError::TooMuch`] at once. In the stream, what keeps it from being completed: a job that was removed meanwhile, or
    /// the store.
    pub fn archive(
        self,
        format: MeshFormat,
    ) -> Result<impl Stream<Item = Result<Bytes, JobsError>> + Send + 'static, JobsError> {
        self.refuse_more_than(ARCHIVE_TRIANGLES, "take them one by one")?;
        let writing = Writing {
            service: self.service,
            id: self.id,
            format,
            jobs: self.jobs.into(),
            zip: Some(Zip::default()),
            listed: Vec::new(),
            pending: VecDeque::new(),
        };
        Ok(stream::try_unfold(writing, |mut writing| async move {
            loop {
                if let Some(bytes) = writing.pending.pop_front() {
                    return Ok(Some((bytes, writing)));
                }
                match (writing.jobs.pop_front(), writing.zip.is_some()) {
                    (Some((index, statistics, row)), _) => writing.job(index, statistics, &row).await?,
                    (None, true) => writing.end()?,
                    (None, false) => return Ok(None),
                }
            }
        }))
    }
}

/// A ZIP under way.
struct Writing {
    service: Jobs,
    id: String,
    format: MeshFormat,
    jobs: VecDeque<(i64, Option<Value>, JobRow)>,
    /// Until its end is written.
    zip: Option<Zip>,
    /// For `batch.json`.
    listed: Vec<Value>,
    pending: VecDeque<Bytes>,
}

impl Writing {
    fn entry(&mut self, name: &str, bytes: Bytes) -> Result<(), JobsError> {
        if let Some(zip) = &mut self.zip {
            let header = zip.entry(name, &bytes).map_err(JobsError::Unwritable)?;
            self.pending.extend([header.into(), bytes]);
        }
        Ok(())
    }

    async fn job(&mut self, index: i64, statistics: Option<Value>, row: &JobRow) -> Result<(), JobsError> {
        let job = self.service.view(row)?;
        let (mut file, mut file_error) = (None, None);
        if job.status == Status::Succeeded {
            let format = self.format;
            let encode = move |archive: &Archive| format.encode(archive).map_err(JobsError::Unwritable);
            match self.service.convert(&row.id, None, format.name(), encode).await {
                Ok(converted) => {
                    let name = format!("{}.{}", part_name(index, &row.kind), format.name());
                    self.entry(&name, converted.bytes)?;
                    file = Some(name);
                }
                // One mesh that this format cannot hold does not cost the others.
                Err(JobsError::Unwritable(error)) => file_error = Some(error.to_string()),
                Err(error) => return Err(error),
            }
        }
        self.listed.push(json!({
            "index": index, "id": job.id, "kind": job.kind, "status": job.status, "file": file, "file_error": file_error,
            "statistics": statistics, "warnings": job.warnings, "error": job.error,
        }));
        Ok(())
    }

    fn end(&mut self) -> Result<(), JobsError> {
        let listing = json!({ "id": self.id, "jobs": self.listed });
        let text = serde_json::to_vec_pretty(&listing).map_err(|error| JobsError::Internal(error.to_string()))?;
        self.entry("batch.json", text.into())?;
        if let Some(zip) = self.zip.take() {
            self.pending.push_back(zip.end().map_err(JobsError::Unwritable)?.into());
        }
        Ok(())
    }
}
