//! Coarse to fine: solves a coarse mesh, halves every edge, corrects the result, and repeats the last two steps until
//! the mesh is as fine as wanted.
//!
//! 1. Every 2^k-th point of each boundary, and every corner, bounds a coarse mesh of a few thousand triangles. The
//!    [default solver](crate::solvers::newton) solves it.
//! 2. Every edge is halved. If a boundary edge skips input points, the new vertex is the middle one of these. Otherwise
//!    it is the middle of the edge, if points may be added. In the end every input point is a vertex.
//! 3. Newton's method in normal heights corrects the finer mesh. Its linear systems are solved by conjugate gradients
//!    over the nested levels ([`multigrid`](plateau_mesh::sparse::multigrid)). The start deviates only by the sagitta
//!    of a coarse edge, so one or two steps suffice.
//!    Before the last correction the vertices slide along the film to where its triangles have less area
//!    ([`sliding`](plateau_mesh::remesh::sliding)).
//! 4. Small angles of the corrected mesh are widened locally, and the mesh is corrected again. Halving keeps the
//!    angles, but where the film bends strongly (at re-entrant corners) each correction makes them smaller.
//!
//! After step 4 the meshes are no longer exactly nested around the widened angles. The matrices of the levels remain a
//! good preconditioner, because the vertices that remain keep their parents. The extrapolated area is computed from the
//! areas before step 4, because those meshes are nested.
//!
//! Work and memory are proportional to the size of the mesh. If the method does not apply (the corners are too dense to
//! skip points, a triangle is flipped, multigrid does not converge), the caller solves the full mesh directly.

mod boundary_places;
mod plan;

use crate::extrapolation::{self, Finer, order};
use crate::initial_mesh;
use crate::options::{BoundarySampling, OnUnstable, Options};
use crate::run::{ExtrapolatedArea, Stability, StabilityMethod};
use crate::solved_film::SolvedFilm;
use crate::solvers::necks::{Look, compare, has_fine_ends, is_calm};
use crate::solvers::newton::{EXTRAPOLATED_TRIANGLES, LEAST_SLID_ANGLE, NARROW, Solve, Task, WIDE, WIDENINGS};
use boundary_places::BoundaryPlaces;
use plan::Plan;
use plateau_equilibrium::form_finding::StopReason;
use plateau_equilibrium::newton::{Aim, Equations, Settings};
use plateau_equilibrium::normal_motion::{FilmState, NormalMotion};
use plateau_equilibrium::stability::{self, MorseIndex, WithMargin};
use plateau_equilibrium::v_cycle::VCycleSteps;
use plateau_mesh::film::Film;
use plateau_mesh::measure;
use plateau_mesh::remesh::isotropic::BoundaryEdges;
use plateau_mesh::remesh::sliding::slide;
use plateau_mesh::remesh::small_angles::{smallest_angle, widen};
use plateau_mesh::sparse::multigrid::{self, Hierarchy, Parents, parents_of};
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::sparse::{Symbolic, SymmetricMatrix, Unsolved};
use plateau_mesh::{DVec3, Error, Execution, Interruption};

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// Residual to which the levels between the coarsest and the finest are solved.
const MIDDLE_TOLERANCE: f64 = 1e-3;
/// Largest number of triangles for which the Morse index is computed by a factorisation. Above it the sign of the
/// lowest eigenvalue decides, which costs far less on a large mesh.
const INERTIA_TRIANGLES: usize = 250_000;
/// Number of sweeps in which all vertices of the finest mesh slide. A mesh that is solved directly needs more sweeps.
/// Here one is enough, because the triangles of the finest mesh are quarters of good triangles.
const FULL_SWEEPS: u32 = 1;
/// Largest number of Newton steps on one level. One or two are usual, so a level that needs more steps than this does
/// not converge.
const STEPS_PER_LEVEL: u32 = 12;

/// Solves coarse to fine. `arrangement` selects the plane layout of three or more boundaries (see
/// [`initial_mesh::build`]). `None` if the wanted mesh is too small for the method, or the method does not apply.
///
/// # Errors
/// [`Error::Interrupted`] on cancel, and on a deadline before there is a mesh.
pub(crate) fn solve(
    boundaries: &[Vec<DVec3>],
    options: &Options,
    arrangement: Option<usize>,
    on_unstable: OnUnstable,
    exec: &Execution,
) -> Result<Option<SolvedFilm>, Error> {
    // A coarse polygon may bound no film although the full polygon does. In this case the next plan keeps more points.
    for plan in Plan::from_coarse(boundaries, options) {
        if let Some(solved) = follow(&plan, boundaries, options, arrangement, on_unstable, exec)? {
            return Ok(Some(solved));
        }
    }
    Ok(None)
}

