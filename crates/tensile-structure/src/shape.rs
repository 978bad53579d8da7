//! The result of form finding: the shape, the forces in it and its figures.

use super::options::{BoundaryPoint, WeaveHold};
use super::ponding::Ponding;
use plateau_equilibrium::Stability;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::error::Warning;
use plateau_mesh::measure::Quality;
use plateau_mesh::{DVec3, Mesh};

/// The reaction of a support at one vertex: the end of a cable, an anchor in the air or a sliding point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Reaction {
    /// The vertex.
    pub vertex: u32,
    /// The boundary point of the vertex; `None` for a vertex in the air.
    pub point: Option<BoundaryPoint>,
    /// The force of the support on the structure.
    pub force: DVec3,
}

/// The sum of the reactions along the held parts of a boundary, without the reactions at single vertices
/// ([`Reaction`]).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EdgeReaction {
    /// The number of the boundary.
    pub boundary: usize,
    /// The sum of the forces of the supports on the structure.
    pub force: DVec3,
    /// The least and the largest magnitude of [`EdgeForce::per_length`] along the boundary. `None` if none of its
    /// segments is held.
    pub per_length: Option<(f64, f64)>,
}

/// The force of the supports on the structure along one segment of a held edge.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EdgeForce {
    /// The ends of the segment.
    pub segment: [u32; 2],
    /// The force per length of the segment: Σ S ν over the triangles beside the segment. S is the stress of a triangle,
    /// and ν is the unit vector in its plane that points across the segment out of the triangle. The value is exact for
    /// a film of one isotropic tension σ, which pulls with σ. Elsewhere its error is of first order in the edge length.
    pub per_length: DVec3,
}

/// A cable or a mast in the found shape.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CableResult {
    /// Its vertices from the first end to the last.
    pub vertices: Vec<u32>,
    /// The force in each segment.
    pub segment_forces: Vec<f64>,
    /// The mean force, weighted by length.
    pub force: f64,
    /// The least and the largest force along the cable, which occur at ends of segments. In a heavy cable the force
    /// grows with the height by the weight per length. The force of a segment in
    /// [`segment_forces`](Self::segment_forces) is the one in its middle.
    pub force_range: (f64, f64),
    /// Length.
    pub length: f64,
    /// L0 = L / (1 + F / EA), if the axial stiffness is known.
    pub unstressed_length: Option<f64>,
    /// The largest distance from the chord between the ends.
    pub sag: f64,
    /// Whether the cable carries no force. A mast is never slack.
    pub slack: bool,
}

/// Principal stresses of the film over all triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "FilmStress"))]
pub struct Stress {
    /// Smallest principal stress, a force per length.
    pub min: f64,
    /// Largest principal stress.
    pub max: f64,
    /// Largest deviation of a principal stress from the required tension, as a fraction of it. It falls with the edge
    /// length. With warp and weft that of their stresses from those required at the same place.
    pub deviation: f64,
    /// Stresses along warp and weft; nothing for an isotropic tension.
    pub weave: Option<WeaveStress>,
}

/// The stress of a triangle of the film, with which the forces balance at every vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TriangleStress {
    /// The least and the largest principal stress, a force per length.
    pub principal: (f64, f64),
    /// Unit vector in the triangle's plane along the largest principal stress.
    pub direction: DVec3,
}

/// Stresses along warp and weft.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct WeaveStress {
    /// The prescribed quantity of the stresses.
    pub hold: WeaveHold,
    /// The stress along the warp.
    pub warp: StressRange,
    /// The stress along the weft.
    pub weft: StressRange,
    /// Stress of the weft over that of the warp.
    pub ratio: StressRange,
    /// Ratio of the stresses that were asked for.
    pub required_ratio: f64,
    /// Root mean square over the area of ratio / required ratio - 1.
    pub ratio_deviation_rms: f64,
    /// Root mean square over the area of each stress over the one required at the same place, less 1. Above 0.05 there
    /// is the warning `stress_deviates`.
    pub deviation_rms: f64,
}

/// Smallest, largest and mean value over the film's area.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct StressRange {
    /// The least value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
    /// Mean over the area.
    pub mean: f64,
}

