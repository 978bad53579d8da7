//! Finds perpendicular planes of symmetry of a boundary.
//!
//! A reflection σ at a plane of symmetry maps the boundary Γ to itself, either in the same direction (s = 1) or in the
//! opposite direction (s = -1). The field s σ*A has the same circulation as A, and its curls have the same lengths. The
//! mean of A and s σ*A also has this circulation, and its curls are at most as long. The largest circulation is
//! therefore reached by a field that is its own image. This field is known on both sides of the plane if it is known on
//! one side. If s = -1, its tangential component vanishes in the plane.
//!
//! A mesh on one side of every plane has a half, a quarter or an eighth of the tetrahedra, so that the same budget
//! affords a finer mesh. The proof does not rely on the symmetry: any field is allowed, and its circulation is computed
//! around the given boundary.
//!
//! The planes are perpendicular to the axes of the mesh. If the boundary has more planes of symmetry in other
//! directions, the mesh is rotated to them ([`Axes`]). Other symmetries, such as half turns, are not used.

use super::interval::{Interval, IntervalVector};
use glam::BVec3;
use plateau_mesh::execution::Interruption;
use plateau_mesh::{DVec3, Execution};

/// Largest distance, as a fraction of the boundary's size, at which a vertex and the mirror image of another vertex
/// count as equal. The coordinates of boundaries of a few metres that were rounded to millimetres differ by this much.
/// A symmetrical field bounds the area of half a film together with that of half its mirror image. If the symmetry
/// holds only roughly, this sum is the film's area up to a term of second order.
const TOLERANCE: f64 = 5e-4;
/// Two planes count as perpendicular if the cosine between their normals is at most this. Normals are less accurate
/// than points, and the axes are made perpendicular afterwards.
const PERPENDICULAR: f64 = 1e-3;
/// Largest number of points of a boundary for which planes of symmetry are searched in all directions, because the time
/// can increase with the square of the number.
const MOST_POINTS: usize = 5_000;

/// A plane of symmetry of a field, perpendicular to an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The number of the axis: 0, 1 or 2.
    pub axis: usize,
    /// The coordinate of the plane.
    pub at: f64,
    /// 1 or -1. The field on the other side of the plane is this number times the reflected field (its pull-back).
    pub sign: i8,
}

/// The planes of symmetry of an oriented boundary: for each axis, whether the reflection at the perpendicular plane
/// through the middle maps the boundary to itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Mirrors {
    /// The mean of all vertices, through which every plane of symmetry passes.
    pub middle: DVec3,
    /// For each axis, 1 if the reflection keeps the boundary's direction, -1 if it reverses the direction, and 0 if the
    /// boundary is not symmetrical.
    signs: [i8; 3],
}

impl Mirrors {
    /// The symmetries of oriented closed polygons. `middle` is the mean of all their vertices.
    pub fn of(loops: &[Vec<DVec3>], middle: DVec3) -> Self {
        Self::that(loops, middle, |_, _| true)
    }

    /// The symmetries of closed polygons that hold whatever the direction of each polygon is, because every polygon is
    /// its own image.
    pub fn in_every_orientation(loops: &[Vec<DVec3>], middle: DVec3) -> Self {
        Self::that(loops, middle, |number, image| image.on == number)
    }

    /// The symmetries for which `is_good` accepts the number and the image of every polygon.
    fn that(loops: &[Vec<DVec3>], middle: DVec3, is_good: impl Fn(usize, &Image) -> bool) -> Self {
        let tolerance = tolerance(loops);
        let sign = |axis: usize| {
            let images = Plane { normal: DVec3::AXES[axis], middle }.images(loops, tolerance)?;
            let same = |(number, image): (usize, &Image)| image.sign == images[0].sign && is_good(number, image);
            images.iter().enumerate().all(same).then_some(images[0].sign)
        };
        Self { middle, signs: std::array::from_fn(|axis| sign(axis).unwrap_or(0)) }
    }

    /// The axes that have a plane of symmetry.
    pub fn axes(&self) -> BVec3 {
        BVec3::from_array(self.signs.map(|sign| sign != 0))
    }

    /// The axes at whose planes the field changes its sign, as a bit for each axis.
    pub fn odd(&self) -> u8 {
        (0..3).filter(|&axis| self.signs[axis] < 0).map(|axis| 1 << axis).sum()
    }

    /// Number of mirror images of a point, including the point itself.
    pub fn images(&self) -> usize {
        1 << self.axes().bitmask().count_ones()
    }

    /// The factor between the integral of the field along a curve and that along its mirror image. `flips` is -1 for
    /// each axis that is reflected, else 1.
    pub fn sign(&self, flips: DVec3) -> f64 {
        (0..3).filter(|&axis| flips[axis] < 0.0).map(|axis| f64::from(self.signs[axis])).product()
    }

