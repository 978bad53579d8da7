//! Axis-aligned boxes, for bounding-volume trees over triangles and segments.

use crate::DVec3;

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisBox {
    pub low: DVec3,
    pub high: DVec3,
}

impl AxisBox {
    /// The empty box, which contains no point.
    pub const EMPTY: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The smallest box around points.
    #[inline]
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |whole, p| Self { low: whole.low.min(p), high: whole.high.max(p) })
    }

    /// The smallest box around both boxes.
    #[must_use]
    #[inline]
    pub fn with(&self, other: &Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    #[must_use]
    #[inline]
    pub fn centre(&self) -> DVec3 {
        0.5 * (self.low + self.high)
    }

    /// The squared length of the diagonal.
    #[must_use]
    #[inline]
    pub fn size_squared(&self) -> f64 {
        (self.high - self.low).length_squared()
    }

    /// The box that is larger by a margin on every side.
    #[must_use]
    #[inline]
    pub fn widened(&self, margin: f64) -> Self {
        Self { low: self.low - margin, high: self.high + margin }
    }

    /// The corners of a degenerate triangle whose smallest box is this one.
    #[must_use]
    #[inline]
    pub fn ends(&self) -> [DVec3; 3] {
        [self.low, self.high, self.high]
    }

    /// Whether the boxes have a point in common.
    #[must_use]
    #[inline]
    pub fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
            && self.low.z <= other.high.z
            && other.low.z <= self.high.z
    }

    /// The gap between two boxes along the axis where it is largest. Negative if the boxes overlap.
    #[must_use]
    #[inline]
    pub fn gap(&self, other: &Self) -> f64 {
        (self.low - other.high).max(other.low - self.high).max_element()
    }

    /// The squared distance between the box and a point.
    #[must_use]
    #[inline]
    pub fn distance_squared(&self, point: DVec3) -> f64 {
        (self.low - point).max(point - self.high).max(DVec3::ZERO).length_squared()
    }
}
