//! Flattening (Katoh, Ohsaki and Xu, section 4, step 2, eq. 1) of an auxiliary triangulation of the surface into the
//! plane. It minimises ½ Σ ((Lᵖ - Lˢ)/Lˢ)² over the edges, where Lˢ is the length on the surface and Lᵖ that in the
//! plane.
//!
//! 1. Start from a plane mesh without flipped triangles. For a patch this is its parameters, stretched to its size. For
//!    a film it is the projection to its mean plane. If a triangle folds over or is steep there, it is Tutte's
//!    embedding, with the longest boundary on a circle and every other boundary filled by one vertex.
//! 2. Minimise the sum over the edges by the method of Levenberg and Marquardt.
//! 3. Refuse a result that folds over, because the planar algorithm needs a plane region.
//!
//! The paper names no method. Our departure: steps that would flip a triangle are refused, because a fold alone does
//! not raise the energy.

use super::least_squares::{Outcome, Settings, minimise, step_before_flip};
use crate::edges::edges;
use plateau_mesh::codes::Reason;
use plateau_mesh::error::Error;
use plateau_mesh::execution::Execution;
use plateau_mesh::plane::frame::Frame;
use plateau_mesh::plane::unit_vector;
use plateau_mesh::sparse::levenberg_marquardt::{LeastSquares, NormalEquations};
use plateau_mesh::sparse::{LinearError, Symbolic, SymmetricMatrix};
use plateau_mesh::topology::Topology;
use plateau_mesh::{DVec2, DVec3, Mesh, measure};
use std::f64::consts::TAU;

struct Flattening<'a> {
    edges: &'a [[u32; 2]],
    lengths: &'a [f64],
    triangles: &'a [[u32; 3]],
    /// Scale of the metric: the mean of 1/Lˢ² over the edges.
    metric: f64,
}

impl LeastSquares<2> for Flattening<'_> {
    type Location = DVec2;

    fn couplings(&self, couple: &mut dyn FnMut(&[u32])) {
        self.edges.iter().for_each(|edge| couple(edge));
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

    fn assemble(&mut self, x: &[DVec2], normal: &mut NormalEquations<2>) {
        for (&[a, b], &length) in self.edges.iter().zip(self.lengths) {
            let edge = x[b as usize] - x[a as usize];
            let now = edge.length();
            let g = edge / (now * length);
            normal.add(now / length - 1.0, &[a, b], &[(-g).into(), g.into()]);
        }
    }

    fn advance(&self, x: &[DVec2], step: &[[f64; 2]], to: &mut [DVec2]) -> f64 {
        let moved = |v: u32| (x[v as usize], DVec2::from(step[v as usize]));
        let most = step_before_flip(self.triangles.iter().map(|t| t.map(moved)));
        for (node, place) in to.iter_mut().enumerate() {
            *place = x[node] + DVec2::from(step[node]) * most;
        }
        most
    }

    fn metric(&self, _node: usize) -> [[f64; 2]; 2] {
        [[self.metric, 0.0], [0.0, self.metric]]
    }
}

fn doubled_area(x: &[DVec2], [a, b, c]: [u32; 3]) -> f64 {
    let a = x[a as usize];
    (x[b as usize] - a).perp_dot(x[c as usize] - a)
}

/// Flattens the mesh. `plane` has the positions of the start, which must have no flipped triangle, and receives the
/// result. `span` is the interval of the progress that belongs to the flattening.
///
/// The flattening ends after 200 steps, or when several steps in a row lower the energy by less than 1e-10 of its
/// value. On an interruption `plane` has the best positions found.
pub(crate) fn flatten(
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

/// Returns a first flattening of a film, without flipped triangles.
///
/// # Errors
/// [`Error::NoResult`] (`not_flattenable`) if the film has no boundary to lay down, or if Tutte's embedding folds over
/// too.
pub(crate) fn start(mesh: &Mesh, topology: &Topology) -> Result<Vec<DVec2>, Error> {
    let doubled: DVec3 = mesh.triangles.iter().map(|&t| measure::double_area_vector(mesh.corners(t))).sum();
    if let Some(normal) = doubled.try_normalize() {
        let frame = Frame::with_normal(normal);
        let plane: Vec<DVec2> = mesh.vertices.iter().map(|&p| frame.coordinates(p)).collect();
        // Triangles that are steep against the mean plane would start far too small. Tutte's embedding is then the
        // better start.
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

/// Tutte's embedding with uniform weights. Every boundary loop but the longest is filled by a cone to a vertex of its
/// own.
fn tutte(mesh: &Mesh, topology: &Topology) -> Result<Vec<DVec2>, Error> {
    let failed = || {
        Error::no_result(
            Reason::NotFlattenable,
            "the surface cannot be laid into the plane without folds: split it into several",
        )
    };
    let loops = topology.boundary_loops();
    let length = |ring: &Vec<u32>| -> f64 {
        let position = |v: u32| mesh.vertices[v as usize];
        ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| position(a).distance(position(b))).sum()
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
        fixed[v as usize] = Some(unit_vector(TAU * way / lengths[outer]) * radius);
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
    let mut plane = at_means(&neighbours, &fixed).map_err(|_| failed())?;
    plane.truncate(mesh.vertices.len());
    // If the boundary is wavy, the circle encloses far more than the surface's area. The embedding is therefore scaled
    // to the mean length of the edges.
    let (mut on_surface, mut in_plane) = (0.0, 0.0);
    for [a, b] in edges(topology) {
        on_surface += mesh.vertices[a as usize].distance(mesh.vertices[b as usize]);
        in_plane += plane[a as usize].distance(plane[b as usize]);
    }
    plane.iter_mut().for_each(|p| *p *= on_surface / in_plane);
    if mesh.triangles.iter().all(|&t| doubled_area(&plane, t) > 0.0) { Ok(plane) } else { Err(failed()) }
}

/// Returns positions at which every vertex without a given position lies at the mean of its neighbours.
fn at_means(neighbours: &[Vec<u32>], fixed: &[Option<DVec2>]) -> Result<Vec<DVec2>, LinearError> {
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
        Symbolic::analyse(&matrix, None)?.factorise(&matrix)?.solve(&mut right)?;
    }
    let position =
        |v: usize| fixed[v].unwrap_or_else(|| DVec2::new(right[unknown[v] as usize], right[n + unknown[v] as usize]));
    Ok((0..neighbours.len()).map(position).collect())
}
