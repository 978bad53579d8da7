//! The Dirichlet energy of a piecewise linear map between two positions of one mesh.
//!
//! ```text
//! E(u) = ¼ Σ_edges (cot α + cot β) |u_i - u_j|²          ∂E/∂u = L u          ∂²E/∂u² = L   for each coordinate
//! ```
//!
//! Here α and β are the angles opposite to an edge, measured on the domain, and L is the cotangent Laplacian. If the
//! domain is its own image, the energy is the area, and its gradient is the gradient of the area. Source: Pinkall,
//! Polthier, *Computing Discrete Minimal Surfaces and Their Conjugates* (1993), section 2.

use super::area::Facet;
use plateau_mesh::DVec3;
use plateau_mesh::sparse::SymmetricMatrix;
use plateau_mesh::sparse::pattern::{FIXED, Pattern};

/// Returns ¼ Σ (cot α + cot β) |a'|² over the edges: the Dirichlet energy of the map from `domain` to `image`, which
/// are two positions of the same mesh.
#[doc(hidden)]
pub fn dirichlet_energy(domain: &[DVec3], image: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
    let energy = |triangle: &[u32; 3]| {
        let facet = Facet::of(domain, triangle);
        let [a, b, c] = triangle.map(|v| image[v as usize]);
        let opposite = [c - b, a - c, b - a];
        // The cotangent at corner k is minus the dot product of the two edges that meet there, divided by the double
        // area.
        let cotangent = |k: usize| -facet.edges[(k + 1) % 3].dot(facet.edges[(k + 2) % 3]) / facet.double_area;
        (0..3).map(|k| 0.25 * cotangent(k) * opposite[k].length_squared()).sum::<f64>()
    };
    triangles.iter().map(energy).sum()
}

/// Fills `matrix` with the cotangent Laplacian L of the free vertices, and `right_hand_side` with -L_free,fixed
/// p_fixed. The angles are measured on `domain`, and p_fixed are the positions of the fixed vertices in `image`. The
/// right-hand side lists x of all free vertices, then y, then z.
#[doc(hidden)]
pub fn laplacian(
    pattern: &Pattern,
    domain: &[DVec3],
    image: &[DVec3],
    triangles: &[[u32; 3]],
    matrix: &mut SymmetricMatrix,
    right_hand_side: &mut Vec<f64>,
) {
    let n = pattern.free.vertex.len();
    matrix.values.fill(0.0);
    right_hand_side.clear();
    right_hand_side.resize(3 * n, 0.0);
    for (triangle, slots) in triangles.iter().zip(&pattern.slots) {
        let facet = Facet::of(domain, triangle);
        let scale = 0.5 / facet.double_area;
        for k in 0..3 {
            let (from, to) = (k, (k + 1) % 3);
            let weight = facet.edges[from].dot(facet.edges[to]) * scale;
            let (row, other) =
                (pattern.free.unknown[triangle[from] as usize], pattern.free.unknown[triangle[to] as usize]);
            if slots[k] != FIXED {
                matrix.values[slots[k] as usize] += weight;
                matrix.values[slots[3 + k] as usize] += weight;
            } else if row != other {
                let (free, fixed) = if row == FIXED { (other, triangle[from]) } else { (row, triangle[to]) };
                let force = -weight * image[fixed as usize];
                for (axis, force) in force.to_array().into_iter().enumerate() {
                    right_hand_side[axis * n + free as usize] += force;
                }
            }
            if row != FIXED {
                matrix.values[pattern.row_start[row as usize] as usize] += facet.edges[from].length_squared() * scale;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::area::first_variation;
    use crate::energy::area::tests::saddle;

    #[test]
    fn the_laplacian_at_the_positions_is_the_area_gradient() {
        let (vertices, triangles, fixed) = saddle();
        let pattern = Pattern::new(&triangles, &fixed);
        let (mut matrix, mut right_hand_side) = (pattern.matrix(), Vec::new());
        laplacian(&pattern, &vertices, &vertices, &triangles, &mut matrix, &mut right_hand_side);
        let n = pattern.free.vertex.len();
        for axis in 0..3 {
            let direction = vec![DVec3::AXES[axis]; vertices.len()];
            let gradient = first_variation(&pattern.free, &vertices, &triangles, &direction).gradient;
            let positions: Vec<f64> = pattern.free.vertex.iter().map(|&v| vertices[v as usize][axis]).collect();
            let mut product = vec![0.0; n];
            matrix.multiply(&positions, &mut product);
            for row in 0..n {
                assert!((product[row] - right_hand_side[axis * n + row] - gradient[row]).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn the_laplacian_is_the_second_derivative_of_the_energy() {
        let (domain, triangles, fixed) = saddle();
        let pattern = Pattern::new(&triangles, &fixed);
        let (mut matrix, mut right_hand_side) = (pattern.matrix(), Vec::new());
        laplacian(&pattern, &domain, &domain, &triangles, &mut matrix, &mut right_hand_side);
        let image: Vec<DVec3> = domain.iter().map(|p| DVec3::new(p.y, p.x * p.y, p.z - p.x)).collect();
        // The energy is quadratic, so that differences of any step are exact up to rounding.
        let energy = |moves: &[(u32, f64)], axis: usize| {
            let mut image = image.clone();
            moves.iter().for_each(|&(v, step)| image[v as usize][axis] += step);
            dirichlet_energy(&domain, &image, &triangles)
        };
        for (row, &v) in pattern.free.vertex.iter().enumerate() {
            let (columns, values) = matrix.row(row);
            for (&column, &value) in columns.iter().zip(values) {
                let w = pattern.free.vertex[column as usize];
                for axis in 0..3 {
                    let at = |a: f64, b: f64| energy(&[(v, a), (w, b)], axis);
                    let second = (at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)) / 4.0;
                    assert!((second - value).abs() < 1e-11, "{row} {column}: {second} {value}");
                }
            }
        }
    }
}
