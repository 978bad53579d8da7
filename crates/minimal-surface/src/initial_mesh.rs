//! Builds the initial mesh from which a solver starts. The initial mesh determines the topology of the result. If
//! several minimal surfaces have the same boundary, the initial mesh also determines to which of them the solver
//! converges.

mod barycentres;
mod domain;
mod first_point;
mod given;
mod graded_lattice;
mod harmonic_map;
mod layout;
pub(super) mod pins;
mod plane_mesh;
mod polygon_domain;
mod rings;
mod sampling;
mod spanning;
mod strip;

use super::estimate::estimate;
use super::options::{BoundarySampling, Constraints, InitialMesh, Options, Resolution};
use barycentres::candidate_mesh;
use domain::{Shape, best_plane, largest_height};
use first_point::turned_back;
use pins::Pins;
use plane_mesh::PlaneError;
use plateau_mesh::codes::Reason;
use plateau_mesh::error::InputError;
use plateau_mesh::film::Film;
use plateau_mesh::plane::frame::Frame;
use plateau_mesh::plane::polygon::contains;
use plateau_mesh::polyline::contact::{MeetingSegments, Segments, first_contact};
use plateau_mesh::self_intersections::{Order, self_intersections};
use plateau_mesh::{DVec2, DVec3, Error, Execution, Interruption, Place};
use spanning::Spanning;

pub(super) use first_point::{first_point, turned};
pub(super) use given::ON_SEGMENT;
pub(super) use spanning::Start;

/// Kind of initial mesh that was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InitialMeshKind {
    /// Delaunay triangles in the best plane. The heights above the plane are extended harmonically from the boundary.
    Planar,
    /// Delaunay triangles in a round disc, mapped harmonically into space.
    Disk,
    /// For two boundaries: Delaunay triangles in a round annulus, mapped harmonically into space.
    Annulus,
    /// For three or more boundaries: Delaunay triangles, mapped harmonically into space. Their plane domain is bounded
    /// either by the stereographic images of the boundary loops, seen from a point in their middle, or by a circle with
    /// round holes.
    SphereWithHoles,
    /// The rings of Chen, Cai, Zheng. [`InitialMesh::Auto`] chooses them if two boundaries nearly coincide.
    Rings,
    /// Liu and Wang's candidate points at barycentres, chosen by a seed.
    Barycentres,
    /// The caller's own mesh.
    Given,
}

impl InitialMeshKind {
    /// Stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Planar => "planar",
            Self::Disk => "disk",
            Self::Annulus => "annulus",
            Self::SphereWithHoles => "sphere_with_holes",
            Self::Rings => "rings",
            Self::Barycentres => "barycentres",
            Self::Given => "given",
        }
    }
}

/// Builds the initial mesh, a film that spans the boundaries, and returns the film with the kind of the mesh. The
/// boundaries must be centred and must not have equal neighbouring points. The triangles run along the first boundary
/// in its direction. The point with which the list of a boundary begins affects only the numbers of the vertices.
///
/// Three or more boundaries of a film in space can be laid out in the plane in several ways, and `arrangement` is the
/// number of the layout to use. Without it, the layout is used whose initial mesh has the least area among those that
/// do not cross themselves.
///
/// # Errors
/// [`Error::Input`] for a resolution that is impossible for these boundaries; [`Error::NoResult`] for a plane boundary
/// that crosses itself; the interruptions of `exec`.
pub(super) fn build(
    boundaries: &[Vec<DVec3>],
    options: &Options,
    arrangement: Option<usize>,
    exec: &Execution,
) -> Result<(Start, InitialMeshKind), Error> {
    let constraints = &options.constraints;
    if let InitialMesh::Given(mesh) = &options.initial_mesh {
        let pins = Pins::new(constraints, boundaries, f64::INFINITY, BoundarySampling::Keep);
        let film = given::build(mesh, boundaries, &pins)?;
        return Ok((Start { film, subdivisions: 0 }, InitialMeshKind::Given));
    }
    if !constraints.is_empty() && matches!(options.initial_mesh, InitialMesh::Rings | InitialMesh::Barycentres { .. }) {
        let detail = "rings and barycentres take no constraints; auto, planar and disk do";
        return Err(Error::input(Place::field("constraints"), detail));
    }
    let (turned, firsts) = turned(boundaries);
    let (mut start, kind) = spanning(&turned, boundaries, options, arrangement, exec)?;
    start.film = turned_back(start.film, boundaries, &firsts);
    Ok((start, kind))
}

