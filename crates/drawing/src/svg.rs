//! Drawings as SVG, true to scale: one user unit is one millimetre, on paper and in the software of every cutter.

use crate::drawing::Drawing;
use crate::figure::Shape;
use crate::options::{Layer, LayerNames};
use std::fmt::Write as _;

/// Height of capitals of a sans-serif font, as a fraction of the font size.
const CAPITALS: f64 = 0.716;

/// Writes each figure as a group. Every layer is a class with its name in lower case. Line widths are relative to the
/// screen instead of the drawing, so that both a hall and a lampshade are readable. The drawing has a margin of 2% of
/// its larger side.
#[must_use]
pub fn to_svg(drawing: &Drawing, layers: &LayerNames) -> Vec<u8> {
    let margin = 0.02 * drawing.size.max_element();
    // SVG's y axis points down.
    let place =
        |point: plateau_mesh::DVec2| plateau_mesh::DVec2::new(point.x + margin, drawing.size.y - point.y + margin);
    let size = drawing.size + 2.0 * margin;
    let mut out = String::new();
    // Writing to a String cannot fail, so `put` handles no errors.
    macro_rules! put {
        ($($argument:tt)*) => { writeln!(out, $($argument)*).expect("writing to memory") };
    }
    put!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{0:?}mm" height="{1:?}mm" viewBox="0 0 {0:?} {1:?}" {2}>"#,
        size.x,
        size.y,
        // For programs that do not read the style sheet.
        r##"fill="none" stroke="#000" stroke-width="0.25""##
    );
    put!("<title>{}</title>", escape(&drawing.title));
    put!("<desc>{}; 1 user unit = 1 mm</desc>", escape(&drawing.generator));
    put!("<style>");
    put!("path, line {{ fill: none; stroke: #000; stroke-width: 1px; vector-effect: non-scaling-stroke; }}");
    for (layer, style) in STYLES {
        put!(".{} {{ {style} }}", class(layer, layers));
    }
    put!("text[class] {{ font-family: sans-serif; stroke: none; }}");
    put!("</style>");
    for (index, group) in drawing.groups.iter().enumerate() {
        put!(r#"<g id="piece-{}">"#, index + 1);
        put!("<title>{}</title>", escape(&group.name));
        for shape in &group.shapes {
            match shape {
                Shape::Polygon { layer, points } => {
                    let corners: Vec<String> =
                        points.iter().map(|&point| place(point)).map(|p| format!("{:?},{:?}", p.x, p.y)).collect();
                    put!(r#"<path class="{}" d="M{}Z"/>"#, class(*layer, layers), corners.join("L"));
                }
                Shape::Line { layer, ends, angle_deg } => {
                    let [start, end] = ends.map(place);
                    let (angle, title) = match angle_deg {
                        Some(angle) => (format!(r#" data-angle-deg="{angle:?}""#), format!("{angle:.2}°")),
                        None => (String::new(), String::new()),
                    };
                    let class = class(*layer, layers);
                    let [x1, y1, x2, y2] = [start.x, start.y, end.x, end.y];
                    let line =
                        format!(r#"<line class="{class}"{angle} x1="{x1:?}" y1="{y1:?}" x2="{x2:?}" y2="{y2:?}""#);
                    if title.is_empty() { put!("{line}/>") } else { put!("{line}><title>{title}</title></line>") }
                }
                Shape::Text { layer, text, spot } => {
                    let (at, anchor) = if spot.starts_left { (spot.start(text), "start") } else { (spot.at, "middle") };
                    let at = place(at);
                    let size = spot.height / CAPITALS;
                    // The baseline is half a capital below the middle, at right angles to the text.
                    let turn = libm::atan2(-spot.direction.y, spot.direction.x).to_degrees();
                    let transform = format!("translate({:?} {:?}) rotate({turn:?})", at.x, at.y);
                    put!(
                        r##"<text class="{}" transform="{transform}" y="{:?}" font-size="{size:?}" {}>{}</text>"##,
                        class(*layer, layers),
                        0.5 * spot.height,
                        format_args!(r##"text-anchor="{anchor}" fill="#000" stroke="none""##),
                        escape(text)
                    );
                }
            }
        }
        put!("</g>");
    }
    put!("</svg>");
    out.into_bytes()
}

/// Styles of the lines on each layer besides the common ones.
const STYLES: [(Layer, &str); 12] = [
    (Layer::Sew, "stroke-dasharray: 10 4;"),
    (Layer::BendUp, "stroke: #0050b0; stroke-dasharray: 6 3;"),
    (Layer::BendDown, "stroke: #b00020; stroke-dasharray: 8 2 2 2;"),
    (Layer::BendZone, "stroke: #c0c0c0;"),
    (Layer::FoldMountain, "stroke: #b00020; stroke-dasharray: 8 2 2 2;"),
    (Layer::FoldValley, "stroke: #0050b0; stroke-dasharray: 6 3;"),
    (Layer::FoldFlat, "stroke: #808080; stroke-dasharray: 1 3;"),
    (Layer::Mark, "stroke: #808080;"),
    (Layer::Grain, "stroke: #008040;"),
    (Layer::Sheet, "stroke: #a0a0a0;"),
    (Layer::Register, "stroke: #a0a0a0;"),
    (Layer::Dimension, "stroke: #808080;"),
];

/// Returns the class of a layer. Without a name of the client it is the layer's name in lower case.
fn class(layer: Layer, layers: &LayerNames) -> String {
    let name = layers.of(layer);
    if name == layer.name() { name.to_lowercase() } else { name.into() }
}

/// Escapes text for XML. Control characters become spaces, because XML 1.0 forbids them.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
