//! The formulas of all objectives, over [`Lanes`]. The sweeps and the statistics call the same functions.
//!
//! The formulas use a bridge e = q_j - p_i and the bank edges that meet it. A bridge can belong to four triangles. Each
//! has a bank edge b and the area vector b × e, whose length is twice the area. The bank edges are p_i - p_{i-1}
//! (arriving by a P-step), p_{i+1} - p_i (leaving by a P-step), q_j - q_{j-1} (arriving by a Q-step) and q_{j+1} - q_j
//! (leaving by a Q-step). Coordinates are those of [`Rails`](super::rails::Rails): centred, the largest about 1.

use super::lanes::{Lanes, Vector};

/// The bending energy at folds beyond 90°.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum BendingLaw {
    /// It grows with the angle up to 180°: 2 - sin²θ beyond 90°.
    #[default]
    Monotone,
    /// sin²θ, as Wang and Tang print it. A fold of 180° then costs nothing.
    Paper,
}

impl BendingLaw {
    /// The scalar product of the normals below which a fold counts as obtuse. No product is below -∞, so that the law
    /// of the paper needs no further instruction.
    #[inline(always)]
    fn obtuse_below(self) -> f64 {
        match self {
            Self::Monotone => 0.0,
            Self::Paper => f64::NEG_INFINITY,
        }
    }
}

/// Square of the sine below which a cross product counts as zero: |u × v| <= 1e-14 |u| |v|, about fifty units of
/// rounding. Triangles above it still have a normal.
const DEGENERATE_SQUARED: f64 = 1e-28;
/// Squared double area below which a triangle also counts as degenerate, where coordinates are about 1. The bound keeps
/// every quotient of the formulas from overflow and underflow.
const TINY: f64 = 1e-140;

/// A triangle at a bridge.
#[derive(Clone, Copy)]
pub(crate) struct BridgeTriangle<V: Lanes> {
    pub(crate) bank: Vector<V>,
    /// b × e: a vector along the triangle's normal whose length is twice the triangle's area.
    pub(crate) normal: Vector<V>,
    pub(crate) squared: V,
    pub(crate) length: V,
    /// Whether the triangle is not degenerate.
    pub(crate) sound: V::Mask,
}

impl<V: Lanes> BridgeTriangle<V> {
    #[inline(always)]
    pub(crate) fn new(bank: Vector<V>, bank_squared: V, bridge: Vector<V>, bridge_squared: V) -> Self {
        let normal = bank.cross(bridge);
        let squared = normal.dot(normal);
        let bound = squared.constant(DEGENERATE_SQUARED) * bank_squared * bridge_squared + squared.constant(TINY);
        Self { bank, normal, squared, length: squared.sqrt(), sound: bound.less(squared) }
    }

    #[inline(always)]
    pub(crate) fn select(mask: V::Mask, yes: &Self, no: &Self) -> Self {
        let taken = V::bits(mask);
        Self {
            bank: Vector::select(mask, yes.bank, no.bank),
            normal: Vector::select(mask, yes.normal, no.normal),
            squared: V::select(mask, yes.squared, no.squared),
            length: V::select(mask, yes.length, no.length),
            sound: V::from_bits(yes.length.simd(), taken & V::bits(yes.sound) | !taken & V::bits(no.sound)),
        }
    }
}

/// `minimal_area` (section 3.1): twice the area of the triangle of a bank edge and a bridge that share a point.
#[inline(always)]
pub(crate) fn double_area<V: Lanes>(bank: Vector<V>, bridge: Vector<V>) -> V {
    let normal = bank.cross(bridge);
    normal.dot(normal).sqrt()
}

/// `minimal_twist` (definition 5): 1 - n_p·n_q with n_p = unit(e × t_p), n_q = unit(e × t_q) (eq. 4); t_p and t_q have
/// length 1 or 0. The twist is 1 where a cross product vanishes.
#[inline(always)]
pub(crate) fn twist<V: Lanes>(bridge: Vector<V>, tangent_p: Vector<V>, tangent_q: Vector<V>) -> V {
    let squared = bridge.dot(bridge);
    let bound = squared.constant(DEGENERATE_SQUARED) * squared + squared.constant(TINY);
    let (a, b) = (bridge.cross(tangent_p), bridge.cross(tangent_q));
    let (aa, bb) = (a.dot(a), b.dot(b));
    let one = aa.constant(1.0);
    V::select(bound.less(aa) & bound.less(bb), one - a.dot(b) / (aa * bb).sqrt(), one)
}

