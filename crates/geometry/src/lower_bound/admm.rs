//! The largest circulation of a field with |curl| <= 1 on one mesh, by the alternating direction method of multipliers.
//!
//! Maximise g·a subject to C a = z, |z| <= 1 at every vertex of every tetrahedron. The steps for the field a solve one
//! and the same symmetric system, factorised once; the steps for z project onto the unit ball. Every iterate gives a
//! bound, g·a / max |C a|, and the best is kept.

use super::bisection::BisectionMesh;
use super::space::Space;
use super::system::Factor;
use crate::DVec3;
use crate::sparse::LinearError;

/// Over-relaxation (Eckstein and Bertsekas, 1992: any value below 2 converges, 1.5 to 1.8 are the fastest).
const RELAXATION: f64 = 1.6;

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
    /// Weight of |C a - z|² at the vertices of each leaf: an area.
    weight: &'a [f64],
    curl: Vec<[DVec3; 4]>,
    target: Vec<[DVec3; 4]>,
    /// Scaled multipliers of C a = z.
    scaled: Vec<[DVec3; 4]>,
    pub best: Best,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn largest(curl: &[[DVec3; 4]]) -> f64 {
    curl.iter().flatten().fold(0.0, |max: f64, v| max.max(v.length_squared())).sqrt()
}

impl<'a> Level<'a> {
    /// Starts from the field and the multipliers that the mesh carries.
    pub fn new(space: &'a Space, mesh: &BisectionMesh, form: &'a [f64], weight: &'a [f64]) -> Self {
        let field = space.field(mesh);
        let curl = space.curl(&field);
        let scale = largest(&curl);
        let bound = if scale > 0.0 { dot(form, &field) / scale } else { 0.0 };
        let target = curl.iter().map(|at| at.map(|v| v.clamp_length_max(1.0))).collect();
        let scaled =
            (0..curl.len()).map(|leaf| std::array::from_fn(|p| mesh.nodal[leaf].current[p] / weight[leaf])).collect();
        Self { space, form, weight, curl, target, scaled, best: Best { bound, field } }
    }

    /// One iteration with the factorised system of the same weights.
    ///
    /// # Errors
    /// What the factor's solve fails with.
    pub fn step(&mut self, factor: &Factor<'_>) -> Result<(), LinearError> {
        let Self { space, form, weight, target, scaled, .. } = self;
        let mut rhs = form.to_vec();
        space.transposed_curl(|leaf, p| (target[leaf][p] - scaled[leaf][p]) * weight[leaf], &mut rhs);
        let field = factor.solve(&rhs)?;
        self.curl = self.space.curl(&field);
        let points = self.target.iter_mut().flatten().zip(self.scaled.iter_mut().flatten());
        for ((z, u), v) in points.zip(self.curl.iter().flatten()) {
            let relaxed = *v * RELAXATION + *z * (1.0 - RELAXATION);
            *z = (relaxed + *u).clamp_length_max(1.0);
            *u += relaxed - *z;
        }
        let bound = dot(self.form, &field) / largest(&self.curl);
        if bound > self.best.bound {
            self.best = Best { bound, field };
        }
        Ok(())
    }

    /// The current τ v at the vertices of every leaf: areas.
    pub fn current(&self, leaf: usize) -> [DVec3; 4] {
        self.scaled[leaf].map(|u| u * self.weight[leaf])
    }
}
