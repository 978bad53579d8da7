//! Every quantity of Wang and Tang's Table 1 (and a few more) of one given triangulation of a strip.

use crate::graph::convexity::{self, ConvexityTest};
use crate::graph::lanes::{LaneWidth, Lanes, MOST_LANES, Task, Vector, with_lanes};
use crate::graph::rails::Rails;
use crate::graph::weight::{self, BridgeTriangle};
use plateau_mesh::DVec3;
use plateau_mesh::error::Error;
use plateau_mesh::execution::Execution;

/// Difference of two fold angles, in radians, above which one counts as larger than the other. It exceeds the rounding
/// of a rotated strip, so that a corner of exactly 90° does not count as more than a right angle.
pub(crate) const SMALLER_FOLD: f64 = 1e-6;

/// The figures of one strip or of a whole stack. Lengths are in the caller's unit, angles in radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// Number of triangles. The number of a whole stack includes its caps.
    pub triangles: usize,
    /// Number of bridges, including the first and the last one of an open strip.
    pub bridges: usize,
    /// Sum of the areas of the triangles.
    pub area: f64,
    /// Sum of 1 - n_p·n_q over all bridges (definition 5).
    pub total_normal_twist: f64,
    /// Number of bridges that are locally convex (definition 6).
    pub convex_bridges: usize,
    /// Locally convex bridges as a fraction of all bridges.
    pub convex_bridge_ratio: f64,
    /// Bending energy (eq. 7).
    pub bending_energy: f64,
    /// Mean curvature variation (eq. 10), over all pairs of consecutive bridges, in the caller's unit of length.
    pub mean_curvature_variation: f64,
    /// Normal variation (eq. 12); `None` without normals.
    pub normal_variation: Option<f64>,
    /// The largest angle between the normals of neighbouring triangles.
    pub largest_fold: f64,
    /// The largest angle between the normals of neighbouring triangles at a bridge that is not locally convex; 0 if all
    /// bridges are locally convex.
    pub developability_deviation: f64,
    /// Length of the shortest bridge.
    pub shortest_bridge: f64,
    /// Length of the longest bridge.
    pub longest_bridge: f64,
    /// Value of the objective; for maximal convexity the number of convex bridges.
    pub objective_value: f64,
    /// The secondary objective of a coupling, summed over the bridges that are not convex; `None` for other objectives.
    pub secondary_value: Option<f64>,
}

impl Statistics {
    /// Whether neighbouring triangles fold by more than 90°.
    #[must_use]
    pub(crate) fn folds_back(&self) -> bool {
        self.largest_fold > std::f64::consts::FRAC_PI_2 + SMALLER_FOLD
    }
    /// Returns the figures of several strips together: sums, or the smallest and the largest value of an extreme.
    #[must_use]
    pub fn total(strips: &[Self]) -> Self {
        let mut all = strips.first().copied().unwrap_or_default();
        for strip in &strips[1.min(strips.len())..] {
            all.triangles += strip.triangles;
            all.bridges += strip.bridges;
            all.area += strip.area;
            all.total_normal_twist += strip.total_normal_twist;
            all.convex_bridges += strip.convex_bridges;
            all.bending_energy += strip.bending_energy;
            all.mean_curvature_variation += strip.mean_curvature_variation;
            all.normal_variation = all.normal_variation.zip(strip.normal_variation).map(|(a, b)| a + b);
            all.largest_fold = all.largest_fold.max(strip.largest_fold);
            all.developability_deviation = all.developability_deviation.max(strip.developability_deviation);
            all.shortest_bridge = all.shortest_bridge.min(strip.shortest_bridge);
            all.longest_bridge = all.longest_bridge.max(strip.longest_bridge);
            all.objective_value += strip.objective_value;
            all.secondary_value = all.secondary_value.zip(strip.secondary_value).map(|(a, b)| a + b);
        }
        all.convex_bridge_ratio = all.convex_bridges as f64 / all.bridges.max(1) as f64;
        all
    }
}

/// A bridge that is not locally convex.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ConcaveBridge {
    /// Number of the bridge. Bridges count from 0 over all strips.
    pub bridge: u32,
    /// The angle between the normals of its two triangles, in radians; 0 if one of them has no area.
    pub fold: f64,
}

