//! Step 1 of the default solver: rounds of Delaunay flips, tangential relaxation and Pinkall-Polthier solves.

use super::Solve;
use crate::minimal_surface::harmonic::{Dirichlet, too_large};
use crate::minimal_surface::solvers::necks::longest_free_edges;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::delaunay::{flip_to_delaunay, tangential_relaxation};
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

impl Solve<'_> {
    /// Step 1: rounds of Delaunay flips, tangential relaxation and Pinkall-Polthier solves until the area settles and
    /// no triangle is flipped. Returns whether a linear system was refused.
    pub(super) fn settle(&mut self, film: &mut Film) -> Result<bool, Error> {
        let mut area = film.area();
        // The area of a thin neck is a small part of the film's area and does not tell whether the neck has settled.
        let refined = self.refined;
        let mut moved = 0.0;
        for round in 0..MAX_ROUNDS {
            self.improve(film)?;
            self.exec.look(film.triangles().len() as u64)?;
            let mut dirichlet = Dirichlet::new(film).map_err(too_large)?;
            let before_round = area;
            for _ in 0..if round < SINGLE_ROUNDS { 1 } else { SOLVES_PER_ROUND } {
                if self.record.iterations >= self.limit {
                    return Ok(false);
                }
                self.exec.look(film.triangles().len() as u64)?;
                let start = if refined { film.vertices.clone() } else { Vec::new() };
                if dirichlet.step(film).is_err() {
                    return Ok(true);
                }
                if refined {
                    moved = largest_motion(film, &start);
                }
                let before = std::mem::replace(&mut area, film.area());
                let residual = self.state(film, &dirichlet.pattern).residual;
                let fraction = 0.5 * f64::from(round + 1) / f64::from(MAX_ROUNDS);
                self.record.iteration("pinkall_polthier", area, residual, fraction);
                if (before - area).abs() <= SETTLED_AREA * area && moved <= SETTLED_MOTION {
                    break;
                }
            }
            let settled = (before_round - area).abs() <= SETTLED_AREA * area && moved <= SETTLED_MOTION;
            if settled && film.flipped_triangles() == 0 {
                break;
            }
        }
        self.improve(film)?;
        Ok(false)
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
