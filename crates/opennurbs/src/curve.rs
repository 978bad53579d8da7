//! Curves, and their approximation by polylines within a tolerance.

use super::Defect;
use plateau_mesh::DVec3;
use std::f64::consts::FRAC_PI_4;

/// Largest number of times that a Bézier curve is halved. A piece is then a billionth of the curve. No tolerance that
/// makes sense in f64 needs smaller pieces.
const MAX_HALVINGS: u32 = 30;
/// Default tolerance as a fraction of the diagonal of the curve's box. A circle gets 60 chords if it is an arc, and 64
/// if it is a NURBS curve of four quarters.
const DEFAULT_TOLERANCE: f64 = 1.0 / 2000.0;

#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// Straight segments, at least one.
    Polyline(Vec<DVec3>),
    Arc(Arc),
    Nurbs(Nurbs),
    /// Curves in order, each of which begins where the one before ends.
    Poly(Vec<Curve>),
}

/// An arc of a circle, from the first to the second angle in radians.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    pub centre: DVec3,
    /// Unit vectors of the circle's plane.
    pub x: DVec3,
    pub y: DVec3,
    pub radius: f64,
    pub angles: [f64; 2],
}

/// A NURBS curve, as checked by [`Nurbs::new`].
#[derive(Clone, Debug, PartialEq)]
pub struct Nurbs {
    degree: usize,
    /// Knots without the first and the last, as openNURBS has them: points + degree - 1.
    knots: Vec<f64>,
    /// Homogeneous control points: the coordinates times the weight, and the weight.
    points: Vec<[f64; 4]>,
}

/// Collects the points of a polyline along a curve, of which there may be at most `max_points`.
struct Sampler {
    points: Vec<DVec3>,
    tolerance: f64,
    max_points: usize,
}

impl Curve {
    /// Returns points of the curve in order. No point of the curve is farther than `tolerance` from the polyline
    /// through them. Points of polylines are returned as they are. A closed curve repeats its first point.
    ///
    /// # Errors
    /// Returns [`Defect::TooLarge`] if more than `max_points` points are needed.
    pub fn points(&self, tolerance: f64, max_points: usize) -> Result<Vec<DVec3>, Defect> {
        let mut sampler = Sampler { points: Vec::new(), tolerance, max_points };
        sampler.curve(self)?;
        Ok(sampler.points)
    }

    /// Returns the tolerance for a client that names none: a two-thousandth of the diagonal of the curve's box.
    #[must_use]
    pub fn default_tolerance(&self) -> f64 {
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        self.for_each_bound(&mut |point| (low, high) = (low.min(point), high.max(point)));
        DEFAULT_TOLERANCE * (high - low).length()
    }

    /// Calls `see` with points whose box contains the curve. Only the box of an arc may be slightly too small, because
    /// nine points of the arc stand for it.
    fn for_each_bound(&self, see: &mut impl FnMut(DVec3)) {
        match self {
            Self::Polyline(points) => points.iter().for_each(|&point| see(point)),
            Self::Arc(arc) => arc.directions(8).for_each(|direction| see(arc.centre + arc.radius * direction)),
            Self::Nurbs(nurbs) => nurbs.points.iter().for_each(|&point| see(place(point))),
            Self::Poly(curves) => curves.iter().for_each(|curve| curve.for_each_bound(see)),
        }
    }
}

impl Arc {
    /// Returns unit vectors from the centre to `pieces` + 1 points of the arc.
    fn directions(&self, pieces: u32) -> impl Iterator<Item = DVec3> {
        let [from, to] = self.angles;
        (0..=pieces).map(move |number| {
            let angle = from + (to - from) * f64::from(number) / f64::from(pieces);
            libm::cos(angle) * self.x + libm::sin(angle) * self.y
        })
    }
}

impl Nurbs {
    /// Checks a NURBS curve. `knots` lacks the first and the last knot. The coordinates in `points` are multiplied by
    /// the weights.
    ///
    /// # Errors
    /// Returns [`Defect::Unusable`] if a number is not finite, a weight is not positive, or the knots decrease or leave
    /// no curve.
    pub fn new(degree: usize, knots: Vec<f64>, points: Vec<[f64; 4]>) -> Result<Self, Defect> {
        if !knots.iter().chain(points.iter().flatten()).all(|number| number.is_finite()) {
            return Err(Defect::Unusable("has a coordinate or a knot that is not a finite number"));
        }
        if !points.iter().all(|&[.., weight]| weight > 0.0) {
            return Err(Defect::Unusable("is a NURBS curve with a weight that is not positive"));
        }
        if !points.iter().all(|&point| place(point).is_finite()) {
            return Err(Defect::Unusable("has a coordinate that is not a finite number"));
        }
        let increase = knots.is_sorted() && knots[degree - 1] < knots[points.len() - 1];
        if !increase {
            return Err(Defect::Unusable("is a NURBS curve whose knots do not increase"));
        }
        Ok(Self { degree, knots, points })
    }

