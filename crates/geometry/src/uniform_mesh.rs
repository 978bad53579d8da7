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
//! Curved domains are flattened, meshed in the plane and carried back; then the inner nodes move on the surface until the
//! lattice's members are as near to ℓ as they get.
//!
//! The steps, each in a file of its own: `polygon` checks a planar domain and places the boundary's nodes, `lattice` lays the
//! lattice, `increment` fills the rest, `plane` joins them; `parametric_surface` evaluates patches, `flatten` lays surfaces
//! into the plane, `curved` goes there and back, `refine_on_surface` moves the nodes, `rim` rebuilds what lies between lattice and
//! boundary for where they have come to.

mod assemble;
mod curved;
mod flatten;
mod increment;
mod lattice;
mod least_squares;
pub mod lengths;
pub mod parametric_surface;
mod plane;
mod polygon;
mod refine_on_surface;
mod rim;
mod sides;
pub mod statistics;
mod triangulation;

use crate::error::{Error, InputError, Place, Warning};
use crate::execution::Execution;
use crate::mesh::measure::Spread;
use crate::mesh::self_intersections::{self, Order, SelfIntersectionCheck};
use crate::polyline::LARGEST_COORDINATE;
use crate::{DVec2, DVec3, Mesh};
use assemble::{on_polygon, on_surface};
use curved::Auxiliary;
use lengths::LengthsRow;
use parametric_surface::Nurbs;
use polygon::Polygon;
use statistics::{LengthHistogram, Stage};

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
    /// A tensor-product Bézier patch: `control_points[i][j]`, i along u and j along v. Its mesh faces u × v.
    Bezier { control_points: Vec<Vec<DVec3>> },
    /// An untrimmed NURBS patch.
    Nurbs(Nurbs),
    /// The minimal surface that spans these closed polygons, see [`crate::minimal_surface`].
    Boundaries(Vec<Vec<DVec3>>),
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

    /// The unit of the objective's value.
    #[must_use]
    pub fn unit(self) -> &'static str {
        "1"
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

/// What is done with a curved surface's nodes after meshing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Optimise {
    /// Nothing: they stay where the plane puts them.
    None,
    /// The inner nodes move on the surface to the least Σ (L - ℓ)² over the lattice group, and the rim is made anew for them
    /// unless it is [`Rim::Free`]. (In the plane the sum is 0 already.)
    #[default]
    Nodes,
    /// After that, on polygons too: the inner nodes move until at most so many lengths stand for all members, each within
    /// half the length tolerance, or as nearly so as found ([`UniformMesh::shared_lengths`]).
    Lengths { most: usize },
}

/// What the members outside the lattice group may do while nodes move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rim {
    /// Stay in [ℓ, 2ℓ] wherever that is possible.
    #[default]
    Bounded,
    /// Anything, as in the paper.
    Free,
}

/// How to mesh it.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// ℓ, in the caller's unit.
    pub edge_length: f64,
    pub objective: Objective,
    /// Lengths that differ by no more count as equal, in the caller's unit. `None`: ℓ/1000.
    pub length_tolerance: Option<f64>,
    /// For curved domains; in the plane lattice members have length ℓ as they are.
    pub optimise: Optimise,
    pub rim: Rim,
    /// Rectangles along u and v of the auxiliary triangulation of a patch, 2 to 400 each.
    pub auxiliary_grid: [u32; 2],
}

impl Options {
    #[must_use]
    pub fn new(edge_length: f64, objective: Objective) -> Self {
        Self {
            edge_length,
            objective,
            length_tolerance: None,
            optimise: Optimise::default(),
            rim: Rim::default(),
            auxiliary_grid: [15, 15],
        }
    }

