//! Local convexity of a bridge (definition 6, with the missing q_{j-1}): does the bridge lie on the convex hull of itself and
//! the neighbours of its end points? Equivalently, seen along the bridge, do the directions to the neighbours fit in a closed
//! half-plane?
//!
//! By default a direction may reach `tolerance` beyond the half-plane, and further by what rounding the input can do to
//! it; with tolerance 0 the answer is exact (adaptive predicates on the input's own coordinates).

use super::shortest_path::{Pulse, Region, Table};
use super::strip::Strip;
use crate::DVec3;
use crate::execution::Interruption;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// How convexity is judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Test {
    Exact,
    /// The sine of the angle that a direction may reach beyond the half-plane.
    Within(f64),
}

impl Test {
    /// `tolerance` in radians.
    pub(super) fn new(tolerance: f64) -> Self {
        if tolerance == 0.0 { Self::Exact } else { Self::Within(tolerance.sin()) }
    }
}

/// Whether a bridge is locally convex; indices are cyclic on closed strips.
pub(super) fn is_convex(strip: &Strip, [i, j]: [usize; 2], test: Test) -> bool {
    let (i, j) = (i % strip.m(), j % strip.n());
    match test {
        Test::Exact => is_convex_exactly(strip, i, j),
        Test::Within(sine) => is_convex_within(strip, i, j, sine),
    }
}

fn neighbours(strip: &Strip, i: usize, j: usize) -> [Option<(bool, usize)>; 4] {
    let of_p = |before| strip.p.neighbour(i, before, strip.closed).map(|k| (true, k));
    let of_q = |before| strip.q.neighbour(j, before, strip.closed).map(|k| (false, k));
    [of_p(true), of_p(false), of_q(true), of_q(false)]
}

fn is_convex_exactly(strip: &Strip, i: usize, j: usize) -> bool {
    let (p, q) = (strip.p.raw[i], strip.q.raw[j]);
    let mut near = [DVec3::ZERO; 4];
    let mut count = 0;
    for (on_p, k) in neighbours(strip, i, j).into_iter().flatten() {
        let point = if on_p { strip.p.raw[k] } else { strip.q.raw[k] };
        if !collinear(p, q, point) || (p == q && point != p) {
            near[count] = point;
            count += 1;
        }
    }
    let near = &near[..count];
    if p == q {
        return is_on_hull(p, near);
    }
    let mut sign = [[0i8; 4]; 4];
    for a in 0..count {
        for b in a + 1..count {
            sign[a][b] = orientation(p, q, near[a], near[b]);
            sign[b][a] = -sign[a][b];
        }
    }
    fits_in_half_plane(count, |a, b| sign[a][b] >= 0, |a, b| sign[a][b] <= 0)
}

/// Whether some direction has all others on one side of it.
fn fits_in_half_plane(count: usize, left: impl Fn(usize, usize) -> bool, right: impl Fn(usize, usize) -> bool) -> bool {
    let others = |a: usize| (0..count).filter(move |&b| b != a);
    count <= 2 || (0..count).any(|a| others(a).all(|b| left(a, b)) || others(a).all(|b| right(a, b)))
}

/// A bridge without length: the point is off the hull only if four neighbours surround it.
fn is_on_hull(p: DVec3, near: &[DVec3]) -> bool {
    let &[a, b, c, d] = near else { return true };
    let signs = [orientation(p, b, c, d), -orientation(p, a, c, d), orientation(p, a, b, d), -orientation(p, a, b, c)];
    !(signs.iter().all(|&s| s > 0) || signs.iter().all(|&s| s < 0))
}

fn orientation(p: DVec3, q: DVec3, a: DVec3, b: DVec3) -> i8 {
    let coord = |v: DVec3| Coord3D { x: v.x, y: v.y, z: v.z };
    let determinant = orient3d(coord(p), coord(q), coord(a), coord(b));
    i8::from(determinant > 0.0) - i8::from(determinant < 0.0)
}

fn collinear(p: DVec3, q: DVec3, a: DVec3) -> bool {
    let flat = |u: usize, v: usize| {
        let coord = |point: DVec3| Coord { x: point[u], y: point[v] };
        orient2d(coord(p), coord(q), coord(a)) == 0.0
    };
    flat(0, 1) && flat(1, 2) && flat(2, 0)
}

fn is_convex_within(strip: &Strip, i: usize, j: usize, sine: f64) -> bool {
    let (p, q) = (strip.p.points[i], strip.q.points[j]);
    let (bridge, rounding) = (q - p, strip.rounding);
    let length = bridge.length();
    if length <= rounding {
        return is_convex_exactly(strip, i, j);
    }
    // A direction, its doubled area with the bridge (distance from the bridge's line times the bridge's length).
    let mut near = [(DVec3::ZERO, DVec3::ZERO, 0.0); 4];
    let mut count = 0;
    for (on_p, k) in neighbours(strip, i, j).into_iter().flatten() {
        let direction = if on_p { strip.p.points[k] - p } else { strip.q.points[k] - q };
        let area = direction.cross(bridge);
        let distance = area.length();
        if distance > rounding * length {
            near[count] = (direction, area, distance);
            count += 1;
        }
    }
    // sin of the angle from a to b times both distances times the bridge's length, and how far below 0 it may be:
    // tolerance and rounding / distance for each of the two directions.
    let side = |a: usize, b: usize| -near[a].1.dot(near[b].0);
    let slack = |a: usize, b: usize| {
        let (a, b) = (near[a].2, near[b].2);
        2.0 * sine * a * b / length + rounding * (a + b)
    };
    fits_in_half_plane(count, |a, b| side(a, b) >= -slack(a, b), |a, b| side(a, b) <= slack(a, b))
}

/// Marks every bridge that is not locally convex, in a table that a sweep of `width` lanes can read.
pub(super) fn concave_bridges(
    strip: &Strip,
    columns: usize,
    width: usize,
    test: Test,
    pulse: &mut Pulse<'_, '_>,
) -> Result<Table, Interruption> {
    let (m, n) = (strip.m(), strip.n());
    let mut table = Table::default();
    table.lay_out(&Region::full(m, 0, columns - 1), 1, width);
    for i in 0..m {
        for block in (0..n).step_by(4096) {
            let end = n.min(block + 4096);
            for j in block..end {
                if !is_convex(strip, [i, j], test) {
                    table.set([i, j]);
                    if columns > n {
                        table.set([i, j + n]);
                    }
                }
            }
            // A bridge costs here what a dozen cells of a sweep do.
            pulse.beat((end - block) as u64)?;
        }
    }
    Ok(table)
}
