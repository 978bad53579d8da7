//! Tensile structures: the request, its statistics, and their conversion to and from the geometry's types.

mod solve;
mod statistics;

pub use statistics::{
    CableForce, ChamberState, EdgeReaction, EquilibriumStability, FilmStress, LayerFigures, MastForce, Ponding,
    RingPosition, StressRange, SupportReaction, TensileStatistics, WeaveHold, WeaveStress,
};

use crate::blocks::{self, Block, Input, Output, Part, Preset, Type};
use crate::body::PointList;
use crate::checked::{Checked, KindRequest, Types};
use crate::common::{self, LengthAndForce, Point};
use crate::kind::{Entry, Kind, Objective as ObjectiveDoc, Units};
use crate::limits::{self, Limits};
use crate::rejection::{FieldError, Rejection};
use crate::resolution::Resolution;
use plateau_archive::units::{Unit, UpAxis};
use plateau_film::equilibrium::Support;
use plateau_film::tensile_structure as geometry;
use plateau_mesh::DVec3;
use schemars::JsonSchema;
use serde::Deserialize;

pub const KIND: Kind = Kind::of(&ENTRY);

static ENTRY: Entry = Entry {
    name: "tensile_structure",
    path: "/v1/tensile-structures",
    summary: "Finds the shape in equilibrium of a film with cables, pressure and weight",
    finds: "films with cables in equilibrium",
    point_fields: &["boundaries"],
    units: Units::LengthAndForce,
    blocks: &[
        Block {
            name: "tensile-structure",
            title: "Tensile Structure",
            description: "Film in equilibrium with cables along its edges between anchors.",
            inputs: &[
                blocks::BOUNDARIES,
                Input::list(
                    "Anchors",
                    "A",
                    Type::Point,
                    2,
                    "Fixed points on the boundaries. A cable runs along the edge between neighbouring anchors. A boundary \
                     without anchors is fixed as a whole.",
                ),
                Input::required(
                    "Cable Value",
                    "C",
                    Type::Number,
                    "Value that the mode holds constant for every cable.",
                ),
                Input::optional(
                    "Cable Mode",
                    "M",
                    Preset::Text("force"),
                    "force, end_tension, horizontal_component, force_density, length or sag.",
                ),
                TENSION,
                WEIGHT,
                blocks::TRIANGLES,
            ],
        },
        Block {
            name: "pneumatic-film",
            title: "Pneumatic Film",
            description: "Film in equilibrium with a pressure or around a volume, on fixed edges.",
            inputs: &[
                blocks::BOUNDARIES,
                Input::optional(
                    "Pressure",
                    "P",
                    Preset::Number(0.0),
                    "Force per area, towards the side from which the first boundary runs counter-clockwise.",
                ),
                Input::optional(
                    "Volume",
                    "V",
                    Preset::Number(0.0),
                    "Volume under the film in place of the pressure, unless 0.",
                ),
                TENSION,
                WEIGHT,
                blocks::TRIANGLES,
            ],
        },
    ],
    outputs: &[
        blocks::MESH,
        blocks::AREA,
        blocks::CONVERGED,
        Output::figure("/pressure", "Pressure", "P", Type::Number, "Pressure, given or found."),
        Output::part(Part::Cables, "Cables", "Ca", Type::Curve, "Segments of the cables."),
        blocks::CABLE_FORCES,
        Output::part(Part::Anchors, "Anchor Points", "AP", Type::Point, "Supports at the ends of cables."),
        blocks::ANCHOR_FORCES,
    ],
    objectives,
    types: Types::of::<TensileStructureRequest>(),
};

const TENSION: Input =
    Input::optional("Film Tension", "S", Preset::Number(1.0), "Tension of the film, a force per length.")
        .to("/film/tension");
const WEIGHT: Input =
    Input::optional("Film Weight", "W", Preset::Number(0.0), "Weight of the film per area, against the z axis.")
        .to("/film/weight");

