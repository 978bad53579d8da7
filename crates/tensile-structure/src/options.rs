//! A tensile structure as the caller describes it.

use plateau_equilibrium::Support;
use plateau_mesh::{DVec3, Place};
use plateau_minimal_surface::{Resolution, SegmentPoint};
use std::sync::Arc;

/// A film with its cables, loads and supports.
///
/// Every point of the boundaries is a support unless it lies strictly inside the stretch of a cable or is one of
/// [`free_points`](Self::free_points). The segments between supports along which no cable runs are supports, too.
/// Points of [`sliding`](Self::sliding) parts and of [`rings`](Self::rings) are held in some directions only.
#[derive(Clone, Debug)]
pub struct Structure {
    /// Closed polygons that do not repeat their first point: the edges of the film before form finding.
    pub boundaries: Vec<Vec<DVec3>>,
    /// The films over the boundaries; usually there is one. They share their edges. The first film is on the side from
    /// which the first boundary runs counter-clockwise, and each further film lies behind the one before.
    pub layers: Vec<FilmStress>,
    /// Cables and masts: along the boundaries, across the film and in the air.
    pub cables: Vec<Cable>,
    /// Points inside segments of the boundaries at which cables across the film end.
    pub across_ends: Vec<SegmentPoint>,
    /// Points of the boundaries at which cables end and which no support holds.
    pub free_points: Vec<BoundaryPoint>,
    /// Supports on which points or edges slide without friction.
    pub sliding: Vec<Sliding>,
    /// Boundaries that are rigid rings and move along an axis.
    pub rings: Vec<Ring>,
    /// Points in the air at which cables and masts end and which no support holds.
    pub joints: Vec<DVec3>,
    /// The closed spaces behind layers. Every space between two layers must be a chamber, because otherwise the layers
    /// would touch.
    pub chambers: Vec<Chamber>,
    /// The unit vector that points up. Weights pull against it.
    pub up: DVec3,
}

impl Structure {
    /// A structure with these boundaries and layers and nothing else, whose z axis points up.
    #[must_use]
    pub fn new(boundaries: Vec<Vec<DVec3>>, layers: Vec<FilmStress>) -> Self {
        Self {
            boundaries,
            layers,
            cables: Vec::new(),
            across_ends: Vec::new(),
            free_points: Vec::new(),
            sliding: Vec::new(),
            rings: Vec::new(),
            joints: Vec::new(),
            chambers: Vec::new(),
            up: DVec3::Z,
        }
    }
}

/// The stress of the film and its weight.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmStress {
    /// The required stress in the found shape.
    pub prestress: FilmPrestress,
    /// The weight per area of the found shape.
    pub weight: f64,
}

/// The required stress of a film, a force per length.
#[derive(Clone, Debug, PartialEq)]
pub enum FilmPrestress {
    /// The tension σ in every direction. It is the same at every point, apart from what the weight adds.
    Isotropic(f64),
    /// Stresses that differ between warp and weft.
    Woven(Weave),
}

impl FilmStress {
    /// The isotropic tension, or the mean of the stresses of warp and weft: the scale of the film's forces.
    #[must_use]
    pub fn mean(&self) -> f64 {
        match &self.prestress {
            FilmPrestress::Isotropic(tension) => *tension,
            FilmPrestress::Woven(weave) => 0.5 * (weave.warp + weave.weft),
        }
    }

    /// The weave of a woven film; `None` for an isotropic one.
    #[must_use]
    pub fn weave(&self) -> Option<&Weave> {
        match &self.prestress {
            FilmPrestress::Isotropic(_) => None,
            FilmPrestress::Woven(weave) => Some(weave),
        }
    }
}

/// The stresses of a woven film along its warp and its weft, which are at right angles.
#[derive(Clone, Debug, PartialEq)]
pub struct Weave {
    /// The stress along the warp, a force per length.
    pub warp: f64,
    /// The stress along the weft, a force per length.
    pub weft: f64,
    /// The field of directions of the warp.
    pub direction: WarpDirection,
    /// Whether the ratio or the magnitudes of the two stresses are prescribed.
    pub hold: WeaveHold,
}

