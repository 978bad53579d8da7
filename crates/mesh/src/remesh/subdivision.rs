//! Regular subdivision: every triangle becomes four and every edge two.

use crate::DVec3;
use crate::film::Film;
use crate::topology::{NONE, Topology, next, previous};

/// Splits every triangle into four. New vertices follow the old ones and lie in the middle of their edge. Also returns
/// the ends of that edge for each new vertex, so that values can be transferred between the two meshes.
///
/// New vertices on the boundary and on locked edges are fixed.
pub fn subdivide(film: &Film) -> (Film, Vec<[u32; 2]>) {
    let old = film.vertices.len();
    let (topology, parents) = film.topology.subdivided();
    let mut vertices = film.vertices.clone();
    vertices.extend(parents.iter().map(|&[a, b]| {
        let (p, q) = (film.vertices[a as usize], film.vertices[b as usize]);
        p + 0.5 * (q - p)
    }));
    let mut fixed = film.fixed.clone();
    let mut locked = Vec::with_capacity(2 * film.locked.len());
    for (k, &[a, b]) in parents.iter().enumerate() {
        let middle = (old + k) as u32;
        let stays = film.is_locked(a, b);
        if stays {
            locked.extend([[a, middle], [b, middle]]);
        }
        fixed.push(stays || topology.is_boundary(middle));
    }
    locked.sort_unstable();
    let boundaries = film.boundaries.iter().map(|boundary| halved(boundary, &topology, old as u32)).collect();
    (Film { vertices, topology, fixed, locked, boundaries }, parents)
}

/// A boundary loop of the old mesh, with the midpoints of its edges inserted. `topology` is that of the new mesh.
fn halved(boundary: &[u32], topology: &Topology, old: u32) -> Vec<u32> {
    let middle = |a: u32, b: u32| {
        let ahead = topology.to(topology.outgoing[a as usize]);
        // If the loop runs against its triangles, the next midpoint is the start of the boundary half-edge that ends at
        // a.
        let along = topology.to(topology.outgoing[ahead as usize]) == b;
        if along { ahead } else { topology.from(previous_on_boundary(topology, a)) }
    };
    let mut result = Vec::with_capacity(2 * boundary.len());
    for (k, &a) in boundary.iter().enumerate() {
        let between = middle(a, boundary[(k + 1) % boundary.len()]);
        debug_assert!(between >= old);
        result.extend([a, between]);
    }
    result
}

/// The boundary half-edge that ends at a boundary vertex: the last edge of the vertex's fan.
fn previous_on_boundary(topology: &Topology, vertex: u32) -> u32 {
    topology.outgoing_half_edges(vertex).last().map_or(NONE, previous)
}

