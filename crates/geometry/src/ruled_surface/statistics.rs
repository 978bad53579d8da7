//! Every quantity of Wang and Tang's Table 1 (and a few more) of one given triangulation of a strip.

use super::convexity::{Test, is_convex};
use super::lanes::Vector;
use super::strip::Strip;
use super::weight::{self, Wing};
use crate::DVec3;
use crate::error::Error;
use crate::execution::Execution;

/// The figures of one strip or of a whole stack. Lengths in the caller's unit, angles in radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    pub triangles: usize,
    /// Bridges, the first and last of an open strip included.
    pub bridges: usize,
    pub area: f64,
    /// Sum of 1 - n_p·n_q over all bridges (definition 5).
    pub total_normal_twist: f64,
    /// Bridges that are locally convex (definition 6).
    pub convex_bridges: usize,
    /// Their share of all bridges.
    pub convex_bridge_ratio: f64,
    /// Eq. 7.
    pub bending_energy: f64,
    /// Eq. 10, over all consecutive bridges. Unit u.
    pub mean_curvature_variation: f64,
    /// Eq. 12; `None` without normals.
    pub normal_variation: Option<f64>,
    /// The largest angle between the normals of neighbouring triangles.
    pub largest_fold: f64,
    /// The same over the bridges that are not locally convex; 0 if all are.
    pub developability_deviation: f64,
    pub shortest_bridge: f64,
    pub longest_bridge: f64,
    /// What was minimised: for maximal convexity the number of convex bridges.
    pub objective_value: f64,
    /// Couplings: the secondary summed over the bridges that are not convex.
    pub secondary_value: Option<f64>,
}

impl Statistics {
    /// The figures of several strips together: sums, extremes.
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

/// The secondaries of the couplings: sums over the bridges that are not locally convex.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CoupledValues {
    pub bending_energy: f64,
    /// Of the steps that enter such a bridge.
    pub mean_curvature_variation: f64,
}

/// A path's figures, and what the couplings add.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Evaluation {
    pub(super) statistics: Statistics,
    /// Normal variation with the triangles wound as they come, and the other way round.
    pub(super) normal_variation: Option<[f64; 2]>,
    /// Bending energy and curvature variation over the bridges that are not convex.
    pub(super) concave_bending: f64,
    pub(super) concave_curvature: f64,
}

/// An angle from 0 to 180°, its sine and cosine times any positive number. Angles compare without being computed.
#[derive(Clone, Copy)]
struct Angle {
    sine: f64,
    cosine: f64,
}

impl Angle {
    const ZERO: Self = Self { sine: 0.0, cosine: 1.0 };

    fn max(self, other: Self) -> Self {
        if other.sine * self.cosine > self.sine * other.cosine { other } else { self }
    }
    fn radians(self) -> f64 {
        self.sine.atan2(self.cosine)
    }
}

