//! The residual: how far a body is from equilibrium. The same figure ends Newton's iteration and is reported.
//!
//! At a vertex inside a film the residual is the mean curvature times the body's radius R: |g·n| R / (2 A_h). Here g is
//! the gradient of the energy, n the unit normal and A_h the vertex's share of tension times area. At other vertices,
//! the part of g along all directions in which the vertex may move replaces g·n, and A_h is a share of tension times
//! size. On a curve where sheets end or meet, the forces that must balance are σ per length. The share there is
//! therefore at least σ ℓ R / 2, where ℓ is the length of the curve that belongs to the vertex, and the residual is the
//! unbalanced fraction of the sheets' tension.

/// Returns |force| / (2 share), in 1/unit; for a film this is the mean curvature. If no triangle around a vertex has
/// any area, the share is 0 and the result is a very large number.
pub fn curvature(force: f64, share: f64) -> f64 {
    if share > 0.0 { force.abs() / (2.0 * share) } else { f64::MAX.sqrt() }
}

/// The largest [`curvature`] of the pairs (force, share), times `radius`. It is 0 if there are no pairs, and infinite
/// if a curvature is NaN.
pub fn residual(pairs: impl Iterator<Item = (f64, f64)>, radius: f64) -> f64 {
    let largest = pairs.fold(0.0, |max: f64, (force, share)| {
        let curvature = curvature(force, share);
        if curvature.is_nan() { f64::INFINITY } else { max.max(curvature) }
    });
    largest * radius
}
