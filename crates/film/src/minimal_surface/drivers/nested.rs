//! Coarse to fine: solves a coarse mesh, halves every edge, corrects the result, and repeats until the mesh is as fine
//! as wanted.
//!
//! 1. Every 2^k-th point of each boundary, and every corner, bounds a coarse mesh of a few thousand triangles. The
//!    [default solver](crate::minimal_surface::solvers::newton) solves it.
//! 2. Every edge is halved. A new boundary vertex is the middle one of the input points that its edge skips. Where the
//!    edge skips none, and points may be added, it is the middle of the edge. In the end every input point is a vertex.
//! 3. Newton's method in normal heights corrects the finer mesh. Its linear systems are solved by conjugate gradients
//!    over the nested levels ([`multigrid`](plateau_mesh::sparse::multigrid)). The start deviates by the sagitta of a
//!    coarse edge, so one or two steps suffice.
//!    Before the last correction the vertices slide along the film to where its triangles have less area
//!    ([`sliding`](plateau_mesh::remesh::sliding)).
//! 4. Small angles of the corrected mesh are widened where they are, and the mesh is corrected again. Halving keeps
//!    angles, but where the film bends strongly (at re-entrant corners) each correction makes them smaller.
//!
//! After step 4 the meshes are no longer exactly nested around the widened angles. The matrices of the levels remain a
//! good preconditioner, because a vertex that is left keeps its parents. The extrapolated area is computed from the
//! areas before step 4, whose meshes are nested.
//!
//! Work and memory are proportional to the size of the mesh. If the method does not apply (the corners are too dense to
//! skip points, a triangle is flipped, multigrid does not converge), the caller solves the full mesh directly.

use crate::equilibrium::newton::{Aim, Equations, Outcome, Settings, iterate};
use crate::equilibrium::stability::{self, MorseIndex, Unknown, WithMargin};
use crate::equilibrium::v_cycle::VCycleSteps;
use crate::equilibrium::{FilmState, NormalMotion};
use crate::minimal_surface::estimate::{area_of_fans, estimate, triangles_of_length};
use crate::minimal_surface::extrapolation::{self, Finer, order};
use crate::minimal_surface::initial_mesh::{self, first_point};
use crate::minimal_surface::options::{BoundarySampling, InitialMesh, OnUnstable, Options, Resolution};
use crate::minimal_surface::run::{ExtrapolatedArea, Stability, StabilityMethod, StopReason, geometric_part};
use crate::minimal_surface::solved_film::SolvedFilm;
use crate::minimal_surface::solvers::necks::{Look, compare, has_fine_ends, is_calm};
use crate::minimal_surface::solvers::newton::{
    EXTRAPOLATED_TRIANGLES, LEAST_SLID_ANGLE, NARROW, Solve, Task, WIDE, WIDENINGS,
};
use plateau_mesh::film::Film;
use plateau_mesh::measure;
use plateau_mesh::remesh::isotropic::BoundaryEdges;
use plateau_mesh::remesh::sliding::slide;
use plateau_mesh::remesh::small_angles::{smallest_angle, widen};
use plateau_mesh::remesh::subdivision::subdivided_inside;
use plateau_mesh::sparse::multigrid::{self, Hierarchy, Parents, parents_of};
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::sparse::{Symbolic, SymmetricMatrix};
use plateau_mesh::{DVec3, Error, Execution, Interruption, polyline};

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// Smallest number of triangles of the coarse mesh. The first plan takes as many levels as this allows (at most 12),
/// each of which divides the number of triangles by four.
const LEAST_COARSE_TRIANGLES: f64 = 1000.0;
/// Smallest number of triangles of the coarse mesh per boundary vertex.
const COARSE_TRIANGLES_PER_BOUNDARY_VERTEX: f64 = 3.0;
/// A boundary vertex at which the boundary turns by more than this (radians) is a corner. A coarse edge replaces at
/// most this much turning.
const CORNER: f64 = 0.6;
/// Residual to which the levels between the coarsest and the finest are solved.
const MIDDLE_TOLERANCE: f64 = 1e-3;
/// Largest number of triangles for which the Morse index is computed by a factorisation. Above it the sign of the
/// lowest eigenvalue decides, which costs far less on a large mesh.
const INERTIA_TRIANGLES: usize = 250_000;
/// A boundary edge counts as long if it exceeds this multiple of the mean edge length of the mesh.
const LONG_EDGE: f64 = 1.6;
/// Number of sweeps in which all vertices of the finest mesh slide. It is smaller than for a mesh that is solved
/// directly, because the triangles of the finest mesh are quarters of good ones.
const FULL_SWEEPS: u32 = 1;
/// Largest number of Newton steps on one level. One or two are usual; more than this many mean that the level does not
/// converge.
const STEPS_PER_LEVEL: u32 = 12;

