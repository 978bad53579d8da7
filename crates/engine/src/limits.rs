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

/// Refuses bodies with too many values, lists or objects before they are parsed, because a parsed value takes much more
/// memory than its text. The number of commas stands for the number of values. A point with a normal and a tangent has
/// twelve values: three lists of three numbers each. The limit leaves a margin.
///
/// # Errors
/// Returns [`Rejection::TooLarge`].
pub fn refuse_too_many_values(body: &[u8], limits: &Limits) -> Result<(), Rejection> {
    let max_values = limits.points.saturating_mul(16).saturating_add(10_000);
    let count = |wanted: u8| body.iter().filter(|&&byte| byte == wanted).count();
    if count(b',') > max_values || count(b'[') > max_values / 3 {
        let detail = format!("has more values than a request of {} points can have", limits.points);
        return Err(Rejection::TooLarge(vec![FieldError::new("", detail)]));
    }
    if Contents::of(body).typed_bytes() > body.len().saturating_mul(TYPED_PER_BYTE).max(SMALL_VALUES_BYTES) {
        let detail = "has more values, lists or objects than this server can look at at once; send fewer";
        return Err(Rejection::TooLarge(vec![FieldError::new("", detail)]));
    }
    Ok(())
}

/// Memory that the values of any body may take, by estimate, in bytes.
const SMALL_VALUES_BYTES: usize = 32 << 20;
/// Memory that the types that a large body is read into may take, by estimate, as a multiple of the body's length. With
/// the body itself it is eight times the length.
const TYPED_PER_BYTE: usize = 7;
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

/// Returns the memory of the JSON values of a body, in bytes.
fn values_bytes(body: &[u8]) -> usize {
    Contents::of(body).values_bytes()
}

/// Numbers of the parts of a body's text. The body need not be valid JSON.
#[derive(Debug, Default)]
struct Contents {
    /// Lists, objects, and elements and members except the first of each.
    values: usize,
    members: usize,
    objects: usize,
    /// Lists in lists.
    inner_lists: usize,
    /// Lists that do not begin with a number or a word such as null.
    outer_lists: usize,
    texts: usize,
    text_bytes: usize,
}

impl Contents {
    fn of(body: &[u8]) -> Self {
        let mut counts = Self { values: 1, ..Self::default() };
        let (mut at, mut before) = (0, b' ');
        while at < body.len() {
            let byte = body[at];
            match byte {
                b',' => counts.values += 1,
                b'{' => {
                    counts.values += 1;
                    counts.objects += 1;
                }
                b'[' => {
                    counts.values += 1;
                    counts.inner_lists += usize::from(before != b':');
                    let first = body[at + 1..].iter().find(|byte| !byte.is_ascii_whitespace());
                    counts.outer_lists += usize::from(first.is_none_or(|byte| b"[]{}\"".contains(byte)));
                }
                b':' => counts.members += 1,
                b'"' => {
                    counts.texts += 1;
                    let start = at + 1;
                    at = start;
                    while at < body.len() && body[at] != b'"' {
                        at += if body[at] == b'\\' { 2 } else { 1 };
                    }
                    counts.text_bytes += at.min(body.len()) - start;
                }
                _ => {}
            }
            if !byte.is_ascii_whitespace() {
                before = byte;
            }
            at += 1;
        }
        counts
    }

    /// Estimates the memory of the JSON values, in bytes.
    fn values_bytes(&self) -> usize {
        /// An element of a list, and half of it for the list's spare capacity.
        const ELEMENT: usize = 48;
        /// A member of an object besides its name: its part of a node of the map, which is half full if the names are
        /// sorted.
        const MEMBER: usize = 120;
        /// The least allocation of a text.
        const TEXT: usize = 16;
        self.values.saturating_sub(self.members) * ELEMENT + self.members * MEMBER + self.texts * TEXT + self.text_bytes
    }

    /// Bounds the memory of the types that the body is read into, in bytes. A vector that has just grown takes up to
    /// three times the memory of its elements: twice for its capacity, and once for the elements before they were moved.
    fn typed_bytes(&self) -> usize {
        /// A number in a vector. The three numbers of a point are the point.
        const NUMBER: usize = 3 * 8;
        /// A list of numbers in a list takes this besides the numbers, because the triangles of a mesh are read as one
        /// type and kept as another.
        const INNER: usize = 16;
        /// A vector in a vector.
        const VECTOR: usize = 24;
        /// The fourth point of a vector, whose least capacity is four. `NUMBER` counts a single point three times.
        const FOURTH: usize = 24;
        /// The largest struct of which a request may have many is the cable of a net.
        const OBJECT: usize = 120;
        let numbers = self.values.saturating_sub(self.members + self.objects + self.inner_lists);
        let lists = grown(self.outer_lists) * VECTOR + self.outer_lists * FOURTH;
        (numbers + self.texts) * NUMBER
            + self.inner_lists.saturating_sub(self.outer_lists) * INNER
            + lists
            + grown(self.objects) * OBJECT
            + self.text_bytes
    }
}

/// Returns the number of elements for which vectors with this number of elements have memory while they grow. One vector
/// has a power of two, and half of that for the elements before they were moved. Many small vectors have up to twice their
/// elements.
fn grown(elements: usize) -> usize {
    (2 * elements).max(elements.next_power_of_two() / 2 * 3)
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

    /// The most compact bodies that people send, with as many points as are allowed.
    #[test]
    fn dense_bodies_that_people_send_may_be_read_and_vectors_of_small_structs_may_not() {
        let body = |start: &str, parts: &[(&str, usize)]| {
            let lists: Vec<String> = parts.iter().map(|(part, count)| format!("[{}]", part.repeat(*count))).collect();
            format!("{start}{}", lists.join(","))
        };
        let may = |body: &str| refuse_too_many_values(body.as_bytes(), &LIMITS).is_ok();
        let with_normals =
            [("[12.345,67.89,0.5],", 200_000), ("[0.6,0.8,0.1],", 200_000), ("[0.6,-0.8,0.1],", 200_000)];
        assert!(may(&body("", &with_normals)));
        let mesh = [("[12.345,67.89,0.5],", 100_000), ("[123456,123457,123458],", 200_000)];
        assert!(may(&body("", &mesh)), "a mesh with its triangles");
        let net = [
            ("[12.3456,7.891,0.5],", 100_000),
            ("[123456,123457],", 150_000),
            (r#"{"edges":[123456],"force":12.5},"#, 100_000),
        ];
        assert!(may(&body("", &net)), "a net with a cable for each edge");
        let point = r#"{"type":"Rhino.Geometry.Point3d","data":"{\"X\":0.0,\"Y\":0.0,\"Z\":0.0}"},"#;
        assert!(may(&body("", &[(point, 200_000)])), "points of Hops");
        for dense in ["{},", "[[0,0,0]],", "[0,0,0],", "{\"a\":1},"] {
            assert!(!may(&dense.repeat(8_000_000 / dense.len())), "{dense}");
            assert!(may(&dense.repeat(300_000 / dense.len())), "{dense} in a small body");
        }
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
