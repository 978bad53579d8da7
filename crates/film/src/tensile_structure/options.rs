//! A tensile structure as the caller describes it, and the checks that need no mesh.

use crate::equilibrium::Support;
use crate::minimal_surface::Resolution;
use plateau_mesh::error::InputError;
use plateau_mesh::polyline::{self, merge_near_neighbours};
use plateau_mesh::{DVec3, Error, Place};

/// A film with its cables, loads and supports.
///
/// Every point of the boundaries is a support unless it lies strictly inside the stretch of a cable or is one of
/// [`free_points`](Self::free_points). The segments between supports without a cable are supports, too.
#[derive(Clone, Debug, PartialEq)]
pub struct Structure {
    /// Closed polygons that do not repeat their first point: the edges of the film before form finding.
    pub boundaries: Vec<Vec<DVec3>>,
    /// The films over the boundaries, which share their edges: the first on the side from which the first boundary runs
    /// counter-clockwise, each next one behind it. Usually one.
    pub layers: Vec<FilmStress>,
    /// Cables along the boundaries and in the air.
    pub cables: Vec<Cable>,
    /// Points of the boundaries at which cables end and which no support holds.
    pub free_points: Vec<BoundaryPoint>,
    /// Supports on which points or edges slide without friction.
    pub sliding: Vec<Sliding>,
    /// Boundaries that are rigid rings and move along an axis.
    pub rings: Vec<Ring>,
    /// Points in the air at which cables and masts end and which no support holds.
    pub joints: Vec<DVec3>,
    /// The closed spaces behind layers. Every space between two layers is one, or the layers would touch.
    pub chambers: Vec<Chamber>,
    /// The unit vector that points up. Weights pull against it.
    pub up: DVec3,
}

/// The stress of the film and its weight.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmStress {
    /// The stress that the found shape is to have.
    pub prestress: FilmPrestress,
    /// The weight per area of the found shape.
    pub weight: f64,
}

/// The stress that a film is to have, a force per length.
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

    /// The weave of a film whose stresses differ between warp and weft.
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
    /// The field of directions.
    pub direction: WarpDirection,
    /// What the two stresses hold constant.
    pub hold: WeaveHold,
}

/// A field of directions in space. The film's warp is its projection onto the film.
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

/// What the stresses of warp and weft hold constant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WeaveHold {
    /// Their ratio. Both vary by a common factor, whose mean over the film is 1, so that the forces within the film can
    /// balance.
    #[default]
    Ratio,
    /// Their magnitudes. If these cannot be in equilibrium the found stresses deviate from them.
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

/// A support without friction: it bears forces at right angles to a surface, or across a line. Along a surface it bears
/// only what holds a given contact angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Sliding {
    /// What slides.
    pub part: SlidingPart,
    /// The line or surface on which it slides. Directions and axes are unit vectors.
    pub on: Support,
    /// The angle in radians between the film and the surface on the left of the edge's direction, as seen from the side
    /// to which the surface's normal points ([`Contact`](crate::equilibrium::Contact)). `None` stands for a right angle.
    pub contact_angle: Option<f64>,
}

/// The part of a boundary that slides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlidingPart {
    /// The edge from one point of a boundary to another, in the boundary's direction, without the two points.
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
    /// One point.
    Point(BoundaryPoint),
}

/// A boundary that is a rigid ring, guided along an axis without friction. It bears every other force and turns
/// nowhere.
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
    /// The number of the layer.
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
    /// The name in requests.
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

    /// The weave of the film, which is its only layer then.
    #[must_use]
    pub fn weave(&self) -> Option<&Weave> {
        self.layers.first().and_then(FilmStress::weave)
    }

    /// Whether a layer has a weight.
    #[must_use]
    pub fn has_heavy_layers(&self) -> bool {
        self.layers.iter().any(|layer| layer.weight > 0.0)
    }
}

/// A cable or a mast.
#[derive(Clone, Debug, PartialEq)]
pub struct Cable {
    /// The name in messages.
    pub name: String,
    /// Where the cable runs.
    pub course: Course,
    /// What the cable holds constant.
    pub mode: CableMode,
    /// EA, a force. It is needed for [`CableMode::UnstressedLength`]; otherwise it gives the unstressed length.
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
    /// boundaries.
    Across(Vec<DVec3>),
    /// In the air, from the first point to the second. A point that equals a boundary's point, a joint or the hub of a
    /// ring is joined to it; any other is a support.
    Air([DVec3; 2]),
    /// A mast between two points in the air, joined like a cable. It is straight and may push. Its mode is
    /// [`CableMode::Force`], with the force with which it pushes, or [`CableMode::Length`].
    Mast([DVec3; 2]),
}

