//! Numbers, texts and lists with bounds. When a type is deserialised, it refuses the values that its JSON Schema
//! refuses.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, Deserializer, Error};
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::ops::Deref;

/// Error text for serde. Clients see an explanation that is made from the schema instead.
const OUT_OF_BOUNDS: &str = "out of bounds";

/// Tests whether a number satisfies one keyword of a schema, such as `minimum`.
macro_rules! keeps {
    (minimum, $number:expr, $bound:literal) => {
        $number >= $bound as f64
    };
    (exclusiveMinimum, $number:expr, $bound:literal) => {
        $number > $bound as f64
    };
    (maximum, $number:expr, $bound:literal) => {
        $number <= $bound as f64
    };
    (exclusiveMaximum, $number:expr, $bound:literal) => {
        $number < $bound as f64
    };
}

/// Declares types that wrap an f64. Keywords of JSON Schema give the bounds of each type.
macro_rules! numbers {
    ($($(#[$doc:meta])* $name:ident { $($keyword:ident: $bound:literal),+ })+) => { $(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
        pub struct $name(f64);

        impl $name {
            /// # Panics
            /// Panics if the number is out of bounds.
            #[must_use]
            pub const fn new(number: f64) -> Self {
                assert!(Self::contains(number), "out of bounds");
                Self(number)
            }

            #[must_use]
            pub const fn get(self) -> f64 {
                self.0
            }

            const fn contains(number: f64) -> bool {
                $(keeps!($keyword, number, $bound))&&+
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let number = f64::deserialize(deserializer)?;
                if Self::contains(number) { Ok(Self(number)) } else { Err(Error::custom(OUT_OF_BOUNDS)) }
            }
        }

        impl JsonSchema for $name {
            fn inline_schema() -> bool {
                true
            }
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }
            fn json_schema(generator: &mut SchemaGenerator) -> Schema {
                let mut schema = f64::json_schema(generator);
                $(schema.insert(stringify!($keyword).into(), $bound.into());)+
                schema
            }
        }
    )+ };
}

numbers! {
    /// From 0 to 1.
    Fraction { minimum: 0, maximum: 1 }
    /// From 0 to 20.
    UpTo20 { minimum: 0, maximum: 20 }
    /// From 0 to 45.
    UpTo45 { minimum: 0, maximum: 45 }
    /// From 0 to 600.
    UpTo600 { minimum: 0, maximum: 600 }
    /// More than 0 and less than 180.
    Below180 { exclusiveMinimum: 0, exclusiveMaximum: 180 }
    /// At least 0.
    AtLeast0 { minimum: 0 }
    /// More than 0.
    MoreThan0 { exclusiveMinimum: 0 }
    /// More than 0, at most 1e50. The square of the bound is finite, and so is its product with a few others.
    Positive { exclusiveMinimum: 0, maximum: 1e50 }
    /// From 0 to 1e50.
    NonNegative { minimum: 0, maximum: 1e50 }
    /// From -1e50 to 1e50.
    Signed { minimum: -1e50, maximum: 1e50 }
    /// More than 0, at most 1e15.
    Length { exclusiveMinimum: 0, maximum: 1e15 }
    /// From 0 to 1e15.
    Tolerance { minimum: 0, maximum: 1e15 }
}

/// An integer from `MIN` to `MAX`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Whole<const MIN: u32, const MAX: u32>(u32);

impl<const MIN: u32, const MAX: u32> Whole<MIN, MAX> {
    /// # Panics
    /// Panics if the number is out of bounds.
    #[must_use]
    pub const fn new(number: u32) -> Self {
        assert!(MIN <= number && number <= MAX, "out of bounds");
        Self(number)
    }

    #[must_use]
    pub const fn get(self) -> u32 {
        self.0
    }
}

impl<'de, const MIN: u32, const MAX: u32> Deserialize<'de> for Whole<MIN, MAX> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let number = u32::deserialize(deserializer)?;
        if (MIN..=MAX).contains(&number) { Ok(Self(number)) } else { Err(Error::custom(OUT_OF_BOUNDS)) }
    }
}

impl<const MIN: u32, const MAX: u32> JsonSchema for Whole<MIN, MAX> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        format!("Whole_{MIN}_{MAX}").into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = u32::json_schema(generator);
        schema.insert("minimum".into(), MIN.into());
        schema.insert("maximum".into(), MAX.into());
        schema
    }
}

