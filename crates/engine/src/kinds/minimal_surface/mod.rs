//! Minimal surfaces: the request and its conversion to the geometry's types. `statistics` converts the
//! result.

mod audit;
mod certificate;
mod file_mesh;
#[cfg(feature = "certificates")]
mod proof;
mod solve;
mod statistics;

pub use certificate::{Certificate, Certify, CertifyOptions};
#[cfg(feature = "certificates")]
pub use proof::CertificateDocument;
pub use statistics::MinimalStatistics;

use crate::blocks::{self, Block, Input, Preset, Type};
use crate::checked::{Checked, KindRequest, Types};
use crate::common::{self, Point};
use crate::join::{self, Member, Notes, OnSegments, Points, Role};
use crate::kind::{Entry, Kind, Objective as ObjectiveDoc, Units};
use crate::limits::{self, Limits};
use crate::options::{Choice, Given, Optioned, RequestOption, when};
use crate::resolution::Resolution;
use plateau_archive::units::{Unit, UpAxis};
use plateau_mesh::{DVec3, Mesh};
use plateau_minimal_surface::{self as geometry, BoundarySampling, LinearSolver, OnUnstable, Process};
use plateau_strict_json::bounds::{
    Fraction, List, NonNegative, Positive, UpTo20, Whole, given, given_one, is_default, unwritten, yes,
};
use plateau_strict_json::rejection::{FieldError, Rejection};
use plateau_strict_json::union;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub const KIND: Kind = Kind::of(&ENTRY);

static ENTRY: Entry = Entry {
    name: "minimal_surface",
    path: "/v1/minimal-surfaces",
    summary: "Finds the minimal surface that spans boundary polylines",
    finds: "minimal surfaces over boundary curves",
    units: Units::Length,
    blocks: &[
        Block {
            name: "minimal-surface",
            title: "Minimal Surface",
            description: "Minimal surface that spans closed curves.",
            inputs: &[
                blocks::BOUNDARIES,
                blocks::TRIANGLES,
                blocks::EDGE_LENGTH,
                OBJECTIVE,
                Input::optional(
                    "Topology",
                    "G",
                    Preset::Text("fixed"),
                    "fixed, free (necks may pinch) or best (the smallest of all ways to span the curves).",
                )
                .to("/topology"),
            ],
        },
        Block {
            name: "film-from-mesh",
            title: "Film From Mesh",
            description: "Minimal surface with the topology of a mesh and its naked edges as boundaries. \
                          Sheets may meet three by three.",
            inputs: &[
                Input::required(
                    "Mesh",
                    "M",
                    Type::Mesh,
                    "Initial mesh. Equal vertices are joined, and quadrilaterals are split. Its naked edges stay \
                     where they are.",
                ),
                OBJECTIVE,
            ],
        },
    ],
    outputs: &[blocks::MESH, blocks::AREA, blocks::CONVERGED],
    objectives,
    types: Types::of::<MinimalSurfaceRequest>(),
};

const OBJECTIVE: Input = Input::optional(
    "Objective",
    "O",
    Preset::Text("minimal_area"),
    "minimal_area, minimal_dirichlet_energy or minimal_mean_curvature.",
)
.to("/objective");

