//! The catenary of a heavy cable between two points, from the quantity that the cable's mode prescribes.
//!
//! With the horizontal component H of the force, the weight w per length and a = H / w the cable is
//!
//! ```text
//! y = a cosh(x / a)        force w y        length from the lowest point a sinh(x / a)
//! ```
//!
//! (any text on cables). The first end is at x0, the second at x0 + d at a height v above the first: x0 = a asinh(v /
//! (2 a sinh(d / 2a))) - d / 2. Form finding places the vertices of the cable on this curve at first. Its own model of
//! the cable is a chain of straight segments.

use super::options::{Cable, CableMode};
use plateau_mesh::DVec3;

/// Smallest a / d at which a catenary is looked for. There the cable is 1e11 times as long as the span.
const LEAST_PARAMETER: f64 = 1.0 / 60.0;
/// Largest a / d at which a catenary is looked for. There the sag is 1e-7 of the span.
const LARGEST_PARAMETER: f64 = 1e6;
/// Ratio of successive values of a in the search for the tautest solution.
const SCAN: f64 = 1.02;
/// If the horizontal distance between the ends is at most this fraction of the chord, the cable hangs straight down
/// from the upper end.
const VERTICAL: f64 = 1e-6;

/// Returns the force at height 0 of a heavy cable between two points, one above the other. The cable hangs straight,
/// and its force grows with the height by the weight per length. Returns `None` for all other cables, and for modes
/// that do not determine the force.
///
/// # Errors
/// The bound on the cable's value beyond which a part of the cable would have to push.
pub(super) fn plumb_force(cable: &Cable, ends: [DVec3; 2], up: DVec3) -> Option<Result<f64, NoCatenary>> {
    let span = ends[1] - ends[0];
    let length = span.length();
    if cable.weight <= 0.0 || !are_plumb(ends, up) {
        return None;
    }
    let [first, second] = ends.map(|end| end.dot(up));
    let (mean, lowest) = (0.5 * (first + second), first.min(second));
    // The force that the mode determines, and the height at which the cable has this force.
    let (force, height) = match cable.mode {
        CableMode::Force(force) => (force, mean),
        CableMode::EndTension(force) => (force, first),
        CableMode::ForceDensity(density) => (density * length, mean),
        CableMode::UnstressedLength(unstressed) => {
            (cable.axial_stiffness.unwrap_or(1.0) * (length / unstressed - 1.0), mean)
        }
        CableMode::HorizontalComponent(_) | CableMode::Length(_) | CableMode::Sag(_) => return None,
    };
    let least = cable.weight * (height - lowest);
    if force <= least {
        let bound = match cable.mode {
            CableMode::ForceDensity(_) => least / length,
            CableMode::UnstressedLength(_) => length / (1.0 + least / cable.axial_stiffness.unwrap_or(1.0)),
            _ => least,
        };
        return Some(Err(NoCatenary { bound }));
    }
    Some(Ok(force - cable.weight * height))
}

/// Whether one of two points is above the other.
pub(super) fn are_plumb(ends: [DVec3; 2], up: DVec3) -> bool {
    let span = ends[1] - ends[0];
    span.reject_from_normalized(up).length() <= VERTICAL * span.length()
}

/// A heavy cable in equilibrium between two points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Catenary {
    first: DVec3,
    /// The horizontal unit vector from the first end towards the second.
    level: DVec3,
    up: DVec3,
    weight: f64,
    a: f64,
    x0: f64,
    /// d, the horizontal distance between the ends.
    width: f64,
    /// v, the height of the second end above the first.
    rise: f64,
}

/// Error: no cable in tension hangs between two points with the given value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NoCatenary {
    /// The bound of the values for which there is a cable: the largest unstressed length, or the least value of any
    /// other mode.
    pub bound: f64,
}

impl Catenary {
    /// Returns the tautest catenary of a cable between two points. Returns `None` if the cable has no weight, if one
    /// point is above the other, or if no catenary has the value of a mode other than force, end tension and force
    /// density.
    ///
    /// # Errors
    /// For these three modes: the bound of the values for which there is a catenary.
    pub fn find(cable: &Cable, ends: [DVec3; 2], up: DVec3) -> Result<Option<Self>, NoCatenary> {
        let span = ends[1] - ends[0];
        let across = span.reject_from_normalized(up);
        let (width, rise) = (across.length(), span.dot(up));
        if cable.weight <= 0.0 || width <= VERTICAL * span.length() {
            return Ok(None);
        }
        let at = |a: f64| {
            let x0 = a * libm::asinh(rise / (2.0 * a * libm::sinh(0.5 * width / a))) - 0.5 * width;
            Self { first: ends[0], level: across / width, up, weight: cable.weight, a, x0, width, rise }
        };
        // The function that equals `value` on the wanted curve. It rises with a where the cable is taut.
        let value = cable.mode.value();
        let measure = |curve: &Self| match cable.mode {
            CableMode::Force(_) => curve.mean_force(),
            CableMode::EndTension(_) => curve.force(0.0),
            CableMode::HorizontalComponent(_) => curve.a * curve.weight,
            CableMode::ForceDensity(_) => curve.mean_force() / curve.length(),
            CableMode::Length(_) => 2.0 * value - curve.length(),
            CableMode::Sag(_) => 2.0 * value - curve.sag(),
            CableMode::UnstressedLength(unstressed) => {
                let stiffness = cable.axial_stiffness.unwrap_or(1.0);
                value + curve.mean_force() - stiffness * (curve.length() / unstressed - 1.0)
            }
        };
        let (mut taut, mut least) = (LARGEST_PARAMETER * width, f64::INFINITY);
        // At most 905 passes, because the parameter falls by `SCAN` from the largest value to the least one.
        loop {
            let found = measure(&at(taut));
            if found <= value {
                break;
            }
            least = least.min(found);
            taut /= SCAN;
            if taut < LEAST_PARAMETER * width || !taut.is_finite() {
                let by_force =
                    matches!(cable.mode, CableMode::Force(_) | CableMode::EndTension(_) | CableMode::ForceDensity(_));
                return if by_force { Err(NoCatenary { bound: least }) } else { Ok(None) };
            }
        }
        let (mut below, mut above) = (taut, taut * SCAN);
        for _ in 0..60 {
            let middle = 0.5 * (below + above);
            *(if measure(&at(middle)) <= value { &mut below } else { &mut above }) = middle;
        }
        Ok(Some(at(above)))
    }

