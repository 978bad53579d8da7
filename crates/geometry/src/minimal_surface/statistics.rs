//! What is reported about a film: size, shape, curvature, residual, and how the solver got there.

use super::extrapolation::ExtrapolatedArea;
use super::film::{Film, Run};
use super::spanning_topology::SpanningComparison;
use super::triple_junction::JunctionStatistics;
use super::{InitialMeshKind, Objective, Options, Solver};
use crate::DVec3;
use crate::mesh::measure::{self, Spread};
use crate::mesh::topology::Topology;

/// Why a solver stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The residual fell to the tolerance.
    Residual,
    /// The area changed by less than its tolerance (the papers' own rule).
    AreaChange,
    /// A neck closed, and the run was asked to end there.
    TopologyChange,
    /// The one linear system of the objective is solved.
    Solved,
    /// There is no vertex to move.
    NothingToMove,
    /// The objective, its gradient or the step's length fell below Liu and Wang's criteria.
    ObjectiveChange,
    Gradient,
    StepLength,
    MaxIterations,
    /// No step gains any more, although the residual is above the tolerance: a fold is in the way, or rounding is reached.
    Stalled,
    /// A part of the mesh has shrunk so far that its linear system has no trustworthy solution.
    Collapsed,
    Deadline,
}

impl StopReason {
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Residual => "residual",
            Self::AreaChange => "area_change",
            Self::TopologyChange => "topology_change",
            Self::Solved => "solved",
            Self::NothingToMove => "nothing_to_move",
            Self::ObjectiveChange => "objective_change",
            Self::Gradient => "gradient",
            Self::StepLength => "step_length",
            Self::MaxIterations => "max_iterations",
            Self::Stalled => "stalled",
            Self::Collapsed => "collapsed",
            Self::Deadline => "deadline",
        }
    }
}

/// One iteration as it is remembered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HistoryRow {
    pub phase: &'static str,
    pub iteration: u32,
    pub area: f64,
    pub residual: f64,
}

/// A change of topology: where a neck closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinch {
    pub iteration: u32,
    pub place: DVec3,
    /// What happened there: `split` (a component became two), `handle_cut` (it stayed one), `closed_component_removed`.
    pub what: &'static str,
}

/// The second variation of area under normal motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// Whether the Morse index is 0: a true local minimum.
    pub stable: bool,
    /// Number of negative eigenvalues.
    pub morse_index: usize,
    /// Lowest eigenvalue against the lumped mass, in 1/unit².
    pub lowest_eigenvalue: f64,
    pub method: StabilityMethod,
}

/// Where a Morse index comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StabilityMethod {
    /// The signs of the pivots of a factorisation: exact.
    Inertia,
    /// The lowest eigenvalue, by preconditioned iteration: on meshes too large to factorise in good time, and then only where
    /// it is positive, so that the index is 0.
    Eigenvalue,
}

impl StabilityMethod {
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Inertia => "inertia",
            Self::Eigenvalue => "eigenvalue",
        }
    }
}

/// Mean curvature over the vertices that are free to move, in 1/unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeanCurvature {
    pub max: f64,
    pub mean: f64,
    pub rms: f64,
}

/// Everything that is reported about a minimal surface. Lengths in the caller's unit u, areas in u², angles in radians.
#[derive(Clone, Debug, PartialEq)]
pub struct Statistics {
    pub objective: Objective,
    pub objective_value: f64,
    /// The solver that ran (never [`Solver::Auto`]).
    pub solver: Solver,
    /// The initial mesh that was built (never "auto").
    pub initial_mesh: InitialMeshKind,
    pub vertices: usize,
    pub triangles: usize,
    pub boundary_loops: usize,
    pub components: usize,
    pub euler_characteristic: i64,
    pub genus: i64,
    pub area: f64,
    pub initial_area: f64,
    /// The area of the smooth surface on the same polygon, from this mesh and one of twice or half its edges. For stable surfaces of the
    /// default solver: up to 10,000 triangles always, above where the boundary's points leave room for a coarser mesh.
    pub extrapolated_area: Option<ExtrapolatedArea>,
    pub mean_curvature: MeanCurvature,
    /// max over the free vertices of H⊥ R: H⊥ = |g·n| / (2 A_h), g the area gradient, n the vertex normal, A_h a third of
    /// the ring's area, R the largest distance of a boundary vertex from their mean. Dimensionless.
    pub residual: f64,
    /// The same with the whole gradient, tangential part included.
    pub residual_full: f64,
    /// residual <= tolerance, and no triangle flipped or degenerate.
    pub converged: bool,
    pub stop_reason: StopReason,
    pub iterations: u32,
    /// One row per iteration; of long runs every iteration to 100, every 10th to 1000, every 100th beyond, and the last.
    pub history: Vec<HistoryRow>,
    pub stability: Option<Stability>,
    pub edge_lengths: Spread,
    pub smallest_angle: f64,
    pub largest_angle: f64,
    pub edges_swapped: u64,
    pub flipped_triangles: usize,
    pub degenerate_triangles: usize,
    pub pinches: Vec<Pinch>,
    /// Under [`Topology::Best`](super::Topology::Best): the films over the boundaries that were compared.
    pub spanning: Option<SpanningComparison>,
    /// Of a film with junctions: sheets that meet three by three along curves.
    pub junctions: Option<JunctionStatistics>,
}

