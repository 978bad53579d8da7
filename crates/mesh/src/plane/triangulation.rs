//! Constrained Delaunay triangulations of a region of the plane. [`triangles_inside`] triangulates given points once; a
//! [`Triangulation`] also takes new points inside the region.
//!
//! The crate `spade` makes the first triangulation. After that, a [`Triangulation`] is a plain array of triangles. A
//! point is inserted by splitting its triangle and flipping edges (Lawson). This takes constant time on average,
//! because farthest-point insertion always knows the triangle where it starts. Edges without a twin are the
//! constraints: the region's outline, holes, and slits (edges that must stay although the region lies on both sides of
//! them). Constraints are never flipped, and lines of sight end at them. All decisions use the adaptive predicates of
//! `robust`, so that the result is exactly Delaunay, not only to a tolerance.

use super::insertion_order::insertion_order;
use crate::DVec2;
use crate::topology::{NONE, next, previous};
use robust::{Coord, incircle, orient2d};
use spade::handles::{DirectedEdgeHandle, FixedVertexHandle};
use spade::{CdtEdge, ConstrainedDelaunayTriangulation, Point2, Triangulation as _};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

fn coord(p: DVec2) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

/// Twice the signed area of the triangle a, b, c: positive if `c` lies to the left of a→b. The sign is exact.
#[inline]
pub fn side(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    orient2d(coord(a), coord(b), coord(c))
}

/// A directed edge of spade's triangulation.
type Edge<'a> = DirectedEdgeHandle<'a, Point2<f64>, (), CdtEdge<()>, ()>;

/// The kind of a constraint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Border {
    /// A piece of the polygon's outline or of a hole, directed with the domain on its left.
    Outline,
    /// An edge with the lattice on exactly one side.
    Lattice,
    /// A lattice edge without a lattice triangle on either side.
    Slit,
}

/// A segment between two points that the triangulation must contain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Constraint {
    pub from: u32,
    pub to: u32,
    pub border: Border,
}

/// Why the constraints do not bound a region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InvalidConstraints {
    /// These two points coincide.
    Coincident(u32, u32),
    /// This constraint crosses another one or runs through a point.
    Crossing { from: u32, to: u32 },
    /// This piece of outline has the domain on the wrong side, because its loop lies outside the outer loop or is
    /// nested in a hole.
    WrongSide { from: u32, to: u32 },
    /// A coordinate is outside the range that spade accepts.
    OutOfRange,
}

/// A triangulation of a region that takes new points. Triangles run counter-clockwise. Half-edge `3 t + k` runs from
/// corner k to corner k + 1 of triangle t, and `twin` has the same meaning as in [`topology`](crate::topology).
#[derive(Clone, Debug, Default)]
pub struct Triangulation {
    pub points: Vec<DVec2>,
    pub corners: Vec<[u32; 3]>,
    pub twin: Vec<[u32; 3]>,
    /// Working memory of `insert`, which is kept to avoid allocating it again.
    stack: Vec<u32>,
}

/// The triangles of the constrained Delaunay triangulation that lie inside an odd number of the outlines. They run
/// counter-clockwise, in the order of the triangulation. Slits are edges that the triangulation must contain. O(n log
/// n).
///
/// # Errors
/// An [`InvalidConstraints`] if the constraints bound no region. Outlines must be disjoint simple loops, in any
/// direction and nested in any way. A loop may visit a place several times if its points there have the same
/// coordinates and it does not cross itself ([`touching`](super::touching)). Each of these points is a vertex of its
/// own.
#[inline]
pub fn triangles_inside(points: &[DVec2], constraints: &[Constraint]) -> Result<Vec<[u32; 3]>, InvalidConstraints> {
    if let Some(shared) = SharedPlaces::of(points, constraints)? {
        let mut triangles = triangles_inside(&shared.points, &shared.constraints)?;
        shared.divide(&mut triangles)?;
        return Ok(triangles);
    }
    let faces = Faces::of(points, constraints)?;
    let is_inside = |label: Option<Label>| label.is_some_and(|label| label.depth % 2 == 1);
    // An outline edge that lies on another outline, or is given twice, does not separate inside from outside.
    let separates = |c: &&Constraint| is_inside(faces.left_of(c)) != is_inside(faces.right_of(c));
    if let Some(c) = constraints.iter().filter(|c| c.border == Border::Outline).find(|c| !separates(c)) {
        return Err(InvalidConstraints::WrongSide { from: c.from, to: c.to });
    }
    let inside = faces.cdt.inner_faces().filter(|face| is_inside(faces.label[face.fix().index()]));
    Ok(inside.map(|face| face.vertices().map(|vertex| faces.point(vertex.fix()))).collect())
}

