//! The plane domains in which initial meshes are made, and the scale between lengths in space and in the plane.

use super::sampling::Sampled;
use super::strip::Matching;
use glam::{DMat3, DVec2};
use plateau_mesh::plane::frame::Frame;
use plateau_mesh::plane::polygon::doubled_area_vector;
use plateau_mesh::plane::unit_vector;
use plateau_mesh::{DVec3, polyline};
use std::f64::consts::TAU;

/// The plane through the mean of all points that is perpendicular to the longest area vector of the boundaries. In this
/// plane that boundary encloses the largest area. If all area vectors vanish, the plane contains the two directions in
/// which the points spread most. `None` if all points lie on one line.
pub(super) fn best_plane(boundaries: &[Vec<DVec3>]) -> Option<Frame> {
    let all: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
    let origin = polyline::mean(&all);
    let spread = all.iter().map(|p| p.distance_squared(origin)).fold(0.0, f64::max);
    let mut normal = DVec3::ZERO;
    for vector in boundaries.iter().map(|points| doubled_area_vector(points)) {
        if vector.length() > normal.length() * (1.0 + 1e-9) {
            normal = vector;
        }
    }
    if normal.length() <= 1e-6 * spread {
        // The plane contains `origin`, the point farthest from it, and the point farthest from the line through both.
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
    // The first segment of the first boundary that is not along the normal determines the direction of x, so that the
    // frame turns with the input.
    let first = &boundaries[0];
    let x = (0..first.len())
        .map(|k| (first[(k + 1) % first.len()] - first[k]).reject_from_normalized(normal))
        .find(|along| along.length_squared() > 1e-12 * spread)
        .unwrap_or_else(|| normal.any_orthonormal_vector());
    let x = x.normalize();
    Some(Frame { origin, x, y: normal.cross(x), normal })
}

/// Largest distance of a point of the boundaries from the plane.
pub(super) fn largest_height(frame: &Frame, boundaries: &[Vec<DVec3>]) -> f64 {
    boundaries.iter().flatten().map(|&p| frame.height(p)).fold(0.0, f64::max)
}

/// The map from boundaries in space to polygons in the plane.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// Projected onto a plane.
    Plane(Frame),
    /// The outer boundary becomes the unit circle, and every other boundary becomes a smaller circle inside. Arc length
    /// on each loop is preserved up to a factor.
    Disc { outer: usize, holes: Vec<Hole> },
    /// Projected onto a sphere around a common centre, and from the sphere stereographically onto the plane.
    Sphere(Directions),
}

/// Projects points onto a sphere around a centre, and from there stereographically onto the plane. The direction `pole`
/// goes to infinity. The widest boundary runs round the pole, so that its image encloses the images of the others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Directions {
    centre: DVec3,
    x: DVec3,
    y: DVec3,
    pole: DVec3,
    /// Scale factor after the stereographic projection of the unit sphere. It makes the farthest boundary point lie at
    /// distance 1.
    stretch: f64,
    /// Mean distance of the boundaries' points from the centre.
    distance: f64,
    /// The boundary round the pole.
    outer: usize,
}

/// Largest distance from the origin that a boundary may reach in the stereographic projection of the unit sphere. A
/// point farther out is within a quarter of a degree of the pole, and would crowd all others after scaling.
const FARTHEST: f64 = 500.0;

/// Smallest length of the mean of the unit vectors to a boundary's points. A shorter mean is only rounding.
const LEAST_MEAN: f64 = 1e-6;

impl Directions {
    /// `None` if a boundary passes through the centre or near the pole, or runs evenly around the centre.
    fn new(boundaries: &[Vec<DVec3>], centre: DVec3) -> Option<Self> {
        let unit = |p: &DVec3| (*p - centre).try_normalize();
        let mut outer = 0;
        let mut axes = Vec::with_capacity(boundaries.len());
        for (k, points) in boundaries.iter().enumerate() {
            let directions: Vec<DVec3> = points.iter().map(unit).collect::<Option<_>>()?;
            let resultant = polyline::mean(&directions);
            // The wider a loop is as seen from the centre, the shorter is the mean of its directions. The mean vanishes
            // if the loop runs evenly around the centre.
            if resultant.length() < LEAST_MEAN {
                return None;
            }
            axes.push(resultant);
            if k > 0 && resultant.length() < axes[outer].length() * (1.0 - 1e-9) {
                outer = k;
            }
        }
        let pole = axes[outer].try_normalize()?;
        let x = (boundaries[outer][0] - centre).reject_from_normalized(pole).try_normalize()?;
        let count: usize = boundaries.iter().map(Vec::len).sum();
        let distance = boundaries.iter().flatten().map(|p| p.distance(centre)).sum::<f64>() / count as f64;
        let mut projection = Self { centre, x, y: pole.cross(x), pole, stretch: 1.0, distance, outer };
        let distances = || boundaries.iter().flatten().map(|&p| projection.project(p).length());
        let farthest = distances().fold(0.0, f64::max);
        // In the direction of the pole the projection is 0 / 0, which gives NaN and fails the second comparison.
        if !(farthest > 0.0 && distances().all(|distance| distance <= FARTHEST)) {
            return None;
        }
        projection.stretch = 1.0 / farthest;
        Some(projection)
    }

