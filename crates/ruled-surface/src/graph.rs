//! The grid of bridges of one strip as a layered graph, and the shortest paths through it (sections 4 and 5).
//!
//! [`rails`] holds the points, [`weight`] the formulas of every objective over [`lanes`]. [`strip_arrays`] lays the
//! points out for a [`sweep`], whose kernels are in [`layers`]. [`convexity`] judges bridges, [`corridor`] leaves out
//! what a strip of least area cannot use, and [`closed`] searches over all starts.

pub(crate) mod cell_counter;
pub(crate) mod closed;
pub(crate) mod convexity;
pub(crate) mod corridor;
pub(crate) mod lanes;
pub(crate) mod layers;
pub(crate) mod rails;
pub(crate) mod strip_arrays;
pub(crate) mod sweep;
pub(crate) mod weight;
