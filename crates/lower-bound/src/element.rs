//! The finite element: Nédélec's element of second order, without its gradients of second order. The curls of its
//! fields are exactly the vector fields that are linear on every tetrahedron, have continuous normal components, and
//! have no divergence.
//!
//! A field has one unknown on each edge (its circulation) and two on each face. On an edge ij (i < j, by the numbers of
//! the vertices) the basis function is Whitney's w_ij = λi ∇λj - λj ∇λi. On a face ijk (i < j < k) the basis functions
//! are λk w_ij and λi w_jk, which have no tangential component on any edge. The curl is linear on a tetrahedron, so
//! that |curl| is largest at one of its four vertices.

use super::bisection::{EDGES, FACES};
use plateau_mesh::DVec3;

/// Number of unknowns of a tetrahedron: first one for each of the six edges, then two for each of the four faces.
pub(super) const UNKNOWNS: usize = 14;

/// How the numbers of a tetrahedron's vertices are ordered on its edges and faces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orientation {
    /// For each of [`EDGES`], whether the vertex at its first position has the smaller number.
    pub ascending: [bool; 6],
    /// For each of [`FACES`], its positions, sorted by the numbers of their vertices.
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

/// The products ∇λi × ∇λj for all pairs of positions. Each is the vector of the opposite edge divided by six times the
/// volume.
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

/// For each of [`EDGES`], the even permutation of the four positions that begins with the edge.
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

/// The two unknowns of a face, computed from the field's curl at its corners. The corners are in the order of their
/// numbers.
pub(super) fn face_unknowns(corners: [DVec3; 3], curls: [DVec3; 3]) -> [f64; 2] {
    let double_area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    let [i, j, k] = curls.map(|curl| curl.dot(double_area));
    [(k - j) / 3.0, (i - j) / 3.0]
}

/// The integrals of the basis functions along a straight segment inside a tetrahedron. Its ends are given by
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
