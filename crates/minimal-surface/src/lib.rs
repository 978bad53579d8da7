//! Minimal surfaces: meshes that span closed boundary polygons and minimise the area or another energy.
//!
//! The main function is [`solve`]. It takes boundary polygons and a resolution, and returns a mesh with its
//! measurements and the reason why the solver stopped. The boundary never moves; the solver places all other vertices.
//!
//! ```
//! use plateau_minimal_surface::{Method, Options, PinkallPolthier, Resolution, solve};
//! use plateau_mesh::{DVec3, Execution};
//!
//! // Two circles of radius 1, half a unit apart: a catenoid.
//! let circle = |height: f64| -> Vec<DVec3> {
//!     let angles = (0..40).map(|k| std::f64::consts::TAU * f64::from(k) / 40.0);
//!     angles.map(|angle| DVec3::new(angle.cos(), angle.sin(), height)).collect()
//! };
//! let rings = [circle(0.0), circle(0.5)];
//! let options = Options::new(Resolution::Triangles(800));
//! let surface = solve(&rings, &options, &Execution::default())?;
//! assert!(surface.statistics.converged);
//! assert_eq!(surface.statistics.genus, Some(0));
//! assert_eq!(surface.statistics.stability.and_then(|stability| stability.morse_index), Some(0));
//! // Between the cylinder's area, π, and a little less.
//! assert!((3.0..std::f64::consts::PI).contains(&surface.statistics.area));
//!
//! // Another solver has options of its own.
//! let method = Method::PinkallPolthier(PinkallPolthier { area_tolerance: 1e-4, ..PinkallPolthier::default() });
//! let slower = solve(&rings, &Options { method, ..options }, &Execution::default())?;
//! assert!((slower.statistics.area / surface.statistics.area - 1.0).abs() < 1e-3);
//! # Ok::<(), plateau_mesh::Error>(())
//! ```
//!
//! # Sources
//! - Chen, Cai, Zheng, *Constructing Triangular Meshes of Minimal Area* (2008): `solvers/chen_cai_zheng`, with the
//!   initial mesh of rings in `initial_mesh/rings`.
//! - Liu, Wang, *Constructing minimal triangular mesh based on discrete mean curvature* (2011): `solvers/liu_wang`,
//!   with the initial mesh of barycentres in `initial_mesh/barycentres`.
//! - Bento, Cavalcanti, *Computação de superfícies mínimas discretas*, after Pinkall, Polthier, *Computing Discrete
//!   Minimal Surfaces and Their Conjugates* (1993): `solvers/pinkall_polthier`.
//!
//! The default solver is Newton's method (`solvers/newton`), on meshes from coarse to fine (`drivers/nested`).
//!
//! # Glossary
//! - *Boundary loop*: a closed polyline that bounds a surface. Boundary vertices do not move.
//! - *Film*: a mesh between boundary loops while a solver works on it. *Sheet*: a part of a film between junctions.
//!   *Junction*: a curve along which three sheets meet.
//! - *Pinch*: a change of topology where a neck closes.
//!
//! The crate [`plateau_equilibrium`] says what a residual, a Morse index and an unstable mode are.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
#![warn(missing_docs)]

mod cone;
mod curvature;
mod drivers;
mod estimate;
mod extrapolation;
mod harmonic;
mod initial_mesh;
mod junction_statistics;
mod kept_film;
mod options;
mod outcome;
mod request;
mod run;
mod solved_film;
mod solvers;
mod statistics;
mod touching_boundaries;
mod triple_junction;

pub use curvature::Curvature;
pub use estimate::estimate;
pub use initial_mesh::InitialMeshKind;
pub use junction_statistics::JunctionStatistics;
pub use kept_film::{KeptFilm, MovedFilm};
pub use options::{
    BoundarySampling, Constraints, Description, FreeTopology, InitialMesh, LARGEST_COUNT, LinearSolver, LiuWang,
    Method, Newton, Objective, OnUnstable, Options, PinkallPolthier, Process, Resolution, SegmentPoint, Solver,
    TopologyRule, VertexRelaxation,
};
pub use outcome::{ConstraintVertices, MinimalSurface};
pub use run::{ExtrapolatedArea, HistoryRow, SpanningComparison, SpanningTopology, Stability, StabilityMethod};
pub use statistics::{MeanCurvature, Statistics};

use drivers::{best_topology, curvature_bound, free_topology, nested};
use outcome::finish;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::complex::has_junctions;
use plateau_mesh::film::Film;
use plateau_mesh::{DVec3, Error, Execution, Interruption};
use request::Input;
use run::Run;
use solved_film::SolvedFilm;
use solvers::{chen_cai_zheng, dirichlet, liu_wang, newton as default_solver, pinkall_polthier};
use touching_boundaries::JoinedLoops;

