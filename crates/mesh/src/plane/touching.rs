//! Joins closed polygons that touch at points into the loops that bound the region between them.
//!
//! If a hole touches the outline or another hole at a point, the region around that point consists of several fans. In
//! a manifold mesh every vertex has only one fan. The mesh therefore has one vertex per fan at the point, and its
//! boundary passes from one polygon to the other there. [`meeting`] finds these loops.

use super::polygon::{contains, doubled_area};
use crate::execution::{Execution, Interruption};
use crate::polyline::contact::{MeetingSegments, Segments, first_contact};
use crate::{DVec2, DVec3};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

/// The number of a polygon and the number of one of its points. Where pairs of polygons are stored, both numbers are
/// numbers of polygons.
pub type PointOf = (usize, usize);

/// A vertex of a joined loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// The point of a polygon that is this vertex. For an added vertex, the start of the side on which it was added
    /// because another polygon touches the side there.
    pub source: PointOf,
    /// Whether the vertex was added on a side of its polygon.
    pub added: bool,
    /// The point that gives the vertex its coordinates. Vertices that touch each other have the same point here.
    pub place: PointOf,
}

/// How polygons meet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Meeting {
    /// No polygons touch: each polygon is a loop of its own.
    Apart,
    /// Some polygons touch at points. The joined loops are given in the order of their first polygons, each in the
    /// direction of its first polygon.
    Touching(Vec<Vec<Corner>>),
    /// Two sides cross or share more than a point. Each side is given by the point at which it starts.
    Crossing([PointOf; 2]),
}

/// Number of pairs of boxes that are compared between two calls of [`Execution::look`].
const BOXES_PER_LOOK: usize = 1 << 16;
/// Two edges at a common point count as lying on each other if their directions differ by at most this angle, in
/// radians. Their polygons then share a piece of a side.
const SAME_DIRECTION: f64 = 1e-9;

/// Finds how polygons meet each other. Points and sides touch if they are at most `tolerance` apart. A polygon that
/// touches itself counts as crossing, except at points with equal coordinates, which the triangulation checks. O(n log
/// n) for n points, plus a comparison of boxes for every pair of polygons.
///
/// # Errors
/// The interruptions of `exec`.
pub fn meeting(polygons: &[Vec<DVec2>], tolerance: f64, exec: &Execution<'_>) -> Result<Meeting, Interruption> {
    let contacts = match Contacts::between(polygons, tolerance, exec)? {
        Ok(contacts) => contacts,
        Err(sides) => return Ok(Meeting::Crossing(sides)),
    };
    if contacts.place.is_empty() {
        return Ok(Meeting::Apart);
    }
    let nodes = Nodes::new(polygons, &contacts);
    Ok(match nodes.link(polygons) {
        Ok(None) => Meeting::Apart,
        Ok(Some(next)) => Meeting::Touching(nodes.loops(&next)),
        Err(sides) => Meeting::Crossing(sides),
    })
}

/// The points at which polygons touch.
#[derive(Default)]
struct Contacts {
    /// For each point that touches another polygon, the first of the points at the same place.
    place: BTreeMap<PointOf, PointOf>,
    /// For each side, the points of other polygons that touch it between its ends.
    on_side: BTreeMap<PointOf, BTreeSet<PointOf>>,
    /// The pairs of polygons that touch.
    touching: BTreeSet<PointOf>,
}

