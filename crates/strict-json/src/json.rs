//! Strict parser of JSON bodies.
//!
//! Duplicate keys are refused. A number that is not finite in f64 is refused with its pointer. An integral number
//! becomes an integer however it was written (`2050.0` becomes 2050), except that -0.0 stays a float. serde_json limits
//! the nesting to 128 levels.

use crate::rejection::{FieldError, Rejection};
use serde::de::{DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Number, Value};
use serde_path_to_error::{Path, Segment, Track};
use std::cell::Cell;
use std::fmt;

/// Parses a body.
///
/// # Errors
/// Returns [`Rejection::Malformed`] if the body is not JSON or repeats a key, and [`Rejection::Invalid`] if a number
/// overflows f64.
pub fn parse(body: &[u8]) -> Result<Value, Rejection> {
    refuse_what_is_no_text(body)?;
    let mut deserializer = serde_json::Deserializer::from_slice(body);
    let outcome =
        AnyValue::default().deserialize(&mut deserializer).and_then(|value| deserializer.end().map(|()| value));
    outcome.map_err(|error| unparsed(body, &error, || stopped_at(body)))
}

/// Returns the rejection of a body that cannot be parsed. `stopped_at` returns the JSON Pointer of the value at which
/// the parser stopped.
pub(crate) fn unparsed(body: &[u8], error: &serde_json::Error, stopped_at: impl Fn() -> String) -> Rejection {
    let text = error.to_string();
    let invalid = |detail: String| Rejection::Invalid(vec![FieldError::new(stopped_at(), detail)]);
    if text.starts_with("number out of range") {
        return invalid("is not a finite number in 64-bit floating point".into());
    }
    let end = offset_of(body, error.line(), error.column());
    match not_a_number(body, end) {
        Some(name) => invalid(format!("is {name}, which JSON cannot hold: only finite numbers are allowed")),
        None if end > 0 && body[end - 1] == b'\'' => {
            Rejection::Malformed(format!("{text}: JSON writes names and strings in double quotes"))
        }
        None => Rejection::Malformed(text),
    }
}

/// Refuses an empty body, and a body that is not plain UTF-8 by its first bytes.
pub(crate) fn refuse_what_is_no_text(body: &[u8]) -> Result<(), Rejection> {
    if let Some(encoding) = foreign_encoding(body) {
        return Err(Rejection::Malformed(format!("the body {encoding}: send JSON as UTF-8 without a byte order mark")));
    }
    if body.iter().all(u8::is_ascii_whitespace) {
        return Err(Rejection::Malformed("the body is empty: send a JSON object".into()));
    }
    Ok(())
}

/// Recognises by its first bytes a body that is not plain UTF-8, and returns a description of its encoding.
fn foreign_encoding(body: &[u8]) -> Option<&'static str> {
    Some(match body {
        [0xef, 0xbb, 0xbf, ..] => "begins with a byte order mark (BOM)",
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [b'{' | b'[' | b' ', 0, ..] | [0, b'{' | b'[' | b' ', ..] => "is UTF-16",
        [0x1f, 0x8b, ..] => "is compressed with gzip",
        [0x28, 0xb5, 0x2f, 0xfd, ..] => "is compressed with zstd",
        _ => return None,
    })
}

/// Returns the name of a number that is not finite, if the parser stopped at one. Python and JavaScript write such
/// names.
fn not_a_number(body: &[u8], end: usize) -> Option<&'static str> {
    // The parser stops at the first letter, or at the sign before it.
    let from = end.saturating_sub(2);
    let start = (from..body.len().min(end + 2)).find(|&at| body[at].is_ascii_alphabetic())?;
    let length = body[start..].iter().take_while(|byte| byte.is_ascii_alphanumeric()).count();
    match body[start..start + length].to_ascii_lowercase().as_slice() {
        b"nan" => Some("NaN"),
        b"inf" | b"infinity" => Some("Infinity"),
        _ => None,
    }
}

/// Returns the integer that equals `value`, if there is one below 2^53. -0.0 stays a float, so that it keeps its sign.
#[must_use]
pub fn integral(value: f64) -> Option<i64> {
    let is_integral = value.abs() < 9_007_199_254_740_992.0 && value as i64 as f64 == value;
    (is_integral && !(value == 0.0 && value.is_sign_negative())).then_some(value as i64)
}

