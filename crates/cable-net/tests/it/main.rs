//! Tests of cable nets by the public interface of the crate.

mod cable_nets;
mod memory;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;
