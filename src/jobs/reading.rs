//! Jobs, batches and files as clients read them.

use super::converters::Length;
use super::files::File;
use super::{Jobs, JobsError};
use crate::status::Status;
use crate::store::{Artefact, BatchLookup, BatchRow, JobRow, JobWatch, Lookup};
use crate::telemetry::metric;
use crate::wire::batch::Batch;
use crate::wire::job::Job;
use plateau_archive::{Archive, Defect};

impl Jobs {
    /// Returns a job.
    ///
    /// # Errors
    /// Returns [`JobsError::NotFound`], [`JobsError::Expired`] or an error of the store.
    pub async fn get(&self, id: &str, owner: Option<&str>) -> Result<Job, JobsError> {
        self.view(&*found(self.0.store.get(id, owner).await?)?)
    }

    /// Returns a watch that follows the changes of a job.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`].
    pub(super) async fn watch(&self, id: &str, owner: Option<&str>) -> Result<JobWatch, JobsError> {
        self.0.store.watch(id, owner).await?.map_err(|lookup| match lookup {
            Lookup::Expired => JobsError::Expired,
            Lookup::Found(_) | Lookup::Missing => JobsError::NotFound,
        })
    }

    /// Returns a batch.
    ///
    /// # Errors
    /// Returns [`JobsError::NoBatch`], [`JobsError::Expired`] or an error of the store.
    pub async fn batch(&self, id: &str, owner: Option<&str>) -> Result<Batch, JobsError> {
        Ok(self.view_batch(&found_batch(self.0.store.batch(id, owner).await?)?))
    }

    /// Returns the request of a job as JSON, as the request's type wrote it when the request was accepted. It names its
    /// kind, so that `plateau solve` and batches take it.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`], and [`JobsError::NoRequest`] if the job ended under a version that dropped
    /// requests.
    pub async fn request(&self, id: &str, owner: Option<&str>) -> Result<File, JobsError> {
        let Some((kind, text)) = self.0.store.request(id, owner).await? else {
            return found(self.0.store.get(id, owner).await?).and(Err(JobsError::NoRequest));
        };
        let service = self.clone();
        self.off_runtime(move || service.files().file(with_kind(&kind, text))).await?
    }

    /// Returns a file made from a succeeded job's mesh. The conversion runs outside the async threads, and the number
    /// of conversions at once is limited. Files are cached, so that range requests, revalidations and many readers
    /// cost one conversion. `format` identifies the conversion in the cache.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`] and of `convert`, [`JobsError::NoMesh`] unless the job has succeeded, and
    /// [`JobsError::Lost`] if its mesh was damaged.
    pub async fn convert(
        &self,
        id: &str,
        owner: Option<&str>,
        format: impl Into<String> + Send,
        convert: impl FnOnce(&Archive) -> Result<Vec<u8>, JobsError> + Send + 'static,
    ) -> Result<File, JobsError> {
        let row = found(self.0.store.get(id, owner).await?)?;
        if row.status != Status::Succeeded {
            return Err(JobsError::NoMesh(row.status));
        }
        let key = (row.artefact.unwrap_or_default(), format.into());
        if let Some(file) = self.0.files.get(&key) {
            return Ok(file);
        }
        let thread = self.converters().reserve(owner, length(row.statistics.as_deref())).await?;
        // Another conversion may have made the file while this one waited.
        if let Some(file) = self.0.files.get(&key) {
            return Ok(file);
        }
        let artefact = self.0.store.artefact(id, owner).await?.ok_or(JobsError::Lost)?;
        let service = self.clone();
        let run = move || match Archive::from_bytes(&artefact.bytes) {
            Ok(archive) => Ok(convert(&archive).and_then(|bytes| service.files().file(bytes))),
            Err(defect) => Err((defect, artefact)),
        };
        let file = match thread.run(run).await? {
            Ok(converted) => converted?,
            Err((defect, artefact)) => return Err(self.unreadable(&defect, &artefact).await),
        };
        metrics::counter!(metric::CONVERSIONS).increment(1);
        self.0.files.put(key, file.clone());
        Ok(file)
    }

    /// Returns the error for a stored mesh that cannot be read. If the mesh is damaged, it is removed, so that the next
    /// equal request is solved again instead of reusing it.
    pub(super) async fn unreadable(&self, defect: &Defect, artefact: &Artefact) -> JobsError {
        tracing::error!(error = %defect, "a stored mesh cannot be read");
        if matches!(defect, Defect::Version(_)) {
            return JobsError::Unavailable("the mesh was stored by another version of this server".into());
        }
        if !matches!(defect, Defect::Magic | Defect::Checksum) {
            return JobsError::Internal("a stored mesh cannot be read".into());
        }
        match self.0.store.discard(artefact).await {
            Ok(()) => JobsError::Lost,
            Err(error) => error.into(),
        }
    }
}

/// Returns the text of a request with its kind as the first member. The types write the kind first if it was given.
fn with_kind(kind: &str, mut text: Vec<u8>) -> Vec<u8> {
    const NAME: &[u8] = b"{\"kind\":";
    if !text.starts_with(NAME) {
        let comma = if text.get(1) == Some(&b'}') { "" } else { "," };
        let first = format!("{}{}{comma}", String::from_utf8_lossy(NAME), serde_json::Value::from(kind));
        text.splice(..1, first.into_bytes());
    }
    text
}

/// Returns how long converting a mesh with these statistics takes.
fn length(statistics: Option<&str>) -> Length {
    /// Largest number of triangles of a mesh that is converted in some tenths of a second.
    const SHORT_TRIANGLES: u64 = 20_000;
    #[derive(serde::Deserialize)]
    struct Size {
        triangles: Option<u64>,
    }
    let size = statistics.and_then(|text| serde_json::from_str::<Size>(text).ok());
    match size.and_then(|size| size.triangles) {
        Some(triangles) if triangles > SHORT_TRIANGLES => Length::Long,
        _ => Length::Short,
    }
}

pub(super) fn found(lookup: Lookup) -> Result<Box<JobRow>, JobsError> {
    match lookup {
        Lookup::Found(row) => Ok(row),
        Lookup::Expired => Err(JobsError::Expired),
        Lookup::Missing => Err(JobsError::NotFound),
    }
}

pub(super) fn found_batch(lookup: BatchLookup) -> Result<BatchRow, JobsError> {
    match lookup {
        BatchLookup::Found(row) => Ok(row),
        BatchLookup::Expired => Err(JobsError::Expired),
        BatchLookup::Missing => Err(JobsError::NoBatch),
    }
}
