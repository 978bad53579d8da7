//! The table of the kinds of requests. Each kind is a folder with its types, its checks, its way to the solver and its
//! words, and two lines here: its module and its place in the table. The service and the command line offer every kind
//! of the table.

#[cfg(feature = "cable-net")]
pub mod cable_net;
#[cfg(feature = "test-hooks")]
pub mod enlargement;
#[cfg(feature = "minimal-surface")]
pub mod minimal_surface;
#[cfg(feature = "ruled-surface")]
pub mod ruled_surface;
#[cfg(feature = "tensile-structure")]
pub mod tensile_structure;
#[cfg(feature = "uniform-mesh")]
pub mod uniform_mesh;

use crate::kind::{Kind, Objective};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;

impl Kind {
    /// Every kind, in the order of the API document.
    pub const ALL: &[Self] = &[
        #[cfg(feature = "ruled-surface")]
        ruled_surface::KIND,
        #[cfg(feature = "minimal-surface")]
        minimal_surface::KIND,
        #[cfg(feature = "uniform-mesh")]
        uniform_mesh::KIND,
        #[cfg(feature = "tensile-structure")]
        tensile_structure::KIND,
        #[cfg(feature = "cable-net")]
        cable_net::KIND,
        #[cfg(feature = "test-hooks")]
        enlargement::KIND,
    ];

    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|kind| kind.name() == name)
    }
}

/// Returns the objectives of every kind.
#[must_use]
pub fn objectives() -> Vec<Objective> {
    Kind::ALL.iter().flat_map(|kind| kind.objectives()).collect()
}

impl<'de> Deserialize<'de> for Kind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = Cow::<str>::deserialize(deserializer)?;
        Self::from_name(&name).ok_or_else(|| D::Error::custom("must be the name of a kind"))
    }
}

impl JsonSchema for Kind {
    fn schema_name() -> Cow<'static, str> {
        "Kind".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let names: Vec<&str> = Self::ALL.iter().map(|kind| kind.name()).collect();
        json_schema!({ "description": "Kind of a request.", "type": "string", "enum": names })
    }
}
