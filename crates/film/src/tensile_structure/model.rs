//! The mesh of a tensile structure: the triangles of its layers, the vertices of its cables, and what each vertex may
//! do.

use super::catenary::{self, Catenary};
use super::options::{
    BoundaryPoint, Cable, CableMode, Course, FilmStress, Options, Pressure, Sliding, SlidingPart, Structure,
    chamber_place,
};
use super::weave::{StressField, pulls_along};
use crate::energy;
use crate::energy::cable::{self, CableCondition, Equation, Law};
use crate::energy::{Load, Term, Volume, Weight};
use crate::equilibrium::{Body, Constraint, Contact, Determined, Freedom, Support};
use crate::minimal_surface::{self, Constraints, Method};
use plateau_mesh::codes::Reason;
use plateau_mesh::complex::Complex;
use plateau_mesh::error::Warning;
use plateau_mesh::film::Film;
use plateau_mesh::measure;
use plateau_mesh::sparse::LinearError;
use plateau_mesh::{DVec3, Error, Execution, Mesh, Place, polyline};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Fewest segments of a heavy cable in the air.
const LEAST_AIR_SEGMENTS: f64 = 16.0;
/// Largest distance of a vertex from the segment of a cable across the film, as a fraction of the segment's length.
const ON_SEGMENT: f64 = 1e-9;
/// Most segments of a heavy cable in the air. More would not show in the shape of a catenary.
const MOST_AIR_SEGMENTS: f64 = 1000.0;

/// A structure as a mesh. Positions are relative to the mean of the boundaries' points.
#[derive(Clone, Debug)]
pub(super) struct Model {
    pub centre: DVec3,
    pub layers: Vec<Layer>,
    /// Number of vertices of all layers.
    pub films: usize,
    /// Vertices of cables in the air, numbered after those of the layers.
    pub air: Vec<DVec3>,
    /// For each vertex in the air whether it is a support.
    pub air_fixed: Vec<bool>,
    /// Number of joints and hubs, which are the first vertices in the air.
    joined: usize,
    /// The rings that move, in the order of the input.
    pub rings: Vec<MovingRing>,
    /// For each cable its vertices from the first end to the last.
    pub chains: Vec<Vec<u32>>,
    /// The vertices of the free points.
    pub free: Vec<u32>,
    /// For each input point its vertex.
    pub input_vertices: Vec<Vec<u32>>,
    /// Signed volume between the origin and the fan of each boundary (the triangles from its edges to its mean). It is
    /// the part that the surface integral over the last layer lacks, because nothing closes the last layer below.
    pub cap_volume: f64,
    /// The surfaces on which vertices slide, and the freedom of each vertex that does.
    pub supports: Vec<Arc<dyn Support>>,
    pub sliding: Vec<(u32, Freedom)>,
    /// The energies of the edges that meet their surface at a given angle, and the vertices of these edges.
    pub contacts: Vec<Contact>,
    pub at_contacts: BTreeSet<u32>,
    pub cables: Vec<energy::Cable>,
    /// For each cable, the quantity that determines its force.
    pub forces_by: Vec<ForceBy>,
    /// The force of each cable with which form finding begins.
    pub start_forces: Vec<f64>,
    /// For each cable, the damping of the changes of that force.
    swings: Vec<Swing>,
    /// Mean length of the edges of the initial mesh.
    start_edge: f64,
    /// The stresses of a woven film.
    pub stress_field: Option<StressField>,
    /// For each cable and each of its segments, the force that the pull of a woven film along the cable adds; empty for
    /// other films and for cables in the air.
    pub further_forces: Vec<Vec<f64>>,
    pub warnings: Vec<Warning>,
}

/// A layer with its own mesh. All layers begin as copies of one mesh and share the vertices of their boundaries.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    /// The mesh of the layer, with its own vertex numbers.
    pub film: Film,
    /// For each vertex of the film its number in the model. The vertices of the first layer have the same number in
    /// both.
    pub numbers: Vec<u32>,
}

impl Layer {
    /// The triangles with the numbers of the model.
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        self.film.triangles().iter().map(|triangle| triangle.map(|v| self.numbers[v as usize]))
    }
}

/// A ring that moves along its axis as a whole.
#[derive(Clone, Debug)]
pub(super) struct MovingRing {
    pub axis: DVec3,
    /// The vertices of its boundary, then that of its hub.
    pub vertices: Vec<u32>,
}

/// The rule by which a renewal chooses the stresses of a woven film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Renewal {
    /// The stresses of the required ratio that come nearest to the balance of forces within the film.
    Balance,
    /// The present stresses.
    Keep,
    /// The required stresses, constant over the film.
    Required,
}

/// The purpose of a body, which decides how its cables act.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stage {
    /// The first rounds, far from the equilibrium. An elastic cable is a constraint that yields. A cable whose length
    /// is given, or whose force an equation determines, has the force densities and the loads of its present shape.
    Settling,
    /// The rounds on a mesh that stays. Every cable has the force densities and the loads of its present shape and of a
    /// force near the required one.
    Reference,
    /// The equilibrium itself.
    Exact,
}

/// The quantity that determines the force of a cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ForceBy {
    /// The law of its energy.
    Law,
    /// Its length, which is a constraint with the force as its multiplier.
    Length(f64),
    /// Its length, which yields to the force: the cable is elastic.
    Elastic {
        /// The length without force.
        unstressed: f64,
        /// EA.
        stiffness: f64,
    },
    /// An equation that replaces a given length in the constraint: the cable is heavy, or its sag or its horizontal
    /// component is given.
    Equation(Equation),
}

