//! Whether a stationary state is a true local minimum: the second variation along the body's freedoms.
//!
//! K is the matrix of [`newton`](super::newton) at the final positions, M the lumped mass (each unknown's share of
//! tension times size).
//! - The Morse index is the number of negative eigenvalues of K, on the tangent space of the constraints if there are
//!   any. By Sylvester's law it is the number of negative pivots in K = L D Lᵀ, whatever the mass; no eigenvalue needs
//!   to be computed for it. The pivots belong to a matrix that differs from K by rounding errors. Their count is the
//!   index if no eigenvalue is as small as a bound on these errors (`Bordered::is_certain`). Otherwise the matrices
//!   K + s and K - s are counted for a small s. Equal counts are the index, and different ones are its bounds.
//! - The lowest eigenvalue of K x = λ M x and its vector: locally optimal preconditioned conjugate gradients (Knyazev,
//!   *Toward the Optimal Preconditioned Eigensolver*, 2001, for one vector). The preconditioner is the factor of K, or
//!   of K + s M with s large enough to make it positive definite, so that a handful of iterations suffice.
//!
//! The iteration starts at the constant height. The lowest eigenfunction of a film that moves along its normals has one
//! sign, so that the two are not orthogonal. Where unknowns have other directions, and on the tangent space of
//! constraints, a symmetric start would miss modes without its symmetry. There the inertia of K - λ M shows whether an
//! eigenvalue is lower than λ. If one is, the iteration starts a second time, at pseudo-random heights. If the sign of
//! the lowest eigenvalue does not agree with the index, the index is undecided.
//!
//! The index counts motions of the vertices. It says nothing about changes of topology: a point where eight junctions
//! meet may be stable under every motion although splitting the point lowers the energy.

use super::constraint::{Bordered, ConstraintState, add_rank_one_products};
use super::newton::{Direct, Equations, State};
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::Warning;
use plateau_mesh::random::SplitMix64;
use plateau_mesh::sparse::{LinearError, Symbolic, SymmetricMatrix, Unsolved, dot};
use plateau_mesh::{DVec3, Execution, Interruption};

/// The iteration for the lowest eigenvalue ends when the eigenvalue changes by less than this fraction of itself, or of
/// 1/1000 of 1/R² if that is more.
const EIGENVALUE_TOLERANCE: f64 = 1e-9;
/// Bound on the number of these iterations.
const MAX_ITERATIONS: usize = 60;
/// Number of shifts of an indefinite matrix that are tried before it is given up. The first is the eigenvalue
/// scale 1/R², and each is four times the one before.
const MAX_SHIFTS: usize = 24;
/// First shift with which a matrix of uncertain inertia is counted again, relative to the sums of absolute values in
/// its rows; the factor to the next shift; and the number of shifts. The first is the rounding error of a factor in
/// which 250 terms add up to an entry. The last moves the lowest eigenvalue of a film of 10,000 triangles by about
/// 1e-4 / R².
const FIRST_COUNT_SHIFT: f64 = 250.0 * f64::EPSILON;
const COUNT_SHIFT_GROWTH: f64 = 32.0;
const MAX_COUNT_SHIFTS: usize = 4;
/// Rounding error of a quadratic form, relative to the sum of the absolute values of its terms.
const FORM_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// The iteration has missed the lowest mode if an eigenvalue lies below its result by more than this fraction of the
/// result (or of 1/1000 of 1/R²). The fraction is far above the [`EIGENVALUE_TOLERANCE`] of the iteration.
const SAME_EIGENVALUE: f64 = 1e-6;
/// A start whose projection on the tangent space is smaller than this fraction of itself consists of rounding errors,
/// because the constraints leave no motion.
const NO_MOTION: f64 = 1e-10;
/// Least length that the second pass of an orthogonalisation leaves of a unit vector. The second pass hardly changes a
/// vector that has a part outside the span of the basis, because the first pass has already made it orthogonal up to
/// rounding errors. If the second pass takes more than half of the vector, the first pass left rounding errors alone.
const LEAST_LEFT: f64 = 0.5;

/// An eigenvalue with its vector (unit in the lumped mass).
#[derive(Clone, Debug)]
pub struct Mode {
    pub eigenvalue: f64,
    pub vector: Vec<f64>,
}