fn follow(
    plan: &Plan,
    boundaries: &[Vec<DVec3>],
    options: &Options,
    arrangement: Option<usize>,
    on_unstable: OnUnstable,
    exec: &Execution,
) -> Result<Option<SolvedFilm>, Error> {
    let coarse_options = Options { resolution: plan.resolution, ..options.clone() };
    let coarse = plan.coarse_boundaries(boundaries);
    let (mut film, kind) = match initial_mesh::build(&coarse, &coarse_options, arrangement, exec) {
        Ok((start, kind)) => (start.refined(exec)?, kind),
        Err(Error::Interrupted(interruption)) => return Err(interruption.into()),
        // The direct solve, which follows, reports the error for the whole request.
        Err(_) => return Ok(None),
    };
    let may_add = options.boundary_sampling != BoundarySampling::Keep;
    let Some(mut places) = BoundaryPlaces::new(&mut film, plan, boundaries, may_add) else { return Ok(None) };
    let initial_area = film.area();
    let boundary_edges = BoundaryEdges::Kept;
    // Only the finest mesh slides, because the angles of a coarser mesh would be widened again on the next level.
    let limits = options.limits();
    let (given, may_widen, may_refine, slides) = (false, true, true, false);
    let task = Task { limits, on_unstable, given, may_widen, may_refine, boundary_edges, slides };
    let mut solve = Solve::new(&film, task, exec);
    let (stop_reason, stability) = match climb(&mut film, &mut places, plan.levels, options.slides, &mut solve) {
        Ok(Some(stability)) => (StopReason::Residual, Some(stability)),
        Ok(None) | Err(Error::NoResult { .. }) => return Ok(None),
        Err(Error::Interrupted(Interruption::DeadlinePassed)) => (StopReason::Deadline, None),
        Err(error) => return Err(error),
    };
    // Ends because each refinement raises the level by one.
    while places.level < plan.levels {
        // After a deadline at a coarse level, the mesh is still refined until it has all boundary points.
        (film, _) = places.refine(&film);
    }
    let run = solve.into_run(stop_reason, stability);
    Ok(places.input_points_first(film).map(|film| SolvedFilm { film, kind, arrangement, initial_area, run }))
}

/// Solves the coarse film and corrects it level by level. On the last level the vertices slide if `slides` is set.
/// `None` if the method does not apply. The film must not be used in that case.
fn climb(
    film: &mut Film,
    places: &mut BoundaryPlaces,
    levels: u32,
    slides: bool,
    solve: &mut Solve,
) -> Result<Option<Stability>, Error> {
    // Each level costs four times as much as the level before. The coarsest level, with its many solves, costs about as
    // much as the next.
    let share = |level: u32| {
        let part = |level: u32| 4f64.powi(level as i32 - levels as i32);
        [if level == 0 { 0.0 } else { part(level - 1) }, part(level)]
    };
    solve.record.share = share(0);
    let Some(mut below) = coarsest(film, solve)? else { return Ok(None) };
    for level in 1..levels {
        solve.record.share = share(level);
        let tolerance = MIDDLE_TOLERANCE.max(solve.tolerance);
        let Some(level) = refine(film, places, &mut below, tolerance, false, solve)? else { return Ok(None) };
        let Corrected { state, parents, matrix } = level.corrected;
        below.hierarchy.push(matrix, parents);
        below.area = state.energy;
    }
    let coarse_order = order(film);
    solve.record.share = share(levels);
    let Some(last) = refine(film, places, &mut below, solve.tolerance, slides, solve)? else { return Ok(None) };
    let same_polygon =
        places.same_polygon.then(|| ExtrapolatedArea::new(below.area, last.area, coarse_order.min(order(film))));
    finish(film, below, last.corrected, levels, same_polygon, solve)
}

/// The levels solved up to now, and the data that the next finer level needs.
struct Levels {
    /// The pattern of the finest level.
    pattern: Pattern,
    hierarchy: Hierarchy,
    /// The area of the finest level before its small angles were widened.
    area: f64,
    /// The lowest mode on the finest level.
    mode: Vec<f64>,
    /// The stability margin on the coarsest level.
    margin: f64,
    /// The motion that belongs to the margin, on the finest level. Empty if the film is calm.
    margin_motion: Vec<f64>,
    /// Whether the film is so far from instability that its margin needs no check on the finest level.
    calm: bool,
}

