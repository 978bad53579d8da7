//! Kernels for the graphs of sections 4 and 5. A kernel derives the costs at a bridge from those at its two
//! predecessors.
//!
//! In a graph of one layer (area, twist, convexity, normal variation) a node is a bridge. With two layers (bending) a
//! node is a bridge and the step that led to it. With four layers (mean curvature variation, weighted sums) a node is a
//! bridge, the step that led to it and the step that leaves it. A path enters row 0 by a P-step and leaves the last row
//! by a P-step. On an open strip both P-steps are virtual. On a closed strip both are the step of the closing triangle:
//! every path takes exactly one step from p_{m-1} to p_0, and the bridge after this step is the start of the path.

use super::lanes::{Lanes, Vector};
use super::strip_arrays::{BANK, BandRows, NORMAL, POINT, StripArrays, TANGENT};
use super::sweep::{BitTable, Bounded, Kernel, Score, Seed};
use super::weight::{self, BridgeTriangle};

/// The cost of a path up to the present bridge, on every lane.
pub(crate) trait PathCost<V: Lanes>: Copy {
    const FIELDS: usize;
    /// The cost of a bridge that no path has reached.
    fn unreached(simd: V::Simd) -> Self;
    fn plus(self, value: V) -> Self;
    /// Counts the bridge if it is concave. A cost without a count stays as it is.
    fn enter(self, concave: V::Mask) -> Self;
    /// Adds to the sums that decide between paths of the same count and value. A cost without a count stays as it is.
    fn break_ties(self, bending: V, double_area: V) -> Self;
    fn less(self, other: Self) -> V::Mask;
    fn select(mask: V::Mask, yes: Self, no: Self) -> Self;
    fn shift_in(self, top: &[f64]) -> Self;
    fn keep(self, lane: usize, top: &mut [f64]);
    fn score(top: &[f64]) -> Score;
}

#[derive(Clone, Copy)]
pub(crate) struct PlainCost<V>(V);

impl<V: Lanes> PathCost<V> for PlainCost<V> {
    const FIELDS: usize = 1;
    #[inline(always)]
    fn unreached(simd: V::Simd) -> Self {
        Self(V::splat(simd, f64::INFINITY))
    }
    #[inline(always)]
    fn plus(self, value: V) -> Self {
        Self(self.0 + value)
    }
    #[inline(always)]
    fn enter(self, _: V::Mask) -> Self {
        self
    }
    #[inline(always)]
    fn break_ties(self, _: V, _: V) -> Self {
        self
    }
    #[inline(always)]
    fn less(self, other: Self) -> V::Mask {
        self.0.less(other.0)
    }
    #[inline(always)]
    fn select(mask: V::Mask, yes: Self, no: Self) -> Self {
        Self(V::select(mask, yes.0, no.0))
    }
    #[inline(always)]
    fn shift_in(self, top: &[f64]) -> Self {
        Self(self.0.shift_in(top[0]))
    }
    #[inline(always)]
    fn keep(self, lane: usize, top: &mut [f64]) {
        top[0] = keep(self.0, lane);
    }
    fn score(top: &[f64]) -> Score {
        Score::of_value(top[0])
    }
}

/// The cost of maximal convexity: the number of concave bridges, the secondary objective over these bridges, the
/// bending energy over all bridges, and twice the area. Costs are ordered by their fields, the first one first. Counts
/// are whole numbers far below 2^53.
#[derive(Clone, Copy)]
pub(crate) struct CoupledCost<V> {
    count: V,
    value: V,
    bending: V,
    double_area: V,
}

