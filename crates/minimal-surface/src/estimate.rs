//! Estimates the size of a mesh before it is made.

use super::options::{InitialMesh, Method, Options, Resolution};
use plateau_mesh::{DVec3, Estimate};

/// Lower bound of the estimated number of triangles, per boundary point. It takes effect where the boundary points are
/// much closer together than the edge length.
const TRIANGLES_PER_POINT: f64 = 12.0;

/// Memory that each of the first [`FIRST_TRIANGLES`] takes in addition, in bytes, because a small film takes more per
/// triangle. Films of 10,000 triangles take 6 to 14 MB.
const BYTES_PER_FIRST_TRIANGLE: f64 = 600.0;
const FIRST_TRIANGLES: f64 = 10_000.0;

/// Memory per triangle, in bytes, for the objectives area and Dirichlet energy. Measured: 490 to 790 bytes at 40,000 and
/// 120,000 triangles. Most of it is for sparse factors, whose size depends on the shape of the boundary.
const BYTES_PER_TRIANGLE: f64 = 780.0;

/// Memory per triangle, in bytes, for the relaxation of one vertex at a time, which has no sparse factors. Measured: 200
/// to 250 bytes at 40,000 and 120,000 triangles.
const BYTES_PER_TRIANGLE_OF_RELAXATION: f64 = 285.0;

/// Memory per triangle, in bytes, for the least squares of the mean curvatures. Measured: 6,740 bytes. It is more than
/// for the other objectives because the normal matrix also connects neighbours of neighbours.
const BYTES_PER_TRIANGLE_OF_LEAST_SQUARES: f64 = 8_000.0;

/// Estimates the triangles of the result and the memory that solving takes. O(points).
///
/// The number of triangles is exact if the request names a number of triangles. For an edge length the estimate is the
/// area of the fans from the boundaries to their common mean, divided by the area of an equilateral triangle, and at
/// least 12 for each boundary point. This estimate is right within a small factor unless the boundaries are far apart.
#[must_use]
pub fn estimate(boundaries: &[Vec<DVec3>], options: &Options) -> Estimate {
    let triangles = triangles(boundaries, options);
    let a_triangle = match options.method {
        Method::Newton(_) | Method::PinkallPolthier(_) | Method::Harmonic => BYTES_PER_TRIANGLE,
        Method::VertexRelaxation(_) => BYTES_PER_TRIANGLE_OF_RELAXATION,
        Method::LiuWang(_) => BYTES_PER_TRIANGLE_OF_LEAST_SQUARES,
    };
    let first = BYTES_PER_FIRST_TRIANGLE * triangles.min(FIRST_TRIANGLES);
    Estimate { triangles, cells: 0, bytes: (triangles * a_triangle + first) as u64 }
}

fn triangles(boundaries: &[Vec<DVec3>], options: &Options) -> f64 {
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

/// Number of equilateral triangles of an edge length that cover the fans of the boundaries.
pub(crate) fn triangles_of_length(boundaries: &[Vec<DVec3>], length: f64) -> f64 {
    area_of_fans(boundaries) / (length * length * 0.75_f64.sqrt() * 0.5)
}

/// Area of the fans from all boundaries to the mean of all points.
pub(crate) fn area_of_fans(boundaries: &[Vec<DVec3>]) -> f64 {
    let all: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
    let centre = plateau_mesh::polyline::mean(&all);
    let fans = boundaries.iter().flat_map(|boundary| {
        let next = boundary.iter().cycle().skip(1);
        boundary.iter().zip(next).map(|(&a, &b)| 0.5 * (a - centre).cross(b - centre).length())
    });
    fans.sum()
}
