//! Self-intersections: pairs of triangles that meet in more than the vertices and the edge that they share.
//!
//! Two triangles *intersect* if their closed sets have a point in common that is not part of a shared vertex or edge:
//! they cross, touch, or overlap in one plane. Vertices with equal coordinates count as one vertex, and triangles
//! without area are left out (their neighbours cover them). All decisions are exact: they use the adaptive predicates
//! of `robust`.
//!
//! `charts` first settles most triangles: large parts of a surface that all face one direction provably do not
//! intersect themselves. The remaining triangles, the suspects, are searched pair by pair.
//!
//! A bounding-volume hierarchy finds the pairs that may intersect. Each node has an axis-aligned box, and an oriented
//! box along its own normal and longest edge (S. Gottschalk, M. C. Lin, D. Manocha, *OBBTree*, SIGGRAPH 1996), which
//! separates long thin triangles. Most pairs whose boxes meet are pairs of triangles around one vertex. These triangles
//! are settled together: if all of them face one direction and wind round the vertex at most once, their projection
//! along that direction is one-to-one, and no two of them intersect. A large fan that is not settled in this way is
//! searched by the arcs that its triangles cut out of a sphere around the common vertex (`fans`). The triangles' boxes
//! all meet at that vertex, but most of their arcs do not meet.
//!
//! O(n log n) time for meshes whose triangles do not pile up, O(n) memory, deterministic.

#![warn(missing_docs)]

mod boxes;
mod charts;
mod fans;
mod patches;
mod predicates;
mod soup;

use crate::codes::WarningCode;
use crate::error::Warning;
use crate::{DVec3, Execution, Interruption, Mesh};
pub use boxes::Order;
use boxes::{Leaves, Tree, Visits};
pub(crate) use predicates::passes_through;
use predicates::{meet_apart, overlap_beside_edge, pierces, segment_meets_triangle};
use soup::{NONE, Soup};
use std::ops::ControlFlow;

/// Triangles in a leaf of the tree. Any value from 2 to 8 takes about the same time; a larger one needs less memory.
const LEAF: usize = 4;
/// Largest number of triangles of a patch. The triangles of a patch are suspects all together or not at all. Two
/// regular subdivisions of a triangle make 16 triangles.
const PATCH: usize = 16;

/// Smallest number of triangles for which charts are sought. Smaller meshes are searched as fast without charts. At
/// 4,000 triangles charts save 10 to 45% of the time.
const LEAST_CHARTED: usize = 2_500;

/// Number of pairs of boxes per triangle after which [`check`] gives up. Meshes that are embedded or cross themselves
/// along curves take 10 to 60. Only sheets that lie on each other in many layers take more.
const WORK_PER_TRIANGLE: u64 = 2000;
/// Number of pairs of boxes that a check may compare in addition, whatever the size of the mesh.
const LEAST_WORK: u64 = 1 << 20;

/// The result of checking a solver's mesh for self-intersections.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelfIntersectionCheck {
    /// Number of pairs of triangles that intersect. `None` if not all pairs were compared.
    pub pairs: Option<u64>,
    /// Why not all pairs were compared. `None` if all were.
    pub skipped: Option<Skipped>,
}

/// Why a check for self-intersections was not started or not completed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Skipped {
    /// The mesh has more triangles than the limit for this check.
    TooManyTriangles,
    /// The search was given up: too many pairs of triangles lie on each other.
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

/// Checks a solver's mesh for self-intersections. If there are any, the warning `self_intersections` states the number
/// of pairs of triangles that intersect, and the place of one of them.
///
/// # Errors
/// [`Interruption::Cancelled`]. If the deadline passes, the check ends without an error, because the mesh itself is
/// still good.
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
        Warning::new(WarningCode::SelfIntersections, detail)
            .with("pairs", found.pairs as f64)
            .with_place(place.to_array())
    });
    let check = SelfIntersectionCheck {
        pairs: found.complete.then_some(found.pairs),
        skipped: (!found.complete).then_some(Skipped::TooManyPairs),
    };
    Ok((check, warning))
}