/// Boundary polygons, and options for the surface that spans them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MinimalSurfaceRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default, skip_serializing_if = "unwritten")]
    pub kind: Option<MinimalSurfaceKind>,
    /// Unit of the coordinates.
    #[serde(default)]
    pub units: Unit,
    /// Axis that points up.
    #[serde(default)]
    pub up: UpAxis,
    /// Closed polygons that do not repeat their first point.
    pub boundaries: List<List<Point, 3>, 1>,
    #[serde(default, skip_serializing_if = "is_default")]
    pub objective: Objective,
    /// Method that minimises the area.
    #[serde(default, skip_serializing_if = "is_default")]
    pub solver: Solver,
    /// Resolution of the mesh. If absent, 2,000 triangles, or four for each boundary point where those are more.
    #[serde(default, deserialize_with = "given_one", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Resolution")]
    pub resolution: Option<Resolution>,
    #[serde(default, skip_serializing_if = "is_default")]
    pub boundary_sampling: BoundarySampling,
    #[serde(default, skip_serializing_if = "is_default")]
    pub initial_mesh: InitialMesh,
    #[serde(default, skip_serializing_if = "is_default")]
    pub constraints: Constraints,
    /// Distance up to which points of `constraints` are joined to points of the boundaries and to each other, in the
    /// request's unit. Null means 1e-6 of the request's size, which is the largest distance of a point from the mean
    /// of all points. It counts as at least 8 units in the last place of the largest coordinate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub join_tolerance: Option<NonNegative>,
    #[serde(default, skip_serializing_if = "is_default")]
    pub topology: Topology,
    /// Residual (see `statistics.residual`) at which the solvers `newton` and `pinkall_polthier` have converged. A
    /// `minimal_area` film with a larger residual has the warning `not_minimal`.
    #[serde(default = "default_tolerance", skip_serializing_if = "is_default_tolerance")]
    #[schemars(extend("default" = 1e-6))]
    pub tolerance: Fraction,
    /// Bound on `statistics.mean_curvature.max`, in 1/unit. A solver that has met its own tolerance goes on until the
    /// film is within the bound: `newton` moves the vertices along the film, down to angles of 10 degrees, and the
    /// others iterate. A film that is not within it in the end has `converged: false` and the warning `not_converged`.
    /// Null means no bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curvature_tolerance: Option<Positive>,
    /// Relative change of area per iteration at which `vertex_relaxation` and `pinkall_polthier` have converged.
    #[serde(default = "default_tolerance", skip_serializing_if = "is_default_tolerance")]
    #[schemars(extend("default" = 1e-6))]
    pub area_tolerance: Fraction,
    /// Liu and Wang's ε, for lengths divided by the boundary's radius. `minimal_mean_curvature` has converged when the
    /// objective F changes by less than ε (1 + F), its gradient is below ∛ε (1 + F), or the step is below √ε.
    #[serde(default = "default_tolerance", skip_serializing_if = "is_default_tolerance")]
    #[schemars(extend("default" = 1e-6))]
    pub least_squares_tolerance: Fraction,
    /// Relative change of area at which the Laplacian fairing of `vertex_relaxation` stops. Null means
    /// `area_tolerance`.
    #[serde(default)]
    pub fairing_tolerance: Option<Fraction>,
    /// Stages of `vertex_relaxation` in order. Each is repeated until its tolerance is reached. A stage of
    /// `edge_swapping` alone ends when no swap reduces the area. Null means the paper's stages.
    #[serde(default)]
    pub processes: Option<List<ProcessStage, 1, 16>>,
    /// Maximum number of iterations. Null means the solver's default.
    #[serde(default)]
    pub max_iterations: Option<Whole<1, 1_000_000_000>>,
    #[serde(default, skip_serializing_if = "is_default")]
    pub on_unstable: OnUnstable,
    /// Method by which `pinkall_polthier` solves its linear systems.
    #[serde(default, skip_serializing_if = "is_default")]
    pub linear_solver: LinearSolver,
    /// Smallest allowed angle in degrees. `pinkall_polthier` and `topology: free` remove triangles with a smaller
    /// angle. 0 removes none.
    #[serde(default = "default_degenerate_angle_deg", skip_serializing_if = "is_default_angle")]
    #[schemars(extend("default" = 1.0))]
    pub degenerate_angle_deg: UpTo20,
    /// Seed of the choice among the candidate points of `initial_mesh: barycentres`.
    #[serde(default = "default_seed", skip_serializing_if = "is_default_seed")]
    #[schemars(extend("default" = 1))]
    #[schemars(range(min = 0, max = 4_294_967_295u32))]
    pub seed: u32,
    /// Whether `minimal_mean_curvature` includes the curvature at the boundary's vertices, as Liu and Wang's formula
    /// does. The film then leaves the minimal surface beside the boundary.
    #[serde(default, skip_serializing_if = "is_default")]
    #[schemars(extend("default" = false))]
    pub boundary_curvature: bool,
    /// Whether `minimal_mean_curvature` fairs a mesh of candidate points (`initial_mesh: barycentres`) once before it
    /// starts: each inner vertex becomes the mean of its neighbours. Liu and Wang's method does not.
    #[serde(default = "yes", skip_serializing_if = "Clone::clone")]
    #[schemars(extend("default" = true))]
    pub candidate_fairing: bool,
    /// Whether to prove a lower bound of the area of all oriented surfaces with this boundary: `true`, or how sharp the
    /// bound is to be and how long the search may take. Only for `minimal_area`.
    #[serde(default, skip_serializing_if = "is_default")]
    pub certify: Certify,
}

