//! Anderson's mixing, which accelerates a fixed-point iteration x ← g(x).
//!
//! Let f = g(x) - x be the residual of a round, and Δx and Δf the differences between rounds. The next x is
//! g - Σ γ (Δx + Δf) with the coefficients γ for which Σ γ Δf comes nearest to f. For a linear iteration this is GMRES
//! on a window of rounds. Source: Walker, Ni, *Anderson Acceleration for Fixed-Point Iterations* (2011).

/// Maximum number of differences that are kept. With a larger number the oldest differences belong to a shape that is
/// far away.
const WINDOW: usize = 8;
/// A difference Δf is left out if its part outside the span of the newer differences is at most this fraction of it,
/// because its coefficient would consist of rounding errors.
const INDEPENDENT: f64 = 1e-7;
/// If the residual grows by more than this factor in a round, all differences are dropped, because the iteration is far
/// from linear.
const GROWTH: f64 = 2.0;

#[derive(Debug, Default)]
pub(super) struct Mixing {
    last: Option<(Vec<f64>, Vec<f64>)>,
    /// Δf and Δx + Δf, the newest last.
    differences: Vec<(Vec<f64>, Vec<f64>)>,
}

impl Mixing {
    /// The next x after a round that led from `x` to `g`.
    pub fn next(&mut self, x: Vec<f64>, g: Vec<f64>) -> Vec<f64> {
        let f: Vec<f64> = g.iter().zip(&x).map(|(g, x)| g - x).collect();
        if let Some((last_x, last_f)) = self.last.take() {
            if dot(&f, &f) > GROWTH * GROWTH * dot(&last_f, &last_f) {
                self.differences.clear();
            } else {
                let of_f: Vec<f64> = f.iter().zip(&last_f).map(|(f, last)| f - last).collect();
                let both = x.iter().zip(&last_x).zip(&of_f).map(|((x, last), f)| x - last + f).collect();
                self.differences.push((of_f, both));
                if self.differences.len() > WINDOW {
                    self.differences.remove(0);
                }
            }
        }
        // Gram and Schmidt's method on the Δf, from the newest to the oldest, with the same combinations of Δx + Δf.
        let mut basis: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
        let mut next = g;
        for (of_f, both) in self.differences.iter().rev() {
            let (mut of_f, mut both) = (of_f.clone(), both.clone());
            let before = dot(&of_f, &of_f).sqrt();
            for (unit, image) in &basis {
                let share = dot(unit, &of_f);
                subtract(&mut of_f, share, unit);
                subtract(&mut both, share, image);
            }
            let norm = dot(&of_f, &of_f).sqrt();
            if norm <= INDEPENDENT * before {
                continue;
            }
            of_f.iter_mut().chain(&mut both).for_each(|value| *value /= norm);
            subtract(&mut next, dot(&of_f, &f), &both);
            basis.push((of_f, both));
        }
        self.last = Some((x, f));
        next
    }

    /// Forgets all rounds.
    pub fn clear(&mut self) {
        *self = Self::default();
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn subtract(from: &mut [f64], share: f64, vector: &[f64]) {
    from.iter_mut().zip(vector).for_each(|(from, value)| *from -= share * value);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_iteration_ends_after_as_many_rounds_as_unknowns() {
        // x ← A x + b with slow, oscillating and growing parts, and the fixed point (1, 2, 3).
        let factors = [0.95, -0.9, 1.2];
        let mut x = vec![0.0; 3];
        let mut mixing = Mixing::default();
        for _ in 0..5 {
            let g = x.iter().zip(factors).zip([1.0, 2.0, 3.0]).map(|((x, a), fixed)| fixed + a * (x - fixed)).collect();
            x = mixing.next(x, g);
        }
        assert!(x.iter().zip([1.0, 2.0, 3.0]).all(|(x, fixed)| (x - fixed).abs() < 1e-9), "{x:?}");
    }
}
