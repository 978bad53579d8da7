//! Binary little-endian PLY in the client's axes and unit. Coordinates are `double`, and `mean_curvature` (1/unit) and
//! `lower_bound_slack` are included if known.

use super::archive::Archive;
use super::obj::one_line;

/// Writes the vertices and triangles in archive order.
#[must_use]
pub fn to_ply(archive: &Archive) -> Vec<u8> {
    let contents = archive.contents();
    let (vertices, triangles) = (&contents.mesh.vertices, &contents.mesh.triangles);
    let curvature = contents.mean_curvature.as_ref().map(|curvature| ("mean_curvature", curvature.values.as_slice()));
    let slack = contents.certificate.as_ref().map(|proof| ("lower_bound_slack", proof.slack.as_slice()));
    let properties: Vec<(&str, &[f64])> = [curvature, slack].into_iter().flatten().collect();
    let mut header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment {}\ncomment unit {}, {} up\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
        one_line(&contents.generator),
        contents.unit.symbol(),
        contents.up.symbol(),
        vertices.len(),
    );
    for (name, _) in &properties {
        header.push_str(&format!("property double {name}\n"));
    }
    header
        .push_str(&format!("element face {}\nproperty list uchar uint vertex_indices\nend_header\n", triangles.len()));

    let mut out = header.into_bytes();
    out.reserve(32 * vertices.len() + 13 * triangles.len());
    for (index, vertex) in vertices.iter().enumerate() {
        vertex.to_array().iter().for_each(|x| out.extend_from_slice(&x.to_le_bytes()));
        for (_, values) in &properties {
            out.extend_from_slice(&values[index].to_le_bytes());
        }
    }
    for triangle in triangles {
        out.push(3);
        triangle.iter().for_each(|v| out.extend_from_slice(&v.to_le_bytes()));
    }
    out
}
