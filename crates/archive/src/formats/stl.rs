//! Binary STL in the client's axes and unit. The format has only f32 and no origin, so coordinates far from zero lose
//! digits. A mesh that is too far from zero is therefore written around the middle of its bounding box, unless the
//! client asks for the given coordinates. OBJ and PLY keep all digits.

use plateau_mesh::DVec3;
use plateau_mesh::measure;

use super::{Choices, Error, Origin};
use crate::archive::Archive;

/// Writes the triangles in archive order. Their unit normals come from the f64 corners, and are zero for triangles
/// without area.
///
/// # Errors
/// Returns [`Error::OutOfRange`] if a coordinate exceeds f32, and [`Error::NoTriangles`] for a cable net.
pub fn to_stl(archive: &Archive, choices: Choices) -> Result<Vec<u8>, Error> {
    let contents = archive.contents();
    let mesh = &contents.mesh;
    if mesh.triangles.is_empty() {
        return Err(Error::NoTriangles { format: "STL" });
    }
    let local = match choices.origin {
        Origin::Local => true,
        Origin::Given => false,
        Origin::Automatic => contents.is_far_from_zero(),
    };
    let shift = if local { contents.origin() } else { DVec3::ZERO };
    let beyond = |&v: &DVec3| (v - shift).abs().max_element() > f64::from(f32::MAX);
    if mesh.vertices.iter().any(beyond) {
        return Err(Error::OutOfRange { format: "STL", detail: "a coordinate is beyond 3e38" });
    }
    let count = u32::try_from(mesh.triangles.len()).expect("an archive has at most 2^32 triangles");
    // The header must not start with "solid", because readers would take the file for the text format.
    let mut header = [b' '; 80];
    let origin = if local { ", local origin" } else { "" };
    let text = format!("binary STL, unit {}, {} up{origin}", contents.unit.symbol(), contents.up.symbol());
    header[..text.len()].copy_from_slice(text.as_bytes());

    let mut out = Vec::with_capacity(84 + 50 * mesh.triangles.len());
    out.extend_from_slice(&header);
    out.extend_from_slice(&count.to_le_bytes());
    for &triangle in &mesh.triangles {
        let corners = mesh.corners(triangle).map(|corner| corner - shift);
        for vector in std::iter::once(unit_normal(corners)).chain(corners) {
            vector.to_array().iter().for_each(|&x| out.extend_from_slice(&(x as f32).to_le_bytes()));
        }
        out.extend_from_slice(&[0, 0]);
    }
    Ok(out)
}

/// Returns the unit normal of a triangle, which is first scaled to size 1, so that no square overflows or becomes zero.
fn unit_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    let extent = (b - a).abs().max((c - a).abs()).max_element();
    if extent > 0.0 {
        measure::double_area_vector([DVec3::ZERO, (b - a) / extent, (c - a) / extent]).normalize_or_zero()
    } else {
        DVec3::ZERO
    }
}