/// Where a face of spade's triangulation lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Label {
    /// Number of outlines around the face.
    depth: u32,
    /// Whether the face lies in the lattice.
    lattice: bool,
}

/// Spade's triangulation of the whole convex hull, with the label of each face. `points` and `vertices` translate
/// between the numbers of spade's vertices and those of the given points.
struct Faces {
    cdt: ConstrainedDelaunayTriangulation<Point2<f64>>,
    label: Vec<Option<Label>>,
    points: Vec<u32>,
    vertices: Vec<u32>,
}

impl Faces {
    /// Triangulates the points with the constraints, and labels the faces.
    ///
    /// # Errors
    /// A [`InvalidConstraints`]. [`InvalidConstraints::WrongSide`] is not detected here.
    fn of(points: &[DVec2], constraints: &[Constraint]) -> Result<Self, InvalidConstraints> {
        let order = insertion_order(points);
        let one_by_one = order.is_some();
        let order = order.unwrap_or_else(|| (0..points.len() as u32).collect());
        let mut vertices = vec![0; points.len()];
        order.iter().enumerate().for_each(|(vertex, &point)| vertices[point as usize] = vertex as u32);
        let edges = constraints.iter().map(|c| [c.from, c.to].map(|v| vertices[v as usize] as usize)).collect();
        // Spade refuses coordinates of less than 1e-142, so they become 0.
        let site = |&v: &u32| spade::mitigate_underflow(Point2::new(points[v as usize].x, points[v as usize].y));
        let sites = order.iter().map(site).collect();
        let (cdt, crossing) = if one_by_one { inserted(sites, edges) } else { loaded(sites, edges) }
            .ok_or(InvalidConstraints::OutOfRange)?;
        if let Some([from, to]) = crossing {
            return Err(InvalidConstraints::Crossing { from: order[from], to: order[to] });
        }
        if cdt.num_vertices() != points.len() {
            return Err(InvalidConstraints::OutOfRange);
        }
        let mut faces = Self { cdt, label: Vec::new(), points: order, vertices };
        // Spade splits a constraint that runs through a point, so that the triangulation does not contain the whole
        // constraint.
        let is_missing = |c: &&Constraint| faces.directed(c).is_none_or(|edge| !edge.is_constraint_edge());
        if let Some(c) = constraints.iter().find(is_missing) {
            return Err(InvalidConstraints::Crossing { from: c.from, to: c.to });
        }
        faces.label = faces.labels(constraints);
        Ok(faces)
    }

    /// The given point of a vertex of spade's.
    fn point(&self, vertex: FixedVertexHandle) -> u32 {
        self.points[vertex.index()]
    }

    fn left_of(&self, c: &Constraint) -> Option<Label> {
        self.directed(c).and_then(|edge| self.label[edge.face().fix().index()])
    }

    fn right_of(&self, c: &Constraint) -> Option<Label> {
        self.directed(c).and_then(|edge| self.label[edge.rev().face().fix().index()])
    }