/// Largest number of cables, and of free points, of a request.
const MAX_CABLES: u32 = 1000;
/// Largest number of layers, and of chambers, of a request. Cushions have two to five.
const MAX_LAYERS: u32 = 16;
/// Largest number of points of a polyline of directions. Every triangle looks for its nearest point in every round.
const MAX_DIRECTION_POINTS: u32 = 200;

/// A film with cables, pressure and weight, whose shape in equilibrium is found.
///
/// Every point of the boundaries is a support, unless it lies strictly inside the stretch of a cable or is listed in
/// `free_points`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TensileStructureRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default)]
    pub kind: Option<TensileStructureKind>,
    #[serde(default)]
    pub units: LengthAndForce,
    /// Axis that points up. Weights pull against it.
    #[serde(default)]
    pub up: UpAxis,
    /// Closed polygons that do not repeat their first point: the edges of the film before form finding.
    #[schemars(length(min = 1), inner(length(min = 3)))]
    pub boundaries: Vec<Vec<Point>>,
    /// The film. Required unless there are `layers`.
    #[serde(default)]
    #[schemars(with = "Film")]
    pub film: Option<Film>,
    /// Two or more films over the same boundaries in place of `film`: a cushion. The first lies on the side from which
    /// the first boundary runs counter-clockwise, each next one below it. Each has a `tension`.
    #[serde(default)]
    #[schemars(with = "Vec<Film>", length(min = 2, max = MAX_LAYERS))]
    pub layers: Option<Vec<Film>>,
    /// Closed spaces below layers. Every space between two layers needs one. Not together with `film`, which has
    /// `pressure` and `volume`.
    #[serde(default)]
    #[schemars(length(max = MAX_LAYERS))]
    pub chambers: Vec<Chamber>,
    /// Cables along the boundaries and in the air.
    #[serde(default)]
    #[schemars(length(max = MAX_CABLES))]
    pub cables: Vec<Cable>,
    /// Points of the boundaries that no support holds although cables end there. Each needs a cable along the boundary
    /// on both sides; cables in the air can tie it back.
    #[serde(default)]
    #[schemars(length(max = MAX_CABLES))]
    pub free_points: Vec<BoundaryPoint>,
    /// Supports on which points or edges of the film slide without friction.
    #[serde(default)]
    #[schemars(length(max = MAX_CABLES))]
    pub supports: Vec<SlidingSupport>,
    /// Boundaries that are rigid rings and move along an axis.
    #[serde(default)]
    #[schemars(length(max = MAX_CABLES))]
    pub rings: Vec<Ring>,
    /// Points in the air at which cables and masts end and which no support holds.
    #[serde(default)]
    #[schemars(length(max = MAX_CABLES))]
    pub joints: Vec<Point>,
    /// Straight members that may push.
    #[serde(default)]
    #[schemars(length(max = MAX_CABLES))]
    pub masts: Vec<Mast>,
    /// Pressure, a force per area, towards the side from which the first boundary runs counter-clockwise. Not together
    /// with `volume`, and not with cables along a boundary, `supports`, `rings` or `layers`.
    #[serde(default)]
    #[schemars(range(min = -1e50, max = 1e50))]
    pub pressure: Option<f64>,
    /// Volume between the film and fans from each boundary to its mean, on the side to which a pressure pushes. The
    /// pressure is found. Not with cables along a boundary, `supports`, `rings` or `layers`.
    #[serde(default)]
    #[schemars(range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub volume: Option<f64>,
    /// Resolution of the mesh of each layer. If absent, 2,000 triangles, or four for each boundary point where those are more.
    #[serde(default)]
    pub resolution: Resolution,
    /// Residual (largest unbalanced force over twice the vertex's share of tension times area, times the radius of the
    /// supports) at which the shape counts as found.
    #[serde(default = "default_tolerance")]
    #[schemars(range(min = 0, max = 1))]
    pub tolerance: f64,
    /// Maximum number of linear solves. Null means 400.
    #[serde(default)]
    #[schemars(range(min = 1, max = 1_000_000_000))]
    pub max_iterations: Option<u32>,
}

