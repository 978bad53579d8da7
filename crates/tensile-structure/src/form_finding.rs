//! From the initial mesh to the shape in equilibrium.
//!
//! 1. *Settle*: a structure whose edges or corners move does so on meshes that are renewed ([`travel`](super::travel)).
//!    Others keep their mesh: rounds of the update reference strategy
//!    ([`prestress`](plateau_equilibrium::energy::prestress)) replace the film's area by the quadratic energy of its
//!    present shape, in which every vertex inside moves freely. Between the rounds edges are flipped and vertices slide
//!    within the film. If a woven film with moving edges is not found in this way, it travels as well.
//! 2. *Newton*: the energy itself. Vertices inside the film move along their normals and those of a cable across it,
//!    until the residual is small. The mean height of a heavy film, at which its tension is the required one, is
//!    renewed between solves. Then the stability is analysed. A woven film has no energy whose minimum its shape could
//!    be: each step takes the shape before it as the reference, and the stresses are renewed between steps
//!    ([`weave`](super::weave)) until they have settled, accelerated by Anderson's mixing, until the forces at the
//!    reference shape itself balance.
//! 3. *Balance*: the shape becomes the reference of a last solve in which all vertices move in all directions. It moves
//!    the vertices within the film, by less than the mesh's error, until the forces balance at every vertex and in
//!    every direction. The stress then deviates from the constant one; the statistics say by how much.

mod balance;
mod settle;

use super::mixing::Mixing;
use super::model::{ForceBy, Model, Renewal, Stage};
use super::options::{CableMode, Chamber, Course, Options, Pressure, Structure, WeaveHold};
use super::remeshing::WORN_ANGLE;
use super::weave::StressField;
use plateau_equilibrium::energy::{PlaneStress, Term};
use plateau_equilibrium::form_finding::StopReason;
use plateau_equilibrium::motion::Frame;
use plateau_equilibrium::newton::{Direct, State, keeps_orientation};
use plateau_equilibrium::{Aim, Body, Outcome, Settings, Stability};
use plateau_mesh::codes::Reason;
use plateau_mesh::error::InputError;
use plateau_mesh::execution::WORK_PER_TRIANGLE;
use plateau_mesh::sparse::LinearError;
use plateau_mesh::{DVec3, Error, Execution, Interruption, Progress, measure};

// Tunables.

/// Largest number of linear solves of an attempt if the caller gives none.
const DEFAULT_SOLVES: u32 = 400;
/// The same for a woven film that travels. Each of its reference shapes holds the film's edges back, so that the number
/// of reference shapes grows with the fineness of the mesh: a sail took 118 at 300 triangles and 280 at 1,050.
const DEFAULT_WOVEN_SOLVES: u32 = 1600;
/// Largest number of Newton steps of one solve of step 2.
const NEWTON_STEPS: u32 = 30;
/// Largest number of renewals: of the mean height of a heavy film, and of the list of slack cables.
const MAX_RENEWALS: u32 = 60;
/// Largest number of reference shapes of a woven film in step 2. The examples take 15 to 60.
const MAX_REFERENCES: u32 = 300;
/// The same for a film that travels.
const MAX_TRAVELLING_REFERENCES: u32 = 800;
/// The stresses of a woven film are kept from the first renewal on that changes none by more than this fraction. The
/// forces that are not balanced within the film by then are far below the mesh's error, and step 3 removes them. With a
/// smaller value the renewals go on without use: stresses that alternate from vertex to vertex hardly pull on the film,
/// so they change slowly, and each change disturbs the shape. With 1e-7 instead of 1e-4 the example conic-tent took 135
/// more solves.
const STRESSES_SETTLED: f64 = 3e-5;
/// The reference shapes of a woven film stand still once a round moves its vertices, in the root mean square, by less
/// than this multiple of the tolerance times the edge length. Where the forces balance, the last round moved the
/// vertices by about 0.1 times the tolerance times the edge length.
const STILL: f64 = 2e-3;
/// Newton steps of the balance, which is linear but for a pressure.
const BALANCE_STEPS: u32 = 12;
/// The residual to which forces are balanced.
const BALANCED: f64 = 1e-12;
/// Largest number of times that the weights and the force densities of cables are renewed on the balanced mesh. Two
/// renewals are enough for the examples.
const RENEWALS: u32 = 6;
/// Largest difference between the given force of a cable and the mean force of its segments in the balanced mesh,
/// relative to the given force. It is half of the difference that the audit allows.
pub(super) const SAME_FORCE: f64 = 1e-3;
/// The weights are not renewed again if the largest change of a vertex's load, relative to the largest load, is at most
/// this.
const SAME_LOADS: f64 = 1e-11;

