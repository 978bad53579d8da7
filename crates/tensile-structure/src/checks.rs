//! Checks of a tensile structure that need no mesh.

mod across;
mod boundary;
mod chambers;
mod requirement;

use super::options::{Cable, Course, FilmPrestress, Options, Structure, WarpDirection, Weave, layer_place, stretch};
use across::check_crossings;
use boundary::{check_cable, check_ring, check_sliding};
use chambers::check_chambers;
use plateau_mesh::error::InputError;
use plateau_mesh::plane::flatness::Flatness;
use plateau_mesh::plane::frame::Frame;
use plateau_mesh::{DVec3, Error, Place};
use requirement::{COORDINATE, UNIT_VECTOR, is_usable, require};

/// Checks the structure and the options as far as this needs no mesh. `plateau_minimal_surface::check` checks the
/// boundaries themselves.
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
    require(&mut errors, structure.up.is_normalized(), Place::field("up"), UNIT_VECTOR);
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
        check_crossings(structure, &mut errors);
        check_warp(structure, &mut errors);
        check_supports(structure, &mut errors);
    }
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

/// Largest ratio of the larger to the smaller of the stresses of warp and weft. Fabrics are prestressed with ratios up
/// to about 5. From about 100 on the film behaves almost like a bundle of parallel threads, and form finding ends above
/// the tolerance.
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

/// Least angle between the warp and the normal of a plane film, in radians. Below it the direction of the warp's
/// projection onto the film is not reliable.
const ALONG_THE_NORMAL: f64 = 0.02;

/// Refuses a warp that runs along the normal of boundaries in one plane.
fn check_warp(structure: &Structure, errors: &mut Vec<InputError>) {
    let Some(Weave { direction: WarpDirection::Parallel(warp), .. }) = structure.weave() else { return };
    let Some(outline) = structure.boundaries.first().filter(|points| points.len() > 2) else { return };
    let Some(plane) = Frame::of_loop(outline) else { return };
    let points = structure.boundaries.iter().flatten().copied();
    if matches!(Flatness::of(points, outline, &plane), Flatness::Bent(_)) {
        return;
    }
    let detail = "has no projection on this film: the boundaries lie in a plane, and the warp runs along its normal";
    require(
        errors,
        warp.cross(plane.normal).length() > ALONG_THE_NORMAL,
        Place::field("film").then("direction"),
        detail,
    );
}

/// Minimum number of cables and masts that end at a joint. Two of them hold the joint on the line between their other
/// ends.
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
        let detail = format!("moves freely: {FEWEST_AT_JOINT} or more cables or masts must end at a joint");
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

/// Supports count as collinear if each lies within this distance of one line, as a fraction of the supports' extent. A
/// structure on collinear supports can turn about their line.
const COLLINEAR: f64 = 1e-9;

/// Marks, for each boundary, the points that a support holds.
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

/// Refuses a mechanism: fewer than two distinct supports, or a structure without weight whose supports are collinear,
/// so that it turns freely about their line.
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
