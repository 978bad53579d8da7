//! Points of requests.

use plateau_mesh::DVec3;

/// A point `[x, y, z]` in the client's axes and unit.
pub type Point = [f64; 3];

/// Converts points of the wire to points of the geometry.
#[must_use]
pub fn points(polyline: &[Point]) -> Vec<DVec3> {
    polyline.iter().map(|&point| DVec3::from_array(point)).collect()
}

#[must_use]
pub fn polylines(polylines: &[Vec<Point>]) -> Vec<Vec<DVec3>> {
    polylines.iter().map(|polyline| points(polyline)).collect()
}