/// Bounds on the number of negative eigenvalues. They differ only if rounding leaves the sign of an eigenvalue
/// undecided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MorseIndex {
    pub least: usize,
    pub most: usize,
}

impl MorseIndex {
    fn exactly(count: usize) -> Self {
        Self { least: count, most: count }
    }

    /// The index; `None` if it is undecided.
    pub fn decided(self) -> Option<usize> {
        (self.least == self.most).then_some(self.least)
    }

    /// Returns this index if the sign of the lowest eigenvalue agrees with it, and otherwise an undecided one with a
    /// lower bound of 0 and an upper bound of 1 or more. The eigenvalue is known up to ±`rounding`.
    pub fn checked_against(self, lowest: f64, rounding: f64) -> Self {
        if self.agrees_with(lowest, rounding) { self } else { Self { least: 0, most: self.most.max(1) } }
    }

    fn agrees_with(self, lowest: f64, rounding: f64) -> bool {
        if self.least > 0 { lowest < -rounding } else { self.most > 0 || lowest > rounding }
    }
}

/// The second variation at one position, analysed.
#[derive(Clone, Debug)]
pub struct SecondVariation {
    pub morse_index: MorseIndex,
    pub lowest: Mode,
    /// The [`Margin`] of a stable state, if it is asked for.
    pub margin: Option<Margin>,
}

/// Second variation of the energy.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "EquilibriumStability"))]
#[non_exhaustive]
pub struct Stability {
    /// Whether the Morse index is 0: a true local minimum of the energy. Null where `morse_index` is.
    pub stable: Option<bool>,
    /// Number of negative eigenvalues of the second variation. Null if rounding does not decide the sign of one.
    pub morse_index: Option<usize>,
    /// Number of eigenvalues that are negative beyond rounding. It is not serialised.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub least_index: usize,
    /// Lowest eigenvalue with respect to the lumped mass, in 1/unit².
    pub lowest_eigenvalue: f64,
}

impl SecondVariation {
    pub fn stability(&self) -> Stability {
        let morse_index = self.morse_index.decided();
        Stability {
            stable: morse_index.map(|index| index == 0),
            morse_index,
            least_index: self.morse_index.least,
            lowest_eigenvalue: self.lowest.eigenvalue,
        }
    }
}

/// How far a stable state is from the edge of stability.
///
/// The second variation K is the difference of a positive semidefinite part D, which resists stretching, and a part
/// that the curvature makes. The margin is the least of xᵀ K x / xᵀ D x over all motions x: 1 for a flat film, 0 at the
/// edge of stability. It has no unit and no scale. A thin neck has the same margin whatever the size of the film around
/// it, whereas the lowest eigenvalue depends on that size. Between two coaxial rings of any radii the margin is about
/// 1.94 √(1 - d), where d is the distance of the rings over the largest distance that a catenoid spans.
#[derive(Clone, Debug)]
pub struct Margin {
    pub value: f64,
    /// The motion x for which the ratio is the least.
    pub motion: Vec<f64>,
}

/// Bound on the inverse iterations of a margin.
const MARGIN_ITERATIONS: usize = 8;
/// Inverse iterations end when the margin changes by less than this fraction of itself.
const MARGIN_TOLERANCE: f64 = 1e-3;

impl Margin {
    /// Computes the margin by inverse iteration from a motion: x becomes K⁻¹ D x. Near the edge of stability the second
    /// lowest ratio is many times the lowest, so that two or three iterations suffice. `solve` applies the inverse of K
    /// in place and returns whether it succeeded. `None` if it fails or the margin is not finite.
    ///
    /// # Errors
    /// The interruption.
    pub fn of(
        matrix: &SymmetricMatrix,
        stretching: &SymmetricMatrix,
        start: Vec<f64>,
        mut solve: impl FnMut(&mut [f64]) -> Result<bool, Interruption>,
    ) -> Result<Option<Self>, Interruption> {
        let mut product = vec![0.0; start.len()];
        let mut ratio = |x: &[f64]| {
            matrix.multiply(x, &mut product);
            let curved = dot(x, &product);
            stretching.multiply(x, &mut product);
            (curved / dot(x, &product), product.clone())
        };
        let mut motion = start;
        let (mut value, mut next) = ratio(&motion);
        for _ in 0..MARGIN_ITERATIONS {
            if !solve(&mut next)? {
                return Ok(None);
            }
            let size = dot(&next, &next).sqrt();
            next.iter_mut().for_each(|height| *height /= size);
            let (lower, product) = ratio(&next);
            motion = std::mem::replace(&mut next, product);
            let change = (value - lower).abs();
            value = lower;
            if change <= MARGIN_TOLERANCE * value.abs() {
                break;
            }
        }
        Ok(value.is_finite().then_some(Self { value, motion }))
    }

