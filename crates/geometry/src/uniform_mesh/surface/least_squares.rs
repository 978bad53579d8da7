//! Levenberg and Marquardt's method for sums of squared edge terms over points with two coordinates each.
//!
//! Flattening, node optimisation and length clustering are all of this shape: one residual an edge, so the normal matrix
//! has one 2 × 2 block per node and two per edge, and its pattern is analysed once. The damping is a metric of the
//! problem's own, so that steps do not depend on how the surface is parametrised. Every step that is kept lowers the energy.

use crate::DVec2;
use crate::execution::{Execution, Interruption, Progress};
use crate::sparse::{Symbolic, SymmetricMatrix};

/// What is minimised over the positions of the nodes 0..n.
pub(in crate::uniform_mesh) trait Problem {
    /// Where a node stands.
    type Place: Clone;
    /// Pairs of nodes that share a residual.
    fn couplings(&self) -> &[[u32; 2]];
    /// ½ Σ r², infinite where the positions are not allowed.
    fn energy(&mut self, x: &[Self::Place]) -> f64;
    /// Adds every residual with its derivatives; returns nothing that `energy` does not.
    fn assemble(&mut self, x: &[Self::Place], normal: &mut Normal);
    /// The metric of a node's displacements (xx, xy, yy), positive definite.
    fn metric(&self, node: usize) -> [f64; 3];
    /// Writes to `to` the places after as much of the step as may be taken; see [`step_before_flip`].
    fn advance(&self, x: &[Self::Place], step: &[DVec2], to: &mut [Self::Place]);
}

/// JᵀJ and Jᵀr on a fixed pattern.
#[derive(Debug)]
pub(in crate::uniform_mesh) struct Normal {
    matrix: SymmetricMatrix,
    pub gradient: Vec<DVec2>,
    /// For coupling k between i and j: where row 2i holds j's columns, and row 2j holds i's.
    slots: Vec<[usize; 2]>,
}

impl Normal {
    /// The couplings must not repeat a pair.
    pub fn new(nodes: usize, couplings: &[[u32; 2]]) -> Self {
        let mut degree = vec![0u32; nodes];
        for pair in couplings {
            degree[pair[0] as usize] += 1;
            degree[pair[1] as usize] += 1;
        }
        let mut row_start = Vec::with_capacity(2 * nodes + 1);
        let mut total = 0;
        for &d in &degree {
            row_start.extend([total, total + 2 + 2 * d]);
            total += 2 * (2 + 2 * d);
        }
        row_start.push(total);
        let mut columns = vec![0u32; total as usize];
        for i in 0..nodes as u32 {
            let start = |row: u32| row_start[row as usize] as usize;
            columns[start(2 * i)..][..2].copy_from_slice(&[2 * i, 2 * i + 1]);
            columns[start(2 * i + 1)..][..2].copy_from_slice(&[2 * i + 1, 2 * i]);
        }
        let mut filled = vec![0usize; nodes];
        let mut slots = Vec::with_capacity(couplings.len());
        for &[i, j] in couplings {
            let mut place = |i: u32, j: u32| {
                let offset = 2 + 2 * filled[i as usize];
                filled[i as usize] += 1;
                for row in [2 * i, 2 * i + 1] {
                    let at = row_start[row as usize] as usize + offset;
                    columns[at..at + 2].copy_from_slice(&[2 * j, 2 * j + 1]);
                }
                offset
            };
            slots.push([place(i, j), place(j, i)]);
        }
        let values = vec![0.0; columns.len()];
        Self { matrix: SymmetricMatrix { row_start, columns, values }, gradient: vec![DVec2::ZERO; nodes], slots }
    }

    fn clear(&mut self) {
        self.matrix.values.fill(0.0);
        self.gradient.fill(DVec2::ZERO);
    }

    fn row(&self, row: usize) -> usize {
        self.matrix.row_start[row] as usize
    }

    fn add_diagonal(&mut self, node: usize, [xx, xy, yy]: [f64; 3]) {
        let (x, y) = (self.row(2 * node), self.row(2 * node + 1));
        self.matrix.values[x] += xx;
        self.matrix.values[x + 1] += xy;
        self.matrix.values[y] += yy;
        self.matrix.values[y + 1] += xy;
    }

    /// A residual r that depends on one node alone.
    pub fn add_single(&mut self, node: usize, residual: f64, g: DVec2) {
        self.gradient[node] += g * residual;
        self.add_diagonal(node, [g.x * g.x, g.x * g.y, g.y * g.y]);
    }

    /// A residual r of coupling k with derivatives `gi` and `gj` by its two nodes.
    pub fn add_pair(&mut self, k: usize, [i, j]: [u32; 2], residual: f64, gi: DVec2, gj: DVec2) {
        let (i, j) = (i as usize, j as usize);
        self.add_single(i, residual, gi);
        self.add_single(j, residual, gj);
        let [at_i, at_j] = self.slots[k];
        for (row, a, b, at) in
            [(2 * i, gi.x, gj, at_i), (2 * i + 1, gi.y, gj, at_i), (2 * j, gj.x, gi, at_j), (2 * j + 1, gj.y, gi, at_j)]
        {
            let at = self.row(row) + at;
            self.matrix.values[at] += a * b.x;
            self.matrix.values[at + 1] += a * b.y;
        }
    }
}

