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
//! Charts are made of the leaves of a coarse tree, each a piece of the surface with some dozens of triangles, because most
//! of the work is then done once for a leaf. A few directions are chosen so that the normals of each leaf are near one of
//! them. The leaves within a wide cone around each direction form charts, which overlap: neighbours are nearly always
//! together in one of them. A part that lies over itself, as a helicoid of several turns does, is cut across the direction
//! into slabs, twice, half a slab apart.
//!
//! The tree then finds the pairs of leaves that are neither apart nor together in a chart. Only their triangles are
//! suspects. On smooth films there are none.

use super::boxes::{Leaves, Order, Tree, Visits};
use super::soup::{LOOK, NONE, Soup};
use crate::{DVec2, DVec3, Execution, Interruption};
use std::borrow::Cow;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Angle in degrees from a direction up to which triangles belong to its charts. A larger angle makes the charts overlap
/// more, and the boundaries that are seen from the side touch more often.
const CHART_DEG: f64 = 72.0;
/// How much closer to one of the directions than [`CHART_DEG`] the mean normal of a leaf is, as a multiple of the largest
/// angle between that normal and its triangles', and its bounds in degrees. That many leaves around are then in the same
/// chart. A smaller value needs fewer directions, and finds no chart for leaves that bend more.
const SPREAD: f64 = 3.0;
const SPREAD_DEG: (f64, f64) = (10.0, 32.0);
/// Largest number of directions, at most the bits of [`Facing`]. A sphere of 8,000 triangles needs about 14; more are
/// needed only by noise.
const DIRECTIONS: usize = 20;
/// Numbers of slabs into which the parts that lie over themselves are cut, one after the other.
const SLABS: [f64; 3] = [2.0, 6.0, 18.0];
/// Leaves that are cut into slabs, counted each time, as a multiple of the mesh's own.
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
/// the number of triangles that are together suspects or not. `twins`: those of the mesh's half-edges as in [`Surface`],
/// where they are known.
pub(super) fn suspects(
    soup: &Soup,
    list: Vec<u32>,
    twins: Option<&[u32]>,
    order: Order,
    leaf_size: usize,
    exec: &Execution<'_>,
) -> Result<Vec<u32>, Interruption> {
    let twins = match twins {
        Some(twins) => Cow::Borrowed(twins),
        None => Cow::Owned(twins_of(soup, &list, exec)?),
    };
    if is_boundary_long(&twins, &list) {
        return Ok(list);
    }
    let leaves = Leaves { triangles: list.clone(), order, size: leaf_size, margin: 0.0, visits: Visits::Leaves };
    let tree = Tree::new(leaves, |t| soup.corners(soup.triangles[t as usize]), exec)?;
    let surface = Surface::new(soup, &tree, twins, exec)?;
    let mut layers: Vec<Vec<u32>> = Vec::new();
    let cones = surface.cones(exec)?;
    let directions = directions(&cones);
    let facing = facing(&cones, &directions);
    exec.look((cones.len() * directions.len()) as u64)?;
    let mut scratch = Scratch::new(cones.len());
    for (k, &direction) in directions.iter().enumerate() {
        let members = (0..cones.len() as u32).filter(|&leaf| facing[leaf as usize] >> k & 1 == 1).collect();
        surface.add_layers(direction, members, &mut layers, &mut scratch, exec)?;
    }
    let same_chart = |a: usize, b: usize| layers.iter().any(|labels| labels[a] != NONE && labels[a] == labels[b]);
    let mut is_suspect = vec![false; soup.triangles.len()];
    let visit = |a: usize, b: usize| {
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

/// The normals of a leaf's triangles: a unit vector, and the largest angle between it and one of them, in radians.
#[derive(Clone, Copy)]
struct Cone {
    axis: DVec3,
    angle: f64,
}

impl Cone {
    /// The angle is a full turn if a triangle has no certain normal: its square vanishes.
    fn of(normals: impl Iterator<Item = DVec3> + Clone) -> Self {
        let axis = normals.clone().sum::<DVec3>().normalize_or_zero();
        let cosine = |normal: DVec3| {
            let squared = normal.length_squared();
            if squared > 0.0 { normal.dot(axis) / squared.sqrt() } else { f64::NEG_INFINITY }
        };
        let least = normals.map(cosine).fold(1.0, f64::min);
        Self { axis, angle: if least > 0.0 { least.acos() } else { TAU } }
    }

    /// How close to a direction the axis must be, so that the leaf and those around it face the direction.
    fn reach(&self) -> f64 {
        let spread = (SPREAD * self.angle).clamp(SPREAD_DEG.0.to_radians(), SPREAD_DEG.1.to_radians());
        CHART_DEG.to_radians() - spread
    }

    /// Whether all its normals are within the charts' angle of a direction.
    fn faces(&self, direction: DVec3) -> bool {
        let angle = self.axis.dot(direction).clamp(-1.0, 1.0).acos();
        angle + self.angle <= CHART_DEG.to_radians()
    }
}

/// Directions such that nearly every leaf, and its neighbours, face one of them.
fn directions(cones: &[Cone]) -> Vec<DVec3> {
    let mut directions: Vec<DVec3> = Vec::new();
    for cone in cones {
        // No direction serves a leaf that bends so much.
        if cone.angle > SPREAD_DEG.1.to_radians() {
            continue;
        }
        let least = cone.reach().cos();
        if directions.len() < DIRECTIONS && !directions.iter().any(|direction| cone.axis.dot(*direction) >= least) {
            directions.push(cone.axis);
        }
    }
    directions
}

/// For a leaf the directions whose charts it may belong to, a bit for each.
type Facing = u32;

/// The directions that each leaf faces.
fn facing(cones: &[Cone], directions: &[DVec3]) -> Vec<Facing> {
    let bit = |cone: &Cone, k: usize| Facing::from(cone.faces(directions[k])) << k;
    cones.iter().map(|cone| (0..directions.len()).map(|k| bit(cone, k)).sum()).collect()
}

/// For each half-edge 3 t + k, from corner k of triangle t to the next one, the half-edge in the opposite direction along
/// the same edge; [`NONE`] unless the edge has exactly these two.
fn twins_of(soup: &Soup, list: &[u32], exec: &Execution<'_>) -> Result<Vec<u32>, Interruption> {
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
                _ => {}
            }
        }
        work += 1 + around.len();
        if work >= LOOK {
            exec.look(work as u64)?;
            work = 0;
        }
    }
    Ok(twins)
}

