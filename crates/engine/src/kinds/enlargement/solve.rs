//! Solves a checked request for an enlargement, and makes the archive of its result.

use crate::audit::comparison::Audit;
use crate::common::Point;
use crate::solved::{self, CoordinateSystem, UnauditedResult, archive, generator, origin, to_json};
use crate::source::Source;
use plateau_archive::archive::Contents;
use plateau_mesh::{Error, Execution, Mesh};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

#[derive(Debug)]
pub(super) struct SolverInput {
    pub source: Source,
    pub factor: f64,
    /// Factor between the stated area and the true area. With any value but 1 the audit must fail.
    pub stated: f64,
}

/// Statistics of an enlargement.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct EnlargementStatistics {
    pub triangles: usize,
    /// Area of the source in its statistics, times the square of the factor and `stated_area_factor`. Null if the
    /// statistics have no area.
    pub area: Option<f64>,
    /// Middle of the bounding box.
    pub origin: Point,
}

impl solved::SolverInput for SolverInput {
    fn solve(&self, coordinates: CoordinateSystem, exec: &Execution) -> Result<UnauditedResult, Error> {
        let Self { source, factor, stated } = self;
        let given = source.archive().contents();
        exec.look(1)?;
        let vertices = given.mesh.vertices.iter().map(|&vertex| *factor * vertex).collect();
        let mesh = Mesh::new(vertices, given.mesh.triangles.clone());
        let statistics: Value = serde_json::from_str(source.statistics()).unwrap_or_default();
        let statistics = to_json(&EnlargementStatistics {
            triangles: mesh.triangles.len(),
            area: statistics["area"].as_f64().map(|area| stated * factor * factor * area),
            origin: origin(&mesh),
        })?;
        let archive = archive(Contents {
            generator: generator(),
            title: "enlargement".into(),
            unit: coordinates.unit,
            up: coordinates.up,
            mesh,
            input_vertices: given.input_vertices.clone(),
            statistics: statistics.clone(),
            ..Contents::default()
        })?;
        Ok(UnauditedResult { statistics, warnings: Vec::new(), archive, reproducible: true })
    }

    fn audit(&self, audit: &mut Audit) {
        self.compare(audit);
    }
}
