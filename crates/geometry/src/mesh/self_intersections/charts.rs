//! Triangles that may intersect others, found from parts of the surface that provably do not intersect themselves.
//!
//! A *chart* is a set of triangles that all face one direction and whose boundary, seen along that direction, consists
//! of polygons that neither cross nor touch, one of which runs counter-clockwise. No two triangles of a chart intersect
//! (P. Volino, N. Magnenat-Thalmann, *Efficient self-collision detection on smoothly discretized surface animations
//! using geometrical shape regularity*, Computer Graphics Forum 13, 1994). The proof needs no assumption on the topology:
//! the number of triangles over a point of the plane is the winding number of the boundary, and one polygon that runs
//! counter-clockwise, with all others clockwise, winds round no point more than once. A common point of two triangles
//! would then lie on the boundary of the chart from both sides.
//!
//! A few directions are chosen so that each normal is near one of them. The triangles within a wide cone around each
//! direction form charts, which overlap: neighbours are nearly always together in one of them. A part that lies over
//! itself, as a helicoid of several turns does, is cut across the direction into slabs, twice, half a slab apart.
//!
//! A coarse tree then finds the pairs of leaves that are neither apart nor together in a chart. Only their triangles are
//! suspects. On smooth films there are none.

use super::boxes::{Leaves, Order, OwnBox, Tree, Visits};
use super::soup::{LOOK, NONE, Soup};
use crate::{DVec2, DVec3, Execution, Interruption};
use std::ops::ControlFlow;

/// Cosine of the angle from a direction up to which triangles belong to its charts: 72 degrees. A larger angle makes the
/// charts overlap more, and the boundaries that are seen from the side touch more often.
const CHART: f64 = 0.31;
/// The same angle in degrees.
const CHART_DEG: f64 = 72.0;
/// How much the normals of a leaf's triangles may differ (degrees) so that one of the charts has them all, for a mesh of
/// [`SPREAD_TRIANGLES`], and at least. It falls with the fourth root of the number of triangles, half as fast as the angle
/// between neighbours, because a surface may bend more in one place than elsewhere. A smaller value needs fewer
/// directions, and finds no chart for leaves that bend more.
const SPREAD_DEG: f64 = 32.0;
const LEAST_SPREAD_DEG: f64 = 10.0;
const SPREAD_TRIANGLES: f64 = 8_000.0;
/// Largest number of directions, at most the bits of [`Facing`]. A sphere of 8,000 triangles needs about 14; more are
/// needed only by noise.
const DIRECTIONS: usize = 20;
/// Numbers of slabs into which the parts that lie over themselves are cut, one after the other.
const SLABS: [f64; 3] = [2.0, 6.0, 18.0];
/// Triangles that are cut into slabs, counted each time, as a multiple of the mesh's own.
const SLAB_WORK: usize = 4;
/// Largest number of times that the boundary of a chart may pass through one vertex.
const PASSES: usize = 16;
/// A surface whose boundary edges are more than this share of its triangles, beyond [`FREE_BOUNDARY`], is not searched
/// for charts: checking their boundaries would cost as much as checking the triangles. Strips are such surfaces.
const BOUNDARY_SHARE: usize = 4;
/// Number of boundary edges that are checked in any case.
const FREE_BOUNDARY: usize = 64;
/// Pairs of boxes for each boundary edge, and for each leaf, after which a search gives up. Smooth films take 10 to 60.
const WORK: u64 = 512;
/// Distance, in units of the largest coordinate, below which points and edges of a boundary count as touching. Rounding
/// moves the projected points by less than a tenth of it.
const MARGIN: f64 = 1e-14;
/// Smallest area of a boundary polygon, as a fraction of its squared length, whose sign is certain.
const LEAST_AREA: f64 = 1e-10;

