//! Statistics of a tensile structure.

use crate::audit::crossings::Crossings;
use crate::common::{AngleRange, ForceBalance, Point};
use plateau_archive::units::ForceUnit;
use plateau_equilibrium::Stability;
use plateau_mesh::measure::Spread;
use plateau_tensile_structure::{self as geometry, LayerResult, Stress};
use schemars::JsonSchema;
use serde::Serialize;

/// A cable of the found shape.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct CableForce {
    pub name: String,
    pub mode: &'static str,
    /// Mean force, weighted by length.
    pub force: f64,
    /// Least force, at the lower end of a segment if the cable is heavy.
    pub force_min: f64,
    /// Largest force, at the upper end of a segment if the cable is heavy.
    pub force_max: f64,
    pub length: f64,
    /// Length / (1 + force / axial stiffness); null without an axial stiffness.
    pub unstressed_length: Option<f64>,
    /// Axial stiffness of the request, a force; null without one.
    pub axial_stiffness: Option<f64>,
    /// Largest distance from the chord between the ends.
    pub sag: f64,
    /// Whether it carries no force.
    pub slack: bool,
}

/// A mast of the found shape.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct MastForce {
    pub name: String,
    pub mode: &'static str,
    /// Force with which the mast pushes; negative if it pulls.
    pub force: f64,
    pub length: f64,
}

/// A ring of the found shape.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct RingPosition {
    pub boundary: usize,
    /// Distance that the ring has moved along its axis.
    pub travel: f64,
}

/// A support at the end of a cable.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SupportReaction {
    pub vertex: u32,
    /// Number of the boundary, or null for a support in the air.
    pub boundary: Option<usize>,
    /// Number of the boundary's point.
    pub point: Option<usize>,
    /// Force of the support on the structure.
    pub force: Point,
}

/// The supports along the fixed parts of a boundary together.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct EdgeReaction {
    pub boundary: usize,
    /// Force of the supports on the structure.
    pub force: Point,
    /// Magnitude of the force per length along the boundary. Null if none of its segments is held.
    pub force_per_length: Option<ForcePerLength>,
}

/// Forces per length along an edge, a force over the length unit.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct ForcePerLength {
    pub min: f64,
    pub max: f64,
}

/// A chamber of the found shape.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct ChamberState {
    /// Number of the layer above it.
    pub below: usize,
    /// Pressure above that outside, given or found.
    pub pressure: f64,
    /// Volume up to the next layer, or up to fans from each boundary to its mean.
    pub volume: f64,
}

/// Water that stands on the film after rain, in all hollows from which it cannot run off over an edge.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct Ponding {
    /// Depth of the water at its deepest place.
    pub depth: f64,
    /// Deepest place.
    pub at: Point,
    /// Area of the water's surface.
    pub area: f64,
    /// Volume of the water. Times 9.81 kN/m³ it is the water's weight.
    pub volume: f64,
}

/// Statistics of a tensile structure.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct TensileStatistics {
    /// Middle of the mesh's bounding box, which files with `origin=local` are relative to.
    pub origin: Point,
    pub objective: &'static str,
    /// Energy of the found shape. With warp and weft the film counts with half the sum of its stresses times its area.
    pub objective_value: f64,
    /// Unit of the forces.
    pub force_unit: &'static str,
    pub vertices: usize,
    pub triangles: usize,
    /// Area of all layers.
    pub area: f64,
    /// Volume of the first of `chambers`. Null without a pressure.
    pub volume: Option<f64>,
    /// Pressure in the first of `chambers`, given or found; 0 for none.
    pub pressure: f64,
    /// The layers. A single film is one.
    pub layers: Vec<LayerResult>,
    /// The chambers. The space below a single film with a pressure is one.
    pub chambers: Vec<ChamberState>,
    pub cables: Vec<CableForce>,
    pub masts: Vec<MastForce>,
    pub rings: Vec<RingPosition>,
    /// Supports at the ends of cables.
    pub reactions: Vec<SupportReaction>,
    /// Supports along the fixed parts of the boundaries.
    pub edge_reactions: Vec<EdgeReaction>,
    /// Null if the forces could not be balanced.
    pub balance: Option<ForceBalance>,
    /// Stresses of all layers. Null if the forces could not be balanced.
    pub stress: Option<Stress>,
    /// Angle between the film's pull on sliding edges and their surface; of edges with a given angle that on their
    /// left. Null without such an edge.
    pub contact_angle_deg: Option<AngleRange>,
    /// Null where the solve did not converge, and with warp and weft, because no energy has their shape as its minimum.
    pub stability: Option<Stability>,
    /// Smallest slope of a triangle against the horizontal, in degrees. The middle of a saddle and a crown have 0.
    pub minimum_slope_deg: f64,
    /// Centroid of the triangle with the smallest slope.
    pub minimum_slope_at: Point,
    /// Water that would stand on the film after rain. Null if it runs off over the film's edges.
    pub ponding: Option<Ponding>,
    pub residual: f64,
    pub converged: bool,
    pub stop_reason: &'static str,
    pub iterations: u32,
    pub edge_lengths: Spread,
    pub angles_deg: AngleRange,
    pub flipped_triangles: usize,
    pub degenerate_triangles: usize,
    /// Number of pairs of triangles of the film that intersect. Null if not all pairs were looked at.
    pub self_intersections: Option<u64>,
    /// Why `self_intersections` is null: `too_many_pairs`, `deadline_passed`.
    pub self_intersections_skipped: Option<&'static str>,
}

