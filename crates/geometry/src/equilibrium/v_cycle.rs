//! Newton's step for meshes too large to factorise: conjugate gradients over nested levels.

use super::newton::{Equations, Outcome, Settings, State, StepSolver};
use crate::sparse::multigrid::{Hierarchy, Parents};
use crate::sparse::{CgFailure, LinearError, SymmetricMatrix};
use crate::{DVec3, Execution};

/// Each step's linear system is solved to this fraction of the residual. A smaller fraction takes more V-cycles, a
/// larger one more steps.
const FORCING: f64 = 1e-3;
/// Below this residual the system is solved as far as the run's tolerance needs, because one step then ends the run. A
/// larger value spends V-cycles on steps that are not the last.
const LAST_STEP_BELOW: f64 = 2e-2;
/// That far: this fraction of the tolerance.
const LAST_STEP_GOAL: f64 = 0.2;

/// Newton's step by conjugate gradients over the nested levels. The body must have no constraints.
pub(crate) struct VCycleSteps<'a> {
    pub hierarchy: &'a Hierarchy,
    pub parents: Parents,
    pub matrix: SymmetricMatrix,
    pub exec: &'a Execution<'a>,
}

impl<E: Equations> StepSolver<E> for VCycleSteps<'_> {
    fn step(
        &mut self,
        vertices: &[DVec3],
        equations: &E,
        state: &State<E::Frame>,
        settings: &Settings,
    ) -> Result<Vec<f64>, Outcome> {
        debug_assert!(state.constraints.is_empty(), "V-cycles know no border");
        equations.second_variation(vertices, state, 0.0, &mut self.matrix);
        let right_hand_side: Vec<f64> = state.gradient.iter().map(|gradient| -gradient).collect();
        let rest = LAST_STEP_GOAL * settings.tolerance;
        let goal = if state.residual > LAST_STEP_BELOW { rest.max(FORCING * state.residual) } else { rest };
        let is_small = |residual: &[f64]| {
            let allowed = 2.0 * goal / equations.radius();
            residual.iter().zip(&state.mass).all(|(residual, mass)| residual.abs() <= allowed * mass)
        };
        self.hierarchy.solve(&self.matrix, &self.parents, &right_hand_side, is_small, self.exec).map_err(|failure| {
            match failure {
                CgFailure::Interrupted(interruption) => Outcome::Interrupted(interruption),
                CgFailure::Indefinite | CgFailure::Slow => Outcome::Refused(LinearError::Inaccurate),
            }
        })
    }
}
