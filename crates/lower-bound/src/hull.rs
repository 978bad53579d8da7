//! Half-spaces that contain the boundary, and the test whether a tetrahedron lies outside one of them.
//!
//! The nearest-point projection onto a convex set lengthens no curve. If the boundary lies in the set, the projection
//! maps a surface to a surface in the set that has the same boundary and no more area. Therefore only surfaces in the
//! intersection of the half-spaces matter, and |curl A| <= 1 is needed only in the tetrahedra that meet it. The other
//! tetrahedra, 5 to 30% of all, are unconstrained: the curl may have any length there.

use plateau_mesh::execution::Interruption;
use plateau_mesh::{DVec3, Execution};
use std::f64::consts::PI;

/// Number of half-space directions that are spread evenly over the sphere, besides the axes and the normals of the
/// loops.
const DIRECTIONS: usize = 600;
/// Distance by which an unconstrained tetrahedron must lie outside a half-space, as a fraction of the boundary's size.
/// It is far above the rounding errors of differences of coordinates (which are rounded once), and far below the size
/// of the tetrahedra.
const MARGIN: f64 = 1e-6;
/// Rounding error of points and of their mirror images, in units of the last place of the largest coordinate. It is
/// added to the margin. For a small boundary far from the origin it exceeds the margin.
const ROUNDED: f64 = 8.0;

/// Number of scalar products of a direction and a point between two calls of [`Execution::look`], about a millisecond
/// of work.
const PRODUCTS_A_LOOK: usize = 400_000;

/// Half-spaces that contain closed polygons.
#[derive(Debug)]
pub(super) struct Hull {
    origin: DVec3,
    /// Distance by which an unconstrained tetrahedron must lie outside a half-space.
    pub margin: f64,
    /// The outward unit direction d and the limit of each half-space. A tetrahedron lies outside if d·(x - origin)
    /// exceeds the limit at each of its vertices x.
    half_spaces: Vec<(DVec3, f64)>,
}

impl Hull {
    /// Finds half-spaces that contain `loops`. `normals` are further directions in which the hull is probably flat. If
    /// there are planes of symmetry, `loops` must include the mirror images of the polygons. If a tetrahedron lies
    /// outside a half-space, its mirror images then lie outside the mirror images of that half-space.
    ///
    /// # Errors
    /// An interruption by the caller.
    pub fn around(loops: &[Vec<DVec3>], normals: &[DVec3], exec: &Execution) -> Result<Self, Interruption> {
        let origin = loops[0][0];
        let size = loops.iter().flatten().fold(0.0, |size: f64, &p| size.max((p - origin).length()));
        let reach = loops.iter().flatten().fold(0.0, |reach: f64, &p| reach.max(p.abs().max_element()));
        let margin = MARGIN * size + ROUNDED * f64::EPSILON * reach;
        let both = |normal: &DVec3| [normal.normalize_or_zero(), -normal.normalize_or_zero()];
        let flat = [DVec3::X, DVec3::Y, DVec3::Z];
        let flat = flat.iter().chain(normals).flat_map(both).filter(|&normal| normal != DVec3::ZERO);
        // Directions that are spread evenly over the sphere, along a spiral with the golden angle.
        let golden_angle = PI * (3.0 - 5f64.sqrt());
        let spread = (0..DIRECTIONS).map(|k| {
            let z = 1.0 - (2 * k + 1) as f64 / DIRECTIONS as f64;
            let (sine, cosine) = libm::sincos(golden_angle * k as f64);
            let radius = (1.0 - z * z).sqrt();
            DVec3::new(radius * cosine, radius * sine, z)
        });
        let reach = |&direction: &DVec3| {
            let product = |p: &DVec3| direction.dot(*p - origin);
            (direction, loops.iter().flatten().map(product).fold(f64::NEG_INFINITY, f64::max) + margin)
        };
        let directions: Vec<DVec3> = flat.chain(spread).collect();
        let count = loops.iter().map(Vec::len).sum::<usize>();
        let mut half_spaces = Vec::with_capacity(directions.len());
        for some in directions.chunks((PRODUCTS_A_LOOK / count).max(1)) {
            exec.look((some.len() * count) as u64)?;
            half_spaces.extend(some.iter().map(reach));
        }
        Ok(Self { origin, margin, half_spaces })
    }

    /// The number of a half-space outside which the whole tetrahedron lies, or `None`.
    pub fn separating(&self, corners: &[DVec3; 4]) -> Option<usize> {
        let corners = corners.map(|corner| corner - self.origin);
        let beyond = |&(direction, reach): &(DVec3, f64)| corners.iter().all(|x| direction.dot(*x) > reach);
        self.half_spaces.iter().position(beyond)
    }

    /// The directions of the half-spaces that have tetrahedra outside them, and these tetrahedra, each with the number
    /// of its direction.
    pub fn beyond(&self, tetrahedra: &[[DVec3; 4]]) -> (Vec<DVec3>, Vec<[u32; 2]>) {
        let (mut directions, mut pairs) = (Vec::new(), Vec::new());
        let mut numbers = vec![None; self.half_spaces.len()];
        for (k, corners) in tetrahedra.iter().enumerate() {
            if let Some(half_space) = self.separating(corners) {
                let number = *numbers[half_space].get_or_insert_with(|| {
                    directions.push(self.half_spaces[half_space].0);
                    directions.len() as u32 - 1
                });
                pairs.push([k as u32, number]);
            }
        }
        (directions, pairs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn points_of_a_small_boundary_far_away_lie_inside_although_they_are_rounded() {
        let (size, centre) = (2e-3, DVec3::new(1e7, -7e6, 3e6));
        let at = |k: u32| {
            let (sine, cosine) = libm::sincos(TAU * f64::from(k) / 24.0);
            centre + size * DVec3::new(cosine, sine, 0.3 * cosine * sine)
        };
        let boundary: Vec<DVec3> = (0..24).map(at).collect();
        let hull = Hull::around(std::slice::from_ref(&boundary), &[DVec3::Z], &Execution::default()).unwrap();
        let rounding = 4.0 * f64::EPSILON * 1e7;
        for &point in &boundary {
            for direction in [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|d| [d, -d]) {
                assert_eq!(hull.separating(&[point + rounding * direction; 4]), None, "{direction}");
            }
            let outside = point + 0.1 * (point - centre);
            assert!(hull.separating(&[outside; 4]).is_some());
        }
    }
}