fn default_degenerate_angle_deg() -> UpTo20 {
    UpTo20::new(1.0)
}

fn default_seed() -> u32 {
    1
}

fn default_tolerance() -> Fraction {
    Fraction::new(1e-6)
}

fn is_default_angle(angle: &UpTo20) -> bool {
    *angle == default_degenerate_angle_deg()
}

fn is_default_seed(seed: &u32) -> bool {
    *seed == default_seed()
}

fn is_default_tolerance(tolerance: &Fraction) -> bool {
    *tolerance == default_tolerance()
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MinimalSurfaceKind {
    MinimalSurface,
}

/// Quantity that is minimised. `GET /v1/objectives` has the formulas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "MinimalSurfaceObjective")]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    #[default]
    MinimalArea,
    MinimalDirichletEnergy,
    MinimalMeanCurvature,
}

/// Method that minimises the area. `auto` chooses the best of the others for the request.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Solver {
    #[default]
    Auto,
    /// Chen, Cai, Zheng.
    VertexRelaxation,
    /// Bento, Cavalcanti.
    PinkallPolthier,
    /// Newton's method in normal heights, which also gives the Morse index.
    Newton,
}

impl From<Objective> for geometry::Objective {
    fn from(objective: Objective) -> Self {
        match objective {
            Objective::MinimalArea => Self::MinimalArea,
            Objective::MinimalDirichletEnergy => Self::MinimalDirichletEnergy,
            Objective::MinimalMeanCurvature => Self::MinimalMeanCurvature,
        }
    }
}

impl Solver {
    fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::VertexRelaxation => "vertex_relaxation",
            Self::PinkallPolthier => "pinkall_polthier",
            Self::Newton => "newton",
        }
    }
}

/// Mesh that the solver starts from: built by the service, or supplied by the client.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum InitialMesh {
    Made(MadeMesh),
    Given(GivenMesh),
}

union!(InitialMesh { name: Made, object: Given });

impl Default for InitialMesh {
    fn default() -> Self {
        Self::Made(MadeMesh::Auto)
    }
}

impl InitialMesh {
    /// Returns the name of the construction, or `given` for the client's own mesh.
    fn name(&self) -> &'static str {
        match self {
            Self::Made(MadeMesh::Auto) => "auto",
            Self::Made(MadeMesh::Planar) => "planar",
            Self::Made(MadeMesh::Disk) => "disk",
            Self::Made(MadeMesh::Rings) => "rings",
            Self::Made(MadeMesh::Barycentres) => "barycentres",
            Self::Given(_) => "given",
        }
    }
}

/// Construction of the initial mesh. The statistics name the construction that `auto` chose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MadeMesh {
    /// Chooses the best of the others for these boundaries.
    Auto,
    /// Delaunay triangulation in a plane onto which the boundary projects without crossing itself.
    Planar,
    /// Delaunay triangulation of a round disc, mapped harmonically.
    Disk,
    /// Rings of vertices (Chen, Cai, Zheng, section 3.4).
    Rings,
    /// Liu, Wang.
    Barycentres,
}

/// The client's own initial mesh. It is either an oriented manifold whose boundary loops are `boundaries`, with or
/// without further vertices on their segments, or a film whose sheets meet three by three along edges with three
/// triangles. In a film, the edges with one triangle must be the segments of `boundaries`, which may share points.
/// `resolution` has no effect in either case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1))]
pub struct GivenMesh {
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "List<Point, 3>")]
    pub vertices: Option<List<Point, 3>>,
    /// Vertex indices of each triangle, counted from 0.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "List<[u32; 3], 1>", inner(inner(range(min = 0, max = 4_294_967_295u32))))]
    pub triangles: Option<List<[u32; 3], 1>>,
    /// The mesh as a binary glTF 2.0 file in base64, instead of `vertices` and `triangles`. The triangles of its
    /// default scene are read with their nodes' transforms, from metres with y up to the request's unit and axis.
    /// Points and lines are left out, and equal vertices become one. Vertices within the rounding of the file's 32-bit
    /// numbers from points of `boundaries` take their places, and boundary vertices between them move onto the segment.
    /// The file needs no other file and no extension.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub glb: Option<String>,
}

