//! Fewer distinct lengths, so that a workshop cuts fewer different members. The paper has no such step.
//!
//! 1. Find the k lengths that come nearest to all members. They are the middles of k intervals of equal width that
//!    cover the sorted lengths and are as narrow as possible (greedy cover and bisection, exact on a line).
//! 2. Move the inner nodes on the surface to minimise Σ (L - c)², where c is the middle of the member's interval.
//! 3. Repeat while the intervals get narrower. The narrowest intervals are kept. Then do the same once more with
//!    1.5 k middles, because members follow a near length more easily than a far one.
//! 4. Narrow the intervals further ([`Search::narrow`]): only the members outside narrower intervals pull at the nodes,
//!    and diagonals of the rim that are far from a middle change ([`rim_flips`](super::rim_flips)). The sum of squares
//!    alone stops early, because it weighs one far member as much as many near ones.
//!
//! These steps are repeated for increasing k up to the largest allowed, each time from the same start. The repetition
//! ends with the first k whose intervals are no wider than the tolerance. Members between two nodes that do not move
//! keep their lengths, but they are covered too.
//!
//! If k lengths are not reached, a second search lowers the number of lengths that differ by more than the tolerance
//! ([`fewer`]). A workshop gains from each length that it need not cut.
//!
//! A lattice member of length ℓ keeps its length, because its ends do not move. Nodes with more lengths than at the
//! start, or with more members outside [ℓ, 2ℓ], are not accepted.

use super::move_nodes::{Effort, OnSurface, Sheet, TargetLength, refine};
use super::rim_flips::{flip_to_fewer_lengths, flip_towards, nearest};
use crate::measure::{RANGE_TOLERANCE, is_in_range};
use crate::report::LengthsRow;
use crate::statistics::distinct_lengths;
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

/// The two numbers that no result may exceed at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Counts {
    /// Number of different lengths, with the tolerance of the request.
    lengths: usize,
    /// Number of members outside [ℓ, 2ℓ].
    out_of_range: usize,
}

impl Counts {
    fn of(lengths: &[f64], tolerance: f64) -> Self {
        let out_of_range = lengths.iter().filter(|&&length| !is_in_range(length)).count();
        Self { lengths: distinct_lengths(lengths, tolerance), out_of_range }
    }
}

/// The same nodes in an order in which the ends of lattice members of length ℓ stand before the moving nodes, and the
/// number that each node has in `nodes`.
fn held<'a, S: Sheet>(nodes: &OnSurface<'a, S>) -> (OnSurface<'a, S>, Vec<u32>) {
    let mut is_held = vec![false; nodes.positions.len()];
    is_held[..nodes.fixed].fill(true);
    for ((member, length), &is_lattice) in nodes.members.iter().zip(nodes.lengths()).zip(&nodes.lattice_group) {
        if is_lattice && (length - 1.0).abs() <= RANGE_TOLERANCE {
            member.iter().for_each(|&v| is_held[v as usize] = true);
        }
    }
    let (mut order, moving): (Vec<u32>, Vec<u32>) = (0..is_held.len() as u32).partition(|&v| is_held[v as usize]);
    let fixed = order.len();
    order.extend(moving);
    let mut places = vec![0; order.len()];
    order.iter().zip(0..).for_each(|(&v, place)| places[v as usize] = place);
    let held = OnSurface {
        surface: nodes.surface,
        parameters: order.iter().map(|&v| nodes.parameters[v as usize]).collect(),
        positions: order.iter().map(|&v| nodes.positions[v as usize]).collect(),
        fixed,
        triangles: nodes.triangles.iter().map(|t| t.map(|v| places[v as usize])).collect(),
        members: nodes.members.iter().map(|m| m.map(|v| places[v as usize])).collect(),
        lattice_group: nodes.lattice_group.clone(),
    };
    (held, order)
}

/// One move of the nodes towards shared lengths.
struct Pull<'a, 'b> {
    /// For each member whether it is in [ℓ, 2ℓ] at the start.
    in_range: &'a [bool],
    /// For each member whether a move has taken it out of [ℓ, 2ℓ]. The member is then only held in the range.
    is_bounded: Vec<bool>,
    effort: Effort,
    execution: &'a Execution<'b>,
}

