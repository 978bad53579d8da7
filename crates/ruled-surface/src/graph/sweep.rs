//! The shortest path through a layered graph: one sweep over the grid of bridges, whatever the objective.
//!
//! A sweep visits the rows in bands of `WIDTH` rows, one lane for each row. Each lane is one column behind the lane
//! above it. The two predecessors of a cell then lie one step back, in the cell's own lane (left) and in the lane
//! above, so no lane waits for another. A band hands the costs of its last row to the next band. The table of back
//! pointers, one bit for each node, is the only memory that grows with m n.

use super::cell_counter::{CELLS_BETWEEN_LOOKS, CellCounter};
use super::lanes::{Lanes, MOST_LANES, Task};
use plateau_mesh::execution::Interruption;
use std::cmp::Ordering;

/// The cost of a path. Scores are ordered by their fields, the first one first. Only a value takes part where concave
/// bridges do not count; the other fields are then 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Score {
    /// Number of concave bridges.
    pub(crate) count: f64,
    pub(crate) value: f64,
    /// Bending energy over all bridges.
    pub(crate) bending: f64,
    /// Twice the area.
    pub(crate) double_area: f64,
}

impl Score {
    pub(crate) const ZERO: Self = Self { count: 0.0, value: 0.0, bending: 0.0, double_area: 0.0 };
    pub(crate) const WORST: Self = Self { count: f64::INFINITY, ..Self::ZERO };
    /// The score of a path whose concave bridges do not count.
    pub(crate) fn of_value(value: f64) -> Self {
        Self { value, ..Self::ZERO }
    }
    pub(crate) fn order(&self, other: &Self) -> Ordering {
        let fields = |score: &Self| [score.count, score.value, score.bending, score.double_area];
        let pairs = fields(self).into_iter().zip(fields(other));
        pairs.map(|(own, other)| own.total_cmp(&other)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    }
    pub(crate) fn better_than(&self, other: &Self) -> bool {
        self.order(other) == Ordering::Less
    }
}

/// The step that led to the bridge before a path's first bridge. A P-step always leads to the first bridge itself. Only
/// the quadruple-layer graph needs this step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Seed {
    /// No step: the natural end of an open strip.
    Open,
    /// Either step, whichever is cheaper: a relaxation on a closed strip.
    Either,
    ByP,
    ByQ,
}

/// A kernel computes the costs of one objective. Each graph numbers the *nodes* of a bridge in its own way. `LAYERS` is
/// the number of nodes of a bridge. `top` has the `CARRY` numbers that a column of the row above hands down.
pub(crate) trait Kernel<V: Lanes> {
    const LAYERS: usize;
    const CARRY: usize;
    type Band: Copy;
    /// The values that each lane remembers from its previous column.
    type State: Copy;
    fn simd(&self) -> V::Simd;
    fn band(&self, band: usize) -> Self::Band;
    /// The state at the start of a band, when no path has reached any lane.
    fn blank(&self) -> Self::State;
    /// Visits the bridges of step `t` (lane r: column t - r) and returns their back pointers: bit `layer * WIDTH +
    /// lane` is set where the predecessor is the one by a Q-step.
    fn step(&self, band: &Self::Band, state: &mut Self::State, top: &[f64], t: usize) -> u32;
    /// Writes the values of a lane to `top`, for the row below.
    fn keep(&self, state: &Self::State, lane: usize, top: &mut [f64]);
    /// Writes to `top` the values of a column that no path has reached.
    fn unreached(&self, top: &mut [f64]);
    /// Writes to `top` the values of a path whose first bridge is the one of row 0 in this column.
    fn source(&self, column: usize, seed: Seed, top: &mut [f64]);
    /// Returns the cost of a path that leaves the last row in this column. With four layers, `arrived_by` selects the
    /// step that led to the path's last bridge: 0 for P, 1 for Q. Other graphs ignore `arrived_by`.
    fn end(&self, top: &[f64], arrived_by: usize) -> Score;
}

/// A kernel whose costs never fall along a path, so that paths above a bound need not be followed.
pub(crate) trait Bounded<V: Lanes>: Kernel<V> {
    /// Whether any lane remembers a cost of at most `bound`.
    fn is_alive(&self, state: &Self::State, bound: f64) -> bool;
    /// Whether a column hands down a cost of at most `bound`.
    fn hands_down(&self, top: &[f64], bound: f64) -> bool;
}

/// The first and the last column that a search may visit, for each row. Neither decreases from one row to the next.
/// Columns right of a band's end were therefore never written and are still `unreached` for the next band.
#[derive(Clone, Debug)]
pub(crate) struct Region {
    pub(crate) first: Vec<u32>,
    pub(crate) last: Vec<u32>,
}