/// Meshes the boundaries. `as_given` are the same boundaries with their points in the caller's order, because errors
/// name points by the caller's numbers.
fn spanning(
    boundaries: &[Vec<DVec3>],
    as_given: &[Vec<DVec3>],
    options: &Options,
    arrangement: Option<usize>,
    exec: &Execution,
) -> Result<(Start, InitialMeshKind), Error> {
    let constraints = &options.constraints;
    let whole = |film| Start { film, subdivisions: 0 };
    if let Some(seed) = options.barycentres(boundaries.len()) {
        return Ok((whole(barycentres(boundaries, options, seed, exec)?), InitialMeshKind::Barycentres));
    }
    let Some(frame) = best_plane(boundaries) else {
        return Err(Error::input(Place::field("boundaries"), "all points lie on one line"));
    };
    let attempt = |shape| Spanning { boundaries, shape, constraints, options, exec }.build();
    match &options.initial_mesh {
        InitialMesh::Rings => Ok((whole(rings::build(boundaries, options, exec)?), InitialMeshKind::Rings)),
        InitialMesh::Planar => {
            let start = attempt(Shape::Plane(frame))?
                .map_err(|error| refusal((as_given, constraints), error, Some(&frame), exec))?;
            Ok((start, InitialMeshKind::Planar))
        }
        InitialMesh::Disk => curved(boundaries, as_given, options, arrangement, exec),
        InitialMesh::Auto | InitialMesh::Barycentres { .. } | InitialMesh::Given(_) => {
            let flat = largest_height(&frame, boundaries) <= FLAT * extent(boundaries);
            if flat || is_gentle(boundaries, &frame) {
                match attempt(Shape::Plane(frame))? {
                    Ok(start) if start.film.topology.components() == 1 => return Ok((start, InitialMeshKind::Planar)),
                    // A single plane boundary that is not simple has no other initial mesh.
                    Err(error @ (PlaneError::NotSimple(_) | PlaneError::PointOutside(_)))
                        if flat && boundaries.len() == 1 =>
                    {
                        return Err(refusal((as_given, constraints), error, Some(&frame), exec));
                    }
                    Err(error @ (PlaneError::TooManyPoints | PlaneError::TooCoarse { .. })) => {
                        return Err(refusal((as_given, constraints), error, Some(&frame), exec));
                    }
                    _ => {}
                }
            }
            if let [first, second] = boundaries
                && constraints.is_empty()
                && rings::is_narrow(first, second, options.resolution)
            {
                match rings::build_narrow(boundaries, options, exec) {
                    Ok(film) if !crosses_itself(&film, exec)? => return Ok((whole(film), InitialMeshKind::Rings)),
                    Err(Error::Interrupted(interruption)) => return Err(interruption.into()),
                    _ => {}
                }
            }
            curved(boundaries, as_given, options, arrangement, exec)
        }
    }
}

/// Number of ways to lay out three or more boundaries in the plane. 0 for one or two boundaries, which have one layout.
pub(super) fn arrangements(boundaries: &[Vec<DVec3>]) -> usize {
    if boundaries.len() > 2 { Shape::arrangements(boundaries).len() } else { 0 }
}

/// Meshes a disc, an annulus or a sphere with holes and maps it into space. Without `arrangement`, the layout is chosen
/// whose mesh has the least area without crossing itself. If areas are nearly equal, the layout that comes first in
/// [`Shape::arrangements`] wins.
fn curved(
    boundaries: &[Vec<DVec3>],
    as_given: &[Vec<DVec3>],
    options: &Options,
    arrangement: Option<usize>,
    exec: &Execution,
) -> Result<(Start, InitialMeshKind), Error> {
    let constraints = &options.constraints;
    let kind = match boundaries.len() {
        1 => InitialMeshKind::Disk,
        2 => InitialMeshKind::Annulus,
        _ => InitialMeshKind::SphereWithHoles,
    };
    let mut arrangements = Shape::arrangements(boundaries);
    if let Some(k) = arrangement.filter(|&k| k < arrangements.len()) {
        arrangements = vec![arrangements.swap_remove(k)];
    }
    let is_only = arrangements.len() == 1;
    let (mut least, mut crossing, mut failure): (Option<(f64, Start)>, Option<Start>, _) = (None, None, None);
    for shape in arrangements {
        let built = Spanning { boundaries, shape, constraints, options, exec }.build()?;
        let start = match built {
            Ok(start) if is_only => return Ok((start, kind)),
            Ok(start) => start,
            Err(error) => {
                failure = Some(error);
                continue;
            }
        };
        // Among the meshes that do not cross themselves, the one of least area is nearest to a film. Meshes of larger
        // area are not examined for crossings, so that rounding in the examination cannot change the choice.
        let area = start.film.area();
        let is_less = least.as_ref().is_none_or(|(least, _)| area < (1.0 - SIMILAR_AREA) * least);
        if !is_less || !is_in_one_piece(&start.film) {
            continue;
        }
        if crosses_itself(&start.film, exec)? {
            crossing.get_or_insert(start);
        } else {
            least = Some((area, start));
        }
    }
    // If all meshes cross themselves, the first of them is returned.
    let Some(start) = least.map(|(_, start)| start).or(crossing) else {
        let error = failure.unwrap_or(PlaneError::NotSimple([0; 2]));
        return Err(refusal((as_given, constraints), error, None, exec));
    };
    Ok((start, kind))
}

