//! Plateau: form finding over HTTP. See `docs/ARCHITECTURE.md`.
//!
//! The library is there for the program and for the tests that look below HTTP. What is private here has no other user,
//! so that the compiler names what nothing uses.

mod app;
mod auth;
pub mod cli;
pub mod config;
pub mod export;
mod http;
pub mod jobs;
pub mod status;
pub mod store;
mod telemetry;
pub mod units;
mod webhook;
pub mod wire;
