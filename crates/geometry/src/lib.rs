//! Minimal surfaces, optimal ruled strips and uniform meshes.
//!
//! # Vocabulary
//! - *Polyline*: points in order, `&[DVec3]`; a closed one does not repeat its first point.
//! - *Directrix*: a polyline that bounds a ruled strip. *Bridge*: a segment between two directrices.
//! - *Boundary loop*: a closed polyline that bounds a surface. Boundary vertices never move.
//! - *Mesh*: an indexed triangle mesh ([`mesh::Mesh`]), oriented, f64.
//!
//! # Units and conventions
//! Lengths are in the caller's unit, angles in radians, curvatures in 1/unit. Nothing here assumes metres or an up axis.
//! Every result is deterministic to the byte and depends on no clock, thread pool, file, or random source.
//!
//! # What is absent
//! No HTTP, no serde, no async, no clock, no thread pool, no file. A solver takes slices, options and an
//! [`Execution`](execution::Execution) (progress out, cancel in) and returns a mesh with a report.

mod energy;
mod equilibrium;
pub mod error;
pub mod execution;
pub mod mesh;
pub mod minimal_surface;
pub mod polyline;
pub mod random;
mod remesh;
pub mod ruled_surface;
pub mod sparse;
pub mod uniform_mesh;

pub use error::{Error, InputError, Place};
pub use execution::{Execution, Interruption, Progress, Signal};
pub use glam::{DVec2, DVec3};
pub use mesh::Mesh;
