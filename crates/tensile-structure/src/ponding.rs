//! Water that would stand on a film: ponding.
//!
//! Rain runs down the film and leaves it over its edges. The level of the water at a vertex is the least height over
//! which a path from there to an edge leads:
//!
//! ```text
//! level(v) = min over the paths from v to an edge of the film, max over the path, of the height
//! ```
//!
//! The levels are found by priority flooding, which goes from the edges inwards and always continues from the lowest
//! vertex that was reached (Barnes, Lehman, Mulla, *Priority-flood: an optimal depression-filling and
//! watershed-labeling algorithm for digital elevation models*, 2014). On a surface of triangles the best path runs
//! along edges of triangles, so the levels are exact for the mesh. Connected vertices below their levels form a pond.

use plateau_mesh::execution::WORK_PER_TRIANGLE;
use plateau_mesh::measure::{self, double_area_vector};
use plateau_mesh::order::TotalOrder;
use plateau_mesh::{DVec3, Execution, Interruption};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A pond shallower than this fraction of the film's radius is attributed to rounding and does not count.
const ROUNDING: f64 = 1e-6;

/// The water that stands on a film after rain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ponding {
    /// The depth of the water at its deepest place.
    pub depth: f64,
    /// The deepest place.
    pub place: DVec3,
    /// The area of the surfaces of all ponds.
    pub area: f64,
    /// The volume of all ponds.
    pub volume: f64,
}

/// A film on which water may stand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roof<'a> {
    pub triangles: &'a [[u32; 3]],
    pub at: &'a [DVec3],
    /// The loops of vertices over which water runs off.
    pub rims: &'a [Vec<u32>],
    /// The edges along cables across the film, each with its smaller vertex first, sorted. The film has a fold there,
    /// so the angle between two triangles says nothing about the mesh.
    pub folds: &'a [[u32; 2]],
    pub up: DVec3,
}

/// Marks a vertex that stays dry, in place of the number of a pond.
const DRY: u32 = u32::MAX;

/// Returns the water that stands on a roof; `None` if all water runs off.
///
/// A pond counts only if it is deeper than a false pond that the mesh alone can make. In a sloping valley whose lowest
/// line runs between the vertices, a vertex may be lower than all its neighbours by up to κ h² / 2, where κ is the
/// curvature of the film and h is the length of its edges. This equals h θ / 2 with the angle θ between the two
/// triangles of an edge. A pond whose deepest place lies below another part of the film, for example inside a chamber,
/// does not count either, because no rain falls there.
///
/// # Errors
/// [`Interruption::Cancelled`]. A deadline does not stop the search, because the search is short.
pub(super) fn find(roof: &Roof, exec: &Execution) -> Result<Option<Ponding>, Interruption> {
    let look = |work: u64| match exec.look(work) {
        Err(Interruption::Cancelled) => Err(Interruption::Cancelled),
        _ => Ok(()),
    };
    let sides = sides(roof.triangles);
    let neighbours = Neighbours::of(&sides, roof.at.len());
    look(WORK_PER_TRIANGLE * roof.triangles.len() as u64)?;
    let heights: Vec<f64> = roof.at.iter().map(|p| p.dot(roof.up)).collect();
    let levels = levels(roof, &neighbours, &heights);
    look(WORK_PER_TRIANGLE * roof.triangles.len() as u64)?;
    let (pond_of, mut ponds) = ponds(&neighbours, &heights, &levels);
    for (ends, error) in errors_of_edges(roof, &sides) {
        for pond in ends.map(|v| pond_of[v as usize]).into_iter().filter(|&pond| pond != DRY) {
            let own = &mut ponds[pond as usize].mesh_error;
            *own = own.max(error);
        }
    }
    let least = ROUNDING * plateau_mesh::polyline::radius(roof.at);
    let mut counts = vec![false; ponds.len()];
    for (pond, counts) in ponds.iter().zip(&mut counts) {
        if pond.depth > least.max(pond.mesh_error) {
            *counts = !roof.is_covered(pond.deepest);
            look(roof.triangles.len() as u64)?;
        }
    }
    let mut sums = vec![[0.0; 2]; ponds.len()];
    for triangle in roof.triangles {
        let Some(wet) = triangle.iter().copied().find(|&v| pond_of[v as usize] != DRY) else { continue };
        let level = levels[wet as usize];
        let area = 0.5 * double_area_vector(triangle.map(|v| roof.at[v as usize])).dot(roof.up);
        let (share, depth) = under_water(triangle.map(|v| level - heights[v as usize]));
        let [own_area, volume] = &mut sums[pond_of[wet as usize] as usize];
        // The area is signed, because otherwise the parts of a bag that lean over the water would be counted twice.
        *own_area += area * share;
        *volume += area * depth;
    }
    let mut found: Option<Ponding> = None;
    for ((pond, [area, volume]), _) in ponds.iter().zip(sums).zip(counts).filter(|(_, counts)| *counts) {
        let own = Ponding {
            depth: pond.depth,
            place: roof.at[pond.deepest as usize],
            area: area.abs(),
            volume: volume.abs(),
        };
        found = Some(match found {
            None => own,
            Some(other) => Ponding {
                area: own.area + other.area,
                volume: own.volume + other.volume,
                ..if own.depth > other.depth { own } else { other }
            },
        });
    }
    Ok(found)
}

