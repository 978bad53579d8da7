//! Self-intersections within large fans: many triangles around one vertex that may intersect each other.
//!
//! The boxes of a fan's triangles all meet at the common vertex, so that a tree of boxes would compare every pair. Each
//! triangle cuts an arc out of a small sphere around the vertex. Two triangles of a fan meet beyond the vertex if and
//! only if their arcs meet. A tree over the arcs therefore finds the pairs of triangles that must be compared.

use super::boxes::{Leaves, Order, Tree, Visits};
use super::soup::{NONE, Soup};
use crate::{DVec3, Execution, Interruption};
use std::ops::ControlFlow;

/// Smallest number of triangles around a vertex for which a tree of arcs is built. For fewer triangles, comparing all
/// pairs is as fast.
const LARGE: u32 = 64;
/// Triangles in a leaf of the tree.
const LEAF: usize = 4;
/// Largest distance by which rounding may move the ends of an arc on the unit sphere. The actual error is a few units
/// in the last place.
const MARGIN: f64 = 1e-14;
/// An arc counts as longer than 170 degrees if 1 plus the cosine of its angle is below this. The tangents at the ends
/// of a longer arc meet too far away, so that the box of the whole sphere takes the place of the arc's box.
const ALMOST_STRAIGHT: f64 = 0.015;

/// The large fans of a mesh.
pub(super) struct Fans {
    /// For each vertex, the number of its triangles if they form a large fan that is not settled as a star, and 0
    /// otherwise. Empty if the mesh has no such fan.
    sizes: Vec<u32>,
    /// The vertex of the fan and the number of the triangle, for each triangle of a large fan. Sorted by fan.
    members: Vec<(u32, u32)>,
}

/// Finds the large fans among the triangles of `list`, which must have an area. O(triangles).
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
    /// The vertex of the large fan to which a triangle belongs: the corner with the most triangles. [`NONE`] if no
    /// corner is the vertex of a large fan.
    pub fn of(&self, triangle: &[u32; 3]) -> u32 {
        if self.sizes.is_empty() {
            return NONE;
        }
        let most = triangle.iter().copied().max_by_key(|&v| (self.sizes[v as usize], std::cmp::Reverse(v)));
        most.filter(|&v| self.sizes[v as usize] > 0).unwrap_or(NONE)
    }

    /// Visits the pairs of triangles of each fan whose arcs may meet. Returns false if a fan needed more work than
    /// `most_work`.
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

/// A triangle that contains the arc which `triangle` cuts out of the unit sphere around its corner `centre`. Its
/// corners are the ends of the arc, and the point where the tangents at the ends meet.
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
