//! What a kind's request must be able to do, and the functions through which the table of kinds reaches it.

use crate::body::PointList;
use crate::json;
use crate::limits::Limits;
use crate::rejection::Rejection;
use crate::solved::{Frame, SolverInput};
use plateau_archive::units::{Unit, UpAxis};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::borrow::Cow;

/// Result of the checks of one kind of request.
#[derive(Debug)]
pub(crate) struct Checked {
    pub memory_bytes: u64,
    pub quick: bool,
    pub input: Box<dyn SolverInput>,
}

/// A request of one kind as its JSON has it.
pub(crate) trait KindRequest: DeserializeOwned + JsonSchema {
    type Statistics: JsonSchema;

    /// Returns the unit of the coordinates and the axis that points up.
    fn axes(&self) -> (Unit, UpAxis);

    /// Takes the points of a field that was read separately.
    fn take(&mut self, _list: &PointList) {}

    /// Makes the checks that the schema cannot express, and converts the request to the geometry's types.
    ///
    /// # Errors
    /// Returns every offending value.
    fn check(&self, limits: &Limits) -> Result<Checked, Rejection>;
}

/// A request that passed every check of its kind.
type Read = Result<(Frame, Checked), Rejection>;

/// The types of a kind, as functions that need no type parameter.
pub(crate) struct Types {
    pub request: TypeSchema,
    pub statistics: TypeSchema,
    /// Reads an outline that was validated against the schema, and the point lists that were read separately.
    pub read: fn(&Value, &[PointList], &Limits) -> Read,
    /// Reads the stored text of a request.
    pub read_stored: fn(&[u8], &Limits) -> Read,
}

impl Types {
    pub const fn of<R: KindRequest>() -> Self {
        Self {
            request: TypeSchema::of::<R>(),
            statistics: TypeSchema::of::<R::Statistics>(),
            read: read::<R>,
            read_stored: read_stored::<R>,
        }
    }
}

/// Access to the schema of a type.
pub(crate) struct TypeSchema {
    pub name: fn() -> Cow<'static, str>,
    /// Adds the schema to a generator's definitions and returns a reference to it.
    pub reference: fn(&mut SchemaGenerator) -> Schema,
    /// Returns the schema with all definitions.
    pub root: fn(SchemaGenerator) -> Schema,
}

impl TypeSchema {
    const fn of<T: JsonSchema>() -> Self {
        Self {
            name: T::schema_name,
            reference: SchemaGenerator::subschema_for::<T>,
            root: SchemaGenerator::into_root_schema_for::<T>,
        }
    }
}

fn read<R: KindRequest>(outline: &Value, lists: &[PointList], limits: &Limits) -> Read {
    let mut request: R = json::deserialize(outline)?;
    lists.iter().for_each(|list| request.take(list));
    checked(&request, limits)
}

fn read_stored<R: KindRequest>(body: &[u8], limits: &Limits) -> Read {
    let request: R = serde_json::from_slice(body).map_err(|error| Rejection::Malformed(error.to_string()))?;
    checked(&request, limits)
}

fn checked(request: &impl KindRequest, limits: &Limits) -> Read {
    let checked = request.check(limits)?;
    let (unit, up) = request.axes();
    Ok((Frame { unit, up }, checked))
}
