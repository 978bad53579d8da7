//! A cable: segments in a row that carry one force, which varies along the cable only with the cable's own weight.
//!
//! With the length ℓ_k of segment k, its share s_k of the cable's length, the height z_k of its middle above the datum
//! and the weight w per length of the found shape:
//!
//! ```text
//! E = Σ φ_k(ℓ_k) + w ℓ_k z_k          force in segment k:  φ_k' + w z_k
//!
//! force of a given size     φ = T ℓ                              φ' = T
//! force density             φ = (q / 2 s) ℓ²                     φ' = q L  where ℓ = s L
//! elastic                   φ = (EA / 2 s L0) (ℓ - s L0)₊²       φ' = EA (L / L0 - 1)₊  where ℓ = s L
//! ```
//!
//! A heavy cable hangs in a catenary because the potential energy of its weight per *found* length makes its force grow
//! with the height: T = T0 + w z (any text on cables). The datum is the height at which the force is φ'. The shares, the
//! datum and, where the shape is given instead of the force, the force T are renewed between solves.
//!
//! Sources: Schek, *The force density method for form finding* (1974) for the densities; Hooke's law with engineering
//! strain for the elastic cable; derivatives by [`length`](super::length).

use super::Term;
use super::length::{self, Stretch};
use crate::DVec3;
use glam::DMat3;

/// How the force of a cable depends on its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
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

/// The quantity that the renewed force T of a cable under [`Law::Force`] is adjusted to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// The largest distance of the cable from the chord between its ends.
    Sag(f64),
    /// The part of the force at the first end that is across the vertical.
    HorizontalComponent(f64),
}

/// The height at which the force of a heavy cable is the force of its law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Datum {
    /// The mean height of the cable, so that the law gives the mean force.
    Mean,
    /// The height of the first end, so that the law gives the force there.
    FirstEnd,
}

/// The energy of one cable.
#[derive(Clone, Debug, PartialEq)]
pub struct Cable {
    /// The segments, in order from the first end to the last.
    pub segments: Vec<[u32; 2]>,
    /// How the force depends on the length.
    pub law: Law,
    /// What the force of [`Law::Force`] is adjusted to, if it is not given.
    pub target: Option<Target>,
    /// w, a force per length; zero for a cable without weight.
    pub weight: f64,
    /// The unit vector that points up.
    pub up: DVec3,
    /// Where the law's force acts.
    pub datum: Datum,
    shares: Vec<f64>,
    height: f64,
}

impl Cable {
    /// A cable whose shares and datum are those of the positions `at`.
    #[must_use]
    pub fn new(segments: Vec<[u32; 2]>, law: Law, at: &[DVec3]) -> Self {
        let shares = vec![0.0; segments.len()];
        let mut cable =
            Self { segments, law, target: None, weight: 0.0, up: DVec3::Z, datum: Datum::Mean, shares, height: 0.0 };
        cable.measure(at);
        cable
    }

    /// This cable with a weight per length, at the positions `at`.
    #[must_use]
    pub fn heavy(mut self, weight: f64, up: DVec3, datum: Datum, at: &[DVec3]) -> Self {
        (self.weight, self.up, self.datum) = (weight, up, datum);
        self.measure(at);
        self
    }

    /// The length of the whole cable.
    #[must_use]
    pub fn length(&self, at: &[DVec3]) -> f64 {
        self.segments.iter().map(|&segment| length::length(segment, at)).sum()
    }

    /// The largest distance of a vertex of the cable from the chord between its ends.
    #[must_use]
    pub fn sag(&self, at: &[DVec3]) -> f64 {
        let (Some(&[first, _]), Some(&[_, last])) = (self.segments.first(), self.segments.last()) else { return 0.0 };
        let start = at[first as usize];
        let chord = (at[last as usize] - start).normalize_or_zero();
        let distance = |v: u32| (at[v as usize] - start).reject_from_normalized(chord).length();
        self.segments.iter().map(|&[_, v]| distance(v)).fold(0.0, f64::max)
    }

    /// The part of the force at the first end that is across the vertical.
    #[must_use]
    pub fn horizontal_component(&self, at: &[DVec3]) -> f64 {
        let Some(&[a, b]) = self.segments.first() else { return 0.0 };
        let unit = (at[b as usize] - at[a as usize]).normalize_or_zero();
        self.force(0, at) * unit.reject_from_normalized(self.up).length()
    }

    /// The force in segment k.
    #[must_use]
    pub fn force(&self, k: usize, at: &[DVec3]) -> f64 {
        self.stretch(k, length::length(self.segments[k], at)).force + self.weight * self.rise(k, at)
    }

    /// Height of the middle of segment k above the datum.
    fn rise(&self, k: usize, at: &[DVec3]) -> f64 {
        let [a, b] = self.segments[k];
        0.5 * (at[a as usize] + at[b as usize]).dot(self.up) - self.height
    }

