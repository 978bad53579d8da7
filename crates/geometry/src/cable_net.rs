//! Cable nets without film: the shape in which the forces of all cables balance, from force densities or from targets.
//!
//! [`solve`] takes a [`Net`]: points, the cables between them, supports and loads. Without targets the force densities
//! give the shape by linear equations (Schek 1974). With forces and lengths that cables are to have, the densities are
//! found for which the shape comes nearest to them, in least squares and in exact equilibrium.
//!
//! ```
//! use plateau_geometry::cable_net::{Edge, Net, Options, solve};
//! use plateau_geometry::{DVec3, Execution};
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
//! # Ok::<(), plateau_geometry::Error>(())
//! ```
//!
//! Source: Schek, *The force density method for form finding and computation of general networks* (1974).

mod fitting;
mod options;
mod shape;

pub use fitting::StopReason;
pub use options::{Edge, Net, Options};

use crate::{DVec3, Error, Estimate, Execution};

/// A net in equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct CableNet {
    /// The vertices in the order of the input; supports at exactly the given coordinates.
    pub vertices: Vec<DVec3>,
    /// The force of each edge.
    pub forces: Vec<f64>,
    /// The length of each edge.
    pub lengths: Vec<f64>,
    /// The force density of each edge.
    pub densities: Vec<f64>,
    /// For each support of the input the force that it exerts on the net.
    pub reactions: Vec<DVec3>,
    /// The sum of all loads.
    pub loads: DVec3,
    /// |loads + reactions| over the sum of the reactions' magnitudes.
    pub imbalance: f64,
    /// The largest force on a free vertex that is not balanced.
    pub residual_force: f64,
    /// Σ F L.
    pub load_path: f64,
    /// Weighted sum of the mean squared relative deviations from the targets, and of the load path over that at the
    /// start; zero without targets.
    pub loss: f64,
    /// The largest derivative of the loss by a logarithm of a force density.
    pub gradient: f64,
    /// Number of steps.
    pub iterations: u32,
    /// Why fitting ended.
    pub stop_reason: StopReason,
}

/// Finds the shape of a net.
///
/// The result depends on nothing but the arguments, to the byte.
///
/// # Errors
/// [`Error::Input`] for what the arguments themselves show; [`Error::NoResult`] for a net whose equations are singular
/// to working precision; [`Error::Interrupted`] on cancel and deadline.
pub fn solve(net: &Net, options: &Options, exec: &Execution) -> Result<CableNet, Error> {
    check(net, options)?;
    let fitted = fitting::fit(net, options, exec)?;
    let at = fitted.vertices;
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
        // A support that is listed twice has its reaction once.
        reactions.push(-std::mem::take(&mut unbalanced[support as usize]));
    }
    let magnitudes: f64 = reactions.iter().map(|reaction| reaction.length()).sum();
    let sum: DVec3 = reactions.iter().sum::<DVec3>() + loads;
    Ok(CableNet {
        load_path: forces.iter().zip(&lengths).map(|(force, length)| force * length).sum(),
        vertices: at,
        forces,
        lengths,
        densities: fitted.densities,
        imbalance: sum.length() / magnitudes.max(f64::MIN_POSITIVE),
        residual_force: unbalanced.iter().map(|force| force.length()).fold(0.0, f64::max),
        reactions,
        loads,
        loss: fitted.loss,
        gradient: fitted.gradient,
        iterations: fitted.iterations,
        stop_reason: fitted.stop_reason,
    })
}

/// Checks the arguments of [`solve`] before any work: linear in the size of the net.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with.
pub fn check(net: &Net, options: &Options) -> Result<(), Error> {
    options::check(net, options)
}

/// Number of bytes of memory per edge: most of it for the factor of a step, with six unknowns at every vertex.
const BYTES_PER_EDGE: f64 = 8_000.0;

/// Estimates the memory that solving takes. A net has no triangles.
#[must_use]
pub fn estimate(net: &Net) -> Estimate {
    Estimate { triangles: 0.0, cells: 0, bytes: (net.edges.len() as f64 * BYTES_PER_EDGE) as u64 }
}
