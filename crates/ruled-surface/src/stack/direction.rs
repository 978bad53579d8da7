//! Chooses which directrices are reversed.
//!
//! Either directrix of a pair can be reversed, which gives two different strips. They are compared by these criteria,
//! as a person would compare them:
//!
//! 1. Two closed contours belong together in the direction in which their area vectors agree.
//! 2. A direction whose strip of least area folds back loses to a direction whose strip does not. The strip of least
//!    area is used whatever the objective, because other strips fold even where the direction is right: of 500 pairs of
//!    rails that lie side by side, the strip of most convex bridges folds back on 161, and that of least area on none.
//! 3. Of open directrices, the ends that are nearer to each other belong together.
//! 4. If all of these are equal, the objective decides.

use super::options::DirectionCriterion;
use super::prepare::Prepared;
use crate::graph::cell_counter::CellCounter;
use crate::graph::convexity::ConvexityTest;
use crate::graph::lanes::LaneWidth;
use crate::graph::rails::Rails;
use crate::strip::objective::{Goal, Objective};
use crate::strip::search::solve_all;
use crate::strip::statistics::{SMALLER_FOLD, Statistics};
use plateau_mesh::DVec3;
use plateau_mesh::error::Error;
use plateau_mesh::plane::polygon::doubled_area_vector;
use std::cmp::Ordering;

/// Relative difference up to which two values count as equal. It covers the rounding of two sums of the same terms in
/// different orders, which stays below 1e-13 on reversed straight directrices and apexes.
const ROUNDING: f64 = 1e-9;
/// Relative difference above which the distances of the ends decide. Also the cosine of the angle between two area
/// vectors up to which they count as perpendicular. A person sees no smaller difference either.
const EQUAL: f64 = 0.01;
/// Area of a contour, as a fraction of its squared perimeter, below which its area vector has no direction. The lobes
/// of a figure of eight cancel up to rounding, which is 1e-9 at survey coordinates.
const NO_AREA: f64 = 1e-6;

/// Goes through the directrices in order and reverses each one that runs against the one before it.
pub(crate) fn choose_directions(
    prepared: &mut Prepared,
    goal: Goal,
    test: ConvexityTest,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<(), Error> {
    for k in 1..prepared.directrices.len() {
        let as_given = prepared.strip(k - 1);
        if as_given.has_apex() {
            continue;
        }
        prepared.directrices[k].reverse();
        let ways = [as_given, prepared.strip(k - 1)];
        let (is_reversed, criterion) = match evident_direction(&ways, lanes, counter)? {
            Some(evident) => evident,
            None => {
                let mut solve = |way: &Rails| -> Result<Statistics, Error> {
                    let way = std::slice::from_ref(way);
                    Ok(solve_all(way, goal, test, lanes, counter, &mut Vec::new())?.statistics[0])
                };
                let (as_given, reversed) = (solve(&ways[0])?, solve(&ways[1])?);
                (is_better(&reversed, &as_given, goal), DirectionCriterion::Objective)
            }
        };
        if !is_reversed {
            prepared.directrices[k].reverse();
        }
        prepared.directrices[k].direction_decided_by = Some(criterion);
    }
    Ok(())
}

/// Returns whether the second of two directions is the right one, and the criterion that decided. Returns `None` if
/// only the objective can decide.
pub(crate) fn evident_direction(
    ways: &[Rails; 2],
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<Option<(bool, DirectionCriterion)>, Error> {
    let [as_given, reversed] = ways;
    if as_given.closed
        && let Some(cosine) = cosine_of_area_vectors(as_given)
        && cosine.abs() > EQUAL
    {
        return Ok(Some((cosine < 0.0, DirectionCriterion::AreaVectors)));
    }
    let mut folds_back = |way: &Rails| -> Result<bool, Error> {
        let (way, goal) = (std::slice::from_ref(way), Goal::single(Objective::MinimalArea));
        let solved = solve_all(way, goal, ConvexityTest::Within(0.0), lanes, counter, &mut Vec::new())?;
        Ok(solved.statistics[0].folds_back())
    };
    let as_given_folds = folds_back(as_given)?;
    if as_given_folds != folds_back(reversed)? {
        return Ok(Some((as_given_folds, DirectionCriterion::Folds)));
    }
    if !as_given.closed {
        let distances = [distance_of_ends(as_given), distance_of_ends(reversed)];
        if (distances[0] - distances[1]).abs() > EQUAL * distances[0].max(distances[1]) {
            return Ok(Some((distances[1] < distances[0], DirectionCriterion::Ends)));
        }
    }
    Ok(None)
}

/// The sum of the squared distances from start to start and from end to end.
fn distance_of_ends(strip: &Rails) -> f64 {
    let first = strip.bridge([0, 0]);
    let last = strip.bridge([strip.m() - 1, strip.n() - 1]);
    first.length_squared() + last.length_squared()
}

/// Cosine of the angle between the area vectors of two contours. `None` if one of the contours has no area.
fn cosine_of_area_vectors(strip: &Rails) -> Option<f64> {
    let direction = |points: &[DVec3]| {
        let next = points.iter().skip(1).chain(points.first());
        let perimeter: f64 = points.iter().zip(next).map(|(from, to)| from.distance(*to)).sum();
        let double_area = doubled_area_vector(points);
        let size = double_area.length();
        (size > 2.0 * NO_AREA * perimeter * perimeter).then(|| double_area / size)
    };
    Some(direction(&strip.p.points)?.dot(direction(&strip.q.points)?))
}

/// Whether a strip is better than another by the objective, then by the secondary objective, then by its largest fold.
fn is_better(one: &Statistics, other: &Statistics, goal: Goal) -> bool {
    let sign = if goal.objective == Objective::MaximalConvexity { -1.0 } else { 1.0 };
    let order = |one: f64, other: f64| {
        let margin = ROUNDING * one.abs().max(other.abs());
        if one < other - margin {
            Ordering::Less
        } else if one > other + margin {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    };
    let by_value = order(sign * one.objective_value, sign * other.objective_value);
    let secondary = |strip: &Statistics| strip.secondary_value.unwrap_or(0.0);
    let by_secondary = order(secondary(one), secondary(other));
    match by_value.then(by_secondary) {
        Ordering::Less => true,
        // A straight directrix and an apex have no better direction, so they stay as given.
        Ordering::Equal => one.largest_fold < other.largest_fold - SMALLER_FOLD,
        Ordering::Greater => false,
    }
}
