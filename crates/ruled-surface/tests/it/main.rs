//! Tests of ruled strips by the public interface of the crate.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod memory;
mod ruled;
mod ruled_brute_force;
mod ruled_corridor;
mod ruled_directions;
mod ruled_properties;
mod ruled_surface;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;
