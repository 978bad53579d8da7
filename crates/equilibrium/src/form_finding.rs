//! The driver of all form finding, from a start that may be far away to a shape in equilibrium.
//!
//! Films, films with junctions and tensile structures find their shapes by the same three steps, which the function
//! `find` repeats until a shape is accepted or given up:
//!
//! 1. *Settle*: rounds of simple solves, each on better triangles than the one before. They accept any start, and end
//!    near the equilibrium.
//! 2. *Newton*: Newton's method (`newton::iterate`) on the mesh that the rounds have left.
//! 3. *Judge*: a shape whose residual is at the tolerance and of which no triangle is flipped is accepted. An accepted
//!    shape may still have to go on, because its mesh is to become finer or because it is unstable. Any other shape
//!    settles again, until the form finding gives up.
//!
//! Each kind of body implements the trait `FormFinding`: how the body settles, which equations Newton's method solves,
//! and how often the body settles again.

use crate::newton::Outcome;
use plateau_mesh::Interruption;

/// Why a form finding stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The residual fell to the tolerance.
    Residual,
    /// The relative change of the area fell below `area_tolerance`, which is the rule of the papers.
    AreaChange,
    /// A neck closed in a run that ends at the first change of topology.
    TopologyChange,
    /// The single linear system of the objective is solved.
    Solved,
    /// There is no vertex to move.
    NothingToMove,
    /// The change of the objective fell below Liu and Wang's criterion.
    ObjectiveChange,
    /// The gradient of the objective fell below Liu and Wang's criterion.
    Gradient,
    /// The length of the step fell below Liu and Wang's criterion.
    StepLength,
    /// The allowed iterations are used up.
    MaxIterations,
    /// No step improves the surface, although the residual is above the tolerance: a triangle would flip, or rounding
    /// errors are reached.
    Stalled,
    /// A part of the mesh has shrunk so far that its linear system has no trustworthy solution.
    Collapsed,
    /// The caller's deadline passed.
    Deadline,
}

impl StopReason {
    /// Returns the stop reason of a run whose last Newton iteration had this outcome.
    ///
    /// # Errors
    /// The interruption.
    #[doc(hidden)]
    pub fn after(outcome: Outcome) -> Result<Self, Interruption> {
        match outcome {
            Outcome::Converged => Ok(Self::Residual),
            Outcome::StepsUsed => Ok(Self::MaxIterations),
            Outcome::Stalled => Ok(Self::Stalled),
            Outcome::Refused(_) => Ok(Self::Collapsed),
            Outcome::Interrupted(interruption) => Err(interruption),
        }
    }

    /// A stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Residual => "residual",
            Self::AreaChange => "area_change",
            Self::TopologyChange => "topology_change",
            Self::Solved => "solved",
            Self::NothingToMove => "nothing_to_move",
            Self::ObjectiveChange => "objective_change",
            Self::Gradient => "gradient",
            Self::StepLength => "step_length",
            Self::MaxIterations => "max_iterations",
            Self::Stalled => "stalled",
            Self::Collapsed => "collapsed",
            Self::Deadline => "deadline",
        }
    }
}

/// The step that follows a round of settling.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Round<E> {
    /// The shape still moves, so that another round follows.
    Moves,
    /// The shape has settled, or its rounds are used up. Newton's method follows.
    Settled,
    /// The form finding ends without Newton's method.
    Ended(E),
}

/// A body whose shape in equilibrium is to be found, with its mesh.
#[doc(hidden)]
pub trait FormFinding {
    /// The end of a form finding: what is known of a shape that was found, or why none was found.
    type End;
    /// Why a form finding is left: the caller's interruption, or a mesh that is too large.
    type Error;

    /// Prepares the rounds that follow a start (`attempt` is 0) or a return from Newton's method.
    fn begin(&mut self, attempt: u32);

    /// Makes one round of settling.
    ///
    /// # Errors
    /// See [`FormFinding::Error`].
    fn round(&mut self) -> Result<Round<Self::End>, Self::Error>;

    /// Runs Newton's method on the present mesh.
    ///
    /// # Errors
    /// See [`FormFinding::Error`].
    fn newton(&mut self) -> Result<StopReason, Self::Error>;

    /// Number of flipped triangles. The residual does not show them.
    fn flipped_triangles(&self) -> usize;

    /// Takes a shape whose residual is at the tolerance and of which no triangle is flipped. `None` if the shape is to
    /// settle again, on another mesh or from another place.
    ///
    /// # Errors
    /// See [`FormFinding::Error`].
    fn accept(&mut self) -> Result<Option<Self::End>, Self::Error>;

    /// Judges a shape on which Newton's method has ended for this reason without an acceptable shape. `None` if the
    /// shape is to settle again; a form finding returns a bounded number of times.
    ///
    /// # Errors
    /// See [`FormFinding::Error`].
    fn refuse(&mut self, reason: StopReason, attempt: u32) -> Result<Option<Self::End>, Self::Error>;
}

