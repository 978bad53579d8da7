//! A small picture of a mesh as PNG, for clients that cannot show a mesh.
//!
//! The mesh is drawn without perspective, from the direction that shows most of it among a few fixed ones. Triangles
//! are shaded by Lambert's law from both sides, and visible lines are drawn on top. The work is linear in the number of
//! triangles and lines, and drawing visits at most `MAX_SAMPLES` samples. The arithmetic is f64 without functions of
//! the platform's mathematics library, so the same archive gives the same bytes on every machine.

use plateau_mesh::{DVec2, DVec3, Mesh};

use crate::archive::{Archive, LineSet, Lines};
use crate::units::UpAxis;

/// Width of the picture in pixels.
pub const WIDTH: usize = 480;
/// Height of the picture in pixels.
pub const HEIGHT: usize = 360;
/// Number of samples of a pixel in each direction. Edges are smoothed by the mean of a pixel's samples.
const SAMPLES: usize = 2;
/// Width of the canvas in samples.
const COLUMNS: usize = WIDTH * SAMPLES;
/// Height of the canvas in samples.
const ROWS: usize = HEIGHT * SAMPLES;
/// Width of the empty frame around the mesh in samples.
const MARGIN: f64 = 24.0;
/// Upper bound of the samples that drawing one picture visits. A film whose sheets lie ten deep visits about 14 million
/// of them. A triangle or line that would exceed the bound is left out.
const MAX_SAMPLES: u64 = 50_000_000;

/// Red, green and blue in sRGB.
type Color = [u8; 3];

const BACKGROUND: Color = [255, 255, 255];
const SURFACE: [f64; 3] = [176.0, 204.0, 232.0];
/// Share of the light that does not depend on the direction of a triangle.
const AMBIENT: f64 = 0.35;

/// Distance by which lines are moved towards the viewer, as a fraction of the mesh's half extent, so that the triangles
/// beside a line do not hide it. Values from 0.01 to 0.03 give nearly the same pictures.
const LINE_BIAS: f64 = 0.02;

/// Cosine and sine of the viewer's elevation of 30°.
const ELEVATION: [f64; 2] = [0.866_025_403_784_438_6, 0.5];
/// Cosine and sine of the viewer's azimuths, which go from -60° in steps of 45°.
const AZIMUTHS: [[f64; 2]; 8] = [
    [0.5, -0.866_025_403_784_438_6],
    [0.965_925_826_289_068_3, -0.258_819_045_102_520_8],
    [0.866_025_403_784_438_6, 0.5],
    [0.258_819_045_102_520_8, 0.965_925_826_289_068_3],
    [-0.5, 0.866_025_403_784_438_6],
    [-0.965_925_826_289_068_3, 0.258_819_045_102_520_8],
    [-0.866_025_403_784_438_6, -0.5],
    [-0.258_819_045_102_520_8, -0.965_925_826_289_068_3],
];
/// Factor by which a direction must show more area than an earlier one of [`AZIMUTHS`] to be preferred.
const CLEARLY_MORE: f64 = 1.25;

/// Draws the mesh and its line sets, and returns the PNG file.
///
/// # Errors
/// Returns the message of the PNG library, which writing to memory never causes.
pub fn to_png(archive: &Archive) -> Result<Vec<u8>, String> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(|error| error.to_string())?;
    writer.write_image_data(&draw(archive).pixels()).map_err(|error| error.to_string())?;
    writer.finish().map_err(|error| error.to_string())?;
    Ok(out)
}

fn draw(archive: &Archive) -> Canvas {
    let contents = archive.contents();
    let mut canvas = Canvas::new();
    let Some(positions) = within_unit_cube(&contents.mesh, contents.up) else { return canvas };
    let view = View::of(&positions, &contents.mesh.triangles);
    let points = view.on_canvas(&positions);
    for &triangle in &contents.mesh.triangles {
        let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
        let Some(normal) = (b - a).cross(c - a).try_normalize() else { continue };
        let brightness = AMBIENT + (1.0 - AMBIENT) * view.lambert(normal);
        let color = SURFACE.map(|channel| (channel * brightness).round() as u8);
        canvas.fill(triangle.map(|vertex| points[vertex as usize]), color);
    }
    for set in &contents.line_sets {
        let pen = Pen::of(set);
        each_segment(set, |ends| canvas.stroke(ends.map(|vertex| points[vertex as usize]), pen));
    }
    canvas
}

