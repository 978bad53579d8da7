//! Minimal surfaces: the least area, or another energy, among the meshes that span closed boundary polygons.
//!
//! [`solve`] is the front door: boundary polygons and a resolution in; a mesh, its measurements and the reason why the
//! solver stopped out. The boundary never moves; everything else is the solver's to place.
//!
//! Sources: Chen, Cai, Zheng, *Constructing Triangular Meshes of Minimal Area* (2008); Pinkall, Polthier, *Computing
//! Discrete Minimal Surfaces and Their Conjugates* (1993).

mod bento_cavalcanti;
mod coarse_to_fine;
mod cotangent;
mod crossing;
mod descent;
mod extrapolation;
mod film;
mod free_topology;
mod initial_mesh;
mod mean_curvature_lm;
mod multigrid;
mod newton;
mod pinkall_polthier;
mod record;
mod remesh;
mod resample;
mod spanning_topology;
mod stability;
mod statistics;
#[cfg(test)]
mod structured;
mod topology_change;
mod triple_junction;
mod vertex_relaxation;

pub use extrapolation::ExtrapolatedArea;
pub use initial_mesh::InitialMeshKind;
pub use spanning_topology::{SpanningComparison, SpanningTopology};
pub use statistics::{Curvature, HistoryRow, MeanCurvature, Pinch, Stability, StabilityMethod, Statistics, StopReason};
pub use triple_junction::JunctionStatistics;
pub use vertex_relaxation::Process;

use crate::error::{InputError, Warning};
use crate::polyline::{LARGEST_COORDINATE, merge_equal_neighbours};
use crate::{DVec3, Error, Execution, Mesh, Place};
use film::{Film, Run};

/// What is made least.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Objective {
    /// The sum of the triangles' areas.
    #[default]
    MinimalArea,
    /// The Dirichlet energy of the piecewise linear map from the (Delaunay) initial mesh: one linear solve.
    MinimalDirichletEnergy,
    /// Liu and Wang: half the sum of the squared discrete mean curvatures.
    MinimalMeanCurvature,
}

/// One objective, for people and for catalogues.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Description {
    pub name: &'static str,
    pub minimises: &'static str,
    pub unit: &'static str,
    pub source: &'static str,
}

impl Objective {
    pub const ALL: [Self; 3] = [Self::MinimalArea, Self::MinimalDirichletEnergy, Self::MinimalMeanCurvature];

    #[must_use]
    pub fn name(self) -> &'static str {
        self.describe().name
    }

    #[must_use]
    pub fn describe(self) -> Description {
        match self {
            Self::MinimalArea => Description {
                name: "minimal_area",
                minimises: "the sum of the triangles' areas, boundary fixed",
                unit: "u²",
                source: "Chen, Cai, Zheng 2008, eq. 3",
            },
            Self::MinimalDirichletEnergy => Description {
                name: "minimal_dirichlet_energy",
                minimises: "the Dirichlet energy ¼ Σ (cot α + cot β) |a'|² of the map from the initial mesh, boundary fixed",
                unit: "u²",
                source: "Pinkall, Polthier 1993, section 2",
            },
            Self::MinimalMeanCurvature => Description {
                name: "minimal_mean_curvature",
                minimises: "half the sum of squared mean curvatures (angle between normals times half the edge, over a \
                    third of the ring's area), lengths divided by the boundary's radius",
                unit: "1",
                source: "Liu, Wang 2011, eq. 1",
            },
        }
    }
}

/// How the area is minimised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solver {
    /// The best of the others for the request at hand; the statistics say which one ran.
    #[default]
    Auto,
    /// Chen, Cai, Zheng: Laplacian fairing, area minimising vertex by vertex, edge swapping.
    VertexRelaxation,
    /// Pinkall, Polthier: the harmonic map from the current mesh, again and again.
    PinkallPolthier,
    /// A few Pinkall-Polthier solves, then Newton's method in normal heights.
    Newton,
    /// Liu, Wang: Levenberg and Marquardt on the mean curvatures. For [`Objective::MinimalMeanCurvature`] alone.
    LevenbergMarquardt,
}

