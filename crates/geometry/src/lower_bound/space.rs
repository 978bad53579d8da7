//! The unknowns of a mesh, the curl as a linear map, and the circulation around the boundary as a linear form.

use super::bisection::{BisectionMesh, EDGES, VertexMap, edge_key};
use super::element::{self, Orientation, UNKNOWNS};
use crate::DVec3;

/// Numbers of the unknowns, for one mesh: the edges first, then the faces.
#[derive(Debug)]
pub(super) struct Space {
    pub edges: Vec<[u32; 2]>,
    pub faces: Vec<[u32; 3]>,
    /// For each leaf its unknowns: six edges, then four pairs of a face.
    pub unknowns: Vec<[u32; UNKNOWNS]>,
    pub orientations: Vec<Orientation>,
    /// Corners of each leaf.
    pub corners: Vec<[DVec3; 4]>,
    /// For each unknown whether it is left as it is: the edges of a spanning tree, which settle the gradient that may
    /// be added to the field without changing its curl.
    pub gauge: Vec<bool>,
}

impl Space {
    pub fn of(mesh: &BisectionMesh) -> Self {
        let leaves = mesh.leaf_count();
        let mut edge_numbers: VertexMap<[u32; 2], u32> = VertexMap::default();
        let mut face_numbers: VertexMap<[u32; 3], u32> = VertexMap::default();
        let mut space = Self {
            edges: Vec::new(),
            faces: Vec::new(),
            unknowns: Vec::with_capacity(leaves),
            orientations: Vec::with_capacity(leaves),
            corners: Vec::with_capacity(leaves),
            gauge: Vec::new(),
        };
        for leaf in 0..leaves {
            let vertices = mesh.leaf_vertices(leaf);
            let orientation = Orientation::of(vertices);
            let mut unknowns = [0; UNKNOWNS];
            for (e, [a, b]) in EDGES.into_iter().enumerate() {
                let key = edge_key(vertices[a], vertices[b]);
                unknowns[e] = *edge_numbers.entry(key).or_insert_with(|| {
                    space.edges.push(key);
                    space.edges.len() as u32 - 1
                });
            }
            for (f, face) in orientation.faces.into_iter().enumerate() {
                let key = face.map(|position| vertices[position]);
                let number = *face_numbers.entry(key).or_insert_with(|| {
                    space.faces.push(key);
                    space.faces.len() as u32 - 1
                });
                (unknowns[6 + 2 * f], unknowns[7 + 2 * f]) = (2 * number, 2 * number + 1);
            }
            space.unknowns.push(unknowns);
            space.orientations.push(orientation);
            space.corners.push(vertices.map(|v| mesh.vertices[v as usize]));
        }
        let edge_count = space.edges.len() as u32;
        for unknowns in &mut space.unknowns {
            unknowns[6..].iter_mut().for_each(|unknown| *unknown += edge_count);
        }
        space.gauge = space.spanning_tree(mesh.vertices.len());
        space
    }

    pub fn count(&self) -> usize {
        self.edges.len() + 2 * self.faces.len()
    }

    /// Marks the edges of a spanning tree of the vertices, shortest numbers first.
    fn spanning_tree(&self, vertices: usize) -> Vec<bool> {
        let mut parent: Vec<u32> = (0..vertices as u32).collect();
        fn root(parent: &mut [u32], mut v: u32) -> u32 {
            while parent[v as usize] != v {
                parent[v as usize] = parent[parent[v as usize] as usize];
                v = parent[v as usize];
            }
            v
        }
        let mut gauge = vec![false; self.count()];
        for (e, &[a, b]) in self.edges.iter().enumerate() {
            let (a, b) = (root(&mut parent, a), root(&mut parent, b));
            if a != b {
                parent[b as usize] = a;
                gauge[e] = true;
            }
        }
        gauge
    }

    /// One of the two fields that the mesh carries.
    pub fn field(&self, mesh: &BisectionMesh, which: usize) -> Vec<f64> {
        let mut field: Vec<f64> = self.edges.iter().map(|edge| mesh.edges[edge].circulation[which]).collect();
        field.resize(self.count(), 0.0);
        for (leaf, unknowns) in self.unknowns.iter().enumerate() {
            for (f, face) in self.orientations[leaf].faces.into_iter().enumerate() {
                let corners = face.map(|position| self.corners[leaf][position]);
                let curls = face.map(|position| mesh.nodal[leaf].curl[which][position]);
                let [first, second] = element::face_unknowns(corners, curls);
                field[unknowns[6 + 2 * f] as usize] = first;
                field[unknowns[7 + 2 * f] as usize] = second;
            }
        }
        field
    }

    /// The curl at the four vertices of every leaf.
    pub fn curl(&self, field: &[f64]) -> Vec<[DVec3; 4]> {
        let of = |leaf: usize| {
            let basis = element::basis_curls(self.corners[leaf], &self.orientations[leaf]);
            let values = self.unknowns[leaf].map(|unknown| field[unknown as usize]);
            basis.map(|at| at.iter().zip(values).map(|(&curl, value)| curl * value).sum())
        };
        (0..self.unknowns.len()).map(of).collect()
    }

    /// Adds the transposed curl of values at the vertices of every leaf.
    pub fn transposed_curl(&self, values: impl Fn(usize, usize) -> DVec3, out: &mut [f64]) {
        for (leaf, unknowns) in self.unknowns.iter().enumerate() {
            let basis = element::basis_curls(self.corners[leaf], &self.orientations[leaf]);
            for (p, at) in basis.iter().enumerate() {
                let value = values(leaf, p);
                for (&unknown, curl) in unknowns.iter().zip(at) {
                    out[unknown as usize] += curl.dot(value);
                }
            }
        }
    }

    /// The circulation of each basis function around closed polygons.
    pub fn circulation(&self, mesh: &BisectionMesh, loops: &[Vec<DVec3>]) -> Vec<f64> {
        let mut form = vec![0.0; self.count()];
        for points in loops {
            for (k, &from) in points.iter().enumerate() {
                let to = points[(k + 1) % points.len()];
                for piece in mesh.trace(from, to) {
                    let leaf = piece.leaf as usize;
                    let values = element::integrals(piece.from, piece.to, &self.orientations[leaf]);
                    for (&unknown, value) in self.unknowns[leaf].iter().zip(values) {
                        form[unknown as usize] += value;
                    }
                }
            }
        }
        form
    }
}
