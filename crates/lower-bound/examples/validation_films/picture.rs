//! Draws meshes as small SVG pictures.

use plateau_mesh::{DVec3, Mesh};
use std::fmt::Write;

/// A mesh to draw, with its title.
pub struct Picture<'a> {
    pub title: String,
    pub mesh: &'a Mesh,
    /// A value per vertex, and the value that is drawn in red; 0 is drawn in blue. Without values the mesh is shaded.
    pub figures: Option<(&'a [f64], f64)>,
    /// Whether triangles are translucent, so that the triangles behind them are visible.
    pub translucent: bool,
}

impl<'a> Picture<'a> {
    pub fn shaded(title: impl Into<String>, mesh: &'a Mesh) -> Self {
        Self { title: title.into(), mesh, figures: None, translucent: false }
    }
}

/// Width and height of a picture without its title.
const SIZE: f64 = 220.0;
/// Colours for values from 0 to the largest: blue to red, as in the exported meshes.
const STOPS: [[f64; 3]; 5] = [[0.1, 0.2, 0.9], [0.0, 0.8, 0.9], [0.1, 0.8, 0.2], [0.95, 0.9, 0.1], [0.9, 0.1, 0.1]];
/// Colours of shaded meshes, from dark to light.
const SHADES: [[f64; 3]; 2] = [[0.30, 0.56, 0.73], [0.95, 0.97, 0.99]];
/// Number of colours of each of the two scales. Each colour is a CSS class whose name is one letter, which keeps the
/// file small.
const STEPS: usize = 24;

fn classes() -> String {
    let mut style = String::from("<style>");
    for (first, stops) in [('a', &SHADES[..]), ('A', &STOPS[..])] {
        for step in 0..STEPS {
            let at = step as f64 / (STEPS - 1) as f64 * (stops.len() - 1) as f64;
            let low = (at as usize).min(stops.len() - 2);
            let channel = |k: usize| stops[low][k] + (at - low as f64) * (stops[low + 1][k] - stops[low][k]);
            let [r, g, b] = [0, 1, 2].map(|k| (255.0 * channel(k)).round() as u8);
            let _ = write!(style, ".{}{{fill:#{r:02x}{g:02x}{b:02x}}}", class(first, step));
        }
    }
    style + "</style>"
}

fn class(first: char, step: usize) -> char {
    char::from(first as u8 + step as u8)
}

fn step_of(part: f64) -> usize {
    (part.clamp(0.0, 1.0) * (STEPS - 1) as f64).round() as usize
}

/// Draws pictures side by side. Each is seen from the same oblique direction and fills its square. Far triangles are
/// drawn first.
pub fn row(pictures: &[Picture]) -> String {
    let (right, back, up) = (
        DVec3::new(0.89, -0.45, 0.0).normalize(),
        DVec3::new(0.42, 0.83, -0.36).normalize(),
        DVec3::new(0.16, 0.32, 0.93).normalize(),
    );
    let mut svg = String::new();
    let (width, height) = (SIZE * pictures.len() as f64, SIZE + 20.0);
    let _ = writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         font-family=\"sans-serif\" font-size=\"12\">{}<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>",
        classes()
    );
    for (k, picture) in pictures.iter().enumerate() {
        let mesh = picture.mesh;
        let seen: Vec<(f64, f64, f64)> =
            mesh.vertices.iter().map(|v| (v.dot(right), -v.dot(up), v.dot(back))).collect();
        let bounds = |of: fn(&(f64, f64, f64)) -> f64| {
            seen.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
        };
        let ((x0, x1), (y0, y1)) = (bounds(|p| p.0), bounds(|p| p.1));
        let scale = (SIZE - 20.0) / (x1 - x0).max(y1 - y0);
        let place = |v: u32| {
            let p = seen[v as usize];
            let x = SIZE * k as f64 + 0.5 * SIZE + (p.0 - 0.5 * (x0 + x1)) * scale;
            [x, 20.0 + 0.5 * SIZE + (p.1 - 0.5 * (y0 + y1)) * scale]
        };
        let mut order: Vec<&[u32; 3]> = mesh.triangles.iter().collect();
        let depth = |t: &[u32; 3]| t.iter().map(|&v| seen[v as usize].2).sum::<f64>();
        order.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
        let opacity = if picture.translucent { 0.6 } else { 1.0 };
        let _ = writeln!(svg, r##"<g stroke="#1b3a4b" stroke-width=".3" fill-opacity="{opacity}">"##);
        for triangle in order {
            let class = match picture.figures {
                Some((figures, red)) => {
                    let mean = triangle.iter().map(|&v| figures[v as usize]).sum::<f64>() / 3.0;
                    class('A', step_of(mean / red.max(f64::MIN_POSITIVE)))
                }
                None => class('a', step_of(light(mesh.corners(*triangle)))),
            };
            // Coordinates are rounded to tenths, and each corner is relative to the corner before it.
            let [a, b, c] = triangle.map(|v| place(v).map(|x| (10.0 * x).round()));
            let by =
                |from: [f64; 2], to: [f64; 2]| format!("{} {}", (to[0] - from[0]) / 10.0, (to[1] - from[1]) / 10.0);
            let _ = writeln!(
                svg,
                r#"<path d="M{} {}l{} {}z" class="{class}"/>"#,
                a[0] / 10.0,
                a[1] / 10.0,
                by(a, b),
                by(b, c)
            );
        }
        let _ = writeln!(svg, r##"</g><text x="{:.0}" y="15">{}</text>"##, SIZE * k as f64 + 8.0, picture.title);
    }
    svg.push_str("</svg>\n");
    svg
}

/// The brightness of a triangle, 0 to 1.
fn light([a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a).normalize_or_zero();
    normal.dot(DVec3::new(0.4, -0.7, 0.6).normalize()).abs()
}
