//! Fitting of nets with struts: densities and positions are found from the targets at the same time.
//!
//! The force densities of a net with struts do not determine its shape, because the matrix D of the equations of
//! [`shape`](super::shape) is indefinite, and for a tensegrity it is singular at every state of self-stress. The
//! positions x are therefore unknowns in addition to the logarithms s of |q|, and the unbalanced forces R are
//! residuals:
//!
//! ```text
//! minimise   ½ Σ r(s, x)² + |R(s, x)|² / 2 ε
//! ```
//!
//! by Levenberg and Marquardt's method. With the multipliers λ = R / ε, a step solves the system of
//! [`fitting`](super::fitting) with the unbalanced forces on the right-hand side and -ε in the diagonal of the
//! multipliers. ε falls in stages (the penalty method: Nocedal, Wright, *Numerical Optimization*, chapter 17). The
//! final steps remove the remaining unbalanced forces by the smallest change of s and x, which is Newton's method for
//! underdetermined equations.
//!
//! Form finding begins with the given vertices. A structure with struts may have several equilibria; the method finds
//! one near these vertices.

use super::fitted::{
    DAMPING, Fitted, LARGEST_DAMPING, LARGEST_STEP, LEAST_DAMPING, QUIET_STEPS, RELAXED, StopReason, TIGHTENED,
    is_late, refused, report,
};
use super::loss::{Loss, length, start};
use super::options::{Net, Options};
use super::shape::Shape;
use super::step::{Change, Damping, Member, Step, gradients, members};
use plateau_mesh::codes::Reason;
use plateau_mesh::{DVec3, Error, Execution};

/// Number of stages. With nine stages the unbalanced forces of the last stage are about 1e-8 of the other forces.
const STAGES: u32 = 9;
/// Factor of the penalty parameter ε from each stage to the next.
const STAGE_FACTOR: f64 = 0.1;
/// A stage ends after [`QUIET_STEPS`] steps in a row that each lower the merit by at most this fraction. The last stage
/// uses the caller's tolerance instead.
const STAGE_TOLERANCE: f64 = 1e-2;
/// Maximum number of steps if the caller gives none.
const DEFAULT_STEPS: u32 = 1000;
/// Maximum number of steps that remove unbalanced forces after the last stage.
const CORRECTIONS: u32 = 30;
/// Largest unbalanced force with which a net counts as balanced, as a fraction of the root mean square force of its
/// edges.
const BALANCED: f64 = 1e-9;

/// Densities and positions, with the loss and the unbalanced forces that follow from them.
#[derive(Clone)]
struct State {
    densities: Vec<f64>,
    at: Vec<DVec3>,
    loss: f64,
    /// The unbalanced force on each free vertex, and zero on supports.
    unbalanced: Vec<DVec3>,
}

impl State {
    fn of(densities: Vec<f64>, at: Vec<DVec3>, loss: &Loss, shape: &Shape) -> Self {
        let net = loss.net;
        let mut unbalanced: Vec<DVec3> = (0..at.len()).map(|v| net.load(v)).collect();
        for (edge, q) in net.edges.iter().zip(&densities) {
            let [a, b] = edge.ends.map(|v| v as usize);
            let pull = *q * (at[b] - at[a]);
            unbalanced[a] += pull;
            unbalanced[b] -= pull;
        }
        unbalanced
            .iter_mut()
            .zip(shape.fixed())
            .filter(|(_, fixed)| **fixed)
            .for_each(|(force, _)| *force = DVec3::ZERO);
        Self { loss: loss.value(&densities, &at), densities, at, unbalanced }
    }

    fn moved(&self, change: &Change, loss: &Loss, shape: &Shape) -> Option<Self> {
        let by = |e: usize| change.logarithms[e].clamp(-LARGEST_STEP, LARGEST_STEP);
        let densities = self.densities.iter().enumerate().map(|(e, &q)| loss.moved(e, q, by(e))).collect();
        let at = self.at.iter().zip(&change.vertices).map(|(p, by)| *p + *by).collect();
        let moved = Self::of(densities, at, loss, shape);
        moved.merit(1.0).is_finite().then_some(moved)
    }

    fn squared_imbalance(&self) -> f64 {
        self.unbalanced.iter().map(|force| force.length_squared()).sum()
    }

    fn merit(&self, softness: f64) -> f64 {
        self.loss + self.squared_imbalance() / softness
    }
}

/// Computes the step from a state with this damping. Returns `None` if the linear system cannot be solved.
fn change(
    state: &State,
    members: &[Member],
    gradients: &[[f64; 2]],
    damping: Damping,
    step: &mut Step,
) -> Option<Change> {
    let system = step.system(members, damping);
    let factor = step.factorise(&system).ok()?;
    let change = factor.change(members, gradients, Some(&state.unbalanced)).ok();
    let storage = factor.into_storage();
    step.reuse(storage);
    change
}

/// Returns the mean square of the forces of the edges, and that of their lengths.
fn mean_squares(net: &Net, state: &State) -> (f64, f64) {
    let count = net.edges.len() as f64;
    let squares = |(edge, q): (&super::options::Edge, &f64)| {
        let length = length(edge.ends, &state.at);
        ((q * length).powi(2), length * length)
    };
    let sums = net.edges.iter().zip(&state.densities).map(squares).fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
    (sums.0 / count, sums.1 / count)
}

