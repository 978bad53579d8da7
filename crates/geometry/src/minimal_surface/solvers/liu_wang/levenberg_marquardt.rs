//! Levenberg and Marquardt's damped Gauss-Newton steps for ½ Σ H², after Madsen, Nielsen and Tingleff (Liu-Wang, Fig.
//! 5).

use super::curvature::CurvatureRows;
use crate::sparse::pattern::BlockPattern;
use crate::sparse::{Symbolic, SymmetricMatrix};
use crate::{DVec3, Execution, Interruption};

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Criteria {
    pub tolerance: f64,
    pub max_iterations: u64,
}

/// Which criterion ended the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    ChangeOfObjective,
    Gradient,
    Step,
    MaxIterations,
    NoUnknowns,
    /// No damping makes a step that lowers the objective (a vertex whose triangles have no area, for example).
    NoStep,
}

/// Moves the unknown vertices until a criterion holds; returns which, and F.
///
/// `observe` is shown the vertices and F after every step, rejected ones included. The vertices are the best so far at
/// every look, so an interruption leaves them valid.
pub(super) fn levenberg_marquardt(
    vertices: &mut [DVec3],
    rows: &mut CurvatureRows,
    criteria: &Criteria,
    observe: &mut dyn FnMut(&[DVec3], f64),
    execution: &Execution<'_>,
) -> Result<(Stop, f64), Interruption> {
    let epsilon = criteria.tolerance;
    let mut objective = rows.differentiate(vertices);
    if rows.unknowns() == 0 {
        return Ok((Stop::NoUnknowns, objective));
    }
    let moving: Vec<usize> = (0..vertices.len()).filter(|&v| rows.unknown_of(v).is_some()).collect();
    let mut normal = NormalEquations::new(rows);
    normal.assemble(rows);
    execution.look(rows.work())?;
    let Ok(symbolic) = Symbolic::analyse(&normal.matrix, None) else {
        return Ok((Stop::NoStep, objective));
    };
    let (mut damping, mut growth) = (1e-6 * normal.largest_diagonal(), 2.0);
    let mut storage = Vec::new();
    let mut trial = vertices.to_vec();
    for _ in 0..criteria.max_iterations {
        // NaN compares false, so a start without curvatures (a degenerate ring) goes on to be refused below.
        if normal.largest_gradient() < epsilon.cbrt() * (1.0 + objective) {
            return Ok((Stop::Gradient, objective));
        }
        let mut step: Vec<f64> = normal.gradient.iter().map(|g| -g).collect();
        normal.damp(damping);
        let solved = symbolic.factorise_into(&normal.matrix, std::mem::take(&mut storage)).and_then(|factors| {
            let solved = factors.solve(&mut step);
            storage = factors.into_storage();
            solved
        });
        execution.look(rows.work() + symbolic.factor_entries() as u64)?;
        let mut accepted = false;
        if solved.is_ok() {
            let largest = step.iter().fold(0.0, |max: f64, d| max.max(d.abs()));
            if largest < epsilon.sqrt() * (1.0 + largest) {
                return Ok((Stop::Step, objective));
            }
            for (&v, d) in moving.iter().zip(step.chunks_exact(3)) {
                trial[v] = vertices[v] + DVec3::new(d[0], d[1], d[2]);
            }
            let reached = rows.evaluate(&trial);
            // L(0) - L(δ) = ½ δᵀ(μδ - g), above 0 for every step that solves the damped system.
            let predicted = 0.5 * step.iter().zip(&normal.gradient).map(|(d, g)| d * (damping * d - g)).sum::<f64>();
            let ratio = (objective - reached) / predicted;
            accepted = ratio > 0.0;
            if accepted {
                vertices.copy_from_slice(&trial);
                let change = objective - reached;
                objective = rows.differentiate(vertices);
                normal.assemble(rows);
                observe(vertices, objective);
                if change < epsilon * (1.0 + objective) {
                    return Ok((Stop::ChangeOfObjective, objective));
                }
                damping *= (1.0 - (2.0 * ratio - 1.0).powi(3)).max(1.0 / 3.0);
                growth = 2.0;
            }
        }
        if !accepted {
            observe(vertices, objective);
            damping *= growth;
            growth *= 2.0;
            if !(damping.is_finite() && growth.is_finite()) {
                return Ok((Stop::NoStep, objective));
            }
        }
    }
    Ok((Stop::MaxIterations, objective))
}

/// JᵀJ and Jᵀf of the rows, on one pattern for one triangulation: three unknowns a vertex, coupled with every vertex
/// that shares a row.
#[derive(Debug)]
struct NormalEquations {
    pattern: BlockPattern,
    matrix: SymmetricMatrix,
    /// The diagonal of JᵀJ without damping.
    diagonal: Vec<f64>,
    gradient: Vec<f64>,
}

impl NormalEquations {
    fn new(rows: &CurvatureRows) -> Self {
        let n = rows.unknowns();
        let pattern = BlockPattern::new(&vec![3; n], |couple| (0..rows.rows()).for_each(|row| couple(rows.row(row).0)));
        let matrix = pattern.matrix();
        Self { pattern, matrix, diagonal: vec![0.0; 3 * n], gradient: vec![0.0; 3 * n] }
    }

    fn assemble(&mut self, rows: &CurvatureRows) {
        self.matrix.values.fill(0.0);
        self.gradient.fill(0.0);
        for row in 0..rows.rows() {
            let (columns, values) = rows.row(row);
            let curvature = rows.curvatures()[row];
            for (&j, derivative) in columns.iter().zip(values) {
                for axis in 0..3 {
                    self.gradient[3 * j as usize + axis] += derivative[axis] * curvature;
                }
                for (&k, other) in columns.iter().zip(values) {
                    self.add_block(j, k, *derivative, *other);
                }
            }
        }
        for (k, diagonal) in self.diagonal.iter_mut().enumerate() {
            *diagonal = self.matrix.diagonal(k);
        }
    }

    /// Adds the outer product of two derivatives to the block of vertices j (rows) and k (columns).
    fn add_block(&mut self, j: u32, k: u32, rows: DVec3, columns: DVec3) {
        let Some(position) = self.pattern.position(j, k) else { return };
        for axis in 0..3 {
            for other in 0..3 {
                self.matrix.values[position.at(axis, other)] += rows[axis] * columns[other];
            }
        }
    }

    /// Makes the matrix JᵀJ + μI.
    fn damp(&mut self, damping: f64) {
        for (k, diagonal) in self.diagonal.iter().enumerate() {
            self.matrix.values[self.matrix.row_start[k] as usize] = diagonal + damping;
        }
    }

    fn largest_diagonal(&self) -> f64 {
        self.diagonal.iter().fold(0.0, |max: f64, a| max.max(*a))
    }

    fn largest_gradient(&self) -> f64 {
        // f64::max would skip NaN, which must not look like a vanishing gradient.
        self.gradient.iter().fold(0.0, |max: f64, g| if g.is_nan() { f64::INFINITY } else { max.max(g.abs()) })
    }
}
