//! Moves the inner nodes on the surface (Katoh, Ohsaki and Xu, section 4, last paragraph). This minimises Σ (L - ℓ)²
//! over the lattice group, with the parameters of the inner nodes as variables.
//!
//! 1. Levenberg and Marquardt on the members' lengths, measured on the surface itself.
//! 2. Members of the rim are kept in [ℓ, 2ℓ]: a member beyond a bound adds the square of its weighted excess, and the
//!    bound is shifted by the remaining excess (the multipliers of Powell and Hestenes), until no excess remains.
//!
//! Our departures:
//!
//! - Members of the rim are bounded (step 2) and the rim is rebuilt in [`transition`](super::transition), because the
//!   paper's own optimum stretched a rim member to 13.4 for ℓ = 5. [`Transition::Free`](crate::Transition::Free) leaves
//!   step 2 out.
//! - A step that would flip a triangle in the parameter plane is refused.
//! - The damping is the surface's metric, so that the result does not depend on how the patch is parametrised.

use super::auxiliary::{Surface, weighted};
use super::least_squares::{Settings, minimise, step_before_flip};
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::sparse::levenberg_marquardt::{LeastSquares, NormalEquations};
use plateau_mesh::{DVec2, DVec3};

/// Distance, in ℓ, by which the bounds of rim members are narrowed, so that members with a small remaining excess are
/// still within [ℓ, 2ℓ].
const MARGIN: f64 = 1e-7;
/// Weight of a rim member's excess, relative to a lattice member's deviation.
const WEIGHT: f64 = 3.0;
/// Weight of a rim member's excess from which on the weight is not raised any further.
const LARGEST_WEIGHT: f64 = 30.0;
/// Largest shift of a bound, in ℓ.
const LARGEST_SHIFT: f64 = 0.5;
/// Tolerance for the bounds on a length, in ℓ.
const ENOUGH: f64 = 1e-9;
/// Maximum number of multiplier updates per attempt on a patch or a film.
const ROUNDS: usize = 16;
/// Maximum number of attempts on a patch or a film.
const ATTEMPTS: usize = 3;
/// Largest number of steps of one attempt, multiplied by the number of moving nodes. On patches of 5,000 nodes and
/// more, further steps lowered the energy by one or two hundredths and took four fifths of the time. Meshes of fewer
/// than 600 nodes never reach this number, because their rounds end first.
const NODE_STEPS: usize = 600_000;
/// Number of steps that an attempt may take at least, however many nodes move.
const FEWEST_STEPS: usize = 30;

/// The required length of a member, in ℓ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum TargetLength {
    /// A length as near to this one as possible.
    At(f64),
    /// The same, with a weight on the difference. A difference at [`TargetLength::At`] has weight 1.
    Weighted { length: f64, weight: f64 },
    /// A length between this one and 2.
    Within(f64),
    /// A length between these two.
    Between([f64; 2]),
    /// Any length.
    Free,
}

/// Limits of the work of one optimisation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// Maximum number of attempts. Each attempt widens the bounds of the members that were out of their bounds after
    /// the previous attempt.
    pub attempts: usize,
    /// Maximum number of multiplier updates per attempt.
    pub rounds: usize,
    /// Maximum number of steps between two updates of the multipliers.
    pub iterations: u64,
    /// Relative change of the energy below which the steps end.
    pub tolerance: f64,
}

/// A surface on which nodes move, by displacements with two coordinates each.
pub(crate) trait Sheet {
    /// The place of a node.
    type Location: Copy + std::fmt::Debug;
    /// Limits of the work of an optimisation on this surface.
    fn effort(&self) -> Effort;
    /// Returns the point of the surface, and its derivatives by the two coordinates of a displacement.
    fn evaluate(&self, place: Self::Location) -> [DVec3; 3];
    /// Whether none of the triangles is flipped. `at` returns the place and the position of a node.
    fn are_upright(&self, triangles: &[[u32; 3]], at: &dyn Fn(u32) -> (Self::Location, DVec3)) -> bool;
    /// Moves the nodes by the largest fraction of `step` that is allowed, and returns that fraction. Writes the new
    /// places of the moving nodes to `to`.
    fn advance(&self, mesh: &Moved<'_, Self::Location>, step: &[DVec2], to: &mut [Self::Location]) -> f64;
    /// Returns the point of the surface nearest to the middle of a triangle, and the surface's unit normal there.
    fn below(&self, corners: [Self::Location; 3], middle: DVec3) -> (DVec3, DVec3);
}

/// The moving part of a mesh.
#[derive(Debug)]
pub(crate) struct Moved<'a, P> {
    /// Places of the nodes that do not move: those with an index below `fixed`.
    pub standing: &'a [P],
    /// Places of the nodes that move: those with an index from `fixed` on.
    pub moving: &'a [P],
    pub fixed: usize,
    /// The triangles with a moving corner.
    pub triangles: &'a [[u32; 3]],
}

