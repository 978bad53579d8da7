//! Tests of stored results and of every format that is written from them.

mod archives;
mod formats;
mod glb;
mod pictures;
mod sample;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;
