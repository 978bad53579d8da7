//! Checks of chambers and of the pressures in them.

use super::requirement::require;
use crate::options::{
    Cable, CableMode, Chamber, Course, FilmPrestress, Pressure, Structure, Weave, WeaveHold, chamber_place,
};
use plateau_mesh::error::InputError;
use plateau_mesh::plane::polygon::doubled_area_vector;
use plateau_mesh::{Place, polyline};

pub(super) fn check_chambers(structure: &Structure, errors: &mut Vec<InputError>) {
    let last = structure.layers.len() - 1;
    let before = errors.len();
    for (k, chamber) in structure.chambers.iter().enumerate() {
        let below = || Place::field("chambers").at(k).then("below");
        if chamber.below > last {
            let detail = format!("there are {} layers, numbered from 0", structure.layers.len());
            errors.push(InputError::new(below(), detail));
            continue;
        }
        let same = structure.chambers[..k].iter().position(|other| other.below == chamber.below);
        if let Some(other) = same {
            let detail = format!("is the layer of chamber {other}: there is one space below each layer");
            errors.push(InputError::new(below(), detail));
            continue;
        }
        check_chamber(structure, k, errors);
    }
    for layer in 0..last {
        if !structure.chambers.iter().any(|chamber| chamber.below == layer) {
            let detail = format!("needs one below layer {layer}: without it layers {layer} and {} touch", layer + 1);
            errors.push(InputError::new(Place::field("chambers"), detail));
        }
    }
    if errors.len() == before {
        check_pressures(structure, errors);
    }
}

fn check_chamber(structure: &Structure, k: usize, errors: &mut Vec<InputError>) {
    let Chamber { below, holds } = structure.chambers[k];
    let place = || chamber_place(structure, k);
    let (Pressure::Constant(value) | Pressure::Volume(value)) = holds;
    if !value.is_finite() {
        errors.push(InputError::new(place(), "must be a finite number"));
        return;
    }
    // The space between two layers is closed even if their common edge moves. The space below the last layer is not.
    if below + 1 == structure.layers.len() {
        let hangs = structure.cables.iter().any(|cable| matches!(cable.course, Course::Boundary { .. }));
        let moving_edges = [
            (hangs, "a film whose edge hangs on a cable"),
            (!structure.sliding.is_empty(), "a film whose edge slides"),
            (!structure.rings.is_empty(), "a film with a ring that moves"),
        ];
        if let Some((_, film)) = moving_edges.into_iter().find(|(moves, _)| *moves) {
            let detail = format!("is not offered for {film}, because the space below it is not closed");
            errors.push(InputError::new(place(), detail));
            return;
        }
    }
    if let Pressure::Volume(volume) = holds {
        let detail = if structure.layers.len() > 1 {
            "must be above 0"
        } else {
            "must be above 0; reverse the first boundary to inflate the other side"
        };
        require(errors, volume > 0.0, place(), detail);
    }
}

/// Returns the chamber below a layer, or `None` if the space there is not closed. `layer` is `None` for the space in
/// front of the first layer, which is never closed.
fn chamber_below(structure: &Structure, layer: Option<usize>) -> Option<usize> {
    structure.chambers.iter().position(|chamber| Some(chamber.below) == layer)
}

/// For each layer the pressure below it minus the pressure above it, and a chamber from which this difference follows.
/// `None` if one of the two pressures is not known before the solve.
fn known_differences(structure: &Structure) -> Vec<Option<(f64, usize)>> {
    let known = |layer: Option<usize>| match chamber_below(structure, layer) {
        None => Some((0.0, None)),
        Some(k) => match structure.chambers[k].holds {
            Pressure::Constant(pressure) => Some((pressure, Some(k))),
            Pressure::Volume(_) => None,
        },
    };
    let difference = |layer: usize| {
        let ((below, own), (above, other)) = (known(Some(layer))?, known(layer.checked_sub(1))?);
        Some((below - above, own.or(other)?))
    };
    (0..structure.layers.len()).map(difference).collect()
}

