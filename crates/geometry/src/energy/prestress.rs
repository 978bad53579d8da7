//! A film and lines whose stress is given on a reference shape: the update reference strategy, and force densities.
//!
//! On a triangle with edges a_k of the reference shape, opposite to the corners k, the second Piola-Kirchhoff stress
//! S = σ I (a force per length) has the energy
//!
//! ```text
//! E(x) = ½ A_ref S : FᵀF = ½ Σ_k c_k |e_k|²          c_k = ½ σ cot(angle at corner k)
//! ```
//!
//! with the deformation gradient F and the edges e_k of x: a quadratic function of the positions. At the reference shape
//! its value and its gradient are those of σ times the area. Repeating the solve with the result as the next reference
//! shape finds the film of constant tension; with a fixed reference shape the equilibrium holds at every vertex and in
//! every direction, and the stress is F S Fᵀ / det F.
//!
//! Lines of force density q have the energy ½ q ℓ² (Schek, *The force density method for form finding*, 1974). Source of
//! the strategy: Bletzinger, Ramm, *A general finite element approach to the form finding of tensile structures by the
//! updated reference strategy* (1999); for isotropic stress it is the iteration of Pinkall and Polthier (1993).

use super::Term;
use super::area::Facet;
use crate::DVec3;
use glam::DMat3;

/// E = ½ Σ c |e|² over the edges of each triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Prestress {
    triangles: Vec<[u32; 3]>,
    /// c_k of each triangle.
    coefficients: Vec<[f64; 3]>,
    /// Tension times area of each triangle in the reference shape.
    shares: Vec<f64>,
}

impl Prestress {
    /// Triangles with the tension `tension(t)` in triangle t of the reference shape `at`.
    #[must_use]
    pub fn isotropic(triangles: &[[u32; 3]], tension: impl Fn(usize) -> f64, at: &[DVec3]) -> Self {
        let (mut coefficients, mut shares) = (Vec::with_capacity(triangles.len()), Vec::with_capacity(triangles.len()));
        for (t, triangle) in triangles.iter().enumerate() {
            let facet = Facet::of(at, triangle);
            let factor = -0.5 * tension(t) / facet.double_area;
            coefficients.push([0, 1, 2].map(|k| factor * facet.edges[(k + 1) % 3].dot(facet.edges[(k + 2) % 3])));
            shares.push(0.5 * tension(t) * facet.double_area);
        }
        Self { triangles: triangles.to_vec(), coefficients, shares }
    }

    /// Calls `visit` with the two ends of every edge of every triangle and the edge's coefficient.
    fn edges(&self, mut visit: impl FnMut(u32, u32, f64)) {
        for (triangle, coefficients) in self.triangles.iter().zip(&self.coefficients) {
            for k in 0..3 {
                visit(triangle[(k + 1) % 3], triangle[(k + 2) % 3], coefficients[k]);
            }
        }
    }
}

fn add_edge(gradient: &mut [DVec3], at: &[DVec3], [a, b]: [u32; 2], coefficient: f64) {
    let force = coefficient * (at[b as usize] - at[a as usize]);
    gradient[a as usize] -= force;
    gradient[b as usize] += force;
}

fn add_blocks(add: &mut dyn FnMut(u32, u32, DMat3), [a, b]: [u32; 2], coefficient: f64) {
    let block = DMat3::IDENTITY * coefficient;
    add(a, a, block);
    add(b, b, block);
    add(a, b, -block);
    add(b, a, -block);
}

impl Term for Prestress {
    fn value(&self, at: &[DVec3]) -> f64 {
        let mut sum = 0.0;
        self.edges(|a, b, coefficient| sum += 0.5 * coefficient * at[a as usize].distance_squared(at[b as usize]));
        sum
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        self.edges(|a, b, coefficient| add_edge(gradient, at, [a, b], coefficient));
    }

    // The three edges of a triangle together are semidefinite.
    fn add_second_derivative(&self, _at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        self.edges(|a, b, coefficient| add_blocks(add, [a, b], (1.0 + shift) * coefficient));
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.triangles.iter().for_each(|triangle| visit(triangle));
    }

    fn add_shares(&self, _at: &[DVec3], shares: &mut [f64]) {
        for (triangle, share) in self.triangles.iter().zip(&self.shares) {
            triangle.iter().for_each(|&v| shares[v as usize] += share / 3.0);
        }
    }
}

/// E = ½ Σ q ℓ²: line elements of given force densities.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceDensity {
    /// Pairs of vertices.
    pub segments: Vec<[u32; 2]>,
    /// q of each segment, a force per length.
    pub densities: Vec<f64>,
}

impl Term for ForceDensity {
    fn value(&self, at: &[DVec3]) -> f64 {
        let squared = |&[a, b]: &[u32; 2]| at[a as usize].distance_squared(at[b as usize]);
        self.segments.iter().zip(&self.densities).map(|(segment, q)| 0.5 * q * squared(segment)).sum()
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        self.segments.iter().zip(&self.densities).for_each(|(&segment, &q)| add_edge(gradient, at, segment, q));
    }

    fn add_second_derivative(&self, _at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        for (&segment, &q) in self.segments.iter().zip(&self.densities) {
            add_blocks(add, segment, if q > 0.0 { (1.0 + shift) * q } else { q });
        }
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.segments.iter().for_each(|segment| visit(segment));
    }

    fn add_shares(&self, at: &[DVec3], shares: &mut [f64]) {
        for (&[a, b], q) in self.segments.iter().zip(&self.densities) {
            let half = 0.5 * q.max(0.0) * at[a as usize].distance_squared(at[b as usize]);
            shares[a as usize] += half;
            shares[b as usize] += half;
        }
    }

    fn visit_forces(&self, at: &[DVec3], visit: &mut dyn FnMut(f64)) {
        let length = |&[a, b]: &[u32; 2]| at[a as usize].distance(at[b as usize]);
        self.segments.iter().zip(&self.densities).for_each(|(segment, q)| visit(q * length(segment)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::Area;
    use crate::energy::finite_differences::{check, patch};

    #[test]
    fn the_derivatives_agree_with_finite_differences() {
        let (reference, triangles) = patch();
        let prestress = Prestress::isotropic(&triangles, |t| 1.0 + 0.1 * t as f64, &reference);
        let moved: Vec<DVec3> = reference.iter().map(|p| DVec3::new(1.2 * p.x + 0.1 * p.y, p.y, p.z + p.x)).collect();
        check(&prestress, &moved, 1e-8);
        check(&ForceDensity { segments: vec![[0, 1], [1, 6]], densities: vec![1.5, -0.5] }, &moved, 1e-8);
    }

    #[test]
    fn at_the_reference_shape_it_is_the_area_with_its_gradient() {
        let (at, triangles) = patch();
        let prestress = Prestress::isotropic(&triangles, |_| 1.7, &at);
        let area = Area { triangles, tension: 1.7 };
        assert!((prestress.value(&at) - area.value(&at)).abs() < 1e-12);
        let gradient = |term: &dyn Term| {
            let mut gradient = vec![DVec3::ZERO; at.len()];
            term.add_gradient(&at, &mut gradient);
            gradient
        };
        let pairs = gradient(&prestress).into_iter().zip(gradient(&area));
        assert!(pairs.into_iter().all(|(a, b)| a.distance(b) < 1e-12));
    }
}
