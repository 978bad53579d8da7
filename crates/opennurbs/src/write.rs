//! Writes polyline curves and meshes.

use super::chunk::Writer;
use super::{class, code};
use plateau_mesh::DVec3;

/// Value that openNURBS stores for a coordinate that is not known.
const UNSET: f64 = -1.234_321_012_343_21e308;

/// Returns a polyline curve as an object. The parameter at each point is the number of the point. A closed curve
/// repeats its first point.
#[must_use]
pub fn polyline_curve(points: &[DVec3]) -> Vec<u8> {
    object(class::POLYLINE_CURVE, |out| {
        out.u8(0x10);
        out.u32(points.len() as u32);
        points.iter().for_each(|point| vector(out, *point));
        out.u32(points.len() as u32);
        (0..points.len()).for_each(|number| out.f64(number as f64));
        out.u32(3);
    })
}

/// Returns a triangle mesh as an object, with vertices in double precision and with vertex normals. Coordinates must be
/// in the range of f32, because the format has both precisions.
#[must_use]
pub fn mesh(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Vec<u8> {
    object(class::MESH, |out| {
        out.u8(0x38);
        out.u32(vertices.len() as u32);
        out.u32(triangles.len() as u32);
        // Domains of texture coordinates and of the surface: not known.
        (0..8).for_each(|_| out.f64(UNSET));
        (0..2).for_each(|_| out.f64(0.0));
        // Boxes of the vertices, normals and texture coordinates. A box whose minimum exceeds its maximum is not known.
        for corner in [1.0_f32, -1.0, 1.0, -1.0] {
            (0..3).for_each(|_| out.raw(&corner.to_le_bytes()));
        }
        for corner in [1.0_f32, 1.0, -1.0, -1.0] {
            out.raw(&corner.to_le_bytes());
        }
        // Whether the mesh is closed is not known.
        out.u32(u32::MAX);
        // Meshing parameters and four curvature statistics: none.
        out.raw(&[0; 5]);
        faces(out, vertices.len(), triangles);
        let single: Vec<u8> = vertices.iter().flat_map(|vertex| f32_bytes(*vertex)).collect();
        buffer(out, &single);
        let normals: Vec<u8> = normals(vertices, triangles).into_iter().flat_map(f32_bytes).collect();
        buffer(out, &normals);
        // Texture coordinates, curvatures and colours: none.
        (0..3).for_each(|_| buffer(out, &[]));
        // Rotation of the texture, identifier of its mapping, and surface parameters: none.
        out.raw(&[0; 20]);
        buffer(out, &[]);
        out.chunk(code::ANONYMOUS, texture_mapping);
        // Whether the mesh is manifold, oriented and solid is not known.
        out.raw(&[0; 3]);
        // There are no polygons of more than four vertices, and there are vertices in double precision.
        out.raw(&[0, 1]);
        out.chunk(code::ANONYMOUS, |out| {
            out.u32(1);
            out.u32(0);
            out.u32(vertices.len() as u32);
            let double: Vec<u8> =
                vertices.iter().flat_map(|vertex| vertex.to_array()).flat_map(f64::to_le_bytes).collect();
            buffer(out, &double);
        });
        (0..6).for_each(|_| out.f64(UNSET));
    })
}

fn object(class: [u8; 16], data: impl FnOnce(&mut Writer)) -> Vec<u8> {
    let mut out = Writer::default();
    out.chunk(code::OBJECT, |out| {
        out.chunk(code::CLASS_ID, |out| out.raw(&class));
        out.chunk(code::CLASS_DATA, data);
        out.chunk(code::CLASS_END, |_| {});
    });
    out.into_bytes()
}

fn vector(out: &mut Writer, vector: DVec3) {
    vector.to_array().into_iter().for_each(|coordinate| out.f64(coordinate));
}

fn f32_bytes(vector: DVec3) -> impl Iterator<Item = u8> {
    vector.to_array().into_iter().flat_map(|coordinate| (coordinate as f32).to_le_bytes())
}

/// Writes faces with indices as short as the number of vertices allows. A triangle repeats its last vertex.
fn faces(out: &mut Writer, vertices: usize, triangles: &[[u32; 3]]) {
    let index_bytes = match vertices {
        0..256 => 1,
        256..65_536 => 2,
        _ => 4,
    };
    out.u32(index_bytes as u32);
    for &[a, b, c] in triangles {
        for index in [a, b, c, c] {
            out.raw(&index.to_le_bytes()[..index_bytes]);
        }
    }
}

/// Writes a buffer without compression: its length, its checksum, the method 0, and the bytes.
fn buffer(out: &mut Writer, bytes: &[u8]) {
    out.u32(bytes.len() as u32);
    if !bytes.is_empty() {
        out.u32(crc32fast::hash(bytes));
        out.u8(0);
        out.raw(bytes);
    }
}

/// Writes an empty texture mapping: version 1.1, no identifier, no checksum of a mapping, and the identity matrix.
fn texture_mapping(out: &mut Writer) {
    out.u32(1);
    out.u32(1);
    out.raw(&[0; 20]);
    for row in 0..4 {
        (0..4).for_each(|column| out.f64(if row == column { 1.0 } else { 0.0 }));
    }
    out.u32(0);
}

/// Returns unit normals at the vertices, weighted by area. A vertex without an area around it gets the z axis, because
/// readers demand unit vectors.
fn normals(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; vertices.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|vertex| vertices[vertex as usize]);
        let normal = (b - a).cross(c - a);
        triangle.iter().for_each(|&vertex| normals[vertex as usize] += normal);
    }
    normals.into_iter().map(|normal| normal.try_normalize().unwrap_or(DVec3::Z)).collect()
}
