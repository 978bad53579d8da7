//! Tensile structures: the request, its statistics, and their conversion to and from the geometry's types.

mod audit;
mod cable;
mod film;
mod guide;
mod solve;
mod statistics;

pub use cable::{Along, Cable, Mast, MastMode, Mode};
pub use film::{Chamber, Film, RadialDirection, WarpDirection};
pub use guide::{CircleGuide, CylinderGuide, Guide, LineGuide, MeshGuide, PlaneGuide, SphereGuide, TorusGuide};
pub use statistics::{
    CableForce, ChamberState, EdgeReaction, ForcePerLength, MastForce, Ponding, RingPosition, SupportReaction,
    TensileStatistics,
};

use crate::blocks::{self, Block, Input, Output, Part, Preset, Type};
use crate::checked::{Checked, KindRequest, Types};
use crate::common::{self, LengthAndForce, Point};
use crate::join::{self, Member, Notes, OnSegments, Points, Role};
use crate::kind::{Entry, Kind, Objective as ObjectiveDoc, Units};
use crate::limits::{self, Limits};
use crate::options::{Optioned, RequestOption};
use crate::resolution::Resolution;
use plateau_archive::units::{Unit, UpAxis};
use plateau_mesh::DVec3;
use plateau_strict_json::bounds::{
    Below180, Fraction, List, NonNegative, Positive, Signed, Whole, given, given_one, is_default, one, unwritten,
};
use plateau_strict_json::rejection::{FieldError, Rejection};
use plateau_tensile_structure as geometry;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub const KIND: Kind = Kind::of(&ENTRY);

static ENTRY: Entry = Entry {
    name: "tensile_structure",
    path: "/v1/tensile-structures",
    summary: "Finds the shape in equilibrium of a film with cables, pressure and weight",
    finds: "films with cables in equilibrium",
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
                    "Fixed points on the boundaries. A cable runs along the edge between neighbouring anchors. A \
                     boundary without anchors is fixed as a whole.",
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

/// Largest number of cables of a request. The same limit holds for its free points, supports, rings, joints and masts.
const MAX_CABLES: usize = 1000;
/// Largest number of layers of a request, and of its chambers. Cushions have two to five.
const MAX_LAYERS: usize = 16;

/// A film with cables, pressure and weight, whose shape in equilibrium is found.
///
/// Every point of the boundaries is a support, unless it lies strictly inside the stretch of a cable or is listed in
/// `free_points`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TensileStructureRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default, skip_serializing_if = "unwritten")]
    pub kind: Option<TensileStructureKind>,
    #[serde(default, skip_serializing_if = "is_default")]
    pub units: LengthAndForce,
    /// Axis that points up. Weights pull against it.
    #[serde(default)]
    pub up: UpAxis,
    /// Closed polygons that do not repeat their first point: the edges of the film before form finding.
    pub boundaries: List<List<Point, 3>, 1>,
    /// The film between boundaries and cables. Required unless there are `layers`.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Film")]
    pub film: Option<Film>,
    /// Two or more films over the same boundaries in place of `film`: a cushion. The first lies on the side from which
    /// the first boundary runs counter-clockwise, each next one below it. Each has a `tension`.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "List<Film, 2, MAX_LAYERS>")]
    pub layers: Option<List<Film, 2, MAX_LAYERS>>,
    /// Closed spaces below layers. Every space between two layers needs one. Not together with `film`, which has
    /// `pressure` and `volume`.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub chambers: List<Chamber, 0, MAX_LAYERS>,
    /// Cables along the boundaries and in the air.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub cables: List<Cable, 0, MAX_CABLES>,
    /// Points of the boundaries that no support holds although cables end there. Each needs a cable along the boundary
    /// on both sides; cables in the air can tie it back.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub free_points: List<BoundaryPoint, 0, MAX_CABLES>,
    /// Supports on which points or edges of the film slide without friction.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub supports: List<SlidingSupport, 0, MAX_CABLES>,
    /// Boundaries that are rigid rings and move along an axis.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub rings: List<Ring, 0, MAX_CABLES>,
    /// Points in the air at which cables and masts end and which no support holds.
    #[serde(default)]
    pub joints: List<Point, 0, MAX_CABLES>,
    /// Distance up to which joints, hubs, ends of cables and masts, and points of cables across the film are joined to
    /// points of the boundaries and to each other, in the request's unit. Null means 1e-6 of the request's size, which
    /// is the largest distance of a point from the mean of all points. It counts as at least 8 units in the last place
    /// of the largest coordinate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub join_tolerance: Option<NonNegative>,
    /// Straight members that may push.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub masts: List<Mast, 0, MAX_CABLES>,
    /// Pressure, a force per area, towards the side from which the first boundary runs counter-clockwise. Not together
    /// with `volume`, and not with cables along a boundary, `supports`, `rings` or `layers`.
    #[serde(default)]
    pub pressure: Option<Signed>,
    /// Volume between the film and fans from each boundary to its mean, on the side to which a pressure pushes. The
    /// pressure is found. Not with cables along a boundary, `supports`, `rings` or `layers`.
    #[serde(default)]
    pub volume: Option<Positive>,
    /// Resolution of the mesh of each layer. If absent, 2,000 triangles, or four for each boundary point where those
    /// are more.
    #[serde(default, deserialize_with = "given_one", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Resolution")]
    pub resolution: Option<Resolution>,
    /// Residual (largest unbalanced force over twice the vertex's share of tension times area, times the radius of the
    /// supports) at which the shape counts as found.
    #[serde(default = "default_tolerance")]
    pub tolerance: Fraction,
    /// Maximum number of linear solves. Null means 400.
    #[serde(default)]
    pub max_iterations: Option<Whole<1, 1_000_000_000>>,
}

