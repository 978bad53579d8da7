//! The model of a tensile structure: the meshes of its layers, the vertices of its cables, and the supports of its
//! vertices.
//!
//! - [`build`]: builds the model of a structure.
//! - [`cable_force`]: the quantity that determines the force of a cable, and estimates of that force.
//! - [`assembly`]: builds the body with the energies of the structure at the model's present shape.

mod assembly;
mod build;
mod cable_force;

pub(super) use build::start_options;
pub(super) use cable_force::{ForceBy, forces};

use super::catenary::Catenary;
use super::options::{BoundaryPoint, CableMode, Course, Structure};
use super::weave::StressField;
use cable_force::{LEAST_ACROSS, Swing, start_force};
use plateau_equilibrium::energy::cable::Law;
use plateau_equilibrium::energy::{self, Term, Volume};
use plateau_equilibrium::{ContactEnergy, Freedom, Support};
use plateau_mesh::error::Warning;
use plateau_mesh::film::Film;
use plateau_mesh::{DVec3, Mesh};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A structure with its meshes. Positions are relative to `centre`, the mean of the boundaries' points.
#[derive(Clone, Debug)]
pub(super) struct Model {
    pub centre: DVec3,
    pub layers: Vec<Layer>,
    /// Number of vertices of all layers.
    pub films: usize,
    /// Positions of the vertices of cables and masts that do not lie on a layer. Their numbers follow those of the
    /// layers' vertices.
    pub air: Vec<DVec3>,
    /// For each vertex in the air whether it is a support.
    pub air_fixed: Vec<bool>,
    /// Number of joints and hubs, which are the first vertices in the air.
    joined: usize,
    /// The rings that move, in the order of the input.
    pub rings: Vec<MovingRing>,
    /// The cables in the order of the input.
    pub cables: Vec<ModelCable>,
    /// The vertices of the free points.
    pub free: Vec<u32>,
    /// For each boundary the vertices of its input points.
    pub input_vertices: Vec<Vec<u32>>,
    /// Sum of the signed volumes between the origin and the fan of each boundary (the triangles from its edges to its
    /// mean). The surface integral over the last layer lacks this part, because nothing closes the last layer below.
    pub cap_volume: f64,
    /// The lines and surfaces on which vertices slide.
    pub supports: Vec<Arc<dyn Support>>,
    /// The vertices that slide, each with its freedom.
    pub sliding: Vec<(u32, Freedom)>,
    /// The energies of the edges that meet their surface at a given contact angle.
    pub contacts: Vec<ContactEnergy>,
    /// The vertices of the edges with a contact angle.
    pub at_contacts: BTreeSet<u32>,
    /// Mean edge length of the initial mesh, scaled to that of the final mesh.
    pub start_edge: f64,
    /// The stresses of a woven film; `None` for an isotropic one.
    pub stress_field: Option<StressField>,
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
    /// The triangles, with the vertex numbers of the model.
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        self.film.triangles().iter().map(|triangle| triangle.map(|v| self.numbers[v as usize]))
    }
}

/// A cable of the model.
#[derive(Clone, Debug)]
pub(super) struct ModelCable {
    /// Its vertices from the first end to the last.
    pub chain: Vec<u32>,
    /// The energy of the cable.
    pub term: energy::Cable,
    /// The quantity that determines the force of the cable.
    pub by: ForceBy,
    /// The force with which form finding begins.
    pub start_force: f64,
    /// The damping of the changes of `start_force`.
    swing: Swing,
    /// For each segment the force that the pull of a woven film along the cable adds; empty for other films and for
    /// cables in the air.
    pub further_forces: Vec<f64>,
}

impl ModelCable {
    /// The first and the last vertex.
    pub fn ends(&self) -> [u32; 2] {
        [self.chain[0], self.chain[self.chain.len() - 1]]
    }

    /// Sets the vertices of the cable, and the segments of its energy.
    pub fn set_chain(&mut self, chain: Vec<u32>) {
        self.term.segments = segments(&chain);
        self.chain = chain;
    }
}

