//! A kind of request as an entry of the table of kinds, [`Kind::ALL`](crate::kinds).

use crate::blocks::{Block, Output};
use crate::checked::Types;
use crate::options::{ObjectiveOption, of_objective};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

/// Kind of a request. Kinds with equal names are equal.
#[derive(Clone, Copy)]
pub struct Kind(&'static Entry);

/// The description of a kind that the hosts use.
pub(crate) struct Entry {
    /// Name in snake case, as requests have it in their field `kind`.
    pub name: &'static str,
    /// Path that accepts requests of this kind.
    pub path: &'static str,
    /// The aim of requests of this kind, as a phrase with a verb.
    pub summary: &'static str,
    /// The result of this kind, as part of the list with which the service introduces itself to a language model.
    pub finds: &'static str,
    pub units: Units,
    /// The blocks that make requests of this kind in a visual program. Jobs are named after the first.
    pub blocks: &'static [Block],
    /// Outputs of each of the blocks.
    pub outputs: &'static [Output],
    pub objectives: fn() -> Vec<Objective>,
    pub types: Types,
}

/// Form of the field `units` of a kind's requests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// The name of a unit of length.
    Length,
    /// An object with `length` and `force`.
    LengthAndForce,
    /// The request has no field `units`, because the result from which it begins has its own units.
    OfSource,
}

/// One objective of one kind of request.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Objective {
    pub name: &'static str,
    pub kind: Kind,
    /// Quantity that is minimised or maximised, as a formula in words and symbols.
    pub minimises: &'static str,
    /// Unit of the objective's value, where `u` is the client's unit.
    pub unit: &'static str,
    /// Author, section and equation.
    pub source: &'static str,
    /// Members of the request that can change the result with this objective, each with the choices that it needs. A
    /// request with a member that does not act is refused.
    pub options: Vec<ObjectiveOption>,
}

impl Kind {
    pub(crate) const fn of(entry: &'static Entry) -> Self {
        Self(entry)
    }

    #[must_use]
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// Returns the name in Pascal case, with which the names of components and operations of the API document begin.
    #[must_use]
    pub fn pascal_name(self) -> String {
        let words = self.0.name.split('_');
        words.map(|word| word[..1].to_ascii_uppercase() + &word[1..]).collect()
    }

    /// Returns what requests of this kind ask for, as a phrase with a verb.
    #[must_use]
    pub fn summary(self) -> &'static str {
        self.0.summary
    }

    /// Returns the result of this kind, as an item of the list with which the service introduces itself to a language
    /// model.
    #[must_use]
    pub fn finds(self) -> &'static str {
        self.0.finds
    }

    /// Returns the path that accepts requests of this kind.
    #[must_use]
    pub fn path(self) -> &'static str {
        self.0.path
    }

    /// Returns whether requests of this kind begin with the result of a finished job.
    #[must_use]
    pub fn has_source(self) -> bool {
        self.0.types.has_source
    }

    #[must_use]
    pub fn units(self) -> Units {
        self.0.units
    }

    /// Returns the blocks that make requests of this kind in a visual program. Jobs are named after the first.
    #[must_use]
    pub fn blocks(self) -> &'static [Block] {
        self.0.blocks
    }

    /// Returns the outputs of the blocks.
    #[must_use]
    pub fn outputs(self) -> &'static [Output] {
        self.0.outputs
    }

    #[must_use]
    pub fn objectives(self) -> Vec<Objective> {
        let mut objectives = (self.0.objectives)();
        for objective in &mut objectives {
            objective.options = of_objective(self.0.types.options, objective.name);
        }
        objectives
    }

    pub(crate) fn types(self) -> &'static Types {
        &self.0.types
    }
}

impl fmt::Debug for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Kind").field(&self.name()).finish()
    }
}

impl PartialEq for Kind {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for Kind {}

impl PartialOrd for Kind {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Kind {
    fn cmp(&self, other: &Self) -> Ordering {
        self.name().cmp(other.name())
    }
}

impl Hash for Kind {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name().hash(state);
    }
}

impl Serialize for Kind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
