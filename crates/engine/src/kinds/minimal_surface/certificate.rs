//! The lower bound of the area: the request for the bound, and its figures in the statistics.

use plateau_archive::Attribute;
use plateau_strict_json::bounds::{Fraction, UpTo600};
use plateau_strict_json::union;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Whether and how to prove a lower bound of the area.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Certify {
    /// `true` stands for the default options.
    Default(bool),
    Options(CertifyOptions),
}

union!(Certify { boolean: Default, object: Options });

impl Default for Certify {
    fn default() -> Self {
        Self::Default(false)
    }
}

/// Sharpness of the lower bound, and the limit of the search for it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CertifyOptions {
    /// The search ends once the film's area is at most this fraction above the bound.
    #[serde(default = "default_gap")]
    pub gap: Fraction,
    /// Number of nominal seconds of one core that the search may take. They are converted to work by fixed rates, so
    /// that the same request gives the same result on every machine.
    #[serde(default = "default_seconds")]
    pub seconds: UpTo600,
}

fn default_gap() -> Fraction {
    Fraction::new(0.005)
}

fn default_seconds() -> UpTo600 {
    UpTo600::new(2.0)
}

impl Default for CertifyOptions {
    fn default() -> Self {
        Self { gap: default_gap(), seconds: default_seconds() }
    }
}

/// A proven lower bound of the area of all oriented surfaces with this boundary, in whichever direction they run along
/// each polygon of it.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Certificate {
    /// No oriented surface of any topology with this boundary has a smaller area.
    pub area_lower_bound: f64,
    /// The film's area is at most this fraction above the least area of these surfaces. Null if the bound is 0.
    pub gap: Option<f64>,
    /// The surfaces for which the bound holds.
    pub scope: String,
    /// Number of nominal seconds to which the work of the search amounts. No clock is read, so that the result is the
    /// same on every machine.
    pub seconds: f64,
    pub iterations: u32,
    /// Number of tetrahedra of all fields together.
    pub tetrahedra: usize,
    /// Number of fields. Up to six boundaries each orientation of them has its own. With more, a field covers all
    /// directions of the boundaries that it leaves free.
    pub orientations: usize,
    /// The result in words.
    pub statement: String,
}

/// The parts of the archive that the search for a lower bound adds.
#[derive(Debug, Default)]
pub(super) struct Proof {
    pub slack: Option<Attribute>,
    pub document: Option<String>,
    /// Whether a deadline cut the search short.
    pub interrupted: bool,
}
