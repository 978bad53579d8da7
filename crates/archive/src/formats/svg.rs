//! The flat pattern as SVG, true to scale: one user unit is one millimetre, on paper and in the software of every
//! cutter.

use std::fmt::Write as _;

use plateau_mesh::DVec2;

use crate::archive::Contents;
use crate::pattern::{FoldKind, Pattern, Piece};

/// Writes each piece as a group: the outline solid, mountain folds dash-dotted, valley folds dashed and flat folds
/// dotted. Line widths are relative to the screen instead of the pattern, so that both a hall and a lampshade are
/// readable.
#[must_use]
pub fn to_svg(pattern: &Pattern, contents: &Contents) -> Vec<u8> {
    let millimetres = contents.unit.millimetres();
    let sheet = pattern.sheet();
    let margin = 0.02 * sheet.size.max_element();
    // SVG's y axis points down.
    let place = |point: DVec2| DVec2::new(point.x + margin, sheet.size.y - point.y + margin) * millimetres;
    let size = (sheet.size + 2.0 * margin) * millimetres;
    let mut out = String::new();
    // Writing to a String cannot fail, so `put` handles no errors.
    macro_rules! put {
        ($($argument:tt)*) => { writeln!(out, $($argument)*).expect("writing to memory") };
    }
    put!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{0:?}mm" height="{1:?}mm" viewBox="0 0 {0:?} {1:?}">"#,
        size.x,
        size.y
    );
    put!("<title>{}</title>", escape(&contents.title));
    put!("<desc>{}; 1 user unit = 1 mm</desc>", escape(&contents.generator));
    put!(
        "<style>\n\
         path, line {{ fill: none; stroke: #000; stroke-width: 1px; vector-effect: non-scaling-stroke; }}\n\
         .mountain {{ stroke: #b00020; stroke-dasharray: 8 2 2 2; }}\n\
         .valley {{ stroke: #0050b0; stroke-dasharray: 6 3; }}\n\
         .flat {{ stroke: #808080; stroke-dasharray: 1 3; }}\n\
         text {{ font-family: sans-serif; text-anchor: middle; }}\n\
         </style>"
    );
    for (index, piece) in sheet.pieces.iter().enumerate() {
        put!(r#"<g id="piece-{}">"#, index + 1);
        put!("<title>{}</title>", escape(&piece.name));
        let corners: Vec<String> =
            piece.outline.iter().map(|&point| place(point)).map(|p| format!("{:?},{:?}", p.x, p.y)).collect();
        put!(r#"<path class="cut" d="M{}Z"/>"#, corners.join("L"));
        for fold in &piece.folds {
            let [start, end] = fold.ends.map(place);
            put!(
                r#"<line class="{}" x1="{:?}" y1="{:?}" x2="{:?}" y2="{:?}"><title>{}</title></line>"#,
                class(fold.kind()),
                start.x,
                start.y,
                end.x,
                end.y,
                format_args!("{:.2}°", fold.angle_deg),
            );
        }
        let at = place(middle(piece));
        put!(
            r#"<text x="{:?}" y="{:?}" font-size="{:?}">{}</text>"#,
            at.x,
            at.y,
            label_height(sheet.size) * millimetres,
            escape(&piece.name),
        );
        put!("</g>");
    }
    put!("</svg>");
    out.into_bytes()
}

fn class(kind: FoldKind) -> &'static str {
    match kind {
        FoldKind::Mountain => "mountain",
        FoldKind::Valley => "valley",
        FoldKind::Flat => "flat",
    }
}

/// Returns the position of the label: the mean of the outline's points.
pub(super) fn middle(piece: &Piece) -> DVec2 {
    let count = piece.outline.len() as f64;
    piece.outline.iter().map(|&point| point / count).sum()
}

pub(super) fn label_height(sheet: DVec2) -> f64 {
    sheet.max_element() / 60.0
}

/// Escapes text for XML. Control characters become spaces, because XML 1.0 forbids them.
fn escape(text: &str) -> String {
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
