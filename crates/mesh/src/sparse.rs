//! Sparse symmetric linear systems, factorised as L D Lᵀ. Matrices of the same pattern share one symbolic
//! factorisation. The signs of D give the inertia.
//!
//! Everything runs on the calling thread ([`Par::Seq`]), so that results do not depend on the number of cores. Every
//! solution is checked against its right-hand side before it is returned.

mod conjugate_gradients;
pub mod levenberg_marquardt;
pub mod multigrid;
pub mod pattern;

pub use conjugate_gradients::{CgFailure, conjugate_gradients};

use crate::Interruption;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

/// Largest residual of an accepted solution, as a fraction of ‖A‖‖x‖ + ‖b‖ (maximum norms). A solution above it is
/// refined once, and refused if its residual is still too large.
const RESIDUAL_TOLERANCE: f64 = 1e-9;

/// Why a linear system has no reliable solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinearError {
    /// An entry is infinite or not a number.
    NotFinite,
    /// A pivot vanished: the matrix is singular to working precision.
    Singular,
    /// The solution does not satisfy the system, even after refinement.
    Inaccurate,
    /// The factor has more entries than 32-bit indices or memory can hold.
    TooLarge,
}

/// Why a solver that looks at its signal has no solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unsolved {
    /// The linear system has no reliable solution, for instance because the mesh is degenerate.
    Refused(LinearError),
    /// The caller wants the solver to stop.
    Interrupted(Interruption),
}

impl From<LinearError> for Unsolved {
    fn from(error: LinearError) -> Self {
        Self::Refused(error)
    }
}

impl From<Interruption> for Unsolved {
    fn from(interruption: Interruption) -> Self {
        Self::Interrupted(interruption)
    }
}

/// The scalar product of two vectors, summed in the order of the entries.
#[must_use]
#[inline]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A sparse symmetric matrix. Both triangles are stored, row by row. The diagonal entry comes first in its row; the
/// other entries of the row follow in any order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SymmetricMatrix {
    pub row_start: Vec<u32>,
    pub columns: Vec<u32>,
    pub values: Vec<f64>,
}

impl SymmetricMatrix {
    #[must_use]
    #[inline]
    pub fn order(&self) -> usize {
        self.row_start.len().saturating_sub(1)
    }

    /// Whether both matrices have entries at the same places, stored in the same order.
    #[must_use]
    pub fn has_pattern_of(&self, other: &Self) -> bool {
        self.row_start == other.row_start && self.columns == other.columns
    }

    /// Columns and values of a row, the diagonal first.
    #[must_use]
    #[inline]
    pub fn row(&self, row: usize) -> (&[u32], &[f64]) {
        let range = self.row_start[row] as usize..self.row_start[row + 1] as usize;
        (&self.columns[range.clone()], &self.values[range])
    }

    #[must_use]
    #[inline]
    pub fn diagonal(&self, row: usize) -> f64 {
        self.values[self.row_start[row] as usize]
    }

    /// `out = self · x`.
    #[inline]
    pub fn multiply(&self, x: &[f64], out: &mut [f64]) {
        for (row, value) in out.iter_mut().enumerate() {
            let (columns, values) = self.row(row);
            *value = columns.iter().zip(values).map(|(&column, &a)| a * x[column as usize]).sum();
        }
    }

    /// Sum of the absolute values in each row.
    #[inline]
    pub fn absolute_row_sums(&self) -> impl Iterator<Item = f64> {
        (0..self.order()).map(|row| self.row(row).1.iter().map(|a| a.abs()).sum())
    }

    /// Largest sum of absolute values in a row.
    #[must_use]
    #[inline]
    pub fn norm(&self) -> f64 {
        self.absolute_row_sums().fold(0.0, f64::max)
    }

    fn pattern(&self) -> SymbolicSparseColMatRef<'_, u32> {
        let n = self.order();
        SymbolicSparseColMatRef::new_unsorted_checked(n, n, &self.row_start, None, &self.columns)
    }
}

/// Numbers of negative and positive eigenvalues of a symmetric matrix. By Sylvester's law they are those of D in L D
/// Lᵀ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inertia {
    pub negative: usize,
    pub positive: usize,
}

impl Inertia {
    #[must_use]
    #[inline]
    pub fn is_positive_definite(self) -> bool {
        self.negative == 0
    }
}

/// A symbolic factorisation: the fill-reducing order of the unknowns and the pattern of L. It is valid for every matrix
/// of the same pattern.
#[derive(Debug)]
pub struct Symbolic {
    inner: SymbolicCholesky<u32>,
}

