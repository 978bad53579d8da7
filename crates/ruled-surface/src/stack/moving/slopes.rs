//! The value of an objective for fixed paths, and its slopes by the coordinates of all points.

use super::dual::{Dual, VARIABLES};
use super::ladder::CELLS_PER_BRIDGE;
use crate::graph::cell_counter::CellCounter;
use crate::graph::lanes::{Lanes, Vector};
use crate::graph::weight::{self, BendingLaw, BridgeTriangle};
use crate::stack::prepare::Prepared;
use crate::strip::objective::{Goal, Objective, Secondary};
use crate::strip::search::SolvedStrips;
use plateau_mesh::DVec3;
use plateau_mesh::execution::Interruption;

/// Factors of the terms of the minimised sum, for points in any unit of length.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Terms {
    area: f64,
    twist: f64,
    bending: f64,
    curvature: f64,
    variation: f64,
}

impl Terms {
    /// `radius` is the unit of length of the points, in the caller's unit. The number of convex bridges has no slopes.
    /// The secondary objective, or the bending energy, takes its place: both fall where a strip that is not convex
    /// becomes flatter.
    pub(super) fn of(goal: Goal, radius: f64) -> Self {
        let none = Self::default();
        match goal.objective {
            Objective::MinimalArea => Self { area: 1.0, ..none },
            Objective::MinimalTwist => Self { twist: 1.0, ..none },
            Objective::MinimalMeanCurvatureVariation => Self { curvature: 1.0, ..none },
            Objective::MinimalNormalVariation => Self { variation: 1.0, ..none },
            Objective::MaximalConvexity if goal.secondary == Some(Secondary::MeanCurvatureVariation) => {
                Self { curvature: 1.0, ..none }
            }
            Objective::MinimalBendingEnergy | Objective::MaximalConvexity => Self { bending: 1.0, ..none },
            Objective::Weighted(weights) => Self {
                area: weights.area * radius * radius,
                twist: weights.twist,
                bending: weights.bending_energy,
                curvature: weights.mean_curvature_variation * radius,
                variation: weights.normal_variation,
            },
        }
    }

    fn needs_tangents(&self) -> bool {
        self.twist > 0.0 || self.variation > 0.0
    }
}

/// Jump of the mean curvature vector below which the norm is smoothed, as a fraction of the mean jump. Values from 0.01
/// to 0.1 give the same sums to a few per cent on noisy cylinders; 0.1 is the better one where the sum has other terms.
const SMOOTHED: f64 = 0.1;

/// Paths of all strips, and everything else that the objective depends on but the points.
pub(super) struct FixedPaths<'a> {
    paths: &'a [Vec<[u32; 2]>],
    closed: bool,
    bending: BendingLaw,
    terms: Terms,
    /// 1, or -1 if the faces agree with the given normals only if every triangle is reversed.
    sign: f64,
    /// Number of the first point of each directrix among the points of all, and the number of all points.
    starts: Vec<usize>,
    /// Given tangents and normals of all points. Empty if there are none.
    tangents: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// Length below which a jump of the mean curvature vector is smoothed, because its norm has no slope at 0.
    smoothing: f64,
}

/// The points about a bridge: their numbers, p_{i-1}, p_i, p_{i+1}, q_{j-1}, q_j, q_{j+1}. A missing neighbour is the
/// point itself.
type About = [usize; 6];

impl<'a> FixedPaths<'a> {
    pub(super) fn new(prepared: &Prepared, solved: &'a SolvedStrips, terms: Terms) -> Self {
        let mut starts = vec![0];
        let (mut tangents, mut normals) = (Vec::new(), Vec::new());
        for directrix in &prepared.directrices {
            let given = directrix.given();
            starts.push(starts[starts.len() - 1] + given.points.len());
            tangents.extend(given.tangents.unwrap_or_default().iter().map(|tangent| tangent.normalize_or_zero()));
            normals.extend(given.normals.unwrap_or_default().iter().map(|normal| normal.normalize_or_zero()));
        }
        Self {
            paths: &solved.paths,
            closed: prepared.closed,
            bending: prepared.bending,
            terms,
            sign: if solved.flipped { -1.0 } else { 1.0 },
            starts,
            tangents,
            normals,
            smoothing: 0.0,
        }
    }

