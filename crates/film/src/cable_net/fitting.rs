//! Force densities from targets, by Levenberg and Marquardt's method.
//!
//! # The problem
//!
//! With the force density q_e of each edge the positions x solve the linear equations of [`shape`](super::shape), so
//! the forces q ℓ and the lengths ℓ depend on the densities alone. The unknowns are s_e = ln q: every cable stays in
//! tension, and a step of s is a relative change of a density. The loss is Σ r² with, for each edge,
//!
//! ```text
//! √(w_F / n_F) (q ℓ / F* - 1)          √(w_L / n_L) (ℓ / L* - 1)          √(w_P q / P0) ℓ
//! ```
//!
//! (the sum of the squares of the last is the load path Σ F ℓ over its value P0 at the start).
//!
//! # The start
//!
//! The forces of a fine net's inner cables may add up to many times what the targets let its rim bear. From such
//! densities the net is drawn together, and steps from there end in a net with cables of almost no length. If the given
//! densities miss a target by far, each density is therefore first multiplied a few times by F* / F and by ℓ / L*, as
//! far as there are targets, each time for the shape that the densities before give. Fitting begins with those of the
//! densities whose loss was the lowest. If the result misses a target by far or leaves a cable slack, fitting begins
//! once more with the given densities, and the better result counts.
//!
//! # A step
//!
//! The Gauss-Newton step minimises ½ Σ (r + r_s δs + r_ℓ δℓ)² + ½ μ Σ δs² under the linearised equilibrium. With the
//! unit vector u of an edge, its density's derivative p = dq/ds, and for a vector a of each vertex Δa = a_1 - a_0 along
//! the edge, the Lagrangian of one edge is, with λ the multipliers of the equilibrium of the vertices,
//!
//! ```text
//! ½ (h_ss + μ) δs² + h_sℓ δs (u·Δx) + ½ h_ℓℓ (u·Δx)² + g_s δs + g_ℓ u·Δx - Δλ·(p ℓ u δs + q Δx)
//! ```
//!
//! where h and g are sums of products of the residuals' derivatives. Every δs is eliminated:
//! δs = (c u·Δλ - g_s - h_sℓ u·Δx) / H with H = h_ss + μ and c = p ℓ. The rest is a sparse symmetric system for the six
//! numbers δx, λ of each free vertex. It costs one factorisation for each step, whatever the number of edges, where a
//! dense Jacobian would have a column for each.
//!
//! A density at the least one stays there in a step if the gradient would lower it (a projected step: Bertsekas,
//! *Projected Newton methods for optimization problems with simple constraints*, 1982). A density that a step would
//! take below the least one ends at the least one.
//!
//! Sources: Schek, *The force density method for form finding* (1974), for the equations and for least squares with
//! densities as unknowns; Levenberg and Marquardt's method as in Madsen, Nielsen, Tingleff, *Methods for Non-Linear
//! Least Squares Problems* (2004); Fresl, Gidak, Vrančić, *Generalized minimal nets in form finding of prestressed
//! cable nets* (2013), for densities from the targets and the shape before. The sparse form of the step is worked out
//! here.

use super::options::{Net, Options};
use super::shape::Shape;
use crate::energy::outer;
use glam::DMat3;
use plateau_mesh::sparse::pattern::BlockPattern;
use plateau_mesh::sparse::{LinearError, Symbolic};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Progress};