fn default_tolerance() -> Fraction {
    Fraction::new(1e-8)
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TensileStructureKind {
    TensileStructure,
}

/// A point of a boundary, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoundaryPoint {
    #[serde(default)]
    #[schemars(range(max = 4_294_967_295u32))]
    pub boundary: u32,
    #[schemars(range(max = 4_294_967_295u32))]
    pub point: u32,
}

/// A support without friction. What slides is exactly one of `along`, `boundary` and `point`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SlidingSupport {
    /// Part of a boundary, without its two ends.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Along")]
    pub along: Option<Along>,
    /// Number of a boundary that slides as a whole.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(max = 4_294_967_295u32))]
    pub boundary: Option<u32>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "BoundaryPoint")]
    pub point: Option<BoundaryPoint>,
    #[serde(deserialize_with = "one")]
    pub on: Guide,
    /// Angle between the film and the surface, on the left of the edge's direction, as seen from the side to which the
    /// surface's normal points: a plane's `normal`, outside a sphere or cylinder. Null means 90. A given angle needs an
    /// edge on a plane, sphere or cylinder, and a single film with a `tension` and no weight.
    #[serde(default)]
    pub contact_angle_deg: Option<Below180>,
}

/// A boundary that is a rigid ring, guided along an axis without friction. It turns nowhere.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ring {
    #[schemars(range(max = 4_294_967_295u32))]
    pub boundary: u32,
    /// Direction in which the ring moves. It needs no unit length.
    pub axis: Point,
    /// Force on the ring along the axis, from outside.
    #[serde(default)]
    pub force: Signed,
    /// Point in the air that moves with the ring. Masts and cables may end there.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Point")]
    pub hub: Option<Point>,
}

impl BoundaryPoint {
    fn to_geometry(self) -> geometry::BoundaryPoint {
        geometry::BoundaryPoint { boundary: self.boundary as usize, point: self.point as usize }
    }
}

impl Optioned for TensileStructureRequest {
    const OPTIONS: &'static [RequestOption] = &[
        RequestOption::always("film"),
        RequestOption::always("layers"),
        RequestOption::always("chambers"),
        RequestOption::always("cables"),
        RequestOption::always("free_points"),
        RequestOption::always("supports"),
        RequestOption::always("rings"),
        RequestOption::always("joints"),
        RequestOption::always("join_tolerance"),
        RequestOption::always("masts"),
        RequestOption::always("pressure"),
        RequestOption::always("volume"),
        RequestOption::always("resolution"),
        RequestOption::always("tolerance"),
        RequestOption::always("max_iterations"),
    ];

    fn choice(&self, _member: &str) -> &'static str {
        "equilibrium"
    }
}

impl KindRequest for TensileStructureRequest {
    type Statistics = TensileStatistics;

    fn axes(&self) -> (Unit, UpAxis) {
        (self.units.into(), self.up)
    }

    fn check(&self, limits: &Limits) -> Result<Checked, Rejection> {
        limits::check_count("/boundaries", common::count(&self.boundaries), limits.points, "points")?;
        if let Some(resolution) = self.resolution {
            resolution.check(limits)?;
        }
        limits::check_number("/max_iterations", self.max_iterations.map(Whole::get), limits.iterations as usize)?;
        let across = self.cables.iter().filter_map(|cable| cable.across.as_deref()).map(<[_]>::len).sum();
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
            let courses = [
                ("along", cable.along.is_some()),
                ("across", cable.across.is_some()),
                ("points", cable.points.is_some()),
            ];
            errors.extend(FieldError::unless_one(&format!("/cables/{k}"), &courses).err());
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
            let contact_angle = support.contact_angle_deg.map(|angle| angle.get().to_radians());
            match support.on.to_geometry() {
                Ok(on) => sliding.push(geometry::Sliding { part, on, contact_angle }),
                Err((place, detail)) => errors.push(FieldError::new(format!("/supports/{k}/on/{place}"), detail)),
            }
        }
        let mut rings = Vec::with_capacity(self.rings.len());
        for (k, ring) in self.rings.iter().enumerate() {
            let (boundary, hub) = (ring.boundary as usize, ring.hub.map(DVec3::from_array));
            match DVec3::from_array(ring.axis).try_normalize() {
                Some(axis) => rings.push(geometry::Ring { boundary, axis, force: ring.force.get(), hub }),
                None => errors.push(FieldError::new(format!("/rings/{k}/axis"), "must be a vector with a length")),
            }
        }
        let layers = self.layers(&mut errors);
        let chambers = self.chambers(&mut errors);
        if !errors.is_empty() {
            return Err(Rejection::Invalid(errors));
        }
        let (mut structure, options) = self.to_geometry(layers, chambers, sliding, rings);
        let joined = self.join(&mut structure)?;
        geometry::check(&structure, &options).map_err(|error| joined.added_to(error))?;
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
            input: Box::new(solve::SolverInput { structure, options, force: self.units.force, joined }),
        })
    }
}

