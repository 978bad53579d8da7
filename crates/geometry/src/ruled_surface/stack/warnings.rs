//! What a caller should know about a result that is optimal all the same.

use crate::DVec3;
use crate::error::{Error, Warning};
use crate::ruled_surface::graph::lanes::Widest;
use crate::ruled_surface::graph::pulse::Pulse;
use crate::ruled_surface::graph::rails::{Given, Rails};
use crate::ruled_surface::strip::objective::{Goal, Objective};
use crate::ruled_surface::strip::search::{least, least_bending_within};
use crate::ruled_surface::strip::statistics::Statistics;

/// Area above that of the minimal one from which on a strip is reported.
const LARGE: f64 = 1.25;
/// Bending energy above the least one from which on a strip is reported: minimal area alone costs a factor of 10 to 20.
const BENT: f64 = 50.0;
/// Strips of up to so many cells are also searched for a path that bends so much less.
pub(crate) const BENDING_CHECKED_UP_TO: usize = 1 << 18;
/// The same on closed strips, which take a few dozen searches.
pub(crate) const CLOSED_BENDING_CHECKED_UP_TO: usize = 1 << 14;
/// Reversing must help by so much, in area, to be mentioned.
const OPPOSITE: f64 = 0.9;
/// Directrices are thinned to so many points to find out.
const THINNED: usize = 48;
/// Warnings about strip `k` of a stack, solved as `path` with these figures. `as_given`: nobody chose its directions.
pub(crate) fn of_strip(
    k: usize,
    strip: &Rails,
    path: &[[u32; 2]],
    statistics: &Statistics,
    (goal, as_given): (Goal, bool),
    lanes: Widest,
    pulse: &mut Pulse<'_, '_>,
) -> Result<Vec<Warning>, Error> {
    let mut warnings = Vec::new();
    if statistics.largest_fold > std::f64::consts::FRAC_PI_2 {
        let degrees = statistics.largest_fold.to_degrees();
        warnings.push(Warning::new(
            "folds",
            format!("strip {k}: neighbouring triangles fold back, by up to {degrees:.1}°"),
        ));
    }
    if strip.closed && repeats_a_bridge(path) {
        let detail = format!("strip {k}: the path runs all the way round one directrix at one point of the other");
        warnings.push(Warning::new("repeated_bridge", detail));
    }
    if strip.has_apex() {
        return Ok(warnings);
    }
    if as_given {
        let area = least(&thinned(strip, false), Objective::MinimalArea, lanes, pulse)?;
        let reversed = least(&thinned(strip, true), Objective::MinimalArea, lanes, pulse)?;
        if reversed < OPPOSITE * area {
            let (saved, next) = (100.0 * (1.0 - reversed / area), k + 1);
            let detail = format!(
                "directrices {k} and {next} run in opposite directions: reversing one makes the minimal area about {saved:.0}% smaller"
            );
            warnings.push(Warning::new("opposite_directions", detail));
        }
    }
    if goal.objective != Objective::MinimalArea {
        let factor = statistics.area / least(strip, Objective::MinimalArea, lanes, pulse)?;
        if factor > LARGE {
            let detail = format!("strip {k}: {factor:.2} times the area of the strip of minimal area");
            warnings.push(Warning::new("large_area", detail));
        }
    }
    let limit = if strip.closed { CLOSED_BENDING_CHECKED_UP_TO } else { BENDING_CHECKED_UP_TO };
    // A planar strip bends by rounding alone.
    let rounding = 1e-9 * statistics.bridges as f64;
    if goal.objective != Objective::MinimalBendingEnergy
        && strip.m() * strip.n() <= limit
        && statistics.bending_energy > rounding
    {
        let bound = statistics.bending_energy / BENT;
        if let Some(least) = least_bending_within(strip, bound, lanes, pulse)? {
            let detail = if least > rounding {
                let factor = statistics.bending_energy / least;
                format!("strip {k}: {factor:.0} times the bending energy of the strip that bends least")
            } else {
                format!("strip {k}: it bends, although it could be laid without bending")
            };
            warnings.push(Warning::new("strongly_bent", detail));
        }
    }
    Ok(warnings)
}

/// A strip of the same shape with at most [`THINNED`] points a side, its second directrix run through backwards if asked.
fn thinned(strip: &Rails, reversed: bool) -> Rails {
    let thin = |points: &[DVec3]| -> Vec<DVec3> {
        let count = points.len().min(THINNED);
        (0..count).map(|k| points[k * (points.len() - 1) / (count - 1)]).collect()
    };
    let (p, mut q) = (thin(&strip.p.points), thin(&strip.q.points));
    if reversed {
        q.reverse();
    }
    Rails::new(Given::from(p.as_slice()), Given::from(q.as_slice()), strip.closed)
}

fn repeats_a_bridge(path: &[[u32; 2]]) -> bool {
    let mut bridges = path.to_vec();
    bridges.sort_unstable();
    bridges.windows(2).any(|pair| pair[0] == pair[1])
}