/// The common plane of the boundaries. `None` if they do not all lie in one plane.
pub(super) fn plane_of(boundaries: &[Vec<DVec3>]) -> Option<Frame> {
    best_plane(boundaries).filter(|frame| largest_height(frame, boundaries) <= FLAT * extent(boundaries))
}

fn barycentres(boundaries: &[Vec<DVec3>], options: &Options, seed: u64, exec: &Execution) -> Result<Film, Error> {
    let [boundary] = boundaries else {
        return Err(Error::input(Place::field("initial_mesh"), "barycentres need exactly one boundary"));
    };
    let interior_vertices = match options.resolution {
        Resolution::InteriorVertices(count) => count,
        // A disc with m boundary points and n interior points has m + 2 n - 2 triangles.
        _ => ((estimate(boundaries, options).triangles + 2.0 - boundary.len() as f64) / 2.0).round() as usize,
    };
    candidate_mesh(boundary, interior_vertices, seed, exec)
}

/// Refuses inputs that [`build`] would refuse, as far as this can be seen without meshing. Linear in the input's size.
///
/// # Errors
/// [`Error::Input`].
pub(super) fn check(boundaries: &[Vec<DVec3>], options: &Options) -> Result<(), Error> {
    match &options.initial_mesh {
        InitialMesh::Given(mesh) => {
            let pins = Pins::new(&options.constraints, boundaries, f64::INFINITY, BoundarySampling::Keep);
            return given::build(mesh, boundaries, &pins).map(drop);
        }
        InitialMesh::Rings if options.boundary_sampling == BoundarySampling::Keep => {
            return rings::check(boundaries, options.resolution);
        }
        _ => {}
    }
    let points: usize = boundaries.iter().map(Vec::len).sum();
    // Without interior points, F = (boundary points) - 2 χ, and a connected surface of genus 0 with k boundaries has
    // χ = 2 - k.
    let least = points as f64 + 2.0 * boundaries.len() as f64 - 4.0;
    match options.resolution {
        Resolution::Triangles(count) if options.keeps_topology() && (count as f64) < 0.9 * least => {
            let detail = format!("the boundaries' own points already make {least} triangles");
            Err(Error::input(Place::field("resolution").then("triangles"), detail))
        }
        _ => Ok(()),
    }
}

/// Whether a film is one connected sphere with a hole for each of its boundaries.
fn is_in_one_piece(film: &Film) -> bool {
    let holes = film.boundaries.len() as i64;
    film.topology.components() == 1 && film.topology.euler_characteristic() == 2 - holes
}

fn crosses_itself(film: &Film, exec: &Execution) -> Result<bool, Interruption> {
    let found = self_intersections(&film.vertices, film.triangles(), Order::Spatial, u64::MAX, exec)?;
    Ok(found.pairs > 0)
}

/// A boundary counts as plane if its distances from the plane are below this fraction of its extent.
const FLAT: f64 = 1e-9;

/// Relative difference of areas up to which two initial meshes count as equally good, so that the first layout wins. It
/// is above the errors of coarse meshes, and two meshes that differ by less usually lead to the same film.
const SIMILAR_AREA: f64 = 1e-2;

/// A projection counts as too steep if a segment keeps less than this fraction of its length. The boundary is then
/// meshed in a disc instead of in its plane.
const STEEP: f64 = 0.25;

fn extent(boundaries: &[Vec<DVec3>]) -> f64 {
    boundaries.iter().flatten().map(|p| p.length()).fold(0.0, f64::max)
}

/// Whether the projection onto the plane keeps at least [`STEEP`] of the length of each boundary segment. A steeper
/// segment would crowd the points around it.
fn is_gentle(boundaries: &[Vec<DVec3>], frame: &Frame) -> bool {
    boundaries.iter().all(|points| {
        (0..points.len()).all(|k| {
            let (a, b) = (points[k], points[(k + 1) % points.len()]);
            frame.project(a).distance(frame.project(b)) >= STEEP * a.distance(b)
        })
    })
}

