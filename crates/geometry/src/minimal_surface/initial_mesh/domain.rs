//! The plane domains in which initial meshes are made, and the scale between lengths in space and in the plane.

use super::sampling::Sampled;
use super::strip::Matching;
use crate::{DVec3, polyline};
use glam::DVec2;
use std::f64::consts::TAU;

/// An orthonormal frame: `origin + x e₁ + y e₂ + z n`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub origin: DVec3,
    pub x: DVec3,
    pub y: DVec3,
    pub normal: DVec3,
}

impl Frame {
    /// The plane through the mean of the points whose normal is the largest of the area vectors of the boundaries: the
    /// plane in which that boundary encloses most. If the area vectors vanish, the plane contains the two directions in
    /// which the points spread most. `None` if all points lie on one line.
    pub fn best(boundaries: &[Vec<DVec3>]) -> Option<Self> {
        let all: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
        let origin = polyline::mean(&all);
        let spread = all.iter().map(|p| p.distance_squared(origin)).fold(0.0, f64::max);
        let area_vector = |points: &Vec<DVec3>| -> DVec3 {
            let centre = polyline::mean(points);
            (0..points.len()).map(|k| (points[k] - centre).cross(points[(k + 1) % points.len()] - centre)).sum()
        };
        let mut normal = DVec3::ZERO;
        for vector in boundaries.iter().map(area_vector) {
            if vector.length() > normal.length() * (1.0 + 1e-9) {
                normal = vector;
            }
        }
        if normal.length() <= 1e-6 * spread {
            // The plane contains the farthest point, and the one farthest from the line to it.
            let far = all
                .iter()
                .map(|p| *p - origin)
                .fold(DVec3::ZERO, |best, p| if p.length() > best.length() * (1.0 + 1e-9) { p } else { best });
            normal = all
                .iter()
                .map(|p| far.cross(*p - origin))
                .fold(DVec3::ZERO, |best, p| if p.length() > best.length() * (1.0 + 1e-9) { p } else { best });
            if normal.length() <= 1e-12 * spread {
                return None;
            }
        }
        let normal = normal.normalize();
        // The first segment of the first boundary that is not along the normal determines the direction of x, so that
        // the frame turns with the input.
        let first = &boundaries[0];
        let x = (0..first.len())
            .map(|k| (first[(k + 1) % first.len()] - first[k]).reject_from_normalized(normal))
            .find(|along| along.length_squared() > 1e-12 * spread)
            .unwrap_or_else(|| normal.any_orthonormal_vector());
        let x = x.normalize();
        Some(Self { origin, x, y: normal.cross(x), normal })
    }

    pub fn project(&self, point: DVec3) -> DVec2 {
        let p = point - self.origin;
        DVec2::new(p.dot(self.x), p.dot(self.y))
    }

    pub fn lift(&self, p: DVec2) -> DVec3 {
        self.origin + p.x * self.x + p.y * self.y
    }

    /// Distance of a point from the plane.
    pub fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.normal).abs()
    }

    pub fn largest_height(&self, boundaries: &[Vec<DVec3>]) -> f64 {
        boundaries.iter().flatten().map(|&p| self.height(p)).fold(0.0, f64::max)
    }
}

/// The map from boundaries in space to polygons in the plane.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// Projected onto a plane.
    Plane(Frame),
    /// The outer boundary becomes the unit circle and every other one a smaller circle inside. Arc length is preserved
    /// on each loop up to a factor.
    Disc { outer: usize, holes: Vec<Hole> },
}

/// The circle inside the unit disc that a boundary becomes.
#[derive(Clone, Debug)]
pub(super) struct Hole {
    /// The boundary's index.
    boundary: usize,
    centre: DVec2,
    radius: f64,
    /// The angle of the first point of the boundary on the circle, and the direction in which the boundary runs.
    start: f64,
    turn: f64,
}

