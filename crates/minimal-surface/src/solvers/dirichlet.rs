//! The least Dirichlet energy: one harmonic map from the initial mesh (Pinkall, Polthier 1993, section 2).

use crate::curvature::Curvature;
use crate::harmonic::{Dirichlet, too_large};
use crate::options::Solver;
use crate::run::{Record, Run};
use plateau_equilibrium::energy::dirichlet::dirichlet_energy;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::codes::Reason;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::delaunay::flip_to_delaunay;
use plateau_mesh::{Error, Execution, Interruption};

/// Minimises the Dirichlet energy by a single solve of steps 1 and 2 of [`harmonic`](crate::harmonic), for the
/// objective [`MinimalDirichletEnergy`](crate::Objective::MinimalDirichletEnergy). The result is the harmonic map from
/// the initial mesh, which is made Delaunay first, so that the weights are positive. The objective value is the energy
/// ¼ Σ (cot α + cot β) |a'|² over the edges.
///
/// # Errors
/// [`Error::Interrupted`] on cancel; [`Error::NoResult`] if the mesh is too large or too degenerate to factorise.
pub(crate) fn run_once(film: &mut Film, exec: &Execution) -> Result<Run, Error> {
    let mut record = Record::new(exec);
    let mut run = Run::new(Solver::PinkallPolthier);
    let flips = flip_to_delaunay(film, exec);
    match flips.and_then(|flips| exec.look(film.triangles().len() as u64).map(|()| flips)) {
        Ok(flips) => run.edges_swapped = flips,
        Err(Interruption::DeadlinePassed) => {
            return Ok(Run { stop_reason: StopReason::Deadline, objective_value: Some(film.area()), ..run });
        }
        Err(Interruption::Cancelled) => return Err(Interruption::Cancelled.into()),
    }
    let mut dirichlet = Dirichlet::new(film).map_err(too_large)?;
    let domain = film.vertices.clone();
    let moves = !dirichlet.pattern.free.vertex.is_empty();
    if moves {
        dirichlet.step(film).map_err(|_| {
            let detail = "the initial mesh is degenerate, so that its harmonic map cannot be computed";
            Error::no_result(Reason::DegenerateBoundary, detail)
        })?;
        record.iteration("pinkall_polthier", film.area(), Curvature::of(film).residual_felt, 1.0);
    }
    let energy = dirichlet_energy(&domain, &film.vertices, film.triangles());
    let stop_reason = if moves { StopReason::Solved } else { StopReason::NothingToMove };
    let Record { history, iterations, .. } = record;
    Ok(Run { stop_reason, iterations, history, objective_value: Some(energy), ..run })
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::DVec3;
    use plateau_mesh::structured::patch;

    #[test]
    fn the_dirichlet_energy_is_least_and_at_least_the_area() {
        let mut film = patch(9, 7, |u, v| DVec3::new(u + 0.2 * v * v, v - 0.3 * u * v, libm::sin(3.0 * u + v) * 0.4));
        let mut domain = film.clone();
        let run = run_once(&mut film, &Execution::default()).unwrap();
        flip_to_delaunay(&mut domain, &Execution::default()).unwrap();
        let energy = |film: &Film| dirichlet_energy(&domain.vertices, &film.vertices, domain.triangles());
        let least = run.objective_value.unwrap();
        // The energy of the identity is the area of the domain. The energy of the harmonic map lies between the area of
        // its image and the area of the domain.
        assert!((energy(&domain) - domain.area()).abs() < 1e-12 * domain.area());
        assert!(film.area() <= least && least <= domain.area());
        for v in (0..film.vertices.len()).filter(|&v| !film.fixed[v]) {
            for direction in DVec3::AXES {
                let mut moved = film.clone();
                moved.vertices[v] += 1e-3 * direction;
                assert!(energy(&moved) > least);
            }
        }
    }
}
