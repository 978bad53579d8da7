//! Measures the angles at the junctions of a film, between facets and between forces.

use super::film::JunctionFilm;
use crate::junction_statistics::JunctionStatistics;
use plateau_equilibrium::energy::area::Facet;
use plateau_mesh::DVec3;
use plateau_mesh::complex::VertexKind;
use plateau_mesh::measure::Spread;
use plateau_mesh::topology::edge_key;

pub(super) const THIRD_OF_TURN: f64 = 2.0 * std::f64::consts::FRAC_PI_3;

/// Returns the three angles (radians) between neighbouring directions, seen along an axis. They add up to a full turn.
pub(super) fn angles_around(axis: DVec3, directions: [DVec3; 3]) -> [f64; 3] {
    let (u, v) = axis.any_orthonormal_pair();
    let mut at = directions.map(|direction| libm::atan2(direction.dot(v), direction.dot(u)));
    at.sort_by(f64::total_cmp);
    [at[1] - at[0], at[2] - at[1], at[0] - at[2] + std::f64::consts::TAU]
}

pub(super) fn junction_statistics(
    film: &JunctionFilm,
    residual: f64,
    morse_index: Option<usize>,
) -> JunctionStatistics {
    let (complex, junction_edges) = (&film.complex, film.complex.junctions());
    let mut facets = Vec::new();
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); film.vertices.len()];
    for (t, &triangle) in complex.triangles.iter().enumerate() {
        triangle.iter().for_each(|&v| around[v as usize].push(t));
        let corners = film.corners(triangle);
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            if junction_edges.binary_search(&edge_key([a, b])).is_ok() {
                let along = (corners[(k + 1) % 3] - corners[k]).normalize_or_zero();
                let inward = (corners[(k + 2) % 3] - corners[k]).reject_from(along).normalize_or_zero();
                facets.push((edge_key([a, b]), along, inward));
            }
        }
    }
    facets.sort_by_key(|facet| facet.0);
    let facet_angles: Vec<f64> = facets
        .chunk_by(|a, b| a.0 == b.0)
        .filter_map(|three| match three {
            [a, b, c] => Some(angles_around(a.1, [a.2, b.2, c.2])),
            _ => None,
        })
        .flatten()
        .collect();
    let at_vertices: Vec<(bool, [f64; 3])> = (0..film.vertices.len())
        .filter_map(|v| {
            let VertexKind::Junction(beside) = complex.kinds[v] else { return None };
            let inside = beside.iter().all(|&v| matches!(complex.kinds[v as usize], VertexKind::Junction(_)));
            Some((inside, angles_around(film.tangent(beside), sheet_forces(film, v as u32, beside, &around[v])?)))
        })
        .collect();
    let sheet_angles = || at_vertices.iter().flat_map(|(_, angles)| *angles);
    let departure = |angles: &[f64]| angles.iter().map(|angle| (angle - THIRD_OF_TURN).abs()).fold(0.0, f64::max);
    let departures =
        |inside: bool| at_vertices.iter().filter(move |vertex| vertex.0 == inside).map(|(_, angles)| departure(angles));
    let at_ends = departures(false).fold(0.0, f64::max);
    let away = departures(true).reduce(f64::max);
    // A junction of a single edge has no vertex inside. If all junctions are of this kind, the angles between facets
    // are measured instead.
    let (largest, mean) = if at_vertices.is_empty() {
        let mean = Spread::of(facet_angles.iter().map(|angle| (angle - THIRD_OF_TURN).abs())).mean;
        (departure(&facet_angles), mean)
    } else {
        (away.unwrap_or(at_ends), Spread::of(sheet_angles().map(|angle| (angle - THIRD_OF_TURN).abs())).mean)
    };
    let length = |&[a, b]: &[u32; 2]| film.vertices[a as usize].distance(film.vertices[b as usize]);
    JunctionStatistics {
        sheets: complex.sheets.len(),
        curves: complex.curves(),
        edges: junction_edges.len(),
        points: complex.kinds.iter().filter(|kind| **kind == VertexKind::Point).count(),
        length: junction_edges.iter().map(length).sum(),
        residual,
        largest_deviation: largest,
        largest_deviation_at_ends: at_ends,
        mean_deviation: mean,
        facet_angles: Spread::of(facet_angles.into_iter()),
        sheet_angles: Spread::of(sheet_angles()),
        morse_index,
    }
}

/// Returns the forces (minus the area gradients) of the three sheets at a vertex inside a junction. The force of a
/// sheet is the sum over its fan of triangles from one junction edge to the other. Returns `None` if the triangles at
/// the vertex do not form three fans of this kind.
fn sheet_forces(film: &JunctionFilm, v: u32, [before, after]: [u32; 2], around: &[usize]) -> Option<[DVec3; 3]> {
    let triangles = &film.complex.triangles;
    let mut forces = Vec::new();
    for &start in around.iter().filter(|&&t| triangles[t].contains(&before)) {
        let (mut force, mut t, mut spoke) = (DVec3::ZERO, start, before);
        // The number of passes is bounded, because a fan contains each triangle at most once.
        for _ in around {
            let triangle = triangles[t];
            let k = triangle.iter().position(|&corner| corner == v)?;
            force -= Facet::of(&film.vertices, &triangle).gradient(k);
            spoke = *triangle.iter().find(|&&corner| corner != v && corner != spoke)?;
            if spoke == after {
                break;
            }
            // The next triangle of the fan is the other triangle at the spoke.
            t = *around.iter().find(|&&u| u != t && triangles[u].contains(&spoke))?;
        }
        if spoke != after {
            return None;
        }
        forces.push(force);
    }
    <[DVec3; 3]>::try_from(forces).ok()
}