/// The options of the surface that the form finding starts from: one harmonic map.
pub(super) fn start_options(structure: &Structure, options: &Options) -> minimal_surface::Options {
    let across = structure.cables.iter().filter_map(|cable| match &cable.course {
        Course::Across(points) => Some(points.clone()),
        Course::Boundary { .. } | Course::Air(_) | Course::Mast(_) => None,
    });
    minimal_surface::Options {
        method: Method::Harmonic,
        constraints: Constraints { points: Vec::new(), polylines: across.collect() },
        ..minimal_surface::Options::new(options.resolution)
    }
}

impl Model {
    /// Meshes the boundaries and finds the vertices of the cables.
    /// The edges of the final mesh are `share` times as long as those of this one.
    pub fn build(structure: &Structure, options: &Options, share: f64, exec: &Execution) -> Result<Self, Error> {
        let all: Vec<DVec3> = structure.boundaries.iter().flatten().copied().collect();
        let centre = polyline::mean(&all);
        let centred: Vec<Vec<DVec3>> =
            structure.boundaries.iter().map(|points| points.iter().map(|&p| p - centre).collect()).collect();
        let mut start = start_options(structure, options);
        start.constraints.polylines.iter_mut().flatten().for_each(|point| *point -= centre);
        let surface = minimal_surface::solve(&centred, &start, exec)?;
        let mut across = surface.constraints.polylines.into_iter();
        let warnings = surface.warnings.into_iter().filter(|warning| warning.code == "merged_points").collect();
        // The numbers of the input's vertices count through all boundaries.
        let input_vertices = surface.input_vertices;
        let invalid = || Error::no_result(Reason::InvalidMesh, "the initial mesh is no oriented manifold");
        let lost = || Error::no_result(Reason::InvalidMesh, "a cable across the film has no edges in the initial mesh");
        let mut mesh = surface.mesh;
        if structure.layers.len() > 1 {
            split_chords(&mut mesh, &surface.boundaries);
        }
        let film = Film::new(mesh.vertices, &mesh.triangles, surface.boundaries).ok_or_else(invalid)?;
        let numbers = (0..film.vertices.len() as u32).collect();
        let mut model = Self {
            centre,
            films: film.vertices.len(),
            layers: vec![Layer { film, numbers }],
            air: Vec::new(),
            air_fixed: Vec::new(),
            joined: 0,
            rings: Vec::new(),
            chains: Vec::new(),
            free: Vec::new(),
            input_vertices,
            cap_volume: 0.0,
            supports: Vec::new(),
            sliding: Vec::new(),
            contacts: Vec::new(),
            at_contacts: BTreeSet::new(),
            cables: Vec::new(),
            forces_by: Vec::new(),
            start_forces: Vec::new(),
            swings: Vec::new(),
            start_edge: 0.0,
            stress_field: None,
            further_forces: vec![Vec::new(); structure.cables.len()],
            warnings,
        };
        for sliding in &structure.sliding {
            model.slide(sliding, structure.pull());
        }
        for _ in 1..structure.layers.len() {
            model.add_layer();
        }
        model.join(structure);
        model.cap_volume = model.caps();
        model.free = structure.free_points.iter().map(|&point| model.input_vertex(point)).collect();
        let edge = share * model.mean_edge();
        model.start_edge = edge;
        for cable in &structure.cables {
            let chain = match &cable.course {
                Course::Boundary { boundary, from, to } => model.along(*boundary, *from, *to),
                Course::Across(_) => model.across(&across.next().unwrap_or_default()).ok_or_else(lost)?,
                Course::Air(ends) | Course::Mast(ends) => model.through_the_air(structure, cable, *ends, edge),
            };
            model.chains.push(chain);
        }
        let vertices = model.vertices();
        for (cable, chain) in structure.cables.iter().zip(&model.chains) {
            let segments: Vec<[u32; 2]> = chain.windows(2).map(|pair| [pair[0], pair[1]]).collect();
            let ends = [chain[0], chain[chain.len() - 1]].map(|v| vertices[v as usize]);
            let held = |v: u32| (v as usize).checked_sub(model.films).is_some_and(|k| model.air_fixed[k]);
            let hangs_between_supports =
                matches!(cable.course, Course::Air(_)) && held(chain[0]) && held(chain[chain.len() - 1]);
            let (law, by) = match catenary::plumb_force(cable, ends, structure.up) {
                Some(Ok(force)) if hangs_between_supports => (Law::Force(force), ForceBy::Law),
                _ => law(cable),
            };
            model.start_forces.push(start_force(cable, structure, &segments, &vertices));
            model.swings.push(Swing::default());
            model.cables.push(energy::Cable::new(segments, law).heavy(cable.weight, structure.up));
            model.forces_by.push(by);
        }
        let film = &model.layers[0].film;
        model.stress_field =
            structure.weave().map(|weave| StressField::new(weave, centre, film.triangles(), film.vertices.len()));
        Ok(model)
    }

    /// Whether the length of a cable is given, exactly or by its stiffness.
    pub fn holds_length(&self, k: usize) -> bool {
        matches!(self.forces_by[k], ForceBy::Length(_) | ForceBy::Elastic { .. })
    }

    /// Whether the length of a cable is a constraint already in [`Stage::Settling`].
    pub fn constrains_length(&self, k: usize) -> bool {
        match self.forces_by[k] {
            ForceBy::Length(_) => self.cables[k].segments.len() <= 1,
            ForceBy::Elastic { .. } => true,
            ForceBy::Law | ForceBy::Equation(_) => false,
        }
    }

