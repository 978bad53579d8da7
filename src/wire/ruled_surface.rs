//! `POST /v1/ruled-surfaces`: the request, its statistics, and the way to the geometry and back.

use super::common::{self, Point, Units, UpAxis};
use super::objectives::Objective as ObjectiveDoc;
use super::{FieldError, Kind, Rejection};
use crate::config::LimitsConfig;
use plateau_geometry::ruled_surface as geometry;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Two or more directrices; every neighbouring pair is one strip, all strips one mesh.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RuledSurfaceRequest {
    /// May say what the path says already; `plateau solve` needs it.
    #[serde(default)]
    pub kind: Option<RuledSurfaceKind>,
    /// Unit of the coordinates.
    #[serde(default)]
    pub units: Units,
    /// Which axis points up.
    #[serde(default)]
    pub up: UpAxis,
    /// Polylines in order; one point alone is an apex.
    #[schemars(length(min = 2), inner(length(min = 1)))]
    pub directrices: Vec<Vec<Point>>,
    /// Whether the directrices are closed polygons (which do not repeat their first point).
    #[serde(default)]
    pub closed: bool,
    #[serde(default)]
    pub objective: Objective,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RuledSurfaceKind {
    RuledSurface,
}

/// What is made least; `GET /v1/objectives` has the formulas.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    #[default]
    MinimalArea,
}

impl RuledSurfaceRequest {
    /// What the schema cannot say.
    ///
    /// # Errors
    /// Every offending value.
    pub fn check(&self, limits: &LimitsConfig) -> Result<(), Rejection> {
        common::check_point_count("/directrices", &self.directrices, limits.points)?;
        let (directrices, options) = self.to_geometry();
        let points: Vec<usize> = directrices.iter().map(Vec::len).collect();
        let cells = geometry::estimate(&points, &options).cells;
        if cells > limits.grid_cells {
            let detail = format!("needs {cells} grid cells, more than this server takes ({})", limits.grid_cells);
            return Err(Rejection::TooLarge(vec![FieldError::new("/directrices", detail)]));
        }
        Ok(geometry::check(&directrices, &options)?)
    }

    /// The geometry's own terms for this request.
    #[must_use]
    pub fn to_geometry(&self) -> (Vec<Vec<plateau_geometry::DVec3>>, geometry::Options) {
        let options = geometry::Options {
            closed: self.closed,
            objective: match self.objective {
                Objective::MinimalArea => geometry::Objective::MinimalArea,
            },
            ..geometry::Options::default()
        };
        (common::polylines(&self.directrices), options)
    }
}

/// The objectives of this kind that can be asked for.
#[must_use]
pub fn objectives() -> Vec<ObjectiveDoc> {
    [geometry::Objective::MinimalArea]
        .iter()
        .map(|objective| ObjectiveDoc {
            name: objective.name(),
            kind: Kind::RuledSurface,
            minimises: objective.minimises(),
            unit: objective.unit(),
            source: objective.source(),
            options: vec!["closed"],
        })
        .collect()
}

/// What is reported about one strip, or about all of a stack together.
/// Lengths in the request's unit, areas in its square, angles in degrees.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StripStatistics {
    /// The objective's value on it: for maximal convexity the number of convex bridges.
    pub objective_value: f64,
    /// Of couplings; null without.
    pub secondary_value: Option<f64>,
    pub triangles: usize,
    pub bridges: usize,
    pub area: f64,
    /// Sum of 1 - n_p·n_q over the bridges (Wang-Tang, eq. 4).
    pub total_normal_twist: f64,
    /// Bridges that are locally convex.
    pub convex_bridges: usize,
    pub convex_bridge_ratio: f64,
    pub bending_energy: f64,
    pub mean_curvature_variation: f64,
    /// Null without normals.
    pub normal_variation: Option<f64>,
    /// Largest angle between the normals of neighbouring triangles.
    pub largest_fold_deg: f64,
    /// The same over the bridges that are not locally convex: 0 for a strip that can be developed.
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

/// What is reported about a ruled surface.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct RuledStatistics {
    pub objective: &'static str,
    #[serde(flatten)]
    pub total: StripStatistics,
    /// The same for each strip, in order.
    pub strips: Vec<StripStatistics>,
    /// Null for closed strips, which do not unroll.
    pub flat_pattern: Option<FlatPatternStatistics>,
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
            total: (&surface.statistics).into(),
            strips: surface.strips.iter().map(Into::into).collect(),
            flat_pattern: surface.flat_pattern.as_ref().map(|pattern| FlatPatternStatistics {
                edge_length_error_max: pattern.edge_length_error_max,
                self_overlap: pattern.self_overlap,
                width: pattern.width,
                height: pattern.height,
            }),
        }
    }
}
