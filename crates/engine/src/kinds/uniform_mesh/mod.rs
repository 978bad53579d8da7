//! Uniform meshes: the request, its statistics, and their conversion to and from the geometry's types.

mod audit;
mod solve;
mod statistics;

pub use statistics::{GroupLengths, OutOfRange, Stage, StageGroup, SurfaceFit, UniformStatistics};

use crate::blocks::{self, Block, Input, Output, Part, Preset, Type};
use crate::checked::{Checked, KindRequest, Types};
use crate::common::{self, Point, count};
use crate::kind::{Entry, Kind, Objective as ObjectiveDoc, Units};
use crate::limits::{self, Limits};
use crate::options::{Optioned, RequestOption, when};
use plateau_archive::units::{Unit, UpAxis};
use plateau_strict_json::bounds::{Length, List, Tolerance, Whole, given, is_default, unwritten, yes};
use plateau_strict_json::rejection::{FieldError, Rejection};
use plateau_uniform_mesh as geometry;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

pub const KIND: Kind = Kind::of(&ENTRY);

static ENTRY: Entry = Entry {
    name: "uniform_mesh",
    path: "/v1/uniform-meshes",
    summary: "Finds a mesh of a polygon, patch or film with as many equal edges as possible",
    finds: "meshes of surfaces and polygons with as many equal edges as possible",
    units: Units::Length,
    blocks: &[Block {
        name: "uniform-mesh",
        title: "Uniform Mesh",
        description: "Mesh with as many equal edges as possible, of a planar region or of the \
                      minimal surface in closed curves.",
        inputs: &[
            Input::list(
                "Boundaries",
                "B",
                Type::Curve,
                1,
                "Closed curves: an outline and its holes in one plane or, with Film, the boundaries of a minimal \
                 surface.",
            ),
            Input::required("Edge Length", "L", Type::Number, "Length of as many edges as possible.")
                .to("/edge_length"),
            Input::optional(
                "Film",
                "F",
                Preset::Boolean(false),
                "Whether the minimal surface in the curves is meshed.",
            ),
            Input::optional("Objective", "O", Preset::Text("most_equal_edges"), "most_equal_edges or fewest_nodes.")
                .to("/objective"),
            Input::optional(
                "Lengths",
                "N",
                Preset::Integer(0),
                "Largest number of different member lengths. 0 sets no limit.",
            ),
        ],
    }],
    outputs: &[
        blocks::MESH,
        // The statistics of a uniform mesh have no area.
        Output::part(Part::Area, "Area", "A", Type::Number, "Area of the mesh."),
        Output::part(Part::Members, "Members", "E", Type::Curve, "Edges of the mesh, those of the lattice first."),
        Output::part(Part::MemberLengths, "Member Lengths", "L", Type::Number, "Length of each member."),
        Output::figure("/equal_edges", "Equal Edges", "N", Type::Integer, "Number of members of the edge length."),
    ],
    objectives,
    types: Types::of::<UniformMeshRequest>(),
};

/// A domain and the edge length of its mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UniformMeshRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default, skip_serializing_if = "unwritten")]
    pub kind: Option<UniformMeshKind>,
    /// Unit of the coordinates.
    #[serde(default)]
    pub units: Unit,
    /// Axis that points up.
    #[serde(default)]
    pub up: UpAxis,
    pub domain: Domain,
    /// Edge length ℓ in the request's unit: the length of as many members as possible, and the smallest length of all
    /// members.
    pub edge_length: Length,
    #[serde(default, skip_serializing_if = "is_default")]
    pub objective: geometry::Objective,
    /// Whether the inner nodes of a curved domain move on the surface after meshing.
    #[serde(default = "yes", skip_serializing_if = "Clone::clone")]
    #[schemars(extend("default" = true))]
    pub optimise_nodes: bool,
    /// Aim of moving the nodes.
    #[serde(default, skip_serializing_if = "is_default")]
    pub optimise: Optimise,
    /// Largest number of different member lengths. It is used only with `optimise: lengths`.
    #[serde(default)]
    pub max_distinct_lengths: Option<Whole<1, 1000>>,
    /// Largest difference between lengths that count as equal, in the request's unit. Null means a thousandth of the
    /// edge length.
    #[serde(default)]
    pub length_tolerance: Option<Tolerance>,
    /// Lengths that members outside the lattice group may take while the nodes move.
    #[serde(default, skip_serializing_if = "is_default")]
    pub rim: geometry::Transition,
    /// Number of rectangles along u and v in the auxiliary triangulation of a patch.
    #[serde(default = "default_auxiliary_grid", skip_serializing_if = "is_default_auxiliary_grid")]
    #[schemars(extend("default" = [15, 15]))]
    pub auxiliary_grid: [Whole<2, 400>; 2],
}

