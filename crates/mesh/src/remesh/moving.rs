//! Remeshing of a film with a moving boundary: keeps the edge lengths near one size while corners and curves move.
//!
//! Each round splits long edges, collapses short edges, flips edges and relaxes vertices within the film. On a flexible
//! stretch (a cable, or an edge that slides), vertices are split, collapsed and relaxed along the stretch. Kept
//! vertices stay where they are and are not merged.
//!
//! Source: Botsch, Kobbelt, *A Remeshing Approach to Multiresolution Modeling* (2004), section 4.

use super::delaunay::{flip_to_delaunay, tangential_relaxation};
use super::passes::{Collapse, Connected, Surface, collapse_edges, split_edges};
use crate::execution::WORK_PER_TRIANGLE;
use crate::film::Film;
use crate::measure::double_area_vector;
use crate::topology::{Topology, edge_key};
use crate::{DVec3, Execution, Interruption};
use std::collections::BTreeMap;

/// An edge is split if it exceeds this multiple of the target size at its ends.
const LONG: f64 = 1.4;
/// An edge is collapsed if it is shorter than this multiple of the target size. With values from 0.5 to 0.65, the forms
/// of random structures are found equally often.
const SHORT: f64 = 0.65;
/// A collapse is refused if it makes an edge longer than this multiple of the target size.
const LONGEST: f64 = 1.5;
/// Growth of the target size with the distance from a short edge that keeps its length, per unit of length.
const GRADING: f64 = 0.4;
/// A loop of three edges that bounds no triangle is a neck if its length (its girth) is below this multiple of the
/// target size.
const NECK: f64 = 3.0 * SHORT;
/// Number of sweeps along the curves in a relaxation. With fewer sweeps the segments of a cable are less even.
const CURVE_SWEEPS: u32 = 4;
/// Edges are sorted by their length relative to the size, in logarithmic steps of this relative width, so that rounding
/// does not decide between edges of equal length. The value is not a simple fraction, so that the lengths of regular
/// meshes do not lie on the limit between two steps.
const KEY_STEP: f64 = 1.234_567_891e-6;

/// The changes that remeshing may make to a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Moves within the film, and may merge with any vertex.
    Inside,
    /// Moves along the stretch of this number, and may merge with a vertex of the same stretch.
    Along(u32),
    /// Does not move, and is not merged into another vertex.
    Kept,
}

/// A boundary loop (closed), or a line across the film.
#[derive(Clone, Debug)]
pub struct Curve {
    pub vertices: Vec<u32>,
    /// For each edge from a vertex to the next, the number of its stretch. A closed curve also has the edge from its
    /// last vertex to its first.
    pub stretches: Vec<u32>,
}

impl Curve {
    fn edge(&self, k: usize) -> [u32; 2] {
        [self.vertices[k], self.vertices[(k + 1) % self.vertices.len()]]
    }
}

/// A film with the curves along which its vertices move.
#[derive(Clone, Debug)]
pub struct MovingFilm {
    pub film: Film,
    pub kinds: Vec<Kind>,
    /// The boundary loops in the order of the film's boundaries, then the lines across the film.
    pub curves: Vec<Curve>,
    /// For each stretch, whether its vertices move along it. On a stretch that is not flexible no vertex moves, and new
    /// vertices are kept.
    pub flexible: Vec<bool>,
    /// For each stretch, the smallest number of vertices inside it that collapses must leave.
    pub fewest: Vec<usize>,
    /// Numbers of kept vertices in which the caller is interested. They are updated when the vertices are renumbered.
    pub named: Vec<u32>,
}

/// A neck: a place where the film is about to close.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neck {
    pub place: DVec3,
    /// The length of the loop of three edges.
    pub girth: f64,
}

fn key(ratio: f64) -> u64 {
    (libm::log(ratio.max(1e-30)) / KEY_STEP + 1e10) as u64
}

