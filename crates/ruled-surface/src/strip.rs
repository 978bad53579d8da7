//! A strip between two directrices: objectives, optimal paths and their figures.

pub(crate) mod check;
pub(crate) mod objective;
pub(crate) mod search;
pub(crate) mod statistics;

use crate::graph::cell_counter::CellCounter;
use crate::graph::convexity::{self, ConvexityTest};
use crate::graph::lanes::LaneWidth;
use crate::graph::rails::{Given, Rails};
use crate::graph::weight::BendingLaw;
use objective::{Goal, Objective, Secondary};
use plateau_mesh::error::{Error, Place};
use plateau_mesh::execution::Execution;
use statistics::{CoupledValues, Statistics};

/// Two directrices, taken as given: nothing is merged or resampled.
#[derive(Clone, Debug)]
pub struct Strip(pub(crate) Rails);

impl Strip {
    /// Makes a strip between two directrices. An open directrix has at least one point. A closed one has at least three
    /// points, or a single one. At most one of the two directrices is a single point.
    ///
    /// # Errors
    /// [`Error::Input`], at `directrices`, `tangents` or `normals`, if lengths do not fit or values are not finite or
    /// beyond 1e50.
    pub fn new(p: Given<'_>, q: Given<'_>, closed: bool) -> Result<Self, Error> {
        let errors = check::strip_errors([p, q], closed);
        if errors.is_empty() { Ok(Self(Rails::new(p, q, closed))) } else { Err(Error::Input(errors)) }
    }

    /// Returns the strip with another law of the bending energy. Without a call it is [`BendingLaw::Monotone`].
    #[must_use]
    pub fn with_bending(self, bending: BendingLaw) -> Self {
        Self(Rails { bending, ..self.0 })
    }

    /// Returns the optimal path: its bridges in order, from (0, 0) to (m - 1, n - 1) on an open strip, and all the way
    /// round from the smallest start on a closed one. `convexity_tolerance` is in radians; 0 asks for the exact test.
    ///
    /// # Errors
    /// [`Error::Input`] if objective, secondary and tolerance are not as [`Options`](crate::Options) requires, or if
    /// the objective needs normals that are not given; [`Error::Interrupted`].
    pub fn optimal_path(
        &self,
        objective: Objective,
        secondary: Option<Secondary>,
        convexity_tolerance: f64,
        execution: &Execution<'_>,
    ) -> Result<Vec<[u32; 2]>, Error> {
        let errors = check::goal_errors(objective, secondary, convexity_tolerance, self.0.has_normals());
        if !errors.is_empty() {
            return Err(Error::Input(errors));
        }
        let goal = Goal { objective, secondary };
        let mut counter = CellCounter::new(execution, (self.0.m() * self.0.n()) as u64);
        let test = ConvexityTest::new(convexity_tolerance);
        let path = search::path_of(&self.0, goal, test, LaneWidth::get(), &mut counter)?;
        counter.last_look()?;
        Ok(path)
    }

    /// Returns the figures of any triangulation of this strip, given as a path. `objective_value` and `secondary_value`
    /// are not set. If normals are given, the normal variation is that of the better winding.
    ///
    /// # Errors
    /// [`Error::Input`] at `path` if it is not a path of this strip; [`Error::Interrupted`].
    pub fn statistics(
        &self,
        path: &[[u32; 2]],
        convexity_tolerance: f64,
        execution: &Execution<'_>,
    ) -> Result<(Statistics, CoupledValues), Error> {
        self.check_path(path)?;
        let evaluation =
            statistics::evaluate(&self.0, path, ConvexityTest::new(convexity_tolerance), LaneWidth::get(), execution)?;
        let mut statistics = evaluation.statistics;
        statistics.normal_variation = evaluation.normal_variation.map(|[one, other]| one.min(other));
        let coupled = CoupledValues {
            bending_energy: evaluation.concave_bending,
            mean_curvature_variation: evaluation.concave_curvature,
        };
        Ok((statistics, coupled))
    }

    /// Whether a bridge is locally convex (definition 6). Indices are cyclic. `convexity_tolerance` is in radians; 0
    /// asks for the exact test.
    #[must_use]
    pub fn is_locally_convex(&self, bridge: [usize; 2], convexity_tolerance: f64) -> bool {
        convexity::is_convex(&self.0, bridge, ConvexityTest::new(convexity_tolerance))
    }

    fn check_path(&self, path: &[[u32; 2]]) -> Result<(), Error> {
        let (m, n) = (self.0.m(), self.0.n());
        let refuse = |detail: &str| Err(Error::input(Place::field("path"), detail));
        let expected = self.0.triangles() + usize::from(!self.0.closed);
        if path.len() != expected {
            return refuse("must have one bridge more than triangles, or as many on a closed strip");
        }
        let mut steps = path.windows(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>();
        if self.0.closed {
            steps.push((path[path.len() - 1], path[0]));
        } else if path[0] != [0, 0] {
            return refuse("must start at the first bridge");
        }
        let mut by_p = 0;
        for ([i, j], [next, other]) in steps {
            let follows = |a: u32, b: u32, count: usize| {
                let after = a as usize + 1;
                b as usize == if self.0.closed { after % count } else { after }
            };
            let p_step = j == other && follows(i, next, m);
            let q_step = i == next && follows(j, other, n);
            if !(p_step || q_step) || next as usize >= m || other as usize >= n {
                return refuse("each bridge must follow the one before by a P-step or a Q-step");
            }
            by_p += usize::from(p_step && m > 1);
        }
        let around = if self.0.closed && m > 1 { m } else { m - 1 };
        if by_p == around { Ok(()) } else { refuse("must use every bank edge once") }
    }
}
