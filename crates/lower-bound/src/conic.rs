//! An interior-point method for the largest circulation of a field with |curl| <= 1 on one mesh.
//!
//! Let v be the curl of the field a at a vertex of a tetrahedron, which is a linear function of a. All these curls
//! together are v = C a. The problem and its dual are
//!
//! ```text
//! maximise g·a under |v| <= 1,     minimise Σ t under -Cᵀ u = g, |u| <= t
//! ```
//!
//! with a pair (t, u) for each v. The vectors -u are the area vectors of the dual surface, and t are their areas. Both
//! (1, v) and (t, u) lie in the cone of vectors whose first coordinate is not less than the length of the other three.
//! On the central path their Jordan product is (μ, 0). The method follows the central path by Newton steps in the
//! scaling of Nesterov and Todd, with Mehrotra's predictor and corrector (Andersen, Roos, Terlaky, *On implementing a
//! primal-dual interior-point method for conic quadratic optimization*, 2003). Every iterate satisfies |v| < 1, so that
//! each gives a bound, g·a / max |v|. The best bound is kept. Once the dual constraint holds, the circulation is at
//! most Σ (t + u·v) below the optimum of the mesh.
//!
//! If the directions of some loops are free, the field must have no circulation around them. Every solution with the
//! factorised matrix satisfies these linear constraints (`Factor::hold`).
//!
//! Each step factorises one matrix with the pattern of Cᵀ C and solves with it three or four times: for the predictor,
//! the corrector, and corrections of its centrality (Gondzio, *Multiple centrality corrections in a primal-dual method
//! for linear programming*, 1996). Five to ten steps suffice on a mesh of any size if they start near the central path.
//! A finer mesh therefore starts from an early iterate of the coarser mesh, because the last iterate lies at the
//! boundary of the cones. The iterate is interpolated and centred (`recentre`). An alternative, Newton's method on z (1
//! - |v|²) = μ with one multiplier z for each v, needed about twice as many steps.

use super::bisection::{BEST, BisectionMesh, CENTRAL};
use super::space::Space;
use super::system::{Factor, System};
use glam::{DMat3, DVec4};
use plateau_mesh::sparse::{Unsolved, dot};
use plateau_mesh::{DVec3, Execution};

/// Longest step, as a fraction of the step that reaches the boundary of a cone. Usual values are 0.9 to 0.99.
const LARGEST_PART: f64 = 0.98;
/// Largest |v| at the start on the first mesh. A start nearer to 1 needs more steps, because its first steps are short:
/// 0.3 and 0.5 needed the same number, 0.8 needed a fifth more and 0.95 half as many more.
const START: f64 = 0.5;
/// The next mesh starts from the first iterate whose gap is at most this fraction of the film's area. On four films,
/// the numbers of steps with fractions from 0.1 to 0.5 differed by at most two.
const HANDED_ON: f64 = 0.1;
/// Factor by which the field of this iterate ([`HANDED_ON`]) is multiplied, so that no curl starts at the boundary of
/// its cone.
const PULLED_BACK: f64 = 0.95;
/// Largest number of centrality corrections of a direction. Two or three save a quarter to a third of the steps, one
/// saves a tenth.
const CORRECTIONS: u32 = 2;
/// Increase of the step length that a correction aims for.
const LONGER: f64 = 0.3;
/// Range of the eigenvalues of the Jordan products after a corrected step, as multiples of the value on the central
/// path.
const SPREAD: [f64; 2] = [0.1, 10.0];
/// Shortest step that is taken. A shorter step shows that the factor has lost its accuracy.
const SHORTEST_STEP: f64 = 1e-6;
/// Work per leaf of one pass over the leaves, as passed to [`Execution::look`], in the units of the assembly.
const LEAF_WORK: usize = 4;
/// Least target μ of the corrector, as a fraction of the present μ.
const LEAST_CENTERING: f64 = 1e-9;

/// The field that gave the best bound so far.
#[derive(Clone, Debug)]
pub(super) struct Best {
    pub bound: f64,
    pub field: Vec<f64>,
}

/// A vector in the space of the cone: a first coordinate and three others. Inside the cone the first coordinate bounds
/// the length of the others.
#[derive(Clone, Copy, Debug)]
struct ConeVector {
    first: f64,
    rest: DVec3,
}

impl ConeVector {
    fn new(first: f64, rest: DVec3) -> Self {
        Self { first, rest }
    }

