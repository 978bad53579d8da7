//! A film that a solver has finished, with the further facts that the statistics need.

use super::initial_mesh::InitialMeshKind;
use super::run::Run;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::film::Film;
use plateau_mesh::measure;

/// A film that a solver has finished.
#[derive(Clone, Debug)]
pub(crate) struct SolvedFilm {
    pub film: Film,
    /// How the initial mesh was made.
    pub kind: InitialMeshKind,
    /// The number of the layout by which the boundaries were arranged in the plane, if a layout was asked for.
    pub arrangement: Option<usize>,
    /// Area of the initial mesh.
    pub initial_area: f64,
    pub run: Run,
}

impl SolvedFilm {
    /// Whether the film counts as a stable minimal surface: the solver converged, no eigenvalue of the second variation
    /// is negative beyond rounding, and no triangle is flipped or degenerate.
    pub fn holds(&self) -> bool {
        let converged = matches!(self.run.stop_reason, StopReason::Residual | StopReason::NothingToMove);
        let is_degenerate = |&triangle: &[u32; 3]| measure::is_degenerate(self.film.corners(triangle));
        converged
            && self.run.stability.is_none_or(|stability| stability.least_index == 0)
            && self.film.flipped_triangles() == 0
            && !self.film.triangles().iter().any(is_degenerate)
    }
}