/// Force below which a cable counts as slack, as a fraction of the mean force, and distance of a density from the least
/// one, as a fraction of it. Fitting never reaches zero: where the targets
/// leave a cable no force, its density falls until the loss no longer changes by the tolerance.
const SLACK: f64 = 1e-3;
/// Damping at the start, as a multiple of the loss, its factors after a step that was kept and one that was not, and
/// its range. A smaller start takes steps that are refused.
const DAMPING: f64 = 1e-2;
const RELAXED: f64 = 0.2;
const TIGHTENED: f64 = 4.0;
const LEAST_DAMPING: f64 = 1e-12;
const LARGEST_DAMPING: f64 = 1e12;
/// Largest change of a logarithm of a density in one step: a factor of e².
const LARGEST_STEP: f64 = 2.0;
/// Steps in a row that must lower the loss by less than the tolerance.
const QUIET_STEPS: u32 = 3;
/// Largest number of steps if the caller gives none.
const DEFAULT_STEPS: u32 = 200;
/// Number of shapes from which densities for the start are made. With 13 every target of the nets of
/// `benches/cable_net.rs`, from 10 to 158 cells a side, is missed by less than 20 %. More are better for the finest of
/// these nets, and let those of 50 cells a side end at a loss that is higher by 8 %.
const ROUNDS: u32 = 13;
/// Largest factor by which a density changes for one target from a shape to the next.
const LARGEST_FACTOR: f64 = 2.0;
/// Smallest density of the start over the given one. Densities below about a tenth of this value count as slack.
const LEAST_SHARE: f64 = 0.01;
/// Relative deviation above which a target is missed by far.
const FAR: f64 = 0.5;
/// Part of the mean diagonal that is added to the positions' block and subtracted from the multipliers', so that the
/// factorisation without pivoting exists (Vanderbei, *Symmetric quasidefinite matrices*, 1995). The step deviates from
/// the linearised equilibrium by about as much; the loss is that of the exact one.
const REGULARISATION: f64 = 1e-9;

/// Why fitting ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The net has no targets: the shape follows from the densities.
    NoTargets,
    /// The loss no longer falls.
    Change,
    /// No step lowers the loss.
    Stalled,
    /// The allowed steps are used up.
    MaxIterations,
    /// The caller's time is used up.
    Deadline,
}

impl StopReason {
    /// A stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NoTargets => "no_targets",
            Self::Change => "change",
            Self::Stalled => "stalled",
            Self::MaxIterations => "max_iterations",
            Self::Deadline => "deadline",
        }
    }
}

/// The densities that were found.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub densities: Vec<f64>,
    pub vertices: Vec<DVec3>,
    pub loss: f64,
    /// The largest derivative of the loss by a logarithm of a density.
    pub gradient: f64,
    pub iterations: u32,
    pub stop_reason: StopReason,
}

/// Sums over the residuals of one edge: of r², r r_s, r r_ℓ, r_s², r_s r_ℓ, r_ℓ².
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    loss: f64,
    g_s: f64,
    g_l: f64,
    h_ss: f64,
    h_sl: f64,
    h_ll: f64,
}

impl Sums {
    fn add(&mut self, r: f64, by_s: f64, by_length: f64) {
        self.loss += r * r;
        self.g_s += r * by_s;
        self.g_l += r * by_length;
        self.h_ss += by_s * by_s;
        self.h_sl += by_s * by_length;
        self.h_ll += by_length * by_length;
    }
}

/// The loss and its derivatives.
pub(super) struct Loss<'a> {
    net: &'a Net,
    least: f64,
    force: f64,
    length: f64,
    load_path: f64,
    /// For each edge whether its density stays: it is held, or it is the least one and the gradient would lower it.
    stays: Vec<bool>,
}

impl<'a> Loss<'a> {
    pub fn new(net: &'a Net, options: &Options, densities: &[f64], at: &[DVec3]) -> Self {
        let share = |weight: f64, count: usize| if count == 0 { 0.0 } else { (weight / count as f64).sqrt() };
        let forces = net.edges.iter().filter(|edge| edge.force.is_some()).count();
        let lengths = net.edges.iter().filter(|edge| edge.length.is_some()).count();
        let path: f64 = net.edges.iter().zip(densities).map(|(edge, q)| q * length(edge.ends, at).powi(2)).sum();
        Self {
            net,
            least: options.least_density,
            force: share(options.force_weight, forces),
            length: share(options.length_weight, lengths),
            load_path: (options.load_path_weight / path.max(f64::MIN_POSITIVE)).sqrt(),
            stays: net.edges.iter().map(|edge| edge.held).collect(),
        }
    }

    pub fn has_targets(&self) -> bool {
        self.force > 0.0 || self.length > 0.0 || self.load_path > 0.0
    }

    /// The derivative p = dq/ds of an edge's density: zero if the density stays.
    fn slope(&self, e: usize, q: f64) -> f64 {
        if self.stays[e] { 0.0 } else { q }
    }

