//! A layout of vertices for a plane mesh, and the comparison of its resolution with the wanted one.

use super::plane_mesh::PlaneRegion;
use super::sampling::Sampled;
use crate::options::Resolution;
use glam::DVec2;
use plateau_mesh::film::Film;

/// Increase of the edge length per distance from the boundary. A larger value gives fewer but less even triangles.
pub(super) const GRADING: f64 = 0.3;
/// Factor between consecutive gradings that are tried.
pub(super) const GRADING_STEP: f64 = 1.5;
/// Largest relative error of the resolution that is tolerated.
pub(super) const TOLERATED: f64 = 0.1;

/// A trial: the boundaries sampled at some size, and the positions of the vertices between them. Only the accepted
/// layout is triangulated, because the number of triangles does not depend on the triangulation.
pub(super) struct Layout {
    pub boundaries: Vec<Sampled>,
    pub domain: PlaneRegion,
    pub sites: Vec<DVec2>,
    pub triangles: usize,
    /// Mean edge length in space, if the resolution is an edge length.
    pub mean_edge: f64,
    /// Mean over all sites of the length in the plane per length in space.
    pub scale: f64,
}

impl Layout {
    fn boundary_points(&self) -> usize {
        self.boundaries.iter().map(|boundary| boundary.points.len()).sum()
    }
}

/// The wanted resolution, and the Euler characteristic of the surface, which relates the numbers of vertices and
/// triangles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal {
    pub resolution: Resolution,
    pub euler: i64,
}

impl Goal {
    /// The number of triangles that a film over these boundaries should have.
    pub fn triangles(&self, film: &Film) -> f64 {
        match self.resolution {
            Resolution::Triangles(count) => count as f64,
            Resolution::InteriorVertices(count) => {
                let boundary = film.boundaries.iter().map(Vec::len).sum::<usize>() as f64;
                2.0 * count as f64 + boundary - 2.0 * self.euler as f64
            }
            Resolution::EdgeLength(length) => film.area() / (0.75f64.sqrt() / 2.0 * length * length),
        }
    }

    /// Ratio of the wanted to the reached number of triangles. Above 1 the mesh must become finer.
    pub fn shortfall(&self, layout: &Layout, subdivisions: u32) -> f64 {
        let growth = 4f64.powi(subdivisions as i32);
        let triangles = layout.triangles as f64 * growth;
        match self.resolution {
            Resolution::Triangles(count) => count as f64 / triangles,
            Resolution::InteriorVertices(count) => {
                // By Euler's formula F = 2 (interior) + (boundary) - 2 χ.
                let boundary = layout.boundary_points() as f64 * 2f64.powi(subdivisions as i32);
                let interior = 0.5 * (triangles - boundary) + self.euler as f64;
                (count as f64).max(0.5) / interior.max(0.25)
            }
            Resolution::EdgeLength(length) => {
                let reached = layout.mean_edge / 2f64.powi(subdivisions as i32);
                (reached / length) * (reached / length)
            }
        }
    }
}

/// Increase of the edge length per distance from the boundary, after `steps` multiplications by [`GRADING_STEP`].
pub(super) fn grading(steps: u32) -> f64 {
    // The steps are multiplied one by one, so that the result does not depend on where the search for it began.
    (0..steps).fold(GRADING, |grading, _| grading * GRADING_STEP)
}