fn default_auxiliary_grid() -> [Whole<2, 400>; 2] {
    [Whole::new(15); 2]
}

fn is_default_auxiliary_grid(grid: &[Whole<2, 400>; 2]) -> bool {
    *grid == default_auxiliary_grid()
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum UniformMeshKind {
    UniformMesh,
}

/// Domain of the mesh: exactly one of `polygon` (with or without `holes`), `bezier`, `nurbs` and `boundaries`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 2))]
pub struct Domain {
    /// A planar polygon in space that does not repeat its first point. If its points or those of its holes are off the
    /// plane by more than rounding, but by at most a thousandth of its size, they are projected onto it, with the
    /// warning `projected`.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "List<Point, 3>")]
    pub polygon: Option<List<Point, 3>>,
    /// Holes of the polygon.
    #[serde(default)]
    pub holes: Vec<List<Point, 3>>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Bezier")]
    pub bezier: Option<Bezier>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Nurbs")]
    pub nurbs: Option<Nurbs>,
    /// Closed polygons. The domain is the minimal surface that spans them.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "List<List<Point, 3>, 1>")]
    pub boundaries: Option<List<List<Point, 3>, 1>>,
}

/// A tensor-product Bézier patch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bezier {
    /// Control points: `control_points[i][j]`, where i counts along u and j along v.
    pub control_points: List<List<Point, 2>, 2>,
}

/// A NURBS patch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Nurbs {
    /// Degrees along u and along v.
    pub degrees: [Whole<1, 60>; 2],
    /// Knots along u and along v: control points + degree + 1 each, in non-decreasing order.
    pub knots: [Vec<f64>; 2],
    /// Control points: `control_points[i][j]`, where i counts along u and j along v.
    pub control_points: List<List<Point, 2>, 2>,
    /// Weights in the shape of the control points. Null means equal weights.
    #[serde(default)]
    pub weights: Option<Vec<Vec<f64>>>,
    /// Trimmed patches are not supported, so only null or an empty list is accepted.
    #[serde(default)]
    pub trim_curves: Option<Vec<Value>>,
}

/// `nodes` brings the members of the lattice as near to the edge length as possible. `lengths` then also lowers the
/// number of different lengths, until `max_distinct_lengths` are met within `length_tolerance`. Neither that number nor
/// the number of members outside the range gets larger, and exact members of the lattice stay exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Optimise {
    #[default]
    Nodes,
    Lengths,
}

impl Domain {
    /// Returns the name of the member that gives the domain, or an empty text if there is not exactly one.
    fn name(&self) -> &'static str {
        match (&self.polygon, &self.bezier, &self.nurbs, &self.boundaries) {
            (Some(_), None, None, None) => "polygon",
            (None, Some(_), None, None) => "bezier",
            (None, None, Some(_), None) => "nurbs",
            (None, None, None, Some(_)) => "boundaries",
            _ => "",
        }
    }

    /// Returns the number of points, and the JSON Pointer for an error about too many points.
    fn point_count(&self) -> (usize, &'static str) {
        match self {
            Self { polygon: Some(polygon), .. } => (polygon.len() + count(&self.holes), "/domain/polygon"),
            Self { bezier: Some(patch), .. } => (count(&patch.control_points), "/domain/bezier/control_points"),
            Self { nurbs: Some(patch), .. } => (count(&patch.control_points), "/domain/nurbs/control_points"),
            Self { boundaries, .. } => (boundaries.as_deref().map_or(0, count), "/domain/boundaries"),
        }
    }

    fn check(&self) -> Result<(), Rejection> {
        let given = [
            ("polygon", self.polygon.is_some()),
            ("bezier", self.bezier.is_some()),
            ("nurbs", self.nurbs.is_some()),
            ("boundaries", self.boundaries.is_some()),
        ];
        FieldError::unless_one("/domain", &given)?;
        let invalid = |pointer: &str, detail: String| Err(Rejection::Invalid(vec![FieldError::new(pointer, detail)]));
        if self.polygon.is_none() && !self.holes.is_empty() {
            return invalid("/domain/holes", "is only allowed with a polygon".into());
        }
        if self.nurbs.as_ref().and_then(|patch| patch.trim_curves.as_ref()).is_some_and(|curves| !curves.is_empty()) {
            let detail = "trimmed patches are not supported: split the patch along its parameter lines, or give its \
                outline as `boundaries`";
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
                degrees: patch.degrees.map(|degree| degree.get() as usize),
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

impl Optioned for UniformMeshRequest {
    const OPTIONS: &'static [RequestOption] = &[
        RequestOption::always("edge_length"),
        RequestOption::with("optimise_nodes", &[&[when("domain", CURVED)]]),
        RequestOption::with("optimise", &[&[when("optimise_nodes", &["true"])]]),
        RequestOption::with("max_distinct_lengths", &[&[when("optimise", &["lengths"])]]),
        RequestOption::always("length_tolerance"),
        RequestOption::with("rim", &[&[when("domain", CURVED), when("optimise_nodes", &["true"])]]),
        RequestOption::with("auxiliary_grid", &[&[when("domain", &["bezier", "nurbs"])]]),
    ];

    fn choice(&self, member: &str) -> &'static str {
        match member {
            "optimise_nodes" if self.optimise_nodes => "true",
            "optimise_nodes" => "false",
            "optimise" => match self.optimise {
                Optimise::Nodes => "nodes",
                Optimise::Lengths => "lengths",
            },
            _ => self.domain.name(),
        }
    }
}