impl Solver {
    pub const ALL: [Self; 5] =
        [Self::Auto, Self::VertexRelaxation, Self::PinkallPolthier, Self::Newton, Self::LevenbergMarquardt];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::VertexRelaxation => "vertex_relaxation",
            Self::PinkallPolthier => "pinkall_polthier",
            Self::Newton => "newton",
            Self::LevenbergMarquardt => "levenberg_marquardt",
        }
    }
}

/// Whether the film keeps the topology of the initial mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Topology {
    #[default]
    Fixed,
    /// Necks may close, so that a film falls apart where no connected one is stable (Bento, Cavalcanti).
    Free,
    /// The least of all films that span the boundaries: connected ones, separate discs, and everything between. The
    /// statistics list the others.
    Best,
}

impl Topology {
    pub const ALL: [Self; 3] = [Self::Fixed, Self::Free, Self::Best];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Fixed => "fixed",
            Self::Free => "free",
            Self::Best => "best",
        }
    }
}

/// How [`Solver::PinkallPolthier`] solves its linear systems.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LinearSolver {
    /// Elimination (L D Lᵀ) every time.
    #[default]
    Direct,
    /// Conjugate gradients, and elimination where they do not converge (Bento, Cavalcanti).
    ConjugateGradients,
}

impl LinearSolver {
    pub const ALL: [Self; 2] = [Self::Direct, Self::ConjugateGradients];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Direct => "direct",
            Self::ConjugateGradients => "conjugate_gradients",
        }
    }
}

/// How fine the mesh is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resolution {
    /// Number of triangles. Exact for [`InitialMesh::Rings`] with [`BoundarySampling::Keep`], else within 10%.
    Triangles(usize),
    /// Mean edge length, in the caller's unit.
    EdgeLength(f64),
    /// Number of vertices that are not on the boundary.
    InteriorVertices(usize),
}

/// Whether points may be added on the segments of the boundary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoundarySampling {
    /// Points are added on long segments, so that the mesh is as fine there as inside.
    #[default]
    Refine,
    /// The polygon's own vertices only, as in the papers.
    Keep,
}

/// The mesh that the solver starts from. It also settles the topology of the result.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum InitialMesh {
    /// The best of the others for the boundaries at hand; the statistics say which one it was.
    #[default]
    Auto,
    /// Delaunay triangles in the plane in which the boundaries enclose most, where their projection is simple.
    Planar,
    /// Delaunay triangles in a round disc (with a round hole for every further boundary), mapped harmonically.
    Disk,
    /// Chen, Cai, Zheng 3.4: rings towards the mean of the boundary; between two boundaries, rings from one to the other.
    Rings,
    /// Liu, Wang: points at barycentres inside one boundary, chosen by [`Options::seed`], in a Delaunay triangulation.
    /// What [`InitialMesh::Auto`] is for one boundary under [`Objective::MinimalMeanCurvature`].
    Barycentres,
    /// The caller's own: an oriented manifold whose boundary loops are the boundaries, exactly, with or without further
    /// vertices on their segments. The resolution then means nothing. A mesh with edges of three triangles is a film with
    /// junctions: the sheets meet there at 120° in the result, and the boundaries together must be its edges of one triangle.
    Given(Mesh),
}

/// Points and curves inside the surface that stay where they are: mesh vertices and edges at exactly these places.
///
/// A point that equals a boundary's point, or another of these, is one vertex with it. Curves may share points, but not cross.
/// With [`BoundarySampling::Refine`] points are added on long segments.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Constraints {
    pub points: Vec<DVec3>,
    pub polylines: Vec<Vec<DVec3>>,
}

