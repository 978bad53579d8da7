//! Handlers, by resource.

pub mod batches;
pub mod catalogue;
pub mod health;
pub mod jobs;
pub mod mesh;
pub mod studio;
pub mod submit;
