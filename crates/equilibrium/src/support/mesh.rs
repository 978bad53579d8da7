//! A smooth surface that follows a mesh of triangles and on which vertices slide.
//!
//! The mesh itself has no tangent plane on its edges, so a film that slides on it, and Newton's method, would get stuck
//! there. The surface is instead the zero set of a weighted mean of signed distances:
//!
//! ```text
//! f(x) = Σ w_t(x) n_t · (x - c_t) / Σ w_t(x)          w_t(x) = min(A_t, ρ²) (1 - d_t(x)² / ρ²)³₊
//! ```
//!
//! over the triangles t with unit normals n_t, centroids c_t, areas A_t and distances d_t(x) from the point x. The
//! length ρ is called the rounding. f has continuous first derivatives; its second derivatives are piecewise
//! continuous. A plane mesh gives exactly its plane. A mesh of a curved surface gives a surface within O(ρ² + h²) of
//! the curved one, where h is the length of the mesh's edges. Edges and corners are rounded within ρ of them. The
//! method is that of Shen, O'Brien, Shewchuk, *Interpolating and approximating implicit surfaces from polygon soup*
//! (2004), with another weight.

use super::{Extent, Support};
use crate::energy::outer;
use glam::DMat3;
use plateau_mesh::axis_box::AxisBox;
use plateau_mesh::error::{InputError, Place};
use plateau_mesh::{DVec3, polyline};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Largest number of triangles in a leaf of the tree. Any value from 2 to 16 takes about the same time.
const LEAF: usize = 4;
/// A triangle counts as degenerate if twice its area is at most this fraction of the square of its longest side.
const DEGENERATE: f64 = 1e-12;
/// Largest number of Newton steps to the surface f = 0. From a point within the rounding of the mesh two to six are
/// enough.
const MOST_STEPS: u32 = 40;

/// A smooth surface that follows a mesh of triangles. Its normal points to the side from which the triangles are seen
/// counter-clockwise. II(u, v) = -(u · ∇²f v) ∇f / |∇f|².
#[derive(Clone, Debug)]
pub struct Mesh {
    /// The surface. All translated copies of the support share it.
    surface: Arc<Surface>,
    /// The origin of the coordinates in which `surface` is given.
    origin: DVec3,
}

impl Mesh {
    /// Makes the surface along a mesh whose triangles are oriented alike. Edges and corners of the mesh are rounded
    /// within the length `rounding` of them.
    ///
    /// # Errors
    /// The first fault, at its place among `vertices`, `triangles` and `rounding`: no triangles, a coordinate that is
    /// not finite or too large, a vertex number that does not exist, a triangle without area, an edge along which two
    /// triangles run in the same direction, or a rounding that is not a finite number above 0.
    pub fn new(vertices: &[DVec3], triangles: &[[u32; 3]], rounding: f64) -> Result<Self, InputError> {
        let (surface, origin) = Surface::new(vertices, triangles, rounding)?;
        Ok(Self { surface: Arc::new(surface), origin })
    }
}

impl Support for Mesh {
    fn is_sound(&self) -> bool {
        true
    }

    fn dimension(&self) -> u8 {
        2
    }

    fn nearest(&self, x: DVec3) -> DVec3 {
        self.origin + self.surface.nearest(x - self.origin)
    }

    fn tangents(&self, x: DVec3) -> [DVec3; 2] {
        self.normal(x).any_orthonormal_pair().into()
    }

    fn normal(&self, x: DVec3) -> DVec3 {
        self.surface.normal(x - self.origin)
    }

    fn second_fundamental_form(&self, x: DVec3, u: DVec3, v: DVec3) -> DVec3 {
        self.surface.second_fundamental_form(x - self.origin, u, v)
    }

    fn moved(&self, by: DVec3) -> Arc<dyn Support> {
        Arc::new(Self { surface: self.surface.clone(), origin: self.origin + by })
    }

    fn extent(&self) -> Option<&dyn Extent> {
        Some(self)
    }
}

impl Extent for Mesh {
    fn rounding(&self) -> f64 {
        self.surface.rounding
    }

    fn distance(&self, x: DVec3) -> f64 {
        self.surface.distance(x - self.origin)
    }

    fn pieces_near(&self, x: DVec3) -> usize {
        self.surface.triangles_near(x - self.origin)
    }

    fn size(&self) -> usize {
        self.surface.triangles.len()
    }
}

