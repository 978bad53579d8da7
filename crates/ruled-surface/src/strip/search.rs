//! Chooses the graph, the kernel and its width for an objective, and finds the optimal path of a strip.

use super::objective::{Goal, Objective, Secondary, Weights};
use super::statistics::{Angle, Evaluation, Statistics, evaluate};
use crate::graph::cell_counter::CellCounter;
use crate::graph::closed::{self, FoundPath, KernelSearch, PathSearch};
use crate::graph::convexity::{self, ConvexityTest};
use crate::graph::corridor::corridor;
use crate::graph::lanes::{LaneWidth, Lanes, with_lanes};
use crate::graph::layers::{
    Area, ConcaveBridges, CoupledCost, DualLayer, Factors, NormalVariation, PlainCost, QuadrupleLayer, SingleLayer,
    Twist,
};
use crate::graph::rails::Rails;
use crate::graph::strip_arrays::StripArrays;
use crate::graph::sweep::{Region, cost_within};
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::{Error, Warning};
use plateau_mesh::execution::Interruption;
use std::marker::PhantomData;

/// An objective with everything else that a search on one strip needs.
#[derive(Clone, Copy)]
pub(crate) struct SearchGoal<'a> {
    goal: Goal,
    /// The factors of a weighted sum; `None` for other objectives.
    factors: Option<&'a Factors>,
    /// Winding for the normal variation, 1 or -1.
    sign: f64,
    test: ConvexityTest,
}

impl SearchGoal<'_> {
    /// Makes a goal without factors, for the winding of the strip's own triangles.
    fn plainly(goal: Goal, test: ConvexityTest) -> Self {
        Self { goal, factors: None, sign: 1.0, test }
    }
}

/// A path on every strip of a stack, and its figures.
#[derive(Clone, Debug)]
pub(crate) struct SolvedStrips {
    pub(crate) paths: Vec<Vec<[u32; 2]>>,
    pub(crate) statistics: Vec<Statistics>,
    /// The bridges of each strip that are not locally convex, by their number along its path, with their folds.
    pub(crate) concave: Vec<Vec<(u32, Angle)>>,
    /// Whether the faces agree with the given normals only if every triangle is reversed.
    pub(crate) flipped: bool,
}

/// Solves every strip. If the value depends on the winding, the whole stack gets the winding with the smaller total.
pub(crate) fn solve_all(
    strips: &[Rails],
    goal: Goal,
    test: ConvexityTest,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
    warnings: &mut Vec<Warning>,
) -> Result<SolvedStrips, Error> {
    let mut factors = Vec::new();
    if let Objective::Weighted(weights) = goal.objective {
        for strip in strips {
            factors.push(normalised(strip, weights, test, lanes, counter, warnings)?);
        }
    }
    let signs: &[f64] = if goal.winding_matters() { &[1.0, -1.0] } else { &[1.0] };
    let mut best: Option<(f64, SolvedStrips)> = None;
    for &sign in signs {
        let mut paths = Vec::with_capacity(strips.len());
        let mut evaluations = Vec::with_capacity(strips.len());
        for (k, strip) in strips.iter().enumerate() {
            let asked = SearchGoal { goal, factors: factors.get(k), sign, test };
            let path = optimal_path(strip, asked, lanes, counter)?;
            evaluations.push(evaluate(strip, &path, test, lanes, counter.execution())?);
            paths.push(path);
        }
        // If the objective does not depend on the winding, the winding that agrees with the normals is taken.
        let flipped = if goal.winding_matters() { sign < 0.0 } else { prefers_flipping(&evaluations) };
        let statistics: Vec<Statistics> = evaluations
            .iter()
            .enumerate()
            .map(|(k, evaluation)| figures(evaluation, goal, factors.get(k), flipped, strips[k].unit))
            .collect();
        let total: f64 = statistics.iter().map(|strip| strip.objective_value).sum();
        if best.as_ref().is_none_or(|(least, _)| total < *least) {
            let concave = evaluations.into_iter().map(|evaluation| evaluation.concave).collect();
            best = Some((total, SolvedStrips { paths, statistics, concave, flipped }));
        }
    }
    let (_, solved) = best.expect("there is at least one winding");
    Ok(solved)
}

