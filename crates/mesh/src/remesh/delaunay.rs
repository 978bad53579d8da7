//! Delaunay flips and tangential smoothing, which leave the surface where it is. Fixed vertices do not move, locked
//! edges stay, and no triangle turns over.

use super::flips::flip_where;
use super::passes::Connected;
use crate::film::Film;
use crate::measure::double_area_vector;
use crate::{DVec3, Execution, Interruption};

/// Flips edges whose two opposite angles sum to more than π, until there are none. Returns the number of flips.
///
/// An edge is not flipped if its two triangles form a fold of a right angle or more, before or after the flip. In the
/// plane the result is the (constrained) Delaunay triangulation.
///
/// # Errors
/// The interruption. The film is valid in that case too.
pub fn flip_to_delaunay(film: &mut Film, exec: &Execution) -> Result<u64, Interruption> {
    flip_where(film, |film, h| wants_flip(film, h, |_, _| true), exec)
}

/// Does the same as [`flip_to_delaunay`], but never creates an edge whose ends are both fixed. Two films over the same
/// boundary would share such an edge.
///
/// # Errors
/// The interruption. The film is valid in that case too.
pub fn flip_without_chords(film: &mut Film, exec: &Execution) -> Result<u64, Interruption> {
    let may = |film: &Film, [.., a, b]: [u32; 4]| !(film.fixed[a as usize] && film.fixed[b as usize]);
    flip_where(film, |film, h| wants_flip(film, h, may), exec)
}

/// Whether an edge should be flipped. `may` receives the four vertices of the edge's two triangles, and can refuse the
/// flip. The flipped edge connects the last two vertices.
fn wants_flip(film: &Film, h: u32, may: impl Fn(&Film, [u32; 4]) -> bool) -> bool {
    let Some(hinge) = film.topology.hinge(h) else { return false };
    let [p, q, r, s] = hinge.map(|v| film.vertices[v as usize]);
    let (left, right) = ((p - r, q - r), (q - s, p - s));
    let (left_normal, right_normal) = (left.0.cross(left.1), right.0.cross(right.1));
    let (left_area, right_area) = (left_normal.length(), right_normal.length());
    // The condition is that cot α + cot β is negative by more than rounding. It is multiplied by both areas, so that a
    // needle needs no division.
    let cotangents = left.0.dot(left.1) * right_area + right.0.dot(right.1) * left_area;
    let scale = left.0.length() * left.1.length() * right_area + right.0.length() * right.1.length() * left_area;
    if scale > 0.0 && cotangents >= -1e-9 * scale {
        return false;
    }
    let (first, second) = ((r - s).cross(p - s), (s - r).cross(q - r));
    let before = left_normal + right_normal;
    left_normal.dot(right_normal) >= 0.0
        && first.dot(second) > 0.0
        && first.dot(before) > 0.0
        && second.dot(before) > 0.0
        && !film.is_locked(hinge[0], hinge[1])
        && may(film, hinge)
}

/// A mesh whose vertices slide along its surface one by one.
pub trait Relaxed: Connected {
    /// The position of a vertex.
    fn position(&self, v: u32) -> DVec3;

    /// The unit normal of the surface at a vertex. `None` stands for that of the triangles around the vertex.
    fn normal(&self, _v: u32) -> Option<DVec3> {
        None
    }

    /// Upper bound of a step of a vertex.
    fn longest_step(&self, _v: u32) -> f64 {
        f64::INFINITY
    }

    /// Moves a vertex along the surface by a step in its tangent plane, and returns whether the triangles around it
    /// keep their shape. If they do not, the vertex stays.
    fn try_step(&mut self, v: u32, step: DVec3) -> bool;
}

impl Relaxed for Film {
    fn position(&self, v: u32) -> DVec3 {
        self.vertices[v as usize]
    }

    /// A step must not turn a triangle over or take nearly all of its area.
    fn try_step(&mut self, v: u32, step: DVec3) -> bool {
        let here = self.vertices[v as usize];
        let moved = here + step;
        let keeps = self.topology.outgoing_half_edges(v).all(|h| {
            let (j, k) = ring_edge(self, h);
            let (before, after) = (double_area_vector([here, j, k]), double_area_vector([moved, j, k]));
            // At least a twentieth of the area is left.
            after.dot(before) > 0.05 * before.length_squared()
        });
        if keeps {
            self.vertices[v as usize] = moved;
        }
        keeps
    }
}

