//! `GET /problems`: the kinds of problem documents and of failed jobs.

use schemars::JsonSchema;
use serde::Serialize;

#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ProblemList {
    /// The kinds, those of problem documents first.
    pub problems: Vec<ProblemKind>,
}

/// A kind of problem.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ProblemKind {
    /// Stable URI reference, which problem documents and the errors of failed jobs have as their `type`. A GET of it
    /// answers with a text for people.
    #[serde(rename = "type")]
    pub kind: String,
    /// Title, for people.
    pub title: String,
    /// HTTP status of the response. Null for the error of a failed job.
    #[schemars(range(min = 400, max = 599))]
    pub status: Option<u16>,
}
