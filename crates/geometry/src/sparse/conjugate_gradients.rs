//! The method of conjugate gradients (Hestenes and Stiefel) for symmetric positive definite systems, without a
//! preconditioner, as the papers on minimal surfaces use it.

use super::SymmetricMatrix;

/// Improves `x` until ‖b - A x‖ <= `tolerance` ‖b - A x₀‖ (Euclidean), x₀ the given `x`. Returns the number of steps.
///
/// In exact arithmetic the order of the matrix bounds the steps; `None` if that many do not suffice, if a direction of
/// negative or vanishing curvature shows up (the matrix is not positive definite) or a number is not finite; `x` is then
/// the last iterate. One product with the matrix a step.
pub fn conjugate_gradients(matrix: &SymmetricMatrix, b: &[f64], x: &mut [f64], tolerance: f64) -> Option<usize> {
    let n = matrix.order();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut product = vec![0.0; n];
    matrix.multiply(x, &mut product);
    let mut residual: Vec<f64> = b.iter().zip(&product).map(|(b, ax)| b - ax).collect();
    let mut direction = residual.clone();
    let mut square = dot(&residual, &residual);
    let goal = tolerance * tolerance * square;
    for step in 0..=n {
        if square <= goal {
            return Some(step);
        }
        matrix.multiply(&direction, &mut product);
        let curvature = dot(&direction, &product);
        if !(curvature > 0.0 && curvature.is_finite()) {
            return None;
        }
        let length = square / curvature;
        for k in 0..n {
            x[k] += length * direction[k];
            residual[k] -= length * product[k];
        }
        let before = std::mem::replace(&mut square, dot(&residual, &residual));
        let ratio = square / before;
        for k in 0..n {
            direction[k] = residual[k] + ratio * direction[k];
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The path graph's Laplacian with both ends held, `shift` subtracted from its diagonal.
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

    #[test]
    fn the_solution_of_a_path_is_the_parabola() {
        let n = 40;
        let mut x = vec![0.0; n];
        let steps = conjugate_gradients(&path(n, 0.0), &vec![1.0; n], &mut x, 1e-12).unwrap();
        assert!(steps <= n);
        for (k, x) in x.iter().enumerate() {
            let exact = 0.5 * (k + 1) as f64 * (n - k) as f64;
            assert!((x - exact).abs() < 1e-8 * exact);
        }
    }

    #[test]
    fn an_indefinite_system_is_given_up() {
        let mut x = vec![0.0; 40];
        assert_eq!(conjugate_gradients(&path(40, 3.0), &[1.0; 40], &mut x, 1e-12), None);
        assert_eq!(conjugate_gradients(&path(40, f64::NAN), &[1.0; 40], &mut x, 1e-12), None);
    }
}
