//! Options of a solve: objective, solver with its own options, resolution, initial mesh, constraints.

use plateau_mesh::error::InputError;
use plateau_mesh::polyline::LARGEST_COORDINATE;
use plateau_mesh::remesh::isotropic::BoundaryEdges;
use plateau_mesh::{DVec3, Mesh, Place};

/// Default of every tolerance on the relative change of the area.
const AREA_TOLERANCE: f64 = 1e-6;
/// Default ε of Liu and Wang's four stopping criteria.
const LEAST_SQUARES_TOLERANCE: f64 = 1e-6;
/// Default angle (radians) below which triangles are removed: one degree.
const DEGENERATE_ANGLE: f64 = std::f64::consts::PI / 180.0;
/// Largest value of `degenerate_angle` that is accepted, in radians: a third of the angle of an equilateral triangle,
/// so that good triangles are never removed.
const LARGEST_DEGENERATE_ANGLE: f64 = std::f64::consts::PI / 9.0;

/// A quantity that is minimised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Objective {
    /// The sum of the triangles' areas.
    #[default]
    MinimalArea,
    /// The Dirichlet energy of the piecewise linear map from the Delaunay-flipped initial mesh. It takes one linear
    /// solve.
    MinimalDirichletEnergy,
    /// Half the sum of the squared discrete mean curvatures (Liu, Wang).
    MinimalMeanCurvature,
}

/// Description of an objective, for documentation and for catalogues.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Description {
    /// A stable name in snake case.
    pub name: &'static str,
    /// The quantity that is minimised.
    pub minimises: &'static str,
    /// Its unit, where u is the caller's unit of length.
    pub unit: &'static str,
    /// The source of the formula in the literature.
    pub source: &'static str,
}

impl Objective {
    /// All objectives.
    pub const ALL: [Self; 3] = [Self::MinimalArea, Self::MinimalDirichletEnergy, Self::MinimalMeanCurvature];

    /// A stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.describe().name
    }

    /// Name, formula, unit and source.
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
                minimises: "the Dirichlet energy ¼ Σ (cot α + cot β) |a'|² of the map from the initial mesh, boundary \
                            fixed",
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

/// A process of Chen, Cai and Zheng's relaxation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Process {
    /// Every interior vertex moves at once to the area-weighted mean of its neighbours.
    LaplacianFairing,
    /// The vertices move one after the other, each towards the least area of its triangles.
    AreaMinimising,
    /// Edges are flipped where that lowers the area.
    EdgeSwapping,
}

impl Process {
    /// All processes.
    pub const ALL: [Self; 3] = [Self::LaplacianFairing, Self::AreaMinimising, Self::EdgeSwapping];

    /// A stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::LaplacianFairing => "laplacian_fairing",
            Self::AreaMinimising => "area_minimising",
            Self::EdgeSwapping => "edge_swapping",
        }
    }
}

/// A solver of this crate. The statistics report it by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// Laplacian fairing, area minimising vertex by vertex, and edge swapping (Chen, Cai, Zheng).
    VertexRelaxation,
    /// Repeated harmonic maps, each from the current mesh (Pinkall, Polthier).
    PinkallPolthier,
    /// A few Pinkall-Polthier solves, then Newton's method in normal heights.
    Newton,
    /// Levenberg and Marquardt's method on the mean curvatures (Liu, Wang).
    LevenbergMarquardt,
}

impl Solver {
    /// All solvers.
    pub const ALL: [Self; 4] = [Self::VertexRelaxation, Self::PinkallPolthier, Self::Newton, Self::LevenbergMarquardt];

    /// A stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::VertexRelaxation => "vertex_relaxation",
            Self::PinkallPolthier => "pinkall_polthier",
            Self::Newton => "newton",
            Self::LevenbergMarquardt => "levenberg_marquardt",
        }
    }
}

