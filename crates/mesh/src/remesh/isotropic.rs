//! Isotropic remeshing: brings every edge near a target length that is given at each vertex. Long edges are split and
//! short edges are collapsed. The surface stays where it is.
//!
//! Source: Botsch, Kobbelt, *A Remeshing Approach to Multiresolution Modeling* (2004), section 4. Departures:
//! - The target size grows with the distance from the boundary, where it equals the boundary's spacing. In the paper it
//!   is one length everywhere.
//! - Edges that are split in one pass share no triangle, and edges that are collapsed in one pass share no
//!   neighbourhood. The triangle list is therefore rebuilt once per pass.

use super::delaunay::{flip_to_delaunay, tangential_relaxation};
use super::passes::{Collapse, Connected, Surface, collapse_edges, split_edges};
use crate::execution::WORK_PER_TRIANGLE;
use crate::film::Film;
use crate::measure::double_area_vector;
use crate::topology::{NONE, Topology, edge_key};
use crate::{DVec3, Execution, Interruption};

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// An edge is split if it exceeds this multiple of the target size at its ends. With √2, each half falls below the size
/// by the same factor by which the whole exceeded it.
const LONG: f64 = std::f64::consts::SQRT_2;
/// An edge is collapsed if it is shorter than this multiple of the target size. If the value were above √2 / 2, the
/// halves of a split edge would collapse again.
const SHORT: f64 = 0.7;
/// Growth of the target size with the distance from a fine boundary, per unit of length.
const GRADING: f64 = 0.3;
/// Largest growth that is tried if [`GRADING`] would give more triangles than are wanted.
const STEEPEST_GRADING: f64 = 5.0;
/// Lower bound of the target size beside an edge that keeps its length, as a fraction of that length. Without the bound
/// a fan of needles starts at the edge.
const FLOOR: f64 = 0.8;
/// Decrease of the lower bound of [`FLOOR`] with the distance from the edge, per unit of length.
const FALL: f64 = 0.5;
/// Largest decrease of the lower bound that is tried if too few triangles would be left for the rest of the film.
const STEEPEST_FALL: f64 = 4.0;
/// The lower bounds make triangles beside long edges larger. To keep the number of triangles, the cap of the target
/// size may be reduced down to this fraction of its value without lower bounds.
const ROOM: f64 = 0.7;
/// A pass counts as settled if it changes the number of triangles by less than this fraction.
const SETTLED_COUNT: f64 = 0.1;
/// The passes end if the number of triangles exceeds this multiple of the wanted number, because the film then has no
/// area.
pub const RUNAWAY: f64 = 4.0;
/// The passes end when the number of triangles differs from the wanted number by less than this fraction.
const CLOSE_ENOUGH: f64 = 0.03;

/// Whether boundary edges are split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundaryEdges {
    /// Long boundary edges are split. The new vertices are fixed and lie on the boundary segments.
    Refined,
    Kept,
}

/// Brings the number of triangles to about `count`, with triangles of even size away from the boundary. Fixed vertices
/// and locked edges stay; `boundary_edges` says whether boundary edges are split. Vertices that are not fixed get new
/// numbers. Each of at most `passes` passes splits, collapses, flips and relaxes once.
///
/// # Errors
/// The interruptions of `exec`; the film is valid in that case too.
pub fn resample(
    film: &mut Film,
    count: f64,
    passes: u32,
    boundary_edges: BoundaryEdges,
    exec: &Execution,
) -> Result<(), Interruption> {
    let (mut aim, mut before) = (count, film.triangles().len() as f64);
    let most = RUNAWAY * count.max(before);
    for _ in 0..passes {
        let mut size = sizes(film, aim, exec)?;
        split_long(film, &mut size, boundary_edges);
        size = sizes(film, aim, exec)?;
        collapse_short(film, &mut size);
        for _ in 0..2 {
            flip_to_delaunay(film, exec)?;
            tangential_relaxation(film, 1);
        }
        flip_to_delaunay(film, exec)?;
        exec.look(WORK_PER_TRIANGLE * film.triangles().len() as u64)?;
        let reached = film.triangles().len() as f64;
        if reached > most {
            // The film has no area: its triangles remain too flat for their sizes, however often their edges are split.
            break;
        }
        let settled = (reached / before - 1.0).abs() < SETTLED_COUNT;
        before = reached;
        if settled && (reached / count - 1.0).abs() < CLOSE_ENOUGH {
            break;
        }
        // Splitting and collapsing leave a range of lengths around the size. The number of triangles depends on where
        // in this range the lengths settle, so the aim is corrected by the number that was reached.
        if settled {
            aim *= (count / reached).clamp(0.7, 1.4);
        }
    }
    Ok(())
}

