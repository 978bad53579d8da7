//! The weight of a film, given per area of the shape in equilibrium.
//!
//! A is the area of a triangle, z the height of its centroid above a datum, w the weight per area, and up the unit
//! vector that points up:
//!
//! ```text
//! E = w Σ A z
//! ∂E/∂x_i       = w (z ∂A/∂x_i + ⅓ A up)
//! ∂²E/∂x_i∂x_j  = w (z ∂²A/∂x_i∂x_j + ⅓ (∂A/∂x_i upᵀ + up (∂A/∂x_j)ᵀ))
//! ```
//!
//! The weight is balanced by a tension that grows with the height, as in a heavy cable: the tension is σ + w z if the
//! film's own tension is σ at the datum. The datum is the mean height of the film; it is renewed between solves. The
//! derivatives of the area are those of [`area`](super::area).

use super::area::{Area, Facet};
use super::{Term, outer};
use glam::DMat3;
use plateau_mesh::DVec3;
use plateau_mesh::measure::double_area_vector;

/// E = w Σ A z over the triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Weight {
    /// Corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// w, a force per area.
    pub weight: f64,
    /// The unit vector that points up.
    pub up: DVec3,
    datum: f64,
}

fn area(triangle: &[u32; 3], at: &[DVec3]) -> f64 {
    0.5 * double_area_vector(triangle.map(|v| at[v as usize])).length()
}

impl Weight {
    /// Makes the weight of `triangles`, with the datum at their mean height at the positions `at`.
    #[must_use]
    pub fn new(triangles: Vec<[u32; 3]>, weight: f64, up: DVec3, at: &[DVec3]) -> Self {
        let mut term = Self { triangles, weight, up, datum: 0.0 };
        term.renew(at);
        term
    }

    /// Returns w z, the tension in a triangle that the weight adds to the film's own tension.
    #[must_use]
    pub fn tension(&self, triangle: &[u32; 3], at: &[DVec3]) -> f64 {
        self.weight * self.rise(triangle, at)
    }

    fn rise(&self, triangle: &[u32; 3], at: &[DVec3]) -> f64 {
        triangle.iter().map(|&v| at[v as usize].dot(self.up)).sum::<f64>() / 3.0 - self.datum
    }
}

impl Term for Weight {
    fn value(&self, at: &[DVec3]) -> f64 {
        self.triangles.iter().map(|triangle| self.tension(triangle, at) * area(triangle, at)).sum()
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        for triangle in &self.triangles {
            super::area::add_gradient(&[*triangle], self.tension(triangle, at), at, gradient);
            let third = self.up * (self.weight * area(triangle, at) / 3.0);
            triangle.iter().for_each(|&v| gradient[v as usize] += third);
        }
    }

    // The shift multiplies nothing, because the factor w z of the area's semidefinite part changes its sign with the
    // height.
    fn add_second_derivative(&self, at: &[DVec3], _shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        for triangle in &self.triangles {
            let single = Area { triangles: vec![*triangle], tension: self.tension(triangle, at) };
            single.add_second_derivative(at, 0.0, add);
            let facet = Facet::of(at, triangle);
            for i in 0..3 {
                for j in 0..3 {
                    let block = outer(facet.gradient(i), self.up) + outer(self.up, facet.gradient(j));
                    add(triangle[i], triangle[j], block * (self.weight / 3.0));
                }
            }
        }
    }

    // No springs where the weight lowers the tension: the springs of the film's own tension are stiff enough there.
    fn visit_springs(&self, at: &[DVec3], visit: &mut dyn FnMut(u32, u32, f64)) {
        let more = |t: usize| self.tension(&self.triangles[t], at).max(0.0);
        super::area::visit_springs(&self.triangles, at, more, visit);
    }

    fn has_unit_directions(&self) -> bool {
        self.up.is_normalized()
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.triangles.iter().for_each(|triangle| visit(triangle));
    }

    fn renew(&mut self, at: &[DVec3]) -> f64 {
        let (mut total, mut moment) = (0.0, 0.0);
        for triangle in &self.triangles {
            let area = area(triangle, at);
            total += area;
            moment += area * triangle.iter().map(|&v| at[v as usize].dot(self.up)).sum::<f64>() / 3.0;
        }
        let before = self.datum;
        self.datum = if total > 0.0 { moment / total } else { 0.0 };
        (self.datum - before).abs() / total.sqrt().max(f64::MIN_POSITIVE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::finite_differences::{check, patch};

    #[test]
    fn the_derivatives_agree_with_finite_differences() {
        let (vertices, triangles) = patch();
        let weight = Weight::new(triangles, 0.8, DVec3::new(0.6, 0.0, 0.8), &vertices);
        check(&weight, &vertices, 1e-8);
    }
}
