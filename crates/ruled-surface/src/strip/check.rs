//! Checks of the directrices of a strip and of its options.

use super::objective::{Goal, Objective, Secondary};
use crate::graph::rails::Given;
use plateau_mesh::DVec3;
use plateau_mesh::error::{InputError, Place};
use plateau_mesh::polyline::LARGEST_COORDINATE;

/// Largest number of errors that are listed. Further errors are left out.
pub(crate) const MOST_ERRORS: usize = 51;
/// Largest convexity tolerance, in radians. With a larger tolerance no bridge would be concave.
const LARGEST_TOLERANCE: f64 = std::f64::consts::FRAC_PI_4;

pub(crate) const TOO_FEW_CLOSED: &str = "a closed directrix needs three distinct points, or one (an apex)";

/// Returns the errors of an objective and of the options that go with it.
pub(crate) fn goal_errors(
    objective: Objective,
    secondary: Option<Secondary>,
    convexity_tolerance: f64,
    has_normals: bool,
) -> Vec<InputError> {
    let mut errors = Vec::new();
    let mut refuse = |place: Place, detail: &str| errors.push(InputError::new(place, detail));
    if !(0.0..=LARGEST_TOLERANCE).contains(&convexity_tolerance) {
        refuse(Place::field("convexity_tolerance"), "must lie between 0 and 45 degrees");
    }
    if secondary.is_some() && objective != Objective::MaximalConvexity {
        refuse(Place::field("secondary_objective"), "goes with the objective maximal_convexity only");
    }
    let weights = match objective {
        Objective::Weighted(weights) => weights.terms().to_vec(),
        _ => Vec::new(),
    };
    for (objective, weight) in &weights {
        if !(weight.is_finite() && *weight >= 0.0) {
            let name = objective.name();
            refuse(Place::field("objective").then("weights").then(name), "must be finite and not negative");
        }
    }
    if !weights.is_empty() && weights.iter().all(|&(_, weight)| weight == 0.0) {
        refuse(Place::field("objective").then("weights"), "at least one weight must be positive");
    }
    if (Goal { objective, secondary }).needs_normals() && !has_normals {
        refuse(Place::field("normals"), "minimal_normal_variation needs surface normals along the directrices");
    }
    errors
}

pub(crate) fn value_errors(name: &'static str, lists: &[&[DVec3]]) -> Vec<InputError> {
    let mut errors = Vec::new();
    for (k, list) in lists.iter().enumerate() {
        if list.is_empty() {
            errors.push(InputError::new(Place::field(name).at(k), "must not be empty"));
        }
        for (index, point) in list.iter().enumerate() {
            for axis in 0..3 {
                let (finite, small) = (point[axis].is_finite(), point[axis].abs() <= LARGEST_COORDINATE);
                if !(finite && small) && errors.len() < MOST_ERRORS {
                    let detail = if finite { "must not exceed 1e50" } else { "must be finite" };
                    errors.push(InputError::new(Place::field(name).at(k).at(index).at(axis), detail));
                }
            }
        }
    }
    errors
}

pub(crate) fn shape_errors(name: &'static str, values: &[&[DVec3]], directrices: &[&[DVec3]]) -> Vec<InputError> {
    if values.len() != directrices.len() {
        return vec![InputError::new(Place::field(name), "must have as many lists as there are directrices")];
    }
    let pairs = values.iter().zip(directrices).enumerate();
    pairs
        .filter(|(_, (values, points))| values.len() != points.len())
        .map(|(k, _)| {
            InputError::new(Place::field(name).at(k), "must have as many vectors as the directrix has points")
        })
        .collect()
}

/// Returns the errors of the two directrices of a single strip.
pub(crate) fn strip_errors(sides: [Given<'_>; 2], closed: bool) -> Vec<InputError> {
    let points = sides.map(|side| side.points);
    let mut errors = value_errors("directrices", &points);
    for (name, values) in [("normals", sides.map(|s| s.normals)), ("tangents", sides.map(|s| s.tangents))] {
        match values {
            [None, None] => {}
            [Some(p), Some(q)] => {
                errors.extend(shape_errors(name, &[p, q], &points));
                errors.extend(value_errors(name, &[p, q]));
            }
            _ => errors.push(InputError::new(Place::field(name), "must be given for both directrices or for neither")),
        }
    }
    if points.iter().all(|side| side.len() == 1) {
        errors.push(InputError::new(Place::field("directrices").at(1), "two single points span nothing"));
    }
    for (k, side) in points.iter().enumerate() {
        if closed && side.len() == 2 {
            errors.push(InputError::new(Place::field("directrices").at(k), TOO_FEW_CLOSED));
        }
    }
    errors
}