impl Sheet for Surface {
    type Location = DVec2;

    fn effort(&self) -> Effort {
        // The derivatives jump between a film's facets, so that the last digits of the minimum are not defined.
        let tolerance = if matches!(self, Self::Film { .. }) { 1e-5 } else { 1e-9 };
        Effort { attempts: ATTEMPTS, rounds: ROUNDS, iterations: 60, tolerance }
    }

    fn evaluate(&self, place: DVec2) -> [DVec3; 3] {
        Self::evaluate(self, place)
    }

    fn are_upright(&self, triangles: &[[u32; 3]], at: &dyn Fn(u32) -> (DVec2, DVec3)) -> bool {
        triangles.iter().all(|triangle| {
            let [a, b, c] = self.beside_pole(triangle.map(|v| (at(v).0, DVec2::ZERO))).map(|(p, _)| p);
            (b - a).perp_dot(c - a) > 0.0
        })
    }

    fn advance(&self, mesh: &Moved<'_, DVec2>, step: &[DVec2], to: &mut [DVec2]) -> f64 {
        let with_step = |v: u32| match (v as usize).checked_sub(mesh.fixed) {
            Some(k) => (mesh.moving[k], step[k]),
            None => (mesh.standing[v as usize], DVec2::ZERO),
        };
        let most = step_before_flip(mesh.triangles.iter().map(|t| self.beside_pole(t.map(with_step))));
        for (node, place) in to.iter_mut().enumerate() {
            *place = self.restrict(mesh.moving[node] + step[node] * most);
        }
        most
    }

    fn below(&self, corners: [DVec2; 3], middle: DVec3) -> (DVec3, DVec3) {
        let mut p = match self {
            Self::Patch(_, pole @ Some(_)) => weighted(*pole, &corners.map(|corner| (corner, 1.0 / 3.0))),
            _ => corners.into_iter().sum::<DVec2>() / 3.0,
        };
        // Three steps of the Gauss-Newton method find the nearest point, because the start is close.
        for _ in 0..3 {
            let [x, du, dv] = Self::evaluate(self, p);
            let (off, uu, uv, vv) = (middle - x, du.dot(du), du.dot(dv), dv.dot(dv));
            let (ou, ov) = (off.dot(du), off.dot(dv));
            let step = DVec2::new(ou * vv - ov * uv, ov * uu - ou * uv) / (uu * vv - uv * uv);
            if !step.is_finite() {
                break;
            }
            p = self.restrict(p + step);
        }
        let [x, du, dv] = Self::evaluate(self, p);
        (x, du.cross(dv).normalize_or_zero())
    }
}

/// A mesh on the surface: the places and positions of its nodes. Lengths are in ℓ.
#[derive(Debug)]
pub(crate) struct OnSurface<'a, S: Sheet> {
    pub surface: &'a S,
    pub parameters: Vec<S::Location>,
    pub positions: Vec<DVec3>,
    /// Number of leading nodes that stay where they are.
    pub fixed: usize,
    pub triangles: Vec<[u32; 3]>,
    pub members: Vec<[u32; 2]>,
    /// For each member whether it belongs to the lattice group.
    pub lattice_group: Vec<bool>,
}

impl<S: Sheet> Clone for OnSurface<'_, S> {
    fn clone(&self) -> Self {
        Self {
            surface: self.surface,
            parameters: self.parameters.clone(),
            positions: self.positions.clone(),
            fixed: self.fixed,
            triangles: self.triangles.clone(),
            members: self.members.clone(),
            lattice_group: self.lattice_group.clone(),
        }
    }
}

