//! Which directrices are run through backwards.

use super::prepare::Prepared;
use crate::error::Error;
use crate::ruled_surface::graph::convexity::Test;
use crate::ruled_surface::graph::lanes::Widest;
use crate::ruled_surface::graph::pulse::Pulse;
use crate::ruled_surface::strip::objective::{Goal, Objective};
use crate::ruled_surface::strip::search::solve_all;
use crate::ruled_surface::strip::statistics::Statistics;

/// Reverses each directrix in turn where that gives the strip before it the better optimum. A strip's optimum depends on the
/// directions of its two directrices relative to each other only, so going from strip to strip is optimal for the stack.
pub(crate) fn choose_directions(
    prepared: &mut Prepared,
    goal: Goal,
    test: Test,
    lanes: Widest,
    pulse: &mut Pulse<'_, '_>,
) -> Result<(), Error> {
    for k in 1..prepared.directrices.len() {
        let mut value = |prepared: &Prepared| -> Result<(f64, f64), Error> {
            let strip = prepared.strip(k - 1);
            let solved = solve_all(&[strip], goal, test, lanes, pulse, &mut Vec::new())?;
            let Statistics { objective_value, secondary_value, .. } = solved.statistics[0];
            let sign = if goal.objective == Objective::MaximalConvexity { -1.0 } else { 1.0 };
            Ok((sign * objective_value, secondary_value.unwrap_or(0.0)))
        };
        let as_given = value(prepared)?;
        prepared.directrices[k].reverse();
        let reversed = value(prepared)?;
        // Equal but for rounding (a straight directrix, an apex): as given.
        let margin = |value: f64| 1e-9 * value.abs();
        let better = reversed.0 < as_given.0 - margin(as_given.0)
            || (reversed.0 <= as_given.0 + margin(as_given.0) && reversed.1 < as_given.1 - margin(as_given.1));
        if !better {
            prepared.directrices[k].reverse();
        }
    }
    Ok(())
}