impl Region {
    pub(crate) fn full(rows: usize, first: usize, last: usize) -> Self {
        Self { first: vec![first as u32; rows], last: vec![last as u32; rows] }
    }
    pub(crate) fn cells(&self) -> u64 {
        self.first.iter().zip(&self.last).map(|(&first, &last)| u64::from(last - first) + 1).sum()
    }
}

/// `layers` bits for every bridge of a region, in the order in which a sweep visits the bridges.
#[derive(Clone, Debug, Default)]
pub(crate) struct BitTable {
    layers: usize,
    width: usize,
    bands: Vec<BandOf>,
    words: Vec<u64>,
}

/// The steps of a band, and the position of its first bit.
#[derive(Clone, Copy, Debug)]
struct BandOf {
    word: usize,
    begin: usize,
    end: usize,
}

impl BitTable {
    pub(crate) fn lay_out(&mut self, region: &Region, layers: usize, width: usize) {
        self.layers = layers;
        self.width = width;
        self.bands.clear();
        let mut word = 0;
        let rows = region.first.len();
        for row in (0..rows).step_by(width) {
            let begin = region.first[row] as usize;
            let lanes = (row + width).min(rows) - row;
            let end = (0..lanes).map(|r| region.last[row + r] as usize + r + 1).max().unwrap_or(begin);
            self.bands.push(BandOf { word, begin, end });
            word += (end - begin).div_ceil(self.steps_per_word());
        }
        self.words.clear();
        self.words.resize(word, 0);
    }

    #[inline(always)]
    fn steps_per_word(&self) -> usize {
        64 / (self.layers * self.width)
    }

    /// Returns the bit of a node (`layer`) of a bridge. The bridge must lie in the table's region.
    pub(crate) fn bit(&self, [i, j]: [usize; 2], layer: usize) -> bool {
        let (band, lane) = (self.bands[i / self.width], i % self.width);
        let step = j + lane - band.begin;
        let per_word = self.steps_per_word();
        let bit = (step % per_word) * self.layers * self.width + layer * self.width + lane;
        self.words[band.word + step / per_word] >> bit & 1 == 1
    }

    /// Sets the bit of a bridge in a table of one layer.
    pub(crate) fn set(&mut self, [i, j]: [usize; 2]) {
        let (band, lane) = (self.bands[i / self.width], i % self.width);
        let (step, per_word) = (j + lane - band.begin, 64 / self.width);
        self.words[band.word + step / per_word] |= 1 << (step % per_word * self.width + lane);
    }

    /// Returns the bits of step `t` in a table of one layer: bit r belongs to row `band * width + r`. Returns zero for
    /// a step outside the table.
    #[inline(always)]
    pub(crate) fn lanes(&self, band: usize, t: usize) -> u32 {
        let BandOf { word, begin, end } = self.bands[band];
        if t < begin || t >= end {
            return 0;
        }
        let per_word = 64 / self.width;
        let step = t - begin;
        (self.words[word + step / per_word] >> (step % per_word * self.width)) as u32 & ((1 << self.width) - 1)
    }
}

/// A sweep's working memory, kept from one search to the next.
#[derive(Debug, Default)]
pub(crate) struct Workspace {
    pub(crate) table: BitTable,
    /// The values that the row above hands down: `CARRY` numbers for each column, column 0 at position `LEFT`.
    top: Vec<f64>,
}

/// Number of columns left of column 0 through which lanes pass on their way into the grid.
const LEFT: usize = MOST_LANES;

/// Sweeps the region from the source columns, given as the first column, the last column and the step before the first
/// bridge. Afterwards [`Workspace::table`] has the back pointers and [`Workspace::end`] returns the costs along the
/// last row.
pub(crate) fn sweep<V: Lanes, K: Kernel<V>>(
    kernel: &K,
    columns: usize,
    region: &Region,
    sources: (usize, usize, Seed),
    workspace: &mut Workspace,
    counter: &mut CellCounter<'_, '_>,
) -> Result<(), Interruption> {
    let (first, last, seed) = sources;
    let rows = region.first.len();
    assert!(
        rows > 0 && last < columns && region.last.iter().all(|&c| (c as usize) < columns),
        "a sweep stays in its grid"
    );
    let Workspace { table, top } = workspace;
    table.lay_out(region, K::LAYERS, V::WIDTH);
    top.clear();
    top.resize((LEFT + columns + V::WIDTH) * K::CARRY, 0.0);
    for column in top.chunks_exact_mut(K::CARRY) {
        kernel.unreached(column);
    }
    for column in first..=last {
        let at = (LEFT + column) * K::CARRY;
        kernel.source(column, seed, &mut top[at..at + K::CARRY]);
    }
    let bands = std::mem::take(&mut table.bands);
    let mut position = SweepPosition { band: 0, step: bands[0].begin, state: kernel.blank() };
    let mut failure = None;
    while position.band < bands.len() {
        let visited = V::run(
            kernel.simd(),
            SweepPart { kernel, bands: &bands, rows, top, words: &mut table.words, position: &mut position },
        );
        if let Err(interruption) = counter.add(visited) {
            failure = Some(interruption);
            break;
        }
    }
    table.bands = bands;
    failure.map_or(Ok(()), Err)
}