/// Finds densities and positions in equilibrium that come nearest to the targets.
///
/// # Errors
/// A cancel, or if no equilibrium is found near the given vertices and targets.
pub(super) fn fit(net: &Net, options: &Options, exec: &Execution) -> Result<Fitted, Error> {
    let shape = Shape::new(net).map_err(refused)?;
    is_late(net, exec)?;
    let mut step = Step::new(net, shape.fixed()).map_err(refused)?;
    let densities = start(net, options);
    let loss = Loss::new(net, options, &densities, &net.vertices);
    let mut state = State::of(densities, net.vertices.clone(), &loss, &shape);
    if !state.merit(1.0).is_finite() {
        return Err(Error::no_result(Reason::NoEquilibrium, "the loads and targets are too large for each other"));
    }
    let limit = options.max_iterations.unwrap_or(DEFAULT_STEPS);
    let (mut iterations, mut stop_reason) = (0, StopReason::Change);
    for stage in 0..STAGES {
        let tolerance = if stage + 1 < STAGES { STAGE_TOLERANCE } else { options.tolerance };
        let softness = STAGE_FACTOR.powi(stage as i32) * mean_squares(net, &state).0;
        stop_reason =
            descend(&mut state, &mut iterations, (limit, tolerance, softness), &loss, (&shape, &mut step), exec)?;
        if matches!(stop_reason, StopReason::Deadline | StopReason::MaxIterations) {
            break;
        }
    }
    let gradient = balance(&mut state, &loss, (&shape, &mut step), exec)?;
    let State { densities, at, loss, .. } = state;
    Ok(Fitted { densities, vertices: at, loss, gradient, iterations, stop_reason })
}

/// Lowers the merit of one stage, whose penalty parameter ε is `softness`.
fn descend(
    state: &mut State,
    iterations: &mut u32,
    (limit, tolerance, softness): (u32, f64, f64),
    loss: &Loss,
    (shape, step): (&Shape, &mut Step),
    exec: &Execution,
) -> Result<StopReason, Error> {
    let net = loss.net;
    let mut damping = DAMPING;
    let mut quiet = 0;
    while *iterations < limit {
        let members = members(loss, &state.densities, &state.at);
        let (_, squared_length) = mean_squares(net, state);
        let merit = state.merit(softness);
        // At most 51 passes, because each pass that refuses a step multiplies the damping by TIGHTENED, from
        // LEAST_DAMPING or more up to LARGEST_DAMPING.
        loop {
            if is_late(net, exec)? {
                return Ok(StopReason::Deadline);
            }
            let damped = Damping { densities: damping, positions: damping / squared_length, softness };
            let change = change(state, &members, &gradients(&members), damped, step);
            let moved = change.and_then(|change| state.moved(&change, loss, shape));
            if let Some(moved) = moved.filter(|moved| moved.merit(softness) < merit) {
                quiet = if merit - moved.merit(softness) <= tolerance * merit { quiet + 1 } else { 0 };
                *state = moved;
                damping = (RELAXED * damping).max(LEAST_DAMPING);
                break;
            }
            damping *= TIGHTENED;
            if damping > LARGEST_DAMPING {
                return Ok(StopReason::Stalled);
            }
        }
        *iterations += 1;
        report(exec, *iterations, limit, state.loss);
        // A merit this small is zero up to rounding errors.
        if quiet >= QUIET_STEPS || state.merit(softness) < f64::EPSILON * f64::EPSILON {
            return Ok(StopReason::Change);
        }
    }
    Ok(StopReason::MaxIterations)
}

/// Removes the unbalanced forces. Returns the largest derivative of the loss along a change that keeps the equilibrium:
/// by a logarithm, or by a position that is measured in root mean square edge lengths.
///
/// # Errors
/// A cancel, or if the forces cannot be balanced near this state.
fn balance(state: &mut State, loss: &Loss, (shape, step): (&Shape, &mut Step), exec: &Execution) -> Result<f64, Error> {
    let net = loss.net;
    let (squared_force, squared_length) = mean_squares(net, state);
    let damping = Damping { densities: 1.0, positions: 1.0 / squared_length, softness: 0.0 };
    let still = vec![[0.0; 2]; net.edges.len()];
    for _ in 0..CORRECTIONS {
        // A late caller still gets balanced forces, because a net without them is no result.
        is_late(net, exec)?;
        let plain: Vec<Member> =
            members(loss, &state.densities, &state.at).iter().map(Member::without_residuals).collect();
        let moved = change(state, &plain, &still, damping, step).and_then(|change| state.moved(&change, loss, shape));
        match moved.filter(|moved| moved.squared_imbalance() < state.squared_imbalance()) {
            Some(moved) => *state = moved,
            None => break,
        }
    }
    let left = state.unbalanced.iter().map(|force| force.length()).fold(0.0, f64::max);
    if left > BALANCED * squared_force.sqrt() {
        let detail = format!(
            "no equilibrium was found near the given vertices and targets: forces of {left:e} remain unbalanced"
        );
        return Err(Error::no_result(Reason::EquilibriumNotFound, detail));
    }
    let now = members(loss, &state.densities, &state.at);
    let plain: Vec<Member> = now.iter().map(Member::without_residuals).collect();
    let slope = change(state, &plain, &gradients(&now), damping, step);
    let Some(slope) = slope else { return Ok(f64::INFINITY) };
    let by_position = slope.vertices.iter().map(|by| by.length() / squared_length.sqrt());
    let largest = slope.logarithms.iter().map(|by| by.abs()).chain(by_position).fold(0.0, f64::max);
    Ok(2.0 * largest)
}