/// A field of directions in space. At each point of the film, the warp is the projection of the direction there onto
/// the film.
#[derive(Clone, Debug, PartialEq)]
pub enum WarpDirection {
    /// The weft runs around the axis, and the warp away from it.
    Radial {
        /// A point of the axis.
        point: DVec3,
        /// Unit vector.
        axis: DVec3,
    },
    /// The warp runs along this unit vector.
    Parallel(DVec3),
    /// The warp runs along the tangent of the polyline at its nearest point.
    Along(Vec<DVec3>),
}

/// Quantity that the stresses of warp and weft hold constant. Requires `warp` and `weft`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum WeaveHold {
    /// Their ratio. Both vary by a common factor with the mean 1, so that the forces within the film can balance.
    #[default]
    Ratio,
    /// Their magnitudes. Two unequal ones cannot be in equilibrium on most shapes. The returned stresses then deviate
    /// from them, with the warning `stress_deviates`.
    Magnitudes,
}

/// A point of a boundary, by its number in the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BoundaryPoint {
    /// The number of the boundary.
    pub boundary: usize,
    /// The number of the point.
    pub point: usize,
}

/// A support without friction. It bears forces at right angles to its surface, or across its line. Along a surface it
/// bears only the force that holds a given contact angle.
#[derive(Clone, Debug)]
pub struct Sliding {
    /// The part of a boundary that slides.
    pub part: SlidingPart,
    /// The line or surface on which the part slides. Directions and axes are unit vectors.
    pub on: Arc<dyn Support>,
    /// The contact angle in radians: the angle between the film and the surface on the left of the edge's direction, as
    /// seen from the side to which the surface's normal points ([`ContactEnergy`](plateau_equilibrium::ContactEnergy)).
    /// `None` stands for a right angle.
    pub contact_angle: Option<f64>,
}

/// The part of a boundary that slides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlidingPart {
    /// The stretch of a boundary from one point to another, in the boundary's direction. The two points themselves do
    /// not slide.
    Edge {
        /// The number of the boundary.
        boundary: usize,
        /// The number of the point at which the edge begins.
        from: usize,
        /// The number of the point at which it ends.
        to: usize,
    },
    /// A whole boundary.
    Boundary(usize),
    /// A single point.
    Point(BoundaryPoint),
}

/// A boundary that is a rigid ring, guided along an axis without friction. The guide bears all forces across the axis
/// and keeps the ring from turning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// The number of the boundary.
    pub boundary: usize,
    /// The unit vector along which the ring moves.
    pub axis: DVec3,
    /// The force on the ring along the axis, from outside.
    pub force: f64,
    /// A point in the air that moves with the ring. Masts and cables may end there.
    pub hub: Option<DVec3>,
}

/// A closed space on the side of a layer that its normals point away from. The normals point to the side from which the
/// first boundary runs counter-clockwise. The space ends at the next layer; behind the last layer it ends at fans from
/// each boundary to its mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chamber {
    /// The number of the layer behind which the chamber lies.
    pub below: usize,
    /// Prescribed gauge pressure, or prescribed volume.
    pub holds: Pressure,
}

/// Prescribed gauge pressure of a chamber, or its prescribed volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pressure {
    /// This pressure, a force per area. It may be negative.
    Constant(f64),
    /// The pressure at which the chamber has this volume.
    Volume(f64),
}

impl Pressure {
    /// The name of the field in requests.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Constant(_) => "pressure",
            Self::Volume(_) => "volume",
        }
    }
}

impl Structure {
    /// The pull of all layers on an edge, a force per length: the sum of their mean stresses.
    #[must_use]
    pub fn pull(&self) -> f64 {
        self.layers.iter().map(FilmStress::mean).sum()
    }

