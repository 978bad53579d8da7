//! Ruled surfaces: the request, its statistics, and their conversion to and from the geometry's types.

mod audit;
mod solve;
mod statistics;

pub use statistics::{
    Comparison, ConcaveBridge, FlatPatternStatistics, RailStatistics, RuledStatistics, StripStatistics,
};

use crate::blocks::{self, Block, Input, Output, Part, Preset, Type};
use crate::checked::{Checked, KindRequest, Types};
use crate::common::{self, Point};
use crate::kind::{Entry, Kind, Objective as ObjectiveDoc, Units};
use crate::limits::{self, Limits};
use crate::options::{Given, Optioned, RequestOption, when};
use plateau_archive::units::{Unit, UpAxis};
use plateau_mesh::Execution;
use plateau_ruled_surface as geometry;
use plateau_strict_json::bounds::{AtLeast0, List, UpTo45, Whole, is_default, unwritten, yes};
use plateau_strict_json::rejection::{FieldError, Rejection};
use plateau_strict_json::union;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub const KIND: Kind = Kind::of(&ENTRY);

static ENTRY: Entry = Entry {
    name: "ruled_surface",
    path: "/v1/ruled-surfaces",
    summary: "Finds the globally optimal ruled strip between directrices for an objective",
    finds: "optimal ruled strips between curves",
    units: Units::Length,
    blocks: &[Block {
        name: "ruled-strip",
        title: "Ruled Strip",
        description: "Best triangulated strip between two or more curves, with its flat pattern.",
        inputs: &[
            Input::list("Rails", "R", Type::Curve, 2, "Curves in order. If all are closed, the strip is closed too."),
            Input::optional(
                "Objective",
                "O",
                Preset::Text("minimal_area"),
                "minimal_area, minimal_twist, maximal_convexity, minimal_bending_energy or \
                 minimal_mean_curvature_variation.",
            )
            .to("/objective"),
            Input::optional(
                "Samples",
                "N",
                Preset::Integer(0),
                "Number of points along each rail, at equal distances. 0 takes the points that the tolerance gives.",
            ),
            Input::optional(
                "Align",
                "A",
                Preset::Boolean(true),
                "Whether a rail that runs against the one before it is reversed.",
            ),
        ],
    }],
    outputs: &[
        blocks::MESH,
        blocks::AREA,
        Output::part(Part::Rulings, "Rulings", "R", Type::Curve, "Lines between the rails."),
        Output::part(Part::Outlines, "Outlines", "O", Type::Curve, "Outlines of the flat pattern in the xy plane."),
        Output::part(Part::Folds, "Folds", "F", Type::Curve, "Folds of the flat pattern."),
        Output::part(
            Part::FoldAngles,
            "Fold Angles",
            "FA",
            Type::Number,
            "Angle of each fold in degrees, positive for a mountain fold.",
        ),
    ],
    objectives,
    types: Types::of::<RuledSurfaceRequest>(),
};

