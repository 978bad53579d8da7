//! Cable nets: the request, its statistics, and their conversion to and from the geometry's types.

mod audit;
mod solve;
mod statistics;

pub use statistics::{CableNetStatistics, CableResult, Group, NetReaction, ValueRange};

use crate::blocks::{self, Block, Input, Output, Part, Preset, Type};
use crate::checked::{Checked, KindRequest, Types};
use crate::common::{LengthAndForce, Point};
use crate::kind::{Entry, Kind, Objective as ObjectiveDoc, Units};
use crate::limits::{self, Limits};
use crate::options::{Given, Optioned, RequestOption};
use plateau_archive::units::{Unit, UpAxis};
use plateau_cable_net as geometry;
use plateau_mesh::error::Step;
use plateau_mesh::{DVec3, Error as GeometryError, InputError};
use plateau_strict_json::bounds::{Fraction, List, NonNegative, Positive, Signed, Text, Whole, is_default, unwritten};
use plateau_strict_json::rejection::{FieldError, Rejection};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub const KIND: Kind = Kind::of(&ENTRY);

static ENTRY: Entry = Entry {
    name: "cable_net",
    path: "/v1/cable-nets",
    summary: "Finds the shape in equilibrium of a cable net that comes nearest to target forces and lengths",
    finds: "cable nets that come nearest to target forces and lengths",
    units: Units::LengthAndForce,
    blocks: &[Block {
        name: "cable-net",
        title: "Cable Net",
        description: "Net of cables in equilibrium that comes nearest to target forces and lengths.",
        inputs: &[
            Input::list(
                "Cables",
                "C",
                Type::Curve,
                1,
                "Lines and polylines. Each segment is an edge of the net, and equal points are joined.",
            ),
            Input::list("Supports", "A", Type::Point, 1, "Points of the cables that do not move."),
            Input::required("Cable Value", "V", Type::Number, "Target of every edge."),
            Input::optional(
                "Cable Mode",
                "M",
                Preset::Text("force"),
                "Meaning of the value: force, length (of each edge) or force_density.",
            ),
            Input::optional(
                "Load",
                "W",
                Preset::Number(0.0),
                "Weight on every point that is no support, against the z axis.",
            ),
        ],
    }],
    // A net has neither triangles nor an area.
    outputs: &[
        blocks::CONVERGED,
        Output::figure("/objective_value", "Loss", "L", Type::Number, "Deviation from the targets."),
        Output::part(Part::Cables, "Cables", "Ca", Type::Curve, "Edges of the net."),
        blocks::CABLE_FORCES,
        Output::part(Part::Anchors, "Anchor Points", "AP", Type::Point, "The supports."),
        blocks::ANCHOR_FORCES,
    ],
    objectives,
    types: Types::of::<CableNetRequest>(),
};

/// Name of the group of edges that no cable lists.
const OTHER_EDGES: &str = "other";

/// A net of cables without film, whose shape in equilibrium comes nearest to target forces and lengths.
///
/// The net is given by its vertices and by the edges between them. Every edge is a straight piece of cable in tension,
/// or a strut in compression. Cables are groups of edges with common targets.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CableNetRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default, skip_serializing_if = "unwritten")]
    pub kind: Option<CableNetKind>,
    #[serde(default, skip_serializing_if = "is_default")]
    pub units: LengthAndForce,
    /// Axis that points up.
    #[serde(default)]
    pub up: UpAxis,
    /// Points of the net: supports where they stay, the other vertices where form finding begins.
    pub vertices: List<Point, 2>,
    /// Pairs of vertices that a cable joins, counted from 0.
    #[schemars(inner(inner(range(min = 0, max = 4_294_967_295u32))))]
    pub edges: List<[u32; 2], 1>,
    /// Vertices that do not move, counted from 0.
    #[schemars(inner(range(min = 0, max = 4_294_967_295u32)))]
    pub supports: List<u32, 1>,
    /// Loads on vertices. Loads of one vertex are added.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub loads: List<NetLoad, 0>,
    /// Groups of edges with their targets. Edges that no cable lists have no target.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub cables: List<NetCable, 0>,
    #[serde(default, skip_serializing_if = "is_default")]
    pub weights: TargetWeights,
    /// Lower bound of the magnitudes of the force densities that are found, a force per length. If it is above 0, every
    /// cable stays in tension. Otherwise a job fails if its targets leave a cable slack.
    #[serde(default)]
    pub least_force_density: NonNegative,
    /// The shape counts as found when three steps in a row each lower the loss by less than this fraction of it.
    #[serde(default = "default_tolerance")]
    pub tolerance: Fraction,
    /// Maximum number of steps. Null means 200, and 200 more if fitting begins a second time; 1000 with
    /// struts.
    #[serde(default)]
    pub max_iterations: Option<Whole<1, 1_000_000_000>>,
}