/// Splits the edges that are longer than √2 times the size at their ends, in at most `passes` passes, with flips and
/// tangential relaxation after each. `size` is the [`graded`] target size at every vertex. No edge is collapsed: all
/// vertices keep their numbers, and fixed vertices and locked edges stay.
///
/// # Errors
/// The interruptions of `exec`; the film is valid in that case too.
pub fn refine(
    film: &mut Film,
    mut size: Vec<f64>,
    passes: u32,
    boundary_edges: BoundaryEdges,
    exec: &Execution,
) -> Result<(), Interruption> {
    for _ in 0..passes {
        let before = film.triangles().len();
        split_long(film, &mut size, boundary_edges);
        if film.triangles().len() == before {
            break;
        }
        flip_to_delaunay(film, exec)?;
        tangential_relaxation(film, 1);
        flip_to_delaunay(film, exec)?;
        exec.look(WORK_PER_TRIANGLE * film.triangles().len() as u64)?;
    }
    Ok(())
}

/// Lowers target sizes so that they grow along the edges by no more than 0.3 of the distance.
pub fn graded(film: &Film, size: &mut [f64]) {
    grade(film, size, GRADING);
}

/// Lowers target sizes so that they grow along the edges by no more than `grading` times the distance.
fn grade(film: &Film, size: &mut [f64], grading: f64) {
    spread(film, |near, far, length| {
        let reached = size[near] + grading * length;
        let falls = reached < size[far] * (1.0 - 1e-9);
        if falls {
            size[far] = reached;
        }
        falls
    });
}

/// The target size at every vertex. It equals the boundary's spacing on the boundary and grows inwards up to a cap. The
/// cap is chosen so that about `count` equilateral triangles cover the film.
///
/// # Errors
/// The interruptions of `exec`.
fn sizes(film: &Film, count: f64, exec: &Execution) -> Result<Vec<f64>, Interruption> {
    let unit = 0.75f64.sqrt() / 2.0;
    let mut grading = GRADING;
    // At most nine passes, because the grading grows by a half in each up to `STEEPEST_GRADING`.
    let (spacing, mut pieces) = loop {
        let spacing = graded_spacing(film, grading);
        let pieces: Vec<(f64, f64)> = film
            .triangles()
            .iter()
            .map(|t| {
                let area = 0.5 * double_area_vector(film.corners(*t)).length();
                (t.iter().map(|&v| spacing[v as usize]).sum::<f64>() / 3.0, area)
            })
            .collect();
        let least: f64 = pieces.iter().map(|(size, area)| area / (unit * size * size)).sum();
        if least <= count || grading > STEEPEST_GRADING {
            break (spacing, pieces);
        }
        exec.look(film.triangles().len() as u64)?;
        grading *= 1.5;
    };
    // With a cap, the number of triangles is the sum of A / s² over the triangles of size s below the cap, plus the sum
    // of A / cap² over the others, up to a constant factor. A is a triangle's area.
    pieces.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut above: f64 = pieces.iter().map(|piece| piece.1).sum();
    let (mut below, mut cap) = (0.0, f64::INFINITY);
    for &(size, area) in &pieces {
        if below + above / (unit * size * size) <= count {
            cap = (above / (unit * (count - below).max(1.0))).sqrt();
            break;
        }
        below += area / (unit * size * size);
        above -= area;
    }
    let longest = stiff_edges(film).map(|(_, length)| length).fold(0.0, f64::max);
    if FLOOR * longest > cap {
        return with_floors(film, &spacing, count, cap, exec);
    }
    Ok(spacing.into_iter().map(|size| size.min(cap)).collect())
}

