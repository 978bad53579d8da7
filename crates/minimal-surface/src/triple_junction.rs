//! Films whose sheets meet three by three along curves (Plateau's first law: at 120°). Bento and Cavalcanti leave them
//! as future work. The initial mesh has such edges, and the topology stays.
//!
//! 1. Read the sheets and the junctions ([`Complex`](plateau_mesh::complex::Complex)). Every edge has one triangle
//!    (boundary), two, or three (junction).
//! 2. Rounds of Pinkall and Polthier's solve on the whole film ([`harmonic`](super::harmonic)) and remeshing
//!    ([`sheets`](plateau_mesh::remesh::sheets)).
//! 3. Rounds of Newton steps and remeshing, then Newton steps alone, until the residuals of the sheets and of the
//!    junctions are below the tolerance. The film is a [`Body`](plateau_equilibrium::Body): a vertex inside a sheet
//!    moves along its normal, a vertex of a junction across its curve, and a vertex where junctions meet in all
//!    directions.
//!
//! The three forces on a junction are the area gradients of the sheets. Where they balance, unit sheets meet at 120°;
//! the angles themselves are not prescribed. They are measured in two ways: between the facets at each junction edge,
//! with an error of order h on a curved sheet, and between the forces of the sheets at each junction vertex, with an
//! error of order h².
//!
//! Near the end of a junction the second measure does not converge. If the wires leave the end at angles other than
//! 120°, the film need not tend to a cone there, and its direction changes at every scale. The deviation at the vertex
//! next to an end is therefore reported separately.

mod angles;
mod film;
mod wires;

use super::harmonic::Dirichlet;
use super::initial_mesh::InitialMeshKind;
use super::junction_statistics::JunctionStatistics;
use super::options::{Method, Objective, Options, Solver};
use super::outcome::{ConstraintVertices, MinimalSurface};
use super::run::{Record, Run};
use super::statistics::{self, Facts, MeanCurvature, Origin};
use angles::junction_statistics;
use film::JunctionFilm;
use plateau_equilibrium::form_finding::{self, FormFinding, Round, StopReason};
use plateau_equilibrium::motion::{Frame, Motion};
use plateau_equilibrium::newton::{Direct, Equations, State};
use plateau_equilibrium::residual::curvature;
use plateau_equilibrium::stability;
use plateau_equilibrium::{Aim, Freedom, Settings};
use plateau_mesh::codes::WarningCode;
use plateau_mesh::complex::VertexKind;
use plateau_mesh::error::{InputError, Warning};
use plateau_mesh::execution::WORK_PER_TRIANGLE;
use plateau_mesh::measure::Quality;
use plateau_mesh::remesh::sheets::{even_out, flipped_triangles};
use plateau_mesh::sparse::Unsolved;
use plateau_mesh::{DVec3, Error, Execution, Interruption, Mesh, Place, polyline};
use wires::Wires;

/// Largest number of Newton steps and harmonic solves of a run if the caller gives none.
const DEFAULT_STEPS: u32 = 200;
/// Largest number of Newton steps before each remeshing of step 3.
const STEPS_PER_ROUND: u32 = 4;
/// Largest number of rounds in step 2, and again in step 3.
const ROUNDS: u32 = 10;
/// The rounds of step 3 end when the residual is below this and the remeshing flipped no edge.
const SETTLED: f64 = 1e-2;
/// Number of harmonic solves before each remeshing of step 2.
const SOLVES_PER_ROUND: u32 = 3;
/// The rounds of step 2 end when one of them changes the area by less than this fraction.
const SETTLED_AREA: f64 = 1e-4;
/// Number of sweeps of each remeshing.
const SWEEPS: u32 = 4;
/// Fractions of the progress at which the harmonic solves and the Newton rounds end.
const SETTLE_SHARE: f64 = 0.4;
const ROUNDS_SHARE: f64 = 0.7;

