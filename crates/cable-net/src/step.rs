//! The sparse linear system of a fitting step. [`fitting`](super::fitting) derives its equations.

use super::loss::{Loss, Residual, Sums, length, unit};
use super::options::Net;
use glam::DMat3;
use plateau_mesh::DVec3;
use plateau_mesh::sparse::pattern::BlockPattern;
use plateau_mesh::sparse::{Factorisation, LinearError, Symbolic, SymmetricMatrix};

/// Fraction of the mean diagonal that is added to the diagonal of the positions and subtracted from that of the
/// multipliers. It ensures that the factorisation without pivoting exists (Vanderbei, *Symmetric quasidefinite
/// matrices*, 1995). The step deviates from the linearised equilibrium by about this fraction; the loss is still
/// computed in exact equilibrium.
const REGULARISATION: f64 = 1e-9;

/// The quantities of one edge from which the system is assembled.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member {
    ends: [u32; 2],
    density: f64,
    unit: DVec3,
    length: f64,
    /// c = p ℓ: the derivative of the edge's force by s, at constant length.
    by_s: f64,
    sums: Sums,
}

impl Member {
    /// The same edge with all residuals and their derivatives zero.
    pub fn without_residuals(&self) -> Self {
        Self { sums: Sums::default(), ..*self }
    }
}

/// Returns the quantities of every edge.
pub(super) fn members(loss: &Loss, densities: &[f64], at: &[DVec3]) -> Vec<Member> {
    let member = |(e, &density): (usize, &f64)| {
        let ends = loss.net.edges[e].ends;
        let length = length(ends, at);
        let by_s = loss.slope(e, density) * length;
        Member { ends, density, unit: unit(ends, at), length, by_s, sums: loss.sums(e, density, at) }
    };
    densities.iter().enumerate().map(member).collect()
}

/// The damping of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Damping {
    /// Damping μ of the logarithms of the densities.
    pub densities: f64,
    /// Damping of the positions, per squared length.
    pub positions: f64,
    /// The penalty parameter ε: an unbalanced force whose square is ε costs as much as a loss of 1. With 0 the step
    /// meets the linearised equations of equilibrium exactly.
    pub softness: f64,
}

impl Damping {
    /// Damps only the densities; the step stays in linearised equilibrium.
    pub fn of_densities(damping: f64) -> Self {
        Self { densities: damping, positions: 0.0, softness: 0.0 }
    }
}

/// The changes of the densities and positions in a step.
#[derive(Clone, Debug)]
pub(super) struct Change {
    /// The change of the logarithm of each density.
    pub logarithms: Vec<f64>,
    /// The displacement of each vertex.
    pub vertices: Vec<DVec3>,
}

impl Change {
    /// Returns the first-order change of a residual of edge `e`.
    pub fn of_residual(&self, e: usize, ends: [u32; 2], at: &[DVec3], residual: &Residual) -> f64 {
        let [a, b] = ends.map(|v| v as usize);
        let stretch = unit(ends, at).dot(self.vertices[b] - self.vertices[a]);
        residual.by_s * self.logarithms[e] + residual.by_length * stretch
    }
}

/// The pattern of the systems of one net, their symbolic factorisation, and the storage of their factor.
pub(super) struct Step {
    pattern: BlockPattern,
    symbolic: Symbolic,
    storage: Vec<f64>,
    vertices: usize,
}

/// The matrix of a step, with the scale of its multipliers and the damping of its densities.
pub(super) struct System {
    matrix: SymmetricMatrix,
    scale: f64,
    damping: f64,
}

impl Step {
    pub fn new(net: &Net, fixed: &[bool]) -> Result<Self, LinearError> {
        let counts: Vec<u8> = fixed.iter().map(|fixed| if *fixed { 0 } else { 6 }).collect();
        let pattern = BlockPattern::new(&counts, |couple| net.edges.iter().for_each(|edge| couple(&edge.ends)));
        let symbolic = Symbolic::analyse(&pattern.matrix(), None)?;
        Ok(Self { pattern, symbolic, storage: Vec::new(), vertices: fixed.len() })
    }

    /// Returns the scale that makes the diagonal of the multipliers as large as that of the positions, and the mean of
    /// the scaled diagonal.
    fn scale(&self, members: &[Member], damping: Damping) -> (f64, f64) {
        let (mut positions, mut multipliers) = (0.0, 0.0);
        let (mut squared_lengths, mut squared_forces) = (0.0, 0.0);
        for Member { by_s, sums, density, length, .. } in members {
            let own = sums.h_ss + damping.densities;
            squared_lengths += length * length;
            squared_forces += (density * length).powi(2);
            positions += sums.h_ll - sums.h_sl * sums.h_sl / own + damping.positions;
            multipliers += by_s * by_s / own;
        }
        // positions / multipliers has the unit 1 / (length force)².
        let edges = members.len() as f64;
        let least = REGULARISATION * edges * edges / (squared_lengths * squared_forces);
        let scale = (positions / multipliers).max(least).sqrt();
        (scale, scale * scale * multipliers / self.pattern.order().max(1) as f64)
    }

