//! The order in which points are inserted into a Delaunay triangulation whose points lie in few directions.
//!
//! spade's bulk load goes outwards from the mean of the points and looks up the direction of each point on the hull. If
//! most points lie in a few directions, as along a narrow diagonal strip, it walks along the hull instead, and takes
//! quadratic time. Such points are inserted one by one in an order that is random from afar and follows a curve that
//! fills the plane from near (Amenta, Choi, Rote: Incremental constructions con BRIO, 2003). This takes O(n log n)
//! expected time wherever the points lie.

use crate::DVec2;
use crate::random::SplitMix64;
use std::cmp::Reverse;

/// The mean number of points in the direction of a point above which the bulk load is slower than one by one.
const MOST_IN_A_DIRECTION: usize = 500;

/// Returns the order in which to insert the points; `None` if spade's bulk load is fast. O(n log n).
pub(super) fn insertion_order(points: &[DVec2]) -> Option<Vec<u32>> {
    let number = points.len();
    let low = points.iter().copied().reduce(DVec2::min)?;
    let high = points.iter().copied().reduce(DVec2::max)?;
    if number < MOST_IN_A_DIRECTION || !lies_in_few_directions(points) {
        return None;
    }
    let scale = f64::from(u32::MAX) / (high - low).max_element();
    // Each round inserts about as many points as all rounds before it.
    let mut random = SplitMix64::new(1);
    let mut keys: Vec<(Reverse<u32>, u64, u32)> = (0..number as u32)
        .map(|v| {
            let from_low = (points[v as usize] - low) * scale;
            let cell = spread(from_low.x as u32) | spread(from_low.y as u32) << 1;
            (Reverse(random.next_u64().leading_zeros()), cell, v)
        })
        .collect();
    keys.sort_unstable();
    Some(keys.into_iter().map(|(_, _, v)| v).collect())
}

/// Whether a point has on average more than [`MOST_IN_A_DIRECTION`] points in its direction from their mean, where a
/// direction is the n-th part of a turn.
fn lies_in_few_directions(points: &[DVec2]) -> bool {
    let number = points.len();
    let centre = points.iter().sum::<DVec2>() / number as f64;
    let mut counts = vec![0usize; number];
    for &p in points {
        let d = p - centre;
        // Rises from 0 to 8 in a turn.
        let turn = match (d.x + d.y >= 0.0, d.x - d.y >= 0.0) {
            (true, true) => d.y / d.x + 1.0,
            (true, false) => 3.0 - d.x / d.y,
            (false, false) => 5.0 + d.y / d.x,
            (false, true) => 7.0 - d.x / d.y,
        };
        // The mean itself has no direction, and becomes 0.
        counts[((turn / 8.0 * number as f64) as usize).min(number - 1)] += 1;
    }
    // A page counts in 32 bits, which do not hold the square of the points that a request may have.
    counts.iter().map(|&count| (count as u64).pow(2)).sum::<u64>() > (MOST_IN_A_DIRECTION * number) as u64
}

/// Puts a zero bit before each bit.
fn spread(value: u32) -> u64 {
    let mut bits = u64::from(value);
    for (shift, mask) in [
        (16, 0x0000_ffff_0000_ffff),
        (8, 0x00ff_00ff_00ff_00ff),
        (4, 0x0f0f_0f0f_0f0f_0f0f),
        (2, 0x3333_3333_3333_3333),
        (1, 0x5555_5555_5555_5555),
    ] {
        bits = (bits | bits << shift) & mask;
    }
    bits
}