/// Whether so many half-edges have no twin that charts would gain nothing.
fn is_boundary_long(twins: &[u32], list: &[u32]) -> bool {
    let bare = |&t: &u32| (0..3).filter(|k| twins[(3 * t + k) as usize] == NONE).count();
    list.iter().map(bare).sum::<usize>() > list.len() / BOUNDARY_SHARE + FREE_BOUNDARY
}

/// The triangles with their neighbours, and the leaves with theirs.
struct Surface<'a> {
    soup: &'a Soup,
    tree: &'a Tree,
    /// See [`twins_of`].
    twins: Cow<'a, [u32]>,
    /// For each triangle the number of its leaf, or [`NONE`] if it is in none.
    leaf_of: Vec<u32>,
    /// The rims of the leaves, one after the other: the half-edges without a twin in the same leaf, each with the leaf
    /// of its twin, or [`NONE`].
    rims: Vec<(u32, u32)>,
    /// Where the rim of each leaf starts.
    start: Vec<u32>,
}

impl<'a> Surface<'a> {
    fn new(soup: &'a Soup, tree: &'a Tree, twins: Cow<'a, [u32]>, exec: &Execution<'_>) -> Result<Self, Interruption> {
        let mut leaf_of = vec![NONE; soup.triangles.len()];
        for leaf in 0..tree.leaf_count() {
            tree.leaf_at(leaf).iter().for_each(|&t| leaf_of[t as usize] = leaf as u32);
        }
        exec.look(soup.triangles.len() as u64)?;
        let (mut rims, mut start) = (Vec::new(), vec![0]);
        let mut work = 0;
        for leaf in 0..tree.leaf_count() {
            for h in tree.leaf_at(leaf).iter().flat_map(|t| 3 * t..3 * t + 3) {
                let twin = twins[h as usize];
                let neighbour = if twin == NONE { NONE } else { leaf_of[twin as usize / 3] };
                if neighbour != leaf as u32 {
                    rims.push((h, neighbour));
                }
            }
            start.push(rims.len() as u32);
            work += tree.leaf_at(leaf).len();
            if work >= LOOK {
                exec.look(work as u64)?;
                work = 0;
            }
        }
        Ok(Self { soup, tree, twins, leaf_of, rims, start })
    }

    fn rim(&self, leaf: u32) -> &[(u32, u32)] {
        &self.rims[self.start[leaf as usize] as usize..self.start[leaf as usize + 1] as usize]
    }

    fn cones(&self, exec: &Execution<'_>) -> Result<Vec<Cone>, Interruption> {
        let mut cones = Vec::with_capacity(self.tree.leaf_count());
        let mut work = 0;
        for leaf in 0..self.tree.leaf_count() {
            let triangles = self.tree.leaf_at(leaf);
            cones.push(Cone::of(triangles.iter().map(|&t| self.soup.normals[t as usize])));
            work += triangles.len();
            if work >= LOOK {
                exec.look(work as u64)?;
                work = 0;
            }
        }
        Ok(cones)
    }

    /// What the leaf of a triangle has in a list of one entry for each leaf.
    fn cell(&self, triangle: u32, of_leaves: &[u32]) -> u32 {
        match self.leaf_of[triangle as usize] {
            NONE => NONE,
            leaf => of_leaves[leaf as usize],
        }
    }

