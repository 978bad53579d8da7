//! Films whose sheets meet three by three along curves (Plateau's first law: at 120°). Bento and Cavalcanti leave them
//! as future work. The initial mesh has such edges, and the topology stays.
//!
//! 1. Read the sheets and the junctions ([`Complex`]). Every edge has one triangle (boundary), two, or three
//!    (junction).
//! 2. Rounds of Pinkall and Polthier's solve on the whole film ([`harmonic`](super::harmonic)) and remeshing
//!    ([`sheets`](plateau_mesh::remesh::sheets)).
//! 3. Rounds of Newton steps and remeshing, then Newton steps alone, until the residuals of the sheets and of the
//!    junctions are below the tolerance. The film is a [`Body`]: a vertex inside a sheet moves along its normal, a
//!    vertex of a junction across its curve, and a vertex where junctions meet in all directions.
//!
//! The three forces on a junction are the area gradients of the sheets. Where they balance, unit sheets meet at 120°;
//! the angles themselves are not prescribed. They are measured in two ways: between the facets at each junction edge,
//! with an error of order h on a curved sheet, and between the forces of the sheets at each junction vertex, with an
//! error of order h².
//!
//! Near the end of a junction the second measure does not converge. If the wires leave the end at angles other than
//! 120°, the film need not tend to a cone there, and its direction changes at every scale. The deviation at the vertex
//! next to an end is therefore reported separately.

use super::harmonic::Dirichlet;
use super::initial_mesh::{InitialMeshKind, ON_SEGMENT};
use super::junction_statistics::JunctionStatistics;
use super::options::{Method, Objective, Options, Solver};
use super::outcome::{ConstraintVertices, MinimalSurface};
use super::run::{Record, StopReason};
use super::statistics::{MeanCurvature, Statistics};
use crate::energy::area::Facet;
use crate::equilibrium::newton::{Direct, Equations, State, iterate};
use crate::equilibrium::residual::curvature;
use crate::equilibrium::{Aim, Body, Frame, Freedom, Motion, Outcome, Settings, stability};
use plateau_mesh::codes::WarningCode;
use plateau_mesh::complex::{Complex, VertexKind};
use plateau_mesh::error::{InputError, Warning};
use plateau_mesh::measure::{self, Spread};
use plateau_mesh::polyline::position_key;
use plateau_mesh::remesh::sheets::{even_out, flipped_triangles};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Mesh, Place, polyline};
use std::collections::BTreeMap;

