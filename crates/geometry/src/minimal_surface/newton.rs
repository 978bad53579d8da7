//! Newton's method on the mesh area with one unknown per free vertex: its height along the present vertex normal.
//!
//! 1. Vertex normals (area-weighted), the area gradient along them, the residual. Stop at the tolerance.
//! 2. The second variation of area in normal directions ([`cotangent`](super::cotangent)): one sparse symmetric matrix the size
//!    of the cotangent Laplacian, factorised as L D Lᵀ. Its inertia is the mesh's Morse index at that moment.
//! 3. If it is indefinite, add the Laplacian part once more, and more, until it is positive definite: the step then
//!    goes down in area. (When a stationary surface is followed whatever its index, take the step as it is.)
//! 4. Line search: halve the step while a triangle would turn over, or the area (following: the residual) does not fall.
//!
//! Before that, rounds of Pinkall-Polthier solves ([`pinkall_polthier`](super::pinkall_polthier)), which forgive any
//! start; after it, the second variation once more for the [`stability`](super::stability).
//!
//! Why normal heights only: sliding vertices in the surface hardly changes the area, so the full 3n x 3n matrix is nearly
//! singular and a descent in all coordinates buys its last digits with triangles of 1e-10 degrees. Heights leave the mesh's
//! quality alone. The price is a tangential part of the gradient that does not vanish (reported as `residual_full`).
//! Since the normals turn with the surface the iteration is Newton's only in the limit of a fine mesh; the rate observed is
//! three to four digits a step.

use super::cotangent::{FIXED, FirstVariation, Pattern, vertex_normals};
use super::film::{Film, Run};
use super::pinkall_polthier::{Dirichlet, too_large};
use super::record::{Record, geometric_part};
use super::remesh::{flip_to_delaunay, tangential_relaxation};
use super::statistics::{Stability, StopReason};
use super::{OnUnstable, Options, Solver, stability};
use crate::linear::{LinearError, Symbolic, SymmetricMatrix};
use crate::mesh::measure;
use crate::{DVec3, Error, Execution, Interruption};

/// A step shorter than this fraction of Newton's own ends the run.
const LEAST_STEP: f64 = 1.0 / 4096.0;
/// First multiple of the Laplacian part that is added to an indefinite matrix, the factor to the next, and the last.
const FIRST_SHIFT: f64 = 0.125;
const SHIFT_GROWTH: f64 = 4.0;
const LAST_SHIFT: f64 = 1e4;
/// The step must gain this fraction of what its slope promises (Armijo).
const LEAST_GAIN: f64 = 1e-4;
/// Changes of area below this fraction of it are rounding, and the residual decides instead.
const AREA_ROUNDING: f64 = 1e-12;

/// Where the iteration is to go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Aim {
    /// Down in area, to a surface of Morse index 0 or to none.
    Minimum,
    /// To the nearest stationary surface, whatever its index.
    Stationary,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Settings {
    pub aim: Aim,
    pub tolerance: f64,
    pub max_steps: u32,
    /// R of the residual.
    pub radius: f64,
}

/// How a run of Newton steps ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// The residual is at most the tolerance.
    Converged,
    /// No step gains any more: a fold or a collapse is in the way, or rounding is reached.
    Stalled,
    /// The allowed steps are used up.
    StepsUsed,
    /// The linear solver refused the mesh.
    Refused(LinearError),
    Interrupted(Interruption),
}

/// The first variation at one position of the mesh.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub normals: Vec<DVec3>,
    pub first: FirstVariation,
    pub residual: f64,
}

impl State {
    pub fn of(pattern: &Pattern, vertices: &[DVec3], triangles: &[[u32; 3]], radius: f64) -> Self {
        let normals = vertex_normals(vertices, triangles);
        let first = pattern.first_variation(vertices, triangles, &normals);
        let residual = first.residual(radius);
        Self { normals, first, residual }
    }
}

/// The heights of one connectivity: its pattern, its symbolic factorisation, and room for its matrix and factor.
#[derive(Debug)]
pub(super) struct Heights {
    pub pattern: Pattern,
    pub symbolic: Symbolic,
    pub matrix: SymmetricMatrix,
    storage: Vec<f64>,
}

impl Heights {
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub fn new(film: &Film) -> Result<Self, LinearError> {
        let pattern = Pattern::new(film.triangles(), &film.fixed);
        let matrix = pattern.matrix();
        let symbolic = Symbolic::analyse(&matrix, None)?;
        Ok(Self { pattern, symbolic, matrix, storage: Vec::new() })
    }

