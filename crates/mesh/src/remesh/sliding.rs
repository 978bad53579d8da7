//! Slides the vertices of a film along its surface until the gradient of the area has hardly any tangential part.
//!
//! If no motion along the normals lowers the area, the film is a minimal surface. The layout of the triangles on the
//! surface still changes the area a little. Chen, Cai and Zheng ("Constructing triangular meshes of minimal area",
//! section 3) measure the whole gradient, which includes this tangential part.

use super::small_angles::least_tangent;
use crate::film::Film;
use crate::{DVec3, Execution, Interruption};
use glam::DMat3;

// Tunables. The figures in docs/papers/chen-cai-zheng.md were obtained with these values.

/// Number of sweeps over all vertices of a film that is solved directly. Further sweeps over all of them make angles
/// smaller.
pub const FULL_SWEEPS: u32 = 4;
/// Number of sweeps in total. The last ones visit few vertices: together they take about a hundredth of a solve.
const SWEEPS: u32 = 12;
/// Number of sweeps after which the neighbours of uneven vertices are visited too, because their motion may free a
/// vertex that an angle keeps in its place.
const WITHOUT_NEIGHBOURS: u32 = 3;
/// A vertex is uneven, and the last sweeps visit it again, if its dimensionless gradient exceeds this: half its
/// gradient divided by the area of its ring and multiplied by the radius of the boundary. At 5e-3, the gradients of
/// Chen, Cai and Zheng's helicoid end near half of their printed 7e-4, which is 8e-3 here.
const UNEVEN: f64 = 5e-3;
/// Multiple of the identity that is added to a vertex's second derivative, as a fraction of its trace. The second
/// derivative is singular if the ring is plane.
const DAMPING: f64 = 3e-3;
/// Longest step, as a fraction of the shortest edge at the vertex. Longer steps turn triangles over.
const REACH: f64 = 0.25;
/// A vertex does not move if its dimensionless gradient (see [`UNEVEN`]) is below this.
const NEGLIGIBLE: f64 = 3e-3;
/// Tangent of 21 degrees, the smallest angle that a step may produce. Films have to keep angles of 20 degrees, and the
/// motion along the normals that follows may make angles smaller again.
const LEAST_TANGENT: f64 = 0.383_864;
/// Number of vertices that are moved between two calls of [`Execution::look`].
const VERTICES_BETWEEN_LOOKS: usize = 4096;
/// Work for one vertex, as passed to [`Execution::look`]. Its six triangles are measured, and measured again for each
/// fraction of a step.
const WORK_PER_VERTEX: u64 = 20;
/// Fractions of a step, in the order in which they are tried. The first fraction that keeps the angles is taken.
const PARTS: [f64; 3] = [1.0, 0.5, 0.25];
/// Tangents of the angles by which a step is turned if an angle blocks all of its fractions.
const TURNS: [f64; 8] = [0.5, -0.5, 1.0, -1.0, 2.0, -2.0, 4.0, -4.0];

/// Thresholds of a call of [`slide_by`].
#[derive(Clone, Copy, Debug)]
pub struct Sliding {
    /// Number of sweeps that visit every vertex.
    pub full_sweeps: u32,
    /// A vertex is visited again in the last sweeps if its dimensionless gradient exceeds this: half its gradient
    /// divided by the area of its ring and multiplied by the radius of the boundary.
    pub uneven: f64,
    /// A vertex does not move if its dimensionless gradient is below this.
    pub negligible: f64,
    /// Tangent of the smallest angle that a step may produce.
    pub least_tangent: f64,
}

/// Moves the free vertices of a film, one after the other, to where the area of their rings is least, in sweeps that
/// run alternately forwards and backwards. The connectivity does not change.
///
/// The area of a ring is a convex function of its vertex x, with the gradient Σ n × e / 2 and the second derivative Σ
/// |e|²/(4A) n nᵀ. Here n and A are the normal and the area of a triangle, and e is its edge opposite x. A sweep takes
/// a damped step of Newton's method at each vertex. No step reduces an angle below 21 degrees, or below the ring's
/// smallest angle if that is less. A step that an angle blocks is turned within the film to where the area of the ring
/// is least. `radius` is the radius of the boundary. The first `full` sweeps visit every vertex. The other sweeps visit
/// the vertices whose gradient was large at their last visit, and in the end their neighbours.
///
/// # Errors
/// The interruptions of `exec`. Some vertices have then been moved, and others have not.
pub fn slide(film: &mut Film, radius: f64, full: u32, exec: &Execution) -> Result<(), Interruption> {
    let by = Sliding { full_sweeps: full, uneven: UNEVEN, negligible: NEGLIGIBLE, least_tangent: LEAST_TANGENT };
    slide_by(film, radius, by, exec)
}

/// Does the same as [`slide`] with thresholds of the caller.
///
/// # Errors
/// The errors of [`slide`].
pub fn slide_by(film: &mut Film, radius: f64, by: Sliding, exec: &Execution) -> Result<(), Interruption> {
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
            let (place, gradient) = slid(film.vertices[v as usize], &ring, radius, by);
            film.vertices[v as usize] = place;
            if gradient > by.uneven {
                uneven.push(v);
            }
        }
        if sweep + 1 >= by.full_sweeps {
            visited = uneven;
            if sweep >= WITHOUT_NEIGHBOURS {
                let topology = &film.topology;
                let neighbours = visited.iter().flat_map(|&v| topology.outgoing_half_edges(v).map(|h| topology.to(h)));
                let neighbours: Vec<u32> = neighbours.filter(|&v| !film.fixed[v as usize]).collect();
                visited.extend(neighbours);
                visited.sort_unstable();
                visited.dedup();
                // After an odd sweep the next one runs forwards, as the sorted list does.
                if sweep % 2 == 1 {
                    continue;
                }
            }
        }
        visited.reverse();
    }
    Ok(())
}

/// Returns the place of a vertex after one step, and its dimensionless gradient (see [`UNEVEN`]) before the step.
/// `ring` holds the edge opposite the vertex in each of its triangles.
fn slid(here: DVec3, ring: &[[DVec3; 2]], radius: f64, by: Sliding) -> (DVec3, f64) {
    let (mut gradient, mut second, mut trace) = (DVec3::ZERO, DMat3::ZERO, 0.0);
    let (mut double_area, mut shortest, mut smallest) = (0.0, f64::INFINITY, by.least_tangent);
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
    if size < by.negligible {
        return (here, size);
    }
    let step = -((second + DMat3::from_diagonal(DVec3::splat(DAMPING * trace))).inverse() * gradient);
    let step = step * (REACH * shortest.sqrt() / step.length()).min(1.0);
    let keeps = |place: DVec3| ring.iter().all(|&[from, to]| least_tangent([place, from, to]) >= smallest);
    if let Some(place) = PARTS.iter().map(|part| here + *part * step).find(|&place| keeps(place)) {
        return (place, size);
    }
    let area = |place: DVec3| ring.iter().map(|&[from, to]| (to - from).cross(place - from).length()).sum::<f64>();
    let side =
        ring.iter().map(|&[from, to]| (to - from).cross(here - from)).sum::<DVec3>().normalize_or_zero().cross(step);
    let turned = TURNS.iter().map(|turn| (step + *turn * side) / (1.0 + turn * turn));
    let places = turned.flat_map(|step| PARTS.map(|part| here + part * step)).filter(|&place| keeps(place));
    let (least, place) =
        places.map(|place| (area(place), place)).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, here));
    (if least < double_area { place } else { here }, size)
}
