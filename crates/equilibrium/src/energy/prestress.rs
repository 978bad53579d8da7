//! Energies of films and lines whose stress is given on a reference shape: the updated reference strategy for films,
//! and force densities for lines.
//!
//! Consider a triangle of the reference shape with the area A_ref and the edges a_k, each opposite to corner k. Let S =
//! σ_w w wᵀ + σ_f f fᵀ be its second Piola-Kirchhoff stress (a force per length), where w and f are unit vectors of its
//! plane at right angles to each other. The energy of the triangle is
//!
//! ```text
//! E(x) = ½ A_ref S : FᵀF = ½ Σ_k c_k |e_k|²
//! c_k  = -(σ_w (a_i·f) (a_j·f) + σ_f (a_i·w) (a_j·w)) / (4 A_ref)          i, j the other two corners
//! c_k  = ½ σ cot(angle at corner k)                                        for σ_w = σ_f = σ
//! ```
//!
//! with the deformation gradient F and the edges e_k of the present shape x. It is a quadratic function of the
//! positions. The coefficients follow from E = ½ A_ref Σ_ij (∇λ_i · S ∇λ_j) x_i·x_j with the gradients ∇λ_i = n × a_i /
//! (2 A_ref) of the corners' hat functions.
//!
//! At the reference shape the stress is S. For σ_w = σ_f the value and the gradient at this shape are those of σ times
//! the area. Repeating the solve with each result as the next reference shape finds the film of the required stress.
//! With a fixed reference shape the equilibrium holds at every vertex and in every direction, and the stress is F S Fᵀ
//! / det F.
//!
//! Lines of force density q have the energy ½ q ℓ² (Schek, *The force density method for form finding*, 1974). The
//! updated reference strategy is that of Bletzinger, Ramm, *A general finite element approach to the form finding of
//! tensile structures by the updated reference strategy* (1999). For isotropic stress it is the iteration of Pinkall
//! and Polthier (1993).

use super::Term;
use super::area::Facet;
use glam::DMat3;
use plateau_mesh::DVec3;

/// E = ½ Σ c |e|² over the three edges of every triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Prestress {
    triangles: Vec<[u32; 3]>,
    /// c_k of the three edges of each triangle.
    coefficients: Vec<[f64; 3]>,
    /// Mean of the two principal stresses times the area of each triangle, in the reference shape.
    shares: Vec<f64>,
}

/// The stress of a triangle in its own plane: principal stresses along a unit vector of the plane and across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneStress {
    /// w, a unit vector in the triangle's plane.
    pub direction: DVec3,
    /// σ_w, a force per length.
    pub along: f64,
    /// σ_f, a force per length.
    pub across: f64,
}

impl Prestress {
    /// Triangles with the stress `stress(t)` in triangle t of the reference shape `at`.
    #[must_use]
    pub fn plane(triangles: &[[u32; 3]], stress: impl Fn(usize) -> PlaneStress, at: &[DVec3]) -> Self {
        let (mut coefficients, mut shares) = (Vec::with_capacity(triangles.len()), Vec::with_capacity(triangles.len()));
        for (t, triangle) in triangles.iter().enumerate() {
            let PlaneStress { direction, along, across } = stress(t);
            let facet = Facet::of(at, triangle);
            let other = facet.normal.cross(direction);
            let (own, turned) = (facet.edges.map(|e| e.dot(direction)), facet.edges.map(|e| e.dot(other)));
            let factor = -0.5 / facet.double_area;
            coefficients.push([0, 1, 2].map(|k| {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                factor * (along * turned[i] * turned[j] + across * own[i] * own[j])
            }));
            shares.push(0.25 * (along + across) * facet.double_area);
        }
        Self { triangles: triangles.to_vec(), coefficients, shares }
    }

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

    // The sum over the three edges of a triangle is positive semidefinite, so `1 + shift` multiplies all of the second
    // derivative.
    fn add_second_derivative(&self, _at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        self.edges(|a, b, coefficient| add_blocks(add, [a, b], (1.0 + shift) * coefficient));
    }

    fn visit_springs(&self, _at: &[DVec3], visit: &mut dyn FnMut(u32, u32, f64)) {
        self.edges(visit);
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

/// E = ½ Σ q ℓ²: line elements with given force densities.
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

    fn visit_springs(&self, _at: &[DVec3], visit: &mut dyn FnMut(u32, u32, f64)) {
        self.segments.iter().zip(&self.densities).for_each(|(segment, q)| visit(segment[0], segment[1], q.max(0.0)));
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
    fn the_derivatives_of_a_woven_film_agree_with_finite_differences() {
        let (reference, triangles) = patch();
        let moved: Vec<DVec3> = reference.iter().map(|p| DVec3::new(1.2 * p.x + 0.1 * p.y, p.y, p.z + p.x)).collect();
        check(
            &Prestress::plane(&triangles, |t| in_plane(&reference, triangles[t], 2.0, 0.7), &reference),
            &moved,
            1e-8,
        );
    }

    /// A stress whose principal direction is the projection of a fixed slanted direction onto the triangle.
    fn in_plane(at: &[DVec3], triangle: [u32; 3], along: f64, across: f64) -> PlaneStress {
        let normal = Facet::of(at, &triangle).normal;
        let direction = DVec3::new(0.8, 0.6, 0.1).reject_from_normalized(normal).normalize();
        PlaneStress { direction, along, across }
    }

    #[test]
    fn the_stresses_pull_on_the_edges_of_a_rectangle() {
        // Two triangles make a rectangle 3 x 2, which is turned by an angle in its plane. The warp runs along the long
        // side. The force on a side is the stress at right angles to the side times the side's length.
        let turn = |x: f64, y: f64| DVec3::new(0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, 0.0);
        let at = [turn(0.0, 0.0), turn(3.0, 0.0), turn(3.0, 2.0), turn(0.0, 2.0)];
        let stress = PlaneStress { direction: turn(1.0, 0.0), along: 5.0, across: 0.5 };
        let prestress = Prestress::plane(&[[0, 1, 2], [0, 2, 3]], |_| stress, &at);
        let mut gradient = vec![DVec3::ZERO; 4];
        prestress.add_gradient(&at, &mut gradient);
        assert!((gradient[1] + gradient[2]).distance(turn(5.0 * 2.0, 0.0)) < 1e-12, "{gradient:?}");
        assert!((gradient[2] + gradient[3]).distance(turn(0.0, 0.5 * 3.0)) < 1e-12, "{gradient:?}");
        assert!((prestress.value(&at) - 0.5 * (5.0 + 0.5) * 6.0).abs() < 1e-12, "half the sum of the stresses");
    }

    #[test]
    fn equal_stresses_are_isotropic_whatever_their_direction() {
        let (at, triangles) = patch();
        let plane = Prestress::plane(&triangles, |t| in_plane(&at, triangles[t], 1.7, 1.7), &at);
        let isotropic = Prestress::isotropic(&triangles, |_| 1.7, &at);
        let pairs = plane.coefficients.iter().flatten().zip(isotropic.coefficients.iter().flatten());
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-12));
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
