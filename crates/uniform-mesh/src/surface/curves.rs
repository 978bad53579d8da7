//! Curves on the reference triangulation. A curve is a chain of edges at which walks end, from one corner to the next.

use plateau_mesh::topology::{NONE, Topology};
use plateau_mesh::{Mesh, measure};

/// A vertex of a curve is a corner if the curve turns by more than this angle, radians.
const CORNER_TURN: f64 = std::f64::consts::FRAC_PI_6;

/// A chain of edges of the reference triangulation between two corners, or around from one corner to itself.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    /// The edges in order. Each is a half-edge, and whether the chain runs in the opposite direction.
    pub edges: Vec<(u32, bool)>,
    /// The length along the curve at the start of each edge, followed by the length of the whole curve.
    pub at: Vec<f64>,
    /// The vertices of the reference triangulation at the two ends.
    pub ends: [u32; 2],
}

impl Curve {
    pub fn length(&self) -> f64 {
        self.at[self.at.len() - 1]
    }
}

/// Joins the edges at which walks end to curves, and marks the corners between them. On a film the corners are given.
/// On a patch (`kinks_are_corners`), each kink of a crease or of the boundary becomes a corner.
pub(super) fn join_curves(
    mesh: &Mesh,
    topology: &Topology,
    stops: &[bool],
    kinks_are_corners: bool,
    corner: &mut [bool],
) -> Vec<Curve> {
    // Each edge is listed at both of its ends, by one of its half-edges.
    let mut at_vertex: Vec<(u32, u32)> = Vec::new();
    for h in 0..topology.twin.len() as u32 {
        let twin = topology.twin[h as usize];
        if stops[h as usize] && (twin == NONE || twin > h) {
            at_vertex.extend([(topology.from(h), h), (topology.to(h), h)]);
        }
    }
    at_vertex.sort_unstable();
    let around = |v: u32| {
        let first = at_vertex.partition_point(|&(w, _)| w < v);
        let last = at_vertex.partition_point(|&(w, _)| w <= v);
        &at_vertex[first..last]
    };
    let other = |h: u32, v: u32| if topology.from(h) == v { topology.to(h) } else { topology.from(h) };
    let position = |v: u32| mesh.vertices[v as usize];
    let mut k = 0;
    // Ends because the edges around a vertex include the one at `k`.
    while k < at_vertex.len() {
        let v = at_vertex[k].0;
        let edges = around(v);
        k += edges.len();
        let sharp = match *edges {
            [(_, g), (_, h)] => {
                measure::angle(position(v) - position(other(g, v)), position(other(h, v)) - position(v)) > CORNER_TURN
            }
            _ => true,
        };
        corner[v as usize] |= edges.len() != 2 || (sharp && kinks_are_corners);
    }
    let mut used = vec![false; topology.twin.len()];
    let mut curves = Vec::new();
    let mut trace = |start: u32, first: u32, corner: &[bool], used: &mut [bool]| {
        let (mut v, mut h) = (start, first);
        let mut curve = Curve { edges: Vec::new(), at: vec![0.0], ends: [start, start] };
        // At most one pass per edge, because an edge that is used is not taken again.
        loop {
            used[h as usize] = true;
            let end = other(h, v);
            curve.edges.push((h, topology.from(h) != v));
            curve.at.push(curve.length() + position(v).distance(position(end)));
            v = end;
            if corner[v as usize] || v == start {
                break;
            }
            match around(v).iter().find(|&&(_, g)| !used[g as usize]) {
                Some(&(_, g)) => h = g,
                None => break,
            }
        }
        curve.ends[1] = v;
        curves.push(curve);
    };
    let corners: Vec<u32> = (0..corner.len() as u32).filter(|&v| corner[v as usize]).collect();
    for v in corners {
        for &(_, h) in around(v) {
            if !used[h as usize] {
                trace(v, h, corner, &mut used);
            }
        }
    }
    // A closed loop without a corner gets one at its first vertex.
    for &(v, h) in &at_vertex {
        if !used[h as usize] {
            corner[v as usize] = true;
            trace(v, h, corner, &mut used);
        }
    }
    curves
}
