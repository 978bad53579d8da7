//! Drawings as PDF, true to scale, on one page or tiled on A4 or A3.
//!
//! The library writes the structure of the file. The operators of the pages are written here, because the library's
//! have 32-bit numbers. There are neither dates nor identifiers, so that the same drawing gives the same bytes.

use crate::drawing::Drawing;
use crate::figure::Shape;
use crate::label::Spot;
use crate::options::{Layer, Paper};
use crate::parameters::Refused;
use crate::polygon;
use pdf_writer::{Finish, Name, Pdf, Rect, Ref};
use plateau_mesh::DVec2;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::ops::RangeInclusive;

/// Points in a millimetre.
const POINTS: f64 = 72.0 / 25.4;
/// Margin of a page in millimetres, which printers need.
const MARGIN: f64 = 10.0;
/// Largest side of a page in points, by the standard.
const LARGEST_PAGE: f64 = 14_400.0;
/// Most pages of a file.
pub const MOST_PAGES: usize = 500;
/// Height of capitals of Helvetica, as a fraction of the font size.
const CAPITALS: f64 = 0.716;
/// Length of the arms of a register mark in millimetres.
const REGISTER: f64 = 5.0;

/// Writes a drawing on one page of its size, or on tiles of paper whose frames join at register marks.
///
/// # Errors
/// Returns [`Refused::Unsuitable`] at `paper` if one page is too small for the drawing, or if there would be too many.
pub fn to_pdf(drawing: &Drawing, paper: Option<Paper>) -> Result<Vec<u8>, Refused> {
    let pages = match paper {
        None => {
            let size = drawing.size + 2.0 * MARGIN;
            if (size * POINTS).max_element() > LARGEST_PAGE {
                let detail = "the drawing is larger than a page can be, 5080 mm; give paper=a4 or paper=a3";
                return Err(Refused::unsuitable("paper", detail));
            }
            vec![(size, page(&boxed(drawing), DVec2::ZERO, drawing.size, None))]
        }
        Some(paper) => tiles(drawing, paper.size())?,
    };
    let mut pdf = Pdf::new();
    let [catalog, tree, font] = [1, 2, 3].map(Ref::new);
    let page_of = |k: usize| Ref::new(4 + 2 * k as i32);
    let content_of = |k: usize| Ref::new(5 + 2 * k as i32);
    pdf.catalog(catalog).pages(tree);
    pdf.pages(tree).kids((0..pages.len()).map(page_of)).count(pages.len() as i32);
    pdf.type1_font(font).base_font(Name(b"Helvetica")).encoding_predefined(Name(b"WinAnsiEncoding"));
    for (k, (size, content)) in pages.iter().enumerate() {
        let points = *size * POINTS;
        let mut page = pdf.page(page_of(k));
        page.media_box(Rect::new(0.0, 0.0, points.x as f32, points.y as f32)).parent(tree).contents(content_of(k));
        page.resources().fonts().pair(Name(b"F"), font);
        page.finish();
        pdf.stream(content_of(k), content.as_bytes());
    }
    Ok(pdf.finish())
}