impl Course {
    /// The two ends of a cable or a mast in the air.
    #[must_use]
    pub fn ends_in_the_air(&self) -> Option<[DVec3; 2]> {
        match self {
            Self::Boundary { .. } | Self::Across(_) => None,
            Self::Air(ends) | Self::Mast(ends) => Some(*ends),
        }
    }

    /// Whether it is a mast.
    #[must_use]
    pub fn is_mast(&self) -> bool {
        matches!(self, Self::Mast(_))
    }
}

/// What a cable holds constant. Lengths and forces are those of the whole cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CableMode {
    /// The (mean) force.
    Force(f64),
    /// The force at the first end.
    EndTension(f64),
    /// The part of the force at the first end that is across the vertical.
    HorizontalComponent(f64),
    /// The force divided by the length.
    ForceDensity(f64),
    /// The length.
    Length(f64),
    /// The length without force; needs the axial stiffness.
    UnstressedLength(f64),
    /// The largest distance from the chord between the ends.
    Sag(f64),
}

impl CableMode {
    /// The name in requests.
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

    /// The value that is held.
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
    /// How fine the mesh of the film is to be.
    pub resolution: Resolution,
    /// The residual at which the shape counts as found.
    pub tolerance: f64,
    /// Largest number of linear solves. `None` stands for 400.
    pub max_iterations: Option<u32>,
}

impl Options {
    /// The default options at a resolution.
    #[must_use]
    pub fn new(resolution: Resolution) -> Self {
        Self { resolution, tolerance: 1e-8, max_iterations: None }
    }
}

/// A length counts as longer than a chord from this ratio on: at a smaller one the force would exceed the film's
/// tension times the chord by a factor of more than 10,000.
const LEAST_EXCESS: f64 = 1e-9;

const COORDINATE: &str = "every coordinate must be a finite number of magnitude at most 1e50";

fn is_usable(point: DVec3) -> bool {
    point.is_finite() && point.abs().max_element() <= polyline::LARGEST_COORDINATE
}

/// The place of a cable or a mast in a request, which lists the masts apart.
pub(super) fn cable_place(structure: &Structure, k: usize) -> Place {
    let is_mast = structure.cables[k].course.is_mast();
    let before = structure.cables[..k].iter().filter(|cable| cable.course.is_mast() == is_mast).count();
    Place::field(if is_mast { "masts" } else { "cables" }).at(before)
}

/// The place of a layer in a request, where a single one is the film.
pub(super) fn layer_place(structure: &Structure, k: usize) -> Place {
    if structure.layers.len() > 1 { Place::field("layers").at(k) } else { Place::field("film") }
}

/// The place of what holds the pressure in a chamber. That of a single film stands in the request itself.
pub(super) fn chamber_place(structure: &Structure, k: usize) -> Place {
    let name = structure.chambers[k].holds.name();
    if structure.layers.len() > 1 { Place::field("chambers").at(k).then(name) } else { Place::field(name) }
}

/// The chord of a cable before form finding, if its course is in range.
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

/// The segments of a boundary from one point to another, by the number of their first point.
fn stretch(count: usize, from: usize, to: usize) -> impl Iterator<Item = usize> {
    (0..(to + count - from) % count).map(move |k| (from + k) % count)
}

fn require(errors: &mut Vec<InputError>, holds: bool, place: Place, detail: &str) {
    if !holds {
        errors.push(InputError::new(place, detail));
    }
}