impl Constraints {
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty() && self.polylines.is_empty()
    }

    fn check(&self, errors: &mut Vec<InputError>) {
        let place = || Place::field("constraints");
        let usable = |point: DVec3| point.is_finite() && point.abs().max_element() <= LARGEST_COORDINATE;
        let detail = "every coordinate must be a finite number of magnitude at most 1e50";
        for (k, &point) in self.points.iter().enumerate() {
            if !usable(point) {
                errors.push(InputError::new(place().then("points").at(k), detail));
            }
        }
        for (k, polyline) in self.polylines.iter().enumerate() {
            let place = || place().then("polylines").at(k);
            for (i, &point) in polyline.iter().enumerate() {
                if !usable(point) {
                    errors.push(InputError::new(place().at(i), detail));
                }
            }
            if polyline.iter().all(|point| *point == polyline[0]) {
                errors.push(InputError::new(place(), "needs at least two distinct points"));
            }
        }
    }
}

/// What to do with a stationary surface that is no local minimum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OnUnstable {
    /// Return it, and say so.
    #[default]
    Report,
    /// Leave it along its lowest mode and go on to a minimum.
    Descend,
}

/// Meshes larger than this are refused: half-edges are numbered with 32 bits.
pub const LARGEST_COUNT: usize = 100_000_000;

/// What a solve is asked for. [`Options::new`] gives the defaults; only the resolution has none.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    pub objective: Objective,
    pub solver: Solver,
    pub resolution: Resolution,
    pub boundary_sampling: BoundarySampling,
    pub initial_mesh: InitialMesh,
    pub constraints: Constraints,
    /// The residual (dimensionless, see [`Statistics::residual`]) at which a surface counts as converged.
    pub tolerance: f64,
    /// Relative change of area per iteration at which [`Solver::VertexRelaxation`] ends its area minimising (ε₂);
    /// Liu and Wang's ε for [`Solver::LevenbergMarquardt`].
    pub area_tolerance: f64,
    /// The same for its Laplacian fairing (ε₁); `None`: as `area_tolerance`.
    pub fairing_tolerance: Option<f64>,
    /// Stages of [`Solver::VertexRelaxation`] in the caller's own order, each repeated until its tolerance; `None`: the paper's.
    pub processes: Option<Vec<Vec<Process>>>,
    pub on_unstable: OnUnstable,
    /// `None`: the solver's own default (10,000 sweeps of vertex relaxation, 200 linear solves, 500 steps of Levenberg
    /// and Marquardt).
    pub max_iterations: Option<u32>,
    pub topology: Topology,
    /// How [`Solver::PinkallPolthier`] solves its systems.
    pub linear_solver: LinearSolver,
    /// Triangles with an angle below this (radians) are removed by [`Solver::PinkallPolthier`] and under
    /// [`Topology::Free`]; `None`: none is.
    pub degenerate_angle: Option<f64>,
    /// Which of the candidate points [`InitialMesh::Barycentres`] takes.
    pub seed: u64,
    /// Whether the boundary's vertices count in [`Objective::MinimalMeanCurvature`] (with their interior edges), as
    /// Liu and Wang's do.
    pub boundary_curvature: bool,
}

impl Options {
    #[must_use]
    pub fn new(resolution: Resolution) -> Self {
        Self {
            objective: Objective::default(),
            solver: Solver::default(),
            resolution,
            boundary_sampling: BoundarySampling::default(),
            initial_mesh: InitialMesh::default(),
            constraints: Constraints::default(),
            tolerance: 1e-6,
            area_tolerance: 1e-6,
            fairing_tolerance: None,
            processes: None,
            on_unstable: OnUnstable::default(),
            max_iterations: None,
            topology: Topology::default(),
            linear_solver: LinearSolver::default(),
            degenerate_angle: Some(1f64.to_radians()),
            seed: 1,
            boundary_curvature: true,
        }
    }

