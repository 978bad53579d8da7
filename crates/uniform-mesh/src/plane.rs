//! The planar problems: lengths in units of ℓ, coordinates in the domain's plane.

pub(super) mod increment;
pub(super) mod lattice;
pub(super) mod mesh;
pub(super) mod polygon;
pub(super) mod sides;
