//! Bento and Cavalcanti, *Computação de Superfícies Mínimas Discretas*: rules against degenerate triangles, and the
//! change of topology that follows from them.
//!
//! A triangle with an angle below the threshold is removed by the first rule that fits it (their Fig. 3):
//! - (a) one small angle: the edge opposite to it collapses, two triangles go;
//! - (b) an angle near 180° at a vertex of three triangles: the vertex goes, the three become one;
//! - (c) an angle near 180° elsewhere: the edge opposite to it is flipped.
//!
//! Where (a) would double an edge (their Fig. 5: a neck of three edges), the surface is cut along these three edges and
//! either side closed with a triangle, which (a) then removes. A component without a boundary is removed.
//!
//! Our departures, each so that the rules end:
//! - Thinnest triangle first; a flip must make the smallest angle of its two triangles larger. Their Fig. 4 is the
//!   order in which unguarded flips undo each other for ever. Now every step either lowers the number of triangles, or
//!   raises the angles, or cuts; and a surface over k loops can be cut a bounded number of times only.
//! - An angle near 180° opposite an edge that cannot be flipped (a boundary edge, or the other diagonal exists):
//!   its vertex moves into the nearer end of that edge.
//! - Fixed vertices stay; of two, none moves.

mod surgery;

use crate::DVec3;
use crate::mesh::film::Film;
use crate::mesh::measure;
use crate::mesh::topology::Topology;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use surgery::Surgery;

/// A change of topology: where a neck closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinch {
    /// The iteration in which it happened, from 1.
    pub iteration: u32,
    /// Where it happened.
    pub place: DVec3,
    /// The kind of change: `split` (a component became two), `handle_cut` (it stayed one), `closed_component_removed`.
    pub what: &'static str,
}

/// Changes that the rules made to a film.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Changes {
    /// Uses of rule (a).
    pub collapses: u64,
    /// Uses of rule (b).
    pub removals: u64,
    /// Uses of rule (c).
    pub flips: u64,
    /// Where the topology changed; `iteration` is 0, for the caller to set.
    pub pinches: Vec<Pinch>,
}

impl Changes {
    /// Whether the film is another one than before.
    pub fn any(&self) -> bool {
        self.collapses + self.removals + self.flips > 0 || !self.pinches.is_empty()
    }
}

/// Whether necks may be cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Necks {
    Keep,
    Cut,
}

/// An angle in the order of total_cmp, for the heap.
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

/// Applies the rules to every triangle with an angle below `degenerate_angle` (radians) until none is left to which one
/// applies. The film stays an oriented manifold over the same boundary loops; interior vertices may vanish or be
/// doubled.
///
/// Free where no triangle is below the threshold; else O(triangles + changes · log).
pub(crate) fn remove_degenerate_triangles(film: &mut Film, degenerate_angle: f64, necks: Necks) -> Changes {
    let smallest = |t: [u32; 3]| smallest_angle(film.corners(t));
    if film.triangles().iter().all(|&t| smallest(t) >= degenerate_angle) {
        return Changes::default();
    }
    let surgery = Surgery::new(film.vertices.clone(), film.fixed.clone(), film.triangles());
    let mut rules = Rules {
        surgery,
        degenerate_angle,
        necks,
        locked: &film.locked,
        thin: BinaryHeap::new(),
        changes: Changes::default(),
    };
    for t in 0..rules.surgery.triangle_count() as u32 {
        rules.consider(t);
    }
    while let Some(Reverse((Angle(angle), t))) = rules.thin.pop() {
        let Some(triangle) = rules.surgery.triangle(t) else { continue };
        // The triangle may have changed since it was queued; it was queued again then.
        if smallest_angle(rules.surgery.corners(triangle)).total_cmp(&angle).is_eq() {
            rules.treat(triangle);
        }
    }
    let changes = rules.changes;
    if !changes.any() {
        return changes;
    }
    let (vertices, fixed, triangles, old) = rules.surgery.finish();
    let Ok(topology) = Topology::build(&triangles, vertices.len()) else {
        debug_assert!(false, "the rules keep a manifold one");
        return Changes::default();
    };
    let mut renamed = vec![u32::MAX; film.vertices.len().max(old.iter().max().map_or(0, |&v| v as usize + 1))];
    old.iter().enumerate().for_each(|(new, &old)| renamed[old as usize] = new as u32);
    for vertex in film.boundaries.iter_mut().flatten().chain(film.locked.iter_mut().flatten()) {
        // Fixed vertices never vanish, and boundaries and locked edges have no others.
        *vertex = renamed[*vertex as usize];
    }
    film.vertices = vertices;
    film.fixed = fixed;
    film.topology = topology;
    changes
}

