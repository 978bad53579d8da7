//! A session: one request after the other, and the files of the last result.

use plateau_archive::Archive;
use plateau_archive::formats::MeshFormat;
use plateau_forms::json;
use plateau_forms::limits::Limits;
use plateau_forms::rejection::{FieldError, MAX_ERRORS, Rejection};
use plateau_forms::report::{Progress, Warning};
use plateau_forms::request::Request;
use plateau_forms::solved::{Signal, Unsolved};
use plateau_forms::source::no_jobs;
use serde::Serialize;
use serde_json::value::RawValue;

/// Limits of one request: the defaults of the service, apart from the memory. A module has at most 4 GiB of memory, so
/// half of them are left to the request, the result and its files.
pub const LIMITS: Limits = Limits {
    points: 200_000,
    triangles: 2_000_000,
    grid_cells: 2_000_000_000,
    iterations: 1_000_000,
    memory_bytes: 2 << 30,
};

/// How a request ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The answer has `statistics` and `warnings`, and there is a mesh.
    Solved = 0,
    /// The answer has a `title`, a `detail` and the wrong values as `errors`, each with its JSON Pointer.
    Refused = 1,
    /// The answer says as for a refused request why there is no result.
    Failed = 2,
    /// The caller's signal ended the solver. The answer is empty.
    Cancelled = 3,
}

/// The last answer and the last result.
#[derive(Debug, Default)]
pub struct Session {
    answer: Vec<u8>,
    archive: Option<Archive>,
}

#[derive(Serialize)]
struct Result<'a> {
    statistics: &'a RawValue,
    warnings: &'a [Warning],
}

#[derive(Serialize)]
struct Failure<'a> {
    title: &'a str,
    detail: &'a str,
    errors: &'a [FieldError],
}

impl Session {
    /// Solves a request that names its kind, as `plateau solve` reads it. The solver calls `signal` at the same places
    /// as in the service, where they are at most 50 ms apart. The result replaces that of the request before.
    pub fn solve(&mut self, request: &[u8], signal: &dyn Fn() -> Signal, report: &dyn Fn(Progress)) -> Ending {
        self.archive = None;
        self.answer.clear();
        let request = json::parse(request)
            .and_then(|value| Request::read_with_kind(&value, &no_jobs, &LIMITS))
            .map(|accepted| accepted.request);
        let request = match request {
            Ok(request) => request,
            Err(Rejection::Malformed(detail)) => {
                return self.without_result(Ending::Refused, "The request is not well-formed JSON", &detail, &[]);
            }
            Err(Rejection::Invalid(errors)) => {
                return self.without_result(Ending::Refused, "The request is invalid", "", &errors);
            }
            Err(Rejection::TooLarge(errors)) => {
                return self.without_result(Ending::Refused, "The request is too large", "", &errors);
            }
        };
        let solved = match request.solve(signal, report) {
            Ok(solved) => solved,
            Err(Unsolved::Cancelled) => return Ending::Cancelled,
            Err(Unsolved::Failed(error)) => {
                return self.without_result(Ending::Failed, &error.title, &error.detail, &error.errors);
            }
        };
        let statistics: &RawValue = serde_json::from_str(&solved.statistics).unwrap_or(RawValue::NULL);
        self.answer = text(&Result { statistics, warnings: &solved.warnings });
        self.archive = Some(solved.archive);
        Ending::Solved
    }

    fn without_result(&mut self, ending: Ending, title: &str, detail: &str, errors: &[FieldError]) -> Ending {
        self.answer = text(&Failure { title, detail, errors: &errors[..errors.len().min(MAX_ERRORS)] });
        ending
    }

    /// Returns the answer to the last request as JSON text.
    #[must_use]
    pub fn answer(&self) -> &[u8] {
        &self.answer
    }

    /// Returns the last result, if the last request was solved.
    #[must_use]
    pub fn archive(&self) -> Option<&Archive> {
        self.archive.as_ref()
    }

    /// Makes a mesh file of the last result. Returns `None` if there is no result, or if the format is none of
    /// [`MeshFormat`] or cannot have this mesh.
    #[must_use]
    pub fn file(&self, format: &str) -> Option<Vec<u8>> {
        MeshFormat::from_name(format)?.encode(self.archive.as_ref()?).ok()
    }
}

/// Returns a value as JSON text. The values of this module always have one.
fn text<T: Serialize>(value: &T) -> Vec<u8> {
    serde_json::to_vec(value).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    const STRIP: &str =
        r#"{"kind": "ruled_surface", "directrices": [[[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 0], [2, 1, 1]]]}"#;

    fn solve(session: &mut Session, request: &str) -> (Ending, Value) {
        let ending = session.solve(request.as_bytes(), &|| Signal::Continue, &|_| {});
        (ending, serde_json::from_slice(session.answer()).unwrap_or_default())
    }

    #[test]
    fn a_solved_request_has_statistics_and_files() {
        let mut session = Session::default();
        let (ending, answer) = solve(&mut session, STRIP);
        assert_eq!((ending, &answer["statistics"]["triangles"]), (Ending::Solved, &Value::from(3)), "{answer}");
        assert!(answer["warnings"].is_array());
        assert!(session.file("glb").is_some_and(|file| file.starts_with(b"glTF")));
        assert_eq!(session.file("doc"), None);
    }

    #[test]
    fn a_refused_request_names_its_wrong_values_and_leaves_no_result() {
        let mut session = Session::default();
        solve(&mut session, STRIP);
        let (ending, answer) = solve(&mut session, &STRIP.replace("[1, 0, 0]", "[1, 0, null]"));
        assert_eq!((ending, answer["errors"][0]["pointer"].as_str()), (Ending::Refused, Some("/directrices/0/1/2")));
        assert_eq!((session.archive().is_none(), session.file("glb")), (true, None));
        let (ending, answer) = solve(&mut session, r#"{"kind": "ruled_surface", "kind": "ruled_surface"}"#);
        assert_eq!((ending, answer["title"].as_str()), (Ending::Refused, Some("The request is not well-formed JSON")));
    }

    #[test]
    fn a_request_without_a_result_says_why() {
        let rings = |z: f64| -> Vec<[f64; 3]> {
            (0..24).map(|k| std::f64::consts::TAU * f64::from(k) / 24.0).map(|t| [t.cos(), t.sin(), z]).collect()
        };
        let request = serde_json::json!({
            "kind": "minimal_surface", "boundaries": [rings(0.0), rings(3.0)]
        });
        let mut session = Session::default();
        let (ending, answer) = solve(&mut session, &request.to_string());
        assert_eq!(ending, Ending::Failed, "{answer}");
        assert!(answer["title"].as_str().is_some_and(|title| !title.is_empty()), "{answer}");
    }

    #[test]
    fn the_signal_ends_a_request() {
        let mut session = Session::default();
        let ending = session.solve(STRIP.as_bytes(), &|| Signal::Cancel, &|_| {});
        assert_eq!((ending, session.answer().len()), (Ending::Cancelled, 0));
    }
}