/// Returns the vertices with z up, moved and scaled into the cube from -1 to 1. Returns `None` if all vertices lie at
/// one point. No finite coordinates overflow.
fn within_unit_cube(mesh: &Mesh, up: UpAxis) -> Option<Vec<DVec3>> {
    let bounds = |(low, high): (DVec3, DVec3), &vertex: &DVec3| (low.min(vertex), high.max(vertex));
    let (low, high) = mesh.vertices.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), bounds);
    let middle = 0.5 * low + 0.5 * high;
    // Halves are subtracted, because the difference of two coordinates may exceed f64.
    let half = |vertex: DVec3| 0.5 * vertex - 0.5 * middle;
    let extent = half(high).abs().max(half(low).abs()).max_element();
    if extent.is_nan() || extent <= 0.0 {
        return None;
    }
    let turned = |v: DVec3| match up {
        UpAxis::Z => v,
        UpAxis::Y => DVec3::new(v.x, -v.z, v.y),
    };
    Some(mesh.vertices.iter().map(|&vertex| turned(half(vertex) / extent)).collect())
}

/// Directions of the picture in the mesh's coordinates. All three are unit vectors.
#[derive(Clone, Copy)]
struct View {
    right: DVec3,
    up: DVec3,
    /// Direction from the mesh to the viewer.
    towards: DVec3,
}

impl View {
    fn from_azimuth([cosine, sine]: [f64; 2]) -> Self {
        let towards = DVec3::new(ELEVATION[0] * cosine, ELEVATION[0] * sine, ELEVATION[1]);
        let right = DVec3::new(-sine, cosine, 0.0);
        Self { right, up: towards.cross(right), towards }
    }

    /// Returns the direction of [`AZIMUTHS`] in which the mesh shows the largest area. Of directions that show about as
    /// much, the first is taken.
    fn of(positions: &[DVec3], triangles: &[[u32; 3]]) -> Self {
        let views = AZIMUTHS.map(Self::from_azimuth);
        let mut shown = [0.0; AZIMUTHS.len()];
        for triangle in triangles {
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
            let area = (b - a).cross(c - a);
            for (shown, view) in shown.iter_mut().zip(&views) {
                *shown += area.dot(view.towards).abs();
            }
        }
        let mut best = 0;
        for (number, &area) in shown.iter().enumerate() {
            if area > CLEARLY_MORE * shown[best] {
                best = number;
            }
        }
        views[best]
    }

    /// Returns the cosine between the light and the normal of the side that the viewer sees, or 0 if that side is
    /// turned away from the light. The light comes from above and left of the viewer.
    fn lambert(&self, normal: DVec3) -> f64 {
        let light = (self.towards + 0.5 * self.up - 0.5 * self.right).normalize();
        let seen = if normal.dot(self.towards) < 0.0 { -normal } else { normal };
        seen.dot(light).max(0.0)
    }

    /// Returns the positions in samples from the upper left corner of the canvas. The third coordinate grows towards
    /// the viewer, and is in units of the mesh's half extent.
    fn on_canvas(&self, positions: &[DVec3]) -> Vec<DVec3> {
        let projected: Vec<DVec3> =
            positions.iter().map(|p| DVec3::new(p.dot(self.right), -p.dot(self.up), p.dot(self.towards))).collect();
        let bounds = |(low, high): (DVec2, DVec2), p: &DVec3| (low.min(p.truncate()), high.max(p.truncate()));
        let (low, high) = projected.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), bounds);
        let canvas = DVec2::new(COLUMNS as f64, ROWS as f64);
        let scale = ((canvas - 2.0 * MARGIN) / (high - low)).min_element();
        // A mesh that the viewer sees as a single point has no scale.
        let scale = if scale.is_finite() { scale } else { 1.0 };
        let place = |p: DVec3| ((p.truncate() - 0.5 * (low + high)) * scale + 0.5 * canvas).extend(p.z);
        projected.into_iter().map(place).collect()
    }
}

/// Colour and width of a line.
#[derive(Clone, Copy)]
struct Pen {
    color: Color,
    /// Width in samples.
    width: isize,
}

impl Pen {
    fn of(set: &LineSet) -> Self {
        match set.name.as_str() {
            "boundaries" | "directrices" => Self { color: [26, 28, 34], width: 3 },
            "bridges" => Self { color: [112, 120, 130], width: 1 },
            _ => Self { color: [150, 82, 24], width: 2 },
        }
    }
}

/// Calls `visit` with the two vertices of each segment of a line set. Arrows are left out, because a viewer shows them
/// only when asked.
fn each_segment(set: &LineSet, mut visit: impl FnMut([u32; 2])) {
    match &set.lines {
        Lines::Segments(pairs) => pairs.iter().for_each(|&pair| visit(pair)),
        Lines::Arrows(_) => {}
        Lines::Polylines(polylines) => {
            for line in polylines {
                line.vertices.windows(2).for_each(|pair| visit([pair[0], pair[1]]));
                if let (true, [first, .., last]) = (line.closed, &line.vertices[..]) {
                    visit([*last, *first]);
                }
            }
        }
    }
}

