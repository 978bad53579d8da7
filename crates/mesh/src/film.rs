//! The working state of a solver: a mesh that spans given boundaries, and which of its vertices and edges are fixed.

use crate::measure;
use crate::topology::{Defect, NONE, Topology};
use crate::{DVec3, Mesh};

/// A mesh that spans given boundaries, while a solver works on it. Positions are relative to the mean of the boundary
/// points.
///
/// The input points of the boundaries are the first vertices. Points that were added on the boundary may have any later
/// numbers, depending on the kind of initial mesh.
#[derive(Clone, Debug)]
pub struct Film {
    pub vertices: Vec<DVec3>,
    pub topology: Topology,
    /// Vertices that never move: the boundary, and points that the caller fixed.
    pub fixed: Vec<bool>,
    /// Edges that must not be removed or flipped, each with its smaller vertex first, sorted. Boundary edges always
    /// stay and are not listed.
    pub locked: Vec<[u32; 2]>,
    /// The boundary loops, in the order and direction of the input.
    pub boundaries: Vec<Vec<u32>>,
}

impl Film {
    /// A film without constraints: the boundary loops are fixed, and all other vertices move. `None` if the triangles
    /// do not form a manifold.
    #[inline]
    pub fn new(vertices: Vec<DVec3>, triangles: &[[u32; 3]], boundaries: Vec<Vec<u32>>) -> Option<Self> {
        let topology = Topology::build(triangles, vertices.len()).ok()?;
        let mut fixed = vec![false; vertices.len()];
        for &vertex in boundaries.iter().flatten() {
            fixed[vertex as usize] = true;
        }
        Some(Self { vertices, topology, fixed, locked: Vec::new(), boundaries })
    }

    #[inline]
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.topology.triangles()
    }

    #[inline]
    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|vertex| self.vertices[vertex as usize])
    }

    #[inline]
    pub fn area(&self) -> f64 {
        self.triangles().iter().map(|&t| 0.5 * measure::double_area_vector(self.corners(t)).length()).sum()
    }

    /// Number of flipped triangles, whose normal points against the sum of their three vertex normals.
    #[inline]
    pub fn flipped_triangles(&self) -> usize {
        let normals = measure::normals(&self.vertices, self.triangles());
        measure::count_flipped(&self.vertices, self.triangles(), &normals)
    }

    /// R: the largest distance of a boundary vertex from the mean of the boundary vertices.
    #[inline]
    pub fn radius(&self) -> f64 {
        let points: Vec<DVec3> = self.boundaries.iter().flatten().map(|&v| self.vertices[v as usize]).collect();
        let mean = crate::polyline::mean(&points);
        points.iter().map(|point| point.distance(mean)).fold(0.0, f64::max)
    }

    /// Whether the edge between two vertices must stay.
    #[inline]
    pub fn is_locked(&self, a: u32, b: u32) -> bool {
        !self.locked.is_empty() && self.locked.binary_search(&[a.min(b), a.max(b)]).is_ok()
    }

    /// Deletes the triangles marked as removed and the vertices without a triangle, and renumbers the others in the
    /// same order. Fixed vertices are always kept.
    ///
    /// # Errors
    /// The defect, if the remaining triangles do not form an oriented manifold. The film is then unchanged.
    #[inline]
    pub fn close_gaps(&mut self) -> Result<(), Defect> {
        let stays = |v: usize| self.fixed[v] || self.topology.outgoing[v] != NONE;
        let (topology, left) = self.topology.without_gaps(stays)?;
        self.topology = topology;
        self.vertices = left.of(&self.vertices);
        self.fixed = left.of(&self.fixed);
        // The vertices of the boundaries and of the locked edges are fixed, and fixed vertices are kept.
        let own = self.boundaries.iter_mut().flatten().chain(self.locked.iter_mut().flatten());
        own.for_each(|v| *v = left.number(*v));
        Ok(())
    }

    #[inline]
    pub fn mesh(&self) -> Mesh {
        Mesh::new(self.vertices.clone(), self.triangles().to_vec())
    }

    #[inline]
    pub fn into_mesh(self) -> Mesh {
        let triangles = self.topology.triangles().to_vec();
        Mesh::new(self.vertices, triangles)
    }

    /// The same film with vertex `v` renumbered to `place[v]`.
    #[inline]
    pub fn renumbered(self, place: &[u32]) -> Self {
        let moved = |v: u32| place[v as usize];
        let mut vertices = vec![DVec3::ZERO; place.len()];
        let mut fixed = vec![false; place.len()];
        for (v, &new) in place.iter().enumerate() {
            vertices[new as usize] = self.vertices[v];
            fixed[new as usize] = self.fixed[v];
        }
        let mut locked: Vec<[u32; 2]> = self.locked.iter().map(|edge| edge.map(moved)).collect();
        locked.iter_mut().for_each(|edge| edge.sort_unstable());
        locked.sort_unstable();
        let boundaries = self.boundaries.iter().map(|boundary| boundary.iter().map(|&v| moved(v)).collect()).collect();
        Self { vertices, topology: self.topology.renumbered(place), fixed, locked, boundaries }
    }

    /// The renumbering that moves the points added on the boundaries directly behind the first `input_points` vertices:
    /// the new number of each vertex. `None` if they are already there.
    #[inline]
    pub fn boundary_first(&self, input_points: usize) -> Option<Vec<u32>> {
        let added: Vec<u32> =
            self.boundaries.iter().flatten().copied().filter(|&v| v as usize >= input_points).collect();
        if added.iter().enumerate().all(|(k, &v)| v as usize == input_points + k) {
            return None;
        }
        let count = self.vertices.len();
        let mut is_added = vec![false; count];
        added.iter().for_each(|&v| is_added[v as usize] = true);
        let rest = (input_points..count).filter(|&v| !is_added[v]).map(|v| v as u32);
        let order = (0..input_points as u32).chain(added.iter().copied()).chain(rest);
        let mut place = vec![0u32; count];
        order.enumerate().for_each(|(new, old)| place[old as usize] = new as u32);
        Some(place)
    }
}
