//! Energies of triangle meshes: value, gradient and second variation of each, with formula and source.

pub(crate) mod area;
