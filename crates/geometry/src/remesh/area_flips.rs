//! Flips of edges that reduce the area of a surface.
//!
//! Where a film is folded onto itself, as beside a noisy boundary, Delaunay flips leave the folds: they never join two
//! triangles that face away from each other. A flip that reduces the area opens such a fold.

use crate::mesh::film::Film;
use crate::mesh::measure::{double_area_vector, is_degenerate};
use crate::mesh::topology::{next, previous};

/// A flip must reduce the area of its two triangles by more than this part, which is more than rounding.
const LEAST_PART: f64 = 1e-12;

/// Flips edges as long as that reduces the area. Returns the number of flips.
///
/// All edges are visited once, and afterwards only those around a flipped edge. It ends, because the area falls with
/// every flip.
pub(crate) fn flip_to_less_area(film: &mut Film) -> u64 {
    let count = film.topology.twin.len() as u32;
    let mut queue: Vec<u32> = (0..count).rev().filter(|&h| film.topology.twin[h as usize] > h).collect();
    let mut queued = vec![false; count as usize];
    queue.iter().for_each(|&h| queued[h as usize] = true);
    let mut flips = 0;
    while let Some(h) = queue.pop() {
        queued[h as usize] = false;
        if !reduces_area(film, h) || !film.topology.can_flip(h) {
            continue;
        }
        film.topology.flip(h);
        flips += 1;
        let twin = film.topology.twin[h as usize];
        for around in [next(h), previous(h), next(twin), previous(twin)] {
            let edge = around.min(film.topology.twin[around as usize]);
            if !queued[edge as usize] {
                queued[edge as usize] = true;
                queue.push(edge);
            }
        }
    }
    flips
}

/// Whether flipping the edge reduces the area and leaves no degenerate triangle. False for locked edges.
pub(crate) fn reduces_area(film: &Film, h: u32) -> bool {
    let Some(hinge) = film.topology.hinge(h) else { return false };
    let [p, q, r, s] = hinge.map(|v| film.vertices[v as usize]);
    let double_area = |corners| double_area_vector(corners).length();
    let before = double_area([p, q, r]) + double_area([q, p, s]);
    let after = double_area([s, r, p]) + double_area([r, s, q]);
    after < before * (1.0 - LEAST_PART)
        && !is_degenerate([s, r, p])
        && !is_degenerate([r, s, q])
        && !film.is_locked(hinge[0], hinge[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DVec3;

    /// A square of which one corner is folded over its diagonal.
    #[test]
    fn a_fold_is_opened_by_the_other_diagonal() {
        let vertices = [(0.0, 0.0), (1.0, 0.0), (0.8, 0.7), (0.5, 0.1)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
        // The triangle [0, 2, 3] lies on [0, 1, 2], turned over.
        let mut film = Film::new(vertices, &[[0, 1, 2], [0, 2, 3]], vec![vec![0, 1, 2, 3]]).unwrap();
        let area = |film: &Film| -> f64 {
            film.triangles().iter().map(|&t| 0.5 * double_area_vector(film.corners(t)).length()).sum()
        };
        let before = area(&film);
        assert_eq!(flip_to_less_area(&mut film), 1);
        assert!(area(&film) < 0.9 * before, "{} of {before}", area(&film));
        film.mesh().check().unwrap();
        assert_eq!(flip_to_less_area(&mut film), 0);
    }
}