/// Solves the coarsest level. `None` if it has no stable film.
fn coarsest(film: &mut Film, solve: &mut Solve) -> Result<Option<Levels>, Error> {
    let (_, Some((pattern, mut direct))) = solve.converge(film)? else { return Ok(None) };
    let motion = NormalMotion { pattern: &pattern, triangles: film.triangles(), radius: solve.radius };
    let state = motion.state(&film.vertices);
    let coarse = match stability::analyse(&film.vertices, &motion, &state, &mut direct, WithMargin::Yes, solve.exec) {
        Ok(Some(coarse)) => coarse,
        Ok(None) | Err(Unsolved::Refused(_)) => return Ok(None),
        Err(Unsolved::Interrupted(interruption)) => return Err(interruption.into()),
    };
    if coarse.morse_index.most > 0 {
        return Ok(None);
    }
    let Some(margin) = coarse.margin else { return Ok(None) };
    let Ok(factor) = direct.symbolic.factorise(&direct.matrix).map(|factorisation| factorisation.into_storage()) else {
        return Ok(None);
    };
    Ok(Some(Levels {
        calm: is_calm(film, margin.value),
        hierarchy: Hierarchy::new(direct.symbolic, factor),
        area: state.energy,
        mode: coarse.lowest.vector,
        margin: margin.value,
        margin_motion: margin.motion,
        pattern,
    }))
}

/// A level that was refined and corrected.
struct Level {
    corrected: Corrected,
    /// The area before its small angles were widened.
    area: f64,
}

/// Carries out steps 2 to 4 on one level: halves the edges of the film, corrects it and widens its small angles. The
/// vertices slide if `slides` is set.
fn refine(
    film: &mut Film,
    places: &mut BoundaryPlaces,
    below: &mut Levels,
    tolerance: f64,
    slides: bool,
    solve: &mut Solve,
) -> Result<Option<Level>, Error> {
    let work = 4 * film.triangles().len() as u64;
    let (fine, midpoints) = places.refine(film);
    *film = fine;
    solve.exec.look(work)?;
    solve.radius = film.radius();
    let mut pattern = Pattern::new(film.triangles(), &film.fixed);
    let coarse_unknown = std::mem::take(&mut below.pattern.free.unknown);
    let parents = parents_of(&coarse_unknown, &pattern.free.vertex, &midpoints);
    solve.exec.look(work)?;
    if slides {
        // Sliding also changes the heights of the vertices a little. The next correction restores them.
        slide(film, solve.radius, FULL_SWEEPS, solve.exec)?;
    }
    let Some(mut corrected) = correct(film, &pattern, parents, &below.hierarchy, tolerance, solve)? else {
        return Ok(None);
    };
    let area = corrected.state.energy;
    let mut origin: Vec<u32> = (0..film.vertices.len() as u32).collect();
    let mut is_widened = false;
    for _ in 0..WIDENINGS {
        let before = smallest_angle(film);
        if before >= if slides { LEAST_SLID_ANGLE } else { NARROW } {
            break;
        }
        let mut widened = film.clone();
        let Some(kept) = widen(&mut widened, WIDE, solve.exec)? else { break };
        let kept: Vec<u32> = kept.into_iter().map(|v| origin[v as usize]).collect();
        let finer = Pattern::new(widened.triangles(), &widened.fixed);
        let vertices: Vec<u32> = finer.free.vertex.iter().map(|&v| kept[v as usize]).collect();
        let parents = parents_of(&coarse_unknown, &vertices, &midpoints);
        solve.exec.look(work)?;
        match correct(&mut widened, &finer, parents, &below.hierarchy, tolerance, solve)? {
            Some(better) if smallest_angle(&widened) > before => {
                (*film, pattern, corrected, origin) = (widened, finer, better, kept);
                is_widened = true;
            }
            _ => break,
        }
    }
    if slides && is_widened {
        // Widening leaves uneven triangles, which slide once more.
        let (before, mut slid) = (smallest_angle(film), film.clone());
        slide(&mut slid, solve.radius, FULL_SWEEPS, solve.exec)?;
        let vertices: Vec<u32> = pattern.free.vertex.iter().map(|&v| origin[v as usize]).collect();
        let parents = parents_of(&coarse_unknown, &vertices, &midpoints);
        if let Some(better) = correct(&mut slid, &pattern, parents, &below.hierarchy, tolerance, solve)?
            && smallest_angle(&slid) >= before.min(LEAST_SLID_ANGLE)
        {
            (*film, corrected) = (slid, better);
        }
    }
    below.pattern = pattern;
    below.mode = multigrid::prolong(&below.mode, &corrected.parents);
    below.margin_motion =
        if below.calm { Vec::new() } else { multigrid::prolong(&below.margin_motion, &corrected.parents) };
    Ok(Some(Level { corrected, area }))
}

