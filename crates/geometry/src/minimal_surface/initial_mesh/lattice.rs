//! Interior points of a graded mesh: an equilateral lattice whose spacing follows a size field.
//!
//! The lattice is refined by halving triangles until they have the wanted size. The lattices of all sizes are therefore
//! nested, and one changes into the next without a seam. Where the size is constant, the Delaunay triangles of these
//! points are equilateral.

use crate::execution::{Execution, Interruption};
use glam::DVec2;

/// A piece of the boundary or of a fixed curve, with the wanted edge length along it. If both ends are equal, it is a
/// point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source {
    a: DVec2,
    along: DVec2,
    /// The inverse of the squared length; zero for a point.
    inverse: f64,
    size: f64,
}

impl Source {
    pub fn new(a: DVec2, b: DVec2, size: f64) -> Self {
        let along = b - a;
        let length_squared = along.length_squared();
        let inverse = if length_squared > 0.0 { 1.0 / length_squared } else { 0.0 };
        Self { a, along, inverse: if inverse.is_finite() { inverse } else { 0.0 }, size }
    }

    fn distance(&self, point: DVec2) -> f64 {
        let away = point - self.a;
        let part = away.dot(self.along) * self.inverse;
        (away - self.along * part.clamp(0.0, 1.0)).length()
    }
}

/// Sources in a leaf of the tree.
const LEAF: usize = 4;
/// Relative rounding error of a bound, by which a part of the tree must be worse than the best source so far to be left
/// out.
const ROUNDING: f64 = 1e-12;

/// A box around sources that follow each other, and the least of their sizes.
#[derive(Clone, Copy)]
struct Group {
    low: DVec2,
    high: DVec2,
    size: f64,
}

impl Group {
    const EMPTY: Self = Self { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY, size: f64::INFINITY };

    fn with(&self, other: &Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high), size: self.size.min(other.size) }
    }

    /// The distance of a point from the box; infinite for an empty one.
    fn distance(&self, point: DVec2) -> f64 {
        (self.low - point).max(point - self.high).max(DVec2::ZERO).length()
    }
}

/// A balanced binary tree over the sources in their order, which is that along the boundaries. Node 1 is the root, the
/// children of k are 2k and 2k + 1. The work for a position grows with the logarithm of the number of sources.
struct Tree<'a> {
    sources: &'a [Source],
    groups: Vec<Group>,
    /// The first leaf's node.
    base: usize,
}

impl<'a> Tree<'a> {
    fn new(sources: &'a [Source]) -> Self {
        let base = sources.len().div_ceil(LEAF).max(1).next_power_of_two();
        let mut groups = vec![Group::EMPTY; 2 * base];
        for (k, source) in sources.iter().enumerate() {
            let (a, b) = (source.a, source.a + source.along);
            let own = Group { low: a.min(b), high: a.max(b), size: source.size };
            groups[base + k / LEAF] = groups[base + k / LEAF].with(&own);
        }
        for node in (1..base).rev() {
            groups[node] = groups[2 * node].with(&groups[2 * node + 1]);
        }
        Self { sources, groups, base }
    }

