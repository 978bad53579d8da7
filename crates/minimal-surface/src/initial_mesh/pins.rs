//! Fixed points and curves inside a film: the mesh vertices and edges that they need, and the positions of these
//! vertices in the plane domain.

use super::domain::Shape;
use crate::options::{BoundarySampling, Constraints};
use glam::DVec2;
use plateau_mesh::film::Film;
use plateau_mesh::measure::double_area_vector;
use plateau_mesh::polyline::position_key;
use plateau_mesh::{DVec3, Execution, Interruption};
use std::collections::{BTreeMap, BTreeSet};

/// A vertex of a fixed curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pin {
    /// A point of a boundary, by its number among the points of all boundaries.
    Boundary(u32),
    /// An entry of [`Pins::points`].
    Inner(u32),
}

/// The vertex at each known position.
type Known = BTreeMap<[u64; 3], Pin>;

/// The constraints, converted to vertices and edges.
#[derive(Clone, Debug, Default)]
pub(super) struct Pins {
    /// The vertices that are not on the boundary, each once.
    pub points: Vec<DVec3>,
    pub edges: Vec<[Pin; 2]>,
}

impl Pins {
    /// Converts the constraints to vertices and edges. Points that equal a boundary point, or each other, become one
    /// vertex. A piece of a curve that is a segment of a boundary needs no edge. With `refine`, curves are divided into
    /// pieces of about `size`.
    pub fn new(constraints: &Constraints, boundaries: &[Vec<DVec3>], size: f64, sampling: BoundarySampling) -> Self {
        let mut known = Known::new();
        for (k, &point) in boundaries.iter().flatten().enumerate() {
            // A point that occurs twice on the boundary keeps its first number.
            known.entry(position_key(point)).or_insert(Pin::Boundary(k as u32));
        }
        let mut pins = Self::default();
        for &point in &constraints.points {
            pins.vertex(point, &mut known);
        }
        let side = |a: DVec3, b: DVec3| {
            let [a, b] = [a, b].map(position_key);
            [a.min(b), a.max(b)]
        };
        let mut sides = BTreeSet::new();
        if !constraints.polylines.is_empty() {
            let count = |boundary: &Vec<DVec3>| 0..boundary.len();
            for (boundary, k) in boundaries.iter().flat_map(|own| count(own).map(move |k| (own, k))) {
                sides.insert(side(boundary[k], boundary[(k + 1) % boundary.len()]));
            }
        }
        for polyline in &constraints.polylines {
            for pair in polyline.windows(2).filter(|pair| !sides.contains(&side(pair[0], pair[1]))) {
                let pieces = match sampling {
                    BoundarySampling::Keep => 1,
                    BoundarySampling::Refine => (pair[0].distance(pair[1]) / size - 0.3).ceil().max(1.0) as usize,
                };
                let mut last = pins.vertex(pair[0], &mut known);
                for k in 1..=pieces {
                    let next = if k == pieces {
                        pins.vertex(pair[1], &mut known)
                    } else {
                        let point = pair[0] + (pair[1] - pair[0]) * (k as f64 / pieces as f64);
                        pins.vertex(point, &mut known)
                    };
                    if next != last {
                        pins.edges.push([last, next]);
                    }
                    last = next;
                }
            }
        }
        pins
    }

    fn vertex(&mut self, point: DVec3, known: &mut Known) -> Pin {
        *known.entry(position_key(point)).or_insert_with(|| {
            self.points.push(point);
            Pin::Inner(self.points.len() as u32 - 1)
        })
    }

    /// Returns the positions of the inner vertices in the plane. For a plane domain, they are projected. Otherwise
    /// `mapped` is a film with the plane position of each of its vertices, and the nearest point of the film is taken.
    /// All triangles are searched for each point, with a call of `exec.look` before.
    ///
    /// # Errors
    /// The interruptions of `exec`.
    pub fn in_plane(
        &self,
        shape: &Shape,
        mapped: Option<&(Film, Vec<DVec2>)>,
        exec: &Execution,
    ) -> Result<Vec<DVec2>, Interruption> {
        let place = |&point: &DVec3| match (shape, mapped) {
            (Shape::Plane(frame), _) => Ok(frame.project(point)),
            (Shape::Disc { .. } | Shape::Sphere(_), Some((film, flat))) => {
                exec.look(film.triangles().len() as u64)?;
                Ok(nearest(film, flat, point))
            }
            (Shape::Disc { .. } | Shape::Sphere(_), None) => Ok(DVec2::ZERO),
        };
        self.points.iter().map(place).collect()
    }
}

