//! Geometric multigrid on nested meshes, as the preconditioner of conjugate gradients.
//!
//! Brandt, *Multi-level adaptive solutions to boundary-value problems* (1977); as a preconditioner: Braess, *Towards
//! algebraic multigrid for elliptic problems of second order* (1995).
//!
//! 1. A fine mesh is made from a coarse one by halving every edge. The prolongation sets the height at a midpoint to
//!    the mean of the heights at the ends of the edge, where a fixed end counts as zero. The restriction is its
//!    transpose.
//! 2. The matrix of a level is the one that Newton's method assembled on that mesh; no product of matrices is formed.
//!    In the plane it equals the restriction of the finer matrix, and on a film nearly so.
//! 3. One V-cycle consists of a forward Gauss-Seidel sweep, the correction by the coarser level, and a backward sweep.
//!    The coarsest level uses the factor L D Lᵀ. The cycle is symmetric, and positive definite if the matrices are.
//! 4. Conjugate gradients use the cycle as preconditioner. The residual falls by a factor of about ten per iteration,
//!    whatever the size of the mesh.

use super::{CgFailure, Symbolic, SymmetricMatrix, conjugate_gradients};
use crate::Execution;

use super::pattern::FIXED;

/// Largest number of iterations of conjugate gradients. If more are needed, the hierarchy is a poor preconditioner for
/// the matrix.
const MAX_ITERATIONS: usize = 60;

/// The two parents of each unknown of a level, which are unknowns of the next coarser level. The prolongation sets each
/// unknown to the mean of its parents. A parent may be [`FIXED`], which counts as zero. An unknown that exists on both
/// levels is its own parent twice.
pub type Parents = Vec<[u32; 2]>;

/// The coarser levels below the level of the system that is to be solved.
#[derive(Debug)]
pub struct Hierarchy {
    symbolic: Symbolic,
    factor: Vec<f64>,
    /// The matrices and parents of the levels, from coarse to fine. The coarsest level is not among them, because only
    /// its factor is kept.
    levels: Vec<(SymmetricMatrix, Parents)>,
}

impl Hierarchy {
    /// Makes a hierarchy of one level. `factor` is the factor of its positive definite matrix.
    pub fn new(symbolic: Symbolic, factor: Vec<f64>) -> Self {
        Self { symbolic, factor, levels: Vec::new() }
    }

    /// Adds a finer level.
    pub fn push(&mut self, matrix: SymmetricMatrix, parents: Parents) {
        self.levels.push((matrix, parents));
    }

    /// Applies an approximate inverse of `matrix` to the right-hand side: one V-cycle. `parents` are the parents of the
    /// unknowns on the finest level of the hierarchy.
    pub fn precondition(&self, matrix: &SymmetricMatrix, parents: &[[u32; 2]], right_hand_side: &[f64]) -> Vec<f64> {
        self.cycle(self.levels.len(), matrix, parents, right_hand_side)
    }

    /// Runs a V-cycle. `below` is the number of levels below this level, not counting the coarsest.
    fn cycle(&self, below: usize, matrix: &SymmetricMatrix, parents: &[[u32; 2]], right_hand_side: &[f64]) -> Vec<f64> {
        let n = right_hand_side.len();
        let mut x = vec![0.0; n];
        for row in 0..n {
            relax(matrix, right_hand_side, &mut x, row);
        }
        let coarse_order = match below {
            0 => self.symbolic.order(),
            _ => self.levels[below - 1].0.order(),
        };
        // An additional entry collects the contributions to fixed vertices, which are not used.
        let mut coarse = vec![0.0; coarse_order + 1];
        let place = |parent: u32| (parent as usize).min(coarse_order);
        for row in 0..n {
            let (columns, values) = matrix.row(row);
            let product: f64 = columns.iter().zip(values).map(|(&column, &a)| a * x[column as usize]).sum();
            let half = 0.5 * (right_hand_side[row] - product);
            let [first, second] = parents[row];
            coarse[place(first)] += half;
            coarse[place(second)] += half;
        }
        coarse.truncate(coarse_order);
        let mut correction = match below {
            0 => {
                self.symbolic.apply(&self.factor, &mut coarse);
                coarse
            }
            _ => {
                let (matrix, parents) = &self.levels[below - 1];
                self.cycle(below - 1, matrix, parents, &coarse)
            }
        };
        correction.push(0.0);
        for (x, &[first, second]) in x.iter_mut().zip(parents) {
            *x += 0.5 * (correction[place(first)] + correction[place(second)]);
        }
        for row in (0..n).rev() {
            relax(matrix, right_hand_side, &mut x, row);
        }
        x
    }

    /// Solves `matrix` x = `right_hand_side` until `is_small` accepts the residual.
    ///
    /// # Errors
    /// See [`CgFailure`].
    pub fn solve(
        &self,
        matrix: &SymmetricMatrix,
        parents: &[[u32; 2]],
        right_hand_side: &[f64],
        is_small: impl Fn(&[f64]) -> bool,
        exec: &Execution,
    ) -> Result<Vec<f64>, CgFailure> {
        let mut x = vec![0.0; right_hand_side.len()];
        let precondition =
            |residual: &[f64], out: &mut [f64]| out.copy_from_slice(&self.precondition(matrix, parents, residual));
        conjugate_gradients(matrix, right_hand_side, &mut x, precondition, is_small, MAX_ITERATIONS, exec)?;
        Ok(x)
    }
}

/// Changes one unknown so that its own equation holds (Gauss-Seidel).
#[inline]
fn relax(matrix: &SymmetricMatrix, right_hand_side: &[f64], x: &mut [f64], row: usize) {
    let (columns, values) = matrix.row(row);
    let others: f64 = columns[1..].iter().zip(&values[1..]).map(|(&column, &a)| a * x[column as usize]).sum();
    x[row] = (right_hand_side[row] - others) / values[0];
}

/// Prolongs the heights of a coarser mesh to the finer one.
pub fn prolong(coarse: &[f64], parents: &[[u32; 2]]) -> Vec<f64> {
    let height = |row: u32| coarse.get(row as usize).copied().unwrap_or(0.0);
    parents.iter().map(|&[first, second]| 0.5 * (height(first) + height(second))).collect()
}

/// Returns the parents of the unknowns of a finer mesh. `coarse_unknown` has the unknown of each coarse vertex, or
/// [`FIXED`], and `fine_vertices` the vertex of each fine unknown. New vertices are numbered after the coarse ones, and
/// each halves an edge: `midpoints` has the ends of the edge for each of them.
pub fn parents_of(coarse_unknown: &[u32], fine_vertices: &[u32], midpoints: &[[u32; 2]]) -> Parents {
    let old = coarse_unknown.len();
    let unknown = |vertex: u32| coarse_unknown[vertex as usize];
    let parents = fine_vertices.iter().map(|&vertex| match (vertex as usize).checked_sub(old) {
        None => [unknown(vertex); 2],
        Some(new) => midpoints[new].map(unknown),
    });
    debug_assert!(coarse_unknown.iter().all(|&row| row == FIXED || (row as usize) < old));
    parents.collect()
}
