//! Form finding of structures that move far: from a coarse mesh to the neighbourhood of the equilibrium.
//!
//! The structure is settled (`plateau_equilibrium::settling`) on meshes of 300, 1,050, 3,675 … triangles until the
//! steps are short. Each of these meshes is remeshed as it moves. Several attempts are made, one after the other, until
//! one finds a shape:
//!
//! 1. bold steps,
//! 2. bold steps from a start with upright masts, if masts stand on supports ([`taut_start`](super::taut_start)),
//! 3. bold steps from a start in which the cables alone hold corners and joints,
//! 4. the gradient flow,
//! 5. bold steps while the film's tension grows,
//! 6. bold steps from a start in which the film also pulls free corners, and these corners begin drawn in,
//! 7. bold steps from a start in which the corners on supports begin on the other side of their given places from where
//!    they slid in the first attempt.
//!
//! If all attempts end because the same kind of part closes or runs away, this counts as evidence that there is
//! no equilibrium. Otherwise the question stays open.

mod ending;

use super::form_finding::{Coarse, Ending, Found, Meshes, Run, Stop};
use super::model::{FirstShape, Model, Renewal, Stage};
use super::options::{Cable, CableMode, FilmPrestress, Pressure, Sliding, SlidingPart, Structure};
use super::remeshing::Fineness;
use super::taut_start::{Held, slid_back, taut};
use super::weave::LARGEST_CHANGE;
use ending::Watch;
use plateau_equilibrium::form_finding::{self, FormFinding, Round, StopReason};
use plateau_equilibrium::settling::{Pace, Settler, energy};
use plateau_equilibrium::{Body, Determined};
use plateau_mesh::error::{InputError, Step};
use plateau_mesh::sparse::Unsolved;
use plateau_mesh::{DVec3, Error, Progress};

/// Number of triangles of the first, coarsest level. With 100 to 300 triangles random structures are found equally
/// often.
pub(super) const COARSE: f64 = 300.0;
/// Ratio of a level's number of triangles to that of the level before.
const GROWTH: f64 = 3.5;
/// A mesh is renewed after a round that moves a vertex by more than this multiple of the mean edge length. With values
/// from 0.1 to 1 random structures are found equally often.
const REMESH_ABOVE: f64 = 0.3;
/// Newton's method begins once a round moves no vertex by more than this multiple of the mean edge length. With values
/// from 0.1 to 2 random structures are found equally often.
const NEWTON_BELOW: f64 = 0.5;
/// A coarse level is left once a round moves no vertex by more than this multiple of the mean edge length.
const SETTLED: f64 = 0.05;
/// The residual at which Newton's method ends on a coarse level.
const COARSE_TOLERANCE: f64 = 1e-4;
/// Largest number of rounds of an attempt.
const MAX_ROUNDS: u32 = 400;
/// The pause before Newton's method is tried again, in rounds, is this number times one more than the number of
/// failures so far. Failures while a cable shrinks do not count. The pause grows because a round of a structure with
/// constraints takes away only a few per cent of the distance to the equilibrium.
const WAIT: u32 = 2;
/// An attempt ends after this number of rounds in a row that found no step.
const MAX_STUCK: u32 = 6;
/// The attempts. Those from a taut start and those with growing tension are made only for structures without chambers.
const ATTEMPTS: [Attempt; 7] = [
    Attempt { from: Start::Given, pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: Start::Taut(Held::UprightMasts), pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: Start::Taut(Held::Cables), pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: Start::Given, pace: Pace::CAUTIOUS, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: Start::Taut(Held::Cables), pace: Pace::BOLD, first_tension: 0.3, tension_rounds: 8 },
    Attempt { from: Start::Taut(Held::Film), pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: Start::SlidBack, pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
];
/// Maximum number of renewals of a woven film's stresses before a round.
const MAX_STRESS_RENEWALS: u32 = 8;
/// Maximum number of kicks in an attempt. A kick moves the vertices along an unstable mode.
const MAX_KICKS: u32 = 3;
/// Length of a kick, in edge lengths.
const KICK: f64 = 0.3;
/// Maximum number of failures of Newton's method in an attempt. Remeshing a shape that Newton's method
/// has reached counts as three failures.
const MAX_FAILURES: u32 = 12;
/// Largest number of remeshings that adjust the number of triangles on the last level.
const CALIBRATIONS: u32 = 4;
/// Largest relative deviation of the number of triangles from the wanted number on the last level.
const COUNT_TOLERANCE: f64 = 0.05;

/// The shape from which an attempt begins.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Start {
    /// The given shape.
    Given,
    /// The shape in which these forces hold corners, joints and hubs.
    Taut(Held),
    /// The given shape with the corners on supports on the other side of their places from where they slid.
    SlidBack,
}

