//! The kinds of requests. Each has a file with its types, its checks and its way to the solver.

pub mod cable_net;
pub mod minimal_surface;
pub mod ruled_surface;
pub mod tensile_structure;
pub mod uniform_mesh;

use crate::objective::Objective;

/// Returns the objectives of every kind.
#[must_use]
pub fn objectives() -> Vec<Objective> {
    let mut objectives = ruled_surface::objectives();
    objectives.extend(minimal_surface::objectives());
    objectives.extend(uniform_mesh::objectives());
    objectives.extend(tensile_structure::objectives());
    objectives.extend(cable_net::objectives());
    objectives
}
