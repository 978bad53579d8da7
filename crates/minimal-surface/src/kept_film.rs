//! A solved film that follows its boundary while a user drags it. The mesh and two matrix factors are kept from one
//! move to the next. A move has two steps:
//!
//! 1. The boundary takes its new places, and the interior follows harmonically: L d = -L_free,fixed d_fixed, with the
//!    displacements d and the cotangent Laplacian L of the film as it was solved. L is factorised once. The
//!    distribution of the vertices within the surface therefore depends only on the place of the boundary, not on the
//!    path by which the boundary got there.
//! 2. A few Newton steps in normal heights ([`newton`](plateau_equilibrium::newton)) correct the film to a residual of
//!    [`PREVIEW_TOLERANCE`]. Their linear systems are solved by conjugate gradients. The preconditioner is the factor
//!    of an earlier second variation. The factor is renewed when the conjugate gradients converge slowly.
//!
//! The result is a preview: its heights agree with those of the minimal surface to the preview's tolerance. A new solve
//! of the same boundary would build another mesh.

use super::harmonic::too_large;
use super::options::{Constraints, InitialMesh, Method, Newton, Options, TopologyRule};
use plateau_equilibrium::energy::area::Facet;
use plateau_equilibrium::newton::{Aim, Equations, Outcome, Settings, State, StepSolver, iterate, keeps_orientation};
use plateau_equilibrium::normal_motion::NormalMotion;
use plateau_equilibrium::v_cycle::accepts;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::small_angles::smallest_angle;
use plateau_mesh::sparse::pattern::{FIXED, Pattern};
use plateau_mesh::sparse::{CgFailure, LinearError, Symbolic, SymmetricMatrix, conjugate_gradients};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Mesh, measure, polyline};

/// Residual to which a preview is corrected, unless the request's tolerance is larger. The heights are then right to
/// about 1e-4 of the boundary's radius, which is less than a pixel.
const PREVIEW_TOLERANCE: f64 = 1e-4;
/// Largest number of Newton steps of one move. A move usually takes one or two. More than four steps would cost as much
/// as a solve.
const MOST_STEPS: u32 = 4;
/// Largest number of iterations of conjugate gradients with the factor of an earlier matrix. If more are needed, the
/// factor is renewed, which costs about as much as this many iterations.
const MOST_ITERATIONS: usize = 12;
/// Smallest angle that a moved film may have, as a fraction of the smallest angle of the kept film. A film with a
/// smaller angle is rejected.
const LEAST_ANGLE: f64 = 0.5;

/// A vertex that was added on a boundary, by its place on the segment between two input points.
#[derive(Clone, Copy, Debug)]
struct Added {
    vertex: u32,
    /// The input points at the ends of the segment.
    ends: [u32; 2],
    fraction: f64,
}

/// A film of least area that can be moved with its boundary.
#[derive(Debug)]
pub struct KeptFilm {
    /// The film after the last move, relative to `centre`.
    film: Film,
    centre: DVec3,
    /// The input points after the last move, not centred.
    points: Vec<DVec3>,
    /// Number of input points of each boundary.
    counts: Vec<usize>,
    added: Vec<Added>,
    pattern: Pattern,
    symbolic: Symbolic,
    laplacian: Vec<f64>,
    /// The entries of L between a free and a fixed vertex. Each has the row of the free vertex, the fixed vertex, and
    /// the entry.
    couplings: Vec<(u32, u32, f64)>,
    matrix: SymmetricMatrix,
    /// Factor of the second variation at the present or an earlier place. It preconditions the conjugate gradients.
    factor: Vec<f64>,
    settings: Settings,
    least_angle: f64,
}

/// Figures of a moved film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovedFilm {
    /// Area in the square of the caller's unit of length.
    pub area: f64,
    /// Residual, as [`Statistics::residual`](super::Statistics::residual) defines it.
    pub residual: f64,
}