    /// The part of a constant curl that a symmetrical field can have.
    pub fn symmetrical(&self, curl: DVec3) -> DVec3 {
        (0..3).fold(curl, |curl, axis| {
            let along = BVec3::from_array(std::array::from_fn(|k| k == axis));
            match self.signs[axis] {
                -1 => DVec3::select(along, DVec3::ZERO, curl),
                1 => DVec3::select(along, curl, DVec3::ZERO),
                _ => curl,
            }
        })
    }

    /// The `flips` of each mirror image: -1 for each axis that is reflected, else 1.
    pub fn flips(&self) -> Vec<DVec3> {
        let mut flips = vec![DVec3::ONE];
        for axis in (0..3).filter(|&axis| self.signs[axis] != 0) {
            flips.extend(flips.iter().map(|&flip| flip - 2.0 * flip * DVec3::AXES[axis]).collect::<Vec<_>>());
        }
        flips
    }

    /// The planes of symmetry. They all pass through `point`.
    pub fn planes(&self, point: DVec3) -> Vec<Mirror> {
        let mirror = |axis: usize| Mirror { axis, at: point[axis], sign: self.signs[axis] };
        (0..3).filter(|&axis| self.signs[axis] != 0).map(mirror).collect()
    }
}

/// The mean of all vertices. A reflection that maps the boundary to itself does not move it.
pub(super) fn middle(loops: &[Vec<DVec3>]) -> DVec3 {
    let start = loops[0][0];
    let (sum, count) = loops.iter().flatten().fold((DVec3::ZERO, 0.0), |(sum, n), &p| (sum + (p - start), n + 1.0));
    start + sum / count
}

fn tolerance(loops: &[Vec<DVec3>]) -> f64 {
    let size = loops.iter().flatten().fold(0.0, |size: f64, p| size.max(p.distance(loops[0][0])));
    TOLERANCE * size
}

/// A plane through a point.
#[derive(Clone, Copy, Debug)]
struct Plane {
    /// The unit normal.
    normal: DVec3,
    middle: DVec3,
}

/// How the mirror image of a closed polygon lies on one of the polygons, which may be the polygon itself.
#[derive(Clone, Copy, Debug)]
struct Image {
    on: usize,
    /// The vertex of that polygon on which the image of the first vertex lies.
    start: usize,
    /// 1 if the image has the direction of the polygon on which it lies, else -1.
    sign: i8,
}

impl Image {
    /// The vertex on which the image of vertex k lies. `count` is the number of vertices of the polygon.
    fn vertex(&self, k: usize, count: usize) -> usize {
        if self.sign > 0 { (self.start + k) % count } else { (self.start + count - k) % count }
    }
}

impl Plane {
    fn reflected(&self, points: &[DVec3]) -> Vec<DVec3> {
        points.iter().map(|&p| p - self.normal * (2.0 * self.normal.dot(p - self.middle))).collect()
    }

    /// The image of each closed polygon. `None` if an image lies on none of the polygons.
    fn images(&self, loops: &[Vec<DVec3>], tolerance: f64) -> Option<Vec<Image>> {
        let image = |points: &Vec<DVec3>| {
            let reflected = self.reflected(points);
            (0..loops.len()).find_map(|on| image_on(&reflected, &loops[on], on, tolerance))
        };
        loops.iter().map(image).collect()
    }

    /// The plane with an improved normal: the mean direction from the vertices to their images.
    fn improved(self, loops: &[Vec<DVec3>], images: &[Image], tolerance: f64) -> Self {
        let (mut sum, mut all) = (DVec3::ZERO, 0.0);
        for (points, image) in loops.iter().zip(images) {
            for (k, &point) in points.iter().enumerate() {
                let way = loops[image.on][image.vertex(k, points.len())] - point;
                sum += way * way.dot(self.normal).signum();
                all += 1.0;
            }
        }
        // Vertices in the plane are their own images and say nothing about the normal.
        if sum.length() > all * tolerance { Self { normal: sum.normalize(), ..self } } else { self }
    }
}

/// Returns how the mirror image of a closed polygon lies on the polygon with the number `on`, or `None` if it does not.
fn image_on(image: &[DVec3], points: &[DVec3], on: usize, tolerance: f64) -> Option<Image> {
    let count = points.len();
    if image.len() != count {
        return None;
    }
    let starts = (0..count).filter(|&start| image[0].distance(points[start]) <= tolerance);
    let candidates = starts.flat_map(|start| [1, -1].map(|sign| Image { on, start, sign }));
    let lies_on = |of: &Image| (0..count).all(|k| image[k].distance(points[of.vertex(k, count)]) <= tolerance);
    candidates.into_iter().find(|candidate| lies_on(candidate))
}