impl<S: Sheet> OnSurface<'_, S> {
    /// Whether neither end of a member moves.
    pub fn holds(&self, member: &[u32; 2]) -> bool {
        member.iter().all(|&v| (v as usize) < self.fixed)
    }

    /// Takes over the places of the nodes and the triangulation of another state of this mesh.
    pub fn take(&mut self, other: &OnSurface<'_, S>) {
        self.parameters.clone_from(&other.parameters);
        self.positions.clone_from(&other.positions);
        self.triangles.clone_from(&other.triangles);
        self.members.clone_from(&other.members);
    }

    pub fn lengths(&self) -> Vec<f64> {
        self.members.iter().map(|&[a, b]| self.positions[a as usize].distance(self.positions[b as usize])).collect()
    }
}

struct Moving<'a, 'b, S: Sheet> {
    nodes: &'a OnSurface<'b, S>,
    /// Indices in `members` of the members with a target and at least one moving end.
    active: Vec<usize>,
    targets: &'a [TargetLength],
    /// For each active member the bounds on its length, in ℓ. They are used only if the member is in the rim.
    bounds: Vec<[f64; 2]>,
    /// For each active member the shifts of its lower and upper bound, 0 or positive.
    shifts: Vec<[f64; 2]>,
    weight: f64,
    /// Triangles with a moving corner that are upright at the start. A step that would flip one of them is not taken.
    triangles: Vec<[u32; 3]>,
    /// Positions and derivatives of the moving nodes at the places of the last evaluation.
    here: Vec<[DVec3; 3]>,
    metrics: Vec<[f64; 3]>,
}

impl<'a, 'b, S: Sheet> Moving<'a, 'b, S> {
    fn new(nodes: &'a OnSurface<'b, S>, targets: &'a [TargetLength]) -> Self {
        let fixed = nodes.fixed as u32;
        let active: Vec<usize> = (0..nodes.members.len())
            .filter(|&m| targets[m] != TargetLength::Free && nodes.members[m].iter().any(|&v| v >= fixed))
            .collect();
        let located = |v: u32| (nodes.parameters[v as usize], nodes.positions[v as usize]);
        let guarded = |t: &&[u32; 3]| t.iter().any(|&v| v >= fixed) && nodes.surface.are_upright(&[**t], &located);
        let triangles = nodes.triangles.iter().filter(guarded).copied().collect();
        let (bounds, shifts) = (vec![[0.0; 2]; active.len()], vec![[0.0; 2]; active.len()]);
        let moving = nodes.parameters.len() - nodes.fixed;
        let mut moving = Self {
            nodes,
            active,
            targets,
            bounds,
            shifts,
            weight: WEIGHT,
            triangles,
            here: Vec::new(),
            metrics: vec![[1.0, 0.0, 1.0]; moving],
        };
        moving.reset_bounds();
        moving
    }

    /// Sets the bounds of all active members to those of their targets.
    fn reset_bounds(&mut self) {
        for (bounds, &member) in self.bounds.iter_mut().zip(&self.active) {
            *bounds = match self.targets[member] {
                TargetLength::Within(least) => [least, 2.0],
                TargetLength::Between(bounds) => bounds,
                _ => [1.0, 2.0],
            };
        }
    }

    /// Whether an active member has bounds.
    fn is_bounded(&self, k: usize) -> bool {
        matches!(self.targets[self.active[k]], TargetLength::Within(_) | TargetLength::Between(_))
    }

    fn position(&self, v: u32) -> DVec3 {
        match (v as usize).checked_sub(self.nodes.fixed) {
            Some(k) => self.here[k][0],
            None => self.nodes.positions[v as usize],
        }
    }

    /// The weighted residual of active member `k` at a length, and its derivative by the length.
    fn residual(&self, k: usize, length: f64) -> (f64, f64) {
        match self.targets[self.active[k]] {
            TargetLength::At(target) => (length - target, 1.0),
            TargetLength::Weighted { length: target, weight } => (weight * (length - target), weight),
            TargetLength::Within(_) | TargetLength::Between(_) => {
                let ([low, high], [down, up]) = (self.bounds[k], self.shifts[k]);
                let (under, over) = (low + MARGIN - length + down, length - high + MARGIN + up);
                if under > 0.0 {
                    (self.weight * under, -self.weight)
                } else if over > 0.0 {
                    (self.weight * over, self.weight)
                } else {
                    (0.0, 0.0)
                }
            }
            TargetLength::Free => (0.0, 0.0),
        }
    }

    fn length(&self, k: usize) -> f64 {
        let [a, b] = self.nodes.members[self.active[k]];
        self.position(a).distance(self.position(b))
    }