/// Checks what needs no mesh. The boundaries themselves are checked by the minimal surface that they span.
pub(super) fn check(structure: &Structure, options: &Options) -> Result<(), Error> {
    let mut errors = Vec::new();
    let positive = |value: f64| value.is_finite() && value > 0.0;
    let not_negative = |value: f64| value.is_finite() && value >= 0.0;
    let above = "must be a finite number above 0";
    let several = structure.layers.len() > 1;
    require(&mut errors, !structure.layers.is_empty(), Place::field("layers"), "needs one film or more");
    for (k, layer) in structure.layers.iter().enumerate() {
        let film = || layer_place(structure, k);
        match &layer.prestress {
            FilmPrestress::Isotropic(tension) => {
                require(&mut errors, positive(*tension), film().then("tension"), above);
            }
            FilmPrestress::Woven(_) if several => {
                let detail = "is not offered for several layers, which have one tension in all directions each";
                errors.push(InputError::new(film().then("warp"), detail));
            }
            FilmPrestress::Woven(weave) => check_weave(weave, &mut errors),
        }
        require(
            &mut errors,
            not_negative(layer.weight),
            film().then("weight"),
            "must be a finite number, not negative",
        );
    }
    require(
        &mut errors,
        not_negative(options.tolerance),
        Place::field("tolerance"),
        "must be a finite number, not negative",
    );
    let mut taken: Vec<Vec<Option<usize>>> =
        structure.boundaries.iter().map(|boundary| vec![None; boundary.len()]).collect();
    for (k, cable) in structure.cables.iter().enumerate() {
        check_cable(structure, k, cable, &mut taken, &mut errors);
    }
    for (k, sliding) in structure.sliding.iter().enumerate() {
        check_sliding(structure, k, sliding, &mut taken, &mut errors);
    }
    for (k, ring) in structure.rings.iter().enumerate() {
        check_ring(structure, k, ring, &mut taken, &mut errors);
    }
    check_joints(structure, &mut errors);
    check_free_points(structure, &mut errors);
    if errors.is_empty() {
        check_chambers(structure, &mut errors);
        check_supports(structure, &mut errors);
    }
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

/// Largest ratio of the stresses of warp and weft, either way. Fabrics are prestressed by ratios up to about 5. From
/// about 100 on the film is nearly a sheaf of threads, and the rounds of form finding end above the tolerance.
const MOST_UNEQUAL: f64 = 100.0;

fn check_weave(weave: &Weave, errors: &mut Vec<InputError>) {
    let film = || Place::field("film");
    let positive = |value: f64| value.is_finite() && value > 0.0;
    for (name, value) in [("warp", weave.warp), ("weft", weave.weft)] {
        require(errors, positive(value), film().then(name), "must be a finite number above 0");
    }
    let ratio = weave.weft / weave.warp;
    if positive(weave.warp) && positive(weave.weft) && !(1.0 / MOST_UNEQUAL..=MOST_UNEQUAL).contains(&ratio) {
        let detail = format!("must be between 1/{MOST_UNEQUAL} and {MOST_UNEQUAL} times the warp's stress");
        errors.push(InputError::new(film().then("weft"), detail));
    }
    let direction = || film().then("direction");
    match &weave.direction {
        WarpDirection::Radial { point, axis } => {
            require(errors, is_usable(*point), direction().then("radial").then("point"), COORDINATE);
            require(errors, axis.is_normalized(), direction().then("radial").then("axis"), UNIT_VECTOR);
        }
        WarpDirection::Parallel(vector) => {
            require(errors, vector.is_normalized(), direction().then("parallel"), UNIT_VECTOR);
        }
        WarpDirection::Along(points) => {
            for (k, point) in points.iter().enumerate() {
                require(errors, is_usable(*point), direction().then("along").at(k), COORDINATE);
            }
            let distinct = points.len() >= 2 && points.windows(2).all(|pair| pair[0] != pair[1]);
            let detail = "needs two or more points, of which no neighbours are equal";
            require(errors, distinct, direction().then("along"), detail);
        }
    }
}

const UNIT_VECTOR: &str = "must be a vector with a length";

fn check_cable(
    structure: &Structure,
    k: usize,
    cable: &Cable,
    taken: &mut [Vec<Option<usize>>],
    errors: &mut Vec<InputError>,
) {
    let place = || cable_place(structure, k);
    let value = cable.mode.value();
    require(errors, value.is_finite() && value > 0.0, place().then("value"), "must be a finite number above 0");
    require(
        errors,
        cable.weight.is_finite() && cable.weight >= 0.0,
        place().then("weight"),
        "must be a finite number, not negative",
    );
    if let Some(stiffness) = cable.axial_stiffness {
        let sound = stiffness.is_finite() && stiffness > 0.0;
        require(errors, sound, place().then("axial_stiffness"), "must be a finite number above 0");
    } else if matches!(cable.mode, CableMode::UnstressedLength(_)) {
        let detail = "is required with the mode unstressed_length, because the force follows from it";
        errors.push(InputError::new(place().then("axial_stiffness"), detail));
    }
    if cable.course.is_mast() && !matches!(cable.mode, CableMode::Force(_) | CableMode::Length(_)) {
        errors.push(InputError::new(place().then("mode"), "a mast has the mode force or length"));
    }
    match &cable.course {
        Course::Boundary { boundary, from, to } => {
            let along = || place().then("along");
            let Some(points) = structure.boundaries.get(*boundary) else {
                let detail = format!("there are {} boundaries, numbered from 0", structure.boundaries.len());
                errors.push(InputError::new(along().then("boundary"), detail));
                return;
            };
            for (name, point) in [("from", *from), ("to", *to)] {
                if point >= points.len() {
                    let detail = format!("the boundary has {} points, numbered from 0", points.len());
                    errors.push(InputError::new(along().then(name), detail));
                    return;
                }
            }
            let merged = merge_near_neighbours(points, true);
            if merged.vertex_of[*from] == merged.vertex_of[*to] {
                errors
                    .push(InputError::new(along().then("to"), "must be another point than the one at which it begins"));
                return;
            }
            for segment in stretch(points.len(), *from, *to) {
                let owner = &mut taken[*boundary][segment];
                if let Some(other) = *owner {
                    let detail = format!("runs along a part of the boundary on which cable {other} runs already");
                    errors.push(InputError::new(along(), detail));
                    return;
                }
                *owner = Some(k);
            }
        }
        Course::Across(points) => {
            if structure.layers.len() > 1 {
                let detail = "is not offered for several layers: a cable runs along a boundary or in the air";
                errors.push(InputError::new(place().then("across"), detail));
                return;
            }
            for (i, point) in points.iter().enumerate() {
                require(errors, is_usable(*point), place().then("across").at(i), COORDINATE);
            }
            if points.len() < 2 || points[0] == points[points.len() - 1] {
                errors.push(InputError::new(place().then("across"), "needs two distinct ends"));
                return;
            }
            for i in [0, points.len() - 1] {
                let detail = "must be a point of the boundaries, at exactly its coordinates";
                let found = structure.boundaries.iter().flatten().any(|p| *p == points[i]);
                require(errors, found, place().then("across").at(i), detail);
            }
        }
        Course::Air(ends) | Course::Mast(ends) => {
            for (i, end) in ends.iter().enumerate() {
                require(errors, is_usable(*end), place().then("points").at(i), COORDINATE);
            }
            if ends[0] == ends[1] {
                errors.push(InputError::new(place().then("points"), "needs two distinct points"));
                return;
            }
        }
    }
    let Some(chord) = chord(structure, cable) else { return };
    if ends_freely(structure, cable) {
        return;
    }
    if cable.course.is_mast() {
        let detail = "both ends are supports, so that the mast bears no force of the structure; at least one end must \
                      be a joint, the hub of a ring, a free point or a point that slides";
        errors.push(InputError::new(place().then("points"), detail));
        return;
    }
    let straight = matches!(cable.course, Course::Air(_)) && cable.weight == 0.0;
    let detail = match cable.mode {
        CableMode::Length(length) if length <= chord * (1.0 + LEAST_EXCESS) => {
            format!("must be longer than the chord between the cable's ends ({chord:.6})")
        }
        CableMode::Length(_) | CableMode::Sag(_) if straight => {
            "a cable in the air without weight is straight, so it would be slack; give its force or its weight".into()
        }
        CableMode::UnstressedLength(length) if straight && length >= chord => {
            format!("must be shorter than the chord between the cable's ends ({chord:.6}), or the cable is slack")
        }
        _ => return,
    };
    errors.push(InputError::new(place().then("value"), detail));
}

/// Whether an end of the cable is a point that no support holds.
fn ends_freely(structure: &Structure, cable: &Cable) -> bool {
    let position = |free: &BoundaryPoint| structure.boundaries.get(free.boundary)?.get(free.point).copied();
    let sliding = |sliding: &Sliding| match sliding.part {
        SlidingPart::Point(point) => position(&point),
        SlidingPart::Edge { .. } | SlidingPart::Boundary(_) => None,
    };
    let mut free: Vec<DVec3> = structure.free_points.iter().filter_map(position).collect();
    free.extend(structure.sliding.iter().filter_map(sliding));
    free.extend(structure.joints.iter().chain(structure.rings.iter().filter_map(|ring| ring.hub.as_ref())));
    for ring in &structure.rings {
        free.extend(structure.boundaries.get(ring.boundary).into_iter().flatten());
    }
    let ends = match &cable.course {
        Course::Boundary { boundary, from, to } => {
            let points = &structure.boundaries[*boundary];
            [points[*from], points[*to]]
        }
        Course::Across(points) => [points[0], points[points.len() - 1]],
        Course::Air(ends) | Course::Mast(ends) => *ends,
    };
    ends.iter().any(|end| free.contains(end))
}

/// Largest distance of a boundary's point from the surface on which it slides, as a fraction of the boundaries' radius.
const ON_SUPPORT: f64 = 1e-9;

fn check_sliding(
    structure: &Structure,
    k: usize,
    sliding: &Sliding,
    taken: &mut [Vec<Option<usize>>],
    errors: &mut Vec<InputError>,
) {
    let place = || Place::field("supports").at(k);
    let (name, boundary) = match sliding.part {
        SlidingPart::Edge { boundary, .. } => ("along", boundary),
        SlidingPart::Boundary(boundary) => ("boundary", boundary),
        SlidingPart::Point(point) => ("point", point.boundary),
    };
    let Some(points) = structure.boundaries.get(boundary) else {
        let detail = format!("there are {} boundaries, numbered from 0", structure.boundaries.len());
        let inside = if name == "boundary" { place().then(name) } else { place().then(name).then("boundary") };
        errors.push(InputError::new(inside, detail));
        return;
    };
    let count = points.len();
    let exists = |point: usize, field: &'static str, errors: &mut Vec<InputError>| {
        let detail = format!("the boundary has {count} points, numbered from 0");
        require(errors, point < count, place().then(name).then(field), &detail);
        point < count
    };
    let segments: Vec<usize> = match sliding.part {
        SlidingPart::Edge { from, to, .. } => {
            if !exists(from, "from", errors) || !exists(to, "to", errors) {
                return;
            }
            if from == to {
                let detail = "must be another point than the one at which the edge begins";
                errors.push(InputError::new(place().then(name).then("to"), detail));
                return;
            }
            stretch(count, from, to).collect()
        }
        SlidingPart::Boundary(_) => (0..count).collect(),
        SlidingPart::Point(BoundaryPoint { point, .. }) => {
            if !exists(point, "point", errors) {
                return;
            }
            let inside = |cable: &Cable| match cable.course {
                Course::Boundary { boundary: own, from, to } => {
                    own == boundary && stretch(count, from, to).skip(1).any(|inner| inner == point)
                }
                Course::Across(_) | Course::Air(_) | Course::Mast(_) => false,
            };
            if structure.cables.iter().any(inside) {
                errors.push(InputError::new(place().then(name), "lies inside the stretch of a cable"));
                return;
            }
            Vec::new()
        }
    };
    if !matches!(sliding.part, SlidingPart::Point(_)) {
        let detail = "an edge slides on a plane, a sphere or a cylinder; only a point slides on a line or a circle";
        require(errors, sliding.on.dimension() == 2, place().then("on"), detail);
    }
    if let Some(angle) = sliding.contact_angle {
        check_contact_angle(structure, sliding, angle, &place().then("contact_angle_deg"), errors);
    }
    for &segment in &segments {
        if taken[boundary][segment].replace(usize::MAX).is_some() {
            let detail = "runs along a part of the boundary on which a cable or another support runs already";
            errors.push(InputError::new(place().then(name), detail));
            return;
        }
    }
    let all: Vec<DVec3> = structure.boundaries.iter().flatten().copied().collect();
    let allowed = ON_SUPPORT * polyline::radius(&all);
    let sliders: Vec<usize> = match sliding.part {
        SlidingPart::Edge { .. } => segments.into_iter().skip(1).collect(),
        SlidingPart::Boundary(_) => segments,
        SlidingPart::Point(point) => vec![point.point],
    };
    for point in sliders {
        let place = || Place::field("boundaries").at(boundary).at(point);
        if let Support::Mesh { surface, origin } = &sliding.on {
            // The distance of a point with coordinates that are no numbers is none either.
            let distance = surface.distance(points[point] - origin);
            if distance.is_nan() || distance > surface.rounding() {
                let detail = format!(
                    "lies {distance:.6} away from the mesh of support {k}, on which it slides, more than the mesh's \
                     rounding ({:.6})",
                    surface.rounding()
                );
                errors.push(InputError::new(place(), detail));
            } else if surface.triangles_near(points[point] - origin) > MOST_NEAR {
                let detail = format!(
                    "reaches more than {MOST_NEAR} triangles from point {point} of boundary {boundary}; make it smaller, \
                     or the mesh coarser"
                );
                errors.push(InputError::new(
                    Place::field("supports").at(k).then("on").then("mesh").then("rounding"),
                    detail,
                ));
                return;
            }
        } else if sliding.on.nearest(points[point]).distance(points[point]) > allowed {
            let detail = format!("does not lie on the surface of support {k}, on which it slides");
            errors.push(InputError::new(place(), detail));
        }
    }
}

