//! The area of the smooth minimal surface on the same boundary polygon, from two meshes (Richardson).
//!
//! The area of a mesh of good triangles, minimal among its kind, is above the surface's by a multiple of h² as long as
//! the surface is smooth up to the boundary. With every edge halved the excess is a quarter: the limit is
//! A_fine - (A_coarse - A_fine) / 3. At a corner of the polygon whose angle is above 180 degrees the order is lower and the limit
//! a little above the true one; the error estimate, the whole correction of the finer area, covers that.

use super::coarse_to_fine::Cascade;
use super::cotangent::Pattern;
use super::film::Film;
use super::multigrid::{Hierarchy, parents_of};
use super::newton::{Aim, Outcome, Settings, iterate};
use super::remesh::subdivide;
use crate::{Execution, Interruption};

/// The residual to which the finer mesh is brought: the error of its area is about the square of that.
const TOLERANCE: f64 = 1e-3;
const MAX_STEPS: u32 = 6;

/// An area extrapolated to edges of length zero, in u².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtrapolatedArea {
    pub area: f64,
    /// How far that may be off: its distance from the finer of the two areas it comes from.
    pub error_estimate: f64,
}

impl ExtrapolatedArea {
    /// From the areas of two minimal meshes on one boundary polygon, the finer with every edge halved.
    pub(super) fn new(coarse: f64, fine: f64) -> Self {
        let correction = (coarse - fine) / 3.0;
        Self { area: fine - correction, error_estimate: correction.abs() }
    }

    /// For a converged stable film: halves its edges, corrects that mesh, and extrapolates. The top level of `hierarchy` is the
    /// second variation where the film stands. `None` where the finer mesh cannot be corrected in a few steps.
    ///
    /// # Errors
    /// The interruption.
    pub(super) fn of(
        film: &Film,
        pattern: &Pattern,
        hierarchy: &Hierarchy,
        radius: f64,
        exec: &Execution,
    ) -> Result<Option<Self>, Interruption> {
        exec.look(4 * film.triangles().len() as u64)?;
        let (mut fine, midpoints) = subdivide(film);
        let finer = Pattern::new(fine.triangles(), &fine.fixed);
        let parents = parents_of(&pattern.unknown, &finer.vertex, &midpoints);
        let mut cascade = Cascade { hierarchy, parents, matrix: finer.matrix(), exec };
        let settings = Settings { aim: Aim::Minimum, tolerance: TOLERANCE, max_steps: MAX_STEPS, radius };
        let (outcome, state) = iterate(&mut fine, &finer, &mut cascade, &settings, exec, &mut |_, _| {});
        match outcome {
            Outcome::Converged => Ok(Some(Self::new(film.area(), state.first.area))),
            Outcome::Interrupted(interruption) => Err(interruption),
            Outcome::Stalled | Outcome::StepsUsed | Outcome::Refused(_) => Ok(None),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excess_in_h_squared_is_taken_off_exactly() {
        let area = |h: f64| 2.0 + 0.3 * h * h;
        let extrapolated = ExtrapolatedArea::new(area(0.2), area(0.1));
        assert!((extrapolated.area - 2.0).abs() < 1e-15);
        assert!((extrapolated.error_estimate - 0.003).abs() < 1e-15);
    }
}
