//! Solving of one job on the calling thread, which belongs to the service or to a child process.

use super::progress::SolverLink;
use super::view;
use crate::store::Outcome;
use crate::wire::job::JobFailure;
use plateau_archive::Archive;
use plateau_engine::kind::Kind;
use plateau_engine::limits::Limits;
use plateau_engine::report::SolveError;
use plateau_engine::request::Request;
#[cfg(feature = "test-hooks")]
use plateau_engine::solved::Signal;
use plateau_engine::solved::{self, Solved, Unsolved};
use plateau_engine::source::{Find, Source};
use plateau_strict_json::rejection::Rejection;
use serde::{Deserialize, Serialize};
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// How a solver ended.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum SolverEnd {
    Solved(Answer),
    /// The solver was told to stop, so there is no outcome.
    Stopped,
    Failed(SolveError),
    /// The request or its kind is unknown to this version, or beyond this worker's limits.
    Unread(SolveError),
    /// The solver's process was killed, but not by this one. The system does that when memory runs out.
    Killed,
}

/// A result as it is stored.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Answer {
    statistics: String,
    summary: String,
    warnings: String,
    reusable: bool,
    /// Stored form of the archive. It is sent between processes as bytes beside the other fields.
    #[serde(skip)]
    pub artefact: Vec<u8>,
}

impl SolverEnd {
    /// Returns the end of a job that failed for a reason that has nothing to do with its geometry.
    pub fn failed(failure: JobFailure, detail: impl Into<String>) -> Self {
        Self::Failed(failure.error(detail, Vec::new()))
    }

    pub fn unresponsive() -> Self {
        let detail = "the solver did not end in time after a cancel, its deadline or a shutdown, which is a defect of \
                      this server; the request is not the cause";
        Self::failed(JobFailure::Unresponsive, detail)
    }

    pub fn panicked() -> Self {
        let detail = "the solver hit a defect of this server; the request is not the cause";
        Self::failed(JobFailure::SolverPanicked, detail)
    }

    /// Returns what is stored of the job.
    ///
    /// # Errors
    /// Returns `self` if nothing is stored.
    pub fn outcome(self) -> Result<Outcome, Self> {
        match self {
            Self::Solved(Answer { statistics, summary, warnings, reusable, artefact }) => {
                let artefact_hash = Archive::checksum(&artefact);
                Ok(Outcome::Succeeded { statistics, summary, warnings, artefact, artefact_hash, reusable })
            }
            Self::Failed(error) => Ok(Outcome::Failed { error: text_of(&error) }),
            other => Err(other),
        }
    }
}

impl From<Solved> for SolverEnd {
    fn from(solved: Solved) -> Self {
        match solved.archive.to_bytes() {
            Ok(artefact) => Self::Solved(Answer {
                summary: view::summary_of(&solved.statistics),
                statistics: solved.statistics,
                // Serialization cannot fail because warnings have only strings.
                warnings: serde_json::to_string(&solved.warnings).unwrap_or_else(|_| "[]".into()),
                reusable: solved.reproducible,
                artefact,
            }),
            Err(defect) => Self::Failed(SolveError::internal(defect.to_string())),
        }
    }
}

impl From<Unsolved> for SolverEnd {
    fn from(unsolved: Unsolved) -> Self {
        match unsolved {
            Unsolved::Cancelled => Self::Stopped,
            Unsolved::Failed(error) => Self::Failed(error),
        }
    }
}

pub(super) fn text_of(error: &SolveError) -> String {
    // Serialization cannot fail because an error has only strings.
    serde_json::to_string(error).unwrap_or_default()
}

