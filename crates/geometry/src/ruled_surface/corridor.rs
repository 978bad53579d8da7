//! Which bridges a strip of least area can have: most of the grid is left out before the search, and the optimum stays exact.
//!
//! Take one square of the grid, bank edges u = p_{i+1} - p_i and v = q_{j+1} - q_j. Swapping "P-step, then Q-step" for
//! "Q-step, then P-step" flips the diagonal of the quadrilateral p_i p_{i+1} q_{j+1} q_j. With A the area,
//!
//!   D = A(P, Q) - A(Q, P) = -½ |u| |v| ∫∫ (1 - cos γ) sin(θ_u + θ_v) ds dt,   s, t from 0 to 1,
//!
//! where for the bridge e = (q_j + t v) - (p_i + s u) the angles θ_u and θ_v are those of u and v with e, and γ is the angle
//! between the planes (u, e) and (v, e). (A triangle's area changes with s or t by ½ (u × v)·n of its unit normal n; the
//! double integral of the difference of the two normals is D, and spherical trigonometry at e gives the integrand.) The sine
//! has the sign of (û + v̂)·e, û and v̂ unit: of how far the bridge *leans forward*. It is linear in s and in t, so its sign at
//! the square's four bridges decides: where all lean forward, q is ahead and taking the P-step first never costs more; where
//! all lean back, taking the Q-step first never does.
//!
//! So if every square right of a staircase leans forward, a path that strays there can be cut off at the staircase without
//! growing, and likewise on the left of one where every square leans back. The *corridor* lies between two such staircases.
//! Boxes around runs of points and edge directions, halved where they leave the sign open, find it in some multiple of
//! m + n steps on smooth directrices; where the sign stays open in too many places the corridor is the whole grid.

use super::shortest_path::{Pulse, Region};
use super::strip::Strip;
use crate::DVec3;
use crate::execution::Interruption;
use std::cmp::Ordering;

/// Edges in the shortest runs: squares are not looked at one by one.
const LEAF: usize = 8;

/// The search for the corridor ends where this share of the grid has no certain sign: it would cost more than it saves.
const HOPELESS: f64 = 0.25;

/// A lean, coordinates being about 1, is certain beyond the rounding of its computation.
const ROUNDING: f64 = 1e-12;

/// The bridges of an open strip among which a path of least area is found.
pub(super) fn corridor(strip: &Strip, pulse: &mut Pulse<'_, '_>) -> Result<Region, Interruption> {
    let (m, n) = (strip.m(), strip.n());
    let whole = Region::full(m, 0, n - 1);
    let (Some(p), Some(q)) = (Tree::new(&strip.p.points), Tree::new(&strip.q.points)) else { return Ok(whole) };
    // Per row of squares: the first that may lean forward, and one more than the last that may lean back. The P-step that
    // crosses the row is taken between the two.
    let (mut first, mut last) = (vec![n - 1; m - 1], vec![0; m - 1]);
    let mut open_leaves = (HOPELESS * (p.leaves() * q.leaves()) as f64) as usize;
    let mut stack = vec![([p.top(), q.top()], [0, 0])];
    while let Some(([level_p, level_q], [a, b])) = stack.pop() {
        pulse.beat(1)?;
        let (rows, columns) = (p.edges(level_p, a), q.edges(level_q, b));
        let lean = lean(&p.levels[level_p][a], &q.levels[level_q][b]);
        if lean.is_none() && level_p.max(level_q) > 0 {
            // The longer run is halved.
            let down = if level_p >= level_q { [level_p - 1, level_q] } else { [level_p, level_q - 1] };
            for child in 0..2 {
                let at = if level_p >= level_q { [2 * a + child, b] } else { [a, 2 * b + child] };
                if at[0] < p.levels[down[0]].len() && at[1] < q.levels[down[1]].len() {
                    stack.push((down, at));
                }
            }
            continue;
        }
        // Only the row that matters to the staircase is written: the others follow below.
        if lean != Some(Ordering::Less) {
            first[rows.end - 1] = first[rows.end - 1].min(columns.start);
        }
        if lean != Some(Ordering::Greater) {
            last[rows.start] = last[rows.start].max(columns.end);
        }
        if lean.is_none() {
            if open_leaves == 0 {
                return Ok(whole);
            }
            open_leaves -= 1;
        }
    }
    for row in (1..m - 1).rev() {
        first[row - 1] = first[row - 1].min(first[row]);
    }
    for row in 1..m - 1 {
        last[row] = last[row].max(last[row - 1]);
    }
    // A row of bridges is entered by the P-step above it and left by the one below.
    let mut region = whole;
    for row in 0..m - 1 {
        region.first[row + 1] = first[row] as u32;
        region.last[row] = last[row] as u32;
    }
    pulse.leave_out((m * n) as u64 - region.cells());
    Ok(region)
}

