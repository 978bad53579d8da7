//! The harmonic map of a plane mesh into space with given positions of its fixed vertices.

use crate::energy::dirichlet::laplacian;
use glam::DVec2;
use plateau_mesh::codes::Reason;
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::sparse::{LinearError, Symbolic};
use plateau_mesh::{DVec3, Error, Execution};

/// Moves the free vertices so that all coordinates are harmonic over the plane mesh.
pub(super) fn harmonic(
    in_plane: &[DVec2],
    triangles: &[[u32; 3]],
    fixed: &[bool],
    vertices: &mut [DVec3],
    exec: &Execution,
) -> Result<(), Error> {
    let pattern = Pattern::new(triangles, fixed);
    if pattern.free.vertex.is_empty() {
        return Ok(());
    }
    exec.look(triangles.len() as u64)?;
    let flat: Vec<DVec3> = in_plane.iter().map(|p| p.extend(0.0)).collect();
    let (mut matrix, mut unused) = (pattern.matrix(), Vec::new());
    laplacian(&pattern, &flat, triangles, &mut matrix, &mut unused);
    let n = pattern.free.vertex.len();
    let mut solution = vec![0.0; 3 * n];
    for triangle in triangles {
        for k in 0..3 {
            let [a, b, c] = [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]].map(|v| v as usize);
            let (u, v) = (in_plane[a] - in_plane[c], in_plane[b] - in_plane[c]);
            let weight = 0.5 * u.dot(v) / u.perp_dot(v).abs().max(f64::MIN_POSITIVE);
            for (free, other) in [(a, b), (b, a)] {
                if !fixed[free] && fixed[other] {
                    let row = pattern.free.unknown[free] as usize;
                    let pull = weight * vertices[other];
                    for (axis, pull) in pull.to_array().into_iter().enumerate() {
                        solution[axis * n + row] += pull;
                    }
                }
            }
        }
    }
    let solved = Symbolic::analyse(&matrix, None)
        .and_then(|symbolic| symbolic.factorise(&matrix).and_then(|factorisation| factorisation.solve(&mut solution)));
    solved.map_err(|error| match error {
        LinearError::TooLarge => {
            Error::no_result(Reason::TooLarge, "the mesh is too large to factorise; ask for fewer triangles")
        }
        _ => Error::no_result(
            Reason::DegenerateBoundary,
            "the boundary's points lie so that its initial mesh is degenerate",
        ),
    })?;
    for (row, &v) in pattern.free.vertex.iter().enumerate() {
        vertices[v as usize] = DVec3::new(solution[row], solution[n + row], solution[2 * n + row]);
    }
    exec.look(triangles.len() as u64)?;
    Ok(())
}
