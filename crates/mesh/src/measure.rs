//! Areas, normals, edge lengths, angles, flipped and degenerate triangles of a mesh.

use crate::topology::Topology;
use crate::{DVec3, Mesh};

/// A triangle is degenerate if its shortest altitude is below this fraction of its longest edge.
pub const DEGENERATE_ALTITUDE: f64 = 1e-10;

/// Minimum, mean, maximum and standard deviation (of the whole population) of a list of values.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Spread {
    /// Number of values. It is not serialised.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub count: usize,
    /// The least value.
    pub min: f64,
    /// The mean.
    pub mean: f64,
    /// The largest value.
    pub max: f64,
    /// Standard deviation of the whole population.
    pub std_dev: f64,
}

impl Spread {
    /// The spread of these values. All figures are zero if there are no values.
    #[inline]
    pub fn of(values: impl Iterator<Item = f64> + Clone) -> Self {
        let (count, sum, min, max) =
            values.clone().fold((0usize, 0.0, f64::INFINITY, f64::NEG_INFINITY), |(n, sum, min, max), value| {
                (n + 1, sum + value, f64::min(min, value), f64::max(max, value))
            });
        if count == 0 {
            return Self::default();
        }
        let mean = sum / count as f64;
        let variance = values.map(|value| (value - mean) * (value - mean)).sum::<f64>() / count as f64;
        Self { count, min, mean, max, std_dev: variance.sqrt() }
    }
}

/// The quality of the triangles of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Lengths of all edges.
    pub edge_lengths: Spread,
    /// Smallest and largest inner angle of a triangle, radians.
    pub angles: (f64, f64),
    /// Number of triangles whose normal points against the sum of their three vertex normals.
    pub flipped_triangles: usize,
    /// Number of triangles whose shortest altitude is below 1e-10 of their longest edge.
    pub degenerate_triangles: usize,
}

impl Quality {
    /// Measures the quality of a mesh. The edge lengths and the number of flipped triangles are given by the caller,
    /// because they depend on how the sheets of the mesh are oriented and where they meet.
    #[must_use]
    pub fn of(mesh: &Mesh, edge_lengths: &[f64], flipped_triangles: usize) -> Self {
        Self {
            edge_lengths: Spread::of(edge_lengths.iter().copied()),
            angles: angle_range(mesh),
            flipped_triangles,
            degenerate_triangles: degenerate_triangles(mesh),
        }
    }

    /// Whether no triangle is flipped or degenerate.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.flipped_triangles == 0 && self.degenerate_triangles == 0
    }
}

/// A power of two above a length by a factor of at most two, or 1 if the length is zero. Multiplying and dividing by a
/// power of two is exact.
#[must_use]
#[inline]
pub fn power_of_two_above(length: f64) -> f64 {
    if length == 0.0 {
        return 1.0;
    }
    // The exponent is limited so that the power and its inverse are both normal numbers.
    let exponent = (length.to_bits() >> 52) & 0x7ff;
    f64::from_bits((exponent + 1).clamp(23, 2023) << 52)
}

/// Twice the triangle's area vector, (b - a) × (c - a).
#[must_use]
#[inline]
pub fn double_area_vector([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// Sum of the triangles' areas, ½ |(b - a) × (c - a)|.
#[must_use]
#[inline]
pub fn area(mesh: &Mesh) -> f64 {
    mesh.triangles.iter().map(|&t| 0.5 * double_area_vector(mesh.corners(t)).length()).sum()
}

/// Unit normals of the vertices, weighted by area. Zero if a vertex belongs to no triangle of positive area.
#[must_use]
#[inline]
pub fn vertex_normals(mesh: &Mesh) -> Vec<DVec3> {
    normals(&mesh.vertices, &mesh.triangles)
}

/// The normals of [`vertex_normals`], with vertices and triangles as separate arguments.
#[must_use]
#[inline]
pub fn normals(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; vertices.len()];
    for &triangle in triangles {
        let normal = double_area_vector(triangle.map(|v| vertices[v as usize]));
        for vertex in triangle {
            normals[vertex as usize] += normal;
        }
    }
    for normal in &mut normals {
        *normal = normal.normalize_or_zero();
    }
    normals
}

/// Lengths of all edges, each once.
#[must_use]
#[inline]
pub fn edge_lengths(mesh: &Mesh, topology: &Topology) -> Vec<f64> {
    (0..topology.twin.len() as u32)
        .filter(|&h| topology.twin[h as usize] > h)
        .map(|h| mesh.vertices[topology.from(h) as usize].distance(mesh.vertices[topology.to(h) as usize]))
        .collect()
}

/// The angle between two vectors in radians, from 0 to π; 0 where a vector vanishes, never NaN. Unlike the arc cosine
/// of the dot product, it is exact to rounding near 0 and near π.
#[must_use]
#[inline]
pub fn angle(u: DVec3, v: DVec3) -> f64 {
    libm::atan2(u.cross(v).length(), u.dot(v))
}

/// The three inner angles of a triangle in radians. An angle at an edge of length zero is 0, never NaN.
#[must_use]
#[inline]
pub fn angles([a, b, c]: [DVec3; 3]) -> [f64; 3] {
    [angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)]
}

/// Smallest and largest inner angle over all triangles, radians; `(0, 0)` for no triangles.
#[must_use]
#[inline]
pub fn angle_range(mesh: &Mesh) -> (f64, f64) {
    let range = mesh.triangles.iter().flat_map(|&t| angles(mesh.corners(t))).fold(None, |range, angle| match range {
        None => Some((angle, angle)),
        Some((min, max)) => Some((f64::min(min, angle), f64::max(max, angle))),
    });
    range.unwrap_or((0.0, 0.0))
}

/// Whether the least altitude is below [`DEGENERATE_ALTITUDE`] of the longest edge.
#[must_use]
#[inline]
pub fn is_degenerate(corners: [DVec3; 3]) -> bool {
    let [a, b, c] = corners;
    let longest_squared = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    // altitude = 2 area / longest, so altitude < k longest  <=>  2 area < k longest².
    !(double_area_vector(corners).length() >= DEGENERATE_ALTITUDE * longest_squared && longest_squared > 0.0)
}

/// Number of degenerate triangles.
#[must_use]
#[inline]
pub fn degenerate_triangles(mesh: &Mesh) -> usize {
    mesh.triangles.iter().filter(|&&t| is_degenerate(mesh.corners(t))).count()
}

/// Number of flipped triangles, whose normal points against the sum of their three vertex normals.
#[must_use]
#[inline]
pub fn flipped_triangles(mesh: &Mesh) -> usize {
    count_flipped(&mesh.vertices, &mesh.triangles, &vertex_normals(mesh))
}

/// The number of [`flipped_triangles`], with vertices, triangles and known normals as separate arguments.
#[must_use]
#[inline]
pub fn count_flipped(vertices: &[DVec3], triangles: &[[u32; 3]], normals: &[DVec3]) -> usize {
    let is_flipped = |triangle: &&[u32; 3]| {
        let around: DVec3 = triangle.iter().map(|&v| normals[v as usize]).sum();
        double_area_vector(triangle.map(|v| vertices[v as usize])).dot(around) < 0.0
    };
    triangles.iter().filter(is_flipped).count()
}