impl GivenMesh {
    /// Returns the mesh for a request with these boundaries, unit and axis.
    ///
    /// # Errors
    /// Returns [`Rejection`] at the member that is missing, superfluous, too large or wrong.
    fn read(&self, boundaries: &[List<Point, 3>], axes: (Unit, UpAxis), limits: &Limits) -> Result<Mesh, Rejection> {
        let invalid = |member: &str, detail: &str| {
            Err(Rejection::Invalid(vec![FieldError::new(format!("/initial_mesh{member}"), detail)]))
        };
        match (&self.vertices, &self.triangles, &self.glb) {
            (None, None, Some(glb)) => file_mesh::read(glb, &common::polylines(boundaries), axes, limits),
            (_, _, Some(_)) => invalid("/glb", "is only allowed without vertices and triangles"),
            (None, None, None) => invalid("", "must have glb, or vertices and triangles"),
            (None, _, None) => invalid("/vertices", "is required"),
            (_, None, None) => invalid("/triangles", "is required"),
            (Some(vertices), Some(triangles), None) => {
                if triangles.len().max(vertices.len()) > limits.triangles {
                    let detail = format!("is larger than is allowed ({} triangles)", limits.triangles);
                    return Err(Rejection::TooLarge(vec![FieldError::new("/initial_mesh", detail)]));
                }
                Ok(Mesh::new(common::points(vertices), triangles.to_vec()))
            }
        }
    }
}

/// Fixed points and curves inside the surface. They become vertices and edges of the mesh. Their points are joined to
/// points of the boundaries and to each other within `join_tolerance`, and the end of a curve may lie on a segment of a
/// boundary.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Constraints {
    #[serde(default)]
    pub points: Vec<Point>,
    #[serde(default)]
    pub polylines: Vec<List<Point, 2>>,
}

/// `fixed` keeps the topology of the initial mesh. `free` allows necks to pinch. `best` solves every spanning topology
/// and returns the surface of least area. Surfaces that pass through themselves or each other come after all others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Topology {
    #[default]
    Fixed,
    Free,
    Best,
}

impl Topology {
    fn name(self) -> &'static str {
        match self {
            Self::Fixed => "fixed",
            Self::Free => "free",
            Self::Best => "best",
        }
    }
}

/// One process, or several that take turns.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum ProcessStage {
    One(Process),
    Several(AlternatingProcesses),
}

union!(ProcessStage { name: One, object: Several });

/// Processes that take turns in one stage.
// An object instead of a bare list, because the generated clients of Java and Python cannot read a list of lists. The
// type's name precedes `Process` in the alphabet, because openapi-generator sorts the alternatives of `ProcessStage` by
// name, and its TypeScript compiles only if the object comes first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AlternatingProcesses {
    /// The processes in the order of each turn.
    pub together: List<Process, 1, 16>,
}

impl ProcessStage {
    fn processes(&self) -> &[Process] {
        match self {
            Self::One(process) => std::slice::from_ref(process),
            Self::Several(processes) => &processes.together,
        }
    }
}

