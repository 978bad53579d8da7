//! The statistics of a film: size, shape, curvature, residual, and how the solver got there.

use super::curvature::Curvature;
use super::initial_mesh::InitialMeshKind;
use super::junction_statistics::JunctionStatistics;
use super::options::{Objective, Options, Solver};
use super::run::{ExtrapolatedArea, HistoryRow, Run, SpanningComparison, Stability, meets_its_rule};
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::Warning;
use plateau_mesh::film::Film;
use plateau_mesh::measure::{self, Quality};
use plateau_mesh::remesh::thin_triangles::Pinch;
use plateau_mesh::topology::Topology;

/// Mean curvature over the vertices that are free to move, in 1/unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MeanCurvature {
    /// The largest.
    pub max: f64,
    /// The mean.
    pub mean: f64,
    /// The root of the mean square.
    pub rms: f64,
}

/// The statistics of a minimal surface. Lengths are in the caller's unit u, areas in u², angles in radians.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// The objective that was minimised.
    pub objective: Objective,
    /// The value of the objective, in its own unit.
    pub objective_value: f64,
    /// The solver that ran.
    pub solver: Solver,
    /// The initial mesh that was built (never "auto").
    pub initial_mesh: InitialMeshKind,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Number of boundary loops.
    pub boundary_loops: usize,
    /// Number of connected components.
    pub components: usize,
    /// Vertices minus edges plus triangles.
    pub euler_characteristic: i64,
    /// Total genus of the components; `None` for films with junctions, which are no manifolds.
    pub genus: Option<i64>,
    /// Area of the mesh, in u².
    pub area: f64,
    /// Area of the initial mesh, in u².
    pub initial_area: f64,
    /// Estimate of the area of the smooth surface on the same polygon, from this mesh and a mesh with twice or half its
    /// edge length. It is computed for stable surfaces of the default solver: always up to 10,000 triangles, and above
    /// that if the boundary has enough points for a coarser mesh.
    pub extrapolated_area: Option<ExtrapolatedArea>,
    /// Mean curvature over the vertices that are free to move.
    pub mean_curvature: MeanCurvature,
    /// The residual of the normal direction: the largest H⊥ R over the free vertices, with H⊥ = |g·n| / (2 A_h). Here g
    /// is the area gradient, n the vertex normal, A_h a third of the area of the vertex's triangles, and R the largest
    /// distance of a boundary vertex from the mean of the boundary vertices. Dimensionless.
    pub residual: f64,
    /// The residual with the whole gradient in place of its normal part.
    pub residual_full: f64,
    /// Whether the solver met its own rule, the mean curvature is within [`Options::curvature_tolerance`], and no
    /// triangle is flipped or degenerate. The rule of the default solver is that the residual is at most the tolerance.
    pub converged: bool,
    /// Why the solver stopped.
    pub stop_reason: StopReason,
    /// Number of iterations.
    pub iterations: u32,
    /// The recorded iterations. Long runs keep every iteration up to 100, every 10th up to 1000, every 100th beyond,
    /// and the last.
    pub history: Vec<HistoryRow>,
    /// Whether the mesh is finer than was asked for, because a neck needed it.
    pub refined: bool,
    /// The second variation of area; `None` where it was not computed.
    pub stability: Option<Stability>,
    /// Edge lengths, angles, flipped and degenerate triangles.
    pub quality: Quality,
    /// Number of edges that the solver flipped.
    pub edges_swapped: u64,
    /// The changes of topology, in order.
    pub pinches: Vec<Pinch>,
    /// The comparison of the ways to span the boundaries, under [`TopologyRule::Best`](super::TopologyRule::Best).
    pub spanning: Option<SpanningComparison>,
    /// The junctions of a film whose sheets meet three by three along curves.
    pub junctions: Option<JunctionStatistics>,
}

impl MeanCurvature {
    /// Returns the figures of the free vertices; all are zero if there is no free vertex.
    pub(super) fn of(free: impl Iterator<Item = f64> + Clone) -> Self {
        let count = free.clone().count().max(1) as f64;
        Self {
            max: free.clone().fold(0.0, f64::max),
            mean: free.clone().sum::<f64>() / count,
            rms: (free.map(|h| h * h).sum::<f64>() / count).sqrt(),
        }
    }
}

