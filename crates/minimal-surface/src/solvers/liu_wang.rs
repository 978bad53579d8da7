//! Liu and Wang, *Constructing Minimal Triangular Mesh Based on Discrete Mean Curvature*, CISME 1(7), 2011.
//!
//! 1. The initial mesh is a Delaunay triangulation of the loop with n points inside. The points are chosen by a seed
//!    from candidates at barycentres (`initial_mesh/barycentres.rs`).
//! 2. The mesh is faired once: every interior vertex becomes the mean of its neighbours (Tutte's map with uniform
//!    weights). Then it is made Delaunay.
//! 3. Levenberg and Marquardt's method (their Fig. 5) minimises F = ½ Σ H_i² over the positions of the interior
//!    vertices, with H_i = (1/B_i) Σ_e β(e)|e|/2 ([`curvature`]).
//! 4. The mesh is made Delaunay again. Steps 3 and 4 repeat until the triangulation stays the same.
//!
//! Departures from the paper:
//! - The curvatures at boundary vertices are left out unless the caller asks for them. Their eq. 1 includes them. But a
//!   boundary vertex has only half a ring of triangles, whose terms do not cancel, so F falls by degenerating
//!   triangles.
//! - Step 2 is added, because without the curvatures at the boundary F has n terms for 3 n unknowns. Every start then
//!   reaches F = 0 and keeps the layout of its points along the surface, so the start decides the result. Only the
//!   candidate mesh of step 1 is faired; other initial meshes are taken as they are. `candidate_fairing: false` leaves
//!   the fairing out.
//! - Lengths are divided by the radius R of the boundary first, because the four stopping criteria depend on the scale.
//! - |F_k - F_{k-1}| is tested after accepted steps only. In the printed form every rejected step would end the run.
//! - The gradient of the dihedral angle has a closed form that is regular at a flat edge. Their eq. 3 is 0/0 there. As
//!   printed, its denominators |n₁|² and |n₂|² are exchanged. Its signs are right; a wrong sign is in the line of its
//!   proof that derives ∂(n₁·n₂).
//! - Step 4 flips the edges whose two opposite angles add up to more than 180°. The mesh is then Delaunay on the
//!   surface itself, and no plane projection is needed. The flips end, because each lowers the Dirichlet energy.
//! - A mesh of several loops, or without interior vertices, is taken as it is.

mod curvature;

use crate::curvature::Curvature;
use crate::options::{Limits, LiuWang, Solver};
use crate::run::{HistoryRow, Run};
use curvature::CurvatureRows;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::delaunay::flip_to_delaunay;
use plateau_mesh::sparse::Symbolic;
use plateau_mesh::sparse::levenberg_marquardt::{Criteria, LeastSquares, NormalEquations, Stop, minimise};
use plateau_mesh::sparse::pattern::{FIXED, Pattern};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Progress};

/// Largest number of steps, over all rounds, if the caller gives none (k_max in the paper).
const MAX_ITERATIONS: u32 = 500;
/// Largest number of rounds of steps 3 and 4, because flips and solves could undo each other for ever.
const MAX_ROUNDS: usize = 50;

/// Damping of Levenberg and Marquardt's method at the start, as a fraction of the largest diagonal entry of JᵀJ (τ in
/// Madsen, Nielsen and Tingleff).
const DAMPING: f64 = 1e-6;

/// The objective F = ½ Σ H² as a function of the positions of the vertices that may move.
struct Bending {
    rows: CurvatureRows,
    vertices: Vec<DVec3>,
    /// The vertices that may move.
    moving: Vec<usize>,
    /// The largest diagonal entry of the first JᵀJ.
    scale: Option<f64>,
}

impl Bending {
    fn new(rows: CurvatureRows, vertices: Vec<DVec3>) -> Self {
        let moving = (0..vertices.len()).filter(|&v| rows.unknown_of(v).is_some()).collect();
        Self { rows, vertices, moving, scale: None }
    }

