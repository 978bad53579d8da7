//! Improves the triangles of a film that has converged: opens flipped triangles, widens small angles, and lets vertices
//! slide along the film.

use super::{REFINING_PASSES, Solve};
use crate::harmonic::too_large;
use crate::solvers::necks::longest_free_edges;
use plateau_equilibrium::form_finding::StopReason;
use plateau_equilibrium::newton::{Aim, Direct};
use plateau_mesh::film::Film;
use plateau_mesh::remesh::area_flips::flip_to_less_area;
use plateau_mesh::remesh::isotropic::{BoundaryEdges, graded, refine};
use plateau_mesh::remesh::sliding::{FULL_SWEEPS, slide};
use plateau_mesh::remesh::small_angles::{smallest_angle, widen};
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::{DVec3, Error, measure};

/// A converged film with an angle below this (radians, 22 degrees) has its small angles widened and is solved again.
/// Small angles arise at re-entrant corners and where a film bends strongly, because vertices that move along normals
/// only shear their triangles. The threshold is above the 20 degrees that are promised, because a solve makes some
/// angles smaller again.
pub(crate) const NARROW: f64 = 0.384;
/// Angle to which small angles are widened where that is possible (radians, 28 degrees).
pub(crate) const WIDE: f64 = 0.489;
/// Largest number of rounds of widening and solving. There are several because a solve may shrink angles again.
pub(crate) const WIDENINGS: u32 = 4;
/// Smallest angle (radians, 20 degrees) that sliding may leave in a film. If the film already has a smaller angle, that
/// angle is the bound.
pub(crate) const LEAST_SLID_ANGLE: f64 = 0.349_066;
/// Largest number of flipped triangles around which a converged film is refined. More of them belong to a film that
/// does not exist.
const MOST_FOLDS: usize = 8;
/// Largest number of refinements around flipped triangles.
const MOST_REFINED_FOLDS: u32 = 3;
/// Largest number of rounds of flips that open folds. There are several because a solve may close folds again.
const OPENINGS: u32 = 4;

