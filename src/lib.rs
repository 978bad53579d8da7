//! Plateau: form finding over HTTP. See `docs/ARCHITECTURE.md`.
//!
//! The library exists for the program and for the tests that look below HTTP. Everything that they do not use is
//! private, so that the compiler reports dead code.

#![forbid(unsafe_code)]

mod app;
mod auth;
#[cfg(test)]
mod bombs;
pub mod cli;
pub mod config;
#[cfg(feature = "hops")]
pub mod hops;
mod http;
pub mod jobs;
pub mod status;
pub mod store;
mod telemetry;
#[cfg(feature = "test-hooks")]
mod test_hooks;
mod threads;
mod webhook;
pub mod wire;
