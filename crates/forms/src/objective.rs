//! What a kind of request can minimise or maximise.

use crate::kind::Kind;
use schemars::JsonSchema;
use serde::Serialize;

/// One objective of one kind of request.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Objective {
    pub name: &'static str,
    pub kind: Kind,
    /// Quantity that is minimised or maximised, as a formula in words and symbols.
    pub minimises: &'static str,
    /// Unit of the objective's value, where `u` is the client's unit.
    pub unit: &'static str,
    /// Author, section and equation.
    pub source: &'static str,
    /// Names of the request's fields that change the solution.
    pub options: Vec<&'static str>,
}
