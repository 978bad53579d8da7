//! Measures the deviation of a finished mesh from its surface, and checks that it is small enough.

use super::move_nodes::{OnSurface, Sheet};
use crate::options::{Optimise, Options, Transition};
use crate::report::{Method, SurfaceFit, UniformMesh, Why};
use plateau_mesh::measure::{self, angles, double_area_vector};
use plateau_mesh::topology::edge_key;
use std::collections::BTreeSet;

/// Limits that a mesh of a curved surface must keep to be called converged.
struct Limits {
    /// Largest difference between the mesh's area and the surface's area, as a fraction of the surface's area.
    area: f64,
    /// Largest angle between a triangle's normal and the surface's, radians. At a larger angle the triangle counts as
    /// turned away from the surface.
    normal: f64,
    /// Range of the lengths, in ℓ, of members that curvature or the optimisation takes out of [ℓ, 2ℓ].
    lengths: (f64, f64),
    /// Smallest inner angle, in radians, of triangles without an edge that the boundary takes out of range.
    angle: f64,
}

const LIMITS: Limits =
    Limits { area: 0.01, normal: 1.4, lengths: (0.6, 2.5), angle: 5.0 * std::f64::consts::PI / 180.0 };

/// Compares the triangles of the nodes with the surface. `area` is the area of the surface in units of ℓ². `unit` is ℓ
/// in the caller's unit, and distances and areas are returned in the caller's unit.
pub(crate) fn compare<S: Sheet>(nodes: &OnSurface<'_, S>, area: f64, unit: f64, method: Method) -> SurfaceFit {
    let (mut mesh_area, mut distance, mut turn) = (0.0, 0.0f64, 0.0f64);
    for &triangle in &nodes.triangles {
        let corners = triangle.map(|v| nodes.positions[v as usize]);
        let normal = double_area_vector(corners);
        mesh_area += 0.5 * normal.length();
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let (below, upward) = nodes.surface.below(triangle.map(|v| nodes.parameters[v as usize]), middle);
        distance = distance.max(below.distance(middle));
        if upward.length_squared() > 0.0 {
            turn = turn.max(measure::angle(normal, upward));
        }
    }
    SurfaceFit {
        method,
        area: area * unit * unit,
        area_error: (mesh_area - area) / area,
        distance_max: distance * unit,
        normal_deviation_max: turn,
    }
}

/// Describes by how much a mesh misses its limits; `None` if it keeps them.
pub(crate) fn shortfall(result: &UniformMesh, options: &Options) -> Option<String> {
    let fit = result.statistics.surface?;
    let mut reasons = Vec::new();
    if fit.area_error.is_nan() || fit.area_error.abs() > LIMITS.area {
        reasons.push(format!("the mesh's area differs from the surface's by {:.2}%", 100.0 * fit.area_error));
    }
    if fit.normal_deviation_max > LIMITS.normal {
        let degrees = fit.normal_deviation_max.to_degrees();
        reasons.push(format!("a triangle is turned by {degrees:.0} degrees against the surface"));
    }
    // Members of a free transition zone, of shared lengths and of nodes that did not move may have any length.
    let bounded = options.optimise == Optimise::Nodes && options.transition == Transition::Bounded;
    let far = result.out_of_range.iter().filter(|edge| matches!(edge.why, Why::Curvature | Why::Optimised));
    let (low, high) =
        far.fold((f64::INFINITY, 0.0), |(low, high), edge| (f64::min(low, edge.length), f64::max(high, edge.length)));
    let (low, high) = (low / options.edge_length, high / options.edge_length);
    if bounded && low < LIMITS.lengths.0 {
        reasons.push(format!("the shortest edge is {low:.2} of the edge length"));
    }
    if bounded && high > LIMITS.lengths.1 {
        reasons.push(format!("the longest edge is {high:.2} times the edge length"));
    }
    let smallest = smallest_angle(result);
    // A free transition zone may have any angle too.
    if options.transition == Transition::Bounded && smallest < LIMITS.angle {
        reasons.push(format!("the smallest angle is {:.2} degrees", smallest.to_degrees()));
    }
    (!reasons.is_empty())
        .then(|| format!("{}: the surface is curved too strongly for this edge length", reasons.join(", ")))
}

/// Smallest inner angle, in radians, over the triangles without an edge that the boundary takes out of range. Triangles
/// with such an edge are left out, because they lie in a sharp corner, at a short side or in a narrow part of the
/// domain and cannot have larger angles than the domain there.
fn smallest_angle(result: &UniformMesh) -> f64 {
    let of_boundary = |why: Why| matches!(why, Why::SharpCorner | Why::Narrow | Why::ShortSide);
    let excused: BTreeSet<[u32; 2]> = result
        .out_of_range
        .iter()
        .filter(|edge| of_boundary(edge.why))
        .map(|edge| edge_key(result.members[edge.member]))
        .collect();
    let judged = result
        .mesh
        .triangles
        .iter()
        .filter(|&&[a, b, c]| [[a, b], [b, c], [c, a]].into_iter().all(|edge| !excused.contains(&edge_key(edge))));
    judged.flat_map(|&triangle| angles(result.mesh.corners(triangle))).fold(f64::INFINITY, f64::min)
}
