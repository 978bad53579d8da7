//! `POST /v1/uniform-meshes`: the request, its statistics, and their conversion to and from the geometry's types.

use super::common::{self, JobFields, Point};
use super::minimal_surface::{AngleRange, Spread};
use super::objectives::Objective as ObjectiveDoc;
use super::{Checked, FieldError, Kind, KindRequest, Problem, Rejection};
use crate::config::LimitsConfig;
use plateau_archive::units::{Unit, UpAxis};
use plateau_mesh::self_intersections::Skipped;
use plateau_uniform_mesh as geometry;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// Number of members outside [ℓ, 2ℓ] that are listed individually. `out_of_range_edges` counts all of them.
const LISTED_EDGES: usize = 200;

/// A domain and the edge length of its mesh.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UniformMeshRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default)]
    pub kind: Option<UniformMeshKind>,
    #[serde(flatten)]
    pub job: JobFields,
    /// Unit of the coordinates.
    #[serde(default)]
    pub units: Unit,
    /// Axis that points up.
    #[serde(default)]
    pub up: UpAxis,
    pub domain: Domain,
    /// Edge length ℓ in the request's unit: the length of as many members as possible, and the smallest length of all
    /// members.
    #[schemars(range(max = 1e15), extend("exclusiveMinimum" = 0))]
    pub edge_length: f64,
    #[serde(default)]
    pub objective: Objective,
    /// Whether the inner nodes of a curved domain move on the surface after meshing.
    #[serde(default = "yes")]
    pub optimise_nodes: bool,
    /// Aim of moving the nodes.
    #[serde(default)]
    pub optimise: Optimise,
    /// Largest number of different member lengths. It is used only with `optimise: lengths`.
    #[serde(default)]
    #[schemars(range(min = 1, max = 1000))]
    pub max_distinct_lengths: Option<u32>,
    /// Largest difference between lengths that count as equal, in the request's unit. Null means a thousandth of the
    /// edge length.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1e15))]
    pub length_tolerance: Option<f64>,
    /// Lengths that members outside the lattice group may take while the nodes move.
    #[serde(default)]
    pub rim: Rim,
    /// Number of rectangles along u and v in the auxiliary triangulation of a patch.
    #[serde(default = "default_auxiliary_grid")]
    #[schemars(inner(range(min = 2, max = 400)))]
    pub auxiliary_grid: [u32; 2],
}

fn yes() -> bool {
    true
}

fn default_auxiliary_grid() -> [u32; 2] {
    [15, 15]
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum UniformMeshKind {
    UniformMesh,
}

/// Domain of the mesh: exactly one of `polygon` (with or without `holes`), `bezier`, `nurbs` and `boundaries`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 2))]
pub struct Domain {
    /// A planar polygon in space that does not repeat its first point. If its points or those of its holes are off the
    /// plane by more than rounding, but by at most a thousandth of its size, they are projected onto it, with the warning
    /// `projected`.
    #[serde(default)]
    #[schemars(with = "Vec<Point>", length(min = 3))]
    pub polygon: Option<Vec<Point>>,
    /// Holes of the polygon.
    #[serde(default)]
    #[schemars(inner(length(min = 3)))]
    pub holes: Vec<Vec<Point>>,
    #[serde(default)]
    #[schemars(with = "Bezier")]
    pub bezier: Option<Bezier>,
    #[serde(default)]
    #[schemars(with = "Nurbs")]
    pub nurbs: Option<Nurbs>,
    /// Closed polygons. The domain is the minimal surface that spans them.
    #[serde(default)]
    #[schemars(with = "Vec<Vec<Point>>", length(min = 1), inner(length(min = 3)))]
    pub boundaries: Option<Vec<Vec<Point>>>,
}

/// A tensor-product Bézier patch.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bezier {
    /// Control points: rows along u, each with the points along v.
    #[schemars(length(min = 2), inner(length(min = 2)))]
    pub control_points: Vec<Vec<Point>>,
}

