//! The edges of a triangle list.

use plateau_mesh::codes::Reason;
use plateau_mesh::error::Error;
use plateau_mesh::topology::{NONE, Topology};
use plateau_mesh::{DVec3, Mesh};

/// Returns the connectivity of a mesh that this crate made. A defect would be a bug of this crate. It is reported as an
/// error, so that no caller receives the mesh.
///
/// # Errors
/// [`Error::NoResult`] (`invalid_mesh`).
pub(super) fn topology(vertices: Vec<DVec3>, triangles: &[[u32; 3]]) -> Result<Topology, Error> {
    Mesh::new(vertices, triangles.to_vec()).check().map_err(|defect| {
        Error::no_result(Reason::InvalidMesh, format!("the triangulation is not a manifold: {defect}"))
    })
}

/// Returns every edge once.
pub(super) fn edges(topology: &Topology) -> Vec<[u32; 2]> {
    (0..topology.twin.len() as u32)
        .filter(|&h| topology.twin[h as usize] == NONE || topology.twin[h as usize] > h)
        .map(|h| [topology.from(h), topology.to(h)])
        .collect()
}

/// Lengths of the edges. `at` gives the position of a vertex.
pub(super) fn lengths(edges: &[[u32; 2]], at: impl Fn(u32) -> DVec3) -> Vec<f64> {
    edges.iter().map(|&[a, b]| at(a).distance(at(b))).collect()
}
