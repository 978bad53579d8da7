//! The area's first and second variation on a triangle mesh, as sums over triangles of cotangents.
//!
//! Sources: Pinkall, Polthier, *Computing Discrete Minimal Surfaces and Their Conjugates* (1993), section 2 (the
//! cotangent Laplacian, whose value at the positions is the area gradient); the second variation in normal directions
//! is worked out here:
//!
//! With corners 0, 1, 2 in the triangle's order, e_i the edge opposite to corner i (from corner i + 1 to i + 2), m the double
//! area vector, n its unit vector, and unit directions N_i in which the corners move, the derivative of m in direction N_i
//! is e_i × N_i. Its part in the triangle's plane is α_i e_i × n with α_i = n·N_i. Hence
//!
//! ```text
//! N_i · g_i   = ½ n · (e_i × N_i)
//! N_i H_ii N_i = α_i² e_i·e_i / (2 |m|)
//! N_i H_ij N_j = α_i α_j e_i·e_j / (2 |m|) + ½ n · (N_i × N_j)          j = i + 1
//! ```
//!
//! The first term is the cotangent Laplacian, weighted; it is positive semidefinite triangle by triangle, so adding a multiple of
//! it is the natural shift where the whole is indefinite. The second carries the curvature. One scalar system of the
//! Laplacian's own size is all that a Newton step needs.

use crate::DVec3;
use crate::sparse::SymmetricMatrix;

/// "No unknown": the entry of a fixed vertex.
pub(crate) const FIXED: u32 = u32::MAX;

/// A double area below this fraction of the longest edge squared is raised to it, so that no weight is infinite.
const LEAST_DOUBLE_AREA: f64 = 1e-12;

/// The sparsity of every operator on the free vertices of one connectivity, and where each triangle's terms go.
#[derive(Clone, Debug)]
pub(crate) struct Pattern {
    /// Per vertex its row, or [`FIXED`].
    pub unknown: Vec<u32>,
    /// Per row its vertex.
    pub vertex: Vec<u32>,
    row_start: Vec<u32>,
    columns: Vec<u32>,
    /// Per triangle the positions in `columns` of (0,1), (1,2), (2,0), then of (1,0), (2,1), (0,2); [`FIXED`] where an end is fixed.
    slots: Vec<[u32; 6]>,
}

impl Pattern {
    /// O(triangles). Every vertex that is not fixed must be an interior vertex of the manifold.
    pub fn new(triangles: &[[u32; 3]], fixed: &[bool]) -> Self {
        let mut unknown = vec![FIXED; fixed.len()];
        let mut vertex = Vec::new();
        for (v, _) in fixed.iter().enumerate().filter(|(_, fixed)| !**fixed) {
            unknown[v] = vertex.len() as u32;
            vertex.push(v as u32);
        }
        // Each half-edge between two free vertices is one entry off the diagonal: round an interior vertex every
        // neighbour is reached by exactly one outgoing half-edge.
        let mut row_start = vec![0u32; vertex.len() + 1];
        for row in 0..vertex.len() {
            row_start[row + 1] = 1;
        }
        for triangle in triangles {
            let rows = triangle.map(|v| unknown[v as usize]);
            for k in 0..3 {
                if rows[k] != FIXED && rows[(k + 1) % 3] != FIXED {
                    row_start[rows[k] as usize + 1] += 1;
                }
            }
        }
        for row in 0..vertex.len() {
            row_start[row + 1] += row_start[row];
        }
        let mut columns = vec![0u32; row_start[vertex.len()] as usize];
        let mut cursor: Vec<u32> = row_start[..vertex.len()].to_vec();
        for row in 0..vertex.len() {
            columns[cursor[row] as usize] = row as u32;
            cursor[row] += 1;
        }
        let mut slots = vec![[FIXED; 6]; triangles.len()];
        for (triangle, slots) in triangles.iter().zip(&mut slots) {
            let rows = triangle.map(|v| unknown[v as usize]);
            for k in 0..3 {
                let (from, to) = (rows[k], rows[(k + 1) % 3]);
                if from != FIXED && to != FIXED {
                    let slot = &mut cursor[from as usize];
                    columns[*slot as usize] = to;
                    slots[k] = *slot;
                    *slot += 1;
                }
            }
        }
        for (triangle, slots) in triangles.iter().zip(&mut slots) {
            let rows = triangle.map(|v| unknown[v as usize]);
            for k in 0..3 {
                if slots[k] != FIXED {
                    let (from, to) = (rows[k], rows[(k + 1) % 3] as usize);
                    let range = row_start[to] as usize..row_start[to + 1] as usize;
                    let offset = columns[range.clone()].iter().position(|&column| column == from);
                    slots[3 + k] = (range.start + offset.expect("both half-edges of an inner edge are present")) as u32;
                }
            }
        }
        Self { unknown, vertex, row_start, columns, slots }
    }