    /// The weave of a woven film, which is the only layer of its structure.
    #[must_use]
    pub fn weave(&self) -> Option<&Weave> {
        self.layers.first().and_then(FilmStress::weave)
    }

    /// For each point of the boundaries whether it can move: inside a stretch on which a cable runs or an edge slides,
    /// a free or a sliding point, or a point of a ring. Parts whose points do not exist are left out.
    #[must_use]
    pub fn moves(&self) -> Vec<Vec<bool>> {
        let mut moves: Vec<Vec<bool>> = self.boundaries.iter().map(|points| vec![false; points.len()]).collect();
        let mut mark = |boundary: usize, part: Part| {
            let Some(own) = moves.get_mut(boundary) else { return };
            let count = own.len();
            match part {
                Part::Whole => own.fill(true),
                Part::Point(point) => own.iter_mut().skip(point).take(1).for_each(|moves| *moves = true),
                Part::Inside { from, to } if from < count && to < count => {
                    stretch(count, from, to).skip(1).for_each(|point| own[point] = true);
                }
                Part::Inside { .. } => {}
            }
        };
        for cable in &self.cables {
            if let Course::Boundary { boundary, from, to } = cable.course {
                mark(boundary, Part::Inside { from, to });
            }
        }
        self.free_points.iter().for_each(|free| mark(free.boundary, Part::Point(free.point)));
        for sliding in &self.sliding {
            match sliding.part {
                SlidingPart::Edge { boundary, from, to } => mark(boundary, Part::Inside { from, to }),
                SlidingPart::Boundary(boundary) => mark(boundary, Part::Whole),
                SlidingPart::Point(BoundaryPoint { boundary, point }) => mark(boundary, Part::Point(point)),
            }
        }
        self.rings.iter().for_each(|ring| mark(ring.boundary, Part::Whole));
        moves
    }

    /// Whether a layer has a weight.
    #[must_use]
    pub fn has_heavy_layers(&self) -> bool {
        self.layers.iter().any(|layer| layer.weight > 0.0)
    }
}

/// A part of one boundary.
enum Part {
    Whole,
    Point(usize),
    /// The points between two others.
    Inside {
        from: usize,
        to: usize,
    },
}

/// A cable or a mast.
#[derive(Clone, Debug, PartialEq)]
pub struct Cable {
    /// The name in messages.
    pub name: String,
    /// Where the cable runs.
    pub course: Course,
    /// The prescribed quantity of the cable.
    pub mode: CableMode,
    /// EA, the axial stiffness, a force. It is required for [`CableMode::UnstressedLength`]. With any other mode it
    /// only serves to report the unstressed length.
    pub axial_stiffness: Option<f64>,
    /// The weight per length of the found shape.
    pub weight: f64,
}

/// The course of a cable.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// Along a boundary in its direction, from one point to another. The film's edge hangs on the cable.
    Boundary {
        /// The number of the boundary.
        boundary: usize,
        /// The number of the point at which the cable begins.
        from: usize,
        /// The number of the point at which it ends.
        to: usize,
    },
    /// Across the film, as a ridge or a valley, through these points before form finding. Both ends are points of the
    /// boundaries, or inside segments of the boundaries and among [`across_ends`](Structure::across_ends).
    Across(Vec<DVec3>),
    /// In the air, from the first point to the second. A point that equals a boundary's point, a joint or the hub of a
    /// ring is joined to it; any other is a support.
    Air([DVec3; 2]),
    /// A mast between two points in the air, joined like a cable. It is straight and may push. Its mode is
    /// [`CableMode::Force`], with the force with which it pushes, or [`CableMode::Length`].
    Mast([DVec3; 2]),
}

impl Course {
    /// The two ends of a cable or a mast in the air; `None` for other courses.
    #[must_use]
    pub fn ends_in_the_air(&self) -> Option<[DVec3; 2]> {
        match self {
            Self::Boundary { .. } | Self::Across(_) => None,
            Self::Air(ends) | Self::Mast(ends) => Some(*ends),
        }
    }