impl Workspace {
    /// Returns the cost of a path that ends in this column of the last row.
    pub(crate) fn end<V: Lanes, K: Kernel<V>>(&self, kernel: &K, column: usize, arrived_by: usize) -> Score {
        let at = (LEFT + column) * K::CARRY;
        kernel.end(&self.top[at..at + K::CARRY], arrived_by)
    }
}

struct SweepPosition<S> {
    band: usize,
    step: usize,
    state: S,
}

/// The part of a sweep between two checks of the caller's signal.
struct SweepPart<'a, V: Lanes, K: Kernel<V>> {
    kernel: &'a K,
    bands: &'a [BandOf],
    rows: usize,
    top: &'a mut [f64],
    words: &'a mut [u64],
    position: &'a mut SweepPosition<K::State>,
}

impl<V: Lanes, K: Kernel<V>> Task<V> for SweepPart<'_, V, K> {
    type Output = u64;
    #[inline(always)]
    fn run(self) -> u64 {
        let mut visited = 0;
        // Ends because each pass visits cells or finishes a band.
        while visited < CELLS_BETWEEN_LOOKS && self.position.band < self.bands.len() {
            let number = self.position.band;
            let band = self.bands[number];
            if self.position.step == band.begin {
                self.position.state = self.kernel.blank();
            }
            let room = (CELLS_BETWEEN_LOOKS as usize / V::WIDTH).next_multiple_of(64);
            let end = band.end.min(self.position.step + room);
            visited += ((end - self.position.step) * V::WIDTH) as u64;
            // The last band may end before its last lane. Its last row is then in an earlier lane.
            if (number + 1) * V::WIDTH <= self.rows {
                steps::<V, K, true>(self.kernel, number, band, end, V::WIDTH - 1, self.top, self.words, self.position);
            } else {
                let lane = (self.rows - 1) % V::WIDTH;
                steps::<V, K, false>(self.kernel, number, band, end, lane, self.top, self.words, self.position);
            }
            if end == band.end {
                self.position.band += 1;
                if let Some(next) = self.bands.get(number + 1) {
                    self.position.step = next.begin;
                }
            }
        }
        visited
    }
}

#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "the inner loop's registers, spelled out")]
fn steps<V: Lanes, K: Kernel<V>, const LAST_LANE: bool>(
    kernel: &K,
    number: usize,
    band: BandOf,
    end: usize,
    lane: usize,
    top: &mut [f64],
    words: &mut [u64],
    position: &mut SweepPosition<K::State>,
) {
    let lane = if LAST_LANE { V::WIDTH - 1 } else { lane };
    let rows = kernel.band(number);
    let bits = K::LAYERS * V::WIDTH;
    let per_word = 64 / bits;
    let mut state = position.state;
    let mut t = position.step;
    let mut word = band.word + (t - band.begin) / per_word;
    // Ends because a word has room for one step at least: four layers of eight lanes take 32 bits.
    while t < end {
        let stop = end.min(t + per_word);
        let (mut packed, mut shift) = (0u64, 0);
        while t < stop {
            let at = (LEFT + t) * K::CARRY;
            let found = kernel.step(&rows, &mut state, &top[at..at + K::CARRY], t);
            packed |= u64::from(found) << shift;
            shift += bits;
            let below = at - lane * K::CARRY;
            kernel.keep(&state, lane, &mut top[below..below + K::CARRY]);
            t += 1;
        }
        words[word] = packed;
        word += 1;
    }
    position.state = state;
    position.step = end;
}

/// Returns the cost of the shortest path of an open strip if the cost is at most `bound`, without the path. The search
/// visits hardly any cells besides those through which paths within the bound run.
pub(crate) fn cost_within<V: Lanes, K: Bounded<V>>(
    kernel: &K,
    (rows, columns): (usize, usize),
    bound: f64,
    counter: &mut CellCounter<'_, '_>,
) -> Result<Option<f64>, Interruption> {
    let mut top = vec![0.0; (LEFT + columns + V::WIDTH) * K::CARRY];
    for column in top.chunks_exact_mut(K::CARRY) {
        kernel.unreached(column);
    }
    kernel.source(0, Seed::Open, &mut top[LEFT * K::CARRY..(LEFT + 1) * K::CARRY]);
    // No path is read back, so each band overwrites the pointers of the band before.
    let mut words = vec![0; columns + V::WIDTH];
    let (mut band, mut written) = (0, Some((0, 0)));
    while let Some(columns_written) = written
        && band * V::WIDTH < rows
    {
        let task = Pruned { kernel, rows, columns, bound, top: &mut top, words: &mut words, band, columns_written };
        let visited;
        (band, written, visited) = V::run(kernel.simd(), task);
        counter.add(visited)?;
    }
    let end = kernel.end(&top[(LEFT + columns - 1) * K::CARRY..], 0).value;
    Ok(written.filter(|&(_, last)| last + 1 == columns && end <= bound).map(|_| end))
}