/// Reads a stored request. `find` returns the result from which the request begins.
///
/// # Errors
/// Returns how the job ends without a solver.
pub(super) fn read(
    kind: &str,
    request: &[u8],
    limits: &Limits,
    find: Find<'_>,
    link: &SolverLink,
) -> Result<Request, SolverEnd> {
    let Some(kind) = Kind::from_name(kind) else {
        let detail = "the workers' version does not know this kind of job";
        return Err(SolverEnd::Unread(JobFailure::Refused.error(detail, Vec::new())));
    };
    let source_lost = Cell::new(false);
    let find = |id: &str| -> Result<Source, String> {
        let found = find(id);
        source_lost.set(found.is_err());
        found
    };
    Request::read_stored(kind, request, &find, limits).map_err(|rejection| {
        if link.is_asked_to_end() {
            SolverEnd::Stopped
        } else if source_lost.get() {
            SolverEnd::Failed(refused(rejection))
        } else {
            SolverEnd::Unread(refused(rejection))
        }
    })
}

#[cfg_attr(not(feature = "test-hooks"), expect(unused_variables, reason = "only the hooks need the identifier"))]
pub(super) fn solve(id: &str, request: &Request, link: &SolverLink) -> SolverEnd {
    let report = |progress| link.report(progress);
    #[cfg(feature = "test-hooks")]
    let holds = crate::test_hooks::Holds::claimed(id, request.kind().name(), || link.signal() == Signal::Continue);
    #[cfg(feature = "test-hooks")]
    let report = |progress: plateau_engine::report::Progress| {
        let fraction = progress.fraction;
        report(progress);
        holds.progress(fraction, || link.is_taken());
    };
    let solved = request.solve(&|| link.signal(), &report);
    #[cfg(feature = "test-hooks")]
    holds.solved();
    match solved {
        Ok(solved) => solved.into(),
        Err(unsolved) => unsolved.into(),
    }
}

/// Turns a panic of the solver into a failed job, so that the worker survives. Data that the solver touched is not used
/// afterwards.
pub(super) fn guarded(solve: impl FnOnce() -> SolverEnd) -> SolverEnd {
    catch_unwind(AssertUnwindSafe(solve)).unwrap_or_else(|_| {
        tracing::error!("the solver panicked");
        SolverEnd::panicked()
    })
}

/// Returns the error of a job whose stored request a worker does not accept.
fn refused(rejection: Rejection) -> SolveError {
    let (detail, errors) = match rejection {
        Rejection::Malformed(detail) => (detail, Vec::new()),
        Rejection::Invalid(errors) | Rejection::TooLarge(errors) => (solved::causes(&errors), errors),
    };
    JobFailure::Refused.error(detail, errors)
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_strict_json::rejection::FieldError;

    #[test]
    fn a_panic_of_the_solver_makes_the_job_fail_with_the_type_solver_panicked() {
        let ended = guarded(|| panic!("a defect")).outcome();
        let Ok(Outcome::Failed { error }) = ended else { panic!("should have failed") };
        let error: SolveError = serde_json::from_str(&error).unwrap();
        assert_eq!(error.kind, "/problems/solver-panicked");
    }

    #[test]
    fn the_error_of_a_stored_request_that_is_not_accepted_has_the_cause_as_its_detail() {
        let errors = vec![FieldError::new("/boundaries", "is too large"), FieldError::new("/units", "is unknown")];
        for (rejection, detail) in [
            (Rejection::Invalid(errors), "/boundaries is too large; one more error is listed in errors"),
            (Rejection::Malformed("the body is UTF-16".into()), "the body is UTF-16"),
        ] {
            let error = refused(rejection);
            assert_eq!((error.kind.as_str(), error.detail.as_str()), ("/problems/refused", detail));
            assert!(SolverEnd::Unread(error).outcome().is_err(), "is handed back");
        }
    }

    #[test]
    fn a_cancelled_job_has_no_outcome_and_a_missed_deadline_is_a_failed_one() {
        assert!(matches!(SolverEnd::from(Unsolved::Cancelled).outcome(), Err(SolverEnd::Stopped)));
        let missed = SolverEnd::from(Unsolved::deadline()).outcome();
        assert!(matches!(missed, Ok(Outcome::Failed { .. })));
    }
}
