//! Flattening (Katoh, Ohsaki and Xu, section 4, step 2, eq. 1): an auxiliary triangulation of the surface is laid into the
//! plane with the least ½ Σ ((Lᵖ - Lˢ)/Lˢ)² over its edges, Lˢ on the surface and Lᵖ in the plane.
//!
//! 1. Start from a plane mesh without flipped triangles: the parameters of a patch stretched to its size; for a film the
//!    projection to its mean plane, or, where that folds over, Tutte's embedding with the longest boundary on a circle and
//!    the other boundaries filled by one vertex each.
//! 2. Levenberg and Marquardt on the edge terms.
//! 3. Refuse what folds over: the planar algorithm needs a plane region.
//!
//! The paper names no method. Our departure: steps that would flip a triangle are refused, as the energy alone does not see
//! a fold.

use super::least_squares::{Normal, Outcome, Problem, Settings, minimise, step_before_flip};
use crate::error::Error;
use crate::execution::Execution;
use crate::mesh::topology::{NONE, Topology};
use crate::sparse::{Symbolic, SymmetricMatrix};
use crate::{DVec2, DVec3, Mesh, mesh::measure};
use std::f64::consts::TAU;

/// The edges of the auxiliary triangulation, each once.
pub(super) fn edges(topology: &Topology) -> Vec<[u32; 2]> {
    (0..topology.twin.len() as u32)
        .filter(|&h| topology.twin[h as usize] == NONE || topology.twin[h as usize] > h)
        .map(|h| [topology.from(h), topology.to(h)])
        .collect()
}

struct Flattening<'a> {
    edges: &'a [[u32; 2]],
    lengths: &'a [f64],
    triangles: &'a [[u32; 3]],
    /// The metric's scale: squares of mean relative edge terms.
    metric: f64,
}

impl Problem for Flattening<'_> {
    fn couplings(&self) -> &[[u32; 2]] {
        self.edges
    }

    fn energy(&mut self, x: &[DVec2]) -> f64 {
        if !self.triangles.iter().all(|&t| doubled_area(x, t) > 0.0) {
            return f64::INFINITY;
        }
        let term = |(&[a, b], &length): (&[u32; 2], &f64)| {
            let r = x[a as usize].distance(x[b as usize]) / length - 1.0;
            0.5 * r * r
        };
        self.edges.iter().zip(self.lengths).map(term).sum()
    }

    fn assemble(&mut self, x: &[DVec2], normal: &mut Normal) {
        for (k, (&[a, b], &length)) in self.edges.iter().zip(self.lengths).enumerate() {
            let edge = x[b as usize] - x[a as usize];
            let now = edge.length();
            let g = edge / (now * length);
            normal.add_pair(k, [a, b], now / length - 1.0, -g, g);
        }
    }

    fn largest_step(&self, x: &[DVec2], step: &[DVec2]) -> f64 {
        step_before_flip(self.triangles.iter().map(|t| t.map(|v| (x[v as usize], step[v as usize]))))
    }

    fn metric(&self, _node: usize) -> [f64; 3] {
        [self.metric, 0.0, self.metric]
    }

    fn restrict(&self, x: DVec2) -> DVec2 {
        x
    }
}

fn doubled_area(x: &[DVec2], [a, b, c]: [u32; 3]) -> f64 {
    let a = x[a as usize];
    (x[b as usize] - a).perp_dot(x[c as usize] - a)
}

/// Lays the mesh into the plane, starting at `plane`, which has no flipped triangle.
///
/// Stops where a step lowers the energy by less than 1e-10 of it. On an interruption `plane` is the best so far.
pub(super) fn flatten(
    mesh: &Mesh,
    edges: &[[u32; 2]],
    plane: &mut Vec<DVec2>,
    span: (f64, f64),
    execution: &Execution<'_>,
) -> Outcome {
    let lengths: Vec<f64> =
        edges.iter().map(|&[a, b]| mesh.vertices[a as usize].distance(mesh.vertices[b as usize])).collect();
    let metric = lengths.iter().map(|length| 1.0 / (length * length)).sum::<f64>() / lengths.len().max(1) as f64;
    let mut problem = Flattening { edges, lengths: &lengths, triangles: &mesh.triangles, metric };
    let settings = Settings { phase: "flatten", span, max_iterations: 200, tolerance: 1e-10 };
    minimise(&mut problem, plane, settings, execution)
}

/// A first flattening of a film without flipped triangles.
///
/// # Errors
/// [`Error::NoResult`] (`not_flattenable`) if the film has no boundary to lay down.
pub(super) fn start(mesh: &Mesh, topology: &Topology) -> Result<Vec<DVec2>, Error> {
    let doubled: DVec3 = mesh.triangles.iter().map(|&t| measure::double_area_vector(mesh.corners(t))).sum();
    if let Some(normal) = doubled.try_normalize() {
        let right = normal.any_orthonormal_vector();
        let up = normal.cross(right);
        let plane: Vec<DVec2> = mesh.vertices.iter().map(|p| DVec2::new(p.dot(right), p.dot(up))).collect();
        // Steep triangles start far too small; Tutte's are better then.
        let steepest = |&t: &[u32; 3]| {
            let area = measure::double_area_vector(mesh.corners(t)).length();
            doubled_area(&plane, t) > 0.05 * area
        };
        if mesh.triangles.iter().all(steepest) {
            return Ok(plane);
        }
    }
    tutte(mesh, topology)
}