    /// The length tolerance in force.
    fn tolerance(&self) -> f64 {
        self.length_tolerance.unwrap_or(self.edge_length / 1000.0)
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
    /// The surface is stretched against the plane there.
    Curvature,
    /// The optimisation took it out, as [`Rim::Free`] and [`Optimise::Lengths`] may.
    Optimised,
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
            Self::Curvature => "curvature",
            Self::Optimised => "optimised",
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
    /// Pairs of triangles that meet in more than what they share.
    pub self_intersections: SelfIntersectionCheck,
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
    /// For [`Optimise::Lengths`]: deviation against the number of lengths, as far as it was tried.
    pub shared_lengths: Vec<LengthsRow>,
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
    check_options(options)?;
    match domain {
        Domain::Polygon { outer, holes } => {
            let (area, perimeter) = polygon::extent(outer, holes)?;
            Ok(cost(area, perimeter, options.edge_length))
        }
        Domain::Bezier { control_points } => estimate_patch(&Nurbs::bezier(control_points.clone()), "bezier", options),
        Domain::Nurbs(patch) => estimate_patch(patch, "nurbs", options),
        Domain::Boundaries(boundaries) => {
            for (k, boundary) in boundaries.iter().enumerate() {
                if let Some(i) =
                    boundary.iter().position(|p| !p.is_finite() || p.abs().max_element() > LARGEST_COORDINATE)
                {
                    let place = Place::field("domain").then("boundaries").at(k).at(i);
                    return Err(Error::input(place, "must be finite and below 1e50 in magnitude"));
                }
            }
            let perimeter: f64 = boundaries.iter().map(|points| crate::polyline::length(points, true)).sum();
            Ok(cost(film_area(boundaries), perimeter, options.edge_length))
        }
    }
}

/// The patch's area and circumference on a grid; a little more, since chords are shorter than arcs.
fn estimate_patch(patch: &Nurbs, field: &'static str, options: &Options) -> Result<Cost, Error> {
    patch.check(&Place::field("domain").then(field))?;
    let n = 24;
    let at = |i: usize, j: usize| patch.evaluate(DVec2::new(i as f64, j as f64) / n as f64)[0];
    let (mut area, mut perimeter) = (0.0, 0.0);
    for i in 0..n {
        for j in 0..n {
            area += 0.5 * (at(i + 1, j + 1) - at(i, j)).cross(at(i, j + 1) - at(i + 1, j)).length();
        }
        for (a, b) in [((i, 0), (i + 1, 0)), ((i, n), (i + 1, n)), ((0, i), (0, i + 1)), ((n, i), (n, i + 1))] {
            perimeter += at(a.0, a.1).distance(at(b.0, b.1));
        }
    }
    Ok(cost(1.1 * area, 1.1 * perimeter, options.edge_length))
}

/// The fans from each boundary to its mean together bound the least area of a film with these boundaries from above.
fn film_area(boundaries: &[Vec<DVec3>]) -> f64 {
    let fan = |points: &Vec<DVec3>| -> f64 {
        let centre = crate::polyline::mean(points);
        let around = points.iter().zip(points.iter().cycle().skip(1));
        around.map(|(&a, &b)| 0.5 * (a - centre).cross(b - centre).length()).sum()
    };
    boundaries.iter().map(fan).sum()
}

/// Oler: at most 2/√3 A/ℓ² + P/2ℓ + 1 points with gaps of ℓ fit; each side adds one more piece by rounding up.
fn cost(area: f64, perimeter: f64, edge_length: f64) -> Cost {
    let nodes = 2.0 / 3f64.sqrt() * area / (edge_length * edge_length) + 1.5 * perimeter / edge_length + 4.0;
    Cost { nodes, triangles: 2.0 * nodes }
}

fn check_options(options: &Options) -> Result<(), Error> {
    let mut errors = Vec::new();
    if !(1.0 / LARGEST_COORDINATE..=LARGEST_COORDINATE).contains(&options.edge_length) {
        errors.push(InputError::new(Place::field("edge_length"), "must be positive, between 1e-50 and 1e50"));
    }
    for (axis, &cells) in options.auxiliary_grid.iter().enumerate() {
        if !(2..=400).contains(&cells) {
            errors.push(InputError::new(Place::field("auxiliary_grid").at(axis), "must lie between 2 and 400"));
        }
    }
    if let Optimise::Lengths { most } = options.optimise
        && !(1..=1000).contains(&most)
    {
        errors.push(InputError::new(Place::field("max_distinct_lengths"), "must lie between 1 and 1000"));
    }
    if options.length_tolerance.is_some_and(|tolerance| !(tolerance >= 0.0 && tolerance.is_finite())) {
        errors.push(InputError::new(Place::field("length_tolerance"), "must be zero or positive"));
    }
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

/// What [`solve`] would say of its arguments before any meshing, planarity included: linear in their size.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with. Arguments that pass may still turn out to cross themselves.
pub fn check(domain: &Domain, options: &Options) -> Result<Cost, Error> {
    let cost = estimate(domain, options)?;
    match domain {
        Domain::Polygon { outer, holes } => drop(Polygon::new(outer, holes, options.edge_length)?),
        Domain::Boundaries(boundaries) => curved::check_film(boundaries, options)?,
        Domain::Bezier { .. } | Domain::Nurbs(_) => {}
    }
    if cost.nodes > MOST_NODES {
        let detail = format!("asks for up to {:.3e} nodes; at most {MOST_NODES:.0e} are possible", cost.nodes);
        return Err(Error::input(Place::field("edge_length"), detail));
    }
    Ok(cost)
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
    check(domain, options)?;
    let mut solved = match domain {
        Domain::Polygon { outer, holes } => on_polygon(outer, holes, options, execution),
        Domain::Bezier { control_points } => {
            let place = Place::field("domain").then("bezier");
            let patch = Nurbs::bezier(control_points.clone());
            on_surface(&Auxiliary::of_patch(&patch, &place, options)?, 0.0, options, execution)
        }
        Domain::Nurbs(patch) => {
            let place = Place::field("domain").then("nurbs");
            on_surface(&Auxiliary::of_patch(patch, &place, options)?, 0.0, options, execution)
        }
        Domain::Boundaries(boundaries) => {
            let film = Auxiliary::of_film(boundaries, options, (0.0, 0.4), execution)?;
            on_surface(&film, 0.4, options, execution)
        }
    }?;
    let (found, warning) = self_intersections::check(&solved.mesh, Order::Spatial, usize::MAX, execution)?;
    solved.statistics.self_intersections = found;
    solved.warnings.extend(warning);
    Ok(solved)
}
