//! A fine triangulation of a curved surface on which nodes stand and walk.
//!
//! A node's place is a triangle and barycentric coordinates ([`Spot`]). Its position is on the true surface: for a
//! patch the coordinates give the parameters, for a film the facet is the surface. A displacement is a straight walk
//! over the triangles, unfolded at each edge. Neither needs a plane of parameters, so that closed patches, poles and
//! surfaces that cannot be flattened are no special cases: seams are sewn up and poles are single vertices of the
//! triangulation.
//!
//! Edges on the boundary and on creases (lines where a patch has no common tangent plane) end a walk. They are joined
//! to curves between corners. A node on a curve has one degree of freedom, the length along it.

use super::nurbs::{Nurbs, unit_normal};
use crate::edges::topology;
use crate::report::Why;
use plateau_mesh::error::{Error, Place as InputPlace};
use plateau_mesh::measure::{self, double_area_vector, vertex_normals};
use plateau_mesh::topology::{NONE, Topology, next};
use plateau_mesh::{DVec2, DVec3, Mesh};

/// The constants of the triangulation of a patch.
struct Grid {
    /// Largest side of a cell, in ℓ. Half an edge resolves the metric; smaller cells only cost time.
    side: f64,
    /// Largest angle between the normals at the ends of a cell's side, radians.
    turn: f64,
    /// Samples of the patch along each knot span, by which sides and angles are measured.
    samples: usize,
    /// Largest number of samples along one parameter.
    most_samples: usize,
    /// Bounds of the number of cells, and how many there may be for each ℓ² of surface in between.
    cells: (f64, f64),
    cells_per_area: f64,
    /// Fewest cells along a parameter between two creases.
    fewest: usize,
}

const GRID: Grid = Grid {
    side: 0.5,
    turn: 0.2,
    samples: 16,
    most_samples: 640,
    cells: (40_000.0, 500_000.0),
    cells_per_area: 12.0,
    fewest: 4,
};

/// A line of a patch with discontinuous derivatives is a crease if the normals on its two sides differ by more than
/// this angle somewhere, radians.
const CREASE: f64 = 0.35;
/// A vertex of a curve is a corner if the curve turns by more than this angle, radians.
const CORNER_TURN: f64 = std::f64::consts::FRAC_PI_6;
/// A sharp corner can be the reason for the length of an edge only if both ends of the edge are nearer to it than this,
/// in ℓ.
const NEAR_CORNER: f64 = 3.0;
/// A sharp corner or a short closed side is the reason for a short edge only if the edge has at least this fraction of
/// the length that the corner or the side leaves to an edge.
const FORCED: f64 = 0.9;
/// Points on each side, less one, at which that distance is taken.
const STEPS_NEAR_CORNER: usize = 8;
/// A closed side takes three nodes. Their distance on a circle, as a fraction of its length.
const OF_THREE: f64 = 0.275;
/// Points nearer than this fraction of the surface's size coincide.
const COINCIDENT: f64 = 1e-9;
/// Largest number of edges that one walk crosses; a guard against an endless walk around a degenerate vertex.
const LONGEST_WALK: usize = 2000;

/// A point of the reference triangulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    pub triangle: u32,
    pub weights: [f64; 3],
}

/// The motion that a node is allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Bond {
    /// Move on the surface.
    Free,
    /// Move along a curve; `at` is the length from the curve's start.
    Curve { curve: u32, at: f64 },
    /// Nothing: the node is a corner, this vertex of the reference.
    Fixed(u32),
}

/// Where a node stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    pub spot: Spot,
    pub bond: Bond,
}

/// A chain of reference edges between two corners, or around from one corner to itself.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    /// The edges in order: a half-edge, and whether the chain runs against it.
    edges: Vec<(u32, bool)>,
    /// The length before each edge, and the whole length at the end.
    pub at: Vec<f64>,
    /// The reference's vertices at the ends.
    pub ends: [u32; 2],
}

impl Curve {
    pub fn length(&self) -> f64 {
        self.at[self.at.len() - 1]
    }
}

/// The triangulation.
#[derive(Debug)]
pub(crate) struct Reference {
    pub mesh: Mesh,
    pub topology: Topology,
    /// Unit normals at the vertices.
    normals: Vec<DVec3>,
    /// Largest normal curvature at each vertex, in 1/ℓ.
    curvature: Vec<f64>,
    /// The patch, and the parameters of each triangle's corners. `None` for a film.
    patch: Option<(Nurbs, Vec<[DVec2; 3]>)>,
    /// Marks the half-edges at which a walk ends.
    pub stops: Vec<bool>,
    pub curves: Vec<Curve>,
    /// Marks the vertices that are corners.
    pub corner: Vec<bool>,
    /// The surface's area.
    pub area: f64,
}

/// The parts of a triangulated patch.
struct Tessellation {
    mesh: Mesh,
    parameters: Vec<[DVec2; 3]>,
    /// Edges on lines that may be creases, by line: the smaller vertex first.
    lines: Vec<Vec<[u32; 2]>>,
    corners: Vec<u32>,
}