/// Largest number of Newton steps and harmonic solves of a run if the caller gives none.
const DEFAULT_STEPS: u32 = 200;
/// Number of Newton steps before each remeshing, and the largest number of such rounds. More steps follow a mesh for
/// longer before it is improved.
const STEPS_PER_ROUND: u32 = 4;
const ROUNDS: u32 = 10;
/// Rounds end when the residual is below this and no edge was flipped.
const SETTLED: f64 = 1e-2;
/// Number of harmonic solves before each remeshing, and the relative change of area at which those rounds end. With a
/// larger change Newton's method starts earlier.
const SOLVES_PER_ROUND: u32 = 3;
const SETTLED_AREA: f64 = 1e-4;
/// Number of sweeps of each remeshing.
const SWEEPS: u32 = 4;
/// Fractions of the progress at which the harmonic solves and the Newton rounds end.
const SETTLE_SHARE: f64 = 0.4;
const ROUNDS_SHARE: f64 = 0.7;
/// Four junctions and six sheets meet in a point of a soap film (Plateau's second law).
const JUNCTIONS_AT_A_POINT: usize = 4;
const THIRD_OF_TURN: f64 = 2.0 * std::f64::consts::FRAC_PI_3;

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
    let statistics = collect(&film, &balance, junctions, solver, stop_reason, initial_area, given.len(), options);
    let mut warnings = Vec::new();
    if !statistics.converged {
        warnings.push(statistics.not_converged(statistics.residual, options.tolerance));
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
    refuse(solver, "solver", "a film with junctions is solved by newton");
    refuse(objective != Objective::MinimalArea, "objective", "a film with junctions takes minimal_area");
    refuse(!options.keeps_topology(), "topology", "a film with junctions keeps its topology");
    refuse(!options.constraints.is_empty(), "constraints", "a film with junctions takes no fixed points or curves");
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

/// The vertices of the mesh at the boundary points, numbered by first appearance, and then those that the mesh has
/// between two neighbouring points.
#[derive(Debug)]
struct Wires {
    /// For each boundary its vertices, added ones included, with the new numbers.
    loops: Vec<Vec<u32>>,
    /// The vertices at the points of all boundaries, one boundary after the other.
    vertex_of: Vec<u32>,
    /// Number of distinct boundary points, which are the first vertices.
    points: usize,
    /// For each old vertex its new number.
    number: Vec<u32>,
}

impl Wires {
    fn find(boundaries: &[Vec<DVec3>], mesh: &Mesh) -> Result<Self, Error> {
        let mut known: Vec<([u64; 3], u32)> =
            mesh.vertices.iter().enumerate().map(|(v, &p)| (position_key(p), v as u32)).collect();
        known.sort_unstable();
        let mut number = vec![u32::MAX; mesh.vertices.len()];
        let mut points = 0;
        let mut corners: Vec<Vec<u32>> = Vec::with_capacity(boundaries.len());
        for (k, boundary) in boundaries.iter().enumerate() {
            let mut vertices = Vec::with_capacity(boundary.len());
            for &point in boundary {
                let at = known.partition_point(|&(other, _)| other < position_key(point));
                let Some(&(_, old)) = known.get(at).filter(|&&(other, _)| other == position_key(point)) else {
                    let detail = format!("has no vertex at a point of boundary {k}");
                    return Err(Error::input(Place::field("initial_mesh").then("vertices"), detail));
                };
                if number[old as usize] == u32::MAX {
                    number[old as usize] = points;
                    points += 1;
                }
                vertices.push(old);
            }
            corners.push(vertices);
        }
        let rim = Rim::of(mesh);
        let loops: Vec<Vec<u32>> = corners
            .iter()
            .map(|corners| {
                let along = |k: usize| rim.between(mesh, corners[k], corners[(k + 1) % corners.len()]);
                (0..corners.len()).flat_map(|k| [vec![corners[k]], along(k)].concat()).collect()
            })
            .collect();
        let mut next = points;
        for old in loops.iter().flatten().copied().chain(0..mesh.vertices.len() as u32) {
            if number[old as usize] == u32::MAX {
                number[old as usize] = next;
                next += 1;
            }
        }
        let renumbered = |vertices: &Vec<u32>| -> Vec<u32> { vertices.iter().map(|&v| number[v as usize]).collect() };
        let vertex_of = corners.iter().flat_map(renumbered).collect();
        let loops = loops.iter().map(renumbered).collect();
        Ok(Self { loops, vertex_of, points: points as usize, number })
    }

    fn renumbered(&self, mesh: &Mesh) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let mut vertices = mesh.vertices.clone();
        mesh.vertices.iter().zip(&self.number).for_each(|(&p, &v)| vertices[v as usize] = p);
        // A number that is out of range is reported when the triangles are read.
        let renumber = |v: u32| self.number.get(v as usize).copied().unwrap_or(v);
        (vertices, mesh.triangles.iter().map(|t| t.map(renumber)).collect())
    }

    /// Checks that the boundary edges of the mesh are the segments of the boundaries.
    fn check(&self, film: &JunctionFilm) -> Result<(), Error> {
        let undirected = |a: u32, b: u32| [a.min(b), a.max(b)];
        let mut wires: Vec<[u32; 2]> = self
            .loops
            .iter()
            .flat_map(|boundary| {
                (0..boundary.len()).map(|k| undirected(boundary[k], boundary[(k + 1) % boundary.len()]))
            })
            .collect();
        wires.sort_unstable();
        wires.dedup();
        let rim: Vec<[u32; 2]> = film.complex.edges().filter(|edge| edge.count() == 1).map(|edge| edge.ends).collect();
        if rim == wires {
            return Ok(());
        }
        let missing = wires.iter().filter(|edge| rim.binary_search(edge).is_err()).count();
        let loose = rim.iter().filter(|edge| wires.binary_search(edge).is_err()).count();
        let detail = format!(
            "its edges of one triangle must be the boundaries' segments: {missing} segments are no such edge, {loose} \
             such edges are no segment"
        );
        Err(Error::input(Place::field("initial_mesh"), detail))
    }
}

/// The edges of one triangle in both directions, sorted.
#[derive(Debug)]
struct Rim(Vec<[u32; 2]>);

