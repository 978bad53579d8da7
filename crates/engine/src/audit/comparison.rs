//! The comparison of stated figures with measured ones, and the faults that it finds.

use super::figure::{Measured, Spread};
use plateau_archive::archive::Contents;
use plateau_mesh::{DVec3, Execution, Interruption};
use serde_json::Value;

/// Assumed rounding error of a coordinate, in units in the last place of the largest coordinate.
const ROUNDING: f64 = 8.0;

/// A stated figure that the arrays contradict, or a required property that the mesh lacks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    /// JSON Pointer of the figure in the statistics, or the required property in words.
    pub figure: String,
    pub stated: String,
    pub measured: String,
}

/// Compares the figures that one result states with measured ones, and collects the faults.
#[derive(Debug)]
pub(crate) struct Audit<'a> {
    /// The arrays of the result.
    pub contents: &'a Contents,
    /// Codes of the warnings of the result.
    warnings: Vec<&'a str>,
    /// The statistics of the result.
    statistics: &'a Value,
    /// Assumed rounding error of a coordinate: 8 units in the last place of the largest coordinate, in the mesh's unit.
    pub step: f64,
    faults: Vec<Fault>,
    exec: &'a Execution<'a>,
    is_cancelled: bool,
}

impl<'a> Audit<'a> {
    pub fn new(contents: &'a Contents, statistics: &'a Value, warnings: Vec<&'a str>, exec: &'a Execution<'a>) -> Self {
        let largest = contents.mesh.vertices.iter().fold(DVec3::ZERO, |largest, p| largest.max(p.abs())).max_element();
        let step = ROUNDING * (largest.next_up() - largest);
        Self { contents, warnings, statistics, step, faults: Vec::new(), exec, is_cancelled: false }
    }

    /// # Errors
    /// Fails if the audit was cancelled.
    pub fn faults(self) -> Result<Vec<Fault>, Interruption> {
        if self.is_cancelled { Err(Interruption::Cancelled) } else { Ok(self.faults) }
    }

    /// Checks for a cancel after a pass over this number of items. Returns whether the audit goes on. A deadline does
    /// not end it, because no result is returned without an audit.
    #[must_use]
    pub fn goes_on(&mut self, items: usize) -> bool {
        self.is_cancelled |= self.exec.look(items as u64) == Err(Interruption::Cancelled);
        !self.is_cancelled
    }

    #[must_use]
    pub fn warns(&self, code: &str) -> bool {
        self.warnings.contains(&code)
    }

    /// Returns a stated value. Null stands for a value that is missing.
    #[must_use]
    pub fn value(&self, pointer: &str) -> &'a Value {
        self.statistics.pointer(pointer).unwrap_or(&Value::Null)
    }

    #[must_use]
    pub fn stated(&self, pointer: &str) -> Option<f64> {
        self.value(pointer).as_f64()
    }

    #[must_use]
    pub fn stated_count(&self, pointer: &str) -> usize {
        self.value(pointer).as_u64().unwrap_or(u64::MAX) as usize
    }

    /// Returns the number of entries of a stated list.
    #[must_use]
    pub fn entries(&self, pointer: &str) -> usize {
        self.value(pointer).as_array().map_or(0, Vec::len)
    }

    fn fault(&mut self, figure: impl Into<String>, stated: impl ToString, measured: impl ToString) {
        let (stated, measured) = (stated.to_string(), measured.to_string());
        self.faults.push(Fault { figure: figure.into(), stated, measured });
    }

    /// Compares a count that rounding does not change.
    pub fn equal(&mut self, pointer: &str, measured: usize) {
        if self.value(pointer).as_u64() != Some(measured as u64) {
            self.fault(pointer, self.value(pointer), measured);
        }
    }

    /// Compares a whole number that may be negative.
    pub fn equal_signed(&mut self, pointer: &str, measured: i64) {
        if self.value(pointer).as_i64() != Some(measured) {
            self.fault(pointer, self.value(pointer), measured);
        }
    }

    pub fn figure(&mut self, pointer: &str, measured: Measured) {
        if !self.stated(pointer).is_some_and(|stated| measured.agrees_with(stated)) {
            self.fault(pointer, self.value(pointer), range(measured));
        }
    }

    /// Compares a figure. A stated and a measured value that are both at most `rounding` count as equal.
    pub fn figure_or_below(&mut self, pointer: &str, measured: Measured, rounding: f64) {
        let both_below = measured.value <= rounding && self.stated(pointer).is_some_and(|stated| stated <= rounding);
        if !both_below {
            self.figure(pointer, measured);
        }
    }

    /// Compares the members `min`, `mean`, `max` and `std_dev` of a stated object.
    pub fn spread(&mut self, pointer: &str, measured: &Spread) {
        let Spread { min, mean, max, std_dev, .. } = *measured;
        for (name, measured) in [("min", min), ("mean", mean), ("max", max), ("std_dev", std_dev)] {
            self.figure(&format!("{pointer}/{name}"), measured);
        }
    }

    /// Compares a number that is stated by an attribute of the mesh.
    pub fn attribute(&mut self, name: impl FnOnce() -> String, stated: f64, measured: Measured) {
        if !measured.agrees_with(stated) {
            self.fault(name(), stated, range(measured));
        }
    }

    /// Adds a fault unless a required property holds, such as that a point of the request is at its vertex.
    pub fn require(&mut self, holds: bool, promise: impl FnOnce() -> String, measured: impl FnOnce() -> String) {
        if !holds {
            self.fault(promise(), "true", measured());
        }
    }
}

fn range(measured: Measured) -> String {
    let Measured { value, low, high } = measured;
    format!("{value} ({low} to {high} agree with it)")
}