    /// Smooths the jumps of the mean curvature vector that are small in comparison with their mean, if `value` is the
    /// value now.
    pub(super) fn smooth(&mut self, value: f64) {
        if self.terms.curvature > 0.0 {
            let bridges = self.paths.iter().map(Vec::len).sum::<usize>().max(1);
            self.smoothing = SMOOTHED * value / (self.terms.curvature * bridges as f64);
        }
    }

    /// Returns the value for these points, and sets its slopes by each of them.
    pub(super) fn value(
        &self,
        points: &[DVec3],
        slopes: &mut [DVec3],
        counter: &mut CellCounter<'_, '_>,
    ) -> Result<f64, Interruption> {
        slopes.fill(DVec3::ZERO);
        let mut value = 0.0;
        for (strip, path) in self.paths.iter().enumerate() {
            let (mut before, mut first): (Option<Bent>, Option<Bent>) = (None, None);
            for (k, &bridge) in path.iter().enumerate() {
                counter.add(CELLS_PER_BRIDGE)?;
                let about = self.about(strip, bridge);
                let (sum, curvature) = self.bridge(strip, k, about, points);
                value += sum.value;
                scatter(slopes, about, &sum.slopes, 1.0);
                if self.terms.curvature > 0.0 {
                    let bent = Bent { about, curvature };
                    if let Some(before) = &before {
                        value += self.jump(before, &bent, slopes);
                    }
                    first = first.or(Some(bent));
                    before = Some(bent);
                }
            }
            if let (true, Some(last), Some(first)) = (self.closed, &before, &first) {
                value += self.jump(last, first, slopes);
            }
        }
        Ok(value)
    }

    fn about(&self, strip: usize, [i, j]: [u32; 2]) -> About {
        let of_rail = |rail: usize, index: u32| {
            let (start, count) = (self.starts[rail], self.starts[rail + 1] - self.starts[rail]);
            let index = index as usize;
            let around = self.closed && count > 1;
            let before = if index > 0 {
                index - 1
            } else if around {
                count - 1
            } else {
                index
            };
            let after = if index + 1 < count {
                index + 1
            } else if around {
                0
            } else {
                index
            };
            [start + before, start + index, start + after]
        };
        let ([a, b, c], [d, e, f]) = (of_rail(strip, i), of_rail(strip + 1, j));
        [a, b, c, d, e, f]
    }

    /// Returns the terms of bridge `k` but the curvature's, and its mean curvature vector. The triangle after a bridge
    /// belongs to it.
    fn bridge(&self, strip: usize, k: usize, about: About, points: &[DVec3]) -> (Dual, Vector<Dual>) {
        let path = &self.paths[strip];
        let (count, m) = (path.len(), self.starts[strip + 1] - self.starts[strip]);
        let n = self.starts[strip + 2] - self.starts[strip + 1];
        let by_p = |from: usize, to: usize| m > 1 && (n == 1 || path[from][0] != path[to][0]);
        // A missing neighbour has the variables of the point itself, so that its bank edge is 0 wherever the point is.
        let at = |slot: usize| {
            let slot = if about[slot] == about[slot / 3 * 3 + 1] { slot / 3 * 3 + 1 } else { slot };
            let [x, y, z] = [0, 1, 2].map(|axis| Dual::variable(points[about[slot]][axis], 3 * slot + axis));
            Vector::new(x, y, z)
        };
        let [p_before, p, p_after, q_before, q, q_after] = [0, 1, 2, 3, 4, 5].map(at);
        let bridge = q.minus(p);
        let squared = bridge.dot(bridge);
        let (has_left, has_right) = (self.closed || k > 0, self.closed || k + 1 < count);
        let triangle = |bank: Vector<Dual>| BridgeTriangle::new(bank, bank.dot(bank), bridge, squared);
        let left = triangle(if by_p((k + count - 1) % count, k) { p.minus(p_before) } else { q.minus(q_before) });
        let right = triangle(if by_p(k, (k + 1) % count) { p_after.minus(p) } else { q_after.minus(q) });
        let mut sum = Dual::constant(0.0);
        let factor = Dual::constant;
        if self.terms.area > 0.0 && has_right {
            sum = sum + right.length * factor(0.5 * self.terms.area);
        }
        let is_inside = has_left && has_right;
        if self.terms.bending > 0.0 && is_inside {
            sum = sum + weight::bending(self.bending, squared, &left, &right) * factor(self.terms.bending);
        }
        if self.terms.needs_tangents() {
            let tangents = [(p_before, p, p_after, about[1]), (q_before, q, q_after, about[4])]
                .map(|(before, at, after, number)| self.tangent(at.minus(before), after.minus(at), number));
            if self.terms.twist > 0.0 {
                sum = sum + weight::twist(bridge, tangents[0], tangents[1]) * factor(self.terms.twist);
            }
            if self.terms.variation > 0.0 {
                let normals = [about[1], about[4]].map(|number| constant(self.sign * self.normals[number]));
                sum = sum + weight::normal_variation(bridge, tangents, normals) * factor(self.terms.variation);
            }
        }
        let curvature = if self.terms.curvature > 0.0 && is_inside {
            weight::mean_curvature(
                (weight::curvature_part(bridge, &left), left.sound),
                (weight::curvature_part(bridge, &right), right.sound),
            )
        } else {
            Vector::zero(())
        };
        (sum, curvature)
    }