/// The segments between the vertices of a chain.
fn segments(chain: &[u32]) -> Vec<[u32; 2]> {
    chain.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// A ring that moves along its axis as a whole.
#[derive(Clone, Debug)]
pub(super) struct MovingRing {
    pub axis: DVec3,
    /// The vertices of the ring's boundary, then the vertex of its hub, if it has one.
    pub vertices: Vec<u32>,
}

/// The shape of the initial mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FirstShape {
    /// A harmonic map of the film. Tubes under pressure or of given volume that are longer than their ends are wide
    /// begin on straight lines.
    Harmonic,
    /// The straight lines between two boundaries.
    Ruled,
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

/// The stage of form finding for which a body is built. It decides how the cables act.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stage {
    /// The first rounds, far from the equilibrium. The length of an elastic cable is a constraint that yields. A cable
    /// acts with its start force if its length is given or an equation determines its force.
    Settling,
    /// The rounds on a mesh that is not remeshed. Every cable acts with its start force unless the law of its energy
    /// gives the force. Only a cable of one segment whose length or stiffness is given has a constraint.
    Reference,
    /// The equilibrium itself: every cable has its own energy and the constraint that determines its force.
    Exact,
}

impl Model {
    /// Whether the length of a cable is prescribed, either exactly or by an unstressed length and a stiffness.
    pub fn holds_length(&self, k: usize) -> bool {
        matches!(self.cables[k].by, ForceBy::Length(_) | ForceBy::Elastic { .. })
    }

    /// Whether the length of a cable is a constraint already in [`Stage::Settling`].
    pub fn constrains_length(&self, k: usize) -> bool {
        match self.cables[k].by {
            ForceBy::Length(_) => self.cables[k].term.segments.len() <= 1,
            ForceBy::Elastic { .. } => true,
            ForceBy::Law | ForceBy::Equation(_) => false,
        }
    }

