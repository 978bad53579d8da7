//! A session solves one request after the other. It makes files of the last result, and previews of it while the user
//! drags points.

use plateau_archive::Archive;
use plateau_archive::formats::MeshFormat;
use plateau_engine::limits::Limits;
use plateau_engine::report::{Progress, SolveError, Warning};
use plateau_engine::request::{Drag, Request};
use plateau_engine::solved::{Moved, Signal, Unsolved};
use plateau_engine::source::no_jobs;
use plateau_mesh::DVec3;
use plateau_strict_json::json;
use plateau_strict_json::rejection::{FieldError, MAX_ERRORS, Rejection};
use serde::Serialize;
use serde_json::value::RawValue;

/// Limits of one request. They are the defaults of the service, apart from the memory. A WebAssembly module has at most
/// 4 GiB of memory. Solving may take half of it, and the other half is left to the request, the result and its files.
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
    /// The answer has the fields of a refused request, and the `type` of the failure.
    Failed = 2,
    /// The caller's signal ended the solver. The answer is empty.
    Cancelled = 3,
    /// The last result followed the drag. The answer has the figures of the moved mesh as `moved`. The moved mesh has
    /// the triangles of the last result and other vertices. It is a preview, of which no file is made.
    Moved = 4,
}

/// The last answer and the last result.
#[derive(Debug, Default)]
pub struct Session {
    answer: Vec<u8>,
    solved: Option<(Request, Archive)>,
    drag: Following,
    /// Vertices of the result after a drag.
    moved: Option<Vec<DVec3>>,
}

/// Whether the last result can move while the user drags points. This is unknown until the first drag.
#[derive(Debug, Default)]
enum Following {
    #[default]
    Unknown,
    No,
    Yes(Drag),
}

#[derive(Serialize)]
struct Result<'a> {
    statistics: &'a RawValue,
    warnings: &'a [Warning],
}

#[derive(Serialize)]
struct Preview {
    moved: Moved,
}

#[derive(Serialize)]
struct Failure<'a> {
    /// Reason of a failure as the service's problem documents name it. A refused request has none.
    #[serde(rename = "type", skip_serializing_if = "str::is_empty")]
    kind: &'a str,
    title: &'a str,
    detail: &'a str,
    errors: &'a [FieldError],
}

impl Session {
    /// Solves a request that names its kind, as `plateau solve` reads it. The solver calls `signal` at the same places
    /// as in the service. The result replaces that of the previous request.
    pub fn solve(&mut self, request: &[u8], signal: &dyn Fn() -> Signal, report: &dyn Fn(Progress)) -> Ending {
        match self.read(request) {
            Ok(request) => self.solve_anew(request, signal, report),
            Err(ending) => ending,
        }
    }

    /// Moves the last result to the positions of the points in a request that differs from the solved one only in these
    /// positions. The first move after a solve prepares the result for this. If the result cannot follow the request,
    /// the request is [solved](Self::solve).
    pub fn drag(&mut self, request: &[u8], signal: &dyn Fn() -> Signal, report: &dyn Fn(Progress)) -> Ending {
        let request = match self.read(request) {
            Ok(request) => request,
            Err(ending) => return ending,
        };
        match self.follow(&request, signal) {
            Ok(Some(moved)) => {
                self.answer = text(&Preview { moved });
                Ending::Moved
            }
            Ok(None) => self.solve_anew(request, signal, report),
            Err(Unsolved::Cancelled) => Ending::Cancelled,
            Err(Unsolved::Failed(error)) => self.failed(&error),
        }
    }

    fn follow(
        &mut self,
        request: &Request,
        signal: &dyn Fn() -> Signal,
    ) -> std::result::Result<Option<Moved>, Unsolved> {
        let Some((last, archive)) = &self.solved else { return Ok(None) };
        if matches!(self.drag, Following::Unknown) {
            self.drag = last.keep(archive, signal)?.map_or(Following::No, Following::Yes);
        }
        let Following::Yes(drag) = &mut self.drag else { return Ok(None) };
        let moved = drag.move_to(request, signal)?;
        if moved.is_some() {
            self.moved = Some(drag.vertices());
        }
        Ok(moved)
    }