/// Returns the pages of a drawing that is divided into tiles, row by row from the top left. A tile on which nothing is
/// drawn and which lies outside every piece has no page.
fn tiles(drawing: &Drawing, paper: DVec2) -> Result<Vec<(DVec2, String)>, Refused> {
    let tile = paper - 2.0 * MARGIN;
    let count = (drawing.size / tile).ceil().max(DVec2::ONE);
    let (columns, rows) = (count.x as usize, count.y as usize);
    let shapes = boxed(drawing);
    let mut used = Tiles { size: tile, columns, rows, used: BTreeSet::new() };
    for (shape, [low, high]) in &shapes {
        match shape {
            Shape::Polygon { layer, points } => {
                let edges = (0..points.len()).map(|k| [points[k], points[(k + 1) % points.len()]]);
                edges.for_each(|edge| used.cross(edge));
                // The template of a piece is whole. The inside of an empty sheet is not needed.
                if *layer == Layer::Cut && used.used.len() <= MOST_PAGES {
                    used.fill(points);
                }
            }
            Shape::Line { ends, .. } => used.cross(*ends),
            Shape::Text { .. } => used.cover(used.columns(low.x, high.x), used.rows(low.y, high.y)),
        }
        if used.used.len() > MOST_PAGES {
            let detail = format!(
                "makes more than {MOST_PAGES} pages, of {columns} columns and {rows} rows; a DXF or an SVG shows the \
                 drawing in one piece"
            );
            return Err(Refused::unsuitable("paper", detail));
        }
    }
    let page = |&(row, column): &(usize, usize)| {
        // The first row is the top of the drawing.
        let low = DVec2::new(column as f64, (rows - 1 - row) as f64) * tile;
        let name = format!("row {} of {rows}, column {} of {columns}", row + 1, column + 1);
        (paper, page(&shapes, low, tile, Some(&name)))
    };
    Ok(used.used.iter().map(page).collect())
}

/// The tiles of a drawing, by their row from the top and their column.
struct Tiles {
    size: DVec2,
    columns: usize,
    rows: usize,
    used: BTreeSet<(usize, usize)>,
}

impl Tiles {
    /// Returns the columns between two coordinates.
    fn columns(&self, from: f64, to: f64) -> RangeInclusive<usize> {
        let [from, to] = [from, to].map(|x| ((x / self.size.x).max(0.0) as usize).min(self.columns - 1));
        from..=to
    }

    /// Returns the rows between two coordinates, from the low end.
    fn rows(&self, from: f64, to: f64) -> RangeInclusive<usize> {
        let [from, to] = [from, to].map(|y| ((y / self.size.y).max(0.0) as usize).min(self.rows - 1));
        from..=to
    }

    /// Uses these tiles. Stops at the first one beyond the most.
    fn cover(&mut self, columns: RangeInclusive<usize>, rows: RangeInclusive<usize>) {
        for column in columns {
            for row in rows.clone() {
                if self.used.len() > MOST_PAGES {
                    return;
                }
                self.used.insert((self.rows - 1 - row, column));
            }
        }
    }

    /// Uses the tiles that a segment crosses.
    fn cross(&mut self, [a, b]: [DVec2; 2]) {
        let (low, high) = (a.x.min(b.x), a.x.max(b.x));
        for column in self.columns(low, high) {
            // The part of the segment in this column.
            let [from, to] = [column, column + 1].map(|side| (side as f64 * self.size.x).clamp(low, high));
            let y = |x: f64| a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
            let [from, to] = if a.x == b.x { [a.y, b.y] } else { [y(from), y(to)] };
            self.cover(column..=column, self.rows(from.min(to), from.max(to)));
        }
    }

    /// Uses the tiles inside a polygon. The tiles that the polygon's edges cross are used already, so that the middle
    /// of each other tile decides.
    fn fill(&mut self, points: &[DVec2]) {
        let [low, high] = crate::piece::bounds(points);
        for row in self.rows(low.y, high.y) {
            let y = (row as f64 + 0.5) * self.size.y;
            for chord in polygon::chords(points, y) {
                self.cover(self.columns(chord[0], chord[1]), row..=row);
            }
        }
    }
}

/// Returns every shape of a drawing with its box.
fn boxed(drawing: &Drawing) -> Vec<(&Shape, [DVec2; 2])> {
    let shapes = drawing.groups.iter().flat_map(|group| &group.shapes);
    let boxed = shapes.map(|shape| {
        let mut points = Vec::new();
        shape.extent(&mut points);
        (shape, crate::piece::bounds(&points))
    });
    boxed.collect()
}