    /// A zero matrix of this pattern.
    pub fn matrix(&self) -> SymmetricMatrix {
        SymmetricMatrix {
            row_start: self.row_start.clone(),
            columns: self.columns.clone(),
            values: vec![0.0; self.columns.len()],
        }
    }

    /// The cotangent Laplacian L of the free vertices, and -L_free,fixed p_fixed in `right_hand_side` (x, then y, then z).
    pub fn laplacian(
        &self,
        vertices: &[DVec3],
        triangles: &[[u32; 3]],
        matrix: &mut SymmetricMatrix,
        right_hand_side: &mut Vec<f64>,
    ) {
        let n = self.vertex.len();
        matrix.values.fill(0.0);
        right_hand_side.clear();
        right_hand_side.resize(3 * n, 0.0);
        for (triangle, slots) in triangles.iter().zip(&self.slots) {
            let corner = Corner::of(vertices, triangle);
            let scale = 0.5 / corner.double_area;
            for k in 0..3 {
                let (from, to) = (k, (k + 1) % 3);
                let weight = corner.edges[from].dot(corner.edges[to]) * scale;
                let (row, other) = (self.unknown[triangle[from] as usize], self.unknown[triangle[to] as usize]);
                if slots[k] != FIXED {
                    matrix.values[slots[k] as usize] += weight;
                    matrix.values[slots[3 + k] as usize] += weight;
                } else if row != other {
                    let (free, fixed) = if row == FIXED { (other, triangle[from]) } else { (row, triangle[to]) };
                    let pull = -weight * vertices[fixed as usize];
                    for (axis, pull) in pull.to_array().into_iter().enumerate() {
                        right_hand_side[axis * n + free as usize] += pull;
                    }
                }
                if row != FIXED {
                    matrix.values[self.row_start[row as usize] as usize] += corner.edges[from].length_squared() * scale;
                }
            }
        }
    }

    /// The second variation of area with vertex `v` moving along `normals[v]`, its Laplacian part times `1 + shift`.
    pub fn second_variation(
        &self,
        vertices: &[DVec3],
        triangles: &[[u32; 3]],
        normals: &[DVec3],
        shift: f64,
        matrix: &mut SymmetricMatrix,
    ) {
        matrix.values.fill(0.0);
        for (triangle, slots) in triangles.iter().zip(&self.slots) {
            let corner = Corner::of(vertices, triangle);
            let scale = (1.0 + shift) * 0.5 / corner.double_area;
            let directions = triangle.map(|v| normals[v as usize]);
            let alpha = directions.map(|direction| corner.normal.dot(direction));
            for k in 0..3 {
                let next = (k + 1) % 3;
                if slots[k] != FIXED {
                    let laplacian = alpha[k] * alpha[next] * corner.edges[k].dot(corner.edges[next]) * scale;
                    let value = laplacian + 0.5 * corner.normal.dot(directions[k].cross(directions[next]));
                    matrix.values[slots[k] as usize] += value;
                    matrix.values[slots[3 + k] as usize] += value;
                }
                let row = self.unknown[triangle[k] as usize];
                if row != FIXED {
                    let value = alpha[k] * alpha[k] * corner.edges[k].length_squared() * scale;
                    matrix.values[self.row_start[row as usize] as usize] += value;
                }
            }
        }
    }

