//! The discrete mean curvature of Cohen-Steiner and Morvan at the vertices of a mesh, and its gradient in closed form.

use plateau_equilibrium::energy::area::Facet;
use plateau_mesh::DVec3;
use plateau_mesh::measure::double_area_vector;
use plateau_mesh::topology::{NONE, Topology, previous};

/// Marks a vertex without an unknown in [`CurvatureRows::unknown`], and a vertex without a row in
/// [`CurvatureRows::row_of`].
const FIXED: u32 = u32::MAX;

/// Returns the signed angle (radians, in (-π, π]) between the normals of the triangles (p, q, r) and (q, p, s) across
/// their common edge p-q. It is positive on a ridge (seen from the side to which the normals point), negative in a
/// valley, and 0 where the surface is flat.
#[must_use]
pub(super) fn dihedral_angle(p: DVec3, q: DVec3, r: DVec3, s: DVec3) -> f64 {
    let left = double_area_vector([p, q, r]);
    let right = double_area_vector([q, p, s]);
    let sine = left.cross(right).dot((q - p).normalize_or_zero());
    libm::atan2(sine, left.dot(right))
}

/// Returns the gradient of [`dihedral_angle`] with respect to p, q, r and s.
///
/// At r and s, the corners opposite the edge e, the gradient is -|e| n / |n|², where n is twice the area vector of the
/// triangle. The gradients at p and q follow, because the four gradients sum to zero and exert no moment. This form is
/// regular at a flat edge, where eq. 3 of Liu and Wang is 0/0. If one of the triangles is a segment or a point, the
/// angle has no gradient, and zeros are returned.
#[must_use]
pub(super) fn dihedral_angle_gradient(p: DVec3, q: DVec3, r: DVec3, s: DVec3) -> [DVec3; 4] {
    let edge = q - p;
    let left = double_area_vector([p, q, r]);
    let right = double_area_vector([q, p, s]);
    let (edge2, left2, right2) = (edge.length_squared(), left.length_squared(), right.length_squared());
    if !(edge2 > 0.0 && left2 > 0.0 && right2 > 0.0) {
        return [DVec3::ZERO; 4];
    }
    let length = edge2.sqrt();
    let at_r = left * (-length / left2);
    let at_s = right * (-length / right2);
    // The feet of the perpendiculars from r and s onto the edge, as positions from 0 at p to 1 at q.
    let (foot_r, foot_s) = ((r - p).dot(edge) / edge2, (s - p).dot(edge) / edge2);
    let at_p = -(at_r * (1.0 - foot_r) + at_s * (1.0 - foot_s));
    let at_q = -(at_r * foot_r + at_s * foot_s);
    [at_p, at_q, at_r, at_s]
}

/// An edge with two triangles, as the vertices p, q at its ends and the opposite corners r (left) and s (right).
type Hinge = [u32; 4];

/// The curvatures H_i = (1/B_i) Σ β(e) |e| / 2, and their derivatives with respect to the vertices that may move. The
/// sum is over the interior edges at vertex i, and B_i is a third of the area of the triangles around it. The
/// derivatives are sparse rows with one `DVec3` for each moving vertex among vertex i and its neighbours.
#[derive(Debug)]
pub(super) struct CurvatureRows {
    hinges: Vec<Hinge>,
    triangles: Vec<[u32; 3]>,
    /// For each vertex its number among the vertices that may move, or [`FIXED`].
    unknown: Vec<u32>,
    /// For each vertex the number of its row, or [`FIXED`] if it has none.
    row_of: Vec<u32>,
    /// Row k owns the entries `start[k]..start[k + 1]` of `columns` (unknowns, ascending) and `values`.
    start: Vec<usize>,
    columns: Vec<u32>,
    values: Vec<DVec3>,
    curvatures: Vec<f64>,
}

