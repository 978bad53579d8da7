//! A drawing: figures in their places, with overall sizes, a scale bar and a legend.

use crate::figure::{Figure, FoldLine, Shape};
use crate::label::{self, Spot};
use crate::metal;
use crate::options::{Layer, PatternOptions, Profile};
use crate::piece::bounds;
use crate::sheets::{self, Layout};
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

/// Groups that stay together, and their box.
struct Block {
    groups: Vec<Group>,
    bounds: [DVec2; 2],
}

impl Block {
    /// Returns a block of one group.
    fn single(name: &str, shapes: Vec<Shape>) -> Self {
        let bounds = extent(&shapes);
        Self { groups: vec![Group { name: name.into(), shapes }], bounds }
    }
}

/// Places figures below each other, with the first at the top and their overall sizes beside them.
#[must_use]
pub fn stacked(figures: &[Figure], options: &PatternOptions, title: &str, generator: &str) -> Drawing {
    let is_bare = options.profile == Profile::Cut;
    let mut blocks: Vec<Block> = figures
        .iter()
        .map(|figure| {
            let mut shapes = figure.shapes.clone();
            if !is_bare {
                shapes.extend(sizes(figure.bounds(), extent(&figure.shapes)[0], options.text_height));
            }
            Block::single(&figure.name, shapes)
        })
        .collect();
    if !is_bare {
        blocks.push(Block::single("notes", notes(figures, None, options)));
    }
    below_each_other(blocks, title, generator)
}

/// Draws some of the sheets of a layout below each other, with the first at the top, and the pieces in their places.
#[must_use]
pub fn on_sheets(
    figures: &[Figure],
    layout: &Layout,
    sheets: std::ops::Range<usize>,
    options: &PatternOptions,
    [title, generator]: [&str; 2],
) -> Drawing {
    let is_bare = options.profile == Profile::Cut;
    let frame = [DVec2::ZERO, layout.stock.size];
    let mut blocks: Vec<Block> = sheets.clone().map(|sheet| sheet_block(sheet, frame, options)).collect();
    for (figure, place) in figures.iter().zip(&layout.places).filter(|(_, place)| sheets.contains(&place.sheet)) {
        let shapes = sheets::placed(figure, place);
        blocks[place.sheet - sheets.start].groups.push(Group { name: figure.name.clone(), shapes });
    }
    if !is_bare {
        blocks.push(Block::single("notes", notes(figures, Some(layout), options)));
    }
    below_each_other(blocks, title, generator)
}

/// Returns a sheet without pieces. Cut lines stand alone, so that there the sheet is the drawing's extent only.
fn sheet_block(sheet: usize, frame: [DVec2; 2], options: &PatternOptions) -> Block {
    if options.profile == Profile::Cut {
        return Block { groups: Vec::new(), bounds: frame };
    }
    let (size, height) = (frame[1], options.text_height);
    let corners = vec![DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
    let name = format!("sheet {}", sheet + 1);
    let at = DVec2::new(0.5 * label::width(&name, height), size.y + height);
    let mut shapes = vec![
        Shape::Polygon { layer: Layer::Sheet, points: corners },
        Shape::Text {
            layer: Layer::Text,
            text: name.clone(),
            spot: Spot { starts_left: true, ..Spot::amid(at, DVec2::X, height) },
        },
    ];
    shapes.extend(sizes(frame, frame[0], height));
    Block::single(&name, shapes)
}

/// Places blocks below each other, with the first at the top. The gap between neighbours is a twentieth of the largest
/// extent.
fn below_each_other(blocks: Vec<Block>, title: &str, generator: &str) -> Drawing {
    let largest = blocks.iter().map(|block| (block.bounds[1] - block.bounds[0]).max_element()).fold(0.0, f64::max);
    let gap = largest / 20.0;
    let mut size = DVec2::ZERO;
    let mut placed: Vec<Vec<Group>> = Vec::with_capacity(blocks.len());
    for Block { groups, bounds: [low, high] } in blocks.into_iter().rev() {
        let bottom = if placed.is_empty() { 0.0 } else { size.y + gap };
        let place = |point: DVec2| point - low + DVec2::new(0.0, bottom);
        size = DVec2::new(size.x.max(high.x - low.x), bottom + high.y - low.y);
        let moved = |group: Group| Group {
            name: group.name,
            shapes: group.shapes.iter().map(|shape| shape.moved(place)).collect(),
        };
        placed.push(groups.into_iter().map(moved).collect());
    }
    let groups = placed.into_iter().rev().flatten().collect();
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

/// Returns the dimension lines of the overall width and height of a box, below and on the left of all that has `low` as
/// its lower left corner.
fn sizes([cut_low, cut_high]: [DVec2; 2], low: DVec2, height: f64) -> Vec<Shape> {
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
fn notes(figures: &[Figure], layout: Option<&Layout>, options: &PatternOptions) -> Vec<Shape> {
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
    let mut rows: Vec<String> = legend(figures).into_iter().map(str::to_owned).collect();
    rows.extend(whole_folds(figures));
    rows.extend(layout.map(|layout| {
        let [length, width] = layout.stock.size.to_array();
        format!("sheets: {} of {length} x {width} mm, {:.1} % used", layout.sheets.len(), 100.0 * layout.utilisation)
    }));
    rows.extend(bend_table(figures, options));
    for entry in rows {
        shapes.push(text(Layer::Text, &entry, 0.0, row));
        row -= 2.0 * height;
    }
    shapes
}

/// Fold in degrees from which on two panels lie upon each other.
const WHOLE_FOLD: f64 = 179.99;
/// Most folds of 180 degrees that a drawing names.
const MOST_WHOLE_FOLDS: usize = 5;

/// Returns the warnings of folds of 180 degrees.
fn whole_folds(figures: &[Figure]) -> Vec<String> {
    let folds = figures.iter().flat_map(|figure| figure.lines.iter().map(move |line| (figure, line)));
    let whole: Vec<_> = folds.filter(|(_, line)| line.angle_deg.abs() >= WHOLE_FOLD).collect();
    let warning = |&(figure, line): &(&Figure, &FoldLine)| {
        format!(
            "warning: {}, bridge {}: a fold of 180 deg lays one panel upon the other; it may be folded to either side",
            figure.name, line.bridge
        )
    };
    let mut rows: Vec<String> = whole.iter().take(MOST_WHOLE_FOLDS).map(warning).collect();
    if whole.len() > rows.len() {
        rows.push(format!("{} more folds of 180 deg", whole.len() - rows.len()));
    }
    rows
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
        (Layer::BendZone, "grey beside a bend: where its zone begins and ends"),
        (Layer::Grain, "green line: the grain runs along it"),
        (Layer::Notch, "short line at the edge: notch, opposite the one of the mate"),
    ];
    entries.into_iter().filter(|(layer, _)| has(*layer)).map(|(_, text)| text).collect()
}
