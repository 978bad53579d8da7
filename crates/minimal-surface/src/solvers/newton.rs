//! The default solver of minimal surfaces, from an initial mesh to a surface with its stability:
//!
//! 1. *Settle*: rounds of Delaunay flips, tangential relaxation and one to four Pinkall-Polthier solves
//!    ([`harmonic`](crate::harmonic)). They accept any start and leave good triangles.
//! 2. *Newton's method* in normal heights ([`newton`](plateau_equilibrium::newton)). If triangles are flipped, edge
//!    flips that reduce the area open the folds, and Newton's method runs again. If triangles are still flipped, or if
//!    the method stalls, the solver returns to step 1. If the film converges with small angles, these are widened in
//!    place, and Newton's method runs again. In the end the vertices slide along the film to where its triangles have
//!    less area ([`sliding`](plateau_mesh::remesh::sliding)), and Newton's method corrects the film once more. If a few
//!    triangles remain flipped, the mesh is refined around them, and the film is solved again from step 1.
//! 3. *Stability* ([`stability`](plateau_equilibrium::stability)). If the caller asks for it, the solver moves away
//!    from a surface that is unstable or whose index is undecided, along its lowest mode.
//! 4. *Check of necks* ([`necks`](crate::solvers::necks)). A stable film near the edge of stability is compared with a
//!    finer one. Where its mesh is too coarse, the mesh is refined, and the film is solved again from step 1. If
//!    Newton's method stalls on the refined mesh, the degenerate triangles are removed once.

mod polish;
mod settle;

pub(crate) use polish::{LEAST_SLID_ANGLE, NARROW, WIDE, WIDENINGS};

use crate::extrapolation::Finer;
use crate::harmonic::too_large;
use crate::options::{Limits, OnUnstable, Solver};
use crate::run::{ExtrapolatedArea, Record, Run, Stability};
use crate::solvers::necks::{self, Look, finer_sizes, has_fine_ends, is_calm, sizes_at_narrow_ends};
use plateau_equilibrium::form_finding::StopReason;
use plateau_equilibrium::newton::{Aim, Direct, Equations, Settings, keeps_orientation};
use plateau_equilibrium::normal_motion::{FilmState, NormalMotion};
use plateau_equilibrium::residual::curvature;
use plateau_equilibrium::stability::{self, Margin, SecondVariation, WithMargin};
use plateau_mesh::film::Film;
use plateau_mesh::remesh::isotropic::{BoundaryEdges, refine};
use plateau_mesh::remesh::thin_triangles::{Necks, remove_degenerate_triangles};
use plateau_mesh::sparse::multigrid::Hierarchy;
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::sparse::{Factorisation, Unsolved};
use plateau_mesh::{DVec3, Error, Execution, Interruption};

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// Largest number of linear solves if the caller gives none.
const DEFAULT_SOLVES: u32 = 200;
/// Largest number of triangles for which the area is extrapolated with a mesh of four times as many.
pub(crate) const EXTRAPOLATED_TRIANGLES: usize = 10_000;
/// Root mean square of the vertices' residuals, weighted by area, below which a mesh of the caller counts as lying near
/// a stationary surface. Newton's method then takes the mesh to that surface, whatever its Morse index. The largest
/// residual is no measure of nearness, because at vertices of uneven triangles it stays above 1 on the exact surface,
/// however fine the mesh.
const NEARLY_STATIONARY: f64 = 1.0;
/// Largest number of returns to step 1 after Newton's method has stalled or left flipped triangles. Also the largest
/// number of unstable surfaces from which the solver moves away.
const MAX_RETURNS: u32 = 2;
/// Smallest angle (radians, 0.06 degrees) of the triangles that are kept where Newton's method stalls on a refined
/// mesh. Triangles with a smaller angle are removed.
const DEGENERATE: f64 = 1e-3;
/// Largest number of refinements of a neck.
const MOST_LOOKS: u32 = 4;
/// Largest number of passes of one refinement. Each pass halves the longest edges once.
pub const REFINING_PASSES: u32 = 8;

/// Instructions for a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Task {
    /// The tolerance and the largest number of iterations.
    pub limits: Limits,
    /// Whether the solver reports an unstable surface or moves away from it.
    pub on_unstable: OnUnstable,
    /// Whether the initial mesh is the caller's own, which may lie near a stationary surface.
    pub given: bool,
    /// Whether small angles may be widened, which changes the number of triangles. Meshes of the caller and rings are
    /// not widened, because their triangles were promised.
    pub may_widen: bool,
    /// Whether a mesh that is too coarse for a neck may be refined, which can make many times as many triangles.
    pub may_refine: bool,
    /// Whether a refinement splits edges of the boundary.
    pub boundary_edges: BoundaryEdges,
    /// Whether the vertices slide in the end.
    pub slides: bool,
}

