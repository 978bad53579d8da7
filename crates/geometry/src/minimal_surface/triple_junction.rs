//! Films whose sheets meet three by three along curves (Plateau's first law: at 120°), which Bento and Cavalcanti leave as
//! future work. From an initial mesh that has such edges; the topology stays.
//!
//! 1. Read the sheets and the junctions ([`sheets`]). Every edge has one triangle (boundary), two, or three (junction).
//! 2. Rounds of Pinkall and Polthier's solve on the whole film and remeshing: the vertices are spread within the sheets and along the
//!    junctions, edges within the sheets flipped to Delaunay's.
//! 3. Rounds of Newton steps and remeshing, then Newton steps alone, until the sheets' residual and the junctions' are
//!    below the tolerance: a sheet's vertex moves along its normal, a junction's across its curve, a vertex where junctions meet
//!    anywhere ([`variation`]).
//!
//! The three pulls on a junction are the sheets' area gradients. Where they balance, unit sheets meet at 120°; nothing is asked of the
//! angles themselves. They are measured twice: between the facets at each junction edge, which a curved sheet leaves at
//! an angle of order h, and between the sheets' pulls at each junction vertex, which converges with h². Next to a junction's end it does
//! not: between wires that leave the end at other angles than 120° the film need not tend to a cone there, and goes on turning as one
//! comes nearer, at every scale. The departure at the vertex next to an end is therefore reported apart.

mod sheets;
mod variation;

pub(super) use sheets::has_junctions;

use super::initial_mesh::InitialMeshKind;
use super::options::{Method, Objective, Options, Solver};
use super::outcome::{ConstraintVertices, MinimalSurface};
use super::run::{HistoryRow, StopReason};
use super::statistics::{MeanCurvature, Statistics};
use crate::error::{InputError, Warning};
use crate::mesh::measure::{self, Spread};
use crate::sparse::Symbolic;
use crate::{DVec3, Error, Execution, Interruption, Mesh, Place, Progress, polyline};
use sheets::{Kind, Sheets};
use variation::{Directions, SecondVariation, dirichlet_step};

/// Newton steps that a run may take if the caller does not say, and in each round before a remeshing.
const DEFAULT_STEPS: u32 = 200;
const STEPS_PER_ROUND: u32 = 4;
const ROUNDS: u32 = 10;
/// Harmonic solves in each round before those, and the change of area at which they end.
const SOLVES_PER_ROUND: u32 = 3;
const SETTLED_AREA: f64 = 1e-4;
/// Sweeps of each remeshing.
const SWEEPS: u32 = 4;
/// Rounds end when both residuals are below this.
const SETTLED: f64 = 1e-2;
/// Multiples of the first part that are added to an indefinite second variation.
const SHIFTS: [f64; 8] = [0.0, 0.125, 0.5, 2.0, 8.0, 32.0, 128.0, 512.0];
/// A step shorter than this fraction of Newton's own ends the run.
const LEAST_STEP: f64 = 1.0 / 4096.0;
const THIRD_OF_TURN: f64 = 2.0 * std::f64::consts::FRAC_PI_3;

/// What is reported of a film with junctions beside the rest.
#[derive(Clone, Debug, PartialEq)]
pub struct JunctionStatistics {
    /// Sheets: parts that hang together across edges of two triangles.
    pub sheets: usize,
    /// Curves along which three sheets meet, each as mesh vertices from end to end; a closed one ends with its first.
    pub curves: Vec<Vec<u32>>,
    /// Edges of three triangles.
    pub edges: usize,
    /// Vertices inside the film where such curves meet.
    pub points: usize,
    /// Length of all junctions.
    pub length: f64,
    /// Largest net pull of the sheets across a junction, per length: 0 where they balance, 1 for one sheet alone. Dimensionless.
    pub residual: f64,
    /// Angles between neighbouring facets around the junction edges, radians.
    pub facet_angles: Spread,
    /// Angles between the pulls of neighbouring sheets at the junctions' inner vertices, radians.
    pub sheet_angles: Spread,
    /// Largest departure of [`Self::sheet_angles`] from 120°, radians, at the vertices that are not next to an end of their junction
    /// (where all are: at all).
    pub largest_deviation: f64,
    /// The same at the vertices next to an end, where it may hardly fall with the mesh; 0 where there are none.
    pub largest_deviation_at_ends: f64,
    /// On average over all of them.
    pub mean_deviation: f64,
    /// Number of negative eigenvalues of the second variation; `None` where it was not computed.
    pub morse_index: Option<usize>,
}

