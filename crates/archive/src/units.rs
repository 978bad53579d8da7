//! Units of length and force, and the upward axis of the client. Requests, the stored archive and every download share
//! them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Unit of the client's coordinates. Meshes in glTF are in metres, as glTF demands; OBJ, PLY and STL keep the client's
/// unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "Units")]
pub enum Unit {
    #[serde(rename = "mm")]
    Millimetre,
    #[serde(rename = "cm")]
    Centimetre,
    #[default]
    #[serde(rename = "m")]
    Metre,
    #[serde(rename = "in")]
    Inch,
    #[serde(rename = "ft")]
    Foot,
}

impl Unit {
    /// Returns `mm`, `cm`, `m`, `in` or `ft`.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "in",
            Self::Foot => "ft",
        }
    }

    /// Returns the number of millimetres in one unit, exactly.
    #[must_use]
    pub fn millimetres(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Centimetre => 10.0,
            Self::Metre => 1000.0,
            Self::Inch => 25.4,
            Self::Foot => 304.8,
        }
    }

    /// Returns the number of metres in one unit, correctly rounded.
    #[must_use]
    pub fn metres(self) -> f64 {
        match self {
            Self::Millimetre => 1e-3,
            Self::Centimetre => 1e-2,
            Self::Metre => 1.0,
            Self::Inch => 0.0254,
            Self::Foot => 0.3048,
        }
    }
}

/// Unit of the client's forces. A film's tension is a force per unit of length, and a pressure a force per unit of
/// area.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum ForceUnit {
    #[serde(rename = "N")]
    Newton,
    #[default]
    #[serde(rename = "kN")]
    Kilonewton,
    #[serde(rename = "MN")]
    Meganewton,
    #[serde(rename = "lbf")]
    PoundForce,
    #[serde(rename = "kip")]
    Kip,
}

impl ForceUnit {
    /// Returns `N`, `kN`, `MN`, `lbf` or `kip`.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Newton => "N",
            Self::Kilonewton => "kN",
            Self::Meganewton => "MN",
            Self::PoundForce => "lbf",
            Self::Kip => "kip",
        }
    }
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
    /// Returns `z` or `y`.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Z => "z",
            Self::Y => "y",
        }
    }
}
