//! The file with all meshes of a batch.

use super::converters::Length;
use super::files::File;
use super::view::{self, Figures};
use super::{Jobs, JobsError, result_version};
use crate::status::Status;
use crate::store::{BatchRow, JobRow};
use bytes::Bytes;
use futures_util::stream::{self, BoxStream, Stream, StreamExt, TryStreamExt};
use plateau_archive::Archive;
use plateau_archive::formats::{MeshFormat, gltf};
use plateau_archive::zip::Zip;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::collections::VecDeque;

/// Largest number of triangles that one ZIP may hold. No format takes more than 200 bytes per triangle, so the ZIP has
/// at most 4 GB, which is the most that a ZIP can address.
const ARCHIVE_TRIANGLES: u64 = 20_000_000;

pub(super) async fn meshes(jobs: &Jobs, batch: &BatchRow) -> Result<BatchMeshes, JobsError> {
    let counts = view::counts(batch);
    if !counts.status().is_final() || counts.succeeded == 0 {
        return Err(JobsError::NoMesh(counts.status()));
    }
    let rows = jobs.store().batch_jobs(&batch.id).await?;
    let triangles = |row: &JobRow| {
        let unreadable = |()| JobsError::Internal("the stored job's summary cannot be read".into());
        let figures: Option<Figures> = view::read(row.summary.as_deref()).map_err(unreadable)?;
        Ok::<_, JobsError>(figures.and_then(|figures| figures.triangles).unwrap_or(0))
    };
    let triangles = rows.iter().map(|(_, row)| triangles(row)).sum::<Result<u64, _>>()?;
    Ok(BatchMeshes { service: jobs.clone(), id: batch.id.clone(), triangles, jobs: rows })
}

/// Jobs of a batch that has ended.
#[derive(Debug)]
pub struct BatchMeshes {
    service: Jobs,
    id: String,
    triangles: u64,
    jobs: Vec<(i64, JobRow)>,
}

/// Name of a job's node in the scene, and of its file in the ZIP without the extension.
fn part_name(index: i64, kind: &str) -> String {
    format!("{index:04}-{kind}")
}

/// Returns a name for the file of a batch. The version of the results is a part of it, because another version of the
/// service may write another file for the same jobs.
fn tag(format: &str, batch: &str, jobs: &[(i64, JobRow)]) -> String {
    let mut hash = Sha256::new();
    hash.update(format!("{} {format} {batch}\n", result_version()));
    for (index, row) in jobs {
        hash.update(format!("{index} {} {}\n", row.id, row.status.name()));
        hash.update(row.artefact.as_deref().unwrap_or_default());
    }
    hash.finalize().iter().take(16).map(|byte| format!("{byte:02x}")).collect()
}

impl BatchMeshes {
    /// Returns a name for the content of the file: equal tags mean equal bytes.
    #[must_use]
    pub fn tag(&self, format: &str) -> String {
        tag(format, &self.id, &self.jobs)
    }

    fn refuse_more_than(&self, maximum: u64, instead: &str) -> Result<(), JobsError> {
        if self.triangles <= maximum {
            return Ok(());
        }
        let has = self.triangles;
        Err(JobsError::TooMuch(format!("the meshes have {has} triangles, and one file takes {maximum}; {instead}")))
    }

    /// Returns one GLB scene with all meshes at their own coordinates.
    ///
    /// # Errors
    /// Returns [`JobsError::TooMuch`], [`JobsError::Unwritable`] or an error of the store.
    pub async fn scene(self) -> Result<File, JobsError> {
        self.refuse_more_than(self.service.config().limits.triangles as u64, "take the ZIP")?;
        // The thread is reserved before the meshes are read, so that a scene that waits for a thread holds no meshes in
        // memory.
        let owner = self.jobs.first().and_then(|(_, row)| row.owner.as_deref());
        let thread = self.service.converters().reserve(owner, Length::Long).await?;
        let mut parts = Vec::new();
        for (index, row) in &self.jobs {
            if row.status == Status::Succeeded {
                let artefact = self.service.store().artefact(&row.id, None).await?.ok_or(JobsError::Lost)?;
                parts.push((part_name(*index, &row.kind), artefact));
            }
        }
        let title = format!("batch {}", self.id);
        let service = self.service.clone();
        let write = move || {
            let mut read = Vec::with_capacity(parts.len());
            for (name, artefact) in parts {
                match Archive::from_bytes(&artefact.bytes) {
                    Ok(archive) => read.push((name, archive)),
                    Err(defect) => return Err((defect, artefact)),
                }
            }
            let scene = gltf::to_glb_scene(&title, &read).map_err(JobsError::Unwritable);
            Ok(scene.and_then(|scene| service.files().file(scene)))
        };
        match thread.run(write).await? {
            Ok(scene) => scene,
            Err((defect, artefact)) => Err(self.service.unreadable(&defect, &artefact).await),
        }
    }

