//! Connectivity of a triangle list: half-edge twins, boundary loops, components, Euler characteristic. This module does
//! not use positions.

use std::fmt;

/// Stands for a missing half-edge, such as the twin of a boundary half-edge.
pub const NONE: u32 = u32::MAX;

/// The key of an edge, which does not depend on its direction: the ends with the smaller number first.
#[must_use]
#[inline]
pub fn edge_key([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// A defect of a mesh. See [`Topology::build`] and [`Mesh::check`](crate::Mesh::check).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defect {
    /// A triangle names a vertex that does not exist.
    VertexOutOfRange {
        /// The number of the triangle.
        triangle: usize,
    },
    /// A triangle names a vertex twice.
    RepeatedVertex {
        /// The number of the triangle.
        triangle: usize,
    },
    /// Three or more triangles share an edge, or two neighbours run along it in the same direction.
    NonManifoldEdge {
        /// An end of the edge.
        from: u32,
        /// The other end.
        to: u32,
    },
    /// The triangles around a vertex form more than one fan.
    NonManifoldVertex {
        /// The number of the vertex.
        vertex: u32,
    },
    /// A vertex belongs to no triangle.
    IsolatedVertex {
        /// The number of the vertex.
        vertex: u32,
    },
    /// A coordinate is infinite or not a number.
    NotFinite {
        /// The number of the vertex.
        vertex: u32,
    },
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::VertexOutOfRange { triangle } => write!(f, "triangle {triangle} names a vertex that does not exist"),
            Self::RepeatedVertex { triangle } => write!(f, "triangle {triangle} names a vertex twice"),
            Self::NonManifoldEdge { from, to } => write!(
                f,
                "the edge between the vertices {from} and {to} has three or more triangles, or two that run along it \
                 in the same direction"
            ),
            Self::NonManifoldVertex { vertex } => {
                write!(f, "the triangles around vertex {vertex} form more than one fan")
            }
            Self::IsolatedVertex { vertex } => write!(f, "vertex {vertex} belongs to no triangle"),
            Self::NotFinite { vertex } => write!(f, "vertex {vertex} has a coordinate that is not finite"),
        }
    }
}

impl std::error::Error for Defect {}

