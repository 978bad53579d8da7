//! Turns a request into a stored result. Every solver is called here, for jobs and for the command line. Besides
//! `wire`, this is the only file that knows both the types of the wire and those of the geometry.

use super::progress::Signal;
use crate::wire::cable_net::{CableNetStatistics, Group};
use crate::wire::job::{JobError, JobWarning, Progress};
use crate::wire::minimal_surface::{CertificateDocument, MinimalStatistics};
use crate::wire::ruled_surface::RuledStatistics;
use crate::wire::tensile_structure::TensileStatistics;
use crate::wire::uniform_mesh::{UniformStatistics, input_vertices};
use crate::wire::{FieldError, MAX_ERRORS, Problem, Request};
use plateau_archive::archive::{CABLES, Certificate, Contents, middle};
use plateau_archive::pattern::BRIDGES;
use plateau_archive::units::ForceUnit;
use plateau_archive::{Archive, LineSet, Lines, MeanCurvature, Polyline, SegmentValues};
use plateau_film::cable_net;
use plateau_film::minimal_surface::{self, StopReason};
use plateau_film::tensile_structure;
use plateau_lower_bound as lower_bound;
use plateau_mesh::error::Warning;
use plateau_mesh::{DVec3, Error, Execution, Interruption, Mesh, polyline};
use plateau_ruled_surface as ruled_surface;
use plateau_uniform_mesh as uniform_mesh;
use serde::Serialize;

/// A solved request.
#[derive(Debug)]
pub struct Solved {
    /// Statistics as JSON text.
    pub statistics: String,
    pub warnings: Vec<JobWarning>,
    pub archive: Archive,
    /// Whether the same request always gives this result. False if a deadline cut the solver short.
    pub reproducible: bool,
}

/// Reason for having no result.
#[derive(Debug)]
pub enum Unsolved {
    /// The job was cancelled.
    Cancelled,
    /// The solver found no valid mesh.
    Failed(JobError),
}

impl Unsolved {
    /// Returns the error for a deadline that passed before the solver had a valid mesh.
    #[must_use]
    pub fn deadline() -> Self {
        let detail = "the deadline passed before there was a valid mesh; ask for a coarser one";
        Self::Failed(JobError::new("deadline", detail, Vec::new()))
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
                JobError::new("invalid-geometry", causes(&fields), fields)
            }
            Error::NoResult { reason, detail, places } => {
                JobError::new(&reason.replace('_', "-"), detail, fields(&places))
            }
        })
    }
}

/// Returns the first error as text, with the number of the others.
pub(super) fn causes(errors: &[FieldError]) -> String {
    let Some(first) = errors.first() else { return "the request was refused".into() };
    let first_one = format!("{} {}", first.pointer, first.detail);
    match errors.len() - 1 {
        0 => first_one,
        1 => format!("{first_one}; one more error is listed in errors"),
        more => format!("{first_one}; {more} more errors are listed in errors"),
    }
}

/// Solves a request on the calling thread. The solver calls `signal` at least every 50 ms.
///
/// # Errors
/// Returns the error of the solver.
pub fn solve(request: &Request, signal: &dyn Fn() -> Signal, report: &dyn Fn(Progress)) -> Result<Solved, Unsolved> {
    let signal = || match signal() {
        Signal::Continue => plateau_mesh::Signal::Continue,
        Signal::Cancel => plateau_mesh::Signal::Cancel,
        Signal::Deadline => plateau_mesh::Signal::Deadline,
    };
    let report = |progress| report(on_the_wire(progress));
    let exec = Execution::new(&signal, &report);
    let solved = match &request.problem {
        Problem::RuledSurface { directrices, options } => ruled(request, directrices, options, &exec),
        Problem::MinimalSurface { boundaries, options, certify } => {
            minimal(request, boundaries, options, certify.as_ref(), &exec)
        }
        Problem::UniformMesh { domain, options } => uniform(request, domain, options, &exec),
        Problem::TensileStructure { structure, options, force } => tensile(request, structure, options, *force, &exec),
        Problem::CableNet { net, options, groups, force } => cables(request, net, options, groups, *force, &exec),
    };
    let mut solved = solved?;
    solved.warnings.extend(far_from_zero(&solved.archive));
    Ok(solved)
}

