//! Deserialises types as strictly as their schemas.
//!
//! serde's derived implementations accept more than the schemas of their types: a struct may be an array of its fields,
//! and a variant of an enum an object with one member. In one case they accept less: 2050.0 is an integer in JSON
//! Schema, but not in serde. `Strict` wraps a deserializer, and every deserializer inside it, so that a type accepts
//! exactly what its schema accepts.

use crate::json::{self, AnyValue, integral};
use crate::rejection::{FieldError, Rejection};
use serde::de::value::MapAccessDeserializer;
use serde::de::{
    Deserialize, DeserializeOwned, DeserializeSeed, Deserializer, Error, IntoDeserializer, MapAccess, SeqAccess,
    Visitor,
};
use serde_json::{Map, Value};
#[cfg(feature = "stored")]
use serde_path_to_error::Track;
use std::cell::Cell;
use std::fmt;
use std::marker::PhantomData;

/// A `T` that was read from the JSON of an object.
#[derive(Debug)]
pub struct Parted<T> {
    pub read: T,
    /// Names of the object's members that are part of the `T`, in the order of the text.
    pub names: Vec<String>,
    /// The other members.
    pub aside: Map<String, Value>,
}

/// Reads a `T` from the JSON of an object. The members that `aside` names are not part of the `T` and are returned
/// separately.
///
/// # Errors
/// Fails if the text is not JSON, if an object repeats a key, or if `T` refuses the other members.
pub fn read<'de, T: Deserialize<'de>>(text: &'de [u8], aside: &[&str]) -> serde_json::Result<Parted<T>> {
    let mut deserializer = serde_json::Deserializer::from_slice(text);
    let (mut names, mut taken, left) = (Vec::new(), Map::new(), Cell::new(ASIDE_BYTES));
    let visitor = Parts { aside, names: &mut names, taken: &mut taken, left: &left, rest: PhantomData };
    let read = deserializer.deserialize_map(visitor)?;
    deserializer.end()?;
    Ok(Parted { read, names, aside: taken })
}

/// Same as [`read`], for a body whose JSON values would take too much memory. Takes longer than [`read`].
///
/// # Errors
/// Returns the first place at which `T` refuses the text.
#[cfg(feature = "stored")]
pub fn read_tracked<T: DeserializeOwned>(text: &[u8], aside: &[&str]) -> Result<Parted<T>, Rejection> {
    json::refuse_what_is_no_text(text)?;
    let mut track = Track::new();
    let mut deserializer = serde_json::Deserializer::from_slice(text);
    let (mut names, mut taken, left) = (Vec::new(), Map::new(), Cell::new(ASIDE_BYTES));
    let visitor = Parts { aside, names: &mut names, taken: &mut taken, left: &left, rest: PhantomData };
    let read = serde_path_to_error::Deserializer::new(&mut deserializer, &mut track).deserialize_map(visitor);
    let error = match read.and_then(|rest| deserializer.end().map(|()| rest)) {
        Ok(read) => return Ok(Parted { read, names, aside: taken }),
        Err(error) => error,
    };
    let pointer = json::pointer(&track.path());
    let message = error.to_string();
    if !error.is_data() || message.starts_with(REPEATED) {
        return Err(json::unparsed(text, &error, || pointer.clone()));
    }
    let detail = if message.starts_with(json::TOO_LONG) {
        format!("has more than {ASIDE_BYTES} bytes as JSON text")
    } else {
        FORM.to_owned()
    };
    Err(FieldError::new(pointer, detail).into())
}

/// Number of bytes of JSON text without white space that the members that are set aside may have together.
const ASIDE_BYTES: usize = 64 << 10;
/// Beginning of the error for an object that repeats a key.
const REPEATED: &str = "an object repeats a key";
/// Detail of the error for a value that a type refuses.
const FORM: &str = "must have the form that the schema requires";

/// Reads a value that [`json::parse`] made.
///
/// # Errors
/// Returns the first place at which `T` refuses the value.
pub fn deserialize<T: DeserializeOwned>(value: &Value) -> Result<T, Rejection> {
    T::deserialize(Strict(value)).map_err(|_| refusal::<T>(value))
}

/// Reads a value that [`json::parse`] made, or returns `None` if `T` refuses it.
pub fn value<T: DeserializeOwned>(value: &Value) -> Option<T> {
    // Without `stored`, as in a web page, `value` and `refusal` share one deserializer, because a second one for each
    // type would make the module that is downloaded larger.
    #[cfg(feature = "stored")]
    let read = T::deserialize(Strict(value)).ok();
    #[cfg(not(feature = "stored"))]
    let read = serde_path_to_error::deserialize::<_, T>(Strict(value)).ok();
    read
}

