//! Pieces of cloth as DXF by ASTM D6673: AutoCAD R13 with one block a piece, and layers by number.
//!
//! Lengths are in millimetres, which the text `UNITS: METRIC` says, because R13 has no variable for it. The texts have
//! no dates, so that the same pattern gives the same bytes.

use crate::columns::Columns;
use crate::dxf;
use crate::figure::{Figure, Shape, crosses_box};
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
/// All layers of the standard. Besides those above: cut-outs, drill holes, notches of other shapes (T, castle, check
/// and U), and the validation curves of inner lines and cut-outs.
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
        let width = rows.iter().map(|row| label::width(row, height)).fold(0.0, f64::max);
        let size = DVec2::new(width, 5.0 * height);
        // In the middle of the piece if no place is clear of its lines and texts.
        let at = clear_place(figure, size).unwrap_or(0.5 * (low + high) - 0.5 * size);
        list(out, &rows, at - low + DVec2::new(0.0, 4.5 * height));
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

/// Places of a box that are tried along each side of a piece.
const TRIED: usize = 24;

/// Returns the lower left corner of a box inside a piece that is clear of its lines and texts, as near to the middle of
/// the piece as one of the places that are tried.
fn clear_place(figure: &Figure, size: DVec2) -> Option<DVec2> {
    let [low, high] = figure.bounds();
    let room = high - low - size;
    if room.min_element() < 0.0 {
        return None;
    }
    let mut lines: Vec<[DVec2; 2]> = Vec::new();
    for shape in &figure.shapes {
        let mut points = Vec::new();
        shape.extent(&mut points);
        match shape {
            Shape::Line { ends, .. } => lines.push(*ends),
            Shape::Polygon { .. } | Shape::Text { .. } => {
                lines.extend((0..points.len()).map(|k| [points[k], points[(k + 1) % points.len()]]));
            }
        }
    }
    let place = |k: usize| DVec2::new((k % TRIED) as f64 + 0.5, (k / TRIED) as f64 + 0.5) / TRIED as f64;
    let mut places: Vec<DVec2> = (0..TRIED * TRIED).map(place).collect();
    places.sort_by(|one, other| one.distance(DVec2::splat(0.5)).total_cmp(&other.distance(DVec2::splat(0.5))));
    let columns = Columns::new(lines.iter().map(|[from, to]| [from.x.min(to.x), from.x.max(to.x)]));
    places.into_iter().map(|place| low + place * room).find(|&at| {
        let corners = [at, at + DVec2::new(size.x, 0.0), at + size, at + DVec2::new(0.0, size.y)];
        polygon::contains(&figure.cut, at + 0.5 * size)
            && !columns
                .near(at.x, at.x + size.x)
                .any(|number| crosses_box(&corners, lines[number][0], lines[number][1]))
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
