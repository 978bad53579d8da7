//! Types that requests of every kind share: points and the use of kept results.

use super::{FieldError, Rejection};
use plateau_geometry::DVec3;
use schemars::JsonSchema;
use serde::Deserialize;

/// A point `[x, y, z]` in the client's axes and unit.
pub type Point = [f64; 3];

/// Whether the result of an equal earlier request may be returned. Results are deterministic, so it has the same bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Cache {
    /// Return a stored result if there is one, and store this one for later requests.
    #[default]
    Reuse,
    /// Solve again, and do not store the result for later requests.
    Bypass,
}

/// Converts points of the wire to points of the geometry.
#[must_use]
pub fn points(polyline: &[Point]) -> Vec<DVec3> {
    polyline.iter().map(|&point| DVec3::from_array(point)).collect()
}

#[must_use]
pub fn polylines(polylines: &[Vec<Point>]) -> Vec<Vec<DVec3>> {
    polylines.iter().map(|polyline| points(polyline)).collect()
}

/// Refuses polylines that together have more than `max_points` points.
///
/// # Errors
/// Returns [`Rejection::TooLarge`] at the field.
pub fn check_point_count(field: &str, polylines: &[Vec<Point>], max_points: usize) -> Result<(), Rejection> {
    let count: usize = polylines.iter().map(Vec::len).sum();
    if count > max_points {
        let detail = format!("has more points than this server accepts ({max_points}); see GET /v1/limits");
        return Err(Rejection::TooLarge(vec![FieldError::new(field, detail)]));
    }
    Ok(())
}
