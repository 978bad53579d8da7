//! Changes of connectivity that keep a mesh an oriented manifold: edge flips, edge collapses, removal of a vertex of
//! three triangles, and regular subdivision. Cutting a neck is in the module `cut`.
//!
//! A removed triangle keeps its number, with [`NONE`] for its corners and its twins. A vertex that is merged into
//! another vertex keeps its number too, but has no outgoing half-edge. [`Topology::without_gaps`] renumbers the
//! remaining triangles and vertices.

use crate::topology::{Defect, NONE, Topology, next, previous};

/// Whether the edge between a and b may be contracted to a point so that the mesh stays a manifold of the same
/// topology: the link condition (Dey, Edelsbrunner, Guha, Nekhayev, *Topology preserving edge contraction*, 1999).
///
/// 1. The edge has a triangle. An edge of two triangles does not join two boundary vertices.
/// 2. The ends have no common neighbour except the corners opposite the edge.
/// 3. The mesh is not the surface of a tetrahedron, nor two triangles back to back.
/// 4. Each corner opposite the edge keeps at least one triangle.
pub fn may_collapse(mesh: &Topology, a: u32, b: u32) -> bool {
    let corners = [(a, b), (b, a)].map(|(from, to)| mesh.half_edge(from, to).map(|h| mesh.opposite(h)));
    let keeps_form = match corners {
        [None, None] => false,
        [Some(c), Some(d)] => {
            let tetrahedron = mesh.degree(c) == 3
                && mesh.degree(d) == 3
                && !mesh.is_boundary(c)
                && !mesh.is_boundary(d)
                && mesh.are_adjacent(c, d);
            c != d && !tetrahedron && !(mesh.is_boundary(a) && mesh.is_boundary(b))
        }
        _ => true,
    };
    keeps_form
        && corners.into_iter().flatten().all(|corner| mesh.degree(corner) > 1)
        && !mesh.neighbours(a).any(|v| v != b && !corners.contains(&Some(v)) && mesh.are_adjacent(v, b))
}

/// The vertices that are left after [`Topology::without_gaps`], and their new numbers.
#[derive(Clone, Debug)]
pub struct Renumbering {
    kept: Vec<usize>,
    number: Vec<u32>,
}

impl Renumbering {
    /// The values of the vertices that are left, in their new order.
    #[must_use]
    #[inline]
    pub fn of<T: Copy>(&self, values: &[T]) -> Vec<T> {
        self.kept.iter().map(|&v| values[v]).collect()
    }

    /// The new number of a vertex; [`NONE`] if it is not left.
    #[must_use]
    #[inline]
    pub fn number(&self, vertex: u32) -> u32 {
        self.number[vertex as usize]
    }
}

impl Topology {
    /// The corners of the triangles. Removed triangles have [`NONE`] for each corner.
    #[must_use]
    #[inline]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Returns a half-edge of each edge whose `key` is above 1, sorted by falling keys, then by number.
    pub fn ranked_edges(&self, key: impl Fn(u32) -> f64) -> Vec<u32> {
        // The twin of a boundary half-edge is `NONE`, the largest number, so that this half-edge is always taken.
        let mut ranked: Vec<(f64, u32)> = (0..self.twin.len() as u32)
            .filter(|&h| self.twin[h as usize] > h)
            .map(|h| (key(h), h))
            .filter(|&(key, _)| key > 1.0)
            .collect();
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        ranked.into_iter().map(|(_, h)| h).collect()
    }

    /// Whether an edge joins the two vertices.
    #[must_use]
    #[inline]
    pub fn are_adjacent(&self, a: u32, b: u32) -> bool {
        self.outgoing_half_edges(a).any(|h| self.to(h) == b || self.from(previous(h)) == b)
    }

    /// The vertex opposite a half-edge in its triangle.
    #[must_use]
    #[inline]
    pub fn opposite(&self, half_edge: u32) -> u32 {
        self.from(previous(half_edge))
    }

