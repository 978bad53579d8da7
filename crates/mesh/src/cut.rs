//! Closes a neck of three edges: cuts the surface along the edges and closes each side with a triangle.

use crate::topology::{NONE, Topology, next, previous};

/// The two triangles that close the sides of a cut, and the vertices that the cut doubled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cut {
    /// The triangle that closes the side to the left of the three edges.
    pub left: u32,
    /// The triangle that closes the side to the right.
    pub right: u32,
    /// The vertices whose copies were added, in the order of their new numbers.
    pub copied: [u32; 3],
}

/// The outgoing half-edges of a vertex on the left of a path that passes through the vertex.
struct Sector {
    half_edges: Vec<u32>,
    /// Whether the boundary runs through the sector.
    has_boundary: bool,
}

impl Topology {
    /// Cuts the surface along the edges a-b, b-c and c-a, which are not the edges of one triangle, and closes each side
    /// with a triangle. Each of the three vertices gets a copy with a new number. If a vertex lies on the boundary, the
    /// side with the boundary keeps the old number; otherwise the left side keeps it. Returns `None`, without a change,
    /// unless a, b and c are joined by edges of two triangles each.
    pub(crate) fn cut(&mut self, cycle: [u32; 3]) -> Option<Cut> {
        let edge = |k: usize| self.half_edge(cycle[k], cycle[(k + 1) % 3]).filter(|&h| self.twin[h as usize] != NONE);
        let edges = [edge(0)?, edge(1)?, edge(2)?];
        let twins = edges.map(|h| self.twin[h as usize]);
        let sectors = [0, 1, 2].map(|k| self.sector_to_the_left(edges[(k + 2) % 3], edges[k]));
        let (mut left, mut right) = (cycle, cycle);
        for (k, sector) in sectors.iter().enumerate() {
            let copy = self.outgoing.len() as u32;
            self.outgoing.push(NONE);
            let left_keeps = sector.has_boundary || !self.is_boundary(cycle[k]);
            let moving: Vec<u32> = if left_keeps {
                right[k] = copy;
                self.outgoing_half_edges(cycle[k]).filter(|h| !sector.half_edges.contains(h)).collect()
            } else {
                left[k] = copy;
                sector.half_edges.clone()
            };
            for h in moving {
                self.triangles[h as usize / 3][h as usize % 3] = copy;
            }
        }
        let left_cap = self.add([left[0], left[2], left[1]]);
        let right_cap = self.add(right);
        for k in 0..3 {
            self.pair(3 * left_cap + (2 - k as u32), edges[k]);
            self.pair(3 * right_cap + k as u32, twins[k]);
        }
        for k in 0..3 {
            self.set_outgoing(left[k], edges[k]);
            self.set_outgoing(right[k], 3 * right_cap + k as u32);
        }
        Some(Cut { left: left_cap, right: right_cap, copied: cycle })
    }

    /// The sector on the left of the path that arrives along one half-edge and leaves along another.
    fn sector_to_the_left(&self, arriving: u32, leaving: u32) -> Sector {
        let mut half_edges = vec![leaving];
        let mut h = leaving;
        // The walk turns anticlockwise from the leaving half-edge to the triangle of the arriving half-edge.
        // Ends because a vertex has one fan: the walk meets the triangle or the boundary.
        while previous(h) != arriving {
            h = self.twin[previous(h) as usize];
            if h == NONE {
                break;
            }
            half_edges.push(h);
        }
        let has_boundary = h == NONE;
        if has_boundary {
            // The rest of the sector, clockwise from the arriving half-edge to the boundary.
            h = next(arriving);
            half_edges.push(h);
            // Ends because the fan of a vertex on the boundary is open.
            while self.twin[h as usize] != NONE {
                h = next(self.twin[h as usize]);
                half_edges.push(h);
            }
        }
        Sector { half_edges, has_boundary }
    }