/// Does steps 1 to 4 on a film.
///
/// The film becomes the best mesh that was reached. If that mesh is not converged, the stop reason says why.
///
/// # Errors
/// [`Error::Interrupted`] on cancel; [`Error::NoResult`] if the mesh is too large to factorise.
pub(crate) fn run(film: &mut Film, task: Task, exec: &Execution) -> Result<Run, Error> {
    let mut solve = Solve::new(film, task, exec);
    let (stop_reason, stability) = match solve.film(film, task.on_unstable) {
        Ok(done) => done,
        Err(Error::Interrupted(Interruption::DeadlinePassed)) => (StopReason::Deadline, None),
        Err(error) => return Err(error),
    };
    Ok(solve.into_run(stop_reason, stability))
}

/// State of a run: its settings and its record.
pub(crate) struct Solve<'a> {
    pub exec: &'a Execution<'a>,
    pub record: Record<'a>,
    pub limit: u32,
    pub tolerance: f64,
    pub radius: f64,
    /// Number of solves that are allowed for each direction away from an unstable surface, and for each refined mesh,
    /// if the caller gives no limit. If the caller gives a limit, this is 0.
    solves_per_way: u32,
    edges_swapped: u64,
    unstable_mode: Option<Vec<DVec3>>,
    pub extrapolated_area: Option<ExtrapolatedArea>,
    /// Whether the film is still the caller's own mesh.
    given: bool,
    /// Whether small angles may be widened, which removes and adds vertices. See [`Task::may_widen`].
    may_widen: bool,
    may_refine: bool,
    /// Whether a neck was refined.
    refined: bool,
    /// Whether a refinement splits edges of the boundary.
    boundary_edges: BoundaryEdges,
    /// Whether the vertices slide in the end.
    pub slides: bool,
}

impl<'a> Solve<'a> {
    pub fn new(film: &Film, task: Task, exec: &'a Execution<'a>) -> Self {
        Self {
            exec,
            record: Record::new(exec),
            limit: task.limits.max_iterations.unwrap_or(DEFAULT_SOLVES),
            tolerance: task.limits.tolerance,
            radius: film.radius(),
            solves_per_way: if task.limits.max_iterations.is_some() { 0 } else { DEFAULT_SOLVES },
            edges_swapped: 0,
            unstable_mode: None,
            extrapolated_area: None,
            given: task.given,
            may_widen: task.may_widen,
            may_refine: task.may_refine,
            refined: false,
            boundary_edges: task.boundary_edges,
            slides: task.slides,
        }
    }

    pub fn into_run(self, stop_reason: StopReason, stability: Option<Stability>) -> Run {
        let Self {
            record: Record { history, iterations, .. },
            edges_swapped,
            unstable_mode,
            extrapolated_area,
            refined,
            ..
        } = self;
        let done = Run { stop_reason, iterations, history, edges_swapped, stability, ..Run::new(Solver::Newton) };
        Run { unstable_mode, extrapolated_area, refined, ..done }
    }