    /// The points of the boundaries at which cables end but through which no cable passes, without those of edges that
    /// slide; each as its vertex, the index of its boundary and its index among the points of that boundary.
    pub fn corners(&self) -> Vec<(u32, usize, usize)> {
        let mut moves = vec![false; self.films];
        for chain in &self.chains {
            for &v in chain.iter().filter(|&&v| (v as usize) < self.films) {
                moves[v as usize] = true;
            }
        }
        let inner: BTreeSet<u32> =
            self.chains.iter().flat_map(|chain| chain.get(1..chain.len() - 1).unwrap_or_default()).copied().collect();
        let slides =
            |v: u32| self.sliding.iter().any(|(own, freedom)| *own == v && matches!(freedom, Freedom::AcrossOn { .. }));
        let corner = |v: u32| moves[v as usize] && !inner.contains(&v) && !slides(v);
        let of = |(boundary, points): (usize, &Vec<u32>)| {
            let one = |(point, &v): (usize, &u32)| corner(v).then_some((v, boundary, point));
            points.iter().enumerate().filter_map(one).collect::<Vec<_>>()
        };
        self.input_vertices.iter().enumerate().flat_map(of).collect()
    }

    pub fn input_vertex(&self, BoundaryPoint { boundary, point }: BoundaryPoint) -> u32 {
        self.input_vertices[boundary][point]
    }

    /// Lets a cable bear no force.
    pub fn let_go(&mut self, k: usize) {
        self.forces_by[k] = ForceBy::Law;
        self.cables[k].law = Law::Force(0.0);
    }

    pub fn is_let_go(&self, k: usize) -> bool {
        self.forces_by[k] == ForceBy::Law && self.cables[k].law == Law::Force(0.0)
    }

    /// Adds a copy of the first layer that shares the vertices of the boundaries and has inner vertices of its own.
    fn add_layer(&mut self) {
        let film = self.layers[0].film.clone();
        let mut on_boundary = vec![false; film.vertices.len()];
        film.boundaries.iter().flatten().for_each(|&v| on_boundary[v as usize] = true);
        let mut numbers = Vec::with_capacity(film.vertices.len());
        for (v, on_boundary) in on_boundary.into_iter().enumerate() {
            numbers.push(if on_boundary { v } else { self.films } as u32);
            self.films += usize::from(!on_boundary);
        }
        self.layers.push(Layer { film, numbers });
    }

    /// All vertices: those of the layers, then those in the air.
    pub fn vertices(&self) -> Vec<DVec3> {
        let mut vertices = vec![DVec3::ZERO; self.films];
        for layer in &self.layers {
            layer.numbers.iter().zip(&layer.film.vertices).for_each(|(&v, &place)| vertices[v as usize] = place);
        }
        vertices.extend(&self.air);
        vertices
    }

    pub fn set_vertices(&mut self, vertices: &[DVec3]) {
        for layer in &mut self.layers {
            layer.numbers.iter().zip(&mut layer.film.vertices).for_each(|(&v, own)| *own = vertices[v as usize]);
        }
        self.air.copy_from_slice(&vertices[self.films..]);
    }