    fn dot(self, other: Self) -> f64 {
        self.first * other.first + self.rest.dot(other.rest)
    }

    fn plus(self, other: Self, times: f64) -> Self {
        Self::new(self.first + times * other.first, self.rest + other.rest * times)
    }

    fn scaled(self, by: f64) -> Self {
        Self::new(self.first * by, self.rest * by)
    }

    /// The square of the first coordinate minus the squares of the others, which is positive inside the cone.
    fn norm(self) -> f64 {
        let length = self.rest.length();
        ((self.first - length) * (self.first + length)).max(f64::MIN_POSITIVE)
    }

    /// The Jordan product.
    fn times(self, other: Self) -> Self {
        Self::new(self.dot(other), other.rest * self.first + self.rest * other.first)
    }

    /// The vector whose Jordan product with `self` is `other`.
    fn divide(self, other: Self) -> Self {
        let first = (self.first * other.first - self.rest.dot(other.rest)) / self.norm();
        Self::new(first, (other.rest - self.rest * first) / self.first)
    }

    /// The largest factor t such that `self` + t `step` lies in the cone. Infinite if every positive t does.
    fn largest_step(self, step: Self) -> f64 {
        // The factor is the smallest positive root of a t² + 2 b t + c = 0: the norm vanishes at the boundary of the
        // cone.
        let a = step.first * step.first - step.rest.length_squared();
        let b = self.first * step.first - self.rest.dot(step.rest);
        let c = self.norm();
        let discriminant = b * b - a * c;
        if discriminant < 0.0 {
            return f64::INFINITY;
        }
        let root = discriminant.sqrt();
        // The root has two forms. The form without cancellation is used.
        let far = if b > 0.0 { if a < 0.0 { (b + root) / -a } else { f64::INFINITY } } else { c / (root - b) };
        if far > 0.0 { far } else { f64::INFINITY }
    }
}

/// The Nesterov-Todd scaling of one cone: the symmetric matrix W with W x = W⁻¹ s.
#[derive(Clone, Copy, Debug)]
struct Scaling {
    /// W is this number times the matrix `[w₀, wᵀ; w, I + w wᵀ / (1 + w₀)]` of `vector` = (w₀, w), whose norm is 1.
    factor: f64,
    vector: ConeVector,
    /// W x.
    scaled: ConeVector,
}

impl Scaling {
    fn of(s: ConeVector, x: ConeVector) -> Self {
        let (of_s, of_x) = (s.norm().sqrt(), x.norm().sqrt());
        let (unit_s, unit_x) = (s.scaled(1.0 / of_s), x.scaled(1.0 / of_x));
        let twice = (2.0 * (1.0 + unit_s.dot(unit_x))).sqrt();
        let vector = ConeVector::new(unit_s.first + unit_x.first, unit_s.rest - unit_x.rest).scaled(1.0 / twice);
        let mut scaling = Self { factor: (of_s / of_x).sqrt(), vector, scaled: x };
        scaling.scaled = scaling.apply(x);
        scaling
    }

    /// W x.
    fn apply(&self, x: ConeVector) -> ConeVector {
        let ConeVector { first, rest } = self.vector;
        let along = rest.dot(x.rest);
        ConeVector::new(first * x.first + along, x.rest + rest * (x.first + along / (first + 1.0))).scaled(self.factor)
    }

    /// W⁻¹ s.
    fn unapply(&self, s: ConeVector) -> ConeVector {
        let ConeVector { first, rest } = self.vector;
        let along = rest.dot(s.rest);
        ConeVector::new(first * s.first - along, s.rest + rest * (along / (first + 1.0) - s.first))
            .scaled(1.0 / self.factor)
    }

    /// W⁻² s for a vector whose first coordinate is 0.
    fn unapply_twice(&self, s: DVec3) -> ConeVector {
        let ConeVector { first, rest } = self.vector;
        let along = 2.0 * rest.dot(s);
        ConeVector::new(-first * along, s + rest * along).scaled(1.0 / (self.factor * self.factor))
    }

    /// The change of the dual vector that Newton's method pairs with a change of v, if the target is the boundary of
    /// the cones.
    fn dual_change(&self, dual: ConeVector, change: DVec3) -> ConeVector {
        dual.scaled(-1.0).plus(self.unapply_twice(change), -1.0)
    }
}