    /// Returns the tangent at a point: the given one, or the one fitted by eq. 13 and 14.
    fn tangent(&self, before: Vector<Dual>, after: Vector<Dual>, number: usize) -> Vector<Dual> {
        if let Some(&given) = self.tangents.get(number) {
            return constant(given);
        }
        let (a, b) = (before.dot(before).sqrt(), after.dot(after).sqrt());
        let (from, to) =
            if a.value > 0.0 && b.value > 0.0 { (before.times(b / a), after.times(a / b)) } else { (before, after) };
        let sum = Vector::new(from.x + to.x, from.y + to.y, from.z + to.z);
        let length = sum.dot(sum).sqrt();
        if length.value > 0.0 { sum.times(Dual::constant(1.0) / length) } else { sum }
    }

    /// Adds the slopes of the jump of the mean curvature vector between two bridges, and returns the jump.
    fn jump(&self, before: &Bent, now: &Bent, slopes: &mut [DVec3]) -> f64 {
        let components = |v: &Vector<Dual>| [v.x, v.y, v.z];
        let (from, to) = (components(&before.curvature), components(&now.curvature));
        let jump = [0, 1, 2].map(|axis| from[axis].value - to[axis].value);
        let squared: f64 = jump.iter().map(|x| x * x).sum();
        let length = (squared + self.smoothing * self.smoothing).sqrt();
        if length > 0.0 {
            for axis in 0..3 {
                let slope = self.terms.curvature * jump[axis] / length;
                scatter(slopes, before.about, &from[axis].slopes, slope);
                scatter(slopes, now.about, &to[axis].slopes, -slope);
            }
        }
        self.terms.curvature * (length - self.smoothing)
    }
}

/// The mean curvature vector of a bridge.
#[derive(Clone, Copy)]
struct Bent {
    about: About,
    curvature: Vector<Dual>,
}

fn constant(v: DVec3) -> Vector<Dual> {
    Vector::new(Dual::constant(v.x), Dual::constant(v.y), Dual::constant(v.z))
}

