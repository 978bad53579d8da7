//! Constraints on the whole body, such as a volume or a length, and linear systems that respect them.
//!
//! With an energy E and constraints c_k(x) = 0 the Lagrangian is E - Σ λ_k c_k. Newton's step x and the change -μ of
//! the multipliers solve the bordered system
//!
//! ```text
//! K x + Cᵀ μ = -g          K the second variation of the Lagrangian, g its gradient,
//! C x        = -c          C the constraints' gradients, one row each
//! ```
//!
//! by elimination: with Y = K⁻¹ Cᵀ and S = C Y. By Haynsworth's additivity of inertia the bordered matrix has n₋(K) +
//! n₊(S) negative eigenvalues, and as many of them as there are constraints belong to the border. The Morse index on
//! the constraints' tangent space C x = 0 is therefore n₋(K) - n₋(S) (Gould, *On practical conditions for the existence
//! and uniqueness of solutions to the general equality quadratic programming problem*, 1985).

use crate::energy::Term;
use crate::sparse::{Factorisation, LinearError};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// A quantity of the whole body that keeps its value.
#[derive(Debug)]
pub struct Constraint {
    /// The quantity: any energy, with coefficient 1. For the volume that is a pressure of -1.
    pub quantity: Box<dyn Term>,
    /// The value that it keeps; not zero.
    pub target: f64,
}

/// A constraint at one position.
#[derive(Clone, Debug)]
pub(crate) struct ConstraintState {
    /// The quantity less its target.
    pub excess: f64,
    /// The target's magnitude.
    pub scale: f64,
    /// λ: for a volume the pressure, for a length the force. The least squares multiplier at this position.
    pub multiplier: f64,
    /// Derivative of the quantity by each unknown.
    pub gradient: Vec<f64>,
}

/// The multipliers that come nearest to balancing a gradient: the least of Σ (g - Σ λ_k c_k)² / m over the unknowns of
/// mass m.
pub(crate) fn least_squares_multipliers(gradient: &[f64], constraints: &[Vec<f64>], mass: &[f64]) -> Vec<f64> {
    if constraints.is_empty() {
        return Vec::new();
    }
    let inner = |a: &[f64], b: &[f64]| {
        a.iter().zip(b).zip(mass).map(|((a, b), m)| if *m > 0.0 { a * b / m } else { 0.0 }).sum::<f64>()
    };
    let n = constraints.len();
    let matrix = Mat::from_fn(n, n, |i, j| inner(&constraints[i], &constraints[j]));
    let right = Mat::from_fn(n, 1, |i, _| inner(&constraints[i], gradient));
    let solution = matrix.full_piv_lu().solve(&right);
    (0..n).map(|k| solution[(k, 0)]).collect()
}

/// A factorised second variation with the constraints' border; without constraints the factorisation alone.
pub(crate) struct Bordered<'a> {
    factorisation: Factorisation<'a>,
    constraints: &'a [ConstraintState],
    /// Columns of Y, one after the other.
    y: Vec<f64>,
    /// S, and its number of negative eigenvalues.
    schur: Mat<f64>,
    negative: usize,
}

impl<'a> Bordered<'a> {
    /// # Errors
    /// A [`LinearError`] if K or S is singular to working precision.
    pub fn new(factorisation: Factorisation<'a>, constraints: &'a [ConstraintState]) -> Result<Self, LinearError> {
        let mut y: Vec<f64> = constraints.iter().flat_map(|constraint| &constraint.gradient).copied().collect();
        let n = constraints.len();
        let mut schur = Mat::zeros(n, n);
        let mut negative = 0;
        if n > 0 {
            factorisation.solve(&mut y)?;
            let order = constraints[0].gradient.len();
            for i in 0..n {
                for j in 0..n {
                    schur[(i, j)] = dot(&constraints[i].gradient, &y[j * order..(j + 1) * order]);
                }
            }
            let eigenvalues = schur.self_adjoint_eigenvalues(Side::Lower).map_err(|_| LinearError::NotFinite)?;
            negative = eigenvalues.iter().filter(|value| **value < 0.0).count();
        }
        Ok(Self { factorisation, constraints, y, schur, negative })
    }

    /// The Morse index on the constraints' tangent space.
    pub fn index(&self) -> usize {
        self.factorisation.inertia().negative.saturating_sub(self.negative)
    }

    /// Newton's step for the Lagrangian's gradient.
    ///
    /// # Errors
    /// A [`LinearError`] if the solution does not satisfy its system.
    pub fn step(&self, gradient: &[f64]) -> Result<Vec<f64>, LinearError> {
        let mut step: Vec<f64> = gradient.iter().map(|gradient| -gradient).collect();
        self.factorisation.solve(&mut step)?;
        self.correct(&mut step, |constraint| -constraint.excess);
        Ok(step)
    }

    /// Applies the inverse of the matrix on the tangent space, without a check: for preconditioners.
    pub fn apply(&self, right_hand_side: &mut [f64]) {
        self.factorisation.solve_unchecked(right_hand_side);
        self.correct(right_hand_side, |_| 0.0);
    }

    /// Subtracts Y μ so that C x becomes `wanted` for each constraint.
    pub fn correct(&self, x: &mut [f64], wanted: impl Fn(&ConstraintState) -> f64) {
        let n = self.constraints.len();
        if n == 0 {
            return;
        }
        let right = Mat::from_fn(n, 1, |k, _| dot(&self.constraints[k].gradient, x) - wanted(&self.constraints[k]));
        let multipliers = self.schur.full_piv_lu().solve(&right);
        for (k, column) in self.y.chunks_exact(x.len()).enumerate() {
            x.iter_mut().zip(column).for_each(|(x, y)| *x -= multipliers[(k, 0)] * y);
        }
    }

    /// Gives the factor's memory back.
    pub fn into_storage(self) -> Vec<f64> {
        self.factorisation.into_storage()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
