//! Tests of lattices on polygons, patches and films by the public interface of the crate.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod once_wrong;
mod uniform_curved;
mod uniform_plane;
mod uniform_surface;

/// Returns true if more cases are to be run than in the first tier of `scripts/test`.
fn is_full() -> bool {
    ["PLATEAU_FULL", "PLATEAU_LONG"].into_iter().any(|name| std::env::var_os(name).is_some())
}
