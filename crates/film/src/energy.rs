//! Energies of triangle meshes and line elements. Each has its value, its gradient and its second variation, with the
//! formula and the source in its documentation.
//!
//! A [`Term`] is an energy over all vertices of a body: a sum over elements of a few vertices each. The equilibrium
//! core ([`equilibrium`](crate::equilibrium)) knows terms only through this trait. `docs/adding-an-energy.md` shows how
//! to add one. Films whose vertices move along their normals alone take the fast path of [`area`], which assembles the
//! same second variation without a block per pair of vertices.

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
/// The three functions must belong together: the gradient is the derivative of the value, the second derivative that of
/// the gradient. The tests of every term compare them with finite differences.
pub trait Term: fmt::Debug {
    /// The energy at the positions `at` of all vertices.
    fn value(&self, at: &[DVec3]) -> f64;

    /// Adds the derivative of the value by each vertex's position to `gradient`.
    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]);

    /// Calls `add(v, w, block)` with parts of the second derivative ∂²E / ∂x_v ∂x_w: for every pair of vertices of one
    /// element in both orders, and for v = w. The part of the matrix that is positive semidefinite element by element
    /// counts `1 + shift` times, so that a large enough `shift` makes an indefinite matrix definite if every motion has
    /// such a part.
    fn add_second_derivative(&self, at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3));

    /// Calls `add(stiffness, gradient)` for each part `stiffness · gradient gradientᵀ` of the second derivative that
    /// couples all vertices of the term, such as the stiffness of a cable whose force depends on its whole length. It
    /// is not among the blocks of [`add_second_derivative`](Self::add_second_derivative). Most terms have none.
    fn visit_rank_one_parts(&self, _at: &[DVec3], _add: &mut dyn FnMut(f64, &[DVec3])) {}

    /// Calls `visit(v, w, k)` with springs of stiffness k between vertices. Their energy ½ Σ k |d_w - d_v|², with the
    /// displacements d, is added to the linear approximation of this energy at `at`. The sum is an upper bound of the
    /// energy, and equal to it at `at`; documentation names exceptions. An energy that is linear or lies below its
    /// tangent needs no springs. Form finding uses them to settle (`equilibrium::settling`).
    fn visit_springs(&self, _at: &[DVec3], _visit: &mut dyn FnMut(u32, u32, f64)) {}

    /// Whether all directions of the term, such as the one that points up, are unit vectors.
    fn has_unit_directions(&self) -> bool {
        true
    }

    /// Calls `visit` with the vertices of each element. Two vertices without a common element have no block.
    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32]));

    /// Adds to each vertex its share of tension times size (of σ A for a surface, of T L for a line): the scale of the
    /// forces there, and the vertex's mass. A term without tension adds nothing.
    fn add_shares(&self, _at: &[DVec3], _shares: &mut [f64]) {}

    /// Calls `visit` with the force in each line element, in order; positive in tension. Surfaces have none.
    fn visit_forces(&self, _at: &[DVec3], _visit: &mut dyn FnMut(f64)) {}

    /// Renews coefficients that are constant during one solve and depend on the equilibrium that the solve found (a
    /// force density from a target force, a reference configuration). Returns the largest relative change, or 0 if the
    /// term has no such coefficients, like most terms.
    fn renew(&mut self, _at: &[DVec3]) -> f64 {
        0.0
    }
}

/// An equation that determines the multiplier of a constrained quantity in place of the quantity's own value. Example:
/// a heavy cable with a given horizontal component. The multiplier of its length is a force, and the length is not
/// known.
pub trait Condition: fmt::Debug {
    /// The value that must vanish, and its derivative by the multiplier.
    fn value(&self, at: &[DVec3], multiplier: f64) -> (f64, f64);

    /// Adds the derivative of the value by each vertex's position to `gradient`.
    fn add_gradient(&self, at: &[DVec3], multiplier: f64, gradient: &mut [DVec3]);

    /// The value counts as vanishing if it is small against this.
    fn scale(&self, at: &[DVec3]) -> f64;
}
