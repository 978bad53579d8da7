//! Step 3 of the form finding: the balance of the forces at every vertex and in every direction.

use super::{BALANCE_STEPS, BALANCED, Balance, Found, RENEWALS, Run, SAME_FORCE, SAME_LOADS, Stop};
use crate::model::{ForceBy, ModelCable, Stage};
use crate::options::Pressure;
use plateau_equilibrium::energy::cable::Law;
use plateau_equilibrium::energy::{self, ForceDensity, Load, PlaneStress, Prestress, Term, Volume};
use plateau_equilibrium::motion::Frame;
use plateau_equilibrium::newton::State;
use plateau_equilibrium::{Aim, Body, Constraint, Determined, Freedom, Outcome, Settings};
use plateau_mesh::DVec3;
use plateau_mesh::measure::double_area_vector;

/// Forces of the found shape, which the balance does not change.
struct Given {
    /// Per triangle, one layer after the other, the stress in the reference shape.
    stresses: Vec<PlaneStress>,
    /// Per cable its force densities.
    densities: Vec<ForceDensity>,
    /// The masts that push with a given force.
    pushing: Vec<usize>,
}

impl Run<'_> {
    /// Runs step 3. If the solver refuses the linear system, `found` stays without a balance.
    pub(super) fn balance(&mut self, found: &mut Found) -> Result<(), Stop> {
        let mut body = self.model.body(self.structure, 1.0, Stage::Exact)?;
        let reference = body.vertices.clone();
        let mut given = self.given(&reference, found);
        let mut loads = self.loads(&reference);
        let place = self.hold_forces(&mut body, &given, &loads, &reference);
        let settings = Settings { aim: Aim::Stationary, tolerance: BALANCED, max_steps: BALANCE_STEPS };
        let (mut outcome, mut state) = self.solve(&mut body, &settings, "balance", 0.2)?;
        // The balance moves vertices along the film, so the weights and the densities of given forces are renewed until
        // they belong to the mesh that is returned.
        for _ in 0..RENEWALS {
            let renewed = self.loads(&body.vertices);
            let change = renewed.iter().zip(&loads).map(|(new, old)| new.distance(*old)).fold(0.0, f64::max);
            let largest = loads.iter().map(|load| load.length()).fold(0.0, f64::max);
            let missed = self.scale_to_given_forces(&mut given.densities, &body.vertices);
            if matches!(outcome, Outcome::Refused(_)) || change <= SAME_LOADS * largest && missed.is_empty() {
                break;
            }
            loads = renewed;
            body.terms[place] = Box::new(Load { forces: loads.clone() });
            for k in missed {
                body.terms[place + 1 + k] = Box::new(given.densities[k].clone());
            }
            (outcome, state) = self.solve(&mut body, &settings, "balance", 0.2)?;
        }
        if matches!(outcome, Outcome::Refused(_)) {
            return Ok(());
        }
        let (more, pressures) = self.found_multipliers(&state, &given.pushing);
        let at = &body.vertices;
        let mut forces = state.frame.gradient;
        self.load_walls(&pressures, at, &mut loads, &mut forces);
        let mut contacts = vec![DVec3::ZERO; at.len()];
        self.model.contacts.iter().for_each(|contact| contact.add_gradient(at, &mut contacts));
        forces.iter_mut().zip(&contacts).for_each(|(force, contact)| *force -= *contact);
        let mut cable_forces = Vec::with_capacity(more.len());
        for (own, more) in given.densities.iter().zip(more) {
            let mut forces = Vec::with_capacity(own.segments.len());
            own.visit_forces(at, &mut |force| forces.push(force + more));
            cable_forces.push(forces);
        }
        found.pressures = pressures;
        self.model.set_vertices(&body.vertices);
        let stresses = given.stresses;
        found.balance = Some(Balance { forces, contacts, loads, cable_forces, reference, stresses });
        Ok(())
    }

    fn given(&self, reference: &[DVec3], found: &Found) -> Given {
        let mut densities = Vec::with_capacity(self.model.cables.len());
        for (ModelCable { term: cable, further_forces, .. }, multiplier) in
            self.model.cables.iter().zip(&found.length_forces)
        {
            let mut own = ForceDensity { segments: cable.segments.clone(), densities: Vec::new() };
            for (k, &segment) in cable.segments.iter().enumerate() {
                let length = energy::length::length(segment, reference);
                let further = further_forces.get(k).copied().unwrap_or(0.0);
                own.densities.push((cable.force(k, reference) + multiplier + further) / length);
            }
            densities.push(own);
        }
        let cables = &self.structure.cables;
        let pushes = |&k: &usize| cables[k].course.is_mast() && self.model.cables[k].by == ForceBy::Law;
        let pushing = (0..densities.len()).filter(pushes).collect();
        Given { stresses: self.reference_stresses(reference), densities, pushing }
    }

    /// Scales the force densities of each cable of given force whose segments miss this force by more than
    /// [`SAME_FORCE`] in the mean. Returns the numbers of these cables. A corner that slides may move so far in the
    /// balance that the lengths of its cables change.
    fn scale_to_given_forces(&self, densities: &mut [ForceDensity], at: &[DVec3]) -> Vec<usize> {
        let mut missed = Vec::new();
        for (k, (own, cable)) in densities.iter_mut().zip(&self.model.cables).enumerate() {
            let Law::Force(force) = cable.term.law else { continue };
            // The force of a heavy cable changes along it, and its mode says where it has the given value.
            if self.structure.cables[k].weight > 0.0 || force <= 0.0 || !cable.further_forces.is_empty() {
                continue;
            }
            let lengths = || own.segments.iter().map(|&segment| energy::length::length(segment, at));
            let moment: f64 = lengths().zip(&own.densities).map(|(length, density)| density * length * length).sum();
            let factor = force * lengths().sum::<f64>() / moment;
            if factor.is_finite() && (factor - 1.0).abs() > SAME_FORCE {
                own.densities.iter_mut().for_each(|density| *density *= factor);
                missed.push(k);
            }
        }
        missed
    }

    /// Replaces the energies of the body by those of the given forces, and lets its vertices move in all directions.
    /// Returns the index of the load among the terms.
    fn hold_forces(&self, body: &mut Body, given: &Given, loads: &[DVec3], reference: &[DVec3]) -> usize {
        let Given { stresses, densities, pushing } = given;
        body.terms.clear();
        // Force densities give the forces of the cables, so only the constraints of given lengths and volumes stay.
        body.constraints.retain(|constraint| matches!(constraint.by, Determined::Value(_)));
        // A mast that pushes with a given force is held at the length that was found. With a force density in its place
        // all forces would be linear in the positions, and a mast between two free ends would shrink to nothing.
        for (place, &k) in pushing.iter().enumerate() {
            let quantity = energy::Length { segments: densities[k].segments.clone(), tension: -1.0 };
            let held = Constraint::value(Box::new(quantity.clone()), quantity.value(reference));
            // Before the volumes, which come last.
            let lengths = self.model.cables.iter().filter(|cable| matches!(cable.by, ForceBy::Length(_))).count();
            body.constraints.insert(lengths + place, held);
        }
        let triangles = self.model.triangles();
        body.terms.push(Box::new(match &self.model.stress_field {
            None => Prestress::isotropic(&triangles, |t| stresses[t].along, reference),
            Some(_) => Prestress::plane(&triangles, |t| stresses[t], reference),
        }));
        let place = body.terms.len();
        body.terms.push(Box::new(Load { forces: loads.to_vec() }));
        densities.iter().for_each(|own| body.terms.push(Box::new(own.clone())));
        self.model.contacts.iter().for_each(|contact| body.terms.push(Box::new(contact.clone())));
        for chamber in &self.structure.chambers {
            if let Pressure::Constant(pressure) = chamber.holds {
                body.terms.push(Box::new(Volume { triangles: self.model.walls(chamber.below), pressure }));
            }
        }
        for freedom in &mut body.freedoms {
            *freedom = match *freedom {
                Freedom::Normal | Freedom::Across(_) => Freedom::Free,
                Freedom::AcrossOn { support, .. } => Freedom::On(support),
                other => other,
            };
        }
        place
    }

    /// Returns the force that the constraint of its length adds to each cable, 0 without a constraint, and the pressure
    /// in each chamber.
    fn found_multipliers(&self, state: &State<Frame>, pushing: &[usize]) -> (Vec<f64>, Vec<f64>) {
        let mut multipliers = state.constraints.iter().map(|constraint| constraint.multiplier);
        let mut more = vec![0.0; self.model.cables.len()];
        let by_length = (0..more.len()).filter(|&k| matches!(self.model.cables[k].by, ForceBy::Length(_)));
        for k in by_length.chain(pushing.iter().copied()) {
            more[k] = multipliers.next().unwrap_or(0.0);
        }
        (more, self.pressures(multipliers))
    }

    /// Adds the pressures on the triangles to the loads. The gradient of a volume includes the cone over the film's
    /// edge, but a pressure acts only on the triangles. In `forces` the gradient of the volume is therefore replaced by
    /// the pressure on the triangles.
    fn load_walls(&self, pressures: &[f64], at: &[DVec3], loads: &mut [DVec3], forces: &mut [DVec3]) {
        let chambers = self.structure.chambers.iter().zip(pressures);
        for (chamber, &pressure) in chambers.filter(|(_, pressure)| **pressure != 0.0) {
            let walls = self.model.walls(chamber.below);
            let mut cone = vec![DVec3::ZERO; at.len()];
            Volume { triangles: walls.clone(), pressure: -1.0 }.add_gradient(at, &mut cone);
            for triangle in &walls {
                let sixth = double_area_vector(triangle.map(|v| at[v as usize])) / 6.0;
                for &v in triangle {
                    loads[v as usize] += pressure * sixth;
                    forces[v as usize] -= pressure * sixth;
                }
            }
            forces.iter_mut().zip(&cone).for_each(|(force, cone)| *force += pressure * *cone);
        }
    }

    /// The weights of films and cables and the forces on rings, as a force on each vertex.
    fn loads(&self, at: &[DVec3]) -> Vec<DVec3> {
        let structure = self.structure;
        let mut loads = self.model.film_loads(structure, at);
        if let Some(forces) = self.model.ring_forces(structure) {
            loads.iter_mut().zip(forces).for_each(|(load, force)| *load += force);
        }
        for ModelCable { term: cable, .. } in &self.model.cables {
            for &segment in &cable.segments {
                let half = structure.up * (0.5 * cable.weight * energy::length::length(segment, at));
                segment.into_iter().for_each(|v| loads[v as usize] -= half);
            }
        }
        loads
    }

    /// Per triangle, one layer after the other, the stress that is required at the found shape.
    fn reference_stresses(&self, at: &[DVec3]) -> Vec<PlaneStress> {
        let weights = self.model.weights(self.structure, at);
        let mut stresses = Vec::new();
        for ((layer, film), weight) in self.model.layers.iter().zip(&self.structure.layers).zip(&weights) {
            let tension = film.mean();
            stresses.extend(layer.triangles().map(|triangle| match &self.model.stress_field {
                Some(field) => field.required(&triangle, at),
                None => {
                    let [a, b, _] = triangle.map(|v| at[v as usize]);
                    let tension = tension + weight.tension(&triangle, at);
                    PlaneStress { direction: (b - a).normalize_or_zero(), along: tension, across: tension }
                }
            }));
        }
        stresses
    }
}
