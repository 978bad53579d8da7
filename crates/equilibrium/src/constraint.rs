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
//! n₊(S) negative eigenvalues, and each constraint of the border accounts for one of them. The Morse index on the
//! constraints' tangent space C x = 0 is therefore n₋(K) - n₋(S) (Gould, *On practical conditions for the existence and
//! uniqueness of solutions to the general equality quadratic programming problem*, 1985).
//!
//! Two further kinds of rows are eliminated in the same way:
//! - A constraint that yields with the compliance d satisfies c(x) + d λ = 0. Its row is C x - d μ = -(c + d λ), which
//!   adds d to the diagonal of S. By the same count, the index of K + Cᵀ C / d is n₋(K) - n₋(S). A rank-one part s c cᵀ
//!   of the second variation (a cable whose force depends on its whole length) is treated as a row of this kind: d is
//!   1 / s, and the excess is 0.
//! - The multiplier of a quantity may be determined by another equation h(x, λ) = 0 ([`Condition`]). The quantity keeps
//!   its column Cᵀ, but its row becomes ∂h x - h_λ μ = -h, so the step solves a system that is not symmetric. The Morse
//!   index is still computed with the symmetric row: it counts motions that keep the value of the quantity.

use super::dense::Lu;
use crate::energy::{Condition, Term};
use faer::{Mat, Side};
use plateau_mesh::random::SplitMix64;
use plateau_mesh::sparse::{Factorisation, LinearError, dot};
use plateau_mesh::{Execution, Interruption};

/// Number of inverse iterations that estimate the smallest eigenvalue. From a random start in n dimensions the estimate
/// exceeds the eigenvalue by a factor of about n^(1/8), which is below 5 for 250,000 unknowns.
const INVERSE_ITERATIONS: usize = 4;
/// The Morse index is certain if the estimate of the smallest eigenvalue exceeds the bound on the rounding errors by
/// this factor. It allows a factor of 5 for the error of the estimate, and a factor of 3 for an unlucky random start.
const CLEARANCE: f64 = 16.0;

/// A quantity of the whole body, such as a volume, with the condition that determines its Lagrange multiplier.
#[derive(Debug)]
pub struct Constraint {
    /// The quantity, given as an energy. For a volume this is the energy of a pressure of -1, and the multiplier is the
    /// pressure. For a negated length it is the energy of a tension of -1, and the multiplier is the force.
    pub quantity: Box<dyn Term>,
    /// The condition that determines the multiplier of the quantity.
    pub by: Determined,
}

/// The condition that determines the multiplier of a constrained quantity.
#[derive(Debug)]
pub enum Determined {
    /// The quantity keeps this value, which must not be 0.
    Value(f64),
    /// The quantity yields to its multiplier λ: it is `value` - `compliance` · λ. The energy that this stores, ½
    /// `compliance` λ², is part of the energy of the body. Example: the negated length of an elastic cable, whose force
    /// is the multiplier. A stiff cable is then as easy to solve as a cable of given length.
    Yielding {
        /// The value at which the multiplier is 0. It must not be 0.
        value: f64,
        /// Decrease of the quantity per unit of λ. It must be positive.
        compliance: f64,
    },
    /// An equation determines the multiplier; the value of the quantity follows from the equilibrium.
    Condition(Box<dyn Condition>),
}

impl Constraint {
    /// A constraint that keeps `quantity` at `target`, which must not be 0.
    #[must_use]
    pub fn value(quantity: Box<dyn Term>, target: f64) -> Self {
        Self { quantity, by: Determined::Value(target) }
    }
}

/// A constraint at one position, or a rank-one part of the second variation.
#[derive(Clone, Debug)]
pub struct ConstraintState {
    /// The quantity minus its target, or the value of the condition. It is 0 in equilibrium.
    pub excess: f64,
    /// The magnitude against which `excess` is measured: that of the target, or [`Condition::scale`].
    pub scale: f64,
    /// λ, the least squares multiplier at this position: the pressure for a volume, the force for a length.
    pub multiplier: f64,
    /// Derivative of the quantity by each unknown.
    pub gradient: Vec<f64>,
    /// For a condition, its derivatives by each unknown and its derivative by the multiplier.
    pub condition: Option<(Vec<f64>, f64)>,
    /// Compliance d of a constraint that yields, or 1 / s for a rank-one part of stiffness s; otherwise 0.
    pub compliance: f64,
}

impl ConstraintState {
    /// Makes the row of the rank-one part `stiffness` · gradient gradientᵀ.
    pub fn rank_one_part(stiffness: f64, gradient: Vec<f64>) -> Self {
        let compliance = 1.0 / stiffness;
        Self { excess: 0.0, scale: 1.0, multiplier: 0.0, gradient, condition: None, compliance }
    }
}