/// The secondary objectives of the couplings, summed over the bridges that are not locally convex.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CoupledValues {
    /// Bending energy at these bridges.
    pub bending_energy: f64,
    /// Mean curvature variation of the steps that enter these bridges.
    pub mean_curvature_variation: f64,
}

/// The figures of a path, and the figures that only the couplings need.
#[derive(Clone, Debug, Default)]
pub(crate) struct Evaluation {
    pub(crate) statistics: Statistics,
    /// Normal variation with the strip's own winding of the triangles, and with the opposite winding.
    pub(crate) normal_variation: Option<[f64; 2]>,
    /// Bending energy and curvature variation over the bridges that are not convex.
    pub(crate) concave_bending: f64,
    pub(crate) concave_curvature: f64,
    /// The bridges that are not convex, by their number along the path, with their folds.
    pub(crate) concave: Vec<(u32, Angle)>,
}

/// An angle from 0 to 180°, as its sine and cosine times any positive number. Two angles are compared without computing
/// either of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Angle {
    sine: f64,
    cosine: f64,
}

impl Angle {
    const ZERO: Self = Self { sine: 0.0, cosine: 1.0 };

    fn max(self, other: Self) -> Self {
        // The sine of the difference. It is 0 for equal angles, and for the pair of 0° and 180°.
        let difference = other.sine * self.cosine - self.sine * other.cosine;
        let opposite = difference == 0.0 && self.cosine > 0.0 && other.cosine < 0.0;
        if difference > 0.0 || opposite { other } else { self }
    }
    pub(crate) fn radians(self) -> f64 {
        libm::atan2(self.sine, self.cosine)
    }
}

/// Number of bridges between two checks of the caller's signal. Their evaluation takes less than a millisecond.
const BRIDGES_BETWEEN_LOOKS: usize = 4096;

/// Evaluates a path, given as its bridges in order. On a closed strip the indices are cyclic and the first bridge is
/// not repeated at the end. O(bridges).
pub(crate) fn evaluate(
    strip: &Rails,
    path: &[[u32; 2]],
    test: ConvexityTest,
    lanes: LaneWidth,
    execution: &Execution<'_>,
) -> Result<Evaluation, Error> {
    let mut sums = Sums::new(path.len());
    for first in (0..path.len()).step_by(BRIDGES_BETWEEN_LOOKS) {
        let bridges = first..path.len().min(first + BRIDGES_BETWEEN_LOOKS);
        with_lanes!(lanes, V, simd => {
            V::run(simd, PathPart { simd, strip, path, test, bridges: bridges.clone(), sums: &mut sums });
        });
        if bridges.end < path.len() {
            execution.look(16 * bridges.len() as u64)?;
        }
    }
    Ok(sums.evaluation(strip))
}

/// Sums over the bridges added so far, in the strip's own unit. Bridges are added one by one, whatever the width of the
/// lanes, so that every width gives the same rounding.
struct Sums {
    evaluation: Evaluation,
    variation: [f64; 2],
    /// Number of bridges added so far.
    added: u32,
    largest_fold: Angle,
    largest_concave_fold: Angle,
    first: Option<(Vector<f64>, bool)>,
    last_curvature: Vector<f64>,
}

/// The figures of one bridge of a path, which are added to the sums.
struct AtBridge {
    convex: bool,
    length: f64,
    /// Twice the area of the triangle after the bridge; 0 if there is none.
    double_area: f64,
    twist: f64,
    variation: [f64; 2],
    /// The angle between two neighbouring triangles, if neither is degenerate.
    fold: Option<Angle>,
    bending: f64,
    curvature: Vector<f64>,
}

impl Sums {
    fn new(bridges: usize) -> Self {
        let statistics = Statistics { bridges, shortest_bridge: f64::INFINITY, ..Statistics::default() };
        Self {
            evaluation: Evaluation { statistics, ..Evaluation::default() },
            variation: [0.0; 2],
            added: 0,
            largest_fold: Angle::ZERO,
            largest_concave_fold: Angle::ZERO,
            first: None,
            last_curvature: Vector::zero(()),
        }
    }