impl Reference {
    /// The reference of a patch whose lengths are in ℓ.
    ///
    /// # Errors
    /// [`Error::Input`] at `place`: the patch collapses to a line, or touches itself along more than a seam.
    pub fn of_patch(patch: &Nurbs, place: &InputPlace) -> Result<Self, Error> {
        let tessellation = tessellate(patch).ok_or_else(|| {
            Error::input(
                place.clone(),
                "part of the patch collapses to a line or folds onto itself: leave that part out",
            )
        })?;
        let Tessellation { mesh, parameters, lines, corners } = tessellation;
        let topology = topology(mesh.vertices.clone(), &mesh.triangles).map_err(|_| {
            Error::input(place.clone(), "the patch touches itself along more than a seam: split it into several")
        })?;
        let mut flags = vec![false; mesh.vertices.len()];
        for v in corners {
            flags[v as usize] = topology.is_boundary(v);
        }
        let normal = |t: u32| double_area_vector(mesh.corners(mesh.triangles[t as usize]));
        let mut stops: Vec<bool> = topology.twin.iter().map(|&twin| twin == NONE).collect();
        for line in lines {
            let half_edges: Vec<u32> = line
                .iter()
                .filter_map(|&[a, b]| topology.outgoing_half_edges(a).find(|&h| topology.to(h) == b))
                .filter(|&h| topology.twin[h as usize] != NONE)
                .collect();
            let bend = |&h: &u32| measure::angle(normal(h / 3), normal(topology.twin[h as usize] / 3));
            if half_edges.iter().map(bend).fold(0.0, f64::max) > CREASE {
                for h in half_edges {
                    stops[h as usize] = true;
                    stops[topology.twin[h as usize] as usize] = true;
                }
            }
        }
        let area = (0..mesh.triangles.len())
            .map(|t| {
                let [a, b, c] = parameters[t];
                let density = |p: DVec2| {
                    let [_, du, dv] = patch.evaluate(p);
                    du.cross(dv).length()
                };
                let sum = density((a + b) / 2.0) + density((b + c) / 2.0) + density((c + a) / 2.0);
                0.5 * (b - a).perp_dot(c - a).abs() * sum / 3.0
            })
            .sum();
        let area = if f64::is_finite(area) { area } else { measure::area(&mesh) };
        Ok(Self::assemble(mesh, topology, Some((patch.clone(), parameters)), stops, flags, area))
    }

    /// The reference of a film: its own mesh. `corners`: the vertices that must stay where they are.
    pub fn of_film(mesh: Mesh, topology: Topology, corners: &[u32]) -> Self {
        let stops = topology.twin.iter().map(|&twin| twin == NONE).collect();
        let mut flags = vec![false; mesh.vertices.len()];
        corners.iter().for_each(|&v| flags[v as usize] = true);
        let area = measure::area(&mesh);
        Self::assemble(mesh, topology, None, stops, flags, area)
    }

    fn assemble(
        mesh: Mesh,
        topology: Topology,
        patch: Option<(Nurbs, Vec<[DVec2; 3]>)>,
        stops: Vec<bool>,
        corner: Vec<bool>,
        area: f64,
    ) -> Self {
        let mut normals = vertex_normals(&mesh);
        if let Some((patch, parameters)) = &patch {
            // The patch's own normals, but for creases and poles, where the mean of the facets serves.
            let mut on_stop = vec![false; mesh.vertices.len()];
            for h in (0..topology.twin.len() as u32).filter(|&h| stops[h as usize] && topology.twin[h as usize] != NONE)
            {
                on_stop[topology.from(h) as usize] = true;
            }
            let mut derivatives = Vec::with_capacity(3 * parameters.len());
            let mut largest = [0.0; 2];
            for [_, du, dv] in parameters.iter().flatten().map(|&p| patch.evaluate(p)) {
                largest = [f64::max(largest[0], du.length()), f64::max(largest[1], dv.length())];
                derivatives.push((du, dv));
            }
            for (&v, &(du, dv)) in mesh.triangles.iter().flatten().zip(&derivatives) {
                if let Some(normal) = unit_normal(du, dv, largest)
                    && !on_stop[v as usize]
                    && normal.dot(normals[v as usize]) > 0.5
                {
                    normals[v as usize] = normal;
                }
            }
        }
        let mut curvature = vec![0.0f64; mesh.vertices.len()];
        for h in 0..topology.twin.len() as u32 {
            let (a, b) = (topology.from(h) as usize, topology.to(h) as usize);
            // A crease's averaged normals say nothing of the curvature beside it.
            if stops[h as usize] {
                continue;
            }
            let length = mesh.vertices[a].distance(mesh.vertices[b]);
            let turn = normals[a].distance(normals[b]);
            if length > 0.0 {
                curvature[a] = curvature[a].max(turn / length);
                curvature[b] = curvature[b].max(turn / length);
            }
        }
        let mut reference = Self { mesh, topology, normals, curvature, patch, stops, curves: Vec::new(), corner, area };
        reference.join_curves();
        reference
    }

