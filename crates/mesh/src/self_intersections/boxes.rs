//! A bounding-volume hierarchy over triangles: axis-aligned boxes, and boxes along each node's own normal and longest
//! edge.

use super::soup::{LOOK, NONE};
use crate::axis_box::AxisBox;
use crate::{DVec3, Execution, Interruption};
use std::ops::{ControlFlow, Range};

/// Slack for the rounding of the boxes' corners, as a fraction of the extent of the mesh. The rounding of the
/// coordinates is added to it: four times the machine epsilon times the largest coordinate.
const SLACK: f64 = 1e-14;

/// How the triangles are arranged before the tree is built over them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// In the order of the list, for meshes whose neighbours in the list are neighbours in space. The triangles of a
    /// strip are an example.
    AsGiven,
    /// Along a space-filling curve (Hilbert's).
    Spatial,
}

/// A direction serves as an axis only if the squared length of its part perpendicular to the normal exceeds this
/// fraction of its whole squared length.
const LEAST_ACROSS: f64 = 1e-12;

/// An oriented box: its axes are its own normal, its longest edge, and the direction perpendicular to both.
#[derive(Clone, Copy)]
pub(super) struct OwnBox {
    axes: [DVec3; 3],
    centre: DVec3,
    half: DVec3,
    /// The sum of the triangles' area vectors, and the sum of their longest edges. Each longest edge is first reversed,
    /// if necessary, so that it makes no obtuse angle with the sum of the edges before it.
    normal: DVec3,
    along: DVec3,
}

impl OwnBox {
    const EMPTY: Self =
        Self { axes: DVec3::AXES, centre: DVec3::ZERO, half: DVec3::ZERO, normal: DVec3::ZERO, along: DVec3::ZERO };

    /// An oriented box whose axes follow a normal and a direction. Its extent is not set yet.
    fn directed(normal: DVec3, along: DVec3) -> Self {
        let third = normal.normalize_or(DVec3::Z);
        let across = |v: DVec3| v - third * v.dot(third);
        // If the direction runs along the normal, its perpendicular remainder is only rounding, and may itself lie
        // along the normal: another vector is taken. For other directions the remainder is computed twice, because the
        // first difference may have lost some of its digits.
        let left = across(along);
        let is_certain = left.length_squared() > LEAST_ACROSS * along.length_squared();
        let first = if is_certain { across(left.normalize()).normalize() } else { third.any_orthonormal_vector() };
        Self { axes: [first, third.cross(first), third], normal, along, ..Self::EMPTY }
    }

    /// Sets the extent: `range` gives the lowest and the highest coordinate along an axis.
    fn extended(mut self, range: impl Fn(DVec3) -> (f64, f64)) -> Self {
        for k in 0..3 {
            let (low, high) = range(self.axes[k]);
            self.centre += self.axes[k] * (0.5 * (low + high));
            self.half[k] = 0.5 * (high - low);
        }
        self
    }

    fn of(triangles: &[[DVec3; 3]]) -> Self {
        let (mut normal, mut along) = (DVec3::ZERO, DVec3::ZERO);
        for &[a, b, c] in triangles {
            normal += (b - a).cross(c - a);
            along = aligned(along, longest([b - a, c - b, a - c]));
        }
        Self::directed(normal, along).extended(|axis| {
            triangles
                .iter()
                .flatten()
                .map(|corner| corner.dot(axis))
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high): (f64, f64), at| (low.min(at), high.max(at)))
        })
    }

    fn with(&self, other: &Self) -> Self {
        let both = Self::directed(self.normal + other.normal, aligned(self.along, other.along));
        both.extended(|axis| {
            let [one, two] = [self, other].map(|own| (own.centre.dot(axis), own.reach(axis)));
            ((one.0 - one.1).min(two.0 - two.1), (one.0 + one.1).max(two.0 + two.1))
        })
    }

    /// How far the box reaches from its centre along a unit vector.
    fn reach(&self, axis: DVec3) -> f64 {
        self.half.x * self.axes[0].dot(axis).abs()
            + self.half.y * self.axes[1].dot(axis).abs()
            + self.half.z * self.axes[2].dot(axis).abs()
    }

    /// Whether an axis of one of the two boxes separates them by more than `slack`.
    fn is_apart(&self, other: &Self, slack: f64) -> bool {
        let between = other.centre - self.centre;
        (0..3).any(|k| between.dot(self.axes[k]).abs() > self.half[k] + other.reach(self.axes[k]) + slack)
            || (0..3).any(|k| between.dot(other.axes[k]).abs() > other.half[k] + self.reach(other.axes[k]) + slack)
    }
}

