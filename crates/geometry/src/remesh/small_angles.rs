//! Widens small angles one triangle at a time: flips, collapses and moves around a thin triangle, each of which raises
//! the smallest angle of the triangles that it changes.
//!
//! Source: Freitag, Ollivier-Gooch, *Tetrahedral mesh improvement using swapping and smoothing* (1997), on a surface.
//! Departures:
//! - Only the triangles below a goal are treated, thinnest first. The rest of the mesh keeps its bits.
//! - A flipped triangle (its normal points against those of its vertices) counts as one with an angle of zero.
//! - An interior edge may also collapse. At a corner of the boundary this takes triangles out of a fan that is too
//!   dense for the corner's angle, which no flip and no move does.
//!
//! The surface changes where its triangles are large for its curvature. A solver brings it back afterwards.

use crate::mesh::edit::may_collapse;
use crate::mesh::film::Film;
use crate::mesh::measure::double_area_vector;
use crate::mesh::topology::NONE;
use crate::{DVec3, Execution, Interruption};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A change must raise the smallest angle by at least this much (radians). A larger value ends sooner; without it the
/// changes could go on by ever smaller gains.
const LEAST_GAIN: f64 = 0.01;
/// Cosine of the largest angle between a changed triangle and the mean of the triangles around it. A smaller value
/// allows sharper folds.
const LEAST_COSINE: f64 = 0.3;
/// Largest number of changes for each triangle that is below the goal at first.
const CHANGES_PER_TRIANGLE: usize = 16;
/// Number of directions in which a vertex is moved on trial.
const DIRECTIONS: usize = 8;
/// First length of such a move, as a fraction of the mean edge at the vertex, and how often it is halved.
const FIRST_MOVE: f64 = 0.4;
const HALVINGS: u32 = 4;

/// An angle with a total order.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Angle(f64);