/// Spans the boundaries (closed polygons that do not repeat their first point) with a mesh that minimises the
/// objective.
///
/// The result is an oriented manifold whose boundary loops are exactly the given boundaries. (A film with junctions is
/// not a manifold.) The result depends only on the arguments. On processors with the same vector instructions it is the
/// same to the byte. If the arguments are rotated, moved or scaled, the result is too, up to rounding.
///
/// Neighbouring points that are equal, or nearer than 1e-9 of the boundary's radius, are merged, with the warning
/// `merged_points`. The minimum is a *local* minimum: a boundary may bound several minimal surfaces, and the initial
/// mesh decides which of them is found.
///
/// If the solver did not meet its own rule, also at a deadline, the surface is returned with `converged: false` and the
/// warning `not_converged`. If the solver met its own rule on a film of least area whose residual is above the
/// tolerance, the film carries the warning `not_minimal`.
///
/// # Errors
/// [`Error::Input`] if the arguments themselves are wrong (a coordinate that is not finite or beyond 1e50, neighbours
/// that are nearer than 1e-50 and not equal, fewer than three distinct points on a boundary, an impossible resolution).
/// [`Error::NoResult`] if no valid mesh was found, with the reason `no_connected_film` if several boundaries had to be
/// connected ([`TopologyRule::Fixed`]) and the film did not hold. [`Error::Interrupted`] on cancel, and at a deadline
/// that passes before there is a mesh.
pub fn solve(boundaries: &[Vec<DVec3>], options: &Options, exec: &Execution) -> Result<MinimalSurface, Error> {
    let input = Input::read(boundaries, options)?;
    let shared = input.shared_point();
    solve_input(input, options, exec).map_err(|error| Input::with_shared_point(shared, error))
}

fn solve_input(input: Input, options: &Options, exec: &Execution) -> Result<MinimalSurface, Error> {
    exec.look(input.point_count() as u64)?;
    if let InitialMesh::Given(mesh) = &options.initial_mesh
        && has_junctions(&mesh.triangles)
    {
        let mut surface = triple_junction::solve(&input.given, &input.vertices, mesh, options, exec)?;
        surface.warnings.extend(input.warnings());
        return Ok(surface);
    }
    let given = options;
    let options = &options.centred(input.centre);
    let joined = JoinedLoops::of(&input, options, exec).map_err(|error| input.placed_as_given(error))?;
    let boundaries = joined.as_ref().map_or(&input.centred, |joined| &joined.loops);
    let solved = match &options.method {
        Method::Newton(Newton { topology: TopologyRule::Best, .. }) => {
            Some(best_topology::solve(boundaries, options, exec)?)
        }
        // Nested meshes are not used for joined boundaries, because a coarser mesh may skip the points at which the
        // boundaries touch.
        Method::Newton(Newton { topology: TopologyRule::Fixed, on_unstable }) if joined.is_none() => {
            // The theorem of the cone does not cover films with fixed points inside. It does not cover a mesh of the
            // caller either, because the mesh may have several parts.
            if options.constraints.is_empty()
                && !matches!(options.initial_mesh, InitialMesh::Given(_))
                && let Some(parted) = cone::part(boundaries, exec)?
            {
                return Err(cone::refusal(&parted));
            }
            nested::solve(boundaries, options, None, *on_unstable, exec)?
        }
        _ => None,
    };
    let mut solved = match solved {
        Some(solved) => solved,
        None => {
            let built = initial_mesh::build(boundaries, options, None, exec);
            let (start, kind) = built.map_err(|error| input.placed_as_given(error))?;
            let mut film = start.refined(exec)?;
            let initial_area = film.area();
            let run = relax(&mut film, kind, options, exec)?;
            SolvedFilm { film, kind, arrangement: None, initial_area, run }
        }
    };
    if joined.is_none() {
        match other_start(boundaries, options, &solved, exec) {
            Ok(Some(other)) => solved = other,
            Ok(None) => {}
            // The deadline has ended the search. A start that was not tried may lead to a film.
            Err(Error::Interrupted(Interruption::DeadlinePassed)) => solved.run.stop_reason = StopReason::Deadline,
            Err(error) => return Err(error),
        }
    }
    if let (Some(bound), Method::Newton(_)) = (options.curvature_tolerance, &options.method) {
        curvature_bound::reach(&mut solved.film, &mut solved.run, bound, options.limits(), exec)?;
    }
    if let Some(joined) = &joined {
        joined.restore(&mut solved, &input);
    }
    let surface = finish(input, solved, joined.as_ref(), given)?;
    if matches!(given.method, Method::Newton(Newton { topology: TopologyRule::Fixed, .. })) {
        refuse_lost_film(&surface.statistics)?;
    }
    Ok(surface)
}