/// Whether every bridge between two runs leans forward (`Greater`) or back (`Less`), if that is certain.
fn lean(p: &Run, q: &Run) -> Option<Ordering> {
    let (direction, spread) = (p.directions.centre + q.directions.centre, p.directions.half + q.directions.half);
    let (bridge, reach) = (q.points.centre - p.points.centre, p.points.half + q.points.half);
    let middle = direction.dot(bridge);
    let doubt = direction.abs().dot(reach) + spread.dot(bridge.abs() + reach) + ROUNDING;
    if middle > doubt {
        Some(Ordering::Greater)
    } else if middle < -doubt {
        Some(Ordering::Less)
    } else {
        None
    }
}

/// A box: centre and half extents.
#[derive(Clone, Copy, Debug)]
struct Extent {
    centre: DVec3,
    half: DVec3,
}

impl Extent {
    fn of(points: impl Iterator<Item = DVec3>) -> Self {
        let (low, high) =
            points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)));
        Self { centre: 0.5 * (low + high), half: 0.5 * (high - low) }
    }
    fn with(self, other: Self) -> Self {
        let corners = [self.centre - self.half, self.centre + self.half];
        Self::of(corners.into_iter().chain([other.centre - other.half, other.centre + other.half]))
    }
}

/// Neighbouring bank edges: their points, and the directions (unit) from each to the next.
#[derive(Clone, Copy, Debug)]
struct Run {
    points: Extent,
    directions: Extent,
}

/// The runs of a directrix: level 0 has [`LEAF`] edges each, every level above twice as many.
struct Tree {
    levels: Vec<Vec<Run>>,
    edges: usize,
}

impl Tree {
    /// None if an edge has no direction.
    fn new(points: &[DVec3]) -> Option<Self> {
        let edges = points.len() - 1;
        let directions: Vec<DVec3> =
            points.windows(2).map(|pair| (pair[1] - pair[0]).try_normalize()).collect::<Option<_>>()?;
        let leaves = (0..edges).step_by(LEAF).map(|start| {
            let end = (start + LEAF).min(edges);
            Run {
                points: Extent::of(points[start..=end].iter().copied()),
                directions: Extent::of(directions[start..end].iter().copied()),
            }
        });
        let mut levels = vec![leaves.collect::<Vec<_>>()];
        while let [.., finest] = levels.as_slice()
            && finest.len() > 1
        {
            let join = |pair: &[Run]| match *pair {
                [a, b] => Run { points: a.points.with(b.points), directions: a.directions.with(b.directions) },
                _ => pair[0],
            };
            let joined = finest.chunks(2).map(join).collect();
            levels.push(joined);
        }
        Some(Self { levels, edges })
    }
    fn top(&self) -> usize {
        self.levels.len() - 1
    }
    fn leaves(&self) -> usize {
        self.levels[0].len()
    }
    fn edges(&self, level: usize, run: usize) -> std::ops::Range<usize> {
        let length = LEAF << level;
        run * length..((run + 1) * length).min(self.edges)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Execution;
    use crate::ruled_surface::Objective;

    /// SplitMix64, from -1 to 1.
    struct Random(u64);
    impl Random {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = self.0;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            (z ^ (z >> 31)) as f64 / u64::MAX as f64 * 2.0 - 1.0
        }
        fn vector(&mut self) -> DVec3 {
            DVec3::new(self.next(), self.next(), self.next())
        }
    }

