//! Solves a checked request for a lattice, and makes the archive of its result.

use super::UniformStatistics;
use crate::audit::comparison::Audit;
use crate::audit::crossings::Crossings;
use crate::solved::{self, CoordinateSystem, UnauditedResult, archive, generator, origin, to_json, warnings};
use plateau_archive::archive::Contents;
use plateau_archive::{Attribute, LineSet, Lines};
use plateau_mesh::self_intersections::Order;
use plateau_mesh::{Error, Execution};
use plateau_uniform_mesh as uniform_mesh;

#[derive(Debug)]
pub(super) struct SolverInput {
    pub domain: uniform_mesh::Domain,
    pub options: uniform_mesh::Options,
}

impl solved::SolverInput for SolverInput {
    fn solve(&self, coordinates: CoordinateSystem, exec: &Execution) -> Result<UnauditedResult, Error> {
        let Self { domain, options } = self;
        let mut solved = uniform_mesh::solve(domain, options, exec)?;
        let (mesh, warned) = (&solved.mesh, &mut solved.warnings);
        let crossings = match domain {
            uniform_mesh::Domain::Polygon { .. } => Crossings::count_in_plane(mesh, warned, exec)?,
            _ => Crossings::count(mesh, Order::Spatial, usize::MAX, warned, exec)?,
        };
        let statistics = to_json(&UniformStatistics::of(&solved, options, crossings, origin(&solved.mesh)))?;
        // Lattice and rim members are separate groups with their own material, so that a viewer can tell them apart.
        let group = |name: &str, lattice: bool| {
            let members = || (0..solved.members.len()).filter(|&member| solved.lattice_group[member] == lattice);
            let lengths = members().map(|member| solved.lengths[member]).collect();
            let attributes = vec![Attribute::new("length", coordinates.unit.symbol(), lengths)];
            let lines = Lines::Segments(members().map(|member| solved.members[member]).collect());
            LineSet { name: "members".into(), group: name.into(), lines, attributes }
        };
        let line_sets = vec![group("lattice", true), group("rim", false)];
        let archive = archive(Contents {
            generator: generator(),
            title: "uniform mesh".into(),
            unit: coordinates.unit,
            up: coordinates.up,
            input_vertices: input_vertices(domain, &solved),
            mesh: solved.mesh,
            line_sets,
            statistics: statistics.clone(),
            ..Contents::default()
        })?;
        let reproducible = solved.converged && !crossings.cut_short;
        Ok(UnauditedResult { statistics, warnings: warnings(solved.warnings), archive, reproducible })
    }

    fn audit(&self, audit: &mut Audit) {
        self.compare(audit);
    }
}

/// Returns, for each polyline of a polygon, the vertices that its points became. The list is empty for other domains,
/// because their points are not nodes.
fn input_vertices(domain: &uniform_mesh::Domain, mesh: &uniform_mesh::UniformMesh) -> Vec<Vec<u32>> {
    let uniform_mesh::Domain::Polygon { outer, holes } = domain else { return Vec::new() };
    let mut vertices = mesh.input_vertices.iter().copied().flatten();
    let lengths = std::iter::once(outer.len()).chain(holes.iter().map(Vec::len));
    lengths.map(|length| vertices.by_ref().take(length).collect()).collect()
}