impl<V: Lanes> PathCost<V> for CoupledCost<V> {
    const FIELDS: usize = 4;
    #[inline(always)]
    fn unreached(simd: V::Simd) -> Self {
        let infinite = V::splat(simd, f64::INFINITY);
        Self { count: infinite, value: infinite, bending: infinite, double_area: infinite }
    }
    #[inline(always)]
    fn plus(self, value: V) -> Self {
        Self { value: self.value + value, ..self }
    }
    #[inline(always)]
    fn enter(self, concave: V::Mask) -> Self {
        let one = V::select(concave, self.count.constant(1.0), self.count.constant(0.0));
        Self { count: self.count + one, ..self }
    }
    #[inline(always)]
    fn break_ties(self, bending: V, double_area: V) -> Self {
        Self { bending: self.bending + bending, double_area: self.double_area + double_area, ..self }
    }
    #[inline(always)]
    fn less(self, other: Self) -> V::Mask {
        let by_area = self.double_area.less(other.double_area);
        let by_bending = self.bending.less(other.bending) | (self.bending.at_most(other.bending) & by_area);
        let by_value = self.value.less(other.value) | (self.value.at_most(other.value) & by_bending);
        self.count.less(other.count) | (self.count.at_most(other.count) & by_value)
    }
    #[inline(always)]
    fn select(mask: V::Mask, yes: Self, no: Self) -> Self {
        Self {
            count: V::select(mask, yes.count, no.count),
            value: V::select(mask, yes.value, no.value),
            bending: V::select(mask, yes.bending, no.bending),
            double_area: V::select(mask, yes.double_area, no.double_area),
        }
    }
    #[inline(always)]
    fn shift_in(self, top: &[f64]) -> Self {
        Self {
            count: self.count.shift_in(top[0]),
            value: self.value.shift_in(top[1]),
            bending: self.bending.shift_in(top[2]),
            double_area: self.double_area.shift_in(top[3]),
        }
    }
    #[inline(always)]
    fn keep(self, lane: usize, top: &mut [f64]) {
        top[0] = keep(self.count, lane);
        top[1] = keep(self.value, lane);
        top[2] = keep(self.bending, lane);
        top[3] = keep(self.double_area, lane);
    }
    fn score(top: &[f64]) -> Score {
        Score { count: top[0], value: top[1], bending: top[2], double_area: top[3] }
    }
}

#[inline(always)]
fn keep<V: Lanes>(value: V, lane: usize) -> f64 {
    if lane + 1 == V::WIDTH { value.last() } else { value.lane(lane) }
}

/// The weights of a single-layer graph.
pub(crate) trait StepWeights<V: Lanes> {
    /// Values that are the same along a band.
    type Band: Copy;
    fn simd(&self) -> V::Simd;
    fn band(&self, band: usize) -> Self::Band;
    /// The costs of arriving by a P-step and by a Q-step.
    fn steps(&self, band: &Self::Band, t: usize) -> [V; 2];
    /// Adds the cost of the bridge itself.
    fn bridge(&self, band: &Self::Band, t: usize, value: V) -> V;
}

/// Twice the area of the triangle of every step.
#[derive(Debug)]
pub(crate) struct Area<'a, S> {
    pub(crate) simd: S,
    pub(crate) arrays: &'a StripArrays,
}

impl<V: Lanes> StepWeights<V> for Area<'_, V::Simd> {
    type Band = [Vector<V>; 2];
    #[inline(always)]
    fn simd(&self) -> V::Simd {
        self.simd
    }
    #[inline(always)]
    fn band(&self, band: usize) -> Self::Band {
        let row = &self.arrays.row;
        [row.vector(self.simd, POINT, band * V::WIDTH), row.vector(self.simd, BANK, band * V::WIDTH)]
    }
    #[inline(always)]
    fn steps(&self, [p, bank]: &Self::Band, t: usize) -> [V; 2] {
        let (column, at) = (&self.arrays.column, self.arrays.at(t));
        let bridge = column.vector::<V>(self.simd, POINT, at).minus(*p);
        [weight::double_area(*bank, bridge), weight::double_area(column.vector(self.simd, BANK, at), bridge)]
    }
    #[inline(always)]
    fn bridge(&self, _: &Self::Band, _: usize, value: V) -> V {
        value
    }
}

/// Normal twist of every bridge.
#[derive(Debug)]
pub(crate) struct Twist<'a, S> {
    pub(crate) simd: S,
    pub(crate) arrays: &'a StripArrays,
}

