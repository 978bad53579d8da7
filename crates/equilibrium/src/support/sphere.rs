//! A sphere as a support.

use super::{AreaBeside, AreaPart, Support};
use crate::energy::outer;
use crate::energy::volume::cross_matrix;
use glam::DMat3;
use plateau_mesh::DVec3;
use std::sync::Arc;

/// A sphere, whose normal points outward. II(u, v) = -(u·v) (x - centre) / r².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub centre: DVec3,
    /// r, the radius.
    pub radius: f64,
}

impl Support for Sphere {
    fn is_sound(&self) -> bool {
        self.radius > 0.0
    }

    fn dimension(&self) -> u8 {
        2
    }

    fn nearest(&self, x: DVec3) -> DVec3 {
        self.centre + self.radius * self.normal(x)
    }

    fn tangents(&self, x: DVec3) -> [DVec3; 2] {
        self.normal(x).any_orthonormal_pair().into()
    }

    fn normal(&self, x: DVec3) -> DVec3 {
        (x - self.centre).normalize_or(DVec3::Z)
    }

    fn second_fundamental_form(&self, x: DVec3, u: DVec3, v: DVec3) -> DVec3 {
        (x - self.centre) * (-u.dot(v) / (self.radius * self.radius))
    }

    fn moved(&self, by: DVec3) -> Arc<dyn Support> {
        Arc::new(Self { centre: self.centre + by, ..*self })
    }

    fn area_beside(&self, edge: &[DVec3]) -> Option<Arc<dyn AreaBeside>> {
        let units: Vec<DVec3> = edge.iter().map(|&x| (x - self.centre).normalize_or_zero()).collect();
        Some(Arc::new(Triangles { sphere: *self, pole: pole(&units) }))
    }
}

/// The area beside an edge, as a sum of spherical triangles. Each has a segment of the edge, drawn as a great circle,
/// as one side and the pole q as the opposite corner:
///
/// ```text
/// r² Ω,  tan(Ω / 2) = q · (u × v) / (1 + q · u + u · v + v · q)         u, v = (a, b - centre) / |·|
/// ```
///
/// with the solid angle Ω of the triangle (Van Oosterom, Strackee 1983).
#[derive(Clone, Copy, Debug)]
struct Triangles {
    sphere: Sphere,
    /// q, the common corner of all triangles.
    pole: DVec3,
}

impl AreaBeside for Triangles {
    fn part(&self, a: DVec3, b: DVec3) -> AreaPart {
        let Self { sphere: Sphere { centre, radius }, pole: q } = *self;
        let (x, y) = (a - centre, b - centre);
        let (u, v) = (x.normalize(), y.normalize());
        // Ω = 2 atan2(N, D), with the numerator N and the denominator D of tan(Ω / 2).
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
}

/// Converts derivatives by the unit vectors u = x / |x| and v = y / |y| to derivatives by x and y.
fn by_places(x: DVec3, y: DVec3, area: f64, gradient: [DVec3; 2], second: [DMat3; 3]) -> AreaPart {
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
    AreaPart {
        area,
        gradient: [to_u * gradient[0], to_v * gradient[1]],
        second: [
            to_u * second[0] * to_u + bend(gradient[0], u, x),
            to_u * second[1] * to_v,
            to_v * second[2] * to_v + bend(gradient[1], v, y),
        ],
    }
}

/// Chooses the pole for the solid angles of a chain of unit vectors. The solid angle jumps where the chain passes the
/// antipode of the pole. Of a few candidates the function therefore takes the one whose antipode is farthest from the
/// chain.
fn pole(units: &[DVec3]) -> DVec3 {
    let mean: DVec3 = units.iter().sum();
    let around: DVec3 = (0..units.len()).map(|k| units[k].cross(units[(k + 1) % units.len()])).sum();
    let nearest = |pole: DVec3| units.iter().map(|unit| unit.dot(pole)).fold(1.0, f64::min);
    let candidates = [mean, around, -around].map(|direction| direction.normalize_or(DVec3::Z));
    let all = candidates.into_iter().chain(DVec3::AXES).chain(DVec3::AXES.map(|axis| -axis));
    all.reduce(|best, pole| if nearest(pole) > nearest(best) + 0.1 { pole } else { best }).unwrap_or(DVec3::Z)
}
