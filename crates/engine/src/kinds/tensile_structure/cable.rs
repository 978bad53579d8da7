//! Cables and masts of a tensile structure, as a request has them.

use crate::common::{self, Point};
use plateau_mesh::DVec3;
use plateau_strict_json::bounds::{List, NonNegative, Positive, Text, given, is_default};
use plateau_tensile_structure as geometry;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A cable. Its course is exactly one of `along`, `across` and `points`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cable {
    /// Name in statistics and warnings. Null means its number, as in `cable 0`.
    #[serde(default)]
    pub name: Option<Text<1, 100>>,
    /// Part of a boundary along which the cable runs. The film's edge hangs on the cable.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Along")]
    pub along: Option<Along>,
    /// Points through which the cable runs across the film before form finding, as a ridge or a valley. The first and
    /// the last are points of the boundaries or lie on their segments. Cables across the film may share points but must
    /// not cross. Points within `join_tolerance` of others take their place.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "List<Point, 2>")]
    pub across: Option<List<Point, 2>>,
    /// Two points between which the cable runs in the air. A point within `join_tolerance` of a boundary's point, one
    /// of `joints` or the hub of a ring is joined to it; any other point is a support.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "[Point; 2]")]
    pub points: Option<[Point; 2]>,
    #[serde(default, skip_serializing_if = "is_default")]
    pub mode: Mode,
    /// Value that the mode holds constant: a force, a force per length (`force_density`) or a length.
    pub value: Positive,
    /// EA, a force. `unstressed_length` needs it; with other modes it gives the unstressed length.
    #[serde(default)]
    pub axial_stiffness: Option<Positive>,
    /// Weight per length of the found shape.
    #[serde(default)]
    pub weight: NonNegative,
}

/// A part of a boundary, in the boundary's direction. Points are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Along {
    #[serde(default)]
    #[schemars(range(max = 4_294_967_295u32))]
    pub boundary: u32,
    /// Number of the point at which the cable begins.
    #[schemars(range(max = 4_294_967_295u32))]
    pub from: u32,
    /// Number of the point at which it ends.
    #[schemars(range(max = 4_294_967_295u32))]
    pub to: u32,
}

/// Quantity of a cable that is held constant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "CableMode")]
pub enum Mode {
    /// The force. With a weight, the mean force.
    #[default]
    Force,
    /// The force at the first end.
    EndTension,
    /// The part of the force at the first end that is across the up axis.
    HorizontalComponent,
    /// The force divided by the length of the whole cable.
    ForceDensity,
    /// The length in the found shape.
    Length,
    /// The length without force. The force is EA (length / unstressed length - 1), and 0 if that is negative.
    UnstressedLength,
    /// The largest distance from the chord between the ends.
    Sag,
}

impl Cable {
    pub(super) fn to_geometry(&self, number: usize) -> geometry::Cable {
        let name = self.name.as_deref().map_or_else(|| format!("{number}"), str::to_owned);
        let course = match (&self.along, &self.across, &self.points) {
            (_, Some(points), _) => geometry::Course::Across(common::points(points)),
            (Some(Along { boundary, from, to }), ..) => {
                geometry::Course::Boundary { boundary: *boundary as usize, from: *from as usize, to: *to as usize }
            }
            (None, None, points) => geometry::Course::Air(points.unwrap_or_default().map(DVec3::from_array)),
        };
        let mode = match self.mode {
            Mode::Force => geometry::CableMode::Force,
            Mode::EndTension => geometry::CableMode::EndTension,
            Mode::HorizontalComponent => geometry::CableMode::HorizontalComponent,
            Mode::ForceDensity => geometry::CableMode::ForceDensity,
            Mode::Length => geometry::CableMode::Length,
            Mode::UnstressedLength => geometry::CableMode::UnstressedLength,
            Mode::Sag => geometry::CableMode::Sag,
        };
        let (axial_stiffness, weight) = (self.axial_stiffness.map(Positive::get), self.weight.get());
        geometry::Cable { name, course, mode: mode(self.value.get()), axial_stiffness, weight }
    }
}

/// A straight member between two points that may push. A point within `join_tolerance` of a boundary's point, one of
/// `joints` or the hub of a ring is joined to it; any other point is a support. At least one end is no support.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mast {
    /// Name in statistics and warnings. Null means its number, as in `mast 0`.
    #[serde(default)]
    pub name: Option<Text<1, 100>>,
    pub points: [Point; 2],
    #[serde(default, skip_serializing_if = "is_default")]
    pub mode: MastMode,
    /// Value that the mode holds constant: a length, or the force with which the mast pushes.
    pub value: Positive,
}

/// Quantity of a mast that is held constant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MastMode {
    /// The length. The force is found, and negative if the mast has to pull.
    #[default]
    Length,
    /// The force with which the mast pushes. The length is found.
    Force,
}

impl Mast {
    pub(super) fn to_geometry(&self, number: usize) -> geometry::Cable {
        geometry::Cable {
            name: self.name.as_deref().map_or_else(|| format!("mast {number}"), str::to_owned),
            course: geometry::Course::Mast(self.points.map(DVec3::from_array)),
            mode: match self.mode {
                MastMode::Length => geometry::CableMode::Length(self.value.get()),
                MastMode::Force => geometry::CableMode::Force(self.value.get()),
            },
            axial_stiffness: None,
            weight: 0.0,
        }
    }
}
