//! The settling of a body: rounds of steps that lower the energy from any start, however far the equilibrium is.
//!
//! At the present shape each energy is replaced by springs (`Term::visit_springs`). Together with the energy's gradient
//! they give an upper bound that touches the energy at this shape. For a film the springs are the cotangent Laplacian
//! of the present triangles; for a segment of a cable of force F and length ℓ there is one spring of stiffness F / ℓ.
//! With the springs' matrix H the step d solves H d = -∇E, and on any mesh ω d lowers E for 0 < ω < 2. A chain of
//! springs F / ℓ has the stiffness F / L of its whole length L, so a corner moves by a whole span within a few rounds.
//! Every vertex slides freely: along its cable, along its support, within the film.
//!
//! - If no vertex slides on a support, the equations of x, y and z are not coupled. One scalar factorisation then
//!   serves the three right-hand sides.
//! - On a curved support the positive part of its curvature is added to H.
//! - A constraint adds a row to the system. The row of an elastic cable has a compliance.
//! - A step that breaks a triangle is halved, because any fraction of the step lowers the energy.
//! - While the energy falls and no triangle breaks, the step is doubled. Near the equilibrium the directions are those
//!   of conjugate gradients.
//!
//! Sources: majorisation and minimisation (Hunter, Lange, *A tutorial on MM algorithms*, 2004); for a film alone the
//! iteration is that of Pinkall and Polthier (1993).

mod springs;

use super::body::Body;
use super::constraint::Determined;
use super::dense::Lu;
use super::freedom::Freedom;
use plateau_mesh::measure::double_area_vector;
use plateau_mesh::sparse::{LinearError, Symbolic, Unsolved};
use plateau_mesh::{DVec3, Execution};
use springs::Springs;

/// Cosine of the largest angle by which a step may turn a triangle (60°). With any angle from 30° to 80° the solver
/// finds the equilibria of random structures equally often.
const LEAST_COSINE: f64 = 0.5;
/// Lowest quality 4 √3 A / Σ ℓ² of a triangle (area A, edges ℓ) that a step may cause freely. Below it, a step may at
/// most halve the quality of a triangle. With any value from 0.05 to 0.3 the solver finds the equilibria of random
/// structures equally often.
const LEAST_QUALITY: f64 = 0.15;
/// A step must lower the energy by this fraction of the decrease that its slope predicts (Armijo's condition).
const LEAST_GAIN: f64 = 1e-4;
/// An increase of the energy by less than this fraction of its magnitude is regarded as a rounding error.
const ROUNDING: f64 = 1e-12;
/// Shortest fraction of a step that the line search tries.
const LEAST_FRACTION: f64 = 1e-3;
/// Maximum number of fractions of a step that the line search tries. Halving from 1 down to [`LEAST_FRACTION`] takes
/// ten, and a first fraction above 1 takes one more.
const MOST_FRACTIONS: u32 = 16;
/// Directions are made conjugate only if no vertex moves farther than this, in edge lengths, in the whole step of the
/// springs.
const CONJUGATE_BELOW: f64 = 0.5;
/// A step is doubled only while it is less than this multiple of the step that the springs give.
const LONGEST_FACTOR: f64 = 30.0;
/// Limits of the steps, and whether they are accelerated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// ω, the multiple of the springs' step that is tried first.
    pub relaxation: f64,
    /// Largest motion of a vertex in the first fraction that is tried, in edge lengths.
    pub longest: f64,
    /// Whether steps may be lengthened and directions made conjugate.
    pub accelerated: bool,
}

impl Pace {
    /// Over-relaxed and accelerated steps, of any length.
    pub const BOLD: Self = Self { relaxation: 1.5, longest: f64::INFINITY, accelerated: true };
    /// Short steps without acceleration, which follow the gradient flow.
    pub const CAUTIOUS: Self = Self { relaxation: 1.0, longest: 0.2, accelerated: false };
}

/// The result of a round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// The largest motion of a vertex in the whole step that the springs give.
    pub step: f64,
    /// The fraction of the direction that was taken. It is 0 if no fraction keeps the mesh intact and lowers the
    /// energy.
    pub fraction: f64,
    /// The largest motion of a vertex in the fraction that was taken.
    pub moved: f64,
    pub energy: f64,
}

