//! Solves a checked request for strips, and makes the archive of its result.

use super::RuledStatistics;
use crate::audit::comparison::Audit;
use crate::audit::crossings::Crossings;
use crate::solved::{
    self, CoordinateSystem, UnauditedResult, archive, generator, line_set, origin, polylines, to_json, warnings,
};
use plateau_archive::archive::{BRIDGES, CONCAVE, Contents, DIRECTRICES};
use plateau_archive::{Attribute, LineSet, Lines};
use plateau_mesh::self_intersections::Order;
use plateau_mesh::{DVec3, Error, Execution};
use plateau_ruled_surface as ruled_surface;

/// Largest number of triangles that are searched for self-intersections. The limit saves time: from some ten thousand
/// triangles on, the search for self-intersections takes longer than the search for a strip of least area, which visits
/// a thousandth of its grid.
const MOST_SEARCHED_TRIANGLES: usize = 200_000;

#[derive(Debug)]
pub(super) struct SolverInput {
    pub directrices: Vec<Vec<DVec3>>,
    pub options: ruled_surface::Options,
}

impl solved::SolverInput for SolverInput {
    fn solve(&self, coordinates: CoordinateSystem, exec: &Execution) -> Result<UnauditedResult, Error> {
        let Self { directrices, options } = self;
        let mut surface = ruled_surface::solve(directrices, options, exec)?;
        let (mesh, warned) = (&surface.mesh, &mut surface.warnings);
        let crossings = Crossings::count(mesh, Order::AsGiven, MOST_SEARCHED_TRIANGLES, warned, exec)?;
        let statistics = to_json(&RuledStatistics::of(&surface, options, crossings, origin(&surface.mesh)))?;
        let mut concave = vec![0.0; surface.bridges.len()];
        for of_bridge in &surface.concave_bridges {
            concave[of_bridge.bridge as usize] = 1.0;
        }
        let concave = Attribute { range: [0.0, 1.0], ..Attribute::new(CONCAVE, "", concave) };
        let archive = archive(Contents {
            generator: generator(),
            title: "ruled surface".into(),
            unit: coordinates.unit,
            up: coordinates.up,
            mesh: surface.mesh,
            line_sets: vec![
                line_set(DIRECTRICES, polylines(&surface.directrices, options.closed)),
                LineSet { attributes: vec![concave], ..line_set(BRIDGES, Lines::Segments(surface.bridges)) },
            ],
            input_vertices: surface.input_vertices,
            statistics: statistics.clone(),
            unrolls: true,
            ..Contents::default()
        })?;
        Ok(UnauditedResult {
            statistics,
            warnings: warnings(surface.warnings),
            archive,
            reproducible: !crossings.cut_short,
        })
    }

    fn audit(&self, audit: &mut Audit) {
        self.compare(audit);
    }
}
