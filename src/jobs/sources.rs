//! Sources: the results of finished jobs from which requests begin.
//!
//! The checks of a request need its source, so the source is read while the request is read. The stored request keeps
//! the name of its source (`requests.source`), and a result stays stored as long as a request names it. The job can
//! therefore be solved after the source's job has expired or was deleted.

use super::progress::SolverLink;
use super::{Jobs, JobsError};
use crate::status::Status;
use crate::store::{Artefact, Claimed, Lookup};
use plateau_archive::Archive;
use plateau_engine::kind::Kind;
use plateau_engine::solved::Signal;
use plateau_engine::source::Source;
use plateau_strict_json::rejection::Rejection;
use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;
use tokio::runtime::Handle;

/// Pause before a worker reads a source again from a store that cannot be reached.
const PAUSE: Duration = Duration::from_millis(200);

/// Looks up the results of an owner's finished jobs, for a thread that reads requests. The thread must not be one of
/// the async runtime, because it waits for the store.
pub(super) struct Sources {
    jobs: Jobs,
    owner: Option<String>,
    runtime: Handle,
    /// Source that was found last, with the identifier of its job. The requests of a batch often begin with the same
    /// source.
    last: RefCell<Option<(String, Source)>>,
    /// Reason for which the last source was not found.
    missing: RefCell<Option<JobsError>>,
}

impl Sources {
    /// Must be called on the async runtime.
    pub(super) fn new(jobs: &Jobs, owner: Option<String>) -> Self {
        Self {
            jobs: jobs.clone(),
            owner,
            runtime: Handle::current(),
            last: RefCell::default(),
            missing: RefCell::default(),
        }
    }

    /// Returns the result of a job of the owner.
    ///
    /// # Errors
    /// Returns, as a phrase, the reason why there is no result.
    pub(super) fn find(&self, id: &str) -> Result<Source, String> {
        if let Some((last, source)) = &*self.last.borrow()
            && last == id
        {
            return Ok(source.clone());
        }
        match self.runtime.block_on(self.read(id)) {
            Ok(source) => {
                *self.last.borrow_mut() = Some((id.to_owned(), source.clone()));
                Ok(source)
            }
            Err(error) => {
                let reason = reason(&error);
                *self.missing.borrow_mut() = Some(error);
                Err(reason)
            }
        }
    }

    async fn read(&self, id: &str) -> Result<Source, JobsError> {
        let store = self.jobs.store();
        let owner = self.owner.as_deref();
        let row = match store.get(id, owner).await? {
            Lookup::Found(row) => row,
            Lookup::Expired => return Err(JobsError::Expired),
            Lookup::Missing => return Err(JobsError::NotFound),
        };
        if row.status != Status::Succeeded {
            return Err(JobsError::NoMesh(row.status));
        }
        let (archive, artefact) = parsed(&self.jobs, store.artefact(id, owner).await?).await?;
        Ok(Source::new(archive, artefact.hash))
    }

    /// Returns the error for a request that was refused. If its source was not found, the error names that cause.
    pub(super) fn refused(&self, rejection: Rejection) -> JobsError {
        match (rejection, self.missing.take()) {
            (Rejection::Invalid(errors), Some(cause)) => JobsError::NoSource { cause: Box::new(cause), errors },
            (rejection, _) => JobsError::Rejected(rejection),
        }
    }

    /// Returns the error for a batch with a request that was refused. Several requests may be wrong for different
    /// reasons, so only a defect of this server counts as the cause.
    pub(super) fn refused_batch(&self, rejection: Rejection) -> JobsError {
        match &*self.missing.borrow() {
            Some(JobsError::Unavailable(_) | JobsError::Internal(_)) => {}
            _ => return JobsError::Rejected(rejection),
        }
        self.refused(rejection)
    }
}

/// Returns the stored result with this name, from which the request of a claimed job begins, in the form that `of`
/// gives it. While the store cannot be reached, it is asked again until the solver is told to end. Must be called on a
/// blocking thread of the runtime.
///
/// # Errors
/// Returns, as a phrase, the reason why the result cannot be read.
pub(super) fn claimed<T>(
    jobs: &Jobs,
    name: Option<&[u8]>,
    link: &SolverLink,
    of: impl FnOnce(Archive, Artefact) -> T,
) -> Result<T, String> {
    let name = name.ok_or("names a job, and its result was not kept")?;
    loop {
        let read = async { parsed(jobs, jobs.store().artefact_named(name).await?).await };
        match Handle::current().block_on(read) {
            Err(JobsError::Unavailable(_)) if link.signal() == Signal::Continue => std::thread::sleep(PAUSE),
            Err(error) => return Err(reason(&error)),
            Ok((archive, artefact)) => return Ok(of(archive, artefact)),
        }
    }
}

/// Same as [`claimed`], for a child process, which needs the bytes. Does not block.
pub(super) async fn bytes(jobs: &Jobs, job: &Claimed, link: &Arc<SolverLink>) -> Result<(Vec<u8>, Vec<u8>), String> {
    if !Kind::from_name(&job.kind).is_some_and(Kind::has_source) {
        return Err("the kind has no source".into());
    }
    let (jobs, name, link) = (jobs.clone(), job.source.clone(), link.clone());
    let read = move || claimed(&jobs, name.as_deref(), &link, |_, artefact| (artefact.hash, artefact.bytes));
    tokio::task::spawn_blocking(read).await.map_err(|error| error.to_string())?
}

async fn parsed(jobs: &Jobs, artefact: Option<Artefact>) -> Result<(Archive, Artefact), JobsError> {
    let artefact = artefact.ok_or(JobsError::Lost)?;
    match Archive::from_bytes(&artefact.bytes) {
        Ok(archive) => Ok((archive, artefact)),
        Err(defect) => Err(jobs.unreadable(&defect, &artefact).await),
    }
}

/// Returns the reason why a job has no result, as the detail of an error of the field that names the job.
fn reason(error: &JobsError) -> String {
    match error {
        JobsError::NotFound => "is not the identifier of a job".into(),
        JobsError::Expired => "is the identifier of a job that was removed with its mesh".into(),
        JobsError::NoMesh(status) => {
            format!("is the identifier of a job that is {}, and must be of one that has succeeded", status.name())
        }
        JobsError::Lost => "is the identifier of a job whose mesh was damaged and has been removed".into(),
        _ => "cannot be looked up now".into(),
    }
}
