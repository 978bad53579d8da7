//! A plane as a support.

use super::{AreaBeside, AreaPart, Support};
use crate::energy::volume::cross_matrix;
use glam::DMat3;
use plateau_mesh::DVec3;
use std::sync::Arc;

/// A plane. II = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: DVec3,
    /// Its unit normal.
    pub normal: DVec3,
}

impl Support for Plane {
    fn is_sound(&self) -> bool {
        self.normal.is_normalized()
    }

    fn dimension(&self) -> u8 {
        2
    }

    fn nearest(&self, x: DVec3) -> DVec3 {
        x - self.normal * (x - self.point).dot(self.normal)
    }

    fn tangents(&self, _x: DVec3) -> [DVec3; 2] {
        self.normal.any_orthonormal_pair().into()
    }

    fn normal(&self, _x: DVec3) -> DVec3 {
        self.normal
    }

    fn is_flat(&self) -> bool {
        true
    }

    fn moved(&self, by: DVec3) -> Arc<dyn Support> {
        Arc::new(Self { point: self.point + by, ..*self })
    }

    fn area_beside(&self, _edge: &[DVec3]) -> Option<Arc<dyn AreaBeside>> {
        Some(Arc::new(*self))
    }
}

/// The triangle over a straight segment: n · ((a - p) × (b - p)) / 2.
impl AreaBeside for Plane {
    fn part(&self, a: DVec3, b: DVec3) -> AreaPart {
        let Self { point, normal } = *self;
        let (a, b) = (a - point, b - point);
        AreaPart {
            area: 0.5 * normal.dot(a.cross(b)),
            gradient: [0.5 * b.cross(normal), 0.5 * normal.cross(a)],
            // ∂/∂b (b × n) / 2 = -[n]× / 2.
            second: [DMat3::ZERO, cross_matrix(normal) * -0.5, DMat3::ZERO],
        }
    }
}