impl KeptFilm {
    /// Keeps a film that [`solve`](super::solve) found. `mesh` and `loops` are the mesh and the boundary loops of the
    /// result. `boundaries` and `options` are those of the solve.
    ///
    /// Returns `None` in these cases, because such a film cannot be moved:
    ///
    /// - The solver is not Newton's method with a fixed topology.
    /// - The film has fixed points or curves inside.
    /// - The film began from a mesh of the caller.
    /// - The boundaries touch, or neighbouring points are equal.
    /// - The film is not stable.
    ///
    /// # Errors
    /// [`Error::Interrupted`], or [`Error::NoResult`] if the factor does not fit into memory.
    pub fn new(
        mesh: &Mesh,
        loops: &[Vec<u32>],
        boundaries: &[Vec<DVec3>],
        options: &Options,
        exec: &Execution,
    ) -> Result<Option<Self>, Error> {
        let Options { method, initial_mesh, constraints, .. } = options;
        let is_newton = matches!(method, Method::Newton(Newton { topology: TopologyRule::Fixed, .. }));
        if !is_newton || matches!(initial_mesh, InitialMesh::Given(_)) || *constraints != Constraints::default() {
            return Ok(None);
        }
        let points: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
        if points.len() > mesh.vertices.len() || points != mesh.vertices[..points.len()] {
            return Ok(None);
        }
        let Some(added) = places(mesh, loops, boundaries) else { return Ok(None) };
        let centre = polyline::mean(&points);
        let vertices = mesh.vertices.iter().map(|vertex| vertex - centre).collect();
        let Some(film) = Film::new(vertices, &mesh.triangles, loops.to_vec()) else { return Ok(None) };
        let vertex_count = film.vertices.len() as u32;
        if (0..vertex_count).any(|vertex| film.topology.is_boundary(vertex) != film.fixed[vertex as usize]) {
            return Ok(None);
        }
        let work = film.triangles().len() as u64;
        exec.look(work)?;
        let pattern = Pattern::new(film.triangles(), &film.fixed);
        let (mut matrix, couplings) = laplacian(&pattern, &film);
        let symbolic = Symbolic::analyse(&matrix, None).map_err(too_large)?;
        exec.look(work)?;
        let Some(laplacian) = positive_factor(&symbolic, &matrix, Vec::new()) else { return Ok(None) };
        exec.look(work)?;
        let motion = NormalMotion { pattern: &pattern, triangles: film.topology.triangles(), radius: film.radius() };
        let state = motion.state(&film.vertices);
        motion.second_variation(&film.vertices, &state, 0.0, &mut matrix);
        let Some(factor) = positive_factor(&symbolic, &matrix, Vec::new()) else { return Ok(None) };
        exec.look(work)?;
        let tolerance = options.tolerance.max(PREVIEW_TOLERANCE);
        let settings = Settings { aim: Aim::Minimum, tolerance, max_steps: MOST_STEPS };
        let least_angle = LEAST_ANGLE * smallest_angle(&film);
        let counts = boundaries.iter().map(Vec::len).collect();
        Ok(Some(Self {
            film,
            centre,
            points,
            counts,
            added,
            pattern,
            symbolic,
            laplacian,
            couplings,
            matrix,
            factor,
            settings,
            least_angle,
        }))
    }

    /// Moves the film so that its boundary points lie at the points of `boundaries`.
    ///
    /// Returns `None` and leaves the film where it is in these cases: the boundaries have other numbers of points, a
    /// triangle would turn over or become thin, or Newton's method does not converge in a few steps.
    ///
    /// # Errors
    /// The interruptions of `exec`. The film then stays where it is.
    pub fn move_to(&mut self, boundaries: &[Vec<DVec3>], exec: &Execution) -> Result<Option<MovedFilm>, Interruption> {
        if !boundaries.iter().map(Vec::len).eq(self.counts.iter().copied()) {
            return Ok(None);
        }
        exec.look(self.film.triangles().len() as u64)?;
        let before = self.film.vertices.clone();
        self.follow(boundaries);
        let moved = self.correct(&before, exec);
        if matches!(moved, Ok(Some(_))) {
            self.points = boundaries.iter().flatten().copied().collect();
        } else {
            self.film.vertices = before;
        }
        moved
    }