/// Minimises the area of the caller's own mesh, some of whose edges have three triangles.
///
/// The edges with one triangle must be the segments of the boundaries, which may share points and segments (three
/// half-circles between two poles are two loops, or three). `given` are the boundaries without equal neighbours, one after the
/// other, and `input_vertices` says for each input point which of these it is.
///
/// # Errors
/// [`Error::Input`] for a mesh that is no such film or has another boundary; [`Error::Interrupted`] on cancel.
pub(super) fn solve(
    given: &[Vec<DVec3>],
    input_vertices: &[Vec<u32>],
    mesh: &Mesh,
    options: &Options,
    exec: &Execution,
) -> Result<MinimalSurface, Error> {
    let Start { wires, mut film, centre, exact } = Start::read(given, mesh, options)?;
    let initial_area = film.area();
    let mut solver = JunctionSolver::new(&film, options, exec);
    let stop_reason = match solver.run(&mut film) {
        Ok(reason) => reason,
        Err(Interruption::DeadlinePassed) => StopReason::Deadline,
        Err(interruption) => return Err(interruption.into()),
    };
    film.check().map_err(|defect| Error::no_result("invalid_mesh", defect))?;
    let pulls = Pulls::of(&film, solver.radius);
    let junctions = junction_statistics(&film, &pulls, solver.morse_index);
    let statistics = collect(&film, &pulls, junctions, &solver, stop_reason, initial_area, given.len(), options);
    let mut warnings = Vec::new();
    if !statistics.converged {
        warnings.push(Warning::new("not_converged", statistics.shortfall(options.tolerance)));
    }
    let mut mesh = Mesh::new(film.vertices, film.triangles);
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
        mean_curvature: pulls.mean_curvature,
        unstable_mode: None,
        statistics,
        warnings,
    })
}

/// What [`solve`] would say of its arguments before any work: O(n log n) in the size of the mesh.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with.
pub(super) fn check(given: &[Vec<DVec3>], mesh: &Mesh, options: &Options) -> Result<(), Error> {
    Start::read(given, mesh, options).map(|_| ())
}

/// The caller's mesh and boundaries, found to fit together.
#[derive(Debug)]
struct Start {
    wires: Wires,
    /// Around the centre.
    film: Sheets,
    centre: DVec3,
    /// The boundaries' points as they were given: the film's first vertices.
    exact: Vec<DVec3>,
}

impl Start {
    fn read(given: &[Vec<DVec3>], mesh: &Mesh, options: &Options) -> Result<Self, Error> {
        check_options(options)?;
        let wires = Wires::find(given, mesh)?;
        let all: Vec<DVec3> = given.iter().flatten().copied().collect();
        let centre = polyline::mean(&all);
        let (vertices, triangles) = wires.renumbered(mesh);
        let exact = vertices[..wires.points].to_vec();
        let film = Sheets::read(vertices.into_iter().map(|v| v - centre).collect(), triangles)?;
        wires.check(&film)?;
        Ok(Self { wires, film, centre, exact })
    }
}

/// What a film with junctions does not take.
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

/// The boundaries on the mesh: each point's vertex, numbered by first appearance.
#[derive(Debug)]
struct Wires {
    /// Per boundary its vertices, as renumbered.
    loops: Vec<Vec<u32>>,
    /// The same, one boundary after the other.
    vertex_of: Vec<u32>,
    /// Number of different points: the first vertices.
    points: usize,
    /// For each old vertex its new number.
    number: Vec<u32>,
}

impl Wires {
    fn find(boundaries: &[Vec<DVec3>], mesh: &Mesh) -> Result<Self, Error> {
        // -0.0 and 0.0 are one coordinate.
        let bits = |p: DVec3| (p + DVec3::ZERO).to_array().map(f64::to_bits);
        let mut known: Vec<([u64; 3], u32)> =
            mesh.vertices.iter().enumerate().map(|(v, &p)| (bits(p), v as u32)).collect();
        known.sort_unstable();
        let mut number = vec![u32::MAX; mesh.vertices.len()];
        let mut points = 0;
        let mut loops = Vec::with_capacity(boundaries.len());
        for (k, boundary) in boundaries.iter().enumerate() {
            let mut vertices = Vec::with_capacity(boundary.len());
            for &point in boundary {
                let at = known.partition_point(|&(other, _)| other < bits(point));
                let Some(&(_, old)) = known.get(at).filter(|&&(other, _)| other == bits(point)) else {
                    let detail = format!("has no vertex at a point of boundary {k}");
                    return Err(Error::input(Place::field("initial_mesh").then("vertices"), detail));
                };
                if number[old as usize] == u32::MAX {
                    number[old as usize] = points;
                    points += 1;
                }
                vertices.push(number[old as usize]);
            }
            loops.push(vertices);
        }
        let mut next = points;
        for number in &mut number {
            if *number == u32::MAX {
                *number = next;
                next += 1;
            }
        }
        let vertex_of = loops.iter().flatten().copied().collect();
        Ok(Self { loops, vertex_of, points: points as usize, number })
    }

