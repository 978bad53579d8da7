//! The iteration of Pinkall and Polthier, *Computing Discrete Minimal Surfaces and Their Conjugates* (1993), section 3:
//!
//! 1. Take the current mesh as the domain. Its cotangent weights give the Dirichlet energy of a piecewise linear map.
//! 2. Minimise that energy with the boundary fixed: one sparse positive definite system, three right-hand sides.
//! 3. The image is the next domain. Repeat.
//!
//! The area never rises, because area(image) <= energy(image) <= energy(identity) = area(domain). The iteration
//! converges linearly. A few rounds make a good mesh of a poor one. A small residual takes many rounds;
//! [`newton`](plateau_equilibrium::newton) reaches it faster.
//!
//! Departure from the paper: the cotangent weights of a triangle whose area vanishes are bounded
//! ([`area`](plateau_equilibrium::energy::area)). The linear solver therefore reports a collapsing neck, and the matrix
//! has no infinite entry.

use plateau_equilibrium::energy::dirichlet::laplacian;
use plateau_mesh::codes::Reason;
use plateau_mesh::film::Film;
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::sparse::{CgFailure, LinearError, Symbolic, SymmetricMatrix, conjugate_gradients};
use plateau_mesh::{DVec3, Error, Execution, Interruption};

/// Residual at which conjugate gradients stop, as a fraction of the residual at the start of the solve.
const ITERATIVE_TOLERANCE: f64 = 1e-10;

/// Whether a step solved its linear systems by elimination, which needs a factorisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Elimination {
    Used,
    Spared,
}

/// Solver of Dirichlet problems on meshes of one connectivity. The symbolic factorisation is computed once.
#[derive(Debug)]
pub(crate) struct Dirichlet {
    pub pattern: Pattern,
    symbolic: Symbolic,
    matrix: SymmetricMatrix,
    right_hand_side: Vec<f64>,
    storage: Vec<f64>,
}

impl Dirichlet {
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub fn new(film: &Film) -> Result<Self, LinearError> {
        Self::of(film.triangles(), &film.fixed)
    }

    /// # Errors
    /// [`LinearError::TooLarge`].
    pub fn of(triangles: &[[u32; 3]], fixed: &[bool]) -> Result<Self, LinearError> {
        Self::of_pattern(Pattern::new(triangles, fixed))
    }

