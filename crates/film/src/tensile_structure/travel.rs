//! From a coarse mesh to the neighbourhood of the equilibrium, however far it is.
//!
//! The structure is settled (`equilibrium::settling`) on meshes of 300, 1,050, 3,675 … triangles, each of them
//! remeshed as it moves, until the steps are short. Attempts follow each other until one finds a shape:
//!
//! 1. bold steps,
//! 2. bold steps from a start with upright masts, if masts stand on supports ([`taut_start`](super::taut_start)),
//! 3. bold steps from a start in which the cables alone hold corners and joints,
//! 4. the gradient flow,
//! 5. bold steps while the film's tension grows,
//! 6. bold steps from a start in which the film counts where corners are free, and corners begin drawn in.
//!
//! Only if all attempts end with a part that closes or a vertex that runs away does that count as evidence that there
//! is no equilibrium.

use super::form_finding::{Coarse, DEFAULT_SOLVES, Ending, Found, Run, Stop};
use super::model::{Model, ModelCable, Stage};
use super::options::{Cable, CableMode, Course, FilmPrestress, Pressure, Sliding, SlidingPart, cable_place};
use super::remeshing::Fineness;
use super::taut_start::{Held, taut};
use crate::equilibrium::settling::{Pace, Settler, energy};
use crate::equilibrium::{Body, Determined};
use crate::minimal_surface::StopReason;
use plateau_mesh::error::InputError;
use plateau_mesh::remesh::moving::Neck;
use plateau_mesh::{DVec3, Error, Place, Progress, measure};

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
/// A mesh with an angle above this one (in radians: 137°) is renewed once Newton's method has converged on the mesh.
const WORN: f64 = 2.4;
/// A cable of given force counts as shrinking only below this length, in spans. Its forces cannot balance before it has
/// shrunk to nothing or found its length, so a failure of Newton's method on the way is not counted.
const SHORT: f64 = 0.2;
/// A cable counts as shrinking if a round leaves it shorter than this fraction of its length before.
const SHRINKS: f64 = 0.97;
/// Largest number of rounds of an attempt.
const MAX_ROUNDS: u32 = 400;
/// Newton's method is tried again after this number of rounds times one more than the number of failures so far, among
/// which those while a cable shrinks do not count. The pause grows because a round of a structure with constraints
/// takes away only a few per cent of the distance to the equilibrium.
const WAIT: u32 = 2;
/// An attempt ends after this number of rounds in a row that found no step.
const MAX_STUCK: u32 = 6;
/// Consecutive rounds in which a corner or a narrow place goes on closing before it counts as closed.
const CLOSING: u32 = 10;
/// A corner below this angle, in degrees, may be closing. Sharp corners open again, so the angle alone decides nothing.
const CLOSES: f64 = 3.0;
/// A corner counts as closed if it stays below this angle, in degrees, for [`STAYS_CLOSED`] rounds.
const CLOSED: f64 = 0.2;
const STAYS_CLOSED: u32 = 3;
/// The attempts. Those from a taut start and those with growing tension are made only for structures without chambers.
const ATTEMPTS: [Attempt; 6] = [
    Attempt { from: None, pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: Some(Held::UprightMasts), pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: Some(Held::Cables), pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: None, pace: Pace::CAUTIOUS, first_tension: 1.0, tension_rounds: 0 },
    Attempt { from: Some(Held::Cables), pace: Pace::BOLD, first_tension: 0.3, tension_rounds: 8 },
    Attempt { from: Some(Held::Film), pace: Pace::BOLD, first_tension: 1.0, tension_rounds: 0 },
];
/// A vertex runs away beyond this distance from the start's centre, in radii of the start.
const FAR: f64 = 20.0;
/// Largest number of kicks along an unstable mode, and their length in edges.
const MAX_KICKS: u32 = 3;
const KICK: f64 = 0.3;
/// Failures of Newton's method that an attempt may have. Remeshing a converged shape counts as three.
const MAX_FAILURES: u32 = 12;
/// Largest number of remeshings that adjust the number of triangles on the last level.
const CALIBRATIONS: u32 = 4;
/// The number of triangles is met within this fraction.
const COUNT_TOLERANCE: f64 = 0.05;

