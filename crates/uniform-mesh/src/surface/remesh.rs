//! Isotropic remeshing on a surface: from the reference triangulation to triangles of about the target edge length.
//!
//! Source: Botsch, Kobbelt, *A Remeshing Approach to Multiresolution Modeling* (2004), section 4: collapse short edges,
//! split long ones, flip, relax tangentially. Our departures: nodes never leave the surface, because they walk on the
//! [`Reference`]. Nodes on its curves stay on the curves, and corners do not move. An operation that would turn a
//! triangle against the surface's normals is refused, so that no edge cuts through a thin sheet or a sharp crest.
//!
//! The passes that split and collapse edges are those of films ([`passes`](plateau_mesh::remesh::passes)).

use super::reference::{Bond, NodeLocation, Reference};
use plateau_mesh::DVec3;
use plateau_mesh::execution::{Execution, Interruption, WORK_PER_TRIANGLE};
use plateau_mesh::measure::{self, double_area_vector};
use plateau_mesh::remesh::delaunay::{Relaxed, relax};
use plateau_mesh::remesh::flips::flip_where;
use plateau_mesh::remesh::passes::{self, Collapse, Connected, Surface};
use plateau_mesh::topology::{NONE, Topology, edge_key};

/// Constants of the remeshing.
struct Remeshing {
    /// Length above which an edge is split, as a multiple of the target length (Botsch and Kobbelt: 4/3).
    long: f64,
    /// Length below which an edge is collapsed, as a multiple of the target length (Botsch and Kobbelt: 4/5).
    short: f64,
    /// Maximum number of passes at the start that collapse edges and split none. Each pass removes up to a seventh of
    /// the nodes.
    coarsening_passes: usize,
    /// Fraction of the nodes that a pass must remove for the coarsening to continue.
    coarsened: f64,
    /// Number of rounds of splits, collapses, flips and relaxation.
    rounds: usize,
    /// Number of relaxation sweeps in each round.
    sweeps: usize,
    /// Least cosine between a triangle's normal and the mean of the surface's normals at its corners.
    upright: f64,
    /// Least altitude of a triangle as a fraction of its longest side. Rounding decides the normal of a flatter
    /// triangle.
    thinnest: f64,
    /// An edge flips if its opposite angles add up to more than 180° plus this angle, radians.
    flat: f64,
}

const REMESHING: Remeshing = Remeshing {
    long: 4.0 / 3.0,
    short: 0.8,
    coarsening_passes: 40,
    coarsened: 0.01,
    rounds: 12,
    sweeps: 3,
    upright: 0.1,
    thinnest: 1e-3,
    flat: 1e-6,
};

/// The target edge length at each place: a constant, or a smaller length where the surface is strongly curved.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Size {
    /// The length where the surface is nearly flat, in ℓ.
    pub largest: f64,
    /// The length where the surface is strongly curved, in ℓ.
    pub least: f64,
    /// Product of length and curvature where the length lies between these two bounds.
    pub turn: f64,
}

impl Size {
    fn at(self, curvature: f64) -> f64 {
        (self.turn / curvature.max(f64::MIN_POSITIVE)).clamp(self.least, self.largest)
    }
}

/// The place at which the ends of a collapsed edge meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meeting {
    /// At one of the ends, which needs no walk on the surface.
    End,
    /// Half way between the two ends.
    Middle,
}

/// A mesh whose nodes stand on the reference.
#[derive(Clone, Debug)]
pub(crate) struct Net<'a> {
    pub reference: &'a Reference,
    pub places: Vec<NodeLocation>,
    pub positions: Vec<DVec3>,
    pub normals: Vec<DVec3>,
    pub topology: Topology,
    /// The edges along curves, each with the smaller end first, and their curves. Sorted.
    pub along: Vec<([u32; 2], u32)>,
    size: Size,
    sizes: Vec<f64>,
}

/// The square of a triangle's longest side.
pub(crate) fn longest_squared([a, b, c]: [DVec3; 3]) -> f64 {
    a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a))
}

