//! Vertices that slide along a film until the gradient of its area has hardly any part along the surface.
//!
//! A film whose area no motion along its normals lowers is a minimal surface, but how its triangles lie on the surface
//! still changes the area a little. Chen, Cai and Zheng ("Constructing triangular meshes of minimal area", section 3)
//! measure the whole gradient, in which the layout of the triangles shows.

use super::small_angles::least_tangent;
use crate::film::Film;
use crate::{DVec3, Execution, Interruption};
use glam::DMat3;

// Tunables. The figures in docs/papers/chen-cai-zheng.md were obtained with these values.

/// Number of sweeps over the vertices. Further sweeps lower the largest gradient, but make angles smaller.
pub const SWEEPS: u32 = 4;
/// The last sweeps visit a vertex again if half its gradient, divided by the area of its ring and multiplied by the
/// radius of the boundary, exceeds this.
const UNEVEN: f64 = 1.6e-2;
/// Part of the trace that is added to a vertex's second derivative, which is singular where the ring is plane.
const DAMPING: f64 = 3e-3;
/// Longest step, as a fraction of the shortest edge at the vertex. Longer steps turn triangles over.
const REACH: f64 = 0.25;
/// A vertex stays where it is if the figure that [`UNEVEN`] limits is below this.
const NEGLIGIBLE: f64 = 3e-3;
/// No step makes an angle smaller than the one with this tangent, 21 degrees. Films have to keep angles of 20 degrees,
/// and the motion along the normals that follows may make angles smaller again.
const LEAST_TANGENT: f64 = 0.383_864;
/// Number of vertices that slide between two looks at the signal.
const VERTICES_BETWEEN_LOOKS: usize = 4096;
/// Units of work of one vertex: its six triangles are measured, and measured again for each part of a step.
const WORK_PER_VERTEX: u64 = 20;
/// Fractions of a step that are tried in this order. The first that keeps the angles is taken.
const PARTS: [f64; 3] = [1.0, 0.5, 0.25];

/// Lets the free vertices of a film slide to where the area of their rings is least, one after the other, in sweeps
/// that run forwards and backwards in turn. The connectivity stays.
///
/// The area of a ring is a convex function of its vertex x, with the gradient Σ n × e / 2 and the second derivative
/// Σ |e|²/(4A) n nᵀ, where n and A are the normal and the area of a triangle and e is its edge opposite to x. A sweep
/// takes a damped step of Newton's method. No step takes an angle below 21 degrees, or below the ring's smallest angle
/// if that is less. `radius` is the radius of the boundary. The first `full` of the [`SWEEPS`] visit every vertex, and
/// the others those whose gradient was large when they were visited last.
///
/// # Errors
/// The interruptions of `exec`. Some vertices have slid then, and others have not.
pub fn slide(film: &mut Film, radius: f64, full: u32, exec: &Execution) -> Result<(), Interruption> {
    let mut visited: Vec<u32> = (0..film.vertices.len() as u32).filter(|&v| !film.fixed[v as usize]).collect();
    let mut ring = Vec::new();
    for sweep in 0..SWEEPS {
        let mut uneven = Vec::new();
        for (k, &v) in visited.iter().enumerate() {
            if k % VERTICES_BETWEEN_LOOKS == 0 {
                exec.look(WORK_PER_VERTEX * VERTICES_BETWEEN_LOOKS as u64)?;
            }
            let edges = film.topology.outgoing_half_edges(v);
            ring.clear();
            ring.extend(
                edges.map(|h| [film.topology.to(h), film.topology.opposite(h)].map(|w| film.vertices[w as usize])),
            );
            let (place, gradient) = slid(film.vertices[v as usize], &ring, radius);
            film.vertices[v as usize] = place;
            if gradient > UNEVEN {
                uneven.push(v);
            }
        }
        if sweep + 1 >= full {
            visited = uneven;
        }
        visited.reverse();
    }
    Ok(())
}

/// Returns the place of a vertex after one step, and half the gradient before the step, divided by the area of the ring
/// and multiplied by the radius. `ring` has the edges opposite to the vertex in its triangles.
fn slid(here: DVec3, ring: &[[DVec3; 2]], radius: f64) -> (DVec3, f64) {
    let (mut gradient, mut second, mut trace) = (DVec3::ZERO, DMat3::ZERO, 0.0);
    let (mut double_area, mut shortest, mut smallest) = (0.0, f64::INFINITY, LEAST_TANGENT);
    for &[from, to] in ring {
        let edge = to - from;
        let normal = edge.cross(here - from);
        let doubled = normal.length();
        if doubled == 0.0 {
            return (here, 0.0);
        }
        let normal = normal / doubled;
        let weight = edge.length_squared() / doubled;
        gradient += normal.cross(edge);
        second += DMat3::from_cols(weight * normal.x * normal, weight * normal.y * normal, weight * normal.z * normal);
        trace += weight;
        double_area += doubled;
        shortest = shortest.min(from.distance_squared(here));
        smallest = smallest.min(least_tangent([here, from, to]));
    }
    let size = gradient.length() * radius / (2.0 * double_area);
    if size < NEGLIGIBLE {
        return (here, size);
    }
    let step = -((second + DMat3::from_diagonal(DVec3::splat(DAMPING * trace))).inverse() * gradient);
    let step = step * (REACH * shortest.sqrt() / step.length()).min(1.0);
    let keeps = |place: DVec3| ring.iter().all(|&[from, to]| least_tangent([place, from, to]) >= smallest);
    (PARTS.iter().map(|part| here + *part * step).find(|&place| keeps(place)).unwrap_or(here), size)
}