fn offset_of(body: &[u8], line: usize, column: usize) -> usize {
    let start: usize = body.split_inclusive(|&byte| byte == b'\n').take(line.saturating_sub(1)).map(<[u8]>::len).sum();
    (start + column).min(body.len())
}

/// Returns the JSON Pointer of the value at which the parser stopped. The body is parsed again with tracking of the
/// place only after an error, because tracking takes as long as parsing.
fn stopped_at(body: &[u8]) -> String {
    let mut track = Track::new();
    let mut deserializer = serde_json::Deserializer::from_slice(body);
    // The error itself is known: the parser fails at the same place as before.
    let _ = AnyValue::default().deserialize(serde_path_to_error::Deserializer::new(&mut deserializer, &mut track));
    pointer(&track.path())
}

/// Returns a path as a JSON Pointer.
pub(crate) fn pointer(path: &Path) -> String {
    let segments = path.iter().map(|segment| match segment {
        Segment::Seq { index } => format!("/{index}"),
        Segment::Map { key } => format!("/{}", key.replace('~', "~0").replace('/', "~1")),
        _ => String::new(),
    });
    segments.collect()
}

/// Beginning of the error for a value beyond the length that [`AnyValue`] may have.
pub(crate) const TOO_LONG: &str = "has more text than is allowed";

/// Reads any value by the rules of [`parse`].
#[derive(Clone, Copy, Default)]
pub(crate) struct AnyValue<'a> {
    /// Number of bytes of JSON text without white space that this value and others may still have, at least. `None`
    /// means any number.
    left: Option<&'a Cell<usize>>,
}

impl<'a> AnyValue<'a> {
    pub(crate) fn within(left: &'a Cell<usize>) -> Self {
        Self { left: Some(left) }
    }

    /// Counts bytes of text.
    fn spend<E: serde::de::Error>(self, bytes: usize) -> Result<(), E> {
        let Some(left) = self.left else { return Ok(()) };
        left.set(left.get().checked_sub(bytes).ok_or_else(|| E::custom(TOO_LONG))?);
        Ok(())
    }
}

