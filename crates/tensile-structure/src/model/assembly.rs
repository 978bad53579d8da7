//! Assembles the body of a structure at the present shape of its model: the energies of films, cables, contacts,
//! weights and chambers.

use super::cable_force::ForceBy;
use super::{Layer, Model, ModelCable, Renewal, Stage};
use crate::options::{Course, FilmStress, Pressure, Structure, chamber_place};
use crate::weave::pulls_along;
use plateau_equilibrium::energy::cable::CableCondition;
use plateau_equilibrium::energy::{self, Load, Term, Volume, Weight};
use plateau_equilibrium::{Body, BodyDefect, Constraint, Determined, Freedom};
use plateau_mesh::codes::Reason;
use plateau_mesh::complex::Complex;
use plateau_mesh::sparse::LinearError;
use plateau_mesh::{DVec3, Error, Place, measure};

/// Lower bound of the force of a segment of a heavy cable at the start, as a fraction of the cable's mean force. The
/// bound is needed because the start may be far from equilibrium. In equilibrium no part of a cable pushes.
const LEAST_FORCE: f64 = 0.1;
/// Largest stiffness EA of a cable while the structure settles, in estimated forces of the cable. A stiffer cable turns
/// the slightest excess of its length into a force that no step survives. The cable of this stiffness is longer by a
/// hundred-thousandth, which Newton's method corrects with the given stiffness.
const STIFFEST: f64 = 1e5;

impl Model {
    /// Builds the body with the terms of the structure, those of the layers first. In this body a chamber of given
    /// volume is required to have `grown` times that volume.
    pub fn body(&self, structure: &Structure, grown: f64, stage: Stage) -> Result<Body, Error> {
        let mut body = self.films_as_body(structure)?;
        self.set_freedoms(&mut body, structure);
        self.add_loads(&mut body, structure);
        for k in 0..self.cables.len() {
            self.add_cable(&mut body, structure, k, stage);
        }
        let before = body.constraints.len();
        let by_volume = self.add_chambers(&mut body, structure, grown);
        body.check().map_err(|defect| match defect {
            BodyDefect::Target(constraint) => Error::input(
                constraint
                    .checked_sub(before)
                    .map_or(Place::field("cables"), |k| chamber_place(structure, by_volume[k])),
                "cannot be told from an empty one; move the boundaries or change it",
            ),
            other => Error::no_result(Reason::InvalidMesh, other.to_string()),
        })?;
        Ok(body)
    }

    /// A body of the layers alone, whose boundaries are fixed.
    fn films_as_body(&self, structure: &Structure) -> Result<Body, Error> {
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
        Ok(body)
    }

