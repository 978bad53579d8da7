//! Jobs in the form that clients see.

use crate::status::{CancelReason, Status};
use plateau_drawing::ParameterError;
use plateau_engine::failure_kinds;
use plateau_engine::kind::Kind;
use plateau_engine::report::{self, Progress, SolveError, Warning};
use plateau_strict_json::rejection::FieldError;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use serde_json::value::RawValue;
use serde_json::{Map, Value};

failure_kinds! {
    /// Failures that have nothing to do with the geometry.
    JobFailure {
        MemoryLimit = "memory-limit": "Solving took more memory than its estimate allows",
        Refused = "refused": "The request exceeds this worker's limits or is unknown to its version",
        SolverCrashed = "solver-crashed": "The solver's process crashed",
        SolverPanicked = "solver-panicked": "The solver failed",
        Unresponsive = "unresponsive": "The solver did not answer",
        WorkerLost = "worker-lost": "The workers of this job died",
    }
}

/// Returns the kinds of failed jobs with their titles, in the order of their names.
#[must_use]
pub fn failures() -> Vec<(String, &'static str)> {
    let own = JobFailure::ALL.iter().map(|&(kind, title)| (kind.to_owned(), title));
    let mut failures: Vec<_> = own.chain(report::failures()).collect();
    failures.sort_unstable();
    failures
}

/// Kind of a stored job. A process of a newer version may have accepted a job of a kind that this version does not
/// know.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum JobKind {
    Known(Kind),
    Newer(String),
}

impl JobKind {
    #[must_use]
    pub fn from_name(name: &str) -> Self {
        Kind::from_name(name).map_or_else(|| Self::Newer(name.to_owned()), Self::Known)
    }

    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Known(kind) => kind.name(),
            Self::Newer(name) => name,
        }
    }
}

impl Serialize for JobKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// Addresses that belong to a job. Each can be followed now: an address without a resource is absent.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Links {
    #[serde(rename = "self")]
    pub this: String,
    /// Address of the request as it was accepted. Absent from jobs that ended under a version that dropped requests.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub request: Option<String>,
    /// Address of the mesh. Present once the job has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh: Option<String>,
    /// Address of the flat pattern. Present once the job has succeeded and has one: only ruled surfaces do.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pattern: Option<String>,
    /// Address of the proof of the area's lower bound. Present once the job has succeeded and has one: only minimal
    /// surfaces do, if their request has `certify`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<String>,
    pub events: String,
    /// Address that cancels the job. Present until the job has ended.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cancel: Option<String>,
    /// Address of the batch that the job belongs to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub batch: Option<String>,
    /// Address of the job that superseded this one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub successor: Option<String>,
}

/// Files that a job has beside its mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExtraFiles {
    pub pattern: bool,
    pub certificate: bool,
}

/// Resources that a job's links lead to, besides those that follow from its status.
#[derive(Clone, Copy, Debug, Default)]
pub struct Related<'a> {
    pub files: ExtraFiles,
    /// Whether the job's request is kept.
    pub request: bool,
    /// Identifier of the job's batch.
    pub batch: Option<&'a str>,
    /// Identifier of the job that superseded this one.
    pub successor: Option<&'a str>,
}

impl Links {
    /// Returns the links of a job on a server below the base path `base`, which is empty or has the form `/plateau`.
    #[must_use]
    pub fn of(base: &str, id: &str, status: Status, related: Related<'_>) -> Self {
        let Related { files, request, batch, successor } = related;
        let this = format!("{base}/v1/jobs/{id}");
        Self {
            request: request.then(|| format!("{this}/request")),
            mesh: (status == Status::Succeeded).then(|| format!("{this}/mesh")),
            pattern: files.pattern.then(|| format!("{this}/pattern")),
            certificate: files.certificate.then(|| format!("{this}/certificate")),
            events: format!("{this}/events"),
            cancel: (!status.is_final()).then(|| format!("{this}/cancel")),
            batch: batch.map(|batch| format!("{base}/v1/batches/{batch}")),
            successor: successor.map(|successor| format!("{base}/v1/jobs/{successor}")),
            this,
        }
    }
}

