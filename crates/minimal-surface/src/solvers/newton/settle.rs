//! Steps 1 and 2 of the default solver as a [`FormFinding`]: rounds of Delaunay flips, tangential relaxation and
//! Pinkall-Polthier solves until the area settles and no triangle is flipped, then Newton's method.

use super::{MAX_RETURNS, Solve};
use crate::harmonic::{Dirichlet, too_large};
use crate::solvers::necks::longest_free_edges;
use plateau_equilibrium::form_finding::{self, FormFinding, Round, StopReason};
use plateau_equilibrium::newton::{Aim, Direct};
use plateau_mesh::film::Film;
use plateau_mesh::remesh::delaunay::{flip_to_delaunay, tangential_relaxation};
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::{DVec3, Error, Interruption};

/// Largest number of rounds of Pinkall-Polthier solves before Newton's method begins.
const MAX_ROUNDS: u32 = 16;
/// Number of first rounds with a single solve each, because a poor start needs new triangles first.
const SINGLE_ROUNDS: u32 = 3;
/// Largest number of solves in each later round.
const SOLVES_PER_ROUND: u32 = 4;
/// Number of tangential relaxations after each round's solves.
const RELAXATIONS_PER_ROUND: u32 = 4;
/// The rounds end when one of them changes the area by less than this fraction and no triangle is flipped.
const SETTLED_AREA: f64 = 1e-3;
/// After a neck has been refined, the rounds end only if the last solve also moved no vertex further than this fraction
/// of the vertex's longest edge.
const SETTLED_MOTION: f64 = 0.05;

/// A film on its way to a minimal surface.
struct Converging<'s, 'a> {
    solve: &'s mut Solve<'a>,
    film: &'s mut Film,
    /// Number of rounds since the start or the last return.
    rounds: u32,
    area: f64,
    /// Largest motion of a vertex in the last solve, as a fraction of its longest edge. It is measured only after a
    /// neck has been refined, and is 0 before. The area of a thin neck is a small part of the film's area, so the area
    /// does not tell whether the neck has settled.
    moved: f64,
    /// Whether a linear system of the last rounds was refused.
    collapsed: bool,
    /// The pattern and the factorisation of the connectivity on which Newton's method has run.
    solved: Option<(Pattern, Direct)>,
}

impl FormFinding for Converging<'_, '_> {
    /// The stop reason, and the pattern and the factorisation of the connectivity if the film converged.
    type End = (StopReason, Option<(Pattern, Direct)>);
    type Error = Error;

    fn begin(&mut self, _attempt: u32) {
        (self.rounds, self.area, self.moved, self.collapsed) = (0, self.film.area(), 0.0, false);
    }

    /// Step 1: Delaunay flips, tangential relaxation and Pinkall-Polthier solves.
    fn round(&mut self) -> Result<Round<Self::End>, Error> {
        let Self { solve, film, .. } = self;
        let refined = solve.refined;
        solve.improve(film)?;
        solve.exec.look(film.triangles().len() as u64)?;
        let mut dirichlet = Dirichlet::new(film).map_err(too_large)?;
        let before_round = self.area;
        for _ in 0..if self.rounds < SINGLE_ROUNDS { 1 } else { SOLVES_PER_ROUND } {
            if solve.record.iterations >= solve.limit {
                return Ok(Round::Settled);
            }
            solve.exec.look(film.triangles().len() as u64)?;
            let start = if refined { film.vertices.clone() } else { Vec::new() };
            if dirichlet.step(film).is_err() {
                self.collapsed = true;
                return Ok(Round::Settled);
            }
            if refined {
                self.moved = largest_motion(film, &start);
            }
            let before = std::mem::replace(&mut self.area, film.area());
            let residual = solve.state(film, &dirichlet.pattern).residual;
            let fraction = 0.5 * f64::from(self.rounds + 1) / f64::from(MAX_ROUNDS);
            solve.record.iteration("pinkall_polthier", self.area, residual, fraction);
            if (before - self.area).abs() <= SETTLED_AREA * self.area && self.moved <= SETTLED_MOTION {
                break;
            }
        }
        self.rounds += 1;
        let settled = (before_round - self.area).abs() <= SETTLED_AREA * self.area && self.moved <= SETTLED_MOTION;
        if self.rounds < MAX_ROUNDS && !(settled && film.flipped_triangles() == 0) {
            return Ok(Round::Moves);
        }
        solve.improve(film)?;
        Ok(Round::Settled)
    }

    /// Step 2. If triangles are flipped, edge flips that reduce the area open the folds.
    fn newton(&mut self) -> Result<StopReason, Error> {
        let Self { solve, film, .. } = self;
        let pattern = Pattern::new(film.triangles(), &film.fixed);
        let mut direct = Direct::new(pattern.matrix()).map_err(too_large)?;
        let reason = solve.newton(film, &pattern, &mut direct, Aim::Minimum)?;
        self.solved = Some((pattern, direct));
        if matches!(reason, StopReason::Residual | StopReason::Stalled)
            && let Some(opened) = solve.open_folds(film)?
        {
            self.solved = Some(opened);
            return Ok(StopReason::Residual);
        }
        Ok(reason)
    }

    fn flipped_triangles(&self) -> usize {
        self.film.flipped_triangles()
    }

    /// Widens small angles and lets the vertices slide.
    fn accept(&mut self) -> Result<Option<Self::End>, Error> {
        let Some((pattern, direct)) = self.solved.take() else { return Ok(None) };
        let (pattern, mut direct) = self.solve.widen(self.film, pattern, direct)?;
        if self.solve.slides {
            self.solve.slide(self.film, &pattern, &mut direct)?;
        }
        Ok(Some((StopReason::Residual, Some((pattern, direct)))))
    }

    /// A film that still has flipped triangles after the last return is accepted.
    fn refuse(&mut self, reason: StopReason, attempt: u32) -> Result<Option<Self::End>, Error> {
        let is_last = attempt == MAX_RETURNS;
        Ok(match reason {
            StopReason::Residual if is_last => return self.accept(),
            StopReason::MaxIterations => Some((reason, None)),
            _ if self.collapsed => Some((StopReason::Collapsed, None)),
            _ => is_last.then_some((reason, None)),
        })
    }
}

impl Solve<'_> {
    /// Steps 1 and 2, repeated where Newton's method stalls or leaves flipped triangles. Returns the stop reason, and
    /// the pattern and the factorisation of the connectivity if the film converged.
    pub(super) fn settle_and_solve(
        &mut self,
        film: &mut Film,
    ) -> Result<(StopReason, Option<(Pattern, Direct)>), Error> {
        let form =
            &mut Converging { solve: self, film, rounds: 0, area: 0.0, moved: 0.0, collapsed: false, solved: None };
        form_finding::find(form)
    }

    /// Improves the triangles without moving the film: Delaunay flips, tangential relaxation, and Delaunay flips again.
    fn improve(&mut self, film: &mut Film) -> Result<(), Interruption> {
        self.edges_swapped += flip_to_delaunay(film, self.exec)?;
        tangential_relaxation(film, RELAXATIONS_PER_ROUND);
        self.edges_swapped += flip_to_delaunay(film, self.exec)?;
        Ok(())
    }
}

/// Largest distance of a vertex from its `start`, as a fraction of its longest edge.
fn largest_motion(film: &Film, start: &[DVec3]) -> f64 {
    let moved = film.vertices.iter().zip(start).map(|(end, start)| end.distance(*start));
    moved
        .zip(longest_free_edges(film))
        .filter(|&(_, edge)| edge > 0.0)
        .map(|(moved, edge)| moved / edge)
        .fold(0.0, f64::max)
}