    /// The triangles of all layers, one layer after the other.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        self.layers.iter().flat_map(Layer::triangles).collect()
    }

    /// The mesh of all layers, without the vertices in the air.
    pub fn mesh(&self) -> Mesh {
        let mut vertices = self.vertices();
        vertices.truncate(self.films);
        Mesh::new(vertices, self.triangles())
    }

    /// For each vertex whether the edge of a film or a support in the air holds it at the start.
    pub fn fixed(&self) -> Vec<bool> {
        let mut fixed = vec![false; self.films];
        for layer in &self.layers {
            layer.numbers.iter().zip(&layer.film.fixed).for_each(|(&v, &own)| fixed[v as usize] = own);
        }
        fixed.extend(&self.air_fixed);
        fixed
    }

    /// The vertices of the boundaries, each as a loop.
    pub fn boundaries(&self) -> &[Vec<u32>] {
        &self.layers[0].film.boundaries
    }

    pub fn mean_edge(&self) -> f64 {
        let (triangles, at) = (self.triangles(), self.vertices());
        let sum: f64 = triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| at[a as usize].distance(at[b as usize]))
            .sum();
        sum / (3 * triangles.len()) as f64
    }

    fn along(&self, boundary: usize, from: usize, to: usize) -> Vec<u32> {
        let rim = &self.boundaries()[boundary];
        let vertex = |point: usize| self.input_vertices[boundary][point];
        let place = |v: u32| rim.iter().position(|&w| w == v).expect("an input point is a vertex of its boundary");
        let (first, last) = (place(vertex(from)), place(vertex(to)));
        let count = (last + rim.len() - first) % rim.len();
        (0..=count).map(|k| rim[(first + k) % rim.len()]).collect()
    }

    /// The vertices of a cable across the film from its first point to its last, with those that meshing added in
    /// between; `None` if no edges connect its points. Locks these edges and fixes these vertices. The film has only
    /// one layer then.
    fn across(&mut self, points: &[u32]) -> Option<Vec<u32>> {
        let film = &mut self.layers[0].film;
        let mut chain = vec![*points.first()?];
        for pair in points.windows(2) {
            let (mut here, end) = (pair[0], pair[1]);
            let at = |v: u32| film.vertices[v as usize];
            let span = at(end) - at(here);
            let (start, direction) = (at(here), span.normalize_or_zero());
            // At most one pass per vertex, because each vertex lies further along the segment than the one before.
            while here != end {
                // The next vertex on the segment: the nearest neighbour ahead that lies on it.
                let ahead = |v: &u32| {
                    let place = at(*v) - start;
                    place.dot(direction) > (at(here) - start).dot(direction)
                        && place.reject_from_normalized(direction).length() <= ON_SEGMENT * span.length()
                };
                let nearer = |a: &u32, b: &u32| at(*a).distance(at(here)).total_cmp(&at(*b).distance(at(here)));
                here = film.topology.neighbours(here).filter(ahead).min_by(nearer)?;
                chain.push(here);
            }
        }
        for pair in chain.windows(2) {
            film.locked.push([pair[0].min(pair[1]), pair[0].max(pair[1])]);
        }
        film.locked.sort_unstable();
        chain.iter().for_each(|&v| film.fixed[v as usize] = true);
        (chain.len() > 1).then_some(chain)
    }

    /// Makes the rings that move and the vertices of hubs and joints.
    fn join(&mut self, structure: &Structure) {
        for ring in &structure.rings {
            let mut vertices = self.boundaries()[ring.boundary].clone();
            vertices.extend(ring.hub.map(|hub| self.add_to_air(hub)));
            self.rings.push(MovingRing { axis: ring.axis, vertices });
        }
        for &joint in &structure.joints {
            self.add_to_air(joint);
        }
        self.joined = self.air.len();
    }

    /// Adds a vertex in the air that no support holds.
    fn add_to_air(&mut self, point: DVec3) -> u32 {
        self.air.push(point - self.centre);
        self.air_fixed.push(false);
        (self.films + self.air.len() - 1) as u32
    }

    fn through_the_air(&mut self, structure: &Structure, cable: &Cable, ends: [DVec3; 2], edge: f64) -> Vec<u32> {
        let mut joined = |end: DVec3| {
            for (boundary, points) in structure.boundaries.iter().enumerate() {
                if let Some(point) = points.iter().position(|p| *p == end) {
                    return self.input_vertices[boundary][point];
                }
            }
            let place = end - self.centre;
            let count = self.films;
            let may_join = |k: usize| k < self.joined || self.air_fixed[k];
            if let Some(k) = (0..self.air.len()).find(|&k| may_join(k) && self.air[k] == place) {
                return (count + k) as u32;
            }
            self.air.push(place);
            self.air_fixed.push(true);
            (count + self.air.len() - 1) as u32
        };
        let [first, last] = ends.map(&mut joined);
        let straight = ends[0].distance(ends[1]);
        let pieces = if cable.weight > 0.0 {
            (straight / edge).ceil().clamp(LEAST_AIR_SEGMENTS, MOST_AIR_SEGMENTS) as usize
        } else {
            1
        };
        let mut chain = vec![first];
        for k in 1..pieces {
            let share = k as f64 / pieces as f64;
            // Without a catenary the cable starts with a sag of a tenth of its chord, so that it has a curvature.
            let sag = 0.4 * straight * share * (1.0 - share) * structure.up;
            chain.push((self.films + self.air.len()) as u32);
            self.air.push(ends[0] - self.centre + share * (ends[1] - ends[0]) - sag);
            self.air_fixed.push(false);
        }
        chain.push(last);
        chain
    }

    /// The catenary of a heavy cable in the air between its present ends.
    fn catenary(&self, structure: &Structure, k: usize, at: &[DVec3]) -> Option<Catenary> {
        let (cable, chain) = (&structure.cables[k], &self.chains[k]);
        if !matches!(cable.course, Course::Air(_)) {
            return None;
        }
        let ends = [chain[0], chain[chain.len() - 1]].map(|v| at[v as usize]);
        Catenary::find(cable, ends, structure.up).ok().flatten()
    }

    /// Hangs the heavy cables in the air in the catenaries between their present ends.
    pub fn hang(&mut self, structure: &Structure) {
        let at = self.vertices();
        let count = self.films;
        for k in 0..self.chains.len() {
            let Some(catenary) = self.catenary(structure, k, &at) else { continue };
            let (chain, length) = (&self.chains[k], catenary.length());
            for (i, &v) in chain.iter().enumerate().take(chain.len() - 1).skip(1) {
                let from_first = length * i as f64 / (chain.len() - 1) as f64;
                self.air[v as usize - count] = catenary.point(from_first);
            }
        }
    }

    /// Computes the start forces that follow from the shape anew from the present shape. Because the shape depends on
    /// these forces in turn, they may oscillate; their changes are damped therefore.
    pub fn renew_start_forces(&mut self, structure: &Structure) {
        let at = self.vertices();
        for (k, cable) in structure.cables.iter().enumerate() {
            let term = &self.cables[k];
            let force = self.start_forces[k];
            // A shallow cable's sag is inversely proportional to its force, and the horizontal component of a force is
            // proportional to it.
            let wanted = match cable.mode {
                CableMode::Sag(sag) => force * (term.sag(&at) / sag).clamp(0.25, 4.0),
                CableMode::HorizontalComponent(wanted) => {
                    let ratio = wanted / (force * term.level_part(&at).max(LEAST_ACROSS));
                    force * ratio.clamp(0.25, 4.0)
                }
                CableMode::Length(_) => {
                    start_force(cable, structure, &term.segments, &at).clamp(0.5 * force, 2.0 * force)
                }
                _ => start_force(cable, structure, &term.segments, &at),
            };
            self.start_forces[k] += self.swings[k].damped(wanted - force);
        }
    }

    /// Lets a part of the boundary slide on a surface and moves its vertices onto it. `tension` is the film's tension,
    /// which the energy of an edge with a contact angle needs.
    fn slide(&mut self, sliding: &Sliding, tension: f64) {
        let number = self.supports.len() as u32;
        let on = sliding.on.moved(-self.centre);
        self.supports.push(on.clone());
        let (vertices, closed): (Vec<u32>, bool) = match sliding.part {
            SlidingPart::Point(point) => {
                let v = self.input_vertex(point);
                let vertex = &mut self.layers[0].film.vertices[v as usize];
                *vertex = on.nearest(*vertex);
                self.sliding.push((v, Freedom::On(number)));
                return;
            }
            SlidingPart::Edge { boundary, from, to } => (self.along(boundary, from, to), false),
            SlidingPart::Boundary(boundary) => (self.boundaries()[boundary].clone(), true),
        };
        let count = vertices.len();
        let inner = if closed { 0..count } else { 1..count - 1 };
        for k in inner {
            let v = vertices[k];
            let vertex = &mut self.layers[0].film.vertices[v as usize];
            *vertex = on.nearest(*vertex);
            let beside = [vertices[(k + count - 1) % count], vertices[(k + 1) % count]];
            self.sliding.push((v, Freedom::AcrossOn { support: number, beside }));
        }
        if let Some(angle) = sliding.contact_angle {
            let at = &self.layers[0].film.vertices;
            self.contacts.extend(Contact::new(&vertices, closed, &*on, tension, angle, at));
            self.at_contacts.extend(&vertices);
        }
    }

    fn caps(&self) -> f64 {
        let mut sixfold = 0.0;
        let film = &self.layers[0].film;
        for rim in film.topology.boundary_loops() {
            let points: Vec<DVec3> = rim.iter().map(|&v| film.vertices[v as usize]).collect();
            let mean = polyline::mean(&points);
            for k in 0..points.len() {
                sixfold += mean.dot(points[(k + 1) % points.len()].cross(points[k]));
            }
        }
        sixfold / 6.0
    }

    /// The triangles of the layers around the space below a layer, oriented so that their normals point out of it.
    pub fn walls(&self, below: usize) -> Vec<[u32; 3]> {
        let mut walls: Vec<[u32; 3]> = self.layers[below].triangles().collect();
        if let Some(next) = self.layers.get(below + 1) {
            walls.extend(next.triangles().map(|[a, b, c]| [a, c, b]));
        }
        walls
    }

    /// The volume to add to the surface integral over the [`walls`](Self::walls) of the space below a layer: that space
    /// is open below the last layer.
    fn cap(&self, below: usize) -> f64 {
        if below + 1 == self.layers.len() { self.cap_volume } else { 0.0 }
    }

    /// The volume below a layer: up to the next one, or up to fans from each boundary to its mean.
    pub fn volume(&self, below: usize, vertices: &[DVec3]) -> f64 {
        Volume { triangles: self.walls(below), pressure: -1.0 }.value(vertices) + self.cap(below)
    }

    /// The body with the terms of the structure, first those of the layers. `grown` is the fraction of the given
    /// volumes that the chambers have in this body.
    pub fn body(&self, structure: &Structure, grown: f64, stage: Stage) -> Result<Body, Error> {
        let invalid = |defect| Error::no_result(Reason::InvalidMesh, format!("the film's mesh is damaged: {defect}"));
        let complex =
            |layer: &Layer| Complex::build(layer.film.triangles().to_vec(), layer.film.vertices.len()).map_err(invalid);
        let first = complex(&self.layers[0])?;
        let tension = structure.layers[0].mean();
        let mut body = Body::new(self.vertices(), &first, &vec![tension; first.sheets.len()]);
        // All sheets have one tension or one field of stresses, so one term serves them all.
        body.terms.truncate(0);
        let triangles = self.layers[0].film.triangles();
        match &self.stress_field {
            None => body.terms.push(Box::new(energy::Area { triangles: triangles.to_vec(), tension })),
            Some(field) => body.terms.push(Box::new(field.prestress(triangles, &body.vertices))),
        }
        for (layer, film) in self.layers.iter().zip(&structure.layers).skip(1) {
            body.add_film(&complex(layer)?, &layer.numbers, film.mean());
        }
        for (k, &fixed) in self.air_fixed.iter().enumerate() {
            body.freedoms[self.films + k] = if fixed { Freedom::Fixed } else { Freedom::Free };
        }
        for (k, chain) in self.chains.iter().enumerate() {
            // Nothing but the film holds a slack cable across it.
            if self.is_let_go(k) && matches!(structure.cables[k].course, Course::Across(_)) {
                continue;
            }
            for three in chain.windows(3) {
                body.freedoms[three[1] as usize] = Freedom::Across([three[0], three[2]]);
            }
        }
        for &v in &self.free {
            body.freedoms[v as usize] = Freedom::Free;
        }
        for (group, ring) in self.rings.iter().enumerate() {
            body.groups.push(ring.axis);
            ring.vertices.iter().for_each(|&v| body.freedoms[v as usize] = Freedom::Together(group as u32));
        }
        if let Some(forces) = self.ring_forces(structure) {
            body.terms.push(Box::new(Load { forces }));
        }
        body.supports.clone_from(&self.supports);
        for &(v, freedom) in &self.sliding {
            body.freedoms[v as usize] = freedom;
        }
        for contact in &self.contacts {
            body.terms.push(Box::new(contact.clone()));
        }
        if structure.has_heavy_layers() {
            // The stress field alone determines the stresses of a woven film, so its weight is a load and changes no
            // stress.
            if self.stress_field.is_some() {
                body.terms.push(Box::new(Load { forces: self.film_loads(structure, &body.vertices) }));
            } else {
                for weight in self.weights(structure, &body.vertices) {
                    body.terms.push(Box::new(weight));
                }
            }
        }
        for (k, (cable, &by)) in self.cables.iter().zip(&self.forces_by).enumerate() {
            // A straight cable in the air has no other shape, so its length is a constraint from the start.
            let by_length = matches!(by, ForceBy::Length(_) | ForceBy::Elastic { .. });
            let at_start = match stage {
                // The length of a straight chain has no gradient across it, so it cannot be a constraint yet.
                Stage::Settling => match by {
                    ForceBy::Equation(_) => true,
                    ForceBy::Length(_) => cable.segments.len() > 1,
                    ForceBy::Law | ForceBy::Elastic { .. } => false,
                },
                Stage::Reference => !(by_length && cable.segments.len() == 1),
                Stage::Exact => false,
            };
            if at_start {
                self.add_start(&mut body, structure, k);
                continue;
            }
            body.terms.push(Box::new(cable.clone()));
            for (&segment, &tension) in cable.segments.iter().zip(&self.further_forces[k]) {
                body.terms.push(Box::new(energy::Length { segments: vec![segment], tension }));
            }
            // With the tension -1 the multiplier is the force.
            let quantity = || Box::new(energy::Length { segments: cable.segments.clone(), tension: -1.0 });
            match by {
                ForceBy::Law => {}
                ForceBy::Length(length) => body.constraints.push(Constraint::value(quantity(), -length)),
                ForceBy::Elastic { unstressed, stiffness } => {
                    let by = Determined::Yielding { value: -unstressed, compliance: unstressed / stiffness };
                    body.constraints.push(Constraint { quantity: quantity(), by });
                }
                ForceBy::Equation(equation) => {
                    let by = Determined::Condition(Box::new(CableCondition { cable: cable.clone(), equation }));
                    body.constraints.push(Constraint { quantity: quantity(), by });
                }
            }
        }
        let before = body.constraints.len();
        let mut by_volume = Vec::new();
        for (k, chamber) in structure.chambers.iter().enumerate() {
            let triangles = self.walls(chamber.below);
            match chamber.holds {
                Pressure::Volume(volume) => {
                    let quantity = Box::new(Volume { triangles, pressure: -1.0 });
                    let value = volume * grown - self.cap(chamber.below);
                    body.constraints.push(Constraint::value(quantity, value));
                    by_volume.push(k);
                }
                Pressure::Constant(pressure) => body.terms.push(Box::new(Volume { triangles, pressure })),
            }
        }
        body.check().map_err(|defect| match defect {
            crate::equilibrium::BodyDefect::Target(constraint) => Error::input(
                constraint
                    .checked_sub(before)
                    .map_or(Place::field("cables"), |k| chamber_place(structure, by_volume[k])),
                "cannot be told from an empty one; move the boundaries or change it",
            ),
            other => Error::no_result(Reason::InvalidMesh, other.to_string()),
        })?;
        Ok(body)
    }

    /// Adds a cable to the body with its start force in place of the condition that determines its force.
    fn add_start(&self, body: &mut Body, structure: &Structure, k: usize) {
        let cable = &self.cables[k];
        if self.forces_by[k] == ForceBy::Law {
            body.terms.push(Box::new(cable.clone()));
            return;
        }
        let force = self.start_forces[k];
        if cable.weight == 0.0 {
            body.terms.push(Box::new(energy::Length { segments: cable.segments.clone(), tension: force }));
            return;
        }
        // The own energy of a heavy cable has no minimum as long as its force is too small for its sag.
        let at = &body.vertices;
        let catenary = self.catenary(structure, k, at);
        let mean = cable.weight * cable.mean_height(at);
        let mut loads = vec![DVec3::ZERO; at.len()];
        let mut densities = Vec::with_capacity(cable.segments.len());
        let mut from_first = 0.0;
        for (s, &segment) in cable.segments.iter().enumerate() {
            let length = energy::length::length(segment, at);
            let own = match &catenary {
                Some(catenary) => catenary.force(from_first + 0.5 * length),
                None => (force + cable.force(s, at) - mean).max(LEAST_FORCE * force),
            };
            from_first += length;
            densities.push(own / length);
            let half = cable.up * (0.5 * cable.weight * length);
            segment.into_iter().for_each(|v| loads[v as usize] -= half);
        }
        body.terms.push(Box::new(energy::ForceDensity { segments: cable.segments.clone(), densities }));
        body.terms.push(Box::new(Load { forces: loads }));
    }

    /// The weight of each layer, with the datum at its mean height at these positions.
    pub fn weights(&self, structure: &Structure, vertices: &[DVec3]) -> Vec<Weight> {
        let weight = |(layer, film): (&Layer, &FilmStress)| {
            Weight::new(layer.triangles().collect(), film.weight, structure.up, vertices)
        };
        self.layers.iter().zip(&structure.layers).map(weight).collect()
    }

    /// The forces on the rings from outside, in equal shares on the vertices of each; `None` if there are none.
    pub fn ring_forces(&self, structure: &Structure) -> Option<Vec<DVec3>> {
        if structure.rings.iter().all(|ring| ring.force == 0.0) {
            return None;
        }
        let mut forces = vec![DVec3::ZERO; self.films + self.air.len()];
        for (ring, moving) in structure.rings.iter().zip(&self.rings) {
            let share = ring.force / moving.vertices.len() as f64 * ring.axis;
            moving.vertices.iter().for_each(|&v| forces[v as usize] += share);
        }
        Some(forces)
    }

    /// The weight of the layers as a force on each vertex, at these positions.
    pub fn film_loads(&self, structure: &Structure, vertices: &[DVec3]) -> Vec<DVec3> {
        let mut loads = vec![DVec3::ZERO; vertices.len()];
        for (layer, film) in self.layers.iter().zip(&structure.layers) {
            for triangle in layer.triangles() {
                let area = 0.5 * measure::double_area_vector(triangle.map(|v| vertices[v as usize])).length();
                let third = structure.up * (film.weight * area / 3.0);
                triangle.iter().for_each(|&v| loads[v as usize] -= third);
            }
        }
        loads
    }

    /// Renews the stresses of a woven film by the given rule, and then the forces that its pull adds to the segments of
    /// its cables. Returns the largest relative change of a stress; 0 for other films.
    pub fn renew_stresses(&mut self, structure: &Structure, renewal: Renewal) -> Result<f64, LinearError> {
        let at = self.vertices();
        let loads = self.film_loads(structure, &at);
        let Some(field) = &mut self.stress_field else { return Ok(0.0) };
        let film = &self.layers[0].film;
        let triangles = film.triangles();
        let change = match renewal {
            Renewal::Balance => {
                let inside: Vec<bool> = film.fixed.iter().map(|fixed| !fixed).collect();
                field.renew(triangles, &at, &loads, &inside)?
            }
            Renewal::Keep => 0.0,
            Renewal::Required => {
                field.make_constant();
                0.0
            }
        };
        let mut pull = vec![DVec3::ZERO; at.len()];
        field.prestress(triangles, &at).add_gradient(&at, &mut pull);
        pull.iter_mut().zip(&loads).for_each(|(pull, load)| *pull -= *load);
        for ((cable, chain), further) in structure.cables.iter().zip(&self.chains).zip(&mut self.further_forces) {
            if cable.course.ends_in_the_air().is_none() {
                *further = pulls_along(chain, cable.mode, &pull, &at);
            }
        }
        Ok(change)
    }

    /// The unknowns of the rounds of a woven film: the coordinates of all vertices, then ln m of each vertex of the
    /// film (m: the factor of its stresses) times an edge length, so that all unknowns are lengths.
    pub fn unknowns(&self) -> Vec<f64> {
        let mut unknowns: Vec<f64> = self.vertices().iter().flat_map(|p| p.to_array()).collect();
        let edge = self.start_edge;
        unknowns.extend(self.stress_field.iter().flat_map(|field| &field.factors).map(|factor| edge * factor));
        unknowns
    }

    /// Sets the values that [`unknowns`](Self::unknowns) returned, or a combination of several. Vertices that slide are
    /// moved back to the nearest points of their supports.
    pub fn set_unknowns(&mut self, unknowns: &[f64]) {
        let count = self.films + self.air.len();
        let mut vertices: Vec<DVec3> = unknowns[..3 * count].chunks_exact(3).map(DVec3::from_slice).collect();
        for (v, freedom) in &self.sliding {
            if let Some(support) = freedom.support() {
                let vertex = &mut vertices[*v as usize];
                *vertex = self.supports[support as usize].nearest(*vertex);
            }
        }
        self.set_vertices(&vertices);
        let edge = self.start_edge;
        if let Some(field) = &mut self.stress_field {
            field.factors.iter_mut().zip(&unknowns[3 * count..]).for_each(|(own, value)| *own = value / edge);
        }
    }

    /// Number of flipped triangles of all layers.
    pub fn flipped(&self) -> usize {
        self.layers.iter().map(|layer| layer.film.flipped_triangles()).sum()
    }
}

