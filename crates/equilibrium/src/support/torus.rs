//! A torus as a support, such as a ring beam made of round tube.

use super::{Support, outward};
use plateau_mesh::DVec3;
use std::sync::Arc;

/// A torus: the points at the distance r (`tube_radius`) from a circle of radius R (`radius`), which lies in the plane
/// across `axis`. The normal n points out of the tube.
///
/// ```text
/// II(u, v) = -n ((u·e) (v·e) (n·o) / ϱ + (u·m) (v·m) / r)
/// ```
///
/// At a point of the torus, o is the unit direction away from the axis, e = axis × o the direction around the axis, and
/// m = n × e the direction around the tube. ϱ = R + r n·o is the distance of the point from the axis. Source: do Carmo,
/// *Differential Geometry of Curves and Surfaces* (1976), section 3-3, example 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    /// The centre.
    pub centre: DVec3,
    /// The unit direction of the axis.
    pub axis: DVec3,
    /// R, the radius of the circle inside the tube.
    pub radius: f64,
    /// r < R, the radius of the tube.
    pub tube_radius: f64,
}

impl Torus {
    /// Returns the direction o away from the axis at `x`, and the point of the circle inside the tube that is nearest
    /// to `x`.
    fn ring(&self, x: DVec3) -> (DVec3, DVec3) {
        let outward = outward(x, self.centre, self.axis);
        (outward, self.centre + self.radius * outward)
    }
}

impl Support for Torus {
    fn is_sound(&self) -> bool {
        self.axis.is_normalized() && self.tube_radius > 0.0 && self.tube_radius < self.radius
    }

    fn dimension(&self) -> u8 {
        2
    }

    fn nearest(&self, x: DVec3) -> DVec3 {
        self.ring(x).1 + self.tube_radius * self.normal(x)
    }

    fn tangents(&self, x: DVec3) -> [DVec3; 2] {
        let around = self.axis.cross(self.ring(x).0);
        [around, self.normal(x).cross(around)]
    }

    fn normal(&self, x: DVec3) -> DVec3 {
        (x - self.ring(x).1).normalize_or(self.axis)
    }

    fn second_fundamental_form(&self, x: DVec3, u: DVec3, v: DVec3) -> DVec3 {
        let (outward, _) = self.ring(x);
        let (normal, [around, along]) = (self.normal(x), self.tangents(x));
        let from_axis = self.radius + self.tube_radius * normal.dot(outward);
        let around = u.dot(around) * v.dot(around) * normal.dot(outward) / from_axis;
        normal * -(around + u.dot(along) * v.dot(along) / self.tube_radius)
    }

    fn moved(&self, by: DVec3) -> Arc<dyn Support> {
        Arc::new(Self { centre: self.centre + by, ..*self })
    }
}
