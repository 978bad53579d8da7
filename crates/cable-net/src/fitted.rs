//! The result of a fit, and the constants that both methods of fitting use.

use super::options::Net;
use plateau_mesh::codes::Reason;
use plateau_mesh::sparse::LinearError;
use plateau_mesh::{DVec3, Error, Execution, Interruption, Progress};

/// Damping at the start. In a net without struts it is a multiple of the loss. With a smaller value the first steps are
/// refused.
pub const DAMPING: f64 = 1e-2;
/// Lower bound of the damping.
pub const LEAST_DAMPING: f64 = 1e-12;
/// Upper bound of the damping. If steps are still refused, fitting has stalled.
pub const LARGEST_DAMPING: f64 = 1e12;
/// Factor of the damping after a good step.
pub const RELAXED: f64 = 0.2;
/// Factor of the damping after a poor step or a refused one.
pub const TIGHTENED: f64 = 3.0;
/// Largest change of the natural logarithm of a density in one step. It corresponds to a factor of e².
pub const LARGEST_STEP: f64 = 2.0;
/// Fitting ends after this number of steps in a row that each lower the loss by at most the tolerance.
pub const QUIET_STEPS: u32 = 3;
/// Work of a step per edge, for [`Execution::look`]. The system of a step has about nine numbers for each end of an
/// edge, and its factor about ten times as many.
const WORK_PER_EDGE: u64 = 200;

/// Why fitting ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The net has no targets: the shape follows from the densities.
    NoTargets,
    /// The loss no longer falls.
    Change,
    /// No step lowers the loss.
    Stalled,
    /// The allowed steps are used up.
    MaxIterations,
    /// The deadline has passed.
    Deadline,
}

impl StopReason {
    /// A stable name of the reason, in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NoTargets => "no_targets",
            Self::Change => "change",
            Self::Stalled => "stalled",
            Self::MaxIterations => "max_iterations",
            Self::Deadline => "deadline",
        }
    }
}

/// The result of a fit: the densities, and the positions of the vertices that belong to them.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub densities: Vec<f64>,
    pub vertices: Vec<DVec3>,
    pub loss: f64,
    /// The largest derivative of the loss by the logarithm of a density. For a net with struts also by a position,
    /// measured in root mean square edge lengths.
    pub gradient: f64,
    pub iterations: u32,
    pub stop_reason: StopReason,
}

/// Makes the error for a net whose equations cannot be solved.
pub(super) fn refused(error: LinearError) -> Error {
    Error::no_result(Reason::NoEquilibrium, format!("the net's equations have no trustworthy solution: {error:?}"))
}

/// Asks the caller whether to continue, after a piece of work of about one step. Returns whether a deadline has passed.
///
/// # Errors
/// A cancel.
pub(super) fn is_late(net: &Net, exec: &Execution) -> Result<bool, Interruption> {
    match exec.look(WORK_PER_EDGE * net.edges.len() as u64) {
        Err(Interruption::DeadlinePassed) => Ok(true),
        other => other.map(|()| false),
    }
}

/// Reports the progress after a step.
pub(super) fn report(exec: &Execution, iterations: u32, total: u32, loss: f64) {
    exec.report(Progress {
        fraction: (f64::from(iterations) / f64::from(total)).min(1.0),
        phase: "fit",
        iteration: u64::from(iterations),
        objective_value: Some(loss),
        residual: None,
    });
}