fn default_tolerance() -> Fraction {
    Fraction::new(1e-4)
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CableNetKind {
    CableNet,
}

/// A load, the same on each of its vertices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NetLoad {
    /// Vertices on which the load acts. Null means all vertices that are no supports. An empty list is refused.
    #[serde(default)]
    #[schemars(inner(range(min = 0, max = 4_294_967_295u32)), extend("x-empty-is-refused" = true))]
    pub vertices: Option<List<u32, 1>>,
    /// Force on each of the vertices.
    pub force: Point,
}

/// Edges with common targets. Targets are met in least squares, and `force_density` exactly.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NetCable {
    /// Name in statistics and files. Null means its number, as in `cable 0`.
    #[serde(default)]
    pub name: Option<Text<1, 100>>,
    /// Numbers of its edges, counted from 0. Null means all edges that no other cable lists. An empty list is refused.
    #[serde(default)]
    #[schemars(inner(range(min = 0, max = 4_294_967_295u32)), extend("x-empty-is-refused" = true))]
    pub edges: Option<List<u32, 1>>,
    /// Force that each edge is to have: positive in a cable, negative in a strut.
    #[serde(default)]
    pub force: Option<Signed>,
    /// Length that each edge is to have in the found shape.
    #[serde(default)]
    pub length: Option<Positive>,
    /// Force over length of each edge, which is held: positive in a cable, negative in a strut. Not together with
    /// `force` or `length`.
    #[serde(default)]
    pub force_density: Option<Signed>,
    /// Whether the edges are struts, which push. A negative `force` or `force_density` says it too.
    #[serde(default, skip_serializing_if = "is_default")]
    pub strut: bool,
    /// EA, a force. It gives the unstressed length.
    #[serde(default)]
    pub axial_stiffness: Option<Positive>,
}

/// Weights of the terms of the loss.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TargetWeights {
    /// Weight of the mean of (force / target - 1)² over the edges with a target force.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    #[schemars(extend("default" = 1.0))]
    pub force: NonNegative,
    /// Weight of the mean of (length / target - 1)² over the edges with a target length.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    #[schemars(extend("default" = 1.0))]
    pub length: NonNegative,
    /// Weight of the load path Σ force · length, as a fraction of its value at the start.
    #[serde(default)]
    pub load_path: NonNegative,
}

fn one() -> NonNegative {
    NonNegative::new(1.0)
}

fn is_one(weight: &NonNegative) -> bool {
    *weight == one()
}

impl Default for TargetWeights {
    fn default() -> Self {
        Self { force: one(), length: one(), load_path: NonNegative::default() }
    }
}

impl NetCable {
    fn is_strut(&self) -> bool {
        let pushes = |value: Option<Signed>| value.is_some_and(|value| value.get() < 0.0);
        self.strut || pushes(self.force) || pushes(self.force_density)
    }
}

impl Optioned for CableNetRequest {
    const OPTIONS: &'static [RequestOption] = &[
        RequestOption::always("edges"),
        RequestOption::always("supports"),
        RequestOption::always("loads"),
        RequestOption::always("cables"),
        RequestOption::always("weights"),
        RequestOption::always("least_force_density"),
        RequestOption::always("tolerance"),
        RequestOption::always("max_iterations"),
    ];

    // Without these lists, a load acts on every free vertex, and a cable has every edge that is left.
    const EMPTY_LISTS: &'static [(&'static str, &'static str)] = &[("vertices", "loads"), ("edges", "cables")];

    fn choice(&self, _member: &str) -> &'static str {
        "nearest_to_targets"
    }

    fn idle(&self, given: &Given<'_>) -> Vec<FieldError> {
        let mut errors = Vec::new();
        let mut refuse = |is_idle: bool, pointers: &[&str], detail: &str| {
            let idle = pointers.iter().filter(|pointer| is_idle && given.has(pointer));
            errors.extend(idle.map(|pointer| FieldError::new(*pointer, detail)));
        };
        let has = |target: fn(&NetCable) -> bool| self.cables.iter().any(target);
        refuse(
            !has(|cable| cable.force.is_some()),
            &["/weights/force"],
            "has no effect in this request: it needs a cable with a `force`",
        );
        refuse(
            !has(|cable| cable.length.is_some()),
            &["/weights/length"],
            "has no effect in this request: it needs a cable with a `length`",
        );
        errors
    }
}

impl KindRequest for CableNetRequest {
    type Statistics = CableNetStatistics;

    fn axes(&self) -> (Unit, UpAxis) {
        (self.units.into(), self.up)
    }

