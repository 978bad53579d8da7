//! Floating-point numbers with the order of `f64::total_cmp`, for heaps and sorting keys.

use std::cmp::Ordering;

/// A floating-point number with a total order. Two numbers are equal if and only if their bits are equal.
#[derive(Clone, Copy, Debug)]
pub struct TotalOrder(pub f64);

impl Ord for TotalOrder {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}
impl PartialOrd for TotalOrder {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl PartialEq for TotalOrder {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for TotalOrder {}
