//! Tests of proven lower bounds by the public interface of the crate.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

#[path = "../../../minimal-surface/tests/it/boundaries/mod.rs"]
mod boundaries;
mod lower_bound;