    /// The constraint as an edge of the triangulation; `None` if it runs through a point.
    fn directed(&self, c: &Constraint) -> Option<Edge<'_>> {
        let [from, to] = [c.from, c.to].map(|v| FixedVertexHandle::from_index(self.vertices[v as usize] as usize));
        self.cdt.get_edge_from_neighbors(from, to)
    }

    /// Finds the label of each face, starting outside the convex hull.
    fn labels(&self, constraints: &[Constraint]) -> Vec<Option<Label>> {
        let cdt = &self.cdt;
        let mut borders: Vec<_> =
            constraints.iter().map(|c| ((c.from.min(c.to), c.from.max(c.to)), c.border)).collect();
        borders.sort_unstable_by_key(|&(ends, _)| ends);
        let border_of = |edge: &Edge<'_>| {
            let [a, b] = [edge.from(), edge.to()].map(|vertex| self.point(vertex.fix()));
            borders.binary_search_by_key(&(a.min(b), a.max(b)), |&(ends, _)| ends).ok().map(|k| borders[k].1)
        };
        let mut label: Vec<Option<Label>> = vec![None; cdt.num_all_faces()];
        label[cdt.outer_face().fix().index()] = Some(Label { depth: 0, lattice: false });
        // A region is filled completely before the next border is crossed. A face without a label beyond a border
        // therefore belongs to a new region, one level further in.
        let mut within: Vec<_> = cdt.convex_hull().flat_map(|edge| [edge, edge.rev()]).collect();
        let mut crossings = VecDeque::new();
        // Ends because edges are added only when a face gets its label, which happens once.
        loop {
            let (edge, border) = match within.pop() {
                Some(edge) if edge.is_constraint_edge() => match border_of(&edge) {
                    Some(border @ (Border::Outline | Border::Lattice)) => {
                        crossings.push_back((edge, border));
                        continue;
                    }
                    border => (edge, border),
                },
                Some(edge) => (edge, None),
                None => match crossings.pop_front() {
                    Some((edge, border)) => (edge, Some(border)),
                    None => return label,
                },
            };
            let (Some(here), None) = (label[edge.face().fix().index()], label[edge.rev().face().fix().index()]) else {
                continue;
            };
            let there = match border {
                Some(Border::Outline) => Label { depth: here.depth + 1, ..here },
                Some(Border::Lattice) => Label { lattice: !here.lattice, ..here },
                Some(Border::Slit) | None => here,
            };
            let Some(face) = edge.rev().face().as_inner() else { continue };
            label[face.fix().index()] = Some(there);
            within.extend(face.adjacent_edges());
        }
    }
}

/// A triangulation, and the first constraint that crosses another one.
type Constrained = (ConstrainedDelaunayTriangulation<Point2<f64>>, Option<[usize; 2]>);

/// Triangulates all points at once. `None` if a coordinate is out of spade's range.
fn loaded(sites: Vec<Point2<f64>>, edges: Vec<[usize; 2]>) -> Option<Constrained> {
    let mut crossing = None;
    let cdt = ConstrainedDelaunayTriangulation::try_bulk_load_cdt(sites, edges, |edge| {
        crossing.get_or_insert(edge);
    });
    Some((cdt.ok()?, crossing))
}

/// Does the same with one point after the other. Each point is looked for from the one before it.
fn inserted(sites: Vec<Point2<f64>>, edges: Vec<[usize; 2]>) -> Option<Constrained> {
    let mut cdt = ConstrainedDelaunayTriangulation::new();
    for site in sites {
        cdt.insert(site).ok()?;
    }
    let crossing = edges.into_iter().find(|&[from, to]| {
        let [from, to] = [from, to].map(FixedVertexHandle::from_index);
        cdt.get_edge_from_neighbors(from, to).is_none_or(|edge| !edge.is_constraint_edge())
            && cdt.try_add_constraint(from, to).is_empty()
    });
    Some((cdt, crossing))
}

/// The triangulation's input with points of equal coordinates merged, and the data to separate them again in the
/// result.
struct SharedPlaces {
    /// The distinct points, and the constraints between the distinct points.
    points: Vec<DVec2>,
    constraints: Vec<Constraint>,
    /// For each distinct point, the first of the given points with its coordinates.
    first: Vec<u32>,
    /// The points that share their place with others. Each is stored with the distinct point at its place, and with the
    /// distinct points before and after it on its loop.
    copies: Vec<FanVertex>,
}

#[derive(Clone, Copy)]
struct FanVertex {
    place: u32,
    point: u32,
    before: u32,
    after: u32,
}

