//! What a caller should know about a result that is optimal all the same.

use super::convexity::Test;
use super::lanes::Widest;
use super::objective::Objective;
use super::shortest_path::Pulse;
use super::solve_strip::{self, Goal};
use super::statistics::Statistics;
use super::strip::{Given, Strip};
use crate::DVec3;
use crate::error::{Error, Warning};

/// Area above that of the minimal one from which on a strip is reported.
const LARGE: f64 = 1.25;
/// Bending energy above the least one from which on a strip is reported: minimal area alone costs a factor of 10 to 20.
const BENT: f64 = 50.0;
/// Strips of up to so many cells are also solved for their least bending, to compare.
pub(super) const BENDING_CHECKED_UP_TO: usize = 1 << 18;
/// The same on closed strips, which take a few dozen searches.
pub(super) const CLOSED_BENDING_CHECKED_UP_TO: usize = 1 << 14;
/// Reversing must help by so much, in area, to be mentioned.
const OPPOSITE: f64 = 0.9;
/// Directrices are thinned to so many points to find out.
const THINNED: usize = 96;

/// Warnings about strip `k` of a stack, solved as `path` with these figures.
pub(super) fn of_strip(
    k: usize,
    strip: &Strip,
    path: &[[u32; 2]],
    statistics: &Statistics,
    goal: Goal,
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
    let mut least = |objective: Objective| -> Result<Statistics, Error> {
        let strips = std::slice::from_ref(strip);
        let solved =
            solve_strip::solve_all(strips, Goal::single(objective), Test::Within(0.0), lanes, pulse, &mut Vec::new())?;
        Ok(solved.statistics[0])
    };
    if goal.objective != Objective::MinimalArea {
        let factor = statistics.area / least(Objective::MinimalArea)?.area;
        if factor > LARGE {
            let detail = format!("strip {k}: {factor:.2} times the area of the strip of minimal area");
            warnings.push(Warning::new("large_area", detail));
        }
    }
    let limit = if strip.closed { CLOSED_BENDING_CHECKED_UP_TO } else { BENDING_CHECKED_UP_TO };
    if goal.objective != Objective::MinimalBendingEnergy && strip.m() * strip.n() <= limit {
        let least = least(Objective::MinimalBendingEnergy)?.bending_energy;
        // A planar strip bends by rounding alone.
        if statistics.bending_energy > BENT * least && statistics.bending_energy > 1e-9 * statistics.bridges as f64 {
            let detail = if least > 1e-9 * statistics.bridges as f64 {
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

fn repeats_a_bridge(path: &[[u32; 2]]) -> bool {
    let mut bridges = path.to_vec();
    bridges.sort_unstable();
    bridges.windows(2).any(|pair| pair[0] == pair[1])
}

/// Whether the directrices run in opposite directions, judged by the minimal area of thinned ones both ways.
pub(super) fn of_directions(
    k: usize,
    [p, q]: [&[DVec3]; 2],
    closed: bool,
    lanes: Widest,
    pulse: &mut Pulse<'_, '_>,
) -> Result<Option<Warning>, Error> {
    if p.len() < 2 || q.len() < 2 {
        return Ok(None);
    }
    let thin = |points: &[DVec3]| -> Vec<DVec3> {
        let count = points.len().min(THINNED);
        (0..count).map(|k| points[k * (points.len() - 1) / (count - 1)]).collect()
    };
    let (p, mut q) = (thin(p), thin(q));
    let mut area = |q: &[DVec3]| -> Result<f64, Error> {
        let given = |points| Given { points, tangents: None, normals: None };
        let strip = Strip::of_checked(given(&p), given(q), closed);
        let goal = Goal::single(Objective::MinimalArea);
        let solved = solve_strip::solve_all(&[strip], goal, Test::Within(0.0), lanes, pulse, &mut Vec::new())?;
        Ok(solved.statistics[0].area)
    };
    let as_given = area(&q)?;
    q.reverse();
    let reversed = area(&q)?;
    Ok((reversed < OPPOSITE * as_given).then(|| {
        let saved = 100.0 * (1.0 - reversed / as_given);
        let detail = format!(
            "directrices {k} and {} run in opposite directions: reversing one makes the minimal area about {saved:.0}% smaller",
            k + 1
        );
        Warning::new("opposite_directions", detail)
    }))
}
