//! Step 3 of the initial mesh: maps the plane mesh into space, and evens out its triangles there.

use super::{Meshed, Pinned, Spanning};
use crate::harmonic::Dirichlet;
use crate::initial_mesh::domain::{Shape, largest_height};
use crate::initial_mesh::harmonic_map::harmonic;
use crate::initial_mesh::layout::TOLERATED;
use crate::initial_mesh::plane_mesh::PlaneMesh;
use crate::initial_mesh::sampling::numbers;
use glam::DVec2;
use plateau_mesh::edit::orient_along;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::delaunay::{flip_to_delaunay, tangential_relaxation};
use plateau_mesh::remesh::isotropic::{RUNAWAY, resample};
use plateau_mesh::topology::Topology;
use plateau_mesh::{DVec3, Error, measure};

/// Largest number of rounds of solving and isotropic remeshing that improve a mesh after it was mapped into space.
const ROUNDS: u32 = 8;
/// The area counts as settled if it is above this fraction of the area of the round before.
const SETTLED_AREA: f64 = 0.998;
/// A projected mesh is not remeshed if its smallest angle (in radians) is at least this.
const GOOD_ANGLE: f64 = 0.44;
/// Largest number of triangles of a mesh that is remeshed. Larger meshes are only relaxed, because remeshing takes
/// longer.
const LARGEST_RESAMPLED: f64 = 20_000.0;

impl Spanning<'_> {
    /// Maps a plane mesh into space and orders its vertices: the points of the polygons, then the added points, then
    /// the fixed points inside, then the rest. Also returns the positions in the plane in that order.
    pub(super) fn carry(&self, meshed: &Meshed, pinned: &Pinned) -> Result<(Film, Vec<DVec2>), Error> {
        let PlaneMesh { points, topology } = &meshed.plane;
        let boundary: usize = meshed.boundaries.iter().map(|boundary| boundary.points.len()).sum();
        let mut place = numbers(&meshed.boundaries);
        place.extend(boundary as u32..points.len() as u32);
        let mut in_plane = vec![DVec2::ZERO; points.len()];
        points.iter().zip(&place).for_each(|(&p, &v)| in_plane[v as usize] = p);
        let mut vertices = vec![DVec3::ZERO; points.len()];
        let in_space = meshed.boundaries.iter().flat_map(|boundary| &boundary.points);
        in_space.zip(&place).for_each(|(&p, &v)| vertices[v as usize] = p);
        vertices[boundary..boundary + pinned.pins.points.len()].copy_from_slice(&pinned.pins.points);
        let mut triangles: Vec<[u32; 3]> =
            topology.triangles().iter().map(|triangle| triangle.map(|v| place[v as usize])).collect();
        let mut first = 0;
        let loops: Vec<Vec<u32>> = meshed
            .boundaries
            .iter()
            .map(|boundary| {
                let range = first..first + boundary.points.len();
                first = range.end;
                place[range].to_vec()
            })
            .collect();
        let fixed: Vec<bool> = (0..points.len()).map(|v| v < boundary + pinned.pins.points.len()).collect();
        let mut locked: Vec<[u32; 2]> = meshed
            .domain
            .segments
            .iter()
            .map(|segment| {
                let [a, b] = segment.map(|v| place[v as usize]);
                [a.min(b), a.max(b)]
            })
            .collect();
        locked.sort_unstable();
        locked.dedup();
        self.lift(&in_plane, &triangles, &fixed, &mut vertices)?;
        orient_along(&mut triangles, &loops[0]);
        let topology = Topology::build(&triangles, vertices.len()).expect("renaming keeps a manifold");
        Ok((Film { vertices, topology, fixed, locked, boundaries: loops }, in_plane))
    }

    /// Improves a film whose map from the plane has stretched its triangles. Each round spreads the vertices evenly and
    /// takes two steps towards the minimal surface, because the triangles have to be good there. The rounds end when
    /// the area settles.
    pub(super) fn even_out(&self, film: &mut Film) -> Result<(), Error> {
        let flat = self.is_plane();
        for _ in 0..if flat { 0 } else { 2 } {
            flip_to_delaunay(film, self.exec)?;
            tangential_relaxation(film, 2);
            self.exec.look(3 * film.triangles().len() as u64)?;
        }
        flip_to_delaunay(film, self.exec)?;
        let count = film.triangles().len() as f64;
        let mapped = self.shape.is_mapped();
        if count > LARGEST_RESAMPLED || (!mapped && measure::angle_range(&film.mesh()).0 >= GOOD_ANGLE) {
            return Ok(());
        }
        let relaxed = film.clone();
        let mut area = f64::INFINITY;
        for _ in 0..ROUNDS {
            resample(film, count, 3, self.options.boundary_edges(), self.exec)?;
            if film.triangles().len() as f64 > RUNAWAY * count {
                *film = relaxed;
                return Ok(());
            }
            let settled = film.area() > SETTLED_AREA * area;
            area = film.area();
            if settled || flat {
                break;
            }
            let solved = Dirichlet::new(film).and_then(|mut dirichlet| {
                dirichlet.step(film)?;
                dirichlet.step(film)
            });
            if solved.is_err() {
                // A neck closes here. The main solver reports this later.
                break;
            }
            flip_to_delaunay(film, self.exec)?;
        }
        resample(film, count, 5, self.options.boundary_edges(), self.exec)?;
        // If the boundary is spaced more finely than the resolution, collapsing edges may not coarsen the mesh enough.
        // In the plane the triangles keep their final shape, so the better of the two meshes can be chosen.
        let worse = || flat && measure::angle_range(&film.mesh()).0 < measure::angle_range(&relaxed.mesh()).0;
        if film.triangles().len() as f64 > (1.0 + 0.8 * TOLERATED) * count || worse() {
            *film = relaxed;
        }
        Ok(())
    }

    /// Whether the boundaries and the constraints all lie in the plane of the domain, up to rounding.
    fn is_plane(&self) -> bool {
        match &self.shape {
            Shape::Plane(frame) => {
                let limit = 1e-13 * self.largest_size();
                let fixed = self.constraints.points.iter().chain(self.constraints.polylines.iter().flatten());
                largest_height(frame, self.boundaries) <= limit && fixed.into_iter().all(|&p| frame.height(p) <= limit)
            }
            Shape::Disc { .. } | Shape::Sphere(_) => false,
        }
    }

    /// Computes the positions of the free vertices in space.
    fn lift(
        &self,
        in_plane: &[DVec2],
        triangles: &[[u32; 3]],
        fixed: &[bool],
        vertices: &mut [DVec3],
    ) -> Result<(), Error> {
        let free = || (0..fixed.len()).filter(|&v| !fixed[v]);
        match &self.shape {
            Shape::Plane(frame) if self.is_plane() => free().for_each(|v| vertices[v] = frame.lift(in_plane[v])),
            Shape::Plane(frame) => {
                harmonic(in_plane, triangles, fixed, vertices, self.exec)?;
                for v in free() {
                    let height = (vertices[v] - frame.origin).dot(frame.normal);
                    vertices[v] = frame.lift(in_plane[v]) + height * frame.normal;
                }
            }
            Shape::Disc { .. } | Shape::Sphere(_) => harmonic(in_plane, triangles, fixed, vertices, self.exec)?,
        }
        Ok(())
    }
}
