//! Chen, Cai, Zheng, *Constructing Triangular Meshes of Minimal Area*, section 3.4: an initial mesh with an exact
//! number m of triangles.
//!
//! 1. For one boundary of n points: s = floor((m - n) / 2n) rings of n points on the segments from the boundary points
//!    to their mean, and the mean itself. These give (2 s + 1) n triangles.
//! 2. The remaining triangles, an even number, come from splitting triangles of the outer ring into three at their
//!    centre.
//!
//! Departures from the paper:
//! - Two boundaries: the paper's Fig. 9 shows the result, but the text does not describe the mesh. Here the rings
//!   have as many points as the longer boundary. The points lie on the bridges of a strip between the two boundaries.
//!   Thus m = n₁ + n₂ + 2 × interior vertices.
//! - The triangles that are split are spread evenly over the outer ring. In the paper any of them are split.
//! - A triangle without a vertex inside is accepted, although the paper always has the mean.
//! - With `refine` the boundary is first sampled as finely as the mesh, and a wanted number of triangles whose parity
//!   is impossible is raised by one.

use super::sampling::{Sampled, numbers, sample};
use super::strip::Matching;
use crate::options::{BoundarySampling, LARGEST_COUNT, Options, Resolution};
use plateau_mesh::edit::orient_along;
use plateau_mesh::film::Film;
use plateau_mesh::{DVec3, Error, Execution, Interruption, Place, polyline};

/// Builds rings over one or two boundaries. If the points of the boundary are kept, the number of triangles is exactly
/// the wanted one.
///
/// # Errors
/// [`Error::Input`] naming the resolution if these boundaries cannot have it.
pub(super) fn build(boundaries: &[Vec<DVec3>], options: &Options, exec: &Execution) -> Result<Film, Error> {
    if options.boundary_sampling == BoundarySampling::Keep {
        let skeleton = Skeleton::of(boundaries)?;
        let interior = skeleton.interior_vertices(options.resolution)?;
        exec.look(interior as u64)?;
        return Ok(skeleton.fill(interior));
    }
    let coarse = Skeleton::of(boundaries)?;
    let area = coarse.fill(coarse.least_interior()).area();
    let triangle = 0.75f64.sqrt() / 2.0;
    let size = match options.resolution {
        Resolution::EdgeLength(length) => length,
        Resolution::Triangles(count) => (area / (triangle * count.max(1) as f64)).sqrt(),
        Resolution::InteriorVertices(count) => (area / (triangle * 2.0 * count.max(1) as f64)).sqrt(),
    };
    coarse.check_size(size, area)?;
    let sampled = sampled(boundaries, size, options.resolution, exec)?;
    let refined: Vec<Vec<DVec3>> = sampled.iter().map(|boundary| boundary.points.clone()).collect();
    let skeleton = Skeleton::of(&refined)?;
    let resolution = match options.resolution {
        Resolution::Triangles(count) => Resolution::Triangles(count + (count + skeleton.points.len()) % 2),
        other => other,
    };
    let interior = skeleton.interior_vertices(resolution)?;
    exec.look(interior as u64)?;
    Ok(renumbered(&skeleton.fill(interior), &numbers(&sampled)))
}

/// Samples the boundaries with pieces of length `size`. If a number of triangles is wanted, the pieces are made longer
/// until there are no more points than triangles: in a narrow strip, the length that follows from the area is too
/// short.
///
/// # Errors
/// The interruptions of `exec`.
fn sampled(
    boundaries: &[Vec<DVec3>],
    size: f64,
    resolution: Resolution,
    exec: &Execution,
) -> Result<Vec<Sampled>, Interruption> {
    let with_size = |size: f64, sampling: BoundarySampling| -> Vec<Sampled> {
        boundaries.iter().map(|points| sample(points, size, GRADING, sampling)).collect()
    };
    let longest_of = |points: &Vec<DVec3>| -> f64 {
        (0..points.len()).map(|k| points[k].distance(points[(k + 1) % points.len()])).fold(0.0, f64::max)
    };
    let longest = boundaries.iter().map(longest_of).fold(0.0, f64::max);
    let mut size = size;
    // At most log(WITHOUT_INFLUENCE × longest / size) / log(1.1) + 2 rounds, because each round multiplies the size by
    // at least 1.1.
    loop {
        let sampled = with_size(size, BoundarySampling::Refine);
        let points: usize = sampled.iter().map(|boundary| boundary.points.len()).sum();
        exec.look(points as u64)?;
        let added = sampled.iter().flat_map(|boundary| &boundary.own).any(|own| !own);
        match resolution {
            // At this size only the grading beside short segments still adds points, so a larger size would not help.
            Resolution::Triangles(count) if added && points > count && size > WITHOUT_INFLUENCE * longest => {
                return Ok(with_size(size, BoundarySampling::Keep));
            }
            Resolution::Triangles(count) if added && points > count => {
                size *= 1.1 * points as f64 / count.max(1) as f64
            }
            _ => return Ok(sampled),
        }
    }
}

