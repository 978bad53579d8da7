//! A fine triangulation of a curved surface, the reference, on which the nodes of the mesh stand and move.
//!
//! The place of a node is a triangle of the reference with barycentric coordinates ([`Spot`]). Its position lies on the
//! true surface: on a patch the coordinates give the parameters, and a film consists of the triangles themselves. A
//! displacement is a straight walk over the triangles, which are unfolded at each edge. Places and walks need no plane
//! of parameters. Closed patches, poles and surfaces that cannot be flattened are therefore no special cases: seams are
//! sewn up, and a pole is a single vertex of the triangulation.
//!
//! Walks end at edges on the boundary and on creases (lines along which a patch has no common tangent plane). These
//! edges are joined to curves between corners. A node on a curve has one degree of freedom, the length along the curve.

use super::curves::{Curve, join_curves};
use super::nurbs::{Nurbs, unit_normal};
use super::tessellation::{Tessellation, tessellate};
use crate::edges::topology;
use crate::report::Why;
use plateau_mesh::error::{Error, Place};
use plateau_mesh::measure::{self, double_area_vector, vertex_normals};
use plateau_mesh::topology::{NONE, Topology, next};
use plateau_mesh::{DVec2, DVec3, Mesh};

/// Angle in radians above which a line of a patch with discontinuous derivatives is a crease: the normals on its two
/// sides differ by more than this somewhere on the line.
const CREASE: f64 = 0.35;
/// Largest distance from a corner, in ℓ, at which the angle between two curves bounds the edges between them.
const NEAR_CORNER: f64 = 3.0;
/// Least length of a short edge for which a sharp corner or a short closed side counts as the reason, as a fraction of
/// the length that the corner or the side leaves to an edge.
const FORCED: f64 = 0.9;
/// Number of intervals into which each side is divided to find the distance between two sides near a corner.
const STEPS_NEAR_CORNER: usize = 8;
/// Distance between neighbours of three nodes that are evenly spaced on a circle, as a fraction of the circle's length.
/// A closed side has at least three nodes.
const OF_THREE: f64 = 0.275;
/// Largest number of triangles that a walk visits.
const LONGEST_WALK: usize = 2000;
/// Number of tangential steps to the foot of a point. One step is exact on a flat facet. On an arch of half a turn,
/// four steps leave less than a thousandth of the distance.
const FOOT_STEPS: usize = 4;

/// A point of the reference triangulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    pub triangle: u32,
    pub weights: [f64; 3],
}

/// The motion that a node is allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Bond {
    /// Motion on the surface.
    Free,
    /// Motion along a curve. `at` is the length along the curve from its start to the node.
    Curve { curve: u32, at: f64 },
    /// No motion: the node is a corner, at this vertex of the reference.
    Fixed(u32),
}

/// The place of a node on the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NodeLocation {
    pub spot: Spot,
    pub bond: Bond,
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
    /// For each vertex whether it is a corner.
    pub corner: Vec<bool>,
    /// The surface's area.
    pub area: f64,
}