    /// Does the same as [`new`](Self::new) for a mesh in which more than two triangles may share an edge.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub fn of_complex(triangles: &[[u32; 3]], fixed: &[bool]) -> Result<Self, LinearError> {
        Self::of_pattern(Pattern::of_complex(triangles, fixed))
    }

    fn of_pattern(pattern: Pattern) -> Result<Self, LinearError> {
        let matrix = pattern.matrix();
        let symbolic = Symbolic::analyse(&matrix, None)?;
        Ok(Self { pattern, symbolic, matrix, right_hand_side: Vec::new(), storage: Vec::new() })
    }

    /// Steps 1 and 2: moves the free vertices to the positions of least energy. The film must have the connectivity for
    /// which this solver was made. On an error the film stays as it was.
    ///
    /// # Errors
    /// A [`LinearError`] if the mesh has collapsed so far that the system has no trustworthy solution.
    pub fn step(&mut self, film: &mut Film) -> Result<(), LinearError> {
        self.move_to_minimum(&mut film.vertices, film.topology.triangles())
    }

    /// Does the same as [`step`](Self::step) for separate vertices and triangles.
    ///
    /// # Errors
    /// The errors of [`step`](Self::step).
    pub fn move_to_minimum(&mut self, vertices: &mut [DVec3], triangles: &[[u32; 3]]) -> Result<(), LinearError> {
        self.solve(vertices, vertices, triangles)?;
        self.place(vertices);
        Ok(())
    }

    /// Moves the free vertices of `image` so that the map from `domain` is harmonic: all coordinates of the image are
    /// discrete harmonic functions on the domain. On an error the image stays as it was.
    ///
    /// # Errors
    /// The errors of [`step`](Self::step).
    pub fn map(&mut self, domain: &[DVec3], image: &mut [DVec3], triangles: &[[u32; 3]]) -> Result<(), LinearError> {
        self.solve(domain, image, triangles)?;
        self.place(image);
        Ok(())
    }

    /// Computes the minimum of the energy among the maps from `domain` that keep the fixed vertices of `image`, and
    /// leaves the coordinates of the free vertices in `right_hand_side`.
    fn solve(&mut self, domain: &[DVec3], image: &[DVec3], triangles: &[[u32; 3]]) -> Result<(), LinearError> {
        laplacian(&self.pattern, domain, image, triangles, &mut self.matrix, &mut self.right_hand_side);
        let factorisation = self.symbolic.factorise_into(&self.matrix, std::mem::take(&mut self.storage))?;
        if !factorisation.inertia().is_positive_definite() {
            return Err(LinearError::Singular);
        }
        factorisation.solve(&mut self.right_hand_side)?;
        self.storage = factorisation.into_storage();
        Ok(())
    }

    /// Puts the free vertices to the coordinates in `right_hand_side`.
    fn place(&self, vertices: &mut [DVec3]) {
        let (n, x) = (self.pattern.free.vertex.len(), &self.right_hand_side);
        for (row, &vertex) in self.pattern.free.vertex.iter().enumerate() {
            vertices[vertex as usize] = DVec3::new(x[row], x[n + row], x[2 * n + row]);
        }
    }

    /// Does the same as [`step`](Self::step) by conjugate gradients from the present positions. If one of the three
    /// coordinates does not converge, all three are solved by elimination. Returns which of the two methods was used,
    /// or why elimination failed. On an error the film stays as it was.
    ///
    /// # Errors
    /// The interruptions of `exec`.
    pub fn step_by_conjugate_gradients(
        &mut self,
        film: &mut Film,
        exec: &Execution,
    ) -> Result<Result<Elimination, LinearError>, Interruption> {
        let at = &film.vertices;
        laplacian(&self.pattern, at, at, film.triangles(), &mut self.matrix, &mut self.right_hand_side);
        let n = self.pattern.free.vertex.len();
        let mut image = vec![DVec3::ZERO; n];
        for (axis, b) in self.right_hand_side.chunks_exact(n).enumerate() {
            let mut x: Vec<f64> = self.pattern.free.vertex.iter().map(|&v| film.vertices[v as usize][axis]).collect();
            match self.solve_from(&mut x, b, exec) {
                Ok(_) => {}
                Err(CgFailure::Interrupted(interruption)) => return Err(interruption),
                Err(CgFailure::Indefinite | CgFailure::Slow) => return Ok(self.step(film).map(|()| Elimination::Used)),
            }
            image.iter_mut().zip(x).for_each(|(point, x)| point[axis] = x);
        }
        for (&vertex, point) in self.pattern.free.vertex.iter().zip(image) {
            film.vertices[vertex as usize] = point;
        }
        Ok(Ok(Elimination::Spared))
    }

    /// Solves by conjugate gradients from `x` until the residual has decreased to [`ITERATIVE_TOLERANCE`] of its first
    /// value. The number of iterations is at most the order of the matrix plus one.
    fn solve_from(&self, x: &mut [f64], b: &[f64], exec: &Execution) -> Result<usize, CgFailure> {
        let square = |residual: &[f64]| residual.iter().map(|r| r * r).sum::<f64>();
        let mut first = vec![0.0; b.len()];
        self.matrix.multiply(x, &mut first);
        first.iter_mut().zip(b).for_each(|(first, b)| *first = b - *first);
        let goal = ITERATIVE_TOLERANCE * ITERATIVE_TOLERANCE * square(&first);
        let is_small = |residual: &[f64]| square(residual) <= goal;
        conjugate_gradients(&self.matrix, b, x, |r, z| z.copy_from_slice(r), is_small, b.len() + 1, exec)
    }
}

/// The error for a mesh whose factor does not fit into memory.
pub(crate) fn too_large(_: LinearError) -> Error {
    Error::no_result(
        Reason::TooLarge,
        "the linear system of this mesh does not fit into memory; ask for fewer triangles",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::structured::patch;

    #[test]
    fn one_solve_flattens_a_patch_with_a_plane_rim() {
        let mut film = patch(8, 8, |u, v| DVec3::new(u, v, (u * (1.0 - u) * v * (1.0 - v)).sqrt()));
        Dirichlet::new(&film).unwrap().step(&mut film).unwrap();
        assert!(film.vertices.iter().all(|vertex| vertex.z.abs() < 1e-14));
    }
}
