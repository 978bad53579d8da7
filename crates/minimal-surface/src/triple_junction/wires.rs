//! Finds the boundaries of a film with junctions among the vertices and edges of its mesh.

use super::film::JunctionFilm;
use crate::initial_mesh::ON_SEGMENT;
use plateau_mesh::polyline::position_key;
use plateau_mesh::topology::edge_key;
use plateau_mesh::{DVec3, Error, Mesh, Place};

/// The boundaries as loops of mesh vertices, and new numbers for all vertices. First come the vertices at boundary
/// points, in the order of their first appearance, then the vertices between two neighbouring boundary points, then all
/// others.
#[derive(Debug)]
pub(super) struct Wires {
    /// The vertices of each boundary, with the new numbers. Vertices between its points are included.
    pub loops: Vec<Vec<u32>>,
    /// The vertex at each boundary point, one boundary after the other, with the new numbers.
    pub vertex_of: Vec<u32>,
    /// Number of distinct boundary points. Their vertices have the first numbers.
    pub points: usize,
    /// The new number of each vertex of the given mesh.
    number: Vec<u32>,
}

impl Wires {
    pub fn find(boundaries: &[Vec<DVec3>], mesh: &Mesh) -> Result<Self, Error> {
        let mut known: Vec<([u64; 3], u32)> =
            mesh.vertices.iter().enumerate().map(|(v, &p)| (position_key(p), v as u32)).collect();
        known.sort_unstable();
        let mut number = vec![u32::MAX; mesh.vertices.len()];
        let mut points = 0;
        let mut corners: Vec<Vec<u32>> = Vec::with_capacity(boundaries.len());
        for (k, boundary) in boundaries.iter().enumerate() {
            let mut vertices = Vec::with_capacity(boundary.len());
            for &point in boundary {
                let at = known.partition_point(|&(other, _)| other < position_key(point));
                let Some(&(_, old)) = known.get(at).filter(|&&(other, _)| other == position_key(point)) else {
                    let detail = format!("has no vertex at a point of boundary {k}");
                    return Err(Error::input(Place::field("initial_mesh").then("vertices"), detail));
                };
                if number[old as usize] == u32::MAX {
                    number[old as usize] = points;
                    points += 1;
                }
                vertices.push(old);
            }
            corners.push(vertices);
        }
        let rim = Rim::of(mesh);
        let loops: Vec<Vec<u32>> = corners
            .iter()
            .map(|corners| {
                let along = |k: usize| rim.between(mesh, corners[k], corners[(k + 1) % corners.len()]);
                (0..corners.len()).flat_map(|k| [vec![corners[k]], along(k)].concat()).collect()
            })
            .collect();
        let mut next = points;
        for old in loops.iter().flatten().copied().chain(0..mesh.vertices.len() as u32) {
            if number[old as usize] == u32::MAX {
                number[old as usize] = next;
                next += 1;
            }
        }
        let renumbered = |vertices: &Vec<u32>| -> Vec<u32> { vertices.iter().map(|&v| number[v as usize]).collect() };
        let vertex_of = corners.iter().flat_map(renumbered).collect();
        let loops = loops.iter().map(renumbered).collect();
        Ok(Self { loops, vertex_of, points: points as usize, number })
    }

    pub fn renumbered(&self, mesh: &Mesh) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let mut vertices = mesh.vertices.clone();
        mesh.vertices.iter().zip(&self.number).for_each(|(&p, &v)| vertices[v as usize] = p);
        // A number that is out of range is reported when the triangles are read.
        let renumber = |v: u32| self.number.get(v as usize).copied().unwrap_or(v);
        (vertices, mesh.triangles.iter().map(|t| t.map(renumber)).collect())
    }

    /// Checks that the edges with one triangle are exactly the segments of the boundaries.
    pub fn check(&self, film: &JunctionFilm) -> Result<(), Error> {
        let mut wires: Vec<[u32; 2]> = self
            .loops
            .iter()
            .flat_map(|boundary| {
                (0..boundary.len()).map(|k| edge_key([boundary[k], boundary[(k + 1) % boundary.len()]]))
            })
            .collect();
        wires.sort_unstable();
        wires.dedup();
        let rim: Vec<[u32; 2]> = film.complex.edges().filter(|edge| edge.count() == 1).map(|edge| edge.ends).collect();
        if rim == wires {
            return Ok(());
        }
        let missing = wires.iter().filter(|edge| rim.binary_search(edge).is_err()).count();
        let loose = rim.iter().filter(|edge| wires.binary_search(edge).is_err()).count();
        let detail = format!(
            "its edges of one triangle must be the boundaries' segments: {missing} segments are no such edge, {loose} \
             such edges are no segment"
        );
        Err(Error::input(Place::field("initial_mesh"), detail))
    }
}

/// The edges with exactly one triangle, each in both directions, sorted.
#[derive(Debug)]
pub(super) struct Rim(pub Vec<[u32; 2]>);

impl Rim {
    pub fn of(mesh: &Mesh) -> Self {
        let mut sides: Vec<[u32; 2]> = mesh
            .triangles
            .iter()
            .filter(|triangle| triangle.iter().all(|&v| (v as usize) < mesh.vertices.len()))
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]].map(edge_key))
            .collect();
        sides.sort_unstable();
        let single = sides.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).map(|same| same[0]);
        let mut edges: Vec<[u32; 2]> = single.flat_map(|[a, b]| [[a, b], [b, a]]).collect();
        edges.sort_unstable();
        Self(edges)
    }

    /// Returns the vertices that the mesh has on the segment between two of its vertices, in order. The result is empty
    /// if no path of edges with one triangle leads along the segment from one end to the other.
    pub fn between(&self, mesh: &Mesh, from: u32, to: u32) -> Vec<u32> {
        let (a, b) = (mesh.vertices[from as usize], mesh.vertices[to as usize]);
        let along = b - a;
        let part = |v: u32| along.dot(mesh.vertices[v as usize] - a) / along.length_squared();
        let is_beside =
            |v: u32| along.cross(mesh.vertices[v as usize] - a).length() > ON_SEGMENT * along.length_squared();
        let (mut vertices, mut here) = (Vec::new(), from);
        // At most one pass per vertex, because each vertex lies further along the segment than the one before.
        loop {
            let first = self.0.partition_point(|edge| edge[0] < here);
            let mut ahead = self.0[first..].iter().take_while(|edge| edge[0] == here).map(|edge| edge[1]);
            if ahead.clone().any(|v| v == to) {
                return vertices;
            }
            let Some(next) = ahead.find(|&v| !is_beside(v) && part(v) > part(here) && part(v) < 1.0) else {
                return Vec::new();
            };
            vertices.push(next);
            here = next;
        }
    }
}