/// Returns the connected film that the search of [`TopologyRule::Best`] finds from other initial meshes, if the default
/// solver has failed on a film over several boundaries under another rule. `None` if the solver has not failed, if the
/// caller chose the start or limited the iterations, or if the search finds no film. The three rules would otherwise
/// contradict each other about whether a connected film exists.
fn other_start(
    boundaries: &[Vec<DVec3>],
    options: &Options,
    solved: &SolvedFilm,
    exec: &Execution,
) -> Result<Option<SolvedFilm>, Error> {
    let Method::Newton(Newton { topology: TopologyRule::Fixed | TopologyRule::Free(_), .. }) = options.method else {
        return Ok(None);
    };
    let reason = solved.run.stop_reason;
    let has_failed = matches!(reason, StopReason::Stalled | StopReason::Collapsed | StopReason::MaxIterations)
        || reason == StopReason::Residual && solved.film.flipped_triangles() > 0;
    let has_choice = options.initial_mesh == InitialMesh::Auto
        && options.constraints.is_empty()
        && options.max_iterations.is_none()
        && (2..=best_topology::MOST_BOUNDARIES).contains(&boundaries.len());
    if has_failed && has_choice { best_topology::connected_film(boundaries, options, exec) } else { Ok(None) }
}

/// Residual above which a film that has not converged is not near a minimal surface. At this residual the radius of
/// curvature of the film is as small as the boundary.
const LOST: f64 = 1.0;

/// Returns an error if the film had to connect several boundaries but the solver found no minimal surface that connects
/// them, because the mesh has collapsed, folded over, or stopped far from any minimal surface.
fn refuse_lost_film(statistics: &Statistics) -> Result<(), Error> {
    let ended = match statistics.stop_reason {
        StopReason::Collapsed => "collapsed",
        StopReason::Stalled | StopReason::Residual if statistics.quality.flipped_triangles > 0 => "folded over",
        StopReason::Stalled if statistics.quality.degenerate_triangles > 0 => "collapsed in part",
        StopReason::Stalled if statistics.residual > LOST => "stopped far from any",
        _ => return Ok(()),
    };
    if statistics.components >= statistics.boundary_loops {
        return Ok(());
    }
    Err(cone::not_connected(&format!("the mesh {ended}")))
}

/// Runs the requested solver from an initial mesh of the full size.
fn relax(film: &mut Film, kind: InitialMeshKind, options: &Options, exec: &Execution) -> Result<Run, Error> {
    let limits = options.limits();
    let given = matches!(options.initial_mesh, InitialMesh::Given(_));
    match &options.method {
        Method::LiuWang(method) => {
            let fairs = method.candidate_fairing && options.barycentres(film.boundaries.len()).is_some();
            liu_wang::run(film, method, fairs, limits, exec)
        }
        Method::Harmonic => dirichlet::run_once(film, exec),
        Method::VertexRelaxation(method) => chen_cai_zheng::run(film, method, limits, exec),
        Method::PinkallPolthier(method) => pinkall_polthier::run(film, method, limits, exec),
        Method::Newton(Newton { topology: TopologyRule::Free(free), .. }) => {
            free_topology::run(film, free, limits, given, exec)
        }
        Method::Newton(Newton { on_unstable, .. }) => {
            // Widening would move the bridges of a strip of rings away from the corners that they join.
            let may_widen = !given && kind != InitialMeshKind::Rings;
            let boundary_edges = options.boundary_edges();
            let (on_unstable, slides) = (*on_unstable, options.slides);
            let may_refine = !given && options.initial_mesh != InitialMesh::Rings;
            let task =
                default_solver::Task { limits, on_unstable, given, may_widen, may_refine, boundary_edges, slides };
            default_solver::run(film, task, exec)
        }
    }
}

/// Checks the arguments of [`solve`] without solving, in a time that is linear in the number of points.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would return for these arguments. Arguments that pass may still turn out to have
/// no valid mesh.
pub fn check(boundaries: &[Vec<DVec3>], options: &Options) -> Result<(), Error> {
    let input = Input::read(boundaries, options)?;
    if let InitialMesh::Given(mesh) = &options.initial_mesh
        && has_junctions(&mesh.triangles)
    {
        return triple_junction::check(&input.given, mesh, options);
    }
    initial_mesh::check(&input.centred, &options.centred(input.centre))
}

/// Compiles and runs the example of the README as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
