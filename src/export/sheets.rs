//! A film with junctions for formats that shade by vertex normals: at an edge of three triangles the surface has three
//! sides, and one normal for all of them would be none.

use plateau_geometry::Mesh;

/// The mesh with one vertex for each sheet that meets at a vertex: the mesh's own first, the further ones after them; and for
/// each vertex the one of `mesh` that it stands for. Sheets hang together across edges of two triangles.
///
/// `None` for a mesh that needs no further vertices. O(n log n).
pub fn apart(mesh: &Mesh) -> Option<(Mesh, Vec<u32>)> {
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
    // Corners 3 t + k of triangles, joined where they are of one vertex and of neighbours in a sheet.
    let mut leader: Vec<usize> = (0..3 * mesh.triangles.len()).collect();
    for group in edges.chunk_by(|a, b| a.0 == b.0) {
        let &[(ends, t, _), (_, u, _)] = group else { continue };
        for end in ends {
            let corner = |t: usize| mesh.triangles[t].iter().position(|&v| v == end).map(|k| 3 * t + k);
            if let (Some(a), Some(b)) = (corner(t), corner(u)) {
                let (a, b) = (find(&mut leader, a), find(&mut leader, b));
                leader[a.max(b)] = a.min(b);
            }
        }
    }
    let mut split = mesh.clone();
    let mut source: Vec<u32> = (0..mesh.vertices.len() as u32).collect();
    // The first sheet at a vertex keeps it.
    let mut taken = vec![false; mesh.vertices.len()];
    let mut vertex_of = vec![u32::MAX; leader.len()];
    for corner in 0..leader.len() {
        let first = find(&mut leader, corner);
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

/// The least corner of a corner's class.
fn find(leader: &mut [usize], corner: usize) -> usize {
    let mut root = corner;
    while leader[root] != root {
        root = leader[root];
    }
    let mut corner = corner;
    while leader[corner] != root {
        corner = std::mem::replace(&mut leader[corner], root);
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_geometry::DVec3;
    use plateau_geometry::mesh::measure::vertex_normals;

    #[test]
    fn three_leaves_of_a_book_have_a_spine_each() {
        let mut vertices = vec![DVec3::ZERO, DVec3::Z, 2.0 * DVec3::Z];
        let mut triangles = Vec::new();
        let mut normals = Vec::new();
        for k in 0..3u32 {
            let angle = f64::from(k) * std::f64::consts::TAU / 3.0;
            vertices.push(DVec3::new(angle.cos(), angle.sin(), 1.0));
            triangles.extend([[0, 1, 3 + k], [1, 2, 3 + k]]);
            normals.push(DVec3::new(-angle.sin(), angle.cos(), 0.0));
        }
        let mesh = Mesh::new(vertices, triangles);
        let (split, source) = apart(&mesh).unwrap();
        assert_eq!(split.vertices.len(), 6 + 2 * 3);
        assert_eq!(source[..6], [0, 1, 2, 3, 4, 5]);
        assert!(split.vertices.iter().zip(&source).all(|(&p, &v)| p == mesh.vertices[v as usize]));
        for (triangle, original) in split.triangles.iter().zip(&mesh.triangles) {
            assert_eq!(triangle.map(|v| source[v as usize]), *original);
        }
        // Each vertex has the normal of its own leaf.
        let shaded = vertex_normals(&split);
        for (k, triangle) in split.triangles.iter().enumerate() {
            assert!(triangle.iter().all(|&v| shaded[v as usize].distance(normals[k / 2]) < 1e-15));
        }
        assert_eq!(apart(&Mesh::new(split.vertices, split.triangles)), None);
    }
}