/// A job: an accepted request and its state.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Job {
    /// ULID, which sorts by time of submission.
    pub id: String,
    #[schemars(with = "Kind")]
    pub kind: JobKind,
    pub status: Status,
    /// Why the job was cancelled. Null unless it was.
    pub cancelled_because: Option<CancelReason>,
    /// Name of the job for people, if the request gave one.
    pub label: Option<String>,
    /// Fields of the client, if the request gave some.
    pub metadata: Option<Map<String, Value>>,
    /// Time of submission (RFC 3339, UTC).
    pub created_at: String,
    pub started_at: Option<String>,
    pub finished_at: Option<String>,
    /// Time at which the job and its mesh are removed.
    pub expires_at: Option<String>,
    pub progress: Progress,
    /// Null until the job has succeeded. The fields depend on the kind.
    #[schemars(schema_with = "plateau_engine::components::statistics")]
    pub statistics: Option<Box<RawValue>>,
    pub warnings: Vec<Warning>,
    /// Null unless the job has failed.
    pub error: Option<SolveError>,
    pub links: Links,
}

/// A job of a list.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct JobSummary {
    /// ULID, which sorts by time of submission.
    pub id: String,
    #[schemars(with = "Kind")]
    pub kind: JobKind,
    pub status: Status,
    /// Why the job was cancelled. Null unless it was.
    pub cancelled_because: Option<CancelReason>,
    /// Name of the job for people, if the request gave one.
    pub label: Option<String>,
    /// Fields of the client, if the request gave some.
    pub metadata: Option<Map<String, Value>>,
    /// Time of submission (RFC 3339, UTC).
    pub created_at: String,
    pub started_at: Option<String>,
    pub finished_at: Option<String>,
    /// Time at which the job and its mesh are removed.
    pub expires_at: Option<String>,
    pub progress: Progress,
    /// Statistics of a job that has succeeded. Absent unless the list was asked for with `statistics=true`. The fields
    /// depend on the kind.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Map<String, Value>")]
    pub statistics: Option<Box<RawValue>>,
    pub warnings: Vec<Warning>,
    /// Null unless the job has failed.
    pub error: Option<SolveError>,
    pub links: Links,
}

impl From<Job> for JobSummary {
    fn from(job: Job) -> Self {
        Self {
            id: job.id,
            kind: job.kind,
            status: job.status,
            cancelled_because: job.cancelled_because,
            label: job.label,
            metadata: job.metadata,
            created_at: job.created_at,
            started_at: job.started_at,
            finished_at: job.finished_at,
            expires_at: job.expires_at,
            progress: job.progress,
            statistics: None,
            warnings: job.warnings,
            error: job.error,
            links: job.links,
        }
    }
}

/// One page of jobs, newest first.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct JobList {
    pub jobs: Vec<JobSummary>,
    /// Value of `?cursor=` for the next page; null on the last page.
    pub next_cursor: Option<String>,
}

/// An offending value of a request. Values are never echoed.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct WrongValue {
    /// JSON Pointer (RFC 6901) to the offending value, if it is in the body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pointer: Option<String>,
    /// Name of the offending parameter, if it is in the query.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parameter: Option<String>,
    /// Description of the error.
    pub detail: String,
}

impl From<FieldError> for WrongValue {
    fn from(FieldError { pointer, detail }: FieldError) -> Self {
        Self { pointer: Some(pointer), parameter: None, detail }
    }
}

impl From<ParameterError> for WrongValue {
    fn from(ParameterError { parameter, detail }: ParameterError) -> Self {
        Self { pointer: None, parameter: Some(parameter), detail }
    }
}

/// A problem document, RFC 9457.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Problem {
    /// Stable URI reference that identifies the kind of problem.
    #[serde(rename = "type")]
    pub kind: String,
    pub title: String,
    /// HTTP status of the response.
    #[schemars(range(min = 400, max = 599))]
    pub status: u16,
    pub detail: String,
    /// Path of the request.
    pub instance: String,
    /// Offending values of the body or of the query, at most 50.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<WrongValue>,
    /// True if there were more errors than are listed.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub errors_omitted: bool,
}
