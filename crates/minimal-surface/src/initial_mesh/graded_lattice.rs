//! Interior points of a graded mesh: an equilateral lattice whose spacing follows a size field.
//!
//! The lattice is made by quartering triangles at the midpoints of their sides until they have the wanted size. The
//! lattices of all sizes are therefore nested, and the spacing can change without a seam. Where the size is constant,
//! the Delaunay triangles of these points are equilateral.

use glam::DVec2;
use plateau_mesh::execution::{Execution, Interruption};
use std::rc::Rc;

/// A segment of the boundary or of a fixed curve, with the wanted edge length along it. If both ends are equal, the
/// source is a point.
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

/// Number of sources in a leaf of the tree.
const LEAF: usize = 4;
/// Largest number of sources in the list of a cell. A cell to which more sources can matter has no list, and the tree
/// is searched instead, because thousands of sources may matter to a cell beside a boundary of many points.
const FEW: usize = 32;
/// Relative rounding error of a bound. A subtree is skipped only if its bound exceeds the best value found by more than
/// this.
const ROUNDING: f64 = 1e-12;

/// Bounding box of consecutive sources, and the smallest of their sizes.
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

/// A balanced binary tree over the sources in their order along the boundaries. Node 1 is the root, and the children of
/// node k are 2k and 2k + 1. The work for a position grows with the logarithm of the number of sources.
struct Tree<'a> {
    sources: &'a [Source],
    groups: Vec<Group>,
    /// Node of the first leaf.
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

    /// Visits the groups from the root on, those nearer to the point first, and offers the sources of the leaves to
    /// `state`. A group that `state` refuses to enter is skipped with its whole subtree.
    fn walk(&self, point: DVec2, state: &mut impl Walk) {
        // The stack holds an entry for each level and one more, which is enough for 2^30 leaves.
        let mut stack = [(1usize, 0.0); 32];
        let mut height = 1;
        stack[0].1 = self.groups[1].distance(point);
        // At most one pass per group, because each group is the child of one other group.
        while height > 0 {
            height -= 1;
            let (node, distance) = stack[height];
            if !state.enters(self.groups[node].size, distance) {
                continue;
            }
            if node < self.base {
                let [left, right] = [2 * node, 2 * node + 1].map(|child| (child, self.groups[child].distance(point)));
                // The nearer half is visited first.
                let [first, second] = if right.1 < left.1 { [right, left] } else { [left, right] };
                (stack[height], stack[height + 1]) = (second, first);
                height += 2;
                continue;
            }
            let start = (node - self.base) * LEAF;
            for k in start..(start + LEAF).min(self.sources.len()) {
                if !state.offer(k as u32, &self.sources[k]) {
                    return;
                }
            }
        }
    }
}

/// A search through the tree: decides which groups are entered, and takes the sources.
trait Walk {
    /// Whether a group at this distance, whose smallest size is `size`, may hold a source that the search needs.
    fn enters(&self, size: f64, distance: f64) -> bool;
    /// Takes a source and its number. False ends the walk.
    fn offer(&mut self, number: u32, source: &Source) -> bool;
}

/// Finds the minimum of the initial `size` and of (source size + grading × distance from the point) over all sources.
struct Smallest {
    point: DVec2,
    grading: f64,
    size: f64,
    /// Distance of the nearest source among those visited. If any source is too near for a lattice point, this is the
    /// distance of the nearest of all sources.
    clearance: f64,
}

impl Walk for Smallest {
    fn enters(&self, size: f64, distance: f64) -> bool {
        // A source of any size counts too, if it is the nearest and can be too near for a lattice point.
        size + self.grading * distance <= self.size * (1.0 + ROUNDING)
            || distance < self.clearance && distance <= CLEARANCE * self.size * (1.0 + ROUNDING)
    }

    fn offer(&mut self, _number: u32, source: &Source) -> bool {
        let distance = source.distance(self.point);
        self.clearance = self.clearance.min(distance);
        self.size = self.size.min(source.size + self.grading * distance);
        true
    }
}

