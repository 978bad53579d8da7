//! The vertices of a film that the fixed points and curves of its request hold.

use super::comparison::Audit;
use super::edges::Edges;
use plateau_mesh::DVec3;
use plateau_mesh::polyline::position_key;

/// Largest distance of a vertex from the segment of a fixed curve on which it was added, in the audit's step, which is
/// 8 units in the last place of the largest coordinate.
const BESIDE: f64 = 1.0;

/// Marks the vertices at fixed points and along fixed curves in `is_held`. Requires that each point is a vertex and
/// that each segment of a curve runs along edges of the mesh. O(edges), and the edges around the vertices of curves.
pub(crate) fn mark(audit: &mut Audit, edges: &Edges, points: &[DVec3], curves: &[Vec<DVec3>], is_held: &mut [bool]) {
    let vertices = &audit.contents.mesh.vertices;
    let mut places: Vec<([u64; 3], u32)> = vertices.iter().copied().map(position_key).zip(0..).collect();
    places.sort_unstable();
    // Several vertices lie at one place where boundaries touch.
    let at = |point: DVec3| {
        let key = position_key(point);
        let start = places.partition_point(|place| place.0 < key);
        places[start..].iter().take_while(move |place| place.0 == key).map(|place| place.1)
    };
    let mut missing = None;
    for (k, &point) in points.iter().chain(curves.iter().flatten()).enumerate() {
        at(point).for_each(|v| is_held[v as usize] = true);
        if at(point).next().is_none() {
            missing = missing.or(Some(k));
        }
    }
    let neighbours = if curves.is_empty() { Neighbours::default() } else { Neighbours::of(edges, vertices.len()) };
    let mut lost = None;
    for (k, curve) in curves.iter().enumerate() {
        for (i, pair) in curve.windows(2).enumerate().filter(|(_, pair)| pair[0] != pair[1]) {
            let [a, b] = [pair[0], pair[1]];
            let walk = at(a).find_map(|start| neighbours.walk(vertices, [a, b], start, BESIDE * audit.step));
            match walk {
                Some(walk) => walk.into_iter().for_each(|v| is_held[v as usize] = true),
                None => lost = lost.or(Some([k, i])),
            }
        }
    }
    audit.require(
        missing.is_none(),
        || "every point of the constraints is a vertex".into(),
        || missing.map_or_else(String::new, |k| format!("point {k} is none")),
    );
    audit.require(
        lost.is_none(),
        || "every segment of a fixed curve runs along edges of the mesh".into(),
        || lost.map_or_else(String::new, |[k, i]| format!("segment {i} of curve {k} does not")),
    );
}

/// The neighbours of each vertex.
#[derive(Default)]
struct Neighbours {
    /// The neighbours of v are `list[first[v]..first[v + 1]]`.
    first: Vec<u32>,
    list: Vec<u32>,
}

impl Neighbours {
    fn of(edges: &Edges, count: usize) -> Self {
        let mut first = vec![0u32; count + 1];
        edges.list.iter().flat_map(|edge| edge.ends).for_each(|v| first[v as usize + 1] += 1);
        for v in 0..count {
            first[v + 1] += first[v];
        }
        let mut next = first.clone();
        let mut list = vec![0; 2 * edges.list.len()];
        for [a, b] in edges.list.iter().map(|edge| edge.ends) {
            for [v, w] in [[a, b], [b, a]] {
                list[next[v as usize] as usize] = w;
                next[v as usize] += 1;
            }
        }
        Self { first, list }
    }

    fn around(&self, v: u32) -> &[u32] {
        &self.list[self.first[v as usize] as usize..self.first[v as usize + 1] as usize]
    }

    /// Returns the vertices from `start` along the segment from `a` to `b`, of which each is at most `beside` away from
    /// the segment. Returns `None` if no edges lead along the segment to a vertex at `b`.
    fn walk(&self, vertices: &[DVec3], [a, b]: [DVec3; 2], start: u32, beside: f64) -> Option<Vec<u32>> {
        let direction = (b - a).normalize_or_zero();
        let along = |v: u32| (vertices[v as usize] - a).dot(direction);
        let mut walk = vec![start];
        let mut here = start;
        // At most one pass for each vertex, because each lies farther along the segment than the one before.
        while vertices[here as usize] != b {
            let is_ahead = |v: &&u32| {
                let off = (vertices[**v as usize] - a).reject_from_normalized(direction).length();
                along(**v) > along(here) && off <= beside
            };
            here = *self.around(here).iter().filter(is_ahead).min_by(|v, w| along(**v).total_cmp(&along(**w)))?;
            walk.push(here);
        }
        Some(walk)
    }
}
