//! The energy of an edge that meets the surface on which it slides at a given angle.
//!
//! ```text
//! E = -τ W          τ = σ cos θ          (Young's relation)
//! ```
//!
//! W is the area of the surface on the left of the edge, as seen from the side to which the surface's normal points,
//! and σ the film's tension. Where the edge moves by δ across itself along the surface, σ A changes by σ δ cos θ' per
//! length with the angle θ' between the film and the surface on the left, so that θ' = θ in equilibrium. Source: Finn,
//! *Equilibrium capillary surfaces* (1986), chapter 1.
//!
//! W is a sum over the segments from a to b of the edge:
//!
//! ```text
//! plane      n · ((a - p) × (b - p)) / 2
//! sphere     r² Ω,  tan(Ω / 2) = q · (u × v) / (1 + q · u + u · v + v · q)         u, v = (a, b - centre) / |·|
//! cylinder   -r (φ_b - φ_a) (z_a + z_b) / 2                                        φ around the axis, z along it
//! ```
//!
//! with the solid angle Ω of the triangle over the segment and a pole q (Van Oosterom, Strackee 1983). A segment is a
//! straight line of the plane, a great circle of the sphere, a helix of the cylinder. For ends that do not move W is
//! the area up to a constant, which is such that W = 0 at the positions at which the term was made.

use super::freedom::Support;
use crate::energy::volume::cross_matrix;
use crate::energy::{Term, outer};
use glam::DMat3;
use plateau_mesh::DVec3;
use std::f64::consts::PI;

/// The surfaces with a closed form of the area.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Surface {
    Plane { point: DVec3, normal: DVec3 },
    Sphere { centre: DVec3, radius: f64, pole: DVec3 },
    Cylinder { point: DVec3, axis: DVec3, radius: f64 },
}

/// E = -τ W of one edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    segments: Vec<[u32; 2]>,
    surface: Surface,
    /// τ, a force per length.
    tension: f64,
    /// The sum over the segments at the positions at which the term was made.
    start: f64,
}

/// The area of one segment and its derivatives by the two ends.
struct Share {
    area: f64,
    gradient: [DVec3; 2],
    /// By a twice, by a and b, by b twice.
    second: [DMat3; 3],
}

/// Converts derivatives by the unit vectors u = x / |x| and v = y / |y| to derivatives by x and y.
fn by_places(x: DVec3, y: DVec3, area: f64, gradient: [DVec3; 2], second: [DMat3; 3]) -> Share {
    let project = |x: DVec3| {
        let unit = x.normalize();
        (unit, (DMat3::IDENTITY - outer(unit, unit)) * (1.0 / x.length()))
    };
    let ((u, to_u), (v, to_v)) = (project(x), project(y));
    // ∂²(g · u)/∂x² = -(t uᵀ + u tᵀ + (g · u) (1 - u uᵀ)) / |x|²,  t = g - u (g · u).
    let bend = |gradient: DVec3, unit: DVec3, x: DVec3| {
        let along = gradient.dot(unit);
        let across = gradient - unit * along;
        let flat = DMat3::IDENTITY - outer(unit, unit);
        (outer(across, unit) + outer(unit, across) + flat * along) * (-1.0 / x.length_squared())
    };
    Share {
        area,
        gradient: [to_u * gradient[0], to_v * gradient[1]],
        second: [
            to_u * second[0] * to_u + bend(gradient[0], u, x),
            to_u * second[1] * to_v,
            to_v * second[2] * to_v + bend(gradient[1], v, y),
        ],
    }
}