/// Evaluates a path: bridges in order, indices cyclic on closed strips (without repeating the first). O(bridges).
pub(super) fn evaluate(
    strip: &Strip,
    path: &[[u32; 2]],
    test: Test,
    execution: &Execution<'_>,
) -> Result<Evaluation, Error> {
    let count = path.len();
    let (tangents_p, tangents_q) = (strip.p.tangents(strip.closed), strip.q.tangents(strip.closed));
    let bridge_at = |k: usize| path[k % count].map(|index| index as usize);
    // The bank edge of the triangle between bridges k and k + 1.
    let bank = |k: usize| -> Option<DVec3> {
        if !strip.closed && k + 1 == count {
            return None;
        }
        let ([i, j], [next, _]) = (bridge_at(k), bridge_at(k + 1));
        let (i, j) = (i % strip.m(), j % strip.n());
        // A step by P changes the first index (by one, or back to 0); round an apex all steps are by Q or all by P.
        let by_p = if strip.m() == 1 { false } else { strip.n() == 1 || next % strip.m() != i };
        Some(if by_p { strip.p.bank(i, 1, strip.closed) } else { strip.q.bank(j, 1, strip.closed) })
    };
    let mut statistics = Statistics {
        triangles: strip.triangles(),
        bridges: count,
        shortest_bridge: f64::INFINITY,
        ..Statistics::default()
    };
    let (mut largest_fold, mut largest_concave_fold) = (Angle::ZERO, Angle::ZERO);
    let mut variation = [0.0; 2];
    let (mut concave_bending, mut concave_curvature) = (0.0, 0.0);
    let (mut first_curvature, mut first_is_convex) = (Vector::zero(), true);
    let mut last_curvature = Vector::<f64>::zero();
    let mut before = if strip.closed { bank(count - 1) } else { None };
    for k in 0..count {
        let at = bridge_at(k);
        let [i, j] = [at[0] % strip.m(), at[1] % strip.n()];
        let vector = strip.bridge(at);
        let (bridge, squared) = (Vector::<f64>::from(vector), vector.length_squared());
        let convex = is_convex(strip, at, test);
        statistics.convex_bridges += usize::from(convex);
        statistics.shortest_bridge = statistics.shortest_bridge.min(vector.length());
        statistics.longest_bridge = statistics.longest_bridge.max(vector.length());
        let tangents = [tangents_p[i].into(), tangents_q[j].into()];
        statistics.total_normal_twist += weight::twist(bridge, tangents[0], tangents[1]);
        if strip.has_normals() {
            for (sum, sign) in variation.iter_mut().zip([1.0, -1.0]) {
                let normals = [(strip.p.normals[i] * sign).into(), (strip.q.normals[j] * sign).into()];
                *sum += weight::normal_variation(bridge, tangents, normals);
            }
        }
        let after = bank(k);
        let wing = |bank: Option<DVec3>| {
            bank.map(|bank| Wing::new(Vector::<f64>::from(bank), bank.length_squared(), bridge, squared))
        };
        let (left, right) = (wing(before), wing(after));
        if let Some(right) = &right {
            statistics.area += 0.5 * right.length;
        }
        let mut curvature = Vector::zero();
        if let (Some(left), Some(right)) = (&left, &right)
            && left.sound
            && right.sound
        {
            let energy = weight::bending(squared, left, right);
            statistics.bending_energy += energy;
            curvature = weight::mean_curvature(
                (weight::curvature_part(bridge, left), left.sound),
                (weight::curvature_part(bridge, right), right.sound),
            );
            let cross = left.normal.cross(right.normal);
            let fold = Angle { sine: cross.dot(cross).sqrt(), cosine: left.normal.dot(right.normal) };
            largest_fold = largest_fold.max(fold);
            if !convex {
                concave_bending += energy;
                largest_concave_fold = largest_concave_fold.max(fold);
            }
        }
        if k == 0 {
            (first_curvature, first_is_convex) = (curvature, convex);
        } else {
            let step = weight::curvature_step(last_curvature, curvature);
            statistics.mean_curvature_variation += step;
            concave_curvature += if convex { 0.0 } else { step };
        }
        (last_curvature, before) = (curvature, after);
        if k % 4096 == 4095 {
            execution.look(4096 * 16)?;
        }
    }
    if strip.closed {
        let step = weight::curvature_step(last_curvature, first_curvature);
        statistics.mean_curvature_variation += step;
        concave_curvature += if first_is_convex { 0.0 } else { step };
    }
    statistics.largest_fold = largest_fold.radians();
    statistics.developability_deviation = largest_concave_fold.radians();
    let unit = strip.unit;
    statistics.area *= unit * unit;
    statistics.mean_curvature_variation *= unit;
    statistics.shortest_bridge *= unit;
    statistics.longest_bridge *= unit;
    statistics.convex_bridge_ratio = statistics.convex_bridges as f64 / count as f64;
    Ok(Evaluation {
        statistics,
        normal_variation: strip.has_normals().then_some(variation),
        concave_bending,
        concave_curvature: concave_curvature * unit,
    })
}
