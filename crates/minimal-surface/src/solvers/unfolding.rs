//! Removes the flipped triangles of a film whose neck has closed.

use plateau_mesh::film::Film;
use plateau_mesh::remesh::delaunay::flip_to_delaunay;
use plateau_mesh::remesh::thin_triangles::{Necks, remove_degenerate_triangles};
use plateau_mesh::{DVec3, Execution, Interruption};

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// Triangles with an angle below this (in radians) are removed.
const NEEDLE: f64 = 0.15;
/// Number of times that every free vertex is averaged.
const UNFOLDING_SWEEPS: u32 = 50;

/// Removes needles and moves every free vertex to the mean of its neighbours many times, which removes flipped
/// triangles. These arise when a neck closes, because it leaves a spike of needles, which may fall over as it flattens.
/// Makes the mesh Delaunay in the end, and returns the number of flips for that.
pub(crate) fn unfold(film: &mut Film, exec: &Execution) -> Result<u64, Interruption> {
    remove_degenerate_triangles(film, NEEDLE, Necks::Keep, exec)?;
    let free: Vec<u32> = (0..film.vertices.len() as u32).filter(|&v| !film.fixed[v as usize]).collect();
    for _ in 0..UNFOLDING_SWEEPS {
        for &v in &free {
            let (sum, count) = film
                .topology
                .outgoing_half_edges(v)
                .map(|h| film.vertices[film.topology.to(h) as usize])
                .fold((DVec3::ZERO, 0.0), |(sum, count), point| (sum + point, count + 1.0));
            film.vertices[v as usize] = sum / count;
        }
    }
    flip_to_delaunay(film, exec)
}