/// The function f of a mesh. All coordinates are relative to the mean of the mesh's vertices.
#[derive(Clone, Debug)]
struct Surface {
    rounding: f64,
    extent: f64,
    triangles: Vec<Triangle>,
    /// The tree over the triangles; the first node is its root.
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Triangle {
    corners: [DVec3; 3],
    normal: DVec3,
    centroid: DVec3,
    weight: f64,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    extent: AxisBox,
    /// The triangles of the node: `count` of them, from number `first` on.
    first: u32,
    count: u32,
    /// The number of the second child, or 0 for a leaf. The first child directly follows its parent.
    second: u32,
}

/// The value of f at a point, with its derivatives.
#[derive(Clone, Copy, Debug)]
struct Level {
    value: f64,
    gradient: DVec3,
    hessian: DMat3,
}

impl Triangle {
    /// The nearest point p of the triangle, and the derivative of p by x.
    fn nearest(&self, x: DVec3) -> (DVec3, DMat3) {
        let [a, b, c] = self.corners;
        let inside = |from: DVec3, to: DVec3| self.normal.cross(to - from).dot(x - from) >= 0.0;
        if inside(a, b) && inside(b, c) && inside(c, a) {
            let height = self.normal.dot(x - a);
            return (x - height * self.normal, DMat3::IDENTITY - outer(self.normal, self.normal));
        }
        let on_side = |from: DVec3, to: DVec3| {
            let side = to - from;
            let share = side.dot(x - from) / side.length_squared();
            if share <= 0.0 {
                (from, DMat3::ZERO)
            } else if share >= 1.0 {
                (to, DMat3::ZERO)
            } else {
                (from + share * side, outer(side, side) * (1.0 / side.length_squared()))
            }
        };
        let nearer = |p: (DVec3, DMat3), q: (DVec3, DMat3)| {
            if q.0.distance_squared(x) < p.0.distance_squared(x) { q } else { p }
        };
        nearer(nearer(on_side(a, b), on_side(b, c)), on_side(c, a))
    }
}

impl Surface {
    /// Makes the surface. Also returns the mean of the mesh's vertices, which is the origin of its coordinates. The
    /// errors are those of [`Mesh::new`].
    fn new(vertices: &[DVec3], triangles: &[[u32; 3]], rounding: f64) -> Result<(Self, DVec3), InputError> {
        let error = |place: Place, detail: String| Err(InputError::new(place, detail));
        if !(rounding.is_finite() && rounding > 0.0) {
            return error(Place::field("rounding"), "must be a finite number above 0".into());
        }
        if triangles.is_empty() {
            return error(Place::field("triangles"), "needs one triangle or more".into());
        }
        let usable = |p: &DVec3| p.is_finite() && p.abs().max_element() <= polyline::LARGEST_COORDINATE;
        if let Some(v) = vertices.iter().position(|p| !usable(p)) {
            let detail = "every coordinate must be a finite number of magnitude at most 1e50";
            return error(Place::field("vertices").at(v), detail.into());
        }
        for (t, triangle) in triangles.iter().enumerate() {
            if let Some(corner) = triangle.iter().position(|&v| v as usize >= vertices.len()) {
                let detail = format!("there are {} vertices, numbered from 0", vertices.len());
                return error(Place::field("triangles").at(t).at(corner), detail);
            }
            let [a, b, c] = triangle.map(|v| vertices[v as usize]);
            let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
            if (b - a).cross(c - a).length() <= DEGENERATE * longest {
                return error(Place::field("triangles").at(t), "has no area".into());
            }
        }
        if let Some((t, other)) = opposed(vertices, triangles) {
            let detail = format!(
                "runs along an edge in the same direction as triangle {other}: neighbours must be oriented alike, and \
                 an edge has two triangles at most"
            );
            return error(Place::field("triangles").at(t), detail);
        }
        let origin = polyline::mean(vertices);
        let make = |triangle: &[u32; 3]| {
            let corners = triangle.map(|v| vertices[v as usize] - origin);
            let double_area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            Triangle {
                corners,
                normal: double_area.normalize(),
                centroid: (corners[0] + corners[1] + corners[2]) / 3.0,
                weight: (0.5 * double_area.length()).min(rounding * rounding),
            }
        };
        let mut triangles: Vec<Triangle> = triangles.iter().map(make).collect();
        let extent = triangles.iter().flat_map(|t| t.corners).map(DVec3::length).fold(0.0, f64::max);
        let mut nodes = Vec::with_capacity(triangles.len());
        build(&mut nodes, &mut triangles, 0);
        Ok((Self { rounding, extent, triangles, nodes }, origin))
    }

    /// The distance of a point from the mesh itself.
    fn distance(&self, x: DVec3) -> f64 {
        self.nearest_of_mesh(x).distance(x)
    }

