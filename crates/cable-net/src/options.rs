//! The caller's description of a cable net, the options, and the checks of both.

use plateau_mesh::disjoint_sets::DisjointSets;
use plateau_mesh::error::InputError;
use plateau_mesh::polyline::LARGEST_COORDINATE;
use plateau_mesh::{DVec3, Error, Place};

/// Points that are joined by cables.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Net {
    /// The points. Supports stay where they are; form finding begins with the others at these positions.
    pub vertices: Vec<DVec3>,
    /// The cables between them.
    pub edges: Vec<Edge>,
    /// The vertices that do not move.
    pub supports: Vec<u32>,
    /// The load on each vertex, or an empty list if there are no loads. A load on a support only changes its reaction.
    pub loads: Vec<DVec3>,
}

/// A cable or a strut between two vertices, with its targets. The densities and forces of struts are negative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Edge {
    /// The two vertices.
    pub ends: [u32; 2],
    /// Whether the edge is a strut, which pushes. Cables pull.
    pub strut: bool,
    /// The force density q = force / length with which fitting begins. Without targets the result has this density.
    pub density: Option<f64>,
    /// Whether fitting keeps the given density unchanged.
    pub held: bool,
    /// The target of the edge's force.
    pub force: Option<f64>,
    /// The target of the edge's length.
    pub length: Option<f64>,
}

/// Options of form finding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Weight of the mean squared deviation (F / F* - 1)² of the forces F from their targets F*.
    pub force_weight: f64,
    /// Weight of the mean squared deviation (L / L* - 1)² of the lengths L from their targets L*.
    pub length_weight: f64,
    /// Weight of the load path Σ |F| L, which is divided by its value at the start. With 0 the load path is left out.
    pub load_path_weight: f64,
    /// Lower bound of the magnitude of every force density that is not held. With a bound above 0 no cable goes slack.
    pub least_density: f64,
    /// Fitting ends when three steps in a row each lower the loss by at most this fraction of its value.
    pub tolerance: f64,
    /// Maximum number of steps. `None` means 200, plus another 200 if fitting starts a second time; for a net with
    /// struts it means 1000.
    pub max_iterations: Option<u32>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            force_weight: 1.0,
            length_weight: 1.0,
            load_path_weight: 0.0,
            least_density: 0.0,
            tolerance: 1e-4,
            max_iterations: None,
        }
    }
}

impl Net {
    /// The load on a vertex.
    #[must_use]
    pub fn load(&self, v: usize) -> DVec3 {
        self.loads.get(v).copied().unwrap_or_default()
    }
}

/// Adds an error unless this holds. The place and the text are made only for an error, because a net has hundreds of
/// thousands of values.
fn require<D: Into<String>>(
    errors: &mut Vec<InputError>,
    holds: bool,
    place: impl FnOnce() -> Place,
    detail: impl FnOnce() -> D,
) {
    if !holds {
        InputError::new(place(), detail()).add_to(errors);
    }
}

