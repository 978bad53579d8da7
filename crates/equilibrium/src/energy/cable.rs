//! A cable: a chain of segments that carry the same force. Only the cable's own weight makes the force vary along the
//! chain.
//!
//! L is the length of the whole cable, ℓ_k the length of segment k, z_k the height of its middle above the origin, and
//! w the weight per length of the shape in equilibrium:
//!
//! ```text
//! E = Φ(L) + w Σ ℓ_k z_k          force in segment k:  Φ'(L) + w z_k
//!
//! force of a given size     Φ = T L                              Φ' = T
//! force density             Φ = (q / 2) L²                       Φ' = q L
//! elastic                   Φ = (EA / 2 L0) (L - L0)₊²           Φ' = EA (L / L0 - 1)₊
//!
//! ∂²E = Φ'(L) ∂²L + Φ''(L) ∂L ∂Lᵀ + …
//! ```
//!
//! The force depends on the whole length, so the stiffness Φ'' couples all vertices of the cable. It gives the second
//! derivative a part of rank one ([`Term::visit_rank_one_parts`]).
//!
//! The potential energy of a heavy cable is its weight per *found* length times the height. This makes the force grow
//! with the height, T = τ + w z, and the cable hangs in a catenary (any text on cables). If the mean force, the sag or
//! the horizontal component of the force is given instead of the length, no term of the energy determines the constant
//! τ. It is then the multiplier of the length, and an [`Equation`] determines it.
//!
//! Sources: Schek, *The force density method for form finding* (1974), for the force densities; Hooke's law with
//! engineering strain for the elastic cable. The derivatives are those of [`super::length`].

use super::length::{self, Stretch};
use super::{Condition, Term};
use glam::DMat3;
use plateau_mesh::DVec3;

/// How the force of a cable depends on its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// The cable has no force of its own. A constraint keeps its length, and the force is the multiplier of this
    /// constraint.
    Multiplier,
    /// A force T that does not depend on the length.
    Force(f64),
    /// A force of q times the length of the whole cable.
    Density(f64),
    /// A force of EA (L / L0 - 1), zero where the cable is shorter than L0.
    Elastic {
        /// L0, the length of the whole cable without force.
        unstressed: f64,
        /// EA, a force.
        stiffness: f64,
    },
}

impl Law {
    /// Returns the energy Φ, the force Φ' and the stiffness Φ'' if the whole cable has the length `length`.
    #[must_use]
    pub fn at(self, length: f64) -> Stretch {
        match self {
            Self::Multiplier => Stretch { energy: 0.0, force: 0.0, stiffness: 0.0 },
            Self::Force(force) => Stretch { energy: force * length, force, stiffness: 0.0 },
            Self::Density(density) => {
                Stretch { energy: 0.5 * density * length * length, force: density * length, stiffness: density }
            }
            Self::Elastic { unstressed, stiffness } => {
                let (per_length, beyond) = (stiffness / unstressed, length - unstressed);
                if beyond > 0.0 {
                    let energy = 0.5 * per_length * beyond * beyond;
                    Stretch { energy, force: per_length * beyond, stiffness: per_length }
                } else {
                    Stretch { energy: 0.0, force: 0.0, stiffness: 0.0 }
                }
            }
        }
    }
}

/// The energy of one cable.
#[derive(Clone, Debug, PartialEq)]
pub struct Cable {
    /// The segments, in order from the first end to the last.
    pub segments: Vec<[u32; 2]>,
    /// How the force depends on the length.
    pub law: Law,
    /// w, a force per length; zero for a cable without weight.
    pub weight: f64,
    /// The unit vector that points up.
    pub up: DVec3,
}

impl Cable {
    /// A cable without weight.
    #[must_use]
    pub fn new(segments: Vec<[u32; 2]>, law: Law) -> Self {
        Self { segments, law, weight: 0.0, up: DVec3::Z }
    }

    /// Returns this cable with the weight `weight` per length.
    #[must_use]
    pub fn heavy(self, weight: f64, up: DVec3) -> Self {
        Self { weight, up, ..self }
    }