    /// The boundary points at which cables end, except points inside another cable and points of sliding edges. Each is
    /// given as its vertex, the index of its boundary and its index among the points of that boundary.
    pub fn corners(&self) -> Vec<(u32, usize, usize)> {
        let mut moves = vec![false; self.films];
        for ModelCable { chain, .. } in &self.cables {
            for &v in chain.iter().filter(|&&v| (v as usize) < self.films) {
                moves[v as usize] = true;
            }
        }
        let inner: BTreeSet<u32> = self
            .cables
            .iter()
            .flat_map(|own| own.chain.get(1..own.chain.len() - 1).unwrap_or_default())
            .copied()
            .collect();
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

    /// Releases a cable, so that it bears no force.
    pub fn let_go(&mut self, k: usize) {
        self.cables[k].by = ForceBy::Law;
        self.cables[k].term.law = Law::Force(0.0);
    }

    pub fn is_let_go(&self, k: usize) -> bool {
        self.cables[k].by == ForceBy::Law && self.cables[k].term.law == Law::Force(0.0)
    }

    /// The positions of all vertices: those of the layers, then those in the air.
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

    /// For each vertex whether it is held: no cable runs through it, and it neither is free, slides, nor moves with a
    /// ring.
    pub fn held(&self) -> Vec<bool> {
        let mut held = self.fixed();
        let inner = self.cables.iter().flat_map(|own| own.chain.get(1..own.chain.len() - 1).unwrap_or_default());
        let sliding = self.sliding.iter().map(|(v, _)| v);
        let guided = self.rings.iter().flat_map(|ring| &ring.vertices);
        for &v in inner.chain(&self.free).chain(sliding).chain(guided) {
            held[v as usize] = false;
        }
        held
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

    /// The catenary of a heavy cable in the air between its present ends.
    fn catenary(&self, structure: &Structure, k: usize, at: &[DVec3]) -> Option<Catenary> {
        let (cable, own) = (&structure.cables[k], &self.cables[k]);
        if !matches!(cable.course, Course::Air(_)) {
            return None;
        }
        let ends = own.ends().map(|v| at[v as usize]);
        Catenary::find(cable, ends, structure.up).ok().flatten()
    }

    /// Moves the vertices of the heavy cables in the air onto the catenaries between the cables' present ends.
    pub fn hang(&mut self, structure: &Structure) {
        let at = self.vertices();
        let count = self.films;
        for k in 0..self.cables.len() {
            let Some(catenary) = self.catenary(structure, k, &at) else { continue };
            let (chain, length) = (&self.cables[k].chain, catenary.length());
            for (i, &v) in chain.iter().enumerate().take(chain.len() - 1).skip(1) {
                let from_first = length * i as f64 / (chain.len() - 1) as f64;
                self.air[v as usize - count] = catenary.point(from_first);
            }
        }
    }

    /// Recomputes the start forces that follow from the shape. Their changes are damped, because the shape depends on
    /// these forces in turn and both could oscillate.
    pub fn renew_start_forces(&mut self, structure: &Structure) {
        let at = self.vertices();
        for (k, cable) in structure.cables.iter().enumerate() {
            let own = &mut self.cables[k];
            let (term, force) = (&own.term, own.start_force);
            // A shallow cable's sag is inversely proportional to its force, and the horizontal component of a force is
            // proportional to it.
            let wanted = match cable.mode {
                CableMode::Sag(sag) => force * (term.sag(&at) / sag).clamp(0.25, 4.0),
                CableMode::HorizontalComponent(wanted) => {
                    let ratio = wanted / (force * term.level_part(&at).max(LEAST_ACROSS));
                    force * ratio.clamp(0.25, 4.0)
                }
                CableMode::Length(length) if matches!(cable.course, Course::Across(_)) => {
                    let [first, last] = own.ends().map(|v| at[v as usize]);
                    let chord = first.distance(last);
                    // A shallow cable under a given load is longer than its chord by a length that is inversely
                    // proportional to the square of its force. The load of a cable across the film is the small
                    // difference between the pulls on its two sides, so that it does not follow from the tension.
                    let ratio = libm::sqrt((term.length(&at) - chord).max(0.0) / (length - chord));
                    force * if ratio.is_finite() { ratio.clamp(0.25, 4.0) } else { 4.0 }
                }
                CableMode::Length(_) => {
                    start_force(cable, structure, &term.segments, &at).clamp(0.5 * force, 2.0 * force)
                }
                _ => start_force(cable, structure, &term.segments, &at),
            };
            own.start_force += own.swing.damped(wanted - force);
        }
    }

    /// The triangles of the layers around the space below a layer, oriented so that their normals point out of this
    /// space.
    pub fn walls(&self, below: usize) -> Vec<[u32; 3]> {
        let mut walls: Vec<[u32; 3]> = self.layers[below].triangles().collect();
        if let Some(next) = self.layers.get(below + 1) {
            walls.extend(next.triangles().map(|[a, b, c]| [a, c, b]));
        }
        walls
    }

    /// The volume to add to the surface integral over the [`walls`](Self::walls) of the space below a layer. It is 0
    /// except below the last layer, where the space is open.
    fn cap(&self, below: usize) -> f64 {
        if below + 1 == self.layers.len() { self.cap_volume } else { 0.0 }
    }

    /// The volume of the space below a layer. The space ends at the next layer or, below the last layer, at fans from
    /// each boundary to its mean.
    pub fn volume(&self, below: usize, vertices: &[DVec3]) -> f64 {
        Volume { triangles: self.walls(below), pressure: -1.0 }.value(vertices) + self.cap(below)
    }

    /// The unknowns of the fixed-point iteration of a woven film: the coordinates of all vertices, then ln m of each
    /// vertex of the film, where m is the factor of the stresses. Each ln m is multiplied by an edge length, so that
    /// all unknowns are lengths.
    pub fn unknowns(&self) -> Vec<f64> {
        let mut unknowns: Vec<f64> = self.vertices().iter().flat_map(|p| p.to_array()).collect();
        let edge = self.start_edge;
        unknowns.extend(self.stress_field.iter().flat_map(|field| &field.factors).map(|factor| edge * factor));
        unknowns
    }

    /// Sets the unknowns to values that [`unknowns`](Self::unknowns) returned or to a linear combination of them.
    /// Vertices that slide are moved back to the nearest points of their supports.
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

    /// Number of flipped triangles in all layers.
    pub fn flipped(&self) -> usize {
        self.layers.iter().map(|layer| layer.film.flipped_triangles()).sum()
    }
}
