//! `POST /v1/minimal-surfaces`: the request, its statistics, and the way to the geometry and back.

use super::common::{self, Cache, Point, Units, UpAxis};
use super::objectives::Objective as ObjectiveDoc;
use super::{FieldError, Kind, Rejection};
use crate::config::LimitsConfig;
use plateau_geometry::minimal_surface as geometry;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Boundary polylines, and what to span them with.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MinimalSurfaceRequest {
    /// May say what the path says already; `plateau solve` needs it.
    #[serde(default)]
    pub kind: Option<MinimalSurfaceKind>,
    /// Whether the kept result of an equal request may be taken.
    #[serde(default)]
    pub cache: Cache,
    /// Unit of the coordinates.
    #[serde(default)]
    pub units: Units,
    /// Which axis points up.
    #[serde(default)]
    pub up: UpAxis,
    /// Closed polygons that do not repeat their first point.
    #[schemars(length(min = 1), inner(length(min = 3)))]
    pub boundaries: Vec<Vec<Point>>,
    #[serde(default)]
    pub objective: Objective,
    /// How the area is minimised.
    #[serde(default)]
    pub solver: Solver,
    #[serde(default)]
    pub resolution: Resolution,
    #[serde(default)]
    pub boundary_sampling: BoundarySampling,
    #[serde(default)]
    pub initial_mesh: InitialMesh,
    #[serde(default)]
    pub topology: Topology,
    /// The residual (largest normal mean curvature times the boundary's radius) at which a surface counts as converged.
    #[serde(default = "default_tolerance")]
    #[schemars(range(min = 0, max = 1))]
    pub tolerance: f64,
    /// Relative change of area per iteration at which the papers' own solvers end.
    #[serde(default = "default_tolerance")]
    #[schemars(range(min = 0, max = 1))]
    pub area_tolerance: f64,
    /// Null: the solver's own default.
    #[serde(default)]
    #[schemars(range(min = 1, max = 1_000_000_000))]
    pub max_iterations: Option<u32>,
}

fn default_tolerance() -> f64 {
    1e-6
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MinimalSurfaceKind {
    MinimalSurface,
}

/// What is made least; `GET /v1/objectives` has the formulas.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    #[default]
    MinimalArea,
}

/// How the area is minimised. `auto` takes the best of the others for the request at hand.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Solver {
    #[default]
    Auto,
    VertexRelaxation,
}

/// How fine the mesh is to be: exactly one of the three.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
pub struct Resolution {
    /// Number of triangles: exact for `rings` with `keep`, else within 10%.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 1_000_000_000))]
    pub triangles: Option<u32>,
    /// Mean edge length, in the request's unit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64", extend("exclusiveMinimum" = 0))]
    pub edge_length: Option<f64>,
    /// Number of vertices that are not on the boundary.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 1_000_000_000))]
    pub interior_vertices: Option<u32>,
}

impl Default for Resolution {
    fn default() -> Self {
        Self { triangles: Some(2000), edge_length: None, interior_vertices: None }
    }
}

/// Whether points may be added on the segments of the boundary (`refine`), or the mesh has the polygon's vertices only (`keep`).
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BoundarySampling {
    #[default]
    Keep,
}

/// The mesh that the solver starts from.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InitialMesh {
    #[default]
    Auto,
    Rings,
}

/// `fixed`: the result has the initial mesh's topology.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Topology {
    #[default]
    Fixed,
}

