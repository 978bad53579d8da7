//! Search for the best path of a strip. An open strip takes one search. A closed strip takes the best path over all
//! starts, and finds it with fewer searches than there are starts.
//!
//! A closed path takes exactly one step from p_{m-1} to p_0. This step arrives at the bridge (0, j), which is the start
//! of the path. The path ends at (m - 1, j + n).
//!
//! - *Single layer*: divide and conquer (Fuchs, Kedem, Uselton 1977). Two shortest paths of different starts need not
//!   cross, so the path of a start in between lies between them: O(m n log n) altogether.
//! - *Two and four layers*: exchanging tails at a common bridge changes the terms at that bridge, so paths may have to
//!   cross and the argument fails. Instead, branch and bound: a search for paths that start and end in a range gives a
//!   lower bound for every start of the range. If the path that it finds is closed, the bound is attained. Ranges whose
//!   bound is not below the best closed path are dropped. The others are split between the path's start and its end.

use super::cell_counter::CellCounter;
use super::lanes::Lanes;
use super::sweep::{Kernel, Region, Score, Seed, Workspace, sweep, walk_back};
use plateau_mesh::execution::Interruption;
use std::collections::BinaryHeap;
use std::marker::PhantomData;

/// A path and its cost.
#[derive(Clone, Debug)]
pub(crate) struct FoundPath {
    pub(crate) score: Score,
    /// The bridges in order. On closed strips the columns continue beyond n.
    pub(crate) path: Vec<[u32; 2]>,
    /// The step that the search assumed before the first bridge: 0 for P, 1 for Q.
    seed: usize,
    /// The step that led to the last bridge: 0 for P, 1 for Q. Always 0 on graphs of fewer than four layers.
    arrived_by: usize,
}

impl FoundPath {
    fn start(&self) -> usize {
        self.path[0][1] as usize
    }
    fn end(&self) -> usize {
        self.path[self.path.len() - 1][1] as usize
    }
}

/// The searches for one objective on one strip.
pub(crate) trait PathSearch {
    fn layers(&self) -> usize;
    fn rows(&self) -> usize;
    fn columns(&self) -> usize;
    /// The cheapest path within the region from a source column of row 0 to an end column of the last row.
    fn find(
        &mut self,
        region: &Region,
        sources: (usize, usize, Seed),
        ends: (usize, usize),
        counter: &mut CellCounter<'_, '_>,
    ) -> Result<FoundPath, Interruption>;
}

/// A kernel with its grid and working memory.
#[derive(Debug)]
pub(crate) struct KernelSearch<V, K> {
    kernel: K,
    rows: usize,
    columns: usize,
    workspace: Workspace,
    lanes: PhantomData<V>,
}

impl<V: Lanes, K: Kernel<V>> KernelSearch<V, K> {
    pub(crate) fn new(kernel: K, rows: usize, columns: usize) -> Self {
        Self { kernel, rows, columns, workspace: Workspace::default(), lanes: PhantomData }
    }
}

impl<V: Lanes, K: Kernel<V>> PathSearch for KernelSearch<V, K> {
    fn layers(&self) -> usize {
        K::LAYERS
    }
    fn rows(&self) -> usize {
        self.rows
    }
    fn columns(&self) -> usize {
        self.columns
    }
    fn find(
        &mut self,
        region: &Region,
        sources: (usize, usize, Seed),
        ends: (usize, usize),
        counter: &mut CellCounter<'_, '_>,
    ) -> Result<FoundPath, Interruption> {
        sweep::<V, K>(&self.kernel, self.columns, region, sources, &mut self.workspace, counter)?;
        let ways: &[usize] = match (K::LAYERS, sources.2) {
            (4, Seed::Open | Seed::Either) => &[0, 1],
            (4, Seed::ByQ) => &[1],
            _ => &[0],
        };
        let mut best = (Score::WORST, ends.0, ways[0]);
        for column in ends.0..=ends.1 {
            for &way in ways {
                let score = self.workspace.end::<V, K>(&self.kernel, column, way);
                if score.better_than(&best.0) {
                    best = (score, column, way);
                }
            }
        }
        let (score, column, arrived_by) = best;
        let (path, seed) = walk_back(&self.workspace.table, self.rows, column, arrived_by);
        Ok(FoundPath { score, path, seed, arrived_by })
    }
}

/// The shortest path of an open strip, known to lie within the region.
pub(crate) fn open(
    search: &mut dyn PathSearch,
    region: &Region,
    counter: &mut CellCounter<'_, '_>,
) -> Result<FoundPath, Interruption> {
    let last = search.columns() - 1;
    search.find(region, (0, 0, Seed::Open), (last, last), counter)
}

/// The shortest closed path over all starts.
pub(crate) fn closed(
    search: &mut dyn PathSearch,
    counter: &mut CellCounter<'_, '_>,
) -> Result<FoundPath, Interruption> {
    if search.layers() == 1 { divide_and_conquer(search, counter) } else { branch_and_bound(search, counter) }
}

/// First and last column of a path in each row.
struct PathBounds {
    first: Vec<u32>,
    last: Vec<u32>,
}

