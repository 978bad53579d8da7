//! Requests: from JSON to a solved result.

use crate::checked::{Checked, Passed, Read};
use crate::kind::Kind;
use crate::limits::Limits;
use crate::options::has_empty;
#[cfg(not(feature = "explain"))]
use crate::options::pruned;
use crate::report::Progress;
#[cfg(feature = "explain")]
use crate::schema;
use crate::solved::{self, CoordinateSystem, Kept, Moved, Signal, Solved, SolverInput, Unsolved};
use crate::source::{Find, no_jobs};
use plateau_archive::Archive;
use plateau_mesh::{DVec3, Error, Execution};
use plateau_strict_json::rejection::{FieldError, Rejection};
use serde_json::Value;
use std::borrow::Cow;

/// A request that passed every check before solving.
#[derive(Debug)]
pub struct Request {
    coordinates: CoordinateSystem,
    /// Estimate of the memory that solving takes, including the result. The estimate is an upper bound.
    pub memory_bytes: u64,
    /// True if solving takes at most about a millisecond.
    pub quick: bool,
    /// Key by which the host finds the result from which the request begins. `None` if the kind has no source.
    pub source: Option<Vec<u8>>,
    kind: Kind,
    input: Box<dyn SolverInput>,
}

/// A request that passed every check before solving, and its text.
#[derive(Debug)]
pub struct CheckedRequest {
    pub request: Request,
    /// The request as JSON. Two requests that mean the same have the same text, whatever the order of their members,
    /// and whether they write or omit members with default values. `Request::read_stored` reads the text. It is empty
    /// without the feature `stored`.
    pub text: Vec<u8>,
}

/// Compares a refused value with the schema of its kind.
#[cfg(feature = "explain")]
fn explained(kind: Kind, value: &Value) -> Option<Rejection> {
    schema::validate(kind, value).err()
}

#[cfg(not(feature = "explain"))]
fn explained(_: Kind, _: &Value) -> Option<Rejection> {
    None
}

/// Returns a request without the members that count as left out, at every depth: those that are null, and empty lists.
fn without_empty(kind: Kind, request: &Value) -> Cow<'_, Value> {
    if !has_empty(request) {
        return Cow::Borrowed(request);
    }
    #[cfg(feature = "explain")]
    let left = schema::without_empty(kind, request);
    #[cfg(not(feature = "explain"))]
    let left = pruned(request, "", kind.types().empty_lists);
    Cow::Owned(left)
}

impl Request {
    /// Reads the JSON of a request of a known kind. The members that `aside` names are not part of the request and are
    /// returned unchanged.
    ///
    /// Returns `None` if the body is not JSON or the request is not valid.
    /// [`json::parse`](plateau_strict_json::json::parse) and
    /// [`Request::from_value`] then find every error.
    #[cfg(feature = "stored")]
    #[must_use]
    pub fn read(
        kind: Kind,
        body: &[u8],
        aside: &[&str],
        find: Find<'_>,
        limits: &Limits,
    ) -> Option<(CheckedRequest, serde_json::Map<String, Value>)> {
        let (read, aside) = (kind.types().read)(body, aside, find, limits)?;
        Some((Self::accepted(kind, read, limits).ok()?, aside))
    }

    /// Same as [`Request::read`], for a body that [`may_be_values`](crate::limits::may_be_values) refuses. It takes
    /// longer, but makes no JSON values.
    ///
    /// # Errors
    /// Returns the first value that the type refuses, or all errors of the first check that fails.
    #[cfg(feature = "stored")]
    pub fn read_tracked(
        kind: Kind,
        body: &[u8],
        aside: &[&str],
        find: Find<'_>,
        limits: &Limits,
    ) -> Result<(CheckedRequest, serde_json::Map<String, Value>), Rejection> {
        let (read, aside) = (kind.types().read_tracked)(body, aside, find, limits)?;
        Ok((Self::accepted(kind, read, limits)?, aside))
    }

    /// Reads a request of a known kind from a JSON value that [`json::parse`](plateau_strict_json::json::parse) made.
    ///
    /// # Errors
    /// Returns every value that the schema refuses (with the feature `explain`). If there are none, returns all errors
    /// of the first check that fails: limits, combinations of members, or geometry. There are at most
    /// [`MAX_ERRORS`](plateau_strict_json::rejection::MAX_ERRORS) + 1 errors. The extra error shows that some were left out.
    pub fn from_value(kind: Kind, value: &Value, find: Find<'_>, limits: &Limits) -> Result<CheckedRequest, Rejection> {
        let value = without_empty(kind, value);
        let read = (kind.types().read_value)(&value, find, limits).map_err(|rejection| {
            explained(kind, &value).unwrap_or_else(|| match rejection {
                Some(rejection) => rejection.placed_in(&value),
                None => (kind.types().refusal)(&value),
            })
        });
        Self::accepted(kind, read?, limits)
    }

    /// Reads a JSON value that names its own kind.
    ///
    /// # Errors
    /// Returns the errors of [`Request::from_value`]. A missing or unknown `kind` is an error at `/kind`.
    pub fn read_with_kind(value: &Value, find: Find<'_>, limits: &Limits) -> Result<CheckedRequest, Rejection> {
        match value["kind"].as_str().and_then(Kind::from_name) {
            Some(kind) => Self::from_value(kind, value, find, limits),
            None => {
                #[cfg(feature = "explain")]
                schema::validate_with_kind(value)?;
                Err(FieldError::new("/kind", "must be the name of a kind").into())
            }
        }
    }

