//! Polygons in the plane: closed lists of points that do not repeat the first one.

use crate::DVec2;

/// Twice the signed area about the point `origin`, positive for a counter-clockwise polygon.
pub(crate) fn doubled_area(points: impl Iterator<Item = DVec2> + Clone, origin: DVec2) -> f64 {
    let next = points.clone().skip(1).chain(points.clone().take(1));
    points.zip(next).map(|(a, b)| (a - origin).perp_dot(b - origin)).sum()
}