/// Moves each free vertex within its tangent plane towards the area-weighted centroid of its ring, `rounds` times. The
/// vertices move one after the other, in the order of their numbers.
pub fn tangential_relaxation(film: &mut Film, rounds: u32) {
    for _ in 0..rounds {
        for v in 0..film.vertices.len() as u32 {
            if !film.fixed[v as usize] {
                relax(film, v);
            }
        }
    }
}

/// Moves a vertex within its tangent plane towards the area-weighted centroid of its ring. A step after which the
/// triangles of the ring do not keep their shape is halved up to twice, and then left out.
pub fn relax<M: Relaxed>(mesh: &mut M, v: u32) {
    let here = mesh.position(v);
    let (mut normal, mut centroid, mut weight) = (DVec3::ZERO, DVec3::ZERO, 0.0);
    for h in mesh.topology().outgoing_half_edges(v) {
        let (j, k) = ring_edge(mesh, h);
        let double_area = (j - here).cross(k - here);
        let area = double_area.length();
        normal += double_area;
        centroid += area * ((j - here) + (k - here)) / 3.0;
        weight += area;
    }
    let normal = mesh.normal(v).unwrap_or(normal.normalize_or_zero());
    if weight == 0.0 || normal == DVec3::ZERO {
        return;
    }
    let mut step = centroid / weight;
    step -= step.dot(normal) * normal;
    step = step.clamp_length_max(mesh.longest_step(v));
    for _ in 0..3 {
        if mesh.try_step(v, step) {
            return;
        }
        step *= 0.5;
    }
}

/// In the triangle of an outgoing half-edge, the ends of the edge opposite the start of the half-edge.
fn ring_edge<M: Relaxed>(mesh: &M, h: u32) -> (DVec3, DVec3) {
    (mesh.position(mesh.topology().to(h)), mesh.position(mesh.topology().opposite(h)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure;
    use crate::structured::shaken;

    #[test]
    fn in_the_plane_the_flips_end_with_empty_circumcircles() {
        let mut film = shaken(12, 0.0);
        assert!(flip_to_delaunay(&mut film, &Execution::default()).unwrap() > 10);
        for h in 0..film.topology.twin.len() as u32 {
            assert!(!(wants_flip(&film, h, |_, _| true) && film.topology.can_flip(h)));
            if let Some(hinge) = film.topology.hinge(h) {
                let [p, q, r, s] = hinge.map(|v| film.vertices[v as usize].truncate());
                let coord = |v: glam::DVec2| robust::Coord { x: v.x, y: v.y };
                assert!(robust::incircle(coord(p), coord(q), coord(r), coord(s)) <= 1e-9);
            }
        }
        assert_eq!(measure::flipped_triangles(&film.mesh()), 0);
        assert!((film.area() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn relaxation_and_flips_widen_the_smallest_angle_and_keep_the_boundary() {
        let mut film = shaken(12, 0.8);
        let before = (measure::angle_range(&film.mesh()).0, film.clone());
        for _ in 0..4 {
            tangential_relaxation(&mut film, 3);
            flip_to_delaunay(&mut film, &Execution::default()).unwrap();
        }
        let smallest = measure::angle_range(&film.mesh()).0;
        assert!(smallest > 30f64.to_radians() && before.0 < 10f64.to_radians(), "{}", smallest.to_degrees());
        for &v in &film.boundaries[0] {
            assert_eq!(film.vertices[v as usize], before.1.vertices[v as usize]);
        }
        film.mesh().check().unwrap();
    }

    #[test]
    fn locked_edges_outlive_the_flips() {
        let mut film = shaken(6, 0.0);
        let mut free = film.clone();
        flip_to_delaunay(&mut free, &Execution::default()).unwrap();
        let gone = (0..film.topology.twin.len() as u32)
            .map(|h| [film.topology.from(h), film.topology.to(h)])
            .find(|&[a, b]| a < b && !free.topology.are_adjacent(a, b))
            .unwrap();
        film.locked = vec![gone];
        flip_to_delaunay(&mut film, &Execution::default()).unwrap();
        assert!(film.topology.are_adjacent(gone[0], gone[1]));
    }
}
