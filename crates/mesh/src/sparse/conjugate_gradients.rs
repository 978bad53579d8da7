//! The method of conjugate gradients (Hestenes and Stiefel 1952) for symmetric positive definite systems.

use super::{SymmetricMatrix, dot};
use crate::{Execution, Interruption};

/// Why the method of conjugate gradients did not reach the required residual.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CgFailure {
    /// A direction of negative or zero curvature occurred, or a number that is not finite: the matrix or the
    /// preconditioner is not positive definite.
    Indefinite,
    /// The maximum number of iterations was reached.
    Slow,
    /// The caller asked to stop.
    Interrupted(Interruption),
}

/// Improves `x` until `is_small` accepts the residual b - A x. Returns the number of iterations.
///
/// `precondition` writes an approximation of A⁻¹ r to its second argument. The map from r to the approximation must be
/// linear, symmetric and positive definite. A `precondition` that copies r gives the method without a preconditioner.
/// Each iteration takes one product with the matrix and one call of `exec.look`.
///
/// # Errors
/// See [`CgFailure`]. After a failure `x` is the last iterate.
pub fn conjugate_gradients(
    matrix: &SymmetricMatrix,
    b: &[f64],
    x: &mut [f64],
    mut precondition: impl FnMut(&[f64], &mut [f64]),
    is_small: impl Fn(&[f64]) -> bool,
    max_iterations: usize,
    exec: &Execution,
) -> Result<usize, CgFailure> {
    let n = matrix.order();
    let mut product = vec![0.0; n];
    let mut residual = b.to_vec();
    if x.iter().any(|&x| x != 0.0) {
        matrix.multiply(x, &mut product);
        residual.iter_mut().zip(&product).for_each(|(residual, ax)| *residual -= ax);
    }
    let mut preconditioned = vec![0.0; n];
    let mut direction = vec![0.0; n];
    let mut last_energy = 0.0;
    for iteration in 0..max_iterations {
        if is_small(&residual) {
            return Ok(iteration);
        }
        exec.look(n as u64).map_err(CgFailure::Interrupted)?;
        precondition(&residual, &mut preconditioned);
        let energy = dot(&residual, &preconditioned);
        let ratio = if iteration == 0 { 0.0 } else { energy / last_energy };
        last_energy = energy;
        for (direction, z) in direction.iter_mut().zip(&preconditioned) {
            *direction = z + ratio * *direction;
        }
        matrix.multiply(&direction, &mut product);
        let curvature = dot(&direction, &product);
        // The negated comparison ends the iteration for NaN too.
        if !(energy > 0.0 && curvature > 0.0 && curvature.is_finite()) {
            return Err(CgFailure::Indefinite);
        }
        let length = energy / curvature;
        for (x, direction) in x.iter_mut().zip(&direction) {
            *x += length * direction;
        }
        for (residual, product) in residual.iter_mut().zip(&product) {
            *residual -= length * product;
        }
    }
    if is_small(&residual) { Ok(max_iterations) } else { Err(CgFailure::Slow) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Signal;
    use crate::sparse::Symbolic;
    use std::cell::Cell;

    /// The Laplacian of a path graph with both ends held, minus `shift` times the identity.
    fn path(n: usize, shift: f64) -> SymmetricMatrix {
        let mut matrix = SymmetricMatrix { row_start: vec![0], ..Default::default() };
        for k in 0..n {
            let neighbours = [(k > 0, k.wrapping_sub(1)), (k + 1 < n, k + 1)];
            matrix.columns.push(k as u32);
            matrix.values.push(2.0 - shift);
            for (_, neighbour) in neighbours.into_iter().filter(|(exists, _)| *exists) {
                matrix.columns.push(neighbour as u32);
                matrix.values.push(-1.0);
            }
            matrix.row_start.push(matrix.columns.len() as u32);
        }
        matrix
    }

    /// Solves with the right-hand side 1, without a preconditioner, to an absolute residual of 1e-11.
    fn solve(matrix: &SymmetricMatrix, x: &mut [f64], exec: &Execution) -> Result<usize, CgFailure> {
        let n = x.len();
        let small = |residual: &[f64]| residual.iter().all(|r| r.abs() < 1e-11);
        conjugate_gradients(matrix, &vec![1.0; n], x, |r, z| z.copy_from_slice(r), small, n + 1, exec)
    }

    #[test]
    fn a_cancel_is_seen_at_the_next_iteration() {
        let looks = Cell::new(0);
        let signal = || {
            looks.set(looks.get() + 1);
            if looks.get() == 5 { Signal::Cancel } else { Signal::Continue }
        };
        let mut x = vec![0.0; 40];
        let ended = solve(&path(40, 0.0), &mut x, &Execution::new(&signal, &|_| {}));
        assert_eq!((ended, looks.get()), (Err(CgFailure::Interrupted(Interruption::Cancelled)), 5));
    }

    #[test]
    fn the_exact_inverse_as_preconditioner_needs_one_iteration() {
        let matrix = path(40, 0.0);
        let symbolic = Symbolic::analyse(&matrix, None).unwrap();
        let factors = symbolic.factorise(&matrix).unwrap();
        let exact = |r: &[f64], z: &mut [f64]| {
            z.copy_from_slice(r);
            factors.solve_unchecked(z);
        };
        let small = |residual: &[f64]| residual.iter().all(|r| r.abs() < 1e-9);
        let mut x = vec![0.0; 40];
        let steps = conjugate_gradients(&matrix, &[1.0; 40], &mut x, exact, small, 10, &Execution::default());
        assert_eq!(steps, Ok(1));
    }

    #[test]
    fn the_solution_of_a_path_is_the_parabola() {
        let n = 40;
        let mut x = vec![0.0; n];
        let steps = solve(&path(n, 0.0), &mut x, &Execution::default()).unwrap();
        assert!(steps <= n);
        for (k, x) in x.iter().enumerate() {
            let exact = 0.5 * (k + 1) as f64 * (n - k) as f64;
            assert!((x - exact).abs() < 1e-8 * exact);
        }
    }

    #[test]
    fn an_indefinite_system_is_given_up() {
        let mut x = vec![0.0; 40];
        assert_eq!(solve(&path(40, 3.0), &mut x, &Execution::default()), Err(CgFailure::Indefinite));
        x.fill(0.0);
        assert_eq!(solve(&path(40, f64::NAN), &mut x, &Execution::default()), Err(CgFailure::Indefinite));
    }
}