impl Pull<'_, '_> {
    /// Moves the nodes so that each member comes near to the nearest of the sorted `shared` lengths. `weight` gives the
    /// weight of a member for its difference.
    fn towards<S: Sheet>(
        &mut self,
        nodes: &mut OnSurface<'_, S>,
        shared: &[f64],
        weight: impl Fn(f64) -> f64,
        span: (f64, f64),
    ) -> Option<Interruption> {
        let lengths = nodes.lengths();
        let mut targets = Vec::with_capacity(lengths.len());
        for (member, &length) in lengths.iter().enumerate() {
            let may_leave = !self.in_range[member];
            self.is_bounded[member] |= !may_leave && !is_in_range(length);
            let target = nearest(shared, length);
            targets.push(if self.is_bounded[member] {
                TargetLength::Within(1.0)
            } else {
                let weight = weight((length - target).abs());
                TargetLength::Weighted { length: if may_leave { target } else { target.clamp(1.0, 2.0) }, weight }
            });
        }
        refine(nodes, &targets, self.effort, "share_lengths", span, self.execution)
    }
}

/// Moves the inner nodes until the members have at most `most` lengths and each member is within half of `tolerance`
/// (in ℓ) of its length. If that is not reached, nodes with fewer lengths, or nearer to `most` lengths, are kept.
/// Returns a row for every number of lengths tried (in ℓ). `nodes` are those of the last row. Nodes that have at most
/// `most` lengths stay where they are.
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
    let (start, order) = held(nodes);
    let before = sorted(&start);
    let counts = Counts::of(&before, tolerance);
    if counts.lengths <= most {
        let deviation = cover(&before, counts.lengths).0;
        return (vec![LengthsRow { lengths: counts.lengths, deviation, deviation_before: deviation }], None);
    }
    let in_range: Vec<bool> = start.lengths().into_iter().map(is_in_range).collect();
    let effort = Effort { attempts: 1, ..start.surface.effort() };
    let search = Search { counts, in_range: &in_range, tolerance, effort, execution };
    let ladder = ladder(most);
    let part = |k: usize| from + (to - from) * k as f64 / (ladder.len() + 1) as f64;
    let (mut rows, mut found, mut interrupted) = (Vec::new(), start.clone(), None);
    for (rung, &count) in ladder.iter().enumerate() {
        let deviation_before = cover(&before, count).0;
        let mut best = Nearest { count, deviation: deviation_before, nodes: start.clone() };
        interrupted = search.nearest(&mut best, (part(rung), part(rung + 1)));
        rows.push(LengthsRow { lengths: count, deviation: best.deviation, deviation_before });
        let is_reached = search.reaches(best.deviation);
        found = best.nodes;
        if interrupted.is_some() || is_reached {
            break;
        }
    }
    if let (None, Some(row)) = (interrupted, rows.last_mut())
        && !search.reaches(row.deviation)
    {
        let goal = Goal { most, allowed: row.deviation.max(LARGEST_DEVIATION * row.deviation_before) };
        (found, interrupted) = fewer(&start, found, &goal, &search, (part(ladder.len()), to));
        row.deviation = cover(&sorted(&found), most).0;
    } else if let (Some(_), Some(row)) = (interrupted, rows.last_mut())
        && Counts::of(&sorted(&found), tolerance).lengths > counts.lengths
    {
        (found, row.deviation) = (start, row.deviation_before);
    }
    for ((&v, &parameter), &position) in order.iter().zip(&found.parameters).zip(&found.positions) {
        (nodes.parameters[v as usize], nodes.positions[v as usize]) = (parameter, position);
    }
    nodes.triangles = found.triangles.into_iter().map(|t| t.map(|v| order[v as usize])).collect();
    nodes.members = found.members.into_iter().map(|m| m.map(|v| order[v as usize])).collect();
    (rows, interrupted)
}

