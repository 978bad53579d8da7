//! What a run remembers of its iterations, and what it tells the caller while it goes on.

use super::statistics::HistoryRow;
use crate::{Execution, Progress};

/// History and progress of one run. The fraction never falls, whatever the phases say.
#[derive(Debug)]
pub(super) struct Record<'a> {
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

    /// One more iteration (a linear solve); `fraction` of the present share is done after it.
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
pub(super) fn geometric_part(start: f64, value: f64, goal: f64) -> f64 {
    let part = (start / value).ln() / (start / goal.max(1e-16)).ln();
    if part.is_nan() { 1.0 } else { part.clamp(0.0, 1.0) }
}
