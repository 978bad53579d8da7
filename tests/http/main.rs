//! Tests against a running server: the real program on a free port, with a real store in its own folder.

mod access;
mod app;
#[cfg(feature = "test-hooks")]
mod audit;
mod base_path;
mod batches;
#[cfg(feature = "s3")]
mod bucket;
mod cable_nets;
mod cancel;
mod catalogue;
#[cfg(feature = "certificates")]
mod certificates;
#[cfg(feature = "test-hooks")]
mod children;
mod command_line;
mod compression;
mod connections;
mod database;
mod downloads;
mod drawings;
mod errors;
mod events;
mod examples;
mod films;
mod health;
#[path = "../hold/mod.rs"]
mod hold;
mod hooks;
#[cfg(feature = "hops")]
mod hops;
mod idempotency;
mod initial_meshes;
mod jobs;
mod limits;
#[cfg(feature = "test-hooks")]
mod limits_of_the_system;
mod load;
#[cfg(feature = "mcp")]
mod mcp;
mod memory;
mod meshes;
mod monitoring;
mod openapi;
mod operations;
mod pairs;
#[path = "../postgres/mod.rs"]
mod postgres;
mod prefer;
mod requests;
mod restart;
mod ruled_surfaces;
mod series;
mod shutdown;
#[path = "../skips/mod.rs"]
mod skips;
mod slow_uploads;
mod sources;
#[cfg(feature = "studio")]
mod studio;
mod tensile_structures;
mod uniform_meshes;
mod unresponsive;
mod webhooks;
