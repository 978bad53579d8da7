//! Large fans whose triangles may intersect each other: many triangles around one vertex.
//!
//! The boxes of these triangles all meet at the vertex, so that a tree of boxes would compare every pair. Two triangles
//! of a fan meet beyond its vertex if and only if the arcs meet that they cut out of a sphere around the vertex. A tree
//! over the arcs therefore finds the pairs that are to be compared.

use super::boxes::{Leaves, Order, Tree, Visits};
use super::soup::{NONE, Soup};
use crate::{DVec3, Execution, Interruption};
use std::ops::ControlFlow;

/// Smallest number of triangles around a vertex for which a tree of arcs is made. Comparing all pairs of fewer takes as
/// long.
const LARGE: u32 = 64;
/// Triangles in a leaf of the tree.
const LEAF: usize = 4;
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
    let member = |&t: &u32| (fans.of(&soup.triangles[t as usize]), t);
    fans.members = list.iter().map(member).filter(|member| member.0 != NONE).collect();
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

    /// Visits the pairs of triangles of each fan whose arcs may meet. False if more work than `most_work` was needed
    /// for a fan.
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

/// A triangle that holds the arc which a triangle cuts out of the unit sphere around one of its corners: the ends of
/// the arc, and the point where the tangents at the ends meet.
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