impl Rim {
    fn of(mesh: &Mesh) -> Self {
        let mut sides: Vec<[u32; 2]> = mesh
            .triangles
            .iter()
            .filter(|triangle| triangle.iter().all(|&v| (v as usize) < mesh.vertices.len()))
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]))
            .collect();
        sides.sort_unstable();
        let single = sides.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).map(|same| same[0]);
        let mut edges: Vec<[u32; 2]> = single.flat_map(|[a, b]| [[a, b], [b, a]]).collect();
        edges.sort_unstable();
        Self(edges)
    }

    /// The vertices that the mesh has on the segment between two of its vertices, in order. None if its edges do not
    /// lead from one end to the other along the segment.
    fn between(&self, mesh: &Mesh, from: u32, to: u32) -> Vec<u32> {
        let (a, b) = (mesh.vertices[from as usize], mesh.vertices[to as usize]);
        let along = b - a;
        let part = |v: u32| along.dot(mesh.vertices[v as usize] - a) / along.length_squared();
        let is_beside =
            |v: u32| along.cross(mesh.vertices[v as usize] - a).length() > ON_SEGMENT * along.length_squared();
        let (mut vertices, mut here) = (Vec::new(), from);
        // At most one pass per vertex, because each vertex lies further along the segment than the one before.
        loop {
            let first = self.0.partition_point(|edge| edge[0] < here);
            let mut ahead = self.0[first..].iter().take_while(|edge| edge[0] == here).map(|edge| edge[1]);
            if ahead.clone().any(|v| v == to) {
                return vertices;
            }
            let Some(next) = ahead.find(|&v| !is_beside(v) && part(v) > part(here) && part(v) < 1.0) else {
                return Vec::new();
            };
            vertices.push(next);
            here = next;
        }
    }
}

/// A film whose sheets meet three by three.
#[derive(Clone, Debug)]
struct JunctionFilm {
    vertices: Vec<DVec3>,
    complex: Complex,
}

