//! Request and result types, their JSON Schemas for the OpenAPI document, and their conversion to and from the
//! geometry's types.
//!
//! The schemas derived from the Rust types are published in the API document ([`components`]), and bodies are validated
//! against the same schemas before serde reads them ([`schema`]). Every error has a JSON Pointer, and a text that says what
//! the value must be ([`explain`]). Long lists of points are read before that, and the schema sees only their first
//! points ([`body`]). After the schema come checks that a schema cannot express, such as too few distinct points or two
//! directrices of a single point each. The last checks are the geometry's own. Besides `jobs/solve.rs`, only this module
//! knows both wire names and geometry types.

pub mod batch;
pub mod body;
pub mod cable_net;
pub mod callback;
pub mod common;
pub mod components;
pub mod explain;
pub mod job;
pub mod json;
pub mod mesh;
pub mod minimal_surface;
pub mod objectives;
pub mod ruled_surface;
pub mod schema;
pub mod tensile_structure;
pub mod uniform_mesh;
#[cfg(test)]
mod wrong_values;

use crate::config::LimitsConfig;
use body::{Body, PointList};
use cable_net::CableNetRequest;
use minimal_surface::MinimalSurfaceRequest;
use plateau_archive::units::{ForceUnit, Unit, UpAxis};
use plateau_mesh::error::Step;
use plateau_mesh::{DVec3, Error as GeometryError, InputError};
use ruled_surface::RuledSurfaceRequest;
use serde::de::DeserializeOwned;
use serde_json::Value;
use tensile_structure::TensileStructureRequest;
use uniform_mesh::UniformMeshRequest;

/// Number of errors of one body that are listed.
pub const MAX_ERRORS: usize = 50;

/// One offending value of a body. Values are never echoed.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
pub struct FieldError {
    /// JSON Pointer (RFC 6901) to the offending value.
    pub pointer: String,
    /// Description of the error.
    pub detail: String,
}

impl FieldError {
    pub fn new(pointer: impl Into<String>, detail: impl Into<String>) -> Self {
        Self { pointer: pointer.into(), detail: detail.into() }
    }
}

/// Names of geometry options whose request fields have other names, because the request has angles in degrees.
const RENAMED: [(&str, &str); 2] =
    [("convexity_tolerance", "convexity_tolerance_deg"), ("degenerate_angle", "degenerate_angle_deg")];

impl From<&InputError> for FieldError {
    fn from(error: &InputError) -> Self {
        let step = |step: &Step| match *step {
            Step::Field(field) => {
                let name = RENAMED.iter().find(|(option, _)| *option == field).map_or(field, |(_, name)| name);
                format!("/{name}")
            }
            Step::Index(index) => format!("/{index}"),
        };
        Self::new(error.place.0.iter().map(step).collect::<String>(), error.detail.clone())
    }
}

/// Reason for refusing a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rejection {
    /// The body is not JSON, or an object repeats a key.
    Malformed(String),
    /// The body is JSON but not a valid request.
    Invalid(Vec<FieldError>),
    /// The request is valid but exceeds a limit of this server.
    TooLarge(Vec<FieldError>),
}

impl Rejection {
    /// Prefixes each pointer, for a request that lies at `pointer` of a larger body.
    #[must_use]
    pub fn within(mut self, pointer: &str) -> Self {
        if let Self::Invalid(errors) | Self::TooLarge(errors) = &mut self {
            errors.iter_mut().for_each(|error| error.pointer.insert_str(0, pointer));
        }
        self
    }

    /// Shortens each pointer to the first member that the body lacks, if it leads through one. The default of that
    /// member is then the wrong value.
    fn placed_in(mut self, body: &Value) -> Self {
        if let Self::Invalid(errors) | Self::TooLarge(errors) = &mut self {
            for error in errors {
                let ends = error.pointer.match_indices('/').map(|(at, _)| at).skip(1).chain([error.pointer.len()]);
                let lacking = ends.into_iter().find(|&end| body.pointer(&error.pointer[..end]).is_none());
                if let Some(end) = lacking {
                    error.pointer.truncate(end);
                }
            }
        }
        self
    }
}

