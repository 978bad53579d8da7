//! Turns the best field of a search into a proof, and finds the places where the bound is not tight.

use super::bisection::{BEST, BisectionMesh};
use super::bound::Field;
use super::hull::Hull;
use super::orientation::Oriented;
use super::rigorous;
use super::space::Space;
use super::symmetry::{self, Axes};
use plateau_mesh::{DVec3, Mesh};

/// Proves the bound of the best field on a mesh. Scales the field to |curl A| <= 1 and computes its circulation, both
/// with outward rounding. `None` if rounding leaves no proof.
pub(super) fn prove(mesh: &BisectionMesh, oriented: &Oriented, hull: &Hull, axes: Option<&Axes>) -> Option<Field> {
    let Oriented { loops, free, .. } = oriented;
    let space = Space::within(mesh, hull);
    let mut field = space.field(mesh, BEST);
    if !scale_to_one(&space, &mut field) {
        return None;
    }
    let margin = 0.5 * hull.margin;
    let area_lower_bound = rigorous::least_area(&space, mesh, &field, (&loops[..], &free[..]), axes, margin)?.max(0.0);
    let (edge_values, faces) = field.split_at(space.edges.len());
    let (half_spaces, unconstrained) = hull.beyond(&space.corners);
    Some(Field {
        loops: loops.clone(),
        free_loops: free.clone(),
        area_lower_bound,
        axes: axes.copied(),
        corners: mesh.corners(),
        mirrors: mesh.mirrors().planes(mesh.corners()[0]),
        vertices: mesh.vertices.clone(),
        tetrahedra: (0..mesh.leaf_count()).map(|leaf| mesh.leaf_vertices(leaf)).collect(),
        edge_values: edge_values.to_vec(),
        face_values: faces.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect(),
        edges: space.edges,
        faces: space.faces,
        half_spaces,
        unconstrained,
    })
}

/// 1 - |curl A · n| at each vertex of the film, for the best field on a mesh.
pub(super) fn slack(mesh: &BisectionMesh, film: &Mesh, hull: &Hull, axes: Option<&Axes>) -> Vec<f64> {
    let mut normals = vec![DVec3::ZERO; film.vertices.len()];
    for &triangle in &film.triangles {
        let [a, b, c] = film.corners(triangle);
        let area = (b - a).cross(c - a);
        triangle.iter().for_each(|&v| normals[v as usize] += area);
    }
    let constrained = Space::within(mesh, hull).constrained;
    let curls = constrained.iter().flat_map(|&leaf| mesh.nodal[leaf as usize].curl[BEST]);
    let largest = curls.map(DVec3::length).fold(0.0, f64::max);
    let slack_at = |(point, normal): (&DVec3, DVec3)| {
        let point = symmetry::place(axes, *point);
        let normal = axes.map_or(normal, |axes| axes.turn(normal));
        let (leaf, weights) = mesh.locate(point);
        let curls = mesh.nodal[leaf as usize].curl[BEST];
        let curl: DVec3 = curls.iter().zip(weights).map(|(&curl, weight)| curl * weight).sum();
        let normal = normal.normalize_or_zero() * mesh.flips(point);
        let along = if largest > 0.0 { curl.dot(normal).abs() / largest } else { 0.0 };
        (1.0 - along).clamp(0.0, 1.0)
    };
    film.vertices.iter().zip(normals).map(slack_at).collect()
}

/// Scales a field so that interval arithmetic proves |curl A| <= 1. Returns whether that succeeded. A field whose curl
/// is zero is not changed.
pub(super) fn scale_to_one(space: &Space, field: &mut [f64]) -> bool {
    for margin in [1e-14, 1e-13, 1e-11, 1e-8] {
        let largest = rigorous::largest_curl(space, field);
        if largest <= 1.0 && (largest == 0.0 || largest > 1.0 - 1e-9) {
            return true;
        }
        if !largest.is_finite() || largest == 0.0 {
            return largest == 0.0;
        }
        let factor = (1.0 - margin) / largest;
        field.iter_mut().for_each(|value| *value *= factor);
    }
    rigorous::largest_curl(space, field) <= 1.0
}
