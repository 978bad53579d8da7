//! Sampling of a boundary: the points of the polygon, and with `refine` additional points on its long segments.

use crate::options::BoundarySampling;
use plateau_mesh::DVec3;

/// A closed boundary with the points that were added on it.
#[derive(Clone, Debug)]
pub(super) struct Sampled {
    pub points: Vec<DVec3>,
    /// Whether each point belongs to the polygon, that is, was not added.
    pub own: Vec<bool>,
}

/// Returns the vertex numbers of the points of sampled boundaries. The polygons' points come first, boundary by
/// boundary, then the added points.
pub(super) fn numbers(boundaries: &[Sampled]) -> Vec<u32> {
    let own = || boundaries.iter().flat_map(|boundary| &boundary.own);
    let (mut next_own, mut next_added) = (0, own().filter(|own| **own).count() as u32);
    own()
        .map(|&own| {
            let next = if own { &mut next_own } else { &mut next_added };
            *next += 1;
            *next - 1
        })
        .collect()
}

/// Samples a closed polygon so that no piece is much longer than `size`, and the pieces next to a short segment grow by
/// `grading` times the distance along the boundary. Added points lie on the segments. A segment that is short enough
/// stays whole.
pub(super) fn sample(polygon: &[DVec3], size: f64, grading: f64, sampling: BoundarySampling) -> Sampled {
    if sampling == BoundarySampling::Keep {
        return Sampled { points: polygon.to_vec(), own: vec![true; polygon.len()] };
    }
    let n = polygon.len();
    let lengths: Vec<f64> = (0..n).map(|k| polygon[k].distance(polygon[(k + 1) % n])).collect();
    let mut wanted: Vec<f64> = (0..n).map(|k| size.min(lengths[k]).min(lengths[(k + n - 1) % n])).collect();
    // Going round twice in each direction carries the size at every short segment to all other points.
    for k in 0..2 * n {
        let (a, b) = (k % n, (k + 1) % n);
        wanted[b] = wanted[b].min(wanted[a] + grading * lengths[a]);
    }
    for k in (0..2 * n).rev() {
        let (a, b) = (k % n, (k + 1) % n);
        wanted[a] = wanted[a].min(wanted[b] + grading * lengths[a]);
    }
    let mut result = Sampled { points: Vec::new(), own: Vec::new() };
    for k in 0..n {
        result.points.push(polygon[k]);
        result.own.push(true);
        for part in parts(lengths[k], wanted[k], wanted[(k + 1) % n], size, grading) {
            result.points.push(polygon[k] + (polygon[(k + 1) % n] - polygon[k]) * part);
            result.own.push(false);
        }
    }
    result
}

/// Largest number of pieces into which one segment is divided. It bounds the size of the mesh where the sizes vanish.
const MOST_PIECES: f64 = 1e5;

/// Fractions of a segment at which it is divided. The wanted sizes at its ends are `from` and `to`. Between the ends,
/// the size grows by `grading` per length, up to `size`.
fn parts(length: f64, from: f64, to: f64, size: f64, grading: f64) -> Vec<f64> {
    let meeting = ((to - from + grading * length) / (2.0 * grading)).clamp(0.0, length);
    let (up, down) = if from + grading * meeting <= size {
        (meeting, meeting)
    } else {
        (((size - from) / grading).max(0.0), length - ((size - to) / grading).max(0.0))
    };
    let rise = libm::log(1.0 + grading * up / from) / grading;
    let flat = (down - up) / size;
    let fall = libm::log(1.0 + grading * (length - down) / to) / grading;
    let pieces = rise + flat + fall;
    // The count is bounded, because closely spaced boundary points can make the sizes vanish.
    let count = if pieces.is_finite() { (pieces - 0.3).ceil().clamp(1.0, MOST_PIECES) as usize } else { 1 };
    (1..count)
        .map(|k| {
            let at = pieces * k as f64 / count as f64;
            let place = if at < rise {
                from * (libm::exp(grading * at) - 1.0) / grading
            } else if at < rise + flat {
                up + (at - rise) * size
            } else {
                length - to * (libm::exp(grading * (pieces - at)) - 1.0) / grading
            };
            place / length
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_corners_are_cut_evenly_and_kept_exactly() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.3), DVec3::Y];
        let sampled = sample(&corners, 0.1, 0.3, BoundarySampling::Refine);
        let own: Vec<DVec3> =
            sampled.points.iter().zip(&sampled.own).filter(|(_, own)| **own).map(|(p, _)| *p).collect();
        assert_eq!(own, corners);
        let n = sampled.points.len();
        for k in 0..n {
            let piece = sampled.points[k].distance(sampled.points[(k + 1) % n]);
            assert!(piece > 0.08 && piece < 0.11, "{piece}");
        }
        assert_eq!(sample(&corners, 0.1, 0.3, BoundarySampling::Keep).points, corners);
    }

    #[test]
    fn pieces_grow_away_from_short_segments() {
        let mut polygon: Vec<DVec3> = (0..=10).map(|k| DVec3::X * (k as f64 * 0.001)).collect();
        polygon.extend([DVec3::new(3.0, 0.0, 0.0), DVec3::new(1.0, 2.0, 1.0)]);
        let sampled = sample(&polygon, 0.5, 0.3, BoundarySampling::Refine);
        let n = sampled.points.len();
        let piece = |k: usize| sampled.points[k % n].distance(sampled.points[(k + 1) % n]);
        for k in 0..n {
            let ratio = piece(k + 1) / piece(k);
            assert!(ratio < 1.6 && ratio > 1.0 / 1.6, "{ratio} at {k}");
            assert!(piece(k) < 0.6);
        }
        assert!(n < 100, "{n}");
    }
}