    fn area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
        0.5 * (b - a).cross(c - a).length()
    }

    #[test]
    fn a_square_whose_bridges_all_lean_forward_is_cheaper_by_p_first() {
        let mut random = Random(1);
        let mut seen = [0; 2];
        for _ in 0..200_000 {
            let [p, q] = [random.vector(), random.vector()];
            let [after, next] = [p + random.vector() * 0.7, q + random.vector() * 0.7];
            let direction = (after - p).normalize() + (next - q).normalize();
            let leans = [(p, q), (after, q), (p, next), (after, next)].map(|(a, b)| direction.dot(b - a));
            let gain = area(p, after, q) + area(after, q, next) - area(p, q, next) - area(p, after, next);
            if leans.iter().all(|&lean| lean > 0.0) {
                assert!(gain <= 1e-12, "{gain} {p} {after} {q} {next}");
                seen[0] += 1;
            }
            if leans.iter().all(|&lean| lean < 0.0) {
                assert!(gain >= -1e-12, "{gain} {p} {after} {q} {next}");
                seen[1] += 1;
            }
        }
        assert!(seen[0] > 20_000 && seen[1] > 20_000, "{seen:?}");
    }

    /// The least area by a plain table over the whole grid.
    fn least_area(p: &[DVec3], q: &[DVec3]) -> f64 {
        let mut row = vec![f64::INFINITY; q.len()];
        for i in 0..p.len() {
            for j in 0..q.len() {
                let above = if i > 0 { row[j] + area(p[i - 1], p[i], q[j]) } else { f64::INFINITY };
                let left = if j > 0 { row[j - 1] + area(p[i], q[j - 1], q[j]) } else { f64::INFINITY };
                row[j] = if i + j == 0 { 0.0 } else { above.min(left) };
            }
        }
        row[q.len() - 1]
    }

    /// A polyline of `count` points: waves of the given height, steps of unequal length, and `jagged` noise.
    fn directrix(random: &mut Random, count: usize, offset: DVec3, height: f64, jagged: f64) -> Vec<DVec3> {
        let waves: Vec<(DVec3, f64)> =
            (1..6).map(|k| (random.vector() * height / f64::from(k), random.next() * 3.0)).collect();
        let mut u = 0.0;
        (0..count)
            .map(|_| {
                u += (1.2 + random.next()) / count as f64;
                let wave: DVec3 =
                    waves.iter().enumerate().map(|(k, &(w, phase))| w * ((k + 1) as f64 * 3.0 * u + phase).sin()).sum();
                offset + DVec3::new(6.0 * u, 0.0, 0.0) + wave + random.vector() * jagged
            })
            .collect()
    }

    #[test]
    fn nothing_is_lost_by_keeping_to_the_corridor() {
        let mut random = Random(2);
        let (mut visited, mut whole) = ([0; 2], [0; 2]);
        for case in 0..400 {
            let rough = case % 2;
            let height = [0.0, 0.3, 1.0, 3.0][case / 2 % 4];
            let jagged = [0.0, 0.02][rough];
            // Enough cells for the search to look for a corridor.
            let count = |random: &mut Random| 150 + (21.0 * random.next()) as usize;
            let (m, n) = (count(&mut random), count(&mut random));
            let p = directrix(&mut random, m, DVec3::ZERO, height, jagged);
            let q = directrix(&mut random, n, DVec3::new(0.0, 1.0, 0.5), height, jagged);
            let strip = Strip::new(p.as_slice().into(), q.as_slice().into(), false).unwrap();
            let execution = Execution::default();
            let region = corridor(&strip, &mut Pulse::new(&execution, 1)).unwrap();
            assert!(region.first.is_sorted() && region.last.is_sorted() && region.first[0] == 0);
            visited[rough] += region.cells();
            whole[rough] += (m * n) as u64;
            let path = strip.optimal_path(Objective::MinimalArea, None, 0.0, &execution).unwrap();
            let reached = strip.statistics(&path, 0.0, &execution).unwrap().0.area;
            let least = least_area(&p, &q);
            assert!((reached - least).abs() <= 1e-12 * least, "case {case}: {reached}, least {least}");
        }
        // Otherwise nothing was tried.
        assert!(3 * visited[0] < 2 * whole[0], "{visited:?} of {whole:?}");
    }

    #[test]
    fn smooth_directrices_leave_a_narrow_corridor() {
        let side = |phase: f64, y: f64| -> Vec<DVec3> {
            let point = |k: usize| {
                let u = k as f64 / 999.0;
                DVec3::new(10.0 * u, y + 0.3 * (9.0 * u + phase).sin(), 0.3 * (7.0 * u - phase).cos())
            };
            (0..1000).map(point).collect()
        };
        let (p, q) = (side(0.3, 0.0), side(1.9, 3.0));
        let strip = Strip::new(p.as_slice().into(), q.as_slice().into(), false).unwrap();
        let execution = Execution::default();
        strip.optimal_path(Objective::MinimalArea, None, 0.0, &execution).unwrap();
        assert!(execution.work() < 100_000, "{} of 1e6 cells", execution.work());
    }

    #[test]
    fn equal_neighbours_and_crossing_rails_get_the_whole_grid() {
        let p = [DVec3::ZERO, DVec3::ZERO, DVec3::X];
        let q = [DVec3::Y, DVec3::Y + DVec3::X];
        let strip = Strip::new(p.as_slice().into(), q.as_slice().into(), false).unwrap();
        let execution = Execution::default();
        let region = corridor(&strip, &mut Pulse::new(&execution, 1)).unwrap();
        assert_eq!(region.cells(), 6);
    }
}