/// A direction of Newton's method.
#[derive(Debug)]
struct Direction {
    /// For each dual vector, the part of its change that leads to a target inside the cone. If this part is zero, the
    /// target is the boundary of the cones.
    targets: Vec<[ConeVector; 4]>,
    field: Vec<f64>,
    curl: Vec<[DVec3; 4]>,
    dual: Vec<[ConeVector; 4]>,
    /// The longest steps for which the curls and the dual vectors stay in the cones.
    far: f64,
    far_dual: f64,
}

/// The linearisation of Newton's method at an iterate.
#[derive(Debug)]
struct Linearisation<'a> {
    space: &'a Space,
    form: &'a [f64],
    curl: &'a [[DVec3; 4]],
    dual: &'a [[ConeVector; 4]],
    scalings: &'a [[Scaling; 4]],
    factor: &'a Factor<'a>,
}

impl Linearisation<'_> {
    fn direction(&self, targets: Vec<[ConeVector; 4]>, exec: &Execution) -> Result<Direction, Unsolved> {
        let Self { space, form, curl, dual, scalings, factor } = self;
        exec.look((LEAF_WORK * curl.len()) as u64)?;
        let mut gradient = form.to_vec();
        space.transposed_curl(|leaf, p| targets[leaf][p].rest, &mut gradient);
        exec.look((LEAF_WORK * curl.len()) as u64)?;
        let field = factor.solve(&gradient);
        exec.look((LEAF_WORK * curl.len()) as u64)?;
        let change = space.curl(&field);
        let (mut far, mut far_dual) = (f64::INFINITY, f64::INFINITY);
        let mut dual_changes = Vec::with_capacity(curl.len());
        for leaf in 0..curl.len() {
            let changes: [ConeVector; 4] = std::array::from_fn(|p| {
                far = far.min(ConeVector::new(1.0, curl[leaf][p]).largest_step(ConeVector::new(0.0, change[leaf][p])));
                let by = scalings[leaf][p].dual_change(dual[leaf][p], change[leaf][p]).plus(targets[leaf][p], 1.0);
                far_dual = far_dual.min(dual[leaf][p].largest_step(by));
                by
            });
            dual_changes.push(changes);
        }
        Ok(Direction { targets, field, curl: change, dual: dual_changes, far, far_dual })
    }

    /// Returns targets for a step that is longer than `direction` allows. If that step would move an eigenvalue of a
    /// Jordan product outside [`SPREAD`], the target is the nearer end of that range.
    fn recentred(&self, direction: &Direction, target: f64) -> Vec<[ConeVector; 4]> {
        let [far, far_dual] = [direction.far, direction.far_dual].map(|far| (far + LONGER).min(1.0));
        let [low, high] = SPREAD.map(|times| times * target);
        let correction = |product: f64| (product.clamp(low, high) - product).max(-high);
        let target_of = |leaf: usize, p: usize| {
            let scaling = &self.scalings[leaf][p];
            let s = scaling.unapply(ConeVector::new(1.0, self.curl[leaf][p] + direction.curl[leaf][p] * far));
            let x = scaling.apply(self.dual[leaf][p].plus(direction.dual[leaf][p], far_dual));
            let product = s.times(x);
            // Each eigenvalue of the product is corrected.
            let length = product.rest.length();
            let [most, least] = [length, -length].map(|by| correction(product.first + by));
            let by = ConeVector::new(0.5 * (most + least), product.rest.normalize_or_zero() * (0.5 * (most - least)));
            direction.targets[leaf][p].plus(scaling.unapply(scaling.scaled.divide(by)), 1.0)
        };
        (0..self.curl.len()).map(|leaf| std::array::from_fn(|p| target_of(leaf, p))).collect()
    }
}

/// Chooses the first coordinate t of every dual vector (t, u) so that the product of the norms of (1, v) and (t, u) is
/// the same as on the central path. The dual constraint concerns only u, so that it is not affected.
///
/// Without this, interpolation to a finer mesh leaves some vectors almost at the boundary of their cones. Each of these
/// would keep the first steps short.
fn recentre(curl: &[[DVec3; 4]], dual: &mut [[ConeVector; 4]]) {
    let mean = complementarity(curl, dual) / (4 * curl.len()) as f64;
    for (x, &v) in dual.iter_mut().flatten().zip(curl.iter().flatten()) {
        x.first = (x.rest.length_squared() + mean * mean / ConeVector::new(1.0, v).norm()).sqrt();
    }
}

