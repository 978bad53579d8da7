//! Reports of a solver besides its result: progress, warnings and the reason for a failure.

use crate::rejection::FieldError;
use plateau_mesh::codes::{Reason, WarningCode};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Progress of a job.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Progress {
    /// Fraction of the work that is done, from 0 to 1. It never falls within one attempt.
    #[schemars(range(min = 0, max = 1))]
    pub fraction: f64,
    /// Name of the solver's current phase.
    pub phase: String,
    pub iteration: u64,
    pub objective_value: Option<f64>,
    pub residual: Option<f64>,
}

/// A warning about the input or the result of a job that succeeded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "JobWarning")]
pub struct Warning {
    #[schemars(schema_with = "code")]
    pub code: String,
    pub detail: String,
    /// Figures of the detail by name, such as the `distance` of the warning `projected`. Indices count from 0, and
    /// lengths are in the request's unit.
    pub values: BTreeMap<String, f64>,
}

impl Warning {
    /// Code of the warning that STL files are not in the request's coordinates.
    pub const FAR_FROM_ZERO: &str = WarningCode::FarFromZero.name();
}

/// Returns the schema of a warning's code. Its description lists the codes with their meanings. A later version may
/// have more codes.
fn code(_: &mut SchemaGenerator) -> Schema {
    let codes: String = WarningCode::ALL.iter().map(|code| format!("\n- `{code}`: {}.", code.meaning())).collect();
    json_schema!({ "type": "string", "description": format!("Stable name in snake case:\n{codes}") })
}

/// Reason for a failure: what was wrong with the geometry, and what to try.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "JobError")]
pub struct SolveError {
    /// Stable URI reference that identifies the kind of failure.
    #[serde(rename = "type")]
    pub kind: String,
    pub title: String,
    pub detail: String,
    pub errors: Vec<FieldError>,
}

/// Kinds of failures that do not come from a [`Reason`] of a solver: the last part of an error's `type`, and its title.
const FAILURES: &[(&str, &str)] = &[
    (SolveError::AUDIT_FAILED, "The figures of the result are not those of its mesh"),
    ("deadline", "The deadline passed"),
    ("invalid-geometry", "The geometry is invalid"),
];

/// Returns every kind of failure: the last part of an error's `type`, and its title.
pub fn failures() -> impl Iterator<Item = (String, &'static str)> {
    let of_solvers = Reason::ALL.iter().map(|reason| (reason.name().replace('_', "-"), reason.meaning()));
    FAILURES.iter().map(|&(kind, title)| (kind.to_owned(), title)).chain(of_solvers)
}

impl SolveError {
    /// Kind of the failure of a result whose stated figures are not those of its mesh.
    pub const AUDIT_FAILED: &str = "audit-failed";

    /// Creates an error of one of the kinds of [`failures`].
    #[must_use]
    pub fn new(kind: &str, detail: impl Into<String>, errors: Vec<FieldError>) -> Self {
        let title =
            failures().find(|(name, _)| *name == kind).map_or("The solver found no valid mesh", |(_, title)| title);
        Self { kind: format!("/problems/{kind}"), title: title.into(), detail: detail.into(), errors }
    }

    /// Returns whether the audit withheld the result.
    #[must_use]
    pub fn is_of_the_audit(&self) -> bool {
        self.kind.ends_with(Self::AUDIT_FAILED)
    }
}