fn longest(edges: [DVec3; 3]) -> DVec3 {
    edges
        .into_iter()
        .fold(DVec3::ZERO, |most, edge| if edge.length_squared() > most.length_squared() { edge } else { most })
}

fn aligned(sum: DVec3, direction: DVec3) -> DVec3 {
    if sum.dot(direction) < 0.0 { sum - direction } else { sum + direction }
}

/// A balanced binary tree of boxes over triangles. Node 1 is the root; the children of node k are 2k and 2k + 1.
pub(super) struct Tree {
    /// Triangles in the order of the leaves.
    order: Vec<u32>,
    /// The boxes of the triangles in the same order, if pairs of triangles are visited. Otherwise empty.
    boxes: Vec<AxisBox>,
    nodes: Vec<AxisBox>,
    /// The oriented boxes of the nodes, if pairs of triangles are visited. Otherwise empty.
    own: Vec<OwnBox>,
    /// The point relative to which the oriented boxes are computed: the centre of the mesh's box. The rounding of these
    /// boxes therefore depends only on the extent of the mesh, not on its distance from the origin of the coordinates.
    origin: DVec3,
    /// The number of the node that is the first leaf.
    base: usize,
    /// Triangles in a leaf.
    leaf_size: usize,
    slack: f64,
}

/// The triangles over which a tree is built, and their arrangement.
pub(super) struct Leaves {
    /// The triangles' numbers.
    pub triangles: Vec<u32>,
    /// How the triangles are arranged.
    pub order: Order,
    /// Triangles in a leaf of the tree.
    pub size: usize,
    /// Largest distance between a point of the exact triangles and the corners that the tree is given.
    pub margin: f64,
    /// The pairs that walks through the tree will visit.
    pub visits: Visits,
}

/// The pairs that a walk through a tree visits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Visits {
    /// Pairs of leaves whose axis-aligned boxes meet.
    Leaves,
    /// Pairs of triangles too. The tree then also stores the box of each triangle and the oriented box of each node.
    Pairs,
}

impl Tree {
    pub fn new(
        leaves: Leaves,
        corners: impl Fn(u32) -> [DVec3; 3],
        exec: &Execution<'_>,
    ) -> Result<Self, Interruption> {
        let Leaves { triangles: mut list, order, size, margin, visits } = leaves;
        let mut whole = AxisBox::EMPTY;
        for chunk in list.chunks(LOOK) {
            whole = chunk.iter().fold(whole, |whole, &t| whole.with(&AxisBox::around(corners(t))));
            exec.look(chunk.len() as u64)?;
        }
        if order == Order::Spatial {
            list = sorted_along_curve(&corners, &list, &whole, exec)?;
        }
        let base = list.len().div_ceil(size).max(1).next_power_of_two();
        let mut tree = Self {
            boxes: Vec::with_capacity(if visits == Visits::Pairs { list.len() } else { 0 }),
            nodes: vec![AxisBox::EMPTY; 2 * base],
            own: vec![OwnBox::EMPTY; if visits == Visits::Pairs { 2 * base } else { 0 }],
            origin: DVec3::ZERO,
            base,
            leaf_size: size,
            // The slack of an empty list is never used.
            slack: SLACK,
            order: list,
        };
        if !tree.order.is_empty() {
            tree.origin = whole.centre();
            let extent = (whole.high - whole.low).max_element();
            tree.slack = SLACK * extent + 4.0 * f64::EPSILON * whole.low.abs().max(whole.high.abs()).max_element();
        }
        tree.slack += 4.0 * margin;
        let mut here = Vec::with_capacity(size);
        for (leaf, triangles) in tree.order.chunks(size).enumerate() {
            here.clear();
            let node = base + leaf;
            for &t in triangles {
                let corners = corners(t);
                let extent = AxisBox::around(corners).widened(margin);
                if visits == Visits::Pairs {
                    tree.boxes.push(extent);
                }
                tree.nodes[node] = tree.nodes[node].with(&extent);
                here.push(corners.map(|corner| corner - tree.origin));
            }
            if visits == Visits::Pairs {
                tree.own[node] = OwnBox::of(&here);
            }
            if (leaf + 1) % (LOOK / size) == 0 {
                exec.look(LOOK as u64)?;
            }
        }
        for node in (1..base).rev() {
            let [left, right] = [2 * node, 2 * node + 1];
            tree.nodes[node] = tree.nodes[left].with(&tree.nodes[right]);
            if visits == Visits::Pairs {
                let alone = tree.is_empty(right);
                tree.own[node] = if alone { tree.own[left] } else { tree.own[left].with(&tree.own[right]) };
            }
            if node % LOOK == 0 {
                exec.look(LOOK as u64)?;
            }
        }
        Ok(tree)
    }