/// Finds the point of the film that is nearest to a point in space, moves it slightly into the interior of its
/// triangle, and returns its position in the plane.
fn nearest(film: &Film, flat: &[DVec2], point: DVec3) -> DVec2 {
    let mut best = (f64::INFINITY, DVec2::ZERO);
    for &triangle in film.triangles() {
        let weights = nearest_weights(film.corners(triangle), point);
        // The point must not lie on an edge, because the boundary edges are those of the domain.
        let weights = weights.map(|weight| (weight + 0.01) / 1.03);
        let at: DVec3 = film.corners(triangle).iter().zip(weights).map(|(&p, weight)| p * weight).sum();
        let distance = at.distance_squared(point);
        if distance < best.0 {
            let corners = triangle.map(|v| flat[v as usize]);
            best = (distance, corners.iter().zip(weights).map(|(&p, weight)| p * weight).sum());
        }
    }
    best.1
}

/// Barycentric weights of the point of a triangle that is nearest to a point in space.
fn nearest_weights([a, b, c]: [DVec3; 3], point: DVec3) -> [f64; 3] {
    let normal = double_area_vector([a, b, c]);
    let scale = normal.length_squared();
    if scale > 0.0 {
        let weight = |u: DVec3, v: DVec3| normal.dot((u - point).cross(v - point)) / scale;
        let weights = [weight(b, c), weight(c, a), weight(a, b)];
        if weights.iter().all(|&weight| weight >= 0.0) {
            return weights;
        }
    }
    let mut best = (f64::INFINITY, [1.0, 0.0, 0.0]);
    for (k, (u, v)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
        let along = v - u;
        let part = ((point - u).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let distance = (u + along * part).distance_squared(point);
        if distance < best.0 {
            let mut weights = [0.0; 3];
            weights[k] = 1.0 - part;
            weights[(k + 1) % 3] = part;
            best = (distance, weights);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shared_points_are_one_vertex_and_curves_are_cut_on_their_segments() {
        let boundary = vec![DVec3::ZERO, DVec3::X * 4.0, DVec3::new(4.0, 4.0, 0.0), DVec3::Y * 4.0];
        let inner = DVec3::new(2.0, 2.0, 1.0);
        let polylines = vec![vec![DVec3::ZERO, inner, boundary[2]]];
        let constraints = Constraints { points: vec![inner, inner], polylines, ..Constraints::default() };
        let kept = Pins::new(&constraints, std::slice::from_ref(&boundary), 0.5, BoundarySampling::Keep);
        assert_eq!(kept.points, [inner]);
        assert_eq!(kept.edges, [[Pin::Boundary(0), Pin::Inner(0)], [Pin::Inner(0), Pin::Boundary(2)]]);
        let refined = Pins::new(&constraints, &[boundary], 1.0, BoundarySampling::Refine);
        assert_eq!((refined.points.len(), refined.edges.len()), (5, 6));
        for &point in &refined.points {
            let beside = |a: DVec3, b: DVec3| (point - a).cross(b - a).length();
            let off = beside(DVec3::ZERO, inner).min(beside(inner, DVec3::new(4.0, 4.0, 0.0)));
            assert!(off < 1e-12, "{point} is on neither segment");
        }
    }

    #[test]
    fn a_piece_of_a_curve_that_is_a_side_of_the_boundary_needs_no_edge() {
        let boundary = vec![DVec3::ZERO, DVec3::X * 4.0, DVec3::new(4.0, 4.0, 0.0), DVec3::Y * 4.0];
        let along = vec![boundary[2], boundary[1], boundary[0], DVec3::new(2.0, 2.0, 1.0)];
        let constraints = Constraints { polylines: vec![along], ..Constraints::default() };
        let pins = Pins::new(&constraints, &[boundary], 10.0, BoundarySampling::Refine);
        assert_eq!(pins.edges, [[Pin::Boundary(0), Pin::Inner(0)]]);
    }

    #[test]
    fn the_nearest_point_of_a_triangle_is_that_of_dense_sampling() {
        let corners = [DVec3::ZERO, DVec3::new(2.0, 0.0, 1.0), DVec3::new(0.5, 1.5, -1.0)];
        for point in [
            DVec3::new(0.7, 0.4, 3.0),
            DVec3::new(-1.0, -1.0, 0.2),
            DVec3::new(3.0, 0.1, 0.0),
            DVec3::new(1.0, 2.0, 1.0),
        ] {
            let weights = nearest_weights(corners, point);
            let at: DVec3 = corners.iter().zip(weights).map(|(&p, w)| p * w).sum();
            let sampled = (0..=200)
                .flat_map(|i| (0..=200 - i).map(move |j| (i, j)))
                .map(|(i, j)| {
                    let (u, v) = (f64::from(i) / 200.0, f64::from(j) / 200.0);
                    (corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v).distance(point)
                })
                .fold(f64::INFINITY, f64::min);
            assert!(at.distance(point) <= sampled + 1e-12 && at.distance(point) > sampled - 0.02);
        }
    }
}