impl Surface {
    fn share(&self, a: DVec3, b: DVec3) -> Share {
        match *self {
            Self::Plane { point, normal } => {
                let (a, b) = (a - point, b - point);
                Share {
                    area: 0.5 * normal.dot(a.cross(b)),
                    gradient: [0.5 * b.cross(normal), 0.5 * normal.cross(a)],
                    // ∂/∂b (b × n) / 2 = -[n]× / 2.
                    second: [DMat3::ZERO, cross_matrix(normal) * -0.5, DMat3::ZERO],
                }
            }
            Self::Sphere { centre, radius, pole: q } => {
                let (x, y) = (a - centre, b - centre);
                let (u, v) = (x.normalize(), y.normalize());
                // Ω = 2 atan2(N, D).
                let (n, d) = (q.dot(u.cross(v)), 1.0 + q.dot(u) + u.dot(v) + v.dot(q));
                let (n_u, n_v) = (v.cross(q), q.cross(u));
                let (d_u, d_v) = (q + v, q + u);
                let squared = n * n + d * d;
                let (by_n, by_d) = (d / squared, -n / squared);
                let (by_nn, by_nd) = (-2.0 * n * d / (squared * squared), (n * n - d * d) / (squared * squared));
                let scale = 2.0 * radius * radius;
                let second = |n_1: DVec3, d_1: DVec3, n_2: DVec3, d_2: DVec3| {
                    (outer(n_1, n_2) - outer(d_1, d_2)) * by_nn + (outer(n_1, d_2) + outer(d_1, n_2)) * by_nd
                };
                // ∂/∂v (v × q) = -[q]×, and ∂/∂v (q + v) = 1.
                let mixed = second(n_u, d_u, n_v, d_v) - cross_matrix(q) * by_n + DMat3::IDENTITY * by_d;
                by_places(
                    x,
                    y,
                    scale * libm::atan2(n, d),
                    [(n_u * by_n + d_u * by_d) * scale, (n_v * by_n + d_v * by_d) * scale],
                    [second(n_u, d_u, n_u, d_u) * scale, mixed * scale, second(n_v, d_v, n_v, d_v) * scale],
                )
            }
            Self::Cylinder { point, axis, radius } => {
                // The angle and the height of a place with the derivatives of the angle.
                let angle = |x: DVec3| {
                    let across = (x - point).reject_from_normalized(axis);
                    let (squared, around) = (across.length_squared(), axis.cross(across));
                    let by_place = around / squared;
                    let bend = (outer(across, around) + outer(around, across)) * (-1.0 / (squared * squared));
                    (across, axis.dot(x - point), by_place, bend)
                };
                let ((from, z_a, turn_a, bend_a), (to, z_b, turn_b, bend_b)) = (angle(a), angle(b));
                let turned = libm::atan2(axis.dot(from.cross(to)), from.dot(to));
                let (half, sum) = (-0.5 * radius, z_a + z_b);
                Share {
                    area: half * turned * sum,
                    gradient: [(axis * turned - turn_a * sum) * half, (axis * turned + turn_b * sum) * half],
                    second: [
                        (bend_a * -sum - outer(turn_a, axis) - outer(axis, turn_a)) * half,
                        (outer(axis, turn_b) - outer(turn_a, axis)) * half,
                        (bend_b * sum + outer(turn_b, axis) + outer(axis, turn_b)) * half,
                    ],
                }
            }
        }
    }
}

impl Contact {
    /// The energy of an edge of a film of a tension σ that meets a support at the angle θ, in radians. The edge is a
    /// chain of vertices, closed if the first follows the last; `at` are the positions at which its energy is 0. `None`
    /// for a support that is no plane, sphere or cylinder.
    #[must_use]
    pub fn new(chain: &[u32], closed: bool, on: &Support, tension: f64, angle: f64, at: &[DVec3]) -> Option<Self> {
        let place = |v: u32| at[v as usize];
        let surface = match *on {
            Support::Plane { point, normal } => Surface::Plane { point, normal },
            Support::Cylinder { point, axis, radius } => Surface::Cylinder { point, axis, radius },
            Support::Sphere { centre, radius } => {
                let units = || chain.iter().map(|&v| (place(v) - centre).normalize_or_zero());
                let pole = pole(units().collect::<Vec<_>>().as_slice());
                Surface::Sphere { centre, radius, pole }
            }
            Support::Line { .. } | Support::Circle { .. } | Support::Mesh { .. } => return None,
        };
        let mut segments: Vec<[u32; 2]> = chain.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        if closed && let (Some(&first), Some(&last)) = (chain.first(), chain.last()) {
            segments.push([last, first]);
        }
        // The cosine of a right angle is exactly 0.
        let tension = tension * libm::sin(0.5 * PI - angle);
        let mut contact = Self { segments, surface, tension, start: 0.0 };
        contact.start = contact.area(at);
        Some(contact)
    }

    /// The area on the left of the edge less that at the start.
    #[must_use]
    pub fn area(&self, at: &[DVec3]) -> f64 {
        self.shares(at).map(|(_, share)| share.area).sum::<f64>() - self.start
    }

    fn shares<'a>(&'a self, at: &'a [DVec3]) -> impl Iterator<Item = ([u32; 2], Share)> + 'a {
        self.segments.iter().map(|&[a, b]| ([a, b], self.surface.share(at[a as usize], at[b as usize])))
    }
}

/// Chooses the pole for the solid angles of a chain of unit vectors. The solid angle jumps where the chain passes the
/// opposite of the pole. Of a few directions the pole is therefore the one whose opposite is furthest from the chain.
fn pole(units: &[DVec3]) -> DVec3 {
    let mean: DVec3 = units.iter().sum();
    let around: DVec3 = (0..units.len()).map(|k| units[k].cross(units[(k + 1) % units.len()])).sum();
    let nearest = |pole: DVec3| units.iter().map(|unit| unit.dot(pole)).fold(1.0, f64::min);
    let candidates = [mean, around, -around].map(|direction| direction.normalize_or(DVec3::Z));
    let all = candidates.into_iter().chain(DVec3::AXES).chain(DVec3::AXES.map(|axis| -axis));
    all.reduce(|best, pole| if nearest(pole) > nearest(best) + 0.1 { pole } else { best }).unwrap_or(DVec3::Z)
}