    #[inline(always)]
    fn add(&mut self, bridge: &AtBridge) {
        let statistics = &mut self.evaluation.statistics;
        statistics.convex_bridges += usize::from(bridge.convex);
        statistics.shortest_bridge = statistics.shortest_bridge.min(bridge.length);
        statistics.longest_bridge = statistics.longest_bridge.max(bridge.length);
        statistics.total_normal_twist += bridge.twist;
        statistics.area += 0.5 * bridge.double_area;
        for (sum, variation) in self.variation.iter_mut().zip(bridge.variation) {
            *sum += variation;
        }
        if let Some(fold) = bridge.fold {
            statistics.bending_energy += bridge.bending;
            self.largest_fold = self.largest_fold.max(fold);
            if !bridge.convex {
                self.evaluation.concave_bending += bridge.bending;
                self.largest_concave_fold = self.largest_concave_fold.max(fold);
            }
        }
        if !bridge.convex {
            self.evaluation.concave.push((self.added, bridge.fold.unwrap_or(Angle::ZERO)));
        }
        self.added += 1;
        if self.first.is_none() {
            self.first = Some((bridge.curvature, bridge.convex));
        } else {
            self.step(bridge.curvature, bridge.convex);
        }
        self.last_curvature = bridge.curvature;
    }

    /// Adds the change of the mean curvature vector on the step into a bridge.
    #[inline(always)]
    fn step(&mut self, curvature: Vector<f64>, convex: bool) {
        let step = weight::curvature_step(self.last_curvature, curvature);
        self.evaluation.statistics.mean_curvature_variation += step;
        self.evaluation.concave_curvature += if convex { 0.0 } else { step };
    }

    fn evaluation(mut self, strip: &Rails) -> Evaluation {
        if let Some((curvature, convex)) = self.first.filter(|_| strip.closed) {
            self.step(curvature, convex);
        }
        let mut evaluation = self.evaluation;
        let (unit, statistics) = (strip.unit, &mut evaluation.statistics);
        statistics.triangles = strip.triangles();
        statistics.largest_fold = self.largest_fold.radians();
        statistics.developability_deviation = self.largest_concave_fold.radians();
        statistics.area *= unit * unit;
        statistics.mean_curvature_variation *= unit;
        statistics.shortest_bridge *= unit;
        statistics.longest_bridge *= unit;
        statistics.convex_bridge_ratio = statistics.convex_bridges as f64 / statistics.bridges as f64;
        evaluation.concave_curvature *= unit;
        evaluation.normal_variation = strip.has_normals().then_some(self.variation);
        evaluation
    }
}

/// Evaluates a range of a path's bridges and adds them to the sums.
struct PathPart<'a, S> {
    simd: S,
    strip: &'a Rails,
    path: &'a [[u32; 2]],
    test: ConvexityTest,
    bridges: std::ops::Range<usize>,
    sums: &'a mut Sums,
}

/// A number for each lane.
type Row = [f64; MOST_LANES];
/// A vector for each lane, by components.
type Rows = [Row; 3];

#[inline(always)]
fn put(rows: &mut Rows, lane: usize, vector: DVec3) {
    for (axis, row) in rows.iter_mut().enumerate() {
        row[lane] = vector[axis];
    }
}

#[inline(always)]
fn vector<V: Lanes>(simd: V::Simd, rows: &Rows) -> Vector<V> {
    Vector::new(V::load(simd, &rows[0]), V::load(simd, &rows[1]), V::load(simd, &rows[2]))
}

#[inline(always)]
fn triangle<V: Lanes>(bank: &Rows, bridge: Vector<V>, bridge_squared: V) -> BridgeTriangle<V> {
    let bank = vector(bridge_squared.simd(), bank);
    BridgeTriangle::new(bank, bank.dot(bank), bridge, bridge_squared)
}

/// Returns the normal variation with the given normals, and with the opposite normals.
#[inline(always)]
fn normal_variations<V: Lanes>(
    simd: V::Simd,
    bridge: Vector<V>,
    tangents: [Vector<V>; 2],
    normals: [Vector<V>; 2],
) -> [V; 2] {
    let back = V::splat(simd, -1.0);
    [
        weight::normal_variation(bridge, tangents, normals),
        weight::normal_variation(bridge, tangents, [normals[0].times(back), normals[1].times(back)]),
    ]
}