impl Reference {
    /// Makes the reference of a patch whose lengths are in ℓ.
    ///
    /// # Errors
    /// [`Error::Input`] at `place`: the patch collapses to a line, or touches itself along more than a seam.
    pub fn of_patch(patch: &Nurbs, place: &Place) -> Result<Self, Error> {
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

    /// Makes the reference of a film, which is the film's own mesh. The vertices `corners` must stay where they are.
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
        mut corner: Vec<bool>,
        area: f64,
    ) -> Self {
        let mut normals = vertex_normals(&mesh);
        if let Some((patch, parameters)) = &patch {
            // The normals are those of the patch, except at creases and poles, where they are the means of the facets'
            // normals.
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
            // Along a crease the averaged normals say nothing about the curvature of the surface beside it.
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
        let curves = join_curves(&mesh, &topology, &stops, patch.is_some(), &mut corner);
        Self { mesh, topology, normals, curvature, patch, stops, curves, corner, area }
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

    /// Returns the two vertices of each edge of a curve, in the direction of the curve.
    pub fn chain(&self, curve: u32) -> Vec<(u32, u32)> {
        let ends = |&(h, against): &(u32, bool)| {
            let (from, to) = (self.topology.from(h), self.topology.to(h));
            if against { (to, from) } else { (from, to) }
        };
        self.curves[curve as usize].edges.iter().map(ends).collect()
    }

    /// The smallest angle, in radians, between two curves at a vertex. If the vertex has fewer than two curves, the
    /// angle around the vertex.
    pub fn angle_at(&self, vertex: u32) -> f64 {
        let position = |v: u32| self.mesh.vertices[v as usize];
        let (mut sectors, mut begins_on_curve) = (vec![0.0], true);
        for (k, h) in self.topology.outgoing_half_edges(vertex).enumerate() {
            if k == 0 {
                begins_on_curve = self.stops[h as usize];
            } else if self.stops[h as usize] {
                sectors.push(0.0);
            }
            let sides = [self.topology.to(h), self.topology.opposite(h)].map(|v| position(v) - position(vertex));
            *sectors.last_mut().expect("starts with one sector") += measure::angle(sides[0], sides[1]);
        }
        // If the turn did not begin on a curve, the first and the last sector are parts of the same sector.
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

    /// Returns the reason why an edge of this length, in ℓ, between two nodes is outside [ℓ, 2ℓ]. The boundary and the
    /// creases count as the reason only if the edge is about as long as they allow. For shorter edges the reason is
    /// [`Why::Curvature`].
    pub fn why(&self, ends: [NodeLocation; 2], length: f64) -> Why {
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

    /// Returns the least length, in ℓ, of an edge across a sharp corner, if the nodes are on the two sides of the
    /// corner and this length is below ℓ.
    pub fn apart_across(&self, ends: [NodeLocation; 2]) -> Option<f64> {
        let [first, second] = ends.map(|place| self.curves_of(place.bond));
        if first.is_empty() || second.is_empty() || first.iter().any(|c| second.contains(c)) {
            return None;
        }
        self.apart_at_corner(ends, [&first, &second]).filter(|&apart| apart < 1.0)
    }

    /// Returns the distance between the curves of two nodes near the corner at which the curves meet, or infinity if
    /// the corner is not sharp. Returns `None` if the curves do not meet, or if the nodes are not near the corner.
    fn apart_at_corner(&self, ends: [NodeLocation; 2], [first, second]: [&[u32]; 2]) -> Option<f64> {
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

    /// Returns the least distance between two curves that meet at a corner, where each is considered from ℓ to
    /// [`NEAR_CORNER`] away from the corner. No node is nearer to the corner if every edge along the curves is ℓ or
    /// longer. For straight curves at an angle α the distance is 2 sin(α/2) ℓ.
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

    /// Returns the length along `curve` at which a node lies, or `None` if the node is not on the curve. A closed curve
    /// starts and ends at the same corner; this corner then counts as the end nearer to `near`, the length of a
    /// neighbour on the curve.
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

    /// Walks from a spot in a straight line over the unfolded triangles. The walk ends early where it meets a curve.
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

    /// Returns the spots that describe the same point in each triangle from which a walk can start there. A walk that
    /// starts on a curve reaches only the side on which its triangle lies.
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
                let at_corner = |h: u32| {
                    let mut weights = [0.0; 3];
                    weights[h as usize % 3] = 1.0;
                    Spot { triangle: h / 3, weights }
                };
                self.topology.outgoing_half_edges(v).map(at_corner).collect()
            }
            _ => vec![spot],
        }
    }

    /// Returns the spot near `start` whose point of the surface is nearest to a point in space. Takes a few tangential
    /// steps.
    pub fn foot(&self, start: Spot, point: DVec3) -> Spot {
        let mut spot = start;
        for _ in 0..FOOT_STEPS {
            spot = self.walk(spot, self.off_foot(spot, point));
        }
        spot
    }

    /// The component along the facet of the vector from a spot to a point in space. It is zero at the point's foot.
    fn off_foot(&self, spot: Spot, point: DVec3) -> DVec3 {
        (point - self.point(spot)).reject_from_normalized(self.facet_normal(spot))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::plane::unit_vector;

    /// Returns a flat rhombus of side 10 whose angle at the origin is `degrees`, and its two curves that meet at the
    /// origin.
    fn rhombus(degrees: f64) -> (Reference, [u32; 2]) {
        let (a, b) = (DVec3::X * 10.0, unit_vector(degrees.to_radians()).extend(0.0) * 10.0);
        let knots = vec![0.0, 0.0, 1.0, 1.0];
        let control_points = vec![vec![DVec3::ZERO, b], vec![a, a + b]];
        let patch = Nurbs { degrees: [1, 1], knots: [knots.clone(), knots], control_points, weights: None };
        let reference = Reference::of_patch(&patch, &Place::field("domain")).unwrap();
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
                NodeLocation { spot: reference.on_curve(curves[which], at), bond }
            };
            let why = |ends: [NodeLocation; 2]| {
                let [p, q] = ends.map(|place| reference.point(place.spot));
                reference.why(ends, p.distance(q))
            };
            // The ends are at distance ℓ from the corner, so straight sides are 2 sin(α/2) ℓ apart there.
            if degrees < 60.0 {
                assert_eq!(why([node(0, 1.0), node(1, 1.0)]), expected, "{degrees}");
                assert_eq!(why([node(0, 1.0), node(1, 1.1)]), expected, "{degrees}");
            }
            // These nodes are nearer to the corner than edges in range allow.
            assert_eq!(why([node(0, 0.5), node(1, 0.5)]), Why::Curvature, "{degrees}");
            // A corner is no reason for a short edge along a single side.
            assert_eq!(why([node(0, 1.0), node(0, 1.3)]), Why::Curvature, "{degrees}");
        }
    }

    #[test]
    fn the_steps_to_a_foot_leave_little_of_the_way() {
        let row = |x: f64, z: f64| vec![DVec3::new(x, 0.0, z), DVec3::new(x, 10.0, z)];
        let control_points = vec![row(-5.0, 0.0), row(-4.0, 8.0), row(4.0, 8.0), row(5.0, 0.0)];
        let knots = [vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0], vec![0.0, 0.0, 1.0, 1.0]];
        let patch = Nurbs { degrees: [3, 1], knots, control_points, weights: None };
        let reference = Reference::of_patch(&patch, &Place::field("domain")).unwrap();
        let centre = |triangle: u32| Spot { triangle, weights: [1.0 / 3.0; 3] };
        let mut compared = 0;
        for t in 0..reference.mesh.triangles.len() as u32 {
            for other in (0..reference.mesh.triangles.len() as u32).step_by(7) {
                let (start, end) = (reference.point(centre(t)), reference.point(centre(other)));
                let point = end + 0.1 * reference.facet_normal(centre(other));
                if start.distance(end) > 1.0 {
                    continue;
                }
                let rest = reference.off_foot(reference.foot(centre(t), point), point).length();
                assert!(rest < 1e-3 * start.distance(end).max(0.1), "{t} {other}: {rest} of {}", start.distance(end));
                compared += 1;
            }
        }
        assert!(compared > 100, "{compared}");
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
            NodeLocation { spot: reference.spot_of(curve.ends[k]), bond }
        };
        let middle =
            NodeLocation { spot: reference.on_curve(curves[0], 0.1), bond: Bond::Curve { curve: curves[0], at: 0.1 } };
        assert_eq!(reference.why([end(0), end(1)], 0.8), Why::ShortSide);
        assert_eq!(reference.why([end(0), middle], 0.1), Why::Curvature);
    }
}
