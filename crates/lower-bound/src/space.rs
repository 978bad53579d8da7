//! The finite-element space of a mesh: its unknowns, the curl as a linear map, and the circulation around the boundary
//! as a linear form.

use super::bisection::{BisectionMesh, EDGES, VertexMap};
use super::element::{self, Orientation, UNKNOWNS};
use super::hull::Hull;
use plateau_mesh::DVec3;
use plateau_mesh::disjoint_sets::DisjointSets;
use plateau_mesh::topology::edge_key;

/// The unknowns of one mesh: first one for each edge, then two for each face.
#[derive(Debug)]
pub(super) struct Space {
    pub edges: Vec<[u32; 2]>,
    pub faces: Vec<[u32; 3]>,
    /// For each leaf, the numbers of its unknowns: those of its six edges, then two for each of its four faces.
    pub unknowns: Vec<[u32; UNKNOWNS]>,
    pub orientations: Vec<Orientation>,
    /// Corners of each leaf.
    pub corners: Vec<[DVec3; 4]>,
    /// For each unknown, whether it is fixed. An unknown is fixed if it belongs to no constrained leaf, if it is zero
    /// by symmetry, or if it is an edge of a spanning tree. Fixing the tree determines the gradient that could be added
    /// to the field without changing its curl.
    pub gauge: Vec<bool>,
    /// For each vertex, the planes of symmetry on which it lies, as a bit for each axis.
    planes: Vec<u8>,
    /// The planes of symmetry in which the field has no tangential component, because the field changes its sign there.
    /// A bit for each axis.
    odd_planes: u8,
    /// Number of mirror images of the mesh, including the mesh itself.
    images: usize,
    /// The constrained leaves, in which |curl A| <= 1 is imposed, in ascending order. Lists of curls have one entry for
    /// each of them.
    pub constrained: Vec<u32>,
}