    /// Takes Newton steps until the residual is small or nothing gains any more; `record` is told every step (area, residual).
    /// The film keeps the best position reached, and its mesh was never folded by a step.
    pub fn iterate(
        &mut self,
        film: &mut Film,
        settings: Settings,
        exec: &Execution,
        record: &mut dyn FnMut(f64, f64),
    ) -> Outcome {
        let work = film.triangles().len() as u64;
        let mut state = State::of(&self.pattern, &film.vertices, film.triangles(), settings.radius);
        for _ in 0..settings.max_steps {
            if state.residual <= settings.tolerance {
                return Outcome::Converged;
            }
            if let Err(interruption) = exec.look(work) {
                return Outcome::Interrupted(interruption);
            }
            let step = match self.step(film, &state, settings.aim) {
                Ok(step) => step,
                Err(error) => return Outcome::Refused(error),
            };
            match search(&self.pattern, film, &state, &step, settings) {
                Some((vertices, reached)) => {
                    film.vertices = vertices;
                    state = reached;
                    record(state.first.area, state.residual);
                }
                None => return Outcome::Stalled,
            }
        }
        if state.residual <= settings.tolerance { Outcome::Converged } else { Outcome::StepsUsed }
    }

    /// Steps 2 and 3: the heights by which Newton moves the free vertices.
    fn step(&mut self, film: &Film, state: &State, aim: Aim) -> Result<Vec<f64>, LinearError> {
        let mut shift = 0.0;
        loop {
            let (vertices, triangles) = (&film.vertices, film.triangles());
            self.pattern.second_variation(vertices, triangles, &state.normals, shift, &mut self.matrix);
            let factorisation = self.symbolic.factorise_into(&self.matrix, std::mem::take(&mut self.storage));
            let usable = match &factorisation {
                Ok(factorisation) => aim == Aim::Stationary || factorisation.inertia().is_positive_definite(),
                Err(LinearError::Singular) => false,
                Err(error) => return Err(*error),
            };
            if let Ok(factorisation) = factorisation {
                let mut heights: Vec<f64> = state.first.gradient.iter().map(|pull| -pull).collect();
                let solved = if usable { factorisation.solve(&mut heights) } else { Ok(()) };
                self.storage = factorisation.into_storage();
                if usable {
                    return solved.map(|()| heights);
                }
            }
            shift = if shift == 0.0 { FIRST_SHIFT } else { SHIFT_GROWTH * shift };
            if shift > LAST_SHIFT {
                return Err(LinearError::Singular);
            }
        }
    }
}

/// Step 4: the longest of the step, its half, its quarter, … that folds nothing and gains; `None` if none does.
fn search(
    pattern: &Pattern,
    film: &Film,
    state: &State,
    step: &[f64],
    settings: Settings,
) -> Option<(Vec<DVec3>, State)> {
    let slope: f64 = state.first.gradient.iter().zip(step).map(|(pull, height)| pull * height).sum();
    let mut fraction = 1.0;
    while fraction >= LEAST_STEP {
        let vertices = moved(pattern, film, &state.normals, step, fraction);
        if keeps_orientation(film, &vertices) {
            let reached = State::of(pattern, &vertices, film.triangles(), settings.radius);
            let (before, after) = (state.first.area, reached.first.area);
            let decided_by_residual =
                (fraction * slope).abs() <= AREA_ROUNDING * before || settings.aim == Aim::Stationary;
            let gains = if decided_by_residual {
                reached.residual < state.residual
            } else {
                after <= before + LEAST_GAIN * fraction * slope
            };
            if gains {
                return Some((vertices, reached));
            }
        }
        fraction *= 0.5;
    }
    None
}

/// All vertices, the free ones moved by a fraction of `step` along their normals.
fn moved(pattern: &Pattern, film: &Film, normals: &[DVec3], step: &[f64], fraction: f64) -> Vec<DVec3> {
    let move_one = |((&vertex, &normal), &row): ((&DVec3, &DVec3), &u32)| match row {
        FIXED => vertex,
        row => vertex + fraction * step[row as usize] * normal,
    };
    film.vertices.iter().zip(normals).zip(&pattern.unknown).map(move_one).collect()
}

/// Whether no triangle turns over (by more than a right angle) or vanishes on the way to `vertices`.
fn keeps_orientation(film: &Film, vertices: &[DVec3]) -> bool {
    film.triangles().iter().all(|&triangle| {
        let before = measure::double_area_vector(film.corners(triangle));
        let after = measure::double_area_vector(triangle.map(|v| vertices[v as usize]));
        after.dot(before) > 0.0
    })
}

/// Linear solves that a run may take if the caller does not say.
const DEFAULT_SOLVES: u32 = 200;
/// Rounds of Pinkall-Polthier solves before Newton takes over, and solves in each.
const MAX_ROUNDS: u32 = 6;
const SOLVES_PER_ROUND: u32 = 4;
/// Tangential relaxations after each round's solves.
const RELAXATIONS_PER_ROUND: u32 = 4;
/// A round that changes the area by less than this fraction is the last.
const SETTLED: f64 = 1e-3;
/// How often a stalled Newton iteration goes back to more rounds.
const MAX_RETURNS: u32 = 3;