    /// The area, its gradient along `normals`, and a third of each ring's area, for the free vertices.
    pub fn first_variation(&self, vertices: &[DVec3], triangles: &[[u32; 3]], normals: &[DVec3]) -> FirstVariation {
        let n = self.vertex.len();
        let mut result = FirstVariation { area: 0.0, gradient: vec![0.0; n], mass: vec![0.0; n] };
        for triangle in triangles {
            let corner = Corner::of(vertices, triangle);
            let area = 0.5 * corner.double_area;
            result.area += area;
            for k in 0..3 {
                let row = self.unknown[triangle[k] as usize];
                if row != FIXED {
                    let row = row as usize;
                    result.mass[row] += area / 3.0;
                    let pull = corner.normal.cross(corner.edges[k]).dot(normals[triangle[k] as usize]);
                    result.gradient[row] += 0.5 * pull;
                }
            }
        }
        result
    }
}

/// ¼ Σ (cot α + cot β) |a'|² over the edges: the Dirichlet energy of the map from `domain` to `image`, two positions of one mesh.
pub(crate) fn dirichlet_energy(domain: &[DVec3], image: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
    let energy = |triangle: &[u32; 3]| {
        let corner = Corner::of(domain, triangle);
        let [a, b, c] = triangle.map(|v| image[v as usize]);
        let opposite = [c - b, a - c, b - a];
        // cot at corner k: minus the dot product of the two edges that meet there, over the double area.
        let cotangent = |k: usize| -corner.edges[(k + 1) % 3].dot(corner.edges[(k + 2) % 3]) / corner.double_area;
        (0..3).map(|k| 0.25 * cotangent(k) * opposite[k].length_squared()).sum::<f64>()
    };
    triangles.iter().map(energy).sum()
}

/// What a descent along the normals needs to know about a mesh.
#[derive(Clone, Debug)]
pub(crate) struct FirstVariation {
    pub area: f64,
    /// g_h · n_h per free vertex.
    pub gradient: Vec<f64>,
    /// A_h, a third of the ring's area, per free vertex.
    pub mass: Vec<f64>,
}

impl FirstVariation {
    /// max |g·n| / (2 A_h), times `radius`; 0 without free vertices.
    pub fn residual(&self, radius: f64) -> f64 {
        let pairs = self.gradient.iter().zip(&self.mass);
        let largest = pairs.fold(0.0, |max: f64, (&pull, &mass)| {
            let curvature = if mass > 0.0 { pull.abs() / (2.0 * mass) } else { f64::MAX.sqrt() };
            if curvature.is_nan() { f64::INFINITY } else { max.max(curvature) }
        });
        largest * radius
    }
}

/// One triangle: the edges opposite to its corners, its unit normal and double area (never zero).
struct Corner {
    edges: [DVec3; 3],
    normal: DVec3,
    double_area: f64,
}

impl Corner {
    #[inline]
    fn of(vertices: &[DVec3], triangle: &[u32; 3]) -> Self {
        let [a, b, c] = triangle.map(|v| vertices[v as usize]);
        let edges = [c - b, a - c, b - a];
        let vector = edges[2].cross(c - a);
        let longest = edges.map(DVec3::length_squared).into_iter().fold(0.0, f64::max);
        let double_area = vector.length().max(LEAST_DOUBLE_AREA * longest).max(f64::MIN_POSITIVE);
        Self { edges, normal: vector / double_area, double_area }
    }
}

