//! Graded triangulation of a plane domain between closed polygons: places lattice points between the boundaries, and
//! triangulates all points by the constrained Delaunay criterion.

use super::graded_lattice::{SizeField, Source};
use glam::DVec2;
use plateau_mesh::film::Film;
use plateau_mesh::plane::polygon::{contains, doubled_area, inside};
use plateau_mesh::plane::triangulation::{Border, Constraint, InvalidConstraints, triangles_inside};
use plateau_mesh::remesh::delaunay::{flip_to_delaunay, tangential_relaxation};
use plateau_mesh::topology::Topology;
use plateau_mesh::{DVec3, Execution, Interruption};

/// A plane region to be meshed. Its lengths are of the order of 1.
#[derive(Clone, Debug, Default)]
pub(super) struct PlaneRegion {
    /// Closed polygons. A point is inside if an odd number of them encloses it.
    pub loops: Vec<Vec<DVec2>>,
    /// Points inside that become vertices.
    pub points: Vec<DVec2>,
    /// Edges that the mesh must have, between vertices that are numbered loop by loop and then through `points`.
    pub segments: Vec<[u32; 2]>,
}

/// A mesh whose vertices are the points of the loops, then the fixed points, then the lattice points.
#[derive(Clone, Debug)]
pub(super) struct PlaneMesh {
    pub points: Vec<DVec2>,
    pub topology: Topology,
}

/// Why a region has no mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PlaneError {
    /// The boundary or a fixed edge crosses or touches itself. Holds the two vertices of the first such edge.
    NotSimple([u32; 2]),
    TooManyPoints,
    /// A fixed point does not lie inside the boundaries. Holds its index among the fixed points.
    PointOutside(u32),
    /// The points of the boundary alone give this number of triangles, which is more than the resolution allows.
    TooCoarse {
        triangles: usize,
    },
    Interrupted(Interruption),
}

/// Number of rounds of relaxation and flips that smooth the lattice beside the boundary.
const SMOOTHING_ROUNDS: u32 = 4;

impl PlaneRegion {
    fn boundary_points(&self) -> usize {
        self.loops.iter().map(Vec::len).sum()
    }

    /// All fixed vertices in order.
    fn fixed_points(&self) -> Vec<DVec2> {
        self.loops.iter().flatten().chain(&self.points).copied().collect()
    }

    /// The boundary edges as pairs of vertices, in the direction of the loops.
    fn boundary_edges(&self) -> Vec<[u32; 2]> {
        let mut first = 0;
        let mut edges = Vec::with_capacity(self.boundary_points());
        for points in &self.loops {
            let n = points.len() as u32;
            edges.extend((0..n).map(|k| [first + k, first + (k + 1) % n]));
            first += n;
        }
        edges
    }

    /// All edges that the mesh must have.
    fn edges(&self) -> Vec<[u32; 2]> {
        self.boundary_edges().into_iter().chain(self.segments.iter().copied()).collect()
    }