fn smallest_angle(corners: [DVec3; 3]) -> f64 {
    measure::angles(corners).into_iter().fold(f64::INFINITY, f64::min)
}

#[derive(Debug)]
struct Rules<'a> {
    surgery: Surgery,
    degenerate_angle: f64,
    necks: Necks,
    locked: &'a [[u32; 2]],
    /// Thin triangles, thinnest first, then by number.
    thin: BinaryHeap<Reverse<(Angle, u32)>>,
    changes: Changes,
}

impl Rules<'_> {
    fn consider(&mut self, t: u32) {
        let Some(triangle) = self.surgery.triangle(t) else { return };
        let angle = smallest_angle(self.surgery.corners(triangle));
        if angle < self.degenerate_angle {
            self.thin.push(Reverse((Angle(angle), t)));
        }
    }

    fn consider_around(&mut self, vertex: u32) {
        for t in self.surgery.around(vertex).to_vec() {
            self.consider(t);
        }
    }

    fn is_locked(&self, a: u32, b: u32) -> bool {
        self.locked.binary_search(&[a.min(b), a.max(b)]).is_ok()
    }

    fn treat(&mut self, triangle: [u32; 3]) {
        let corners = self.surgery.corners(triangle);
        let angles = measure::angles(corners);
        let length = |k: usize| corners[(k + 1) % 3].distance(corners[(k + 2) % 3]);
        let widest = (0..3).fold(0, |best, k| if angles[k] > angles[best] { k } else { best });
        let shortest = (0..3).fold(0, |best, k| if length(k) < length(best) { k } else { best });
        let small = angles.iter().filter(|&&angle| angle < self.degenerate_angle).count();
        let rotated = |k: usize| [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
        // A vanished edge makes its two angles 0, whatever they would be.
        if small == 1 || length(shortest) <= self.degenerate_angle * 1e-3 * length(widest) {
            let [_, a, b] = rotated(shortest);
            self.collapse(a, b);
            return;
        }
        let [apex, a, b] = rotated(widest);
        if self.surgery.around(apex).len() == 3
            && let Some(t) = self.surgery.remove_vertex_of_three(apex)
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

    /// Rule (c), if it makes the smallest angle of the two triangles larger.
    fn flip(&mut self, a: u32, b: u32) -> bool {
        let Some([_, _, c, d]) = self.surgery.quad(a, b) else { return false };
        if self.is_locked(a, b) {
            return false;
        }
        let angle = |t: [u32; 3]| smallest_angle(self.surgery.corners(t));
        let (before, after) = (angle([a, b, c]).min(angle([b, a, d])), angle([d, c, a]).min(angle([c, d, b])));
        if after <= before {
            return false;
        }
        let Some(new) = self.surgery.flip(a, b) else { return false };
        self.changes.flips += 1;
        new.into_iter().for_each(|t| self.consider(t));
        true
    }

    /// Rule (a): the edge becomes a point; a neck of three edges is cut first.
    fn collapse(&mut self, a: u32, b: u32) -> bool {
        let fixed = |v: u32| self.surgery.fixed[v as usize];
        let (a, b) = if fixed(b) { (b, a) } else { (a, b) };
        if fixed(b) || self.is_locked(a, b) {
            return false;
        }
        if let Some(c) = self.surgery.third_of_empty_triangle(a, b) {
            return self.cut(a, b, c);
        }
        let place = self.place_for(a, b);
        let done = self.surgery.collapse(a, b, place);
        if done {
            self.changes.collapses += 1;
            self.consider_around(a);
        }
        done
    }

    /// Where the vertex goes that a and b become: a fixed a stays; else the middle, or the end that turns fewer
    /// triangles over.
    fn place_for(&self, a: u32, b: u32) -> DVec3 {
        let (from, to) = (self.surgery.vertices[a as usize], self.surgery.vertices[b as usize]);
        if self.surgery.fixed[a as usize] {
            return from;
        }
        let turned_over = |place: DVec3| {
            let around = [a, b].map(|v| self.surgery.around(v).iter().filter_map(|&t| self.surgery.triangle(t)));
            let triangles = around.into_iter().flatten().filter(|t| !(t.contains(&a) && t.contains(&b)));
            triangles
                .filter(|&t| {
                    let moved = t.map(|v| if v == a || v == b { place } else { self.surgery.vertices[v as usize] });
                    let before = measure::double_area_vector(self.surgery.corners(t));
                    before.dot(measure::double_area_vector(moved)) < 0.0
                })
                .count()
        };
        let places = [0.5 * (from + to), from, to];
        let counts = places.map(turned_over);
        // The first of the best: the middle where it is as good as the ends.
        let best = (1..3).fold(0, |best, k| if counts[k] < counts[best] { k } else { best });
        places[best]
    }

    /// Cuts through the neck a-b-c and drops what is left without a boundary.
    fn cut(&mut self, a: u32, b: u32, c: u32) -> bool {
        let place = [a, b, c].iter().map(|&v| self.surgery.vertices[v as usize]).sum::<DVec3>() / 3.0;
        if self.necks == Necks::Keep && !self.closes_one_vertex(a, b, c) {
            return false;
        }
        let Some(caps) = self.surgery.cut(a, b, c) else { return false };
        let left = self.surgery.component(caps.left);
        let apart = !left.contains(&caps.right);
        let mut removed = 0;
        if apart {
            let right = self.surgery.component(caps.right);
            for side in [left, right] {
                if self.surgery.is_loose(&side) {
                    removed = removed.max(side.len());
                    self.surgery.remove_all(&side);
                }
            }
        }
        let what = match (apart, removed) {
            (true, 0) => Some("split"),
            (false, _) => Some("handle_cut"),
            // Four triangles: one vertex of three triangles and the cap. Rule (b) in another guise.
            (true, 4) => None,
            (true, _) => Some("closed_component_removed"),
        };
        self.changes.pinches.extend(what.map(|what| Pinch { iteration: 0, place, what }));
        if what.is_none() {
            self.changes.removals += 1;
        }
        for t in [caps.left, caps.right] {
            for vertex in self.surgery.triangle(t).into_iter().flatten() {
                self.consider_around(vertex);
            }
        }
        true
    }

    /// Whether a-b-c surround one vertex of three triangles, so that a cut removes that vertex and nothing else.
    fn closes_one_vertex(&self, a: u32, b: u32, c: u32) -> bool {
        let corner = |x, y| self.surgery.left_of(x, y).map(|(_, corner)| corner);
        let one = |x: u32, y: u32, z: u32| {
            let apex = corner(x, y);
            apex.is_some() && apex == corner(y, z) && apex == corner(z, x)
        };
        one(a, b, c) || one(c, b, a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::structured::{cylinder, patch};
    use proptest::prelude::*;

    const ONE_DEGREE: f64 = std::f64::consts::PI / 180.0;

    fn thinnest(film: &Film) -> f64 {
        film.triangles().iter().map(|&t| smallest_angle(film.corners(t))).fold(f64::INFINITY, f64::min)
    }

    /// Bento and Cavalcanti's Fig. 4: the triangle 1 = (p, q, a) and, across p-q, the triangle 2 = (q, p, d), whose
    /// wide angle is at q. Flipping p-q first leaves (d, q, a), wide at q again, whose flip brings p-q back.
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
        let film = figure_4();
        let mut surgery = Surgery::new(film.vertices.clone(), film.fixed.clone(), film.triangles());
        for _ in 0..3 {
            // Rule (c) without a guard, always on the triangle with the corners a and q.
            let widest = |surgery: &Surgery, t: [u32; 3]| {
                let angles = measure::angles(surgery.corners(t));
                (0..3).fold(0, |best, k| if angles[k] > angles[best] { k } else { best })
            };
            assert_eq!(widest(&surgery, [0, 5, 6]), 2);
            assert!(surgery.flip(0, 5).is_some());
            assert_eq!(widest(&surgery, [2, 5, 6]), 1);
            assert!(surgery.flip(2, 6).is_some());
        }
    }

    #[test]
    fn figure_4_ends_without_a_thin_triangle() {
        let mut film = figure_4();
        let changes = remove_degenerate_triangles(&mut film, ONE_DEGREE, Necks::Cut);
        assert!(changes.flips > 0 && changes.flips < 10 && changes.pinches.is_empty(), "{changes:?}");
        assert!(thinnest(&film) > ONE_DEGREE);
        assert_eq!(film.mesh().check().unwrap().euler_characteristic(), 1);
        assert_eq!(measure::flipped_triangles(&film.mesh()), 0);
    }

    #[test]
    fn rule_a_collapses_a_needle() {
        let mut film = patch(6, 6, |u, v| DVec3::new(u, v, 0.0));
        // Two neighbours in the middle come close together.
        let (a, b) = (3 * 7 + 3, 4 * 7 + 3);
        film.vertices[b] = film.vertices[a] + DVec3::new(1e-4, 0.0, 0.0);
        let before = film.triangles().len();
        let changes = remove_degenerate_triangles(&mut film, ONE_DEGREE, Necks::Keep);
        assert_eq!((changes.collapses, film.triangles().len()), (1, before - 2));
        assert_eq!(film.mesh().check().unwrap().euler_characteristic(), 1);
    }

    #[test]
    fn rule_b_removes_a_vertex_of_three_triangles() {
        let corner = |x, y| DVec3::new(x, y, 0.0);
        let vertices = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0), corner(0.5, 1e-4)];
        let mut film = Film::new(vertices, &[[0, 1, 3], [1, 2, 3], [2, 0, 3]], vec![vec![0, 1, 2]]).unwrap();
        let changes = remove_degenerate_triangles(&mut film, ONE_DEGREE, Necks::Keep);
        assert_eq!((changes.removals, film.triangles()), (1, &[[0, 1, 2]][..]));
    }

    #[test]
    fn a_wide_angle_at_the_boundary_moves_its_vertex_into_the_nearer_end() {
        let mut film = patch(4, 4, |u, v| DVec3::new(u, v, 0.0));
        // The vertex next to the middle of the lower side drops almost onto it.
        let middle = 2 * 5 + 1;
        film.vertices[middle] = DVec3::new(0.6, 1e-4, 0.0);
        remove_degenerate_triangles(&mut film, ONE_DEGREE, Necks::Keep);
        assert!(thinnest(&film) >= ONE_DEGREE);
        assert_eq!(film.mesh().check().unwrap().euler_characteristic(), 1);
    }

    #[test]
    fn a_bubble_on_a_thin_neck_is_cut_off_and_removed() {
        let mut film = cylinder(6, 5, 2.0);
        // Close the upper rim with a fan, so that the tube is a bag over its lower rim.
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
        // The ring above the lower rim shrinks to a thousandth.
        for vertex in &mut vertices[12..18] {
            *vertex *= DVec3::new(1e-3, 1e-3, 1.0);
        }
        film = Film::new(vertices, &triangles, vec![film.boundaries[0].clone()]).unwrap();
        let changes = remove_degenerate_triangles(&mut film, ONE_DEGREE, Necks::Cut);
        assert_eq!(changes.pinches.iter().map(|pinch| pinch.what).collect::<Vec<_>>(), ["closed_component_removed"]);
        let topology = film.mesh().check().unwrap();
        assert_eq!((topology.components(), topology.euler_characteristic()), (1, 1));
    }

    proptest! {
        #[test]
        fn the_rules_end_and_keep_the_surface(
            heights in prop::collection::vec(-1.0f64..1.0, 49), squeeze in 0.0f64..1.0, angle in 0.1f64..20.0
        ) {
            // Nothing is left of the grid's regularity, and whole rows fall onto each other.
            let mut film = patch(6, 6, |u, v| DVec3::new(u, v, 0.0));
            for (vertex, height) in film.vertices.iter_mut().zip(&heights) {
                vertex.x += squeeze * (height * 7.0).sin();
                vertex.y = if height.abs() < 0.3 { 0.5 } else { vertex.y };
                vertex.z = squeeze * height;
            }
            let boundary: Vec<DVec3> = film.boundaries[0].iter().map(|&v| film.vertices[v as usize]).collect();
            let changes = remove_degenerate_triangles(&mut film, angle.to_radians(), Necks::Keep);
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
            remove_degenerate_triangles(&mut film, angle.to_radians(), Necks::Cut);
            let topology = film.mesh().check().map_err(|defect| TestCaseError::fail(defect.to_string()))?;
            let components = topology.components() as i64;
            prop_assert!(components == 1 || components == 2);
            prop_assert_eq!(topology.euler_characteristic(), 2 * components - 2);
            prop_assert_eq!(topology.boundary_loops().len(), 2);
        }
    }
}