    /// The triangles of a triangle's connected component, this triangle first. Triangles are connected across edges.
    pub(crate) fn component_of(&self, triangle: u32) -> Vec<u32> {
        let mut seen = vec![false; self.triangles.len()];
        seen[triangle as usize] = true;
        let mut component = vec![triangle];
        let mut at = 0;
        // At most one pass per triangle, because each is added once.
        while let Some(&t) = component.get(at) {
            at += 1;
            for &twin in &self.twin[3 * t as usize..3 * t as usize + 3] {
                if twin != NONE && !std::mem::replace(&mut seen[twin as usize / 3], true) {
                    component.push(twin / 3);
                }
            }
        }
        component
    }

    /// Removes a whole component with its vertices.
    pub(crate) fn remove_component(&mut self, triangles: &[u32]) {
        for &t in triangles {
            self.triangles[t as usize].into_iter().for_each(|v| self.outgoing[v as usize] = NONE);
        }
        triangles.iter().for_each(|&t| self.take_out(t));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::may_collapse;

    /// A tube of `rings` rings of `n` vertices, open at both ends.
    fn tube(n: u32, rings: u32) -> Topology {
        let triangles: Vec<[u32; 3]> = (0..rings - 1)
            .flat_map(|i| (0..n).map(move |j| (i * n + j, i * n + (j + 1) % n)))
            .flat_map(|(a, b)| [[a, b, b + n], [a, b + n, a + n]])
            .collect();
        Topology::build(&triangles, (rings * n) as usize).unwrap()
    }

    /// Builds the topology again from the triangles that were not removed, and asserts that its vertices agree. Returns
    /// the number of components, the boundary loops and the Euler characteristic.
    fn rebuilt(topology: &Topology) -> (usize, Vec<Vec<u32>>, i64) {
        let left: Vec<[u32; 3]> = topology.triangles().iter().copied().filter(|t| t[0] != NONE).collect();
        let fresh = Topology::build(&left, topology.outgoing.len()).unwrap();
        for v in 0..topology.outgoing.len() as u32 {
            assert_eq!(topology.is_boundary(v), fresh.is_boundary(v));
            assert_eq!(topology.degree(v), fresh.degree(v));
        }
        (fresh.components(), fresh.boundary_loops(), fresh.euler_characteristic())
    }

    #[test]
    fn a_cut_through_a_neck_of_three_leaves_two_discs() {
        let mut topology = tube(3, 5);
        assert!(!may_collapse(&topology, 6, 7));
        let cut = topology.cut([6, 7, 8]).unwrap();
        assert!(!topology.component_of(cut.left).contains(&cut.right));
        let (components, loops, characteristic) = rebuilt(&topology);
        assert_eq!((components, loops.len(), characteristic), (2, 2, 2));
    }

    #[test]
    fn a_cut_that_touches_the_boundary_leaves_the_boundary_on_one_side() {
        // A tube whose rings have three vertices each: the ring 3-4-5 is next to the boundary ring 0-1-2. After vertex
        // 3 has collapsed into the boundary vertex 0, the vertices 0, 4 and 5 form a neck of three edges around the
        // tube.
        for cycle in [[0, 4, 5], [5, 4, 0]] {
            let mut topology = tube(3, 4);
            topology.collapse(0, 3);
            topology.cut(cycle).unwrap();
            let (components, loops, characteristic) = rebuilt(&topology);
            assert_eq!((components, loops.len(), characteristic), (2, 2, 2));
            assert_eq!(loops.iter().map(Vec::len).sum::<usize>(), 6);
            assert!(loops.iter().flatten().all(|&v| v < 12), "the boundary keeps its vertices");
        }
    }

    #[test]
    fn a_cut_along_the_boundary_is_refused() {
        assert_eq!(tube(3, 3).cut([0, 1, 2]), None);
    }

    #[test]
    fn a_component_can_be_taken_out() {
        let mut topology = tube(3, 5);
        let cut = topology.cut([6, 7, 8]).unwrap();
        let side = topology.component_of(cut.right);
        topology.remove_component(&side);
        let (components, loops, characteristic) = rebuilt(&topology);
        assert_eq!((components, loops.len(), characteristic), (1, 1, 1));
    }
}
