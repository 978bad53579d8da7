//! The loss of a net, its residuals and their derivatives.

use super::options::{Edge, Net, Options};
use super::shape::Shape;
use plateau_mesh::DVec3;
use plateau_mesh::sparse::LinearError;

/// A target counts as missed by far if the relative deviation from it exceeds this.
pub const FAR: f64 = 0.5;

/// A residual of an edge, with its derivatives by s = ln |q| and by the edge's length.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Residual {
    pub value: f64,
    pub by_s: f64,
    pub by_length: f64,
}

/// Sums over the residuals r of one edge, in the order of the fields: r², r r_s, r r_ℓ, r_s², r_s r_ℓ, r_ℓ². Here r_s
/// and r_ℓ are the derivatives by s and by the length.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    pub loss: f64,
    pub g_s: f64,
    pub g_l: f64,
    pub h_ss: f64,
    pub h_sl: f64,
    pub h_ll: f64,
}

impl Sums {
    fn of(residuals: &[Residual; 3]) -> Self {
        residuals.iter().fold(Self::default(), |sums, residual| Self {
            loss: sums.loss + residual.value * residual.value,
            g_s: sums.g_s + residual.value * residual.by_s,
            g_l: sums.g_l + residual.value * residual.by_length,
            h_ss: sums.h_ss + residual.by_s * residual.by_s,
            h_sl: sums.h_sl + residual.by_s * residual.by_length,
            h_ll: sums.h_ll + residual.by_length * residual.by_length,
        })
    }
}

/// The loss of a net with its targets and weights.
pub(super) struct Loss<'a> {
    pub net: &'a Net,
    /// The least density.
    pub least: f64,
    /// √(w_F / n_F), the factor of a force's relative deviation in its residual.
    pub force: f64,
    /// √(w_L / n_L), the factor of a length's relative deviation in its residual.
    pub length: f64,
    /// √(w_P / P0), the factor of the load path in its residual.
    load_path: f64,
    /// Edges whose density the next step must not change: held densities, and densities at the lower bound that the
    /// gradient would lower.
    stays: Vec<bool>,
}