/// Divides every edge that connects two vertices of the boundaries through the inside at its middle. Two layers over
/// the same boundaries would both have it, and could not come apart there.
fn split_chords(mesh: &mut Mesh, boundaries: &[Vec<u32>]) {
    let mut on_boundary = vec![false; mesh.vertices.len()];
    boundaries.iter().flatten().for_each(|&v| on_boundary[v as usize] = true);
    let mut rims = BTreeSet::new();
    for rim in boundaries {
        let next = |k: usize| rim[(k + 1) % rim.len()];
        rims.extend((0..rim.len()).map(|k| (rim[k].min(next(k)), rim[k].max(next(k)))));
    }
    let mut middles = BTreeMap::new();
    let mut triangles = Vec::with_capacity(mesh.triangles.len());
    for &triangle in &mesh.triangles {
        // The middle of the side that begins at each corner, if it is a chord.
        let middle = [0, 1, 2].map(|k| {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            let side = (a.min(b), a.max(b));
            let is_chord = on_boundary[a as usize] && on_boundary[b as usize] && !rims.contains(&side);
            is_chord.then(|| {
                *middles.entry(side).or_insert_with(|| {
                    mesh.vertices.push(0.5 * (mesh.vertices[a as usize] + mesh.vertices[b as usize]));
                    (mesh.vertices.len() - 1) as u32
                })
            })
        });
        // Rotate the corners so that the sides that are chords come first.
        let count = middle.iter().flatten().count();
        let turn = (0..3).find(|turn| (0..count).all(|k| middle[(turn + k) % 3].is_some())).unwrap_or(0);
        let [a, b, c] = [0, 1, 2].map(|k| triangle[(turn + k) % 3]);
        match [0, 1, 2].map(|k| middle[(turn + k) % 3]) {
            [Some(u), Some(v), Some(w)] => triangles.extend([[a, u, w], [u, b, v], [w, v, c], [u, v, w]]),
            [Some(u), Some(v), None] => triangles.extend([[u, b, v], [a, u, v], [a, v, c]]),
            [Some(u), ..] => triangles.extend([[a, u, c], [u, b, c]]),
            _ => triangles.push(triangle),
        }
    }
    mesh.triangles = triangles;
}