/// Rounds of Pinkall-Polthier, then Newton's method, then the stability of what came out.
///
/// Ends with the best mesh reached, folded never: the stop reason says why where it is not converged.
///
/// # Errors
/// [`Error::Interrupted`] on cancel; [`Error::NoResult`] if the mesh is too large to factorise.
pub(super) fn run(film: &mut Film, options: &Options, exec: &Execution) -> Result<Run, Error> {
    let mut solve = Solve {
        exec,
        record: Record::new(exec),
        limit: options.max_iterations.unwrap_or(DEFAULT_SOLVES),
        tolerance: options.tolerance,
        radius: film.radius(),
        edges_swapped: 0,
    };
    let (stop_reason, stability) = match solve.film(film, options.on_unstable) {
        Ok(done) => done,
        Err(Stop::Interrupted(Interruption::DeadlinePassed)) => (StopReason::Deadline, None),
        Err(Stop::Interrupted(Interruption::Cancelled)) => return Err(Interruption::Cancelled.into()),
        Err(Stop::TooLarge) => return Err(too_large(LinearError::TooLarge)),
    };
    let Solve { record: Record { history, iterations, .. }, edges_swapped, .. } = solve;
    Ok(Run { stop_reason, iterations, history, edges_swapped, stability, ..Run::new(Solver::Newton) })
}

/// Why a solve was left half way.
enum Stop {
    Interrupted(Interruption),
    TooLarge,
}

impl From<Interruption> for Stop {
    fn from(interruption: Interruption) -> Self {
        Self::Interrupted(interruption)
    }
}

/// What stays the same during one run.
struct Solve<'a> {
    exec: &'a Execution<'a>,
    record: Record<'a>,
    limit: u32,
    tolerance: f64,
    radius: f64,
    edges_swapped: u64,
}

impl Solve<'_> {
    fn film(&mut self, film: &mut Film, on_unstable: OnUnstable) -> Result<(StopReason, Option<Stability>), Stop> {
        if film.fixed.iter().all(|&fixed| fixed) {
            return Ok((StopReason::NothingToMove, None));
        }
        let mut reason = StopReason::Stalled;
        for _ in 0..=MAX_RETURNS {
            let collapsed = self.settle(film)?;
            let mut heights = Heights::new(film).map_err(|_| Stop::TooLarge)?;
            let outcome = self.newton(film, &mut heights, Aim::Minimum)?;
            reason = match outcome {
                StopReason::Residual => {
                    let stability = self.stability(film, &mut heights, on_unstable)?;
                    return Ok((outcome, stability));
                }
                StopReason::MaxIterations => return Ok((outcome, None)),
                _ if collapsed => StopReason::Collapsed,
                other => other,
            };
        }
        Ok((reason, None))
    }

    fn newton(&mut self, film: &mut Film, heights: &mut Heights, aim: Aim) -> Result<StopReason, Stop> {
        let start = State::of(&heights.pattern, &film.vertices, film.triangles(), self.radius).residual;
        let max_steps = self.limit.saturating_sub(self.record.iterations);
        let settings = Settings { aim, tolerance: self.tolerance, max_steps, radius: self.radius };
        let outcome = heights.iterate(film, settings, self.exec, &mut |area, residual| {
            let part = geometric_part(start, residual, settings.tolerance);
            self.record.iteration("newton", area, residual, 0.5 + 0.4 * part);
        });
        Ok(match outcome {
            Outcome::Converged => StopReason::Residual,
            Outcome::StepsUsed => StopReason::MaxIterations,
            Outcome::Stalled => StopReason::Stalled,
            Outcome::Refused(_) => StopReason::Collapsed,
            Outcome::Interrupted(interruption) => return Err(interruption.into()),
        })
    }

    /// Rounds of Pinkall-Polthier, tangential relaxation and Delaunay flips until the area settles; true if a linear system was refused on the way.
    fn settle(&mut self, film: &mut Film) -> Result<bool, Stop> {
        let mut area = film.area();
        for round in 0..MAX_ROUNDS {
            let mut dirichlet = Dirichlet::new(film).map_err(|_| Stop::TooLarge)?;
            let before_round = area;
            for _ in 0..SOLVES_PER_ROUND {
                if self.record.iterations >= self.limit {
                    return Ok(false);
                }
                self.exec.look(film.triangles().len() as u64)?;
                if dirichlet.step(film).is_err() {
                    return Ok(true);
                }
                let before = std::mem::replace(&mut area, film.area());
                let residual = State::of(&dirichlet.pattern, &film.vertices, film.triangles(), self.radius).residual;
                let fraction = 0.5 * f64::from(round + 1) / f64::from(MAX_ROUNDS);
                self.record.iteration("pinkall_polthier", area, residual, fraction);
                if (before - area).abs() <= SETTLED * area {
                    break;
                }
            }
            let settled = (before_round - area).abs() <= SETTLED * area;
            tangential_relaxation(film, RELAXATIONS_PER_ROUND);
            let swapped = flip_to_delaunay(film);
            self.edges_swapped += swapped;
            self.exec.look(film.triangles().len() as u64)?;
            if settled && swapped == 0 {
                break;
            }
            area = film.area();
        }
        Ok(false)
    }

    /// The stability of the film where it stands; an unstable one is left first if that is asked for.
    fn stability(
        &mut self,
        film: &mut Film,
        heights: &mut Heights,
        on_unstable: OnUnstable,
    ) -> Result<Option<Stability>, Stop> {
        let mut found = None;
        for _ in 0..=MAX_RETURNS {
            self.exec.look(film.triangles().len() as u64)?;
            let state = State::of(&heights.pattern, &film.vertices, film.triangles(), self.radius);
            let Heights { pattern, symbolic, matrix, .. } = &mut *heights;
            let Ok(Some(variation)) = stability::analyse(film, pattern, symbolic, matrix, &state, self.radius) else {
                break;
            };
            found = Some(Stability {
                stable: variation.morse_index == 0,
                morse_index: variation.morse_index,
                lowest_eigenvalue: variation.lowest.eigenvalue,
            });
            if variation.morse_index == 0 || on_unstable == OnUnstable::Report {
                break;
            }
            leave(film, &heights.pattern, &state, &variation.lowest.heights);
            if self.newton(film, heights, Aim::Minimum)? != StopReason::Residual {
                break;
            }
        }
        Ok(found)
    }
}