    fn check(&self, limits: &Limits) -> Result<Checked, Rejection> {
        limits::check_count("/vertices", self.vertices.len(), limits.points, "points")?;
        limits::check_count("/edges", self.edges.len(), limits.triangles, "edges")?;
        limits::check_count("/cables", self.cables.len(), limits.triangles, "cables")?;
        limits::check_count("/loads", self.loads.len(), limits.points, "loads")?;
        limits::check_number("/max_iterations", self.max_iterations.map(Whole::get), limits.iterations as usize)?;
        let mut errors = Vec::new();
        let of_edge = self.check_cables(&mut errors);
        let loads = self.check_loads(&mut errors);
        self.check_supports(&mut errors);
        if !errors.is_empty() {
            return Err(Rejection::Invalid(errors));
        }
        let (net, options) = self.to_geometry(&of_edge, loads);
        geometry::check(&net, &options).map_err(|error| placed(error, &of_edge))?;
        Ok(Checked {
            memory_bytes: geometry::estimate(&net).bytes,
            quick: false,
            input: Box::new(solve::SolverInput {
                net,
                options,
                groups: self.groups(&of_edge),
                force: self.units.force,
            }),
        })
    }
}

impl CableNetRequest {
    /// Returns for each edge the number of its cable. Edges that no cable lists belong to the cable without a list, if
    /// there is one.
    fn check_cables(&self, errors: &mut Vec<FieldError>) -> Vec<Option<usize>> {
        let mut of_edge = vec![None; self.edges.len()];
        let mut rest = None;
        for (k, cable) in self.cables.iter().enumerate() {
            let mut refuse = |field: String, detail: String| {
                FieldError::new(format!("/cables/{k}{field}"), detail).add_to(errors);
            };
            if cable.force_density.is_some() && (cable.force.is_some() || cable.length.is_some()) {
                let detail = "is not allowed with a force or a length: it is held, and they follow from it";
                refuse("/force_density".into(), detail.into());
            }
            for (name, value) in [("force", cable.force), ("force_density", cable.force_density)] {
                match value.map(Signed::get) {
                    Some(0.0) => refuse(format!("/{name}"), "must not be 0".into()),
                    Some(value) if value > 0.0 && cable.is_strut() => {
                        refuse(format!("/{name}"), "must be negative, because the cable is a strut".into());
                    }
                    _ => {}
                }
            }
            if cable.name.as_deref() == Some(OTHER_EDGES) {
                refuse("/name".into(), format!("is the name of the edges that no cable lists: {OTHER_EDGES}"));
            }
            let Some(edges) = &cable.edges else {
                match rest {
                    None => rest = Some(k),
                    Some(first) => refuse(
                        String::new(),
                        format!("needs `edges`, because cable {first} has all edges that no other cable lists"),
                    ),
                }
                continue;
            };
            for (i, &edge) in edges.iter().enumerate() {
                match of_edge.get_mut(edge as usize) {
                    None => {
                        refuse(format!("/edges/{i}"), format!("there are {} edges, numbered from 0", self.edges.len()))
                    }
                    Some(Some(other)) => refuse(format!("/edges/{i}"), format!("belongs to cable {other} already")),
                    Some(cable) => *cable = Some(k),
                }
            }
        }
        of_edge.iter_mut().for_each(|cable| *cable = cable.or(rest));
        let asks = |cable: &NetCable| cable.force.is_some() || cable.length.is_some() || cable.force_density.is_some();
        if !self.cables.iter().any(asks) && self.weights.load_path.get() <= 0.0 {
            let detail = "needs a cable with a force, a length or a force density, unless the load path has a weight";
            errors.push(FieldError::new("/cables", detail));
        }
        of_edge
    }

    /// Returns the load on each vertex, or an empty list if there are no loads.
    fn check_loads(&self, errors: &mut Vec<FieldError>) -> Vec<DVec3> {
        if self.loads.is_empty() {
            return Vec::new();
        }
        let count = self.vertices.len();
        let mut loads = vec![DVec3::ZERO; count];
        let mut held = vec![false; count];
        for &support in self.supports.iter() {
            if let Some(held) = held.get_mut(support as usize) {
                *held = true;
            }
        }
        for (k, load) in self.loads.iter().enumerate() {
            let force = DVec3::from_array(load.force);
            let Some(vertices) = &load.vertices else {
                (0..count).filter(|&v| !held[v]).for_each(|v| loads[v] += force);
                continue;
            };
            for (i, &v) in vertices.iter().enumerate() {
                match loads.get_mut(v as usize) {
                    Some(load) => *load += force,
                    None => {
                        FieldError::new(format!("/loads/{k}/vertices/{i}"), numbered(count)).add_to(errors);
                    }
                }
            }
        }
        loads
    }

