//! How far the points of the rails may move, and the radii of the balls on the way.

use crate::stack::options::{Options, RailEnds};
use plateau_mesh::DVec3;

/// Radius of the lowest rung, as a fraction of the radius of all points. Below it, points stay. The odd factor keeps
/// round tolerances away from the rungs, because rounding would decide between two rungs there.
const LOWEST: f64 = 0.739_085_133_215_160_6 / 1_048_576.0;
/// Largest tolerance, as a fraction of the radius of all points. Beyond it nothing is left of the shape of the rails.
const LARGEST: f64 = 0.25;
/// Rungs for each doubling of the radius, up to [`COARSE_DOUBLINGS`] doublings of the lowest radius.
const COARSE: u32 = 4;
/// Rungs for each doubling of the radius above. The points thus use at least 97.8% of the tolerance.
const FINE: u32 = 32;
/// Doublings of the radius with coarse rungs. Fine rungs begin at about 1/5,500 of the radius of all points.
const COARSE_DOUBLINGS: u32 = 8;

/// Work of computing the slopes of a bridge, in cells of a search. It takes about 1 µs, and a cell 1 to 5 ns.
pub(super) const CELLS_PER_BRIDGE: u64 = 256;
/// Work of a descent for each point, in cells of a search: a point has about one bridge, and the descents of a ladder
/// evaluate it 16 times on average.
pub(crate) const CELLS_PER_POINT: u64 = 16 * CELLS_PER_BRIDGE;

/// The radii of the balls, from the lowest to the largest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ladder {
    /// Radius of all points: the largest distance of a given point from the mean of all.
    pub(super) unit: f64,
}

impl Ladder {
    pub(super) fn radius(self, rung: u32) -> f64 {
        let coarse = COARSE * COARSE_DOUBLINGS;
        let doublings =
            f64::from(rung.min(coarse)) / f64::from(COARSE) + f64::from(rung.saturating_sub(coarse)) / f64::from(FINE);
        LOWEST * self.unit * libm::exp2(doublings)
    }

    /// Returns the number of rungs whose radius is at most the tolerance.
    fn rungs(self, tolerance: f64) -> u32 {
        // Ends because the radius grows with the rung without bound and the tolerance is finite.
        (0..).take_while(|&rung| self.radius(rung) <= tolerance).count() as u32
    }
}

/// How far the points may move.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Freedom {
    pub(super) ladder: Ladder,
    tolerance: f64,
    /// Whether the ends of open directrices keep their places.
    pub(super) has_fixed_ends: bool,
}

impl Freedom {
    /// Returns `None` if the options let no point move. The directrices are those of the caller.
    pub(crate) fn new(directrices: &[Vec<DVec3>], options: &Options) -> Option<Self> {
        let tolerance = options.rail_tolerance?;
        let points = || directrices.iter().flatten();
        let count = points().count().max(1) as f64;
        let mean = points().fold(DVec3::ZERO, |sum, &p| sum + p / count);
        let unit = points().map(|p| p.distance(mean)).fold(0.0, f64::max);
        Some(Self { ladder: Ladder { unit }, tolerance, has_fixed_ends: options.rail_ends == RailEnds::Fixed })
    }

    pub(crate) fn rungs(self) -> u32 {
        self.ladder.rungs(self.tolerance)
    }

    /// Returns the number of rungs for the largest tolerance.
    pub(crate) fn most_rungs() -> u32 {
        Ladder { unit: 1.0 }.rungs(LARGEST)
    }

    /// Returns the reason why the tolerance is too large, if it is.
    pub(crate) fn excess(self) -> Option<String> {
        let most = LARGEST * self.ladder.unit;
        (self.tolerance > most).then(|| format!("must be at most {most}, a quarter of the radius of all points"))
    }
}
