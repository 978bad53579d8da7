//! `POST /v1/ruled-surfaces`: the request, its statistics, and the way to the geometry and back.

use super::body::PointList;
use super::common::{self, Cache, Point};
use super::objectives::Objective as ObjectiveDoc;
use super::{Checked, FieldError, Kind, Problem, Rejection};
use crate::config::LimitsConfig;
use crate::units::{Unit, UpAxis};
use plateau_geometry::ruled_surface as geometry;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Two or more directrices; every neighbouring pair is one strip, all strips one mesh.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RuledSurfaceRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default)]
    pub kind: Option<RuledSurfaceKind>,
    /// Whether the stored result of an equal earlier request may be returned.
    #[serde(default)]
    pub cache: Cache,
    /// URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
    /// `webhooks` of `GET /v1/limits`.
    #[serde(default)]
    #[schemars(length(max = 2000))]
    pub callback_url: Option<String>,
    /// Unit of the coordinates.
    #[serde(default)]
    pub units: Unit,
    /// Axis that points up.
    #[serde(default)]
    pub up: UpAxis,
    /// Polylines in order; one point alone is an apex.
    #[schemars(length(min = 2), inner(length(min = 1)))]
    pub directrices: Vec<Vec<Point>>,
    /// Whether the directrices are closed polygons (which do not repeat their first point).
    #[serde(default)]
    pub closed: bool,
    /// One of the named objectives, or a weighted sum of them.
    #[serde(default)]
    pub objective: Goal,
    /// Only with `maximal_convexity`: objective that decides among the strips with the most convex bridges.
    #[serde(default)]
    pub secondary_objective: Option<SecondaryObjective>,
    /// Tolerance of the test for local convexity: angle in degrees by which a direction may reach beyond the
    /// half-plane. 0 is the exact test.
    #[serde(default = "default_convexity_tolerance_deg")]
    #[schemars(range(min = 0, max = 45))]
    pub convexity_tolerance_deg: f64,
    /// `auto` reverses a directrix if that improves the objective; the statistics name the reversed ones. `as_given`
    /// reverses none.
    #[serde(default)]
    pub direction: Direction,
    /// How the ends of a closed stack are closed.
    #[serde(default)]
    pub caps: Caps,
    /// Surface normals along the directrices, in their shape; `minimal_normal_variation` needs them.
    #[serde(default)]
    pub normals: Option<Vec<Vec<Point>>>,
    /// Tangents along the directrices, in their shape; fitted if not given.
    #[serde(default)]
    pub tangents: Option<Vec<Vec<Point>>>,
    /// Solve for every objective and add the comparison to the statistics.
    #[serde(default)]
    pub all_objectives: bool,
    /// Resample the directrices before solving; as given by default.
    #[serde(default)]
    pub sampling: Option<Sampling>,
}

/// A rule by which every directrix is resampled. `extras.input_vertices` then maps each given point to the nearest
/// sample.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sampling {
    /// Points of each directrix; with `chord_height` the most that are kept, all that are needed by default.
    #[serde(default)]
    #[schemars(range(min = 2, max = 16_777_216))]
    pub samples: Option<usize>,
    pub by: SamplingRule,
    /// With `chord_height`: how far, in the request's unit, the kept points' chords may stray from the polyline.
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub tolerance: Option<f64>,
}

/// `parameter`: uniform in the number of the point; `arc_length`: uniform along the polyline; `chord_height`: those of
/// the given points that are needed to stay within `tolerance`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SamplingRule {
    Parameter,
    ArcLength,
    ChordHeight,
}

/// A named objective, or a weighted sum.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Goal {
    Named(Objective),
    Weighted(WeightedSum),
}

impl Default for Goal {
    fn default() -> Self {
        Self::Named(Objective::default())
    }
}

/// The sum of the named objectives times their weights.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WeightedSum {
    pub weights: Weights,
    /// Divide each term by its own optimum on the strip first: they have different units.
    #[serde(default = "yes")]
    pub normalise: bool,
}

