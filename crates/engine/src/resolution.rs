//! Resolution of the mesh of a film.

use crate::limits::{self, Limits};
use plateau_minimal_surface as geometry;
use plateau_strict_json::bounds::{MoreThan0, OneOf, Whole, given};
use plateau_strict_json::rejection::Rejection;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Resolution of the mesh, given by exactly one of the three fields.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
pub struct Resolution {
    /// Number of triangles. It is exact for `rings` with `keep`, and otherwise met within 10%.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Whole<1, 1_000_000_000>")]
    pub triangles: Option<Whole<1, 1_000_000_000>>,
    /// Mean edge length in the request's unit.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "MoreThan0")]
    pub edge_length: Option<MoreThan0>,
    /// Number of vertices that are not on the boundary.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Whole<1, 1_000_000_000>")]
    pub interior_vertices: Option<Whole<1, 1_000_000_000>>,
}

/// Number of triangles if the request has no resolution.
const DEFAULT_TRIANGLES: usize = 2000;
/// Smallest number of triangles for each boundary point if the request has no resolution. With fewer, the triangles
/// would grow too fast from a boundary of many points to the middle.
const DEFAULT_TRIANGLES_PER_POINT: usize = 4;

impl OneOf for Resolution {
    fn given(&self) -> usize {
        let given = [self.triangles.is_some(), self.edge_length.is_some(), self.interior_vertices.is_some()];
        given.into_iter().filter(|given| *given).count()
    }
}

impl Resolution {
    /// Refuses numbers above the limits.
    ///
    /// # Errors
    /// Returns [`Rejection::TooLarge`] at the number.
    pub fn check(&self, limits: &Limits) -> Result<(), Rejection> {
        let [triangles, vertices] = [self.triangles, self.interior_vertices].map(|number| number.map(Whole::get));
        limits::check_number("/resolution/triangles", triangles, limits.triangles)?;
        limits::check_number("/resolution/interior_vertices", vertices, limits.triangles / 2)
    }

    /// Converts a resolution to the geometry's type, or returns the default for boundaries with this number of points.
    #[must_use]
    pub fn or_default(resolution: Option<Self>, boundary_points: usize) -> geometry::Resolution {
        match resolution {
            Some(Self { triangles: Some(count), .. }) => geometry::Resolution::Triangles(count.get() as usize),
            Some(Self { edge_length: Some(length), .. }) => geometry::Resolution::EdgeLength(length.get()),
            Some(Self { interior_vertices: Some(count), .. }) => {
                geometry::Resolution::InteriorVertices(count.get() as usize)
            }
            _ => {
                let graded = DEFAULT_TRIANGLES_PER_POINT * boundary_points;
                geometry::Resolution::Triangles(graded.max(DEFAULT_TRIANGLES))
            }
        }
    }
}
