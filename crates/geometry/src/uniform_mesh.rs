//! Uniform meshes: triangulations whose edges (the members of a latticed roof) have as few lengths as possible.
//!
//! N. Katoh, M. Ohsaki, Y. Xu, *A uniform triangle mesh generation of curved surfaces*. Given a length ℓ, every edge is to
//! lie in [ℓ, 2ℓ]:
//! - [`Objective::FewestNodes`] (their problem 1): farthest-point insertion, at most 16/3 times the fewest nodes possible;
//! - [`Objective::MostEqualEdges`] (their problem 2): an equilateral lattice of edge ℓ inside, the same insertion in the rim.
//!
//! Both promises hold on convex polygons with inner angles of 90° or more and sides of ℓ or more. Elsewhere (concave
//! polygons, sharp corners, short sides, holes) the mesh is still valid, no edge is longer than 2ℓ, and every edge shorter
//! than ℓ is listed with the reason.
//!
//! The steps, each in a file of its own: [`polygon`] checks the domain and places the boundary's nodes, [`lattice`] lays the
//! lattice, [`increment`] fills the rest, [`plane`] joins them.

mod increment;
mod lattice;
mod plane;
mod polygon;
pub mod statistics;
mod triangulation;

use crate::error::{Error, InputError, Place, Warning};
use crate::execution::{Execution, Progress};
use crate::mesh::measure::{Spread, angle_range};
use crate::mesh::topology::{NONE, Topology};
use crate::{DVec3, Mesh};
use plane::Failure;
use polygon::Polygon;
use statistics::{Group, LengthHistogram, Stage};
use triangulation::Tangle;

/// Coordinates beyond this overflow when squared and multiplied.
const LARGEST_COORDINATE: f64 = 1e100;
/// More nodes than this and indices no longer fit.
const MOST_NODES: f64 = 5e7;
/// What rounding of unit lengths may add beyond [ℓ, 2ℓ] (the insertion's own slack is half of it).
const RANGE_TOLERANCE: f64 = 2.0 * increment::SLACK;

/// What to mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum Domain {
    /// A planar polygon in space with holes, none repeating its first point, in either direction. Its points may lie up to
    /// 1e-6 of its size off their plane; they stay exactly where they are given. The mesh faces the side from which `outer`
    /// runs counter-clockwise.
    Polygon { outer: Vec<DVec3>, holes: Vec<Vec<DVec3>> },
}

/// What to minimise or maximise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objective {
    /// Their problem 1: as few nodes as possible, every edge in [ℓ, 2ℓ].
    FewestNodes,
    /// Their problem 2: as many edges of length ℓ as possible, every other edge in [ℓ, 2ℓ].
    MostEqualEdges,
}

impl Objective {
    pub const ALL: [Self; 2] = [Self::FewestNodes, Self::MostEqualEdges];

    /// The name in requests.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::FewestNodes => "fewest_nodes",
            Self::MostEqualEdges => "most_equal_edges",
        }
    }

    /// What is minimised or maximised, and what `objective_value` counts.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::FewestNodes => {
                "The number of nodes, every edge between ℓ and 2ℓ: farthest-point insertion, at most 16/3 of the optimum. \
                 The objective value is the number of nodes."
            }
            Self::MostEqualEdges => {
                "The number of edges of length ℓ, every other edge between ℓ and 2ℓ: an equilateral lattice where it fits \
                 best, farthest-point insertion with visibility in the rim. The objective value is the number of lattice edges."
            }
        }
    }

    /// Where the formula stands.
    #[must_use]
    pub fn source(self) -> &'static str {
        match self {
            Self::FewestNodes => "Katoh, Ohsaki, Xu, section 2, problem 1",
            Self::MostEqualEdges => "Katoh, Ohsaki, Xu, section 3, problem 2",
        }
    }
}

/// How to mesh it.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// ℓ, in the caller's unit.
    pub edge_length: f64,
    pub objective: Objective,
    /// Lengths that differ by no more count as equal, in the caller's unit. `None`: ℓ/1000.
    pub length_tolerance: Option<f64>,
}

impl Options {
    #[must_use]
    pub fn new(edge_length: f64, objective: Objective) -> Self {
        Self { edge_length, objective, length_tolerance: None }
    }
}

