//! Finds the triangles that may intersect others, by excluding parts of the surface that provably do not intersect
//! themselves.
//!
//! A *chart* is a set of triangles that all face one direction and whose boundary, seen along that direction, consists
//! of polygons that neither cross nor touch, one of which runs counter-clockwise. No two triangles of a chart intersect
//! (P. Volino, N. Magnenat-Thalmann, *Efficient self-collision detection on smoothly discretized surface animations
//! using geometrical shape regularity*, Computer Graphics Forum 13, 1994). The proof needs no assumption on the
//! topology: the number of triangles over a point of the plane is the winding number of the boundary, and one polygon
//! that runs counter-clockwise, with all others clockwise, winds round no point more than once. Two triangles could
//! therefore meet only over a point where the boundary touches itself.
//!
//! Charts are made of patches. A patch faces a direction if its whole cone of normals does. Here, vertices with equal
//! coordinates count as different vertices. Edges along which such vertices meet are boundaries that touch. No chart
//! contains them, and the exact search decides.
//!
//! A few directions are chosen so that the axis of each patch is near one of them. The patches within a wide cone
//! around each direction form charts. The charts of different directions overlap, so that neighbouring patches are
//! nearly always together in one of them. A part that lies over itself, such as a helicoid of several turns, is cut
//! across the direction into slabs. It is cut twice, the second time half a slab further, so that neighbours at a cut
//! are together in one of the two.
//!
//! A tree of boxes then finds the pairs of patches that may meet and are not together in a chart. Only the triangles of
//! these patches are suspects. Smooth films have none.

use super::boxes::{Leaves, Order, OwnBox, Tree, Visits};
use super::patches::{Patch, Patches};
use super::soup::{LOOK, NONE};
use crate::{DVec2, DVec3, Execution, Interruption};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

/// Largest angle between a direction and the normals of its charts, in radians: 72 degrees. With a larger angle the
/// charts would overlap more, but their boundaries, then seen from the side, would touch more often.
const CHART: f64 = 0.4 * PI;
/// Margin between a patch's normals and the edge of the cone of a direction that covers the patch, as a multiple of the
/// patch's [`spread`](Patch::spread). The patches beside it are then in the same chart, unless the surface bends more
/// there than in the patch itself.
const MARGIN_OF_NEIGHBOURS: f64 = 2.0;
/// Lower and upper bound of the margin of [`MARGIN_OF_NEIGHBOURS`], in radians: 5 and 32 degrees.
const NEIGHBOURS: [f64; 2] = [PI / 36.0, PI * 32.0 / 180.0];
/// Largest number of directions. A sphere of 8,000 triangles needs about 14. Only noisy surfaces need more.
const DIRECTIONS: usize = 20;
/// Numbers of slabs into which parts that lie over themselves are cut. If some patches are still in no chart, the next
/// number is tried.
const SLABS: [f64; 3] = [2.0, 6.0, 18.0];
/// Bound on the work of cutting into slabs: how many times a patch may be cut on average, over all patches of the mesh.
const SLAB_WORK: usize = 4;
/// Largest number of times that the boundary of a chart may pass through one vertex.
const PASSES: usize = 16;
/// A surface with more boundary edges than its number of triangles divided by this, plus [`FREE_BOUNDARY`], is not
/// searched for charts, because checking its boundary would cost as much as checking the triangles. Strips are such
/// surfaces.
const BOUNDARY_SHARE: usize = 4;
/// Number of boundary edges that may be checked whatever the number of triangles.
const FREE_BOUNDARY: usize = 64;
/// Number of pairs of boxes per boundary edge, or per patch, after which the search of a tree gives up. Smooth films
/// take 10 to 60.
const WORK: u64 = 512;
/// Distance, in units of the largest coordinate, below which points and edges of a boundary count as touching. Rounding
/// moves the projected points by less than a tenth of it.
const MARGIN: f64 = 1e-14;
/// Smallest area of a boundary polygon whose sign is certain, as a fraction of the square of its perimeter.
const LEAST_AREA: f64 = 1e-10;