fn yes() -> bool {
    true
}

/// At least one must be positive. `minimal_normal_variation` needs `normals`.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Weights {
    #[schemars(range(min = 0))]
    pub minimal_area: f64,
    #[schemars(range(min = 0))]
    pub minimal_twist: f64,
    #[schemars(range(min = 0))]
    pub minimal_bending_energy: f64,
    #[schemars(range(min = 0))]
    pub minimal_mean_curvature_variation: f64,
    #[schemars(range(min = 0))]
    pub minimal_normal_variation: f64,
}

fn default_convexity_tolerance_deg() -> f64 {
    1e-6
}

/// Objective that decides among the strips with the most convex bridges, summed over the bridges that are not convex.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SecondaryObjective {
    MinimalBendingEnergy,
    MinimalMeanCurvatureVariation,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    #[default]
    AsGiven,
    Auto,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Caps {
    #[default]
    None,
    Flat,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RuledSurfaceKind {
    RuledSurface,
}

/// Quantity that is minimised. `GET /v1/objectives` has the formulas.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    #[default]
    MinimalArea,
    MinimalTwist,
    MaximalConvexity,
    MinimalBendingEnergy,
    MinimalMeanCurvatureVariation,
    /// Needs `normals`.
    MinimalNormalVariation,
}

/// Memory that a point takes beside the solver's own estimate: its triangles, and the archive of both.
const BYTES_PER_POINT: u64 = 2_000;

impl RuledSurfaceRequest {
    /// Takes the points of a field that was read apart.
    pub(super) fn take(&mut self, list: &PointList) {
        let polylines = list.polylines.clone();
        match list.field {
            "directrices" => self.directrices = polylines,
            "normals" => self.normals = Some(polylines),
            "tangents" => self.tangents = Some(polylines),
            _ => {}
        }
    }

    /// Checks what the schema cannot say, and returns the request in the geometry's terms.
    ///
    /// # Errors
    /// Every offending value.
    pub(super) fn check(&self, limits: &LimitsConfig) -> Result<Checked, Rejection> {
        common::check_point_count("/directrices", &self.directrices, limits.points)?;
        self.check_sampling(limits)?;
        let (directrices, options) = self.to_geometry();
        let points: Vec<usize> = directrices.iter().map(Vec::len).collect();
        let estimate = geometry::estimate(&points, &options);
        let cells = estimate.cells;
        if cells > limits.grid_cells {
            let detail = format!("needs {cells} grid cells, more than this server takes ({})", limits.grid_cells);
            return Err(Rejection::TooLarge(vec![FieldError::new("/directrices", detail)]));
        }
        geometry::check(&directrices, &options)?;
        let points: usize = points.iter().sum();
        Ok(Checked {
            memory_bytes: estimate.bytes + points as u64 * BYTES_PER_POINT,
            quick: self.is_quick(points, cells),
            problem: Problem::RuledSurface { directrices, options },
        })
    }

    fn check_sampling(&self, limits: &LimitsConfig) -> Result<(), Rejection> {
        let Some(sampling) = self.sampling else { return Ok(()) };
        let wrong = |pointer: &str, detail: &str| Err(Rejection::Invalid(vec![FieldError::new(pointer, detail)]));
        match (sampling.by, sampling.samples, sampling.tolerance) {
            (SamplingRule::ChordHeight, _, None) => {
                return wrong("/sampling/tolerance", "chord_height needs a tolerance");
            }
            (SamplingRule::ChordHeight, ..) => {}
            (_, None, _) => return wrong("/sampling/samples", "this rule needs the number of samples"),
            (.., Some(_)) => return wrong("/sampling/tolerance", "goes with chord_height only"),
            _ => {}
        }
        let points = sampling.samples.unwrap_or(0).saturating_mul(self.directrices.len());
        if sampling.by != SamplingRule::ChordHeight && points > limits.points {
            let detail = format!("makes more points than this server takes ({}); see GET /v1/limits", limits.points);
            return Err(Rejection::TooLarge(vec![FieldError::new("/sampling/samples", detail)]));
        }
        Ok(())
    }

