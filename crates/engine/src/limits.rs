//! Limits of the size of a request, and the refusals of larger requests.

use crate::rejection::{FieldError, Rejection};

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

/// Refuses bodies with too many values before they are parsed, because a parsed value takes much more memory than its
/// text. The number of commas stands for the number of values. A point with a normal and a tangent has twelve values:
/// three arrays of three numbers each. The limit leaves a margin.
///
/// # Errors
/// Returns [`Rejection::TooLarge`].
pub fn refuse_too_many_values(body: &[u8], limits: &Limits) -> Result<(), Rejection> {
    let max_values = limits.points.saturating_mul(16).saturating_add(10_000);
    if body.iter().filter(|&&byte| byte == b',').count() <= max_values {
        return Ok(());
    }
    let detail = format!("has more values than a request of {} points can have", limits.points);
    Err(Rejection::TooLarge(vec![FieldError::new("", detail)]))
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
