//! Self-intersections: pairs of triangles that meet in more than the vertices and the edge that they share.
//!
//! Two triangles *intersect* if their closed sets have a point in common that is not part of a shared vertex or edge:
//! they cross, touch, or overlap in one plane. Vertices with equal coordinates count as one vertex, and triangles
//! without area are left out (their neighbours cover them). All decisions are exact: they use the adaptive predicates
//! of `robust`.
//!
//! A bounding-volume hierarchy finds the pairs that may intersect: axis-aligned boxes first, then boxes along each
//! node's own normal and longest edge (S. Gottschalk, M. C. Lin, D. Manocha, *OBBTree*, SIGGRAPH 1996), which keep long
//! thin triangles apart. The triangles around one vertex meet there, and are most of the pairs whose boxes meet. They
//! are settled together: if all of them face one direction and wind round the vertex at most once, their projection
//! along that direction is one-to-one, and no two of them intersect.
//!
//! O(n log n) time for meshes whose triangles do not pile up, O(n) memory, deterministic.

#![warn(missing_docs)]

use crate::error::Warning;
use crate::{DVec3, Execution, Interruption, Mesh};
use robust::{Coord, Coord3D, orient2d, orient3d};
use std::ops::ControlFlow;

/// Triangles in a leaf of the tree. Any value from 2 to 8 takes about the same time; a larger one needs less memory.
const LEAF: usize = 4;
/// Triangles, vertices or pairs between two looks at the execution: a few milliseconds at most.
const LOOK: usize = 1 << 14;
/// A triangle counts as facing a vertex normal if the cosine, times the sine of its angle at the vertex, exceeds this.
/// A larger value sends more triangles to the exact predicates; a value near rounding (1e-15) would not be safe.
const FACING: f64 = 1e-7;
/// The same for the sine of the angle between two edges at a vertex.
const APART: f64 = 1e-11;
/// An edge that is in line with a ray lies on its other side if the cosine between them is below minus this. The angle to
/// the exact opposite is then below [`APART`] / [`OPPOSITE`], which must be well below [`FACING`], the least angle of a
/// triangle.
const OPPOSITE: f64 = 1e-3;
/// Slack of the floating-point boxes, as a fraction of the largest coordinate and of the extent of the mesh.
const SLACK: f64 = 1e-14;
/// No vertex.
const NONE: u32 = u32::MAX;

/// Pairs of boxes, for each triangle, after which [`check`] gives up. Meshes that are embedded or cross themselves
/// along curves take 10 to 60; only sheets that lie on each other in many layers take more.
const WORK_PER_TRIANGLE: u64 = 2000;
/// Pairs of boxes that a check may look at whatever the size of the mesh.
const LEAST_WORK: u64 = 1 << 20;

/// What is reported about the self-intersections of a mesh that leaves a solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelfIntersectionCheck {
    /// Number of pairs of triangles that intersect; `None` if not all pairs were looked at.
    pub pairs: Option<u64>,
    /// Why not.
    pub skipped: Option<Skipped>,
}

/// Why a mesh was not checked for self-intersections, or not to the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Skipped {
    /// It has more triangles than are checked.
    TooManyTriangles,
    /// So many triangles lie on each other that the pairs are too many to look at.
    TooManyPairs,
    /// The deadline passed while the mesh was checked.
    DeadlinePassed,
}

impl Skipped {
    /// A stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::TooManyTriangles => "too_many_triangles",
            Self::TooManyPairs => "too_many_pairs",
            Self::DeadlinePassed => "deadline_passed",
        }
    }
}