/// Largest distance at which two projected sides of the boundaries count as touching, as a fraction of the extent.
const TOUCHING: f64 = 1e-12;

/// Finds the first two sides of the boundaries that meet when they are projected onto the plane. Returns an error at
/// the start point of each of the two. Empty if no sides meet.
fn crossing_places(
    boundaries: &[Vec<DVec3>],
    frame: &Frame,
    exec: &Execution,
) -> Result<Vec<InputError>, Interruption> {
    let flat = |boundary: &Vec<DVec3>| -> Vec<DVec3> {
        boundary.iter().map(|&point| frame.project(point).extend(0.0)).collect()
    };
    let flat: Vec<Vec<DVec3>> = boundaries.iter().map(flat).collect();
    let segments: Vec<Segments> = flat.iter().map(|points| Segments::new(points, true)).collect();
    let tolerance = TOUCHING * extent(boundaries);
    for k in 0..boundaries.len() {
        for l in k..boundaries.len() {
            let count = boundaries[k].len();
            let apart = |c: &MeetingSegments| k != l || (c.first + 1 < c.second && (c.second + 1) % count != c.first);
            if let Some(contact) = first_contact(&segments[k], &segments[l], tolerance, apart, exec)? {
                let sides = [(k, contact.first), (l, contact.second)];
                let place = |[(k, i), (l, j)]: [(usize, usize); 2]| {
                    let detail = format!("the side from this point meets the side from point {j} of boundary {l}");
                    InputError::new(Place::field("boundaries").at(k).at(i), detail)
                };
                return Ok(vec![place(sides), place([sides[1], sides[0]])]);
            }
        }
    }
    Ok(Vec::new())
}

/// Finds the first piece of a fixed curve that meets another piece or a side of a boundary when both are projected onto
/// the plane. Pieces may meet at a point that both have. Returns an error for each of the two curves, or for the one.
/// Empty if no pieces meet.
fn crossing_curves(
    boundaries: &[Vec<DVec3>],
    curves: &[Vec<DVec3>],
    frame: &Frame,
    exec: &Execution,
) -> Result<Vec<InputError>, Interruption> {
    let flat =
        |points: &Vec<DVec3>| -> Vec<DVec3> { points.iter().map(|&point| frame.project(point).extend(0.0)).collect() };
    let lines: Vec<(&Vec<DVec3>, bool)> =
        curves.iter().map(|curve| (curve, false)).chain(boundaries.iter().map(|points| (points, true))).collect();
    let flat: Vec<Vec<DVec3>> = lines.iter().map(|(points, _)| flat(points)).collect();
    let segments: Vec<Segments> =
        flat.iter().zip(&lines).map(|(points, (_, closed))| Segments::new(points, *closed)).collect();
    let tolerance = TOUCHING * extent(boundaries);
    let piece = |line: usize, k: usize| {
        let points = lines[line].0;
        [points[k], points[(k + 1) % points.len()]]
    };
    for k in 0..curves.len() {
        exec.look(lines.len() as u64)?;
        for l in k..lines.len() {
            let apart = |c: &MeetingSegments| {
                let [first, second] = [piece(k, c.first), piece(l, c.second)];
                let is_same = k == l && c.first >= c.second;
                !is_same && !first.iter().any(|point| second.contains(point))
            };
            let Some(contact) = first_contact(&segments[k], &segments[l], tolerance, apart, exec)? else { continue };
            let place = |curve: usize, i: usize| Place::field("constraints").then("polylines").at(curve).at(i);
            if l >= curves.len() {
                let detail = "seen in the plane of the boundaries, the curve meets a side of a boundary between this \
                              point and the next one: a curve stays inside, and only its ends lie on the boundaries";
                let side = Place::field("boundaries").at(l - curves.len()).at(contact.second);
                let other = "a fixed curve meets the side from this point";
                return Ok(vec![InputError::new(place(k, contact.first), detail), InputError::new(side, other)]);
            }
            let detail = "seen in the plane of the boundaries, two curves meet between this point and the next one, \
                          where they have no common point: give both the same point there";
            return Ok(vec![
                InputError::new(place(k, contact.first), detail),
                InputError::new(place(l, contact.second), detail),
            ]);
        }
    }
    Ok(Vec::new())
}

