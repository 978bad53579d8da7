//! Whether two films pass through each other.

use crate::mesh::film::Film;
use crate::{DVec3, Execution, Interruption};

/// Whether a triangle's edge of one film pierces the inside of a triangle of the other.
///
/// Touching, and lying in one plane, do not count: two discs in a plane, one inside the other, do not cross. Decided
/// with exact predicates. Sweeps along x: O(n log n) and the pairs whose boxes meet. Looks every few thousand pairs.
///
/// # Errors
/// The interruptions of `exec`.
pub(crate) fn films_cross(first: &Film, second: &Film, exec: &Execution) -> Result<bool, Interruption> {
    let boxes = |film: &Film| {
        let mut boxes: Vec<(DVec3, DVec3, [DVec3; 3])> = film
            .triangles()
            .iter()
            .map(|&t| film.corners(t))
            .map(|corners @ [a, b, c]| (a.min(b).min(c), a.max(b).max(c), corners))
            .collect();
        boxes.sort_by(|a, b| a.0.x.total_cmp(&b.0.x));
        boxes
    };
    let (first, second) = (boxes(first), boxes(second));
    // How far along x the widest box reaches: what begins further back cannot meet a box.
    let widest = second.iter().map(|(low, high, _)| high.x - low.x).fold(0.0, f64::max);
    let mut work = 0;
    for (low, high, corners) in &first {
        let begin = second.partition_point(|other| other.0.x < low.x - widest);
        for (other_low, other_high, other) in second[begin..].iter().take_while(|other| other.0.x <= high.x) {
            work += 1;
            let meet = low.cmple(*other_high).all() && other_low.cmple(*high).all();
            if meet && (pierces(corners, other) || pierces(other, corners)) {
                return Ok(true);
            }
        }
        if work > 4096 {
            exec.look(work)?;
            work = 0;
        }
    }
    exec.look(work)?;
    Ok(false)
}

/// Whether an edge of `edges` runs through the inside of `triangle`.
fn pierces(edges: &[DVec3; 3], triangle: &[DVec3; 3]) -> bool {
    let [a, b, c] = *triangle;
    (0..3).any(|k| {
        let (p, q) = (edges[k], edges[(k + 1) % 3]);
        let (above, below) = (side(a, b, c, p), side(a, b, c, q));
        if above * below >= 0 {
            return false;
        }
        let turns = [side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)];
        turns.iter().all(|&turn| turn > 0) || turns.iter().all(|&turn| turn < 0)
    })
}

/// The sign of the volume of a, b, c, d.
fn side(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> i32 {
    let coord = |p: DVec3| robust::Coord3D { x: p.x, y: p.y, z: p.z };
    let volume = robust::orient3d(coord(a), coord(b), coord(c), coord(d));
    i32::from(volume > 0.0) - i32::from(volume < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::structured::{cylinder, patch};

    fn cross(a: &Film, b: &Film) -> bool {
        films_cross(a, b, &Execution::default()).unwrap()
    }

    #[test]
    fn a_disc_crosses_the_tube_that_it_is_wider_than_and_no_other() {
        let tube = cylinder(24, 6, 2.0);
        let square =
            |reach: f64, z: f64| patch(9, 9, |u, v| DVec3::new((2.0 * u - 1.0) * reach, (2.0 * v - 1.0) * reach, z));
        for (reach, z, expected) in [(2.0, 0.1, true), (0.5, 0.1, false), (2.0, 1.5, false), (0.9, 0.1, true)] {
            assert_eq!(cross(&tube, &square(reach, z)), expected, "{reach} {z}");
            assert_eq!(cross(&square(reach, z), &tube), expected, "{reach} {z}");
        }
    }

    #[test]
    fn films_in_one_plane_do_not_cross() {
        let square = |reach: f64| patch(5, 5, |u, v| DVec3::new((u - 0.5) * reach, (v - 0.5) * reach, 0.0));
        assert!(!cross(&square(1.0), &square(3.0)));
    }
}
