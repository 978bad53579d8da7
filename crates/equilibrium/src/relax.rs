//! Moves a body to its equilibrium ([`Body::relax`]) and analyses the stability of that equilibrium.

use super::body::{Body, BodyDefect};
use super::motion::{Frame, Motion};
use super::newton::{Direct, Equations, Outcome, Settings, State, iterate};
use super::stability::{self, Stability, WithMargin};
use plateau_mesh::sparse::{LinearError, Unsolved};
use plateau_mesh::{DVec3, Execution};

/// How [`Body::relax`] ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// Why the iteration ended.
    pub outcome: Outcome,
    /// The energy of the body: the sum of all its terms.
    pub energy: f64,
    /// The dimensionless residual. The run converges when it is at most [`Settings::tolerance`].
    pub residual: f64,
    /// The multiplier of each constraint: the pressure for a volume, the force for a length.
    pub multipliers: Vec<f64>,
    /// The stability of the equilibrium. `None` if the body has no unknowns, did not converge, or is too degenerate to
    /// factorise.
    pub stability: Option<Stability>,
    /// The displacement of each vertex in the mode of the lowest eigenvalue, scaled so that the largest has length 1.
    /// `None` where the stability is unknown.
    pub lowest_mode: Option<Vec<DVec3>>,
}

impl Report {
    /// Makes the report on one solve of a body with `constraints` constraints. The stability is left out.
    fn new(outcome: Outcome, constraints: usize, state: &State<Frame>) -> Self {
        // `state.constraints` lists the body's constraints first, then the rank-one parts of the terms.
        let multipliers = state.constraints[..constraints].iter().map(|constraint| constraint.multiplier).collect();
        let (energy, residual) = (state.energy, state.residual);
        Self { outcome, energy, residual, multipliers, stability: None, lowest_mode: None }
    }
}

impl Body {
    /// Moves the body to the nearest equilibrium and analyses its stability there. `record` receives the energy and the
    /// residual after every step.
    ///
    /// Some terms renew their coefficients after each solve ([`Body::renew`]). The body is then solved again, until no
    /// coefficient changes by more than the tolerance or the steps are used up.
    ///
    /// # Errors
    /// The first [`BodyDefect`]; the body does not move then.
    pub fn relax(
        &mut self,
        settings: &Settings,
        exec: &Execution,
        record: &mut dyn FnMut(f64, f64),
    ) -> Result<Report, BodyDefect> {
        self.check()?;
        let mut left = settings.max_steps;
        loop {
            let mut taken = 0;
            let mut count = |energy: f64, residual: f64| {
                taken += 1;
                record(energy, residual);
            };
            let report = self.relax_once(&Settings { max_steps: left, ..*settings }, exec, &mut count);
            left = left.saturating_sub(taken);
            if report.outcome != Outcome::Converged || self.renew() <= settings.tolerance {
                return Ok(report);
            }
            if left == 0 {
                return Ok(Report { outcome: Outcome::StepsUsed, ..report });
            }
        }
    }

    /// Moves the body to the nearest equilibrium with its present coefficients and analyses the stability there.
    fn relax_once(&mut self, settings: &Settings, exec: &Execution, record: &mut dyn FnMut(f64, f64)) -> Report {
        let constraints = self.constraints.len();
        let mut vertices = self.vertices.clone();
        let motion = Motion::new(self);
        let mut direct = match Direct::new(motion.matrix()) {
            Ok(direct) => direct,
            Err(error) => return Report::new(Outcome::Refused(error), constraints, &motion.state(&vertices)),
        };
        let (outcome, state) = iterate(&mut vertices, &motion, &mut direct, settings, exec, record);
        let mut report = Report::new(outcome, constraints, &state);
        if outcome == Outcome::Converged {
            match stability::analyse(&vertices, &motion, &state, &mut direct, WithMargin::No, exec) {
                Ok(Some(variation)) => {
                    report.stability = Some(variation.stability());
                    report.lowest_mode = Some(motion.displacements(&state, &variation.lowest.vector));
                }
                Ok(None) | Err(Unsolved::Refused(_)) => {}
                Err(Unsolved::Interrupted(interruption)) => report.outcome = Outcome::Interrupted(interruption),
            }
        }
        drop(motion);
        self.vertices = vertices;
        report
    }

    /// Runs one solve of [`relax`](Self::relax), without the check, the renewal and the stability. Also returns the
    /// state that was reached. `kept` passes the symbolic factorisation and its storage from one solve to the next:
    /// they are reused if the matrix has the same pattern.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`].
    #[doc(hidden)]
    pub fn solve_once(
        &mut self,
        settings: &Settings,
        exec: &Execution,
        record: &mut dyn FnMut(f64, f64),
        kept: &mut Option<Direct>,
    ) -> Result<(Outcome, State<Frame>), LinearError> {
        let mut vertices = self.vertices.clone();
        let motion = Motion::new(self);
        let matrix = motion.matrix();
        if let Err(interruption) = exec.look(motion.work()) {
            return Ok((Outcome::Interrupted(interruption), motion.state(&vertices)));
        }
        let mut direct = match kept.take() {
            Some(last) if last.matrix.has_pattern_of(&matrix) => last,
            _ => Direct::new(matrix)?,
        };
        let solved = iterate(&mut vertices, &motion, &mut direct, settings, exec, record);
        drop(motion);
        *kept = Some(direct);
        self.vertices = vertices;
        Ok(solved)
    }
}
