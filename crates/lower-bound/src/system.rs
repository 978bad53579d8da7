//! The linear systems with the matrix Cᵀ W C and their factorisation. C is the curl, and W consists of a symmetric 3 ×
//! 3 matrix for each vertex of a tetrahedron.

use super::dissection::{self, NONE};
use super::element::{self, UNKNOWNS};
use super::space::Space;
use glam::DMat3;
use plateau_mesh::codes::Reason;
use plateau_mesh::execution::Interruption;
use plateau_mesh::sparse::{Symbolic, SymmetricMatrix, Unsolved, dot};
use plateau_mesh::{DVec3, Error, Execution};

/// The pattern of the matrix, its symbolic factorisation, and the entries to which each tetrahedron contributes.
#[derive(Debug)]
pub(super) struct System {
    /// For each unknown, its row, or `NONE` if the gauge fixes the unknown.
    row: Vec<u32>,
    rows: usize,
    pub(super) matrix: SymmetricMatrix,
    /// The rows in their order of elimination.
    #[cfg(test)]
    pub(super) order: Vec<u32>,
    /// For each constrained leaf, the positions of its entries in the matrix.
    entries: Vec<[u32; UNKNOWNS * UNKNOWNS]>,
    symbolic: Symbolic,
}

/// Number of leaves that are assembled between two calls of [`Execution::look`], a few milliseconds of work.
const LEAVES_A_LOOK: usize = 1_000;

/// Number of rows whose pattern is built between two calls of [`Execution::look`], a few milliseconds of work.
const ROWS_A_LOOK: u32 = 5_000;

/// A linear form counts as dependent on earlier forms if at most this fraction of its squared norm remains after they
/// are projected out. The norm is that of the inverse matrix.
const INDEPENDENT: f64 = 1e-12;

/// The error of a lower bound whose system was not solved.
pub(super) fn error_of(unsolved: Unsolved) -> Error {
    match unsolved {
        Unsolved::Interrupted(interruption) => interruption.into(),
        Unsolved::Refused(_) => {
            Error::no_result(Reason::Internal, "the linear system of the lower bound could not be solved")
        }
    }
}

impl System {
    /// Numbers the rows, builds the pattern of the matrix, and analyses it.
    ///
    /// # Errors
    /// The error of the analysis, or an interruption.
    pub fn of(space: &Space, exec: &Execution) -> Result<Self, Unsolved> {
        let mut rows = 0u32;
        let mut row = vec![NONE; space.count()];
        for (unknown, row) in row.iter_mut().enumerate() {
            if !space.gauge[unknown] {
                *row = rows;
                rows += 1;
            }
        }
        // The constrained leaves that have each row.
        let mut start = vec![0u32; rows as usize + 1];
        let numbers = |&leaf: &u32| space.unknowns[leaf as usize].map(|unknown| row[unknown as usize]);
        let rows_of: Vec<[u32; UNKNOWNS]> = space.constrained.iter().map(numbers).collect();
        for of in &rows_of {
            of.iter().filter(|&&r| r != NONE).for_each(|&r| start[r as usize + 1] += 1);
        }
        for k in 0..rows as usize {
            start[k + 1] += start[k];
        }
        let mut around = vec![(0u32, 0u8); start[rows as usize] as usize];
        let mut next = start.clone();
        for (k, of) in rows_of.iter().enumerate() {
            for (local, &r) in of.iter().enumerate() {
                if r != NONE {
                    around[next[r as usize] as usize] = (k as u32, local as u8);
                    next[r as usize] += 1;
                }
            }
        }
        let mut matrix = SymmetricMatrix { row_start: vec![0], ..SymmetricMatrix::default() };
        let mut entries = vec![[NONE; UNKNOWNS * UNKNOWNS]; rows_of.len()];
        let mut place = vec![NONE; rows as usize];
        for r in 0..rows {
            if r.is_multiple_of(ROWS_A_LOOK) {
                exec.look(u64::from(ROWS_A_LOOK) * 30)?;
            }
            let begin = matrix.columns.len();
            place[r as usize] = begin as u32;
            matrix.columns.push(r);
            for &(k, local) in &around[start[r as usize] as usize..start[r as usize + 1] as usize] {
                for (other, &column) in rows_of[k as usize].iter().enumerate() {
                    if column == NONE {
                        continue;
                    }
                    if place[column as usize] == NONE {
                        place[column as usize] = matrix.columns.len() as u32;
                        matrix.columns.push(column);
                    }
                    entries[k as usize][local as usize * UNKNOWNS + other] = place[column as usize];
                }
            }
            matrix.columns[begin..].iter().for_each(|&column| place[column as usize] = NONE);
            matrix.row_start.push(matrix.columns.len() as u32);
        }
        matrix.values = vec![0.0; matrix.columns.len()];
        let centroid = |&leaf: &u32| space.corners[leaf as usize].iter().sum::<DVec3>() * 0.25;
        let centroids: Vec<DVec3> = space.constrained.iter().map(centroid).collect();
        let order = dissection::order(&rows_of, &centroids, rows as usize, exec)?;
        exec.look(rows.into())?;
        let symbolic = Symbolic::analyse(&matrix, Some(&order))?;
        Ok(Self {
            row,
            rows: rows as usize,
            matrix,
            #[cfg(test)]
            order,
            entries,
            symbolic,
        })
    }