    fn renumbered(&self, mesh: &Mesh) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let mut vertices = mesh.vertices.clone();
        mesh.vertices.iter().zip(&self.number).for_each(|(&p, &v)| vertices[v as usize] = p);
        // A number that is out of range is reported when the triangles are read.
        let renumber = |v: u32| self.number.get(v as usize).copied().unwrap_or(v);
        (vertices, mesh.triangles.iter().map(|t| t.map(renumber)).collect())
    }

    /// The mesh's boundary edges must be the boundaries' segments.
    fn check(&self, film: &Sheets) -> Result<(), Error> {
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
        let mut rim: Vec<[u32; 2]> = film.boundary.iter().map(|&[a, b]| undirected(a, b)).collect();
        rim.sort_unstable();
        if rim == wires {
            return Ok(());
        }
        let missing = wires.iter().filter(|edge| rim.binary_search(edge).is_err()).count();
        let loose = rim.iter().filter(|edge| wires.binary_search(edge).is_err()).count();
        let detail = format!(
            "its edges of one triangle must be the boundaries' segments: {missing} segments are no such edge, {loose} such edges are no segment"
        );
        Err(Error::input(Place::field("initial_mesh"), detail))
    }
}

struct JunctionSolver<'a> {
    exec: &'a Execution<'a>,
    tolerance: f64,
    limit: u32,
    radius: f64,
    history: Vec<HistoryRow>,
    iterations: u32,
    edges_swapped: u64,
    morse_index: Option<usize>,
}

/// How a few Newton steps ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Newton {
    Converged,
    StepsUsed,
    Stalled,
}

impl<'a> JunctionSolver<'a> {
    fn new(film: &Sheets, options: &Options, exec: &'a Execution<'a>) -> Self {
        let rim: Vec<DVec3> =
            film.kinds.iter().zip(&film.vertices).filter(|(kind, _)| **kind == Kind::Fixed).map(|(_, &p)| p).collect();
        let mean = polyline::mean(&rim);
        Self {
            exec,
            tolerance: options.tolerance,
            limit: options.max_iterations.unwrap_or(DEFAULT_STEPS),
            radius: rim.iter().map(|p| p.distance(mean)).fold(0.0, f64::max),
            history: Vec::new(),
            iterations: 0,
            edges_swapped: 0,
            morse_index: None,
        }
    }

    /// Steps 2 and 3.
    fn run(&mut self, film: &mut Sheets) -> Result<StopReason, Interruption> {
        if film.kinds.iter().all(|kind| *kind == Kind::Fixed) {
            return Ok(StopReason::NothingToMove);
        }
        self.settle(film)?;
        for round in 0..ROUNDS {
            let share = 0.4 + 0.3 * f64::from(round + 1) / f64::from(ROUNDS);
            self.newton(film, SETTLED, STEPS_PER_ROUND, "junction_rounds", share)?;
            let swapped = film.remesh(SWEEPS);
            self.edges_swapped += swapped;
            self.exec.look(u64::from(SWEEPS) * film.triangles.len() as u64)?;
            let pulls = Pulls::of(film, self.radius);
            if swapped == 0 && pulls.residual <= SETTLED && pulls.junction_residual <= SETTLED {
                break;
            }
        }
        let steps = self.limit.saturating_sub(self.iterations);
        Ok(match self.newton(film, self.tolerance, steps, "newton", 0.95)? {
            Newton::Converged => StopReason::Residual,
            Newton::StepsUsed => StopReason::MaxIterations,
            Newton::Stalled => StopReason::Stalled,
        })
    }

