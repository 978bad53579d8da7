//! `POST /v1/uniform-meshes`: the request, its statistics, and the way to the geometry and back.

use super::common::{self, Cache, Point};
use super::minimal_surface::{AngleRange, Spread};
use super::objectives::Objective as ObjectiveDoc;
use super::{Checked, FieldError, Kind, Problem, Rejection};
use crate::config::LimitsConfig;
use crate::units::{Unit, UpAxis};
use plateau_geometry::uniform_mesh as geometry;
use plateau_geometry::uniform_mesh::parametric_surface;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// Edges outside [ℓ, 2ℓ] that are listed one by one; `out_of_range_edges` counts them all.
const LISTED_EDGES: usize = 200;

/// A domain, and the edge length of its mesh.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UniformMeshRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default)]
    pub kind: Option<UniformMeshKind>,
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
    pub domain: Domain,
    /// ℓ: the length of as many members as possible, and the least length of all, in the request's unit.
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
    /// With `optimise: lengths`: how many lengths may stand for all members.
    #[serde(default)]
    #[schemars(range(min = 1, max = 1000))]
    pub max_distinct_lengths: Option<u32>,
    /// Lengths that differ by no more are equal, in the request's unit; null: a thousandth of the edge length.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1e15))]
    pub length_tolerance: Option<f64>,
    /// What the members outside the lattice group may do while nodes move.
    #[serde(default)]
    pub rim: Rim,
    /// Rectangles along u and v of the auxiliary triangulation of a patch.
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

/// What to mesh: exactly one of `polygon` (with or without `holes`), `bezier`, `nurbs`, `boundaries`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 2))]
pub struct Domain {
    /// A planar polygon in space that does not repeat its first point.
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
    /// Closed polygons; the domain is the minimal surface that spans them.
    #[serde(default)]
    #[schemars(with = "Vec<Vec<Point>>", length(min = 1), inner(length(min = 3)))]
    pub boundaries: Option<Vec<Vec<Point>>>,
}

/// A tensor-product Bézier patch.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bezier {
    /// Rows along u of points along v.
    #[schemars(length(min = 2), inner(length(min = 2)))]
    pub control_points: Vec<Vec<Point>>,
}

/// A NURBS patch.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Nurbs {
    /// Along u and along v.
    #[schemars(inner(range(min = 1, max = 60)))]
    pub degrees: [u32; 2],
    /// Along u and along v: control points + degree + 1 each, not falling.
    pub knots: [Vec<f64>; 2],
    /// Rows along u of points along v.
    #[schemars(length(min = 2), inner(length(min = 2)))]
    pub control_points: Vec<Vec<Point>>,
    /// In the shape of the control points; null: all equal.
    #[serde(default)]
    pub weights: Option<Vec<Vec<f64>>>,
    /// Trimmed patches are not offered: only null or an empty list is taken.
    #[serde(default)]
    pub trim_curves: Option<Vec<Value>>,
}

/// Quantity that is optimised. `GET /v1/objectives` has the formulas.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    /// As few nodes as possible.
    FewestNodes,
    /// As many members of the edge length as possible.
    #[default]
    MostEqualEdges,
}

/// `nodes`: members of the lattice as near to the edge length as they get. `lengths`: after that, at most
/// `max_distinct_lengths` lengths for all members.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Optimise {
    #[default]
    Nodes,
    Lengths,
}

/// `bounded`: they stay between the edge length and its double wherever that is possible. `free`: as in the paper.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Rim {
    #[default]
    Bounded,
    Free,
}

impl Domain {
    /// How many points it has in all, and where to complain if there are too many.
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
            return invalid("/domain", format!("needs exactly one of: {names}"));
        }
        if self.polygon.is_none() && !self.holes.is_empty() {
            return invalid("/domain/holes", "only a polygon has holes".into());
        }
        if self.nurbs.as_ref().and_then(|patch| patch.trim_curves.as_ref()).is_some_and(|curves| !curves.is_empty()) {
            let detail = "trimmed patches are not offered: split the patch along its parameter lines, or give its outline \
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
            Self { nurbs: Some(patch), .. } => geometry::Domain::Nurbs(parametric_surface::Nurbs {
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

impl UniformMeshRequest {
    /// Checks what the schema cannot say, and returns the request in the geometry's terms.
    ///
    /// # Errors
    /// Every offending value.
    pub(super) fn check(&self, limits: &LimitsConfig) -> Result<Checked, Rejection> {
        self.domain.check()?;
        let (points, field) = self.domain.point_count();
        if points > limits.points {
            let detail = format!("has more points than this server takes ({}); see GET /v1/limits", limits.points);
            return Err(Rejection::TooLarge(vec![FieldError::new(field, detail)]));
        }
        let invalid = |pointer: &str, detail: &str| Err(Rejection::Invalid(vec![FieldError::new(pointer, detail)]));
        if self.optimise == Optimise::Lengths && !self.optimise_nodes {
            return invalid("/optimise_nodes", "must be true where lengths are to be optimised: it is nodes that move");
        }
        match (self.optimise, self.max_distinct_lengths) {
            (Optimise::Lengths, None) => {
                return invalid("/max_distinct_lengths", "is required with `optimise: lengths`");
            }
            (Optimise::Nodes, Some(_)) => {
                return invalid("/max_distinct_lengths", "means something with `optimise: lengths` only");
            }
            _ => {}
        }
        let (domain, options) = self.to_geometry();
        let estimate = geometry::estimate(&domain, &options)?.triangles;
        if estimate > limits.triangles as f64 {
            let detail = format!(
                "asks for up to {estimate:.0} triangles, more than this server makes ({}); see GET /v1/limits",
                limits.triangles
            );
            return Err(Rejection::TooLarge(vec![FieldError::new("/edge_length", detail)]));
        }
        geometry::check(&domain, &options)?;
        Ok(Checked {
            memory_bytes: self.memory_bytes(estimate),
            quick: false,
            problem: Problem::UniformMesh { domain, options },
        })
    }

    /// The geometry's own terms for this request.
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
            rim: match self.rim {
                Rim::Bounded => geometry::Rim::Bounded,
                Rim::Free => geometry::Rim::Free,
            },
            auxiliary_grid: self.auxiliary_grid,
        };
        (self.domain.to_geometry(), options)
    }

    /// About how much memory solving takes: a triangle costs some 600 bytes with its members, their lengths and the archive,
    /// and on a surface as much again for the sparse factor; a film's own mesh is bounded.
    fn memory_bytes(&self, triangles: f64) -> u64 {
        let a_triangle = if self.domain.polygon.is_some() { 600.0 } else { 1500.0 };
        (triangles * a_triangle) as u64 + (64 << 20)
    }
}

/// For each polyline of a polygon the vertices that its points became; empty for other domains, whose points are not
/// nodes.
#[must_use]
pub fn input_vertices(domain: &geometry::Domain, mesh: &geometry::UniformMesh) -> Vec<Vec<u32>> {
    let geometry::Domain::Polygon { outer, holes } = domain else { return Vec::new() };
    let mut vertices = mesh.input_vertices.iter().copied().flatten();
    let lengths = std::iter::once(outer.len()).chain(holes.iter().map(Vec::len));
    lengths.map(|length| vertices.by_ref().take(length).collect()).collect()
}

/// The objectives of this kind.
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

/// Count, minimum, mean, maximum and standard deviation of a group of lengths; zeros for an empty one.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct GroupLengths {
    pub count: usize,
    pub min: f64,
    pub mean: f64,
    pub max: f64,
    pub std_dev: f64,
}

