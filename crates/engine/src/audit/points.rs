//! Checks that the points of the request are at their vertices, and that its boundaries run along the mesh.

use super::comparison::Audit;
use super::edges::{Edge, Edges};
use plateau_archive::Lines;
use plateau_archive::archive::Contents;
use plateau_mesh::polyline::position_key;
use plateau_mesh::{DVec3, polyline};
use std::collections::BTreeMap;

/// Largest distance of a point from the point into which it was merged, as a fraction of the polyline's radius. It
/// leaves a margin over the distance at which neighbours are merged.
const MERGED: f64 = 1e-7;
/// Largest distance of a point from the segment on which it was added, in the audit's step, which is 8 units in the
/// last place of the largest coordinate.
const BESIDE: f64 = 1.0;

/// Requires that each point is exactly at its vertex. A point that was merged into another one only has to be near the
/// vertex.
pub(crate) fn at_their_vertices<'p>(audit: &mut Audit, polylines: impl Iterator<Item = &'p [DVec3]>) {
    near_their_vertices(audit, polylines, |_, _| 0.0);
}

/// Requires that each point is at most as far from its vertex as `allowed` says for its index and the number of points
/// of its polyline. A point that was merged into another one may also be farther by the distance at which points are
/// merged. Returns the distance of each vertex from the point that it stands for, except for merged points.
pub(crate) fn near_their_vertices<'p>(
    audit: &mut Audit,
    polylines: impl Iterator<Item = &'p [DVec3]>,
    allowed: impl Fn(usize, usize) -> f64,
) -> Vec<(u32, f64)> {
    let contents = audit.contents;
    let (mut count, mut moves) = (0, Vec::new());
    for (k, points) in polylines.enumerate() {
        count = k + 1;
        let numbers = contents.input_vertices.get(k).map_or(&[][..], |numbers| &numbers[..]);
        let lengths = || format!("{} vertices for {} points", numbers.len(), points.len());
        audit.require(numbers.len() == points.len(), || format!("each point of polyline {k} has its vertex"), lengths);
        let near = MERGED * polyline::radius(points);
        // A merged point directly follows the point into which it was merged, except at the end of a closed polyline,
        // where points are merged into the first one.
        let mut before = None;
        for (i, (&point, &v)) in points.iter().zip(numbers).enumerate() {
            let vertex = contents.mesh.vertices[v as usize];
            let is_merged = i > 0 && (before == Some(v) || Some(&v) == numbers.first());
            let (distance, allowed) = (vertex.distance(point), allowed(i, points.len()));
            let holds = if allowed > 0.0 { distance <= allowed } else { vertex == point };
            audit.require(
                holds || is_merged && distance <= allowed + near,
                || format!("point {i} of polyline {k} is at its vertex"),
                || format!("vertex {v} is {distance} away, of {allowed} allowed"),
            );
            if !is_merged {
                moves.push((v, distance));
            }
            before = Some(v);
        }
    }
    let lists = contents.input_vertices.len();
    audit.require(count == lists, || "each polyline of the request has its vertices".into(), || lists.to_string());
    moves
}

/// Returns the polylines of the line set with this name.
#[must_use]
pub(crate) fn polylines<'c>(contents: &'c Contents, name: &str) -> Vec<&'c [u32]> {
    let sets = contents.line_sets.iter().filter(|set| set.name == name);
    let vertices_of = |lines: &'c Lines| match lines {
        Lines::Polylines(polylines) => polylines.iter().map(|line| &line.vertices[..]).collect(),
        _ => Vec::new(),
    };
    sets.flat_map(|set| vertices_of(&set.lines)).collect()
}

/// Boundary vertices that share their position with others, by position. Where boundaries touch, the mesh has a
/// separate vertex for each of them.
struct Twins(BTreeMap<[u64; 3], Vec<u32>>);

impl Twins {
    fn of(contents: &Contents, loops: &[&[u32]]) -> Self {
        let key = |v: u32| position_key(contents.mesh.vertices[v as usize]);
        let mut places: Vec<([u64; 3], u32)> = loops.iter().flat_map(|rim| rim.iter()).map(|&v| (key(v), v)).collect();
        places.sort_unstable();
        places.dedup();
        let shared = places.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1);
        Self(shared.map(|same| (same[0].0, same.iter().map(|place| place.1).collect())).collect())
    }

    fn has(&self, contents: &Contents, v: u32) -> bool {
        !self.0.is_empty() && self.0.contains_key(&position_key(contents.mesh.vertices[v as usize]))
    }

    /// Returns the edge between two vertices, or between other vertices at the same two positions.
    fn edge<'e>(&self, contents: &Contents, edges: &'e Edges, a: u32, b: u32) -> Option<&'e Edge> {
        edges.between(a, b).or_else(|| {
            let twins_of =
                |v: u32| self.0.get(&position_key(contents.mesh.vertices[v as usize])).map_or(vec![v], Vec::clone);
            let (one, other) = (twins_of(a), twins_of(b));
            one.iter().find_map(|&a| other.iter().find_map(|&b| edges.between(a, b)))
        })
    }
}