/// Damps the changes of a cable's force where the force is computed from the shape and the shape follows from the
/// force, so that both might swing to and fro without end.
#[derive(Clone, Copy, Debug)]
struct Swing {
    /// The part of a change that is made.
    share: f64,
    /// The last change that was asked for.
    last: f64,
}

impl Default for Swing {
    fn default() -> Self {
        Self { share: 1.0, last: 0.0 }
    }
}

impl Swing {
    /// A change opposite to the last one counts as an oscillation if it is above this fraction of the last one.
    const LASTS: f64 = 0.7;
    /// Smallest part of a change that is made.
    const LEAST_SHARE: f64 = 0.1;

    /// The part of a change that is made, which is halved while the changes go to and fro.
    fn damped(&mut self, change: f64) -> f64 {
        if change * self.last < 0.0 && change.abs() > Self::LASTS * self.last.abs() {
            self.share = (0.5 * self.share).max(Self::LEAST_SHARE);
        }
        self.last = change;
        self.share * change
    }
}

/// Least horizontal part of a chord, as a fraction of its length, by which a start force divides a horizontal
/// component.
const LEAST_ACROSS: f64 = 0.1;
/// Least force of a segment of a heavy cable at the start, as a fraction of the cable's mean force. The positions may
/// be far from those of an equilibrium, where no part of a cable pushes.
const LEAST_FORCE: f64 = 0.1;