impl Solve<'_> {
    /// Refines a converged film around its flipped triangles, if these are few, and solves the film again. Repeats this
    /// as long as fewer triangles are flipped. Such triangles arise where a boundary of close points turns to and fro,
    /// because a triangle whose corners lie on the boundary cannot move.
    pub(super) fn refine_at_folds(
        &mut self,
        film: &mut Film,
        mut reason: StopReason,
        mut converged: Option<(Pattern, Direct)>,
    ) -> Result<(StopReason, Option<(Pattern, Direct)>), Error> {
        for _ in 0..MOST_REFINED_FOLDS {
            let flipped = film.flipped_triangles();
            if reason != StopReason::Residual || flipped == 0 || flipped > MOST_FOLDS || self.solves_per_way == 0 {
                break;
            }
            let mut finer = film.clone();
            let sizes = sizes_at_folds(film);
            refine(&mut finer, sizes, REFINING_PASSES, BoundaryEdges::Kept, self.exec)?;
            let (again, solved) = self.converge_again(&mut finer)?;
            if solved.is_none() || finer.flipped_triangles() >= flipped {
                break;
            }
            (*film, reason, converged) = (finer, again, solved);
        }
        Ok((reason, converged))
    }

    /// Opens the folds of a film with flipped triangles by edge flips that reduce the area, and lets the film converge
    /// again. Repeats this as long as it leaves fewer flipped triangles. Returns the pattern and the factorisation of
    /// the new connectivity, or `None` if no triangle is flipped or the flips do not help.
    pub(super) fn open_folds(&mut self, film: &mut Film) -> Result<Option<(Pattern, Direct)>, Error> {
        let mut opened = None;
        for _ in 0..OPENINGS {
            self.exec.look(film.triangles().len() as u64)?;
            let flipped = film.flipped_triangles();
            let mut better = film.clone();
            let flips = if flipped == 0 { 0 } else { flip_to_less_area(&mut better, self.exec)? };
            if flips == 0 {
                break;
            }
            let pattern = Pattern::new(better.triangles(), &better.fixed);
            let mut direct = Direct::new(pattern.matrix()).map_err(too_large)?;
            let outcome = self.newton(&mut better, &pattern, &mut direct, Aim::Minimum)?;
            if outcome != StopReason::Residual || better.flipped_triangles() >= flipped {
                break;
            }
            *film = better;
            self.edges_swapped += flips;
            opened = Some((pattern, direct));
        }
        Ok(opened)
    }

    /// Widens the small angles of a converged film, opens its flipped triangles, and lets the film converge again.
    /// Repeats this as long as it leaves fewer flipped triangles or a larger smallest angle. Returns the pattern and
    /// the factorisation of the connectivity that remains.
    pub(super) fn widen(
        &mut self,
        film: &mut Film,
        pattern: Pattern,
        direct: Direct,
    ) -> Result<(Pattern, Direct), Error> {
        let (mut pattern, mut direct) = (pattern, direct);
        for _ in 0..if self.may_widen { WIDENINGS } else { 0 } {
            self.exec.look(film.triangles().len() as u64)?;
            let (before, flipped) = (smallest_angle(film), film.flipped_triangles());
            if before >= NARROW && flipped == 0 {
                break;
            }
            let mut widened = film.clone();
            if widen(&mut widened, WIDE, self.exec)?.is_none() {
                break;
            }
            let new_pattern = Pattern::new(widened.triangles(), &widened.fixed);
            let mut solver = Direct::new(new_pattern.matrix()).map_err(too_large)?;
            let reason = self.newton(&mut widened, &new_pattern, &mut solver, Aim::Minimum)?;
            let flipped_after = widened.flipped_triangles();
            let improves = flipped_after < flipped || (flipped_after == flipped && smallest_angle(&widened) > before);
            if reason != StopReason::Residual || !improves {
                break;
            }
            (*film, pattern, direct) = (widened, new_pattern, solver);
        }
        Ok((pattern, direct))
    }

    /// Lets the vertices of a converged film slide along the film to where its triangles have less area, and corrects
    /// the film along the normals. The film stays as it was if it does not converge again, if its area rises, or if an
    /// angle gets too small.
    pub(super) fn slide(&mut self, film: &mut Film, pattern: &Pattern, direct: &mut Direct) -> Result<(), Error> {
        let before = film.vertices.clone();
        let (rows, iterations) = (self.record.history.len(), self.record.iterations);
        let (area, angle, flipped) = (film.area(), smallest_angle(film), film.flipped_triangles());
        let slid = slide(film, self.radius, FULL_SWEEPS, self.exec);
        if slid.is_ok() && film.vertices == before {
            return Ok(());
        }
        let outcome = match slid {
            Ok(()) => self.newton(film, pattern, direct, Aim::Stationary),
            Err(interruption) => Err(interruption.into()),
        };
        let keeps = |film: &Film| {
            film.area() <= area
                && film.flipped_triangles() <= flipped
                && smallest_angle(film) >= angle.min(LEAST_SLID_ANGLE)
        };
        if !matches!(outcome, Ok(StopReason::Residual)) || !keeps(film) {
            film.vertices = before;
            self.record.history.truncate(rows);
            self.record.iterations = iterations;
        }
        outcome.map(|_| ())
    }
}

/// Returns target edge lengths, one for each vertex, that halve the edges of flipped triangles.
fn sizes_at_folds(film: &Film) -> Vec<f64> {
    let longest = longest_free_edges(film);
    let mut sizes: Vec<f64> = longest.iter().map(|&length| if length > 0.0 { length } else { f64::INFINITY }).collect();
    let normals = measure::normals(&film.vertices, film.triangles());
    for &triangle in film.triangles() {
        let around: DVec3 = triangle.iter().map(|&v| normals[v as usize]).sum();
        let [a, b, c] = film.corners(triangle);
        if measure::double_area_vector([a, b, c]).dot(around) < 0.0 {
            let shortest = a.distance(b).min(b.distance(c)).min(c.distance(a));
            triangle.iter().for_each(|&v| sizes[v as usize] = sizes[v as usize].min(0.5 * shortest));
        }
    }
    graded(film, &mut sizes);
    sizes
}