    fn is_empty(&self, node: usize) -> bool {
        self.nodes[node].low.x == f64::INFINITY
    }

    /// For each node, the label that all its triangles share, or [`NONE`] if their labels differ.
    pub fn labels(&self, label: impl Fn(u32) -> u32) -> Vec<u32> {
        let mut labels = vec![NONE; 2 * self.base];
        for (leaf, triangles) in self.order.chunks(self.leaf_size).enumerate() {
            let first = label(triangles[0]);
            let same = triangles[1..].iter().all(|&t| label(t) == first);
            labels[self.base + leaf] = if same { first } else { NONE };
        }
        for node in (1..self.base).rev() {
            let [left, right] = [2 * node, 2 * node + 1];
            let same = self.is_empty(right) || labels[left] == labels[right];
            labels[node] = if same { labels[left] } else { NONE };
        }
        labels
    }

    /// Visits every pair of leaves whose boxes meet, including each leaf with itself. A pair of nodes for which `skip`
    /// returns true is left out with all pairs of leaves below it. Returns false if the walk needed more work than
    /// `most_work`, or if the visitor broke off.
    pub fn visit_leaves(
        &self,
        most_work: u64,
        skip: impl Fn(usize, usize) -> bool,
        mut visit: impl FnMut(usize, usize) -> ControlFlow<()>,
        exec: &Execution<'_>,
    ) -> Result<bool, Interruption> {
        let mut pairs = vec![(1, 1)];
        let (mut work, mut total) = (0, 0u64);
        while let Some((a, b)) = pairs.pop() {
            work += 1;
            if work >= LOOK {
                exec.look(work as u64)?;
                total += work as u64;
                work = 0;
                if total >= most_work {
                    return Ok(false);
                }
            }
            if skip(a, b) {
                continue;
            }
            let is_apart = || match self.own.get(a) {
                Some(own) => own.is_apart(&self.own[b], self.slack),
                None => false,
            };
            if a != b && (!self.nodes[a].meets(&self.nodes[b]) || is_apart()) {
                continue;
            }
            if a < self.base {
                pairs.push((2 * a, 2 * b));
                pairs.push((2 * a, 2 * b + 1));
                pairs.push((2 * a + 1, 2 * b + 1));
                if a != b {
                    pairs.push((2 * a + 1, 2 * b));
                }
                continue;
            }
            work += self.leaf_size;
            if visit(a, b).is_break() {
                return Ok(false);
            }
        }
        exec.look(work as u64)?;
        Ok(true)
    }

    /// Visits every pair of triangles whose boxes meet, with the arguments and result of
    /// [`visit_leaves`](Self::visit_leaves). The tree must have been built for [`Visits::Pairs`].
    pub fn visit_pairs(
        &self,
        most_work: u64,
        skip: impl Fn(usize, usize) -> bool,
        mut visit: impl FnMut(u32, u32) -> ControlFlow<()>,
        exec: &Execution<'_>,
    ) -> Result<bool, Interruption> {
        let visit = |a: usize, b: usize| {
            for first in self.places(a) {
                let seconds = if a == b { first + 1..self.places(b).end } else { self.places(b) };
                for second in seconds {
                    if self.boxes[first].meets(&self.boxes[second]) {
                        visit(self.order[first], self.order[second])?;
                    }
                }
            }
            ControlFlow::Continue(())
        };
        self.visit_leaves(most_work, skip, visit, exec)
    }

    /// The oriented box of some triangles.
    pub fn own_box(&self, triangles: impl Iterator<Item = [DVec3; 3]>) -> OwnBox {
        let here: Vec<[DVec3; 3]> = triangles.map(|corners| corners.map(|corner| corner - self.origin)).collect();
        OwnBox::of(&here)
    }

    /// Whether two oriented boxes are certainly apart.
    pub fn are_apart(&self, one: &OwnBox, other: &OwnBox) -> bool {
        one.is_apart(other, self.slack)
    }

    /// The triangles of a leaf.
    pub fn leaf(&self, node: usize) -> &[u32] {
        &self.order[self.places(node)]
    }

    fn places(&self, leaf: usize) -> Range<usize> {
        let start = (leaf - self.base) * self.leaf_size;
        start.min(self.order.len())..(start + self.leaf_size).min(self.order.len())
    }
}

/// Number of bits per axis of a position on the curve. Each pass of the radix sort takes as many bits.
const BITS: u32 = 10;

