//! Helpers of the tests of ruled strips: small random strips, and every functional evaluated as the papers print it
//! (angles, arc tangents, normalised sums). No formula is shared with the solver.
#![allow(dead_code, reason = "each test file uses its part")]

pub mod pairs;

use plateau_mesh::DVec3;
use plateau_mesh::random::SplitMix64;
use plateau_ruled_surface::{BendingLaw, Objective, Secondary};

/// Every named objective that needs no normals, with both couplings.
pub const GOALS: [(Objective, Option<Secondary>); 7] = [
    (Objective::MinimalArea, None),
    (Objective::MinimalTwist, None),
    (Objective::MaximalConvexity, None),
    (Objective::MinimalBendingEnergy, None),
    (Objective::MinimalMeanCurvatureVariation, None),
    (Objective::MaximalConvexity, Some(Secondary::BendingEnergy)),
    (Objective::MaximalConvexity, Some(Secondary::MeanCurvatureVariation)),
];

/// Random numbers, vectors and directions.
pub struct Random(SplitMix64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(SplitMix64::new(seed))
    }
    /// Uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.between(low, high)
    }
    /// A whole number from low to high, both included.
    pub fn whole(&mut self, low: i64, high: i64) -> i64 {
        low + (self.0.next_u64() % (high - low + 1) as u64) as i64
    }
    pub fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::new(self.between(-size, size), self.between(-size, size), self.between(-size, size))
    }
    pub fn unit(&mut self) -> DVec3 {
        loop {
            let v = self.vector(1.0);
            if v.length() > 0.1 && v.length() < 1.0 {
                return v.normalize();
            }
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    Anywhere,
    /// Small whole numbers, which give ties, degenerate triangles and bridges without length.
    Integer,
    /// Small whole numbers in a plane.
    Planar,
    /// Strips like those that users send.
    Sensible,
}

pub const STYLES: [Style; 4] = [Style::Anywhere, Style::Integer, Style::Planar, Style::Sensible];

#[derive(Clone, Debug)]
pub struct Case {
    pub style: Style,
    pub closed: bool,
    pub p: Vec<DVec3>,
    pub q: Vec<DVec3>,
    pub normals: [Vec<DVec3>; 2],
    pub bending: BendingLaw,
}

pub fn random_case(random: &mut Random, style: Style, closed: bool, most: i64) -> Case {
    let least = if closed { 3 } else { 2 };
    let mut side = |y: f64| -> Vec<DVec3> {
        let count = random.whole(least, most) as usize;
        let mut x: Vec<f64> = (0..count).map(|_| random.between(0.0, 5.0)).collect();
        x.sort_by(f64::total_cmp);
        (0..count)
            .map(|k| match style {
                Style::Anywhere => random.vector(2.0),
                Style::Integer => {
                    DVec3::new(random.whole(-2, 2) as f64, random.whole(-2, 2) as f64, random.whole(-2, 2) as f64)
                }
                Style::Planar => DVec3::new(random.whole(-4, 4) as f64, random.whole(-4, 4) as f64, 0.0),
                Style::Sensible => DVec3::new(x[k], y + random.between(-0.5, 0.5), random.between(-0.5, 0.5)),
            })
            .collect()
    };
    let (p, q) = (side(0.0), side(2.0));
    let normals = [&p, &q].map(|side| side.iter().map(|_| random.unit()).collect());
    Case { style, closed, p, q, normals, bending: BendingLaw::Monotone }
}

/// Every functional of one triangulation.
#[derive(Clone, Copy, Debug)]
pub struct Values {
    pub area: f64,
    pub twist: f64,
    pub convex: usize,
    pub bending: f64,
    pub curvature: f64,
    /// Normal variation with the triangles as they are wound, and with the opposite winding.
    pub variation: [f64; 2],
    pub concave_bending: f64,
    pub concave_curvature: f64,
}

fn unit_cross(u: DVec3, v: DVec3) -> Option<DVec3> {
    let cross = u.cross(v);
    (cross.length() > 1e-14 * u.length() * v.length()).then(|| cross / cross.length())
}

/// Tangents by eq. 13 and 14, exactly as the paper prints them.
pub fn tangents(points: &[DVec3], closed: bool) -> Vec<DVec3> {
    let count = points.len();
    let tangent = |k: usize| {
        if !closed && k == 0 {
            return points[1] - points[0];
        }
        if !closed && k == count - 1 {
            return points[k] - points[k - 1];
        }
        let (before, after) = (points[(k + count - 1) % count] - points[k], points[(k + 1) % count] - points[k]);
        let (a, b) = (before.length(), after.length());
        let alpha = if a == 0.0 || b == 0.0 { 0.5 } else { a / (a + b) };
        let first = -(1.0 + alpha) / alpha * before + alpha / (alpha - 1.0) * after;
        let second = before / alpha + after / (1.0 - alpha);
        first + 2.0 * alpha * second
    };
    (0..count).map(tangent).collect()
}

impl Case {
    pub fn paths(&self) -> Vec<Vec<[usize; 2]>> {
        let (m, n) = (self.p.len(), self.q.len());
        let (down, right) = if self.closed { (m, n) } else { (m - 1, n - 1) };
        let mut paths = Vec::new();
        for start in 0..if self.closed { n } else { 1 } {
            // On a closed strip only paths whose last step is a P-step are taken, so that each cyclic path counts once.
            for choice in 0u32..1 << (down + right) {
                if choice.count_ones() as usize != down || (self.closed && choice >> (down + right - 1) != 1) {
                    continue;
                }
                let mut path = vec![[0, start]];
                for step in 0..down + right {
                    let [i, j] = path[step];
                    path.push(if choice >> step & 1 == 1 { [i + 1, j] } else { [i, j + 1] });
                }
                paths.push(path);
            }
        }
        paths
    }

    /// Evaluates every functional of a triangulation. `path` runs from the first bridge to the last one. On closed
    /// strips the last bridge is the first one again, with indices increased by m and n.
    pub fn evaluate(&self, path: &[[usize; 2]], convex: &dyn Fn(usize, usize) -> bool) -> Values {
        let (m, n) = (self.p.len(), self.q.len());
        let (tp, tq) = (tangents(&self.p, self.closed), tangents(&self.q, self.closed));
        let triangles: Vec<(f64, Option<DVec3>)> = path
            .windows(2)
            .map(|pair| {
                let ([i, j], [next, other]) = (pair[0], pair[1]);
                let (a, c) = (self.p[i % m], self.q[j % n]);
                let b = if next == i + 1 { self.p[next % m] } else { self.q[other % n] };
                (0.5 * (b - a).cross(c - a).length(), unit_cross(b - a, c - a))
            })
            .collect();
        let bridges = if self.closed { &path[..path.len() - 1] } else { path };
        let count = bridges.len();
        let mut bending = vec![0.0; count];
        let mut curvature = vec![DVec3::ZERO; count];
        let mut values = Values {
            area: triangles.iter().map(|t| t.0).sum(),
            twist: 0.0,
            convex: 0,
            bending: 0.0,
            curvature: 0.0,
            variation: [0.0; 2],
            concave_bending: 0.0,
            concave_curvature: 0.0,
        };
        let mut is_convex = Vec::new();
        for (k, &[i, j]) in bridges.iter().enumerate() {
            let (i, j) = (i % m, j % n);
            let e = self.q[j] - self.p[i];
            is_convex.push(convex(i, j));
            let (np, nq) = (unit_cross(e, tp[i]), unit_cross(e, tq[j]));
            values.twist += 1.0 - np.zip(nq).map_or(0.0, |(np, nq)| np.dot(nq));
            for (sum, sign) in values.variation.iter_mut().zip([-1.0, 1.0]) {
                *sum += 1.0 - sign * np.map_or(0.0, |np| np.dot(self.normals[0][i]));
                *sum += 1.0 - sign * nq.map_or(0.0, |nq| nq.dot(self.normals[1][j]));
            }
            if !self.closed && (k == 0 || k == count - 1) {
                continue;
            }
            let before = triangles[(k + triangles.len() - 1) % triangles.len()];
            let after = triangles[k % triangles.len()];
            let (Some(left), Some(right)) = (before.1, after.1) else { continue };
            let angle = left.cross(right).length().atan2(left.dot(right));
            let sine = angle.sin() * angle.sin();
            let is_monotone = self.bending == BendingLaw::Monotone;
            let s = if is_monotone && angle > std::f64::consts::FRAC_PI_2 { 2.0 - sine } else { sine };
            let area = before.0 + after.0;
            if e.length() > 0.0 {
                let length = 2.0 * area / e.length();
                bending[k] = area * s / (length * length);
            }
            let both = left + right;
            curvature[k] = if both.length() > 1e-9 {
                let signed = if left.cross(right).dot(e) >= 0.0 { angle } else { -angle };
                both.normalize() * 2.0 * e.length() * (0.5 * signed).sin()
            } else {
                2.0 * e.cross(left)
            };
        }
        values.convex = is_convex.iter().filter(|&&c| c).count();
        values.bending = bending.iter().sum();
        values.concave_bending = (0..count).filter(|&k| !is_convex[k]).map(|k| bending[k]).sum();
        let links = if self.closed { count } else { count - 1 };
        for k in 0..links {
            let next = (k + 1) % count;
            let jump = curvature[k].distance(curvature[next]);
            values.curvature += jump;
            values.concave_curvature += if is_convex[next] { 0.0 } else { jump };
        }
        values
    }

    /// Local convexity exactly as definition 6 states it: some plane through the bridge has all neighbours on one side.
    /// Whole numbers are decided exactly. Other coordinates are decided by the widest gap between the directions around
    /// the bridge.
    pub fn is_convex(&self, i: usize, j: usize) -> bool {
        let around = |points: &[DVec3], k: usize| -> Vec<DVec3> {
            let count = points.len();
            let before = if self.closed { Some((k + count - 1) % count) } else { k.checked_sub(1) };
            let after = if self.closed { Some((k + 1) % count) } else { Some(k + 1).filter(|&k| k < count) };
            before.into_iter().chain(after).map(|k| points[k]).collect()
        };
        let (p, q) = (self.p[i], self.q[j]);
        let near: Vec<DVec3> = around(&self.p, i).into_iter().chain(around(&self.q, j)).collect();
        let e = q - p;
        let determinant = |a: DVec3, b: DVec3| e.dot((a - p).cross(b - p));
        if self.style == Style::Integer || self.style == Style::Planar {
            // Products of small whole numbers are exact in f64.
            if p == q {
                let near: Vec<DVec3> = near.into_iter().filter(|&a| a != p).collect();
                // With fewer than four neighbours, some plane through the point has all of them on one side. With four
                // neighbours there is no such plane only if they surround the point.
                return near.len() < 4 || !surrounded(p, &near);
            }
            let near: Vec<DVec3> = near.into_iter().filter(|&a| e.cross(a - p) != DVec3::ZERO).collect();
            let supports = |a: &DVec3| {
                near.iter().all(|&b| determinant(*a, b) >= 0.0) || near.iter().all(|&b| determinant(*a, b) <= 0.0)
            };
            return near.is_empty() || near.iter().any(supports);
        }
        let u = e.any_orthogonal_vector().normalize();
        let v = e.normalize().cross(u);
        let mut angles: Vec<f64> = near.iter().map(|&a| (a - p).dot(v).atan2((a - p).dot(u))).collect();
        angles.sort_by(f64::total_cmp);
        let turn = std::f64::consts::TAU;
        (0..angles.len()).any(|k| {
            let next = if k + 1 < angles.len() { angles[k + 1] } else { angles[0] + turn };
            next - angles[k] >= std::f64::consts::PI
        })
    }
}

/// Whether a point is strictly inside the tetrahedron of its four neighbours (whole numbers).
fn surrounded(p: DVec3, near: &[DVec3]) -> bool {
    let volume = |a: DVec3, b: DVec3, c: DVec3, d: DVec3| (b - a).dot((c - a).cross(d - a));
    let whole = volume(near[0], near[1], near[2], near[3]);
    whole != 0.0
        && (0..4).all(|k| {
            let mut corners = [near[0], near[1], near[2], near[3]];
            corners[k] = p;
            volume(corners[0], corners[1], corners[2], corners[3]) * whole > 0.0
        })
}
