//! Proves the bound in interval arithmetic, by an upper bound of |curl A| and a lower bound of ∮A.
//!
//! **|curl A|.** The curl is linear on a tetrahedron and |·| is convex, so that its values at the four vertices
//! suffice. It is bounded in all constrained tetrahedra: those that meet the intersection of the half-spaces (`hull`).
//!
//! **∮A.** A segment of the boundary is followed through the mesh by rounded barycentric coordinates. Non-negative
//! weights, not all zero, define an exact point: the weighted mean of the tetrahedron's vertices. Rounded coordinates
//! therefore describe *another* polygon exactly. This rounded polygon follows the given polygon up to rounding. Each of
//! its pieces lies in one tetrahedron, where the integral has a closed form. At the end of a piece, only the
//! coordinates at vertices that belong to this and the next tetrahedron are kept, so that the end of the piece is
//! exactly the start of the next.
//!
//! A strip of triangles lies between the two polygons. It is thinner than the distance between the polygons and every
//! unconstrained tetrahedron; otherwise there is no bound. Because |curl A| <= 1 in the strip, the two circulations
//! differ by at most the area of the strip, which is bounded too. If the mesh has axes of its own, the given polygon is
//! known up to intervals. The axes are perpendicular only up to rounding, and the bound is divided by the largest
//! factor by which they can enlarge an area.

use super::bisection::{BisectionMesh, EDGES, Piece};
use super::element::{EVEN, Orientation, UNKNOWNS};
use super::interval::{Interval, IntervalVector};
use super::space::Space;
use super::symmetry::{self, Axes};
use plateau_mesh::DVec3;

/// The values of a field at the unknowns of a leaf, in the leaf's order.
fn local(space: &Space, field: &[f64], leaf: usize) -> [f64; UNKNOWNS] {
    space.unknowns[leaf].map(|unknown| field[unknown as usize])
}

/// An upper bound of |curl A| in the constrained leaves.
pub(super) fn largest_curl(space: &Space, field: &[f64]) -> f64 {
    let mut largest: f64 = 0.0;
    for &leaf in &space.constrained {
        let leaf = leaf as usize;
        let corners = &space.corners[leaf];
        let values = local(space, field, leaf).map(Interval::exactly);
        let [a, b, c, d] = corners.map(IntervalVector::exactly);
        let volume = (b - a).cross(c - a).dot(d - a);
        for at in curl_numerators(*corners, &values, &space.orientations[leaf]) {
            let curl = (at.length_squared() / volume.square()).sqrt().high;
            largest = if curl.is_nan() { f64::INFINITY } else { largest.max(curl) };
        }
    }
    largest
}

/// Six times the signed volume times the curl at each vertex.
fn curl_numerators(
    corners: [DVec3; 4],
    values: &[Interval; UNKNOWNS],
    orientation: &Orientation,
) -> [IntervalVector; 4] {
    let mut result = [IntervalVector::ZERO; 4];
    // For each vertex, the coefficients of the products ∇λi × ∇λj.
    let mut coefficients = [[[Interval::ZERO; 4]; 4]; 4];
    for (p, at) in coefficients.iter_mut().enumerate() {
        for (e, [a, b]) in EDGES.into_iter().enumerate() {
            let value = values[e].times(2.0);
            at[a][b] = if orientation.ascending[e] { value } else { -value };
        }
        for (f, [i, j, k]) in orientation.faces.into_iter().enumerate() {
            let (first, second) = (values[6 + 2 * f], values[7 + 2 * f]);
            if p == i {
                at[j][k] = at[j][k] - first + second.times(2.0);
            } else if p == j {
                at[k][i] = at[k][i] - first - second;
            } else if p == k {
                at[i][j] = at[i][j] + first.times(2.0) - second;
            }
        }
    }
    let corner = corners.map(IntervalVector::exactly);
    for (at, out) in coefficients.iter().zip(&mut result) {
        for [i, j, k, l] in EVEN {
            *out = *out + (corner[l] - corner[k]).scaled(at[i][j] - at[j][i]);
        }
    }
    result
}

/// A piece of the rounded polygon, and the segment of the given polygon that it follows.
#[derive(Clone, Copy, Debug)]
struct Link {
    piece: Piece,
    /// The given segment, in the coordinates of the mesh.
    segment: [IntervalVector; 2],
}