    /// Joins the edges at which walks end to curves, and marks the corners between them.
    fn join_curves(&mut self) {
        let topology = &self.topology;
        // Each edge by one half-edge, at both of its ends.
        let mut at_vertex: Vec<(u32, u32)> = Vec::new();
        for h in 0..topology.twin.len() as u32 {
            let twin = topology.twin[h as usize];
            if self.stops[h as usize] && (twin == NONE || twin > h) {
                at_vertex.extend([(topology.from(h), h), (topology.to(h), h)]);
            }
        }
        at_vertex.sort_unstable();
        let around = |v: u32| {
            let first = at_vertex.partition_point(|&(w, _)| w < v);
            let last = at_vertex.partition_point(|&(w, _)| w <= v);
            &at_vertex[first..last]
        };
        let other = |h: u32, v: u32| if topology.from(h) == v { topology.to(h) } else { topology.from(h) };
        let at = |v: u32| self.mesh.vertices[v as usize];
        let mut k = 0;
        while k < at_vertex.len() {
            let v = at_vertex[k].0;
            let edges = around(v);
            k += edges.len();
            let sharp = match *edges {
                [(_, g), (_, h)] => measure::angle(at(v) - at(other(g, v)), at(other(h, v)) - at(v)) > CORNER_TURN,
                _ => true,
            };
            // A film's corners are given; on a patch a crease or a boundary with a kink makes one.
            self.corner[v as usize] |= edges.len() != 2 || (sharp && self.patch.is_some());
        }
        let mut used = vec![false; topology.twin.len()];
        let mut curves = Vec::new();
        let mut trace = |start: u32, first: u32, corner: &[bool], used: &mut [bool]| {
            let (mut v, mut h) = (start, first);
            let mut curve = Curve { edges: Vec::new(), at: vec![0.0], ends: [start, start] };
            loop {
                used[h as usize] = true;
                let end = other(h, v);
                curve.edges.push((h, topology.from(h) != v));
                curve.at.push(curve.length() + at(v).distance(at(end)));
                v = end;
                if corner[v as usize] || v == start {
                    break;
                }
                match around(v).iter().find(|&&(_, g)| !used[g as usize]) {
                    Some(&(_, g)) => h = g,
                    None => break,
                }
            }
            curve.ends[1] = v;
            curves.push(curve);
        };
        let corners: Vec<u32> = (0..self.corner.len() as u32).filter(|&v| self.corner[v as usize]).collect();
        for v in corners {
            for &(_, h) in around(v) {
                if !used[h as usize] {
                    trace(v, h, &self.corner, &mut used);
                }
            }
        }
        // Loops without a corner get one.
        for &(v, h) in &at_vertex {
            if !used[h as usize] {
                self.corner[v as usize] = true;
                trace(v, h, &self.corner, &mut used);
            }
        }
        self.curves = curves;
    }

    /// The point of the surface at a spot.
    pub fn point(&self, spot: Spot) -> DVec3 {
        let (t, [wa, wb, wc]) = (spot.triangle as usize, spot.weights);
        match &self.patch {
            Some((patch, parameters)) => {
                let [a, b, c] = parameters[t];
                patch.evaluate(a * wa + b * wb + c * wc)[0]
            }
            None => {
                let [a, b, c] = self.mesh.corners(self.mesh.triangles[t]);
                a * wa + b * wb + c * wc
            }
        }
    }

    /// The normal at a spot, interpolated between the vertices' normals.
    pub fn normal(&self, spot: Spot) -> DVec3 {
        let corners = self.mesh.triangles[spot.triangle as usize];
        let sum: DVec3 = corners.iter().zip(spot.weights).map(|(&v, w)| self.normals[v as usize] * w).sum();
        sum.normalize_or_zero()
    }

    /// The normal of the facet at a spot.
    pub fn facet_normal(&self, spot: Spot) -> DVec3 {
        double_area_vector(self.mesh.corners(self.mesh.triangles[spot.triangle as usize])).normalize_or_zero()
    }

    /// The largest normal curvature about a spot, in 1/ℓ.
    pub fn curvature(&self, spot: Spot) -> f64 {
        let corners = self.mesh.triangles[spot.triangle as usize];
        corners.iter().map(|&v| self.curvature[v as usize]).fold(0.0, f64::max)
    }

    /// The spot of a vertex.
    pub fn spot_of(&self, vertex: u32) -> Spot {
        let h = self.topology.outgoing[vertex as usize];
        let mut weights = [0.0; 3];
        weights[h as usize % 3] = 1.0;
        Spot { triangle: h / 3, weights }
    }