/// Regular subdivision like [`Topology::subdivided`], except that boundary edges for which `splits` returns false are
/// not split. The triangles at these edges are divided into fewer parts.
pub fn subdivided_inside(
    topology: &Topology,
    vertices: &[DVec3],
    splits: impl Fn(u32, u32) -> bool,
) -> (Topology, Vec<[u32; 2]>) {
    let old = vertices.len() as u32;
    let mut midpoints: Vec<[u32; 2]> = Vec::new();
    let mut middle = vec![NONE; topology.twin.len()];
    for h in 0..topology.twin.len() {
        let (a, b, twin) = (topology.from(h as u32), topology.to(h as u32), topology.twin[h]);
        if middle[h] == NONE && (twin != NONE || splits(a, b)) {
            middle[h] = old + midpoints.len() as u32;
            if twin != NONE {
                middle[twin as usize] = middle[h];
            }
            midpoints.push([a, b]);
        }
    }
    let position = |v: u32| match v.checked_sub(old) {
        None => vertices[v as usize],
        Some(new) => {
            0.5 * (vertices[midpoints[new as usize][0] as usize] + vertices[midpoints[new as usize][1] as usize])
        }
    };
    let mut triangles = Vec::with_capacity(4 * topology.triangles().len());
    for t in 0..topology.triangles().len() {
        // The triangle is divided along its midpoints. Corners between two midpoints are cut off, and the rest is
        // divided along its shorter diagonal.
        let h = 3 * t as u32;
        let mut whole = [h, next(h), previous(h)].into_iter().filter(|&h| middle[h as usize] == NONE);
        let first = whole.next();
        let second = whole.next();
        let corner = |h: u32| (topology.from(h), middle[h as usize]);
        match (first, second) {
            (None, _) => {
                let [(a, ab), (b, bc), (c, ca)] = [corner(h), corner(next(h)), corner(previous(h))];
                triangles.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
            }
            (Some(edge), None) => {
                let [(a, _), (b, bc), (c, ca)] = [corner(edge), corner(next(edge)), corner(previous(edge))];
                triangles.push([c, ca, bc]);
                if position(a).distance_squared(position(bc)) <= position(b).distance_squared(position(ca)) {
                    triangles.extend([[a, b, bc], [a, bc, ca]]);
                } else {
                    triangles.extend([[a, b, ca], [b, bc, ca]]);
                }
            }
            (Some(_), Some(_)) => {
                let halved = [h, next(h), previous(h)].into_iter().find(|&h| middle[h as usize] != NONE);
                match halved {
                    Some(edge) => {
                        let [(a, ab), (b, _), (c, _)] = [corner(edge), corner(next(edge)), corner(previous(edge))];
                        triangles.extend([[a, ab, c], [ab, b, c]]);
                    }
                    None => triangles.push(topology.triangles()[t]),
                }
            }
        }
    }
    let topology = Topology::build(&triangles, (old as usize) + midpoints.len());
    (topology.expect("cutting triangles along halved edges keeps a manifold one"), midpoints)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structured::{patch, shaken};

    #[test]
    fn subdivision_puts_boundary_points_on_the_segments_in_either_direction() {
        for reversed in [false, true] {
            let mut film = shaken(3, 0.5);
            if reversed {
                film.boundaries[0].reverse();
            }
            film.locked = vec![[5, 6]];
            let (fine, parents) = subdivide(&film);
            assert_eq!(fine.triangles().len(), 4 * film.triangles().len());
            assert!((fine.area() - film.area()).abs() < 1e-14);
            let boundary = &fine.boundaries[0];
            assert_eq!(boundary.len(), 24);
            for k in 0..24 {
                assert!(fine.topology.are_adjacent(boundary[k], boundary[(k + 1) % 24]));
                assert!(fine.fixed[boundary[k] as usize]);
            }
            assert_eq!(boundary.iter().step_by(2).copied().collect::<Vec<_>>(), film.boundaries[0]);
            let middle = parents.iter().position(|&edge| edge == [5, 6] || edge == [6, 5]).unwrap() + 16;
            assert_eq!(fine.locked, [[5, middle as u32], [6, middle as u32]]);
            assert!(fine.fixed[middle]);
        }
    }

    #[test]
    fn boundary_edges_that_stay_whole_leave_a_manifold_with_everything_else_halved() {
        let film = patch(3, 4, |u, v| DVec3::new(u, v, u * v));
        for pattern in [0u32, 1, 2, 5] {
            let splits = |a: u32, b: u32| pattern.wrapping_mul(a + b) % 3 == 1;
            let (topology, midpoints) = subdivided_inside(&film.topology, &film.vertices, splits);
            assert_eq!(topology.euler_characteristic(), 1);
            let rim = film.boundaries[0].len();
            let whole = (0..rim).filter(|&k| !splits(film.boundaries[0][k], film.boundaries[0][(k + 1) % rim])).count();
            assert_eq!(midpoints.len(), film.topology.edge_count() - whole);
            assert_eq!(topology.triangles().len(), 4 * film.triangles().len() - whole);
            let boundary = &topology.boundary_loops()[0];
            assert_eq!(boundary.len(), 2 * rim - whole);
        }
    }
}
