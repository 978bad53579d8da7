//! Pairs of rails with a known direction, from the tests of the geometry crate.

#[path = "../../crates/ruled-surface/tests/it/ruled/pairs.rs"]
#[allow(dead_code, reason = "the names of the pairs are for the geometry's own test")]
mod of_geometry;

use of_geometry::{Pair, closed_pair, open_pair};
use plateau_mesh::random::SplitMix64;

/// Two rails as a request has them.
type Rails = [Vec<[f64; 3]>; 2];

/// Returns some pairs as they are and with the second rail reversed: the rails, whether the second one runs against the
/// first, and whether they are closed.
pub fn some_pairs() -> Vec<(Rails, bool, bool)> {
    let mut random = SplitMix64::new(41);
    let mut pairs = Vec::new();
    for k in 0..30 {
        let Pair { rails, closed, .. } = if k % 3 == 2 { closed_pair(&mut random) } else { open_pair(&mut random) };
        for runs_against in [false, true] {
            let mut rails = rails.clone().map(|rail| rail.iter().map(|point| point.to_array()).collect::<Vec<_>>());
            if runs_against {
                rails[1].reverse();
            }
            pairs.push((rails, runs_against, closed));
        }
    }
    pairs
}