/// Why an edge is outside [ℓ, 2ℓ].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Why {
    /// A side of the domain is itself shorter than ℓ (the edge is that side, or joins nodes around it).
    ShortSide,
    /// It joins two sides that meet at an inner angle below 90°.
    SharpCorner,
    /// It joins two parts of the boundary that come closer than ℓ.
    Narrow,
    /// The deadline passed before the insertion was through.
    Unfinished,
}

impl Why {
    /// The name in results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::ShortSide => "short_side",
            Self::SharpCorner => "sharp_corner",
            Self::Narrow => "narrow",
            Self::Unfinished => "unfinished",
        }
    }
}

/// An edge outside [ℓ, 2ℓ].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// Index into [`UniformMesh::members`].
    pub member: usize,
    pub length: f64,
    pub why: Why,
}

/// The figures of a result.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Nodes, or lattice edges, by the objective.
    pub objective_value: usize,
    pub nodes: usize,
    pub triangles: usize,
    pub edges: usize,
    pub edge_lengths: Spread,
    /// Edges of length ℓ on the lattice.
    pub lattice_edges: Spread,
    /// Edges whose length is within the tolerance of ℓ.
    pub equal_edges: usize,
    pub distinct_lengths: usize,
    /// The tolerance behind the two counts above.
    pub length_tolerance: f64,
    pub out_of_range_edges: usize,
    /// Smallest and largest inner angle, radians.
    pub angles: (f64, f64),
    pub length_histogram: LengthHistogram,
    /// Entry k counts the nodes with k members.
    pub valence_histogram: Vec<usize>,
    /// No mesh of this domain with every edge at most 2ℓ has fewer nodes.
    pub node_lower_bound: Option<usize>,
}

/// A uniform mesh and everything known about it.
#[derive(Clone, Debug, PartialEq)]
pub struct UniformMesh {
    /// The input's points first (merged ones once), then further nodes on the boundary, then the inner nodes.
    pub mesh: Mesh,
    /// The edges, each once.
    pub members: Vec<[u32; 2]>,
    /// For each member whether it belongs to the lattice group.
    pub lattice_group: Vec<bool>,
    /// For each member its length.
    pub lengths: Vec<f64>,
    pub statistics: Statistics,
    pub stages: Vec<Stage>,
    /// The edges outside [ℓ, 2ℓ], by member.
    pub out_of_range: Vec<OutOfRange>,
    /// For each input point its vertex, in input order; merged points share one.
    pub input_vertices: Vec<Option<u32>>,
    /// False if the deadline cut the work short; the mesh is valid all the same.
    pub converged: bool,
    pub warnings: Vec<Warning>,
}

/// What a solve will cost at most, before any of the work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// An upper bound on the nodes (Oler's packing bound with gaps of ℓ); about 1.2 to 1.6 times what comes out.
    pub nodes: f64,
    pub triangles: f64,
}

/// Bounds the size of the result in O(input).
///
/// # Errors
/// The input errors that [`solve`] would report before meshing.
pub fn estimate(domain: &Domain, options: &Options) -> Result<Cost, Error> {
    check(options)?;
    match domain {
        Domain::Polygon { outer, holes } => {
            let (area, perimeter) = polygon::extent(outer, holes)?;
            Ok(cost(area, perimeter, options.edge_length))
        }
    }
}

/// Oler: at most 2/√3 A/ℓ² + P/2ℓ + 1 points with gaps of ℓ fit; each side adds one more piece by rounding up.
fn cost(area: f64, perimeter: f64, edge_length: f64) -> Cost {
    let nodes = 2.0 / 3f64.sqrt() * area / (edge_length * edge_length) + 1.5 * perimeter / edge_length + 4.0;
    Cost { nodes, triangles: 2.0 * nodes }
}