    fn check_supports(&self, errors: &mut Vec<FieldError>) {
        let mut seen = vec![None; self.vertices.len()];
        for (k, &support) in self.supports.iter().enumerate() {
            match seen.get_mut(support as usize) {
                None => {
                    FieldError::new(format!("/supports/{k}"), numbered(self.vertices.len())).add_to(errors);
                }
                Some(Some(first)) => {
                    FieldError::new(format!("/supports/{k}"), format!("repeats support {first}")).add_to(errors);
                }
                Some(place) => *place = Some(k),
            }
        }
    }

    fn to_geometry(&self, of_edge: &[Option<usize>], loads: Vec<DVec3>) -> (geometry::Net, geometry::Options) {
        let edge = |(&ends, cable): (&[u32; 2], &Option<usize>)| {
            let cable = cable.map(|k| &self.cables[k]);
            let density = cable.and_then(|cable| cable.force_density).map(Signed::get);
            geometry::Edge {
                ends,
                strut: cable.is_some_and(NetCable::is_strut),
                density,
                held: density.is_some(),
                force: cable.and_then(|cable| cable.force).map(Signed::get),
                length: cable.and_then(|cable| cable.length).map(Positive::get),
            }
        };
        let net = geometry::Net {
            vertices: self.vertices.iter().copied().map(DVec3::from_array).collect(),
            edges: self.edges.iter().zip(of_edge).map(edge).collect(),
            supports: self.supports.to_vec(),
            loads,
        };
        let options = geometry::Options {
            force_weight: self.weights.force.get(),
            length_weight: self.weights.length.get(),
            load_path_weight: self.weights.load_path.get(),
            least_density: self.least_force_density.get(),
            tolerance: self.tolerance.get(),
            max_iterations: self.max_iterations.map(Whole::get),
        };
        (net, options)
    }

    /// Returns the cables with their edges. Cables without edges are left out.
    fn groups(&self, of_edge: &[Option<usize>]) -> Vec<Group> {
        let mut groups: Vec<Group> = self
            .cables
            .iter()
            .enumerate()
            .map(|(k, cable)| Group {
                name: cable.name.as_deref().map_or_else(|| format!("{k}"), str::to_owned),
                edges: Vec::new(),
                axial_stiffness: cable.axial_stiffness.map(Positive::get),
            })
            .collect();
        groups.push(Group { name: OTHER_EDGES.into(), edges: Vec::new(), axial_stiffness: None });
        for (k, cable) in of_edge.iter().enumerate() {
            groups[cable.unwrap_or(self.cables.len())].edges.push(k);
        }
        groups.retain(|group| !group.edges.is_empty());
        groups
    }
}

fn numbered(count: usize) -> String {
    format!("there are {count} vertices, numbered from 0")
}

/// Converts the geometry's errors to errors at the corresponding fields of the request.
fn placed(error: GeometryError, of_edge: &[Option<usize>]) -> Rejection {
    let GeometryError::Input(errors) = error else { return error.into() };
    Rejection::Invalid(errors.iter().map(|error| FieldError::new(pointer(error, of_edge), &*error.detail)).collect())
}

fn pointer(error: &InputError, of_edge: &[Option<usize>]) -> String {
    use Step::{Field, Index};
    match error.place.0.as_slice() {
        [Field("edges"), Index(k), Field("ends")] => format!("/edges/{k}"),
        [Field("edges"), Index(k), Field("ends"), Index(end)] => format!("/edges/{k}/{end}"),
        [Field("edges"), Index(k), Field(field)] => {
            let field = if *field == "density" { "force_density" } else { field };
            match of_edge.get(*k).copied().flatten() {
                Some(cable) => format!("/cables/{cable}/{field}"),
                None => format!("/edges/{k}"),
            }
        }
        [Field("loads"), ..] => "/loads".into(),
        [Field("least_density")] => "/least_force_density".into(),
        [Field("force_weight")] => "/weights/force".into(),
        [Field("length_weight")] => "/weights/length".into(),
        [Field("load_path_weight")] => "/weights/load_path".into(),
        _ => FieldError::from(error).pointer,
    }
}

/// Returns the objectives of this kind.
fn objectives() -> Vec<ObjectiveDoc> {
    vec![ObjectiveDoc {
        name: "nearest_to_targets",
        kind: KIND,
        minimises: "w_F mean((F / F* - 1)²) + w_L mean((L / L* - 1)²) + w_P Σ F L / (Σ F L at the start), in exact \
                    equilibrium, over the edges' force densities",
        unit: "1",
        source: "Schek 1974",
        options: Vec::new(),
    }]
}
