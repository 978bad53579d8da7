//! One strip as the solver sees it: centred and scaled points, bank edges, tangents, normals.

use super::convexity::{self, Test};
use super::lanes::Widest;
use super::objective::{Objective, Secondary};
use super::shortest_path::Pulse;
use super::solve_strip::{self, Goal};
use super::statistics::{CoupledValues, Statistics, evaluate};
use crate::DVec3;
use crate::error::{Error, Place};
use crate::execution::Execution;
use std::sync::OnceLock;

/// Two directrices, taken as given: nothing is merged or resampled.
///
/// Kept in the solver's own coordinates: divided by a power of two so that the largest is about 1 (exact),
/// then centred at p_0, then divided by a power of two again. Areas and lengths scale back exactly.
#[derive(Clone, Debug)]
pub struct Strip {
    pub(super) closed: bool,
    pub(super) p: Directrix,
    pub(super) q: Directrix,
    /// A length in the caller's unit is one of ours times this (a power of two).
    pub(super) unit: f64,
    /// What rounding the input can move a coordinate by: ulp of the largest |coordinate|, in our unit.
    pub(super) rounding: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Directrix {
    pub(super) points: Vec<DVec3>,
    /// The input times a power of two, uncentred: exact, for the exact predicates.
    pub(super) raw: Vec<DVec3>,
    /// Unit or zero; fitted when first asked for, unless given.
    tangents: OnceLock<Vec<DVec3>>,
    /// Unit or zero; empty if not given.
    pub(super) normals: Vec<DVec3>,
}

/// A directrix as given: points and what belongs to them, of the same length.
#[derive(Clone, Copy, Debug)]
pub struct Given<'a> {
    pub points: &'a [DVec3],
    /// Fitted if not given (eq. 13 and 14).
    pub tangents: Option<&'a [DVec3]>,
    pub normals: Option<&'a [DVec3]>,
}

impl<'a> From<&'a [DVec3]> for Given<'a> {
    fn from(points: &'a [DVec3]) -> Self {
        Self { points, tangents: None, normals: None }
    }
}

impl Strip {
    /// A strip between two directrices of one or more points, not both of one; closed ones of three or more, or one.
    ///
    /// # Errors
    /// [`Error::Input`], at `directrices`, `tangents` or `normals`, if lengths do not fit or values are not finite or
    /// beyond 1e50.
    pub fn new(p: Given<'_>, q: Given<'_>, closed: bool) -> Result<Self, Error> {
        let errors = super::prepare::strip_errors([p, q], closed);
        if errors.is_empty() { Ok(Self::of_checked(p, q, closed)) } else { Err(Error::Input(errors)) }
    }

    /// The optimal path: its bridges in order, from (0, 0) to (m - 1, n - 1), or all the way round from the smallest start.
    /// `convexity_tolerance` in radians; 0 is exact.
    ///
    /// # Errors
    /// [`Error::Input`] if objective, secondary and tolerance are not what [`Options`](super::Options) asks for, or the
    /// objective needs normals that are not there; [`Error::Interrupted`].
    pub fn optimal_path(
        &self,
        objective: Objective,
        secondary: Option<Secondary>,
        convexity_tolerance: f64,
        execution: &Execution<'_>,
    ) -> Result<Vec<[u32; 2]>, Error> {
        let errors = super::prepare::goal_errors(objective, secondary, convexity_tolerance, self.has_normals());
        if !errors.is_empty() {
            return Err(Error::Input(errors));
        }
        let goal = Goal { objective, secondary };
        let mut pulse = Pulse::new(execution, (self.m() * self.n()) as u64);
        let test = Test::new(convexity_tolerance);
        let path = solve_strip::path_of(self, goal, test, Widest::get(), &mut pulse)?;
        pulse.last_look()?;
        Ok(path)
    }

