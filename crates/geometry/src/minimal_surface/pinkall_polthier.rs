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

use super::cotangent::Pattern;
use super::film::{Film, Run};
use super::record::{Record, geometric_part};
use super::statistics::{Curvature, StopReason};
use super::{Options, Solver};
use crate::linear::{LinearError, Symbolic, SymmetricMatrix};
use crate::{DVec3, Error, Execution, Interruption};

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
}

/// Linear solves that a run may take if the caller does not say.
const DEFAULT_SOLVES: u32 = 200;

/// Step 3 until the area changes by less than the area tolerance, or the residual is below its own.
///
/// A deadline ends the run with what was reached, a collapse with [`StopReason::Collapsed`].
///
/// # Errors
/// [`Error::Interrupted`] on cancel; [`Error::NoResult`] if the mesh is too large to factorise.
pub(super) fn run(film: &mut Film, options: &Options, exec: &Execution) -> Result<Run, Error> {
    let limit = options.max_iterations.unwrap_or(DEFAULT_SOLVES);
    let mut record = Record::new(exec);
    let mut dirichlet = Dirichlet::new(film).map_err(too_large)?;
    let mut area = film.area();
    let mut first_change = None;
    let stop_reason = loop {
        if dirichlet.pattern.vertex.is_empty() {
            break StopReason::NothingToMove;
        }
        if record.iterations >= limit {
            break StopReason::MaxIterations;
        }
        match exec.look(film.triangles().len() as u64) {
            Ok(()) => {}
            Err(Interruption::DeadlinePassed) => break StopReason::Deadline,
            Err(Interruption::Cancelled) => return Err(Interruption::Cancelled.into()),
        }
        if dirichlet.step(film).is_err() {
            break StopReason::Collapsed;
        }
        let before = std::mem::replace(&mut area, film.area());
        let change = (before - area).abs() / area;
        let residual = Curvature::of(film).residual;
        let first_change = *first_change.get_or_insert(change);
        let part = geometric_part(first_change, change, options.area_tolerance);
        record.iteration("pinkall_polthier", area, residual, part);
        if residual <= options.tolerance {
            break StopReason::Residual;
        }
        if change <= options.area_tolerance || change.is_nan() {
            break StopReason::AreaChange;
        }
    };
    Ok(Run { stop_reason, iterations: record.iterations, history: record.history, ..Run::new(Solver::PinkallPolthier) })
}

/// The error for a mesh whose factor does not fit.
pub(super) fn too_large(_: LinearError) -> Error {
    Error::no_result("too_large", "the linear system of this mesh does not fit into memory; ask for fewer triangles")
}

#[cfg(test)]
mod tests {
    use super::super::Resolution;
    use super::super::structured::{cylinder, patch};
    use super::*;

    #[test]
    fn one_solve_flattens_a_patch_with_a_plane_rim() {
        let mut film = patch(8, 8, |u, v| DVec3::new(u, v, (u * (1.0 - u) * v * (1.0 - v)).sqrt()));
        Dirichlet::new(&film).unwrap().step(&mut film).unwrap();
        assert!(film.vertices.iter().all(|vertex| vertex.z.abs() < 1e-14));
    }

    #[test]
    fn the_area_falls_at_every_solve_to_the_catenoid() {
        let mut film = cylinder(48, 12, 1.0);
        let mut options = Options::new(Resolution::Triangles(1));
        (options.area_tolerance, options.tolerance) = (0.0, 1e-4);
        let run = run(&mut film, &options, &Execution::default()).unwrap();
        assert_eq!(run.stop_reason, StopReason::Residual);
        assert!(run.history.windows(2).all(|pair| pair[1].area <= pair[0].area * (1.0 + 1e-14)));
        // Between the polygons the area is a little below the smooth catenoid's 5.991797 between circles.
        assert!((film.area() - 5.9918).abs() < 0.02, "{}", film.area());
    }

    #[test]
    fn the_area_tolerance_and_the_limit_end_a_run() {
        let mut options = Options::new(Resolution::Triangles(1));
        let solve = |options: &Options| run(&mut cylinder(24, 6, 1.0), options, &Execution::default()).unwrap();
        (options.area_tolerance, options.tolerance) = (1e-4, 0.0);
        assert_eq!(solve(&options).stop_reason, StopReason::AreaChange);
        (options.area_tolerance, options.max_iterations) = (0.0, Some(3));
        let run = solve(&options);
        assert_eq!((run.stop_reason, run.iterations), (StopReason::MaxIterations, 3));
    }
}