    /// The ends of an edge of two triangles, the vertex opposite the half-edge and the vertex opposite its twin; `None`
    /// on the boundary.
    #[must_use]
    #[inline]
    pub fn hinge(&self, half_edge: u32) -> Option<[u32; 4]> {
        let twin = self.twin[half_edge as usize];
        (twin != NONE)
            .then(|| [self.from(half_edge), self.to(half_edge), self.opposite(half_edge), self.opposite(twin)])
    }

    /// The half-edge that runs from one vertex to the other; `None` if no triangle has it.
    #[must_use]
    #[inline]
    pub fn half_edge(&self, from: u32, to: u32) -> Option<u32> {
        self.outgoing_half_edges(from).find(|&h| self.to(h) == to)
    }

    /// The neighbours of a vertex, each once.
    #[inline]
    pub fn neighbours(&self, vertex: u32) -> impl Iterator<Item = u32> + '_ {
        // No half-edge runs from a boundary vertex to its last neighbour. This neighbour is the corner before the
        // vertex in its last triangle.
        self.outgoing_half_edges(vertex).flat_map(|h| {
            let last = self.twin[previous(h) as usize] == NONE;
            std::iter::once(self.to(h)).chain(last.then(|| self.opposite(h)))
        })
    }

    /// Number of triangles around a vertex.
    #[must_use]
    #[inline]
    pub fn degree(&self, vertex: u32) -> usize {
        self.outgoing_half_edges(vertex).count()
    }

    /// Whether a triangle has been removed.
    #[must_use]
    #[inline]
    pub fn is_removed(&self, triangle: u32) -> bool {
        self.triangles[triangle as usize][0] == NONE
    }

    /// Whether the edge has two triangles whose opposite vertices are not yet joined by an edge, so that
    /// [`flip`](Self::flip) keeps the mesh a manifold. The shape of the triangles is not considered.
    #[must_use]
    #[inline]
    pub fn can_flip(&self, half_edge: u32) -> bool {
        self.hinge(half_edge).is_some_and(|[_, _, c, d]| c != d && !self.are_adjacent(c, d))
    }

    /// Replaces the edge a-b of the triangles (a, b, c) and (b, a, d) by the edge d-c: (d, c, a) and (c, d, b).
    ///
    /// The half-edge keeps its index and then runs from d to c. The flip must be allowed by
    /// [`can_flip`](Self::can_flip).
    pub fn flip(&mut self, half_edge: u32) {
        let (h, g) = (half_edge, self.twin[half_edge as usize]);
        debug_assert!(self.can_flip(h));
        let (a, b) = (self.from(h), self.to(h));
        let (c, d) = (self.opposite(h), self.opposite(g));
        let (bc, ca, ad, db) = (next(h), previous(h), next(g), previous(g));
        let outside = [bc, ca, ad, db].map(|e| self.twin[e as usize]);
        self.set_corners(h, [d, c, a]);
        self.set_corners(g, [c, d, b]);
        // The new index and the start of each of the four outer half-edges.
        let moved = [(previous(g), b), (next(h), c), (previous(h), a), (next(g), d)];
        for ((place, vertex), twin) in moved.into_iter().zip(outside) {
            self.twin[place as usize] = twin;
            if twin != NONE {
                self.twin[twin as usize] = place;
            }
            // A boundary vertex keeps its outgoing boundary half-edge. If it is one of the four, its index has changed.
            let before = self.outgoing[vertex as usize];
            if [h, g, bc, ca, ad, db].contains(&before) {
                self.outgoing[vertex as usize] = place;
            }
        }
    }

    /// Returns the connectivity without the removed triangles and without the vertices for which `stays` is false. The
    /// others are renumbered in the same order.
    ///
    /// # Errors
    /// The defect, if the remaining triangles form no oriented manifold.
    #[inline]
    pub fn without_gaps(&self, stays: impl Fn(usize) -> bool) -> Result<(Self, Renumbering), Defect> {
        let kept: Vec<usize> = (0..self.outgoing.len()).filter(|&v| stays(v)).collect();
        let mut number = vec![NONE; self.outgoing.len()];
        kept.iter().enumerate().for_each(|(new, &old)| number[old] = new as u32);
        let left = self.triangles.iter().filter(|triangle| triangle[0] != NONE);
        let triangles: Vec<[u32; 3]> = left.map(|triangle| triangle.map(|v| number[v as usize])).collect();
        Ok((Self::build(&triangles, kept.len())?, Renumbering { kept, number }))
    }

    /// Merges the vertex `merged` into its neighbour `kept`, and removes the triangles at their common edge. The
    /// collapse must be allowed by [`may_collapse`].
    pub fn collapse(&mut self, kept: u32, merged: u32) {
        debug_assert!(may_collapse(self, kept, merged));
        let sides = [self.half_edge(kept, merged), self.half_edge(merged, kept)];
        let around: Vec<u32> = self.outgoing_half_edges(merged).collect();
        for h in around {
            self.triangles[h as usize / 3][h as usize % 3] = kept;
        }
        self.outgoing[merged as usize] = NONE;
        let mut outgoing = Vec::with_capacity(8);
        for side in sides.into_iter().flatten() {
            let corner = self.opposite(side);
            // The corner's edges to the two ends become one edge, with one half-edge that leaves the corner and one
            // that arrives.
            let (leaving, arriving) = (self.twin[next(side) as usize], self.twin[previous(side) as usize]);
            self.take_out(side / 3);
            self.pair(leaving, arriving);
            if leaving != NONE {
                outgoing.extend([(corner, leaving), (kept, next(leaving))]);
            }
            if arriving != NONE {
                outgoing.extend([(kept, arriving), (corner, next(arriving))]);
            }
        }
        outgoing.into_iter().for_each(|(vertex, h)| self.set_outgoing(vertex, h));
    }

    /// Replaces the three triangles around an interior vertex by one triangle, and returns its number. Returns `None`
    /// for any other vertex, and on the surface of a tetrahedron.
    pub(crate) fn remove_vertex_of_three(&mut self, vertex: u32) -> Option<u32> {
        let spokes: Vec<u32> = self.outgoing_half_edges(vertex).collect();
        if spokes.len() != 3 || self.is_boundary(vertex) {
            return None;
        }
        // The half-edges from the vertex in anticlockwise order, beginning with the one in the triangle of the smallest
        // number. That triangle's number is kept.
        let first = *spokes.iter().min()?;
        let second = self.twin[previous(first) as usize];
        let third = self.twin[previous(second) as usize];
        let outer = [first, second, third].map(|spoke| self.twin[next(spoke) as usize]);
        let corners = [first, second, third].map(|spoke| self.to(spoke));
        if outer[0] != NONE && self.opposite(outer[0]) == corners[2] {
            return None;
        }
        [first, second, third].into_iter().for_each(|spoke| self.take_out(spoke / 3));
        self.outgoing[vertex as usize] = NONE;
        let stays = first / 3;
        self.triangles[stays as usize] = corners;
        for (h, twin) in (3 * stays..).zip(outer) {
            self.pair(h, twin);
        }
        for (h, corner) in (3 * stays..).zip(corners) {
            self.set_outgoing(corner, h);
        }
        Some(stays)
    }

    /// Adds a triangle without neighbours, and returns its number.
    pub(super) fn add(&mut self, corners: [u32; 3]) -> u32 {
        self.triangles.push(corners);
        self.twin.extend([NONE; 3]);
        self.triangles.len() as u32 - 1
    }

    /// Removes a triangle. The caller must update the twins of its neighbours and the outgoing half-edges of its
    /// corners.
    pub(super) fn take_out(&mut self, triangle: u32) {
        self.triangles[triangle as usize] = [NONE; 3];
        self.twin[3 * triangle as usize..3 * triangle as usize + 3].fill(NONE);
    }

    /// Makes two half-edges each other's twins. If one of them is [`NONE`], the other becomes a boundary half-edge.
    pub(super) fn pair(&mut self, h: u32, g: u32) {
        for (one, other) in [(h, g), (g, h)] {
            if one != NONE {
                self.twin[one as usize] = other;
            }
        }
    }

    /// Sets a vertex's outgoing half-edge: the boundary half-edge if turning anticlockwise from `half_edge` meets it,
    /// otherwise `half_edge` itself.
    pub(super) fn set_outgoing(&mut self, vertex: u32, half_edge: u32) {
        let mut h = half_edge;
        // Ends because a vertex has one fan: the walk meets the boundary or comes back to its start.
        while self.twin[h as usize] != NONE {
            h = next(self.twin[h as usize]);
            if h == half_edge {
                break;
            }
        }
        self.outgoing[vertex as usize] = h;
    }

    /// Splits every triangle into four at the midpoints of its edges. Returns the new topology, and for each new vertex
    /// the ends of the edge that it halves.
    ///
    /// Old vertices keep their numbers, and the new vertices follow. Triangle `t` becomes the triangles `4 t + k` at
    /// its corners `k` and the triangle `4 t + 3` in the middle. O(n), because the twins follow from the old twins.
    #[must_use]
    pub fn subdivided(&self) -> (Self, Vec<[u32; 2]>) {
        let old = self.outgoing.len() as u32;
        let mut parents = Vec::with_capacity(self.twin.len() / 2 + 1);
        let mut midpoint = vec![NONE; self.twin.len()];
        for h in 0..self.twin.len() as u32 {
            if midpoint[h as usize] == NONE {
                midpoint[h as usize] = old + parents.len() as u32;
                if self.twin[h as usize] != NONE {
                    midpoint[self.twin[h as usize] as usize] = midpoint[h as usize];
                }
                parents.push([self.from(h), self.to(h)]);
            }
        }
        // The two halves of half-edge 3 t + k: the first from corner k to the midpoint, the second from there to the
        // next corner.
        let first_half = |h: u32| 3 * (4 * (h / 3) + h % 3);
        let second_half = |h: u32| 3 * (4 * (h / 3) + (h % 3 + 1) % 3) + 2;
        let mut triangles = Vec::with_capacity(4 * self.triangles.len());
        let mut twin = vec![NONE; 4 * self.twin.len()];
        let mut outgoing = vec![NONE; old as usize + parents.len()];
        for (t, &corners) in self.triangles.iter().enumerate() {
            let middle: [u32; 3] = [midpoint[3 * t], midpoint[3 * t + 1], midpoint[3 * t + 2]];
            for k in 0..3 {
                triangles.push([corners[k], middle[k], middle[(k + 2) % 3]]);
                let (inner, centre) = (3 * (4 * t + k) + 1, 3 * (4 * t + 3) + (k + 2) % 3);
                twin[inner] = centre as u32;
                twin[centre] = inner as u32;
            }
            triangles.push(middle);
        }
        for h in 0..self.twin.len() as u32 {
            let other = self.twin[h as usize];
            if other != NONE {
                twin[first_half(h) as usize] = second_half(other);
                twin[second_half(h) as usize] = first_half(other);
            }
            outgoing[midpoint[h as usize] as usize] = second_half(h);
        }
        for (v, &h) in self.outgoing.iter().enumerate() {
            if h != NONE {
                outgoing[v] = first_half(h);
            }
        }
        (Self { twin, outgoing, triangles }, parents)
    }

    /// The same triangles with vertex `v` renumbered to `place[v]`. `place` must be a permutation. O(n).
    #[must_use]
    #[inline]
    pub fn renumbered(mut self, place: &[u32]) -> Self {
        for triangle in &mut self.triangles {
            *triangle = triangle.map(|v| place[v as usize]);
        }
        let mut outgoing = vec![NONE; place.len()];
        for (v, &new) in place.iter().enumerate() {
            outgoing[new as usize] = self.outgoing[v];
        }
        Self { outgoing, ..self }
    }

    /// Writes a triangle so that its corners start at the given half-edge.
    fn set_corners(&mut self, half_edge: u32, corners: [u32; 3]) {
        let (triangle, first) = (half_edge as usize / 3, half_edge as usize % 3);
        for (k, corner) in corners.into_iter().enumerate() {
            self.triangles[triangle][(first + k) % 3] = corner;
        }
    }
}