/// Returns the operators of a page that shows the drawing from `low` on. A tile is clipped, and has register marks in
/// the corners of its frame.
fn page(shapes: &[(&Shape, [DVec2; 2])], low: DVec2, size: DVec2, tile: Option<&str>) -> String {
    let mut out = String::new();
    // Writing to a String cannot fail. Display of f64 has no exponent, which PDF does not know.
    macro_rules! put {
        ($($argument:tt)*) => { writeln!(out, $($argument)*).expect("writing to memory") };
    }
    put!("q {POINTS} 0 0 {POINTS} 0 0 cm 0.25 w");
    if tile.is_some() {
        put!("q {MARGIN} {MARGIN} {} {} re W n", size.x, size.y);
    }
    let place = |point: DVec2| point - low + MARGIN;
    for &(shape, [from, to]) in shapes {
        if tile.is_some() && (to.x < low.x || to.y < low.y || from.x > (low + size).x || from.y > (low + size).y) {
            continue;
        }
        match shape {
            Shape::Polygon { layer, points } => {
                put!("{}", style(*layer));
                for (k, &point) in points.iter().enumerate() {
                    let at = place(point);
                    put!("{} {} {}", at.x, at.y, if k == 0 { "m" } else { "l" });
                }
                put!("s");
            }
            Shape::Line { layer, ends, .. } => {
                let [start, end] = ends.map(place);
                put!("{} {} {} m {} {} l S", style(*layer), start.x, start.y, end.x, end.y);
            }
            Shape::Text { text, spot, .. } => put!("{}", text_operators(text, &Spot { at: place(spot.at), ..*spot })),
        }
    }
    if let Some(name) = tile {
        put!("Q {}", style(Layer::Register));
        for corner in [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)] {
            let at = corner + MARGIN;
            put!("{} {} m {} {} l S", at.x - REGISTER, at.y, at.x + REGISTER, at.y);
            put!("{} {} m {} {} l S", at.x, at.y - REGISTER, at.x, at.y + REGISTER);
        }
        let spot = Spot::amid(DVec2::new(MARGIN + 0.5 * size.x, 0.5 * MARGIN), DVec2::X, 2.5);
        put!("{}", text_operators(name, &spot));
    }
    put!("Q");
    out
}

/// Returns the operators that set the colour and the dashes of a layer.
fn style(layer: Layer) -> &'static str {
    match layer {
        Layer::Sew => "0 G [5 2] 0 d",
        Layer::BendUp | Layer::FoldValley => "0 0.31 0.69 RG [3 1.5] 0 d",
        Layer::BendDown | Layer::FoldMountain => "0.69 0 0.13 RG [4 1 1 1] 0 d",
        Layer::FoldFlat => "0.5 G [0.5 1.5] 0 d",
        Layer::BendZone | Layer::Mark | Layer::Sheet | Layer::Register | Layer::Dimension => "0.6 G [] 0 d",
        Layer::Cut | Layer::Notch | Layer::Grain | Layer::Text | Layer::ScaleBar => "0 G [] 0 d",
    }
}

fn text_operators(text: &str, spot: &Spot) -> String {
    let size = spot.height / CAPITALS;
    let letters: Vec<u8> = text.chars().map(|c| if c.is_ascii() && !c.is_control() { c as u8 } else { b'?' }).collect();
    let width = letters.iter().map(|&c| f64::from(WIDTHS[usize::from(c - b' ')])).sum::<f64>() * size / 1000.0;
    let (x, y) = (spot.direction, spot.direction.perp());
    let left = if spot.starts_left { spot.start(text) } else { spot.at - x * (0.5 * width) };
    let start = left - y * (0.5 * spot.height);
    let mut escaped = String::new();
    for &c in &letters {
        if matches!(c, b'(' | b')' | b'\\') {
            escaped.push('\\');
        }
        escaped.push(char::from(c));
    }
    format!("BT /F {size} Tf {} {} {} {} {} {} Tm ({escaped}) Tj ET", x.x, x.y, y.x, y.y, start.x, start.y)
}

/// Widths of the letters of Helvetica from space to tilde, in thousandths of the font size (Adobe's metrics).
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556, 556, 556,
    556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833,
    722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556,
    556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334,
    260, 334, 584,
];