    /// Reads a request. If it is refused, the answer says why, and the last result is dropped.
    fn read(&mut self, request: &[u8]) -> std::result::Result<Request, Ending> {
        self.answer.clear();
        let read = json::parse(request).and_then(|value| Request::read_with_kind(&value, &no_jobs, &LIMITS));
        let rejection = match read {
            Ok(accepted) => return Ok(accepted.request),
            Err(rejection) => rejection,
        };
        self.forget();
        let (title, detail, errors) = match &rejection {
            Rejection::Malformed(detail) => ("The request is not well-formed JSON", detail.as_str(), &[][..]),
            Rejection::Invalid(errors) => ("The request is invalid", "", &errors[..]),
            Rejection::TooLarge(errors) => ("The request is too large", "", &errors[..]),
        };
        self.without_result("", title, detail, errors);
        Err(Ending::Refused)
    }

    fn forget(&mut self) {
        (self.solved, self.drag, self.moved) = (None, Following::Unknown, None);
    }

    fn solve_anew(&mut self, request: Request, signal: &dyn Fn() -> Signal, report: &dyn Fn(Progress)) -> Ending {
        self.forget();
        let solved = match request.solve(signal, report) {
            Ok(solved) => solved,
            Err(Unsolved::Cancelled) => return Ending::Cancelled,
            Err(Unsolved::Failed(error)) => return self.failed(&error),
        };
        let statistics: &RawValue = serde_json::from_str(&solved.statistics).unwrap_or(RawValue::NULL);
        self.answer = text(&Result { statistics, warnings: &solved.warnings });
        self.solved = Some((request, solved.archive));
        Ending::Solved
    }

    fn failed(&mut self, error: &SolveError) -> Ending {
        self.without_result(&error.kind, &error.title, &error.detail, &error.errors);
        Ending::Failed
    }

    fn without_result(&mut self, kind: &str, title: &str, detail: &str, errors: &[FieldError]) {
        self.answer = text(&Failure { kind, title, detail, errors: &errors[..errors.len().min(MAX_ERRORS)] });
    }

    /// Returns the answer to the last request as JSON text.
    #[must_use]
    pub fn answer(&self) -> &[u8] {
        &self.answer
    }

    /// Returns the last result, if the last request was solved.
    #[must_use]
    pub fn archive(&self) -> Option<&Archive> {
        self.solved.as_ref().map(|(_, archive)| archive)
    }

    /// Returns the vertices of the last result, or of its preview after a drag.
    #[must_use]
    pub fn vertices(&self) -> &[DVec3] {
        let solved = || self.archive().map_or(&[][..], |archive| &archive.contents().mesh.vertices);
        self.moved.as_deref().unwrap_or_else(solved)
    }

    /// Returns the triangles of the last result.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.archive().map_or(&[], |archive| &archive.contents().mesh.triangles)
    }

    /// Makes a file of the last result: its mesh in a format of [`MeshFormat`], or its flat pattern as `svg` or `dxf`.
    /// Returns `None` if there is no result or only a preview of one, or if the format is unknown or cannot have this
    /// result.
    #[must_use]
    pub fn file(&self, format: &str) -> Option<Vec<u8>> {
        let archive = self.archive().filter(|_| self.moved.is_none())?;
        match (MeshFormat::from_name(format), format) {
            (Some(mesh), _) => mesh.encode(archive).ok(),
            (None, "svg") => plateau_drawing::plain_svg(archive.contents()).ok(),
            (None, "dxf") => plateau_drawing::plain_dxf(archive.contents()).ok(),
            (None, _) => None,
        }
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
