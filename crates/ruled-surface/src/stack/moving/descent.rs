//! The spectral projected gradient method (Birgin, Martínez, Raydan 2000) over points in balls.

use super::slopes::FixedPaths;
use crate::graph::cell_counter::CellCounter;
use plateau_mesh::DVec3;
use plateau_mesh::execution::Interruption;

/// Balls about the places of all points. The unit of length is the radius of all points.
pub(super) struct Balls<'a> {
    pub(super) places: &'a [DVec3],
    /// Whether each point stays in its place.
    pub(super) is_fixed: &'a [bool],
    pub(super) radius: f64,
}

/// Maximum number of steps. Each radius starts from the points of the radius before, which are near.
const STEPS: usize = 12;
/// A step may exceed the least of this many last values, so that long steps are not cut short.
const REMEMBERED: usize = 5;
/// Least decrease of a step, relative to the one that the slopes promise (Armijo).
const SUFFICIENT: f64 = 1e-4;
/// Maximum number of times that a step is halved.
const HALVINGS: usize = 8;
/// The descent ends where the slopes promise a decrease of less than this part of the value.
const CONVERGED: f64 = 1e-7;
/// Length of the first step, as a part of the radius of the balls.
const FIRST: f64 = 0.2;

impl Balls<'_> {
    fn project(&self, k: usize, point: DVec3) -> DVec3 {
        let place = self.places[k];
        if self.is_fixed[k] {
            return place;
        }
        let offset = point - place;
        let length = offset.length();
        if length > self.radius { place + offset * (self.radius / length) } else { point }
    }
}

/// Returns the best points that the method finds from these.
pub(super) fn descend(
    paths: &mut FixedPaths<'_>,
    balls: &Balls<'_>,
    from: &[DVec3],
    counter: &mut CellCounter<'_, '_>,
) -> Result<Vec<DVec3>, Interruption> {
    let mut points = from.to_vec();
    let mut slopes = vec![DVec3::ZERO; points.len()];
    let value = paths.value(&points, &mut slopes, counter)?;
    paths.smooth(value);
    let mut value = paths.value(&points, &mut slopes, counter)?;
    let mut best = (value, points.clone());
    let mut last = vec![value];
    let steepest = slopes.iter().map(|slope| slope.length()).fold(0.0, f64::max);
    if !(steepest > 0.0 && steepest.is_finite()) {
        return Ok(points);
    }
    let mut length = FIRST * balls.radius / steepest;
    let mut next_slopes = slopes.clone();
    for _ in 0..STEPS {
        let step: Vec<DVec3> =
            (0..points.len()).map(|k| balls.project(k, points[k] - length * slopes[k]) - points[k]).collect();
        let promised = dot(&step, &slopes);
        // A promise that is no number ends the descent too.
        if promised.is_nan() || promised >= -CONVERGED * value.abs() {
            break;
        }
        let limit = last.iter().rev().take(REMEMBERED).copied().fold(f64::NEG_INFINITY, f64::max);
        let mut share = 1.0;
        let mut accepted = None;
        for _ in 0..HALVINGS {
            let next: Vec<DVec3> = points.iter().zip(&step).map(|(point, step)| *point + share * *step).collect();
            let found = paths.value(&next, &mut next_slopes, counter)?;
            if found <= limit + SUFFICIENT * share * promised {
                accepted = Some((next, found));
                break;
            }
            share *= 0.5;
        }
        let Some((next, found)) = accepted else { break };
        let moved: Vec<DVec3> = next.iter().zip(&points).map(|(to, from)| *to - *from).collect();
        let turned: Vec<DVec3> = next_slopes.iter().zip(&slopes).map(|(to, from)| *to - *from).collect();
        let curvature = dot(&moved, &turned);
        length = if curvature > 0.0 { dot(&moved, &moved) / curvature } else { 4.0 * length };
        std::mem::swap(&mut slopes, &mut next_slopes);
        (points, value) = (next, found);
        last.push(value);
        if value < best.0 {
            best = (value, points.clone());
        }
    }
    Ok(best.1)
}

fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}
