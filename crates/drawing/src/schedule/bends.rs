//! Bends of a flat pattern.

use super::csv::{Cell, Table};
use crate::divide;
use crate::metal;
use crate::options::{Layer, PatternOptions};
use crate::parameters::Refused;
use plateau_archive::Contents;

/// Returns the table of bends in millimetres. Bends have a radius and a bend allowance if the pattern is one of sheet
/// metal. Folds that stay flat are no bends.
pub(super) fn bends(contents: &Contents, options: Option<&PatternOptions>) -> Result<Table, Refused> {
    let default = PatternOptions::default();
    let options = options.unwrap_or(&default);
    let mut table = Table::new(&[
        "piece",
        "bend",
        "bridge",
        "angle_deg",
        "direction",
        "radius_mm",
        "bend_allowance_mm",
        "length_mm",
    ]);
    let mut bend = 0;
    for figure in divide::of_result(contents, options)? {
        let lines: Vec<_> = figure.lines.iter().filter(|line| line.layer != Layer::FoldFlat).collect();
        for hits in lines.chunk_by(|one, next| one.bridge == next.bridge) {
            let angle: f64 = hits.iter().map(|hit| hit.angle_deg).sum();
            let direction = if angle < 0.0 { "up" } else { "down" };
            let of_metal = options.metal.as_ref();
            let allowance = of_metal.map(|metal| metal::bend_allowance(metal, angle.abs().to_radians()));
            let middle = hits[hits.len() / 2];
            table.row(&[
                Cell::Text(&figure.name),
                Cell::Count(bend),
                Cell::Count(middle.bridge as usize),
                Cell::Number(angle),
                Cell::Text(direction),
                of_metal.map(|metal| metal.radius).into(),
                allowance.into(),
                Cell::Number(middle.ends[0].distance(middle.ends[1])),
            ]);
            bend += 1;
        }
    }
    Ok(table)
}
