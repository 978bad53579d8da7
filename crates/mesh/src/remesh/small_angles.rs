//! Widens small angles one triangle at a time. Flips an edge, collapses an edge or moves a vertex around a thin
//! triangle. Each change raises the smallest angle of the triangles that it affects.
//!
//! Source: Freitag, Ollivier-Gooch, *Tetrahedral mesh improvement using swapping and smoothing* (1997), on a surface.
//! Departures:
//! - Only triangles with an angle below a goal are treated, thinnest first. The rest of the mesh stays bit for bit.
//! - A flipped triangle (its normal points against those of its vertices) counts as having an angle of zero.
//! - An interior edge may also collapse. At a corner of the boundary this removes triangles from a fan that has too
//!   many for the corner's angle. Neither a flip nor a move can do that.
//!
//! The changes alter the surface where its triangles are large compared with its radius of curvature. The caller's
//! solver restores the surface afterwards.

use crate::edit::may_collapse;
use crate::film::Film;
use crate::measure::double_area_vector;
use crate::order::TotalOrder;
use crate::topology::NONE;
use crate::{DVec3, Execution, Interruption};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Least increase of the smallest angle by a change, in radians. Without this bound the changes could go on with ever
/// smaller gains.
const LEAST_GAIN: f64 = 0.01;
/// Relative rounding error of a tangent. A triangle is rejected by its tangent alone, before its angle is computed,
/// only if the tangent is below that of the least useful angle by more than this.
const ROUNDING: f64 = 1e-12;
/// Cosine of the largest angle between a changed triangle and the mean of the triangles around it.
const LEAST_COSINE: f64 = 0.3;
/// Largest number of changes in total, per triangle that is below the goal at the start.
const CHANGES_PER_TRIANGLE: usize = 16;
/// Largest number of changes that are made for the same triangle. Without this bound two flips can undo each other
/// again and again: on a noisy boundary one pair of flips used up all changes of the mesh.
const MOST_CHANGES: u8 = 16;
/// Number of directions in which moves of a vertex are tried.
const DIRECTIONS: usize = 8;
/// Length of the first move that is tried, as a fraction of the mean edge length at the vertex.
const FIRST_MOVE: f64 = 0.4;
/// Number of lengths that are tried in each direction. Each is half the length before.
const HALVINGS: u32 = 4;

#[derive(Clone, Copy, Debug)]
enum Change {
    Flip(u32),
    /// The second vertex is merged into the first, which moves to the given place.
    Collapse(u32, u32, DVec3),
    Move(u32, DVec3),
}

/// Smallest angle of a film, in radians.
pub fn smallest_angle(film: &Film) -> f64 {
    libm::atan(film.triangles().iter().map(|&t| least_tangent(film.corners(t))).fold(f64::INFINITY, f64::min))
}

/// Raises angles below `goal` (radians) as far as single changes can. Fixed vertices and locked edges stay.
///
/// Returns the former number of each vertex of the film, or `None` if nothing changed.
///
/// # Errors
/// The interruptions of `exec`; the film is then as it was before.
pub fn widen(film: &mut Film, goal: f64, exec: &Execution) -> Result<Option<Vec<u32>>, Interruption> {
    let mut widening = Widening::new(film.clone(), goal);
    let (most, mut changes) = (CHANGES_PER_TRIANGLE * widening.thin.len(), 0);
    while let Some(Reverse((TotalOrder(angle), t))) = widening.thin.pop() {
        let state = &mut widening.states[t as usize];
        // A triangle that has changed since it was queued was queued again with its new angle.
        if widening.film.topology.is_removed(t) || state.queued.total_cmp(&angle).is_ne() {
            continue;
        }
        state.queued = f64::NAN;
        if state.changes == MOST_CHANGES {
            continue;
        }
        exec.look(100)?;
        if let Some(change) = widening.best_change(t) {
            widening.states[t as usize].changes += 1;
            widening.make(change);
            changes += 1;
            if changes == most {
                break;
            }
        }
    }
    if changes == 0 {
        return Ok(None);
    }
    let mut widened = widening.film;
    let stays = |v: &u32| widened.fixed[*v as usize] || widened.topology.outgoing[*v as usize] != NONE;
    let origin = (0..widened.vertices.len() as u32).filter(stays).collect();
    if widened.close_gaps().is_err() {
        debug_assert!(false, "the link condition keeps a manifold");
        return Ok(None);
    }
    *film = widened;
    Ok(Some(origin))
}

