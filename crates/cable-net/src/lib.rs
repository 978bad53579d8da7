//! Form finding of cable nets without film: finds the shape in which the forces of all cables balance, from force
//! densities or from targets.
//!
//! [`solve`] takes a [`Net`]: points, the cables between them, supports and loads. Without targets the force densities
//! give the shape by linear equations (Schek 1974). If cables have target forces or lengths, the densities are fitted
//! in least squares so that the shape comes nearest to the targets, in exact equilibrium. Densities can also be held at
//! given values. Edges may be struts, which push: their forces and densities are negative, and the net may be a
//! tensegrity.
//!
//! ```
//! use plateau_cable_net::{Edge, Net, Options, solve};
//! use plateau_mesh::{DVec3, Execution};
//!
//! // Four cables from a point to four supports, two high and two low. One is to have the force 3.
//! let ends = [(0.0, 0.0, 2.0), (2.0, 0.0, 0.0), (2.0, 2.0, 2.0), (0.0, 2.0, 0.0)];
//! let mut vertices = vec![DVec3::ONE];
//! vertices.extend(ends.map(|(x, y, z)| DVec3::new(x, y, z)));
//! let edge = |k: u32| Edge { ends: [0, k], force: (k == 1).then_some(3.0), ..Edge::default() };
//! let net = Net { vertices, edges: (1..5).map(edge).collect(), supports: vec![1, 2, 3, 4], loads: Vec::new() };
//! let found = solve(&net, &Options::default(), &Execution::default())?;
//! assert!((found.forces[0] - 3.0).abs() < 1e-3);
//! assert!(found.residual_force < 1e-9);
//! # Ok::<(), plateau_mesh::Error>(())
//! ```
//!
//! Source: Schek, *The force density method for form finding and computation of general networks* (1974).

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
#![warn(missing_docs)]

mod fitted;
mod fitting;
mod loss;
mod options;
mod shape;
mod step;
mod struts;

pub use fitted::StopReason;
pub use options::{Edge, Net, Options};

use plateau_mesh::codes::Reason;
use plateau_mesh::{DVec3, Error, Estimate, Execution, InputError, Place, polyline};

/// A net in equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct CableNet {
    /// The vertices in the order of the input. Supports have exactly the given coordinates.
    pub vertices: Vec<DVec3>,
    /// The force of each edge, positive in tension.
    pub forces: Vec<f64>,
    /// The length of each edge.
    pub lengths: Vec<f64>,
    /// The force density of each edge.
    pub densities: Vec<f64>,
    /// The force that each support of the input exerts on the net.
    pub reactions: Vec<DVec3>,
    /// The sum of all loads.
    pub loads: DVec3,
    /// For each edge that is not held, whether its force is almost zero or its density is at the least density. The
    /// targets would need such a cable to push.
    pub slack: Vec<bool>,
    /// For each edge, whether its force or length deviates from a target by more than half of the target.
    pub missed: Vec<bool>,
    /// The sum of the magnitudes of the reactions.
    pub magnitudes: f64,
    /// The magnitude of the sum of all loads and reactions, divided by `magnitudes`.
    pub imbalance: f64,
    /// The largest unbalanced force on a free vertex.
    pub residual_force: f64,
    /// The load path Σ |F| L.
    pub load_path: f64,
    /// The sum of three weighted parts: the mean squared relative deviations of the forces from their targets, the same
    /// of the lengths, and the load path relative to its value at the start. It is 0 if the net has no targets and the
    /// load path has no weight.
    pub loss: f64,
    /// The largest derivative of the loss by the logarithm of a force density. For a net with struts also by the
    /// position of a vertex, measured in root mean square edge lengths.
    pub gradient: f64,
    /// Number of steps of the fitting.
    pub iterations: u32,
    /// Why fitting ended.
    pub stop_reason: StopReason,
}

