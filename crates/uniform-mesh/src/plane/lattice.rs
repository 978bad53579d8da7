//! Places the equilateral lattice inside a domain (Katoh, Ohsaki and Xu, section 3), and searches for the best
//! placement.
//!
//! 1. Overlay a triangular lattice of edge ℓ and keep its nodes inside the domain.
//! 2. Drop the nodes nearer than ℓ to a node on the boundary.
//! 3. The remaining nodes, with every lattice edge between two of them, are the lattice group. Between the group and
//!    the boundary lies the rim, which [`increment`](super::increment) fills.
//!
//! Our departures:
//! - Nodes on or inside the diametral circle of a boundary edge are dropped too. Without this rule lemma 3 fails for
//!   boundary edges near 2ℓ, because the middle of such an edge may come arbitrarily close to a lattice node. With the
//!   rule no lattice edge crosses a boundary edge, even in concave domains and at holes. Proof: if a lattice edge uv
//!   crossed a boundary edge ab, the quadrilateral's angles at u and v would be below 90°. Its angle at a or at b would
//!   then be above 90°, and with |ua|, |va| >= ℓ the edge uv would be longer than √2 ℓ.
//! - Nodes without any lattice edge are dropped, because they only constrain the rim.
//! - The paper takes one placement. We search for the placement with the most lattice edges: first along every edge
//!   direction of the boundary with the lattice running through a corner, then on a grid of angles and origins, then by
//!   a pattern search from the best few.
//! - The division of the boundary matters too. With pieces of √2 ℓ the lattice may come nearer to the boundary than
//!   with pieces of ℓ, unless the boundary runs along the lattice. Both divisions are therefore searched
//!   ([`Division`](super::sides::Division)).
//! - A placement is evaluated in O(boundary), because a lattice row is a set of free intervals of a line, and edges are
//!   counted from the ends of the intervals without visiting the nodes. The search is bounded by the number of rows
//!   built, not by time, so that the result is the same on every machine.

use plateau_mesh::DVec2;
use plateau_mesh::execution::{Execution, Interruption, Progress};
use plateau_mesh::plane::triangulation::{Border, Constraint};
use plateau_mesh::plane::unit_vector;
use std::cmp::Ordering;
use std::f64::consts::FRAC_PI_3;

/// Distance between lattice rows in ℓ, √3/2.
const ROW: f64 = 0.866_025_403_784_438_6;
/// Tolerance for rounding in the least distances from the boundary, in ℓ. Lattices aligned with the boundary have
/// exactly these distances.
const TOUCH: f64 = 1e-10;

/// Largest number of placements from which the pattern search starts: in total, and at the same angle.
const STARTS: usize = 24;
const STARTS_PER_ANGLE: usize = 3;
/// Number of best placements for which the lattice edges along the boundary are counted too.
const BEST: usize = 64;

/// The placement of a lattice of edge 1. Node (i, j) is at origin + i e₁ + j e₂, where e₁ points at `angle` and e₂ 60°
/// further.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Placement {
    pub angle: f64,
    /// The position of node (0, 0), in coordinates rotated by `-angle`.
    pub origin: DVec2,
}

impl Placement {
    /// Whether the point is a lattice point, up to a tolerance of 1e-7 ℓ.
    pub fn carries(&self, point: DVec2) -> bool {
        let p = unit_vector(-self.angle).rotate(point) - self.origin;
        let j = p.y / ROW;
        let i = p.x - j.round() / 2.0;
        (j - j.round()).abs() < 1e-7 && (i - i.round()).abs() < 1e-7
    }
}

/// The boundary of the domain: its nodes, and its pieces, each from node to node.
#[derive(Clone, Debug)]
pub(crate) struct Boundary<'a> {
    pub nodes: &'a [DVec2],
    pub pieces: &'a [(u32, u32)],
}

/// The lattice group: nodes, triangles, and the edges that the rim must respect.
#[derive(Clone, Debug)]
pub(crate) struct Lattice {
    pub nodes: Vec<DVec2>,
    pub triangles: Vec<[u32; 3]>,
    /// The lattice edges with fewer than two lattice triangles.
    pub borders: Vec<Constraint>,
}