    /// Number of triangles within the rounding of a point.
    fn triangles_near(&self, x: DVec3) -> usize {
        let mut count = 0;
        self.visit_near(x, &mut |_, _, _| count += 1);
        count
    }

    /// Returns the point of the surface that Newton's method reaches from `x` along the gradient of f. It differs from
    /// the nearest point of the surface by terms of third order in the distance. If `x` is farther from the mesh than
    /// the rounding, the search starts at the nearest point of the mesh.
    fn nearest(&self, x: DVec3) -> DVec3 {
        let mut p = x;
        for _ in 0..MOST_STEPS {
            let Some(level) = self.level(p) else {
                p = self.nearest_of_mesh(p);
                continue;
            };
            let step = level.gradient * (level.value / level.gradient.length_squared().max(f64::MIN_POSITIVE));
            p -= step.clamp_length_max(self.rounding);
            if step.length() <= 4.0 * f64::EPSILON * self.extent {
                break;
            }
        }
        p
    }

    /// The unit normal at a point of the surface.
    fn normal(&self, x: DVec3) -> DVec3 {
        let level = self.level(x);
        level.map_or(DVec3::Z, |level| level.gradient.normalize_or(DVec3::Z))
    }

    /// The second fundamental form II(u, v) = -(u · ∇²f v) ∇f / |∇f|².
    fn second_fundamental_form(&self, x: DVec3, u: DVec3, v: DVec3) -> DVec3 {
        let Some(level) = self.level(x) else { return DVec3::ZERO };
        let squared = level.gradient.length_squared().max(f64::MIN_POSITIVE);
        level.gradient * (-u.dot(level.hessian * v) / squared)
    }

    /// Calls `visit` with each triangle that is nearer to `x` than the rounding, the point of the triangle nearest to
    /// `x`, and the derivative of that point by `x`.
    fn visit_near(&self, x: DVec3, visit: &mut dyn FnMut(&Triangle, DVec3, DMat3)) {
        let squared = self.rounding * self.rounding;
        let mut stack = vec![0];
        // At most one pass per node, because each is the child of one other.
        while let Some(k) = stack.pop() {
            let node = &self.nodes[k];
            if node.extent.distance_squared(x) >= squared {
                continue;
            }
            if node.second > 0 {
                stack.extend([node.second as usize, k + 1]);
                continue;
            }
            for triangle in &self.triangles[node.first as usize..(node.first + node.count) as usize] {
                let (nearest, derivative) = triangle.nearest(x);
                if nearest.distance_squared(x) < squared {
                    visit(triangle, nearest, derivative);
                }
            }
        }
    }

    /// The value of f at `x` with its derivatives, or `None` if no triangle is nearer than the rounding.
    fn level(&self, x: DVec3) -> Option<Level> {
        let squared = self.rounding * self.rounding;
        let (mut weights, mut moments) = ((0.0, DVec3::ZERO, DMat3::ZERO), (0.0, DVec3::ZERO, DMat3::ZERO));
        self.visit_near(x, &mut |triangle, nearest, derivative| {
            let height = triangle.normal.dot(x - triangle.centroid);
            // w = W (1 - s)³ with s = |x - nearest|² / ρ².
            let left = 1.0 - nearest.distance_squared(x) / squared;
            let slope = (x - nearest) * (2.0 / squared);
            let bend = (DMat3::IDENTITY - derivative) * (2.0 / squared);
            let weight = triangle.weight * left * left * left;
            let by_place = slope * (-3.0 * triangle.weight * left * left);
            let second =
                outer(slope, slope) * (6.0 * triangle.weight * left) - bend * (3.0 * triangle.weight * left * left);
            weights.0 += weight;
            weights.1 += by_place;
            weights.2 += second;
            moments.0 += weight * height;
            moments.1 += by_place * height + triangle.normal * weight;
            moments.2 += second * height + outer(by_place, triangle.normal) + outer(triangle.normal, by_place);
        });
        if weights.0 <= 0.0 {
            return None;
        }
        let value = moments.0 / weights.0;
        let gradient = (moments.1 - weights.1 * value) / weights.0;
        let mixed = outer(gradient, weights.1) + outer(weights.1, gradient);
        let hessian = (moments.2 - weights.2 * value - mixed) * (1.0 / weights.0);
        Some(Level { value, gradient, hessian })
    }

