//! Uniform meshes: triangulations whose edges (the members of a latticed roof) have as few lengths as possible.
//!
//! N. Katoh, M. Ohsaki, Y. Xu, *A uniform triangle mesh generation of curved surfaces*. Given a length ℓ, every edge
//! should lie in [ℓ, 2ℓ]:
//! - [`Objective::FewestNodes`] (their problem 1): farthest-point insertion, at most 16/3 times the fewest nodes
//!   possible;
//! - [`Objective::MostEqualEdges`] (their problem 2): an equilateral lattice of edge ℓ inside, and the same insertion
//!   in the transition zone between lattice and boundary.
//!
//! The range [ℓ, 2ℓ] and the factor 16/3 are guaranteed on convex polygons with inner angles of 90° or more and sides
//! of ℓ or more. On other polygons (concave, with sharp corners, short sides or holes) the mesh is still valid, no edge
//! is longer than 2ℓ, and every edge shorter than ℓ is listed with the reason.
//!
//! A curved domain is flattened and meshed in the plane, and the mesh is carried back to the surface. Then the inner
//! nodes move on the surface until the lattice members are as near to ℓ as possible.
//!
//! If a surface cannot be flattened with a bounded distortion (it is strongly curved, closed, or has a pole), the mesh
//! is made on the surface itself ([`Method::OnSurface`]). [`Statistics::surface`] compares the mesh of a curved domain
//! with its surface, and `converged` is false if the mesh is too far from the surface.
//!
//! Each step has a file of its own. In `plane/`, `polygon` checks a planar domain and places the boundary's nodes,
//! `lattice` places the lattice, `increment` inserts the other nodes, and `mesh` joins the parts. In `surface/`,
//! `nurbs` evaluates patches, `auxiliary` triangulates a surface, `flatten` flattens it, `move_nodes` moves the nodes
//! on the surface, and `transition` rebuilds the zone between lattice and boundary around the moved lattice.
//! `reference`, `remesh` and `on_reference` mesh on the surface itself. `deviation` compares a mesh with its surface.
//!
//! ```
//! use plateau_uniform_mesh::{Domain, Objective, Options, solve};
//! use plateau_mesh::{DVec3, Execution};
//!
//! let corners = [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [0.0, 20.0]];
//! let outer = corners.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
//! let options = Options::new(2.0, Objective::MostEqualEdges);
//! let floor = solve(&Domain::Polygon { outer, holes: Vec::new() }, &options, &Execution::default())?;
//! assert!(floor.out_of_range.is_empty());
//! assert!(floor.statistics.equal_edges > floor.statistics.edges / 2);
//! # Ok::<(), plateau_mesh::Error>(())
//! ```

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
#![deny(missing_docs)]

mod edges;
mod measure;
mod on_polygon;
mod on_surface;
mod options;
mod plane;
mod report;
mod solve;
pub mod statistics;
mod surface;

pub use options::{Domain, Objective, Optimise, Options, Transition};
pub use report::{LengthsRow, Method, OutOfRange, Statistics, SurfaceFit, UniformMesh, Why};
pub use solve::{check, estimate, solve};
pub use surface::nurbs::Nurbs;

/// Compiles and runs the example of the README with the other doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