    /// Visits the groups from the root on, and the sources of the leaves, nearest to a point first. It leaves out what
    /// is below a group of which `visit` says false.
    fn walk(&self, nearer: DVec2, mut visit: impl FnMut(Walk<'_>) -> bool) {
        let mut stack = [1usize; 64];
        let mut height = 1;
        while height > 0 {
            height -= 1;
            let node = stack[height];
            if !visit(Walk::Group(&self.groups[node])) {
                continue;
            }
            if node < self.base {
                let [left, right] = [2 * node, 2 * node + 1];
                let right_is_nearer = self.groups[right].distance(nearer) < self.groups[left].distance(nearer);
                // The nearer half is visited first.
                let [first, second] = if right_is_nearer { [right, left] } else { [left, right] };
                (stack[height], stack[height + 1]) = (second, first);
                height += 2;
            } else {
                let start = (node - self.base) * LEAF;
                for k in start..(start + LEAF).min(self.sources.len()) {
                    visit(Walk::Source(k as u32, &self.sources[k]));
                }
            }
        }
    }

    /// The least of `bound` and, over all sources, size + grading × distance from a point, with the source that gives
    /// it. `hint` is a source whose value is likely to be low.
    fn size(&self, point: DVec2, grading: f64, bound: f64, hint: u32) -> (f64, u32) {
        let mut best = (bound, hint);
        let mut offer = |k: u32, source: &Source| {
            let value = source.size + grading * source.distance(point);
            if value < best.0 {
                best = (value, k);
            }
            best.0
        };
        let mut least = self.sources.get(hint as usize).map_or(bound, |source| offer(hint, source));
        self.walk(point, |step| match step {
            Walk::Group(group) => group.size + grading * group.distance(point) <= least * (1.0 + ROUNDING),
            Walk::Source(k, source) => {
                least = offer(k, source);
                true
            }
        });
        best
    }

    /// Whether no source is nearer to a point than `reach`.
    fn is_clear(&self, point: DVec2, reach: f64) -> bool {
        let mut clear = true;
        self.walk(point, |step| match step {
            Walk::Group(group) => clear && group.distance(point) <= reach * (1.0 + ROUNDING),
            Walk::Source(_, source) => {
                clear &= source.distance(point) >= reach;
                true
            }
        });
        clear
    }
}

/// A step of a walk through the tree.
enum Walk<'a> {
    /// Whether the walk goes on into this group.
    Group(&'a Group),
    /// A source and its number.
    Source(u32, &'a Source),
}

/// The wanted edge length as a function of the position: the least of the cap and, over all sources, size + grading ×
/// distance.
pub(super) struct SizeField<'a> {
    pub sources: Vec<Source>,
    pub grading: f64,
    /// Upper bound of the size at a position. It changes by less than the grading per distance.
    pub cap: &'a dyn Fn(DVec2) -> f64,
}

/// Smallest distance of a lattice point from a source, as a fraction of the local size; nearer points would make flat
/// triangles. A larger value leaves wider gaps beside the boundary.
const CLEARANCE: f64 = 0.6;

/// Largest number of halvings from the root, so that sizes may vary by 2^24 within one domain.
const DEPTH: u32 = 24;

struct Cell {
    corners: [[i64; 2]; 3],
    depth: u32,
    /// Whether the triangle points the other way than the root. Each of its corners is then a corner of an upright one
    /// too.
    inverted: bool,
    /// The source that determines the size in the cell around this one.
    hint: u32,
}

/// Number of cells visited between two looks, which takes a few milliseconds.
const CELLS_BETWEEN_LOOKS: u64 = 1 << 15;

/// A lattice point (row, then column) that may stand too near to a source, and the source that determines the size beside
/// it.
type Corner = (u64, u32);

impl SizeField<'_> {
    /// The lattice points in the rectangle that are not too near to a source, sorted by y, then x. `None` if there
    /// would be more than `limit`. Looks every [`CELLS_BETWEEN_LOOKS`] cells.
    ///
    /// `spacing` is the spacing of the lattice where no source needs less. It must not exceed the largest value of the
    /// cap.
    pub fn lattice(
        &self,
        low: DVec2,
        high: DVec2,
        spacing: f64,
        limit: usize,
        exec: &Execution,
    ) -> Result<Option<Vec<DVec2>>, Interruption> {
        // The root is an equilateral triangle around the rectangle. Its side is the spacing times a power of two.
        let row = 0.75f64.sqrt();
        let extent = high - low;
        let needed = extent.x + 2.0 * extent.y + 2.0 * spacing;
        let doublings = (needed / spacing).log2().ceil().max(0.0) as i32;
        let side = spacing * 2f64.powi(doublings);
        let unit = side / 2f64.powi(DEPTH as i32);
        let centre = 0.5 * (low + high);
        let origin = DVec2::new(centre.x - 0.5 * side, centre.y - 0.25 * row * side);
        let place = |[u, v]: [i64; 2]| origin + DVec2::new((u as f64 + 0.5 * v as f64) * unit, v as f64 * row * unit);
        let whole = 1i64 << DEPTH;
        let tree = Tree::new(&self.sources);
        let size_at = |point: DVec2, hint: u32| tree.size(point, self.grading, (self.cap)(point), hint);
        let mut stack = vec![Cell { corners: [[0, 0], [whole, 0], [0, whole]], depth: 0, inverted: false, hint: 0 }];
        let mut found: Vec<Corner> = Vec::new();
        let merge = |found: &mut Vec<Corner>| {
            found.sort_unstable();
            found.dedup_by_key(|corner| corner.0);
        };
        let mut merged = 0;
        let mut visited = 0;
        while let Some(Cell { corners, depth, inverted, hint }) = stack.pop() {
            visited += 1;
            if visited % CELLS_BETWEEN_LOOKS == 0 {
                exec.look(CELLS_BETWEEN_LOOKS)?;
            }
            let places = corners.map(place);
            let [p, q, r] = places;
            let centre = (p + q + r) / 3.0;
            let side = side / 2f64.powi(depth as i32);
            if p.min(q).min(r).cmpgt(high).any() || p.max(q).max(r).cmplt(low).any() {
                continue;
            }
            let (size, hint) = size_at(centre, hint);
            if depth < DEPTH && side > size * (1.0 + 1e-9) {
                let half = |a: [i64; 2], b: [i64; 2]| [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
                let [a, b, c] = corners;
                let (ab, bc, ca) = (half(a, b), half(b, c), half(c, a));
                for (corners, turned) in
                    [([a, ab, ca], false), ([ab, b, bc], false), ([ca, bc, c], false), ([bc, ca, ab], true)]
                {
                    let inverted = inverted != turned;
                    stack.push(Cell { corners, depth: depth + 1, inverted, hint });
                }
                continue;
            }
            if inverted {
                continue;
            }
            for ([column, row], point) in corners.into_iter().zip(places) {
                if point.cmpge(low).all() && point.cmple(high).all() {
                    found.push(((row as u64) << 32 | column as u64, hint));
                }
            }
            if found.len() > merged + 2 * limit {
                merge(&mut found);
                merged = found.len();
                // Points that are too near to a source do not count. If there are far more points than the limit,
                // others must be among them.
                if merged > 2 * limit {
                    return Ok(None);
                }
            }
        }
        merge(&mut found);
        let clear = |&(corner, hint): &Corner| {
            let point = place([(corner & u64::from(u32::MAX)) as i64, (corner >> 32) as i64]);
            let (size, _) = size_at(point, hint);
            tree.is_clear(point, CLEARANCE * size).then_some(point)
        };
        let points: Vec<DVec2> = found.iter().filter_map(clear).collect();
        Ok((points.len() <= limit).then_some(points))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square_sources(side: f64, pieces: usize) -> Vec<Source> {
        let corners = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(|(x, y)| DVec2::new(x, y));
        let size = side / pieces as f64;
        (0..4)
            .flat_map(|k| {
                let (a, b) = (corners[k], corners[(k + 1) % 4]);
                (0..pieces).map(move |i| {
                    let at = |i: usize| a + (b - a) * (i as f64 / pieces as f64);
                    Source::new(at(i), at(i + 1), size)
                })
            })
            .collect()
    }

    #[test]
    fn pruned_sizes_and_clearances_equal_brute_force() {
        // One long and one very short source: pruning must keep both where they matter.
        let mut sources = square_sources(1.0, 4);
        sources.push(Source::new(DVec2::new(0.3, 0.4), DVec2::new(0.3, 0.4), 0.003));
        let field = SizeField { sources, grading: 0.3, cap: &|_| 0.2 };
        let points = field.lattice(DVec2::ZERO, DVec2::ONE, 0.2, 100_000, &Execution::default()).unwrap().unwrap();
        assert!(points.len() > 100);
        for (k, &p) in points.iter().enumerate() {
            let sizes = field.sources.iter().map(|source| source.size + field.grading * source.distance(p));
            let size = sizes.fold(0.2, f64::min);
            assert!(field.sources.iter().all(|source| source.distance(p) >= CLEARANCE * size * (1.0 - 1e-9)));
            let nearest = points.iter().enumerate().filter(|&(i, _)| i != k).map(|(_, q)| q.distance(p));
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            assert!(nearest > 0.3 * size, "{nearest} {size}");
            let covered = field.sources.iter().map(|source| source.distance(p)).fold(nearest, f64::min);
            assert!(covered < 1.3 * size, "{covered} {size}");
        }
    }

    #[test]
    fn too_many_points_are_refused_before_they_are_made() {
        let field = SizeField { sources: square_sources(1.0, 4), grading: 0.3, cap: &|_| 1e-4 };
        assert!(field.lattice(DVec2::ZERO, DVec2::ONE, 1e-4, 10_000, &Execution::default()).unwrap().is_none());
    }
}