    /// The force at the length `from_first` of the cable from the first end.
    pub fn force(&self, from_first: f64) -> f64 {
        let x = self.place(from_first);
        self.weight * self.a * libm::cosh(x / self.a)
    }

    pub fn length(&self) -> f64 {
        let Self { a, x0, width, .. } = *self;
        a * (libm::sinh((x0 + width) / a) - libm::sinh(x0 / a))
    }

    /// The mean force ∫ w y ds / L with ds = cosh(x / a) dx.
    fn mean_force(&self) -> f64 {
        let Self { a, x0, width, .. } = *self;
        let integral = |x: f64| 0.5 * a * (x + 0.5 * a * libm::sinh(2.0 * x / a));
        self.weight * (integral(x0 + width) - integral(x0)) / self.length()
    }

    /// The largest distance of the cable from its chord, at the point where the cable is parallel to the chord.
    fn sag(&self) -> f64 {
        let Self { a, x0, width, rise, .. } = *self;
        let x = a * libm::asinh(rise / width);
        let chord = a * libm::cosh(x0 / a) + rise * (x - x0) / width;
        (chord - a * libm::cosh(x / a)) * width / libm::hypot(width, rise)
    }

    /// x at the length `from_first` of the cable from the first end.
    fn place(&self, from_first: f64) -> f64 {
        self.a * libm::asinh(from_first / self.a + libm::sinh(self.x0 / self.a))
    }

    /// The point at the length `from_first` of the cable from the first end.
    pub fn point(&self, from_first: f64) -> DVec3 {
        let (x, a) = (self.place(from_first), self.a);
        // cosh(p) - cosh(q) = 2 sinh((p + q) / 2) sinh((p - q) / 2) keeps the digits of a shallow cable.
        let rise = 2.0 * a * libm::sinh(0.5 * (x + self.x0) / a) * libm::sinh(0.5 * (x - self.x0) / a);
        self.first + (x - self.x0) * self.level + rise * self.up
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::Course;

    #[test]
    fn every_mode_finds_the_catenary_whose_figures_it_is_given() {
        // Span 10, rise 3, parameter 6: y = 6 cosh(x / 6).
        let ends = [DVec3::new(1.0, 2.0, 3.0), DVec3::new(7.0, 10.0, 6.0)];
        let cable = |mode, axial_stiffness| Cable {
            name: String::new(),
            course: Course::Air(ends),
            mode,
            axial_stiffness,
            weight: 2.0,
        };
        let find = |mode, stiffness| Catenary::find(&cable(mode, stiffness), ends, DVec3::Z).unwrap().unwrap();
        let curve = find(CableMode::HorizontalComponent(12.0), None);
        assert!((curve.a - 6.0).abs() < 1e-12);
        assert!(curve.point(curve.length()).distance(ends[1]) < 1e-12);
        // Length, sag and mean force measured on points of the curve.
        let count = 20_000;
        let points: Vec<DVec3> =
            (0..=count).map(|k| curve.point(curve.length() * f64::from(k) / f64::from(count))).collect();
        let length: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let chord = (ends[1] - ends[0]).normalize();
        let sag = points.iter().map(|p| (*p - ends[0]).reject_from_normalized(chord).length()).fold(0.0, f64::max);
        let mean =
            (0..count).map(|k| curve.force(curve.length() * (f64::from(k) + 0.5) / f64::from(count))).sum::<f64>()
                / f64::from(count);
        assert!((length - curve.length()).abs() < 1e-6 && (sag - curve.sag()).abs() < 1e-6);
        assert!((mean - curve.mean_force()).abs() < 1e-6);
        for (mode, stiffness) in [
            (CableMode::Force(mean), None),
            (CableMode::EndTension(curve.force(0.0)), None),
            (CableMode::ForceDensity(mean / length), None),
            (CableMode::Length(length), None),
            (CableMode::Sag(sag), None),
            (CableMode::UnstressedLength(length / (1.0 + mean / 500.0)), Some(500.0)),
        ] {
            let found = find(mode, stiffness);
            assert!((found.a - 6.0).abs() < 1e-4, "{mode:?} {}", found.a);
        }
        let refused = Catenary::find(&cable(CableMode::Force(1.0), None), ends, DVec3::Z);
        assert!(refused.is_err_and(|error| error.bound > 1.0));
    }
}