/// The optimal path of a strip on its own.
pub(crate) fn path_of(
    strip: &Rails,
    goal: Goal,
    test: ConvexityTest,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<Vec<[u32; 2]>, Error> {
    if matches!(goal.objective, Objective::Weighted(_)) || goal.winding_matters() {
        let mut solved = solve_all(std::slice::from_ref(strip), goal, test, lanes, counter, &mut Vec::new())?;
        return Ok(solved.paths.swap_remove(0));
    }
    Ok(optimal_path(strip, SearchGoal::plainly(goal, test), lanes, counter)?)
}

fn prefers_flipping(evaluations: &[Evaluation]) -> bool {
    let total = |side: usize| evaluations.iter().filter_map(|e| e.normal_variation).map(|both| both[side]).sum::<f64>();
    total(1) < total(0)
}

/// The reported figures of a strip.
fn figures(evaluation: &Evaluation, goal: Goal, factors: Option<&Factors>, flipped: bool, unit: f64) -> Statistics {
    let mut s = evaluation.statistics;
    s.normal_variation = evaluation.normal_variation.map(|both| both[usize::from(flipped)]);
    let variation = s.normal_variation.unwrap_or(0.0);
    s.objective_value = match goal.objective {
        Objective::MinimalArea => s.area,
        Objective::MinimalTwist => s.total_normal_twist,
        Objective::MaximalConvexity => s.convex_bridges as f64,
        Objective::MinimalBendingEnergy => s.bending_energy,
        Objective::MinimalMeanCurvatureVariation => s.mean_curvature_variation,
        Objective::MinimalNormalVariation => variation,
        Objective::Weighted(_) => factors.map_or(0.0, |f| {
            f.double_area * 2.0 * s.area / (unit * unit)
                + f.twist * s.total_normal_twist
                + f.bending * s.bending_energy
                + f.curvature * s.mean_curvature_variation / unit
                + f.normal_variation * variation
        }),
    };
    s.secondary_value = goal.secondary.map(|secondary| match secondary {
        Secondary::BendingEnergy => evaluation.concave_bending,
        Secondary::MeanCurvatureVariation => evaluation.concave_curvature,
    });
    s
}

/// Optimum per bridge, in coordinates scaled to the strip, up to which a term of a weighted sum is not divided by its
/// optimum. Dividing by a smaller optimum would amplify rounding errors.
const VANISHING: f64 = 1e-12;

/// Returns the factors of a weighted sum on one strip, in the strip's own unit. If the weights are to be normalised,
/// each is divided by the optimum of its term.
fn normalised(
    strip: &Rails,
    weights: Weights,
    test: ConvexityTest,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
    warnings: &mut Vec<Warning>,
) -> Result<Factors, Error> {
    let mut factors = weights.terms().map(|(_, weight)| weight);
    for (factor, (objective, weight)) in factors.iter_mut().zip(weights.terms()) {
        let scale = match objective {
            Objective::MinimalArea => strip.unit * strip.unit,
            Objective::MinimalMeanCurvatureVariation => strip.unit,
            _ => 1.0,
        };
        *factor *= scale;
        if weight == 0.0 || !weights.normalise {
            continue;
        }
        let own = solve_all(std::slice::from_ref(strip), Goal::single(objective), test, lanes, counter, warnings)?;
        let optimum = own.statistics[0].objective_value / scale;
        if optimum > VANISHING * own.statistics[0].bridges as f64 {
            *factor = weight / optimum;
        } else {
            let name = objective.name();
            warnings.push(Warning::new(
                WarningCode::NotNormalised,
                format!("{name} can be brought to zero on a strip, so its term is not divided by its optimum there"),
            ));
        }
    }
    let [area, twist, bending, curvature, normal_variation] = factors;
    Ok(Factors { double_area: 0.5 * area, twist, bending, curvature, normal_variation, sign: 1.0 })
}

/// Returns the optimal path of one strip, bridges in order. On closed strips the indices lie below m and n.
pub(crate) fn optimal_path(
    strip: &Rails,
    asked: SearchGoal<'_>,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<Vec<[u32; 2]>, Interruption> {
    let (m, n) = (strip.m() as u32, strip.n() as u32);
    if strip.has_apex() {
        // A strip with an apex has only one triangulation.
        return Ok(if m == 1 { (0..n).map(|j| [0, j]).collect() } else { (0..m).map(|i| [i, 0]).collect() });
    }
    let is_exchanged = is_better_exchanged(strip, asked.goal);
    let path = if is_exchanged {
        let asked = SearchGoal { sign: -asked.sign, ..asked };
        found(&strip.exchanged(), asked, lanes, counter)?.path.into_iter().map(|[j, i]| [i, j]).collect()
    } else {
        found(strip, asked, lanes, counter)?.path
    };
    if !strip.closed {
        return Ok(path);
    }
    let mut path: Vec<[u32; 2]> = path.into_iter().map(|[i, j]| [i % m, j % n]).collect();
    if is_exchanged {
        // A closed path starts at the bridge to which the step from p_{m-1} to p_0 leads.
        let count = path.len();
        let start = (0..count).find(|&k| path[k][0] == 0 && path[(k + count - 1) % count][0] == m - 1);
        path.rotate_left(start.unwrap_or(0));
    }
    Ok(path)
}

/// Ratio of the number of points of Q to that of P above which the two directrices are exchanged for the search.
const FAR_MORE: usize = 8;

/// Whether a closed strip is searched with its directrices exchanged. Divide and conquer takes a search for each point
/// of Q, and each search follows a path of m + n bridges, so the directrix with few points is best taken as Q. Only
/// graphs of one layer are searched in this way.
fn is_better_exchanged(strip: &Rails, goal: Goal) -> bool {
    let has_one_layer =
        matches!(goal.objective, Objective::MinimalArea | Objective::MinimalTwist | Objective::MinimalNormalVariation);
    strip.closed && has_one_layer && strip.n() > FAR_MORE * strip.m()
}

/// Returns the least area (in squared units of the caller) or the least bending energy of a strip without an apex. The
/// path and its other figures are not computed.
pub(crate) fn least(
    strip: &Rails,
    objective: Objective,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<f64, Interruption> {
    let cost = found(strip, SearchGoal::plainly(Goal::single(objective), ConvexityTest::Within(0.0)), lanes, counter)?
        .score
        .value;
    Ok(if objective == Objective::MinimalArea { 0.5 * cost * strip.unit * strip.unit } else { cost })
}

/// Returns the least bending energy of a strip without an apex, if it is at most `bound`.
pub(crate) fn least_bending_within(
    strip: &Rails,
    bound: f64,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<Option<f64>, Interruption> {
    if strip.closed {
        return Ok(Some(least(strip, Objective::MinimalBendingEnergy, lanes, counter)?).filter(|&least| least <= bound));
    }
    with_lanes!(lanes, V, simd => bending_within::<V>(simd, strip, bound, counter))
}

fn bending_within<V: Lanes>(
    simd: V::Simd,
    strip: &Rails,
    bound: f64,
    counter: &mut CellCounter<'_, '_>,
) -> Result<Option<f64>, Interruption> {
    let arrays = &StripArrays::new(strip, false);
    let kernel = DualLayer { simd, arrays, concave: None, cost: PhantomData::<PlainCost<V>> };
    cost_within::<V, _>(&kernel, (arrays.rows, arrays.columns), bound, counter)
}

fn found(
    strip: &Rails,
    asked: SearchGoal<'_>,
    lanes: LaneWidth,
    counter: &mut CellCounter<'_, '_>,
) -> Result<FoundPath, Interruption> {
    with_lanes!(lanes, V, simd => search::<V>(simd, strip, asked, counter))
}

/// Number of grid cells up to which the whole grid is swept without a corridor, because the sweep takes less time than
/// finding a corridor.
const SMALL: usize = 16384;

fn search<V: Lanes>(
    simd: V::Simd,
    strip: &Rails,
    SearchGoal { goal, factors, sign, test }: SearchGoal<'_>,
    counter: &mut CellCounter<'_, '_>,
) -> Result<FoundPath, Interruption> {
    let arrays = &StripArrays::new(strip, goal.needs_tangents());
    let (rows, columns) = (arrays.rows, arrays.columns);
    let table = match goal.objective {
        Objective::MaximalConvexity => Some(convexity::concave_bridges::<V>(strip, (arrays, simd), test, counter)?),
        _ => None,
    };
    let concave = table.as_ref().map(|table| ConcaveBridges {
        table,
        is_coupled: goal.secondary.is_some(),
        rounding: strip.rounding,
    });
    // An open strip of least area does not need the whole grid.
    let region = match goal.objective {
        Objective::MinimalArea if !strip.closed && rows * columns > SMALL => corridor(strip, counter)?,
        _ => Region::full(rows, 0, columns - 1),
    };
    macro_rules! run {
        ($kernel:expr) => {
            find(strip.closed, &mut KernelSearch::<V, _>::new($kernel, rows, columns), &region, counter)
        };
    }
    match (goal.objective, goal.secondary) {
        (Objective::MaximalConvexity, None | Some(Secondary::BendingEnergy)) => {
            run!(DualLayer { simd, arrays, concave, cost: PhantomData::<CoupledCost<V>> })
        }
        (Objective::MaximalConvexity, Some(Secondary::MeanCurvatureVariation)) => {
            run!(QuadrupleLayer { simd, arrays, concave, factors: None, cost: PhantomData::<CoupledCost<V>> })
        }
        (Objective::MinimalArea, _) => run!(SingleLayer(Area { simd, arrays })),
        (Objective::MinimalTwist, _) => run!(SingleLayer(Twist { simd, arrays })),
        (Objective::MinimalNormalVariation, _) => run!(SingleLayer(NormalVariation { simd, arrays, sign })),
        (Objective::MinimalBendingEnergy, _) => {
            run!(DualLayer { simd, arrays, concave: None, cost: PhantomData::<PlainCost<V>> })
        }
        (Objective::MinimalMeanCurvatureVariation, _) => {
            run!(QuadrupleLayer { simd, arrays, concave: None, factors: None, cost: PhantomData::<PlainCost<V>> })
        }
        (Objective::Weighted(_), _) => {
            let factors = factors.map(|factors| Factors { sign, ..*factors });
            run!(QuadrupleLayer { simd, arrays, concave: None, factors, cost: PhantomData::<PlainCost<V>> })
        }
    }
}

fn find(
    is_closed: bool,
    search: &mut dyn PathSearch,
    region: &Region,
    counter: &mut CellCounter<'_, '_>,
) -> Result<FoundPath, Interruption> {
    if is_closed { closed::closed(search, counter) } else { closed::open(search, region, counter) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::{DVec3, Execution};

    fn strip(m: usize, n: usize, wave: f64) -> Rails {
        let rail = |count: usize, y: f64, phase: f64| -> Vec<DVec3> {
            let point = |k: usize| {
                let u = k as f64 / (count - 1) as f64;
                DVec3::new(8.0 * u, y + wave * libm::sin(9.0 * u + phase), wave * libm::cos(7.0 * u - phase))
            };
            (0..count).map(point).collect()
        };
        let (p, q) = (rail(m, 0.0, 0.0), rail(n, 3.0, 1.0));
        Rails::new(p.as_slice().into(), q.as_slice().into(), false)
    }

    #[test]
    fn a_bounded_search_finds_the_optimum_exactly_if_it_is_within_the_bound() {
        let execution = Execution::default();
        for (m, n) in [(2, 2), (2, 9), (3, 7), (5, 4), (8, 8), (66, 41), (41, 66), (131, 203), (400, 90)] {
            for wave in [0.0, 0.3, 1.0, 2.0] {
                let strip = strip(m, n, wave);
                for lanes in LaneWidth::all() {
                    let mut counter = CellCounter::new(&execution, 1);
                    let least = least(&strip, Objective::MinimalBendingEnergy, lanes, &mut counter).unwrap();
                    for factor in [0.0, 0.5, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 2.0, 1e3, f64::INFINITY] {
                        let bound = if factor.is_finite() { factor * least } else { factor };
                        let found = least_bending_within(&strip, bound, lanes, &mut counter).unwrap();
                        assert_eq!(found, (least <= bound).then_some(least), "{m} x {n}, {wave}, {factor} times");
                    }
                }
            }
        }
    }

    #[test]
    fn a_bounded_search_leaves_most_of_the_grid_alone() {
        let strip = strip(1000, 1000, 1.0);
        let execution = Execution::default();
        let mut counter = CellCounter::new(&execution, 1);
        let least = least(&strip, Objective::MinimalBendingEnergy, LaneWidth::get(), &mut counter).unwrap();
        for (factor, share) in [(0.2, 0.1), (0.5, 0.25), (1.0, 0.7)] {
            let before = execution.work();
            least_bending_within(&strip, factor * least, LaneWidth::get(), &mut counter).unwrap();
            counter.last_look().unwrap();
            let cells = (execution.work() - before) as f64;
            assert!(cells < share * 1e6, "{factor}: {cells} of 1e6");
        }
    }

    #[test]
    fn a_closed_strip_with_few_points_on_p_is_searched_from_there_and_has_the_same_optimum() {
        let ring = |count: usize, radius: f64, height: f64| -> Vec<DVec3> {
            let point = |k: usize| {
                let angle = std::f64::consts::TAU * k as f64 / count as f64 + 0.3 * height;
                let wave = radius * (1.0 + 0.1 * libm::sin(5.0 * angle));
                DVec3::new(wave * libm::cos(angle), wave * libm::sin(angle), height + 0.1 * libm::cos(3.0 * angle))
            };
            (0..count).map(point).collect()
        };
        let execution = Execution::default();
        let mut counter = CellCounter::new(&execution, 1);
        let test = ConvexityTest::Within(1e-8);
        for (m, n) in [(2, 17), (3, 25), (3, 400), (7, 100)] {
            let strip = Rails::new(ring(m, 0.5, 0.0)[..].into(), ring(n, 1.0, 1.0)[..].into(), true);
            for objective in [Objective::MinimalArea, Objective::MinimalTwist] {
                let asked = SearchGoal::plainly(Goal::single(objective), test);
                assert!(is_better_exchanged(&strip, asked.goal));
                let path = optimal_path(&strip, asked, LaneWidth::get(), &mut counter).unwrap();
                assert!(path[0][0] == 0 && path[path.len() - 1][0] == m as u32 - 1 && path.len() == m + n);
                let plain = found(&strip, asked, LaneWidth::get(), &mut counter).unwrap().path;
                let plain: Vec<[u32; 2]> = plain.into_iter().map(|[i, j]| [i % m as u32, j % n as u32]).collect();
                let value = |path: &[[u32; 2]]| {
                    let evaluation = evaluate(&strip, path, test, LaneWidth::get(), &execution).unwrap();
                    figures(&evaluation, asked.goal, None, false, 1.0).objective_value
                };
                let (one, other) = (value(&path), value(&plain));
                assert!((one - other).abs() <= 1e-12 * other.abs(), "{objective:?} {m} x {n}: {one} and {other}");
            }
        }
        let strip = Rails::new(ring(3, 0.5, 0.0)[..].into(), ring(3000, 1.0, 1.0)[..].into(), true);
        counter.last_look().unwrap();
        let before = execution.work();
        let asked = SearchGoal::plainly(Goal::single(Objective::MinimalTwist), test);
        optimal_path(&strip, asked, LaneWidth::get(), &mut counter).unwrap();
        counter.last_look().unwrap();
        let cells = execution.work() - before;
        assert!(cells < 100 * 3 * 3000, "{cells}");
    }
}
