//! Whether two triangles of a flat strip overlap.
//!
//! No triangles overlap if both directrices run in one direction and one lies above the other. Otherwise a tree of
//! bounding polygons over the chain of triangles finds the pairs that may overlap, and a test of separating axes
//! decides each pair.

use super::flat_strip::FlatStrip;
use plateau_mesh::DVec2;
use plateau_mesh::error::Error;
use plateau_mesh::execution::Execution;

/// Depth of an overlap, as a fraction of the pattern's size, up to which it counts as rounding.
pub(crate) const TOLERANCE: f64 = 1e-9;
/// Number of triangles in a leaf of the tree.
const LEAF: usize = 4;
/// Number of directions of the bounding polygons. They are 22.5° apart, so that the polygon of a long thin triangle is
/// narrow at any angle. More directions cost more for each node.
const AXES: usize = 8;

/// A bounding polygon: the extent of a set of points along each axis.
#[derive(Clone, Copy)]
struct Slabs {
    low: [f64; AXES],
    high: [f64; AXES],
}

impl Slabs {
    const EMPTY: Self = Self { low: [f64::INFINITY; AXES], high: [f64::NEG_INFINITY; AXES] };

    fn add(&mut self, point: DVec2, axes: &[DVec2; AXES]) {
        for (k, axis) in axes.iter().enumerate() {
            let along = point.dot(*axis);
            self.low[k] = self.low[k].min(along);
            self.high[k] = self.high[k].max(along);
        }
    }
    fn merge(&self, other: &Self) -> Self {
        let mut both = *self;
        for k in 0..AXES {
            both.low[k] = both.low[k].min(other.low[k]);
            both.high[k] = both.high[k].max(other.high[k]);
        }
        both
    }
    fn apart(&self, other: &Self, tolerance: f64) -> bool {
        (0..AXES).any(|k| self.high[k].min(other.high[k]) - self.low[k].max(other.low[k]) <= tolerance)
    }
}

/// Whether the interiors of any two triangles overlap by more than [`TOLERANCE`] of the pattern's size.
pub(crate) fn overlaps(flat: &FlatStrip, execution: &Execution<'_>) -> Result<bool, Error> {
    let tolerance = TOLERANCE * flat.width.max(flat.height);
    if runs_along_x(flat, tolerance) { Ok(false) } else { some_pair_overlaps(flat, tolerance, execution) }
}

pub(crate) fn some_pair_overlaps(flat: &FlatStrip, tolerance: f64, execution: &Execution<'_>) -> Result<bool, Error> {
    let corner = |v: u32| {
        let v = v as usize;
        if v < flat.p.len() { flat.p[v] } else { flat.q[v - flat.p.len()] }
    };
    let triangles: Vec<[DVec2; 3]> = flat.triangles.iter().map(|t| t.map(corner)).collect();
    if triangles.is_empty() {
        return Ok(false);
    }
    // Half-angle formulas give cos and sin of 22.5°, because the last digit of a library function may differ between
    // machines.
    let diagonal = std::f64::consts::FRAC_1_SQRT_2;
    let (c, s) = ((0.5 + 0.5 * diagonal).sqrt(), (0.5 - 0.5 * diagonal).sqrt());
    let axes = [
        DVec2::new(1.0, 0.0),
        DVec2::new(c, s),
        DVec2::new(diagonal, diagonal),
        DVec2::new(s, c),
        DVec2::new(0.0, 1.0),
        DVec2::new(-s, c),
        DVec2::new(-diagonal, diagonal),
        DVec2::new(-c, s),
    ];
    let leaves = triangles.len().div_ceil(LEAF);
    let base = leaves.next_power_of_two();
    let mut tree = vec![Slabs::EMPTY; 2 * base];
    for (k, triangle) in triangles.iter().enumerate() {
        for &point in triangle {
            tree[base + k / LEAF].add(point, &axes);
        }
    }
    for node in (1..base).rev() {
        tree[node] = tree[2 * node].merge(&tree[2 * node + 1]);
    }
    let range = |leaf: usize| (leaf - base) * LEAF..((leaf - base + 1) * LEAF).min(triangles.len());
    let mut pairs = vec![(1, 1)];
    let mut work = 0;
    while let Some((a, b)) = pairs.pop() {
        work += 1;
        if work == 1 << 14 {
            execution.look(work)?;
            work = 0;
        }
        if a != b && tree[a].apart(&tree[b], tolerance) {
            continue;
        }
        if a >= base {
            for first in range(a) {
                for second in range(b) {
                    if first < second && overlap(&triangles[first], &triangles[second], tolerance) {
                        return Ok(true);
                    }
                }
            }
        } else {
            pairs.push((2 * a, 2 * b));
            pairs.push((2 * a, 2 * b + 1));
            pairs.push((2 * a + 1, 2 * b + 1));
            if a != b {
                pairs.push((2 * a + 1, 2 * b));
            }
        }
    }
    Ok(false)
}