impl MovingFilm {
    /// Brings the edge lengths near `size`, in the given number of rounds. `onto` projects a point near a stretch onto
    /// the stretch's support. Returns the narrowest neck of the last round.
    ///
    /// # Errors
    /// The interruptions of `exec`; the film is valid in that case too.
    pub fn remesh(
        &mut self,
        size: f64,
        rounds: u32,
        onto: &dyn Fn(u32, DVec3) -> DVec3,
        exec: &Execution,
    ) -> Result<Option<Neck>, Interruption> {
        let mut neck = None;
        for _ in 0..rounds {
            let mut sizes = self.sizes(size);
            for _ in 0..6 {
                exec.look(WORK_PER_TRIANGLE * self.film.triangles().len() as u64)?;
                if !self.split_long(&mut sizes, onto) {
                    break;
                }
                flip_to_delaunay(&mut self.film, exec)?;
            }
            for _ in 0..4 {
                exec.look(WORK_PER_TRIANGLE * self.film.triangles().len() as u64)?;
                let collapsed;
                (collapsed, neck) = self.collapse_short(&mut sizes, onto);
                if !collapsed {
                    break;
                }
            }
            for _ in 0..2 {
                flip_to_delaunay(&mut self.film, exec)?;
                for _ in 0..CURVE_SWEEPS {
                    self.relax_curves(onto);
                }
                tangential_relaxation(&mut self.film, 1);
            }
            flip_to_delaunay(&mut self.film, exec)?;
        }
        Ok(neck.filter(|neck| neck.girth < NECK * size))
    }

    /// The stretch of every edge of a curve.
    fn stretches(&self) -> BTreeMap<[u32; 2], u32> {
        let edge_stretches = |curve: &Curve| -> Vec<([u32; 2], u32)> {
            curve.stretches.iter().enumerate().map(|(k, &stretch)| (edge_key(curve.edge(k)), stretch)).collect()
        };
        self.curves.iter().flat_map(edge_stretches).collect()
    }

    /// For each stretch, the number of vertices inside it.
    fn numbers_inside(&self) -> Vec<usize> {
        let mut numbers = vec![0; self.flexible.len()];
        for kind in &self.kinds {
            if let Kind::Along(stretch) = kind {
                numbers[*stretch as usize] += 1;
            }
        }
        numbers
    }

    /// The target size at every vertex: the given size, but less beside shorter edges that keep their length and beside
    /// stretches that need more vertices.
    fn sizes(&self, size: f64) -> Vec<f64> {
        let mut sizes = vec![size; self.film.vertices.len()];
        let at = &self.film.vertices;
        let stretches = self.stretches();
        let length = |edge: &[u32; 2]| at[edge[0] as usize].distance(at[edge[1] as usize]);
        let mut lengths = vec![0.0; self.flexible.len()];
        stretches.iter().for_each(|(edge, &stretch)| lengths[stretch as usize] += length(edge));
        for (edge, &stretch) in &stretches {
            let stretch = stretch as usize;
            let spacing = if self.flexible[stretch] {
                lengths[stretch] / (self.fewest[stretch] + 1) as f64
            } else {
                length(edge)
            };
            if spacing < 0.7 * size {
                edge.iter().for_each(|&v| sizes[v as usize] = sizes[v as usize].min(1.1 * spacing));
            }
        }
        if sizes.iter().any(|&own| own < size) {
            let topology = &self.film.topology;
            for _ in 0..30 {
                let mut changed = false;
                for h in 0..topology.twin.len() as u32 {
                    let (a, b) = (topology.from(h) as usize, topology.to(h) as usize);
                    let grown = GRADING * at[a].distance(at[b]);
                    for (near, far) in [(a, b), (b, a)] {
                        if sizes[far] > (sizes[near] + grown) * (1.0 + 1e-9) {
                            sizes[far] = sizes[near] + grown;
                            changed = true;
                        }
                    }
                }
                if !changed {
                    break;
                }
            }
        }
        sizes
    }

    /// For each edge, the ratio of its length to the target size, and a half-edge.
    fn ratios(&self, sizes: &[f64]) -> Vec<(f64, u32)> {
        let (topology, at) = (&self.film.topology, &self.film.vertices);
        let ratio = |h: u32| {
            let (a, b) = (topology.from(h) as usize, topology.to(h) as usize);
            (at[a].distance(at[b]) / (0.5 * (sizes[a] + sizes[b])), h)
        };
        (0..topology.twin.len() as u32).filter(|&h| topology.twin[h as usize] > h).map(ratio).collect()
    }