impl TensileStatistics {
    #[must_use]
    pub(crate) fn of(
        result: &geometry::TensileStructure,
        structure: &geometry::Structure,
        force: ForceUnit,
        crossings: Crossings,
        origin: Point,
    ) -> Self {
        let statistics = &result.statistics;
        let members = || structure.cables.iter().zip(&result.cables);
        let chamber = |(chamber, found): (&geometry::Chamber, &geometry::ChamberResult)| ChamberState {
            below: chamber.below,
            pressure: found.pressure,
            volume: found.volume,
        };
        let ring = |(ring, &travel): (&geometry::Ring, &f64)| RingPosition { boundary: ring.boundary, travel };
        let reaction = |reaction: &geometry::Reaction| SupportReaction {
            vertex: reaction.vertex,
            boundary: reaction.point.map(|point| point.boundary),
            point: reaction.point.map(|point| point.point),
            force: reaction.force.to_array(),
        };
        let edge = |edge: &geometry::EdgeReaction| EdgeReaction {
            boundary: edge.boundary,
            force: edge.force.to_array(),
            force_per_length: edge.per_length.map(|(min, max)| ForcePerLength { min, max }),
        };
        Self {
            origin,
            objective: "equilibrium",
            objective_value: statistics.energy,
            force_unit: force.symbol(),
            vertices: statistics.vertices,
            triangles: statistics.triangles,
            area: statistics.area,
            volume: statistics.chambers.first().map(|chamber| chamber.volume),
            pressure: statistics.chambers.first().map_or(0.0, |chamber| chamber.pressure),
            layers: statistics.layers.clone(),
            chambers: structure.chambers.iter().zip(&statistics.chambers).map(chamber).collect(),
            cables: members().filter(|(member, _)| !member.course.is_mast()).map(cable_force).collect(),
            masts: members().filter(|(member, _)| member.course.is_mast()).map(mast_force).collect(),
            rings: structure.rings.iter().zip(&result.ring_travels).map(ring).collect(),
            reactions: result.reactions.iter().map(reaction).collect(),
            edge_reactions: result.edge_reactions.iter().map(edge).collect(),
            balance: statistics.balance.map(|balance| ForceBalance {
                loads: balance.loads.to_array(),
                reactions: balance.reactions.to_array(),
                magnitudes: balance.magnitudes,
                imbalance: balance.imbalance,
                residual_force: balance.residual_force,
            }),
            stress: statistics.stress,
            contact_angle_deg: statistics.contact_angle.map(AngleRange::of_radians),
            stability: statistics.stability,
            minimum_slope_deg: statistics.minimum_slope.to_degrees(),
            minimum_slope_at: statistics.flattest_place.to_array(),
            ponding: statistics.ponding.map(|ponding| Ponding {
                depth: ponding.depth,
                at: ponding.place.to_array(),
                area: ponding.area,
                volume: ponding.volume,
            }),
            residual: statistics.residual,
            converged: statistics.converged,
            stop_reason: statistics.stop_reason.name(),
            iterations: statistics.iterations,
            edge_lengths: statistics.quality.edge_lengths,
            angles_deg: AngleRange::of_radians(statistics.quality.angles),
            flipped_triangles: statistics.quality.flipped_triangles,
            degenerate_triangles: statistics.quality.degenerate_triangles,
            self_intersections: crossings.pairs,
            self_intersections_skipped: crossings.skipped,
        }
    }
}

fn cable_force((cable, found): (&geometry::Cable, &geometry::CableResult)) -> CableForce {
    CableForce {
        name: cable.name.clone(),
        mode: cable.mode.name(),
        force: found.force,
        force_min: found.force_range.0,
        force_max: found.force_range.1,
        length: found.length,
        unstressed_length: found.unstressed_length,
        axial_stiffness: cable.axial_stiffness,
        sag: found.sag,
        slack: found.slack,
    }
}

fn mast_force((mast, found): (&geometry::Cable, &geometry::CableResult)) -> MastForce {
    MastForce { name: mast.name.clone(), mode: mast.mode.name(), force: -found.force, length: found.length }
}