impl Optioned for MinimalSurfaceRequest {
    const OPTIONS: &'static [RequestOption] = &[
        RequestOption::with("solver", &[&[when("objective", AREA)]]),
        RequestOption::with("resolution", &[&[when("initial_mesh", MADE)]]),
        RequestOption::with("boundary_sampling", &[&[when("initial_mesh", SAMPLED)]]),
        RequestOption::always("initial_mesh"),
        RequestOption::always("constraints"),
        RequestOption::always("join_tolerance"),
        RequestOption::with(
            "topology",
            &[&[when("objective", AREA), when("solver", &["auto", "pinkall_polthier", "newton"])]],
        ),
        RequestOption::with("tolerance", &[&[when("objective", AREA)]]),
        RequestOption::with("curvature_tolerance", &[&[when("objective", AREA)]]),
        RequestOption::with(
            "area_tolerance",
            &[&[when("objective", AREA), when("solver", &["vertex_relaxation", "pinkall_polthier"])]],
        ),
        RequestOption::with("least_squares_tolerance", &[&[when("objective", &["minimal_mean_curvature"])]]),
        RequestOption::with("fairing_tolerance", &[&[when("objective", AREA), when("solver", &["vertex_relaxation"])]]),
        RequestOption::with("processes", &[&[when("objective", AREA), when("solver", &["vertex_relaxation"])]]),
        RequestOption::with("max_iterations", &[&[when("objective", &["minimal_area", "minimal_mean_curvature"])]]),
        RequestOption::with(
            "on_unstable",
            &[&[when("objective", AREA), when("solver", &["auto", "newton"]), when("topology", &["fixed"])]],
        ),
        RequestOption::with("linear_solver", REMOVES_TRIANGLES),
        RequestOption::with("degenerate_angle_deg", REMOVES_TRIANGLES),
        RequestOption::with(
            "seed",
            &[
                &[when("initial_mesh", &["barycentres"])],
                &[when("objective", &["minimal_mean_curvature"]), when("initial_mesh", &["auto"])],
            ],
        ),
        RequestOption::with("boundary_curvature", &[&[when("objective", &["minimal_mean_curvature"])]]),
        RequestOption::with(
            "candidate_fairing",
            &[&[when("objective", &["minimal_mean_curvature"]), when("initial_mesh", &["auto", "barycentres"])]],
        ),
        RequestOption::with("certify", &[&[when("objective", AREA)]]),
    ];

    fn choice(&self, member: &str) -> &'static str {
        match member {
            "objective" => geometry::Objective::from(self.objective).name(),
            "solver" => self.solver.name(),
            "topology" => self.topology.name(),
            _ => self.initial_mesh.name(),
        }
    }

    fn idle(&self, given: &Given<'_>) -> Vec<FieldError> {
        let mut errors = Vec::new();
        let mut refuse = |is_idle: bool, member: &str, detail: &str| {
            let pointer = format!("/{member}");
            if is_idle && given.has(&pointer) {
                errors.push(FieldError::new(pointer, detail));
            }
        };
        let is_made = matches!(self.initial_mesh, InitialMesh::Made(MadeMesh::Auto));
        let takes_points = self.boundaries.len() == 1 && self.constraints == Constraints::default();
        for member in ["seed", "candidate_fairing"] {
            refuse(
                is_made && matches!(self.objective, Objective::MinimalMeanCurvature) && !takes_points,
                member,
                "has no effect in this request: it needs one boundary and no constraints, or `initial_mesh: \
                 barycentres`",
            );
        }
        let has = |stage: &ProcessStage, process| stage.processes().contains(&process);
        let minimises = |stage: &ProcessStage| has(stage, Process::AreaMinimising);
        let fairs = |stage: &ProcessStage| has(stage, Process::LaplacianFairing) && !minimises(stage);
        refuse(
            self.processes.as_ref().is_some_and(|stages| !stages.iter().any(fairs)),
            "fairing_tolerance",
            "has no effect in this request: it needs a stage of `processes` with laplacian_fairing and without \
             area_minimising",
        );
        let own = self.fairing_tolerance.is_some();
        refuse(
            self.processes.as_ref().is_some_and(|stages| !stages.iter().any(|s| minimises(s) || fairs(s) && !own)),
            "area_tolerance",
            "has no effect in this request: it needs a stage of `processes` with area_minimising, or with \
             laplacian_fairing and no `fairing_tolerance`",
        );
        errors
    }
}

/// The objectives with which the methods for the area act.
const AREA: &[&str] = &["minimal_area"];
/// The initial meshes that the service makes.
const MADE: &[&str] = &["auto", "planar", "disk", "rings", "barycentres"];
/// The initial meshes that may have points between those of the boundaries.
const SAMPLED: &[&str] = &["auto", "planar", "disk", "rings"];
/// The choices with which triangles with small angles are removed while the film shrinks.
const REMOVES_TRIANGLES: &[&[Choice]] = &[
    &[when("objective", AREA), when("solver", &["pinkall_polthier"])],
    &[when("objective", AREA), when("topology", &["free"])],
];

impl KindRequest for MinimalSurfaceRequest {
    type Statistics = MinimalStatistics;

    fn axes(&self) -> (Unit, UpAxis) {
        (self.units, self.up)
    }