    /// The length of the whole cable.
    #[must_use]
    pub fn length(&self, at: &[DVec3]) -> f64 {
        self.segments.iter().map(|&segment| length::length(segment, at)).sum()
    }

    /// Returns the largest distance of the cable from the chord between its two ends. Next to the vertex farthest from
    /// the chord, the cable is followed by the parabola through this vertex and its two neighbours, because the
    /// vertices themselves miss the middle of a cable with an odd number n of segments: their sag is too small by 1 /
    /// n².
    #[must_use]
    pub fn sag(&self, at: &[DVec3]) -> f64 {
        self.crest(at).map_or(0.0, |crest| crest.height)
    }

    /// Returns the length of the horizontal part of the cable's unit tangent at its first end, extrapolated from the
    /// first two segments.
    #[must_use]
    pub fn level_part(&self, at: &[DVec3]) -> f64 {
        let parts = self.segments.iter().map(|&segment| across(segment, self.up, at).0);
        let weights = self.end_weights(at);
        parts.zip(weights).map(|(part, weight)| weight * part).sum()
    }

    /// The weights with which the values at the middles of the first two segments give the value at the first end. With
    /// the value of the first segment alone the error would be of the first order in the length of the segments. The
    /// second weight of a cable of one segment is not used.
    fn end_weights(&self, at: &[DVec3]) -> [f64; 2] {
        let [Some(first), Some(second)] = [0, 1].map(|k| self.segments.get(k)) else { return [1.0, 0.0] };
        let [first, second] = [first, second].map(|&segment| length::length(segment, at));
        let share = first / (first + second).max(f64::MIN_POSITIVE);
        [1.0 + share, -share]
    }

    /// Returns the force in segment k, without the multiplier of a constraint on the length.
    #[must_use]
    pub fn force(&self, k: usize, at: &[DVec3]) -> f64 {
        self.law.at(self.length(at)).force + self.weight * self.height(k, at)
    }

    /// The height of the middle of segment k above the origin.
    fn height(&self, k: usize, at: &[DVec3]) -> f64 {
        let [a, b] = self.segments[k];
        0.5 * (at[a as usize] + at[b as usize]).dot(self.up)
    }

    /// The mean height of the whole cable above the origin.
    #[must_use]
    pub fn mean_height(&self, at: &[DVec3]) -> f64 {
        let moment = |k: usize| length::length(self.segments[k], at) * self.height(k, at);
        (0..self.segments.len()).map(moment).sum::<f64>() / self.length(at).max(f64::MIN_POSITIVE)
    }

    /// Returns the point of the cable farthest from the chord between its two ends.
    fn crest(&self, at: &[DVec3]) -> Option<Crest> {
        let (&[first, _], &[_, last]) = (self.segments.first()?, self.segments.last()?);
        let start = at[first as usize];
        let span = at[last as usize] - start;
        let (chord, length) = (span.normalize_or_zero(), span.length());
        let from_chord = |vertex: u32| {
            let place = at[vertex as usize] - start;
            FromChord { vertex, along: place.dot(chord), distance: place.reject_from_normalized(chord) }
        };
        let farthest = |a: (usize, FromChord), b: (usize, FromChord)| {
            // Of several vertices at the same distance the first is taken.
            if a.1.distance.length() < b.1.distance.length() { b } else { a }
        };
        let vertices = self.segments.iter().map(|&[_, vertex]| from_chord(vertex)).enumerate();
        let (k, middle) = vertices.reduce(farthest)?;
        let before = from_chord(self.segments[k][0]);
        let after = self.segments.get(k + 1).map_or(middle, |&[_, vertex]| from_chord(vertex));
        let height = middle.distance.length();
        let at_vertex = Crest {
            height,
            chord,
            length,
            through: [before, middle, after],
            weights: [0.0, 1.0, 0.0],
            slopes: [0.0; 3],
        };
        let (h, g) = (middle.along - before.along, after.along - middle.along);
        let (rise, fall) = (height - before.distance.length(), after.distance.length() - height);
        // Newton's form of the parabola, with the origin at the middle vertex: height + slope t + curvature t².
        let slope = (rise / h * g + fall / g * h) / (h + g);
        let curvature = (fall / g - rise / h) / (h + g);
        if !(h > 0.0 && g > 0.0 && curvature < 0.0) {
            return Some(at_vertex);
        }
        let t = -slope / (2.0 * curvature);
        Some(Crest {
            height: height - slope * slope / (4.0 * curvature),
            weights: [t * (t - g) / (h * (h + g)), (t + h) * (g - t) / (h * g), t * (t + h) / (g * (h + g))],
            slopes: [slope - 2.0 * curvature * h, slope, slope + 2.0 * curvature * g],
            ..at_vertex
        })
    }

