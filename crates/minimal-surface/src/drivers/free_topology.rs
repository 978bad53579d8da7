//! Finds a film whose topology may change: Bento and Cavalcanti's rules are applied while the film shrinks, and the
//! default solver runs when it settles.
//!
//! 1. Iterate by Pinkall and Polthier with the rules. If a neck closes, start this step again. The step ends when the
//!    area changes little.
//! 2. Run the default solver on a copy of the film, descending from unstable surfaces. The rules may have removed two
//!    thirds of the triangles along a long neck. If too few are left, the copy is first remeshed to the number of
//!    triangles of the initial mesh. If the solver reaches a stable film with a small residual, this is the result.
//! 3. Otherwise the film shrinks slowly because a minimal surface almost exists. Continue step 1 to a much smaller
//!    change of area, and try step 2 again. If a closed neck left flipped triangles, average the vertices and start
//!    step 1 again. If no neck closes after that either, return the film of the default solver as not converged.

use crate::options::{FreeTopology, Limits, OnUnstable, PinkallPolthier, Solver};
use crate::run::{Record, Run};
use crate::solvers::newton;
use crate::solvers::pinkall_polthier::{Until, iterate};
use crate::solvers::unfolding::unfold;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::isotropic::{BoundaryEdges, resample};
use plateau_mesh::{Error, Execution, Interruption};

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// Largest number of solves of step 1 if the caller gives none. It is high, because a film beyond its last stable shape
/// shrinks slowly.
const DEFAULT_SOLVES: u32 = 2000;
/// Relative change of area per solve below which step 1 ends at first.
const SETTLED_AREA: f64 = 1e-4;
/// Relative change of area per solve below which step 1 ends after step 2 has failed.
const AT_REST: f64 = 1e-9;
/// Largest number of rounds that remove flipped triangles after a neck has closed.
const MOST_UNFOLDINGS: u32 = 3;
/// Step 2 remeshes the film first if fewer than this fraction of the triangles of the initial mesh are left.
const FEW: f64 = 0.8;
/// Largest number of passes of the remeshing in step 2.
const REFILL_PASSES: u32 = 12;

/// Carries out steps 1 to 3 on a film. The returned [`Run`] counts the solves of steps 1 and 2.
///
/// # Errors
/// [`Error::Interrupted`] on cancel; [`Error::NoResult`] if the mesh is too large to factorise.
pub(crate) fn run(
    film: &mut Film,
    options: &FreeTopology,
    limits: Limits,
    given: bool,
    exec: &Execution,
) -> Result<Run, Error> {
    let limit = limits.max_iterations.unwrap_or(DEFAULT_SOLVES);
    let FreeTopology { degenerate_angle, linear_solver } = *options;
    let mut run = Run::new(Solver::Newton);
    let mut change = SETTLED_AREA;
    let mut done = 0.0;
    let mut unfolded = 0;
    let initial = film.triangles().len() as f64;
    // There are few rounds, because each neck that closes changes the number of components or handles by one.
    loop {
        let part = 0.5 * (1.0 - done);
        let rules = PinkallPolthier { area_tolerance: change, linear_solver, degenerate_angle, cut_necks: true };
        // The bound on the mean curvature is for the film in the end and not for one that shrinks.
        let left =
            Limits { max_iterations: Some(limit.saturating_sub(run.iterations)), curvature_tolerance: None, ..limits };
        let reached = shrink(film, &rules, left, &mut run, exec, [done, done + 0.5 * part])?;
        match reached {
            StopReason::Deadline | StopReason::MaxIterations | StopReason::NothingToMove => {
                run.stop_reason = reached;
                return Ok(run);
            }
            StopReason::TopologyChange => {
                change = SETTLED_AREA;
                done += 0.5 * part;
                continue;
            }
            _ => {}
        }
        let mut held = film.clone();
        if !given && (held.triangles().len() as f64) < FEW * initial {
            resample(&mut held, initial, REFILL_PASSES, BoundaryEdges::Kept, exec)?;
        }
        let left = limits.max_iterations.map(|_| limit.saturating_sub(run.iterations));
        let limits = Limits { max_iterations: left, ..limits };
        let boundary_edges = BoundaryEdges::Kept;
        let on_unstable = OnUnstable::Descend;
        let (may_widen, may_refine, slides) = (!given, !given, true);
        let task = newton::Task { limits, on_unstable, given, may_widen, may_refine, boundary_edges, slides };
        let finish = exec.part([done + 0.5 * part, done + part], |exec| newton::run(&mut held, task, exec))?;
        let converged = finish.stop_reason == StopReason::Residual;
        let stable = finish.stability.is_none_or(|stability| stability.least_index == 0);
        let interrupted = finish.stop_reason == StopReason::Deadline;
        run.append(finish);
        done += part;
        let folds = held.flipped_triangles();
        if converged && stable && folds > 0 && unfolded < MOST_UNFOLDINGS {
            unfolded += 1;
            *film = held;
            exec.look(film.triangles().len() as u64)?;
            unfold(film, exec)?;
            change = SETTLED_AREA;
        } else if (converged && stable) || change == AT_REST || interrupted {
            *film = held;
            return Ok(run);
        } else {
            change = AT_REST;
        }
    }
}

