//! Chen, Cai, Zheng, *Constructing Triangular Meshes of Minimal Area* (Computer-Aided Design & Applications 5, 2008).
//!
//! The method has three processes for a mesh whose boundary is fixed (their sections 3.1 to 3.3):
//! 1. *Laplacian fairing* moves every interior vertex at once to Σ w_ij P_j. The weight w_ij is proportional to the
//!    area of the two triangles at the edge ij.
//! 2. *Area minimising* moves one vertex at a time, in index order, to the solution of the linearised equation ∂A/∂P_h
//!    = 0 (their eq. 5).
//! 3. *Edge swapping* swaps interior edges as long as that reduces the area and leaves a manifold.
//!
//! Their algorithm (section 3.4) swaps once. Then it repeats fairing and swapping until the area changes by less than
//! ε₁, and area minimising and swapping until it changes by less than ε₂. The caller may name other stages.
//!
//! Departures from the paper:
//! - Their tolerances are areas. Ours are relative to the area, so that they mean the same at every scale.
//! - Eq. 5 is written for the step P_h(new) - P_h, so that large coordinates cost no digits. With frozen weights the
//!   step minimises a weighted sum of squared distances to the lines of the opposite edges, so it does not raise the
//!   area (Weiszfeld). The weight of a triangle without height would be infinite and is bounded.
//! - A swap must reduce the area by more than rounding (1e-12 of the products of sides) and must not make a degenerate
//!   triangle.
//! - Fairing does not lower the area in every step and could alternate between two states for ever. The iterations of
//!   each stage are therefore limited to its share of the remaining iterations.
//! - If the caller bounds the mean curvature, the last stage goes on until the film is within the bound.

use crate::curvature::Curvature;
use crate::options::{Limits, Process, Solver, VertexRelaxation};
use crate::run::{HistoryRow, Run};
use glam::DMat3;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::film::Film;
use plateau_mesh::measure::double_area_vector;
use plateau_mesh::remesh::area_flips::reduces_area;
use plateau_mesh::{DVec3, Error, Execution, Interruption, Progress};

/// Largest number of sweeps if the caller gives none.
const DEFAULT_SWEEPS: u32 = 10_000;

/// Number of triangles visited between two checks for an interruption. Visiting them takes less than a millisecond.
const LOOK_EVERY: u64 = 20_000;

/// Relaxes the film stage by stage. The mesh is valid at every moment; at a deadline the run ends with the present
/// mesh.
///
/// # Errors
/// [`Error::Interrupted`] on cancel.
pub(crate) fn run(film: &mut Film, options: &VertexRelaxation, limits: Limits, exec: &Execution) -> Result<Run, Error> {
    let paper = || {
        vec![
            vec![Process::LaplacianFairing, Process::EdgeSwapping],
            vec![Process::AreaMinimising, Process::EdgeSwapping],
        ]
    };
    let stages = options.processes.clone().unwrap_or_else(paper);
    let mut relaxation = Relaxation {
        film,
        exec,
        limits,
        limit: limits.max_iterations.unwrap_or(DEFAULT_SWEEPS),
        iterations: 0,
        history: Vec::new(),
        swapped: 0,
        work: 0,
        fraction: 0.0,
    };
    let stop_reason = match relaxation.stages(&stages, options) {
        Ok(reason) => reason,
        Err(Interruption::DeadlinePassed) => StopReason::Deadline,
        Err(Interruption::Cancelled) => return Err(Interruption::Cancelled.into()),
    };
    let Relaxation { iterations, history, swapped, .. } = relaxation;
    Ok(Run { stop_reason, iterations, history, edges_swapped: swapped, ..Run::new(Solver::VertexRelaxation) })
}

struct Relaxation<'a> {
    film: &'a mut Film,
    exec: &'a Execution<'a>,
    limits: Limits,
    limit: u32,
    iterations: u32,
    history: Vec<HistoryRow>,
    swapped: u64,
    /// Number of triangles visited since the last check for an interruption.
    work: u64,
    fraction: f64,
}

