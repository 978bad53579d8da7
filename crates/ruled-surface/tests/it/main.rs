//! Tests of ruled strips by the public interface of the crate.

mod memory;
mod ruled;
mod ruled_brute_force;
mod ruled_corridor;
mod ruled_directions;
mod ruled_properties;
mod ruled_surface;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;