impl JunctionFilm {
    /// Reads a mesh.
    ///
    /// # Errors
    /// [`Error::Input`] under `initial_mesh`: an edge of four triangles, a vertex that is not finite, a triangle
    /// without area, or a [defect](plateau_mesh::complex::ComplexDefect) of the
    /// complex.
    fn read(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, Error> {
        let place = || Place::field("initial_mesh");
        let mut errors = Vec::new();
        let mut seen = BTreeMap::new();
        for (t, triangle) in triangles.iter().enumerate() {
            let mut refuse = |detail: String| errors.push(InputError::new(place().then("triangles").at(t), detail));
            let mut corners = *triangle;
            corners.sort_unstable();
            let first = *seen.entry(corners).or_insert(t);
            if first < t {
                refuse(format!("has the same corners as triangle {first}"));
            }
            if triangle.iter().any(|&v| v as usize >= vertices.len()) {
                refuse("names a vertex that does not exist".into());
            } else if measure::is_degenerate(triangle.map(|v| vertices[v as usize])) {
                refuse("has no area".into());
            }
        }
        for (v, _) in vertices.iter().enumerate().filter(|(_, vertex)| !vertex.is_finite()) {
            let detail = "every coordinate must be a finite number";
            errors.push(InputError::new(place().then("vertices").at(v), detail));
        }
        if !errors.is_empty() {
            return Err(Error::Input(errors));
        }
        let complex =
            Complex::build(triangles, vertices.len()).map_err(|defect| Error::input(place(), defect.to_string()))?;
        if let Some(edge) = complex.edges().find(|edge| edge.count() > 3) {
            let ([a, b], count) = (edge.ends, edge.count());
            let detail = format!("{count} triangles share the edge between the vertices {a} and {b}");
            return Err(Error::input(place(), detail));
        }
        Ok(Self { vertices, complex })
    }

    fn area(&self) -> f64 {
        let area = |&t: &[u32; 3]| 0.5 * measure::double_area_vector(self.corners(t)).length();
        self.complex.triangles.iter().map(area).sum()
    }

    fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| self.vertices[v as usize])
    }

    /// The film as a body of surface tension 1.
    fn body(&self) -> Body {
        Body::new(self.vertices.clone(), &self.complex, &vec![1.0; self.complex.sheets.len()])
    }

    /// The unit tangent of a junction between two of its vertices; the x axis if they coincide.
    fn tangent(&self, [a, b]: [u32; 2]) -> DVec3 {
        (self.vertices[b as usize] - self.vertices[a as usize]).normalize_or(DVec3::X)
    }

    /// The points at which a number of junctions other than four meet, with that number.
    fn unstable_points(&self) -> Vec<(u32, usize)> {
        let mut meeting = vec![0; self.vertices.len()];
        self.complex.junctions().iter().flatten().for_each(|&v| meeting[v as usize] += 1);
        let point =
            |&(v, count): &(usize, usize)| self.complex.kinds[v] == VertexKind::Point && count != JUNCTIONS_AT_A_POINT;
        meeting.into_iter().enumerate().filter(point).map(|(v, count)| (v as u32, count)).collect()
    }
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

    /// Steps 2 and 3.
    fn run(&mut self, film: &mut JunctionFilm) -> Result<StopReason, Error> {
        if film.complex.kinds.iter().all(|kind| *kind == VertexKind::Boundary) {
            return Ok(StopReason::NothingToMove);
        }
        self.record.share = [0.0, SETTLE_SHARE];
        self.settle(film)?;
        self.record.share = [SETTLE_SHARE, ROUNDS_SHARE];
        for round in 0..ROUNDS {
            let done = f64::from(round + 1) / f64::from(ROUNDS);
            self.newton(film, SETTLED, STEPS_PER_ROUND, "junction_rounds", done)?;
            let swapped = self.even_out(film)?;
            let body = film.body();
            if swapped == 0 && Motion::new(&body).state(&film.vertices).residual <= SETTLED {
                break;
            }
        }
        self.record.share = [ROUNDS_SHARE, 1.0];
        let outcome = self.newton(film, self.tolerance, u32::MAX, "newton", 0.5)?;
        Ok(match outcome {
            // A flipped triangle does not show in the residual.
            Outcome::Converged if flipped_triangles(&film.vertices, &film.complex) > 0 => StopReason::Stalled,
            Outcome::Converged => StopReason::Residual,
            Outcome::StepsUsed => StopReason::MaxIterations,
            Outcome::Stalled | Outcome::Refused(_) => StopReason::Stalled,
            Outcome::Interrupted(interruption) => return Err(interruption.into()),
        })
    }

    /// Step 2: harmonic solves and remeshing until the area settles. Accepts any start.
    fn settle(&mut self, film: &mut JunctionFilm) -> Result<(), Error> {
        let fixed: Vec<bool> = film.complex.kinds.iter().map(|kind| *kind == VertexKind::Boundary).collect();
        let mut area = film.area();
        for round in 0..ROUNDS {
            let before = area;
            let Ok(mut dirichlet) = Dirichlet::of_complex(&film.complex.triangles, &fixed) else { return Ok(()) };
            for _ in 0..SOLVES_PER_ROUND {
                self.exec.look(20 * film.complex.triangles.len() as u64)?;
                let full = self.record.iterations >= self.limit;
                if full || dirichlet.move_to_minimum(&mut film.vertices, &film.complex.triangles).is_err() {
                    return Ok(());
                }
                let body = film.body();
                let residual = Motion::new(&body).state(&film.vertices).residual;
                let done = f64::from(round + 1) / f64::from(ROUNDS);
                self.record.iteration("pinkall_polthier", film.area(), residual, done);
            }
            self.even_out(film)?;
            area = film.area();
            if (before - area).abs() <= SETTLED_AREA * area {
                break;
            }
        }
        Ok(())
    }

    fn even_out(&mut self, film: &mut JunctionFilm) -> Result<u64, Error> {
        let swapped = even_out(&mut film.vertices, &mut film.complex, SWEEPS, self.exec)?;
        self.edges_swapped += swapped;
        self.exec.look(u64::from(SWEEPS) * film.complex.triangles.len() as u64)?;
        Ok(swapped)
    }

    /// Newton steps on the present mesh. In the last phase also the Morse index, if the steps reach the tolerance.
    fn newton(
        &mut self,
        film: &mut JunctionFilm,
        tolerance: f64,
        steps: u32,
        phase: &'static str,
        done: f64,
    ) -> Result<Outcome, Error> {
        let max_steps = steps.min(self.limit.saturating_sub(self.record.iterations));
        let settings = Settings { aim: Aim::Minimum, tolerance, max_steps };
        let body = film.body();
        let motion = Motion::new(&body);
        let mut direct = match Direct::new(motion.matrix()) {
            Ok(direct) => direct,
            Err(error) => return Ok(Outcome::Refused(error)),
        };
        self.exec.look(direct.symbolic.factor_entries() as u64)?;
        let record = &mut self.record;
        let (outcome, state) =
            iterate(&mut film.vertices, &motion, &mut direct, &settings, self.exec, &mut |area, residual| {
                record.iteration(phase, area, residual, done);
            });
        match outcome {
            Outcome::Interrupted(interruption) => return Err(interruption.into()),
            Outcome::Converged if phase == "newton" => {
                motion.second_variation(&film.vertices, &state, 0.0, &mut direct.matrix);
                let unit = motion.radius().powi(-2);
                let Direct { symbolic, matrix, .. } = &direct;
                self.morse_index = stability::morse_index(symbolic, matrix, &state.mass, unit, &[]).ok();
            }
            _ => {}
        }
        Ok(outcome)
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
    /// The residual of the junctions: |g⊥| / ℓ with half the length ℓ of the junction edges at the vertex.
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

/// The three angles between directions around an axis. If all directions are perpendicular to the axis, the angles add
/// up to a full turn.
fn angles_around(axis: DVec3, directions: [DVec3; 3]) -> [f64; 3] {
    let (u, v) = axis.any_orthonormal_pair();
    let mut at = directions.map(|direction| libm::atan2(direction.dot(v), direction.dot(u)));
    at.sort_by(f64::total_cmp);
    [at[1] - at[0], at[2] - at[1], at[0] - at[2] + std::f64::consts::TAU]
}

fn junction_statistics(film: &JunctionFilm, residual: f64, morse_index: Option<usize>) -> JunctionStatistics {
    let (complex, junction_edges) = (&film.complex, film.complex.junctions());
    let mut facets = Vec::new();
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); film.vertices.len()];
    for (t, &triangle) in complex.triangles.iter().enumerate() {
        triangle.iter().for_each(|&v| around[v as usize].push(t));
        let corners = film.corners(triangle);
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            if junction_edges.binary_search(&[a.min(b), a.max(b)]).is_ok() {
                let along = (corners[(k + 1) % 3] - corners[k]).normalize_or_zero();
                let inward = (corners[(k + 2) % 3] - corners[k]).reject_from(along).normalize_or_zero();
                facets.push(([a.min(b), a.max(b)], along, inward));
            }
        }
    }
    facets.sort_by_key(|facet| facet.0);
    let facet_angles: Vec<f64> = facets
        .chunk_by(|a, b| a.0 == b.0)
        .filter_map(|three| match three {
            [a, b, c] => Some(angles_around(a.1, [a.2, b.2, c.2])),
            _ => None,
        })
        .flatten()
        .collect();
    let at_vertices: Vec<(bool, [f64; 3])> = (0..film.vertices.len())
        .filter_map(|v| {
            let VertexKind::Junction(beside) = complex.kinds[v] else { return None };
            let inside = beside.iter().all(|&v| matches!(complex.kinds[v as usize], VertexKind::Junction(_)));
            Some((inside, angles_around(film.tangent(beside), sheet_forces(film, v as u32, beside, &around[v])?)))
        })
        .collect();
    let sheet_angles = || at_vertices.iter().flat_map(|(_, angles)| *angles);
    let departure = |angles: &[f64]| angles.iter().map(|angle| (angle - THIRD_OF_TURN).abs()).fold(0.0, f64::max);
    let departures =
        |inside: bool| at_vertices.iter().filter(move |vertex| vertex.0 == inside).map(|(_, angles)| departure(angles));
    let at_ends = departures(false).fold(0.0, f64::max);
    let away = departures(true).reduce(f64::max);
    // A junction of a single edge has no inner vertex. Its facets are measured instead.
    let (largest, mean) = if at_vertices.is_empty() {
        let mean = Spread::of(facet_angles.iter().map(|angle| (angle - THIRD_OF_TURN).abs())).mean;
        (departure(&facet_angles), mean)
    } else {
        (away.unwrap_or(at_ends), Spread::of(sheet_angles().map(|angle| (angle - THIRD_OF_TURN).abs())).mean)
    };
    let length = |&[a, b]: &[u32; 2]| film.vertices[a as usize].distance(film.vertices[b as usize]);
    JunctionStatistics {
        sheets: complex.sheets.len(),
        curves: complex.curves(),
        edges: junction_edges.len(),
        points: complex.kinds.iter().filter(|kind| **kind == VertexKind::Point).count(),
        length: junction_edges.iter().map(length).sum(),
        residual,
        largest_deviation: largest,
        largest_deviation_at_ends: at_ends,
        mean_deviation: mean,
        facet_angles: Spread::of(facet_angles.into_iter()),
        sheet_angles: Spread::of(sheet_angles()),
        morse_index,
    }
}