/// The start and the pace of an attempt.
#[derive(Clone, Copy, Debug)]
struct Attempt {
    from: Start,
    pace: Pace,
    /// Fraction of the film's tension with which the attempt starts.
    first_tension: f64,
    /// Number of rounds in which this fraction grows to 1.
    tension_rounds: u32,
}

impl Attempt {
    /// The fraction of the film's tension in a round.
    fn tension(self, round: u32) -> f64 {
        if round >= self.tension_rounds {
            return 1.0;
        }
        self.first_tension + (1.0 - self.first_tension) * f64::from(round) / f64::from(self.tension_rounds)
    }
}

/// The state of an attempt between two rounds.
struct TravelState {
    attempt: Attempt,
    settler: Settler,
    /// Number of triangles of the present level.
    level: f64,
    /// Whether the level has just begun, so that the film must first be remeshed.
    is_fresh: bool,
    rounds: u32,
    /// Number of consecutive rounds, up to the last one, that found no step.
    stuck: u32,
    /// Newton's method is not tried before the round of this number.
    wait: u32,
    failures: u32,
    kicks: u32,
    /// Edge length of the mesh in the last round, and whether its level is the last.
    edge: f64,
    is_last: bool,
    /// The shape from which Newton's method began.
    before: Option<Model>,
}

impl TravelState {
    fn new(attempt: Attempt, level: f64) -> Self {
        Self {
            attempt,
            settler: Settler::default(),
            level,
            is_fresh: true,
            rounds: 0,
            stuck: 0,
            wait: 0,
            failures: 0,
            kicks: 0,
            edge: 0.0,
            is_last: false,
            before: None,
        }
    }

    /// Goes on to the next finer level.
    fn grow(&mut self, wanted: f64) {
        self.level = (GROWTH * self.level).min(wanted);
        self.is_fresh = true;
    }
}

/// The end of an attempt.
enum Arrival {
    /// The structure is in equilibrium on the last level.
    Found,
    /// There is no shape, or none was found.
    Lost(Ending),
}

/// Returns the ending of an attempt, or [`Ending::NotFound`] in its place if the earlier ending `known` names another
/// kind of part that closes or runs away. Endings that depend on the start are no evidence. In a symmetric structure
/// each attempt may close another of equal corners, so that the number of the part does not count.
fn agreed(known: Option<&Ending>, ending: Ending) -> Ending {
    let part = |own: &Option<InputError>| {
        let names = own.iter().flat_map(|own| &own.place.0).filter(|step| matches!(step, Step::Field(_)));
        names.cloned().collect::<Vec<_>>()
    };
    match (known, ending) {
        (
            Some(Ending::RunsAway(_, before) | Ending::Collapses(_, before)),
            Ending::RunsAway(detail, own) | Ending::Collapses(detail, own),
        ) if part(before) != part(&own) => Ending::NotFound(detail),
        (_, ending) => ending,
    }
}

/// A structure on its way, on meshes that are renewed.
struct Travelling<'r, 'a> {
    run: &'r mut Run<'a>,
    trip: TravelState,
    found: &'r mut Found,
    watch: &'r mut Watch,
}

impl FormFinding for Travelling<'_, '_> {
    type End = Arrival;
    type Error = Stop;

    fn begin(&mut self, _attempt: u32) {}

    fn round(&mut self) -> Result<Round<Self::End>, Stop> {
        self.run.settle_once(&mut self.trip, self.watch)
    }

