//! What a solve is asked for.

use crate::error::InputError;
use crate::polyline::LARGEST_COORDINATE;
use crate::{DVec3, Mesh, Place};

/// A third of an equilateral triangle's angle: rules against thinner ones leave good triangles alone.
const LARGEST_DEGENERATE_ANGLE: f64 = std::f64::consts::PI / 9.0;

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

/// One of the paper's three processes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Process {
    LaplacianFairing,
    AreaMinimising,
    EdgeSwapping,
}

impl Process {
    pub const ALL: [Self; 3] = [Self::LaplacianFairing, Self::AreaMinimising, Self::EdgeSwapping];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::LaplacianFairing => "laplacian_fairing",
            Self::AreaMinimising => "area_minimising",
            Self::EdgeSwapping => "edge_swapping",
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
    pub(crate) fn centred(&self, centre: DVec3) -> Self {
        let mut options = self.clone();
        if let InitialMesh::Given(mesh) = &mut options.initial_mesh {
            mesh.vertices.iter_mut().for_each(|vertex| *vertex -= centre);
        }
        let Constraints { points, polylines } = &mut options.constraints;
        points.iter_mut().chain(polylines.iter_mut().flatten()).for_each(|point| *point -= centre);
        options
    }

    pub(crate) fn check(&self) -> Vec<InputError> {
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
            errors.push(InputError::new(Place::field("degenerate_angle"), "must be above 0 and at most 20 degrees"));
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
