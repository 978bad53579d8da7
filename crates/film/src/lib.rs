//! Films and nets: minimal surfaces, tensile structures and cable nets.
//!
//! [`minimal_surface`] finds surfaces of least area between boundary loops (Chen, Cai and Zheng; Liu and Wang; Bento
//! and Cavalcanti). [`tensile_structure`] finds films with cables, pressure and weight in equilibrium. [`cable_net`]
//! finds nets of cables without a film. All three use [`energy`] and [`equilibrium`]. [`form_finding`] drives films and
//! tensile structures to their shapes.
//!
//! ```
//! use plateau_film::minimal_surface::{Options, Resolution, solve};
//! use plateau_mesh::{DVec3, Execution};
//!
//! // A skew quadrilateral: the corners of a square, two of them raised.
//! let corners = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.5), (1.0, 1.0, 0.0), (0.0, 1.0, 0.5)];
//! let boundary: Vec<DVec3> = corners.into_iter().map(DVec3::from).collect();
//! let surface = solve(&[boundary], &Options::new(Resolution::Triangles(500)), &Execution::default())?;
//! assert!(surface.statistics.converged);
//! assert_eq!(surface.mesh.triangles.len(), surface.statistics.triangles);
//! # Ok::<(), plateau_mesh::Error>(())
//! ```
//!
//! # Glossary
//! - *Boundary loop*: a closed polyline that bounds a surface. Boundary vertices do not move.
//! - *Film*: a mesh between boundary loops while a solver works on it. *Sheet*: a part of a film between junctions.
//!   *Junction*: a curve along which three sheets meet.
//! - *Residual*: the largest mean curvature times the radius of the boundary, from the gradient of the area.
//!   Dimensionless.
//! - *Stationary*: the gradient of the energy vanishes. *Morse index*: the number of independent directions in which
//!   the energy of a stationary surface falls. *Stable*: the index is 0. *Unstable mode*: one of these directions.
//! - *Pinch*: a change of topology where a neck closes.
//!
//! # Layers
//! Each module uses only the modules before it in this list: [`energy`], [`equilibrium`], [`form_finding`],
//! [`minimal_surface`], [`tensile_structure`], [`cable_net`].

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
#![warn(missing_docs)]

pub mod cable_net;
pub mod energy;
pub mod equilibrium;
pub mod form_finding;
pub mod minimal_surface;
pub mod tensile_structure;

/// Compiles and runs the example of the README as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