impl Roof<'_> {
    /// Whether a triangle lies above the vertex. Triangles around the vertex do not count.
    fn is_covered(&self, vertex: u32) -> bool {
        let (east, north) = self.up.any_orthonormal_pair();
        let place = self.at[vertex as usize];
        self.triangles.iter().filter(|triangle| !triangle.contains(&vertex)).any(|triangle| {
            let corners = triangle.map(|v| self.at[v as usize] - place);
            let plan = corners.map(|p| (p.dot(east), p.dot(north)));
            // Twice the areas of the triangles between the vertex and each edge, as seen from above.
            let areas = [0, 1, 2].map(|k| {
                let ((x, y), (u, v)) = (plan[(k + 1) % 3], plan[(k + 2) % 3]);
                x * v - y * u
            });
            let whole: f64 = areas.iter().sum();
            let inside = areas.iter().all(|area| *area >= 0.0) || areas.iter().all(|area| *area <= 0.0);
            let height = || (0..3).map(|k| areas[k] / whole * corners[k].dot(self.up)).sum::<f64>();
            whole != 0.0 && inside && height() > 0.0
        })
    }
}

/// All sides of all triangles, each as its smaller end, its larger end and the triangle. They are sorted, so that the
/// sides of an edge are adjacent.
fn sides(triangles: &[[u32; 3]]) -> Vec<(u32, u32, u32)> {
    let mut sides = Vec::with_capacity(3 * triangles.len());
    for (t, &[a, b, c]) in triangles.iter().enumerate() {
        sides.extend([[a, b], [b, c], [c, a]].map(|[a, b]| (a.min(b), a.max(b), t as u32)));
    }
    sides.sort_unstable();
    sides
}

/// The neighbours of all vertices in one list.
#[derive(Debug)]
struct Neighbours {
    /// For each vertex the place in `all` at which its neighbours begin, and at the end the length of `all`.
    starts: Vec<usize>,
    all: Vec<u32>,
}

impl Neighbours {
    fn of(sides: &[(u32, u32, u32)], count: usize) -> Self {
        let edges = || sides.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).map(|sides| [sides[0].0, sides[0].1]);
        let mut starts = vec![0; count + 1];
        edges().flatten().for_each(|v| starts[v as usize + 1] += 1);
        (0..count).for_each(|v| starts[v + 1] += starts[v]);
        let mut next = starts.clone();
        let mut all = vec![0; starts[count]];
        for [a, b] in edges() {
            for (from, to) in [(a, b), (b, a)] {
                all[next[from as usize]] = to;
                next[from as usize] += 1;
            }
        }
        Self { starts, all }
    }

    fn of_vertex(&self, v: u32) -> &[u32] {
        &self.all[self.starts[v as usize]..self.starts[v as usize + 1]]
    }
}

