//! Energies of line elements that depend on each segment's length alone.
//!
//! With the segment from a to b, L = |b - a|, t = (b - a) / L and the energy φ(L) of one segment:
//!
//! ```text
//! ∂E/∂b = φ' t = -∂E/∂a
//! ∂²E/∂b² = ∂²E/∂a² = -∂²E/∂a∂b = φ'' t tᵀ + (φ' / L) (I - t tᵀ)
//! ```
//!
//! The second line is the tangent stiffness of a truss element: its material part and its geometric part. Sources:
//! Schek, *The force density method for form finding*, 1974, for a constant φ' / L; any text on cable structures for
//! the rest.

use super::Term;
use glam::DMat3;
use plateau_mesh::DVec3;

/// The energy φ of a segment, its force φ' and its stiffness φ'', all at one length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// φ(L).
    pub energy: f64,
    /// φ'(L), the tension in the segment.
    pub force: f64,
    /// φ''(L).
    pub stiffness: f64,
}

/// The length of a segment (never zero) and the unit vector from its first end to the second.
fn along([a, b]: [u32; 2], at: &[DVec3]) -> (f64, DVec3) {
    let vector = at[b as usize] - at[a as usize];
    let length = vector.length().max(f64::MIN_POSITIVE);
    (length, vector / length)
}

/// The length of a segment.
#[must_use]
pub fn length(segment: [u32; 2], at: &[DVec3]) -> f64 {
    along(segment, at).0
}

/// Adds the gradient of a sum of segment energies. `stretch(k, L)` gives the energy of segment k at the length L.
pub fn add_gradient(
    segments: &[[u32; 2]],
    at: &[DVec3],
    gradient: &mut [DVec3],
    stretch: impl Fn(usize, f64) -> Stretch,
) {
    for (k, &segment) in segments.iter().enumerate() {
        let (length, unit) = along(segment, at);
        let force = stretch(k, length).force * unit;
        gradient[segment[0] as usize] -= force;
        gradient[segment[1] as usize] += force;
    }
}

/// Adds the second derivative of a sum of segment energies. The parts with a positive stiffness or tension are
/// multiplied by `1 + shift`.
pub fn add_second_derivative(
    segments: &[[u32; 2]],
    at: &[DVec3],
    shift: f64,
    add: &mut dyn FnMut(u32, u32, DMat3),
    stretch: impl Fn(usize, f64) -> Stretch,
) {
    let raised = |coefficient: f64| if coefficient > 0.0 { (1.0 + shift) * coefficient } else { coefficient };
    for (k, &segment) in segments.iter().enumerate() {
        let (length, unit) = along(segment, at);
        let Stretch { force, stiffness, .. } = stretch(k, length);
        let along = DMat3::from_cols(unit * unit.x, unit * unit.y, unit * unit.z);
        let block = along * raised(stiffness) + (DMat3::IDENTITY - along) * raised(force / length);
        let [a, b] = segment;
        add(a, a, block);
        add(b, b, block);
        add(a, b, -block);
        add(b, a, -block);
    }
}

/// Adds half of each segment's tension times its length to both ends of the segment. `force(k, L)` is the tension of
/// segment k at the length L; compression counts as 0.
pub fn add_shares(segments: &[[u32; 2]], at: &[DVec3], shares: &mut [f64], force: impl Fn(usize, f64) -> f64) {
    for (k, &segment) in segments.iter().enumerate() {
        let length = length(segment, at);
        let half = 0.5 * force(k, length).max(0.0) * length;
        segment.into_iter().for_each(|v| shares[v as usize] += half);
    }
}

/// E = T Σ L: line elements of one constant tension, such as a cable of given force. With T = 1 the energy is the total
/// length.
#[derive(Clone, Debug, PartialEq)]
pub struct Length {
    /// Pairs of vertices.
    pub segments: Vec<[u32; 2]>,
    /// T, a force. It has the unit of the surface tension times a length.
    pub tension: f64,
}

impl Length {
    fn stretch(&self, length: f64) -> Stretch {
        Stretch { energy: self.tension * length, force: self.tension, stiffness: 0.0 }
    }
}

impl Term for Length {
    fn value(&self, at: &[DVec3]) -> f64 {
        self.segments.iter().map(|&segment| self.stretch(length(segment, at)).energy).sum()
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        add_gradient(&self.segments, at, gradient, |_, length| self.stretch(length));
    }

    fn add_second_derivative(&self, at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        add_second_derivative(&self.segments, at, shift, add, |_, length| self.stretch(length));
    }

    // The springs bound the length from above because the square root is concave: ℓ ≤ ½ (ℓ² / ℓ_k + ℓ_k) with the
    // present length ℓ_k. A negative tension gives negative springs. A constraint on a length multiplies them by its
    // multiplier, which may make them positive.
    fn visit_springs(&self, at: &[DVec3], visit: &mut dyn FnMut(u32, u32, f64)) {
        self.segments.iter().for_each(|&segment| visit(segment[0], segment[1], self.tension / length(segment, at)));
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.segments.iter().for_each(|segment| visit(segment));
    }

    fn add_shares(&self, at: &[DVec3], shares: &mut [f64]) {
        add_shares(&self.segments, at, shares, |_, _| self.tension);
    }
}
