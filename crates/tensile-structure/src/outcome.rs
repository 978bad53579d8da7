//! Makes the result from a found shape: mesh, forces, figures and warnings, moved back to the position of the caller's
//! boundaries.

use super::corners;
use super::form_finding::{Ending, Found, SAME_FORCE};
use super::model::{Model, ModelCable, MovingRing, Stage, forces};
use super::options::{
    CableMode, Chamber, Course, FilmPrestress, FilmStress, Pressure, Ring, Structure, cable_place, chord, layer_place,
};
use super::ponding::{self, Ponding, Roof};
use super::reactions::{Hold, contact_angles, edge_forces, holds, reactions, sums};
use super::shape::{CableResult, ChamberResult, LayerResult, Statistics, TensileStructure};
use super::stress::{of_all, of_triangles, stress};
use super::warnings::{piercing, warn};
use plateau_equilibrium::energy::cable::Law;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::codes::Reason;
use plateau_mesh::error::InputError;
use plateau_mesh::measure::{self, Quality, double_area_vector};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Mesh};

/// A cable counts as slack if its largest force is at most this fraction of the film's tension times the cable's
/// length. Rounding errors are far below this bound. The force of a cable that holds a plane edge is far above it, at
/// least half the tension times the chord.
const SLACK: f64 = 1e-9;

/// Errors for edge cables whose force is too small to hold a plane edge: the arc of radius F / σ does not reach across
/// the chord.
fn weak_cables(structure: &Structure) -> Vec<InputError> {
    let [FilmStress { prestress: FilmPrestress::Isotropic(tension), .. }] = structure.layers[..] else {
        return Vec::new();
    };
    let weak = |(k, cable): (usize, &super::options::Cable)| {
        let CableMode::Force(force) = cable.mode else { return None };
        if !matches!(cable.course, Course::Boundary { .. }) {
            return None;
        }
        let least = 0.5 * tension * chord(structure, cable)?;
        (force < least).then(|| {
            let detail = format!("holds no plane edge of this film: half the tension times the chord is {least:.6}");
            InputError::new(cable_place(structure, k).then("value"), detail)
        })
    };
    structure.cables.iter().enumerate().filter_map(weak).collect()
}

/// Names what the caller may change in this structure, so that its form finding succeeds.
fn remedies(structure: &Structure) -> String {
    let mut remedies = Vec::new();
    if structure.cables.iter().any(|cable| !cable.course.is_mast()) {
        remedies.push("larger cable forces");
    }
    if structure.chambers.iter().any(|chamber| chamber.holds != Pressure::Constant(0.0)) {
        remedies.push("a smaller pressure");
    }
    if structure.weave().is_some() {
        remedies.push("more points on the boundaries");
    }
    remedies.push("supports nearer to each other");
    let last = remedies.pop().unwrap_or_default();
    if remedies.is_empty() { format!("try {last}") } else { format!("try {}, or {last}", remedies.join(", ")) }
}

/// The error for a search that found no shape.
fn no_shape(structure: &Structure, found: &Found) -> Error {
    let places = weak_cables(structure);
    let named = |detail: &str, own: Option<&InputError>| {
        let places = if places.is_empty() { own.cloned().into_iter().collect() } else { places.clone() };
        let remedy =
            if places.is_empty() { remedies(structure) } else { "give the edge cables larger forces".to_owned() };
        let detail = format!("no shape in equilibrium is reached: {detail}; {remedy}");
        Error::NoResult { reason: Reason::NoEquilibrium, detail, places }
    };
    match &found.ending {
        Some(Ending::RunsAway(detail, own) | Ending::Collapses(detail, own)) => named(detail, own.as_ref()),
        Some(Ending::NotFound(detail)) => {
            let detail = format!(
                "no shape in equilibrium was found, which does not say that there is none: {detail}; start nearer to \
                 the shape, or try another resolution"
            );
            Error::NoResult { reason: Reason::EquilibriumNotFound, detail, places }
        }
        // Form finding without remeshing has no ending; weak cables are its only evidence that there is no shape.
        None if !places.is_empty() => named("the film pulls the edge cables in without end", None),
        None => {
            let detail = format!(
                "no shape in equilibrium was found, which does not say that there is none; {}",
                remedies(structure)
            );
            Error::NoResult { reason: Reason::EquilibriumNotFound, detail, places }
        }
    }
}

