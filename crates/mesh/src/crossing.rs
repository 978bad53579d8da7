//! Tests whether two films pass through each other, and finds where a segment passes through a film.

use crate::film::Film;
use crate::self_intersections::{passes_through, surfaces_cross};
use crate::{DVec3, Execution, Interruption};

/// Whether an edge of one film pierces the inside of a triangle of the other ([`surfaces_cross`]).
///
/// # Errors
/// The interruptions of `exec`.
pub fn films_cross(first: &Film, second: &Film, exec: &Execution) -> Result<bool, Interruption> {
    surfaces_cross((&first.vertices, first.triangles()), (&second.vertices, second.triangles()), exec)
}

/// Number of triangles between two calls of [`Execution::look`].
const LOOK: usize = 1 << 16;

/// Returns the point where a segment passes from one side of a triangle to the other, for the first such triangle in
/// the list. A segment that ends on a triangle does not pass through it. Whether there is such a triangle is decided
/// exactly; the point is rounded.
///
/// # Errors
/// The interruptions of `exec`.
pub fn passage(
    [p, q]: [DVec3; 2],
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    exec: &Execution<'_>,
) -> Result<Option<DVec3>, Interruption> {
    let (low, high) = (p.min(q), p.max(q));
    for some in triangles.chunks(LOOK) {
        exec.look(some.len() as u64)?;
        for triangle in some {
            let corners @ [a, b, c] = triangle.map(|v| vertices[v as usize]);
            let apart = a.min(b).min(c).cmpgt(high).any() || a.max(b).max(c).cmplt(low).any();
            if apart || !passes_through([p, q], &corners) {
                continue;
            }
            let normal = (b - a).cross(c - a);
            let [before, after] = [p, q].map(|end| normal.dot(end - a).abs());
            return Ok(Some(p.lerp(q, before / (before + after).max(f64::MIN_POSITIVE))));
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structured::{cylinder, patch};

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

    #[test]
    fn a_segment_passes_through_the_inside_an_edge_and_a_corner_but_not_where_it_ends() {
        let square = patch(3, 3, |u, v| DVec3::new(u, v, 0.0));
        let place = |from: [f64; 3], to: [f64; 3]| {
            let ends = [DVec3::from(from), DVec3::from(to)];
            passage(ends, &square.vertices, square.triangles(), &Execution::default()).unwrap()
        };
        assert_eq!(place([0.3, 0.2, -1.0], [0.3, 0.2, 3.0]), Some(DVec3::new(0.3, 0.2, 0.0)));
        assert_eq!(place([0.5, 0.5, -1.0], [0.5, 0.5, 1.0]), Some(DVec3::new(0.5, 0.5, 0.0)));
        assert_eq!(place([0.5, 0.2, -1.0], [0.5, 0.2, 1.0]), Some(DVec3::new(0.5, 0.2, 0.0)));
        let none = [([0.3, 0.2, 0.0], [0.3, 0.2, 1.0]), ([1.2, 0.2, -1.0], [1.2, 0.2, 1.0])];
        assert!(none.into_iter().all(|(from, to)| place(from, to).is_none()));
        assert_eq!(place([-1.0, 0.3, 0.0], [2.0, 0.3, 0.0]), None, "within the plane");
    }
}