/// Finds the shape by the three steps of the [module](self).
///
/// # Errors
/// See [`FormFinding::Error`].
#[doc(hidden)]
pub fn find<F: FormFinding>(form: &mut F) -> Result<F::End, F::Error> {
    let mut attempt = 0;
    // The form finding makes at most as many attempts as it allows itself, because it counts its returns and its
    // rounds.
    loop {
        form.begin(attempt);
        // The form finding makes at most as many rounds as it allows itself, because it counts them.
        loop {
            match form.round()? {
                Round::Moves => {}
                Round::Settled => break,
                Round::Ended(end) => return Ok(end),
            }
        }
        let reason = form.newton()?;
        let is_sound = reason == StopReason::Residual && form.flipped_triangles() == 0;
        let end = if is_sound { form.accept()? } else { form.refuse(reason, attempt)? };
        if let Some(end) = end {
            return Ok(end);
        }
        attempt += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A form finding by a script: for each attempt its number of rounds, the reason with which Newton's method ends,
    /// and the number of flipped triangles. It records the calls.
    struct Scripted {
        attempts: Vec<(u32, StopReason, usize)>,
        /// The number of converged shapes that have to go on.
        goes_on: u32,
        attempt: usize,
        rounds: u32,
        calls: Vec<String>,
    }

    impl FormFinding for Scripted {
        type End = &'static str;
        type Error = Interruption;

        fn begin(&mut self, attempt: u32) {
            (self.attempt, self.rounds) = (attempt as usize, 0);
            self.calls.push(format!("begin {attempt}"));
        }

        fn round(&mut self) -> Result<Round<Self::End>, Interruption> {
            self.rounds += 1;
            self.calls.push("round".into());
            Ok(match self.attempts[self.attempt].0 {
                0 => Round::Ended("closed"),
                rounds if self.rounds < rounds => Round::Moves,
                _ => Round::Settled,
            })
        }

        fn newton(&mut self) -> Result<StopReason, Interruption> {
            self.calls.push("newton".into());
            match self.attempts[self.attempt].1 {
                StopReason::Deadline => Err(Interruption::DeadlinePassed),
                reason => Ok(reason),
            }
        }

        fn flipped_triangles(&self) -> usize {
            self.attempts[self.attempt].2
        }

        fn accept(&mut self) -> Result<Option<Self::End>, Interruption> {
            self.calls.push("accept".into());
            self.goes_on = self.goes_on.wrapping_sub(1);
            Ok((self.goes_on == u32::MAX).then_some("found"))
        }

        fn refuse(&mut self, reason: StopReason, attempt: u32) -> Result<Option<Self::End>, Interruption> {
            self.calls.push(format!("refuse {}", reason.name()));
            Ok((attempt as usize + 1 == self.attempts.len()).then_some("lost"))
        }
    }

    fn run(goes_on: u32, attempts: &[(u32, StopReason, usize)]) -> (Result<&'static str, Interruption>, String) {
        let attempts = attempts.to_vec();
        let mut form = Scripted { attempts, goes_on, attempt: 0, rounds: 0, calls: Vec::new() };
        (find(&mut form), form.calls.join(", "))
    }

    #[test]
    fn a_shape_settles_before_newtons_method_and_is_accepted_if_it_converges() {
        let (end, calls) = run(0, &[(3, StopReason::Residual, 0)]);
        assert_eq!((end, &*calls), (Ok("found"), "begin 0, round, round, round, newton, accept"));
    }

    #[test]
    fn a_shape_settles_again_where_newtons_method_stalls_or_leaves_flipped_triangles() {
        let (end, calls) =
            run(0, &[(1, StopReason::Stalled, 0), (1, StopReason::Residual, 2), (2, StopReason::Residual, 0)]);
        let expected = "begin 0, round, newton, refuse stalled, begin 1, round, newton, refuse residual, \
                        begin 2, round, round, newton, accept";
        assert_eq!((end, &*calls), (Ok("found"), expected));
        assert_eq!(run(0, &[(1, StopReason::Stalled, 0), (1, StopReason::Residual, 1)]).0, Ok("lost"));
    }

    #[test]
    fn an_accepted_shape_that_has_to_go_on_settles_again() {
        let (end, calls) = run(1, &[(1, StopReason::Residual, 0), (1, StopReason::Residual, 0)]);
        assert_eq!((end, &*calls), (Ok("found"), "begin 0, round, newton, accept, begin 1, round, newton, accept"));
    }

    #[test]
    fn a_round_or_an_interruption_may_end_the_form_finding() {
        let (end, calls) = run(0, &[(0, StopReason::Residual, 0)]);
        assert_eq!((end, &*calls), (Ok("closed"), "begin 0, round"));
        assert_eq!(run(0, &[(1, StopReason::Deadline, 0)]).0, Err(Interruption::DeadlinePassed));
    }
}