    fn stretch(&self, at: &[DVec3]) -> impl Fn(usize, f64) -> Stretch {
        let own = self.law.at(self.length(at)).force;
        move |k, _| Stretch { energy: 0.0, force: own + self.weight * self.height(k, at), stiffness: 0.0 }
    }
}

/// A vertex of a cable, seen from the chord between the cable's ends.
#[derive(Clone, Copy)]
struct FromChord {
    vertex: u32,
    /// Distance from the first end, measured along the chord.
    along: f64,
    /// The vector from the chord to the vertex.
    distance: DVec3,
}

/// The point of a cable farthest from the chord between its ends, on the parabola through three vertices.
struct Crest {
    height: f64,
    /// Unit vector and length of the chord.
    chord: DVec3,
    length: f64,
    through: [FromChord; 3],
    /// Lagrange's weights of the three vertices at the crest.
    weights: [f64; 3],
    /// The parabola's slope at each of the three vertices.
    slopes: [f64; 3],
}

impl Term for Cable {
    fn value(&self, at: &[DVec3]) -> f64 {
        let potential = |k: usize| length::length(self.segments[k], at) * self.height(k, at);
        let height: f64 = if self.weight == 0.0 { 0.0 } else { (0..self.segments.len()).map(potential).sum() };
        self.law.at(self.length(at)).energy + self.weight * height
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        length::add_gradient(&self.segments, at, gradient, self.stretch(at));
        if self.weight != 0.0 {
            for &segment in &self.segments {
                let half = 0.5 * self.weight * length::length(segment, at) * self.up;
                segment.into_iter().for_each(|v| gradient[v as usize] += half);
            }
        }
    }

    fn add_second_derivative(&self, at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        length::add_second_derivative(&self.segments, at, shift, add, self.stretch(at));
        if self.weight == 0.0 {
            return;
        }
        // The gradient consists of the parts w ℓ up / 2 and w z t, with the unit vector t of the segment. The blocks
        // here are the derivatives of the first by the length ℓ (∂ℓ/∂b = t = -∂ℓ/∂a), and of the second by the height
        // z.
        for &[a, b] in &self.segments {
            let unit = (at[b as usize] - at[a as usize]).normalize_or_zero();
            let half = 0.5 * self.weight * DMat3::from_cols(self.up * unit.x, self.up * unit.y, self.up * unit.z);
            let both = half + half.transpose();
            let turn = half.transpose() - half;
            add(a, a, -both);
            add(b, b, both);
            add(a, b, -turn);
            add(b, a, turn);
        }
    }

    fn visit_rank_one_parts(&self, at: &[DVec3], add: &mut dyn FnMut(f64, &[DVec3])) {
        let stiffness = self.law.at(self.length(at)).stiffness;
        if stiffness != 0.0 {
            let mut gradient = vec![DVec3::ZERO; at.len()];
            add_length_gradient(&self.segments, at, 1.0, &mut gradient);
            add(stiffness, &gradient);
        }
    }

    // The springs bound the energy from above. Φ(L) = T L is concave in L². For Φ = q L² / 2 the inequality of Cauchy
    // and Schwarz gives L² ≤ Σ ℓ² L_0 / ℓ_k, with the present lengths L_0 of the cable and ℓ_k of its segments.
    fn visit_springs(&self, at: &[DVec3], visit: &mut dyn FnMut(u32, u32, f64)) {
        for (k, &segment) in self.segments.iter().enumerate() {
            visit(segment[0], segment[1], (self.force(k, at) / length::length(segment, at)).max(0.0));
        }
    }