/// Two or more directrices. Every neighbouring pair forms one strip, and all strips form one mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RuledSurfaceRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default, skip_serializing_if = "unwritten")]
    pub kind: Option<RuledSurfaceKind>,
    /// Unit of the coordinates.
    #[serde(default)]
    pub units: Unit,
    /// Axis that points up.
    #[serde(default)]
    pub up: UpAxis,
    /// Polylines in order. A single point is an apex.
    pub directrices: List<List<Point, 1>, 2>,
    /// Whether the directrices are closed polygons (which do not repeat their first point).
    #[serde(default)]
    pub closed: bool,
    /// One of the named objectives, or a weighted sum of them.
    #[serde(default, skip_serializing_if = "is_default")]
    pub objective: Goal,
    /// Objective that decides among the strips with the most convex bridges. It is used only with `maximal_convexity`.
    #[serde(default)]
    pub secondary_objective: Option<geometry::Secondary>,
    /// Tolerance of the test for local convexity: the angle in degrees by which a direction may reach beyond the
    /// half-plane. 0 is the exact test.
    #[serde(default = "default_convexity_tolerance_deg")]
    pub convexity_tolerance_deg: UpTo45,
    /// Bending energy at folds beyond 90 degrees, in the objective, the secondary objective and the statistics.
    #[serde(default, skip_serializing_if = "is_default")]
    pub bending: geometry::BendingLaw,
    /// `auto` reverses a directrix that runs against the one before it. Closed contours then have area vectors that
    /// agree. Of the two ways to join open directrices, a way whose strip of least area folds by more than 90° loses to
    /// one whose strip does not; after that the smaller sum of the squared distances between the ends decides, and the
    /// objective if the sums differ by less than 1%. The statistics list the reversed directrices (`reversed`) and what
    /// decided (`direction_decided_by`). `as_given` reverses none, and the warning `opposite_directions` says where
    /// `auto` would.
    #[serde(default, skip_serializing_if = "is_default")]
    pub direction: geometry::Direction,
    /// Treatment of the ends of a closed stack: open, or closed by flat caps. An end contour that is off its plane by
    /// at most a thousandth of its size is projected onto it for the cap, with the warning `projected`.
    #[serde(default, skip_serializing_if = "is_default")]
    pub caps: geometry::Caps,
    /// Surface normals along the directrices, with the same shape as `directrices`. `minimal_normal_variation` requires
    /// them.
    #[serde(default)]
    pub normals: Option<Vec<Vec<Point>>>,
    /// Tangents along the directrices, with the same shape as `directrices`. If null, they are estimated from the
    /// points.
    #[serde(default)]
    pub tangents: Option<Vec<Vec<Point>>>,
    /// Solve for every objective and add the comparison to the statistics.
    #[serde(default)]
    pub all_objectives: bool,
    /// Rule by which the directrices are resampled before solving. If null, they are used as given.
    #[serde(default)]
    pub sampling: Option<Sampling>,
    /// Distance, in the request's unit, by which every point of the directrices may move from its own place for the
    /// optimum (Wang-Tang, section 7). It is at most a quarter of the largest distance of a point from the mean of all
    /// points. The bridges and the points are improved in turn, which finds a local optimum. Its value is never worse
    /// than that of the points as given, and never worse than with a smaller tolerance. Samples have the places that
    /// `sampling` gives them. It is not allowed with `caps`, nor with a weighted sum unless `normalise` is false. If
    /// null, the points stay.
    #[serde(default)]
    pub rail_tolerance: Option<AtLeast0>,
    /// Whether the ends of open directrices move as the other points do. Needs `rail_tolerance`.
    #[serde(default, skip_serializing_if = "is_default")]
    pub rail_ends: geometry::RailEnds,
}

/// Rule by which every directrix is resampled. `extras.input_vertices` of the mesh then maps each given point to the
/// nearest sample.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sampling {
    /// Number of points of each directrix. With `chord_height` it is the largest number of points that are kept; null
    /// then keeps all points that the tolerance requires.
    #[serde(default)]
    pub samples: Option<Whole<2, 16_777_216>>,
    pub by: SamplingRule,
    /// Largest distance, in the request's unit, between the polyline and the chords of the kept points. It is used only
    /// with `chord_height`.
    #[serde(default)]
    pub tolerance: Option<AtLeast0>,
}

fn count(samples: Whole<2, 16_777_216>) -> usize {
    samples.get() as usize
}

/// `parameter` spaces the samples uniformly in the number of the point. `arc_length` spaces them uniformly along the
/// polyline. `chord_height` keeps those of the given points that are needed to stay within `tolerance`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SamplingRule {
    Parameter,
    ArcLength,
    ChordHeight,
}

/// A named objective, or a weighted sum.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Goal {
    Named(Objective),
    Weighted(ObjectiveSum),
}

union!(Goal { name: Named, object: Weighted });

impl Default for Goal {
    fn default() -> Self {
        Self::Named(Objective::default())
    }
}

/// The sum of the named objectives times their weights.
// The type's name precedes `RuledSurfaceObjective` in the alphabet, because openapi-generator sorts the alternatives of
// `Goal` by name, and its TypeScript compiles only if the object comes first.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObjectiveSum {
    pub weights: Weights,
    /// Whether each term is first divided by its own optimum on the strip, because the terms have different units.
    #[serde(default = "yes")]
    pub normalise: bool,
}

/// Weights of the objectives. At least one must be positive. `minimal_normal_variation` requires `normals`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Weights {
    pub minimal_area: AtLeast0,
    pub minimal_twist: AtLeast0,
    pub minimal_bending_energy: AtLeast0,
    pub minimal_mean_curvature_variation: AtLeast0,
    pub minimal_normal_variation: AtLeast0,
}