/// The triangles of the list that may intersect another one, or all of them where no charts are found. `leaf_size` is
/// the number of triangles that are together suspects or not.
pub(super) fn suspects(
    soup: &Soup,
    list: Vec<u32>,
    order: Order,
    leaf_size: usize,
    exec: &Execution<'_>,
) -> Result<Vec<u32>, Interruption> {
    let Some(surface) = Surface::new(soup, &list, exec)? else { return Ok(list) };
    let leaves = Leaves { triangles: list.clone(), order, size: leaf_size, margin: 0.0, visits: Visits::Leaves };
    let tree = Tree::new(leaves, |t| soup.corners(soup.triangles[t as usize]), exec)?;
    let mut layers: Vec<Vec<u32>> = Vec::new();
    let directions = directions(soup, &list, exec)?;
    let facing = facing(soup, &list, &directions, exec)?;
    let mut scratch = Scratch::new(soup.triangles.len(), SLAB_WORK * list.len());
    for (k, &direction) in directions.iter().enumerate() {
        let members = list.iter().zip(&facing).filter(|(_, facing)| *facing >> k & 1 == 1).map(|(&t, _)| t).collect();
        exec.look(list.len() as u64)?;
        surface.add_layers(direction, members, &tree, &mut layers, &mut scratch, exec)?;
    }
    let same_chart = |a: usize, b: usize| layers.iter().any(|labels| labels[a] != NONE && labels[a] == labels[b]);
    let mut is_suspect = vec![false; soup.triangles.len()];
    // Few leaves are ever compared, so that a box of their own is made for those alone.
    let mut own_boxes: Vec<Option<OwnBox>> = vec![None; tree.first_leaf()];
    let visit = |a: usize, b: usize| {
        if a != b {
            for leaf in [a, b] {
                own_boxes[leaf - tree.first_leaf()]
                    .get_or_insert_with(|| tree.own_box(leaf, |t| soup.corners(soup.triangles[t as usize])));
            }
            let own = |leaf: usize| own_boxes[leaf - tree.first_leaf()].as_ref();
            if let (Some(one), Some(other)) = (own(a), own(b))
                && tree.are_apart(one, other)
            {
                return ControlFlow::Continue(());
            }
        }
        for leaf in [a, b] {
            tree.leaf(leaf).iter().for_each(|&t| is_suspect[t as usize] = true);
        }
        ControlFlow::Continue(())
    };
    let most_work = WORK * list.len().div_ceil(leaf_size) as u64 + LOOK as u64;
    if !tree.visit_leaves(most_work, same_chart, visit, exec)? {
        return Ok(list);
    }
    Ok(list.into_iter().filter(|&t| is_suspect[t as usize]).collect())
}

/// Directions such that nearly every normal is within a leaf's spread of the charts' edge of one of them.
fn directions(soup: &Soup, list: &[u32], exec: &Execution<'_>) -> Result<Vec<DVec3>, Interruption> {
    let spread = SPREAD_DEG * (SPREAD_TRIANGLES / list.len() as f64).sqrt().sqrt();
    let covered = (CHART_DEG - spread.clamp(LEAST_SPREAD_DEG, SPREAD_DEG)).to_radians().cos();
    let mut directions: Vec<DVec3> = Vec::new();
    let mut last = 0;
    for chunk in list.chunks(LOOK) {
        for &t in chunk {
            let normal = soup.normals[t as usize];
            let is_covered = |direction: &DVec3| faces(normal, *direction, covered);
            if directions.get(last).is_some_and(is_covered) {
                continue;
            }
            if let Some(found) = directions.iter().position(is_covered) {
                last = found;
            } else if directions.len() < DIRECTIONS
                && let Some(direction) = normal.try_normalize()
            {
                last = directions.len();
                directions.push(direction);
            }
        }
        exec.look(chunk.len() as u64)?;
    }
    Ok(directions)
}

/// For a triangle the directions whose charts it may belong to, a bit for each.
type Facing = u32;

/// The directions that each triangle of the list faces.
fn facing(soup: &Soup, list: &[u32], directions: &[DVec3], exec: &Execution<'_>) -> Result<Vec<Facing>, Interruption> {
    let mut facing = Vec::with_capacity(list.len());
    for chunk in list.chunks(LOOK) {
        facing.extend(chunk.iter().map(|&t| {
            let normal = soup.normals[t as usize];
            let bit = |(k, &direction)| Facing::from(faces(normal, direction, CHART)) << k;
            directions.iter().enumerate().map(bit).sum::<Facing>()
        }));
        exec.look(chunk.len() as u64)?;
    }
    Ok(facing)
}

/// Whether the angle between a normal and a direction is below one with this cosine. False for triangles without a
/// certain normal, whose squares vanish.
fn faces(normal: DVec3, direction: DVec3, cosine: f64) -> bool {
    let along = normal.dot(direction);
    along > 0.0 && along * along > cosine * cosine * normal.length_squared()
}