/// The part of a step, at most 1, that takes no triangle more than nine tenths of the way to where it loses its area.
///
/// Without it one triangle about to flip would shorten the steps of the whole mesh by way of the damping.
pub(in crate::uniform_mesh) fn step_before_flip(triangles: impl Iterator<Item = [(DVec2, DVec2); 3]>) -> f64 {
    let mut most = 1.0 / 0.9;
    for [(a, da), (b, db), (c, dc)] in triangles {
        let ((u, du), (v, dv)) = ((b - a, db - da), (c - a, dc - da));
        // Twice the area after the part s of the step: p + q s + r s², with p > 0.
        let (p, q, r) = (u.perp_dot(v), u.perp_dot(dv) + du.perp_dot(v), du.perp_dot(dv));
        let discriminant = q * q - 4.0 * p * r;
        if p <= 0.0 || discriminant < 0.0 {
            continue;
        }
        // The stable form of the smaller positive root; the other one has the opposite sign or comes later.
        let root = 2.0 * p / (discriminant.sqrt() - q);
        if root > 0.0 {
            most = f64::min(most, root);
        }
    }
    0.9 * most
}

/// When to stop, and how to say where one is.
#[derive(Clone, Copy, Debug)]
pub(in crate::uniform_mesh) struct Settings {
    pub phase: &'static str,
    /// The part of the whole solve's progress that this run stands for.
    pub span: (f64, f64),
    pub max_iterations: usize,
    /// Ends the run when a step lowers the energy by less than this fraction of it.
    pub tolerance: f64,
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::uniform_mesh) struct Outcome {
    pub energy: f64,
    pub iterations: usize,
    pub interrupted: Option<Interruption>,
}

/// Lowers the problem's energy from `x`, which must be allowed, until steps gain less than the tolerance.
///
/// Looks at `execution` once a step tried (one sparse factorisation). On an interruption `x` is the best so far.
pub(in crate::uniform_mesh) fn minimise<P: Problem>(
    problem: &mut P,
    x: &mut Vec<P::Place>,
    settings: Settings,
    execution: &Execution<'_>,
) -> Outcome {
    let mut energy = problem.energy(x);
    let mut normal = Normal::new(x.len(), problem.couplings());
    let mut outcome = Outcome { energy, iterations: 0, interrupted: None };
    let Ok(symbolic) = Symbolic::analyse(&normal.matrix, None) else { return outcome };
    let mut damping = 1e-3;
    let mut quiet = 0;
    let mut trial = x.clone();
    let mut step = vec![0.0; 2 * x.len()];
    let mut moves = vec![DVec2::ZERO; x.len()];
    while outcome.iterations < settings.max_iterations && energy > 0.0 && quiet < 3 && !x.is_empty() {
        normal.clear();
        problem.assemble(x, &mut normal);
        let undamped = normal.matrix.values.clone();
        let mut moved = false;
        while !moved && damping < 1e9 {
            if let Err(interruption) = execution.look(normal.matrix.columns.len() as u64) {
                outcome.interrupted = Some(interruption);
                return outcome;
            }
            normal.matrix.values.copy_from_slice(&undamped);
            for node in 0..x.len() {
                normal.add_diagonal(node, problem.metric(node).map(|m| m * damping));
            }
            for (node, g) in normal.gradient.iter().enumerate() {
                (step[2 * node], step[2 * node + 1]) = (-g.x, -g.y);
            }
            let solved = symbolic.factorise(&normal.matrix).is_ok_and(|factor| factor.solve(&mut step).is_ok());
            if solved {
                for (node, vector) in moves.iter_mut().enumerate() {
                    *vector = DVec2::new(step[2 * node], step[2 * node + 1]);
                }
                problem.advance(x, &moves, &mut trial);
                let there = problem.energy(&trial);
                if there < energy {
                    quiet = if energy - there <= settings.tolerance * energy { quiet + 1 } else { 0 };
                    (energy, moved) = (there, true);
                    std::mem::swap(x, &mut trial);
                    damping = f64::max(damping / 5.0, 1e-9);
                }
            }
            if !moved {
                damping *= 6.0;
            }
        }
        if !moved {
            break;
        }
        outcome.iterations += 1;
        outcome.energy = energy;
        let (from, to) = settings.span;
        let share = outcome.iterations as f64 / settings.max_iterations as f64;
        execution.report(Progress {
            fraction: from + (to - from) * share,
            phase: settings.phase,
            iteration: outcome.iterations as u64,
            objective_value: Some(energy),
            residual: None,
        });
    }
    outcome
}
