//! The harmonic map of a plane mesh into space with given positions of its fixed vertices.

use crate::harmonic::Dirichlet;
use glam::DVec2;
use plateau_mesh::codes::Reason;
use plateau_mesh::sparse::LinearError;
use plateau_mesh::{DVec3, Error, Execution};

/// Moves the free vertices so that all coordinates are harmonic over the plane mesh.
pub(super) fn harmonic(
    in_plane: &[DVec2],
    triangles: &[[u32; 3]],
    fixed: &[bool],
    vertices: &mut [DVec3],
    exec: &Execution,
) -> Result<(), Error> {
    if fixed.iter().all(|&fixed| fixed) {
        return Ok(());
    }
    exec.look(triangles.len() as u64)?;
    let domain: Vec<DVec3> = in_plane.iter().map(|p| p.extend(0.0)).collect();
    let solved = Dirichlet::of(triangles, fixed).and_then(|mut dirichlet| dirichlet.map(&domain, vertices, triangles));
    solved.map_err(|error| match error {
        LinearError::TooLarge => {
            Error::no_result(Reason::TooLarge, "the mesh is too large to factorise; ask for fewer triangles")
        }
        _ => Error::no_result(
            Reason::DegenerateBoundary,
            "the boundary's points lie so that its initial mesh is degenerate",
        ),
    })?;
    exec.look(triangles.len() as u64)?;
    Ok(())
}
