//! Optimal ruled strips between polylines: the global optimum of each of Wang and Tang's objectives.
//!
//! C. C. L. Wang and K. Tang, *Optimal boundary triangulations of an interpolating ruled surface*, JCISE 5 (2005).
//!
//! 1. Directrices are cleaned (equal neighbours merged, resampled if asked) and every neighbouring pair becomes a strip.
//! 2. A triangulation of a strip is a path through the grid of its bridges (section 2); each objective is a graph of
//!    one, two or four nodes a bridge (sections 4 and 5, `layered_graph`) whose weights are in `weight`.
//! 3. One sweep finds the shortest path (`shortest_path`), within a `corridor` where least area allows one; closed strips
//!    are optimal over all starts too (`closed`).
//! 4. The path gives the triangles, every figure of Table 1 (`statistics`) and the flat pattern (`unroll`).
//!
//! Departures, and why: local convexity sees q_{j-1}, which the printed definition 6 lost; bending grows monotonically to a
//! full fold (as printed a fold-back is free); couplings are lexicographic shortest paths, exact where the paper rescales
//! weights; a plain sweep replaces Dijkstra's algorithm, since the graphs are acyclic grids.

mod caps;
mod closed;
mod convexity;
mod corridor;
mod lanes;
mod layered_graph;
mod objective;
mod overlap;
mod prepare;
mod sampling;
mod shortest_path;
mod solve_strip;
mod statistics;
mod strip;
mod unroll;
mod warnings;
mod weight;

pub use objective::{Objective, Secondary, Weights};
pub use sampling::Sampling;
pub use statistics::{CoupledValues, Statistics};
pub use strip::{Given, Strip};
pub use unroll::{FlatPattern, FlatStrip, strips_of};

use crate::error::{Error, Warning};
use crate::execution::{Execution, Progress};
use crate::{DVec3, Mesh};
use convexity::Test;
use lanes::Widest;
use shortest_path::Pulse;
use solve_strip::{Goal, Solved};

/// Default of [`Options::convexity_tolerance`]: 1e-6 degrees.
pub const DEFAULT_CONVEXITY_TOLERANCE: f64 = 1e-6 * std::f64::consts::PI / 180.0;

/// What to solve. The default: open strips of minimal area, as given.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Directrices are closed polygons; the optimum is over every starting bridge too.
    pub closed: bool,
    pub objective: Objective,
    /// With [`Objective::MaximalConvexity`] only.
    pub secondary: Option<Secondary>,
    /// How far, in radians, a direction may reach beyond the half-plane of a locally convex bridge; 0 is the exact answer.
    pub convexity_tolerance: f64,
    pub direction: Direction,
    pub caps: Caps,
    /// Surface normals along the directrices, in their shape; needed for [`Objective::MinimalNormalVariation`].
    pub normals: Option<Vec<Vec<DVec3>>>,
    /// Tangents along the directrices, in their shape; fitted if not given (eq. 13 and 14).
    pub tangents: Option<Vec<Vec<DVec3>>>,
    /// Solve for every objective and fill [`RuledSurface::comparison`].
    pub all_objectives: bool,
    pub sampling: Option<Sampling>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            closed: false,
            objective: Objective::MinimalArea,
            secondary: None,
            convexity_tolerance: DEFAULT_CONVEXITY_TOLERANCE,
            direction: Direction::AsGiven,
            caps: Caps::None,
            normals: None,
            tangents: None,
            all_objectives: false,
            sampling: None,
        }
    }
}

/// Whether a directrix may be run through backwards.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    #[default]
    AsGiven,
    /// Each directrix but the first is reversed where that gives the better optimum.
    Auto,
}

/// What closes the ends of a closed stack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Caps {
    #[default]
    None,
    /// Constrained Delaunay triangulations of the planar end contours: a closed body, oriented outwards.
    Flat,
}

/// A triangulated stack of strips.
#[derive(Clone, Debug, PartialEq)]
pub struct RuledSurface {
    /// Vertices: the directrices' points, directrix by directrix. Triangles: strip by strip along the path, then caps.
    pub mesh: Mesh,
    /// Vertex pairs, strip by strip, from the first bridge to the last.
    pub bridges: Vec<[u32; 2]>,
    /// The vertices of each directrix, in the direction in which its strips run through it.
    pub directrices: Vec<Vec<u32>>,
    /// For each input point its vertex: merged points share one, resampled ones name the nearest along the directrix.
    pub input_vertices: Vec<Vec<u32>>,
    /// Which directrices [`Direction::Auto`] reversed.
    pub reversed: Vec<bool>,
    /// Figures of the whole stack, caps not counted.
    pub statistics: Statistics,
    /// Figures of each strip.
    pub strips: Vec<Statistics>,
    /// Table 1: the figures of every objective's own optimum, if asked for.
    pub comparison: Option<Vec<Comparison>>,
    /// Open surfaces only.
    pub flat_pattern: Option<FlatPattern>,
    pub warnings: Vec<Warning>,
}

/// A row of Table 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    pub objective: Objective,
    pub secondary: Option<Secondary>,
    pub statistics: Statistics,
}

/// What a solve will take, to price it before the work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Grid cells visited, about; open strips visit exactly these, closed ones may need fewer or somewhat more.
    pub cells: u64,
    /// Working memory above input and result, at most, for the largest strip.
    pub bytes: u64,
}