/// Limits of all searches from one start.
struct Search<'a, 'b> {
    /// The counts at the start.
    counts: Counts,
    /// For each member whether it is in [ℓ, 2ℓ] at the start.
    in_range: &'a [bool],
    tolerance: f64,
    effort: Effort,
    execution: &'a Execution<'b>,
}

/// Nodes whose members are near to `count` lengths.
struct Nearest<'a, S: Sheet> {
    count: usize,
    /// Largest difference of a member from the nearest of `count` lengths.
    deviation: f64,
    nodes: OnSurface<'a, S>,
}

impl<'p, 'e> Search<'p, 'e> {
    /// Whether members with this deviation count as equal.
    fn reaches(&self, deviation: f64) -> bool {
        2.0 * deviation <= self.tolerance
    }

    fn pull(&self) -> Pull<'p, 'e> {
        let is_bounded = vec![false; self.in_range.len()];
        Pull { in_range: self.in_range, is_bounded, effort: self.effort, execution: self.execution }
    }

    /// Moves the nodes as near to `best.count` lengths as the search can bring them.
    fn nearest<S: Sheet>(&self, best: &mut Nearest<'_, S>, (from, to): (f64, f64)) -> Option<Interruption> {
        let part = |k: usize| from + (to - from) * k as f64 / (MIDDLES.len() + 1) as f64;
        for (k, more) in MIDDLES.into_iter().enumerate() {
            let aimed = (best.count as f64 * more) as usize;
            if let Some(interruption) = self.follow(best, aimed, (part(k), part(k + 1))) {
                return Some(interruption);
            }
        }
        self.narrow(best, (part(MIDDLES.len()), to))
    }

    /// Pulls the members to the middles of the narrowest cover by `aimed` intervals, again and again.
    fn follow<S: Sheet>(
        &self,
        best: &mut Nearest<'_, S>,
        aimed: usize,
        (from, to): (f64, f64),
    ) -> Option<Interruption> {
        let (mut here, mut pull, mut idle) = (best.nodes.clone(), self.pull(), 0);
        let part = |round: usize| from + (to - from) * round as f64 / ROUNDS as f64;
        for round in 0..ROUNDS {
            if idle == IDLE_ROUNDS || self.reaches(best.deviation) {
                break;
            }
            let middles = cover(&sorted(&here), aimed).1;
            let interrupted = pull.towards(&mut here, &middles, |_| 1.0, (part(round), part(round + 1)));
            let before = best.deviation;
            self.keep(best, &here);
            idle = if best.deviation < before * 0.999 { 0 } else { idle + 1 };
            if interrupted.is_some() {
                return interrupted;
            }
        }
        None
    }

    /// Replaces the best nodes by these if they are nearer and no more members are out of range than at the start.
    fn keep<S: Sheet>(&self, best: &mut Nearest<'_, S>, here: &OnSurface<'_, S>) {
        let lengths = sorted(here);
        let deviation = cover(&lengths, best.count).0;
        if deviation < best.deviation && Counts::of(&lengths, self.tolerance).out_of_range <= self.counts.out_of_range {
            best.deviation = deviation;
            best.nodes.take(here);
        }
    }

