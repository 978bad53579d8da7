//! Forces of cables: the quantity that determines each, and the force with which form finding begins.

use crate::options::{Cable, CableMode, Course, Structure};
use plateau_equilibrium::energy;
use plateau_equilibrium::energy::cable::{self, Equation, Law};
use plateau_mesh::DVec3;

/// The quantity that determines the force of a cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ForceBy {
    /// The law of the cable's energy.
    Law,
    /// The given length of the cable. The length is a constraint, and the force is the multiplier of this constraint.
    Length(f64),
    /// The unstressed length and the stiffness: the cable is elastic. The length is a constraint that yields to the
    /// force.
    Elastic {
        /// L0, the length without force.
        unstressed: f64,
        /// EA, the axial stiffness, a force.
        stiffness: f64,
    },
    /// An equation that takes the place of a given length in the constraint. It is used if the cable is heavy, or if
    /// its sag or its horizontal component is given.
    Equation(Equation),
}

/// Damps the changes of a cable's start force. The force is computed from the shape, and the shape follows from the
/// force, so both could oscillate without end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Swing {
    /// Fraction of a wanted change that is made.
    share: f64,
    /// The last wanted change, before damping.
    last: f64,
}

impl Default for Swing {
    fn default() -> Self {
        Self { share: 1.0, last: 0.0 }
    }
}

impl Swing {
    /// A change of opposite sign counts as an oscillation if its magnitude exceeds this fraction of the last change.
    const LASTS: f64 = 0.7;
    /// Lower bound of the fraction of a change that is made.
    const LEAST_SHARE: f64 = 0.1;

    /// Returns the damped change. Every oscillation halves the fraction of the change that is made.
    pub fn damped(&mut self, change: f64) -> f64 {
        if change * self.last < 0.0 && change.abs() > Self::LASTS * self.last.abs() {
            self.share = (0.5 * self.share).max(Self::LEAST_SHARE);
        }
        self.last = change;
        self.share * change
    }
}

/// Lower bound of the horizontal part of a cable's unit direction. A start force is a given horizontal component
/// divided by this part, and without the bound it would be infinite for a vertical cable.
pub(super) const LEAST_ACROSS: f64 = 0.1;

/// Half of the central angle, in radians, of the flattest arc with which a cable of given length begins. It bounds the
/// force in [`Stage::Settling`](super::Stage::Settling), where the ends may be further apart than the cable is long.
const FLATTEST: f64 = 0.05;

/// The radius of the circular arc of the given length over a chord. If the chord is not shorter than the arc, the
/// radius of the flattest arc is returned.
fn arc_radius(chord: f64, length: f64) -> f64 {
    if chord >= length {
        return 0.5 * length / FLATTEST;
    }
    // Bisection for the half angle t with sin t / t = chord / length. The quotient falls from 1 at t = 0 to 0 at t = π.
    let (mut low, mut high) = (0.0, std::f64::consts::PI);
    for _ in 0..60 {
        let middle: f64 = 0.5 * (low + high);
        *(if libm::sin(middle) * length > chord * middle { &mut low } else { &mut high }) = middle;
    }
    0.5 * length / low.max(FLATTEST)
}

/// The law of a cable's energy, and the quantity that determines the cable's force.
pub(super) fn law(cable: &Cable) -> (Law, ForceBy) {
    let by_equation = |equation| (Law::Multiplier, ForceBy::Equation(equation));
    if let (Course::Mast(_), CableMode::Force(force)) = (&cable.course, cable.mode) {
        return (Law::Force(-force), ForceBy::Law);
    }
    let heavy = cable.weight > 0.0;
    match cable.mode {
        CableMode::Length(length) => (Law::Multiplier, ForceBy::Length(length)),
        CableMode::Sag(sag) => by_equation(Equation::Sag(sag)),
        CableMode::HorizontalComponent(force) => by_equation(Equation::HorizontalComponent(force)),
        CableMode::Force(force) if heavy => by_equation(Equation::MeanForce(force)),
        CableMode::EndTension(force) if heavy => by_equation(Equation::EndTension(force)),
        CableMode::Force(force) | CableMode::EndTension(force) => (Law::Force(force), ForceBy::Law),
        CableMode::ForceDensity(density) if heavy => by_equation(Equation::ForceDensity(density)),
        CableMode::ForceDensity(density) => (Law::Density(density), ForceBy::Law),
        CableMode::UnstressedLength(unstressed) => {
            let stiffness = cable.axial_stiffness.unwrap_or(1.0);
            if heavy {
                by_equation(Equation::Elastic { unstressed, stiffness })
            } else {
                (Law::Multiplier, ForceBy::Elastic { unstressed, stiffness })
            }
        }
    }
}

/// Estimates the force of a cable from its present shape. The estimate for a cable of given length or sag is that of a
/// circular arc under a uniform load across it.
pub(super) fn start_force(cable: &Cable, structure: &Structure, segments: &[[u32; 2]], at: &[DVec3]) -> f64 {
    let (Some(&[first, _]), Some(&[_, last])) = (segments.first(), segments.last()) else { return 0.0 };
    let span = at[last as usize] - at[first as usize];
    let chord = span.length();
    let length = || segments.iter().map(|&segment| energy::length::length(segment, at)).sum::<f64>();
    let load = if cable.course.ends_in_the_air().is_some() { cable.weight } else { structure.pull() };
    match cable.mode {
        CableMode::Force(force) | CableMode::EndTension(force) => force,
        CableMode::HorizontalComponent(wanted) => {
            let across = span.normalize_or_zero().reject_from_normalized(structure.up).length();
            wanted / across.max(LEAST_ACROSS)
        }
        CableMode::ForceDensity(density) => density * length(),
        CableMode::Length(length) => load * arc_radius(chord, length),
        CableMode::UnstressedLength(unstressed) => {
            // Bisection for the force F of the arc of radius F / load whose length is L0 (1 + F / EA). The length of
            // the arc falls with the force, and the arc of the least force is half a circle.
            let stiffness = cable.axial_stiffness.unwrap_or(1.0);
            let (mut low, mut high) = (0.5 * load * chord, 0.5 * load * chord + stiffness * (2.0 * chord / unstressed));
            for _ in 0..60 {
                let force = 0.5 * (low + high);
                let arc = 2.0 * force / load.max(f64::MIN_POSITIVE) * libm::asin((0.5 * load * chord / force).min(1.0));
                *(if arc > unstressed * (1.0 + force / stiffness) { &mut low } else { &mut high }) = force;
            }
            low
        }
        CableMode::Sag(sag) => load * (0.25 * chord * chord + sag * sag) / (2.0 * sag),
    }
}

/// Returns the mean force of a cable, weighted by the lengths of its segments, then the least and the largest force of
/// a segment. `further` is added to the force of every segment.
pub(crate) fn forces(term: &cable::Cable, further: f64, at: &[DVec3]) -> (f64, f64, f64) {
    let (mut sum, mut total, mut least, mut most) = (0.0, 0.0, f64::INFINITY, f64::NEG_INFINITY);
    for (k, &segment) in term.segments.iter().enumerate() {
        let (force, length) = (term.force(k, at) + further, energy::length::length(segment, at));
        sum += force * length;
        total += length;
        least = least.min(force);
        most = most.max(force);
    }
    (sum / total.max(f64::MIN_POSITIVE), least, most)
}