impl<'a> Loss<'a> {
    pub fn new(net: &'a Net, options: &Options, densities: &[f64], at: &[DVec3]) -> Self {
        let share = |weight: f64, count: usize| if count == 0 { 0.0 } else { (weight / count as f64).sqrt() };
        let forces = net.edges.iter().filter(|edge| edge.force.is_some()).count();
        let lengths = net.edges.iter().filter(|edge| edge.length.is_some()).count();
        let path: f64 = net.edges.iter().zip(densities).map(|(edge, q)| q.abs() * length(edge.ends, at).powi(2)).sum();
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
    pub fn slope(&self, e: usize, q: f64) -> f64 {
        if self.stays[e] { 0.0 } else { q }
    }

    /// Returns the density of an edge after its logarithm has changed by `change`. A held density stays the same.
    pub fn moved(&self, e: usize, q: f64, change: f64) -> f64 {
        if self.net.edges[e].held { q } else { q.signum() * (q.abs() * libm::exp(change)).max(self.least) }
    }

    /// Updates `stays`: marks the densities that the next step must not change.
    pub fn hold(&mut self, densities: &[f64], at: &[DVec3], shape: &Shape) -> Result<(), LinearError> {
        self.stays = self.net.edges.iter().map(|edge| edge.held).collect();
        let least = self.least;
        if densities.iter().any(|q| q.abs() <= least) {
            let gradient = self.gradient(densities, at, shape)?;
            let lowest = densities.iter().zip(&gradient).map(|(q, g)| q.abs() <= least && *g >= 0.0);
            self.stays.iter_mut().zip(lowest).for_each(|(stays, lowest)| *stays |= lowest);
        }
        Ok(())
    }

    /// Returns the relative deviation of an edge from each of its targets of positive weight: from the force, then from
    /// the length.
    pub fn deviations(&self, e: usize, q: f64, at: &[DVec3]) -> [Option<f64>; 2] {
        let edge = &self.net.edges[e];
        let length = length(edge.ends, at);
        let off = |value: f64, target: Option<f64>| target.map(|target| (value / target - 1.0).abs());
        let force = edge.force.filter(|_| self.force > 0.0);
        [off(q * length, force), off(length, edge.length.filter(|_| self.length > 0.0))]
    }

    /// Whether any target is missed by far.
    pub fn is_far(&self, densities: &[f64], at: &[DVec3]) -> bool {
        let far = |(e, q): (usize, &f64)| self.deviations(e, *q, at).into_iter().flatten().any(|off| off > FAR);
        densities.iter().enumerate().any(far)
    }

    /// Returns the three residuals of an edge: of its force, of its length and of the load path. A residual without a
    /// target is zero.
    pub fn residuals(&self, e: usize, q: f64, at: &[DVec3]) -> [Residual; 3] {
        let edge = &self.net.edges[e];
        let (length, p) = (length(edge.ends, at), self.slope(e, q));
        let mut residuals = [Residual::default(); 3];
        if let Some(target) = edge.force {
            let factor = self.force / target;
            residuals[0] =
                Residual { value: factor * q * length - self.force, by_s: factor * p * length, by_length: factor * q };
        }
        if let Some(target) = edge.length {
            let (value, by_length) = (self.length * (length / target - 1.0), self.length / target);
            residuals[1] = Residual { value, by_s: 0.0, by_length };
        }
        if self.load_path > 0.0 {
            let root = self.load_path * q.abs().sqrt();
            residuals[2] = Residual { value: root * length, by_s: 0.5 * (p / q) * root * length, by_length: root };
        }
        residuals
    }

    pub fn sums(&self, e: usize, q: f64, at: &[DVec3]) -> Sums {
        Sums::of(&self.residuals(e, q, at))
    }

    pub fn value(&self, densities: &[f64], at: &[DVec3]) -> f64 {
        densities.iter().enumerate().map(|(e, &q)| self.sums(e, q, at).loss).sum()
    }

    /// Returns the derivative of half the loss by each logarithm s, computed with the adjoint equations: it is g_s - p
    /// ℓ u·Δλ, where D λ is the derivative of half the loss by the positions (notation of [`fitting`](super::fitting)).
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
        let derivative = |(e, sums): (usize, &Sums)| {
            let [a, b] = self.net.edges[e].ends;
            let edge = at[b as usize] - at[a as usize];
            sums.g_s - self.slope(e, densities[e]) * edge.dot(lambda[b as usize] - lambda[a as usize])
        };
        Ok(sums.iter().enumerate().map(derivative).collect())
    }
}

pub(super) fn length([a, b]: [u32; 2], at: &[DVec3]) -> f64 {
    at[a as usize].distance(at[b as usize])
}

pub(super) fn unit([a, b]: [u32; 2], at: &[DVec3]) -> DVec3 {
    (at[b as usize] - at[a as usize]).normalize_or_zero()
}

/// Returns the densities with which fitting begins. An edge has its given density, or else its target force divided by
/// its target length (or by its present length). Edges with neither have the mean of the other densities, or 1 if there
/// are none. The densities of struts are negative.
pub(super) fn start(net: &Net, options: &Options) -> Vec<f64> {
    let given = |edge: &Edge| {
        let length = length(edge.ends, &net.vertices).max(f64::MIN_POSITIVE);
        edge.density.or_else(|| edge.force.map(|force| force / edge.length.unwrap_or(length))).map(f64::abs)
    };
    let known: Vec<f64> = net.edges.iter().filter_map(given).filter(|q| q.is_finite()).collect();
    let mean = if known.is_empty() { 1.0 } else { known.iter().sum::<f64>() / known.len() as f64 };
    let found = |edge: &Edge| {
        let size = given(edge).filter(|q| q.is_finite()).unwrap_or(mean);
        let size = if edge.held { size } else { size.max(options.least_density) };
        if edge.strut { -size } else { size }
    };
    net.edges.iter().map(found).collect()
}
