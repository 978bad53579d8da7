//! Edge flips that reduce the area of a surface.
//!
//! A flip that reduces the area opens a fold, where a film lies on itself, for example beside a noisy boundary.
//! Delaunay flips leave folds, because they never join two triangles that face away from each other.

use super::flips::flip_where;
use crate::film::Film;
use crate::measure::{double_area_vector, is_degenerate};
use crate::{Execution, Interruption};

/// Least reduction of the area by a flip, as a fraction of the products of the triangles' sides. An area is a cross
/// product, whose rounding error is a few 1e-16 of that product. For a sliver this error exceeds the area itself. If
/// the least reduction were proportional to the area, flips of slivers could undo each other for ever.
const LEAST_GAIN: f64 = 1e-12;

/// Flips edges as long as that reduces the area. Returns the number of flips.
///
/// # Errors
/// The interruption. The film is valid in that case too.
pub fn flip_to_less_area(film: &mut Film, exec: &Execution) -> Result<u64, Interruption> {
    flip_where(film, reduces_area, exec)
}

/// Whether flipping the edge reduces the area and leaves no degenerate triangle. False for locked edges.
pub fn reduces_area(film: &Film, h: u32) -> bool {
    let Some(hinge) = film.topology.hinge(h) else { return false };
    let [p, q, r, s] = hinge.map(|v| film.vertices[v as usize]);
    let double_area = |corners| double_area_vector(corners).length();
    let before = double_area([p, q, r]) + double_area([q, p, s]);
    let after = double_area([s, r, p]) + double_area([r, s, q]);
    // The sum of the products of side lengths that bound these areas.
    let products = p.distance(q) * (p.distance(r) + q.distance(s)) + r.distance(s) * (s.distance(p) + r.distance(q));
    before - after > LEAST_GAIN * products
        && !is_degenerate([s, r, p])
        && !is_degenerate([r, s, q])
        && !film.is_locked(hinge[0], hinge[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DVec3;
    use crate::measure;
    use crate::structured::{relax, shaken};

    /// In a plane no flip reduces the area. The triangles are a billion times longer than high, and rotated in space,
    /// so that their areas are known to seven digits only.
    #[test]
    fn rounding_of_slivers_is_no_gain() {
        let mut film = shaken(20, 0.3);
        relax(&mut film, 1);
        let (along, across) = (DVec3::new(0.6, 0.64, 0.48), DVec3::new(0.8, -0.48, -0.36));
        film.vertices.iter_mut().for_each(|point| *point = point.x * along + 1e-9 * point.y * across);
        assert_eq!(measure::flipped_triangles(&film.mesh()), 0);
        assert_eq!(flip_to_less_area(&mut film, &Execution::default()), Ok(0));
    }

    /// A square with one corner folded over its diagonal.
    #[test]
    fn a_fold_is_opened_by_the_other_diagonal() {
        let vertices = [(0.0, 0.0), (1.0, 0.0), (0.8, 0.7), (0.5, 0.1)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
        // The triangle [0, 2, 3] lies on the triangle [0, 1, 2] with the opposite orientation.
        let mut film = Film::new(vertices, &[[0, 1, 2], [0, 2, 3]], vec![vec![0, 1, 2, 3]]).unwrap();
        let area = |film: &Film| -> f64 {
            film.triangles().iter().map(|&t| 0.5 * double_area_vector(film.corners(t)).length()).sum()
        };
        let before = area(&film);
        assert_eq!(flip_to_less_area(&mut film, &Execution::default()), Ok(1));
        assert!(area(&film) < 0.9 * before, "{} of {before}", area(&film));
        film.mesh().check().unwrap();
        assert_eq!(flip_to_less_area(&mut film, &Execution::default()), Ok(0));
    }
}
