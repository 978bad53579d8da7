//! Whether two films pass through each other.

use crate::film::Film;
use crate::self_intersections::surfaces_cross;
use crate::{Execution, Interruption};

/// Whether an edge of one film pierces the inside of a triangle of the other ([`surfaces_cross`]).
///
/// # Errors
/// The interruptions of `exec`.
pub fn films_cross(first: &Film, second: &Film, exec: &Execution) -> Result<bool, Interruption> {
    surfaces_cross((&first.vertices, first.triangles()), (&second.vertices, second.triangles()), exec)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DVec3;
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
}