/// A NURBS patch.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Nurbs {
    /// Degrees along u and along v.
    #[schemars(inner(range(min = 1, max = 60)))]
    pub degrees: [u32; 2],
    /// Knots along u and along v: control points + degree + 1 each, in non-decreasing order.
    pub knots: [Vec<f64>; 2],
    /// Control points: rows along u, each with the points along v.
    #[schemars(length(min = 2), inner(length(min = 2)))]
    pub control_points: Vec<Vec<Point>>,
    /// Weights in the shape of the control points. Null means equal weights.
    #[serde(default)]
    pub weights: Option<Vec<Vec<f64>>>,
    /// Trimmed patches are not supported, so only null or an empty list is accepted.
    #[serde(default)]
    pub trim_curves: Option<Vec<Value>>,
}

/// Quantity that is optimised. `GET /v1/objectives` has the formulas.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[schemars(rename = "UniformMeshObjective")]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    /// As few nodes as possible.
    FewestNodes,
    /// As many members of the edge length as possible.
    #[default]
    MostEqualEdges,
}

/// `nodes` brings the members of the lattice as near to the edge length as possible. `lengths` then also reduces all
/// members to at most `max_distinct_lengths` lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Optimise {
    #[default]
    Nodes,
    Lengths,
}

/// `bounded` keeps the members between the edge length and its double wherever possible. `free` does not limit them, as
/// in the paper.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Rim {
    #[default]
    Bounded,
    Free,
}

impl Domain {
    /// Returns the number of points, and the field for an error if there are too many.
    fn point_count(&self) -> (usize, &'static str) {
        let count = |rows: &[Vec<Point>]| rows.iter().map(Vec::len).sum::<usize>();
        match self {
            Self { polygon: Some(polygon), .. } => (polygon.len() + count(&self.holes), "/domain/polygon"),
            Self { bezier: Some(patch), .. } => (count(&patch.control_points), "/domain/bezier/control_points"),
            Self { nurbs: Some(patch), .. } => (count(&patch.control_points), "/domain/nurbs/control_points"),
            Self { boundaries, .. } => (count(boundaries.as_deref().unwrap_or_default()), "/domain/boundaries"),
        }
    }

    fn check(&self) -> Result<(), Rejection> {
        let given = [
            ("polygon", self.polygon.is_some()),
            ("bezier", self.bezier.is_some()),
            ("nurbs", self.nurbs.is_some()),
            ("boundaries", self.boundaries.is_some()),
        ];
        let names = given.map(|(name, _)| name).join(", ");
        let invalid = |pointer: &str, detail: String| Err(Rejection::Invalid(vec![FieldError::new(pointer, detail)]));
        if given.iter().filter(|(_, given)| *given).count() != 1 {
            return invalid("/domain", format!("must have exactly one of the members {names}"));
        }
        if self.polygon.is_none() && !self.holes.is_empty() {
            return invalid("/domain/holes", "is only allowed with a polygon".into());
        }
        if self.nurbs.as_ref().and_then(|patch| patch.trim_curves.as_ref()).is_some_and(|curves| !curves.is_empty()) {
            let detail = "trimmed patches are not supported: split the patch along its parameter lines, or give its outline \
                as `boundaries`";
            return invalid("/domain/nurbs/trim_curves", detail.into());
        }
        Ok(())
    }

    fn to_geometry(&self) -> geometry::Domain {
        match self {
            Self { polygon: Some(polygon), holes, .. } => {
                geometry::Domain::Polygon { outer: common::points(polygon), holes: common::polylines(holes) }
            }
            Self { bezier: Some(patch), .. } => {
                geometry::Domain::Bezier { control_points: common::polylines(&patch.control_points) }
            }
            Self { nurbs: Some(patch), .. } => geometry::Domain::Nurbs(geometry::Nurbs {
                degrees: patch.degrees.map(|degree| degree as usize),
                knots: patch.knots.clone(),
                control_points: common::polylines(&patch.control_points),
                weights: patch.weights.clone(),
            }),
            Self { boundaries, .. } => {
                geometry::Domain::Boundaries(common::polylines(boundaries.as_deref().unwrap_or_default()))
            }
        }
    }
}

impl KindRequest for UniformMeshRequest {
    fn job(&self) -> &JobFields {
        &self.job
    }