/// Objective and solver. Each variant stands for a solver and holds the options of that solver.
#[derive(Clone, Debug, PartialEq)]
pub enum Method {
    /// Least area by Newton's method. It is the default and the fastest, and it also computes the Morse index.
    Newton(Newton),
    /// Least area by Chen, Cai and Zheng's relaxation of one vertex at a time.
    VertexRelaxation(VertexRelaxation),
    /// Least area by Pinkall and Polthier's iteration with Bento and Cavalcanti's rules against thin triangles.
    PinkallPolthier(PinkallPolthier),
    /// Least Dirichlet energy: one harmonic map from the initial mesh.
    Harmonic,
    /// Least sum of squared mean curvatures, after Liu and Wang.
    LiuWang(LiuWang),
}

impl Default for Method {
    fn default() -> Self {
        Self::Newton(Newton::default())
    }
}

impl Method {
    /// The objective of the method.
    #[must_use]
    pub fn objective(&self) -> Objective {
        match self {
            Self::Newton(_) | Self::VertexRelaxation(_) | Self::PinkallPolthier(_) => Objective::MinimalArea,
            Self::Harmonic => Objective::MinimalDirichletEnergy,
            Self::LiuWang(_) => Objective::MinimalMeanCurvature,
        }
    }
}

/// Options of [`Method::Newton`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Newton {
    /// Whether the film keeps the topology of the initial mesh.
    pub topology: TopologyRule,
    /// Treatment of an unstable surface. Under [`TopologyRule::Free`] and [`TopologyRule::Best`] this option has no
    /// effect: the solver always moves away from an unstable surface.
    pub on_unstable: OnUnstable,
}

/// Whether the film keeps the topology of the initial mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum TopologyRule {
    /// The topology stays.
    #[default]
    Fixed,
    /// Necks may close. The film then comes apart if no connected film is stable (Bento, Cavalcanti).
    Free(FreeTopology),
    /// The film of least area among all that span the boundaries: connected films, separate discs, and everything
    /// between. The statistics list the other films.
    Best,
}

/// Options of [`TopologyRule::Free`].
#[derive(Clone, Debug, PartialEq)]
pub struct FreeTopology {
    /// Triangles with an angle below this (radians) are removed while the film shrinks. `None` removes none.
    pub degenerate_angle: Option<f64>,
    /// How the linear systems are solved while the film shrinks.
    pub linear_solver: LinearSolver,
}

impl Default for FreeTopology {
    fn default() -> Self {
        Self { degenerate_angle: Some(DEGENERATE_ANGLE), linear_solver: LinearSolver::Direct }
    }
}

/// Options of [`Method::VertexRelaxation`].
#[derive(Clone, Debug, PartialEq)]
pub struct VertexRelaxation {
    /// Relative change of area per iteration at which a stage with area minimising ends (ε₂).
    pub area_tolerance: f64,
    /// Relative change of area per iteration at which a stage of Laplacian fairing ends (ε₁). `None` stands for
    /// `area_tolerance`.
    pub fairing_tolerance: Option<f64>,
    /// The stages and their processes in the caller's order. Each stage is repeated until its tolerance is met. A stage
    /// of edge swapping alone ends when no swap reduces the area. `None` stands for the stages of the paper.
    pub processes: Option<Vec<Vec<Process>>>,
}

impl Default for VertexRelaxation {
    fn default() -> Self {
        Self { area_tolerance: AREA_TOLERANCE, fairing_tolerance: None, processes: None }
    }
}

/// Options of [`Method::PinkallPolthier`].
#[derive(Clone, Debug, PartialEq)]
pub struct PinkallPolthier {
    /// Relative change of area per solve at which the run ends.
    pub area_tolerance: f64,
    /// How the linear systems are solved.
    pub linear_solver: LinearSolver,
    /// Triangles with an angle below this (radians) are removed. `None` removes none.
    pub degenerate_angle: Option<f64>,
    /// Whether necks of three edges are cut, so that the topology may change.
    pub cut_necks: bool,
}

impl Default for PinkallPolthier {
    fn default() -> Self {
        Self {
            area_tolerance: AREA_TOLERANCE,
            linear_solver: LinearSolver::Direct,
            degenerate_angle: Some(DEGENERATE_ANGLE),
            cut_necks: false,
        }
    }
}