/// The triangles that may intersect another one, or all triangles if no charts are found. Patches have at most `size`
/// triangles, and the triangles of a patch are suspects together.
pub(super) fn suspects(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    order: Order,
    size: usize,
    exec: &Execution<'_>,
) -> Result<Vec<u32>, Interruption> {
    let all = || (0..triangles.len() as u32).collect();
    let patches = Patches::new(vertices, triangles, order, size, exec)?;
    if patches.bare_edges() > triangles.len() / BOUNDARY_SHARE + FREE_BOUNDARY {
        return Ok(all());
    }
    let count = patches.list.len();
    let leaves = Leaves { triangles: (0..count as u32).collect(), order, size: 1, margin: 0.0, visits: Visits::Leaves };
    let tree = Tree::new(leaves, |p| patches.list[p as usize].extent.ends(), exec)?;
    let mut layers: Vec<Vec<u32>> = Vec::new();
    let mut charts =
        Charts { patches: &patches, cells: vec![NONE; count], parts: vec![NONE; count], slab_work: SLAB_WORK * count };
    for direction in directions(&patches, exec)? {
        charts.add_layers(direction, &tree, &mut layers, exec)?;
    }
    let same_chart = |a: usize, b: usize| layers.iter().any(|labels| labels[a] != NONE && labels[a] == labels[b]);
    let mut is_suspect = vec![false; count];
    // Oriented boxes are made only for the patches that are compared, because these are few.
    let mut own_boxes: Vec<Option<OwnBox>> = vec![None; count];
    let visit = |a: usize, b: usize| {
        // The leaves after the last patch are empty.
        let [Some(&a), Some(&b)] = [a, b].map(|leaf| tree.leaf(leaf).first()) else { return ControlFlow::Continue(()) };
        let [a, b] = [a as usize, b as usize];
        if a != b {
            for patch in [a, b] {
                own_boxes[patch]
                    .get_or_insert_with(|| tree.own_box(patches.triangles(patch).iter().map(|&t| patches.corners(t))));
            }
            if let (Some(one), Some(other)) = (&own_boxes[a], &own_boxes[b])
                && tree.are_apart(one, other)
            {
                return ControlFlow::Continue(());
            }
        }
        is_suspect[a] = true;
        is_suspect[b] = true;
        ControlFlow::Continue(())
    };
    let most_work = WORK * count as u64 + LOOK as u64;
    if !tree.visit_leaves(most_work, same_chart, visit, exec)? {
        return Ok(all());
    }
    let suspected = (0..count).filter(|&patch| is_suspect[patch]);
    let mut suspects: Vec<u32> = suspected.flat_map(|patch| patches.triangles(patch)).copied().collect();
    suspects.sort_unstable();
    Ok(suspects)
}

/// Chooses directions such that nearly every patch, together with the patches beside it, faces at least one of them.
fn directions(patches: &Patches, exec: &Execution<'_>) -> Result<Vec<DVec3>, Interruption> {
    let mut directions: Vec<DVec3> = Vec::new();
    let mut last = 0;
    for chunk in patches.list.chunks(LOOK) {
        for patch in chunk {
            let margin = (MARGIN_OF_NEIGHBOURS * patch.spread).clamp(NEIGHBOURS[0], NEIGHBOURS[1]);
            let Some(least) = least_cosine(patch, margin) else { continue };
            let is_covered = |direction: &DVec3| patch.axis.dot(*direction) > least;
            if directions.get(last).is_some_and(is_covered) {
                continue;
            }
            if let Some(found) = directions.iter().position(is_covered) {
                last = found;
            } else if directions.len() < DIRECTIONS {
                last = directions.len();
                directions.push(patch.axis);
            }
        }
        exec.look(chunk.len() as u64)?;
    }
    Ok(directions)
}