impl Term for Contact {
    fn value(&self, at: &[DVec3]) -> f64 {
        -self.tension * self.area(at)
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        for ([a, b], share) in self.shares(at) {
            gradient[a as usize] -= share.gradient[0] * self.tension;
            gradient[b as usize] -= share.gradient[1] * self.tension;
        }
    }

    // The second derivative has no semidefinite part, so the shift does not enter.
    fn add_second_derivative(&self, at: &[DVec3], _shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        for ([a, b], share) in self.shares(at) {
            let [own, mixed, other] = share.second.map(|block| block * -self.tension);
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
    use std::f64::consts::TAU;

    fn supports() -> [Support; 3] {
        let axis = DVec3::new(0.6, 0.0, 0.8);
        [
            Support::Plane { point: DVec3::new(0.3, -0.2, 0.1), normal: axis },
            Support::Sphere { centre: DVec3::new(-0.1, 0.2, 0.0), radius: 2.0 },
            Support::Cylinder { point: DVec3::new(0.2, 0.1, -0.4), axis, radius: 1.5 },
        ]
    }

    #[test]
    fn the_derivatives_agree_with_finite_differences() {
        let at = |k: usize| {
            let angle = 0.9 * k as f64;
            DVec3::new(1.7 * libm::cos(angle), 1.4 * libm::sin(angle), 0.4 * libm::sin(2.0 * angle))
        };
        let places: Vec<DVec3> = (0..7).map(at).collect();
        for support in supports() {
            let on: Vec<DVec3> = places.iter().map(|&p| support.nearest(p)).collect();
            for (closed, chain) in [(true, vec![0, 1, 2, 3, 4, 5, 6]), (false, vec![0, 1, 2, 3])] {
                let contact = Contact::new(&chain, closed, &support, 1.3, 1.0, &on).unwrap();
                assert_eq!(contact.value(&on), 0.0);
                check(&contact, &on, 1e-7);
                // Also off the surface, where the term is smooth too.
                check(&contact, &places, 1e-7);
            }
        }
    }

    #[test]
    fn the_area_is_that_on_the_left_of_the_edge() {
        // Circles around the axis of each support that run counter-clockwise, from one height or radius to another.
        let count = 400;
        for support in supports() {
            let (centre, axis, radius) = match support {
                Support::Plane { point, normal } => (point, normal, f64::NAN),
                Support::Sphere { centre, radius } => (centre, DVec3::Z, radius),
                Support::Cylinder { point, axis, radius } => (point, axis, radius),
                _ => unreachable!(),
            };
            let (u, v) = axis.any_orthonormal_pair();
            let circle = |r: f64, z: f64| -> Vec<DVec3> {
                let angle = |k: usize| TAU * k as f64 / f64::from(count);
                let at = |k: usize| centre + axis * z + r * (libm::cos(angle(k)) * u + libm::sin(angle(k)) * v);
                (0..count as usize).map(at).collect()
            };
            let (from, to, exact) = match support {
                Support::Plane { .. } => (circle(1.0, 0.0), circle(1.6, 0.0), PI * (1.6 * 1.6 - 1.0)),
                // The cap above the circle of the polar angle t has the area 2 π r² (1 - cos t).
                Support::Sphere { .. } => {
                    let at = |t: f64| circle(radius * libm::sin(t), radius * libm::cos(t));
                    (at(0.7), at(1.9), TAU * radius * radius * (libm::cos(0.7f64) - libm::cos(1.9f64)))
                }
                // The part above the circle is on its left.
                _ => (circle(radius, 0.4), circle(radius, -0.3), TAU * radius * 0.7),
            };
            let chain: Vec<u32> = (0..count).collect();
            let contact = Contact::new(&chain, true, &support, 1.0, 1.0, &from).unwrap();
            let area = contact.area(&to);
            assert!((area / exact - 1.0).abs() < 1e-3, "{support:?}: {area} {exact}");
        }
    }

    #[test]
    fn a_right_angle_has_no_energy_and_a_curve_no_area() {
        let [plane, ..] = supports();
        let at = [DVec3::X, DVec3::Y, DVec3::ZERO];
        let contact = Contact::new(&[0, 1, 2], true, &plane, 2.0, 0.5 * PI, &at).unwrap();
        assert_eq!(contact.tension, 0.0);
        let line = Support::Line { point: DVec3::ZERO, direction: DVec3::X };
        assert_eq!(Contact::new(&[0, 1, 2], true, &line, 2.0, 1.0, &at), None);
    }
}
