//! Resolution of the mesh of a film.

use crate::limits::{self, Limits};
use crate::rejection::Rejection;
use plateau_film::minimal_surface as geometry;
use schemars::JsonSchema;
use serde::Deserialize;

/// Resolution of the mesh, given by exactly one of the three fields.
// None of them stands for a request without a resolution; the schema refuses an empty object.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
pub struct Resolution {
    /// Number of triangles. It is exact for `rings` with `keep`, and otherwise met within 10%.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 1_000_000_000))]
    pub triangles: Option<u32>,
    /// Mean edge length in the request's unit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64", extend("exclusiveMinimum" = 0))]
    pub edge_length: Option<f64>,
    /// Number of vertices that are not on the boundary.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 1_000_000_000))]
    pub interior_vertices: Option<u32>,
}

/// Number of triangles if the request has no resolution.
const DEFAULT_TRIANGLES: usize = 2000;
/// Smallest number of triangles for each boundary point if the request has no resolution. A larger value grades the
/// triangles more gently from a boundary of many points to the middle.
const DEFAULT_TRIANGLES_PER_POINT: usize = 4;

impl Resolution {
    /// Refuses numbers above the limits.
    ///
    /// # Errors
    /// Returns [`Rejection::TooLarge`] at the number.
    pub fn check(&self, limits: &Limits) -> Result<(), Rejection> {
        limits::check_number("/resolution/triangles", self.triangles, limits.triangles)?;
        limits::check_number("/resolution/interior_vertices", self.interior_vertices, limits.triangles / 2)
    }

    /// Converts the resolution to the geometry's type, for boundaries with so many points.
    #[must_use]
    pub fn to_geometry(self, boundary_points: usize) -> geometry::Resolution {
        match self {
            Self { triangles: Some(count), .. } => geometry::Resolution::Triangles(count as usize),
            Self { edge_length: Some(length), .. } => geometry::Resolution::EdgeLength(length),
            Self { interior_vertices: Some(count), .. } => geometry::Resolution::InteriorVertices(count as usize),
            Self { .. } => {
                let graded = DEFAULT_TRIANGLES_PER_POINT * boundary_points;
                geometry::Resolution::Triangles(graded.max(DEFAULT_TRIANGLES))
            }
        }
    }
}