    /// The same with all positions relative to a centre.
    fn centred(&self, centre: DVec3) -> Self {
        let mut options = self.clone();
        if let InitialMesh::Given(mesh) = &mut options.initial_mesh {
            mesh.vertices.iter_mut().for_each(|vertex| *vertex -= centre);
        }
        let Constraints { points, polylines } = &mut options.constraints;
        points.iter_mut().chain(polylines.iter_mut().flatten()).for_each(|point| *point -= centre);
        options
    }

    fn check(&self) -> Vec<InputError> {
        let mut errors = Vec::new();
        let positive = [
            ("tolerance", Some(self.tolerance)),
            ("area_tolerance", Some(self.area_tolerance)),
            ("fairing_tolerance", self.fairing_tolerance),
        ];
        for (name, value) in positive {
            if value.is_some_and(|value| !(value.is_finite() && value >= 0.0)) {
                errors.push(InputError::new(Place::field(name), "must be a finite number, not negative"));
            }
        }
        if let Resolution::EdgeLength(length) = self.resolution
            && !(length.is_finite() && length > 0.0)
        {
            let place = Place::field("resolution").then("edge_length");
            errors.push(InputError::new(place, "must be a finite number above 0"));
        }
        let least_squares = self.objective == Objective::MinimalMeanCurvature;
        if self.solver != Solver::Auto && (self.solver == Solver::LevenbergMarquardt) != least_squares {
            let detail = format!("{} does not solve {}", self.solver.name(), self.objective.name());
            errors.push(InputError::new(Place::field("solver"), detail));
        }
        let dirichlet = self.objective == Objective::MinimalDirichletEnergy;
        if dirichlet && !matches!(self.solver, Solver::Auto | Solver::PinkallPolthier) {
            let detail = format!("{} does not solve {}", self.solver.name(), self.objective.name());
            errors.push(InputError::new(Place::field("solver"), detail));
        }
        if self.topology != Topology::Fixed
            && (least_squares
                || dirichlet
                || matches!(self.solver, Solver::VertexRelaxation | Solver::LevenbergMarquardt)
                || (self.solver == Solver::PinkallPolthier && self.topology == Topology::Best))
        {
            let detail = "is for the minimal area, under auto, newton and (free alone) pinkall_polthier";
            errors.push(InputError::new(Place::field("topology"), detail));
        }
        if self.degenerate_angle.is_some_and(|angle| !(angle > 0.0 && angle <= LARGEST_DEGENERATE_ANGLE)) {
            errors
                .push(InputError::new(Place::field("degenerate_angle_deg"), "must be above 0 and at most 20 degrees"));
        }
        self.constraints.check(&mut errors);
        if self.topology == Topology::Best && self.initial_mesh != InitialMesh::Auto {
            let detail = "best spans every set of boundaries by itself and takes auto alone";
            errors.push(InputError::new(Place::field("initial_mesh"), detail));
        }
        if !self.constraints.is_empty() && self.topology != Topology::Fixed {
            let detail = "a film with fixed points or curves keeps its topology";
            errors.push(InputError::new(Place::field("topology"), detail));
        }
        let counted = match self.resolution {
            Resolution::Triangles(count) => Some(("triangles", count)),
            Resolution::InteriorVertices(count) => Some(("interior_vertices", count)),
            Resolution::EdgeLength(_) => None,
        };
        if let Some((name, _)) = counted.filter(|&(_, count)| count > LARGEST_COUNT) {
            let detail = format!("must be at most {LARGEST_COUNT}");
            errors.push(InputError::new(Place::field("resolution").then(name), detail));
        }
        if let Some(stages) = &self.processes {
            for (k, stage) in stages.iter().enumerate() {
                if stage.iter().all(|process| *process == Process::EdgeSwapping) {
                    let place = Place::field("processes").at(k);
                    errors.push(InputError::new(place, "a stage needs laplacian_fairing or area_minimising"));
                }
            }
        }
        errors
    }
}