impl MinimalSurfaceRequest {
    /// What the schema cannot say.
    ///
    /// # Errors
    /// Every offending value.
    pub fn check(&self, limits: &LimitsConfig) -> Result<(), Rejection> {
        common::check_point_count("/boundaries", &self.boundaries, limits.points)?;
        let too_many = |pointer: &str, detail: String| Err(Rejection::TooLarge(vec![FieldError::new(pointer, detail)]));
        if self.resolution.triangles.is_some_and(|count| count as usize > limits.triangles) {
            let detail = format!("is more than this server makes ({}); see GET /v1/limits", limits.triangles);
            return too_many("/resolution/triangles", detail);
        }
        if self.resolution.interior_vertices.is_some_and(|count| count as usize > limits.triangles / 2) {
            let detail = format!("is more than this server makes ({}); see GET /v1/limits", limits.triangles / 2);
            return too_many("/resolution/interior_vertices", detail);
        }
        if self.max_iterations.is_some_and(|count| count > limits.iterations) {
            let detail = format!("is more than this server runs ({}); see GET /v1/limits", limits.iterations);
            return too_many("/max_iterations", detail);
        }
        let (boundaries, options) = self.to_geometry();
        geometry::check(&boundaries, &options)?;
        let estimate = geometry::estimate_triangles(&boundaries, &options);
        if estimate > limits.triangles as f64 {
            let detail =
                format!("asks for about {estimate:.0} triangles, more than this server makes ({})", limits.triangles);
            return too_many("/resolution", detail);
        }
        Ok(())
    }

    /// About how much memory solving it takes. The factors of the stiffness matrix dominate; they grow a little faster than
    /// the mesh, which the factor per triangle allows for up to the largest meshes that are taken.
    #[must_use]
    pub fn memory_bytes(&self) -> u64 {
        const BYTES_PER_TRIANGLE: f64 = 2_000.0;
        let (boundaries, options) = self.to_geometry();
        (geometry::estimate_triangles(&boundaries, &options) * BYTES_PER_TRIANGLE) as u64
    }

    /// The geometry's own terms for this request.
    #[must_use]
    pub fn to_geometry(&self) -> (Vec<Vec<plateau_geometry::DVec3>>, geometry::Options) {
        let resolution = match self.resolution {
            Resolution { triangles: Some(count), .. } => geometry::Resolution::Triangles(count as usize),
            Resolution { edge_length: Some(length), .. } => geometry::Resolution::EdgeLength(length),
            Resolution { interior_vertices, .. } => {
                geometry::Resolution::InteriorVertices(interior_vertices.unwrap_or(1000) as usize)
            }
        };
        let options = geometry::Options {
            objective: match self.objective {
                Objective::MinimalArea => geometry::Objective::MinimalArea,
            },
            solver: match self.solver {
                Solver::Auto => geometry::Solver::Auto,
                Solver::VertexRelaxation => geometry::Solver::VertexRelaxation,
            },
            boundary_sampling: match self.boundary_sampling {
                BoundarySampling::Keep => geometry::BoundarySampling::Keep,
            },
            initial_mesh: match self.initial_mesh {
                InitialMesh::Auto => geometry::InitialMesh::Auto,
                InitialMesh::Rings => geometry::InitialMesh::Rings,
            },
            tolerance: self.tolerance,
            area_tolerance: self.area_tolerance,
            max_iterations: self.max_iterations,
            ..geometry::Options::new(resolution)
        };
        (common::polylines(&self.boundaries), options)
    }
}

/// The objectives of this kind.
#[must_use]
pub fn objectives() -> Vec<ObjectiveDoc> {
    geometry::Objective::ALL
        .iter()
        .map(|objective| {
            let about = objective.describe();
            ObjectiveDoc {
                name: about.name,
                kind: Kind::MinimalSurface,
                minimises: about.minimises,
                unit: about.unit,
                source: about.source,
                options: vec![
                    "solver",
                    "resolution",
                    "boundary_sampling",
                    "initial_mesh",
                    "topology",
                    "tolerance",
                    "area_tolerance",
                    "max_iterations",
                ],
            }
        })
        .collect()
}

/// Minimum, mean, maximum and standard deviation.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct Spread {
    pub min: f64,
    pub mean: f64,
    pub max: f64,
    pub std_dev: f64,
}

impl From<plateau_geometry::mesh::measure::Spread> for Spread {
    fn from(spread: plateau_geometry::mesh::measure::Spread) -> Self {
        Self { min: spread.min, mean: spread.mean, max: spread.max, std_dev: spread.std_dev }
    }
}