    /// Whether this is the course of a mast.
    #[must_use]
    pub fn is_mast(&self) -> bool {
        matches!(self, Self::Mast(_))
    }
}

/// The prescribed quantity of a cable. Lengths and forces are those of the whole cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CableMode {
    /// The force. In a heavy cable it is the mean force, weighted by length.
    Force(f64),
    /// The force at the first end.
    EndTension(f64),
    /// The horizontal component of the force at the first end.
    HorizontalComponent(f64),
    /// The force divided by the length.
    ForceDensity(f64),
    /// The length in the found shape.
    Length(f64),
    /// The length without force; needs the axial stiffness.
    UnstressedLength(f64),
    /// The largest distance from the chord between the ends.
    Sag(f64),
}

impl CableMode {
    /// The name of the mode in requests.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Force(_) => "force",
            Self::EndTension(_) => "end_tension",
            Self::HorizontalComponent(_) => "horizontal_component",
            Self::ForceDensity(_) => "force_density",
            Self::Length(_) => "length",
            Self::UnstressedLength(_) => "unstressed_length",
            Self::Sag(_) => "sag",
        }
    }

    /// The prescribed value.
    #[must_use]
    pub fn value(self) -> f64 {
        match self {
            Self::Force(value)
            | Self::EndTension(value)
            | Self::HorizontalComponent(value)
            | Self::ForceDensity(value)
            | Self::Length(value)
            | Self::UnstressedLength(value)
            | Self::Sag(value) => value,
        }
    }
}

/// Options of form finding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The fineness of the film's mesh.
    pub resolution: Resolution,
    /// The residual at which the shape counts as found.
    pub tolerance: f64,
    /// Largest number of linear solves. With `None` each attempt of form finding may take 400.
    pub max_iterations: Option<u32>,
}

impl Options {
    /// The default options at a resolution.
    #[must_use]
    pub fn new(resolution: Resolution) -> Self {
        Self { resolution, tolerance: 1e-8, max_iterations: None }
    }
}

/// The place of a cable or a mast in a request, where masts are listed separately.
pub(super) fn cable_place(structure: &Structure, k: usize) -> Place {
    let is_mast = structure.cables[k].course.is_mast();
    let before = structure.cables[..k].iter().filter(|cable| cable.course.is_mast() == is_mast).count();
    Place::field(if is_mast { "masts" } else { "cables" }).at(before)
}

/// The place of a layer in a request: the field `film` for a single layer, an entry of `layers` otherwise.
pub(super) fn layer_place(structure: &Structure, k: usize) -> Place {
    if structure.layers.len() > 1 { Place::field("layers").at(k) } else { Place::field("film") }
}

/// The place in a request of the pressure or volume of a chamber; for a single film it is a field of the request
/// itself.
pub(super) fn chamber_place(structure: &Structure, k: usize) -> Place {
    let name = structure.chambers[k].holds.name();
    if structure.layers.len() > 1 { Place::field("chambers").at(k).then(name) } else { Place::field(name) }
}

/// The distance between the ends of a cable before form finding; `None` if the course refers to a boundary or a point
/// that does not exist.
pub(super) fn chord(structure: &Structure, cable: &Cable) -> Option<f64> {
    match &cable.course {
        Course::Boundary { boundary, from, to } => {
            let points = structure.boundaries.get(*boundary)?;
            Some(points.get(*from)?.distance(*points.get(*to)?))
        }
        Course::Across(points) => Some(points.first()?.distance(*points.last()?)),
        Course::Air([a, b]) | Course::Mast([a, b]) => Some(a.distance(*b)),
    }
}

/// The segments of a boundary with `count` points from one point to another. Each segment has the number of its first
/// point.
pub(super) fn stretch(count: usize, from: usize, to: usize) -> impl Iterator<Item = usize> {
    (0..(to + count - from) % count).map(move |k| (from + k) % count)
}