/// Collects the sources that can determine the size, or be too near for a lattice point, anywhere within `reach` of a
/// point.
struct Near {
    point: DVec2,
    grading: f64,
    /// The size at the point, and an upper bound of the distance of the nearest source.
    size: f64,
    clearance: f64,
    reach: f64,
    found: Vec<u32>,
}

impl Near {
    fn matters(&self, size: f64, distance: f64) -> bool {
        let largest = self.size + 2.0 * self.grading * self.reach;
        // For another point within reach, the nearest source is at most twice the reach farther from this point.
        let can_be_nearest = distance <= (self.clearance + 2.0 * self.reach) * (1.0 + ROUNDING);
        size + self.grading * distance <= largest
            || can_be_nearest && distance - self.reach <= CLEARANCE * largest * (1.0 + ROUNDING)
    }
}

impl Walk for Near {
    fn enters(&self, size: f64, distance: f64) -> bool {
        self.matters(size * (1.0 - ROUNDING), distance * (1.0 - ROUNDING))
    }

    fn offer(&mut self, number: u32, source: &Source) -> bool {
        if self.matters(source.size, source.distance(self.point)) {
            self.found.push(number);
        }
        self.found.len() <= FEW
    }
}

/// The wanted edge length as a function of the position: the minimum of the cap and of (source size + grading ×
/// distance) over all sources.
pub(super) struct SizeField<'a> {
    pub sources: Vec<Source>,
    pub grading: f64,
    /// Upper bound of the size at a position. Its slope must be less than the grading.
    pub cap: &'a dyn Fn(DVec2) -> f64,
}

/// Smallest distance of a lattice point from a source, as a fraction of the local size. Nearer points would make flat
/// triangles.
const CLEARANCE: f64 = 0.6;

/// Largest number of quarterings of the root triangle, so that sizes may vary by 2^24 within one domain.
const DEPTH: u32 = 24;

struct Cell {
    corners: [[i64; 2]; 3],
    depth: u32,
    /// Whether the triangle points the other way than the root. The corners of an inverted triangle add no lattice
    /// points, because each is a corner of an upright triangle too.
    inverted: bool,
    near: Sources,
}

/// The sources that can matter to a cell.
#[derive(Clone)]
enum Sources {
    All,
    Few(Rc<[u32]>),
}

impl Sources {
    /// Whether both are the same list, or both are all sources.
    fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Few(one), Self::Few(other)) => Rc::ptr_eq(one, other),
            (Self::All, Self::All) => true,
            _ => false,
        }
    }
}

