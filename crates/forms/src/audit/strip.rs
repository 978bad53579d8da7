//! The figures of one strip between two directrices, from its bridges: the formulas of DEFINITIONS, each written anew.

use super::figure::{Largest, Least, Measured, RELATIVE, Sum};
use super::surface::{Sides, corners};
use plateau_mesh::DVec3;

/// A cross product below this fraction of the product of the lengths counts as zero.
const PARALLEL: f64 = 1e-14;
/// Cross products from the reciprocal of this to this multiple of [`PARALLEL`] may count or not, as rounding decides.
const UNDECIDED: f64 = 100.0;
/// Angle in radians by which a convexity tolerance may be missed.
const CONVEXITY: f64 = 1e-9;

/// Side of a strip: the vertices of a directrix in the order in which the strip runs along it.
#[derive(Clone, Debug)]
pub(crate) struct Rail<'a> {
    pub vertices: &'a [u32],
    /// Unit tangents, or empty if they follow from the points.
    pub tangents: Vec<DVec3>,
    /// Unit normals of the surface to be blended, or empty.
    pub normals: Vec<DVec3>,
}

/// A strip as it leaves. Bridges are pairs of positions on the two rails.
#[derive(Clone, Debug)]
pub(crate) struct Strip<'a> {
    pub at: &'a [DVec3],
    pub rails: [Rail<'a>; 2],
    pub closed: bool,
    pub bridges: Vec<[usize; 2]>,
    /// Tolerance of local convexity, in radians.
    pub convexity_tolerance: f64,
    /// Rounding of a coordinate.
    pub step: f64,
}

/// The measured figures of a strip. Angles are in radians.
#[derive(Clone, Debug)]
pub(crate) struct Figures {
    pub area: Sum,
    pub twist: Sum,
    /// Bridges that certainly are locally convex, and those that are if rounding favours them.
    pub convex: [usize; 2],
    pub bending: Sum,
    pub curvature_variation: Sum,
    /// With the strip wound as it comes, and the other way round.
    pub normal_variation: Option<[Sum; 2]>,
    pub fold: Largest,
    pub concave_fold: [Largest; 2],
    pub shortest: Least,
    pub longest: Largest,
    /// Least and largest bending energy and curvature variation at bridges that are not convex.
    pub concave_bending: [Sum; 2],
    pub concave_curvature: [Sum; 2],
}

/// A vector and how far rounding moves it.
type Rounded = (DVec3, f64);

/// The chords at a point of a directrix.
struct Chords {
    /// To the point before and to the point after, where there is one.
    to: [Option<DVec3>; 2],
    /// Their lengths; infinite where there is none.
    lengths: [f64; 2],
    /// The directrix's direction.
    tangent: DVec3,
}

/// Returns the derivative at the middle of the quadratic through three neighbours, whose parameter is the length of the
/// chords (Wang-Tang, eq. 13 and 14), as a unit vector.
fn fitted_tangent(before: Option<DVec3>, after: Option<DVec3>, [a, b]: [f64; 2]) -> DVec3 {
    let tangent = match (before.map(|chord| -chord), after) {
        (Some(before), Some(after)) => {
            let alpha = if a == 0.0 || b == 0.0 { 0.5 } else { a / (a + b) };
            before * ((1.0 - alpha) / alpha) + after * (alpha / (1.0 - alpha))
        }
        (Some(chord), None) | (None, Some(chord)) => chord,
        (None, None) => DVec3::ZERO,
    };
    tangent.normalize_or_zero()
}

/// Passes over folds that are certainly not the largest ones, because an arc tangent takes as long as the rest of a
/// fold. There are three bounds: for all folds, for folds at bridges that are certainly not convex, and for folds at
/// bridges that may not be convex.
#[derive(Default)]
struct FoldFilter([Option<[f64; 2]>; 3]);

/// Margin of the filter in radians. Folds whose tolerance is larger are never passed over.
const MARGIN: f64 = 1e-6;

