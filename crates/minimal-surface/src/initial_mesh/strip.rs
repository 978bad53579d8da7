//! The matching of two closed loops: the direction and the start of the second loop, and the strip of triangles between
//! the two.

use plateau_mesh::DVec3;

/// A closed sequence of bridges between the loops P and Q. Each bridge advances by one point on one of the loops.
#[derive(Clone, Debug)]
pub(super) struct Matching {
    /// The points of Q in the order of the strip, starting opposite to the first point of P.
    pub order: Vec<usize>,
    /// Each bridge, as the index of its point on P and the position in `order` of its point on Q. The last entry
    /// repeats the first bridge, with the numbers of points of P and Q as its indices, so there is one entry more than
    /// triangles.
    pub bridges: Vec<(usize, usize)>,
}

/// Number of samples on each loop from which the direction and the start are determined.
const SAMPLES: usize = 64;

impl Matching {
    /// Matches Q to P: chooses the direction and the start of Q for which the points at equal fractions of arc length
    /// are nearest (least sum of squared distances).
    pub fn between(p: &[DVec3], q: &[DVec3]) -> Self {
        let (from, to) = (samples(p), samples(q));
        let mut best = (f64::INFINITY, 0, false);
        for reversed in [false, true] {
            for start in 0..SAMPLES {
                let opposite = |k: usize| to[if reversed { start + SAMPLES - k } else { start + k } % SAMPLES];
                let cost: f64 = from.iter().enumerate().map(|(k, a)| a.distance_squared(opposite(k))).sum();
                if cost < best.0 * (1.0 - 1e-9) {
                    best = (cost, start, reversed);
                }
            }
        }
        let (_, start, reversed) = best;
        let first = (0..q.len())
            .min_by(|&a, &b| q[a].distance_squared(to[start]).total_cmp(&q[b].distance_squared(to[start])))
            .unwrap_or(0);
        let n = q.len();
        let order: Vec<usize> = (0..n).map(|k| if reversed { first + n - k } else { first + k } % n).collect();
        let turned: Vec<DVec3> = order.iter().map(|&k| q[k]).collect();
        Self { bridges: march(&shares(p), &shares(&turned)), order }
    }

    /// Returns for each point of P the position in `order` at which the middle one of its bridges ends.
    pub fn partners(&self, points: usize) -> Vec<usize> {
        let mut range = vec![(usize::MAX, 0); points];
        for &(i, j) in &self.bridges {
            if i < points {
                range[i] = (range[i].0.min(j), range[i].1.max(j));
            }
        }
        range.into_iter().map(|(low, high)| (low + high) / 2 % self.order.len()).collect()
    }

    /// Returns the triangles of the strip. `p` and `q` are the vertex numbers of the points of P and of Q, the latter
    /// in the given order of Q. The triangles run along P in its direction.
    pub fn triangles(&self, p: &[u32], q: &[u32]) -> Vec<[u32; 3]> {
        let on_p = |i: usize| p[i % p.len()];
        let on_q = |j: usize| q[self.order[j % q.len()]];
        self.bridges
            .windows(2)
            .map(|step| {
                let ((i, j), (i_next, _)) = (step[0], step[1]);
                if i_next > i { [on_p(i), on_p(i + 1), on_q(j)] } else { [on_p(i), on_q(j + 1), on_q(j)] }
            })
            .collect()
    }
}

/// Fractions of the arc length from the first point to each point, followed by 1.
fn shares(points: &[DVec3]) -> Vec<f64> {
    let total = plateau_mesh::polyline::length(points, true);
    let mut at = 0.0;
    let mut result = vec![0.0];
    for k in 0..points.len() {
        at += points[k].distance(points[(k + 1) % points.len()]);
        result.push(at / total);
    }
    result
}

fn samples(points: &[DVec3]) -> Vec<DVec3> {
    let shares = shares(points);
    let mut k = 0;
    (0..SAMPLES)
        .map(|sample| {
            let share = sample as f64 / SAMPLES as f64;
            while k + 1 < points.len() && shares[k + 1] <= share {
                k += 1;
            }
            let part = ((share - shares[k]) / (shares[k + 1] - shares[k])).clamp(0.0, 1.0);
            points[k].lerp(points[(k + 1) % points.len()], part)
        })
        .collect()
}

/// The bridges between two loops that are traversed at equal fractions of arc length.
fn march(p: &[f64], q: &[f64]) -> Vec<(usize, usize)> {
    let (mut i, mut j) = (0, 0);
    let mut bridges = vec![(0, 0)];
    // At most one pass per point, because each pass raises i or j by one.
    while i + 1 < p.len() || j + 1 < q.len() {
        // The strip advances on the loop whose next segment has its middle at the smaller fraction.
        let ahead = |shares: &[f64], k: usize| shares[k] + shares[k + 1];
        if j + 1 == q.len() || (i + 1 < p.len() && ahead(p, i) <= ahead(q, j)) {
            i += 1;
        } else {
            j += 1;
        }
        bridges.push((i, j));
    }
    bridges
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(n: usize, z: f64, turn: f64, direction: f64) -> Vec<DVec3> {
        (0..n)
            .map(|k| {
                let angle = turn + direction * std::f64::consts::TAU * k as f64 / n as f64;
                DVec3::new(libm::cos(angle), libm::sin(angle), z)
            })
            .collect()
    }

    #[test]
    fn rings_turned_and_reversed_are_matched_straight_across() {
        for direction in [1.0, -1.0] {
            let (p, q) = (circle(32, 0.0, 0.0, 1.0), circle(32, 1.0, 1.3, direction));
            let matching = Matching::between(&p, &q);
            assert_eq!(matching.bridges.len(), 65);
            for &(i, j) in &matching.bridges {
                let bridge = q[matching.order[j % 32]] - p[i % 32];
                assert!(bridge.length() < 1.08, "bridge of length {}", bridge.length());
            }
        }
    }

    #[test]
    fn the_strip_between_unequal_loops_is_an_annulus() {
        use plateau_mesh::topology::Topology;
        let (p, q) = (circle(7, 0.0, 0.0, 1.0), circle(12, 1.0, 0.4, -1.0));
        let matching = Matching::between(&p, &q);
        let ids: Vec<u32> = (0..19).collect();
        let triangles = matching.triangles(&ids[..7], &ids[7..]);
        assert_eq!(triangles.len(), 19);
        let topology = Topology::build(&triangles, 19).unwrap();
        assert_eq!((topology.euler_characteristic(), topology.boundary_loops().len()), (0, 2));
        let along_p = topology.boundary_loops().into_iter().find(|vertices| vertices.contains(&0)).unwrap();
        let start = along_p.iter().position(|&v| v == 0).unwrap();
        assert_eq!([&along_p[start..], &along_p[..start]].concat(), ids[..7]);
    }
}