    /// Returns the positions of the vertices: first the fixed ones, then the lattice points. The wanted edge lengths
    /// are those of the boundary edges and of the fixed edges, and grow with the distance from these by `grading`, up
    /// to the cap.
    ///
    /// # Errors
    /// See [`PlaneError`]. A boundary that crosses itself is found only by [`mesh`](Self::mesh).
    pub fn sites(
        &self,
        cap: &dyn Fn(DVec2) -> f64,
        largest_cap: f64,
        grading: f64,
        limit: usize,
        exec: &Execution,
    ) -> Result<Vec<DVec2>, PlaneError> {
        let mut points = self.fixed_points();
        let mut order: Vec<usize> = (0..self.points.len()).collect();
        order.sort_by(|&a, &b| self.points[a].y.total_cmp(&self.points[b].y));
        let sorted: Vec<DVec2> = order.iter().map(|&k| self.points[k]).collect();
        if let Some(outside) = inside(&self.loops, &sorted).iter().position(|inside| !inside) {
            return Err(PlaneError::PointOutside(order[outside] as u32));
        }
        let edges = self.edges();
        let source = |&[a, b]: &[u32; 2]| {
            let (a, b) = (points[a as usize], points[b as usize]);
            Source::new(a, b, a.distance(b))
        };
        let mut sources: Vec<Source> = edges.iter().map(source).collect();
        sources.extend(self.points.iter().map(|&point| Source::new(point, point, f64::INFINITY)));
        let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let extent = (high - low).max_element();
        let field = SizeField { sources, grading, cap };
        let candidates = field
            .lattice(low, high, largest_cap.min(extent), limit, exec)
            .map_err(PlaneError::Interrupted)?
            .ok_or(PlaneError::TooManyPoints)?;
        exec.look(candidates.len() as u64).map_err(PlaneError::Interrupted)?;
        let kept = inside(&self.loops, &candidates);
        points.extend(candidates.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point));
        Ok(points)
    }

    /// Refuses a boundary that crosses or touches itself.
    ///
    /// # Errors
    /// [`PlaneError::NotSimple`].
    pub fn check_simple(&self) -> Result<(), PlaneError> {
        let boundary: Vec<DVec2> = self.loops.iter().flatten().copied().collect();
        self.triangulate(&boundary, &self.boundary_edges()).map(drop)
    }

    /// The area inside the loops.
    pub fn area(&self) -> f64 {
        let area = |points: &[DVec2]| 0.5 * doubled_area(points.iter().copied(), points[0]).abs();
        let empty = [DVec2::INFINITY, DVec2::NEG_INFINITY];
        let bounds = |points: &Vec<DVec2>| points.iter().fold(empty, |[low, high], &p| [low.min(p), high.max(p)]);
        let boxes: Vec<[DVec2; 2]> = self.loops.iter().map(bounds).collect();
        let part = |(k, points): (usize, &Vec<DVec2>)| {
            let around = |&l: &usize| {
                let ([low, high], [own_low, own_high]) = (boxes[l], boxes[k]);
                l != k && low.cmple(own_low).all() && high.cmpge(own_high).all() && contains(&self.loops[l], points[0])
            };
            let hole = (0..self.loops.len()).filter(around).count() % 2 == 1;
            if hole { -area(points) } else { area(points) }
        };
        self.loops.iter().enumerate().map(part).sum()
    }

    /// Mean edge length of the triangles on the sites, before smoothing.
    ///
    /// # Errors
    /// [`PlaneError::NotSimple`].
    pub fn mean_edge(&self, sites: &[DVec2]) -> Result<f64, PlaneError> {
        let triangles = self.triangulate(sites, &self.edges())?;
        let length = |a: u32, b: u32| sites[a as usize].distance(sites[b as usize]);
        let around: f64 = triangles.iter().map(|&[a, b, c]| length(a, b) + length(b, c) + length(c, a)).sum();
        // Every inner edge was counted twice, every boundary edge once.
        let boundary = self.boundary_edges();
        let rim: f64 = boundary.iter().map(|&[a, b]| length(a, b)).sum();
        Ok((around + rim) / (3 * triangles.len() + boundary.len()) as f64)
    }

    /// Triangulates the fixed and the free points, and smooths the free ones.
    ///
    /// # Errors
    /// See [`PlaneError`].
    pub fn mesh(&self, sites: &[DVec2], exec: &Execution) -> Result<PlaneMesh, PlaneError> {
        let triangles = self.triangulate(sites, &self.edges())?;
        exec.look(triangles.len() as u64).map_err(PlaneError::Interrupted)?;
        let topology =
            Topology::build(&triangles, sites.len()).map_err(|_| PlaneError::NotSimple(self.boundary_edges()[0]))?;
        let mut film = self.as_film(sites, topology);
        for _ in 0..SMOOTHING_ROUNDS {
            tangential_relaxation(&mut film, 1);
            flip_to_delaunay(&mut film, exec).map_err(PlaneError::Interrupted)?;
            exec.look(film.triangles().len() as u64).map_err(PlaneError::Interrupted)?;
        }
        Ok(PlaneMesh { points: film.vertices.iter().map(|p| p.truncate()).collect(), topology: film.topology })
    }

    /// Adds up to `count` vertices at the centres of the largest triangles, then triangulates and smooths again.
    ///
    /// # Errors
    /// See [`PlaneError`].
    pub fn densified(&self, mesh: &PlaneMesh, count: usize, exec: &Execution) -> Result<PlaneMesh, PlaneError> {
        let corners = |t: u32| mesh.topology.triangles()[t as usize].map(|v| mesh.points[v as usize]);
        let area = |t: u32| {
            let [a, b, c] = corners(t);
            (b - a).perp_dot(c - a)
        };
        let mut order: Vec<u32> = (0..mesh.topology.triangles().len() as u32).collect();
        order.sort_by(|&s, &t| area(t).total_cmp(&area(s)).then(s.cmp(&t)));
        let mut points = mesh.points.clone();
        let mut taken = vec![false; points.len()];
        // Triangles that share a corner with a chosen one are skipped, so that the new points keep a distance.
        let mut added = 0;
        for t in order {
            let triangle = mesh.topology.triangles()[t as usize];
            if added < count && triangle.iter().all(|&v| !taken[v as usize]) {
                triangle.iter().for_each(|&v| taken[v as usize] = true);
                let [a, b, c] = corners(t);
                points.push((a + b + c) / 3.0);
                added += 1;
            }
        }
        self.mesh(&points, exec)
    }

    fn as_film(&self, points: &[DVec2], topology: Topology) -> Film {
        let fixed = self.boundary_points() + self.points.len();
        let mut locked: Vec<[u32; 2]> = self.segments.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        locked.sort_unstable();
        Film {
            vertices: points.iter().map(|p| p.extend(0.0)).collect::<Vec<DVec3>>(),
            fixed: (0..points.len()).map(|k| k < fixed).collect(),
            topology,
            locked,
            boundaries: Vec::new(),
        }
    }

    /// Constrained Delaunay triangles inside the loops. `edges` are the edges of the loops, followed by the fixed
    /// edges.
    fn triangulate(&self, points: &[DVec2], edges: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, PlaneError> {
        let outlines = self.boundary_points();
        let constraint = |(k, &[from, to]): (usize, &[u32; 2])| {
            let border = if k < outlines { Border::Outline } else { Border::Slit };
            Constraint { from, to, border }
        };
        let constraints: Vec<Constraint> = edges.iter().enumerate().map(constraint).collect();
        triangles_inside(points, &constraints).map_err(|tangle| {
            PlaneError::NotSimple(match tangle {
                InvalidConstraints::Crossing { from, to } | InvalidConstraints::WrongSide { from, to } => [from, to],
                InvalidConstraints::Coincident(a, b) => {
                    edges.iter().copied().find(|edge| edge.contains(&a) || edge.contains(&b)).unwrap_or(edges[0])
                }
                InvalidConstraints::OutOfRange => edges[0],
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_mesh::measure;

    fn polygon(corners: &[(f64, f64)], spacing: f64) -> Vec<DVec2> {
        let corners: Vec<DVec2> = corners.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
        (0..corners.len())
            .flat_map(|k| {
                let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
                let pieces = (a.distance(b) / spacing).ceil().max(1.0) as usize;
                (0..pieces).map(move |i| a.lerp(b, i as f64 / pieces as f64))
            })
            .collect()
    }

    fn mesh(loops: Vec<Vec<DVec2>>, size: f64) -> Result<Film, PlaneError> {
        let domain = PlaneRegion { loops, ..PlaneRegion::default() };
        let exec = Execution::default();
        let sites = domain.sites(&|_| size, size, 0.3, 1_000_000, &exec)?;
        let plane = domain.mesh(&sites, &exec)?;
        Ok(domain.as_film(&plane.points, plane.topology))
    }

    #[test]
    fn concave_polygons_and_holes_have_their_exact_area_and_good_triangles() {
        let u = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (2.6, 3.0), (2.6, 0.4), (0.4, 0.4), (0.4, 3.0), (0.0, 3.0)];
        let square = |low: f64, high: f64| polygon(&[(low, low), (high, low), (high, high), (low, high)], 0.1);
        let cases = [
            (vec![polygon(&u, 0.15)], 9.0 - 2.2 * 2.6, 1),
            (vec![square(0.0, 1.0), square(0.3, 0.7)], 0.84, 0),
            (vec![square(0.3, 0.7), square(0.0, 1.0)], 0.84, 0),
        ];
        for (loops, area, euler) in cases {
            let film = mesh(loops, 0.2).unwrap();
            assert!((film.area() / area - 1.0).abs() < 1e-13);
            let topology = film.mesh().check().unwrap();
            assert_eq!(topology.euler_characteristic(), euler);
            let smallest = measure::angle_range(&film.mesh()).0.to_degrees();
            assert!(smallest > 25.0, "{smallest}");
            assert_eq!(measure::flipped_triangles(&film.mesh()), 0);
        }
    }

    #[test]
    fn sizes_grow_from_a_thousandth_to_one_without_needles() {
        let mut boundary = Vec::new();
        // A circle of radius 3 sampled ever coarser: from 0.001 to about 1.
        let (mut angle, mut step) = (0.0f64, 0.001f64);
        while angle < std::f64::consts::TAU - 0.5 * step {
            boundary.push(3.0 * DVec2::new(libm::cos(angle), libm::sin(angle)));
            step = if angle < 3.0 { (step * 1.15).min(1.0) } else { (step / 1.15).max(0.001) };
            angle += step / 3.0;
        }
        let film = mesh(vec![boundary], 1.0).unwrap();
        let smallest = measure::angle_range(&film.mesh()).0.to_degrees();
        assert!(smallest > 20.0, "{smallest}");
    }

    #[test]
    fn crossing_and_touching_boundaries_are_refused() {
        let bow_tie = vec![DVec2::ZERO, DVec2::ONE, DVec2::new(1.0, 0.0), DVec2::new(0.0, 1.0)];
        assert!(matches!(mesh(vec![bow_tie], 0.5), Err(PlaneError::NotSimple(_))));
        // A vertex on another edge, and a vertex visited twice.
        let touching = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 0.0), (0.0, 1.0)];
        assert!(matches!(mesh(vec![polygon(&touching, 10.0)], 0.5), Err(PlaneError::NotSimple(_))));
        let twice = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (2.0, 2.0), (1.0, 1.0), (0.0, 2.0)];
        assert!(matches!(mesh(vec![polygon(&twice, 10.0)], 0.5), Err(PlaneError::NotSimple(_))));
    }

    #[test]
    fn fixed_points_and_edges_are_in_the_mesh() {
        let domain = PlaneRegion {
            loops: vec![polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], 0.2)],
            points: vec![DVec2::new(0.31, 0.52), DVec2::new(0.69, 0.47), DVec2::new(0.5, 0.1)],
            segments: vec![[20, 21]],
        };
        let exec = Execution::default();
        let sites = domain.sites(&|_| 0.2, 0.2, 0.3, 10_000, &exec).unwrap();
        let plane = domain.mesh(&sites, &exec).unwrap();
        assert_eq!(plane.points[20..23], domain.points);
        assert!(plane.topology.are_adjacent(20, 21));
    }
}