    /// Computes the margin from the lowest mode, with the factor of the matrix.
    fn near(
        lowest: &Mode,
        matrix: &SymmetricMatrix,
        stretching: &SymmetricMatrix,
        bordered: &Bordered,
        exec: &Execution,
    ) -> Result<Option<Self>, Interruption> {
        Self::of(matrix, stretching, lowest.vector.clone(), |x| {
            exec.look(x.len() as u64)?;
            bordered.apply(x);
            Ok(true)
        })
    }
}

/// The positive semidefinite part of a second variation: the part that a shift multiplies.
pub fn stretching<E: Equations>(
    vertices: &[DVec3],
    equations: &E,
    state: &State<E::Frame>,
    matrix: &SymmetricMatrix,
) -> SymmetricMatrix {
    let mut part = matrix.clone();
    equations.second_variation(vertices, state, 1.0, &mut part);
    part.values.iter_mut().zip(&matrix.values).for_each(|(part, whole)| *part -= whole);
    part
}

/// Whether the analysis of a stable state includes its margin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WithMargin {
    Yes,
    No,
}

/// A second variation, factorised with its constraints' border. `None` if its inertia is not certain.
///
/// # Errors
/// See [`Unsolved`].
fn certain<'a>(
    symbolic: &'a Symbolic,
    matrix: &'a SymmetricMatrix,
    constraints: &'a [ConstraintState],
    exec: &Execution,
) -> Result<Option<Bordered<'a>>, Unsolved> {
    let bordered = symbolic.factorise(matrix).and_then(|factorisation| Bordered::new(factorisation, constraints));
    match bordered {
        Ok(bordered) => Ok(bordered.is_certain(exec)?.then_some(bordered)),
        Err(LinearError::Singular | LinearError::Inaccurate) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// Bounds on the Morse index of a second variation whose inertia is not certain: the indices of the matrices that are
/// slightly larger and slightly smaller, for the smallest shifts with which these are certain. `unit` is the eigenvalue
/// scale 1/R².
///
/// # Errors
/// See [`Unsolved`].
fn bounds(
    symbolic: &Symbolic,
    matrix: &SymmetricMatrix,
    mass: &[f64],
    unit: f64,
    constraints: &[ConstraintState],
    exec: &Execution,
) -> Result<MorseIndex, Unsolved> {
    let scale: Vec<f64> = matrix.absolute_row_sums().zip(mass).map(|(sum, mass)| sum + unit * mass).collect();
    let mut index = MorseIndex { least: 0, most: mass.len() };
    for sign in [1.0, -1.0] {
        let mut shift = FIRST_COUNT_SHIFT;
        for _ in 0..MAX_COUNT_SHIFTS {
            exec.look(symbolic.order() as u64)?;
            let moved = shifted(matrix, &scale, sign * shift);
            if let Some(bordered) = certain(symbolic, &moved, constraints, exec)? {
                *(if sign > 0.0 { &mut index.least } else { &mut index.most }) = bordered.index();
                break;
            }
            shift *= COUNT_SHIFT_GROWTH;
        }
    }
    Ok(index)
}

/// The Morse index of a second variation: its negative eigenvalues on the constraints' tangent space. `unit` is the
/// eigenvalue scale 1/R².
///
/// # Errors
/// See [`Unsolved`].
pub fn morse_index(
    symbolic: &Symbolic,
    matrix: &SymmetricMatrix,
    mass: &[f64],
    unit: f64,
    constraints: &[ConstraintState],
    exec: &Execution,
) -> Result<MorseIndex, Unsolved> {
    match certain(symbolic, matrix, constraints, exec)? {
        Some(bordered) => Ok(MorseIndex::exactly(bordered.index())),
        None => bounds(symbolic, matrix, mass, unit, constraints, exec),
    }
}

/// Computes the Morse index by inertia and the lowest mode at a position, in the storage of `direct`. `None` for a body
/// that cannot move because it has no unknowns, or because its constraints leave no motion.
///
/// # Errors
/// See [`Unsolved`].
pub fn analyse<E: Equations>(
    vertices: &[DVec3],
    equations: &E,
    state: &State<E::Frame>,
    direct: &mut Direct,
    with_margin: WithMargin,
    exec: &Execution,
) -> Result<Option<SecondVariation>, Unsolved> {
    if state.mass.is_empty() {
        return Ok(None);
    }
    let Direct { symbolic, matrix, .. } = direct;
    equations.second_variation(vertices, state, 0.0, matrix);
    let (mass, constraints) = (&state.mass, &state.constraints);
    let unit = 1.0 / (equations.radius() * equations.radius());
    exec.look(equations.work())?;
    let has_one_sign = E::LOWEST_MODE_HAS_ONE_SIGN && constraints.is_empty();
    let has_lower = |mode: &Mode| {
        let below = mode.eigenvalue - SAME_EIGENVALUE * mode.eigenvalue.abs().max(1e-3 * unit);
        exec.look(symbolic.order() as u64)?;
        let moved = shifted(matrix, mass, -below);
        let bordered = symbolic.factorise(&moved).and_then(|factorisation| Bordered::new(factorisation, constraints));
        Ok::<_, Interruption>(bordered.map_or(true, |bordered| bordered.index() > 0))
    };
    let lowest = |bordered: &Bordered| {
        let multiply = |x: &[f64], product: &mut [f64]| {
            matrix.multiply(x, product);
            add_rank_one_products(constraints, x, product);
        };
        let mut lowest: Option<Mode> = None;
        for start in [Start::Constant, Start::Random] {
            let Some(start) = start.on_tangent_space(bordered, mass) else { continue };
            let mode = lowest_mode(multiply, mass, unit, start, |residual| bordered.apply(residual), exec)?;
            let is_lower = |last: &Mode| mode.eigenvalue < last.eigenvalue;
            if mode.eigenvalue.is_finite() && lowest.as_ref().is_none_or(is_lower) {
                lowest = Some(mode);
            }
            if has_one_sign || matches!(&lowest, Some(mode) if !has_lower(mode)?) {
                break;
            }
        }
        Ok::<_, Interruption>(lowest)
    };
    let checked = |index: MorseIndex, lowest: &Mode| {
        index.checked_against(lowest.eigenvalue, rounding_of_form(matrix, &lowest.vector))
    };
    let morse_index = match certain(symbolic, matrix, constraints, exec)? {
        Some(bordered) if bordered.index() == 0 => {
            let Some(lowest) = lowest(&bordered)? else { return Ok(None) };
            let margin = match with_margin {
                WithMargin::No => None,
                WithMargin::Yes => {
                    let stretching = stretching(vertices, equations, state, matrix);
                    Margin::near(&lowest, matrix, &stretching, &bordered, exec)?
                }
            };
            let morse_index = checked(MorseIndex::exactly(0), &lowest);
            return Ok(Some(SecondVariation { morse_index, lowest, margin }));
        }
        Some(bordered) => MorseIndex::exactly(bordered.index()),
        None => bounds(symbolic, matrix, mass, unit, constraints, exec)?,
    };
    let mut shift = unit;
    for _ in 0..MAX_SHIFTS {
        let raised = shifted(matrix, mass, shift);
        exec.look(equations.work())?;
        match symbolic.factorise(&raised).and_then(|factorisation| Bordered::new(factorisation, constraints)) {
            Ok(bordered) if bordered.index() == 0 => {
                let Some(lowest) = lowest(&bordered)? else { return Ok(None) };
                let morse_index = checked(morse_index, &lowest);
                return Ok(Some(SecondVariation { morse_index, lowest, margin: None }));
            }
            Ok(_) | Err(LinearError::Singular | LinearError::Inaccurate) => shift *= 4.0,
            Err(error) => return Err(error.into()),
        }
    }
    Err(LinearError::Singular.into())
}

/// The start of the iteration for the lowest mode.
#[derive(Clone, Copy, Debug)]
enum Start {
    Constant,
    Random,
}

impl Start {
    /// Returns the start vector projected on the constraints' tangent space; `None` if the constraints leave no motion.
    fn on_tangent_space(self, bordered: &Bordered, mass: &[f64]) -> Option<Vec<f64>> {
        let mut random = SplitMix64::new(1);
        let mut start: Vec<f64> = match self {
            Self::Constant => vec![1.0; mass.len()],
            Self::Random => mass.iter().map(|_| random.between(-1.0, 1.0)).collect(),
        };
        let size = |x: &[f64]| x.iter().zip(mass).map(|(x, mass)| x * x * mass).sum::<f64>().sqrt();
        let whole = size(&start);
        bordered.correct(&mut start, |_| 0.0);
        (size(&start) > NO_MOTION * whole).then_some(start)
    }
}

/// The warnings about a state that is not known to be stable. `unstable` makes the text of the warning about an
/// unstable state from words such as "Morse index 2".
pub fn stability_warnings(
    morse_index: Option<usize>,
    least_index: usize,
    unstable: impl Fn(&str) -> String,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if least_index > 0 {
        let bound = if morse_index.is_some() { "" } else { "at least " };
        let detail = unstable(&format!("Morse index {bound}{least_index}"));
        warnings.push(Warning::new(WarningCode::Unstable, detail).with_count("morse_index", least_index));
    }
    if morse_index.is_none() {
        let detail = "rounding errors are as large as the second variation along a motion of the shape, so that its \
                      Morse index is not known";
        warnings.push(Warning::new(WarningCode::StabilityUndecided, detail));
    }
    warnings
}

/// Rounding error of the quadratic form xᵀ K x.
pub fn rounding_of_form(matrix: &SymmetricMatrix, x: &[f64]) -> f64 {
    FORM_ROUNDING * matrix.absolute_row_sums().zip(x).map(|(sum, x)| sum * x * x).sum::<f64>()
}

/// The matrix plus a multiple of a diagonal.
fn shifted(matrix: &SymmetricMatrix, diagonal: &[f64], shift: f64) -> SymmetricMatrix {
    let mut result = matrix.clone();
    for (row, entry) in diagonal.iter().enumerate() {
        result.values[result.row_start[row] as usize] += shift * entry;
    }
    result
}

/// The lowest eigenvalue of K x = λ M x from a start vector; `multiply` writes the product of K by its first argument
/// to the second, and `precondition` applies an approximate positive definite inverse of K in place. `unit` is the
/// eigenvalue scale 1/R².
///
/// # Errors
/// The interruption.
pub fn lowest_mode(
    multiply: impl Fn(&[f64], &mut [f64]),
    mass: &[f64],
    unit: f64,
    start: Vec<f64>,
    precondition: impl Fn(&mut [f64]),
    exec: &Execution,
) -> Result<Mode, Interruption> {
    let inner = |a: &[f64], b: &[f64]| a.iter().zip(b).zip(mass).map(|((a, b), m)| a * b * m).sum::<f64>();
    let n = mass.len();
    // The basis: the iterate, the preconditioned residual, the last direction; each with its product by K.
    let mut x = Vector { value: start, product: vec![0.0; n] };
    multiply(&x.value, &mut x.product);
    x.scale(1.0 / inner(&x.value, &x.value).sqrt());
    let mut eigenvalue = dot(&x.value, &x.product);
    let mut last: Option<Vector> = None;
    for _ in 0..MAX_ITERATIONS {
        exec.look(n as u64)?;
        let mut residual: Vec<f64> =
            x.product.iter().zip(&x.value).zip(mass).map(|((kx, x), m)| kx - eigenvalue * m * x).collect();
        precondition(&mut residual);
        let mut basis = vec![x];
        let mut w = Vector { value: residual, product: vec![0.0; n] };
        if w.orthonormalise(&basis, inner) {
            multiply(&w.value, &mut w.product);
            basis.push(w);
        }
        if let Some(mut direction) = last.take()
            && direction.orthonormalise(&basis, inner)
        {
            basis.push(direction);
        }
        let size = basis.len();
        let mut small = [[0.0; 3]; 3];
        for i in 0..size {
            for j in 0..size {
                small[i][j] = dot(&basis[i.min(j)].value, &basis[i.max(j)].product);
            }
        }
        let (lowest, weights) = lowest_of_three(small, size);
        let mut next = Vector { value: vec![0.0; n], product: vec![0.0; n] };
        let mut direction = Vector { value: vec![0.0; n], product: vec![0.0; n] };
        for (k, (vector, &weight)) in basis.iter().zip(&weights).enumerate() {
            next.add(weight, vector);
            if k > 0 {
                direction.add(weight, vector);
            }
        }
        x = next;
        x.scale(1.0 / inner(&x.value, &x.value).sqrt());
        last = Some(direction);
        let change = (eigenvalue - lowest).abs();
        eigenvalue = lowest;
        if change.is_nan() || change <= EIGENVALUE_TOLERANCE * eigenvalue.abs().max(1e-3 * unit) {
            break;
        }
    }
    Ok(Mode { eigenvalue, vector: x.value })
}

/// A vector and its product by K, which take part in the same linear combinations.
struct Vector {
    value: Vec<f64>,
    product: Vec<f64>,
}

impl Vector {
    fn scale(&mut self, factor: f64) {
        self.value.iter_mut().chain(&mut self.product).for_each(|value| *value *= factor);
    }

    fn add(&mut self, weight: f64, other: &Self) {
        self.value.iter_mut().zip(&other.value).for_each(|(value, other)| *value += weight * other);
        self.product.iter_mut().zip(&other.product).for_each(|(value, other)| *value += weight * other);
    }

    /// Makes the vector orthogonal to the basis and of length 1 in the inner product, and returns whether it could. Two
    /// passes are enough (Kahan). A vector that lies in the span of the basis, up to rounding errors, is refused.
    fn orthonormalise(&mut self, basis: &[Self], inner: impl Fn(&[f64], &[f64]) -> f64) -> bool {
        for least_left in [f64::MIN_POSITIVE, LEAST_LEFT] {
            for other in basis {
                let weight = -inner(&self.value, &other.value);
                self.add(weight, other);
            }
            let norm = inner(&self.value, &self.value).sqrt();
            if !norm.is_finite() || norm < least_left {
                return false;
            }
            self.scale(1.0 / norm);
        }
        true
    }
}

/// The lowest eigenvalue of the leading `size` rows and columns of a symmetric matrix, and its unit eigenvector, by
/// Jacobi's rotations.
fn lowest_of_three(mut a: [[f64; 3]; 3], size: usize) -> (f64, [f64; 3]) {
    let mut vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _sweep in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if q >= size || a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            for row in &mut a {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            let (row_p, row_q) = (a[p], a[q]);
            a[p] = std::array::from_fn(|k| c * row_p[k] - s * row_q[k]);
            a[q] = std::array::from_fn(|k| s * row_p[k] + c * row_q[k]);
            for row in &mut vectors {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
        }
    }
    let lowest = (0..size).min_by(|&i, &j| a[i][i].total_cmp(&a[j][j])).unwrap_or(0);
    (a[lowest][lowest], vectors.map(|row| row[lowest]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::newton::{Aim, Outcome, Settings, iterate};
    use crate::normal_motion::NormalMotion;
    use plateau_mesh::DVec3;
    use plateau_mesh::film::Film;
    use plateau_mesh::sparse::pattern::Pattern;
    use plateau_mesh::structured::{catenoid, patch};
    use std::f64::consts::PI;

    fn converged(mut film: Film, aim: Aim) -> SecondVariation {
        let settings = Settings { aim, tolerance: 1e-9, max_steps: 20 };
        let pattern = Pattern::new(film.triangles(), &film.fixed);
        let mut direct = Direct::new(pattern.matrix()).unwrap();
        let radius = film.radius();
        let motion = NormalMotion { pattern: &pattern, triangles: film.topology.triangles(), radius };
        let exec = Execution::default();
        let (outcome, state) = iterate(&mut film.vertices, &motion, &mut direct, &settings, &exec, &mut |_, _| {});
        assert_eq!(outcome, Outcome::Converged);
        analyse(&film.vertices, &motion, &state, &mut direct, WithMargin::Yes, &exec).unwrap().unwrap()
    }

    #[test]
    fn the_unit_square_vibrates_at_two_pi_squared() {
        // On a flat film the second variation is the Dirichlet energy: -Δ, with λ = 2 π² on the unit square.
        let lowest = |n| converged(patch(n, n, |u, v| DVec3::new(u, v, 0.0)), Aim::Minimum).lowest.eigenvalue;
        let errors = [8, 16, 32].map(|n| (lowest(n) - 2.0 * PI * PI).abs());
        assert!(errors[2] < 0.05 && errors[1] / errors[2] > 3.5 && errors[0] / errors[1] > 3.5, "{errors:?}");
    }

    #[test]
    fn a_catenoid_sector_beyond_the_critical_one_has_index_one() {
        let sector = 6.0 * PI / 5.0;
        for (reach, index) in [(1.5, 0), (2.0, 1)] {
            let film = patch(52, 52, catenoid(sector, reach));
            let variation = converged(film, Aim::Stationary);
            assert_eq!(variation.morse_index, MorseIndex::exactly(index));
            assert_eq!(variation.lowest.eigenvalue < 0.0, index > 0);
        }
    }

    #[test]
    fn the_critical_sector_of_the_catenoid() {
        // Chen, Cai and Zheng's sector, 6 π / 5, clamped on all four sides: stable for |v| < 1.70676.
        let critical = |n: usize| {
            let (mut stable, mut unstable) = (1.6, 1.8);
            while unstable - stable > 1e-4 {
                let reach = 0.5 * (stable + unstable);
                let film = patch(n, n, catenoid(6.0 * PI / 5.0, reach));
                let pattern = Pattern::new(film.triangles(), &film.fixed);
                let motion = NormalMotion { pattern: &pattern, triangles: film.triangles(), radius: film.radius() };
                let state = motion.state(&film.vertices);
                let Direct { symbolic, mut matrix, .. } = Direct::new(pattern.matrix()).unwrap();
                motion.second_variation(&film.vertices, &state, 0.0, &mut matrix);
                let inertia = symbolic.factorise(&matrix).unwrap().inertia();
                assert!(inertia.negative <= 1);
                if inertia.negative == 0 { stable = reach } else { unstable = reach }
            }
            0.5 * (stable + unstable)
        };
        let (coarse, fine) = (critical(40), critical(80));
        let extrapolated = fine + (fine - coarse) / 3.0;
        assert!((extrapolated - 1.70676).abs() < 5e-4, "{coarse} {fine} {extrapolated}");
        assert!((fine - 1.70676).abs() < 0.3 * (coarse - 1.70676).abs());
    }

    #[test]
    fn an_index_is_decided_if_rounding_cannot_change_it() {
        // A spring of stiffness 1 between two heights, and a spring of stiffness `stiffness` that holds the second one.
        let index = |stiffness: f64| {
            let matrix = SymmetricMatrix {
                row_start: vec![0, 2, 4],
                columns: vec![0, 1, 1, 0],
                values: vec![1.0, -1.0, 1.0 + stiffness, -1.0],
            };
            let symbolic = Symbolic::analyse(&matrix, None).unwrap();
            morse_index(&symbolic, &matrix, &[1e-3, 1e-3], 1.0, &[], &Execution::default()).unwrap()
        };
        for tiny in [0.0, 4e-16, -4e-16] {
            assert_eq!(index(tiny), MorseIndex { least: 0, most: 1 }, "{tiny}");
        }
        for stiffness in [1e-12, 1e-6, 1.0] {
            assert_eq!(index(stiffness), MorseIndex::exactly(0), "{stiffness}");
            assert_eq!(index(-stiffness), MorseIndex::exactly(1), "{stiffness}");
        }
    }

    #[test]
    fn an_index_that_the_lowest_eigenvalue_contradicts_is_undecided() {
        let undecided = MorseIndex { least: 0, most: 1 };
        assert_eq!(MorseIndex::exactly(0).checked_against(1e-9, 1e-12), MorseIndex::exactly(0));
        assert_eq!(MorseIndex::exactly(1).checked_against(-1e-9, 1e-12), MorseIndex::exactly(1));
        assert_eq!(MorseIndex::exactly(0).checked_against(-1e-9, 1e-12), undecided);
        assert_eq!(MorseIndex::exactly(1).checked_against(1e-9, 1e-12), undecided);
        assert_eq!(MorseIndex::exactly(0).checked_against(1e-13, 1e-12), undecided);
        let known_unstable = MorseIndex { least: 1, most: 3 };
        assert_eq!((known_unstable.checked_against(-1e-9, 1e-12), known_unstable.decided()), (known_unstable, None));
    }

    #[test]
    fn the_eigenvalue_of_a_single_vertex_is_its_stiffness_over_its_mass() {
        let mut random = SplitMix64::new(2);
        for _ in 0..100 {
            let mut film = patch(2, 2, |u, v| DVec3::new(u, v, 0.0));
            for vertex in &mut film.vertices {
                *vertex += DVec3::from_array([(); 3].map(|()| random.between(-0.2, 0.2)));
            }
            let pattern = Pattern::new(film.triangles(), &film.fixed);
            let motion = NormalMotion { pattern: &pattern, triangles: film.triangles(), radius: film.radius() };
            let state = motion.state(&film.vertices);
            let mut direct = Direct::new(pattern.matrix()).unwrap();
            let exec = Execution::default();
            let variation = analyse(&film.vertices, &motion, &state, &mut direct, WithMargin::No, &exec);
            let mode = variation.unwrap().unwrap().lowest;
            let expected = direct.matrix.values[0] / state.mass[0];
            let error = (mode.eigenvalue - expected).abs();
            assert!(error <= 1e-12 * expected.abs(), "{} for {expected}", mode.eigenvalue);
            assert!((mode.vector[0] * mode.vector[0] * state.mass[0] - 1.0).abs() < 1e-12, "{mode:?}");
        }
    }

    /// Two heights with the energy (x² + 4 x y + y²) / 2, whose second variation has the eigenvalues 3 (for equal
    /// heights) and -1.
    struct TwoHeights;

    impl Equations for TwoHeights {
        type Frame = ();

        // It is false for this matrix, so that the iteration ends at the eigenvector from which it starts.
        const LOWEST_MODE_HAS_ONE_SIGN: bool = true;

        fn state(&self, _: &[DVec3]) -> State<()> {
            State {
                frame: (),
                energy: 0.0,
                magnitude: 0.0,
                gradient: vec![0.0; 2],
                mass: vec![1.0; 2],
                residual: 0.0,
                constraints: Vec::new(),
            }
        }

        fn second_variation(&self, _: &[DVec3], _: &State<()>, _: f64, matrix: &mut SymmetricMatrix) {
            matrix.values.copy_from_slice(&[1.0, 2.0, 1.0, 2.0]);
        }

        fn matrix(&self) -> SymmetricMatrix {
            SymmetricMatrix { row_start: vec![0, 2, 4], columns: vec![0, 1, 1, 0], values: vec![0.0; 4] }
        }

        fn moved(&self, vertices: &[DVec3], _: &State<()>, _: &[f64], _: f64) -> Vec<DVec3> {
            vertices.to_vec()
        }

        fn triangles(&self) -> &[[u32; 3]] {
            &[]
        }

        fn radius(&self) -> f64 {
            1.0
        }
    }

    #[test]
    fn an_analysis_that_misses_the_lowest_mode_leaves_the_index_undecided() {
        let mut direct = Direct::new(TwoHeights.matrix()).unwrap();
        let (state, exec) = (TwoHeights.state(&[]), Execution::default());
        let variation = analyse(&[], &TwoHeights, &state, &mut direct, WithMargin::No, &exec).unwrap().unwrap();
        assert!((variation.lowest.eigenvalue - 3.0).abs() < 1e-12, "{:?}", variation.lowest);
        assert_eq!(variation.morse_index, MorseIndex { least: 0, most: 1 });
    }

    #[test]
    fn the_lowest_of_three() {
        let (value, vector) = lowest_of_three([[2.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 2.0]], 3);
        assert!((value - (2.0 - 2f64.sqrt())).abs() < 1e-14);
        assert!((vector[1] / vector[0] - 2f64.sqrt()).abs() < 1e-12);
        assert!((lowest_of_three([[2.0, -1.0, 9.0], [-1.0, 2.0, 9.0], [9.0, 9.0, 9.0]], 2).0 - 1.0).abs() < 1e-14);
    }
}