impl CurvatureRows {
    /// Lays out the rows: one for every vertex if `boundary_rows` is set, otherwise one for each vertex that may move.
    #[must_use]
    pub fn new(topology: &Topology, moves: &[bool], boundary_rows: bool) -> Self {
        let mut unknown = vec![FIXED; moves.len()];
        for (number, (vertex, _)) in moves.iter().enumerate().filter(|(_, moves)| **moves).enumerate() {
            unknown[vertex] = number as u32;
        }
        let hinges = (0..topology.twin.len() as u32)
            .filter(|&h| topology.twin[h as usize] != NONE && topology.twin[h as usize] > h)
            .map(|h| {
                let opposite = |half_edge| topology.from(previous(half_edge));
                [topology.from(h), topology.to(h), opposite(h), opposite(topology.twin[h as usize])]
            })
            .collect();
        let mut row_of = vec![FIXED; moves.len()];
        let (mut start, mut columns, mut rows) = (vec![0], Vec::new(), 0);
        for vertex in 0..moves.len() {
            if !(boundary_rows || moves[vertex]) {
                continue;
            }
            row_of[vertex] = rows;
            rows += 1;
            let begin = columns.len();
            columns.push(unknown[vertex]);
            for h in topology.outgoing_half_edges(vertex as u32) {
                columns.push(unknown[topology.to(h) as usize]);
                columns.push(unknown[topology.from(previous(h)) as usize]);
            }
            let mut ring = columns.split_off(begin);
            ring.retain(|&column| column != FIXED);
            ring.sort_unstable();
            ring.dedup();
            columns.append(&mut ring);
            start.push(columns.len());
        }
        let values = vec![DVec3::ZERO; columns.len()];
        Self {
            hinges,
            triangles: topology.triangles().to_vec(),
            unknown,
            row_of,
            start,
            columns,
            values,
            curvatures: vec![0.0; rows as usize],
        }
    }

    /// The number of a vertex among those that may move.
    #[must_use]
    pub fn unknown_of(&self, vertex: usize) -> Option<usize> {
        (self.unknown[vertex] != FIXED).then_some(self.unknown[vertex] as usize)
    }

    #[must_use]
    pub fn rows(&self) -> usize {
        self.curvatures.len()
    }

    /// The curvature H of each row, from the last call of [`evaluate`](Self::evaluate) or
    /// [`differentiate`](Self::differentiate).
    #[must_use]
    pub fn curvatures(&self) -> &[f64] {
        &self.curvatures
    }

    /// The columns of a row (the numbers of moving vertices, ascending), and the derivative of its H with respect to
    /// each. The derivatives are those of the last call of [`differentiate`](Self::differentiate).
    #[must_use]
    pub fn row(&self, row: usize) -> (&[u32], &[DVec3]) {
        let range = self.start[row]..self.start[row + 1];
        (&self.columns[range.clone()], &self.values[range])
    }

    /// Returns S and B for the vertex of each row. The mean curvature is H = S / B. S = Σ β(e) |e| / 2 is the sum over
    /// the edges e at the vertex, where β is the dihedral angle. B is a third of the area of the triangles at the
    /// vertex.
    fn sums(&self, vertices: &[DVec3]) -> (Vec<f64>, Vec<f64>) {
        let (mut bending, mut third) = (vec![0.0; self.rows()], vec![0.0; self.rows()]);
        for &hinge in &self.hinges {
            let [p, q, r, s] = hinge.map(|v| vertices[v as usize]);
            let term = 0.5 * dihedral_angle(p, q, r, s) * p.distance(q);
            for end in [hinge[0], hinge[1]] {
                if self.row_of[end as usize] != FIXED {
                    bending[self.row_of[end as usize] as usize] += term;
                }
            }
        }
        for &triangle in &self.triangles {
            let area = double_area_vector(triangle.map(|v| vertices[v as usize])).length() / 6.0;
            for vertex in triangle {
                if self.row_of[vertex as usize] != FIXED {
                    third[self.row_of[vertex as usize] as usize] += area;
                }
            }
        }
        (bending, third)
    }

    /// Evaluates every H and returns F = ½ Σ H². The result is not finite if the triangles of a vertex have no area.
    pub fn evaluate(&mut self, vertices: &[DVec3]) -> f64 {
        let (bending, third) = self.sums(vertices);
        for (row, curvature) in self.curvatures.iter_mut().enumerate() {
            *curvature = bending[row] / third[row];
        }
        0.5 * self.curvatures.iter().map(|h| h * h).sum::<f64>()
    }