    fn sampling(&self) -> Option<geometry::Sampling> {
        let Sampling { samples, by, tolerance } = self.sampling?;
        // What is missing was refused before; none of it can reach the geometry as a zero.
        Some(match by {
            SamplingRule::Parameter => geometry::Sampling::Parameter { samples: samples.unwrap_or_default() },
            SamplingRule::ArcLength => geometry::Sampling::ArcLength { samples: samples.unwrap_or_default() },
            SamplingRule::ChordHeight => {
                geometry::Sampling::ChordHeight { samples, tolerance: tolerance.unwrap_or_default() }
            }
        })
    }

    /// True if solving it takes about a millisecond at most. Closed strips and exact convexity may take more than their
    /// cells say.
    fn is_quick(&self, points: usize, cells: u64) -> bool {
        const QUICK_POINTS: usize = 1_000;
        const QUICK_CELLS: u64 = 50_000;
        let simple = !self.closed && self.convexity_tolerance_deg != 0.0 && self.sampling.is_none();
        simple && points <= QUICK_POINTS && cells <= QUICK_CELLS
    }

    /// The geometry's own terms for this request.
    fn to_geometry(&self) -> (Vec<Vec<plateau_geometry::DVec3>>, geometry::Options) {
        let options = geometry::Options {
            closed: self.closed,
            objective: self.objective.into(),
            secondary: self.secondary_objective.map(|secondary| match secondary {
                SecondaryObjective::MinimalBendingEnergy => geometry::Secondary::BendingEnergy,
                SecondaryObjective::MinimalMeanCurvatureVariation => geometry::Secondary::MeanCurvatureVariation,
            }),
            convexity_tolerance: self.convexity_tolerance_deg.to_radians(),
            direction: match self.direction {
                Direction::AsGiven => geometry::Direction::AsGiven,
                Direction::Auto => geometry::Direction::Auto,
            },
            caps: match self.caps {
                Caps::None => geometry::Caps::None,
                Caps::Flat => geometry::Caps::Flat,
            },
            normals: self.normals.as_deref().map(common::polylines),
            tangents: self.tangents.as_deref().map(common::polylines),
            all_objectives: self.all_objectives,
            sampling: self.sampling(),
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
            Goal::Weighted(WeightedSum { weights, normalise }) => Self::Weighted(geometry::Weights {
                area: weights.minimal_area,
                twist: weights.minimal_twist,
                bending_energy: weights.minimal_bending_energy,
                mean_curvature_variation: weights.minimal_mean_curvature_variation,
                normal_variation: weights.minimal_normal_variation,
                normalise,
            }),
        }
    }
}

/// The named objectives of this kind; a request may also ask for a weighted sum of all but the convexity.
#[must_use]
pub fn objectives() -> Vec<ObjectiveDoc> {
    geometry::Objective::NAMED
        .iter()
        .map(|objective| ObjectiveDoc {
            name: objective.name(),
            kind: Kind::RuledSurface,
            minimises: objective.minimises(),
            unit: objective.unit(),
            source: objective.source(),
            options: vec![
                "closed",
                "secondary_objective",
                "convexity_tolerance_deg",
                "direction",
                "caps",
                "normals",
                "tangents",
                "all_objectives",
                "sampling",
            ],
        })
        .collect()
}