fn default_tolerance() -> f64 {
    1e-8
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TensileStructureKind {
    TensileStructure,
}

/// The film's prestress and weight. The prestress is either `tension`, or `warp` and `weft` with a `direction`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "TensileFilm")]
pub struct Film {
    /// Isotropic tension, a force per length.
    #[serde(default)]
    #[schemars(with = "f64", range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub tension: Option<f64>,
    /// Stress along the warp, a force per length.
    #[serde(default)]
    #[schemars(with = "f64", range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub warp: Option<f64>,
    /// Stress along the weft, at right angles to the warp, a force per length.
    #[serde(default)]
    #[schemars(with = "f64", range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub weft: Option<f64>,
    #[serde(default)]
    #[schemars(with = "WarpDirection")]
    pub direction: Option<WarpDirection>,
    #[serde(default)]
    #[schemars(with = "WeaveHold")]
    pub hold: Option<WeaveHold>,
    /// Weight per area of the found shape. An isotropic tension is `tension` at the film's mean height and grows with
    /// the height by the weight.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1e50))]
    pub weight: f64,
}

/// A closed space below a layer: up to the next layer, or, below the last layer, up to fans from each boundary to its
/// mean, which stand for the ground. It has exactly one of `pressure` and `volume`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Chamber {
    /// Number of the layer, counted from 0.
    #[serde(default)]
    #[schemars(range(max = 4_294_967_295u32))]
    pub below: u32,
    /// Pressure above that outside, a force per area.
    #[serde(default)]
    #[schemars(with = "f64", range(min = -1e50, max = 1e50))]
    pub pressure: Option<f64>,
    /// Volume. The pressure is found.
    #[serde(default)]
    #[schemars(with = "f64", range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub volume: Option<f64>,
}

/// Field of directions in space, given by exactly one of its fields. The film's warp is the projection of the field
/// onto the film. Directions need no unit length.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
pub struct WarpDirection {
    #[serde(default)]
    #[schemars(with = "RadialDirection")]
    pub radial: Option<RadialDirection>,
    /// Vector along which the warp runs.
    #[serde(default)]
    #[schemars(with = "Point")]
    pub parallel: Option<Point>,
    /// Polyline along whose tangent at the nearest point the warp runs.
    #[serde(default)]
    #[schemars(with = "Vec<Point>", length(min = 2, max = MAX_DIRECTION_POINTS))]
    pub along: Option<Vec<Point>>,
}

/// The weft runs around an axis and the warp away from it. The axis must not pass through the film.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RadialDirection {
    /// A point of the axis.
    pub point: Point,
    pub axis: Point,
}

impl Film {
    /// Converts the film to the geometry's type.
    fn to_geometry(&self, pointer: &str) -> Result<geometry::FilmStress, Vec<FieldError>> {
        Ok(geometry::FilmStress { prestress: self.prestress(pointer)?, weight: self.weight })
    }

    /// Converts the prestress to the geometry's type, or returns what is missing or too much. `pointer` is the film's.
    fn prestress(&self, pointer: &str) -> Result<geometry::FilmPrestress, Vec<FieldError>> {
        let (warp, weft, direction) = match (self.tension, self.warp, self.weft, &self.direction, self.hold) {
            (Some(tension), None, None, None, None) => return Ok(geometry::FilmPrestress::Isotropic(tension)),
            (None, None, None, None, None) => {
                let detail = "is required, or warp, weft and direction in its place";
                return Err(vec![FieldError::new(format!("{pointer}/tension"), detail)]);
            }
            (Some(_), ..) => {
                let detail = "is not allowed with warp, weft, direction or hold";
                return Err(vec![FieldError::new(format!("{pointer}/tension"), detail)]);
            }
            (None, Some(warp), Some(weft), Some(direction), _) => (warp, weft, direction),
            (None, warp, weft, direction, _) => {
                let given = [("warp", warp.is_some()), ("weft", weft.is_some()), ("direction", direction.is_some())];
                let detail = "is required: a prestress by warp and weft needs both and a direction";
                let missing = given.into_iter().filter(|(_, given)| !given);
                return Err(missing.map(|(name, _)| FieldError::new(format!("{pointer}/{name}"), detail)).collect());
            }
        };
        let unit = |vector: Point, field: &str| {
            let error = || FieldError::new(format!("{pointer}/direction/{field}"), "must be a vector with a length");
            DVec3::from_array(vector).try_normalize().ok_or_else(|| vec![error()])
        };
        let direction = match direction {
            WarpDirection { radial: Some(RadialDirection { point, axis }), .. } => {
                geometry::WarpDirection::Radial { point: DVec3::from_array(*point), axis: unit(*axis, "radial/axis")? }
            }
            WarpDirection { parallel: Some(vector), .. } => {
                geometry::WarpDirection::Parallel(unit(*vector, "parallel")?)
            }
            // The schema demands exactly one of the three.
            WarpDirection { along, .. } => {
                geometry::WarpDirection::Along(common::points(along.as_deref().unwrap_or_default()))
            }
        };
        let hold = match self.hold.unwrap_or_default() {
            WeaveHold::Ratio => geometry::WeaveHold::Ratio,
            WeaveHold::Magnitudes => geometry::WeaveHold::Magnitudes,
        };
        Ok(geometry::FilmPrestress::Woven(geometry::Weave { warp, weft, direction, hold }))
    }
}