/// Whether two boundaries are so close together that a strip of single triangles between them meets the resolution. A
/// mesh of equilateral triangles would need many more.
pub(super) fn is_narrow(first: &[DVec3], second: &[DVec3], resolution: Resolution) -> bool {
    let length = polyline::length(first, true) + polyline::length(second, true);
    let edge = match resolution {
        Resolution::Triangles(count) => length / count.max(1) as f64,
        Resolution::InteriorVertices(count) => length / (2 * count.max(1)) as f64,
        Resolution::EdgeLength(edge) => edge,
    };
    let matching = Matching::between(first, second);
    // Distances are measured to the sides, because half of the bridges are diagonals, whose length does not vanish with
    // the gap.
    let mut gaps = vec![f64::INFINITY; first.len() + second.len()];
    let (n, m) = (first.len(), second.len());
    for &(i, j) in &matching.bridges {
        let (i, j) = (i % n, j % m);
        let opposite = |j: usize| second[matching.order[j % m]];
        let from_first = to_sides(first[i], [opposite(j + m - 1), opposite(j), opposite(j + 1)]);
        let from_second = to_sides(opposite(j), [first[(i + n - 1) % n], first[i], first[(i + 1) % n]]);
        gaps[i] = gaps[i].min(from_first);
        gaps[n + j] = gaps[n + j].min(from_second);
    }
    gaps.iter().sum::<f64>() / (gaps.len() as f64) < NARROW * edge
}

/// Distance of a point from two sides that meet at `corner`.
fn to_sides(point: DVec3, [before, corner, after]: [DVec3; 3]) -> f64 {
    let to = |end: DVec3| {
        let side = end - corner;
        let along = (point - corner).dot(side) / side.length_squared();
        point.distance(corner + along.clamp(0.0, 1.0) * side)
    };
    to(before).min(to(after))
}

/// Builds rings in a narrow strip. A wanted number of triangles is raised to the next number that rings can have.
///
/// # Errors
/// The errors of [`build`].
pub(super) fn build_narrow(boundaries: &[Vec<DVec3>], options: &Options, exec: &Execution) -> Result<Film, Error> {
    let points: usize = boundaries.iter().map(Vec::len).sum();
    let resolution = match options.resolution {
        Resolution::Triangles(count) => Resolution::Triangles((count + (count + points) % 2).max(points)),
        other => other,
    };
    build(boundaries, &Options { resolution, ..options.clone() }, exec)
}

/// Checks that rings on these boundaries can have this resolution.
///
/// # Errors
/// [`Error::Input`] naming the resolution, or the initial mesh if there are more than two boundaries.
pub(super) fn check(boundaries: &[Vec<DVec3>], resolution: Resolution) -> Result<(), Error> {
    Skeleton::of(boundaries)?.interior_vertices(resolution).map(drop)
}

/// Mean distance between two boundaries below which the strip between them counts as narrow, as a fraction of the edge
/// length of a strip of single triangles.
const NARROW: f64 = 1.0;

/// Largest increase of the length of boundary pieces per distance along the boundary.
const GRADING: f64 = 0.3;

/// Multiple of the longest segment above which a size has no influence, because with [`GRADING`] the sizes of
/// [`sample`] stay below 1.3 of that segment.
const WITHOUT_INFLUENCE: f64 = 2.0;