impl<V: Lanes> StepWeights<V> for Twist<'_, V::Simd> {
    type Band = [Vector<V>; 2];
    #[inline(always)]
    fn simd(&self) -> V::Simd {
        self.simd
    }
    #[inline(always)]
    fn band(&self, band: usize) -> Self::Band {
        let row = &self.arrays.row;
        [row.vector(self.simd, POINT, band * V::WIDTH), row.vector(self.simd, TANGENT, band * V::WIDTH)]
    }
    #[inline(always)]
    fn steps(&self, _: &Self::Band, _: usize) -> [V; 2] {
        [V::splat(self.simd, 0.0); 2]
    }
    #[inline(always)]
    fn bridge(&self, [p, tangent]: &Self::Band, t: usize, value: V) -> V {
        let (column, at) = (&self.arrays.column, self.arrays.at(t));
        value
            + weight::twist(
                column.vector::<V>(self.simd, POINT, at).minus(*p),
                *tangent,
                column.vector(self.simd, TANGENT, at),
            )
    }
}

/// Normal variation of every bridge, for the winding of the strip's triangles (`sign` 1) or the opposite winding (-1).
#[derive(Debug)]
pub(crate) struct NormalVariation<'a, S> {
    pub(crate) simd: S,
    pub(crate) arrays: &'a StripArrays,
    pub(crate) sign: f64,
}

impl<V: Lanes> StepWeights<V> for NormalVariation<'_, V::Simd> {
    type Band = [Vector<V>; 3];
    #[inline(always)]
    fn simd(&self) -> V::Simd {
        self.simd
    }
    #[inline(always)]
    fn band(&self, band: usize) -> Self::Band {
        let (row, at) = (&self.arrays.row, band * V::WIDTH);
        [
            row.vector(self.simd, POINT, at),
            row.vector(self.simd, TANGENT, at),
            row.vector::<V>(self.simd, NORMAL, at).times(V::splat(self.simd, self.sign)),
        ]
    }
    #[inline(always)]
    fn steps(&self, _: &Self::Band, _: usize) -> [V; 2] {
        [V::splat(self.simd, 0.0); 2]
    }
    #[inline(always)]
    fn bridge(&self, [p, tangent, normal]: &Self::Band, t: usize, value: V) -> V {
        let (column, at) = (&self.arrays.column, self.arrays.at(t));
        let other = column.vector::<V>(self.simd, NORMAL, at).times(V::splat(self.simd, self.sign));
        let bridge = column.vector::<V>(self.simd, POINT, at).minus(*p);
        value + weight::normal_variation(bridge, [*tangent, column.vector(self.simd, TANGENT, at)], [*normal, other])
    }
}

/// The bridges that maximal convexity counts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ConcaveBridges<'a> {
    pub(crate) table: &'a BitTable,
    /// Whether the kernel's own objective, summed over these bridges, decides before the bending energy of all bridges.
    pub(crate) is_coupled: bool,
    /// Folds within the rounding of the input count as flat where the bending energy of all bridges decides. Otherwise
    /// rounding would outweigh the area on a plane strip.
    pub(crate) rounding: f64,
}

impl ConcaveBridges<'_> {
    /// The lanes on which the kernel's own objective counts.
    #[inline(always)]
    fn counted<V: Lanes>(&self, simd: V::Simd, concave: V::Mask) -> V::Mask {
        concave & V::from_bits(simd, if self.is_coupled { u32::MAX } else { 0 })
    }

    /// Returns the bending energy that breaks ties, from the energy at a bridge between two triangles.
    #[inline(always)]
    fn tie_energy<V: Lanes>(&self, energy: V, left: &BridgeTriangle<V>, right: &BridgeTriangle<V>) -> V {
        let flat = weight::is_flat(left, right, energy.constant(self.rounding));
        V::select(flat, energy.constant(0.0), energy)
    }
}