/// Options of [`Method::LiuWang`].
#[derive(Clone, Debug, PartialEq)]
pub struct LiuWang {
    /// ε of the paper's stopping criteria, in lengths divided by the boundary's radius.
    pub tolerance: f64,
    /// Whether the curvatures at boundary vertices (from their interior edges) are part of the objective, as in the
    /// paper. Off by default, because a boundary vertex has only half a ring of triangles. Its curvature does not
    /// vanish on a minimal surface, and would pull the film off that surface.
    pub boundary_curvature: bool,
    /// The seed by which the points of the initial mesh are chosen from the candidates, if [`InitialMesh::Auto`] stands
    /// for [`InitialMesh::Barycentres`].
    pub seed: u64,
    /// Whether a mesh of [`InitialMesh::Barycentres`] is faired once before the first least squares. On by default,
    /// although the paper has no such step, because without the curvatures at boundary vertices every start reaches an
    /// objective of zero and keeps the layout of its points.
    pub candidate_fairing: bool,
}

impl Default for LiuWang {
    fn default() -> Self {
        Self { tolerance: LEAST_SQUARES_TOLERANCE, boundary_curvature: false, seed: 1, candidate_fairing: true }
    }
}

/// Method by which Pinkall and Polthier's linear systems are solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum LinearSolver {
    /// Elimination (L D Lᵀ) for every system.
    #[default]
    Direct,
    /// Conjugate gradients, and elimination only where they do not converge (Bento, Cavalcanti).
    ConjugateGradients,
}

impl LinearSolver {
    /// All linear solvers.
    pub const ALL: [Self; 2] = [Self::Direct, Self::ConjugateGradients];

    /// A stable name in snake case.
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
    /// Number of triangles. It is exact for [`InitialMesh::Rings`] with [`BoundarySampling::Keep`], else within 10%.
    Triangles(usize),
    /// Mean edge length, in the caller's unit.
    EdgeLength(f64),
    /// Number of vertices that are not on the boundary.
    InteriorVertices(usize),
}

/// Sampling of the boundary: whether points may be added on its segments.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum BoundarySampling {
    /// Points are added on long segments, so that the mesh is as fine there as inside.
    #[default]
    Refine,
    /// Only the polygon's vertices are used, as in the papers.
    Keep,
}

/// The mesh that the solver starts from. It also determines the topology of the result.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum InitialMesh {
    /// The most suitable of the other variants for the boundaries. The statistics name the variant that was used.
    #[default]
    Auto,
    /// A Delaunay triangulation in the plane in which the boundaries enclose the largest area. The projection of the
    /// boundaries onto this plane must be simple.
    Planar,
    /// A Delaunay triangulation of a round disc (with a round hole for every further boundary), mapped harmonically.
    Disk,
    /// Rings of vertices towards the mean of the boundary, or from one of two boundaries to the other (Chen, Cai,
    /// Zheng, section 3.4).
    Rings,
    /// A Delaunay triangulation with points at barycentres inside one boundary (Liu, Wang). [`InitialMesh::Auto`]
    /// stands for this mesh under [`Method::LiuWang`] if there is one boundary and no constraint.
    Barycentres {
        /// The seed that chooses among the candidate points.
        seed: u64,
    },
    /// The caller's own mesh. It must be an oriented manifold whose boundary loops are exactly the boundaries, with or
    /// without further vertices on their segments. The resolution has no effect.
    ///
    /// A mesh in which some edges have three triangles is a film with junctions: in the result the sheets meet there at
    /// 120°. The edges with one triangle must then be exactly the segments of the boundaries.
    Given(Mesh),
}

/// Points and curves inside the surface that do not move. They become mesh vertices and edges at exactly these
/// positions.
///
/// A fixed point that equals a boundary point or another fixed point shares a vertex with that point. Curves may share
/// points, but must not cross. With [`BoundarySampling::Refine`] points are added on long segments.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Constraints {
    /// Fixed points.
    pub points: Vec<DVec3>,
    /// Fixed curves.
    pub polylines: Vec<Vec<DVec3>>,
    /// Points inside segments of the boundaries at which curves end. They become points of the boundary, which
    /// [`MinimalSurface::input_vertices`](super::MinimalSurface::input_vertices) does not list.
    pub ends: Vec<SegmentPoint>,
}