impl FoldFilter {
    /// Returns whether a fold with this sine and cosine may be larger than those that were reached.
    fn may_count(&self, counts: [bool; 3], [sine, cosine]: [f64; 2], tolerance: f64) -> bool {
        // Whether the angle is less than the bound: both lie between 0 and π.
        let is_below = |bound: &Option<[f64; 2]>| bound.is_some_and(|[s, c]| sine * c - cosine * s < 0.0);
        let certain = tolerance < MARGIN && sine * sine + cosine * cosine > 0.5;
        !certain || self.0.iter().zip(counts).any(|(bound, counts)| counts && !is_below(bound))
    }

    fn reached(&mut self, counts: [bool; 3], angle: f64) {
        let bound = angle - 2.0 * MARGIN;
        if bound <= 0.0 {
            return;
        }
        let (sine, cosine) = libm::sincos(bound);
        for (known, _) in self.0.iter_mut().zip(counts).filter(|(_, counts)| *counts) {
            let is_larger = known.is_none_or(|[s, c]| sine * c - cosine * s > 0.0);
            if is_larger {
                *known = Some([sine, cosine]);
            }
        }
    }
}

/// Returns the unit vector of a cross product, or zero if the product counts as zero. The third value says that
/// rounding decides about it.
fn unit_cross((a, length): (DVec3, f64), b: DVec3, step: f64) -> (DVec3, f64, bool) {
    let (cross, other) = (a.cross(b), b.length());
    let across = cross.length();
    let sine = across / (length * other);
    if sine.is_nan() || sine <= PARALLEL / UNDECIDED {
        return (DVec3::ZERO, 0.0, false);
    }
    let shortest = length.min(other);
    let turn = 2.0 * step / (shortest * sine) + 4.0 * f64::EPSILON / sine;
    (if sine > PARALLEL { cross / across } else { DVec3::ZERO }, turn, sine < PARALLEL * UNDECIDED)
}

fn is_thin(sides: &Sides) -> bool {
    sides.altitude().is_nan() || sides.altitude() <= PARALLEL * UNDECIDED * sides.longest
}