impl From<GeometryError> for Rejection {
    fn from(error: GeometryError) -> Self {
        match error {
            GeometryError::Input(errors) => Self::Invalid(errors.iter().map(FieldError::from).collect()),
            other => Self::Invalid(vec![FieldError::new("", other.to_string())]),
        }
    }
}

/// Kind of a request.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    RuledSurface,
    MinimalSurface,
    UniformMesh,
    TensileStructure,
    CableNet,
}

impl Kind {
    pub const ALL: [Self; 5] =
        [Self::RuledSurface, Self::MinimalSurface, Self::UniformMesh, Self::TensileStructure, Self::CableNet];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::RuledSurface => "ruled_surface",
            Self::MinimalSurface => "minimal_surface",
            Self::UniformMesh => "uniform_mesh",
            Self::TensileStructure => "tensile_structure",
            Self::CableNet => "cable_net",
        }
    }

    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Returns the names of the request fields that are lists of polylines.
    #[must_use]
    pub fn point_fields(self) -> &'static [&'static str] {
        match self {
            Self::RuledSurface => &["directrices", "normals", "tangents"],
            Self::MinimalSurface | Self::TensileStructure => &["boundaries"],
            Self::UniformMesh | Self::CableNet => &[],
        }
    }

    /// Returns what requests of this kind ask for, as a phrase with a verb.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::RuledSurface => "Finds the globally optimal ruled strip between directrices for an objective",
            Self::MinimalSurface => "Finds the minimal surface that spans boundary polylines",
            Self::UniformMesh => "Finds a mesh of a polygon, patch or film with as many equal edges as possible",
            Self::TensileStructure => "Finds the shape in equilibrium of a film with cables, pressure and weight",
            Self::CableNet => {
                "Finds the shape in equilibrium of a cable net that comes nearest to target forces and lengths"
            }
        }
    }

    /// Returns the path that accepts requests of this kind.
    #[must_use]
    pub fn path(self) -> &'static str {
        match self {
            Self::RuledSurface => "/v1/ruled-surfaces",
            Self::MinimalSurface => "/v1/minimal-surfaces",
            Self::UniformMesh => "/v1/uniform-meshes",
            Self::TensileStructure => "/v1/tensile-structures",
            Self::CableNet => "/v1/cable-nets",
        }
    }
}

/// Refuses bodies with too many values before they are parsed, because a value takes much more memory than its text.
/// Points, normals and tangents with three coordinates each have twelve values per point.
///
/// # Errors
/// Returns [`Rejection::TooLarge`].
pub fn refuse_too_many_values(body: &[u8], limits: &LimitsConfig) -> Result<(), Rejection> {
    let max_values = limits.points.saturating_mul(16).saturating_add(10_000);
    if body.iter().filter(|&&byte| byte == b',').count() <= max_values {
        return Ok(());
    }
    let detail = format!("has more values than a request of {} points can have; see GET /v1/limits", limits.points);
    Err(Rejection::TooLarge(vec![FieldError::new("", detail)]))
}

/// A request that passed every check before solving.
#[derive(Clone, Debug)]
pub struct Request {
    pub unit: Unit,
    pub up: UpAxis,
    /// Whether the kept result of an equal request may be reused.
    pub cache: common::Cache,
    /// The URL that receives a message when the job ends.
    pub callback_url: Option<String>,
    pub marks: common::Marks,
    /// Estimate of the memory that solving takes, including the result. The estimate is an upper bound.
    pub memory_bytes: u64,
    /// True if solving takes at most about a millisecond, so that it may run on a thread of the server.
    pub quick: bool,
    pub problem: Problem,
}