    fn check(&self, limits: &Limits) -> Result<Checked, Rejection> {
        limits::check_count("/boundaries", common::count(&self.boundaries), limits.points, "points")?;
        if let Some(resolution) = self.resolution {
            resolution.check(limits)?;
        }
        limits::check_count(
            "/constraints/polylines",
            common::count(&self.constraints.polylines),
            limits.points,
            "points",
        )?;
        limits::check_count("/constraints/points", self.constraints.points.len(), limits.points, "points")?;
        let initial_mesh = self.initial_mesh(limits)?;
        limits::check_number("/max_iterations", self.max_iterations.map(Whole::get), limits.iterations as usize)?;
        if matches!((self.solver, self.topology), (Solver::PinkallPolthier, Topology::Best)) {
            let detail = "`best` needs the solver auto or newton; pinkall_polthier takes `fixed` and `free`";
            return Err(FieldError::new("/topology", detail).into());
        }
        let certify = self.certify_options()?;
        let (boundaries, mut options) = self.to_geometry(initial_mesh);
        let joined = self.join(&boundaries, &mut options)?;
        geometry::check(&boundaries, &options).map_err(|error| joined.added_to(error)).map_err(|error| match &self
            .initial_mesh
        {
            InitialMesh::Given(GivenMesh { glb: Some(_), .. }) => file_mesh::at_the_file(error.into()),
            _ => Rejection::from(error),
        })?;
        let estimate = geometry::estimate(&boundaries, &options);
        if estimate.triangles > limits.triangles as f64 {
            let detail = format!(
                "asks for about {:.0} triangles, more than are allowed ({})",
                estimate.triangles, limits.triangles
            );
            return Err(Rejection::TooLarge(vec![FieldError::new("/resolution", detail)]));
        }
        let memory_bytes = estimate.bytes;
        #[cfg(feature = "certificates")]
        let memory_bytes =
            memory_bytes.saturating_add(certify.map_or(0, |options| proof::memory_bytes(boundaries.len(), options)));
        let input = Box::new(solve::SolverInput { boundaries, options, certify, joined });
        Ok(Checked { memory_bytes, quick: false, input })
    }
}

impl MinimalSurfaceRequest {
    /// Returns the options of the search for a lower bound of the area, if the request asks for one.
    ///
    /// # Errors
    /// Fails at `/certify` in a build without the feature `certificates`.
    fn certify_options(&self) -> Result<Option<CertifyOptions>, Rejection> {
        let options = match self.certify {
            Certify::Default(false) => return Ok(None),
            Certify::Default(true) => CertifyOptions::default(),
            Certify::Options(options) => options,
        };
        if cfg!(not(feature = "certificates")) {
            let detail = "must be false, because lower bounds were left out of this build";
            return Err(FieldError::new("/certify", detail).into());
        }
        Ok(Some(options))
    }

    /// Converts the initial mesh to the geometry's type.
    ///
    /// # Errors
    /// Returns the errors of [`GivenMesh::read`].
    fn initial_mesh(&self, limits: &Limits) -> Result<geometry::InitialMesh, Rejection> {
        Ok(match &self.initial_mesh {
            InitialMesh::Made(MadeMesh::Auto) => geometry::InitialMesh::Auto,
            InitialMesh::Made(MadeMesh::Planar) => geometry::InitialMesh::Planar,
            InitialMesh::Made(MadeMesh::Disk) => geometry::InitialMesh::Disk,
            InitialMesh::Made(MadeMesh::Rings) => geometry::InitialMesh::Rings,
            InitialMesh::Made(MadeMesh::Barycentres) => {
                geometry::InitialMesh::Barycentres { seed: u64::from(self.seed) }
            }
            InitialMesh::Given(mesh) => {
                geometry::InitialMesh::Given(mesh.read(&self.boundaries, (self.units, self.up), limits)?)
            }
        })
    }

    /// Converts the request to the geometry's types.
    fn to_geometry(&self, initial_mesh: geometry::InitialMesh) -> (Vec<Vec<DVec3>>, geometry::Options) {
        let resolution = Resolution::or_default(self.resolution, common::count(&self.boundaries));
        let options = geometry::Options {
            method: self.method(),
            boundary_sampling: self.boundary_sampling,
            initial_mesh,
            constraints: geometry::Constraints {
                points: common::points(&self.constraints.points),
                polylines: common::polylines(&self.constraints.polylines),
                ends: Vec::new(),
            },
            tolerance: self.tolerance.get(),
            curvature_tolerance: self.curvature_tolerance.map(Positive::get),
            max_iterations: self.max_iterations.map(Whole::get),
            ..geometry::Options::new(resolution)
        };
        (common::polylines(&self.boundaries), options)
    }

