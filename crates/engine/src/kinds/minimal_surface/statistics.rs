//! Statistics of a minimal surface.

use super::certificate::Certificate;
use crate::audit::crossings::Crossings;
use crate::common::{AngleRange, Point};
use plateau_mesh::measure::Spread;
use plateau_minimal_surface::{self as geometry, ExtrapolatedArea, HistoryRow, MeanCurvature, Stability};
use schemars::JsonSchema;
use serde::Serialize;

/// A change of topology.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Pinch {
    pub iteration: u32,
    /// Place of the change in the request's unit and axes.
    pub place: Point,
    /// Kind of the change: `split` (a component became two), `handle_cut` (it stayed one) or
    /// `closed_component_removed`.
    pub what: &'static str,
}

/// One way to span the boundaries.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SpanningTopology {
    #[serde(flatten)]
    pub solved: geometry::SpanningTopology,
    /// With `certify`: the area is at most this fraction above the least area of all oriented surfaces with this
    /// boundary. Null if nothing is proven.
    pub gap: Option<f64>,
}

/// Comparison of the ways to span the boundaries, made with `topology: best`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Spanning {
    /// The topologies in order of area. Topologies without a film are last.
    pub topologies: Vec<SpanningTopology>,
    /// Whether a film that connects all boundaries exists.
    pub connected_film_exists: bool,
    /// For two boundaries without a connected film, the largest fraction of their gap at which a connected film exists.
    pub largest_gap_fraction: Option<f64>,
}

impl From<&geometry::SpanningComparison> for Spanning {
    fn from(spanning: &geometry::SpanningComparison) -> Self {
        let topology = |solved: &geometry::SpanningTopology| SpanningTopology { solved: solved.clone(), gap: None };
        Self {
            topologies: spanning.topologies.iter().map(topology).collect(),
            connected_film_exists: spanning.connected_film_exists,
            largest_gap_fraction: spanning.largest_gap_fraction,
        }
    }
}

/// Curves along which three sheets of a film meet, and the balance of the sheets there.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Junctions {
    /// Number of parts of the film that are connected without crossing a junction.
    pub sheets: usize,
    /// Curves along which three sheets meet, each as vertices of the mesh (counted from 0) from end to end. A closed
    /// curve ends with its first vertex.
    pub curves: Vec<Vec<u32>>,
    /// Number of mesh edges with three triangles.
    pub edges: usize,
    /// Number of vertices inside the film where such curves meet.
    pub points: usize,
    /// Total length of these curves.
    pub length: f64,
    /// Largest net pull of the sheets across a junction per length. It is 0 if the sheets balance, and 1 for a single
    /// sheet.
    pub residual: f64,
    /// Angles between neighbouring triangles around the junctions' edges.
    pub facet_angles_deg: Spread,
    /// Angles between the pulls of neighbouring sheets at the junctions' inner vertices.
    pub sheet_angles_deg: Spread,
    /// Largest departure of `sheet_angles_deg` from 120° at the vertices that are not next to an end of their junction.
    pub largest_deviation_deg: f64,
    /// The same at the vertices next to an end, where it may hardly decrease with the mesh size. It is 0 if there are
    /// no such vertices.
    pub largest_deviation_at_ends_deg: f64,
    /// Mean departure of `sheet_angles_deg` from 120° over all these vertices.
    pub mean_deviation_deg: f64,
    /// Number of negative eigenvalues of the second variation with moving junctions. Null if it was not computed, or if
    /// rounding does not decide the sign of one.
    pub morse_index: Option<usize>,
}

impl From<&geometry::JunctionStatistics> for Junctions {
    fn from(junctions: &geometry::JunctionStatistics) -> Self {
        let degrees = |angles: Spread| Spread {
            count: angles.count,
            min: angles.min.to_degrees(),
            mean: angles.mean.to_degrees(),
            max: angles.max.to_degrees(),
            std_dev: angles.std_dev.to_degrees(),
        };
        Self {
            sheets: junctions.sheets,
            curves: junctions.curves.clone(),
            edges: junctions.edges,
            points: junctions.points,
            length: junctions.length,
            residual: junctions.residual,
            facet_angles_deg: degrees(junctions.facet_angles),
            sheet_angles_deg: degrees(junctions.sheet_angles),
            largest_deviation_deg: junctions.largest_deviation.to_degrees(),
            largest_deviation_at_ends_deg: junctions.largest_deviation_at_ends.to_degrees(),
            mean_deviation_deg: junctions.mean_deviation.to_degrees(),
            morse_index: junctions.morse_index,
        }
    }
}

