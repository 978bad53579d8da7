//! What requests of every kind share: points, units, the up axis.

use super::{FieldError, Rejection};
use plateau_geometry::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A point `[x, y, z]` in the client's own axes and unit.
pub type Point = [f64; 3];

/// The unit of the client's coordinates. Meshes in glTF are in metres, as glTF demands; OBJ, PLY and STL keep the
/// client's unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Units {
    Mm,
    Cm,
    #[default]
    M,
    In,
    Ft,
}

impl Units {
    /// Metres in one unit.
    #[must_use]
    pub fn in_metres(self) -> f64 {
        match self {
            Self::Mm => 0.001,
            Self::Cm => 0.01,
            Self::M => 1.0,
            Self::In => 0.0254,
            Self::Ft => 0.3048,
        }
    }

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Mm => "mm",
            Self::Cm => "cm",
            Self::M => "m",
            Self::In => "in",
            Self::Ft => "ft",
        }
    }
}

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

/// Axis of the client's coordinates that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum UpAxis {
    #[default]
    Z,
    Y,
}

impl UpAxis {
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Z => "z",
            Self::Y => "y",
        }
    }
}

/// Points of the wire as points of the geometry.
#[must_use]
pub fn points(polyline: &[Point]) -> Vec<DVec3> {
    polyline.iter().map(|&point| DVec3::from_array(point)).collect()
}

#[must_use]
pub fn polylines(polylines: &[Vec<Point>]) -> Vec<Vec<DVec3>> {
    polylines.iter().map(|polyline| points(polyline)).collect()
}

/// Refuses more than `max_points` points in all.
///
/// # Errors
/// [`Rejection::TooLarge`] at the field.
pub fn check_point_count(field: &str, polylines: &[Vec<Point>], max_points: usize) -> Result<(), Rejection> {
    let count: usize = polylines.iter().map(Vec::len).sum();
    if count > max_points {
        let detail = format!("has more points than this server takes ({max_points}); see GET /v1/limits");
        return Err(Rejection::TooLarge(vec![FieldError::new(field, detail)]));
    }
    Ok(())
}