    /// Evaluates every H and its derivatives, and returns F = ½ Σ H². O(triangles).
    pub fn differentiate(&mut self, vertices: &[DVec3]) -> f64 {
        let (bending, third) = self.sums(vertices);
        self.values.fill(DVec3::ZERO);
        // dH = dS / B - S dB / B².
        for k in 0..self.hinges.len() {
            let hinge = self.hinges[k];
            let [p, q, r, s] = hinge.map(|v| vertices[v as usize]);
            let (angle, gradient) = (dihedral_angle(p, q, r, s), dihedral_angle_gradient(p, q, r, s));
            let (length, along) = (p.distance(q), (q - p).normalize_or_zero());
            let term = [
                0.5 * (gradient[0] * length - along * angle),
                0.5 * (gradient[1] * length + along * angle),
                0.5 * gradient[2] * length,
                0.5 * gradient[3] * length,
            ];
            for end in [hinge[0], hinge[1]] {
                let row = self.row_of[end as usize];
                if row != FIXED {
                    for (vertex, derivative) in hinge.into_iter().zip(term) {
                        self.add(row as usize, vertex, derivative / third[row as usize]);
                    }
                }
            }
        }
        for k in 0..self.triangles.len() {
            let triangle = self.triangles[k];
            let facet = Facet::of(vertices, &triangle);
            for end in triangle {
                let row = self.row_of[end as usize];
                if row == FIXED {
                    continue;
                }
                let factor = -bending[row as usize] / (third[row as usize] * third[row as usize]);
                for (k, vertex) in triangle.into_iter().enumerate() {
                    // The factor is 1/3 because B is a third of the area.
                    self.add(row as usize, vertex, facet.gradient(k) * (factor / 3.0));
                }
            }
        }
        for (row, curvature) in self.curvatures.iter_mut().enumerate() {
            *curvature = bending[row] / third[row];
        }
        0.5 * self.curvatures.iter().map(|h| h * h).sum::<f64>()
    }