    fn places(&self) -> Vec<DVec3> {
        self.moving.iter().map(|&v| self.vertices[v]).collect()
    }

    fn put(&mut self, places: &[DVec3]) {
        for (&v, &place) in self.moving.iter().zip(places) {
            self.vertices[v] = place;
        }
    }
}

impl LeastSquares<3> for Bending {
    type Location = DVec3;

    fn couplings(&self, couple: &mut dyn FnMut(&[u32])) {
        (0..self.rows.rows()).for_each(|row| couple(self.rows.row(row).0));
    }

    fn energy(&mut self, x: &[DVec3]) -> f64 {
        self.put(x);
        self.rows.evaluate(&self.vertices)
    }

    fn assemble(&mut self, x: &[DVec3], normal: &mut NormalEquations<3>) {
        self.put(x);
        self.rows.differentiate(&self.vertices);
        for row in 0..self.rows.rows() {
            let (columns, values) = self.rows.row(row);
            let derivatives: Vec<[f64; 3]> = values.iter().map(|&by| by.into()).collect();
            normal.add(self.rows.curvatures()[row], columns, &derivatives);
        }
        self.scale.get_or_insert(normal.largest_diagonal());
    }

    fn metric(&self, _node: usize) -> [[f64; 3]; 3] {
        let scale = self.scale.unwrap_or(1.0);
        [[scale, 0.0, 0.0], [0.0, scale, 0.0], [0.0, 0.0, scale]]
    }

    fn advance(&self, x: &[DVec3], step: &[[f64; 3]], to: &mut [DVec3]) -> f64 {
        for ((place, &from), &step) in to.iter_mut().zip(x).zip(step) {
            *place = from + DVec3::from(step);
        }
        1.0
    }
}

/// Steps 2 to 4 on a film: lowers F = ½ Σ H² until the triangulation stays the same. The fairing of step 2 is made only
/// if `fairs` is set.
///
/// `options.tolerance` is their ε, for lengths divided by R. A run ends at |ΔF| < ε(1 + F), ‖∇F‖∞ < ∛ε(1 + F), ‖δ‖∞ <
/// √ε(1 + ‖δ‖∞), or after `max_iterations` steps. Where F vanishes, the *normal cycle* curvature of the surface
/// vanishes. A surface with F = 0 is near a minimal surface, but does not have the least area; the residual tells how
/// near it is. The run checks for an interruption after every sweep over the triangles and after every factorisation.
/// At a deadline the film is the best film so far.
///
/// # Errors
/// [`Interruption::Cancelled`].
pub(crate) fn run(
    film: &mut Film,
    options: &LiuWang,
    fairs: bool,
    limits: Limits,
    execution: &Execution,
) -> Result<Run, Error> {
    if fairs {
        fair(film);
    }
    let mut run = Run::new(Solver::LevenbergMarquardt);
    let radius = film.radius();
    let given = film.vertices.clone();
    film.vertices.iter_mut().for_each(|vertex| *vertex /= radius);
    let outcome = rounds(film, options, limits, radius, &mut run, execution);
    for (vertex, (given, fixed)) in film.vertices.iter_mut().zip(given.into_iter().zip(&film.fixed)) {
        *vertex = if *fixed { given } else { *vertex * radius };
    }
    match outcome {
        Ok(stop_reason) => run.stop_reason = stop_reason,
        Err(Interruption::DeadlinePassed) => run.stop_reason = StopReason::Deadline,
        Err(interruption) => return Err(interruption.into()),
    }
    Ok(run)
}

