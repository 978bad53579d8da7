//! Sets of boundaries, the films over them, and the order in which the boundaries are considered.

use crate::solved_film::SolvedFilm;
use plateau_mesh::edit::orient_along;
use plateau_mesh::film::Film;
use plateau_mesh::{DVec3, polyline};
use std::cmp::Ordering;

/// Lengths count as equal if they differ by less than this fraction of the radius of all boundaries. It is above
/// rounding.
const EQUAL_LENGTH: f64 = 1e-9;

/// Returns the indices of the boundaries, sorted by length, then by radius, then by the sum of the distances of their
/// mean from the means of all others. Motions, scaling and the order of the list do not change this order, except that
/// boundaries that are equal in all three keep the order of the list.
pub(super) fn order_of(boundaries: &[Vec<DVec3>]) -> Vec<usize> {
    let means: Vec<DVec3> = boundaries.iter().map(|points| polyline::mean(points)).collect();
    let size = polyline::radius(&boundaries.concat());
    let rounded = |length: f64| (length / (EQUAL_LENGTH * size)).round();
    let key = |k: usize| {
        let apart: f64 = means.iter().map(|mean| mean.distance(means[k])).sum();
        let inside = polyline::radius(&boundaries[k]);
        [polyline::length(&boundaries[k], true), inside, apart].map(rounded)
    };
    let mut order: Vec<usize> = (0..boundaries.len()).collect();
    order.sort_by(|&a, &b| {
        let pairs = key(a).into_iter().zip(key(b));
        pairs.fold(Ordering::Equal, |so_far, (a, b)| so_far.then(a.total_cmp(&b)))
    });
    order
}

/// The set of these boundaries as a number: bit k is set if boundary k belongs to it.
pub(super) fn set_of(boundaries: &[usize]) -> u32 {
    boundaries.iter().map(|&boundary| 1 << boundary).sum()
}

/// The boundaries of a set (see [`set_of`]), ascending.
pub(super) fn members(set: u32) -> Vec<usize> {
    (0..32).filter(|&boundary| set & (1 << boundary) != 0).collect()
}

/// Every partition of `count` boundaries into sets (see [`set_of`] for the numbers).
pub(super) fn partitions(count: usize) -> Vec<Vec<u32>> {
    let mut result = vec![Vec::new()];
    for boundary in 0..count {
        let bit = 1u32 << boundary;
        result = result
            .into_iter()
            .flat_map(|partition: Vec<u32>| {
                let joined = (0..partition.len()).map({
                    let partition = partition.clone();
                    move |k| {
                        let mut partition = partition.clone();
                        partition[k] |= bit;
                        partition
                    }
                });
                let alone = std::iter::once([partition, vec![bit]].concat());
                joined.chain(alone).collect::<Vec<_>>()
            })
            .collect();
    }
    result
}

/// Joins several films into one, and orients each along the first of its boundaries. The input points of the boundaries
/// come first, in input order, then the other vertices film by film. `None` if the films do not fit together.
pub(super) fn together(boundaries: &[Vec<DVec3>], films: &[(Vec<usize>, &SolvedFilm)]) -> Option<Film> {
    let mut first = Vec::with_capacity(boundaries.len());
    let mut count = 0u32;
    for boundary in boundaries {
        first.push(count);
        count += boundary.len() as u32;
    }
    let mut vertices: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
    let mut fixed = vec![true; vertices.len()];
    let (mut triangles, mut loops, mut locked) = (Vec::new(), vec![Vec::new(); boundaries.len()], Vec::new());
    for (set, part) in films {
        let film = &part.film;
        let own: usize = set.iter().map(|&k| boundaries[k].len()).sum();
        let mut renamed: Vec<u32> = set
            .iter()
            .flat_map(|&k| (0..boundaries[k].len() as u32).map(|i| i + first[k]).collect::<Vec<_>>())
            .collect();
        for v in own..film.vertices.len() {
            renamed.push(vertices.len() as u32);
            vertices.push(film.vertices[v]);
            fixed.push(film.fixed[v]);
        }
        for (&boundary, loop_) in set.iter().zip(&film.boundaries) {
            loops[boundary] = loop_.iter().map(|&v| renamed[v as usize]).collect();
        }
        let mut own: Vec<[u32; 3]> = film.triangles().iter().map(|t| t.map(|v| renamed[v as usize])).collect();
        orient_along(&mut own, &loops[*set.iter().min()?]);
        triangles.append(&mut own);
        locked.extend(film.locked.iter().map(|&[a, b]| {
            let (a, b) = (renamed[a as usize], renamed[b as usize]);
            [a.min(b), a.max(b)]
        }));
    }
    locked.sort_unstable();
    let mut film = Film::new(vertices, &triangles, loops)?;
    (film.fixed, film.locked) = (fixed, locked);
    Some(film)
}
