//! The cost of a solve, estimated before the work.

use super::moving::ladder::CELLS_PER_POINT;
use super::options::{Direction, Options};
use super::warnings::{BENDING_CHECKED_UP_TO, CLOSED_BENDING_CHECKED_UP_TO};
use crate::strip::objective::{Goal, Objective};
use plateau_mesh::Estimate;

/// Memory that each point takes in addition to the search, in bytes: its bridges, triangles and statistics. Together
/// with [`BYTES_PER_LINE`] it is 600 to 850 bytes; strips of 3,000 to 30,000 points a side took 100 to 550.
const BYTES_PER_POINT: u64 = 250;
/// Largest memory that points take once more, in bytes. Up to this memory each point takes [`BYTES_PER_POINT`] twice,
/// because small strips take more for each point.
const BYTES_OF_FIRST_POINTS: u64 = 2_000_000;
/// Memory that each point takes in addition if it may move, in bytes: its positions and slopes in the descent, and the
/// best paths so far.
const BYTES_PER_MOVING_POINT: u64 = 700;
/// Memory that each row and each column of a grid takes while it is searched, in bytes.
const BYTES_PER_LINE: u64 = 400;

/// Estimates the cost of a stack of directrices with these numbers of points. The number of cells assumes that every
/// search on an open strip visits the whole grid; searches that leave out cells need fewer. A closed strip may need
/// fewer or somewhat more. Points that move do so on `rungs` rungs, with a search on each.
pub(crate) fn estimate(lengths: &[usize], options: &Options, rungs: u32) -> Estimate {
    let goal = Goal { objective: options.objective, secondary: options.secondary };
    let mut goals = vec![goal];
    if let Objective::Weighted(weights) = options.objective
        && weights.normalise
    {
        goals.extend(weights.terms().iter().filter(|(_, weight)| *weight > 0.0).map(|&(o, _)| Goal::single(o)));
    }
    let mut total = Estimate::default();
    for pair in lengths.windows(2) {
        let ends = if options.closed { 0 } else { 2 };
        total.triangles += (pair[0] + pair[1]).saturating_sub(ends) as f64;
        total.cells += u64::from(rungs) * CELLS_PER_POINT * (pair[0] + pair[1]) as u64;
        if pair[0].min(pair[1]) < 2 {
            continue;
        }
        let (m, n) = (pair[0] as u64, pair[1] as u64);
        let directions = if options.direction == Direction::Auto { 3 } else { 1 };
        let (mut cells, mut bytes) = (0u64, 0u64);
        let mut add = |goal: &Goal, times: u64| {
            let (layers, windings) = (goal.layers(), goal.windings());
            let convexity = if goal.objective == Objective::MaximalConvexity { m * n } else { 0 };
            let searches = match (options.closed, layers) {
                (false, _) => 1,
                (true, 1) => u64::from(n.ilog2()) + 2,
                (true, _) => 2 * (u64::from(n.ilog2()) + 2),
            };
            let columns = if options.closed { 2 * n } else { n };
            cells += times * (windings * searches * m * n + convexity);
            let grid = (m + 4) * (columns + 64);
            let of_convexity = if convexity > 0 { grid / 8 } else { 0 };
            bytes = bytes.max(grid * layers / 8 + of_convexity + BYTES_PER_LINE * (m + columns));
        };
        for goal in &goals {
            add(goal, directions + u64::from(rungs));
        }
        // The strips of least area are solved too, because the directions and the warnings need them.
        if goal.objective != Objective::MinimalArea {
            add(&Goal::single(Objective::MinimalArea), directions);
        }
        let limit = if options.closed { CLOSED_BENDING_CHECKED_UP_TO } else { BENDING_CHECKED_UP_TO };
        if m * n <= limit as u64 {
            add(&Goal::single(Objective::MinimalBendingEnergy), 1);
        }
        if options.all_objectives {
            Goal::all(options.normals.is_some()).for_each(|goal| add(&goal, 1));
        }
        total.cells += cells;
        total.bytes = total.bytes.max(bytes);
    }
    total.bytes += bytes_of_points(lengths);
    if options.rail_tolerance.is_some() {
        total.bytes += BYTES_PER_MOVING_POINT * lengths.iter().sum::<usize>() as u64;
    }
    if options.all_objectives {
        // The strips of all objectives are in memory at the same time, in addition to the largest grid.
        total.bytes += total.bytes / 4;
    }
    total
}

/// Memory of the result of directrices with these numbers of points, in bytes.
pub(crate) fn bytes_of_points(lengths: &[usize]) -> u64 {
    let points = BYTES_PER_POINT * lengths.iter().sum::<usize>() as u64;
    points + points.min(BYTES_OF_FIRST_POINTS)
}

/// Memory of the searches on an open strip of `m` and `n` points for the strip of least area, in bytes. The search keeps
/// to a corridor with `cells` cells. A small strip is also searched for the strip of least bending energy.
pub(crate) fn bytes_within_corridor(cells: u64, m: usize, n: usize) -> u64 {
    let bending = if m * n <= BENDING_CHECKED_UP_TO { 2 * (m * n) as u64 } else { 0 };
    cells.max(bending) / 8 + BYTES_PER_LINE * (m + n) as u64
}
