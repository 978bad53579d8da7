//! Builds the model of a structure: its mesh, the vertices and the start forces of its cables, and its supports.

use super::cable_force::{ForceBy, Swing, law, start_force};
use super::{FirstShape, Layer, Model, ModelCable, MovingRing, segments};
use crate::catenary;
use crate::options::{Cable, Course, Options, Sliding, SlidingPart, Structure};
use crate::weave::StressField;
use plateau_equilibrium::energy;
use plateau_equilibrium::energy::cable::Law;
use plateau_equilibrium::{ContactEnergy, Freedom};
use plateau_mesh::codes::Reason;
use plateau_mesh::film::Film;
use plateau_mesh::{DVec3, Error, Execution, Mesh, polyline};
use plateau_minimal_surface::{Constraints, InitialMesh, Method, VertexRelaxation};
use std::collections::{BTreeMap, BTreeSet};

/// Minimum number of segments of a heavy cable in the air.
const LEAST_AIR_SEGMENTS: f64 = 16.0;
/// Maximum number of segments of a heavy cable in the air. More segments would not show in the shape of a catenary.
const MOST_AIR_SEGMENTS: f64 = 1000.0;
/// A vertex counts as lying on a segment of a cable across the film up to this distance, as a fraction of the segment's
/// length.
const ON_SEGMENT: f64 = 1e-9;

/// The options of the surface with which form finding starts: a single harmonic map, in which the cables across the
/// film are constraint polylines.
pub(crate) fn start_options(structure: &Structure, options: &Options) -> plateau_minimal_surface::Options {
    let across = structure.cables.iter().filter_map(|cable| match &cable.course {
        Course::Across(points) => Some(points.clone()),
        Course::Boundary { .. } | Course::Air(_) | Course::Mast(_) => None,
    });
    plateau_minimal_surface::Options {
        method: Method::Harmonic,
        constraints: Constraints {
            points: Vec::new(),
            polylines: across.collect(),
            ends: structure.across_ends.clone(),
        },
        ..plateau_minimal_surface::Options::new(options.resolution)
    }
}

/// The options of a ruled start: rings on the straight lines between two boundaries. They are also for a tube under
/// pressure or of given volume that is longer than its ends are wide, because a harmonic map narrows such a tube to a
/// neck, which then closes although a wide film is in equilibrium. `None` for other structures.
fn ruled_options(
    structure: &Structure,
    harmonic: &plateau_minimal_surface::Options,
    shape: FirstShape,
) -> Option<plateau_minimal_surface::Options> {
    let [first, second] = &structure.boundaries[..] else { return None };
    let apart = polyline::mean(first).distance(polyline::mean(second));
    let is_long = apart > polyline::radius(first).min(polyline::radius(second));
    let is_tube = is_long && !structure.chambers.is_empty();
    let may_rule = structure.layers.len() == 1 && harmonic.constraints.is_empty();
    // No iteration of the paper's solver, so that its initial mesh is returned as it is.
    ((is_tube || shape == FirstShape::Ruled) && may_rule).then(|| plateau_minimal_surface::Options {
        method: Method::VertexRelaxation(VertexRelaxation::default()),
        initial_mesh: InitialMesh::Rings,
        max_iterations: Some(0),
        ..harmonic.clone()
    })
}

impl Model {
    /// Meshes the boundaries and finds the vertices of the cables. `share` is the edge length of the final mesh divided
    /// by that of this mesh.
    pub fn build(
        structure: &Structure,
        options: &Options,
        share: f64,
        shape: FirstShape,
        exec: &Execution,
    ) -> Result<Self, Error> {
        let all: Vec<DVec3> = structure.boundaries.iter().flatten().copied().collect();
        let centre = polyline::mean(&all);
        let centred: Vec<Vec<DVec3>> =
            structure.boundaries.iter().map(|points| points.iter().map(|&p| p - centre).collect()).collect();
        let mut start = start_options(structure, options);
        let Constraints { polylines, ends, .. } = &mut start.constraints;
        let ends = ends.iter_mut().map(|end| &mut end.place);
        polylines.iter_mut().flatten().chain(ends).for_each(|point| *point -= centre);
        let surface = match ruled_options(structure, &start, shape) {
            // Where no strip of rings meets the resolution, the harmonic map is the start.
            Some(ruled) => match plateau_minimal_surface::solve(&centred, &ruled, exec) {
                Err(Error::Input(_) | Error::NoResult { .. }) => {
                    plateau_minimal_surface::solve(&centred, &start, exec)?
                }
                other => other?,
            },
            None => plateau_minimal_surface::solve(&centred, &start, exec)?,
        };
        let warnings = surface.warnings.into_iter().filter(|warning| warning.code == "merged_points").collect();
        // For each boundary the vertices of its points, as vertex numbers of the whole mesh.
        let input_vertices = surface.input_vertices;
        let invalid = || Error::no_result(Reason::InvalidMesh, "the initial mesh is no oriented manifold");
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
            cables: Vec::new(),
            free: Vec::new(),
            input_vertices,
            cap_volume: 0.0,
            supports: Vec::new(),
            sliding: Vec::new(),
            contacts: Vec::new(),
            at_contacts: BTreeSet::new(),
            start_edge: 0.0,
            stress_field: None,
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
        model.start_edge = share * model.mean_edge();
        model.add_cables(structure, surface.constraints.polylines)?;
        model.renew_stress_field(structure);
        Ok(model)
    }