/// The single-layer graph (section 4): a node is a bridge. Its back pointer is the step that led to it.
#[derive(Debug)]
pub(crate) struct SingleLayer<W>(pub(crate) W);

impl<V: Lanes, W: StepWeights<V>> Kernel<V> for SingleLayer<W> {
    const LAYERS: usize = 1;
    const CARRY: usize = 1;
    type Band = W::Band;
    type State = V;
    #[inline(always)]
    fn simd(&self) -> V::Simd {
        self.0.simd()
    }
    #[inline(always)]
    fn band(&self, band: usize) -> Self::Band {
        self.0.band(band)
    }
    #[inline(always)]
    fn blank(&self) -> V {
        V::splat(self.0.simd(), f64::INFINITY)
    }
    #[inline(always)]
    fn step(&self, band: &Self::Band, state: &mut V, top: &[f64], t: usize) -> u32 {
        let [by_p, by_q] = self.0.steps(band, t);
        let above = state.shift_in(top[0]) + by_p;
        let left = *state + by_q;
        let step_q = left.less(above);
        *state = self.0.bridge(band, t, V::select(step_q, left, above));
        V::bits(step_q)
    }
    #[inline(always)]
    fn keep(&self, state: &V, lane: usize, top: &mut [f64]) {
        top[0] = keep(*state, lane);
    }
    fn unreached(&self, top: &mut [f64]) {
        top[0] = f64::INFINITY;
    }
    fn source(&self, _: usize, _: Seed, top: &mut [f64]) {
        top[0] = 0.0;
    }
    fn end(&self, top: &[f64], _: usize) -> Score {
        Score::of_value(top[0])
    }
}

/// The dual-layer graph (section 5.1). A node is a bridge and the step that led to it. The cost of leaving a node
/// includes the bending at its bridge. For each of the two steps that can leave a bridge, the back pointer is the step
/// that led to the bridge.
#[derive(Debug)]
pub(crate) struct DualLayer<'a, S, C> {
    pub(crate) simd: S,
    pub(crate) arrays: &'a StripArrays,
    /// The bridges that are not locally convex, if their number is minimised.
    pub(crate) concave: Option<ConcaveBridges<'a>>,
    pub(crate) cost: std::marker::PhantomData<C>,
}

impl<V: Lanes, C: PathCost<V>> Kernel<V> for DualLayer<'_, V::Simd, C> {
    const LAYERS: usize = 2;
    const CARRY: usize = C::FIELDS;
    type Band = BandRows<V>;
    /// The costs of leaving the bridge by P and by Q.
    type State = [C; 2];
    #[inline(always)]
    fn simd(&self) -> V::Simd {
        self.simd
    }
    #[inline(always)]
    fn band(&self, band: usize) -> Self::Band {
        self.arrays.band_rows(self.simd, band)
    }
    #[inline(always)]
    fn blank(&self) -> [C; 2] {
        [C::unreached(self.simd); 2]
    }
    #[inline(always)]
    fn step(&self, band: &Self::Band, state: &mut [C; 2], top: &[f64], t: usize) -> u32 {
        let (_, squared, [in_p, in_q, out_p, out_q]) = self.arrays.triangles(band, t);
        let law = self.arrays.bending;
        let mut energy = [
            weight::bending(law, squared, &in_p, &out_p),
            weight::bending(law, squared, &in_q, &out_p),
            weight::bending(law, squared, &in_p, &out_q),
            weight::bending(law, squared, &in_q, &out_q),
        ];
        let (mut by_p, mut by_q) = (state[0].shift_in(top), state[1]);
        let mut ties = [V::splat(self.simd, 0.0); 4];
        if let Some(bridges) = self.concave {
            let concave = V::from_bits(self.simd, bridges.table.lanes(band.number, t));
            let counted = bridges.counted::<V>(self.simd, concave);
            ties = [
                bridges.tie_energy(energy[0], &in_p, &out_p),
                bridges.tie_energy(energy[1], &in_q, &out_p),
                bridges.tie_energy(energy[2], &in_p, &out_q),
                bridges.tie_energy(energy[3], &in_q, &out_q),
            ];
            for energy in &mut energy {
                *energy = V::select(counted, *energy, energy.constant(0.0));
            }
            (by_p, by_q) = (by_p.enter(concave), by_q.enter(concave));
        }
        let pp = by_p.plus(energy[0]).break_ties(ties[0], in_p.length);
        let qp = by_q.plus(energy[1]).break_ties(ties[1], in_q.length);
        let pq = by_p.plus(energy[2]).break_ties(ties[2], in_p.length);
        let qq = by_q.plus(energy[3]).break_ties(ties[3], in_q.length);
        let (from_q_to_p, from_q_to_q) = (qp.less(pp), qq.less(pq));
        *state = [C::select(from_q_to_p, qp, pp), C::select(from_q_to_q, qq, pq)];
        V::bits(from_q_to_p) | V::bits(from_q_to_q) << V::WIDTH
    }
    #[inline(always)]
    fn keep(&self, state: &[C; 2], lane: usize, top: &mut [f64]) {
        state[0].keep(lane, top);
    }
    fn unreached(&self, top: &mut [f64]) {
        top.fill(f64::INFINITY);
    }
    fn source(&self, _: usize, _: Seed, top: &mut [f64]) {
        top.fill(0.0);
    }
    fn end(&self, top: &[f64], _: usize) -> Score {
        C::score(top)
    }
}

