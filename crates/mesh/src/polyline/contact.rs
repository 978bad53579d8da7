//! Finds where polylines meet: two segments whose distance is at most a tolerance.
//!
//! Each polyline has a binary tree of boxes around runs of consecutive segments. If two boxes are farther apart than
//! the tolerance, all pairs of their segments are skipped. Otherwise the box with more segments is halved. Polylines
//! that stay apart take O(n log n) operations.

use crate::DVec3;
use crate::axis_box::AxisBox;
use crate::box_tree::{RUN, Run};
use crate::execution::{Execution, Interruption};

/// Number of pairs of boxes between two calls of [`Execution::look`].
const PAIRS_PER_LOOK: u64 = 4096;

/// Two segments that meet. The number of a segment is that of its first point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeetingSegments {
    /// Number of the first segment.
    pub first: usize,
    /// Number of the second segment.
    pub second: usize,
    /// The point of the first segment that is nearest to the second.
    pub point: DVec3,
}

/// A polyline with its tree of boxes.
#[derive(Clone, Debug)]
pub struct Segments<'p> {
    points: &'p [DVec3],
    count: usize,
    /// The boxes of the binary tree. Box 1 contains all segments; the halves of box k are the boxes 2 k and 2 k + 1.
    boxes: Vec<AxisBox>,
}

impl<'p> Segments<'p> {
    /// The segments of a polyline of two or more points.
    pub fn new(points: &'p [DVec3], closed: bool) -> Self {
        let count = if closed { points.len() } else { points.len() - 1 };
        let mut segments = Self { points, count, boxes: vec![AxisBox::EMPTY; 4 * count.div_ceil(RUN)] };
        segments.enclose(Run::whole(count));
        segments
    }

    fn segment(&self, k: usize) -> [DVec3; 2] {
        [self.points[k], self.points[(k + 1) % self.points.len()]]
    }

    fn enclose(&mut self, run: Run) -> AxisBox {
        let found = if run.to - run.from <= RUN {
            AxisBox::around((run.from..run.to).flat_map(|k| self.segment(k)))
        } else {
            let [begin, end] = run.halves().map(|half| self.enclose(half));
            begin.with(&end)
        };
        self.boxes[run.node] = found;
        found
    }
}

/// The first pair of segments that are at most `tolerance` apart and that `counts` accepts. Pairs are tried in the
/// order of the boxes of the first polyline.
///
/// # Errors
/// The interruptions of `exec`.
pub fn first_contact(
    first: &Segments<'_>,
    second: &Segments<'_>,
    tolerance: f64,
    counts: impl Fn(&MeetingSegments) -> bool,
    exec: &Execution<'_>,
) -> Result<Option<MeetingSegments>, Interruption> {
    let mut pairs = vec![[Run::whole(first.count), Run::whole(second.count)]];
    let mut tried = 0;
    while let Some([a, b]) = pairs.pop() {
        tried += 1;
        if tried % PAIRS_PER_LOOK == 0 {
            exec.look(PAIRS_PER_LOOK)?;
        }
        if first.boxes[a.node].gap(&second.boxes[b.node]) > tolerance {
            continue;
        }
        let (long_a, long_b) = (a.to - a.from > RUN, b.to - b.from > RUN);
        if long_a && (!long_b || a.to - a.from >= b.to - b.from) {
            let [begin, end] = a.halves();
            pairs.extend([[end, b], [begin, b]]);
            continue;
        }
        if long_b {
            let [begin, end] = b.halves();
            pairs.extend([[a, end], [a, begin]]);
            continue;
        }
        for k in a.from..a.to {
            for l in b.from..b.to {
                let [near, far] = nearest(first.segment(k), second.segment(l));
                let contact = MeetingSegments { first: k, second: l, point: near };
                if near.distance(far) <= tolerance && counts(&contact) {
                    return Ok(Some(contact));
                }
            }
        }
    }
    Ok(None)
}