/// Whether both directrices run towards greater x, with Q above P all the way. The outline is then a simple polygon.
/// All triangles face up, so each point inside the outline is covered once, and nothing overlaps. The test takes
/// O(points) and holds for most strips.
pub(crate) fn runs_along_x(flat: &FlatStrip, tolerance: f64) -> bool {
    let ([p_first, .., p_last], [q_first, .., q_last]) = (flat.p.as_slice(), flat.q.as_slice()) else { return false };
    // If one directrix extends further than the other at an end, the other is continued along the bridge at that end,
    // up to the point that both lines then share.
    let continued = |own: &[DVec2], [first, last]: [DVec2; 2]| -> Vec<DVec2> {
        let before = (first.x < own[0].x).then_some(first);
        let after = (last.x > own[own.len() - 1].x).then_some(last);
        before.into_iter().chain(own.iter().copied()).chain(after).collect()
    };
    let lower = continued(&flat.p, [*q_first, *q_last]);
    let upper = continued(&flat.q, [*p_first, *p_last]);
    let runs = |line: &[DVec2]| line.windows(2).all(|pair| pair[0].x < pair[1].x);
    if !(runs(&lower) && runs(&upper)) {
        return false;
    }
    // Whether all of `points` lie below `line` (above it if `sign` is -1) by more than the tolerance. An end that both
    // lines share may touch.
    let ends = [lower[0], lower[lower.len() - 1]];
    let clear = |points: &[DVec2], line: &[DVec2], sign: f64| {
        let mut edge = 1;
        points.iter().all(|point| {
            while edge + 1 < line.len() && line[edge].x < point.x {
                edge += 1;
            }
            let (from, to) = (line[edge - 1], line[edge]);
            let at = from.y + (to.y - from.y) * ((point.x - from.x) / (to.x - from.x));
            let is_shared = ends.contains(point) && (line[0] == *point || line[line.len() - 1] == *point);
            is_shared || sign * (at - point.y) > tolerance
        })
    };
    clear(&lower, &upper, 1.0) && clear(&upper, &lower, -1.0)
}

/// Whether two triangles overlap by more than `tolerance`: the edge normals of both are tried as separating axes.
fn overlap(one: &[DVec2; 3], other: &[DVec2; 3], tolerance: f64) -> bool {
    for triangle in [one, other] {
        for k in 0..3 {
            let normal = (triangle[(k + 1) % 3] - triangle[k]).perp();
            let length = normal.length();
            if length == 0.0 {
                continue;
            }
            let extent = |corners: &[DVec2; 3]| {
                corners.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| {
                    let along = c.dot(normal) / length;
                    (low.min(along), high.max(along))
                })
            };
            let ((low, high), (other_low, other_high)) = (extent(one), extent(other));
            if high.min(other_high) - low.max(other_low) <= tolerance {
                return false;
            }
        }
    }
    true
}
