//! Self-intersections: pairs of triangles that meet in more than the vertices and the edge that they share.
//!
//! Two triangles *intersect* if their closed sets have a point in common that is not part of a shared vertex or edge:
//! they cross, touch, or overlap in one plane. Vertices with equal coordinates count as one vertex, and triangles
//! without area are left out (their neighbours cover them). All decisions are exact: they use the adaptive predicates
//! of `robust`.
//!
//! Most triangles are settled by `charts`: large parts of a surface that all face one direction provably do not
//! intersect themselves. The other triangles are searched pair by pair.
//!
//! A bounding-volume hierarchy finds the pairs that may intersect: axis-aligned boxes first, then boxes along each
//! node's own normal and longest edge (S. Gottschalk, M. C. Lin, D. Manocha, *OBBTree*, SIGGRAPH 1996), which keep long
//! thin triangles apart. The triangles around one vertex meet there, and are most of the pairs whose boxes meet. They
//! are settled together: if all of them face one direction and wind round the vertex at most once, their projection
//! along that direction is one-to-one, and no two of them intersect.
//!
//! O(n log n) time for meshes whose triangles do not pile up, O(n) memory, deterministic.

#![warn(missing_docs)]

mod boxes;
mod charts;
mod predicates;
mod soup;

use crate::error::Warning;
use crate::{DVec3, Execution, Interruption, Mesh};
pub use boxes::Order;
use boxes::{Leaves, Tree, Visits};
use predicates::{meet_apart, overlap_beside_edge, pierces, segment_meets_triangle};
use soup::{NONE, Soup};
use std::ops::ControlFlow;

/// Triangles in a leaf of the tree. Any value from 2 to 8 takes about the same time; a larger one needs less memory.
const LEAF: usize = 4;
/// Triangles that are suspects, or not, together. A larger value needs less time for the tree, and has more pairs of
/// leaves that bend too much for a chart: 16 to 64 take about the same time.
const COARSE_LEAF: usize = 32;

/// Smallest number of triangles for which charts are sought. The leaves of smaller meshes bend too much for a chart, so
/// that most triangles would be searched pair by pair all the same.
const LEAST_CHARTED: usize = 8_000;

/// Pairs of boxes, for each triangle, after which [`check`] gives up. Meshes that are embedded or cross themselves
/// along curves take 10 to 60; only sheets that lie on each other in many layers take more.
const WORK_PER_TRIANGLE: u64 = 2000;
/// Pairs of boxes that a check may look at whatever the size of the mesh.
const LEAST_WORK: u64 = 1 << 20;

/// What is reported about the self-intersections of a mesh that leaves a solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelfIntersectionCheck {
    /// Number of pairs of triangles that intersect; `None` if not all pairs were looked at.
    pub pairs: Option<u64>,
    /// Why not.
    pub skipped: Option<Skipped>,
}

/// Why a mesh was not checked for self-intersections, or not to the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Skipped {
    /// It has more triangles than are checked.
    TooManyTriangles,
    /// So many triangles lie on each other that the pairs are too many to look at.
    TooManyPairs,
    /// The deadline passed while the mesh was checked.
    DeadlinePassed,
}

impl Skipped {
    /// A stable name in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::TooManyTriangles => "too_many_triangles",
            Self::TooManyPairs => "too_many_pairs",
            Self::DeadlinePassed => "deadline_passed",
        }
    }
}

