//! Solves a checked request for a tensile structure, and makes the archive of its result.

use super::TensileStatistics;
use crate::audit::comparison::Audit;
use crate::audit::crossings::Crossings;
use crate::join::Notes;
use crate::solved::{
    self, CoordinateSystem, UnauditedResult, archive, generator, line_set, origin, polylines, reactions, to_json,
    warnings,
};
use plateau_archive::archive::{CABLES, Contents};
use plateau_archive::units::{ForceUnit, Unit};
use plateau_archive::{Attribute, LineSet, Lines};
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::self_intersections::Order;
use plateau_mesh::{DVec3, Error, Execution};
use plateau_tensile_structure as tensile_structure;

/// Name of the line set of the held segments of the boundaries.
pub(super) const HELD_EDGES: &str = "held edges";

#[derive(Debug)]
pub(super) struct SolverInput {
    pub structure: tensile_structure::Structure,
    pub options: tensile_structure::Options,
    pub force: ForceUnit,
    pub joined: Notes,
}

/// Returns the principal stresses of the triangles, and the direction of the largest one.
fn stresses(of_triangles: &[tensile_structure::TriangleStress], force: ForceUnit, length: Unit) -> Vec<Attribute> {
    if of_triangles.is_empty() {
        return Vec::new();
    }
    let unit = format!("{}/{}", force.symbol(), length.symbol());
    let attribute = |name: &str, unit: &str, value: &dyn Fn(&tensile_structure::TriangleStress) -> f64| {
        Attribute::new(name, unit, of_triangles.iter().map(value).collect())
    };
    vec![
        attribute("stress_min", &unit, &|stress| stress.principal.0),
        attribute("stress_max", &unit, &|stress| stress.principal.1),
        attribute("stress_max_x", "", &|stress| stress.direction.x),
        attribute("stress_max_y", "", &|stress| stress.direction.y),
        attribute("stress_max_z", "", &|stress| stress.direction.z),
    ]
}

/// Returns the held segments of the boundaries, with the force per length of their supports on the structure.
fn held_edges(of_segments: &[tensile_structure::EdgeForce], force: ForceUnit, length: Unit) -> LineSet {
    let unit = format!("{}/{}", force.symbol(), length.symbol());
    let attribute = |name: &str, value: &dyn Fn(DVec3) -> f64| {
        Attribute::new(name, &unit, of_segments.iter().map(|own| value(own.per_length)).collect())
    };
    let attributes = vec![
        attribute("force_per_length", &DVec3::length),
        attribute("force_per_length_x", &|force| force.x),
        attribute("force_per_length_y", &|force| force.y),
        attribute("force_per_length_z", &|force| force.z),
    ];
    let segments = of_segments.iter().map(|own| own.segment).collect();
    LineSet { attributes, ..line_set(HELD_EDGES, Lines::Segments(segments)) }
}

impl solved::SolverInput for SolverInput {
    fn solve(&self, coordinates: CoordinateSystem, exec: &Execution) -> Result<UnauditedResult, Error> {
        let Self { structure, options, force, joined } = self;
        let force = *force;
        let found = tensile_structure::solve(structure, options, exec);
        let mut found = found.map_err(|error| joined.added_to(error))?;
        found.warnings.splice(0..0, joined.warnings.iter().cloned());
        let crossings = Crossings::count(&found.mesh, Order::Spatial, usize::MAX, &mut found.warnings, exec)?;
        let statistics = to_json(&TensileStatistics::of(&found, structure, force, crossings, origin(&found.mesh)))?;
        let forces = |values: Vec<f64>| Attribute::new("force", force.symbol(), values);
        let mut line_sets = vec![line_set("boundaries", polylines(&found.boundaries, true))];
        for (cable, result) in structure.cables.iter().zip(&found.cables) {
            let pairs = result.vertices.windows(2).map(|pair| [pair[0], pair[1]]).collect();
            // The force of a mast is positive if it pushes, as in the statistics.
            let (name, sign) = if cable.course.is_mast() { ("masts", -1.0) } else { (CABLES, 1.0) };
            let attributes = vec![forces(result.segment_forces.iter().map(|force| sign * force).collect())];
            let (group, lines) = (cable.name.clone(), Lines::Segments(pairs));
            line_sets.push(LineSet { name: name.into(), group, lines, attributes });
        }
        if !found.edge_forces.is_empty() {
            line_sets.push(held_edges(&found.edge_forces, force, coordinates.unit));
        }
        let single = found.reactions.iter().map(|reaction| (reaction.vertex, reaction.force));
        let feet = single.chain(found.edge_supports.iter().copied());
        let feet = feet.map(|(vertex, force)| (found.mesh.vertices[vertex as usize], force));
        line_sets.push(reactions(feet.collect(), &found.mesh.vertices, forces));
        let archive = archive(Contents {
            generator: generator(),
            title: "tensile structure".into(),
            unit: coordinates.unit,
            up: coordinates.up,
            input_vertices: found.input_vertices,
            mesh: found.mesh,
            triangle_attributes: stresses(&found.stresses, force, coordinates.unit),
            line_sets,
            statistics: statistics.clone(),
            ..Contents::default()
        })?;
        let reproducible = found.statistics.stop_reason != StopReason::Deadline && !crossings.cut_short;
        Ok(UnauditedResult { statistics, warnings: warnings(found.warnings), archive, reproducible })
    }

    fn audit(&self, audit: &mut Audit) {
        self.compare(audit);
    }
}
