//! Pinkall, Polthier, *Computing Discrete Minimal Surfaces and Their Conjugates* (1993), section 3:
//!
//! 1. Take the current mesh as the domain. Its cotangent weights give the Dirichlet energy of a piecewise linear map.
//! 2. Minimise that energy with the boundary fixed: one sparse positive definite system, three right-hand sides.
//! 3. The image is the next domain. Repeat.
//!
//! The area never rises, since area(image) <= energy(image) <= energy(identity) = area(domain). The iteration converges linearly:
//! a few rounds take a poor mesh to a good one, many are needed for a small residual ([`newton`](super::newton) for that).
//!
//! Departures: the weight of a triangle whose area vanishes is bounded ([`cotangent`](super::cotangent)), so that a collapsing
//! neck is reported by the linear solver and not by an infinite entry.

use super::Solver;
use super::cotangent::Pattern;
use super::cotangent::dirichlet_energy;
use super::film::{Film, Run};
use super::record::Record;
use super::remesh::flip_to_delaunay;
use super::statistics::{Curvature, StopReason};
use crate::linear::{LinearError, Symbolic, SymmetricMatrix, conjugate_gradients};
use crate::{DVec3, Error, Execution, Interruption};

/// Residual at which conjugate gradients stop, relative to that of the present positions.
const ITERATIVE_TOLERANCE: f64 = 1e-10;

/// Whether a step needed a factorisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Elimination {
    Used,
    Spared,
}

/// One connectivity's Dirichlet problems: the symbolic factorisation is made once.
#[derive(Debug)]
pub(super) struct Dirichlet {
    pub pattern: Pattern,
    symbolic: Symbolic,
    matrix: SymmetricMatrix,
    right_hand_side: Vec<f64>,
    storage: Vec<f64>,
}

impl Dirichlet {
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub fn new(film: &Film) -> Result<Self, LinearError> {
        let pattern = Pattern::new(film.triangles(), &film.fixed);
        let matrix = pattern.matrix();
        let symbolic = Symbolic::analyse(&matrix, None)?;
        Ok(Self { pattern, symbolic, matrix, right_hand_side: Vec::new(), storage: Vec::new() })
    }

    /// Steps 1 and 2: moves the free vertices to the image of the energy's minimum. The film must have the connectivity
    /// that this was made for. Leaves the film as it was on an error.
    ///
    /// # Errors
    /// A [`LinearError`] if the mesh has collapsed so far that the system has no trustworthy solution.
    pub fn step(&mut self, film: &mut Film) -> Result<(), LinearError> {
        self.pattern.laplacian(&film.vertices, film.triangles(), &mut self.matrix, &mut self.right_hand_side);
        let factorisation = self.symbolic.factorise_into(&self.matrix, std::mem::take(&mut self.storage))?;
        if !factorisation.inertia().is_positive_definite() {
            return Err(LinearError::Singular);
        }
        factorisation.solve(&mut self.right_hand_side)?;
        self.storage = factorisation.into_storage();
        let n = self.pattern.vertex.len();
        for (row, &vertex) in self.pattern.vertex.iter().enumerate() {
            let x = &self.right_hand_side;
            film.vertices[vertex as usize] = DVec3::new(x[row], x[n + row], x[2 * n + row]);
        }
        Ok(())
    }

    /// As [`step`](Self::step), by conjugate gradients from the present positions; by elimination where one of the three
    /// coordinates does not converge. Says which it was.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_by_conjugate_gradients(&mut self, film: &mut Film) -> Result<Elimination, LinearError> {
        self.pattern.laplacian(&film.vertices, film.triangles(), &mut self.matrix, &mut self.right_hand_side);
        let n = self.pattern.vertex.len();
        let mut image = vec![DVec3::ZERO; n];
        for (axis, b) in self.right_hand_side.chunks_exact(n).enumerate() {
            let mut x: Vec<f64> = self.pattern.vertex.iter().map(|&v| film.vertices[v as usize][axis]).collect();
            if conjugate_gradients(&self.matrix, b, &mut x, ITERATIVE_TOLERANCE).is_none() {
                return self.step(film).map(|()| Elimination::Used);
            }
            image.iter_mut().zip(x).for_each(|(point, x)| point[axis] = x);
        }
        for (&vertex, point) in self.pattern.vertex.iter().zip(image) {
            film.vertices[vertex as usize] = point;
        }
        Ok(Elimination::Spared)
    }
}

