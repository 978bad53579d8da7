//! A straight line as a support.

use super::Support;
use plateau_mesh::DVec3;
use std::sync::Arc;

/// A straight line. II = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StraightLine {
    /// A point of the line.
    pub point: DVec3,
    /// Its unit direction.
    pub direction: DVec3,
}

impl Support for StraightLine {
    fn is_sound(&self) -> bool {
        self.direction.is_normalized()
    }

    fn dimension(&self) -> u8 {
        1
    }

    fn nearest(&self, x: DVec3) -> DVec3 {
        self.point + self.direction * (x - self.point).dot(self.direction)
    }

    fn tangents(&self, _x: DVec3) -> [DVec3; 2] {
        [self.direction, DVec3::ZERO]
    }

    fn is_flat(&self) -> bool {
        true
    }

    fn moved(&self, by: DVec3) -> Arc<dyn Support> {
        Arc::new(Self { point: self.point + by, ..*self })
    }
}
