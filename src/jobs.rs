//! Jobs: submission, results, and the workers that solve them.
//!
//! A job goes through `queued` -> `running` -> `succeeded` | `failed` | `cancelled`. A queued or running job may be
//! cancelled at once, and a running job whose worker died goes back to `queued`. This module decides on each
//! transition; the store makes it in one transaction. [`submission`], [`reading`], [`service`] and [`events`] have the
//! operations.

mod attempt;
pub(crate) mod batch;
pub(crate) mod callbacks;
pub(crate) mod child;
mod children;
pub(crate) mod converters;
pub(crate) mod counters;
pub(crate) mod events;
mod fair_permits;
pub(crate) mod files;
mod handle;
mod memory;
pub mod progress;
mod reading;
pub(crate) mod service;
mod shares;
mod solving;
mod sources;
pub(crate) mod submission;
mod view;
pub(crate) mod worker;

pub(crate) use handle::Jobs;

use crate::status::Status;
use crate::store::StoreError;
use plateau_archive::archive::VERSION;
use plateau_archive::formats::Error as ExportError;
use plateau_drawing::Refused;
use plateau_engine::SOLVER_REVISION;
use plateau_engine::kind::Kind;
use plateau_strict_json::rejection::{FieldError, Rejection};

/// Version of the code that computes results and of the format that stores them. A kept result is reused only by the
/// same version.
#[must_use]
pub fn result_version() -> String {
    format!("{} solvers {SOLVER_REVISION} archive {VERSION}", env!("CARGO_PKG_VERSION"))
}

/// Selection of the jobs in a list. The default selects all jobs.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// States of the jobs. An empty list selects jobs in every state.
    pub statuses: Vec<Status>,
    pub kind: Option<Kind>,
    pub idempotency_key: Option<String>,
    pub label: Option<String>,
    /// Identifier of a batch.
    pub batch: Option<String>,
    /// Time after which the jobs were submitted, in milliseconds since 1970.
    pub created_after_ms: Option<i64>,
}

/// Error of an operation on jobs.
#[derive(Debug)]
pub enum JobsError {
    /// The body is not a valid request.
    Rejected(Rejection),
    /// The request begins with the result of another job, and that result cannot be read because of `cause`. The errors
    /// point to the job's identifier in the request.
    NoSource {
        cause: Box<Self>,
        errors: Vec<FieldError>,
    },
    /// The queue, or the owner's share of it, is full.
    QueueFull {
        own: bool,
    },
    /// The idempotency key was used with another body.
    KeyConflict,
    NotFound,
    /// The batch does not exist, or it belongs to another owner.
    NoBatch,
    Expired,
    /// The job has not succeeded, or its kind has no such file.
    NoMesh(Status),
    /// The stored mesh was damaged and has been removed.
    Lost,
    /// A drawing or a schedule cannot be made of this result with these parameters.
    NoDrawing(Refused),
    /// The request did not ask for a lower bound of the area, or none could be computed.
    NoCertificate,
    /// The job ended under a version that did not keep requests.
    NoRequest,
    /// The request of the job or batch named no callback URL.
    NoCallback,
    /// The answer is larger than one file can hold. The text says what to do instead.
    TooMuch(String),
    /// The mesh cannot be written in the format.
    Unwritable(ExportError),
    /// The store is unreachable or full.
    Unavailable(String),
    /// A defect of this server.
    Internal(String),
}

impl JobsError {
    /// Prefixes each pointer, for a request that lies at `pointer` of a larger message.
    #[must_use]
    pub fn within(self, pointer: &str) -> Self {
        match self {
            Self::Rejected(rejection) => Self::Rejected(rejection.within(pointer)),
            Self::NoSource { cause, mut errors } => {
                errors.iter_mut().for_each(|error| error.pointer.insert_str(0, pointer));
                Self::NoSource { cause, errors }
            }
            other => other,
        }
    }
}

impl From<StoreError> for JobsError {
    fn from(error: StoreError) -> Self {
        match error {
            StoreError::QueueFull { own } => Self::QueueFull { own },
            StoreError::NoSpace(text)
            | StoreError::Unavailable(text)
            | StoreError::Refused(text)
            | StoreError::Contended(text) => {
                tracing::warn!(error = %text, "the store is unavailable");
                Self::Unavailable("the store cannot be reached or is full; try again".into())
            }
            other => {
                tracing::error!(error = %other, "the store failed");
                Self::Internal("the store failed".into())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_of_another_revision_are_not_reused() {
        assert!(result_version().contains(&format!(" solvers {SOLVER_REVISION} ")), "{}", result_version());
    }
}
