//! A drawing: figures in their places, with overall sizes, a scale bar and a legend.

use crate::figure::{Figure, Shape};
use crate::label::{self, Spot};
use crate::metal;
use crate::options::{Layer, PatternOptions, Profile};
use crate::piece::bounds;
use plateau_mesh::DVec2;

/// Shapes of one figure in their places.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    pub name: String,
    pub shapes: Vec<Shape>,
}

/// A drawing. The origin is the lower left corner, and y points up. Lengths are in millimetres.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    pub title: String,
    pub generator: String,
    pub size: DVec2,
    pub groups: Vec<Group>,
}

/// Length of the scale bar in millimetres.
pub const SCALE_BAR: f64 = 100.0;

/// Places figures below each other, with the first at the top. The gap between neighbours is a twentieth of the largest
/// extent.
#[must_use]
pub fn stacked(figures: &[Figure], options: &PatternOptions, title: &str, generator: &str) -> Drawing {
    let bare = options.profile == Profile::Cut;
    let sized: Vec<Vec<Shape>> = figures
        .iter()
        .map(|figure| {
            let mut shapes = figure.shapes.clone();
            if !bare {
                shapes.extend(sizes(figure, options.text_height));
            }
            shapes
        })
        .collect();
    let boxes: Vec<[DVec2; 2]> = sized.iter().map(|shapes| extent(shapes)).collect();
    let largest = boxes.iter().map(|[low, high]| (*high - *low).max_element()).fold(0.0, f64::max);
    let gap = largest / 20.0;
    let mut size = DVec2::ZERO;
    let mut groups = Vec::with_capacity(figures.len() + 1);
    let mut add = |name: &str, shapes: &[Shape], [low, high]: [DVec2; 2], first: bool| {
        let bottom = if first { 0.0 } else { size.y + gap };
        let place = |point: DVec2| point - low + DVec2::new(0.0, bottom);
        size = DVec2::new(size.x.max(high.x - low.x), bottom + high.y - low.y);
        groups.push(Group { name: name.into(), shapes: shapes.iter().map(|shape| shape.moved(place)).collect() });
    };
    if !bare {
        let notes = notes(figures, options);
        add("notes", &notes, extent(&notes), true);
    }
    for (k, (figure, shapes)) in figures.iter().zip(&sized).enumerate().rev() {
        add(&figure.name, shapes, boxes[k], bare && k + 1 == figures.len());
    }
    groups.reverse();
    Drawing { title: title.into(), generator: generator.into(), size, groups }
}

fn extent(shapes: &[Shape]) -> [DVec2; 2] {
    let mut points = Vec::new();
    shapes.iter().for_each(|shape| shape.extent(&mut points));
    bounds(&points)
}

/// Returns a length as it is printed: rounded to a hundredth of a millimetre.
fn printed_length(length: f64) -> String {
    format!("{length:.2} mm")
}

/// Returns the dimension lines of a figure's overall width and height: below it and on its left.
fn sizes(figure: &Figure, height: f64) -> Vec<Shape> {
    let [_, cut_high] = figure.bounds();
    let [cut_low, _] = figure.bounds();
    let [low, _] = extent(&figure.shapes);
    let line = |from: DVec2, to: DVec2| Shape::Line { layer: Layer::Dimension, ends: [from, to], angle_deg: None };
    let tick = 0.5 * height;
    let (below, left) = (low.y - 2.0 * height, low.x - 2.0 * height);
    let mut shapes = vec![
        line(DVec2::new(cut_low.x, below), DVec2::new(cut_high.x, below)),
        line(DVec2::new(left, cut_low.y), DVec2::new(left, cut_high.y)),
    ];
    for x in [cut_low.x, cut_high.x] {
        shapes.push(line(DVec2::new(x, below - tick), DVec2::new(x, below + tick)));
    }
    for y in [cut_low.y, cut_high.y] {
        shapes.push(line(DVec2::new(left - tick, y), DVec2::new(left + tick, y)));
    }
    let size = cut_high - cut_low;
    let middle = cut_low.midpoint(cut_high);
    let texts = [
        (printed_length(size.x), DVec2::new(middle.x, below - 1.2 * height), DVec2::X),
        (printed_length(size.y), DVec2::new(left - 1.2 * height, middle.y), DVec2::Y),
    ];
    for (text, at, direction) in texts {
        shapes.push(Shape::Text { layer: Layer::Dimension, text, spot: Spot::amid(at, direction, height) });
    }
    shapes
}