/// A rectangular coordinate system. The coordinates of a point x are the scalar products of the directions with x -
/// origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// The point whose coordinates become zero.
    pub origin: DVec3,
    /// Three directions, perpendicular to each other and of length 1 up to rounding.
    pub directions: [DVec3; 3],
}

/// The coordinates of a point with respect to `axes`, or the point itself if `axes` is `None`.
pub(super) fn place(axes: Option<&Axes>, point: DVec3) -> DVec3 {
    axes.map_or(point, |axes| axes.turn(point - axes.origin))
}

impl Axes {
    /// Finds axes that have more planes of symmetry perpendicular to them than the given coordinate axes have. `None`
    /// if there are none.
    ///
    /// # Errors
    /// An interruption by the caller.
    pub(super) fn of(loops: &[Vec<DVec3>], exec: &Execution) -> Result<Option<Self>, Interruption> {
        let middle = middle(loops);
        let points = || loops.iter().flatten().copied();
        let count = points().count();
        let have = Mirrors::of(loops, middle).axes().bitmask().count_ones() as usize;
        if count > MOST_POINTS || have == 3 {
            return Ok(None);
        }
        let farthest = |from: &dyn Fn(DVec3) -> f64| {
            points().fold(middle, |best, p| if from(p - middle) > from(best - middle) { p } else { best })
        };
        let first = farthest(&|p| p.length_squared());
        let second = farthest(&|p| p.cross(first - middle).length_squared());
        // For every plane of symmetry, one of three cases holds: it lies halfway between the first point and its image,
        // it lies halfway between the second point and its image, or it contains both points.
        let tolerance = tolerance(loops);
        let between = |p: DVec3| {
            points().filter_map(move |q| {
                let normal = (q - p).try_normalize().filter(|_| q.distance(p) > tolerance)?;
                (normal.dot(0.5 * (p - middle) + 0.5 * (q - middle)).abs() <= tolerance).then_some(normal)
            })
        };
        let both = (first - middle).cross(second - middle).try_normalize();
        let mut normals: Vec<DVec3> = Vec::new();
        for normal in between(first).chain(between(second)).chain(both) {
            exec.look(4 * count as u64)?;
            let plane = Plane { normal, middle };
            if normals.iter().all(|other| other.dot(normal).abs() <= PERPENDICULAR)
                && let Some(images) = plane.images(loops, tolerance)
            {
                normals.push(plane.improved(loops, &images, tolerance).normal);
            }
            if normals.len() == 3 {
                break;
            }
        }
        if normals.len() <= have {
            return Ok(None);
        }
        let x = normals[0];
        // If there is only one plane, the second axis points to the point that is farthest from the first axis.
        let y = normals.get(1).copied().unwrap_or_else(|| farthest(&|p| p.cross(x).length_squared()) - middle);
        let y = (y - x * x.dot(y)).try_normalize();
        Ok(y.map(|y| Self { origin: middle, directions: [x, y, x.cross(y)] }))
    }

    /// The components of a vector along the axes.
    pub(super) fn turn(&self, vector: DVec3) -> DVec3 {
        DVec3::from_array(self.directions.map(|axis| axis.dot(vector)))
    }

    /// Intervals that contain the coordinates of a point.
    pub(super) fn place_rigorously(&self, point: DVec3) -> IntervalVector {
        let from_origin = IntervalVector::exactly(point) - IntervalVector::exactly(self.origin);
        IntervalVector(self.directions.map(|axis| IntervalVector::exactly(axis).dot(from_origin)))
    }