/// The state that each round passes to the next: the multipliers and the last direction.
#[derive(Clone, Debug, Default)]
pub struct Settler {
    /// The multiplier of each constraint. The caller sets the initial values.
    pub multipliers: Vec<f64>,
    last: Option<Last>,
}

#[derive(Clone, Debug)]
struct Last {
    gradient: Vec<DVec3>,
    slope: f64,
    direction: Vec<DVec3>,
}

/// The row that a constraint adds to the system.
struct Row {
    gradient: Vec<DVec3>,
    compliance: f64,
    missing: f64,
}

impl Settler {
    /// Forgets the last direction. This is needed after a change of the mesh.
    pub fn restart(&mut self) {
        self.last = None;
    }

    /// Moves the body's vertices by one round. `edge` is the edge length of the mesh. Constraints that are kept at a
    /// value or yield are taken into account; those that are determined by a condition are ignored. The round looks at
    /// the signal before and after the sparse factorisation, which takes most of its time.
    ///
    /// # Errors
    /// [`Unsolved`]; the body is then as it was before.
    pub fn round(&mut self, body: &mut Body, edge: f64, pace: Pace, exec: &Execution) -> Result<Round, Unsolved> {
        let at = body.vertices.clone();
        self.multipliers.resize(body.constraints.len(), 0.0);
        let mut gradient = vec![DVec3::ZERO; at.len()];
        body.terms.iter().for_each(|term| term.add_gradient(&at, &mut gradient));
        let (mut rows, mut of_row) = (Vec::new(), Vec::new());
        for (k, constraint) in body.constraints.iter().enumerate() {
            let (excess, compliance) = match constraint.by {
                Determined::Value(value) => (constraint.quantity.value(&at) - value, 0.0),
                Determined::Yielding { value, compliance } => {
                    let excess = constraint.quantity.value(&at) - value;
                    self.multipliers[k] = (-excess / compliance).max(0.0);
                    if self.multipliers[k] == 0.0 {
                        continue;
                    }
                    (0.0, compliance)
                }
                Determined::Condition(_) => continue,
            };
            let mut own = vec![DVec3::ZERO; at.len()];
            constraint.quantity.add_gradient(&at, &mut own);
            gradient.iter_mut().zip(&own).for_each(|(sum, own)| *sum -= self.multipliers[k] * *own);
            rows.push(Row { gradient: own, compliance, missing: -excess });
            of_row.push(k);
        }
        let (direction, changes) = self.direction(body, &at, &gradient, &rows, exec)?;
        for (&k, change) in of_row.iter().zip(changes) {
            self.multipliers[k] -= change;
        }
        let constrained = rows.iter().any(|row| row.compliance == 0.0);
        let slope = -dot(&gradient, &direction);
        let step = largest(&direction);
        let mut chosen = direction.clone();
        if let Some(last) = self.last.take()
            && pace.accelerated
            && !constrained
            && step < CONJUGATE_BELOW * edge
            && last.gradient.len() == gradient.len()
        {
            let against: f64 =
                direction.iter().zip(&gradient).zip(&last.gradient).map(|((d, g), h)| d.dot(*g - *h)).sum();
            let beta = (-against / last.slope).max(0.0);
            let conjugate: Vec<DVec3> = direction.iter().zip(&last.direction).map(|(d, e)| *d + beta * *e).collect();
            if -dot(&gradient, &conjugate) >= 0.1 * slope {
                chosen = conjugate;
            }
        }
        let before = energy(body, &at);
        let is_conjugate = chosen != direction;
        let tries = if is_conjugate { vec![chosen, direction] } else { vec![direction] };
        for (n, direction) in tries.into_iter().enumerate() {
            let length = largest(&direction).max(f64::MIN_POSITIVE);
            let slope = -dot(&gradient, &direction);
            let conjugate = is_conjugate && n == 0;
            let cap = if conjugate { pace.longest.min(1.0) } else { pace.longest } * edge / length;
            let whole = if constrained || conjugate { 1.0 } else { pace.relaxation };
            let Some((places, fraction, after)) =
                search(body, &at, &direction, whole.min(cap), before, slope, constrained, |fraction| {
                    pace.accelerated && !constrained && 2.0 * fraction * length < edge && fraction < LONGEST_FACTOR
                })
            else {
                continue;
            };
            body.vertices = places;
            self.last = Some(Last { gradient, slope, direction });
            return Ok(Round { step, fraction, moved: fraction * length, energy: after });
        }
        Ok(Round { step, fraction: 0.0, moved: 0.0, energy: before })
    }