fn default_convexity_tolerance_deg() -> UpTo45 {
    UpTo45::new(1e-6)
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RuledSurfaceKind {
    RuledSurface,
}

/// Quantity that is minimised. `GET /v1/objectives` has the formulas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "RuledSurfaceObjective")]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    #[default]
    MinimalArea,
    MinimalTwist,
    MaximalConvexity,
    MinimalBendingEnergy,
    MinimalMeanCurvatureVariation,
    /// Requires `normals`.
    MinimalNormalVariation,
}

impl Optioned for RuledSurfaceRequest {
    const OPTIONS: &'static [RequestOption] = &[
        RequestOption::always("closed"),
        RequestOption::with("secondary_objective", &[&[when("objective", &["maximal_convexity"])]]),
        RequestOption::always("convexity_tolerance_deg"),
        RequestOption::always("bending"),
        RequestOption::always("direction"),
        RequestOption::with("caps", &[&[when("closed", &["true"])]]),
        RequestOption::always("normals"),
        RequestOption::always("tangents"),
        RequestOption::always("all_objectives"),
        RequestOption::always("sampling"),
        RequestOption::always("rail_tolerance"),
        RequestOption::with("rail_ends", &[&[when("closed", &["false"])]]),
    ];

    fn idle(&self, given: &Given<'_>) -> Vec<FieldError> {
        let is_idle = given.has("/rail_ends") && self.rail_tolerance.is_none();
        let detail = "has no effect in this request: it needs rail_tolerance";
        is_idle.then(|| FieldError::new("/rail_ends", detail)).into_iter().collect()
    }

    fn choice(&self, member: &str) -> &'static str {
        match member {
            "closed" if self.closed => "true",
            "closed" => "false",
            _ => geometry::Objective::from(self.objective).name(),
        }
    }
}

/// Memory above which a strip's estimate is worth the time that a closer one takes, in bytes.
const LARGE_BYTES: u64 = 8 << 20;

impl KindRequest for RuledSurfaceRequest {
    type Statistics = RuledStatistics;

    fn axes(&self) -> (Unit, UpAxis) {
        (self.units, self.up)
    }

    fn check(&self, limits: &Limits) -> Result<Checked, Rejection> {
        limits::check_count("/directrices", common::count(&self.directrices), limits.points, "points")?;
        self.check_sampling(limits)?;
        let (directrices, options) = self.to_geometry();
        let points: Vec<usize> = directrices.iter().map(Vec::len).collect();
        let mut estimate = geometry::estimate(&points, &options);
        if estimate.cells > limits.grid_cells || estimate.bytes > LARGE_BYTES {
            // The search for a strip of least area may visit only a small part of its grid, and rails that move take
            // fewer rungs for a small tolerance.
            estimate = geometry::estimate_for(&directrices, &options, &Execution::default())?;
        }
        let cells = estimate.cells;
        if cells > limits.grid_cells {
            let detail = format!("needs {cells} grid cells, more than are allowed ({})", limits.grid_cells);
            let pointer = if self.rail_tolerance.is_some() { "/rail_tolerance" } else { "/directrices" };
            return Err(Rejection::TooLarge(vec![FieldError::new(pointer, detail)]));
        }
        geometry::check(&directrices, &options)?;
        let points: usize = points.iter().sum();
        Ok(Checked {
            memory_bytes: estimate.bytes,
            quick: self.is_quick(points, cells),
            input: Box::new(solve::SolverInput { directrices, options }),
        })
    }
}

impl RuledSurfaceRequest {
    fn check_sampling(&self, limits: &Limits) -> Result<(), Rejection> {
        let Some(sampling) = self.sampling else { return Ok(()) };
        let invalid = |pointer: &str, detail: &str| Err(Rejection::Invalid(vec![FieldError::new(pointer, detail)]));
        match (sampling.by, sampling.samples, sampling.tolerance) {
            (SamplingRule::ChordHeight, _, None) => {
                return invalid("/sampling/tolerance", "chord_height needs a tolerance");
            }
            (SamplingRule::ChordHeight, ..) => {}
            (_, None, _) => return invalid("/sampling/samples", "is required with this rule"),
            (.., Some(_)) => return invalid("/sampling/tolerance", "is only allowed with chord_height"),
            _ => {}
        }
        let points = sampling.samples.map_or(0, count).saturating_mul(self.directrices.len());
        if sampling.by != SamplingRule::ChordHeight && points > limits.points {
            let detail = format!("makes more points than are allowed ({})", limits.points);
            return Err(Rejection::TooLarge(vec![FieldError::new("/sampling/samples", detail)]));
        }
        Ok(())
    }