/// The mesh vertices of [`Constraints`], in their order; points added on curves are not listed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ConstraintVertices {
    pub points: Vec<u32>,
    pub polylines: Vec<Vec<u32>>,
}

/// A mesh that spans the boundaries, and what is known about it.
#[derive(Clone, Debug, PartialEq)]
pub struct MinimalSurface {
    /// Vertices: the input's points in input order, boundary by boundary, equal neighbours once, at exactly the given
    /// coordinates; then points added on the boundaries; then the interior.
    pub mesh: Mesh,
    /// Each boundary as a loop of mesh vertices, in the input's direction, added points included.
    pub boundaries: Vec<Vec<u32>>,
    /// For each input point its vertex.
    pub input_vertices: Vec<Vec<u32>>,
    /// For each fixed point, and each fixed curve's point, its vertex.
    pub constraints: ConstraintVertices,
    /// Per vertex |area gradient| / (2/3 of the ring's area), in 1/unit; 0 where the vertex is fixed.
    pub mean_curvature: Vec<f64>,
    /// For an unstable surface the direction in which to leave it: per vertex the lowest mode of its second variation, along the
    /// normal, the largest of length 1. Either sign lowers the area.
    pub way_down: Option<Vec<DVec3>>,
    pub statistics: Statistics,
    pub warnings: Vec<Warning>,
}

/// Spans the boundaries (closed polygons that do not repeat their first point) with a mesh that makes the objective least.
///
/// The result is an oriented manifold whose boundary loops are exactly the given ones. It depends on nothing but the
/// arguments, to the byte, and turns, moves and scales with them up to rounding. Exactly equal neighbouring points are
/// merged, with the warning `merged_points`. The least found is a *local* one: a boundary may bound several minimal
/// surfaces, and which one comes out follows from the initial mesh. A surface that stopped above the tolerance is
/// returned with `converged: false` and the warning `not_converged`, at a deadline too.
///
/// # Errors
/// [`Error::Input`] for what the arguments themselves show (a coordinate that is not finite or beyond 1e50, neighbours
/// nearer than 1e-50 and not equal, fewer than three distinct points on a boundary, an impossible resolution); [`Error::NoResult`] if no valid mesh came out;
/// [`Error::Interrupted`] on cancel, and on a deadline that passes before there is a mesh.
pub fn solve(boundaries: &[Vec<DVec3>], options: &Options, exec: &Execution) -> Result<MinimalSurface, Error> {
    let input = Input::read(boundaries, options)?;
    exec.look(input.point_count() as u64)?;
    if let InitialMesh::Given(mesh) = &options.initial_mesh
        && triple_junction::has_junctions(&mesh.triangles)
    {
        let mut surface = triple_junction::solve(&input.given, &input.vertices, mesh, options, exec)?;
        surface.warnings.extend(input.merged_points());
        return Ok(surface);
    }
    let given = options;
    let options = &options.centred(input.centre);
    let newton = matches!(options.solver, Solver::Auto | Solver::Newton) && options.objective == Objective::MinimalArea;
    let solved = match options.topology {
        Topology::Best => Some(spanning_topology::solve(&input.centred, options, exec)?),
        Topology::Fixed if newton => coarse_to_fine::solve(&input.centred, options, exec)?,
        _ => None,
    };
    let (film, kind, initial_area, run) = match solved {
        Some(solved) => solved,
        None => {
            let (start, kind) = initial_mesh::build(&input.centred, options, exec)?;
            let mut film = start.refined(exec)?;
            let initial_area = film.area();
            let run = relax(&mut film, options, exec)?;
            (film, kind, initial_area, run)
        }
    };
    finish(input, film, kind, initial_area, run, given)
}

