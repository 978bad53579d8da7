//! Solves a checked request for a cable net, and makes the archive of its result.

use super::{CableNetStatistics, Group};
use crate::audit::comparison::Audit;
use crate::solved::{self, CoordinateSystem, UnauditedResult, archive, generator, reactions, to_json, warnings};
use plateau_archive::archive::{CABLES, Contents, middle};
use plateau_archive::units::ForceUnit;
use plateau_archive::{Attribute, LineSet, Lines};
use plateau_cable_net as cable_net;
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::Warning;
use plateau_mesh::{Error, Execution, Mesh};

#[derive(Debug)]
pub(super) struct SolverInput {
    pub net: cable_net::Net,
    pub options: cable_net::Options,
    pub groups: Vec<Group>,
    pub force: ForceUnit,
}

/// Maximum number of edges that a warning names.
const NAMED_EDGES: usize = 10;

impl solved::SolverInput for SolverInput {
    fn solve(&self, coordinates: CoordinateSystem, exec: &Execution) -> Result<UnauditedResult, Error> {
        let Self { net, options, groups, force } = self;
        let force = *force;
        let found = cable_net::solve(net, options, exec)?;
        let statistics =
            to_json(&CableNetStatistics::of(&found, net, groups, force, middle(&found.vertices).to_array()))?;
        let forces = |values: Vec<f64>| Attribute::new("force", force.symbol(), values);
        let set = |group: &Group| LineSet {
            name: CABLES.into(),
            group: group.name.clone(),
            lines: Lines::Segments(group.edges.iter().map(|&k| net.edges[k].ends).collect()),
            attributes: vec![forces(group.edges.iter().map(|&k| found.forces[k]).collect())],
        };
        let mut line_sets: Vec<LineSet> = groups.iter().map(set).collect();
        let feet = net.supports.iter().map(|&v| found.vertices[v as usize]).zip(found.reactions.iter().copied());
        line_sets.push(reactions(feet.collect(), &found.vertices, forces));
        let warnings = warnings(net_warnings(&found));
        let archive = archive(Contents {
            generator: generator(),
            title: "cable net".into(),
            unit: coordinates.unit,
            up: coordinates.up,
            input_vertices: vec![(0..found.vertices.len() as u32).collect()],
            mesh: Mesh::new(found.vertices, Vec::new()),
            line_sets,
            statistics: statistics.clone(),
            ..Contents::default()
        })?;
        let reproducible = found.stop_reason != cable_net::StopReason::Deadline;
        Ok(UnauditedResult { statistics, warnings, archive, reproducible })
    }

    fn audit(&self, audit: &mut Audit) {
        self.compare(audit);
    }
}

fn net_warnings(found: &cable_net::CableNet) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if !found.converged() {
        let detail = format!(
            "the net is in equilibrium, but the loss still fell when the solver stopped ({}): allow more iterations",
            found.stop_reason.name()
        );
        warnings.push(Warning::new(WarningCode::NotConverged, detail));
    }
    let missed = edges_where(&found.missed, "these edges miss a target by more than half");
    warnings.extend(
        missed.map(|(detail, count)| Warning::new(WarningCode::TargetsMissed, detail).with_count("count", count)),
    );
    let slack = "the targets leave these edges no force; least_force_density keeps a force in them";
    let slack = edges_where(&found.slack, slack);
    warnings
        .extend(slack.map(|(detail, count)| Warning::new(WarningCode::SlackCable, detail).with_count("count", count)));
    warnings
}

/// Returns `detail` followed by the names of the first marked edges, and the number of all marked edges. Returns `None`
/// if no edge is marked.
fn edges_where(marked: &[bool], detail: &str) -> Option<(String, usize)> {
    let edges: Vec<usize> = (0..marked.len()).filter(|&k| marked[k]).collect();
    let names: Vec<String> = edges.iter().take(NAMED_EDGES).map(|k| format!("/edges/{k}")).collect();
    let more = edges.len() - names.len();
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    (!edges.is_empty()).then(|| (format!("{detail}: {}{more}", names.join(", ")), edges.len()))
}
