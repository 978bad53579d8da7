//! Levenberg and Marquardt's method: damped Gauss-Newton steps that minimise ½ Σ r², a function of nodes with N
//! unknowns each.
//!
//! Source: Madsen, Nielsen, Tingleff, *Methods for Non-Linear Least Squares Problems* (2004), algorithm 3.16. A step δ
//! solves (JᵀJ + μM) δ = -Jᵀr. The caller provides the metric M, which is the identity in the source. Another metric
//! can make the steps independent of the choice of the unknowns. The damping μ follows the ratio of the actual decrease
//! of the energy to the decrease that the linear model predicts (Nielsen's rule). Every accepted step lowers the
//! energy.

use super::pattern::BlockPattern;
use super::{Symbolic, SymmetricMatrix};
use crate::execution::{Execution, Interruption};

/// Largest damping μ, in units of the metric. A run in which no step lowers the energy ends above it, because steps are
/// then too short to matter.
const LARGEST_DAMPING: f64 = 1e9;
const LEAST_DAMPING: f64 = 1e-15;

/// A sum of squares that is minimised over the locations of nodes.
pub trait LeastSquares<const N: usize> {
    /// The location of a node.
    type Location: Clone;
    /// Calls `couple` with the nodes of each residual that depends on more than one node.
    fn couplings(&self, couple: &mut dyn FnMut(&[u32]));
    /// The energy ½ Σ r². Infinite if the locations are not allowed.
    fn energy(&mut self, x: &[Self::Location]) -> f64;
    /// Adds every residual with its derivatives to the normal equations.
    fn assemble(&mut self, x: &[Self::Location], normal: &mut NormalEquations<N>);
    /// A node's block of the metric M at the locations of the last [`assemble`](Self::assemble). It must be symmetric
    /// and positive definite.
    fn metric(&self, node: usize) -> [[f64; N]; N];
    /// Takes the largest part of a step that is allowed: writes the new locations to `to`, and returns the part as a
    /// fraction of the step.
    fn advance(&self, x: &[Self::Location], step: &[[f64; N]], to: &mut [Self::Location]) -> f64;
}

/// The matrix JᵀJ on a fixed pattern, and the gradient Jᵀr.
#[derive(Debug)]
pub struct NormalEquations<const N: usize> {
    pattern: BlockPattern,
    matrix: SymmetricMatrix,
    gradient: Vec<[f64; N]>,
}

impl<const N: usize> NormalEquations<N> {
    fn new(nodes: usize, couplings: impl FnOnce(&mut dyn FnMut(&[u32]))) -> Self {
        let pattern = BlockPattern::new(&vec![N as u8; nodes], couplings);
        let matrix = pattern.matrix();
        Self { pattern, matrix, gradient: vec![[0.0; N]; nodes] }
    }

    fn clear(&mut self) {
        self.matrix.values.fill(0.0);
        self.gradient.fill([0.0; N]);
    }

    /// Adds a residual with its derivatives with respect to the unknowns of its nodes.
    pub fn add(&mut self, residual: f64, nodes: &[u32], derivatives: &[[f64; N]]) {
        for (&v, by_v) in nodes.iter().zip(derivatives) {
            for (sum, derivative) in self.gradient[v as usize].iter_mut().zip(by_v) {
                *sum += derivative * residual;
            }
            for (&w, by_w) in nodes.iter().zip(derivatives) {
                let Some(position) = self.pattern.position(v, w) else { continue };
                for (i, a) in by_v.iter().enumerate() {
                    for (j, b) in by_w.iter().enumerate() {
                        self.matrix.values[position.at(i, j)] += a * b;
                    }
                }
            }
        }
    }

    /// The largest diagonal entry of JᵀJ.
    pub fn largest_diagonal(&self) -> f64 {
        (0..self.matrix.order()).map(|row| self.matrix.diagonal(row)).fold(0.0, f64::max)
    }

    /// The largest absolute entry of the gradient. Infinite if an entry is not a number, because such a gradient must
    /// not count as vanishing.
    fn largest_gradient(&self) -> f64 {
        let entries = self.gradient.iter().flatten();
        entries.fold(0.0, |max, g| if g.is_nan() { f64::INFINITY } else { f64::max(max, g.abs()) })
    }

    /// Adds μM to the matrix.
    fn damp(&mut self, damping: f64, metric: impl Fn(usize) -> [[f64; N]; N]) {
        for node in 0..self.gradient.len() {
            let Some(position) = self.pattern.position(node as u32, node as u32) else { continue };
            let block = metric(node);
            for (i, row) in block.iter().enumerate() {
                for (j, entry) in row.iter().enumerate() {
                    self.matrix.values[position.at(i, j)] += damping * entry;
                }
            }
        }
    }
}