    fn film(&mut self, film: &mut Film, on_unstable: OnUnstable) -> Result<(StopReason, Option<Stability>), Error> {
        // A film with one boundary has no neck.
        let may_refine = self.may_refine && film.boundaries.len() > 1;
        let mut start = may_refine.then(|| film.clone());
        let (mut reason, mut converged) = self.converge(film)?;
        if self.may_refine {
            (reason, converged) = self.refine_at_folds(film, reason, converged)?;
        }
        let mut returns = 0;
        let mut looks = 0;
        let mut thin_removed = false;
        loop {
            let found = match converged {
                Some((pattern, mut direct)) => {
                    self.stability(film, &pattern, &mut direct)?.map(|found| (pattern, direct, found))
                }
                None => None,
            };
            let Some((pattern, direct, (mut stability, variation, state))) = found else {
                // If the mesh is coarse beside a narrow boundary, the solver may fail although a film exists. The start
                // is therefore refined there and solved again.
                if reason != StopReason::MaxIterations
                    && let Some(start) = start.take()
                    && let Some(sizes) = sizes_at_narrow_ends(&start)
                    && let Some(finer) = self.refined(&start, sizes)?
                {
                    *film = finer;
                    (reason, converged) = self.converge_again(film)?;
                    continue;
                }
                // Newton's method stalls where a vertex has come to lie on an edge beside it, because the vertex moves
                // along its normal only.
                if reason == StopReason::Stalled && looks > 0 && !std::mem::replace(&mut thin_removed, true) {
                    let changes = remove_degenerate_triangles(film, DEGENERATE, Necks::Keep, self.exec)?;
                    if changes.any() {
                        (reason, converged) = self.converge_again(film)?;
                        continue;
                    }
                }
                // If the refined mesh does not hold the film, no such film exists.
                let is_lost = looks > 0 && reason != StopReason::MaxIterations;
                return Ok((if is_lost { StopReason::Collapsed } else { reason }, None));
            };
            if stability.stable == Some(true) {
                let own = variation.margin.as_ref().map(|margin| margin.value);
                let look = self.look(film, &pattern, direct, variation.margin)?;
                let may_refine_again = may_refine && looks < MOST_LOOKS && matches!(look, Look::Unresolved(_));
                let finer = match may_refine_again.then(|| finer_sizes(film)).flatten() {
                    Some(sizes) => self.refined(film, sizes)?,
                    None => None,
                };
                if let Some(finer) = finer {
                    looks += 1;
                    *film = finer;
                    (reason, converged) = self.converge_again(film)?;
                    continue;
                }
                let doubtful = look == Look::Unresolved(None) && may_refine;
                let look = match own.filter(|&own| doubtful && own >= necks::SAFE) {
                    Some(own) => necks::confirm(own, self.margin_of_finer(film)?),
                    None => look,
                };
                return Ok(match look {
                    Look::Unresolved(None) if may_refine => (StopReason::Collapsed, None),
                    Look::Exists(margin) | Look::Unresolved(Some(margin)) => {
                        stability.margin = Some(margin);
                        (reason, Some(stability))
                    }
                    Look::Unresolved(None) => {
                        stability.margin = own;
                        (reason, Some(stability))
                    }
                });
            }
            if (on_unstable == OnUnstable::Report && looks == 0) || returns == MAX_RETURNS {
                return Ok((reason, Some(stability)));
            }
            returns += 1;
            // The direction of the lower area may lead to a film that comes apart, and the other direction to a
            // minimum.
            let before = film.clone();
            let ways = self.ways_out(film, &pattern, &state, &variation.lowest.vector);
            if ways.is_empty() {
                return Ok((reason, Some(stability)));
            }
            (reason, converged) = self.leave(film, &before, ways)?;
        }
    }

    /// Returns a copy of the film that is refined to the target edge length in `sizes` at each vertex. Returns `None`
    /// if the copy has no more triangles than the film.
    fn refined(&mut self, film: &Film, sizes: Vec<f64>) -> Result<Option<Film>, Interruption> {
        let mut finer = film.clone();
        refine(&mut finer, sizes, REFINING_PASSES, self.boundary_edges, self.exec)?;
        let grows = finer.triangles().len() > film.triangles().len();
        self.refined |= grows;
        Ok(grows.then_some(finer))
    }

    /// Converges from each of the `ways` out of an unstable film, of which there is at least one, until a film
    /// converges without flipped triangles. If none of them does, the film becomes that of the first way.
    fn leave(
        &mut self,
        film: &mut Film,
        before: &Film,
        ways: Vec<Vec<DVec3>>,
    ) -> Result<(StopReason, Option<(Pattern, Direct)>), Error> {
        let mut first = None;
        for vertices in ways {
            *film = Film { vertices, ..before.clone() };
            let (reason, converged) = self.converge_again(film)?;
            if converged.is_some() && film.flipped_triangles() == 0 {
                return Ok((reason, converged));
            }
            first.get_or_insert_with(|| (film.clone(), reason, converged));
        }
        let (before, reason, converged) = first.expect("there is at least one way out");
        *film = before;
        Ok((reason, converged))
    }