impl Contacts {
    /// Finds the points at which polygons touch. Returns two sides that cross instead, if there are any.
    fn between(
        polygons: &[Vec<DVec2>],
        tolerance: f64,
        exec: &Execution<'_>,
    ) -> Result<Result<Self, [PointOf; 2]>, Interruption> {
        let flat: Vec<Vec<DVec3>> =
            polygons.iter().map(|points| points.iter().map(|p| p.extend(0.0)).collect()).collect();
        let segments: Vec<Segments> = flat.iter().map(|points| Segments::new(points, true)).collect();
        let boxes: Vec<[DVec2; 2]> = polygons.iter().map(|points| bounds(points)).collect();
        let mut contacts = Self::default();
        let mut compared = 0;
        for k in 0..polygons.len() {
            compared += polygons.len() - k;
            if compared >= BOXES_PER_LOOK {
                exec.look(std::mem::take(&mut compared) as u64)?;
            }
            let count = polygons[k].len();
            for l in k..polygons.len() {
                let apart = (boxes[k][0] - boxes[l][1]).max(boxes[l][0] - boxes[k][1]).max_element();
                if apart > tolerance {
                    continue;
                }
                let found: RefCell<Vec<PointOf>> = RefCell::default();
                let are_neighbours = |i: usize, j: usize| i + 1 >= j || (j + 1) % count == i;
                let note = |contact: &MeetingSegments| {
                    if k != l || !are_neighbours(contact.first, contact.second) {
                        found.borrow_mut().push((contact.first, contact.second));
                    }
                    false
                };
                first_contact(&segments[k], &segments[l], tolerance, note, exec)?;
                for (i, j) in found.into_inner() {
                    let is_one_place = || {
                        let ends = |k: usize, i: usize| [polygons[k][i], polygons[k][(i + 1) % polygons[k].len()]];
                        ends(k, i).iter().any(|p| ends(l, j).contains(p))
                    };
                    if k == l && is_one_place() {
                        continue;
                    }
                    if k == l || !contacts.add([(k, i), (l, j)], polygons, tolerance) {
                        return Ok(Err([(k, i), (l, j)]));
                    }
                }
            }
        }
        Ok(Ok(contacts))
    }

    /// Records how two sides meet. Returns `false` if neither side has an end on the other.
    fn add(&mut self, sides: [PointOf; 2], polygons: &[Vec<DVec2>], tolerance: f64) -> bool {
        let position = |(k, i): PointOf| polygons[k][i];
        let ends = |(k, i): PointOf| [(k, i), (k, (i + 1) % polygons[k].len())];
        let mut touch = false;
        let mut on_a_corner = BTreeSet::new();
        for p in ends(sides[0]) {
            for q in ends(sides[1]) {
                if position(p).distance(position(q)) <= tolerance {
                    self.unite(p, q);
                    on_a_corner.extend([p, q]);
                    touch = true;
                }
            }
        }
        for (side, other) in [(sides[0], sides[1]), (sides[1], sides[0])] {
            let [a, b] = ends(side).map(position);
            for p in ends(other) {
                if !on_a_corner.contains(&p) && distance_from_side(position(p), a, b) <= tolerance {
                    self.unite(p, p);
                    self.on_side.entry(side).or_default().insert(p);
                    touch = true;
                }
            }
        }
        if touch {
            self.touching.insert((sides[0].0, sides[1].0));
        }
        touch
    }

    fn unite(&mut self, p: PointOf, q: PointOf) {
        let [a, b] = [p, q].map(|point| self.place.get(&point).copied().unwrap_or(point));
        let first = a.min(b);
        self.place.extend([(p, first), (q, first)]);
        self.place.values_mut().filter(|place| **place == a || **place == b).for_each(|place| *place = first);
    }
}

fn bounds(points: &[DVec2]) -> [DVec2; 2] {
    let empty = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    points.iter().fold(empty, |[low, high], &p| [low.min(p), high.max(p)])
}

fn distance_from_side(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let part = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (a + along * part).distance(p)
}

/// The vertices of all polygons, including the vertices that were added on their sides.
struct Nodes {
    corners: Vec<Corner>,
    /// For each vertex, the next vertex of its polygon. The polygon runs so that the region is on its left.
    following: Vec<usize>,
    /// For each polygon, its first vertex, and whether the polygon was reversed to have the region on its left.
    polygons: Vec<(usize, bool)>,
}

impl Nodes {
    fn new(polygons: &[Vec<DVec2>], contacts: &Contacts) -> Self {
        let mut nodes = Self { corners: Vec::new(), following: Vec::new(), polygons: Vec::new() };
        for (k, points) in polygons.iter().enumerate() {
            let first = nodes.corners.len();
            for (i, &point) in points.iter().enumerate() {
                let own = (k, i);
                let place = contacts.place.get(&own).copied().unwrap_or(own);
                nodes.corners.push(Corner { source: own, added: false, place });
                let mut added: Vec<PointOf> = contacts.on_side.get(&own).into_iter().flatten().copied().collect();
                let way = |&(l, j): &PointOf| polygons[l][j].distance_squared(point);
                added.sort_by(|p, q| way(p).total_cmp(&way(q)));
                let mut places: Vec<PointOf> = added.iter().map(|point| contacts.place[point]).collect();
                places.dedup();
                nodes.corners.extend(places.into_iter().map(|place| Corner { source: own, added: true, place }));
            }
            let depth = (0..polygons.len()).filter(|&l| l != k && contacts.lies_in(k, l, polygons)).count();
            let is_counter_clockwise = doubled_area(points.iter().copied(), points[0]) > 0.0;
            let reversed = is_counter_clockwise != depth.is_multiple_of(2);
            let count = nodes.corners.len() - first;
            let step = if reversed { count - 1 } else { 1 };
            nodes.following.extend((0..count).map(|i| first + (i + step) % count));
            nodes.polygons.push((first, reversed));
        }
        nodes
    }

