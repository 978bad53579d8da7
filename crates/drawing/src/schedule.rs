//! Schedules: the members, nodes, bends, cables and supports of a result as tables, and the numbered lattice in space.
//!
//! A table is CSV with one head row. Units stand last in the names of the columns and are the client's. Every number
//! has all its digits. Nodes and members count from 0 in the order of the mesh.

pub mod bends;
pub mod cables;
pub mod csv;
pub mod lattice;
mod request;
pub mod space;

use crate::parameters::Refused;
use lattice::Lattice;
use plateau_archive::Contents;
use plateau_archive::archive::CABLES;
pub use request::{Content, PARAMETERS, Part, ScheduleOptions};
use serde_json::Value;

/// Returns the parts that a result has.
#[must_use]
pub fn parts(contents: &Contents) -> Vec<Part> {
    let statistics: Value = serde_json::from_str(&contents.statistics).unwrap_or_default();
    let has = |name: &str| statistics[name].as_array().is_some_and(|list| !list.is_empty());
    let has_lattice = Lattice::is_in(contents);
    let cables = has("cables") && contents.line_sets.iter().any(|set| set.name == CABLES);
    let present = |part: &Part| match part {
        Part::Members | Part::Nodes => has_lattice,
        Part::Bends => contents.unrolls,
        Part::Cables | Part::CableEdges => cables,
        Part::Reactions => has("reactions"),
        Part::EdgeReactions => has("edge_reactions"),
    };
    Part::ALL.into_iter().filter(present).collect()
}

/// Makes a schedule of a result.
///
/// # Errors
/// Returns [`Refused::NoPart`] unless the result has this part, and [`Refused::Unsuitable`] if a parameter does not
/// suit the result.
pub fn schedule(contents: &Contents, options: &ScheduleOptions) -> Result<Vec<u8>, Refused> {
    let parts = parts(contents);
    let needed = match options.content {
        Content::Space => Part::Members,
        Content::Table(part, _) => part,
    };
    if !parts.contains(&needed) {
        return Err(Refused::NoPart(parts.into_iter().map(Part::name).collect()));
    }
    let statistics: Value = serde_json::from_str(&contents.statistics).unwrap_or_default();
    let table = match &options.content {
        Content::Space => return space::to_dxf(&Lattice::of(contents), contents, options),
        Content::Table(Part::Members, _) => lattice::members(&Lattice::of(contents), contents, options)?,
        Content::Table(Part::Nodes, _) => lattice::nodes(&Lattice::of(contents), contents, options),
        Content::Table(Part::Bends, pattern) => bends::bends(contents, pattern.as_deref())?,
        Content::Table(Part::Cables, _) => cables::cables(contents, &statistics),
        Content::Table(Part::CableEdges, _) => cables::cable_edges(contents, &statistics),
        Content::Table(Part::Reactions, _) => cables::reactions(contents, &statistics),
        Content::Table(Part::EdgeReactions, _) => cables::edge_reactions(contents, &statistics),
    };
    Ok(table.into_bytes())
}