    /// Step 2: harmonic solves and remeshing until the area settles. Forgives any start.
    fn settle(&mut self, film: &mut Sheets) -> Result<(), Interruption> {
        let mut area = film.area();
        for round in 0..ROUNDS {
            let before = area;
            for _ in 0..SOLVES_PER_ROUND {
                self.exec.look(20 * film.triangles.len() as u64)?;
                if self.iterations >= self.limit || !dirichlet_step(film) {
                    return Ok(());
                }
                self.record(film, "pinkall_polthier", 0.4 * f64::from(round + 1) / f64::from(ROUNDS));
            }
            self.edges_swapped += film.remesh(SWEEPS);
            self.exec.look(u64::from(SWEEPS) * film.triangles.len() as u64)?;
            area = film.area();
            if (before - area).abs() <= SETTLED_AREA * area {
                break;
            }
        }
        Ok(())
    }

    /// One more solve, for the history and the caller.
    fn record(&mut self, film: &Sheets, phase: &'static str, fraction: f64) {
        self.iterations += 1;
        let pulls = Pulls::of(film, self.radius);
        let (residual, area) = (pulls.residual.max(pulls.junction_residual), film.area());
        self.history.push(HistoryRow { phase, iteration: self.iterations, area, residual });
        self.exec.report(Progress {
            fraction,
            phase,
            iteration: u64::from(self.iterations),
            objective_value: Some(area),
            residual: Some(residual),
        });
    }

    /// Newton's method with a shift where the second variation is indefinite, and a line search on the area.
    fn newton(
        &mut self,
        film: &mut Sheets,
        tolerance: f64,
        steps: u32,
        phase: &'static str,
        share: f64,
    ) -> Result<Newton, Interruption> {
        let mut symbolic = None;
        for step in 0..=steps {
            let pulls = Pulls::of(film, self.radius);
            let converged = pulls.residual <= tolerance && pulls.junction_residual <= tolerance;
            let directions = Directions::of(film);
            let mut second = SecondVariation::new(film, &directions);
            // The last look at a converged film is for its index.
            if (converged && phase != "newton") || (!converged && (step == steps || self.iterations >= self.limit)) {
                return Ok(if converged { Newton::Converged } else { Newton::StepsUsed });
            }
            let symbolic = match &symbolic {
                Some(symbolic) => symbolic,
                None => match Symbolic::analyse(&second.matrix, None) {
                    Ok(fresh) => symbolic.insert(fresh),
                    Err(_) => return Ok(Newton::Stalled),
                },
            };
            self.exec.look(40 * film.triangles.len() as u64 + symbolic.factor_entries() as u64)?;
            if converged {
                second.assemble(film, &directions, 0.0);
                self.morse_index = symbolic.factorise(&second.matrix).ok().map(|factors| factors.inertia().negative);
                return Ok(Newton::Converged);
            }
            let gradient = film.gradient(&film.vertices);
            let pull = directions.components(&gradient);
            let mut moved = None;
            for shift in SHIFTS {
                second.assemble(film, &directions, shift);
                let Ok(factors) = symbolic.factorise(&second.matrix) else { continue };
                if !factors.inertia().is_positive_definite() {
                    continue;
                }
                let mut heights: Vec<f64> = pull.iter().map(|pull| -pull).collect();
                if factors.solve(&mut heights).is_err() {
                    continue;
                }
                moved = self.search(film, &directions, &pull, &heights, &pulls);
                if moved.is_some() {
                    break;
                }
                self.exec.look(40 * film.triangles.len() as u64)?;
            }
            let Some(vertices) = moved else { return Ok(Newton::Stalled) };
            film.vertices = vertices;
            self.record(film, phase, share);
        }
        Ok(Newton::StepsUsed)
    }

    /// The step, halved until no triangle turns over and the area falls; where area is rounding, until the pulls do.
    fn search(
        &self,
        film: &Sheets,
        directions: &Directions,
        pull: &[f64],
        heights: &[f64],
        before: &Pulls,
    ) -> Option<Vec<DVec3>> {
        let slope: f64 = pull.iter().zip(heights).map(|(pull, height)| pull * height).sum();
        let area = film.area();
        let mut fraction = 1.0;
        while fraction >= LEAST_STEP {
            let vertices = directions.moved(film, heights, fraction);
            let keeps = film.triangles.iter().all(|&t| {
                let now = measure::double_area_vector(film.corners(t));
                now.dot(measure::double_area_vector(t.map(|v| vertices[v as usize]))) > 0.0
            });
            if keeps {
                let moved = Sheets { vertices, ..film.clone() };
                let gains = if (fraction * slope).abs() <= 1e-12 * area {
                    let after = Pulls::of(&moved, self.radius);
                    after.residual.max(after.junction_residual) < before.residual.max(before.junction_residual)
                } else {
                    moved.area() <= area + 1e-4 * fraction * slope
                };
                if gains {
                    return Some(moved.vertices);
                }
            }
            fraction *= 0.5;
        }
        None
    }
}

