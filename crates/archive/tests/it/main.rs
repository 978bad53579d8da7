//! Tests of stored results and of every format that is written from them.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod archives;
mod formats;
mod glb;
mod pictures;
mod sample;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;