/// Moves an unstable film along its lowest mode, to the side and as far (of a few lengths) as lowers the area most.
fn leave(film: &mut Film, pattern: &Pattern, state: &State, mode: &[f64]) {
    let largest = mode.iter().fold(0.0, |max: f64, height| max.max(height.abs()));
    let mean_length = (state.first.area / film.triangles().len() as f64).sqrt();
    let lengths = [0.25, 0.5, 1.0, 2.0].into_iter().flat_map(|length| [length, -length]);
    let candidates = lengths.map(|length| moved(pattern, film, &state.normals, mode, length * mean_length / largest));
    let best = candidates.filter(|vertices| keeps_orientation(film, vertices)).min_by(|a, b| {
        let area = |vertices: &[DVec3]| pattern.first_variation(vertices, film.triangles(), &state.normals).area;
        area(a).total_cmp(&area(b))
    });
    if let Some(vertices) = best {
        film.vertices = vertices;
    }
}

#[cfg(test)]
mod tests {
    use super::super::structured::{cylinder, helicoid, patch, relax};
    use super::*;

    fn residuals(film: &mut Film) -> (Outcome, Vec<f64>) {
        let mut dirichlet = Dirichlet::new(film).unwrap();
        for _ in 0..2 {
            dirichlet.step(film).unwrap();
        }
        let settings = Settings { aim: Aim::Minimum, tolerance: 1e-9, max_steps: 20, radius: film.radius() };
        let mut residuals = Vec::new();
        let mut heights = Heights::new(film).unwrap();
        let record = &mut |_, residual| residuals.push(residual);
        let outcome = heights.iterate(film, settings, &Execution::default(), record);
        (outcome, residuals)
    }

    #[test]
    fn the_number_of_steps_does_not_grow_with_the_mesh() {
        for (n, sweeps) in [(10, 20), (40, 200)] {
            let mut film = patch(n, 6 * n, helicoid);
            relax(&mut film, sweeps);
            let (outcome, residuals) = residuals(&mut film);
            assert_eq!(outcome, Outcome::Converged);
            assert!(residuals.len() <= 5, "{residuals:?}");
        }
    }

    #[test]
    fn rings_close_to_the_critical_gap_take_a_few_steps_more() {
        for (gap, most) in [(1.0, 4), (1.32, 9)] {
            for n in [40, 160] {
                let (outcome, residuals) = residuals(&mut cylinder(n, n / 5, gap));
                assert_eq!(outcome, Outcome::Converged);
                assert!(residuals.len() <= most, "{residuals:?}");
            }
        }
    }

    #[test]
    fn beyond_the_critical_gap_nothing_is_called_converged() {
        let mut film = cylinder(48, 16, 1.5);
        let run = run(&mut film, &Options::new(super::super::Resolution::Triangles(1)), &Execution::default()).unwrap();
        assert_ne!(run.stop_reason, StopReason::Residual);
        assert!(film.vertices.iter().all(|vertex| vertex.is_finite()));
    }
}