/// Half angle, in radians, of the flattest arc with which a cable of given length begins. It limits the force in
/// [`Stage::Settling`], where the ends may stand further apart than the cable is long.
const FLATTEST: f64 = 0.05;

/// The radius of an arc of the given length over a chord; the radius of the flattest arc if the chord is not shorter.
fn arc_radius(chord: f64, length: f64) -> f64 {
    if chord >= length {
        return 0.5 * length / FLATTEST;
    }
    // The half angle t with sin t / t = chord / length, by bisection: the quotient falls from 1 to 0.
    let (mut low, mut high) = (0.0, std::f64::consts::PI);
    for _ in 0..60 {
        let middle: f64 = 0.5 * (low + high);
        *(if libm::sin(middle) * length > chord * middle { &mut low } else { &mut high }) = middle;
    }
    0.5 * length / low.max(FLATTEST)
}

/// The law of a cable and what determines its force.
fn law(cable: &Cable) -> (Law, ForceBy) {
    let by_equation = |equation| (Law::Multiplier, ForceBy::Equation(equation));
    if let (Course::Mast(_), CableMode::Force(force)) = (&cable.course, cable.mode) {
        return (Law::Force(-force), ForceBy::Law);
    }
    let heavy = cable.weight > 0.0;
    match cable.mode {
        CableMode::Length(length) => (Law::Multiplier, ForceBy::Length(length)),
        CableMode::Sag(sag) => by_equation(Equation::Sag(sag)),
        CableMode::HorizontalComponent(force) => by_equation(Equation::HorizontalComponent(force)),
        CableMode::Force(force) if heavy => by_equation(Equation::MeanForce(force)),
        CableMode::EndTension(force) if heavy => by_equation(Equation::EndTension(force)),
        CableMode::Force(force) | CableMode::EndTension(force) => (Law::Force(force), ForceBy::Law),
        CableMode::ForceDensity(density) if heavy => by_equation(Equation::ForceDensity(density)),
        CableMode::ForceDensity(density) => (Law::Density(density), ForceBy::Law),
        CableMode::UnstressedLength(unstressed) => {
            let stiffness = cable.axial_stiffness.unwrap_or(1.0);
            if heavy {
                by_equation(Equation::Elastic { unstressed, stiffness })
            } else {
                (Law::Multiplier, ForceBy::Elastic { unstressed, stiffness })
            }
        }
    }
}