/// Checks a mesh that leaves a solver. The warning `self_intersections` says how many pairs of triangles intersect, and
/// where.
///
/// # Errors
/// [`Interruption::Cancelled`]. A deadline that passes ends the check, and the mesh is still good.
pub fn check(
    mesh: &Mesh,
    order: Order,
    most_triangles: usize,
    exec: &Execution<'_>,
) -> Result<(SelfIntersectionCheck, Option<Warning>), Interruption> {
    let skipped = |why| (SelfIntersectionCheck { pairs: None, skipped: Some(why) }, None);
    if mesh.triangles.len() > most_triangles {
        return Ok(skipped(Skipped::TooManyTriangles));
    }
    let most_work = LEAST_WORK + WORK_PER_TRIANGLE * mesh.triangles.len() as u64;
    let found = match self_intersections(&mesh.vertices, &mesh.triangles, order, most_work, exec) {
        Err(Interruption::DeadlinePassed) => return Ok(skipped(Skipped::DeadlinePassed)),
        found => found?,
    };
    let warning = found.place.map(|place| {
        let least = if found.complete { "" } else { "at least " };
        let detail = format!(
            "{least}{} pairs of triangles cross or touch each other beyond the vertices and edges that they share, \
             for example at ({}, {}, {})",
            found.pairs, place.x, place.y, place.z
        );
        Warning::new("self_intersections", detail)
    });
    let check = SelfIntersectionCheck {
        pairs: found.complete.then_some(found.pairs),
        skipped: (!found.complete).then_some(Skipped::TooManyPairs),
    };
    Ok((check, warning))
}

/// What a search for self-intersections found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SelfIntersections {
    /// Number of pairs of triangles that intersect.
    pub pairs: u64,
    /// False if the search used up its work before it had seen all pairs. Then `pairs` is a lower bound.
    pub complete: bool,
    /// A point where two triangles meet: those with the lowest numbers among the pairs seen.
    pub place: Option<DVec3>,
}

/// Finds all self-intersections of a triangle mesh, or gives up after `most_work` pairs of boxes.
///
/// # Errors
/// The interruptions of `exec`.
///
/// # Panics
/// If a triangle names a vertex that does not exist.
pub fn self_intersections(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    order: Order,
    most_work: u64,
    exec: &Execution<'_>,
) -> Result<SelfIntersections, Interruption> {
    let soup = Soup::new(vertices, triangles, exec)?;
    let mut list = soup.with_area();
    if list.len() >= LEAST_CHARTED {
        list = charts::suspects(&soup, list, order, COARSE_LEAF, exec)?;
    }
    intersections_among(&soup, list, order, most_work, exec)
}

/// Finds the intersections of some triangles with each other.
fn intersections_among(
    soup: &Soup,
    list: Vec<u32>,
    order: Order,
    most_work: u64,
    exec: &Execution<'_>,
) -> Result<SelfIntersections, Interruption> {
    let mut found = SelfIntersections { complete: true, ..SelfIntersections::default() };
    if list.is_empty() {
        return Ok(found);
    }
    let stars = soup.embedded_stars(&list, exec)?;
    let leaves = Leaves { triangles: list, order, size: LEAF, margin: 0.0, visits: Visits::Pairs };
    let tree = Tree::new(leaves, |t| soup.corners(soup.triangles[t as usize]), exec)?;
    let labels = tree.labels(|t| largest_star(&soup.triangles[t as usize], &stars));
    let same_star = |a: usize, b: usize| labels[a] != NONE && labels[a] == labels[b];
    let mut first = [NONE; 2];
    let visit = |a: u32, b: u32| {
        // In the order of their numbers, so that the place depends on the pair alone.
        let pair = [a.min(b), a.max(b)];
        let [one, other] = pair.map(|t| soup.triangles[t as usize]);
        if let Some(point) = meet(soup, one, other, &stars) {
            found.pairs += 1;
            if pair < first {
                first = pair;
                found.place = Some(point);
            }
        }
        ControlFlow::Continue(())
    };
    found.complete = tree.visit_pairs(most_work, same_star, visit, exec)?;
    found.place = found.place.map(|place| place * soup.unit);
    Ok(found)
}

