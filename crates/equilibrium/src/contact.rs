//! The energy of a film's edge that slides on a surface and meets it at a given contact angle.
//!
//! ```text
//! E = -τ W          τ = σ cos θ          (Young's relation)
//! ```
//!
//! W is the area of the surface on the left of the edge, as seen from the side to which the surface's normal points. σ
//! is the tension of the film. Let the edge move by δ to its right along the surface, and let θ' be the angle between
//! the film and the part of the surface on the left. Then σ A changes by σ δ cos θ' per length, and τ W by τ δ, so that
//! θ' = θ in equilibrium. Source: Finn, *Equilibrium capillary surfaces* (1986), chapter 1.
//!
//! W is a sum over the segments of the edge, and the support gives the part of each segment in closed form
//! ([`AreaBeside`](super::support::AreaBeside)). If the ends of the edge do not move, this sum is the area up to a
//! constant. The constant is chosen such that W = 0 at the positions at which the term was made.

use super::support::{AreaBeside, AreaPart, Support};
use crate::energy::Term;
use glam::DMat3;
use plateau_mesh::DVec3;
use std::f64::consts::PI;
use std::sync::Arc;

/// The energy E = -τ W of one edge.
#[derive(Clone, Debug)]
pub struct ContactEnergy {
    segments: Vec<[u32; 2]>,
    beside: Arc<dyn AreaBeside>,
    /// τ, a force per length.
    tension: f64,
    /// The sum of the segments' areas at the positions at which the term was made.
    start: f64,
}

impl ContactEnergy {
    /// Makes the energy of an edge of a film of tension `tension` that meets `on` at `angle`, in radians. The edge is
    /// the chain of vertices `chain`; if `closed`, a segment joins its last vertex to its first. The energy is 0 at the
    /// positions `at`. Returns `None` if the support has no closed form of the area beside an edge.
    #[must_use]
    pub fn new(chain: &[u32], closed: bool, on: &dyn Support, tension: f64, angle: f64, at: &[DVec3]) -> Option<Self> {
        let edge: Vec<DVec3> = chain.iter().map(|&v| at[v as usize]).collect();
        let beside = on.area_beside(&edge)?;
        let mut segments: Vec<[u32; 2]> = chain.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        if closed && let (Some(&first), Some(&last)) = (chain.first(), chain.last()) {
            segments.push([last, first]);
        }
        // The sine of 90° - θ is used in place of the cosine of θ because it is exactly 0 at a right angle.
        let tension = tension * libm::sin(0.5 * PI - angle);
        let mut contact = Self { segments, beside, tension, start: 0.0 };
        contact.start = contact.area(at);
        Some(contact)
    }

    /// W: the area on the left of the edge minus the area at the positions at which the term was made.
    #[must_use]
    pub fn area(&self, at: &[DVec3]) -> f64 {
        self.parts(at).map(|(_, part)| part.area).sum::<f64>() - self.start
    }

    fn parts<'a>(&'a self, at: &'a [DVec3]) -> impl Iterator<Item = ([u32; 2], AreaPart)> + 'a {
        self.segments.iter().map(|&[a, b]| ([a, b], self.beside.part(at[a as usize], at[b as usize])))
    }
}

impl Term for ContactEnergy {
    fn value(&self, at: &[DVec3]) -> f64 {
        -self.tension * self.area(at)
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        for ([a, b], part) in self.parts(at) {
            gradient[a as usize] -= part.gradient[0] * self.tension;
            gradient[b as usize] -= part.gradient[1] * self.tension;
        }
    }