    /// Returns the control points of the Bézier curve between the knots `span` and `span` + 1.
    fn bezier(&self, span: usize) -> Vec<[f64; 4]> {
        let (from, to) = (self.knots[span], self.knots[span + 1]);
        let degree = self.degree;
        let first = span + 1 - degree;
        // The blossom of the curve at `degree - count` times `from` and `count` times `to`, by de Boor's algorithm.
        let blossom = |count: usize| {
            let mut row = self.points[first..=first + degree].to_vec();
            for round in 0..degree {
                let at = if round < count { to } else { from };
                for k in (round + 1..=degree).rev() {
                    let (left, right) = (self.knots[first + k - 1], self.knots[first + k + degree - round - 1]);
                    row[k] = between(row[k - 1], row[k], (at - left) / (right - left));
                }
            }
            row[degree]
        };
        (0..=degree).map(blossom).collect()
    }
}

/// Returns the point for homogeneous coordinates: the coordinates divided by their weight.
fn place([x, y, z, weight]: [f64; 4]) -> DVec3 {
    DVec3::new(x, y, z) / weight
}

fn between(a: [f64; 4], b: [f64; 4], fraction: f64) -> [f64; 4] {
    std::array::from_fn(|k| (1.0 - fraction) * a[k] + fraction * b[k])
}

impl Sampler {
    fn push(&mut self, point: DVec3) -> Result<(), Defect> {
        if self.points.len() == self.max_points {
            return Err(Defect::TooLarge(self.max_points));
        }
        self.points.push(point);
        Ok(())
    }

    fn curve(&mut self, curve: &Curve) -> Result<(), Defect> {
        match curve {
            Curve::Polyline(points) => points.iter().try_for_each(|&point| self.push(point)),
            Curve::Arc(arc) => self.arc(arc),
            Curve::Nurbs(nurbs) => self.nurbs(nurbs),
            Curve::Poly(curves) => {
                for (number, curve) in curves.iter().enumerate() {
                    // Each further curve begins at the last point so far. That point is removed, because the curve adds
                    // it again.
                    if number > 0 {
                        self.points.pop();
                    }
                    self.curve(curve)?;
                }
                Ok(())
            }
        }
    }

    /// Adds points at equal angles. The distance of a chord from its arc is r (1 - cos(angle / 2)). A whole circle gets
    /// at least eight chords.
    fn arc(&mut self, arc: &Arc) -> Result<(), Defect> {
        let angle = 2.0 * libm::acos(1.0 - (self.tolerance / arc.radius).min(1.0));
        let pieces = ((arc.angles[1] - arc.angles[0]) / angle.min(FRAC_PI_4)).ceil().max(1.0);
        if pieces >= self.max_points as f64 {
            return Err(Defect::TooLarge(self.max_points));
        }
        arc.directions(pieces as u32).try_for_each(|direction| self.push(arc.centre + arc.radius * direction))
    }

    fn nurbs(&mut self, nurbs: &Nurbs) -> Result<(), Defect> {
        let spans = nurbs.degree - 1..nurbs.points.len() - 1;
        let mut begun = false;
        for span in spans.filter(|&span| nurbs.knots[span] < nurbs.knots[span + 1]) {
            let mut pieces = vec![(nurbs.bezier(span), 0)];
            if !begun {
                self.push(place(pieces[0].0[0]))?;
                begun = true;
            }
            while let Some((piece, halvings)) = pieces.pop() {
                let (first, last) = (place(piece[0]), place(piece[nurbs.degree]));
                let chord = |point: &[f64; 4]| distance_to_segment(place(*point), first, last);
                let farthest = piece[1..nurbs.degree].iter().map(chord).fold(0.0, f64::max);
                let is_near = farthest * inner_share(&piece) <= self.tolerance;
                if halvings == MAX_HALVINGS || is_near {
                    self.push(last)?;
                } else {
                    let (left, right) = halved(piece);
                    pieces.push((right, halvings + 1));
                    pieces.push((left, halvings + 1));
                }
            }
        }
        Ok(())
    }
}

/// Returns the two halves of a Bézier curve, by de Casteljau's algorithm.
fn halved(mut row: Vec<[f64; 4]>) -> (Vec<[f64; 4]>, Vec<[f64; 4]>) {
    let degree = row.len() - 1;
    let mut left = vec![row[0]];
    for round in 1..=degree {
        for k in 0..=degree - round {
            row[k] = between(row[k], row[k + 1], 0.5);
        }
        left.push(row[0]);
    }
    (left, row)
}

/// Returns an upper bound of the share that the inner control points have together in any point of a Bézier curve. The
/// end points have the rest, and lie on the chord. The distance of the curve from its chord is therefore at most that
/// of the farthest control point times this bound.
fn inner_share(piece: &[[f64; 4]]) -> f64 {
    let degree = piece.len() - 1;
    let weight = |point: &[f64; 4]| point[3];
    let ends = weight(&piece[0]).min(weight(&piece[degree]));
    let inner = piece[1..degree].iter().map(weight).fold(0.0, f64::max);
    // With equal weights the share is 1 - (1 - t)^d - t^d, which is largest in the middle.
    let share = 1.0 - 2.0 * 0.5_f64.powi(degree as i32);
    inner * share / (ends * (1.0 - share) + inner * share)
}

fn distance_to_segment(point: DVec3, from: DVec3, to: DVec3) -> f64 {
    let along = to - from;
    let fraction = ((point - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    // A chord without a length gives NaN.
    let nearest = if fraction.is_nan() { from } else { from + fraction * along };
    point.distance(nearest)
}