/// The code below has no closures over lanes, because the compiler does not compile closures for the instructions that
/// [`Lanes::run`] enables.
impl<V: Lanes> Task<V> for PathPart<'_, V::Simd> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let PathPart { simd, strip, path, test, bridges, sums } = self;
        let (m, n, count) = (strip.m(), strip.n(), path.len());
        let (tangents_p, tangents_q) = (strip.p.tangents(strip.closed), strip.q.tangents(strip.closed));
        // A step by P changes the first index (by one, or back to 0). On a strip with an apex all steps are by Q or all
        // by P.
        let by_p = |from: usize, to: usize| m > 1 && (n == 1 || path[from][0] != path[to][0]);
        let mut start = bridges.start;
        // Ends because each pass raises the start by the number of lanes, which is at least 1.
        while start < bridges.end {
            let lanes = V::WIDTH.min(bridges.end - start);
            let mut rows = [[[0.0; MOST_LANES]; 3]; 5];
            // The bank edges at each bridge: arriving by P, by Q, leaving by P, by Q.
            let mut banks = [[[0.0; MOST_LANES]; 3]; 4];
            let (mut arrived_by_p, mut leaves_by_p) = (0, 0);
            for lane in 0..lanes {
                let k = start + lane;
                let [i, j] = path[k].map(|index| index as usize);
                put(&mut rows[0], lane, strip.q.points[j] - strip.p.points[i]);
                put(&mut rows[1], lane, tangents_p[i]);
                put(&mut rows[2], lane, tangents_q[j]);
                if strip.has_normals() {
                    put(&mut rows[3], lane, strip.p.normals[i]);
                    put(&mut rows[4], lane, strip.q.normals[j]);
                }
                for (side, bank) in banks.iter_mut().enumerate() {
                    let (directrix, index) = if side % 2 == 0 { (&strip.p, i) } else { (&strip.q, j) };
                    put(bank, lane, directrix.bank(index, side / 2, strip.closed));
                }
                // At the two ends of an open strip these bits do not matter, because both bank edges there are zero.
                arrived_by_p |= u32::from(by_p((k + count - 1) % count, k)) << lane;
                leaves_by_p |= u32::from(by_p(k, (k + 1) % count)) << lane;
            }
            let bridge = vector::<V>(simd, &rows[0]);
            let squared = bridge.dot(bridge);
            let length = squared.sqrt();
            let triangles = [
                triangle(&banks[0], bridge, squared),
                triangle(&banks[1], bridge, squared),
                triangle(&banks[2], bridge, squared),
                triangle(&banks[3], bridge, squared),
            ];
            let convex = convexity::are_convex(strip, &path[start..start + lanes], test, length, &triangles);
            let left = BridgeTriangle::select(V::from_bits(simd, arrived_by_p), &triangles[0], &triangles[1]);
            let right = BridgeTriangle::select(V::from_bits(simd, leaves_by_p), &triangles[2], &triangles[3]);
            let tangents = [vector::<V>(simd, &rows[1]), vector(simd, &rows[2])];
            let twist = weight::twist(bridge, tangents[0], tangents[1]);
            let variation = if strip.has_normals() {
                normal_variations(simd, bridge, tangents, [vector(simd, &rows[3]), vector(simd, &rows[4])])
            } else {
                [V::splat(simd, 0.0); 2]
            };
            let sound = V::bits(left.sound & right.sound);
            let bending = weight::bending(strip.bending, squared, &left, &right);
            let curvature = weight::mean_curvature(
                (weight::curvature_part(bridge, &left), left.sound),
                (weight::curvature_part(bridge, &right), right.sound),
            );
            let cross = left.normal.cross(right.normal);
            let (sine, cosine) = (cross.dot(cross).sqrt().lanes(), left.normal.dot(right.normal).lanes());
            let (length, double_area, twist, bending) =
                (length.lanes(), right.length.lanes(), twist.lanes(), bending.lanes());
            let variation = [variation[0].lanes(), variation[1].lanes()];
            let curvature = [curvature.x.lanes(), curvature.y.lanes(), curvature.z.lanes()];
            for lane in 0..lanes {
                let fold = Angle { sine: sine[lane], cosine: cosine[lane] };
                sums.add(&AtBridge {
                    convex: convex >> lane & 1 == 1,
                    length: length[lane],
                    double_area: double_area[lane],
                    twist: twist[lane],
                    variation: [variation[0][lane], variation[1][lane]],
                    fold: (sound >> lane & 1 == 1).then_some(fold),
                    bending: bending[lane],
                    curvature: Vector::new(curvature[0][lane], curvature[1][lane], curvature[2][lane]),
                });
            }
            start += lanes;
        }
    }
}
