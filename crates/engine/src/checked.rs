//! Traits that the request type of a kind implements, and the functions through which the table of kinds uses that
//! type.

use crate::limits::Limits;
use crate::options::{Given, Optioned, RequestOption, idle_members};
use crate::solved::{CoordinateSystem, SolverInput};
use crate::source::{self, Find, JobSource, Source};
use plateau_archive::units::{Unit, UpAxis};
use plateau_strict_json::rejection::{FieldError, Rejection};
use plateau_strict_json::strict;
#[cfg(feature = "stored")]
use plateau_strict_json::strict::Parted;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::borrow::Cow;

/// Result of checking a request.
#[derive(Debug)]
pub(crate) struct Checked {
    pub memory_bytes: u64,
    pub quick: bool,
    pub input: Box<dyn SolverInput>,
}

/// The request type of a kind, with the fields of the request's JSON.
pub(crate) trait KindRequest: DeserializeOwned + Serialize + JsonSchema + Optioned {
    type Statistics: JsonSchema;

    /// Returns the unit of the coordinates and the axis that points up.
    fn axes(&self) -> (Unit, UpAxis);

    /// Checks what deserialising the type has not checked, and converts the request to the geometry's types.
    ///
    /// # Errors
    /// Returns every offending value.
    fn check(&self, limits: &Limits) -> Result<Checked, Rejection>;
}

/// The request type of a kind whose requests begin with the result of a finished job.
pub(crate) trait SourcedRequest: DeserializeOwned + Serialize + JsonSchema + Optioned {
    type Statistics: JsonSchema;

    fn source(&self) -> &JobSource;

    /// Checks what deserialising the type has not checked, and converts the request and its source to the geometry's
    /// types.
    ///
    /// # Errors
    /// Returns every offending value.
    fn check(&self, source: &Source, limits: &Limits) -> Result<Checked, Rejection>;
}

/// A request that passed every check of its kind.
pub(crate) struct Passed {
    pub coordinates: CoordinateSystem,
    pub checked: Checked,
    /// Key by which the host finds the result from which the request begins. `None` if the kind has no source.
    pub source: Option<Vec<u8>>,
}
/// A request that passed its checks, and its JSON as its type writes it.
pub(crate) type Read = (Passed, Vec<u8>);
/// A request that passed its checks, and the members of the body that are not part of the request.
#[cfg(feature = "stored")]
pub(crate) type ReadApart = (Read, serde_json::Map<String, Value>);