/// A cable. Its course is exactly one of `along`, `across` and `points`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cable {
    /// Name in statistics and warnings. Null means its number, as in `cable 0`.
    #[serde(default)]
    #[schemars(length(min = 1, max = 100))]
    pub name: Option<String>,
    /// Part of a boundary along which the cable runs. The film's edge hangs on the cable.
    #[serde(default)]
    #[schemars(with = "Along")]
    pub along: Option<Along>,
    /// Points through which the cable runs across the film before form finding, as a ridge or a valley. The first and
    /// the last are points of the boundaries. Cables across the film may share points but must not cross.
    #[serde(default)]
    #[schemars(with = "Vec<Point>", length(min = 2))]
    pub across: Option<Vec<Point>>,
    /// Two points between which the cable runs in the air. A point that equals a boundary's point, one of `joints` or
    /// the hub of a ring is joined to it; any other point is a support.
    #[serde(default)]
    #[schemars(with = "[Point; 2]")]
    pub points: Option<[Point; 2]>,
    #[serde(default)]
    pub mode: Mode,
    /// Value that the mode holds constant: a force, a force per length (`force_density`) or a length.
    #[schemars(range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub value: f64,
    /// EA, a force. `unstressed_length` needs it; with other modes it gives the unstressed length.
    #[serde(default)]
    #[schemars(range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub axial_stiffness: Option<f64>,
    /// Weight per length of the found shape.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1e50))]
    pub weight: f64,
}

/// A part of a boundary, in the boundary's direction. Points are counted from 0.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Along {
    #[serde(default)]
    #[schemars(range(max = 4_294_967_295u32))]
    pub boundary: u32,
    /// Number of the point at which the cable begins.
    #[schemars(range(max = 4_294_967_295u32))]
    pub from: u32,
    /// Number of the point at which it ends.
    #[schemars(range(max = 4_294_967_295u32))]
    pub to: u32,
}

/// A point of a boundary, counted from 0.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoundaryPoint {
    #[serde(default)]
    #[schemars(range(max = 4_294_967_295u32))]
    pub boundary: u32,
    #[schemars(range(max = 4_294_967_295u32))]
    pub point: u32,
}

/// A support without friction. What slides is exactly one of `along`, `boundary` and `point`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SlidingSupport {
    /// Part of a boundary, without its two ends.
    #[serde(default)]
    #[schemars(with = "Along")]
    pub along: Option<Along>,
    /// Number of a boundary that slides as a whole.
    #[serde(default)]
    #[schemars(with = "u32", range(max = 4_294_967_295u32))]
    pub boundary: Option<u32>,
    #[serde(default)]
    #[schemars(with = "BoundaryPoint")]
    pub point: Option<BoundaryPoint>,
    pub on: Guide,
    /// Angle between the film and the surface, on the left of the edge's direction, as seen from the side to which the
    /// surface's normal points: a plane's `normal`, outside a sphere or cylinder. Null means 90. A given angle needs an
    /// edge on a plane, sphere or cylinder, and a single film with a `tension` and no weight.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 180))]
    pub contact_angle_deg: Option<f64>,
}

