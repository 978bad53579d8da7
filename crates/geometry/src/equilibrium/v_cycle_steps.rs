//! Newton's step for meshes too large to factorise: conjugate gradients over nested levels.

use super::newton::{Outcome, Settings, State, StepSolver};
use crate::Execution;
use crate::energy::area::Pattern;
use crate::mesh::film::Film;
use crate::sparse::multigrid::{Hierarchy, Parents};
use crate::sparse::{CgFailure, LinearError, SymmetricMatrix};

/// Each step's linear system is solved to this fraction of the residual, until the residual is small enough for the rest in one go.
const FORCING: f64 = 1e-3;
const LAST_STEP_BELOW: f64 = 2e-2;

/// Newton's step by conjugate gradients over the nested levels.
pub(crate) struct VCycleSteps<'a> {
    pub hierarchy: &'a Hierarchy,
    pub parents: Parents,
    pub matrix: SymmetricMatrix,
    pub exec: &'a Execution<'a>,
}

impl StepSolver for VCycleSteps<'_> {
    fn heights(
        &mut self,
        film: &Film,
        pattern: &Pattern,
        state: &State,
        settings: &Settings,
    ) -> Result<Vec<f64>, Outcome> {
        pattern.second_variation(&film.vertices, film.triangles(), &state.normals, 0.0, &mut self.matrix);
        let right_hand_side: Vec<f64> = state.first.gradient.iter().map(|pull| -pull).collect();
        let rest = 0.2 * settings.tolerance;
        let goal = if state.residual > LAST_STEP_BELOW { rest.max(FORCING * state.residual) } else { rest };
        let is_small = |residual: &[f64]| {
            let allowed = 2.0 * goal / settings.radius;
            residual.iter().zip(&state.first.mass).all(|(pull, mass)| pull.abs() <= allowed * mass)
        };
        self.hierarchy.solve(&self.matrix, &self.parents, &right_hand_side, is_small, self.exec).map_err(|failure| {
            match failure {
                CgFailure::Interrupted(interruption) => Outcome::Interrupted(interruption),
                CgFailure::Indefinite | CgFailure::Slow => Outcome::Refused(LinearError::Inaccurate),
            }
        })
    }
}
