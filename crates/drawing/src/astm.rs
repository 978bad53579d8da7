//! Pieces of cloth as DXF by ASTM D6673: AutoCAD R13 with one block a piece, and layers by number.
//!
//! Lengths are in millimetres, which the text `UNITS: METRIC` says, because R13 has no variable for it. The texts have
//! no dates, so that the same pattern gives the same bytes.

use crate::dxf;
use crate::figure::{Figure, Shape};
use crate::label::{self, Spot};
use crate::options::{Layer, PatternOptions};
use crate::polygon::{self, NOTCH_HALF_WIDTH};
use plateau_mesh::{DVec2, DVec3};

/// Layers of the standard that are used here.
const OUTLINE: &str = "1";
const TURN_POINTS: &str = "2";
const CURVE_POINTS: &str = "3";
const NOTCHES: &str = "4";
const GRAIN: &str = "7";
const INNER_LINES: &str = "8";
const SEWING_LINE: &str = "14";
const ANNOTATION: &str = "15";
const OUTLINE_VALIDATION: &str = "84";
const SEWING_VALIDATION: &str = "87";
/// All layers of the standard. Besides those above: cut-outs, drill holes, notches of other shapes (T, castle, check and
/// U), and the validation curves of inner lines and cut-outs.
const LAYERS: [&str; 18] = [
    OUTLINE,
    TURN_POINTS,
    CURVE_POINTS,
    NOTCHES,
    GRAIN,
    INNER_LINES,
    "11",
    "13",
    SEWING_LINE,
    ANNOTATION,
    "80",
    "81",
    "82",
    "83",
    OUTLINE_VALIDATION,
    "85",
    "86",
    SEWING_VALIDATION,
];

/// Cosine of the turn of an outline from which on a point is a turn point: 30 degrees. A smaller one lies on a curve.
const TURN: f64 = 0.866_025_403_784_438_6;

/// Writes the pieces, one below the other, with the first at the top.
pub(crate) fn to_dxf(figures: &[Figure], options: &PatternOptions, [title, generator]: [&str; 2]) -> Vec<u8> {
    let layers: Vec<_> = LAYERS.iter().map(|name| ((*name).to_owned(), 7, "CONTINUOUS")).collect();
    let names: Vec<String> = figures.iter().map(|figure| block_name(&figure.name)).collect();
    let sizes: Vec<DVec2> = figures.iter().map(|figure| figure.bounds()).map(|[low, high]| high - low).collect();
    let gap = sizes.iter().map(|size| size.max_element()).fold(0.0, f64::max) / 20.0;
    let mut places = vec![DVec2::ZERO; figures.len()];
    let mut top = 0.0;
    for k in (0..figures.len()).rev() {
        places[k] = DVec2::new(0.0, top);
        top += sizes[k].y + gap;
    }
    let width = sizes.iter().map(|size| size.x).fold(0.0, f64::max);
    let height = options.text_height;
    let list = |out: &mut dxf::Writer, rows: &[String], from: DVec2| {
        for (k, row) in rows.iter().enumerate() {
            let left = from - DVec2::new(0.0, 2.0 * height * k as f64);
            let at = left + DVec2::new(0.5 * label::width(row, height), 0.0);
            out.text(row, &Spot { starts_left: true, ..Spot::amid(at, DVec2::X, height) }, OUTLINE);
        }
    };
    let block = |out: &mut dxf::Writer, number: usize| {
        let figure = &figures[number];
        let [low, high] = figure.bounds();
        piece(out, figure, low);
        let rows = [format!("PIECE NAME: {}", figure.name), "SIZE: NONE".into(), "QUANTITY: 1".into()];
        let start = 0.5 * (high - low) + DVec2::new(0.0, 2.0 * height);
        list(out, &rows, start);
    };
    dxf::complete(&layers, [DVec3::ZERO, DVec3::new(width, top, 0.0)], None, generator, &names, block, |out| {
        let rows = [
            "ASTM/D13PROPOSAL 1 VERSION: D 6673-10".to_owned(),
            format!("STYLE NAME: {title}"),
            format!("AUTHOR: {generator}"),
            "SAMPLE SIZE: NONE".to_owned(),
            "UNITS: METRIC".to_owned(),
        ];
        list(out, &rows, DVec2::new(0.0, -2.0 * height));
        for (name, &at) in names.iter().zip(&places) {
            out.insert(name, at, OUTLINE);
        }
    })
}

/// Returns the name of a piece with the letters that R13 allows.
fn block_name(name: &str) -> String {
    name.to_uppercase().chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' }).take(31).collect()
}

/// Writes the content of a block. Its origin is the lower left corner of the cut, at `low`.
fn piece(out: &mut dxf::Writer, figure: &Figure, low: DVec2) {
    let moved = |points: &[DVec2]| -> Vec<DVec2> { points.iter().map(|&point| point - low).collect() };
    let cut = moved(&figure.cut);
    out.old_polygon(&cut, OUTLINE);
    out.old_polygon(&cut, OUTLINE_VALIDATION);
    let count = cut.len();
    for k in 0..count {
        let (before, at, after) = (cut[(k + count - 1) % count], cut[k], cut[(k + 1) % count]);
        let cosine = (at - before).normalize_or_zero().dot((after - at).normalize_or_zero());
        out.mark(at.extend(0.0), if cosine < TURN { TURN_POINTS } else { CURVE_POINTS });
    }
    if let Some(sew) = &figure.sew {
        let sew = moved(sew);
        out.old_polygon(&sew, SEWING_LINE);
        out.old_polygon(&sew, SEWING_VALIDATION);
    }
    for shape in &figure.shapes {
        match shape {
            Shape::Line { layer: Layer::Notch, ends: [from, to], .. } => {
                let inwards = *to - *from;
                let direction = libm::atan2(inwards.y, inwards.x).to_degrees();
                out.notch(*from - low, [inwards.length(), 2.0 * NOTCH_HALF_WIDTH, direction], NOTCHES);
            }
            Shape::Line { layer, ends, angle_deg } => {
                let name = match layer {
                    Layer::Grain => GRAIN,
                    Layer::FoldMountain | Layer::FoldValley | Layer::FoldFlat => INNER_LINES,
                    // Leaders lead out of the piece.
                    _ => continue,
                };
                out.line(ends.map(|end| (end - low).extend(0.0)), name);
                angle_deg.iter().for_each(|&angle| out.angle(angle));
            }
            Shape::Text { text, spot, .. } if polygon::contains(&figure.cut, spot.at) => {
                out.text(text, &Spot { at: spot.at - low, ..*spot }, ANNOTATION);
            }
            Shape::Text { .. } | Shape::Polygon { .. } => {}
        }
    }
}
