//! The stated topology of a surface.

use super::comparison::Audit;
use super::edges::{Components, Edges};

/// Compares the stated numbers of components and boundary loops, the Euler characteristic and the genus with those of
/// the mesh. A mesh of sheets that meet along junctions has no genus.
pub(crate) fn compare(audit: &mut Audit, edges: &Edges, has_junctions: bool) {
    let mesh = &audit.contents.mesh;
    let count = mesh.vertices.len();
    let mut is_used = vec![false; count];
    mesh.triangles.iter().flatten().for_each(|&v| is_used[v as usize] = true);
    let unused = is_used.iter().filter(|used| !**used).count();
    audit.require(unused == 0, || "every vertex belongs to a triangle".into(), || format!("{unused} do not"));
    let oriented = has_junctions || edges.are_of_an_oriented_manifold();
    audit.require(oriented, || "the mesh is an oriented manifold".into(), || "it is not".into());
    let components = Components::of(edges.list.iter(), count).count(&is_used);
    let characteristic = count as i64 - edges.list.len() as i64 + mesh.triangles.len() as i64;
    audit.equal("/components", components);
    audit.equal_signed("/euler_characteristic", characteristic);
    let mut on_boundary = vec![false; count];
    edges.on_boundary().flat_map(|edge| edge.ends).for_each(|v| on_boundary[v as usize] = true);
    // On a manifold, every connected component of the boundary edges is a loop.
    let loops = Components::of(edges.on_boundary(), count).count(&on_boundary);
    if !has_junctions {
        audit.equal("/boundary_loops", loops);
        audit.equal_signed("/genus", (2 * components as i64 - characteristic - loops as i64) / 2);
    }
}