/// Checks that each closed boundary runs along edges of the mesh with exactly `triangles` triangles, that all edges
/// with this number of triangles lie on boundaries, and that each boundary passes the request's points in their order.
/// With `straight`, the vertices between two of these points must lie on the segment between them, in its order.
pub(crate) fn along_boundaries(audit: &mut Audit, edges: &Edges, triangles: u32, straight: bool) {
    let contents = audit.contents;
    let position = |v: u32| contents.mesh.vertices[v as usize];
    let loops = polylines(contents, "boundaries");
    let twins = Twins::of(contents, &loops);
    let radius = polyline::radius(&loops.iter().flat_map(|rim| rim.iter()).map(|&v| position(v)).collect::<Vec<_>>());
    // Boundaries may share sides, such as the rims of sheets that meet.
    let mut borders = Vec::new();
    for (k, rim) in loops.iter().enumerate() {
        let next = |i: usize| rim[(i + 1) % rim.len()];
        let border =
            |i: usize| twins.edge(contents, edges, rim[i], next(i)).filter(|edge| edge.triangles() == triangles);
        borders.extend((0..rim.len()).filter_map(&border).map(|edge| edge.ends));
        let off = (0..rim.len()).find(|&i| border(i).is_none());
        audit.require(
            off.is_none(),
            || format!("boundary {k} runs along border edges of the mesh"),
            || off.map_or_else(String::new, |i| format!("not from vertex {} to vertex {}", rim[i], next(i))),
        );
        let mut numbers = contents.input_vertices.get(k).cloned().unwrap_or_default();
        numbers.dedup();
        if numbers.len() > 1 && numbers.first() == numbers.last() {
            numbers.pop();
        }
        let mut from = rim.iter().position(|v| Some(v) == numbers.first());
        let mut stray = None;
        for (i, &vertex) in numbers.iter().enumerate().skip(1).chain(numbers.iter().enumerate().take(1)) {
            let Some(start) = from else { break };
            let steps = (1..=rim.len()).find(|step| rim[(start + step) % rim.len()] == vertex);
            from = steps.map(|steps| start + steps);
            let Some(steps) = steps.filter(|_| straight) else { continue };
            let (a, b) = (position(rim[start % rim.len()]), position(vertex));
            // If another boundary has a vertex on this side, the side passes through that vertex, which may be as far
            // beside the segment as points are merged.
            let touches = (1..steps).any(|step| twins.has(contents, rim[(start + step) % rim.len()]));
            let beside = if touches { MERGED * radius } else { BESIDE * audit.step };
            let along = (b - a).normalize_or_zero();
            let mut reached = 0.0;
            for step in 1..steps {
                let v = rim[(start + step) % rim.len()];
                let offset = position(v) - a;
                let place = offset.dot(along);
                let distance = (offset - place * along).length();
                if !(distance <= beside && place >= reached) {
                    stray = stray.or(Some((i, v, distance)));
                }
                reached = place;
            }
        }
        let total = numbers.len();
        // A full turn passes every point once and ends where it began.
        let turn = from.map(|end| end - rim.iter().position(|v| Some(v) == numbers.first()).unwrap_or_default());
        audit.require(
            turn == Some(rim.len()) || total == 0,
            || format!("boundary {k} passes the request's points in their order"),
            || "it does not".into(),
        );
        audit.require(
            stray.is_none(),
            || format!("points added on boundary {k} lie on its segments in their order"),
            || stray.map_or_else(String::new, |(i, v, far)| format!("vertex {v} before point {i} is {far} beside")),
        );
    }
    borders.sort_unstable();
    borders.dedup();
    let (followed, found) = (borders.len(), edges.list.iter().filter(|edge| edge.triangles() == triangles).count());
    audit.require(
        found == followed,
        || format!("the boundaries have all {found} border edges of the mesh"),
        || followed.to_string(),
    );
}
