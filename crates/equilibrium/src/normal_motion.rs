//! The scalar fast path: a film whose free vertices each move along their normal.

use super::newton::{Equations, State};
use super::residual::residual;
use crate::energy::area;
use crate::energy::area::{FirstVariation, first_variation};
use plateau_mesh::DVec3;
use plateau_mesh::measure;
use plateau_mesh::sparse::SymmetricMatrix;
use plateau_mesh::sparse::pattern::{FIXED, FreeVertices, Pattern};

/// A force on a vertex of a film counts as zero up to this many units of rounding of R. Coordinates are of the order of
/// R, and each of the about six triangles at a vertex rounds its force by a few units. Beside two boundary points that
/// nearly coincide, the vertex's share of area may be 1e-12 R². Without this threshold, rounding errors divided by this
/// share make a residual of 1e-4 or more wherever the vertex is. In films whose edges are longer than 1e-4 R the
/// threshold corresponds to a residual of about 2e-7 or less.
const ROUNDING: f64 = 16.0;

/// The state of a film. Its frame holds the normals of all vertices, including the fixed ones.
pub type FilmState = State<Vec<DVec3>>;

/// Returns the state of a film of surface tension 1 whose `free` vertices move along their normals. Newton's iteration
/// uses it, and its residual is reported.
pub fn film_state(free: &FreeVertices, vertices: &[DVec3], triangles: &[[u32; 3]], radius: f64) -> FilmState {
    let normals = measure::normals(vertices, triangles);
    let FirstVariation { area, gradient, mass } = first_variation(free, vertices, triangles, &normals);
    let rounding = ROUNDING * f64::EPSILON * radius;
    let felt = gradient.iter().map(|&force| if force.abs() > rounding { force } else { 0.0 });
    let residual = residual(felt.zip(mass.iter().copied()), radius);
    State { frame: normals, energy: area, magnitude: area, gradient, mass, residual, constraints: Vec::new() }
}

/// The equations of a film of surface tension 1, with one unknown per free vertex: its height along the present vertex
/// normal.
#[derive(Clone, Copy, Debug)]
pub struct NormalMotion<'a> {
    pub pattern: &'a Pattern,
    pub triangles: &'a [[u32; 3]],
    /// R, the length that makes the residual dimensionless.
    pub radius: f64,
}

impl Equations for NormalMotion<'_> {
    type Frame = Vec<DVec3>;

    const LOWEST_MODE_HAS_ONE_SIGN: bool = true;

    fn state(&self, vertices: &[DVec3]) -> FilmState {
        film_state(&self.pattern.free, vertices, self.triangles, self.radius)
    }

    fn second_variation(&self, vertices: &[DVec3], state: &FilmState, shift: f64, matrix: &mut SymmetricMatrix) {
        area::second_variation(self.pattern, vertices, self.triangles, &state.frame, shift, matrix);
    }

    fn matrix(&self) -> SymmetricMatrix {
        self.pattern.matrix()
    }

    fn moved(&self, vertices: &[DVec3], state: &FilmState, step: &[f64], fraction: f64) -> Vec<DVec3> {
        let move_one = |((&vertex, &normal), &row): ((&DVec3, &DVec3), &u32)| match row {
            FIXED => vertex,
            row => vertex + fraction * step[row as usize] * normal,
        };
        vertices.iter().zip(&state.frame).zip(&self.pattern.free.unknown).map(move_one).collect()
    }

    fn triangles(&self) -> &[[u32; 3]] {
        self.triangles
    }

    fn radius(&self) -> f64 {
        self.radius
    }
}