impl<'de> DeserializeSeed<'de> for AnyValue<'_> {
    type Value = Value;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for AnyValue<'_> {
    type Value = Value;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }
    fn visit_bool<E: serde::de::Error>(self, value: bool) -> Result<Value, E> {
        self.spend(1)?;
        Ok(Value::Bool(value))
    }
    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Value, E> {
        self.spend(1)?;
        Ok(Value::Number(value.into()))
    }
    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Value, E> {
        self.spend(1)?;
        Ok(Value::Number(value.into()))
    }
    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Value, E> {
        self.spend(1)?;
        let number = integral(value).map(Number::from).or_else(|| Number::from_f64(value));
        Ok(number.map_or(Value::Null, Value::Number))
    }
    fn visit_str<E: serde::de::Error>(self, value: &str) -> Result<Value, E> {
        self.spend(value.len() + 2)?;
        Ok(Value::String(value.to_owned()))
    }
    fn visit_string<E: serde::de::Error>(self, value: String) -> Result<Value, E> {
        self.spend(value.len() + 2)?;
        Ok(Value::String(value))
    }
    fn visit_unit<E: serde::de::Error>(self) -> Result<Value, E> {
        self.spend(1)?;
        Ok(Value::Null)
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Value, A::Error> {
        self.spend(2)?;
        // Most arrays are points with three coordinates.
        let mut list = Vec::with_capacity(3);
        while let Some(value) = seq.next_element_seed(self)? {
            if list.len() == list.capacity() {
                // Doubling a long list would take three times its memory for a moment.
                list.reserve_exact(list.len().max(3) / if list.len() < 1024 { 1 } else { 4 });
            }
            list.push(value);
        }
        list.shrink_to_fit();
        Ok(Value::Array(list))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Value, A::Error> {
        self.spend(2)?;
        let mut map = Map::new();
        while let Some(key) = entries.next_key::<String>()? {
            self.spend(key.len() + 3)?;
            if map.contains_key(&key) {
                return Err(serde::de::Error::custom("an object repeats a key"));
            }
            map.insert(key, entries.next_value_seed(self)?);
        }
        Ok(Value::Object(map))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_repeated_key_is_malformed() {
        assert!(
            matches!(parse(br#"{"a":1,"a":2}"#), Err(Rejection::Malformed(text)) if text.contains("repeats a key"))
        );
    }

    #[test]
    fn the_error_for_an_overflowing_number_has_its_pointer() {
        let body = br#"{"x/y": {"s": "a,[\"", "z": 1}, "boundaries": [[[0,0,0],
            [1, 1e999, 0]]]}"#;
        let Err(Rejection::Invalid(errors)) = parse(body) else { panic!("should be refused") };
        assert_eq!(errors[0].pointer, "/boundaries/0/1/1");
        let Err(Rejection::Invalid(errors)) = parse(br#"{"x/y": 1e999}"#) else { panic!("should be refused") };
        assert_eq!(errors[0].pointer, "/x~1y");
    }

    #[test]
    fn encodings_other_than_plain_utf8_are_named() {
        let utf16: Vec<u8> = "{}".encode_utf16().flat_map(u16::to_le_bytes).collect();
        for (body, name) in [
            (&b"\xef\xbb\xbf{}"[..], "byte order mark"),
            (b"\xff\xfe{\0}\0", "UTF-16"),
            (b"\xfe\xff\0{\0}", "UTF-16"),
            (&utf16, "UTF-16"),
            (b"\x1f\x8b\x08\0", "gzip"),
            (b"\x28\xb5\x2f\xfd\0", "zstd"),
        ] {
            assert!(matches!(parse(body), Err(Rejection::Malformed(text)) if text.contains(name)), "{name}");
        }
    }

    #[test]
    fn numbers_that_are_not_finite_are_named_with_their_pointers() {
        for (written, name) in [
            ("NaN", "NaN"),
            ("nan", "NaN"),
            ("-NaN", "NaN"),
            ("Infinity", "Infinity"),
            ("-Infinity", "Infinity"),
            ("inf", "Infinity"),
        ] {
            for body in [format!(r#"{{"p": [[0, 1, {written}], 2]}}"#), format!(r#"{{"p": [[0, 1, {written}"#)] {
                let Err(Rejection::Invalid(errors)) = parse(body.as_bytes()) else { panic!("{body}") };
                assert_eq!(errors[0].pointer, "/p/0/2", "{body}");
                assert!(errors[0].detail.starts_with(&format!("is {name},")), "{errors:?}");
            }
        }
        for other in [r#"{"a": nothing}"#, r#"{"a": infant"#, "[1, nano]", r#"{"a": tru}"#] {
            assert!(matches!(parse(other.as_bytes()), Err(Rejection::Malformed(_))), "{other}");
        }
    }

    #[test]
    fn integral_floats_are_integers_and_minus_zero_keeps_its_sign() {
        assert_eq!(parse(b"2050.0").unwrap(), Value::from(2050));
        assert!(parse(b"-0.0").unwrap().as_f64().unwrap().is_sign_negative());
    }

    #[test]
    fn empty_bodies_and_single_quotes_are_named() {
        for (body, detail) in [
            ("", "the body is empty: send a JSON object"),
            (" \n", "the body is empty: send a JSON object"),
            (
                "{'units': \"m\"}",
                "key must be a string at line 1 column 2: JSON writes names and strings in double quotes",
            ),
            ("{\"units\":\n 'm'}", "expected value at line 2 column 2: JSON writes names and strings in double quotes"),
            ("{\"units\": m}", "expected value at line 1 column 11"),
        ] {
            assert!(matches!(parse(body.as_bytes()), Err(Rejection::Malformed(text)) if text == detail), "{body}");
        }
    }

    #[test]
    fn deep_nesting_and_trailing_text_are_malformed() {
        assert!(matches!(parse("[".repeat(100_000).as_bytes()), Err(Rejection::Malformed(_))));
        assert!(matches!(parse(b"{} x"), Err(Rejection::Malformed(_))));
    }

    proptest! {
        #[test]
        fn no_bytes_make_the_parser_panic(body in proptest::collection::vec(any::<u8>(), 0..200)) {
            let _ = parse(&body);
        }

        #[test]
        fn no_json_like_text_makes_the_parser_panic(body in r#"[\[\]{}",:0-9eE+. \\a-c-]{0,60}"#) {
            let _ = parse(body.as_bytes());
            let _ = stopped_at(body.as_bytes());
        }
    }
}