/// The smallest angle of a triangle in radians; 0 if the triangle has no area. The smallest angle has the least tangent
/// of the acute angles, because it is never obtuse.
fn least([a, b, c]: [DVec3; 3]) -> f64 {
    libm::atan(least_tangent([a, b, c]))
}

pub(super) fn least_tangent([a, b, c]: [DVec3; 3]) -> f64 {
    let (u, v, w) = (b - a, c - b, a - c);
    let double_area = u.cross(w).length();
    if double_area == 0.0 {
        return 0.0;
    }
    // The cosine times both side lengths at each corner. The largest of these belongs to the smallest tangent.
    double_area / (-u.dot(w)).max(-v.dot(u)).max(-w.dot(v))
}

/// The smallest angle of some triangles. `None` if the normal of one of them is too far from their common `direction`,
/// or if one has an angle whose tangent is below `useful`.
fn quality(triangles: impl Iterator<Item = [DVec3; 3]>, direction: DVec3, useful: f64) -> Option<f64> {
    let mut smallest = f64::INFINITY;
    for corners in triangles {
        let tangent = least_tangent(corners);
        if tangent < useful {
            return None;
        }
        let normal = double_area_vector(corners);
        if normal.dot(direction) <= LEAST_COSINE * normal.length() {
            return None;
        }
        smallest = smallest.min(tangent);
    }
    // The arc tangent grows with its argument, so that a single arc tangent is enough for all triangles.
    Some(libm::atan(smallest))
}

/// The argument `useful` of [`quality`] for an angle: an angle with a smaller tangent is certainly below it.
fn useful_tangent(angle: f64) -> f64 {
    libm::tan(angle) * (1.0 - ROUNDING)
}

#[derive(Clone, Copy, Debug)]
struct State {
    /// Twice the area vector.
    area_vector: DVec3,
    /// The smallest angle (radians); 0 if the triangle is flipped.
    angle: f64,
    /// The angle with which the triangle waits in the queue; NaN if it does not wait.
    queued: f64,
    /// Number of changes made so far to widen this triangle.
    changes: u8,
}

#[derive(Debug)]
struct Widening {
    film: Film,
    goal: f64,
    /// Sines and cosines of the directions in which moves of a vertex are tried.
    directions: [(f64, f64); DIRECTIONS],
    /// The state of each triangle. It is not kept up to date for removed triangles.
    states: Vec<State>,
    /// The queue of thin triangles, sorted by angle, then by number. The thinnest comes first.
    thin: BinaryHeap<Reverse<(TotalOrder, u32)>>,
}

impl Widening {
    fn new(film: Film, goal: f64) -> Self {
        let count = film.triangles().len();
        let unknown = State { area_vector: DVec3::ZERO, angle: 0.0, queued: f64::NAN, changes: 0 };
        let direction = |k: usize| libm::sincos(std::f64::consts::TAU * k as f64 / DIRECTIONS as f64);
        let directions = std::array::from_fn(direction);
        let mut widening = Self { film, goal, directions, states: vec![unknown; count], thin: BinaryHeap::new() };
        widening.consider(0..count as u32);
        widening
    }

    /// The smallest angle of a triangle, or 0 if the triangle is flipped: its normal points away from those of its
    /// vertices. The vertex normals are computed only if the triangle faces away from a neighbour, because otherwise it
    /// is not flipped.
    fn angle(&self, t: u32) -> f64 {
        let film = &self.film;
        let own = self.states[t as usize].area_vector;
        let leans_away = |h: u32| {
            let twin = film.topology.twin[h as usize];
            twin != NONE && self.states[twin as usize / 3].area_vector.dot(own) < 0.0
        };
        let triangle = film.triangles()[t as usize];
        let vertex_normal = |v: u32| {
            let around: DVec3 =
                film.topology.outgoing_half_edges(v).map(|h| self.states[h as usize / 3].area_vector).sum();
            around.normalize_or_zero()
        };
        let is_flipped =
            (3 * t..3 * t + 3).any(leans_away) && triangle.into_iter().map(vertex_normal).sum::<DVec3>().dot(own) < 0.0;
        if is_flipped { 0.0 } else { least(film.corners(triangle)) }
    }

    /// Computes the angles of new or changed triangles, and queues the thin ones. Whether a triangle is flipped depends
    /// on the triangles around its vertices. `triangles` must therefore contain every triangle that shares a vertex
    /// with a changed one.
    fn consider(&mut self, triangles: impl Iterator<Item = u32> + Clone) {
        for t in triangles.clone() {
            let triangle = self.film.triangles()[t as usize];
            self.states[t as usize].area_vector = double_area_vector(self.film.corners(triangle));
        }
        for t in triangles {
            let angle = self.angle(t);
            let state = &mut self.states[t as usize];
            state.angle = angle;
            // A triangle is queued only once for the same angle, because treating it again takes long and gives the
            // same result.
            if angle < self.goal && state.queued != angle {
                state.queued = angle;
                self.thin.push(Reverse((TotalOrder(angle), t)));
            }
        }
    }