    /// For each vertex, the next vertex of its joined loop. `None` if no polygons are joined.
    ///
    /// # Errors
    /// Two sides that do more than touch.
    fn link(&self, polygons: &[Vec<DVec2>]) -> Result<Option<Vec<usize>>, [PointOf; 2]> {
        let position = |v: usize| polygons[self.corners[v].place.0][self.corners[v].place.1];
        let mut before = vec![0; self.following.len()];
        self.following.iter().enumerate().for_each(|(v, &after)| before[after] = v);
        let mut places: BTreeMap<PointOf, Vec<usize>> = BTreeMap::new();
        for (v, corner) in self.corners.iter().enumerate() {
            places.entry(corner.place).or_default().push(v);
        }
        let mut next = self.following.clone();
        let mut is_joined = false;
        for vertices in places.values().filter(|vertices| vertices.len() > 1) {
            // The edges at the place: the angle of each edge's direction, whether the edge ends here (otherwise it
            // starts here), and its vertex here.
            let mut edges: Vec<(f64, bool, usize)> = Vec::new();
            for &v in vertices {
                for (comes, neighbour) in [(true, before[v]), (false, self.following[v])] {
                    let direction = position(neighbour) - position(v);
                    edges.push((libm::atan2(direction.y, direction.x), comes, v));
                }
            }
            edges.sort_by(|a, b| b.0.total_cmp(&a.0));
            let turn = std::f64::consts::TAU;
            let following = |k: usize| edges[(k + 1) % edges.len()];
            let faulty = |lie_on_each_other: bool| {
                (0..edges.len()).find(|&k| {
                    let (between, wraps) = (edges[k].0 - following(k).0, k + 1 == edges.len());
                    let between = if wraps { between + turn } else { between };
                    between <= SAME_DIRECTION || (!lie_on_each_other && edges[k].1 == following(k).1)
                })
            };
            if let Some(k) = faulty(true).or_else(|| faulty(false)) {
                let mut sides = [edges[k], following(k)].map(|(_, comes, v)| self.side(v, comes));
                sides.sort_unstable();
                return Err(sides);
            }
            for (k, &(_, comes, v)) in edges.iter().enumerate() {
                let (.., other) = following(k);
                // The region lies on the left of an edge that ends here. It fills the sector clockwise from this edge
                // to the next edge, which starts here.
                if comes {
                    next[v] = self.following[other];
                    is_joined |= v != other;
                }
            }
        }
        Ok(is_joined.then_some(next))
    }

    /// Returns the side of a polygon that contains an edge at a vertex: the edge that ends at the vertex if `comes` is
    /// true, otherwise the edge that starts there.
    fn side(&self, v: usize, comes: bool) -> PointOf {
        let (polygon, point) = self.corners[v].source;
        let (first, reversed) = self.polygons[polygon];
        if comes == reversed || self.corners[v].added {
            return (polygon, point);
        }
        // The side that ends at the point.
        let before = self.corners.iter().enumerate().skip(first).take_while(|(_, corner)| corner.source.0 == polygon);
        let count = before.map(|(_, corner)| corner.source.1 + 1).max().unwrap_or(1);
        (polygon, (point + count - 1) % count)
    }

    fn loops(&self, next: &[usize]) -> Vec<Vec<Corner>> {
        let mut seen = vec![false; next.len()];
        let mut loops = Vec::new();
        for &(first, reversed) in &self.polygons {
            let mut begin = first;
            // The vertices of one polygon may belong to several loops.
            // Ends because `following` leads once around the polygon.
            loop {
                let mut around = Vec::new();
                let mut v = begin;
                // Ends because each pass marks a vertex that was not marked before.
                while !seen[v] {
                    seen[v] = true;
                    around.push(self.corners[v]);
                    v = next[v];
                }
                if !around.is_empty() {
                    if reversed {
                        around[1..].reverse();
                    }
                    loops.push(around);
                }
                begin = self.following[begin];
                if begin == first {
                    break;
                }
            }
        }
        loops
    }
}

