//! Reads curves and meshes. Any bytes are safe to read: the memory used is at most a small multiple of their length, or
//! of `max_points`, and the time is linear in both.

use super::chunk::Reader;
use super::curve::{Arc, Curve, Nurbs};
use super::{Defect, Mesh, Object, class, code};
use plateau_mesh::DVec3;
use std::io::Read as _;

/// Largest depth of polycurves inside polycurves. Rhino itself removes such nesting.
const MAX_DEPTH: usize = 8;
/// Largest degree of a NURBS curve. Rhino's own limit is 11.
const MAX_DEGREE: usize = 32;

/// Reads an object.
///
/// # Errors
/// Returns [`Defect`] if the bytes are not an object, are damaged, or are of another class. A mesh of more than
/// `max_points` vertices is [`Defect::TooLarge`].
pub fn object(bytes: &[u8], max_points: usize) -> Result<Object, Defect> {
    next_object(&mut Reader::new(bytes), max_points, 0)
}

fn next_object(reader: &mut Reader<'_>, max_points: usize, depth: usize) -> Result<Object, Defect> {
    let (found, mut parts) = reader.chunk()?;
    if found != code::OBJECT {
        return Err(Defect::Structure("it does not begin with an object"));
    }
    let mut identity = parts.chunk_of(code::CLASS_ID)?;
    let class: [u8; 16] = identity.array()?;
    identity.finish()?;
    let mut data = parts.chunk_of(code::CLASS_DATA)?;
    let object = match class {
        class::POLYLINE_CURVE => Object::Curve(polyline_curve(&mut data)?),
        class::LINE_CURVE => Object::Curve(line_curve(&mut data)?),
        class::NURBS_CURVE => Object::Curve(nurbs_curve(&mut data)?),
        class::ARC_CURVE => Object::Curve(arc_curve(&mut data)?),
        class::POLY_CURVE => Object::Curve(poly_curve(&mut data, max_points, depth)?),
        class::MESH => Object::Mesh(mesh(&mut data, max_points)?),
        other => {
            let known = class::OTHERS.iter().find(|(first, _)| other.starts_with(first));
            let what = known.map_or("an object of another class", |(_, name)| name);
            let article = if known.is_some() { "a " } else { "" };
            return Err(Defect::Unsupported(format!("is {article}{what}, and this server reads curves and meshes")));
        }
    };
    data.finish()?;
    // User data may follow. It is skipped up to the end mark.
    while !parts.is_empty() && parts.chunk()?.0 != code::CLASS_END {}
    Ok(object)
}

fn vector(bytes: &[u8]) -> DVec3 {
    let number = |at: usize| bytes[at..].first_chunk().map_or(f64::NAN, |bytes| f64::from_le_bytes(*bytes));
    DVec3::new(number(0), number(8), number(16))
}

/// Reads a point or a vector.
fn point(data: &mut Reader<'_>) -> Result<DVec3, Defect> {
    finite(vector(data.bytes(24)?))
}

fn finite(point: DVec3) -> Result<DVec3, Defect> {
    if point.is_finite() { Ok(point) } else { Err(Defect::Unusable("has a coordinate that is not a finite number")) }
}

fn polyline_curve(data: &mut Reader<'_>) -> Result<Curve, Defect> {
    data.version("polyline curve", 1)?;
    let count = data.count()?;
    let points: Vec<DVec3> = data.items(count, 24)?.map(|bytes| finite(vector(bytes))).collect::<Result<_, _>>()?;
    // The parameters of the points and the dimension follow. They are not read, because they do not change the curve in
    // space.
    if points.len() < 2 { Err(Defect::Unusable("has fewer than two points")) } else { Ok(Curve::Polyline(points)) }
}

fn line_curve(data: &mut Reader<'_>) -> Result<Curve, Defect> {
    data.version("line", 1)?;
    Ok(Curve::Polyline(vec![point(data)?, point(data)?]))
}

fn arc_curve(data: &mut Reader<'_>) -> Result<Curve, Defect> {
    data.version("arc", 1)?;
    let [centre, x, y, _] = [point(data)?, point(data)?, point(data)?, point(data)?];
    // The plane's equation is skipped.
    data.bytes(32)?;
    let radius = data.f64()?;
    // Three points of the circle are skipped.
    data.bytes(72)?;
    let angles = [data.f64()?, data.f64()?];
    let unit = |vector: DVec3| (vector.length() - 1.0).abs() < 1e-6;
    let turn = angles[1] - angles[0];
    if !(radius > 0.0 && radius.is_finite() && unit(x) && unit(y) && turn > 0.0 && turn < 7.0 && angles[0].is_finite())
    {
        return Err(Defect::Unusable("is an arc without a plane, a radius or a length"));
    }
    Ok(Curve::Arc(Arc { centre, x, y, radius, angles }))
}

