//! Measures the stated figures of an enlargement again, and compares.

use super::solve::SolverInput;
use crate::audit::comparison::Audit;
use crate::audit::surface::Surface;

impl SolverInput {
    pub(super) fn compare(&self, audit: &mut Audit) {
        let mesh = &audit.contents.mesh;
        audit.equal("/triangles", mesh.triangles.len());
        let source = &self.source.archive().contents().mesh.vertices;
        let stretched = source.len() == mesh.vertices.len()
            && source.iter().zip(&mesh.vertices).all(|(given, now)| self.factor * *given == *now);
        audit.require(stretched, || "each vertex is that of the source, enlarged".into(), || "it is not".into());
        if !audit.value("/area").is_null() {
            audit.figure("/area", Surface::of(&mesh.vertices, &mesh.triangles, audit.step).area.measured());
        }
    }
}
