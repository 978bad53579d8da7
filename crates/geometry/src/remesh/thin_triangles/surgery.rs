//! Local changes of a triangle list under the knife: collapse an edge, remove a vertex, flip an edge, cut along three
//! edges.

use crate::DVec3;
use crate::mesh::edit::{Adjacency, may_collapse, may_flip};

/// A triangle list with, for each vertex, the triangles around it. Triangles and vertices that were removed leave gaps.
///
/// Every operation keeps it an oriented manifold if it was one, and refuses to work (`false` or `None`) where it could
/// not.
#[derive(Debug)]
pub(super) struct Surgery {
    pub vertices: Vec<DVec3>,
    /// Vertices that must neither move nor vanish.
    pub fixed: Vec<bool>,
    triangles: Vec<Option<[u32; 3]>>,
    around: Vec<Vec<u32>>,
}

/// The two sides of a cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Caps {
    pub left: u32,
    pub right: u32,
}

impl Surgery {
    pub fn new(vertices: Vec<DVec3>, fixed: Vec<bool>, triangles: &[[u32; 3]]) -> Self {
        let mut around = vec![Vec::new(); vertices.len()];
        for (t, triangle) in triangles.iter().enumerate() {
            triangle.iter().for_each(|&v| around[v as usize].push(t as u32));
        }
        Self { vertices, fixed, triangles: triangles.iter().copied().map(Some).collect(), around }
    }