    fn split_long(&mut self, sizes: &mut Vec<f64>, onto: &dyn Fn(u32, DVec3) -> DVec3) -> bool {
        let stretches = self.stretches();
        let inside = self.numbers_inside();
        let mut long = self.ratios(sizes);
        for (ratio, h) in &mut long {
            let ends = edge_key([self.film.topology.from(*h), self.film.topology.to(*h)]);
            let lacks = |&&stretch: &&u32| {
                self.flexible[stretch as usize] && inside[stretch as usize] < self.fewest[stretch as usize]
            };
            if stretches.get(&ends).filter(lacks).is_some() {
                *ratio *= 2.0 * LONG / ratio.min(1.0);
            }
        }
        long.retain(|&(ratio, _)| ratio > LONG);
        long.sort_by_key(|&(ratio, h)| (u64::MAX - key(ratio), h));
        let long: Vec<u32> = long.into_iter().map(|(_, h)| h).collect();
        let mut pass = Pass::new(self, sizes, onto, stretches);
        if split_edges(&mut pass, long) == 0 {
            return false;
        }
        let middles = pass.middles;
        if !middles.is_empty() {
            for curve in &mut self.curves {
                let (mut vertices, mut stretches) = (Vec::new(), Vec::new());
                for (k, &v) in curve.vertices.iter().enumerate() {
                    vertices.push(v);
                    let Some(&stretch) = curve.stretches.get(k) else { continue };
                    stretches.push(stretch);
                    if let Some(&middle) = middles.get(&edge_key(curve.edge(k))) {
                        vertices.push(middle);
                        stretches.push(stretch);
                    }
                }
                *curve = Curve { vertices, stretches };
            }
            self.renew_curves();
        }
        true
    }

    /// Sets the boundaries and the locked edges of the film to those of the curves.
    pub fn renew_curves(&mut self) {
        let count = self.film.boundaries.len();
        self.film.boundaries = self.curves[..count].iter().map(|curve| curve.vertices.clone()).collect();
        self.film.locked = self.curves[count..]
            .iter()
            .flat_map(|curve| (0..curve.stretches.len()).map(|k| edge_key(curve.edge(k))))
            .collect();
        self.film.locked.sort_unstable();
    }

    fn collapse_short(&mut self, sizes: &mut Vec<f64>, onto: &dyn Fn(u32, DVec3) -> DVec3) -> (bool, Option<Neck>) {
        let mut short: Vec<(f64, u32)> = self.ratios(sizes).into_iter().filter(|&(ratio, _)| ratio < SHORT).collect();
        short.sort_by_key(|&(ratio, h)| (key(ratio), h));
        let stretches = self.stretches();
        let short: Vec<u32> = short.into_iter().map(|(_, h)| h).collect();
        let mut pass = Pass::new(self, sizes, onto, stretches);
        let any = collapse_edges(&mut pass, short) > 0;
        let Pass { dead, neck, .. } = pass;
        if any {
            self.remove(&dead, sizes);
        }
        (any, neck)
    }

    /// The neck that prevents an edge from collapsing: a loop of three edges that contains the edge and bounds no
    /// triangle.
    fn neck_at(&self, a: u32, b: u32) -> Option<Neck> {
        let topology = &self.film.topology;
        let corners = [(a, b), (b, a)].map(|(from, to)| topology.half_edge(from, to).map(|h| topology.opposite(h)));
        if corners.contains(&None) || [a, b].iter().any(|&v| topology.degree(v) <= 3) {
            return None;
        }
        let is_neck = |v: &u32| {
            *v != b && !corners.contains(&Some(*v)) && topology.are_adjacent(*v, b) && topology.degree(*v) > 3
        };
        let third = topology.neighbours(a).find(is_neck)?;
        let [p, q, r] = [a, b, third].map(|v| self.film.vertices[v as usize]);
        Some(Neck { place: (p + q + r) / 3.0, girth: p.distance(q) + q.distance(r) + r.distance(p) })
    }

    /// Whether a collapse may move `v` to `place`: the triangles around `v` that do not contain `other` pass
    /// [`stays_whole`], and their edges stay short enough.
    fn keeps_shape(&self, sizes: &[f64], v: u32, other: u32, place: DVec3) -> bool {
        let (topology, at) = (&self.film.topology, &self.film.vertices);
        topology.outgoing_half_edges(v).all(|h| {
            let (j, k) = (topology.to(h), topology.opposite(h));
            if j == other || k == other {
                return true;
            }
            let (p, q) = (at[j as usize], at[k as usize]);
            let longest = LONGEST * sizes[v as usize];
            stays_whole([at[v as usize], p, q], [place, p, q], 0.3, 0.08)
                && place.distance(p).max(place.distance(q)) < longest
        })
    }