/// Whether two surfaces pass through each other: an edge of one pierces the inside of a triangle of the other.
///
/// Unlike [`self_intersections`], touching and lying in one plane do not count: two discs in a plane, one inside the
/// other, do not cross.
///
/// # Errors
/// The interruptions of `exec`.
///
/// # Panics
/// If a triangle names a vertex that does not exist.
pub fn surfaces_cross(
    first: (&[DVec3], &[[u32; 3]]),
    second: (&[DVec3], &[[u32; 3]]),
    exec: &Execution<'_>,
) -> Result<bool, Interruption> {
    let offset = first.0.len() as u32;
    let vertices: Vec<DVec3> = first.0.iter().chain(second.0).copied().collect();
    let moved = second.1.iter().map(|triangle| triangle.map(|v| v + offset));
    let triangles: Vec<[u32; 3]> = first.1.iter().copied().chain(moved).collect();
    let soup = Soup::new(&vertices, &triangles, exec)?;
    // Every triangle and every node has the number of its surface; a node with triangles of both has none.
    let surface = |t: u32| u32::from(t as usize >= first.1.len());
    let triangles = soup.with_area();
    let leaves = Leaves { triangles, order: Order::Spatial, size: LEAF, margin: 0.0, visits: Visits::Pairs };
    let tree = Tree::new(leaves, |t| soup.corners(soup.triangles[t as usize]), exec)?;
    let labels = tree.labels(surface);
    let same_surface = |a: usize, b: usize| labels[a] != NONE && labels[a] == labels[b];
    let mut cross = false;
    let visit = |a: u32, b: u32| {
        let [one, other] = [a, b].map(|t| soup.corners(soup.triangles[t as usize]));
        if surface(a) != surface(b) && (pierces(&one, &other) || pierces(&other, &one)) {
            cross = true;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    };
    tree.visit_pairs(u64::MAX, same_surface, visit, exec)?;
    Ok(cross)
}

/// A point where two triangles meet beyond what they share.
fn meet(soup: &Soup, one: [u32; 3], other: [u32; 3], stars: &[u32]) -> Option<DVec3> {
    let mut shared = [(0, 0); 3];
    let mut count = 0;
    for (i, &v) in one.iter().enumerate() {
        for (j, &w) in other.iter().enumerate() {
            if v == w {
                if stars[v as usize] > 0 {
                    return None;
                }
                shared[count] = (i, j);
                count += 1;
            }
        }
    }
    let (a, b) = (soup.corners(one), soup.corners(other));
    match count {
        0 => meet_apart(&a, &b),
        1 => {
            // What meets beyond the shared vertex reaches the edge opposite it, in one of the triangles.
            let (i, j) = shared[0];
            segment_meets_triangle(a[(i + 1) % 3], a[(i + 2) % 3], &b)
                .or_else(|| segment_meets_triangle(b[(j + 1) % 3], b[(j + 2) % 3], &a))
        }
        2 => {
            let ([(i, j), (k, l), _], sum) = (shared, 3);
            let (third, fourth) = (a[sum - i - k], b[sum - j - l]);
            overlap_beside_edge(a[i], a[k], third, fourth)
        }
        _ => Some((a[0] + a[1] + a[2]) / 3.0),
    }
}

/// The corner with the most triangles among those whose triangles cannot intersect, or [`NONE`]. All triangles of a
/// large fan name its centre, so that the fan is settled as a whole.
fn largest_star(triangle: &[u32; 3], stars: &[u32]) -> u32 {
    let most = triangle.iter().copied().max_by_key(|&v| (stars[v as usize], std::cmp::Reverse(v)));
    most.filter(|&v| stars[v as usize] > 0).unwrap_or(NONE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::SplitMix64;

    /// A net over a curve that may cross itself, with holes, noise, and vertices moved onto others. A coarse grid of
    /// coordinates makes much of it touch.
    fn net(random: &mut SplitMix64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let (m, n) = (8 + random.below(40) as u32, 2 + random.below(8) as u32);
        let mut any = |low: f64, high: f64| random.between(low, high);
        let waves =
            [1.0, 2.0, 3.0].map(|k: f64| [k, any(-4.0, 4.0) / (k * k), any(-4.0, 4.0) / (k * k), any(0.0, 6.0)]);
        let (noise, holes, grid, twist) = (any(-0.5, 0.5).max(0.0), any(-0.1, 0.3), any(-0.3, 0.5), any(-0.5, 0.5));
        let mut vertices = Vec::new();
        for i in 0..m {
            for j in 0..n {
                let (t, v) = (6.0 * f64::from(i) / f64::from(m), f64::from(j));
                let sum = |which: usize| waves.iter().map(|w| w[which] * (w[0] * t + w[3]).sin()).sum::<f64>();
                let point = DVec3::new(sum(1) + twist * v, v + any(-noise, noise), sum(2) + any(-noise, noise));
                vertices.push(if grid > 0.0 { (point / grid).round() * grid } else { point });
            }
        }
        let mut triangles = Vec::new();
        for i in 0..m - 1 {
            for j in 0..n - 1 {
                let [a, b, c, d] = [i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1];
                triangles.extend([[a, b, c], [a, c, d]].into_iter().filter(|_| any(0.0, 1.0) > holes));
            }
        }
        if any(0.0, 1.0) < 0.3 {
            // A vertex is shared by parts of the net that are far from each other.
            let [one, other] = [0, 0].map(|_: u32| any(0.0, vertices.len() as f64) as u32);
            triangles.iter_mut().flatten().filter(|v| **v == one).for_each(|v| *v = other);
        }
        (vertices, triangles)
    }

    #[test]
    fn charts_leave_out_no_triangle_that_intersects_another() {
        let mut random = SplitMix64::new(16);
        let exec = Execution::default();
        let (mut all, mut suspected, mut crossing) = (0, 0, 0);
        for case in 0..3000 {
            let (vertices, triangles) = net(&mut random);
            let soup = Soup::new(&vertices, &triangles, &exec).unwrap();
            let list = soup.with_area();
            let suspects = charts::suspects(&soup, list.clone(), Order::Spatial, 1 + case % 4, &exec).unwrap();
            all += list.len();
            suspected += suspects.len();
            let among = |list| intersections_among(&soup, list, Order::Spatial, u64::MAX, &exec).unwrap();
            let expected = among(list);
            assert_eq!(among(suspects), expected, "case {case}: {vertices:?} {triangles:?}");
            crossing += usize::from(expected.pairs > 0);
        }
        // Both kinds of mesh are frequent, and the charts settle a part of them.
        assert!((300..2900).contains(&crossing), "{crossing}");
        assert!(suspected + 30_000 < all, "{suspected} of {all}");
    }

    /// A ramp of one and a half turns, seen from above: its boundary is one polygon, which crosses itself.
    #[test]
    fn a_part_whose_boundary_crosses_itself_is_no_chart() {
        let (m, n) = (120u32, 4u32);
        let exec = Execution::default();
        for (slope, crosses) in [(0.05, false), (0.0, true)] {
            let mut vertices = Vec::new();
            for i in 0..=m {
                for j in 0..=n {
                    let angle = 9.4 * f64::from(i) / f64::from(m);
                    let (y, x) = angle.sin_cos();
                    let radius = 1.0 + f64::from(j) / f64::from(n);
                    vertices.push(DVec3::new(radius * x, radius * y, slope * angle + 0.1 * (0.5 * angle - 0.5).sin()));
                }
            }
            let mut triangles = Vec::new();
            for i in 0..m {
                for j in 0..n {
                    let at = |i: u32, j: u32| i * (n + 1) + j;
                    triangles.extend([
                        [at(i, j), at(i, j + 1), at(i + 1, j + 1)],
                        [at(i, j), at(i + 1, j + 1), at(i + 1, j)],
                    ]);
                }
            }
            let soup = Soup::new(&vertices, &triangles, &exec).unwrap();
            let list = soup.with_area();
            let suspects = charts::suspects(&soup, list.clone(), Order::Spatial, 8, &exec).unwrap();
            let among = |list| intersections_among(&soup, list, Order::Spatial, u64::MAX, &exec).unwrap();
            let expected = among(list);
            assert_eq!(expected.pairs > 0, crosses, "{slope}");
            assert_eq!(among(suspects), expected, "{slope}");
        }
    }
}
