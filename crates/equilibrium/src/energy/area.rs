//! The area of a triangle mesh.
//!
//! Number the corners 0, 1, 2 in the triangle's order. Let e_i be the edge opposite to corner i, from corner i + 1 to
//! corner i + 2. Let m be the double area vector and n its unit vector. The derivative of m, if corner i moves in the
//! direction N_i, is e_i × N_i. Hence
//!
//! ```text
//! A        = ½ |m|
//! ∂A/∂x_i  = ½ n × e_i
//! ∂²A/∂x_i∂x_j = (e_i·e_j / (2 |m|)) n nᵀ  -  ½ [n]×      for j = i + 1, with [n]× v = n × v
//!                                                          (+ ½ [n]× for j = i - 1; the first part alone for j = i)
//! ```
//!
//! and, if each corner i moves along a unit direction N_i, with α_i = n·N_i,
//!
//! ```text
//! N_i · ∂A/∂x_i             = ½ n · (e_i × N_i)
//! N_i · ∂²A/∂x_i∂x_i · N_i  = α_i² e_i·e_i / (2 |m|)
//! N_i · ∂²A/∂x_i∂x_j · N_j  = α_i α_j e_i·e_j / (2 |m|) + ½ n · (N_i × N_j)          j = i + 1
//! ```
//!
//! The first part is the cotangent Laplacian of [`dirichlet`](super::dirichlet) with the weights α_i α_j. It is
//! positive semidefinite triangle by triangle, so a multiple of it can be added where the whole matrix is indefinite.
//! The second part comes from the curvature.
//!
//! Sources: the gradient is section 2 of Pinkall, Polthier, *Computing Discrete Minimal Surfaces and Their Conjugates*
//! (1993); the second variation is worked out here and checked against finite differences.
//!
//! There are two evaluations, which share the formulas of one triangle (`Facet`). The term [`Area`] gives a block of 3
//! × 3 numbers for each pair of corners. The fast path for films, `first_variation` and `second_variation`, gives one
//! number for each pair, because every free vertex moves along one direction. A Newton step of the fast path solves one
//! scalar system with as many unknowns as the Laplacian has.

use super::Term;
use super::volume::cross_matrix;
use glam::DMat3;
use plateau_mesh::DVec3;
use plateau_mesh::sparse::SymmetricMatrix;
use plateau_mesh::sparse::pattern::{FIXED, FreeVertices, Pattern};

/// Lower bound of a triangle's double area in every formula, as a fraction of its longest edge squared. A smaller area
/// is raised to this bound, so that no weight is infinite. The bound lies below the limit of 1e-10 that
/// [`is_degenerate`](plateau_mesh::measure::is_degenerate) uses, so that it does not affect valid meshes.
const LEAST_DOUBLE_AREA: f64 = 1e-12;

/// Lower bound of a triangle's double area in the springs, as a fraction of the sum of its squared edges. It limits the
/// stiffness of a thin triangle's springs, because rounding errors spoil a system in which the stiffnesses differ by
/// too large a factor.
const LEAST_SPRUNG_AREA: f64 = 1e-6;

/// A triangle: the edges opposite to its corners, its unit normal, and its double area, which is never zero. The normal
/// of a degenerate triangle is shorter than 1.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Facet {
    pub edges: [DVec3; 3],
    pub normal: DVec3,
    pub double_area: f64,
}

impl Facet {
    #[inline]
    pub fn of(vertices: &[DVec3], triangle: &[u32; 3]) -> Self {
        let [a, b, c] = triangle.map(|v| vertices[v as usize]);
        let edges = [c - b, a - c, b - a];
        let vector = edges[2].cross(c - a);
        let longest = edges.map(DVec3::length_squared).into_iter().fold(0.0, f64::max);
        let double_area = vector.length().max(LEAST_DOUBLE_AREA * longest).max(f64::MIN_POSITIVE);
        Self { edges, normal: vector / double_area, double_area }
    }

    /// The gradient of the triangle's area with respect to a corner.
    #[inline]
    pub fn gradient(&self, corner: usize) -> DVec3 {
        0.5 * self.normal.cross(self.edges[corner])
    }
}

