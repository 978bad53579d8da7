//! The record of a run: why it stopped, its iterations, and the stability of the surface that it reached.

use super::options::Solver;
use plateau_equilibrium::Settings;
use plateau_equilibrium::form_finding::StopReason;
use plateau_equilibrium::newton::{Equations, State, StepSolver, iterate};
use plateau_equilibrium::stability::SecondVariation;
use plateau_mesh::remesh::thin_triangles::Pinch;
use plateau_mesh::{DVec3, Execution, Interruption, Progress};

/// Whether a solver that stopped for this reason, on a film of this residual, has met its own rule. The default solver
/// has met its rule if the residual is at most the tolerance. The solvers of the papers have rules of their own; for
/// Pinkall and Polthier's solver a residual at the tolerance suffices too.
pub(super) fn meets_its_rule(solver: Solver, reason: StopReason, residual: f64, tolerance: f64) -> bool {
    let by_residual = matches!(solver, Solver::Newton | Solver::PinkallPolthier) && residual <= tolerance;
    let by_another = match reason {
        StopReason::AreaChange
        | StopReason::Solved
        | StopReason::NothingToMove
        | StopReason::ObjectiveChange
        | StopReason::Gradient
        | StopReason::StepLength => true,
        StopReason::Residual
        | StopReason::TopologyChange
        | StopReason::MaxIterations
        | StopReason::Stalled
        | StopReason::Collapsed
        | StopReason::Deadline => false,
    };
    by_residual || by_another
}

/// The record of an iteration of the solver.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HistoryRow {
    /// The solver's phase.
    pub phase: &'static str,
    /// The number of the iteration, from 1.
    pub iteration: u32,
    /// Area after it, in u².
    pub area: f64,
    /// Residual after it.
    pub residual: f64,
}

/// Second variation of area under normal motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Stability {
    /// Whether the Morse index is 0. The surface is then a true local minimum, like a physical soap film. Null where
    /// `morse_index` is.
    pub stable: Option<bool>,
    /// Number of negative eigenvalues. Null if rounding does not decide the sign of one.
    pub morse_index: Option<usize>,
    /// Number of eigenvalues that are negative beyond rounding. It is not serialised.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub least_index: usize,
    /// Lowest eigenvalue with respect to the lumped mass, in 1/unit².
    pub lowest_eigenvalue: f64,
    /// Method that gave the index.
    pub method: StabilityMethod,
    /// Distance of a stable surface from the edge of stability: the least ratio of the second variation to its part
    /// without curvature, over all motions. 1 for a flat film, 0 at the edge, without a unit. If the film was compared
    /// with a finer one, this is an estimate for the smooth surface. `None` for unstable surfaces, and if it could not
    /// be computed. It is not serialised.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub margin: Option<f64>,
}

impl Stability {
    /// Returns the stability as the inertia of a factorisation gives it, without a margin.
    pub(crate) fn of(variation: &SecondVariation) -> Self {
        let plateau_equilibrium::Stability { stable, morse_index, least_index, lowest_eigenvalue, .. } =
            variation.stability();
        Self { stable, morse_index, least_index, lowest_eigenvalue, method: StabilityMethod::Inertia, margin: None }
    }
}

/// Method that gave a Morse index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum StabilityMethod {
    /// From the signs of the pivots of a factorisation. It is exact, because errors of rounding are bounded.
    Inertia,
    /// From the sign of the lowest eigenvalue, which a preconditioned iteration computes. Used for meshes that are too
    /// large to factorise in reasonable time, and only if the eigenvalue is positive, so that the index is 0.
    Eigenvalue,
}

impl StabilityMethod {
    /// A stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Inertia => "inertia",
            Self::Eigenvalue => "eigenvalue",
        }
    }
}

/// Area of the smooth surface on the same polygon, extrapolated from two resolutions to edges of length zero.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ExtrapolatedArea {
    /// Extrapolated area, in u².
    pub area: f64,
    /// Estimate of the error: the distance of the limit from the finer of the two areas, and twice that at a re-entrant
    /// corner.
    pub error_estimate: f64,
}

impl ExtrapolatedArea {
    /// Extrapolates from the areas of two minimal meshes on one boundary polygon. The edges of the finer mesh are half
    /// as long. The error of an area is assumed to fall with a power of the edge length between `order` and 2; see
    /// [`extrapolation`](super::extrapolation).
    pub(crate) fn new(coarse: f64, fine: f64, order: f64) -> Self {
        let correction = |order: f64| (coarse - fine) / (libm::exp2(order) - 1.0);
        let correction = 0.5 * (correction(2.0) + correction(order));
        let corrections = if order < 2.0 { 2.0 } else { 1.0 };
        Self { area: fine - correction, error_estimate: corrections * correction.abs() }
    }
}

/// A way to span the boundaries by films.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SpanningTopology {
    /// Sets of boundaries by their numbers. A connected film spans each set.
    pub films: Vec<Vec<usize>>,
    /// Total area. Null if one of the films does not exist.
    pub area: Option<f64>,
    /// Second variation of area under normal motion.
    pub stability: Option<Stability>,
    /// Whether its films pass through each other or through themselves. No soap film has such a shape, so these
    /// topologies follow those whose films do not cross. Null if the time was up before a crossing was found.
    pub films_cross: Option<bool>,
    /// Whether this topology was returned.
    pub chosen: bool,
}

