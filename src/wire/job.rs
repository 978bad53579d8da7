//! A job as a client sees it.

use super::{FieldError, Kind};
use schemars::JsonSchema;
use schemars::generate::SchemaGenerator;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

/// Where a job stands. `succeeded`, `failed` and `cancelled` are final.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    Queued,
    Running,
    Succeeded,
    Failed,
    Cancelled,
}

impl Status {
    pub const ALL: [Self; 5] = [Self::Queued, Self::Running, Self::Succeeded, Self::Failed, Self::Cancelled];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Succeeded => "succeeded",
            Self::Failed => "failed",
            Self::Cancelled => "cancelled",
        }
    }

    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|status| status.name() == name)
    }

    #[must_use]
    pub fn is_final(self) -> bool {
        matches!(self, Self::Succeeded | Self::Failed | Self::Cancelled)
    }
}

/// How far a job has come.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Progress {
    /// 0 to 1, never falling within one attempt.
    #[schemars(range(min = 0, max = 1))]
    pub fraction: f64,
    /// What the solver is doing.
    pub phase: String,
    pub iteration: u64,
    pub objective_value: Option<f64>,
    pub residual: Option<f64>,
}

/// Something about the input or the result that the client should know although the job went through.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct JobWarning {
    /// Stable, snake case.
    pub code: String,
    pub detail: String,
}

/// Why a job failed: what was wrong with the geometry, and what to try.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct JobError {
    /// A URI reference that names the kind of failure; stable.
    #[serde(rename = "type")]
    pub kind: String,
    pub title: String,
    pub detail: String,
    pub errors: Vec<FieldError>,
}

/// Where to go from a job.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Links {
    #[serde(rename = "self")]
    pub this: String,
    pub mesh: String,
    /// Ruled surfaces only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pattern: Option<String>,
    pub events: String,
    pub cancel: String,
}

impl Links {
    /// `base` is what a proxy puts before the paths of this server; empty without one.
    #[must_use]
    pub fn of(base: &str, id: &str, kind: Kind) -> Self {
        let this = format!("{base}/v1/jobs/{id}");
        Self {
            mesh: format!("{this}/mesh"),
            pattern: (kind == Kind::RuledSurface).then(|| format!("{this}/pattern")),
            events: format!("{this}/events"),
            cancel: format!("{this}/cancel"),
            this,
        }
    }
}

/// A job: a request that was taken, and what became of it.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Job {
    /// A ULID: sorts by time of submission.
    pub id: String,
    pub kind: Kind,
    pub status: Status,
    /// RFC 3339, UTC.
    pub created_at: String,
    pub started_at: Option<String>,
    pub finished_at: Option<String>,
    /// When job and mesh are removed.
    pub expires_at: Option<String>,
    pub progress: Progress,
    /// Null until the job has succeeded; its fields depend on the kind.
    #[schemars(schema_with = "statistics_schema")]
    pub statistics: Option<Box<RawValue>>,
    pub warnings: Vec<JobWarning>,
    /// Null unless the job has failed.
    pub error: Option<JobError>,
    pub links: Links,
}

fn statistics_schema(generator: &mut SchemaGenerator) -> schemars::Schema {
    let ruled = generator.subschema_for::<super::ruled_surface::RuledStatistics>();
    let minimal = generator.subschema_for::<super::minimal_surface::MinimalStatistics>();
    let uniform = generator.subschema_for::<super::uniform_mesh::UniformStatistics>();
    schemars::json_schema!({ "anyOf": [ruled, minimal, uniform, { "type": "null" }] })
}

/// One page of jobs, newest first.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct JobList {
    pub jobs: Vec<Job>,
    /// Hand it back as `?cursor=` for the next page; null on the last one.
    pub next_cursor: Option<String>,
}

/// A problem document, RFC 9457.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Problem {
    /// A URI reference that names the kind of problem; stable.
    #[serde(rename = "type")]
    pub kind: String,
    pub title: String,
    /// The HTTP status, repeated.
    #[schemars(range(min = 400, max = 599))]
    pub status: u16,
    pub detail: String,
    /// The path that was asked for.
    pub instance: String,
    /// Offending values of the body, at most 50.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<FieldError>,
    /// True if there were more errors than are listed.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub errors_omitted: bool,
}

pub(super) fn schemas(generator: &mut SchemaGenerator) {
    generator.subschema_for::<Job>();
    generator.subschema_for::<JobList>();
    generator.subschema_for::<super::batch::Batch>();
    generator.subschema_for::<Problem>();
    generator.subschema_for::<super::objectives::ObjectiveList>();
    generator.subschema_for::<super::objectives::Limits>();
    generator.subschema_for::<super::objectives::ExampleList>();
    generator.subschema_for::<super::objectives::Example>();
}