/// Returns the first place at which `T` refuses a value.
pub fn refusal<T: DeserializeOwned>(value: &Value) -> Rejection {
    // The path is tracked only here, because tracking takes as long as reading.
    let Err(error) = serde_path_to_error::deserialize::<_, T>(Strict(value)) else { return Rejection::Invalid(vec![]) };
    FieldError::new(json::pointer(error.path()), FORM).into()
}

/// Visitor of an object that puts the members named in `aside` into `taken`, makes a `T` from the others, and puts
/// their names into `names`.
struct Parts<'a, T> {
    aside: &'a [&'a str],
    names: &'a mut Vec<String>,
    taken: &'a mut Map<String, Value>,
    /// Number of bytes that the members may still have.
    left: &'a Cell<usize>,
    rest: PhantomData<T>,
}

impl<'de, T: Deserialize<'de>> Visitor<'de> for Parts<'_, T> {
    type Value = T;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a request")
    }
    fn visit_map<A: MapAccess<'de>>(self, entries: A) -> Result<T, A::Error> {
        let rest = Rest { entries, aside: self.aside, names: self.names, taken: self.taken, left: self.left };
        T::deserialize(Strict(MapAccessDeserializer::new(rest)))
    }
}

/// Access to the members of an object that are not set aside.
struct Rest<'a, A> {
    entries: A,
    aside: &'a [&'a str],
    names: &'a mut Vec<String>,
    taken: &'a mut Map<String, Value>,
    left: &'a Cell<usize>,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for Rest<'_, A> {
    type Error = A::Error;
    fn next_key_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, A::Error> {
        while let Some(name) = self.entries.next_key::<String>()? {
            if !self.aside.contains(&name.as_str()) {
                let key = seed.deserialize(name.as_str().into_deserializer())?;
                self.names.push(name);
                return Ok(Some(key));
            }
            if self.taken.contains_key(&name) {
                return Err(Error::custom(REPEATED));
            }
            let value = self.entries.next_value_seed(AnyValue::within(self.left))?;
            self.taken.insert(name, value);
        }
        Ok(None)
    }
    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, A::Error> {
        self.entries.next_value_seed(seed)
    }
}

/// Wraps a deserializer or one of serde's parts of it. It reads structs only from objects, names only from strings, and
/// integers from every integral number.
struct Strict<T>(pub T);

macro_rules! forward {
    ($($method:ident)+) => { $(
        fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, D::Error> {
            self.0.$method(visitor)
        }
    )+ };
}

macro_rules! wrap {
    ($($method:ident)+) => { $(
        fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, D::Error> {
            self.0.$method(Strict(visitor))
        }
    )+ };
}

impl<'de, D: Deserializer<'de>> Deserializer<'de> for Strict<D> {
    type Error = D::Error;

    forward! {
        deserialize_bool deserialize_f32 deserialize_f64 deserialize_char deserialize_str deserialize_string
        deserialize_bytes deserialize_byte_buf deserialize_unit deserialize_identifier deserialize_ignored_any
    }
    wrap! {
        deserialize_any deserialize_option deserialize_seq deserialize_map deserialize_i8 deserialize_i16
        deserialize_i32 deserialize_i64 deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(self, name: &'static str, visitor: V) -> Result<V::Value, D::Error> {
        self.0.deserialize_unit_struct(name, visitor)
    }
    fn deserialize_newtype_struct<V: Visitor<'de>>(self, name: &'static str, visitor: V) -> Result<V::Value, D::Error> {
        self.0.deserialize_newtype_struct(name, Strict(visitor))
    }
    fn deserialize_tuple<V: Visitor<'de>>(self, len: usize, visitor: V) -> Result<V::Value, D::Error> {
        self.0.deserialize_tuple(len, Strict(visitor))
    }
    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        len: usize,
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        self.0.deserialize_tuple_struct(name, len, Strict(visitor))
    }
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        self.0.deserialize_map(Strict(visitor))
    }
    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        self.0.deserialize_str(Name(visitor))
    }
}

