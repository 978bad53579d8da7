//! Newton's step for meshes too large to factorise: conjugate gradients over nested levels.

use super::newton::{Equations, Outcome, Settings, State, StepSolver};
use plateau_mesh::sparse::multigrid::{Hierarchy, Parents};
use plateau_mesh::sparse::{CgFailure, LinearError, SymmetricMatrix};
use plateau_mesh::{DVec3, Execution};

/// The linear system of a Newton step is solved until its residual falls to this fraction of the residual of the state.
const FORCING: f64 = 1e-3;
/// If the residual of the state is below this, the Newton step is expected to be the last. Its linear system is
/// therefore solved to the accuracy that the tolerance of the run needs.
const LAST_STEP_BELOW: f64 = 2e-2;
/// Residual to which the linear system of the last step is solved, as a fraction of the tolerance of the run.
const LAST_STEP_GOAL: f64 = 0.2;

/// Returns a test that tells whether a residual of the linear system is small enough for a Newton step from `state`.
pub fn accepts<F>(state: &State<F>, settings: &Settings, radius: f64) -> impl Fn(&[f64]) -> bool {
    let rest = LAST_STEP_GOAL * settings.tolerance;
    let goal = if state.residual > LAST_STEP_BELOW { rest.max(FORCING * state.residual) } else { rest };
    let allowed = 2.0 * goal / radius;
    move |residual| residual.iter().zip(&state.mass).all(|(residual, mass)| residual.abs() <= allowed * mass)
}

/// Computes Newton's step by conjugate gradients, preconditioned by V-cycles over nested meshes. The body must have no
/// constraints.
#[derive(Debug)]
pub struct VCycleSteps<'a> {
    pub hierarchy: &'a Hierarchy,
    pub parents: Parents,
    pub matrix: SymmetricMatrix,
}

impl<E: Equations> StepSolver<E> for VCycleSteps<'_> {
    fn step(
        &mut self,
        vertices: &[DVec3],
        equations: &E,
        state: &State<E::Frame>,
        settings: &Settings,
        exec: &Execution,
    ) -> Result<Vec<f64>, Outcome> {
        debug_assert!(state.constraints.is_empty(), "V-cycles know no border");
        equations.second_variation(vertices, state, 0.0, &mut self.matrix);
        let right_hand_side: Vec<f64> = state.gradient.iter().map(|gradient| -gradient).collect();
        let is_small = accepts(state, settings, equations.radius());
        self.hierarchy.solve(&self.matrix, &self.parents, &right_hand_side, is_small, exec).map_err(|failure| {
            match failure {
                CgFailure::Interrupted(interruption) => Outcome::Interrupted(interruption),
                CgFailure::Indefinite | CgFailure::Slow => Outcome::Refused(LinearError::Inaccurate),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::energy::area;
    use plateau_mesh::Execution;
    use plateau_mesh::Signal;
    use plateau_mesh::film::Film;
    use plateau_mesh::measure;
    use plateau_mesh::remesh::subdivision::subdivide;
    use plateau_mesh::sparse::multigrid::{Hierarchy, parents_of};
    use plateau_mesh::sparse::pattern::Pattern;
    use plateau_mesh::sparse::{CgFailure, Symbolic, SymmetricMatrix};
    use plateau_mesh::structured::{catenoid, patch};
    use std::cell::Cell;

    fn second_variation(film: &Film, pattern: &Pattern) -> SymmetricMatrix {
        let normals = measure::normals(&film.vertices, film.triangles());
        let mut matrix = pattern.matrix();
        area::second_variation(pattern, &film.vertices, film.triangles(), &normals, 0.0, &mut matrix);
        matrix
    }

    #[test]
    fn the_number_of_iterations_does_not_grow_with_the_levels_and_the_solution_is_the_factors() {
        let mut film = patch(12, 12, catenoid(3.0, 1.0));
        let mut pattern = Pattern::new(film.triangles(), &film.fixed);
        let matrix = second_variation(&film, &pattern);
        let symbolic = Symbolic::analyse(&matrix, None).unwrap();
        let factor = symbolic.factorise(&matrix).unwrap().into_storage();
        let mut hierarchy = Hierarchy::new(symbolic, factor);
        let mut counts = Vec::new();
        for _ in 0..4 {
            let (fine, midpoints) = subdivide(&film);
            let finer = Pattern::new(fine.triangles(), &fine.fixed);
            let parents = parents_of(&pattern.free.unknown, &finer.free.vertex, &midpoints);
            (film, pattern) = (fine, finer);
            let matrix = second_variation(&film, &pattern);
            let right: Vec<f64> = (0..matrix.order()).map(|row| libm::sin(row as f64)).collect();
            let looks = Cell::new(0);
            let signal = || {
                looks.set(looks.get() + 1);
                Signal::Continue
            };
            let exec = Execution::new(&signal, &|_| {});
            let small = |residual: &[f64]| residual.iter().all(|r| r.abs() < 1e-9);
            let x = hierarchy.solve(&matrix, &parents, &right, small, &exec).unwrap();
            counts.push(looks.get());
            let mut exact = right.clone();
            let symbolic = Symbolic::analyse(&matrix, None).unwrap();
            symbolic.factorise(&matrix).unwrap().solve(&mut exact).unwrap();
            let largest = exact.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
            assert!(x.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-7 * largest));
            hierarchy.push(matrix, parents);
        }
        assert!(counts.iter().all(|&count| count <= 20), "{counts:?}");
    }

    #[test]
    fn an_indefinite_matrix_is_noticed() {
        let film = patch(8, 8, catenoid(6.0, 1.0));
        let pattern = Pattern::new(film.triangles(), &film.fixed);
        let matrix = second_variation(&film, &pattern);
        let symbolic = Symbolic::analyse(&matrix, None).unwrap();
        let factor = symbolic.factorise(&matrix).unwrap().into_storage();
        let hierarchy = Hierarchy::new(symbolic, factor);
        let (fine, midpoints) = subdivide(&film);
        let finer = Pattern::new(fine.triangles(), &fine.fixed);
        let parents = parents_of(&pattern.free.unknown, &finer.free.vertex, &midpoints);
        let mut matrix = second_variation(&fine, &finer);
        for row in 0..matrix.order() {
            let diagonal = matrix.row_start[row] as usize;
            matrix.values[diagonal] -= 3.0;
        }
        let right = vec![1.0; matrix.order()];
        let solved =
            hierarchy.solve(&matrix, &parents, &right, |r| r.iter().all(|r| r.abs() < 1e-9), &Execution::default());
        assert!(matches!(solved, Err(CgFailure::Indefinite | CgFailure::Slow)));
    }
}