    /// Removes the vertices that were merged into others.
    fn remove(&mut self, dead: &[bool], sizes: &mut Vec<f64>) {
        let film = &mut self.film;
        let closed = film.topology.without_gaps(|v| !dead[v]);
        let (topology, left) = closed.expect("the link condition keeps a manifold");
        film.topology = topology;
        film.vertices = left.of(&film.vertices);
        film.fixed = left.of(&film.fixed);
        self.kinds = left.of(&self.kinds);
        *sizes = left.of(sizes);
        self.named.iter_mut().for_each(|v| *v = left.number(*v));
        for curve in &mut self.curves {
            let (mut vertices, mut stretches) = (Vec::new(), Vec::new());
            for (k, &v) in curve.vertices.iter().enumerate() {
                // Both edges at a vertex that is removed belong to the same stretch.
                if !dead[v as usize] {
                    vertices.push(left.number(v));
                    stretches.extend(curve.stretches.get(k));
                }
            }
            *curve = Curve { vertices, stretches };
        }
        self.renew_curves();
    }

    /// Moves each vertex of a flexible stretch along its curve, so that its two edges on the curve become more equal.
    fn relax_curves(&mut self, onto: &dyn Fn(u32, DVec3) -> DVec3) {
        for curve in &self.curves {
            let count = curve.vertices.len();
            for (k, &v) in curve.vertices.iter().enumerate() {
                let Kind::Along(stretch) = self.kinds[v as usize] else { continue };
                let at = &self.film.vertices;
                let here = at[v as usize];
                let [before, after] = [k + count - 1, k + 1].map(|k| at[curve.vertices[k % count] as usize]);
                let (back, ahead) = (here.distance(before), here.distance(after));
                let shift = 0.25 * (ahead - back);
                let towards = if shift > 0.0 { after - here } else { here - before };
                let place = onto(stretch, here + shift * towards.normalize_or_zero());
                let topology = &self.film.topology;
                let keeps = topology.outgoing_half_edges(v).all(|h| {
                    let [p, q] = [topology.to(h), topology.opposite(h)].map(|w| at[w as usize]);
                    stays_whole([here, p, q], [place, p, q], 0.3, 0.05)
                });
                if keeps {
                    self.film.vertices[v as usize] = place;
                }
            }
        }
    }
}

/// A pass of splits or of collapses over a film whose edges move.
struct Pass<'m> {
    moving: &'m mut MovingFilm,
    sizes: &'m mut Vec<f64>,
    onto: &'m dyn Fn(u32, DVec3) -> DVec3,
    /// The stretch of every edge of a curve.
    stretches: BTreeMap<[u32; 2], u32>,
    /// The edges of curves that were split, each with its new vertex.
    middles: BTreeMap<[u32; 2], u32>,
    /// For each stretch the number of vertices inside it.
    inside: Vec<usize>,
    /// Marks the vertices that were merged into others.
    dead: Vec<bool>,
    /// The narrowest neck that has prevented a collapse.
    neck: Option<Neck>,
}

impl<'m> Pass<'m> {
    fn new(
        moving: &'m mut MovingFilm,
        sizes: &'m mut Vec<f64>,
        onto: &'m dyn Fn(u32, DVec3) -> DVec3,
        stretches: BTreeMap<[u32; 2], u32>,
    ) -> Self {
        let (inside, dead) = (moving.numbers_inside(), vec![false; moving.kinds.len()]);
        Self { moving, sizes, onto, stretches, middles: BTreeMap::new(), inside, dead, neck: None }
    }

    fn ends(&self, h: u32) -> [u32; 2] {
        [self.moving.film.topology.from(h), self.moving.film.topology.to(h)]
    }

    fn middle(&self, ends: [u32; 2]) -> DVec3 {
        let [a, b] = ends.map(|v| self.moving.film.vertices[v as usize]);
        0.5 * (a + b)
    }
}

