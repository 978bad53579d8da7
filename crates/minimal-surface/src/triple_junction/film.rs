//! A film whose sheets meet three by three, and how it is read from a mesh.

use plateau_equilibrium::Body;
use plateau_mesh::complex::{Complex, VertexKind};
use plateau_mesh::error::InputError;
use plateau_mesh::{DVec3, Error, Place, measure};
use std::collections::BTreeMap;

/// Number of junctions that meet in a point of a soap film, together with six sheets (Plateau's second law).
const JUNCTIONS_AT_A_POINT: usize = 4;

/// A film whose sheets meet three by three.
#[derive(Clone, Debug)]
pub(super) struct JunctionFilm {
    pub vertices: Vec<DVec3>,
    pub complex: Complex,
}

impl JunctionFilm {
    /// Reads a film from a mesh.
    ///
    /// # Errors
    /// [`Error::Input`] under `initial_mesh`: two triangles with the same corners, a triangle without area or with a
    /// vertex that does not exist, a vertex that is not finite, an edge of more than three triangles, or a
    /// [defect](plateau_mesh::complex::ComplexDefect) of the complex.
    pub fn read(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, Error> {
        let place = || Place::field("initial_mesh");
        let mut errors = Vec::new();
        let mut seen = BTreeMap::new();
        for (t, triangle) in triangles.iter().enumerate() {
            let mut refuse =
                |detail: String| InputError::new(place().then("triangles").at(t), detail).add_to(&mut errors);
            let mut corners = *triangle;
            corners.sort_unstable();
            let first = *seen.entry(corners).or_insert(t);
            if first < t {
                refuse(format!("has the same corners as triangle {first}"));
            }
            if triangle.iter().any(|&v| v as usize >= vertices.len()) {
                refuse("names a vertex that does not exist".into());
            } else if measure::is_degenerate(triangle.map(|v| vertices[v as usize])) {
                refuse("has no area".into());
            }
        }
        for (v, _) in vertices.iter().enumerate().filter(|(_, vertex)| !vertex.is_finite()) {
            let detail = "every coordinate must be a finite number";
            InputError::new(place().then("vertices").at(v), detail).add_to(&mut errors);
        }
        if !errors.is_empty() {
            return Err(Error::Input(errors));
        }
        let complex =
            Complex::build(triangles, vertices.len()).map_err(|defect| Error::input(place(), defect.to_string()))?;
        if let Some(edge) = complex.edges().find(|edge| edge.count() > 3) {
            let ([a, b], count) = (edge.ends, edge.count());
            let detail = format!("{count} triangles share the edge between the vertices {a} and {b}");
            return Err(Error::input(place(), detail));
        }
        Ok(Self { vertices, complex })
    }

    pub fn area(&self) -> f64 {
        let area = |&t: &[u32; 3]| 0.5 * measure::double_area_vector(self.corners(t)).length();
        self.complex.triangles.iter().map(area).sum()
    }

    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| self.vertices[v as usize])
    }

    /// Returns the film as a body of surface tension 1.
    pub fn body(&self) -> Body {
        Body::new(self.vertices.clone(), &self.complex, &vec![1.0; self.complex.sheets.len()])
    }

    /// Returns the unit tangent of a junction between two of its vertices; the x axis if they coincide.
    pub fn tangent(&self, [a, b]: [u32; 2]) -> DVec3 {
        (self.vertices[b as usize] - self.vertices[a as usize]).normalize_or(DVec3::X)
    }

    /// Returns the points at which a number of junctions other than four meet, each with that number.
    pub fn unstable_points(&self) -> Vec<(u32, usize)> {
        let mut meeting = vec![0; self.vertices.len()];
        self.complex.junctions().iter().flatten().for_each(|&v| meeting[v as usize] += 1);
        let point =
            |&(v, count): &(usize, usize)| self.complex.kinds[v] == VertexKind::Point && count != JUNCTIONS_AT_A_POINT;
        meeting.into_iter().enumerate().filter(point).map(|(v, count)| (v as u32, count)).collect()
    }
}
