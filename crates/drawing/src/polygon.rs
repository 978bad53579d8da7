//! Polygons in the plane: area, crossings, offsets and notches.

use plateau_mesh::DVec2;

/// Returns the area, positive if the points run counter-clockwise.
#[must_use]
pub fn area(points: &[DVec2]) -> f64 {
    let Some(&origin) = points.first() else { return 0.0 };
    let term = |k: usize| (points[k] - origin).perp_dot(points[(k + 1) % points.len()] - origin);
    0.5 * (0..points.len()).map(term).sum::<f64>()
}

/// Returns the point at which the polygon first crosses or touches itself, or `None` if it is simple. Neighbouring
/// edges may only share their common point.
#[must_use]
pub fn crossing(points: &[DVec2]) -> Option<DVec2> {
    let count = points.len();
    let edges: Vec<[DVec2; 2]> = (0..count).map(|k| [points[k], points[(k + 1) % count]]).collect();
    swept(&edges, |k, other| {
        let ([a, b], [c, d]) = (edges[k], edges[other]);
        if (k + 1) % count == other {
            folds_back(a, b, d)
        } else if (other + 1) % count == k {
            folds_back(c, a, b)
        } else {
            meeting([a, b], [c, d])
        }
    })
}

/// Whether two segments of an open chain of points meet that are not neighbours.
pub(crate) fn chain_meets_itself(points: &[DVec2]) -> bool {
    let segments: Vec<[DVec2; 2]> = points.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let apart = |k: usize, other: usize| k.abs_diff(other) > 1;
    swept(&segments, |k, other| if apart(k, other) { meeting(segments[k], segments[other]) } else { None }).is_some()
}

/// Returns what `compare` finds first among the pairs of segments whose extents overlap.
///
/// The segments are swept from left to right, and each is compared with those that have not ended yet. That takes
/// O(n log n) time for the outlines of pieces, whose edges are short.
fn swept(segments: &[[DVec2; 2]], compare: impl Fn(usize, usize) -> Option<DVec2>) -> Option<DVec2> {
    let mut order: Vec<usize> = (0..segments.len()).collect();
    let left = |k: usize| segments[k][0].x.min(segments[k][1].x);
    order.sort_by(|&one, &other| left(one).total_cmp(&left(other)));
    let mut active: Vec<usize> = Vec::new();
    for &k in &order {
        let [a, b] = segments[k];
        let (low, high) = (a.min(b), a.max(b));
        active.retain(|&other| {
            let [c, d] = segments[other];
            c.x.max(d.x) >= low.x
        });
        for &other in &active {
            let [c, d] = segments[other];
            if c.y.max(d.y) < low.y || c.y.min(d.y) > high.y {
                continue;
            }
            if let Some(found) = compare(k, other) {
                return Some(found);
            }
        }
        active.push(k);
    }
    None
}

/// Returns the corner if the edges a-b and b-c run back over each other.
fn folds_back(a: DVec2, b: DVec2, c: DVec2) -> Option<DVec2> {
    ((b - a).perp_dot(c - b) == 0.0 && (b - a).dot(c - b) < 0.0).then_some(b)
}

