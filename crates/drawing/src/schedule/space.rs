//! The numbered lattice or net in space, as DXF.

use super::lattice::Lattice;
use super::request::ScheduleOptions;
use crate::dxf;
use crate::parameters::Refused;
use plateau_archive::Contents;
use plateau_archive::units::Unit;
use plateau_mesh::DVec3;

/// Most layers of a file. Programs for drawings list layers one by one.
const MOST_LAYERS: usize = 1000;
/// Height of the numbers, as a fraction of the mean length of the members.
const NUMBER_HEIGHT: f64 = 0.1;

/// Writes each member as a line on the layer of its kind, its number at its middle, and the number of each node. The
/// coordinates are the client's, and `$INSUNITS` names the unit.
///
/// # Errors
/// Returns [`Refused::Unsuitable`] at `tolerance` if there are more kinds of members than a file may have layers.
pub(super) fn to_dxf(lattice: &Lattice, contents: &Contents, options: &ScheduleOptions) -> Result<Vec<u8>, Refused> {
    let kinds = lattice.member_kinds(options.tolerance);
    let count = kinds.iter().max().map_or(0, |last| last + 1);
    if count > MOST_LAYERS {
        let detail = format!("makes {count} kinds of members, more than {MOST_LAYERS} layers; give a larger one");
        return Err(Refused::unsuitable("tolerance", detail));
    }
    let layer = |kind: usize| format!("MEMBERS_{kind}");
    let mut layers: Vec<(String, u8, &'static str)> =
        (0..count).map(|kind| (layer(kind), 1 + (kind % 6) as u8, "CONTINUOUS")).collect();
    layers.push(("MEMBER_NUMBERS".into(), 7, "CONTINUOUS"));
    layers.push(("NODE_NUMBERS".into(), 8, "CONTINUOUS"));
    let units = match contents.unit {
        Unit::Inch => 1,
        Unit::Foot => 2,
        Unit::Millimetre => 4,
        Unit::Centimetre => 5,
        Unit::Metre => 6,
    };
    let lengths: f64 = (0..lattice.members.len()).map(|member| lattice.length(member as u32)).sum();
    let height = NUMBER_HEIGHT * lengths / lattice.members.len().max(1) as f64;
    let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let extent = lattice.nodes.iter().fold(empty, |[low, high], &node| [low.min(node), high.max(node)]);
    Ok(dxf::file(&layers, extent, units, &contents.generator, |out| {
        for (number, ends) in lattice.members.iter().enumerate() {
            let ends = ends.map(|node| lattice.nodes[node as usize]);
            out.line(ends, &layer(kinds[number]));
            out.text_at(&number.to_string(), ends[0].midpoint(ends[1]), height, 0.0, "MEMBER_NUMBERS");
        }
        for (number, &node) in lattice.nodes.iter().enumerate() {
            if !lattice.at_nodes[number].is_empty() {
                out.text_at(&number.to_string(), node, height, 0.0, "NODE_NUMBERS");
            }
        }
    }))
}