/// Cuts a triangle into four at the midpoints of its sides. Returns each part, and whether the part points the other
/// way than the whole triangle.
fn quarters([a, b, c]: [[i64; 2]; 3]) -> [([[i64; 2]; 3], bool); 4] {
    let half = |a: [i64; 2], b: [i64; 2]| [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    let (ab, bc, ca) = (half(a, b), half(b, c), half(c, a));
    [([a, ab, ca], false), ([ab, b, bc], false), ([ca, bc, c], false), ([bc, ca, ab], true)]
}

/// Number of cells visited between two calls of [`Execution::look`]. These cells take a few milliseconds.
const CELLS_BETWEEN_LOOKS: u64 = 1 << 15;

/// A lattice point (row, then column), which may still be too near to a source, and the index of its list of near
/// sources.
type Corner = (u64, u32);

impl SizeField<'_> {
    /// Returns the size at a position and the distance of the nearest source. If no source is too near for a lattice
    /// point, the distance may belong to another source than the nearest.
    #[inline]
    fn size_and_clearance(&self, point: DVec2, tree: &Tree, near: &Sources) -> (f64, f64) {
        let size = (self.cap)(point);
        let mut found = Smallest { point, grading: self.grading, size, clearance: f64::INFINITY };
        match near {
            Sources::All => tree.walk(point, &mut found),
            Sources::Few(near) => near.iter().for_each(|&k| {
                found.offer(k, &self.sources[k as usize]);
            }),
        }
        (found.size, found.clearance)
    }

    /// Returns the sources that can determine the size, or be too near for a lattice point, anywhere within `reach` of
    /// a point. The size and the clearance at the point are given.
    fn narrowed(
        &self,
        point: DVec2,
        reach: f64,
        (size, clearance): (f64, f64),
        tree: &Tree,
        near: &Sources,
    ) -> Sources {
        let mut found = Near { point, grading: self.grading, size, clearance, reach, found: Vec::new() };
        match near {
            Sources::All => tree.walk(point, &mut found),
            Sources::Few(near) => near.iter().for_each(|&k| {
                found.offer(k, &self.sources[k as usize]);
            }),
        }
        if found.found.len() <= FEW { Sources::Few(found.found.into()) } else { Sources::All }
    }

    /// Returns the lattice points in the rectangle that are not too near to a source, sorted by y, then x. `None` if
    /// there would be more than `limit`. Calls `exec.look` every [`CELLS_BETWEEN_LOOKS`] cells.
    ///
    /// `spacing` is the spacing of the lattice where no source demands a smaller one. It must not exceed the largest
    /// value of the cap.
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
        let doublings = libm::log2(needed / spacing).ceil().max(0.0) as i32;
        let side = spacing * 2f64.powi(doublings);
        let unit = side / 2f64.powi(DEPTH as i32);
        let centre = 0.5 * (low + high);
        let origin = DVec2::new(centre.x - 0.5 * side, centre.y - 0.25 * row * side);
        let place = |[u, v]: [i64; 2]| origin + DVec2::new((u as f64 + 0.5 * v as f64) * unit, v as f64 * row * unit);
        let whole = 1i64 << DEPTH;
        let tree = Tree::new(&self.sources);
        let root = [[0, 0], [whole, 0], [0, whole]];
        let mut stack = vec![Cell { corners: root, depth: 0, inverted: false, near: Sources::All }];
        let (mut found, mut lists): (Vec<Corner>, Vec<Sources>) = (Vec::new(), Vec::new());
        let merge = |found: &mut Vec<Corner>| {
            found.sort_unstable();
            found.dedup_by_key(|corner| corner.0);
        };
        let (mut merged, mut visited) = (0, 0);
        while let Some(Cell { corners, depth, inverted, near }) = stack.pop() {
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
            let (size, clearance) = self.size_and_clearance(centre, &tree, &near);
            if depth < DEPTH && side > size * (1.0 + 1e-9) {
                let near = self.narrowed(centre, side / 3f64.sqrt(), (size, clearance), &tree, &near);
                for (corners, turned) in quarters(corners) {
                    let inverted = inverted != turned;
                    stack.push(Cell { corners, depth: depth + 1, inverted, near: near.clone() });
                }
                continue;
            }
            if inverted {
                continue;
            }
            if !lists.last().is_some_and(|last| last.is_same(&near)) {
                lists.push(near);
            }
            let list = lists.len() as u32 - 1;
            for ([column, row], point) in corners.into_iter().zip(places) {
                if point.cmpge(low).all() && point.cmple(high).all() {
                    found.push(((row as u64) << 32 | column as u64, list));
                }
            }
            if found.len() > merged + 2 * limit {
                merge(&mut found);
                merged = found.len();
                // `found` still includes points that are too near to a source. These are refused only if there are far
                // more than `limit`, because then some are far enough from all sources.
                if merged > 2 * limit {
                    return Ok(None);
                }
            }
        }
        merge(&mut found);
        let clear = |&(corner, list): &Corner| {
            let point = place([(corner & u64::from(u32::MAX)) as i64, (corner >> 32) as i64]);
            let (size, clearance) = self.size_and_clearance(point, &tree, &lists[list as usize]);
            (clearance >= CLEARANCE * size).then_some(point)
        };
        let points: Vec<DVec2> = found.iter().filter_map(clear).collect();
        Ok((points.len() <= limit).then_some(points))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::plane::unit_vector;

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
        // The last source is much smaller than the others: pruning must keep both kinds of source where they matter.
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
    fn the_tree_and_the_lists_decide_as_all_sources_do() {
        let mut random = plateau_mesh::random::SplitMix64::new(7);
        let mut sources = square_sources(1.0, 300);
        sources.push(Source::new(DVec2::new(0.3, 0.4), DVec2::new(0.3, 0.4), f64::INFINITY));
        sources.push(Source::new(DVec2::new(0.6, 0.2), DVec2::new(0.9, 0.2), 0.3));
        for grading in [0.3, 1.0, 3.0, 20.0] {
            let field = SizeField { sources: sources.clone(), grading, cap: &|_| 0.2 };
            let tree = Tree::new(&field.sources);
            let (mut too_near, mut lists) = (0, 0);
            for _ in 0..3_000 {
                let mut any = |low: f64, high: f64| random.between(low, high);
                let (centre, reach) = (DVec2::new(any(0.0, 1.0), any(0.0, 1.0)), any(0.0, 0.1));
                let known = field.size_and_clearance(centre, &tree, &Sources::All);
                let near = field.narrowed(centre, reach, known, &tree, &Sources::All);
                lists += usize::from(matches!(near, Sources::Few(_)));
                let point = centre + unit_vector(any(0.0, 6.3)) * any(0.0, reach);
                let sizes = field.sources.iter().map(|source| source.size + grading * source.distance(point));
                let size = sizes.fold(0.2, f64::min);
                let clearance = field.sources.iter().map(|source| source.distance(point)).fold(f64::INFINITY, f64::min);
                for from in [&Sources::All, &near] {
                    let found = field.size_and_clearance(point, &tree, from);
                    assert_eq!(found.0, size, "{grading} {point}");
                    assert_eq!(found.1 < CLEARANCE * size, clearance < CLEARANCE * size, "{grading} {point}");
                }
                too_near += usize::from(clearance < CLEARANCE * size);
            }
            assert!(too_near > 30 && lists > 100, "{grading}: {too_near} {lists}");
        }
    }

    #[test]
    fn too_many_points_are_refused_before_they_are_made() {
        let field = SizeField { sources: square_sources(1.0, 4), grading: 0.3, cap: &|_| 1e-4 };
        assert!(field.lattice(DVec2::ZERO, DVec2::ONE, 1e-4, 10_000, &Execution::default()).unwrap().is_none());
    }

    /// Counts the sources that a search looks at.
    struct Counted(Smallest, usize);

    impl Walk for Counted {
        fn enters(&self, size: f64, distance: f64) -> bool {
            self.0.enters(size, distance)
        }
        fn offer(&mut self, number: u32, source: &Source) -> bool {
            self.1 += 1;
            self.0.offer(number, source)
        }
    }

    #[test]
    fn few_of_the_sources_on_a_long_boundary_are_looked_at() {
        let count = 50_000;
        let at = |k: u32| unit_vector(std::f64::consts::TAU * f64::from(k) / f64::from(count));
        let sources: Vec<Source> = (0..count).map(|k| Source::new(at(k), at(k + 1), 1e-4)).collect();
        let tree = Tree::new(&sources);
        for radius in [0.2, 0.5, 0.9, 0.99, 0.9999] {
            let point = unit_vector(1.0) * radius;
            let smallest = Smallest { point, grading: 0.3, size: 1.0, clearance: f64::INFINITY };
            let mut counted = Counted(smallest, 0);
            tree.walk(point, &mut counted);
            let brute_force = sources.iter().map(|source| source.size + 0.3 * source.distance(point));
            assert_eq!(counted.0.size, brute_force.fold(1.0, f64::min));
            assert!(counted.1 < 3_000, "{radius}: {}", counted.1);
        }
    }
}
