//! Estimates the area of the smooth minimal surface on the same boundary polygon from two meshes (Richardson
//! extrapolation).
//!
//! As long as the surface is smooth up to the boundary, the area of a minimal mesh of well-shaped triangles exceeds the
//! area of the surface by a multiple of h². With every edge halved the excess is a quarter. The limit is therefore
//! A_fine - (A_coarse - A_fine) / 3. At a corner of the polygon with an angle above 180° the order is lower, and the
//! limit is a little too large. The error estimate, which is the whole correction of the finer area, covers that.

use super::run::ExtrapolatedArea;
use crate::equilibrium::NormalMotion;
use crate::equilibrium::newton::{Aim, Outcome, Settings, iterate};
use crate::equilibrium::v_cycle::VCycleSteps;
use crate::mesh::film::Film;
use crate::remesh::subdivision::subdivide;
use crate::sparse::multigrid::{Hierarchy, parents_of};
use crate::sparse::pattern::Pattern;
use crate::{Execution, Interruption};

/// Residual to which the finer mesh is solved. A larger value takes fewer steps; the error of the area is about the
/// square of it.
const TOLERANCE: f64 = 1e-3;
/// Largest number of Newton steps on the finer mesh.
const MAX_STEPS: u32 = 6;

impl ExtrapolatedArea {
    /// Halves the edges of a converged stable film, corrects that mesh, and extrapolates. The top level of `hierarchy`
    /// is the second variation at the film. `None` if the finer mesh cannot be corrected in a few steps.
    ///
    /// # Errors
    /// The interruption.
    pub(in crate::minimal_surface) fn of(
        film: &Film,
        pattern: &Pattern,
        hierarchy: &Hierarchy,
        radius: f64,
        exec: &Execution,
    ) -> Result<Option<Self>, Interruption> {
        exec.look(4 * film.triangles().len() as u64)?;
        let (mut fine, midpoints) = subdivide(film);
        let finer = Pattern::new(fine.triangles(), &fine.fixed);
        let parents = parents_of(&pattern.free.unknown, &finer.free.vertex, &midpoints);
        let mut steps = VCycleSteps { hierarchy, parents, matrix: finer.matrix(), exec };
        let settings = Settings { aim: Aim::Minimum, tolerance: TOLERANCE, max_steps: MAX_STEPS };
        let motion = NormalMotion { pattern: &finer, triangles: fine.topology.triangles(), radius };
        let (outcome, state) = iterate(&mut fine.vertices, &motion, &mut steps, &settings, exec, &mut |_, _| {});
        match outcome {
            Outcome::Converged => Ok(Some(Self::new(film.area(), state.energy))),
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