/// The stopping criteria of a run, and its initial damping.
#[derive(Clone, Copy, Debug)]
pub struct Criteria {
    /// The damping μ at the start, in units of the metric.
    pub damping: f64,
    /// A step is quiet if it lowers the energy F by at most this times (F + `floor`).
    pub change: f64,
    /// Added to F in the criteria. With 1 the criteria are absolute where F is small, with 0 they are relative.
    pub floor: f64,
    /// Number of quiet steps in a row that ends the run.
    pub quiet_steps: u32,
    /// A gradient whose entries are at most this times (F + `floor`) ends the run.
    pub gradient: f64,
    /// A step δ whose entries are at most this times (1 + ‖δ‖∞) ends the run.
    pub step: f64,
    /// Largest number of steps that are tried.
    pub max_iterations: u64,
}

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The last steps lowered the energy by too little.
    Change,
    /// The gradient vanishes.
    Gradient,
    /// The step vanishes.
    Step,
    MaxIterations,
    NoUnknowns,
    /// No damping makes a step that lowers the energy.
    NoStep,
    Interrupted(Interruption),
}

/// Receives the number of each step that was tried, and the best locations and energy so far.
pub(crate) type Observer<'a, Location> = dyn FnMut(u64, &[Location], f64) + 'a;

/// Lowers the problem's energy, starting at `x`, until a criterion holds. The locations `x` must be allowed. Returns
/// why the run ended, and the final energy.
///
/// `observe` receives the best locations and energy after every step that was tried. `execution.look` is called once
/// per step, which takes one sparse factorisation. On an interruption `x` holds the best locations so far.
pub fn minimise<const N: usize, P: LeastSquares<N>>(
    problem: &mut P,
    x: &mut Vec<P::Location>,
    criteria: Criteria,
    observe: &mut Observer<'_, P::Location>,
    execution: &Execution<'_>,
) -> (Stop, f64) {
    let mut energy = problem.energy(x);
    if x.is_empty() {
        return (Stop::NoUnknowns, energy);
    }
    let mut normal = NormalEquations::<N>::new(x.len(), |couple| problem.couplings(couple));
    let Ok(symbolic) = Symbolic::analyse(&normal.matrix, None) else { return (Stop::NoStep, energy) };
    problem.assemble(x, &mut normal);
    let mut undamped = normal.matrix.values.clone();
    let (mut damping, mut growth, mut quiet) = (criteria.damping, 2.0, 0);
    let mut trial = x.clone();
    let mut solution = vec![0.0; N * x.len()];
    let mut step = vec![[0.0; N]; x.len()];
    let mut storage = Vec::new();
    for iteration in 1..=criteria.max_iterations {
        if normal.largest_gradient() <= criteria.gradient * (criteria.floor + energy) {
            return (Stop::Gradient, energy);
        }
        let work = 2 * normal.matrix.columns.len() + symbolic.factor_entries();
        if let Err(interruption) = execution.look(work as u64) {
            return (Stop::Interrupted(interruption), energy);
        }
        normal.matrix.values.copy_from_slice(&undamped);
        normal.damp(damping, |node| problem.metric(node));
        for (entry, g) in solution.iter_mut().zip(normal.gradient.iter().flatten()) {
            *entry = -g;
        }
        let factors = symbolic.factorise_into(&normal.matrix, std::mem::take(&mut storage));
        let solved = factors.and_then(|factors| {
            let solved = factors.solve(&mut solution);
            storage = factors.into_storage();
            solved
        });
        let mut accepted = false;
        if solved.is_ok() {
            let largest = solution.iter().fold(0.0, |max: f64, d| max.max(d.abs()));
            if largest <= criteria.step * (1.0 + largest) {
                return (Stop::Step, energy);
            }
            for (node, entries) in step.iter_mut().zip(solution.chunks_exact(N)) {
                node.copy_from_slice(entries);
            }
            let share = problem.advance(x, &step, &mut trial);
            let reached = problem.energy(&trial);
            accepted = reached < energy;
            if accepted {
                let ratio =
                    (energy - reached) / predicted(&step, &normal.gradient, damping, share, |k| problem.metric(k));
                quiet = if energy - reached <= criteria.change * (criteria.floor + reached) { quiet + 1 } else { 0 };
                energy = reached;
                std::mem::swap(x, &mut trial);
                damping = f64::max(damping * (1.0 - (2.0 * ratio - 1.0).powi(3)).max(1.0 / 3.0), LEAST_DAMPING);
                growth = 2.0;
            }
        }
        observe(iteration, x, energy);
        if quiet == criteria.quiet_steps {
            return (Stop::Change, energy);
        }
        if accepted {
            normal.clear();
            problem.assemble(x, &mut normal);
            undamped.copy_from_slice(&normal.matrix.values);
        } else {
            damping *= growth;
            growth *= 2.0;
            if damping.is_nan() || damping > LARGEST_DAMPING {
                return (Stop::NoStep, energy);
            }
        }
    }
    (Stop::MaxIterations, energy)
}

