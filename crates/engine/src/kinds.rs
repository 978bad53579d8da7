//! The table of the kinds of requests. Each kind is a folder with its types, its checks, its call of the solver and its
//! texts, and one line in the table here. The service and the command line offer every kind of the table.

use crate::kind::{Kind, Objective};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;

/// Declares the module of each kind, a folder beside this file, and lists the kinds. Each kind is compiled only with
/// its feature.
macro_rules! kinds {
    ($($module:ident if $feature:literal,)*) => {
        $(#[cfg(feature = $feature)] pub mod $module;)*

        impl Kind {
            /// Every kind, in the order of the API document.
            pub const ALL: &[Self] = &[$(#[cfg(feature = $feature)] $module::KIND),*];
        }
    };
}

// The order is that of the API document. `cargo fmt` does not find the files of these modules, because a macro declares
// them, so scripts/test formats them by name.
kinds! {
    ruled_surface if "ruled-surface",
    minimal_surface if "minimal-surface",
    uniform_mesh if "uniform-mesh",
    tensile_structure if "tensile-structure",
    cable_net if "cable-net",
    enlargement if "test-hooks",
}

impl Kind {
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