fn nurbs_curve(data: &mut Reader<'_>) -> Result<Curve, Defect> {
    data.version("NURBS curve", 1)?;
    let [dimension, rational, order, points] = [data.count()?, data.count()?, data.count()?, data.count()?];
    // Two reserved numbers and a box.
    data.bytes(8 + 48)?;
    if !(2..=3).contains(&dimension) || rational > 1 {
        return Err(Defect::Unusable("is a NURBS curve of neither two nor three dimensions"));
    }
    if !(2..=MAX_DEGREE + 1).contains(&order) || points < order {
        return Err(Defect::Unusable("is a NURBS curve with too few points, or of too high a degree"));
    }
    let number = |bytes: &[u8]| bytes.first_chunk().map_or(f64::NAN, |bytes| f64::from_le_bytes(*bytes));
    let knots = data.count()?;
    if knots != order + points - 2 {
        return Err(Defect::Structure("a NURBS curve with a wrong number of knots"));
    }
    let knots: Vec<f64> = data.items(knots, 8)?.map(number).collect();
    if data.count()? != points {
        return Err(Defect::Structure("a NURBS curve with a wrong number of points"));
    }
    let row = |bytes: &[u8]| {
        let mut row: Vec<f64> = bytes.chunks_exact(8).map(number).collect();
        let weight = if rational == 1 { row.pop().unwrap_or(1.0) } else { 1.0 };
        row.resize(3, 0.0);
        [row[0], row[1], row[2], weight]
    };
    let points: Vec<[f64; 4]> = data.items(points, 8 * (dimension + rational))?.map(row).collect();
    Nurbs::new(order - 1, knots, points).map(Curve::Nurbs)
}

fn poly_curve(data: &mut Reader<'_>, max_points: usize, depth: usize) -> Result<Curve, Defect> {
    if depth == MAX_DEPTH {
        return Err(Defect::Unusable("has polycurves in polycurves more than 8 deep"));
    }
    data.version("polycurve", 1)?;
    let segments = data.count()?;
    // Two reserved numbers and a box.
    data.bytes(8 + 48)?;
    let parameters = data.count()?;
    let _ = data.items(parameters, 8)?;
    let mut curves = Vec::new();
    for _ in 0..segments {
        match next_object(data, max_points, depth + 1)? {
            Object::Curve(curve) => curves.push(curve),
            Object::Mesh(_) => return Err(Defect::Structure("a polycurve with a part that is no curve")),
        }
    }
    if curves.is_empty() { Err(Defect::Unusable("is a polycurve without parts")) } else { Ok(Curve::Poly(curves)) }
}

fn mesh(data: &mut Reader<'_>, max_points: usize) -> Result<Mesh, Defect> {
    let minor = data.version("mesh", 3)?;
    let (vertices, faces) = (data.count()?, data.count()?);
    if vertices > max_points {
        return Err(Defect::TooLarge(max_points));
    }
    // Domains, scales, boxes, and whether the mesh is closed: all are skipped.
    data.bytes(80 + 64 + 4)?;
    // Meshing parameters and four curvature statistics are skipped.
    for _ in 0..5 {
        if data.u8()? != 0 {
            data.chunk_of(code::ANONYMOUS)?;
        }
    }
    let faces = read_faces(data, vertices, faces)?;
    if vertices == 0 || faces.is_empty() {
        return Err(Defect::Unusable("is a mesh without faces"));
    }
    let single = Buffer::next(data)?;
    // Normals, texture coordinates, curvatures and colours are skipped.
    for _ in 0..4 {
        Buffer::next(data)?;
    }
    let mut double = None;
    if minor >= 2 {
        data.bytes(4)?;
    }
    if minor >= 3 {
        data.bytes(16)?;
        Buffer::next(data)?;
    }
    if minor >= 4 {
        data.chunk_of(code::ANONYMOUS)?;
    }
    if minor >= 5 {
        data.bytes(3)?;
    }
    if minor >= 6 && data.u8()? != 0 {
        data.chunk_of(code::ANONYMOUS)?;
    }
    if minor >= 7 && data.u8()? != 0 {
        let mut chunk = data.chunk_of(code::ANONYMOUS)?;
        let [major, _] = [chunk.u32()?, chunk.u32()?];
        if major == 1 && chunk.count()? == vertices {
            double = Some(Buffer::next(&mut chunk)?);
            chunk.finish()?;
        }
    }
    let vertices: Vec<DVec3> = match double {
        Some(buffer) => {
            let bytes = buffer.bytes(24 * vertices)?;
            bytes.chunks_exact(24).map(|bytes| finite(vector(bytes))).collect::<Result<_, _>>()?
        }
        None => {
            let bytes = single.bytes(12 * vertices)?;
            let number =
                |bytes: &[u8]| f64::from(bytes.first_chunk().map_or(f32::NAN, |bytes| f32::from_le_bytes(*bytes)));
            let point = |bytes: &[u8]| DVec3::new(number(bytes), number(&bytes[4..]), number(&bytes[8..]));
            bytes.chunks_exact(12).map(|bytes| finite(point(bytes))).collect::<Result<_, _>>()?
        }
    };
    Ok(Mesh { vertices, faces })
}