/// Runs the solver that is asked for from an initial mesh of the full size.
fn relax(film: &mut Film, options: &Options, exec: &Execution) -> Result<Run, Error> {
    match (options.objective, options.solver) {
        (Objective::MinimalMeanCurvature, _) | (_, Solver::LevenbergMarquardt) => {
            mean_curvature_lm::run(film, options, exec)
        }
        (Objective::MinimalDirichletEnergy, _) => pinkall_polthier::run_once(film, exec),
        (_, Solver::VertexRelaxation) => vertex_relaxation::run(film, options, exec),
        (_, Solver::PinkallPolthier) => bento_cavalcanti::run(film, options, exec),
        (_, Solver::Auto | Solver::Newton) if options.topology == Topology::Free => {
            free_topology::run(film, options, exec)
        }
        (_, Solver::Auto | Solver::Newton) => descent::run(film, options, exec),
    }
}

/// What [`solve`] would say of its arguments before any work: linear in the number of points.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with. Arguments that pass may still turn out to have no valid mesh.
pub fn check(boundaries: &[Vec<DVec3>], options: &Options) -> Result<(), Error> {
    let input = Input::read(boundaries, options)?;
    if let InitialMesh::Given(mesh) = &options.initial_mesh
        && triple_junction::has_junctions(&mesh.triangles)
    {
        return triple_junction::check(&input.given, mesh, options);
    }
    initial_mesh::check(&input.centred, &options.centred(input.centre))
}

/// About how many triangles a request asks for, so that a service can price it before the work.
///
/// Exact where a count is asked for; for an edge length the area of the boundaries' fans about their means is divided by
/// that of an equilateral triangle (but the boundary's own points ask for some each), which is right within a small factor unless the boundaries are far apart.
#[must_use]
pub fn estimate_triangles(boundaries: &[Vec<DVec3>], options: &Options) -> f64 {
    let points: usize = boundaries.iter().map(Vec::len).sum();
    if let InitialMesh::Given(mesh) = &options.initial_mesh {
        return mesh.triangles.len() as f64;
    }
    match options.resolution {
        Resolution::Triangles(count) => count as f64,
        Resolution::InteriorVertices(count) => (2 * count + points) as f64,
        Resolution::EdgeLength(length) => {
            triangles_of_length(boundaries, length).max(TRIANGLES_PER_POINT * points as f64)
        }
    }
}

/// How many equilateral triangles of an edge length cover the boundaries' fans.
fn triangles_of_length(boundaries: &[Vec<DVec3>], length: f64) -> f64 {
    area_of_fans(boundaries) / (length * length * 0.75_f64.sqrt() * 0.5)
}

/// The area of all boundaries' fans about the mean of their points.
fn area_of_fans(boundaries: &[Vec<DVec3>]) -> f64 {
    let all: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
    let centre = crate::polyline::mean(&all);
    let fans = boundaries.iter().flat_map(|boundary| {
        let next = boundary.iter().cycle().skip(1);
        boundary.iter().zip(next).map(|(&a, &b)| 0.5 * (a - centre).cross(b - centre).length())
    });
    fans.sum()
}

/// The boundaries without equal neighbours, and around the origin, so that an offset of 1e7 costs no digits.
#[derive(Debug)]
struct Input {
    centre: DVec3,
    given: Vec<Vec<DVec3>>,
    centred: Vec<Vec<DVec3>>,
    /// For each input point its vertex.
    vertices: Vec<Vec<u32>>,
    dropped: usize,
}

/// About how many triangles a boundary of points much closer than the edge length has for each, graded.
const TRIANGLES_PER_POINT: f64 = 12.0;
/// How far a resolution may be missed without a warning.
const RESOLUTION_TOLERANCE: f64 = 0.1;

/// A third of an equilateral triangle's angle: rules against thinner ones leave good triangles alone.
const LARGEST_DEGENERATE_ANGLE: f64 = std::f64::consts::PI / 9.0;

/// Between neighbours on a boundary: products of six lengths must not vanish.
const SMALLEST_DISTANCE: f64 = 1e-50;