/// The result of a search for self-intersections.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SelfIntersections {
    /// Number of pairs of triangles that intersect.
    pub pairs: u64,
    /// False if the search reached its limit of work before it had compared all pairs. Then `pairs` is a lower bound.
    pub complete: bool,
    /// A point where two triangles meet. Among the pairs found, this is the pair with the lowest numbers.
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
    if triangles.len() < LEAST_CHARTED {
        return intersections_among(vertices, triangles, order, most_work, exec);
    }
    let suspects = charts::suspects(vertices, triangles, order, PATCH, exec)?;
    let suspects: Vec<[u32; 3]> = suspects.into_iter().map(|t| triangles[t as usize]).collect();
    intersections_among(vertices, &suspects, order, most_work, exec)
}

/// Finds all intersections between the given triangles, pair by pair, without charts.
fn intersections_among(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    order: Order,
    most_work: u64,
    exec: &Execution<'_>,
) -> Result<SelfIntersections, Interruption> {
    let mut found = SelfIntersections { complete: true, ..SelfIntersections::default() };
    if triangles.is_empty() {
        return Ok(found);
    }
    let soup = &Soup::new(vertices, triangles, exec)?;
    let list = soup.with_area();
    if list.is_empty() {
        return Ok(found);
    }
    let stars = soup.embedded_stars(&list, exec)?;
    let fans = fans::large(soup, &list, &stars);
    let leaves = Leaves { triangles: list, order, size: LEAF, margin: 0.0, visits: Visits::Pairs };
    let tree = Tree::new(leaves, |t| soup.corners(soup.triangles[t as usize]), exec)?;
    // Pairs with the same label need no comparison here: their star settles them, or they are compared as a fan below.
    let labels = tree.labels(|t| match fans.of(&soup.triangles[t as usize]) {
        NONE => largest_star(&soup.triangles[t as usize], &stars),
        centre => centre,
    });
    let same_star = |a: usize, b: usize| labels[a] != NONE && labels[a] == labels[b];
    let mut first = [NONE; 2];
    let mut visit = |a: u32, b: u32| {
        // The triangles are compared in the order of their numbers, so that the place depends on the pair alone.
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
    let complete = tree.visit_pairs(
        most_work,
        same_star,
        |a, b| {
            // A leaf may hold triangles of a fan together with others. Pairs of the same fan are therefore skipped here
            // one by one.
            let [one, other] = [a, b].map(|t| fans.of(&soup.triangles[t as usize]));
            if one != NONE && one == other { ControlFlow::Continue(()) } else { visit(a, b) }
        },
        exec,
    )?;
    found.complete = complete && fans.visit_pairs(soup, order, most_work, visit, exec)?;
    found.place = found.place.map(|place| place * soup.unit);
    Ok(found)
}

/// Whether two surfaces pass through each other: an edge of one pierces the inside of a triangle of the other.
///
/// Touching and overlapping in one plane do not count, unlike in [`self_intersections`]: two discs in a plane, one
/// inside the other, do not cross.
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
    // The label of a triangle is the number of its surface. A node with triangles of both surfaces has no label.
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

/// A point where two triangles meet outside their shared vertices and edge, or `None`.
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
            // An intersection beyond the shared vertex reaches the edge opposite it, in one of the triangles.
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

/// The corner with the largest star: the most triangles, none of which intersect each other. [`NONE`] if no corner has
/// a settled star. All triangles of a large star choose its centre, so that the star is settled as a whole.
fn largest_star(triangle: &[u32; 3], stars: &[u32]) -> u32 {
    let most = triangle.iter().copied().max_by_key(|&v| (stars[v as usize], std::cmp::Reverse(v)));
    most.filter(|&v| stars[v as usize] > 0).unwrap_or(NONE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::SplitMix64;
    use std::f64::consts::TAU;

    /// A random grid of triangles swept from a curve that may cross itself, with holes, noise, and vertices merged with
    /// others. If the coordinates are rounded to a coarse grid, many of the triangles touch.
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
                let sum = |which: usize| waves.iter().map(|w| w[which] * libm::sin(w[0] * t + w[3])).sum::<f64>();
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
            // Two parts of the net that are far from each other share a vertex.
            let [one, other] = [0, 0].map(|_: u32| any(0.0, vertices.len() as f64) as u32);
            triangles.iter_mut().flatten().filter(|v| **v == one).for_each(|v| *v = other);
        }
        (vertices, triangles)
    }

    /// The self-intersections of a mesh and the number of suspects. Asserts that the suspects alone have the same
    /// intersections.
    fn found_among_suspects(vertices: &[DVec3], triangles: &[[u32; 3]], size: usize) -> (SelfIntersections, usize) {
        let exec = Execution::default();
        let suspects = charts::suspects(vertices, triangles, Order::Spatial, size, &exec).unwrap();
        let suspects: Vec<[u32; 3]> = suspects.into_iter().map(|t| triangles[t as usize]).collect();
        let among = |list: &[[u32; 3]]| intersections_among(vertices, list, Order::Spatial, u64::MAX, &exec).unwrap();
        let expected = among(triangles);
        assert_eq!(among(&suspects), expected, "{size}: {vertices:?} {triangles:?}");
        (expected, suspects.len())
    }

    /// The triangles of a grid of m by n cells whose vertices have the given numbers.
    fn grid(m: u32, n: u32, number: impl Fn(u32, u32) -> u32) -> Vec<[u32; 3]> {
        let cell = |i: u32, j: u32| {
            let [a, b, c, d] = [number(i, j), number(i, j + 1), number(i + 1, j + 1), number(i + 1, j)];
            [[a, b, c], [a, c, d]]
        };
        (0..m * n).flat_map(|k| cell(k / n, k % n)).collect()
    }

    #[test]
    fn charts_leave_out_no_triangle_that_intersects_another() {
        let mut random = SplitMix64::new(16);
        let (mut all, mut suspected, mut crossing) = (0, 0, 0);
        let cases = if std::env::var_os("PLATEAU_FULL").is_some() { 3000 } else { 1000 };
        for case in 0..cases {
            let (vertices, triangles) = net(&mut random);
            let (found, suspects) = found_among_suspects(&vertices, &triangles, [1, 2, 3, 4, 7, 16][case % 6]);
            all += triangles.len();
            suspected += suspects;
            crossing += usize::from(found.pairs > 0);
        }
        // Both kinds of mesh are frequent, and the charts settle a part of them.
        assert!((cases / 10..cases * 29 / 30).contains(&crossing), "{crossing} of {cases}");
        assert!(suspected + 10 * cases < all, "{suspected} of {all}");
    }

    /// A ramp of one and a half turns, seen from above: its boundary is one polygon, which crosses itself.
    #[test]
    fn a_part_whose_boundary_crosses_itself_is_no_chart() {
        for (slope, crosses) in [(0.05, false), (0.0, true)] {
            let mut vertices = Vec::new();
            for i in 0..=120 {
                for j in 0..=4 {
                    let angle = 9.4 * f64::from(i) / 120.0;
                    let (y, x) = libm::sincos(angle);
                    let radius = 1.0 + f64::from(j) / 4.0;
                    vertices.push(DVec3::new(
                        radius * x,
                        radius * y,
                        slope * angle + 0.1 * libm::sin(0.5 * angle - 0.5),
                    ));
                }
            }
            let (found, _) = found_among_suspects(&vertices, &grid(120, 4, |i, j| 5 * i + j), 8);
            assert_eq!(found.pairs > 0, crosses, "{slope}");
        }
    }

    /// A spiral ramp of a little more than one turn, whose last part lies over its first part. The two parts share two
    /// vertices, and seen from above the boundary crosses itself exactly there. The last part is tilted about the line
    /// through these vertices, so that it intersects the first part. A search for crossings of boundary edges that
    /// ignores common vertices would take the ramp for a chart, which cannot intersect itself.
    #[test]
    fn a_part_whose_boundary_crosses_itself_at_vertices_is_no_chart() {
        let over = 8;
        let (turn, rows) = (64, 4);
        let place = |i: u32, j: u32| {
            let angle = TAU * f64::from(i) / f64::from(turn);
            let radius = 1.0 + f64::from(j) / f64::from(rows) + 0.5 * angle / TAU;
            DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 0.0)
        };
        // The first vertex is where the start's side crosses the end's inner edge, the second where the start's outer
        // edge crosses the end's side.
        let shared = [[0, 2], [over, rows]];
        let [one, other] = shared.map(|[i, j]| place(i, j));
        let tilt = (other - one).cross(DVec3::Z).normalize();
        let mut vertices = Vec::new();
        for i in 0..=turn + over {
            for j in 0..=rows {
                let point = place(i, j);
                let is_end = i + over >= turn;
                vertices.push(if is_end { point + DVec3::Z * 0.3 * tilt.dot(point - one) } else { point });
            }
        }
        let number = |i: u32, j: u32| match [i, j] {
            _ if [i, j] == [turn, 0] => 2,
            _ if [i, j] == [turn + over, 2] => over * (rows + 1) + rows,
            _ => i * (rows + 1) + j,
        };
        for size in [1, 4, 8] {
            let (found, _) = found_among_suspects(&vertices, &grid(turn + over, rows, number), size);
            assert!(found.pairs > 5, "{found:?}");
        }
    }

    /// Two sheets that lie on the same side of their common edge, and pass through each other further on.
    #[test]
    fn sheets_on_the_same_side_of_an_edge_are_no_chart() {
        let n = 16;
        let row = |k: u32| move |i: u32, j: u32| if i == 0 { j } else { (k * n + i) * (n + 1) + j };
        let mut vertices = Vec::new();
        for (k, height) in [(0, 0.0), (1, 0.2)] {
            for i in k..=n {
                for j in 0..=n {
                    let [x, y] = [i, j].map(|at| f64::from(at) / f64::from(n));
                    vertices.push(DVec3::new(-x, y, height * libm::sin(4.5 * x + 0.1 * y)));
                }
            }
        }
        let triangles: Vec<[u32; 3]> =
            grid(n, n, row(0)).into_iter().zip(grid(n, n, row(1))).flat_map(|(one, other)| [one, other]).collect();
        for size in [1, 4, 16] {
            let (found, _) = found_among_suspects(&vertices, &triangles, size);
            assert!(found.pairs > 5, "{found:?}");
        }
    }

    /// A vertex of a plane sheet lies on the wrong side of an edge by less than the rounding of a normal.
    #[test]
    fn a_triangle_that_is_folded_by_less_than_rounding_is_in_no_chart() {
        let n = 12;
        let mut vertices: Vec<DVec3> =
            (0..(n + 1) * (n + 1)).map(|v| DVec3::new(f64::from(v / (n + 1)), f64::from(v % (n + 1)), 0.0)).collect();
        let triangles = grid(n, n, |i, j| i * (n + 1) + j);
        let middle = (6 * (n + 1) + 6) as usize;
        vertices[middle] += DVec3::new(-1.0 - 2.0f64.powi(-42), -0.5, 0.0);
        for size in [1, 4, 16] {
            let (found, _) = found_among_suspects(&vertices, &triangles, size);
            assert!(found.pairs > 0, "{found:?}");
        }
    }

    /// A piece of a catenoid whose triangles are numbered in three ways: along its rows, in families of sixteen, and at
    /// random.
    #[test]
    fn a_smooth_surface_has_no_suspects_in_whatever_order_its_triangles_are() {
        let (m, n) = (128, 64);
        let place = |v: u32| {
            let (angle, height) = (TAU * f64::from(v % m) / f64::from(m), f64::from(v / m) / f64::from(n) - 0.5);
            DVec3::new(libm::cosh(height) * libm::cos(angle), libm::cosh(height) * libm::sin(angle), height)
        };
        let vertices: Vec<DVec3> = (0..m * (n + 1)).map(place).collect();
        let rows = grid(m, n, |i, j| j * m + i % m);
        // A family is a block of 4 by 2 cells, which has 16 triangles. The families follow each other in random order.
        let mut random = SplitMix64::new(7);
        let mut shuffled = |count: usize| {
            let mut order: Vec<usize> = (0..count).collect();
            (1..count).for_each(|k| order.swap(k, random.below(k + 1)));
            order
        };
        let families: Vec<[u32; 3]> = shuffled(rows.len() / 16)
            .into_iter()
            .flat_map(|family| {
                let (i, j) = (4 * (family / (n as usize / 2)), 2 * (family % (n as usize / 2)));
                let rows = &rows;
                (0..4).flat_map(move |k| {
                    let start = 2 * ((i + k) * n as usize + j);
                    rows[start..start + 4].iter().copied()
                })
            })
            .collect();
        let random_order: Vec<[u32; 3]> = shuffled(rows.len()).into_iter().map(|t| rows[t]).collect();
        for (name, triangles, most_work) in
            [("rows", rows, 10.0), ("families", families, 10.0), ("at random", random_order, 20.0)]
        {
            let exec = Execution::default();
            let suspects = charts::suspects(&vertices, &triangles, Order::Spatial, PATCH, &exec).unwrap();
            assert_eq!(suspects.len(), 0, "{name}");
            let work = exec.work() as f64 / triangles.len() as f64;
            assert!(work < most_work, "{name}: {work}");
        }
    }

    /// A disc with a pleat around its middle. One row of cells of the pleat faces down, and the pleat passes through
    /// itself.
    #[test]
    fn a_patch_faces_a_direction_only_if_all_its_triangles_do() {
        let profile = [
            [0.3, 0.0],
            [0.9, 0.0],
            [1.44, 0.0],
            [2.0, 0.0],
            [1.8, 0.4],
            [2.1, -0.4],
            [2.8, -0.4],
            [3.4, -0.4],
            [4.0, -0.4],
        ];
        let n = profile.len() as u32;
        let vertices: Vec<DVec3> = (0..32 * n)
            .map(|v| {
                let ([radius, z], angle) = (profile[(v % n) as usize], TAU * f64::from(v / n) / 32.0);
                DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
            })
            .collect();
        for size in [4, 16] {
            let (found, _) = found_among_suspects(&vertices, &grid(32, n - 1, |i, j| i % 32 * n + j), size);
            assert!(found.pairs > 5, "{found:?}");
        }
    }

    /// A sheet with holes that touch each other at vertices, so that the boundary passes through these vertices twice.
    #[test]
    fn holes_that_touch_leave_a_chart() {
        let n = 24;
        let at = |v: u32| [v / (n + 1), v % (n + 1)].map(f64::from);
        let vertices: Vec<DVec3> = (0..(n + 1) * (n + 1))
            .map(at)
            .map(|[x, y]| DVec3::new(x, y, libm::sin(0.3 * x) * libm::cos(0.2 * y)))
            .collect();
        let mut triangles = grid(n, n, |i, j| i * (n + 1) + j);
        let is_hole = |[i, j]: [u32; 2]| (5..15).contains(&i) && (i == j || i + j == 24);
        let mut cell = 0..;
        triangles.retain(|_| cell.next().is_some_and(|k: u32| !is_hole([k / 2 / n, k / 2 % n])));
        for size in [1, 4, 16] {
            assert_eq!(found_among_suspects(&vertices, &triangles, size).1, 0, "{size}");
        }
    }

    /// Two parallel sheets, tilted so that the axis-aligned boxes of their patches meet.
    #[test]
    fn patches_that_are_apart_are_no_suspects() {
        let n = 40;
        let sheet = |height: f64| {
            (0..(n + 1) * (n + 1)).map(move |v| {
                let [x, y] = [v / (n + 1), v % (n + 1)].map(f64::from);
                DVec3::new(x, y, 0.7 * x + 0.6 * y + height)
            })
        };
        let vertices: Vec<DVec3> = sheet(0.0).chain(sheet(1.0)).collect();
        let triangles = [0, 1].map(|k| grid(n, n, |i, j| k * (n + 1) * (n + 1) + i * (n + 1) + j)).concat();
        assert_eq!(found_among_suspects(&vertices, &triangles, PATCH).1, 0);
    }
}