/// How a search without a result ended.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Ending {
    /// A vertex moves away without end; its place in the input if it has one.
    RunsAway(String, Option<InputError>),
    /// A part closes; its place in the input if it has one.
    Collapses(String, Option<InputError>),
    /// The rounds are used up, or no step keeps the mesh.
    NotFound(String),
}

/// The shape that was found.
#[derive(Debug)]
pub(super) struct Found {
    pub stop_reason: StopReason,
    /// The residual of step 2.
    pub residual: f64,
    pub iterations: u32,
    pub stability: Option<Stability>,
    /// Displacements of the vertices in the lowest mode.
    pub lowest_mode: Option<Vec<DVec3>>,
    /// The pressure in each chamber, given or found.
    pub pressures: Vec<f64>,
    /// Per cable the part of its force that is the multiplier of its length.
    pub length_forces: Vec<f64>,
    /// Step 3, if step 2 converged.
    pub balance: Option<Balance>,
    /// Cables across the film whose given length is not reached, so that they bear no force in this shape.
    pub slack: Vec<usize>,
    /// How the search ended, if it found no shape.
    pub ending: Option<Ending>,
}

/// A shape whose residual is above the tolerance but not above this value is returned as not converged. Beyond it there
/// is no shape to return.
const NEARLY: f64 = 1e-3;

impl Found {
    /// No shape yet.
    fn nothing(cables: usize, chambers: usize) -> Self {
        Self {
            stop_reason: StopReason::Stalled,
            residual: f64::INFINITY,
            iterations: 0,
            stability: None,
            lowest_mode: None,
            pressures: vec![0.0; chambers],
            length_forces: vec![0.0; cables],
            balance: None,
            slack: Vec::new(),
            ending: None,
        }
    }

    /// Whether the form finding ended without having used up its solves or its time.
    pub fn gave_up(&self) -> bool {
        matches!(self.stop_reason, StopReason::Stalled | StopReason::Collapsed)
    }

    /// Whether the shape is an equilibrium up to the tolerance or nearly so.
    pub fn is_shape(&self) -> bool {
        match self.stop_reason {
            StopReason::Residual => true,
            StopReason::Stalled | StopReason::MaxIterations => self.residual <= NEARLY,
            _ => false,
        }
    }
}

/// The balanced shape's forces.
#[derive(Debug)]
pub(super) struct Balance {
    /// Per vertex the force that film and cables exert less the loads: at a support the reaction, elsewhere the
    /// imbalance.
    pub forces: Vec<DVec3>,
    /// Per vertex the gradient of the energies of given contact angles: what the supports bear along their surface. It
    /// is part of the reaction, so `forces` are without it.
    pub contacts: Vec<DVec3>,
    /// Per vertex the load: weights and pressure.
    pub loads: Vec<DVec3>,
    /// Per cable the force of each segment.
    pub cable_forces: Vec<Vec<f64>>,
    /// Per vertex its position in the reference shape, which is the shape before the balance.
    pub reference: Vec<DVec3>,
    /// Per triangle, one layer after the other, the stress in the reference shape: the required one.
    pub stresses: Vec<PlaneStress>,
}

/// State of a run.
pub(super) struct Run<'a> {
    pub structure: &'a Structure,
    pub options: &'a Options,
    pub exec: &'a Execution<'a>,
    pub model: &'a mut Model,
    pub solves: u32,
    pub limit: u32,
    pub fraction: f64,
    pub meshes: Meshes,
    /// Factor on the edge length at which remeshing comes to the wanted number of triangles; 1 if all were equilateral.
    pub calibration: f64,
    /// The symbolic factorisation and the storage of the last solve.
    pub factor: Option<Direct>,
}

/// The meshes on which the shape is found.
#[derive(Clone, Copy, Debug)]
pub(super) enum Meshes {
    /// The initial mesh.
    Kept,
    /// A coarse mesh, which is renewed and becomes finer as the structure moves.
    Travelling(Coarse),
}

/// The mesh with which a structure begins to travel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coarse {
    /// Number of triangles that are wanted in the end.
    pub count: f64,
    /// The options of the first mesh.
    pub options: Options,
    /// The length of the edges of the last mesh over those of the first.
    pub share: f64,
}

/// Why a phase ended early.
pub(super) enum Stop {
    Reason(StopReason),
    Failed(Error),
}

impl From<Error> for Stop {
    fn from(error: Error) -> Self {
        match error {
            Error::Interrupted(Interruption::DeadlinePassed) => Self::Reason(StopReason::Deadline),
            error => Self::Failed(error),
        }
    }
}