fn read_faces(data: &mut Reader<'_>, vertices: usize, faces: usize) -> Result<Vec<[u32; 4]>, Defect> {
    let index_bytes = data.count()?;
    if ![1, 2, 4].contains(&index_bytes) {
        return Err(Defect::Structure("indices of faces with another size than 1, 2 or 4 bytes"));
    }
    let face = |bytes: &[u8]| {
        let index = |corner: usize| {
            let bytes = &bytes[corner * index_bytes..][..index_bytes];
            bytes.iter().rev().fold(0_u32, |index, &byte| index << 8 | u32::from(byte))
        };
        let face = [index(0), index(1), index(2), index(3)];
        let exists = face.iter().all(|&vertex| (vertex as usize) < vertices);
        if exists { Ok(face) } else { Err(Defect::Structure("a face of a vertex that does not exist")) }
    };
    data.items(faces, 4 * index_bytes)?.map(face).collect()
}

/// A buffer whose bytes have not been decompressed yet.
struct Buffer<'a> {
    length: usize,
    checksum: u32,
    content: Content<'a>,
}

enum Content<'a> {
    Raw(&'a [u8]),
    Deflated(&'a [u8]),
}

impl<'a> Buffer<'a> {
    /// Reads the next buffer without decompressing its bytes.
    fn next(data: &mut Reader<'a>) -> Result<Self, Defect> {
        let length = data.u32()? as usize;
        if length == 0 {
            return Ok(Self { length, checksum: 0, content: Content::Raw(&[]) });
        }
        let checksum = data.u32()?;
        let content = match data.u8()? {
            0 => Content::Raw(data.bytes(length)?),
            1 => {
                let mut chunk = data.chunk_of(code::ANONYMOUS)?;
                let bytes = chunk.rest()?;
                chunk.finish()?;
                Content::Deflated(bytes)
            }
            _ => return Err(Defect::Structure("an unknown compression")),
        };
        Ok(Self { length, checksum, content })
    }

    /// Returns the decompressed bytes. Fails if their number is not `wanted`.
    fn bytes(self, wanted: usize) -> Result<Vec<u8>, Defect> {
        if self.length != wanted {
            return Err(Defect::Structure("a mesh with a wrong number of coordinates"));
        }
        let bytes = match self.content {
            Content::Raw(bytes) => bytes.to_vec(),
            Content::Deflated(bytes) => {
                let mut inflated = Vec::new();
                // At most one byte more than wanted is decompressed, which shows that there are too many.
                let mut limited = flate2::read::ZlibDecoder::new(bytes).take(wanted as u64 + 1);
                limited.read_to_end(&mut inflated).map_err(|_| Defect::Structure("compressed bytes are damaged"))?;
                inflated
            }
        };
        if bytes.len() != wanted {
            return Err(Defect::Truncated);
        }
        if crc32fast::hash(&bytes) == self.checksum { Ok(bytes) } else { Err(Defect::Checksum) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chunk::Writer;

    /// Returns a mesh as Rhino 5 writes it: version 3.5, which ends before the vertices in double precision.
    fn mesh_of_rhino_5() -> Vec<u8> {
        let mut out = Writer::default();
        out.chunk(code::OBJECT, |out| {
            out.chunk(code::CLASS_ID, |out| out.raw(&class::MESH));
            out.chunk(code::CLASS_DATA, |out| {
                out.u8(0x35);
                out.u32(3);
                out.u32(1);
                out.raw(&[0; 148]);
                // Meshing parameters are a chunk of their own, and there are no statistics of curvature.
                out.u8(1);
                out.chunk(code::ANONYMOUS, |out| out.raw(&[7; 9]));
                out.raw(&[0; 4]);
                out.u32(1);
                out.raw(&[0, 1, 2, 2]);
                let bytes: Vec<u8> = [0.5_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.1].map(f32::to_le_bytes).concat();
                out.u32(36);
                out.u32(crc32fast::hash(&bytes));
                out.u8(0);
                out.raw(&bytes);
                out.raw(&[0; 16]);
                out.raw(&[0; 24]);
                out.chunk(code::ANONYMOUS, |out| out.raw(&[0; 160]));
                out.raw(&[0; 3]);
            });
            out.chunk(code::CLASS_END, |_| {});
        });
        out.into_bytes()
    }

    #[test]
    fn vertices_in_single_precision_are_read_if_there_are_no_others() {
        let bytes = mesh_of_rhino_5();
        let Object::Mesh(mesh) = object(&bytes, 3).unwrap() else { panic!("a mesh") };
        assert_eq!(mesh.vertices[2], DVec3::new(0.0, 1.0, f64::from(0.1_f32)));
        assert_eq!(mesh.faces, [[0, 1, 2, 2]]);
        assert_eq!(object(&bytes, 2), Err(Defect::TooLarge(2)));
    }
}