    fn nearest_of_mesh(&self, x: DVec3) -> DVec3 {
        let (mut best, mut place) = (f64::INFINITY, DVec3::ZERO);
        let mut stack = vec![0];
        // At most one pass per node, because each is the child of one other.
        while let Some(k) = stack.pop() {
            let node = &self.nodes[k];
            if node.extent.distance_squared(x) >= best {
                continue;
            }
            if node.second > 0 {
                let children = [k + 1, node.second as usize];
                let [near, far] = if self.nodes[children[0]].extent.distance_squared(x)
                    <= self.nodes[children[1]].extent.distance_squared(x)
                {
                    children
                } else {
                    [children[1], children[0]]
                };
                stack.extend([far, near]);
                continue;
            }
            for triangle in &self.triangles[node.first as usize..(node.first + node.count) as usize] {
                let (nearest, _) = triangle.nearest(x);
                if nearest.distance_squared(x) < best {
                    (best, place) = (nearest.distance_squared(x), nearest);
                }
            }
        }
        place
    }
}

/// Returns the numbers of a triangle and of an earlier triangle that run along an edge in the same direction, if there
/// are any. Vertices at equal positions count as the same vertex.
fn opposed(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Option<(usize, usize)> {
    let mut first_at = BTreeMap::new();
    let number: Vec<usize> =
        vertices.iter().enumerate().map(|(v, &p)| *first_at.entry(polyline::position_key(p)).or_insert(v)).collect();
    let mut edges = BTreeMap::new();
    for (t, triangle) in triangles.iter().enumerate() {
        for k in 0..3 {
            let edge = [triangle[k], triangle[(k + 1) % 3]].map(|v| number[v as usize]);
            if let Some(other) = edges.insert(edge, t) {
                return Some((t, other));
            }
        }
    }
    None
}

/// Appends the tree over `triangles` to `nodes`, and sorts `triangles` by the leaves of the tree. `first` is the number
/// of the first triangle.
fn build(nodes: &mut Vec<Node>, triangles: &mut [Triangle], first: usize) {
    let extent = AxisBox::around(triangles.iter().flat_map(|triangle| triangle.corners));
    let own = nodes.len();
    nodes.push(Node { extent, first: first as u32, count: triangles.len() as u32, second: 0 });
    if triangles.len() <= LEAF {
        return;
    }
    let size = extent.high - extent.low;
    let axis = (0..3).fold(0, |best, axis| if size[axis] > size[best] { axis } else { best });
    triangles.sort_by(|a, b| a.centroid[axis].total_cmp(&b.centroid[axis]));
    let (left, right) = triangles.split_at_mut(triangles.len() / 2);
    let middle = first + left.len();
    build(nodes, left, first);
    nodes[own].second = nodes.len() as u32;
    build(nodes, right, middle);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grid of `n` × `n` cells over [-1, 1]² at the heights of a function.
    fn grid(n: u32, height: impl Fn(f64, f64) -> f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let at = |k: u32| 2.0 * f64::from(k) / f64::from(n) - 1.0;
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for j in 0..=n {
            for i in 0..=n {
                vertices.push(DVec3::new(at(i), at(j), height(at(i), at(j))));
                if i < n && j < n {
                    let k = j * (n + 1) + i;
                    triangles.extend([[k, k + 1, k + n + 2], [k, k + n + 2, k + n + 1]]);
                }
            }
        }
        (vertices, triangles)
    }

    #[test]
    fn the_derivatives_of_the_level_agree_with_finite_differences() {
        let (vertices, triangles) = grid(6, |x, y| 0.3 * x * x - 0.2 * x * y + 0.1 * libm::sin(3.0 * y));
        let (surface, origin) = Surface::new(&vertices, &triangles, 0.7).unwrap();
        let h = 1e-5;
        for k in 0..20 {
            let at = |k: f64| 0.8 * libm::sin(1.7 * k + 0.3);
            let x = DVec3::new(at(f64::from(k)), at(f64::from(k) + 40.0), 0.13) - origin;
            let level = surface.level(x).unwrap();
            for axis in 0..3 {
                let moved = |by: f64| surface.level(x + by * DVec3::AXES[axis]).unwrap();
                let (up, down) = (moved(h), moved(-h));
                let slope = (up.value - down.value) / (2.0 * h);
                assert!((slope - level.gradient[axis]).abs() < 1e-8, "{slope} {}", level.gradient[axis]);
                let bend = (up.gradient - down.gradient) / (2.0 * h);
                // A second derivative may jump within a step.
                assert!((bend - level.hessian.col(axis)).length() < 1e-3, "{bend} {}", level.hessian.col(axis));
            }
        }
    }

    #[test]
    fn a_plane_mesh_is_its_plane_and_a_step_to_it_is_along_the_normal() {
        let (vertices, triangles) = grid(3, |x, y| 0.5 * x - 0.25 * y + 2.0);
        let normal = DVec3::new(-0.5, 0.25, 1.0).normalize();
        for rounding in [0.05, 0.8, 5.0] {
            let (surface, origin) = Surface::new(&vertices, &triangles, rounding).unwrap();
            for x in [DVec3::new(0.1, 0.2, 2.0), DVec3::new(-0.7, 0.4, 1.5), DVec3::new(0.3, -0.2, 2.6)] {
                let x = x - origin;
                let own = surface.nearest(x);
                let height = own.z - 0.5 * own.x + 0.25 * own.y;
                assert!(height.abs() < 1e-14, "{height}");
                assert!((x - own).cross(normal).length() < 1e-14);
                assert!((surface.normal(own) - normal).length() < 1e-14);
                assert!(surface.second_fundamental_form(own, DVec3::X, DVec3::Y).length() < 1e-12);
            }
        }
    }

    #[test]
    fn the_tree_finds_the_nearest_point_and_all_triangles_near_it() {
        let (vertices, triangles) = grid(9, |x, y| 0.4 * libm::cos(2.0 * x) * y);
        let (surface, _) = Surface::new(&vertices, &triangles, 0.4).unwrap();
        for k in 0..40 {
            let at = |k: f64| 1.4 * libm::sin(2.3 * k + 0.1);
            let x = DVec3::new(at(f64::from(k)), at(f64::from(k) + 50.0), at(f64::from(k) + 90.0));
            let all = surface.triangles.iter().map(|triangle| triangle.nearest(x).0.distance(x));
            let least = all.clone().fold(f64::INFINITY, f64::min);
            assert!((surface.distance(x) - least).abs() < 1e-14);
            assert_eq!(surface.triangles_near(x), all.filter(|distance| *distance < 0.4).count());
        }
    }

    #[test]
    fn a_mesh_of_a_sphere_comes_nearer_to_it_with_the_square_of_the_edges() {
        // The cap of a sphere of radius 2.
        let height = |x: f64, y: f64| (4.0 - x * x - y * y).sqrt();
        let mut errors = Vec::new();
        for n in [8, 16, 32] {
            let (vertices, triangles) = grid(n, height);
            let (surface, origin) = Surface::new(&vertices, &triangles, 5.0 / f64::from(n)).unwrap();
            let mut worst: [f64; 2] = [0.0, 0.0];
            for k in 0..50 {
                let at = |k: f64| 0.4 * libm::sin(2.3 * k + 0.1);
                let own = surface.nearest(DVec3::new(at(f64::from(k)), at(f64::from(k) + 50.0), 2.0) - origin);
                let place = own + origin;
                worst[0] = worst[0].max((place.length() - 2.0).abs());
                worst[1] = worst[1].max(surface.normal(own).cross(place.normalize()).length());
            }
            errors.push(worst);
        }
        println!("{errors:?}");
        assert!(errors.windows(2).all(|pair| (3.4..4.6).contains(&(pair[0][0] / pair[1][0]))), "{errors:?}");
        assert!(errors[2][1] < 3e-3, "{errors:?}");
    }

    #[test]
    fn faults_of_a_mesh_are_named() {
        let (vertices, triangles) = grid(2, |_, _| 0.0);
        let place = |vertices: &[DVec3], triangles: &[[u32; 3]], rounding: f64| {
            Surface::new(vertices, triangles, rounding).unwrap_err().place.to_string()
        };
        assert!(Surface::new(&vertices, &triangles, 0.5).is_ok());
        assert_eq!(place(&vertices, &[], 0.5), "/triangles");
        assert_eq!(place(&vertices, &triangles, 0.0), "/rounding");
        assert_eq!(place(&vertices, &triangles, f64::NAN), "/rounding");
        let changed = |change: &dyn Fn(&mut Vec<[u32; 3]>)| {
            let mut triangles = triangles.clone();
            change(&mut triangles);
            place(&vertices, &triangles, 0.5)
        };
        assert_eq!(changed(&|t| t[3][1] = 9), "/triangles/3/1");
        assert_eq!(changed(&|t| t[3] = [0, 1, 2]), "/triangles/3");
        assert_eq!(changed(&|t| t[3] = [5, 5, 1]), "/triangles/3");
        assert_eq!(changed(&|t| t[1].reverse()), "/triangles/1");
        let mut far = vertices.clone();
        far[4].y = f64::INFINITY;
        assert_eq!(place(&far, &triangles, 0.5), "/vertices/4");
    }
}