/// A boundary that is a rigid ring, guided along an axis without friction. It turns nowhere.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ring {
    #[schemars(range(max = 4_294_967_295u32))]
    pub boundary: u32,
    /// Direction in which the ring moves. It needs no unit length.
    pub axis: Point,
    /// Force on the ring along the axis, from outside.
    #[serde(default)]
    #[schemars(range(min = -1e50, max = 1e50))]
    pub force: f64,
    /// Point in the air that moves with the ring. Masts and cables may end there.
    #[serde(default)]
    #[schemars(with = "Point")]
    pub hub: Option<Point>,
}

/// A straight member between two points that may push. A point that equals a boundary's point, one of `joints` or the
/// hub of a ring is joined to it; any other point is a support. At least one end is no support.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mast {
    /// Name in statistics and warnings. Null means its number, as in `mast 0`.
    #[serde(default)]
    #[schemars(length(min = 1, max = 100))]
    pub name: Option<String>,
    pub points: [Point; 2],
    #[serde(default)]
    pub mode: MastMode,
    /// Value that the mode holds constant: a length, or the force with which the mast pushes.
    #[schemars(range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub value: f64,
}

/// Quantity of a mast that is held constant.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MastMode {
    /// The length. The force is found, and negative if the mast has to pull.
    #[default]
    Length,
    /// The force with which the mast pushes. The length is found.
    Force,
}

impl Mast {
    fn to_geometry(&self, number: usize) -> geometry::Cable {
        geometry::Cable {
            name: self.name.clone().unwrap_or_else(|| format!("mast {number}")),
            course: geometry::Course::Mast(self.points.map(DVec3::from_array)),
            mode: match self.mode {
                MastMode::Length => geometry::CableMode::Length(self.value),
                MastMode::Force => geometry::CableMode::Force(self.value),
            },
            axial_stiffness: None,
            weight: 0.0,
        }
    }
}