    fn project(&self, point: DVec3) -> DVec2 {
        let direction = (point - self.centre).normalize_or_zero();
        self.stretch * DVec2::new(direction.dot(self.x), direction.dot(self.y)) / (1.0 - direction.dot(self.pole))
    }

    /// Lays the boundaries out on circles, each at the place of its projected boundary and running in the same
    /// direction. The start angle of a circle is chosen so that the directions of its points from its centre agree with
    /// those of the projected points as well as possible.
    fn circles(&self, boundaries: &[Vec<DVec3>]) -> Shape {
        let seen: Vec<Vec<DVec2>> =
            boundaries.iter().map(|points| points.iter().map(|&p| self.project(p)).collect()).collect();
        // The outer circle starts at the angle 0 and runs counter-clockwise.
        let (start, turn) = circle_through(&boundaries[self.outer], &seen[self.outer], DVec2::ZERO);
        let upright = |p: DVec2| {
            let turned = unit_vector(-start).rotate(p);
            DVec2::new(turned.x, turn * turned.y)
        };
        let places: Vec<Vec<DVec2>> = seen.iter().map(|points| points.iter().map(|&p| upright(p)).collect()).collect();
        let centre = |k: usize| {
            let mean = places[k].iter().sum::<DVec2>() / places[k].len() as f64;
            mean.clamp_length_max(0.9)
        };
        let others: Vec<usize> = (0..boundaries.len()).filter(|&k| k != self.outer).collect();
        let hole = |&boundary: &usize| {
            let here = centre(boundary);
            let neighbours = others.iter().filter(|&&k| k != boundary).map(|&k| 0.5 * here.distance(centre(k)));
            let room = neighbours.fold(1.0 - here.length(), f64::min);
            let seen = places[boundary].iter().map(|p| p.distance(here)).sum::<f64>() / places[boundary].len() as f64;
            let radius = seen.clamp(0.2 * room, 0.6 * room);
            let (start, turn) = circle_through(&boundaries[boundary], &places[boundary], here);
            Hole { boundary, centre: here, radius, start, turn }
        };
        Shape::Disc { outer: self.outer, holes: others.iter().map(hole).collect() }
    }

    /// Length in the plane per length in space, for a surface at the mean distance of the boundary points from the
    /// centre.
    fn scale(&self, p: DVec2) -> f64 {
        let p = p / self.stretch;
        0.5 * (1.0 + p.length_squared()) * self.stretch / self.distance
    }
}

/// The point with the least sum of squared distances to the axes of all boundaries. The axis of a boundary passes
/// through the mean of its points along its area vector. For rings that face outwards on a sphere, the point is the
/// sphere's centre. `None` if the axes are nearly parallel, or if the point is farther from the origin than all
/// boundary points.
fn meeting_point(boundaries: &[Vec<DVec3>]) -> Option<DVec3> {
    let mut matrix = DMat3::ZERO;
    let mut right = DVec3::ZERO;
    for points in boundaries {
        let mean = polyline::mean(points);
        let axis = doubled_area_vector(points).try_normalize()?;
        let across = DMat3::IDENTITY - DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
        matrix += across;
        right += across * mean;
    }
    let farthest = boundaries.iter().flatten().map(|p| p.length()).fold(0.0, f64::max);
    let parallel = matrix.determinant() < 1e-3 * (boundaries.len() as f64).powi(3) / 27.0;
    (!parallel).then(|| matrix.inverse() * right).filter(|point| point.length() < farthest)
}

/// A circle inside the unit disc onto which a boundary is laid.
#[derive(Clone, Debug)]
pub(super) struct Hole {
    /// The boundary's index.
    boundary: usize,
    centre: DVec2,
    radius: f64,
    /// The angle of the boundary's first point on the circle, and the direction of the boundary (1 or -1).
    start: f64,
    turn: f64,
}