/// The free intervals of the lattice rows, for one angle and height. A free interval is a part of a row that lies
/// inside the domain and far enough from its boundary.
#[derive(Default)]
struct Rows {
    first: i64,
    start: Vec<usize>,
    free: Vec<(f64, f64)>,
    crossings: Vec<(u32, f64)>,
    blocked: Vec<(u32, f64, f64)>,
    // Working memory of `sort_rows`.
    spare_crossings: Vec<(u32, f64)>,
    spare_blocked: Vec<(u32, f64, f64)>,
    ends: Vec<u32>,
    runs: Vec<(i64, i64)>,
}

impl Rows {
    /// Finds the free intervals of the lines y = `height` + j · [`ROW`]. `turned` holds the boundary nodes in rotated
    /// coordinates.
    fn build(&mut self, boundary: &Boundary<'_>, turned: &[DVec2], height: f64) {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for p in turned {
            low = low.min(p.y);
            high = high.max(p.y);
        }
        self.first = ((low - height) / ROW).ceil() as i64;
        let last = ((high - height) / ROW).floor() as i64;
        let count = (last - self.first + 1).max(0) as usize;
        let first = self.first;
        let y = |row: u32| height + (first + i64::from(row)) as f64 * ROW;
        // The rows with low <= y < high, as indices that count from the first row.
        let rows = |low: f64, high: f64| {
            let from = ((low - height) / ROW).ceil() as i64 - first;
            let to = ((high - height) / ROW).ceil() as i64 - first;
            from.max(0) as u32..to.clamp(0, count as i64) as u32
        };
        self.crossings.clear();
        self.blocked.clear();
        let block = |blocked: &mut Vec<(u32, f64, f64)>, centre: DVec2, radius: f64| {
            for row in rows(centre.y - radius, centre.y + radius) {
                let half = radius * radius - (y(row) - centre.y) * (y(row) - centre.y);
                if half > 0.0 {
                    blocked.push((row, centre.x - half.sqrt(), centre.x + half.sqrt()));
                }
            }
        };
        for &p in turned {
            block(&mut self.blocked, p, 1.0 - TOUCH);
        }
        for &(a, b) in boundary.pieces {
            let (a, b) = (turned[a as usize], turned[b as usize]);
            for row in rows(a.y.min(b.y), a.y.max(b.y)) {
                self.crossings.push((row, a.x + (b.x - a.x) * ((y(row) - a.y) / (b.y - a.y))));
            }
            // The diametral circle of an edge of at most √2 ℓ lies within the circles around its ends.
            if a.distance_squared(b) > 2.0 - 1e-6 {
                block(&mut self.blocked, (a + b) / 2.0, a.distance(b) / 2.0 + TOUCH);
            }
        }
        sort_rows(
            &mut self.crossings,
            &mut self.spare_crossings,
            &mut self.ends,
            count,
            |c| c.0,
            |a, b| a.1.total_cmp(&b.1),
        );
        let order = |a: &(u32, f64, f64), b: &(u32, f64, f64)| a.1.total_cmp(&b.1).then(a.2.total_cmp(&b.2));
        sort_rows(&mut self.blocked, &mut self.spare_blocked, &mut self.ends, count, |b| b.0, order);
        self.find_free(count as u32);
    }

    /// Collects the free intervals row by row: the parts inside the boundary that are not blocked.
    fn find_free(&mut self, count: u32) {
        self.start.clear();
        self.free.clear();
        let (mut c, mut k) = (0, 0);
        for row in 0..count {
            self.start.push(self.free.len());
            let mut gap = k;
            while k < self.blocked.len() && self.blocked[k].0 == row {
                k += 1;
            }
            while c + 1 < self.crossings.len() && self.crossings[c].0 == row {
                let (mut from, to) = (self.crossings[c].1, self.crossings[c + 1].1);
                c += 2;
                // Blocked intervals are sorted by their start. A blocked interval may reach over several inside
                // intervals.
                for &(_, start, end) in &self.blocked[gap..k] {
                    if start >= to {
                        break;
                    }
                    if start > from {
                        self.free.push((from, start));
                    }
                    from = from.max(end);
                }
                while gap < k && self.blocked[gap].2 <= from.min(to) && self.blocked[gap].1 < to {
                    gap += 1;
                }
                if from < to {
                    self.free.push((from, to));
                }
            }
        }
        self.start.push(self.free.len());
    }

    /// Finds the runs of lattice nodes in the free intervals, for a lattice whose node (0, 0) is at `x`. A run is the
    /// first and the last index i of consecutive nodes. Calls `each(j, runs)` for every row in order.
    fn each_row(&mut self, x: f64, mut each: impl FnMut(i64, &[(i64, i64)])) {
        for row in 0..self.start.len().saturating_sub(1) {
            let j = self.first + row as i64;
            let shift = x + j as f64 / 2.0;
            self.runs.clear();
            for &(from, to) in &self.free[self.start[row]..self.start[row + 1]] {
                let (from, to) = ((from - shift).ceil() as i64, (to - shift).floor() as i64);
                match self.runs.last_mut() {
                    _ if to < from => {}
                    // Neighbouring nodes on the two sides of a thin blocked interval are joined by an edge too.
                    Some(last) if last.1 + 1 >= from => last.1 = last.1.max(to),
                    _ => self.runs.push((from, to)),
                }
            }
            each(j, &self.runs);
        }
    }

    /// Number of lattice edges of a lattice whose node (0, 0) is at `x`.
    fn edges(&mut self, x: f64) -> usize {
        let (mut total, mut below, mut spare) = (0i64, Vec::new(), Vec::new());
        self.each_row(x, |_, runs| {
            total += runs.iter().map(|&(from, to)| to - from).sum::<i64>();
            total += common(&below, runs, 0) + common(&below, runs, 1);
            spare.clear();
            spare.extend_from_slice(runs);
            std::mem::swap(&mut below, &mut spare);
        });
        total as usize
    }
}

