//! Results of requests, and the helpers with which every kind makes its result from a solver's output.

use crate::audit::comparison::{Audit, Fault};
use crate::report::{Failure, Progress, SolveError, Warning};
use plateau_archive::archive::{Contents, middle};
use plateau_archive::units::{Unit, UpAxis};
use plateau_archive::{Archive, Attribute, LineSet, Lines, Polyline};
use plateau_mesh::codes::{Reason, WarningCode};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Mesh, polyline};
use plateau_strict_json::rejection::{FieldError, MAX_ERRORS};
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// A solved request, whose stated figures agree with its mesh.
#[derive(Debug)]
pub struct Solved {
    /// Statistics as JSON text.
    pub statistics: String,
    pub warnings: Vec<Warning>,
    pub archive: Archive,
    /// Whether the same request always gives this result. False if a deadline cut the solver short.
    pub reproducible: bool,
    /// Only this module can create an `Audited`, so that no result leaves without its audit.
    _audited: Audited,
}

/// Marks a result that passed the audit.
#[derive(Debug)]
struct Audited;

/// A solver's result before its audit.
#[derive(Debug)]
pub(crate) struct UnauditedResult {
    /// Statistics as JSON text.
    pub statistics: String,
    pub warnings: Vec<Warning>,
    pub archive: Archive,
    pub reproducible: bool,
}

/// Maximum number of differing figures that the error of a failed audit lists.
const NAMED_FAULTS: usize = 5;

impl UnauditedResult {
    /// Measures every stated figure again from the arrays of the archive, and compares the two.
    ///
    /// # Errors
    /// Fails with `audit-failed` if a stated figure differs from the measured one, and with a cancel if the audit was
    /// cancelled.
    pub fn audited(self, input: &dyn SolverInput, exec: &Execution) -> Result<Solved, Unsolved> {
        let faults = faults(&self.statistics, &self.warnings, &self.archive, input, exec).map_err(Error::from)?;
        let Self { statistics, warnings, archive, reproducible } = self;
        if faults.is_empty() {
            return Ok(Solved { statistics, warnings, archive, reproducible, _audited: Audited });
        }
        let named = faults.iter().take(NAMED_FAULTS);
        let texts =
            named.map(|Fault { figure, stated, measured }| format!("{figure}: stated {stated}, measured {measured}"));
        let texts = texts.collect::<Vec<_>>().join("; ");
        let more = faults.len().saturating_sub(NAMED_FAULTS);
        let more = if more > 0 { format!("; and {more} more") } else { String::new() };
        let detail = format!(
            "the result was withheld because its figures are not those of its mesh: {texts}{more}. This is a defect of \
             the solver; the request is not the cause"
        );
        Err(Unsolved::Failed(Failure::AuditFailed.error(detail, Vec::new())))
    }
}

/// Returns the stated figures that differ from those of the archive's arrays.
///
/// # Errors
/// Fails if the audit was cancelled.
pub(crate) fn faults(
    statistics: &str,
    warnings: &[Warning],
    archive: &Archive,
    input: &dyn SolverInput,
    exec: &Execution,
) -> Result<Vec<Fault>, Interruption> {
    let statistics: Value = serde_json::from_str(statistics).unwrap_or_default();
    let codes = warnings.iter().map(|warning| warning.code.as_str()).collect();
    let mut audit = Audit::new(archive.contents(), &statistics, codes, exec);
    input.audit(&mut audit);
    audit.faults()
}

/// Reason for having no result.
#[derive(Debug)]
pub enum Unsolved {
    /// The job was cancelled.
    Cancelled,
    /// The solver found no valid mesh.
    Failed(SolveError),
}

impl Unsolved {
    /// Returns the error for a deadline that passed before the solver had a valid mesh.
    #[must_use]
    pub fn deadline() -> Self {
        let detail = "the deadline passed before there was a valid mesh; ask for a coarser one";
        Self::Failed(Failure::Deadline.error(detail, Vec::new()))
    }
}

impl From<Error> for Unsolved {
    fn from(error: Error) -> Self {
        let fields = |errors: &[plateau_mesh::InputError]| -> Vec<FieldError> {
            errors.iter().take(MAX_ERRORS).map(FieldError::from).collect()
        };
        Self::Failed(match error {
            Error::Interrupted(Interruption::Cancelled) => return Self::Cancelled,
            Error::Interrupted(Interruption::DeadlinePassed) => return Self::deadline(),
            Error::Input(errors) => {
                let fields = fields(&errors);
                Failure::InvalidGeometry.error(causes(&fields), fields)
            }
            Error::NoResult { reason, detail, places } => SolveError::of_solver(reason, detail, fields(&places)),
        })
    }
}

/// Returns the first error as text, with the number of the others.
#[must_use]
pub fn causes(errors: &[FieldError]) -> String {
    let Some(first) = errors.first() else { return "the request was refused".into() };
    let first_one = format!("{} {}", first.pointer, first.detail);
    match errors.len() - 1 {
        0 => first_one,
        1 => format!("{first_one}; one more error is listed in errors"),
        more => format!("{first_one}; {more} more errors are listed in errors"),
    }
}

/// Unit and upward axis of a request's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CoordinateSystem {
    pub unit: Unit,
    pub up: UpAxis,
}

/// A checked request in the geometry's types.
pub(crate) trait SolverInput: std::any::Any + std::fmt::Debug + Send + Sync {
    /// Runs the solver of this input on the calling thread.
    ///
    /// # Errors
    /// Returns the error of the solver.
    fn solve(&self, coordinates: CoordinateSystem, exec: &Execution) -> Result<UnauditedResult, Error>;

    /// Compares every figure that the statistics state with the arrays of the result.
    fn audit(&self, audit: &mut Audit);