/// Checks a mesh that leaves a solver. The warning `self_intersections` says how many pairs of triangles intersect, and
/// where.
///
/// # Errors
/// [`Interruption::Cancelled`]. A deadline that passes ends the check, and the mesh is still good.
pub fn check(
    mesh: &Mesh,
    order: Order,
    most_triangles: usize,
    exec: &Execution<'_>,
) -> Result<(SelfIntersectionCheck, Option<Warning>), Interruption> {
    let skipped = |why| (SelfIntersectionCheck { pairs: None, skipped: Some(why) }, None);
    if mesh.triangles.len() > most_triangles {
        return Ok(skipped(Skipped::TooManyTriangles));
    }
    let most_work = LEAST_WORK + WORK_PER_TRIANGLE * mesh.triangles.len() as u64;
    let found = match self_intersections(&mesh.vertices, &mesh.triangles, order, most_work, exec) {
        Err(Interruption::DeadlinePassed) => return Ok(skipped(Skipped::DeadlinePassed)),
        found => found?,
    };
    let warning = found.place.map(|place| {
        let least = if found.complete { "" } else { "at least " };
        let detail = format!(
            "{least}{} pairs of triangles cross or touch each other beyond the vertices and edges that they share, \
             for example at ({}, {}, {})",
            found.pairs, place.x, place.y, place.z
        );
        Warning::new("self_intersections", detail)
    });
    let check = SelfIntersectionCheck {
        pairs: found.complete.then_some(found.pairs),
        skipped: (!found.complete).then_some(Skipped::TooManyPairs),
    };
    Ok((check, warning))
}

/// How the triangles are arranged before the tree is built over them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Neighbours in the list are neighbours in space, as along a strip.
    AsGiven,
    /// Along a space-filling curve (Morton's order).
    Spatial,
}

/// What a search for self-intersections found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SelfIntersections {
    /// Number of pairs of triangles that intersect.
    pub pairs: u64,
    /// False if the search used up its work before it had seen all pairs. Then `pairs` is a lower bound.
    pub complete: bool,
    /// A point where two triangles meet: those with the lowest numbers among the pairs seen.
    pub place: Option<DVec3>,
}

/// Finds all self-intersections of a triangle mesh, or gives up after `most_work` pairs of boxes.
///
/// # Errors
/// The interruptions of `exec`.
///
/// # Panics
/// If a triangle names a vertex that does not exist.
pub fn self_intersections(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    order: Order,
    most_work: u64,
    exec: &Execution<'_>,
) -> Result<SelfIntersections, Interruption> {
    let soup = Soup::new(vertices, triangles, exec)?;
    let stars = soup.embedded_stars(exec)?;
    let tree = Tree::new(&soup, order, |t| largest_star(&soup.triangles[t], &stars), exec)?;
    let mut found = SelfIntersections { complete: true, ..SelfIntersections::default() };
    let mut first = [NONE; 2];
    let same_star = |a: u32, b: u32| a != NONE && a == b;
    let visit = |a: u32, b: u32| {
        let [one, other] = [a, b].map(|t| soup.triangles[t as usize]);
        if let Some(point) = soup.meet(one, other, &stars) {
            found.pairs += 1;
            let pair = [a.min(b), a.max(b)];
            if pair < first {
                first = pair;
                found.place = Some(point);
            }
        }
        ControlFlow::Continue(())
    };
    found.complete = tree.visit_pairs(most_work, same_star, visit, exec)?;
    found.place = found.place.map(|place| place * soup.unit);
    Ok(found)
}