/// One solve of steps 1 and 2 for [`Objective::MinimalDirichletEnergy`](super::Objective): the harmonic map from the
/// initial mesh, made Delaunay so that its weights are positive. The energy, ¼ Σ (cot α + cot β) |a'|² over the edges, is the objective value.
///
/// # Errors
/// [`Error::Interrupted`] on cancel; [`Error::NoResult`] if the mesh is too large or too degenerate to factorise.
pub(super) fn run_once(film: &mut Film, exec: &Execution) -> Result<Run, Error> {
    let mut record = Record::new(exec);
    let edges_swapped = flip_to_delaunay(film);
    let run = Run { edges_swapped, ..Run::new(Solver::PinkallPolthier) };
    let mut dirichlet = Dirichlet::new(film).map_err(too_large)?;
    let domain = film.vertices.clone();
    let moves = !dirichlet.pattern.vertex.is_empty();
    match exec.look(film.triangles().len() as u64) {
        Ok(()) if moves => {
            dirichlet.step(film).map_err(|_| {
                let detail = "the initial mesh is degenerate, so that its harmonic map cannot be computed";
                Error::no_result("degenerate_boundary", detail)
            })?;
            record.iteration("pinkall_polthier", film.area(), Curvature::of(film).residual, 1.0);
        }
        Ok(()) => {}
        Err(Interruption::DeadlinePassed) => {
            return Ok(Run { stop_reason: StopReason::Deadline, objective_value: Some(film.area()), ..run });
        }
        Err(Interruption::Cancelled) => return Err(Interruption::Cancelled.into()),
    }
    let energy = dirichlet_energy(&domain, &film.vertices, film.triangles());
    let stop_reason = if moves { StopReason::Solved } else { StopReason::NothingToMove };
    let Record { history, iterations, .. } = record;
    Ok(Run { stop_reason, iterations, history, objective_value: Some(energy), ..run })
}

/// The error for a mesh whose factor does not fit.
pub(super) fn too_large(_: LinearError) -> Error {
    Error::no_result("too_large", "the linear system of this mesh does not fit into memory; ask for fewer triangles")
}

#[cfg(test)]
mod tests {
    use super::super::structured::patch;
    use super::*;

    #[test]
    fn one_solve_flattens_a_patch_with_a_plane_rim() {
        let mut film = patch(8, 8, |u, v| DVec3::new(u, v, (u * (1.0 - u) * v * (1.0 - v)).sqrt()));
        Dirichlet::new(&film).unwrap().step(&mut film).unwrap();
        assert!(film.vertices.iter().all(|vertex| vertex.z.abs() < 1e-14));
    }

    #[test]
    fn the_dirichlet_energy_is_least_and_at_least_the_area() {
        let mut film = patch(9, 7, |u, v| DVec3::new(u + 0.2 * v * v, v - 0.3 * u * v, (3.0 * u + v).sin() * 0.4));
        let mut domain = film.clone();
        let run = run_once(&mut film, &Execution::default()).unwrap();
        flip_to_delaunay(&mut domain);
        let energy = |film: &Film| dirichlet_energy(&domain.vertices, &film.vertices, domain.triangles());
        let least = run.objective_value.unwrap();
        // The identity's energy is the area; the image's is between its own area and that.
        assert!((energy(&domain) - domain.area()).abs() < 1e-12 * domain.area());
        assert!(film.area() <= least && least <= domain.area());
        for v in (0..film.vertices.len()).filter(|&v| !film.fixed[v]) {
            for direction in DVec3::AXES {
                let mut moved = film.clone();
                moved.vertices[v] += 1e-3 * direction;
                assert!(energy(&moved) > least);
            }
        }
    }
}