    /// The change that raises the smallest angle around a triangle most.
    fn best_change(&self, t: u32) -> Option<Change> {
        let triangle = self.film.triangles()[t as usize];
        let mut best: Option<(f64, Change)> = None;
        let mut offer = |gain: Option<(f64, Change)>| {
            if let Some((gain, change)) = gain
                && gain >= best.map_or(LEAST_GAIN, |(best, _)| best)
            {
                best = Some((gain, change));
            }
        };
        for h in 3 * t..3 * t + 3 {
            offer(self.collapse(h));
            offer(self.flip(h));
        }
        triangle.into_iter().for_each(|v| offer(self.movement(v)));
        best.map(|(_, change)| change)
    }

    fn flip(&self, h: u32) -> Option<(f64, Change)> {
        let topology = &self.film.topology;
        let (a, b) = (topology.from(h), topology.to(h));
        if self.film.is_locked(a, b) || !topology.can_flip(h) {
            return None;
        }
        let twin = topology.twin[h as usize];
        let (c, d) = (topology.opposite(h), topology.opposite(twin));
        let corners = |t: [u32; 3]| self.film.corners(t);
        let after = [corners([d, c, a]), corners([c, d, b])];
        let [one, other] = [h / 3, twin / 3].map(|t| t as usize);
        let direction = (self.states[one].area_vector + self.states[other].area_vector).normalize_or_zero();
        let before = self.states[one].angle.min(self.states[other].angle);
        let reached = quality(after.into_iter(), direction, useful_tangent(before + LEAST_GAIN))?;
        Some((reached - before, Change::Flip(h)))
    }

    /// The best collapse of an edge: into one of its ends or its middle.
    fn collapse(&self, h: u32) -> Option<(f64, Change)> {
        let film = &self.film;
        let (a, b) = (film.topology.from(h), film.topology.to(h));
        let is_fixed = |v: u32| film.fixed[v as usize];
        let (stays, leaves) = if is_fixed(b) { (b, a) } else { (a, b) };
        if is_fixed(leaves) || !may_collapse(&film.topology, stays, leaves) {
            return None;
        }
        let around = || {
            let triangles_around = |v: u32, other: u32| {
                let numbers = film.topology.outgoing_half_edges(v).map(|h| h / 3);
                numbers.map(move |t| (t, film.triangles()[t as usize].contains(&other)))
            };
            triangles_around(stays, leaves).chain(triangles_around(leaves, stays).filter(|(_, both)| !both))
        };
        let mut before = f64::INFINITY;
        let mut direction = DVec3::ZERO;
        for (t, _) in around() {
            before = before.min(self.states[t as usize].angle);
            direction += self.states[t as usize].area_vector;
        }
        let direction = direction.normalize_or_zero();
        let useful = useful_tangent(before + LEAST_GAIN);
        let (p, q) = (film.vertices[stays as usize], film.vertices[leaves as usize]);
        let places = [p, 0.5 * (p + q), q];
        let mut best: Option<(f64, Change)> = None;
        for &place in if is_fixed(stays) { &places[..1] } else { &places[..] } {
            let moved = |t: u32| {
                let corner = |v: u32| if v == stays || v == leaves { place } else { film.vertices[v as usize] };
                film.triangles()[t as usize].map(corner)
            };
            let left = around().filter(|(_, both)| !both).map(|(t, _)| moved(t));
            if let Some(reached) = quality(left, direction, useful)
                && best.is_none_or(|(gain, _)| reached - before > gain)
            {
                best = Some((reached - before, Change::Collapse(stays, leaves, place)));
            }
        }
        best
    }

