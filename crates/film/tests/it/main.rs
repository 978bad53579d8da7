//! Tests of minimal surfaces, tensile structures and cable nets by the public interface of the crate.

mod best_of_all_starts;
mod boundaries;
mod cable_nets;
mod cornered_boundaries;
mod cushions;
mod first_points;
mod forces;
mod initial_meshes;
mod kept_film;
mod liu_wang;
mod memory;
mod minimal_closed_forms;
mod minimal_properties;
mod random_boundaries;
mod random_structures;
mod rings_near_the_limit;
mod rings_on_a_sphere;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;
mod sliding_edges;
mod tensile_structures;
mod topologies;
mod travelling;
mod vertex_relaxation;
