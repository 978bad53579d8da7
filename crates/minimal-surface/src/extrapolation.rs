//! Estimates the area of the smooth minimal surface on the same boundary polygon from two meshes (Richardson
//! extrapolation).
//!
//! If the surface is smooth up to the boundary, the area of a minimal mesh of well-shaped triangles exceeds the area of
//! the surface by a multiple of h², where h is the edge length. Halving every edge divides the excess by four. The
//! limit is therefore A_fine - (A_coarse - A_fine) / 3, and the error estimate is the whole correction that is
//! subtracted from A_fine.
//!
//! At a corner of the polygon where the film has an angle ω above 180° the surface behaves like r^(π/ω), and the excess
//! tends to fall with h^(2π/ω) only. The limit is then the mean of the two extrapolations with h^(2π/ω) and with h².
//! The error estimate is twice the correction, because on coarse meshes the order can be lower still (0.9 was seen
//! where the theory gives 1.15).

use super::run::ExtrapolatedArea;
use plateau_equilibrium::newton::{Aim, Equations, Outcome, Settings, iterate};
use plateau_equilibrium::normal_motion::NormalMotion;
use plateau_equilibrium::stability::{Margin, stretching};
use plateau_equilibrium::v_cycle::VCycleSteps;
use plateau_mesh::film::Film;
use plateau_mesh::measure;
use plateau_mesh::remesh::subdivision::subdivide;
use plateau_mesh::sparse::multigrid::{Hierarchy, parents_of, prolong};
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::sparse::{CgFailure, SymmetricMatrix};
use plateau_mesh::{DVec3, Execution, Interruption};
use std::f64::consts::{PI, TAU};

/// Residual to which the finer mesh is solved. The error of the area is about its square.
const TOLERANCE: f64 = 1e-3;
/// Largest number of Newton steps on the finer mesh.
const MAX_STEPS: u32 = 6;
/// Residual to which the linear systems of a margin are solved, as a fraction of the right-hand side. The error of the
/// margin is about its square.
const MARGIN_SOLVES: f64 = 1e-3;

/// A boundary vertex is a re-entrant corner if the angle of the film there exceeds 180 degrees by more than this
/// (radians). The vertices of a smooth curve that is sampled with a dozen points or more stay below it.
const RE_ENTRANT: f64 = std::f64::consts::FRAC_PI_6;

/// Power of the edge length with which the area of a film's meshes tends to its limit: 2, or 2π/ω if the film has the
/// angle ω at its widest re-entrant corner.
pub(crate) fn order(film: &Film) -> f64 {
    let mut angles = vec![0.0; film.vertices.len()];
    for &triangle in film.triangles() {
        let [a, b, c] = film.corners(triangle);
        let inner_angle = |a: DVec3, b: DVec3, c: DVec3| measure::angle(b - a, c - a);
        for (v, angle) in triangle.into_iter().zip([inner_angle(a, b, c), inner_angle(b, c, a), inner_angle(c, a, b)]) {
            angles[v as usize] += angle;
        }
    }
    let widest = film.boundaries.iter().flatten().map(|&v| angles[v as usize]).fold(0.0, f64::max);
    if widest > PI + RE_ENTRANT { TAU / widest } else { 2.0 }
}

/// Figures of the finer film, whose mesh has every edge of the film halved.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Finer {
    pub area: ExtrapolatedArea,
    /// The [`Margin`] of the finer film, if it was asked for and could be computed.
    pub margin: Option<f64>,
}

impl Finer {
    /// Halves the edges of a converged stable film, corrects the finer mesh by Newton's method, and extrapolates the
    /// area. The top level of `hierarchy` is the second variation at the film. `motion` is the motion that gives the
    /// film's margin, or `None` if the margin of the finer film is not wanted. Returns `None` if the finer mesh cannot
    /// be corrected in a few steps.
    ///
    /// # Errors
    /// The interruption.
    pub fn of(
        film: &Film,
        pattern: &Pattern,
        hierarchy: &Hierarchy,
        radius: f64,
        motion: Option<&[f64]>,
        exec: &Execution,
    ) -> Result<Option<Self>, Interruption> {
        exec.look(4 * film.triangles().len() as u64)?;
        let (mut fine, midpoints) = subdivide(film);
        let finer = Pattern::new(fine.triangles(), &fine.fixed);
        let parents = parents_of(&pattern.free.unknown, &finer.free.vertex, &midpoints);
        let mut steps = VCycleSteps { hierarchy, parents, matrix: finer.matrix() };
        let settings = Settings { aim: Aim::Minimum, tolerance: TOLERANCE, max_steps: MAX_STEPS };
        let equations = NormalMotion { pattern: &finer, triangles: fine.topology.triangles(), radius };
        let (outcome, state) = iterate(&mut fine.vertices, &equations, &mut steps, &settings, exec, &mut |_, _| {});
        match outcome {
            Outcome::Converged => {}
            Outcome::Interrupted(interruption) => return Err(interruption),
            Outcome::Stalled | Outcome::StepsUsed | Outcome::Refused(_) => return Ok(None),
        }
        let margin = match motion {
            Some(motion) => {
                let VCycleSteps { parents, mut matrix, .. } = steps;
                equations.second_variation(&fine.vertices, &state, 0.0, &mut matrix);
                let stretching = stretching(&fine.vertices, &equations, &state, &matrix);
                margin(&matrix, &stretching, hierarchy, &parents, prolong(motion, &parents), exec)?
            }
            None => None,
        };
        Ok(Some(Self { area: ExtrapolatedArea::new(film.area(), state.energy, order(film)), margin }))
    }
}

/// Computes the margin at the finest of nested levels. The iteration starts from `start`, an estimate of the motion
/// that gives the margin. Its linear systems are solved by conjugate gradients, which the levels below precondition.
/// Returns `None` if the conjugate gradients do not converge, or if the second variation is not positive definite.
///
/// # Errors
/// The interruption.
pub(crate) fn margin(
    matrix: &SymmetricMatrix,
    stretching: &SymmetricMatrix,
    hierarchy: &Hierarchy,
    parents: &[[u32; 2]],
    start: Vec<f64>,
    exec: &Execution,
) -> Result<Option<f64>, Interruption> {
    let norm = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let found = Margin::of(matrix, stretching, start, |x| {
        let goal = MARGIN_SOLVES * norm(x);
        match hierarchy.solve(matrix, parents, x, |residual| norm(residual) <= goal, exec) {
            Ok(solved) => {
                x.copy_from_slice(&solved);
                Ok(true)
            }
            Err(CgFailure::Interrupted(interruption)) => Err(interruption),
            Err(CgFailure::Indefinite | CgFailure::Slow) => Ok(false),
        }
    })?;
    Ok(found.map(|margin| margin.value).filter(|&margin| margin > 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excess_in_h_squared_is_taken_off_exactly() {
        let area = |h: f64| 2.0 + 0.3 * h * h;
        let extrapolated = ExtrapolatedArea::new(area(0.2), area(0.1), 2.0);
        assert!((extrapolated.area - 2.0).abs() < 1e-15);
        assert!((extrapolated.error_estimate - 0.003).abs() < 1e-15);
    }

    #[test]
    fn a_limit_of_a_lower_order_is_within_the_error_estimate() {
        for order in [1.0, 1.2, 1.5, 2.0] {
            let area = |h: f64| 2.0 + 0.3 * libm::pow(h, order);
            let extrapolated = ExtrapolatedArea::new(area(0.2), area(0.1), 1.0);
            assert!((extrapolated.area - 2.0).abs() <= extrapolated.error_estimate, "{order}: {extrapolated:?}");
        }
    }
}
