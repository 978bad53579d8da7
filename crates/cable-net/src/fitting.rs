//! Fits force densities to targets, by Levenberg and Marquardt's method.
//!
//! # The problem
//!
//! Given the force density q_e of each edge, the positions x solve the linear equations of [`shape`](super::shape). The
//! forces q ℓ and the lengths ℓ therefore depend on the densities alone. The unknowns are s_e = ln q_e: every cable
//! stays in tension, and a change of s is a relative change of a density. The loss is Σ r² over three residuals r of
//! each edge,
//!
//! ```text
//! √(w_F / n_F) (q ℓ / F* - 1)          √(w_L / n_L) (ℓ / L* - 1)          √(w_P q / P0) ℓ
//! ```
//!
//! for its force, its length and the load path. The squares of the last residual add up to w_P times the load path Σ F
//! ℓ, divided by its value P0 at the start.
//!
//! # The start
//!
//! The forces of a fine net's inner cables may add up to many times the force that the targets let its rim bear. Such
//! densities draw the net together, and steps from there end in a net with cables of almost no length. If the given
//! densities miss a target by far, a better start is therefore sought: each density is multiplied by F* / F and by ℓ /
//! L*, as far as there are targets, and this is repeated with the forces F and lengths ℓ of the new shape. Fitting
//! begins with the densities whose loss was the lowest. If the result still misses a target by far or leaves a cable
//! slack, fitting begins once more with the given densities, and the better result counts. If the caller limits the
//! number of steps, the first fit is judged after half of them, so that the second has the other half.
//!
//! # A step
//!
//! The Gauss-Newton step minimises ½ Σ (r + r_s δs + r_ℓ δℓ)² + ½ μ Σ δs² under the linearised equilibrium. For an
//! edge, let u be its unit vector, p = dq/ds the derivative of its density, and Δa = a_1 - a_0 the difference between
//! its ends of any vector a of the vertices. With the multipliers λ of the vertices' equilibrium, the Lagrangian of one
//! edge is
//!
//! ```text
//! ½ (h_ss + μ) δs² + h_sℓ δs (u·Δx) + ½ h_ℓℓ (u·Δx)² + g_s δs + g_ℓ u·Δx - Δλ·(p ℓ u δs + q Δx)
//! ```
//!
//! where h and g are sums of products of the residuals' derivatives. Every δs is eliminated: δs = (c u·Δλ - g_s - h_sℓ
//! u·Δx) / H with H = h_ss + μ and c = p ℓ. This leaves a sparse symmetric system for the six numbers δx, λ of each
//! free vertex. A step costs one factorisation of this system for any number of edges, whereas a dense Jacobian would
//! have one column per edge.
//!
//! The damping μ follows the ratio of the fall of the loss to the fall that the linearised residuals predict (Madsen,
//! Nielsen, Tingleff). A step v that raises the loss is halved a few times before μ grows, because a new μ costs a
//! factorisation.
//!
//! # Acceleration
//!
//! The second derivative of the residuals along a step v is r_vv = (2/h) ((r(s + h v) - r(s)) / h - J v). The same
//! factor gives the acceleration a from (JᵀJ + μ) a = -Jᵀ r_vv. The path v + a/2 follows the curved path of least
//! residuals further than v does. It is taken if 2 |a| ≤ ¾ |v| (Transtrum, Sethna, *Geodesic acceleration and the
//! small-curvature approximation for nonlinear least squares*, 2012).
//!
//! A density at its lower bound stays there during a step if the gradient would lower it (a projected step: Bertsekas,
//! *Projected Newton methods for optimization problems with simple constraints*, 1982). A step that would take a
//! density below its lower bound takes it to the bound.
//!
//! Sources: Schek, *The force density method for form finding* (1974), for the equations and for least squares with
//! densities as unknowns; Levenberg and Marquardt's method as in Madsen, Nielsen, Tingleff, *Methods for Non-Linear
//! Least Squares Problems* (2004); Fresl, Gidak, Vrančić, *Generalized minimal nets in form finding of prestressed
//! cable nets* (2013), for densities from the targets and the shape before. The sparse form of the step is worked out
//! here.

