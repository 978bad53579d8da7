//! Builds initial meshes with well-shaped triangles at a wanted resolution: meshes a plane domain, and maps the mesh
//! into space.
//!
//! 1. The boundaries become polygons in the plane: their projections if these are simple, otherwise circles on which
//!    the points keep their fractions of arc length. Three or more boundaries are seen from a point between them.
//! 2. The domain is meshed with sizes that are graded to the spacing of the boundary
//!    ([`plane_mesh`](super::plane_mesh)). The size is adjusted until the resolution is met.
//! 3. The mesh is mapped into space. A plane boundary needs no map. For a projected boundary the heights are extended
//!    harmonically. Otherwise all coordinates are harmonic; with Delaunay triangles the weights are positive, so
//!    this is a convex combination map (Tutte 1963, Floater 1997).
//! 4. For a fine mesh, a coarse mesh is made in this way and then subdivided regularly.

mod mapping;

use super::domain::Shape;
use super::layout::{GRADING, GRADING_STEP, Goal, Layout, TOLERATED, grading};
use super::pins::{Pin, Pins};
use super::plane_mesh::{PlaneError, PlaneMesh, PlaneRegion};
use super::sampling::{Sampled, sample};
use crate::estimate::estimate;
use crate::harmonic::Dirichlet;
use crate::options::{BoundarySampling, Constraints, LARGEST_COUNT, Options, Resolution};
use glam::DVec2;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::isotropic::resample;
use plateau_mesh::remesh::subdivision::subdivide;
use plateau_mesh::{DVec3, Error, Execution, Place, polyline};

/// A film at a coarse resolution, and the number of subdivisions that lead to the wanted resolution.
#[derive(Clone, Debug)]
pub(crate) struct Start {
    pub film: Film,
    pub subdivisions: u32,
}

impl Start {
    /// The film at its full resolution.
    ///
    /// # Errors
    /// The interruptions of `exec`.
    pub fn refined(self, exec: &Execution) -> Result<Film, Error> {
        let mut film = self.film;
        for _ in 0..self.subdivisions {
            exec.look(4 * film.triangles().len() as u64)?;
            film = subdivide(&film).0;
        }
        Ok(film)
    }
}

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// Largest number of times that the grading is multiplied by [`GRADING_STEP`], which makes it 26. The grading is
/// increased if the spacing of the boundary leads to more triangles than are wanted.
const STEEPEST_GRADING: u32 = 11;
/// Number of triangles per boundary edge in the zone between the boundary and the large triangles inside, times the
/// grading in that zone. Measured on a plane star of 50,000 points. It only decides which grading is tried first.
const GRADED_TRIANGLES: f64 = 2.75;
/// A boundary counts as dense if fewer triangles than this are wanted for each of its points. For a dense boundary the
/// first grading is estimated, because a layout with the least grading has ten times as many triangles as wanted. Also,
/// the triangles at the boundary are taken into account when the next size is chosen. A mesh of so few triangles is not
/// subdivided.
const DENSE: f64 = 3.0;
/// Ratio of the wanted to the reached number of triangles at which the search aims on a dense boundary. It is above 1,
/// because too few triangles are better than too many.
const AIM: f64 = 1.01;
/// Approximate lower bound of the number of triangles of a mesh that is then subdivided. A larger coarse mesh would
/// give more even triangles but take longer.
const COARSE_TRIANGLES: f64 = 450.0;
/// A size is accepted if the wanted number of triangles differs from the reached one by at most this fraction.
const CLOSE_ENOUGH: f64 = 0.02;
/// Least number of triangles of the coarse mesh from which a fine mesh with kept boundary points is made by splitting
/// edges. The coarse mesh has this many triangles, or eight per boundary point if that is more.
const FINEST_MAPPED: usize = 2_000;
/// Number of passes of isotropic remeshing from this coarse mesh to the wanted number of triangles.
const FINE_PASSES: u32 = 12;
/// Largest number of sizes that are tried for one mesh.
const TRIALS: u32 = 10;
/// Number of trials after which an error of twice [`CLOSE_ENOUGH`] is accepted.
const PATIENCE: u32 = 3;
/// Largest number of rounds that add vertices if no size gave enough triangles.
const DENSIFICATIONS: u32 = 4;

/// Why there is no film: the domain has no mesh, or another error that [`Spanning::build`] returns.
enum NoFilm {
    Plane(PlaneError),
    Other(Error),
}

impl From<PlaneError> for NoFilm {
    fn from(error: PlaneError) -> Self {
        Self::Plane(error)
    }
}

impl From<Error> for NoFilm {
    fn from(error: Error) -> Self {
        Self::Other(error)
    }
}

