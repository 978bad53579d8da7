//! Half-spaces that contain the boundary, and the tetrahedra that lie beyond one of them.
//!
//! The nearest-point projection onto a convex set lengthens no curve. It maps a surface to one in the convex set with
//! no more area, and leaves the boundary as it is if the boundary lies in the set. Therefore only surfaces in the
//! intersection of the half-spaces matter, and |curl A| <= 1 is needed only in the tetrahedra that meet it. The others
//! are 5 to 30% of all. They have no constraint, and the curl may have any length there.

use plateau_mesh::execution::Interruption;
use plateau_mesh::{DVec3, Execution};
use std::f64::consts::PI;

/// Number of directions that are spread evenly over the sphere, besides the axes and the normals of the loops.
const DIRECTIONS: usize = 600;
/// Distance by which a tetrahedron has to lie beyond a half-space, as a fraction of the boundary's size. It is far
/// above the rounding errors of differences (they are rounded once), and far below the size of tetrahedra.
const MARGIN: f64 = 1e-6;
/// Rounding error of points and of their mirror images, in units of the largest coordinate's last place. It is added to
/// the margin, and exceeds it where the boundary is small and far from the origin.
const ROUNDED: f64 = 8.0;

/// Number of products of a direction with a point between two looks at the caller's signal: about a millisecond of
/// work.
const PRODUCTS_A_LOOK: usize = 400_000;

/// Half-spaces around closed polygons.
#[derive(Debug)]
pub(super) struct Hull {
    origin: DVec3,
    /// Distance by which a tetrahedron has to lie beyond a half-space.
    pub margin: f64,
    /// Outward directions d of length 1, each with a number that d·(x - origin) exceeds at every vertex x of a
    /// tetrahedron beyond.
    half_spaces: Vec<(DVec3, f64)>,
}

impl Hull {
    /// Finds half-spaces around `loops`. `normals` are further directions in which the hull is probably flat. With
    /// planes of symmetry, `loops` must include the mirror images of the polygons. The mirror images of a tetrahedron
    /// beyond a half-space then lie beyond mirror images of that half-space.
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
        // Points of equal area on the sphere, along a spiral with the golden angle.
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

    /// The number of a half-space beyond which the whole tetrahedron lies.
    pub fn separating(&self, corners: &[DVec3; 4]) -> Option<usize> {
        let corners = corners.map(|corner| corner - self.origin);
        let beyond = |&(direction, reach): &(DVec3, f64)| corners.iter().all(|x| direction.dot(*x) > reach);
        self.half_spaces.iter().position(beyond)
    }

    /// The directions of the half-spaces that have tetrahedra beyond them, and these tetrahedra, each with the
    /// direction's number.
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
