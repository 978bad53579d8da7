//! Minimal surfaces, tensile structures, optimal ruled strips and uniform meshes.
//!
//! Each kind of surface has a module with a function `solve`. It takes slices, options, and an [`Execution`] for
//! progress and cancellation. It returns a mesh with statistics and warnings.
//!
//! ```
//! use plateau_geometry::minimal_surface::{Options, Resolution, solve};
//! use plateau_geometry::{DVec3, Execution};
//!
//! // A skew quadrilateral: the corners of a square, two of them raised.
//! let corners = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.5), (1.0, 1.0, 0.0), (0.0, 1.0, 0.5)];
//! let boundary: Vec<DVec3> = corners.into_iter().map(DVec3::from).collect();
//! let surface = solve(&[boundary], &Options::new(Resolution::Triangles(500)), &Execution::default())?;
//! assert!(surface.statistics.converged);
//! assert_eq!(surface.mesh.triangles.len(), surface.statistics.triangles);
//! # Ok::<(), plateau_geometry::Error>(())
//! ```
//!
//! # Glossary
//! - *Polyline*: points in order, `&[DVec3]`; a closed one does not repeat its first point.
//! - *Boundary loop*: a closed polyline that bounds a surface. Boundary vertices do not move.
//! - *Mesh*: an indexed, oriented triangle mesh ([`mesh::Mesh`]) in double precision.
//! - *Half-edge*: one side of an edge, in one triangle and with its direction ([`mesh::topology`]).
//! - *Flipped triangle*: its normal points against the normals of its vertices. *Degenerate triangle*: its shortest
//!   altitude is below 1e-10 of its longest edge.
//! - *Film*: a mesh between boundary loops while a solver works on it. *Sheet*: a part of a film between junctions.
//!   *Junction*: a curve along which three sheets meet.
//! - *Residual*: the largest mean curvature times the radius of the boundary, from the gradient of the area.
//!   Dimensionless.
//! - *Stationary*: the gradient of the energy vanishes. *Morse index*: the number of independent directions in which
//!   the energy of a stationary surface falls. *Stable*: the index is 0. *Unstable mode*: one of these directions.
//! - *Pinch*: a change of topology where a neck closes.
//! - *Directrix*: a polyline that bounds a ruled strip. *Bridge*: a segment between two directrices.
//! - *Lattice*: the points of the plane with coordinates i a + j b for whole i and j; a uniform mesh carries one.
//!
//! # Units and conventions
//! Lengths are in the caller's unit, angles in radians, curvatures in 1/unit. Nothing here assumes metres or an up
//! axis. Every result is deterministic to the byte and depends on no clock, thread pool, file, or random source.
//!
//! # Layers
//! Each module knows only those above it: `mesh`, `sparse` (linear systems), `plane`, `remesh`, `energy`,
//! `equilibrium`, [`minimal_surface`], [`tensile_structure`], [`cable_net`], [`uniform_mesh`], [`ruled_surface`]. The
//! crate knows no HTTP, no serde, no async, no clock, no thread pool and no file.

#![warn(missing_docs)]

pub mod cable_net;
pub mod energy;
pub mod equilibrium;
pub mod error;
mod estimate;
pub mod execution;
pub mod mesh;
pub mod minimal_surface;
mod plane;
pub mod polyline;
pub mod random;
mod remesh;
pub mod ruled_surface;
mod sparse;
pub mod tensile_structure;
pub mod uniform_mesh;

pub use error::{Error, InputError, Place};
pub use estimate::Estimate;
pub use execution::{Execution, Interruption, Progress, Signal};
pub use glam::{DVec2, DVec3};
pub use mesh::Mesh;
