//! The largest circulation of a field with |curl| <= 1 on one mesh, by a barrier method.
//!
//! Let v = C a be the curl of the field a at the four vertices of every tetrahedron, and N the number of these points.
//! With a multiplier z >= 0 of each constraint 1 - |v|² >= 0, Newton's method is applied to
//!
//! ```text
//! g = Σ 2 z Cᵀ v,    z (1 - |v|²) = μ
//! ```
//!
//! while μ falls: a primal-dual interior-point method (Boyd, Vandenberghe, *Convex Optimization*, 2004, section 11.7).
//! Every iterate satisfies |v| < 1, so that each gives a bound, g·a / max |v|, and the best is kept. Near the central path
//! the circulation is at most Σ z (1 - |v|²) below the optimum of the mesh. The vectors 2 z v are the dual surface.
//!
//! The steps depart from the book in two ways: the field and the multipliers take steps of different lengths, and a step
//! is not shortened further than |v| < 1 and z > 0 demand, because no iterate can do harm.
//!
//! Each step factorises a matrix with the pattern of Cᵀ C. About 15 steps suffice whatever the mesh, where the
//! alternating direction method of multipliers had not converged after 200.

use super::bisection::BisectionMesh;
use super::space::Space;
use super::system::{Stop, System};
use crate::{DVec3, Execution};
use glam::DMat3;

/// Part of the way to the boundary |v| = 1, or z = 0, that a step may go at most.
const LARGEST_PART: f64 = 0.95;
/// The next μ as a fraction of the mean of z (1 - |v|²), and the length that the shorter of the last two steps must have
/// had. Smaller fractions need fewer steps, until the steps become short.
const TARGETS: [(f64, f64); 3] = [(0.8, 0.08), (0.4, 0.25), (0.0, 0.6)];
/// A multiplier stays within this factor of μ / (1 - |v|²).
const FARTHEST: f64 = 1e4;

/// The field that gave the best bound so far.
#[derive(Clone, Debug)]
pub(super) struct Best {
    pub bound: f64,
    pub field: Vec<f64>,
}

/// The iteration on one mesh.
#[derive(Debug)]
pub(super) struct Level<'a> {
    space: &'a Space,
    /// g.
    form: &'a [f64],
    field: Vec<f64>,
    /// v.
    curl: Vec<[DVec3; 4]>,
    /// z.
    multiplier: Vec<[f64; 4]>,
    /// μ: an area.
    target: f64,
    /// Σ z (1 - |v|²).
    complementarity: f64,
    /// Whether rounding allows no further step.
    pub stalled: bool,
    pub best: Best,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn largest(curl: &[[DVec3; 4]]) -> f64 {
    curl.iter().flatten().fold(0.0, |max: f64, v| max.max(v.length_squared())).sqrt()
}

/// The distance of a curl from the boundary, 1 - |v|².
fn slack(v: DVec3) -> f64 {
    1.0 - v.length_squared()
}

/// The largest step along `step` that keeps |v| below 1; infinite if none leaves the ball.
fn largest_step(v: DVec3, step: DVec3) -> f64 {
    // The positive root of a t² + 2 b t - c = 0, which says |v + t step| = 1. Of its two forms the one that does not
    // cancel is used.
    let (a, b, c) = (step.length_squared(), v.dot(step), slack(v));
    let root = (b * b + a * c).sqrt();
    if a == 0.0 {
        f64::INFINITY
    } else if b > 0.0 {
        c / (b + root)
    } else {
        (root - b) / a
    }
}

impl<'a> Level<'a> {
    /// Starts from the field that the mesh carries. `film_area` is an upper bound of the optimum.
    pub fn new(space: &'a Space, mesh: &BisectionMesh, form: &'a [f64], film_area: f64) -> Self {
        let mut field = space.field(mesh);
        let curl = space.curl(&field);
        let scale = largest(&curl);
        let bound = if scale > 0.0 { (dot(form, &field) / scale).max(0.0) } else { 0.0 };
        let best = Best { bound, field: field.clone() };
        // The start lies about as far inside as the central path with N μ = the gap does.
        let gap = (1.0 - bound / film_area).clamp(1e-6, 1.0);
        let factor = if bound > 0.0 { (1.0 - 0.5 * gap.min(0.9)) / scale } else { 0.0 };
        field.iter_mut().for_each(|value| *value *= factor);
        let curl = curl.iter().map(|at| at.map(|v| v * factor)).collect::<Vec<_>>();
        let weight = gap * film_area / (4 * curl.len()) as f64;
        let multiplier = curl.iter().map(|at| at.map(|v| weight / slack(v))).collect();
        let complementarity = weight * (4 * curl.len()) as f64;
        Self { space, form, field, curl, multiplier, target: weight, complementarity, stalled: false, best }
    }

