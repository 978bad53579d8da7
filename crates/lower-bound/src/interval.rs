//! Interval arithmetic with outward rounding: every resulting interval contains the exact result.
//!
//! The five basic operations of IEEE 754 are correctly rounded. The exact result of an operation therefore lies between
//! the two neighbours of the rounded result.

use plateau_mesh::DVec3;
use std::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub low: f64,
    pub high: f64,
}

impl Interval {
    pub const ZERO: Self = Self::exactly(0.0);

    pub const fn exactly(value: f64) -> Self {
        Self { low: value, high: value }
    }

    fn around(low: f64, high: f64) -> Self {
        // A NaN gives no information, so that the interval must contain every number.
        if low.is_nan() || high.is_nan() {
            return Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        Self { low: low.next_down(), high: high.next_up() }
    }

    /// Largest absolute value.
    pub fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    pub fn square(self) -> Self {
        let largest = self.magnitude();
        let least = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { self.low.abs().min(self.high.abs()) };
        let square = Self::around(least * least, largest * largest);
        Self { low: square.low.max(0.0), ..square }
    }

    /// The square root of an interval without negative numbers.
    pub fn sqrt(self) -> Self {
        let root = Self::around(self.low.max(0.0).sqrt(), self.high.sqrt());
        Self { low: root.low.max(0.0), ..root }
    }

    /// The interval times a number. The product is rounded outwards like every other result.
    pub fn times(self, factor: f64) -> Self {
        self * Self::exactly(factor)
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::around(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let products = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        if products.iter().any(|product| product.is_nan()) {
            return Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        let [a, b, c, d] = products;
        Self::around(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.low <= 0.0 && other.high >= 0.0 {
            return Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        let quotients = [self.low / other.low, self.low / other.high, self.high / other.low, self.high / other.high];
        if quotients.iter().any(|quotient| quotient.is_nan()) {
            return Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        let [a, b, c, d] = quotients;
        Self::around(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

/// A vector of intervals.
#[derive(Clone, Copy, Debug)]
pub(super) struct IntervalVector(pub [Interval; 3]);

impl IntervalVector {
    pub const ZERO: Self = Self([Interval::ZERO; 3]);

    pub fn exactly(vector: DVec3) -> Self {
        Self(vector.to_array().map(Interval::exactly))
    }

    pub fn scaled(self, factor: Interval) -> Self {
        Self(self.0.map(|x| x * factor))
    }

    pub fn dot(self, other: Self) -> Interval {
        let [a, b, c] = [0, 1, 2].map(|k| self.0[k] * other.0[k]);
        a + b + c
    }

    pub fn cross(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])
    }

    pub fn length_squared(self) -> Interval {
        let [a, b, c] = self.0.map(Interval::square);
        a + b + c
    }

    /// An upper bound of the vector's length.
    pub fn length_at_most(self) -> f64 {
        self.length_squared().sqrt().high
    }
}

impl Add for IntervalVector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for IntervalVector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}
