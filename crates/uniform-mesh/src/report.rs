//! The result of a solve: the mesh, its members and their statistics.

use super::statistics::{LengthHistogram, Stage};
use plateau_mesh::Mesh;
use plateau_mesh::error::Warning;
use plateau_mesh::measure::Spread;

/// Why an edge is outside [ℓ, 2ℓ].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Why {
    /// A side of the domain is itself shorter than ℓ. The edge is that side, or joins nodes on both sides of it.
    ShortSide,
    /// The edge joins two sides that meet at an inner angle below 90°.
    SharpCorner,
    /// The edge joins two parts of the boundary that come closer than ℓ.
    Narrow,
    /// The surface is curved at the edge.
    Curvature,
    /// The optimisation moved the nodes so that the edge left the range. [`Transition::Free`](super::Transition::Free)
    /// and [`Optimise::Lengths`](super::Optimise::Lengths) allow this.
    Optimised,
    /// The deadline passed before all nodes were inserted.
    Unfinished,
}

impl Why {
    /// The name in results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::ShortSide => "short_side",
            Self::SharpCorner => "sharp_corner",
            Self::Narrow => "narrow",
            Self::Curvature => "curvature",
            Self::Optimised => "optimised",
            Self::Unfinished => "unfinished",
        }
    }
}

/// An edge outside [ℓ, 2ℓ].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// Index into [`UniformMesh::members`].
    pub member: usize,
    /// The length of the edge, in the caller's unit.
    pub length: f64,
    /// The reason.
    pub why: Why,
}

/// How a curved domain was meshed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The surface was flattened and meshed in the plane, and the mesh was carried back, as in the paper.
    Flattened,
    /// The mesh was made on the surface itself, because the surface cannot be flattened with a bounded distortion.
    OnSurface,
}

impl Method {
    /// The name in results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flattened => "flattened",
            Self::OnSurface => "on_surface",
        }
    }
}

/// Comparison of the mesh with the curved surface that it approximates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SurfaceFit {
    /// How the mesh was made.
    pub method: Method,
    /// The area of the surface itself.
    pub area: f64,
    /// The area of the mesh minus the area of the surface, as a fraction of the area of the surface.
    pub area_error: f64,
    /// Largest distance from a triangle's centroid to the point of the surface below it, in the caller's unit. All
    /// nodes lie on the surface.
    pub distance_max: f64,
    /// Largest angle between a triangle's normal and the surface's normal below the triangle's centroid, in radians.
    pub normal_deviation_max: f64,
}

/// The statistics of a result.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// Number of nodes or of lattice edges, depending on the objective.
    pub objective_value: usize,
    /// Number of nodes.
    pub nodes: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Number of edges.
    pub edges: usize,
    /// Lengths of all edges.
    pub edge_lengths: Spread,
    /// Lengths of the lattice group's edges.
    pub lattice_edges: Spread,
    /// Number of edges whose length differs from ℓ by at most the tolerance.
    pub equal_edges: usize,
    /// The smallest number of different lengths that a workshop has to cut. See
    /// [`distinct_lengths`](super::statistics::distinct_lengths).
    pub distinct_lengths: usize,
    /// The length tolerance of `equal_edges` and `distinct_lengths`, in the caller's unit.
    pub length_tolerance: f64,
    /// Number of edges outside [ℓ, 2ℓ].
    pub out_of_range_edges: usize,
    /// Smallest and largest inner angle, radians.
    pub angles: (f64, f64),
    /// Number of edges by length.
    pub length_histogram: LengthHistogram,
    /// Entry k counts the nodes with k members.
    pub valence_histogram: Vec<usize>,
    /// Lower bound of the number of nodes of any mesh of this domain with every edge at most 2ℓ. `None` for curved
    /// domains.
    pub node_lower_bound: Option<usize>,
    /// Comparison of the mesh with its surface. `None` for polygons.
    pub surface: Option<SurfaceFit>,
}

/// A uniform mesh with its members and statistics.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct UniformMesh {
    /// The mesh. Its vertices are first the points of the input (merged points once), then further nodes on the
    /// boundary, then the inner nodes.
    pub mesh: Mesh,
    /// The members: the ends of each edge, each edge once.
    pub members: Vec<[u32; 2]>,
    /// For each member, whether it belongs to the lattice group.
    pub lattice_group: Vec<bool>,
    /// For each member, its length in the caller's unit.
    pub lengths: Vec<f64>,
    /// The statistics.
    pub statistics: Statistics,
    /// Table 1 of the paper, stage by stage.
    pub stages: Vec<Stage>,
    /// With [`Optimise::Lengths`](super::Optimise::Lengths), the deviation for each number of different lengths that
    /// was tried.
    pub shared_lengths: Vec<LengthsRow>,
    /// The edges outside [ℓ, 2ℓ], in the order of the members.
    pub out_of_range: Vec<OutOfRange>,
    /// For each input point, in input order, its vertex. Merged points have the same vertex.
    pub input_vertices: Vec<Option<u32>>,
    /// False if the deadline passed before the work was done, or if the surface is curved too strongly for this edge
    /// length. The warning `not_converged` then states by how much. The mesh is valid in any case.
    pub converged: bool,
    /// Facts about the result that the caller should know.
    pub warnings: Vec<Warning>,
}

/// Deviation of the members for one number of distinct lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "SharedLengths"))]
#[non_exhaustive]
pub struct LengthsRow {
    /// Number of different lengths.
    pub lengths: usize,
    /// Largest difference between a member's length and the shared length that replaces it.
    pub deviation: f64,
    /// The same difference before the nodes moved.
    pub deviation_before: f64,
}