    /// Adds the charts of a direction: for each layer the number of the chart that all triangles of a node belong to.
    /// The members are the leaves that face the direction.
    fn add_layers(
        &self,
        direction: DVec3,
        members: Vec<u32>,
        layers: &mut Vec<Vec<u32>>,
        scratch: &mut Scratch,
        exec: &Execution<'_>,
    ) -> Result<(), Interruption> {
        let mut left = members;
        left.iter().for_each(|&leaf| scratch.cells[leaf as usize] = 0);
        let mut next = self.add_layer(direction, &left, layers, scratch, exec)?;
        left.iter().for_each(|&leaf| scratch.cells[leaf as usize] = NONE);
        left = next;
        // Parts that lie over themselves.
        let height = |leaf: u32| {
            let first = self.tree.leaf_at(leaf as usize)[0];
            self.soup.corners(self.soup.triangles[first as usize])[0].dot(direction)
        };
        for count in SLABS {
            if left.is_empty() || scratch.slab_work < left.len() {
                break;
            }
            scratch.slab_work -= left.len();
            let (low, high) = left.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &leaf| {
                let height = height(leaf);
                (low.min(height), high.max(height))
            });
            let thickness = ((high - low) / count).max(f64::MIN_POSITIVE);
            next = Vec::new();
            for shift in [0.0, 0.5] {
                for &leaf in &left {
                    scratch.cells[leaf as usize] = ((height(leaf) - low) / thickness + shift) as u32;
                }
                next.extend(self.add_layer(direction, &left, layers, scratch, exec)?);
            }
            left.iter().for_each(|&leaf| scratch.cells[leaf as usize] = NONE);
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
        layers: &mut Vec<Vec<u32>>,
        scratch: &mut Scratch,
        exec: &Execution<'_>,
    ) -> Result<Vec<u32>, Interruption> {
        let holds = self.charts(direction, members, scratch, exec)?;
        let chart = |leaf: u32| {
            let part = scratch.parts[leaf as usize];
            if part != NONE && holds[part as usize] { part } else { NONE }
        };
        if holds.contains(&true) {
            layers.push(self.tree.labels_of_leaves(|leaf| chart(leaf as u32)));
        }
        let outside = members.iter().copied().filter(|&leaf| chart(leaf) == NONE).collect();
        members.iter().for_each(|&leaf| scratch.parts[leaf as usize] = NONE);
        exec.look(members.len() as u64)?;
        Ok(outside)
    }

    /// Finds the connected parts of the cells. Returns for each part whether it is a chart. The members face the
    /// direction, and no other leaf has a cell.
    fn charts(
        &self,
        direction: DVec3,
        members: &[u32],
        scratch: &mut Scratch,
        exec: &Execution<'_>,
    ) -> Result<Vec<bool>, Interruption> {
        let Scratch { cells, parts, stack, .. } = scratch;
        let mut boundary: Vec<u32> = Vec::new();
        let (mut count, mut triangles, mut work) = (0, 0, 0);
        for &seed in members {
            if parts[seed as usize] != NONE {
                continue;
            }
            parts[seed as usize] = count;
            stack.push(seed);
            while let Some(leaf) = stack.pop() {
                let rim = self.rim(leaf);
                for &(h, next) in rim {
                    if next == NONE || cells[next as usize] != cells[leaf as usize] {
                        boundary.push(h);
                    } else if parts[next as usize] == NONE {
                        parts[next as usize] = count;
                        stack.push(next);
                    }
                }
                triangles += self.tree.leaf_at(leaf as usize).len();
                work += rim.len();
                if work >= LOOK {
                    exec.look(work as u64)?;
                    work = 0;
                }
            }
            count += 1;
        }
        if boundary.len() > triangles / BOUNDARY_SHARE + FREE_BOUNDARY {
            return Ok(vec![false; count as usize]);
        }
        boundary.sort_unstable();
        Boundary::new(self, direction, cells, parts, &boundary).encloses_once(count as usize, exec)
    }
}

/// Arrays that are used for one direction after another.
struct Scratch {
    /// For each leaf of the present members its cell, else [`NONE`].
    cells: Vec<u32>,
    /// For each leaf the number of its connected part, or [`NONE`].
    parts: Vec<u32>,
    stack: Vec<u32>,
    /// Leaves that may still be cut into slabs.
    slab_work: usize,
}

impl Scratch {
    fn new(leaves: usize) -> Self {
        let none = || vec![NONE; leaves];
        Self { cells: none(), parts: none(), stack: Vec::new(), slab_work: SLAB_WORK * leaves }
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
                if twin == NONE || surface.cell(twin / 3, cells) != surface.cell(h / 3, cells) {
                    return half_edges.binary_search(&next).expect("an edge without a twin in its part") as u32;
                }
                next = after(twin);
            }
        };
        let ends: Vec<[u32; 2]> = half_edges.iter().map(|&h| [corner(h), corner(after(h))]).collect();
        Self {
            parts: half_edges.iter().map(|&h| surface.cell(h / 3, parts)).collect(),
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