/// The iteration on one mesh.
#[derive(Debug)]
pub(super) struct Level<'a> {
    space: &'a Space,
    /// The coefficients g of the circulation.
    form: &'a [f64],
    /// Linear forms that vanish on the field: the circulations around free loops.
    held: Vec<Vec<f64>>,
    field: Vec<f64>,
    /// The curls v.
    curl: Vec<[DVec3; 4]>,
    /// The dual vectors (t, u).
    dual: Vec<[ConeVector; 4]>,
    /// Σ (t + u·v).
    complementarity: f64,
    /// The residual of the dual constraint, relative to its value at the start.
    infeasibility: f64,
    film_area: f64,
    /// Whether rounding allows no further step.
    pub stalled: bool,
    pub best: Best,
    /// The iterate (field and dual vectors) from which the next mesh starts. `None` until it is reached
    /// ([`HANDED_ON`]).
    central: Option<(Vec<f64>, Vec<[ConeVector; 4]>)>,
}

fn largest(curl: &[[DVec3; 4]]) -> f64 {
    curl.iter().flatten().fold(0.0, |max: f64, v| max.max(v.length_squared())).sqrt()
}

/// Σ (t + u·v).
fn complementarity(curl: &[[DVec3; 4]], dual: &[[ConeVector; 4]]) -> f64 {
    curl.iter().flatten().zip(dual.iter().flatten()).map(|(&v, x)| x.dot(ConeVector::new(1.0, v))).sum()
}

impl<'a> Level<'a> {
    /// Starts from the best field that the mesh carries. If `warm`, starts from the mesh's central field and its dual
    /// vectors instead. `film_area` is an upper bound of the optimum.
    pub fn new(
        space: &'a Space,
        mesh: &BisectionMesh,
        form: &'a [f64],
        held: Vec<Vec<f64>>,
        film_area: f64,
        warm: bool,
    ) -> Self {
        let mut field = space.field(mesh, BEST);
        let mut curl = space.curl(&field);
        let scale = largest(&curl);
        let bound = if scale > 0.0 { (dot(form, &field) / scale).max(0.0) } else { 0.0 };
        let best = Best { bound, field: field.clone() };
        let (dual, infeasibility): (Vec<[ConeVector; 4]>, f64) = if warm {
            field = space.field(mesh, CENTRAL);
            curl = space.curl(&field);
            let cone_vectors = |&leaf: &u32| mesh.nodal[leaf as usize].dual.map(|x| ConeVector::new(x.w, x.truncate()));
            let mut dual: Vec<_> = space.constrained.iter().map(cone_vectors).collect();
            field.iter_mut().for_each(|value| *value *= PULLED_BACK);
            curl.iter_mut().flatten().for_each(|v| *v *= PULLED_BACK);
            recentre(&curl, &mut dual);
            // An estimate of the dual residual: the distance of the iterate from its optimum, as a fraction of the
            // film's area.
            let infeasibility = complementarity(&curl, &dual) / film_area;
            (dual, infeasibility)
        } else {
            // The start lies on the central path of a problem with another g.
            let factor = if bound > 0.0 { START / scale } else { 0.0 };
            field.iter_mut().for_each(|value| *value *= factor);
            curl.iter_mut().flatten().for_each(|v| *v *= factor);
            let weight = (1.0 - START) * film_area / (4 * curl.len()) as f64;
            let central = |v: DVec3| ConeVector::new(1.0, -v).scaled(weight / ConeVector::new(1.0, v).norm());
            (curl.iter().map(|at| at.map(central)).collect(), 1.0)
        };
        let complementarity = complementarity(&curl, &dual);
        let (stalled, central) = (false, None);
        Self { space, form, held, field, curl, dual, complementarity, infeasibility, film_area, stalled, best, central }
    }

    /// Whether there are free loops, around which the field must have no circulation.
    pub fn has_free_loops(&self) -> bool {
        !self.held.is_empty()
    }

    /// The field and the dual vectors (u, t) from which the next mesh starts.
    pub fn central(&self) -> (Vec<f64>, Vec<[DVec4; 4]>) {
        let (field, dual) = self.central.as_ref().map_or((&self.field, &self.dual), |(field, dual)| (field, dual));
        (field.clone(), dual.iter().map(|at| at.map(|x| x.rest.extend(x.first))).collect())
    }

    /// Upper bound of the distance from the circulation to the optimum of this mesh, once the dual constraint holds.
    /// Before that it is an estimate, to which the remaining fraction of the dual residual times the film's area is
    /// added.
    pub fn gap(&self) -> f64 {
        self.complementarity + self.infeasibility * self.film_area
    }