/// Solves coarse to fine, with three and more boundaries laid out in the plane as `arrangement` says (see
/// [`initial_mesh::build`]). `None` if the request is too small for the method, or the method does not apply.
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
    // A coarse polygon may bound no film although the polygon of all points does. The next plan keeps more points.
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
        // The error is reported for the whole request, by the direct solve.
        Err(_) => return Ok(None),
    };
    let may_add = options.boundary_sampling != BoundarySampling::Keep;
    let Some(mut places) = BoundaryPlaces::new(&mut film, plan, boundaries, may_add) else { return Ok(None) };
    let initial_area = film.area();
    let boundary_edges = BoundaryEdges::Kept;
    // Only the finest mesh slides: the angles of a coarser one would be widened again on the next level.
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
        // A deadline passed at a coarse level: the mesh is still refined until it has all boundary points.
        (film, _) = places.refine(&film);
    }
    let run = solve.into_run(stop_reason, stability);
    Ok(places.input_points_first(film).map(|film| SolvedFilm { film, kind, arrangement, initial_area, run }))
}

/// Solves the coarse film and corrects it level by level. On the last level the vertices slide if `slides`. `None` if
/// the method does not apply; the film is then of no use.
fn climb(
    film: &mut Film,
    places: &mut BoundaryPlaces,
    levels: u32,
    slides: bool,
    solve: &mut Solve,
) -> Result<Option<Stability>, Error> {
    // Each level costs four times as much as the last. The coarsest, with its many solves, costs about as much as the
    // next.
    let share = |level: u32| {
        let part = |level: u32| 4f64.powi(level as i32 - levels as i32);
        [if level == 0 { 0.0 } else { part(level - 1) }, part(level)]
    };
    solve.record.share = share(0);
    let (_, Some((mut pattern, mut direct))) = solve.converge(film)? else { return Ok(None) };
    let motion = NormalMotion { pattern: &pattern, triangles: film.triangles(), radius: solve.radius };
    let state = motion.state(&film.vertices);
    let coarse = match stability::analyse(&film.vertices, &motion, &state, &mut direct, WithMargin::Yes, solve.exec) {
        Ok(Some(coarse)) => coarse,
        Ok(None) | Err(Unknown::Refused(_)) => return Ok(None),
        Err(Unknown::Interrupted(interruption)) => return Err(interruption.into()),
    };
    if coarse.morse_index.most > 0 {
        return Ok(None);
    }
    let Some(margin) = coarse.margin else { return Ok(None) };
    // A film far from the edge of stability needs no further check. For any other film the margins on the coarsest and
    // on the finest level are compared.
    let calm = is_calm(film, margin.value);
    let mut mode = coarse.lowest.vector;
    let mut margin_motion = margin.motion;
    let mut coarse_area = state.energy;
    let Ok(factor) = direct.symbolic.factorise(&direct.matrix).map(|factorisation| factorisation.into_storage()) else {
        return Ok(None);
    };
    let mut hierarchy = Hierarchy::new(direct.symbolic, factor);
    for level in 1..=levels {
        let work = 4 * film.triangles().len() as u64;
        let (fine, midpoints) = places.refine(film);
        let last = level == levels;
        let coarse_order = if last { order(film) } else { 2.0 };
        *film = fine;
        solve.exec.look(work)?;
        let tolerance = if last { solve.tolerance } else { MIDDLE_TOLERANCE.max(solve.tolerance) };
        solve.radius = film.radius();
        solve.record.share = share(level);
        let coarse_unknown = pattern.free.unknown;
        pattern = Pattern::new(film.triangles(), &film.fixed);
        let parents = parents_of(&coarse_unknown, &pattern.free.vertex, &midpoints);
        solve.exec.look(work)?;
        let slides = slides && last;
        if slides {
            // Sliding also changes the heights of the vertices a little. The correction that follows makes up for that.
            slide(film, solve.radius, FULL_SWEEPS, solve.exec)?;
        }
        let Some(mut corrected) = correct(film, &pattern, parents, &hierarchy, tolerance, solve)? else {
            return Ok(None);
        };
        let nested_area = corrected.state.energy;
        let mut origin: Vec<u32> = (0..film.vertices.len() as u32).collect();
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
            match correct(&mut widened, &finer, parents, &hierarchy, tolerance, solve)? {
                Some(better) if smallest_angle(&widened) > before => {
                    (*film, pattern, corrected, origin) = (widened, finer, better, kept);
                }
                _ => break,
            }
        }
        let Corrected { state, parents, mut matrix } = corrected;
        mode = multigrid::prolong(&mode, &parents);
        margin_motion = if calm { Vec::new() } else { multigrid::prolong(&margin_motion, &parents) };
        let motion = NormalMotion { pattern: &pattern, triangles: film.topology.triangles(), radius: solve.radius };
        if last {
            if measure::count_flipped(&film.vertices, film.triangles(), &state.frame) > 0 {
                return Ok(None);
            }
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
                    Err(Unknown::Refused(_)) => return Ok(None),
                    Err(Unknown::Interrupted(interruption)) => return Err(interruption.into()),
                }
            } else {
                MorseIndex { least: 0, most: 0 }
            };
            let rounding = stability::rounding_of_form(&matrix, &lowest.vector);
            if index.checked_against(lowest.eigenvalue, rounding).most > 0 {
                return Ok(None);
            }
            let margin = if calm {
                Look::Exists(margin.value)
            } else {
                let stretching = stability::stretching(&film.vertices, &motion, &state, &matrix);
                let fine =
                    extrapolation::margin(&matrix, &stretching, &hierarchy, &parents, margin_motion, solve.exec)?;
                compare(margin.value, fine, levels)
            };
            // The levels do not resolve the film: the next plan begins with a finer mesh.
            let Look::Exists(margin) = margin else { return Ok(None) };
            if !has_fine_ends(film) {
                return Ok(None);
            }
            if places.same_polygon {
                solve.extrapolated_area =
                    Some(ExtrapolatedArea::new(coarse_area, nested_area, coarse_order.min(order(film))));
            } else if film.triangles().len() <= EXTRAPOLATED_TRIANGLES {
                hierarchy.push(matrix, parents);
                let finer = Finer::of(film, &pattern, &hierarchy, solve.radius, None, solve.exec)?;
                solve.extrapolated_area = finer.map(|finer| finer.area);
            }
            let lowest_eigenvalue = lowest.eigenvalue;
            let method = if by_inertia { StabilityMethod::Inertia } else { StabilityMethod::Eigenvalue };
            let margin = Some(margin);
            let (stable, morse_index, least_index) = (Some(true), Some(0), 0);
            return Ok(Some(Stability { stable, morse_index, least_index, lowest_eigenvalue, method, margin }));
        }
        hierarchy.push(matrix, parents);
        coarse_area = state.energy;
    }
    Ok(None)
}