fn scatter(slopes: &mut [DVec3], about: About, of_bridge: &[f64; VARIABLES], factor: f64) {
    for (slot, &number) in about.iter().enumerate() {
        slopes[number] += factor * DVec3::from_slice(&of_bridge[3 * slot..3 * slot + 3]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::convexity::ConvexityTest;
    use crate::graph::lanes::LaneWidth;
    use crate::stack::options::Options;
    use crate::stack::prepare::prepare;
    use crate::strip::objective::Weights;
    use crate::strip::search::solve_all;
    use crate::strip::statistics::Statistics;
    use plateau_mesh::Execution;
    use plateau_mesh::random::SplitMix64;

    /// Three rails of random points and random normals.
    fn rails(random: &mut SplitMix64) -> [Vec<Vec<DVec3>>; 2] {
        let mut vector = |size: f64| {
            DVec3::new(random.between(-size, size), random.between(-size, size), random.between(-size, size))
        };
        let mut rail = |count: usize, y: f64| -> Vec<DVec3> {
            (0..count).map(|k| DVec3::new(k as f64 / count as f64, y, 0.0) + vector(0.1)).collect()
        };
        let rails = vec![rail(6, 0.0), rail(4, 1.0), rail(5, 2.0)];
        let normals = rails.iter().map(|rail| rail.iter().map(|_| vector(1.0) + 2.0 * DVec3::Z).collect()).collect();
        [rails, normals]
    }

    #[test]
    fn values_are_those_of_the_statistics_and_slopes_are_difference_quotients() {
        let mut random = SplitMix64::new(7);
        let weights = Weights {
            area: 0.7,
            twist: 0.2,
            bending_energy: 0.4,
            mean_curvature_variation: 0.3,
            normal_variation: 0.1,
            normalise: false,
        };
        let named = Objective::NAMED.into_iter().filter(|&objective| objective != Objective::MaximalConvexity);
        for objective in named.chain([Objective::Weighted(weights)]) {
            for (closed, bending, with_tangents) in [
                (false, BendingLaw::Monotone, false),
                (true, BendingLaw::Paper, false),
                (false, BendingLaw::Paper, true),
            ] {
                let [directrices, normals] = rails(&mut random);
                let tangents = with_tangents
                    .then(|| normals.iter().map(|of| of.iter().map(|n| n.cross(DVec3::Y)).collect()).collect());
                let options =
                    Options { objective, closed, bending, tangents, normals: Some(normals), ..Options::default() };
                let execution = Execution::default();
                let prepared = prepare(&directrices, &options, None, &execution).unwrap();
                let mut counter = CellCounter::new(&execution, 1);
                let goal = Goal::single(objective);
                let solved = solve_all(
                    &prepared.strips(),
                    goal,
                    ConvexityTest::Within(1e-8),
                    LaneWidth::Plain,
                    &mut counter,
                    &mut Vec::new(),
                )
                .unwrap();
                let unit = 2.5;
                let mut paths = FixedPaths::new(&prepared, &solved, Terms::of(goal, unit));
                let points: Vec<DVec3> = directrices.iter().flatten().map(|&point| point / unit).collect();
                let mut slopes = vec![DVec3::ZERO; points.len()];
                let value = paths.value(&points, &mut slopes, &mut counter).unwrap();
                let stated = Statistics::total(&solved.statistics).objective_value;
                let scale = match objective {
                    Objective::MinimalArea => unit * unit,
                    Objective::MinimalMeanCurvatureVariation => unit,
                    _ => 1.0,
                };
                assert!(
                    (scale * value - stated).abs() <= 1e-12 * stated,
                    "{objective:?} {closed}: {value} and {stated}"
                );
                // A jump of nearly 0 has slopes that change within the steps of the difference quotient.
                paths.smooth(value);
                paths.value(&points, &mut slopes, &mut counter).unwrap();
                let mut unused = slopes.clone();
                for k in 0..points.len() {
                    for axis in 0..3 {
                        let mut at = |step: f64| {
                            let mut moved = points.clone();
                            moved[k][axis] += step;
                            paths.value(&moved, &mut unused, &mut counter).unwrap()
                        };
                        // The difference quotient of fourth order, for steps of 1e-5 and 2e-5.
                        let quotient = (8.0 * (at(1e-5) - at(-1e-5)) - (at(2e-5) - at(-2e-5))) / 12e-5;
                        let slope = slopes[k][axis];
                        assert!(
                            (quotient - slope).abs() <= 1e-6 * (1.0 + slope.abs()),
                            "{objective:?} {closed} {k} {axis}: {slope} and {quotient}"
                        );
                    }
                }
            }
        }
    }
}