    /// Tries Newton's method from the present shape.
    fn newton(&mut self) -> Result<StopReason, Stop> {
        let Self { run, trip, found, .. } = self;
        trip.before = Some(run.model.clone());
        let tolerance = run.options.tolerance;
        found.stop_reason =
            run.newton(found, if trip.is_last { tolerance } else { tolerance.max(COARSE_TOLERANCE) })?;
        Ok(found.stop_reason)
    }

    fn flipped_triangles(&self) -> usize {
        self.run.model.flipped()
    }

    fn accept(&mut self) -> Result<Option<Self::End>, Stop> {
        self.run.accept(&mut self.trip, self.found, self.watch)
    }

    /// Goes back to the shape from which Newton's method has failed, or renews the mesh of a woven film on which it has
    /// failed. After [`MAX_FAILURES`] failures the attempt ends.
    fn refuse(&mut self, reason: StopReason, _attempt: u32) -> Result<Option<Self::End>, Stop> {
        let Self { run, trip, found, watch } = self;
        let before = trip.before.take();
        let is_woven = run.model.stress_field.is_some();
        if is_woven
            && reason == StopReason::Stalled
            && run.model.flipped() == 0
            && run.is_worn()
            && trip.failures < MAX_FAILURES
        {
            run.renew_reached_mesh(trip, watch)?;
            return Ok(None);
        }
        if let Some(before) = before {
            *run.model = before;
        }
        if trip.failures >= MAX_FAILURES {
            let detail = format!("Newton's method does not converge: the residual is {:.1e}", found.residual);
            return Ok(Some(Arrival::Lost(Ending::NotFound(detail))));
        }
        trip.failures += u32::from(!watch.shrinks);
        trip.wait = trip.rounds + WAIT * (1 + trip.failures);
        trip.settler.restart();
        Ok(None)
    }
}

