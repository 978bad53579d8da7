//! Measures the figures of one strip between two directrices from its bridges. The formulas are those of DEFINITIONS,
//! implemented independently of the solver.

use super::figure::{Largest, Least, Measured, RELATIVE, Sum};
use plateau_mesh::DVec3;
use plateau_ruled_surface::BendingLaw;

/// A cross product below this fraction of the product of the lengths counts as zero.
const PARALLEL: f64 = 1e-14;
/// Rounding may decide whether a cross product counts if it lies between 1 / `UNDECIDED` and `UNDECIDED` times the
/// limit [`PARALLEL`].
const UNDECIDED: f64 = 100.0;
/// Tolerance for the angles in the test of local convexity, in radians.
const CONVEXITY: f64 = 1e-9;

/// Side of a strip: the vertices of a directrix in the order in which the strip runs along it.
#[derive(Clone, Debug)]
pub(crate) struct Rail<'a> {
    pub vertices: &'a [u32],
    /// Given unit tangents. Empty if the tangents are computed from the points.
    pub tangents: Vec<DVec3>,
    /// Given unit normals of the surface to be blended. Empty if there are none.
    pub normals: Vec<DVec3>,
}

/// A strip of a result. Bridges are pairs of positions on the two rails.
#[derive(Clone, Debug)]
pub(crate) struct Strip<'a> {
    pub at: &'a [DVec3],
    pub rails: [Rail<'a>; 2],
    pub closed: bool,
    pub bridges: Vec<[usize; 2]>,
    /// Tolerance of local convexity, in radians.
    pub convexity_tolerance: f64,
    /// The bending energy at folds beyond 90°.
    pub bending: BendingLaw,
    /// Assumed rounding error of a coordinate.
    pub step: f64,
}

/// The measured figures of a strip. Angles are in radians.
#[derive(Clone, Debug)]
pub(crate) struct Figures {
    pub area: Sum,
    pub twist: Sum,
    /// Number of bridges that certainly are locally convex, and of those that are if rounding favours them.
    pub convex: [usize; 2],
    pub bending: Sum,
    pub curvature_variation: Sum,
    /// The normal variation of the strip as it is wound, and that of the strip wound the other way round.
    pub normal_variation: Option<[Sum; 2]>,
    pub fold: Largest,
    pub concave_fold: [Largest; 2],
    /// For each bridge whether it certainly is locally convex, and whether it is if rounding favours it.
    pub convexity: Vec<[bool; 2]>,
    /// The folds in order of the bridges. The two ends of an open strip have none.
    folds: Vec<Fold>,
    pub shortest: Least,
    pub longest: Largest,
    /// Bending energy of the bridges that certainly are not convex, and of those that may not be convex. The next field
    /// has the curvature variation of the same two sets.
    pub concave_bending: [Sum; 2],
    pub concave_curvature: [Sum; 2],
}

/// A vector, and the distance by which rounding may move it.
type Rounded = (DVec3, f64);

/// The chords and the tangent at a point of a directrix.
struct Chords {
    /// The chords to the point before and to the point after. `None` where there is no such point.
    to: [Option<DVec3>; 2],
    /// The lengths of both chords. Infinite for a missing chord.
    lengths: [f64; 2],
    /// Unit tangent of the directrix.
    tangent: DVec3,
    /// Reciprocal of the length of the shorter chord.
    steepness: f64,
}

/// Returns the unit tangent at a point of a polyline. The polyline is replaced by the quadratic through the point and
/// its two neighbours, parametrised by chord length (Wang-Tang, eq. 13 and 14). At an end of the polyline the tangent
/// has the direction of the only chord.
fn fitted_tangent(before: Option<DVec3>, after: Option<DVec3>, [a, b]: [f64; 2]) -> DVec3 {
    let tangent = match (before.map(|chord| -chord), after) {
        (Some(before), Some(after)) if a == 0.0 || b == 0.0 => before + after,
        // The derivative times a b (a + b), which does not change its direction.
        (Some(before), Some(after)) => before * (b * b) + after * (a * a),
        (Some(chord), None) | (None, Some(chord)) => chord,
        (None, None) => DVec3::ZERO,
    };
    tangent.normalize_or_zero()
}