    /// Returns the vertices of the film after the last move, in the order of the solved mesh. The input points have
    /// exactly the given coordinates.
    pub fn vertices(&self) -> impl Iterator<Item = DVec3> {
        let others = self.film.vertices.iter().skip(self.points.len()).map(|vertex| vertex + self.centre);
        self.points.iter().copied().chain(others)
    }

    /// Step 1: moves the boundary to its new places, and the interior harmonically.
    fn follow(&mut self, boundaries: &[Vec<DVec3>]) {
        let Self { film, added, couplings, symbolic, laplacian, pattern, .. } = self;
        let vertices = &mut film.vertices;
        let mut moves = vec![DVec3::ZERO; vertices.len()];
        for ((vertex, by), point) in vertices.iter_mut().zip(&mut moves).zip(boundaries.iter().flatten()) {
            let place = point - self.centre;
            *by = place - *vertex;
            *vertex = place;
        }
        for &Added { vertex, ends, fraction } in added.iter() {
            let [a, b] = ends.map(|end| vertices[end as usize]);
            let place = a + fraction * (b - a);
            moves[vertex as usize] = place - vertices[vertex as usize];
            vertices[vertex as usize] = place;
        }
        let free = &pattern.free.vertex;
        let count = free.len();
        let mut right_hand_side = vec![0.0; 3 * count];
        for &(row, fixed, entry) in couplings.iter() {
            for (axis, by) in moves[fixed as usize].to_array().into_iter().enumerate() {
                right_hand_side[axis * count + row as usize] -= entry * by;
            }
        }
        symbolic.apply(laplacian, &mut right_hand_side);
        for (row, &vertex) in free.iter().enumerate() {
            let by = [0, 1, 2].map(|axis| right_hand_side[axis * count + row]);
            vertices[vertex as usize] += DVec3::from_array(by);
        }
    }

    /// Step 2: corrects the film by Newton's method. Then checks its triangles. Returns `None` if the film cannot be
    /// used.
    fn correct(&mut self, before: &[DVec3], exec: &Execution) -> Result<Option<MovedFilm>, Interruption> {
        if !keeps_orientation(self.film.triangles(), before, &self.film.vertices) {
            return Ok(None);
        }
        let radius = self.film.radius();
        let motion = NormalMotion { pattern: &self.pattern, triangles: self.film.topology.triangles(), radius };
        let mut steps = KeptFactor { symbolic: &self.symbolic, matrix: &mut self.matrix, factor: &mut self.factor };
        let vertices = &mut self.film.vertices;
        let (outcome, state) = iterate(vertices, &motion, &mut steps, &self.settings, exec, &mut |_, _| {});
        match outcome {
            Outcome::Converged => {}
            Outcome::Interrupted(interruption) => return Err(interruption),
            Outcome::Stalled | Outcome::StepsUsed | Outcome::Refused(_) => return Ok(None),
        }
        let is_sound = measure::count_flipped(&self.film.vertices, self.film.triangles(), &state.frame) == 0
            && smallest_angle(&self.film) >= self.least_angle;
        Ok(is_sound.then_some(MovedFilm { area: state.energy, residual: state.residual }))
    }
}

/// Returns the places of the vertices that were added on the boundaries. Returns `None` if a loop does not begin at its
/// first input point and run through the other points in order, because then the boundary touches itself or another
/// boundary.
fn places(mesh: &Mesh, loops: &[Vec<u32>], boundaries: &[Vec<DVec3>]) -> Option<Vec<Added>> {
    let mut added = Vec::new();
    let mut first = 0;
    if loops.len() != boundaries.len() {
        return None;
    }
    for (along, boundary) in loops.iter().zip(boundaries) {
        let end = first + boundary.len() as u32;
        let mut next = first;
        for &vertex in along {
            if vertex == next {
                next += 1;
                continue;
            }
            let ends = [next.checked_sub(1).filter(|&start| start >= first)?, if next == end { first } else { next }];
            let [a, b, place] = [ends[0], ends[1], vertex].map(|v| mesh.vertices[v as usize]);
            let side = b - a;
            let fraction = ((place - a).dot(side) / side.length_squared()).clamp(0.0, 1.0);
            added.push(Added { vertex, ends, fraction });
        }
        if next != end {
            return None;
        }
        first = end;
    }
    added.iter().all(|added| added.vertex >= first).then_some(added)
}

