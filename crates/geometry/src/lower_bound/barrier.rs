//! The largest circulation of a field with |curl| <= 1 on one mesh, by a barrier method.
//!
//! Let v = C a be the curl of the field a at the four vertices of every tetrahedron, and N the number of these points.
//! Newton's method maximises
//!
//! ```text
//! g·a + μ Σ log(1 - |v|²)
//! ```
//!
//! while μ falls (Boyd, Vandenberghe, *Convex Optimization*, 2004, section 11.3). Every iterate satisfies |v| < 1, so
//! that each gives a bound, g·a / max |v|, and the best is kept. The barrier of a ball has the parameter 1, so on the
//! central path the circulation is at most N μ below the optimum of the mesh, and the multipliers of |v| <= 1 are
//! 2 μ v / (1 - |v|²): the dual surface.
//!
//! Each step factorises a matrix with the pattern of Cᵀ C. About 20 steps suffice whatever the mesh, where the
//! alternating direction method of multipliers had not converged after 200.

use super::bisection::BisectionMesh;
use super::space::Space;
use super::system::{Stop, System};
use crate::{DVec3, Execution};
use glam::DMat3;

/// Part of the way to the boundary |v| = 1 that a step may go at most.
const LARGEST_PART: f64 = 0.9;
/// Factors of μ after a whole step, and after a step of at least half. A smaller factor needs fewer steps, until the steps
/// become short.
const AFTER_WHOLE_STEP: f64 = 0.15;
const AFTER_HALF_STEP: f64 = 0.5;
/// Part of the decrease that Newton's model predicts which a step must reach (Armijo).
const SUFFICIENT: f64 = 1e-4;
/// Halvings of a step at most.
const MOST_HALVINGS: u32 = 30;

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
    /// μ: an area.
    weight: f64,
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
    // |v + t step|² = 1, without cancellation.
    let (a, b, c) = (step.length_squared(), v.dot(step), slack(v));
    if a == 0.0 { f64::INFINITY } else { c / (b + (b * b + a * c).sqrt()).max(f64::MIN_POSITIVE) }
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
        Self { space, form, field, curl, weight, best }
    }

    /// How far the circulation is at most below the optimum of this mesh, if the iterate is on the central path.
    pub fn gap(&self) -> f64 {
        self.weight * (4 * self.curl.len()) as f64
    }

    /// One step of Newton's method. `storage` is the memory of the factor.
    ///
    /// # Errors
    /// The error of the factorisation, or an interruption, which leaves the iterate as it was.
    pub fn step(&mut self, system: &mut System, storage: &mut Vec<f64>, exec: &Execution) -> Result<(), Stop> {
        let Self { space, form, curl, .. } = self;
        let mut gradient: Vec<f64> = form.iter().map(|g| g / self.weight).collect();
        space.transposed_curl(|leaf, p| curl[leaf][p] * (-2.0 / slack(curl[leaf][p])), &mut gradient);
        let block = |leaf: usize, p: usize| {
            let (v, inverse) = (curl[leaf][p], 1.0 / slack(curl[leaf][p]));
            let outer = DMat3::from_cols(v * v.x, v * v.y, v * v.z);
            DMat3::from_diagonal(DVec3::splat(2.0 * inverse)) + outer * (4.0 * inverse * inverse)
        };
        let factor = system.factorise(space, block, storage, exec)?;
        let direction = factor.solve(&gradient);
        *storage = factor.into_storage();
        let predicted = dot(&gradient, &direction);
        let change = space.curl(&direction);
        let points = || self.curl.iter().flatten().zip(change.iter().flatten());
        let bounded = points().map(|(&v, &step)| largest_step(v, step)).fold(f64::INFINITY, f64::min);
        let gain = dot(&self.form, &direction) / self.weight;
        // The increase of the objective over μ along the direction.
        let increase = |step: f64| -> f64 {
            let barrier: f64 = points().map(|(&v, &by)| (slack(v + by * step) / slack(v)).ln()).sum();
            gain * step + barrier
        };
        let mut step = (LARGEST_PART * bounded).min(1.0);
        let mut halvings = 0;
        while !(increase(step) >= SUFFICIENT * step * predicted) {
            halvings += 1;
            if halvings > MOST_HALVINGS || !step.is_finite() {
                // Rounding hides what is left to gain for this μ.
                self.weight *= AFTER_HALF_STEP;
                return Ok(());
            }
            step *= 0.5;
        }
        self.field.iter_mut().zip(&direction).for_each(|(value, by)| *value += by * step);
        self.curl = self.space.curl(&self.field);
        let bound = dot(self.form, &self.field) / largest(&self.curl);
        if bound > self.best.bound {
            self.best = Best { bound, field: self.field.clone() };
        }
        if step >= 1.0 {
            self.weight *= AFTER_WHOLE_STEP;
        } else if step >= 0.5 {
            self.weight *= AFTER_HALF_STEP;
        }
        Ok(())
    }

    /// The dual surface at the vertices of a leaf: areas.
    pub fn current(&self, leaf: usize) -> [DVec3; 4] {
        self.curl[leaf].map(|v| v * (2.0 * self.weight / slack(v)))
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
