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
//!
//! Two further kinds of rows share the elimination:
//! - A constraint that yields by its compliance d, c(x) + d λ = 0, has the row C x - d μ = -(c + d λ). It adds d to S,
//!   and by the same count the index of K + Cᵀ C / d is n₋(K) - n₋(S) as before. A rank-one part s c cᵀ of the second
//!   variation (a cable whose force depends on its whole length) is such a row with d = 1 / s and no excess.
//! - A quantity whose multiplier is determined by another equation h(x, λ) = 0 ([`Condition`]) keeps its column Cᵀ, and
//!   its row is ∂h x - h_λ μ = -h. The step then solves a system that is not symmetric. The index stays that of
//!   the constrained quantity: of motions that keep the value which the equation leads to.

use super::dense::Lu;
use crate::energy::{Condition, Term};
use faer::{Mat, Side};
use plateau_mesh::random::SplitMix64;
use plateau_mesh::sparse::{Factorisation, LinearError, dot};
use plateau_mesh::{Execution, Interruption};

/// Number of inverse iterations that estimate the least eigenvalue. From a random start in n dimensions the estimate is
/// too large by a factor of about n^(1/8), which is below 5 for 250,000 unknowns.
const INVERSE_ITERATIONS: usize = 4;
/// An inertia is certain if the estimate of the least eigenvalue exceeds the bound on the rounding errors by this
/// factor: 5 for the estimate, and 3 for an unlucky start.
const CLEARANCE: f64 = 16.0;

/// A quantity of the whole body that keeps its value.
#[derive(Debug)]
pub struct Constraint {
    /// The quantity, given as an energy. The volume is the energy of a pressure of -1, and the negated length that of a
    /// tension of -1; their multipliers are the pressure and the force.
    pub quantity: Box<dyn Term>,
    /// The condition that determines its multiplier.
    pub by: Determined,
}

/// The condition that determines the multiplier of a constrained quantity.
#[derive(Debug)]
pub enum Determined {
    /// The value that the quantity keeps; not zero.
    Value(f64),
    /// A value that yields to the multiplier λ: the quantity is `value` - `compliance` · λ. The energy of the yielding,
    /// ½ `compliance` λ², counts in the energy of the body. Example: the negated length of an elastic cable, whose
    /// force is the multiplier. A stiff cable is then as easy to solve as a cable of given length.
    Yielding {
        /// The value at which the multiplier is 0. It must not be 0.
        value: f64,
        /// The fall of the quantity per unit of λ. It must be positive.
        compliance: f64,
    },
    /// Another equation; the quantity's value follows.
    Condition(Box<dyn Condition>),
}

impl Constraint {
    /// A quantity that keeps a value, which must not be zero.
    #[must_use]
    pub fn value(quantity: Box<dyn Term>, target: f64) -> Self {
        Self { quantity, by: Determined::Value(target) }
    }
}

/// A constraint at one position, or a rank-one part of the second variation.
#[derive(Clone, Debug)]
pub(crate) struct ConstraintState {
    /// The quantity less its target, or the value of the condition.
    pub excess: f64,
    /// The target's magnitude.
    pub scale: f64,
    /// λ: for a volume the pressure, for a length the force. The least squares multiplier at this position.
    pub multiplier: f64,
    /// Derivative of the quantity by each unknown.
    pub gradient: Vec<f64>,
    /// For a condition its derivatives by each unknown and by the multiplier.
    pub condition: Option<(Vec<f64>, f64)>,
    /// d of a constraint that yields, 1 / s of a rank-one part of the second variation; otherwise zero.
    pub compliance: f64,
}

impl ConstraintState {
    /// The rank-one part `stiffness` · gradient gradientᵀ.
    pub fn rank_one_part(stiffness: f64, gradient: Vec<f64>) -> Self {
        let compliance = 1.0 / stiffness;
        Self { excess: 0.0, scale: 1.0, multiplier: 0.0, gradient, condition: None, compliance }
    }
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
    let right: Vec<f64> = constraints.iter().map(|constraint| inner(constraint, gradient)).collect();
    Lu::new(n, |i, j| inner(&constraints[i], &constraints[j])).solve(&right)
}

/// A factorised second variation with the constraints' border; without constraints the factorisation alone.
pub(crate) struct Bordered<'a> {
    factorisation: Factorisation<'a>,
    constraints: &'a [ConstraintState],
    /// Columns of Y, one after the other.
    y: Vec<f64>,
    /// S of the constrained quantities and rank-one parts, and its factors.
    schur_matrix: Mat<f64>,
    schur: Lu,
    /// S with the rows of the conditions, if there are any.
    conditioned: Option<Lu>,
    /// Number of negative eigenvalues of S.
    negative: usize,
    /// Number of rank-one parts of negative stiffness. Each raises the index by one, because its entry -d of the border
    /// is positive and adds no negative eigenvalue.
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

    /// Whether rounding errors cannot have changed the [`index`](Self::index).
    ///
    /// The inertia of K is certain if no eigenvalue of K x = λ Δ x lies between -1 and 1, where Δ is the
    /// [bound on the errors](Factorisation::rounding). Inverse iteration estimates the least one, for K and for K on
    /// the tangent space. The errors of K change S by at most Yᵀ Δ Y, and the sums in S are rounded, too.
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

    /// Whether the least eigenvalue of K x = λ Δ x, whose inverse `solve` applies, is large enough.
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

    /// Newton's step for the Lagrangian's gradient.
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

    /// Applies the inverse of the matrix on the tangent space, without a check: for preconditioners.
    pub fn apply(&self, right_hand_side: &mut [f64]) {
        self.factorisation.solve_unchecked(right_hand_side);
        self.correct(right_hand_side, |_| 0.0);
    }

    /// Subtracts Y μ so that C x becomes `wanted` for each constraint.
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

    /// Gives the factor's memory back.
    pub fn into_storage(self) -> Vec<f64> {
        self.factorisation.into_storage()
    }
}

/// Number of negative eigenvalues of a small symmetric matrix.
fn negative_eigenvalues(matrix: &Mat<f64>) -> Result<usize, LinearError> {
    let eigenvalues = matrix.self_adjoint_eigenvalues(Side::Lower).map_err(|_| LinearError::NotFinite)?;
    Ok(eigenvalues.iter().filter(|value| **value < 0.0).count())
}

/// Adds the products of the parts s c cᵀ by `x` to `product`: those of the rows that yield.
pub(crate) fn add_rank_one_products(constraints: &[ConstraintState], x: &[f64], product: &mut [f64]) {
    for row in constraints.iter().filter(|row| row.compliance != 0.0) {
        let factor = dot(&row.gradient, x) / row.compliance;
        product.iter_mut().zip(&row.gradient).for_each(|(product, gradient)| *product += factor * gradient);
    }
}
