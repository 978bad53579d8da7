//! Meshing of planar domains. Lengths are in units of ℓ, and coordinates are in the domain's plane.

pub(super) mod increment;
pub(super) mod lattice;
pub(super) mod mesh;
pub(super) mod polygon;
pub(super) mod sides;