/// Warns of a mesh whose STL file is not in the request's coordinates.
fn far_from_zero(archive: &Archive) -> Option<JobWarning> {
    let detail = "the mesh is so far from zero, compared with its size, that 32-bit numbers cannot hold its coordinates: \
        STL files are relative to `origin` of the statistics, unless they are asked for with `origin=given`";
    let warning = || JobWarning { code: JobWarning::FAR_FROM_ZERO.into(), detail: detail.into() };
    archive.contents().is_far_from_zero().then(warning)
}

fn origin(mesh: &Mesh) -> [f64; 3] {
    middle(&mesh.vertices).to_array()
}

fn on_the_wire(progress: plateau_mesh::Progress) -> Progress {
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

fn warnings(warnings: Vec<Warning>) -> Vec<JobWarning> {
    warnings.into_iter().map(|warning| JobWarning { code: warning.code.into(), detail: warning.detail }).collect()
}

fn generator() -> String {
    concat!("plateau ", env!("CARGO_PKG_VERSION")).into()
}

fn line_set(name: &str, lines: Lines) -> LineSet {
    LineSet { name: name.into(), group: String::new(), lines }
}

/// Returns the polylines with two or more vertices. An apex has one vertex and is left out.
fn polylines(of: &[Vec<u32>], closed: bool) -> Lines {
    let lines = of.iter().filter(|vertices| vertices.len() > 1);
    Lines::Polylines(lines.map(|vertices| Polyline { vertices: vertices.clone(), closed }).collect())
}

/// Returns the statistics as JSON. A figure that is not finite would be a solver's defect and becomes null, because
/// JSON cannot hold it.
fn to_json(statistics: &impl Serialize) -> Result<String, Error> {
    serde_json::to_string(statistics).map_err(|error| Error::no_result("internal", error.to_string()))
}

fn archive(contents: Contents) -> Result<Archive, Error> {
    Archive::new(contents).map_err(|defect| Error::no_result("invalid_mesh", defect.to_string()))
}

/// Lower bound of the end of the default colour scale of the mean curvature, times the boundary's radius. 95% of the
/// vertices of a converged film of usual resolution are below it, so that its discretisation is no rainbow.
const LEAST_RANGE: f64 = 0.01;

fn minimal(
    request: &Request,
    boundaries: &[Vec<DVec3>],
    options: &minimal_surface::Options,
    certify: Option<&lower_bound::Options>,
    exec: &Execution,
) -> Result<Solved, Error> {
    let share = if certify.is_some() { 0.5 } else { 1.0 };
    let mut surface = exec.part([0.0, share], |exec| minimal_surface::solve(boundaries, options, exec))?;
    let mut statistics = MinimalStatistics::of(&surface.statistics, origin(&surface.mesh));
    let mut reproducible = surface.statistics.stop_reason != StopReason::Deadline;
    let mut certificate = None;
    if let Some(certify) = certify {
        let bound = |exec: &Execution| lower_bound::certify(boundaries, &surface.mesh, certify, exec);
        let bound = if surface.statistics.junctions.is_some() {
            Err("the film has triple junctions, and the bound holds for oriented surfaces only")
        } else {
            let bound = exec.part([share, 1.0], bound)?;
            bound.ok_or("the coordinates are too large for the boundary's size, or the film has no area")
        };
        match bound {
            Ok(bound) => {
                statistics = statistics.certified(&bound);
                reproducible &= !bound.interrupted;
                let proof = to_json(&CertificateDocument::of(&bound))?;
                certificate = Some(Certificate { slack: bound.slack, proof });
            }
            Err(reason) => {
                surface.warnings.push(Warning::new("no_certificate", format!("no lower bound was computed: {reason}")))
            }
        }
    }
    let statistics = to_json(&statistics)?;
    let points: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
    let centre = polyline::mean(&points);
    let radius = points.iter().map(|point| point.distance(centre)).fold(0.0, f64::max);
    let mut line_sets = vec![line_set("boundaries", polylines(&surface.boundaries, true))];
    if let Some(junctions) = &surface.statistics.junctions {
        line_sets.push(line_set("junctions", polylines(&junctions.curves, false)));
    }
    let archive = archive(Contents {
        generator: generator(),
        title: "minimal surface".into(),
        unit: request.unit,
        up: request.up,
        mesh: surface.mesh,
        mean_curvature: Some(MeanCurvature {
            values: surface.mean_curvature,
            least_range: if radius > 0.0 { LEAST_RANGE / radius } else { 0.0 },
        }),
        line_sets,
        input_vertices: surface.input_vertices,
        statistics: statistics.clone(),
        unrolls: false,
        certificate,
    })?;
    Ok(Solved { statistics, warnings: warnings(surface.warnings), archive, reproducible })
}

fn ruled(
    request: &Request,
    directrices: &[Vec<DVec3>],
    options: &ruled_surface::Options,
    exec: &Execution,
) -> Result<Solved, Error> {
    let surface = ruled_surface::solve(directrices, options, exec)?;
    let statistics = to_json(&RuledStatistics::of(&surface, options, origin(&surface.mesh)))?;
    let unrolls = surface.flat_pattern.is_some();
    let archive = archive(Contents {
        generator: generator(),
        title: "ruled surface".into(),
        unit: request.unit,
        up: request.up,
        mesh: surface.mesh,
        mean_curvature: None,
        line_sets: vec![
            line_set("directrices", polylines(&surface.directrices, options.closed)),
            line_set(BRIDGES, Lines::Segments { pairs: surface.bridges, values: None }),
        ],
        input_vertices: surface.input_vertices,
        statistics: statistics.clone(),
        unrolls,
        certificate: None,
    })?;
    Ok(Solved { statistics, warnings: warnings(surface.warnings), archive, reproducible: true })
}

fn uniform(
    request: &Request,
    domain: &uniform_mesh::Domain,
    options: &uniform_mesh::Options,
    exec: &Execution,
) -> Result<Solved, Error> {
    let solved = uniform_mesh::solve(domain, options, exec)?;
    let statistics = to_json(&UniformStatistics::of(&solved, options, origin(&solved.mesh)))?;
    // Lattice and rim members are separate groups with their own material, so that a viewer can tell them apart.
    let group = |name: &str, lattice: bool| {
        let of = || (0..solved.members.len()).filter(|&member| solved.lattice_group[member] == lattice);
        let unit = request.unit.symbol().into();
        let values = of().map(|member| solved.lengths[member]).collect();
        let pairs = of().map(|member| solved.members[member]).collect();
        let values = Some(SegmentValues { name: "length".into(), unit, values });
        LineSet { name: "members".into(), group: name.into(), lines: Lines::Segments { pairs, values } }
    };
    let line_sets = vec![group("lattice", true), group("rim", false)];
    let archive = archive(Contents {
        generator: generator(),
        title: "uniform mesh".into(),
        unit: request.unit,
        up: request.up,
        input_vertices: input_vertices(domain, &solved),
        mesh: solved.mesh,
        mean_curvature: None,
        line_sets,
        statistics: statistics.clone(),
        unrolls: false,
        certificate: None,
    })?;
    Ok(Solved { statistics, warnings: warnings(solved.warnings), archive, reproducible: solved.converged })
}

/// Length of the longest arrow of a reaction, as a fraction of the radius of the mesh.
const LONGEST_ARROW: f64 = 0.25;

fn tensile(
    request: &Request,
    structure: &tensile_structure::Structure,
    options: &tensile_structure::Options,
    force: ForceUnit,
    exec: &Execution,
) -> Result<Solved, Error> {
    let found = tensile_structure::solve(structure, options, exec)?;
    let statistics = to_json(&TensileStatistics::of(&found, structure, force, origin(&found.mesh)))?;
    let forces = |values: Vec<f64>| Some(SegmentValues { name: "force".into(), unit: force.symbol().into(), values });
    let mut line_sets = vec![line_set("boundaries", polylines(&found.boundaries, true))];
    for (cable, result) in structure.cables.iter().zip(&found.cables) {
        let pairs = result.vertices.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let lines = Lines::Segments { pairs, values: forces(result.segment_forces.clone()) };
        let name = if cable.course.is_mast() { "masts" } else { CABLES };
        line_sets.push(LineSet { name: name.into(), group: cable.name.clone(), lines });
    }
    let feet = found.reactions.iter().map(|reaction| (found.mesh.vertices[reaction.vertex as usize], reaction.force));
    line_sets.push(line_set("reactions", reactions(feet.collect(), &found.mesh.vertices, forces)));
    let archive = archive(Contents {
        generator: generator(),
        title: "tensile structure".into(),
        unit: request.unit,
        up: request.up,
        input_vertices: found.input_vertices,
        mesh: found.mesh,
        mean_curvature: None,
        line_sets,
        statistics: statistics.clone(),
        unrolls: false,
        certificate: None,
    })?;
    let reproducible = found.statistics.stop_reason != StopReason::Deadline;
    Ok(Solved { statistics, warnings: warnings(found.warnings), archive, reproducible })
}

/// Returns an arrow for each support and its force on the structure, from the support in the direction of the force. The
/// longest arrow has [`LONGEST_ARROW`] of the radius of the vertices.
fn reactions(
    supports: Vec<(DVec3, DVec3)>,
    vertices: &[DVec3],
    forces: impl Fn(Vec<f64>) -> Option<SegmentValues>,
) -> Lines {
    let largest = supports.iter().map(|(_, force)| force.length()).fold(0.0, f64::max);
    let radius = LONGEST_ARROW * polyline::radius(vertices);
    // Dividing first keeps the arrows finite however small the forces are.
    let arrow = |force: DVec3| if largest > 0.0 { radius * (force / largest) } else { DVec3::ZERO };
    Lines::Arrows {
        ends: supports.iter().map(|&(foot, force)| [foot, foot + arrow(force)].map(|end| end.to_array())).collect(),
        values: forces(supports.iter().map(|(_, force)| force.length()).collect()),
    }
}

/// Number of edges that a warning names.
const NAMED_EDGES: usize = 10;

fn cables(
    request: &Request,
    net: &cable_net::Net,
    options: &cable_net::Options,
    groups: &[Group],
    force: ForceUnit,
    exec: &Execution,
) -> Result<Solved, Error> {
    let found = cable_net::solve(net, options, exec)?;
    let statistics = to_json(&CableNetStatistics::of(&found, net, groups, force, middle(&found.vertices).to_array()))?;
    let forces = |values: Vec<f64>| Some(SegmentValues { name: "force".into(), unit: force.symbol().into(), values });
    let lines = |group: &Group| Lines::Segments {
        pairs: group.edges.iter().map(|&k| net.edges[k].ends).collect(),
        values: forces(group.edges.iter().map(|&k| found.forces[k]).collect()),
    };
    let set = |group: &Group| LineSet { name: CABLES.into(), group: group.name.clone(), lines: lines(group) };
    let mut line_sets: Vec<LineSet> = groups.iter().map(set).collect();
    let feet = net.supports.iter().map(|&v| found.vertices[v as usize]).zip(found.reactions.iter().copied());
    line_sets.push(line_set("reactions", reactions(feet.collect(), &found.vertices, forces)));
    let warnings = warnings(net_warnings(&found));
    let archive = archive(Contents {
        generator: generator(),
        title: "cable net".into(),
        unit: request.unit,
        up: request.up,
        input_vertices: vec![(0..found.vertices.len() as u32).collect()],
        mesh: Mesh::new(found.vertices, Vec::new()),
        mean_curvature: None,
        line_sets,
        statistics: statistics.clone(),
        unrolls: false,
        certificate: None,
    })?;
    let reproducible = found.stop_reason != cable_net::StopReason::Deadline;
    Ok(Solved { statistics, warnings, archive, reproducible })
}

fn net_warnings(found: &cable_net::CableNet) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if !found.converged() {
        let detail = format!(
            "the net is in equilibrium, but the loss still fell when the solver stopped ({}): allow more iterations",
            found.stop_reason.name()
        );
        warnings.push(Warning::new("not_converged", detail));
    }
    let slack: Vec<usize> = (0..found.slack.len()).filter(|&k| found.slack[k]).collect();
    if !slack.is_empty() {
        let names: Vec<String> = slack.iter().take(NAMED_EDGES).map(|k| format!("/edges/{k}")).collect();
        let more = slack.len() - names.len();
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        let detail = format!(
            "the targets leave these edges no force; least_force_density keeps them in tension: {}{more}",
            names.join(", ")
        );
        warnings.push(Warning::new("slack_cable", detail));
    }
    warnings
}