impl<V: Lanes> Bounded<V> for DualLayer<'_, V::Simd, PlainCost<V>> {
    #[inline(always)]
    fn is_alive(&self, state: &[PlainCost<V>; 2], bound: f64) -> bool {
        let bound = V::splat(self.simd, bound);
        V::bits(state[0].0.at_most(bound) | state[1].0.at_most(bound)) != 0
    }
    #[inline(always)]
    fn hands_down(&self, top: &[f64], bound: f64) -> bool {
        top[0] <= bound
    }
}

/// Factors of the terms of a weighted sum. Each factor is the weight divided by the value that normalises the term.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Factors {
    pub(crate) double_area: f64,
    pub(crate) twist: f64,
    pub(crate) bending: f64,
    pub(crate) curvature: f64,
    pub(crate) normal_variation: f64,
    /// Winding for the normal variation, 1 or -1.
    pub(crate) sign: f64,
}

/// The quadruple-layer graph (section 5.2). A node is a bridge, the step that led to it and the step that leaves it.
/// The cost of a link is the change of the mean curvature vector from one node to the next. The back pointer of a node
/// is the step that led to the previous bridge.
#[derive(Debug)]
pub(crate) struct QuadrupleLayer<'a, S, C> {
    pub(crate) simd: S,
    pub(crate) arrays: &'a StripArrays,
    /// The bridges that are not locally convex, if their number is minimised.
    pub(crate) concave: Option<ConcaveBridges<'a>>,
    /// Factors of a weighted sum. `None` minimises the curvature variation alone.
    pub(crate) factors: Option<Factors>,
    pub(crate) cost: std::marker::PhantomData<C>,
}

/// A bridge's four nodes, `[arrived by P, leaving by P], [P, Q], [Q, P], [Q, Q]`.
#[derive(Clone, Copy)]
pub(crate) struct Nodes<V, C> {
    cost: [C; 4],
    curvature: [Vector<V>; 4],
}

/// Mean curvature vectors of the four nodes.
#[inline(always)]
fn curvatures<V: Lanes>(bridge: Vector<V>, triangles: &[BridgeTriangle<V>; 4]) -> [Vector<V>; 4] {
    let in_p = (weight::curvature_part(bridge, &triangles[0]), triangles[0].sound);
    let in_q = (weight::curvature_part(bridge, &triangles[1]), triangles[1].sound);
    let out_p = (weight::curvature_part(bridge, &triangles[2]), triangles[2].sound);
    let out_q = (weight::curvature_part(bridge, &triangles[3]), triangles[3].sound);
    [
        weight::mean_curvature(in_p, out_p),
        weight::mean_curvature(in_p, out_q),
        weight::mean_curvature(in_q, out_p),
        weight::mean_curvature(in_q, out_q),
    ]
}

