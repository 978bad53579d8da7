//! Self-intersections of the mesh that the client gets.

use plateau_mesh::error::Warning;
use plateau_mesh::self_intersections::{self, Order, Skipped};
#[cfg(feature = "uniform-mesh")]
use plateau_mesh::{DVec2, DVec3, plane::triangulation::side};
use plateau_mesh::{Execution, Interruption, Mesh};

/// The number of self-intersections, as statistics state it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossings {
    /// Number of pairs of triangles that intersect. `None` if not all pairs were searched.
    pub pairs: Option<u64>,
    /// Reason why not all pairs were searched.
    pub skipped: Option<&'static str>,
    /// Whether a deadline ended the search, so that another run may count more.
    pub cut_short: bool,
}

impl Crossings {
    /// Counts the pairs of triangles of a mesh that intersect, and adds a warning if there are any. Meshes of more than
    /// `most_triangles` are not searched.
    ///
    /// # Errors
    /// Fails if the search was cancelled. A deadline only ends the search, because the mesh is good without the count.
    pub fn count(
        mesh: &Mesh,
        order: Order,
        most_triangles: usize,
        warnings: &mut Vec<Warning>,
        exec: &Execution,
    ) -> Result<Self, Interruption> {
        let (found, warning) = self_intersections::check(mesh, order, most_triangles, exec)?;
        warnings.extend(warning);
        let cut_short = found.skipped == Some(Skipped::DeadlinePassed);
        Ok(Self { pairs: found.pairs, skipped: found.skipped.map(Skipped::name), cut_short })
    }

    /// Counts the self-intersections of a mesh inside plane polygons that do not cross. If all its triangles face the
    /// same side, seen along an axis, then no triangle intersects another, because the number of triangles over a point
    /// changes only at the edges of the polygons. This test is O(triangles), whereas the search takes longer than the
    /// meshing.
    ///
    /// # Errors
    /// Returns the errors of [`count`](Self::count).
    #[cfg(feature = "uniform-mesh")]
    pub fn count_in_plane(mesh: &Mesh, warnings: &mut Vec<Warning>, exec: &Execution) -> Result<Self, Interruption> {
        exec.look(mesh.triangles.len() as u64)?;
        if faces_one_side(mesh) {
            return Ok(Self { pairs: Some(0), skipped: None, cut_short: false });
        }
        Self::count(mesh, Order::Spatial, usize::MAX, warnings, exec)
    }
}

/// Returns whether all triangles face the same side, seen along the axis that is nearest to their mean normal. The test
/// is exact.
#[cfg(feature = "uniform-mesh")]
fn faces_one_side(mesh: &Mesh) -> bool {
    let double_area = |&t: &[u32; 3]| {
        let [a, b, c] = mesh.corners(t);
        (b - a).cross(c - a)
    };
    let normal: DVec3 = mesh.triangles.iter().map(double_area).sum();
    let largest = normal.abs().max_element();
    let Some(axis) = (0..3).find(|&axis| normal[axis].abs() == largest && largest > 0.0) else { return false };
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    let sign = normal[axis].signum();
    mesh.triangles.iter().all(|&t| {
        let [a, b, c] = mesh.corners(t).map(|corner| DVec2::new(corner[u], corner[v]));
        sign * side(a, b, c) > 0.0
    })
}
