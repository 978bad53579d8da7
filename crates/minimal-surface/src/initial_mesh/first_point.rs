//! Chooses the point at which a closed boundary begins while its initial mesh is made.
//!
//! The axes of the best plane, the start of a circle and the matching of two loops depend on the first point of a
//! boundary. The list that a client sends may begin anywhere. Therefore the shape of the boundary determines the first
//! point, and afterwards the vertices are renumbered in the order of the client's list.

use plateau_mesh::film::Film;
use plateau_mesh::{DVec3, polyline};

/// Largest difference of two distances that count as equal, as a fraction of the boundary's radius. It is far above
/// rounding, and equals the distance up to which neighbouring points count as one.
const EQUAL: f64 = polyline::SAME_POINT;

/// Returns the index of a point that the shape of a closed polygon singles out: the point farthest from the mean of the
/// points.
///
/// Ties between equally far points are broken by the distances to the points 1, 2, 4, … places away. The larger of the
/// distances ahead and behind is compared first, then the smaller, and in the end the distances ahead. The choice does
/// not depend on rotation, translation, scale or the first point of the list. Reversing the list changes it only if the
/// distances ahead decide. If several points are equal in all of this, like the corners of a square, the first of them
/// is returned. O(n log n).
pub(crate) fn first_point(points: &[DVec3]) -> usize {
    let n = points.len();
    let centre = polyline::mean(points);
    let tolerance = EQUAL * polyline::radius(points);
    let mut candidates: Vec<usize> = (0..n).collect();
    let mut keep_largest = |measure: &dyn Fn(usize) -> f64| {
        if candidates.len() > 1 {
            let largest = candidates.iter().map(|&k| measure(k)).fold(f64::NEG_INFINITY, f64::max);
            candidates.retain(|&k| measure(k) >= largest - tolerance);
        }
    };
    keep_largest(&|k| points[k].distance(centre));
    let strides = || std::iter::successors(Some(1), |stride| Some(2 * stride)).take_while(|stride| 2 * stride <= n);
    let ahead = |k: usize, stride: usize| points[k].distance(points[(k + stride) % n]);
    let behind = |k: usize, stride: usize| ahead((k + n - stride) % n, stride);
    for stride in strides() {
        keep_largest(&|k| ahead(k, stride).max(behind(k, stride)));
        keep_largest(&|k| ahead(k, stride).min(behind(k, stride)));
    }
    for stride in strides() {
        keep_largest(&|k| ahead(k, stride));
    }
    candidates.first().copied().unwrap_or(0)
}

/// Rotates each boundary so that it begins at its [`first_point`]. Also returns the indices of these points.
pub(crate) fn turned(boundaries: &[Vec<DVec3>]) -> (Vec<Vec<DVec3>>, Vec<usize>) {
    let firsts: Vec<usize> = boundaries.iter().map(|points| first_point(points)).collect();
    let mut turned = boundaries.to_vec();
    turned.iter_mut().zip(&firsts).for_each(|(points, &first)| points.rotate_left(first));
    (turned, firsts)
}

/// Converts a film over [`turned`] boundaries into a film over the boundaries themselves. Its first vertices are the
/// boundaries' points in the given order, and each boundary loop begins at the first of its points.
pub(super) fn turned_back(film: Film, boundaries: &[Vec<DVec3>], firsts: &[usize]) -> Film {
    let mut place: Vec<u32> = (0..film.vertices.len() as u32).collect();
    let mut starts = Vec::with_capacity(boundaries.len());
    let mut start = 0;
    for (points, first) in boundaries.iter().zip(firsts) {
        let n = points.len();
        (0..n).for_each(|k| place[start + k] = (start + (first + k) % n) as u32);
        starts.push(start as u32);
        start += n;
    }
    let mut film = film.renumbered(&place);
    for (boundary, start) in film.boundaries.iter_mut().zip(starts) {
        let at = boundary.iter().position(|&v| v == start).expect("a boundary point stays a vertex of its loop");
        boundary.rotate_left(at);
    }
    film
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;
    use plateau_mesh::random::SplitMix64;

    fn chosen(points: &[DVec3]) -> DVec3 {
        points[first_point(points)]
    }

    #[test]
    fn motions_scales_directions_and_first_points_do_not_change_the_choice() {
        let mut random = SplitMix64::new(42);
        for case in 0..200 {
            let n = 5 + case % 40;
            let on_circle = case % 2 == 0;
            let mut any = |low: f64, high: f64| random.between(low, high);
            let mut angle = 0.0;
            // In every second case all points are equally far from the origin, though not from their mean.
            let point = |_| {
                angle += any(0.2, 1.0) * std::f64::consts::TAU / n as f64;
                let (radius, height) = if on_circle { (1.0, 0.0) } else { (any(0.5, 1.0), any(-1.0, 1.0)) };
                DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), height)
            };
            let points: Vec<DVec3> = (0..n).map(point).collect();
            let expected = chosen(&points);
            let turn = DQuat::from_euler(glam::EulerRot::XYZ, any(0.0, 6.0), any(0.0, 6.0), any(0.0, 6.0));
            let moved = |p: DVec3| 37.0 * (turn * p) + DVec3::new(100.0, -50.0, 7.0);
            for first in 0..n {
                let mut points = points.clone();
                points.rotate_left(first);
                assert_eq!(chosen(&points), expected, "{case} from {first}");
                let there: Vec<DVec3> = points.iter().map(|&p| moved(p)).collect();
                assert_eq!(chosen(&there), moved(expected), "{case} from {first}, moved");
                points.reverse();
                assert_eq!(chosen(&points), expected, "{case} from {first}, reversed");
            }
        }
    }

    #[test]
    fn equally_far_points_are_told_apart_by_their_neighbours() {
        // A rectangle of 3 by 5 pieces has four equally far corners. The choice is one with the longer side ahead.
        let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 5.0), (0.0, 5.0)];
        let mut points = Vec::new();
        for (k, pieces) in [3, 5, 3, 5].into_iter().enumerate() {
            let at = |k: usize| DVec3::new(corners[k % 4].0, corners[k % 4].1, 0.0);
            points.extend((0..pieces).map(|i| at(k).lerp(at(k + 1), f64::from(i) / f64::from(pieces))));
        }
        for _ in 0..16 {
            let first = chosen(&points);
            assert!(first == DVec3::new(3.0, 0.0, 0.0) || first == DVec3::new(0.0, 5.0, 0.0), "{first}");
            points.rotate_left(1);
        }
    }
}