/// Largest number of triangles of a mesh within its rounding of a point that slides on it. All of them are looked at in
/// every step; with two to three lengths of an edge as the rounding there are about fifty.
const MOST_NEAR: usize = 2000;

fn check_contact_angle(
    structure: &Structure,
    sliding: &Sliding,
    angle: f64,
    place: &Place,
    errors: &mut Vec<InputError>,
) {
    let closed_form = matches!(sliding.on, Support::Plane { .. } | Support::Sphere { .. } | Support::Cylinder { .. });
    let one_tension =
        matches!(structure.layers[..], [FilmStress { prestress: FilmPrestress::Isotropic(_), weight: 0.0 }]);
    let is_edge = !matches!(sliding.part, SlidingPart::Point(_));
    let refusals = [
        (angle > 0.0 && angle < std::f64::consts::PI, "must be above 0 and below 180 degrees"),
        (is_edge, "is offered for an edge or a boundary; a point has no angle"),
        (closed_form, "is offered on a plane, a sphere or a cylinder; an edge meets other supports at a right angle"),
        (one_tension, "is offered for a single film of one tension in all directions and without weight"),
    ];
    if let Some((_, detail)) = refusals.into_iter().find(|(holds, _)| !holds) {
        errors.push(InputError::new(place.clone(), detail));
    }
}

