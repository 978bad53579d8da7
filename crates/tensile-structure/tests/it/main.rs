//! Tests of tensile structures by the public interface of the crate.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod cushions;
mod forces;
mod random_structures;
mod sliding_edges;
mod tensile_structures;
mod travelling;

/// Whether `scripts/test --full` or `--long` runs the tests. The first tier takes fewer cases of the slowest tests.
fn is_full() -> bool {
    ["PLATEAU_FULL", "PLATEAU_LONG"].into_iter().any(|name| std::env::var_os(name).is_some())
}