/// Margin in radians. Folds that are smaller than the largest one by more than twice this margin are not measured.
/// Folds whose tolerance is larger than the margin are always measured.
const MARGIN: f64 = 1e-6;

/// The fold at a bridge.
#[derive(Clone, Debug)]
struct Fold {
    cosine: f64,
    sine_squared: f64,
    tolerance: f64,
    /// Whether the fold counts for the largest of all folds, for the largest at bridges that certainly are not convex,
    /// and for the largest at bridges that may not be convex.
    counts: [bool; 3],
}

impl Fold {
    fn angle(&self) -> f64 {
        libm::atan2(self.sine_squared.sqrt(), self.cosine)
    }
}

/// Returns the largest of the folds whose `counts[which]` is set. Only folds near the one with the least cosine are
/// measured, because an arc tangent takes as long as the rest of a fold.
fn largest_fold(folds: &[Fold], which: usize) -> Largest {
    let counted = || folds.iter().filter(|fold| fold.counts[which]);
    let known = counted().filter(|fold| fold.tolerance < MARGIN);
    let widest = known.min_by(|a, b| a.cosine.total_cmp(&b.cosine)).map_or(0.0, Fold::angle);
    // A rounding error of a cosine changes the angle by far less than the margin, even near 0° and 180°.
    let limit = libm::cos((widest - 2.0 * MARGIN).max(0.0)) + 4.0 * f64::EPSILON;
    let mut largest = Largest::NONE;
    for fold in counted().filter(|fold| fold.cosine <= limit || fold.tolerance >= MARGIN) {
        largest.add(fold.angle(), fold.tolerance);
    }
    largest
}

/// Returns the unit vector of the cross product of a vector `a` of known length and a unit vector, or zero if the
/// product counts as zero. The second value is the angle by which rounding of the coordinates by `step` turns it. The
/// third value tells whether rounding may decide if the product counts as zero.
fn unit_cross((a, length): (DVec3, f64), unit: DVec3, step: f64) -> (DVec3, f64, bool) {
    let cross = a.cross(unit);
    let across = cross.length();
    let is_certain = across > PARALLEL / UNDECIDED * length;
    if !is_certain {
        return (DVec3::ZERO, 0.0, false);
    }
    let inverse = 1.0 / across;
    let turn = (2.0 * step + 4.0 * f64::EPSILON * length) * inverse;
    (
        if across > PARALLEL * length { cross * inverse } else { DVec3::ZERO },
        turn,
        across < PARALLEL * UNDECIDED * length,
    )
}

/// A triangle between two bridges.
struct Facet {
    normal: DVec3,
    double_area: f64,
    /// The angle by which rounding of a corner turns its normal.
    turn: f64,
    /// Whether the triangle has hardly any area, so that rounding decides about its normal.
    is_thin: bool,
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

    /// Returns the chords and the tangent at each point of a directrix.
    fn chords(&self, side: usize) -> Vec<Chords> {
        let with_length = |chord: Option<DVec3>| (chord, chord.map_or(f64::INFINITY, DVec3::length));
        // Each chord is computed once, as the chord to the next point, and is then the reversed chord to the point
        // before.
        let mut last = with_length(self.neighbour(side, 0, false).map(|other| other - self.point(side, 0)));
        let chords_at = |index: usize| {
            let point = self.point(side, index);
            let (before, after) = (last, with_length(self.neighbour(side, index, true).map(|other| other - point)));
            last = (after.0.map(|chord| -chord), after.1);
            let lengths = [before.1, after.1];
            let fitted = || fitted_tangent(before.0, after.0, lengths);
            let tangent = self.rails[side].tangents.get(index).copied().unwrap_or_else(fitted);
            Chords { to: [before.0, after.0], lengths, tangent, steepness: 1.0 / before.1.min(after.1) }
        };
        (0..self.count(side)).map(chords_at).collect()
    }