/// The triangles with their neighbours.
struct Surface<'a> {
    soup: &'a Soup,
    /// For each half-edge 3 t + k, from corner k of triangle t to the next one, the half-edge in the opposite direction
    /// along the same edge; [`NONE`] unless the edge has exactly these two.
    twins: Vec<u32>,
}

impl<'a> Surface<'a> {
    /// `None` if the boundary is too long to look for charts.
    fn new(soup: &'a Soup, list: &[u32], exec: &Execution<'_>) -> Result<Option<Self>, Interruption> {
        // The half-edges of each vertex with a lower number, each after the number of the other end.
        let mut start = vec![0u32; soup.points.len() + 1];
        let edges = |t: u32| {
            let [a, b, c] = soup.triangles[t as usize];
            [[a, b], [b, c], [c, a]]
        };
        for chunk in list.chunks(LOOK) {
            chunk.iter().flat_map(|&t| edges(t)).for_each(|[a, b]| start[a.min(b) as usize + 1] += 1);
            exec.look(chunk.len() as u64)?;
        }
        for v in 0..soup.points.len() {
            start[v + 1] += start[v];
        }
        let mut half_edges = vec![0u64; start[soup.points.len()] as usize];
        for chunk in list.chunks(LOOK) {
            for &t in chunk {
                for (k, [a, b]) in (0..).zip(edges(t)) {
                    // The slots of a vertex are filled from the end.
                    let slot = &mut start[a.min(b) as usize + 1];
                    *slot -= 1;
                    half_edges[*slot as usize] = u64::from(a.max(b)) << 32 | u64::from(3 * t + k);
                }
            }
            exec.look(chunk.len() as u64)?;
        }
        // Entry v + 1 is now where the half-edges of vertex v start.
        start.remove(0);
        start.push(half_edges.len() as u32);
        let mut twins = vec![NONE; 3 * soup.triangles.len()];
        let mut bare = 0;
        let mut work = 0;
        for v in 0..soup.points.len() {
            let around = &mut half_edges[start[v] as usize..start[v + 1] as usize];
            around.sort_unstable();
            for edge in around.chunk_by(|a, b| a >> 32 == b >> 32) {
                let other_end = (edge[0] >> 32) as u32;
                let starts_here = |half_edge: u64| {
                    let h = half_edge as u32 as usize;
                    soup.triangles[h / 3][(h % 3 + 1) % 3] == other_end
                };
                match *edge {
                    [one, two] if starts_here(one) != starts_here(two) => {
                        twins[one as u32 as usize] = two as u32;
                        twins[two as u32 as usize] = one as u32;
                    }
                    _ => bare += edge.len(),
                }
            }
            work += 1 + around.len();
            if work >= LOOK {
                exec.look(work as u64)?;
                work = 0;
            }
        }
        let is_short = bare <= list.len() / BOUNDARY_SHARE + FREE_BOUNDARY;
        Ok(is_short.then_some(Self { soup, twins }))
    }