/// The cosine between a patch's axis and a direction above which all normals of the patch lie in the direction's cone
/// ([`CHART`]), by at least a margin. `None` if the normals spread too far for that.
fn least_cosine(patch: &Patch, margin: f64) -> Option<f64> {
    let left = CHART - margin - patch.spread;
    (left > 0.0).then(|| libm::cos(left))
}

/// Finds the charts of a surface, one direction after another.
struct Charts<'a> {
    patches: &'a Patches<'a>,
    /// For each patch that is searched at present (a member), the number of its cell: its slab, or 0 without slabs.
    /// [`NONE`] for all other patches.
    cells: Vec<u32>,
    /// For each member, the number of the connected part of its cell. [`NONE`] for all other patches.
    parts: Vec<u32>,
    /// Number of patches that may still be cut into slabs.
    slab_work: usize,
}

impl Charts<'_> {
    /// Adds the charts of one direction to `layers`. A layer holds, for each node of the tree, the number of the chart
    /// that contains all patches of the node, or [`NONE`].
    fn add_layers(
        &mut self,
        direction: DVec3,
        tree: &Tree,
        layers: &mut Vec<Vec<u32>>,
        exec: &Execution<'_>,
    ) -> Result<(), Interruption> {
        let list = &self.patches.list;
        let is_member = |patch: &Patch| least_cosine(patch, 0.0).is_some_and(|least| patch.axis.dot(direction) > least);
        let mut left: Vec<u32> = (0..).zip(list).filter(|(_, patch)| is_member(patch)).map(|(p, _)| p).collect();
        exec.look(list.len() as u64)?;
        let mut next = self.add_layer(direction, &left, |_| 0, tree, layers, exec)?;
        // The members that are in no chart yet are cut into slabs, because they belong to parts that lie over
        // themselves.
        let height = |p: u32| self.patches.list[p as usize].extent.centre().dot(direction);
        for count in SLABS {
            left = next;
            if left.is_empty() || self.slab_work < left.len() {
                break;
            }
            self.slab_work -= left.len();
            let (low, high) = left.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &p| {
                let height = height(p);
                (low.min(height), high.max(height))
            });
            let thickness = ((high - low) / count).max(f64::MIN_POSITIVE);
            next = Vec::new();
            for shift in [0.0, 0.5] {
                let cell = |p: u32| ((height(p) - low) / thickness + shift) as u32;
                next.extend(self.add_layer(direction, &left, cell, tree, layers, exec)?);
            }
            next.sort_unstable();
            next.dedup();
        }
        Ok(())
    }

    /// Divides the members into cells, finds the charts among the parts of the cells, and adds a layer if there are any
    /// charts. Returns the members that are in no chart.
    fn add_layer(
        &mut self,
        direction: DVec3,
        members: &[u32],
        cell: impl Fn(u32) -> u32,
        tree: &Tree,
        layers: &mut Vec<Vec<u32>>,
        exec: &Execution<'_>,
    ) -> Result<Vec<u32>, Interruption> {
        members.iter().for_each(|&p| self.cells[p as usize] = cell(p));
        let holds = self.find(direction, members, exec)?;
        let chart = |p: u32| {
            let part = self.parts[p as usize];
            if part != NONE && holds[part as usize] { part } else { NONE }
        };
        if holds.contains(&true) {
            layers.push(tree.labels(chart));
        }
        let outside = members.iter().copied().filter(|&p| chart(p) == NONE).collect();
        for &p in members {
            self.cells[p as usize] = NONE;
            self.parts[p as usize] = NONE;
        }
        exec.look(members.len() as u64)?;
        Ok(outside)
    }

    /// Finds the connected parts of the cells, and returns for each part whether it is a chart. All members must face
    /// the direction, and no other patch may have a cell.
    fn find(&mut self, direction: DVec3, members: &[u32], exec: &Execution<'_>) -> Result<Vec<bool>, Interruption> {
        let mut boundary: Vec<u32> = Vec::new();
        let (mut work, mut triangles) = (0, 0);
        for &p in members {
            let cell = self.cells[p as usize];
            let range = self.patches.edges_of(p);
            work += 1 + range.len();
            triangles += self.patches.triangles(p as usize).len();
            let bounds = |&e: &usize| {
                let across = self.patches.across[e];
                across == NONE || self.cells[across as usize] != cell
            };
            boundary.extend(range.filter(bounds).map(|e| e as u32));
            if work >= LOOK {
                exec.look(work as u64)?;
                work = 0;
            }
        }
        if boundary.len() > triangles / BOUNDARY_SHARE + FREE_BOUNDARY {
            return Ok(Vec::new());
        }
        // Each part has an area because it faces the direction, and therefore a polygon that runs counter-clockwise. If
        // there is only one such polygon, the members are one part.
        members.iter().for_each(|&p| self.parts[p as usize] = 0);
        let whole = Boundary::new(self, direction, &boundary);
        if whole.has_one_outer_polygon(1) == [true] {
            return whole.encloses_once(1, exec);
        }
        let count = self.find_parts(members, exec)?;
        Boundary::new(self, direction, &boundary).encloses_once(count, exec)
    }

    /// Numbers the connected parts of the cells, and returns their number.
    fn find_parts(&mut self, members: &[u32], exec: &Execution<'_>) -> Result<usize, Interruption> {
        members.iter().for_each(|&p| self.parts[p as usize] = NONE);
        let (mut count, mut work) = (0, 0);
        let mut stack = Vec::new();
        for &seed in members {
            if self.parts[seed as usize] != NONE {
                continue;
            }
            self.parts[seed as usize] = count;
            stack.push(seed);
            while let Some(p) = stack.pop() {
                let range = self.patches.edges_of(p);
                work += 1 + range.len();
                for &next in &self.patches.across[range] {
                    if next != NONE
                        && self.cells[next as usize] == self.cells[p as usize]
                        && self.parts[next as usize] == NONE
                    {
                        self.parts[next as usize] = count;
                        stack.push(next);
                    }
                }
                if work >= LOOK {
                    exec.look(work as u64)?;
                    work = 0;
                }
            }
            count += 1;
        }
        Ok(count as usize)
    }
}