impl Shape {
    /// A disc for one boundary. Of several boundaries the longest is outside, and the others are inside, each facing it
    /// as in space.
    pub fn disc(boundaries: &[Vec<DVec3>]) -> Self {
        let lengths: Vec<f64> = boundaries.iter().map(|points| polyline::length(points, true)).collect();
        let mut outer = 0;
        for k in 1..boundaries.len() {
            if lengths[k] > lengths[outer] * (1.0 + 1e-9) {
                outer = k;
            }
        }
        let others: Vec<usize> = (0..boundaries.len()).filter(|&k| k != outer).collect();
        let placed: Vec<(f64, usize)> = match others[..] {
            [] => Vec::new(),
            [only] => vec![(0.0, only)],
            _ => {
                let angles = directions(boundaries, outer, &others);
                let mut placed: Vec<(f64, usize)> = angles.into_iter().zip(others.iter().copied()).collect();
                placed.sort_by(|a, b| a.0.total_cmp(&b.0));
                // They are spread evenly, in the order of their directions.
                let count = placed.len() as f64;
                let first = placed[0].0;
                placed.iter().enumerate().map(|(k, &(_, hole))| (first + TAU * k as f64 / count, hole)).collect()
            }
        };
        let holes = placed
            .iter()
            .map(|&(angle, boundary)| {
                let (p, q) = (&boundaries[outer], &boundaries[boundary]);
                let matching = Matching::between(p, q);
                let (centre, radius) = if others.len() == 1 {
                    // The ratio of the gap to the mean length of the two circles is that of the boundaries in space.
                    let gap = mean_gap(p, q, &matching);
                    let radius = (-TAU * gap / (0.5 * (lengths[outer] + lengths[boundary]))).exp();
                    (DVec2::ZERO, radius.clamp(0.02, 0.9))
                } else {
                    let room = 0.5 * (std::f64::consts::PI / others.len() as f64).sin();
                    let radius = 0.6 * (room.min(0.4)) * (lengths[boundary] / lengths[outer]).sqrt();
                    (0.5 * DVec2::from_angle(angle), radius.max(0.05))
                };
                let turn = if reversed(&matching) { -1.0 } else { 1.0 };
                // The point of Q that is opposite to P's first point stands at the angle 0 of its circle.
                let opposite = polyline::length(&q[..=matching.order[0]], false) / lengths[boundary];
                Hole { boundary, centre, radius, start: -turn * TAU * opposite, turn }
            })
            .collect();
        Self::Disc { outer, holes }
    }

    /// The boundaries' points in the plane.
    pub fn embed(&self, boundaries: &[Sampled]) -> Vec<Vec<DVec2>> {
        boundaries
            .iter()
            .enumerate()
            .map(|(k, boundary)| match self {
                Self::Plane(frame) => boundary.points.iter().map(|&p| frame.project(p)).collect(),
                Self::Disc { holes, .. } => {
                    let unit = Hole { boundary: k, centre: DVec2::ZERO, radius: 1.0, start: 0.0, turn: 1.0 };
                    holes.iter().find(|hole| hole.boundary == k).unwrap_or(&unit).place(&boundary.points)
                }
            })
            .collect()
    }

    /// The length in the plane of a unit of length in space, at a position of the plane.
    pub fn scale<'a>(&'a self, boundaries: &[Vec<DVec3>]) -> Box<dyn Fn(DVec2) -> f64 + 'a> {
        match self {
            Self::Plane(_) => Box::new(|_| 1.0),
            Self::Disc { outer, holes } => {
                let on = |k: usize, radius: f64| TAU * radius / polyline::length(&boundaries[k], true);
                let outside = on(*outer, 1.0);
                let scales: Vec<f64> = holes.iter().map(|hole| on(hole.boundary, hole.radius)).collect();
                // Between the circles it is the mean of the logarithms, weighted by the inverse of the distances.
                Box::new(move |p| {
                    let weight = |distance: f64| 1.0 / distance.max(1e-3);
                    let rim = weight(1.0 - p.length());
                    let (mut sum, mut weights) = (rim * outside.ln(), rim);
                    for (hole, scale) in holes.iter().zip(&scales) {
                        let near = weight(p.distance(hole.centre) - hole.radius);
                        sum += near * scale.ln();
                        weights += near;
                    }
                    (sum / weights).exp()
                })
            }
        }
    }
}

impl Hole {
    fn place(&self, points: &[DVec3]) -> Vec<DVec2> {
        let total = polyline::length(points, true);
        let mut along = 0.0;
        (0..points.len())
            .map(|k| {
                let angle = self.start + self.turn * TAU * along / total;
                along += points[k].distance(points[(k + 1) % points.len()]);
                self.centre + self.radius * DVec2::from_angle(angle)
            })
            .collect()
    }
}

fn reversed(matching: &Matching) -> bool {
    let n = matching.order.len();
    n > 1 && matching.order[1] != (matching.order[0] + 1) % n
}

/// Mean length of the bridges between two matched loops.
fn mean_gap(p: &[DVec3], q: &[DVec3], matching: &Matching) -> f64 {
    let sum: f64 = matching.bridges.iter().map(|&(i, j)| p[i % p.len()].distance(q[matching.order[j % q.len()]])).sum();
    sum / matching.bridges.len() as f64
}

/// For each other boundary the angle of the nearest point on the outer circle.
fn directions(boundaries: &[Vec<DVec3>], outer: usize, others: &[usize]) -> Vec<f64> {
    let rim = &boundaries[outer];
    let centre = polyline::mean(rim);
    let total = polyline::length(rim, true);
    others
        .iter()
        .map(|&k| {
            let towards = polyline::mean(&boundaries[k]) - centre;
            let (mut best, mut angle, mut along) = (f64::NEG_INFINITY, 0.0, 0.0);
            for (i, &point) in rim.iter().enumerate() {
                let facing = (point - centre).dot(towards);
                if facing > best {
                    (best, angle) = (facing, TAU * along / total);
                }
                along += point.distance(rim[(i + 1) % rim.len()]);
            }
            angle
        })
        .collect()
}