impl SharedPlaces {
    /// Merges points with equal coordinates. `None` if all points are distinct.
    ///
    /// # Errors
    /// [`InvalidConstraints::Coincident`] for two equal points if one of them is not on an outline.
    fn of(points: &[DVec2], constraints: &[Constraint]) -> Result<Option<Self>, InvalidConstraints> {
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        let position = |v: u32| points[v as usize];
        let key = |v: u32| (position(v).x, position(v).y);
        order.sort_unstable_by(|&a, &b| {
            key(a).partial_cmp(&key(b)).unwrap_or(std::cmp::Ordering::Equal).then(a.cmp(&b))
        });
        if order.windows(2).all(|pair| position(pair[0]) != position(pair[1])) {
            return Ok(None);
        }
        // The distinct points keep the order of their numbers. A point that equals an earlier point is left out.
        let mut leader: Vec<u32> = (0..points.len() as u32).collect();
        for pair in order.windows(2).filter(|pair| position(pair[0]) == position(pair[1])) {
            leader[pair[1] as usize] = leader[pair[0] as usize];
        }
        let first: Vec<u32> = (0..points.len() as u32).filter(|&v| leader[v as usize] == v).collect();
        let mut place = vec![0; points.len()];
        first.iter().enumerate().for_each(|(number, &v)| place[v as usize] = number as u32);
        (0..points.len()).for_each(|v| place[v] = place[leader[v] as usize]);
        let moved = |c: &Constraint| Constraint { from: place[c.from as usize], to: place[c.to as usize], ..*c };
        let [mut before, mut after] = [vec![NONE; points.len()], vec![NONE; points.len()]];
        for c in constraints.iter().filter(|c| c.border == Border::Outline) {
            before[c.to as usize] = place[c.from as usize];
            after[c.from as usize] = place[c.to as usize];
        }
        let mut copies = Vec::new();
        for group in order.chunk_by(|&a, &b| position(a) == position(b)).filter(|group| group.len() > 1) {
            for &point in group {
                let [before, after] = [before[point as usize], after[point as usize]];
                let here = place[point as usize];
                if [before, after].iter().any(|&v| v == NONE || v == here) || before == after {
                    return Err(InvalidConstraints::Coincident(group[0], group[1]));
                }
                copies.push(FanVertex { place: here, point, before, after });
            }
        }
        let constraints = constraints.iter().map(moved).collect();
        Ok(Some(Self { points: first.iter().map(|&v| position(v)).collect(), constraints, first, copies }))
    }

    /// Renumbers the corners of the triangles from the distinct points to the given points. A copy (one of several
    /// points at the same place) becomes a corner of the triangles between its two neighbours on its loop.
    ///
    /// # Errors
    /// [`InvalidConstraints::Coincident`] if a copy has no fan of its own, because its loop crosses another one there.
    fn divide(&self, triangles: &mut [[u32; 3]]) -> Result<(), InvalidConstraints> {
        let places: BTreeSet<u32> = self.copies.iter().map(|copy| copy.place).collect();
        // For each edge that starts at a shared place: the triangle on its left, the index of the triangle's corner at
        // the place, and the next corner around the place.
        let mut left_of = BTreeMap::new();
        for (t, corners) in triangles.iter().enumerate() {
            for k in (0..3).filter(|&k| places.contains(&corners[k])) {
                left_of.insert((corners[k], corners[(k + 1) % 3]), (t, k, corners[(k + 2) % 3]));
            }
        }
        triangles.iter_mut().flatten().for_each(|corner| *corner = self.first[*corner as usize]);
        for copy in &self.copies {
            // Both directions around the copy are tried, because the region may lie on the left of the loop or on its
            // right.
            let ends = [(copy.after, copy.before), (copy.before, copy.after)];
            let fan = ends.into_iter().find_map(|(start, end)| {
                let (mut fan, mut edge) = (Vec::new(), start);
                // Ends because no two edges have the same next one: the walk runs out of edges or comes back to its
                // start.
                while edge != end {
                    // The walk through a closed fan that does not contain `end` leads back to its start.
                    let is_round = !fan.is_empty() && edge == start;
                    let &(t, k, next) = left_of.get(&(copy.place, edge)).filter(|_| !is_round)?;
                    fan.push((t, k, edge));
                    edge = next;
                }
                Some(fan)
            });
            let crossing = || {
                let first = self.first[copy.place as usize];
                let other = self.copies.iter().find(|other| other.place == copy.place && other.point != first);
                InvalidConstraints::Coincident(first, other.map_or(copy.point, |other| other.point))
            };
            // All triangles of the fan get the same copy as their corner.
            for (t, k, edge) in fan.ok_or_else(crossing)? {
                left_of.remove(&(copy.place, edge));
                triangles[t][k] = copy.point;
            }
        }
        Ok(())
    }
}

/// Where a straight path from a triangle towards a point ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sight {
    /// The path reaches the point, which lies in this triangle.
    In(u32),
    /// The path meets a constraint, so that the point is not visible.
    Hidden,
}