/// The boundary edges of parts of a surface, projected along a direction.
struct Boundary {
    /// For each edge, the part that it bounds, the numbers of its ends, and the projections of its ends.
    parts: Vec<u32>,
    ends: Vec<[u32; 2]>,
    points: Vec<[DVec2; 2]>,
    /// For each edge, the next edge of the boundary of its part, which starts where this edge ends.
    next: Vec<u32>,
}

impl Boundary {
    /// Joins boundary edges into closed polygons. `edges` are the half-edges that bound the parts; each bounds exactly
    /// one part.
    fn new(charts: &Charts, direction: DVec3, edges: &[u32]) -> Self {
        let patches = charts.patches;
        let across = direction.any_orthonormal_vector();
        let up = direction.cross(across);
        let ends: Vec<[u32; 2]> = edges.iter().map(|&e| patches.edges[e as usize]).collect();
        // Points are taken relative to a point of the boundary, so that the rounding depends on the extent alone.
        let origin = ends.first().map_or(DVec3::ZERO, |&[first, _]| patches.point(first));
        let seen = |vertex: u32| {
            let point = patches.point(vertex) - origin;
            DVec2::new(point.dot(across), point.dot(up))
        };
        let parts: Vec<u32> = edges.iter().map(|&e| charts.parts[patches.owners[e as usize] as usize]).collect();
        let points: Vec<[DVec2; 2]> = ends.iter().map(|ends| ends.map(seen)).collect();
        let start = |e: u32| (parts[e as usize], ends[e as usize][0]);
        let mut departures: Vec<u32> = (0..edges.len() as u32).collect();
        departures.sort_unstable_by_key(|&e| start(e));
        let following = |e: usize| {
            let here = (parts[e], ends[e][1]);
            let from = departures.partition_point(|&other| start(other) < here);
            let leaving = departures[from..].iter().copied().take_while(|&other| start(other) == here);
            // The part lies on the left of its edges. The edge that bounds the same sector of the part at the vertex is
            // therefore the first edge clockwise from this edge.
            let [before, corner] = points[e];
            let clockwise = |other: u32| {
                let [u, v] = [before - corner, points[other as usize][1] - corner];
                let angle = -libm::atan2(u.perp_dot(v), u.dot(v));
                if angle > 0.0 { angle } else { angle + TAU }
            };
            let mut leaving = leaving.map(|other| (other, clockwise(other)));
            let first = leaving.next().expect("as many edges of a part leave a vertex as arrive there");
            leaving.fold(first, |first, other| if other.1 < first.1 { other } else { first }).0
        };
        let next = (0..edges.len()).map(following).collect();
        Self { parts, ends, points, next }
    }