    /// Solves the system of the springs and of `rows`. Returns the displacement of each vertex, and the decrease of the
    /// multiplier of each row.
    fn direction(
        &self,
        body: &Body,
        at: &[DVec3],
        gradient: &[DVec3],
        rows: &[Row],
        exec: &Execution,
    ) -> Result<(Vec<DVec3>, Vec<f64>), Unsolved> {
        let springs = Springs::new(body, at, gradient, &self.multipliers);
        let mut right = Vec::new();
        springs.reduce(gradient, &mut right);
        rows.iter().for_each(|row| springs.reduce(&row.gradient, &mut right));
        exec.look(at.len() as u64)?;
        let factorised = Symbolic::analyse(&springs.matrix, None)?;
        factorised.factorise(&springs.matrix)?.solve(&mut right)?;
        exec.look(at.len() as u64)?;
        let mut solutions = right.chunks_exact(springs.order().max(1)).map(|solution| springs.displacements(solution));
        let Some(mut direction) = solutions.next() else { return Ok((vec![DVec3::ZERO; at.len()], Vec::new())) };
        direction.iter_mut().for_each(|d| *d = -*d);
        let of_rows: Vec<Vec<DVec3>> = solutions.collect();
        let schur = Lu::new(rows.len(), |i, j| {
            dot(&rows[i].gradient, &of_rows[j]) + if i == j { rows[i].compliance } else { 0.0 }
        });
        let wanted: Vec<f64> = rows.iter().map(|row| dot(&row.gradient, &direction) - row.missing).collect();
        let changes = schur.solve(&wanted);
        if changes.iter().any(|change| !change.is_finite()) {
            return Err(LinearError::Singular.into());
        }
        for (change, own) in changes.iter().zip(&of_rows) {
            direction.iter_mut().zip(own).for_each(|(d, y)| *d -= *change * *y);
        }
        Ok((direction, changes))
    }
}

fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

fn largest(vectors: &[DVec3]) -> f64 {
    vectors.iter().map(|vector| vector.length()).fold(0.0, f64::max)
}

/// The energy that the rounds lower: the sum of the terms and of the energies stored in the constraints that yield.
pub fn energy(body: &Body, at: &[DVec3]) -> f64 {
    let yielding = body.constraints.iter().map(|constraint| match constraint.by {
        Determined::Yielding { value, compliance } => {
            let force = ((value - constraint.quantity.value(at)) / compliance).max(0.0);
            0.5 * compliance * force * force
        }
        Determined::Value(_) | Determined::Condition(_) => 0.0,
    });
    body.terms.iter().map(|term| term.value(at)).sum::<f64>() + yielding.sum::<f64>()
}

fn moved(body: &Body, at: &[DVec3], direction: &[DVec3], fraction: f64) -> Vec<DVec3> {
    let one = |((freedom, &place), &d): ((&Freedom, &DVec3), &DVec3)| match freedom.support() {
        Some(support) => body.supports[support as usize].nearest(place + fraction * d),
        None => place + fraction * d,
    };
    body.freedoms.iter().zip(at).zip(direction).map(one).collect()
}

