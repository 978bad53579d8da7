//! Brings a film of the default solver within the caller's bound on the mean curvature.
//!
//! The default solver ends by the residual along the normals. The mean curvature also has a part along the surface,
//! which depends on the layout of the triangles ([`sliding`](plateau_mesh::remesh::sliding)). It falls as long as the
//! vertices slide along the film, but their triangles become thinner. The default solver therefore stops sliding early.
//! With a bound it slides further:
//!
//! 1. The vertices slide where their curvature is not far below an aim, which is a fraction of the largest curvature. No
//!    angle falls below 21 degrees.
//! 2. Newton's method corrects the film along its normals.
//! 3. Steps 1 and 2 are repeated until the film is within the bound. If that no longer lowers the curvature, the aim is
//!    raised, and then smaller angles are allowed.
//!
//! The bound only says when the rounds end, and each round lowers the largest curvature. So a smaller bound never ends
//! at a larger curvature.

use crate::curvature::Curvature;
use crate::harmonic::too_large;
use crate::options::Limits;
use crate::run::{Record, Run};
use plateau_equilibrium::Settings;
use plateau_equilibrium::form_finding::StopReason;
use plateau_equilibrium::newton::{Aim, Direct};
use plateau_equilibrium::normal_motion::NormalMotion;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::sliding::{FULL_SWEEPS, Sliding, slide_by};
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::{Error, Execution, Interruption};

/// Tangents of the smallest angles that the rounds allow, one after the other: 21, 15 and 10 degrees.
const LEAST_TANGENTS: [f64; 3] = [0.383_864, 0.267_949, 0.176_327];
/// Largest number of rounds with one smallest angle and one aim.
const ROUNDS: u32 = 8;
/// Curvatures at which the rounds aim, as fractions of the largest curvature before a round. A later fraction is used
/// when rounds with the one before no longer lower the curvature, because a round that aims low moves nearly all
/// vertices, and the curvature of single vertices may then rise.
const AIMS: [f64; 3] = [0.5, 0.8, 0.95];
/// A vertex is visited again while its curvature exceeds this fraction of the aim. The fraction is below 1, because the
/// correction along the normals that follows changes the curvature a little.
const UNEVEN: f64 = 0.5;
/// A vertex does not move if its curvature is below this fraction of the aim.
const NEGLIGIBLE: f64 = 0.3;
/// Largest number of Newton steps of a correction if the caller gives no limit. One or two are usual.
const STEPS: u32 = 12;

/// Does steps 1 to 3 on a film that has converged, and adds the corrections to `run`. Other films stay as they are.
///
/// # Errors
/// [`Error::Interrupted`] on cancel; [`Error::NoResult`] if the mesh is too large to factorise.
pub(crate) fn reach(film: &mut Film, run: &mut Run, bound: f64, limits: Limits, exec: &Execution) -> Result<(), Error> {
    if run.stop_reason != StopReason::Residual {
        return Ok(());
    }
    let mut record = Record::new(exec);
    record.share = [1.0, 1.0];
    match rounds(film, &mut record, bound, limits, run.iterations, exec) {
        Ok(()) => {}
        Err(Error::Interrupted(Interruption::DeadlinePassed)) => run.stop_reason = StopReason::Deadline,
        Err(error) => return Err(error),
    }
    let before = run.iterations;
    run.iterations += record.iterations;
    run.history.extend(record.history.into_iter().map(|mut row| {
        row.iteration += before;
        row
    }));
    let area = film.area();
    let topologies = run.spanning.iter_mut().flat_map(|spanning| &mut spanning.topologies);
    topologies.filter(|topology| topology.chosen).for_each(|topology| topology.area = Some(area));
    Ok(())
}

fn rounds(
    film: &mut Film,
    record: &mut Record,
    bound: f64,
    limits: Limits,
    before: u32,
    exec: &Execution,
) -> Result<(), Error> {
    let radius = film.radius();
    let mut largest = Curvature::of(film).largest();
    if largest <= bound {
        return Ok(());
    }
    let pattern = Pattern::new(film.triangles(), &film.fixed);
    let mut direct = Direct::new(pattern.matrix()).map_err(too_large)?;
    let flipped = film.flipped_triangles();
    for (least_tangent, fraction) in LEAST_TANGENTS.into_iter().flat_map(|tangent| AIMS.map(|aim| (tangent, aim))) {
        for _ in 0..ROUNDS {
            // The gradient that sliding measures is a third of the mean curvature, because the mean curvature refers to
            // a third of the ring's area.
            let aim = fraction * largest * radius / 3.0;
            let by =
                Sliding { full_sweeps: FULL_SWEEPS, uneven: UNEVEN * aim, negligible: NEGLIGIBLE * aim, least_tangent };
            exec.look(film.triangles().len() as u64)?;
            let max_steps =
                limits.max_iterations.map_or(STEPS, |limit| limit.saturating_sub(before + record.iterations));
            let mut slid = film.clone();
            slide_by(&mut slid, radius, by, exec)?;
            let motion = NormalMotion { pattern: &pattern, triangles: slid.topology.triangles(), radius };
            let settings = Settings { aim: Aim::Stationary, tolerance: limits.tolerance, max_steps };
            let (rows, iterations) = (record.history.len(), record.iterations);
            let (reason, _) = record.newton(&mut slid.vertices, &motion, &mut direct, &settings, "newton", |_| 1.0)?;
            let now = Curvature::of(&slid).largest();
            if reason != StopReason::Residual || slid.flipped_triangles() > flipped || now >= largest {
                record.history.truncate(rows);
                record.iterations = iterations;
                break;
            }
            (*film, largest) = (slid, now);
            if largest <= bound {
                return Ok(());
            }
        }
    }
    Ok(())
}