impl Input {
    fn read(boundaries: &[Vec<DVec3>], options: &Options) -> Result<Self, Error> {
        let mut errors = options.check();
        let place = || Place::field("boundaries");
        if boundaries.is_empty() {
            errors.push(InputError::new(place(), "needs at least one closed polygon"));
        }
        let mut given = Vec::with_capacity(boundaries.len());
        let mut vertices = Vec::with_capacity(boundaries.len());
        let (mut first, mut dropped) = (0u32, 0);
        for (k, boundary) in boundaries.iter().enumerate() {
            for (i, point) in boundary.iter().enumerate() {
                if !(point.is_finite() && point.abs().max_element() <= LARGEST_COORDINATE) {
                    let detail = "every coordinate must be a finite number of magnitude at most 1e50";
                    errors.push(InputError::new(place().at(k).at(i), detail));
                }
            }
            let merged = merge_equal_neighbours(boundary, true);
            let next = |i: usize| merged.points[(i + 1) % merged.points.len()];
            if let Some(i) = (0..merged.points.len()).find(|&i| merged.points[i].distance(next(i)) < SMALLEST_DISTANCE)
                && merged.points.len() > 1
            {
                let detail = "lies nearer than 1e-50 to its neighbour, too near to compute with";
                errors.push(InputError::new(place().at(k).at(merged.source[i]), detail));
            }
            let mut distinct: Vec<[f64; 3]> = merged.points.iter().map(|p| (*p + DVec3::ZERO).to_array()).collect();
            distinct.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
            distinct.dedup();
            if distinct.len() < 3 {
                errors.push(InputError::new(place().at(k), "needs at least three distinct points"));
            }
            vertices.push(merged.vertex_of.iter().map(|&v| first + v as u32).collect());
            first += merged.points.len() as u32;
            dropped += merged.dropped();
            given.push(merged.points);
        }
        // The film between a loop and its double has no area: no size of triangle suits it.
        let mut seen = std::collections::BTreeMap::new();
        for (k, points) in given.iter().enumerate() {
            let mut keys: Vec<[u64; 3]> =
                points.iter().map(|p| (*p + DVec3::ZERO).to_array().map(f64::to_bits)).collect();
            keys.sort_unstable();
            if let Some(first) = seen.get(&keys) {
                let detail = format!("runs through the same points as boundary {first}");
                errors.push(InputError::new(place().at(k), detail));
            } else {
                seen.insert(keys, k);
            }
        }
        if !errors.is_empty() {
            return Err(Error::Input(errors));
        }
        let all: Vec<DVec3> = given.iter().flatten().copied().collect();
        let centre = crate::polyline::mean(&all);
        let centred = given.iter().map(|points| points.iter().map(|&p| p - centre).collect()).collect();
        Ok(Self { centre, given, centred, vertices, dropped })
    }

    fn merged_points(&self) -> Option<Warning> {
        let detail = format!("{} points equal to their neighbour were merged with it", self.dropped);
        (self.dropped > 0).then(|| Warning::new("merged_points", detail))
    }

    fn point_count(&self) -> usize {
        self.given.iter().map(Vec::len).sum()
    }
}

/// A warning where the edges are not as long as was asked for.
fn missed_edge_length(statistics: &Statistics, options: &Options) -> Option<Warning> {
    let Resolution::EdgeLength(length) = options.resolution else { return None };
    let mean = statistics.edge_lengths.mean;
    let missed =
        (mean / length - 1.0).abs() > RESOLUTION_TOLERANCE && !matches!(options.initial_mesh, InitialMesh::Given(_));
    missed.then(|| {
        let why = if mean < length {
            "the boundary's own points are closer, or the film shrank on the way"
        } else {
            "the boundary's own segments are longer and must be kept, or the film grew on the way"
        };
        let detail = format!(
            "the mean edge is {mean:.4e} long, not {length:.4e}: {why}; ask for a number of triangles to be sure of it"
        );
        Warning::new("edge_length_missed", detail)
    })
}

