//! Mean curvature and residuals of a film.

use plateau_equilibrium::energy::area;
use plateau_equilibrium::normal_motion::{FilmState, film_state};
use plateau_equilibrium::residual::curvature;
use plateau_mesh::DVec3;
use plateau_mesh::film::Film;
use plateau_mesh::sparse::pattern::FreeVertices;

/// Mean curvature and residuals of a film, vertex by vertex.
#[derive(Clone, Debug)]
pub struct Curvature {
    /// Mean curvature |g| / (2 A_h) of each vertex, in 1/unit, with the area gradient g and a third A_h of the area of
    /// the vertex's triangles. 0 where the vertex is fixed.
    pub mean_curvature: Vec<f64>,
    /// See [`Statistics::residual`](super::statistics::Statistics::residual).
    pub residual: f64,
    /// The residual that the solvers compare with their tolerance. Forces of the size of rounding errors count as zero
    /// in it.
    pub(super) residual_felt: f64,
    /// See [`Statistics::residual_full`](super::statistics::Statistics::residual_full).
    pub residual_full: f64,
    /// The residual over the vertices at which the force exceeds the rounding that [`force_rounding`] allows.
    pub(super) residual_beyond_rounding: f64,
}

/// Rounding error that is assumed of a sum of forces, in units in the last place of the largest coordinate times the
/// sensitivity of the sum to the coordinates.
const ROUNDING: f64 = 8.0;

impl Curvature {
    /// The largest mean curvature, in 1/unit.
    pub(super) fn largest(&self) -> f64 {
        self.mean_curvature.iter().copied().fold(0.0, f64::max)
    }

    /// Measures a film. The field `residual_felt` is the residual of [`film_state`], which also ends Newton's
    /// iteration.
    pub(crate) fn of(film: &Film) -> Self {
        let (free, radius) = (FreeVertices::new(&film.fixed), film.radius());
        let FilmState { mass, residual: residual_felt, gradient: forces, .. } =
            film_state(&free, &film.vertices, film.triangles(), radius);
        let mut gradient = vec![DVec3::ZERO; film.vertices.len()];
        area::add_gradient(film.triangles(), 1.0, &film.vertices, &mut gradient);
        let mut mean_curvature = vec![0.0; film.vertices.len()];
        let mut largest: f64 = 0.0;
        for (&v, &mass) in free.vertex.iter().zip(&mass) {
            let full = curvature(gradient[v as usize].length(), mass);
            mean_curvature[v as usize] = full;
            largest = largest.max(full);
        }
        let rounding = force_rounding(film);
        let beyond =
            |((&v, &force), &mass): ((&u32, &f64), &f64)| (force.abs() > rounding[v as usize]).then_some((force, mass));
        let pairs = free.vertex.iter().zip(&forces).zip(&mass).filter_map(beyond);
        let residual_beyond_rounding = plateau_equilibrium::residual::residual(pairs, radius).min(residual_felt);
        let residual =
            plateau_equilibrium::residual::residual(forces.iter().copied().zip(mass.iter().copied()), radius);
        Self { mean_curvature, residual, residual_felt, residual_full: largest * radius, residual_beyond_rounding }
    }
}

/// Returns for each vertex the largest force that rounding of the coordinates alone can cause. A triangle exerts the
/// force |n × e| / 2 on a corner, where e is the opposite edge. Moving a corner by δ changes this force by up to δ (1 +
/// l / h) / 2, where l is the longest edge and h the altitude over it.
fn force_rounding(film: &Film) -> Vec<f64> {
    let largest = film.vertices.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let step = ROUNDING * f64::EPSILON * largest;
    let mut rounding = vec![0.0; film.vertices.len()];
    for &triangle in film.triangles() {
        let [a, b, c] = film.corners(triangle);
        let longest_squared = [b - a, c - b, a - c].map(DVec3::length_squared).into_iter().fold(0.0, f64::max);
        let ratio = longest_squared / (b - a).cross(c - a).length();
        triangle.iter().for_each(|&v| rounding[v as usize] += 0.5 * step * (1.0 + ratio));
    }
    rounding
}