/// Largest number of edges into which all fixed curves together are divided. It bounds the time, because the whole film
/// is searched for the place of each end.
const MOST_PINS: f64 = 2e4;

static NO_CONSTRAINTS: Constraints = Constraints { points: Vec::new(), polylines: Vec::new(), ends: Vec::new() };

/// The constraints, and the positions of their vertices in the plane.
#[derive(Clone, Debug, Default)]
struct Pinned {
    pins: Pins,
    places: Vec<DVec2>,
}

/// A layout with its mesh.
struct Meshed {
    boundaries: Vec<Sampled>,
    domain: PlaneRegion,
    plane: PlaneMesh,
}

/// Meshes the boundaries with one shape of domain.
pub(super) struct Spanning<'a> {
    pub boundaries: &'a [Vec<DVec3>],
    pub shape: Shape,
    pub constraints: &'a Constraints,
    pub options: &'a Options,
    pub exec: &'a Execution<'a>,
}

impl Spanning<'_> {
    /// Returns the film, or the reason why the domain has no mesh. The outer error is one that ends the whole search.
    pub fn build(&self) -> Result<Result<Start, PlaneError>, Error> {
        match self.try_build() {
            Ok(start) => Ok(Ok(start)),
            Err(NoFilm::Plane(PlaneError::Interrupted(interruption))) => Err(interruption.into()),
            Err(NoFilm::Plane(error)) => Ok(Err(error)),
            Err(NoFilm::Other(error)) => Err(error),
        }
    }

    fn try_build(&self) -> Result<Start, NoFilm> {
        if let Some(resolution) = self.resolution_in_space()? {
            let options = Options { resolution, ..self.options.clone() };
            return Spanning { options: &options, shape: self.shape.clone(), ..*self }.try_build();
        }
        let pinned = self.pinned()?;
        let (meshed, subdivisions) = match self.fit(&pinned) {
            // Beside a short segment a long one gets points at every size. The boundary's own points alone may do.
            Err(PlaneError::TooCoarse { .. }) if self.options.boundary_sampling == BoundarySampling::Refine => {
                let options = Options { boundary_sampling: BoundarySampling::Keep, ..self.options.clone() };
                return Spanning { options: &options, shape: self.shape.clone(), ..*self }.try_build();
            }
            fitted => fitted?,
        };
        let (mut film, _) = self.carry(&meshed, &pinned)?;
        self.even_out(&mut film)?;
        if self.resolution() != self.options.resolution {
            let count = self.goal().triangles(&film);
            resample(&mut film, count, FINE_PASSES, self.options.boundary_edges(), self.exec).map_err(Error::from)?;
        }
        Ok(Start { film, subdivisions })
    }

    /// Converts a wanted edge length into a number of triangles if the domain is mapped into space. A coarse film is
    /// built for this, because the area in space is not known before. `None` for a plane domain or another kind of
    /// resolution.
    fn resolution_in_space(&self) -> Result<Option<Resolution>, NoFilm> {
        if !self.shape.is_mapped() || !matches!(self.options.resolution, Resolution::EdgeLength(_)) {
            return Ok(None);
        }
        let boundary: usize = self.boundaries.iter().map(Vec::len).sum();
        let resolution = Resolution::Triangles(FINEST_MAPPED.max(8 * boundary));
        let coarse = Options { resolution, boundary_sampling: BoundarySampling::Keep, ..self.options.clone() };
        let film = self.unpinned(&coarse).try_build()?.film;
        let count = Goal { resolution: self.options.resolution, euler: 0 }.triangles(&film);
        if count > LARGEST_COUNT as f64 {
            return Err(PlaneError::TooManyPoints.into());
        }
        // The spacing of the boundary may require more triangles than the edge length.
        let least = self.unpinned(self.options).layout(self.largest_size(), GRADING, &Pinned::default())?.triangles;
        Ok(Some(Resolution::Triangles((count.round() as usize).max(least))))
    }

    /// The same problem with other options and without constraints.
    fn unpinned<'b>(&'b self, options: &'b Options) -> Spanning<'b> {
        Spanning { options, shape: self.shape.clone(), constraints: &NO_CONSTRAINTS, ..*self }
    }

    /// Converts the constraints to vertices and edges, and finds their places in the plane.
    fn pinned(&self) -> Result<Pinned, NoFilm> {
        if self.constraints.is_empty() {
            return Ok(Pinned::default());
        }
        let mapped = match &self.shape {
            Shape::Plane(_) => None,
            Shape::Disc { .. } | Shape::Sphere(_) => {
                let boundary: usize = self.boundaries.iter().map(Vec::len).sum();
                let resolution = Resolution::Triangles(FINEST_MAPPED.max(8 * boundary));
                let coarse = Options { resolution, boundary_sampling: BoundarySampling::Keep, ..self.options.clone() };
                let spanning = self.unpinned(&coarse);
                let (meshed, _) = spanning.fit(&Pinned::default())?;
                let (mut film, flat) = spanning.carry(&meshed, &Pinned::default())?;
                // A few solves with the same connectivity bring the mesh near the film in which the constraints lie.
                if let Ok(mut dirichlet) = Dirichlet::new(&film) {
                    let _ = (0..3).try_for_each(|_| dirichlet.step(&mut film));
                }
                Some((film, flat))
            }
        };
        let wanted = match self.options.resolution {
            Resolution::Triangles(count) => count as f64,
            Resolution::InteriorVertices(count) => 2.0 * count as f64,
            Resolution::EdgeLength(_) => f64::INFINITY,
        };
        let size = match self.options.resolution {
            Resolution::EdgeLength(length) => length,
            _ => 2.0 * self.radius() / wanted.clamp(16.0, 4.0 * COARSE_TRIANGLES).sqrt(),
        };
        self.check_lengths(size)?;
        let pins = Pins::new(self.constraints, self.boundaries, size, self.options.boundary_sampling);
        let places = pins.in_plane(&self.shape, mapped.as_ref(), self.exec).map_err(Error::from)?;
        Ok(Pinned { pins, places })
    }

    /// Refuses curves that would be divided into more pieces than the film can have triangles. A single distant point
    /// can make a curve too long.
    fn check_lengths(&self, size: f64) -> Result<(), NoFilm> {
        if self.options.boundary_sampling == BoundarySampling::Keep {
            return Ok(());
        }
        let most = estimate(self.boundaries, self.options).triangles.clamp(1e3, MOST_PINS);
        let mut pieces = 0.0;
        for (k, curve) in self.constraints.polylines.iter().enumerate() {
            pieces += polyline::length(curve, false) / size;
            if pieces > most {
                let detail =
                    format!("too long for this film: more than {most:.0} edges of {size:.3e} with those before it");
                return Err(NoFilm::Other(Error::input(Place::field("constraints").then("polylines").at(k), detail)));
            }
        }
        Ok(())
    }

    fn radius(&self) -> f64 {
        self.boundaries.iter().flatten().map(|p| p.length()).fold(0.0, f64::max)
    }

    /// Number of lattice points above which a layout is given up. It exceeds the wanted number of triangles, because
    /// many points may lie in the rectangle around the boundary but outside the boundary (a thin diagonal strip). It is
    /// bounded, because a spike in the boundary may be a million times longer than the rest.
    fn largest_lattice(&self) -> usize {
        let boundary: usize = self.boundaries.iter().map(Vec::len).sum();
        let asked = estimate(self.boundaries, self.options).triangles + boundary as f64;
        // Boundaries that are mapped to circles leave little of the rectangle outside.
        let outside = if self.shape.is_mapped() { 5e4 } else { 1e6 };
        (64.0 * asked + outside).min(LARGEST_COUNT as f64) as usize
    }

    fn goal(&self) -> Goal {
        Goal { resolution: self.options.resolution, euler: 2 - self.boundaries.len() as i64 }
    }

    /// The resolution of the mesh in the plane. A mesh whose boundary must be kept cannot be subdivided. If it has to
    /// be fine, a coarse mesh is made and improved first, and its edges are split afterwards.
    fn resolution(&self) -> Resolution {
        let boundary: usize = self.boundaries.iter().map(Vec::len).sum();
        let coarse = FINEST_MAPPED.max(8 * boundary);
        let fine = match self.options.resolution {
            Resolution::Triangles(count) => count > 2 * coarse,
            Resolution::InteriorVertices(count) => count > coarse,
            Resolution::EdgeLength(_) => false,
        };
        if fine && self.options.boundary_sampling == BoundarySampling::Keep {
            Resolution::Triangles(coarse)
        } else {
            self.options.resolution
        }
    }

    /// Makes the plane mesh with the size and the number of subdivisions that come nearest to the resolution.
    fn fit(&self, pinned: &Pinned) -> Result<(Meshed, u32), PlaneError> {
        let goal = Goal { resolution: self.resolution(), ..self.goal() };
        // At the largest size only the spacing of the boundary counts. A coarser mesh is possible only with a larger
        // grading.
        let mut step = self.first_grading_step(goal.resolution);
        let mut coarsest = self.layout(self.largest_size(), grading(step), pinned)?;
        if !matches!(self.shape, Shape::Disc { .. }) {
            coarsest.domain.check_simple()?;
        }
        // Only the area in the plane is known yet. The area in space is about this area over the squared scale.
        let area = coarsest.domain.area() / (coarsest.scale * coarsest.scale);
        let triangle = 0.75f64.sqrt() / 2.0;
        let wanted = match goal.resolution {
            Resolution::Triangles(count) => count as f64,
            Resolution::InteriorVertices(count) => 2.0 * count as f64,
            Resolution::EdgeLength(length) => area / (triangle * length * length),
        };
        if wanted > LARGEST_COUNT as f64 {
            return Err(PlaneError::TooManyPoints);
        }
        let mut subdivisions = match self.options.boundary_sampling {
            BoundarySampling::Keep => 0,
            BoundarySampling::Refine => (0.5 * libm::log2(wanted / COARSE_TRIANGLES)).floor().max(0.0) as u32,
        };
        while subdivisions > 0 && goal.shortfall(&coarsest, subdivisions) < 1.0 {
            subdivisions -= 1;
        }
        // If the spacing of the boundary does not allow an edge length, the edge length is met where possible. A number
        // of triangles must be met.
        let by_number = !matches!(goal.resolution, Resolution::EdgeLength(_));
        let estimated = step;
        while by_number && goal.shortfall(&coarsest, subdivisions) < 1.0 && step < STEEPEST_GRADING {
            step += 1;
            coarsest = self.layout(self.largest_size(), grading(step), pinned)?;
        }
        // At most `estimated` passes, because each pass that does not end the loop lowers the step by one.
        while step > 0 && step <= estimated {
            let layout = self.layout(self.largest_size(), grading(step - 1), pinned)?;
            if goal.shortfall(&layout, subdivisions) < 1.0 {
                break;
            }
            (step, coarsest) = (step - 1, layout);
        }
        let shortfall = goal.shortfall(&coarsest, subdivisions);
        if by_number && shortfall < 1.0 - TOLERATED {
            return Err(PlaneError::TooCoarse { triangles: coarsest.triangles });
        }
        let (layout, shortfall) = if shortfall <= 1.0 + CLOSE_ENOUGH {
            (coarsest, shortfall)
        } else {
            let first = (area / (triangle * wanted)).sqrt() * 2f64.powi(subdivisions as i32);
            self.tune(&goal, first, (grading(step), shortfall), subdivisions, pinned)?
        };
        let Layout { boundaries, domain, sites, triangles, .. } = layout;
        let mut plane = domain.mesh(&sites, self.exec)?;
        // New vertices must keep a distance from each other, so one round may not be enough.
        for _ in 0..DENSIFICATIONS {
            let reached = plane.topology.triangles().len() as f64;
            let missing = (shortfall * triangles as f64 / reached).min(2.0) - 1.0;
            if missing <= CLOSE_ENOUGH {
                break;
            }
            plane = domain.densified(&plane, (0.5 * missing * reached).round() as usize, self.exec)?;
        }
        Ok((Meshed { boundaries, domain, plane }, subdivisions))
    }

    /// Adjusts the size until the resolution is met. Returns the layout, and its ratio of the wanted to the reached
    /// number of triangles. `first` is the first size to try. `coarsest` holds the grading, and the ratio at the
    /// largest size.
    fn tune(
        &self,
        goal: &Goal,
        first: f64,
        coarsest: (f64, f64),
        subdivisions: u32,
        pinned: &Pinned,
    ) -> Result<(Layout, f64), PlaneError> {
        let (grading, at_largest) = coarsest;
        let largest = self.largest_size();
        let mut size = first.min(0.9 * largest);
        // Logarithms of sizes and of their ratios: `low` has too many triangles, `high` has too few.
        let (mut low, mut high): (Option<(f64, f64)>, _) = (None, (libm::log(largest), libm::log(at_largest)));
        let mut best: Option<(Layout, f64)> = None;
        for trial in 0..TRIALS {
            let layout = self.layout(size, grading, pinned)?;
            let shortfall = goal.shortfall(&layout, subdivisions);
            // Too few triangles are better than the same number too many, because vertices can be added.
            let distance = |shortfall: f64| match shortfall {
                ..0.92 => 2.0 / shortfall,
                ..1.0 => 2.0 / shortfall - 2.0,
                _ => shortfall - 1.0,
            };
            if best.as_ref().is_none_or(|(_, nearest)| distance(shortfall) < distance(*nearest)) {
                best = Some((layout, shortfall));
            }
            // The number of lattice points beside the boundary jumps with the size, so the last percent is worth only a
            // few trials.
            if (shortfall - 1.0).abs() <= if trial < PATIENCE { CLOSE_ENOUGH } else { 2.0 * CLOSE_ENOUGH } {
                break;
            }
            let here = (libm::log(size), libm::log(shortfall));
            if shortfall < 1.0 {
                low = Some(here);
            } else {
                high = here;
            }
            // The number of triangles decreases with the square of the size, or more slowly if the spacing of the
            // boundary decides. Above some size it is constant, so the largest size is not used for interpolation.
            let square = here.0 - 0.5 * here.1;
            size = libm::exp(match low {
                None => square,
                Some(_) if high.0 == libm::log(largest) && self.is_dense(goal.resolution) => {
                    // The number of triangles due to the spacing of the boundary does not depend on the size.
                    let inside = |shortfall: f64| 1.0 / shortfall - 1.0 / at_largest;
                    let ratio = inside(shortfall) / inside(AIM);
                    (here.0 + 0.5 * libm::log(ratio)).max(here.0 + 0.05).min(0.5 * (here.0 + high.0))
                }
                Some(_) if high.0 == libm::log(largest) => square.max(here.0 + 0.05).min(0.5 * (here.0 + high.0)),
                Some(low) => {
                    let secant = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
                    let room = 0.15 * (high.0 - low.0);
                    secant.max(low.0 + room).min(high.0 - room)
                }
            });
        }
        Ok(best.expect("at least one layout was tried"))
    }

    /// Number of [`GRADING_STEP`]s of the grading that is tried first. On a dense boundary, a smaller grading makes a
    /// larger layout, so the search starts near the grading that is needed.
    fn first_grading_step(&self, resolution: Resolution) -> u32 {
        let Resolution::Triangles(count) = resolution else { return 0 };
        if !self.is_dense(resolution) {
            return 0;
        }
        let room = (count as f64 / self.points() - 1.0).max(0.0);
        let steps = (libm::log(GRADED_TRIANGLES / (room * GRADING)) / libm::log(GRADING_STEP)).floor();
        steps.clamp(0.0, f64::from(STEEPEST_GRADING)) as u32
    }

    fn points(&self) -> f64 {
        self.boundaries.iter().map(Vec::len).sum::<usize>() as f64
    }

    fn is_dense(&self, resolution: Resolution) -> bool {
        matches!(resolution, Resolution::Triangles(count) if (count as f64) < DENSE * self.points())
    }

    fn largest_size(&self) -> f64 {
        self.boundaries.iter().map(|points| polyline::length(points, true)).sum()
    }

    /// Makes the layout for a size, without triangulating it.
    fn layout(&self, size: f64, grading: f64, pinned: &Pinned) -> Result<Layout, PlaneError> {
        let sampling = self.options.boundary_sampling;
        let boundaries: Vec<Sampled> =
            self.boundaries.iter().map(|points| sample(points, size, GRADING, sampling)).collect();
        let own: Vec<u32> = boundaries
            .iter()
            .flat_map(|boundary| &boundary.own)
            .enumerate()
            .filter(|(_, own)| **own)
            .map(|(k, _)| k as u32)
            .collect();
        let first = boundaries.iter().map(|boundary| boundary.points.len() as u32).sum::<u32>();
        let vertex = |pin: Pin| match pin {
            Pin::Boundary(k) => own[k as usize],
            Pin::Inner(k) => first + k,
        };
        let domain = PlaneRegion {
            loops: self.shape.embed(&boundaries),
            points: pinned.places.clone(),
            segments: pinned.pins.edges.iter().map(|edge| edge.map(vertex)).collect(),
        };
        let scale = self.shape.scale(self.boundaries);
        // The lattice starts from the largest size in the plane. If the scale is the same everywhere, its spacing
        // therefore follows the size without jumps.
        let largest = domain.loops.iter().flatten().map(|&p| scale(p)).fold(0.0, f64::max);
        let sites = domain.sites(&|p| size * scale(p), size * largest, grading, self.largest_lattice(), self.exec)?;
        let mean_scale = sites.iter().map(|&p| scale(p)).sum::<f64>() / sites.len() as f64;
        // Euler's formula for one connected domain, whose Euler characteristic is 2 minus the number of loops. A domain
        // of several components has a few triangles fewer.
        let euler = 2 - boundaries.len() as i64;
        let triangles = (2 * sites.len() as i64 - i64::from(first) - 2 * euler).max(1) as usize;
        let mean_edge = match self.options.resolution {
            Resolution::EdgeLength(_) => domain.mean_edge(&sites)? / mean_scale,
            _ => 0.0,
        };
        Ok(Layout { boundaries, domain, sites, triangles, mean_edge, scale: mean_scale })
    }
}