    /// Keeps what is needed to move the result while the user drags points of the request. Returns `None` if a request
    /// of this kind or with these options has to be solved anew after every change.
    ///
    /// # Errors
    /// Fails if `exec` interrupts it, or if the memory does not suffice.
    fn keep(&self, _result: &Contents, _exec: &Execution) -> Result<Option<Box<dyn Kept>>, Error> {
        Ok(None)
    }
}

/// The mesh of a result, which can move while the user drags points of the request.
pub(crate) trait Kept: std::fmt::Debug {
    /// Moves the mesh to the positions of the points of another request. Returns `None` and leaves the vertices as they
    /// are if that request differs in more than the positions, or if the mesh cannot follow.
    ///
    /// # Errors
    /// Returns the interruptions of `exec`.
    fn move_to(&mut self, input: &dyn SolverInput, exec: &Execution) -> Result<Option<Moved>, Interruption>;

    /// Returns the vertices after the last move.
    fn vertices(&self) -> Vec<DVec3>;
}

/// Figures of a result after it was moved by a drag.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Moved {
    /// Area in the square of the request's unit.
    pub area: f64,
    /// Residual, defined as in the statistics.
    pub residual: f64,
}

/// The host's answer when a solver asks whether to go on. Solvers ask regularly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    Continue,
    /// Stop without a result.
    Cancel,
    /// Stop, and return the best result so far.
    Deadline,
}

impl Signal {
    pub(crate) fn of_the_solver(self) -> plateau_mesh::Signal {
        match self {
            Self::Continue => plateau_mesh::Signal::Continue,
            Self::Cancel => plateau_mesh::Signal::Cancel,
            Self::Deadline => plateau_mesh::Signal::Deadline,
        }
    }
}

/// Warns of a mesh whose STL file is not in the request's coordinates.
pub(crate) fn far_from_zero(archive: &Archive) -> Option<Warning> {
    let detail = "the mesh is so far from zero, compared with its size, that 32-bit numbers cannot hold its \
        coordinates: STL files are relative to `origin` of the statistics, unless they are asked for with \
        `origin=given`";
    let warning =
        || Warning { code: WarningCode::FarFromZero.to_string(), detail: detail.into(), values: BTreeMap::new() };
    archive.contents().is_far_from_zero().then(warning)
}

pub(crate) fn origin(mesh: &Mesh) -> [f64; 3] {
    middle(&mesh.vertices).to_array()
}

/// Returns a solver's progress as JSON can hold it.
pub(crate) fn on_the_wire(progress: plateau_mesh::Progress) -> Progress {
    // JSON has no NaN, so a residual that is not finite becomes null.
    let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
    Progress {
        fraction: progress.fraction.clamp(0.0, 1.0),
        phase: progress.phase.into(),
        iteration: progress.iteration,
        objective_value: finite(progress.objective_value),
        residual: finite(progress.residual),
    }
}

pub(crate) fn warnings(warnings: Vec<plateau_mesh::error::Warning>) -> Vec<Warning> {
    let on_the_wire = |plateau_mesh::error::Warning { code, detail, values }| Warning {
        code: code.to_string(),
        detail,
        values: values.into_iter().map(|(name, value)| (name.into(), value)).collect(),
    };
    warnings.into_iter().map(on_the_wire).collect()
}

pub(crate) fn generator() -> String {
    concat!("plateau ", env!("CARGO_PKG_VERSION")).into()
}

pub(crate) fn line_set(name: &str, lines: Lines) -> LineSet {
    LineSet { name: name.into(), group: String::new(), lines, attributes: Vec::new() }
}

/// Returns the polylines with two or more vertices. An apex has one vertex and is left out.
pub(crate) fn polylines(of: &[Vec<u32>], closed: bool) -> Lines {
    let lines = of.iter().filter(|vertices| vertices.len() > 1);
    Lines::Polylines(lines.map(|vertices| Polyline { vertices: vertices.clone(), closed }).collect())
}

/// Returns the statistics as JSON. A figure that is not finite would be a solver's defect and becomes null, because
/// JSON cannot hold it.
pub(crate) fn to_json(statistics: &impl Serialize) -> Result<String, Error> {
    serde_json::to_string(statistics).map_err(|error| Error::no_result(Reason::Internal, error.to_string()))
}

pub(crate) fn archive(contents: Contents) -> Result<Archive, Error> {
    Archive::new(contents).map_err(|defect| Error::no_result(Reason::InvalidMesh, defect.to_string()))
}

/// Length of the longest arrow of a reaction, as a fraction of the radius of the mesh.
const LONGEST_ARROW: f64 = 0.25;

/// Returns one arrow for each support, which starts there and points along the force of the support on the structure.
/// Lengths are proportional to the forces, and the longest is [`LONGEST_ARROW`] times the radius of the vertices.
pub(crate) fn reactions(
    supports: Vec<(DVec3, DVec3)>,
    vertices: &[DVec3],
    forces: impl Fn(Vec<f64>) -> Attribute,
) -> LineSet {
    let largest = supports.iter().map(|(_, force)| force.length()).fold(0.0, f64::max);
    let radius = LONGEST_ARROW * polyline::radius(vertices);
    // Dividing first keeps the arrows finite however small the forces are.
    let arrow = |force: DVec3| if largest > 0.0 { radius * (force / largest) } else { DVec3::ZERO };
    let ends = supports.iter().map(|&(foot, force)| [foot, foot + arrow(force)].map(|end| end.to_array())).collect();
    let attributes = vec![forces(supports.iter().map(|(_, force)| force.length()).collect())];
    LineSet { attributes, ..line_set("reactions", Lines::Arrows(ends)) }
}
