//! Removes degenerate triangles by the rules of Bento and Cavalcanti, *Computação de Superfícies Mínimas Discretas*.
//! The rules can change the topology of the surface.
//!
//! A triangle with an angle below the threshold is treated by the first rule that fits it (their Fig. 3):
//! - (a) one small angle: the edge opposite it collapses, which removes two triangles;
//! - (b) an angle near 180° at a vertex of three triangles: the vertex is removed, and one triangle replaces the three;
//! - (c) an angle near 180° elsewhere: the edge opposite it is flipped.
//!
//! If rule (a) would leave two edges between the same vertices (their Fig. 5: a neck of three edges), the surface is
//! cut along the three edges. Each side is closed with a triangle, which rule (a) then removes. A component without a
//! boundary is removed.
//!
//! Departures from the paper, which make the rules terminate:
//! - The thinnest triangle is treated first, and a flip must increase the smallest angle of its two triangles. In the
//!   order of their Fig. 4, flips without this condition undo each other for ever. With the condition every step lowers
//!   the number of triangles, raises the angles, or cuts. A surface over k loops can be cut only a bounded number of
//!   times.
//! - If the edge opposite an angle near 180° cannot be flipped (it lies on the boundary, or the other diagonal exists
//!   already), the vertex with that angle is merged into the nearer end of the edge.
//! - A fixed vertex stays where it is. An edge between two fixed vertices does not collapse.

use crate::edit::may_collapse;
use crate::film::Film;
use crate::measure;
use crate::order::TotalOrder;
use crate::topology::NONE;
use crate::{DVec3, Execution, Interruption};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Number of visited triangles between two calls of [`Execution::look`].
const WORK_PER_LOOK: u64 = 100_000;

/// A change of topology at the place where a neck closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinch {
    /// The iteration in which it happened, from 1.
    pub iteration: u32,
    /// Where it happened.
    pub place: DVec3,
    /// The kind of change: `split` (a component became two), `handle_cut` (the component stayed connected), or
    /// `closed_component_removed`.
    pub what: &'static str,
}

/// The changes that the rules made to a film.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Number of collapsed edges, rule (a).
    pub collapses: u64,
    /// Number of removed vertices, rule (b).
    pub removals: u64,
    /// Number of flipped edges, rule (c).
    pub flips: u64,
    /// The changes of topology. Their `iteration` is 0; the caller sets it.
    pub pinches: Vec<Pinch>,
}

impl Changes {
    /// Whether anything changed.
    pub fn any(&self) -> bool {
        self.collapses + self.removals + self.flips > 0 || !self.pinches.is_empty()
    }
}

/// Whether necks may be cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Necks {
    Keep,
    Cut,
}

/// Applies the rules to the triangles with an angle below `degenerate_angle` (radians), until no rule applies to any of
/// them. The film stays an oriented manifold over the same boundary loops. Interior vertices may be removed or
/// duplicated.
///
/// Takes one pass over the triangles if no angle is below the threshold, otherwise O(triangles + changes · log).
///
/// # Errors
/// The interruptions of `exec`; the film is then as it was before.
pub fn remove_degenerate_triangles(
    film: &mut Film,
    degenerate_angle: f64,
    necks: Necks,
    exec: &Execution,
) -> Result<Changes, Interruption> {
    if !has_degenerate_triangles(film, degenerate_angle) {
        return Ok(Changes::default());
    }
    let mut rules = Rules {
        film: film.clone(),
        degenerate_angle,
        necks,
        thin: BinaryHeap::new(),
        changes: Changes::default(),
        work: 0,
    };
    for t in 0..film.triangles().len() as u32 {
        rules.consider(t);
    }
    // Ends because each change lowers the number of triangles, raises the smallest angle of two of them, or cuts.
    while let Some(Reverse((TotalOrder(angle), t))) = rules.thin.pop() {
        // Work is counted here too, because changes at a vertex queue all its triangles again.
        rules.work += 1;
        if rules.work >= WORK_PER_LOOK {
            exec.look(std::mem::take(&mut rules.work))?;
        }
        if rules.film.topology.is_removed(t) {
            continue;
        }
        let triangle = rules.film.triangles()[t as usize];
        // A triangle that has changed since it was queued was queued again with its new angle.
        if smallest_angle(rules.film.corners(triangle)).total_cmp(&angle).is_eq() {
            rules.treat(triangle);
        }
    }
    let Rules { film: mut changed, changes, .. } = rules;
    if !changes.any() {
        return Ok(changes);
    }
    if changed.close_gaps().is_err() {
        debug_assert!(false, "the rules keep a manifold one");
        return Ok(Changes::default());
    }
    *film = changed;
    Ok(changes)
}

