//! Exact intersection tests for triangles and segments, based on the adaptive predicates of `robust`.

use crate::DVec3;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// A common point of two triangles without a common vertex, or `None` if they do not meet.
pub(super) fn meet_apart(a: &[DVec3; 3], b: &[DVec3; 3]) -> Option<DVec3> {
    for (one, other) in [(a, b), (b, a)] {
        let sides = other.map(|corner| volume(one, corner));
        if sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0) {
            return None;
        }
    }
    // Two triangles meet if and only if an edge of either triangle meets the other triangle. This also holds if one
    // lies inside the other in the same plane.
    [(a, b), (b, a)]
        .into_iter()
        .find_map(|(one, other)| (0..3).find_map(|k| segment_meets_triangle(one[k], one[(k + 1) % 3], other)))
}

/// The midpoint of the common edge of two triangles, if they lie in one plane and are folded onto each other. Their
/// third corners are `third` and `fourth`.
pub(super) fn overlap_beside_edge(from: DVec3, to: DVec3, third: DVec3, fourth: DVec3) -> Option<DVec3> {
    let triangle = [from, to, third];
    if volume(&triangle, fourth) != 0.0 {
        return None;
    }
    let axes = plane_axes(&triangle)?;
    let same = turn(axes, from, to, third) * turn(axes, from, to, fourth) > 0.0;
    same.then(|| (from + to) * 0.5)
}

/// A point where a segment meets a triangle that has an area, both closed. Whether they meet is decided exactly; the
/// point is rounded.
pub(super) fn segment_meets_triangle(p: DVec3, q: DVec3, triangle: &[DVec3; 3]) -> Option<DVec3> {
    let (above, below) = (volume(triangle, p), volume(triangle, q));
    if above == 0.0 && below == 0.0 {
        return segment_meets_in_plane(p, q, triangle);
    }
    if (above > 0.0 && below > 0.0) || (above < 0.0 && below < 0.0) {
        return None;
    }
    let [a, b, c] = *triangle;
    let turns = [volume(&[p, q, a], b), volume(&[p, q, b], c), volume(&[p, q, c], a)];
    let meets = turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0);
    meets.then(|| p + (q - p) * (above / (above - below)))
}

fn segment_meets_in_plane(p: DVec3, q: DVec3, triangle: &[DVec3; 3]) -> Option<DVec3> {
    let axes = plane_axes(triangle)?;
    let turn = |a: DVec3, b: DVec3, c: DVec3| turn(axes, a, b, c);
    let [a, b, c] = *triangle;
    let edges = [(a, b), (b, c), (c, a)];
    let orientation = turn(a, b, c).signum();
    let is_inside = |point: DVec3| edges.iter().all(|&(from, to)| turn(from, to, point) * orientation >= 0.0);
    if let Some(inside) = [p, q].into_iter().find(|&end| is_inside(end)) {
        return Some(inside);
    }
    edges.into_iter().find_map(|(from, to)| {
        let ends = [turn(from, to, p), turn(from, to, q)];
        let sides = [turn(p, q, from), turn(p, q, to)];
        if ends == [0.0; 2] {
            // On one line: neither end is inside, so the segment covers the edge or misses it.
            let covers = from.cmpge(p.min(q)).all() && from.cmple(p.max(q)).all();
            return covers.then_some(from);
        }
        let opposite = |[one, other]: [f64; 2]| !(one > 0.0 && other > 0.0 || one < 0.0 && other < 0.0);
        (opposite(ends) && opposite(sides)).then(|| p + (q - p) * (ends[0] / (ends[0] - ends[1])))
    })
}

/// Whether a segment passes from one side of a triangle's plane to the other through the triangle: through its inside,
/// an edge or a corner.
pub(crate) fn passes_through([p, q]: [DVec3; 2], triangle: &[DVec3; 3]) -> bool {
    let [a, b, c] = *triangle;
    let (above, below) = (volume(triangle, p), volume(triangle, q));
    if !(above > 0.0 && below < 0.0 || above < 0.0 && below > 0.0) {
        return false;
    }
    let turns = [volume(&[p, q, a], b), volume(&[p, q, b], c), volume(&[p, q, c], a)];
    turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0)
}

/// Whether an edge of `edges` runs through the inside of `triangle`.
pub(super) fn pierces(edges: &[DVec3; 3], triangle: &[DVec3; 3]) -> bool {
    let [a, b, c] = *triangle;
    (0..3).any(|k| {
        let (p, q) = (edges[k], edges[(k + 1) % 3]);
        let (above, below) = (volume(triangle, p), volume(triangle, q));
        if !(above > 0.0 && below < 0.0 || above < 0.0 && below > 0.0) {
            return false;
        }
        let turns = [volume(&[p, q, a], b), volume(&[p, q, b], c), volume(&[p, q, c], a)];
        turns.iter().all(|&turn| turn > 0.0) || turns.iter().all(|&turn| turn < 0.0)
    })
}

/// Six times the signed volume of the tetrahedron of a triangle and a point. The sign is exact.
fn volume([a, b, c]: &[DVec3; 3], d: DVec3) -> f64 {
    let coord = |p: DVec3| Coord3D { x: p.x, y: p.y, z: p.z };
    orient3d(coord(*a), coord(*b), coord(*c), coord(d))
}

/// Twice the signed area of a triangle projected to the plane of two coordinate axes. The sign is exact.
fn turn([u, v]: [usize; 2], a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let coord = |p: DVec3| Coord { x: p[u], y: p[v] };
    orient2d(coord(a), coord(b), coord(c))
}

/// Two coordinate axes such that the triangle's projection to their plane has an area. `None` if the triangle has no
/// area.
pub(super) fn plane_axes(&[a, b, c]: &[DVec3; 3]) -> Option<[usize; 2]> {
    [[0, 1], [1, 2], [2, 0]].into_iter().find(|&axes| turn(axes, a, b, c) != 0.0)
}