fn too_large(error: LinearError) -> Error {
    Error::no_result(Reason::TooLarge, format!("the linear system is too large: {error:?}"))
}

/// Finds the shape. The model's vertices become those of the shape.
///
/// # Errors
/// The cancel; [`Error::NoResult`] for a mesh that is too large.
pub(super) fn run(
    model: &mut Model,
    structure: &Structure,
    options: &Options,
    meshes: Meshes,
    exec: &Execution,
) -> Result<Found, Error> {
    let mut run = Run {
        structure,
        options,
        exec,
        model,
        solves: 0,
        limit: 0,
        fraction: 0.0,
        meshes,
        calibration: 1.0,
        factor: None,
    };
    run.limit = options.max_iterations.unwrap_or(run.default_solves());
    let start = run.model.clone();
    let mut found = run.attempt()?;
    run.release_slack(&start, &mut found)?;
    found.iterations = run.solves;
    Ok(found)
}

impl Run<'_> {
    /// Allows another attempt its solves, if the caller gave no limit.
    pub fn more_solves(&mut self) {
        if self.options.max_iterations.is_none() {
            self.limit = self.solves + self.default_solves();
        }
    }

    fn travels(&self) -> bool {
        matches!(self.meshes, Meshes::Travelling(_))
    }

    /// Largest number of linear solves of an attempt if the caller gives none.
    pub fn default_solves(&self) -> u32 {
        if self.travels() && self.model.stress_field.is_some() { DEFAULT_WOVEN_SOLVES } else { DEFAULT_SOLVES }
    }

    /// Makes steps 1 to 3 from the model's present shape.
    fn attempt(&mut self) -> Result<Found, Error> {
        let mut found = Found::nothing(self.structure.cables.len(), self.structure.chambers.len());
        match self.shape(&mut found) {
            Ok(()) => {}
            Err(Stop::Reason(reason)) => found.stop_reason = reason,
            Err(Stop::Failed(error)) => return Err(error),
        }
        if !found.residual.is_finite() {
            self.measure(&mut found)?;
        }
        Ok(found)
    }

    /// If no shape was found, looks for the one in which cables across the film are slack. A cable that is longer than
    /// the film needs would have to push. It buckles, and Newton's method does not converge.
    ///
    /// The shape is found again from the `start` without the forces of all cables of given length. Released cables that
    /// become longer than their given length bear a force, so they are put back, and the shape is found once more. When
    /// all released cables are shorter than their given length, they are slack. If no shape of this kind is found, the
    /// model and `found` stay as they were.
    fn release_slack(&mut self, start: &Model, found: &mut Found) -> Result<(), Error> {
        let structure = self.structure;
        let length = |k: usize| match (&structure.cables[k].course, structure.cables[k].mode) {
            (Course::Across(_), CableMode::Length(length) | CableMode::UnstressedLength(length)) => Some(length),
            _ => None,
        };
        let gave_up = found.gave_up() || found.stop_reason == StopReason::MaxIterations;
        let stands = |found: &Found, model: &Model| found.is_shape() && model.flipped() == 0;
        if !gave_up || stands(found, self.model) {
            return Ok(());
        }
        let mut released: Vec<usize> = (0..structure.cables.len()).filter(|&k| length(k).is_some()).collect();
        let first = self.model.clone();
        // At most one pass per cable, because fewer cables are released in each pass.
        while !released.is_empty() {
            *self.model = start.clone();
            released.iter().for_each(|&k| self.model.let_go(k));
            self.more_solves();
            let loose = self.attempt()?;
            if !stands(&loose, self.model) {
                break;
            }
            let at = self.model.vertices();
            let count = released.len();
            released.retain(|&k| length(k).is_some_and(|length| self.model.cables[k].term.length(&at) <= length));
            if released.len() == count {
                *found = Found { slack: released, ..loose };
                return Ok(());
            }
        }
        *self.model = first;
        Ok(())
    }

    fn shape(&mut self, found: &mut Found) -> Result<(), Stop> {
        if let Meshes::Travelling(coarse) = self.meshes {
            self.search(coarse, found)?;
            if found.is_shape() && self.model.flipped() == 0 {
                self.balance(found)?;
            }
            return Ok(());
        }
        self.settle_and_solve(found)
    }

    /// The residual of a shape that was left before Newton's method began.
    fn measure(&mut self, found: &mut Found) -> Result<(), Error> {
        let mut body = self.model.body(self.structure, 1.0, Stage::Exact)?;
        let settings = Settings { max_steps: 0, ..Settings::default() };
        let (_, state) =
            body.solve_once(&settings, &Execution::default(), &mut |_, _| {}, &mut self.factor).map_err(too_large)?;
        found.residual = state.residual;
        Ok(())
    }

    /// Solves the body and returns the outcome with the last state. Each step is reported as progress and takes `share`
    /// of the remaining fraction.
    fn solve(
        &mut self,
        body: &mut Body,
        settings: &Settings,
        phase: &'static str,
        share: f64,
    ) -> Result<(Outcome, State<Frame>), Stop> {
        let left = self.limit.saturating_sub(self.solves);
        if left == 0 {
            return Err(Stop::Reason(StopReason::MaxIterations));
        }
        let settings = Settings { max_steps: settings.max_steps.min(left), ..*settings };
        let (exec, mut solves, mut fraction) = (self.exec, self.solves, self.fraction);
        let mut record = |energy: f64, residual: f64| {
            solves += 1;
            fraction += share * (0.95 - fraction);
            exec.report(Progress {
                fraction,
                phase,
                iteration: u64::from(solves),
                objective_value: Some(energy),
                residual: Some(residual),
            });
        };
        let solved = body.solve_once(&settings, exec, &mut record, &mut self.factor);
        let solved = solved.map_err(|error| Stop::Failed(too_large(error)))?;
        (self.solves, self.fraction) = (solves, fraction);
        match solved.0 {
            Outcome::Interrupted(interruption) => Err(Error::Interrupted(interruption).into()),
            _ => Ok(solved),
        }
    }

    pub fn look(&self) -> Result<(), Stop> {
        let count: usize = self.model.layers.iter().map(|layer| layer.film.triangles().len()).sum();
        self.exec.look(WORK_PER_TRIANGLE * count as u64).map_err(|interruption| Stop::from(Error::from(interruption)))
    }

    pub fn renew_stresses(&mut self, renewal: Renewal) -> Result<f64, Stop> {
        self.model.renew_stresses(self.structure, renewal).map_err(|error| match error {
            LinearError::TooLarge => Stop::Failed(too_large(error)),
            _ => Stop::Reason(StopReason::Collapsed),
        })
    }

    /// Step 2 for a woven film.
    fn renew_references(&mut self, found: &mut Found, tolerance: f64) -> Result<StopReason, Stop> {
        let settings = Settings { aim: Aim::Minimum, tolerance, max_steps: 1 };
        let mut renewal = match self.model.stress_field.as_ref().map(StressField::hold) {
            Some(WeaveHold::Ratio) => Renewal::Balance,
            _ => Renewal::Required,
        };
        let mut mixing = Mixing::default();
        for _ in 0..if self.travels() { MAX_TRAVELLING_REFERENCES } else { MAX_REFERENCES } {
            self.look()?;
            let start = self.model.unknowns();
            let change = self.renew_stresses(renewal)?;
            if renewal == Renewal::Balance && change <= STRESSES_SETTLED {
                // From here on only the shape changes. Each renewal would disturb it by more than the tolerance.
                renewal = Renewal::Keep;
                mixing.clear();
            }
            let mut body = self.model.body(self.structure, 1.0, Stage::Exact)?;
            let solves = self.solves;
            let (outcome, state) = self.solve(&mut body, &settings, "newton", 0.05)?;
            self.model.set_vertices(&body.vertices);
            self.multipliers(&state, found);
            match StopReason::after(outcome).map_err(Error::from)? {
                // Without a step the residual is that of the reference shape itself.
                StopReason::Residual if self.solves == solves => {
                    found.residual = state.residual;
                    if self.slacken(found) || renewal == Renewal::Balance {
                        continue;
                    }
                    let flipped = self.model.flipped() > 0;
                    return Ok(if flipped { StopReason::Stalled } else { StopReason::Residual });
                }
                StopReason::Residual | StopReason::MaxIterations => {}
                reason => {
                    self.measure(found)?;
                    return Ok(reason);
                }
            }
            let reached = self.model.unknowns();
            if self.travels() && self.is_still(&start, &reached, tolerance) && self.is_worn() {
                // The shape has been found, but a triangle has become so flat that the force at one of its vertices is
                // large for the vertex's area. The mesh has to be renewed.
                self.measure(found)?;
                return Ok(StopReason::Stalled);
            }
            let mixed = mixing.next(start, reached.clone());
            self.model.set_unknowns(&mixed);
            if !keeps_orientation(self.model.layers[0].film.triangles(), &body.vertices, &self.model.vertices()) {
                self.model.set_unknowns(&reached);
                mixing.clear();
            }
        }
        self.measure(found)?;
        Ok(StopReason::MaxIterations)
    }

    /// Whether a round that led from one shape to another has moved the vertices by next to nothing.
    fn is_still(&self, start: &[f64], reached: &[f64], tolerance: f64) -> bool {
        let squares: f64 = start.iter().zip(reached).map(|(a, b)| (a - b) * (a - b)).sum();
        let vertices = self.model.layers[0].film.vertices.len() as f64;
        (squares / vertices).sqrt() < STILL * tolerance * self.model.start_edge
    }

    /// Whether the film has a triangle that is so flat that the mesh has to be renewed.
    pub fn is_worn(&self) -> bool {
        measure::angle_range(&self.model.layers[0].film.mesh()).1 > WORN_ANGLE
    }

    /// Step 2.
    pub fn newton(&mut self, found: &mut Found, tolerance: f64) -> Result<StopReason, Stop> {
        if self.model.stress_field.is_some() {
            return self.renew_references(found, tolerance);
        }
        let settings = Settings { aim: Aim::Minimum, tolerance, max_steps: NEWTON_STEPS };
        for _ in 0..MAX_RENEWALS {
            let mut body = self.model.body(self.structure, 1.0, Stage::Exact)?;
            let mut weights = self.model.weights(self.structure, &body.vertices);
            let (outcome, state) = self.solve(&mut body, &settings, "newton", 0.05)?;
            self.model.set_vertices(&body.vertices);
            found.residual = state.residual;
            self.multipliers(&state, found);
            let reason = StopReason::after(outcome).map_err(Error::from)?;
            if reason != StopReason::Residual {
                return Ok(reason);
            }
            let change = if self.structure.has_heavy_layers() {
                weights.iter_mut().map(|weight| weight.renew(&body.vertices)).fold(0.0, f64::max)
            } else {
                0.0
            };
            if self.slacken(found) {
                continue;
            }
            if change <= tolerance.max(1e-12) {
                if self.model.flipped() > 0 {
                    return Ok(StopReason::Stalled);
                }
                return self.stability(found);
            }
        }
        Ok(StopReason::MaxIterations)
    }

    /// Lets elastic cables that would push go slack. Returns whether there are any.
    fn slacken(&mut self, found: &mut Found) -> bool {
        let mut any = false;
        for (k, force) in found.length_forces.iter_mut().enumerate() {
            if *force < 0.0 && matches!(self.model.cables[k].by, ForceBy::Elastic { .. }) {
                self.model.let_go(k);
                *force = 0.0;
                any = true;
            }
        }
        any
    }

    /// The stability of the converged shape.
    fn stability(&mut self, found: &mut Found) -> Result<StopReason, Stop> {
        // The analysis has a factor of its own, and two at once would take twice the memory.
        self.factor = None;
        let mut body = self.model.body(self.structure, 1.0, Stage::Exact)?;
        // The terms' own renewals end at once, because the coefficients have just been renewed.
        let settings = Settings {
            aim: Aim::Stationary,
            tolerance: 2.0 * found.residual.max(self.options.tolerance),
            max_steps: 2,
        };
        let report = body
            .relax(&settings, self.exec, &mut |_, _| {})
            .map_err(|defect| Stop::Failed(Error::no_result(Reason::InvalidMesh, defect.to_string())))?;
        if let Outcome::Interrupted(interruption) = report.outcome {
            return Err(Error::Interrupted(interruption).into());
        }
        found.stability = report.stability;
        found.lowest_mode = report.lowest_mode;
        Ok(StopReason::Residual)
    }

    /// The constraints' multipliers: the forces of cables of given length, and the pressures of given volumes.
    fn multipliers(&self, state: &State<Frame>, found: &mut Found) {
        let mut multipliers = state.constraints.iter().map(|constraint| constraint.multiplier);
        for (force, cable) in found.length_forces.iter_mut().zip(&self.model.cables) {
            if cable.by != ForceBy::Law {
                *force = multipliers.next().unwrap_or(0.0);
            }
        }
        found.pressures = self.pressures(multipliers);
    }

    /// The pressure in each chamber, with the multipliers of the given volumes.
    fn pressures(&self, mut of_volumes: impl Iterator<Item = f64>) -> Vec<f64> {
        let pressure = |chamber: &Chamber| match chamber.holds {
            Pressure::Constant(pressure) => pressure,
            Pressure::Volume(_) => of_volumes.next().unwrap_or(0.0),
        };
        self.structure.chambers.iter().map(pressure).collect()
    }
}