/// Refuses pressures above the limits of the openings, and pressures that press one layer through another.
fn check_pressures(structure: &Structure, errors: &mut Vec<InputError>) {
    let differences = known_differences(structure);
    let before = errors.len();
    for (layer, known) in differences.iter().enumerate() {
        let Some((difference, chamber)) = *known else { continue };
        let limit = pressure_limit(structure, layer);
        let place = chamber_place(structure, chamber);
        if difference.abs() <= limit || errors.iter().any(|error| error.place == place) {
            continue;
        }
        let of_layer = if structure.layers.len() > 1 {
            format!("makes a difference of {difference:.6} between the two sides of layer {layer}, which ")
        } else {
            String::new()
        };
        let detail = format!(
            "{of_layer}is above the limit of the opening, {limit:.6}: the film's tension times the length of the \
             boundary, and the forces of the cables across the film at their ends, divided by the area that the \
             boundary encloses; no film of this tension holds more"
        );
        errors.push(InputError::new(place, detail));
    }
    if errors.len() > before {
        return;
    }
    // Of two weightless layers over the same edge, the layer with the larger curvature lies in front. The curvature is
    // the pressure difference over the tension.
    for (layer, pair) in differences.windows(2).enumerate() {
        let [Some((above, chamber)), Some((below, _))] = *pair else { continue };
        let [upper, lower] = [layer, layer + 1].map(|k| &structure.layers[k]);
        if structure.has_heavy_layers() || above / upper.mean() > below / lower.mean() {
            continue;
        }
        let detail = format!(
            "presses layers {layer} and {} onto each other: the difference of the pressures on the two sides over the \
             tension must be larger for layer {layer} ({:.6}) than for the layer below it ({:.6})",
            layer + 1,
            above / upper.mean(),
            below / lower.mean()
        );
        errors.push(InputError::new(chamber_place(structure, chamber), detail));
    }
}

/// Returns the largest pressure that a layer of constant tension can hold. The tension σ along the perimeter P of the
/// opening and the forces F of the cables that end there must bear the pressure p on the opening's vector area A: |p A|
/// <= σ P + Σ F. For a woven film σ is the larger of the stresses of warp and weft.
///
/// The limit is infinite if the pressure is partly borne by something that is not known before the solve: by several
/// boundaries, whose openings may balance each other; by an edge that moves; by stresses that vary along the edge, as
/// in a heavy film; or by a cable across the film whose force at its ends is not given.
fn pressure_limit(structure: &Structure, layer: usize) -> f64 {
    let [points] = &structure.boundaries[..] else { return f64::INFINITY };
    let film = &structure.layers[layer];
    let hangs = structure.cables.iter().any(|cable| matches!(cable.course, Course::Boundary { .. }));
    if film.weight > 0.0 || hangs || !structure.sliding.is_empty() || !structure.rings.is_empty() {
        return f64::INFINITY;
    }
    let largest = match &film.prestress {
        FilmPrestress::Isotropic(tension) => *tension,
        FilmPrestress::Woven(Weave { hold: WeaveHold::Ratio, .. }) => return f64::INFINITY,
        FilmPrestress::Woven(weave) => weave.warp.max(weave.weft),
    };
    let across = structure.cables.iter().filter(|cable| matches!(cable.course, Course::Across(_)));
    let borne: f64 = across.map(|cable| forces_at_ends(structure, cable)).sum();
    (largest * polyline::length(points, true) + borne) / (0.5 * doubled_area_vector(points).length())
}

/// The sum of a cable's forces at its two ends, or infinity if the mode does not give them. The sum is infinite on a
/// woven film too, because the film pulls along the cable and changes the cable's force by an amount that is known only
/// with the shape.
fn forces_at_ends(structure: &Structure, cable: &Cable) -> f64 {
    if cable.weight > 0.0 || structure.weave().is_some() {
        return f64::INFINITY;
    }
    match cable.mode {
        CableMode::Force(force) | CableMode::EndTension(force) => 2.0 * force,
        CableMode::HorizontalComponent(_)
        | CableMode::ForceDensity(_)
        | CableMode::Length(_)
        | CableMode::UnstressedLength(_)
        | CableMode::Sag(_) => f64::INFINITY,
    }
}