    /// Sets the freedoms of the vertices in the air and of those on cables, free points, rings and supports.
    fn set_freedoms(&self, body: &mut Body, structure: &Structure) {
        for (k, &fixed) in self.air_fixed.iter().enumerate() {
            body.freedoms[self.films + k] = if fixed { Freedom::Fixed } else { Freedom::Free };
        }
        for (k, ModelCable { chain, .. }) in self.cables.iter().enumerate() {
            // A slack cable across the film moves with the film, so its vertices keep the freedom of film vertices.
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
        body.supports.clone_from(&self.supports);
        for &(v, freedom) in &self.sliding {
            body.freedoms[v as usize] = freedom;
        }
    }

    /// Adds the forces on rings, the energies of edges with a contact angle, and the weights of the layers.
    fn add_loads(&self, body: &mut Body, structure: &Structure) {
        if let Some(forces) = self.ring_forces(structure) {
            body.terms.push(Box::new(Load { forces }));
        }
        for contact in &self.contacts {
            body.terms.push(Box::new(contact.clone()));
        }
        if structure.has_heavy_layers() {
            // The stress field alone determines the stresses of a woven film, so the film's weight is a load that
            // changes no stress.
            if self.stress_field.is_some() {
                body.terms.push(Box::new(Load { forces: self.film_loads(structure, &body.vertices) }));
            } else {
                for weight in self.weights(structure, &body.vertices) {
                    body.terms.push(Box::new(weight));
                }
            }
        }
    }

    /// Adds the energy of a cable and the constraint that determines its force, if there is one.
    fn add_cable(&self, body: &mut Body, structure: &Structure, k: usize, stage: Stage) {
        let ModelCable { term: cable, by, further_forces, .. } = &self.cables[k];
        // A cable of a single segment in the air is always straight, so its length is a constraint from the start.
        let by_length = matches!(by, ForceBy::Length(_) | ForceBy::Elastic { .. });
        let at_start = match stage {
            // Where a chain is straight, its length has no gradient across the chain, so it cannot be a constraint yet.
            Stage::Settling => match *by {
                ForceBy::Equation(_) => true,
                ForceBy::Length(_) => cable.segments.len() > 1,
                ForceBy::Law | ForceBy::Elastic { .. } => false,
            },
            Stage::Reference => !(by_length && cable.segments.len() == 1),
            Stage::Exact => false,
        };
        if at_start {
            self.add_start(body, structure, k);
            return;
        }
        body.terms.push(Box::new(cable.clone()));
        for (&segment, &tension) in cable.segments.iter().zip(further_forces) {
            body.terms.push(Box::new(energy::Length { segments: vec![segment], tension }));
        }
        let determined = match *by {
            ForceBy::Law => return,
            ForceBy::Length(length) => Determined::Value(-length),
            ForceBy::Elastic { unstressed, stiffness } => {
                let stiffness = match stage {
                    Stage::Settling => {
                        stiffness.min(STIFFEST * self.cables[k].start_force.max(structure.pull() * unstressed))
                    }
                    Stage::Reference | Stage::Exact => stiffness,
                };
                Determined::Yielding { value: -unstressed, compliance: unstressed / stiffness }
            }
            ForceBy::Equation(equation) => {
                Determined::Condition(Box::new(CableCondition { cable: cable.clone(), equation }))
            }
        };
        // With the tension -1 the multiplier is the force.
        let quantity = Box::new(energy::Length { segments: cable.segments.clone(), tension: -1.0 });
        body.constraints.push(Constraint { quantity, by: determined });
    }

    /// Adds the pressures and the given volumes of the chambers. Returns the chambers whose volume is given, in the
    /// order of their constraints.
    fn add_chambers(&self, body: &mut Body, structure: &Structure, grown: f64) -> Vec<usize> {
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
        by_volume
    }

    /// Adds a cable to the body with its start force. The condition that determines the final force is left out.
    fn add_start(&self, body: &mut Body, structure: &Structure, k: usize) {
        let ModelCable { term: cable, by, start_force: force, .. } = &self.cables[k];
        if *by == ForceBy::Law {
            body.terms.push(Box::new(cable.clone()));
            return;
        }
        let force = *force;
        if cable.weight == 0.0 {
            body.terms.push(Box::new(energy::Length { segments: cable.segments.clone(), tension: force }));
            return;
        }
        // The energy of a heavy cable has no minimum while the force is too small for the sag. Force densities and a
        // load that are computed at the present shape take its place.
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

    /// The weight term of each layer. Heights are measured from the layer's mean height at these positions.
    pub fn weights(&self, structure: &Structure, vertices: &[DVec3]) -> Vec<Weight> {
        let weight = |(layer, film): (&Layer, &FilmStress)| {
            Weight::new(layer.triangles().collect(), film.weight, structure.up, vertices)
        };
        self.layers.iter().zip(&structure.layers).map(weight).collect()
    }

    /// The external forces on the rings, as a force on each vertex. The vertices of a ring share its force equally.
    /// `None` if all of these forces are 0.
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

    /// Renews the stresses of a woven film by the given rule, then the forces that the film's pull adds to the segments
    /// of the cables. Returns the largest relative change of a stress, or 0 if the film is not woven.
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
        for (cable, own) in structure.cables.iter().zip(&mut self.cables) {
            if cable.course.ends_in_the_air().is_none() {
                own.further_forces = pulls_along(&own.chain, cable.mode, &pull, &at);
            }
        }
        Ok(change)
    }
}
