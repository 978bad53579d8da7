//! Statistics of a lattice.

use crate::audit::crossings::Crossings;
use crate::common::{AngleRange, Point};
use plateau_mesh::measure::Spread;
use plateau_uniform_mesh as geometry;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Maximum number of members outside [ℓ, 2ℓ] that are listed individually. `out_of_range_edges` counts all of them.
const LISTED_EDGES: usize = 200;

/// Count, minimum, mean, maximum and standard deviation of a group of lengths. All are 0 for an empty group.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct GroupLengths {
    pub count: usize,
    pub min: f64,
    pub mean: f64,
    pub max: f64,
    pub std_dev: f64,
}

impl From<Spread> for GroupLengths {
    fn from(spread: Spread) -> Self {
        let Spread { count, min, mean, max, std_dev } = spread;
        Self { count, min, mean, max, std_dev }
    }
}

/// One group of members at one stage.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct StageGroup {
    #[serde(flatten)]
    pub lengths: GroupLengths,
    /// Number of members within the tolerance of the edge length.
    pub equal_edges: usize,
    /// Smallest number of lengths for all members if lengths that differ by at most the tolerance count as one.
    pub distinct_lengths: usize,
}

impl From<geometry::statistics::Group> for StageGroup {
    fn from(group: geometry::statistics::Group) -> Self {
        Self { lengths: group.lengths.into(), equal_edges: group.equal_edges, distinct_lengths: group.distinct_lengths }
    }
}

/// One stage of the computation: a pair of rows of Katoh, Ohsaki and Xu's Table 1.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Stage {
    /// Name of the stage: `auxiliary_surface`, `auxiliary_plane`, `plane`, `surface`, `optimised_nodes` or
    /// `shared_lengths`.
    pub name: &'static str,
    pub all: StageGroup,
    /// Null for the auxiliary triangulation.
    pub lattice: Option<StageGroup>,
}

/// A member outside the range from the edge length to its double.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct OutOfRange {
    pub vertices: [u32; 2],
    pub length: f64,
    /// Reason: `short_side`, `sharp_corner`, `narrow`, `curvature`, `optimised` or `unfinished`.
    pub why: &'static str,
}

/// The mesh beside the curved surface that it stands for. All nodes lie on the surface.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct SurfaceFit {
    /// `flattened`: laid into the plane, meshed there and carried back. `on_surface`: meshed on the surface itself,
    /// because it cannot be laid into the plane with a bounded distortion.
    pub method: &'static str,
    /// The surface's own area.
    pub area: f64,
    /// The mesh's area less the surface's, relative to the surface's.
    pub area_error: f64,
    /// Largest distance from the middle of a triangle to the surface.
    pub distance_max: f64,
    /// Largest angle between the normals of a triangle and of the surface below its middle.
    pub normal_deviation_max_deg: f64,
}

impl From<geometry::SurfaceFit> for SurfaceFit {
    fn from(fit: geometry::SurfaceFit) -> Self {
        Self {
            method: fit.method.name(),
            area: fit.area,
            area_error: fit.area_error,
            distance_max: fit.distance_max,
            normal_deviation_max_deg: fit.normal_deviation_max.to_degrees(),
        }
    }
}

/// Statistics of a uniform mesh. Lengths are in the request's unit, and angles are in degrees.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct UniformStatistics {
    /// Middle of the mesh's bounding box, which files with `origin=local` are relative to.
    pub origin: Point,
    pub objective: &'static str,
    /// Number of nodes for `fewest_nodes`, and number of lattice edges for `most_equal_edges`.
    pub objective_value: usize,
    pub nodes: usize,
    pub triangles: usize,
    pub edges: usize,
    pub edge_lengths: Spread,
    /// Lengths of the members of the lattice.
    pub lattice_edges: GroupLengths,
    /// Number of members within the tolerance of the edge length.
    pub equal_edges: usize,
    pub distinct_lengths: usize,
    /// Tolerance of `equal_edges` and `distinct_lengths`.
    pub length_tolerance: f64,
    pub out_of_range_edges: usize,
    /// Number of members that are out of range, for each reason.
    pub out_of_range_reasons: BTreeMap<&'static str, usize>,
    /// The first 200 members that are out of range.
    pub out_of_range: Vec<OutOfRange>,
    /// Pairs of triangles that cross, touch or overlap beyond the vertices and edges that they share; 0 for an embedded
    /// mesh. Null if not all pairs were looked at.
    pub self_intersections: Option<u64>,
    /// Why `self_intersections` is null: `too_many_triangles`, `too_many_pairs`, `deadline_passed`.
    pub self_intersections_skipped: Option<&'static str>,
    /// False if the deadline cut the work short, or if the surface is curved too strongly for this edge length: the
    /// area is off by more than 1%, a triangle faces away, or edges or angles are far out of range. `not_converged`
    /// says by how much.
    pub converged: bool,
    /// Curved domains: the mesh beside its surface. Null for polygons.
    pub surface: Option<SurfaceFit>,
    pub angles_deg: AngleRange,
    pub length_histogram: geometry::statistics::LengthHistogram,
    /// Entry k is the number of nodes with k members.
    pub valence_histogram: Vec<usize>,
    /// For polygons, a lower bound of the number of nodes of any mesh with members of at most twice the edge length.
    /// Null for curved domains.
    pub node_lower_bound: Option<usize>,
    /// Rows of Katoh, Ohsaki and Xu's Table 1, stage by stage.
    pub stages: Vec<Stage>,
    /// With `optimise: lengths`, the deviation for each number of lengths that was tried.
    pub shared_lengths: Vec<geometry::LengthsRow>,
}

impl UniformStatistics {
    #[must_use]
    pub(crate) fn of(
        mesh: &geometry::UniformMesh,
        options: &geometry::Options,
        crossings: Crossings,
        origin: Point,
    ) -> Self {
        let statistics = &mesh.statistics;
        let mut reasons = BTreeMap::new();
        for edge in &mesh.out_of_range {
            *reasons.entry(edge.why.name()).or_default() += 1;
        }
        let listed = mesh.out_of_range.iter().take(LISTED_EDGES).map(|edge| OutOfRange {
            vertices: mesh.members[edge.member],
            length: edge.length,
            why: edge.why.name(),
        });
        let stage = |stage: &geometry::statistics::Stage| Stage {
            name: stage.name,
            all: stage.all.into(),
            lattice: stage.lattice.map(Into::into),
        };
        Self {
            origin,
            objective: options.objective.name(),
            objective_value: statistics.objective_value,
            nodes: statistics.nodes,
            triangles: statistics.triangles,
            edges: statistics.edges,
            edge_lengths: statistics.edge_lengths,
            lattice_edges: statistics.lattice_edges.into(),
            equal_edges: statistics.equal_edges,
            distinct_lengths: statistics.distinct_lengths,
            length_tolerance: statistics.length_tolerance,
            out_of_range_edges: statistics.out_of_range_edges,
            out_of_range_reasons: reasons,
            out_of_range: listed.collect(),
            self_intersections: crossings.pairs,
            self_intersections_skipped: crossings.skipped,
            converged: mesh.converged,
            surface: statistics.surface.map(Into::into),
            angles_deg: AngleRange::of_radians(statistics.angles),
            length_histogram: statistics.length_histogram.clone(),
            valence_histogram: statistics.valence_histogram.clone(),
            node_lower_bound: statistics.node_lower_bound,
            stages: mesh.stages.iter().map(stage).collect(),
            shared_lengths: mesh.shared_lengths.clone(),
        }
    }
}
