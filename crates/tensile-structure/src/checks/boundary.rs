//! Checks of cables, sliding supports and rings, which occupy parts of the boundaries.

use super::requirement::{COORDINATE, UNIT_VECTOR, is_usable, require};
use crate::options::{
    BoundaryPoint, Cable, CableMode, Course, FilmPrestress, FilmStress, Ring, Sliding, SlidingPart, Structure,
    cable_place, chord, stretch,
};
use plateau_mesh::error::InputError;
use plateau_mesh::polyline::{self, merge_near_neighbours};
use plateau_mesh::{DVec3, Place};

/// A cable's length must exceed the chord by more than this fraction. With a smaller excess the cable's force would be
/// more than 6,000 times the film's tension times the chord, because an arc of radius F / σ is that flat.
const LEAST_EXCESS: f64 = 1e-9;

pub(super) fn check_cable(
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
    if check_course(structure, k, cable, taken, errors) {
        check_mode(structure, k, cable, errors);
    }
}

/// Checks where a cable runs, and marks its segments of the boundary in `taken`. Returns false if the course is
/// refused, so that the cable's mode cannot be checked against it.
fn check_course(
    structure: &Structure,
    k: usize,
    cable: &Cable,
    taken: &mut [Vec<Option<usize>>],
    errors: &mut Vec<InputError>,
) -> bool {
    let place = || cable_place(structure, k);
    match &cable.course {
        Course::Boundary { boundary, from, to } => {
            let along = || place().then("along");
            let Some(points) = structure.boundaries.get(*boundary) else {
                let detail = format!("there are {} boundaries, numbered from 0", structure.boundaries.len());
                errors.push(InputError::new(along().then("boundary"), detail));
                return false;
            };
            for (name, point) in [("from", *from), ("to", *to)] {
                if point >= points.len() {
                    let detail = format!("the boundary has {} points, numbered from 0", points.len());
                    errors.push(InputError::new(along().then(name), detail));
                    return false;
                }
            }
            let merged = merge_near_neighbours(points, true);
            if merged.vertex_of[*from] == merged.vertex_of[*to] {
                errors
                    .push(InputError::new(along().then("to"), "must be another point than the one at which it begins"));
                return false;
            }
            for segment in stretch(points.len(), *from, *to) {
                let owner = &mut taken[*boundary][segment];
                if let Some(other) = *owner {
                    let detail = format!("runs along a part of the boundary on which cable {other} runs already");
                    errors.push(InputError::new(along(), detail));
                    return false;
                }
                *owner = Some(k);
            }
        }
        Course::Across(points) => {
            if structure.layers.len() > 1 {
                let detail = "is not offered for several layers: a cable runs along a boundary or in the air";
                errors.push(InputError::new(place().then("across"), detail));
                return false;
            }
            for (i, point) in points.iter().enumerate() {
                require(errors, is_usable(*point), place().then("across").at(i), COORDINATE);
            }
            if points.len() < 2 || points[0] == points[points.len() - 1] {
                errors.push(InputError::new(place().then("across"), "needs two distinct ends"));
                return false;
            }
            for i in [0, points.len() - 1] {
                let detail = "must be a point of the boundaries or lie on one of their segments";
                let on_segments = structure.across_ends.iter().map(|end| end.place);
                let found = structure.boundaries.iter().flatten().copied().chain(on_segments).any(|p| p == points[i]);
                require(errors, found, place().then("across").at(i), detail);
            }
        }
        Course::Air(ends) | Course::Mast(ends) => {
            for (i, end) in ends.iter().enumerate() {
                require(errors, is_usable(*end), place().then("points").at(i), COORDINATE);
            }
            if ends[0] == ends[1] {
                errors.push(InputError::new(place().then("points"), "needs two distinct points"));
                return false;
            }
        }
    }
    true
}

