//! Tests of ruled strips by the public interface of the crate.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod memory;
mod moving_rails;
mod ruled;
mod ruled_brute_force;
mod ruled_corridor;
mod ruled_directions;
mod ruled_properties;
mod ruled_surface;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;

/// Returns true if more cases are to be run than in the first tier of `scripts/test`.
fn is_full() -> bool {
    ["PLATEAU_FULL", "PLATEAU_LONG"].into_iter().any(|name| std::env::var_os(name).is_some())
}
