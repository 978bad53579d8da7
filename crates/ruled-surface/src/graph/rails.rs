//! The two directrices of a strip as the solver sees them: centred and scaled points, bank edges, tangents, normals.

use super::weight::BendingLaw;
use plateau_mesh::DVec3;
use plateau_mesh::measure::power_of_two_above;
use std::sync::OnceLock;

/// Two directrices, taken as given: nothing is merged or resampled.
///
/// Coordinates are first divided by a power of two, so that the largest is about 1. Then they are centred at p_0, or at
/// q_0 if Q is far smaller, and divided by a second power of two. Dividing by a power of two is exact, so areas and
/// lengths scale back exactly.
#[derive(Clone, Debug)]
pub(crate) struct Rails {
    pub(crate) closed: bool,
    pub(crate) p: Rail,
    pub(crate) q: Rail,
    /// Factor from the solver's unit to the caller's: a power of two.
    pub(crate) unit: f64,
    /// Largest distance by which rounding of the input moves a coordinate: the ulp of the largest |coordinate|, in the
    /// solver's unit.
    pub(crate) rounding: f64,
    pub(crate) bending: BendingLaw,
}

#[derive(Clone, Debug)]
pub(crate) struct Rail {
    pub(crate) points: Vec<DVec3>,
    /// The input divided by a power of two but not centred. These coordinates are exact, as the exact predicates
    /// require.
    pub(crate) raw: Vec<DVec3>,
    /// Unit tangents; a tangent that has no direction is zero. If the caller gives no tangents, they are fitted at the
    /// first use.
    tangents: OnceLock<Vec<DVec3>>,
    /// Unit normals; a normal that has no direction is zero. The list is empty if the caller gives no normals.
    pub(crate) normals: Vec<DVec3>,
}

/// A directrix as the caller gives it.
#[derive(Clone, Copy, Debug)]
pub struct Given<'a> {
    /// The points in order, in the caller's unit.
    pub points: &'a [DVec3],
    /// Tangents at the points. If absent, they are fitted (eq. 13 and 14).
    pub tangents: Option<&'a [DVec3]>,
    /// Surface normals at the points, of any length.
    pub normals: Option<&'a [DVec3]>,
}

impl<'a> From<&'a [DVec3]> for Given<'a> {
    fn from(points: &'a [DVec3]) -> Self {
        Self { points, tangents: None, normals: None }
    }
}

/// Q counts as far smaller than P if its extent is below this fraction of P's. Otherwise coordinates are relative to
/// p_0, even if Q is a little smaller.
const FAR_SMALLER: f64 = 1e-3;

