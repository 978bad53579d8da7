//! Mean curvature and residuals of a film.

use crate::energy::area;
use crate::equilibrium::residual::curvature;
use crate::equilibrium::{FilmState, film_state};
use plateau_mesh::DVec3;
use plateau_mesh::film::Film;
use plateau_mesh::sparse::pattern::FreeVertices;

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
    /// The residual is that of [`film_state`], which also ends Newton's iteration.
    pub(crate) fn of(film: &Film) -> Self {
        let (free, radius) = (FreeVertices::new(&film.fixed), film.radius());
        let FilmState { mass, residual, .. } = film_state(&free, &film.vertices, film.triangles(), radius);
        let mut gradient = vec![DVec3::ZERO; film.vertices.len()];
        area::add_gradient(film.triangles(), 1.0, &film.vertices, &mut gradient);
        let mut mean_curvature = vec![0.0; film.vertices.len()];
        let mut largest: f64 = 0.0;
        for (&v, &mass) in free.vertex.iter().zip(&mass) {
            let full = curvature(gradient[v as usize].length(), mass);
            mean_curvature[v as usize] = full;
            largest = largest.max(full);
        }
        Self { mean_curvature, residual, residual_full: largest * radius }
    }
}
