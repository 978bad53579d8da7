//! Step 1: chooses the input points that bound the coarse mesh.

use crate::estimate::{area_of_fans, estimate, triangles_of_length};
use crate::initial_mesh::first_point;
use crate::options::{BoundarySampling, InitialMesh, Options, Resolution};
use plateau_mesh::{DVec3, measure, polyline};

/// Smallest number of triangles of the coarse mesh. The first plan has as many levels as this allows (at most 12). Each
/// level divides the number of triangles by four.
const LEAST_COARSE_TRIANGLES: f64 = 1000.0;
/// Smallest number of triangles of the coarse mesh per boundary vertex.
const COARSE_TRIANGLES_PER_BOUNDARY_VERTEX: f64 = 3.0;
/// A boundary vertex at which the boundary turns by more than this (in radians) is a corner. The boundary that a coarse
/// edge replaces turns by at most this much in total.
const CORNER: f64 = 0.6;
/// A boundary edge counts as long if it exceeds this multiple of the mean edge length of the mesh.
const LONG_EDGE: f64 = 1.6;

/// The input points that bound the coarse mesh, its resolution, and the number of refinements.
#[derive(Debug)]
pub(super) struct Plan {
    pub levels: u32,
    /// Resolution of the coarse mesh.
    pub resolution: Resolution,
    /// For each boundary the indices of the points that the coarse mesh keeps, ascending.
    pub kept: Vec<Vec<u32>>,
}

impl Plan {
    /// The plans for a request, the coarsest first.
    pub fn from_coarse(boundaries: &[Vec<DVec3>], options: &Options) -> impl Iterator<Item = Self> {
        let suits = matches!(options.initial_mesh, InitialMesh::Auto | InitialMesh::Planar | InitialMesh::Disk)
            && options.constraints.is_empty();
        let target = match options.resolution {
            // The number of triangles that cover the area. The additional triangles that `estimate` counts beside a
            // boundary of close points are left out, because halving does not make them.
            Resolution::EdgeLength(length) => triangles_of_length(boundaries, length),
            _ => estimate(boundaries, options).triangles,
        };
        let suits =
            suits && !(options.boundary_sampling == BoundarySampling::Keep && has_long_edges(boundaries, target));
        let most =
            if suits { (0.5 * libm::log2(target / LEAST_COARSE_TRIANGLES)).floor().clamp(0.0, 12.0) as u32 } else { 0 };
        (1..=most).rev().filter_map(move |levels| {
            let kept: Vec<Vec<u32>> = boundaries.iter().map(|points| kept_points(points, 1 << levels)).collect();
            let boundary_vertices: usize = kept.iter().map(Vec::len).sum();
            // A boundary edge that skips no point stays whole, and the triangle at it becomes three instead of four.
            let points: usize = boundaries.iter().map(Vec::len).sum();
            let lost = match options.boundary_sampling {
                BoundarySampling::Keep => ((boundary_vertices << levels) as f64 - points as f64).max(0.0),
                BoundarySampling::Refine => 0.0,
            };
            let triangles = (target + lost) / f64::from(4u32.pow(levels));
            let resolution = match options.resolution {
                Resolution::Triangles(_) => Resolution::Triangles(triangles.round() as usize),
                Resolution::EdgeLength(length) => Resolution::EdgeLength(length * f64::from(1u32 << levels)),
                Resolution::InteriorVertices(_) => return None,
            };
            (triangles >= COARSE_TRIANGLES_PER_BOUNDARY_VERTEX * boundary_vertices as f64).then_some(Self {
                levels,
                resolution,
                kept,
            })
        })
    }

    pub fn coarse_boundaries(&self, boundaries: &[Vec<DVec3>]) -> Vec<Vec<DVec3>> {
        let pick = |(points, kept): (&Vec<DVec3>, &Vec<u32>)| kept.iter().map(|&k| points[k as usize]).collect();
        boundaries.iter().zip(&self.kept).map(pick).collect()
    }
}

/// Whether the boundary edges are on average much longer than the edges of a mesh of this number of triangles. If long
/// boundary edges must be kept, the triangles beside them have to be graded, and halving all other edges would destroy
/// the grading.
fn has_long_edges(boundaries: &[Vec<DVec3>], triangles: f64) -> bool {
    let length: f64 = boundaries.iter().map(|points| polyline::length(points, true)).sum();
    let points: usize = boundaries.iter().map(Vec::len).sum();
    let edge = (area_of_fans(boundaries) / (0.75f64.sqrt() / 2.0 * triangles)).sqrt();
    length / points as f64 > LONG_EDGE * edge
}

/// Indices of the points of a closed polygon that a coarse mesh keeps: all corners, and further points at most `stride`
/// apart, so many that no edge replaces more turning than a corner has. The choice does not depend on the first point
/// of the list.
fn kept_points(points: &[DVec3], stride: usize) -> Vec<u32> {
    let n = points.len();
    let direction = |k: usize| (points[(k + 1) % n] - points[k % n]).normalize_or_zero();
    let turn = |k: usize| {
        let (before, after) = (direction(k + n - 1), direction(k));
        measure::angle(before, after)
    };
    let mut corners: Vec<usize> = (0..n).filter(|&k| turn(k) > CORNER).collect();
    if corners.is_empty() {
        corners.push(first_point(points));
    }
    let mut kept = Vec::new();
    for (i, &start) in corners.iter().enumerate() {
        let end = corners.get(i + 1).copied().unwrap_or(corners[0] + n);
        let turning: f64 = (start + 1..end).map(|k| turn(k % n)).sum();
        // A loop without corners keeps at least three edges.
        let least = if corners.len() < 3 { 3 } else { 1 };
        let edges = (end - start).div_ceil(stride).max((turning / CORNER).ceil() as usize).max(least).min(end - start);
        kept.extend((0..edges).map(|j| ((start + j * (end - start) / edges) % n) as u32));
    }
    kept.sort_unstable();
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_stay_and_no_edge_skips_more_than_the_stride() {
        let square = |k: usize| match k / 25 {
            0 => DVec3::new(k as f64, 0.0, 0.0),
            1 => DVec3::new(25.0, k as f64 - 25.0, 0.0),
            2 => DVec3::new(75.0 - k as f64, 25.0, 0.0),
            _ => DVec3::new(0.0, 100.0 - k as f64, 0.0),
        };
        let points: Vec<DVec3> = (0..100).map(square).collect();
        let kept = kept_points(&points, 8);
        assert!([0, 25, 50, 75].iter().all(|corner| kept.contains(corner)), "{kept:?}");
        assert!(kept.windows(2).all(|pair| pair[1] - pair[0] <= 8) && kept.len() == 16);
        // A circle of few points turns too much between neighbours to skip many of them.
        let circle: Vec<DVec3> =
            (0..24).map(|k| DVec3::new(libm::cos(k as f64 * 0.2618), libm::sin(k as f64 * 0.2618), 0.0)).collect();
        assert!(kept_points(&circle, 16).len() >= 10);
    }
}
