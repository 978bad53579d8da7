//! Numbers with their slopes by the coordinates of the six points about a bridge (forward differentiation), so that the
//! slopes of the objectives come from the formulas of [`weight`](crate::graph::weight) themselves.

use crate::graph::lanes::{Lanes, MOST_LANES, Task};
use std::ops::{Add, Div, Mul, Sub};

/// Number of variables: three coordinates of p_{i-1}, p_i, p_{i+1}, q_{j-1}, q_j and q_{j+1}.
pub(super) const VARIABLES: usize = 18;

/// A number and its slopes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dual {
    pub(super) value: f64,
    pub(super) slopes: [f64; VARIABLES],
}

impl Dual {
    pub(super) fn constant(value: f64) -> Self {
        Self { value, slopes: [0.0; VARIABLES] }
    }

    pub(super) fn variable(value: f64, variable: usize) -> Self {
        let mut slopes = [0.0; VARIABLES];
        slopes[variable] = 1.0;
        Self { value, slopes }
    }

    /// Returns a function of two numbers with this value and these partial derivatives.
    #[inline(always)]
    fn of(value: f64, (a, by_a): (&Self, f64), (b, by_b): (&Self, f64)) -> Self {
        let mut slopes = [0.0; VARIABLES];
        for (slope, (a, b)) in slopes.iter_mut().zip(a.slopes.iter().zip(&b.slopes)) {
            *slope = by_a * a + by_b * b;
        }
        Self { value, slopes }
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::of(self.value + other.value, (&self, 1.0), (&other, 1.0))
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::of(self.value - other.value, (&self, 1.0), (&other, -1.0))
    }
}

impl Mul for Dual {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::of(self.value * other.value, (&self, other.value), (&other, self.value))
    }
}

impl Div for Dual {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let (inverse, quotient) = (1.0 / other.value, self.value / other.value);
        Self::of(quotient, (&self, inverse), (&other, -quotient * inverse))
    }
}

impl Lanes for Dual {
    const WIDTH: usize = 1;
    type Mask = bool;
    type Simd = ();
    fn splat((): (), value: f64) -> Self {
        Self::constant(value)
    }
    fn load((): (), from: &[f64]) -> Self {
        Self::constant(from[0])
    }
    fn simd(self) {}
    /// The root of 0 has no slope, and 0 stands for it.
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        let slope = if root > 0.0 { 0.5 / root } else { 0.0 };
        Self::of(root, (&self, slope), (&self, 0.0))
    }
    fn less(self, other: Self) -> bool {
        self.value < other.value
    }
    fn at_most(self, other: Self) -> bool {
        self.value <= other.value
    }
    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    fn bits(mask: bool) -> u32 {
        u32::from(mask)
    }
    fn from_bits((): (), bits: u32) -> bool {
        bits & 1 == 1
    }
    fn shift_in(self, first: f64) -> Self {
        Self::constant(first)
    }
    fn last(self) -> f64 {
        self.value
    }
    fn lanes(self) -> [f64; MOST_LANES] {
        self.value.lanes()
    }
    fn run<T: Task<Self>>((): (), task: T) -> T::Output {
        task.run()
    }
}