impl Shape {
    /// Whether lengths in the plane differ from those in space, so that a mesh has to be evened out in space.
    pub fn is_mapped(&self) -> bool {
        !matches!(self, Self::Plane(_))
    }

    /// Returns the ways to lay out boundaries in space, the most trusted first.
    ///
    /// Three or more boundaries are first projected from a common centre onto a sphere and from there onto the plane.
    /// In case these images cross, circles at the same places follow. The last two layouts put the boundaries on one
    /// ring of circles, in the order of their directions and in the opposite order, because boundaries that surround
    /// each other have no order.
    pub fn arrangements(boundaries: &[Vec<DVec3>]) -> Vec<Self> {
        let mut arrangements = Vec::new();
        if boundaries.len() > 2 {
            let means: Vec<DVec3> = boundaries.iter().map(|points| polyline::mean(points)).collect();
            let centres = meeting_point(boundaries).into_iter().chain([polyline::mean(&means)]);
            let seen: Vec<Directions> = centres.filter_map(|centre| Directions::new(boundaries, centre)).collect();
            arrangements.extend(seen.iter().map(|&directions| Self::Sphere(directions)));
            arrangements.extend(seen.iter().map(|directions| directions.circles(boundaries)));
        }
        arrangements.push(Self::disc(boundaries, false));
        if boundaries.len() > 2 {
            arrangements.push(Self::disc(boundaries, true));
        }
        arrangements
    }

    /// Lays the boundaries out on circles. The longest boundary becomes the unit circle, and the others become circles
    /// inside, each turned to face the outer boundary as in space. A single inner circle is concentric. Two or more are
    /// spread evenly around the centre, in the order of their directions or in the opposite order.
    pub fn disc(boundaries: &[Vec<DVec3>], is_opposite: bool) -> Self {
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
                let step = TAU / placed.len() as f64;
                // The inner circles go to the angles k · step, rotated by the mean of (direction - k · step), which
                // brings them nearest to the directions. If these differences cancel, the first circle keeps its own.
                let turns = || placed.iter().enumerate().map(|(k, &(angle, _))| unit_vector(angle - step * k as f64));
                let sum: DVec2 = turns().sum();
                let turn = if sum.length() > CONCENTRIC { libm::atan2(sum.y, sum.x) } else { placed[0].0 };
                if is_opposite {
                    placed.reverse();
                }
                placed.iter().enumerate().map(|(k, &(_, hole))| (turn + step * k as f64, hole)).collect()
            }
        };
        let holes = placed
            .iter()
            .map(|&(angle, boundary)| {
                let (p, q) = (&boundaries[outer], &boundaries[boundary]);
                let matching = Matching::between(p, q);
                let (centre, radius) = if others.len() == 1 {
                    // ln(1 / radius) / 2π, the conformal ratio of the annulus's width to its length, equals the gap
                    // over the mean length of the boundaries in space.
                    let gap = mean_gap(p, q, &matching);
                    let radius = libm::exp(-TAU * gap / (0.5 * (lengths[outer] + lengths[boundary])));
                    (DVec2::ZERO, radius.clamp(0.02, 0.9))
                } else {
                    let room = 0.5 * libm::sin(std::f64::consts::PI / others.len() as f64);
                    let radius = 0.6 * (room.min(0.4)) * (lengths[boundary] / lengths[outer]).sqrt();
                    (0.5 * unit_vector(angle), radius.max(0.05))
                };
                let turn = if reversed(&matching) { -1.0 } else { 1.0 };
                // The point of Q that is opposite to P's first point gets the angle 0 on its circle.
                let opposite = polyline::length(&q[..=matching.order[0]], false) / lengths[boundary];
                Hole { boundary, centre, radius, start: -turn * TAU * opposite, turn }
            })
            .collect();
        Self::Disc { outer, holes }
    }

    /// Maps the points of the boundaries into the plane.
    pub fn embed(&self, boundaries: &[Sampled]) -> Vec<Vec<DVec2>> {
        boundaries
            .iter()
            .enumerate()
            .map(|(k, boundary)| match self {
                Self::Plane(frame) => boundary.points.iter().map(|&p| frame.project(p)).collect(),
                Self::Sphere(directions) => boundary.points.iter().map(|&p| directions.project(p)).collect(),
                Self::Disc { holes, .. } => {
                    let unit = Hole { boundary: k, centre: DVec2::ZERO, radius: 1.0, start: 0.0, turn: 1.0 };
                    holes.iter().find(|hole| hole.boundary == k).unwrap_or(&unit).place(&boundary.points)
                }
            })
            .collect()
    }

    /// Returns the function from a position in the plane to the length in the plane per length in space there.
    pub fn scale<'a>(&'a self, boundaries: &[Vec<DVec3>]) -> Box<dyn Fn(DVec2) -> f64 + 'a> {
        match self {
            Self::Plane(_) => Box::new(|_| 1.0),
            Self::Sphere(directions) => Box::new(|p| directions.scale(p)),
            Self::Disc { outer, holes } => {
                let on = |k: usize, radius: f64| TAU * radius / polyline::length(&boundaries[k], true);
                let outside = on(*outer, 1.0);
                let scales: Vec<f64> = holes.iter().map(|hole| on(hole.boundary, hole.radius)).collect();
                // Between the circles, the logarithm of the scale is the mean of the circles' logarithms, weighted by
                // the inverse distances to the circles.
                Box::new(move |p| {
                    let weight = |distance: f64| 1.0 / distance.max(1e-3);
                    let rim = weight(1.0 - p.length());
                    let (mut sum, mut weights) = (rim * libm::log(outside), rim);
                    for (hole, scale) in holes.iter().zip(&scales) {
                        let near = weight(p.distance(hole.centre) - hole.radius);
                        sum += near * libm::log(*scale);
                        weights += near;
                    }
                    libm::exp(sum / weights)
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
                self.centre + self.radius * unit_vector(angle)
            })
            .collect()
    }
}