    fn has_unit_directions(&self) -> bool {
        self.up.is_normalized()
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.segments.iter().for_each(|segment| visit(segment));
    }

    fn add_shares(&self, at: &[DVec3], shares: &mut [f64]) {
        // For a heavy cable the weight sets the scale, because the force at the height of the origin may have any size.
        let total = self.length(at);
        let force = self.law.at(total).force.max(0.0) + self.weight * total;
        length::add_shares(&self.segments, at, shares, |_, _| force);
    }

    fn visit_forces(&self, at: &[DVec3], visit: &mut dyn FnMut(f64)) {
        let stretch = self.stretch(at);
        (0..self.segments.len()).for_each(|k| visit(stretch(k, 0.0).force));
    }
}

fn add_length_gradient(segments: &[[u32; 2]], at: &[DVec3], factor: f64, gradient: &mut [DVec3]) {
    length::add_gradient(segments, at, gradient, |_, _| Stretch { energy: 0.0, force: factor, stiffness: 0.0 });
}

/// The error of an elastic cable's force is measured relative to the force at this strain. Cables in built structures
/// have strains of 1e-4 to 1e-2.
const SMALL_STRAIN: f64 = 1e-4;

/// The equation that determines the multiplier τ of a cable's length, for a cable whose length is not given. The force
/// in segment k is τ + w z_k. The mean force is τ + w z̄, with the mean height z̄.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Equation {
    /// The mean force has this value.
    MeanForce(f64),
    /// The force at the first end has this value.
    EndTension(f64),
    /// The horizontal component of the force at the first end has this magnitude. It is extrapolated from those of the
    /// first two segments.
    HorizontalComponent(f64),
    /// The mean force divided by the length of the cable has this value.
    ForceDensity(f64),
    /// The mean force is EA (L / L0 - 1).
    Elastic {
        /// L0, the length of the whole cable without force.
        unstressed: f64,
        /// EA, a force.
        stiffness: f64,
    },
    /// The sag, which is the largest distance of the cable from the chord between its two ends, has this value.
    Sag(f64),
}

/// An [`Equation`] of one cable, whose law is [`Law::Multiplier`].
#[derive(Clone, Debug, PartialEq)]
pub struct CableCondition {
    /// The cable.
    pub cable: Cable,
    /// The equation that the cable has to satisfy.
    pub equation: Equation,
}

impl CableCondition {
    /// Adds `factor` times the derivative of the mean height, ∂z̄ = Σ ((z_k - z̄) ∂ℓ_k + ℓ_k ∂z_k) / L, to `gradient`.
    fn add_mean_height(&self, at: &[DVec3], factor: f64, gradient: &mut [DVec3]) {
        let Cable { segments, up, .. } = &self.cable;
        let (mean, total) = (self.cable.mean_height(at), self.cable.length(at).max(f64::MIN_POSITIVE));
        let factor = factor / total;
        let rise =
            |k: usize, _| Stretch { energy: 0.0, force: factor * (self.cable.height(k, at) - mean), stiffness: 0.0 };
        length::add_gradient(segments, at, gradient, rise);
        for &segment in segments {
            let half = 0.5 * factor * length::length(segment, at) * *up;
            segment.into_iter().for_each(|v| gradient[v as usize] += half);
        }
    }
}

impl Condition for CableCondition {
    fn value(&self, at: &[DVec3], multiplier: f64) -> (f64, f64) {
        let cable = &self.cable;
        let mean = || multiplier + cable.weight * cable.mean_height(at);
        match self.equation {
            Equation::MeanForce(force) => (mean() - force, 1.0),
            Equation::EndTension(force) => {
                let height = cable.segments.first().map_or(0.0, |&[first, _]| at[first as usize].dot(cable.up));
                (multiplier + cable.weight * height - force, 1.0)
            }
            Equation::HorizontalComponent(force) => {
                let (mut own, mut by_multiplier) = (0.0, 0.0);
                for (k, (&segment, weight)) in cable.segments.iter().zip(cable.end_weights(at)).enumerate() {
                    let across = across(segment, cable.up, at).0;
                    own += weight * across * (cable.force(k, at) + multiplier);
                    by_multiplier += weight * across;
                }
                (own - force, by_multiplier)
            }
            Equation::ForceDensity(density) => (mean() - density * cable.length(at), 1.0),
            Equation::Elastic { unstressed, stiffness } => {
                (mean() - stiffness * (cable.length(at) / unstressed - 1.0), 1.0)
            }
            Equation::Sag(sag) => (cable.sag(at) - sag, 0.0),
        }
    }