impl Strip<'_> {
    fn count(&self, side: usize) -> usize {
        self.rails[side].vertices.len()
    }

    fn point(&self, side: usize, index: usize) -> DVec3 {
        self.at[self.rails[side].vertices[index] as usize]
    }

    fn neighbour(&self, side: usize, index: usize, forward: bool) -> Option<DVec3> {
        let count = self.count(side);
        let next = match (forward, self.closed) {
            _ if count == 1 => return None,
            (true, true) => (index + 1) % count,
            (false, true) => (index + count - 1) % count,
            (true, false) => index + 1,
            (false, false) => index.checked_sub(1)?,
        };
        (next < count).then(|| self.point(side, next))
    }

    /// Returns the chords at each point of a directrix, and its direction there.
    fn chords(&self, side: usize) -> Vec<Chords> {
        let of = |index: usize| {
            let point = self.point(side, index);
            let before = self.neighbour(side, index, false).map(|other| other - point);
            let after = self.neighbour(side, index, true).map(|other| other - point);
            let lengths = [before, after].map(|chord| chord.map_or(f64::INFINITY, DVec3::length));
            let fitted = || fitted_tangent(before, after, lengths);
            let tangent = self.rails[side].tangents.get(index).copied().unwrap_or_else(fitted);
            Chords { to: [before, after], lengths, tangent }
        };
        (0..self.count(side)).map(of).collect()
    }

    fn bridge(&self, [i, j]: [usize; 2]) -> DVec3 {
        self.point(1, j) - self.point(0, i)
    }

    /// Returns whether a bridge certainly is locally convex, and whether it is if rounding favours it: seen along the
    /// bridge the directions to the neighbours of its ends fit into a half-plane. `tolerance` is the sine of the
    /// tolerance.
    fn convexity(&self, axis: DVec3, length: f64, ends: [&Chords; 2], tolerance: f64) -> [bool; 2] {
        if length == 0.0 {
            return [false, true];
        }
        let axis = axis / length;
        let (mut directions, mut turns, mut count) = ([DVec3::ZERO; 4], [0.0f64; 4], 0);
        let mut undecided = false;
        for end in ends {
            for (offset, offset_length) in end.to.iter().zip(end.lengths) {
                let Some(offset) = *offset else { continue };
                let across = offset - offset.dot(axis) * axis;
                let distance = across.length();
                if distance <= self.step {
                    // A neighbour this near to the bridge's line has no direction, or any.
                    undecided |= distance > 0.0;
                    continue;
                }
                directions[count] = across / distance;
                turns[count] = (self.step + 16.0 * f64::EPSILON * (offset_length + length)) / distance;
                count += 1;
            }
        }
        let mut sines = [[0.0f64; 4]; 4];
        for k in 1..count {
            for other in 0..k {
                let sine = directions[k].cross(directions[other]).dot(axis);
                (sines[k][other], sines[other][k]) = (sine, -sine);
            }
        }
        let fits = |slack: [f64; 4]| {
            (0..count).any(|k| {
                // Whether all directions are to the left of direction k, or on its right by no more than the slack.
                (0..count).all(|other| sines[k][other] >= -slack[k].max(slack[other]) || other == k)
            })
        };
        // The sine of a sum of two angles is at most the sine of the first plus the second.
        let possible = fits(turns.map(|turn| tolerance + CONVEXITY + 2.0 * turn));
        let certain = possible && !undecided && fits(turns.map(|turn| tolerance - CONVEXITY - turn));
        [certain || count == 0, possible || count == 0]
    }

    /// Measures the strip. O(bridges).
    #[must_use]
    pub fn figures(&self) -> Figures {
        let count = self.bridges.len();
        let has_normals = self.rails.iter().all(|rail| !rail.normals.is_empty());
        let mut figures = Figures {
            area: Sum::default(),
            twist: Sum::default(),
            convex: [0; 2],
            bending: Sum::default(),
            curvature_variation: Sum::default(),
            normal_variation: has_normals.then(|| [Sum::default(); 2]),
            fold: Largest::NONE,
            concave_fold: [Largest::NONE; 2],
            shortest: Least::NONE,
            longest: Largest::NONE,
            concave_bending: [Sum::default(); 2],
            concave_curvature: [Sum::default(); 2],
        };
        let steps = if self.closed { count } else { count - 1 };
        let triangles: Vec<Sides> = (0..steps).map(|k| Sides::of(corners(self.at, self.triangle(k)))).collect();
        for sides in &triangles {
            figures.area.add(0.5 * sides.double_area, 0.5 * self.step * sides.perimeter);
        }
        let mut curvatures: Vec<Rounded> = Vec::with_capacity(count);
        let mut convexities = Vec::with_capacity(count);
        let chords = [0, 1].map(|side| self.chords(side));
        let tolerance_sine = libm::sin(self.convexity_tolerance);
        let mut folds = FoldFilter::default();
        for (k, &bridge) in self.bridges.iter().enumerate() {
            let axis = self.bridge(bridge);
            let length = axis.length();
            figures.shortest.add(length, RELATIVE * length + 2.0 * self.step);
            figures.longest.add(length, RELATIVE * length + 2.0 * self.step);
            let ends = [&chords[0][bridge[0]], &chords[1][bridge[1]]];
            let [certain, possible] = self.convexity(axis, length, ends, tolerance_sine);
            convexities.push([certain, possible]);
            figures.convex[0] += usize::from(certain);
            figures.convex[1] += usize::from(possible);
            self.add_twist(&mut figures, bridge, (axis, length), ends);
            let left = if k > 0 { Some(k - 1) } else { self.closed.then(|| count - 1) };
            let right = Some(k).filter(|&k| k < steps);
            let Some((left, right)) = left.zip(right) else {
                curvatures.push((DVec3::ZERO, 0.0));
                continue;
            };
            let (left, right) = (&triangles[left], &triangles[right]);
            // Where a triangle has hardly any area, rounding decides whether the fold counts.
            let thin = is_thin(left) || is_thin(right);
            let (a, b) = (left.double_area_vector.normalize_or_zero(), right.double_area_vector.normalize_or_zero());
            let (sine, cosine) = (a.cross(b).length(), a.dot(b));
            let turn = RELATIVE + self.step / left.altitude() + self.step / right.altitude();
            let tolerance = if thin { f64::INFINITY } else { turn };
            let counts = [true, !possible, !certain];
            if folds.may_count(counts, [sine, cosine], tolerance) {
                let angle = libm::atan2(sine, cosine);
                let [least, most] = &mut figures.concave_fold;
                for (fold, counts) in [&mut figures.fold, least, most].into_iter().zip(counts) {
                    if counts {
                        fold.add(angle, tolerance);
                    }
                }
                if tolerance < MARGIN {
                    folds.reached(counts, angle);
                }
            }
            let squared = length * length;
            let strength = if cosine < 0.0 { 2.0 - sine * sine } else { sine * sine };
            let area = 0.5 * (left.double_area + right.double_area);
            // A s / L² with L = 2 A / |e|.
            let factor = squared / (4.0 * area);
            let (term, error) = if thin {
                (0.0, if area > 0.0 { 2.0 * factor } else { f64::INFINITY })
            } else {
                (factor * strength, 0.0)
            };
            let error = error + if thin { 0.0 } else { (2.0 * factor + 4.0 * term) * turn.min(2.0) };
            figures.bending.add(term, error);
            let curvature = if thin { DVec3::ZERO } else { axis.cross(a - b) };
            let rounding = length * if thin { 4.0 } else { 2.0 * turn.min(2.0) };
            curvatures.push((curvature, rounding));
            if !possible {
                figures.concave_bending[0].add(term, error);
            }
            if !certain {
                figures.concave_bending[1].add(term, error);
            }
        }
        let entered = |k: usize| curvatures[(k + count - 1) % count];
        for k in usize::from(!self.closed)..count {
            let ((before, a), (now, b)) = (entered(k), curvatures[k]);
            let (term, error) = ((now - before).length(), a + b);
            figures.curvature_variation.add(term, error);
            if !convexities[k][1] {
                figures.concave_curvature[0].add(term, error);
            }
            if !convexities[k][0] {
                figures.concave_curvature[1].add(term, error);
            }
        }
        figures
    }

    fn add_twist(&self, figures: &mut Figures, [i, j]: [usize; 2], axis: (DVec3, f64), ends: [&Chords; 2]) {
        let turned = |end: &Chords| {
            // The tangent's own rounding is that of its shorter chord.
            let (normal, turn, undecided) = unit_cross(axis, end.tangent, self.step);
            let chord = end.lengths[0].min(end.lengths[1]);
            (normal, turn + turn * (axis.1 / chord).min(1e6), undecided)
        };
        let ((p, a, unclear_p), (q, b, unclear_q)) = (turned(ends[0]), turned(ends[1]));
        let unclear = if unclear_p || unclear_q { 2.0 } else { 0.0 };
        figures.twist.add(1.0 - p.dot(q), (a + b).min(2.0) + unclear);
        let Some(sums) = &mut figures.normal_variation else { return };
        let (given_p, given_q) = (self.rails[0].normals[i], self.rails[1].normals[j]);
        // n_p is unit(t_p × e) for this winding, and the opposite for the other.
        for (sum, sign) in sums.iter_mut().zip([-1.0, 1.0]) {
            let terms = 2.0 - sign * p.dot(given_p) - sign * q.dot(given_q);
            sum.add(terms, (a + b).min(4.0) + unclear);
        }
    }

    /// Returns whether the step from bridge k to the next one runs along the first rail.
    fn steps_along_first(&self, k: usize) -> bool {
        let (now, next) = (self.bridges[k], self.bridges[(k + 1) % self.bridges.len()]);
        self.count(0) > 1 && (self.count(1) == 1 || now[0] != next[0])
    }

    /// Returns the triangle between bridge k and the next one, wound as the strip is.
    #[must_use]
    pub fn triangle(&self, k: usize) -> [u32; 3] {
        let [[i, j], [next, other]] = [self.bridges[k], self.bridges[(k + 1) % self.bridges.len()]];
        let vertex = |side: usize, index: usize| self.rails[side].vertices[index];
        let [p, q] = [vertex(0, i), vertex(1, j)];
        if self.steps_along_first(k) { [p, vertex(0, next), q] } else { [p, vertex(1, other), q] }
    }
}

/// Returns the figure that lies between the least and the largest of two sums.
#[must_use]
pub(crate) fn between([least, most]: [Sum; 2]) -> Measured {
    let (least, most) = (least.measured(), most.measured());
    Measured { value: least.value, low: least.low, high: most.high }
}