/// Carries out step 1. Adds its solves and pinches to `run`. Returns [`StopReason::TopologyChange`] if a neck has
/// closed.
fn shrink(
    film: &mut Film,
    options: &PinkallPolthier,
    limits: Limits,
    run: &mut Run,
    exec: &Execution,
    share: [f64; 2],
) -> Result<StopReason, Error> {
    let mut part = Run::new(Solver::Newton);
    let ended = exec.part(share, |exec| {
        let mut record = Record::new(exec);
        let ended = iterate(film, options, limits, &mut record, &mut part, Until::Pinched, exec);
        (part.iterations, part.history) = (record.iterations, record.history);
        ended
    });
    part.stop_reason = match ended {
        Ok(reason) => reason,
        Err(Error::Interrupted(Interruption::DeadlinePassed)) => StopReason::Deadline,
        Err(error) => return Err(error),
    };
    let reason = part.stop_reason;
    run.append(part);
    Ok(reason)
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::structured::cylinder;

    fn rings(height: f64) -> (Film, Run) {
        let mut film = cylinder(48, 8, height / 10.0);
        film.vertices.iter_mut().for_each(|vertex| *vertex *= 10.0);
        let limits = Limits { tolerance: 1e-6, curvature_tolerance: None, max_iterations: None };
        let run = run(&mut film, &FreeTopology::default(), limits, false, &Execution::default()).unwrap();
        film.mesh().check().unwrap();
        assert_eq!((run.stop_reason, film.flipped_triangles()), (StopReason::Residual, 0));
        assert!(run.stability.is_some_and(|stability| stability.stable == Some(true)));
        assert!(run.history.windows(2).all(|pair| pair[1].iteration == pair[0].iteration + 1));
        assert_eq!(run.history.len(), run.iterations as usize);
        (film, run)
    }

    #[test]
    fn rings_below_the_critical_gap_stay_connected_and_beyond_it_come_apart() {
        // The critical gap of circles is 0.6627 of the diameter 20, which is 13.254. Between 48-gons with so few
        // triangles it holds to about a percent.
        for height in [12.0, 13.0, 13.2] {
            let (film, run) = rings(height);
            assert_eq!((film.topology.components(), run.pinches.len()), (1, 0), "{height}");
        }
        for height in [13.5, 14.0, 30.0] {
            let (film, run) = rings(height);
            assert_eq!((film.topology.components(), run.pinches.len()), (2, 1), "{height}");
            let discs = 100.0 * 48.0 * libm::sin(std::f64::consts::TAU / 48.0);
            assert!((film.area() - discs).abs() < 1e-9 * discs);
        }
    }
}