/// Data of a level whose film [`correct`] has made stationary to the level's tolerance.
struct Corrected {
    state: FilmState,
    parents: Parents,
    /// The matrix of the last Newton step.
    matrix: SymmetricMatrix,
}

/// Step 3 on one level. `None` if Newton's method or its linear solver does not converge.
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
    let mut start = None;
    let (outcome, state) =
        iterate(&mut film.vertices, &motion, &mut steps, &settings, solve.exec, &mut |area, residual| {
            let part = geometric_part(*start.get_or_insert(residual), residual, tolerance);
            solve.record.iteration("newton", area, residual, 0.9 * part);
        });
    let VCycleSteps { parents, mut matrix, .. } = steps;
    if start.is_none() {
        // No step was needed (the film is plane), so nothing has assembled the matrix that the next level needs.
        motion.second_variation(&film.vertices, &state, 0.0, &mut matrix);
    }
    match outcome {
        Outcome::Converged => Ok(Some(Corrected { state, parents, matrix })),
        Outcome::Interrupted(interruption) => Err(interruption.into()),
        Outcome::Stalled | Outcome::StepsUsed | Outcome::Refused(_) => Ok(None),
    }
}

/// Which input points bound the coarse mesh, how large it is, and how often it will be refined.
#[derive(Debug)]
struct Plan {
    levels: u32,
    /// Resolution of the coarse mesh.
    resolution: Resolution,
    /// For each boundary the indices of the points that the coarse mesh keeps, ascending.
    kept: Vec<Vec<u32>>,
}

