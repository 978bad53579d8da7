//! Solves a checked request for a film, and makes the archive of its result.

use super::MinimalStatistics;
use super::certificate::{CertifyOptions, Proof};
#[cfg(feature = "certificates")]
use super::proof;
use crate::audit::comparison::Audit;
use crate::audit::crossings::Crossings;
use crate::join::Notes;
use crate::solved::{
    self, CoordinateSystem, Kept, Moved, UnauditedResult, archive, generator, line_set, origin, polylines, to_json,
    warnings,
};
use plateau_archive::archive::{Contents, MEAN_CURVATURE};
use plateau_archive::{Attribute, Lines};
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::self_intersections::Order;
use plateau_mesh::{DVec3, Error, Execution, Interruption, polyline};
use plateau_minimal_surface as minimal_surface;
use plateau_minimal_surface::{KeptFilm, MovedFilm};
use std::any::Any;

#[derive(Debug)]
pub(super) struct SolverInput {
    pub boundaries: Vec<Vec<DVec3>>,
    pub options: minimal_surface::Options,
    /// Whether and how to prove a lower bound of the area.
    pub certify: Option<CertifyOptions>,
    pub joined: Notes,
}

/// Least value at which the default colour scale of the mean curvature ends, times the boundary's radius. 95% of the
/// vertices of a converged film of usual resolution are below it, so that the film's discretisation error does not use
/// the whole scale.
const LEAST_RANGE: f64 = 0.01;
/// Fraction of the vertices that are within the default colour scale of the mean curvature. The few largest values, at
/// the corners of the boundary, are beyond the scale, so that they do not determine the colours of all others.
const WITHIN_SCALE: f64 = 0.95;

impl solved::SolverInput for SolverInput {
    fn solve(&self, coordinates: CoordinateSystem, exec: &Execution) -> Result<UnauditedResult, Error> {
        let Self { boundaries, options, certify, joined } = self;
        let share = if certify.is_some() { 0.5 } else { 1.0 };
        let surface = exec.part([0.0, share], |exec| minimal_surface::solve(boundaries, options, exec));
        let mut surface = surface.map_err(|error| joined.added_to(error))?;
        surface.warnings.splice(0..0, joined.warnings.iter().cloned());
        let crossings = Crossings::count(&surface.mesh, Order::Spatial, usize::MAX, &mut surface.warnings, exec)?;
        let mut statistics = MinimalStatistics::of(&surface.statistics, crossings, origin(&surface.mesh));
        let mut proof = Proof::default();
        #[cfg(feature = "certificates")]
        if let Some(options) = *certify {
            let search = |exec: &Execution| proof::search(boundaries, &mut surface, options, &mut statistics, exec);
            proof = exec.part([share, 1.0], search)?;
        }
        let cut_short = proof.interrupted || crossings.cut_short;
        let reproducible = surface.statistics.stop_reason != StopReason::Deadline && !cut_short;
        let statistics = to_json(&statistics)?;
        let points: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
        let centre = polyline::mean(&points);
        let radius = points.iter().map(|point| point.distance(centre)).fold(0.0, f64::max);
        let mut line_sets = vec![line_set("boundaries", polylines(&surface.boundaries, true))];
        if let Some(junctions) = &surface.statistics.junctions {
            line_sets.push(line_set("junctions", polylines(&junctions.curves, false)));
        }
        let least_range = if radius > 0.0 { LEAST_RANGE / radius } else { 0.0 };
        let per_length = format!("1/{}", coordinates.unit.symbol());
        let curvature = Attribute::new(MEAN_CURVATURE, per_length, surface.mean_curvature)
            .ending_at_percentile(WITHIN_SCALE, least_range);
        let archive = archive(Contents {
            generator: generator(),
            title: "minimal surface".into(),
            unit: coordinates.unit,
            up: coordinates.up,
            mesh: surface.mesh,
            vertex_attributes: std::iter::once(curvature).chain(proof.slack).collect(),
            line_sets,
            input_vertices: surface.input_vertices,
            statistics: statistics.clone(),
            proof: proof.document,
            ..Contents::default()
        })?;
        Ok(UnauditedResult { statistics, warnings: warnings(surface.warnings), archive, reproducible })
    }

    fn audit(&self, audit: &mut Audit) {
        self.compare(audit);
    }

    fn keep(&self, result: &Contents, exec: &Execution) -> Result<Option<Box<dyn Kept>>, Error> {
        let Self { boundaries, options, .. } = self;
        let Some(Lines::Polylines(lines)) = result.line_sets.first().map(|set| &set.lines) else { return Ok(None) };
        let loops: Vec<Vec<u32>> = lines.iter().map(|line| line.vertices.clone()).collect();
        let film = KeptFilm::new(&result.mesh, &loops, boundaries, options, exec)?;
        Ok(film.map(|film| -> Box<dyn Kept> { Box::new(Drag { film, options: options.clone() }) }))
    }
}

/// A film that moves with its boundary while the user drags points.
#[derive(Debug)]
struct Drag {
    film: KeptFilm,
    options: minimal_surface::Options,
}

impl Kept for Drag {
    fn move_to(&mut self, input: &dyn solved::SolverInput, exec: &Execution) -> Result<Option<Moved>, Interruption> {
        let input: &dyn Any = input;
        let input = input.downcast_ref::<SolverInput>();
        let Some(SolverInput { boundaries, options, .. }) = input else { return Ok(None) };
        if *options != self.options {
            return Ok(None);
        }
        let moved = self.film.move_to(boundaries, exec)?;
        Ok(moved.map(|MovedFilm { area, residual }| Moved { area, residual }))
    }

    fn vertices(&self) -> Vec<DVec3> {
        self.film.vertices().collect()
    }
}