    /// Step 4: compares a stable film of this margin with the film whose edges are halved, and records the area that is
    /// extrapolated from the two films.
    fn look(
        &mut self,
        film: &Film,
        pattern: &Pattern,
        direct: Direct,
        margin: Option<Margin>,
    ) -> Result<Look, Interruption> {
        // There is no margin if the second variation is singular.
        let Some(Margin { value, motion }) = margin else { return Ok(Look::Unresolved(None)) };
        let calm = is_calm(film, value);
        if calm && film.triangles().len() > EXTRAPOLATED_TRIANGLES {
            return Ok(Look::Exists(value));
        }
        let Ok(factor) = direct.symbolic.factorise(&direct.matrix).map(Factorisation::into_storage) else {
            return Ok(if calm { Look::Exists(value) } else { Look::Unresolved(None) });
        };
        let hierarchy = Hierarchy::new(direct.symbolic, factor);
        let motion = (!calm).then_some(&motion[..]);
        let finer = Finer::of(film, pattern, &hierarchy, self.radius, motion, self.exec)?;
        if film.triangles().len() <= EXTRAPOLATED_TRIANGLES {
            self.extrapolated_area = finer.map(|finer| finer.area);
        }
        if calm {
            return Ok(Look::Exists(value));
        }
        let look = necks::compare(value, finer.and_then(|finer| finer.margin), 1);
        Ok(match look {
            Look::Exists(margin) if !has_fine_ends(film) => Look::Unresolved(Some(margin)),
            look => look,
        })
    }

    /// Halves all edges of a copy of the film and solves the copy from step 1. Returns the margin of the copy. `None` if
    /// the copy is no stable film, or if it would have too many triangles. The run does not report the copy.
    fn margin_of_finer(&mut self, film: &Film) -> Result<Option<f64>, Error> {
        let Some(sizes) = necks::halved_sizes(film) else { return Ok(None) };
        let (rows, iterations, limit) = (self.record.history.len(), self.record.iterations, self.limit);
        let (refined, edges_swapped) = (self.refined, self.edges_swapped);
        let finer = self.refined(film, sizes)?;
        self.refined = refined;
        let Some(mut finer) = finer else { return Ok(None) };
        let (_, converged) = self.converge_again(&mut finer)?;
        let found = match converged {
            Some((pattern, mut direct)) => self.stability(&finer, &pattern, &mut direct)?,
            None => None,
        };
        self.record.history.truncate(rows);
        (self.record.iterations, self.limit, self.edges_swapped) = (iterations, limit, edges_swapped);
        self.unstable_mode = None;
        let holds = |stability: &Stability| stability.stable == Some(true) && finer.flipped_triangles() == 0;
        let found = found.filter(|(stability, ..)| holds(stability));
        Ok(found.and_then(|(_, variation, _)| variation.margin).map(|margin| margin.value))
    }

    /// Calls [`converge`](Self::converge) after raising the limit, so that at least [`Self::solves_per_way`] solves are
    /// left.
    fn converge_again(&mut self, film: &mut Film) -> Result<(StopReason, Option<(Pattern, Direct)>), Error> {
        self.limit = self.limit.max(self.record.iterations + self.solves_per_way);
        self.converge(film)
    }

    /// Steps 1 and 2, repeated where Newton's method stalls. Also returns the pattern and the factorisation of the
    /// connectivity if the film converged.
    pub fn converge(&mut self, film: &mut Film) -> Result<(StopReason, Option<(Pattern, Direct)>), Error> {
        if film.fixed.iter().all(|&fixed| fixed) {
            return Ok((StopReason::NothingToMove, None));
        }
        if std::mem::take(&mut self.given)
            && let Some(converged) = self.stay(film)?
        {
            return Ok((StopReason::Residual, Some(converged)));
        }
        self.settle_and_solve(film)
    }

    /// Looks for a stationary surface near the caller's own mesh by Newton's method alone. This surface need not be a
    /// minimum, and Pinkall-Polthier solves would move away from it. Returns `None` and leaves the film unchanged if
    /// there is no such surface.
    fn stay(&mut self, film: &mut Film) -> Result<Option<(Pattern, Direct)>, Error> {
        let pattern = Pattern::new(film.triangles(), &film.fixed);
        let FilmState { gradient, mass, .. } = self.state(film, &pattern);
        let squares = gradient.iter().zip(&mass).map(|(force, share)| curvature(*force, *share).powi(2) * share);
        let mean_square = squares.sum::<f64>() / mass.iter().sum::<f64>();
        if self.radius * mean_square.sqrt() > NEARLY_STATIONARY {
            return Ok(None);
        }
        let mut direct = Direct::new(pattern.matrix()).map_err(too_large)?;
        let start = film.vertices.clone();
        let reason = self.newton(film, &pattern, &mut direct, Aim::Stationary)?;
        if reason == StopReason::Residual && film.flipped_triangles() == 0 {
            return Ok(Some((pattern, direct)));
        }
        film.vertices = start;
        Ok(None)
    }

