//! Fewer distinct lengths, so that a workshop cuts fewer different members. The paper has no such step.
//!
//! 1. Find the k lengths that come nearest to all members. They are the middles of k intervals of equal width that
//!    cover the sorted lengths and are as narrow as possible (greedy cover and bisection, exact on a line).
//! 2. Move the inner nodes on the surface to minimise Σ (L - c)², where c is the middle of the member's interval.
//! 3. Repeat while the intervals get narrower. The narrowest intervals are kept.
//!
//! These steps are repeated for increasing k up to the largest allowed, each time from the same start. The repetition
//! ends with the first k whose intervals are no wider than the tolerance. Members between two boundary nodes cannot
//! change, but they are covered too.

use super::move_nodes::{OnSurface, Sheet, TargetLength, refine};
use crate::report::LengthsRow;
use plateau_mesh::execution::{Execution, Interruption};

/// Returns the numbers of lengths that are tried: 1, 2, 3, 4, 6, 8, 12, 16, 24, ... and the largest allowed.
fn ladder(most: usize) -> Vec<usize> {
    let mut ladder: Vec<usize> = std::iter::successors(Some(1usize), |k| k.checked_mul(2))
        .take_while(|&k| k <= most)
        .flat_map(|k| [k, k / 2 * 3])
        .collect();
    ladder.retain(|&k| k > 0 && k <= most);
    ladder.push(most);
    ladder.sort_unstable();
    ladder.dedup();
    ladder
}

/// Returns the least half-width of at most `count` intervals that cover the sorted lengths, and the middles of the
/// intervals.
fn cover(sorted: &[f64], count: usize) -> (f64, Vec<f64>) {
    let cut = |width: f64| {
        let mut starts: Vec<(f64, f64)> = Vec::new();
        for &length in sorted {
            match starts.last_mut() {
                Some((from, to)) if length - *from <= width => *to = length,
                _ => starts.push((length, length)),
            }
            if starts.len() > count {
                return None;
            }
        }
        Some(starts)
    };
    let (mut low, mut high) = (0.0, sorted.last().map_or(0.0, |last| last - sorted[0]));
    if cut(0.0).is_some() {
        high = 0.0;
    }
    // The bisection ends at the rounding of lengths near 1, because each pass halves the interval.
    while high - low > 1e-15 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if cut(middle).is_some() { high = middle } else { low = middle }
    }
    let intervals = cut(high).unwrap_or_default();
    let half = intervals.iter().map(|(from, to)| 0.5 * (to - from)).fold(0.0, f64::max);
    (half, intervals.iter().map(|(from, to)| 0.5 * (from + to)).collect())
}

fn sorted<S: Sheet>(nodes: &OnSurface<'_, S>) -> Vec<f64> {
    let mut lengths = nodes.lengths();
    lengths.sort_unstable_by(f64::total_cmp);
    lengths
}

/// Moves the inner nodes until the members have at most `most` lengths and each member is within half of `tolerance`
/// (in ℓ) of its length. If that is not reached, the nearest result is kept. Returns a row for every number of lengths
/// tried (in ℓ). `nodes` are those of the last row.
///
/// # Errors
/// The interruption, beside the rows. `nodes` and the rows are then the best found until then.
pub(crate) fn share_lengths<S: Sheet>(
    nodes: &mut OnSurface<'_, S>,
    most: usize,
    tolerance: f64,
    (from, to): (f64, f64),
    execution: &Execution<'_>,
) -> (Vec<LengthsRow>, Option<Interruption>) {
    let effort = nodes.surface.effort();
    let start = nodes.clone();
    let before = sorted(&start);
    let ladder = ladder(most);
    let mut rows = Vec::new();
    for (rung, &count) in ladder.iter().enumerate() {
        let part = |k: usize| from + (to - from) * k as f64 / (ladder.len() * ROUNDS) as f64;
        let mut here = start.clone();
        let (deviation_before, mut middles) = cover(&before, count);
        let mut best = (deviation_before, start.clone());
        let mut interrupted = None;
        let mut idle = 0;
        for round in 0..ROUNDS {
            let nearest = |length: f64| {
                let k = middles.partition_point(|&middle| middle < length);
                let candidates = middles[k.saturating_sub(1)..(k + 1).min(middles.len())].iter().copied();
                candidates.min_by(|a, b| (a - length).abs().total_cmp(&(b - length).abs())).unwrap_or(length)
            };
            let targets: Vec<TargetLength> =
                here.lengths().into_iter().map(|length| TargetLength::At(nearest(length))).collect();
            let step = rung * ROUNDS + round;
            interrupted = refine(&mut here, &targets, effort, "share_lengths", (part(step), part(step + 1)), execution);
            let (deviation, better) = cover(&sorted(&here), count);
            middles = better;
            idle = if deviation < best.0 * 0.999 { 0 } else { idle + 1 };
            if deviation < best.0 {
                best = (deviation, here.clone());
            }
            if interrupted.is_some() || idle == 3 || 2.0 * best.0 <= tolerance {
                break;
            }
        }
        rows.push(LengthsRow { lengths: count, deviation: best.0, deviation_before });
        *nodes = best.1;
        if interrupted.is_some() || 2.0 * best.0 <= tolerance {
            return (rows, interrupted);
        }
    }
    (rows, None)
}

/// Maximum number of rounds of moving nodes and covering lengths, for each number of lengths.
const ROUNDS: usize = 12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cover_is_the_narrowest_there_is() {
        let lengths = [1.0, 1.1, 1.15, 1.5, 1.8, 1.82];
        // Brute force over every way to cut the sorted list into consecutive groups.
        for count in 1..=6 {
            let best = (0..1u32 << (lengths.len() - 1))
                .filter(|cuts| (cuts.count_ones() as usize) < count)
                .map(|cuts| {
                    let (mut widest, mut first) = (0.0f64, 0);
                    for k in 0..lengths.len() {
                        if k + 1 == lengths.len() || cuts >> k & 1 == 1 {
                            widest = widest.max(lengths[k] - lengths[first]);
                            first = k + 1;
                        }
                    }
                    widest / 2.0
                })
                .fold(f64::INFINITY, f64::min);
            let (half, middles) = cover(&lengths, count);
            assert!((half - best).abs() < 1e-12 && middles.len() <= count, "{count}: {half} {best}");
        }
    }

    #[test]
    fn the_ladder_ends_with_the_largest() {
        assert_eq!(ladder(1), [1]);
        assert_eq!(ladder(10), [1, 2, 3, 4, 6, 8, 10]);
        assert_eq!(ladder(12), [1, 2, 3, 4, 6, 8, 12]);
    }
}