    /// Adds the charts of a direction: for each layer the number of the chart that all triangles of a node belong to.
    /// The members are the triangles that face the direction.
    fn add_layers(
        &self,
        direction: DVec3,
        members: Vec<u32>,
        tree: &Tree,
        layers: &mut Vec<Vec<u32>>,
        scratch: &mut Scratch,
        exec: &Execution<'_>,
    ) -> Result<(), Interruption> {
        let mut left = members;
        left.iter().for_each(|&t| scratch.cells[t as usize] = 0);
        let mut next = self.add_layer(direction, &left, tree, layers, scratch, exec)?;
        left.iter().for_each(|&t| scratch.cells[t as usize] = NONE);
        left = next;
        // Parts that lie over themselves.
        let height = |t: u32| self.soup.corners(self.soup.triangles[t as usize])[0].dot(direction);
        for count in SLABS {
            if left.is_empty() || scratch.slab_work < left.len() {
                break;
            }
            scratch.slab_work -= left.len();
            let (low, high) = left.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &t| {
                let height = height(t);
                (low.min(height), high.max(height))
            });
            let thickness = ((high - low) / count).max(f64::MIN_POSITIVE);
            next = Vec::new();
            for shift in [0.0, 0.5] {
                left.iter().for_each(|&t| scratch.cells[t as usize] = ((height(t) - low) / thickness + shift) as u32);
                next.extend(self.add_layer(direction, &left, tree, layers, scratch, exec)?);
            }
            left.iter().for_each(|&t| scratch.cells[t as usize] = NONE);
            next.sort_unstable();
            next.dedup();
            left = next;
        }
        Ok(())
    }

    /// Adds the layer of the charts of the present cells, if there are any. Returns the members that are in none.
    fn add_layer(
        &self,
        direction: DVec3,
        members: &[u32],
        tree: &Tree,
        layers: &mut Vec<Vec<u32>>,
        scratch: &mut Scratch,
        exec: &Execution<'_>,
    ) -> Result<Vec<u32>, Interruption> {
        let holds = self.charts(direction, members, scratch, exec)?;
        let chart = |t: u32| {
            let part = scratch.parts[t as usize];
            if part != NONE && holds[part as usize] { part } else { NONE }
        };
        if holds.contains(&true) {
            layers.push(tree.labels(chart));
        }
        let outside = members.iter().copied().filter(|&t| chart(t) == NONE).collect();
        members.iter().for_each(|&t| scratch.parts[t as usize] = NONE);
        Ok(outside)
    }

    /// Whether the members are a chart as a whole. `None` if they may have several parts, or several cells. A part that
    /// faces the direction has an area, and so a polygon that runs counter-clockwise: if there is one such polygon, the
    /// members are one part.
    fn whole_chart(
        &self,
        direction: DVec3,
        members: &[u32],
        cells: &[u32],
        parts: &mut [u32],
        exec: &Execution<'_>,
    ) -> Result<Option<bool>, Interruption> {
        let mut boundary: Vec<u32> = Vec::new();
        for chunk in members.chunks(LOOK) {
            for &t in chunk {
                if cells[t as usize] != 0 {
                    return Ok(None);
                }
                for h in 3 * t..3 * t + 3 {
                    let twin = self.twins[h as usize];
                    if twin == NONE || cells[twin as usize / 3] != 0 {
                        boundary.push(h);
                    }
                }
            }
            exec.look(chunk.len() as u64)?;
        }
        if boundary.len() > members.len() / BOUNDARY_SHARE + FREE_BOUNDARY {
            return Ok(None);
        }
        members.iter().for_each(|&t| parts[t as usize] = 0);
        boundary.sort_unstable();
        let boundary = Boundary::new(self, direction, cells, parts, &boundary);
        if boundary.has_one_outer_polygon(1) == [true] {
            return Ok(Some(boundary.encloses_once(1, exec)?[0]));
        }
        members.iter().for_each(|&t| parts[t as usize] = NONE);
        Ok(None)
    }

    /// Finds the connected parts of the cells. Returns for each part whether it is a chart. The members face the
    /// direction, and no other triangle has a cell.
    fn charts(
        &self,
        direction: DVec3,
        members: &[u32],
        scratch: &mut Scratch,
        exec: &Execution<'_>,
    ) -> Result<Vec<bool>, Interruption> {
        let Scratch { cells, parts, stack, .. } = scratch;
        if let Some(holds) = self.whole_chart(direction, members, cells, parts, exec)? {
            return Ok(vec![holds]);
        }
        let mut boundary: Vec<u32> = Vec::new();
        let (mut count, mut work) = (0, 0);
        for &seed in members {
            if parts[seed as usize] != NONE {
                continue;
            }
            parts[seed as usize] = count;
            stack.push(seed);
            while let Some(t) = stack.pop() {
                for h in 3 * t..3 * t + 3 {
                    let next = self.twins[h as usize];
                    if next == NONE || cells[next as usize / 3] != cells[t as usize] {
                        boundary.push(h);
                    } else if parts[next as usize / 3] == NONE {
                        parts[next as usize / 3] = count;
                        stack.push(next / 3);
                    }
                }
                work += 1;
                if work == LOOK {
                    exec.look(work as u64)?;
                    work = 0;
                }
            }
            count += 1;
        }
        if boundary.len() > members.len() / BOUNDARY_SHARE + FREE_BOUNDARY {
            return Ok(vec![false; count as usize]);
        }
        boundary.sort_unstable();
        Boundary::new(self, direction, cells, parts, &boundary).encloses_once(count as usize, exec)
    }
}