impl Eq for Angle {}
impl PartialOrd for Angle {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Angle {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

#[derive(Clone, Copy, Debug)]
enum Change {
    Flip(u32),
    /// The first vertex stays, at the place, and the second merges into it.
    Collapse(u32, u32, DVec3),
    Move(u32, DVec3),
}

/// Smallest angle of a film, in radians.
pub(crate) fn smallest_angle(film: &Film) -> f64 {
    film.triangles().iter().map(|&t| least_tangent(film.corners(t))).fold(f64::INFINITY, f64::min).atan()
}

/// Raises the angles below `goal` (radians) as far as single changes can. Fixed vertices and locked edges stay.
///
/// Returns for each vertex of the film its number before, or `None` if nothing changed.
///
/// # Errors
/// The interruptions of `exec`; the film is then as it was before.
pub(crate) fn widen(film: &mut Film, goal: f64, exec: &Execution) -> Result<Option<Vec<u32>>, Interruption> {
    let mut widening = Widening { film: film.clone(), goal, thin: BinaryHeap::new() };
    (0..film.triangles().len() as u32).for_each(|t| widening.consider(t));
    let (most, mut changes) = (CHANGES_PER_TRIANGLE * widening.thin.len(), 0);
    while let Some(Reverse((Angle(angle), t))) = widening.thin.pop() {
        // A triangle that has changed since it was queued was queued again with its new angle.
        if widening.film.topology.is_removed(t) || widening.angle(t).total_cmp(&angle).is_ne() {
            continue;
        }
        exec.look(100)?;
        if let Some(change) = widening.best_change(t) {
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

/// The smallest angle of a triangle, which is never obtuse: the least tangent of its acute angles. 0 if it has no area.
fn least([a, b, c]: [DVec3; 3]) -> f64 {
    least_tangent([a, b, c]).atan()
}

fn least_tangent([a, b, c]: [DVec3; 3]) -> f64 {
    let (u, v, w) = (b - a, c - b, a - c);
    let double_area = u.cross(w).length();
    if double_area == 0.0 {
        return 0.0;
    }
    // The cosine times both lengths at each corner: the largest belongs to the smallest tangent.
    double_area / (-u.dot(w)).max(-v.dot(u)).max(-w.dot(v))
}

/// The smallest angle of some triangles. `None` if one of them leans too far from the direction of all together.
fn quality(triangles: impl Iterator<Item = [DVec3; 3]>, direction: DVec3) -> Option<f64> {
    let mut smallest = f64::INFINITY;
    for corners in triangles {
        let normal = double_area_vector(corners);
        if normal.dot(direction) <= LEAST_COSINE * normal.length() {
            return None;
        }
        smallest = smallest.min(least_tangent(corners));
    }
    // The arc tangent grows with the tangent, so that one is enough for all triangles.
    Some(smallest.atan())
}

#[derive(Debug)]
struct Widening {
    film: Film,
    goal: f64,
    /// The thin triangles by angle, then by number. The thinnest comes first.
    thin: BinaryHeap<Reverse<(Angle, u32)>>,
}

impl Widening {
    /// The smallest angle of a triangle; 0 if it is flipped: its normal points away from those of its vertices. Only
    /// a triangle that leans away from a neighbour is compared with them.
    fn angle(&self, t: u32) -> f64 {
        let film = &self.film;
        let area_vector = |t: u32| double_area_vector(film.corners(film.triangles()[t as usize]));
        let own = area_vector(t);
        let leans_away = |h: u32| {
            let twin = film.topology.twin[h as usize];
            twin != NONE && area_vector(twin / 3).dot(own) < 0.0
        };
        let triangle = film.triangles()[t as usize];
        let vertex_normal = |v: u32| {
            let around: DVec3 = film.topology.outgoing_half_edges(v).map(|h| area_vector(h / 3)).sum();
            around.normalize_or_zero()
        };
        let is_flipped =
            (3 * t..3 * t + 3).any(leans_away) && triangle.into_iter().map(vertex_normal).sum::<DVec3>().dot(own) < 0.0;
        if is_flipped { 0.0 } else { least(film.corners(triangle)) }
    }

    fn consider(&mut self, t: u32) {
        let angle = self.angle(t);
        if angle < self.goal {
            self.thin.push(Reverse((Angle(angle), t)));
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
        let before = [corners([a, b, c]), corners([b, a, d])];
        let after = [corners([d, c, a]), corners([c, d, b])];
        let direction = before.map(double_area_vector).into_iter().sum::<DVec3>().normalize_or_zero();
        let reached = quality(after.into_iter(), direction)?;
        Some((reached - self.angle(h / 3).min(self.angle(twin / 3)), Change::Flip(h)))
    }

    /// The better of the collapses of an edge into its ends or its middle.
    fn collapse(&self, h: u32) -> Option<(f64, Change)> {
        let film = &self.film;
        let (a, b) = (film.topology.from(h), film.topology.to(h));
        let is_fixed = |v: u32| film.fixed[v as usize];
        let (stays, leaves) = if is_fixed(b) { (b, a) } else { (a, b) };
        if is_fixed(leaves) || !may_collapse(&film.topology, stays, leaves) {
            return None;
        }
        let around = || {
            let of = |v: u32, other: u32| {
                let numbers = film.topology.outgoing_half_edges(v).map(|h| h / 3);
                numbers.map(move |t| (t, film.triangles()[t as usize].contains(&other)))
            };
            of(stays, leaves).chain(of(leaves, stays).filter(|(_, both)| !both))
        };
        let mut before = f64::INFINITY;
        let mut direction = DVec3::ZERO;
        for (t, _) in around() {
            before = before.min(self.angle(t));
            direction += double_area_vector(film.corners(film.triangles()[t as usize]));
        }
        let direction = direction.normalize_or_zero();
        let (p, q) = (film.vertices[stays as usize], film.vertices[leaves as usize]);
        let places = [p, 0.5 * (p + q), q];
        let mut best: Option<(f64, Change)> = None;
        for &place in if is_fixed(stays) { &places[..1] } else { &places[..] } {
            let moved = |t: u32| {
                let corner = |v: u32| if v == stays || v == leaves { place } else { film.vertices[v as usize] };
                film.triangles()[t as usize].map(corner)
            };
            let left = around().filter(|(_, both)| !both).map(|(t, _)| moved(t));
            if let Some(reached) = quality(left, direction)
                && best.is_none_or(|(gain, _)| reached - before > gain)
            {
                best = Some((reached - before, Change::Collapse(stays, leaves, place)));
            }
        }
        best
    }

    /// The best move of a vertex within its tangent plane that a search in a few directions finds.
    fn movement(&self, v: u32) -> Option<(f64, Change)> {
        let film = &self.film;
        if film.fixed[v as usize] {
            return None;
        }
        let start = film.vertices[v as usize];
        let ring: Vec<[DVec3; 2]> = film
            .topology
            .outgoing_half_edges(v)
            .map(|h| [film.topology.to(h), film.topology.opposite(h)].map(|w| film.vertices[w as usize]))
            .collect();
        let direction = ring.iter().map(|&[j, k]| double_area_vector([start, j, k])).sum::<DVec3>().normalize_or_zero();
        if direction == DVec3::ZERO {
            return None;
        }
        let reached = |place: DVec3| quality(ring.iter().map(|&[j, k]| [place, j, k]), direction);
        let triangles = film.topology.outgoing_half_edges(v).map(|h| h / 3);
        let before = triangles.map(|t| self.angle(t)).fold(f64::INFINITY, f64::min);
        let size = ring.iter().map(|[j, _]| j.distance(start)).sum::<f64>() / ring.len() as f64;
        let across = direction.any_orthonormal_vector();
        let along = direction.cross(across);
        let (mut place, mut best, mut length) = (start, before, FIRST_MOVE * size);
        for _ in 0..HALVINGS {
            for k in 0..DIRECTIONS {
                let (sine, cosine) = (std::f64::consts::TAU * k as f64 / DIRECTIONS as f64).sin_cos();
                let tried = place + length * (cosine * across + sine * along);
                if let Some(angle) = reached(tried)
                    && angle > best
                {
                    (place, best) = (tried, angle);
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
        around.into_iter().for_each(|t| self.consider(t));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::measure;
    use crate::mesh::structured::shaken;

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

    /// A corner of 60 degrees with a fan of six triangles of 10 degrees each.
    #[test]
    fn a_fan_that_is_too_dense_for_its_corner_loses_triangles() {
        let at = |degrees: f64, radius: f64| {
            let (y, x) = degrees.to_radians().sin_cos();
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