/// A string of `MIN` to `MAX` characters.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Text<const MIN: usize, const MAX: usize>(String);

impl<const MIN: usize, const MAX: usize> Deref for Text<MIN, MAX> {
    type Target = str;
    fn deref(&self) -> &str {
        &self.0
    }
}

impl<'de, const MIN: usize, const MAX: usize> Deserialize<'de> for Text<MIN, MAX> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        if counts::<MIN, MAX>(text.chars().count()) { Ok(Self(text)) } else { Err(Error::custom(OUT_OF_BOUNDS)) }
    }
}

impl<const MIN: usize, const MAX: usize> JsonSchema for Text<MIN, MAX> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        format!("Text_{MIN}_{MAX}").into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        with_counts::<MIN, MAX>(String::json_schema(generator), "minLength", "maxLength")
    }
}

/// A list of `MIN` to `MAX` items.
#[derive(Clone, Debug, PartialEq)]
pub struct List<T, const MIN: usize, const MAX: usize = { usize::MAX }>(Vec<T>);

impl<T, const MIN: usize, const MAX: usize> List<T, MIN, MAX> {
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<T, const MAX: usize> Default for List<T, 0, MAX> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T, const MIN: usize, const MAX: usize> Deref for List<T, MIN, MAX> {
    type Target = [T];
    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<T: Serialize, const MIN: usize, const MAX: usize> Serialize for List<T, MIN, MAX> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

impl<'de, T: Deserialize<'de>, const MIN: usize, const MAX: usize> Deserialize<'de> for List<T, MIN, MAX> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let list = Vec::deserialize(deserializer)?;
        if counts::<MIN, MAX>(list.len()) { Ok(Self(list)) } else { Err(Error::custom(OUT_OF_BOUNDS)) }
    }
}

impl<T: JsonSchema, const MIN: usize, const MAX: usize> JsonSchema for List<T, MIN, MAX> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        format!("List_{MIN}_{MAX}_of_{}", T::schema_name()).into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        with_counts::<MIN, MAX>(Vec::<T>::json_schema(generator), "minItems", "maxItems")
    }
}

fn counts<const MIN: usize, const MAX: usize>(count: usize) -> bool {
    (MIN..=MAX).contains(&count)
}

fn with_counts<const MIN: usize, const MAX: usize>(mut schema: Schema, least: &str, most: &str) -> Schema {
    if MIN > 0 {
        schema.insert(least.into(), MIN.into());
    }
    if MAX < usize::MAX {
        schema.insert(most.into(), MAX.into());
    }
    schema
}

/// Reads a member that may be absent but not null.
///
/// # Errors
/// Returns the errors of the member.
pub fn given<'de, T: Deserialize<'de>, D: Deserializer<'de>>(deserializer: D) -> Result<Option<T>, D::Error> {
    T::deserialize(deserializer).map(Some)
}

/// An object with several optional members, of which a valid object has exactly one.
pub trait OneOf {
    /// Returns the number of members that are given.
    fn given(&self) -> usize;
}

/// Reads an object that has exactly one member.
///
/// # Errors
/// Fails if it has none or several, and returns the errors of the members.
pub fn one<'de, T: Deserialize<'de> + OneOf, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    let object = T::deserialize(deserializer)?;
    if object.given() == 1 { Ok(object) } else { Err(Error::custom(OUT_OF_BOUNDS)) }
}

/// Reads a member that may be absent, and otherwise has exactly one member itself.
///
/// # Errors
/// Returns the errors of [`one`].
pub fn given_one<'de, T: Deserialize<'de> + OneOf, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Option<T>, D::Error> {
    one(deserializer).map(Some)
}

/// Returns whether a member has its default value. The member need not be written then, because a missing member has
/// this value.
pub fn is_default<T: Default + PartialEq>(member: &T) -> bool {
    *member == T::default()
}

/// The default of a member that is true unless the request says otherwise.
pub fn yes() -> bool {
    true
}

/// Always returns true, so that serde leaves a member out of the written request. It is for members that are stored
/// elsewhere.
pub fn unwritten<T>(_member: &T) -> bool {
    true
}