/// Area-weighted unit normals of all vertices; zero where the ring has no area.
pub(crate) fn vertex_normals(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; vertices.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|v| vertices[v as usize]);
        let vector = (b - a).cross(c - a);
        for v in triangle {
            normals[*v as usize] += vector;
        }
    }
    for normal in &mut normals {
        *normal = normal.normalize_or_zero();
    }
    normals
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bumpy strip of the hyperbolic paraboloid: 5 x 5 vertices, the rim fixed.
    fn saddle() -> (Vec<DVec3>, Vec<[u32; 3]>, Vec<bool>) {
        let n = 5u32;
        let mut vertices = Vec::new();
        let mut triangles = Vec::new();
        for k in 0..n * n {
            let (x, y) = (f64::from(k % n), f64::from(k / n));
            vertices.push(DVec3::new(x + 0.1 * (3.0 * y).sin(), y, 0.2 * x * y + 0.15 * f64::from(k * k % 7)));
            if k % n + 1 < n && k / n + 1 < n {
                triangles.push([k, k + 1, k + n + 1]);
                triangles.push([k, k + n + 1, k + n]);
            }
        }
        let fixed = (0..n * n).map(|k| k % n == 0 || k % n == n - 1 || k / n == 0 || k / n == n - 1).collect();
        (vertices, triangles, fixed)
    }

    fn moved(vertices: &[DVec3], normals: &[DVec3], pattern: &Pattern, heights: &[f64]) -> Vec<DVec3> {
        let mut vertices = vertices.to_vec();
        for (row, &v) in pattern.vertex.iter().enumerate() {
            vertices[v as usize] += heights[row] * normals[v as usize];
        }
        vertices
    }

    #[test]
    fn first_and_second_variation_agree_with_finite_differences() {
        let (vertices, triangles, fixed) = saddle();
        let pattern = Pattern::new(&triangles, &fixed);
        let normals = vertex_normals(&vertices, &triangles);
        let first = pattern.first_variation(&vertices, &triangles, &normals);
        let mut matrix = pattern.matrix();
        pattern.second_variation(&vertices, &triangles, &normals, 0.0, &mut matrix);
        let step = 1e-5;
        for row in 0..pattern.vertex.len() {
            let mut heights = vec![0.0; pattern.vertex.len()];
            let mut at = |height: f64| {
                heights[row] = height;
                pattern.first_variation(&moved(&vertices, &normals, &pattern, &heights), &triangles, &normals)
            };
            let (up, down) = (at(step), at(-step));
            assert!(((up.area - down.area) / (2.0 * step) - first.gradient[row]).abs() < 1e-9);
            let mut expected = vec![0.0; pattern.vertex.len()];
            let (columns, values) = matrix.row(row);
            columns.iter().zip(values).for_each(|(&column, &value)| expected[column as usize] = value);
            for (other, expected) in expected.iter().enumerate() {
                let measured = (up.gradient[other] - down.gradient[other]) / (2.0 * step);
                assert!((measured - expected).abs() < 1e-8, "{row} {other}: {measured} {expected}");
            }
        }
    }

    #[test]
    fn the_laplacian_at_the_positions_is_the_area_gradient() {
        let (vertices, triangles, fixed) = saddle();
        let pattern = Pattern::new(&triangles, &fixed);
        let (mut matrix, mut right_hand_side) = (pattern.matrix(), Vec::new());
        pattern.laplacian(&vertices, &triangles, &mut matrix, &mut right_hand_side);
        let n = pattern.vertex.len();
        for axis in 0..3 {
            let direction = vec![DVec3::AXES[axis]; vertices.len()];
            let gradient = pattern.first_variation(&vertices, &triangles, &direction).gradient;
            let positions: Vec<f64> = pattern.vertex.iter().map(|&v| vertices[v as usize][axis]).collect();
            let mut product = vec![0.0; n];
            matrix.multiply(&positions, &mut product);
            for row in 0..n {
                assert!((product[row] - right_hand_side[axis * n + row] - gradient[row]).abs() < 1e-12);
            }
        }
    }
}