/// Whether a triangle has an angle below `degenerate_angle` (radians).
#[must_use]
pub fn has_degenerate_triangles(film: &Film, degenerate_angle: f64) -> bool {
    let is_thin = |t: [u32; 3]| smallest_angle(film.corners(t)) < degenerate_angle;
    film.triangles().iter().any(|&t| is_thin(t))
}

fn smallest_angle(corners: [DVec3; 3]) -> f64 {
    measure::angles(corners).into_iter().fold(f64::INFINITY, f64::min)
}

#[derive(Debug)]
struct Rules {
    film: Film,
    degenerate_angle: f64,
    necks: Necks,
    /// The queue of thin triangles, sorted by angle, then by number. The thinnest comes first.
    thin: BinaryHeap<Reverse<(TotalOrder, u32)>>,
    changes: Changes,
    /// Number of triangles visited since the last call of [`Execution::look`].
    work: u64,
}

impl Rules {
    fn consider(&mut self, t: u32) {
        self.work += 1;
        let angle = smallest_angle(self.film.corners(self.film.triangles()[t as usize]));
        if angle < self.degenerate_angle {
            self.thin.push(Reverse((TotalOrder(angle), t)));
        }
    }

    fn consider_around(&mut self, vertex: u32) {
        let around: Vec<u32> = self.film.topology.outgoing_half_edges(vertex).collect();
        around.into_iter().for_each(|h| self.consider(h / 3));
    }