use super::fitted::{
    DAMPING, Fitted, LARGEST_DAMPING, LARGEST_STEP, LEAST_DAMPING, QUIET_STEPS, RELAXED, StopReason, TIGHTENED,
    is_late, refused, report,
};
use super::loss::{Loss, length, start};
use super::options::{Net, Options};
use super::shape::Shape;
use super::step::{Change, Damping, Factor, Member, Step, gradients, members};
use plateau_mesh::codes::Reason;
use plateau_mesh::{DVec3, Error, Execution, Interruption};

/// Force below which a cable counts as slack, as a fraction of the mean force. A cable also counts as slack if its
/// density exceeds the least density by less than this fraction. Fitting never reaches a force of exactly zero: where
/// the targets leave a cable no force, its density falls until the change of the loss is below the tolerance.
const SLACK: f64 = 1e-3;
/// Ratio of the fall of the loss to the predicted fall above which the damping is relaxed.
const GOOD: f64 = 0.75;
/// Ratio of the fall of the loss to the predicted fall up to which the damping is tightened.
const POOR: f64 = 0.25;
/// Maximum number of times that a step which raises the loss is halved.
const HALVINGS: u32 = 3;
/// Fraction h of a step at which the second derivative is measured. The value is that of Transtrum and Sethna.
const PROBE: f64 = 0.1;
/// Largest ratio 2 |a| / |v| at which an acceleration is used. The value is that of Transtrum and Sethna.
const LARGEST_ACCELERATION: f64 = 0.75;
/// Maximum number of steps if the caller gives none.
const DEFAULT_STEPS: u32 = 200;
/// The default of [`Options::tolerance`]. Where the targets leave a cable little force, a descent with a smaller
/// tolerance goes on until the cable is slack, although its loss hardly falls. The net at this tolerance is then
/// better.
const USUAL_TOLERANCE: f64 = 1e-4;
/// Maximum number of rounds in which the densities of the start are multiplied by the targets. With 13 every target of
/// the nets of `benches/cable_net.rs`, from 10 to 158 cells a side, is missed by less than 20 %. More rounds improve
/// the finest of these nets, but raise the final loss of those of 50 cells a side by 8 %.
const ROUNDS: u32 = 13;
/// Largest factor by which one target changes a density in a round.
const LARGEST_FACTOR: f64 = 2.0;
/// Smallest density with which fitting begins, as a fraction of the given density. Densities below about a tenth of
/// this fraction count as slack.
const LEAST_SHARE: f64 = 0.01;

/// Returns for each edge whether the targets leave it no force. Held edges never count.
pub(super) fn slack_edges(net: &Net, options: &Options, forces: &[f64], densities: &[f64]) -> Vec<bool> {
    let mean = forces.iter().map(|force| force.abs()).sum::<f64>() / forces.len() as f64;
    let lowest = options.least_density * (1.0 + SLACK);
    let slack = |k: usize| !net.edges[k].held && (forces[k].abs() <= SLACK * mean || densities[k].abs() <= lowest);
    (0..forces.len()).map(slack).collect()
}

/// A state of the fit: densities, with the positions and the value of the loss that follow from them.
#[derive(Clone)]
struct Fit {
    densities: Vec<f64>,
    at: Vec<DVec3>,
    value: f64,
}