#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct MeanCurvature {
    pub max: f64,
    pub mean: f64,
    pub rms: f64,
}

#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct AngleRange {
    pub min: f64,
    pub max: f64,
}

/// One iteration of the solver.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct HistoryRow {
    pub phase: &'static str,
    pub iteration: u32,
    pub area: f64,
    pub residual: f64,
}

/// The second variation of area under normal motion.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct Stability {
    /// Whether the Morse index is 0: a true local minimum, a physical soap film.
    pub stable: bool,
    /// Number of negative eigenvalues.
    pub morse_index: usize,
    /// Against the lumped mass, 1/unit².
    pub lowest_eigenvalue: f64,
}

/// What is reported about a minimal surface. Lengths in the request's unit, areas in its square, curvatures in its inverse, angles in degrees.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct MinimalStatistics {
    pub objective: &'static str,
    pub objective_value: f64,
    /// The solver that ran.
    pub solver: &'static str,
    /// The initial mesh that was built.
    pub initial_mesh: &'static str,
    pub vertices: usize,
    pub triangles: usize,
    pub boundary_loops: usize,
    pub components: usize,
    pub euler_characteristic: i64,
    pub genus: i64,
    pub area: f64,
    /// Area of the initial mesh.
    pub initial_area: f64,
    pub mean_curvature: MeanCurvature,
    /// Largest normal mean curvature times the boundary's radius: dimensionless.
    pub residual: f64,
    /// The same with the tangential part of the area gradient.
    pub residual_full: f64,
    pub converged: bool,
    pub stop_reason: &'static str,
    pub iterations: u32,
    pub history: Vec<HistoryRow>,
    /// Null where it was not computed.
    pub stability: Option<Stability>,
    pub edge_lengths: Spread,
    pub angles_deg: AngleRange,
    pub edges_swapped: u64,
    pub flipped_triangles: usize,
    pub degenerate_triangles: usize,
    /// Number of changes of topology.
    pub pinches: usize,
}

impl From<&geometry::Statistics> for MinimalStatistics {
    fn from(statistics: &geometry::Statistics) -> Self {
        let row = |row: &geometry::HistoryRow| HistoryRow {
            phase: row.phase,
            iteration: row.iteration,
            area: row.area,
            residual: row.residual,
        };
        Self {
            objective: statistics.objective.name(),
            objective_value: statistics.objective_value,
            solver: statistics.solver.name(),
            initial_mesh: statistics.initial_mesh.name(),
            vertices: statistics.vertices,
            triangles: statistics.triangles,
            boundary_loops: statistics.boundary_loops,
            components: statistics.components,
            euler_characteristic: statistics.euler_characteristic,
            genus: statistics.genus,
            area: statistics.area,
            initial_area: statistics.initial_area,
            mean_curvature: MeanCurvature {
                max: statistics.mean_curvature.max,
                mean: statistics.mean_curvature.mean,
                rms: statistics.mean_curvature.rms,
            },
            residual: statistics.residual,
            residual_full: statistics.residual_full,
            converged: statistics.converged,
            stop_reason: statistics.stop_reason.name(),
            iterations: statistics.iterations,
            history: statistics.history.iter().map(row).collect(),
            stability: statistics.stability.map(|stability| Stability {
                stable: stability.stable,
                morse_index: stability.morse_index,
                lowest_eigenvalue: stability.lowest_eigenvalue,
            }),
            edge_lengths: statistics.edge_lengths.into(),
            angles_deg: AngleRange {
                min: statistics.smallest_angle.to_degrees(),
                max: statistics.largest_angle.to_degrees(),
            },
            edges_swapped: statistics.edges_swapped,
            flipped_triangles: statistics.flipped_triangles,
            degenerate_triangles: statistics.degenerate_triangles,
            pinches: statistics.pinches.len(),
        }
    }
}