impl<V: Lanes, C: PathCost<V>> Kernel<V> for QuadrupleLayer<'_, V::Simd, C> {
    const LAYERS: usize = 4;
    /// Carries the costs and mean curvature vectors of the two nodes that leave by P.
    const CARRY: usize = 2 * C::FIELDS + 6;
    type Band = BandRows<V>;
    type State = Nodes<V, C>;
    #[inline(always)]
    fn simd(&self) -> V::Simd {
        self.simd
    }
    #[inline(always)]
    fn band(&self, band: usize) -> Self::Band {
        self.arrays.band_rows(self.simd, band)
    }
    #[inline(always)]
    fn blank(&self) -> Self::State {
        Nodes { cost: [C::unreached(self.simd); 4], curvature: [Vector::zero(self.simd); 4] }
    }
    #[inline(always)]
    fn step(&self, band: &Self::Band, state: &mut Self::State, top: &[f64], t: usize) -> u32 {
        let (bridge, squared, triangles) = self.arrays.triangles(band, t);
        let here = curvatures(bridge, &triangles);
        let f = 2 * C::FIELDS;
        // The four predecessor nodes: the bridge above, arrived at by P and by Q, then the bridge to the left, by P and
        // by Q.
        let mut back = [
            (state.cost[0].shift_in(top), state.curvature[0].shift_in(&top[f..])),
            (state.cost[2].shift_in(&top[C::FIELDS..]), state.curvature[2].shift_in(&top[f + 3..])),
            (state.cost[1], state.curvature[1]),
            (state.cost[3], state.curvature[3]),
        ];
        #[expect(clippy::manual_map, reason = "a closure need not be compiled for the wide instructions")]
        let concave = match self.concave {
            Some(bridges) => Some(V::from_bits(self.simd, bridges.table.lanes(band.number, t))),
            None => None,
        };
        if let Some(concave) = concave {
            for (cost, _) in &mut back {
                *cost = cost.enter(concave);
            }
        }
        let mut bits = 0;
        let mut cost = state.cost;
        for node in 0..4 {
            let [(from_p, curvature_p), (from_q, curvature_q)] =
                if node < 2 { [back[0], back[1]] } else { [back[2], back[3]] };
            let mut jump_p = weight::curvature_step(curvature_p, here[node]);
            let mut jump_q = weight::curvature_step(curvature_q, here[node]);
            if let Some(concave) = concave {
                let zero = jump_p.constant(0.0);
                (jump_p, jump_q) = (V::select(concave, jump_p, zero), V::select(concave, jump_q, zero));
            }
            if let Some(factors) = &self.factors {
                let factor = jump_p.constant(factors.curvature);
                (jump_p, jump_q) = (jump_p * factor, jump_q * factor);
            }
            let (by_p, by_q) = (from_p.plus(jump_p), from_q.plus(jump_q));
            let choose_q = by_q.less(by_p);
            cost[node] = C::select(choose_q, by_q, by_p);
            bits |= V::bits(choose_q) << (node * V::WIDTH);
        }
        if let Some(factors) = &self.factors {
            let terms = self.terms(factors, bridge, squared, &triangles, band, t);
            for node in 0..4 {
                cost[node] = cost[node].plus(terms[node]);
            }
        }
        if let Some(bridges) = self.concave {
            for (node, (arrive, leave)) in [(0, 2), (0, 3), (1, 2), (1, 3)].into_iter().enumerate() {
                let (left, right) = (&triangles[arrive], &triangles[leave]);
                let energy = weight::bending(self.arrays.bending, squared, left, right);
                cost[node] = cost[node].break_ties(bridges.tie_energy(energy, left, right), left.length);
            }
        }
        *state = Nodes { cost, curvature: here };
        bits
    }
    #[inline(always)]
    fn keep(&self, state: &Self::State, lane: usize, top: &mut [f64]) {
        let f = C::FIELDS;
        state.cost[0].keep(lane, top);
        state.cost[2].keep(lane, &mut top[f..]);
        for (at, curvature) in [(2 * f, state.curvature[0]), (2 * f + 3, state.curvature[2])] {
            top[at] = keep(curvature.x, lane);
            top[at + 1] = keep(curvature.y, lane);
            top[at + 2] = keep(curvature.z, lane);
        }
    }
    fn unreached(&self, top: &mut [f64]) {
        let (costs, curvatures) = top.split_at_mut(2 * C::FIELDS);
        costs.fill(f64::INFINITY);
        curvatures.fill(0.0);
    }
    fn source(&self, column: usize, seed: Seed, top: &mut [f64]) {
        self.unreached(top);
        let f = C::FIELDS;
        let (by_p, by_q) = match seed {
            Seed::Open => (true, false),
            Seed::Either => (true, true),
            Seed::ByP => (true, false),
            Seed::ByQ => (false, true),
        };
        if by_p {
            top[..f].fill(0.0);
        }
        if by_q {
            top[f..2 * f].fill(0.0);
        }
        if seed != Seed::Open {
            // The closing step leaves the last row. The mean curvature vectors there are computed as at the end of the
            // path.
            let band = self.arrays.band_rows::<f64>((), self.arrays.rows - 1);
            let (bridge, _, triangles) = self.arrays.triangles::<f64>(&band, column);
            let here = curvatures(bridge, &triangles);
            for (at, curvature) in [(2 * f, here[0]), (2 * f + 3, here[2])] {
                [top[at], top[at + 1], top[at + 2]] = [curvature.x, curvature.y, curvature.z];
            }
        }
    }
    fn end(&self, top: &[f64], arrived_by: usize) -> Score {
        C::score(&top[arrived_by * C::FIELDS..])
    }
}