/// Reverses the orientation of all triangles if it is opposite to that of the boundary polygon.
#[inline]
pub fn orient_along(triangles: &mut [[u32; 3]], boundary: &[u32]) {
    let edge = (boundary[0], boundary[1]);
    let along = triangles.iter().any(|&[a, b, c]| [(a, b), (b, c), (c, a)].contains(&edge));
    if !along {
        triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::SplitMix64;
    use proptest::prelude::*;

    /// A triangulated k x k grid.
    fn grid(k: u32) -> Topology {
        let at = |i, j| i * (k + 1) + j;
        let triangles: Vec<[u32; 3]> = (0..k)
            .flat_map(|i| (0..k).map(move |j| (i, j)))
            .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
            .collect();
        Topology::build(&triangles, ((k + 1) * (k + 1)) as usize).unwrap()
    }

    proptest! {
        #[test]
        fn flipped_topology_equals_the_one_built_afresh(edges in prop::collection::vec(0u32..96, 1..60)) {
            let mut topology = grid(4);
            for h in edges {
                if topology.can_flip(h) {
                    let (c, d) = (topology.opposite(h), topology.opposite(topology.twin[h as usize]));
                    topology.flip(h);
                    prop_assert_eq!((topology.from(h), topology.to(h)), (d, c));
                }
            }
            let fresh = Topology::build(topology.triangles(), 25).unwrap();
            prop_assert_eq!(&fresh.twin, &topology.twin);
            prop_assert_eq!(fresh.euler_characteristic(), 1);
            for v in 0..25 {
                let h = topology.outgoing[v as usize];
                prop_assert_eq!(topology.from(h), v);
                prop_assert_eq!(topology.is_boundary(v), fresh.is_boundary(v));
                prop_assert_eq!(
                    topology.outgoing_half_edges(v).count(), fresh.outgoing_half_edges(v).count());
            }
        }
    }

    /// Whether the half-edge structure, without its removed triangles, equals the structure that is built from its
    /// triangles.
    fn is_sound(topology: &Topology) -> bool {
        let left: Vec<u32> = (0..topology.triangles().len() as u32).filter(|&t| !topology.is_removed(t)).collect();
        let triangles: Vec<[u32; 3]> = left.iter().map(|&t| topology.triangles()[t as usize]).collect();
        let fresh = Topology::build(&triangles, topology.outgoing.len()).unwrap();
        let old = |h: u32| if h == NONE { NONE } else { 3 * left[h as usize / 3] + h % 3 };
        (0..fresh.twin.len() as u32).all(|h| topology.twin[old(h) as usize] == old(fresh.twin[h as usize]))
            && (0..fresh.outgoing.len() as u32).all(|v| {
                let h = topology.outgoing[v as usize];
                (h == NONE) == (fresh.outgoing[v as usize] == NONE)
                    && (h == NONE || topology.from(h) == v)
                    && topology.is_boundary(v) == fresh.is_boundary(v)
                    && topology.degree(v) == fresh.degree(v)
            })
    }

    #[test]
    fn collapses_leave_the_topology_that_is_built_afresh() {
        let (mut collapses, mut removals) = (0, 0);
        for seed in 0..20 {
            let mut topology = grid(6);
            let mut random = SplitMix64::new(seed);
            for _ in 0..400 {
                let h = random.below(topology.twin.len()) as u32;
                if topology.is_removed(h / 3) {
                    continue;
                }
                let (a, b) = (topology.from(h), topology.to(h));
                match random.below(4) {
                    0 if may_collapse(&topology, a, b) => {
                        topology.collapse(a, b);
                        collapses += 1;
                    }
                    1 => removals += usize::from(topology.remove_vertex_of_three(a).is_some()),
                    _ if topology.can_flip(h) => topology.flip(h),
                    _ => {}
                }
                assert!(is_sound(&topology), "seed {seed}");
            }
        }
        assert!(collapses > 200 && removals > 20, "{collapses} {removals}");
    }

    #[test]
    fn a_vertex_of_three_triangles_leaves_one_and_a_tetrahedron_stays() {
        let mut fan = Topology::build(&[[0, 1, 3], [1, 2, 3], [2, 0, 3]], 4).unwrap();
        assert_eq!(fan.remove_vertex_of_three(3), Some(0));
        assert_eq!(fan.triangles(), [[0, 1, 2], [NONE; 3], [NONE; 3]]);
        assert!(is_sound(&fan));
        let mut tetrahedron = Topology::build(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], 4).unwrap();
        assert_eq!(tetrahedron.remove_vertex_of_three(3), None);
    }

    #[test]
    fn subdivided_topology_equals_the_one_built_afresh() {
        let coarse = grid(3);
        let (fine, parents) = coarse.subdivided();
        assert_eq!((fine.triangles().len(), parents.len()), (4 * 18, coarse.edge_count()));
        let fresh = Topology::build(fine.triangles(), 16 + parents.len()).unwrap();
        assert_eq!(fresh.twin, fine.twin);
        for v in 0..fine.outgoing.len() as u32 {
            assert_eq!(fine.from(fine.outgoing[v as usize]), v);
            assert_eq!(fine.is_boundary(v), fresh.is_boundary(v));
        }
        for (k, &[a, b]) in parents.iter().enumerate() {
            assert!(fine.are_adjacent(a, 16 + k as u32) && fine.are_adjacent(b, 16 + k as u32));
        }
    }

    /// Input: the corner 0 and the vertex 4 have the common neighbour 3, and two vertices lie in the triangle between
    /// the three. This collapse must be refused, because it would leave two triangles on the same three vertices.
    #[test]
    fn an_edge_whose_ends_share_a_neighbour_around_a_corner_stays() {
        let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [0, 4, 5], [0, 5, 3], [5, 4, 6], [4, 3, 6], [5, 6, 3]];
        let topology = Topology::build(&triangles, 7).unwrap();
        assert!(!may_collapse(&topology, 4, 0) && !may_collapse(&topology, 0, 4));
        assert!(may_collapse(&topology, 6, 4) && may_collapse(&topology, 4, 6));
    }

    #[test]
    fn collapses_that_would_change_the_topology_are_refused() {
        let may = |triangles: &[[u32; 3]], count, a, b| may_collapse(&Topology::build(triangles, count).unwrap(), a, b);
        let tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        assert!(!may(&tetrahedron, 4, 0, 1), "the surface of a tetrahedron");
        assert!(!may(&[[0, 1, 2]], 3, 0, 1), "one triangle alone");
        assert!(!may(&[[0, 1, 2], [0, 2, 3]], 4, 0, 2), "the diagonal of a square joins two boundary vertices");
        assert!(may(&[[0, 1, 2], [0, 2, 3]], 4, 0, 1), "a side of a square");
        let fan = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        assert!(may(&fan, 5, 4, 0) && may(&fan, 5, 0, 1), "a spoke and a side of a fan");
    }

    /// On random triangulations, every collapse that the condition allows leaves a manifold of the same Euler
    /// characteristic and number of boundary loops, and every collapse that it refuses does not.
    #[test]
    fn the_link_condition_is_what_rebuilding_says() {
        let mut topology = grid(4);
        let mut random = SplitMix64::new(5);
        for _ in 0..300 {
            let h = random.below(topology.twin.len()) as u32;
            if topology.can_flip(h) {
                topology.flip(h);
            }
        }
        let mut seen = [0; 2];
        for h in 0..topology.twin.len() as u32 {
            let (a, b) = (topology.from(h), topology.to(h));
            let merged: Vec<[u32; 3]> = topology
                .triangles()
                .iter()
                .map(|triangle| triangle.map(|v| if v == a { b } else { v }))
                .filter(|[a, b, c]| a != b && b != c && c != a)
                .collect();
            let sound = Topology::build(&merged, 25).is_ok_and(|rebuilt| {
                let isolated = rebuilt.outgoing.iter().filter(|&&h| h == NONE).count();
                rebuilt.euler_characteristic() == 1 && rebuilt.boundary_loops().len() == 1 && isolated == 1
            });
            assert_eq!(may_collapse(&topology, a, b), sound, "{a} {b}");
            seen[usize::from(sound)] += 1;
        }
        assert!(seen[0] > 5 && seen[1] > 5, "{seen:?}");
    }

    #[test]
    fn a_flip_that_would_double_an_edge_is_refused() {
        // The faces of a tetrahedron: every pair of vertices is already joined by an edge.
        let topology = Topology::build(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], 4).unwrap();
        assert!((0..12).all(|h| !topology.can_flip(h)));
    }
}
