//! The way of a body to its equilibrium, with the stability there.

use super::body::{Body, BodyDefect};
use super::motion::{Frame, Motion};
use super::newton::{Direct, Equations, Outcome, Settings, State, iterate};
use super::stability::{self, Unknown, WithMargin};
use plateau_mesh::sparse::LinearError;
use plateau_mesh::{DVec3, Execution};

/// The stability of an equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// Number of negative eigenvalues of the second variation on the constraints' tangent space; 0 for a local minimum.
    /// `None` if rounding does not decide the sign of an eigenvalue.
    pub morse_index: Option<usize>,
    /// Number of eigenvalues that are negative beyond rounding.
    pub least_index: usize,
    /// Lowest eigenvalue against the lumped mass, in 1/unit².
    pub lowest_eigenvalue: f64,
}

/// How [`Body::relax`] ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// Why the iteration ended.
    pub outcome: Outcome,
    /// The sum of all terms.
    pub energy: f64,
    /// The dimensionless residual, which the tolerance bounds.
    pub residual: f64,
    /// Per constraint its multiplier: for a volume the pressure, for a length the force.
    pub multipliers: Vec<f64>,
    /// `None` where the body has no unknowns, did not converge, or is too degenerate to factorise.
    pub stability: Option<Stability>,
    /// The displacement of each vertex in the mode of the lowest eigenvalue, scaled so that the largest has length 1.
    /// `None` where the stability is unknown.
    pub lowest_mode: Option<Vec<DVec3>>,
}

impl Report {
    fn new(outcome: Outcome, constraints: usize, state: &State<Frame>, stability: Option<Stability>) -> Self {
        // The rows of the terms' rank-one parts follow those of the constraints.
        let multipliers = state.constraints[..constraints].iter().map(|constraint| constraint.multiplier).collect();
        Self { outcome, energy: state.energy, residual: state.residual, multipliers, stability, lowest_mode: None }
    }
}

impl Body {
    /// Moves the body to the nearest equilibrium and analyses its stability there. `record` receives the energy and the
    /// residual after every step.
    ///
    /// Terms that renew their coefficients do so after each solve, and the next solve follows, until no coefficient
    /// changes by more than the tolerance or the steps are used up.
    ///
    /// # Errors
    /// The first [`BodyDefect`]; nothing moves then.
    pub fn relax(
        &mut self,
        settings: &Settings,
        exec: &Execution,
        record: &mut dyn FnMut(f64, f64),
    ) -> Result<Report, BodyDefect> {
        self.check()?;
        let mut left = settings.max_steps;
        let count_of_constraints = self.constraints.len();
        loop {
            let mut vertices = self.vertices.clone();
            let motion = Motion::new(self);
            let mut taken = 0;
            let mut count = |energy: f64, residual: f64| {
                taken += 1;
                record(energy, residual);
            };
            let (report, solved) = match Direct::new(motion.matrix()) {
                Err(error) => {
                    let state = motion.state(&vertices);
                    (Report::new(Outcome::Refused(error), count_of_constraints, &state, None), false)
                }
                Ok(mut direct) => {
                    let round = Settings { max_steps: left, ..*settings };
                    let (outcome, state) = iterate(&mut vertices, &motion, &mut direct, &round, exec, &mut count);
                    let solved = outcome == Outcome::Converged;
                    let analysed = if solved {
                        stability::analyse(&vertices, &motion, &state, &mut direct, WithMargin::No, exec)
                    } else {
                        Ok(None)
                    };
                    let report = match analysed {
                        Ok(variation) => {
                            let found = variation.as_ref().map(|variation| Stability {
                                morse_index: variation.morse_index.decided(),
                                least_index: variation.morse_index.least,
                                lowest_eigenvalue: variation.lowest.eigenvalue,
                            });
                            let lowest_mode =
                                variation.map(|variation| motion.displacements(&state, &variation.lowest.vector));
                            Report { lowest_mode, ..Report::new(outcome, count_of_constraints, &state, found) }
                        }
                        Err(Unknown::Refused(_)) => Report::new(outcome, count_of_constraints, &state, None),
                        Err(Unknown::Interrupted(interruption)) => {
                            Report::new(Outcome::Interrupted(interruption), count_of_constraints, &state, None)
                        }
                    };
                    (report, solved)
                }
            };
            drop(motion);
            self.vertices = vertices;
            left = left.saturating_sub(taken);
            if !solved || self.renew() <= settings.tolerance {
                return Ok(report);
            }
            if left == 0 {
                return Ok(Report { outcome: Outcome::StepsUsed, ..report });
            }
        }
    }

    /// Runs one solve of [`relax`](Self::relax), without the check, the renewal and the stability. Also returns the
    /// state that was reached. `kept` has the symbolic factorisation and the storage of the last solve, which are used
    /// again if the pattern is the same, and gets those of this one.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub(crate) fn solve_once(
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