/// The error for the first cable that would have to push, or that is slack at its given length.
fn pushing_cable(structure: &Structure, model: &Model, found: &Found, at: &[DVec3]) -> Option<Error> {
    let mean = |(cable, &further): (&ModelCable, &f64)| forces(&cable.term, further, at).0;
    let is_cable = |k: &usize| !structure.cables[*k].course.is_mast();
    let all = model.cables.iter().zip(&found.length_forces).map(mean).enumerate();
    let pushes = all.filter(|(_, force)| *force < 0.0).map(|(k, _)| k).find(is_cable);
    // An elastic cable may be slack; a cable of given length may not, because its length is not reached.
    let of_length = |k: &usize| matches!(structure.cables[*k].mode, CableMode::Length(_));
    let k = pushes.or_else(|| found.slack.iter().copied().find(of_length))?;
    let place = InputError::new(
        cable_place(structure, k).then("value"),
        "is longer than the film pulls it: the cable would be slack",
    );
    let detail = format!("cable {} would be slack at this length", structure.cables[k].name);
    Some(Error::NoResult { reason: Reason::SlackCable, detail, places: vec![place] })
}

/// The error for the first layer that would be in compression, because its weight is more than its tension can hold. A
/// film cannot push.
fn pushing_film(structure: &Structure, layers: &[LayerResult]) -> Option<Error> {
    let least = |layer: &LayerResult| layer.stress.map_or(f64::INFINITY, |stress| stress.min);
    let k = layers.iter().position(|layer| least(layer) < 0.0)?;
    let detail = format!(
        "the film would be in compression: its tension falls to {:.6} at its lowest point, because it grows with the \
         height by the weight per area; give it more tension",
        least(&layers[k])
    );
    let place = InputError::new(layer_place(structure, k), "is too heavy for its tension at this height");
    Some(Error::NoResult { reason: Reason::NoEquilibrium, detail, places: vec![place] })
}

/// Measures the shape and moves it back to the position of the input.
pub(super) fn finish(
    model: Model,
    found: Found,
    structure: &Structure,
    exec: &Execution,
) -> Result<TensileStructure, Error> {
    if !found.residual.is_finite() || (found.gave_up() && !(found.is_shape() && model.flipped() == 0)) {
        return Err(no_shape(structure, &found));
    }
    let at = model.vertices();
    if let Some(error) = pushing_cable(structure, &model, &found, &at) {
        return Err(error);
    }
    if let Some(error) = corners::impossible(structure, &model, &found, &at) {
        return Err(error);
    }
    let film = model.mesh();
    let triangles = film.triangles.clone();
    let (layers, edge_lengths) = measure_layers(&model, &found, structure, &at)?;
    if let Some(error) = pushing_film(structure, &layers) {
        return Err(error);
    }
    let cables = cables(&model, &found, structure, &at);
    let quality = Quality::of(&film, &edge_lengths, model.flipped());
    let (minimum_slope, flattest_place) = flattest(&triangles, &at, structure.up);
    let (rims, folds) = (model.boundaries(), &model.layers[0].film.locked);
    let ponding = ponding::find(&Roof { triangles: &triangles, at: &at, rims, folds, up: structure.up }, exec)?;
    let chamber =
        |(chamber, &pressure): (&Chamber, &f64)| ChamberResult { pressure, volume: model.volume(chamber.below, &at) };
    let chambers = structure.chambers.iter().zip(&found.pressures).map(chamber).collect();
    let mesh = Mesh::new(at.iter().map(|p| *p + model.centre).collect(), triangles.clone());
    let holds = holds(&model);
    let balance = found.balance.as_ref().map(|balance| sums(&model, balance, &holds, &at));
    let of_all_triangles = |balance| of_triangles(balance, &triangles, &at);
    let stresses = found.balance.as_ref().map(of_all_triangles).unwrap_or_default();
    let edge_forces = edge_forces(&model, &holds, &triangles, &stresses, &at);
    let reactions = reactions(&model, &found, &holds, &edge_forces);
    let statistics = Statistics {
        // The energy is that of the mesh that is returned, whichever step ended the search.
        energy: model.body(structure, 1.0, Stage::Exact)?.energy(),
        vertices: at.len(),
        triangles: triangles.len(),
        area: measure::area(&film),
        stress: of_all(&layers),
        layers,
        chambers,
        residual: found.residual,
        converged: found.stop_reason == StopReason::Residual && quality.is_sound(),
        stop_reason: found.stop_reason,
        iterations: found.iterations,
        balance,
        contact_angle: found.balance.as_ref().and_then(|balance| contact_angles(&model, balance, &holds, &at)),
        stability: found.stability,
        minimum_slope,
        flattest_place: flattest_place + model.centre,
        ponding: ponding.map(|ponding| Ponding { place: ponding.place + model.centre, ..ponding }),
        quality,
    };
    let mut warnings = model.warnings.clone();
    warnings.extend(warn(&model, &found, structure, &statistics, &cables));
    warnings.extend(corners::nearly_closed(structure, &model, &found, &at));
    match piercing(&model, structure, exec) {
        Ok(found) => warnings.extend(found),
        // The shape is complete, so it is returned without this search.
        Err(Interruption::DeadlinePassed) => {}
        Err(cancelled) => return Err(cancelled.into()),
    }
    let mut vertices = mesh.vertices;
    place_supports(structure, &model, &holds, &mut vertices);
    let ring_travels = ring_travels(structure, &model, &vertices);
    Ok(TensileStructure {
        mesh: Mesh::new(vertices, triangles),
        boundaries: model.boundaries().to_vec(),
        input_vertices: model.input_vertices,
        stresses,
        cables,
        reactions: reactions.single,
        edge_reactions: reactions.edges,
        edge_supports: reactions.edge_supports,
        edge_forces: edge_forces.into_iter().flatten().collect(),
        ring_travels,
        statistics,
        warnings,
    })
}

