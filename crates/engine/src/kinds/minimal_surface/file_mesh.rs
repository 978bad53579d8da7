//! Reads the client's own initial mesh from a binary glTF file in base64, and gives its boundary the exact coordinates
//! of the request.
//!
//! The numbers of a file are f32, but the mesh has to run through the request's f64 points exactly. Therefore a vertex
//! on the mesh's boundary moves to a point of the request that is within the rounding of the file, and boundary
//! vertices between two moved vertices move onto the straight line between them.

use crate::limits::Limits;
use base64::Engine as _;
use plateau_archive::glb::{self, GlbError, Triangles};
use plateau_archive::units::{Unit, UpAxis};
use plateau_mesh::polyline::position_key;
use plateau_mesh::{DVec3, Mesh};
use plateau_strict_json::rejection::{FieldError, Rejection};
use std::collections::BTreeMap;

const POINTER: &str = "/initial_mesh/glb";

/// Largest size of a file in bytes, for each triangle that a mesh may have. A triangle of a closed mesh has 12 bytes of
/// indices and half a vertex. A vertex has 12 bytes of position and rarely more than 100 bytes of other attributes. The
/// next constant is the allowance for the file's JSON document.
const BYTES_PER_TRIANGLE: usize = 128;
const BYTES_OF_DOCUMENT: usize = 16 << 20;

/// Largest distance at which a boundary vertex moves to a point of the request, as a multiple of the rounding of the
/// file's numbers. The program that wrote the file has rounded once, and maybe again when it moved the mesh.
const ROUNDINGS: f64 = 4.0;

/// Largest number of vertices that are compared with one boundary point. A mesh with more is finer than the rounding of
/// its numbers, and no solver could use it.
const MOST_NEAR: usize = 64;

/// Reads the mesh of a request with these boundaries, units and axis.
///
/// # Errors
/// Returns [`Rejection`] at the file.
pub(super) fn read(
    glb: &str,
    boundaries: &[Vec<DVec3>],
    (unit, up): (Unit, UpAxis),
    limits: &Limits,
) -> Result<Mesh, Rejection> {
    let invalid = |detail: String| Rejection::Invalid(vec![FieldError::new(POINTER, detail)]);
    let too_large = |detail: String| Rejection::TooLarge(vec![FieldError::new(POINTER, detail)]);
    let most = limits.triangles.saturating_mul(BYTES_PER_TRIANGLE).saturating_add(BYTES_OF_DOCUMENT);
    if glb.len() / 4 * 3 > most {
        return Err(too_large(format!("is a file of more bytes than are allowed ({most})")));
    }
    let file = base64::engine::general_purpose::STANDARD.decode(glb);
    let file = file.map_err(|error| invalid(format!("is not base64: {error}")))?;
    let Triangles { mut mesh, rounding } =
        glb::read(&file, unit, up, limits.triangles).map_err(|refusal| match refusal {
            GlbError::Invalid(detail) => invalid(detail),
            GlbError::TooLarge => too_large(format!("is larger than is allowed ({} triangles)", limits.triangles)),
        })?;
    restore(&mut mesh, boundaries, ROUNDINGS * rounding).map_err(invalid)?;
    Ok(mesh)
}

/// Moves errors about single vertices and triangles of the mesh to the file, because a request with a file has no such
/// members.
pub(super) fn at_the_file(rejection: Rejection) -> Rejection {
    let led = |FieldError { pointer, detail }: FieldError| {
        let place = pointer.strip_prefix("/initial_mesh").map(|inner| inner.trim_start_matches('/').replace('/', " "));
        match place {
            Some(place) if place.is_empty() => FieldError::new(POINTER, detail),
            Some(place) => FieldError::new(POINTER, format!("{detail} ({place}, with equal vertices counted once)")),
            None => FieldError { pointer, detail },
        }
    };
    match rejection {
        Rejection::Invalid(errors) => Rejection::Invalid(errors.into_iter().map(led).collect()),
        Rejection::TooLarge(errors) => Rejection::TooLarge(errors.into_iter().map(led).collect()),
        malformed @ Rejection::Malformed(_) => malformed,
    }
}