/// The domains whose nodes can move on a surface.
const CURVED: &[&str] = &["bezier", "nurbs", "boundaries"];

impl KindRequest for UniformMeshRequest {
    type Statistics = UniformStatistics;

    fn axes(&self) -> (Unit, UpAxis) {
        (self.units, self.up)
    }

    fn check(&self, limits: &Limits) -> Result<Checked, Rejection> {
        self.domain.check()?;
        let (points, field) = self.domain.point_count();
        limits::check_count(field, points, limits.points, "points")?;
        let invalid = |pointer: &str, detail: &str| Err(Rejection::Invalid(vec![FieldError::new(pointer, detail)]));
        if self.optimise == Optimise::Lengths && !self.optimise_nodes {
            return invalid(
                "/optimise_nodes",
                "must be true with `optimise: lengths`, because lengths are optimised by moving nodes",
            );
        }
        if self.optimise == Optimise::Lengths && self.max_distinct_lengths.is_none() {
            return invalid("/max_distinct_lengths", "is required with `optimise: lengths`");
        }
        let (domain, options) = self.to_geometry();
        let estimate = geometry::estimate(&domain, &options)?;
        if estimate.triangles > limits.triangles as f64 {
            let detail = format!(
                "asks for up to {:.0} triangles, more than are allowed ({})",
                estimate.triangles, limits.triangles
            );
            return Err(Rejection::TooLarge(vec![FieldError::new("/edge_length", detail)]));
        }
        geometry::check(&domain, &options)?;
        Ok(Checked {
            memory_bytes: estimate.bytes,
            quick: false,
            input: Box::new(solve::SolverInput { domain, options }),
        })
    }
}

impl UniformMeshRequest {
    /// Converts the request to the geometry's types.
    fn to_geometry(&self) -> (geometry::Domain, geometry::Options) {
        let optimise = match (self.optimise_nodes, self.optimise, self.max_distinct_lengths) {
            (false, ..) => geometry::Optimise::None,
            (true, Optimise::Lengths, Some(most)) => geometry::Optimise::Lengths { most: most.get() as usize },
            (true, ..) => geometry::Optimise::Nodes,
        };
        let options = geometry::Options {
            edge_length: self.edge_length.get(),
            objective: self.objective,
            length_tolerance: self.length_tolerance.map(Tolerance::get),
            optimise,
            transition: self.rim,
            auxiliary_grid: self.auxiliary_grid.map(Whole::get),
        };
        (self.domain.to_geometry(), options)
    }
}

/// Returns the objectives of this kind.
fn objectives() -> Vec<ObjectiveDoc> {
    geometry::Objective::ALL
        .iter()
        .map(|objective| ObjectiveDoc {
            name: objective.name(),
            kind: KIND,
            minimises: objective.description(),
            unit: objective.unit(),
            source: objective.source(),
            options: Vec::new(),
        })
        .collect()
}
