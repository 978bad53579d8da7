//! Computes the statistics of a mesh, stage by stage.

use super::options::{Objective, Optimise, Options};
use super::plane::increment::SLACK;
use super::plane::mesh::PlaneMesh;
use super::report::{OutOfRange, Statistics, UniformMesh, Why};
use super::statistics::{self, Group, LengthHistogram, Stage};
use plateau_mesh::Mesh;
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::{Error, Warning};
use plateau_mesh::execution::{Execution, Progress};
use plateau_mesh::measure::{Spread, angle_range};

/// Distance of a length from [ℓ, 2ℓ] that counts as rounding, in ℓ: twice the slack of the insertion.
pub(crate) const RANGE_TOLERANCE: f64 = 2.0 * SLACK;

/// Whether a length, in units of ℓ, lies in [1, 2] up to [`RANGE_TOLERANCE`].
pub(crate) fn is_in_range(length: f64) -> bool {
    (1.0 - RANGE_TOLERANCE..=2.0 + RANGE_TOLERANCE).contains(&length)
}

/// Collects the statistics of the stages of a solve. Lengths are passed in units of ℓ.
pub(super) struct Table {
    pub target: f64,
    pub tolerance: f64,
    pub stages: Vec<Stage>,
}

impl Table {
    pub fn new(options: &Options) -> Self {
        Self { target: options.edge_length, tolerance: options.tolerance(), stages: Vec::new() }
    }

    pub fn row(&mut self, name: &'static str, lengths: &[f64], lattice: Option<&[bool]>) {
        let group = |lengths: Vec<f64>| Group::of(&lengths, self.target, self.tolerance);
        let all: Vec<f64> = lengths.iter().map(|length| length * self.target).collect();
        let lattice = lattice.map(|lattice| {
            group(all.iter().zip(lattice).filter(|&(_, &member)| member).map(|(&length, _)| length).collect())
        });
        self.stages.push(Stage { name, all: group(all), lattice });
    }
}

/// Marks the members that belong to the lattice group: they have the length ℓ in the plane and join two lattice points.
pub(super) fn lattice_group(members: &[[u32; 2]], flat: &PlaneMesh) -> Vec<bool> {
    let on_lattice: Vec<bool> =
        flat.points.iter().map(|&p| flat.lattice.is_some_and(|placement| placement.carries(p))).collect();
    members
        .iter()
        .map(|&[a, b]| {
            let (a, b) = (a as usize, b as usize);
            on_lattice[a] && on_lattice[b] && (flat.points[a].distance(flat.points[b]) - 1.0).abs() < 1e-6
        })
        .collect()
}

/// Makes the result of a solve from a finished mesh: computes its lengths and statistics.
pub(super) fn assemble(
    mesh: Mesh,
    members: Vec<[u32; 2]>,
    lattice_group: Vec<bool>,
    options: &Options,
    why: impl Fn(usize) -> Why,
) -> UniformMesh {
    let target = options.edge_length;
    let tolerance = options.tolerance();
    let position = |v: u32| mesh.vertices[v as usize];
    let lengths: Vec<f64> = members.iter().map(|&[a, b]| position(a).distance(position(b))).collect();
    // Far from the origin, lengths are only as accurate as the rounded coordinates.
    let largest = mesh.vertices.iter().map(|v| v.abs().max_element()).fold(0.0, f64::max);
    let slack = RANGE_TOLERANCE * target + 8.0 * f64::EPSILON * largest;
    let out_of_range: Vec<OutOfRange> = lengths
        .iter()
        .enumerate()
        .filter(|&(_, &length)| length < target - slack || length > 2.0 * (target + slack))
        .map(|(member, &length)| OutOfRange { member, length, why: why(member) })
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
        surface: None,
    };
    let mut warnings = Vec::new();
    if !out_of_range.is_empty() {
        let mut reasons: Vec<&str> = out_of_range.iter().map(|edge| edge.why.name()).collect();
        reasons.sort_unstable();
        reasons.dedup();
        let detail = format!("{} edges are outside [ℓ, 2ℓ]: {}", out_of_range.len(), reasons.join(", "));
        warnings.push(Warning::new(WarningCode::OutOfRange, detail).with_count("count", out_of_range.len()));
    }
    UniformMesh {
        mesh,
        members,
        lattice_group,
        lengths,
        statistics,
        stages: Vec::new(),
        shared_lengths: Vec::new(),
        out_of_range,
        input_vertices: Vec::new(),
        converged: true,
        warnings,
    }
}

/// Sets `converged`, and adds the warnings that do not depend on the kind of domain.
pub(super) fn finish(
    mut result: UniformMesh,
    interrupted: bool,
    shortfall: Option<String>,
    first: Vec<Warning>,
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    result.converged = !interrupted && shortfall.is_none();
    result.warnings.splice(0..0, first);
    if interrupted {
        let detail = "the deadline passed: edges may be longer than 2ℓ, nodes not yet optimal";
        result.warnings.push(Warning::new(WarningCode::NotConverged, detail));
    } else if let Some(detail) = shortfall {
        result.warnings.push(Warning::new(WarningCode::NotConverged, detail));
    } else if options.objective == Objective::MostEqualEdges && result.statistics.lattice_edges.count == 0 {
        let detail = "no lattice edge fits: the domain is too narrow for this length";
        result.warnings.push(Warning::new(WarningCode::NoLattice, detail));
    }
    if let (Optimise::Lengths { most }, Some(row)) = (options.optimise, result.shared_lengths.last())
        && 2.0 * row.deviation > result.statistics.length_tolerance
    {
        let detail = format!("{most} lengths stand for all members to {:.6e} only, see shared_lengths", row.deviation);
        let warning = Warning::new(WarningCode::LengthsNotReached, detail);
        result.warnings.push(warning.with_count("lengths", most).with("deviation", row.deviation));
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
