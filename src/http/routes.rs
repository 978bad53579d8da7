//! Handlers by resource, each with its entry in the API document.

pub mod batches;
pub mod catalogue;
pub mod docs;
pub mod events;
pub mod health;
pub mod hops;
pub mod jobs;
pub mod mcp;
pub mod mesh;
pub mod studio;
pub mod submit;