/// The level of the water at every vertex. At a dry vertex it is the height of the vertex.
fn levels(roof: &Roof, neighbours: &Neighbours, heights: &[f64]) -> Vec<f64> {
    let mut levels = heights.to_vec();
    let mut reached = vec![false; heights.len()];
    let mut queue = BinaryHeap::new();
    for &v in roof.rims.iter().flatten() {
        if !std::mem::replace(&mut reached[v as usize], true) {
            queue.push(Reverse((TotalOrder(heights[v as usize]), v)));
        }
    }
    // At most one pass per vertex, because a vertex is added when it is reached for the first time.
    while let Some(Reverse((TotalOrder(level), v))) = queue.pop() {
        for &next in neighbours.of_vertex(v) {
            if !std::mem::replace(&mut reached[next as usize], true) {
                let own = &mut levels[next as usize];
                *own = own.max(level);
                queue.push(Reverse((TotalOrder(*own), next)));
            }
        }
    }
    levels
}

#[derive(Clone, Copy, Debug)]
struct Pond {
    depth: f64,
    deepest: u32,
    /// Depth of the deepest false pond that the mesh alone can make here: the largest h θ / 2 ([`find`]).
    mesh_error: f64,
}

/// The number of the pond of each vertex, [`DRY`] for dry vertices, and the ponds. A pond is a connected set of wet
/// vertices.
fn ponds(neighbours: &Neighbours, heights: &[f64], levels: &[f64]) -> (Vec<u32>, Vec<Pond>) {
    let depth = |v: u32| levels[v as usize] - heights[v as usize];
    let mut pond_of = vec![DRY; heights.len()];
    let mut ponds = Vec::new();
    for start in 0..heights.len() as u32 {
        if depth(start) <= 0.0 || pond_of[start as usize] != DRY {
            continue;
        }
        let number = ponds.len() as u32;
        let mut pond = Pond { depth: 0.0, deepest: start, mesh_error: 0.0 };
        let mut stack = vec![start];
        pond_of[start as usize] = number;
        // At most one pass per vertex, because each vertex gets its pond once and is added then.
        while let Some(v) = stack.pop() {
            if depth(v) > pond.depth {
                pond = Pond { depth: depth(v), deepest: v, ..pond };
            }
            for &next in neighbours.of_vertex(v) {
                if depth(next) > 0.0 && pond_of[next as usize] == DRY {
                    pond_of[next as usize] = number;
                    stack.push(next);
                }
            }
        }
        ponds.push(pond);
    }
    (pond_of, ponds)
}

/// For each edge between two triangles that is no fold, its ends and the depth h θ / 2 of the false pond that the mesh
/// can make there ([`find`]).
fn errors_of_edges<'a>(
    roof: &'a Roof,
    sides: &'a [(u32, u32, u32)],
) -> impl Iterator<Item = ([u32; 2], f64)> + use<'a> {
    let normal = |t: u32| double_area_vector(roof.triangles[t as usize].map(|v| roof.at[v as usize]));
    sides.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).filter_map(move |sides| {
        let &[(a, b, first), (.., second)] = sides else { return None };
        if roof.folds.binary_search(&[a, b]).is_ok() {
            return None;
        }
        let angle = measure::angle(normal(first), normal(second));
        Some(([a, b], 0.5 * angle * roof.at[a as usize].distance(roof.at[b as usize])))
    })
}