fn check_ring(
    structure: &Structure,
    k: usize,
    ring: &Ring,
    taken: &mut [Vec<Option<usize>>],
    errors: &mut Vec<InputError>,
) {
    let place = || Place::field("rings").at(k);
    let Some(segments) = taken.get_mut(ring.boundary) else {
        let detail = format!("there are {} boundaries, numbered from 0", structure.boundaries.len());
        errors.push(InputError::new(place().then("boundary"), detail));
        return;
    };
    let is_taken = segments.iter().any(Option::is_some);
    segments.fill(Some(usize::MAX));
    let slides =
        |sliding: &Sliding| matches!(sliding.part, SlidingPart::Point(point) if point.boundary == ring.boundary);
    let free = structure.free_points.iter().any(|point| point.boundary == ring.boundary);
    let detail = "a cable, a support, a free point or another ring is on this boundary already";
    let alone = !is_taken && !free && !structure.sliding.iter().any(slides);
    require(errors, alone, place().then("boundary"), detail);
    require(errors, ring.axis.is_normalized(), place().then("axis"), UNIT_VECTOR);
    require(errors, ring.force.is_finite(), place().then("force"), "must be a finite number");
    if let Some(hub) = ring.hub {
        require(errors, is_usable(hub), place().then("hub"), COORDINATE);
        let boundaries = structure.boundaries.iter().flatten();
        let apart = boundaries.chain(&structure.joints).all(|point| *point != hub)
            && structure.rings[..k].iter().all(|other| other.hub != Some(hub));
        let detail = "must be another point than those of boundaries, joints and other hubs";
        require(errors, apart, place().then("hub"), detail);
    }
}