/// Whether two surfaces pass through each other: an edge of one pierces the inside of a triangle of the other.
///
/// Unlike [`self_intersections`], touching and lying in one plane do not count: two discs in a plane, one inside the
/// other, do not cross.
///
/// # Errors
/// The interruptions of `exec`.
///
/// # Panics
/// If a triangle names a vertex that does not exist.
pub fn surfaces_cross(
    first: (&[DVec3], &[[u32; 3]]),
    second: (&[DVec3], &[[u32; 3]]),
    exec: &Execution<'_>,
) -> Result<bool, Interruption> {
    let offset = first.0.len() as u32;
    let vertices: Vec<DVec3> = first.0.iter().chain(second.0).copied().collect();
    let moved = second.1.iter().map(|triangle| triangle.map(|v| v + offset));
    let triangles: Vec<[u32; 3]> = first.1.iter().copied().chain(moved).collect();
    let soup = Soup::new(&vertices, &triangles, exec)?;
    // Every triangle and every node has the number of its surface; a node with triangles of both has none.
    let surface = |t: usize| u32::from(t >= first.1.len());
    let tree = Tree::new(&soup, Order::Spatial, surface, exec)?;
    let same_surface = |a: u32, b: u32| a != NONE && a == b;
    let mut cross = false;
    let visit = |a: u32, b: u32| {
        let [one, other] = [a, b].map(|t| soup.corners(soup.triangles[t as usize]));
        if surface(a as usize) != surface(b as usize) && (pierces(&one, &other) || pierces(&other, &one)) {
            cross = true;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    };
    tree.visit_pairs(u64::MAX, same_surface, visit, exec)?;
    Ok(cross)
}

/// Triangles over points, without connectivity.
struct Soup {
    /// The vertices times a power of two, so that the largest coordinate is about 1: exact, and no product under- or
    /// overflows.
    points: Vec<DVec3>,
    unit: f64,
    /// Corners; vertices with equal coordinates have the lowest of their numbers.
    triangles: Vec<[u32; 3]>,
    /// Twice the area vector of each triangle, rounded; zero for triangles without area, exactly.
    normals: Vec<DVec3>,
}

impl Soup {
    fn new(vertices: &[DVec3], triangles: &[[u32; 3]], exec: &Execution<'_>) -> Result<Self, Interruption> {
        let largest = vertices.iter().fold(0.0f64, |largest, v| largest.max(v.abs().max_element()));
        let unit = power_of_two_above(largest);
        // Adding zero turns -0 into 0, so that equal coordinates have equal bits.
        let points: Vec<DVec3> = vertices.iter().map(|&v| v * unit.recip() + DVec3::ZERO).collect();
        let representative = representatives(&points, exec)?;
        let mut soup = Self { points, unit, triangles: Vec::new(), normals: Vec::new() };
        soup.triangles.reserve_exact(triangles.len());
        soup.normals.reserve_exact(triangles.len());
        for chunk in triangles.chunks(LOOK) {
            for triangle in chunk {
                let triangle = triangle.map(|v| representative[v as usize]);
                let corners = soup.corners(triangle);
                let [a, b, c] = corners;
                let (u, v) = (b - a, c - a);
                let normal = u.cross(v);
                // A cross product well above rounding is not zero; the others are decided exactly.
                let is_clear = normal.length_squared() > 1e-24 * u.length_squared() * v.length_squared();
                let has_area = is_clear || plane_axes(&corners).is_some();
                soup.triangles.push(triangle);
                soup.normals.push(match (has_area, normal == DVec3::ZERO) {
                    (false, _) => DVec3::ZERO,
                    (true, false) => normal,
                    // An area so small that it rounds to zero has no normal to speak of: any will do.
                    (true, true) => DVec3::splat(f64::MIN_POSITIVE),
                });
            }
            exec.look(chunk.len() as u64)?;
        }
        Ok(soup)
    }

    fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| self.points[v as usize])
    }

    /// For each vertex the number of its triangles if no two of them can intersect: they form one fan, all of them face
    /// the sum of their normals, and seen from there the fan goes round the vertex at most once. Zero where that is not
    /// certain.
    fn embedded_stars(&self, exec: &Execution<'_>) -> Result<Vec<u32>, Interruption> {
        let mut start = vec![0u32; self.points.len() + 1];
        for triangle in self.with_area() {
            for v in self.triangles[triangle] {
                start[v as usize + 1] += 1;
            }
        }
        exec.look(self.triangles.len() as u64)?;
        for v in 0..self.points.len() {
            start[v + 1] += start[v];
        }
        let mut incident = vec![0u32; start[self.points.len()] as usize];
        let mut cursor = start.clone();
        for triangle in self.with_area() {
            for (k, v) in self.triangles[triangle].into_iter().enumerate() {
                let slot = &mut cursor[v as usize];
                incident[*slot as usize] = (3 * triangle + k) as u32;
                *slot += 1;
            }
        }
        exec.look(self.triangles.len() as u64)?;
        let mut stars = vec![0; self.points.len()];
        let mut scratch = [Vec::new(), Vec::new()];
        let mut work = 0;
        for v in 0..self.points.len() {
            let corners = &incident[start[v] as usize..start[v + 1] as usize];
            if self.is_embedded(v, corners, &mut scratch) {
                stars[v] = corners.len() as u32;
            }
            work += 1 + corners.len();
            if work >= LOOK {
                exec.look(work as u64)?;
                work = 0;
            }
        }
        Ok(stars)
    }

    fn with_area(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.triangles.len()).filter(|&t| self.normals[t] != DVec3::ZERO)
    }

    /// `corners` are 3 t + k for each triangle t whose corner k is the vertex.
    fn is_embedded(&self, vertex: usize, corners: &[u32], [after, before]: &mut [Vec<u32>; 2]) -> bool {
        let ends = |corner: u32| {
            let (triangle, k) = (self.triangles[corner as usize / 3], corner as usize % 3);
            (triangle[(k + 1) % 3], triangle[(k + 2) % 3])
        };
        // The neighbours after the vertex in its triangles, and those before it: in one fan every neighbour is in both
        // lists once, but for the two ends of a fan that is open.
        after.clear();
        before.clear();
        for &corner in corners {
            let (a, b) = ends(corner);
            after.push(a);
            before.push(b);
        }
        after.sort_unstable();
        before.sort_unstable();
        let repeats = |list: &[u32]| list.windows(2).any(|pair| pair[0] == pair[1]);
        if corners.is_empty() || repeats(after) || repeats(before) {
            return false;
        }
        let mut starts = after.iter().filter(|a| before.binary_search(a).is_err());
        let ray = starts.next().unwrap_or(&after[0]);
        if starts.next().is_some() {
            return false;
        }
        let centre = self.points[vertex];
        let normal: DVec3 = corners.iter().map(|&corner| self.normals[corner as usize / 3]).sum();
        let facing = normal.length();
        let direction = self.points[*ray as usize] - centre;
        let size = |v: DVec3| v.abs().element_sum();
        // The triangles that the ray runs through, the one that it bounds on the right among them.
        let mut covered = 0;
        for &corner in corners {
            let (a, b) = ends(corner);
            let (to_a, to_b) = (self.points[a as usize] - centre, self.points[b as usize] - centre);
            let area = self.normals[corner as usize / 3];
            let is_facing = area.dot(normal) > FACING * size(to_a) * size(to_b) * facing;
            if !is_facing {
                return false;
            }
            // An edge on the ray's other side bounds no triangle that the ray runs through, since each is narrower than
            // a half-plane. On which side of the line it lies is not needed, and may be rounding.
            let is_opposite = |to: DVec3| {
                let along = direction.dot(to) - direction.dot(normal) * to.dot(normal) / (facing * facing);
                let sine = normal.dot(direction.cross(to));
                let scale = size(direction) * size(to);
                along < -OPPOSITE * scale && sine.abs() <= APART * facing * scale
            };
            if is_opposite(to_a) || is_opposite(to_b) {
                continue;
            }
            let side = |end: u32, to: DVec3| {
                let sine = if end == *ray { 0.0 } else { normal.dot(direction.cross(to)) };
                let certain = end == *ray || sine.abs() > APART * facing * size(direction) * size(to);
                certain.then_some(sine)
            };
            let (Some(right), Some(left)) = (side(a, to_a), side(b, to_b)) else { return false };
            covered += usize::from(right <= 0.0 && left > 0.0);
        }
        covered == 1
    }

    /// A point where two triangles meet beyond what they share.
    fn meet(&self, one: [u32; 3], other: [u32; 3], stars: &[u32]) -> Option<DVec3> {
        let mut shared = [(0, 0); 3];
        let mut count = 0;
        for (i, &v) in one.iter().enumerate() {
            for (j, &w) in other.iter().enumerate() {
                if v == w {
                    if stars[v as usize] > 0 {
                        return None;
                    }
                    shared[count] = (i, j);
                    count += 1;
                }
            }
        }
        let (a, b) = (self.corners(one), self.corners(other));
        match count {
            0 => meet_apart(&a, &b),
            1 => {
                // What meets beyond the shared vertex reaches the edge opposite it, in one of the triangles.
                let (i, j) = shared[0];
                segment_meets_triangle(a[(i + 1) % 3], a[(i + 2) % 3], &b)
                    .or_else(|| segment_meets_triangle(b[(j + 1) % 3], b[(j + 2) % 3], &a))
            }
            2 => {
                let ([(i, j), (k, l), _], sum) = (shared, 3);
                let (third, fourth) = (a[sum - i - k], b[sum - j - l]);
                overlap_beside_edge(a[i], a[k], third, fourth)
            }
            _ => Some((a[0] + a[1] + a[2]) / 3.0),
        }
    }
}