    /// Number of entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.symbolic.factor_entries()
    }

    /// Number of unknowns that the gauge does not fix.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Assembles and factorises the matrix. `weight` gives the symmetric positive definite matrix W at each of the four
    /// vertices of each constrained leaf.
    pub fn factorise(
        &mut self,
        space: &Space,
        weight: impl Fn(usize, usize) -> DMat3,
        storage: &mut Vec<f64>,
        exec: &Execution,
    ) -> Result<Factor<'_>, Unsolved> {
        self.matrix.values.fill(0.0);
        for (k, &leaf) in space.constrained.iter().enumerate() {
            if k.is_multiple_of(LEAVES_A_LOOK) {
                exec.look((LEAVES_A_LOOK * UNKNOWNS * UNKNOWNS) as u64)?;
            }
            let leaf = leaf as usize;
            let basis = element::basis_curls(space.corners[leaf], &space.orientations[leaf]);
            let mut local = [[0.0; UNKNOWNS]; UNKNOWNS];
            for (p, curls) in basis.iter().enumerate() {
                let weight = weight(k, p);
                for i in 0..UNKNOWNS {
                    let weighted = weight * curls[i];
                    for j in 0..=i {
                        local[i][j] += weighted.dot(curls[j]);
                    }
                }
            }
            let entries = &self.entries[k];
            for i in 0..UNKNOWNS {
                for j in 0..UNKNOWNS {
                    let entry = entries[i * UNKNOWNS + j];
                    if entry != NONE {
                        self.matrix.values[entry as usize] += local[i.max(j)][i.min(j)];
                    }
                }
            }
        }
        let factor = self.symbolic.factorise_into(&self.matrix, std::mem::take(storage))?;
        Ok(Factor { row: &self.row, factor, rows: self.rows, held: Vec::new() })
    }
}

/// A factorised matrix.
#[derive(Debug)]
pub(super) struct Factor<'a> {
    row: &'a [u32],
    factor: plateau_mesh::sparse::Factorisation<'a>,
    rows: usize,
    /// The solutions whose right-hand sides are the held forms, made orthonormal in the inner product of the matrix.
    held: Vec<Vec<f64>>,
}

impl Factor<'_> {
    /// Holds the given linear forms at zero: they vanish on all later solutions, which minimise the quadratic function
    /// under these constraints. A form that depends on earlier ones changes nothing.
    pub fn hold(&mut self, forms: &[Vec<f64>], exec: &Execution) -> Result<(), Interruption> {
        for form in forms {
            exec.look(self.rows as u64)?;
            let free = self.solve_freely(form);
            let mut solution = self.project(free.clone(), form);
            let square = dot(form, &solution);
            if square > INDEPENDENT * dot(form, &free) {
                solution.iter_mut().for_each(|value| *value /= square.sqrt());
                self.held.push(solution);
            }
        }
        Ok(())
    }

    /// Solves for all unknowns. Unknowns that the gauge fixes are zero. An inaccurate solution is still usable as a
    /// direction of Newton's method, because the step along it is limited by the cones.
    pub fn solve(&self, right_hand_side: &[f64]) -> Vec<f64> {
        self.project(self.solve_freely(right_hand_side), right_hand_side)
    }

    /// Projects a solution so that the held forms vanish on it.
    fn project(&self, mut solution: Vec<f64>, right_hand_side: &[f64]) -> Vec<f64> {
        for held in &self.held {
            let share = dot(held, right_hand_side);
            solution.iter_mut().zip(held).for_each(|(value, by)| *value -= share * by);
        }
        solution
    }

    fn solve_freely(&self, right_hand_side: &[f64]) -> Vec<f64> {
        let mut reduced = vec![0.0; self.rows];
        for (&row, &value) in self.row.iter().zip(right_hand_side) {
            if row != NONE {
                reduced[row as usize] = value;
            }
        }
        self.factor.solve_unchecked(&mut reduced);
        self.row.iter().map(|&row| if row == NONE { 0.0 } else { reduced[row as usize] }).collect()
    }

    pub fn into_storage(self) -> Vec<f64> {
        self.factor.into_storage()
    }
}