    fn bridge(&self, [i, j]: [usize; 2]) -> DVec3 {
        self.point(1, j) - self.point(0, i)
    }

    /// Tests whether a bridge is locally convex: seen along the bridge, the directions to the neighbours of its ends
    /// must fit into a half-plane. Returns whether this certainly holds, and whether it holds if rounding favours it.
    /// `tolerance` is the sine of the angle by which the directions may be wider than a half-plane: twice the convexity
    /// tolerance, because the outermost directions on both sides may reach beyond the half-plane.
    fn convexity(&self, axis: DVec3, length: f64, ends: [&Chords; 2], tolerance: f64) -> [bool; 2] {
        if length <= self.step {
            // Rounding determines the direction of the bridge.
            return [false, true];
        }
        if let Some(clear) = self.clear_convexity(axis, length, ends, tolerance) {
            return [clear; 2];
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
                    // A neighbour so near to the bridge's line has a direction that rounding determines.
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
        // The sine of a sum of two angles is at most the sine of the first angle plus the second angle.
        let possible = fits(turns.map(|turn| tolerance + CONVEXITY + 2.0 * turn));
        let certain = possible && !undecided && fits(turns.map(|turn| tolerance - CONVEXITY - turn));
        [certain || count == 0 && !undecided, possible || count == 0]
    }

    /// Returns whether a bridge is locally convex, or `None` if rounding or the tolerance can change the answer. The
    /// triple product of two offsets and the bridge has the sign of the sine between the directions of the offsets,
    /// seen along the bridge.
    fn clear_convexity(&self, axis: DVec3, length: f64, ends: [&Chords; 2], tolerance: f64) -> Option<bool> {
        let (mut offsets, mut count, mut longest) = ([(DVec3::ZERO, 0.0); 4], 0, length);
        for end in ends {
            for (offset, offset_length) in end.to.iter().zip(end.lengths) {
                let Some(offset) = *offset else { continue };
                offsets[count] = (offset, offset_length);
                longest = longest.max(offset_length);
                count += 1;
            }
        }
        let slack = tolerance + CONVEXITY;
        let rounding = 2.0 * (self.step + 32.0 * f64::EPSILON * longest) * length;
        // Entry k tells whether no other direction is to the right of direction k.
        let mut is_rightmost = [true; 4];
        for k in 1..count {
            for other in 0..k {
                let ((a, a_length), (b, b_length)) = (offsets[k], offsets[other]);
                let triple = a.cross(b).dot(axis);
                // The sine is at least the triple product over the product of all three lengths. A direction turns by
                // at most its rounding over its distance from the bridge's line. That distance is at least the triple
                // product over the lengths of the other two vectors.
                let whole = a_length * b_length * length;
                let least = triple.abs() * whole * slack + rounding * a_length.max(b_length) * whole;
                let is_clear = triple * triple > least;
                if !is_clear {
                    return None;
                }
                is_rightmost[if triple < 0.0 { k } else { other }] = false;
            }
        }
        (count > 1).then(|| is_rightmost[..count].contains(&true))
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
            convexity: Vec::with_capacity(count),
            folds: Vec::new(),
            shortest: Least::NONE,
            longest: Largest::NONE,
            concave_bending: [Sum::default(); 2],
            concave_curvature: [Sum::default(); 2],
        };
        let steps = self.steps();
        let chords = [0, 1].map(|side| self.chords(side));
        let axis = |&bridge: &[usize; 2]| {
            let axis = self.bridge(bridge);
            (axis, axis.length())
        };
        let axes: Vec<(DVec3, f64)> = self.bridges.iter().map(axis).collect();
        let mut facets = Vec::with_capacity(steps);
        for k in 0..steps {
            let (facet, perimeter) = self.facet(k, &axes, &chords);
            figures.area.add(0.5 * facet.double_area, 0.5 * self.step * perimeter);
            facets.push(facet);
        }
        let tolerance_sine = libm::sin(2.0 * self.convexity_tolerance);
        let mut folds = Vec::with_capacity(count);
        // Curvature vectors of the previous bridge and of the first bridge, with their rounding.
        let (mut before, mut first): (Option<Rounded>, Option<(Rounded, [bool; 2])>) = (None, None);
        for (k, &bridge) in self.bridges.iter().enumerate() {
            let (axis, length) = axes[k];
            figures.shortest.add(length, RELATIVE * length + 2.0 * self.step);
            figures.longest.add(length, RELATIVE * length + 2.0 * self.step);
            let ends = [&chords[0][bridge[0]], &chords[1][bridge[1]]];
            let convex = self.convexity(axis, length, ends, tolerance_sine);
            figures.convexity.push(convex);
            figures.convex[0] += usize::from(convex[0]);
            figures.convex[1] += usize::from(convex[1]);
            self.add_twist(&mut figures, bridge, (axis, length), ends);
            let left = if k > 0 { Some(k - 1) } else { self.closed.then(|| count - 1) };
            let sides = left.zip(Some(k).filter(|&k| k < steps)).map(|(left, right)| [&facets[left], &facets[right]]);
            let curvature = match sides {
                Some(sides) => self.add_fold(&mut figures, &mut folds, (axis, length), sides, convex),
                None => (DVec3::ZERO, 0.0),
            };
            match before {
                Some(before) => figures.add_curvature(before, curvature, convex),
                None => first = Some((curvature, convex)),
            }
            before = Some(curvature);
        }
        if let (true, Some(last), Some((curvature, convex))) = (self.closed, before, first) {
            figures.add_curvature(last, curvature, convex);
        }
        figures.fold = largest_fold(&folds, 0);
        figures.concave_fold = [1, 2].map(|which| largest_fold(&folds, which));
        figures.folds = folds;
        figures
    }

