//! Blocks of a visual program, such as Grasshopper's components. A block has named inputs, from which the host makes a
//! request, and outputs, which show parts of the result.

use serde::Serialize;
use serde_json::Value;

/// A block that makes requests of one kind. The host appends inputs for a tolerance and for any further field of the
/// request.
#[derive(Debug)]
pub struct Block {
    /// Name in kebab case.
    pub name: &'static str,
    pub title: &'static str,
    /// Description of the block, in one sentence.
    pub description: &'static str,
    pub inputs: &'static [Input],
}

/// Type of an input or output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    Boolean,
    Curve,
    Integer,
    Mesh,
    Number,
    Point,
    Text,
    Vector,
}

/// An input. A block does not run while an input without a default has no value.
#[derive(Clone, Debug)]
pub struct Input {
    pub name: &'static str,
    pub nickname: &'static str,
    pub description: &'static str,
    pub of: Type,
    /// Smallest number of values, for an input that takes a list. `None` for an input that takes a single value.
    pub at_least: Option<u32>,
    pub default: Option<Preset>,
    /// JSON Pointer to the field of the request that takes the value unchanged. If it is `None`, the host's own code
    /// for the block uses the value.
    pub field: Option<&'static str>,
}

/// Value of an input for which the user gives none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Preset {
    Boolean(bool),
    Integer(i64),
    Number(f64),
    Text(&'static str),
}

impl From<Preset> for Value {
    fn from(default: Preset) -> Self {
        match default {
            Preset::Boolean(value) => value.into(),
            Preset::Integer(value) => value.into(),
            Preset::Number(value) => value.into(),
            Preset::Text(value) => value.into(),
        }
    }
}

impl Input {
    #[must_use]
    pub const fn required(name: &'static str, nickname: &'static str, of: Type, description: &'static str) -> Self {
        Self { name, nickname, description, of, at_least: None, default: None, field: None }
    }

    /// Creates an input that takes a list of `at_least` or more values.
    #[must_use]
    pub const fn list(
        name: &'static str,
        nickname: &'static str,
        of: Type,
        at_least: u32,
        description: &'static str,
    ) -> Self {
        Self { name, nickname, description, of, at_least: Some(at_least), default: None, field: None }
    }

    #[must_use]
    pub const fn optional(
        name: &'static str,
        nickname: &'static str,
        default: Preset,
        description: &'static str,
    ) -> Self {
        let of = match default {
            Preset::Boolean(_) => Type::Boolean,
            Preset::Integer(_) => Type::Integer,
            Preset::Number(_) => Type::Number,
            Preset::Text(_) => Type::Text,
        };
        Self { name, nickname, description, of, at_least: None, default: Some(default), field: None }
    }

    /// Sets the field of the request, as a JSON Pointer, that takes the value unchanged.
    #[must_use]
    pub const fn to(mut self, field: &'static str) -> Self {
        self.field = Some(field);
        self
    }
}

/// An output that every block of a kind has.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    pub name: &'static str,
    pub nickname: &'static str,
    pub description: &'static str,
    pub of: Type,
    pub source: Source,
}

/// Source of an output's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    Part(Part),
    /// JSON Pointer into the statistics.
    Statistic(&'static str),
}

/// Part of a result: geometry, or a list with one value for each item of some geometry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    Mesh,
    Area,
    Rulings,
    Outlines,
    Folds,
    FoldAngles,
    Members,
    MemberLengths,
    Cables,
    CableForces,
    Anchors,
    AnchorForces,
}

impl Output {
    #[must_use]
    pub const fn part(
        part: Part,
        name: &'static str,
        nickname: &'static str,
        of: Type,
        description: &'static str,
    ) -> Self {
        Self { name, nickname, description, of, source: Source::Part(part) }
    }

    /// Creates an output of the figure at a JSON Pointer into the statistics.
    #[must_use]
    pub const fn figure(
        pointer: &'static str,
        name: &'static str,
        nickname: &'static str,
        of: Type,
        description: &'static str,
    ) -> Self {
        Self { name, nickname, description, of, source: Source::Statistic(pointer) }
    }
}

/// Input for closed boundary curves. Several kinds share this and the following inputs and outputs.
pub(crate) const BOUNDARIES: Input = Input::list("Boundaries", "B", Type::Curve, 1, "Closed curves.");
pub(crate) const TRIANGLES: Input = Input::optional("Triangles", "T", Preset::Integer(2000), "Number of triangles.");
pub(crate) const EDGE_LENGTH: Input = Input::optional(
    "Edge Length",
    "L",
    Preset::Number(0.0),
    "Mean edge length in place of the number of triangles, unless 0.",
);
pub(crate) const MESH: Output =
    Output::part(Part::Mesh, "Mesh", "M", Type::Mesh, "The mesh, with vertices in double precision.");
pub(crate) const AREA: Output = Output::figure("/area", "Area", "A", Type::Number, "Area of the mesh.");
pub(crate) const CONVERGED: Output =
    Output::figure("/converged", "Converged", "C", Type::Boolean, "Whether the solver reached its tolerance.");
pub(crate) const CABLE_FORCES: Output =
    Output::part(Part::CableForces, "Cable Forces", "F", Type::Number, "Force in each of them.");
pub(crate) const ANCHOR_FORCES: Output = Output::part(
    Part::AnchorForces,
    "Anchor Forces",
    "AF",
    Type::Vector,
    "Force of each of these supports on the structure.",
);
