//! The options of a search for a lower bound, and the check of its arguments.

use plateau_mesh::error::InputError;
use plateau_mesh::{DVec3, Error, Mesh, Place};

/// The options of [`certify`](crate::certify). They are made by changing the defaults:
///
/// ```
/// let options = plateau_lower_bound::Options::default().with_gap(0.01).with_seconds(0.2);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// The search ends when the film's area exceeds the bound by at most this fraction of the bound. Default: 0.005.
    pub gap: f64,
    /// The budget in nominal seconds of one core, which fixed rates convert to work. At most [`MOST_SECONDS`] are used.
    /// Default: 2.
    pub seconds: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self { gap: 0.005, seconds: 2.0 }
    }
}

impl Options {
    /// These options with another gap.
    #[must_use]
    pub fn with_gap(self, gap: f64) -> Self {
        Self { gap, ..self }
    }

    /// These options with another budget, in nominal seconds.
    #[must_use]
    pub fn with_seconds(self, seconds: f64) -> Self {
        Self { seconds, ..self }
    }

    /// The part of the budget that is used, in nominal seconds.
    pub(super) fn budget_s(&self) -> f64 {
        self.seconds.min(MOST_SECONDS)
    }
}

/// Largest number of loops whose orientations are searched one by one from the start: six loops have 32 orientations.
/// With more loops the search begins with one bound for all orientations. It then fixes the direction of one loop after
/// the other in the search with the least bound.
pub(super) const MOST_DIRECTED: usize = 6;
/// Largest number of simultaneous searches. It bounds the memory and the size of the proof.
pub(super) const MOST_SEARCHES: usize = 64;
/// Largest budget that is used, in nominal seconds.
pub const MOST_SECONDS: f64 = 600.0;

/// Checks the arguments of [`certify`](crate::certify) before any work. The time is linear in their size.
///
/// # Errors
/// The [`Error::Input`] that [`certify`](crate::certify) would return: if there is no loop, a loop has fewer than three
/// points, a coordinate is not a finite number, a triangle names a vertex that the film does not have, or an option is
/// negative or not finite.
pub fn check(loops: &[Vec<DVec3>], film: &Mesh, options: &Options) -> Result<(), Error> {
    let mut errors = Vec::new();
    if loops.is_empty() {
        errors.push(InputError::new(Place::field("loops"), "needs one closed polygon or more"));
    }
    for (k, points) in loops.iter().enumerate() {
        let place = || Place::field("loops").at(k);
        if points.len() < 3 {
            let detail = format!("has {} points, and a closed polygon has three or more", points.len());
            errors.push(InputError::new(place(), detail));
        }
        if let Some(point) = points.iter().position(|point| !point.is_finite()) {
            errors.push(InputError::new(place().at(point), not_finite(points[point])));
        }
    }
    if let Some(vertex) = film.vertices.iter().position(|point| !point.is_finite()) {
        let place = Place::field("film").then("vertices").at(vertex);
        errors.push(InputError::new(place, not_finite(film.vertices[vertex])));
    }
    let count = film.vertices.len();
    let is_missing = |triangle: &[u32; 3]| triangle.iter().any(|&vertex| vertex as usize >= count);
    if let Some(triangle) = film.triangles.iter().position(is_missing) {
        let detail = format!("has the vertices {:?}, and the film has {count}", film.triangles[triangle]);
        errors.push(InputError::new(Place::field("film").then("triangles").at(triangle), detail));
    }
    for (name, value) in [("gap", options.gap), ("seconds", options.seconds)] {
        if !(value.is_finite() && value >= 0.0) {
            let detail = format!("is {value}, and must be a finite number, not negative");
            errors.push(InputError::new(Place::field("options").then(name), detail));
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

fn not_finite(point: DVec3) -> String {
    format!("is ({}, {}, {}), and every coordinate must be a finite number", point.x, point.y, point.z)
}

/// Estimate of the memory that [`certify`](crate::certify) takes with a gap of 0, in bytes. The largest factor grows
/// with a power of the time below 1, because a step costs the square of its entries for each row. Measured on four
/// boundaries: 41 to 55 MB after 1 s, 127 to 142 MB after 3 s, 267 to 287 MB after 10 s, and 594 MB after 30 s.
#[must_use]
pub fn memory_bytes(loops: usize, options: &Options) -> u64 {
    let orientations = if loops <= MOST_DIRECTED { 1 << loops.saturating_sub(1) } else { MOST_SEARCHES as u64 };
    // A mesh of the first size takes 8 MB; the largest 1.2 GB, most of it the factor.
    let largest = (libm::pow(options.seconds.clamp(0.0, MOST_SECONDS), 0.75) * 60e6).min(1.2e9) as u64;
    orientations * 8_000_000 + 5_000_000 + largest
}