/// Returns the cotangent Laplacian of the free vertices, and its entries between free and fixed vertices.
fn laplacian(pattern: &Pattern, film: &Film) -> (SymmetricMatrix, Vec<(u32, u32, f64)>) {
    let (mut matrix, mut right_hand_side) = (pattern.matrix(), Vec::new());
    plateau_equilibrium::energy::dirichlet::laplacian(
        pattern,
        &film.vertices,
        &film.vertices,
        film.triangles(),
        &mut matrix,
        &mut right_hand_side,
    );
    let mut couplings = Vec::new();
    for triangle in film.triangles() {
        let facet = Facet::of(&film.vertices, triangle);
        for k in 0..3 {
            let (from, to) = (triangle[k], triangle[(k + 1) % 3]);
            let entry = 0.5 * facet.edges[k].dot(facet.edges[(k + 1) % 3]) / facet.double_area;
            match [from, to].map(|v| pattern.free.unknown[v as usize]) {
                [FIXED, FIXED] => {}
                [FIXED, row] => couplings.push((row, from, entry)),
                [row, FIXED] => couplings.push((row, to, entry)),
                _ => {}
            }
        }
    }
    (matrix, couplings)
}

/// Returns the factor of a matrix, or `None` if the matrix is not positive definite.
fn positive_factor(symbolic: &Symbolic, matrix: &SymmetricMatrix, storage: Vec<f64>) -> Option<Vec<f64>> {
    let factorisation = symbolic.factorise_into(matrix, storage).ok()?;
    factorisation.inertia().is_positive_definite().then(|| factorisation.into_storage())
}

/// Computes Newton's step by conjugate gradients, preconditioned with the factor of an earlier matrix.
struct KeptFactor<'a> {
    symbolic: &'a Symbolic,
    matrix: &'a mut SymmetricMatrix,
    factor: &'a mut Vec<f64>,
}

impl StepSolver<NormalMotion<'_>> for KeptFactor<'_> {
    fn step(
        &mut self,
        vertices: &[DVec3],
        equations: &NormalMotion,
        state: &State<Vec<DVec3>>,
        settings: &Settings,
        exec: &Execution,
    ) -> Result<Vec<f64>, Outcome> {
        let refused = Outcome::Refused(LinearError::Singular);
        equations.second_variation(vertices, state, 0.0, self.matrix);
        exec.look(equations.work()).map_err(Outcome::Interrupted)?;
        let mut step: Vec<f64> = vec![0.0; state.gradient.len()];
        let right_hand_side: Vec<f64> = state.gradient.iter().map(|gradient| -gradient).collect();
        let is_small = accepts(state, settings, equations.radius());
        for most in [MOST_ITERATIONS, 1] {
            let precondition = |residual: &[f64], out: &mut [f64]| {
                out.copy_from_slice(residual);
                self.symbolic.apply(self.factor, out);
            };
            step.fill(0.0);
            match conjugate_gradients(self.matrix, &right_hand_side, &mut step, precondition, &is_small, most, exec) {
                Ok(_) => return Ok(step),
                Err(CgFailure::Interrupted(interruption)) => return Err(Outcome::Interrupted(interruption)),
                Err(CgFailure::Indefinite) => return Err(refused),
                Err(CgFailure::Slow) if most == 1 => return Err(refused),
                Err(CgFailure::Slow) => {}
            }
            let storage = std::mem::take(self.factor);
            let Some(renewed) = positive_factor(self.symbolic, self.matrix, storage) else { return Err(refused) };
            *self.factor = renewed;
        }
        Err(refused)
    }
}