    /// Narrows the cover in steps. In each step every member has the bounds of a narrower interval instead of a target,
    /// so that only the members outside pull at the nodes.
    fn narrow<S: Sheet>(&self, best: &mut Nearest<'_, S>, (from, to): (f64, f64)) -> Option<Interruption> {
        let part = |step: usize| from + (to - from) * step as f64 / NARROWINGS as f64;
        let (mut cut, mut here, mut tries) = (FIRST_NARROWING, best.nodes.clone(), 0);
        for step in 0..NARROWINGS {
            let before = best.deviation;
            if cut < LEAST_NARROWING || self.reaches(before) {
                break;
            }
            // Moves cannot bring the members whose ends are held any nearer, but flips can.
            let least = cover(&held_lengths(&here), best.count).0;
            // Half of the tolerance less a little for what the moves leave over.
            let half = (before * (1.0 - cut)).max(0.499 * self.tolerance).max(least);
            let middles = middles(&here, half, best.count);
            if let Err(interruption) = flip_towards(&mut here, &middles, self.execution) {
                return Some(interruption);
            }
            let targets: Vec<TargetLength> = here
                .lengths()
                .into_iter()
                .zip(self.in_range)
                .map(|(length, &is_in_range)| {
                    let middle = nearest(&middles, length);
                    let [low, high] = [middle - half, middle + half];
                    TargetLength::Between(if is_in_range {
                        [low.clamp(1.0, 2.0 - LEAST_RANGE), high.clamp(1.0 + LEAST_RANGE, 2.0)]
                    } else {
                        [low, high]
                    })
                })
                .collect();
            let span = (part(step), part(step + 1));
            let interrupted = refine(&mut here, &targets, self.effort, "share_lengths", span, self.execution);
            self.keep(best, &here);
            tries += 1;
            if best.deviation < before * (1.0 - 0.5 * cut) {
                (cut, tries) = ((2.0 * cut).min(LARGEST_NARROWING), 0);
            } else if tries == TRIES {
                (cut, tries) = (0.5 * cut, 0);
                here.take(&best.nodes);
            }
            if interrupted.is_some() {
                return interrupted;
            }
        }
        None
    }
}

/// Lengths of the members whose ends do not move, in order.
fn held_lengths<S: Sheet>(nodes: &OnSurface<'_, S>) -> Vec<f64> {
    let mut lengths: Vec<f64> = nodes
        .lengths()
        .into_iter()
        .zip(&nodes.members)
        .filter(|(_, member)| nodes.holds(member))
        .map(|m| m.0)
        .collect();
    lengths.sort_unstable_by(f64::total_cmp);
    lengths
}

/// Returns the middles of at most `count` intervals of half-width `half`. The intervals hold all members whose ends do
/// not move, if that is possible, and the largest distance of another member from them is as small as possible.
fn middles<S: Sheet>(nodes: &OnSurface<'_, S>, half: f64, count: usize) -> Vec<f64> {
    let is_held = nodes.members.iter().map(|member| nodes.holds(member));
    let members: Vec<(f64, bool)> = nodes.lengths().into_iter().zip(is_held).collect();
    let lengths = || members.iter().map(|member| member.0);
    // With the largest difference of two lengths as the distance, every member may belong to every interval.
    let (mut low, mut high) = (0.0, lengths().fold(0.0, f64::max) - lengths().fold(f64::INFINITY, f64::min));
    let cover = || cover(&sorted(nodes), count).1;
    let mut best = common_points(&members, half, high, count).unwrap_or_else(cover);
    for _ in 0..HALVINGS {
        let distance = 0.5 * (low + high);
        match common_points(&members, half, distance, count) {
            Some(middles) => (best, high) = (middles, distance),
            None => low = distance,
        }
    }
    best
}

/// Returns at most `count` points, so that each length is within `half` of one if it is held, or else within `half` and
/// `distance`. `None` if more points are needed. Each point is the middle of the range that serves its lengths.
///
/// The points are found greedily from the range that ends first, which gives the fewest.
fn common_points(members: &[(f64, bool)], half: f64, distance: f64, count: usize) -> Option<Vec<f64>> {
    let range = |&(length, is_held): &(f64, bool)| {
        let reach = half * (1.0 + 1e-12) + if is_held { 0.0 } else { distance };
        (length - reach, length + reach)
    };
    let mut ranges: Vec<(f64, f64)> = members.iter().map(range).collect();
    ranges.sort_unstable_by(|a, b| a.1.total_cmp(&b.1));
    let mut common: Vec<(f64, f64)> = Vec::new();
    for (low, high) in ranges {
        match common.last_mut() {
            Some(last) if low <= last.1 => last.0 = last.0.max(low),
            _ => common.push((low, high)),
        }
        if common.len() > count {
            return None;
        }
    }
    Some(common.into_iter().map(|(low, high)| 0.5 * (low + high)).collect())
}