    /// Marks the densities that the next step must not change.
    fn hold(&mut self, densities: &[f64], at: &[DVec3], shape: &Shape) -> Result<(), LinearError> {
        self.stays = self.net.edges.iter().map(|edge| edge.held).collect();
        let least = self.least;
        if densities.iter().any(|q| *q <= least) {
            let gradient = self.gradient(densities, at, shape)?;
            let lowest = densities.iter().zip(&gradient).map(|(q, g)| *q <= least && *g >= 0.0);
            self.stays.iter_mut().zip(lowest).for_each(|(stays, lowest)| *stays |= lowest);
        }
        Ok(())
    }

    /// Whether some target is missed by far.
    fn is_far(&self, densities: &[f64], at: &[DVec3]) -> bool {
        self.net.edges.iter().zip(densities).any(|(edge, q)| {
            let length = length(edge.ends, at);
            let far = |value: f64, target: Option<f64>| target.is_some_and(|target| (value / target - 1.0).abs() > FAR);
            (self.force > 0.0 && far(q * length, edge.force)) || (self.length > 0.0 && far(length, edge.length))
        })
    }

    fn sums(&self, e: usize, q: f64, at: &[DVec3]) -> Sums {
        let edge = &self.net.edges[e];
        let (length, p) = (length(edge.ends, at), self.slope(e, q));
        let mut sums = Sums::default();
        if let Some(target) = edge.force {
            let factor = self.force / target;
            sums.add(factor * q * length - self.force, factor * p * length, factor * q);
        }
        if let Some(target) = edge.length {
            sums.add(self.length * (length / target - 1.0), 0.0, self.length / target);
        }
        if self.load_path > 0.0 {
            let root = q.sqrt();
            sums.add(self.load_path * root * length, 0.5 * self.load_path * p * length / root, self.load_path * root);
        }
        sums
    }

    pub fn value(&self, densities: &[f64], at: &[DVec3]) -> f64 {
        densities.iter().enumerate().map(|(e, &q)| self.sums(e, q, at).loss).sum()
    }

    /// The derivative of half the loss by each logarithm s, by the adjoint equations: with D λ = ∂/∂x it is
    /// g_s - p ℓ u·Δλ.
    pub fn gradient(&self, densities: &[f64], at: &[DVec3], shape: &Shape) -> Result<Vec<f64>, LinearError> {
        let mut by_positions = vec![DVec3::ZERO; at.len()];
        let sums: Vec<Sums> = densities.iter().enumerate().map(|(e, &q)| self.sums(e, q, at)).collect();
        for (edge, sums) in self.net.edges.iter().zip(&sums) {
            let [a, b] = edge.ends;
            let pull = sums.g_l * unit(edge.ends, at);
            by_positions[b as usize] += pull;
            by_positions[a as usize] -= pull;
        }
        let lambda = shape.solve(densities, &by_positions)?;
        let of = |(e, sums): (usize, &Sums)| {
            let [a, b] = self.net.edges[e].ends;
            let edge = at[b as usize] - at[a as usize];
            sums.g_s - self.slope(e, densities[e]) * edge.dot(lambda[b as usize] - lambda[a as usize])
        };
        Ok(sums.iter().enumerate().map(of).collect())
    }
}

fn length([a, b]: [u32; 2], at: &[DVec3]) -> f64 {
    at[a as usize].distance(at[b as usize])
}

fn unit([a, b]: [u32; 2], at: &[DVec3]) -> DVec3 {
    (at[b as usize] - at[a as usize]).normalize_or_zero()
}

/// The sparse system of a step.
struct Step {
    pattern: BlockPattern,
    symbolic: Symbolic,
    storage: Vec<f64>,
}

impl Step {
    fn new(net: &Net, fixed: &[bool]) -> Result<Self, LinearError> {
        let counts: Vec<u8> = fixed.iter().map(|fixed| if *fixed { 0 } else { 6 }).collect();
        let pattern = BlockPattern::new(&counts, |couple| net.edges.iter().for_each(|edge| couple(&edge.ends)));
        let symbolic = Symbolic::analyse(&pattern.matrix(), None)?;
        Ok(Self { pattern, symbolic, storage: Vec::new() })
    }