/// Adds the gradient of `tension` times the area of `triangles`.
#[doc(hidden)]
pub fn add_gradient(triangles: &[[u32; 3]], tension: f64, at: &[DVec3], gradient: &mut [DVec3]) {
    for triangle in triangles {
        let facet = Facet::of(at, triangle);
        for k in 0..3 {
            gradient[triangle[k] as usize] += tension * facet.gradient(k);
        }
    }
}

/// E = σ Σ A: the triangles of a sheet with one surface tension σ.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    /// Corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// σ, a force per length; 1 for the area itself.
    pub tension: f64,
}

/// Calls `visit(v, w, k)` with the springs of the Dirichlet energy of `triangles`: k is the stiffness between the
/// vertices v and w. Triangle t has the tension `tension(t)`.
pub(crate) fn visit_springs(
    triangles: &[[u32; 3]],
    at: &[DVec3],
    tension: impl Fn(usize) -> f64,
    visit: &mut dyn FnMut(u32, u32, f64),
) {
    for (t, triangle) in triangles.iter().enumerate() {
        let Facet { edges, double_area, .. } = Facet::of(at, triangle);
        let sum: f64 = edges.iter().map(|edge| edge.length_squared()).sum();
        let factor = -0.5 * tension(t) / double_area.max(LEAST_SPRUNG_AREA * sum);
        for k in 0..3 {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            visit(triangle[i], triangle[j], factor * edges[i].dot(edges[j]));
        }
    }
}

impl Term for Area {
    fn value(&self, at: &[DVec3]) -> f64 {
        self.tension * self.triangles.iter().map(|triangle| 0.5 * Facet::of(at, triangle).double_area).sum::<f64>()
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        add_gradient(&self.triangles, self.tension, at, gradient);
    }

    fn add_second_derivative(&self, at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        for triangle in &self.triangles {
            let Facet { edges, normal: n, double_area } = Facet::of(at, triangle);
            let scale = (1.0 + shift) * 0.5 * self.tension / double_area;
            let outer = DMat3::from_cols(n * n.x, n * n.y, n * n.z);
            let turn = cross_matrix(n) * (-0.5 * self.tension);
            for k in 0..3 {
                let next = (k + 1) % 3;
                add(triangle[k], triangle[k], outer * (scale * edges[k].length_squared()));
                let block = outer * (scale * edges[k].dot(edges[next])) + turn;
                add(triangle[k], triangle[next], block);
                add(triangle[next], triangle[k], block.transpose());
            }
        }
    }

    // The springs bound the area from above, because a map of singular values σ₁, σ₂ has the area σ₁ σ₂ and the
    // Dirichlet energy ½ (σ₁² + σ₂²). Single cotangents may be negative, but the three springs of a triangle together
    // are positive semidefinite.
    fn visit_springs(&self, at: &[DVec3], visit: &mut dyn FnMut(u32, u32, f64)) {
        visit_springs(&self.triangles, at, |_| self.tension, visit);
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.triangles.iter().for_each(|triangle| visit(triangle));
    }

    fn add_shares(&self, at: &[DVec3], shares: &mut [f64]) {
        for triangle in &self.triangles {
            let share = self.tension * 0.5 * Facet::of(at, triangle).double_area / 3.0;
            triangle.iter().for_each(|&v| shares[v as usize] += share);
        }
    }
}

/// The area, its gradient along the free vertices' directions, and their masses.
#[derive(Clone, Debug)]
pub(crate) struct FirstVariation {
    pub area: f64,
    /// g_h · N_h per free vertex.
    pub gradient: Vec<f64>,
    /// A_h, a third of the ring's area, per free vertex.
    pub mass: Vec<f64>,
}