/// The target sizes of [`sizes`], but with lower bounds beside the stiff edges that are longer than the cap.
///
/// # Errors
/// The interruptions of `exec`.
fn with_floors(
    film: &Film,
    spacing: &[f64],
    count: f64,
    plain_cap: f64,
    exec: &Execution,
) -> Result<Vec<f64>, Interruption> {
    let unit = 0.75f64.sqrt() / 2.0;
    let size = |floor: &[f64], cap: f64, v: usize| spacing[v].min(cap.max(floor[v]));
    let mut fall = FALL;
    // At most six passes, because the decrease grows by a half in each up to `STEEPEST_FALL`.
    while fall <= STEEPEST_FALL {
        let floor = graded_floor(film, fall);
        let triangles = |cap: f64| -> f64 {
            let number = |t: &[u32; 3]| {
                let mean = t.iter().map(|&v| size(&floor, cap, v as usize)).sum::<f64>() / 3.0;
                0.5 * double_area_vector(film.corners(*t)).length() / (unit * mean * mean)
            };
            film.triangles().iter().map(number).sum()
        };
        let (mut low, mut high) = (ROOM * plain_cap, plain_cap);
        if triangles(low) >= count {
            for _ in 0..8 {
                let middle = (low * high).sqrt();
                *(if triangles(middle) >= count { &mut low } else { &mut high }) = middle;
            }
            return Ok((0..spacing.len()).map(|v| size(&floor, low, v)).collect());
        }
        exec.look(film.triangles().len() as u64)?;
        fall *= 1.5;
    }
    Ok(spacing.iter().map(|size| size.min(plain_cap)).collect())
}

/// The stiff edges, which keep their length: boundary edges and locked edges. Gives a half-edge and the length of each.
fn stiff_edges(film: &Film) -> impl Iterator<Item = (u32, f64)> + '_ {
    let topology = &film.topology;
    (0..topology.twin.len() as u32).filter_map(move |h| {
        let (a, b) = (topology.from(h), topology.to(h));
        let twin = topology.twin[h as usize];
        let stiff = twin == NONE || (twin > h && film.is_locked(a, b));
        stiff.then(|| (h, film.vertices[a as usize].distance(film.vertices[b as usize])))
    })
}

/// The lower bound of the target size at every vertex. At the ends of a stiff edge it is [`FLOOR`] times the edge's
/// length. It decreases inwards by `fall` times the distance, and is at least zero.
fn graded_floor(film: &Film, fall: f64) -> Vec<f64> {
    let mut floor = vec![0.0f64; film.vertices.len()];
    let topology = &film.topology;
    for (h, length) in stiff_edges(film) {
        for v in [topology.from(h), topology.to(h)] {
            floor[v as usize] = floor[v as usize].max(FLOOR * length);
        }
        // The third corner of a triangle at the edge is as far from the edge as the triangle is high.
        for half in [h, topology.twin[h as usize]].into_iter().filter(|&half| half != NONE) {
            let apex = topology.opposite(half) as usize;
            let altitude = double_area_vector(film.corners(film.triangles()[half as usize / 3])).length() / length;
            floor[apex] = floor[apex].max(FLOOR * length - fall * altitude);
        }
    }
    spread(film, |near, far, length| {
        let reached = floor[near] - fall * length;
        let rises = reached > floor[far] * (1.0 + 1e-9);
        if rises {
            floor[far] = reached;
        }
        rises
    });
    floor
}

/// Calls `offer` for every edge in both directions until it changes nothing, in at most 50 sweeps that run forwards and
/// backwards through the edges. A few sweeps suffice, because sizes need not travel far.
fn spread(film: &Film, mut offer: impl FnMut(usize, usize, f64) -> bool) {
    let topology = &film.topology;
    for sweep in 0..50 {
        let mut changed = false;
        for k in 0..topology.twin.len() {
            let h = if sweep % 2 == 0 { k } else { topology.twin.len() - 1 - k } as u32;
            let (a, b) = (topology.from(h) as usize, topology.to(h) as usize);
            let length = film.vertices[a].distance(film.vertices[b]);
            changed |= offer(a, b, length);
            changed |= offer(b, a, length);
        }
        if !changed {
            break;
        }
    }
}

/// The uncapped target size at every vertex. At the ends of stiff edges it is the length of the shortest stiff edge
/// there. From there it grows inwards along the edges by `grading` times the distance.
fn graded_spacing(film: &Film, grading: f64) -> Vec<f64> {
    let mut size = vec![f64::INFINITY; film.vertices.len()];
    for (h, length) in stiff_edges(film) {
        for v in [film.topology.from(h), film.topology.to(h)] {
            size[v as usize] = size[v as usize].min(length);
        }
    }
    grade(film, &mut size, grading);
    size
}

/// The edges whose key is above 1, largest key first. Boundary edges are left out if they are kept.
fn ranked(film: &Film, boundary_edges: BoundaryEdges, key: impl Fn(u32) -> f64) -> Vec<u32> {
    let twin = &film.topology.twin;
    let may = |h: u32| boundary_edges == BoundaryEdges::Refined || twin[h as usize] != NONE;
    film.topology.ranked_edges(|h| if may(h) { key(h) } else { 0.0 })
}