/// Largest derivative of the loss at which a stalled net still counts as converged. The loss has no unit.
const STATIONARY: f64 = 1e-6;

impl CableNet {
    /// Whether the loss is at a minimum: fitting ended because the loss no longer falls, or stalled where its
    /// derivative almost vanishes. A net without targets always counts.
    #[must_use]
    pub fn converged(&self) -> bool {
        match self.stop_reason {
            StopReason::NoTargets | StopReason::Change => true,
            StopReason::Stalled => self.gradient <= STATIONARY,
            StopReason::MaxIterations | StopReason::Deadline => false,
        }
    }
}

/// Finds the shape of a net.
///
/// The result depends only on the arguments. It is the same to the byte on processors with the same vector
/// instructions.
///
/// # Errors
/// [`Error::Input`] for faults that the arguments themselves show. [`Error::NoResult`] if the equations are singular to
/// working precision, if the net collapses or grows without limit, or if the targets leave cables slack.
/// [`Error::Interrupted`] if the caller cancels. If a deadline passes, the shape of the last step is returned.
pub fn solve(net: &Net, options: &Options, exec: &Execution) -> Result<CableNet, Error> {
    check(net, options)?;
    // The shape is found relative to a support, because differences of coordinates lose digits far from zero.
    let origin = net.vertices[net.supports[0] as usize];
    let local = Net { vertices: net.vertices.iter().map(|p| *p - origin).collect(), ..net.clone() };
    let has_struts = net.edges.iter().any(|edge| edge.strut) && net.edges.iter().any(|edge| !edge.held);
    let fit = if has_struts { struts::fit } else { fitting::fit };
    let fitted = fit(&local, options, exec)?;
    let mut at: Vec<DVec3> = fitted.vertices.iter().map(|p| *p + origin).collect();
    for &support in &net.supports {
        at[support as usize] = net.vertices[support as usize];
    }
    let mut unbalanced: Vec<DVec3> = (0..at.len()).map(|v| net.load(v)).collect();
    let loads = unbalanced.iter().sum();
    let (mut forces, mut lengths) = (Vec::with_capacity(net.edges.len()), Vec::with_capacity(net.edges.len()));
    for (edge, q) in net.edges.iter().zip(&fitted.densities) {
        let [a, b] = edge.ends.map(|v| v as usize);
        let vector = at[b] - at[a];
        unbalanced[a] += *q * vector;
        unbalanced[b] -= *q * vector;
        lengths.push(vector.length());
        forces.push(q * vector.length());
    }
    let mut reactions = Vec::with_capacity(net.supports.len());
    for &support in &net.supports {
        // If a support is listed twice, only its first entry has the reaction; the second has zero.
        reactions.push(-std::mem::take(&mut unbalanced[support as usize]));
    }
    let magnitudes: f64 = reactions.iter().map(|reaction| reaction.length()).sum();
    let sum: DVec3 = reactions.iter().sum::<DVec3>() + loads;
    if !magnitudes.is_finite() || !at.iter().all(|p| p.is_finite()) || !forces.iter().all(|force| force.is_finite()) {
        return Err(Error::no_result(Reason::NoEquilibrium, "the loads and forces are too large for each other"));
    }
    let deviations = deviations(net, options, &forces, &lengths);
    if fitted.stop_reason != StopReason::NoTargets {
        refuse_vanishing(net, options, &lengths, &deviations)?;
    }
    refuse_collapsed(net, &lengths)?;
    let slack = fitting::slack_edges(net, options, &forces, &fitted.densities);
    refuse_slack(options, &slack)?;
    if fitted.stop_reason != StopReason::NoTargets {
        refuse_runaway(net, &lengths, &deviations)?;
    }
    Ok(CableNet {
        load_path: forces.iter().zip(&lengths).map(|(force, length)| force.abs() * length).sum(),
        missed: deviations.iter().map(|deviation| *deviation > loss::FAR).collect(),
        vertices: at,
        forces,
        lengths,
        densities: fitted.densities,
        imbalance: sum.length() / magnitudes.max(f64::MIN_POSITIVE),
        residual_force: unbalanced.iter().map(|force| force.length()).fold(0.0, f64::max),
        slack,
        reactions,
        magnitudes,
        loads,
        loss: fitted.loss,
        gradient: fitted.gradient,
        iterations: fitted.iterations,
        stop_reason: fitted.stop_reason,
    })
}