/// Fewest cables and masts that can hold a joint: one mast between two cables, or three cables.
const FEWEST_AT_JOINT: usize = 2;

fn check_joints(structure: &Structure, errors: &mut Vec<InputError>) {
    for (k, joint) in structure.joints.iter().enumerate() {
        let place = || Place::field("joints").at(k);
        if !is_usable(*joint) {
            errors.push(InputError::new(place(), COORDINATE));
            continue;
        }
        let boundaries = structure.boundaries.iter().flatten();
        if boundaries.chain(&structure.joints[..k]).any(|point| point == joint) {
            errors.push(InputError::new(place(), "must be another point than those of boundaries and other joints"));
            continue;
        }
        let ends = |cable: &&Cable| cable.course.ends_in_the_air().is_some_and(|ends| ends.contains(joint));
        let detail = format!(
            "moves freely: {FEWEST_AT_JOINT} or more cables or masts must end at a joint, at exactly its coordinates"
        );
        require(errors, structure.cables.iter().filter(ends).count() >= FEWEST_AT_JOINT, place(), &detail);
    }
}

fn check_free_points(structure: &Structure, errors: &mut Vec<InputError>) {
    for (k, free) in structure.free_points.iter().enumerate() {
        let place = || Place::field("free_points").at(k);
        let Some(points) = structure.boundaries.get(free.boundary) else {
            let detail = format!("there are {} boundaries, numbered from 0", structure.boundaries.len());
            errors.push(InputError::new(place().then("boundary"), detail));
            continue;
        };
        if free.point >= points.len() {
            let detail = format!("the boundary has {} points, numbered from 0", points.len());
            errors.push(InputError::new(place().then("point"), detail));
            continue;
        }
        let on =
            |cable: &&Cable| matches!(cable.course, Course::Boundary { boundary, .. } if boundary == free.boundary);
        let ends = |cable: &Cable, last: bool| match cable.course {
            Course::Boundary { from, to, .. } => (if last { to } else { from }) == free.point,
            Course::Across(_) | Course::Air(_) | Course::Mast(_) => false,
        };
        let mut cables = structure.cables.iter().filter(on);
        let (arrives, leaves) = (cables.clone().any(|cable| ends(cable, true)), cables.any(|cable| ends(cable, false)));
        let detail = "a free point needs a boundary cable on both of its sides";
        require(errors, arrives && leaves, place(), detail);
    }
}

fn check_chambers(structure: &Structure, errors: &mut Vec<InputError>) {
    let last = structure.layers.len() - 1;
    let before = errors.len();
    for (k, chamber) in structure.chambers.iter().enumerate() {
        let below = || Place::field("chambers").at(k).then("below");
        if chamber.below > last {
            let detail = format!("there are {} layers, numbered from 0", structure.layers.len());
            errors.push(InputError::new(below(), detail));
            continue;
        }
        let same = structure.chambers[..k].iter().position(|other| other.below == chamber.below);
        if let Some(other) = same {
            let detail = format!("is the layer of chamber {other}: there is one space below each layer");
            errors.push(InputError::new(below(), detail));
            continue;
        }
        check_chamber(structure, k, errors);
    }
    for layer in 0..last {
        if !structure.chambers.iter().any(|chamber| chamber.below == layer) {
            let detail = format!("needs one below layer {layer}: without it layers {layer} and {} touch", layer + 1);
            errors.push(InputError::new(Place::field("chambers"), detail));
        }
    }
    if errors.len() == before {
        check_pressures(structure, errors);
    }
}

