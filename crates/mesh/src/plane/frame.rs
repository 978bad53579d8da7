//! Orthonormal frames of planes in space.

use super::polygon::doubled_area_vector;
use crate::polyline::mean;
use crate::{DVec2, DVec3};

/// Smallest length of the area vector of a loop that encloses an area, as a fraction of the square of the loop's size.
const SMALLEST_AREA_VECTOR: f64 = 1e-10;

/// A plane with its axes: the point (x, y) of the plane stands at `origin + x · self.x + y · self.y`.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub origin: DVec3,
    pub x: DVec3,
    pub y: DVec3,
    /// x × y.
    pub normal: DVec3,
}

impl Frame {
    /// The plane through the mean of a closed loop whose normal is the loop's area vector (Newell's normal). The x axis
    /// follows the first side, so that the frame turns with the loop. `None` if the loop encloses no area.
    #[inline]
    pub fn of_loop(points: &[DVec3]) -> Option<Self> {
        let origin = mean(points);
        let size = points.iter().map(|p| (*p - origin).abs().max_element()).fold(0.0, f64::max);
        let area_vector = doubled_area_vector(points);
        let normal = (area_vector.length() > SMALLEST_AREA_VECTOR * size * size).then(|| area_vector.normalize())?;
        let edge = (points[1] - points[0]) / size;
        // If the first side runs along the normal, its part in the plane is only noise. Then any direction in the plane
        // will do.
        let x = (edge - normal * normal.dot(edge)).try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
        Some(Self { origin, x, y: normal.cross(x), normal })
    }

    /// The frame of the plane through the origin with this unit normal. Its axes have any direction in the plane.
    #[inline]
    pub fn with_normal(normal: DVec3) -> Self {
        let x = normal.any_orthonormal_vector();
        Self { origin: DVec3::ZERO, x, y: normal.cross(x), normal }
    }

    /// The coordinates of a direction (or of a point, relative to the origin) in the plane.
    #[inline]
    pub fn coordinates(&self, direction: DVec3) -> DVec2 {
        DVec2::new(direction.dot(self.x), direction.dot(self.y))
    }

    /// The direction in space that has these coordinates.
    #[inline]
    pub fn direction(&self, p: DVec2) -> DVec3 {
        p.x * self.x + p.y * self.y
    }

    /// The coordinates, in the plane, of the point's perpendicular projection onto the plane.
    #[inline]
    pub fn project(&self, point: DVec3) -> DVec2 {
        self.coordinates(point - self.origin)
    }

    /// The point of the plane that has these coordinates.
    #[inline]
    pub fn lift(&self, p: DVec2) -> DVec3 {
        self.origin + p.x * self.x + p.y * self.y
    }

    /// The nearest point of the plane: the perpendicular projection.
    #[inline]
    pub fn foot(&self, point: DVec3) -> DVec3 {
        point - (point - self.origin).dot(self.normal) * self.normal
    }

    /// Distance of a point from the plane.
    #[inline]
    pub fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.normal).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frame_of_a_loop_follows_its_first_side_and_its_sense() {
        let points = [[1.0, 0.0, 2.0], [1.0, 3.0, 2.0], [0.0, 3.0, 2.0], [0.0, 0.0, 2.0]].map(DVec3::from);
        let frame = Frame::of_loop(&points).unwrap();
        assert!(frame.x.distance(DVec3::Y) < 1e-15 && frame.normal.distance(DVec3::Z) < 1e-15);
        assert!(frame.y.distance(DVec3::NEG_X) < 1e-15 && points.iter().all(|&p| frame.height(p) < 1e-15));
        let there = frame.coordinates(points[2] - frame.origin);
        assert!((frame.origin + frame.direction(there)).distance(points[2]) < 1e-15);
        assert!(Frame::of_loop(&[points[0], points[1], points[0]]).is_none());
    }
}
