//! The mesh that a solver starts from. It determines the topology of the result. If a boundary bounds several minimal
//! surfaces, it also determines which of them comes out.

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
use plateau_mesh::polyline::contact::{Contact, Segments, first_contact};
use plateau_mesh::self_intersections::{Order, self_intersections};
use plateau_mesh::{DVec2, DVec3, Error, Execution, Interruption, Place};
use spanning::Spanning;

pub(super) use first_point::{first_point, turned};
pub(super) use given::ON_SEGMENT;
pub(super) use spanning::Start;

/// Which initial mesh was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InitialMeshKind {
    /// Delaunay triangles in the best plane, heights extended harmonically.
    Planar,
    /// Delaunay triangles in a round disc, mapped harmonically.
    Disk,
    /// Two boundaries: Delaunay triangles in a round annulus, mapped harmonically.
    Annulus,
    /// Three and more: Delaunay triangles between the loops as they are seen from a point in their middle, or in a disc
    /// with round holes, mapped harmonically.
    SphereWithHoles,
    /// Chen, Cai, Zheng's rings. [`InitialMesh::Auto`] stands for them between two boundaries that nearly coincide.
    Rings,
    /// Liu, Wang's seeded choice of barycentres.
    Barycentres,
    /// The caller's own mesh.
    Given,
}

impl InitialMeshKind {
    /// A stable name in snake case.
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

/// A film between the boundaries (centred, without equal neighbours), and how it was made. Its triangles run along the
/// first boundary in the direction of the boundary. The point with which the list of a boundary begins affects only the
/// numbers of the vertices.
///
/// Three and more boundaries of a film in space can be laid out in the plane in several ways, of which `arrangement`
/// asks for one by its number. Without a number the initial mesh of least area is taken among those that do not cross
/// themselves.
///
/// # Errors
/// [`Error::Input`] for a resolution that these boundaries cannot have; [`Error::NoResult`] for a plane boundary that
/// crosses itself; the interruptions of `exec`.
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

/// Meshes the boundaries. `as_given` are the same boundaries as the caller numbers their points; errors name these
/// numbers.
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

/// The number of ways to lay out the boundaries in the plane, or 0 if there is only one.
pub(super) fn arrangements(boundaries: &[Vec<DVec3>]) -> usize {
    if boundaries.len() > 2 { Shape::arrangements(boundaries).len() } else { 0 }
}

/// Meshes a disc, an annulus or a sphere with holes and maps it into space. If no `arrangement` is asked for, the
/// layout of the boundaries is chosen whose mesh has the least area without crossing itself. Among nearly equal areas
/// the more trusted layout is preferred.
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
        // area are not examined for crossings, so that rounding in these tests cannot change the choice.
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
    // If all of them cross themselves, the first one is as good as any.
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
        // A disk of m boundary points and n others has m + 2 n - 2 triangles.
        _ => ((estimate(boundaries, options).triangles + 2.0 - boundary.len() as f64) / 2.0).round() as usize,
    };
    candidate_mesh(boundary, interior_vertices, seed, exec)
}

/// Refuses what [`build`] would refuse, as far as that can be seen without meshing. Linear in the size of the input.
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
    // By Euler's formula F = 2 (interior) + (boundary) - 2 χ, and a connected surface with k boundaries has χ = 2 - k.
    let least = points as f64 + 2.0 * boundaries.len() as f64 - 4.0;
    match options.resolution {
        Resolution::Triangles(count) if options.keeps_topology() && (count as f64) < 0.9 * least => {
            let detail = format!("the boundaries' own points already make {least} triangles");
            Err(Error::input(Place::field("resolution").then("triangles"), detail))
        }
        _ => Ok(()),
    }
}

/// Whether a film is a sphere with one hole for each of its boundaries.
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

/// Relative difference of areas up to which the more trusted of two initial meshes is preferred. It is above the errors
/// of coarse meshes, and both usually lead to the same film.
const SIMILAR_AREA: f64 = 1e-2;

/// A projection counts as too steep if a segment keeps less than this fraction of its length. The boundary is then
/// meshed in a disc instead of in its plane.
const STEEP: f64 = 0.25;

fn extent(boundaries: &[Vec<DVec3>]) -> f64 {
    boundaries.iter().flatten().map(|p| p.length()).fold(0.0, f64::max)
}

/// Whether no segment is so steep that the projection would crowd the points around it.
fn is_gentle(boundaries: &[Vec<DVec3>], frame: &Frame) -> bool {
    boundaries.iter().all(|points| {
        (0..points.len()).all(|k| {
            let (a, b) = (points[k], points[(k + 1) % points.len()]);
            frame.project(a).distance(frame.project(b)) >= STEEP * a.distance(b)
        })
    })
}

/// Largest distance, as a fraction of the boundaries' extent, at which sides touch when they are seen in their plane.
const TOUCHING: f64 = 1e-12;

/// The start points of the first two sides that meet when they are projected onto a plane, as the places of an error.
/// Empty if no sides meet.
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
            let apart = |c: &Contact| k != l || (c.first + 1 < c.second && (c.second + 1) % count != c.first);
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

/// The first point of the constraints that does not lie inside the boundaries, seen in their plane.
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
    let curves = constraints.polylines.iter().enumerate();
    curves
        .filter_map(|(k, curve)| Some((k, curve.iter().position(is_outside)?)))
        .next()
        .map(|(k, i)| Place::field("constraints").then("polylines").at(k).at(i))
}

/// The error for a domain that has no mesh. `plane` is the plane in which the mesh was made.
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
        PlaneError::NotSimple(_) if plane.is_some() => Error::NoResult {
            reason: Reason::SelfIntersectingBoundary,
            detail:
                "seen in its plane the boundary crosses or touches itself, so that no mesh without folds spans it; \
                     move the points apart, or ask for the initial mesh disk if the boundary is a curve in space"
                    .into(),
            places: match plane.map(|frame| crossing_places(boundaries, frame, exec)) {
                Some(Ok(places)) if !places.is_empty() => places,
                _ => (0..boundaries.len())
                    .map(|k| {
                        InputError::new(Place::field("boundaries").at(k), "is part of a boundary that is not simple")
                    })
                    .collect(),
            },
        },
        PlaneError::NotSimple(_) => Error::no_result(
            Reason::DegenerateBoundary,
            "points of the boundary are so close together that they cannot be told apart",
        ),
    }
}