impl Connected for Pass<'_> {
    fn topology(&self) -> &Topology {
        &self.moving.film.topology
    }

    fn topology_mut(&mut self) -> &mut Topology {
        &mut self.moving.film.topology
    }
}

impl Surface for Pass<'_> {
    type Place = DVec3;

    fn add_middle(&mut self, h: u32) -> Option<u32> {
        let ends = self.ends(h);
        let place = self.middle(ends);
        let middle = self.moving.kinds.len() as u32;
        let (kind, place) = match self.stretches.get(&edge_key(ends)) {
            None => (Kind::Inside, place),
            Some(&stretch) => {
                self.middles.insert(edge_key(ends), middle);
                if self.moving.flexible[stretch as usize] {
                    (Kind::Along(stretch), (self.onto)(stretch, place))
                } else {
                    (Kind::Kept, place)
                }
            }
        };
        self.moving.film.vertices.push(place);
        self.moving.film.fixed.push(kind != Kind::Inside);
        self.moving.kinds.push(kind);
        let [a, b] = ends.map(|v| self.sizes[v as usize]);
        self.sizes.push(0.5 * (a + b));
        Some(middle)
    }

    /// Two vertices inside the film, or two of one stretch, meet in the middle. Otherwise the vertex that may move is
    /// merged into the other one.
    fn planned_collapse(&self, h: u32) -> Option<Collapse<DVec3>> {
        let [a, b] = self.ends(h);
        let stretch = self.stretches.get(&edge_key([a, b])).copied();
        let (leaves, stays, in_the_middle) =
            match (stretch, self.moving.kinds[a as usize], self.moving.kinds[b as usize]) {
                (Some(s), _, _) if self.inside[s as usize] <= self.moving.fewest[s as usize] => return None,
                (Some(_), Kind::Along(_), Kind::Along(_)) | (None, Kind::Inside, Kind::Inside) => (a, b, true),
                (Some(_), Kind::Along(_), _) | (None, Kind::Inside, _) => (a, b, false),
                (Some(_), _, Kind::Along(_)) | (None, _, Kind::Inside) => (b, a, false),
                _ => return None,
            };
        let place = if in_the_middle {
            let middle = self.middle([a, b]);
            stretch.map_or(middle, |stretch| (self.onto)(stretch, middle))
        } else {
            self.moving.film.vertices[stays as usize]
        };
        Some(Collapse { leaves, stays, place, moves: true })
    }

    fn cannot_collapse(&mut self, h: u32) {
        let [a, b] = self.ends(h);
        if let Some(found) = self.moving.neck_at(a, b)
            && self.neck.is_none_or(|known| found.girth < known.girth)
        {
            self.neck = Some(found);
        }
    }

    fn keeps_shape(&self, &Collapse { leaves, stays, place, .. }: &Collapse<DVec3>) -> bool {
        let keeps = |v: u32, other: u32| self.moving.keeps_shape(self.sizes, v, other, place);
        let moves = place != self.moving.film.vertices[stays as usize];
        keeps(leaves, stays) && (!moves || keeps(stays, leaves))
    }

    fn merge(&mut self, Collapse { leaves, stays, place, .. }: Collapse<DVec3>) {
        self.moving.film.vertices[stays as usize] = place;
        self.dead[leaves as usize] = true;
        if let Some(&stretch) = self.stretches.get(&edge_key([leaves, stays])) {
            self.inside[stretch as usize] -= 1;
        }
    }
}

/// Whether a moved triangle keeps its direction and does not become thin. Its normal must turn by less than the angle
/// with this cosine; a triangle that had almost no area may turn in any direction. Twice its area divided by the sum of
/// its squared sides must be at least `thin`, or at least as large as before the move.
fn stays_whole(before: [DVec3; 3], after: [DVec3; 3], cosine: f64, thin: f64) -> bool {
    let squares = |[p, q, r]: [DVec3; 3]| p.distance_squared(q) + q.distance_squared(r) + r.distance_squared(p);
    let (normal, moved) = (double_area_vector(before), double_area_vector(after));
    let (was, is) = (normal.length() / squares(before), moved.length() / squares(after).max(f64::MIN_POSITIVE));
    (was < 1e-3 || normal.dot(moved) >= cosine * normal.length() * moved.length()) && (is >= thin || is >= was)
}