    /// The best move of a vertex within its tangent plane, found by a search in a few directions.
    fn movement(&self, v: u32) -> Option<(f64, Change)> {
        let film = &self.film;
        if film.fixed[v as usize] {
            return None;
        }
        let start = film.vertices[v as usize];
        let mut ring: Vec<(f64, [DVec3; 2])> = film
            .topology
            .outgoing_half_edges(v)
            .map(|h| {
                let ends = [film.topology.to(h), film.topology.opposite(h)].map(|w| film.vertices[w as usize]);
                (self.states[h as usize / 3].angle, ends)
            })
            .collect();
        let direction =
            ring.iter().map(|&(_, [j, k])| double_area_vector([start, j, k])).sum::<DVec3>().normalize_or_zero();
        if direction == DVec3::ZERO {
            return None;
        }
        let size = ring.iter().map(|(_, [j, _])| j.distance(start)).sum::<f64>() / ring.len() as f64;
        // The thinnest triangle comes first, because a move that does not widen it is useless.
        ring.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        let before = ring[0].0;
        let across = direction.any_orthonormal_vector();
        let along = direction.cross(across);
        let (mut place, mut best, mut length) = (start, before, FIRST_MOVE * size);
        let mut useful = useful_tangent(best);
        for _ in 0..HALVINGS {
            for &(sine, cosine) in &self.directions {
                let tried = place + length * (cosine * across + sine * along);
                let triangles = ring.iter().map(|&(_, [j, k])| [tried, j, k]);
                if let Some(angle) = quality(triangles, direction, useful)
                    && angle > best
                {
                    (place, best) = (tried, angle);
                    useful = useful_tangent(best);
                }
            }
            length *= 0.5;
        }
        Some((best - before, Change::Move(v, place)))
    }

    fn make(&mut self, change: Change) {
        let mut changed = Vec::with_capacity(4);
        match change {
            Change::Flip(h) => {
                self.film.topology.flip(h);
                let twin = self.film.topology.twin[h as usize];
                changed.extend([h, twin].map(|h| self.film.topology.from(h)));
                changed.extend([h, twin].map(|h| self.film.topology.opposite(h)));
            }
            Change::Collapse(stays, leaves, place) => {
                self.film.topology.collapse(stays, leaves);
                self.film.vertices[stays as usize] = place;
                changed.extend(self.film.topology.neighbours(stays));
                changed.push(stays);
            }
            Change::Move(v, place) => {
                self.film.vertices[v as usize] = place;
                changed.extend(self.film.topology.neighbours(v));
                changed.push(v);
            }
        }
        let mut around: Vec<u32> =
            changed.iter().flat_map(|&v| self.film.topology.outgoing_half_edges(v)).map(|h| h / 3).collect();
        around.sort_unstable();
        around.dedup();
        self.consider(around.into_iter());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure;
    use crate::structured::shaken;

    #[test]
    fn angles_of_a_shaken_square_are_widened_and_its_boundary_stays() {
        let mut film = shaken(12, 0.8);
        let before = film.clone();
        assert!(smallest_angle(&film) < 10f64.to_radians());
        let origin = widen(&mut film, 25f64.to_radians(), &Execution::default()).unwrap().unwrap();
        film.mesh().check().unwrap();
        assert!(smallest_angle(&film) > 22f64.to_radians(), "{}", smallest_angle(&film).to_degrees());
        assert_eq!((film.vertices.len(), measure::flipped_triangles(&film.mesh())), (origin.len(), 0));
        for (&v, &w) in film.boundaries[0].iter().zip(&before.boundaries[0]) {
            assert_eq!((film.vertices[v as usize], origin[v as usize]), (before.vertices[w as usize], w));
        }
    }

    /// A boundary corner of 60 degrees with a fan of six triangles of 10 degrees each.
    #[test]
    fn a_fan_that_is_too_dense_for_its_corner_loses_triangles() {
        let at = |degrees: f64, radius: f64| {
            let (y, x) = libm::sincos(degrees.to_radians());
            radius * DVec3::new(x, y, 0.0)
        };
        let mut vertices = vec![DVec3::ZERO];
        vertices.extend((0..7).map(|k| at(10.0 * f64::from(k), 1.0)));
        vertices.extend((0..4).map(|k| at(20.0 * f64::from(k), 1.6)));
        let mut triangles: Vec<[u32; 3]> = (1..7).map(|k| [0, k, k + 1]).collect();
        for k in 0..3 {
            let (inner, outer) = (1 + 2 * k, 8 + k);
            triangles.extend([
                [inner, outer, inner + 1],
                [inner + 1, outer, outer + 1],
                [inner + 1, outer + 1, inner + 2],
            ]);
        }
        let mut film = Film::new(vertices, &triangles, vec![vec![0, 1, 8, 9, 10, 11, 7]]).unwrap();
        widen(&mut film, 25f64.to_radians(), &Execution::default()).unwrap().unwrap();
        assert!(film.topology.degree(0) <= 3);
        assert!(smallest_angle(&film) > 19f64.to_radians(), "{}", smallest_angle(&film).to_degrees());
    }
}