/// Arrays that are used for one direction after another.
struct Scratch {
    /// For each triangle of the present members its cell, else [`NONE`].
    cells: Vec<u32>,
    /// For each triangle the number of its connected part, or [`NONE`].
    parts: Vec<u32>,
    stack: Vec<u32>,
    /// Triangles that may still be cut into slabs.
    slab_work: usize,
}

impl Scratch {
    fn new(triangles: usize, slab_work: usize) -> Self {
        Self { cells: vec![NONE; triangles], parts: vec![NONE; triangles], stack: Vec::new(), slab_work }
    }
}

/// The boundary edges of parts of a surface, seen along a direction.
struct Boundary {
    /// For each edge the part that it bounds, its ends' numbers, and where they are seen.
    parts: Vec<u32>,
    ends: Vec<[u32; 2]>,
    points: Vec<[DVec2; 2]>,
    /// For each edge the one that follows it around the same part.
    next: Vec<u32>,
}

impl Boundary {
    /// `half_edges` are those without a twin in their part, in order.
    fn new(surface: &Surface, direction: DVec3, cells: &[u32], parts: &[u32], half_edges: &[u32]) -> Self {
        let soup = surface.soup;
        let across = direction.any_orthonormal_vector();
        let up = direction.cross(across);
        // Relative to a point of the boundary, so that the rounding is that of the extent.
        let corner = |h: u32| soup.triangles[h as usize / 3][h as usize % 3];
        let origin = half_edges.first().map_or(DVec3::ZERO, |&h| soup.points[corner(h) as usize]);
        let after = |h: u32| if h % 3 == 2 { h - 2 } else { h + 1 };
        let seen = |vertex: u32| {
            let point = soup.points[vertex as usize] - origin;
            DVec2::new(point.dot(across), point.dot(up))
        };
        // Around the end of the edge, from triangle to triangle, to the next edge without a twin in the part.
        let following = |h: u32| {
            let mut next = after(h);
            loop {
                let twin = surface.twins[next as usize];
                if twin == NONE || cells[twin as usize / 3] != cells[h as usize / 3] {
                    return half_edges.binary_search(&next).expect("an edge without a twin in its part") as u32;
                }
                next = after(twin);
            }
        };
        let ends: Vec<[u32; 2]> = half_edges.iter().map(|&h| [corner(h), corner(after(h))]).collect();
        Self {
            parts: half_edges.iter().map(|&h| parts[h as usize / 3]).collect(),
            points: ends.iter().map(|ends| ends.map(seen)).collect(),
            next: half_edges.iter().map(|&h| following(h)).collect(),
            ends,
        }
    }

    /// For each part whether its boundary is certain to consist of polygons that do not cross or touch, one of which
    /// runs counter-clockwise.
    fn encloses_once(&self, parts: usize, exec: &Execution<'_>) -> Result<Vec<bool>, Interruption> {
        let mut holds = self.has_one_outer_polygon(parts);
        self.reject_crossings_at_vertices(&mut holds);
        let edges = (0..self.ends.len() as u32).filter(|&e| holds[self.parts[e as usize] as usize]).collect();
        let leaves = Leaves { triangles: edges, order: Order::Spatial, size: 4, margin: MARGIN, visits: Visits::Pairs };
        let flat = |e: u32| {
            let [from, to] = self.points[e as usize].map(|point| point.extend(0.0));
            [from, to, to]
        };
        let most_work = WORK * self.ends.len() as u64 + LOOK as u64;
        let tree = Tree::new(leaves, flat, exec)?;
        let labels = tree.labels(|e| self.parts[e as usize]);
        let skip = |a: usize, b: usize| labels[a] != NONE && labels[b] != NONE && labels[a] != labels[b];
        let visit = |a: u32, b: u32| {
            let [a, b] = [a as usize, b as usize];
            let part = self.parts[a];
            if part == self.parts[b] && holds[part as usize] && !self.are_apart(a, b) {
                holds[part as usize] = false;
            }
            ControlFlow::Continue(())
        };
        if !tree.visit_pairs(most_work, skip, visit, exec)? {
            holds.fill(false);
        }
        Ok(holds)
    }