/// The corner with the most triangles among those whose triangles cannot intersect, or [`NONE`]. All triangles of a
/// large fan name its centre, so that the fan is settled as a whole.
fn largest_star(triangle: &[u32; 3], stars: &[u32]) -> u32 {
    let most = triangle.iter().copied().max_by_key(|&v| (stars[v as usize], std::cmp::Reverse(v)));
    most.filter(|&v| stars[v as usize] > 0).unwrap_or(NONE)
}

/// For each point the lowest number of those with the same coordinates.
fn representatives(points: &[DVec3], exec: &Execution<'_>) -> Result<Vec<u32>, Interruption> {
    // A hash table with open addressing, at most half full.
    let size = (2 * points.len()).next_power_of_two().max(2);
    let mut table = vec![NONE; size];
    let mut representative = Vec::with_capacity(points.len());
    for (k, point) in points.iter().enumerate() {
        let mixed = point.to_array().iter().fold(0u64, |hash, coordinate| {
            (hash.rotate_left(23) ^ coordinate.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15)
        });
        let mut slot = (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9) as usize >> 7 & (size - 1);
        loop {
            let there = table[slot];
            if there == NONE {
                table[slot] = k as u32;
                representative.push(k as u32);
                break;
            }
            if points[there as usize] == *point {
                representative.push(there);
                break;
            }
            slot = (slot + 1) & (size - 1);
        }
        if k % LOOK == LOOK - 1 {
            exec.look(LOOK as u64)?;
        }
    }
    Ok(representative)
}

