//! Equilibrium of a mesh: Newton's method on an energy, and the stability of what it finds.

pub(crate) mod newton;
pub(crate) mod stability;
pub(crate) mod v_cycle_steps;
