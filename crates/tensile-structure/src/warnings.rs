//! Warnings about a found shape.

use super::form_finding::Found;
use super::model::Model;
use super::options::{Course, Structure, Weave, WeaveHold, cable_place};
use super::ponding::Ponding;
use super::shape::{CableResult, ChamberResult, Statistics, WeaveStress};
use plateau_equilibrium::Support;
use plateau_equilibrium::stability::stability_warnings;
use plateau_mesh::codes::WarningCode;
use plateau_mesh::crossing::passage;
use plateau_mesh::error::Warning;
use plateau_mesh::{DVec3, Execution, Interruption};
use std::sync::Arc;

/// A structure counts as a mechanism if the magnitude of its lowest eigenvalue is below this value, in units of 1/R²
/// with the radius R of the mesh. The lowest eigenvalue of a plane film between cables is about 1 to 10.
const MECHANISM: f64 = 1e-6;

/// The warning about a mechanism names the points that move by more than this fraction of the largest displacement in
/// the lowest mode.
const MOVES: f64 = 0.5;

/// A woven film gets a warning if the root mean square of the relative deviation of its stresses from the required ones
/// exceeds this value. On the meshes of the examples the mesh's error alone causes a deviation below 0.02.
const DEVIATES: f64 = 0.05;

/// A sliding edge counts as beyond the mesh of its support if a vertex is farther from the mesh than this fraction of
/// the mesh's rounding. The rounding of a right angle of the mesh alone moves a vertex away by 0.14 times the rounding.
const BEYOND: f64 = 0.5;

/// Maximum number of points that a message lists.
const LISTED: usize = 12;

pub(super) fn warn(
    model: &Model,
    found: &Found,
    structure: &Structure,
    statistics: &Statistics,
    cables: &[CableResult],
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    for (k, (cable, result)) in structure.cables.iter().zip(cables).enumerate() {
        if result.slack {
            let detail = format!("cable {} carries no force: it is longer than the shape needs", cable.name);
            warnings.push(Warning::new(WarningCode::SlackCable, detail).with_count("cable", k));
        }
    }
    if !statistics.converged {
        let detail = format!(
            "the residual is {:.1e} ({}): forces and lengths are not those of an equilibrium",
            statistics.residual,
            statistics.stop_reason.name()
        );
        warnings.push(Warning::new(WarningCode::NotConverged, detail).with("residual", statistics.residual));
    } else if statistics.balance.is_none() {
        let detail =
            "the forces within the film could not be balanced, so there are no reactions; try another resolution";
        warnings.push(Warning::new(WarningCode::NotBalanced, detail));
    }
    warnings.extend(beyond_their_mesh(model));
    if let Some(weave) = statistics.stress.and_then(|stress| stress.weave)
        && weave.deviation_rms > DEVIATES
    {
        let warning = Warning::new(WarningCode::StressDeviates, deviating_stress(&weave, structure));
        warnings.push(warning.with("deviation_rms", weave.deviation_rms));
    }
    if let Some(Ponding { depth, place: DVec3 { x, y, z }, .. }) = statistics.ponding {
        let detail = format!(
            "water would stand up to {depth:.4} deep on the film, deepest at ({x:.4}, {y:.4}, {z:.4}), because it \
             cannot run off over an edge; its weight would deepen the hollow (ponding)"
        );
        warnings.push(Warning::new(WarningCode::Ponding, detail).with("depth", depth).with_place([x, y, z]));
    }
    for (chamber, ChamberResult { volume, .. }) in structure.chambers.iter().zip(&statistics.chambers) {
        let next = chamber.below + 1;
        if next < structure.layers.len() && *volume <= 0.0 {
            let detail = format!(
                "layer {next} lies in front of layer {}: the volume between them is {volume:.4}, and they do not press \
                 on each other here as they would in fact; change the pressures",
                chamber.below
            );
            warnings
                .push(Warning::new(WarningCode::LayersCross, detail).with_count("layer", next).with("volume", *volume));
        }
    }
    if let Some(stability) = statistics.stability {
        let radius = plateau_mesh::polyline::radius(&model.mesh().vertices);
        if (stability.lowest_eigenvalue * radius * radius).abs() < MECHANISM {
            warnings.push(Warning::new(WarningCode::Mechanism, mechanism(model, found)));
        } else {
            warnings.extend(stability_warnings(stability.morse_index, stability.least_index, |index| {
                format!("the shape is in equilibrium but no minimum of the energy ({index}): it would leave it")
            }));
        }
    }
    warnings
}

