//! Statistics of a cable net.

use crate::common::{ForceBalance, Point};
use plateau_archive::units::ForceUnit;
use plateau_cable_net as geometry;
use plateau_mesh::DVec3;
use plateau_mesh::measure::Spread;
use schemars::JsonSchema;
use serde::Serialize;

/// A group of a net's edges in statistics and files: the edges of a cable, or all edges that no cable lists.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    pub name: String,
    /// Numbers of its edges in increasing order.
    pub edges: Vec<usize>,
    pub axial_stiffness: Option<f64>,
}

/// Smallest and largest value.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct ValueRange {
    pub min: f64,
    pub max: f64,
}

impl ValueRange {
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let empty = Self { min: f64::INFINITY, max: f64::NEG_INFINITY };
        values.fold(empty, |range, value| Self { min: range.min.min(value), max: range.max.max(value) })
    }
}

/// A cable of the found net: all its edges together.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "NetCableResult")]
pub struct CableResult {
    pub name: String,
    /// Number of its edges.
    pub edges: usize,
    /// Mean force, weighted by length. Forces of struts are negative.
    pub force: f64,
    pub force_min: f64,
    pub force_max: f64,
    /// Sum of the edges' lengths.
    pub length: f64,
    /// Sum of the edges' unstressed lengths, length / (1 + force / axial stiffness) each; null without an axial
    /// stiffness, or if a strut's force exceeds it.
    pub unstressed_length: Option<f64>,
    /// Axial stiffness of the request, a force; null without one.
    pub axial_stiffness: Option<f64>,
    pub edge_lengths: ValueRange,
    pub force_densities: ValueRange,
    /// Largest |force / target - 1|; null without a target.
    pub force_deviation: Option<f64>,
    /// Largest |length / target - 1|; null without a target.
    pub length_deviation: Option<f64>,
    /// Number of edges to which the targets leave no force, so that only `least_force_density` keeps them in tension.
    pub slack_edges: usize,
}

/// A support of the net.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct NetReaction {
    pub vertex: u32,
    /// Force of the support on the net.
    pub force: Point,
}

/// Statistics of a cable net.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct CableNetStatistics {
    /// Middle of the net's bounding box, which files with `origin=local` are relative to.
    pub origin: Point,
    pub objective: &'static str,
    /// Loss: the weighted sum of the mean squared relative deviations of the forces and of the lengths from their
    /// targets, and of the load path relative to its value at the start. 0 if there are no targets and the load path
    /// has no weight.
    pub objective_value: f64,
    /// Unit of the forces.
    pub force_unit: &'static str,
    pub vertices: usize,
    pub edges: usize,
    /// Always 0: a net has no triangles.
    pub triangles: usize,
    /// Cables in the order of the request, and `other` for edges that no cable lists.
    pub cables: Vec<CableResult>,
    /// Supports in the order of the request.
    pub reactions: Vec<NetReaction>,
    pub balance: ForceBalance,
    /// Σ |force| · length.
    pub load_path: f64,
    /// Largest force on a free vertex that is not balanced, over the largest force of an edge.
    pub residual: f64,
    /// Largest derivative of the loss by the logarithm of a force density.
    pub gradient: f64,
    pub converged: bool,
    pub stop_reason: &'static str,
    pub iterations: u32,
    pub edge_lengths: Spread,
}

impl CableNetStatistics {
    #[must_use]
    pub fn of(
        found: &geometry::CableNet,
        net: &geometry::Net,
        groups: &[Group],
        force: ForceUnit,
        origin: Point,
    ) -> Self {
        let reaction = |(vertex, force): (&u32, &DVec3)| NetReaction { vertex: *vertex, force: force.to_array() };
        let largest = found.forces.iter().fold(f64::MIN_POSITIVE, |largest, force| largest.max(force.abs()));
        Self {
            origin,
            objective: "nearest_to_targets",
            objective_value: found.loss,
            force_unit: force.symbol(),
            vertices: found.vertices.len(),
            edges: net.edges.len(),
            triangles: 0,
            cables: groups.iter().map(|group| CableResult::of(found, net, group)).collect(),
            reactions: net.supports.iter().zip(&found.reactions).map(reaction).collect(),
            balance: ForceBalance {
                loads: found.loads.to_array(),
                reactions: found.reactions.iter().sum::<DVec3>().to_array(),
                magnitudes: found.magnitudes,
                imbalance: found.imbalance,
                residual_force: found.residual_force,
            },
            load_path: found.load_path,
            residual: found.residual_force / largest,
            gradient: found.gradient,
            converged: found.converged(),
            stop_reason: found.stop_reason.name(),
            iterations: found.iterations,
            edge_lengths: Spread::of(found.lengths.iter().copied()),
        }
    }
}

impl CableResult {
    fn of(found: &geometry::CableNet, net: &geometry::Net, group: &Group) -> Self {
        let edges = || group.edges.iter().copied();
        let length: f64 = edges().map(|k| found.lengths[k]).sum();
        let path: f64 = edges().map(|k| found.forces[k] * found.lengths[k]).sum();
        let forces = ValueRange::of(edges().map(|k| found.forces[k]));
        let deviation = |values: &[f64], target: fn(&geometry::Edge) -> Option<f64>| {
            let relative = |k: usize| Some((values[k] / target(&net.edges[k])? - 1.0).abs());
            edges().filter_map(relative).reduce(f64::max)
        };
        Self {
            name: group.name.clone(),
            edges: group.edges.len(),
            force: path / length,
            force_min: forces.min,
            force_max: forces.max,
            length,
            unstressed_length: group.axial_stiffness.and_then(|stiffness| {
                let stretch = |k: usize| 1.0 + found.forces[k] / stiffness;
                edges().all(|k| stretch(k) > 0.0).then(|| edges().map(|k| found.lengths[k] / stretch(k)).sum())
            }),
            axial_stiffness: group.axial_stiffness,
            edge_lengths: ValueRange::of(edges().map(|k| found.lengths[k])),
            force_densities: ValueRange::of(edges().map(|k| found.densities[k])),
            force_deviation: deviation(&found.forces, |edge| edge.force),
            length_deviation: deviation(&found.lengths, |edge| edge.length),
            slack_edges: edges().filter(|&k| found.slack[k]).count(),
        }
    }
}
