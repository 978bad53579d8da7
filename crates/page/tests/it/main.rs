//! Tests of the WebAssembly module's functions, called from Rust.

mod drag;