/// The aim of [`fewer`].
struct Goal {
    most: usize,
    /// Largest difference of a member from the nearest of `most` lengths.
    allowed: f64,
}

/// Lowers the number of lengths that differ by more than the tolerance, from `start` and from `found`, and returns the
/// acceptable nodes with the fewest lengths.
///
/// Two unknowns of each moving node cannot make all members shared, so a member far from a shared length is pulled
/// with less weight than one near it (the reweighting of a sparse fit): some members then fall together exactly.
fn fewer<'a, S: Sheet>(
    start: &OnSurface<'a, S>,
    found: OnSurface<'a, S>,
    goal: &Goal,
    search: &Search<'_, '_>,
    (from, to): (f64, f64),
) -> (OnSurface<'a, S>, Option<Interruption>) {
    let tolerance = search.tolerance;
    let state = |nodes: OnSurface<'a, S>| {
        let lengths = sorted(&nodes);
        let (counts, deviation) = (Counts::of(&lengths, tolerance), cover(&lengths, goal.most).0);
        let is_accepted = counts.lengths <= search.counts.lengths
            && counts.out_of_range <= search.counts.out_of_range
            && deviation <= goal.allowed;
        State { is_accepted, counts, deviation, lengths, nodes }
    };
    let mut best = state(start.clone());
    for (way, begin) in [found, start.clone()].into_iter().enumerate() {
        let span = |attempt: usize, round: usize| {
            let part = (attempt * SHARPNESS.len() + round) as f64 / (ATTEMPTS * SHARPNESS.len()) as f64;
            from + (to - from) * 0.5 * (way as f64 + part)
        };
        let mut here = state(begin);
        let mut cut = FIRST_CUT;
        for attempt in 0..ATTEMPTS {
            best.replace_if_worse(&here);
            let mut flipped = here.nodes.clone();
            if let Err(interruption) = flip_to_fewer_lengths(&mut flipped, tolerance, search.execution) {
                return (best.nodes, Some(interruption));
            }
            let flipped = state(flipped);
            if flipped.is_accepted || !here.is_accepted {
                here = flipped;
            }
            best.replace_if_worse(&here);
            let count = ((here.counts.lengths as f64 * (1.0 - cut)) as usize).max(goal.most);
            if count >= here.counts.lengths {
                break;
            }
            let (mut tried, mut pull, mut is_fewer) = (here.nodes.clone(), search.pull(), false);
            let mut middles = modes(&here.lengths, count, tolerance);
            for (round, sharpness) in SHARPNESS.into_iter().enumerate() {
                let near = sharpness * tolerance;
                let weight = |off: f64| (1.0 + (off / near).powi(2)).sqrt().recip();
                let span = (span(attempt, round), span(attempt, round + 1));
                if let Some(interruption) = pull.towards(&mut tried, &middles, weight, span) {
                    return (best.nodes, Some(interruption));
                }
                let after = state(tried.clone());
                middles = modes(&after.lengths, count, tolerance);
                if after.counts.lengths < here.counts.lengths && (after.is_accepted || !here.is_accepted) {
                    (here, is_fewer) = (after, true);
                }
            }
            cut = if is_fewer { cut } else { 0.5 * cut };
        }
        best.replace_if_worse(&here);
    }
    (best.nodes, None)
}

/// Nodes with their figures.
struct State<'a, S: Sheet> {
    nodes: OnSurface<'a, S>,
    /// The lengths of the members in order.
    lengths: Vec<f64>,
    counts: Counts,
    /// Largest difference of a member from the nearest of the lengths that are allowed.
    deviation: f64,
    is_accepted: bool,
}

impl<S: Sheet> State<'_, S> {
    /// Becomes the other state if that is accepted and has fewer lengths, or as many and a smaller deviation.
    fn replace_if_worse(&mut self, other: &Self) {
        let figures = |state: &Self| (state.counts.lengths, state.deviation);
        if other.is_accepted && figures(other) < figures(self) {
            (self.nodes, self.lengths) = (other.nodes.clone(), other.lengths.clone());
            (self.counts, self.deviation) = (other.counts, other.deviation);
        }
    }
}