/// A lower bound of the area of all surfaces bounded by closed polygons. It is the circulation of a field with |curl|
/// <= 1 around the directed loops, minus the magnitude of its circulation around the `free` loops. `None` if the
/// rounded polygon is farther than `margin` from the given polygon. `axes` are the axes of the field, if they differ
/// from those of the loops.
pub(super) fn least_area(
    space: &Space,
    mesh: &BisectionMesh,
    field: &[f64],
    (loops, free): (&[Vec<DVec3>], &[usize]),
    axes: Option<&Axes>,
    margin: f64,
) -> Option<f64> {
    let rounded = |point| symmetry::place(axes, point);
    let exact = |point| axes.map_or_else(|| IntervalVector::exactly(point), |axes| axes.place_rigorously(point));
    let mut sum = Interval::ZERO;
    for (number, points) in loops.iter().enumerate() {
        let mut around = Interval::ZERO;
        let mut links: Vec<Link> = Vec::new();
        for (k, &from) in points.iter().enumerate() {
            let to = points[(k + 1) % points.len()];
            let segment = [from, to].map(exact);
            let pieces = mesh.trace(rounded(from), rounded(to));
            links.extend(pieces.into_iter().map(|piece| Link { piece, segment }));
        }
        close(mesh, &mut links)?;
        for link in &links {
            let Piece { leaf, from, to, flips, .. } = link.piece;
            let leaf = leaf as usize;
            let along = integral(&local(space, field, leaf), from, to, &space.orientations[leaf]);
            around = around + along.times(mesh.mirrors().sign(flips));
            let strip = strip_area(&space.corners[leaf].map(|corner| mesh.reflect(corner, flips)), link, margin)?;
            around = around + Interval { low: -strip, high: strip };
        }
        if free.contains(&number) {
            let most = around.low.abs().max(around.high.abs());
            around = Interval { low: -most, high: most };
        }
        sum = sum + around;
    }
    let area = axes.map_or(sum, |axes| Interval::exactly(sum.low.max(0.0)) / axes.enlargement());
    area.low.is_finite().then_some(area.low)
}

/// Makes the end of every piece and the start of the next piece the same point. `None` if this point is too far from
/// the vertices that both leaves have in common.
fn close(mesh: &BisectionMesh, links: &mut [Link]) -> Option<()> {
    for k in 0..links.len() {
        let next = (k + 1) % links.len();
        let (here, there) = (links[k].piece, links[next].piece);
        let (own, other) = (mesh.leaf_vertices(here.leaf as usize), mesh.leaf_vertices(there.leaf as usize));
        let (mut to, mut from) = ([0.0; 4], [0.0; 4]);
        // A vertex of both leaves is a common vertex of their mirror images only if it lies in the planes between the
        // images.
        let between = BisectionMesh::planes_between(here.flips, there.flips);
        for (i, vertex) in own.iter().enumerate() {
            if mesh.planes_at(*vertex) & between != between {
                continue;
            }
            if let Some(j) = other.iter().position(|v| v == vertex) {
                (to[i], from[j]) = (here.to[i], here.to[i]);
            }
        }
        if to.iter().sum::<f64>() < 0.5 {
            return None;
        }
        links[k].piece.to = to;
        links[next].piece.from = from;
    }
    Some(())
}

fn sum_of(at: [f64; 4]) -> Interval {
    at.into_iter().fold(Interval::ZERO, |sum, x| sum + Interval::exactly(x))
}

/// The integral of the field along a straight piece, whose ends are weighted means of the tetrahedron's vertices.
fn integral(values: &[f64; UNKNOWNS], from: [f64; 4], to: [f64; 4], orientation: &Orientation) -> Interval {
    let (from_sum, to_sum) = (sum_of(from), sum_of(to));
    let from = from.map(|x| Interval::exactly(x) / from_sum);
    let to = to.map(|x| Interval::exactly(x) / to_sum);
    let whitney = |i: usize, j: usize| from[i] * to[j] - from[j] * to[i];
    let mut sum = Interval::ZERO;
    for (e, [a, b]) in EDGES.into_iter().enumerate() {
        let along = if orientation.ascending[e] { whitney(a, b) } else { whitney(b, a) };
        sum = sum + Interval::exactly(values[e]) * along;
    }
    for (f, [i, j, k]) in orientation.faces.into_iter().enumerate() {
        let first = (from[k] + to[k]) * whitney(i, j);
        let second = (from[i] + to[i]) * whitney(j, k);
        let twice = Interval::exactly(values[6 + 2 * f]) * first + Interval::exactly(values[7 + 2 * f]) * second;
        sum = sum + twice.times(0.5);
    }
    sum
}

/// An upper bound of the area of the two triangles between a piece and the part of the given segment that it follows.
/// `None` if the distance between them may exceed `margin`.
fn strip_area(corners: &[DVec3; 4], link: &Link, margin: f64) -> Option<f64> {
    let [origin, end] = link.segment;
    let along = end - origin;
    let given = |t: f64| {
        // The ends are the given points themselves.
        if t == 1.0 { end } else { origin + along.scaled(Interval::exactly(t)) }
    };
    let point = |at: [f64; 4]| {
        let sum = sum_of(at);
        let mut point = IntervalVector::ZERO;
        for (corner, x) in corners.iter().zip(at) {
            point = point + (IntervalVector::exactly(*corner) - origin).scaled(Interval::exactly(x) / sum);
        }
        point + origin
    };
    let [t0, t1] = link.piece.range;
    let (c0, c1) = (given(t0), given(t1));
    let (q0, q1) = (point(link.piece.from), point(link.piece.to));
    let bound = |a: f64, b: f64| Interval::exactly(a) * Interval::exactly(b);
    let (start, end) = ((q0 - c0).length_at_most(), (q1 - c1).length_at_most());
    let twice = bound((c1 - c0).length_at_most(), end) + bound((q1 - q0).length_at_most(), start);
    (start.max(end) <= margin).then(|| twice.times(0.5).high)
}