/// Returns a common point of two segments.
pub(crate) fn meeting([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<DVec2> {
    let side = |from: DVec2, to: DVec2, point: DVec2| (to - from).perp_dot(point - from);
    let [of_c, of_d, of_a, of_b] = [side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)];
    if of_c * of_d > 0.0 || of_a * of_b > 0.0 {
        return None;
    }
    if of_c == 0.0 && of_d == 0.0 {
        // On one line: do the extents overlap?
        let along = b - a;
        let at = |point: DVec2| (point - a).dot(along);
        let (low, high) = (at(c).min(at(d)), at(c).max(at(d)));
        return (high >= 0.0 && low <= along.length_squared()).then(|| if low >= 0.0 { c.min(d) } else { a });
    }
    let along = of_a / (of_a - of_b);
    Some(if along.is_finite() { a + (b - a) * along } else { a })
}

/// Returns the intersection of two lines, each given by a point and a unit direction, or `None` if they are parallel.
fn lines_meet((from, along): (DVec2, DVec2), (other, direction): (DVec2, DVec2)) -> Option<DVec2> {
    let sine = along.perp_dot(direction);
    // Below this sine the intersection is decided by rounding. Such neighbours get the point between them.
    (sine.abs() > 1e-9).then(|| from + along * ((other - from).perp_dot(direction) / sine))
}

/// Longest mitre of an offset, as a multiple of the larger of the two distances. Longer mitres, at corners below 29
/// degrees, are cut off at this distance.
const LONGEST_MITRE: f64 = 4.0;

/// Moves each edge of a polygon that runs counter-clockwise outwards by its own distance, and joins neighbours at their
/// intersection. Where an edge vanishes because its neighbours meet before it, the neighbours are joined instead. The
/// second list names for each point of the result the edge that starts there.
///
/// Returns `None` if fewer than three edges are left. The result may cross itself: see [`crossing`].
#[must_use]
pub fn offset(points: &[DVec2], distances: &[f64]) -> Option<(Vec<DVec2>, Vec<usize>)> {
    if distances.iter().all(|&distance| distance == 0.0) {
        return Some((points.to_vec(), (0..points.len()).collect()));
    }
    let count = points.len();
    let line = |k: usize| {
        let along = (points[(k + 1) % count] - points[k]).normalize_or_zero();
        (points[k] - along.perp() * distances[k], along)
    };
    let lines: Vec<(DVec2, DVec2)> = (0..count).map(line).collect();
    let corner = |before: usize, after: usize| {
        let shared = points[after];
        lines_meet(lines[before], lines[after]).unwrap_or_else(|| {
            let foot = |k: usize| lines[k].0 + lines[k].1 * (shared - lines[k].0).dot(lines[k].1);
            foot(before).midpoint(foot(after))
        })
    };
    let mut kept: Vec<usize> = (0..count).filter(|&k| points[k] != points[(k + 1) % count]).collect();
    // Every round removes an edge, so that there are at most as many rounds as edges.
    loop {
        if kept.len() < 3 {
            return None;
        }
        let around = |k: usize| kept[k % kept.len()];
        let length = kept.len();
        let reversed: Vec<bool> = (0..length)
            .map(|k| {
                let (before, own, after) = (around(k + length - 1), kept[k], around(k + 1));
                (corner(own, after) - corner(before, own)).dot(lines[own].1) < 0.0
            })
            .collect();
        if !reversed.contains(&true) {
            break;
        }
        // Of neighbours that are reversed only the shorter can vanish first.
        let own_length = |k: usize| points[around(k)].distance(points[(around(k) + 1) % count]);
        let vanishes = |k: usize| {
            let beside = [(k + length - 1) % length, (k + 1) % length];
            reversed[k]
                && beside.iter().all(|&other| !reversed[other] || (own_length(k), k) < (own_length(other), other))
        };
        let gone: Vec<bool> = (0..length).map(vanishes).collect();
        kept = kept.iter().enumerate().filter(|(k, _)| !gone[*k]).map(|(_, &own)| own).collect();
    }
    let (mut moved, mut edges) = (Vec::with_capacity(kept.len()), Vec::with_capacity(kept.len()));
    for k in 0..kept.len() {
        let (before, own) = (kept[(k + kept.len() - 1) % kept.len()], kept[k]);
        let at = corner(before, own);
        let limit = LONGEST_MITRE * distances[before].abs().max(distances[own].abs());
        let shared = points[own];
        let is_convex = lines[before].1.perp_dot(lines[own].1) > 0.0;
        let adjacent = (before + 1) % count == own;
        if adjacent && is_convex && at.distance(shared) > limit {
            // The mitre is cut off at right angles to its own direction.
            let towards = (at - shared).normalize();
            let cut = (shared + towards * limit, towards.perp());
            for neighbour in [before, own] {
                moved.push(lines_meet(lines[neighbour], cut).unwrap_or(at));
                edges.push(own);
            }
        } else {
            moved.push(at);
            edges.push(own);
        }
    }
    Some((moved, edges))
}

/// Half the width of a notch at the edge, in millimetres.
pub const NOTCH_HALF_WIDTH: f64 = 1.0;
/// Depth of a notch, in millimetres.
pub const NOTCH_DEPTH: f64 = 3.0;

/// A notch of a polygon: the edge, the fraction of its length, and the depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notch {
    pub edge: usize,
    pub fraction: f64,
    pub depth: f64,
}

