//! The mesh of a tensile structure: the film's triangles, the vertices of its cables, and what each vertex may do.

use super::catenary::Catenary;
use super::options::{BoundaryPoint, Cable, CableMode, Course, Options, Pressure, Sliding, SlidingPart, Structure};
use super::weave::{StressField, pulls_along};
use crate::energy::cable::{self, CableCondition, Equation, Law};
use crate::energy::{Load, Term, Volume, Weight};
use crate::equilibrium::{Body, Constraint, Determined, Freedom, Support};
use crate::error::Warning;
use crate::mesh::complex::Complex;
use crate::mesh::film::Film;
use crate::mesh::measure;
use crate::minimal_surface::{self, Constraints, Method};
use crate::sparse::LinearError;
use crate::{DVec3, Error, Execution, Place, energy, polyline};

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
    pub film: Film,
    /// Vertices of cables in the air, numbered after those of the film.
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
    /// The volume between fans from each boundary to its mean and the origin, which closes the film's own.
    pub cap_volume: f64,
    /// The surfaces on which vertices slide, and the freedom of each vertex that does.
    pub supports: Vec<Support>,
    pub sliding: Vec<(u32, Freedom)>,
    pub cables: Vec<energy::Cable>,
    /// What determines the force of each cable.
    pub forces_by: Vec<ForceBy>,
    /// The force of each cable with which form finding begins.
    pub start_forces: Vec<f64>,
    /// Mean length of the edges of the initial mesh.
    start_edge: f64,
    /// The stresses of a woven film.
    pub stress_field: Option<StressField>,
    /// For each cable and each of its segments what the pull of a woven film along the cable adds to the force; empty
    /// for other films and for cables in the air.
    pub further_forces: Vec<Vec<f64>>,
    pub warnings: Vec<Warning>,
}

/// A ring that moves along its axis as a whole.
#[derive(Clone, Debug)]
pub(super) struct MovingRing {
    pub axis: DVec3,
    /// The vertices of its boundary, then that of its hub.
    pub vertices: Vec<u32>,
}

/// What the stresses of a woven film become in a renewal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Renewal {
    /// Those of the required ratio that come nearest to the balance within the film.
    Balance,
    /// They stay as they are.
    Keep,
    /// The required ones, constant over the film.
    Required,
}

