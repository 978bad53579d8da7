//! Places of pieces on sheets: bottom-left by their bounding boxes.

use crate::divide::fits;
use crate::figure::{Figure, Shape};
use crate::options::{Rotate, Stock};
use crate::parameters::Refused;
use crate::polygon;
use plateau_mesh::DVec2;

/// Place of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Number of the sheet, from 0.
    pub sheet: usize,
    /// Whether the piece is turned by 90 degrees, counter-clockwise.
    pub turned: bool,
    /// The box of the piece before it is turned, in the coordinates of the piece.
    from: [DVec2; 2],
    /// Lower left corner of the box on the sheet.
    at: DVec2,
}

impl Place {
    /// Returns the place on the sheet of a point of the piece.
    #[must_use]
    pub fn point(&self, point: DVec2) -> DVec2 {
        let own = point - self.from[0];
        let height = (self.from[1] - self.from[0]).y;
        self.at + if self.turned { DVec2::new(height - own.y, own.x) } else { own }
    }

    /// Returns the angle by which the piece is turned, in degrees.
    #[must_use]
    pub fn turned_deg(&self) -> f64 {
        if self.turned { 90.0 } else { 0.0 }
    }

    /// Returns the upper right corner of the box on the sheet.
    fn end(&self) -> DVec2 {
        let size = self.from[1] - self.from[0];
        self.at + turned(size, self.turned)
    }
}

/// Returns the size of a box that may be turned by 90 degrees.
fn turned(size: DVec2, is_turned: bool) -> DVec2 {
    if is_turned { DVec2::new(size.y, size.x) } else { size }
}

/// Pieces on sheets.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    pub stock: Stock,
    /// A place for each piece.
    pub places: Vec<Place>,
    /// For each sheet the upper right corner of the box of what lies on it, whose lower left corner is that of the
    /// sheet.
    pub sheets: Vec<DVec2>,
    /// Area of the pieces over that of the sheets.
    pub utilisation: f64,
}

/// Most sheets of a pattern.
pub const MOST_SHEETS: usize = 1000;
/// Number of the newest sheets on which a piece is tried before a sheet is added. The older ones are full.
const TRIED: usize = 16;

/// The free border of a sheet that is filled from the bottom: its steps from left to right, each with the coordinate at
/// which it starts and its height. The last one ends at the width of the sheet.
struct Skyline {
    steps: Vec<(f64, f64)>,
    room: DVec2,
}

impl Skyline {
    /// Returns the lowest place for a box, and the leftmost of those.
    fn place(&self, size: DVec2) -> Option<DVec2> {
        let mut best: Option<DVec2> = None;
        for (k, &(x, _)) in self.steps.iter().enumerate() {
            if x + size.x > self.room.x {
                break;
            }
            let covered = self.steps[k..].iter().take_while(|(start, _)| *start < x + size.x);
            let y = covered.map(|(_, height)| *height).fold(0.0, f64::max);
            if y + size.y <= self.room.y && best.is_none_or(|best| y < best.y) {
                best = Some(DVec2::new(x, y));
            }
        }
        best
    }

    /// Puts a box at a place.
    fn fill(&mut self, at: DVec2, size: DVec2) {
        let end = at.x + size.x;
        let beyond = self.steps.iter().rev().find(|(start, _)| *start <= end).map_or(0.0, |(_, height)| *height);
        self.steps.retain(|(start, _)| *start < at.x || *start > end);
        let k = self.steps.partition_point(|(start, _)| *start < at.x);
        self.steps.insert(k, (at.x, at.y + size.y));
        if end < self.room.x {
            self.steps.insert(k + 1, (end, beyond));
        }
    }
}

/// Places the figures, the widest first. The box of a figure contains its texts, if the sheet has room for them.
///
/// # Errors
/// Returns [`Refused::Unsuitable`] at `sheet` for a piece that does not fit, and for more than [`MOST_SHEETS`] sheets.
pub fn place(figures: &[Figure], stock: &Stock) -> Result<Layout, Refused> {
    let mut boxes = Vec::with_capacity(figures.len());
    for figure in figures {
        let mut points = figure.cut.clone();
        figure.shapes.iter().for_each(|shape| shape.extent(&mut points));
        let with_texts = crate::piece::bounds(&points);
        let size = |[low, high]: [DVec2; 2]| high - low;
        let own = [with_texts, figure.bounds()].into_iter().find(|own| fits(size(*own), stock)).ok_or_else(|| {
            let [length, width] = size(figure.bounds()).to_array();
            let detail =
                format!("is too small for {}, which is {length:.2} mm long and {width:.2} mm wide", figure.name);
            Refused::unsuitable("sheet", detail)
        })?;
        // A piece lies along the sheet unless it only fits across.
        let lies_along = size(own).cmple(stock.size * (1.0 + 1e-9)).all();
        let is_turned = stock.rotate == Rotate::Free && !lies_along;
        boxes.push((own, is_turned, turned(size(own), is_turned)));
    }
    let mut order: Vec<usize> = (0..figures.len()).collect();
    order.sort_by(|&one, &other| {
        let [one, other] = [one, other].map(|k| boxes[k].2);
        other.y.total_cmp(&one.y).then(other.x.total_cmp(&one.x))
    });
    // A box that takes its gap along fits if the sheet is larger by a gap. The sheet is wider by rounding, as in `fits`.
    let gap = DVec2::splat(stock.gap);
    let room = stock.size * (1.0 + 1e-9) + gap;
    let mut skylines: Vec<Skyline> = Vec::new();
    let mut places: Vec<Option<Place>> = vec![None; figures.len()];
    for k in order {
        let (from, is_turned, size) = boxes[k];
        let first = skylines.len().saturating_sub(TRIED);
        let found = (first..skylines.len()).find_map(|sheet| Some((sheet, skylines[sheet].place(size + gap)?)));
        let (sheet, at) = found.unwrap_or_else(|| {
            skylines.push(Skyline { steps: vec![(0.0, 0.0)], room });
            (skylines.len() - 1, DVec2::ZERO)
        });
        if skylines.len() > MOST_SHEETS {
            return Err(Refused::unsuitable("sheet", format!("makes more than {MOST_SHEETS} sheets")));
        }
        skylines[sheet].fill(at, size + gap);
        places[k] = Some(Place { sheet, turned: is_turned, from, at });
    }
    let places: Vec<Place> = places.into_iter().flatten().collect();
    let mut sheets = vec![DVec2::ZERO; skylines.len()];
    for place in &places {
        sheets[place.sheet] = sheets[place.sheet].max(place.end());
    }
    let area: f64 = figures.iter().map(|figure| polygon::area(&figure.cut)).sum();
    let utilisation = area / (stock.size.x * stock.size.y * sheets.len().max(1) as f64);
    Ok(Layout { stock: *stock, places, sheets, utilisation })
}

/// Returns the shapes of a figure in its place.
pub(crate) fn placed(figure: &Figure, place: &Place) -> Vec<Shape> {
    figure.shapes.iter().map(|shape| shape.placed(|point| place.point(point), place.turned)).collect()
}