/// Half-edge connectivity. Half-edge `3 t + k` runs from corner `k` to corner `(k + 1) % 3` of triangle `t`.
#[derive(Clone, Debug)]
pub struct Topology {
    /// The opposite half-edge, or [`NONE`] on the boundary.
    pub twin: Vec<u32>,
    /// An outgoing half-edge of each vertex; for a boundary vertex the outgoing *boundary* half-edge. [`NONE`] if
    /// isolated.
    pub outgoing: Vec<u32>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// The next half-edge in the same triangle.
#[must_use]
#[inline]
pub fn next(half_edge: u32) -> u32 {
    if half_edge % 3 == 2 { half_edge - 2 } else { half_edge + 1 }
}

/// The previous half-edge in the same triangle.
#[must_use]
#[inline]
pub fn previous(half_edge: u32) -> u32 {
    if half_edge.is_multiple_of(3) { half_edge + 2 } else { half_edge - 1 }
}

impl Topology {
    /// Builds the connectivity of a triangle list by pairing the half-edges. O(n log n), deterministic.
    ///
    /// # Errors
    /// The first defect that is found. The indices are checked first, then the edges, then the vertices. Isolated
    /// vertices are allowed here; [`check`](crate::check) refuses them.
    pub fn build(triangles: &[[u32; 3]], vertex_count: usize) -> Result<Self, Defect> {
        for (triangle, &[a, b, c]) in triangles.iter().enumerate() {
            if [a, b, c].iter().any(|&v| v as usize >= vertex_count) {
                return Err(Defect::VertexOutOfRange { triangle });
            }
            if a == b || b == c || c == a {
                return Err(Defect::RepeatedVertex { triangle });
            }
        }
        // The half-edges are sorted by their lower vertex (counting sort), so that the half-edges of an edge lie in the
        // same short bucket.
        let mut start = vec![0u32; vertex_count + 1];
        let corner = |h: usize| triangles[h / 3][h % 3];
        let ends = |h: usize| (corner(h), corner(if h % 3 == 2 { h - 2 } else { h + 1 }));
        let count = 3 * triangles.len();
        for h in 0..count {
            let (a, b) = ends(h);
            start[a.min(b) as usize + 1] += 1;
        }
        for v in 0..vertex_count {
            start[v + 1] += start[v];
        }
        let mut cursor = start.clone();
        // The higher vertex and the number of each half-edge of a bucket.
        let mut bucket = vec![(0u32, 0u32); count];
        for h in 0..count {
            let (a, b) = ends(h);
            let slot = &mut cursor[a.min(b) as usize];
            bucket[*slot as usize] = (a.max(b), h as u32);
            *slot += 1;
        }
        let mut twin = vec![NONE; count];
        let mut outgoing = vec![NONE; vertex_count];
        for v in 0..vertex_count {
            let edges = &mut bucket[start[v] as usize..start[v + 1] as usize];
            edges.sort_unstable();
            let mut k = 0;
            // Ends because `length` counts the half-edge at `k` too and is at least 1.
            while k < edges.len() {
                let (higher, h) = edges[k];
                let length = edges[k..].iter().take_while(|edge| edge.0 == higher).count();
                let (a, b) = ends(h as usize);
                match length {
                    1 => {}
                    2 if ends(edges[k + 1].1 as usize) == (b, a) => {
                        let other = edges[k + 1].1;
                        twin[h as usize] = other;
                        twin[other as usize] = h;
                    }
                    _ => return Err(Defect::NonManifoldEdge { from: a, to: b }),
                }
                k += length;
            }
        }
        let mut degree = vec![0u32; vertex_count];
        for h in 0..count {
            let from = corner(h) as usize;
            degree[from] += 1;
            if outgoing[from] == NONE || (twin[h] == NONE && twin[outgoing[from] as usize] != NONE) {
                outgoing[from] = h as u32;
            }
        }
        let topology = Self { twin, outgoing, triangles: triangles.to_vec() };
        for v in 0..vertex_count as u32 {
            if topology.outgoing_half_edges(v).count() as u32 != degree[v as usize] {
                return Err(Defect::NonManifoldVertex { vertex: v });
            }
        }
        Ok(topology)
    }

    /// The vertex at which a half-edge starts.
    #[must_use]
    #[inline]
    pub fn from(&self, half_edge: u32) -> u32 {
        self.triangles[half_edge as usize / 3][half_edge as usize % 3]
    }

    /// The vertex at which a half-edge ends.
    #[must_use]
    #[inline]
    pub fn to(&self, half_edge: u32) -> u32 {
        self.from(next(half_edge))
    }

    /// The outgoing half-edges of a vertex, clockwise. For a boundary vertex the first one is its boundary half-edge.
    /// The last edge of the fan of a boundary vertex has no outgoing half-edge, only the incoming boundary half-edge.
    #[inline]
    pub fn outgoing_half_edges(&self, vertex: u32) -> impl Iterator<Item = u32> + '_ {
        let first = self.outgoing[vertex as usize];
        let mut current = first;
        // previous(h) is the incoming half-edge of the same triangle. Its twin leaves the vertex again.
        std::iter::from_fn(move || {
            if current == NONE {
                return None;
            }
            let result = current;
            let after = self.twin[previous(current) as usize];
            current = if after == first { NONE } else { after };
            Some(result)
        })
    }

    /// Whether a vertex lies on the boundary.
    #[must_use]
    #[inline]
    pub fn is_boundary(&self, vertex: u32) -> bool {
        let h = self.outgoing[vertex as usize];
        h != NONE && self.twin[h as usize] == NONE
    }

