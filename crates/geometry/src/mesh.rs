//! An indexed, oriented triangle mesh. Connectivity ([`topology`]) never sees positions; [`edit`] changes it;
//! [`measure`] and [`check`] see both.

pub mod check;
pub mod complex;
pub(crate) mod crossing;
mod cut;
pub mod edit;
pub(crate) mod film;
pub mod measure;
#[cfg(test)]
pub(crate) mod structured;
pub mod topology;

use crate::DVec3;

/// Triangles over vertices; counter-clockwise seen from the side that the normals point to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions.
    pub vertices: Vec<DVec3>,
    /// For each triangle the numbers of its vertices.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A mesh of these; nothing is checked ([`check`](Self::check) does).
    #[must_use]
    pub fn new(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Self {
        Self { vertices, triangles }
    }

    /// The three corners of a triangle.
    #[must_use]
    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|vertex| self.vertices[vertex as usize])
    }
}