/// Checks a net and the options, in a time that is nearly linear in the size of the net.
pub(super) fn check(net: &Net, options: &Options) -> Result<(), Error> {
    let mut errors = Vec::new();
    let count = net.vertices.len();
    let usable = |p: &DVec3| p.is_finite() && p.abs().max_element() <= LARGEST_COORDINATE;
    let coordinate = || "every coordinate must be a finite number of magnitude at most 1e50";
    for (k, p) in net.vertices.iter().enumerate() {
        require(&mut errors, usable(p), || Place::field("vertices").at(k), coordinate);
    }
    for (k, load) in net.loads.iter().enumerate() {
        require(&mut errors, usable(load), || Place::field("loads").at(k), coordinate);
    }
    let loaded = net.loads.is_empty() || net.loads.len() == count;
    require(&mut errors, loaded, || Place::field("loads"), || "needs one load for each vertex, or none at all");
    for (k, &support) in net.supports.iter().enumerate() {
        let detail = || format!("there are {count} vertices, numbered from 0");
        require(&mut errors, (support as usize) < count, || Place::field("supports").at(k), detail);
    }
    let positive = |value: f64| value.is_finite() && value > 0.0;
    for (k, edge) in net.edges.iter().enumerate() {
        let place = || Place::field("edges").at(k);
        for (i, &end) in edge.ends.iter().enumerate() {
            let detail = || format!("there are {count} vertices, numbered from 0");
            require(&mut errors, (end as usize) < count, || place().then("ends").at(i), detail);
        }
        require(
            &mut errors,
            edge.ends[0] != edge.ends[1],
            || place().then("ends"),
            || "must be two different vertices",
        );
        let (sign, detail) = match edge.strut {
            false => (1.0, "must be a finite number above 0, because a cable only pulls"),
            true => (-1.0, "must be a finite number below 0, because a strut only pushes"),
        };
        for (name, value) in [("density", edge.density), ("force", edge.force)] {
            require(&mut errors, value.is_none_or(|value| positive(sign * value)), || place().then(name), || detail);
        }
        let sound = edge.length.is_none_or(positive);
        require(&mut errors, sound, || place().then("length"), || "must be a finite number above 0");
        if let Some(density) = edge.density {
            let detail = || format!("must be above least_density ({}) in magnitude", options.least_density);
            let above = edge.held || density.abs() > options.least_density;
            require(&mut errors, above, || place().then("density"), detail);
        }
        let held = !edge.held || edge.density.is_some();
        require(&mut errors, held, || place().then("density"), || "is needed to be held");
    }
    require(&mut errors, !net.edges.is_empty(), || Place::field("edges"), || "must not be empty");
    for (name, value) in [
        ("force_weight", options.force_weight),
        ("length_weight", options.length_weight),
        ("load_path_weight", options.load_path_weight),
        ("least_density", options.least_density),
        ("tolerance", options.tolerance),
    ] {
        let sound = value.is_finite() && value >= 0.0;
        require(&mut errors, sound, || Place::field(name), || "must be a finite number, not negative");
    }
    if errors.is_empty() {
        check_edges(net, &mut errors);
        check_supports(net, &mut errors);
    }
    if errors.is_empty() {
        check_loose_ends(net, &mut errors);
    }
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

/// Vertices closer than this fraction of the net's size count as the same point.
const SAME_POINT: f64 = 1e-9;

/// Adds errors for edges without length, for edges that repeat another, and for target lengths that an edge between two
/// supports cannot have.
fn check_edges(net: &Net, errors: &mut Vec<InputError>) {
    let bounds = |(low, high): (DVec3, DVec3), p: &DVec3| (low.min(*p), high.max(*p));
    let (low, high) = net.vertices.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), bounds);
    let same = SAME_POINT * low.distance(high);
    let mut held = vec![false; net.vertices.len()];
    net.supports.iter().for_each(|&v| held[v as usize] = true);
    let mut seen: Vec<([u32; 2], usize)> = Vec::with_capacity(net.edges.len());
    for (k, edge) in net.edges.iter().enumerate() {
        let [a, b] = edge.ends;
        let place = || Place::field("edges").at(k);
        let distance = net.vertices[a as usize].distance(net.vertices[b as usize]);
        let apart = distance > same;
        require(errors, apart, place, || format!("has no length: vertices {a} and {b} are at the same point"));
        seen.push(([a.min(b), a.max(b)], k));
        let Some(length) = edge.length.filter(|_| apart && held[a as usize] && held[b as usize]) else { continue };
        let fits = (length - distance).abs() <= SAME_POINT * distance;
        let fault = if length > distance { "the cable would be slack" } else { "it is shorter than the chord" };
        let detail = || format!("{fault}: both ends are supports, {distance} apart");
        require(errors, fits, || place().then("length"), detail);
    }
    seen.sort_unstable();
    for pair in seen.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        let detail = || format!("joins the same two vertices as edge {}", pair[0].1);
        require(errors, false, || Place::field("edges").at(pair[1].1), detail);
    }
}

/// Adds an error for each vertex that moves freely because only one cable and no load acts on it. The cable of such a
/// vertex is not counted at its other end, so every vertex of a loose chain is found.
fn check_loose_ends(net: &Net, errors: &mut Vec<InputError>) {
    let count = net.vertices.len();
    let mut cables: Vec<Vec<u32>> = vec![Vec::new(); count];
    for edge in &net.edges {
        let [a, b] = edge.ends;
        cables[a as usize].push(b);
        cables[b as usize].push(a);
    }
    let mut left: Vec<usize> = cables.iter().map(Vec::len).collect();
    let mut stays: Vec<bool> = (0..count).map(|v| net.load(v) != DVec3::ZERO).collect();
    net.supports.iter().for_each(|&v| stays[v as usize] = true);
    let mut loose: Vec<usize> = (0..count).filter(|&v| left[v] < 2 && !stays[v]).collect();
    let mut free = Vec::new();
    // At most one pass per vertex, because a vertex is added either at the start or when its number of cables falls to
    // 1.
    while let Some(v) = loose.pop() {
        free.push(v);
        stays[v] = true;
        for &other in &cables[v] {
            let other = other as usize;
            left[other] -= 1;
            if left[other] == 1 && !stays[other] {
                loose.push(other);
            }
        }
    }
    free.sort_unstable();
    for v in free {
        let detail = || "moves freely: a single cable and no load acts on it";
        require(errors, false, || Place::field("vertices").at(v), detail);
    }
}

/// Adds an error for each vertex that no chain of cables joins to a support, because it moves freely.
fn check_supports(net: &Net, errors: &mut Vec<InputError>) {
    let mut parts = DisjointSets::new(net.vertices.len());
    net.edges.iter().for_each(|edge| parts.join(edge.ends[0], edge.ends[1]));
    let mut held = vec![false; net.vertices.len()];
    net.supports.iter().for_each(|&support| held[parts.leader(support) as usize] = true);
    for v in 0..net.vertices.len() {
        let is_held = held[parts.leader(v as u32) as usize];
        let detail = || "moves freely: no cables join it to a support";
        require(errors, is_held, || Place::field("vertices").at(v), detail);
    }
}
