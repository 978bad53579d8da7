//! Optimal ruled strips between polylines: the global optimum of each of Wang and Tang's objectives.
//!
//! C. C. L. Wang and K. Tang, *Optimal boundary triangulations of an interpolating ruled surface*, JCISE 5 (2005).
//!
//! # Vocabulary
//! - *Directrices*: the two polylines P and Q that bound a strip. A *bridge* (i, j) is the segment from p_i to q_j.
//! - *P-step*, *Q-step*: from a bridge to the next one, along P or along Q. Each step is a triangle with one *bank
//!   edge*, the edge of the directrix that it runs along.
//! - *Locally convex*: a bridge that lies on the convex hull of the neighbours of its end points (definition 6).
//! - *Closed* strip: both directrices are closed polygons. *Apex*: a directrix of one point.
//!
//! # How it works
//! 1. The input is checked, near neighbours are merged, and directrices are resampled if that is asked for (`stack`).
//!    Every neighbouring pair of directrices becomes a strip.
//! 2. A triangulation of a strip is a path through the grid of its bridges (section 2). Each objective is a graph with
//!    one, two or four nodes for each bridge (sections 4 and 5).
//! 3. One sweep over the graph finds the shortest path (`graph`). A strip of least area is searched for within a
//!    corridor. Closed strips are optimal over all starts too.
//! 4. The path gives the triangles, every figure of Table 1 (`strip`) and the flat pattern (`pattern`).
//!
//! # Departures from the paper
//! - Local convexity takes q_{j-1} into account, which is missing from the printed definition 6.
//! - Bending grows monotonically up to a full fold. As printed, a fold of 180° would cost nothing.
//! - Couplings are lexicographic shortest paths. They are exact where the paper rescales weights.
//! - A plain sweep replaces Dijkstra's algorithm, because the graphs are acyclic grids.
//!
//! # Example
//! ```
//! use plateau_ruled_surface::{Objective, Options, solve};
//! use plateau_mesh::{DVec3, Execution};
//!
//! // Two parallel rails, 3 apart and 10 long, with different points.
//! let rail = |count: usize, y: f64| -> Vec<DVec3> {
//!     (0..count).map(|k| DVec3::new(10.0 * k as f64 / (count - 1) as f64, y, 0.0)).collect()
//! };
//! let options = Options { objective: Objective::MinimalArea, ..Options::default() };
//! let surface = solve(&[rail(6, 0.0), rail(11, 3.0)], &options, &Execution::default())?;
//! assert_eq!(surface.mesh.triangles.len(), 15);
//! assert!((surface.statistics.area - 30.0).abs() < 1e-12);
//! let pattern = surface.flat_pattern;
//! assert!((pattern.width - 10.0).abs() < 1e-12 && !pattern.self_overlap);
//! # Ok::<(), plateau_mesh::Error>(())
//! ```

#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
#![warn(missing_docs)]

mod graph;
mod pattern;
mod stack;
mod strip;

pub use graph::rails::Given;
pub use graph::weight::BendingLaw;
pub use pattern::FlatPattern;
pub use pattern::flat_strip::FlatStrip;
pub use stack::moving::MovedRails;
pub use stack::options::{Caps, DEFAULT_CONVEXITY_TOLERANCE, Direction, DirectionCriterion, Options, RailEnds};
pub use stack::sampling::Sampling;
pub use stack::surface::{Comparison, RuledSurface};
pub use strip::Strip;
pub use strip::objective::{Objective, Secondary, Weights};
pub use strip::statistics::{ConcaveBridge, CoupledValues, Statistics};