/// The ways to span the boundaries that [`TopologyRule::Best`](super::options::TopologyRule::Best) compared.
#[derive(Clone, Debug, PartialEq)]
pub struct SpanningComparison {
    /// The compared topologies. Topologies solved at the full size come before topologies solved on coarse meshes only.
    /// Each group is sorted: first the topologies whose films do not cross, then those whose films cross, each by area,
    /// and last those without an area.
    pub topologies: Vec<SpanningTopology>,
    /// Whether a film holds that connects all boundaries.
    pub connected_film_exists: bool,
    /// The largest fraction of the gap between two boundaries at which a connected film holds. Between coaxial rings of
    /// 32 points and more it is within 2% of the largest catenoid's. It is determined only if no connected film holds
    /// at the whole gap. The gap is measured along the line through the centroids of the boundaries. `None` if there is
    /// no gap or no film was found.
    pub largest_gap_fraction: Option<f64>,
}

/// The report of a run of a solver on a film.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub solver: Solver,
    pub stop_reason: StopReason,
    pub iterations: u32,
    pub history: Vec<HistoryRow>,
    pub edges_swapped: u64,
    pub pinches: Vec<Pinch>,
    pub stability: Option<Stability>,
    /// The displacement of each vertex in the lowest mode of an unstable film.
    pub unstable_mode: Option<Vec<DVec3>>,
    pub extrapolated_area: Option<ExtrapolatedArea>,
    /// Whether the mesh was refined beyond the requested resolution, because a neck needed it.
    pub refined: bool,
    /// The value of the objective, if the objective is not the area.
    pub objective_value: Option<f64>,
    /// The comparison of topologies, if there was one.
    pub spanning: Option<SpanningComparison>,
}

impl Run {
    /// Returns the report of a run that has not begun.
    pub fn new(solver: Solver) -> Self {
        Self {
            solver,
            stop_reason: StopReason::NothingToMove,
            iterations: 0,
            history: Vec::new(),
            edges_swapped: 0,
            pinches: Vec::new(),
            stability: None,
            unstable_mode: None,
            extrapolated_area: None,
            refined: false,
            objective_value: None,
            spanning: None,
        }
    }

    /// Appends a later run on the same film.
    pub(crate) fn append(&mut self, later: Self) {
        let before = self.iterations;
        self.stop_reason = later.stop_reason;
        self.iterations += later.iterations;
        self.history
            .extend(later.history.into_iter().map(|row| HistoryRow { iteration: row.iteration + before, ..row }));
        self.edges_swapped += later.edges_swapped;
        self.pinches.extend(later.pinches.into_iter().map(|mut pinch| {
            pinch.iteration += before;
            pinch
        }));
        self.stability = later.stability;
        self.refined |= later.refined;
    }
}

/// History and progress of a run. The reported fraction never falls.
#[derive(Debug)]
pub(crate) struct Record<'a> {
    exec: &'a Execution<'a>,
    pub history: Vec<HistoryRow>,
    pub iterations: u32,
    fraction: f64,
    /// The interval of the total progress, within 0 to 1, that the present iterations cover.
    pub share: [f64; 2],
}

impl<'a> Record<'a> {
    pub fn new(exec: &'a Execution<'a>) -> Self {
        Self { exec, history: Vec::new(), iterations: 0, fraction: 0.0, share: [0.0, 1.0] }
    }

    /// Records an iteration. `fraction` is the part of the present interval that is done after this iteration.
    pub fn iteration(&mut self, phase: &'static str, area: f64, residual: f64, fraction: f64) {
        self.iterations += 1;
        self.history.push(HistoryRow { phase, iteration: self.iterations, area, residual });
        let [from, to] = self.share;
        self.fraction = self.fraction.max(from + (to - from) * fraction.clamp(0.0, 1.0));
        self.exec.report(Progress {
            fraction: self.fraction,
            phase,
            iteration: u64::from(self.iterations),
            objective_value: Some(area),
            residual: Some(residual),
        });
    }

    /// Runs Newton's method on a fixed connectivity and records each step under `phase`. `done` converts the progress
    /// of the residual towards the tolerance (0 to 1) into the part of the present interval that is done.
    ///
    /// # Errors
    /// The interruption.
    pub fn newton<E: Equations>(
        &mut self,
        vertices: &mut Vec<DVec3>,
        equations: &E,
        solver: &mut dyn StepSolver<E>,
        settings: &Settings,
        phase: &'static str,
        done: impl Fn(f64) -> f64,
    ) -> Result<(StopReason, State<E::Frame>), Interruption> {
        let mut start = None;
        let exec = self.exec;
        let (outcome, state) = iterate(vertices, equations, solver, settings, exec, &mut |energy, residual| {
            let part = geometric_part(*start.get_or_insert(residual), residual, settings.tolerance);
            self.iteration(phase, energy, residual, done(part));
        });
        Ok((StopReason::after(outcome)?, state))
    }
}

/// Returns the progress, from 0 to 1, of a value that decreases geometrically from `start` to `goal`.
pub(crate) fn geometric_part(start: f64, value: f64, goal: f64) -> f64 {
    let part = libm::log(start / value) / libm::log(start / goal.max(1e-16));
    if part.is_nan() { 1.0 } else { part.clamp(0.0, 1.0) }
}
