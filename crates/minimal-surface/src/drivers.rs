//! Drivers that call a solver several times, for different topologies or resolutions.

pub(super) mod best_topology;
pub(super) mod curvature_bound;
pub(super) mod free_topology;
pub(super) mod nested;
mod sets;