/// Sorts by row and then by `order`. The items are first distributed to a bucket for each row, because a row holds few
/// of them, and most of the search's time is spent in this sort.
fn sort_rows<T: Copy>(
    items: &mut [T],
    spare: &mut Vec<T>,
    ends: &mut Vec<u32>,
    rows: usize,
    row: impl Fn(&T) -> u32,
    order: impl Fn(&T, &T) -> Ordering,
) {
    ends.clear();
    ends.resize(rows + 1, 0);
    for item in items.iter() {
        ends[row(item) as usize + 1] += 1;
    }
    for k in 0..rows {
        ends[k + 1] += ends[k];
    }
    spare.clear();
    spare.extend_from_slice(items);
    for item in spare.iter() {
        let end = &mut ends[row(item) as usize];
        items[*end as usize] = *item;
        *end += 1;
    }
    let mut from = 0;
    for &end in &ends[..rows] {
        items[from..end as usize].sort_unstable_by(&order);
        from = end as usize;
    }
}

/// Number of indices that lie in both lists of runs after `shift` is added to the indices of the second list.
fn common(a: &[(i64, i64)], b: &[(i64, i64)], shift: i64) -> i64 {
    let (mut i, mut j, mut total) = (0, 0, 0);
    // Ends because each pass raises i or j by one.
    while i < a.len() && j < b.len() {
        let from = a[i].0.max(b[j].0 + shift);
        let to = a[i].1.min(b[j].1 + shift);
        total += (to - from + 1).max(0);
        if a[i].1 < b[j].1 + shift { i += 1 } else { j += 1 }
    }
    total
}

/// The state of the search: the best placements so far, and the number of row sets built (`built`) of the most that may
/// be built (`budget`).
struct Search<'a> {
    boundary: &'a Boundary<'a>,
    rows: Rows,
    turned: Vec<DVec2>,
    angle: f64,
    built: u64,
    budget: u64,
    best: Vec<(usize, Placement)>,
}