fn check_chamber(structure: &Structure, k: usize, errors: &mut Vec<InputError>) {
    let Chamber { below, holds } = structure.chambers[k];
    let place = || chamber_place(structure, k);
    let (Pressure::Constant(value) | Pressure::Volume(value)) = holds;
    if !value.is_finite() {
        errors.push(InputError::new(place(), "must be a finite number"));
        return;
    }
    // Two layers close the space between them wherever their common edge is.
    if below + 1 == structure.layers.len() {
        let hangs = structure.cables.iter().any(|cable| matches!(cable.course, Course::Boundary { .. }));
        let moving_edges = [
            (hangs, "a film whose edge hangs on a cable"),
            (!structure.sliding.is_empty(), "a film whose edge slides"),
            (!structure.rings.is_empty(), "a film with a ring that moves"),
        ];
        if let Some((_, film)) = moving_edges.into_iter().find(|(moves, _)| *moves) {
            let detail = format!("is not offered for {film}, because the space below it is not closed");
            errors.push(InputError::new(place(), detail));
            return;
        }
    }
    if let Pressure::Volume(volume) = holds {
        let detail = if structure.layers.len() > 1 {
            "must be above 0"
        } else {
            "must be above 0; reverse the first boundary to inflate the other side"
        };
        require(errors, volume > 0.0, place(), detail);
    }
}

/// The chamber below a layer; for the space in front of the first one `None`, as for one that is not closed.
fn chamber_below(structure: &Structure, layer: Option<usize>) -> Option<usize> {
    structure.chambers.iter().position(|chamber| Some(chamber.below) == layer)
}

/// The pressure below each layer less that above it, where both are known before the solve, and the chamber that it
/// follows from.
fn known_differences(structure: &Structure) -> Vec<Option<(f64, usize)>> {
    let known = |layer: Option<usize>| match chamber_below(structure, layer) {
        None => Some((0.0, None)),
        Some(k) => match structure.chambers[k].holds {
            Pressure::Constant(pressure) => Some((pressure, Some(k))),
            Pressure::Volume(_) => None,
        },
    };
    let difference = |layer: usize| {
        let ((below, own), (above, other)) = (known(Some(layer))?, known(layer.checked_sub(1))?);
        Some((below - above, own.or(other)?))
    };
    (0..structure.layers.len()).map(difference).collect()
}

/// Refuses pressures above the limits of the openings, and pressures that press one layer through another.
fn check_pressures(structure: &Structure, errors: &mut Vec<InputError>) {
    let differences = known_differences(structure);
    let before = errors.len();
    for (layer, known) in differences.iter().enumerate() {
        let Some((difference, chamber)) = *known else { continue };
        let limit = pressure_limit(structure, layer);
        let place = chamber_place(structure, chamber);
        if difference.abs() <= limit || errors.iter().any(|error| error.place == place) {
            continue;
        }
        let of_layer = if structure.layers.len() > 1 {
            format!("makes a difference of {difference:.6} between the two sides of layer {layer}, which ")
        } else {
            String::new()
        };
        let detail = format!(
            "{of_layer}is above the limit of the opening, {limit:.6}: the film's tension times the length of the \
             boundary, and the forces of the cables across the film at their ends, divided by the area that the \
             boundary encloses; no film of this tension holds more"
        );
        errors.push(InputError::new(place, detail));
    }
    if errors.len() > before {
        return;
    }
    // Of two layers without weight over the same edge the one with the larger curvature lies in front.
    for (layer, pair) in differences.windows(2).enumerate() {
        let [Some((above, chamber)), Some((below, _))] = *pair else { continue };
        let [upper, lower] = [layer, layer + 1].map(|k| &structure.layers[k]);
        if structure.has_heavy_layers() || above / upper.mean() > below / lower.mean() {
            continue;
        }
        let detail = format!(
            "presses layers {layer} and {} onto each other: the difference of the pressures on the two sides over the \
             tension must be larger for layer {layer} ({:.6}) than for the layer below it ({:.6})",
            layer + 1,
            above / upper.mean(),
            below / lower.mean()
        );
        errors.push(InputError::new(chamber_place(structure, chamber), detail));
    }
}

/// Supports count as lying on one line up to this fraction of their extent. A structure on such supports turns about
/// the line.
const COLLINEAR: f64 = 1e-9;