/// A line or surface to slide on, given by exactly one of its fields. Edges slide on surfaces only. Directions need no
/// unit length.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
pub struct Guide {
    #[serde(default)]
    #[schemars(with = "LineGuide")]
    pub line: Option<LineGuide>,
    #[serde(default)]
    #[schemars(with = "CircleGuide")]
    pub circle: Option<CircleGuide>,
    #[serde(default)]
    #[schemars(with = "PlaneGuide")]
    pub plane: Option<PlaneGuide>,
    #[serde(default)]
    #[schemars(with = "SphereGuide")]
    pub sphere: Option<SphereGuide>,
    #[serde(default)]
    #[schemars(with = "CylinderGuide")]
    pub cylinder: Option<CylinderGuide>,
    #[serde(default)]
    #[schemars(with = "MeshGuide")]
    pub mesh: Option<MeshGuide>,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineGuide {
    pub point: Point,
    pub direction: Point,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CircleGuide {
    pub centre: Point,
    /// Normal of the circle's plane.
    pub axis: Point,
    #[schemars(range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlaneGuide {
    pub point: Point,
    pub normal: Point,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereGuide {
    pub centre: Point,
    #[schemars(range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CylinderGuide {
    /// A point of the axis.
    pub point: Point,
    pub axis: Point,
    #[schemars(range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

/// A smooth surface along the client's own mesh. Neighbouring triangles are oriented alike.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshGuide {
    #[schemars(length(min = 3))]
    pub vertices: Vec<Point>,
    /// Vertex indices of each triangle, counted from 0.
    #[schemars(length(min = 1), inner(inner(range(min = 0, max = 4_294_967_295u32))))]
    pub triangles: Vec<[u32; 3]>,
    /// Length within which the mesh's edges are rounded, because a film cannot slide over a sharp edge. For a mesh of a
    /// curved surface two to three times the length of its edges.
    #[schemars(range(max = 1e50), extend("exclusiveMinimum" = 0))]
    pub rounding: f64,
}

impl MeshGuide {
    /// Number of vertices or of triangles, whichever is larger.
    fn size(&self) -> usize {
        self.vertices.len().max(self.triangles.len())
    }
}

impl Guide {
    /// Converts the guide, or returns the place of an error and the error. The schema demands exactly one field.
    fn to_geometry(&self) -> Result<Support, (String, String)> {
        let unit = |vector: Point, field: &str| {
            let error = || (field.to_owned(), "must be a vector with a length".to_owned());
            DVec3::from_array(vector).try_normalize().ok_or_else(error)
        };
        let place = DVec3::from_array;
        if let Some(LineGuide { point, direction }) = self.line {
            let direction = unit(direction, "line/direction")?;
            return Ok(Support::Line { point: place(point), direction });
        }
        if let Some(CircleGuide { centre, axis, radius }) = self.circle {
            return Ok(Support::Circle { centre: place(centre), axis: unit(axis, "circle/axis")?, radius });
        }
        if let Some(SphereGuide { centre, radius }) = self.sphere {
            return Ok(Support::Sphere { centre: place(centre), radius });
        }
        if let Some(CylinderGuide { point, axis, radius }) = self.cylinder {
            return Ok(Support::Cylinder { point: place(point), axis: unit(axis, "cylinder/axis")?, radius });
        }
        if let Some(MeshGuide { vertices, triangles, rounding }) = &self.mesh {
            return Support::mesh(&common::points(vertices), triangles, *rounding)
                .map_err(|error| (format!("mesh{}", error.place), error.detail));
        }
        let PlaneGuide { point, normal } = self.plane.ok_or_else(|| ("plane".into(), "is required".into()))?;
        Ok(Support::Plane { point: place(point), normal: unit(normal, "plane/normal")? })
    }
}

impl BoundaryPoint {
    fn to_geometry(self) -> geometry::BoundaryPoint {
        geometry::BoundaryPoint { boundary: self.boundary as usize, point: self.point as usize }
    }
}

/// Quantity of a cable that is held constant.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "CableMode")]
pub enum Mode {
    /// The force. With a weight, the mean force.
    #[default]
    Force,
    /// The force at the first end.
    EndTension,
    /// The part of the force at the first end that is across the up axis.
    HorizontalComponent,
    /// The force divided by the length of the whole cable.
    ForceDensity,
    /// The length in the found shape.
    Length,
    /// The length without force. The force is EA (length / unstressed length - 1), and 0 if that is negative.
    UnstressedLength,
    /// The largest distance from the chord between the ends.
    Sag,
}

impl Cable {
    fn to_geometry(&self, number: usize) -> geometry::Cable {
        let name = self.name.clone().unwrap_or_else(|| format!("{number}"));
        let course = match (&self.along, &self.across, &self.points) {
            (_, Some(points), _) => geometry::Course::Across(common::points(points)),
            (Some(Along { boundary, from, to }), ..) => {
                geometry::Course::Boundary { boundary: *boundary as usize, from: *from as usize, to: *to as usize }
            }
            (None, None, points) => geometry::Course::Air(points.unwrap_or_default().map(DVec3::from_array)),
        };
        let mode = match self.mode {
            Mode::Force => geometry::CableMode::Force,
            Mode::EndTension => geometry::CableMode::EndTension,
            Mode::HorizontalComponent => geometry::CableMode::HorizontalComponent,
            Mode::ForceDensity => geometry::CableMode::ForceDensity,
            Mode::Length => geometry::CableMode::Length,
            Mode::UnstressedLength => geometry::CableMode::UnstressedLength,
            Mode::Sag => geometry::CableMode::Sag,
        };
        let (axial_stiffness, weight) = (self.axial_stiffness, self.weight);
        geometry::Cable { name, course, mode: mode(self.value), axial_stiffness, weight }
    }
}

impl KindRequest for TensileStructureRequest {
    type Statistics = TensileStatistics;

    fn axes(&self) -> (Unit, UpAxis) {
        (self.units.into(), self.up)
    }

    fn take(&mut self, list: &PointList) {
        if list.field == "boundaries" {
            self.boundaries.clone_from(&list.polylines);
        }
    }

    fn check(&self, limits: &Limits) -> Result<Checked, Rejection> {
        limits::check_point_count("/boundaries", &self.boundaries, limits.points)?;
        self.resolution.check(limits)?;
        limits::check_number("/max_iterations", self.max_iterations, limits.iterations as usize)?;
        let across = self.cables.iter().filter_map(|cable| cable.across.as_ref()).map(Vec::len).sum();
        limits::check_count("/cables", across, limits.points, "points")?;
        let meshes = self.supports.iter().filter_map(|support| support.on.mesh.as_ref()).map(MeshGuide::size).sum();
        limits::check_count("/supports", meshes, limits.triangles, "triangles or vertices of meshes")?;
        let mut errors = Vec::new();
        if self.pressure.is_some() && self.volume.is_some() {
            errors.push(FieldError::new(
                "/volume",
                "is not allowed with a pressure: one of the two follows from the other",
            ));
        }
        for (k, cable) in self.cables.iter().enumerate() {
            let courses = [cable.along.is_some(), cable.across.is_some(), cable.points.is_some()];
            if courses.into_iter().filter(|given| *given).count() != 1 {
                errors.push(FieldError::new(
                    format!("/cables/{k}"),
                    "must have exactly one of the members along, across, points",
                ));
            }
        }
        let mut sliding = Vec::with_capacity(self.supports.len());
        for (k, support) in self.supports.iter().enumerate() {
            let part = match (support.along, support.boundary, support.point) {
                (Some(Along { boundary, from, to }), None, None) => {
                    let [boundary, from, to] = [boundary, from, to].map(|number| number as usize);
                    geometry::SlidingPart::Edge { boundary, from, to }
                }
                (None, Some(boundary), None) => geometry::SlidingPart::Boundary(boundary as usize),
                (None, None, Some(point)) => geometry::SlidingPart::Point(point.to_geometry()),
                _ => {
                    let detail = "must have exactly one of the members along, boundary, point";
                    errors.push(FieldError::new(format!("/supports/{k}"), detail));
                    continue;
                }
            };
            let contact_angle = support.contact_angle_deg.map(f64::to_radians);
            match support.on.to_geometry() {
                Ok(on) => sliding.push(geometry::Sliding { part, on, contact_angle }),
                Err((place, detail)) => errors.push(FieldError::new(format!("/supports/{k}/on/{place}"), detail)),
            }
        }
        let mut rings = Vec::with_capacity(self.rings.len());
        for (k, ring) in self.rings.iter().enumerate() {
            let (boundary, hub) = (ring.boundary as usize, ring.hub.map(DVec3::from_array));
            match DVec3::from_array(ring.axis).try_normalize() {
                Some(axis) => rings.push(geometry::Ring { boundary, axis, force: ring.force, hub }),
                None => errors.push(FieldError::new(format!("/rings/{k}/axis"), "must be a vector with a length")),
            }
        }
        let layers = self.layers(&mut errors);
        let chambers = self.chambers(&mut errors);
        if !errors.is_empty() {
            return Err(Rejection::Invalid(errors));
        }
        let (structure, options) = self.to_geometry(layers, chambers, sliding, rings);
        geometry::check(&structure, &options)?;
        let estimate = geometry::estimate(&structure, &options);
        if estimate.triangles > limits.triangles as f64 {
            let detail = format!(
                "asks for about {:.0} triangles, more than are allowed ({})",
                estimate.triangles, limits.triangles
            );
            return Err(Rejection::TooLarge(vec![FieldError::new("/resolution", detail)]));
        }
        Ok(Checked {
            memory_bytes: estimate.bytes,
            quick: false,
            input: Box::new(solve::SolverInput { structure, options, force: self.units.force }),
        })
    }
}

impl TensileStructureRequest {
    /// Converts the film or the layers.
    fn layers(&self, errors: &mut Vec<FieldError>) -> Vec<geometry::FilmStress> {
        let mut take = |film: &Film, pointer: &str| film.to_geometry(pointer).map_err(|own| errors.extend(own)).ok();
        match (&self.film, &self.layers) {
            (Some(film), None) => take(film, "/film").into_iter().collect(),
            (None, Some(layers)) => {
                layers.iter().enumerate().filter_map(|(k, film)| take(film, &format!("/layers/{k}"))).collect()
            }
            (Some(_), Some(_)) => {
                errors.push(FieldError::new("/layers", "is not allowed with film: a single film is one layer"));
                Vec::new()
            }
            (None, None) => {
                errors.push(FieldError::new("/film", "is required, or layers in its place"));
                Vec::new()
            }
        }
    }

    /// Converts the chambers, or the pressure or volume of a single film.
    fn chambers(&self, errors: &mut Vec<FieldError>) -> Vec<geometry::Chamber> {
        if self.layers.is_none() {
            if !self.chambers.is_empty() {
                let detail = "is not allowed without layers: below a single film it is its pressure or volume";
                errors.push(FieldError::new("/chambers", detail));
            }
            let holds = self.pressure.map(geometry::Pressure::Constant);
            let holds = holds.or(self.volume.map(geometry::Pressure::Volume));
            return holds.map(|holds| geometry::Chamber { below: 0, holds }).into_iter().collect();
        }
        for (name, given) in [("pressure", self.pressure), ("volume", self.volume)] {
            if given.is_some() {
                let detail = "is not allowed with layers: each of chambers has its own";
                errors.push(FieldError::new(format!("/{name}"), detail));
            }
        }
        let mut chambers = Vec::with_capacity(self.chambers.len());
        for (k, chamber) in self.chambers.iter().enumerate() {
            let holds = match (chamber.pressure, chamber.volume) {
                (Some(pressure), None) => geometry::Pressure::Constant(pressure),
                (None, Some(volume)) => geometry::Pressure::Volume(volume),
                _ => {
                    let detail = "must have exactly one of the members pressure, volume";
                    errors.push(FieldError::new(format!("/chambers/{k}"), detail));
                    continue;
                }
            };
            chambers.push(geometry::Chamber { below: chamber.below as usize, holds });
        }
        chambers
    }

    /// Converts the request to the geometry's types.
    fn to_geometry(
        &self,
        layers: Vec<geometry::FilmStress>,
        chambers: Vec<geometry::Chamber>,
        sliding: Vec<geometry::Sliding>,
        rings: Vec<geometry::Ring>,
    ) -> (geometry::Structure, geometry::Options) {
        let resolution = self.resolution.to_geometry(self.boundaries.iter().map(Vec::len).sum());
        let cables = self.cables.iter().enumerate().map(|(k, cable)| cable.to_geometry(k));
        let masts = self.masts.iter().enumerate().map(|(k, mast)| mast.to_geometry(k));
        let structure = geometry::Structure {
            boundaries: common::polylines(&self.boundaries),
            layers,
            // The masts follow the cables.
            cables: cables.chain(masts).collect(),
            free_points: self.free_points.iter().map(|point| point.to_geometry()).collect(),
            sliding,
            rings,
            joints: common::points(&self.joints),
            chambers,
            up: match self.up {
                UpAxis::Z => DVec3::Z,
                UpAxis::Y => DVec3::Y,
            },
        };
        (structure, geometry::Options { resolution, tolerance: self.tolerance, max_iterations: self.max_iterations })
    }
}

/// Returns the objectives of this kind.
fn objectives() -> Vec<ObjectiveDoc> {
    vec![ObjectiveDoc {
        name: "equilibrium",
        kind: KIND,
        minimises: "Σ σ A + Σ T L + Σ (EA / 2 L0) (L - L0)²₊ - Σ p V - Σ σ cos θ W and the potential energy of the \
                    weights, with lengths and volumes as constraints where they are given and the area W of a support \
                    beside an edge of given contact angle θ",
        unit: "force u",
        source: "Schek 1974; Bletzinger, Ramm 1999, section 3",
        options: vec![
            "film",
            "layers",
            "chambers",
            "cables",
            "free_points",
            "supports",
            "rings",
            "joints",
            "masts",
            "pressure",
            "volume",
            "resolution",
            "tolerance",
            "max_iterations",
        ],
    }]
}