/// Computes the stability of the finest level, and the extrapolated area. The latter is `extrapolated` if the last two
/// levels have the same polygon; otherwise it comes from a finer mesh. `None` if the finest level has no stable film,
/// or if the levels do not resolve it.
fn finish(
    film: &Film,
    levels: Levels,
    Corrected { state, parents, mut matrix }: Corrected,
    halvings: u32,
    extrapolated: Option<ExtrapolatedArea>,
    solve: &mut Solve,
) -> Result<Option<Stability>, Error> {
    let Levels { pattern, mut hierarchy, mode, margin, margin_motion, calm, .. } = levels;
    if measure::count_flipped(&film.vertices, film.triangles(), &state.frame) > 0 {
        return Ok(None);
    }
    let motion = NormalMotion { pattern: &pattern, triangles: film.topology.triangles(), radius: solve.radius };
    solve.exec.look(film.triangles().len() as u64)?;
    motion.second_variation(&film.vertices, &state, 0.0, &mut matrix);
    let (mass, unit) = (&state.mass, 1.0 / solve.radius.powi(2));
    let precondition = |residual: &mut [f64]| {
        let solved = hierarchy.precondition(&matrix, &parents, residual);
        residual.copy_from_slice(&solved);
    };
    let multiply = |x: &[f64], product: &mut [f64]| matrix.multiply(x, product);
    let lowest = stability::lowest_mode(multiply, mass, unit, mode, precondition, solve.exec)?;
    let by_inertia = film.triangles().len() <= INERTIA_TRIANGLES;
    let index = if by_inertia {
        solve.exec.look(film.triangles().len() as u64)?;
        let Ok(symbolic) = Symbolic::analyse(&matrix, None) else { return Ok(None) };
        match stability::morse_index(&symbolic, &matrix, mass, unit, &state.constraints, solve.exec) {
            Ok(index) => index,
            Err(Unsolved::Refused(_)) => return Ok(None),
            Err(Unsolved::Interrupted(interruption)) => return Err(interruption.into()),
        }
    } else {
        MorseIndex { least: 0, most: 0 }
    };
    let rounding = stability::rounding_of_form(&matrix, &lowest.vector);
    if index.checked_against(lowest.eigenvalue, rounding).most > 0 {
        return Ok(None);
    }
    let look = if calm {
        Look::Exists(margin)
    } else {
        let stretching = stability::stretching(&film.vertices, &motion, &state, &matrix);
        let fine = extrapolation::margin(&matrix, &stretching, &hierarchy, &parents, margin_motion, solve.exec)?;
        compare(margin, fine, halvings)
    };
    // If the levels do not resolve the film, the next plan starts from a finer coarse mesh.
    let Look::Exists(margin) = look else { return Ok(None) };
    if !has_fine_ends(film) {
        return Ok(None);
    }
    if extrapolated.is_some() {
        solve.extrapolated_area = extrapolated;
    } else if film.triangles().len() <= EXTRAPOLATED_TRIANGLES {
        hierarchy.push(matrix, parents);
        let finer = Finer::of(film, &pattern, &hierarchy, solve.radius, None, solve.exec)?;
        solve.extrapolated_area = finer.map(|finer| finer.area);
    }
    Ok(Some(Stability {
        stable: Some(true),
        morse_index: Some(0),
        least_index: 0,
        lowest_eigenvalue: lowest.eigenvalue,
        method: if by_inertia { StabilityMethod::Inertia } else { StabilityMethod::Eigenvalue },
        margin: Some(margin),
    }))
}

/// Data of a level after [`correct`] has made its film stationary to the level's tolerance.
struct Corrected {
    state: FilmState,
    parents: Parents,
    /// The matrix of the last Newton step.
    matrix: SymmetricMatrix,
}

/// Carries out step 3 on one level. `None` if Newton's method or its linear solver does not converge.
fn correct(
    film: &mut Film,
    pattern: &Pattern,
    parents: Parents,
    hierarchy: &Hierarchy,
    tolerance: f64,
    solve: &mut Solve,
) -> Result<Option<Corrected>, Error> {
    let settings = Settings { aim: Aim::Minimum, tolerance, max_steps: STEPS_PER_LEVEL };
    let motion = NormalMotion { pattern, triangles: film.topology.triangles(), radius: solve.radius };
    let mut steps = VCycleSteps { hierarchy, parents, matrix: pattern.matrix() };
    let before = solve.record.iterations;
    let done = |part| 0.9 * part;
    let (reason, state) = solve.record.newton(&mut film.vertices, &motion, &mut steps, &settings, "newton", done)?;
    if reason != StopReason::Residual {
        return Ok(None);
    }
    let VCycleSteps { parents, mut matrix, .. } = steps;
    if solve.record.iterations == before {
        // No step was needed (the film is plane), so the matrix that the next level needs was not assembled yet.
        motion.second_variation(&film.vertices, &state, 0.0, &mut matrix);
    }
    Ok(Some(Corrected { state, parents, matrix }))
}
