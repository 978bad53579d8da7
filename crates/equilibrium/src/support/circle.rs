//! A circle as a support.

use super::{Support, outward};
use plateau_mesh::DVec3;
use std::sync::Arc;

/// A circle in the plane through its centre at right angles to `axis`. II(u, v) = -(u·v) (x - centre) / r².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// The centre.
    pub centre: DVec3,
    /// The unit normal of the circle's plane.
    pub axis: DVec3,
    /// r, the radius.
    pub radius: f64,
}

impl Support for Circle {
    fn is_sound(&self) -> bool {
        self.axis.is_normalized() && self.radius > 0.0
    }

    fn dimension(&self) -> u8 {
        1
    }

    fn nearest(&self, x: DVec3) -> DVec3 {
        self.centre + self.radius * outward(x, self.centre, self.axis)
    }

    fn tangents(&self, x: DVec3) -> [DVec3; 2] {
        [self.axis.cross(x - self.centre).normalize_or_zero(), DVec3::ZERO]
    }

    fn second_fundamental_form(&self, x: DVec3, u: DVec3, v: DVec3) -> DVec3 {
        (x - self.centre) * (-u.dot(v) / (self.radius * self.radius))
    }

    fn moved(&self, by: DVec3) -> Arc<dyn Support> {
        Arc::new(Self { centre: self.centre + by, ..*self })
    }
}
