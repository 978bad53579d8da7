//! Point location: finds the triangle of a plane mesh that contains a point.

use crate::DVec2;

/// A grid of buckets that finds the triangle of a plane mesh that contains a point.
#[derive(Debug)]
pub struct Locator {
    low: DVec2,
    cell: f64,
    columns: usize,
    rows: usize,
    start: Vec<u32>,
    triangles: Vec<u32>,
}

impl Locator {
    pub fn new(plane: &[DVec2], triangles: &[[u32; 3]]) -> Self {
        let low = plane.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = plane.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let size = (high - low).max(DVec2::splat(f64::MIN_POSITIVE));
        // This size gives about one triangle per cell. The lower bound keeps a thin strip from making a huge grid.
        let cell = (size.x * size.y / triangles.len().max(1) as f64).sqrt().max(size.max_element() / 4000.0);
        let (columns, rows) = ((size.x / cell) as usize + 1, (size.y / cell) as usize + 1);
        let mut locator = Self { low, cell, columns, rows, start: Vec::new(), triangles: Vec::new() };
        let boxes = |t: &[u32; 3]| {
            let corners = t.map(|v| plane[v as usize]);
            let low = corners[0].min(corners[1]).min(corners[2]);
            let high = corners[0].max(corners[1]).max(corners[2]);
            let ((x0, y0), (x1, y1)) = (locator.cell_of(low), locator.cell_of(high));
            (y0..=y1).flat_map(move |y| (x0..=x1).map(move |x| y * columns + x))
        };
        let mut counts = vec![0u32; columns * rows + 1];
        for cell in triangles.iter().flat_map(&boxes) {
            counts[cell + 1] += 1;
        }
        for k in 0..columns * rows {
            counts[k + 1] += counts[k];
        }
        let mut list = vec![0u32; counts[columns * rows] as usize];
        let mut cursor = counts.clone();
        for (t, corners) in triangles.iter().enumerate() {
            for cell in boxes(corners) {
                list[cursor[cell] as usize] = t as u32;
                cursor[cell] += 1;
            }
        }
        (locator.start, locator.triangles) = (counts, list);
        locator
    }

    fn cell_of(&self, p: DVec2) -> (usize, usize) {
        let q = (p - self.low) / self.cell;
        ((q.x.max(0.0) as usize).min(self.columns - 1), (q.y.max(0.0) as usize).min(self.rows - 1))
    }

    /// The triangle that contains the point, and the barycentric coordinates of the point in it. For a point outside
    /// the mesh, these are the triangle and the coordinates of the nearest point of the mesh.
    pub fn find(&self, p: DVec2, plane: &[DVec2], triangles: &[[u32; 3]]) -> (u32, [f64; 3]) {
        let (x, y) = self.cell_of(p);
        let mut best: Option<(f64, u32, [f64; 3])> = None;
        let most = self.columns.max(self.rows);
        for ring in 0..=most {
            let (x0, x1) = (x.saturating_sub(ring), (x + ring).min(self.columns - 1));
            let (y0, y1) = (y.saturating_sub(ring), (y + ring).min(self.rows - 1));
            for cy in y0..=y1 {
                for cx in x0..=x1 {
                    let on_ring = cx + ring == x || cx == x + ring || cy + ring == y || cy == y + ring;
                    if !on_ring {
                        continue;
                    }
                    let cell = cy * self.columns + cx;
                    for &t in &self.triangles[self.start[cell] as usize..self.start[cell + 1] as usize] {
                        let (distance, weights) = nearest(p, triangles[t as usize].map(|v| plane[v as usize]));
                        if best.is_none_or(|(least, other, _)| distance < least || (distance == least && t < other)) {
                            best = Some((distance, t, weights));
                        }
                    }
                }
            }
            // The cells beyond this ring are at least `ring` cells away.
            if best.is_some_and(|(distance, ..)| distance <= ring as f64 * self.cell) {
                break;
            }
        }
        best.map_or((0, [1.0, 0.0, 0.0]), |(_, t, weights)| (t, weights))
    }
}

/// The distance of a point from a triangle (0 inside), and the barycentric coordinates of the nearest point of the
/// triangle.
fn nearest(p: DVec2, [a, b, c]: [DVec2; 3]) -> (f64, [f64; 3]) {
    let double = (b - a).perp_dot(c - a);
    let (wa, wb) = ((b - p).perp_dot(c - p) / double, (c - p).perp_dot(a - p) / double);
    let weights = [wa, wb, 1.0 - wa - wb];
    if weights.iter().all(|&w| w >= 0.0) {
        return (0.0, weights);
    }
    let corners = [a, b, c];
    let mut best = (f64::INFINITY, [0.0; 3]);
    for k in 0..3 {
        let (from, to) = (corners[k], corners[(k + 1) % 3]);
        let t = ((p - from).dot(to - from) / (to - from).length_squared()).clamp(0.0, 1.0);
        let distance = p.distance(from + (to - from) * t);
        if distance < best.0 {
            let mut weights = [0.0; 3];
            (weights[k], weights[(k + 1) % 3]) = (1.0 - t, t);
            best = (distance, weights);
        }
    }
    best
}
