//! First and second variation of a film's area in the directions in which its vertices may move.

use super::sheets::{Kind, Sheets};
use crate::DVec3;
use crate::sparse::{Symbolic, SymmetricMatrix};

/// The directions in which the vertices move, one unknown each: a sheet's vertex along its normal, a junction's vertex in two
/// directions across the curve, a point's vertex (and, for the Laplacian, every vertex) in three.
#[derive(Clone, Debug)]
pub(super) struct Directions {
    /// Vertex v owns the unknowns `start[v]..start[v + 1]`.
    pub start: Vec<usize>,
    pub direction: Vec<DVec3>,
}

impl Directions {
    pub fn of(film: &Sheets) -> Self {
        let mut normals = vec![DVec3::ZERO; film.vertices.len()];
        for &triangle in &film.triangles {
            let [a, b, c] = film.corners(triangle);
            let normal = (b - a).cross(c - a);
            triangle.iter().for_each(|&v| normals[v as usize] += normal);
        }
        let (mut start, mut direction) = (vec![0], Vec::new());
        for (v, kind) in film.kinds.iter().enumerate() {
            match kind {
                Kind::Fixed => {}
                Kind::Sheet => direction.push(normals[v].normalize_or_zero()),
                Kind::Junction(_) => {
                    let (u, w) = film.tangent(v).any_orthonormal_pair();
                    direction.extend([u, w]);
                }
                Kind::Point => direction.extend(DVec3::AXES),
            }
            start.push(direction.len());
        }
        Self { start, direction }
    }

    fn of_vertex(&self, v: u32) -> std::ops::Range<usize> {
        self.start[v as usize]..self.start[v as usize + 1]
    }

    /// The parts of one vector per vertex along the directions.
    pub fn components(&self, vectors: &[DVec3]) -> Vec<f64> {
        let of_vertex = |(v, vector): (usize, &DVec3)| {
            let vector = *vector;
            self.direction[self.start[v]..self.start[v + 1]].iter().map(move |direction| vector.dot(*direction))
        };
        vectors.iter().enumerate().flat_map(of_vertex).collect()
    }

    /// All vertices, moved by `fraction` of a step.
    pub fn moved(&self, film: &Sheets, step: &[f64], fraction: f64) -> Vec<DVec3> {
        (0..film.vertices.len())
            .map(|v| {
                let range = self.start[v]..self.start[v + 1];
                film.vertices[v] + range.map(|k| fraction * step[k] * self.direction[k]).sum::<DVec3>()
            })
            .collect()
    }
}

impl Sheets {
    /// The unit tangent of a junction at one of its vertices; x where it vanishes.
    pub fn tangent(&self, v: usize) -> DVec3 {
        match self.kinds[v] {
            Kind::Junction([a, b]) => (self.vertices[b as usize] - self.vertices[a as usize]).normalize_or(DVec3::X),
            _ => DVec3::X,
        }
    }

    /// The area's gradient at every vertex.
    pub fn gradient(&self, vertices: &[DVec3]) -> Vec<DVec3> {
        let mut gradient = vec![DVec3::ZERO; vertices.len()];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| vertices[v as usize]);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            for (v, edge) in triangle.iter().zip([c - b, a - c, b - a]) {
                gradient[*v as usize] += 0.5 * normal.cross(edge);
            }
        }
        gradient
    }
}

/// One solve of Pinkall and Polthier on the whole film, junctions included: moves the free vertices to the minimum of the Dirichlet energy
/// over the film as it is, which lowers the area. False where the system has no trustworthy solution; nothing moves then.
pub(super) fn dirichlet_step(film: &mut Sheets) -> bool {
    let mut start = vec![0];
    let mut free = Vec::new();
    for (v, kind) in film.kinds.iter().enumerate() {
        free.extend((*kind != Kind::Fixed).then_some(v));
        start.push(free.len());
    }
    // One unknown a vertex, the same for all three coordinates; its direction does not matter.
    let unknowns = Directions { start, direction: vec![DVec3::ZERO; free.len()] };
    let mut laplacian = SecondVariation::new(film, &unknowns);
    let mut image = vec![0.0; 3 * free.len()];
    for &triangle in &film.triangles {
        let [a, b, c] = film.corners(triangle);
        let edges = [c - b, a - c, b - a];
        let length = edges[2].cross(c - a).length().max(f64::MIN_POSITIVE);
        for (i, &v) in triangle.iter().enumerate() {
            for row in unknowns.of_vertex(v) {
                for (j, &w) in triangle.iter().enumerate() {
                    let weight = edges[i].dot(edges[j]) / (2.0 * length);
                    match unknowns.of_vertex(w).next() {
                        Some(column) => {
                            let slot = laplacian.slot(&unknowns, v, row, w, column);
                            laplacian.matrix.values[slot] += weight;
                        }
                        None => {
                            let pull = weight * film.vertices[w as usize];
                            for axis in 0..3 {
                                image[axis * free.len() + row] -= pull[axis];
                            }
                        }
                    }
                }
            }
        }
    }
    let solved = Symbolic::analyse(&laplacian.matrix, None).and_then(|symbolic| {
        let factors = symbolic.factorise(&laplacian.matrix)?;
        factors.solve(&mut image)?;
        Ok(factors.inertia().is_positive_definite())
    });
    if solved != Ok(true) {
        return false;
    }
    for (row, &v) in free.iter().enumerate() {
        film.vertices[v] = DVec3::from_array([0, 1, 2].map(|axis| image[axis * free.len() + row]));
    }
    true
}

