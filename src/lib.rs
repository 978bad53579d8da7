//! Plateau: form finding over HTTP. See `docs/ARCHITECTURE.md`.

pub mod app;
pub mod cli;
pub mod config;
pub mod export;
pub mod http;
pub mod jobs;
pub mod store;
pub mod telemetry;
pub mod webhook;
pub mod wire;