impl<'de, V: Visitor<'de>> Visitor<'de> for Strict<V> {
    type Value = V::Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.expecting(f)
    }
    fn visit_bool<E: Error>(self, value: bool) -> Result<V::Value, E> {
        self.0.visit_bool(value)
    }
    fn visit_i64<E: Error>(self, value: i64) -> Result<V::Value, E> {
        self.0.visit_i64(value)
    }
    fn visit_u64<E: Error>(self, value: u64) -> Result<V::Value, E> {
        self.0.visit_u64(value)
    }
    fn visit_f64<E: Error>(self, value: f64) -> Result<V::Value, E> {
        match integral(value) {
            Some(integer) => self.0.visit_i64(integer),
            None => self.0.visit_f64(value),
        }
    }
    fn visit_str<E: Error>(self, value: &str) -> Result<V::Value, E> {
        self.0.visit_str(value)
    }
    fn visit_borrowed_str<E: Error>(self, value: &'de str) -> Result<V::Value, E> {
        self.0.visit_borrowed_str(value)
    }
    fn visit_string<E: Error>(self, value: String) -> Result<V::Value, E> {
        self.0.visit_string(value)
    }
    fn visit_none<E: Error>(self) -> Result<V::Value, E> {
        self.0.visit_none()
    }
    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<V::Value, D::Error> {
        self.0.visit_some(Strict(deserializer))
    }
    fn visit_unit<E: Error>(self) -> Result<V::Value, E> {
        self.0.visit_unit()
    }
    fn visit_newtype_struct<D: Deserializer<'de>>(self, deserializer: D) -> Result<V::Value, D::Error> {
        self.0.visit_newtype_struct(Strict(deserializer))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<V::Value, A::Error> {
        self.0.visit_seq(Strict(items))
    }
    fn visit_map<A: MapAccess<'de>>(self, entries: A) -> Result<V::Value, A::Error> {
        self.0.visit_map(Strict(entries))
    }
}

impl<'de, A: SeqAccess<'de>> SeqAccess<'de> for Strict<A> {
    type Error = A::Error;
    fn next_element_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, A::Error> {
        self.0.next_element_seed(Strict(seed))
    }
    fn size_hint(&self) -> Option<usize> {
        self.0.size_hint()
    }
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for Strict<A> {
    type Error = A::Error;
    fn next_key_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, A::Error> {
        self.0.next_key_seed(seed)
    }
    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, A::Error> {
        self.0.next_value_seed(Strict(seed))
    }
}

impl<'de, S: DeserializeSeed<'de>> DeserializeSeed<'de> for Strict<S> {
    type Value = S::Value;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<S::Value, D::Error> {
        self.0.deserialize(Strict(deserializer))
    }
}

/// Visitor of an enum whose variants carry no data, so that each is a name in JSON.
struct Name<V>(V);

impl<'de, V: Visitor<'de>> Visitor<'de> for Name<V> {
    type Value = V::Value;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.expecting(f)
    }
    fn visit_str<E: Error>(self, name: &str) -> Result<V::Value, E> {
        self.0.visit_enum(IntoDeserializer::<E>::into_deserializer(name))
    }
}

/// Implements `Deserialize` for a union. The JSON type of the value selects the variant. serde's untagged enums are not
/// used, because they copy the value and try one variant after the other.
#[macro_export]
macro_rules! union {
    ($name:ident { $($of:ident: $variant:ident),+ }) => {
        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Branches;
                impl<'de> serde::de::Visitor<'de> for Branches {
                    type Value = $name;
                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str(stringify!($name))
                    }
                    $($crate::branch!($of, $name, $variant);)+
                }
                deserializer.deserialize_any(Branches)
            }
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! branch {
    (boolean, $name:ident, $variant:ident) => {
        fn visit_bool<E>(self, value: bool) -> Result<$name, E> {
            Ok($name::$variant(value))
        }
    };
    (name, $name:ident, $variant:ident) => {
        fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<$name, E> {
            serde::Deserialize::deserialize(serde::de::value::StrDeserializer::new(name)).map($name::$variant)
        }
    };
    (list, $name:ident, $variant:ident) => {
        fn visit_seq<A: serde::de::SeqAccess<'de>>(self, items: A) -> Result<$name, A::Error> {
            serde::Deserialize::deserialize(serde::de::value::SeqAccessDeserializer::new(items)).map($name::$variant)
        }
    };
    (object, $name:ident, $variant:ident) => {
        fn visit_map<A: serde::de::MapAccess<'de>>(self, entries: A) -> Result<$name, A::Error> {
            serde::Deserialize::deserialize(serde::de::value::MapAccessDeserializer::new(entries)).map($name::$variant)
        }
    };
}