impl Rails {
    pub(crate) fn new(p: Given<'_>, q: Given<'_>, closed: bool) -> Self {
        let largest = |sides: [&[DVec3]; 2], from: DVec3| {
            let reach = |points: &[DVec3]| points.iter().fold(DVec3::ZERO, |reach, &v| reach.max((v - from).abs()));
            reach(sides[0]).max(reach(sides[1])).max_element()
        };
        let outer = power_of_two_above(largest([p.points, q.points], DVec3::ZERO));
        // Multiplying by the inverse of a power of two gives the same bits as dividing by it.
        let raw = |points: &[DVec3]| points.iter().map(|&v| v * outer.recip()).collect::<Vec<_>>();
        let (raw_p, raw_q) = (raw(p.points), raw(q.points));
        // A tiny directrix keeps the digits of its edges if coordinates are relative to one of its own points.
        let [size_p, size_q] = [&raw_p, &raw_q].map(|raw| largest([raw, raw], raw[0]));
        let is_centred_on_q = size_q > 0.0 && size_q < FAR_SMALLER * size_p;
        let centre = if is_centred_on_q { raw_q[0] } else { raw_p[0] };
        let extent = largest([&raw_p, &raw_q], centre);
        let inner = power_of_two_above(extent);
        let largest_raw = largest([&raw_p, &raw_q], DVec3::ZERO);
        let side = |given: Given<'_>, raw: Vec<DVec3>| {
            let points: Vec<DVec3> = raw.iter().map(|&v| (v - centre) * inner.recip()).collect();
            let tangents = match given.tangents {
                Some(tangents) => OnceLock::from(tangents.iter().map(|t| unit(*t)).collect::<Vec<_>>()),
                None => OnceLock::new(),
            };
            let normals = given.normals.map(|n| n.iter().map(|n| unit(*n)).collect()).unwrap_or_default();
            Rail { points, raw, tangents, normals }
        };
        Self {
            closed,
            p: side(p, raw_p),
            q: side(q, raw_q),
            unit: outer * inner,
            rounding: (largest_raw.next_up() - largest_raw) / inner,
            bending: BendingLaw::default(),
        }
    }

    /// The same strip seen from the other side: P and Q change places.
    pub(crate) fn exchanged(&self) -> Self {
        Self { p: self.q.clone(), q: self.p.clone(), ..*self }
    }
    pub(crate) fn m(&self) -> usize {
        self.p.points.len()
    }
    pub(crate) fn n(&self) -> usize {
        self.q.points.len()
    }
    /// Whether a directrix is an apex: a single point.
    pub(crate) fn has_apex(&self) -> bool {
        self.m() == 1 || self.n() == 1
    }
    /// Number of triangles: m + n - 2 of an open strip, m + n of a closed one, or m + n - 1 of a closed one with an
    /// apex.
    pub(crate) fn triangles(&self) -> usize {
        match (self.closed, self.has_apex()) {
            (false, _) => self.m() + self.n() - 2,
            (true, false) => self.m() + self.n(),
            (true, true) => self.m() + self.n() - 1,
        }
    }
    pub(crate) fn has_normals(&self) -> bool {
        !self.p.normals.is_empty() && !self.q.normals.is_empty()
    }
    /// The triangles along a path. Vertices are numbered through P's points, then Q's.
    pub(crate) fn triangles_along(&self, path: &[[u32; 2]]) -> Vec<[u32; 3]> {
        let (m, n, count) = (self.m() as u32, self.n() as u32, path.len());
        let steps = if self.closed { count } else { count - 1 };
        (0..steps)
            .map(|k| {
                let ([i, j], [next, other]) = (path[k], path[(k + 1) % count]);
                let by_p = m > 1 && (n == 1 || next != i);
                if by_p { [i, next, m + j] } else { [i, m + other, m + j] }
            })
            .collect()
    }
    /// The corners of a triangle of [`triangles_along`](Self::triangles_along).
    pub(crate) fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| {
            let v = v as usize;
            if v < self.m() { self.p.points[v] } else { self.q.points[v - self.m()] }
        })
    }
    /// The bridge's vector, q_j - p_i; indices are cyclic on closed strips.
    pub(crate) fn bridge(&self, [i, j]: [usize; 2]) -> DVec3 {
        self.q.points[j % self.n()] - self.p.points[i % self.m()]
    }
}

impl Rail {
    pub(crate) fn tangents(&self, closed: bool) -> &[DVec3] {
        self.tangents.get_or_init(|| fitted_tangents(&self.points, closed))
    }
    /// The bank edge that ends (`step` 0) or starts (`step` 1) at a point; zero if there is none.
    pub(crate) fn bank(&self, index: usize, step: usize, closed: bool) -> DVec3 {
        bank_edge(&self.points, index, step, closed)
    }
    pub(crate) fn neighbour(&self, index: usize, before: bool, closed: bool) -> Option<usize> {
        let count = self.points.len();
        match (before, closed && count > 1) {
            (true, true) => Some((index + count - 1) % count),
            (false, true) => Some((index + 1) % count),
            (true, false) => index.checked_sub(1),
            (false, false) => Some(index + 1).filter(|&k| k < count),
        }
    }
}

fn bank_edge(points: &[DVec3], index: usize, step: usize, closed: bool) -> DVec3 {
    let count = points.len();
    let end = index + step;
    if closed && count > 1 {
        points[end % count] - points[(end + count - 1) % count]
    } else if end == 0 || end >= count {
        DVec3::ZERO
    } else {
        points[end] - points[end - 1]
    }
}

fn unit(v: DVec3) -> DVec3 {
    let largest = v.abs().max_element();
    // A power of two scales without rounding.
    if largest == 0.0 { DVec3::ZERO } else { (v * power_of_two_above(largest).recip()).normalize() }
}

/// Returns the unit tangents by eq. 13 and 14: the derivative, at the middle point, of the quadratic through three
/// consecutive points, whose parameter is the chord length. With the edges a and b, the middle point has the parameter
/// α = |a|/(|a|+|b|), or 1/2 if a neighbour coincides with it. The tangent at an open end is the direction of the only
/// edge there.
fn fitted_tangents(points: &[DVec3], closed: bool) -> Vec<DVec3> {
    (0..points.len())
        .map(|k| {
            let (before, after) = (bank_edge(points, k, 0, closed), bank_edge(points, k, 1, closed));
            if !closed && (k == 0 || k + 1 == points.len()) {
                return unit(before + after);
            }
            let (a, b) = (before.length(), after.length());
            let alpha = if a == 0.0 || b == 0.0 { 0.5 } else { a / (a + b) };
            unit(before * ((1.0 - alpha) / alpha) + after * (alpha / (1.0 - alpha)))
        })
        .collect()
}