/// The share of a triangle that is under water, and the mean depth over the whole triangle. `depths` are the depths at
/// the corners, negative at dry corners.
fn under_water(depths: [f64; 3]) -> (f64, f64) {
    // The share of the triangle on the side of the shore on which corner k is the only corner.
    let cut_off = |k: usize| {
        let [own, next, last] = [0, 1, 2].map(|i| depths[(k + i) % 3]);
        own * own / ((own - next) * (own - last))
    };
    let corner = |wet: bool| (0..3).find(|&k| (depths[k] > 0.0) == wet).unwrap_or(0);
    let mean = depths.iter().sum::<f64>() / 3.0;
    match depths.iter().filter(|depth| **depth > 0.0).count() {
        0 => (0.0, 0.0),
        1 => {
            let wet = corner(true);
            (cut_off(wet), cut_off(wet) * depths[wet] / 3.0)
        }
        2 => {
            let dry = corner(false);
            (1.0 - cut_off(dry), mean - cut_off(dry) * depths[dry] / 3.0)
        }
        _ => (1.0, mean),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::film::Film;
    use plateau_mesh::structured::patch;
    use std::f64::consts::PI;

    /// A disc of radius 1 of `2 n²` triangles, with the height of each point.
    fn disc(n: usize, height: impl Fn(f64, f64) -> f64) -> Film {
        patch(n, n, |u, v| {
            let (u, v) = (2.0 * u - 1.0, 2.0 * v - 1.0);
            let (x, y) = (u * (1.0 - 0.5 * v * v).sqrt(), v * (1.0 - 0.5 * u * u).sqrt());
            DVec3::new(x, y, height(x, y))
        })
    }

    fn on(film: &Film) -> Option<Ponding> {
        let roof = Roof {
            triangles: film.triangles(),
            at: &film.vertices,
            rims: &film.boundaries,
            folds: &film.locked,
            up: DVec3::Z,
        };
        find(&roof, &Execution::default()).unwrap()
    }

    #[test]
    fn a_tilted_bowl_fills_up_to_its_lowest_rim() {
        // z = k r² + s x over a disc of radius 1: the water's surface is a circle of radius ρ = 1 - s / 2 k around
        // x = -s / 2 k, its depth k ρ², its volume π k ρ⁴ / 2.
        let (k, slope) = (0.3, 0.2);
        let radius: f64 = 1.0 - slope / (2.0 * k);
        let exact = [k * radius.powi(2), PI * radius.powi(2), 0.5 * PI * k * radius.powi(4)];
        let mut errors = [Vec::new(), Vec::new(), Vec::new()];
        for n in [16, 32, 64] {
            let pond = on(&disc(n, |x, y| k * (x * x + y * y) + slope * x)).unwrap();
            for (errors, (found, exact)) in
                errors.iter_mut().zip([pond.depth, pond.area, pond.volume].into_iter().zip(exact))
            {
                errors.push((found - exact).abs());
            }
            let deepest = DVec3::new(-slope / (2.0 * k), 0.0, -slope * slope / (4.0 * k));
            assert!(pond.place.distance(deepest) < 2.0 / n as f64, "{pond:?}");
        }
        println!("{errors:?}");
        assert!(errors[0][2] < 1e-3 * exact[0], "{errors:?}");
        assert!(errors[1..].iter().all(|errors| libm::log2(errors[0] / errors[2]) > 3.0), "{errors:?}");
        // A rim that is level all around.
        let level = on(&disc(32, |x, y| 0.3 * (x * x + y * y))).unwrap();
        assert!((level.depth - 0.3).abs() < 1e-12 && level.place.length() < 1e-12, "{level:?}");
        // A slope that is steeper than the bowl's own at its rim lets all water run off.
        assert_eq!(on(&disc(32, |x, y| k * (x * x + y * y) + 0.7 * x)), None);
    }

    #[test]
    fn water_runs_off_a_saddle_and_a_crown_although_they_are_level_in_their_middle() {
        for turned in [0.0, 0.3, 0.7, 1.2f64] {
            let saddle = |x: f64, y: f64| {
                let (x, y) =
                    (x * libm::cos(turned) + y * libm::sin(turned), y * libm::cos(turned) - x * libm::sin(turned));
                0.4 * (x * x - y * y) + 0.1
            };
            assert_eq!(on(&disc(24, saddle)), None, "{turned}");
        }
        assert_eq!(on(&disc(24, |x, y| -0.3 * (x * x + y * y))), None);
        assert_eq!(on(&disc(24, |_, _| 1.0)), None);
    }

    #[test]
    fn a_hollow_that_only_the_mesh_has_does_not_count() {
        // A valley that slopes in a direction oblique to the mesh. Its lowest line runs between the vertices, and some
        // vertices are lower than all their neighbours.
        let (cos, sin) = (libm::cos(0.37f64), libm::sin(0.37f64));
        let valley = disc(24, |x, y| 2.0 * (y * cos - x * sin).powi(2) - 0.02 * (x * cos + y * sin));
        let heights: Vec<f64> = valley.vertices.iter().map(|p| p.z).collect();
        let lowest = |v: u32| valley.topology.neighbours(v).all(|w| heights[w as usize] > heights[v as usize]);
        assert!((0..heights.len() as u32).any(|v| !valley.fixed[v as usize] && lowest(v)), "no hollow to ignore");
        assert_eq!(on(&valley), None);
    }

    #[test]
    fn a_hollow_beneath_film_stays_dry() {
        let bowl = disc(16, |x, y| 0.3 * (x * x + y * y) - 0.3);
        let dome = disc(16, |x, y| 0.3 - 0.3 * (x * x + y * y));
        let count = bowl.vertices.len() as u32;
        let vertices: Vec<DVec3> = bowl.vertices.iter().chain(&dome.vertices).copied().collect();
        let mut triangles = bowl.triangles().to_vec();
        triangles.extend(dome.triangles().iter().map(|triangle| triangle.map(|v| v + count)));
        let mut rims = bowl.boundaries.clone();
        rims.extend(dome.boundaries.iter().map(|rim| rim.iter().map(|v| v + count).collect()));
        let covered = Film::new(vertices, &triangles, rims).unwrap();
        assert!(on(&bowl).is_some());
        assert_eq!(on(&covered), None);
    }

    #[test]
    fn the_deepest_of_two_ponds_is_named_and_both_are_measured() {
        // Two paraboloids of radius 1/4 in a plane, one twice as deep as the other.
        let one = |x: f64, y: f64, depth: f64| (depth * (4.0 * (x * x + y * y) - 1.0)).min(0.0);
        let area = PI / 16.0;
        for deeper in [1.0, -1.0] {
            let bowls = |x: f64, y: f64| {
                let x = 2.0 * x * deeper;
                one(x - 1.0, 2.0 * y, 0.2) + one(x + 1.0, 2.0 * y, 0.1)
            };
            let both = on(&disc(64, bowls)).unwrap();
            assert!((both.depth - 0.2).abs() < 2e-3, "{both:?}");
            assert!(both.place.distance(DVec3::new(0.5 * deeper, 0.0, -0.2)) < 0.05, "{both:?}");
            // Each pond has the area π r² and, as its volume, half the area times the depth. The plane around the ponds
            // is as high as the water, so triangles across their rims count as a whole.
            assert!((both.area / (2.0 * area) - 1.0).abs() < 0.15, "{both:?}");
            assert!((both.volume / (0.5 * area * 0.3) - 1.0).abs() < 0.02, "{both:?}");
        }
    }

    #[test]
    fn a_crater_on_a_hill_fills_up_to_its_own_rim() {
        // z = 1/2 - (4 r² - 1)² / 5: the crater has the radius 1/2, the depth 1/5 and the volume π / 60.
        let crater = on(&disc(64, |x, y| 0.5 - 0.2 * (4.0 * (x * x + y * y) - 1.0).powi(2))).unwrap();
        assert!((crater.depth - 0.2).abs() < 2e-3, "{crater:?}");
        assert!((crater.area / (0.25 * PI) - 1.0).abs() < 0.1, "{crater:?}");
        assert!((crater.volume / (PI / 60.0) - 1.0).abs() < 0.03, "{crater:?}");
    }

    #[test]
    fn a_bag_holds_water_up_to_its_mouth() {
        // A sphere of radius 1 without the cap above the height 1/2, which leans over the water.
        let bag = disc(48, libm::hypot);
        let vertices: Vec<DVec3> = bag
            .vertices
            .iter()
            .map(|p| {
                let polar = (PI - PI / 3.0) * p.z;
                let around = p.truncate().normalize_or_zero() * libm::sin(polar);
                around.extend(-libm::cos(polar))
            })
            .collect();
        let bag = Film { vertices, ..bag };
        let pond = on(&bag).unwrap();
        // The water fills the spherical cap up to the height h = 3/2: its volume is π h² (3 - h) / 3, and its mouth has
        // the radius √3 / 2.
        assert!((pond.depth - 1.5).abs() < 1e-9, "{pond:?}");
        assert!((pond.area / (0.75 * PI) - 1.0).abs() < 0.01, "{pond:?}");
        assert!((pond.volume / (PI * 2.25 * 1.5 / 3.0) - 1.0).abs() < 0.01, "{pond:?}");
    }
}