/// Returns the fullest length of each of the narrowest `count` intervals that cover the sorted lengths: the middle of
/// the lengths within a tolerance that most members have.
fn modes(sorted: &[f64], count: usize, tolerance: f64) -> Vec<f64> {
    let (half, middles) = cover(sorted, count);
    let mode = |middle: f64| {
        let reach = half * (1.0 + 1e-9) + f64::EPSILON;
        let from = sorted.partition_point(|&length| length < middle - reach);
        let to = sorted.partition_point(|&length| length <= middle + reach);
        let own = &sorted[from..to];
        let until = |first: f64| own.partition_point(|&length| length <= first + tolerance);
        let fullest =
            (0..own.len()).map(|k| (until(own[k]) - k, k)).max_by_key(|&(members, k)| (members, usize::MAX - k));
        fullest.map_or(middle, |(members, k)| 0.5 * (own[k] + own[k + members - 1]))
    };
    middles.into_iter().map(mode).collect()
}

/// Numbers of lengths that the members are pulled to, as multiples of the number that is searched for.
const MIDDLES: [f64; 2] = [1.0, 1.5];
/// Maximum number of rounds of moving nodes and covering lengths.
const ROUNDS: usize = 12;
/// Number of rounds without a narrower cover after which the rounds end.
const IDLE_ROUNDS: usize = 6;
/// Part of its width by which the first step narrows the cover. A step that succeeds doubles the part for the next one.
const FIRST_NARROWING: f64 = 0.1;
/// Largest part of its width by which a step narrows the cover.
const LARGEST_NARROWING: f64 = 0.5;
/// Part of the width below which narrowing ends.
const LEAST_NARROWING: f64 = 0.004;
/// Maximum number of steps that narrow a cover.
const NARROWINGS: usize = 40;
/// Number of steps in a row without a narrower cover after which the part is halved.
const TRIES: usize = 2;
/// Least difference between the bounds of a member, in ℓ: above the margin of the bounds.
const LEAST_RANGE: f64 = 1e-6;
/// Number of halvings of the distance of members from their intervals. Its last digits do not matter.
const HALVINGS: usize = 20;
/// Deviation from the number of lengths asked for that [`fewer`] may leave, relative to that at the start. It may leave
/// more than the nearest nodes have, because lengths that are not reached are worth less than lengths that are saved.
const LARGEST_DEVIATION: f64 = 0.85;
/// Number of attempts of [`fewer`] to lower the number of lengths, from each of its two starts.
const ATTEMPTS: usize = 6;
/// Part of the lengths that the first attempt is to save. An attempt that saves none is followed by one for half of it.
const FIRST_CUT: f64 = 0.3;
/// Difference of a member, in tolerances, at which its weight has fallen to 1/√2, in each round of an attempt.
const SHARPNESS: [f64; 5] = [32.0, 8.0, 2.0, 0.5, 0.25];

#[cfg(test)]
mod tests {
    use super::super::auxiliary::Surface;
    use super::*;
    use plateau_mesh::DVec2;

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
    fn common_points_are_as_few_as_possible_and_near_every_length() {
        let held = [(1.0, true), (1.02, true), (1.3, true), (1.31, true)];
        let members = [&held[..], &[(1.11, false), (1.18, false), (1.45, false)]].concat();
        for (distance, fewest) in [(0.0, 5), (0.05, 4), (0.1, 3), (0.13, 2), (1.0, 2)] {
            assert_eq!(common_points(&members, 0.02, distance, fewest - 1), None, "{distance}");
            let points = common_points(&members, 0.02, distance, fewest).unwrap();
            for &(length, is_held) in &members {
                let off = (length - nearest(&points, length)).abs();
                assert!(off <= 0.02 + 1e-9 + if is_held { 0.0 } else { distance }, "{distance}: {length} {points:?}");
            }
        }
    }

