//! Rails that move within a tolerance for the optimum: the extension that Wang and Tang name in section 7.
//!
//! The path of a strip is optimal for its points (sections 4 and 5). Here the points move too, each within a ball about
//! its own place. Paths and points are improved in turn: the global search finds the paths for the points, and the
//! spectral projected gradient method (Birgin, Martínez, Raydan, *SIAM J. Optim.* 10, 2000) moves the points for the
//! paths. The result is a local optimum, because the descent finds the best near its start; no search over all
//! positions of the points is known.
//!
//! The radius of the balls grows along a ladder, which depends on the given points alone. Each rung starts from the
//! best points of the rungs below and keeps them unless it finds better ones. The tolerance decides only at which rung
//! the sequence ends. A larger tolerance therefore never gives a worse value, and none gives a worse value than the
//! points as given. The price is that points move by at most the radius of the highest rung within the tolerance.

mod descent;
mod dual;
pub(crate) mod ladder;
mod slopes;

use crate::graph::cell_counter::CellCounter;
use crate::graph::convexity::ConvexityTest;
use crate::graph::lanes::LaneWidth;
use crate::stack::prepare::Prepared;
use crate::strip::objective::{Goal, Objective};
use crate::strip::search::{SolvedStrips, solve_all};
use crate::strip::statistics::Statistics;
use descent::Balls;
use ladder::Freedom;
use plateau_mesh::DVec3;
use plateau_mesh::error::Error;
use slopes::{FixedPaths, Terms};

/// How far the points of the directrices moved, and what that brought.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MovedRails {
    /// Largest distance of a point from its own place.
    pub moved_max: f64,
    /// Vertex of the mesh that moved by `moved_max`, the lowest number among equals.
    pub moved_max_vertex: u32,
    /// Value of the objective for the points in their own places.
    pub before: f64,
    /// Improvement of the objective: `before` less the value now, or the number of further convex bridges.
    pub gain: f64,
}

/// Moves the points of the directrices. Returns their best paths.
pub(crate) fn move_rails(
    prepared: &mut Prepared,
    (goal, test): (Goal, ConvexityTest),
    freedom: Freedom,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<(SolvedStrips, MovedRails), Error> {
    counter.phase("rails");
    let given: Vec<Vec<DVec3>> = prepared.directrices.iter().map(|directrix| directrix.points.clone()).collect();
    let solve = |prepared: &Prepared, counter: &mut CellCounter<'_, '_>| {
        solve_all(&prepared.strips(), goal, test, lanes, counter, &mut Vec::new())
    };
    // The descent has coordinates about 1, as the search has.
    let (unit, origin) = (freedom.ladder.unit, given[0][0]);
    let places: Vec<DVec3> = given.iter().flatten().map(|&point| (point - origin) / unit).collect();
    let ends = given.iter().flat_map(|rail| (0..rail.len()).map(|k| k == 0 || k + 1 == rail.len()));
    let is_fixed: Vec<bool> = ends.map(|is_end| is_end && freedom.has_fixed_ends).collect();
    let mut best = solve(prepared, counter)?;
    let before = Statistics::total(&best.statistics).objective_value;
    let (mut points, mut limit) = (places.clone(), 0.0);
    for rung in 0..freedom.rungs() {
        let radius = freedom.ladder.radius(rung);
        let balls = Balls { places: &places, is_fixed: &is_fixed, radius: radius / unit };
        let mut paths = FixedPaths::new(prepared, &best, Terms::of(goal, unit));
        let moved = descent::descend(&mut paths, &balls, &points, counter)?;
        set(prepared, &given, |k| (moved[k] - places[k]) * unit, radius);
        let found = solve(prepared, counter)?;
        if is_better(&found, &best, goal) {
            (best, points, limit) = (found, moved, radius);
        }
    }
    set(prepared, &given, |k| (points[k] - places[k]) * unit, limit);
    let now = Statistics::total(&best.statistics).objective_value;
    let sign = if goal.objective == Objective::MaximalConvexity { -1.0 } else { 1.0 };
    let (moved_max, moved_max_vertex) = largest_move(prepared, &given);
    Ok((best, MovedRails { moved_max, moved_max_vertex, before, gain: sign * (before - now) }))
}

/// Returns the largest distance of a point from its own place, and the vertex with it.
fn largest_move(prepared: &Prepared, given: &[Vec<DVec3>]) -> (f64, u32) {
    let moves = prepared.directrices.iter().zip(given).flat_map(|(directrix, given)| {
        let distance = |k: usize| directrix.points[k].distance(given[k]);
        (0..given.len()).map(move |k| (distance(k), directrix.vertex(k)))
    });
    moves.fold((0.0, 0), |most, one| if one.0 > most.0 || one.0 == most.0 && one.1 < most.1 { one } else { most })
}

/// Moves the points from their given places by these offsets, which are shortened if rounding would make one longer
/// than `limit`.
fn set(prepared: &mut Prepared, given: &[Vec<DVec3>], offset: impl Fn(usize) -> DVec3, limit: f64) {
    let mut number = 0;
    for (directrix, given) in prepared.directrices.iter_mut().zip(given) {
        for (point, &place) in directrix.points.iter_mut().zip(given) {
            let offset = offset(number);
            let shorter = [1.0, 1.0 - 1e-9, 1.0 - 1e-3, 0.0].map(|share| place + share * offset);
            *point = shorter.into_iter().find(|at| at.distance(place) <= limit).unwrap_or(place);
            number += 1;
        }
    }
}

/// Whether strips are strictly better than others. Among equal numbers of convex bridges the secondary objective
/// decides, or the bending energy.
fn is_better(one: &SolvedStrips, other: &SolvedStrips, goal: Goal) -> bool {
    let [one, other] = [one, other].map(|solved| Statistics::total(&solved.statistics));
    if goal.objective != Objective::MaximalConvexity {
        return one.objective_value < other.objective_value;
    }
    let secondary = |s: &Statistics| s.secondary_value.unwrap_or(s.bending_energy);
    one.convex_bridges > other.convex_bridges
        || one.convex_bridges == other.convex_bridges && secondary(&one) < secondary(&other)
}