impl Triangulation {
    /// The constrained Delaunay triangulation of the points, restricted to the region: inside the outer outline,
    /// outside the holes, and outside the lattice. O(n log n).
    ///
    /// # Errors
    /// An [`InvalidConstraints`] if the constraints bound no region. Outlines must be disjoint simple loops, which may
    /// touch at points as in [`triangles_inside`].
    pub fn build(points: Vec<DVec2>, constraints: &[Constraint]) -> Result<Self, InvalidConstraints> {
        if let Some(mut shared) = SharedPlaces::of(&points, constraints)? {
            let mut whole = Self::build(std::mem::take(&mut shared.points), &shared.constraints)?;
            shared.divide(&mut whole.corners)?;
            whole.points = points;
            return Ok(whole);
        }
        let faces = Faces::of(&points, constraints)?;
        let wrong_side = |c: &&Constraint| c.border == Border::Outline && faces.left_of(c).is_none_or(|l| l.depth != 1);
        if let Some(c) = constraints.iter().find(wrong_side) {
            return Err(InvalidConstraints::WrongSide { from: c.from, to: c.to });
        }
        let cdt = &faces.cdt;
        let inside = |face: usize| faces.label[face] == Some(Label { depth: 1, lattice: false });
        // The triangles are sorted by their corners, because spade's order changes when the input is rotated or scaled.
        let mut numbered: Vec<([u32; 3], usize)> = cdt
            .inner_faces()
            .filter(|face| inside(face.fix().index()))
            .map(|face| {
                let mut corners = face.vertices().map(|v| faces.point(v.fix()));
                let least = (0..3).min_by_key(|&k| corners[k]).unwrap_or(0);
                corners.rotate_left(least);
                (corners, face.fix().index())
            })
            .collect();
        numbered.sort_unstable();
        let mut number = vec![NONE; cdt.num_all_faces()];
        for (t, &(_, face)) in numbered.iter().enumerate() {
            number[face] = t as u32;
        }
        let corners: Vec<[u32; 3]> = numbered.into_iter().map(|(corners, _)| corners).collect();
        let mut twin = vec![[NONE; 3]; corners.len()];
        for face in cdt.inner_faces().filter(|face| inside(face.fix().index())) {
            let t = number[face.fix().index()];
            for edge in face.adjacent_edges() {
                if edge.is_constraint_edge() {
                    continue;
                }
                let k = position(corners[t as usize], faces.point(edge.from().fix()));
                let other = number[edge.rev().face().fix().index()];
                if other != NONE {
                    let j = position(corners[other as usize], faces.point(edge.to().fix()));
                    twin[t as usize][k] = 3 * other + j as u32;
                }
            }
        }
        Ok(Self { points, corners, twin, stack: Vec::new() })
    }

    #[inline]
    pub fn from(&self, half_edge: u32) -> u32 {
        self.corners[half_edge as usize / 3][half_edge as usize % 3]
    }

    #[inline]
    pub fn twin_of(&self, half_edge: u32) -> u32 {
        self.twin[half_edge as usize / 3][half_edge as usize % 3]
    }

    fn position_of(&self, vertex: u32) -> DVec2 {
        self.points[vertex as usize]
    }

    #[inline]
    pub fn triangle(&self, t: u32) -> [DVec2; 3] {
        self.corners[t as usize].map(|v| self.position_of(v))
    }