/// Input of a solver.
#[derive(Clone, Debug)]
pub enum Problem {
    RuledSurface {
        directrices: Vec<Vec<DVec3>>,
        options: plateau_ruled_surface::Options,
    },
    MinimalSurface {
        boundaries: Vec<Vec<DVec3>>,
        options: plateau_film::minimal_surface::Options,
        /// Whether and how to prove a lower bound of the area.
        certify: Option<plateau_lower_bound::Options>,
    },
    UniformMesh {
        domain: plateau_uniform_mesh::Domain,
        options: plateau_uniform_mesh::Options,
    },
    TensileStructure {
        structure: plateau_film::tensile_structure::Structure,
        options: plateau_film::tensile_structure::Options,
        force: ForceUnit,
    },
    CableNet {
        net: plateau_film::cable_net::Net,
        options: plateau_film::cable_net::Options,
        groups: Vec<cable_net::Group>,
        force: ForceUnit,
    },
}

/// Result of the checks of one kind of request.
#[derive(Debug)]
struct Checked {
    memory_bytes: u64,
    quick: bool,
    problem: Problem,
}

/// A request of one kind as its JSON has it.
trait KindRequest: DeserializeOwned {
    /// Returns the fields that concern the job.
    fn job(&self) -> &common::JobFields;

    /// Returns the unit of the coordinates and the axis that points up.
    fn axes(&self) -> (Unit, UpAxis);

    /// Takes the points of a field that was read separately.
    fn take(&mut self, _list: &PointList) {}

    /// Makes the checks that the schema cannot express, and converts the request to the geometry's types.
    ///
    /// # Errors
    /// Returns every offending value.
    fn check(&self, limits: &LimitsConfig) -> Result<Checked, Rejection>;
}

impl Request {
    /// Reads a body of a known kind. The stages are syntax, schema, types, limits and geometry.
    ///
    /// # Errors
    /// Returns all errors of the first stage that fails, at most [`MAX_ERRORS`] + 1. The extra error shows that some
    /// were left out.
    pub fn read(kind: Kind, body: &[u8], limits: &LimitsConfig) -> Result<(Self, Body), Rejection> {
        refuse_too_many_values(body, limits)?;
        // The fast reader accepts only valid bodies and gives no reason for refusing others. They are read again by the
        // strict reader, which reports every error.
        if let Some(body) = Body::read(body, kind.point_fields())
            && let Ok(request) = Self::of(kind, body.outline(), body.lists(), limits)
        {
            return Ok((request, body));
        }
        let value = json::parse(body)?;
        let request = Self::from_value(kind, &value, limits)?;
        Ok((request, value.into()))
    }

    /// Reads a body that was validated against the schema when it was submitted. The limits of this process may differ
    /// from those of the process that accepted it.
    ///
    /// # Errors
    /// Fails if this version does not know the body, or if it exceeds the limits.
    pub fn read_stored(kind: Kind, body: &[u8], limits: &LimitsConfig) -> Result<Self, Rejection> {
        let request = match kind {
            Kind::RuledSurface => Self::stored::<RuledSurfaceRequest>(body, limits),
            Kind::MinimalSurface => Self::stored::<MinimalSurfaceRequest>(body, limits),
            Kind::UniformMesh => Self::stored::<UniformMeshRequest>(body, limits),
            Kind::TensileStructure => Self::stored::<TensileStructureRequest>(body, limits),
            Kind::CableNet => Self::stored::<CableNetRequest>(body, limits),
        };
        request?.within(limits)
    }

    fn stored<T: KindRequest>(body: &[u8], limits: &LimitsConfig) -> Result<Self, Rejection> {
        let request: T = serde_json::from_slice(body).map_err(|error| Rejection::Malformed(error.to_string()))?;
        Self::checked(&request, limits)
    }