/// Renumbers the first vertices of the film: vertex v becomes `numbers[v]`.
fn renumbered(film: &Film, numbers: &[u32]) -> Film {
    let place = |v: u32| numbers.get(v as usize).copied().unwrap_or(v);
    let mut vertices = film.vertices.clone();
    film.vertices.iter().enumerate().for_each(|(v, &p)| vertices[place(v as u32) as usize] = p);
    let triangles: Vec<[u32; 3]> = film.triangles().iter().map(|triangle| triangle.map(place)).collect();
    let boundaries = film.boundaries.iter().map(|boundary| boundary.iter().map(|&v| place(v)).collect()).collect();
    Film::new(vertices, &triangles, boundaries).expect("renaming keeps a manifold")
}

/// The paths on which the vertices of the rings lie: from each point of the outer loop to its partner on the inner
/// loop, or to the centre.
struct Skeleton {
    /// All boundary points, boundary by boundary.
    points: Vec<DVec3>,
    boundaries: Vec<Vec<u32>>,
    /// The boundary that determines the number of points of each ring.
    outer: usize,
    inner: Inner,
}

enum Inner {
    /// The mean of the boundary's points, if there is one boundary.
    Centre(DVec3),
    /// The boundary that is not the outer one, if there are two.
    Loop { index: usize, matching: Matching },
}

impl Skeleton {
    fn of(boundaries: &[Vec<DVec3>]) -> Result<Self, Error> {
        match boundaries {
            [only] => Ok(Self::disc(only)),
            [first, second] => Ok(Self::annulus(first, second)),
            _ => Err(Error::input(
                Place::field("initial_mesh"),
                "rings span one or two boundaries, because each ring runs from one boundary to one other; auto, disk and planar \
                 span more",
            )),
        }
    }

    fn disc(boundary: &[DVec3]) -> Self {
        Self {
            points: boundary.to_vec(),
            boundaries: vec![(0..boundary.len() as u32).collect()],
            outer: 0,
            inner: Inner::Centre(polyline::mean(boundary)),
        }
    }

    fn annulus(first: &[DVec3], second: &[DVec3]) -> Self {
        let outer = usize::from(second.len() > first.len());
        let loops = [first, second];
        let matching = Matching::between(loops[outer], loops[1 - outer]);
        let (n, all) = (first.len() as u32, (first.len() + second.len()) as u32);
        Self {
            points: loops.concat(),
            boundaries: vec![(0..n).collect(), (n..all).collect()],
            outer,
            inner: Inner::Loop { index: 1 - outer, matching },
        }
    }

    /// Number of triangles without an interior vertex: n - 2 for a disc, n for an annulus (Euler).
    fn bare_triangles(&self) -> i64 {
        let n = self.points.len() as i64;
        if matches!(self.inner, Inner::Centre(_)) { n - 2 } else { n }
    }

    fn least_interior(&self) -> usize {
        usize::from(matches!(self.inner, Inner::Centre(_)))
    }

    fn interior_vertices(&self, resolution: Resolution) -> Result<usize, Error> {
        let place = Place::field("resolution");
        let bare = self.bare_triangles();
        match resolution {
            Resolution::InteriorVertices(count) if count < self.least_interior() => {
                Err(Error::input(place.then("interior_vertices"), "rings need at least one interior vertex"))
            }
            Resolution::InteriorVertices(count) => Ok(count),
            Resolution::Triangles(count) => {
                // A triangle is its own mesh, without the mean of its corners.
                let least = if bare == 1 { 1 } else { bare + 2 * self.least_interior() as i64 };
                let count = i64::try_from(count).unwrap_or(i64::MAX);
                if count < least || (count - bare) % 2 != 0 {
                    let parity = if bare % 2 == 0 { "even" } else { "odd" };
                    let detail = format!(
                        "with {} boundary points the number of triangles must be {parity} and at least {least}",
                        self.points.len()
                    );
                    return Err(Error::input(place.then("triangles"), detail));
                }
                Ok(((count - bare) / 2) as usize)
            }
            Resolution::EdgeLength(length) => {
                let area = self.fill(self.least_interior()).area();
                self.check_size(length, area)?;
                let triangles = area / (0.75f64.sqrt() / 2.0 * length * length);
                Ok((((triangles - bare as f64) / 2.0).round().max(0.0) as usize).max(self.least_interior()))
            }
        }
    }