    fn sampling(&self) -> Option<geometry::Sampling> {
        let Sampling { samples, by, tolerance } = self.sampling?;
        // Missing values were refused by `check_sampling`, so the zeros below are never used.
        Some(match by {
            SamplingRule::Parameter => geometry::Sampling::Parameter { samples: samples.map_or(0, count) },
            SamplingRule::ArcLength => geometry::Sampling::ArcLength { samples: samples.map_or(0, count) },
            SamplingRule::ChordHeight => geometry::Sampling::ChordHeight {
                samples: samples.map(count),
                tolerance: tolerance.unwrap_or_default().get(),
            },
        })
    }

    /// Returns true if solving takes at most about a millisecond. Closed strips and exact convexity may take longer
    /// than the number of their cells suggests, and each strip costs some 40 µs beside its cells.
    fn is_quick(&self, points: usize, cells: u64) -> bool {
        const QUICK_STRIPS: usize = 20;
        const QUICK_POINTS: usize = 1_000;
        const QUICK_CELLS: u64 = 50_000;
        let simple = !self.closed && self.convexity_tolerance_deg.get() != 0.0 && self.sampling.is_none();
        simple && self.directrices.len() <= QUICK_STRIPS + 1 && points <= QUICK_POINTS && cells <= QUICK_CELLS
    }

    /// Converts the request to the geometry's types.
    fn to_geometry(&self) -> (Vec<Vec<plateau_mesh::DVec3>>, geometry::Options) {
        let options = geometry::Options {
            closed: self.closed,
            objective: self.objective.into(),
            secondary: self.secondary_objective,
            convexity_tolerance: self.convexity_tolerance_deg.get().to_radians(),
            bending: self.bending,
            direction: self.direction,
            caps: self.caps,
            normals: self.normals.as_deref().map(common::polylines),
            tangents: self.tangents.as_deref().map(common::polylines),
            all_objectives: self.all_objectives,
            sampling: self.sampling(),
            rail_tolerance: self.rail_tolerance.map(AtLeast0::get),
            rail_ends: self.rail_ends,
        };
        (common::polylines(&self.directrices), options)
    }
}

impl From<Goal> for geometry::Objective {
    fn from(goal: Goal) -> Self {
        match goal {
            Goal::Named(Objective::MinimalArea) => Self::MinimalArea,
            Goal::Named(Objective::MinimalTwist) => Self::MinimalTwist,
            Goal::Named(Objective::MaximalConvexity) => Self::MaximalConvexity,
            Goal::Named(Objective::MinimalBendingEnergy) => Self::MinimalBendingEnergy,
            Goal::Named(Objective::MinimalMeanCurvatureVariation) => Self::MinimalMeanCurvatureVariation,
            Goal::Named(Objective::MinimalNormalVariation) => Self::MinimalNormalVariation,
            Goal::Weighted(ObjectiveSum { weights, normalise }) => Self::Weighted(geometry::Weights {
                area: weights.minimal_area.get(),
                twist: weights.minimal_twist.get(),
                bending_energy: weights.minimal_bending_energy.get(),
                mean_curvature_variation: weights.minimal_mean_curvature_variation.get(),
                normal_variation: weights.minimal_normal_variation.get(),
                normalise,
            }),
        }
    }
}

/// Returns the named objectives of this kind. A request may also ask for a weighted sum of all of them except the
/// convexity.
fn objectives() -> Vec<ObjectiveDoc> {
    geometry::Objective::NAMED
        .iter()
        .map(|objective| ObjectiveDoc {
            name: objective.name(),
            kind: KIND,
            minimises: objective.minimises(),
            unit: objective.unit(),
            source: objective.source(),
            options: Vec::new(),
        })
        .collect()
}