/// How far a film is from balance.
#[derive(Clone, Debug)]
struct Pulls {
    /// Per vertex |g| / (2 A_h) inside the sheets, else 0.
    mean_curvature: Vec<f64>,
    /// max |g·n| R / (2 A_h) inside the sheets.
    residual: f64,
    /// The same with the whole gradient.
    residual_full: f64,
    /// max |g⊥| / ℓ on the junctions, ℓ half the length of the junction edges at the vertex.
    junction_residual: f64,
}

impl Pulls {
    fn of(film: &Sheets, radius: f64) -> Self {
        let gradient = film.gradient(&film.vertices);
        let count = film.vertices.len();
        let (mut normals, mut area, mut length) = (vec![DVec3::ZERO; count], vec![0.0; count], vec![0.0; count]);
        for &triangle in &film.triangles {
            let vector = measure::double_area_vector(film.corners(triangle));
            for v in triangle {
                normals[v as usize] += vector;
                area[v as usize] += vector.length() / 6.0;
            }
        }
        for &[a, b] in &film.junctions {
            let half = 0.5 * film.vertices[a as usize].distance(film.vertices[b as usize]);
            length[a as usize] += half;
            length[b as usize] += half;
        }
        let mut pulls =
            Self { mean_curvature: vec![0.0; count], residual: 0.0, residual_full: 0.0, junction_residual: 0.0 };
        // A vanishing ring is as far from balance as can be.
        let over = |pull: f64, share: f64| if share > 0.0 { pull / share } else { f64::MAX.sqrt() };
        for v in 0..count {
            match film.kinds[v] {
                Kind::Fixed => {}
                Kind::Sheet => {
                    let full = over(gradient[v].length(), 2.0 * area[v]);
                    let normal = over(gradient[v].dot(normals[v].normalize_or_zero()).abs(), 2.0 * area[v]);
                    pulls.mean_curvature[v] = full;
                    pulls.residual = pulls.residual.max(normal * radius);
                    pulls.residual_full = pulls.residual_full.max(full * radius);
                }
                Kind::Junction(_) => {
                    let across = gradient[v].reject_from_normalized(film.tangent(v)).length();
                    pulls.junction_residual = pulls.junction_residual.max(over(across, length[v]));
                }
                Kind::Point => {
                    pulls.junction_residual = pulls.junction_residual.max(over(gradient[v].length(), length[v]));
                }
            }
        }
        pulls
    }
}

/// The three angles between directions around an axis; they add up to a full turn where all lie across it.
fn angles_around(axis: DVec3, directions: [DVec3; 3]) -> [f64; 3] {
    let (u, v) = axis.any_orthonormal_pair();
    let mut at = directions.map(|direction| direction.dot(v).atan2(direction.dot(u)));
    at.sort_by(f64::total_cmp);
    [at[1] - at[0], at[2] - at[1], at[0] - at[2] + std::f64::consts::TAU]
}

fn junction_statistics(film: &Sheets, pulls: &Pulls, morse_index: Option<usize>) -> JunctionStatistics {
    let mut facets = Vec::new();
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); film.vertices.len()];
    for (t, &triangle) in film.triangles.iter().enumerate() {
        triangle.iter().for_each(|&v| around[v as usize].push(t));
        let corners = film.corners(triangle);
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            if film.junctions.binary_search(&[a.min(b), a.max(b)]).is_ok() {
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
            let Kind::Junction(beside) = film.kinds[v] else { return None };
            let inside = beside.iter().all(|&v| matches!(film.kinds[v as usize], Kind::Junction(_)));
            Some((inside, angles_around(film.tangent(v), sheet_pulls(film, v as u32, &around[v])?)))
        })
        .collect();
    let sheet_angles = || at_vertices.iter().flat_map(|(_, angles)| *angles);
    let departure = |angles: &[f64]| angles.iter().map(|angle| (angle - THIRD_OF_TURN).abs()).fold(0.0, f64::max);
    let departures =
        |inside: bool| at_vertices.iter().filter(move |vertex| vertex.0 == inside).map(|(_, angles)| departure(angles));
    let at_ends = departures(false).fold(0.0, f64::max);
    let away = departures(true).reduce(f64::max);
    // A junction of one edge has no inner vertex, but facets.
    let (largest, mean) = if at_vertices.is_empty() {
        let mean = Spread::of(facet_angles.iter().map(|angle| (angle - THIRD_OF_TURN).abs())).mean;
        (departure(&facet_angles), mean)
    } else {
        (away.unwrap_or(at_ends), Spread::of(sheet_angles().map(|angle| (angle - THIRD_OF_TURN).abs())).mean)
    };
    let length = |&[a, b]: &[u32; 2]| film.vertices[a as usize].distance(film.vertices[b as usize]);
    JunctionStatistics {
        sheets: film.sheets.len(),
        curves: film.curves(),
        edges: film.junctions.len(),
        points: film.kinds.iter().filter(|kind| **kind == Kind::Point).count(),
        length: film.junctions.iter().map(length).sum(),
        residual: pulls.junction_residual,
        largest_deviation: largest,
        largest_deviation_at_ends: at_ends,
        mean_deviation: mean,
        facet_angles: Spread::of(facet_angles.into_iter()),
        sheet_angles: Spread::of(sheet_angles()),
        morse_index,
    }
}

