//! Tests of minimal surfaces by the public interface of the crate.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod best_of_all_starts;
mod boundaries;
mod cornered_boundaries;
mod curvature_bound;
mod first_points;
mod initial_meshes;
mod kept_film;
mod liu_wang;
mod minimal_closed_forms;
mod minimal_properties;
mod random_boundaries;
mod rings_near_the_limit;
mod rings_on_a_sphere;
mod topologies;
mod vertex_relaxation;

/// Returns true if more cases are to be run than in the first tier of `scripts/test`.
fn is_full() -> bool {
    ["PLATEAU_FULL", "PLATEAU_LONG"].into_iter().any(|name| std::env::var_os(name).is_some())
}