    // The second derivative has no semidefinite part, so the shift multiplies nothing.
    fn add_second_derivative(&self, at: &[DVec3], _shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        for ([a, b], part) in self.parts(at) {
            let [own, mixed, other] = part.second.map(|block| block * -self.tension);
            add(a, a, own);
            add(b, b, other);
            add(a, b, mixed);
            add(b, a, mixed.transpose());
        }
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.segments.iter().for_each(|segment| visit(segment));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::finite_differences::check;
    use crate::support::{Circle, Cylinder, Mesh, Plane, Sphere, StraightLine, Torus};
    use std::f64::consts::TAU;

    const AXIS: DVec3 = DVec3::new(0.6, 0.0, 0.8);
    const PLANE: Plane = Plane { point: DVec3::new(0.3, -0.2, 0.1), normal: AXIS };
    const SPHERE: Sphere = Sphere { centre: DVec3::new(-0.1, 0.2, 0.0), radius: 2.0 };
    const CYLINDER: Cylinder = Cylinder { point: DVec3::new(0.2, 0.1, -0.4), axis: AXIS, radius: 1.5 };

    #[test]
    fn the_derivatives_agree_with_finite_differences() {
        let at = |k: usize| {
            let angle = 0.9 * k as f64;
            DVec3::new(1.7 * libm::cos(angle), 1.4 * libm::sin(angle), 0.4 * libm::sin(2.0 * angle))
        };
        let places: Vec<DVec3> = (0..7).map(at).collect();
        for support in [&PLANE as &dyn Support, &SPHERE, &CYLINDER] {
            let on: Vec<DVec3> = places.iter().map(|&p| support.nearest(p)).collect();
            for (closed, chain) in [(true, vec![0, 1, 2, 3, 4, 5, 6]), (false, vec![0, 1, 2, 3])] {
                let contact = ContactEnergy::new(&chain, closed, support, 1.3, 1.0, &on).unwrap();
                assert_eq!(contact.value(&on), 0.0);
                check(&contact, &on, 1e-7);
                // Also off the surface, where the term is smooth too.
                check(&contact, &places, 1e-7);
            }
        }
    }

    #[test]
    fn the_area_is_that_on_the_left_of_the_edge() {
        // Circles around the axis of each support, which run counter-clockwise. Each moves from one height or radius to
        // another.
        let count = 400;
        // The radius of a plane is not used.
        for (support, centre, axis, radius) in [
            (&PLANE as &dyn Support, PLANE.point, PLANE.normal, f64::NAN),
            (&SPHERE, SPHERE.centre, DVec3::Z, SPHERE.radius),
            (&CYLINDER, CYLINDER.point, CYLINDER.axis, CYLINDER.radius),
        ] {
            let (u, v) = axis.any_orthonormal_pair();
            let circle = |r: f64, z: f64| -> Vec<DVec3> {
                let angle = |k: usize| TAU * k as f64 / f64::from(count);
                let at = |k: usize| centre + axis * z + r * (libm::cos(angle(k)) * u + libm::sin(angle(k)) * v);
                (0..count as usize).map(at).collect()
            };
            let (from, to, exact) = if support.is_flat() {
                (circle(1.0, 0.0), circle(1.6, 0.0), PI * (1.6 * 1.6 - 1.0))
            } else if axis == DVec3::Z {
                // The cap above the circle of the polar angle t has the area 2 π r² (1 - cos t).
                let at = |t: f64| circle(radius * libm::sin(t), radius * libm::cos(t));
                (at(0.7), at(1.9), TAU * radius * radius * (libm::cos(0.7f64) - libm::cos(1.9f64)))
            } else {
                // The part of the cylinder above the circle is on its left.
                (circle(radius, 0.4), circle(radius, -0.3), TAU * radius * 0.7)
            };
            let chain: Vec<u32> = (0..count).collect();
            let contact = ContactEnergy::new(&chain, true, support, 1.0, 1.0, &from).unwrap();
            let area = contact.area(&to);
            assert!((area / exact - 1.0).abs() < 1e-3, "{support:?}: {area} {exact}");
        }
    }

    #[test]
    fn a_right_angle_has_no_energy_and_a_support_without_the_form_no_area() {
        let at = [DVec3::X, DVec3::Y, DVec3::ZERO];
        let contact = ContactEnergy::new(&[0, 1, 2], true, &PLANE, 2.0, 0.5 * PI, &at).unwrap();
        assert_eq!(contact.tension, 0.0);
        let line = StraightLine { point: DVec3::ZERO, direction: DVec3::X };
        let circle = Circle { centre: DVec3::ZERO, axis: DVec3::Z, radius: 1.0 };
        let torus = Torus { centre: DVec3::ZERO, axis: DVec3::Z, radius: 1.0, tube_radius: 0.2 };
        let mesh = Mesh::new(&at, &[[0, 1, 2]], 0.5).unwrap();
        for support in [&line as &dyn Support, &circle, &torus, &mesh] {
            assert!(ContactEnergy::new(&[0, 1, 2], true, support, 2.0, 1.0, &at).is_none(), "{support:?}");
        }
    }
}