    fn axes(&self) -> (Unit, UpAxis) {
        (self.units, self.up)
    }

    fn check(&self, limits: &LimitsConfig) -> Result<Checked, Rejection> {
        self.domain.check()?;
        let (points, field) = self.domain.point_count();
        common::check_count(field, points, limits.points, "points")?;
        let invalid = |pointer: &str, detail: &str| Err(Rejection::Invalid(vec![FieldError::new(pointer, detail)]));
        if self.optimise == Optimise::Lengths && !self.optimise_nodes {
            return invalid(
                "/optimise_nodes",
                "must be true with `optimise: lengths`, because lengths are optimised by moving nodes",
            );
        }
        match (self.optimise, self.max_distinct_lengths) {
            (Optimise::Lengths, None) => {
                return invalid("/max_distinct_lengths", "is required with `optimise: lengths`");
            }
            (Optimise::Nodes, Some(_)) => {
                return invalid("/max_distinct_lengths", "is only allowed with `optimise: lengths`");
            }
            _ => {}
        }
        let (domain, options) = self.to_geometry();
        let estimate = geometry::estimate(&domain, &options)?;
        if estimate.triangles > limits.triangles as f64 {
            let detail = format!(
                "asks for up to {:.0} triangles, more than this server allows ({}); see GET /v1/limits",
                estimate.triangles, limits.triangles
            );
            return Err(Rejection::TooLarge(vec![FieldError::new("/edge_length", detail)]));
        }
        geometry::check(&domain, &options)?;
        Ok(Checked { memory_bytes: estimate.bytes, quick: false, problem: Problem::UniformMesh { domain, options } })
    }
}

impl UniformMeshRequest {
    /// Converts the request to the geometry's types.
    fn to_geometry(&self) -> (geometry::Domain, geometry::Options) {
        let optimise = match (self.optimise_nodes, self.optimise, self.max_distinct_lengths) {
            (false, ..) => geometry::Optimise::None,
            (true, Optimise::Lengths, Some(most)) => geometry::Optimise::Lengths { most: most as usize },
            (true, ..) => geometry::Optimise::Nodes,
        };
        let options = geometry::Options {
            edge_length: self.edge_length,
            objective: match self.objective {
                Objective::FewestNodes => geometry::Objective::FewestNodes,
                Objective::MostEqualEdges => geometry::Objective::MostEqualEdges,
            },
            length_tolerance: self.length_tolerance,
            optimise,
            transition: match self.rim {
                Rim::Bounded => geometry::Transition::Bounded,
                Rim::Free => geometry::Transition::Free,
            },
            auxiliary_grid: self.auxiliary_grid,
        };
        (self.domain.to_geometry(), options)
    }
}

/// Returns the vertices that the points of each polyline of a polygon became. The list is empty for other domains,
/// because their points are not nodes.
#[must_use]
pub fn input_vertices(domain: &geometry::Domain, mesh: &geometry::UniformMesh) -> Vec<Vec<u32>> {
    let geometry::Domain::Polygon { outer, holes } = domain else { return Vec::new() };
    let mut vertices = mesh.input_vertices.iter().copied().flatten();
    let lengths = std::iter::once(outer.len()).chain(holes.iter().map(Vec::len));
    lengths.map(|length| vertices.by_ref().take(length).collect()).collect()
}

/// Returns the objectives of this kind.
#[must_use]
pub fn objectives() -> Vec<ObjectiveDoc> {
    geometry::Objective::ALL
        .iter()
        .map(|objective| ObjectiveDoc {
            name: objective.name(),
            kind: Kind::UniformMesh,
            minimises: objective.description(),
            unit: objective.unit(),
            source: objective.source(),
            options: vec![
                "edge_length",
                "optimise_nodes",
                "optimise",
                "max_distinct_lengths",
                "length_tolerance",
                "rim",
                "auxiliary_grid",
            ],
        })
        .collect()
}

/// Count, minimum, mean, maximum and standard deviation of a group of lengths. All are 0 for an empty group.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct GroupLengths {
    pub count: usize,
    pub min: f64,
    pub mean: f64,
    pub max: f64,
    pub std_dev: f64,
}

