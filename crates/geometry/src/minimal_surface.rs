//! Minimal surfaces: the least area, or another energy, among the meshes that span closed boundary polygons.
//!
//! [`solve`] is the front door: boundary polygons and a resolution in; a mesh, its measurements and the reason why the
//! solver stopped out. The boundary never moves; everything else is the solver's to place.
//!
//! Sources: Chen, Cai, Zheng, *Constructing Triangular Meshes of Minimal Area* (2008); Pinkall, Polthier, *Computing
//! Discrete Minimal Surfaces and Their Conjugates* (1993).

mod curvature;
mod drivers;
mod estimate;
mod extrapolation;
pub(crate) mod harmonic;
mod initial_mesh;
mod options;
mod outcome;
mod request;
mod run;
mod solvers;
mod statistics;
mod triple_junction;

pub use crate::remesh::thin_triangles::Pinch;
pub use curvature::Curvature;
pub use estimate::estimate_triangles;
pub use initial_mesh::InitialMeshKind;
pub use options::{
    BoundarySampling, Constraints, Description, InitialMesh, LARGEST_COUNT, LinearSolver, Objective, OnUnstable,
    Options, Process, Resolution, Solver, Topology,
};
pub use outcome::{ConstraintVertices, MinimalSurface};
pub use run::{
    ExtrapolatedArea, HistoryRow, SpanningComparison, SpanningTopology, Stability, StabilityMethod, StopReason,
};
pub use statistics::{MeanCurvature, Statistics};
pub use triple_junction::JunctionStatistics;

use crate::mesh::film::Film;
use crate::{DVec3, Error, Execution};
use drivers::{best_topology, free_topology, nested};
use outcome::finish;
use request::Input;
use run::Run;
use solvers::{chen_cai_zheng, dirichlet, liu_wang, newton as default_solver, pinkall_polthier};

/// Spans the boundaries (closed polygons that do not repeat their first point) with a mesh that makes the objective least.
///
/// The result is an oriented manifold whose boundary loops are exactly the given ones. It depends on nothing but the
/// arguments, to the byte, and turns, moves and scales with them up to rounding. Exactly equal neighbouring points are
/// merged, with the warning `merged_points`. The least found is a *local* one: a boundary may bound several minimal
/// surfaces, and which one comes out follows from the initial mesh. A surface that stopped above the tolerance is
/// returned with `converged: false` and the warning `not_converged`, at a deadline too.
///
/// # Errors
/// [`Error::Input`] for what the arguments themselves show (a coordinate that is not finite or beyond 1e50, neighbours
/// nearer than 1e-50 and not equal, fewer than three distinct points on a boundary, an impossible resolution); [`Error::NoResult`] if no valid mesh came out;
/// [`Error::Interrupted`] on cancel, and on a deadline that passes before there is a mesh.
pub fn solve(boundaries: &[Vec<DVec3>], options: &Options, exec: &Execution) -> Result<MinimalSurface, Error> {
    let input = Input::read(boundaries, options)?;
    exec.look(input.point_count() as u64)?;
    if let InitialMesh::Given(mesh) = &options.initial_mesh
        && triple_junction::has_junctions(&mesh.triangles)
    {
        let mut surface = triple_junction::solve(&input.given, &input.vertices, mesh, options, exec)?;
        surface.warnings.extend(input.merged_points());
        return Ok(surface);
    }
    let given = options;
    let options = &options.centred(input.centre);
    let newton = matches!(options.solver, Solver::Auto | Solver::Newton) && options.objective == Objective::MinimalArea;
    let solved = match options.topology {
        Topology::Best => Some(best_topology::solve(&input.centred, options, exec)?),
        Topology::Fixed if newton => nested::solve(&input.centred, options, exec)?,
        _ => None,
    };
    let (film, kind, initial_area, run) = match solved {
        Some(solved) => solved,
        None => {
            let (start, kind) = initial_mesh::build(&input.centred, options, exec)?;
            let mut film = start.refined(exec)?;
            let initial_area = film.area();
            let run = relax(&mut film, options, exec)?;
            (film, kind, initial_area, run)
        }
    };
    finish(input, film, kind, initial_area, run, given)
}

/// Runs the solver that is asked for from an initial mesh of the full size.
fn relax(film: &mut Film, options: &Options, exec: &Execution) -> Result<Run, Error> {
    match (options.objective, options.solver) {
        (Objective::MinimalMeanCurvature, _) | (_, Solver::LevenbergMarquardt) => liu_wang::run(film, options, exec),
        (Objective::MinimalDirichletEnergy, _) => dirichlet::run_once(film, exec),
        (_, Solver::VertexRelaxation) => chen_cai_zheng::run(film, options, exec),
        (_, Solver::PinkallPolthier) => pinkall_polthier::run(film, options, exec),
        (_, Solver::Auto | Solver::Newton) if options.topology == Topology::Free => {
            free_topology::run(film, options, exec)
        }
        (_, Solver::Auto | Solver::Newton) => default_solver::run(film, options, exec),
    }
}

/// What [`solve`] would say of its arguments before any work: linear in the number of points.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with. Arguments that pass may still turn out to have no valid mesh.
pub fn check(boundaries: &[Vec<DVec3>], options: &Options) -> Result<(), Error> {
    let input = Input::read(boundaries, options)?;
    if let InitialMesh::Given(mesh) = &options.initial_mesh
        && triple_junction::has_junctions(&mesh.triangles)
    {
        return triple_junction::check(&input.given, mesh, options);
    }
    initial_mesh::check(&input.centred, &options.centred(input.centre))
}
