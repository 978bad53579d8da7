//! Steps 1 and 2 of a structure that keeps its mesh, as a [`FormFinding`]: rounds of the update reference strategy,
//! then Newton's method.

use super::{Found, Run, Stop};
use crate::model::{Renewal, Stage};
use crate::options::Pressure;
use plateau_equilibrium::energy::Prestress;
use plateau_equilibrium::form_finding::{self, FormFinding, Round, StopReason};
use plateau_equilibrium::{Aim, Freedom, Outcome, Settings};
use plateau_mesh::measure::normals;
use plateau_mesh::remesh::delaunay::{flip_to_delaunay, flip_without_chords, tangential_relaxation};
use plateau_mesh::{DVec3, Error};

/// Largest number of rounds of step 1. Structures of the examples settle in 4 to 15.
const MAX_ROUNDS: u32 = 60;
/// Largest number of rounds of step 1 for a woven film. It is smaller than [`MAX_ROUNDS`], because step 2 of a woven
/// film converges from a poorer shape.
const MAX_WOVEN_ROUNDS: u32 = 20;
/// Number of Newton steps of one round of step 1. More steps would only refine the equilibrium of a reference shape
/// that the next round replaces.
const STEPS_PER_ROUND: u32 = 3;
/// A round that moves no vertex by more than this fraction of the mean edge is the last.
const SETTLED: f64 = 0.05;
/// Rounds in which an enclosed volume grows to its required value.
const VOLUME_ROUNDS: u32 = 8;
/// Largest number of times that a stalled Newton iteration is followed by another step 1.
const MAX_RETURNS: u32 = 3;

/// A structure on its way to equilibrium, on a mesh that it keeps.
struct Settling<'r, 'a> {
    run: &'r mut Run<'a>,
    found: &'r mut Found,
    /// Number of the last round, from 1.
    round: u32,
    /// Number of the round after which Newton's method follows in any case.
    last_round: u32,
}

impl FormFinding for Settling<'_, '_> {
    /// `found` has the end.
    type End = ();
    type Error = Stop;

    /// After a return the volumes already have their required values.
    fn begin(&mut self, attempt: u32) {
        self.round = if attempt == 0 { 0 } else { VOLUME_ROUNDS - 1 };
        self.last_round = if self.run.model.stress_field.is_some() { MAX_WOVEN_ROUNDS } else { MAX_ROUNDS };
    }

    fn round(&mut self) -> Result<Round<()>, Stop> {
        self.round += 1;
        let settled = self.run.reference_round(self.round)?;
        Ok(if settled || self.round >= self.last_round { Round::Settled } else { Round::Moves })
    }

    fn newton(&mut self) -> Result<StopReason, Stop> {
        let reason = self.run.newton(self.found, self.run.options.tolerance)?;
        self.found.stop_reason = reason;
        Ok(reason)
    }

    fn flipped_triangles(&self) -> usize {
        self.run.model.flipped()
    }

    /// Step 3.
    fn accept(&mut self) -> Result<Option<()>, Stop> {
        self.run.balance(self.found)?;
        Ok(Some(()))
    }

    fn refuse(&mut self, reason: StopReason, attempt: u32) -> Result<Option<()>, Stop> {
        let may_return = matches!(reason, StopReason::Stalled | StopReason::MaxIterations) && attempt < MAX_RETURNS;
        Ok((!may_return).then_some(()))
    }
}

impl Run<'_> {
    /// Makes steps 1 to 3 on the present mesh. `found` gets the end.
    pub(super) fn settle_and_solve(&mut self, found: &mut Found) -> Result<(), Stop> {
        form_finding::find(&mut Settling { run: self, found, round: 0, last_round: 0 })
    }

    /// Makes a round of step 1 from the present shape as the reference. Returns whether the structure has settled.
    fn reference_round(&mut self, round: u32) -> Result<bool, Stop> {
        let settings = Settings { aim: Aim::Minimum, tolerance: 1e-6, max_steps: STEPS_PER_ROUND };
        let by_volume = self.structure.chambers.iter().any(|chamber| matches!(chamber.holds, Pressure::Volume(_)));
        let grown = f64::from(round.min(VOLUME_ROUNDS)) / f64::from(VOLUME_ROUNDS);
        self.model.hang(self.structure);
        // The stresses vary even if their magnitudes are to be held. Otherwise the vertices of a film whose stresses
        // cannot be in equilibrium would move within it from round to round.
        self.renew_stresses(Renewal::Balance)?;
        let mut body = self.model.body(self.structure, grown, Stage::Reference)?;
        self.look()?;
        let before = body.vertices.clone();
        if self.model.stress_field.is_none() {
            for ((term, layer), film) in body.terms.iter_mut().zip(&self.model.layers).zip(&self.structure.layers) {
                let (triangles, tension) = (layer.triangles().collect::<Vec<_>>(), film.mean());
                *term = Box::new(Prestress::isotropic(&triangles, |_| tension, &before));
            }
        }
        for freedom in &mut body.freedoms {
            if *freedom == Freedom::Normal {
                *freedom = Freedom::Free;
            }
        }
        let (outcome, _) = self.solve(&mut body, &settings, "settle", 0.02)?;
        let moved = self.largest_motion(&before, &body.vertices);
        self.model.set_vertices(&body.vertices);
        self.model.renew_start_forces(self.structure);
        let flip = if self.model.layers.len() > 1 { flip_without_chords } else { flip_to_delaunay };
        for k in 0..self.model.layers.len() {
            self.look()?;
            flip(&mut self.model.layers[k].film, self.exec).map_err(Error::from)?;
            self.look()?;
            tangential_relaxation(&mut self.model.layers[k].film, 1);
            flip(&mut self.model.layers[k].film, self.exec).map_err(Error::from)?;
        }
        self.look()?;
        if matches!(outcome, Outcome::Refused(_)) {
            return Err(Stop::Reason(StopReason::Collapsed));
        }
        let grown = !by_volume || round >= VOLUME_ROUNDS;
        Ok(grown && moved <= SETTLED * self.model.mean_edge())
    }

    /// The largest distance between two positions of a vertex. Inside a woven film it is that along the normal, because
    /// vertices may move within the film from round to round although the shape has settled.
    fn largest_motion(&self, before: &[DVec3], after: &[DVec3]) -> f64 {
        let film = &self.model.layers[0].film;
        let normals = match self.model.stress_field {
            Some(_) => normals(before, film.triangles()),
            None => Vec::new(),
        };
        let distance = |(v, (a, b)): (usize, (&DVec3, &DVec3))| match normals.get(v) {
            Some(normal) if film.fixed.get(v) == Some(&false) => (*b - *a).dot(*normal).abs(),
            _ => a.distance(*b),
        };
        before.iter().zip(after).enumerate().map(distance).fold(0.0, f64::max)
    }
}
