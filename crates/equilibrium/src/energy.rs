//! Energies of triangle meshes and line elements. Each energy has its value, its gradient and its second variation. The
//! documentation of each states the formula and its source.
//!
//! A [`Term`] is an energy over all vertices of a body: a sum over elements of a few vertices each. The solver uses
//! terms only through this trait. `docs/adding-an-energy.md` shows how to add one. A film whose vertices only move
//! along their normals takes the fast path of [`area`], which assembles the same second variation with one number in
//! place of a block per pair of vertices.

pub mod area;
pub mod cable;
pub mod dirichlet;
#[cfg(test)]
pub(crate) mod finite_differences;
pub mod length;
pub mod load;
pub mod prestress;
pub mod volume;
pub mod weight;

use glam::DMat3;
use plateau_mesh::DVec3;
use std::fmt;

pub use area::Area;
pub use cable::{Cable, CableCondition};
pub use length::Length;
pub use load::Load;
pub use prestress::{ForceDensity, PlaneStress, Prestress};
pub use volume::Volume;
pub use weight::Weight;

/// The matrix a bᵀ.
pub(crate) fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

/// An energy over the vertices of a body.
///
/// [`value`](Self::value), [`add_gradient`](Self::add_gradient) and
/// [`add_second_derivative`](Self::add_second_derivative) must belong together: the gradient is the derivative of the
/// value, and the second derivative is the derivative of the gradient. The tests of every term compare them with finite
/// differences.
pub trait Term: fmt::Debug {
    /// The energy at the positions `at` of all vertices.
    fn value(&self, at: &[DVec3]) -> f64;

    /// Adds the derivative of the value by each vertex's position to `gradient`.
    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]);

    /// Calls `add(v, w, block)` with parts of the second derivative ∂²E / ∂x_v ∂x_w: for every pair of vertices of an
    /// element in both orders, and for v = w. The part that is positive semidefinite in each element is multiplied by
    /// `1 + shift`. If every motion has such a part, a large enough `shift` makes an indefinite matrix definite.
    fn add_second_derivative(&self, at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3));

    /// Calls `add(stiffness, gradient)` for each part `stiffness · gradient gradientᵀ` of the second derivative that
    /// couples all vertices of the term. An example is the stiffness of a cable whose force depends on its whole
    /// length. [`add_second_derivative`](Self::add_second_derivative) leaves these parts out. Most terms have none.
    fn visit_rank_one_parts(&self, _at: &[DVec3], _add: &mut dyn FnMut(f64, &[DVec3])) {}

    /// Calls `visit(v, w, k)` with springs of stiffness k between the vertices v and w. With the displacements d, the
    /// energy ½ Σ k |d_w - d_v|² of the springs is added to the linear approximation of this term at `at`. The sum is
    /// an upper bound of the term that equals it at `at`; terms that are exceptions say so. A term that is linear or
    /// lies below its tangent needs no springs. The settling of form finding uses them (`settling`).
    fn visit_springs(&self, _at: &[DVec3], _visit: &mut dyn FnMut(u32, u32, f64)) {}

    /// Whether all directions of the term, such as the one that points up, are unit vectors.
    fn has_unit_directions(&self) -> bool {
        true
    }

    /// Calls `visit` with the vertices of each element. The second derivative has no block for two vertices without a
    /// common element.
    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32]));

    /// Adds to each vertex its share of tension times size (of σ A for a surface, of T L for a line). This share is the
    /// scale of the forces on the vertex, and its mass. A term without tension adds nothing.
    fn add_shares(&self, _at: &[DVec3], _shares: &mut [f64]) {}

    /// Calls `visit` with the force in each line element, in order. The force is positive in tension. Surfaces have no
    /// such forces.
    fn visit_forces(&self, _at: &[DVec3], _visit: &mut dyn FnMut(f64)) {}

    /// Renews coefficients that are constant during a solve but depend on the equilibrium that the solve found, such as
    /// a force density from a target force, or a reference configuration. Returns the largest relative change. Most
    /// terms have no such coefficients and return 0.
    fn renew(&mut self, _at: &[DVec3]) -> f64 {
        0.0
    }
}

/// An equation that determines the multiplier of a constrained quantity, in place of a given value of the quantity.
/// Example: a heavy cable with a given horizontal component. Its length is not known, and the multiplier of the length
/// is a force.
pub trait Condition: fmt::Debug {
    /// The value of the equation, which must become 0, and its derivative by the multiplier.
    fn value(&self, at: &[DVec3], multiplier: f64) -> (f64, f64);

    /// Adds the derivative of the value by each vertex's position to `gradient`.
    fn add_gradient(&self, at: &[DVec3], multiplier: f64, gradient: &mut [DVec3]);

    /// The magnitude against which the value of the equation is measured: the equation is met if its value is small
    /// against this.
    fn scale(&self, at: &[DVec3]) -> f64;
}