/// The fixed vertices by the bits of their (centred) coordinates.
fn fixed_places(film: &Film) -> Vec<([u64; 3], u32)> {
    let mut places: Vec<([u64; 3], u32)> = (0..film.vertices.len() as u32)
        .filter(|&v| film.fixed[v as usize])
        .map(|v| (initial_mesh::bits(film.vertices[v as usize]), v))
        .collect();
    places.sort_unstable();
    places
}

/// Gives the constraints' vertices exactly the given coordinates, and says which they are.
fn restore(mesh: &mut Mesh, fixed: &[([u64; 3], u32)], constraints: &Constraints, centre: DVec3) -> ConstraintVertices {
    let mut vertex = |&point: &DVec3| {
        let key = initial_mesh::bits(point - centre);
        let found = fixed.get(fixed.partition_point(|&(bits, _)| bits < key)).filter(|&&(bits, _)| bits == key);
        let &(_, vertex) = found?;
        mesh.vertices[vertex as usize] = point;
        Some(vertex)
    };
    ConstraintVertices {
        points: constraints.points.iter().filter_map(&mut vertex).collect(),
        polylines: constraints
            .polylines
            .iter()
            .map(|polyline| polyline.iter().filter_map(&mut vertex).collect())
            .collect(),
    }
}

/// Puts the mesh back where the caller's is, in the promised vertex order, and measures it.
fn finish(
    input: Input,
    film: Film,
    kind: InitialMeshKind,
    initial_area: f64,
    mut run: Run,
    options: &Options,
) -> Result<MinimalSurface, Error> {
    run.pinches.iter_mut().for_each(|pinch| pinch.place += input.centre);
    let mut way_down = run.way_down.take();
    let film = match film.boundary_first(input.point_count()) {
        None => film,
        Some(place) => {
            way_down = way_down.map(|direction| {
                let mut moved = vec![DVec3::ZERO; direction.len()];
                direction.iter().zip(&place).for_each(|(&direction, &v)| moved[v as usize] = direction);
                moved
            });
            film.renumbered(&place)
        }
    };
    let topology = film.mesh().check().map_err(|defect| {
        Error::no_result("invalid_mesh", format!("the solver left a mesh that is no oriented manifold ({defect})"))
    })?;
    let measured = Curvature::of(&film);
    let statistics =
        statistics::collect(&film, &topology, &measured, statistics::Origin { kind, initial_area, run }, options);
    let mut warnings = Vec::new();
    warnings.extend(input.merged_points());
    if !statistics.pinches.is_empty() {
        let detail = format!(
            "the film came apart at {} places; its topology is not the initial mesh's",
            statistics.pinches.len()
        );
        warnings.push(Warning::new("topology_changed", detail));
    }
    if let Some(spanning) = &statistics.spanning {
        warnings.extend(spanning.warnings());
    }
    warnings.extend(missed_edge_length(&statistics, options));
    if !statistics.converged {
        warnings.push(Warning::new("not_converged", statistics.shortfall(options.tolerance)));
    }
    if let Some(stability) = statistics.stability.filter(|stability| !stability.stable) {
        let detail = format!(
            "the surface is stationary but no minimum (Morse index {}): ask for on_unstable descend to leave it",
            stability.morse_index
        );
        warnings.push(Warning::new("unstable", detail));
    }
    let boundaries = film.boundaries.clone();
    let fixed = fixed_places(&film);
    let mut mesh = film.into_mesh();
    for vertex in &mut mesh.vertices {
        *vertex += input.centre;
    }
    for (vertex, &point) in mesh.vertices.iter_mut().zip(input.given.iter().flatten()) {
        *vertex = point;
    }
    let constraints = restore(&mut mesh, &fixed, &options.constraints, input.centre);
    Ok(MinimalSurface {
        mesh,
        boundaries,
        input_vertices: input.vertices,
        constraints,
        mean_curvature: measured.mean_curvature,
        way_down,
        statistics,
        warnings,
    })
}