/// Maximum number of edges that an error names.
const NAMED_EDGES: usize = 50;
/// Length below which an edge counts as collapsed, as a fraction of the size of the input net.
const COLLAPSED: f64 = 1e-9;

/// Fails with `reason` and names the given edges, unless there are none.
fn refuse(reason: Reason, detail: &str, edges: &[usize], each: &str) -> Result<(), Error> {
    if edges.is_empty() {
        return Ok(());
    }
    let place = |&k: &usize| InputError::new(Place::field("edges").at(k), each);
    let places = edges.iter().take(NAMED_EDGES).map(place).collect();
    Err(Error::NoResult { reason, detail: detail.into(), places })
}

/// Refuses a shape in which edges have no length, such as a net without loads at a single support.
fn refuse_collapsed(net: &Net, lengths: &[f64]) -> Result<(), Error> {
    let least = COLLAPSED * polyline::radius(&net.vertices);
    let collapsed: Vec<usize> = (0..lengths.len()).filter(|&k| lengths[k] <= least).collect();
    let detail = "the net collapses: nothing holds the ends of some cables apart; add supports or loads";
    refuse(Reason::NoEquilibrium, detail, &collapsed, "has no length in equilibrium")
}

/// Refuses a shape in which cables have no force because the targets would need them to push.
fn refuse_slack(options: &Options, slack: &[bool]) -> Result<(), Error> {
    // With a least density, the caller has chosen the tension that slack cables keep.
    if options.least_density > 0.0 {
        return Ok(());
    }
    let slack: Vec<usize> = (0..slack.len()).filter(|&k| slack[k]).collect();
    let detail = "the targets leave some cables no force; change their targets, or give a least force density, which \
                  keeps every cable in tension";
    refuse(Reason::SlackCable, detail, &slack, "would be slack")
}

/// An edge longer than this shows that the net runs away from its targets. Multiple of the size of the input net plus
/// the sum of all target lengths.
const RUNAWAY: f64 = 20.0;
/// Relative deviation above which a target counts as missed. Only a net that misses a target is refused for its long
/// edges.
const MISSED: f64 = 1e-3;

/// Returns the largest relative deviation of each edge from its targets of positive weight, or 0 without such targets.
fn deviations(net: &Net, options: &Options, forces: &[f64], lengths: &[f64]) -> Vec<f64> {
    let off = |value: f64, target: Option<f64>, weight: f64| {
        target.filter(|_| weight > 0.0).map_or(0.0, |target| (value / target - 1.0).abs())
    };
    let largest = |((edge, force), length): ((&Edge, &f64), &f64)| {
        off(*force, edge.force, options.force_weight).max(off(*length, edge.length, options.length_weight))
    };
    net.edges.iter().zip(forces).zip(lengths).map(largest).collect()
}

/// An edge with a target of force that is shorter than this shows that the net draws together towards its targets.
/// Fraction of the edge's length in the given net. A hoop of twelve edges keeps 4e-4 of its length at a force 0.03 %
/// below the largest possible one, and 3e-8 at a force 0.2 % above it.
const VANISHING: f64 = 1e-4;

