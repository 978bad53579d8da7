//! The residual: how far a body is from equilibrium. The same function ends Newton's iteration and is reported.
//!
//! At a vertex of a film the residual is the mean curvature times the body's radius R: |g·n| R / (2 A_h), with the
//! energy's gradient g, the unit normal n and the vertex's share A_h of tension times area. In general the part of g
//! along all directions of the vertex takes the place of g·n, and A_h is a share of tension times size. On a curve
//! where sheets end or meet, the forces that must balance are σ per length, so the share is at least σ ℓ R / 2, with ℓ
//! the length of the curve that belongs to the vertex; the residual there is the unbalanced part of the sheets'
//! tension.

/// |force| / (2 share), in 1/unit: mean curvature, for a film. A vertex whose whole ring has no area is as far from
/// equilibrium as can be.
pub(crate) fn curvature(force: f64, share: f64) -> f64 {
    if share > 0.0 { force.abs() / (2.0 * share) } else { f64::MAX.sqrt() }
}

/// The largest [`curvature`] of pairs (force, share), times `radius`; 0 without pairs, infinite if one is not a number.
pub(crate) fn residual(pairs: impl Iterator<Item = (f64, f64)>, radius: f64) -> f64 {
    let largest = pairs.fold(0.0, |max: f64, (force, share)| {
        let curvature = curvature(force, share);
        if curvature.is_nan() { f64::INFINITY } else { max.max(curvature) }
    });
    largest * radius
}