/// Minimises the area of the caller's own mesh, in which some edges have three triangles.
///
/// The edges with one triangle must be the segments of the boundaries, with or without further vertices on them.
/// Boundaries may share points and segments: three half-circles between two poles are two loops, or three. `given` are
/// the boundaries without equal neighbours. `input_vertices` gives for each input point its number among the points of
/// all these boundaries.
///
/// # Errors
/// [`Error::Input`] for a mesh that is not such a film or has another boundary; [`Error::Interrupted`] on cancel.
pub(super) fn solve(
    given: &[Vec<DVec3>],
    input_vertices: &[Vec<u32>],
    mesh: &Mesh,
    options: &Options,
    exec: &Execution,
) -> Result<MinimalSurface, Error> {
    let JunctionInput { wires, mut film, centre, exact } = JunctionInput::read(given, mesh, options)?;
    let initial_area = film.area();
    let mut solver = JunctionSolver::new(options, exec);
    let stop_reason = match solver.run(&mut film) {
        Ok(reason) => reason,
        Err(Error::Interrupted(Interruption::DeadlinePassed)) => StopReason::Deadline,
        Err(error) => return Err(error),
    };
    let balance = Balance::of(&film);
    let split = film.unstable_points();
    let morse_index = solver.morse_index.filter(|_| split.is_empty());
    let junctions = junction_statistics(&film, balance.junction_residual, morse_index);
    let is_balanced = balance.residual.max(junctions.residual) <= options.tolerance;
    let facts = facts(&film, &balance, junctions, given.len());
    let origin = Origin { kind: InitialMeshKind::Given, initial_area, run: solver.into_run(stop_reason) };
    let statistics = statistics::collect(facts, is_balanced, origin, options);
    let mut warnings = Vec::new();
    if !statistics.converged {
        warnings.push(statistics.not_converged(statistics.residual, options));
    }
    if let Some(&(_, meeting)) = split.first() {
        let detail = format!(
            "{meeting} junctions meet in one point ({} such points): in a soap film four do (Plateau's second law). \
             The film is stationary under motions of its vertices, but splitting the point may lower its area",
            split.len()
        );
        let warning = Warning::new(WarningCode::JunctionPoint, detail);
        warnings.push(warning.with_count("junctions", meeting).with_count("points", split.len()));
    }
    let mut mesh = Mesh::new(film.vertices, film.complex.triangles);
    mesh.vertices.iter_mut().for_each(|vertex| *vertex += centre);
    mesh.vertices[..exact.len()].copy_from_slice(&exact);
    Ok(MinimalSurface {
        mesh,
        input_vertices: input_vertices
            .iter()
            .map(|boundary| boundary.iter().map(|&point| wires.vertex_of[point as usize]).collect())
            .collect(),
        boundaries: wires.loops,
        constraints: ConstraintVertices::default(),
        mean_curvature: balance.mean_curvature,
        unstable_mode: None,
        statistics,
        warnings,
    })
}

/// Checks the arguments of [`solve`] before any work: O(n log n) in the size of the mesh.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with.
pub(super) fn check(given: &[Vec<DVec3>], mesh: &Mesh, options: &Options) -> Result<(), Error> {
    JunctionInput::read(given, mesh, options).map(|_| ())
}

/// The caller's mesh and boundaries, after checking that they fit together.
#[derive(Debug)]
struct JunctionInput {
    wires: Wires,
    /// The film, centred on the mean of the boundary points.
    film: JunctionFilm,
    centre: DVec3,
    /// The boundary points as they were given. They are the first vertices of the film.
    exact: Vec<DVec3>,
}

impl JunctionInput {
    fn read(given: &[Vec<DVec3>], mesh: &Mesh, options: &Options) -> Result<Self, Error> {
        check_options(options)?;
        let wires = Wires::find(given, mesh)?;
        let all: Vec<DVec3> = given.iter().flatten().copied().collect();
        let centre = polyline::mean(&all);
        let (vertices, triangles) = wires.renumbered(mesh);
        let exact = vertices[..wires.points].to_vec();
        let film = JunctionFilm::read(vertices.into_iter().map(|v| v - centre).collect(), triangles)?;
        wires.check(&film)?;
        Ok(Self { wires, film, centre, exact })
    }
}

/// Refuses options that a film with junctions does not support.
fn check_options(options: &Options) -> Result<(), Error> {
    let mut errors = Vec::new();
    let mut refuse = |refused: bool, field: &'static str, detail: &str| {
        errors.extend(refused.then(|| InputError::new(Place::field(field), detail)));
    };
    let objective = options.method.objective();
    let solver = objective == Objective::MinimalArea && !matches!(options.method, Method::Newton(_));
    refuse(
        solver,
        "solver",
        "a film with junctions is solved by newton, because the other solvers need edges with at most two triangles",
    );
    refuse(objective != Objective::MinimalArea, "objective", "a film with junctions takes minimal_area");
    refuse(
        !options.keeps_topology(),
        "topology",
        "a film with junctions keeps its topology, because the rules that remove thin triangles and cut necks hold for \
         edges with two triangles only",
    );
    refuse(!options.constraints.is_empty(), "constraints", "a film with junctions takes no fixed points or curves");
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

struct JunctionSolver<'a> {
    exec: &'a Execution<'a>,
    record: Record<'a>,
    tolerance: f64,
    limit: u32,
    edges_swapped: u64,
    morse_index: Option<usize>,
}

impl<'a> JunctionSolver<'a> {
    fn new(options: &Options, exec: &'a Execution<'a>) -> Self {
        Self {
            exec,
            record: Record::new(exec),
            tolerance: options.tolerance,
            limit: options.max_iterations.unwrap_or(DEFAULT_STEPS),
            edges_swapped: 0,
            morse_index: None,
        }
    }