impl<'a> Net<'a> {
    /// Makes a net of the reference's own triangles.
    pub fn new(reference: &'a Reference, size: Size) -> Self {
        let count = reference.mesh.vertices.len();
        let mut bonds = vec![Bond::Free; count];
        let mut along = Vec::new();
        for (number, curve) in reference.curves.iter().enumerate() {
            let number = number as u32;
            for (k, (from, to)) in reference.chain(number).into_iter().enumerate() {
                along.push((edge_key([from, to]), number));
                bonds[from as usize] = Bond::Curve { curve: number, at: curve.at[k] };
            }
        }
        along.sort_unstable();
        for v in 0..count as u32 {
            if reference.corner[v as usize] {
                bonds[v as usize] = Bond::Fixed(v);
            }
        }
        let places: Vec<NodeLocation> =
            (0..count as u32).map(|v| NodeLocation { spot: reference.spot_of(v), bond: bonds[v as usize] }).collect();
        let mut net = Self {
            reference,
            places: Vec::new(),
            positions: Vec::new(),
            normals: Vec::new(),
            topology: reference.topology.clone(),
            along,
            size,
            sizes: Vec::new(),
        };
        places.into_iter().for_each(|place| net.push(place));
        net
    }

    fn push(&mut self, place: NodeLocation) {
        self.places.push(place);
        self.positions.push(self.reference.point(place.spot));
        self.normals.push(self.reference.normal(place.spot));
        self.sizes.push(self.size.at(self.reference.curvature(place.spot)));
    }

    pub fn put(&mut self, v: u32, place: NodeLocation) {
        let v = v as usize;
        self.places[v] = place;
        self.positions[v] = self.reference.point(place.spot);
        self.normals[v] = self.reference.normal(place.spot);
        self.sizes[v] = self.size.at(self.reference.curvature(place.spot));
    }

    /// Moves every node to its new place.
    pub fn put_all(&mut self, places: &[NodeLocation]) {
        for (v, &place) in places.iter().enumerate() {
            self.put(v as u32, place);
        }
    }

    fn is_free(&self, v: u32) -> bool {
        self.places[v as usize].bond == Bond::Free
    }

    /// The curve that an edge runs along.
    pub fn curve_of(&self, a: u32, b: u32) -> Option<u32> {
        if self.is_free(a) || self.is_free(b) {
            return None;
        }
        self.along.binary_search_by_key(&edge_key([a, b]), |edge| edge.0).ok().map(|k| self.along[k].1)
    }

    pub fn length(&self, h: u32) -> f64 {
        self.positions[self.topology.from(h) as usize].distance(self.positions[self.topology.to(h) as usize])
    }

    fn size_at(&self, h: u32) -> f64 {
        0.5 * (self.sizes[self.topology.from(h) as usize] + self.sizes[self.topology.to(h) as usize])
    }

    /// Whether the normal of a triangle with these corners agrees with the surface's normals, and the triangle is not
    /// too thin.
    fn is_upright(&self, corners: [DVec3; 3], normals: [DVec3; 3]) -> bool {
        let normal = double_area_vector(corners);
        let mean: DVec3 = normals.iter().sum();
        normal.dot(mean) > REMESHING.upright * normal.length() * mean.length()
            && normal.length() > REMESHING.thinnest * longest_squared(corners)
    }

    fn triangle_is_upright(&self, triangle: [u32; 3]) -> bool {
        self.is_upright(triangle.map(|v| self.positions[v as usize]), triangle.map(|v| self.normals[v as usize]))
    }

    /// Returns the place half way between two nodes, measured along the curve if they are neighbours on a curve.
    /// Returns `None` if no walk finds such a place.
    fn middle(&self, a: u32, b: u32) -> Option<NodeLocation> {
        let [p, q] = [a, b].map(|v| self.positions[v as usize]);
        let [from, to] = [a, b].map(|v| self.places[v as usize]);
        if let Some(curve) = self.curve_of(a, b) {
            let other = self.reference.at(curve, to.bond, None);
            let near = self.reference.at(curve, from.bond, other)?;
            let other = self.reference.at(curve, to.bond, Some(near))?;
            let at = 0.5 * (near + other);
            return Some(NodeLocation { spot: self.reference.on_curve(curve, at), bond: Bond::Curve { curve, at } });
        }
        let length = p.distance(q);
        for (start, from, to) in [(from, p, q), (to, q, p)] {
            for start in self.reference.sides(start.spot) {
                let normal = self.reference.facet_normal(start);
                let direction = (to - from).reject_from_normalized(normal).normalize_or_zero();
                let spot = self.reference.walk(start, direction * (0.5 * length));
                let spot = self.reference.foot(spot, (from + to) / 2.0);
                let point = self.reference.point(spot);
                if point.distance(from).max(point.distance(to)) < 0.8 * length {
                    return Some(NodeLocation { spot, bond: Bond::Free });
                }
            }
        }
        None
    }