    /// The change of each logarithm.
    fn take(&mut self, loss: &Loss, densities: &[f64], at: &[DVec3], damping: f64) -> Result<Vec<f64>, LinearError> {
        let mut matrix = self.pattern.matrix();
        let mut right = vec![0.0; self.pattern.order()];
        let sums: Vec<Sums> = densities.iter().enumerate().map(|(e, &q)| loss.sums(e, q, at)).collect();
        // The multipliers are scaled so that their block has the size of the positions'.
        let (mut positions, mut multipliers) = (0.0, 0.0);
        let (mut squared_lengths, mut squared_forces) = (0.0, 0.0);
        for (e, sums) in sums.iter().enumerate() {
            let own = sums.h_ss + damping;
            let length = length(loss.net.edges[e].ends, at);
            let c = loss.slope(e, densities[e]) * length;
            squared_lengths += length * length;
            squared_forces += (densities[e] * length).powi(2);
            positions += sums.h_ll - sums.h_sl * sums.h_sl / own;
            multipliers += c * c / own;
        }
        // The ratio of the two has the unit 1 / (length force)².
        let edges = sums.len() as f64;
        let least = REGULARISATION * edges * edges / (squared_lengths * squared_forces);
        let scale = (positions / multipliers).max(least).sqrt();
        for (e, edge) in loss.net.edges.iter().enumerate() {
            let (q, sums, u) = (densities[e], &sums[e], unit(edge.ends, at));
            let own = sums.h_ss + damping;
            let c = scale * loss.slope(e, q) * length(edge.ends, at);
            let along = outer(u, u);
            let xx = along * (sums.h_ll - sums.h_sl * sums.h_sl / own);
            let ll = along * (-c * c / own);
            let xl = along * (c * sums.h_sl / own) - DMat3::IDENTITY * (scale * q);
            let by_x = (sums.g_l - sums.g_s * sums.h_sl / own) * u;
            let by_l = c * sums.g_s / own * u;
            for (v, sign) in [(edge.ends[0], -1.0), (edge.ends[1], 1.0)] {
                let unknowns = self.pattern.unknowns(v);
                if unknowns.is_empty() {
                    continue;
                }
                for i in 0..3 {
                    right[unknowns.start + i] -= sign * by_x[i];
                    right[unknowns.start + 3 + i] -= sign * by_l[i];
                }
                for (w, other) in [(edge.ends[0], -1.0), (edge.ends[1], 1.0)] {
                    let Some(position) = self.pattern.position(v, w) else { continue };
                    for j in 0..3 {
                        for i in 0..3 {
                            let factor = sign * other;
                            matrix.values[position.at(i, j)] += factor * xx.col(j)[i];
                            matrix.values[position.at(3 + i, 3 + j)] += factor * ll.col(j)[i];
                            matrix.values[position.at(i, 3 + j)] += factor * xl.col(j)[i];
                            matrix.values[position.at(3 + i, j)] += factor * xl.col(j)[i];
                        }
                    }
                }
            }
        }
        let count = self.pattern.order().max(1) as f64;
        let mean = scale * scale * multipliers / count;
        for row in 0..self.pattern.order() {
            let sign = if row % 6 < 3 { 1.0 } else { -1.0 };
            matrix.values[matrix.row_start[row] as usize] += sign * REGULARISATION * mean;
        }
        let factor = self.symbolic.factorise_into(&matrix, std::mem::take(&mut self.storage))?;
        factor.solve_unchecked(&mut right);
        self.storage = factor.into_storage();
        let part = |v: u32, from: usize| {
            let unknowns = self.pattern.unknowns(v);
            if unknowns.is_empty() { DVec3::ZERO } else { DVec3::from_slice(&right[unknowns.start + from..]) }
        };
        let change = |(e, sums): (usize, &Sums)| {
            let [a, b] = loss.net.edges[e].ends;
            let u = unit([a, b], at);
            let c = scale * loss.slope(e, densities[e]) * length([a, b], at);
            let (x, l) = (u.dot(part(b, 0) - part(a, 0)), u.dot(part(b, 3) - part(a, 3)));
            (c * l - sums.g_s - sums.h_sl * x) / (sums.h_ss + damping)
        };
        let steps: Vec<f64> = sums.iter().enumerate().map(change).collect();
        if steps.iter().all(|step| step.is_finite()) { Ok(steps) } else { Err(LinearError::NotFinite) }
    }
}

