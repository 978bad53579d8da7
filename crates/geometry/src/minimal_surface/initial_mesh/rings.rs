//! Chen, Cai, Zheng, *Constructing Triangular Meshes of Minimal Area*, section 3.4: an initial mesh with an exact number
//! of triangles.
//!
//! 1. One boundary of n points: s = floor((m - n) / 2n) rings of n points on the segments from the boundary points to
//!    their mean, and the mean itself: (2 s + 1) n triangles.
//! 2. The rest, an even number, by splitting triangles of the outer ring into three at their centre.
//!
//! Departures. Two boundaries (their Fig. 9 shows the result, the text leaves the mesh open): rings of as many points as
//! the longer list has, on the bridges of a strip between the two, so that m = n₁ + n₂ + 2 × interior vertices. The
//! triangles to be split are spread evenly over the outer ring (theirs: any).

use super::super::Resolution;
use super::super::film::Film;
use super::strip::Matching;
use crate::{DVec3, Error, Execution, Place, polyline};

/// One or two boundaries, exactly the triangles asked for.
///
/// # Errors
/// [`Error::Input`] naming the resolution if these boundaries cannot have it.
pub(super) fn build(boundaries: &[Vec<DVec3>], resolution: Resolution, exec: &Execution) -> Result<Film, Error> {
    let skeleton = match boundaries {
        [only] => Skeleton::disc(only),
        [first, second] => Skeleton::annulus(first, second),
        _ => return Err(Error::input(Place::field("boundaries"), "rings span one or two boundaries")),
    };
    let interior = skeleton.interior_vertices(resolution)?;
    exec.look(interior as u64)?;
    Ok(skeleton.fill(interior))
}

/// What the rings run along: from each point of the outer loop to its partner further in.
struct Skeleton {
    /// All boundary points, boundary by boundary.
    points: Vec<DVec3>,
    boundaries: Vec<Vec<u32>>,
    /// The boundary whose points the rings repeat.
    outer: usize,
    inner: Inner,
}

enum Inner {
    /// One boundary: its mean.
    Centre(DVec3),
    /// Two: the other one.
    Loop { index: usize, matching: Matching },
}

impl Skeleton {
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

    /// Triangles without any interior vertex: n - 2 for a disc, n for an annulus (Euler).
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
                let least = bare + 2 * self.least_interior() as i64;
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
                // Equilateral triangles of that edge on the mesh without rings.
                let triangles = self.fill(self.least_interior()).area() / (0.75f64.sqrt() / 2.0 * length * length);
                if triangles > f64::from(u32::MAX / 4) {
                    let detail = "so short an edge needs more triangles than can be numbered";
                    return Err(Error::input(place.then("edge_length"), detail));
                }
                Ok((((triangles - bare as f64) / 2.0).round().max(0.0) as usize).max(self.least_interior()))
            }
        }
    }

    fn fill(&self, interior: usize) -> Film {
        let outer = &self.boundaries[self.outer];
        let n = outer.len();
        let rings = (interior - self.least_interior()) / n;
        let mut vertices = self.points.clone();
        let partners: Vec<DVec3> = match &self.inner {
            Inner::Centre(centre) => vec![*centre; n],
            Inner::Loop { index, matching } => {
                let inner = &self.boundaries[*index];
                let at = |j: usize| self.points[inner[matching.order[j]] as usize];
                matching.partners(n).into_iter().map(at).collect()
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

/// Splits `splits` of the first `candidates` triangles (those of the outer ring) into three at their centres, evenly
/// spread; once each has been split, another round over the smaller ones.
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

/// Turns all triangles over if they run against the boundary.
fn orient_along(triangles: &mut [[u32; 3]], boundary: &[u32]) {
    let edge = (boundary[0], boundary[1]);
    let along = triangles.iter().any(|&[a, b, c]| [(a, b), (b, c), (c, a)].contains(&edge));
    if !along {
        triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1));
    }
}
