//! Meshing of curved domains. Lengths are in units of ℓ, and coordinates are relative to the surface's centre.

pub(super) mod auxiliary;
mod curves;
pub(super) mod deviation;
pub(super) mod flatten;
pub(super) mod least_squares;
pub(super) mod lengths;
pub(super) mod move_nodes;
pub(super) mod nurbs;
pub(super) mod on_reference;
pub(super) mod reference;
pub(super) mod remesh;
mod rim_flips;
mod tessellation;
pub(super) mod transition;