/// The densities with which fitting begins: given ones, then those of the target forces at the present lengths, then
/// the mean of these; 1 if there are none.
pub(super) fn start(net: &Net, options: &Options) -> Vec<f64> {
    let given = |edge: &super::options::Edge| {
        let length = length(edge.ends, &net.vertices).max(f64::MIN_POSITIVE);
        edge.density.or_else(|| edge.force.map(|force| force / edge.length.unwrap_or(length)))
    };
    let known: Vec<f64> = net.edges.iter().filter_map(given).filter(|q| q.is_finite()).collect();
    let mean = if known.is_empty() { 1.0 } else { known.iter().sum::<f64>() / known.len() as f64 };
    let found = |edge: &super::options::Edge| given(edge).filter(|q| q.is_finite()).unwrap_or(mean);
    net.edges.iter().map(|edge| if edge.held { found(edge) } else { found(edge).max(options.least_density) }).collect()
}

/// For each edge whether the targets leave it no force.
pub(super) fn slack_edges(net: &Net, options: &Options, forces: &[f64], densities: &[f64]) -> Vec<bool> {
    let mean = forces.iter().sum::<f64>() / forces.len() as f64;
    let lowest = options.least_density * (1.0 + SLACK);
    let slack = |k: usize| !net.edges[k].held && (forces[k] <= SLACK * mean || densities[k] <= lowest);
    (0..forces.len()).map(slack).collect()
}

fn refused(error: LinearError) -> Error {
    Error::no_result("no_equilibrium", format!("the net's equations have no trustworthy solution: {error:?}"))
}

/// The densities that a fit has reached.
#[derive(Clone)]
struct Fit {
    densities: Vec<f64>,
    at: Vec<DVec3>,
    value: f64,
}

/// The densities with the lowest loss among the given ones and those that follow from them by the targets alone. They
/// are the given ones if these miss no target by far.
///
/// # Errors
/// A cancel.
fn approach(given: &Fit, loss: &Loss, shape: &Shape, exec: &Execution) -> Result<Fit, Error> {
    let (mut last, mut best) = (given.clone(), given.clone());
    if !loss.is_far(&given.densities, &given.at) {
        return Ok(best);
    }
    for _ in 0..ROUNDS {
        match exec.look(20 * loss.net.edges.len() as u64) {
            Err(Interruption::DeadlinePassed) => break,
            other => other?,
        }
        let densities = last.densities.iter_mut().zip(&given.densities);
        for (edge, (q, given)) in loss.net.edges.iter().zip(densities).filter(|(edge, _)| !edge.held) {
            let length = length(edge.ends, &last.at);
            let by = |factor: f64| factor.clamp(1.0 / LARGEST_FACTOR, LARGEST_FACTOR);
            let force = edge.force.filter(|_| loss.force > 0.0).map_or(1.0, |target| by(target / (*q * length)));
            let stretch = edge.length.filter(|_| loss.length > 0.0).map_or(1.0, |target| by(length / target));
            *q = (*q * force * stretch).max(loss.least).max(LEAST_SHARE * given);
        }
        let Ok(at) = shape.positions(loss.net, &last.densities) else { break };
        last.value = loss.value(&last.densities, &at);
        last.at = at;
        if last.value < best.value {
            best = last.clone();
        }
    }
    Ok(best)
}