    /// Joins the points of the constraints that should be one, and returns what the client gets to know of it.
    ///
    /// # Errors
    /// Returns the errors of [`join::join`].
    fn join(&self, boundaries: &[Vec<DVec3>], options: &mut geometry::Options) -> Result<Notes, Rejection> {
        let geometry::Constraints { points, polylines, ends } = &mut options.constraints;
        let member = |role, list, (number, points)| Member { role, list, number, field: "", points };
        let fixed = points.iter().map(|&point| vec![point]).enumerate();
        let fixed = fixed.map(|own| member(Role::FixedPoint, "/constraints/points", own));
        let guides = polylines.iter().cloned().enumerate();
        let guides = guides.map(|own| member(Role::Guide, "/constraints/polylines", own));
        let joined = join::join(&Points {
            boundaries,
            moves: boundaries.iter().map(|points| vec![false; points.len()]).collect(),
            members: fixed.chain(guides).collect(),
            tolerance: self.join_tolerance.map(NonNegative::get),
            on_segments: match (&self.initial_mesh, self.boundary_sampling) {
                (InitialMesh::Given(_), _) => OnSegments::Left,
                (InitialMesh::Made(_), BoundarySampling::Keep) => OnSegments::Refused,
                (InitialMesh::Made(_), BoundarySampling::Refine) => OnSegments::Joined,
            },
        })?;
        let mut places = joined.points.into_iter();
        points.iter_mut().zip(places.by_ref().flatten()).for_each(|(point, place)| *point = place);
        polylines.iter_mut().zip(places).for_each(|(guide, places)| *guide = places);
        *ends = joined.ends;
        Ok(joined.notes)
    }

    /// Returns the method for the objective and the solver.
    fn method(&self) -> geometry::Method {
        let linear_solver = self.linear_solver;
        let degenerate_angle = self.degenerate_angle_deg.get();
        let degenerate_angle = (degenerate_angle > 0.0).then(|| degenerate_angle.to_radians());
        let area_tolerance = self.area_tolerance.get();
        match (self.objective, self.solver) {
            (Objective::MinimalMeanCurvature, _) => geometry::Method::LiuWang(geometry::LiuWang {
                tolerance: self.least_squares_tolerance.get(),
                boundary_curvature: self.boundary_curvature,
                seed: u64::from(self.seed),
                candidate_fairing: self.candidate_fairing,
            }),
            (Objective::MinimalDirichletEnergy, _) => geometry::Method::Harmonic,
            (Objective::MinimalArea, Solver::VertexRelaxation) => {
                geometry::Method::VertexRelaxation(geometry::VertexRelaxation {
                    area_tolerance,
                    fairing_tolerance: self.fairing_tolerance.map(Fraction::get),
                    processes: self
                        .processes
                        .as_ref()
                        .map(|stages| stages.iter().map(|stage| stage.processes().to_vec()).collect()),
                })
            }
            (Objective::MinimalArea, Solver::PinkallPolthier) => {
                geometry::Method::PinkallPolthier(geometry::PinkallPolthier {
                    area_tolerance,
                    linear_solver,
                    degenerate_angle,
                    cut_necks: matches!(self.topology, Topology::Free),
                })
            }
            (Objective::MinimalArea, Solver::Auto | Solver::Newton) => geometry::Method::Newton(geometry::Newton {
                topology: match self.topology {
                    Topology::Fixed => geometry::TopologyRule::Fixed,
                    Topology::Free => {
                        geometry::TopologyRule::Free(geometry::FreeTopology { degenerate_angle, linear_solver })
                    }
                    Topology::Best => geometry::TopologyRule::Best,
                },
                on_unstable: self.on_unstable,
            }),
        }
    }
}

/// Returns the objectives of this kind.
fn objectives() -> Vec<ObjectiveDoc> {
    geometry::Objective::ALL
        .iter()
        .map(|objective| {
            let about = objective.describe();
            ObjectiveDoc {
                name: about.name,
                kind: KIND,
                minimises: about.minimises,
                unit: about.unit,
                source: about.source,
                options: Vec::new(),
            }
        })
        .collect()
}