    /// Reads a body that names its own kind, as `plateau solve` accepts it.
    ///
    /// # Errors
    /// Returns the errors of [`Request::read`]. A missing or unknown `kind` is an error at `/kind`.
    pub fn read_with_kind(body: &[u8], limits: &LimitsConfig) -> Result<Self, Rejection> {
        let value = json::parse(body)?;
        schema::validate_with_kind(&value)?;
        Self::from_valid(&value, limits)
    }

    /// Reads a request of a known kind from a JSON value.
    ///
    /// # Errors
    /// Returns the errors of [`Request::read`].
    pub fn from_value(kind: Kind, value: &Value, limits: &LimitsConfig) -> Result<Self, Rejection> {
        Self::of(kind, value, &[], limits)
    }

    /// Reads a request that names its kind and was validated against the schema.
    fn from_valid(value: &Value, limits: &LimitsConfig) -> Result<Self, Rejection> {
        // The schema requires a known kind.
        let kind = value["kind"].as_str().and_then(Kind::from_name);
        let kind = kind.ok_or_else(|| Rejection::Invalid(vec![FieldError::new("/kind", "is required")]))?;
        Self::of_valid(kind, value, &[], limits)
    }

    /// Reads a request from a body's outline and the point lists that were read separately.
    fn of(kind: Kind, outline: &Value, lists: &[PointList], limits: &LimitsConfig) -> Result<Self, Rejection> {
        schema::validate(kind, outline)?;
        Self::of_valid(kind, outline, lists, limits)
    }

    fn of_valid(kind: Kind, outline: &Value, lists: &[PointList], limits: &LimitsConfig) -> Result<Self, Rejection> {
        let request = match kind {
            Kind::RuledSurface => Self::validated::<RuledSurfaceRequest>(outline, lists, limits),
            Kind::MinimalSurface => Self::validated::<MinimalSurfaceRequest>(outline, lists, limits),
            Kind::UniformMesh => Self::validated::<UniformMeshRequest>(outline, lists, limits),
            Kind::TensileStructure => Self::validated::<TensileStructureRequest>(outline, lists, limits),
            Kind::CableNet => Self::validated::<CableNetRequest>(outline, lists, limits),
        };
        request.map_err(|rejection| rejection.placed_in(outline))?.within(limits)
    }

    /// Reads an outline that was validated against the schema.
    fn validated<T: KindRequest>(
        outline: &Value,
        lists: &[PointList],
        limits: &LimitsConfig,
    ) -> Result<Self, Rejection> {
        let mut request: T = schema::deserialize(outline)?;
        lists.iter().for_each(|list| request.take(list));
        Self::checked(&request, limits)
    }

    fn checked<T: KindRequest>(request: &T, limits: &LimitsConfig) -> Result<Self, Rejection> {
        let Checked { memory_bytes, quick, problem } = request.check(limits)?;
        let (unit, up) = request.axes();
        let job = request.job();
        Ok(Self {
            unit,
            up,
            cache: job.cache,
            callback_url: job.callback_url.clone(),
            marks: common::Marks::new(job)?,
            memory_bytes,
            quick,
            problem,
        })
    }

    /// Refuses a request that needs more memory than the limit of one job.
    fn within(self, limits: &LimitsConfig) -> Result<Self, Rejection> {
        if self.memory_bytes <= limits.memory_bytes {
            return Ok(self);
        }
        let (needed, available) = (self.memory_bytes >> 20, limits.memory_bytes >> 20);
        let detail = format!("needs about {needed} MiB to solve, more than the limit of this server ({available} MiB)");
        Err(Rejection::TooLarge(vec![FieldError::new("", detail)]))
    }

    #[must_use]
    pub fn kind(&self) -> Kind {
        match self.problem {
            Problem::RuledSurface { .. } => Kind::RuledSurface,
            Problem::MinimalSurface { .. } => Kind::MinimalSurface,
            Problem::UniformMesh { .. } => Kind::UniformMesh,
            Problem::TensileStructure { .. } => Kind::TensileStructure,
            Problem::CableNet { .. } => Kind::CableNet,
        }
    }
}
