//! Splits vertices, for formats whose normals and colours belong to vertices.
//!
//! At an edge with three triangles a film has three sides, so no single normal fits all of them. Colours of triangles
//! end at their edges, so a vertex between two colours needs both.

use plateau_mesh::Mesh;
use plateau_mesh::disjoint_sets::DisjointSets;

/// Returns a mesh with a separate vertex for each sheet that meets at a vertex of `mesh`, and for each vertex of the
/// result its original in `mesh`. The vertices of `mesh` come first and the added ones after them. Triangles belong to
/// the same sheet if they are connected across edges with two triangles.
///
/// Returns `None` if no vertex needs to be split. Takes O(n log n) time.
pub fn split_by_sheet(mesh: &Mesh) -> Option<(Mesh, Vec<u32>)> {
    let mut edges: Vec<([u32; 2], usize, usize)> = (0..mesh.triangles.len())
        .flat_map(|t| (0..3).map(move |k| (t, k)))
        .map(|(t, k)| {
            let (a, b) = (mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
            ([a.min(b), a.max(b)], t, k)
        })
        .collect();
    edges.sort_unstable();
    if !edges.windows(3).any(|three| three[0].0 == three[1].0 && three[1].0 == three[2].0) {
        return None;
    }
    // Sets of corners 3 t + k of the triangles. Corners at one vertex are joined if their triangles are neighbours in a
    // sheet.
    let mut sets = DisjointSets::new(3 * mesh.triangles.len());
    for group in edges.chunk_by(|a, b| a.0 == b.0) {
        let &[(ends, t, _), (_, u, _)] = group else { continue };
        for end in ends {
            let corner = |t: usize| mesh.triangles[t].iter().position(|&v| v == end).map(|k| 3 * t + k);
            if let (Some(a), Some(b)) = (corner(t), corner(u)) {
                sets.join(a as u32, b as u32);
            }
        }
    }
    let mut split = mesh.clone();
    let mut source: Vec<u32> = (0..mesh.vertices.len() as u32).collect();
    // The first sheet at a vertex keeps the original vertex.
    let mut taken = vec![false; mesh.vertices.len()];
    let mut vertex_of = vec![u32::MAX; 3 * mesh.triangles.len()];
    for corner in 0..vertex_of.len() {
        let first = sets.leader(corner as u32) as usize;
        let v = mesh.triangles[corner / 3][corner % 3];
        if first == corner {
            vertex_of[corner] = if std::mem::replace(&mut taken[v as usize], true) {
                source.push(v);
                split.vertices.push(mesh.vertices[v as usize]);
                split.vertices.len() as u32 - 1
            } else {
                v
            };
        }
        split.triangles[corner / 3][corner % 3] = vertex_of[first];
    }
    Some((split, source))
}

/// Returns a mesh in which all triangles at a vertex have the same value, for each of its vertices the original in
/// `mesh`, and for each of its vertices the value. `values` has a number for each triangle. The vertices of `mesh` come
/// first and the added ones after them. A vertex without triangles has the value 0. Takes O(n log n) time.
pub fn split_by_value(mesh: &Mesh, values: &[f64]) -> (Mesh, Vec<u32>, Vec<f64>) {
    let mut split = mesh.clone();
    let mut source: Vec<u32> = (0..mesh.vertices.len() as u32).collect();
    let mut at_vertices = vec![0.0; mesh.vertices.len()];
    let mut corners: Vec<(u32, f64, usize)> =
        mesh.triangles.iter().flatten().enumerate().map(|(corner, &v)| (v, values[corner / 3], corner)).collect();
    corners.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
    for at_vertex in corners.chunk_by(|a, b| a.0 == b.0) {
        for (k, of_value) in at_vertex.chunk_by(|a, b| a.1 == b.1).enumerate() {
            let (v, value, _) = of_value[0];
            let vertex = if k == 0 {
                at_vertices[v as usize] = value;
                v
            } else {
                source.push(v);
                at_vertices.push(value);
                split.vertices.push(mesh.vertices[v as usize]);
                split.vertices.len() as u32 - 1
            };
            for &(_, _, corner) in of_value {
                split.triangles[corner / 3][corner % 3] = vertex;
            }
        }
    }
    (split, source, at_vertices)
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::DVec3;
    use plateau_mesh::measure::vertex_normals;

    #[test]
    fn three_sheets_at_an_edge_get_their_own_vertices_and_normals() {
        let mut vertices = vec![DVec3::ZERO, DVec3::Z, 2.0 * DVec3::Z];
        let mut triangles = Vec::new();
        let mut normals = Vec::new();
        for k in 0..3u32 {
            let angle = f64::from(k) * std::f64::consts::TAU / 3.0;
            vertices.push(DVec3::new(libm::cos(angle), libm::sin(angle), 1.0));
            triangles.extend([[0, 1, 3 + k], [1, 2, 3 + k]]);
            normals.push(DVec3::new(-libm::sin(angle), libm::cos(angle), 0.0));
        }
        let mesh = Mesh::new(vertices, triangles);
        let (split, source) = split_by_sheet(&mesh).unwrap();
        assert_eq!(split.vertices.len(), 6 + 2 * 3);
        assert_eq!(source[..6], [0, 1, 2, 3, 4, 5]);
        assert!(split.vertices.iter().zip(&source).all(|(&p, &v)| p == mesh.vertices[v as usize]));
        for (triangle, original) in split.triangles.iter().zip(&mesh.triangles) {
            assert_eq!(triangle.map(|v| source[v as usize]), *original);
        }
        // Each vertex has the normal of its own sheet.
        let shaded = vertex_normals(&split);
        for (k, triangle) in split.triangles.iter().enumerate() {
            assert!(triangle.iter().all(|&v| shaded[v as usize].distance(normals[k / 2]) < 1e-15));
        }
        assert_eq!(split_by_sheet(&Mesh::new(split.vertices, split.triangles)), None);
    }
}
