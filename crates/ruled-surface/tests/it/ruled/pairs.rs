//! Random pairs of rails that lie side by side, drawn so that the direction of the second one is known.

use plateau_mesh::DVec3;
use plateau_mesh::random::SplitMix64;
use std::f64::consts::{PI, TAU};

/// Two rails that run in the same direction. Both follow one guiding curve, and each has its own points.
pub struct Pair {
    pub name: String,
    pub closed: bool,
    pub rails: [Vec<DVec3>; 2],
}

/// The curve that both rails follow, as a place and a sideways direction at a parameter from 0 to 1.
enum Guide {
    Line { length: f64 },
    Arc { radius: f64, angle: f64 },
    Spline { controls: Vec<DVec3> },
}

impl Guide {
    fn random(random: &mut SplitMix64, kind: i64) -> (&'static str, Self) {
        match kind {
            0 => ("line", Self::Line { length: random.between(1.0, 20.0) }),
            1 => ("arc", Self::Arc { radius: random.between(3.0, 10.0), angle: random.between(0.2, 1.5 * PI) }),
            _ => {
                let count = whole(random, 4, 7);
                let control = |k: i64, random: &mut SplitMix64| {
                    DVec3::new(3.0 * k as f64, random.between(-1.5, 1.5), random.between(-1.5, 1.5))
                };
                ("spline", Self::Spline { controls: (0..count).map(|k| control(k, random)).collect() })
            }
        }
    }

    /// Returns the place on the curve, and the horizontal unit vector to its left.
    fn at(&self, t: f64) -> (DVec3, DVec3) {
        match self {
            Self::Line { length } => (DVec3::X * length * t, DVec3::Y),
            Self::Arc { radius, angle } => {
                let direction = DVec3::new((angle * t).cos(), (angle * t).sin(), 0.0);
                (*radius * direction, -direction)
            }
            Self::Spline { controls } => {
                let step = 1e-4;
                let (before, after) = (bezier(controls, (t - step).max(0.0)), bezier(controls, (t + step).min(1.0)));
                let along = after - before;
                (bezier(controls, t), DVec3::new(-along.y, along.x, 0.0).normalize())
            }
        }
    }
}

fn bezier(controls: &[DVec3], t: f64) -> DVec3 {
    let mut row = controls.to_vec();
    while row.len() > 1 {
        row = row.windows(2).map(|pair| pair[0].lerp(pair[1], t)).collect();
    }
    row[0]
}

/// Draws a pair of open rails. The second rail is offset to the side and vertically. Both offsets may change along the
/// rails.
pub fn open_pair(random: &mut SplitMix64) -> Pair {
    let (name, guide) = {
        let kind = whole(random, 0, 2);
        Guide::random(random, kind)
    };
    let width = [random.between(0.3, 2.5), random.between(0.3, 2.5)];
    let height = [random.between(-2.0, 2.0), random.between(-2.0, 2.0)];
    // Parameters of the guide at which each rail begins and ends.
    let reach = [(0.0, 1.0), (random.between(0.0, 0.15), random.between(0.85, 1.0))];
    let rails: [Vec<DVec3>; 2] = [0, 1].map(|side| {
        // A straight rail may consist of its two ends only.
        let least = if name == "line" { 2 } else { 12 };
        let count = whole(random, least, 60) as usize;
        let jitter = random.between(0.0, 0.4);
        let (from, to) = reach[side];
        (0..count)
            .map(|k| {
                let inside = if k == 0 || k + 1 == count { 0.0 } else { jitter * random.between(-1.0, 1.0) };
                let u = (k as f64 + inside) / (count - 1) as f64;
                let (place, left) = guide.at(from + u * (to - from));
                let across = side as f64 * (width[0] + u * (width[1] - width[0]));
                let up = side as f64 * (height[0] + u * (height[1] - height[0]));
                place + across * left + up * DVec3::Z
            })
            .collect()
    });
    let (m, n) = (rails[0].len(), rails[1].len());
    Pair { name: format!("{name}, {m} and {n} points"), closed: false, rails }
}

/// Draws a pair of contours that run in the same sense, like two sections of a hull or of a wing.
pub fn closed_pair(random: &mut SplitMix64) -> Pair {
    let lobes = whole(random, 0, 4) as f64;
    let depth = if lobes == 0.0 { 0.0 } else { random.between(0.0, 0.4) };
    let (flat, turn) = (random.between(0.1, 1.0), random.between(0.0, TAU));
    let shift = DVec3::new(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(0.5, 4.0));
    let scale = random.between(0.3, 1.5);
    let rails: [Vec<DVec3>; 2] = [0, 1].map(|side| {
        let count = whole(random, 8, 60) as usize;
        let start = random.between(0.0, TAU);
        (0..count)
            .map(|k| start + TAU * k as f64 / count as f64)
            .map(|a| {
                let r = 2.0 * (1.0 + depth * (lobes * a + turn).cos());
                let point = DVec3::new(r * a.cos(), flat * r * a.sin(), 0.0);
                if side == 0 { point } else { scale * point + shift }
            })
            .collect()
    });
    let (m, n) = (rails[0].len(), rails[1].len());
    Pair { name: format!("contours, {m} and {n} points"), closed: true, rails }
}

/// A whole number from low to high, both included.
fn whole(random: &mut SplitMix64, low: i64, high: i64) -> i64 {
    low + (random.next_u64() % (high - low + 1) as u64) as i64
}