/// Line search along `direction`. Halves the fraction `first` until the step keeps the mesh intact and lowers the
/// energy; with `constrained` it only has to keep the mesh intact. Then doubles the fraction while `may_lengthen`
/// allows it and the energy falls. Returns the positions, the fraction and the energy there, or `None` if no fraction
/// is accepted.
#[expect(clippy::too_many_arguments, reason = "a line search: everything it has is needed at each step")]
fn search(
    body: &Body,
    at: &[DVec3],
    direction: &[DVec3],
    first: f64,
    before: f64,
    slope: f64,
    constrained: bool,
    may_lengthen: impl Fn(f64) -> bool,
) -> Option<(Vec<DVec3>, f64, f64)> {
    let (mut fraction, mut tried) = (first, 0);
    // At most MOST_FRACTIONS passes, because `tried` counts them. The fraction of an infinite direction may be 0, which
    // halving does not change.
    while tried < MOST_FRACTIONS && fraction >= LEAST_FRACTION * first.min(1.0) {
        tried += 1;
        let places = moved(body, at, direction, fraction);
        if keeps_mesh(body.triangles(), at, &places) {
            let after = energy(body, &places);
            if constrained || after <= before - LEAST_GAIN * fraction * slope + ROUNDING * before.abs() {
                let mut best = (places, fraction, after);
                // At most 16 passes, because the fraction doubles from LEAST_FRACTION or more, and only while it is
                // below LONGEST_FACTOR.
                while may_lengthen(best.1) {
                    let places = moved(body, at, direction, 2.0 * best.1);
                    if !keeps_mesh(body.triangles(), at, &places) {
                        break;
                    }
                    let after = energy(body, &places);
                    if after >= best.2 {
                        break;
                    }
                    best = (places, 2.0 * best.1, after);
                }
                // Try the minimum of the parabola that has the slope and the energies at both ends.
                let bend = best.2 - before + best.1 * slope;
                if may_lengthen(0.0) && bend > 0.0 {
                    let bottom = best.1 * best.1 * slope / (2.0 * bend);
                    if may_lengthen(0.5 * bottom) {
                        let places = moved(body, at, direction, bottom);
                        if keeps_mesh(body.triangles(), at, &places) {
                            let after = energy(body, &places);
                            if after < best.2 {
                                best = (places, bottom, after);
                            }
                        }
                    }
                }
                return Some(best);
            }
        }
        fraction = if fraction > 1.0 { 1.0 } else { 0.5 * fraction };
    }
    None
}

/// Whether a step keeps every triangle intact: none turns by too large an angle, and none becomes too thin.
pub(crate) fn keeps_mesh(triangles: &[[u32; 3]], before: &[DVec3], after: &[DVec3]) -> bool {
    let quality = |[p, q, r]: [DVec3; 3], double_area: f64| {
        let squares = p.distance_squared(q) + q.distance_squared(r) + r.distance_squared(p);
        2.0 * 3f64.sqrt() * double_area / squares.max(f64::MIN_POSITIVE)
    };
    triangles.iter().all(|triangle| {
        let (old, new) = (triangle.map(|v| before[v as usize]), triangle.map(|v| after[v as usize]));
        let (normal, turned) = (double_area_vector(old), double_area_vector(new));
        let (size, grown) = (normal.length(), turned.length());
        let is = quality(new, grown);
        normal.dot(turned) >= LEAST_COSINE * size * grown && (is >= LEAST_QUALITY || is >= 0.5 * quality(old, size))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::finite_differences::patch;
    use plateau_mesh::complex::Complex;
    use plateau_mesh::{Interruption, Signal};
    use std::cell::Cell;

    #[test]
    fn a_round_looks_at_the_signal_on_both_sides_of_its_factorisation() {
        let (vertices, triangles) = patch();
        let complex = Complex::build(triangles, vertices.len()).unwrap();
        for looks in [0, 1, 2] {
            let mut body = Body::new(vertices.clone(), &complex, &[1.0]);
            let seen = Cell::new(0);
            let signal = || {
                seen.set(seen.get() + 1);
                if seen.get() > looks { Signal::Cancel } else { Signal::Continue }
            };
            let round = Settler::default().round(&mut body, 1.0, Pace::BOLD, &Execution::new(&signal, &|_| {}));
            if looks < 2 {
                assert_eq!(round, Err(Unsolved::Interrupted(Interruption::Cancelled)), "{looks} looks");
                assert_eq!(body.vertices, vertices);
            } else {
                assert!(round.unwrap().moved > 0.0);
                assert_ne!(body.vertices, vertices);
            }
        }
    }
}
