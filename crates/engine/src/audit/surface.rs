//! Area, angles, flipped and degenerate triangles of a list of triangles.

use super::figure::{Largest, Least, Measured, RELATIVE, Sum};
use plateau_mesh::DVec3;

/// A triangle is degenerate below this ratio of its least altitude to its longest edge.
pub(crate) const DEGENERATE: f64 = 1e-10;

/// Figures of some triangles. Angles are in radians.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    /// Longest side and double area of each triangle.
    pub sides: Vec<Sides>,
    /// Sums over the triangles around each vertex.
    pub rings: Vec<Ring>,
    pub area: Sum,
    pub smallest_angle: Least,
    pub largest_angle: Largest,
    /// Number of triangles that certainly are degenerate, and of those that are if rounding favours it. The next field
    /// has the same two numbers for flipped triangles.
    pub degenerate: [usize; 2],
    pub flipped: [usize; 2],
}

/// Sums over the triangles around one vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ring {
    /// Sum of the double area vectors of the triangles.
    pub normal: DVec3,
    /// Distance by which rounding may move `normal`.
    rounding: f64,
    /// Gradient of the area with respect to the vertex.
    pub gradient: DVec3,
    pub double_area: f64,
    /// Reciprocal of the shortest altitude of the triangles.
    pub steepness: f64,
    /// Whether one of the triangles is degenerate, so that rounding determines its figures.
    pub is_degenerate: bool,
}

/// The longest side of a triangle and twice its area.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sides {
    pub double_area_vector: DVec3,
    pub double_area: f64,
    pub longest: f64,
}

impl Sides {
    #[must_use]
    pub fn of([a, b, c]: [DVec3; 3]) -> Self {
        let double_area_vector = (b - a).cross(c - a);
        let [u, v, w] = [b - a, c - b, a - c].map(DVec3::length_squared);
        Self { double_area_vector, double_area: double_area_vector.length(), longest: u.max(v).max(w).sqrt() }
    }