/// A power of two above a length, 1 for zero.
fn power_of_two_above(length: f64) -> f64 {
    let exponent = (length.to_bits() >> 52) & 0x7ff;
    if length == 0.0 { 1.0 } else { f64::from_bits((exponent + 1).clamp(23, 2023) << 52) }
}

/// A box along the axes.
#[derive(Clone, Copy)]
struct AxisBox {
    low: DVec3,
    high: DVec3,
}

impl AxisBox {
    const EMPTY: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    fn of(corners: &[DVec3; 3]) -> Self {
        let [a, b, c] = *corners;
        Self { low: a.min(b).min(c), high: a.max(b).max(c) }
    }
    fn with(&self, other: &Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
    fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
            && self.low.z <= other.high.z
            && other.low.z <= self.high.z
    }
}

/// A box along axes of its own.
#[derive(Clone, Copy)]
struct OwnBox {
    axes: [DVec3; 3],
    centre: DVec3,
    half: DVec3,
    /// The sum of the triangles' area vectors, and of their longest edges, each of these turned to the side of the
    /// others.
    normal: DVec3,
    along: DVec3,
}

impl OwnBox {
    const EMPTY: Self =
        Self { axes: DVec3::AXES, centre: DVec3::ZERO, half: DVec3::ZERO, normal: DVec3::ZERO, along: DVec3::ZERO };

