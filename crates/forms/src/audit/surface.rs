//! Area, angles, flipped and degenerate triangles of a list of triangles.

use super::figure::{Largest, Least, Measured, RELATIVE, Sum};
use plateau_mesh::DVec3;

/// A triangle is degenerate below this ratio of its least altitude to its longest edge.
pub(crate) const DEGENERATE: f64 = 1e-10;

/// Figures of some triangles. Angles are in radians.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface {
    pub area: Sum,
    pub smallest_angle: Least,
    pub largest_angle: Largest,
    /// The triangles that certainly count, and those that count if rounding favours them.
    pub degenerate: [usize; 2],
    pub flipped: [usize; 2],
}

/// Lengths of the sides of a triangle and twice its area.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sides {
    pub double_area_vector: DVec3,
    pub double_area: f64,
    pub perimeter: f64,
    pub longest: f64,
}

impl Sides {
    #[must_use]
    pub fn of([a, b, c]: [DVec3; 3]) -> Self {
        let double_area_vector = (b - a).cross(c - a);
        let [u, v, w] = [b - a, c - b, a - c].map(DVec3::length);
        let double_area = double_area_vector.length();
        Self { double_area_vector, double_area, perimeter: u + v + w, longest: u.max(v).max(w) }
    }

    /// Returns the shortest altitude.
    #[must_use]
    pub fn altitude(&self) -> f64 {
        self.double_area / self.longest
    }
}

/// Returns the corners of a triangle.
#[must_use]
pub(crate) fn corners(vertices: &[DVec3], triangle: [u32; 3]) -> [DVec3; 3] {
    triangle.map(|v| vertices[v as usize])
}

impl Surface {
    /// Measures triangles whose coordinates are rounded by `step`. O(vertices + triangles).
    #[must_use]
    pub fn of(vertices: &[DVec3], triangles: &[[u32; 3]], step: f64) -> Self {
        let mut found = Self {
            area: Sum::default(),
            smallest_angle: Least::NONE,
            largest_angle: Largest::NONE,
            degenerate: [0; 2],
            flipped: [0; 2],
        };
        // Sum of the double area vectors around each vertex, and how far rounding moves it.
        let mut normals = vec![(DVec3::ZERO, 0.0); vertices.len()];
        for &triangle in triangles {
            let at = corners(vertices, triangle);
            let sides = Sides::of(at);
            found.area.add(0.5 * sides.double_area, 0.5 * step * sides.perimeter);
            let [a, b, c] = at;
            let dots = [(b - a).dot(c - a), (c - b).dot(a - b), (a - c).dot(b - c)];
            let tolerance = RELATIVE + step / sides.altitude();
            found.smallest_angle.add(libm::atan2(sides.double_area, dots[0].max(dots[1]).max(dots[2])), tolerance);
            found.largest_angle.add(libm::atan2(sides.double_area, dots[0].min(dots[1]).min(dots[2])), tolerance);
            let (limit, error) = (DEGENERATE * sides.longest * sides.longest, step * sides.perimeter);
            found.degenerate[0] += usize::from(sides.double_area + error < limit * (1.0 - RELATIVE));
            found.degenerate[1] += usize::from(sides.double_area <= limit * (1.0 + RELATIVE) + error);
            for v in triangle {
                let (normal, rounding) = &mut normals[v as usize];
                *normal += sides.double_area_vector;
                *rounding += error;
            }
        }
        let units: Vec<(DVec3, f64)> = normals
            .into_iter()
            .map(|(normal, rounding)| (normal.normalize_or_zero(), RELATIVE + rounding / normal.length()))
            .collect();
        for &triangle in triangles {
            let [a, b, c] = corners(vertices, triangle);
            let normal = (b - a).cross(c - a);
            let length = normal.length();
            let [a, b, c] = triangle.map(|v| units[v as usize]);
            let cosine = normal.dot(a.0 + b.0 + c.0) / length;
            // Each unit normal moves by its own rounding, and the triangle's normal turns by the step over its
            // altitude.
            let turn = RELATIVE + step * longest(vertices, triangle) / length;
            let tolerance = a.1 + b.1 + c.1 + 3.0 * turn;
            found.flipped[0] += usize::from(cosine < -tolerance);
            // A triangle without area has neither a normal nor a cosine, and may count.
            let certainly_upright = cosine >= tolerance;
            found.flipped[1] += usize::from(!certainly_upright);
        }
        found
    }

    /// Returns the smallest and the largest angle in degrees.
    #[must_use]
    pub fn angles_deg(&self) -> [Measured; 2] {
        let degrees = 1f64.to_degrees();
        [self.smallest_angle.measured().times(degrees), self.largest_angle.measured().times(degrees)]
    }
}

fn longest(vertices: &[DVec3], triangle: [u32; 3]) -> f64 {
    let [a, b, c] = corners(vertices, triangle);
    (b - a).length().max((c - b).length()).max((a - c).length())
}