impl From<plateau_geometry::mesh::measure::Spread> for GroupLengths {
    fn from(spread: plateau_geometry::mesh::measure::Spread) -> Self {
        let Spread { min, mean, max, std_dev } = spread.into();
        Self { count: spread.count, min, mean, max, std_dev }
    }
}

/// One group of members at one stage.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct StageGroup {
    #[serde(flatten)]
    pub lengths: GroupLengths,
    /// Members within the tolerance of the edge length.
    pub equal_edges: usize,
    /// The least number of lengths for all of them, those of one kind differing by at most the tolerance.
    pub distinct_lengths: usize,
}

impl From<geometry::statistics::Group> for StageGroup {
    fn from(group: geometry::statistics::Group) -> Self {
        Self { lengths: group.lengths.into(), equal_edges: group.equal_edges, distinct_lengths: group.distinct_lengths }
    }
}

/// A row pair of Katoh, Ohsaki and Xu's Table 1.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Stage {
    /// `auxiliary_surface`, `auxiliary_plane`, `plane`, `surface`, `optimised_nodes` or `shared_lengths`.
    pub name: &'static str,
    pub all: StageGroup,
    /// Null for the auxiliary triangulation.
    pub lattice: Option<StageGroup>,
}

/// Bin k counts lengths from `from + k width` up to the next.
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
    /// Largest difference between a member and the length that stands for it.
    pub deviation: f64,
    /// Largest difference before the nodes moved.
    pub deviation_before: f64,
}

/// A member outside the range from the edge length to its double.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct OutOfRange {
    pub vertices: [u32; 2],
    pub length: f64,
    /// `short_side`, `sharp_corner`, `narrow`, `curvature`, `optimised` or `unfinished`.
    pub why: &'static str,
}

/// Statistics of a uniform mesh. Lengths in the request's unit, angles in degrees.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct UniformStatistics {
    pub objective: &'static str,
    /// Nodes for `fewest_nodes`, lattice edges for `most_equal_edges`.
    pub objective_value: usize,
    pub nodes: usize,
    pub triangles: usize,
    pub edges: usize,
    pub edge_lengths: Spread,
    /// Members of the lattice.
    pub lattice_edges: GroupLengths,
    /// Members within the tolerance of the edge length.
    pub equal_edges: usize,
    pub distinct_lengths: usize,
    /// Tolerance of `equal_edges` and `distinct_lengths`.
    pub length_tolerance: f64,
    pub out_of_range_edges: usize,
    /// Number of members that are out of range, for each reason.
    pub out_of_range_reasons: BTreeMap<&'static str, usize>,
    /// The first 200 members that are out of range.
    pub out_of_range: Vec<OutOfRange>,
    pub converged: bool,
    pub angles_deg: AngleRange,
    pub length_histogram: LengthHistogram,
    /// Entry k is the number of nodes with k members.
    pub valence_histogram: Vec<usize>,
    /// Polygons: no mesh with members of at most twice the edge length has fewer nodes. Null for curved domains.
    pub node_lower_bound: Option<usize>,
    /// Rows of Katoh, Ohsaki and Xu's Table 1, stage by stage.
    pub stages: Vec<Stage>,
    /// With `optimise: lengths`: deviation against the number of lengths, as far as it was tried.
    pub shared_lengths: Vec<SharedLengths>,
}

impl UniformStatistics {
    #[must_use]
    pub fn of(mesh: &geometry::UniformMesh, options: &geometry::Options) -> Self {
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
        let shared = |row: &geometry::lengths::LengthsRow| SharedLengths {
            lengths: row.lengths,
            deviation: row.deviation,
            deviation_before: row.deviation_before,
        };
        Self {
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
            converged: mesh.converged,
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
