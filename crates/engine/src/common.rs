//! Types that the requests and statistics of several kinds share.

use plateau_archive::units::{ForceUnit, Unit};
use plateau_mesh::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Deref;

/// A point `[x, y, z]` in the client's axes and unit.
pub type Point = [f64; 3];

/// Converts the points of a JSON request to the geometry's vectors.
#[must_use]
pub fn points(polyline: &[Point]) -> Vec<DVec3> {
    polyline.iter().map(|&point| DVec3::from_array(point)).collect()
}

#[must_use]
pub fn polylines(polylines: &[impl Deref<Target = [Point]>]) -> Vec<Vec<DVec3>> {
    polylines.iter().map(|polyline| points(polyline)).collect()
}

/// Returns the number of points of all polylines together.
#[must_use]
pub fn count(polylines: &[impl Deref<Target = [Point]>]) -> usize {
    polylines.iter().map(|polyline| polyline.len()).sum()
}

#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct AngleRange {
    pub min: f64,
    pub max: f64,
}

impl AngleRange {
    /// Converts a range of angles from radians to degrees.
    #[must_use]
    pub fn of_radians((min, max): (f64, f64)) -> Self {
        Self { min: min.to_degrees(), max: max.to_degrees() }
    }
}

/// Units of lengths and forces. A tension is a force per length, a weight of a film and a pressure a force per area, a
/// weight of a cable a force per length, and an axial stiffness a force.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Self::default())]
pub struct LengthAndForce {
    #[serde(default)]
    pub length: Unit,
    #[serde(default)]
    pub force: ForceUnit,
}

impl From<LengthAndForce> for Unit {
    fn from(units: LengthAndForce) -> Self {
        units.length
    }
}

/// Sums of the forces.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ForceBalance {
    /// Sum of all loads: weights and pressure.
    pub loads: Point,
    /// Sum of all reactions.
    pub reactions: Point,
    /// Sum of the reactions' magnitudes, vertex by vertex.
    pub magnitudes: f64,
    /// |loads + reactions| / magnitudes.
    pub imbalance: f64,
    /// Largest force on a vertex that is not balanced.
    pub residual_force: f64,
}