    /// The boundary loops as lists of vertices, in the direction of the half-edges of their triangles. The loops are
    /// sorted by their smallest half-edge.
    #[must_use]
    pub fn boundary_loops(&self) -> Vec<Vec<u32>> {
        let mut seen = vec![false; self.twin.len()];
        let mut loops = Vec::new();
        for first in 0..self.twin.len() as u32 {
            if self.twin[first as usize] != NONE || seen[first as usize] {
                continue;
            }
            let mut vertices = Vec::new();
            let mut current = first;
            // Ends because each pass marks a half-edge that was not marked before.
            while !seen[current as usize] {
                seen[current as usize] = true;
                vertices.push(self.from(current));
                current = self.outgoing[self.to(current) as usize];
            }
            loops.push(vertices);
        }
        loops
    }

    /// Number of connected components of the triangles (isolated vertices do not count).
    #[must_use]
    pub fn components(&self) -> usize {
        let mut seen = vec![false; self.triangles.len()];
        let mut stack = Vec::new();
        let mut components = 0;
        for start in 0..self.triangles.len() {
            if seen[start] {
                continue;
            }
            components += 1;
            seen[start] = true;
            stack.push(start);
            // At most one pass per triangle, because each is added once.
            while let Some(triangle) = stack.pop() {
                for k in 0..3 {
                    let twin = self.twin[3 * triangle + k];
                    if twin != NONE && !seen[twin as usize / 3] {
                        seen[twin as usize / 3] = true;
                        stack.push(twin as usize / 3);
                    }
                }
            }
        }
        components
    }

    /// Number of edges, including boundary edges.
    #[must_use]
    #[inline]
    pub fn edge_count(&self) -> usize {
        let boundary = self.twin.iter().filter(|&&twin| twin == NONE).count();
        (self.twin.len() - boundary) / 2 + boundary
    }

    /// The Euler characteristic V - E + F, where V counts only the vertices that belong to a triangle.
    #[must_use]
    #[inline]
    pub fn euler_characteristic(&self) -> i64 {
        let used = self.outgoing.iter().filter(|&&h| h != NONE).count();
        used as i64 - self.edge_count() as i64 + self.triangles.len() as i64
    }

    /// Total genus of the components: (2 C - loops - χ) / 2 (orientable surfaces only, which this type guarantees).
    #[must_use]
    #[inline]
    pub fn genus(&self) -> i64 {
        (2 * self.components() as i64 - self.boundary_loops().len() as i64 - self.euler_characteristic()) / 2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_annulus_has_two_loops_and_euler_characteristic_zero() {
        let n = 5u32;
        let triangles: Vec<[u32; 3]> = (0..n)
            .flat_map(|k| {
                let next = (k + 1) % n;
                [[k, next, n + k], [next, n + next, n + k]]
            })
            .collect();
        let topology = Topology::build(&triangles, 2 * n as usize).unwrap();
        assert_eq!(topology.boundary_loops().len(), 2);
        assert_eq!(topology.boundary_loops()[0], [0, 1, 2, 3, 4]);
        assert_eq!((topology.euler_characteristic(), topology.genus(), topology.components()), (0, 0, 1));
    }

    #[test]
    fn a_tetrahedron_is_closed() {
        let topology = Topology::build(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], 4).unwrap();
        assert_eq!((topology.euler_characteristic(), topology.boundary_loops().len(), topology.genus()), (2, 0, 0));
        assert_eq!(topology.outgoing_half_edges(3).count(), 3);
    }

    #[test]
    fn defects_are_named() {
        assert_eq!(Topology::build(&[[0, 1, 5]], 3).unwrap_err(), Defect::VertexOutOfRange { triangle: 0 });
        assert_eq!(Topology::build(&[[0, 1, 1]], 3).unwrap_err(), Defect::RepeatedVertex { triangle: 0 });
        let same_direction = Topology::build(&[[0, 1, 2], [0, 1, 3]], 4).unwrap_err();
        assert_eq!(same_direction, Defect::NonManifoldEdge { from: 0, to: 1 });
        let bow_tie = Topology::build(&[[0, 1, 2], [0, 3, 4]], 5).unwrap_err();
        assert_eq!(bow_tie, Defect::NonManifoldVertex { vertex: 0 });
    }
}