    /// Refuses an edge length that would give more triangles than can be numbered.
    fn check_size(&self, size: f64, area: f64) -> Result<(), Error> {
        let boundary: f64 = self.points.len() as f64;
        if area / (size * size) + boundary > LARGEST_COUNT as f64 {
            let detail = "so fine a mesh has more triangles than can be numbered";
            return Err(Error::input(Place::field("resolution"), detail));
        }
        Ok(())
    }

    /// Builds the rings. Without an interior vertex the boundary must be a triangle or the two of an annulus.
    fn fill(&self, interior: usize) -> Film {
        if interior < self.least_interior() {
            return Film::new(self.points.clone(), &[[0, 1, 2]], self.boundaries.clone()).expect("a triangle");
        }
        let outer = &self.boundaries[self.outer];
        let n = outer.len();
        let rings = (interior - self.least_interior()) / n;
        let mut vertices = self.points.clone();
        let partners: Vec<DVec3> = match &self.inner {
            Inner::Centre(centre) => vec![*centre; n],
            Inner::Loop { index, matching } => {
                let inner = &self.boundaries[*index];
                let partner = |j: usize| self.points[inner[matching.order[j]] as usize];
                matching.partners(n).into_iter().map(partner).collect()
            }
        };
        let mut ring = outer.clone();
        let mut triangles = Vec::new();
        for j in 1..=rings {
            let part = j as f64 / (rings + 1) as f64;
            let first = vertices.len() as u32;
            vertices.extend((0..n).map(|i| self.points[outer[i] as usize].lerp(partners[i], part)));
            for i in 0..n {
                let (a, b) = (ring[i], ring[(i + 1) % n]);
                let (c, d) = (first + ((i + 1) % n) as u32, first + i as u32);
                triangles.extend([[a, b, c], [a, c, d]]);
            }
            ring = (first..first + n as u32).collect();
        }
        match &self.inner {
            Inner::Centre(centre) => {
                let apex = vertices.len() as u32;
                vertices.push(*centre);
                triangles.extend((0..n).map(|i| [ring[i], ring[(i + 1) % n], apex]));
            }
            Inner::Loop { index, matching } => {
                triangles.extend(matching.triangles(&ring, &self.boundaries[*index]));
            }
        }
        let splits = interior - self.least_interior() - rings * n;
        split_evenly(&mut vertices, &mut triangles, if rings > 0 { 2 * n } else { n }, splits);
        if self.outer != 0 {
            orient_along(&mut triangles, &self.boundaries[0]);
        }
        Film::new(vertices, &triangles, self.boundaries.clone()).expect("rings are a manifold by construction")
    }
}

/// Splits `splits` of the first `candidates` triangles into three at their centres, evenly spread. The first triangles
/// are those of the outer ring.
fn split_evenly(vertices: &mut Vec<DVec3>, triangles: &mut Vec<[u32; 3]>, candidates: usize, splits: usize) {
    for k in 0..splits {
        let t = k * candidates / splits.max(1);
        let [a, b, c] = triangles[t];
        let centre = vertices.len() as u32;
        vertices.push((vertices[a as usize] + vertices[b as usize] + vertices[c as usize]) / 3.0);
        triangles[t] = [a, b, centre];
        triangles.extend([[b, c, centre], [c, a, centre]]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Input: a square with a short side. The grading adds points beside that side at any size, so that longer pieces
    /// alone never bring the number of points below the limit.
    #[test]
    fn a_triangle_is_its_own_mesh_if_one_triangle_is_wanted() {
        let corners = vec![vec![DVec3::ZERO, DVec3::X, DVec3::new(0.0, 1.0, 0.5)]];
        for sampling in [BoundarySampling::Keep, BoundarySampling::Refine] {
            let mut options = Options::new(Resolution::Triangles(1));
            options.boundary_sampling = sampling;
            let film = build(&corners, &options, &Execution::default()).unwrap();
            assert_eq!((film.triangles().len(), film.vertices.len()), (1, 3));
        }
    }

    #[test]
    fn a_boundary_keeps_its_own_points_if_every_size_adds_too_many() {
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.01, 1.0), (0.0, 1.0)];
        let square = vec![corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec()];
        let points = |count: usize| {
            let sampled = sampled(&square, 0.3, Resolution::Triangles(count), &Execution::default()).unwrap();
            sampled[0].points.len()
        };
        assert_eq!(points(10), 5);
        assert!((6..=30).contains(&points(30)), "{}", points(30));
    }
}
