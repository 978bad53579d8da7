//! The foundation of the other crates: triangle meshes, sparse symmetric systems, plane triangulation, remeshing.
//!
//! All other crates of the geometry use this crate. Its interface is not stable: it changes whenever one of them needs
//! a change. Parts that only these crates need are left out of the documentation.
//!
//! # Glossary
//! - *Polyline*: points in order, `&[DVec3]`. A closed polyline does not repeat its first point.
//! - *Mesh*: an indexed, oriented triangle mesh ([`Mesh`]) in double precision. Connectivity ([`topology`]) never sees
//!   positions; [`edit`] changes it; [`measure`] and [`check`] see both.
//! - *Half-edge*: one side of an edge, in one triangle and with its direction ([`topology`]).
//! - *Flipped triangle*: its normal points against the normals of its vertices. *Degenerate triangle*: its shortest
//!   altitude is below 1e-10 of its longest edge.
//!
//! # Units and conventions
//! Lengths are in the caller's unit, angles in radians, curvatures in 1/unit. No code assumes metres or an up axis.
//! Results depend only on the arguments, not on a clock, thread pool, file or random source. The same build gives the
//! same bytes for the same arguments. If faer factorises a system, this holds only on processors with the same vector
//! instructions.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
#![warn(missing_docs)]

#[doc(hidden)]
pub mod axis_box;
#[doc(hidden)]
pub mod box_tree;
pub mod check;
pub mod codes;
pub mod complex;
#[doc(hidden)]
pub mod crossing;
mod cut;
#[doc(hidden)]
pub mod disjoint_sets;
pub mod edit;
pub mod error;
mod estimate;
pub mod execution;
#[doc(hidden)]
pub mod film;
pub mod measure;
#[doc(hidden)]
pub mod order;
#[doc(hidden)]
pub mod plane;
pub mod polyline;
pub mod random;
#[doc(hidden)]
pub mod remesh;
pub mod self_intersections;
#[doc(hidden)]
pub mod sparse;
#[doc(hidden)]
pub mod structured;
pub mod topology;

pub use codes::{Reason, WarningCode};
pub use error::{Error, InputError, Place};
pub use estimate::Estimate;
pub use execution::{Execution, Interruption, Progress, Signal};
pub use glam::{DVec2, DVec3};

/// An indexed triangle mesh. Triangles run counter-clockwise, seen from the side to which the normals point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions.
    pub vertices: Vec<DVec3>,
    /// For each triangle, the numbers of its vertices.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A mesh of these vertices and triangles. They are not checked here; see [`check`](Self::check).
    #[must_use]
    #[inline]
    pub fn new(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Self {
        Self { vertices, triangles }
    }

    /// The three corners of a triangle.
    #[must_use]
    #[inline]
    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|vertex| self.vertices[vertex as usize])
    }
}

/// Compiles and runs the example of the README with the other documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
