//! Requirements on points and vectors, and the errors of values that do not meet them.

use plateau_mesh::error::InputError;
use plateau_mesh::polyline;
use plateau_mesh::{DVec3, Place};

pub(super) const COORDINATE: &str = "every coordinate must be a finite number of magnitude at most 1e50";

pub(super) const UNIT_VECTOR: &str = "must be a vector with a length";

pub(super) fn is_usable(point: DVec3) -> bool {
    point.is_finite() && point.abs().max_element() <= polyline::LARGEST_COORDINATE
}

pub(super) fn require(errors: &mut Vec<InputError>, holds: bool, place: Place, detail: &str) {
    if !holds {
        errors.push(InputError::new(place, detail));
    }
}