    pub fn triangle(&self, t: u32) -> Option<[u32; 3]> {
        self.triangles[t as usize]
    }

    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    pub fn around(&self, vertex: u32) -> &[u32] {
        &self.around[vertex as usize]
    }

    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| self.vertices[v as usize])
    }

    /// The triangle that runs along the edge from a to b, and its third corner.
    pub fn left_of(&self, a: u32, b: u32) -> Option<(u32, u32)> {
        self.around[a as usize].iter().find_map(|&t| {
            let triangle = self.triangles[t as usize]?;
            (0..3).find_map(|k| (triangle[k] == a && triangle[(k + 1) % 3] == b).then_some((t, triangle[(k + 2) % 3])))
        })
    }

    pub fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let mut ring: Vec<u32> = self.around[vertex as usize]
            .iter()
            .filter_map(|&t| self.triangles[t as usize])
            .flatten()
            .filter(|&v| v != vertex)
            .collect();
        ring.sort_unstable();
        ring.dedup();
        ring
    }

    fn is_boundary_edge(&self, a: u32, b: u32) -> bool {
        self.left_of(a, b).is_some() != self.left_of(b, a).is_some()
    }

    fn is_boundary(&self, vertex: u32) -> bool {
        self.neighbours(vertex).into_iter().any(|other| self.is_boundary_edge(vertex, other))
    }

    fn remove(&mut self, t: u32) {
        if let Some(triangle) = self.triangles[t as usize].take() {
            triangle.iter().for_each(|&v| self.around[v as usize].retain(|&other| other != t));
        }
    }

    fn add(&mut self, triangle: [u32; 3]) -> u32 {
        let t = self.triangles.len() as u32;
        self.triangles.push(Some(triangle));
        triangle.iter().for_each(|&v| self.around[v as usize].push(t));
        t
    }

    /// A vertex c such that a-b-c are joined in pairs although no triangle at the edge a-b has the corner c: if a and b
    /// became one vertex, two edges would join it with c.
    pub fn third_of_empty_triangle(&self, a: u32, b: u32) -> Option<u32> {
        let faces = [self.left_of(a, b), self.left_of(b, a)].map(|face| face.map(|(_, corner)| corner));
        let others = self.neighbours(b);
        self.neighbours(a)
            .into_iter()
            .find(|&c| c != b && others.binary_search(&c).is_ok() && !faces.contains(&Some(c)))
    }

    /// Makes b one with a, at `place`; removes the triangles at their edge. Refuses where two edges would come to join
    /// the same vertices, where a boundary would close, and where b is fixed.
    pub fn collapse(&mut self, a: u32, b: u32, place: DVec3) -> bool {
        if self.fixed[b as usize] || !may_collapse(self, a, b) {
            return false;
        }
        let faces = [self.left_of(a, b), self.left_of(b, a)];
        for (t, _) in faces.into_iter().flatten() {
            self.remove(t);
        }
        for t in std::mem::take(&mut self.around[b as usize]) {
            if let Some(triangle) = &mut self.triangles[t as usize] {
                triangle.iter_mut().filter(|v| **v == b).for_each(|v| *v = a);
                self.around[a as usize].push(t);
            }
        }
        self.around[a as usize].sort_unstable();
        if !self.fixed[a as usize] {
            self.vertices[a as usize] = place;
        }
        true
    }

    /// Replaces the three triangles around an interior vertex by one; its number. Refuses other vertices.
    pub fn remove_vertex_of_three(&mut self, vertex: u32) -> Option<u32> {
        let faces: Vec<u32> = self.around[vertex as usize].clone();
        if faces.len() != 3 || self.fixed[vertex as usize] || self.is_boundary(vertex) {
            return None;
        }
        let triangle = self.triangles[faces[0] as usize]?;
        let k = triangle.iter().position(|&v| v == vertex)?;
        let (a, b) = (triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
        let (_, c) = self.left_of(vertex, b)?;
        // The same three corners the other way round: the rest of a closed tetrahedron.
        if self.left_of(b, a).is_some_and(|(_, corner)| corner == c) {
            return None;
        }
        faces.into_iter().for_each(|t| self.remove(t));
        Some(self.add([a, b, c]))
    }

    /// The four corners around an edge: its ends a, b, the corner to its left and the one to its right.
    pub fn quad(&self, a: u32, b: u32) -> Option<[u32; 4]> {
        let ((_, c), (_, d)) = (self.left_of(a, b)?, self.left_of(b, a)?);
        (c != d).then_some([a, b, c, d])
    }

    /// Replaces the edge a-b by the other diagonal of its two triangles; their numbers. Refuses where that diagonal
    /// exists.
    pub fn flip(&mut self, a: u32, b: u32) -> Option<[u32; 2]> {
        if !may_flip(self, a, b) {
            return None;
        }
        let [_, _, c, d] = self.quad(a, b)?;
        let (left, right) = (self.left_of(a, b)?.0, self.left_of(b, a)?.0);
        self.remove(left);
        self.remove(right);
        Some([self.add([d, c, a]), self.add([c, d, b])])
    }

    /// Cuts the surface open along the edges a-b, b-c and c-a, which no triangle spans, and closes either side with a
    /// triangle. Where a corner lies on the boundary, the side with the boundary keeps it. Refuses if one of the edges
    /// is a boundary edge, or a corner is fixed without lying on the boundary.
    pub fn cut(&mut self, a: u32, b: u32, c: u32) -> Option<Caps> {
        let cycle = [a, b, c];
        let mut left_sectors: [Vec<u32>; 3] = Default::default();
        let mut keeps_left = [true; 3];
        for k in 0..3 {
            let (before, x, after) = (cycle[(k + 2) % 3], cycle[k], cycle[(k + 1) % 3]);
            if self.left_of(x, after).is_none() || self.left_of(after, x).is_none() {
                return None;
            }
            let (sector, gap) = self.sector(before, x, after)?;
            let on_boundary = self.is_boundary(x);
            if self.fixed[x as usize] && !on_boundary {
                return None;
            }
            keeps_left[k] = gap || !on_boundary;
            left_sectors[k] = sector;
        }
        let mut left = cycle;
        let mut right = cycle;
        for k in 0..3 {
            let copy = self.vertices.len() as u32;
            self.vertices.push(self.vertices[cycle[k] as usize]);
            self.fixed.push(false);
            self.around.push(Vec::new());
            let moving: Vec<u32> = if keeps_left[k] {
                right[k] = copy;
                let stays = &left_sectors[k];
                self.around[cycle[k] as usize].iter().copied().filter(|t| !stays.contains(t)).collect()
            } else {
                left[k] = copy;
                left_sectors[k].clone()
            };
            for &t in &moving {
                if let Some(triangle) = &mut self.triangles[t as usize] {
                    triangle.iter_mut().filter(|v| **v == cycle[k]).for_each(|v| *v = copy);
                }
            }
            self.around[cycle[k] as usize].retain(|t| !moving.contains(t));
            self.around[copy as usize] = moving;
        }
        Some(Caps { left: self.add([left[0], left[2], left[1]]), right: self.add(right) })
    }

    /// The triangles around x to the left of the path before-x-after, and whether the boundary runs through them.
    fn sector(&self, before: u32, x: u32, after: u32) -> Option<(Vec<u32>, bool)> {
        let mut sector = Vec::new();
        let (mut spoke, mut gap) = (after, false);
        while spoke != before {
            let Some((t, corner)) = self.left_of(x, spoke) else {
                gap = true;
                break;
            };
            if sector.contains(&t) {
                return None;
            }
            sector.push(t);
            spoke = corner;
        }
        if gap {
            // The other half of the sector, from its other end back to the boundary.
            let mut spoke = before;
            while let Some((t, corner)) = self.left_of(spoke, x) {
                if sector.contains(&t) {
                    return None;
                }
                sector.push(t);
                spoke = corner;
            }
        }
        Some((sector, gap))
    }

    /// The triangles connected with one.
    pub fn component(&self, t: u32) -> Vec<u32> {
        let mut seen = vec![false; self.triangles.len()];
        let mut stack = vec![t];
        let mut component = Vec::new();
        seen[t as usize] = true;
        while let Some(t) = stack.pop() {
            component.push(t);
            for vertex in self.triangles[t as usize].into_iter().flatten() {
                for &other in &self.around[vertex as usize] {
                    if !std::mem::replace(&mut seen[other as usize], true) {
                        stack.push(other);
                    }
                }
            }
        }
        component
    }

    /// Whether these triangles (a component) have no boundary and no fixed vertex, so that nothing holds them.
    pub fn is_loose(&self, component: &[u32]) -> bool {
        component.iter().filter_map(|&t| self.triangles[t as usize]).all(|triangle| {
            (0..3).all(|k| {
                let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
                !self.fixed[a as usize] && self.left_of(b, a).is_some()
            })
        })
    }

    pub fn remove_all(&mut self, triangles: &[u32]) {
        triangles.iter().for_each(|&t| self.remove(t));
    }

    /// The triangles that are left, over the vertices that are left: renumbered in order, and for each new vertex its
    /// old number.
    pub fn finish(self) -> (Vec<DVec3>, Vec<bool>, Vec<[u32; 3]>, Vec<u32>) {
        let stays = |v: u32| self.fixed[v as usize] || !self.around[v as usize].is_empty();
        let old: Vec<u32> = (0..self.vertices.len() as u32).filter(|&v| stays(v)).collect();
        let mut renamed = vec![u32::MAX; self.vertices.len()];
        old.iter().enumerate().for_each(|(new, &old)| renamed[old as usize] = new as u32);
        let vertices = old.iter().map(|&v| self.vertices[v as usize]).collect();
        let fixed = old.iter().map(|&v| self.fixed[v as usize]).collect();
        let triangles = self.triangles.into_iter().flatten().map(|t| t.map(|v| renamed[v as usize])).collect();
        (vertices, fixed, triangles, old)
    }
}