    /// The figures of any triangulation of this strip; `objective_value` and `secondary_value` are not set. With normals, the
    /// normal variation is that of the better winding.
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
        let evaluation = evaluate(self, path, Test::new(convexity_tolerance), Widest::get(), execution)?;
        let mut statistics = evaluation.statistics;
        statistics.normal_variation = evaluation.normal_variation.map(|[one, other]| one.min(other));
        let coupled = CoupledValues {
            bending_energy: evaluation.concave_bending,
            mean_curvature_variation: evaluation.concave_curvature,
        };
        Ok((statistics, coupled))
    }

    /// Whether a bridge is locally convex (definition 6); indices are cyclic, `convexity_tolerance` in radians, 0 is exact.
    #[must_use]
    pub fn is_locally_convex(&self, bridge: [usize; 2], convexity_tolerance: f64) -> bool {
        convexity::is_convex(self, bridge, Test::new(convexity_tolerance))
    }

    fn check_path(&self, path: &[[u32; 2]]) -> Result<(), Error> {
        let (m, n) = (self.m(), self.n());
        let refuse = |detail: &str| Err(Error::input(Place::field("path"), detail));
        let expected = self.triangles() + usize::from(!self.closed);
        if path.len() != expected {
            return refuse("must have one bridge more than triangles, or as many on a closed strip");
        }
        let mut steps = path.windows(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>();
        if self.closed {
            steps.push((path[path.len() - 1], path[0]));
        } else if path[0] != [0, 0] {
            return refuse("must start at the first bridge");
        }
        let mut by_p = 0;
        for ([i, j], [next, other]) in steps {
            let follows = |a: u32, b: u32, count: usize| {
                let after = a as usize + 1;
                b as usize == if self.closed { after % count } else { after }
            };
            let p_step = j == other && follows(i, next, m);
            let q_step = i == next && follows(j, other, n);
            if !(p_step || q_step) || next as usize >= m || other as usize >= n {
                return refuse("each bridge must follow the one before by a P-step or a Q-step");
            }
            by_p += usize::from(p_step && m > 1);
        }
        let around = if self.closed && m > 1 { m } else { m - 1 };
        if by_p == around { Ok(()) } else { refuse("must use every bank edge once") }
    }

    pub(super) fn of_checked(p: Given<'_>, q: Given<'_>, closed: bool) -> Self {
        let largest = |sides: [&[DVec3]; 2], from: DVec3| {
            let reach = |points: &[DVec3]| points.iter().fold(DVec3::ZERO, |reach, &v| reach.max((v - from).abs()));
            reach(sides[0]).max(reach(sides[1])).max_element()
        };
        let outer = power_of_two_above(largest([p.points, q.points], DVec3::ZERO));
        // Dividing by a power of two is multiplying by its inverse, to the bit.
        let raw = |points: &[DVec3]| points.iter().map(|&v| v * outer.recip()).collect::<Vec<_>>();
        let (raw_p, raw_q) = (raw(p.points), raw(q.points));
        let centre = raw_p[0];
        let extent = largest([&raw_p, &raw_q], centre);
        let inner = power_of_two_above(extent);
        let largest_raw = largest([&raw_p, &raw_q], DVec3::ZERO);
        let side = |given: Given<'_>, raw: Vec<DVec3>| {
            let points: Vec<DVec3> = raw.iter().map(|&v| (v - centre) * inner.recip()).collect();
            let tangents = match given.tangents {
                Some(tangents) => OnceLock::from(tangents.iter().map(|t| unit(*t)).collect::<Vec<_>>()),
                None => OnceLock::new(),
            };
            let normals = given.normals.map(|n| n.iter().map(|n| unit(*n)).collect()).unwrap_or_default();
            Directrix { points, raw, tangents, normals }
        };
        Self {
            closed,
            p: side(p, raw_p),
            q: side(q, raw_q),
            unit: outer * inner,
            rounding: (largest_raw.next_up() - largest_raw) / inner,
        }
    }

    pub(super) fn m(&self) -> usize {
        self.p.points.len()
    }
    pub(super) fn n(&self) -> usize {
        self.q.points.len()
    }
    /// A closed directrix of one point is an apex: nothing runs around it.
    pub(super) fn has_apex(&self) -> bool {
        self.m() == 1 || self.n() == 1
    }
    /// Triangles: m + n - 2 open, m + n closed, one fewer round an apex.
    pub(super) fn triangles(&self) -> usize {
        match (self.closed, self.has_apex()) {
            (false, _) => self.m() + self.n() - 2,
            (true, false) => self.m() + self.n(),
            (true, true) => self.m() + self.n() - 1,
        }
    }
    pub(super) fn has_normals(&self) -> bool {
        !self.p.normals.is_empty() && !self.q.normals.is_empty()
    }
    /// The bridge's vector, q_j - p_i; indices are cyclic on closed strips.
    pub(super) fn bridge(&self, [i, j]: [usize; 2]) -> DVec3 {
        self.q.points[j % self.n()] - self.p.points[i % self.m()]
    }
}

impl Directrix {
    pub(super) fn tangents(&self, closed: bool) -> &[DVec3] {
        self.tangents.get_or_init(|| fitted_tangents(&self.points, closed))
    }
    /// The bank edge that ends (`step` 0) or starts (`step` 1) at a point; zero if there is none.
    pub(super) fn bank(&self, index: usize, step: usize, closed: bool) -> DVec3 {
        bank_edge(&self.points, index, step, closed)
    }
    pub(super) fn neighbour(&self, index: usize, before: bool, closed: bool) -> Option<usize> {
        let count = self.points.len();
        match (before, closed && count > 1) {
            (true, true) => Some((index + count - 1) % count),
            (false, true) => Some((index + 1) % count),
            (true, false) => index.checked_sub(1),
            (false, false) => Some(index + 1).filter(|&k| k < count),
        }
    }
}

fn bank_edge(points: &[DVec3], index: usize, step: usize, closed: bool) -> DVec3 {
    let count = points.len();
    let end = index + step;
    if closed && count > 1 {
        points[end % count] - points[(end + count - 1) % count]
    } else if end == 0 || end >= count {
        DVec3::ZERO
    } else {
        points[end] - points[end - 1]
    }
}

/// A power of two within a factor of two above a length; 1 for zero.
fn power_of_two_above(length: f64) -> f64 {
    if length == 0.0 {
        return 1.0;
    }
    // The exponent field, kept where the power and its inverse are normal numbers.
    let exponent = (length.to_bits() >> 52) & 0x7ff;
    f64::from_bits((exponent + 1).clamp(23, 2023) << 52)
}

fn unit(v: DVec3) -> DVec3 {
    let largest = v.abs().max_element();
    // A power of two scales without rounding.
    if largest == 0.0 { DVec3::ZERO } else { (v * power_of_two_above(largest).recip()).normalize() }
}

/// Unit tangents by eq. 13/14: the derivative at the middle of the quadratic through three neighbours, whose parameter is
/// the chord length (the middle at α = |a|/(|a|+|b|), 1/2 where a neighbour coincides). One-sided chords at open ends.
fn fitted_tangents(points: &[DVec3], closed: bool) -> Vec<DVec3> {
    (0..points.len())
        .map(|k| {
            let (before, after) = (bank_edge(points, k, 0, closed), bank_edge(points, k, 1, closed));
            if !closed && (k == 0 || k + 1 == points.len()) {
                return unit(before + after);
            }
            let (a, b) = (before.length(), after.length());
            let alpha = if a == 0.0 || b == 0.0 { 0.5 } else { a / (a + b) };
            unit(before * ((1.0 - alpha) / alpha) + after * (alpha / (1.0 - alpha)))
        })
        .collect()
}