    /// Returns the number of triangles.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.bridges.len() - usize::from(!self.closed)
    }

    /// Returns whether each step of the strip goes to the next point of one rail, and all steps together pass every
    /// point of both.
    #[must_use]
    pub fn follows_its_rails(&self) -> bool {
        let mut taken = [0; 2];
        for k in 0..self.steps() {
            let (now, next) = (self.bridges[k], self.bridges[(k + 1) % self.bridges.len()]);
            let side = usize::from(!self.steps_along_first(k));
            let count = self.count(side);
            let after = if self.closed { (now[side] + 1) % count } else { now[side] + 1 };
            if next[side] != after || next[1 - side] != now[1 - side] {
                return false;
            }
            taken[side] += 1;
        }
        let all = |side: usize| match self.count(side) {
            1 => 0,
            count => count - usize::from(!self.closed),
        };
        taken == [all(0), all(1)] && (self.closed || self.bridges[0] == [0, 0])
    }

    /// Returns the triangle between bridge k and the next one, and its perimeter.
    fn facet(&self, k: usize, axes: &[(DVec3, f64)], chords: &[Vec<Chords>; 2]) -> (Facet, f64) {
        let ([i, j], along_first) = (self.bridges[k], self.steps_along_first(k));
        let from = if along_first { &chords[0][i] } else { &chords[1][j] };
        let (chord, chord_length) = (from.to[1].unwrap_or_default(), from.lengths[1]);
        let ((axis, length), (_, next)) = (axes[k], axes[(k + 1) % axes.len()]);
        // The normal agrees with the winding of the strip: from the bridge's first end along the chord to the other
        // end.
        let vector = chord.cross(axis);
        let double_area = vector.length();
        let longest = length.max(next).max(chord_length);
        let is_thin = double_area.is_nan() || double_area <= PARALLEL * UNDECIDED * longest * longest;
        let inverse = if double_area > 0.0 { 1.0 / double_area } else { 0.0 };
        let turn = if double_area > 0.0 { self.step * longest * inverse } else { f64::INFINITY };
        (Facet { normal: vector * inverse, double_area, turn, is_thin }, length + next + chord_length)
    }

    /// Adds the fold and the bending energy at a bridge between two triangles. Returns its curvature vector.
    fn add_fold(
        &self,
        figures: &mut Figures,
        folds: &mut Vec<Fold>,
        (axis, length): (DVec3, f64),
        [left, right]: [&Facet; 2],
        [certain, possible]: [bool; 2],
    ) -> Rounded {
        // If a triangle has hardly any area, rounding determines the fold.
        let thin = left.is_thin || right.is_thin;
        let (a, b) = (left.normal, right.normal);
        let (sine_squared, cosine) = (a.cross(b).length_squared(), a.dot(b));
        let turn = RELATIVE + left.turn + right.turn;
        let tolerance = if thin { f64::INFINITY } else { turn };
        folds.push(Fold { cosine, sine_squared, tolerance, counts: [true, !possible, !certain] });
        let is_monotone = self.bending == BendingLaw::Monotone;
        let strength = if is_monotone && cosine < 0.0 { 2.0 - sine_squared } else { sine_squared };
        let area = 0.5 * (left.double_area + right.double_area);
        // A / L² with L = 2 A / |e|. Times s(θ) this is the bending energy.
        let factor = length * length / (4.0 * area);
        let (term, error) = if !thin {
            let term = factor * strength;
            (term, (2.0 * factor + 4.0 * term) * turn.min(2.0))
        } else {
            (0.0, if area > 0.0 { 2.0 * factor } else { f64::INFINITY })
        };
        figures.bending.add(term, error);
        if !possible {
            figures.concave_bending[0].add(term, error);
        }
        if !certain {
            figures.concave_bending[1].add(term, error);
        }
        let curvature = if thin { DVec3::ZERO } else { axis.cross(a - b) };
        (curvature, length * if thin { 4.0 } else { 2.0 * turn.min(2.0) })
    }

    fn add_twist(&self, figures: &mut Figures, [i, j]: [usize; 2], axis: (DVec3, f64), ends: [&Chords; 2]) {
        let turned = |end: &Chords| {
            // The tangent turns by the rounding of the shorter chord.
            let (normal, turn, undecided) = unit_cross(axis, end.tangent, self.step);
            (normal, turn + turn * (axis.1 * end.steepness).min(1e6), undecided)
        };
        let ((p, a, unclear_p), (q, b, unclear_q)) = (turned(ends[0]), turned(ends[1]));
        let unclear = if unclear_p || unclear_q { 2.0 } else { 0.0 };
        figures.twist.add(1.0 - p.dot(q), (a + b).min(2.0) + unclear);
        let Some(sums) = &mut figures.normal_variation else { return };
        let (given_p, given_q) = (self.rails[0].normals[i], self.rails[1].normals[j]);
        // n_p is unit(t_p × e) for this winding, and the opposite for the other winding.
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

impl Figures {
    /// Returns the angle between the normals of the triangles on both sides of bridge k. At the end of an open strip it
    /// is 0.
    #[must_use]
    pub fn fold_at(&self, k: usize) -> Measured {
        let ends = self.convexity.len() - self.folds.len();
        let fold = k.checked_sub(ends / 2).and_then(|k| self.folds.get(k));
        let mut angle = Largest::NONE;
        fold.iter().for_each(|fold| angle.add(fold.angle(), fold.tolerance));
        angle.measured()
    }

    fn add_curvature(&mut self, (before, a): Rounded, (now, b): Rounded, [certain, possible]: [bool; 2]) {
        let (term, error) = ((now - before).length(), a + b);
        self.curvature_variation.add(term, error);
        if !possible {
            self.concave_curvature[0].add(term, error);
        }
        if !certain {
            self.concave_curvature[1].add(term, error);
        }
    }
}

/// Returns a figure that may lie anywhere between two sums, each with its own tolerance.
#[must_use]
pub(crate) fn between([least, most]: [Sum; 2]) -> Measured {
    let (least, most) = (least.measured(), most.measured());
    Measured { value: least.value, low: least.low, high: most.high }
}