    fn has_one_outer_polygon(&self, parts: usize) -> Vec<bool> {
        let mut outer = vec![0; parts];
        let mut is_certain = vec![true; parts];
        let mut seen = vec![false; self.ends.len()];
        for first in 0..self.ends.len() {
            let origin = self.points[first][0];
            let (mut area, mut length) = (0.0, 0.0);
            let mut edge = first;
            while !seen[edge] {
                seen[edge] = true;
                let [from, to] = self.points[edge].map(|point| point - origin);
                area += 0.5 * from.perp_dot(to);
                length += from.distance(to);
                edge = self.next[edge] as usize;
            }
            if length > 0.0 {
                let part = self.parts[first] as usize;
                is_certain[part] &= area.abs() > LEAST_AREA * length * length + MARGIN * length;
                outer[part] += usize::from(area > 0.0);
            }
        }
        is_certain.iter().zip(outer).map(|(&is_certain, outer)| is_certain && outer == 1).collect()
    }

    /// Where the boundary passes through a vertex several times, the triangles that each pass goes round must lie in
    /// sectors of their own. Then the passes can be moved apart, so that they do not cross there.
    fn reject_crossings_at_vertices(&self, holds: &mut [bool]) {
        let vertex = |edge: u32| (self.parts[edge as usize], self.ends[edge as usize][1]);
        let mut arrivals: Vec<u32> = (0..self.ends.len() as u32).collect();
        arrivals.sort_unstable_by_key(|&edge| vertex(edge));
        for passes in arrivals.chunk_by(|&a, &b| vertex(a) == vertex(b)).filter(|passes| passes.len() > 1) {
            // From the vertex to the pass's next point and to the one before.
            let rays = |edge: u32| {
                let [[before, here], [_, after]] =
                    [edge, self.next[edge as usize]].map(|edge| self.points[edge as usize]);
                [after - here, before - here]
            };
            // Whether a ray is certain to lie outside the sector that runs counter-clockwise from one to the other.
            let is_outside = |[from, to]: [DVec2; 2], ray: DVec2| match turn(from, to) {
                1.0 => turn(from, ray) < 0.0 || turn(ray, to) < 0.0,
                -1.0 => turn(to, ray) > 0.0 && turn(ray, from) > 0.0,
                _ => false,
            };
            let is_apart = |one: u32, other: u32| rays(other).iter().all(|&ray| is_outside(rays(one), ray));
            let all_apart = || passes.iter().all(|&a| passes.iter().all(|&b| a == b || is_apart(a, b)));
            if passes.len() > PASSES || !all_apart() {
                holds[self.parts[passes[0] as usize] as usize] = false;
            }
        }
    }

    /// Whether two edges certainly have no more in common than an end.
    fn are_apart(&self, a: usize, b: usize) -> bool {
        let ([p, q], [r, s]) = (self.points[a], self.points[b]);
        let shared = |i: usize, j: usize| self.ends[a][i] == self.ends[b][j];
        let far = |one: [DVec2; 2], axis: DVec2, other: [DVec2; 2]| {
            let [one, other] = [one, other].map(|points| points.map(|point| point.dot(axis)));
            one[0].max(one[1]) + MARGIN < other[0].min(other[1]) || other[0].max(other[1]) + MARGIN < one[0].min(one[1])
        };
        let meet_at = |end: DVec2, one: DVec2, other: DVec2| {
            let [u, v] = [one - end, other - end];
            turn(u, v) != 0.0 || u.dot(v) < -MARGIN * (u.abs().element_sum() + v.abs().element_sum())
        };
        match [shared(0, 0), shared(0, 1), shared(1, 0), shared(1, 1)] {
            [false, false, false, false] => {
                let beside = |[p, q]: [DVec2; 2], [r, s]: [DVec2; 2]| turn(q - p, r - p) * turn(q - p, s - p) > 0.0;
                far([p, q], DVec2::X, [r, s])
                    || far([p, q], DVec2::Y, [r, s])
                    || beside([p, q], [r, s])
                    || beside([r, s], [p, q])
            }
            [true, false, false, false] => meet_at(p, q, s),
            [false, true, false, false] => meet_at(p, q, r),
            [false, false, true, false] => meet_at(q, p, s),
            [false, false, false, true] => meet_at(q, p, r),
            _ => false,
        }
    }
}

/// The sign of the turn from the first vector to the second one; zero if it is not certain.
fn turn(u: DVec2, v: DVec2) -> f64 {
    let turn = u.perp_dot(v);
    let is_certain = turn.abs() > MARGIN * (u.abs().element_sum() + v.abs().element_sum());
    if is_certain { turn.signum() } else { 0.0 }
}
