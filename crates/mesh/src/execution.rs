//! The channel between a solver and its caller: the solver reports progress and receives requests to stop.

use std::cell::Cell;
use std::fmt;

/// The caller's request to a running solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    /// Continue.
    Continue,
    /// Stop and return nothing.
    Cancel,
    /// Time is used up: stop, and return the valid mesh reached so far if there is one.
    Deadline,
}

/// Why a solver stopped early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interruption {
    /// The caller wants no result.
    Cancelled,
    /// The caller's time is used up.
    DeadlinePassed,
}

/// The progress of a solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The completed part of the solve, from 0 to 1. It never decreases within one solve.
    pub fraction: f64,
    /// The solver's phase: `initial_mesh`, `newton`, `strip`.
    pub phase: &'static str,
    /// Number of iterations of the present phase so far.
    pub iteration: u64,
    /// The value of the objective, if it is known.
    pub objective_value: Option<f64>,
    /// The residual, if it is known.
    pub residual: Option<f64>,
}

/// The channel between a solver and its caller.
///
/// A solver calls [`look`](Self::look) between its steps, on meshes of up to 20,000 triangles at least every 50 ms. On
/// larger meshes one pass over the mesh or one sparse factorisation takes longer. The solver passes the amount of work
/// since its last call. Hidden counters of calls and work let tests check this promise
/// without a clock.
pub struct Execution<'a> {
    signal: &'a dyn Fn() -> Signal,
    report: &'a dyn Fn(Progress),
    work: Cell<u64>,
    largest_work: Cell<u64>,
    looks: Cell<u64>,
}

impl fmt::Debug for Execution<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Execution").field("looks", &self.looks).field("largest_work", &self.largest_work).finish()
    }
}

/// Work per triangle that a pass of remeshing or a linear solve passes to [`Execution::look`]: about the number of
/// times that the pass visits each triangle.
pub const WORK_PER_TRIANGLE: u64 = 20;

impl<'a> Execution<'a> {
    /// Makes an execution that calls `signal` at every [`look`](Self::look) and passes progress to `report`.
    #[inline]
    pub fn new(signal: &'a dyn Fn() -> Signal, report: &'a dyn Fn(Progress)) -> Self {
        Self { signal, report, work: Cell::new(0), largest_work: Cell::new(0), looks: Cell::new(0) }
    }

    /// Asks the caller whether to continue. `work` is the number of elementary operations (visited cells or triangles)
    /// since the last look.
    ///
    /// # Errors
    /// The interruption, if the caller wants the solver to stop.
    #[inline]
    pub fn look(&self, work: u64) -> Result<(), Interruption> {
        self.looks.set(self.looks.get() + 1);
        self.work.set(self.work.get() + work);
        self.largest_work.set(self.largest_work.get().max(work));
        match (self.signal)() {
            Signal::Continue => Ok(()),
            Signal::Cancel => Err(Interruption::Cancelled),
            Signal::Deadline => Err(Interruption::DeadlinePassed),
        }
    }

    /// Reports progress to the caller.
    #[inline]
    pub fn report(&self, progress: Progress) {
        (self.report)(progress);
    }

    /// Runs a part of a solve. The progress of the part, from 0 to 1, is reported as an interval of the whole progress,
    /// from `span[0]` to `span[1]`. The work and looks of the part are added to the counters of this execution.
    pub fn part<R>(&self, span: [f64; 2], work: impl FnOnce(&Execution) -> R) -> R {
        self.section(None, span, work)
    }

    /// The same as [`part`](Self::part), but every report names this phase.
    pub fn part_as<R>(&self, phase: &'static str, span: [f64; 2], work: impl FnOnce(&Execution) -> R) -> R {
        self.section(Some(phase), span, work)
    }

    fn section<R>(&self, phase: Option<&'static str>, [from, to]: [f64; 2], work: impl FnOnce(&Execution) -> R) -> R {
        let report = |progress: Progress| {
            let fraction = from + (to - from) * progress.fraction.clamp(0.0, 1.0);
            self.report(Progress { fraction, phase: phase.unwrap_or(progress.phase), ..progress });
        };
        let part = Execution::new(self.signal, &report);
        let result = work(&part);
        self.looks.set(self.looks.get() + part.looks.get());
        self.work.set(self.work.get() + part.work.get());
        self.largest_work.set(self.largest_work.get().max(part.largest_work.get()));
        result
    }

    /// Total work that was passed to [`look`](Self::look).
    #[doc(hidden)]
    #[inline]
    pub fn work(&self) -> u64 {
        self.work.get()
    }

    /// Number of looks so far.
    #[doc(hidden)]
    #[inline]
    pub fn looks(&self) -> u64 {
        self.looks.get()
    }

    /// Largest amount of work between two looks.
    #[doc(hidden)]
    #[inline]
    pub fn largest_work_between_looks(&self) -> u64 {
        self.largest_work.get()
    }
}

impl Default for Execution<'static> {
    /// Never stops the solver and drops its progress.
    fn default() -> Self {
        Self::new(&|| Signal::Continue, &|_| {})
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    #[test]
    fn a_part_reports_into_its_share_and_counts_its_looks() {
        let seen = RefCell::new(Vec::new());
        let report = |progress: Progress| seen.borrow_mut().push(progress.fraction);
        let exec = Execution::new(&|| Signal::Continue, &report);
        exec.look(3).unwrap();
        exec.part([0.5, 0.75], |part| {
            part.look(7).unwrap();
            for fraction in [0.0, 0.5, 1.0] {
                part.report(Progress { fraction, phase: "p", iteration: 0, objective_value: None, residual: None });
            }
        });
        assert_eq!((exec.looks(), exec.largest_work_between_looks(), exec.work()), (2, 7, 10));
        assert_eq!(*seen.borrow(), [0.5, 0.625, 0.75]);
    }
}