/// The multipliers λ that best balance a gradient g: they minimise Σ (g - Σ λ_k c_k)² / m over the unknowns, whose
/// masses are m.
pub(crate) fn least_squares_multipliers(gradient: &[f64], constraints: &[Vec<f64>], mass: &[f64]) -> Vec<f64> {
    if constraints.is_empty() {
        return Vec::new();
    }
    let inner = |a: &[f64], b: &[f64]| {
        a.iter().zip(b).zip(mass).map(|((a, b), m)| if *m > 0.0 { a * b / m } else { 0.0 }).sum::<f64>()
    };
    let n = constraints.len();
    let right: Vec<f64> = constraints.iter().map(|constraint| inner(constraint, gradient)).collect();
    Lu::new(n, |i, j| inner(&constraints[i], &constraints[j])).solve(&right)
}

/// A factorised second variation, bordered by the rows of the constraints. Without constraints it is the factorisation
/// alone.
pub(crate) struct Bordered<'a> {
    factorisation: Factorisation<'a>,
    constraints: &'a [ConstraintState],
    /// The columns of Y = K⁻¹ Cᵀ, stored one after the other.
    y: Vec<f64>,
    /// The matrix S = C Y, with the compliances added to its diagonal, and its factors.
    schur_matrix: Mat<f64>,
    schur: Lu,
    /// Factors of S with the rows of conditions in place of the symmetric rows. `None` if there are no conditions.
    conditioned: Option<Lu>,
    /// Number of negative eigenvalues of S.
    negative: usize,
    /// Number of rank-one parts of negative stiffness. Each raises the Morse index by one, because its diagonal entry
    /// -d in the border is positive and therefore adds no negative eigenvalue.
    softening: usize,
}

impl<'a> Bordered<'a> {
    /// # Errors
    /// A [`LinearError`] if K or S is singular to working precision.
    pub fn new(factorisation: Factorisation<'a>, constraints: &'a [ConstraintState]) -> Result<Self, LinearError> {
        let mut y: Vec<f64> = constraints.iter().flat_map(|constraint| &constraint.gradient).copied().collect();
        let n = constraints.len();
        let mut schur = Mat::zeros(n, n);
        let (mut negative, mut softening) = (0, 0);
        let mut conditioned = None;
        if n > 0 {
            factorisation.solve(&mut y)?;
            let order = constraints[0].gradient.len();
            let column = |j: usize| &y[j * order..(j + 1) * order];
            for i in 0..n {
                for j in 0..n {
                    schur[(i, j)] = dot(&constraints[i].gradient, column(j));
                }
                schur[(i, i)] += constraints[i].compliance;
            }
            negative = negative_eigenvalues(&schur)?;
            softening = constraints.iter().filter(|constraint| constraint.compliance < 0.0).count();
            if constraints.iter().any(|constraint| constraint.condition.is_some()) {
                let mut rows = schur.clone();
                for (i, constraint) in constraints.iter().enumerate() {
                    let Some((by_unknowns, by_multiplier)) = &constraint.condition else { continue };
                    (0..n).for_each(|j| rows[(i, j)] = dot(by_unknowns, column(j)));
                    rows[(i, i)] += by_multiplier;
                }
                conditioned = Some(Lu::new(n, |i, j| rows[(i, j)]));
            }
        }
        let (schur_matrix, schur) = (schur.clone(), Lu::new(n, |i, j| schur[(i, j)]));
        Ok(Self { factorisation, constraints, y, schur_matrix, schur, conditioned, negative, softening })
    }

    /// The Morse index on the constraints' tangent space.
    pub fn index(&self) -> usize {
        (self.factorisation.inertia().negative + self.softening).saturating_sub(self.negative)
    }

    /// Whether the [`index`](Self::index) is certain in spite of rounding errors.
    ///
    /// The inertia of K is certain if no eigenvalue of K x = λ Δ x lies between -1 and 1. Here Δ is the bound on the
    /// rounding errors of K ([`Factorisation::rounding`]). Inverse iteration estimates the eigenvalue of least
    /// magnitude, for K and for K on the tangent space. The errors of K change S by at most Yᵀ Δ Y; rounding in the
    /// sums of S is added to that.
    ///
    /// # Errors
    /// The interruption.
    pub fn is_certain(&self, exec: &Execution) -> Result<bool, Interruption> {
        let rounding = self.factorisation.rounding();
        if !self.clears(&rounding, |x| self.factorisation.solve_unchecked(x), exec)? {
            return Ok(false);
        }
        if self.constraints.is_empty() {
            return Ok(true);
        }
        let order = self.factorisation.order();
        let columns: Vec<&[f64]> = self.y.chunks_exact(order).collect();
        let sums = order as f64 * f64::EPSILON;
        let error = |i: usize, j: usize| {
            let (rows, column) = (self.constraints[i].gradient.iter().zip(columns[i]), columns[j].iter());
            let errors = rows.zip(column).zip(&rounding);
            errors.map(|(((c, y), other), bound)| ((y * bound).abs() + sums * c.abs()) * other.abs()).sum::<f64>()
        };
        let n = self.constraints.len();
        let shift: Vec<f64> = (0..n).map(|i| (0..n).map(|j| error(i, j)).sum()).collect();
        let counted = |sign: f64| {
            let shifted = |i: usize, j: usize| self.schur_matrix[(i, j)] + if i == j { sign * shift[i] } else { 0.0 };
            negative_eigenvalues(&Mat::from_fn(n, n, shifted))
        };
        if counted(1.0) != Ok(self.negative) || counted(-1.0) != Ok(self.negative) {
            return Ok(false);
        }
        self.clears(&rounding, |x| self.apply(x), exec)
    }