    /// The axes for a normal and a direction; the extent is not set.
    fn directed(normal: DVec3, along: DVec3) -> Self {
        let third = normal.normalize_or(DVec3::Z);
        // Twice, since the first difference may have lost most of its digits.
        let across = |v: DVec3| (v - third * v.dot(third)).try_normalize();
        let first = across(along).and_then(across).unwrap_or_else(|| third.any_orthonormal_vector());
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

    /// Whether one of the two boxes' own axes separates them by more than `slack`.
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

/// A balanced binary tree over the triangles that have an area. Node 1 is the root, the children of k are 2k and 2k +
/// 1.
struct Tree {
    /// Triangles in the order of the leaves, and their boxes.
    order: Vec<u32>,
    boxes: Vec<AxisBox>,
    nodes: Vec<AxisBox>,
    own: Vec<OwnBox>,
    /// The label that all triangles of a node have, or [`NONE`].
    labels: Vec<u32>,
    /// The first leaf's node.
    base: usize,
    slack: f64,
}

impl Tree {
    fn new(
        soup: &Soup,
        order: Order,
        label: impl Fn(usize) -> u32,
        exec: &Execution<'_>,
    ) -> Result<Self, Interruption> {
        let mut list: Vec<u32> = soup.with_area().map(|t| t as u32).collect();
        let whole = list
            .iter()
            .fold(AxisBox::EMPTY, |whole, &t| whole.with(&AxisBox::of(&soup.corners(soup.triangles[t as usize]))));
        exec.look(list.len() as u64)?;
        if order == Order::Spatial {
            sort_along_curve(soup, &mut list, &whole, exec)?;
        }
        let leaves = list.len().div_ceil(LEAF).max(1);
        let base = leaves.next_power_of_two();
        let mut tree = Self {
            boxes: Vec::with_capacity(list.len()),
            nodes: vec![AxisBox::EMPTY; 2 * base],
            own: vec![OwnBox::EMPTY; 2 * base],
            labels: vec![NONE; 2 * base],
            base,
            // Coordinates are at most 1: their rounding, and that of extents, moves a box by less than this.
            slack: SLACK,
            order: list,
        };
        // Own boxes are computed from a point of the mesh, so that the rounding is that of the extent.
        let origin = if tree.order.is_empty() { DVec3::ZERO } else { 0.5 * (whole.low + whole.high) };
        if !tree.order.is_empty() {
            let extent = (whole.high - whole.low).max_element();
            tree.slack = SLACK * extent + 4.0 * f64::EPSILON * whole.low.abs().max(whole.high.abs()).max_element();
        }
        let mut corners = Vec::with_capacity(LEAF);
        for (leaf, triangles) in tree.order.chunks(LEAF).enumerate() {
            corners.clear();
            let node = base + leaf;
            tree.labels[node] = label(triangles[0] as usize);
            for &t in triangles {
                let here = soup.corners(soup.triangles[t as usize]);
                let extent = AxisBox::of(&here);
                tree.boxes.push(extent);
                tree.nodes[node] = tree.nodes[node].with(&extent);
                corners.push(here.map(|corner| corner - origin));
                if label(t as usize) != tree.labels[node] {
                    tree.labels[node] = NONE;
                }
            }
            tree.own[node] = OwnBox::of(&corners);
            if leaf % (LOOK / LEAF) == 0 {
                exec.look(LOOK as u64)?;
            }
        }
        for node in (1..base).rev() {
            let [left, right] = [2 * node, 2 * node + 1];
            tree.nodes[node] = tree.nodes[left].with(&tree.nodes[right]);
            let is_empty = tree.nodes[right].low.x == f64::INFINITY;
            tree.own[node] = if is_empty { tree.own[left] } else { tree.own[left].with(&tree.own[right]) };
            let same = is_empty || tree.labels[left] == tree.labels[right];
            tree.labels[node] = if same { tree.labels[left] } else { NONE };
            if node % LOOK == 0 {
                exec.look(LOOK as u64)?;
            }
        }
        Ok(tree)
    }

    /// Visits every pair of triangles whose boxes meet, unless the labels of both sides say that it is not needed.
    /// False if the work was used up before, or the visitor broke off.
    fn visit_pairs(
        &self,
        most_work: u64,
        skip: impl Fn(u32, u32) -> bool,
        mut visit: impl FnMut(u32, u32) -> ControlFlow<()>,
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
            if skip(self.labels[a], self.labels[b]) {
                continue;
            }
            if a != b && (!self.nodes[a].meets(&self.nodes[b]) || self.own[a].is_apart(&self.own[b], self.slack)) {
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
            work += LEAF;
            for first in self.leaf(a) {
                let seconds = if a == b { first + 1..self.leaf(b).end } else { self.leaf(b) };
                for second in seconds {
                    if self.boxes[first].meets(&self.boxes[second])
                        && visit(self.order[first], self.order[second]).is_break()
                    {
                        return Ok(false);
                    }
                }
            }
        }
        exec.look(work as u64)?;
        Ok(true)
    }

    fn leaf(&self, node: usize) -> std::ops::Range<usize> {
        let start = (node - self.base) * LEAF;
        start.min(self.order.len())..(start + LEAF).min(self.order.len())
    }
}

/// Sorts triangles by the Morton code of their centre: ten bits an axis, stable.
fn sort_along_curve(
    soup: &Soup,
    list: &mut Vec<u32>,
    whole: &AxisBox,
    exec: &Execution<'_>,
) -> Result<(), Interruption> {
    /// Bits sorted by in one pass.
    const BITS: u32 = 10;
    let scale = 1023.0 / (whole.high - whole.low).max(DVec3::splat(f64::MIN_POSITIVE));
    let spread = |value: f64| {
        let mut bits = value as u32 & 0x3ff;
        bits = (bits | bits << 16) & 0x030000ff;
        bits = (bits | bits << 8) & 0x0300f00f;
        bits = (bits | bits << 4) & 0x030c30c3;
        (bits | bits << 2) & 0x09249249
    };
    let code = |t: u32| {
        let [a, b, c] = soup.corners(soup.triangles[t as usize]);
        let at = ((a + b + c) / 3.0 - whole.low) * scale;
        spread(at.x) | spread(at.y) << 1 | spread(at.z) << 2
    };
    let mut keyed: Vec<(u32, u32)> = list.iter().map(|&t| (code(t), t)).collect();
    exec.look(list.len() as u64)?;
    let mut sorted = vec![(0, 0); keyed.len()];
    for pass in 0..3 {
        let digit = |code: u32| (code >> (pass * BITS) & ((1 << BITS) - 1)) as usize;
        let mut start = [0usize; (1 << BITS) + 1];
        keyed.iter().for_each(|&(code, _)| start[digit(code) + 1] += 1);
        for k in 0..1 << BITS {
            start[k + 1] += start[k];
        }
        for &(code, t) in &keyed {
            let slot = &mut start[digit(code)];
            sorted[*slot] = (code, t);
            *slot += 1;
        }
        std::mem::swap(&mut keyed, &mut sorted);
        exec.look(list.len() as u64)?;
    }
    list.clear();
    list.extend(keyed.iter().map(|&(_, t)| t));
    Ok(())
}

/// Where two triangles without a common vertex meet.
fn meet_apart(a: &[DVec3; 3], b: &[DVec3; 3]) -> Option<DVec3> {
    for (one, other) in [(a, b), (b, a)] {
        let sides = other.map(|corner| volume(one, corner));
        if sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0) {
            return None;
        }
    }
    // Two triangles meet if an edge of one meets the other; one inside the other, in its plane, is such a case.
    [(a, b), (b, a)]
        .into_iter()
        .find_map(|(one, other)| (0..3).find_map(|k| segment_meets_triangle(one[k], one[(k + 1) % 3], other)))
}

/// Whether the triangles on two sides of a common edge, with their third corners there, lie folded onto each other in
/// one plane.
fn overlap_beside_edge(from: DVec3, to: DVec3, third: DVec3, fourth: DVec3) -> Option<DVec3> {
    let triangle = [from, to, third];
    if volume(&triangle, fourth) != 0.0 {
        return None;
    }
    let axes = plane_axes(&triangle)?;
    let same = turn(axes, from, to, third) * turn(axes, from, to, fourth) > 0.0;
    same.then(|| (from + to) * 0.5)
}

/// Where a segment meets a triangle that has an area, both closed. Exact but for the point itself.
fn segment_meets_triangle(p: DVec3, q: DVec3, triangle: &[DVec3; 3]) -> Option<DVec3> {
    let (above, below) = (volume(triangle, p), volume(triangle, q));
    if above == 0.0 && below == 0.0 {
        return segment_meets_in_plane(p, q, triangle);
    }
    if (above > 0.0 && below > 0.0) || (above < 0.0 && below < 0.0) {
        return None;
    }
    let [a, b, c] = *triangle;
    let turns = [volume(&[p, q, a], b), volume(&[p, q, b], c), volume(&[p, q, c], a)];
    let meets = turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0);
    meets.then(|| p + (q - p) * (above / (above - below)))
}

