//! The finite element: Nédélec's element of second order, without its gradients of second order. Its curls are all
//! vector fields that are linear on every tetrahedron, and have continuous normal components and no divergence.
//!
//! A field has one unknown on each edge (its circulation) and two on each face. On an edge ij (i < j, by the vertices'
//! numbers) the basis function is Whitney's w_ij = λi ∇λj - λj ∇λi; on a face ijk (i < j < k) they are λk w_ij and λi
//! w_jk, which have no tangential component on any edge. The curl is linear on a tetrahedron, so |curl| is largest at
//! one of its four vertices.

use super::bisection::{EDGES, FACES};
use plateau_mesh::DVec3;

/// Unknowns of a tetrahedron: six edges, then two of each of the four faces.
pub(super) const UNKNOWNS: usize = 14;

/// The order of a tetrahedron's four positions by the numbers of their vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orientation {
    /// For each of [`EDGES`] whether its first position has the smaller number.
    pub ascending: [bool; 6],
    /// For each of [`FACES`] its positions by ascending number.
    pub faces: [[usize; 3]; 4],
}

impl Orientation {
    pub fn of(vertices: [u32; 4]) -> Self {
        Self {
            ascending: EDGES.map(|[a, b]| vertices[a] < vertices[b]),
            faces: FACES.map(|mut face| {
                face.sort_by_key(|&position| vertices[position]);
                face
            }),
        }
    }
}

/// ∇λi × ∇λj of all pairs of positions: an edge vector over six times the volume.
pub(super) fn gradient_products(corners: [DVec3; 4]) -> [[DVec3; 4]; 4] {
    let [a, b, c, d] = corners;
    let scale = 1.0 / (b - a).cross(c - a).dot(d - a);
    let mut products = [[DVec3::ZERO; 4]; 4];
    for [i, j, k, l] in EVEN {
        products[i][j] = (corners[l] - corners[k]) * scale;
        products[j][i] = -products[i][j];
    }
    products
}

/// Even permutations of the four positions that begin with each of [`EDGES`].
pub(super) const EVEN: [[usize; 4]; 6] =
    [[0, 1, 2, 3], [0, 2, 3, 1], [0, 3, 1, 2], [1, 2, 0, 3], [1, 3, 2, 0], [2, 3, 0, 1]];

/// The curls of the basis functions at each of the four vertices.
pub(super) fn basis_curls(corners: [DVec3; 4], orientation: &Orientation) -> [[DVec3; UNKNOWNS]; 4] {
    let products = gradient_products(corners);
    let mut curls = [[DVec3::ZERO; UNKNOWNS]; 4];
    for (e, [a, b]) in EDGES.into_iter().enumerate() {
        let curl = products[a][b] * if orientation.ascending[e] { 2.0 } else { -2.0 };
        curls.iter_mut().for_each(|at| at[e] = curl);
    }
    for (f, [i, j, k]) in orientation.faces.into_iter().enumerate() {
        let [first, second] = [6 + 2 * f, 7 + 2 * f];
        curls[i][first] = -products[j][k];
        curls[j][first] = -products[k][i];
        curls[k][first] = 2.0 * products[i][j];
        curls[i][second] = 2.0 * products[j][k];
        curls[j][second] = -products[k][i];
        curls[k][second] = -products[i][j];
    }
    curls
}

/// The two unknowns of a face, from the field's curl at its corners (in ascending order of number).
pub(super) fn face_unknowns(corners: [DVec3; 3], curls: [DVec3; 3]) -> [f64; 2] {
    let double_area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    let [i, j, k] = curls.map(|curl| curl.dot(double_area));
    [(k - j) / 3.0, (i - j) / 3.0]
}

/// The integrals of the basis functions along a straight piece inside a tetrahedron, between two points given by their
/// barycentric coordinates.
pub(super) fn integrals(from: [f64; 4], to: [f64; 4], orientation: &Orientation) -> [f64; UNKNOWNS] {
    let mut values = [0.0; UNKNOWNS];
    let whitney = |i: usize, j: usize| from[i] * to[j] - from[j] * to[i];
    for (e, [a, b]) in EDGES.into_iter().enumerate() {
        values[e] = if orientation.ascending[e] { whitney(a, b) } else { whitney(b, a) };
    }
    for (f, [i, j, k]) in orientation.faces.into_iter().enumerate() {
        values[6 + 2 * f] = 0.5 * (from[k] + to[k]) * whitney(i, j);
        values[7 + 2 * f] = 0.5 * (from[i] + to[i]) * whitney(j, k);
    }
    values
}