    /// How far the circulation is at most below the optimum of this mesh, if the iterate is near the central path.
    pub fn gap(&self) -> f64 {
        self.complementarity
    }

    /// One step of Newton's method. `storage` is the memory of the factor.
    ///
    /// # Errors
    /// The error of the factorisation, or an interruption, which leaves the iterate as it was.
    pub fn step(&mut self, system: &mut System, storage: &mut Vec<f64>, exec: &Execution) -> Result<(), Stop> {
        let Self { space, form, curl, multiplier, target, .. } = &*self;
        let mut gradient = form.to_vec();
        let pull = |leaf: usize, p: usize| curl[leaf][p] * (-2.0 * target / slack(curl[leaf][p]));
        space.transposed_curl(pull, &mut gradient);
        let block = |leaf: usize, p: usize| {
            let (v, z) = (curl[leaf][p], multiplier[leaf][p]);
            let outer = DMat3::from_cols(v * v.x, v * v.y, v * v.z);
            DMat3::from_diagonal(DVec3::splat(2.0 * z)) + outer * (4.0 * z / slack(v))
        };
        let factor = system.factorise(space, block, storage, exec)?;
        let direction = factor.solve(&gradient);
        *storage = factor.into_storage();
        let change = space.curl(&direction);
        // How far the curl and the multipliers may go.
        let (mut far, mut far_multiplier) = (f64::INFINITY, f64::INFINITY);
        let mut multiplier_change = Vec::with_capacity(curl.len());
        for ((curl, change), multiplier) in curl.iter().zip(&change).zip(multiplier) {
            let by: [f64; 4] = std::array::from_fn(|p| {
                let (v, z) = (curl[p], multiplier[p]);
                far = far.min(largest_step(v, change[p]));
                let by = (target + 2.0 * z * v.dot(change[p])) / slack(v) - z;
                if by < 0.0 {
                    far_multiplier = far_multiplier.min(-z / by);
                }
                by
            });
            multiplier_change.push(by);
        }
        let step = (LARGEST_PART * far).min(1.0);
        let multiplier_step = (LARGEST_PART * far_multiplier).min(1.0);
        // A factor without accuracy gives no direction.
        if !(step > 0.0 && multiplier_step > 0.0 && direction.iter().all(|value| value.is_finite())) {
            self.stalled = true;
            return Ok(());
        }
        self.field.iter_mut().zip(&direction).for_each(|(value, by)| *value += by * step);
        self.curl = self.space.curl(&self.field);
        let bound = dot(self.form, &self.field) / largest(&self.curl);
        if bound > self.best.bound {
            self.best = Best { bound, field: self.field.clone() };
        }
        let mut sum = 0.0;
        for ((multiplier, by), curl) in self.multiplier.iter_mut().zip(&multiplier_change).zip(&self.curl) {
            for p in 0..4 {
                let slack = slack(curl[p]).max(f64::MIN_POSITIVE);
                let central = self.target / slack;
                multiplier[p] = (multiplier[p] + multiplier_step * by[p]).clamp(central / FARTHEST, central * FARTHEST);
                sum += multiplier[p] * slack;
            }
        }
        self.complementarity = sum;
        let mean = sum / (4 * self.curl.len()) as f64;
        let worse = step.min(multiplier_step);
        let fraction = TARGETS.iter().find(|(length, _)| worse > *length).map_or(1.0, |(_, fraction)| *fraction);
        self.target = fraction * mean;
        Ok(())
    }

    /// The dual surface at the vertices of a leaf: areas.
    pub fn current(&self, leaf: usize) -> [DVec3; 4] {
        std::array::from_fn(|p| self.curl[leaf][p] * (2.0 * self.multiplier[leaf][p]))
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
            let step = largest_step(v, by);
            assert!(step > 0.0 && ((v + by * step).length() - 1.0).abs() < 1e-12, "{step}");
        }
        assert_eq!(largest_step(DVec3::new(0.1, 0.2, 0.3), DVec3::ZERO), f64::INFINITY);
    }
}