/// The displacement of each ring along its axis, from its place in the input.
fn ring_travels(structure: &Structure, model: &Model, vertices: &[DVec3]) -> Vec<f64> {
    let travel = |(ring, moving): (&Ring, &MovingRing)| {
        let start = structure.boundaries[ring.boundary][0];
        (vertices[model.input_vertices[ring.boundary][0] as usize] - start).dot(moving.axis)
    };
    structure.rings.iter().zip(&model.rings).map(travel).collect()
}

/// Gives the boundary's fixed vertices exactly the coordinates of the input.
fn place_supports(structure: &Structure, model: &Model, holds: &[Hold], vertices: &mut [DVec3]) {
    for (points, numbers) in structure.boundaries.iter().zip(&model.input_vertices) {
        // In reverse order, so that the first of several merged points gives the place.
        for (&point, &v) in points.iter().zip(numbers).rev() {
            if matches!(holds[v as usize], Hold::Fixed) {
                vertices[v as usize] = point;
            }
        }
    }
}

/// The figures of each layer, and the edge lengths of all layers.
fn measure_layers(
    model: &Model,
    found: &Found,
    structure: &Structure,
    at: &[DVec3],
) -> Result<(Vec<LayerResult>, Vec<f64>), Error> {
    let (mut layers, mut lengths, mut first) = (Vec::new(), Vec::new(), 0);
    for (layer, film) in model.layers.iter().zip(&structure.layers) {
        let mesh = layer.film.mesh();
        let topology = mesh.check().map_err(|defect| Error::no_result(Reason::InvalidMesh, defect.to_string()))?;
        lengths.extend(measure::edge_lengths(&mesh, &topology));
        let triangles: Vec<[u32; 3]> = layer.triangles().collect();
        let of_balance = |balance| stress(balance, film, model, first, &triangles, at);
        let stress = found.balance.as_ref().map(of_balance);
        layers.push(LayerResult { triangles: triangles.len(), area: measure::area(&mesh), stress });
        first += triangles.len();
    }
    Ok((layers, lengths))
}

/// The least slope of a triangle against the horizontal, in radians, and the centroid of the first triangle that has
/// it.
fn flattest(triangles: &[[u32; 3]], at: &[DVec3], up: DVec3) -> (f64, DVec3) {
    let (mut least, mut place) = (f64::INFINITY, DVec3::ZERO);
    for corners in triangles.iter().map(|triangle| triangle.map(|v| at[v as usize])) {
        let normal = double_area_vector(corners).normalize_or_zero();
        let slope = libm::atan2(normal.cross(up).length(), normal.dot(up).abs());
        if slope < least {
            (least, place) = (slope, corners.iter().sum::<DVec3>() / 3.0);
        }
    }
    (least, place)
}

fn cables(model: &Model, found: &Found, structure: &Structure, at: &[DVec3]) -> Vec<CableResult> {
    let one = |(k, cable): (usize, &super::options::Cable)| {
        let term = &model.cables[k].term;
        let segment_forces = match &found.balance {
            Some(balance) => balance.cable_forces[k].clone(),
            None => (0..term.segments.len()).map(|s| term.force(s, at) + found.length_forces[k]).collect(),
        };
        let length = term.length(at);
        let moment =
            |(s, force): (usize, &f64)| force * plateau_equilibrium::energy::length::length(term.segments[s], at);
        let mean = segment_forces.iter().enumerate().map(moment).sum::<f64>() / length;
        // The segments have the mean that is stated. A given force is stated as it was given.
        let force = match term.law {
            Law::Force(given) if (mean - given).abs() <= SAME_FORCE * given.abs() => given,
            _ => mean,
        };
        let largest = segment_forces.iter().copied().fold(0.0, f64::max);
        let range = term.segments.iter().zip(&segment_forces).map(|(&[a, b], force)| {
            let half = 0.5 * cable.weight * (at[b as usize] - at[a as usize]).dot(structure.up).abs();
            (force - half, force + half)
        });
        let widen = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
        CableResult {
            force_range: range.fold((f64::INFINITY, f64::NEG_INFINITY), widen),
            vertices: model.cables[k].chain.clone(),
            force,
            length,
            unstressed_length: cable.axial_stiffness.map(|stiffness| length / (1.0 + force / stiffness)),
            sag: term.sag(at),
            slack: !cable.course.is_mast() && largest <= SLACK * structure.pull() * length,
            segment_forces,
        }
    };
    structure.cables.iter().enumerate().map(one).collect()
}
