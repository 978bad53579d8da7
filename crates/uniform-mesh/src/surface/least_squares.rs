//! Least-squares problems over points with two coordinates each: flattening, the moves of nodes and the sharing of
//! lengths. [`minimise`](levenberg_marquardt::minimise) lowers the energy and reports every step.

use plateau_mesh::DVec2;
use plateau_mesh::execution::{Execution, Interruption, Progress};
use plateau_mesh::sparse::levenberg_marquardt::{self, Criteria, LeastSquares, Stop};

/// Damping at the start, in units of the problem's metric. Any value from 1e-4 to 1e-2 gives the same results.
const DAMPING: f64 = 1e-3;
/// Number of steps in a row below the tolerance that end a run. One step is not enough, because it may be short on
/// account of a single triangle.
const QUIET_STEPS: u32 = 3;

/// Returns the largest fraction of a step, at most 1, that takes no triangle more than nine tenths of the way to zero
/// area.
///
/// Without this limit a single triangle that is about to flip would raise the damping, and shorten the steps of the
/// whole mesh.
pub(crate) fn step_before_flip(triangles: impl Iterator<Item = [(DVec2, DVec2); 3]>) -> f64 {
    let mut most = 1.0 / 0.9;
    for [(a, da), (b, db), (c, dc)] in triangles {
        let ((u, du), (v, dv)) = ((b - a, db - da), (c - a, dc - da));
        // Twice the area after the part s of the step: p + q s + r s², with p > 0.
        let (p, q, r) = (u.perp_dot(v), u.perp_dot(dv) + du.perp_dot(v), du.perp_dot(dv));
        let discriminant = q * q - 4.0 * p * r;
        if p <= 0.0 || discriminant < 0.0 {
            continue;
        }
        // This is the stable form of the smaller positive root. The other root is negative or larger.
        let root = 2.0 * p / (discriminant.sqrt() - q);
        if root > 0.0 {
            most = f64::min(most, root);
        }
    }
    0.9 * most
}

/// Stopping rule of a run, and its part of the progress.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    pub phase: &'static str,
    /// The interval of the solve's progress that this run covers.
    pub span: (f64, f64),
    /// Largest number of steps that are tried.
    pub max_iterations: u64,
    /// Relative decrease of the energy below which a step counts as idle. `QUIET_STEPS` idle steps in a row end the
    /// run.
    pub tolerance: f64,
}

/// Result of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Outcome {
    pub energy: f64,
    /// Number of steps tried.
    pub steps: u64,
    pub interrupted: Option<Interruption>,
}

/// Lowers the problem's energy, starting from `x`, until the steps gain less than the tolerance. The energy at `x` must
/// be finite.
///
/// On an interruption `x` is the best location found.
pub(crate) fn minimise<P: LeastSquares<2>>(
    problem: &mut P,
    x: &mut Vec<P::Location>,
    settings: Settings,
    execution: &Execution<'_>,
) -> Outcome {
    let Settings { phase, span: (from, to), max_iterations, tolerance } = settings;
    let criteria = Criteria {
        damping: DAMPING,
        change: tolerance,
        floor: 0.0,
        quiet_steps: QUIET_STEPS,
        gradient: 0.0,
        step: 0.0,
        max_iterations,
    };
    let mut steps = 0;
    let mut observe = |iteration: u64, _: &[P::Location], energy: f64| {
        steps = iteration;
        execution.report(Progress {
            fraction: from + (to - from) * iteration as f64 / max_iterations as f64,
            phase,
            iteration,
            objective_value: Some(energy),
            residual: None,
        });
    };
    let (stop, energy) = levenberg_marquardt::minimise(problem, x, criteria, &mut observe, execution);
    let interrupted = if let Stop::Interrupted(interruption) = stop { Some(interruption) } else { None };
    Outcome { energy, steps, interrupted }
}