/// Refuses a net some of whose edges lose their length as it approaches its targets, because no net meets such targets.
fn refuse_vanishing(net: &Net, options: &Options, lengths: &[f64], deviations: &[f64]) -> Result<(), Error> {
    if options.force_weight == 0.0 || deviations.iter().all(|deviation| *deviation <= MISSED) {
        return Ok(());
    }
    let given = |edge: &Edge| {
        let [a, b] = edge.ends.map(|v| net.vertices[v as usize]);
        a.distance(b)
    };
    let is_short = |&k: &usize| {
        let edge = &net.edges[k];
        edge.force.is_some() && edge.length.is_none() && lengths[k] <= VANISHING * given(edge)
    };
    let short: Vec<usize> = (0..lengths.len()).filter(is_short).collect();
    let detail = "no net meets the targets: the nearer it comes to them, the shorter some edges become, down to nothing; \
                  give smaller forces to these edges, or larger ones to the edges that hold them apart";
    refuse(Reason::TargetsNotReached, detail, &short, "loses its length")
}

/// Refuses a net some of whose edges grow without limit as it approaches its targets, because no net meets such
/// targets.
fn refuse_runaway(net: &Net, lengths: &[f64], deviations: &[f64]) -> Result<(), Error> {
    let wanted: f64 = net.edges.iter().filter_map(|edge| edge.length).sum();
    let most = RUNAWAY * (polyline::radius(&net.vertices) + wanted);
    if deviations.iter().all(|deviation| *deviation <= MISSED) {
        return Ok(());
    }
    let long: Vec<usize> = (0..lengths.len()).filter(|&k| lengths[k] > most).collect();
    let detail = "no net meets the targets: the nearer it comes to them, the longer some edges become, without limit";
    refuse(Reason::TargetsNotReached, detail, &long, "grows without limit")
}

/// Checks the arguments of [`solve`] before any work, in a time that is nearly linear in the size of the net.
///
/// # Errors
/// The [`Error::Input`] with which [`solve`] would fail.
pub fn check(net: &Net, options: &Options) -> Result<(), Error> {
    options::check(net, options)
}

/// Memory per edge, in bytes. Together with [`BYTES_PER_ENTRY`] it makes an estimate of which grids of squares, walls
/// of bricks and grids in space take 70 % to 80 %.
const BYTES_PER_EDGE: f64 = 5_600.0;
/// Memory in bytes per entry of the factor of the equations with one unknown at a vertex. The system of a step has six
/// unknowns at a vertex, so its factor has 36 numbers of 8 bytes for each such entry, or fewer where its elimination
/// order is better.
const BYTES_PER_ENTRY: f64 = 330.0;

/// Memory per edge, in bytes, of a net whose densities are all held, which takes one linear solve. Measured: 520 to 730
/// bytes for grids of 3,000 to 45,000 edges, with the factor.
const BYTES_PER_HELD_EDGE: f64 = 600.0;
/// Memory of that solve in bytes besides that of its edges and its factor.
const BYTES_OF_SHAPE: f64 = 2e6;
/// Memory in bytes per entry of the factor of that solve.
const BYTES_PER_ENTRY_OF_SHAPE: f64 = 12.0;

/// Estimates the memory that solving takes, for a net that [`check`] accepts. A net has no triangles. The factor takes
/// most of the memory, and its size depends on how the edges join: a net in space takes twice as much per edge as a net
/// on a surface. The size is found by ordering the equations, which takes far less time than solving them.
#[must_use]
pub fn estimate(net: &Net) -> Estimate {
    let factor = shape::Shape::new(net).map(|shape| shape.factor_entries());
    let (first, an_edge, an_entry) = match net.edges.iter().all(|edge| edge.held) {
        true => (BYTES_OF_SHAPE, BYTES_PER_HELD_EDGE, BYTES_PER_ENTRY_OF_SHAPE),
        false => (0.0, BYTES_PER_EDGE, BYTES_PER_ENTRY),
    };
    let bytes = |entries: usize| first + net.edges.len() as f64 * an_edge + entries as f64 * an_entry;
    Estimate { triangles: 0.0, cells: 0, bytes: factor.map_or(u64::MAX, |entries| bytes(entries) as u64) }
}

/// Compiles and runs the example of the README as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