    fn into_run(self, stop_reason: StopReason) -> Run {
        let Record { history, iterations, .. } = self.record;
        let edges_swapped = self.edges_swapped;
        Run { stop_reason, iterations, history, edges_swapped, ..Run::new(Solver::Newton) }
    }

    /// Steps 2 and 3.
    fn run(&mut self, film: &mut JunctionFilm) -> Result<StopReason, Error> {
        if film.complex.kinds.iter().all(|kind| *kind == VertexKind::Boundary) {
            return Ok(StopReason::NothingToMove);
        }
        let area = film.area();
        form_finding::find(&mut Converging { solver: self, film, rounds: Rounds::Harmonic(0), area })
    }

    fn even_out(&mut self, film: &mut JunctionFilm) -> Result<u64, Error> {
        let swapped = even_out(&mut film.vertices, &mut film.complex, SWEEPS, self.exec)?;
        self.edges_swapped += swapped;
        self.exec.look(u64::from(SWEEPS) * film.complex.triangles.len() as u64)?;
        Ok(swapped)
    }

    /// Makes Newton steps on the present mesh. If the steps of the last phase reach the tolerance, the Morse index is
    /// computed too.
    fn newton(
        &mut self,
        film: &mut JunctionFilm,
        tolerance: f64,
        steps: u32,
        phase: &'static str,
        done: f64,
    ) -> Result<StopReason, Error> {
        let max_steps = steps.min(self.limit.saturating_sub(self.record.iterations));
        let settings = Settings { aim: Aim::Minimum, tolerance, max_steps };
        let body = film.body();
        let motion = Motion::new(&body);
        let mut direct = match Direct::new(motion.matrix()) {
            Ok(direct) => direct,
            Err(_) => return Ok(StopReason::Collapsed),
        };
        self.exec.look(direct.symbolic.factor_entries() as u64)?;
        let (reason, state) =
            self.record.newton(&mut film.vertices, &motion, &mut direct, &settings, phase, |_| done)?;
        if reason == StopReason::Residual && phase == "newton" {
            motion.second_variation(&film.vertices, &state, 0.0, &mut direct.matrix);
            let unit = motion.radius().powi(-2);
            let Direct { symbolic, matrix, .. } = &direct;
            self.morse_index = match stability::morse_index(symbolic, matrix, &state.mass, unit, &[], self.exec) {
                Ok(index) => index.decided(),
                Err(Unsolved::Refused(_)) => None,
                Err(Unsolved::Interrupted(interruption)) => return Err(interruption.into()),
            };
        }
        Ok(reason)
    }
}

/// The rounds of a film with junctions: the kind of the next round, and the number of rounds of this kind before it.
#[derive(Clone, Copy, Debug)]
enum Rounds {
    /// Step 2: harmonic solves and remeshing.
    Harmonic(u32),
    /// Step 3: a few Newton steps and remeshing.
    Newton(u32),
}

/// A film with junctions on its way to a stationary shape.
struct Converging<'s, 'a> {
    solver: &'s mut JunctionSolver<'a>,
    film: &'s mut JunctionFilm,
    rounds: Rounds,
    area: f64,
}

impl Converging<'_, '_> {
    /// Makes a round of step 2. Returns whether the area has settled, or no further solve is possible.
    fn harmonic_round(&mut self, round: u32) -> Result<bool, Error> {
        let Self { solver, film, .. } = self;
        let fixed: Vec<bool> = film.complex.kinds.iter().map(|kind| *kind == VertexKind::Boundary).collect();
        let before = self.area;
        let Ok(mut dirichlet) = Dirichlet::of_complex(&film.complex.triangles, &fixed) else { return Ok(true) };
        for _ in 0..SOLVES_PER_ROUND {
            solver.exec.look(WORK_PER_TRIANGLE * film.complex.triangles.len() as u64)?;
            let full = solver.record.iterations >= solver.limit;
            if full || dirichlet.move_to_minimum(&mut film.vertices, &film.complex.triangles).is_err() {
                return Ok(true);
            }
            let body = film.body();
            let residual = Motion::new(&body).state(&film.vertices).residual;
            solver.record.iteration("pinkall_polthier", film.area(), residual, part_of_rounds(round));
        }
        solver.even_out(film)?;
        self.area = film.area();
        Ok(round + 1 == ROUNDS || (before - self.area).abs() <= SETTLED_AREA * self.area)
    }

    /// Makes a round of step 3. Returns whether the film has settled, or the rounds are used up.
    fn newton_round(&mut self, round: u32) -> Result<bool, Error> {
        let Self { solver, film, .. } = self;
        solver.newton(film, SETTLED, STEPS_PER_ROUND, "junction_rounds", part_of_rounds(round))?;
        let swapped = solver.even_out(film)?;
        let body = film.body();
        let settled = swapped == 0 && Motion::new(&body).state(&film.vertices).residual <= SETTLED;
        Ok(round + 1 == ROUNDS || settled)
    }
}