    fn stretch(&self, k: usize, length: f64) -> Stretch {
        match self.law {
            Law::Force(force) => Stretch { energy: force * length, force, stiffness: 0.0 },
            Law::Density(density) => {
                let density = density / self.shares[k];
                Stretch { energy: 0.5 * density * length * length, force: density * length, stiffness: density }
            }
            Law::Elastic { unstressed, stiffness } => {
                let unstressed = unstressed * self.shares[k];
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

    /// The force and stiffness of the law with the part of the force that the weight adds.
    fn heavy_stretch(&self, k: usize, length: f64, at: &[DVec3]) -> Stretch {
        let own = self.stretch(k, length);
        Stretch { force: own.force + self.weight * self.rise(k, at), ..own }
    }

    /// Sets the shares and the datum to those of the positions. Returns the largest relative change.
    fn measure(&mut self, at: &[DVec3]) -> f64 {
        let total = self.length(at).max(f64::MIN_POSITIVE);
        let (mut change, mut height) = (0.0f64, 0.0);
        for k in 0..self.segments.len() {
            let [a, b] = self.segments[k];
            let share = length::length(self.segments[k], at) / total;
            change = change.max((share / self.shares[k].max(f64::MIN_POSITIVE) - 1.0).abs());
            self.shares[k] = share;
            height += share * 0.5 * (at[a as usize] + at[b as usize]).dot(self.up);
        }
        if let (Datum::FirstEnd, Some(&[first, _])) = (self.datum, self.segments.first()) {
            height = at[first as usize].dot(self.up);
        }
        let moved = (height - self.height).abs() / total;
        self.height = height;
        let by_shares = if matches!(self.law, Law::Force(_)) { 0.0 } else { change };
        if self.weight == 0.0 { by_shares } else { by_shares.max(moved) }
    }
}

impl Term for Cable {
    fn value(&self, at: &[DVec3]) -> f64 {
        let energy = |(k, &segment): (usize, &[u32; 2])| {
            let length = length::length(segment, at);
            self.stretch(k, length).energy + self.weight * length * self.rise(k, at)
        };
        self.segments.iter().enumerate().map(energy).sum()
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        length::add_gradient(&self.segments, at, gradient, |k, length| self.heavy_stretch(k, length, at));
        if self.weight != 0.0 {
            for &segment in &self.segments {
                let half = 0.5 * self.weight * length::length(segment, at) * self.up;
                segment.into_iter().for_each(|v| gradient[v as usize] += half);
            }
        }
    }

    fn add_second_derivative(&self, at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        length::add_second_derivative(&self.segments, at, shift, add, |k, length| self.heavy_stretch(k, length, at));
        if self.weight == 0.0 {
            return;
        }
        // The derivative of w ℓ up / 2 by the length, and of w z t by the height; ∂ℓ/∂b = t = -∂ℓ/∂a.
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

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.segments.iter().for_each(|segment| visit(segment));
    }

    fn add_shares(&self, at: &[DVec3], shares: &mut [f64]) {
        // A cable whose force is the multiplier of its length has no force of its own; its weight then gives the scale.
        let own = self.weight * self.length(at);
        length::add_shares(&self.segments, at, shares, |k, length| {
            self.heavy_stretch(k, length, at).force.max(0.0) + own
        });
    }

    fn visit_forces(&self, at: &[DVec3], visit: &mut dyn FnMut(f64)) {
        (0..self.segments.len()).for_each(|k| visit(self.force(k, at)));
    }

    fn renew(&mut self, at: &[DVec3]) -> f64 {
        let change = self.measure(at);
        let (Some(target), Law::Force(force)) = (self.target, self.law) else { return change };
        // A shallow cable's sag is inversely proportional to its force, and the horizontal component of a force is
        // proportional to it, so each renewal is nearly a step of Newton's method.
        let ratio = match target {
            Target::Sag(sag) => self.sag(at) / sag,
            Target::HorizontalComponent(wanted) => wanted / self.horizontal_component(at).max(f64::MIN_POSITIVE),
        };
        let ratio = ratio.clamp(0.25, 4.0);
        self.law = Law::Force(force * ratio);
        change.max((ratio - 1.0).abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::finite_differences::{check, patch};

    #[test]
    fn the_derivatives_of_every_law_agree_with_finite_differences_light_and_heavy() {
        let (vertices, _) = patch();
        let up = DVec3::new(0.6, 0.0, 0.8);
        for law in [Law::Force(2.5), Law::Density(0.7), Law::Elastic { unstressed: 3.1, stiffness: 4.0 }] {
            for weight in [0.0, 0.9] {
                let segments = vec![[0, 1], [1, 2], [2, 6], [6, 7]];
                let cable = Cable::new(segments, law, &vertices).heavy(weight, up, Datum::FirstEnd, &vertices);
                check(&cable, &vertices, 1e-8);
            }
        }
    }

    #[test]
    fn a_slack_cable_has_no_force_and_a_taut_one_the_same_force_in_every_segment() {
        let (vertices, _) = patch();
        let segments = vec![[0, 1], [1, 2], [2, 6]];
        let taut = Cable::new(segments.clone(), Law::Elastic { unstressed: 2.0, stiffness: 5.0 }, &vertices);
        let force = 5.0 * (taut.length(&vertices) / 2.0 - 1.0);
        taut.visit_forces(&vertices, &mut |found| assert!((found - force).abs() < 1e-14));
        let slack = Cable::new(segments, Law::Elastic { unstressed: 9.0, stiffness: 5.0 }, &vertices);
        check(&slack, &vertices, 1e-8);
        slack.visit_forces(&vertices, &mut |found| assert_eq!(found, 0.0));
    }
}