    fn add(&mut self, row: usize, vertex: u32, derivative: DVec3) {
        let column = self.unknown[vertex as usize];
        if column == FIXED {
            return;
        }
        let begin = self.start[row];
        if let Ok(k) = self.columns[begin..self.start[row + 1]].binary_search(&column) {
            self.values[begin + k] += derivative;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::Mesh;
    use proptest::prelude::*;

    #[test]
    fn a_ridge_is_positive_and_a_valley_negative() {
        let at = |r: f64| {
            dihedral_angle(DVec3::ZERO, DVec3::X, DVec3::new(0.0, 1.0, r), DVec3::new(0.0, -1.0, r)).to_degrees()
        };
        assert!((at(-1.0) - 90.0).abs() < 1e-12);
        assert!((at(1.0) + 90.0).abs() < 1e-12);
        assert_eq!(at(0.0), 0.0);
    }

    fn point() -> impl Strategy<Value = DVec3> {
        (-1.0..1.0, -1.0..1.0, -1.0..1.0).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    proptest! {
        #[test]
        fn the_closed_gradient_agrees_with_finite_differences(
            points in [point(), point(), point(), point()],
            flat in any::<bool>(),
            direction in [point(), point(), point(), point()],
        ) {
            let [p, q, r, mut s] = points;
            if flat {
                // The two triangles are coplanar, which is the case where the paper's formula is 0/0.
                s = p + q - r;
            }
            let (left, right) = (double_area_vector([p, q, r]), double_area_vector([q, p, s]));
            prop_assume!(left.length() > 0.1 && right.length() > 0.1 && p.distance(q) > 0.2);
            let angle = dihedral_angle(p, q, r, s);
            prop_assume!(angle.abs() < 3.0);
            let gradient = dihedral_angle_gradient(p, q, r, s);
            let step = 1e-5;
            let moved = |sign: f64| {
                let x = [p, q, r, s];
                let y: Vec<DVec3> = (0..4).map(|k| x[k] + direction[k] * (sign * step)).collect();
                dihedral_angle(y[0], y[1], y[2], y[3])
            };
            let difference = (moved(1.0) - moved(-1.0)) / (2.0 * step);
            let closed: f64 = (0..4).map(|k| gradient[k].dot(direction[k])).sum();
            let scale = gradient.iter().map(|g| g.length()).sum::<f64>().max(1.0);
            prop_assert!((difference - closed).abs() < 1e-6 * scale, "{difference} {closed}");
        }
    }

    /// The gradient at V3 by eq. 3 for the edge from V3 to V4 between the triangles (1, 3, 4) and (2, 4, 3), with the
    /// two denominators given.
    fn equation_3([v1, v2, v3, v4]: [DVec3; 4], angle: f64, denominators: impl Fn(DVec3, DVec3) -> [f64; 2]) -> DVec3 {
        let (e13, e14, e23, e24) = (v3 - v1, v4 - v1, v3 - v2, v4 - v2);
        let (n1, n2) = (e13.cross(e14), e24.cross(e23));
        let [first, second] = denominators(n1, n2);
        let (a, b) = (n1.cross(-e14) / first, n2.cross(e24) / second);
        let bracket = n1.dot(n2) * (a + b) - (n2.cross(-e14) + n1.cross(e24));
        angle.signum() * bracket / n1.cross(n2).length()
    }

    #[test]
    fn the_signs_of_equation_3_are_right_and_its_denominators_are_exchanged() {
        for height in [-0.7, 0.4] {
            let (v1, v2) = (DVec3::new(-1.0, 0.3, 0.2), DVec3::new(1.9, 0.1, height));
            let (v3, v4) = (DVec3::new(0.1, -0.8, 0.0), DVec3::new(0.0, 1.0, 0.1));
            let angle = dihedral_angle(v3, v4, v1, v2);
            let [closed, ..] = dihedral_angle_gradient(v3, v4, v1, v2);
            let corners = [v1, v2, v3, v4];
            let exchanged = equation_3(corners, angle, |n1, n2| [n1.length_squared(), n2.length_squared()]);
            let printed = equation_3(corners, angle, |n1, n2| [n2.length_squared(), n1.length_squared()]);
            assert!(exchanged.distance(closed) < 1e-12, "{height}: {exchanged} {closed}");
            assert!(printed.distance(closed) > 0.1, "{height}: {printed} {closed}");
        }
    }

    /// A wavy k x k grid on [0, 1]², oriented upwards.
    fn wavy(k: u32) -> Mesh {
        let at = |i, j| i * (k + 1) + j;
        let vertices = (0..=k)
            .flat_map(|i| (0..=k).map(move |j| (f64::from(i) / f64::from(k), f64::from(j) / f64::from(k))))
            .map(|(x, y)| DVec3::new(x + 0.03 * libm::sin(9.0 * y), y, 0.3 * libm::sin(5.0 * x) * libm::cos(4.0 * y)))
            .collect();
        let triangles = (0..k)
            .flat_map(|i| (0..k).map(move |j| (i, j)))
            .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
            .collect();
        Mesh::new(vertices, triangles)
    }

    #[test]
    fn every_row_of_the_jacobian_agrees_with_finite_differences_to_1e_6() {
        let mesh = wavy(5);
        let topology = mesh.check().unwrap();
        let moves: Vec<bool> = (0..mesh.vertices.len() as u32).map(|v| !topology.is_boundary(v)).collect();
        let mut rows = CurvatureRows::new(&topology, &moves, true);
        rows.differentiate(&mesh.vertices);
        let unknowns = (0..36).filter(|&v| rows.unknown_of(v).is_some()).count();
        assert_eq!((rows.rows(), unknowns), (36, 16));
        let mut worst: f64 = 0.0;
        for vertex in 0..mesh.vertices.len() {
            let Some(unknown) = rows.unknown_of(vertex) else { continue };
            for axis in DVec3::AXES {
                let step = 1e-5;
                let at = |sign: f64| {
                    let mut moved = mesh.clone();
                    moved.vertices[vertex] += axis * (sign * step);
                    let mut other = CurvatureRows::new(&topology, &moves, true);
                    other.evaluate(&moved.vertices);
                    other.curvatures().to_vec()
                };
                let (plus, minus) = (at(1.0), at(-1.0));
                for row in 0..rows.rows() {
                    let (columns, values) = rows.row(row);
                    let closed = columns.binary_search(&(unknown as u32)).map_or(0.0, |k| values[k].dot(axis));
                    let difference = (plus[row] - minus[row]) / (2.0 * step);
                    worst =
                        worst.max((closed - difference).abs() / values.iter().map(|v| v.length()).fold(1.0, f64::max));
                }
            }
        }
        assert!(worst < 1e-6, "{worst}");
    }

    #[test]
    fn a_cylinder_has_half_its_inverse_radius_twice() {
        // H approaches the sum of the two principal curvatures, which is 1/R for a cylinder of radius R.
        let (n, radius) = (64u32, 2.0);
        let rings = 5u32;
        let width = 2.0 * radius * libm::sin(std::f64::consts::PI / f64::from(n));
        let vertices = (0..rings)
            .flat_map(|i| (0..n).map(move |j| (i, j)))
            .map(|(i, j)| {
                let angle = f64::from(j) * std::f64::consts::TAU / f64::from(n);
                DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), f64::from(i) * width)
            })
            .collect();
        let triangles = (0..rings - 1)
            .flat_map(|i| (0..n).map(move |j| (i * n + j, i * n + (j + 1) % n)))
            .flat_map(|(a, b)| [[a, b, b + n], [a, b + n, a + n]])
            .collect();
        let mesh = Mesh::new(vertices, triangles);
        let topology = mesh.check().unwrap();
        let mut rows = CurvatureRows::new(&topology, &vec![true; mesh.vertices.len()], true);
        rows.evaluate(&mesh.vertices);
        let middle = rows.curvatures()[(2 * n) as usize];
        assert!((middle - 1.0 / radius).abs() < 1e-3, "{middle}");
    }
}