/// Lowers the loss by Levenberg and Marquardt's method until `iterations` has come to `limit`.
///
/// # Errors
/// A cancel; a net whose equations are singular to working precision.
fn descend(
    fit: &mut Fit,
    iterations: &mut u32,
    (limit, total, tolerance): (u32, u32, f64),
    loss: &mut Loss,
    (shape, step): (&Shape, &mut Step),
    exec: &Execution,
) -> Result<StopReason, Error> {
    let net = loss.net;
    let mut damping = (DAMPING * fit.value).max(LEAST_DAMPING);
    let mut quiet = 0;
    while *iterations < limit {
        loss.hold(&fit.densities, &fit.at, shape).map_err(refused)?;
        loop {
            match exec.look(200 * net.edges.len() as u64) {
                // The shape of the last step is a net in equilibrium.
                Err(Interruption::DeadlinePassed) => return Ok(StopReason::Deadline),
                other => other?,
            }
            let moved = step.take(loss, &fit.densities, &fit.at, damping).ok().and_then(|changes| {
                let next =
                    |q: f64, change: f64| (q * libm::exp(change.clamp(-LARGEST_STEP, LARGEST_STEP))).max(loss.least);
                let of_edge = |((edge, q), change): ((&super::options::Edge, &f64), f64)| {
                    if edge.held { *q } else { next(*q, change) }
                };
                let densities: Vec<f64> = net.edges.iter().zip(&fit.densities).zip(changes).map(of_edge).collect();
                let at = shape.positions(net, &densities).ok()?;
                let value = loss.value(&densities, &at);
                (value < fit.value).then_some(Fit { densities, at, value })
            });
            if let Some(moved) = moved {
                quiet = if fit.value - moved.value <= tolerance * fit.value { quiet + 1 } else { 0 };
                *fit = moved;
                damping = (RELAXED * damping).max(LEAST_DAMPING);
                break;
            }
            damping *= TIGHTENED;
            if damping > LARGEST_DAMPING {
                return Ok(StopReason::Stalled);
            }
        }
        *iterations += 1;
        exec.report(Progress {
            fraction: f64::from(*iterations) / f64::from(total),
            phase: "fit",
            iteration: u64::from(*iterations),
            objective_value: Some(fit.value),
            residual: None,
        });
        if quiet >= QUIET_STEPS || fit.value == 0.0 {
            return Ok(StopReason::Change);
        }
    }
    Ok(StopReason::MaxIterations)
}

/// Finds densities whose shape comes nearest to the targets.
///
/// # Errors
/// The interruption; a net whose equations are singular to working precision.
pub(super) fn fit(net: &Net, options: &Options, exec: &Execution) -> Result<Fitted, Error> {
    let shape = Shape::new(net).map_err(refused)?;
    let densities = start(net, options);
    let at = shape.positions(net, &densities).map_err(refused)?;
    let mut loss = Loss::new(net, options, &densities, &at);
    let value = loss.value(&densities, &at);
    let given = Fit { densities, at, value };
    let (mut fit, mut iterations) = (given.clone(), 0);
    let stop_reason = if !loss.has_targets() || net.edges.iter().all(|edge| edge.held) {
        StopReason::NoTargets
    } else if !value.is_finite() {
        return Err(Error::no_result("no_equilibrium", "the loads and targets are too large for each other"));
    } else if value == 0.0 {
        StopReason::Change
    } else {
        let limit = options.max_iterations.unwrap_or(DEFAULT_STEPS);
        let mut step = Step::new(net, shape.fixed()).map_err(refused)?;
        fit = approach(&given, &loss, &shape, exec)?;
        let approached = fit.value < given.value;
        let total = options.max_iterations.unwrap_or(if approached { 2 * DEFAULT_STEPS } else { DEFAULT_STEPS });
        let limits = (limit, total, options.tolerance);
        let mut reason = descend(&mut fit, &mut iterations, limits, &mut loss, (&shape, &mut step), exec)?;
        let is_slack = |fit: &Fit| {
            let forces: Vec<f64> =
                net.edges.iter().zip(&fit.densities).map(|(edge, q)| q * length(edge.ends, &fit.at)).collect();
            options.least_density <= 0.0 && slack_edges(net, options, &forces, &fit.densities).contains(&true)
        };
        let slack = is_slack(&fit);
        if approached && reason != StopReason::Deadline && (slack || loss.is_far(&fit.densities, &fit.at)) {
            let limits = (options.max_iterations.unwrap_or(iterations + DEFAULT_STEPS), total, options.tolerance);
            let mut second = given;
            let other = descend(&mut second, &mut iterations, limits, &mut loss, (&shape, &mut step), exec)?;
            // A net without slack cables is better than one with them, and then that with the lower loss.
            if (is_slack(&second), second.value) < (slack, fit.value) {
                (fit, reason) = (second, other);
            }
        }
        reason
    };
    let Fit { densities, at, value } = fit;
    loss.hold(&densities, &at, &shape).map_err(refused)?;
    let gradient = loss.gradient(&densities, &at, &shape).map_err(refused)?;
    let gradient = gradient.iter().fold(0.0, |max: f64, g| max.max(2.0 * g.abs()));
    Ok(Fitted { densities, vertices: at, loss: value, gradient, iterations, stop_reason })
}

#[cfg(test)]
mod tests {
    use super::super::options::Edge;
    use super::*;