    /// Splits the edges that are too long, longest first, at most one of each triangle. Returns their number.
    fn split(&mut self) -> usize {
        let edges = self.topology.ranked_edges(|h| self.length(h) / (REMESHING.long * self.size_at(h)));
        self.split_edges(&edges)
    }

    /// Splits these edges, at most one of each triangle. Returns the number of split edges.
    pub fn split_edges(&mut self, edges: &[u32]) -> usize {
        let mut pass =
            Pass { net: self, to: Meeting::Middle, long: f64::INFINITY, on_curves: Vec::new(), gone: Vec::new() };
        let count = passes::split_edges(&mut pass, edges.iter().copied());
        let on_curves = pass.on_curves;
        let mut split: Vec<[u32; 2]> = on_curves.iter().map(|edge| edge.0).collect();
        split.sort_unstable();
        self.along.retain(|edge| split.binary_search(&edge.0).is_err());
        for ([a, b], middle, curve) in on_curves {
            self.along.extend([(edge_key([a, middle]), curve), (edge_key([b, middle]), curve)]);
        }
        self.along.sort_unstable();
        count
    }

    /// Collapses the edges that are too short, shortest first, whose neighbourhoods do not touch. Returns their number.
    fn collapse(&mut self, to: Meeting) -> usize {
        let edges =
            self.topology.ranked_edges(|h| REMESHING.short * self.size_at(h) / self.length(h).max(f64::MIN_POSITIVE));
        self.collapse_edges(&edges, to, REMESHING.long)
    }

    /// Collapses these edges where no edge becomes longer than `long` sizes. Returns the number of collapsed edges.
    pub fn collapse_edges(&mut self, edges: &[u32], to: Meeting, long: f64) -> usize {
        let gone = vec![None; self.places.len()];
        let mut pass = Pass { net: self, to, long, on_curves: Vec::new(), gone };
        let count = passes::collapse_edges(&mut pass, edges.iter().copied());
        let gone = pass.gone;
        if count == 0 {
            return 0;
        }
        let closed = self.topology.without_gaps(|v| gone[v].is_none());
        let (topology, left) = closed.expect("the link condition keeps a manifold");
        self.topology = topology;
        self.places = left.of(&self.places);
        self.positions = left.of(&self.positions);
        self.normals = left.of(&self.normals);
        self.sizes = left.of(&self.sizes);
        for (edge, _) in &mut self.along {
            *edge = edge_key(edge.map(|v| left.number(gone[v as usize].unwrap_or(v))));
        }
        self.along.retain(|([a, b], _)| a != b);
        self.along.sort_unstable();
        count
    }

    /// Whether an edge may flip: the edge does not run along a curve, and the two new triangles are upright.
    pub fn can_flip(&self, h: u32) -> bool {
        let Some([a, b, c, d]) = self.topology.hinge(h) else { return false };
        self.curve_of(a, b).is_none()
            && self.topology.can_flip(h)
            && self.triangle_is_upright([d, c, a])
            && self.triangle_is_upright([c, d, b])
    }

    /// Flips every edge whose opposite angles add up to more than 180°, where that keeps the triangles upright.
    ///
    /// # Errors
    /// The interruption. The net is valid in that case too.
    pub fn flip_to_delaunay(&mut self, execution: &Execution<'_>) -> Result<(), Interruption> {
        let wants = |net: &Self, h: u32| {
            net.topology.hinge(h).is_some_and(|hinge| {
                let [a, b, c, d] = hinge.map(|v| net.positions[v as usize]);
                let angle = |at: DVec3| measure::angle(a - at, b - at);
                angle(c) + angle(d) > std::f64::consts::PI + REMESHING.flat && net.can_flip(h)
            })
        };
        flip_where(self, wants, execution).map(|_| ())
    }

    /// Moves every free node towards the area-weighted mean of the centres of its triangles, and every node on a curve
    /// to the middle between its two neighbours on the curve.
    pub fn relax(&mut self, sweeps: usize) {
        for _ in 0..sweeps {
            for v in 0..self.places.len() as u32 {
                match self.places[v as usize].bond {
                    Bond::Free => relax(self, v),
                    Bond::Curve { curve, at } => self.relax_on_curve(v, curve, at),
                    Bond::Fixed(_) => {}
                }
            }
        }
    }