fn check(options: &Options) -> Result<(), Error> {
    let mut errors = Vec::new();
    if !(1.0 / LARGEST_COORDINATE..=LARGEST_COORDINATE).contains(&options.edge_length) {
        errors.push(InputError::new(Place::field("edge_length"), "must be positive, between 1e-100 and 1e100"));
    }
    if options.length_tolerance.is_some_and(|tolerance| !(tolerance >= 0.0 && tolerance.is_finite())) {
        errors.push(InputError::new(Place::field("length_tolerance"), "must be zero or positive"));
    }
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

/// Meshes the domain.
///
/// On convex polygons with inner angles of 90° or more and sides of ℓ or more, every edge has a length in [ℓ, 2ℓ] (to 2e-9).
/// On any other valid polygon no edge is longer than 2ℓ, and those shorter than ℓ are listed with the reason. Looks at
/// `execution` every few thousand triangles or one lattice placement. O(n log n) in practice.
///
/// # Errors
/// [`Error::Input`]: values that are not finite, a polygon without area, not planar, self-intersecting or self-touching, a
/// hole outside, an edge length that asks for more than 5e7 nodes. [`Error::Interrupted`]: cancelled, or the deadline passed
/// before there was a valid mesh; later the mesh reached so far is returned with `converged` false.
pub fn solve(domain: &Domain, options: &Options, execution: &Execution<'_>) -> Result<UniformMesh, Error> {
    let cost = estimate(domain, options)?;
    if cost.nodes > MOST_NODES {
        let detail = format!("asks for up to {:.3e} nodes; at most {MOST_NODES:.0e} are possible", cost.nodes);
        return Err(Error::input(Place::field("edge_length"), detail));
    }
    match domain {
        Domain::Polygon { outer, holes } => on_polygon(outer, holes, options, execution),
    }
}

fn on_polygon(
    outer: &[DVec3],
    holes: &[Vec<DVec3>],
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    let polygon = Polygon::new(outer, holes, options.edge_length, options.objective)?;
    let flat = plane::mesh(&polygon.outline, options.objective, (0.0, 0.95), execution)
        .map_err(|failure| planar_error(failure, &polygon))?;
    let mut vertices = polygon.positions.clone();
    vertices.extend(flat.points[vertices.len()..].iter().map(|&p| polygon.frame.point(p)));
    let mesh = Mesh::new(vertices, flat.triangles);
    let topology = topology(&mesh)?;
    let members = members(&mesh, &topology);
    let on_lattice: Vec<bool> =
        flat.points.iter().map(|&p| flat.lattice.is_some_and(|placement| placement.carries(p))).collect();
    let lattice_group: Vec<bool> = members
        .iter()
        .map(|&[a, b]| {
            let (a, b) = (a as usize, b as usize);
            on_lattice[a] && on_lattice[b] && (flat.points[a].distance(flat.points[b]) - 1.0).abs() < 1e-6
        })
        .collect();
    let mut result = Assembly { mesh, members, lattice_group, options }
        .finish(|edge, length| polygon.why(edge, length / options.edge_length));
    result.stages.push(result.stage("plane", options.edge_length));
    result.statistics.node_lower_bound = Some(polygon.node_lower_bound());
    result.input_vertices = polygon.input_vertices;
    result.converged = !flat.interrupted;
    result.warnings.splice(0..0, polygon.warnings);
    if flat.interrupted {
        result.warnings.push(Warning::new("not_converged", "the deadline passed; edges may be longer than 2ℓ"));
    } else if options.objective == Objective::MostEqualEdges && result.statistics.lattice_edges.count == 0 {
        result
            .warnings
            .push(Warning::new("no_lattice", "no lattice edge fits: the domain is too narrow for this length"));
    }
    execution.report(Progress {
        fraction: 1.0,
        phase: "done",
        iteration: result.statistics.nodes as u64,
        objective_value: Some(result.statistics.objective_value as f64),
        residual: None,
    });
    Ok(result)
}

/// The mesh's connectivity; a defect here is a defect of this module, reported rather than passed on.
fn topology(mesh: &Mesh) -> Result<Topology, Error> {
    mesh.check()
        .map_err(|defect| Error::no_result("invalid_mesh", format!("the triangulation is not a manifold: {defect}")))
}

fn members(mesh: &Mesh, topology: &Topology) -> Vec<[u32; 2]> {
    (0..3 * mesh.triangles.len() as u32)
        .filter(|&h| topology.twin[h as usize] == NONE || topology.twin[h as usize] > h)
        .map(|h| [topology.from(h), topology.to(h)])
        .collect()
}

fn planar_error(failure: Failure, polygon: &Polygon) -> Error {
    let crossing = "the polygon crosses or touches itself (or a hole) here";
    match failure {
        Failure::Interrupted(interruption) => Error::Interrupted(interruption),
        Failure::Tangle(Tangle::Coincident(a, b)) => Error::Input(vec![
            InputError::new(polygon.place_of(a), "coincides with another point: the boundary touches itself"),
            InputError::new(polygon.place_of(b), "coincides with another point: the boundary touches itself"),
        ]),
        Failure::Tangle(Tangle::Crossing { from, .. }) => Error::input(polygon.place_of(from), crossing),
        Failure::Tangle(Tangle::WrongSide { from, .. }) => {
            Error::input(polygon.ring_of(from), "does not lie inside the polygon, clear of the other holes")
        }
        Failure::Tangle(Tangle::OutOfRange) => {
            Error::input(Place::field("domain"), "coordinates are too large or too close together for this edge length")
        }
    }
}

/// A mesh on its way to a result.
struct Assembly<'a> {
    mesh: Mesh,
    members: Vec<[u32; 2]>,
    lattice_group: Vec<bool>,
    options: &'a Options,
}