/// The forces (minus the area gradients) of the three sheets at a vertex inside a junction. Each is the sum over the
/// fan of triangles from one junction edge to the other. `None` if the sheets cannot be told apart there.
fn sheet_forces(film: &JunctionFilm, v: u32, [before, after]: [u32; 2], around: &[usize]) -> Option<[DVec3; 3]> {
    let triangles = &film.complex.triangles;
    let mut forces = Vec::new();
    for &start in around.iter().filter(|&&t| triangles[t].contains(&before)) {
        let (mut force, mut t, mut spoke) = (DVec3::ZERO, start, before);
        // A fan has each triangle once at most.
        for _ in around {
            let triangle = triangles[t];
            let k = triangle.iter().position(|&corner| corner == v)?;
            force -= Facet::of(&film.vertices, &triangle).gradient(k);
            spoke = *triangle.iter().find(|&&corner| corner != v && corner != spoke)?;
            if spoke == after {
                break;
            }
            // The next triangle of the fan is the other triangle at the spoke.
            t = *around.iter().find(|&&u| u != t && triangles[u].contains(&spoke))?;
        }
        if spoke != after {
            return None;
        }
        forces.push(force);
    }
    <[DVec3; 3]>::try_from(forces).ok()
}

#[allow(clippy::too_many_arguments, reason = "one call, each argument its own kind of thing")]
fn collect(
    film: &JunctionFilm,
    balance: &Balance,
    junctions: JunctionStatistics,
    solver: JunctionSolver,
    stop_reason: StopReason,
    initial_area: f64,
    boundary_loops: usize,
    options: &Options,
) -> Statistics {
    let complex = &film.complex;
    let mesh = Mesh::new(film.vertices.clone(), complex.triangles.clone());
    let area = film.area();
    let inside = (0..film.vertices.len()).filter(|&v| complex.kinds[v] == VertexKind::Sheet);
    let free: Vec<f64> = inside.map(|v| balance.mean_curvature[v]).collect();
    let curvature = Spread::of(free.iter().copied());
    let rms = (free.iter().map(|h| h * h).sum::<f64>() / free.len().max(1) as f64).sqrt();
    let (smallest_angle, largest_angle) = measure::angle_range(&mesh);
    let length = |[a, b]: [u32; 2]| film.vertices[a as usize].distance(film.vertices[b as usize]);
    let edge_lengths: Vec<f64> = complex.edges().map(|edge| length(edge.ends)).collect();
    let flipped_triangles = flipped_triangles(&film.vertices, complex);
    let degenerate_triangles = measure::degenerate_triangles(&mesh);
    let balanced = balance.residual <= options.tolerance && junctions.residual <= options.tolerance;
    Statistics {
        objective: options.method.objective(),
        objective_value: area,
        solver: Solver::Newton,
        initial_mesh: InitialMeshKind::Given,
        vertices: mesh.vertices.len(),
        triangles: mesh.triangles.len(),
        boundary_loops,
        components: complex.components(),
        euler_characteristic: complex.euler_characteristic(),
        // The genus is not defined, because a film with junctions is not a surface.
        genus: None,
        area,
        initial_area,
        extrapolated_area: None,
        mean_curvature: MeanCurvature { max: curvature.max, mean: curvature.mean, rms },
        residual: balance.residual,
        residual_full: balance.residual_full,
        converged: balanced && flipped_triangles == 0 && degenerate_triangles == 0,
        stop_reason,
        iterations: solver.record.iterations,
        history: solver.record.history,
        refined: false,
        stability: None,
        edge_lengths: Spread::of(edge_lengths.into_iter()),
        smallest_angle,
        largest_angle,
        edges_swapped: solver.edges_swapped,
        flipped_triangles,
        degenerate_triangles,
        pinches: Vec::new(),
        spanning: None,
        junctions: Some(junctions),
    }
}

#[cfg(test)]
mod tests;
