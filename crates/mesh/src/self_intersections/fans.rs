//! Large fans whose triangles may intersect each other: many triangles around one vertex.
//!
//! The boxes of these triangles all meet at the vertex, so that a tree of boxes would compare every pair. Two triangles
//! of a fan meet beyond its vertex if and only if the arcs meet that they cut out of a sphere around the vertex. A tree
//! over the arcs therefore finds the pairs that are to be compared.

use super::LEAF;
use super::boxes::{Leaves, Order, Tree, Visits};
use super::soup::{NONE, Soup};
use crate::{DVec3, Execution, Interruption};
use std::ops::ControlFlow;

/// Smallest number of triangles around a vertex for which a tree of arcs is made. Comparing all pairs of fewer takes as
/// long.
const LARGE: u32 = 64;
/// How far rounding may move the ends of an arc on the unit sphere. They are off by a few units in the last place.
const MARGIN: f64 = 1e-14;
/// An arc is longer than 170 degrees if 1 + the cosine of its angle is below this. The tangents at its ends then meet
/// too far away, and it counts as a whole sphere.
const ALMOST_STRAIGHT: f64 = 0.015;

/// The large fans of a mesh.
pub(super) struct Fans {
    /// For each vertex the number of its triangles if they are a large fan that is not settled as a star, else 0.
    /// Empty without a fan.
    sizes: Vec<u32>,
    /// Each triangle with the vertex of its fan, fan by fan.
    members: Vec<(u32, u32)>,
}

/// Finds the fans among triangles with an area. O(triangles).
pub(super) fn large(soup: &Soup, list: &[u32], stars: &[u32]) -> Fans {
    let mut sizes = vec![0; soup.points.len()];
    list.iter().flat_map(|&t| soup.triangles[t as usize]).for_each(|v| sizes[v as usize] += 1);
    let mut any = false;
    for (size, &star) in sizes.iter_mut().zip(stars) {
        if *size < LARGE || star > 0 {
            *size = 0;
        }
        any |= *size > 0;
    }
    if !any {
        return Fans { sizes: Vec::new(), members: Vec::new() };
    }
    let mut fans = Fans { sizes, members: Vec::new() };
    let of = |&t: &u32| (fans.of(&soup.triangles[t as usize]), t);
    fans.members = list.iter().map(of).filter(|member| member.0 != NONE).collect();
    fans.members.sort_unstable();
    fans
}

impl Fans {
    /// The vertex of the fan to which a triangle belongs: the corner with the most triangles. [`NONE`] for the others.
    pub fn of(&self, triangle: &[u32; 3]) -> u32 {
        if self.sizes.is_empty() {
            return NONE;
        }
        let most = triangle.iter().copied().max_by_key(|&v| (self.sizes[v as usize], std::cmp::Reverse(v)));
        most.filter(|&v| self.sizes[v as usize] > 0).unwrap_or(NONE)
    }