    /// Returns a ZIP with all meshes and, as the last entry, `batch.json`, which describes every job. The ZIP is
    /// written while it is read, so that only one mesh at a time is in memory.
    ///
    /// # Errors
    /// Returns [`JobsError::TooMuch`] at once. Errors in the stream end it early: a job was removed meanwhile, or the
    /// store failed.
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
            file: None,
        };
        Ok(stream::try_unfold(writing, |mut writing| async move {
            loop {
                if let Some(bytes) = writing.pending.pop_front() {
                    return Ok(Some((bytes, writing)));
                }
                if let Some(file) = &mut writing.file {
                    match file.try_next().await.map_err(|error| JobsError::Unavailable(error.to_string()))? {
                        Some(bytes) => return Ok(Some((bytes, writing))),
                        None => writing.file = None,
                    }
                }
                match (writing.jobs.pop_front(), writing.zip.is_some()) {
                    (Some((index, row)), _) => writing.job(index, &row).await?,
                    (None, true) => writing.end()?,
                    (None, false) => return Ok(None),
                }
            }
        }))
    }
}

/// A ZIP that is being written.
struct Writing {
    service: Jobs,
    id: String,
    format: MeshFormat,
    jobs: VecDeque<(i64, JobRow)>,
    /// `None` after the end of the ZIP has been written.
    zip: Option<Zip>,
    /// Entries of `batch.json`.
    listed: Vec<Value>,
    pending: VecDeque<Bytes>,
    /// Rest of the current entry, which follows the pending bytes.
    file: Option<BoxStream<'static, std::io::Result<Bytes>>>,
}

impl Writing {
    async fn job(&mut self, index: i64, row: &JobRow) -> Result<(), JobsError> {
        let job = self.service.view(row)?;
        let (mut file, mut file_error) = (None, None);
        if job.status == Status::Succeeded {
            let format = self.format;
            let encode = move |archive: &Archive| format.encode(archive).map_err(JobsError::Unwritable);
            match self.service.convert(&row.id, row.owner.as_deref(), format.name(), encode).await {
                Ok(converted) => {
                    let name = format!("{}.{}", part_name(index, &row.kind), format.name());
                    if let Some(zip) = &mut self.zip {
                        let header = zip.entry_of(&name, converted.length, converted.checksum);
                        self.pending.push_back(header.map_err(JobsError::Unwritable)?.into());
                    }
                    let whole = 0..converted.length;
                    self.file = Some(converted.stream(whole).boxed());
                    file = Some(name);
                }
                // A mesh that the format cannot hold is reported in `batch.json`, and the other meshes are still
                // written.
                Err(JobsError::Unwritable(error)) => file_error = Some(error.to_string()),
                Err(error) => return Err(error),
            }
        }
        self.listed.push(json!({
            "index": index, "id": job.id, "kind": job.kind, "status": job.status, "file": file,
            "file_error": file_error,
            "statistics": job.statistics, "warnings": job.warnings, "error": job.error,
        }));
        Ok(())
    }

    fn end(&mut self) -> Result<(), JobsError> {
        let listing = json!({ "id": self.id, "jobs": self.listed });
        let text = serde_json::to_vec_pretty(&listing).map_err(|error| JobsError::Internal(error.to_string()))?;
        if let Some(mut zip) = self.zip.take() {
            let header = zip.entry("batch.json", &text).map_err(JobsError::Unwritable)?;
            self.pending.extend([header.into(), text.into()]);
            self.pending.push_back(zip.end().map_err(JobsError::Unwritable)?.into());
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::store::{Addition, NewJob, Store, StoreOptions};
    use futures_util::FutureExt;
    use std::sync::Arc;
    use std::time::Duration;

    #[tokio::test]
    async fn a_scene_waits_for_a_converter_before_it_loads_its_meshes() {
        let folder = tempfile::tempdir().unwrap();
        let url = format!("sqlite://{}/plateau.db", folder.path().display());
        let store = Store::open(&url, StoreOptions::default()).await.unwrap();
        let job = NewJob {
            id: "0".repeat(26),
            kind: "ruled_surface".into(),
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
        let Addition::Created(row, _) = store.add_job(job).await.unwrap() else { panic!("a new job") };
        let row = JobRow { status: Status::Succeeded, ..*row };
        let jobs = Jobs::new(store.clone(), Arc::new(Config::default()), None).unwrap();
        let mut reserved = Vec::new();
        while let Some(reservation) = jobs.converters().reserve(None, Length::Long).now_or_never() {
            reserved.push(reservation.unwrap());
        }
        // Loading a mesh fails from now on.
        store.close().await;
        let meshes = BatchMeshes { service: jobs.clone(), id: "1".repeat(26), triangles: 1, jobs: vec![(0, row)] };
        let mut scene = std::pin::pin!(meshes.scene());
        let waited = tokio::time::timeout(Duration::from_millis(200), &mut scene).await;
        assert!(waited.is_err(), "no converter is free");
        drop(reserved);
        assert!(matches!(scene.await, Err(JobsError::Unavailable(_))));
    }

    #[test]
    fn the_tag_of_a_batch_changes_with_the_version_of_the_results() {
        let digest = Sha256::digest(format!("{} glb b\n", result_version()));
        let expected: String = digest.iter().take(16).map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(tag("glb", "b", &[]), expected);
        assert!(result_version().contains(&format!("solvers {}", plateau_engine::SOLVER_REVISION)));
    }
}