/// The decrease of the energy that the linear model predicts for the fraction s (`share`) of a step δ: -s (1 - s/2) gᵀδ
/// + ½ s² μ δᵀMδ.
fn predicted<const N: usize>(
    step: &[[f64; N]],
    gradient: &[[f64; N]],
    damping: f64,
    share: f64,
    metric: impl Fn(usize) -> [[f64; N]; N],
) -> f64 {
    let (mut slope, mut length) = (0.0, 0.0);
    for (node, (d, g)) in step.iter().zip(gradient).enumerate() {
        let block = metric(node);
        for i in 0..N {
            slope += g[i] * d[i];
            length += (0..N).map(|j| d[i] * block[i][j] * d[j]).sum::<f64>();
        }
    }
    -share * (1.0 - 0.5 * share) * slope + 0.5 * share * share * damping * length
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rosenbrock's valley with the residuals r = (10 (y - x²), 1 - x): one node with two unknowns. The length of a
    /// step is limited to `longest`.
    struct Valley {
        longest: f64,
    }

    impl LeastSquares<2> for Valley {
        type Location = [f64; 2];
        fn couplings(&self, _: &mut dyn FnMut(&[u32])) {}
        fn energy(&mut self, x: &[[f64; 2]]) -> f64 {
            let [x, y] = x[0];
            50.0 * (y - x * x).powi(2) + 0.5 * (1.0 - x).powi(2)
        }
        fn assemble(&mut self, x: &[[f64; 2]], normal: &mut NormalEquations<2>) {
            let [x, y] = x[0];
            normal.add(10.0 * (y - x * x), &[0], &[[-20.0 * x, 10.0]]);
            normal.add(1.0 - x, &[0], &[[-1.0, 0.0]]);
        }
        fn metric(&self, _: usize) -> [[f64; 2]; 2] {
            [[1.0, 0.0], [0.0, 1.0]]
        }
        fn advance(&self, x: &[[f64; 2]], step: &[[f64; 2]], to: &mut [[f64; 2]]) -> f64 {
            let [dx, dy] = step[0];
            let share = f64::min(1.0, self.longest / libm::hypot(dx, dy));
            to[0] = [x[0][0] + share * dx, x[0][1] + share * dy];
            share
        }
    }

    const CRITERIA: Criteria = Criteria {
        damping: 1e-3,
        change: 1e-20,
        floor: 0.0,
        quiet_steps: 3,
        gradient: 0.0,
        step: 0.0,
        max_iterations: 200,
    };

    #[test]
    fn the_valley_is_followed_to_its_least_point() {
        for longest in [f64::INFINITY, 0.1] {
            let mut x = vec![[-1.2, 1.0]];
            let (mut last, mut steps) = (f64::INFINITY, 0);
            let mut observe = |_: u64, _: &[[f64; 2]], energy: f64| {
                assert!(energy <= last);
                (last, steps) = (energy, steps + 1);
            };
            let (stop, energy) =
                minimise(&mut Valley { longest }, &mut x, CRITERIA, &mut observe, &Execution::default());
            assert_ne!(stop, Stop::MaxIterations);
            assert!(
                energy < 1e-24 && libm::hypot(x[0][0] - 1.0, x[0][1] - 1.0) < 1e-10 && steps < 100,
                "{x:?} {steps}"
            );
        }
    }

    #[test]
    fn each_criterion_ends_the_run() {
        let run = |criteria: Criteria| {
            let mut x = vec![[-1.2, 1.0]];
            let valley = &mut Valley { longest: f64::INFINITY };
            minimise(valley, &mut x, criteria, &mut |_, _, _| {}, &Execution::default()).0
        };
        assert_eq!(run(Criteria { max_iterations: 2, ..CRITERIA }), Stop::MaxIterations);
        assert_eq!(run(Criteria { gradient: 1e-3, floor: 1.0, ..CRITERIA }), Stop::Gradient);
        assert_eq!(run(Criteria { step: 1e-3, ..CRITERIA }), Stop::Step);
        assert_eq!(run(Criteria { change: 1e-3, floor: 1.0, quiet_steps: 1, ..CRITERIA }), Stop::Change);
    }
}