    /// For each part, whether its boundary certainly consists of polygons that neither cross nor touch, exactly one of
    /// which runs counter-clockwise.
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
            // Ends because each pass marks an edge that was not marked before.
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

    /// Rejects parts whose boundary may cross itself at a vertex. Where the boundary passes through a vertex several
    /// times, each pass bounds a sector of triangles, and these sectors must not overlap. Then the passes can be moved
    /// apart, so that they do not cross at the vertex.
    fn reject_crossings_at_vertices(&self, holds: &mut [bool]) {
        let vertex = |edge: u32| (self.parts[edge as usize], self.ends[edge as usize][1]);
        let mut arrivals: Vec<u32> = (0..self.ends.len() as u32).collect();
        arrivals.sort_unstable_by_key(|&edge| vertex(edge));
        for passes in arrivals.chunk_by(|&a, &b| vertex(a) == vertex(b)).filter(|passes| passes.len() > 1) {
            // The vectors from the vertex to the next point and to the previous point of the pass.
            let rays = |edge: u32| {
                let [[before, here], [_, after]] =
                    [edge, self.next[edge as usize]].map(|edge| self.points[edge as usize]);
                [after - here, before - here]
            };
            // Whether a ray certainly lies outside the sector that runs counter-clockwise from ray `from` to ray `to`.
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

/// The sign of the turn from the first vector to the second. Zero if rounding makes it uncertain.
fn turn(u: DVec2, v: DVec2) -> f64 {
    let turn = u.perp_dot(v);
    let is_certain = turn.abs() > MARGIN * (u.abs().element_sum() + v.abs().element_sum());
    if is_certain { turn.signum() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square that stands on its corner, and a smaller square inside it with the same corner. One closed polygon runs
    /// round both squares. It is accepted if the small square is a hole, and rejected if it is covered twice.
    #[test]
    fn passes_through_one_vertex_must_go_round_sectors_of_their_own() {
        let outer = [[0.0, 0.0], [3.0, -3.0], [6.0, 0.0], [3.0, 3.0]];
        let twice = [[0.0, 0.0], [2.0, -1.0], [3.0, 0.0], [2.0, 1.0]];
        let hole = [[0.0, 0.0], [2.0, 1.0], [3.0, 0.0], [2.0, -1.0]];
        for (inner, expected) in [(twice, false), (hole, true)] {
            let points: Vec<DVec2> = [outer, inner].concat().into_iter().map(DVec2::from).collect();
            let after = |k: usize| (k + 1) % points.len();
            let number = |k: usize| if k == 4 { 0 } else { k as u32 };
            let boundary = Boundary {
                parts: vec![0; points.len()],
                ends: (0..points.len()).map(|k| [number(k), number(after(k))]).collect(),
                points: (0..points.len()).map(|k| [points[k], points[after(k)]]).collect(),
                next: (0..points.len()).map(|k| after(k) as u32).collect(),
            };
            assert_eq!(boundary.has_one_outer_polygon(1), [true]);
            assert_eq!(boundary.encloses_once(1, &Execution::default()), Ok(vec![expected]));
        }
    }
}
