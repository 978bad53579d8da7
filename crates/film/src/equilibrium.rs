//! The equilibrium of sheets and lines: every body is solved by the same Newton iteration, with the same residual and
//! the same analysis of stability.
//!
//! A [`Body`] consists of a complex of triangles with a surface tension per sheet, further energies
//! ([`Term`](crate::energy::Term)), the directions in which each vertex may move ([`Freedom`]), and constraints on the
//! whole body. [`Body::relax`] moves it to the nearest equilibrium:
//!
//! ```
//! use plateau_film::equilibrium::{Body, Outcome, Settings};
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

mod body;
mod constraint;
mod contact;
mod dense;
mod freedom;
mod motion;
pub(crate) mod newton;
mod normal_motion;
mod relax;
pub(crate) mod residual;
pub(crate) mod settling;
pub(crate) mod stability;
pub mod support;
#[cfg(test)]
mod tests;
pub(crate) mod v_cycle;

pub use body::{Body, BodyDefect};
pub use constraint::{Constraint, Determined};
pub use contact::Contact;
pub use freedom::Freedom;
pub use newton::{Aim, Outcome, Settings};
pub use relax::Report;
pub use stability::Stability;
pub use support::Support;

pub(crate) use motion::{Frame, Motion};
pub(crate) use normal_motion::{FilmState, NormalMotion, film_state};
pub(crate) use stability::stability_warnings;