    /// Visits the pairs of triangles of each fan whose arcs may meet. False if more work than `most_work` was needed for
    /// a fan.
    ///
    /// # Errors
    /// The interruptions of `exec`.
    pub fn visit_pairs(
        &self,
        soup: &Soup,
        order: Order,
        most_work: u64,
        mut visit: impl FnMut(u32, u32) -> ControlFlow<()>,
        exec: &Execution<'_>,
    ) -> Result<bool, Interruption> {
        for fan in self.members.chunk_by(|a, b| a.0 == b.0) {
            let centre = fan[0].0;
            let triangles = fan.iter().map(|member| member.1).collect();
            let leaves = Leaves { triangles, order, size: LEAF, margin: MARGIN, visits: Visits::Pairs };
            let tree = Tree::new(leaves, |t| hull_of_arc(soup, soup.triangles[t as usize], centre), exec)?;
            if !tree.visit_pairs(most_work, |_, _| false, &mut visit, exec)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// A triangle that holds the arc which a triangle cuts out of the unit sphere around one of its corners: the ends of the
/// arc, and the point where the tangents at the ends meet.
fn hull_of_arc(soup: &Soup, triangle: [u32; 3], centre: u32) -> [DVec3; 3] {
    let from = soup.points[centre as usize];
    let k = triangle.iter().position(|&v| v == centre).unwrap_or(0);
    let [a, b] = [1, 2].map(|step| (soup.points[triangle[(k + step) % 3] as usize] - from).normalize());
    let cosine = a.dot(b);
    if 1.0 + cosine < ALMOST_STRAIGHT {
        return [DVec3::splat(-1.0), DVec3::ONE, a];
    }
    [a, b, (a + b) / (1.0 + cosine)]
}

#[cfg(test)]
mod tests {
    use super::super::{intersections_among, meet};
    use super::*;
    use crate::random::SplitMix64;
    use std::f64::consts::TAU;

    /// A fan around a point off the origin, whose rim is a curve that may cross itself as seen from there. A coarse grid
    /// makes some of it touch.
    fn fan(random: &mut SplitMix64, count: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let mut any = |low: f64, high: f64| random.between(low, high);
        let waves = [1.0, 2.0, 3.0].map(|k: f64| (k, [0; 4].map(|_| any(-2.0, 2.0) / k)));
        let (turns, grid, noise) = (any(0.3, 2.5), any(-0.05, 0.1), any(-0.1, 0.1).max(0.0));
        let apex = DVec3::new(any(-1.0, 1.0), any(-1.0, 1.0), any(-1.0, 1.0));
        let mut vertices = vec![apex];
        for k in 0..=count {
            let t = turns * TAU * f64::from(k) / f64::from(count);
            let sum = |which: usize| waves.iter().map(|(k, a)| a[which] * libm::sin(k * t + a[3])).sum::<f64>();
            let point = apex + DVec3::new(sum(0), sum(1), 0.5 + sum(2)) + DVec3::splat(any(-noise, noise));
            vertices.push(if grid > 0.0 { (point / grid).round() * grid } else { point });
        }
        (vertices, (1..=count).map(|k| [0, k, k + 1]).collect())
    }

    #[test]
    fn the_arcs_of_a_fan_find_the_pairs_that_a_comparison_of_all_finds() {
        let mut random = SplitMix64::new(45);
        let (mut crossing, mut searched) = (0, 0);
        for case in 0..300 {
            let (vertices, triangles) = fan(&mut random, 64 + case % 60);
            let exec = Execution::default();
            let soup = Soup::new(&vertices, &triangles, &exec).unwrap();
            let list = soup.with_area();
            let stars = soup.embedded_stars(&list, &exec).unwrap();
            searched += usize::from(!large(&soup, &list, &stars).members.is_empty());
            let mut expected = 0;
            for (k, &one) in list.iter().enumerate() {
                for &other in &list[k + 1..] {
                    let [one, other] = [one, other].map(|t| soup.triangles[t as usize]);
                    expected += u64::from(meet(&soup, one, other, &stars).is_some());
                }
            }
            let found = intersections_among(&vertices, &triangles, Order::AsGiven, u64::MAX, &exec).unwrap();
            assert_eq!(found.pairs, expected, "case {case}");
            crossing += usize::from(expected > 0);
        }
        // Many fans are no stars, some of them cross themselves and others do not.
        assert!(searched > 100 && (50..290).contains(&crossing), "{searched} searched, {crossing} crossing");
    }

    /// A cone over a waved circle seen from beside it: no star, and nothing crosses.
    #[test]
    fn a_large_fan_takes_little_work() {
        let count = 7_500;
        let rim = (0..=count).map(|k| {
            let (sine, cosine) = libm::sincos(TAU * f64::from(k) / f64::from(count) * 0.999);
            DVec3::new(cosine, sine, 0.1 * libm::sin(40.0 * f64::from(k) / f64::from(count)) - 0.2)
        });
        let vertices: Vec<DVec3> = std::iter::once(DVec3::ZERO).chain(rim).collect();
        let triangles: Vec<[u32; 3]> = (1..=count).map(|k| [0, k, k + 1]).collect();
        let exec = Execution::default();
        let found = intersections_among(&vertices, &triangles, Order::AsGiven, u64::MAX, &exec).unwrap();
        assert_eq!(found.pairs, 0);
        assert!(exec.work() < 100 * u64::from(count), "{}", exec.work());
    }
}