    /// Makes one Newton step. `storage` is memory that the factorisation reuses.
    ///
    /// # Errors
    /// The error of the factorisation, or an interruption. The iterate is then unchanged.
    pub fn step(&mut self, system: &mut System, storage: &mut Vec<f64>, exec: &Execution) -> Result<(), Unsolved> {
        let Self { space, form, curl, dual, .. } = &*self;
        exec.look((LEAF_WORK * curl.len()) as u64)?;
        let scalings_of = |(v, x): (&[DVec3; 4], &[ConeVector; 4])| -> [Scaling; 4] {
            std::array::from_fn(|p| Scaling::of(ConeVector::new(1.0, v[p]), x[p]))
        };
        let scalings: Vec<[Scaling; 4]> = curl.iter().zip(dual).map(scalings_of).collect();
        let scaling = |leaf: usize, p: usize| scalings[leaf][p];
        let block = |leaf: usize, p: usize| {
            let Scaling { factor, vector: ConeVector { rest, .. }, .. } = scaling(leaf, p);
            let all = 1.0 / (factor * factor);
            let w = rest * (2.0 * all);
            DMat3::from_diagonal(DVec3::splat(all)) + DMat3::from_cols(w * rest.x, w * rest.y, w * rest.z)
        };
        let mut factor = system.factorise(space, block, storage, exec)?;
        factor.hold(&self.held, exec)?;
        exec.look((LEAF_WORK * curl.len()) as u64)?;
        let points = (4 * curl.len()) as f64;
        // The target of the predictor is the boundary of the cones.
        let predictor = space.curl(&factor.solve(form));
        let (mut far, mut far_dual) = (1.0_f64, 1.0_f64);
        let dual_change = |leaf: usize, p: usize| scaling(leaf, p).dual_change(dual[leaf][p], predictor[leaf][p]);
        for leaf in 0..curl.len() {
            for p in 0..4 {
                far =
                    far.min(ConeVector::new(1.0, curl[leaf][p]).largest_step(ConeVector::new(0.0, predictor[leaf][p])));
                far_dual = far_dual.min(dual[leaf][p].largest_step(dual_change(leaf, p)));
            }
        }
        let mut predicted = 0.0;
        for leaf in 0..curl.len() {
            for p in 0..4 {
                let x = dual[leaf][p].plus(dual_change(leaf, p), far_dual);
                predicted += x.dot(ConeVector::new(1.0, curl[leaf][p] + predictor[leaf][p] * far));
            }
        }
        let mean = self.complementarity / points;
        let target = mean * (predicted / self.complementarity).clamp(0.0, 1.0).powi(3).max(LEAST_CENTERING);
        // The corrector takes the product of the predictor's changes into account.
        let target_of = |leaf: usize, p: usize| {
            let scaling = scaling(leaf, p);
            let change = scaling.apply(scaling.dual_change(dual[leaf][p], predictor[leaf][p]));
            let product = scaling.unapply(ConeVector::new(0.0, predictor[leaf][p])).times(change);
            scaling.unapply(scaling.scaled.divide(ConeVector::new(target, DVec3::ZERO).plus(product, -1.0)))
        };
        exec.look((LEAF_WORK * curl.len()) as u64)?;
        let targets: Vec<[ConeVector; 4]> =
            (0..curl.len()).map(|leaf| std::array::from_fn(|p| target_of(leaf, p))).collect();
        let newton = Linearisation { space, form, curl, dual, scalings: &scalings, factor: &factor };
        let mut best = newton.direction(targets, exec)?;
        let length = |direction: &Direction| direction.far.min(1.0) + direction.far_dual.min(1.0);
        for _ in 0..CORRECTIONS {
            exec.look((LEAF_WORK * curl.len()) as u64)?;
            let corrected = newton.direction(newton.recentred(&best, target), exec)?;
            if length(&corrected) <= length(&best) {
                break;
            }
            best = corrected;
        }
        *storage = factor.into_storage();
        self.advance(&best);
        Ok(())
    }