impl PathBounds {
    fn of(path: &[[u32; 2]], rows: usize) -> Self {
        let (mut first, mut last) = (vec![u32::MAX; rows], vec![0; rows]);
        for &[i, j] in path {
            let i = i as usize;
            first[i] = first[i].min(j);
            last[i] = last[i].max(j);
        }
        Self { first, last }
    }
    fn shifted(&self, by: u32) -> Self {
        Self { first: self.first.iter().map(|c| c + by).collect(), last: self.last.iter().map(|c| c + by).collect() }
    }
}

fn divide_and_conquer(
    search: &mut dyn PathSearch,
    counter: &mut CellCounter<'_, '_>,
) -> Result<FoundPath, Interruption> {
    let (rows, n) = (search.rows(), search.columns() / 2);
    let mut best = search.find(&Region::full(rows, 0, n), (0, 0, Seed::Either), (n, n), counter)?;
    let low = PathBounds::of(&best.path, rows);
    let high = low.shifted(n as u32);
    // Each range (a, low, b, high) has the starts strictly between a and b, whose shortest paths `low` and `high`
    // enclose the paths from all of them. The path from n is the path from 0, shifted by n columns.
    let mut ranges = vec![(0, low, n, high)];
    while let Some((a, low, b, high)) = ranges.pop() {
        if b - a < 2 {
            continue;
        }
        let start = a.midpoint(b);
        // A path from a start below n ends below column 2n, so the region that is cut at the last column has all paths.
        let columns = search.columns() as u32 - 1;
        let region = Region { first: low.first.clone(), last: high.last.iter().map(|&c| c.min(columns)).collect() };
        let found = search.find(&region, (start, start, Seed::Either), (start + n, start + n), counter)?;
        let middle = PathBounds::of(&found.path, rows);
        if found.score.better_than(&best.score) || (found.score == best.score && start < best.start()) {
            best = found;
        }
        let copy = PathBounds { first: middle.first.clone(), last: middle.last.clone() };
        ranges.push((start, middle, b, high));
        ranges.push((a, low, start, copy));
    }
    Ok(best)
}

/// A range of starts. Every closed path that starts in the range costs at least `bound`. The heap pops the range of
/// least bound first; among equal bounds, the range with the smallest first start.
struct StartRange {
    bound: Score,
    first: usize,
    last: usize,
    seed: Seed,
}

impl Ord for StartRange {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.bound.order(&self.bound).then(other.first.cmp(&self.first)).then(other.last.cmp(&self.last))
    }
}
impl PartialOrd for StartRange {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl PartialEq for StartRange {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for StartRange {}

fn branch_and_bound(search: &mut dyn PathSearch, counter: &mut CellCounter<'_, '_>) -> Result<FoundPath, Interruption> {
    let (rows, n) = (search.rows(), search.columns() / 2);
    let mut best: Option<FoundPath> = None;
    let mut heap = BinaryHeap::new();
    heap.push(StartRange { bound: Score::ZERO, first: 0, last: n - 1, seed: Seed::Either });
    while let Some(range) = heap.pop() {
        let hopeless = |bound: &Score, first: usize, best: &Option<FoundPath>| {
            best.as_ref().is_some_and(|best| match bound.order(&best.score) {
                std::cmp::Ordering::Less => false,
                std::cmp::Ordering::Equal => first >= best.start(),
                std::cmp::Ordering::Greater => true,
            })
        };
        if hopeless(&range.bound, range.first, &best) {
            continue;
        }
        let region = Region::full(rows, range.first, range.last + n);
        let ends = (range.first + n, range.last + n);
        let found = search.find(&region, (range.first, range.last, range.seed), ends, counter)?;
        if hopeless(&found.score, range.first, &best) {
            continue;
        }
        let (start, end, bound) = (found.start(), found.end() - n, found.score);
        let is_narrowed = range.first == range.last && range.seed != Seed::Either;
        if (start == end && found.seed == found.arrived_by) || is_narrowed {
            // The bound is attained: either the path is closed, or the range has a single start and a single step
            // before it, so that every path within it is closed. Among equal paths the one with the smallest start is
            // preferred, so smaller starts are still searched.
            if start > range.first {
                heap.push(StartRange { bound, first: range.first, last: start - 1, seed: range.seed });
            }
            best = Some(found);
        } else if start != end {
            let cut = start.midpoint(end);
            heap.push(StartRange { bound, first: range.first, last: cut, seed: range.seed });
            heap.push(StartRange { bound, first: cut + 1, last: range.last, seed: range.seed });
        } else if range.first < range.last {
            // The path closes but the step assumed before its first bridge is not the step that led to its last one, so
            // its cost is only a lower bound. This start is searched alone, and so are the starts on either side.
            heap.push(StartRange { bound, first: start, last: start, seed: Seed::Either });
            if start > range.first {
                heap.push(StartRange { bound, first: range.first, last: start - 1, seed: range.seed });
            }
            if start < range.last {
                heap.push(StartRange { bound, first: start + 1, last: range.last, seed: range.seed });
            }
        } else {
            heap.push(StartRange { bound, first: start, last: start, seed: Seed::ByP });
            heap.push(StartRange { bound, first: start, last: start, seed: Seed::ByQ });
        }
    }
    // While no closed path is known, no range is dropped. Every range is either replaced by smaller ones or gives a
    // closed path.
    Ok(best.expect("a range that cannot be divided gives a closed path"))
}