/// Position of a cell of a cube of 2^[`BITS`] cells along each axis on Hilbert's curve (J. Skilling, *Programming the
/// Hilbert curve*, 2004). Unlike Morton's curve it makes no jumps, so that a leaf is one piece of the surface.
fn place_on_curve([mut x, mut y, mut z]: [u32; 3]) -> u32 {
    // All ones if the bit is set, and zero otherwise. This avoids branches, which would be taken at random.
    let all_if = |value: u32, bit: u32| 0u32.wrapping_sub(value >> bit & 1);
    for bit in (1..BITS).rev() {
        let below = (1 << bit) - 1;
        x ^= below & all_if(x, bit);
        for other in [&mut y, &mut z] {
            let set = all_if(*other, bit);
            let exchanged = (x ^ *other) & below & !set;
            x ^= exchanged | below & set;
            *other ^= exchanged;
        }
    }
    y ^= x;
    z ^= y;
    let turned = (1..BITS).fold(0, |turned, bit| turned ^ ((1 << bit) - 1) & all_if(z, bit));
    let spread = |value: u32| {
        let mut bits = value ^ turned;
        bits = (bits | bits << 16) & 0x030000ff;
        bits = (bits | bits << 8) & 0x0300f00f;
        bits = (bits | bits << 4) & 0x030c30c3;
        (bits | bits << 2) & 0x09249249
    };
    spread(x) << 2 | spread(y) << 1 | spread(z)
}

/// Sorts triangles by the position of their centroid on Hilbert's space-filling curve.
pub(super) fn sorted_along_curve(
    corners: impl Fn(u32) -> [DVec3; 3],
    list: &[u32],
    whole: &AxisBox,
    exec: &Execution<'_>,
) -> Result<Vec<u32>, Interruption> {
    let centre = |&t: &u32| {
        let [a, b, c] = corners(t);
        (a + b + c) / 3.0
    };
    let centres: Vec<DVec3> = list.iter().map(centre).collect();
    exec.look(list.len() as u64)?;
    let order = along_curve(&centres, whole, exec)?;
    Ok(order.into_iter().map(|k| list[k as usize]).collect())
}

/// The numbers of the points, sorted by their position on Hilbert's curve. The sort is stable.
fn along_curve(points: &[DVec3], whole: &AxisBox, exec: &Execution<'_>) -> Result<Vec<u32>, Interruption> {
    let cells = f64::from((1 << BITS) - 1);
    let scale = cells / (whole.high - whole.low).max(DVec3::splat(f64::MIN_POSITIVE));
    let code = |point: DVec3| {
        let at = (point - whole.low) * scale;
        place_on_curve(at.to_array().map(|coordinate| (coordinate as u32).min((1 << BITS) - 1)))
    };
    let mut keyed: Vec<(u32, u32)> = points.iter().zip(0..).map(|(&point, k)| (code(point), k)).collect();
    exec.look(points.len() as u64)?;
    let mut sorted = vec![(0, 0); keyed.len()];
    for pass in 0..3 {
        let digit = |code: u32| (code >> (pass * BITS) & ((1 << BITS) - 1)) as usize;
        let mut start = [0usize; (1 << BITS) + 1];
        keyed.iter().for_each(|&(code, _)| start[digit(code) + 1] += 1);
        for k in 0..1 << BITS {
            start[k + 1] += start[k];
        }
        for &(code, k) in &keyed {
            let slot = &mut start[digit(code)];
            sorted[*slot] = (code, k);
            *slot += 1;
        }
        std::mem::swap(&mut keyed, &mut sorted);
        exec.look(points.len() as u64)?;
    }
    Ok(keyed.into_iter().map(|(_, k)| k).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_of_a_box_are_at_right_angles_when_its_longest_edges_lie_along_its_normal() {
        let mut random = crate::random::SplitMix64::new(4);
        for _ in 0..1000 {
            let mut any = || random.between(-1.0, 1.0);
            let normal = DVec3::new(any(), any(), any());
            for along in [normal * 3.0, -normal, normal * (1.0 + f64::EPSILON), DVec3::ZERO] {
                let [x, y, z] = OwnBox::directed(normal, along).axes;
                assert!([x.dot(y), y.dot(z), z.dot(x)].iter().all(|cosine| cosine.abs() < 1e-14), "{normal} {along}");
                assert!([x, y, z].iter().all(|axis| (axis.length() - 1.0).abs() < 1e-14), "{normal} {along}");
            }
        }
    }

    #[test]
    fn the_curve_goes_from_neighbour_to_neighbour() {
        let mut cells: Vec<[u32; 3]> = (0..4096).map(|k| [k / 256, k / 16 % 16, k % 16]).collect();
        cells.sort_unstable_by_key(|&cell| place_on_curve(cell));
        for pair in cells.windows(2) {
            let steps: u32 = (0..3).map(|k| pair[0][k].abs_diff(pair[1][k])).sum();
            assert_eq!(steps, 1, "{pair:?}");
        }
    }
}