    /// Moves along a direction, and keeps the field if its bound is the best so far.
    fn advance(&mut self, direction: &Direction) {
        let Direction { field: direction, dual: dual_changes, far, far_dual, .. } = direction;
        let step = (LARGEST_PART * far).min(1.0);
        let dual_step = (LARGEST_PART * far_dual).min(1.0);
        if !(step > SHORTEST_STEP && dual_step > SHORTEST_STEP && direction.iter().all(|value| value.is_finite())) {
            self.stalled = true;
            return;
        }
        self.field.iter_mut().zip(direction).for_each(|(value, by)| *value += by * step);
        self.curl = self.space.curl(&self.field);
        let bound = dot(self.form, &self.field) / largest(&self.curl);
        if bound > self.best.bound {
            self.best = Best { bound, field: self.field.clone() };
        }
        for (dual, by) in self.dual.iter_mut().flatten().zip(dual_changes.iter().flatten()) {
            *dual = dual.plus(*by, dual_step);
        }
        self.complementarity = complementarity(&self.curl, &self.dual);
        self.infeasibility *= 1.0 - dual_step;
        if self.central.is_none() && self.gap() <= HANDED_ON * self.film_area {
            self.central = Some((self.field.clone(), self.dual.clone()));
        }
    }

    /// The area vectors of the dual surface at the vertices of a leaf.
    pub fn current(&self, leaf: usize) -> [DVec3; 4] {
        self.dual[leaf].map(|dual| -dual.rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_step_ends_on_the_sphere() {
        for (v, by) in [
            (DVec3::new(0.3, -0.2, 0.5), DVec3::new(2.0, 1.0, -0.4)),
            (DVec3::new(0.999_999, 0.0, 0.0), DVec3::new(-1.0, 1e-3, 0.0)),
            (DVec3::ZERO, DVec3::new(0.0, 1e-9, 0.0)),
        ] {
            let step = ConeVector::new(1.0, v).largest_step(ConeVector::new(0.0, by));
            assert!(step > 0.0 && ((v + by * step).length() - 1.0).abs() < 1e-12, "{step}");
        }
        let inside = ConeVector::new(1.0, DVec3::new(0.1, 0.2, 0.3));
        assert_eq!(inside.largest_step(ConeVector::new(0.0, DVec3::ZERO)), f64::INFINITY);
        // First along the axis of the cone, then towards its tip.
        assert_eq!(inside.largest_step(ConeVector::new(1.0, DVec3::ZERO)), f64::INFINITY);
        assert!((inside.largest_step(inside.scaled(-1.0)) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_scaling_maps_both_vectors_to_the_same_one() {
        let (s, x) =
            (ConeVector::new(1.0, DVec3::new(0.6, -0.5, 0.59)), ConeVector::new(3e-4, DVec3::new(1e-4, 2e-4, -1.5e-4)));
        let scaling = Scaling::of(s, x);
        let same = |a: ConeVector, b: ConeVector, size: f64| {
            (a.first - b.first).abs() + a.rest.distance(b.rest) < 1e-12 * size
        };
        assert!(same(scaling.unapply(s), scaling.scaled, 1.0));
        assert!(same(scaling.unapply(scaling.apply(x)), x, 1.0));
        let change = DVec3::new(0.2, 0.1, -0.7);
        let twice = scaling.unapply(scaling.unapply(ConeVector::new(0.0, change)));
        assert!(same(scaling.unapply_twice(change), twice, 1.0));
        // The Jordan product of the quotient and the divisor is the dividend.
        assert!(same(scaling.scaled.times(scaling.scaled.divide(s)), s, 1.0));
    }

    #[test]
    fn centring_leaves_the_dual_surface_and_gives_every_pair_the_same_product_of_norms() {
        let v = |k: f64| DVec3::new(0.9 * libm::cos(k), 0.9 * libm::sin(k), 0.43);
        let curl = [[v(0.0), v(1.0), v(2.0), DVec3::ZERO]];
        // The first vector is at the boundary of its cone, and the last one is far inside.
        let at_the_boundary = ConeVector::new(0.5, DVec3::new(0.3, 0.4, 0.0));
        let inside = ConeVector::new(2.0, DVec3::new(0.0, 0.1, 0.0));
        let mut dual = [[at_the_boundary, inside, at_the_boundary, inside]];
        let surface = dual[0].map(|x| x.rest);
        let mean = complementarity(&curl, &dual) / 4.0;
        recentre(&curl, &mut dual);
        assert_eq!(dual[0].map(|x| x.rest), surface);
        for (x, v) in dual[0].into_iter().zip(curl[0]) {
            assert!((x.norm() * ConeVector::new(1.0, v).norm() / (mean * mean) - 1.0).abs() < 1e-12);
        }
    }
}
