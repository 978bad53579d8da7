//! Orientations of the boundary: the directions in which a surface can run along its loops.

use super::bisection::VertexMap;
use super::symmetry::Mirrors;
use plateau_mesh::polyline::position_key;
use plateau_mesh::{DVec3, Mesh};

/// The loops in one orientation.
#[derive(Debug)]
pub(super) struct Oriented {
    pub loops: Vec<Vec<DVec3>>,
    /// The loops along the axes of the mesh.
    pub placed: Vec<Vec<DVec3>>,
    pub mirrors: Mirrors,
}

impl Oriented {
    /// Orients loops: those of which a bit of `pattern` differs from the film's own direction are reversed.
    pub fn of(
        loops: &[Vec<DVec3>],
        own: &[bool],
        pattern: u32,
        place: &impl Fn(DVec3) -> DVec3,
        middle: DVec3,
    ) -> Self {
        // The pattern 0 is the film's own orientation.
        let oriented = |(k, points): (usize, &Vec<DVec3>)| -> Vec<DVec3> {
            if own[k] == (pattern >> k & 1 == 1) { points.iter().rev().copied().collect() } else { points.clone() }
        };
        let loops: Vec<Vec<DVec3>> = loops.iter().enumerate().map(oriented).collect();
        let placed: Vec<Vec<DVec3>> = loops.iter().map(|points| points.iter().map(|&p| place(p)).collect()).collect();
        let mirrors = Mirrors::of(&placed, middle);
        Self { loops, placed, mirrors }
    }
}

/// The integral of the unit normal over any surface that the loops bound. Its length is the bound that a field of
/// constant curl gives: the area itself for plane polygons.
pub(super) fn vector_area(loops: &[Vec<DVec3>]) -> DVec3 {
    let origin = loops[0][0];
    let double_area = |points: &Vec<DVec3>| -> DVec3 {
        (0..points.len()).map(|k| (points[k] - origin).cross(points[(k + 1) % points.len()] - origin)).sum()
    };
    0.5 * loops.iter().map(double_area).sum::<DVec3>()
}

/// For each loop whether the film's triangles run along it in the loop's direction.
pub(super) fn own_orientation(loops: &[Vec<DVec3>], film: &Mesh) -> Vec<bool> {
    let mut triangles_at: VertexMap<u32, Vec<u32>> = VertexMap::default();
    for (t, triangle) in film.triangles.iter().enumerate() {
        for &v in triangle {
            triangles_at.entry(v).or_default().push(t as u32);
        }
    }
    let mut places: Vec<([u64; 3], u32)> =
        film.vertices.iter().enumerate().map(|(v, &p)| (position_key(p), v as u32)).collect();
    places.sort_unstable();
    loops
        .iter()
        .map(|points| {
            // A triangle at the loop's first vertex has an edge that leaves it along the first segment, or arrives
            // along that segment.
            let vertex =
                places.get(places.partition_point(|place| place.0 < position_key(points[0]))).map(|place| place.1);
            let along = (points[1] - points[0]).normalize_or_zero();
            let mut best = (0.0, true);
            for &t in vertex.and_then(|v| triangles_at.get(&v)).into_iter().flatten() {
                let triangle = film.triangles[t as usize];
                for k in 0..3 {
                    let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
                    let forward = Some(a) == vertex;
                    if !forward && Some(b) != vertex {
                        continue;
                    }
                    let other = film.vertices[if forward { b } else { a } as usize];
                    let cosine = (other - points[0]).normalize_or_zero().dot(along);
                    // The boundary edge is the edge along the segment; an interior edge runs both ways.
                    if cosine > best.0 + 1e-9 {
                        best = (cosine, forward);
                    }
                }
            }
            best.1
        })
        .collect()
}
