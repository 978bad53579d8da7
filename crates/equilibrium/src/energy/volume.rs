//! The volume of the cones from the origin to the triangles of a surface.
//!
//! ```text
//! V = Σ a · (b × c) / 6          ∂V/∂a = b × c / 6          N_a · ∂²V/∂a∂b · N_b = c · (N_a × N_b) / 6
//! ```
//!
//! This follows from the divergence theorem, triangle by triangle; a, b, c are the corners in the triangle's order. For
//! a closed surface V is the enclosed volume, wherever the origin is. For a surface with a boundary V is the volume of
//! the cone over the surface with its apex at the origin. Its derivatives are those of the volume under the surface, if
//! the boundary does not move or slides on a plane through the origin.

use super::Term;
use glam::DMat3;
use plateau_mesh::DVec3;

/// E = -p V, the energy of a pressure p on the side from which the triangles' normals point away. With p = -1 the
/// energy is the volume itself, which serves as the quantity of a constraint.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// The triangles of the wall that encloses the volume, oriented alike.
    pub triangles: Vec<[u32; 3]>,
    /// p, a force per area. Its unit is that of the surface tension divided by a length.
    pub pressure: f64,
}

/// Returns the matrix V of the cross product with v: V w = v × w.
pub(crate) fn cross_matrix(v: DVec3) -> DMat3 {
    DMat3::from_cols(DVec3::new(0.0, v.z, -v.y), DVec3::new(-v.z, 0.0, v.x), DVec3::new(v.y, -v.x, 0.0))
}

impl Term for Volume {
    fn value(&self, at: &[DVec3]) -> f64 {
        let sixfold = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|v| at[v as usize]);
            a.dot(b.cross(c))
        };
        -self.pressure / 6.0 * self.triangles.iter().map(sixfold).sum::<f64>()
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        let factor = -self.pressure / 6.0;
        for triangle in &self.triangles {
            let corners = triangle.map(|v| at[v as usize]);
            for k in 0..3 {
                gradient[triangle[k] as usize] += factor * corners[(k + 1) % 3].cross(corners[(k + 2) % 3]);
            }
        }
    }

    // The second derivative has no semidefinite part, so the shift multiplies nothing.
    fn add_second_derivative(&self, at: &[DVec3], _shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        let factor = -self.pressure / 6.0;
        for triangle in &self.triangles {
            for k in 0..3 {
                let (v, w, third) = (triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
                // c · (N_a × N_b) = -N_a · (c × N_b).
                let block = cross_matrix(at[third as usize]) * -factor;
                add(v, w, block);
                add(w, v, block.transpose());
            }
        }
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.triangles.iter().for_each(|triangle| visit(triangle));
    }
}
