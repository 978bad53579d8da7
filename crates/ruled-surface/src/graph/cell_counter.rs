//! Progress and cancellation of a solve, counted in grid cells.

use plateau_mesh::execution::{Execution, Interruption, Progress};

/// Number of grid cells between two checks of the caller's cancellation signal. The slowest kernel (four layers, no
/// wide instructions) takes a few milliseconds for this number. A solve promises to stop within 50 ms.
pub(crate) const CELLS_BETWEEN_LOOKS: u64 = 1 << 16;

/// Counts the cells that a solve has visited; reports progress and looks at the caller's signal.
#[derive(Debug)]
pub(crate) struct CellCounter<'a, 'e> {
    execution: &'a Execution<'e>,
    phase: &'static str,
    expected: u64,
    done: u64,
    since_look: u64,
    fraction: f64,
    reported: f64,
}

impl<'a, 'e> CellCounter<'a, 'e> {
    pub(crate) fn new(execution: &'a Execution<'e>, expected: u64) -> Self {
        Self {
            execution,
            phase: "strip",
            expected: expected.max(1),
            done: 0,
            since_look: 0,
            fraction: 0.0,
            reported: -1.0,
        }
    }
    pub(crate) fn phase(&mut self, phase: &'static str) {
        self.phase = phase;
    }
    /// Counts cells that are not visited, so that the progress includes them.
    pub(crate) fn leave_out(&mut self, cells: u64) {
        self.done += cells;
    }
    /// Counts visited cells. Looks at the signal after [`CELLS_BETWEEN_LOOKS`], and reports every half per cent of
    /// progress.
    pub(crate) fn add(&mut self, cells: u64) -> Result<(), Interruption> {
        self.done += cells;
        self.since_look += cells;
        if self.since_look < CELLS_BETWEEN_LOOKS {
            return Ok(());
        }
        self.last_look()?;
        // Closed strips search until the bounds meet and may need more work than expected. Beyond 0.9 the fraction
        // therefore only approaches 1.
        let ratio = self.done as f64 / self.expected as f64;
        let fraction = if ratio <= 0.9 { ratio } else { 1.0 - 0.09 / ratio };
        self.fraction = self.fraction.max(fraction.min(0.999));
        if self.fraction >= self.reported + 0.005 {
            self.report(self.fraction, None);
        }
        Ok(())
    }
    /// Looks at the signal and accounts for the cells visited since the last look.
    pub(crate) fn last_look(&mut self) -> Result<(), Interruption> {
        self.execution.look(std::mem::take(&mut self.since_look))
    }
    pub(crate) fn report(&mut self, fraction: f64, objective_value: Option<f64>) {
        self.fraction = self.fraction.max(fraction);
        self.reported = self.fraction;
        self.execution.report(Progress {
            fraction: self.fraction,
            phase: self.phase,
            iteration: self.done,
            objective_value,
            residual: None,
        });
    }
    pub(crate) fn execution(&self) -> &'a Execution<'e> {
        self.execution
    }
}