/// Tutte's embedding, uniform weights; every boundary loop but the longest is coned to a vertex of its own.
fn tutte(mesh: &Mesh, topology: &Topology) -> Result<Vec<DVec2>, Error> {
    let failed = || {
        Error::no_result(
            "not_flattenable",
            "the surface cannot be laid into the plane without folds: split it into several",
        )
    };
    let loops = topology.boundary_loops();
    let length = |ring: &Vec<u32>| -> f64 {
        let at = |v: u32| mesh.vertices[v as usize];
        ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| at(a).distance(at(b))).sum()
    };
    if loops.is_empty() || topology.components() != 1 || topology.genus() != 0 {
        return Err(failed());
    }
    let lengths: Vec<f64> = loops.iter().map(length).collect();
    let outer = (0..loops.len()).max_by(|&a, &b| lengths[a].total_cmp(&lengths[b]).then(b.cmp(&a))).unwrap_or(0);
    let mut fixed: Vec<Option<DVec2>> = vec![None; mesh.vertices.len()];
    let radius = lengths[outer] / TAU;
    let mut way = 0.0;
    for (&v, &next) in loops[outer].iter().zip(loops[outer].iter().cycle().skip(1)) {
        fixed[v as usize] = Some(DVec2::from_angle(TAU * way / lengths[outer]) * radius);
        way += mesh.vertices[v as usize].distance(mesh.vertices[next as usize]);
    }
    let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); mesh.vertices.len()];
    let join = |neighbours: &mut Vec<Vec<u32>>, a: u32, b: u32| {
        neighbours[a as usize].push(b);
        neighbours[b as usize].push(a);
    };
    for [a, b] in edges(topology) {
        join(&mut neighbours, a, b);
    }
    for (k, ring) in loops.iter().enumerate() {
        if k != outer {
            let cone = neighbours.len() as u32;
            neighbours.push(Vec::new());
            fixed.push(None);
            for &v in ring {
                join(&mut neighbours, cone, v);
            }
        }
    }
    let free: Vec<u32> = (0..neighbours.len() as u32).filter(|&v| fixed[v as usize].is_none()).collect();
    let mut unknown = vec![u32::MAX; neighbours.len()];
    for (k, &v) in free.iter().enumerate() {
        unknown[v as usize] = k as u32;
    }
    let n = free.len();
    let mut matrix = SymmetricMatrix { row_start: vec![0], columns: Vec::new(), values: Vec::new() };
    let mut right = vec![0.0; 2 * n];
    for (k, &v) in free.iter().enumerate() {
        matrix.columns.push(k as u32);
        matrix.values.push(neighbours[v as usize].len() as f64);
        for &w in &neighbours[v as usize] {
            match fixed[w as usize] {
                Some(p) => {
                    right[k] += p.x;
                    right[n + k] += p.y;
                }
                None => {
                    matrix.columns.push(unknown[w as usize]);
                    matrix.values.push(-1.0);
                }
            }
        }
        matrix.row_start.push(matrix.columns.len() as u32);
    }
    if n > 0 {
        let symbolic = Symbolic::analyse(&matrix, None).map_err(|_| failed())?;
        symbolic.factorise(&matrix).and_then(|factor| factor.solve(&mut right)).map_err(|_| failed())?;
    }
    let at =
        |v: usize| fixed[v].unwrap_or_else(|| DVec2::new(right[unknown[v] as usize], right[n + unknown[v] as usize]));
    let mut plane: Vec<DVec2> = (0..mesh.vertices.len()).map(at).collect();
    // The circle holds far more than the surface's area if its boundary is wavy: bring the mean length to scale.
    let (mut on_surface, mut in_plane) = (0.0, 0.0);
    for [a, b] in edges(topology) {
        on_surface += mesh.vertices[a as usize].distance(mesh.vertices[b as usize]);
        in_plane += plane[a as usize].distance(plane[b as usize]);
    }
    plane.iter_mut().for_each(|p| *p *= on_surface / in_plane);
    if mesh.triangles.iter().all(|&t| doubled_area(&plane, t) > 0.0) { Ok(plane) } else { Err(failed()) }
}

/// Finds the triangle of a plane mesh that holds a point, by a grid of buckets.
#[derive(Debug)]
pub(super) struct Locator {
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
        // About one triangle a cell; a thin strip must not make a huge grid.
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

    /// The triangle that holds the point and its barycentric coordinates there; for a point outside the mesh, those of the
    /// nearest point of the mesh.
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
            // Cells beyond this ring are at least so far away.
            if best.is_some_and(|(distance, ..)| distance <= ring as f64 * self.cell) {
                break;
            }
        }
        best.map_or((0, [1.0, 0.0, 0.0]), |(_, t, weights)| (t, weights))
    }
}

/// Distance from a triangle (0 inside) and barycentric coordinates of its nearest point.
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