/// Returns the angle at which a circle around `centre` starts, and the direction in which it runs (1 or -1). The points
/// of the boundary stand on the circle at their fractions of arc length. Start and direction are chosen so that their
/// directions from the centre agree with those of `places` as well as possible.
fn circle_through(boundary: &[DVec3], places: &[DVec2], centre: DVec2) -> (f64, f64) {
    let next = |k: usize| (k + 1) % places.len();
    let area: f64 = (0..places.len()).map(|k| (places[k] - centre).perp_dot(places[next(k)] - centre)).sum();
    let turn = if area < 0.0 { -1.0 } else { 1.0 };
    let total = polyline::length(boundary, true);
    let (mut along, mut sum) = (0.0, DVec2::ZERO);
    for (k, &place) in places.iter().enumerate() {
        sum += unit_vector(-turn * TAU * along / total).rotate((place - centre).normalize_or_zero());
        along += boundary[k].distance(boundary[next(k)]);
    }
    (libm::atan2(sum.y, sum.x), turn)
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

/// Relative tolerance below which a direction counts as undetermined. A loop is concentric with the outer boundary if
/// the distance of their means is below this fraction of the outer boundary's radius. A concentric loop has no nearest
/// direction if its distances from the outer boundary differ by less.
const CONCENTRIC: f64 = 1e-9;
/// Maximum number of points of a concentric loop whose distances are compared.
const COMPARED_POINTS: usize = 256;

/// Returns for each boundary of `others` the angle on the outer circle towards which it lies: the phase of the first
/// Fourier coefficient of its nearness along the outer boundary. The nearest point of the outer boundary would be a
/// worse choice, because several boundaries can share it if the outer boundary has few points.
fn directions(boundaries: &[Vec<DVec3>], outer: usize, others: &[usize]) -> Vec<f64> {
    let rim = &boundaries[outer];
    let centre = polyline::mean(rim);
    let radius = polyline::radius(rim);
    let total = polyline::length(rim, true);
    others
        .iter()
        .map(|&k| {
            let towards = polyline::mean(&boundaries[k]) - centre;
            // The mean of a concentric loop has no certain direction, so its nearest points decide.
            let is_concentric = towards.length() <= CONCENTRIC * radius;
            let stride = boundaries[k].len() / COMPARED_POINTS + 1;
            let nearness = |point: DVec3| {
                if is_concentric {
                    let distances = boundaries[k].iter().step_by(stride).map(|other| other.distance(point));
                    -distances.fold(f64::INFINITY, f64::min)
                } else {
                    (point - centre).dot(towards) / towards.length()
                }
            };
            let (mut along, mut sum) = (0.0, DVec2::ZERO);
            for (i, &point) in rim.iter().enumerate() {
                let next = rim[(i + 1) % rim.len()];
                let step = point.distance(next);
                let nearness = 0.5 * (nearness(point) + nearness(next));
                sum += step * nearness * unit_vector(TAU * (along + 0.5 * step) / total);
                along += step;
            }
            if sum.length() <= CONCENTRIC * radius * total { 0.0 } else { libm::atan2(sum.y, sum.x) }
        })
        .collect()
}