fn length(film: &Film, h: u32) -> f64 {
    film.vertices[film.topology.from(h) as usize].distance(film.vertices[film.topology.to(h) as usize])
}

fn size_at(film: &Film, size: &[f64], h: u32) -> f64 {
    0.5 * (size[film.topology.from(h) as usize] + size[film.topology.to(h) as usize])
}

/// Splits the edges that are too long, beginning with the largest ratio of length to size. Two edges of one triangle
/// are not split in the same pass. A new vertex gets the mean of the sizes at the ends of its edge.
fn split_long(film: &mut Film, size: &mut Vec<f64>, boundary_edges: BoundaryEdges) {
    let edges = ranked(film, boundary_edges, |h| length(film, h) / (LONG * size_at(film, size, h)));
    let mut sized = Sized { film, size, on_boundary: Vec::new() };
    split_edges(&mut sized, edges);
    let Sized { film, mut on_boundary, .. } = sized;
    on_boundary.sort_unstable();
    if on_boundary.is_empty() {
        return;
    }
    for boundary in &mut film.boundaries {
        let mut longer = Vec::with_capacity(2 * boundary.len());
        for (k, &a) in boundary.iter().enumerate() {
            let b = boundary[(k + 1) % boundary.len()];
            longer.push(a);
            if let Ok(found) = on_boundary.binary_search_by_key(&edge_key([a, b]), |(ends, _)| *ends) {
                longer.push(on_boundary[found].1);
            }
        }
        *boundary = longer;
    }
}

/// Collapses the edges that are too short, beginning with the smallest ratio of length to size. Collapses in one pass
/// share no neighbourhood.
fn collapse_short(film: &mut Film, size: &mut Vec<f64>) {
    let edges =
        ranked(film, BoundaryEdges::Kept, |h| SHORT * size_at(film, size, h) / length(film, h).max(f64::MIN_POSITIVE));
    collapse_edges(&mut Sized { film, size, on_boundary: Vec::new() }, edges);
    film.close_gaps().expect("the link condition keeps a manifold");
}

/// A film with a target size at every vertex.
struct Sized<'f> {
    film: &'f mut Film,
    size: &'f mut Vec<f64>,
    /// The boundary edges that were split, each with its new vertex.
    on_boundary: Vec<([u32; 2], u32)>,
}

impl Sized<'_> {
    /// Whether a collapse may move `v` to `place`: the triangles around `v` that do not contain `other` keep their
    /// orientation, and their edges stay short enough.
    fn may_move(&self, v: u32, other: u32, place: DVec3) -> bool {
        let Self { film, size, .. } = self;
        let topology = &film.topology;
        topology.outgoing_half_edges(v).all(|h| {
            let (j, k) = (topology.to(h), topology.opposite(h));
            if j == other || k == other {
                return true;
            }
            let (p, q) = (film.vertices[j as usize], film.vertices[k as usize]);
            let before = double_area_vector([film.vertices[v as usize], p, q]);
            let after = double_area_vector([place, p, q]);
            let longest = LONG * 0.5 * (size[v as usize] + size[j as usize]);
            after.dot(before) > 0.2 * after.length() * before.length()
                && after.length() > 0.1 * p.distance_squared(q).max(place.distance_squared(p))
                && place.distance(p) < longest
        })
    }
}

impl Connected for Sized<'_> {
    fn topology(&self) -> &Topology {
        &self.film.topology
    }

    fn topology_mut(&mut self) -> &mut Topology {
        &mut self.film.topology
    }
}