/// The part of [`cost_within`] between two checks of the caller's signal: one or more bands.
struct Pruned<'a, K> {
    kernel: &'a K,
    rows: usize,
    columns: usize,
    bound: f64,
    top: &'a mut [f64],
    words: &'a mut [u64],
    band: usize,
    /// First and last column that the row above has written.
    columns_written: (usize, usize),
}

impl<V: Lanes, K: Bounded<V>> Task<V> for Pruned<'_, K> {
    /// The next band, the columns written for it (none if no path is within the bound), and the number of visited
    /// cells.
    type Output = (usize, Option<(usize, usize)>, u64);
    #[inline(always)]
    fn run(mut self) -> Self::Output {
        /// Number of steps after which the search checks whether a path within the bound is left.
        const STEPS: usize = 16;
        let mut visited = 0;
        while visited < CELLS_BETWEEN_LOOKS && self.band * V::WIDTH < self.rows {
            let (from, to) = self.columns_written;
            let hands_down = |column: &usize| {
                let at = (LEFT + column) * K::CARRY;
                self.kernel.hands_down(&self.top[at..at + K::CARRY], self.bound)
            };
            let Some(begin) = (from..=to).find(hands_down) else { return (self.band, None, visited) };
            let last = (begin..=to).rev().find(hands_down).unwrap_or(begin);
            let lanes = V::WIDTH.min(self.rows - self.band * V::WIDTH);
            let all = BandOf { word: 0, begin, end: self.columns + lanes - 1 };
            let mut position = SweepPosition { band: self.band, step: begin, state: self.kernel.blank() };
            // Ends because each pass moves on by at least one step towards the end of the band.
            loop {
                let end = all.end.min(position.step + STEPS);
                if lanes == V::WIDTH {
                    let lane = V::WIDTH - 1;
                    steps::<V, K, true>(self.kernel, self.band, all, end, lane, self.top, self.words, &mut position);
                } else {
                    let lane = lanes - 1;
                    steps::<V, K, false>(self.kernel, self.band, all, end, lane, self.top, self.words, &mut position);
                }
                if end == all.end || end > last && !self.kernel.is_alive(&position.state, self.bound) {
                    break;
                }
            }
            visited += ((position.step - begin) * V::WIDTH) as u64;
            // Columns right of `written` still hold values of the row above, so they are reset.
            let written = position.step - lanes;
            for column in written + 1..=to {
                let at = (LEFT + column) * K::CARRY;
                self.kernel.unreached(&mut self.top[at..at + K::CARRY]);
            }
            self.columns_written = (begin, written);
            self.band += 1;
        }
        (self.band, Some(self.columns_written), visited)
    }
}

/// Walks the back pointers from the bridge (rows - 1, `column`). The path leaves this bridge by the closing P-step; on
/// four layers it arrived there by `arrived_by`. Returns the bridges from the first to the last, and the step that led
/// to the bridge before the first one.
pub(crate) fn walk_back(table: &BitTable, rows: usize, column: usize, arrived_by: usize) -> (Vec<[u32; 2]>, usize) {
    let (mut i, mut j) = (rows - 1, column);
    let mut path = Vec::with_capacity(rows + column);
    // The step that leaves the bridge and, on four layers, the step that led to it.
    let (mut leaving, mut arriving) = (0, arrived_by);
    // At most one pass per row and column, because each pass lowers i or j.
    loop {
        path.push([i as u32, j as u32]);
        let mut before = 0;
        match table.layers {
            1 => arriving = usize::from(table.bit([i, j], 0)),
            2 => arriving = usize::from(table.bit([i, j], leaving)),
            _ => before = usize::from(table.bit([i, j], 2 * arriving + leaving)),
        }
        if arriving == 0 {
            if i == 0 {
                path.reverse();
                return (path, before);
            }
            i -= 1;
        } else {
            // Column `begin` has no reachable left neighbour, so its pointers lead up.
            assert!(j > 0, "back pointers stay in the grid");
            j -= 1;
        }
        (leaving, arriving) = (arriving, before);
    }
}