    /// Assembles the matrix of a step.
    pub fn system(&self, members: &[Member], damping: Damping) -> System {
        let mut matrix = self.pattern.matrix();
        let (scale, mean) = self.scale(members, damping);
        for Member { ends, density, unit, by_s, sums, .. } in members {
            let own = sums.h_ss + damping.densities;
            let c = scale * by_s;
            let along = DMat3::from_cols(*unit * unit.x, *unit * unit.y, *unit * unit.z);
            let xx = along * (sums.h_ll - sums.h_sl * sums.h_sl / own);
            let ll = along * (-c * c / own);
            let xl = along * (c * sums.h_sl / own) - DMat3::IDENTITY * (scale * density);
            for (v, sign) in [(ends[0], -1.0), (ends[1], 1.0)] {
                for (w, other) in [(ends[0], -1.0), (ends[1], 1.0)] {
                    let Some(position) = self.pattern.position(v, w) else { continue };
                    let factor = sign * other;
                    for j in 0..3 {
                        for i in 0..3 {
                            matrix.values[position.at(i, j)] += factor * xx.col(j)[i];
                            matrix.values[position.at(3 + i, 3 + j)] += factor * ll.col(j)[i];
                            matrix.values[position.at(i, 3 + j)] += factor * xl.col(j)[i];
                            matrix.values[position.at(3 + i, j)] += factor * xl.col(j)[i];
                        }
                    }
                }
            }
        }
        let (stiff, soft) = (damping.positions, scale * scale * damping.softness);
        for row in 0..self.pattern.order() {
            let added = if row % 6 < 3 { stiff + REGULARISATION * mean } else { -soft - REGULARISATION * mean };
            matrix.values[matrix.row_start[row] as usize] += added;
        }
        System { matrix, scale, damping: damping.densities }
    }

    pub fn factorise<'a>(&'a mut self, system: &'a System) -> Result<Factor<'a>, LinearError> {
        let inner = self.symbolic.factorise_into(&system.matrix, std::mem::take(&mut self.storage))?;
        Ok(Factor { inner, system, pattern: &self.pattern, vertices: self.vertices })
    }

    /// Takes back the storage of a factor, for the next factorisation.
    pub fn reuse(&mut self, storage: Vec<f64>) {
        self.storage = storage;
    }
}

/// The factor of a step's matrix.
pub(super) struct Factor<'a> {
    inner: Factorisation<'a>,
    system: &'a System,
    pattern: &'a BlockPattern,
    vertices: usize,
}

impl Factor<'_> {
    pub fn into_storage(self) -> Vec<f64> {
        self.inner.into_storage()
    }

    /// Solves for the changes of a step. `gradients` lists the derivatives of half the loss by the logarithm s and by
    /// the length of each edge. `unbalanced` lists the unbalanced force on each vertex, if there are any.
    pub fn change(
        &self,
        members: &[Member],
        gradients: &[[f64; 2]],
        unbalanced: Option<&[DVec3]>,
    ) -> Result<Change, LinearError> {
        let System { scale, damping, .. } = self.system;
        let mut right = vec![0.0; self.pattern.order()];
        for (Member { ends, unit, by_s, sums, .. }, [g_s, g_l]) in members.iter().zip(gradients) {
            let own = sums.h_ss + damping;
            let by_x = (g_l - g_s * sums.h_sl / own) * *unit;
            let by_l = scale * by_s * g_s / own * *unit;
            for (v, sign) in [(ends[0], -1.0), (ends[1], 1.0)] {
                let unknowns = self.pattern.unknowns(v);
                if unknowns.is_empty() {
                    continue;
                }
                for i in 0..3 {
                    right[unknowns.start + i] -= sign * by_x[i];
                    right[unknowns.start + 3 + i] -= sign * by_l[i];
                }
            }
        }
        for (v, force) in unbalanced.unwrap_or_default().iter().enumerate() {
            let unknowns = self.pattern.unknowns(v as u32);
            if !unknowns.is_empty() {
                (0..3).for_each(|i| right[unknowns.start + 3 + i] -= scale * force[i]);
            }
        }
        self.inner.solve_unchecked(&mut right);
        let part = |v: u32, from: usize| {
            let unknowns = self.pattern.unknowns(v);
            if unknowns.is_empty() { DVec3::ZERO } else { DVec3::from_slice(&right[unknowns.start + from..]) }
        };
        let change = |(Member { ends: [a, b], unit, by_s, sums, .. }, [g_s, _]): (&Member, &[f64; 2])| {
            let (x, l) = (unit.dot(part(*b, 0) - part(*a, 0)), unit.dot(part(*b, 3) - part(*a, 3)));
            (scale * by_s * l - g_s - sums.h_sl * x) / (sums.h_ss + damping)
        };
        let logarithms: Vec<f64> = members.iter().zip(gradients).map(change).collect();
        let vertices: Vec<DVec3> = (0..self.vertices).map(|v| part(v as u32, 0)).collect();
        let finite = logarithms.iter().all(|step| step.is_finite()) && vertices.iter().all(|by| by.is_finite());
        if finite { Ok(Change { logarithms, vertices }) } else { Err(LinearError::NotFinite) }
    }
}

/// Returns, for each edge, the derivatives of half the loss by the logarithm s and by the length.
pub(super) fn gradients(members: &[Member]) -> Vec<[f64; 2]> {
    members.iter().map(|member| [member.sums.g_s, member.sums.g_l]).collect()
}