impl Space {
    /// The space of the whole mesh, constrained in all leaves.
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
            planes: (0..mesh.vertices.len() as u32).map(|vertex| mesh.planes_at(vertex)).collect(),
            odd_planes: mesh.mirrors().odd(),
            images: mesh.mirrors().images(),
            constrained: (0..leaves as u32).collect(),
        };
        for leaf in 0..leaves {
            let vertices = mesh.leaf_vertices(leaf);
            let orientation = Orientation::of(vertices);
            let mut unknowns = [0; UNKNOWNS];
            for (e, [a, b]) in EDGES.into_iter().enumerate() {
                let key = edge_key([vertices[a], vertices[b]]);
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
        space.gauge = space.fixed_unknowns();
        space
    }

    /// The space of the whole mesh, constrained only in the leaves that do not lie outside one of the hull's
    /// half-spaces.
    pub fn within(mesh: &BisectionMesh, hull: &Hull) -> Self {
        let mut space = Self::of(mesh);
        let meets = |leaf: &u32| hull.separating(&space.corners[*leaf as usize]).is_none();
        let leaves = space.constrained.iter().copied().filter(meets).collect();
        space.constrain(leaves);
        space
    }

    /// Constrains only the given leaves, which must be in ascending order.
    pub(super) fn constrain(&mut self, leaves: Vec<u32>) {
        self.constrained = leaves;
        self.gauge = self.fixed_unknowns();
    }

    /// The planes of symmetry in which an edge or a face lies, as a bit for each axis.
    fn planes_of(&self, vertices: &[u32]) -> u8 {
        vertices.iter().fold(u8::MAX, |planes, &vertex| planes & self.planes[vertex as usize])
    }

    /// Whether the field's tangential component vanishes on an edge or a face.
    fn vanishes(&self, vertices: &[u32]) -> bool {
        self.planes_of(vertices) & self.odd_planes != 0
    }

    /// Whether the constrained leaves and their mirror images together have the Euler characteristic of a ball. If they
    /// surround a hole, some fields with zero curl are not gradients, and the system would be singular.
    pub fn is_a_ball(&self) -> bool {
        let used = self.used_unknowns();
        let (edges, faces) = used.split_at(self.edges.len());
        let mut vertices: Vec<u32> =
            self.edges.iter().zip(edges).filter(|(_, used)| **used).flat_map(|(edge, _)| *edge).collect();
        vertices.sort_unstable();
        vertices.dedup();
        // A vertex, edge or face in a plane of symmetry is its own image there.
        let images = |of: &[u32]| self.images >> self.planes_of(of).count_ones();
        let vertices: usize = vertices.iter().map(|&vertex| images(&[vertex])).sum();
        let edges: usize = self.edges.iter().zip(edges).filter(|(_, used)| **used).map(|(edge, _)| images(edge)).sum();
        // Each face has two unknowns.
        let faces = self.faces.iter().zip(faces.chunks_exact(2));
        let faces: usize = faces.filter(|(_, used)| used[0]).map(|(face, _)| images(face)).sum();
        vertices + faces == edges + self.images * self.constrained.len() + 1
    }

    /// For each unknown, whether it belongs to a constrained leaf.
    fn used_unknowns(&self) -> Vec<bool> {
        let mut used = vec![false; self.count()];
        for &leaf in &self.constrained {
            self.unknowns[leaf as usize].iter().for_each(|&unknown| used[unknown as usize] = true);
        }
        used
    }

    pub fn count(&self) -> usize {
        self.edges.len() + 2 * self.faces.len()
    }

    /// Marks the fixed unknowns: those that belong to no constrained leaf, those that are zero by symmetry, and the
    /// edges of a spanning tree of the remaining vertices. The tree takes edges in the order of their numbers.
    fn fixed_unknowns(&self) -> Vec<bool> {
        let mut joined = DisjointSets::new(self.planes.len());
        let mut fixed: Vec<bool> = self.used_unknowns().into_iter().map(|used| !used).collect();
        // The edges on which the field vanishes come first, because the potential of the gradient is constant along
        // them.
        for vanishing in [true, false] {
            for (e, edge @ &[a, b]) in self.edges.iter().enumerate() {
                if fixed[e] || self.vanishes(edge) != vanishing {
                    continue;
                }
                fixed[e] = vanishing || joined.leader(a) != joined.leader(b);
                joined.join(a, b);
            }
        }
        for (face, fixed) in self.faces.iter().zip(fixed[self.edges.len()..].chunks_exact_mut(2)) {
            if self.vanishes(face) {
                fixed.fill(true);
            }
        }
        fixed
    }

    /// Returns one of the two fields that the mesh carries: `which` is [`BEST`](super::bisection::BEST) or
    /// [`CENTRAL`](super::bisection::CENTRAL).
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
        // The values on edges and faces where the field vanishes are zero up to rounding, and are set to zero exactly.
        let (on_edges, on_faces) = field.split_at_mut(self.edges.len());
        for (edge, value) in self.edges.iter().zip(on_edges) {
            if self.vanishes(edge) {
                *value = 0.0;
            }
        }
        for (face, values) in self.faces.iter().zip(on_faces.chunks_exact_mut(2)) {
            if self.vanishes(face) {
                values.fill(0.0);
            }
        }
        field
    }

    /// The curl at the four vertices of a leaf.
    pub fn curl_in(&self, leaf: usize, field: &[f64]) -> [DVec3; 4] {
        let basis = element::basis_curls(self.corners[leaf], &self.orientations[leaf]);
        let values = self.unknowns[leaf].map(|unknown| field[unknown as usize]);
        basis.map(|at| at.iter().zip(values).map(|(&curl, value)| curl * value).sum())
    }

    /// The curl at the four vertices of every constrained leaf.
    pub fn curl(&self, field: &[f64]) -> Vec<[DVec3; 4]> {
        self.constrained.iter().map(|&leaf| self.curl_in(leaf as usize, field)).collect()
    }

    /// Applies the transposed curl to values at the vertices of every constrained leaf, and adds the result to `out`.
    pub fn transposed_curl(&self, values: impl Fn(usize, usize) -> DVec3, out: &mut [f64]) {
        for (k, &leaf) in self.constrained.iter().enumerate() {
            let leaf = leaf as usize;
            let basis = element::basis_curls(self.corners[leaf], &self.orientations[leaf]);
            for (p, at) in basis.iter().enumerate() {
                let value = values(k, p);
                for (&unknown, curl) in self.unknowns[leaf].iter().zip(at) {
                    out[unknown as usize] += curl.dot(value);
                }
            }
        }
    }

    /// The circulation of each basis function around closed polygons: the coefficients of a linear form.
    pub fn circulation<'a>(&self, mesh: &BisectionMesh, loops: impl IntoIterator<Item = &'a Vec<DVec3>>) -> Vec<f64> {
        let mut form = vec![0.0; self.count()];
        for points in loops {
            for (k, &from) in points.iter().enumerate() {
                let to = points[(k + 1) % points.len()];
                for piece in mesh.trace(from, to) {
                    let leaf = piece.leaf as usize;
                    let values = element::integrals(piece.from, piece.to, &self.orientations[leaf]);
                    let sign = mesh.mirrors().sign(piece.flips);
                    for (&unknown, value) in self.unknowns[leaf].iter().zip(values) {
                        form[unknown as usize] += sign * value;
                    }
                }
            }
        }
        form
    }
}