    fn treat(&mut self, triangle: [u32; 3]) {
        let corners = self.film.corners(triangle);
        let angles = measure::angles(corners);
        let length = |k: usize| corners[(k + 1) % 3].distance(corners[(k + 2) % 3]);
        let widest = (0..3).fold(0, |best, k| if angles[k] > angles[best] { k } else { best });
        let shortest = (0..3).fold(0, |best, k| if length(k) < length(best) { k } else { best });
        let small = angles.iter().filter(|&&angle| angle < self.degenerate_angle).count();
        let rotated = |k: usize| [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
        // If an edge has length zero, two angles are computed as 0, whatever the shape of the triangle is.
        if small == 1 || length(shortest) <= self.degenerate_angle * 1e-3 * length(widest) {
            let [_, a, b] = rotated(shortest);
            self.collapse(a, b);
            return;
        }
        let [apex, a, b] = rotated(widest);
        if !self.film.fixed[apex as usize]
            && let Some(t) = self.film.topology.remove_vertex_of_three(apex)
        {
            self.changes.removals += 1;
            self.consider(t);
            return;
        }
        if !self.flip(a, b) {
            let nearer = if length((widest + 2) % 3) <= length((widest + 1) % 3) { a } else { b };
            self.collapse(nearer, apex);
        }
    }

    /// Rule (c). Flips the edge if that increases the smallest angle of its two triangles.
    fn flip(&mut self, a: u32, b: u32) -> bool {
        let topology = &self.film.topology;
        let Some(h) = topology.half_edge(a, b) else { return false };
        if self.film.is_locked(a, b) || !topology.can_flip(h) {
            return false;
        }
        let twin = topology.twin[h as usize];
        let (c, d) = (topology.opposite(h), topology.opposite(twin));
        let angle = |t: [u32; 3]| smallest_angle(self.film.corners(t));
        let (before, after) = (angle([a, b, c]).min(angle([b, a, d])), angle([d, c, a]).min(angle([c, d, b])));
        if after <= before {
            return false;
        }
        self.film.topology.flip(h);
        self.changes.flips += 1;
        [h, twin].into_iter().for_each(|h| self.consider(h / 3));
        true
    }

    /// Rule (a). Collapses the edge. If the edge belongs to a neck of three edges, cuts the neck instead.
    fn collapse(&mut self, a: u32, b: u32) -> bool {
        let fixed = |v: u32| self.film.fixed[v as usize];
        let (a, b) = if fixed(b) { (b, a) } else { (a, b) };
        if fixed(b) || self.film.is_locked(a, b) {
            return false;
        }
        if let Some(c) = self.third_of_empty_triangle(a, b) {
            return self.cut([a, b, c]);
        }
        if !may_collapse(&self.film.topology, a, b) {
            return false;
        }
        let place = self.place_for(a, b);
        self.film.topology.collapse(a, b);
        self.film.vertices[a as usize] = place;
        self.changes.collapses += 1;
        self.consider_around(a);
        true
    }

    /// The third vertex c of a neck: a, b and c are joined in pairs, but no triangle at the edge a-b has the corner c.
    /// If a and b became one vertex, two edges would join it with c.
    fn third_of_empty_triangle(&self, a: u32, b: u32) -> Option<u32> {
        let topology = &self.film.topology;
        let corners = [(a, b), (b, a)].map(|(from, to)| topology.half_edge(from, to).map(|h| topology.opposite(h)));
        let is_third = |&c: &u32| c != b && topology.are_adjacent(c, b) && !corners.contains(&Some(c));
        topology.neighbours(a).filter(is_third).min()
    }

    /// The position of the vertex into which a and b are merged. If a is fixed, this is its position. Otherwise it is
    /// the middle of the edge, or an end if that turns fewer triangles over.
    fn place_for(&self, a: u32, b: u32) -> DVec3 {
        let film = &self.film;
        let (from, to) = (film.vertices[a as usize], film.vertices[b as usize]);
        if film.fixed[a as usize] {
            return from;
        }
        let turned_over = |place: DVec3| {
            let around = [a, b].into_iter().flat_map(|v| film.topology.outgoing_half_edges(v));
            let triangles = around.map(|h| film.triangles()[h as usize / 3]);
            triangles
                .filter(|t| !(t.contains(&a) && t.contains(&b)))
                .filter(|&t| {
                    let moved = t.map(|v| if v == a || v == b { place } else { film.vertices[v as usize] });
                    let before = measure::double_area_vector(film.corners(t));
                    before.dot(measure::double_area_vector(moved)) < 0.0
                })
                .count()
        };
        let places = [0.5 * (from + to), from, to];
        let counts = places.map(turned_over);
        // The first of equal counts is taken, so that the middle is preferred to the ends.
        let best = (1..3).fold(0, |best, k| if counts[k] < counts[best] { k } else { best });
        places[best]
    }

    /// Cuts through the neck a-b-c and removes a side that has neither a boundary nor a fixed vertex.
    fn cut(&mut self, cycle: [u32; 3]) -> bool {
        if self.necks == Necks::Keep && !self.closes_one_vertex(cycle) {
            return false;
        }
        let film = &mut self.film;
        // The cut would duplicate a fixed vertex inside the film.
        if cycle.iter().any(|&v| film.fixed[v as usize] && !film.topology.is_boundary(v)) {
            return false;
        }
        let place = cycle.iter().map(|&v| film.vertices[v as usize]).sum::<DVec3>() / 3.0;
        let Some(caps) = film.topology.cut(cycle) else { return false };
        film.vertices.extend(cycle.map(|v| film.vertices[v as usize]));
        film.fixed.extend([false; 3]);
        self.work += film.triangles().len() as u64;
        let left = film.topology.component_of(caps.left);
        let apart = !left.contains(&caps.right);
        let mut removed = 0;
        if apart {
            let right = film.topology.component_of(caps.right);
            for side in [left, right] {
                if is_loose(film, &side) {
                    removed = removed.max(side.len());
                    film.topology.remove_component(&side);
                }
            }
        }
        let what = match (apart, removed) {
            (true, 0) => Some("split"),
            (false, _) => Some("handle_cut"),
            // A closed side of four triangles consists of a vertex of three triangles and the new cap. The cut has then
            // done the same as rule (b).
            (true, 4) => None,
            (true, _) => Some("closed_component_removed"),
        };
        self.changes.pinches.extend(what.map(|what| Pinch { iteration: 0, place, what }));
        if what.is_none() {
            self.changes.removals += 1;
        }
        for t in [caps.left, caps.right] {
            if !self.film.topology.is_removed(t) {
                self.film.triangles()[t as usize].into_iter().for_each(|vertex| self.consider_around(vertex));
            }
        }
        true
    }

    /// Whether the edges of a cycle surround one vertex of three triangles, so that a cut removes that vertex and
    /// nothing else.
    fn closes_one_vertex(&self, [a, b, c]: [u32; 3]) -> bool {
        let topology = &self.film.topology;
        let corner = |x, y| topology.half_edge(x, y).map(|h| topology.opposite(h));
        let one = |x: u32, y: u32, z: u32| {
            let apex = corner(x, y);
            apex.is_some() && apex == corner(y, z) && apex == corner(z, x)
        };
        one(a, b, c) || one(c, b, a)
    }
}

/// Whether a component has neither a boundary nor a fixed vertex, so that nothing holds it in place.
fn is_loose(film: &Film, component: &[u32]) -> bool {
    component.iter().all(|&t| {
        let corners = film.triangles()[t as usize];
        let twins = &film.topology.twin[3 * t as usize..3 * t as usize + 3];
        corners.iter().all(|&v| !film.fixed[v as usize]) && twins.iter().all(|&twin| twin != NONE)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structured::{cylinder, patch};
    use proptest::prelude::*;

    const ONE_DEGREE: f64 = std::f64::consts::PI / 180.0;

    fn remove(film: &mut Film, degenerate_angle: f64, necks: Necks) -> Changes {
        remove_degenerate_triangles(film, degenerate_angle, necks, &Execution::default()).unwrap()
    }

    fn thinnest(film: &Film) -> f64 {
        film.triangles().iter().map(|&t| smallest_angle(film.corners(t))).fold(f64::INFINITY, f64::min)
    }

    /// The mesh of Bento and Cavalcanti's Fig. 4. Triangle 1 is (p, q, a). Across the edge p-q lies triangle 2 = (q, p,
    /// d), with a wide angle at q. Flipping p-q produces the triangle (d, q, a), which is again wide at q, and flipping
    /// its edge restores p-q.
    fn figure_4() -> Film {
        let points = [
            (0.0, 0.0),    // 0 p
            (0.7, -1.0),   // 1 e
            (1.5, -0.003), // 2 d
            (1.3, 1.0),    // 3 g
            (0.3, 1.0),    // 4 f
            (1.0, 0.0),    // 5 q
            (0.5, 0.002),  // 6 a
            (0.6, 0.5),    // 7 h
        ];
        let triangles =
            [[0, 5, 6], [5, 0, 2], [0, 1, 2], [0, 6, 4], [6, 7, 4], [6, 5, 7], [5, 2, 3], [5, 3, 7], [7, 3, 4]];
        let vertices = points.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
        Film::new(vertices, &triangles, vec![vec![0, 1, 2, 3, 4]]).unwrap()
    }

    #[test]
    fn figure_4_flipping_triangle_1_first_would_never_end() {
        let mut film = figure_4();
        // Rule (c) without the condition on the angles, always applied to the triangle with the corners a and q.
        let widest = |film: &Film, t: [u32; 3]| {
            let angles = measure::angles(film.corners(t));
            (0..3).fold(0, |best, k| if angles[k] > angles[best] { k } else { best })
        };
        let flip = |film: &mut Film, a: u32, b: u32| {
            let h = film.topology.half_edge(a, b).unwrap();
            assert!(film.topology.can_flip(h));
            film.topology.flip(h);
        };
        for _ in 0..3 {
            assert_eq!(widest(&film, [0, 5, 6]), 2);
            flip(&mut film, 0, 5);
            assert_eq!(widest(&film, [2, 5, 6]), 1);
            flip(&mut film, 2, 6);
        }
    }

    #[test]
    fn figure_4_ends_without_a_thin_triangle() {
        let mut film = figure_4();
        let changes = remove(&mut film, ONE_DEGREE, Necks::Cut);
        assert!(changes.flips > 0 && changes.flips < 10 && changes.pinches.is_empty(), "{changes:?}");
        assert!(thinnest(&film) > ONE_DEGREE);
        assert_eq!(film.mesh().check().unwrap().euler_characteristic(), 1);
        assert_eq!(measure::flipped_triangles(&film.mesh()), 0);
    }

    #[test]
    fn rule_a_collapses_a_needle() {
        let mut film = patch(6, 6, |u, v| DVec3::new(u, v, 0.0));
        // Two neighbours in the middle are moved close together.
        let (a, b) = (3 * 7 + 3, 4 * 7 + 3);
        film.vertices[b] = film.vertices[a] + DVec3::new(1e-4, 0.0, 0.0);
        let before = film.triangles().len();
        let changes = remove(&mut film, ONE_DEGREE, Necks::Keep);
        assert_eq!((changes.collapses, film.triangles().len()), (1, before - 2));
        assert_eq!(film.mesh().check().unwrap().euler_characteristic(), 1);
    }

    #[test]
    fn rule_b_removes_a_vertex_of_three_triangles() {
        let corner = |x, y| DVec3::new(x, y, 0.0);
        let vertices = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0), corner(0.5, 1e-4)];
        let mut film = Film::new(vertices, &[[0, 1, 3], [1, 2, 3], [2, 0, 3]], vec![vec![0, 1, 2]]).unwrap();
        let changes = remove(&mut film, ONE_DEGREE, Necks::Keep);
        assert_eq!((changes.removals, film.triangles()), (1, &[[0, 1, 2]][..]));
    }

    #[test]
    fn a_wide_angle_at_the_boundary_moves_its_vertex_into_the_nearer_end() {
        let mut film = patch(4, 4, |u, v| DVec3::new(u, v, 0.0));
        // The vertex next to the middle of the lower side is moved almost onto the side.
        let middle = 2 * 5 + 1;
        film.vertices[middle] = DVec3::new(0.6, 1e-4, 0.0);
        remove(&mut film, ONE_DEGREE, Necks::Keep);
        assert!(thinnest(&film) >= ONE_DEGREE);
        assert_eq!(film.mesh().check().unwrap().euler_characteristic(), 1);
    }

    #[test]
    fn a_bubble_on_a_thin_neck_is_cut_off_and_removed() {
        let mut film = cylinder(6, 5, 2.0);
        // A fan of triangles closes the upper rim, so that the tube becomes a bag over its lower rim.
        let apex = film.vertices.len() as u32;
        let mut triangles = film.triangles().to_vec();
        let upper: Vec<u32> = (0..6).map(|k| 5 * 6 + k).collect();
        for k in 0..6 {
            let (a, b) = (upper[k], upper[(k + 1) % 6]);
            let forward = film.triangles().iter().any(|t| (0..3).any(|i| t[i] == a && t[(i + 1) % 3] == b));
            triangles.push(if forward { [b, a, apex] } else { [a, b, apex] });
        }
        let mut vertices = film.vertices.clone();
        vertices.push(DVec3::new(0.0, 0.0, 1.2));
        // The ring above the lower rim is shrunk to a thousandth of its radius.
        for vertex in &mut vertices[12..18] {
            *vertex *= DVec3::new(1e-3, 1e-3, 1.0);
        }
        film = Film::new(vertices, &triangles, vec![film.boundaries[0].clone()]).unwrap();
        let changes = remove(&mut film, ONE_DEGREE, Necks::Cut);
        assert_eq!(changes.pinches.iter().map(|pinch| pinch.what).collect::<Vec<_>>(), ["closed_component_removed"]);
        let topology = film.mesh().check().unwrap();
        assert_eq!((topology.components(), topology.euler_characteristic()), (1, 1));
    }

    proptest! {
        #[test]
        fn the_rules_end_and_keep_the_surface(
            heights in prop::collection::vec(-1.0f64..1.0, 49), squeeze in 0.0f64..1.0, angle in 0.1f64..20.0
        ) {
            // The grid becomes irregular, and whole rows of vertices fall onto each other.
            let mut film = patch(6, 6, |u, v| DVec3::new(u, v, 0.0));
            for (vertex, height) in film.vertices.iter_mut().zip(&heights) {
                vertex.x += squeeze * libm::sin(height * 7.0);
                vertex.y = if height.abs() < 0.3 { 0.5 } else { vertex.y };
                vertex.z = squeeze * height;
            }
            let boundary: Vec<DVec3> = film.boundaries[0].iter().map(|&v| film.vertices[v as usize]).collect();
            let changes = remove(&mut film, angle.to_radians(), Necks::Keep);
            let topology = film.mesh().check().map_err(|defect| TestCaseError::fail(defect.to_string()))?;
            prop_assert_eq!((topology.euler_characteristic(), topology.components()), (1, 1));
            prop_assert!(changes.pinches.is_empty());
            let after: Vec<DVec3> = film.boundaries[0].iter().map(|&v| film.vertices[v as usize]).collect();
            prop_assert_eq!(boundary, after);
        }

        #[test]
        fn any_tube_may_be_cut_and_stays_over_its_two_loops(
            radii in prop::collection::vec(0.0f64..1.0, 7), twist in -1.0f64..1.0, angle in 0.1f64..25.0
        ) {
            let mut film = cylinder(7, 8, 3.0);
            for ring in 1..8 {
                for v in 7 * ring..7 * ring + 7 {
                    let vertex = film.vertices[v];
                    let radius = radii[ring - 1].powi(6);
                    let turned = vertex.rotate_z(twist * ring as f64);
                    film.vertices[v] = DVec3::new(turned.x * radius, turned.y * radius, vertex.z);
                }
            }
            remove(&mut film, angle.to_radians(), Necks::Cut);
            let topology = film.mesh().check().map_err(|defect| TestCaseError::fail(defect.to_string()))?;
            let components = topology.components() as i64;
            prop_assert!(components == 1 || components == 2);
            prop_assert_eq!(topology.euler_characteristic(), 2 * components - 2);
            prop_assert_eq!(topology.boundary_loops().len(), 2);
        }
    }
}