impl TensileStructureRequest {
    /// Joins the points that should be one, and returns what the client gets to know of it.
    ///
    /// # Errors
    /// Returns the errors of [`join::join`].
    fn join(&self, structure: &mut geometry::Structure) -> Result<Notes, Rejection> {
        let mut members = Vec::new();
        let mut add = |role, list, number, field, points| members.push(Member { role, list, number, field, points });
        for (k, &joint) in structure.joints.iter().enumerate() {
            add(Role::Joint, "/joints", k, "", vec![joint]);
        }
        for (k, hub) in structure.rings.iter().enumerate().filter_map(|(k, ring)| Some((k, ring.hub?))) {
            add(Role::Joint, "/rings", k, "/hub", vec![hub]);
        }
        for (k, cable) in structure.cables.iter().enumerate() {
            match &cable.course {
                geometry::Course::Boundary { .. } => {}
                geometry::Course::Across(points) => add(Role::Across, "/cables", k, "/across", points.clone()),
                geometry::Course::Air(ends) => add(Role::Cable, "/cables", k, "/points", ends.to_vec()),
                // The masts follow the cables.
                geometry::Course::Mast(ends) => {
                    add(Role::Mast, "/masts", k - self.cables.len(), "/points", ends.to_vec());
                }
            }
        }
        let joined = join::join(&Points {
            boundaries: &structure.boundaries,
            moves: structure.moves(),
            members,
            tolerance: self.join_tolerance.map(NonNegative::get),
            on_segments: OnSegments::Joined,
        })?;
        let mut places = joined.points.into_iter();
        let hubs = structure.rings.iter_mut().filter_map(|ring| ring.hub.as_mut());
        let single = structure.joints.iter_mut().chain(hubs);
        single.zip(places.by_ref().flatten()).for_each(|(point, place)| *point = place);
        let of_cables = structure.cables.iter_mut().filter_map(|cable| match &mut cable.course {
            geometry::Course::Boundary { .. } => None,
            geometry::Course::Across(points) => Some(&mut points[..]),
            geometry::Course::Air(ends) | geometry::Course::Mast(ends) => Some(&mut ends[..]),
        });
        of_cables.zip(places).for_each(|(points, places)| points.copy_from_slice(&places));
        structure.across_ends = joined.ends;
        Ok(joined.notes)
    }

    /// Converts the film or the layers to the geometry's type. Adds what is wrong to `errors`.
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

    /// Converts the chambers, or the pressure or volume of a single film, to the geometry's type. Adds what is wrong to
    /// `errors`.
    fn chambers(&self, errors: &mut Vec<FieldError>) -> Vec<geometry::Chamber> {
        if self.layers.is_none() {
            if !self.chambers.is_empty() {
                let detail = "is not allowed without layers: below a single film it is its pressure or volume";
                errors.push(FieldError::new("/chambers", detail));
            }
            let holds = self.pressure.map(|pressure| geometry::Pressure::Constant(pressure.get()));
            let holds = holds.or(self.volume.map(|volume| geometry::Pressure::Volume(volume.get())));
            return holds.map(|holds| geometry::Chamber { below: 0, holds }).into_iter().collect();
        }
        for (name, given) in [("pressure", self.pressure.is_some()), ("volume", self.volume.is_some())] {
            if given {
                let detail = "is not allowed with layers: each of chambers has its own";
                errors.push(FieldError::new(format!("/{name}"), detail));
            }
        }
        let mut chambers = Vec::with_capacity(self.chambers.len());
        for (k, chamber) in self.chambers.iter().enumerate() {
            let holds = match (chamber.pressure, chamber.volume) {
                (Some(pressure), None) => geometry::Pressure::Constant(pressure.get()),
                (None, Some(volume)) => geometry::Pressure::Volume(volume.get()),
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
        let resolution = Resolution::or_default(self.resolution, common::count(&self.boundaries));
        let cables = self.cables.iter().enumerate().map(|(k, cable)| cable.to_geometry(k));
        let masts = self.masts.iter().enumerate().map(|(k, mast)| mast.to_geometry(k));
        let structure = geometry::Structure {
            boundaries: common::polylines(&self.boundaries),
            layers,
            // The masts follow the cables.
            cables: cables.chain(masts).collect(),
            across_ends: Vec::new(),
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
        (
            structure,
            geometry::Options {
                resolution,
                tolerance: self.tolerance.get(),
                max_iterations: self.max_iterations.map(Whole::get),
            },
        )
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
        options: Vec::new(),
    }]
}