/// Cuts a V into the polygon at each place. The notches are given in the order in which they follow each other around
/// the polygon.
///
/// # Errors
/// Returns the number of the first notch that overlaps the next one.
pub fn notched(points: &[DVec2], places: &[Notch], half_width: f64) -> Result<Vec<DVec2>, usize> {
    let count = points.len();
    let mut starts = Vec::with_capacity(count + 1);
    let mut along = 0.0;
    for k in 0..count {
        starts.push(along);
        along += points[k].distance(points[(k + 1) % count]);
    }
    let total = along;
    starts.push(total);
    let arc = |place: &Notch| starts[place.edge] + place.fraction * (starts[place.edge + 1] - starts[place.edge]);
    let at = |arc: f64| {
        let arc = arc.rem_euclid(total);
        let edge = starts.partition_point(|&start| start <= arc).clamp(1, count) - 1;
        let length = starts[edge + 1] - starts[edge];
        let fraction = if length > 0.0 { (arc - starts[edge]) / length } else { 0.0 };
        points[edge].lerp(points[(edge + 1) % count], fraction)
    };
    let arcs: Vec<f64> = places.iter().map(arc).collect();
    for k in 0..arcs.len() {
        let next = if k + 1 < arcs.len() { arcs[k + 1] } else { arcs[0] + total };
        if next - arcs[k] < 2.0 * half_width {
            return Err(k);
        }
    }
    let mut notched = Vec::with_capacity(count + 3 * places.len());
    let mut vertex = 0;
    // A notch near the first point may reach back over it, so that points within any notch are left out by arc length.
    let in_notch = |arc: f64| {
        let near = |&place: &f64| {
            let distance = (arc - place).abs();
            distance.min(total - distance) < half_width
        };
        let k = arcs.partition_point(|&place| place < arc);
        [k.checked_sub(1), Some(k), Some(0), arcs.len().checked_sub(1)]
            .into_iter()
            .flatten()
            .filter_map(|k| arcs.get(k))
            .any(near)
    };
    let keep = |upto: f64, vertex: &mut usize, notched: &mut Vec<DVec2>| {
        while *vertex < count && starts[*vertex] <= upto {
            if !in_notch(starts[*vertex]) {
                notched.push(points[*vertex]);
            }
            *vertex += 1;
        }
    };
    for (place, &arc) in places.iter().zip(&arcs) {
        keep(arc, &mut vertex, &mut notched);
        let direction = (points[(place.edge + 1) % count] - points[place.edge]).normalize_or_zero();
        let tip = at(arc) + direction.perp() * place.depth;
        notched.extend([at(arc - half_width), tip, at(arc + half_width)]);
    }
    keep(total, &mut vertex, &mut notched);
    Ok(notched)
}

/// Returns the chords of a polygon at a height: where each begins and ends along x, from left to right.
pub(crate) fn chords(points: &[DVec2], y: f64) -> Vec<[f64; 2]> {
    let mut at: Vec<f64> = (0..points.len())
        .map(|k| [points[k], points[(k + 1) % points.len()]])
        .filter(|[a, b]| (a.y > y) != (b.y > y))
        .map(|[a, b]| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y))
        .collect();
    at.sort_by(f64::total_cmp);
    at.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Whether a point lies inside a polygon.
#[must_use]
pub fn contains(points: &[DVec2], point: DVec2) -> bool {
    let mut inside = false;
    for k in 0..points.len() {
        let (a, b) = (points[k], points[(k + 1) % points.len()]);
        if (a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y) {
            inside = !inside;
        }
    }
    inside
}
