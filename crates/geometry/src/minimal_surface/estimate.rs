//! About how large a mesh will be, before any work.

use super::options::{InitialMesh, Options, Resolution};
use crate::DVec3;

/// Number of triangles, roughly, for each boundary point where the points are much closer than the edge length.
const TRIANGLES_PER_POINT: f64 = 12.0;

/// About how many triangles a request asks for, so that a service can price it before the work.
///
/// Exact where a count is asked for; for an edge length the area of the boundaries' fans about their means is divided
/// by that of an equilateral triangle (but the boundary's own points ask for some each), which is right within a small
/// factor unless the boundaries are far apart.
#[must_use]
pub fn estimate_triangles(boundaries: &[Vec<DVec3>], options: &Options) -> f64 {
    let points: usize = boundaries.iter().map(Vec::len).sum();
    if let InitialMesh::Given(mesh) = &options.initial_mesh {
        return mesh.triangles.len() as f64;
    }
    match options.resolution {
        Resolution::Triangles(count) => count as f64,
        Resolution::InteriorVertices(count) => (2 * count + points) as f64,
        Resolution::EdgeLength(length) => {
            triangles_of_length(boundaries, length).max(TRIANGLES_PER_POINT * points as f64)
        }
    }
}

/// How many equilateral triangles of an edge length cover the boundaries' fans.
pub(crate) fn triangles_of_length(boundaries: &[Vec<DVec3>], length: f64) -> f64 {
    area_of_fans(boundaries) / (length * length * 0.75_f64.sqrt() * 0.5)
}

/// The area of all boundaries' fans about the mean of their points.
pub(crate) fn area_of_fans(boundaries: &[Vec<DVec3>]) -> f64 {
    let all: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
    let centre = crate::polyline::mean(&all);
    let fans = boundaries.iter().flat_map(|boundary| {
        let next = boundary.iter().cycle().skip(1);
        boundary.iter().zip(next).map(|(&a, &b)| 0.5 * (a - centre).cross(b - centre).length())
    });
    fans.sum()
}
