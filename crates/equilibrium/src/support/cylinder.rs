//! A round cylinder as a support.

use super::{AreaBeside, AreaPart, Support, outward};
use crate::energy::outer;
use plateau_mesh::DVec3;
use std::sync::Arc;

/// A round cylinder around the line through `point` along `axis`. Its normal points outward. II(u, v) = -(u⊥·v⊥) (x -
/// point)⊥ / r², where ⊥ denotes the part of a vector at right angles to the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// A point of the axis.
    pub point: DVec3,
    /// The axis's unit direction.
    pub axis: DVec3,
    /// r, the radius.
    pub radius: f64,
}

impl Support for Cylinder {
    fn is_sound(&self) -> bool {
        self.axis.is_normalized() && self.radius > 0.0
    }

    fn dimension(&self) -> u8 {
        2
    }

    fn nearest(&self, x: DVec3) -> DVec3 {
        let along = self.axis * (x - self.point).dot(self.axis);
        let outward = (x - self.point - along).normalize_or(self.axis.any_orthonormal_vector());
        self.point + along + self.radius * outward
    }

    fn tangents(&self, x: DVec3) -> [DVec3; 2] {
        [self.axis, self.axis.cross(self.normal(x))]
    }

    fn normal(&self, x: DVec3) -> DVec3 {
        outward(x, self.point, self.axis)
    }

    fn second_fundamental_form(&self, x: DVec3, u: DVec3, v: DVec3) -> DVec3 {
        let across = |vector: DVec3| vector.reject_from_normalized(self.axis);
        across(x - self.point) * (-across(u).dot(across(v)) / (self.radius * self.radius))
    }

    fn moved(&self, by: DVec3) -> Arc<dyn Support> {
        Arc::new(Self { point: self.point + by, ..*self })
    }

    fn area_beside(&self, _edge: &[DVec3]) -> Option<Arc<dyn AreaBeside>> {
        Some(Arc::new(*self))
    }
}

/// The area on the unrolled cylinder between the segment, drawn as a helix, and the height of `point`: -r (φ_b - φ_a)
/// (z_a + z_b) / 2 with the angles φ around the axis and the heights z along it.
impl AreaBeside for Cylinder {
    fn part(&self, a: DVec3, b: DVec3) -> AreaPart {
        let Self { point, axis, radius } = *self;
        // Returns the part of x - point across the axis, the height of x, and the first and second derivatives of its
        // angle.
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
        AreaPart {
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