/// A point inside a segment of a boundary. It lies on the segment up to rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentPoint {
    /// The number of the boundary.
    pub boundary: usize,
    /// The number of the point at which the segment begins.
    pub segment: usize,
    /// The place of the point.
    pub place: DVec3,
}

impl Constraints {
    /// Whether nothing is constrained.
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

/// Treatment of a stationary surface that is not a local minimum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum OnUnstable {
    /// Return it with a warning.
    #[default]
    Report,
    /// Leave it along its most unstable mode and continue to a minimum.
    Descend,
}

/// Largest number of triangles or vertices that a request may ask for, because half-edges are numbered with 32 bits.
pub const LARGEST_COUNT: usize = 100_000_000;

/// Options of a solve. [`Options::new`] fills in the default of every option but the resolution, which has none.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Objective and solver.
    pub method: Method,
    /// How fine the mesh is to be.
    pub resolution: Resolution,
    /// Whether points may be added on the boundary.
    pub boundary_sampling: BoundarySampling,
    /// The mesh that the solver starts from.
    pub initial_mesh: InitialMesh,
    /// Points and curves inside the surface that do not move.
    pub constraints: Constraints,
    /// The residual (dimensionless, see [`Statistics::residual`](super::Statistics::residual)) at which the default
    /// solver and Pinkall and Polthier's solver count as converged. If a solver stops by its own rule at a film of
    /// least area with a larger residual, the film carries the warning `not_minimal`.
    pub tolerance: f64,
    /// Bound on the largest mean curvature ([`MeanCurvature::max`](super::MeanCurvature), in 1/unit) of a film of least
    /// area. A solver that has met its own rule goes on until the film is within the bound. A film that is not within
    /// it in the end has not converged. `None` stands for no bound.
    pub curvature_tolerance: Option<f64>,
    /// Largest number of iterations. `None` stands for the default of the solver: 10,000 sweeps of vertex relaxation,
    /// 200 linear solves, or 500 steps of Levenberg and Marquardt.
    pub max_iterations: Option<u32>,
    /// Whether the vertices of a film of least area finally slide along the film to where its triangles have less area
    /// ([`sliding`](plateau_mesh::remesh::sliding)). Without sliding the triangles are more even. Films of
    /// [`TopologyRule::Free`] always slide.
    pub slides: bool,
}

/// Limits that apply to every solver.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// The residual at which the surface counts as converged.
    pub tolerance: f64,
    /// The largest mean curvature within which the film has to be, in 1/unit.
    pub curvature_tolerance: Option<f64>,
    /// Largest number of iterations. `None` stands for the default of the solver.
    pub max_iterations: Option<u32>,
}

impl Limits {
    /// Whether a film of this largest mean curvature, which has met the solver's own rule, may end the solve.
    pub fn allow(&self, curvature: f64) -> bool {
        self.curvature_tolerance.is_none_or(|bound| curvature <= bound)
    }
}

impl Options {
    /// Returns the default options for a resolution: least area by Newton's method, with the topology of the initial
    /// mesh.
    #[must_use]
    pub fn new(resolution: Resolution) -> Self {
        Self {
            method: Method::default(),
            resolution,
            boundary_sampling: BoundarySampling::default(),
            initial_mesh: InitialMesh::default(),
            constraints: Constraints::default(),
            tolerance: 1e-6,
            curvature_tolerance: None,
            max_iterations: None,
            slides: true,
        }
    }

    pub(crate) fn limits(&self) -> Limits {
        Limits {
            tolerance: self.tolerance,
            curvature_tolerance: self.curvature_tolerance,
            max_iterations: self.max_iterations,
        }
    }

    /// Whether remeshing may add points on the boundaries.
    pub(crate) fn boundary_edges(&self) -> BoundaryEdges {
        match self.boundary_sampling {
            BoundarySampling::Refine => BoundaryEdges::Refined,
            BoundarySampling::Keep => BoundaryEdges::Kept,
        }
    }

