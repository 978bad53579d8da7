//! From a checked request for strips to its stored result.

use super::RuledStatistics;
use crate::audit::comparison::Audit;
use crate::solved::{self, Draft, Frame, archive, generator, line_set, origin, polylines, to_json, warnings};
use plateau_archive::Lines;
use plateau_archive::archive::BRIDGES;
use plateau_archive::archive::Contents;
use plateau_mesh::{DVec3, Error, Execution};
use plateau_ruled_surface as ruled_surface;

#[derive(Debug)]
pub(super) struct SolverInput {
    pub directrices: Vec<Vec<DVec3>>,
    pub options: ruled_surface::Options,
}

impl solved::SolverInput for SolverInput {
    fn solve(&self, frame: Frame, exec: &Execution) -> Result<Draft, Error> {
        let Self { directrices, options } = self;
        let surface = ruled_surface::solve(directrices, options, exec)?;
        let statistics = to_json(&RuledStatistics::of(&surface, options, origin(&surface.mesh)))?;
        let unrolls = surface.flat_pattern.is_some();
        let archive = archive(Contents {
            generator: generator(),
            title: "ruled surface".into(),
            unit: frame.unit,
            up: frame.up,
            mesh: surface.mesh,
            line_sets: vec![
                line_set("directrices", polylines(&surface.directrices, options.closed)),
                line_set(BRIDGES, Lines::Segments(surface.bridges)),
            ],
            input_vertices: surface.input_vertices,
            statistics: statistics.clone(),
            unrolls,
            ..Contents::default()
        })?;
        Ok(Draft { statistics, warnings: warnings(surface.warnings), archive, reproducible: true })
    }

    fn audit(&self, audit: &mut Audit) {
        self.compare(audit);
    }
}