/// Moves boundary vertices to the points of `boundaries` that are within the tolerance, and the boundary vertices
/// between two moved vertices onto the straight line between them. O(n log n) in the number of triangles.
fn restore(mesh: &mut Mesh, boundaries: &[Vec<DVec3>], tolerance: f64) -> Result<(), String> {
    if tolerance <= 0.0 {
        return Ok(());
    }
    let neighbours = boundary_neighbours(&mesh.triangles);
    let cell = |p: DVec3| (p / tolerance).floor();
    let mut cells: BTreeMap<[u64; 3], Vec<u32>> = BTreeMap::new();
    for &v in neighbours.keys() {
        cells.entry(position_key(cell(mesh.vertices[v as usize]))).or_default().push(v);
    }
    let mut is_restored = vec![false; mesh.vertices.len()];
    let around = [-1.0, 0.0, 1.0];
    for &point in boundaries.iter().flatten() {
        let own = cell(point);
        let offsets =
            around.iter().flat_map(|&i| around.iter().flat_map(move |&j| around.map(|k| DVec3::new(i, j, k))));
        let near = offsets.filter_map(|offset| cells.get(&position_key(own + offset)));
        let near: Vec<u32> = near.flatten().copied().collect();
        if near.len() > MOST_NEAR {
            return Err(format!(
                "has more than {MOST_NEAR} vertices within the rounding of its numbers ({tolerance:.1e})"
            ));
        }
        let distance = |v: u32| mesh.vertices[v as usize].distance(point);
        let free = near.into_iter().filter(|&v| !is_restored[v as usize] && distance(v) <= tolerance);
        // Of equally near vertices the one with the smallest number is taken.
        if let Some(v) = free.min_by(|&a, &b| distance(a).total_cmp(&distance(b)).then(a.cmp(&b))) {
            mesh.vertices[v as usize] = point;
            is_restored[v as usize] = true;
        }
    }
    straighten(mesh, &neighbours, &is_restored, tolerance);
    Ok(())
}

/// Moves the boundary vertices between two neighbouring restored vertices onto the straight line through both, if they
/// are within the tolerance.
fn straighten(mesh: &mut Mesh, neighbours: &BTreeMap<u32, Vec<u32>>, is_restored: &[bool], tolerance: f64) {
    let starts: Vec<u32> = (0..is_restored.len() as u32).filter(|&v| is_restored[v as usize]).collect();
    for start in starts {
        for &first in &neighbours[&start] {
            let mut chain = Vec::new();
            let (mut before, mut at) = (start, first);
            while !is_restored[at as usize] && at != start {
                chain.push(at);
                // A vertex where more than two edges of the boundary meet ends the chain.
                let [a, b] = neighbours[&at][..] else { break };
                (before, at) = (at, if a == before { b } else { a });
            }
            // Each chain is found from both ends. It is handled from the end with the smaller number.
            if !is_restored[at as usize] || at < start {
                continue;
            }
            let (from, to) = (mesh.vertices[start as usize], mesh.vertices[at as usize]);
            let along = (to - from).normalize_or_zero();
            for v in chain {
                let vertex = &mut mesh.vertices[v as usize];
                let foot = from + along * (*vertex - from).dot(along);
                if foot.distance(*vertex) <= tolerance {
                    *vertex = foot;
                }
            }
        }
    }
}

/// Returns the vertices on the boundary, each with its neighbours along the edges that have one triangle.
fn boundary_neighbours(triangles: &[[u32; 3]]) -> BTreeMap<u32, Vec<u32>> {
    let sides = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]);
    let mut edges: Vec<[u32; 2]> = triangles.iter().flat_map(sides).collect();
    edges.sort_unstable();
    let mut neighbours: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for group in edges.chunk_by(|a, b| a == b) {
        if let &[[a, b]] = group {
            neighbours.entry(a).or_default().push(b);
            neighbours.entry(b).or_default().push(a);
        }
    }
    neighbours
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_boundary_takes_the_exact_places_and_straight_lines_of_the_request() {
        // A square whose lower edge has two further vertices, off by a rounding.
        let off = 1e-8;
        let corners = [[0.0, off], [1.0, -off], [1.0, 1.0], [0.0, 1.0 - off], [0.3, off], [0.7, -off], [0.5, 0.5]];
        let vertices = corners.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        let triangles = vec![[0, 4, 6], [4, 5, 6], [5, 1, 6], [1, 2, 6], [2, 3, 6], [3, 0, 6]];
        let mut mesh = Mesh::new(vertices.clone(), triangles);
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        restore(&mut mesh, &[square.to_vec()], 4.0 * off).unwrap();
        assert_eq!(mesh.vertices[..4], square);
        assert_eq!((mesh.vertices[4].y, mesh.vertices[5].y), (0.0, 0.0));
        assert_eq!(mesh.vertices[6], vertices[6]);
        // A vertex that is further from its point than the tolerance stays where it is.
        let mut mesh = Mesh::new(vertices.clone(), mesh.triangles);
        restore(&mut mesh, &[square.to_vec()], 0.5 * off).unwrap();
        assert_eq!(mesh.vertices[0], vertices[0]);
    }
}