/// Returns the scale bar and the legend.
fn notes(figures: &[Figure], options: &PatternOptions) -> Vec<Shape> {
    let height = options.text_height;
    let line = |from: [f64; 2], to: [f64; 2]| Shape::Line {
        layer: Layer::ScaleBar,
        ends: [DVec2::from_array(from), DVec2::from_array(to)],
        angle_deg: None,
    };
    let text = |layer: Layer, text: &str, left: f64, y: f64| {
        let at = DVec2::new(left + 0.5 * label::width(text, height), y);
        Shape::Text { layer, text: text.into(), spot: Spot { starts_left: true, ..Spot::amid(at, DVec2::X, height) } }
    };
    let tick = 0.5 * height;
    let mut shapes = vec![
        line([0.0, 0.0], [SCALE_BAR, 0.0]),
        line([0.0, -tick], [0.0, tick]),
        line([SCALE_BAR, -tick], [SCALE_BAR, tick]),
        text(Layer::ScaleBar, "100 mm", SCALE_BAR + height, 0.0),
    ];
    let mut row = -2.0 * height;
    for entry in legend(figures) {
        shapes.push(text(Layer::Text, entry, 0.0, row));
        row -= 2.0 * height;
    }
    for entry in bend_table(figures, options) {
        shapes.push(text(Layer::Text, &entry, 0.0, row));
        row -= 2.0 * height;
    }
    shapes
}

/// Most rows of a bend table on a drawing. The schedule of bends has all of them.
const MOST_ROWS: usize = 60;

/// Returns the lines of the bend table of sheet metal.
fn bend_table(figures: &[Figure], options: &PatternOptions) -> Vec<String> {
    let Some(metal) = &options.metal else { return Vec::new() };
    let mut rows = Vec::new();
    let mut bends = 0;
    for figure in figures {
        for hits in figure.lines.chunk_by(|one, next| one.bridge == next.bridge) {
            let angle: f64 = hits.iter().map(|hit| hit.angle_deg).sum();
            let direction = if angle < 0.0 { "up" } else { "down" };
            let allowance = metal::bend_allowance(metal, angle.abs().to_radians());
            if rows.len() < MOST_ROWS {
                rows.push(format!(
                    "bend {bends}: {}, bridge {}, {direction} {:.2} deg in {} hits, inner radius {} mm, allowance \
                     {allowance:.4} mm",
                    figure.name,
                    hits[0].bridge,
                    angle.abs(),
                    hits.len(),
                    metal.radius,
                ));
            }
            bends += 1;
        }
    }
    if bends > rows.len() {
        rows.push(format!("{} more bends: see the schedule of bends", bends - rows.len()));
    }
    rows
}

/// Returns the lines of the legend for the layers that the figures use.
fn legend(figures: &[Figure]) -> Vec<&'static str> {
    let has = |layer: Layer| {
        figures.iter().flat_map(|figure| &figure.shapes).any(|shape| match shape {
            Shape::Polygon { layer: own, .. } | Shape::Line { layer: own, .. } | Shape::Text { layer: own, .. } => {
                *own == layer
            }
        })
    };
    let entries = [
        (Layer::Cut, "solid: cut"),
        (Layer::Sew, "long dashes: seam"),
        (Layer::FoldMountain, "dash-dotted: mountain fold, a ridge on this side, angle above 0"),
        (Layer::FoldValley, "dashed: valley fold, a groove on this side, angle below 0"),
        (Layer::FoldFlat, "dotted: stays flat"),
        (Layer::BendUp, "dashed: bend up, towards the reader"),
        (Layer::BendDown, "dash-dotted: bend down, away from the reader"),
        (Layer::Notch, "short line at the edge: notch, opposite the one of the mate"),
    ];
    entries.into_iter().filter(|(layer, _)| has(*layer)).map(|(_, text)| text).collect()
}