/// `minimal_normal_variation` (eq. 11): (1 - n_p·n̄_p) + (1 - n_q·n̄_q) with n_p = unit(t_p × e), as the triangles of a
/// strip are wound, and the given normals n̄_p and n̄_q. A term whose cross product vanishes counts 1.
#[inline(always)]
pub(crate) fn normal_variation<V: Lanes>(bridge: Vector<V>, tangents: [Vector<V>; 2], normals: [Vector<V>; 2]) -> V {
    let squared = bridge.dot(bridge);
    let bound = squared.constant(DEGENERATE_SQUARED) * squared + squared.constant(TINY);
    half_variation(bridge, bound, tangents[0], normals[0]) + half_variation(bridge, bound, tangents[1], normals[1])
}

#[inline(always)]
fn half_variation<V: Lanes>(bridge: Vector<V>, bound: V, tangent: Vector<V>, given: Vector<V>) -> V {
    let normal = tangent.cross(bridge);
    let squared = normal.dot(normal);
    let one = squared.constant(1.0);
    V::select(bound.less(squared), one - normal.dot(given) / squared.sqrt(), one)
}

/// `minimal_bending_energy` (eq. 6, K = 1): A s(θ) / L², where A is the area of both triangles and L = 2A/|e|. The
/// energy is therefore |e|² s / (4A). s is sin²θ for θ up to 90°; beyond, it is 2 - sin²θ, or sin²θ by the law of the
/// paper. The identity |N_l × N_r| = |e| |N_l·b_r| gives sin²θ without an angle. The energy is 0 where a triangle is
/// degenerate.
#[inline(always)]
pub(crate) fn bending<V: Lanes>(
    law: BendingLaw,
    bridge_squared: V,
    left: &BridgeTriangle<V>,
    right: &BridgeTriangle<V>,
) -> V {
    let (zero, two) = (bridge_squared.constant(0.0), bridge_squared.constant(2.0));
    let height = left.normal.dot(right.bank);
    let both = left.squared * right.squared;
    let sine = bridge_squared * (height * height);
    let obtuse = left.normal.dot(right.normal).less(bridge_squared.constant(law.obtuse_below()));
    let share = V::select(obtuse, two * both - sine, sine);
    let energy = bridge_squared * share / (both * (two * (left.length + right.length)));
    V::select(left.sound & right.sound, energy, zero)
}

/// Whether two triangles at a bridge are plane neighbours up to `rounding`, the largest distance by which rounding of
/// the input moves a coordinate. A corner that moves by r turns a triangle by r over its altitude, so r (|N_l| + |N_r|)
/// bounds the change of the volume N_l·b_r that the two triangles span. The factor 4 leaves room for all four corners.
#[inline(always)]
pub(crate) fn is_flat<V: Lanes>(left: &BridgeTriangle<V>, right: &BridgeTriangle<V>, rounding: V) -> V::Mask {
    let zero = rounding.constant(0.0);
    let height = left.normal.dot(right.bank);
    let bound = rounding.constant(4.0) * rounding * (left.length + right.length);
    (zero - bound).at_most(height) & height.at_most(bound) & zero.at_most(left.normal.dot(right.normal))
}

/// A triangle's part of the mean curvature vector: e × n with the triangle's unit normal n.
#[inline(always)]
pub(crate) fn curvature_part<V: Lanes>(bridge: Vector<V>, triangle: &BridgeTriangle<V>) -> Vector<V> {
    bridge.cross(triangle.normal).times(triangle.length.constant(1.0) / triangle.length)
}

/// The mean curvature vector (eq. 8): H_e = 2|e| sin(φ/2) n_e = e × (n_left - n_right), from the two triangles' parts.
/// The vector is 0 where a triangle is degenerate.
#[inline(always)]
pub(crate) fn mean_curvature<V: Lanes>(left: (Vector<V>, V::Mask), right: (Vector<V>, V::Mask)) -> Vector<V> {
    Vector::select(left.1 & right.1, left.0.minus(right.0), Vector::zero(left.0.x.simd()))
}

/// `minimal_mean_curvature_variation` (eq. 9): ‖H_k - H_{k+1}‖.
#[inline(always)]
pub(crate) fn curvature_step<V: Lanes>(from: Vector<V>, to: Vector<V>) -> V {
    let jump = from.minus(to);
    jump.dot(jump).sqrt()
}