/// Estimates the force of a cable from its present shape. The estimate for a cable of given length or sag is that of a
/// circular arc under a uniform load across it.
fn start_force(cable: &Cable, structure: &Structure, segments: &[[u32; 2]], at: &[DVec3]) -> f64 {
    let (Some(&[first, _]), Some(&[_, last])) = (segments.first(), segments.last()) else { return 0.0 };
    let span = at[last as usize] - at[first as usize];
    let chord = span.length();
    let length = || segments.iter().map(|&segment| energy::length::length(segment, at)).sum::<f64>();
    let load = if cable.course.ends_in_the_air().is_some() { cable.weight } else { structure.pull() };
    match cable.mode {
        CableMode::Force(force) | CableMode::EndTension(force) => force,
        CableMode::HorizontalComponent(wanted) => {
            let across = span.normalize_or_zero().reject_from_normalized(structure.up).length();
            wanted / across.max(LEAST_ACROSS)
        }
        CableMode::ForceDensity(density) => density * length(),
        CableMode::Length(length) => load * arc_radius(chord, length),
        CableMode::UnstressedLength(unstressed) => {
            // The force F of an arc of radius F / load whose length is L0 (1 + F / EA), by bisection: the length of the
            // arc falls with the force. The arc of the least force is half a circle.
            let stiffness = cable.axial_stiffness.unwrap_or(1.0);
            let (mut low, mut high) = (0.5 * load * chord, 0.5 * load * chord + stiffness * (2.0 * chord / unstressed));
            for _ in 0..60 {
                let force = 0.5 * (low + high);
                let arc = 2.0 * force / load.max(f64::MIN_POSITIVE) * libm::asin((0.5 * load * chord / force).min(1.0));
                *(if arc > unstressed * (1.0 + force / stiffness) { &mut low } else { &mut high }) = force;
            }
            low
        }
        CableMode::Sag(sag) => load * (0.25 * chord * chord + sag * sag) / (2.0 * sag),
    }
}

/// The mean force of a cable, weighted by the lengths of its segments, its least and its largest force.
pub(super) fn forces(term: &cable::Cable, further: f64, at: &[DVec3]) -> (f64, f64, f64) {
    let (mut sum, mut total, mut least, mut most) = (0.0, 0.0, f64::INFINITY, f64::NEG_INFINITY);
    for (k, &segment) in term.segments.iter().enumerate() {
        let (force, length) = (term.force(k, at) + further, energy::length::length(segment, at));
        sum += force * length;
        total += length;
        least = least.min(force);
        most = most.max(force);
    }
    (sum / total.max(f64::MIN_POSITIVE), least, most)
}
