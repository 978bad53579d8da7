//! A flat pattern as JSON, with every number in all digits.

use crate::figure::Figure;
use crate::kinds;
use crate::piece::Seam;
use crate::sheets::{Layout, Place};
use plateau_mesh::DVec2;
use serde_json::{Value, json};

/// Writes the figures. Lengths are in millimetres. The coordinates of a piece start at the lower left corner of its
/// cut, or at that of its sheet.
#[must_use]
pub fn to_json(figures: &[Figure], layout: Option<&Layout>) -> Vec<u8> {
    let place = |k: usize| layout.map(|layout| &layout.places[k]);
    let pieces: Vec<Value> = figures.iter().enumerate().map(|(k, figure)| piece(figure, place(k))).collect();
    let bends: usize = figures.iter().map(Figure::bends).sum();
    let sheet = |layout: &Layout, size: &DVec2| {
        json!({
            "width": layout.stock.size.x,
            "height": layout.stock.size.y,
            "size": { "width": size.x, "height": size.y },
        })
    };
    let sheets = layout.map(|layout| layout.sheets.iter().map(|size| sheet(layout, size)).collect::<Vec<_>>());
    let document = json!({
        "pieces": pieces,
        "sheets": sheets.unwrap_or_default(),
        "utilisation": layout.map(|layout| layout.utilisation),
        // A piece that fits no sheet is refused.
        "unplaced": [],
        "bends": bends,
        "kinds": kinds::count(figures),
    });
    // Serialization cannot fail because there are only lists, text and numbers.
    serde_json::to_vec(&document).unwrap_or_default()
}

/// Returns the name of a seam: rails and bridges count from 0.
#[must_use]
pub fn seam_name(seam: Seam) -> String {
    match seam {
        Seam::Rail(number) => format!("rail {number}"),
        Seam::Bridge(number) => format!("bridge {number}"),
    }
}

fn piece(figure: &Figure, place: Option<&Place>) -> Value {
    let [low, high] = figure.bounds();
    let size = high - low;
    let point = |at: DVec2| place.map_or(at - low, |place| place.point(at)).to_array();
    let points = |of: &[DVec2]| of.iter().map(|&at| point(at)).collect::<Vec<_>>();
    let lines: Vec<Value> = figure
        .lines
        .iter()
        .map(|line| {
            json!({
                "kind": line.layer.name().to_lowercase(),
                "ends": line.ends.map(point),
                "angle_deg": line.angle_deg,
                "bridge": line.bridge,
            })
        })
        .collect();
    let marks: Vec<Value> = figure
        .marks
        .iter()
        .map(|mark| json!({ "at": point(mark.at), "seam": seam_name(mark.seam), "arc_length": mark.arc_length }))
        .collect();
    json!({
        "name": figure.name,
        "size": { "width": size.x, "height": size.y },
        "outline": points(&figure.cut),
        "sew": figure.sew.as_deref().map(points),
        "sheet": place.map(|place| place.sheet),
        "turned_deg": place.map(Place::turned_deg),
        "lines": lines,
        "marks": marks,
    })
}
