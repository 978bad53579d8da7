//! Newton's method on the mesh area with one unknown per free vertex: its height along the present vertex normal.
//!
//! 1. Vertex normals (area-weighted), the area gradient along them, the residual. Stop at the tolerance.
//! 2. The second variation of area in normal directions ([`area`](crate::energy::area)): one sparse symmetric matrix the size
//!    of the cotangent Laplacian, factorised as L D Lᵀ. Its inertia is the mesh's Morse index at that moment.
//! 3. If it is indefinite, add the Laplacian part once more, and more, until it is positive definite: the step then
//!    goes down in area. (When a stationary surface is followed whatever its index, take the step as it is.)
//! 4. Line search: halve the step while a triangle would turn over, or the area (following: the residual) does not fall.
//!
//! Why normal heights only: sliding vertices in the surface hardly changes the area, so the full 3n x 3n matrix is nearly
//! singular and a descent in all coordinates buys its last digits with triangles of 1e-10 degrees. Heights leave the mesh's
//! quality alone. The price is a tangential part of the gradient that does not vanish (reported as `residual_full`).
//! Since the normals turn with the surface the iteration is Newton's only in the limit of a fine mesh; the rate observed is
//! three to four digits a step.

use crate::energy::area::{FIXED, FirstVariation, Pattern, vertex_normals};
use crate::mesh::film::Film;
use crate::mesh::measure;
use crate::sparse::{LinearError, Symbolic, SymmetricMatrix};
use crate::{DVec3, Execution, Interruption};

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
pub(crate) enum Aim {
    /// Down in area, to a surface of Morse index 0 or to none.
    Minimum,
    /// To the nearest stationary surface, whatever its index.
    Stationary,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    pub aim: Aim,
    pub tolerance: f64,
    pub max_steps: u32,
    /// R of the residual.
    pub radius: f64,
}