/// Solves every strip of a stack for its global optimum and welds them into one mesh.
///
/// `directrices`: two or more polylines, each with two or more distinct points (three if `closed`) or a single one (an apex; no
/// two of them next to each other). Triangles: m + n - 2 for an open strip, m + n for a closed one, one fewer round
/// an apex. All triangles of a surface have one orientation: a P-step gives (p_i, p_{i+1}, q_j), a Q-step
/// (p_i, q_{j+1}, q_j); with normals given (or caps) the faces agree with them (point outwards).
/// Ties: the predecessor by P-step, on closed strips the smallest start.
///
/// Equal neighbouring points are merged (warning `merged_points`). Results do not depend on the processor's vector width.
///
/// # Errors
/// [`Error::Input`] if the input is not as described, values are not finite or beyond 1e50, or options do not fit together;
/// [`Error::Interrupted`] if stopped, by cancel or deadline: there is no mesh before the optimum is known.
///
/// # Cost
/// O(m n) time on an open strip (see [`estimate`]), one to four bits of memory a bridge; the logarithm of n more on a
/// closed one with a single-layer objective, some searches more with the others.
pub fn solve(directrices: &[Vec<DVec3>], options: &Options, execution: &Execution<'_>) -> Result<RuledSurface, Error> {
    solve_with(directrices, options, execution, Widest::get())
}

fn solve_with(
    directrices: &[Vec<DVec3>],
    options: &Options,
    execution: &Execution<'_>,
    lanes: Widest,
) -> Result<RuledSurface, Error> {
    let mut prepared = prepare::prepare(directrices, options, options.sampling, execution)?;
    let test = Test::new(options.convexity_tolerance);
    let mut pulse = Pulse::new(execution, prepare::cost(&prepared.lengths(), options).cells);
    let goal = Goal { objective: options.objective, secondary: options.secondary };
    if options.direction == Direction::Auto {
        prepare::choose_directions(&mut prepared, goal, test, lanes, &mut pulse)?;
    }
    let strips: Vec<Strip> = prepared.strips();
    let Solved { paths, statistics: strip_statistics, flipped } =
        solve_strip::solve_all(&strips, goal, test, lanes, &mut pulse, &mut prepared.warnings)?;
    pulse.phase("statistics");
    let mut comparison = None;
    if options.all_objectives {
        let mut rows = Vec::new();
        for other in Goal::all(strips.iter().all(Strip::has_normals)) {
            let statistics = if other == goal {
                strip_statistics.clone()
            } else {
                solve_strip::solve_all(&strips, other, test, lanes, &mut pulse, &mut Vec::new())?.statistics
            };
            rows.push(Comparison {
                objective: other.objective,
                secondary: other.secondary,
                statistics: Statistics::total(&statistics),
            });
        }
        comparison = Some(rows);
    }
    let mut surface = prepare::assemble(&prepared, &strips, &paths, options, execution)?;
    if options.caps == Caps::Flat {
        caps::close(&mut surface.mesh, &surface.directrices, execution)?;
    } else if flipped {
        for triangle in &mut surface.mesh.triangles {
            triangle.swap(1, 2);
        }
    }
    pulse.phase("checks");
    for (k, strip) in strips.iter().enumerate() {
        let asked = (goal, options.direction == Direction::AsGiven);
        let found = warnings::of_strip(k, strip, &paths[k], &strip_statistics[k], asked, lanes, &mut pulse)?;
        prepared.warnings.extend(found);
    }
    surface.statistics = Statistics::total(&strip_statistics);
    surface.strips = strip_statistics;
    surface.comparison = comparison;
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

/// What [`solve`] would say of its arguments before any work (sampling included): linear in the number of points.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would begin with.
pub fn check(directrices: &[Vec<DVec3>], options: &Options) -> Result<(), Error> {
    prepare::prepare(directrices, options, None, &Execution::default()).map(drop)
}

/// What [`solve`] will take for directrices of so many points; `options.sampling` is applied to them. O(directrices).
#[must_use]
pub fn estimate(points: &[usize], options: &Options) -> Cost {
    let sampled: Vec<usize> = points.iter().map(|&count| sampling::count(count, options.sampling)).collect();
    prepare::cost(&sampled, options)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rail(count: usize, phase: f64, z: f64, closed: bool) -> Vec<DVec3> {
        let point = |k: usize| {
            let u = k as f64 / count as f64;
            let a = std::f64::consts::TAU * u;
            let r = 2.0 + 0.4 * (3.0 * a + phase).sin();
            if closed {
                DVec3::new(r * a.cos(), r * a.sin(), z + 0.2 * a.sin())
            } else {
                DVec3::new(9.0 * u, r, z * (a + phase).cos())
            }
        };
        (0..count).map(point).collect()
    }

    /// On processors without wide instructions there is the plain path only and the test says nothing.
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
                        let options = Options {
                            closed,
                            objective,
                            secondary,
                            normals: Some(normals.clone()),
                            ..Options::default()
                        };
                        let solve = |lanes| solve_with(&rails, &options, &Execution::default(), lanes).unwrap();
                        let plain = solve(Widest::Plain);
                        for &wide in &Widest::all()[1..] {
                            assert_eq!(plain, solve(wide), "{objective:?} {m} {n} {wide:?}");
                        }
                    }
                }
            }
        }
    }
}
