//! Mean curvature and residuals of a film.

use crate::DVec3;
use crate::mesh::film::Film;
use crate::mesh::measure;

/// Mean curvature and residuals of a film, vertex by vertex.
#[derive(Clone, Debug)]
pub struct Curvature {
    /// Per vertex |g| / (2 A_h), in 1/unit; 0 where the vertex is fixed.
    pub mean_curvature: Vec<f64>,
    /// See [`Statistics::residual`](super::statistics::Statistics::residual).
    pub residual: f64,
    /// See [`Statistics::residual_full`](super::statistics::Statistics::residual_full).
    pub residual_full: f64,
}

impl Curvature {
    /// Measures a film in two passes over its triangles and one over its vertices.
    pub(crate) fn of(film: &Film) -> Self {
        let count = film.vertices.len();
        let mut gradient = vec![DVec3::ZERO; count];
        let mut normal = vec![DVec3::ZERO; count];
        for &triangle in film.triangles() {
            let [a, b, c] = film.corners(triangle);
            let double_area = (b - a).cross(c - a);
            let unit = double_area.normalize_or_zero();
            // The area grows fastest when a corner moves away from the opposite edge, at half that edge's length.
            let pull = [(c - b), (a - c), (b - a)].map(|edge| 0.5 * unit.cross(edge));
            for (vertex, pull) in triangle.into_iter().zip(pull) {
                gradient[vertex as usize] += pull;
                normal[vertex as usize] += double_area;
            }
        }
        let mut ring_area = vec![0.0; count];
        for &triangle in film.triangles() {
            let area = 0.5 * measure::double_area_vector(film.corners(triangle)).length();
            triangle.into_iter().for_each(|vertex| ring_area[vertex as usize] += area);
        }
        let radius = film.radius();
        let mut result = Self { mean_curvature: vec![0.0; count], residual: 0.0, residual_full: 0.0 };
        for v in (0..count).filter(|&v| !film.fixed[v]) {
            let double_share = 2.0 / 3.0 * ring_area[v];
            // A vertex whose whole ring has no area is as far from converged as can be.
            let over_share = |pull: f64| if double_share > 0.0 { pull / double_share } else { f64::MAX.sqrt() };
            let full = over_share(gradient[v].length());
            result.mean_curvature[v] = full;
            result.residual_full = result.residual_full.max(full * radius);
            let along_normal = gradient[v].dot(normal[v].normalize_or_zero()).abs();
            result.residual = result.residual.max(over_share(along_normal) * radius);
        }
        result
    }
}
