//! Reports of a solver besides its result: progress, warnings and the reason for a failure.

use plateau_mesh::codes::{Reason, WarningCode};
use plateau_strict_json::rejection::FieldError;
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

/// Declares kinds of failures. Every kind is in `ALL`, from which the catalogue is made, so that no error has a kind
/// that the catalogue does not explain.
#[macro_export]
macro_rules! failure_kinds {
    ($(#[$attribute:meta])* $kinds:ident { $($kind:ident = $name:literal: $title:literal,)+ }) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $kinds {
            $(#[doc = $title] $kind,)+
        }

        impl $kinds {
            /// The last part of an error's `type`, and its title.
            pub const ALL: &[(&str, &str)] = &[$(($name, $title)),+];

            /// Creates an error of this kind.
            #[must_use]
            pub fn error(
                self,
                detail: impl Into<String>,
                errors: Vec<plateau_strict_json::rejection::FieldError>,
            ) -> $crate::report::SolveError {
                let (name, title) = Self::ALL[self as usize];
                let kind = format!("/problems/{name}");
                $crate::report::SolveError { kind, title: title.into(), detail: detail.into(), errors }
            }
        }
    };
}

failure_kinds! {
    /// Failures that do not come from a [`Reason`] of a solver.
    Failure {
        AuditFailed = "audit-failed": "The figures of the result are not those of its mesh",
        Deadline = "deadline": "The deadline passed",
        InvalidGeometry = "invalid-geometry": "The geometry is invalid",
    }
}

/// Returns every kind of failure: the last part of an error's `type`, and its title.
pub fn failures() -> impl Iterator<Item = (String, &'static str)> {
    let of_solvers = Reason::ALL.iter().map(|&reason| (name(reason), reason.meaning()));
    Failure::ALL.iter().map(|&(kind, title)| (kind.to_owned(), title)).chain(of_solvers)
}

/// Returns the last part of the `type` of a solver's error.
fn name(reason: Reason) -> String {
    reason.name().replace('_', "-")
}

impl SolveError {
    /// Creates the error for a solver that has given up.
    #[must_use]
    pub fn of_solver(reason: Reason, detail: impl Into<String>, errors: Vec<FieldError>) -> Self {
        let kind = format!("/problems/{}", name(reason));
        Self { kind, title: reason.meaning().into(), detail: detail.into(), errors }
    }

    /// Creates the error for a defect of the server.
    #[must_use]
    pub fn internal(detail: impl Into<String>) -> Self {
        Self::of_solver(Reason::Internal, detail, Vec::new())
    }

    /// Returns whether the audit withheld the result.
    #[must_use]
    pub fn is_of_the_audit(&self) -> bool {
        self.kind == Failure::AuditFailed.error("", Vec::new()).kind
    }
}
