//! Boundary polygons of known minimal surfaces, shared by the tests and the benches.
#![allow(dead_code, reason = "each test file uses its part")]

use plateau_mesh::DVec3;
use std::f64::consts::{PI, TAU};

/// The boundary of the image of a parameter rectangle, with `nu` and `nv` intervals along its sides in u and v.
pub fn patch(
    surface: impl Fn(f64, f64) -> DVec3,
    (u0, u1): (f64, f64),
    (v0, v1): (f64, f64),
    (nu, nv): (usize, usize),
) -> Vec<DVec3> {
    patch_with_sides(surface, (u0, u1), (v0, v1), [nu, nv, nu, nv])
}

/// The boundary of the patch with a number of intervals for each side. The sides are at v0, u1, v1 and u0, in the order
/// in which the boundary passes them.
pub fn patch_with_sides(
    surface: impl Fn(f64, f64) -> DVec3,
    (u0, u1): (f64, f64),
    (v0, v1): (f64, f64),
    sides: [usize; 4],
) -> Vec<DVec3> {
    let u = |k: usize, n: usize| u0 + (u1 - u0) * k as f64 / n as f64;
    let v = |k: usize, n: usize| v0 + (v1 - v0) * k as f64 / n as f64;
    let mut points: Vec<DVec3> = (0..sides[0]).map(|k| surface(u(k, sides[0]), v0)).collect();
    points.extend((0..sides[1]).map(|k| surface(u1, v(k, sides[1]))));
    points.extend((1..=sides[2]).rev().map(|k| surface(u(k, sides[2]), v1)));
    points.extend((1..=sides[3]).rev().map(|k| surface(u0, v(k, sides[3]))));
    points
}

/// Chen, Cai, Zheng's helicoid patch: 186 points, limit area 535.0748 on this polygon.
pub fn helicoid() -> Vec<DVec3> {
    helicoid_with(12, 81)
}

pub fn helicoid_with(nu: usize, nv: usize) -> Vec<DVec3> {
    helicoid_split([nu, nu, nv, nv])
}

/// The helicoid patch with these numbers of intervals on its two straight sides, on the inner and on the outer helix.
/// [12, 12, 49, 113] are 13 points on each straight side, 48 on the inner and 112 on the outer helix: 186 points whose
/// limit area is 536.023, near the paper's 536.07.
pub fn helicoid_split([first, last, inner, outer]: [usize; 4]) -> Vec<DVec3> {
    let sides = [first, outer, last, inner];
    patch_with_sides(|u, v| DVec3::new(u * v.cos(), u * v.sin(), v), (2.0, 10.0), (-1.0, 10.0), sides)
}

/// Chen, Cai, Zheng's catenoid patch: 156 points. The limit area 58.1637 is that of another surface, because the
/// catenoid is unstable here.
pub fn catenoid() -> Vec<DVec3> {
    catenoid_to(2.0)
}

/// The same sector of the catenoid, for |v| up to `height`.
pub fn catenoid_to(height: f64) -> Vec<DVec3> {
    catenoid_sector(height, (52, 26))
}

/// The catenoid patch with other numbers of intervals along u and v.
pub fn catenoid_split(nu: usize, nv: usize) -> Vec<DVec3> {
    catenoid_sector(2.0, (nu, nv))
}

fn catenoid_sector(height: f64, intervals: (usize, usize)) -> Vec<DVec3> {
    let sector = 3.0 * PI / 5.0;
    let surface = |u: f64, v: f64| DVec3::new(v.cosh() * u.cos(), v.cosh() * u.sin(), v);
    patch(surface, (-sector, sector), (-height, height), intervals)
}

/// Scherk's surface over |x|, |y| <= 0.4 π: 40 points, limit area 11.6147.
pub fn scherk() -> Vec<DVec3> {
    let side = (-0.4 * PI, 0.4 * PI);
    patch(|x, y| DVec3::new(x, y, (y.cos() / x.cos()).ln()), side, side, (10, 10))
}

pub fn circle(points: usize, radius: f64, z: f64) -> Vec<DVec3> {
    (0..points)
        .map(|k| {
            let angle = TAU * k as f64 / points as f64;
            DVec3::new(radius * angle.cos(), radius * angle.sin(), z)
        })
        .collect()
}

/// Two coaxial unit circles.
pub fn rings(points: usize, gap: f64) -> Vec<Vec<DVec3>> {
    vec![circle(points, 1.0, -gap / 2.0), circle(points, 1.0, gap / 2.0)]
}

/// A closed polygon's corners with `per_side` intervals on every side.
pub fn sides(corners: &[DVec3], per_side: usize) -> Vec<DVec3> {
    (0..corners.len())
        .flat_map(|k| {
            let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
            (0..per_side).map(move |i| a + (b - a) * (i as f64 / per_side as f64))
        })
        .collect()
}

/// Four edges of a regular tetrahedron with edge 1: limit area 0.6396308.
pub fn skew_quadrilateral(per_side: usize) -> Vec<DVec3> {
    let corner = |x, y, z| DVec3::new(x, y, z) / 2f64.sqrt();
    sides(&[corner(0.0, 0.0, 0.0), corner(1.0, 0.0, 1.0), corner(1.0, 1.0, 0.0), corner(0.0, 1.0, 1.0)], per_side)
}