    /// Largest excess of a rim member over its bounds.
    fn excess(&self) -> f64 {
        (0..self.active.len())
            .filter(|&k| self.is_bounded(k))
            .map(|k| (self.length(k), self.bounds[k]))
            .map(|(length, [low, high])| (low - length).max(length - high))
            .fold(0.0, f64::max)
    }

    fn shift(&mut self) {
        for k in 0..self.active.len() {
            if self.is_bounded(k) {
                let length = self.length(k);
                let ([low, high], [down, up]) = (self.bounds[k], self.shifts[k]);
                self.shifts[k] =
                    [down + low + MARGIN - length, up + length - high + MARGIN].map(|s| s.clamp(0.0, LARGEST_SHIFT));
            }
        }
    }
}

impl<S: Sheet> LeastSquares<2> for Moving<'_, '_, S> {
    type Location = S::Location;

    fn couplings(&self, couple: &mut dyn FnMut(&[u32])) {
        let fixed = self.nodes.fixed as u32;
        for &member in &self.active {
            let [a, b] = self.nodes.members[member];
            if a >= fixed && b >= fixed {
                couple(&[a - fixed, b - fixed]);
            }
        }
    }

    fn energy(&mut self, x: &[S::Location]) -> f64 {
        self.here = x.iter().map(|&p| Sheet::evaluate(self.nodes.surface, p)).collect();
        let located = |v: u32| match (v as usize).checked_sub(self.nodes.fixed) {
            Some(k) => (x[k], self.here[k][0]),
            None => (self.nodes.parameters[v as usize], self.nodes.positions[v as usize]),
        };
        if !self.nodes.surface.are_upright(&self.triangles, &located) {
            return f64::INFINITY;
        }
        (0..self.active.len())
            .map(|k| {
                let (r, _) = self.residual(k, self.length(k));
                0.5 * r * r
            })
            .sum()
    }

    fn assemble(&mut self, x: &[S::Location], normal: &mut NormalEquations<2>) {
        self.here = x.iter().map(|&p| Sheet::evaluate(self.nodes.surface, p)).collect();
        for (metric, [_, du, dv]) in self.metrics.iter_mut().zip(&self.here) {
            *metric = [du.dot(*du), du.dot(*dv), dv.dot(*dv)];
        }
        for k in 0..self.active.len() {
            let [a, b] = self.nodes.members[self.active[k]];
            let edge = self.position(b) - self.position(a);
            let length = edge.length();
            let (r, slope) = self.residual(k, length);
            if slope == 0.0 || length == 0.0 {
                continue;
            }
            let direction = edge * (slope / length);
            let derivative = |v: u32, direction: DVec3| {
                (v as usize).checked_sub(self.nodes.fixed).map(|node| {
                    let [_, du, dv] = self.here[node];
                    (node as u32, [du.dot(direction), dv.dot(direction)])
                })
            };
            match (derivative(a, -direction), derivative(b, direction)) {
                (Some((a, by_a)), Some((b, by_b))) => normal.add(r, &[a, b], &[by_a, by_b]),
                (Some((node, by_node)), None) | (None, Some((node, by_node))) => normal.add(r, &[node], &[by_node]),
                (None, None) => {}
            }
        }
    }

    fn advance(&self, x: &[S::Location], step: &[[f64; 2]], to: &mut [S::Location]) -> f64 {
        let nodes = self.nodes;
        let step: Vec<DVec2> = step.iter().map(|&step| step.into()).collect();
        let mesh = Moved {
            standing: &nodes.parameters[..nodes.fixed],
            moving: x,
            fixed: nodes.fixed,
            triangles: &self.triangles,
        };
        nodes.surface.advance(&mesh, &step, to)
    }

    fn metric(&self, node: usize) -> [[f64; 2]; 2] {
        let [xx, xy, yy] = self.metrics[node];
        // A small part of the trace keeps the metric definite at points of a patch without a tangent plane.
        let little = 1e-9 * (xx + yy) + f64::MIN_POSITIVE;
        [[xx + little, xy], [xy, yy + little]]
    }
}

