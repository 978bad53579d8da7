//! Tests of meshes by the public interface of the crate.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod self_intersections;
