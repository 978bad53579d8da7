//! The equilibrium of sheets and lines: every body is solved by the same Newton iteration, with the same residual and
//! the same analysis of stability.
//!
//! A [`Body`] consists of a complex of triangles with a surface tension per sheet, further energies
//! ([`Term`](energy::Term)), the directions in which each vertex may move ([`Freedom`]), and constraints on the whole
//! body. [`Body::relax`] moves it to the nearest equilibrium:
//!
//! ```
//! use plateau_equilibrium::{Body, Outcome, Settings};
//! use plateau_mesh::complex::Complex;
//! use plateau_mesh::{DVec3, Execution};
//!
//! // Four sides of a unit square with a vertex in the middle, pulled out of the plane.
//! let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
//! let mut vertices = corners.to_vec();
//! vertices.push(DVec3::new(0.5, 0.5, 0.3));
//! let complex = Complex::build(vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], 5)?;
//! let mut body = Body::new(vertices, &complex, &[1.0]);
//! let report = body.relax(&Settings::default(), &Execution::default(), &mut |_, _| {})?;
//! assert_eq!(report.outcome, Outcome::Converged);
//! assert_eq!(report.stability.and_then(|stability| stability.morse_index), Some(0));
//! assert!((body.energy() - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Glossary
//! - *Residual*: the largest mean curvature times the radius of the boundary, from the gradient of the area.
//!   Dimensionless.
//! - *Stationary*: the gradient of the energy vanishes. *Morse index*: the number of independent directions in which
//!   the energy of a stationary surface falls. *Stable*: the index is 0. *Unstable mode*: one of these directions.
//!
//! # How it works
//! - [`energy`] has the energies, each with its gradient and its second variation. A new physical effect is a term
//!   (`docs/adding-an-energy.md`).
//! - `newton` is the iteration: a factorised step and a line search. Its two sets of equations are `normal_motion`, the
//!   fast path of a film whose vertices move along their normals, and `motion`, a body with any energies, freedoms and
//!   constraints. `v_cycle` computes the steps of large films by multigrid.
//! - `residual` ends the iteration and is reported. `stability` counts the unstable modes.
//! - [`support`] has the lines and surfaces on which edges slide (`docs/adding-a-support.md`).
//! - `settling` brings a shape near its equilibrium from any start, and [`form_finding`] drives a film or a structure
//!   through rounds of settling and Newton's method until its shape is accepted.
//!
//! The crates of minimal surfaces and tensile structures use the parts that these pages do not show.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
#![warn(missing_docs)]

mod body;
mod constraint;
mod contact;
mod dense;
pub mod energy;
pub mod form_finding;
mod freedom;
#[doc(hidden)]
pub mod motion;
#[doc(hidden)]
pub mod newton;
#[doc(hidden)]
pub mod normal_motion;
mod relax;
#[doc(hidden)]
pub mod residual;
#[doc(hidden)]
pub mod settling;
#[doc(hidden)]
pub mod stability;
pub mod support;
#[cfg(test)]
mod tests;
#[doc(hidden)]
pub mod v_cycle;

pub use body::{Body, BodyDefect};
pub use constraint::{Constraint, Determined};
pub use contact::ContactEnergy;
pub use freedom::Freedom;
pub use newton::{Aim, Outcome, Settings};
pub use relax::Report;
pub use stability::Stability;
pub use support::Support;

/// Compiles and runs the example of the README as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