/// Improves the start ("The start" above). Multiplies the given densities a few times by the targets, and returns the
/// densities of the lowest loss, including the given ones. If the given densities miss no target by far, they are
/// returned.
///
/// # Errors
/// A cancel.
fn approach(given: &Fit, loss: &Loss, shape: &Shape, exec: &Execution) -> Result<Fit, Error> {
    let (mut last, mut best) = (given.clone(), given.clone());
    if !loss.is_far(&given.densities, &given.at) {
        return Ok(best);
    }
    for _ in 0..ROUNDS {
        if is_late(loss.net, exec)? {
            break;
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

/// The state of a descent between two steps, besides the net itself.
struct Pace {
    damping: f64,
    /// Number of consecutive steps that lowered the loss by less than the tolerance.
    quiet: u32,
    /// The same number for [`USUAL_TOLERANCE`].
    usually_quiet: u32,
    /// The net with which the descent would have ended at [`USUAL_TOLERANCE`], once it has passed it.
    settled: Option<Fit>,
}

impl Pace {
    /// The state with which a descent from a loss of this value begins.
    fn from(value: f64) -> Self {
        Self { damping: (DAMPING * value).max(LEAST_DAMPING), quiet: 0, usually_quiet: 0, settled: None }
    }
}

/// A step of a descent and its second-order correction.
struct Direction {
    change: Change,
    /// Half the acceleration, or zero if the acceleration is too large to be used.
    correction: Vec<f64>,
    /// The two parts of the predicted fall of the loss: |J v|², and in the next field 2 μ |v|².
    linear: f64,
    damped: f64,
}

impl Direction {
    /// Returns the fall of the loss that the linearised residuals predict for the fraction `part` of the step.
    fn predicted(&self, part: f64) -> f64 {
        part * (2.0 * self.linear + self.damped) - part * part * self.linear
    }

    /// Returns the net after the fraction `part` of the step, or `None` if it has no equilibrium.
    fn moved(&self, part: f64, fit: &Fit, loss: &Loss, shape: &Shape) -> Option<Fit> {
        let change = |e: usize| part * self.change.logarithms[e] + part * part * self.correction[e];
        moved(fit, loss, shape, |e| change(e).clamp(-LARGEST_STEP, LARGEST_STEP))
    }
}

/// Returns the net after `change(e)` of the logarithm of each density, or `None` if it has no equilibrium.
fn moved(fit: &Fit, loss: &Loss, shape: &Shape, change: impl Fn(usize) -> f64) -> Option<Fit> {
    let densities: Vec<f64> = fit.densities.iter().enumerate().map(|(e, &q)| loss.moved(e, q, change(e))).collect();
    let at = shape.positions(loss.net, &densities).ok()?;
    let value = loss.value(&densities, &at);
    Some(Fit { densities, at, value })
}

/// Computes the step from the present net with this damping. Returns `None` if the system cannot be solved.
///
/// # Errors
/// A cancel.
fn direction(
    fit: &Fit,
    members: &[Member],
    damping: f64,
    loss: &Loss,
    (shape, step): (&Shape, &mut Step),
    exec: &Execution,
) -> Result<Option<Direction>, Interruption> {
    let system = step.system(members, Damping::of_densities(damping));
    let Ok(factor) = step.factorise(&system) else { return Ok(None) };
    // A late caller still gets the step, because the factorisation took most of its time.
    is_late(loss.net, exec)?;
    let found = factor.change(members, &gradients(members), None).ok().map(|change| {
        let along = |e: usize| -> [f64; 3] {
            let ends = loss.net.edges[e].ends;
            loss.residuals(e, fit.densities[e], &fit.at).map(|residual| change.of_residual(e, ends, &fit.at, &residual))
        };
        let linear: Vec<[f64; 3]> = (0..members.len()).map(along).collect();
        let correction = acceleration(fit, members, &change, &linear, &factor, loss, shape);
        let squares = linear.iter().flatten().map(|by| by * by).sum();
        let damped = 2.0 * damping * change.logarithms.iter().map(|by| by * by).sum::<f64>();
        let correction = correction.unwrap_or_else(|| vec![0.0; members.len()]);
        Direction { change, correction, linear: squares, damped }
    });
    let storage = factor.into_storage();
    step.reuse(storage);
    Ok(found)
}

/// Returns half the acceleration along a step, if it is small enough to be used. `linear` lists the first-order changes
/// of the residuals.
fn acceleration(
    fit: &Fit,
    members: &[Member],
    change: &Change,
    linear: &[[f64; 3]],
    factor: &Factor<'_>,
    loss: &Loss,
    shape: &Shape,
) -> Option<Vec<f64>> {
    let probe = moved(fit, loss, shape, |e| PROBE * change.logarithms[e])?;
    let second = |(e, linear): (usize, &[f64; 3])| {
        let here = loss.residuals(e, fit.densities[e], &fit.at);
        let there = loss.residuals(e, probe.densities[e], &probe.at);
        let mut gradient = [0.0; 2];
        for k in 0..3 {
            let second = 2.0 / PROBE * ((there[k].value - here[k].value) / PROBE - linear[k]);
            gradient[0] += second * here[k].by_s;
            gradient[1] += second * here[k].by_length;
        }
        gradient
    };
    let second: Vec<[f64; 2]> = linear.iter().enumerate().map(second).collect();
    let acceleration = factor.change(members, &second, None).ok()?.logarithms;
    let size = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>().sqrt();
    let trusted = 2.0 * size(&acceleration) <= LARGEST_ACCELERATION * size(&change.logarithms);
    trusted.then(|| acceleration.iter().map(|a| 0.5 * a).collect())
}

/// Lowers the loss by Levenberg and Marquardt's method, until `iterations` reaches `limit` or the loss no longer falls.
/// A descent that has reached its limit continues with the same `pace` as if it had not stopped.
///
/// # Errors
/// A cancel, or if the equations of the net are singular to working precision.
fn descend(
    fit: &mut Fit,
    Pace { damping, quiet, usually_quiet, settled }: &mut Pace,
    iterations: &mut u32,
    (limit, total, tolerance): (u32, u32, f64),
    loss: &mut Loss,
    (shape, step): (&Shape, &mut Step),
    exec: &Execution,
) -> Result<StopReason, Error> {
    let net = loss.net;
    while *iterations < limit {
        loss.hold(&fit.densities, &fit.at, shape).map_err(refused)?;
        let members = members(loss, &fit.densities, &fit.at);
        loop {
            // At a deadline the last step is a valid result, because its shape is in equilibrium.
            if is_late(net, exec)? {
                return Ok(StopReason::Deadline);
            }
            let direction = direction(fit, &members, *damping, loss, (shape, step), exec)?;
            is_late(net, exec)?;
            let lower = direction.and_then(|direction| {
                let parts = (0..=HALVINGS).map(|k| 0.5f64.powi(k as i32));
                let mut tried = parts.map(|part| (part, direction.moved(part, fit, loss, shape)));
                tried.find_map(|(part, moved)| {
                    let moved = moved.filter(|moved| moved.value < fit.value)?;
                    let ratio = (fit.value - moved.value) / direction.predicted(part);
                    Some((if part < 1.0 { 0.0 } else { ratio }, moved))
                })
            });
            let Some((ratio, moved)) = lower else {
                *damping *= TIGHTENED;
                if *damping > LARGEST_DAMPING {
                    return Ok(StopReason::Stalled);
                }
                continue;
            };
            let fall = fit.value - moved.value;
            *quiet = if fall <= tolerance * fit.value { *quiet + 1 } else { 0 };
            *usually_quiet = if fall <= USUAL_TOLERANCE * fit.value { *usually_quiet + 1 } else { 0 };
            *fit = moved;
            if *usually_quiet == QUIET_STEPS && settled.is_none() {
                *settled = Some(fit.clone());
            }
            *damping *= if ratio > GOOD {
                RELAXED
            } else if ratio > POOR {
                1.0
            } else {
                TIGHTENED
            };
            *damping = damping.clamp(LEAST_DAMPING, LARGEST_DAMPING);
            break;
        }
        *iterations += 1;
        report(exec, *iterations, total, fit.value);
        if *quiet >= QUIET_STEPS || fit.value == 0.0 {
            return Ok(StopReason::Change);
        }
    }
    Ok(StopReason::MaxIterations)
}

/// Finds densities whose shape comes nearest to the targets.
///
/// # Errors
/// The interruption, or if the equations of the net are singular to working precision.
pub(super) fn fit(net: &Net, options: &Options, exec: &Execution) -> Result<Fitted, Error> {
    let shape = Shape::new(net).map_err(refused)?;
    // A late caller still gets the shape of the given densities, because every valid result needs one shape.
    is_late(net, exec)?;
    let densities = start(net, options);
    let at = shape.positions(net, &densities).map_err(refused)?;
    let mut loss = Loss::new(net, options, &densities, &at);
    let value = loss.value(&densities, &at);
    let late = is_late(net, exec)?;
    let given = Fit { densities, at, value };
    let (mut fit, mut iterations) = (given.clone(), 0);
    let stop_reason = if !loss.has_targets() || net.edges.iter().all(|edge| edge.held) {
        StopReason::NoTargets
    } else if !value.is_finite() {
        return Err(Error::no_result(Reason::NoEquilibrium, "the loads and targets are too large for each other"));
    } else if value == 0.0 {
        StopReason::Change
    } else if late {
        StopReason::Deadline
    } else {
        let limit = options.max_iterations.unwrap_or(DEFAULT_STEPS);
        let mut step = Step::new(net, shape.fixed()).map_err(refused)?;
        fit = approach(&given, &loss, &shape, exec)?;
        let approached = fit.value < given.value;
        let total = options.max_iterations.unwrap_or(if approached { 2 * DEFAULT_STEPS } else { DEFAULT_STEPS });
        let first = match options.max_iterations {
            Some(most) if approached => most.div_ceil(2),
            _ => limit,
        };
        let mut pace = Pace::from(fit.value);
        let limits = |limit: u32| (limit, total, options.tolerance);
        let (begun, solver) = (&mut iterations, (&shape, &mut step));
        let mut reason = descend(&mut fit, &mut pace, begun, limits(first), &mut loss, solver, exec)?;
        let is_slack = |fit: &Fit| {
            let forces: Vec<f64> =
                net.edges.iter().zip(&fit.densities).map(|(edge, q)| q * length(edge.ends, &fit.at)).collect();
            options.least_density <= 0.0 && slack_edges(net, options, &forces, &fit.densities).contains(&true)
        };
        let slack = is_slack(&fit);
        let mut settled = pace.settled.take();
        let again = options.max_iterations.unwrap_or(iterations + DEFAULT_STEPS);
        let may_begin_again = approached && reason != StopReason::Deadline && iterations < again;
        if may_begin_again && (slack || loss.is_far(&fit.densities, &fit.at)) {
            let (mut second, mut pace) = (given, Pace::from(value));
            let (begun, solver) = (&mut iterations, (&shape, &mut step));
            let other = descend(&mut second, &mut pace, begun, limits(again), &mut loss, solver, exec)?;
            // A net without slack cables is better than a net with them; otherwise the lower loss is better.
            if (is_slack(&second), second.value) < (slack, fit.value) {
                (fit, reason) = (second, other);
            }
            let lower = |net: &Fit| {
                !is_slack(net) && settled.as_ref().is_none_or(|known| is_slack(known) || net.value < known.value)
            };
            if pace.settled.as_ref().is_some_and(lower) {
                settled = pace.settled.take();
            }
        } else if reason == StopReason::MaxIterations && first < limit {
            let (begun, solver) = (&mut iterations, (&shape, &mut step));
            reason = descend(&mut fit, &mut pace, begun, limits(limit), &mut loss, solver, exec)?;
            settled = settled.or(pace.settled.take());
        }
        if is_slack(&fit)
            && let Some(settled) = settled.filter(|settled| !is_slack(settled))
        {
            // The tolerance is not met.
            reason = if reason == StopReason::Change { StopReason::Stalled } else { reason };
            fit = settled;
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
                net.edges.push(Edge { ends: [k, other], force, length, ..Edge::default() });
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
        let mut step = Step::new(&net, shape.fixed()).unwrap();
        let members = members(&loss, &densities, &at);
        let system = step.system(&members, Damping::of_densities(damping));
        let factor = step.factorise(&system).unwrap();
        let step = factor.change(&members, &gradients(&members), None).unwrap().logarithms;
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
        // The step must satisfy (JᵀJ + μ) δ = -Jᵀ r.
        let product: Vec<f64> =
            (0..here.len()).map(|i| columns.iter().zip(&step).map(|(column, step)| column[i] * step).sum()).collect();
        let largest = step.iter().fold(0.0, |max: f64, step| max.max(step.abs()));
        for (e, column) in columns.iter().enumerate() {
            let sum: f64 = column.iter().zip(product.iter().zip(&here)).map(|(j, (p, r))| j * (p + r)).sum();
            assert!((sum + damping * step[e]).abs() < 1e-5 * largest, "{e}: {sum} {}", step[e]);
        }
    }
}
