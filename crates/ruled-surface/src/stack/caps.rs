//! Flat caps: constrained Delaunay triangulations of planar end contours, which add no vertices.

use plateau_mesh::error::{Error, InputError, Place};
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::plane::flatness::Flatness;
use plateau_mesh::plane::frame::Frame;
use plateau_mesh::plane::triangulation::{Border, Constraint, triangles_inside};
use plateau_mesh::polyline::merge_near_neighbours;
use plateau_mesh::{DVec2, DVec3, Mesh};

/// Projects the points of an end contour onto its plane. Returns the projected points and the largest distance by which
/// a point was moved, or `None` if all points already lie in the plane, up to rounding. `place` is the place of the
/// contour in the input.
///
/// # Errors
/// [`InputError`] if the contour has no area, or at the farthest point if it is not planar.
pub(crate) fn project(points: &[DVec3], place: Place) -> Result<Option<(Vec<DVec3>, f64)>, InputError> {
    let merged = merge_near_neighbours(points, true);
    if merged.points.len() < 3 {
        // Either an apex, or too few points, which is reported elsewhere.
        return Ok(None);
    }
    let Some(plane) = Frame::of_loop(&merged.points) else {
        return Err(InputError::new(place, WITHOUT_AREA));
    };
    match Flatness::of(merged.points.iter().copied(), &merged.points, &plane) {
        Flatness::Plane => Ok(None),
        Flatness::Near(distance) => Ok(Some((points.iter().map(|&point| plane.foot(point)).collect(), distance))),
        Flatness::Bent(departure) => {
            let place = place.at(merged.source[departure.point]);
            Err(InputError::new(place, departure.detail("flat caps need planar end contours")))
        }
    }
}

const WITHOUT_AREA: &str = "flat caps need an end contour with an area";

/// Closes the two ends of a closed stack with planar caps and orients the mesh outwards. The end contours must be
/// planar. An end that is a directrix of one point gets no cap, because it is closed already.
///
/// # Errors
/// [`Error::Input`] at `directrices`, k if an end contour crosses itself.
pub(crate) fn close(mesh: &mut Mesh, directrices: &[Vec<u32>], execution: &Execution<'_>) -> Result<(), Error> {
    let last = directrices.len() - 1;
    for k in [0, last] {
        if directrices[k].len() > 1 {
            // The triangles of a strip run along its first directrix and against its second one. The edges of a cap run
            // the other way.
            let cap = cap(&mesh.vertices, &directrices[k], k == last, execution)?
                .map_err(|detail| Error::input(Place::field("directrices").at(k), detail))?;
            mesh.triangles.extend(cap);
        }
    }
    if six_volumes(mesh) < 0.0 {
        for triangle in &mut mesh.triangles {
            triangle.swap(1, 2);
        }
    }
    Ok(())
}

/// Returns six times the enclosed volume, summed over the tetrahedra from the first vertex to the triangles.
fn six_volumes(mesh: &Mesh) -> f64 {
    let origin = mesh.vertices[0];
    let volume = |&t: &[u32; 3]| {
        let [a, b, c] = mesh.corners(t).map(|corner| corner - origin);
        a.dot(b.cross(c))
    };
    mesh.triangles.iter().map(volume).sum()
}

/// Returns triangles that fill the polygon, or the reason why there are none. Their outer edges run along the contour
/// if `along` is true, otherwise against it.
fn cap(
    vertices: &[DVec3],
    contour: &[u32],
    along: bool,
    execution: &Execution<'_>,
) -> Result<Result<Vec<[u32; 3]>, &'static str>, Interruption> {
    let origin = vertices[contour[0] as usize];
    let points: Vec<DVec3> = contour.iter().map(|&v| vertices[v as usize] - origin).collect();
    let size = points.iter().fold(0.0f64, |m, p| m.max(p.length()));
    // Twice the area vector. The points are divided by their size, so that nothing overflows.
    let next = |k: usize| points[(k + 1) % points.len()] / size;
    let area: DVec3 = (0..points.len()).map(|k| (points[k] / size).cross(next(k))).sum();
    let Some(normal) = area.try_normalize() else {
        return Ok(Err(WITHOUT_AREA));
    };
    let frame = Frame::with_normal(normal);
    let flat: Vec<DVec2> = points.iter().map(|&p| frame.coordinates(p) / size).collect();
    let n = flat.len() as u32;
    let outline = |k| Constraint { from: k, to: (k + 1) % n, border: Border::Outline };
    execution.look(contour.len() as u64)?;
    let Ok(triangles) = triangles_inside(&flat, &(0..n).map(outline).collect::<Vec<_>>()) else {
        return Ok(Err("flat caps need end contours that do not cross or touch themselves"));
    };
    let mut triangles: Vec<[u32; 3]> = triangles.into_iter().map(|t| t.map(|v| contour[v as usize])).collect();
    // The plane's axes make the contour run counter-clockwise, as the faces do.
    if !along {
        for triangle in &mut triangles {
            triangle.swap(1, 2);
        }
    }
    Ok(Ok(triangles))
}
