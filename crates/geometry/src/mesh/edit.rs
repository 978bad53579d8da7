//! Changes of connectivity that keep a mesh an oriented manifold: when an edge may be flipped or collapsed, flipping
//! the diagonal of two triangles, and regular subdivision.

use crate::mesh::topology::{NONE, Topology, next, previous};

/// Questions that the rules for flips and collapses ask of a representation of an oriented manifold.
pub(crate) trait Adjacency {
    /// The corners opposite to the edge in its triangles: on the left of a to b, and on the right.
    fn opposite_corners(&self, a: u32, b: u32) -> [Option<u32>; 2];
    /// Whether an edge joins the two vertices.
    fn joined(&self, a: u32, b: u32) -> bool;
    /// Whether a neighbour of the vertex fulfils a condition.
    fn any_neighbour(&self, vertex: u32, condition: impl FnMut(u32) -> bool) -> bool;
    /// Number of triangles around the vertex.
    fn degree(&self, vertex: u32) -> usize;
    /// Whether the vertex lies on the boundary.
    fn on_boundary(&self, vertex: u32) -> bool;
}

/// Whether the edge between a and b may be replaced by the other diagonal of its two triangles: it has two, and no edge
/// joins their far corners yet. Says nothing about shape.
pub(crate) fn may_flip(mesh: &impl Adjacency, a: u32, b: u32) -> bool {
    match mesh.opposite_corners(a, b) {
        [Some(c), Some(d)] => c != d && !mesh.joined(c, d),
        _ => false,
    }
}

/// The link condition (Dey, Edelsbrunner, Guha, Nekhayev, *Topology preserving edge contraction*, 1999): whether the
/// edge between a and b may become a point, so that the mesh stays a manifold of the same topology.
///
/// 1. The edge has a triangle. An edge of two triangles does not join two boundary vertices.
/// 2. The ends have no common neighbour but the corners opposite to the edge.
/// 3. The mesh is not the surface of a tetrahedron, nor two triangles back to back.
/// 4. No corner opposite to the edge is left without a triangle.
pub(crate) fn may_collapse(mesh: &impl Adjacency, a: u32, b: u32) -> bool {
    let corners = mesh.opposite_corners(a, b);
    let keeps_form = match corners {
        [None, None] => false,
        [Some(c), Some(d)] => {
            let tetrahedron = mesh.degree(c) == 3
                && mesh.degree(d) == 3
                && !mesh.on_boundary(c)
                && !mesh.on_boundary(d)
                && mesh.joined(c, d);
            c != d && !tetrahedron && !(mesh.on_boundary(a) && mesh.on_boundary(b))
        }
        _ => true,
    };
    keeps_form
        && corners.into_iter().flatten().all(|corner| mesh.degree(corner) > 1)
        && !mesh.any_neighbour(a, |v| v != b && !corners.contains(&Some(v)) && mesh.joined(v, b))
}

impl Adjacency for Topology {
    fn opposite_corners(&self, a: u32, b: u32) -> [Option<u32>; 2] {
        [(a, b), (b, a)]
            .map(|(from, to)| self.outgoing_half_edges(from).find(|&h| self.to(h) == to).map(|h| self.opposite(h)))
    }

    fn joined(&self, a: u32, b: u32) -> bool {
        self.are_adjacent(a, b)
    }

    fn any_neighbour(&self, vertex: u32, mut condition: impl FnMut(u32) -> bool) -> bool {
        // A vertex of the boundary reaches its last neighbour only as an opposite corner.
        self.outgoing_half_edges(vertex).any(|h| {
            let corner = self.opposite(h);
            condition(self.to(h)) || (self.twin[previous(h) as usize] == NONE && condition(corner))
        })
    }

    fn degree(&self, vertex: u32) -> usize {
        self.outgoing_half_edges(vertex).count()
    }

    fn on_boundary(&self, vertex: u32) -> bool {
        self.is_boundary(vertex)
    }
}

impl Topology {
    /// The triangles as they are now.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Whether an edge joins the two vertices.
    #[must_use]
    pub fn are_adjacent(&self, a: u32, b: u32) -> bool {
        self.outgoing_half_edges(a).any(|h| self.to(h) == b || self.from(previous(h)) == b)
    }

    /// The vertex opposite a half-edge in its triangle.
    #[must_use]
    pub fn opposite(&self, half_edge: u32) -> u32 {
        self.from(previous(half_edge))
    }

    /// Whether the edge has two triangles and its two opposite vertices are not joined yet, so that
    /// [`flip`](Self::flip) keeps the mesh a manifold. Says nothing about shape.
    #[must_use]
    pub fn can_flip(&self, half_edge: u32) -> bool {
        let twin = self.twin[half_edge as usize];
        if twin == NONE {
            return false;
        }
        let (c, d) = (self.opposite(half_edge), self.opposite(twin));
        c != d && !self.are_adjacent(c, d)
    }

    /// Replaces the edge a-b of the triangles (a, b, c) and (b, a, d) by the edge d-c: (d, c, a) and (c, d, b).
    ///
    /// The half-edge keeps its index and then runs from d to c. Only where [`can_flip`](Self::can_flip) allows it.
    pub fn flip(&mut self, half_edge: u32) {
        let (h, g) = (half_edge, self.twin[half_edge as usize]);
        debug_assert!(self.can_flip(h));
        let (a, b) = (self.from(h), self.to(h));
        let (c, d) = (self.opposite(h), self.opposite(g));
        let (bc, ca, ad, db) = (next(h), previous(h), next(g), previous(g));
        let outside = [bc, ca, ad, db].map(|e| self.twin[e as usize]);
        self.set_corners(h, [d, c, a]);
        self.set_corners(g, [c, d, b]);
        // Where each of the four outer half-edges stands now.
        let moved = [(previous(g), b), (next(h), c), (previous(h), a), (next(g), d)];
        for ((place, vertex), twin) in moved.into_iter().zip(outside) {
            self.twin[place as usize] = twin;
            if twin != NONE {
                self.twin[twin as usize] = place;
            }
            // A boundary vertex keeps its outgoing boundary half-edge; if that was one of the four, it has moved.
            let before = self.outgoing[vertex as usize];
            if [h, g, bc, ca, ad, db].contains(&before) {
                self.outgoing[vertex as usize] = place;
            }
        }
    }

    /// Splits every triangle into four at its edges' midpoints: the new topology, and for each new vertex the ends of
    /// the edge that it halves.
    ///
    /// Old vertices keep their numbers, new ones follow. Triangle `t` becomes `4 t + k` at its corner `k` and `4 t + 3`
    /// in the middle. O(n), without pairing half-edges afresh.
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
        // The two halves of half-edge 3 t + k: from corner k to the midpoint, and on to the next corner.
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

    /// The same triangles with vertex `v` as number `place[v]`, a permutation. O(n).
    #[must_use]
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

/// Turns all triangles over if they run against the boundary.
pub(crate) fn orient_along(triangles: &mut [[u32; 3]], boundary: &[u32]) {
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

    /// Input: the corner 0 and the vertex 4 have the neighbour 3 in common, and two vertices stand in the triangle
    /// between. When this collapse was allowed, two triangles stood on one another.
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

    /// On random triangulations every collapse that the condition allows leaves a manifold of the same Euler
    /// characteristic and number of boundary loops, and every one that it refuses does not.
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
        // The faces of a tetrahedron: every pair of vertices is joined already.
        let topology = Topology::build(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], 4).unwrap();
        assert!((0..12).all(|h| !topology.can_flip(h)));
    }
}