impl Run<'_> {
    /// Makes the attempts until one finds a shape. If none does, `found` gets the ending and the model gets the last
    /// shape of one of the attempts: the first attempt that leaves open whether there is a shape, or else the first of
    /// all.
    pub fn search(&mut self, coarse: Coarse, found: &mut Found) -> Result<(), Stop> {
        let start = self.model.clone();
        self.check_side()?;
        let plain = self.structure.chambers.is_empty();
        let (mut first, mut worn): (Option<(Ending, Model)>, Option<Model>) = (None, None);
        let is_woven = self.structure.weave().is_some();
        let possible = |attempt: &Attempt| {
            let is_plain_attempt = attempt.from == Start::Given && attempt.tension_rounds == 0;
            // Form finding of a woven film is slow, and the stress field sets the stresses, so that no tension grows.
            let suits_weave = attempt.pace == Pace::BOLD && attempt.tension_rounds == 0;
            (plain || is_plain_attempt) && (!is_woven || suits_weave)
        };
        let mut slid = Vec::new();
        for (number, attempt) in ATTEMPTS.into_iter().filter(possible).enumerate() {
            if number > 0 {
                self.more_solves();
            }
            let forces: Vec<f64> = start.cables.iter().map(|cable| cable.start_force).collect();
            let moved = match attempt.from {
                Start::Given => None,
                Start::Taut(held) => taut(self.structure, &forces, held),
                Start::SlidBack => slid_back(self.structure, &forces, &slid),
            };
            let moved = match moved {
                Some(moved) => self.moved_model(coarse, &start, &moved)?,
                None => None,
            };
            *self.model = match moved {
                Some(moved) => moved,
                None if attempt.from != Start::Given && attempt.tension_rounds == 0 => continue,
                None => start.clone(),
            };
            let mut watch = self.watch();
            let attempted = match self.attempt_at(attempt, found, &mut watch) {
                Err(Stop::Reason(StopReason::MaxIterations)) if self.options.max_iterations.is_none() => {
                    let detail = format!("{} linear solves of form finding were not enough", self.default_solves());
                    Some((Ending::NotFound(detail), self.model.clone()))
                }
                other => other?,
            };
            let Some((ending, last)) = attempted else {
                found.ending = None;
                return Ok(());
            };
            if number == 0 {
                slid = self.sliding_corners();
            }
            worn = worn.or(watch.worn);
            let ending = agreed(first.as_ref().map(|known| &known.0), self.judged(ending));
            // An attempt that ends with `NotFound` leaves open whether there is a shape.
            let leaves_open =
                |known: &(Ending, _)| matches!(ending, Ending::NotFound(_)) && !matches!(known.0, Ending::NotFound(_));
            if first.as_ref().is_none_or(leaves_open) {
                first = Some((ending, last));
            }
        }
        let is_open = first.as_ref().is_none_or(|(ending, _)| matches!(ending, Ending::NotFound(_)));
        if is_open && let Some(worn) = worn {
            // Remeshing this shape led to no result, because a film that hardly opens at a corner has no even mesh. The
            // shape is solved once more on the mesh that it had.
            *self.model = worn;
            self.model.order_input_first(self.structure);
            self.more_solves();
            found.stop_reason = self.newton(found, self.options.tolerance)?;
            if found.stop_reason == StopReason::Residual {
                found.ending = None;
                return Ok(());
            }
        }
        if let Some((ending, last)) = first {
            *self.model = last;
            found.ending = Some(ending);
        }
        found.stop_reason = StopReason::Stalled;
        Ok(())
    }

    /// The places of the corners on supports at the present shape, in the order of the supports.
    fn sliding_corners(&self) -> Vec<DVec3> {
        let at = self.model.vertices();
        let points = self.structure.sliding.iter().filter_map(|sliding| match sliding.part {
            SlidingPart::Point(point) => Some(point),
            SlidingPart::Edge { .. } | SlidingPart::Boundary(_) => None,
        });
        points.map(|point| at[self.model.input_vertex(point) as usize] + self.model.centre).collect()
    }

    /// The model of another start on a coarse mesh; `None` if it cannot be meshed.
    fn moved_model(&self, coarse: Coarse, start: &Model, moved: &Structure) -> Result<Option<Model>, Stop> {
        match Model::build(moved, &coarse.options, coarse.share, FirstShape::Harmonic, self.exec) {
            Ok(mut model) => {
                (0..moved.cables.len()).filter(|&k| start.is_let_go(k)).for_each(|k| model.let_go(k));
                Ok(Some(model))
            }
            Err(error @ Error::Interrupted(_)) => Err(error.into()),
            Err(_) => Ok(None),
        }
    }

    /// Returns the ending, or [`Ending::NotFound`] in place of an ending that is no evidence. A part that closes is
    /// evidence only if the cables alone have a single equilibrium, from which the taut attempts begin. With masts,
    /// curved supports, pressure or given lengths the start decides which shape is found.
    fn judged(&self, ending: Ending) -> Ending {
        let structure = self.structure;
        let flat = |sliding: &Sliding| sliding.on.is_flat();
        let by_force = |cable: &Cable| match cable.mode {
            CableMode::Force(_) | CableMode::EndTension(_) | CableMode::ForceDensity(_) => !cable.course.is_mast(),
            CableMode::UnstressedLength(_) => true,
            CableMode::HorizontalComponent(_) | CableMode::Length(_) | CableMode::Sag(_) => false,
        };
        let is_convex = structure.chambers.is_empty()
            && structure.sliding.iter().all(flat)
            && structure.cables.iter().all(by_force);
        match ending {
            Ending::Collapses(detail, _) if !is_convex => Ending::NotFound(detail),
            ending => ending,
        }
    }

    /// Fails if the film between several loops encloses a volume of the opposite sign to the one that is required.
    fn check_side(&self) -> Result<(), Stop> {
        let own = self.model.volume(0, &self.model.vertices());
        for chamber in &self.structure.chambers {
            if let Pressure::Volume(volume) = chamber.holds
                && self.structure.boundaries.len() > 1
                && own < -0.1 * volume
            {
                let place = super::options::chamber_place(self.structure, 0);
                let detail = format!(
                    "lies on the other side of the loops: the film between them encloses {own:.4} with their \
                     direction; reverse every loop"
                );
                return Err(Stop::Failed(Error::Input(vec![InputError::new(place, detail)])));
            }
        }
        Ok(())
    }

    /// The wanted number of triangles, which for a given edge length follows from the film's present area.
    fn wanted(&self) -> f64 {
        match self.options.resolution {
            plateau_minimal_surface::Resolution::EdgeLength(edge) => {
                4.0 * self.model.layers[0].film.area() / (3f64.sqrt() * edge * edge)
            }
            _ => match self.meshes {
                Meshes::Travelling(coarse) => coarse.count,
                Meshes::Kept => COARSE,
            },
        }
    }

    fn size(&self, count: f64) -> f64 {
        (4.0 * self.model.layers[0].film.area().max(f64::MIN_POSITIVE) / (3f64.sqrt() * count)).sqrt()
    }

    /// Makes one attempt. Returns the ending and the last shape if there is no result.
    fn attempt_at(
        &mut self,
        attempt: Attempt,
        found: &mut Found,
        watch: &mut Watch,
    ) -> Result<Option<(Ending, Model)>, Stop> {
        let trip = TravelState::new(attempt, COARSE.min(self.wanted()));
        Ok(match form_finding::find(&mut Travelling { run: self, trip, found, watch })? {
            Arrival::Found => None,
            Arrival::Lost(ending) => Some((ending, self.model.clone())),
        })
    }

    /// Makes one settling round, and remeshes the film if the round has moved it far. Returns the step that follows.
    fn settle_once(&mut self, trip: &mut TravelState, watch: &mut Watch) -> Result<Round<Arrival>, Stop> {
        let Attempt { pace, tension_rounds, .. } = trip.attempt;
        let is_last = trip.level >= 0.99 * self.wanted();
        trip.is_last = is_last;
        if is_last {
            trip.level = self.wanted();
        }
        let mut edge = self.size(trip.level);
        if std::mem::take(&mut trip.is_fresh) {
            self.begin_level(edge, trip.rounds == 0, is_last, watch)?;
            trip.settler.restart();
        }
        if trip.rounds >= MAX_ROUNDS {
            let detail = format!("{} rounds of form finding were not enough", trip.rounds);
            return Ok(Round::Ended(Arrival::Lost(Ending::NotFound(detail))));
        }
        trip.rounds += 1;
        self.model.hang(self.structure);
        self.renew_settling_stresses()?;
        let (mut body, complete) = self.settling_body(trip.attempt.tension(trip.rounds), edge)?;
        if trip.rounds == 1 {
            trip.settler.multipliers = self.start_multipliers(&body);
        }
        self.look()?;
        self.count_solve("settle", energy(&body, &body.vertices))?;
        let round = match trip.settler.round(&mut body, edge, pace, self.exec) {
            Ok(round) => round,
            Err(Unsolved::Interrupted(interruption)) => return Err(Error::from(interruption).into()),
            Err(Unsolved::Refused(error)) => {
                let detail = format!("nothing holds the structure: {error:?}");
                return Ok(Round::Ended(Arrival::Lost(Ending::NotFound(detail))));
            }
        };
        self.model.set_vertices(&body.vertices);
        self.model.renew_start_forces(self.structure);
        if let Some(ending) = self.ending(watch, edge) {
            return Ok(Round::Ended(Arrival::Lost(ending)));
        }
        trip.stuck = if round.fraction == 0.0 { trip.stuck + 1 } else { 0 };
        if trip.stuck >= MAX_STUCK {
            return Ok(Round::Ended(Arrival::Lost(self.stuck(watch))));
        }
        let ramping = trip.rounds < tension_rounds;
        let moves = round.moved > REMESH_ABOVE * edge;
        let is_stuck = trip.stuck > 0;
        if moves || round.fraction < 0.9 * pace.relaxation.min(1.0) && pace.accelerated || is_stuck || ramping {
            edge = self.size(trip.level);
            self.renew_mesh(edge, 1, is_last, watch)?;
            trip.settler.restart();
        }
        if ramping || moves || is_stuck || !complete || trip.rounds < trip.wait {
            return Ok(Round::Moves);
        }
        if !is_last && round.step < SETTLED * edge {
            trip.grow(self.wanted());
            return Ok(Round::Moves);
        }
        trip.edge = edge;
        Ok(if round.step >= NEWTON_BELOW * edge { Round::Moves } else { Round::Settled })
    }

    /// Remeshes the film at the beginning of a level. The last level is remeshed again while it misses the number of
    /// triangles.
    fn begin_level(&mut self, edge: f64, is_first: bool, is_last: bool, watch: &mut Watch) -> Result<(), Stop> {
        self.calibration = 1.0;
        self.renew_mesh(edge, if is_first { 3 } else { 2 }, is_last, watch)?;
        for _ in 0..CALIBRATIONS {
            if !is_last || !self.misses_count(edge) {
                break;
            }
            self.renew_mesh(edge, 1, is_last, watch)?;
        }
        Ok(())
    }

    /// Judges a shape to which Newton's method has converged. `None` if the shape is to go on: it is unstable, or its
    /// mesh is worn or too coarse.
    fn accept(
        &mut self,
        trip: &mut TravelState,
        found: &mut Found,
        watch: &mut Watch,
    ) -> Result<Option<Arrival>, Stop> {
        let (edge, is_last) = (trip.edge, trip.is_last);
        let before = trip.before.take();
        let unstable = found.stability.is_some_and(|stability| stability.least_index > 0);
        if unstable && trip.kicks < MAX_KICKS {
            trip.kicks += 1;
            self.kick(found, KICK * edge);
            trip.settler.restart();
            return Ok(None);
        }
        let is_worn = || watch.last_neck.is_some() || self.is_worn();
        if trip.failures < MAX_FAILURES && (self.travelled(before.as_ref()) > edge || is_last && is_worn()) {
            // Newton's method moves vertices along the normals, which makes bad triangles, so the mesh is renewed.
            if is_last && !unstable && watch.last_neck.is_none() {
                watch.worn = Some(self.model.clone());
            }
            self.renew_reached_mesh(trip, watch)?;
            return Ok(None);
        }
        if !is_last {
            trip.grow(self.wanted());
            return Ok(None);
        }
        if let Some(neck) = watch.last_neck {
            // A neck that is only three edges around is held open by the mesh alone.
            return Ok(Some(Arrival::Lost(self.pinched(neck))));
        }
        self.model.order_input_first(self.structure);
        found.stop_reason = self.newton(found, self.options.tolerance)?;
        Ok(Some(Arrival::Found))
    }

    /// Renews the mesh of a shape that Newton's method has reached.
    fn renew_reached_mesh(&mut self, trip: &mut TravelState, watch: &mut Watch) -> Result<(), Stop> {
        trip.failures += 3;
        self.renew_mesh(trip.edge, 2, trip.is_last, watch)?;
        trip.settler.restart();
        Ok(())
    }

    /// The largest distance of a vertex from its position in `before`.
    fn travelled(&self, before: Option<&Model>) -> f64 {
        let (old, new) = (before.map(Model::vertices).unwrap_or_default(), self.model.vertices());
        old.iter().zip(&new).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
    }

    /// Renews the stresses of a woven film. After remeshing they begin at the required ones, so that they are renewed
    /// until the balance asks for no more than one renewal may change.
    fn renew_settling_stresses(&mut self) -> Result<(), Stop> {
        let most = if self.model.stress_field.is_some() { MAX_STRESS_RENEWALS } else { 0 };
        for _ in 0..most {
            if self.renew_stresses(Renewal::Balance)? <= LARGEST_CHANGE {
                break;
            }
        }
        Ok(())
    }

    /// Returns the body of a round, and whether the volumes have their required values in this body. A round changes a
    /// volume by at most half an edge length times the film's area.
    fn settling_body(&self, tension: f64, edge: f64) -> Result<(Body, bool), Stop> {
        let mut scaled;
        let structure = if tension < 1.0 {
            scaled = self.structure.clone();
            for layer in &mut scaled.layers {
                if let FilmPrestress::Isotropic(own) = &mut layer.prestress {
                    *own *= tension;
                }
            }
            &scaled
        } else {
            self.structure
        };
        let mut body = self.model.body(structure, 1.0, Stage::Settling)?;
        let volumes =
            self.structure.chambers.iter().filter(|chamber| matches!(chamber.holds, Pressure::Volume(_))).count();
        let most = 0.5 * edge * self.model.layers[0].film.area();
        let mut complete = true;
        let count = body.constraints.len();
        for constraint in &mut body.constraints[count - volumes..] {
            if let Determined::Value(target) = &mut constraint.by {
                let own = constraint.quantity.value(&body.vertices);
                complete &= (*target - own).abs() <= most;
                *target = own + (*target - own).clamp(-most, most);
            }
        }
        Ok((body, complete))
    }

    /// The multipliers with which the rounds begin: for a cable of given length its start force, for masts and volumes
    /// 0.
    fn start_multipliers(&self, body: &Body) -> Vec<f64> {
        let lengths = (0..self.structure.cables.len()).filter(|&k| self.model.constrains_length(k));
        let mut multipliers: Vec<f64> = lengths
            .map(|k| if self.structure.cables[k].course.is_mast() { 0.0 } else { self.model.cables[k].start_force })
            .collect();
        multipliers.resize(body.constraints.len(), 0.0);
        multipliers
    }

    fn renew_mesh(&mut self, size: f64, rounds: u32, is_last: bool, watch: &mut Watch) -> Result<(), Stop> {
        let fineness = Fineness { size: self.calibration * size, rounds, all_points: is_last };
        let neck = self.model.remesh(self.structure, fineness, self.exec).map_err(Error::from)?;
        watch.necks = if neck.is_some() { watch.necks + 1 } else { 0 };
        if neck.is_some() {
            watch.worn = None;
        }
        watch.last_neck = neck;
        // Only the last level is calibrated: a coarse mesh has more triangles than are wanted where the boundary is
        // finer.
        if is_last && self.misses_count(size) {
            self.calibration = (self.calibration * self.count_ratio(size).sqrt()).clamp(0.7, 1.5);
        }
        Ok(())
    }

    /// The number of triangles over the number of equilateral triangles of edge length `size` with the same area.
    fn count_ratio(&self, size: f64) -> f64 {
        let wanted = 4.0 * self.model.layers[0].film.area() / (3f64.sqrt() * size * size);
        self.model.layers[0].film.triangles().len() as f64 / wanted
    }

    fn misses_count(&self, size: f64) -> bool {
        (self.count_ratio(size) - 1.0).abs() > COUNT_TOLERANCE
    }

    /// Moves the vertices along the lowest mode, to the side on which the energy is lower.
    fn kick(&mut self, found: &Found, length: f64) {
        let Some(mode) = &found.lowest_mode else { return };
        let at = self.model.vertices();
        let Ok((body, _)) = self.settling_body(1.0, length) else { return };
        let moved = |sign: f64| -> Vec<DVec3> {
            let place = |((v, p), d): ((usize, &DVec3), &DVec3)| {
                let place = *p + sign * length * *d;
                match body.freedoms[v].support() {
                    Some(support) => body.supports[support as usize].nearest(place),
                    None => place,
                }
            };
            at.iter().enumerate().zip(mode).map(place).collect()
        };
        let [ahead, back] = [moved(1.0), moved(-1.0)];
        let lower = if energy(&body, &ahead) <= energy(&body, &back) { ahead } else { back };
        self.model.set_vertices(&lower);
    }

    fn count_solve(&mut self, phase: &'static str, energy: f64) -> Result<(), Stop> {
        if self.solves >= self.limit {
            return Err(Stop::Reason(StopReason::MaxIterations));
        }
        self.solves += 1;
        self.fraction += 0.02 * (0.95 - self.fraction);
        self.exec.report(Progress {
            fraction: self.fraction,
            phase,
            iteration: u64::from(self.solves),
            objective_value: Some(energy),
            residual: None,
        });
        Ok(())
    }
}
