//! The shape of a net with given force densities, by linear equations (Schek 1974).
//!
//! ```text
//! Σ q (x_j - x_i) + f_i = 0          at every free vertex i, over the edges to its neighbours j
//! ```
//!
//! The matrix D of the free vertices is the Laplacian of the graph with the weights q. It is the same for the three
//! coordinates. It is positive definite if all densities are positive, because every vertex is joined to a support.

use super::options::Net;
use plateau_mesh::DVec3;
use plateau_mesh::sparse::pattern::BlockPattern;
use plateau_mesh::sparse::{LinearError, Symbolic};

/// The linear equations of nets with the same connectivity and supports.
#[derive(Debug)]
pub(super) struct Shape {
    edges: Vec<[u32; 2]>,
    fixed: Vec<bool>,
    pattern: BlockPattern,
    symbolic: Symbolic,
}

impl Shape {
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub fn new(net: &Net) -> Result<Self, LinearError> {
        let mut fixed = vec![false; net.vertices.len()];
        net.supports.iter().for_each(|&v| fixed[v as usize] = true);
        let counts: Vec<u8> = fixed.iter().map(|fixed| u8::from(!fixed)).collect();
        let pattern = BlockPattern::new(&counts, |couple| net.edges.iter().for_each(|edge| couple(&edge.ends)));
        let symbolic = Symbolic::analyse(&pattern.matrix(), None)?;
        Ok(Self { edges: net.edges.iter().map(|edge| edge.ends).collect(), fixed, pattern, symbolic })
    }

    /// Number of entries of the factor of D.
    pub fn factor_entries(&self) -> usize {
        self.symbolic.factor_entries()
    }

    pub fn fixed(&self) -> &[bool] {
        &self.fixed
    }

    /// Returns the positions of all vertices at the given densities.
    ///
    /// # Errors
    /// A [`LinearError`] if the equations are singular to working precision.
    pub fn positions(&self, net: &Net, densities: &[f64]) -> Result<Vec<DVec3>, LinearError> {
        let mut forces: Vec<DVec3> = (0..net.vertices.len()).map(|v| net.load(v)).collect();
        for (&[a, b], &q) in self.edges.iter().zip(densities) {
            for (free, held) in [(a, b), (b, a)] {
                if self.fixed[held as usize] {
                    forces[free as usize] += q * net.vertices[held as usize];
                }
            }
        }
        let mut at = self.solve(densities, &forces)?;
        for (v, &fixed) in self.fixed.iter().enumerate() {
            if fixed {
                at[v] = net.vertices[v];
            }
        }
        Ok(at)
    }

    /// Applies D⁻¹ to one vector per vertex. The result is zero at supports.
    ///
    /// # Errors
    /// A [`LinearError`] if D is singular to working precision.
    pub fn solve(&self, densities: &[f64], vectors: &[DVec3]) -> Result<Vec<DVec3>, LinearError> {
        let mut matrix = self.pattern.matrix();
        for (&[a, b], &q) in self.edges.iter().zip(densities) {
            for (v, w, value) in [(a, a, q), (b, b, q), (a, b, -q), (b, a, -q)] {
                if let Some(position) = self.pattern.position(v, w) {
                    matrix.values[position.at(0, 0)] += value;
                }
            }
        }
        let order = self.pattern.order();
        let mut right = vec![0.0; 3 * order];
        for (v, vector) in vectors.iter().enumerate() {
            for row in self.pattern.unknowns(v as u32) {
                (0..3).for_each(|axis| right[axis * order + row] = vector[axis]);
            }
        }
        self.symbolic.factorise(&matrix)?.solve(&mut right)?;
        let solution = |v: usize| {
            let mut rows = self.pattern.unknowns(v as u32);
            rows.next().map_or(DVec3::ZERO, |row| DVec3::new(right[row], right[order + row], right[2 * order + row]))
        };
        Ok((0..vectors.len()).map(solution).collect())
    }
}