    /// Whether the result has the topology of the initial mesh.
    pub(crate) fn keeps_topology(&self) -> bool {
        match &self.method {
            Method::Newton(newton) => newton.topology == TopologyRule::Fixed,
            Method::PinkallPolthier(options) => !options.cut_necks,
            Method::VertexRelaxation(_) | Method::Harmonic | Method::LiuWang(_) => true,
        }
    }

    /// Returns the seed of the candidate points if the initial mesh for this number of boundaries is of the kind
    /// [`InitialMesh::Barycentres`]. Returns `None` for other initial meshes.
    pub(crate) fn barycentres(&self, boundaries: usize) -> Option<u64> {
        match (&self.initial_mesh, &self.method) {
            (InitialMesh::Barycentres { seed }, _) => Some(*seed),
            (InitialMesh::Auto, Method::LiuWang(options)) if boundaries == 1 && self.constraints.is_empty() => {
                Some(options.seed)
            }
            _ => None,
        }
    }

    /// Returns these options with all positions relative to a centre.
    pub(crate) fn centred(&self, centre: DVec3) -> Self {
        let mut options = self.clone();
        if let InitialMesh::Given(mesh) = &mut options.initial_mesh {
            mesh.vertices.iter_mut().for_each(|vertex| *vertex -= centre);
        }
        let Constraints { points, polylines, ends } = &mut options.constraints;
        let ends = ends.iter_mut().map(|end| &mut end.place);
        points.iter_mut().chain(polylines.iter_mut().flatten()).chain(ends).for_each(|point| *point -= centre);
        options
    }

    pub(crate) fn check(&self) -> Vec<InputError> {
        let mut errors = Vec::new();
        let mut tolerances = vec![("tolerance", self.tolerance)];
        tolerances.extend(self.curvature_tolerance.map(|bound| ("curvature_tolerance", bound)));
        let degenerate_angle = match &self.method {
            Method::Newton(Newton { topology: TopologyRule::Free(free), .. }) => free.degenerate_angle,
            Method::Newton(_) | Method::Harmonic => None,
            Method::VertexRelaxation(options) => {
                tolerances.push(("area_tolerance", options.area_tolerance));
                tolerances.extend(options.fairing_tolerance.map(|tolerance| ("fairing_tolerance", tolerance)));
                None
            }
            Method::PinkallPolthier(options) => {
                tolerances.push(("area_tolerance", options.area_tolerance));
                options.degenerate_angle
            }
            Method::LiuWang(options) => {
                tolerances.push(("least_squares_tolerance", options.tolerance));
                None
            }
        };
        for (name, value) in tolerances {
            if !(value.is_finite() && value >= 0.0) {
                errors.push(InputError::new(Place::field(name), "must be a finite number, not negative"));
            }
        }
        if let Resolution::EdgeLength(length) = self.resolution
            && !(length.is_finite() && length > 0.0)
        {
            let place = Place::field("resolution").then("edge_length");
            errors.push(InputError::new(place, "must be a finite number above 0"));
        }
        if degenerate_angle.is_some_and(|angle| !(angle > 0.0 && angle <= LARGEST_DEGENERATE_ANGLE)) {
            errors.push(InputError::new(Place::field("degenerate_angle"), "must be above 0 and at most 20 degrees"));
        }
        self.constraints.check(&mut errors);
        let best = matches!(&self.method, Method::Newton(newton) if newton.topology == TopologyRule::Best);
        if best && self.initial_mesh != InitialMesh::Auto {
            let detail = "best spans every set of boundaries by itself and takes auto alone";
            errors.push(InputError::new(Place::field("initial_mesh"), detail));
        }
        if !self.constraints.is_empty() && !self.keeps_topology() {
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
        if let Method::VertexRelaxation(VertexRelaxation { processes: Some(stages), .. }) = &self.method {
            for (k, _) in stages.iter().enumerate().filter(|(_, stage)| stage.is_empty()) {
                errors.push(InputError::new(Place::field("processes").at(k), "a stage needs a process"));
            }
        }
        errors
    }
}
