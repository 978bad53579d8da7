//! Which directrices are run through backwards.

use super::prepare::Prepared;
use crate::error::Error;
use crate::ruled_surface::graph::convexity::ConvexityTest;
use crate::ruled_surface::graph::lanes::Widest;
use crate::ruled_surface::graph::pulse::Pulse;
use crate::ruled_surface::strip::objective::{Goal, Objective};
use crate::ruled_surface::strip::search::solve_all;
use crate::ruled_surface::strip::statistics::Statistics;
use std::cmp::Ordering;

/// Values are equal if they differ by no more than this fraction: rounding of two sums of the same terms in another
/// order. Measured on reversed straight directrices and apexes, where it stays below 1e-13.
const ROUNDING: f64 = 1e-9;
/// A fold, in radians, must be smaller by this much to decide between two directions of equal value.
const SMALLER_FOLD: f64 = 1e-6;

/// Reverses each directrix in turn where that gives the strip before it the better optimum, or an equal one that folds
/// less. A strip's optimum depends on the directions of its two directrices relative to each other only, so going from
/// strip to strip is optimal for the stack.
pub(crate) fn choose_directions(
    prepared: &mut Prepared,
    goal: Goal,
    test: ConvexityTest,
    lanes: Widest,
    pulse: &mut Pulse<'_, '_>,
) -> Result<(), Error> {
    for k in 1..prepared.directrices.len() {
        let mut solve = |prepared: &Prepared| -> Result<Statistics, Error> {
            let strip = prepared.strip(k - 1);
            Ok(solve_all(&[strip], goal, test, lanes, pulse, &mut Vec::new())?.statistics[0])
        };
        let as_given = solve(prepared)?;
        prepared.directrices[k].reverse();
        let reversed = solve(prepared)?;
        if !is_better(&reversed, &as_given, goal) {
            prepared.directrices[k].reverse();
        }
    }
    Ok(())
}

/// Whether a strip is better than another by the objective, then by the secondary, then by its largest fold.
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
        // A directrix that is straight, or an apex, has no better direction: as given.
        Ordering::Equal => one.largest_fold < other.largest_fold - SMALLER_FOLD,
        Ordering::Greater => false,
    }
}
