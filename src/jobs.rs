//! Jobs: what is submitted, what becomes of it, and the workers that see to it.
//!
//! A job's life: `queued` -> `running` -> `succeeded` | `failed` | `cancelled`. A queued or running job may be cancelled
//! at once, and a running one whose worker died goes back to `queued`. The store makes every transition, in one
//! transaction each; this module decides which. [`service`] lists every operation.

mod attempt;
pub(crate) mod batch;
pub(crate) mod callbacks;
pub(crate) mod converters;
pub(crate) mod events;
pub(crate) mod files;
mod memory;
pub mod progress;
pub(crate) mod service;
pub mod solve;
pub(crate) mod submission;
mod view;
pub(crate) mod worker;

pub(crate) use service::Jobs;

use crate::export::Error as ExportError;
use crate::export::archive::VERSION;
use crate::status::Status;
use crate::store::StoreError;
use crate::wire::{Kind, Rejection};

/// Names the code that computes results and the form in which they are stored: kept results are shared only within one.
#[must_use]
pub fn result_version() -> String {
    format!("{} archive {}", env!("CARGO_PKG_VERSION"), VERSION)
}

/// Which jobs a list shows; all by default.
#[derive(Clone, Debug, Default)]
pub struct Filter {
    pub status: Option<Status>,
    pub kind: Option<Kind>,
    pub idempotency_key: Option<String>,
}

/// Why `jobs` did not do as asked.
#[derive(Debug)]
pub enum JobsError {
    /// The body is not a request that can be worked on.
    Rejected(Rejection),
    /// The queue, or the owner's share of it, is full.
    QueueFull {
        own: bool,
    },
    /// The idempotency key was used with another body.
    KeyConflict,
    NotFound,
    /// There is no such batch, or it is another owner's.
    NoBatch,
    Expired,
    /// The job has not succeeded, or its kind has no such file.
    NoMesh(Status),
    /// The stored mesh was damaged and has been removed.
    Lost,
    /// Only open ruled surfaces have a flat pattern.
    NoPattern,
    /// More than one file can hold, and what to do instead.
    TooMuch(String),
    /// The mesh cannot be written in the format.
    Unwritable(ExportError),
    /// The store cannot take or give anything now.
    Unavailable(String),
    /// A defect.
    Internal(String),
}

impl From<StoreError> for JobsError {
    fn from(error: StoreError) -> Self {
        match error {
            StoreError::QueueFull { own } => Self::QueueFull { own },
            StoreError::NoSpace(text) | StoreError::Unavailable(text) | StoreError::Contended(text) => {
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
