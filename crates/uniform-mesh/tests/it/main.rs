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
