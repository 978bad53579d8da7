//! Progress and cancellation of a solve, counted in grid cells.

use plateau_mesh::execution::{Execution, Interruption, Progress};

/// Grid cells between two looks at the execution. The slowest kernel (four layers, no wide instructions) takes some
/// milliseconds for so many; a larger value delays cancellation.
pub(crate) const CELLS_BETWEEN_LOOKS: u64 = 1 << 16;

/// Progress and cancel of one solve, by cells visited.
#[derive(Debug)]
pub(crate) struct Pulse<'a, 'e> {
    execution: &'a Execution<'e>,
    phase: &'static str,
    expected: u64,
    done: u64,
    since_look: u64,
    fraction: f64,
    reported: f64,
}

impl<'a, 'e> Pulse<'a, 'e> {
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
    /// Cells that need no visit after all: progress only.
    pub(crate) fn leave_out(&mut self, cells: u64) {
        self.done += cells;
    }
    /// Counts cells, looks when enough have gathered and reports every half per cent.
    pub(crate) fn beat(&mut self, cells: u64) -> Result<(), Interruption> {
        self.done += cells;
        self.since_look += cells;
        if self.since_look < CELLS_BETWEEN_LOOKS {
            return Ok(());
        }
        self.last_look()?;
        // More work than expected (closed strips search until the bounds meet) creeps towards 1.
        let ratio = self.done as f64 / self.expected as f64;
        let fraction = if ratio <= 0.9 { ratio } else { 1.0 - 0.09 / ratio };
        self.fraction = self.fraction.max(fraction.min(0.999));
        if self.fraction >= self.reported + 0.005 {
            self.report(self.fraction, None);
        }
        Ok(())
    }
    /// Looks with what has gathered since.
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