/// The nearest points of two segments, one on each (Ericson, *Real-Time Collision Detection*, section 5.1.9).
fn nearest([p, p_end]: [DVec3; 2], [q, q_end]: [DVec3; 2]) -> [DVec3; 2] {
    let (along_p, along_q, between) = (p_end - p, q_end - q, p - q);
    let (a, e, f) = (along_p.length_squared(), along_q.length_squared(), along_q.dot(between));
    let (b, c) = (along_p.dot(along_q), along_p.dot(between));
    let fraction = |numerator: f64, denominator: f64| {
        if denominator > 0.0 { (numerator / denominator).clamp(0.0, 1.0) } else { 0.0 }
    };
    // The determinant of parallel segments is zero. Then any point of the first segment will do.
    let mut s = fraction(b * f - c * e, a * e - b * b);
    let t = if e > 0.0 { (b * s + f) / e } else { 0.0 };
    if t < 0.0 {
        s = fraction(-c, a);
    } else if t > 1.0 {
        s = fraction(b - c, a);
    }
    [p + along_p * s, q + along_q * t.clamp(0.0, 1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(coordinates: &[[f64; 3]]) -> Vec<DVec3> {
        coordinates.iter().copied().map(DVec3::from).collect()
    }

    fn all(_: &MeetingSegments) -> bool {
        true
    }

    #[test]
    fn polylines_that_cross_are_found_where_they_cross() {
        let wave: Vec<DVec3> =
            (0..1000).map(|k| DVec3::new(f64::from(k), libm::sin(0.1 * f64::from(k)), 0.0)).collect();
        let line = points(&[[-1.0, 2.0, 0.0], [700.3, 2.0, 0.0], [700.3, -2.0, 0.0]]);
        let (wave, line) = (Segments::new(&wave, false), Segments::new(&line, false));
        let found = first_contact(&wave, &line, 1e-9, all, &Execution::default()).unwrap().unwrap();
        assert_eq!((found.first, found.second), (700, 1));
        assert!((found.point.x - 700.3).abs() < 1e-9);
        let found = first_contact(&line, &wave, 1e-9, all, &Execution::default()).unwrap().unwrap();
        assert_eq!((found.first, found.second), (1, 700));
    }

    #[test]
    fn polylines_above_each_other_do_not_meet() {
        let below: Vec<DVec3> = (0..500).map(|k| DVec3::new(f64::from(k), f64::from(k % 7), 0.0)).collect();
        let above: Vec<DVec3> = below.iter().map(|p| DVec3::new(p.x, 6.0 - p.y, 1e-6)).collect();
        let (below, above) = (Segments::new(&below, true), Segments::new(&above, true));
        assert_eq!(first_contact(&below, &above, 1e-7, all, &Execution::default()).unwrap(), None);
        assert!(first_contact(&below, &above, 1e-5, all, &Execution::default()).unwrap().is_some());
    }

    #[test]
    fn the_nearest_points_are_those_of_a_search() {
        let mut random = crate::random::SplitMix64::new(7);
        let mut point = || DVec3::new(random.unit(), random.unit(), random.unit());
        for _ in 0..200 {
            let (p, q) = ([point(), point()], [point(), point()]);
            let [near, far] = nearest(p, q);
            let on = |[a, b]: [DVec3; 2], k: i32| a.lerp(b, f64::from(k) / 100.0);
            let searched = (0..=100)
                .flat_map(|k| (0..=100).map(move |l| (k, l)))
                .map(|(k, l)| on(p, k).distance(on(q, l)))
                .fold(f64::INFINITY, f64::min);
            let found = near.distance(far);
            assert!(found <= searched + 1e-12 && found > searched - 0.03, "{found} and {searched}");
        }
        // Parallel segments, and segments of length zero.
        let x = |a: f64, b: f64, y: f64| [DVec3::new(a, y, 0.0), DVec3::new(b, y, 0.0)];
        for (p, q, expected) in [
            (x(0.0, 2.0, 0.0), x(1.0, 3.0, 1.0), 1.0),
            (x(0.0, 1.0, 0.0), x(4.0, 5.0, 4.0), 5.0),
            (x(1.0, 1.0, 0.0), x(1.0, 1.0, 2.0), 2.0),
        ] {
            let [near, far] = nearest(p, q);
            assert_eq!(near.distance(far), expected);
        }
    }
}