    fn relax_on_curve(&mut self, v: u32, curve: u32, at: f64) {
        let neighbours: Vec<f64> = self
            .topology
            .neighbours(v)
            .filter(|&w| self.curve_of(v, w) == Some(curve))
            .filter_map(|w| self.reference.at(curve, self.places[w as usize].bond, Some(at)))
            .collect();
        let &[low, high] = &neighbours[..] else { return };
        let before = self.places[v as usize];
        let at = 0.5 * (low + high);
        self.put(v, NodeLocation { spot: self.reference.on_curve(curve, at), bond: Bond::Curve { curve, at } });
        if !self.star_is_upright(v) {
            self.put(v, before);
        }
    }

    pub fn star_is_upright(&self, v: u32) -> bool {
        self.topology
            .outgoing_half_edges(v)
            .all(|h| self.triangle_is_upright(self.topology.triangles()[h as usize / 3]))
    }

    /// Numbers the nodes: corners, then nodes on the boundary, then those on creases, then the free ones.
    pub fn sort(&mut self) {
        let rank = |v: u32| match self.places[v as usize].bond {
            Bond::Fixed(corner) => (0, corner),
            Bond::Curve { .. } if self.topology.is_boundary(v) => (1, v),
            Bond::Curve { .. } => (2, v),
            Bond::Free => (3, v),
        };
        let mut order: Vec<u32> = (0..self.places.len() as u32).collect();
        order.sort_by_key(|&v| rank(v));
        let mut place = vec![0u32; order.len()];
        for (new, &old) in order.iter().enumerate() {
            place[old as usize] = new as u32;
        }
        let old = |k: usize| order[k] as usize;
        self.positions = (0..order.len()).map(|k| self.positions[old(k)]).collect();
        self.normals = (0..order.len()).map(|k| self.normals[old(k)]).collect();
        self.sizes = (0..order.len()).map(|k| self.sizes[old(k)]).collect();
        self.places = (0..order.len()).map(|k| self.places[old(k)]).collect();
        for (edge, _) in &mut self.along {
            let [a, b] = edge.map(|v| place[v as usize]);
            *edge = edge_key([a, b]);
        }
        self.along.sort_unstable();
        self.topology = self.topology.clone().renumbered(&place);
    }

    /// Remeshes until every edge is near the target length at its place.
    ///
    /// # Errors
    /// The interruption. The net is valid then, but its edges may be far from their target lengths.
    pub fn remesh(&mut self, execution: &Execution<'_>) -> Result<(), Interruption> {
        for pass in 0..REMESHING.coarsening_passes {
            execution.look(4 * self.places.len() as u64)?;
            let before = self.places.len() as f64;
            let removed = self.collapse(Meeting::End) as f64;
            self.flip_to_delaunay(execution)?;
            if pass % 2 == 1 {
                self.relax(1);
            }
            if removed < REMESHING.coarsened * before {
                break;
            }
        }
        for _ in 0..REMESHING.rounds {
            execution.look(WORK_PER_TRIANGLE * self.topology.triangles().len() as u64)?;
            self.split();
            self.collapse(Meeting::Middle);
            self.flip_to_delaunay(execution)?;
            self.relax(REMESHING.sweeps);
            self.flip_to_delaunay(execution)?;
        }
        Ok(())
    }
}

impl Connected for Net<'_> {
    fn topology(&self) -> &Topology {
        &self.topology
    }

    fn topology_mut(&mut self) -> &mut Topology {
        &mut self.topology
    }
}

impl Relaxed for Net<'_> {
    fn position(&self, v: u32) -> DVec3 {
        self.positions[v as usize]
    }

    fn normal(&self, v: u32) -> Option<DVec3> {
        Some(self.normals[v as usize])
    }

    /// Half the distance to the nearest neighbour.
    fn longest_step(&self, v: u32) -> f64 {
        let here = self.positions[v as usize];
        let distances = self.topology.neighbours(v).map(|w| self.positions[w as usize].distance(here));
        0.5 * distances.fold(f64::INFINITY, f64::min)
    }

    fn try_step(&mut self, v: u32, step: DVec3) -> bool {
        let before = self.places[v as usize];
        let spot = self.reference.walk(before.spot, step);
        self.put(v, NodeLocation { spot, bond: Bond::Free });
        let keeps = self.star_is_upright(v);
        if !keeps {
            self.put(v, before);
        }
        keeps
    }
}

/// A pass of splits or of collapses over a net.
struct Pass<'n, 'a> {
    net: &'n mut Net<'a>,
    /// The place at which two nodes meet that both may move.
    to: Meeting,
    /// No collapse makes an edge longer than this multiple of the size.
    long: f64,
    /// The edges along curves that were split, each with its new node and its curve.
    on_curves: Vec<([u32; 2], u32, u32)>,
    /// For each node the node that it was merged into.
    gone: Vec<Option<u32>>,
}

