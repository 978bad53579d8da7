//! Flat caps: constrained Delaunay triangulations of planar end contours, which add no vertices.

use crate::error::{Error, Place};
use crate::execution::{Execution, Interruption};
use crate::{DVec2, DVec3, Mesh};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

/// Largest distance of a point of a planar contour from its plane, as a fraction of the contour's size; rounding of the
/// input comes on top. A larger value closes ends that are visibly bent.
const PLANARITY: f64 = 1e-9;

/// Closes the two ends of a closed stack. A directrix of one point closes its end already. Leaves the mesh oriented
/// outwards.
///
/// # Errors
/// [`Error::Input`] at `directrices`, k if an end contour is not planar or crosses itself.
pub(crate) fn close(mesh: &mut Mesh, directrices: &[Vec<u32>], execution: &Execution<'_>) -> Result<(), Error> {
    let last = directrices.len() - 1;
    for k in [0, last] {
        if directrices[k].len() > 1 {
            // Strips run along their first directrix and against their second one; a cap's edges run the other way.
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

/// Six times the enclosed volume, seen from the first vertex.
fn six_volumes(mesh: &Mesh) -> f64 {
    let origin = mesh.vertices[0];
    let volume = |&t: &[u32; 3]| {
        let [a, b, c] = mesh.corners(t).map(|corner| corner - origin);
        a.dot(b.cross(c))
    };
    mesh.triangles.iter().map(volume).sum()
}

/// Triangles of the polygon's inside, or why there are none; their outer edges run along the contour if `along`, else
/// against it.
fn cap(
    vertices: &[DVec3],
    contour: &[u32],
    along: bool,
    execution: &Execution<'_>,
) -> Result<Result<Vec<[u32; 3]>, &'static str>, Interruption> {
    let origin = vertices[contour[0] as usize];
    let points: Vec<DVec3> = contour.iter().map(|&v| vertices[v as usize] - origin).collect();
    let largest = contour.iter().fold(0.0f64, |m, &v| m.max(vertices[v as usize].abs().max_element()));
    let size = points.iter().fold(0.0f64, |m, p| m.max(p.length()));
    // Twice the area vector; scaled so that no size overflows.
    let next = |k: usize| points[(k + 1) % points.len()] / size;
    let area: DVec3 = (0..points.len()).map(|k| (points[k] / size).cross(next(k))).sum();
    let Some(normal) = area.try_normalize() else {
        return Ok(Err("flat caps need an end contour with an area"));
    };
    let tolerance = PLANARITY * size + 4.0 * (largest.next_up() - largest);
    if points.iter().any(|p| p.dot(normal).abs() > tolerance) {
        return Ok(Err("flat caps need planar end contours"));
    }
    let (u, v) = normal.any_orthonormal_pair();
    let flat: Vec<DVec2> = points.iter().map(|p| DVec2::new(p.dot(u), p.dot(v)) / size).collect();
    let crossing = Ok(Err("flat caps need end contours that do not cross or touch themselves"));
    let mut triangulation = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
    let mut handles = Vec::with_capacity(flat.len());
    for (k, point) in flat.iter().enumerate() {
        look_now_and_then(k, execution)?;
        match triangulation.insert(Point2::new(point.x, point.y)) {
            Ok(handle) if handle.index() == handles.len() => handles.push(handle),
            // The point of an earlier one, or coordinates too small for the triangulation.
            _ => return crossing,
        }
    }
    for k in 0..handles.len() {
        look_now_and_then(k, execution)?;
        let (from, to) = (handles[k], handles[(k + 1) % handles.len()]);
        if !triangulation.can_add_constraint(from, to) || !triangulation.add_constraint(from, to) {
            return crossing;
        }
        // A constraint through a third point is split there.
        if !triangulation.exists_constraint(from, to) {
            return crossing;
        }
    }
    // Faces inside: reached from the outer face over an odd number of contour edges.
    let mut inside = vec![None; triangulation.num_all_faces()];
    inside[triangulation.outer_face().index()] = Some(false);
    let mut open = vec![triangulation.outer_face()];
    let mut triangles = Vec::with_capacity(flat.len());
    while let Some(face) = open.pop() {
        let here = inside[face.index()] == Some(true);
        let edges: Vec<_> = match face.as_inner() {
            Some(inner) => inner.adjacent_edges().to_vec(),
            None => triangulation.convex_hull().collect(),
        };
        if let (true, Some(inner)) = (here, face.as_inner()) {
            triangles.push(inner.vertices().map(|vertex| contour[vertex.fix().index()]));
        }
        for edge in edges {
            // The hull's edges run along the outer face, a triangle's along the triangle: the other side is the twin's.
            let other = edge.rev().face();
            if inside[other.index()].is_none() {
                inside[other.index()] = Some(here != edge.is_constraint_edge());
                open.push(other);
            }
        }
    }
    if triangles.len() != contour.len() - 2 {
        return crossing;
    }
    // The plane's axes make the contour run counter-clockwise, as the faces do.
    if !along {
        for triangle in &mut triangles {
            triangle.swap(1, 2);
        }
    }
    Ok(Ok(triangles))
}

/// A point or an edge of the triangulation takes some microseconds.
fn look_now_and_then(k: usize, execution: &Execution<'_>) -> Result<(), Interruption> {
    if k % 256 == 255 { execution.look(256) } else { Ok(()) }
}
