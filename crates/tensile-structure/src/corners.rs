//! Corners of a film between edge cables: whether they can be open at all, and which are nearly closed.
//!
//! A weightless film of one tension σ without pressure is a minimal surface, so its Gaussian curvature K is nowhere
//! positive. A cable of force F along its edge has the geodesic curvature σ / F, and turns the edge by σ L / F over its
//! length L. A straight fixed edge turns by nothing. With the interior angles θ of the corners, Gauss and Bonnet's
//! theorem says
//!
//! ```text
//! ∫ K dA + Σ (π - θ) - Σ σ L / F = 2 π χ    hence    Σ σ L / F ≤ Σ (π - α) - 2 π χ
//! ```
//!
//! where α is a lower bound of θ: the angle between the edges if both are fixed, otherwise 0. A mesh has a little
//! positive curvature where corners close, so that it can balance although no film does.

use super::form_finding::Found;
use super::model::{Model, ModelCable, forces};
use super::options::{Course, FilmPrestress, FilmStress, Pressure, Structure, cable_place};
use plateau_mesh::codes::{Reason, WarningCode};
use plateau_mesh::error::{InputError, Warning};
use plateau_mesh::measure::angle;
use plateau_mesh::{DVec3, Error};
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Excess over the largest turn, in radians, above which a film is refused. The lengths of cables are known to 1e-4 of
/// their value on a mesh of 2,000 triangles, which is 6e-4 of a whole turn.
const EXCESS: f64 = 5e-3;
/// A corner between cables is reported as nearly closed below this angle, in degrees. The warning names the forces that
/// would open it to this angle.
const NEARLY_CLOSED: f64 = 5.0;

/// Returns the turn σ L / F of each cable along the boundary, 0 for other cables. Returns `None` if the film does not
/// have one tension, or if something else than cables of one force curves its edge.
fn turns(structure: &Structure, model: &Model, found: &Found, at: &[DVec3]) -> Option<Vec<f64>> {
    let [FilmStress { prestress: FilmPrestress::Isotropic(tension), weight }] = structure.layers[..] else {
        return None;
    };
    let presses = |holds: Pressure| !matches!(holds, Pressure::Constant(0.0));
    if weight > 0.0 || !model.sliding.is_empty() || structure.chambers.iter().any(|chamber| presses(chamber.holds)) {
        return None;
    }
    let turn = |(k, cable): (usize, &super::options::Cable)| {
        let ModelCable { term, .. } = &model.cables[k];
        match cable.course {
            Course::Across(_) => None,
            Course::Boundary { .. } => {
                let force = forces(term, found.length_forces[k], at).0;
                (cable.weight == 0.0 && force > 0.0).then(|| tension * term.length(at) / force)
            }
            Course::Air(_) | Course::Mast(_) => Some(0.0),
        }
    };
    structure.cables.iter().enumerate().map(turn).collect()
}

/// The error for a film whose edge cables turn further than any film between its corners lets them.
pub(super) fn impossible(structure: &Structure, model: &Model, found: &Found, at: &[DVec3]) -> Option<Error> {
    let turns = turns(structure, model, found, at)?;
    let turn: f64 = turns.iter().sum();
    let most = largest_turn(model, structure, at);
    if turn <= most + EXCESS {
        return None;
    }
    let detail = format!(
        "no shape in equilibrium exists: with these forces the edge cables turn by {:.1} degrees in all, and a film \
         between these corners lets them turn by {:.1} degrees at most (Gauss and Bonnet), so it closes at its corners; \
         give the edge cables larger forces, by a factor above {:.3}",
        turn.to_degrees(),
        most.to_degrees(),
        turn / most.max(f64::MIN_POSITIVE)
    );
    let named = turns.iter().enumerate().filter(|(_, turn)| **turn > 0.0).map(|(k, turn)| {
        let detail = format!("is too small: the cable turns by {:.1} degrees", turn.to_degrees());
        InputError::new(cable_place(structure, k).then("value"), detail)
    });
    Some(Error::NoResult { reason: Reason::NoEquilibrium, detail, places: named.collect() })
}

/// The largest turn that a film lets the cables along its edges have, in radians.
fn largest_turn(model: &Model, structure: &Structure, at: &[DVec3]) -> f64 {
    let (mut held_by_cables, mut inside) = (BTreeSet::new(), BTreeSet::new());
    for (own, cable) in model.cables.iter().zip(&structure.cables) {
        if matches!(cable.course, Course::Boundary { .. }) {
            held_by_cables.extend(own.chain.windows(2).map(|ends| [ends[0].min(ends[1]), ends[0].max(ends[1])]));
            inside.extend(own.chain.get(1..own.chain.len().saturating_sub(1)).unwrap_or_default().iter().copied());
        }
    }
    let boundaries = model.boundaries();
    let mut most = -2.0 * PI * (2.0 - boundaries.len() as f64);
    for ring in boundaries {
        let count = ring.len();
        for k in 0..count {
            let [before, v, after] = [ring[(k + count - 1) % count], ring[k], ring[(k + 1) % count]];
            if inside.contains(&v) {
                continue;
            }
            let is_fixed = |a: u32, b: u32| !held_by_cables.contains(&[a.min(b), a.max(b)]);
            let [p, corner, q] = [before, v, after].map(|v| at[v as usize]);
            let least = if is_fixed(before, v) && is_fixed(v, after) { angle(p - corner, q - corner) } else { 0.0 };
            most += PI - least;
        }
    }
    most
}

/// A warning for each corner between cables that is nearly closed.
pub(super) fn nearly_closed(structure: &Structure, model: &Model, found: &Found, at: &[DVec3]) -> Vec<Warning> {
    let Some(turns) = turns(structure, model, found, at) else { return Vec::new() };
    let mut angles = vec![0.0; at.len()];
    for triangle in model.layers[0].film.triangles() {
        for k in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|i| at[triangle[(k + i) % 3] as usize]);
            angles[triangle[k] as usize] += angle(b - a, c - a);
        }
    }
    let warning = |(v, boundary, point): (u32, usize, usize)| {
        let theta = angles[v as usize];
        let degrees = theta.to_degrees();
        if degrees >= NEARLY_CLOSED {
            return None;
        }
        let detail = format!(
            "the film is nearly closed at point {point} of boundary {boundary}: its sides meet at \
                              {degrees:.2} degrees"
        );
        let warning = |detail: String| {
            let warning = Warning::new(WarningCode::ClosingCorner, detail);
            warning.with_count("boundary", boundary).with_count("point", point).with("angle_deg", degrees)
        };
        let meeting: Vec<usize> =
            (0..turns.len()).filter(|&k| turns[k] > 0.0 && model.cables[k].ends().contains(&v)).collect();
        // Half of a cable's turn lies between its chord and its end. A force larger by the factor f leaves 1 / f of it.
        let half: f64 = meeting.iter().map(|&k| 0.5 * turns[k]).sum();
        let wider = NEARLY_CLOSED.to_radians() - theta;
        if half <= wider {
            return Some(warning(detail));
        }
        let factor = half / (half - wider);
        let wanted = meeting.iter().map(|&k| {
            let force = factor * forces(&model.cables[k].term, found.length_forces[k], at).0;
            format!("{force:.4} in cable {}", structure.cables[k].name)
        });
        let wanted = wanted.collect::<Vec<_>>().join(" and ");
        Some(warning(format!("{detail}; about {wanted} would open it to 5 degrees")).with("force_factor", factor))
    };
    model.corners().into_iter().filter_map(warning).collect()
}