    /// The spot at a length along a curve.
    pub fn on_curve(&self, curve: u32, at: f64) -> Spot {
        let curve = &self.curves[curve as usize];
        let k = curve.at.partition_point(|&start| start <= at).clamp(1, curve.edges.len()) - 1;
        let (from, to) = (curve.at[k], curve.at[k + 1]);
        let part = if to > from { ((at - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        let (h, against) = curve.edges[k];
        let part = if against { 1.0 - part } else { part };
        let mut weights = [0.0; 3];
        weights[h as usize % 3] = 1.0 - part;
        weights[next(h) as usize % 3] = part;
        Spot { triangle: h / 3, weights }
    }

    /// The vertices of a curve's edges, in its direction.
    pub fn chain(&self, curve: u32) -> Vec<(u32, u32)> {
        let ends = |&(h, against): &(u32, bool)| {
            let (from, to) = (self.topology.from(h), self.topology.to(h));
            if against { (to, from) } else { (from, to) }
        };
        self.curves[curve as usize].edges.iter().map(ends).collect()
    }

    /// The smallest angle at a vertex between curves, or around it where there is none, radians.
    pub fn angle_at(&self, vertex: u32) -> f64 {
        let at = |v: u32| self.mesh.vertices[v as usize];
        let (mut sectors, mut begins_on_curve) = (vec![0.0], true);
        for (k, h) in self.topology.outgoing_half_edges(vertex).enumerate() {
            if k == 0 {
                begins_on_curve = self.stops[h as usize];
            } else if self.stops[h as usize] {
                sectors.push(0.0);
            }
            let sides = [self.topology.to(h), self.topology.opposite(h)].map(|v| at(v) - at(vertex));
            *sectors.last_mut().expect("starts with one sector") += measure::angle(sides[0], sides[1]);
        }
        // The sector in whose middle the turn began ends where the turn does.
        if !begins_on_curve && let [first, .., last] = &mut sectors[..] {
            *last += *first;
            *first = f64::INFINITY;
        }
        sectors.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// The curves that a node stands on.
    fn curves_of(&self, bond: Bond) -> Vec<u32> {
        match bond {
            Bond::Free => Vec::new(),
            Bond::Curve { curve, .. } => vec![curve],
            Bond::Fixed(v) => {
                (0..self.curves.len() as u32).filter(|&c| self.curves[c as usize].ends.contains(&v)).collect()
            }
        }
    }

    /// Why an edge of this length, in ℓ, between two nodes is outside [ℓ, 2ℓ]. The boundary and the creases are the
    /// reason only for edges that are as long as they allow; shorter ones are left to [`Why::Curvature`].
    pub fn why(&self, ends: [Place; 2], length: f64) -> Why {
        let [first, second] = ends.map(|place| self.curves_of(place.bond));
        if length > 1.0 || first.is_empty() || second.is_empty() {
            return Why::Curvature;
        }
        let shared: Vec<&Curve> =
            first.iter().filter(|c| second.contains(c)).map(|&c| &self.curves[c as usize]).collect();
        if !shared.is_empty() {
            let are_corners = ends.iter().all(|place| matches!(place.bond, Bond::Fixed(_)));
            let forces = |curve: &&Curve| {
                let is_whole = are_corners || length >= FORCED * OF_THREE * curve.length();
                curve.length() < 1.0 && is_whole
            };
            return if shared.iter().any(forces) { Why::ShortSide } else { Why::Curvature };
        }
        match self.apart_at_corner(ends, [&first, &second]) {
            None => Why::Narrow,
            Some(apart) if apart < 1.0 && length >= FORCED * apart => Why::SharpCorner,
            Some(_) => Why::Curvature,
        }
    }

    /// The least length that a sharp corner leaves to edges across it, if these nodes stand on its two sides and that
    /// length is below ℓ.
    pub fn apart_across(&self, ends: [Place; 2]) -> Option<f64> {
        let [first, second] = ends.map(|place| self.curves_of(place.bond));
        if first.is_empty() || second.is_empty() || first.iter().any(|c| second.contains(c)) {
            return None;
        }
        self.apart_at_corner(ends, [&first, &second]).filter(|&apart| apart < 1.0)
    }

    /// How far the curves of two nodes are apart at the corner where they meet, infinite if that is not sharp. `None`
    /// if they meet at none, or the nodes are not near it.
    fn apart_at_corner(&self, ends: [Place; 2], [first, second]: [&[u32]; 2]) -> Option<f64> {
        let points = ends.map(|place| self.point(place.spot));
        let mut least = None;
        for (&c, &d) in first.iter().flat_map(|c| second.iter().map(move |d| (c, d))) {
            let [one, other] = [c, d].map(|c| self.curves[c as usize].ends);
            for v in one.into_iter().filter(|v| other.contains(v)) {
                let corner = self.mesh.vertices[v as usize];
                if points.iter().all(|point| point.distance(corner) < NEAR_CORNER) {
                    let is_sharp = self.angle_at(v) < std::f64::consts::FRAC_PI_2;
                    let apart = if is_sharp { self.apart_near(v, [c, d]) } else { f64::INFINITY };
                    least = Some(apart.min(least.unwrap_or(f64::INFINITY)));
                }
            }
        }
        least
    }

    /// The least distance between two curves that meet at a corner, from ℓ to [`NEAR_CORNER`] away from it along each:
    /// no node stands nearer to the corner if every edge along the curves is ℓ or longer. Straight curves that meet at
    /// an angle α are 2 sin(α/2) ℓ apart.
    fn apart_near(&self, corner: u32, curves: [u32; 2]) -> f64 {
        let [one, other] = curves.map(|c| {
            let curve = &self.curves[c as usize];
            let length = curve.length();
            let way = |k: usize| (1.0 + (NEAR_CORNER - 1.0) * k as f64 / STEPS_NEAR_CORNER as f64).min(length);
            let mut points = Vec::new();
            for k in 0..=STEPS_NEAR_CORNER {
                // A closed curve leaves its corner in both directions.
                if curve.ends[0] == corner {
                    points.push(self.point(self.on_curve(c, way(k))));
                }
                if curve.ends[1] == corner {
                    points.push(self.point(self.on_curve(c, length - way(k))));
                }
            }
            points
        });
        one.iter().flat_map(|p| other.iter().map(|q| p.distance(*q))).fold(f64::INFINITY, f64::min)
    }

    /// The unit tangent of a curve.
    pub fn tangent(&self, curve: u32, at: f64) -> DVec3 {
        let length = self.curves[curve as usize].length();
        let step = 1e-3 * length.min(1.0);
        let [low, high] =
            [(at - step).max(0.0), (at + step).min(length)].map(|at| self.point(self.on_curve(curve, at)));
        (high - low).normalize_or_zero()
    }

    /// The length along `curve` at which a node stands, seen from a neighbour on the curve at `near`. A corner at both
    /// ends of a closed curve is the end nearer to the neighbour.
    pub fn at(&self, curve: u32, bond: Bond, near: Option<f64>) -> Option<f64> {
        let (ends, length) = (self.curves[curve as usize].ends, self.curves[curve as usize].length());
        match bond {
            Bond::Curve { curve: other, at } => (other == curve).then_some(at),
            Bond::Fixed(v) if ends[0] == ends[1] => {
                (v == ends[0]).then(|| if near.is_some_and(|near| near > 0.5 * length) { length } else { 0.0 })
            }
            Bond::Fixed(v) => ends.iter().position(|&end| end == v).map(|k| if k == 0 { 0.0 } else { length }),
            Bond::Free => None,
        }
    }

    /// Goes straight on from a spot, unfolding the triangles on the way; stops at curves.
    pub fn walk(&self, spot: Spot, displacement: DVec3) -> Spot {
        let Spot { triangle: mut t, weights: mut w } = spot;
        let mut d = displacement;
        for _ in 0..LONGEST_WALK {
            let corners = self.mesh.triangles[t as usize];
            let [a, b, c] = self.mesh.corners(corners);
            let (e, f) = (b - a, c - a);
            let (ee, ef, ff) = (e.dot(e), e.dot(f), f.dot(f));
            let determinant = ee * ff - ef * ef;
            if determinant <= 1e-20 * ee * ff {
                break;
            }
            let (de, df) = (d.dot(e), d.dot(f));
            let (x, y) = ((de * ff - df * ef) / determinant, (df * ee - de * ef) / determinant);
            let rates = [-x - y, x, y];
            let (mut part, mut exit) = (1.0, None);
            for k in 0..3 {
                if rates[k] < 0.0 && w[k] < -rates[k] * part {
                    (part, exit) = (w[k] / -rates[k], Some(k));
                }
            }
            for k in 0..3 {
                w[k] = (w[k] + rates[k] * part).max(0.0);
            }
            if let Some(k) = exit {
                w[k] = 0.0;
            }
            let sum: f64 = w.iter().sum();
            w = w.map(|weight| weight / sum);
            let Some(k) = exit else { break };
            let h = 3 * t + (k as u32 + 1) % 3;
            let twin = self.topology.twin[h as usize];
            if self.stops[h as usize] || twin == NONE {
                break;
            }
            let rest = (e * x + f * y) * (1.0 - part);
            let (from, to) = (self.topology.from(h), self.topology.to(h));
            let [from, to, apex] = [from, to, self.topology.opposite(twin)].map(|v| self.mesh.vertices[v as usize]);
            let along = (to - from).normalize_or_zero();
            let inward = (apex - from).reject_from(to - from).normalize_or_zero();
            let straight = rest.dot(along);
            d = along * straight + inward * (rest - along * straight).length();
            let mut crossed = [0.0; 3];
            crossed[twin as usize % 3] = w[(k + 2) % 3];
            crossed[next(twin) as usize % 3] = w[(k + 1) % 3];
            (t, w) = (twin / 3, crossed);
            if !d.is_finite() {
                break;
            }
        }
        Spot { triangle: t, weights: w }
    }

    /// The same point as a spot of every triangle from which a walk may set out: a walk from a curve reaches only the
    /// side that its triangle lies on.
    pub fn sides(&self, spot: Spot) -> Vec<Spot> {
        let Spot { triangle: t, weights: w } = spot;
        let zeros: Vec<usize> = (0..3).filter(|&k| w[k] == 0.0).collect();
        match zeros[..] {
            [k] => {
                let h = 3 * t + (k as u32 + 1) % 3;
                let twin = self.topology.twin[h as usize];
                if !self.stops[h as usize] || twin == NONE {
                    return vec![spot];
                }
                let mut crossed = [0.0; 3];
                crossed[twin as usize % 3] = w[(k + 2) % 3];
                crossed[next(twin) as usize % 3] = w[(k + 1) % 3];
                vec![spot, Spot { triangle: twin / 3, weights: crossed }]
            }
            [_, _] => {
                let k = w.iter().position(|&w| w > 0.0).unwrap_or(0);
                let v = self.mesh.triangles[t as usize][k];
                let at = |h: u32| {
                    let mut weights = [0.0; 3];
                    weights[h as usize % 3] = 1.0;
                    Spot { triangle: h / 3, weights }
                };
                self.topology.outgoing_half_edges(v).map(at).collect()
            }
            _ => vec![spot],
        }
    }

    /// The spot near `start` whose point of the surface is nearest to a point of space, by a few tangential steps.
    pub fn foot(&self, start: Spot, point: DVec3) -> Spot {
        let mut spot = start;
        for _ in 0..4 {
            let normal = self.facet_normal(spot);
            let off = point - self.point(spot);
            spot = self.walk(spot, off - normal * off.dot(normal));
        }
        spot
    }
}

/// The parameters of the lines of a tensor-product grid, and which of them may be creases.
fn lines(patch: &Nurbs) -> ([Vec<f64>; 2], [Vec<usize>; 2]) {
    // Distinct knots on [0, 1], and whether the patch may have a crease there.
    let spans: [Vec<(f64, bool)>; 2] = [0, 1].map(|axis| {
        let (knots, degree) = (&patch.knots[axis], patch.degrees[axis]);
        let (low, high) = (knots[degree], knots[knots.len() - degree - 1]);
        let mut distinct: Vec<(f64, usize)> = Vec::new();
        for &knot in knots.iter().filter(|&&knot| knot >= low && knot <= high) {
            match distinct.last_mut() {
                Some((last, count)) if *last == knot => *count += 1,
                _ => distinct.push((knot, 1)),
            }
        }
        distinct.iter().map(|&(knot, count)| ((knot - low) / (high - low), count >= degree)).collect()
    });
    let samples: [Vec<f64>; 2] = [0, 1].map(|axis| {
        let count = spans[axis].len() - 1;
        let each = GRID.samples.min(GRID.most_samples / count).max(1);
        let mut all: Vec<f64> = spans[axis]
            .windows(2)
            .flat_map(|pair| (0..each).map(move |k| pair[0].0 + (pair[1].0 - pair[0].0) * k as f64 / each as f64))
            .collect();
        all.push(1.0);
        all
    });
    // Points and normals at the samples; at a pole there is no normal.
    let evaluated: Vec<Vec<[DVec3; 3]>> =
        samples[0].iter().map(|&u| samples[1].iter().map(|&v| patch.evaluate(DVec2::new(u, v))).collect()).collect();
    let largest = [1, 2].map(|k| evaluated.iter().flatten().map(|sample| sample[k].length()).fold(0.0, f64::max));
    let at: Vec<Vec<(DVec3, Option<DVec3>)>> = evaluated
        .iter()
        .map(|row| row.iter().map(|&[p, du, dv]| (p, unit_normal(du, dv, largest))).collect())
        .collect();
    let (nu, nv) = (samples[0].len(), samples[1].len());
    let area: f64 = (1..nu)
        .flat_map(|i| (1..nv).map(move |j| (i, j)))
        .map(|(i, j)| 0.5 * (at[i][j].0 - at[i - 1][j - 1].0).cross(at[i - 1][j].0 - at[i][j - 1].0).length())
        .sum();
    let need = |a: (DVec3, Option<DVec3>), b: (DVec3, Option<DVec3>)| {
        let turn = match (a.1, b.1) {
            (Some(a), Some(b)) => a.distance(b),
            _ => 0.0,
        };
        (a.0.distance(b.0) / GRID.side).max(turn / GRID.turn)
    };
    let along_u = (1..nu).map(|i| (0..nv).map(|j| need(at[i - 1][j], at[i][j])).fold(0.0, f64::max)).collect();
    let along_v = (1..nv).map(|j| (0..nu).map(|i| need(at[i][j - 1], at[i][j])).fold(0.0, f64::max)).collect();
    let needs: [Vec<f64>; 2] = [along_u, along_v];
    let most = (GRID.cells_per_area * area).clamp(GRID.cells.0, GRID.cells.1);
    let wanted: f64 = needs.iter().map(|need| need.iter().sum::<f64>()).product();
    let scale = (most / wanted).sqrt().min(1.0);
    let mut creases: [Vec<usize>; 2] = Default::default();
    let grid = [0, 1].map(|axis| {
        let mut grid = vec![0.0];
        let mut from = 0;
        for &(knot, may_crease) in &spans[axis][1..] {
            if !may_crease && knot < 1.0 {
                continue;
            }
            let to = samples[axis].partition_point(|&t| t < knot);
            let need = &needs[axis][from..to];
            let total = need.iter().sum::<f64>() * scale;
            let fewest = GRID.fewest.min(GRID.most_samples / spans[axis].len()).max(1);
            let count = (total.ceil() as usize).max(fewest);
            // Equal shares of the need, which may be zero where the patch stands still.
            let least = 1e-6 * total.max(1e-6) / need.len() as f64;
            let weights: Vec<f64> = need.iter().map(|need| need * scale + least).collect();
            let sum: f64 = weights.iter().sum();
            let (mut passed, mut k) = (0.0, 0);
            for line in 1..count {
                let aim = sum * line as f64 / count as f64;
                while k + 1 < weights.len() && passed + weights[k] < aim {
                    passed += weights[k];
                    k += 1;
                }
                let (low, high) = (samples[axis][from + k], samples[axis][from + k + 1]);
                grid.push(low + (high - low) * ((aim - passed) / weights[k]).clamp(0.0, 1.0));
            }
            grid.push(knot);
            creases[axis].push(grid.len() - 1);
            from = to;
        }
        grid
    });
    (grid, creases)
}

/// The triangulation of a patch over a grid: seams sewn up, poles merged. `None` if an edge elsewhere has no length.
fn tessellate(patch: &Nurbs) -> Option<Tessellation> {
    let ([us, vs], creases) = lines(patch);
    let (nu, nv) = (us.len() - 1, vs.len() - 1);
    let points: Vec<DVec3> = us
        .iter()
        .flat_map(|&u| vs.iter().map(move |&v| (u, v)))
        .map(|(u, v)| patch.evaluate(DVec2::new(u, v))[0])
        .collect();
    let index = |i: usize, j: usize| i * (nv + 1) + j;
    let size = points.iter().map(|p| p.length()).fold(0.0, f64::max);
    let tiny = COINCIDENT * size;
    let same = |a: (usize, usize), b: (usize, usize)| points[index(a.0, a.1)].distance(points[index(b.0, b.1)]) <= tiny;
    let closed = [(0..=nv).all(|j| same((0, j), (nu, j))), (0..=nu).all(|i| same((i, 0), (i, nv)))];
    // The sides u = 0, u = 1, v = 0, v = 1.
    let pole = [
        (0..=nv).all(|j| same((0, 0), (0, j))),
        (0..=nv).all(|j| same((nu, 0), (nu, j))),
        (0..=nu).all(|i| same((0, 0), (i, 0))),
        (0..=nu).all(|i| same((0, nv), (i, nv))),
    ];
    let representative = |i: usize, j: usize| {
        // Poles first: a pole's row is one point, whether or not the patch closes across it.
        let j = if (i == 0 && pole[0]) || (i == nu && pole[1]) { 0 } else { j };
        let i = if (j == 0 && pole[2]) || (j == nv && pole[3]) { 0 } else { i };
        let i = if i == nu && closed[0] && !pole[1] { 0 } else { i };
        let j = if j == nv && closed[1] && !pole[3] { 0 } else { j };
        index(i, j)
    };
    let mut number = vec![NONE; points.len()];
    let mut vertices = Vec::new();
    for i in 0..=nu {
        for j in 0..=nv {
            let k = representative(i, j);
            if number[k] == NONE {
                number[k] = vertices.len() as u32;
                vertices.push(points[k]);
            }
        }
    }
    let vertex = |i: usize, j: usize| number[representative(i, j)];
    let (mut triangles, mut parameters) = (Vec::new(), Vec::new());
    let apart = |a: u32, b: u32| vertices[a as usize].distance(vertices[b as usize]);
    for i in 0..nu {
        for j in 0..nv {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            let numbers = corners.map(|(i, j)| vertex(i, j));
            let places = corners.map(|(i, j)| DVec2::new(us[i], vs[j]));
            // The shorter diagonal, unless a pole leaves one triangle only.
            let straight = apart(numbers[0], numbers[2]) <= apart(numbers[1], numbers[3]) * (1.0 + 1e-9);
            let halves = if straight { [[0, 1, 2], [0, 2, 3]] } else { [[0, 1, 3], [1, 2, 3]] };
            for half in halves {
                let triangle = half.map(|k| numbers[k]);
                if triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0] {
                    continue;
                }
                let mut at = half.map(|k| places[k]);
                // A pole has every parameter of its side: the middle of the cell's serves best.
                for (k, &corner) in half.iter().enumerate() {
                    let (i, j) = corners[corner];
                    if (j == 0 && pole[2]) || (j == nv && pole[3]) {
                        at[k].x = 0.5 * (places[0].x + places[2].x);
                    }
                    if (i == 0 && pole[0]) || (i == nu && pole[1]) {
                        at[k].y = 0.5 * (places[0].y + places[2].y);
                    }
                }
                if (0..3).any(|k| apart(triangle[k], triangle[(k + 1) % 3]) <= tiny) {
                    return None;
                }
                triangles.push(triangle);
                parameters.push(at);
            }
        }
    }
    let mut candidates = Vec::new();
    let ordered = |a: u32, b: u32| [a.min(b), a.max(b)];
    for &i in &creases[0] {
        candidates.push((0..nv).map(|j| ordered(vertex(i, j), vertex(i, j + 1))).collect());
    }
    for &j in &creases[1] {
        candidates.push((0..nu).map(|i| ordered(vertex(i, j), vertex(i + 1, j))).collect());
    }
    let corners = vec![vertex(0, 0), vertex(nu, 0), vertex(nu, nv), vertex(0, nv)];
    Some(Tessellation { mesh: Mesh::new(vertices, triangles), parameters, lines: candidates, corners })
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::plane::unit_vector;

    /// A flat rhombus of side 10 with this angle at the origin, in degrees, and its two curves from there.
    fn rhombus(degrees: f64) -> (Reference, [u32; 2]) {
        let (a, b) = (DVec3::X * 10.0, unit_vector(degrees.to_radians()).extend(0.0) * 10.0);
        let knots = vec![0.0, 0.0, 1.0, 1.0];
        let control_points = vec![vec![DVec3::ZERO, b], vec![a, a + b]];
        let patch = Nurbs { degrees: [1, 1], knots: [knots.clone(), knots], control_points, weights: None };
        let reference = Reference::of_patch(&patch, &InputPlace::field("domain")).unwrap();
        let is_here = |c: &u32| reference.curves[*c as usize].ends.iter().any(|&v| is_origin(&reference, v));
        let here: Vec<u32> = (0..reference.curves.len() as u32).filter(is_here).collect();
        (reference, [here[0], here[1]])
    }

    fn is_origin(reference: &Reference, vertex: u32) -> bool {
        reference.mesh.vertices[vertex as usize].length() < 1e-9
    }

    #[test]
    fn a_sharp_corner_is_the_reason_only_for_edges_across_it_that_are_as_long_as_its_angle_makes_them() {
        for (degrees, expected) in [(20.0, Why::SharpCorner), (50.0, Why::SharpCorner), (90.0, Why::Curvature)] {
            let (reference, curves) = rhombus(degrees);
            let node = |which: usize, from_corner: f64| {
                let curve = &reference.curves[curves[which] as usize];
                let starts_here = is_origin(&reference, curve.ends[0]);
                let at = if starts_here { from_corner } else { curve.length() - from_corner };
                let bond = Bond::Curve { curve: curves[which], at };
                Place { spot: reference.on_curve(curves[which], at), bond }
            };
            let why = |ends: [Place; 2]| {
                let [p, q] = ends.map(|place| reference.point(place.spot));
                reference.why(ends, p.distance(q))
            };
            // Both ends at ℓ from the corner: with straight sides 2 sin(α/2) ℓ apart.
            if degrees < 60.0 {
                assert_eq!(why([node(0, 1.0), node(1, 1.0)]), expected, "{degrees}");
                assert_eq!(why([node(0, 1.0), node(1, 1.1)]), expected, "{degrees}");
            }
            // Nearer to the corner than any edge in range lets them stand.
            assert_eq!(why([node(0, 0.5), node(1, 0.5)]), Why::Curvature, "{degrees}");
            // Along a side no corner forces anything.
            assert_eq!(why([node(0, 1.0), node(0, 1.3)]), Why::Curvature, "{degrees}");
        }
    }

    #[test]
    fn a_short_side_is_the_reason_only_for_the_whole_side() {
        let (mut reference, curves) = rhombus(90.0);
        for vertex in &mut reference.mesh.vertices {
            *vertex *= 0.08;
        }
        for curve in &mut reference.curves {
            curve.at.iter_mut().for_each(|at| *at *= 0.08);
        }
        let curve = &reference.curves[curves[0] as usize];
        let end = |k: usize| {
            let bond = Bond::Fixed(curve.ends[k]);
            Place { spot: reference.spot_of(curve.ends[k]), bond }
        };
        let middle =
            Place { spot: reference.on_curve(curves[0], 0.1), bond: Bond::Curve { curve: curves[0], at: 0.1 } };
        assert_eq!(reference.why([end(0), end(1)], 0.8), Why::ShortSide);
        assert_eq!(reference.why([end(0), middle], 0.1), Why::Curvature);
    }
}
