//! What a kind's request must be able to do, and the functions through which the table of kinds reaches it.

use crate::limits::Limits;
use crate::rejection::Rejection;
use crate::solved::{Frame, SolverInput};
use crate::strict::{self, Strict};
use plateau_archive::units::{Unit, UpAxis};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};
use std::borrow::Cow;

/// Result of the checks of one kind of request.
#[derive(Debug)]
pub(crate) struct Checked {
    pub memory_bytes: u64,
    pub quick: bool,
    pub input: Box<dyn SolverInput>,
}

/// A request of one kind as its JSON has it.
pub(crate) trait KindRequest: DeserializeOwned + Serialize + JsonSchema {
    type Statistics: JsonSchema;

    /// Returns the unit of the coordinates and the axis that points up.
    fn axes(&self) -> (Unit, UpAxis);

    /// Makes the checks that the types do not make on reading, and converts the request to the geometry's types.
    ///
    /// # Errors
    /// Returns every offending value.
    fn check(&self, limits: &Limits) -> Result<Checked, Rejection>;
}

/// A request that passed every check of its kind.
pub(crate) type Passed = (Frame, Checked);
/// A request that was read, and how its type writes it.
pub(crate) type Read = (Passed, Vec<u8>);
/// A request that was read, and the members that were kept apart from it.
pub(crate) type ReadApart = (Read, Map<String, Value>);

/// The types of a kind, as functions that need no type parameter.
pub(crate) struct Types {
    pub request: TypeSchema,
    pub statistics: TypeSchema,
    /// Reads the JSON of a request, and the members in the list apart from it. Returns `None` for a body that is refused.
    pub read: fn(&[u8], &[&str], &Limits) -> Option<ReadApart>,
    /// Reads a request from a JSON value. An error without a rejection means that the type refuses the value.
    pub read_value: fn(&Value, &Limits) -> Result<Read, Option<Rejection>>,
    /// Returns the place at which the type refuses a value, for a value that its schema accepts.
    pub refusal: fn(&Value) -> Rejection,
    /// Reads a request as its type has written it.
    pub read_stored: fn(&[u8], &Limits) -> Result<Passed, Rejection>,
}

impl Types {
    pub const fn of<R: KindRequest>() -> Self {
        Self {
            request: TypeSchema::of::<R>(),
            statistics: TypeSchema::of::<R::Statistics>(),
            read: read::<R>,
            read_value: read_value::<R>,
            refusal: strict::refusal::<R>,
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

fn read<R: KindRequest>(body: &[u8], aside: &[&str], limits: &Limits) -> Option<ReadApart> {
    let (request, aside) = strict::read::<R>(body, aside).ok()?;
    Some((written(&request, limits).ok()?, aside))
}

fn read_value<R: KindRequest>(value: &Value, limits: &Limits) -> Result<Read, Option<Rejection>> {
    let request = R::deserialize(Strict(value)).map_err(|_| None)?;
    written(&request, limits).map_err(Some)
}

fn read_stored<R: KindRequest>(text: &[u8], limits: &Limits) -> Result<Passed, Rejection> {
    let read = strict::read::<R>(text, &[]).map_err(|error| Rejection::Malformed(error.to_string()));
    checked(&read?.0, limits)
}

fn written(request: &impl KindRequest, limits: &Limits) -> Result<Read, Rejection> {
    let checked = checked(request, limits)?;
    // Numbers that were read from JSON are finite, so they can be written.
    let text = serde_json::to_vec(request).map_err(|error| Rejection::Malformed(error.to_string()))?;
    Ok((checked, text))
}

fn checked(request: &impl KindRequest, limits: &Limits) -> Result<Passed, Rejection> {
    let checked = request.check(limits)?;
    let (unit, up) = request.axes();
    Ok((Frame { unit, up }, checked))
}