impl Surface for Sized<'_> {
    type Place = DVec3;

    fn add_middle(&mut self, h: u32) -> Option<u32> {
        let Self { film, size, on_boundary } = self;
        let (a, b) = (film.topology.from(h), film.topology.to(h));
        if film.is_locked(a, b) {
            return None;
        }
        let middle = film.vertices.len() as u32;
        let is_boundary = film.topology.twin[h as usize] == NONE;
        film.vertices.push(0.5 * (film.vertices[a as usize] + film.vertices[b as usize]));
        size.push(0.5 * (size[a as usize] + size[b as usize]));
        film.fixed.push(is_boundary);
        if is_boundary {
            on_boundary.push((edge_key([a, b]), middle));
        }
        Some(middle)
    }

    /// If one end is fixed, the free end moves there. Two free ends meet in the middle.
    fn planned_collapse(&self, h: u32) -> Option<Collapse<DVec3>> {
        let (film, a, b) = (&self.film, self.film.topology.from(h), self.film.topology.to(h));
        let (leaves, stays) = if film.fixed[a as usize] { (b, a) } else { (a, b) };
        let place = if film.fixed[stays as usize] {
            film.vertices[stays as usize]
        } else {
            0.5 * (film.vertices[a as usize] + film.vertices[b as usize])
        };
        (!film.fixed[leaves as usize]).then_some(Collapse { leaves, stays, place, moves: true })
    }

    fn keeps_shape(&self, &Collapse { leaves, stays, place, .. }: &Collapse<DVec3>) -> bool {
        self.may_move(leaves, stays, place) && self.may_move(stays, leaves, place)
    }

    fn merge(&mut self, Collapse { stays, place, .. }: Collapse<DVec3>) {
        self.film.vertices[stays as usize] = place;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure;

    /// A flat strip that is ten times as long as it is wide. Its inner vertices are crowded towards one side.
    fn strip() -> Film {
        let (n, m) = (40, 4);
        let at = |i: usize, j: usize| (j * (n + 1) + i) as u32;
        let vertices: Vec<DVec3> = (0..=m)
            .flat_map(|j| {
                (0..=n).map(move |i| {
                    let inner = i > 0 && i < n && j > 0 && j < m;
                    let y = j as f64 / m as f64;
                    DVec3::new(10.0 * i as f64 / n as f64, if inner { y * y * y } else { y }, 0.0)
                })
            })
            .collect();
        let triangles: Vec<[u32; 3]> = (0..m)
            .flat_map(|j| (0..n).map(move |i| (i, j)))
            .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
            .collect();
        let mut boundary: Vec<u32> = (0..n).map(|i| at(i, 0)).collect();
        boundary.extend((0..m).map(|j| at(n, j)));
        boundary.extend((1..=n).rev().map(|i| at(i, m)));
        boundary.extend((1..=m).rev().map(|j| at(0, j)));
        Film::new(vertices, &triangles, vec![boundary]).unwrap()
    }

    #[test]
    fn counts_are_met_finer_and_coarser_and_the_boundary_stays() {
        let start = strip();
        for count in [320.0, 900.0] {
            let mut film = start.clone();
            resample(&mut film, count, 12, BoundaryEdges::Kept, &Execution::default()).unwrap();
            let mesh = film.mesh();
            mesh.check().unwrap();
            assert_eq!(measure::flipped_triangles(&mesh), 0);
            assert!((film.area() - 10.0).abs() < 1e-12, "area {}", film.area());
            let reached = film.triangles().len() as f64;
            assert!((reached / count - 1.0).abs() < 0.1, "{reached} for {count}");
            let smallest = measure::angle_range(&mesh).0.to_degrees();
            assert!(smallest > 25.0, "{smallest} for {count}");
            for (&v, &w) in film.boundaries[0].iter().zip(&start.boundaries[0]) {
                assert_eq!(film.vertices[v as usize], start.vertices[w as usize]);
            }
        }
    }

    /// A square of two triangles, whose boundary edges are far longer than the target size.
    fn coarse_square() -> Film {
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        Film::new(corners.to_vec(), &[[0, 1, 2], [0, 2, 3]], vec![vec![0, 1, 2, 3]]).unwrap()
    }

    #[test]
    fn a_coarse_boundary_is_split_where_it_may_be_and_has_larger_triangles_where_not() {
        for (boundary_edges, count, least_angle) in
            [(BoundaryEdges::Refined, 600.0, 25.0), (BoundaryEdges::Kept, 60.0, 7.0)]
        {
            let mut film = coarse_square();
            resample(&mut film, count, 20, boundary_edges, &Execution::default()).unwrap();
            let mesh = film.mesh();
            mesh.check().unwrap();
            assert!((film.area() - 1.0).abs() < 1e-12 && measure::flipped_triangles(&mesh) == 0);
            let reached = film.triangles().len() as f64;
            assert!((reached / count - 1.0).abs() < 0.1, "{boundary_edges:?}: {reached}");
            let smallest = measure::angle_range(&mesh).0.to_degrees();
            assert!(smallest > least_angle, "{boundary_edges:?}: {smallest}");
            let boundary = &film.boundaries[0];
            assert_eq!(boundary.len() == 4, boundary_edges == BoundaryEdges::Kept);
            for (k, &a) in boundary.iter().enumerate() {
                assert!(film.fixed[a as usize] && film.topology.is_boundary(a));
                assert!(film.topology.are_adjacent(a, boundary[(k + 1) % boundary.len()]));
            }
        }
    }
}