/// The start and the pace of an attempt.
#[derive(Clone, Copy, Debug)]
struct Attempt {
    /// The taut start from which the attempt begins; `None` for the given one.
    from: Option<Held>,
    pace: Pace,
    /// Fraction of the film's tension at the start, and the number of rounds in which it grows to 1.
    first_tension: f64,
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

/// Figures that an attempt follows from round to round to see whether a part closes or shrinks to nothing.
struct Watch {
    centre: DVec3,
    radius: f64,
    span: f64,
    area: f64,
    least_angle: f64,
    closing: u32,
    closed: u32,
    narrow: Option<Strait>,
    last_width: f64,
    pinching: u32,
    necks: u32,
    last_neck: Option<Neck>,
    /// A shape in equilibrium on the last level, whose mesh is to be renewed. It has no neck.
    worn: Option<Model>,
    compressed: u32,
    /// The length of the shortest cable of given force in the air, and whether it is shrinking.
    shortest: f64,
    shrinks: bool,
}

/// The narrowest place between two sides of the film.
#[derive(Clone, Copy)]
struct Strait {
    /// The width over the distance from the nearest corner.
    ratio: f64,
    width: f64,
    place: DVec3,
}

impl Run<'_> {
    /// Makes the attempts until one finds a shape. If none does, `found` gets the ending and the model the last shape
    /// of the first attempt, or of the first one that leaves open whether there is a shape.
    pub fn search(&mut self, coarse: Coarse, found: &mut Found) -> Result<(), Stop> {
        let start = self.model.clone();
        self.check_side()?;
        let plain = self.structure.chambers.is_empty();
        let (mut first, mut worn): (Option<(Ending, Model)>, Option<Model>) = (None, None);
        let possible = |attempt: &Attempt| plain || attempt.from.is_none() && attempt.tension_rounds == 0;
        for (number, attempt) in ATTEMPTS.into_iter().filter(possible).enumerate() {
            if number > 0 {
                self.more_solves();
            }
            let taut = match attempt.from {
                Some(held) => self.taut_model(coarse, &start, held)?,
                None => None,
            };
            *self.model = match taut {
                Some(taut) => taut,
                None if attempt.from.is_some() && attempt.tension_rounds == 0 => continue,
                None => start.clone(),
            };
            let mut watch = self.watch();
            let attempted = match self.attempt_at(attempt, found, &mut watch) {
                Err(Stop::Reason(StopReason::MaxIterations)) if self.options.max_iterations.is_none() => {
                    let detail = format!("{DEFAULT_SOLVES} linear solves of form finding were not enough");
                    Some((Ending::NotFound(detail), self.model.clone()))
                }
                other => other?,
            };
            let Some((ending, last)) = attempted else {
                found.ending = None;
                return Ok(());
            };
            worn = worn.or(watch.worn);
            let ending = self.judged(ending);
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

    /// The first mesh of a taut start, if there is one.
    fn taut_model(&self, coarse: Coarse, start: &Model, held: Held) -> Result<Option<Model>, Stop> {
        let forces: Vec<f64> = start.cables.iter().map(|cable| cable.start_force).collect();
        let Some(structure) = taut(self.structure, &forces, held) else { return Ok(None) };
        match Model::build(&structure, &coarse.options, coarse.share, self.exec) {
            Ok(mut model) => {
                (0..structure.cables.len()).filter(|&k| start.is_let_go(k)).for_each(|k| model.let_go(k));
                Ok(Some(model))
            }
            Err(error @ Error::Interrupted(_)) => Err(error.into()),
            Err(_) => Ok(None),
        }
    }

    /// A part that closes is evidence only if the cables alone have a single equilibrium, from which the taut attempts
    /// begin. With masts, curved supports, pressure or given lengths the start decides which shape is found.
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

    /// The number of triangles that are wanted at the present area.
    fn wanted(&self) -> f64 {
        match self.options.resolution {
            crate::minimal_surface::Resolution::EdgeLength(edge) => {
                4.0 * self.model.layers[0].film.area() / (3f64.sqrt() * edge * edge)
            }
            _ => self.coarse.map_or(COARSE, |coarse| coarse.count),
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
        let pace = attempt.pace;
        let mut settler = Settler::default();
        let mut level = COARSE.min(self.wanted());
        let (mut rounds, mut stuck, mut wait, mut failures, mut kicks) = (0, 0, 0, 0, 0);
        let mut fresh = true;
        loop {
            let is_last = level >= 0.99 * self.wanted();
            if is_last {
                level = self.wanted();
            }
            let mut edge = self.size(level);
            if fresh {
                self.calibration = 1.0;
                let passes = if rounds == 0 { 3 } else { 2 };
                self.renew_mesh(edge, passes, is_last, watch)?;
                for _ in 0..CALIBRATIONS {
                    if !is_last || !self.misses_count(edge) {
                        break;
                    }
                    self.renew_mesh(edge, 1, is_last, watch)?;
                }
                settler.restart();
                fresh = false;
            }
            if rounds >= MAX_ROUNDS {
                let detail = format!("{rounds} rounds of form finding were not enough");
                return Ok(Some((Ending::NotFound(detail), self.model.clone())));
            }
            rounds += 1;
            self.model.hang(self.structure);
            let (mut body, complete) = self.settling_body(attempt.tension(rounds), edge)?;
            if rounds == 1 {
                settler.multipliers = self.start_multipliers(&body);
            }
            self.look()?;
            self.count_solve("settle", energy(&body, &body.vertices))?;
            let round = match settler.round(&mut body, edge, pace) {
                Ok(round) => round,
                Err(error) => {
                    let detail = format!("nothing holds the structure: {error:?}");
                    return Ok(Some((Ending::NotFound(detail), self.model.clone())));
                }
            };
            self.model.set_vertices(&body.vertices);
            self.model.renew_start_forces(self.structure);
            if let Some(ending) = self.ending(watch, edge) {
                return Ok(Some((ending, self.model.clone())));
            }
            stuck = if round.fraction == 0.0 { stuck + 1 } else { 0 };
            if stuck >= MAX_STUCK {
                return Ok(Some((self.stuck(watch), self.model.clone())));
            }
            let ramping = rounds < attempt.tension_rounds;
            let moves = round.moved > REMESH_ABOVE * edge;
            if moves || round.fraction < 0.9 * pace.relaxation.min(1.0) && pace.accelerated || stuck > 0 || ramping {
                edge = self.size(level);
                self.renew_mesh(edge, 1, is_last, watch)?;
                settler.restart();
            }
            if ramping || moves || stuck > 0 || !complete || rounds < wait {
                continue;
            }
            if !is_last && round.step < SETTLED * edge {
                level = (GROWTH * level).min(self.wanted());
                fresh = true;
                continue;
            }
            if round.step >= NEWTON_BELOW * edge {
                continue;
            }
            let before = self.model.clone();
            let tolerance = self.options.tolerance;
            let reason = self.newton(found, if is_last { tolerance } else { tolerance.max(COARSE_TOLERANCE) })?;
            found.stop_reason = reason;
            let whole = self.model.flipped() == 0;
            match reason {
                StopReason::Residual if whole => {
                    let unstable = found.stability.is_some_and(|stability| stability.least_index > 0);
                    if unstable && kicks < MAX_KICKS {
                        kicks += 1;
                        self.kick(found, KICK * edge);
                        settler.restart();
                        continue;
                    }
                    let largest_angle = || measure::angle_range(&self.model.layers[0].film.mesh()).1;
                    let is_worn = || watch.last_neck.is_some() || largest_angle() > WORN;
                    if failures < MAX_FAILURES && (self.travelled(&before) > edge || is_last && is_worn()) {
                        // Newton's method moves vertices along the normals, which makes bad triangles, so the mesh is
                        // renewed.
                        failures += 3;
                        if is_last && !unstable && watch.last_neck.is_none() {
                            watch.worn = Some(self.model.clone());
                        }
                        self.renew_mesh(edge, 2, is_last, watch)?;
                        settler.restart();
                        continue;
                    }
                    if !is_last {
                        level = (GROWTH * level).min(self.wanted());
                        fresh = true;
                        continue;
                    }
                    if let Some(neck) = watch.last_neck {
                        // A neck that is only three edges around is held open by the mesh alone.
                        return Ok(Some((self.pinched(neck), self.model.clone())));
                    }
                    self.model.order_input_first(self.structure);
                    let again = self.newton(found, tolerance)?;
                    found.stop_reason = again;
                    return Ok(None);
                }
                StopReason::Residual | StopReason::Stalled | StopReason::Collapsed | StopReason::MaxIterations
                    if failures < MAX_FAILURES =>
                {
                    failures += u32::from(!watch.shrinks);
                    wait = rounds + WAIT * (1 + failures);
                    *self.model = before;
                    settler.restart();
                }
                _ => {
                    let detail = format!("Newton's method does not converge: the residual is {:.1e}", found.residual);
                    *self.model = before;
                    return Ok(Some((Ending::NotFound(detail), self.model.clone())));
                }
            }
        }
    }

    /// The largest distance between a vertex and where it was.
    fn travelled(&self, before: &Model) -> f64 {
        let (old, new) = (before.vertices(), self.model.vertices());
        old.iter().zip(&new).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
    }

    /// The body of a round, and whether all volumes have their required values in it. A round changes a volume by at
    /// most half an edge length times the film's area.
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

    /// The multipliers with which the rounds begin: the forces of the cables of given length.
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

    fn watch(&self) -> Watch {
        let at = self.model.vertices();
        let centre = plateau_mesh::polyline::mean(&at);
        let radius = at.iter().map(|p| p.distance(centre)).fold(0.0, f64::max);
        let (low, high) = at.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(l, h), p| (l.min(*p), h.max(*p)));
        Watch {
            centre,
            radius,
            span: low.distance(high),
            area: self.model.layers[0].film.area(),
            least_angle: f64::INFINITY,
            closing: 0,
            closed: 0,
            narrow: None,
            last_width: f64::INFINITY,
            pinching: 0,
            necks: 0,
            last_neck: None,
            worn: None,
            compressed: 0,
            shortest: f64::INFINITY,
            shrinks: false,
        }
    }

    /// The ending of the attempt if the present shape shows that it cannot succeed; `None` if the attempt goes on.
    fn ending(&self, watch: &mut Watch, edge: f64) -> Option<Ending> {
        let at = self.model.vertices();
        let place = |p: DVec3| {
            let DVec3 { x, y, z } = p + self.model.centre;
            format!("({x:.4}, {y:.4}, {z:.4})")
        };
        let distances = at.iter().map(|p| p.distance(watch.centre)).enumerate();
        let (v, distance) = distances.max_by(|a, b| a.1.total_cmp(&b.1))?;
        if distance.is_nan() || distance > FAR * watch.radius {
            let detail = format!(
                "a vertex runs away: it is at {}, {:.0} times the radius of the start from its centre",
                place(at[v]),
                distance / watch.radius
            );
            let own = self.place_of(v as u32).map(|place| InputError::new(place, "runs away"));
            return Some(Ending::RunsAway(detail, own));
        }
        if let Some(ending) = self.corner(watch, &at, &place) {
            return Some(ending);
        }
        self.narrowest(watch, &at, edge);
        if watch.pinching >= CLOSING
            && let Some(strait) = watch.narrow
        {
            let detail = format!("the film pinches off: it is {:.3e} wide near {}", strait.width, place(strait.place));
            return Some(Ending::Collapses(detail, None));
        }
        if watch.necks >= 6
            && let Some(neck) = watch.last_neck
        {
            return Some(self.pinched(neck));
        }
        let mut shortest = f64::INFINITY;
        for (k, cable) in self.structure.cables.iter().enumerate() {
            let length = self.model.cables[k].term.length(&at);
            if matches!(cable.course, Course::Air(_)) && !self.model.holds_length(k) {
                shortest = shortest.min(length);
            }
            let least = if matches!(cable.course, Course::Air(_) | Course::Mast(_)) { 1e-3 } else { 1e-2 };
            if length < least * watch.span && !self.model.holds_length(k) {
                let detail = format!("cable {} shrinks to nothing: its length is {length:.3e}", cable.name);
                // The error names the end of the cable if that end moves, because its place is wrong, not the cable.
                let end = self.model.cables[k].ends().into_iter().find_map(|v| self.place_of(v));
                let own = match end {
                    Some(end) => InputError::new(end, format!("moves to the other end of cable {}", cable.name)),
                    None => InputError::new(cable_place(self.structure, k), "shrinks to nothing"),
                };
                return Some(Ending::Collapses(detail, Some(own)));
            }
        }
        watch.shrinks = shortest < (SHRINKS * watch.shortest).min(SHORT * watch.span);
        watch.shortest = shortest;
        let area = self.model.layers[0].film.area();
        if area < 1e-4 * watch.area {
            return Some(Ending::Collapses(format!("the film shrinks to an area of {area:.3e}"), None));
        }
        if self.structure.has_heavy_layers() {
            let weights = self.model.weights(self.structure, &at);
            let least = self.model.triangles().iter().map(|t| weights[0].tension(t, &at)).fold(0.0, f64::min);
            let tension = self.structure.layers[0].mean() + least;
            watch.compressed = if tension <= 0.0 { watch.compressed + 1 } else { 0 };
            if watch.compressed >= 5 {
                let detail = format!(
                    "the film's lowest part would be in compression: its weight leaves a tension of {tension:.4}"
                );
                let own = InputError::new(Place::field("film").then("weight"), "is more than the tension bears");
                return Some(Ending::Collapses(detail, Some(own)));
            }
        }
        None
    }

    /// The ending of a film that closes at a neck.
    fn pinched(&self, neck: Neck) -> Ending {
        let DVec3 { x, y, z } = neck.place + self.model.centre;
        let girth = neck.girth;
        Ending::Collapses(
            format!("the film pinches off at a neck of girth {girth:.4} near ({x:.4}, {y:.4}, {z:.4})"),
            None,
        )
    }

    /// The ending of a film that closes at a corner; `None` if it does not close.
    fn corner(&self, watch: &mut Watch, at: &[DVec3], place: &dyn Fn(DVec3) -> String) -> Option<Ending> {
        let mut angles = vec![0.0; at.len()];
        for triangle in self.model.layers[0].film.triangles() {
            for k in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|i| at[triangle[(k + i) % 3] as usize]);
                angles[triangle[k] as usize] += libm::atan2((b - a).cross(c - a).length(), (b - a).dot(c - a));
            }
        }
        let corners = self.model.corners();
        let &(v, boundary, point) =
            corners.iter().min_by(|a, b| angles[a.0 as usize].total_cmp(&angles[b.0 as usize]))?;
        let angle = angles[v as usize].to_degrees();
        watch.closing = if angle < CLOSES && angle <= 1.02 * watch.least_angle { watch.closing + 1 } else { 0 };
        watch.closed = if angle < CLOSED { watch.closed + 1 } else { 0 };
        watch.least_angle = angle;
        (watch.closing >= CLOSING || watch.closed >= STAYS_CLOSED).then(|| {
            let detail = format!(
                "the film closes at point {point} of boundary {boundary}, at {}: its sides meet at {angle:.2} degrees",
                place(at[v as usize])
            );
            // A support does not move: the other end of one of its two sides has moved too far.
            let ends = self.model.cables.iter().map(ModelCable::ends);
            let other = |[a, b]: [u32; 2]| if a == v { Some(b) } else { (b == v).then_some(a) };
            let own = self
                .place_of(v)
                .or_else(|| ends.filter_map(other).find_map(|end| self.place_of(end)))
                .unwrap_or_else(|| Place::field("boundaries").at(boundary).at(point));
            Ending::Collapses(detail, Some(InputError::new(own, "the film closes at this point or beside it")))
        })
    }