    /// An upper bound of the factor by which the change of coordinates enlarges an area. Without rounding it would be
    /// 1.
    pub(super) fn enlargement(&self) -> Interval {
        // The largest eigenvalue of RᵀR, and so of R Rᵀ, is at most the largest sum of a row's magnitudes.
        let sum = |a: &DVec3| {
            self.directions.iter().fold(Interval::ZERO, |sum, b| {
                let product = IntervalVector::exactly(*a).dot(IntervalVector::exactly(*b));
                sum + Interval::exactly(product.low.abs().max(product.high.abs()))
            })
        };
        let most = self.directions.iter().map(|axis| sum(axis).high).fold(1.0, f64::max);
        Interval { low: 1.0, high: most }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn circle(points: usize, at: impl Fn(f64, f64) -> DVec3) -> Vec<DVec3> {
        (0..points)
            .map(|k| libm::sincos(TAU * k as f64 / points as f64))
            .map(|(sine, cosine)| at(cosine, sine))
            .collect()
    }

    #[test]
    fn reflections_of_oriented_boundaries_are_found() {
        let offset = DVec3::new(300.0, -20.0, 7.0);
        let ring = |z: f64| circle(24, |x, y| offset + DVec3::new(x, y, z));
        let reversed = |points: Vec<DVec3>| points.into_iter().rev().collect::<Vec<_>>();
        let signs = |loops: &[Vec<DVec3>]| Mirrors::of(loops, middle(loops)).signs;
        assert_eq!(signs(&[ring(0.0)]), [-1, -1, 1]);
        assert_eq!(signs(&[ring(0.0), ring(1.0)]), [-1, -1, 1]);
        assert_eq!(signs(&[ring(0.0), reversed(ring(1.0))]), [-1, -1, -1]);
        // The middle ring would keep its direction, while the other rings would change theirs.
        assert_eq!(signs(&[ring(0.0), ring(0.5), reversed(ring(1.0))]), [-1, -1, 0]);
        // This curve has half turns as symmetries, but no reflection.
        assert_eq!(signs(&[circle(24, |x, y| DVec3::new(x, y, x * y))]), [0, 0, 0]);
        assert_eq!(signs(&[circle(24, |x, y| DVec3::new(x, y, x * x))]), [-1, -1, 0]);
        assert_eq!(signs(&[circle(24, |x, y| DVec3::new(x + 0.01 * y, y, x * x))]), [0, 0, 0]);
        // Rounded coordinates keep their symmetry only up to the rounding.
        let rounded = |p: DVec3| (p * 1e3).round() * 1e-3;
        assert_eq!(signs(&[circle(24, |x, y| offset + rounded(DVec3::new(x, y, x * x)))]), [-1, -1, 0]);
        // In this position a regular polygon of 23 sides has only one coordinate plane of symmetry.
        assert_eq!(signs(&[circle(23, |x, y| DVec3::new(x, y, x * x))]), [0, -1, 0]);
    }

    #[test]
    fn planes_of_symmetry_in_any_direction_become_planes_across_the_axes() {
        let x = DVec3::new(0.6, -0.3, 0.5).normalize();
        let y = x.cross(DVec3::new(0.1, 0.9, 0.2)).normalize();
        let turned = |p: DVec3| x * p.x + y * p.y + x.cross(y) * p.z + DVec3::new(3e4, -5e4, 120.0);
        let axes_of = |loops: &[Vec<DVec3>]| Axes::of(loops, &Execution::default()).unwrap();
        let planes = |shape: &dyn Fn(f64, f64) -> DVec3, points: usize| {
            let loops = [circle(points, |x, y| turned(shape(x, y)))];
            assert_eq!(Mirrors::of(&loops, middle(&loops)).images(), 1);
            let found = axes_of(&loops)?;
            assert!(found.enlargement().high < 1.0 + 1e-14);
            let placed = loops.map(|points| points.iter().map(|&p| place(Some(&found), p)).collect::<Vec<_>>());
            for (found_at, given) in placed[0].iter().zip(circle(points, shape)) {
                let centre = place(Some(&found), turned(DVec3::ZERO));
                assert!((found_at.distance(centre) - given.length()).abs() < 1e-10);
            }
            let mut signs = Mirrors::of(&placed, DVec3::ZERO).signs;
            signs.sort_unstable();
            Some(signs)
        };
        assert_eq!(planes(&|x, y| DVec3::new(x, 2.0 * y, 0.0), 40), Some([-1, -1, 1]));
        assert_eq!(planes(&|x, y| DVec3::new(x, y, x * x), 40), Some([-1, -1, 0]));
        assert_eq!(planes(&|x, y| DVec3::new(x, y, x * x), 23), Some([-1, 0, 0]));
        // The first and the second point lie in one plane of symmetry.
        assert_eq!(planes(&|x, y| DVec3::new(5.0 * x, y, 2.0 * x * x), 12), Some([-1, -1, 0]));
        assert_eq!(planes(&|x, y| DVec3::new(5.0 * x, y, x * x + x), 12), Some([-1, 0, 0]));
        assert_eq!(planes(&|x, y| DVec3::new(x, y, x * y * (2.0 + x)), 40), None);
        let rounded: Vec<DVec3> = circle(96, |x, y| (2e3 * turned(DVec3::new(x, y, x * x))).round());
        let found = axes_of(std::slice::from_ref(&rounded)).unwrap();
        let placed: Vec<DVec3> = rounded.iter().map(|&p| place(Some(&found), p)).collect();
        assert_eq!(Mirrors::of(&[placed], DVec3::ZERO).images(), 4);
        // No axes are returned if the given axes have as many planes of symmetry.
        assert_eq!(axes_of(&[circle(24, |x, y| DVec3::new(x, y, x * x))]), None);
        assert!(axes_of(&[circle(24, |x, y| DVec3::new(x, y, x * y))]).is_some());
    }
}