impl Plan {
    /// The plans for a request, the coarsest first.
    fn from_coarse(boundaries: &[Vec<DVec3>], options: &Options) -> impl Iterator<Item = Self> {
        let suits = matches!(options.initial_mesh, InitialMesh::Auto | InitialMesh::Planar | InitialMesh::Disk)
            && options.constraints.is_empty();
        let target = match options.resolution {
            // The number of triangles that cover the area. The additional triangles that `estimate` counts beside a
            // fine boundary are left out, because halving does not make them.
            Resolution::EdgeLength(length) => triangles_of_length(boundaries, length),
            _ => estimate(boundaries, options).triangles,
        };
        let suits =
            suits && !(options.boundary_sampling == BoundarySampling::Keep && has_long_edges(boundaries, target));
        let most =
            if suits { (0.5 * libm::log2(target / LEAST_COARSE_TRIANGLES)).floor().clamp(0.0, 12.0) as u32 } else { 0 };
        (1..=most).rev().filter_map(move |levels| {
            let kept: Vec<Vec<u32>> = boundaries.iter().map(|points| kept_points(points, 1 << levels)).collect();
            let boundary_vertices: usize = kept.iter().map(Vec::len).sum();
            // A boundary edge that skips no point stays whole, and the triangle at it becomes three instead of four.
            let points: usize = boundaries.iter().map(Vec::len).sum();
            let lost = match options.boundary_sampling {
                BoundarySampling::Keep => ((boundary_vertices << levels) as f64 - points as f64).max(0.0),
                BoundarySampling::Refine => 0.0,
            };
            let triangles = (target + lost) / f64::from(4u32.pow(levels));
            let resolution = match options.resolution {
                Resolution::Triangles(_) => Resolution::Triangles(triangles.round() as usize),
                Resolution::EdgeLength(length) => Resolution::EdgeLength(length * f64::from(1u32 << levels)),
                Resolution::InteriorVertices(_) => return None,
            };
            (triangles >= COARSE_TRIANGLES_PER_BOUNDARY_VERTEX * boundary_vertices as f64).then_some(Self {
                levels,
                resolution,
                kept,
            })
        })
    }

    fn coarse_boundaries(&self, boundaries: &[Vec<DVec3>]) -> Vec<Vec<DVec3>> {
        let pick = |(points, kept): (&Vec<DVec3>, &Vec<u32>)| kept.iter().map(|&k| points[k as usize]).collect();
        boundaries.iter().zip(&self.kept).map(pick).collect()
    }
}

/// Whether the boundary edges are on average much longer than the edges of a mesh of this number of triangles. If such
/// boundary edges must be kept, the triangles beside them have to be graded, and halving all other edges would not
/// leave them graded.
fn has_long_edges(boundaries: &[Vec<DVec3>], triangles: f64) -> bool {
    let length: f64 = boundaries.iter().map(|points| polyline::length(points, true)).sum();
    let points: usize = boundaries.iter().map(Vec::len).sum();
    let edge = (area_of_fans(boundaries) / (0.75f64.sqrt() / 2.0 * triangles)).sqrt();
    length / points as f64 > LONG_EDGE * edge
}

/// Indices of the points of a closed polygon that a coarse mesh keeps: all corners, and others at most `stride` apart,
/// so that no edge replaces more turning than a corner has. They do not depend on which point the polygon begins with.
fn kept_points(points: &[DVec3], stride: usize) -> Vec<u32> {
    let n = points.len();
    let direction = |k: usize| (points[(k + 1) % n] - points[k % n]).normalize_or_zero();
    let turn = |k: usize| {
        let (before, after) = (direction(k + n - 1), direction(k));
        measure::angle(before, after)
    };
    let mut corners: Vec<usize> = (0..n).filter(|&k| turn(k) > CORNER).collect();
    if corners.is_empty() {
        corners.push(first_point(points));
    }
    let mut kept = Vec::new();
    for (i, &start) in corners.iter().enumerate() {
        let end = corners.get(i + 1).copied().unwrap_or(corners[0] + n);
        let turning: f64 = (start + 1..end).map(|k| turn(k % n)).sum();
        // A loop without corners keeps at least three edges.
        let least = if corners.len() < 3 { 3 } else { 1 };
        let edges = (end - start).div_ceil(stride).max((turning / CORNER).ceil() as usize).max(least).min(end - start);
        kept.extend((0..edges).map(|j| ((start + j * (end - start) / edges) % n) as u32));
    }
    kept.sort_unstable();
    kept
}

/// The places of the film's boundary vertices on the input polygons.
#[derive(Debug)]
struct BoundaryPlaces<'a> {
    polygons: &'a [Vec<DVec3>],
    may_add: bool,
    /// Number of refinements so far.
    level: u32,
    /// Whether the last refinement added no input point, so that the boundary polygon stayed the same.
    same_polygon: bool,
    /// For each vertex of the film's boundary loops its place on the polygon: the index of an input point, or a number
    /// between two indices.
    places: Vec<Vec<f64>>,
}