    /// Walks straight from the centroid of triangle `start` towards `goal`. Returns where the path ends, and the number
    /// of triangles visited.
    pub fn look_towards(&self, start: u32, goal: DVec2) -> (Sight, u64) {
        let [a, b, c] = self.triangle(start);
        if side(a, b, goal) >= 0.0 && side(b, c, goal) >= 0.0 && side(c, a, goal) >= 0.0 {
            return (Sight::In(start), 1);
        }
        let eye = (a + b + c) / 3.0;
        // The edge through which the path leaves the first triangle. Its ends lie to the right and to the left of the
        // path, and the goal lies beyond it.
        let corners = [a, b, c];
        let way_out = (0..3).find(|&k| {
            let (u, v) = (corners[k], corners[(k + 1) % 3]);
            side(u, v, goal) < 0.0 && side(eye, goal, u) <= 0.0 && side(eye, goal, v) >= 0.0
        });
        let Some(k) = way_out else { return (Sight::Hidden, 1) };
        let mut half_edge = 3 * start + k as u32;
        let mut visited = 1;
        // At most one pass per triangle, because a straight path visits no triangle twice. The count is checked too,
        // because rounding may have put the start outside its triangle.
        while visited <= self.corners.len() as u64 {
            let entered = self.twin_of(half_edge);
            if entered == NONE {
                return (Sight::Hidden, visited);
            }
            visited += 1;
            let apex = self.position_of(self.from(previous(entered)));
            // The triangle is entered across v→u, with u on the right of the path. The side of the apex decides whether
            // the path leaves through u→apex or apex→v.
            let out = if side(eye, goal, apex) >= 0.0 { next(entered) } else { previous(entered) };
            let (from, to) = (self.position_of(self.from(out)), self.position_of(self.from(next(out))));
            if side(from, to, goal) >= 0.0 {
                return (Sight::In(entered / 3), visited);
            }
            half_edge = out;
        }
        (Sight::Hidden, visited)
    }

    /// Inserts a point that lies in triangle `t`, or on an edge of `t` that has a twin. Flips an edge opposite the
    /// point if `flips` returns true for its half-edge. If `flips` is [`is_not_delaunay`](Self::is_not_delaunay), the
    /// triangulation stays Delaunay. Appends the triangles around the new point to `star`.
    pub fn insert(&mut self, t: u32, point: DVec2, star: &mut Vec<u32>, flips: impl Fn(&Self, u32) -> bool) {
        let p = self.points.len() as u32;
        self.points.push(point);
        let [a, b, c] = self.corners[t as usize];
        let [ab, bc, ca] = self.twin[t as usize];
        let n = self.corners.len() as u32;
        // The new point is corner 2 of every triangle around it, so that edge 0 is the edge opposite the point.
        self.corners[t as usize] = [a, b, p];
        self.corners.push([b, c, p]);
        self.corners.push([c, a, p]);
        self.twin[t as usize] = [ab, 3 * n + 2, 3 * (n + 1) + 1];
        self.twin.push([bc, 3 * (n + 1) + 2, 3 * t + 1]);
        self.twin.push([ca, 3 * t + 2, 3 * n + 1]);
        self.point_back(bc, 3 * n);
        self.point_back(ca, 3 * (n + 1));
        let mut stack = std::mem::take(&mut self.stack);
        stack.extend([t, n, n + 1]);
        // Ends because each flip adds a triangle to those around the new point, and no triangle leaves them.
        while let Some(t) = stack.pop() {
            if self.twin[t as usize][0] == NONE || !flips(self, 3 * t) {
                star.push(t);
                continue;
            }
            stack.extend(self.flip(3 * t));
        }
        self.stack = stack;
    }

    /// Whether the circumcircle of a half-edge's triangle contains the opposite corner of the twin's triangle.
    #[inline]
    pub fn is_not_delaunay(&self, half_edge: u32) -> bool {
        let [a, b, c, d] = self.around(half_edge).map(|v| coord(self.position_of(v)));
        incircle(a, b, c, d) > 0.0
    }

    /// The ends of a half-edge that has a twin, then the third corner of its triangle, then the third corner of its
    /// twin's triangle.
    #[inline]
    pub fn around(&self, half_edge: u32) -> [u32; 4] {
        let across = self.twin_of(half_edge);
        [half_edge, next(half_edge), previous(half_edge), previous(across)].map(|h| self.from(h))
    }

    /// Replaces the edge between two triangles by the other diagonal of their quadrilateral. Returns the two triangles.
    /// Their corner 2 is the third corner of the half-edge's triangle.
    pub fn flip(&mut self, half_edge: u32) -> [u32; 2] {
        let across = self.twin_of(half_edge);
        let (t, s) = (half_edge / 3, across / 3);
        let [a, b, c, d] = self.around(half_edge);
        let (ad, db) = (self.twin_of(next(across)), self.twin_of(previous(across)));
        let (bc, ca) = (self.twin_of(next(half_edge)), self.twin_of(previous(half_edge)));
        self.corners[t as usize] = [a, d, c];
        self.corners[s as usize] = [d, b, c];
        self.twin[t as usize] = [ad, 3 * s + 2, ca];
        self.twin[s as usize] = [db, bc, 3 * t + 1];
        self.point_back(ad, 3 * t);
        self.point_back(ca, 3 * t + 2);
        self.point_back(db, 3 * s);
        self.point_back(bc, 3 * s + 1);
        [t, s]
    }

