//! What a kind's request must be able to do.

use crate::body::PointList;
use crate::limits::Limits;
use crate::rejection::Rejection;
use crate::solved::SolverInput;
use plateau_archive::units::{Unit, UpAxis};
use serde::de::DeserializeOwned;

/// Result of the checks of one kind of request.
#[derive(Debug)]
pub(crate) struct Checked {
    pub memory_bytes: u64,
    pub quick: bool,
    pub input: Box<dyn SolverInput>,
}

/// A request of one kind as its JSON has it.
pub(crate) trait KindRequest: DeserializeOwned {
    /// Returns the unit of the coordinates and the axis that points up.
    fn axes(&self) -> (Unit, UpAxis);

    /// Takes the points of a field that was read separately.
    fn take(&mut self, _list: &PointList) {}

    /// Makes the checks that the schema cannot express, and converts the request to the geometry's types.
    ///
    /// # Errors
    /// Returns every offending value.
    fn check(&self, limits: &Limits) -> Result<Checked, Rejection>;
}