/// Part of the rounds of a step that is done after the round of this number, which begins at 0.
fn part_of_rounds(round: u32) -> f64 {
    f64::from(round + 1) / f64::from(ROUNDS)
}

impl FormFinding for Converging<'_, '_> {
    type End = StopReason;
    type Error = Error;

    fn begin(&mut self, _attempt: u32) {
        self.solver.record.share = [0.0, SETTLE_SHARE];
    }

    fn round(&mut self) -> Result<Round<StopReason>, Error> {
        match self.rounds {
            Rounds::Harmonic(round) => {
                self.rounds = Rounds::Harmonic(round + 1);
                if self.harmonic_round(round)? {
                    self.rounds = Rounds::Newton(0);
                    self.solver.record.share = [SETTLE_SHARE, ROUNDS_SHARE];
                }
            }
            Rounds::Newton(round) => {
                self.rounds = Rounds::Newton(round + 1);
                if self.newton_round(round)? {
                    self.solver.record.share = [ROUNDS_SHARE, 1.0];
                    return Ok(Round::Settled);
                }
            }
        }
        Ok(Round::Moves)
    }

    fn newton(&mut self) -> Result<StopReason, Error> {
        self.solver.newton(self.film, self.solver.tolerance, u32::MAX, "newton", 0.5)
    }

    fn flipped_triangles(&self) -> usize {
        flipped_triangles(&self.film.vertices, &self.film.complex)
    }

    fn accept(&mut self) -> Result<Option<StopReason>, Error> {
        Ok(Some(StopReason::Residual))
    }

    /// A film with junctions never settles again, because its rounds of Newton steps and remeshing have already brought
    /// it near its shape.
    fn refuse(&mut self, reason: StopReason, _attempt: u32) -> Result<Option<StopReason>, Error> {
        Ok(Some(if reason == StopReason::Residual { StopReason::Stalled } else { reason }))
    }
}

/// The residuals of a film, by its parts.
#[derive(Clone, Debug)]
struct Balance {
    /// For each vertex |g| / (2 A_h) inside the sheets, else 0.
    mean_curvature: Vec<f64>,
    /// The residual of the vertices inside the sheets.
    residual: f64,
    /// The residual of these vertices with the whole gradient, tangential part included.
    residual_full: f64,
    /// The residual of the junctions: |g⊥| / ℓ, where g⊥ is the part of the area gradient in the directions in which
    /// the vertex may move, and ℓ is half the length of the junction edges at the vertex.
    junction_residual: f64,
}

impl Balance {
    fn of(film: &JunctionFilm) -> Self {
        let body = film.body();
        let motion = Motion::new(&body);
        let state: State<Frame> = motion.state(&film.vertices);
        let radius = motion.radius();
        let mut balance = Self {
            mean_curvature: vec![0.0; film.vertices.len()],
            residual: 0.0,
            residual_full: 0.0,
            junction_residual: 0.0,
        };
        for (v, force, share) in motion.unbalanced_forces(&state) {
            let residual = radius * curvature(force, share);
            if body.freedoms[v] == Freedom::Normal {
                let full = curvature(state.frame.gradient[v].length(), share);
                balance.mean_curvature[v] = full;
                balance.residual = balance.residual.max(residual);
                balance.residual_full = balance.residual_full.max(radius * full);
            } else {
                balance.junction_residual = balance.junction_residual.max(residual);
            }
        }
        balance
    }
}

/// The facts about a film and its junctions.
fn facts(film: &JunctionFilm, balance: &Balance, junctions: JunctionStatistics, boundary_loops: usize) -> Facts {
    let complex = &film.complex;
    let mesh = Mesh::new(film.vertices.clone(), complex.triangles.clone());
    let inside = (0..film.vertices.len()).filter(|&v| complex.kinds[v] == VertexKind::Sheet);
    let length = |[a, b]: [u32; 2]| film.vertices[a as usize].distance(film.vertices[b as usize]);
    let lengths: Vec<f64> = complex.edges().map(|edge| length(edge.ends)).collect();
    Facts {
        vertices: mesh.vertices.len(),
        triangles: mesh.triangles.len(),
        boundary_loops,
        components: complex.components(),
        euler_characteristic: complex.euler_characteristic(),
        // The genus is not defined, because a film with junctions is not a surface.
        genus: None,
        area: film.area(),
        mean_curvature: MeanCurvature::of(inside.map(|v| balance.mean_curvature[v])),
        residual: balance.residual,
        residual_full: balance.residual_full,
        quality: Quality::of(&mesh, &lengths, flipped_triangles(&film.vertices, complex)),
        junctions: Some(junctions),
    }
}

#[cfg(test)]
mod tests;
