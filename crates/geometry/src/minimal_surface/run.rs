//! The record and the report of a run: why it stopped, its iterations, the stability of what it reached.

use super::options::Solver;
use crate::remesh::thin_triangles::Pinch;
use crate::{DVec3, Execution, Progress};

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
    /// The same for the gradient.
    Gradient,
    /// The same for the length of the step.
    StepLength,
    /// The allowed iterations are used up.
    MaxIterations,
    /// No step gains any more, although the residual is above the tolerance: a fold is in the way, or rounding is
    /// reached.
    Stalled,
    /// A part of the mesh has shrunk so far that its linear system has no trustworthy solution.
    Collapsed,
    /// The caller's deadline passed.
    Deadline,
}

impl StopReason {
    /// A stable name in snake case.
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

/// The record of an iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// The second variation of area under normal motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// Whether the Morse index is 0: a true local minimum.
    pub stable: bool,
    /// Number of negative eigenvalues.
    pub morse_index: usize,
    /// Lowest eigenvalue against the lumped mass, in 1/unit².
    pub lowest_eigenvalue: f64,
    /// Where the index comes from.
    pub method: StabilityMethod,
}

/// Where a Morse index comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StabilityMethod {
    /// The signs of the pivots of a factorisation: exact.
    Inertia,
    /// The lowest eigenvalue, by preconditioned iteration: on meshes too large to factorise in good time, and then only
    /// where it is positive, so that the index is 0.
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

/// An area extrapolated to edges of length zero, in u².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtrapolatedArea {
    /// The limit, in u².
    pub area: f64,
    /// How far that may be off: its distance from the finer of the two areas it comes from.
    pub error_estimate: f64,
}

impl ExtrapolatedArea {
    /// From the areas of two minimal meshes on one boundary polygon, the finer with every edge halved.
    pub(crate) fn new(coarse: f64, fine: f64) -> Self {
        let correction = (coarse - fine) / 3.0;
        Self { area: fine - correction, error_estimate: correction.abs() }
    }
}

/// A way to span the boundaries.
#[derive(Clone, Debug, PartialEq)]
pub struct SpanningTopology {
    /// The sets of boundaries, by their numbers, that a connected film spans each; ascending.
    pub films: Vec<Vec<usize>>,
    /// The sum of the films' areas; `None` if one of them does not hold.
    pub area: Option<f64>,
    /// Of all films together.
    pub stability: Option<Stability>,
    /// Whether its films pass through each other or themselves, so that no soap film takes this shape.
    pub films_cross: bool,
    /// Whether this is the one that was returned.
    pub chosen: bool,
}

/// The films that [`TopologyRule::Best`](super::options::TopologyRule::Best) compared.
#[derive(Clone, Debug, PartialEq)]
pub struct SpanningComparison {
    /// By area, those without one last.
    pub topologies: Vec<SpanningTopology>,
    /// Whether a film that connects all boundaries holds.
    pub connected_film_exists: bool,
    /// Of two boundaries without a connected film: the largest fraction of their gap, along the line of their
    /// centroids, at which one holds, to within 0.001. `None` if there is no gap or none was found.
    pub largest_gap_fraction: Option<f64>,
}

/// Report of a solver's run on a film.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub solver: Solver,
    pub stop_reason: StopReason,
    pub iterations: u32,
    pub history: Vec<HistoryRow>,
    pub edges_swapped: u64,
    pub pinches: Vec<Pinch>,
    pub stability: Option<Stability>,
    /// Per vertex the lowest mode of an unstable film.
    pub unstable_mode: Option<Vec<DVec3>>,
    pub extrapolated_area: Option<ExtrapolatedArea>,
    /// Where the objective is not the area.
    pub objective_value: Option<f64>,
    /// The comparison of topologies, if there was one.
    pub spanning: Option<SpanningComparison>,
}

impl Run {
    /// Nothing done yet.
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
    }
}

/// History and progress of one run. The fraction never falls, whatever the phases say.
#[derive(Debug)]
pub(crate) struct Record<'a> {
    exec: &'a Execution<'a>,
    pub history: Vec<HistoryRow>,
    pub iterations: u32,
    fraction: f64,
    /// The share of the whole run that the iterations now belong to.
    pub share: [f64; 2],
}

impl<'a> Record<'a> {
    pub fn new(exec: &'a Execution<'a>) -> Self {
        Self { exec, history: Vec::new(), iterations: 0, fraction: 0.0, share: [0.0, 1.0] }
    }

    /// Records an iteration (a linear solve); `fraction` of the present share is done after it.
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
}

/// How far `value` has come from `start` down to `goal` when it falls geometrically: 0 to 1.
pub(crate) fn geometric_part(start: f64, value: f64, goal: f64) -> f64 {
    let part = (start / value).ln() / (start / goal.max(1e-16)).ln();
    if part.is_nan() { 1.0 } else { part.clamp(0.0, 1.0) }
}