    fn add_gradient(&self, at: &[DVec3], multiplier: f64, gradient: &mut [DVec3]) {
        let cable = &self.cable;
        let (Some(&[first, second]), Some(&[_, last])) = (cable.segments.first(), cable.segments.last()) else {
            return;
        };
        match self.equation {
            Equation::MeanForce(_) => self.add_mean_height(at, cable.weight, gradient),
            Equation::EndTension(_) => gradient[first as usize] += cable.weight * cable.up,
            Equation::HorizontalComponent(_) => {
                let mut components = [0.0; 2];
                for (k, (&segment, weight)) in cable.segments.iter().zip(cable.end_weights(at)).enumerate() {
                    let (across, derivative) = across(segment, cable.up, at);
                    let force = multiplier + cable.weight * cable.height(k, at);
                    let half = 0.5 * cable.weight * across * cable.up;
                    gradient[segment[0] as usize] += weight * (half - force * derivative);
                    gradient[segment[1] as usize] += weight * (half + force * derivative);
                    components[k] = force * across;
                }
                let [_, Some(&next)] = [0, 1].map(|k| cable.segments.get(k)) else { return };
                // The weights are 1 + s and -s, with s = ℓ0 / (ℓ0 + ℓ1).
                let lengths = [[first, second], next].map(|segment| length::length(segment, at));
                let by_share = (components[0] - components[1]) / (lengths[0] + lengths[1]).powi(2);
                for (segment, by_length) in [([first, second], lengths[1]), (next, -lengths[0])] {
                    add_length_gradient(&[segment], at, by_share * by_length, gradient);
                }
            }
            Equation::ForceDensity(density) => {
                self.add_mean_height(at, cable.weight, gradient);
                add_length_gradient(&cable.segments, at, -density, gradient);
            }
            Equation::Elastic { unstressed, stiffness } => {
                self.add_mean_height(at, cable.weight, gradient);
                add_length_gradient(&cable.segments, at, -stiffness / unstressed, gradient);
            }
            Equation::Sag(_) => {
                let Some(crest) = cable.crest(at) else { return };
                // The parabola is level at its crest, so only the change of its height there counts: Σ w (∂y - y' ∂x)
                // over the three vertices, with the distance y and the place x along the chord.
                for ((place, weight), slope) in crest.through.iter().zip(crest.weights).zip(crest.slopes) {
                    let share = place.along / crest.length.max(f64::MIN_POSITIVE);
                    let outward = weight * place.distance.normalize_or_zero();
                    let along = weight * slope * crest.chord;
                    let turn = weight * slope / crest.length.max(f64::MIN_POSITIVE) * place.distance;
                    gradient[place.vertex as usize] += outward - along;
                    gradient[first as usize] += along + turn - (1.0 - share) * outward;
                    gradient[last as usize] -= turn + share * outward;
                }
            }
        }
    }

    fn scale(&self, at: &[DVec3]) -> f64 {
        match self.equation {
            Equation::MeanForce(value)
            | Equation::EndTension(value)
            | Equation::HorizontalComponent(value)
            | Equation::Sag(value) => value,
            Equation::ForceDensity(density) => density * self.cable.length(at),
            Equation::Elastic { stiffness, .. } => SMALL_STRAIN * stiffness,
        }
    }
}

