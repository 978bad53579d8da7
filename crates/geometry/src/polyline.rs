//! Polylines: points in order, open or closed (a closed one does not repeat its first point).

use crate::DVec3;

/// Coordinates beyond this could overflow where six lengths are multiplied, as in the square of an area times a length.
pub const LARGEST_COORDINATE: f64 = 1e50;

/// A polyline without equal neighbours, and where each input point went.
#[derive(Clone, Debug, PartialEq)]
pub struct Merged {
    /// The points that are left, in order.
    pub points: Vec<DVec3>,
    /// `vertex_of[k]` is the index in `points` of input point `k`.
    pub vertex_of: Vec<usize>,
    /// For each kept point the index of the (first) input point it came from.
    pub source: Vec<usize>,
}

impl Merged {
    /// Number of points that were merged away.
    #[must_use]
    pub fn dropped(&self) -> usize {
        self.vertex_of.len() - self.points.len()
    }
}

/// Neighbours nearer than this fraction of the polyline's radius are one point. Sampling a closed curve with its end point
/// repeats the first point up to rounding, about 1e-16 of the radius; an edge that is meant is longer by far.
pub const SAME_POINT: f64 = 1e-9;

/// Merges *exactly* equal neighbours (and, on a closed polyline, a last point equal to the first).
///
/// Nothing is merged by tolerance: points that differ in one bit stay apart. All points equal gives one point.
#[must_use]
pub fn merge_equal_neighbours(input: &[DVec3], closed: bool) -> Merged {
    merge(input, closed, |a, b| a == b)
}

/// Merges neighbours that are equal or nearer than [`SAME_POINT`] of the [`radius`] into the first of them, and on a closed
/// polyline a last point that is as near to the first.
///
/// A point is compared with the last one that was kept, so that many small steps in a row add up to an edge. All points
/// equal gives one point.
#[must_use]
pub fn merge_near_neighbours(input: &[DVec3], closed: bool) -> Merged {
    let tolerance = SAME_POINT * radius(input);
    merge(input, closed, |a, b| a == b || a.distance(b) < tolerance)
}

fn merge(input: &[DVec3], closed: bool, same: impl Fn(DVec3, DVec3) -> bool) -> Merged {
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
        while points.len() > 1 && same(points[0], points[points.len() - 1]) {
            let last = points.len() - 1;
            points.pop();
            source.pop();
            for vertex in vertex_of.iter_mut().rev().take_while(|vertex| **vertex == last) {
                *vertex = 0;
            }
        }
    }
    Merged { points, vertex_of, source }
}

/// The largest distance of a point from the [`mean`]; zero for none.
#[must_use]
pub fn radius(points: &[DVec3]) -> f64 {
    let centre = mean(points);
    points.iter().map(|point| point.distance(centre)).fold(0.0, f64::max)
}

/// Length of the polyline, in its own unit; the closing segment counts on a closed one.
#[must_use]
pub fn length(points: &[DVec3], closed: bool) -> f64 {
    let open: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    match (closed, points.first(), points.last()) {
        (true, Some(first), Some(last)) => open + last.distance(*first),
        _ => open,
    }
}

/// The mean of the points; zero for none.
#[must_use]
pub fn mean(points: &[DVec3]) -> DVec3 {
    let Some(&first) = points.first() else { return DVec3::ZERO };
    // Sum offsets from the first point, so that an offset of 1e7 costs no digits.
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
        let merged = merge_equal_neighbours(&[p(0.0), p(0.0), p(1.0), p(2.0), p(2.0), p(0.0), p(0.0)], true);
        assert_eq!(merged.points, [p(0.0), p(1.0), p(2.0)]);
        assert_eq!(merged.vertex_of, [0, 0, 1, 2, 2, 0, 0]);
        assert_eq!(merged.source, [0, 2, 3]);
        assert_eq!(merged.dropped(), 4);
    }

    #[test]
    fn an_open_polyline_keeps_its_returning_end() {
        let merged = merge_equal_neighbours(&[p(0.0), p(1.0), p(0.0)], false);
        assert_eq!(merged.vertex_of, [0, 1, 2]);
    }

    #[test]
    fn all_points_equal_give_one() {
        let merged = merge_equal_neighbours(&[p(3.0); 4], true);
        assert_eq!((merged.points.len(), merged.vertex_of), (1, vec![0; 4]));
    }

    #[test]
    fn length_counts_the_closing_segment_of_a_closed_polyline() {
        assert_eq!(length(&[p(0.0), p(1.0), p(3.0)], false), 3.0);
        assert_eq!(length(&[p(0.0), p(1.0), p(3.0)], true), 6.0);
    }
}