    fn newton(
        &mut self,
        film: &mut Film,
        pattern: &Pattern,
        direct: &mut Direct,
        aim: Aim,
    ) -> Result<StopReason, Error> {
        let max_steps = self.limit.saturating_sub(self.record.iterations);
        let settings = Settings { aim, tolerance: self.tolerance, max_steps };
        let motion = NormalMotion { pattern, triangles: film.topology.triangles(), radius: self.radius };
        let done = |part| 0.5 + 0.4 * part;
        Ok(self.record.newton(&mut film.vertices, &motion, direct, &settings, "newton", done)?.0)
    }

    /// Step 3: computes the stability of the film. Returns `None` if the linear solver refuses the mesh, or if no
    /// vertex can move.
    fn stability(
        &mut self,
        film: &Film,
        pattern: &Pattern,
        direct: &mut Direct,
    ) -> Result<Option<(Stability, SecondVariation, FilmState)>, Error> {
        self.exec.look(film.triangles().len() as u64)?;
        let motion = NormalMotion { pattern, triangles: film.triangles(), radius: self.radius };
        let state = motion.state(&film.vertices);
        let variation = match stability::analyse(&film.vertices, &motion, &state, direct, WithMargin::Yes, self.exec) {
            Ok(Some(variation)) => variation,
            Ok(None) | Err(Unsolved::Refused(_)) => return Ok(None),
            Err(Unsolved::Interrupted(interruption)) => return Err(interruption.into()),
        };
        let stability = Stability::of(&variation);
        self.unstable_mode = (stability.least_index > 0).then(|| {
            let heights = &variation.lowest.vector;
            let largest = heights.iter().fold(0.0, |max: f64, height| max.max(height.abs()));
            let mut direction = vec![DVec3::ZERO; film.vertices.len()];
            for (&vertex, height) in pattern.free.vertex.iter().zip(heights) {
                direction[vertex as usize] = height / largest * state.frame[vertex as usize];
            }
            direction
        });
        Ok(Some((stability, variation, state)))
    }

    /// Returns the vertices of an unstable film after a step along its lowest mode, for both directions, the lower area
    /// first. The step in each direction is the step of least area among four lengths. A direction is left out if each
    /// of its four steps would turn a triangle over.
    fn ways_out(&self, film: &Film, pattern: &Pattern, state: &FilmState, mode: &[f64]) -> Vec<Vec<DVec3>> {
        let largest = mode.iter().fold(0.0, |max: f64, height| max.max(height.abs()));
        let mean_length = (state.energy / film.triangles().len() as f64).sqrt();
        let motion = NormalMotion { pattern, triangles: film.triangles(), radius: self.radius };
        let way = |direction: f64| {
            let lengths = [0.25, 0.5, 1.0, 2.0].into_iter().map(|length| direction * length * mean_length / largest);
            let moved = lengths.map(|length| motion.moved(&film.vertices, state, mode, length));
            moved
                .filter(|vertices| keeps_orientation(motion.triangles, &film.vertices, vertices))
                .map(|vertices| (motion.state(&vertices).energy, vertices))
                .min_by(|a, b| a.0.total_cmp(&b.0))
        };
        let mut ways: Vec<(f64, Vec<DVec3>)> = [1.0, -1.0].into_iter().filter_map(way).collect();
        ways.sort_by(|a, b| a.0.total_cmp(&b.0));
        ways.into_iter().map(|(_, vertices)| vertices).collect()
    }

    /// The first variation of the film at its present position.
    fn state(&self, film: &Film, pattern: &Pattern) -> FilmState {
        NormalMotion { pattern, triangles: film.triangles(), radius: self.radius }.state(&film.vertices)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::structured::cylinder;

    #[test]
    fn beyond_the_critical_gap_nothing_is_called_converged() {
        let mut film = cylinder(48, 16, 1.5);
        let limits = Limits { tolerance: 1e-6, curvature_tolerance: None, max_iterations: None };
        let boundary_edges = BoundaryEdges::Kept;
        let task = Task {
            limits,
            on_unstable: OnUnstable::Report,
            given: false,
            may_widen: true,
            may_refine: true,
            boundary_edges,
            slides: true,
        };
        let run = run(&mut film, task, &Execution::default()).unwrap();
        assert_ne!(run.stop_reason, StopReason::Residual);
        assert!(run.iterations > 5, "{} iterations", run.iterations);
        assert!(film.vertices.iter().all(|vertex| vertex.is_finite()));
    }
}