/// Returns the error for boundaries and fixed curves that cross or touch, seen in their plane. The curves are named if
/// the boundaries alone do not.
fn not_simple(
    (boundaries, constraints): (&[Vec<DVec3>], &Constraints),
    frame: &Frame,
    exec: &Execution,
) -> Result<Error, Interruption> {
    let mut places = crossing_places(boundaries, frame, exec)?;
    let curves = &constraints.polylines;
    if places.is_empty() && !curves.is_empty() {
        let crossing = crossing_curves(boundaries, curves, frame, exec)?;
        if !crossing.is_empty() {
            return Ok(Error::Input(crossing));
        }
        let detail = "seen in the plane of the boundaries, the curves touch each other or the boundaries elsewhere \
                      than at their points";
        return Ok(Error::input(Place::field("constraints").then("polylines"), detail));
    }
    if places.is_empty() {
        let detail = "is part of a boundary that is not simple";
        places = (0..boundaries.len()).map(|k| InputError::new(Place::field("boundaries").at(k), detail)).collect();
    }
    let detail = "seen in its plane the boundary crosses or touches itself, so that no mesh without folds spans it; \
                  move the points apart, or ask for the initial mesh disk if the boundary is a curve in space";
    Ok(Error::NoResult { reason: Reason::SelfIntersectingBoundary, detail: detail.into(), places })
}

/// Finds the first point of the constraints whose projection onto the plane does not lie inside the boundaries. Middles
/// of pieces of curves come after all points, at the points with which the pieces begin.
fn outside(boundaries: &[Vec<DVec3>], constraints: &Constraints, frame: &Frame) -> Option<Place> {
    let loops: Vec<Vec<DVec2>> =
        boundaries.iter().map(|points| points.iter().map(|&p| frame.project(p)).collect()).collect();
    let is_outside = |point: &DVec3| {
        let place = frame.project(*point);
        let is_on_boundary = boundaries.iter().flatten().any(|p| p == point);
        !is_on_boundary && loops.iter().filter(|polygon| contains(polygon, place)).count().is_multiple_of(2)
    };
    let place = Place::field("constraints");
    if let Some(k) = constraints.points.iter().position(is_outside) {
        return Some(place.then("points").at(k));
    }
    let is_side = |pair: &[DVec3]| {
        let side = |points: &Vec<DVec3>, k: usize| [points[k], points[(k + 1) % points.len()]];
        let joins = |[a, b]: [DVec3; 2]| [a, b] == *pair || [b, a] == *pair;
        boundaries.iter().any(|points| (0..points.len()).any(|k| joins(side(points, k))))
    };
    let middle_is_outside = |pair: &[DVec3]| is_outside(&pair[0].midpoint(pair[1])) && !is_side(pair);
    let curves = || constraints.polylines.iter().enumerate();
    let points = curves().filter_map(|(k, curve)| Some((k, curve.iter().position(is_outside)?)));
    let middles = curves().filter_map(|(k, curve)| Some((k, curve.windows(2).position(middle_is_outside)?)));
    let mut found = points.chain(middles);
    found.next().map(|(k, i)| Place::field("constraints").then("polylines").at(k).at(i))
}

/// Converts a failure of the plane mesher into the error for the caller. `plane` is the plane of the mesh, if the mesh
/// was made by projection.
fn refusal(
    (boundaries, constraints): (&[Vec<DVec3>], &Constraints),
    error: PlaneError,
    plane: Option<&Frame>,
    exec: &Execution,
) -> Error {
    match error {
        PlaneError::Interrupted(interruption) => interruption.into(),
        PlaneError::TooManyPoints => {
            let detail = "the mesh would have more triangles than can be numbered, or many times those asked for; is \
                there a spike in the boundaries, or are some points much closer together than the rest?";
            Error::input(Place::field("resolution"), detail)
        }
        PlaneError::PointOutside(_) => {
            let detail = "a fixed point or curve does not lie inside the boundaries, seen in their plane";
            let place = plane.and_then(|frame| outside(boundaries, constraints, frame));
            Error::input(place.unwrap_or_else(|| Place::field("constraints")), detail)
        }
        PlaneError::TooCoarse { triangles } => {
            let detail =
                format!("the boundaries' own points already make {triangles} triangles, which is too many for it");
            Error::input(Place::field("resolution"), detail)
        }
        PlaneError::NotSimple(_) => match plane {
            Some(frame) => not_simple((boundaries, constraints), frame, exec).unwrap_or_else(Error::from),
            None if constraints.polylines.is_empty() => Error::no_result(
                Reason::DegenerateBoundary,
                "points of the boundary are so close together that they cannot be told apart",
            ),
            None => {
                let detail = "the curves cross each other or a boundary where the film is laid out flat to be \
                              meshed: give curves that cross a common point, and let only the ends of a curve lie on \
                              a boundary";
                Error::input(Place::field("constraints").then("polylines"), detail)
            }
        },
    }
}
