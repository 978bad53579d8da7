//! Flips members of the rim so that fewer different lengths are left. The nodes stay where they are.
//!
//! A member between two triangles is replaced by the other diagonal of their quadrilateral if that diagonal is nearer
//! to a shared length ([`flip_towards`]), or if the number of different lengths becomes smaller
//! ([`flip_to_fewer_lengths`]). If the number stays, the flip is made where it gathers the members on fewer of the
//! lengths, because a later flip can then empty one. Lattice members, members of the boundary, and members whose other
//! diagonal would be outside [ℓ, 2ℓ] stay. No flip makes an angle below 20 degrees smaller.

use super::move_nodes::{OnSurface, Sheet};
use crate::measure::is_in_range;
use plateau_mesh::DVec3;
use plateau_mesh::execution::{Execution, Interruption};
use std::collections::{BTreeMap, BTreeSet};

/// Cosine of the smallest angle that a flip may make: 20 degrees, as films keep it.
const LARGEST_COSINE: f64 = 0.939_692_620_785_908_4;
/// Maximum number of passes over the members. Two or three are usual.
const PASSES: usize = 12;
/// Least gain of the gathering of the members, above the rounding of the sum.
const LEAST_GAIN: f64 = 1e-9;

/// The nearest of some sorted lengths.
pub(super) fn nearest(sorted: &[f64], length: f64) -> f64 {
    let k = sorted.partition_point(|&other| other < length);
    let candidates = sorted[k.saturating_sub(1)..(k + 1).min(sorted.len())].iter().copied();
    candidates.min_by(|a, b| (a - length).abs().total_cmp(&(b - length).abs())).unwrap_or(length)
}

/// How the members are spread over the lengths: the number of lengths that differ by more than the tolerance, and the
/// sum of the square roots of their numbers of members. The sum is smaller if the members gather on few lengths.
fn spread(sorted: &[f64], tolerance: f64) -> (usize, f64) {
    let (mut kinds, mut sum, mut first) = (0, 0.0, 0);
    // At most as many passes as lengths, because the length at `first` is within the tolerance of itself.
    while first < sorted.len() {
        let members = sorted[first..].partition_point(|&length| length <= sorted[first] + tolerance);
        (kinds, sum) = (kinds + 1, sum + (members as f64).sqrt());
        first += members;
    }
    (kinds, sum)
}

/// The cosine of a triangle's smallest angle.
fn largest_cosine([a, b, c]: [DVec3; 3]) -> f64 {
    let cosine = |[p, q, r]: [DVec3; 3]| (q - p).normalize_or_zero().dot((r - p).normalize_or_zero());
    [[a, b, c], [b, c, a], [c, a, b]].map(cosine).into_iter().fold(-1.0, f64::max)
}

/// Flips members of the rim so that fewer lengths differ by more than the tolerance. Members keep their numbers.
///
/// # Errors
/// The interruption. The flips made until then remain, and the mesh is valid.
pub(super) fn flip_to_fewer_lengths<S: Sheet>(
    nodes: &mut OnSurface<'_, S>,
    tolerance: f64,
    execution: &Execution<'_>,
) -> Result<(), Interruption> {
    let mut sorted = nodes.lengths();
    sorted.sort_unstable_by(f64::total_cmp);
    let mut best = spread(&sorted, tolerance);
    let mut accepts = |old: f64, new: f64| {
        let mut flipped = sorted.clone();
        flipped.remove(flipped.partition_point(|&other| other < old));
        flipped.insert(flipped.partition_point(|&other| other < new), new);
        let after = spread(&flipped, tolerance);
        let is_better = after.0 < best.0 || after.0 == best.0 && after.1 < best.1 - LEAST_GAIN;
        if is_better {
            (sorted, best) = (flipped, after);
        }
        is_better
    };
    flip_members(nodes, &mut accepts, execution)
}