/// Reads a request and the members that are set aside from a body, or returns the first reason against it.
#[cfg(feature = "stored")]
type ReadTracked = fn(&[u8], &[&str], Find<'_>, &Limits) -> Result<ReadApart, Rejection>;

/// The operations on the types of a kind, as function pointers without type parameters, so that one table can hold
/// every kind.
pub(crate) struct Types {
    #[cfg(feature = "explain")]
    pub request: TypeSchema,
    #[cfg(feature = "explain")]
    pub statistics: TypeSchema,
    pub has_source: bool,
    pub options: &'static [RequestOption],
    /// Lists that differ if they are empty from lists that are left out (see [`Optioned::EMPTY_LISTS`]).
    pub empty_lists: &'static [(&'static str, &'static str)],
    /// Reads a request from its JSON. The members that the list names are returned separately. Returns `None` if the
    /// body is refused.
    #[cfg(feature = "stored")]
    pub read: fn(&[u8], &[&str], Find<'_>, &Limits) -> Option<ReadApart>,
    /// Same as `read`, but returns the first reason for which a body is refused. It takes longer.
    #[cfg(feature = "stored")]
    pub read_tracked: ReadTracked,
    /// Reads a request from a JSON value without the members that count as left out. The error is `None` if the type
    /// refuses the value.
    pub read_value: fn(&Value, Find<'_>, &Limits) -> Result<Read, Option<Rejection>>,
    /// Returns the first place at which the type refuses a value. It explains values that the type refuses although the
    /// schema accepts them.
    pub refusal: fn(&Value) -> Rejection,
    /// Reads the JSON that the type itself has written for an accepted request.
    #[cfg(feature = "stored")]
    pub read_stored: fn(&[u8], Find<'_>, &Limits) -> Result<Passed, Rejection>,
}

impl Types {
    pub const fn of<R: KindRequest>() -> Self {
        Self {
            #[cfg(feature = "explain")]
            request: TypeSchema::of::<R>(),
            #[cfg(feature = "explain")]
            statistics: TypeSchema::of::<R::Statistics>(),
            has_source: false,
            options: R::OPTIONS,
            empty_lists: R::EMPTY_LISTS,
            #[cfg(feature = "stored")]
            read: |body, aside, _, limits| read::<R>(body, aside, |request| checked(request, limits)),
            #[cfg(feature = "stored")]
            read_tracked: |body, aside, _, limits| read_tracked::<R>(body, aside, |request| checked(request, limits)),
            read_value: |value, _, limits| read_value::<R>(value, |request| checked(request, limits)),
            refusal: strict::refusal::<R>,
            #[cfg(feature = "stored")]
            read_stored: |text, _, limits| read_stored::<R>(text, |request| checked(request, limits)),
        }
    }

    /// Creates the operations of a kind whose requests begin with the result of a finished job.
    #[cfg_attr(not(feature = "test-hooks"), expect(dead_code, reason = "only a kind for tests has a source"))]
    pub const fn sourced<R: SourcedRequest>() -> Self {
        Self {
            #[cfg(feature = "explain")]
            request: TypeSchema::of::<R>(),
            #[cfg(feature = "explain")]
            statistics: TypeSchema::of::<R::Statistics>(),
            has_source: true,
            options: R::OPTIONS,
            empty_lists: R::EMPTY_LISTS,
            #[cfg(feature = "stored")]
            read: |body, aside, find, limits| read::<R>(body, aside, |request| checked_from(request, find, limits)),
            #[cfg(feature = "stored")]
            read_tracked: |body, aside, find, limits| {
                read_tracked::<R>(body, aside, |request| checked_from(request, find, limits))
            },
            read_value: |value, find, limits| read_value::<R>(value, |request| checked_from(request, find, limits)),
            refusal: strict::refusal::<R>,
            #[cfg(feature = "stored")]
            read_stored: |text, find, limits| read_stored::<R>(text, |request| checked_from(request, find, limits)),
        }
    }
}

/// Functions that return the name and the schema of a type.
#[cfg(feature = "explain")]
pub(crate) struct TypeSchema {
    pub name: fn() -> Cow<'static, str>,
    /// Adds the schema to a generator's definitions and returns a reference to it.
    pub reference: fn(&mut SchemaGenerator) -> Schema,
    /// Returns the schema with all definitions.
    pub root: fn(SchemaGenerator) -> Schema,
}

#[cfg(feature = "explain")]
impl TypeSchema {
    const fn of<T: JsonSchema>() -> Self {
        Self {
            name: T::schema_name,
            reference: SchemaGenerator::subschema_for::<T>,
            root: SchemaGenerator::into_root_schema_for::<T>,
        }
    }
}

/// Function that checks a request after it has been read.
type Checks<'a, R> = &'a dyn Fn(&R) -> Result<Passed, Rejection>;

#[cfg(feature = "stored")]
fn read<R: DeserializeOwned + Serialize + Optioned>(
    body: &[u8],
    aside: &[&str],
    checks: impl Fn(&R) -> Result<Passed, Rejection>,
) -> Option<ReadApart> {
    let Parted { read, names, aside } = strict::read::<R>(body, aside).ok()?;
    // A member that is null or an empty list counts as left out, which only a request that is read from a value can
    // tell.
    let idle = idle_members(&read, &Given::Names(&names));
    idle.is_empty().then_some(())?;
    Some((written(&read, &checks).ok()?, aside))
}

#[cfg(feature = "stored")]
fn read_tracked<R: DeserializeOwned + Serialize + Optioned>(
    body: &[u8],
    aside: &[&str],
    checks: impl Fn(&R) -> Result<Passed, Rejection>,
) -> Result<ReadApart, Rejection> {
    let Parted { read, names, aside } = strict::read_tracked::<R>(body, aside)?;
    let idle = idle_members(&read, &Given::Names(&names));
    if !idle.is_empty() {
        return Err(Rejection::Invalid(idle));
    }
    Ok((written(&read, &checks)?, aside))
}

fn read_value<R: DeserializeOwned + Serialize + Optioned>(
    value: &Value,
    checks: impl Fn(&R) -> Result<Passed, Rejection>,
) -> Result<Read, Option<Rejection>> {
    let request = strict::value::<R>(value).ok_or(None)?;
    let idle = idle_members(&request, &Given::Body(value));
    if !idle.is_empty() {
        return Err(Some(Rejection::Invalid(idle)));
    }
    written(&request, &checks).map_err(Some)
}

#[cfg(feature = "stored")]
fn read_stored<R: DeserializeOwned>(
    text: &[u8],
    checks: impl Fn(&R) -> Result<Passed, Rejection>,
) -> Result<Passed, Rejection> {
    let read = strict::read::<R>(text, &[]).map_err(|error| Rejection::Malformed(error.to_string()));
    checks(&read?.read)
}

fn written<R: Serialize>(request: &R, checks: Checks<'_, R>) -> Result<Read, Rejection> {
    let passed = checks(request)?;
    Ok((passed, text_of(request)?))
}

#[cfg(feature = "stored")]
fn text_of(request: &impl Serialize) -> Result<Vec<u8>, Rejection> {
    // Numbers that were read from JSON are finite, so they can be written.
    serde_json::to_vec(request).map_err(|error| Rejection::Malformed(error.to_string()))
}

#[cfg(not(feature = "stored"))]
fn text_of(_: &impl Serialize) -> Result<Vec<u8>, Rejection> {
    Ok(Vec::new())
}

fn checked(request: &impl KindRequest, limits: &Limits) -> Result<Passed, Rejection> {
    let checked = request.check(limits)?;
    let (unit, up) = request.axes();
    Ok(Passed { coordinates: CoordinateSystem { unit, up }, checked, source: None })
}

fn checked_from(request: &impl SourcedRequest, find: Find<'_>, limits: &Limits) -> Result<Passed, Rejection> {
    let missing = |reason| Rejection::Invalid(vec![FieldError::new(source::POINTER, reason)]);
    let source = find(&request.source().job).map_err(missing)?;
    let mut checked = request.check(&source, limits)?;
    checked.memory_bytes = checked.memory_bytes.saturating_add(source.memory_bytes());
    let contents = source.archive().contents();
    let coordinates = CoordinateSystem { unit: contents.unit, up: contents.up };
    Ok(Passed { coordinates, checked, source: Some(source.key().to_vec()) })
}