impl Statistics {
    /// Why the surface does not count as converged, for a person.
    #[must_use]
    pub fn shortfall(&self, tolerance: f64) -> String {
        let mut reasons = Vec::new();
        if self.residual.is_nan() || self.residual > tolerance {
            reasons.push(format!("the residual is {:.3e}, the tolerance {tolerance:.3e}", self.residual));
        }
        if self.flipped_triangles > 0 {
            reasons.push(format!("{} triangles are folded over", self.flipped_triangles));
        }
        if self.degenerate_triangles > 0 {
            reasons.push(format!("{} triangles are degenerate", self.degenerate_triangles));
        }
        format!("{}; it stopped for the reason {}", reasons.join(", "), self.stop_reason.name())
    }
}

/// Mean curvature and residuals of a film, vertex by vertex.
#[derive(Clone, Debug)]
pub struct Curvature {
    /// Per vertex |g| / (2 A_h), in 1/unit; 0 where the vertex is fixed.
    pub mean_curvature: Vec<f64>,
    pub residual: f64,
    pub residual_full: f64,
}

impl Curvature {
    /// One pass over the triangles and one over the vertices.
    pub(super) fn of(film: &Film) -> Self {
        let count = film.vertices.len();
        let mut gradient = vec![DVec3::ZERO; count];
        let mut normal = vec![DVec3::ZERO; count];
        for &triangle in film.triangles() {
            let [a, b, c] = film.corners(triangle);
            let double_area = (b - a).cross(c - a);
            let unit = double_area.normalize_or_zero();
            // The area grows fastest when a corner moves away from the opposite edge, at half that edge's length.
            let pull = [(c - b), (a - c), (b - a)].map(|edge| 0.5 * unit.cross(edge));
            for (vertex, pull) in triangle.into_iter().zip(pull) {
                gradient[vertex as usize] += pull;
                normal[vertex as usize] += double_area;
            }
        }
        let mut ring_area = vec![0.0; count];
        for &triangle in film.triangles() {
            let area = 0.5 * measure::double_area_vector(film.corners(triangle)).length();
            triangle.into_iter().for_each(|vertex| ring_area[vertex as usize] += area);
        }
        let radius = film.radius();
        let mut result = Self { mean_curvature: vec![0.0; count], residual: 0.0, residual_full: 0.0 };
        for v in (0..count).filter(|&v| !film.fixed[v]) {
            let double_share = 2.0 / 3.0 * ring_area[v];
            // A vertex whose whole ring has no area is as far from converged as can be.
            let over_share = |pull: f64| if double_share > 0.0 { pull / double_share } else { f64::MAX.sqrt() };
            let full = over_share(gradient[v].length());
            result.mean_curvature[v] = full;
            result.residual_full = result.residual_full.max(full * radius);
            let along_normal = gradient[v].dot(normal[v].normalize_or_zero()).abs();
            result.residual = result.residual.max(over_share(along_normal) * radius);
        }
        result
    }
}

/// What [`collect`] cannot see on the film itself.
pub(super) struct Origin {
    pub kind: InitialMeshKind,
    pub initial_area: f64,
    pub run: Run,
}

pub(super) fn collect(
    film: &Film,
    topology: &Topology,
    measured: &Curvature,
    origin: Origin,
    options: &Options,
) -> Statistics {
    let mesh = film.mesh();
    let area = measure::area(&mesh);
    let free = film.fixed.iter().filter(|fixed| !**fixed).count();
    let over_free = |sum: f64| if free == 0 { 0.0 } else { sum / free as f64 };
    let curvature = &measured.mean_curvature;
    let (smallest_angle, largest_angle) = measure::angle_range(&mesh);
    let flipped_triangles = measure::flipped_triangles(&mesh);
    let degenerate_triangles = measure::degenerate_triangles(&mesh);
    let Origin { kind, initial_area, run } = origin;
    Statistics {
        objective: options.objective,
        objective_value: run.objective_value.unwrap_or(area),
        solver: run.solver,
        initial_mesh: kind,
        vertices: mesh.vertices.len(),
        triangles: mesh.triangles.len(),
        boundary_loops: topology.boundary_loops().len(),
        components: topology.components(),
        euler_characteristic: topology.euler_characteristic(),
        genus: topology.genus(),
        area,
        initial_area,
        extrapolated_area: run.extrapolated_area,
        mean_curvature: MeanCurvature {
            max: curvature.iter().copied().fold(0.0, f64::max),
            mean: over_free(curvature.iter().sum()),
            rms: over_free(curvature.iter().map(|h| h * h).sum()).sqrt(),
        },
        residual: measured.residual,
        residual_full: measured.residual_full,
        converged: measured.residual <= options.tolerance && flipped_triangles == 0 && degenerate_triangles == 0,
        stop_reason: run.stop_reason,
        iterations: run.iterations,
        history: run.history,
        stability: run.stability,
        edge_lengths: Spread::of(measure::edge_lengths(&mesh, topology).into_iter()),
        smallest_angle,
        largest_angle,
        edges_swapped: run.edges_swapped,
        flipped_triangles,
        degenerate_triangles,
        pinches: run.pinches,
        spanning: run.spanning,
        junctions: None,
    }
}