impl Assembly<'_> {
    fn finish(self, why: impl Fn([u32; 2], f64) -> Why) -> UniformMesh {
        let Self { mesh, members, lattice_group, options } = self;
        let target = options.edge_length;
        let tolerance = options.length_tolerance.unwrap_or(target / 1000.0);
        let at = |v: u32| mesh.vertices[v as usize];
        let lengths: Vec<f64> = members.iter().map(|&[a, b]| at(a).distance(at(b))).collect();
        // Coordinates far from the origin carry lengths only to their own rounding.
        let largest = mesh.vertices.iter().map(|v| v.abs().max_element()).fold(0.0, f64::max);
        let slack = RANGE_TOLERANCE * target + 8.0 * f64::EPSILON * largest;
        let out_of_range: Vec<OutOfRange> = lengths
            .iter()
            .enumerate()
            .filter(|&(_, &length)| length < target - slack || length > 2.0 * (target + slack))
            .map(|(member, &length)| OutOfRange { member, length, why: why(members[member], length) })
            .collect();
        let all = Group::of(&lengths, target, tolerance);
        let lattice = lengths.iter().zip(&lattice_group).filter(|&(_, &member)| member).map(|(&length, _)| length);
        let lattice_edges = Spread::of(lattice);
        let statistics = Statistics {
            objective_value: match options.objective {
                Objective::FewestNodes => mesh.vertices.len(),
                Objective::MostEqualEdges => lattice_edges.count,
            },
            nodes: mesh.vertices.len(),
            triangles: mesh.triangles.len(),
            edges: members.len(),
            edge_lengths: all.lengths,
            lattice_edges,
            equal_edges: all.equal_edges,
            distinct_lengths: all.distinct_lengths,
            length_tolerance: tolerance,
            out_of_range_edges: out_of_range.len(),
            angles: angle_range(&mesh),
            length_histogram: LengthHistogram::of(&lengths, target),
            valence_histogram: statistics::valences(&members, mesh.vertices.len()),
            node_lower_bound: None,
        };
        let mut warnings = Vec::new();
        if !out_of_range.is_empty() {
            let mut reasons: Vec<&str> = out_of_range.iter().map(|edge| edge.why.name()).collect();
            reasons.sort_unstable();
            reasons.dedup();
            let detail = format!("{} edges are outside [ℓ, 2ℓ]: {}", out_of_range.len(), reasons.join(", "));
            warnings.push(Warning::new("out_of_range", detail));
        }
        UniformMesh {
            mesh,
            members,
            lattice_group,
            lengths,
            statistics,
            stages: Vec::new(),
            out_of_range,
            input_vertices: Vec::new(),
            converged: true,
            warnings,
        }
    }
}

impl UniformMesh {
    /// The figures of the mesh as it stands, as one row pair of Table 1.
    fn stage(&self, name: &'static str, target: f64) -> Stage {
        let lattice: Vec<f64> =
            self.lengths.iter().zip(&self.lattice_group).filter(|&(_, &member)| member).map(|(&l, _)| l).collect();
        let tolerance = self.statistics.length_tolerance;
        Stage {
            name,
            all: Group::of(&self.lengths, target, tolerance),
            lattice: Some(Group::of(&lattice, target, tolerance)),
        }
    }
}