impl Pass<'_, '_> {
    /// Whether the triangles at `v` that do not contain `other` stay upright and are not too flat, and their edges stay
    /// short enough, when `v` moves to `point`.
    fn may_move(&self, v: u32, other: u32, point: DVec3, normal: DVec3) -> bool {
        let Self { net, long, .. } = self;
        let topology = &net.topology;
        topology.outgoing_half_edges(v).all(|h| {
            let (j, k) = (topology.to(h), topology.opposite(h));
            if j == other || k == other {
                return true;
            }
            let [p, q] = [j, k].map(|v| net.positions[v as usize]);
            let [m, n] = [j, k].map(|v| net.normals[v as usize]);
            let size = 0.5 * (net.sizes[v as usize] + net.sizes[j as usize]);
            let area = double_area_vector([point, p, q]).length();
            net.is_upright([point, p, q], [normal, m, n])
                && area > 0.05 * p.distance_squared(q).max(point.distance_squared(p))
                && point.distance(p).max(point.distance(q)) < long * size
        })
    }
}

impl Connected for Pass<'_, '_> {
    fn topology(&self) -> &Topology {
        &self.net.topology
    }

    fn topology_mut(&mut self) -> &mut Topology {
        &mut self.net.topology
    }
}

impl Surface for Pass<'_, '_> {
    type Place = NodeLocation;

    /// An edge is not split if one of the new triangles would not be upright.
    fn add_middle(&mut self, h: u32) -> Option<u32> {
        let net = &mut *self.net;
        let (a, b) = (net.topology.from(h), net.topology.to(h));
        let place = net.middle(a, b)?;
        let (point, normal) = (net.reference.point(place.spot), net.reference.normal(place.spot));
        let fits = |half: u32| {
            let corners = [net.topology.from(half), net.topology.to(half), net.topology.opposite(half)];
            let [from, to, apex] = corners.map(|v| net.positions[v as usize]);
            let [from_normal, to_normal, apex_normal] = corners.map(|v| net.normals[v as usize]);
            net.is_upright([from, point, apex], [from_normal, normal, apex_normal])
                && net.is_upright([point, to, apex], [normal, to_normal, apex_normal])
        };
        if ![h, net.topology.twin[h as usize]].into_iter().filter(|&half| half != NONE).all(fits) {
            return None;
        }
        let middle = net.places.len() as u32;
        if let Some(curve) = net.curve_of(a, b) {
            self.on_curves.push((edge_key([a, b]), middle, curve));
        }
        net.push(place);
        Some(middle)
    }

    /// A free node is merged into a node on a curve, and a node on a curve into a corner. Two free nodes, and two nodes
    /// of one curve, meet where [`Meeting`] says.
    fn planned_collapse(&self, h: u32) -> Option<Collapse<NodeLocation>> {
        let net = &*self.net;
        let (a, b) = (net.topology.from(h), net.topology.to(h));
        let curve = net.curve_of(a, b);
        let middle = || if self.to == Meeting::Middle { net.middle(a, b) } else { None };
        let [place_a, place_b] = [a, b].map(|v| net.places[v as usize]);
        let (leaves, stays, place) = match ([place_a.bond, place_b.bond], curve) {
            ([Bond::Free, Bond::Free], _) | ([Bond::Curve { .. }, Bond::Curve { .. }], Some(_)) => {
                (a, b, middle().unwrap_or(place_b))
            }
            ([Bond::Free, _], _) | ([Bond::Curve { .. }, Bond::Fixed(_)], Some(_)) => (a, b, place_b),
            ([_, Bond::Free], _) | ([Bond::Fixed(_), Bond::Curve { .. }], Some(_)) => (b, a, place_a),
            _ => return None,
        };
        let moves = place != net.places[stays as usize];
        Some(Collapse { leaves, stays, place, moves })
    }

    fn keeps_shape(&self, &Collapse { leaves, stays, place, moves }: &Collapse<NodeLocation>) -> bool {
        let (point, normal) = (self.net.reference.point(place.spot), self.net.reference.normal(place.spot));
        let keeps = |v: u32, other: u32| self.may_move(v, other, point, normal);
        keeps(leaves, stays) && (!moves || keeps(stays, leaves))
    }

    fn merge(&mut self, Collapse { leaves, stays, place, .. }: Collapse<NodeLocation>) {
        self.gone[leaves as usize] = Some(stays);
        self.net.put(stays, place);
    }
}