/// A warning for each cable or mast in the air that passes through the film.
///
/// # Errors
/// The interruptions of `exec`.
pub(super) fn piercing(model: &Model, structure: &Structure, exec: &Execution) -> Result<Vec<Warning>, Interruption> {
    let (at, triangles) = (model.vertices(), model.triangles());
    let mut warnings = Vec::new();
    for (k, cable) in structure.cables.iter().enumerate() {
        if !matches!(cable.course, Course::Air(_) | Course::Mast(_)) {
            continue;
        }
        for ends in model.cables[k].chain.windows(2) {
            let ends = [ends[0], ends[1]].map(|v| at[v as usize]);
            if let Some(place) = passage(ends, &at, &triangles, exec)? {
                let DVec3 { x, y, z } = place + model.centre;
                let is_mast = cable.course.is_mast();
                let what = if is_mast { "mast" } else { "cable" };
                let before = &structure.cables[..k];
                let number = before.iter().filter(|other| other.course.is_mast() == is_mast).count();
                let detail = format!(
                    "{what} {} passes through the film at ({x:.4}, {y:.4}, {z:.4}), where neither bears on the other \
                     here; move its ends, or give the film an opening ({})",
                    cable.name,
                    cable_place(structure, k)
                );
                warnings.push(
                    Warning::new(WarningCode::PiercesFilm, detail).with_count(what, number).with_place([x, y, z]),
                );
                break;
            }
        }
    }
    Ok(warnings)
}

/// A warning for each support mesh beyond whose border an edge has slid.
fn beyond_their_mesh(model: &Model) -> Vec<Warning> {
    let at = model.vertices();
    let beyond = |(number, support): (usize, &Arc<dyn Support>)| {
        let extent = support.extent()?;
        let own = model.sliding.iter().filter(|(_, freedom)| freedom.support() == Some(number as u32));
        let farthest = own.map(|(v, _)| extent.distance(at[*v as usize])).fold(0.0, f64::max);
        (farthest > BEYOND * extent.rounding()).then(|| {
            let detail = format!(
                "the edge on the mesh of support {number} has slid up to {farthest:.6} beyond the mesh, which goes on \
                 flat there; make the mesh larger"
            );
            Warning::new(WarningCode::BeyondSupport, detail).with_count("support", number).with("distance", farthest)
        })
    };
    model.supports.iter().enumerate().filter_map(beyond).collect()
}

/// The message about stresses of a woven film that differ from the required ones.
fn deviating_stress(weave: &WeaveStress, structure: &Structure) -> String {
    let required = |of: fn(&Weave) -> f64| structure.weave().map_or(0.0, of);
    let (warp, weft) = (required(|weave| weave.warp), required(|weave| weave.weft));
    let (cause, remedy) = match weave.hold {
        WeaveHold::Magnitudes => (
            format!("no film of this shape is in equilibrium with {warp} along the warp and {weft} along the weft"),
            "with hold: ratio both vary by a common factor",
        ),
        WeaveHold::Ratio => (
            format!("no film of this shape is in equilibrium with the ratio {:.3} everywhere", weave.required_ratio),
            "try other directions or a ratio nearer to 1",
        ),
    };
    format!(
        "{cause}; the returned forces balance with {:.4} to {:.4} along the warp and {:.4} to {:.4} along the weft, \
         which deviates by {:.1} % (root mean square); {remedy}",
        weave.warp.min,
        weave.warp.max,
        weave.weft.min,
        weave.weft.max,
        100.0 * weave.deviation_rms
    )
}

/// The message about a mechanism, which lists the points that move freely.
fn mechanism(model: &Model, found: &Found) -> String {
    let mode = found.lowest_mode.as_deref().unwrap_or_default();
    let moves = |v: u32| mode.get(v as usize).is_some_and(|d| d.length() > MOVES);
    let mut points = Vec::new();
    for (boundary, numbers) in model.input_vertices.iter().enumerate() {
        points.extend(
            numbers.iter().enumerate().filter(|(_, v)| moves(**v)).map(|(k, _)| format!("/boundaries/{boundary}/{k}")),
        );
    }
    let count = (0..mode.len() as u32).filter(|&v| moves(v)).count();
    let named = if points.is_empty() {
        "none of them a point of the boundaries".to_owned()
    } else {
        format!("among them {}", points.iter().take(LISTED).cloned().collect::<Vec<_>>().join(", "))
    };
    format!("the structure moves freely: nothing resists a motion of {count} vertices, {named}; add supports or cables")
}
