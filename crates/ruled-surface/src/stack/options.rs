//! Options of a stack of strips.

use super::sampling::Sampling;
use crate::graph::weight::BendingLaw;
use crate::strip::objective::{Objective, Secondary};
use plateau_mesh::DVec3;

/// Default of [`Options::convexity_tolerance`]: 1e-6 degrees.
pub const DEFAULT_CONVEXITY_TOLERANCE: f64 = 1e-6 * std::f64::consts::PI / 180.0;

/// Options of [`solve`](crate::solve). By default the strips are open and have minimal area, and the directrices run as
/// given.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Whether the directrices are closed polygons. The optimum is then taken over every starting bridge too.
    pub closed: bool,
    /// The objective of each strip.
    pub objective: Objective,
    /// The secondary objective, with [`Objective::MaximalConvexity`] only.
    pub secondary: Option<Secondary>,
    /// Angle, in radians, by which the direction to a neighbour may lie outside the half-plane of a locally convex
    /// bridge. 0 asks for the exact test.
    pub convexity_tolerance: f64,
    /// The bending energy at folds beyond 90°, wherever it is minimised or reported.
    pub bending: BendingLaw,
    /// Whether directrices may be reversed.
    pub direction: Direction,
    /// The caps at the ends of a closed stack.
    pub caps: Caps,
    /// Surface normals, one for each point of each directrix. Needed for [`Objective::MinimalNormalVariation`].
    pub normals: Option<Vec<Vec<DVec3>>>,
    /// Tangents, one for each point of each directrix. If absent, they are fitted (eq. 13 and 14).
    pub tangents: Option<Vec<Vec<DVec3>>>,
    /// Whether to solve for every objective as well and fill
    /// [`RuledSurface::comparison`](crate::RuledSurface::comparison).
    pub all_objectives: bool,
    /// How directrices are resampled before the solve. `None` leaves them as given.
    pub sampling: Option<Sampling>,
    /// Distance by which each point may move from its own place for the optimum. Points that are resampled have the
    /// places of the samples. `None` keeps the points.
    pub rail_tolerance: Option<f64>,
    /// Whether the ends of open directrices move too, with `rail_tolerance`.
    pub rail_ends: RailEnds,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            closed: false,
            objective: Objective::MinimalArea,
            secondary: None,
            convexity_tolerance: DEFAULT_CONVEXITY_TOLERANCE,
            bending: BendingLaw::Monotone,
            direction: Direction::AsGiven,
            caps: Caps::None,
            normals: None,
            tangents: None,
            all_objectives: false,
            sampling: None,
            rail_tolerance: None,
            rail_ends: RailEnds::Free,
        }
    }
}

/// Whether a directrix may be run through backwards.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Direction {
    #[default]
    /// Each directrix runs as given.
    AsGiven,
    /// Each directrix but the first is reversed where it runs against the one before it.
    Auto,
}

/// Whether the ends of open directrices move when the other points do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum RailEnds {
    #[default]
    /// The ends move as every other point.
    Free,
    /// The ends keep their places.
    Fixed,
}

/// Criterion that decided in which direction a directrix is run through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectionCriterion {
    /// The area vectors of two closed contours.
    AreaVectors,
    /// Folds by more than 90°, which occur in only one of the two directions.
    Folds,
    /// The sum of the squared distances between the ends.
    Ends,
    /// The value of the objective, if none of the other criteria decides.
    Objective,
}

impl DirectionCriterion {
    /// The criterion's name, in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::AreaVectors => "area_vectors",
            Self::Folds => "folds",
            Self::Ends => "ends",
            Self::Objective => "objective",
        }
    }
}

/// The caps at the ends of a closed stack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Caps {
    #[default]
    /// The ends stay open.
    None,
    /// Constrained Delaunay triangulations of the planar end contours: a closed body, oriented outwards. A contour that
    /// is off its plane by at most a thousandth of its size is projected onto it before anything is solved, with the
    /// warning `projected`.
    Flat,
}