    /// Whether the eigenvalue of least magnitude of K x = λ Δ x exceeds 1 by the factor [`CLEARANCE`]. `solve` applies
    /// K⁻¹, and `rounding` is the diagonal of Δ.
    fn clears(&self, rounding: &[f64], solve: impl Fn(&mut [f64]), exec: &Execution) -> Result<bool, Interruption> {
        let size = |x: &[f64]| x.iter().zip(rounding).map(|(x, bound)| x * x * bound).sum::<f64>().sqrt();
        let mut random = SplitMix64::new(1);
        let mut x: Vec<f64> = rounding.iter().map(|_| random.between(-1.0, 1.0)).collect();
        let mut growth = f64::INFINITY;
        for _ in 0..INVERSE_ITERATIONS {
            exec.look(self.factorisation.order() as u64)?;
            let before = size(&x);
            x.iter_mut().zip(rounding).for_each(|(x, bound)| *x *= bound / before);
            solve(&mut x);
            growth = size(&x);
        }
        Ok(CLEARANCE * growth <= 1.0)
    }

    /// Returns Newton's step, given the gradient of the Lagrangian.
    ///
    /// # Errors
    /// A [`LinearError`] if the solution does not satisfy its system.
    pub fn step(&self, gradient: &[f64]) -> Result<Vec<f64>, LinearError> {
        let mut step: Vec<f64> = gradient.iter().map(|gradient| -gradient).collect();
        self.factorisation.solve(&mut step)?;
        let Some(rows) = &self.conditioned else {
            self.correct(&mut step, |constraint| -constraint.excess);
            return Ok(step);
        };
        let along = |constraint: &ConstraintState| match &constraint.condition {
            Some((by_unknowns, _)) => dot(by_unknowns, &step),
            None => dot(&constraint.gradient, &step),
        };
        let right: Vec<f64> = self.constraints.iter().map(|row| along(row) + row.excess).collect();
        let multipliers = rows.solve(&right);
        self.subtract(&mut step, &multipliers);
        if step.iter().all(|value| value.is_finite()) { Ok(step) } else { Err(LinearError::Singular) }
    }

    /// Applies the inverse of K on the constraints' tangent space. The result is not checked, because this serves
    /// preconditioners and inverse iterations.
    pub fn apply(&self, right_hand_side: &mut [f64]) {
        self.factorisation.solve_unchecked(right_hand_side);
        self.correct(right_hand_side, |_| 0.0);
    }

    /// Subtracts Y μ from `x`, with the μ for which C x becomes `wanted` for each constraint.
    pub fn correct(&self, x: &mut [f64], wanted: impl Fn(&ConstraintState) -> f64) {
        if self.constraints.is_empty() {
            return;
        }
        let right: Vec<f64> = self.constraints.iter().map(|row| dot(&row.gradient, x) - wanted(row)).collect();
        let multipliers = self.schur.solve(&right);
        self.subtract(x, &multipliers);
    }

    fn subtract(&self, x: &mut [f64], multipliers: &[f64]) {
        for (k, column) in self.y.chunks_exact(x.len()).enumerate() {
            x.iter_mut().zip(column).for_each(|(x, y)| *x -= multipliers[k] * y);
        }
    }

    /// Returns the storage of the factor, for reuse by the next factorisation.
    pub fn into_storage(self) -> Vec<f64> {
        self.factorisation.into_storage()
    }
}

/// Number of negative eigenvalues of a small symmetric matrix.
fn negative_eigenvalues(matrix: &Mat<f64>) -> Result<usize, LinearError> {
    let eigenvalues = matrix.self_adjoint_eigenvalues(Side::Lower).map_err(|_| LinearError::NotFinite)?;
    Ok(eigenvalues.iter().filter(|value| **value < 0.0).count())
}

/// Adds s c (cᵀ x) to `product` for each row with a compliance, where c is the row's gradient and s = 1 / compliance.
pub(crate) fn add_rank_one_products(constraints: &[ConstraintState], x: &[f64], product: &mut [f64]) {
    for row in constraints.iter().filter(|row| row.compliance != 0.0) {
        let factor = dot(&row.gradient, x) / row.compliance;
        product.iter_mut().zip(&row.gradient).for_each(|(product, gradient)| *product += factor * gradient);
    }
}