fn segment_meets_in_plane(p: DVec3, q: DVec3, triangle: &[DVec3; 3]) -> Option<DVec3> {
    let axes = plane_axes(triangle)?;
    let turn = |a: DVec3, b: DVec3, c: DVec3| turn(axes, a, b, c);
    let [a, b, c] = *triangle;
    let edges = [(a, b), (b, c), (c, a)];
    let orientation = turn(a, b, c).signum();
    let is_inside = |point: DVec3| edges.iter().all(|&(from, to)| turn(from, to, point) * orientation >= 0.0);
    if let Some(inside) = [p, q].into_iter().find(|&end| is_inside(end)) {
        return Some(inside);
    }
    edges.into_iter().find_map(|(from, to)| {
        let ends = [turn(from, to, p), turn(from, to, q)];
        let sides = [turn(p, q, from), turn(p, q, to)];
        if ends == [0.0; 2] {
            // On one line: neither end is inside, so the segment covers the edge or misses it.
            let covers = from.cmpge(p.min(q)).all() && from.cmple(p.max(q)).all();
            return covers.then_some(from);
        }
        let opposite = |[one, other]: [f64; 2]| !(one > 0.0 && other > 0.0 || one < 0.0 && other < 0.0);
        (opposite(ends) && opposite(sides)).then(|| p + (q - p) * (ends[0] / (ends[0] - ends[1])))
    })
}