/// Checks that the mode is possible for the chord between the cable's ends.
fn check_mode(structure: &Structure, k: usize, cable: &Cable, errors: &mut Vec<InputError>) {
    let place = || cable_place(structure, k);
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

/// Whether an end of the cable can move: a free point, a sliding point, a joint, or a point or the hub of a ring.
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

/// Returns the segments of the boundary along which a part slides; a single point has none. Returns `None` and adds an
/// error if a point does not exist or cannot slide. The boundary has `count` points, and `name` is the field that names
/// the part.
fn slid_segments(
    structure: &Structure,
    k: usize,
    part: SlidingPart,
    name: &'static str,
    count: usize,
    errors: &mut Vec<InputError>,
) -> Option<Vec<usize>> {
    let place = || Place::field("supports").at(k);
    let exists = |point: usize, field: &'static str, errors: &mut Vec<InputError>| {
        let detail = format!("the boundary has {count} points, numbered from 0");
        require(errors, point < count, place().then(name).then(field), &detail);
        point < count
    };
    match part {
        SlidingPart::Edge { from, to, .. } => {
            if !exists(from, "from", errors) || !exists(to, "to", errors) {
                return None;
            }
            if from == to {
                let detail = "must be another point than the one at which the edge begins";
                errors.push(InputError::new(place().then(name).then("to"), detail));
                return None;
            }
            Some(stretch(count, from, to).collect())
        }
        SlidingPart::Boundary(_) => Some((0..count).collect()),
        SlidingPart::Point(BoundaryPoint { boundary, point }) => {
            if !exists(point, "point", errors) {
                return None;
            }
            let inside = |cable: &Cable| match cable.course {
                Course::Boundary { boundary: own, from, to } => {
                    own == boundary && stretch(count, from, to).skip(1).any(|inner| inner == point)
                }
                Course::Across(_) | Course::Air(_) | Course::Mast(_) => false,
            };
            if structure.cables.iter().any(inside) {
                errors.push(InputError::new(place().then(name), "lies inside the stretch of a cable"));
                return None;
            }
            Some(Vec::new())
        }
    }
}

pub(super) fn check_sliding(
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
    let Some(segments) = slid_segments(structure, k, sliding.part, name, points.len(), errors) else { return };
    if !matches!(sliding.part, SlidingPart::Point(_)) {
        let detail = "an edge slides on a plane, a sphere or a cylinder; only a point slides on a line or a circle";
        require(errors, sliding.on.dimension() == 2, place().then("on"), detail);
    }
    if !sliding.on.is_sound() {
        let detail = "needs directions and axes with a length, and a radius above 0";
        errors.push(InputError::new(place().then("on"), detail));
        return;
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
    let sliders: Vec<usize> = match sliding.part {
        SlidingPart::Edge { .. } => segments.into_iter().skip(1).collect(),
        SlidingPart::Boundary(_) => segments,
        SlidingPart::Point(point) => vec![point.point],
    };
    check_distances(structure, k, boundary, &sliders, errors);
}

/// Checks that points of a boundary lie on the support on which they slide.
fn check_distances(structure: &Structure, k: usize, boundary: usize, sliders: &[usize], errors: &mut Vec<InputError>) {
    let (sliding, points) = (&structure.sliding[k], &structure.boundaries[boundary]);
    let all: Vec<DVec3> = structure.boundaries.iter().flatten().copied().collect();
    let allowed = ON_SUPPORT * polyline::radius(&all);
    for &point in sliders {
        let place = || Place::field("boundaries").at(boundary).at(point);
        if let Some(extent) = sliding.on.extent() {
            // The distance is NaN if a coordinate of the point is not a number.
            let distance = extent.distance(points[point]);
            if distance.is_nan() || distance > extent.rounding() {
                let detail = format!(
                    "lies {distance:.6} away from the mesh of support {k}, on which it slides, more than the mesh's \
                     rounding ({:.6})",
                    extent.rounding()
                );
                errors.push(InputError::new(place(), detail));
            } else if extent.pieces_near(points[point]) > MOST_NEAR {
                let detail = format!(
                    "reaches more than {MOST_NEAR} triangles from point {point} of boundary {boundary}; make it \
                     smaller, or the mesh coarser"
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

/// Maximum number of triangles of a support's mesh within the mesh's rounding of a sliding point, because every step
/// visits all of them. With a rounding of two to three edge lengths there are about fifty.
const MOST_NEAR: usize = 2000;

fn check_contact_angle(
    structure: &Structure,
    sliding: &Sliding,
    angle: f64,
    place: &Place,
    errors: &mut Vec<InputError>,
) {
    let closed_form = sliding.on.area_beside(&[]).is_some();
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

pub(super) fn check_ring(
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