/// Step 2 without the flips: moves every free vertex to the mean of its neighbours, all at once. A film whose linear
/// system has no solution stays as it is.
fn fair(film: &mut Film) {
    let pattern = Pattern::new(film.triangles(), &film.fixed);
    let count = pattern.free.vertex.len();
    let mut matrix = pattern.matrix();
    let mut means = vec![0.0; 3 * count];
    for (triangle, slots) in film.triangles().iter().zip(&pattern.slots) {
        for k in 0..3 {
            // This visits every neighbour of an interior vertex once, because each is the end of one half-edge from the
            // vertex.
            let (row, end) = (pattern.free.unknown[triangle[k] as usize], triangle[(k + 1) % 3] as usize);
            if row == FIXED {
                continue;
            }
            let row = row as usize;
            matrix.values[pattern.row_start[row] as usize] += 1.0;
            if slots[k] == FIXED {
                let place = film.vertices[end].to_array();
                (0..3).for_each(|axis| means[axis * count + row] += place[axis]);
            } else {
                matrix.values[slots[k] as usize] = -1.0;
            }
        }
    }
    let solved = Symbolic::analyse(&matrix, None)
        .and_then(|symbolic| symbolic.factorise(&matrix).and_then(|factor| factor.solve(&mut means)));
    if count == 0 || solved.is_err() {
        return;
    }
    for (row, &v) in pattern.free.vertex.iter().enumerate() {
        film.vertices[v as usize] = DVec3::new(means[row], means[count + row], means[2 * count + row]);
    }
}

fn rounds(
    film: &mut Film,
    options: &LiuWang,
    limits: Limits,
    radius: f64,
    run: &mut Run,
    execution: &Execution,
) -> Result<StopReason, Interruption> {
    let max_iterations = limits.max_iterations.unwrap_or(MAX_ITERATIONS);
    run.edges_swapped += flip_to_delaunay(film, execution)?;
    execution.look(film.triangles().len() as u64)?;
    let mut stop_reason = StopReason::NothingToMove;
    for _ in 0..MAX_ROUNDS {
        let moves: Vec<bool> = film.fixed.iter().map(|fixed| !fixed).collect();
        let rows = CurvatureRows::new(&film.topology, &moves, options.boundary_curvature);
        let epsilon = options.tolerance;
        let criteria = Criteria {
            damping: DAMPING,
            change: epsilon,
            floor: 1.0,
            quiet_steps: 1,
            gradient: libm::cbrt(epsilon),
            step: epsilon.sqrt(),
            max_iterations: u64::from(max_iterations.saturating_sub(run.iterations)),
        };
        let mut bending = Bending::new(rows, film.vertices.clone());
        let moving = bending.moving.clone();
        let mut places = bending.places();
        let mut observe = |_: u64, places: &[DVec3], objective_value: f64| {
            for (&v, &place) in moving.iter().zip(places) {
                film.vertices[v] = place;
            }
            run.iterations += 1;
            let residual = Curvature::of(film).residual_felt;
            let area = film.area() * radius * radius;
            let iteration = run.iterations;
            run.history.push(HistoryRow { phase: "mean_curvature", iteration, area, residual });
            execution.report(Progress {
                fraction: f64::from(iteration) / f64::from(max_iterations.max(1)),
                phase: "mean_curvature",
                iteration: u64::from(iteration),
                objective_value: Some(objective_value),
                residual: Some(residual),
            });
        };
        let (stop, objective_value) = minimise(&mut bending, &mut places, criteria, &mut observe, execution);
        run.objective_value = Some(objective_value);
        stop_reason = match stop {
            Stop::Change => StopReason::ObjectiveChange,
            Stop::Gradient => StopReason::Gradient,
            Stop::Step => StopReason::StepLength,
            Stop::NoUnknowns => StopReason::NothingToMove,
            Stop::NoStep => StopReason::Stalled,
            Stop::MaxIterations => return Ok(StopReason::MaxIterations),
            Stop::Interrupted(interruption) => return Err(interruption),
        };
        let swapped = flip_to_delaunay(film, execution)?;
        execution.look(film.triangles().len() as u64)?;
        run.edges_swapped += swapped;
        if swapped == 0 {
            break;
        }
    }
    Ok(stop_reason)
}