/// Statistics of one strip, or of all strips of a stack together.
/// Lengths in the request's unit, areas in its square, angles in degrees.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StripStatistics {
    /// Value of the objective. For `maximal_convexity` it is the number of convex bridges.
    pub objective_value: f64,
    /// Value of the secondary objective; null without one.
    pub secondary_value: Option<f64>,
    pub triangles: usize,
    pub bridges: usize,
    pub area: f64,
    /// Sum of 1 - n_p·n_q over the bridges (Wang-Tang, eq. 4).
    pub total_normal_twist: f64,
    /// Number of bridges that are locally convex.
    pub convex_bridges: usize,
    pub convex_bridge_ratio: f64,
    pub bending_energy: f64,
    pub mean_curvature_variation: f64,
    /// Value of `minimal_normal_variation`; null without normals.
    pub normal_variation: Option<f64>,
    /// Largest angle between the normals of neighbouring triangles.
    pub largest_fold_deg: f64,
    /// Largest angle between the normals of neighbouring triangles at bridges that are not locally convex: 0 for a
    /// strip that can be developed.
    pub developability_deviation_deg: f64,
    pub shortest_bridge: f64,
    pub longest_bridge: f64,
}

/// How well the strips unroll into the plane.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct FlatPatternStatistics {
    /// Largest relative difference between an edge's length in space and in the plane.
    pub edge_length_error_max: f64,
    /// Whether an unrolled strip overlaps itself.
    pub self_overlap: bool,
    pub width: f64,
    pub height: f64,
}

/// Statistics of a ruled surface.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct RuledStatistics {
    /// Name of the objective; `weighted` for a weighted sum.
    pub objective: &'static str,
    /// Number of vertices of the mesh.
    pub vertices: usize,
    #[serde(flatten)]
    pub total: StripStatistics,
    /// Statistics of each strip, in order.
    pub strips: Vec<StripStatistics>,
    /// Null for closed strips, which do not unroll.
    pub flat_pattern: Option<FlatPatternStatistics>,
    /// For each directrix, whether `direction: auto` reversed it.
    pub reversed: Vec<bool>,
    /// With `all_objectives`: the statistics of each objective's optimum (Wang-Tang's Table 1); otherwise null.
    pub comparison: Option<Vec<Comparison>>,
}

/// Statistics of one objective's optimum.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Comparison {
    pub objective: &'static str,
    pub secondary_objective: Option<&'static str>,
    #[serde(flatten)]
    pub statistics: StripStatistics,
}

impl From<&geometry::Statistics> for StripStatistics {
    fn from(strip: &geometry::Statistics) -> Self {
        Self {
            objective_value: strip.objective_value,
            secondary_value: strip.secondary_value,
            triangles: strip.triangles,
            bridges: strip.bridges,
            area: strip.area,
            total_normal_twist: strip.total_normal_twist,
            convex_bridges: strip.convex_bridges,
            convex_bridge_ratio: strip.convex_bridge_ratio,
            bending_energy: strip.bending_energy,
            mean_curvature_variation: strip.mean_curvature_variation,
            normal_variation: strip.normal_variation,
            largest_fold_deg: strip.largest_fold.to_degrees(),
            developability_deviation_deg: strip.developability_deviation.to_degrees(),
            shortest_bridge: strip.shortest_bridge,
            longest_bridge: strip.longest_bridge,
        }
    }
}

impl RuledStatistics {
    #[must_use]
    pub fn of(surface: &geometry::RuledSurface, options: &geometry::Options) -> Self {
        Self {
            objective: options.objective.name(),
            vertices: surface.mesh.vertices.len(),
            total: (&surface.statistics).into(),
            strips: surface.strips.iter().map(Into::into).collect(),
            flat_pattern: surface.flat_pattern.as_ref().map(|pattern| FlatPatternStatistics {
                edge_length_error_max: pattern.edge_length_error_max,
                self_overlap: pattern.self_overlap,
                width: pattern.width,
                height: pattern.height,
            }),
            reversed: surface.reversed.clone(),
            comparison: surface.comparison.as_ref().map(|rows| {
                let row = |row: &geometry::Comparison| Comparison {
                    objective: row.objective.name(),
                    secondary_objective: row.secondary.map(geometry::Secondary::name),
                    statistics: (&row.statistics).into(),
                };
                rows.iter().map(row).collect()
            }),
        }
    }
}