impl Search<'_> {
    /// Counts the lattice edges at every `x` for one angle and height. Returns the placement with the most edges, and
    /// their number.
    fn try_heights(&mut self, angle: f64, height: f64, xs: impl Iterator<Item = f64>) -> Option<(usize, Placement)> {
        if angle != self.angle || self.turned.is_empty() {
            let turn = unit_vector(-angle);
            self.turned.clear();
            self.turned.extend(self.boundary.nodes.iter().map(|&p| turn.rotate(p)));
            self.angle = angle;
        }
        self.rows.build(self.boundary, &self.turned, height);
        self.built += 1;
        let mut best: Option<(usize, Placement)> = None;
        for x in xs {
            let edges = self.rows.edges(x);
            if best.is_none_or(|(most, _)| edges > most) {
                best = Some((edges, Placement { angle, origin: DVec2::new(x, height) }));
            }
        }
        best
    }

    fn keep(&mut self, candidate: Option<(usize, Placement)>) {
        self.best.extend(candidate);
    }

    /// Pattern search: moves and rotates a placement in ever smaller steps as long as that increases the number of
    /// edges.
    ///
    /// # Errors
    /// The interruptions of `execution`.
    fn climb(
        &mut self,
        (mut edges, mut here): (usize, Placement),
        mut step: f64,
        span: (f64, f64),
        execution: &Execution<'_>,
    ) -> Result<(usize, Placement), Interruption> {
        // Ends because each pass uses some of the budget.
        while step > 5e-4 && self.built < self.budget {
            let mut moved = false;
            let turn = step * FRAC_PI_3 / 2.0;
            for (turn, lift) in [(0.0, 0.0), (0.0, step), (0.0, -step), (turn, 0.0), (-turn, 0.0)] {
                let x = here.origin.x;
                let (angle, height) = (here.angle + turn, here.origin.y + lift);
                let xs = [x, x - step, x + step, x - step / 2.0, x + step / 2.0];
                if let Some(found) = self.try_heights(angle, height, xs.into_iter())
                    && found.0 > edges
                {
                    (edges, here, moved) = (found.0, found.1, true);
                }
                self.look(span, execution)?;
            }
            if !moved {
                step /= 2.0;
            }
        }
        Ok((edges, here))
    }

    /// Calls [`Execution::look`] with the boundary's size as the work, and reports progress. Called once per height
    /// tried.
    fn look(&self, (from, to): (f64, f64), execution: &Execution<'_>) -> Result<(), Interruption> {
        execution.look(self.boundary.nodes.len() as u64)?;
        let share = (self.built as f64 / self.budget as f64).min(1.0);
        let most = self.best.iter().map(|&(edges, _)| edges).max();
        execution.report(Progress {
            fraction: from + (to - from) * share,
            phase: "lattice",
            iteration: self.built,
            objective_value: most.map(|edges| edges as f64),
            residual: None,
        });
        Ok(())
    }
}

/// The directions of the boundary edges modulo 60°, each with the nodes where edges of that direction start. Sorted by
/// the total length of the edges, longest first.
fn directions(boundary: &Boundary<'_>) -> Vec<(f64, Vec<u32>)> {
    let mut all: Vec<(f64, f64, u32)> = boundary
        .pieces
        .iter()
        .map(|&(a, b)| {
            let edge = boundary.nodes[b as usize] - boundary.nodes[a as usize];
            let angle = libm::atan2(edge.y, edge.x).rem_euclid(FRAC_PI_3);
            // Angles within 1e-6 of 60° count as 0, because the lattice repeats every 60°.
            (if FRAC_PI_3 - angle < 1e-6 { angle - FRAC_PI_3 } else { angle }, edge.length(), a)
        })
        .collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)));
    let mut groups: Vec<(f64, f64, Vec<u32>)> = Vec::new();
    for (angle, length, node) in all {
        match groups.last_mut() {
            Some(group) if angle - group.0 < 1e-6 => {
                group.1 += length;
                group.2.push(node);
            }
            _ => groups.push((angle, length, vec![node])),
        }
    }
    // Lengths are rounded, so that rounding errors do not order groups of equal length.
    groups.sort_by_key(|group| (std::cmp::Reverse((group.1 * 1e6).round() as i64), group.2.iter().min().copied()));
    groups
        .into_iter()
        .map(|(angle, _, mut nodes)| {
            nodes.sort_unstable();
            (angle, nodes)
        })
        .collect()
}

