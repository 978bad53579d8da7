//! The film of a tensile structure and the chambers below its layers, as a request has them.

use crate::common::{self, Point};
use plateau_mesh::DVec3;
use plateau_strict_json::bounds::{List, NonNegative, OneOf, Positive, Signed, given, given_one};
use plateau_strict_json::rejection::FieldError;
use plateau_tensile_structure::{self as geometry, WeaveHold};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Largest number of points of the polyline that gives the warp's direction. The limit bounds the work, because every
/// triangle searches the polyline for its nearest point in every round.
const MAX_DIRECTION_POINTS: usize = 200;

/// The film's prestress and weight. The prestress is either `tension`, or `warp` and `weft` with a `direction`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "TensileFilm")]
pub struct Film {
    /// Isotropic tension, a force per length.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Positive")]
    pub tension: Option<Positive>,
    /// Stress along the warp, a force per length.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Positive")]
    pub warp: Option<Positive>,
    /// Stress along the weft, at right angles to the warp, a force per length.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Positive")]
    pub weft: Option<Positive>,
    #[serde(default, deserialize_with = "given_one", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "WarpDirection")]
    pub direction: Option<WarpDirection>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "WeaveHold")]
    pub hold: Option<WeaveHold>,
    /// Weight per area of the found shape. An isotropic tension is `tension` at the film's mean height and grows with
    /// the height by the weight.
    #[serde(default)]
    pub weight: NonNegative,
}

/// A closed space below a layer: up to the next layer, or, below the last layer, up to fans from each boundary to its
/// mean, which stand for the ground. It has exactly one of `pressure` and `volume`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Chamber {
    /// Number of the layer, counted from 0.
    #[serde(default)]
    #[schemars(range(max = 4_294_967_295u32))]
    pub below: u32,
    /// Pressure above that outside, a force per area.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Signed")]
    pub pressure: Option<Signed>,
    /// Volume. The pressure is found.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Positive")]
    pub volume: Option<Positive>,
}

/// Field of directions in space, given by exactly one of its fields. The film's warp is the projection of the field
/// onto the film. Directions need no unit length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
pub struct WarpDirection {
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "RadialDirection")]
    pub radial: Option<RadialDirection>,
    /// Vector along which the warp runs.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Point")]
    pub parallel: Option<Point>,
    /// Polyline along whose tangent at the nearest point the warp runs.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "List<Point, 2, MAX_DIRECTION_POINTS>")]
    pub along: Option<List<Point, 2, MAX_DIRECTION_POINTS>>,
}

impl OneOf for WarpDirection {
    fn given(&self) -> usize {
        let given = [self.radial.is_some(), self.parallel.is_some(), self.along.is_some()];
        given.into_iter().filter(|given| *given).count()
    }
}

/// The weft runs around an axis and the warp away from it. The axis must not pass through the film.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RadialDirection {
    /// A point of the axis.
    pub point: Point,
    pub axis: Point,
}

impl Film {
    /// Converts the film to the geometry's type.
    pub(super) fn to_geometry(&self, pointer: &str) -> Result<geometry::FilmStress, Vec<FieldError>> {
        Ok(geometry::FilmStress { prestress: self.prestress(pointer)?, weight: self.weight.get() })
    }

    /// Converts the prestress to the geometry's type, or returns an error for each member that is missing or not
    /// allowed. `pointer` is the JSON Pointer of the film.
    fn prestress(&self, pointer: &str) -> Result<geometry::FilmPrestress, Vec<FieldError>> {
        let (warp, weft, direction) = match (self.tension, self.warp, self.weft, &self.direction, self.hold) {
            (Some(tension), None, None, None, None) => return Ok(geometry::FilmPrestress::Isotropic(tension.get())),
            (None, None, None, None, None) => {
                let detail = "is required, or warp, weft and direction in its place";
                return Err(vec![FieldError::new(format!("{pointer}/tension"), detail)]);
            }
            (Some(_), ..) => {
                let detail = "is not allowed with warp, weft, direction or hold";
                return Err(vec![FieldError::new(format!("{pointer}/tension"), detail)]);
            }
            (None, Some(warp), Some(weft), Some(direction), _) => (warp, weft, direction),
            (None, warp, weft, direction, _) => {
                let given = [("warp", warp.is_some()), ("weft", weft.is_some()), ("direction", direction.is_some())];
                let detail = "is required: a prestress by warp and weft needs both and a direction";
                let missing = given.into_iter().filter(|(_, given)| !given);
                return Err(missing.map(|(name, _)| FieldError::new(format!("{pointer}/{name}"), detail)).collect());
            }
        };
        let unit = |vector: Point, field: &str| {
            let error = || FieldError::new(format!("{pointer}/direction/{field}"), "must be a vector with a length");
            DVec3::from_array(vector).try_normalize().ok_or_else(|| vec![error()])
        };
        let direction = match direction {
            WarpDirection { radial: Some(RadialDirection { point, axis }), .. } => {
                geometry::WarpDirection::Radial { point: DVec3::from_array(*point), axis: unit(*axis, "radial/axis")? }
            }
            WarpDirection { parallel: Some(vector), .. } => {
                geometry::WarpDirection::Parallel(unit(*vector, "parallel")?)
            }
            WarpDirection { along, .. } => {
                geometry::WarpDirection::Along(common::points(along.as_deref().unwrap_or_default()))
            }
        };
        let hold = self.hold.unwrap_or_default();
        Ok(geometry::FilmPrestress::Woven(geometry::Weave { warp: warp.get(), weft: weft.get(), direction, hold }))
    }
}