/// Samples of the picture with their depths. A larger depth is nearer to the viewer.
struct Canvas {
    colors: Vec<Color>,
    depths: Vec<f64>,
    /// Number of samples that may still be visited.
    budget: u64,
}

impl Canvas {
    fn new() -> Self {
        let samples = COLUMNS * ROWS;
        Self { colors: vec![BACKGROUND; samples], depths: vec![f64::NEG_INFINITY; samples], budget: MAX_SAMPLES }
    }

    /// Takes a number of samples from the budget. Returns false if there are not enough left.
    fn spend(&mut self, samples: u64) -> bool {
        let enough = samples <= self.budget;
        if enough {
            self.budget -= samples;
        }
        enough
    }

    fn set(&mut self, column: usize, row: usize, depth: f64, color: Color) {
        let sample = row * COLUMNS + column;
        if depth >= self.depths[sample] {
            self.depths[sample] = depth;
            self.colors[sample] = color;
        }
    }

    /// Fills the samples whose centres lie in a triangle. A sample on a common edge belongs to both triangles.
    fn fill(&mut self, [a, b, c]: [DVec3; 3], color: Color) {
        /// Tolerance of the barycentric coordinates, so that rounding leaves no gaps between neighbouring triangles.
        const SLACK: f64 = -1e-9;
        let cross = |u: DVec3, v: DVec3| u.x * v.y - u.y * v.x;
        let area = cross(b - a, c - a);
        // A triangle without area on the canvas is seen edge-on and covers no sample.
        if area == 0.0 || !area.is_finite() {
            return;
        }
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let (columns, rows) = (centres(low.x, high.x, COLUMNS), centres(low.y, high.y, ROWS));
        if !self.spend((columns.len() * rows.len()) as u64) {
            return;
        }
        for row in rows {
            for column in columns.clone() {
                let p = DVec3::new(column as f64 + 0.5, row as f64 + 0.5, 0.0);
                let (u, v) = (cross(c - b, p - b) / area, cross(a - c, p - c) / area);
                let w = 1.0 - u - v;
                if u >= SLACK && v >= SLACK && w >= SLACK {
                    self.set(column, row, u * a.z + v * b.z + w * c.z, color);
                }
            }
        }
    }

    /// Draws a line in steps of at most one sample, with a square pen.
    fn stroke(&mut self, [a, b]: [DVec3; 2], pen: Pen) {
        let steps = (b - a).truncate().abs().max_element().ceil().max(1.0) as u64;
        if !self.spend((steps + 1) * (pen.width * pen.width) as u64) {
            return;
        }
        for step in 0..=steps {
            let p = a.lerp(b, step as f64 / steps as f64);
            let [left, top] = [p.x, p.y].map(|x| (x - 0.5 * (pen.width - 1) as f64).floor() as isize);
            for (row, column) in (0..pen.width).flat_map(|y| (0..pen.width).map(move |x| (top + y, left + x))) {
                // The margin is wider than the pen, so lines never leave the canvas. The check costs little.
                if (0..COLUMNS as isize).contains(&column) && (0..ROWS as isize).contains(&row) {
                    self.set(column as usize, row as usize, p.z + LINE_BIAS, pen.color);
                }
            }
        }
    }

    /// Returns the pixels in rows from the top, three bytes each: the mean of each pixel's samples.
    fn pixels(&self) -> Vec<u8> {
        let mut pixels = Vec::with_capacity(3 * WIDTH * HEIGHT);
        for row in 0..HEIGHT {
            for column in 0..WIDTH {
                let mut sums = [0_usize; 3];
                for (y, x) in (0..SAMPLES).flat_map(|y| (0..SAMPLES).map(move |x| (y, x))) {
                    let color = self.colors[(row * SAMPLES + y) * COLUMNS + column * SAMPLES + x];
                    sums.iter_mut().zip(color).for_each(|(sum, channel)| *sum += usize::from(channel));
                }
                pixels.extend(sums.map(|sum| (sum / (SAMPLES * SAMPLES)) as u8));
            }
        }
        pixels
    }
}

/// Returns the numbers of the samples whose centres lie between two coordinates.
fn centres(low: f64, high: f64, count: usize) -> std::ops::Range<usize> {
    // Conversions to usize saturate, so negative numbers become 0.
    let first = (low - 0.5).ceil() as usize;
    let end = ((high - 0.5).floor() + 1.0) as usize;
    first.min(count)..end.clamp(first.min(count), count)
}