use graph::cell_counter::CellCounter;
use graph::convexity::ConvexityTest;
use graph::corridor::corridor;
use graph::lanes::LaneWidth;
use graph::rails::Rails;
use plateau_mesh::error::Error;
use plateau_mesh::execution::{Execution, Progress};
use plateau_mesh::measure::double_area_vector;
use plateau_mesh::{DVec3, Estimate};
use stack::assemble::assemble;
use stack::direction::choose_directions;
use stack::moving::ladder::Freedom;
use stack::moving::move_rails;
use stack::prepare::prepare;
use stack::{caps, meetings, sampling, warnings};
use strip::objective::Goal;
use strip::search::{SolvedStrips, solve_all};
use strip::statistics::Angle;

/// Solves every strip of a stack for its global optimum and welds them into one mesh.
///
/// `directrices`: two or more polylines, each with two or more distinct points (three if `closed`) or with a single
/// point (an apex; two apexes may not be neighbours). An open strip has m + n - 2 triangles, a closed one m + n, or m +
/// n - 1 if it has an apex. All triangles of a surface have one orientation: a P-step gives (p_i, p_{i+1}, q_j), a
/// Q-step (p_i, q_{j+1}, q_j). If normals are given, the faces agree with them; with caps, the faces point outwards.
/// Among equal paths the predecessor by P-step is preferred, and on closed strips the smallest start.
///
/// Neighbouring points are merged (warning `merged_points`) if they are equal, or nearer than
/// [`SAME_POINT`](plateau_mesh::polyline::SAME_POINT) times the directrix's radius. Results do not depend on the
/// processor's vector width.
///
/// # Errors
/// [`Error::Input`] if the input is not as described, values are not finite or beyond 1e50, or options do not fit
/// together; [`Error::Interrupted`] if stopped, by cancel or deadline: there is no mesh before the optimum is known.
///
/// # Cost
/// O(m n) time on an open strip (see [`estimate`]), and one to four bits of memory for each bridge. On a closed strip a
/// single-layer objective takes O(m n log n) time; the other objectives take some more searches.
pub fn solve(directrices: &[Vec<DVec3>], options: &Options, execution: &Execution<'_>) -> Result<RuledSurface, Error> {
    solve_with(directrices, options, execution, LaneWidth::get())
}

fn solve_with(
    directrices: &[Vec<DVec3>],
    options: &Options,
    execution: &Execution<'_>,
    lanes: LaneWidth,
) -> Result<RuledSurface, Error> {
    let mut prepared = prepare(directrices, options, options.sampling, execution)?;
    let meetings = meetings::warnings(&prepared, execution)?;
    prepared.warnings.extend(meetings);
    let test = ConvexityTest::new(options.convexity_tolerance);
    let freedom = Freedom::new(directrices, options);
    let rungs = freedom.map_or(0, Freedom::rungs);
    let mut counter = CellCounter::new(execution, stack::estimate::estimate(&prepared.lengths(), options, rungs).cells);
    let goal = Goal { objective: options.objective, secondary: options.secondary };
    if options.direction == Direction::Auto {
        choose_directions(&mut prepared, goal, test, lanes, &mut counter)?;
    }
    let moved = match freedom {
        Some(freedom) => Some(move_rails(&mut prepared, (goal, test), freedom, lanes, &mut counter)?),
        None => None,
    };
    let strips: Vec<Rails> = prepared.strips();
    let (solved, rails) = match moved {
        Some((solved, rails)) => (solved, Some(rails)),
        None => (solve_all(&strips, goal, test, lanes, &mut counter, &mut prepared.warnings)?, None),
    };
    let SolvedStrips { paths, statistics: strip_statistics, concave, flipped } = solved;
    counter.phase("statistics");
    let mut comparison = None;
    if options.all_objectives {
        let mut rows = Vec::new();
        for other in Goal::all(strips.iter().all(Rails::has_normals)) {
            let statistics = if other == goal {
                strip_statistics.clone()
            } else {
                solve_all(&strips, other, test, lanes, &mut counter, &mut Vec::new())?.statistics
            };
            rows.push(Comparison {
                objective: other.objective,
                secondary: other.secondary,
                statistics: Statistics::total(&statistics),
            });
        }
        comparison = Some(rows);
    }
    let mut surface = assemble(&prepared, &strips, &paths, options, execution)?;
    if options.caps == Caps::Flat {
        caps::close(&mut surface.mesh, &surface.directrices, execution)?;
    } else if flipped {
        for triangle in &mut surface.mesh.triangles {
            triangle.swap(1, 2);
        }
    }
    counter.phase("checks");
    for (k, strip) in strips.iter().enumerate() {
        let asked = (goal, options.direction == Direction::AsGiven);
        let found = warnings::of_strip(k, strip, &paths[k], &strip_statistics[k], asked, lanes, &mut counter)?;
        prepared.warnings.extend(found);
    }
    surface.statistics = Statistics::total(&strip_statistics);
    let cap = &surface.mesh.triangles[surface.statistics.triangles..];
    surface.statistics.triangles += cap.len();
    surface.statistics.area +=
        cap.iter().map(|&triangle| 0.5 * double_area_vector(surface.mesh.corners(triangle)).length()).sum::<f64>();
    surface.concave_bridges = concave_bridges(&strip_statistics, &concave);
    surface.strips = strip_statistics;
    surface.comparison = comparison;
    surface.rails = rails;
    surface.warnings = prepared.warnings;
    execution.report(Progress {
        fraction: 1.0,
        phase: "done",
        iteration: surface.bridges.len() as u64,
        objective_value: Some(surface.statistics.objective_value),
        residual: None,
    });
    Ok(surface)
}