/// For each boundary and each of its points whether a support holds it.
fn held(structure: &Structure) -> Vec<Vec<bool>> {
    let mut held: Vec<Vec<bool>> = structure.boundaries.iter().map(|points| vec![true; points.len()]).collect();
    for cable in &structure.cables {
        if let Course::Boundary { boundary, from, to } = cable.course {
            stretch(held[boundary].len(), from, to).skip(1).for_each(|point| held[boundary][point] = false);
        }
    }
    structure.free_points.iter().for_each(|free| held[free.boundary][free.point] = false);
    structure.rings.iter().for_each(|ring| held[ring.boundary].fill(false));
    held
}

/// Refuses a mechanism: supports on one line, about which a structure without weight turns freely.
fn check_supports(structure: &Structure, errors: &mut Vec<InputError>) {
    let held = held(structure);
    let mut supports: Vec<DVec3> = Vec::new();
    for (points, held) in structure.boundaries.iter().zip(&held) {
        supports.extend(points.iter().zip(held).filter(|(_, held)| **held).map(|(point, _)| *point));
    }
    let hubs = structure.rings.iter().filter_map(|ring| ring.hub);
    let joined: Vec<DVec3> =
        structure.boundaries.iter().flatten().copied().chain(structure.joints.iter().copied()).chain(hubs).collect();
    for ends in structure.cables.iter().filter_map(|cable| cable.course.ends_in_the_air()) {
        supports.extend(ends.into_iter().filter(|end| !joined.contains(end)));
    }
    let heavy = structure.has_heavy_layers() || structure.cables.iter().any(|cable| cable.weight > 0.0);
    let first = supports.first().copied().unwrap_or_default();
    let farthest =
        supports.iter().map(|p| *p - first).fold(DVec3::ZERO, |a, b| if b.length() > a.length() { b } else { a });
    let axis = farthest.normalize_or_zero();
    let off = |p: &DVec3| (*p - first).reject_from_normalized(axis).length();
    let collinear = supports.iter().all(|p| off(p) <= COLLINEAR * farthest.length());
    if !collinear || (heavy && farthest != DVec3::ZERO) {
        return;
    }
    let detail = if farthest == DVec3::ZERO {
        "moves freely: fewer than two points are supports"
    } else {
        "moves freely: all supports lie on one line, about which the structure turns"
    };
    for (boundary, held) in held.iter().enumerate() {
        for point in (0..held.len()).filter(|&point| !held[point]) {
            errors.push(InputError::new(Place::field("boundaries").at(boundary).at(point), detail));
        }
    }
}

/// The largest pressure that a layer of constant tension can hold: the pressure on the opening's vector area is borne by
/// the tension along its perimeter and by the cables that end there, |p A| <= σ P + Σ F, with the larger of the
/// stresses of warp and weft for σ. Infinite where something that is not known before the solve bears it: several
/// boundaries, whose openings may balance each other; an edge that moves; stresses that vary along the edge, as those of
/// a heavy film do; and a cable across the film whose force at its ends is not given.
fn pressure_limit(structure: &Structure, layer: usize) -> f64 {
    let [points] = &structure.boundaries[..] else { return f64::INFINITY };
    let film = &structure.layers[layer];
    let hangs = structure.cables.iter().any(|cable| matches!(cable.course, Course::Boundary { .. }));
    if film.weight > 0.0 || hangs || !structure.sliding.is_empty() || !structure.rings.is_empty() {
        return f64::INFINITY;
    }
    let largest = match &film.prestress {
        FilmPrestress::Isotropic(tension) => *tension,
        FilmPrestress::Woven(Weave { hold: WeaveHold::Ratio, .. }) => return f64::INFINITY,
        FilmPrestress::Woven(weave) => weave.warp.max(weave.weft),
    };
    let across = structure.cables.iter().filter(|cable| matches!(cable.course, Course::Across(_)));
    let borne: f64 = across.map(|cable| forces_at_ends(structure, cable)).sum();
    let mean = polyline::mean(points);
    let next = |k: usize| points[(k + 1) % points.len()] - mean;
    let area: DVec3 = (0..points.len()).map(|k| 0.5 * (points[k] - mean).cross(next(k))).sum();
    (largest * polyline::length(points, true) + borne) / area.length()
}

/// The sum of a cable's forces at its two ends, if it is given with the mode; else infinite. A woven film pulls along
/// the cable and changes its force, by an amount that is known only with the shape.
fn forces_at_ends(structure: &Structure, cable: &Cable) -> f64 {
    if cable.weight > 0.0 || structure.weave().is_some() {
        return f64::INFINITY;
    }
    match cable.mode {
        CableMode::Force(force) | CableMode::EndTension(force) => 2.0 * force,
        CableMode::HorizontalComponent(_)
        | CableMode::ForceDensity(_)
        | CableMode::Length(_)
        | CableMode::UnstressedLength(_)
        | CableMode::Sag(_) => f64::INFINITY,
    }
}
