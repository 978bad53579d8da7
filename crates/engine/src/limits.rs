//! Limits of the size of a request, and the refusals of larger requests.

use plateau_strict_json::rejection::{FieldError, Rejection};

/// Limits of one request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Number of points that all polylines of a request together may have.
    pub points: usize,
    /// Number of triangles that a minimal surface or a uniform mesh may have.
    pub triangles: usize,
    /// Number of cells that the grids of all strips of a ruled surface together may have.
    pub grid_cells: u64,
    /// Largest `max_iterations` that a request may ask for.
    pub iterations: u32,
    /// Number of bytes of memory that solving one request may take, by estimate.
    pub memory_bytes: u64,
}

/// Refuses bodies with too many values or lists before they are parsed, because a parsed value takes much more memory
/// than its text. The number of commas stands for the number of values. A point with a normal and a tangent has twelve
/// values: three lists of three numbers each. The limit leaves a margin.
///
/// # Errors
/// Returns [`Rejection::TooLarge`].
pub fn refuse_too_many_values(body: &[u8], limits: &Limits) -> Result<(), Rejection> {
    let max_values = limits.points.saturating_mul(16).saturating_add(10_000);
    let count = |wanted: u8| body.iter().filter(|&&byte| byte == wanted).count();
    if count(b',') <= max_values && count(b'[') <= max_values / 3 {
        return Ok(());
    }
    let detail = format!("has more values than a request of {} points can have", limits.points);
    Err(Rejection::TooLarge(vec![FieldError::new("", detail)]))
}

/// Memory that the JSON values of any body may take, by estimate, in bytes.
const SMALL_VALUES_BYTES: usize = 32 << 20;
/// Memory that the JSON values of a large body may take, by estimate, as a multiple of the body's length. Lists take up
/// to half as much again while they grow, and the request is made from the values.
const VALUES_PER_BYTE: usize = 4;

/// Returns whether a body may be parsed into JSON values. They then take a few times the memory of their text. Bodies
/// with many short values or names would take up to fifty times as much.
#[must_use]
pub fn may_be_values(body: &[u8]) -> bool {
    values_bytes(body) <= body.len().saturating_mul(VALUES_PER_BYTE).max(SMALL_VALUES_BYTES)
}

/// Same as [`may_be_values`], as a check.
///
/// # Errors
/// Returns [`Rejection::TooLarge`].
pub fn refuse_too_much_as_values(body: &[u8]) -> Result<(), Rejection> {
    if may_be_values(body) {
        return Ok(());
    }
    let detail = "has more values or names than this server can look at at once; send fewer";
    Err(Rejection::TooLarge(vec![FieldError::new("", detail)]))
}

/// Estimates the memory of the JSON values of a body from its text, in bytes. The body need not be valid JSON.
fn values_bytes(body: &[u8]) -> usize {
    /// An element of a list, and half of it for the list's spare capacity.
    const ELEMENT: usize = 48;
    /// A member of an object besides its name: its part of a node of the map, which is half full if the names are
    /// sorted.
    const MEMBER: usize = 120;
    /// The least allocation of a text.
    const TEXT: usize = 16;
    let (mut values, mut members, mut texts, mut text_bytes) = (1_usize, 0_usize, 0_usize, 0_usize);
    let mut at = 0;
    while at < body.len() {
        match body[at] {
            b',' | b'[' | b'{' => values += 1,
            b':' => members += 1,
            b'"' => {
                texts += 1;
                let start = at + 1;
                at = start;
                while at < body.len() && body[at] != b'"' {
                    at += if body[at] == b'\\' { 2 } else { 1 };
                }
                text_bytes += at.min(body.len()) - start;
            }
            _ => {}
        }
        at += 1;
    }
    values.saturating_sub(members) * ELEMENT + members * MEMBER + texts * TEXT + text_bytes
}

/// Refuses a field with more than `most` entries. `what` is a plural noun for the entries, which the error contains.
///
/// # Errors
/// Returns [`Rejection::TooLarge`] at the field.
pub fn check_count(field: &str, count: usize, most: usize, what: &str) -> Result<(), Rejection> {
    if count > most {
        let detail = format!("has more {what} than are allowed ({most})");
        return Err(Rejection::TooLarge(vec![FieldError::new(field, detail)]));
    }
    Ok(())
}

/// Refuses a number above `most`.
///
/// # Errors
/// Returns [`Rejection::TooLarge`] at the field.
pub fn check_number(field: &str, number: Option<u32>, most: usize) -> Result<(), Rejection> {
    if number.is_some_and(|number| number as usize > most) {
        let detail = format!("is more than is allowed ({most})");
        return Err(Rejection::TooLarge(vec![FieldError::new(field, detail)]));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits = Limits { points: 200_000, triangles: 1, grid_cells: 1, iterations: 1, memory_bytes: 1 };

    #[test]
    fn lists_and_values_are_counted_before_the_parse() {
        assert!(refuse_too_many_values(&b"[[0,0,0],".repeat(200_000), &LIMITS).is_ok());
        assert!(refuse_too_many_values(&b"1,".repeat(4_000_000), &LIMITS).is_err());
        assert!(refuse_too_many_values(&b"[".repeat(2_000_000), &LIMITS).is_err());
    }

    #[test]
    fn long_coordinates_may_be_values_and_many_short_values_or_names_may_not() {
        let point = b"[-123.45678901234567,0.12345678901234567,98.765432109876543],";
        assert!(may_be_values(&point.repeat(400_000)));
        assert!(may_be_values(&b"[0,0,0],".repeat(10_000)), "small bodies may have any values");
        assert!(may_be_values(format!("\"{}\"", "a,[{:".repeat(5_000_000)).as_bytes()), "one text");
        for dense in ["1,", "[],", "{},", "\"a12345\":1,", "\"\",", "[[[[", "{\"a\":"] {
            assert!(!may_be_values(&dense.as_bytes().repeat(29_000_000 / dense.len())), "{dense}");
        }
    }
}