impl From<plateau_mesh::measure::Spread> for GroupLengths {
    fn from(spread: plateau_mesh::measure::Spread) -> Self {
        let Spread { min, mean, max, std_dev } = spread.into();
        Self { count: spread.count, min, mean, max, std_dev }
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

/// Histogram of lengths. Bin k counts lengths from `from` + k · `width` up to the next bin.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct LengthHistogram {
    pub from: f64,
    pub width: f64,
    pub counts: Vec<usize>,
}

/// Deviation of the members for one number of distinct lengths.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct SharedLengths {
    pub lengths: usize,
    /// Largest difference between a member's length and the shared length that replaces it.
    pub deviation: f64,
    /// The same difference before the nodes moved.
    pub deviation_before: f64,
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
    /// `flattened`: laid into the plane, meshed there and carried back. `on_surface`: meshed on the surface itself, because
    /// it cannot be laid into the plane with a bounded distortion.
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
    /// Pairs of triangles that cross, touch or overlap beyond the vertices and edges that they share; 0 for an embedded mesh.
    /// Null if not all pairs were looked at.
    pub self_intersections: Option<u64>,
    /// Why `self_intersections` is null: `too_many_triangles`, `too_many_pairs`, `deadline_passed`.
    pub self_intersections_skipped: Option<&'static str>,
    /// False if the deadline cut the work short, or if the surface is curved too strongly for this edge length: the area is
    /// off by more than 1%, a triangle faces away, or edges or angles are far out of range. `not_converged` says by how much.
    pub converged: bool,
    /// Curved domains: the mesh beside its surface. Null for polygons.
    pub surface: Option<SurfaceFit>,
    pub angles_deg: AngleRange,
    pub length_histogram: LengthHistogram,
    /// Entry k is the number of nodes with k members.
    pub valence_histogram: Vec<usize>,
    /// For polygons, a lower bound of the number of nodes of any mesh with members of at most twice the edge length.
    /// Null for curved domains.
    pub node_lower_bound: Option<usize>,
    /// Rows of Katoh, Ohsaki and Xu's Table 1, stage by stage.
    pub stages: Vec<Stage>,
    /// With `optimise: lengths`, the deviation for each number of lengths that was tried.
    pub shared_lengths: Vec<SharedLengths>,
}

impl UniformStatistics {
    #[must_use]
    pub fn of(mesh: &geometry::UniformMesh, options: &geometry::Options, origin: Point) -> Self {
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
        let shared = |row: &geometry::LengthsRow| SharedLengths {
            lengths: row.lengths,
            deviation: row.deviation,
            deviation_before: row.deviation_before,
        };
        Self {
            origin,
            objective: options.objective.name(),
            objective_value: statistics.objective_value,
            nodes: statistics.nodes,
            triangles: statistics.triangles,
            edges: statistics.edges,
            edge_lengths: statistics.edge_lengths.into(),
            lattice_edges: statistics.lattice_edges.into(),
            equal_edges: statistics.equal_edges,
            distinct_lengths: statistics.distinct_lengths,
            length_tolerance: statistics.length_tolerance,
            out_of_range_edges: statistics.out_of_range_edges,
            out_of_range_reasons: reasons,
            out_of_range: listed.collect(),
            self_intersections: statistics.self_intersections.pairs,
            self_intersections_skipped: statistics.self_intersections.skipped.map(Skipped::name),
            converged: mesh.converged,
            surface: statistics.surface.map(Into::into),
            angles_deg: AngleRange { min: statistics.angles.0.to_degrees(), max: statistics.angles.1.to_degrees() },
            length_histogram: LengthHistogram {
                from: statistics.length_histogram.from,
                width: statistics.length_histogram.width,
                counts: statistics.length_histogram.counts.clone(),
            },
            valence_histogram: statistics.valence_histogram.clone(),
            node_lower_bound: statistics.node_lower_bound,
            stages: mesh.stages.iter().map(stage).collect(),
            shared_lengths: mesh.shared_lengths.iter().map(shared).collect(),
        }
    }
}