    /// A lattice of rows along x, whose members have the length `along`. `rows[j]` is the step from a node of row j to
    /// one of the next row.
    fn lattice(columns: usize, along: f64, rows: &[[f64; 2]]) -> OnSurface<'static, Surface> {
        let mut places = vec![DVec2::ZERO];
        places.extend(rows.iter().scan(DVec2::ZERO, |at, &row| {
            *at += DVec2::from(row);
            Some(*at)
        }));
        let is_inner = |i: usize, j: usize| i > 0 && i < columns && j > 0 && j < rows.len();
        let all = || (0..=rows.len()).flat_map(|j| (0..=columns).map(move |i| (i, j)));
        let mut order: Vec<(usize, usize)> = all().filter(|&(i, j)| !is_inner(i, j)).collect();
        let fixed = order.len();
        order.extend(all().filter(|&(i, j)| is_inner(i, j)));
        let number = |i: usize, j: usize| order.iter().position(|&node| node == (i, j)).unwrap() as u32;
        let mut members = Vec::new();
        let mut triangles = Vec::new();
        for (i, j) in all() {
            let steps = [(i + 1, j), (i, j + 1), (i.wrapping_sub(1), j + 1)];
            for (k, l) in steps.into_iter().filter(|&(k, l)| k <= columns && l <= rows.len()) {
                members.push([number(i, j), number(k, l)]);
            }
            if i < columns && j < rows.len() {
                triangles.push([number(i, j), number(i + 1, j), number(i, j + 1)]);
                triangles.push([number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)]);
            }
        }
        let parameters: Vec<DVec2> = order.iter().map(|&(i, j)| places[j] + DVec2::X * (along * i as f64)).collect();
        let positions = parameters.iter().map(|p| p.extend(0.0)).collect();
        let lattice_group = vec![false; members.len()];
        OnSurface { surface: &Surface::Plane, parameters, positions, fixed, triangles, members, lattice_group }
    }

    #[test]
    fn lattices_of_few_lengths_are_found_again_after_their_nodes_were_moved() {
        let row = |length: f64, other: f64, along: f64| {
            let x = (along * along + length * length - other * other) / (2.0 * along);
            [x, (length * length - x * x).sqrt()]
        };
        let cases: [(usize, f64, Vec<[f64; 2]>); 5] = [
            (1, 1.5, vec![row(1.5, 1.5, 1.5); 5]),
            (2, 1.3, vec![row(1.6, 1.6, 1.3); 6]),
            (3, 1.2, vec![row(1.4, 1.65, 1.2); 5]),
            (4, 1.25, [vec![row(1.5, 1.5, 1.25); 3], vec![row(1.75, 1.9, 1.25); 3]].concat()),
            (5, 1.2, [vec![row(1.35, 1.5, 1.2); 3], vec![row(1.65, 1.8, 1.2); 2]].concat()),
        ];
        for (count, along, rows) in cases {
            let exact = lattice(7, along, &rows);
            assert_eq!(distinct_lengths(&sorted(&exact), 1e-9), count);
            let mut nodes = exact.clone();
            let mut state = 1u32;
            let mut random = || {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                f64::from(state >> 8) / f64::from(1u32 << 24) - 0.5
            };
            for v in nodes.fixed..nodes.parameters.len() {
                nodes.parameters[v] += DVec2::new(random(), random()) * 0.04;
                nodes.positions[v] = nodes.parameters[v].extend(0.0);
            }
            assert!(distinct_lengths(&sorted(&nodes), 1e-3) > 20);
            let (rows, interrupted) = share_lengths(&mut nodes, count, 1e-3, (0.0, 1.0), &Execution::default());
            let last = rows.last().unwrap();
            assert!(interrupted.is_none() && last.lengths == count && last.deviation <= 5e-4, "{count}: {rows:?}");
            assert_eq!(distinct_lengths(&sorted(&nodes), 1e-3), count);
        }
    }

    #[test]
    fn the_ladder_ends_with_the_largest() {
        assert_eq!(ladder(1), [1]);
        assert_eq!(ladder(10), [1, 2, 3, 4, 6, 8, 10]);
        assert_eq!(ladder(12), [1, 2, 3, 4, 6, 8, 12]);
    }
}