    /// Returns an upper bound of the perimeter, which takes one root in place of three.
    #[must_use]
    pub fn perimeter(&self) -> f64 {
        3.0 * self.longest
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
    /// Measures triangles whose coordinates have a rounding error of `step`. O(vertices + triangles).
    #[must_use]
    pub fn of(vertices: &[DVec3], triangles: &[[u32; 3]], step: f64) -> Self {
        let mut found = Self {
            sides: Vec::with_capacity(triangles.len()),
            rings: vec![
                Ring {
                    normal: DVec3::ZERO,
                    rounding: 0.0,
                    gradient: DVec3::ZERO,
                    double_area: 0.0,
                    steepness: 0.0,
                    is_degenerate: false,
                };
                vertices.len()
            ],
            area: Sum::default(),
            smallest_angle: Least::NONE,
            largest_angle: Largest::NONE,
            degenerate: [0; 2],
            flipped: [0; 2],
        };
        let [mut smallest, mut largest] = [Filter::new(), Filter::new()];
        for &triangle in triangles {
            let at = corners(vertices, triangle);
            let sides = Sides::of(at);
            found.sides.push(sides);
            found.area.add(0.5 * sides.double_area, 0.5 * step * sides.perimeter());
            let [a, b, c] = at;
            // Side k lies opposite corner k.
            let opposite = [c - b, a - c, b - a];
            let dots = [1, 2, 0].map(|k: usize| -opposite[k].dot(opposite[(k + 1) % 3]));
            // A triangle without area has infinite steepness, so that its tolerance allows every angle. If its corners
            // coincide, the steepness is NaN, and the triangle has no angle.
            let inverse = 1.0 / sides.double_area;
            let steepness = sides.longest * inverse;
            let tolerance = RELATIVE + step * steepness;
            let (greatest, least) = (dots[0].max(dots[1]).max(dots[2]), dots[0].min(dots[1]).min(dots[2]));
            if smallest.may_count(greatest, sides.double_area, tolerance) {
                found.smallest_angle.add(libm::atan2(sides.double_area, greatest), tolerance);
                smallest.reached(found.smallest_angle.measured().high);
            }
            if largest.may_count(-least, sides.double_area, tolerance) {
                found.largest_angle.add(libm::atan2(sides.double_area, least), tolerance);
                largest.reached(std::f64::consts::PI - found.largest_angle.measured().low);
            }
            let (limit, error) = (DEGENERATE * sides.longest * sides.longest, step * sides.perimeter());
            found.degenerate[0] += usize::from(sides.double_area + error < limit * (1.0 - RELATIVE));
            found.degenerate[1] += usize::from(sides.double_area <= limit * (1.0 + RELATIVE) + error);
            let is_degenerate = sides.double_area.is_nan() || sides.double_area <= limit;
            let half_unit =
                if sides.double_area > 0.0 { sides.double_area_vector * (0.5 * inverse) } else { DVec3::ZERO };
            for (v, opposite) in triangle.into_iter().zip(opposite) {
                let ring = &mut found.rings[v as usize];
                ring.normal += sides.double_area_vector;
                ring.rounding += error;
                // The gradient of a triangle's area at a corner points away from the opposite side, and has half its
                // length.
                ring.gradient += half_unit.cross(opposite);
                ring.double_area += sides.double_area;
                ring.steepness = ring.steepness.max(steepness);
                ring.is_degenerate |= is_degenerate;
            }
        }
        found.count_flipped(triangles, step);
        found
    }

    /// Counts the triangles that face away from the normals at their corners.
    fn count_flipped(&mut self, triangles: &[[u32; 3]], step: f64) {
        let unit = |ring: &Ring| {
            let length = ring.normal.length();
            let inverse = 1.0 / length;
            let unit = if length > 0.0 { ring.normal * inverse } else { DVec3::ZERO };
            (unit, RELATIVE + ring.rounding * inverse)
        };
        let units: Vec<(DVec3, f64)> = self.rings.iter().map(unit).collect();
        for (triangle, sides) in triangles.iter().zip(&self.sides) {
            let [a, b, c] = triangle.map(|v| units[v as usize]);
            // The sum of three cosines times the double area.
            let facing = sides.double_area_vector.dot(a.0 + b.0 + c.0);
            // Each unit normal moves by its own rounding, and the triangle's normal turns by the step over its
            // altitude.
            let turned = (a.1 + b.1 + c.1 + 3.0 * RELATIVE) * sides.double_area + 3.0 * step * sides.longest;
            self.flipped[0] += usize::from(facing < -turned);
            // A triangle without area has neither a normal nor a cosine, and may count.
            let certainly_upright = facing >= turned && sides.double_area > 0.0;
            self.flipped[1] += usize::from(!certainly_upright);
        }
    }

    /// Returns the smallest and the largest angle in degrees.
    #[must_use]
    pub fn angles_deg(&self) -> [Measured; 2] {
        let degrees = 1f64.to_degrees();
        [self.smallest_angle.measured().times(degrees), self.largest_angle.measured().times(degrees)]
    }
}

/// Skips the triangles whose angle is certainly not the extreme one, because an arc tangent takes as long as all other
/// figures of a triangle.
struct Filter {
    /// Cotangent below which an angle is certainly larger than the extreme one.
    cotangent: f64,
}

/// Margin of a filter in radians. Triangles whose tolerance is larger are never skipped.
const MARGIN: f64 = 1e-6;

impl Filter {
    fn new() -> Self {
        Self { cotangent: f64::NEG_INFINITY }
    }

    /// Returns whether the angle whose cotangent is `dot / double_area` may be smaller than the smallest angle so far.
    fn may_count(&self, dot: f64, double_area: f64, tolerance: f64) -> bool {
        let is_larger = tolerance < MARGIN && dot < self.cotangent * double_area;
        !is_larger
    }

    fn reached(&mut self, angle: f64) {
        let bound = angle + MARGIN;
        // Nothing is skipped if the bound is near or beyond a right angle, or if rounding allows every angle.
        self.cotangent = if bound > 0.0 && bound < 1.5 { 1.0 / libm::tan(bound) } else { f64::NEG_INFINITY };
    }
}