/// Statistics of a minimal surface. Lengths are in the request's unit, areas in its square, curvatures in its inverse,
/// and angles in degrees.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct MinimalStatistics {
    /// Middle of the mesh's bounding box, which files with `origin=local` are relative to.
    pub origin: Point,
    pub objective: &'static str,
    pub objective_value: f64,
    /// Solver that was used.
    pub solver: &'static str,
    /// Initial mesh that was built.
    pub initial_mesh: &'static str,
    pub vertices: usize,
    pub triangles: usize,
    pub boundary_loops: usize,
    pub components: usize,
    pub euler_characteristic: i64,
    /// Null for films with junctions, for which it is not defined.
    pub genus: Option<i64>,
    pub area: f64,
    /// Area of the initial mesh.
    pub initial_area: f64,
    /// Null if the boundary's points do not allow a second resolution, and for unstable surfaces.
    pub extrapolated_area: Option<ExtrapolatedArea>,
    pub mean_curvature: MeanCurvature,
    /// Residual of the normal direction, dimensionless: the largest mean curvature along the vertex normal, times the
    /// boundary's radius. It is 0 for a minimal surface, whichever solver was used.
    pub residual: f64,
    /// The same including the tangential part of the area gradient, which depends on the layout of the triangles.
    pub residual_full: f64,
    /// Whether the solver met its own rule, the mean curvature is within `curvature_tolerance`, and no triangle is
    /// flipped or degenerate. The rule is `tolerance` for `newton`, `area_tolerance` for `vertex_relaxation`, either of
    /// the two for `pinkall_polthier`, and `least_squares_tolerance` for `minimal_mean_curvature`.
    pub converged: bool,
    /// Rule or limit that ended the solver.
    pub stop_reason: &'static str,
    pub iterations: u32,
    pub history: Vec<HistoryRow>,
    /// Null if it was not computed.
    pub stability: Option<Stability>,
    pub edge_lengths: Spread,
    pub angles_deg: AngleRange,
    pub edges_swapped: u64,
    pub flipped_triangles: usize,
    pub degenerate_triangles: usize,
    /// Pairs of triangles that cross, touch or overlap beyond the vertices and edges that they share; 0 for an embedded
    /// mesh. Null if not all pairs were looked at.
    pub self_intersections: Option<u64>,
    /// Why `self_intersections` is null: `too_many_triangles`, `too_many_pairs`, `deadline_passed`.
    pub self_intersections_skipped: Option<&'static str>,
    /// Changes of topology in the order in which they happened.
    pub pinches: Vec<Pinch>,
    /// Null without `topology: best`.
    pub spanning: Option<Spanning>,
    /// Null unless the initial mesh of the film has edges with three triangles.
    pub junctions: Option<Junctions>,
    /// Proven lower bound of the area. Null without `certify`.
    pub certificate: Option<Certificate>,
}

impl MinimalStatistics {
    #[must_use]
    pub(crate) fn of(statistics: &geometry::Statistics, crossings: Crossings, origin: Point) -> Self {
        let pinch = |pinch: &plateau_mesh::remesh::thin_triangles::Pinch| Pinch {
            iteration: pinch.iteration,
            place: pinch.place.to_array(),
            what: pinch.what,
        };
        Self {
            origin,
            objective: statistics.objective.name(),
            objective_value: statistics.objective_value,
            solver: statistics.solver.name(),
            initial_mesh: statistics.initial_mesh.name(),
            vertices: statistics.vertices,
            triangles: statistics.triangles,
            boundary_loops: statistics.boundary_loops,
            components: statistics.components,
            euler_characteristic: statistics.euler_characteristic,
            genus: statistics.genus,
            area: statistics.area,
            initial_area: statistics.initial_area,
            extrapolated_area: statistics.extrapolated_area,
            mean_curvature: statistics.mean_curvature,
            residual: statistics.residual,
            residual_full: statistics.residual_full,
            converged: statistics.converged,
            stop_reason: statistics.stop_reason.name(),
            iterations: statistics.iterations,
            history: statistics.history.clone(),
            stability: statistics.stability,
            edge_lengths: statistics.quality.edge_lengths,
            angles_deg: AngleRange::of_radians(statistics.quality.angles),
            edges_swapped: statistics.edges_swapped,
            flipped_triangles: statistics.quality.flipped_triangles,
            degenerate_triangles: statistics.quality.degenerate_triangles,
            self_intersections: crossings.pairs,
            self_intersections_skipped: crossings.skipped,
            pinches: statistics.pinches.iter().map(pinch).collect(),
            spanning: statistics.spanning.as_ref().map(Into::into),
            junctions: statistics.junctions.as_ref().map(Into::into),
            certificate: None,
        }
    }
}