impl<S: Copy, C> QuadrupleLayer<'_, S, C> {
    /// Returns the terms of a weighted sum at each of the four nodes, without the curvature variation.
    #[inline(always)]
    fn terms<V: Lanes<Simd = S>>(
        &self,
        factors: &Factors,
        bridge: Vector<V>,
        squared: V,
        triangles: &[BridgeTriangle<V>; 4],
        band: &BandRows<V>,
        t: usize,
    ) -> [V; 4] {
        let (row, column, at) = (&self.arrays.row, &self.arrays.column, self.arrays.at(t));
        let row_at = band.number * V::WIDTH;
        let mut shared = squared.constant(0.0);
        if factors.twist != 0.0 {
            let twist =
                weight::twist(bridge, row.vector(self.simd, TANGENT, row_at), column.vector(self.simd, TANGENT, at));
            shared = shared + squared.constant(factors.twist) * twist;
        }
        if factors.normal_variation != 0.0 {
            let sign = squared.constant(factors.sign);
            let tangents = [row.vector(self.simd, TANGENT, row_at), column.vector(self.simd, TANGENT, at)];
            let normals = [
                row.vector::<V>(self.simd, NORMAL, row_at).times(sign),
                column.vector::<V>(self.simd, NORMAL, at).times(sign),
            ];
            let variation = weight::normal_variation(bridge, tangents, normals);
            shared = shared + squared.constant(factors.normal_variation) * variation;
        }
        let (area, bending) = (squared.constant(factors.double_area), squared.constant(factors.bending));
        let arrive = [shared + area * triangles[0].length, shared + area * triangles[1].length];
        let law = self.arrays.bending;
        [
            arrive[0] + bending * weight::bending(law, squared, &triangles[0], &triangles[2]),
            arrive[0] + bending * weight::bending(law, squared, &triangles[0], &triangles[3]),
            arrive[1] + bending * weight::bending(law, squared, &triangles[1], &triangles[2]),
            arrive[1] + bending * weight::bending(law, squared, &triangles[1], &triangles[3]),
        ]
    }
}