    /// A net of 3 × 3 squares with two corners lifted, a load inside, and targets of every kind.
    fn small() -> Net {
        let mut net = Net::default();
        for k in 0..16u32 {
            let (x, y) = (f64::from(k % 4), f64::from(k / 4));
            let z = if k == 0 || k == 15 { 1.5 } else { 0.1 * x };
            net.vertices.push(DVec3::new(x, y, z));
            let mut join = |other: u32| {
                let force = (net.edges.len() % 3 == 0).then_some(2.0);
                let length = (net.edges.len() % 2 == 0).then_some(1.1);
                net.edges.push(Edge { held: false, ends: [k, other], density: None, force, length });
            };
            if k % 4 < 3 {
                join(k + 1);
            }
            if k < 12 {
                join(k + 4);
            }
        }
        net.supports = vec![0, 3, 12, 15];
        net.loads = vec![DVec3::ZERO; 16];
        net.loads[5] = DVec3::new(0.1, 0.0, -0.4);
        net
    }

    #[test]
    fn the_gradient_of_the_loss_agrees_with_finite_differences() {
        let net = small();
        let options = Options { load_path_weight: 0.7, least_density: 0.1, ..Options::default() };
        let shape = Shape::new(&net).unwrap();
        let densities: Vec<f64> = (0..net.edges.len()).map(|e| 1.0 + 0.05 * e as f64).collect();
        let at = shape.positions(&net, &densities).unwrap();
        let loss = Loss::new(&net, &options, &densities, &at);
        let gradient = loss.gradient(&densities, &at, &shape).unwrap();
        for e in 0..densities.len() {
            let half = |by: f64| {
                let mut moved = densities.clone();
                moved[e] *= libm::exp(by);
                0.5 * loss.value(&moved, &shape.positions(&net, &moved).unwrap())
            };
            let slope = (half(1e-5) - half(-1e-5)) / 2e-5;
            assert!((slope - gradient[e]).abs() < 1e-9, "{e}: {slope} {}", gradient[e]);
        }
    }

    #[test]
    fn a_damped_step_is_that_of_the_dense_normal_equations() {
        let net = small();
        let options = Options::default();
        let shape = Shape::new(&net).unwrap();
        let densities: Vec<f64> = (0..net.edges.len()).map(|e| 1.0 + 0.05 * e as f64).collect();
        let at = shape.positions(&net, &densities).unwrap();
        let loss = Loss::new(&net, &options, &densities, &at);
        let damping = 1e-3;
        let step = Step::new(&net, shape.fixed()).unwrap().take(&loss, &densities, &at, damping).unwrap();
        // The residuals after s, in order: forces, then lengths.
        let residuals = |densities: &[f64]| {
            let at = shape.positions(&net, densities).unwrap();
            let length = |edge: &Edge| length(edge.ends, &at);
            let force = |(edge, q): (&Edge, &f64)| Some(loss.force * (q * length(edge) / edge.force? - 1.0));
            let by_length = |edge: &Edge| Some(loss.length * (length(edge) / edge.length? - 1.0));
            let forces = net.edges.iter().zip(densities).filter_map(force);
            forces.chain(net.edges.iter().filter_map(by_length)).collect::<Vec<f64>>()
        };
        let here = residuals(&densities);
        let columns: Vec<Vec<f64>> = (0..densities.len())
            .map(|e| {
                let moved = |by: f64| {
                    let mut moved = densities.clone();
                    moved[e] *= libm::exp(by);
                    residuals(&moved)
                };
                moved(1e-5).iter().zip(moved(-1e-5)).map(|(a, b)| (a - b) / 2e-5).collect()
            })
            .collect();
        // (JᵀJ + μ) δ = -Jᵀ r holds for the step.
        let product: Vec<f64> =
            (0..here.len()).map(|i| columns.iter().zip(&step).map(|(column, step)| column[i] * step).sum()).collect();
        let largest = step.iter().fold(0.0, |max: f64, step| max.max(step.abs()));
        for (e, column) in columns.iter().enumerate() {
            let sum: f64 = column.iter().zip(product.iter().zip(&here)).map(|(j, (p, r))| j * (p + r)).sum();
            assert!((sum + damping * step[e]).abs() < 1e-5 * largest, "{e}: {sum} {}", step[e]);
        }
    }
}