/// The pulls (against the area gradient) of the three sheets' sides at a vertex inside a junction, each the sum over the fan of triangles from one
/// junction edge to the other. `None` where the sides cannot be told apart.
fn sheet_pulls(film: &Sheets, v: u32, around: &[usize]) -> Option<[DVec3; 3]> {
    let Kind::Junction([before, after]) = film.kinds[v as usize] else { return None };
    let mut pulls = Vec::new();
    for &start in around.iter().filter(|&&t| film.triangles[t].contains(&before)) {
        let (mut pull, mut t, mut spoke) = (DVec3::ZERO, start, before);
        loop {
            let triangle = film.triangles[t];
            let k = triangle.iter().position(|&corner| corner == v)?;
            let corners = film.corners(triangle);
            let normal = measure::double_area_vector(corners).normalize_or_zero();
            pull -= 0.5 * normal.cross(corners[(k + 2) % 3] - corners[(k + 1) % 3]);
            spoke = *triangle.iter().find(|&&corner| corner != v && corner != spoke)?;
            if spoke == after {
                break;
            }
            // The next triangle of the fan shares the spoke, which has two triangles.
            t = *around.iter().find(|&&u| u != t && film.triangles[u].contains(&spoke))?;
        }
        pulls.push(pull);
    }
    <[DVec3; 3]>::try_from(pulls).ok()
}

#[allow(clippy::too_many_arguments, reason = "one call, each argument its own kind of thing")]
fn collect(
    film: &Sheets,
    pulls: &Pulls,
    junctions: JunctionStatistics,
    solver: &JunctionSolver,
    stop_reason: StopReason,
    initial_area: f64,
    boundary_loops: usize,
    options: &Options,
) -> Statistics {
    let mesh = Mesh::new(film.vertices.clone(), film.triangles.clone());
    let area = film.area();
    let free: Vec<f64> =
        (0..film.vertices.len()).filter(|&v| film.kinds[v] == Kind::Sheet).map(|v| pulls.mean_curvature[v]).collect();
    let curvature = Spread::of(free.iter().copied());
    let rms = (free.iter().map(|h| h * h).sum::<f64>() / free.len().max(1) as f64).sqrt();
    let (smallest_angle, largest_angle) = measure::angle_range(&mesh);
    let flipped_triangles = film.flipped_triangles();
    let degenerate_triangles = measure::degenerate_triangles(&mesh);
    let balanced = pulls.residual <= options.tolerance && junctions.residual <= options.tolerance;
    Statistics {
        objective: options.method.objective(),
        objective_value: area,
        solver: Solver::Newton,
        initial_mesh: InitialMeshKind::Given,
        vertices: mesh.vertices.len(),
        triangles: mesh.triangles.len(),
        boundary_loops,
        components: film.components(),
        euler_characteristic: film.euler_characteristic(),
        // Of a film that is no surface: not defined, and the sheets of a film with junctions are discs as a rule.
        genus: None,
        area,
        initial_area,
        extrapolated_area: None,
        mean_curvature: MeanCurvature { max: curvature.max, mean: curvature.mean, rms },
        residual: pulls.residual,
        residual_full: pulls.residual_full,
        converged: balanced && flipped_triangles == 0 && degenerate_triangles == 0,
        stop_reason,
        iterations: solver.iterations,
        history: solver.history.clone(),
        stability: None,
        edge_lengths: Spread::of(film.edge_lengths().into_iter()),
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