impl Relaxation<'_> {
    fn stages(&mut self, stages: &[Vec<Process>], options: &VertexRelaxation) -> Result<StopReason, Interruption> {
        if stages.iter().flatten().any(|&process| process == Process::EdgeSwapping) {
            self.swap_edges()?;
        }
        if self.film.fixed.iter().all(|&fixed| fixed) {
            return Ok(StopReason::NothingToMove);
        }
        let mut reason = StopReason::AreaChange;
        for (k, stage) in stages.iter().enumerate() {
            let tolerance = if stage.contains(&Process::AreaMinimising) {
                options.area_tolerance
            } else {
                options.fairing_tolerance.unwrap_or(options.area_tolerance)
            };
            let share = (self.limit - self.iterations) / (stages.len() - k) as u32;
            let span = (k as f64 / stages.len() as f64, (k + 1) as f64 / stages.len() as f64);
            let is_last = k + 1 == stages.len();
            let ended = self.stage(stage, tolerance, is_last, self.iterations + share, span)?;
            // The last stage decides the reason. An earlier stage that used up its iterations leaves the rest of its
            // work to the next stage.
            reason = if ended { StopReason::AreaChange } else { StopReason::MaxIterations };
        }
        Ok(reason)
    }

    /// Repeats a stage. Returns true if the area changed by less than the tolerance, and in the last stage the mean
    /// curvature is within its bound too. Returns false if the iterations were used up.
    fn stage(
        &mut self,
        stage: &[Process],
        tolerance: f64,
        is_last: bool,
        last_iteration: u32,
        span: (f64, f64),
    ) -> Result<bool, Interruption> {
        let phase =
            stage.iter().find(|process| **process != Process::EdgeSwapping).map_or("edge_swapping", |p| p.name());
        let mut area = self.film.area();
        let mut first_change = None;
        // At most `last_iteration` passes, because each pass is one iteration.
        loop {
            if self.iterations >= last_iteration {
                return Ok(false);
            }
            for process in stage {
                match process {
                    Process::LaplacianFairing => self.fair()?,
                    Process::AreaMinimising => self.minimise_area()?,
                    Process::EdgeSwapping => self.swap_edges()?,
                }
            }
            self.iterations += 1;
            let before = std::mem::replace(&mut area, self.film.area());
            let change = (before - area).abs() / area;
            let is_within = || !is_last || self.limits.allow(Curvature::of(self.film).largest());
            let ended = change.is_nan() || change <= tolerance && is_within();
            let first_change = *first_change.get_or_insert(change);
            // The changes decrease geometrically, so the logarithm of the change measures the progress of the stage.
            let part = libm::log(first_change / change) / libm::log(first_change / tolerance.max(1e-16));
            let part = if ended { 1.0 } else { part.clamp(0.0, 1.0) };
            self.remember(phase, area, span.0 + (span.1 - span.0) * part, ended || self.iterations >= last_iteration);
            if ended {
                return Ok(true);
            }
        }
    }

    /// Adds a history row and reports progress after the iterations that
    /// [`Statistics::history`](crate::Statistics) names.
    fn remember(&mut self, phase: &'static str, area: f64, fraction: f64, last: bool) {
        let k = self.iterations;
        let kept = k <= 100 || k.is_multiple_of(100) || (k <= 1000 && k.is_multiple_of(10));
        if !(kept || last) {
            return;
        }
        let residual = Curvature::of(self.film).residual_felt;
        self.work += 2 * self.film.triangles().len() as u64;
        self.history.push(HistoryRow { phase, iteration: k, area, residual });
        self.fraction = self.fraction.max(if fraction.is_nan() { 0.0 } else { fraction });
        self.exec.report(Progress {
            fraction: self.fraction,
            phase,
            iteration: u64::from(k),
            objective_value: Some(area),
            residual: Some(residual),
        });
    }

    fn worked(&mut self, triangles: u64) -> Result<(), Interruption> {
        self.work += triangles;
        if self.work >= LOOK_EVERY { self.exec.look(std::mem::take(&mut self.work)) } else { Ok(()) }
    }

    /// Makes one iteration of Laplacian fairing (section 3.2).
    fn fair(&mut self) -> Result<(), Interruption> {
        let mut sums = vec![(DVec3::ZERO, 0.0); self.film.vertices.len()];
        for (k, &[a, b, c]) in self.film.triangles().iter().enumerate() {
            let [p, q, r] = self.film.corners([a, b, c]);
            let area = double_area_vector([p, q, r]).length();
            for (vertex, others) in [(a, q + r), (b, r + p), (c, p + q)] {
                let sum = &mut sums[vertex as usize];
                sum.0 += area * others;
                sum.1 += 2.0 * area;
            }
            if k as u64 % LOOK_EVERY == LOOK_EVERY - 1 {
                self.exec.look(self.work + LOOK_EVERY)?;
                self.work = 0;
            }
        }
        for (v, (sum, weight)) in sums.into_iter().enumerate() {
            if !self.film.fixed[v] && weight > 0.0 {
                self.film.vertices[v] = sum / weight;
            }
        }
        self.worked(self.film.triangles().len() as u64 % LOOK_EVERY)
    }

    /// Makes one sweep of area minimising (section 3.1) over the free vertices.
    fn minimise_area(&mut self) -> Result<(), Interruption> {
        for v in 0..self.film.vertices.len() as u32 {
            if self.film.fixed[v as usize] {
                continue;
            }
            let (step, ring) = eq5_step(self.film, v);
            self.film.vertices[v as usize] += step;
            self.worked(ring)?;
        }
        Ok(())
    }

    /// Swaps edges (section 3.3) in passes over all edges until a pass swaps none.
    fn swap_edges(&mut self) -> Result<(), Interruption> {
        // Ends because each flip reduces the area by more than its rounding error.
        loop {
            let mut swapped = 0;
            for h in 0..self.film.topology.twin.len() as u32 {
                if h < self.film.topology.twin[h as usize]
                    && reduces_area(self.film, h)
                    && self.film.topology.can_flip(h)
                {
                    self.film.topology.flip(h);
                    swapped += 1;
                }
                self.worked(1)?;
            }
            self.swapped += swapped;
            if swapped == 0 {
                return Ok(());
            }
        }
    }
}