/// Returns the first variation of the area, if each vertex v moves along `directions[v]`.
pub(crate) fn first_variation(
    free: &FreeVertices,
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    directions: &[DVec3],
) -> FirstVariation {
    let n = free.vertex.len();
    let mut result = FirstVariation { area: 0.0, gradient: vec![0.0; n], mass: vec![0.0; n] };
    for triangle in triangles {
        let facet = Facet::of(vertices, triangle);
        let area = 0.5 * facet.double_area;
        result.area += area;
        for k in 0..3 {
            let row = free.unknown[triangle[k] as usize];
            if row != FIXED {
                let row = row as usize;
                result.mass[row] += area / 3.0;
                let component = facet.normal.cross(facet.edges[k]).dot(directions[triangle[k] as usize]);
                result.gradient[row] += 0.5 * component;
            }
        }
    }
    result
}

/// Fills `matrix` with the second variation of the area, if each vertex v moves along `directions[v]`. Its Laplacian
/// part is multiplied by `1 + shift`.
pub(crate) fn second_variation(
    pattern: &Pattern,
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    directions: &[DVec3],
    shift: f64,
    matrix: &mut SymmetricMatrix,
) {
    matrix.values.fill(0.0);
    for (triangle, slots) in triangles.iter().zip(&pattern.slots) {
        let facet = Facet::of(vertices, triangle);
        let scale = (1.0 + shift) * 0.5 / facet.double_area;
        let directions = triangle.map(|v| directions[v as usize]);
        let alpha = directions.map(|direction| facet.normal.dot(direction));
        for k in 0..3 {
            let next = (k + 1) % 3;
            if slots[k] != FIXED {
                let laplacian = alpha[k] * alpha[next] * facet.edges[k].dot(facet.edges[next]) * scale;
                let value = laplacian + 0.5 * facet.normal.dot(directions[k].cross(directions[next]));
                matrix.values[slots[k] as usize] += value;
                matrix.values[slots[3 + k] as usize] += value;
            }
            let row = pattern.free.unknown[triangle[k] as usize];
            if row != FIXED {
                let value = alpha[k] * alpha[k] * facet.edges[k].length_squared() * scale;
                matrix.values[pattern.row_start[row as usize] as usize] += value;
            }
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use plateau_mesh::measure::normals;

    /// A bumpy piece of a hyperbolic paraboloid with 5 x 5 vertices. Its rim is fixed.
    pub(crate) fn saddle() -> (Vec<DVec3>, Vec<[u32; 3]>, Vec<bool>) {
        let n = 5u32;
        let mut vertices = Vec::new();
        let mut triangles = Vec::new();
        for k in 0..n * n {
            let (x, y) = (f64::from(k % n), f64::from(k / n));
            vertices.push(DVec3::new(x + 0.1 * libm::sin(3.0 * y), y, 0.2 * x * y + 0.15 * f64::from(k * k % 7)));
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
        for (row, &v) in pattern.free.vertex.iter().enumerate() {
            vertices[v as usize] += heights[row] * normals[v as usize];
        }
        vertices
    }

    #[test]
    fn first_and_second_variation_agree_with_finite_differences() {
        let (vertices, triangles, fixed) = saddle();
        let pattern = Pattern::new(&triangles, &fixed);
        let normals = normals(&vertices, &triangles);
        let first = |at: &[DVec3], normals: &[DVec3]| first_variation(&pattern.free, at, &triangles, normals);
        let here = first(&vertices, &normals);
        let mut matrix = pattern.matrix();
        second_variation(&pattern, &vertices, &triangles, &normals, 0.0, &mut matrix);
        let step = 1e-5;
        for row in 0..pattern.free.vertex.len() {
            let mut heights = vec![0.0; pattern.free.vertex.len()];
            let mut at = |height: f64| {
                heights[row] = height;
                first(&moved(&vertices, &normals, &pattern, &heights), &normals)
            };
            let (up, down) = (at(step), at(-step));
            assert!(((up.area - down.area) / (2.0 * step) - here.gradient[row]).abs() < 1e-9);
            let mut expected = vec![0.0; pattern.free.vertex.len()];
            let (columns, values) = matrix.row(row);
            columns.iter().zip(values).for_each(|(&column, &value)| expected[column as usize] = value);
            for (other, expected) in expected.iter().enumerate() {
                let measured = (up.gradient[other] - down.gradient[other]) / (2.0 * step);
                assert!((measured - expected).abs() < 1e-8, "{row} {other}: {measured} {expected}");
            }
        }
    }
}