    /// Returns the place in the input of a vertex that can move: a joint, a hub, a free point or a sliding point.
    /// `None` for other vertices.
    fn place_of(&self, v: u32) -> Option<Place> {
        let structure = self.structure;
        let hubs = structure.rings.iter().enumerate().filter(|(_, ring)| ring.hub.is_some());
        let in_the_air = (v as usize).checked_sub(self.model.films);
        let joined = hubs.map(|(k, _)| Place::field("rings").at(k));
        let mut joined = joined.chain((0..structure.joints.len()).map(|k| Place::field("joints").at(k)));
        let free = || self.model.free.iter().position(|&own| own == v).map(|k| Place::field("free_points").at(k));
        let is_here = |point| self.model.input_vertex(point) == v;
        let slides = |sliding: &Sliding| matches!(sliding.part, SlidingPart::Point(point) if is_here(point));
        let sliding = || structure.sliding.iter().position(slides).map(|k| Place::field("supports").at(k));
        match in_the_air {
            Some(k) => joined.nth(k),
            None => free().or_else(sliding),
        }
    }

    /// Finds the narrowest chord between two sides and follows its width in `watch`.
    fn narrowest(&self, watch: &mut Watch, at: &[DVec3], edge: f64) {
        let topology = &self.model.layers[0].film.topology;
        let kept: Vec<DVec3> = self.model.corners().iter().map(|corner| at[corner.0 as usize]).collect();
        let mut narrow = None::<Strait>;
        for h in 0..topology.twin.len() as u32 {
            let (a, b) = (topology.from(h), topology.to(h));
            if topology.twin[h as usize] <= h
                || topology.hinge(h).is_none()
                || !topology.is_boundary(a)
                || !topology.is_boundary(b)
            {
                continue;
            }
            let middle = 0.5 * (at[a as usize] + at[b as usize]);
            let distance = kept.iter().map(|p| p.distance(middle)).fold(watch.span, f64::min);
            let width = at[a as usize].distance(at[b as usize]);
            if distance > 1.5 * edge && narrow.is_none_or(|known| width / distance < known.ratio) {
                narrow = Some(Strait { ratio: width / distance, width, place: middle });
            }
        }
        let thin = narrow.filter(|strait| strait.ratio < 0.03 && strait.width < 0.15 * edge);
        let goes_on = thin.is_some_and(|strait| strait.width <= 1.05 * watch.last_width);
        watch.pinching = if goes_on { watch.pinching + 1 } else { 0 };
        watch.last_width = thin.map_or(f64::INFINITY, |strait| strait.width);
        watch.narrow = narrow;
    }

    /// The ending of an attempt in which no step keeps the mesh.
    fn stuck(&self, watch: &Watch) -> Ending {
        let narrow = watch.narrow.filter(|strait| strait.ratio < 0.03);
        if watch.least_angle < CLOSES {
            let detail = format!("the film closes at a corner: its sides meet at {:.2} degrees", watch.least_angle);
            return Ending::Collapses(detail, None);
        }
        match narrow {
            Some(strait) => {
                let DVec3 { x, y, z } = strait.place + self.model.centre;
                let detail =
                    format!("the film pinches off: it is {:.3e} wide near ({x:.4}, {y:.4}, {z:.4})", strait.width);
                Ending::Collapses(detail, None)
            }
            None => Ending::NotFound("no step of the form finding keeps the mesh whole".into()),
        }
    }
}
