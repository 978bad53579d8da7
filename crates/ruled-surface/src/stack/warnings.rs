//! Warnings about a result. The result is the optimum even if there are warnings.

use super::direction::evident_direction;
use super::options::DirectionCriterion;
use crate::graph::cell_counter::CellCounter;
use crate::graph::lanes::LaneWidth;
use crate::graph::rails::{Rail, Rails};
use crate::strip::objective::{Goal, Objective};
use crate::strip::search::{least, least_bending_within};
use crate::strip::statistics::{SMALLER_FOLD, Statistics};
use plateau_mesh::DVec3;
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::{Error, Warning};
use plateau_mesh::measure::{double_area_vector, is_degenerate};
use std::f64::consts::{FRAC_PI_2, PI};

/// Area above which a strip is reported, as a multiple of the least area.
const LARGE: f64 = 1.25;
/// Bending energy above which a strip is reported, as a multiple of the least bending energy. On Wang and Tang's
/// examples the strip of least area already has 10 to 20 times the least bending energy.
const BENT: f64 = 50.0;
/// Largest number of grid cells of an open strip whose least bending energy is computed for a comparison.
pub(crate) const BENDING_CHECKED_UP_TO: usize = 1 << 18;
/// Largest number of grid cells of a closed strip whose least bending energy is computed for a comparison. It is
/// smaller than for open strips, because a closed strip takes a few dozen searches.
pub(crate) const CLOSED_BENDING_CHECKED_UP_TO: usize = 1 << 14;
/// A fold counts as the strip's own if it exceeds the angle of both directrices at the ends of its bridge by more than
/// this, in radians. A bridge that leans towards the bisector of a corner sees the corner as sharper: from 160°, a lean
/// of 45° makes 166°.
const SHARPER: f64 = 10.0 * (PI / 180.0);
/// Number of triangles without area up to which a strip is not reported. An open strip whose directrices share both
/// ends has two.
const EMPTY_AT_ENDS: usize = 2;
/// Largest number of points of a directrix when two directions are compared. Longer directrices are thinned to it,
/// because the time of the comparison grows with its square.
const THINNED: usize = 48;
/// Returns the warnings about strip `k` of a stack. `path` and `statistics` are its solution. `as_given` is true if no
/// criterion has decided the directions of its directrices.
pub(crate) fn of_strip(
    k: usize,
    strip: &Rails,
    path: &[[u32; 2]],
    statistics: &Statistics,
    (goal, as_given): (Goal, bool),
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<Vec<Warning>, Error> {
    let mut warnings = Vec::new();
    let triangles = strip.triangles_along(path);
    if statistics.folds_back()
        && let Some(fold) = largest_fold_back(strip, path, &triangles)
    {
        let degrees = fold.to_degrees();
        let undecided = if fold > PI - SMALLER_FOLD {
            "; a fold of 180° lays one triangle upon the other, so that it is neither a mountain nor a valley"
        } else {
            ""
        };
        let detail = format!("strip {k}: neighbouring triangles fold back, by up to {degrees:.1}°{undecided}");
        warnings
            .push(Warning::new(WarningCode::Folds, detail).with_count("strip", k).with("largest_fold_deg", degrees));
    }
    let empty = triangles.iter().filter(|&&triangle| is_degenerate(strip.corners(triangle))).count();
    if empty > EMPTY_AT_ENDS || empty == triangles.len() {
        let of = if empty == triangles.len() { "all".to_owned() } else { format!("{empty} of") };
        let detail = format!(
            "strip {k}: {of} {} triangles have no area: directrices {k} and {} coincide there or run along one line",
            triangles.len(),
            k + 1
        );
        warnings
            .push(Warning::new(WarningCode::EmptyTriangles, detail).with_count("strip", k).with_count("count", empty));
    }
    if strip.closed && repeats_a_bridge(path) {
        let detail = format!("strip {k}: the path runs all the way round one directrix at one point of the other");
        warnings.push(Warning::new(WarningCode::RepeatedBridge, detail).with_count("strip", k));
    }
    if strip.has_apex() {
        return Ok(warnings);
    }
    if as_given && let Some((true, criterion)) = evident_direction(&thinned_ways(strip), lanes, counter)? {
        let reason = match criterion {
            DirectionCriterion::AreaVectors => "they run round in opposite senses",
            DirectionCriterion::Folds => "the strip folds back, and does not if one of them is reversed",
            DirectionCriterion::Ends | DirectionCriterion::Objective => {
                "if one of them is reversed, their ends are nearer to each other"
            }
        };
        let detail = format!("directrices {k} and {} run in opposite directions: {reason}", k + 1);
        warnings.push(Warning::new(WarningCode::OppositeDirections, detail).with_count("directrix", k));
    }
    if goal.objective != Objective::MinimalArea {
        let factor = statistics.area / least(strip, Objective::MinimalArea, lanes, counter)?;
        if factor > LARGE {
            let detail = format!("strip {k}: {factor:.2} times the area of the strip of minimal area");
            warnings.push(Warning::new(WarningCode::LargeArea, detail).with_count("strip", k).with("factor", factor));
        }
    }
    let limit = if strip.closed { CLOSED_BENDING_CHECKED_UP_TO } else { BENDING_CHECKED_UP_TO };
    // Bending energy up to which a strip counts as planar: a planar strip has rounding errors only.
    let rounding = 1e-9 * statistics.bridges as f64;
    if goal.objective != Objective::MinimalBendingEnergy
        && strip.m() * strip.n() <= limit
        && statistics.bending_energy > rounding
    {
        let bound = statistics.bending_energy / BENT;
        if let Some(least) = least_bending_within(strip, bound, lanes, counter)? {
            let warning = if least > rounding {
                let factor = statistics.bending_energy / least;
                let detail = format!("strip {k}: {factor:.0} times the bending energy of the strip that bends least");
                Warning::new(WarningCode::StronglyBent, detail).with("factor", factor)
            } else {
                Warning::new(
                    WarningCode::StronglyBent,
                    format!("strip {k}: it bends, although it could be laid without bending"),
                )
            };
            warnings.push(warning.with_count("strip", k));
        }
    }
    Ok(warnings)
}

/// Returns the largest fold of more than 90° that is sharper than the directrices themselves at the bridge's ends. A
/// profile's own sharp edge, such as the trailing edge of an aerofoil, is no fault of the strip. A fold of 180° counts in
/// any case, because the two triangles are in the same place.
fn largest_fold_back(strip: &Rails, path: &[[u32; 2]], triangles: &[[u32; 3]]) -> Option<f64> {
    let normal = |t: usize| {
        let corners = strip.corners(triangles[t]);
        (!is_degenerate(corners)).then(|| double_area_vector(corners))
    };
    let turn = |rail: &Rail, index: u32| {
        let [before, after] = [0, 1].map(|step| rail.bank(index as usize, step, strip.closed));
        angle(before, after)
    };
    let fold = |k: usize| {
        let left = if k > 0 { k - 1 } else { triangles.len().checked_sub(1).filter(|_| strip.closed)? };
        let fold = angle(normal(left)?, normal(Some(k).filter(|&k| k < triangles.len())?)?);
        let [i, j] = path[k];
        let own = turn(&strip.p, i).max(turn(&strip.q, j));
        let is_whole = fold > PI - SMALLER_FOLD;
        (is_whole || fold > FRAC_PI_2 + SMALLER_FOLD && fold > own + SHARPER).then_some(fold)
    };
    (0..path.len()).filter_map(fold).reduce(f64::max)
}

/// Returns the angle between two vectors, or 0 if one of them is zero.
fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

/// Returns the strip as it is, and with Q reversed. Both are thinned to at most [`THINNED`] points on each side.
fn thinned_ways(strip: &Rails) -> [Rails; 2] {
    let thin = |points: &[DVec3]| -> Vec<DVec3> {
        let count = points.len().min(THINNED);
        (0..count).map(|k| points[k * (points.len() - 1) / (count - 1)]).collect()
    };
    let (p, q) = (thin(&strip.p.points), thin(&strip.q.points));
    let back: Vec<DVec3> = q.iter().rev().copied().collect();
    [q, back].map(|q| Rails::new(p.as_slice().into(), q.as_slice().into(), strip.closed))
}

fn repeats_a_bridge(path: &[[u32; 2]]) -> bool {
    let mut bridges = path.to_vec();
    bridges.sort_unstable();
    bridges.windows(2).any(|pair| pair[0] == pair[1])
}