/// The second variation of area, on one connectivity's pattern.
#[derive(Debug)]
pub(super) struct SecondVariation {
    pub matrix: SymmetricMatrix,
    /// For each vertex its neighbours, itself first, then ascending.
    neighbours: Vec<Vec<u32>>,
}

impl SecondVariation {
    pub fn new(film: &Sheets, directions: &Directions) -> Self {
        let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); film.vertices.len()];
        for triangle in &film.triangles {
            for k in 0..3 {
                neighbours[triangle[k] as usize].extend([triangle[(k + 1) % 3], triangle[(k + 2) % 3]]);
            }
        }
        for (v, ring) in neighbours.iter_mut().enumerate() {
            ring.sort_unstable();
            ring.dedup();
            ring.insert(0, v as u32);
        }
        let mut matrix = SymmetricMatrix { row_start: vec![0], ..Default::default() };
        for v in 0..film.vertices.len() as u32 {
            let own = directions.of_vertex(v);
            for row in own.clone() {
                // The diagonal first in its row, as the matrix's type asks for.
                matrix.columns.push(row as u32);
                matrix.columns.extend(own.clone().filter(|&column| column != row).map(|column| column as u32));
                for &other in &neighbours[v as usize][1..] {
                    matrix.columns.extend(directions.of_vertex(other).map(|column| column as u32));
                }
                matrix.row_start.push(matrix.columns.len() as u32);
            }
        }
        matrix.values = vec![0.0; matrix.columns.len()];
        Self { matrix, neighbours }
    }

    /// Fills the matrix. With m the double area vector and m_i its derivative in direction N_i, the second derivative of |m| / 2 is
    /// (m_i·m_j - (n·m_i)(n·m_j)) / (2|m|) + ½ n·m_ij; the first part, positive semidefinite, counts `1 + shift` times.
    pub fn assemble(&mut self, film: &Sheets, directions: &Directions, shift: f64) {
        self.matrix.values.fill(0.0);
        for &triangle in &film.triangles {
            let [a, b, c] = film.corners(triangle);
            let edges = [c - b, a - c, b - a];
            let vector = edges[2].cross(c - a);
            let length = vector.length().max(f64::MIN_POSITIVE);
            let normal = vector / length;
            for i in 0..3 {
                for row in directions.of_vertex(triangle[i]) {
                    let towards = directions.direction[row];
                    let first = edges[i].cross(towards);
                    for j in 0..3 {
                        for column in directions.of_vertex(triangle[j]) {
                            let other = directions.direction[column];
                            let second = edges[j].cross(other);
                            let stretch = (first.dot(second) - normal.dot(first) * normal.dot(second)) / (2.0 * length);
                            let turn = match (j + 3 - i) % 3 {
                                0 => 0.0,
                                1 => 0.5 * normal.dot(towards.cross(other)),
                                _ => -0.5 * normal.dot(towards.cross(other)),
                            };
                            let slot = self.slot(directions, triangle[i], row, triangle[j], column);
                            self.matrix.values[slot] += (1.0 + shift) * stretch + turn;
                        }
                    }
                }
            }
        }
    }

    /// Where the entry of an unknown of v and one of w stands.
    fn slot(&self, directions: &Directions, v: u32, row: usize, w: u32, column: usize) -> usize {
        let own = directions.of_vertex(v);
        let begin = self.matrix.row_start[row] as usize;
        if v == w {
            // The diagonal has moved to the front of the vertex's own unknowns.
            let (row, column) = (row - own.start, column - own.start);
            return begin + if column == row { 0 } else { column + usize::from(column < row) };
        }
        let mut at = begin + own.len();
        for &other in &self.neighbours[v as usize][1..] {
            let range = directions.of_vertex(other);
            if other == w {
                return at + (column - range.start);
            }
            at += range.len();
        }
        at
    }
}