/// Numbers the bridges that are not convex over all strips.
fn concave_bridges(strips: &[Statistics], concave: &[Vec<(u32, Angle)>]) -> Vec<ConcaveBridge> {
    let mut all = Vec::with_capacity(concave.iter().map(Vec::len).sum());
    let mut first = 0;
    for (strip, concave) in strips.iter().zip(concave) {
        all.extend(concave.iter().map(|&(k, fold)| ConcaveBridge { bridge: first + k, fold: fold.radians() }));
        first += strip.bridges as u32;
    }
    all
}

/// Checks the arguments of [`solve`] without resampling or solving. The time is linear in the number of points.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with.
pub fn check(directrices: &[Vec<DVec3>], options: &Options) -> Result<(), Error> {
    prepare(directrices, options, None, &Execution::default()).map(drop)
}

/// Estimates the cost of [`solve`] for directrices with these numbers of points, to which `options.sampling` is
/// applied. O(directrices).
///
/// The number of triangles leaves out caps. The number of cells assumes that every search on an open strip visits the
/// whole grid; searches that leave out cells need fewer (see [`estimate_for`]). A closed strip may need fewer or
/// somewhat more. The memory is an upper bound.
#[must_use]
pub fn estimate(points: &[usize], options: &Options) -> Estimate {
    let sampled: Vec<usize> = points.iter().map(|&count| sampling::count(count, options.sampling)).collect();
    // The coordinates, which decide the number of rungs, are not known here.
    let rungs = if options.rail_tolerance.is_some() { Freedom::most_rungs() } else { 0 };
    stack::estimate::estimate(&sampled, options, rungs)
}