    fn point_back(&mut self, half_edge: u32, twin: u32) {
        if half_edge != NONE {
            self.twin[half_edge as usize / 3][half_edge as usize % 3] = twin;
        }
    }

    /// Asserts that the twins and orientations are right and that every edge with a twin is Delaunay. For tests.
    #[cfg(test)]
    pub fn sanity_check(&self) {
        for h in 0..3 * self.corners.len() as u32 {
            let [a, b, c] = self.triangle(h / 3);
            assert!(side(a, b, c) > 0.0, "triangle {} is not counter-clockwise", h / 3);
            let twin = self.twin_of(h);
            if twin == NONE {
                continue;
            }
            assert_eq!(self.twin_of(twin), h);
            assert_eq!((self.from(twin), self.from(next(twin))), (self.from(next(h)), self.from(h)));
            let d = self.position_of(self.from(previous(twin)));
            assert!(incircle(coord(a), coord(b), coord(c), coord(d)) <= 0.0, "edge {h} is not Delaunay");
        }
    }
}

fn position(corners: [u32; 3], vertex: u32) -> usize {
    usize::from(corners[1] == vertex) + 2 * usize::from(corners[2] == vertex)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square_with_a_slit() -> Triangulation {
        let mut points: Vec<DVec2> = Vec::new();
        for k in 0..4 {
            let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]].map(DVec2::from);
            points.extend([corners[k], (corners[k] + corners[(k + 1) % 4]) / 2.0]);
        }
        points.extend([DVec2::new(3.0, 4.0), DVec2::new(5.0, 4.5)]);
        let outline = (0..8).map(|k| Constraint { from: k, to: (k + 1) % 8, border: Border::Outline });
        let constraints: Vec<_> = outline.chain([Constraint { from: 8, to: 9, border: Border::Slit }]).collect();
        Triangulation::build(points, &constraints).unwrap()
    }

    #[test]
    fn insertion_keeps_the_triangulation_delaunay_and_the_slit_in_place() {
        let mut region = square_with_a_slit();
        let slit = |region: &Triangulation| {
            (0..3 * region.corners.len() as u32)
                .filter(|&h| [region.from(h), region.from(next(h))].iter().all(|v| [8, 9].contains(v)))
                .map(|h| region.twin_of(h))
                .collect::<Vec<_>>()
        };
        assert_eq!(slit(&region), [NONE, NONE]);
        let mut state = 1u64;
        for _ in 0..400 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let p = DVec2::new(
                (state >> 40) as f64 / (1u64 << 21) as f64,
                (state >> 20 & 0xff_ffff) as f64 / (1u64 << 21) as f64,
            );
            // Coordinates rounded to eighths put many points on edges and circumcircles.
            let p = (p * 8.0).round() / 8.0;
            let strictly_inside = p.min_element() > 0.0 && p.max_element() < 8.0;
            if !strictly_inside || region.points.contains(&p) {
                continue;
            }
            let holder = (0..region.corners.len() as u32).find(|&t| {
                let [a, b, c] = region.triangle(t);
                let on = |a, b, k: usize| {
                    let s = side(a, b, p);
                    s > 0.0 || (s == 0.0 && region.twin[t as usize][k] != NONE)
                };
                on(a, b, 0) && on(b, c, 1) && on(c, a, 2)
            });
            let Some(t) = holder else { continue };
            let mut star = Vec::new();
            region.insert(t, p, &mut star, Triangulation::is_not_delaunay);
            assert!(star.iter().all(|&t| region.corners[t as usize][2] as usize == region.points.len() - 1));
            region.sanity_check();
        }
        assert!(region.points.len() > 200);
        assert_eq!(slit(&region), [NONE, NONE]);
    }

    #[test]
    fn nothing_is_seen_through_a_slit() {
        let region = square_with_a_slit();
        let middle = |t: u32| region.triangle(t).iter().sum::<DVec2>() / 3.0;
        let below = (0..region.corners.len() as u32)
            .find(|&t| {
                region.corners[t as usize].contains(&8) && region.corners[t as usize].contains(&9) && middle(t).y < 4.0
            })
            .unwrap();
        assert_eq!(region.look_towards(below, DVec2::new(4.1, 7.0)).0, Sight::Hidden);
        assert_eq!(region.look_towards(below, DVec2::new(4.1, 9.0)).0, Sight::Hidden);
        assert!(matches!(region.look_towards(below, DVec2::new(6.0, 1.0)).0, Sight::In(_)));
    }

    #[test]
    fn tangled_outlines_are_named() {
        let outline = |points: &[[f64; 2]]| {
            let n = points.len() as u32;
            let constraints: Vec<_> =
                (0..n).map(|k| Constraint { from: k, to: (k + 1) % n, border: Border::Outline }).collect();
            Triangulation::build(points.iter().map(|&p| DVec2::from(p)).collect(), &constraints).err()
        };
        assert_eq!(outline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]), None);
        assert_eq!(outline(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]), Some(InvalidConstraints::Coincident(0, 2)));
        assert!(matches!(
            outline(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 7.0]]),
            Some(InvalidConstraints::Crossing { .. })
        ));
        assert!(matches!(outline(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0]]), Some(InvalidConstraints::WrongSide { .. })));
    }

    /// A narrow band along a diagonal, whose outline turns at every point.
    fn diagonal_zigzag(points: usize) -> (Vec<DVec2>, Vec<Constraint>) {
        let mut random = crate::random::SplitMix64::new(7);
        let half = points / 2;
        let mut at = |k: usize, side: f64| {
            let along = k as f64 + random.between(-0.2, 0.2);
            DVec2::new(along - side, along + side * (1.0 + (k % 2) as f64))
        };
        let mut outline: Vec<DVec2> = (0..half).map(|k| at(k, -0.1)).collect();
        outline.extend((0..half).rev().map(|k| at(k, 0.1)));
        let n = outline.len() as u32;
        let constraints = (0..n).map(|k| Constraint { from: k, to: (k + 1) % n, border: Border::Outline }).collect();
        (outline, constraints)
    }

    /// Input: a polygon of 40,000 points along a diagonal. Symptom: 12 s in spade's bulk load, without a look at the
    /// signal, because all points lie in two directions from their middle. Rule: such points are inserted one by one,
    /// and the triangles are those of the bulk load.
    #[test]
    fn points_in_few_directions_have_the_triangles_of_the_bulk_load() {
        let (points, constraints) = diagonal_zigzag(8_000);
        let sorted = |mut triangles: Vec<[u32; 3]>| {
            triangles.iter_mut().for_each(|corners| {
                let least = (0..3).min_by_key(|&k| corners[k]).unwrap();
                corners.rotate_left(least);
            });
            triangles.sort_unstable();
            triangles
        };
        assert!(insertion_order(&points).is_some());
        let found = sorted(triangles_inside(&points, &constraints).unwrap());
        let edges = constraints.iter().map(|c| [c.from as usize, c.to as usize]).collect();
        let (cdt, crossing) = loaded(points.iter().map(|p| Point2::new(p.x, p.y)).collect(), edges).unwrap();
        assert_eq!(crossing, None);
        let faces = Faces { label: Vec::new(), points: (0..8_000).collect(), vertices: (0..8_000).collect(), cdt };
        let label = faces.labels(&constraints);
        let inside = faces.cdt.inner_faces().filter(|face| label[face.fix().index()].is_some_and(|l| l.depth == 1));
        assert_eq!(found, sorted(inside.map(|face| face.vertices().map(|v| v.fix().index() as u32)).collect()));
        assert_eq!(found.len(), 7_998);
        Triangulation::build(points, &constraints).unwrap().sanity_check();

        let mut random = crate::random::SplitMix64::new(8);
        let anywhere: Vec<DVec2> = (0..8_000).map(|_| DVec2::new(random.unit(), random.unit())).collect();
        assert!(insertion_order(&anywhere).is_none());
    }

    #[test]
    fn crossing_outlines_in_few_directions_are_named() {
        let (mut points, constraints) = diagonal_zigzag(8_000);
        points.swap(700, 720);
        assert!(matches!(triangles_inside(&points, &constraints), Err(InvalidConstraints::Crossing { .. })));
    }
}
