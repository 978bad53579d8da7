//! Requests: from JSON to a solved result.

use crate::body::{Body, PointList};
use crate::checked::Checked;
use crate::kind::Kind;
use crate::limits::Limits;
use crate::rejection::{FieldError, Rejection};
use crate::report::Progress;
use crate::schema;
use crate::solved::{self, Frame, Signal, Solved, SolverInput, Unsolved};
use plateau_mesh::Execution;
use serde_json::Value;

/// A request that passed every check before solving.
#[derive(Debug)]
pub struct Request {
    frame: Frame,
    /// Estimate of the memory that solving takes, including the result. The estimate is an upper bound.
    pub memory_bytes: u64,
    /// True if solving takes at most about a millisecond.
    pub quick: bool,
    kind: Kind,
    input: Box<dyn SolverInput>,
}

impl Request {
    /// Reads a request of a known kind. The stages are schema, types, limits and geometry.
    ///
    /// # Errors
    /// Returns all errors of the first stage that fails, at most [`MAX_ERRORS`](crate::rejection::MAX_ERRORS) + 1. The
    /// extra error shows that some were left out.
    pub fn read(kind: Kind, body: &Body, limits: &Limits) -> Result<Self, Rejection> {
        match Self::of(kind, body.outline(), body.lists(), limits) {
            // The outline lacks points to which errors may point.
            Err(_) if !body.lists().is_empty() => Self::of(kind, &body.whole(), &[], limits),
            read => read,
        }
    }

    /// Reads a body that was validated against the schema when it was submitted. The limits of this process may differ
    /// from those of the process that accepted it.
    ///
    /// # Errors
    /// Fails if this version does not know the body, or if it exceeds the limits.
    pub fn read_stored(kind: Kind, body: &[u8], limits: &Limits) -> Result<Self, Rejection> {
        Self::new(kind, (kind.types().read_stored)(body, limits)?).within(limits)
    }

    /// Reads a request that names its own kind.
    ///
    /// # Errors
    /// Returns the errors of [`Request::read`]. A missing or unknown `kind` is an error at `/kind`.
    pub fn read_with_kind(value: &Value, limits: &Limits) -> Result<Self, Rejection> {
        schema::validate_with_kind(value)?;
        // The schema requires a known kind.
        let kind = value["kind"].as_str().and_then(Kind::from_name);
        let kind = kind.ok_or_else(|| Rejection::Invalid(vec![FieldError::new("/kind", "is required")]))?;
        Self::of_valid(kind, value, &[], limits)
    }

    /// Reads a request from a body's outline and the point lists that were read separately.
    fn of(kind: Kind, outline: &Value, lists: &[PointList], limits: &Limits) -> Result<Self, Rejection> {
        schema::validate(kind, outline)?;
        Self::of_valid(kind, outline, lists, limits)
    }

    fn of_valid(kind: Kind, outline: &Value, lists: &[PointList], limits: &Limits) -> Result<Self, Rejection> {
        let read = (kind.types().read)(outline, lists, limits).map_err(|rejection| rejection.placed_in(outline))?;
        Self::new(kind, read).within(limits)
    }

    fn new(kind: Kind, (frame, checked): (Frame, Checked)) -> Self {
        let Checked { memory_bytes, quick, input } = checked;
        Self { frame, memory_bytes, quick, kind, input }
    }

    /// Refuses a request that needs more memory than the limit of one job.
    fn within(self, limits: &Limits) -> Result<Self, Rejection> {
        if self.memory_bytes <= limits.memory_bytes {
            return Ok(self);
        }
        let (needed, available) = (self.memory_bytes >> 20, limits.memory_bytes >> 20);
        let detail = format!("needs about {needed} MiB to solve, more than is allowed ({available} MiB)");
        Err(Rejection::TooLarge(vec![FieldError::new("", detail)]))
    }

    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// Solves the request on the calling thread. The solver calls `signal` at least every 50 ms.
    ///
    /// # Errors
    /// Returns the error of the solver.
    pub fn solve(&self, signal: &dyn Fn() -> Signal, report: &dyn Fn(Progress)) -> Result<Solved, Unsolved> {
        let signal = || match signal() {
            Signal::Continue => plateau_mesh::Signal::Continue,
            Signal::Cancel => plateau_mesh::Signal::Cancel,
            Signal::Deadline => plateau_mesh::Signal::Deadline,
        };
        let report = |progress| report(solved::on_the_wire(progress));
        let mut solved = self.input.solve(self.frame, &Execution::new(&signal, &report))?;
        solved.warnings.extend(solved::far_from_zero(&solved.archive));
        Ok(solved)
    }
}
