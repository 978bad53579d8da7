//! Polygons in the plane: closed lists of points that do not repeat the first one.

use super::triangulation::side;
use crate::polyline::mean;
use crate::{DVec2, DVec3};

/// Twice the area vector of a closed polyline in space (Newell). If the polyline lies in a plane, the vector is normal
/// to the plane and its length is twice the enclosed area. The sum is taken about the mean of the points, so that a
/// large distance from the origin loses no digits.
#[inline]
pub fn doubled_area_vector(points: &[DVec3]) -> DVec3 {
    let centre = mean(points);
    (0..points.len()).map(|k| (points[k] - centre).cross(points[(k + 1) % points.len()] - centre)).sum()
}

/// Twice the signed area about the point `origin`, positive for a counter-clockwise polygon.
#[inline]
pub fn doubled_area(points: impl Iterator<Item = DVec2> + Clone, origin: DVec2) -> f64 {
    let next = points.clone().skip(1).chain(points.clone().take(1));
    points.zip(next).map(|(a, b)| (a - origin).perp_dot(b - origin)).sum()
}

/// For each point, whether it lies inside the closed polygons, by the parity of the crossings of a ray. The points must
/// be sorted by y.
pub fn inside(loops: &[Vec<DVec2>], points: &[DVec2]) -> Vec<bool> {
    let mut segments: Vec<(DVec2, DVec2)> = Vec::new();
    for points in loops {
        for (k, &a) in points.iter().enumerate() {
            let b = points[(k + 1) % points.len()];
            segments.push(if a.y <= b.y { (a, b) } else { (b, a) });
        }
    }
    segments.sort_by(|s, t| s.0.y.total_cmp(&t.0.y));
    let (mut next, mut active): (usize, Vec<(DVec2, DVec2)>) = (0, Vec::new());
    let mut crossings: Vec<f64> = Vec::new();
    let mut row = f64::NEG_INFINITY;
    points
        .iter()
        .map(|point| {
            if point.y > row {
                row = point.y;
                while next < segments.len() && segments[next].0.y <= row {
                    active.push(segments[next]);
                    next += 1;
                }
                active.retain(|(_, upper)| upper.y > row);
                crossings.clear();
                crossings.extend(active.iter().map(|(a, b)| a.x + (b.x - a.x) * ((row - a.y) / (b.y - a.y))));
                crossings.sort_by(f64::total_cmp);
            }
            crossings.partition_point(|&x| x < point.x) % 2 == 1
        })
        .collect()
}

/// Whether a point lies inside a closed polygon, by the parity of the crossings of a ray, with exact predicates. A
/// point on the polygon may count as inside or outside. O(points).
#[inline]
pub fn contains(polygon: &[DVec2], point: DVec2) -> bool {
    let mut inside = false;
    let mut previous = polygon[polygon.len() - 1];
    for &current in polygon {
        if (current.y > point.y) != (previous.y > point.y) {
            let (low, high) = if current.y > previous.y { (previous, current) } else { (current, previous) };
            inside ^= side(low, high, point) > 0.0;
        }
        previous = current;
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parity_is_that_of_a_square_with_a_hole() {
        let at = |x, y| DVec2::new(x, y);
        let square = |low: f64, high: f64| vec![at(low, low), at(high, low), at(high, high), at(low, high)];
        let points =
            [at(-1.0, 0.1), at(0.1, 0.1), at(0.5, 0.1), at(0.1, 0.5), at(0.5, 0.5), at(0.9, 0.5), at(1.1, 0.5)];
        let expected = [false, true, true, true, false, true, false];
        assert_eq!(inside(&[square(0.0, 1.0), square(0.3, 0.7)], &points), expected);
    }
}