    /// Sets the stresses of a woven film to the required ones, on the present mesh.
    pub fn renew_stress_field(&mut self, structure: &Structure) {
        let film = &self.layers[0].film;
        let field = |weave| StressField::new(weave, self.centre, film.triangles(), film.vertices.len());
        self.stress_field = structure.weave().map(field);
    }

    /// Finds the vertices, the laws and the start forces of the cables. `across` holds, for each cable across the film,
    /// the vertices of its points.
    fn add_cables(&mut self, structure: &Structure, across: Vec<Vec<u32>>) -> Result<(), Error> {
        let lost = || Error::no_result(Reason::InvalidMesh, "a cable across the film has no edges in the initial mesh");
        let mut across = across.into_iter();
        let mut chains = Vec::with_capacity(structure.cables.len());
        for cable in &structure.cables {
            let chain = match &cable.course {
                Course::Boundary { boundary, from, to } => self.along(*boundary, *from, *to),
                Course::Across(_) => self.across(&across.next().unwrap_or_default()).ok_or_else(lost)?,
                Course::Air(ends) | Course::Mast(ends) => self.through_the_air(structure, cable, *ends),
            };
            chains.push(chain);
        }
        let vertices = self.vertices();
        for (cable, chain) in structure.cables.iter().zip(chains) {
            let segments = segments(&chain);
            let ends = [chain[0], chain[chain.len() - 1]].map(|v| vertices[v as usize]);
            let held = |v: u32| (v as usize).checked_sub(self.films).is_some_and(|k| self.air_fixed[k]);
            let hangs_between_supports =
                matches!(cable.course, Course::Air(_)) && held(chain[0]) && held(chain[chain.len() - 1]);
            let (law, by) = match catenary::plumb_force(cable, ends, structure.up) {
                Some(Ok(force)) if hangs_between_supports => (Law::Force(force), ForceBy::Law),
                _ => law(cable),
            };
            self.cables.push(ModelCable {
                start_force: start_force(cable, structure, &segments, &vertices),
                term: energy::Cable::new(segments, law).heavy(cable.weight, structure.up),
                by,
                swing: Swing::default(),
                further_forces: Vec::new(),
                chain,
            });
        }
        Ok(())
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

    fn along(&self, boundary: usize, from: usize, to: usize) -> Vec<u32> {
        let rim = &self.boundaries()[boundary];
        let vertex = |point: usize| self.input_vertices[boundary][point];
        let place = |v: u32| rim.iter().position(|&w| w == v).expect("an input point is a vertex of its boundary");
        let (first, last) = (place(vertex(from)), place(vertex(to)));
        let count = (last + rim.len() - first) % rim.len();
        (0..=count).map(|k| rim[(first + k) % rim.len()]).collect()
    }

    /// Returns the vertices of a cable across the film from its first point to its last, including the vertices that
    /// meshing added between its points. Returns `None` if no edges connect the points. Locks these edges and fixes
    /// these vertices. A film with a cable across it has only one layer.
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

    /// Adds the moving rings, and the vertices of hubs and joints.
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

    fn through_the_air(&mut self, structure: &Structure, cable: &Cable, ends: [DVec3; 2]) -> Vec<u32> {
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
            (straight / self.start_edge).ceil().clamp(LEAST_AIR_SEGMENTS, MOST_AIR_SEGMENTS) as usize
        } else {
            1
        };
        let mut chain = vec![first];
        for k in 1..pieces {
            let share = k as f64 / pieces as f64;
            // The cable starts with a sag of a tenth of its chord, so that it is curved even if no catenary is found.
            let sag = 0.4 * straight * share * (1.0 - share) * structure.up;
            chain.push((self.films + self.air.len()) as u32);
            self.air.push(ends[0] - self.centre + share * (ends[1] - ends[0]) - sag);
            self.air_fixed.push(false);
        }
        chain.push(last);
        chain
    }

    /// Lets a part of the boundary slide on its support and moves the vertices of that part onto the support. `tension`
    /// is the film's tension, which the energy of an edge with a contact angle needs.
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
            self.contacts.extend(ContactEnergy::new(&vertices, closed, &*on, tension, angle, at));
            self.at_contacts.extend(&vertices);
        }
    }

    /// The signed volume between the origin and the fans from the edges of each boundary to its mean. The mean is taken
    /// by arc length, so that it is that of the boundary curve and not of the points that the mesh has on it.
    fn caps(&self) -> f64 {
        let mut sixfold = 0.0;
        let film = &self.layers[0].film;
        for rim in film.topology.boundary_loops() {
            let points: Vec<DVec3> = rim.iter().map(|&v| film.vertices[v as usize]).collect();
            let sides = || (0..points.len()).map(|k| (points[k], points[(k + 1) % points.len()]));
            let moment: DVec3 = sides().map(|(a, b)| a.distance(b) * a.midpoint(b)).sum();
            let mean = moment / polyline::length(&points, true).max(f64::MIN_POSITIVE);
            for k in 0..points.len() {
                sixfold += mean.dot(points[(k + 1) % points.len()].cross(points[k]));
            }
        }
        sixfold / 6.0
    }
}

/// Splits every inner edge whose two ends are boundary vertices at its middle. Two layers over the same boundaries
/// would share this edge and could not come apart there.
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
        // For each corner the middle of the side that begins there, if this side is a chord between boundary vertices.
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
