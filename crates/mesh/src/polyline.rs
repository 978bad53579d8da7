//! Polylines: points in order, open or closed. A closed polyline does not repeat its first point.

pub mod contact;

use crate::DVec3;

/// Largest absolute coordinate that is accepted. Larger coordinates could overflow where six lengths are multiplied,
/// for example in the square of an area times the square of a length.
pub const LARGEST_COORDINATE: f64 = 1e50;

/// A polyline whose neighbouring points are distinct, and the mapping between its points and the input points.
#[derive(Clone, Debug, PartialEq)]
pub struct Merged {
    /// The points that were kept, in order.
    pub points: Vec<DVec3>,
    /// `vertex_of[k]` is the index in `points` of input point `k`.
    pub vertex_of: Vec<usize>,
    /// For each kept point, the index of its input point: the first of those that were merged into it.
    pub source: Vec<usize>,
}

impl Merged {
    /// Number of input points that were merged into another point.
    #[must_use]
    #[inline]
    pub fn dropped(&self) -> usize {
        self.vertex_of.len() - self.points.len()
    }
}

/// Neighbouring points nearer than this fraction of the polyline's radius count as one point. If a closed curve is
/// sampled including its end point, the last point repeats the first up to rounding, about 1e-16 of the radius. An
/// intended edge is far longer.
pub const SAME_POINT: f64 = 1e-9;

/// Merges each run of neighbouring points that are equal or nearer than [`SAME_POINT`] times the [`radius`] into its
/// first point. On a closed polyline, last points that are as near to the first point are merged into it.
///
/// A point is compared with the last point that was kept, so that many small steps in a row add up to an edge. If all
/// points are equal, one point is left.
#[must_use]
pub fn merge_near_neighbours(input: &[DVec3], closed: bool) -> Merged {
    let tolerance = SAME_POINT * radius(input);
    let same = |a: DVec3, b: DVec3| a == b || a.distance(b) < tolerance;
    let mut points: Vec<DVec3> = Vec::with_capacity(input.len());
    let mut vertex_of = Vec::with_capacity(input.len());
    let mut source = Vec::with_capacity(input.len());
    for (k, &point) in input.iter().enumerate() {
        if points.last().is_none_or(|&last| !same(last, point)) {
            points.push(point);
            source.push(k);
        }
        vertex_of.push(points.len() - 1);
    }
    if closed {
        // At most one pass per point, because each pass removes one.
        while points.len() > 1 && same(points[0], points[points.len() - 1]) {
            points.pop();
            source.pop();
        }
        vertex_of.iter_mut().filter(|vertex| **vertex >= points.len()).for_each(|vertex| *vertex = 0);
    }
    Merged { points, vertex_of, source }
}

/// The largest distance of a point from the [`mean`] of the points. Zero if there are no points.
#[must_use]
#[inline]
pub fn radius(points: &[DVec3]) -> f64 {
    let centre = mean(points);
    points.iter().map(|point| point.distance(centre)).fold(0.0, f64::max)
}

/// The length of a polyline, in the unit of its coordinates. For a closed polyline it includes the closing segment.
#[must_use]
#[inline]
pub fn length(points: &[DVec3], closed: bool) -> f64 {
    let open: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    match (closed, points.first(), points.last()) {
        (true, Some(first), Some(last)) => open + last.distance(*first),
        _ => open,
    }
}

/// A key for sorting points: the bits of the coordinates. Equal points have equal keys, because -0 is turned into 0.
#[must_use]
#[inline]
pub fn position_key(point: DVec3) -> [u64; 3] {
    (point + DVec3::ZERO).to_array().map(f64::to_bits)
}

/// The mean of the points. Zero if there are no points.
#[must_use]
#[inline]
pub fn mean(points: &[DVec3]) -> DVec3 {
    let Some(&first) = points.first() else { return DVec3::ZERO };
    // Differences from the first point are summed, so that points as far as 1e7 from the origin lose no digits.
    first + points.iter().map(|point| *point - first).sum::<DVec3>() / points.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64) -> DVec3 {
        DVec3::new(x, 0.0, 0.0)
    }

    #[test]
    fn equal_neighbours_merge_and_map_back() {
        let merged = merge_near_neighbours(&[p(0.0), p(0.0), p(1.0), p(2.0), p(2.0), p(0.0), p(0.0)], true);
        assert_eq!(merged.points, [p(0.0), p(1.0), p(2.0)]);
        assert_eq!(merged.vertex_of, [0, 0, 1, 2, 2, 0, 0]);
        assert_eq!(merged.source, [0, 2, 3]);
        assert_eq!(merged.dropped(), 4);
    }

    #[test]
    fn an_open_polyline_keeps_its_returning_end() {
        let merged = merge_near_neighbours(&[p(0.0), p(1.0), p(0.0)], false);
        assert_eq!(merged.vertex_of, [0, 1, 2]);
    }

    #[test]
    fn neighbours_apart_by_rounding_merge_and_others_do_not() {
        let circle = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / 100.0;
            1e3 * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
        };
        // The end point of a full turn: 2.4e-13 from the first point.
        let with_its_end: Vec<DVec3> = (0..=100).map(circle).collect();
        assert_ne!(with_its_end[0], with_its_end[100]);
        let merged = merge_near_neighbours(&with_its_end, true);
        assert_eq!((merged.points.len(), merged.vertex_of[100]), (100, 0));
        assert_eq!(merge_near_neighbours(&with_its_end, false).points.len(), 101);
        let mut near = with_its_end.clone();
        near[100] += DVec3::Y * 1.1e-6;
        assert_eq!(merge_near_neighbours(&near, true).points.len(), 101);
    }

    #[test]
    fn small_steps_add_up() {
        let steps: Vec<DVec3> = (0..=1000).map(|k| p(f64::from(k) * 1e-10)).chain([p(1.0), p(2.0)]).collect();
        let merged = merge_near_neighbours(&steps, false);
        // The radius is about 2.
        assert!(merged.points.len() > 40 && merged.points.len() < 60, "{}", merged.points.len());
        assert!(steps.iter().zip(&merged.vertex_of).all(|(step, &v)| merged.points[v].distance(*step) < 2.1e-9));
    }

    /// Input: the last two points are on opposite sides of the first point, each near the first point but not near the
    /// other. Both must refer to the first point in `vertex_of`, and not to a point that was removed.
    #[test]
    fn several_last_points_merge_into_the_first() {
        let near = |offset: f64| DVec3::new(1.0, offset, 0.0);
        let input = [near(0.0), DVec3::Y, -DVec3::X, -DVec3::Y, near(0.9e-9), near(-0.9e-9)];
        let merged = merge_near_neighbours(&input, true);
        assert_eq!((merged.points.len(), merged.vertex_of), (4, vec![0, 1, 2, 3, 0, 0]));
    }

    #[test]
    fn all_points_equal_give_one() {
        let merged = merge_near_neighbours(&[p(3.0); 4], true);
        assert_eq!((merged.points.len(), merged.vertex_of), (1, vec![0; 4]));
    }

    #[test]
    fn length_counts_the_closing_segment_of_a_closed_polyline() {
        assert_eq!(length(&[p(0.0), p(1.0), p(3.0)], false), 3.0);
        assert_eq!(length(&[p(0.0), p(1.0), p(3.0)], true), 6.0);
    }
}