/// Flips members of the rim whose other diagonal is nearer to one of the sorted `shared` lengths, if their difference is
/// above half of the largest. Members keep their numbers.
///
/// # Errors
/// As [`flip_to_fewer_lengths`].
pub(super) fn flip_towards<S: Sheet>(
    nodes: &mut OnSurface<'_, S>,
    shared: &[f64],
    execution: &Execution<'_>,
) -> Result<(), Interruption> {
    let off = |length: f64| (length - nearest(shared, length)).abs();
    let largest = nodes.lengths().into_iter().map(off).fold(0.0, f64::max);
    let mut accepts = |old: f64, new: f64| off(old) > 0.5 * largest && off(new) < off(old) - LEAST_GAIN;
    flip_members(nodes, &mut accepts, execution)
}

/// Flips the members of the rim for which `accepts` takes the length of the other diagonal in place of their own.
fn flip_members<S: Sheet>(
    nodes: &mut OnSurface<'_, S>,
    accepts: &mut dyn FnMut(f64, f64) -> bool,
    execution: &Execution<'_>,
) -> Result<(), Interruption> {
    let sorted_pair = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
    let mut lengths = nodes.lengths();
    let mut existing: BTreeSet<[u32; 2]> = nodes.members.iter().map(|&member| sorted_pair(member)).collect();
    for _ in 0..PASSES {
        execution.look(nodes.triangles.len() as u64)?;
        let mut sides: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        for (t, &[a, b, c]) in nodes.triangles.iter().enumerate() {
            for side in [[a, b], [b, c], [c, a]] {
                sides.entry(sorted_pair(side)).or_default().push(t);
            }
        }
        // `sides` does not know the new triangles of a flip, so they wait for the next pass.
        let mut is_changed = vec![false; nodes.triangles.len()];
        let mut flips = 0;
        for member in (0..nodes.members.len()).filter(|&member| !nodes.lattice_group[member]) {
            let [one, other] = match sides.get(&sorted_pair(nodes.members[member])).map(Vec::as_slice) {
                Some(&[one, other]) if !is_changed[one] && !is_changed[other] => [one, other],
                _ => continue,
            };
            let Some(Flip { ends, triangles }) = flip(nodes, nodes.members[member], [one, other]) else { continue };
            let [c, d] = ends.map(|v| nodes.positions[v as usize]);
            let length = c.distance(d);
            if existing.contains(&sorted_pair(ends)) || !is_in_range(length) || !accepts(lengths[member], length) {
                continue;
            }
            existing.remove(&sorted_pair(nodes.members[member]));
            existing.insert(sorted_pair(ends));
            (nodes.members[member], lengths[member]) = (ends, length);
            [nodes.triangles[one], nodes.triangles[other]] = triangles;
            [is_changed[one], is_changed[other]] = [true; 2];
            flips += 1;
        }
        if flips == 0 {
            break;
        }
    }
    Ok(())
}

struct Flip {
    /// The ends of the other diagonal.
    ends: [u32; 2],
    /// The two triangles beside it.
    triangles: [[u32; 3]; 2],
}

/// Returns the flip of the member between two triangles, or `None` if it would turn a triangle over or make an angle
/// too small.
fn flip<S: Sheet>(nodes: &OnSurface<'_, S>, member: [u32; 2], sides: [usize; 2]) -> Option<Flip> {
    let old = sides.map(|t| nodes.triangles[t]);
    // The first triangle runs from a to b, the second from b to a.
    let k = (0..3).find(|&k| !member.contains(&old[0][k]))?;
    let [c, a, b] = [0, 1, 2].map(|step| old[0][(k + step) % 3]);
    let d = old[1].into_iter().find(|v| !member.contains(v))?;
    let triangles = [[a, d, c], [d, b, c]];
    let located = |v: u32| (nodes.parameters[v as usize], nodes.positions[v as usize]);
    if c == d || !nodes.surface.are_upright(&triangles, &located) {
        return None;
    }
    let largest = |triangles: [[u32; 3]; 2]| {
        let cosines = triangles.map(|t| largest_cosine(t.map(|v| nodes.positions[v as usize])));
        cosines[0].max(cosines[1])
    };
    (largest(triangles) <= largest(old).max(LARGEST_COSINE)).then_some(Flip { ends: [c, d], triangles })
}