impl Statistics {
    /// Returns the warning that the surface does not count as converged, with the reasons. `residual_felt` is the
    /// residual that the solvers compare with their tolerance (see [`Curvature`]).
    pub(super) fn not_converged(&self, residual_felt: f64, options: &Options) -> Warning {
        let tolerance = options.tolerance;
        let mut reasons = Vec::new();
        if !meets_its_rule(self.solver, self.stop_reason, residual_felt, tolerance) {
            let residual = || format!("the residual is {:.3e}, the tolerance {tolerance:.3e}", self.residual);
            reasons.push(match self.solver {
                Solver::Newton => residual(),
                Solver::PinkallPolthier => residual() + ", and the area still changes by more than its tolerance",
                Solver::VertexRelaxation => "the area still changes by more than its tolerance".to_owned(),
                Solver::LevenbergMarquardt => "the least squares still change by more than their tolerance".to_owned(),
            });
        }
        if let Some(bound) = missed_curvature(self.mean_curvature.max, options) {
            let largest = self.mean_curvature.max;
            reasons.push(format!(
                "the largest mean curvature is {largest:.3e}, the curvature tolerance {bound:.3e}: ask for \
                 another resolution or a larger tolerance"
            ));
        }
        if self.quality.flipped_triangles > 0 {
            reasons.push(format!("{} triangles are folded over", self.quality.flipped_triangles));
        }
        if self.quality.degenerate_triangles > 0 {
            reasons.push(format!("{} triangles are degenerate", self.quality.degenerate_triangles));
        }
        let detail = format!("{}; it stopped for the reason {}", reasons.join(", "), self.stop_reason.name());
        Warning::new(WarningCode::NotConverged, detail)
            .with("residual", self.residual)
            .with("tolerance", tolerance)
            .with_count("flipped_triangles", self.quality.flipped_triangles)
            .with_count("degenerate_triangles", self.quality.degenerate_triangles)
    }
}

/// Returns the bound on the mean curvature of a film of least area if the `largest` one is above it.
fn missed_curvature(largest: f64, options: &Options) -> Option<f64> {
    options.curvature_tolerance.filter(|&bound| options.method.objective() == Objective::MinimalArea && largest > bound)
}

/// Facts about the origin of a film, which the film itself does not show.
pub(super) struct Origin {
    pub kind: InitialMeshKind,
    pub initial_area: f64,
    pub run: Run,
}

/// Facts about the mesh of a film, with or without junctions.
pub(super) struct Facts {
    pub vertices: usize,
    pub triangles: usize,
    pub boundary_loops: usize,
    pub components: usize,
    pub euler_characteristic: i64,
    pub genus: Option<i64>,
    pub area: f64,
    pub mean_curvature: MeanCurvature,
    pub residual: f64,
    pub residual_full: f64,
    pub quality: Quality,
    pub junctions: Option<JunctionStatistics>,
}

impl Facts {
    pub fn of_film(film: &Film, topology: &Topology, measured: &Curvature) -> Self {
        let mesh = film.mesh();
        let lengths = measure::edge_lengths(&mesh, topology);
        let free = film.fixed.iter().zip(&measured.mean_curvature).filter(|(fixed, _)| !**fixed);
        Self {
            vertices: mesh.vertices.len(),
            triangles: mesh.triangles.len(),
            boundary_loops: topology.boundary_loops().len(),
            components: topology.components(),
            euler_characteristic: topology.euler_characteristic(),
            genus: Some(topology.genus()),
            area: measure::area(&mesh),
            mean_curvature: MeanCurvature::of(free.map(|(_, curvature)| *curvature)),
            residual: measured.residual,
            residual_full: measured.residual_full,
            quality: Quality::of(&mesh, &lengths, measure::flipped_triangles(&mesh)),
            junctions: None,
        }
    }
}

/// Assembles the statistics of a film. `rule_met` says whether the solver has met its own rule.
pub(super) fn collect(facts: Facts, rule_met: bool, origin: Origin, options: &Options) -> Statistics {
    let Origin { kind, initial_area, run } = origin;
    let within = missed_curvature(facts.mean_curvature.max, options).is_none();
    let converged = rule_met && within && facts.quality.is_sound();
    Statistics {
        objective: options.method.objective(),
        objective_value: run.objective_value.unwrap_or(facts.area),
        solver: run.solver,
        initial_mesh: kind,
        vertices: facts.vertices,
        triangles: facts.triangles,
        boundary_loops: facts.boundary_loops,
        components: facts.components,
        euler_characteristic: facts.euler_characteristic,
        genus: facts.genus,
        area: facts.area,
        initial_area,
        extrapolated_area: run.extrapolated_area,
        mean_curvature: facts.mean_curvature,
        residual: facts.residual,
        residual_full: facts.residual_full,
        converged,
        // The residual does not show flipped or degenerate triangles. A run that ended by its residual on a mesh with
        // such triangles counts as stalled.
        stop_reason: match run.stop_reason {
            StopReason::Residual if !converged => StopReason::Stalled,
            other => other,
        },
        iterations: run.iterations,
        history: run.history,
        refined: run.refined,
        stability: run.stability,
        quality: facts.quality,
        edges_swapped: run.edges_swapped,
        pinches: run.pinches,
        spanning: run.spanning,
        junctions: facts.junctions,
    }
}