    /// Reads the text of a request that was accepted earlier. The limits of this process may differ from those of the
    /// process that accepted it.
    ///
    /// # Errors
    /// Fails if this version does not know the request, or if it exceeds the limits.
    #[cfg(feature = "stored")]
    pub fn read_stored(kind: Kind, text: &[u8], find: Find<'_>, limits: &Limits) -> Result<Self, Rejection> {
        Self::new(kind, (kind.types().read_stored)(text, find, limits)?).within(limits)
    }

    /// Reads a value as [`Request::from_value`] does, but explains nothing by the schema.
    ///
    /// # Errors
    /// Returns the rejection of the checks, or `None` if the type refuses the value.
    #[doc(hidden)]
    pub fn without_schema(kind: Kind, value: &Value, limits: &Limits) -> Result<(), Option<Rejection>> {
        (kind.types().read_value)(&without_empty(kind, value), &no_jobs, limits).map(drop)
    }

    fn accepted(kind: Kind, (passed, text): Read, limits: &Limits) -> Result<CheckedRequest, Rejection> {
        Ok(CheckedRequest { request: Self::new(kind, passed).within(limits)?, text })
    }

    fn new(kind: Kind, passed: Passed) -> Self {
        let Passed { coordinates, checked, source } = passed;
        let Checked { memory_bytes, quick, input } = checked;
        Self { coordinates, memory_bytes, quick, source, kind, input }
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

    /// Solves the request on the calling thread. The solver calls `signal` as often as
    /// [`Execution`] promises.
    ///
    /// # Errors
    /// Returns the error of the solver.
    pub fn solve(&self, signal: &dyn Fn() -> Signal, report: &dyn Fn(Progress)) -> Result<Solved, Unsolved> {
        self.solve_and_count(signal, report).0
    }

    /// Solves the request, and also returns the largest amount of work between two checks of the signal. A test
    /// requires that this amount stays below a bound.
    #[doc(hidden)]
    pub fn solve_and_count(
        &self,
        signal: &dyn Fn() -> Signal,
        report: &dyn Fn(Progress),
    ) -> (Result<Solved, Unsolved>, u64) {
        let signal = || signal().of_the_solver();
        let report = |progress| report(solved::on_the_wire(progress));
        let exec = Execution::new(&signal, &report);
        let solve = || {
            let mut draft = self.input.solve(self.coordinates, &exec)?;
            draft.warnings.extend(solved::far_from_zero(&draft.archive));
            draft.audited(&*self.input, &exec)
        };
        (solve(), exec.largest_work_between_looks())
    }

    /// Keeps what is needed to move the result while the user drags points of this request. Returns `None` for strips,
    /// lattices, nets and tensile structures, and for the films that [`KeptFilm`] cannot move.
    ///
    /// # Errors
    /// Fails if the signal is a cancel, or if the memory does not suffice.
    ///
    /// [`KeptFilm`]: plateau_minimal_surface::KeptFilm
    pub fn keep(&self, result: &Archive, signal: &dyn Fn() -> Signal) -> Result<Option<Drag>, Unsolved> {
        let signal = || signal().of_the_solver();
        let kept = self.input.keep(result.contents(), &Execution::new(&signal, &|_| {}))?;
        Ok(kept.map(|kept| Drag { coordinates: self.coordinates, kept }))
    }

    /// Audits a result once more and returns the number of its faults, which is 0. The benchmark of the audit's cost
    /// calls it.
    #[doc(hidden)]
    #[must_use]
    pub fn audit(&self, solved: &Solved) -> usize {
        let Solved { statistics, warnings, archive, .. } = solved;
        solved::faults(statistics, warnings, archive, &*self.input, &Execution::default())
            .map_or(1, |faults| faults.len())
    }

    /// Returns the solver's result before its audit, with the input that audits it.
    #[cfg(test)]
    pub(crate) fn draft(&self) -> (solved::UnauditedResult, &dyn SolverInput) {
        let draft = self.input.solve(self.coordinates, &Execution::default());
        (draft.unwrap_or_else(|error| panic!("{error:?}")), &*self.input)
    }
}

/// A result that moves while the user drags points of its request.
///
/// The result after each move is a preview. A preview has the connectivity of the result from which the drag began. It
/// is corrected to a tolerance that the eye does not see, and is not audited.
#[derive(Debug)]
pub struct Drag {
    coordinates: CoordinateSystem,
    kept: Box<dyn Kept>,
}

impl Drag {
    /// Moves the result to the positions of the points of another request, and returns the figures there. Returns
    /// `None` and leaves the vertices as they are if that request differs in more than the positions, or if the mesh
    /// cannot follow. That request has to be solved.
    ///
    /// # Errors
    /// Fails if the signal is a cancel.
    pub fn move_to(&mut self, request: &Request, signal: &dyn Fn() -> Signal) -> Result<Option<Moved>, Unsolved> {
        if request.coordinates != self.coordinates {
            return Ok(None);
        }
        let signal = || signal().of_the_solver();
        let moved = self.kept.move_to(&*request.input, &Execution::new(&signal, &|_| {}));
        Ok(moved.map_err(Error::from)?)
    }

    /// Returns the vertices after the last move. The triangles are those of the result from which the drag began.
    #[must_use]
    pub fn vertices(&self) -> Vec<DVec3> {
        self.kept.vertices()
    }
}
