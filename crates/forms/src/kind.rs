//! Names of the kinds of requests, and what can be said of them without their types.

/// Kind of a request.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    RuledSurface,
    MinimalSurface,
    UniformMesh,
    TensileStructure,
    CableNet,
}

impl Kind {
    pub const ALL: [Self; 5] =
        [Self::RuledSurface, Self::MinimalSurface, Self::UniformMesh, Self::TensileStructure, Self::CableNet];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::RuledSurface => "ruled_surface",
            Self::MinimalSurface => "minimal_surface",
            Self::UniformMesh => "uniform_mesh",
            Self::TensileStructure => "tensile_structure",
            Self::CableNet => "cable_net",
        }
    }

    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Returns the names of the request fields that are lists of polylines.
    #[must_use]
    pub fn point_fields(self) -> &'static [&'static str] {
        match self {
            Self::RuledSurface => &["directrices", "normals", "tangents"],
            Self::MinimalSurface | Self::TensileStructure => &["boundaries"],
            Self::UniformMesh | Self::CableNet => &[],
        }
    }

    /// Returns what requests of this kind ask for, as a phrase with a verb.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::RuledSurface => "Finds the globally optimal ruled strip between directrices for an objective",
            Self::MinimalSurface => "Finds the minimal surface that spans boundary polylines",
            Self::UniformMesh => "Finds a mesh of a polygon, patch or film with as many equal edges as possible",
            Self::TensileStructure => "Finds the shape in equilibrium of a film with cables, pressure and weight",
            Self::CableNet => {
                "Finds the shape in equilibrium of a cable net that comes nearest to target forces and lengths"
            }
        }
    }

    /// Returns the path that accepts requests of this kind.
    #[must_use]
    pub fn path(self) -> &'static str {
        match self {
            Self::RuledSurface => "/v1/ruled-surfaces",
            Self::MinimalSurface => "/v1/minimal-surfaces",
            Self::UniformMesh => "/v1/uniform-meshes",
            Self::TensileStructure => "/v1/tensile-structures",
            Self::CableNet => "/v1/cable-nets",
        }
    }
}