impl Symbolic {
    /// Analyses the pattern of a matrix. `order` is a permutation that gives the old index at each new position. If
    /// `order` is `None`, the approximate minimum degree method determines it.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub fn analyse(matrix: &SymmetricMatrix, order: Option<&[u32]>) -> Result<Self, LinearError> {
        let inverse = order.map(|order| {
            let mut inverse = vec![0u32; order.len()];
            for (new, &old) in order.iter().enumerate() {
                inverse[old as usize] = new as u32;
            }
            inverse
        });
        let ordering = match (order, &inverse) {
            (Some(order), Some(inverse)) => {
                SymmetricOrdering::Custom(PermRef::new_checked(order, inverse, matrix.order()))
            }
            _ => SymmetricOrdering::Amd,
        };
        let parameters = CholeskySymbolicParams::default();
        factorize_symbolic_cholesky(matrix.pattern(), Side::Lower, ordering, parameters)
            .map(|inner| Self { inner })
            .map_err(|_| LinearError::TooLarge)
    }

    /// Number of unknowns.
    #[must_use]
    #[inline]
    pub fn order(&self) -> usize {
        self.inner.nrows()
    }

    /// Number of stored entries of L. It determines the memory of a factorisation; its square over the order determines
    /// the work.
    #[must_use]
    #[inline]
    pub fn factor_entries(&self) -> usize {
        self.inner.len_val()
    }

    /// Factorises a matrix of the analysed pattern, which may be indefinite, as L D Lᵀ without pivoting.
    ///
    /// Without pivoting the factor of an indefinite matrix may lose digits. [`Factorisation::solve`] then refines the
    /// solution or refuses it.
    ///
    /// # Errors
    /// [`LinearError::NotFinite`], [`LinearError::Singular`] or [`LinearError::TooLarge`].
    #[inline]
    pub fn factorise<'a>(&'a self, matrix: &'a SymmetricMatrix) -> Result<Factorisation<'a>, LinearError> {
        self.factorise_into(matrix, Vec::new())
    }

    /// Does the same as [`factorise`](Self::factorise), but reuses the storage of an earlier factorisation
    /// ([`Factorisation::into_storage`]).
    ///
    /// # Errors
    /// The errors of [`factorise`](Self::factorise).
    pub fn factorise_into<'a>(
        &'a self,
        matrix: &'a SymmetricMatrix,
        storage: Vec<f64>,
    ) -> Result<Factorisation<'a>, LinearError> {
        if matrix.values.iter().any(|value| !value.is_finite()) {
            return Err(LinearError::NotFinite);
        }
        let mut values = storage;
        values.resize(self.inner.len_val(), 0.0);
        let request = self.inner.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = MemBuffer::try_new(request).map_err(|_| LinearError::TooLarge)?;
        let a = SparseColMatRef::new(matrix.pattern(), &matrix.values);
        self.inner
            .factorize_numeric_ldlt(
                &mut values,
                a,
                Side::Lower,
                LdltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|_| LinearError::Singular)?;
        let inertia = self.inertia(&values).ok_or(LinearError::Singular)?;
        Ok(Factorisation { symbolic: self, matrix, values, inertia })
    }

    /// Applies the inverse of the matrix whose factor has the entries `values` ([`Factorisation::into_storage`]). The
    /// result is not checked. This function is for preconditioners.
    #[inline]
    pub fn apply(&self, values: &[f64], right_hand_sides: &mut [f64]) {
        let n = self.inner.nrows();
        if n == 0 {
            return;
        }
        let columns = right_hand_sides.len() / n;
        let request = self.inner.solve_in_place_scratch::<f64>(columns, Par::Seq);
        let mut memory = MemBuffer::new(request);
        LdltRef::new(&self.inner, values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(right_hand_sides, n, columns),
            Par::Seq,
            MemStack::new(&mut memory),
        );
    }

    /// Counts the signs of the pivots in D. `None` if a pivot is zero or not finite.
    fn inertia(&self, values: &[f64]) -> Option<Inertia> {
        let mut inertia = Inertia { negative: 0, positive: 0 };
        let mut is_regular = true;
        self.visit_columns(values, |column| {
            match column.pivot.partial_cmp(&0.0) {
                Some(std::cmp::Ordering::Less) => inertia.negative += 1,
                Some(std::cmp::Ordering::Greater) => inertia.positive += 1,
                _ => is_regular = false,
            }
            is_regular &= column.pivot.is_finite();
        });
        is_regular.then_some(inertia)
    }

    /// Visits the columns of the factor whose entries are `values`, in the order of the factorisation.
    fn visit_columns<'a>(&'a self, values: &'a [f64], mut visit: impl FnMut(Column<'a>)) {
        match self.inner.raw() {
            SymbolicCholeskyRaw::Simplicial(simplicial) => {
                for number in 0..simplicial.ncols() {
                    let range = simplicial.col_ptr()[number] as usize..simplicial.col_ptr()[number + 1] as usize;
                    let (rows, entries) = (&simplicial.row_idx()[range.clone()], &values[range]);
                    visit(Column { number, pivot: entries[0], next: &[], rows: &rows[1..], others: &entries[1..] });
                }
            }
            SymbolicCholeskyRaw::Supernodal(supernodal) => {
                for node in 0..supernodal.n_supernodes() {
                    let first = supernodal.supernode_begin()[node] as usize;
                    let columns = supernodal.supernode_end()[node] as usize - first;
                    let rows = supernodal.supernode(node).pattern();
                    let begin = supernodal.col_ptr_for_val()[node] as usize;
                    let height = columns + rows.len();
                    for k in 0..columns {
                        let entries = &values[begin + k * height..begin + (k + 1) * height];
                        let (next, others) = (&entries[k + 1..columns], &entries[columns..]);
                        visit(Column { number: first + k, pivot: entries[k], next, rows, others });
                    }
                }
            }
        }
    }

    /// See [`Factorisation::rounding`].
    fn rounding(&self, values: &[f64]) -> Vec<f64> {
        let n = self.order();
        let mut scaled_sums = vec![0.0; n];
        let mut terms = vec![0u32; n];
        self.visit_columns(values, |column| {
            let sum: f64 = column.below().map(|(_, entry)| entry.abs()).sum();
            scaled_sums[column.number] = column.pivot.abs() * (1.0 + sum);
            column.below().for_each(|(row, _)| terms[row] += 1);
        });
        let mut sums = scaled_sums.clone();
        self.visit_columns(values, |column| {
            let scaled = scaled_sums[column.number];
            column.below().for_each(|(row, entry)| sums[row] += entry.abs() * scaled);
        });
        let factor = f64::from(terms.into_iter().max().unwrap_or(0) + 2) * f64::EPSILON;
        match self.inner.perm() {
            Some(permutation) => {
                let mut rounding = vec![0.0; n];
                permutation.arrays().0.iter().zip(sums).for_each(|(&old, sum)| rounding[old as usize] = factor * sum);
                rounding
            }
            None => sums.into_iter().map(|sum| factor * sum).collect(),
        }
    }
}