/// Moves the inner nodes so that the members come near to their targets. `effort` limits the work.
///
/// In places the surface may be curved so strongly that some rim members cannot reach a length within [ℓ, 2ℓ]. These
/// members may keep the length they start with, because more weight on them would only spoil the lattice. If the work
/// ended early, returns the reason, and `nodes` is the best found until then.
pub(crate) fn refine<S: Sheet>(
    nodes: &mut OnSurface<'_, S>,
    targets: &[TargetLength],
    effort: Effort,
    phase: &'static str,
    (from, to): (f64, f64),
    execution: &Execution<'_>,
) -> Option<Interruption> {
    let start: Vec<S::Location> = nodes.parameters[nodes.fixed..].to_vec();
    let mut moving = Moving::new(nodes, targets);
    let before = (moving.deviation(&start), moving.excess());
    let given: Vec<f64> = (0..moving.active.len()).map(|k| moving.length(k)).collect();
    let (mut x, mut interrupted) = (start.clone(), None);
    for attempt in 0..effort.attempts {
        let part = |k: usize| from + (to - from) * k as f64 / effort.attempts as f64;
        x.clone_from(&start);
        interrupted = moving.multipliers(&mut x, effort, phase, (part(attempt), part(attempt + 1)), execution);
        moving.energy(&x);
        if interrupted.is_some() || moving.excess() <= ENOUGH {
            break;
        }
        let mut widened = false;
        // Only the bounds of rim members are widened. Lattice members have target lengths instead, and their entries in
        // `bounds` are not used. Widening such an entry would only run the same attempt again.
        let in_rim = |k: &usize| moving.is_bounded(*k);
        for k in (0..given.len()).filter(in_rim).collect::<Vec<usize>>() {
            let given = given[k];
            let (length, [low, high]) = (moving.length(k), moving.bounds[k]);
            if length < low - ENOUGH || length > high + ENOUGH {
                moving.bounds[k] = [low.min(given), high.max(given)];
                widened |= moving.bounds[k] != [low, high];
            }
        }
        if !widened {
            break;
        }
    }
    // If neither the deviation nor the excess is smaller than at the start, the nodes return to their start.
    moving.reset_bounds();
    if moving.deviation(&x) >= before.0 && moving.excess() >= before.1 {
        x = start;
        moving.energy(&x);
    }
    let here = std::mem::take(&mut moving.here);
    let fixed = nodes.fixed;
    nodes.parameters.truncate(fixed);
    nodes.parameters.extend(x);
    nodes.positions.truncate(fixed);
    nodes.positions.extend(here.iter().map(|point| point[0]));
    interrupted
}

impl<S: Sheet> Moving<'_, '_, S> {
    /// ½ Σ (L - target)² over the members that have a target length.
    fn deviation(&mut self, x: &[S::Location]) -> f64 {
        self.energy(x);
        let aimed =
            |k: &usize| matches!(self.targets[self.active[*k]], TargetLength::At(_) | TargetLength::Weighted { .. });
        let term = |k: usize| 0.5 * self.residual(k, self.length(k)).0.powi(2);
        (0..self.active.len()).filter(aimed).map(term).sum()
    }

    /// Runs the method of multipliers once, from `x`.
    fn multipliers(
        &mut self,
        x: &mut Vec<S::Location>,
        Effort { rounds, iterations, tolerance, .. }: Effort,
        phase: &'static str,
        (from, to): (f64, f64),
        execution: &Execution<'_>,
    ) -> Option<Interruption> {
        self.weight = WEIGHT;
        self.shifts.fill([0.0; 2]);
        let (mut last, mut stalled) = (f64::INFINITY, 0);
        let mut steps_left = (NODE_STEPS / x.len().max(1)).max(FEWEST_STEPS) as u64;
        for round in 0..rounds {
            let part = |k: usize| from + (to - from) * k as f64 / rounds as f64;
            let span = (part(round), part(round + 1));
            let settings = Settings { phase, span, max_iterations: iterations.min(steps_left), tolerance };
            let outcome = minimise(self, x, settings, execution);
            steps_left -= outcome.steps;
            if outcome.interrupted.is_some() {
                return outcome.interrupted;
            }
            self.energy(x);
            let excess = self.excess();
            stalled = if excess > 0.9 * last { stalled + 1 } else { 0 };
            if excess <= ENOUGH || stalled == 3 || steps_left == 0 {
                break;
            }
            if excess > 0.3 * last && self.weight < LARGEST_WEIGHT {
                self.weight *= 3.0;
                // A shift is a multiplier divided by the square of the weight, so that a new weight rescales it.
                self.shifts.iter_mut().for_each(|shift| *shift = shift.map(|s| s / 9.0));
            }
            last = excess;
            self.shift();
        }
        None
    }
}
