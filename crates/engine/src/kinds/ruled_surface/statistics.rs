//! Statistics of strips.

use crate::audit::crossings::Crossings;
use crate::common::Point;
use plateau_ruled_surface as geometry;
use schemars::JsonSchema;
use serde::Serialize;

/// Statistics of one strip, or of all strips of a stack together. Lengths are in the request's unit, areas in its
/// square, and angles in degrees.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StripStatistics {
    /// Value of the objective. For `maximal_convexity` it is the number of convex bridges.
    pub objective_value: f64,
    /// Value of the secondary objective. Null without one.
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
    /// Value of `minimal_normal_variation`. Null without normals.
    pub normal_variation: Option<f64>,
    /// Largest angle between the normals of neighbouring triangles.
    pub largest_fold_deg: f64,
    /// Largest angle between the normals of neighbouring triangles at bridges that are not locally convex. It is 0 for
    /// a strip that can be developed.
    pub developability_deviation_deg: f64,
    pub shortest_bridge: f64,
    pub longest_bridge: f64,
}

/// Maximum number of bridges that are listed individually. `convex_bridges` counts all others.
pub(super) const LISTED_BRIDGES: usize = 200;

/// A bridge that is not locally convex: the sheet has to stretch there.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct ConcaveBridge {
    /// Number of the bridge. Bridges count from 0 over all strips, as in `cut_at`, in the flat pattern and in the list
    /// of bridges of the JSON mesh.
    pub bridge: u32,
    /// Vertices of the mesh at its two ends, on the first and on the second directrix of its strip.
    pub vertices: [u32; 2],
    /// Angle between the normals of its two triangles. 0 if one of them has no area.
    pub fold_deg: f64,
}

/// Quality of the strips' flat pattern.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct FlatPatternStatistics {
    /// Largest relative difference between an edge's length in space and in the plane.
    pub edge_length_error_max: f64,
    /// Whether an unrolled strip overlaps itself.
    pub self_overlap: bool,
    pub width: f64,
    pub height: f64,
    /// For each strip of a closed surface the number of the bridge at which its pattern is cut: the bridge of least
    /// fold, the first among equals. Bridges count from 0 over all strips. Null for open strips, which need no cut.
    pub cut_at: Option<Vec<u32>>,
}

/// Statistics of a ruled surface.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct RuledStatistics {
    /// Middle of the mesh's bounding box, which files with `origin=local` are relative to.
    pub origin: Point,
    /// Name of the objective, or `weighted` for a weighted sum.
    pub objective: &'static str,
    /// Number of vertices of the mesh.
    pub vertices: usize,
    /// Statistics of the whole surface. `triangles` and `area` are those of the mesh, caps included. All other figures
    /// are those of the strips together.
    #[serde(flatten)]
    pub total: StripStatistics,
    /// Statistics of each strip, in order. Caps belong to none.
    pub strips: Vec<StripStatistics>,
    /// The first 200 bridges that are not locally convex, from the first strip to the last. Empty if the surface can be
    /// developed. `bridges` less `convex_bridges` counts them all. The JSON mesh marks all of them, and
    /// `?colors=convexity` colours them.
    pub concave_bridges: Vec<ConcaveBridge>,
    pub flat_pattern: FlatPatternStatistics,
    /// Pairs of triangles that cross, touch or overlap beyond the vertices and edges that they share; 0 for an embedded
    /// mesh. Null if not all pairs were looked at.
    pub self_intersections: Option<u64>,
    /// Why `self_intersections` is null: `too_many_triangles`, `too_many_pairs`, `deadline_passed`.
    pub self_intersections_skipped: Option<&'static str>,
    /// For each directrix, whether `direction: auto` reversed it.
    pub reversed: Vec<bool>,
    /// For each directrix, what decided its direction under `direction: auto`: `area_vectors` of closed contours,
    /// `folds`, `ends` or `objective`. Null for the first directrix, beside an apex, and with `as_given`.
    pub direction_decided_by: Vec<Option<&'static str>>,
    /// Statistics of each objective's optimum (Wang-Tang's Table 1). Null without `all_objectives`.
    pub comparison: Option<Vec<Comparison>>,
    /// How far the points of the directrices moved, and what that brought. Null without `rail_tolerance`.
    pub rails: Option<RailStatistics>,
}

/// Result of `rail_tolerance`.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct RailStatistics {
    /// Largest distance of a point from its own place, in the request's unit.
    pub moved_max: f64,
    /// Vertex of the mesh that moved by `moved_max`, the lowest number among equals.
    pub moved_max_vertex: u32,
    /// Value of the objective for the points in their own places.
    pub before: f64,
    /// Improvement of the objective: `before` less `objective_value`, or the number of further convex bridges.
    pub gain: f64,
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

impl FlatPatternStatistics {
    fn of(pattern: &geometry::FlatPattern, closed: bool) -> Self {
        let cut = |strip: &geometry::FlatStrip| strip.numbers[0];
        Self {
            edge_length_error_max: pattern.edge_length_error_max,
            self_overlap: pattern.self_overlap,
            width: pattern.width,
            height: pattern.height,
            cut_at: closed.then(|| pattern.strips.iter().map(cut).collect()),
        }
    }
}

impl RuledStatistics {
    #[must_use]
    pub(crate) fn of(
        surface: &geometry::RuledSurface,
        options: &geometry::Options,
        crossings: Crossings,
        origin: Point,
    ) -> Self {
        Self {
            origin,
            objective: options.objective.name(),
            vertices: surface.mesh.vertices.len(),
            total: (&surface.statistics).into(),
            strips: surface.strips.iter().map(Into::into).collect(),
            concave_bridges: surface
                .concave_bridges
                .iter()
                .take(LISTED_BRIDGES)
                .map(|concave| ConcaveBridge {
                    bridge: concave.bridge,
                    vertices: surface.bridges[concave.bridge as usize],
                    fold_deg: concave.fold.to_degrees(),
                })
                .collect(),
            flat_pattern: FlatPatternStatistics::of(&surface.flat_pattern, options.closed),
            self_intersections: crossings.pairs,
            self_intersections_skipped: crossings.skipped,
            reversed: surface.reversed.clone(),
            direction_decided_by: surface
                .direction_decided_by
                .iter()
                .map(|criterion| criterion.map(geometry::DirectionCriterion::name))
                .collect(),
            rails: surface.rails.map(|rails| RailStatistics {
                moved_max: rails.moved_max,
                moved_max_vertex: rails.moved_max_vertex,
                before: rails.before,
                gain: rails.gain,
            }),
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