/// What determines the force of a cable.
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
    /// An equation in place of the constraint's value: the cable is heavy, or its sag or its horizontal component is
    /// given.
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
    pub fn build(structure: &Structure, options: &Options, exec: &Execution) -> Result<Self, Error> {
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
        let invalid = || Error::no_result("invalid_mesh", "the initial mesh is no oriented manifold");
        let lost = || Error::no_result("invalid_mesh", "a cable across the film has no edges in the initial mesh");
        let film = Film::new(surface.mesh.vertices, &surface.mesh.triangles, surface.boundaries).ok_or_else(invalid)?;
        let mut model = Self {
            centre,
            film,
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
            cables: Vec::new(),
            forces_by: Vec::new(),
            start_forces: Vec::new(),
            start_edge: 0.0,
            stress_field: None,
            further_forces: vec![Vec::new(); structure.cables.len()],
            warnings,
        };
        for sliding in &structure.sliding {
            model.slide(sliding);
        }
        model.join(structure);
        model.cap_volume = model.caps();
        model.free = structure.free_points.iter().map(|&point| model.input_vertex(point)).collect();
        let edge = model.mean_edge();
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
            let (law, by) = law(cable);
            model.start_forces.push(start_force(cable, structure, &segments, &vertices));
            model.cables.push(energy::Cable::new(segments, law).heavy(cable.weight, structure.up));
            model.forces_by.push(by);
        }
        let count = model.film.vertices.len();
        model.stress_field =
            structure.film.weave().map(|weave| StressField::new(weave, centre, model.film.triangles(), count));
        Ok(model)
    }

    pub fn input_vertex(&self, BoundaryPoint { boundary, point }: BoundaryPoint) -> u32 {
        self.input_vertices[boundary][point]
    }

    /// Lets a cable bear no force.
    pub fn let_go(&mut self, k: usize) {
        self.forces_by[k] = ForceBy::Law;
        self.cables[k].law = Law::Force(0.0);
    }

    fn is_let_go(&self, k: usize) -> bool {
        self.forces_by[k] == ForceBy::Law && self.cables[k].law == Law::Force(0.0)
    }

    /// All vertices: the film's, then those in the air.
    pub fn vertices(&self) -> Vec<DVec3> {
        self.film.vertices.iter().chain(&self.air).copied().collect()
    }

    pub fn set_vertices(&mut self, vertices: &[DVec3]) {
        let count = self.film.vertices.len();
        self.film.vertices.copy_from_slice(&vertices[..count]);
        self.air.copy_from_slice(&vertices[count..]);
    }

    pub fn mean_edge(&self) -> f64 {
        let triangles = self.film.triangles();
        let sum: f64 = triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| self.film.vertices[a as usize].distance(self.film.vertices[b as usize]))
            .sum();
        sum / (3 * triangles.len()) as f64
    }

    fn along(&self, boundary: usize, from: usize, to: usize) -> Vec<u32> {
        let rim = &self.film.boundaries[boundary];
        let vertex = |point: usize| self.input_vertices[boundary][point];
        let place = |v: u32| rim.iter().position(|&w| w == v).expect("an input point is a vertex of its boundary");
        let (first, last) = (place(vertex(from)), place(vertex(to)));
        let count = (last + rim.len() - first) % rim.len();
        (0..=count).map(|k| rim[(first + k) % rim.len()]).collect()
    }

    /// The vertices of a cable across the film, with those that were added between its points. Its edges stay.
    fn across(&mut self, points: &[u32]) -> Option<Vec<u32>> {
        let mut chain = vec![*points.first()?];
        for pair in points.windows(2) {
            let (mut here, end) = (pair[0], pair[1]);
            let at = |v: u32| self.film.vertices[v as usize];
            let span = at(end) - at(here);
            let (start, direction) = (at(here), span.normalize_or_zero());
            while here != end {
                // The next vertex on the segment: the nearest neighbour ahead that lies on it.
                let ahead = |v: &u32| {
                    let place = at(*v) - start;
                    place.dot(direction) > (at(here) - start).dot(direction)
                        && place.reject_from_normalized(direction).length() <= ON_SEGMENT * span.length()
                };
                let nearer = |a: &u32, b: &u32| at(*a).distance(at(here)).total_cmp(&at(*b).distance(at(here)));
                here = self.film.topology.neighbours(here).filter(ahead).min_by(nearer)?;
                chain.push(here);
            }
        }
        for pair in chain.windows(2) {
            self.film.locked.push([pair[0].min(pair[1]), pair[0].max(pair[1])]);
        }
        self.film.locked.sort_unstable();
        chain.iter().for_each(|&v| self.film.fixed[v as usize] = true);
        (chain.len() > 1).then_some(chain)
    }

    /// Makes the rings that move and the vertices of hubs and joints.
    fn join(&mut self, structure: &Structure) {
        for ring in &structure.rings {
            let mut vertices = self.film.boundaries[ring.boundary].clone();
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
        (self.film.vertices.len() + self.air.len() - 1) as u32
    }

    fn through_the_air(&mut self, structure: &Structure, cable: &Cable, ends: [DVec3; 2], edge: f64) -> Vec<u32> {
        let mut joined = |end: DVec3| {
            for (boundary, points) in structure.boundaries.iter().enumerate() {
                if let Some(point) = points.iter().position(|p| *p == end) {
                    return self.input_vertices[boundary][point];
                }
            }
            let place = end - self.centre;
            let count = self.film.vertices.len();
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
            // Without a catenary the cable starts from a sag of a tenth of its length, so that it has a curvature.
            let sag = 0.4 * straight * share * (1.0 - share) * structure.up;
            chain.push((self.film.vertices.len() + self.air.len()) as u32);
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
        let count = self.film.vertices.len();
        for k in 0..self.chains.len() {
            let Some(catenary) = self.catenary(structure, k, &at) else { continue };
            let (chain, length) = (&self.chains[k], catenary.length());
            for (i, &v) in chain.iter().enumerate().take(chain.len() - 1).skip(1) {
                let from_first = length * i as f64 / (chain.len() - 1) as f64;
                self.air[v as usize - count] = catenary.point(from_first);
            }
        }
    }

    /// Adjusts the forces at the start that follow from the shape to the present one.
    pub fn renew_start_forces(&mut self, structure: &Structure) {
        let at = self.vertices();
        for (k, cable) in structure.cables.iter().enumerate() {
            let term = &self.cables[k];
            let force = &mut self.start_forces[k];
            // A shallow cable's sag is inversely proportional to its force, and the horizontal component of a force is
            // proportional to it.
            let ratio = match cable.mode {
                CableMode::Sag(sag) => term.sag(&at) / sag,
                CableMode::HorizontalComponent(wanted) => wanted / (*force * term.level_part(&at).max(LEAST_ACROSS)),
                _ => {
                    *force = start_force(cable, structure, &term.segments, &at);
                    continue;
                }
            };
            *force *= ratio.clamp(0.25, 4.0);
        }
    }

    fn slide(&mut self, sliding: &Sliding) {
        let number = self.supports.len() as u32;
        self.supports.push(moved(sliding.on, -self.centre));
        let on = &self.supports[number as usize];
        let (vertices, closed): (Vec<u32>, bool) = match sliding.part {
            SlidingPart::Point(point) => {
                let v = self.input_vertex(point);
                self.film.vertices[v as usize] = on.nearest(self.film.vertices[v as usize]);
                self.sliding.push((v, Freedom::On(number)));
                return;
            }
            SlidingPart::Edge { boundary, from, to } => (self.along(boundary, from, to), false),
            SlidingPart::Boundary(boundary) => (self.film.boundaries[boundary].clone(), true),
        };
        let count = vertices.len();
        let inner = if closed { 0..count } else { 1..count - 1 };
        for k in inner {
            let v = vertices[k];
            self.film.vertices[v as usize] = on.nearest(self.film.vertices[v as usize]);
            let beside = [vertices[(k + count - 1) % count], vertices[(k + 1) % count]];
            self.sliding.push((v, Freedom::AcrossOn { support: number, beside }));
        }
    }

    fn caps(&self) -> f64 {
        let mut sixfold = 0.0;
        for rim in self.film.topology.boundary_loops() {
            let points: Vec<DVec3> = rim.iter().map(|&v| self.film.vertices[v as usize]).collect();
            let mean = polyline::mean(&points);
            for k in 0..points.len() {
                sixfold += mean.dot(points[(k + 1) % points.len()].cross(points[k]));
            }
        }
        sixfold / 6.0
    }

    /// The volume that the film and the fans from each boundary to its mean enclose.
    pub fn volume(&self, vertices: &[DVec3]) -> f64 {
        let triangles = self.film.triangles().to_vec();
        Volume { triangles, pressure: -1.0 }.value(vertices) + self.cap_volume
    }

    /// The body with the terms of the structure, the film's area first. `volume` is the volume to be enclosed, if that
    /// is required. At the `start` every cable has the force densities and the loads of its present shape and of a
    /// force that comes near the required one.
    pub fn body(&self, structure: &Structure, volume: Option<f64>, start: bool) -> Result<Body, Error> {
        let vertices = self.vertices();
        let invalid = |defect| Error::no_result("invalid_mesh", format!("the film's mesh is damaged: {defect}"));
        let complex = Complex::build(self.film.triangles().to_vec(), self.film.vertices.len()).map_err(invalid)?;
        let tension = structure.film.mean();
        let tensions = vec![tension; complex.sheets.len()];
        let mut body = Body::new(vertices, &complex, &tensions);
        // All sheets have one tension or one field of stresses, so one term serves them all.
        body.terms.truncate(0);
        match &self.stress_field {
            None => {
                body.terms.push(Box::new(energy::Area { triangles: self.film.triangles().to_vec(), tension }));
            }
            Some(field) => body.terms.push(Box::new(field.prestress(self.film.triangles(), &body.vertices))),
        }
        for (k, &fixed) in self.air_fixed.iter().enumerate() {
            body.freedoms[self.film.vertices.len() + k] = if fixed { Freedom::Fixed } else { Freedom::Free };
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
        if structure.film.weight > 0.0 {
            // The stresses of a woven film are what its field says, so its weight only loads it.
            body.terms.push(match &self.stress_field {
                None => Box::new(self.weight(structure, &body.vertices)),
                Some(_) => Box::new(Load { forces: self.film_loads(structure, &body.vertices) }),
            });
        }
        for (k, (cable, &by)) in self.cables.iter().zip(&self.forces_by).enumerate() {
            // A straight cable in the air has no other shape, so its length is a constraint from the start.
            let by_length = matches!(by, ForceBy::Length(_) | ForceBy::Elastic { .. });
            if start && !(by_length && cable.segments.len() == 1) {
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
        let triangles = || self.film.triangles().to_vec();
        match (structure.pressure, volume) {
            (_, Some(volume)) => {
                let quantity = Box::new(Volume { triangles: triangles(), pressure: -1.0 });
                body.constraints.push(Constraint::value(quantity, volume - self.cap_volume));
            }
            (Pressure::Constant(pressure), None) => {
                body.terms.push(Box::new(Volume { triangles: triangles(), pressure }));
            }
            (Pressure::None | Pressure::Volume(_), None) => {}
        }
        body.check().map_err(|defect| match defect {
            crate::equilibrium::BodyDefect::Target(_) => Error::input(
                Place::field("volume"),
                "cannot be told from an empty one; move the boundaries or change it",
            ),
            other => Error::no_result("invalid_mesh", other.to_string()),
        })?;
        Ok(body)
    }

    /// Adds a cable as it is at the start.
    fn add_start(&self, body: &mut Body, structure: &Structure, k: usize) {
        let cable = &self.cables[k];
        if self.forces_by[k] == ForceBy::Law && cable.weight == 0.0 {
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

    /// The film's weight, with the datum at the mean height of these positions.
    pub fn weight(&self, structure: &Structure, vertices: &[DVec3]) -> Weight {
        Weight::new(self.film.triangles().to_vec(), structure.film.weight, structure.up, vertices)
    }

    /// The forces on the rings from outside, in equal shares on the vertices of each; `None` if there are none.
    pub fn ring_forces(&self, structure: &Structure) -> Option<Vec<DVec3>> {
        if structure.rings.iter().all(|ring| ring.force == 0.0) {
            return None;
        }
        let mut forces = vec![DVec3::ZERO; self.film.vertices.len() + self.air.len()];
        for (ring, moving) in structure.rings.iter().zip(&self.rings) {
            let share = ring.force / moving.vertices.len() as f64 * ring.axis;
            moving.vertices.iter().for_each(|&v| forces[v as usize] += share);
        }
        Some(forces)
    }

    /// The film's weight as a force on each vertex, at these positions.
    pub fn film_loads(&self, structure: &Structure, vertices: &[DVec3]) -> Vec<DVec3> {
        let mut loads = vec![DVec3::ZERO; vertices.len()];
        for triangle in self.film.triangles() {
            let area = 0.5 * measure::double_area_vector(triangle.map(|v| vertices[v as usize])).length();
            let third = structure.up * (structure.film.weight * area / 3.0);
            triangle.iter().for_each(|&v| loads[v as usize] -= third);
        }
        loads
    }

    /// Lets the stresses of a woven film, and the forces of its cables from segment to segment, follow from the balance
    /// of forces within the film. Returns the largest relative change of a stress; 0 for other films.
    pub fn renew_stresses(&mut self, structure: &Structure, renewal: Renewal) -> Result<f64, LinearError> {
        let at = self.vertices();
        let loads = self.film_loads(structure, &at);
        let Some(field) = &mut self.stress_field else { return Ok(0.0) };
        let triangles = self.film.triangles();
        let change = match renewal {
            Renewal::Balance => {
                let inside: Vec<bool> = self.film.fixed.iter().map(|fixed| !fixed).collect();
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

    /// What the rounds of a woven film change: the coordinates of all vertices, and ln m of each vertex of the film
    /// times the length of an edge, so that both count alike.
    pub fn unknowns(&self) -> Vec<f64> {
        let mut unknowns: Vec<f64> = self.vertices().iter().flat_map(|p| p.to_array()).collect();
        let edge = self.start_edge;
        unknowns.extend(self.stress_field.iter().flat_map(|field| &field.factors).map(|factor| edge * factor));
        unknowns
    }

    /// Takes what [`unknowns`](Self::unknowns) returned, or a combination of several, in which vertices that slide are
    /// taken back to their supports.
    pub fn set_unknowns(&mut self, unknowns: &[f64]) {
        let count = self.film.vertices.len() + self.air.len();
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

    /// Number of flipped triangles of the film.
    pub fn flipped(&self) -> usize {
        let normals = measure::normals(&self.film.vertices, self.film.triangles());
        measure::count_flipped(&self.film.vertices, self.film.triangles(), &normals)
    }
}

/// A support at another place.
fn moved(support: Support, by: DVec3) -> Support {
    match support {
        Support::Line { point, direction } => Support::Line { point: point + by, direction },
        Support::Circle { centre, axis, radius } => Support::Circle { centre: centre + by, axis, radius },
        Support::Plane { point, normal } => Support::Plane { point: point + by, normal },
        Support::Sphere { centre, radius } => Support::Sphere { centre: centre + by, radius },
        Support::Cylinder { point, axis, radius } => Support::Cylinder { point: point + by, axis, radius },
    }
}

/// The least part of a chord across the vertical that a start uses to estimate the force from its horizontal component.
const LEAST_ACROSS: f64 = 0.1;
/// Least force of a segment of a heavy cable at the start, as a fraction of the cable's mean force. The positions may
/// be far from those of an equilibrium, where no part of a cable pushes.
const LEAST_FORCE: f64 = 0.1;

/// The radius of an arc of the given length over a chord; half the length if the chord is not shorter.
fn arc_radius(chord: f64, length: f64) -> f64 {
    if chord >= length {
        return 0.5 * length;
    }
    // The half angle t with sin t / t = chord / length, by bisection: the quotient falls from 1 to 0.
    let (mut low, mut high) = (0.0, std::f64::consts::PI);
    for _ in 0..60 {
        let middle: f64 = 0.5 * (low + high);
        *(if middle.sin() * length > chord * middle { &mut low } else { &mut high }) = middle;
    }
    0.5 * length / low.max(1e-6)
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

/// A force near the one that a cable will have, from its present shape. A cable of given length or sag has that of an
/// arc under a load across it.
fn start_force(cable: &Cable, structure: &Structure, segments: &[[u32; 2]], at: &[DVec3]) -> f64 {
    let (Some(&[first, _]), Some(&[_, last])) = (segments.first(), segments.last()) else { return 0.0 };
    let span = at[last as usize] - at[first as usize];
    let chord = span.length();
    let length = || segments.iter().map(|&segment| energy::length::length(segment, at)).sum::<f64>();
    let load = if cable.course.ends_in_the_air().is_some() { cable.weight } else { structure.film.mean() };
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
                let arc = 2.0 * force / load.max(f64::MIN_POSITIVE) * (0.5 * load * chord / force).min(1.0).asin();
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
