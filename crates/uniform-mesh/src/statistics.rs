//! The statistics of Katoh, Ohsaki and Xu's Table 1, and further statistics for fabricators.

use plateau_mesh::measure::Spread;

/// The statistics of a group of edges at one stage: a row of Table 1 with two more columns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Group {
    /// Count, minimum, mean, maximum, standard deviation (of the whole population).
    pub lengths: Spread,
    /// Number of edges whose length differs from ℓ by at most the tolerance.
    pub equal_edges: usize,
    /// The smallest number of different lengths that a workshop has to cut: see [`distinct_lengths`].
    pub distinct_lengths: usize,
}

impl Group {
    /// The statistics of these lengths, compared with the target length. O(n log n).
    #[must_use]
    pub fn of(lengths: &[f64], target: f64, tolerance: f64) -> Self {
        Self {
            lengths: Spread::of(lengths.iter().copied()),
            equal_edges: lengths.iter().filter(|&&length| (length - target).abs() <= tolerance).count(),
            distinct_lengths: distinct_lengths(lengths, tolerance),
        }
    }
}

/// The statistics of one stage of a solve, in the order of Table 1.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Stage {
    /// The name of the stage: `auxiliary_surface`, `auxiliary_plane`, `plane`, `surface`, `optimised_nodes` or
    /// `shared_lengths`.
    pub name: &'static str,
    /// All edges.
    pub all: Group,
    /// The lattice group G1. `None` for the auxiliary triangulation, which has no lattice.
    pub lattice: Option<Group>,
}

/// Histogram of lengths. Bin k counts lengths from `from` + k · `width` up to the next bin.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LengthHistogram {
    /// Smallest length that bin 0 counts.
    pub from: f64,
    /// Width of a bin.
    pub width: f64,
    /// Number of edges in each bin.
    pub counts: Vec<usize>,
}

impl LengthHistogram {
    /// Counts lengths in bins whose width is a twentieth of the target length. The width is doubled until at most about
    /// 100 bins are needed. Bins start at multiples of their width.
    #[must_use]
    pub fn of(lengths: &[f64], target: f64) -> Self {
        let (low, high) =
            lengths.iter().fold((f64::INFINITY, 0.0), |(low, high), &l| (f64::min(low, l), f64::max(high, l)));
        if lengths.is_empty() {
            return Self::default();
        }
        let mut width = (target / 20.0).max(f64::MIN_POSITIVE);
        // Equal lengths differ by rounding. A small shift keeps lengths of about ℓ together in the bin that starts at
        // ℓ.
        let nudge = 1e-6 * width;
        // At most 2,100 passes, because the width starts above 0 and doubles in each.
        while (high - low) / width > 100.0 {
            width *= 2.0;
        }
        let bin = |length: f64| ((length + nudge) / width).floor();
        let first = bin(low);
        let mut counts = vec![0; (bin(high) - first) as usize + 1];
        for &length in lengths {
            counts[(bin(length) - first) as usize] += 1;
        }
        Self { from: first * width, width, counts }
    }
}

/// The smallest number of groups into which members can be sorted so that the lengths in each group differ by at most
/// `tolerance`.
///
/// The groups are formed greedily from the shortest length, which is optimal for numbers on a line. O(n log n). Merging
/// neighbouring lengths that are closer than the tolerance would be wrong, because it would count a continuous range of
/// lengths as one length.
#[must_use]
pub fn distinct_lengths(lengths: &[f64], tolerance: f64) -> usize {
    let mut sorted = lengths.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let (mut kinds, mut limit) = (0, f64::NEG_INFINITY);
    for length in sorted {
        if length > limit {
            kinds += 1;
            limit = length + tolerance;
        }
    }
    kinds
}

/// The number of nodes for each valence: entry k counts the nodes with k members.
#[must_use]
pub fn valences(members: &[[u32; 2]], nodes: usize) -> Vec<usize> {
    let mut valence = vec![0usize; nodes];
    for &end in members.iter().flatten() {
        valence[end as usize] += 1;
    }
    let mut counts = vec![0; valence.iter().max().map_or(0, |most| most + 1)];
    for k in valence {
        counts[k] += 1;
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spread_of_lengths_is_not_one_length() {
        let lengths: Vec<f64> = (0..101).map(|k| f64::from(k) * 0.01).collect();
        assert_eq!(distinct_lengths(&lengths, 0.0101), 51);
        assert_eq!(distinct_lengths(&lengths, 2.0), 1);
        assert_eq!(distinct_lengths(&[], 0.1), 0);
    }

    #[test]
    fn histogram_counts_every_edge_once_and_keeps_equal_lengths_together() {
        let lengths = [5.0 - 1e-12, 5.0, 5.0 + 1e-12, 5.3, 9.99];
        let histogram = LengthHistogram::of(&lengths, 5.0);
        assert_eq!(histogram.counts.iter().sum::<usize>(), 5);
        assert_eq!((histogram.from, histogram.counts[0], histogram.counts[1]), (5.0, 3, 1));
        assert!(LengthHistogram::of(&[0.0, 1e12], 5.0).counts.len() <= 102);
    }

    #[test]
    fn valences_of_two_triangles() {
        assert_eq!(valences(&[[0, 1], [1, 2], [2, 0], [1, 3], [3, 2]], 4), [0, 0, 2, 2]);
    }
}