/// Searches for the placement with the most lattice edges. Also returns the number of these edges, of which those along
/// the boundary are estimated. `None` if no lattice edge fits.
///
/// # Errors
/// The interruptions of `execution`. The placements found so far are then lost.
pub(crate) fn search(
    boundary: &Boundary<'_>,
    span: (f64, f64),
    execution: &Execution<'_>,
) -> Result<Option<(usize, Placement)>, Interruption> {
    let budget = (1_500_000 / boundary.nodes.len().max(1) as u64).clamp(60, 6000);
    let steps: u32 = if budget >= 2000 {
        12
    } else if budget >= 300 {
        8
    } else {
        4
    };
    let mut search = Search {
        boundary,
        rows: Rows::default(),
        turned: Vec::new(),
        angle: f64::NAN,
        built: 0,
        budget,
        best: Vec::new(),
    };
    let directions = directions(boundary);
    let fraction = move |k: u32| f64::from(k) / f64::from(steps);
    // Placements that are aligned with the boundary and run through its nodes. If there is an exact fit, it is among
    // them.
    for (angle, nodes) in directions.iter().take(8) {
        for &node in nodes.iter().step_by((nodes.len() / 4).max(1)).take(4) {
            let origin = unit_vector(-angle).rotate(boundary.nodes[node as usize]);
            let xs = std::iter::once(origin.x).chain((0..steps).map(|k| origin.x + fraction(k)));
            let found = search.try_heights(*angle, origin.y, xs);
            search.keep(found);
            search.look(span, execution)?;
        }
    }
    let uniform = (0..2 * steps).map(|k| FRAC_PI_3 * f64::from(k) / f64::from(2 * steps));
    for angle in directions.iter().map(|d| d.0).take(8).chain(uniform) {
        for k in 0..steps {
            if search.built * 10 > budget * 7 {
                break;
            }
            let found = search.try_heights(angle, fraction(k) * ROW, (0..steps).map(fraction));
            search.keep(found);
            search.look(span, execution)?;
        }
    }
    search.best.sort_by_key(|&(edges, _)| std::cmp::Reverse(edges));
    // For the best placements, the edges that continue the lattice along the boundary are counted too.
    let with_boundary = |&(edges, placement): &(usize, Placement)| (edges + edges_on(boundary, placement), placement);
    let mut winner: Option<(usize, Placement)> = None;
    for candidate in search.best.iter().take(BEST).map(with_boundary) {
        if winner.is_none_or(|(most, _)| candidate.0 > most) {
            winner = Some(candidate);
        }
    }
    // The best few placements, but only a few of the same angle, because neighbouring heights lead to the same
    // placement.
    let mut starts: Vec<(usize, Placement)> = Vec::new();
    for &candidate in &search.best {
        let alike = starts.iter().filter(|(_, start)| start.angle == candidate.1.angle).count();
        if starts.len() < STARTS && alike < STARTS_PER_ANGLE {
            starts.push(candidate);
        }
    }
    for (edges, start) in starts {
        let climbed = with_boundary(&search.climb((edges, start), 0.5 / f64::from(steps), span, execution)?);
        if winner.is_none_or(|(most, _)| climbed.0 > most) {
            winner = Some(climbed);
        }
    }
    Ok(winner.filter(|&(edges, _)| edges > 0))
}