/// A layer of the found shape. In the mesh its triangles follow those of the layers before it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "LayerFigures"))]
#[non_exhaustive]
pub struct LayerResult {
    /// Number of triangles.
    pub triangles: usize,
    /// Area, in square units of the request's unit of length.
    pub area: f64,
    /// Null if the forces could not be balanced.
    pub stress: Option<Stress>,
}

/// A chamber of the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ChamberResult {
    /// The gauge pressure, prescribed or found.
    pub pressure: f64,
    /// The volume up to the next layer, or up to fans from each boundary to its mean.
    pub volume: f64,
}

/// The sums of the forces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ForceBalance {
    /// The sum of all loads: weights and pressure.
    pub loads: DVec3,
    /// The sum of all reactions.
    pub reactions: DVec3,
    /// The sum of the reactions' magnitudes, support by support.
    pub magnitudes: f64,
    /// |loads + reactions| over the sum of the magnitudes.
    pub imbalance: f64,
    /// The largest force on a vertex that is not balanced.
    pub residual_force: f64,
}

/// Figures of the shape and of the run.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// The total energy σ A + Σ T L + …, a force times a length.
    pub energy: f64,
    /// Number of vertices, those of cables in the air included.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Area of all layers.
    pub area: f64,
    /// The layers in the order of the input.
    pub layers: Vec<LayerResult>,
    /// The chambers in the order of the input.
    pub chambers: Vec<ChamberResult>,
    /// How far the shape is from equilibrium, dimensionless.
    pub residual: f64,
    /// Whether the residual is at most the tolerance and no triangle is flipped or degenerate.
    pub converged: bool,
    /// Why form finding ended.
    pub stop_reason: StopReason,
    /// Number of linear solves.
    pub iterations: u32,
    /// Principal stresses of all layers; `None` if the forces could not be balanced.
    pub stress: Option<Stress>,
    /// Sums of the forces; `None` if the forces could not be balanced.
    pub balance: Option<ForceBalance>,
    /// The least and the largest angle, in radians, between a surface and the film's pull on an edge that slides on
    /// this surface. In equilibrium it is a right angle, or the given contact angle. `None` if no edge slides on a
    /// surface.
    pub contact_angle: Option<(f64, f64)>,
    /// Stability, if it was found.
    pub stability: Option<Stability>,
    /// The least slope of a triangle against the horizontal, in radians.
    pub minimum_slope: f64,
    /// The centroid of the triangle with the least slope.
    pub flattest_place: DVec3,
    /// The water that stands on the film after rain; `None` if it runs off.
    pub ponding: Option<Ponding>,
    /// Edge lengths, angles, flipped and degenerate triangles of all layers.
    pub quality: Quality,
}

/// A tensile structure in equilibrium.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TensileStructure {
    /// The mesh of all layers. Its vertices come in this order: the input's points (equal neighbours once, fixed points
    /// at exactly the given coordinates), the other vertices of the film, and the vertices of cables in the air, which
    /// belong to no triangle.
    pub mesh: Mesh,
    /// Each boundary as a loop of vertices, in the input's direction, added points included.
    pub boundaries: Vec<Vec<u32>>,
    /// For each boundary the vertices of its input points.
    pub input_vertices: Vec<Vec<u32>>,
    /// The stress of each triangle. Empty if the forces could not be balanced.
    pub stresses: Vec<TriangleStress>,
    /// The cables in the order of the input.
    pub cables: Vec<CableResult>,
    /// Reactions at single vertices.
    pub reactions: Vec<Reaction>,
    /// Sums of the reactions along edges, boundary by boundary.
    pub edge_reactions: Vec<EdgeReaction>,
    /// The reactions along edges, vertex by vertex, whose sums are in [`edge_reactions`](Self::edge_reactions).
    /// Together with [`reactions`](Self::reactions) they balance the loads: the sums of the forces and of the moments
    /// vanish.
    pub edge_supports: Vec<(u32, DVec3)>,
    /// The force per length along each segment of a held edge. Empty if the forces could not be balanced.
    pub edge_forces: Vec<EdgeForce>,
    /// Displacement of each ring along its axis.
    pub ring_travels: Vec<f64>,
    /// Figures of the shape and of the run.
    pub statistics: Statistics,
    /// Facts that the caller should know although the solve went through.
    pub warnings: Vec<Warning>,
}