/// A column of L with its pivot in D.
struct Column<'a> {
    number: usize,
    pivot: f64,
    /// The entries in the consecutive rows directly below the diagonal.
    next: &'a [f64],
    /// The rows of the other entries, and the other entries themselves.
    rows: &'a [u32],
    others: &'a [f64],
}

impl Column<'_> {
    /// The rows and entries below the diagonal.
    fn below(&self) -> impl Iterator<Item = (usize, f64)> {
        let others = self.rows.iter().map(|&row| row as usize).zip(self.others.iter().copied());
        (self.number + 1..).zip(self.next.iter().copied()).chain(others)
    }
}

/// The factorisation L D Lᵀ of a matrix.
#[derive(Debug)]
pub struct Factorisation<'a> {
    symbolic: &'a Symbolic,
    matrix: &'a SymmetricMatrix,
    values: Vec<f64>,
    inertia: Inertia,
}

impl Factorisation<'_> {
    #[must_use]
    #[inline]
    pub fn inertia(&self) -> Inertia {
        self.inertia
    }

    /// Bound on the rounding errors of the factorisation: the diagonal entries of a matrix Δ with -Δ ≤ L D Lᵀ - A ≤ Δ.
    /// If no eigenvalue λ of A x = λ Δ x lies between -1 and 1, the computed inertia is therefore that of A.
    ///
    /// Each entry of L D Lᵀ - A is at most (k + 1) u times the entry of |L| |D| |Lᵀ|, where k is the largest number of
    /// terms of an entry and u is half of [`f64::EPSILON`] (Higham, *Accuracy and Stability of Numerical Algorithms*,
    /// 2002, theorem 10.3). The sum of a row of these bounds is the row's entry of Δ, because it bounds the row's share
    /// of the quadratic form. The returned bound is twice that sum.
    #[must_use]
    #[inline]
    pub fn rounding(&self) -> Vec<f64> {
        self.symbolic.rounding(&self.values)
    }

    /// Number of unknowns.
    #[must_use]
    #[inline]
    pub fn order(&self) -> usize {
        self.matrix.order()
    }

    /// Returns the memory of the factor for the next factorisation.
    #[must_use]
    #[inline]
    pub fn into_storage(self) -> Vec<f64> {
        self.values
    }

    /// Overwrites the right-hand sides, stored one after the other, with the solutions. Each solution is checked, and
    /// refined once if its residual is too large.
    ///
    /// # Errors
    /// [`LinearError::Inaccurate`] if a solution is not finite or does not satisfy its system;
    /// [`LinearError::NotFinite`] if a right-hand side is not finite.
    ///
    /// # Panics
    /// If the length is not a multiple of the matrix's order.
    pub fn solve(&self, right_hand_sides: &mut [f64]) -> Result<(), LinearError> {
        let n = self.matrix.order();
        if n == 0 {
            return Ok(());
        }
        assert_eq!(right_hand_sides.len() % n, 0, "whole columns");
        if right_hand_sides.iter().any(|value| !value.is_finite()) {
            return Err(LinearError::NotFinite);
        }
        let given = right_hand_sides.to_vec();
        self.solve_unchecked(right_hand_sides);
        let norm = self.matrix.norm();
        let mut residual = vec![0.0; n];
        for (x, b) in right_hand_sides.chunks_exact_mut(n).zip(given.chunks_exact(n)) {
            if self.is_accurate(norm, x, b, &mut residual) {
                continue;
            }
            self.solve_unchecked(&mut residual);
            for (x, correction) in x.iter_mut().zip(&residual) {
                *x += correction;
            }
            if !self.is_accurate(norm, x, b, &mut residual) {
                return Err(LinearError::Inaccurate);
            }
        }
        Ok(())
    }

    /// Solves with the factor once, without checking the solutions. This function is for preconditioners, whose errors
    /// the outer iteration detects.
    #[inline]
    pub fn solve_unchecked(&self, right_hand_sides: &mut [f64]) {
        self.symbolic.apply(&self.values, right_hand_sides);
    }

    /// Whether the residual of `x` is within the tolerance. Writes b - A x to `residual`.
    fn is_accurate(&self, norm: f64, x: &[f64], b: &[f64], residual: &mut [f64]) -> bool {
        let largest = |values: &[f64]| values.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
        self.matrix.multiply(x, residual);
        for (residual, b) in residual.iter_mut().zip(b) {
            *residual = b - *residual;
        }
        // f64::max ignores NaN, so finiteness is checked first.
        x.iter().all(|value| value.is_finite())
            && largest(residual) <= RESIDUAL_TOLERANCE * (norm * largest(x) + largest(b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The five-point Laplacian of a square grid minus `shift` times the identity. Its eigenvalues are known.
    fn grid(side: usize, shift: f64) -> SymmetricMatrix {
        let mut matrix = SymmetricMatrix { row_start: vec![0], ..Default::default() };
        for k in 0..side * side {
            let (i, j) = (k / side, k % side);
            matrix.columns.push(k as u32);
            matrix.values.push(4.0 - shift);
            let neighbours = [
                (i > 0, k.wrapping_sub(side)),
                (j + 1 < side, k + 1),
                (i + 1 < side, k + side),
                (j > 0, k.wrapping_sub(1)),
            ];
            for (_, neighbour) in neighbours.iter().filter(|(exists, _)| *exists) {
                matrix.columns.push(*neighbour as u32);
                matrix.values.push(-1.0);
            }
            matrix.row_start.push(matrix.columns.len() as u32);
        }
        matrix
    }

    fn eigenvalues_below(side: usize, shift: f64) -> usize {
        let term = |k: usize| 2.0 - 2.0 * libm::cos(std::f64::consts::PI * k as f64 / (side + 1) as f64);
        (1..=side).flat_map(|i| (1..=side).map(move |j| term(i) + term(j))).filter(|&value| value < shift).count()
    }

    #[test]
    fn inertia_counts_the_eigenvalues_of_a_shifted_grid_in_both_storage_forms() {
        // The small matrix is factorised column by column, the large one by supernodes.
        for (side, simplicial) in [(6, true), (150, false)] {
            let symbolic = Symbolic::analyse(&grid(side, 0.0), None).unwrap();
            assert_eq!(matches!(symbolic.inner.raw(), SymbolicCholeskyRaw::Simplicial(_)), simplicial);
            for shift in [0.0, 0.1234, 0.777] {
                let matrix = grid(side, shift);
                let factorisation = symbolic.factorise(&matrix).unwrap();
                let negative = eigenvalues_below(side, shift);
                assert_eq!(factorisation.inertia(), Inertia { negative, positive: side * side - negative });
                let expected: Vec<f64> = (0..2 * side * side).map(|k| libm::sin(k as f64)).collect();
                let mut x = vec![0.0; expected.len()];
                for (out, column) in x.chunks_exact_mut(side * side).zip(expected.chunks_exact(side * side)) {
                    matrix.multiply(column, out);
                }
                factorisation.solve(&mut x).unwrap();
                assert!(x.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-8));
            }
        }
    }

    #[test]
    fn the_factors_differ_from_the_matrix_by_less_than_the_bound_on_rounding() {
        let mut random = crate::random::SplitMix64::new(3);
        for (side, shift) in [(6, 0.777), (150, 0.0), (150, 0.777)] {
            let n = side * side;
            let matrix = grid(side, shift);
            let symbolic = Symbolic::analyse(&matrix, None).unwrap();
            let factorisation = symbolic.factorise(&matrix).unwrap();
            let rounding = factorisation.rounding();
            // Without pivoting, the entries of the factor of an indefinite matrix may grow, and the bound grows with
            // them.
            assert!(shift > 0.0 || rounding.iter().sum::<f64>() < 1e-11 * matrix.absolute_row_sums().sum::<f64>());
            let order = symbolic.inner.perm().unwrap().arrays().0;
            for _ in 0..20 {
                let x: Vec<f64> = (0..n).map(|_| random.between(-1.0, 1.0)).collect();
                // The quadratic form of L D Lᵀ: the sum over the columns of the pivot times the squared entry of Lᵀ x.
                let mut form = 0.0;
                let at = |row: usize| x[order[row] as usize];
                symbolic.visit_columns(&factorisation.values, |column| {
                    let below: f64 = column.below().map(|(row, entry)| entry * at(row)).sum();
                    form += column.pivot * (at(column.number) + below).powi(2);
                });
                let mut product = vec![0.0; n];
                matrix.multiply(&x, &mut product);
                let given: f64 = x.iter().zip(&product).map(|(x, product)| x * product).sum();
                let bound: f64 = x.iter().zip(&rounding).map(|(x, rounding)| rounding * x * x).sum();
                assert!((form - given).abs() <= bound, "{side}: {form} {given} {bound}");
            }
        }
    }

    #[test]
    fn a_given_order_gives_the_same_solution() {
        let matrix = grid(12, 0.3);
        let order: Vec<u32> = (0..144).map(|k| k * 5 % 144).collect();
        let mut given: Vec<f64> = (0..144).map(f64::from).collect();
        let mut own = given.clone();
        Symbolic::analyse(&matrix, Some(&order)).unwrap().factorise(&matrix).unwrap().solve(&mut given).unwrap();
        Symbolic::analyse(&matrix, None).unwrap().factorise(&matrix).unwrap().solve(&mut own).unwrap();
        assert!(given.iter().zip(&own).all(|(a, b)| (a - b).abs() < 1e-9));
    }

    #[test]
    fn singular_and_infinite_systems_are_refused() {
        let mut matrix =
            SymmetricMatrix { row_start: vec![0, 2, 4], columns: vec![0, 1, 1, 0], values: vec![1.0, -1.0, 1.0, -1.0] };
        let symbolic = Symbolic::analyse(&matrix, None).unwrap();
        assert_eq!(symbolic.factorise(&matrix).err(), Some(LinearError::Singular));
        matrix.values[0] = f64::NAN;
        assert_eq!(symbolic.factorise(&matrix).err(), Some(LinearError::NotFinite));
        matrix.values = vec![2.0, -1.0, 2.0, -1.0];
        let factorisation = symbolic.factorise(&matrix).unwrap();
        assert_eq!(factorisation.solve(&mut [f64::INFINITY, 0.0]), Err(LinearError::NotFinite));
    }

    #[test]
    fn an_inaccurate_solution_is_refused() {
        // The factor of another matrix takes the place of a silently wrong factorisation.
        let (right, wrong) = (grid(8, 0.0), grid(8, 0.5));
        let symbolic = Symbolic::analyse(&right, None).unwrap();
        let values = symbolic.factorise(&wrong).unwrap().into_storage();
        let factorisation = Factorisation {
            symbolic: &symbolic,
            matrix: &right,
            values,
            inertia: Inertia { negative: 0, positive: 64 },
        };
        assert_eq!(factorisation.solve(&mut [1.0; 64]), Err(LinearError::Inaccurate));
    }
}
