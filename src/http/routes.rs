//! Handlers by resource, each with its entry in the API document.

pub mod batches;
pub mod catalogue;
pub mod docs;
pub mod drawings;
pub mod events;
pub mod health;
#[cfg(feature = "hops")]
pub mod hops;
pub mod jobs;
#[cfg(feature = "mcp")]
pub mod mcp;
pub mod mesh;
#[cfg(feature = "studio")]
pub mod studio;
pub mod submit;