/// Returns the length of the horizontal part of a segment's unit vector, from 0 to 1, and its derivative by the second
/// end.
fn across([a, b]: [u32; 2], up: DVec3, at: &[DVec3]) -> (f64, DVec3) {
    let edge = at[b as usize] - at[a as usize];
    let (length, level) = (edge.length().max(f64::MIN_POSITIVE), edge.reject_from_normalized(up));
    let across = level.length() / length;
    (across, (level.normalize_or_zero() - across * edge / length) / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::finite_differences::{check, patch};

    const UP: DVec3 = DVec3::new(0.6, 0.0, 0.8);

    fn segments() -> Vec<[u32; 2]> {
        vec![[0, 1], [1, 2], [2, 6], [6, 7]]
    }

    #[test]
    fn the_derivatives_of_every_law_agree_with_finite_differences_light_and_heavy() {
        let (vertices, _) = patch();
        let laws =
            [Law::Multiplier, Law::Force(2.5), Law::Density(0.7), Law::Elastic { unstressed: 3.1, stiffness: 4.0 }];
        for law in laws {
            for weight in [0.0, 0.9] {
                check(&Cable::new(segments(), law).heavy(weight, UP), &vertices, 1e-8);
            }
        }
    }

    #[test]
    fn the_derivatives_of_every_equation_agree_with_finite_differences() {
        let (vertices, _) = patch();
        let cable = Cable::new(segments(), Law::Multiplier).heavy(0.9, UP);
        let equations = [
            Equation::MeanForce(2.0),
            Equation::EndTension(2.0),
            Equation::HorizontalComponent(2.0),
            Equation::ForceDensity(0.7),
            Equation::Elastic { unstressed: 3.1, stiffness: 4.0 },
            Equation::Sag(0.4),
        ];
        for equation in equations {
            let condition = CableCondition { cable: cable.clone(), equation };
            let (multiplier, step) = (1.3, 1e-6);
            let mut gradient = vec![DVec3::ZERO; vertices.len()];
            condition.add_gradient(&vertices, multiplier, &mut gradient);
            let value = |at: &[DVec3], multiplier: f64| condition.value(at, multiplier).0;
            for v in 0..vertices.len() {
                for axis in 0..3 {
                    let moved = |step: f64| {
                        let mut at = vertices.clone();
                        at[v][axis] += step;
                        value(&at, multiplier)
                    };
                    let slope = (moved(step) - moved(-step)) / (2.0 * step);
                    assert!((slope - gradient[v][axis]).abs() < 1e-8, "{equation:?} {v} {axis}");
                }
            }
            let slope = (value(&vertices, multiplier + step) - value(&vertices, multiplier - step)) / (2.0 * step);
            assert!((slope - condition.value(&vertices, multiplier).1).abs() < 1e-8, "{equation:?}");
        }
    }

    #[test]
    fn the_sag_of_an_arc_does_not_depend_on_the_parity_of_its_segments() {
        for count in 4..=9u32 {
            // An arc of radius 1 over 60°.
            let point = |k: u32| {
                let angle = std::f64::consts::FRAC_PI_3 * (f64::from(k) / f64::from(count) - 0.5);
                DVec3::new(libm::sin(angle), libm::cos(angle), 0.0)
            };
            let at: Vec<DVec3> = (0..=count).map(point).collect();
            let cable = Cable::new((0..count).map(|k| [k, k + 1]).collect(), Law::Multiplier);
            let sag = 1.0 - 0.75f64.sqrt();
            assert!((cable.sag(&at) / sag - 1.0).abs() < 2e-3, "{count} segments: {} for {sag}", cable.sag(&at));
        }
    }

    #[test]
    fn a_slack_cable_has_no_force_and_a_taut_one_the_same_force_in_every_segment() {
        let (vertices, _) = patch();
        let segments = vec![[0, 1], [1, 2], [2, 6]];
        let taut = Cable::new(segments.clone(), Law::Elastic { unstressed: 2.0, stiffness: 5.0 });
        let force = 5.0 * (taut.length(&vertices) / 2.0 - 1.0);
        taut.visit_forces(&vertices, &mut |found| assert!((found - force).abs() < 1e-14));
        let slack = Cable::new(segments, Law::Elastic { unstressed: 9.0, stiffness: 5.0 });
        check(&slack, &vertices, 1e-8);
        slack.visit_forces(&vertices, &mut |found| assert_eq!(found, 0.0));
    }
}