/// Whether an edge of `edges` runs through the inside of `triangle`.
fn pierces(edges: &[DVec3; 3], triangle: &[DVec3; 3]) -> bool {
    let [a, b, c] = *triangle;
    (0..3).any(|k| {
        let (p, q) = (edges[k], edges[(k + 1) % 3]);
        let (above, below) = (volume(triangle, p), volume(triangle, q));
        if !(above > 0.0 && below < 0.0 || above < 0.0 && below > 0.0) {
            return false;
        }
        let turns = [volume(&[p, q, a], b), volume(&[p, q, b], c), volume(&[p, q, c], a)];
        turns.iter().all(|&turn| turn > 0.0) || turns.iter().all(|&turn| turn < 0.0)
    })
}

/// The volume of a triangle and a point, times six: its sign is exact.
fn volume([a, b, c]: &[DVec3; 3], d: DVec3) -> f64 {
    let coord = |p: DVec3| Coord3D { x: p.x, y: p.y, z: p.z };
    orient3d(coord(*a), coord(*b), coord(*c), coord(d))
}

/// The area of a triangle seen along an axis, times two: its sign is exact.
fn turn([u, v]: [usize; 2], a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let coord = |p: DVec3| Coord { x: p[u], y: p[v] };
    orient2d(coord(a), coord(b), coord(c))
}

/// Two axes in whose plane the triangle has an area; `None` if it has none at all.
fn plane_axes(&[a, b, c]: &[DVec3; 3]) -> Option<[usize; 2]> {
    [[0, 1], [1, 2], [2, 0]].into_iter().find(|&axes| turn(axes, a, b, c) != 0.0)
}