/// Returns the step of eq. 5 for one vertex, and the number of its triangles.
fn eq5_step(film: &Film, v: u32) -> (DVec3, u64) {
    let topology = &film.topology;
    let position = |vertex: u32| film.vertices[vertex as usize];
    let here = position(v);
    let (mut matrix, mut gradient, mut ring) = (DMat3::ZERO, DVec3::ZERO, 0);
    for h in topology.outgoing_half_edges(v) {
        let j = position(topology.to(h));
        let edge = position(topology.opposite(h)) - j;
        let to_j = j - here;
        let length_squared = edge.length_squared();
        // Twice the area of the triangle. It is bounded below, so that a vertex on the line of the opposite edge can
        // move.
        let double_area = edge.cross(to_j).length().max(1e-8 * length_squared);
        if double_area > 0.0 {
            let outer = DMat3::from_cols(edge.x * edge, edge.y * edge, edge.z * edge);
            matrix += (DMat3::from_diagonal(DVec3::splat(length_squared)) - outer) * (1.0 / double_area);
            gradient += (length_squared * to_j - edge.dot(to_j) * edge) / double_area;
        }
        ring += 1;
    }
    // The matrix is singular only if all opposite edges are parallel.
    let scale = matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z;
    let determinant = matrix.determinant();
    if determinant.is_nan() || determinant <= 1e-14 * scale * scale * scale {
        return (DVec3::ZERO, ring);
    }
    (matrix.inverse() * gradient, ring)
}