impl Adjacency for Surgery {
    fn opposite_corners(&self, a: u32, b: u32) -> [Option<u32>; 2] {
        [self.left_of(a, b), self.left_of(b, a)].map(|face| face.map(|(_, corner)| corner))
    }

    fn joined(&self, a: u32, b: u32) -> bool {
        self.left_of(a, b).is_some() || self.left_of(b, a).is_some()
    }

    fn any_neighbour(&self, vertex: u32, condition: impl FnMut(u32) -> bool) -> bool {
        self.neighbours(vertex).into_iter().any(condition)
    }

    fn degree(&self, vertex: u32) -> usize {
        self.around[vertex as usize].len()
    }

    fn on_boundary(&self, vertex: u32) -> bool {
        self.is_boundary(vertex)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mesh;
    use crate::mesh::topology::Topology;

    /// A tube of `rings` rings of `n` vertices, open at both ends; the ends are fixed.
    fn tube(n: u32, rings: u32) -> Surgery {
        let vertices = (0..rings * n)
            .map(|v| {
                let angle = f64::from(v % n) * std::f64::consts::TAU / f64::from(n);
                DVec3::new(angle.cos(), angle.sin(), f64::from(v / n))
            })
            .collect();
        let triangles: Vec<[u32; 3]> = (0..rings - 1)
            .flat_map(|i| (0..n).map(move |j| (i * n + j, i * n + (j + 1) % n)))
            .flat_map(|(a, b)| [[a, b, b + n], [a, b + n, a + n]])
            .collect();
        let fixed = (0..rings * n).map(|v| v < n || v >= (rings - 1) * n).collect();
        Surgery::new(vertices, fixed, &triangles)
    }

    fn topology(surgery: Surgery) -> Topology {
        let (vertices, _, triangles, _) = surgery.finish();
        Mesh::new(vertices, triangles).check().unwrap()
    }

    #[test]
    fn a_cut_through_a_neck_of_three_leaves_two_discs() {
        let mut surgery = tube(3, 5);
        assert_eq!(surgery.third_of_empty_triangle(6, 7), Some(8));
        assert!(!surgery.collapse(6, 7, DVec3::ZERO));
        let caps = surgery.cut(6, 7, 8).unwrap();
        assert!(!surgery.component(caps.left).contains(&caps.right));
        assert!(!surgery.is_loose(&surgery.component(caps.left)));
        let topology = topology(surgery);
        assert_eq!(
            (topology.components(), topology.boundary_loops().len(), topology.euler_characteristic()),
            (2, 2, 2)
        );
    }

    #[test]
    fn a_cut_that_touches_the_boundary_leaves_the_boundary_on_one_side() {
        // A tube of three: the ring 3-4-5 beside the boundary ring 0-1-2. When vertex 3 has collapsed into the boundary
        // vertex 0, the vertices 0, 4 and 5 are joined in pairs across the tube.
        let mut surgery = tube(3, 4);
        let place = surgery.vertices[0];
        assert!(surgery.collapse(0, 3, place));
        assert_eq!(surgery.third_of_empty_triangle(4, 5), Some(0));
        surgery.cut(0, 4, 5).unwrap();
        let topology = topology(surgery);
        assert_eq!(
            (topology.components(), topology.boundary_loops().len(), topology.euler_characteristic()),
            (2, 2, 2)
        );
        assert_eq!(topology.boundary_loops().iter().map(Vec::len).sum::<usize>(), 6);
    }

    #[test]
    fn a_cut_along_the_boundary_is_refused() {
        assert_eq!(tube(3, 3).cut(0, 1, 2), None);
    }

    #[test]
    fn closed_components_are_loose() {
        let corners = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let surgery = Surgery::new(corners, vec![false; 4], &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
        assert!(surgery.is_loose(&surgery.component(0)));
    }

    #[test]
    fn a_vertex_of_three_triangles_can_go_and_an_edge_can_collapse() {
        let mut surgery = tube(6, 4);
        let before = surgery.triangles.iter().flatten().count();
        let middle = surgery.vertices.len() as u32;
        surgery.vertices.push(DVec3::ZERO);
        surgery.fixed.push(false);
        surgery.around.push(Vec::new());
        let [a, b, c] = surgery.triangle(12).unwrap();
        surgery.remove(12);
        for t in [[a, b, middle], [b, c, middle], [c, a, middle]] {
            surgery.add(t);
        }
        let new = surgery.remove_vertex_of_three(middle).unwrap();
        let mut corners = surgery.triangle(new).unwrap();
        corners.sort_unstable();
        let mut expected = [a, b, c];
        expected.sort_unstable();
        assert_eq!(corners, expected);
        assert!(surgery.collapse(6, 7, DVec3::ZERO));
        assert_eq!(surgery.triangles.iter().flatten().count(), before - 2);
        assert_eq!(topology(surgery).euler_characteristic(), 0);
    }
}