/// Estimates the number of lattice edges that the boundary adds to the finished mesh where it runs on the lattice.
/// Counts the pieces of length 1 between two lattice points, and two edges to the next row for each boundary node on a
/// lattice point.
fn edges_on(boundary: &Boundary<'_>, placement: Placement) -> usize {
    let on: Vec<bool> = boundary.nodes.iter().map(|&p| placement.carries(p)).collect();
    let apart = |a: u32, b: u32| boundary.nodes[a as usize].distance(boundary.nodes[b as usize]);
    let is_on = |&&(a, b): &&(u32, u32)| on[a as usize] && on[b as usize] && (apart(a, b) - 1.0).abs() < 1e-6;
    boundary.pieces.iter().filter(is_on).count() + 2 * on.iter().filter(|&&on| on).count()
}

/// Makes the lattice group of a placement. O(nodes + boundary log boundary).
pub(crate) fn place(boundary: &Boundary<'_>, placement: Placement) -> Lattice {
    let turn = unit_vector(-placement.angle);
    let turned: Vec<DVec2> = boundary.nodes.iter().map(|&p| turn.rotate(p)).collect();
    let mut rows = Rows::default();
    rows.build(boundary, &turned, placement.origin.y);
    // The runs of all rows: (first index, last index, number of the first node).
    let mut runs: Vec<(i64, i64, u32)> = Vec::new();
    let mut start: Vec<usize> = Vec::new();
    let mut count = 0u32;
    let first = rows.first;
    rows.each_row(placement.origin.x, |_, row| {
        start.push(runs.len());
        for &(from, to) in row {
            runs.push((from, to, count));
            count += (to - from + 1) as u32;
        }
    });
    start.push(runs.len());
    let node_number = |i: i64, j: i64| -> Option<u32> {
        let row = usize::try_from(j - first).ok().filter(|&row| row + 1 < start.len())?;
        let row = &runs[start[row]..start[row + 1]];
        let k = row.partition_point(|&(from, ..)| from <= i).checked_sub(1)?;
        (i <= row[k].1).then(|| row[k].2 + (i - row[k].0) as u32)
    };
    let back = unit_vector(placement.angle);
    let mut nodes = Vec::with_capacity(count as usize);
    let (mut triangles, mut borders) = (Vec::new(), Vec::new());
    let mut used = vec![false; count as usize];
    for row in 0..start.len().saturating_sub(1) {
        let j = first + row as i64;
        for &(from, to, number) in &runs[start[row]..start[row + 1]] {
            for i in from..=to {
                let here = number + (i - from) as u32;
                let x = placement.origin.x + (i as f64 + j as f64 / 2.0);
                nodes.push(back.rotate(DVec2::new(x, placement.origin.y + j as f64 * ROW)));
                let (right, up, up_left) = (node_number(i + 1, j), node_number(i, j + 1), node_number(i - 1, j + 1));
                if let (Some(a), Some(b)) = (right, up) {
                    triangles.push([here, a, b]);
                }
                if let (Some(a), Some(b)) = (up, up_left) {
                    triangles.push([here, a, b]);
                }
                // Each edge is visited once, with the third corners of its two possible triangles.
                let sides = [
                    (right, up, node_number(i + 1, j - 1)),
                    (up, right, up_left),
                    (up_left, up, node_number(i - 1, j)),
                ];
                for (end, left, right) in sides {
                    let Some(end) = end else { continue };
                    used[here as usize] = true;
                    used[end as usize] = true;
                    let border = match (left.is_some(), right.is_some()) {
                        (true, true) => continue,
                        (false, false) => Border::Slit,
                        _ => Border::Lattice,
                    };
                    borders.push(Constraint { from: here, to: end, border });
                }
            }
        }
    }
    let mut number = vec![u32::MAX; nodes.len()];
    let mut kept = 0u32;
    for (k, &used) in used.iter().enumerate() {
        if used {
            number[k] = kept;
            nodes[kept as usize] = nodes[k];
            kept += 1;
        }
    }
    nodes.truncate(kept as usize);
    for triangle in &mut triangles {
        *triangle = triangle.map(|v| number[v as usize]);
    }
    for border in &mut borders {
        (border.from, border.to) = (number[border.from as usize], number[border.to as usize]);
    }
    Lattice { nodes, triangles, borders }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An L-shaped domain with a hole. It has concave corners, several intervals per row, and thin blocked intervals.
    fn domain() -> (Vec<DVec2>, Vec<(u32, u32)>) {
        let corners = [[0.0, 0.0], [17.0, 0.0], [17.0, 6.0], [7.5, 7.0], [6.0, 15.0], [0.0, 15.0]].map(DVec2::from);
        let hole = [[2.0, 2.0], [2.5, 5.5], [5.0, 2.5]].map(DVec2::from);
        let (mut nodes, mut pieces) = (Vec::new(), Vec::new());
        for ring in [&corners[..], &hole[..]] {
            let first = nodes.len() as u32;
            for k in 0..ring.len() {
                let (a, b) = (ring[k], ring[(k + 1) % ring.len()]);
                let count = (a.distance(b) / 1.7).ceil();
                nodes.extend((0..count as u32).map(|k| a + (b - a) * (f64::from(k) / count)));
            }
            let last = nodes.len() as u32;
            pieces.extend((first..last).map(|k| (k, if k + 1 == last { first } else { k + 1 })));
        }
        (nodes, pieces)
    }

    /// The lattice nodes by definition: inside the boundary, at least 1 away from its nodes, and outside all diametral
    /// circles.
    fn brute_force(boundary: &Boundary<'_>, placement: Placement) -> Vec<DVec2> {
        let mut kept = Vec::new();
        for j in -60..60i64 {
            for i in -80..80i64 {
                let p = placement.origin + DVec2::new(i as f64 + j as f64 / 2.0, j as f64 * ROW);
                let p = unit_vector(placement.angle).rotate(p);
                let ends = |&(a, b): &(u32, u32)| (boundary.nodes[a as usize], boundary.nodes[b as usize]);
                let crossed = boundary.pieces.iter().map(ends).filter(|(a, b)| {
                    (a.y <= p.y) != (b.y <= p.y) && a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) > p.x
                });
                if crossed.count() % 2 == 1
                    && boundary.nodes.iter().all(|node| node.distance(p) >= 1.0)
                    && boundary.pieces.iter().map(ends).all(|(a, b)| (a - p).dot(b - p) > 0.0)
                {
                    kept.push(p);
                }
            }
        }
        kept
    }

    #[test]
    fn intervals_and_brute_force_find_the_same_lattice() {
        let (nodes, pieces) = domain();
        let boundary = Boundary { nodes: &nodes, pieces: &pieces };
        for k in 0..40 {
            let k = f64::from(k);
            let placement = Placement { angle: 0.026 * k, origin: DVec2::new(0.37 * k, 0.21 * k) };
            let expected = brute_force(&boundary, placement);
            let pairs = |p: &DVec2| expected.iter().filter(|q| (p.distance(**q) - 1.0).abs() < 1e-6).count();
            let edges = expected.iter().map(pairs).sum::<usize>() / 2;
            let lattice = place(&boundary, placement);
            let alone = expected.iter().filter(|p| pairs(p) == 0).count();
            assert_eq!(lattice.nodes.len(), expected.len() - alone);
            for p in &lattice.nodes {
                assert!(expected.iter().any(|q| p.distance(*q) < 1e-9) && placement.carries(*p));
            }
            // The edges are counted in three ways: as pairs of nodes, from the intervals, and from the triangles and
            // border edges.
            let turned: Vec<DVec2> = nodes.iter().map(|&p| unit_vector(-placement.angle).rotate(p)).collect();
            let mut rows = Rows::default();
            rows.build(&boundary, &turned, placement.origin.y);
            assert_eq!(rows.edges(placement.origin.x), edges);
            let slits = lattice.borders.iter().filter(|c| c.border == Border::Slit).count();
            assert_eq!((3 * lattice.triangles.len() + lattice.borders.len() - slits) / 2 + slits, edges);
        }
    }
}