impl<'a> BoundaryPlaces<'a> {
    /// Finds the places of the boundary vertices of a coarse film. A vertex that was added on an edge that skips input
    /// points is moved to one of these points. `None` if the edge skips fewer points than vertices were added on it, or
    /// if two of these vertices would get the same point.
    fn new(film: &mut Film, plan: &Plan, polygons: &'a [Vec<DVec3>], may_add: bool) -> Option<Self> {
        let mut places = Vec::with_capacity(polygons.len());
        let mut first = 0u32;
        for ((polygon, kept), boundary) in polygons.iter().zip(&plan.kept).zip(&film.boundaries) {
            let count = kept.len() as u32;
            let mut on_polygon = Vec::with_capacity(boundary.len());
            let is_kept = |v: u32| (first..first + count).contains(&v);
            if boundary.first().is_none_or(|&v| v != first) {
                return None;
            }
            let mut k = 0;
            // Ends because each pass raises k by one or more.
            while k < boundary.len() {
                let edge = (boundary[k] - first) as usize;
                let added = boundary[k + 1..].iter().take_while(|&&v| !is_kept(v)).count();
                let start = f64::from(kept[edge]);
                let end = kept.get(edge + 1).map_or(f64::from(kept[0]) + polygon.len() as f64, |&end| f64::from(end));
                let skipped = (end - start) as usize - 1;
                on_polygon.push(start);
                let (a, b) = (point_at(polygon, start), point_at(polygon, end));
                for j in 1..=added {
                    let vertex = boundary[k + j] as usize;
                    let along = b - a;
                    let part = ((film.vertices[vertex] - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                    let mut place = start + (end - start) * part;
                    if skipped > 0 {
                        place = place.round();
                        film.vertices[vertex] = point_at(polygon, place);
                    }
                    if place <= on_polygon[on_polygon.len() - 1] || place >= end {
                        return None;
                    }
                    on_polygon.push(place);
                }
                k += 1 + added;
            }
            places.push(on_polygon);
            first += count;
        }
        Some(Self { polygons, may_add, level: 0, same_polygon: false, places })
    }

    /// Halves every edge that can be halved. Also returns the ends of the edges that the new vertices halve.
    fn refine(&mut self, film: &Film) -> (Film, Vec<[u32; 2]>) {
        let old = film.vertices.len();
        // The boundary edges, each with the smaller vertex first, and the place at which each is halved.
        let mut edges: Vec<([u32; 2], Option<f64>)> = Vec::new();
        for ((boundary, places), polygon) in film.boundaries.iter().zip(&self.places).zip(self.polygons) {
            for k in 0..boundary.len() {
                let next = (k + 1) % boundary.len();
                let wrap = if next == 0 { polygon.len() as f64 } else { 0.0 };
                let ends = [boundary[k].min(boundary[next]), boundary[k].max(boundary[next])];
                edges.push((ends, self.middle(places[k], places[next] + wrap)));
            }
        }
        edges.sort_unstable_by_key(|(ends, _)| *ends);
        self.same_polygon = edges.iter().all(|(_, place)| place.is_none_or(|place| place.fract() != 0.0));
        let place_of = |a: u32, b: u32| {
            let found = edges.binary_search_by_key(&[a.min(b), a.max(b)], |(ends, _)| *ends);
            found.ok().and_then(|k| edges[k].1)
        };
        let (topology, midpoints) = if edges.iter().all(|(_, place)| place.is_some()) {
            film.topology.subdivided()
        } else {
            subdivided_inside(&film.topology, &film.vertices, |a, b| place_of(a, b).is_some())
        };
        let mut vertices = Vec::with_capacity(old + midpoints.len());
        vertices.extend_from_slice(&film.vertices);
        vertices.extend(midpoints.iter().map(|&[a, b]| 0.5 * (film.vertices[a as usize] + film.vertices[b as usize])));
        let mut fixed = film.fixed.clone();
        fixed.resize(vertices.len(), false);
        let mut middle_of: Vec<([u32; 2], u32)> = Vec::with_capacity(edges.len());
        for (k, &[a, b]) in midpoints.iter().enumerate() {
            if film.fixed[a as usize] && film.fixed[b as usize] && place_of(a, b).is_some() {
                fixed[old + k] = true;
                middle_of.push(([a.min(b), a.max(b)], (old + k) as u32));
            }
        }
        middle_of.sort_unstable();
        let mut boundaries = Vec::with_capacity(film.boundaries.len());
        for ((boundary, places), polygon) in film.boundaries.iter().zip(&mut self.places).zip(self.polygons) {
            let (mut vertices_along, mut places_along) = (Vec::new(), Vec::new());
            for k in 0..boundary.len() {
                let (a, b) = (boundary[k], boundary[(k + 1) % boundary.len()]);
                vertices_along.push(a);
                places_along.push(places[k]);
                if let (Ok(at), Some(place)) =
                    (middle_of.binary_search_by_key(&[a.min(b), a.max(b)], |(ends, _)| *ends), place_of(a, b))
                {
                    let vertex = middle_of[at].1;
                    vertices[vertex as usize] = point_at(polygon, place);
                    vertices_along.push(vertex);
                    places_along.push(place);
                }
            }
            *places = places_along;
            boundaries.push(vertices_along);
        }
        self.level += 1;
        (Film { vertices, topology, fixed, locked: Vec::new(), boundaries }, midpoints)
    }

    /// The place at which an edge between two places is halved: the middle one of the input points between them. If
    /// there is no input point between them, it is the middle of the edge, or `None` if no points may be added.
    fn middle(&self, start: f64, end: f64) -> Option<f64> {
        let (lowest, highest) = (start.floor() + 1.0, end.ceil() - 1.0);
        if lowest <= highest {
            Some((0.5 * (start + end)).round().clamp(lowest, highest))
        } else {
            self.may_add.then_some(0.5 * (start + end))
        }
    }

    /// The film with its vertices in the documented order: input points, points added on the boundaries, the interior.
    ///
    /// The loops are rotated so that each begins at point 0 of its polygon. Before, it begins at the first point that
    /// the coarse mesh keeps, which need not be point 0. `None` if point 0 is not a vertex, which cannot happen on the
    /// last level, because every input point is a vertex there.
    fn input_points_first(&mut self, mut film: Film) -> Option<Film> {
        for ((boundary, places), polygon) in film.boundaries.iter_mut().zip(&mut self.places).zip(self.polygons) {
            let count = polygon.len() as f64;
            let first = places.iter().position(|place| place % count == 0.0)?;
            boundary.rotate_left(first);
            places.rotate_left(first);
        }
        const UNPLACED: u32 = u32::MAX;
        let mut place = vec![UNPLACED; film.vertices.len()];
        let mut next = 0u32;
        for input_points in [true, false] {
            for (boundary, places) in film.boundaries.iter().zip(&self.places) {
                let chosen = boundary.iter().zip(places).filter(|(_, place)| (place.fract() == 0.0) == input_points);
                for (&vertex, _) in chosen {
                    place[vertex as usize] = next;
                    next += 1;
                }
            }
        }
        for place in place.iter_mut().filter(|place| **place == UNPLACED) {
            *place = next;
            next += 1;
        }
        Some(film.renumbered(&place))
    }
}

/// The point at a place on a closed polygon. At a whole number it is exactly an input point.
fn point_at(polygon: &[DVec3], place: f64) -> DVec3 {
    let n = polygon.len();
    let index = place.floor() as usize;
    let (a, b) = (polygon[index % n], polygon[(index + 1) % n]);
    match place.fract() {
        0.0 => a,
        fraction => a + fraction * (b - a),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_stay_and_no_edge_skips_more_than_the_stride() {
        let square = |k: usize| match k / 25 {
            0 => DVec3::new(k as f64, 0.0, 0.0),
            1 => DVec3::new(25.0, k as f64 - 25.0, 0.0),
            2 => DVec3::new(75.0 - k as f64, 25.0, 0.0),
            _ => DVec3::new(0.0, 100.0 - k as f64, 0.0),
        };
        let points: Vec<DVec3> = (0..100).map(square).collect();
        let kept = kept_points(&points, 8);
        assert!([0, 25, 50, 75].iter().all(|corner| kept.contains(corner)), "{kept:?}");
        assert!(kept.windows(2).all(|pair| pair[1] - pair[0] <= 8) && kept.len() == 16);
        // A circle of few points turns too much between neighbours to skip many of them.
        let circle: Vec<DVec3> =
            (0..24).map(|k| DVec3::new(libm::cos(k as f64 * 0.2618), libm::sin(k as f64 * 0.2618), 0.0)).collect();
        assert!(kept_points(&circle, 16).len() >= 10);
    }
}