/// Estimates the cost of [`solve`] for these directrices. An open strip of least area is searched for within a corridor,
/// which often has a thousandth of the grid's cells. Such a strip counts the memory of its corridor. If the direction is
/// to be chosen, the larger of two corridors counts. With given directions the strip also counts only the cells of the
/// corridor. Other strips count as in [`estimate`].
///
/// Finding a corridor takes about as long as the search itself: at most 0.3 s for 50,000 points on either side.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with; [`Error::Interrupted`].
pub fn estimate_for(
    directrices: &[Vec<DVec3>],
    options: &Options,
    execution: &Execution<'_>,
) -> Result<Estimate, Error> {
    let mut prepared = prepare(directrices, options, options.sampling, execution)?;
    let lengths = prepared.lengths();
    let rungs = Freedom::new(directrices, options).map_or(0, Freedom::rungs);
    let mut estimate = stack::estimate::estimate(&lengths, options, rungs);
    let is_area = options.objective == Objective::MinimalArea && options.rail_tolerance.is_none();
    if !is_area || options.closed || options.all_objectives {
        return Ok(estimate);
    }
    let is_given = options.direction == Direction::AsGiven;
    let mut counter = CellCounter::new(execution, estimate.cells);
    let mut of_searches = 0;
    for k in 1..prepared.directrices.len() {
        // A strip whose direction is to be chosen is measured in both directions. The second reversal restores the
        // directrix.
        for _ in 0..if is_given { 1 } else { 2 } {
            let strip = prepared.strip(k - 1);
            let (m, n) = (strip.m(), strip.n());
            let cells = if strip.has_apex() { 0 } else { corridor(&strip, &mut counter)?.cells() };
            if is_given && !strip.has_apex() {
                estimate.cells -= (m * n) as u64 - cells;
            }
            of_searches = of_searches.max(stack::estimate::bytes_within_corridor(cells, m, n));
            if !is_given {
                prepared.directrices[k].reverse();
            }
        }
    }
    estimate.bytes = estimate.bytes.min(of_searches + stack::estimate::bytes_of_points(&lengths));
    Ok(estimate)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rail(count: usize, phase: f64, z: f64, closed: bool) -> Vec<DVec3> {
        let point = |k: usize| {
            let u = k as f64 / count as f64;
            let a = std::f64::consts::TAU * u;
            let r = 2.0 + 0.4 * libm::sin(3.0 * a + phase);
            if closed {
                DVec3::new(r * libm::cos(a), r * libm::sin(a), z + 0.2 * libm::sin(a))
            } else {
                DVec3::new(9.0 * u, r, z * libm::cos(a + phase))
            }
        };
        (0..count).map(point).collect()
    }

    /// On processors without wide instructions only the plain path exists, and the test compares nothing.
    #[test]
    fn the_wide_and_the_plain_path_give_the_same_bits() {
        for closed in [false, true] {
            for (m, n) in [(3, 3), (4, 7), (17, 5), (66, 41), (131, 203)] {
                let rails = [rail(m, 0.3, 0.0, closed), rail(n, 1.4, 1.0, closed), rail(m + 1, 2.0, 2.0, closed)];
                let normals: Vec<Vec<DVec3>> =
                    rails.iter().map(|r| r.iter().map(|p| (*p + DVec3::Z).normalize()).collect()).collect();
                let weights = Weights {
                    area: 1.0,
                    twist: 0.3,
                    bending_energy: 0.2,
                    mean_curvature_variation: 0.1,
                    normal_variation: 0.1,
                    normalise: true,
                };
                for objective in Objective::NAMED.into_iter().chain([Objective::Weighted(weights)]) {
                    let couplings: &[Option<Secondary>] = match objective {
                        Objective::MaximalConvexity => {
                            &[None, Some(Secondary::BendingEnergy), Some(Secondary::MeanCurvatureVariation)]
                        }
                        _ => &[None],
                    };
                    for &secondary in couplings {
                        for bending in [BendingLaw::Monotone, BendingLaw::Paper] {
                            let normals = Some(normals.clone());
                            let options =
                                Options { closed, objective, secondary, bending, normals, ..Options::default() };
                            let solve = |lanes| solve_with(&rails, &options, &Execution::default(), lanes).unwrap();
                            let plain = solve(LaneWidth::Plain);
                            for wide in LaneWidth::all().split_off(1) {
                                assert_eq!(plain, solve(wide), "{objective:?} {m} {n} {wide:?} {bending:?}");
                            }
                        }
                    }
                }
            }
        }
    }
}

/// Compiles and runs the example of the README with the other doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
