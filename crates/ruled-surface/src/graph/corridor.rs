//! The corridor: a subset of the grid of bridges that contains a strip of least area. It leaves out most of the grid,
//! and the optimum over the corridor is the exact optimum over the grid.
//!
//! Take one square of the grid, bank edges u = p_{i+1} - p_i and v = q_{j+1} - q_j. Swapping "P-step, then Q-step" for
//! "Q-step, then P-step" flips the diagonal of the quadrilateral p_i p_{i+1} q_{j+1} q_j. With A the area,
//!
//!   D = A(P, Q) - A(Q, P) = -½ |u| |v| ∫∫ (1 - cos γ) sin(θ_u + θ_v) ds dt,   s, t from 0 to 1,
//!
//! where for the bridge e = (q_j + t v) - (p_i + s u) the angles θ_u and θ_v are those of u and v with e, and γ is the
//! angle between the planes (u, e) and (v, e). (The area ½ |u × e| of a P-step's triangle changes with t at the rate ½
//! (u × v)·n, where n is the triangle's unit normal. The area ½ |v × e| of a Q-step's triangle changes with s at the
//! same rate, with its own n. The double integral of the difference of the two rates is D, and spherical trigonometry
//! at e gives the integrand.) The sine has the sign of (û + v̂)·e, where û and v̂ are the unit vectors along u and v.
//! The bridge *leans forward* if this product is positive, and *back* if it is negative. The product is linear in s and
//! in t, so its signs at the square's four bridges decide. If all four lean forward, Q is ahead, and taking the P-step
//! first never costs more. If all four lean back, taking the Q-step first never costs more.
//!
//! Suppose that every square right of a staircase leans forward. If a path crosses to the right of the staircase, that
//! part of the path can be replaced by the staircase without an increase of the area. The same holds left of a
//! staircase if every square there leans back. The *corridor* lies between two such staircases. To find it, boxes
//! around runs of points and of edge directions bound the lean, and runs whose lean has no certain sign are halved. On
//! smooth directrices this takes a number of steps proportional to m + n. If the sign stays open in too many places,
//! the corridor is the whole grid.

use super::cell_counter::CellCounter;
use super::rails::Rails;
use super::sweep::Region;
use plateau_mesh::DVec3;
use plateau_mesh::axis_box::AxisBox;
use plateau_mesh::execution::Interruption;
use std::cmp::Ordering;

/// Number of edges in the shortest runs: few enough for a narrow corridor, and enough to bound the number of boxes.
const LEAF: usize = 8;

/// Fraction of the grid without a certain sign at which the search for the corridor ends, because a sweep of the whole
/// grid then costs little more.
const HOPELESS: f64 = 0.25;

/// Absolute value of the lean above which its sign is certain, where coordinates are about 1. The rounding error of its
/// computation stays below 1e-15.
const ROUNDING: f64 = 1e-12;

/// Returns a region of an open strip's grid that contains a path of least area.
pub(crate) fn corridor(rails: &Rails, counter: &mut CellCounter<'_, '_>) -> Result<Region, Interruption> {
    let (m, n) = (rails.m(), rails.n());
    let whole = Region::full(m, 0, n - 1);
    let (Some(p), Some(q)) = (RunTree::new(&rails.p.points), RunTree::new(&rails.q.points)) else { return Ok(whole) };
    // For each row of squares the first square that may lean forward, and one more than the last square that may lean
    // back. The P-step that crosses the row is taken between the two.
    let (mut first, mut last) = (vec![n - 1; m - 1], vec![0; m - 1]);
    let mut open_leaves = (HOPELESS * (p.leaves() * q.leaves()) as f64) as usize;
    let mut stack = vec![([p.top(), q.top()], [0, 0])];
    while let Some(([level_p, level_q], [a, b])) = stack.pop() {
        counter.add(1)?;
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
        // Only the row that bounds the staircase is written. The loops below derive the other rows.
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
    // A path enters a row of bridges by the P-step above the row and leaves it by the P-step below the row.
    let mut region = whole;
    for row in 0..m - 1 {
        region.first[row + 1] = first[row] as u32;
        region.last[row] = last[row] as u32;
    }
    debug_assert!(region.first.is_sorted() && region.last.is_sorted() && region.first[0] == 0);
    counter.leave_out((m * n) as u64 - region.cells());
    Ok(region)
}

/// Whether every bridge between two runs leans forward (`Greater`) or back (`Less`), if that is certain.
fn lean(p: &EdgeRun, q: &EdgeRun) -> Option<Ordering> {
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
        let AxisBox { low, high } = AxisBox::around(points);
        Self { centre: 0.5 * (low + high), half: 0.5 * (high - low) }
    }
    fn with(self, other: Self) -> Self {
        let corners = [self.centre - self.half, self.centre + self.half];
        Self::of(corners.into_iter().chain([other.centre - other.half, other.centre + other.half]))
    }
}

/// A run of neighbouring bank edges: a box around its points, and a box around the unit directions of its edges.
#[derive(Clone, Copy, Debug)]
struct EdgeRun {
    points: Extent,
    directions: Extent,
}

/// The runs of a directrix: each run has [`LEAF`] edges on level 0 and twice as many on every further level.
struct RunTree {
    levels: Vec<Vec<EdgeRun>>,
    edges: usize,
}

impl RunTree {
    /// `None` if an edge is too short to have a direction.
    fn new(points: &[DVec3]) -> Option<Self> {
        let edges = points.len() - 1;
        let directions: Vec<DVec3> =
            points.windows(2).map(|pair| (pair[1] - pair[0]).try_normalize()).collect::<Option<_>>()?;
        let leaves = (0..edges).step_by(LEAF).map(|start| {
            let end = (start + LEAF).min(edges);
            EdgeRun {
                points: Extent::of(points[start..=end].iter().copied()),
                directions: Extent::of(directions[start..end].iter().copied()),
            }
        });
        let mut levels = vec![leaves.collect::<Vec<_>>()];
        // Ends because each level has half as many runs as the one before, rounded up.
        while let [.., finest] = levels.as_slice()
            && finest.len() > 1
        {
            let join = |pair: &[EdgeRun]| match *pair {
                [a, b] => EdgeRun { points: a.points.with(b.points), directions: a.directions.with(b.directions) },
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
    use plateau_mesh::Execution;

    #[test]
    fn equal_neighbours_and_crossing_rails_get_the_whole_grid() {
        let p = [DVec3::ZERO, DVec3::ZERO, DVec3::X];
        let q = [DVec3::Y, DVec3::Y + DVec3::X];
        let strip = Rails::new(p.as_slice().into(), q.as_slice().into(), false);
        let execution = Execution::default();
        let region = corridor(&strip, &mut CellCounter::new(&execution, 1)).unwrap();
        assert_eq!(region.cells(), 6);
    }
}