impl Contacts {
    /// Whether polygon k lies inside polygon l.
    fn lies_in(&self, k: usize, l: usize, polygons: &[Vec<DVec2>]) -> bool {
        let ([low, high], [other_low, other_high]) = (bounds(&polygons[k]), bounds(&polygons[l]));
        if (other_low - low).max(high - other_high).max_element() > 0.0 {
            return false;
        }
        if !self.touching.contains(&(k.min(l), k.max(l))) {
            return contains(&polygons[l], polygons[k][0]);
        }
        // A point that touches no polygon if there is one, otherwise the middle of the first side.
        let points = &polygons[k];
        let free = (0..points.len()).find(|&i| !self.place.contains_key(&(k, i)));
        let inside = free.map_or_else(|| 0.5 * (points[0] + points[1]), |i| points[i]);
        contains(&polygons[l], inside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(points: &[[f64; 2]]) -> Vec<DVec2> {
        points.iter().copied().map(DVec2::from).collect()
    }

    fn meeting_of(polygons: &[Vec<DVec2>]) -> Meeting {
        meeting(polygons, 1e-9, &Execution::default()).unwrap()
    }

    fn places(polygons: &[Vec<DVec2>]) -> Vec<Vec<PointOf>> {
        let Meeting::Touching(loops) = meeting_of(polygons) else { panic!("they do not touch") };
        loops.iter().map(|corners| corners.iter().map(|corner| corner.place).collect()).collect()
    }

    fn square(low: f64, high: f64) -> Vec<DVec2> {
        polygon(&[[low, low], [high, low], [high, high], [low, high]])
    }

    #[test]
    fn a_hole_at_a_corner_a_side_or_another_hole_is_joined_there() {
        let outline = square(0.0, 4.0);
        // The loop runs along the outline, and once round the hole in the opposite direction.
        let at_a_corner = polygon(&[[0.0, 0.0], [2.0, 1.0], [1.0, 2.0]]);
        let expected = vec![vec![(0, 0), (1, 2), (1, 1), (0, 0), (0, 1), (0, 2), (0, 3)]];
        assert_eq!(places(&[outline.clone(), at_a_corner]), expected);
        let on_a_side = polygon(&[[1.0, 0.0], [2.0, 1.0], [1.0, 1.0]]);
        let found = places(&[outline.clone(), on_a_side.clone()]);
        assert_eq!((found.len(), found[0].len()), (1, 8));
        let other = polygon(&[[2.0, 1.0], [3.0, 1.0], [3.0, 2.0]]);
        let found = places(&[outline, on_a_side, other]);
        assert_eq!((found.len(), found[0].len()), (1, 11));
    }

    #[test]
    fn polygons_that_stay_apart_cross_or_share_a_side_are_not_joined() {
        assert_eq!(meeting_of(&[square(0.0, 4.0), square(1.0, 2.0)]), Meeting::Apart);
        // Two squares that touch from outside bound two separate parts.
        assert_eq!(meeting_of(&[square(0.0, 1.0), square(1.0, 2.0)]), Meeting::Apart);
        let crossing = meeting_of(&[square(0.0, 4.0), square(1.0, 5.0)]);
        assert!(matches!(crossing, Meeting::Crossing([(0, 1 | 2), (1, 0 | 3)])), "{crossing:?}");
        let shared = meeting_of(&[square(0.0, 4.0), polygon(&[[0.0, 1.0], [0.0, 2.0], [1.0, 1.0]])]);
        assert_eq!(shared, Meeting::Crossing([(0, 3), (1, 0)]));
    }

    #[test]
    fn two_contacts_of_a_hole_with_the_outline_divide_the_region() {
        let found = places(&[square(0.0, 4.0), polygon(&[[0.0, 2.0], [2.0, 1.0], [4.0, 2.0], [2.0, 3.0]])]);
        assert_eq!(found.iter().map(Vec::len).collect::<Vec<_>>(), [5, 5]);
    }
}
