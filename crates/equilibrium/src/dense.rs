//! A solver for the small dense systems of the constraints.
//!
//! The kernels of a linear algebra library use fused multiply-adds where the processor has them, which changes the last
//! bits of a result from one machine to the next. The systems here have one row per constraint, so plain loops are fast
//! enough, and they give the same bits on every machine.

/// The factorisation P A Q = L U of a matrix A, with complete pivoting.
#[derive(Debug)]
pub(crate) struct Lu {
    n: usize,
    /// L below the diagonal and U on and above it, row by row.
    entries: Vec<f64>,
    /// For each step k of the elimination, the row and the column of A that it eliminates.
    rows: Vec<usize>,
    columns: Vec<usize>,
}

impl Lu {
    /// Factorises the n × n matrix with the given entries, in O(n³). For a singular matrix, [`solve`](Self::solve)
    /// returns values that are not finite.
    pub fn new(n: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut entries: Vec<f64> = (0..n * n).map(|k| entry(k / n, k % n)).collect();
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..n).collect(), (0..n).collect());
        for k in 0..n {
            let mut pivot = (k, k);
            for i in k..n {
                for j in k..n {
                    if entries[i * n + j].abs() > entries[pivot.0 * n + pivot.1].abs() {
                        pivot = (i, j);
                    }
                }
            }
            rows.swap(k, pivot.0);
            columns.swap(k, pivot.1);
            if pivot.0 != k {
                (0..n).for_each(|j| entries.swap(k * n + j, pivot.0 * n + j));
            }
            if pivot.1 != k {
                (0..n).for_each(|i| entries.swap(i * n + k, i * n + pivot.1));
            }
            let (above, below) = entries.split_at_mut((k + 1) * n);
            let row = &above[k * n..];
            for other in below.chunks_exact_mut(n) {
                let factor = other[k] / row[k];
                other[k] = factor;
                other[k + 1..].iter_mut().zip(&row[k + 1..]).for_each(|(entry, above)| *entry -= factor * above);
            }
        }
        Self { n, entries, rows, columns }
    }

    /// Solves A x = b.
    pub fn solve(&self, right: &[f64]) -> Vec<f64> {
        let n = self.n;
        let mut y: Vec<f64> = self.rows.iter().map(|&row| right[row]).collect();
        for k in 0..n {
            let known: f64 = (0..k).map(|j| self.entries[k * n + j] * y[j]).sum();
            y[k] -= known;
        }
        for k in (0..n).rev() {
            let known: f64 = (k + 1..n).map(|j| self.entries[k * n + j] * y[j]).sum();
            y[k] = (y[k] - known) / self.entries[k * n + k];
        }
        let mut x = vec![0.0; n];
        self.columns.iter().zip(y).for_each(|(&column, value)| x[column] = value);
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn solutions_satisfy_their_systems(
            n in 0usize..12,
            seed in prop::collection::vec(-1.0..1.0f64, 144),
            zeros in 0usize..4,
        ) {
            // A block of zeros at the top left has no pivot of its own, so the pivots must come from elsewhere.
            let entry = |i: usize, j: usize| {
                if i < zeros && j < zeros && zeros < n / 2 { 0.0 } else { seed[i * 12 + j] }
            };
            let right: Vec<f64> = (0..n).map(|i| seed[143 - i]).collect();
            let x = Lu::new(n, entry).solve(&right);
            let size = x.iter().fold(1.0f64, |size, x| size.max(x.abs()));
            for (i, right) in right.iter().enumerate() {
                let sum: f64 = (0..n).map(|j| entry(i, j) * x[j]).sum();
                prop_assert!((sum - right).abs() < 1e-13 * size, "{i} of {n}: {sum} {right}");
            }
        }
    }

    #[test]
    fn the_solution_of_a_singular_system_is_not_finite() {
        let x = Lu::new(2, |_, j| [1.0, 2.0][j]).solve(&[1.0, 2.0]);
        assert!(x.iter().any(|x| !x.is_finite()), "{x:?}");
    }
}