/// How a run of Newton steps ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
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
pub(crate) struct State {
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

/// What solves for Newton's step: a factorisation, or multigrid.
pub(crate) trait StepSolver {
    /// Steps 2 and 3: the heights by which Newton moves the free vertices. `state` is where the film stands.
    ///
    /// # Errors
    /// The outcome with which the iteration has to end.
    fn heights(
        &mut self,
        film: &Film,
        pattern: &Pattern,
        state: &State,
        settings: &Settings,
    ) -> Result<Vec<f64>, Outcome>;
}

/// Takes Newton steps until the residual is small or nothing gains any more; `record` is told every step (area, residual).
///
/// The film keeps the best position reached, and no step folds its mesh. Also returns where it stands.
pub(crate) fn iterate(
    film: &mut Film,
    pattern: &Pattern,
    solver: &mut dyn StepSolver,
    settings: &Settings,
    exec: &Execution,
    record: &mut dyn FnMut(f64, f64),
) -> (Outcome, State) {
    let work = film.triangles().len() as u64;
    let mut state = State::of(pattern, &film.vertices, film.triangles(), settings.radius);
    for _ in 0..settings.max_steps {
        if state.residual <= settings.tolerance {
            return (Outcome::Converged, state);
        }
        if let Err(interruption) = exec.look(work) {
            return (Outcome::Interrupted(interruption), state);
        }
        let step = match solver.heights(film, pattern, &state, settings) {
            Ok(step) => step,
            Err(outcome) => return (outcome, state),
        };
        match search(pattern, film, &state, &step, settings) {
            Some((vertices, reached)) => {
                film.vertices = vertices;
                state = reached;
                record(state.first.area, state.residual);
            }
            None => return (Outcome::Stalled, state),
        }
    }
    (if state.residual <= settings.tolerance { Outcome::Converged } else { Outcome::StepsUsed }, state)
}

/// Newton's step by factorisation: the symbolic part is made once for a connectivity.
#[derive(Debug)]
pub(crate) struct Direct {
    pub symbolic: Symbolic,
    pub matrix: SymmetricMatrix,
    /// The last factor made, for the next one to be made in, or to be kept.
    pub storage: Vec<f64>,
}

impl Direct {
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub fn new(pattern: &Pattern) -> Result<Self, LinearError> {
        let matrix = pattern.matrix();
        let symbolic = Symbolic::analyse(&matrix, None)?;
        Ok(Self { symbolic, matrix, storage: Vec::new() })
    }
}

impl StepSolver for Direct {
    fn heights(
        &mut self,
        film: &Film,
        pattern: &Pattern,
        state: &State,
        settings: &Settings,
    ) -> Result<Vec<f64>, Outcome> {
        let mut shift = 0.0;
        loop {
            let (vertices, triangles) = (&film.vertices, film.triangles());
            pattern.second_variation(vertices, triangles, &state.normals, shift, &mut self.matrix);
            let factorisation = self.symbolic.factorise_into(&self.matrix, std::mem::take(&mut self.storage));
            let usable = match &factorisation {
                Ok(factorisation) => settings.aim == Aim::Stationary || factorisation.inertia().is_positive_definite(),
                Err(LinearError::Singular) => false,
                Err(error) => return Err(Outcome::Refused(*error)),
            };
            if let Ok(factorisation) = factorisation {
                let mut heights: Vec<f64> = state.first.gradient.iter().map(|pull| -pull).collect();
                let solved = if usable { factorisation.solve(&mut heights) } else { Ok(()) };
                self.storage = factorisation.into_storage();
                if usable {
                    return solved.map(|()| heights).map_err(Outcome::Refused);
                }
            }
            shift = if shift == 0.0 { FIRST_SHIFT } else { SHIFT_GROWTH * shift };
            if shift > LAST_SHIFT {
                return Err(Outcome::Refused(LinearError::Singular));
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
    settings: &Settings,
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
pub(crate) fn moved(pattern: &Pattern, film: &Film, normals: &[DVec3], step: &[f64], fraction: f64) -> Vec<DVec3> {
    let move_one = |((&vertex, &normal), &row): ((&DVec3, &DVec3), &u32)| match row {
        FIXED => vertex,
        row => vertex + fraction * step[row as usize] * normal,
    };
    film.vertices.iter().zip(normals).zip(&pattern.unknown).map(move_one).collect()
}

/// Whether no triangle turns over (by more than a right angle) or vanishes on the way to `vertices`.
pub(crate) fn keeps_orientation(film: &Film, vertices: &[DVec3]) -> bool {
    film.triangles().iter().all(|&triangle| {
        let before = measure::double_area_vector(film.corners(triangle));
        let after = measure::double_area_vector(triangle.map(|v| vertices[v as usize]));
        after.dot(before) > 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::structured::{cylinder, helicoid, patch, relax};
    use crate::minimal_surface::harmonic::Dirichlet;

    fn residuals(film: &mut Film) -> (Outcome, Vec<f64>) {
        let mut dirichlet = Dirichlet::new(film).unwrap();
        for _ in 0..2 {
            dirichlet.step(film).unwrap();
        }
        let settings = Settings { aim: Aim::Minimum, tolerance: 1e-9, max_steps: 20, radius: film.radius() };
        let mut residuals = Vec::new();
        let pattern = Pattern::new(film.triangles(), &film.fixed);
        let mut direct = Direct::new(&pattern).unwrap();
        let record = &mut |_, residual| residuals.push(residual);
        let (outcome, _) = iterate(film, &pattern, &mut direct, &settings, &Execution::default(), record);
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
    fn the_critical_gap_of_two_rings() {
        // gap / diameter = 0.66274: the catenoid whose waist is 0.55243 of the rings' radius is the last.
        let holds = |n: usize, gap: f64| {
            let mut film = cylinder(n, n / 6, gap);
            for vertex in &mut film.vertices {
                let profile = |z: f64| 0.55243 * (z / 0.55243).cosh();
                let narrowed = 1.0 + profile(vertex.z) - profile(0.5 * gap);
                if vertex.z.abs() < 0.5 * gap {
                    (vertex.x, vertex.y) = (narrowed * vertex.x, narrowed * vertex.y);
                }
            }
            let settings = Settings { aim: Aim::Minimum, tolerance: 1e-8, max_steps: 40, radius: film.radius() };
            let pattern = Pattern::new(film.triangles(), &film.fixed);
            let mut direct = Direct::new(&pattern).unwrap();
            let exec = Execution::default();
            iterate(&mut film, &pattern, &mut direct, &settings, &exec, &mut |_, _| {}).0 == Outcome::Converged
        };
        let critical = |n: usize| {
            let (mut held, mut broken) = (1.28, 1.38);
            while broken - held > 2e-4 {
                let gap = 0.5 * (held + broken);
                if holds(n, gap) { held = gap } else { broken = gap }
            }
            0.25 * (held + broken)
        };
        let (coarse, fine) = (critical(60), critical(120));
        let extrapolated = fine + (fine - coarse) / 3.0;
        assert!((extrapolated - 0.66274).abs() < 5e-4, "{coarse} {fine} {extrapolated}");
    }
}
