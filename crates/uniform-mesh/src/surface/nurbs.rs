//! Tensor-product NURBS patches. Bézier patches are the special case of one span and equal weights.
//!
//! Evaluation follows Piegl and Tiller, *The NURBS Book*: span by bisection (A2.1), basis functions and their first
//! derivatives from one triangular table (A2.2, A2.3), the quotient rule on homogeneous coordinates (eq. 4.20).

use plateau_mesh::error::{Error, InputError, Place, Step};
use plateau_mesh::polyline::LARGEST_COORDINATE;
use plateau_mesh::{DVec2, DVec3};

/// Largest degree that is accepted. Nobody draws with higher degrees, and evaluating their tables takes O(degree²).
const LARGEST_DEGREE: usize = 60;
/// Degrees below this are evaluated in small tables. Nearly all patches have such degrees.
const COMMON: usize = 8;

/// Number of cells along a parameter over which a patch's area is integrated, at least two for each knot span.
const AREA_CELLS: usize = 48;

/// A NURBS patch without trimming curves. Knot vectors may run over any interval; the parameters u, v here run over
/// \[0, 1\].
#[derive(Clone, Debug, PartialEq)]
pub struct Nurbs {
    /// Degree along u and along v.
    pub degrees: [usize; 2],
    /// Knots along u and along v, in non-decreasing order. Their number is the number of control points plus the degree
    /// plus one. An inner knot is repeated at most degree times. The patch covers the parameters from knot `degree` to
    /// the knot that has `degree` knots after it.
    pub knots: [Vec<f64>; 2],
    /// The control points `control_points[i][j]`, where i counts along u and j along v.
    pub control_points: Vec<Vec<DVec3>>,
    /// A positive weight for each control point; `None` if all are equal.
    pub weights: Option<Vec<Vec<f64>>>,
}

impl Nurbs {
    /// Makes the Bézier patch with these control points. Their number determines the degrees.
    #[must_use]
    pub fn bezier(control_points: Vec<Vec<DVec3>>) -> Self {
        let (m, n) = (control_points.len(), control_points.first().map_or(0, Vec::len));
        let knots = |count: usize| (0..2 * count).map(|k| if k < count { 0.0 } else { 1.0 }).collect();
        Self {
            degrees: [m.saturating_sub(1), n.saturating_sub(1)],
            knots: [knots(m), knots(n)],
            control_points,
            weights: None,
        }
    }

    /// Checks everything that evaluation relies on. `place` is the place of the patch in the input.
    ///
    /// # Errors
    /// [`Error::Input`] with the place of every wrong value.
    pub fn check(&self, place: &Place) -> Result<(), Error> {
        let mut errors = Vec::new();
        let columns = self.control_points.first().map_or(0, Vec::len);
        let points = place.clone().then("control_points");
        if self.control_points.len() < 2 || columns < 2 {
            return Err(Error::input(points, "needs at least 2 × 2 control points"));
        }
        for (i, row) in self.control_points.iter().enumerate() {
            if row.len() != columns {
                errors.push(InputError::new(points.clone().at(i), "must have as many points as the first row"));
            }
            for (j, p) in row.iter().enumerate() {
                if !p.is_finite() || p.abs().max_element() > LARGEST_COORDINATE {
                    let place = points.clone().at(i).at(j);
                    errors.push(InputError::new(place, "must be finite and below 1e50 in magnitude"));
                }
            }
        }
        if let Some(weights) = &self.weights {
            let place = place.clone().then("weights");
            if weights.len() != self.control_points.len() || weights.iter().any(|row| row.len() != columns) {
                errors.push(InputError::new(place.clone(), "must have the shape of the control points"));
            }
            for (i, row) in weights.iter().enumerate() {
                for (j, &weight) in row.iter().enumerate() {
                    if !(1e-6..=1e6).contains(&weight) {
                        errors.push(InputError::new(place.clone().at(i).at(j), "must lie between 1e-6 and 1e6"));
                    }
                }
            }
        }
        let counts = [self.control_points.len(), columns];
        for (axis, (knots, count)) in self.knots.iter().zip(counts).enumerate() {
            let degree = self.degrees[axis];
            let place = Place(place.0.iter().copied().chain([Step::Field("knots"), Step::Index(axis)]).collect());
            if degree < 1 || degree >= count || degree > LARGEST_DEGREE {
                let place = Place(
                    place.0[..place.0.len() - 2]
                        .iter()
                        .copied()
                        .chain([Step::Field("degrees"), Step::Index(axis)])
                        .collect(),
                );
                let detail = format!(
                    "must be at least 1, below the number of control points along it, and at most {LARGEST_DEGREE}"
                );
                errors.push(InputError::new(place, detail));
            } else if knots.len() != count + degree + 1 {
                errors.push(InputError::new(
                    place,
                    format!("must have {} knots: control points + degree + 1", count + degree + 1),
                ));
            } else if let Some(k) = knots.iter().position(|knot| knot.is_nan() || knot.abs() > LARGEST_COORDINATE) {
                errors.push(InputError::new(place.at(k), "must be finite"));
            } else if let Some(k) = knots.windows(2).position(|pair| pair[1] < pair[0]) {
                errors.push(InputError::new(place.at(k + 1), "must not be less than the knot before it"));
            } else if let Some(k) = (1..count).find(|&k| knots[k] >= knots[k + degree]) {
                errors.push(InputError::new(
                    place.at(k),
                    "is repeated more often than the degree: the patch would come apart",
                ));
            } else if knots[degree] >= knots[count] {
                errors.push(InputError::new(place, "cover no interval"));
            }
        }
        if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
    }

    /// Returns the patch moved by -`centre`, then divided by `unit`.
    pub(crate) fn centred(&self, centre: DVec3, unit: f64) -> Self {
        let control_points =
            self.control_points.iter().map(|row| row.iter().map(|&p| (p - centre) / unit).collect()).collect();
        Self { control_points, ..self.clone() }
    }

    /// Returns the area of the patch, by Gauss's rule with three points in each cell along each parameter.
    pub(crate) fn area(&self) -> f64 {
        let rule: [Vec<(f64, f64)>; 2] = [0, 1].map(|axis| {
            let (knots, degree) = (&self.knots[axis], self.degrees[axis]);
            let (low, high) = (knots[degree], knots[knots.len() - degree - 1]);
            let mut ends: Vec<f64> = knots.iter().filter(|&&knot| knot >= low && knot <= high).copied().collect();
            ends.dedup();
            let cells = (AREA_CELLS / (ends.len() - 1)).max(2);
            let spans = ends.windows(2).map(|pair| ((pair[0] - low) / (high - low), (pair[1] - low) / (high - low)));
            spans
                .flat_map(|(from, to)| {
                    let width = (to - from) / cells as f64;
                    (0..cells).flat_map(move |k| {
                        let middle = from + (k as f64 + 0.5) * width;
                        let off = 0.5 * width * 0.6f64.sqrt();
                        [(middle - off, 5.0), (middle, 8.0), (middle + off, 5.0)].map(|(t, w)| (t, w * width / 18.0))
                    })
                })
                .collect()
        });
        let density = |u: f64, v: f64| {
            let [_, du, dv] = self.evaluate(DVec2::new(u, v));
            du.cross(dv).length()
        };
        rule[0].iter().map(|&(u, w)| w * rule[1].iter().map(|&(v, w)| w * density(u, v)).sum::<f64>()).sum()
    }

    /// Returns the point and its derivatives by u and v at parameters in \[0, 1\]². The patch must have passed
    /// [`check`](Self::check).
    #[must_use]
    pub fn evaluate(&self, parameters: DVec2) -> [DVec3; 3] {
        if self.degrees[0].max(self.degrees[1]) < COMMON {
            self.evaluate_with::<COMMON>(parameters)
        } else {
            self.evaluate_with::<{ LARGEST_DEGREE + 1 }>(parameters)
        }
    }

    /// [`evaluate`](Self::evaluate) for degrees below N.
    fn evaluate_with<const N: usize>(&self, parameters: DVec2) -> [DVec3; 3] {
        let (mut bu, mut bv) = ([(0.0, 0.0); N], [(0.0, 0.0); N]);
        let i = basis(&self.knots[0], self.degrees[0], parameters.x, &mut bu);
        let j = basis(&self.knots[1], self.degrees[1], parameters.y, &mut bv);
        // Sums over the basis functions of weight · point, and of the weights. Each has three entries: the value, the
        // derivative by u and the derivative by v.
        let (mut points, mut weights) = ([DVec3::ZERO; 3], [0.0; 3]);
        for (k, &(nu, du)) in bu[..=self.degrees[0]].iter().enumerate() {
            for (l, &(nv, dv)) in bv[..=self.degrees[1]].iter().enumerate() {
                let weight = self.weights.as_ref().map_or(1.0, |weights| weights[i + k][j + l]);
                let point = self.control_points[i + k][j + l];
                for (slot, b) in [nu * nv, du * nv, nu * dv].into_iter().enumerate() {
                    points[slot] += point * (b * weight);
                    weights[slot] += b * weight;
                }
            }
        }
        let point = points[0] / weights[0];
        [point, (points[1] - point * weights[1]) / weights[0], (points[2] - point * weights[2]) / weights[0]]
    }
}

/// Least sine of the angle between the two derivatives of a patch, and least length of a derivative relative to the
/// largest one along its parameter. Below either the point has no normal, because near a pole rounding would decide its
/// direction.
const SINGULAR: [f64; 2] = [1e-3, 1e-9];

/// Returns the unit vector along du × dv, or `None` where the derivatives define no normal. `largest` has the lengths
/// of the patch's largest derivatives by u and by v.
pub(crate) fn unit_normal(du: DVec3, dv: DVec3, largest: [f64; 2]) -> Option<DVec3> {
    let (cross, lengths) = (du.cross(dv), [du.length(), dv.length()]);
    let regular = cross.length() > SINGULAR[0] * lengths[0] * lengths[1]
        && (0..2).all(|axis| lengths[axis] > SINGULAR[1] * largest[axis]);
    if regular { cross.try_normalize() } else { None }
}

/// Evaluates the degree + 1 basis functions that do not vanish at `t` in \[0, 1\]. Writes the value and the derivative
/// by `t` of each to `functions`. Returns the index of the first of these functions, which is also that of its control
/// point.
fn basis<const N: usize>(knots: &[f64], degree: usize, t: f64, functions: &mut [(f64, f64); N]) -> usize {
    let count = knots.len() - degree - 1;
    let (low, high) = (knots[degree], knots[count]);
    let x = (low + (high - low) * t).clamp(low, high);
    // The span of x is the last non-empty span that starts at or before x. The end of the domain belongs to the last
    // span.
    let span = (knots[degree + 1..=count].partition_point(|&knot| knot <= x) + degree).min(count - 1);
    let span = (degree..=span).rev().find(|&k| knots[k] < knots[k + 1]).unwrap_or(span);
    // After round r the first r + 1 values are the functions of degree r; `lower` keeps those of degree - 1.
    let (mut values, mut lower) = ([0.0; N], [0.0; N]);
    values[0] = 1.0;
    for r in 1..=degree {
        if r == degree {
            lower = values;
        }
        let mut carried = 0.0;
        for k in 0..r {
            let (left, right) = (knots[span + 1 - r + k], knots[span + 1 + k]);
            let share = values[k] / (right - left);
            values[k] = carried + (right - x) * share;
            carried = (x - left) * share;
        }
        values[r] = carried;
    }
    let mut rising = 0.0;
    for k in 0..=degree {
        let falling = if k < degree { lower[k] / (knots[span + 1 + k] - knots[span + 1 - degree + k]) } else { 0.0 };
        functions[k] = (values[k], degree as f64 * (rising - falling) * (high - low));
        rising = falling;
    }
    span - degree
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wavy(rows: usize, columns: usize) -> Vec<Vec<DVec3>> {
        let height = |i: usize, j: usize| ((i * 7 + j * 3) % 5) as f64 - 1.3 * ((i * j) % 3) as f64;
        (0..rows).map(|i| (0..columns).map(|j| DVec3::new(i as f64, 1.2 * j as f64, height(i, j))).collect()).collect()
    }

    fn close(a: DVec3, b: DVec3) {
        assert!(a.distance(b) < 1e-12 * (1.0 + a.length()), "{a} {b}");
    }

    #[test]
    fn a_bezier_patch_is_what_de_casteljau_says() {
        let patch = Nurbs::bezier(wavy(5, 4));
        patch.check(&Place::default()).unwrap();
        let de_casteljau = |mut points: Vec<DVec3>, t: f64| {
            while points.len() > 1 {
                points = points.windows(2).map(|pair| pair[0].lerp(pair[1], t)).collect();
            }
            points[0]
        };
        for (u, v) in [(0.0, 0.0), (0.3, 0.8), (1.0, 0.4), (1.0, 1.0), (0.77, 0.0)] {
            let rows = patch.control_points.iter().map(|row| de_casteljau(row.clone(), v)).collect();
            close(patch.evaluate(DVec2::new(u, v))[0], de_casteljau(rows, u));
        }
    }

    #[test]
    fn derivatives_agree_with_differences_at_second_order() {
        let weights = (0..6).map(|i| (0..5).map(|j| 1.0 + ((i + 2 * j) % 4) as f64).collect()).collect();
        let patch = Nurbs {
            degrees: [3, 2],
            knots: [
                vec![2.0, 2.0, 2.0, 2.0, 3.0, 5.0, 7.0, 7.0, 7.0, 7.0],
                vec![-1.0, -0.5, 0.0, 1.0, 1.0, 2.0, 2.5, 3.0],
            ],
            control_points: wavy(6, 5),
            weights: Some(weights),
        };
        patch.check(&Place::default()).unwrap();
        for at in [DVec2::new(0.21, 0.33), DVec2::new(0.9, 0.71)] {
            let [_, du, dv] = patch.evaluate(at);
            let error = |h: f64| {
                let p = |x, y| patch.evaluate(at + DVec2::new(x, y))[0];
                let (u, v) = ((p(h, 0.0) - p(-h, 0.0)) / (2.0 * h), (p(0.0, h) - p(0.0, -h)) / (2.0 * h));
                (u - du).length() + (v - dv).length()
            };
            assert!(error(1e-3) / error(5e-4) > 3.8 && error(1e-5) < 1e-6);
        }
    }

    #[test]
    fn rational_weights_make_an_exact_cylinder() {
        let r = 0.5f64.sqrt();
        let arc = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let patch = Nurbs {
            degrees: [2, 1],
            knots: [vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], vec![0.0, 0.0, 1.0, 1.0]],
            control_points: arc.iter().map(|&[x, z]| vec![DVec3::new(x, 0.0, z), DVec3::new(x, 4.0, z)]).collect(),
            weights: Some(vec![vec![1.0; 2], vec![r; 2], vec![1.0; 2]]),
        };
        for k in 0..=10 {
            let [p, du, dv] = patch.evaluate(DVec2::new(f64::from(k) / 10.0, 0.3));
            assert!((libm::hypot(p.x, p.z) - 1.0).abs() < 1e-14 && (p.y - 1.2).abs() < 1e-14);
            assert!(du.dot(DVec3::new(p.x, 0.0, p.z)).abs() < 1e-13);
            close(dv, DVec3::new(0.0, 4.0, 0.0));
        }
    }

    #[test]
    fn wrong_patches_are_named() {
        let places = |patch: &Nurbs| match patch.check(&Place::field("domain")) {
            Err(Error::Input(errors)) => errors.iter().map(|e| e.place.to_string()).collect::<Vec<_>>(),
            other => panic!("{other:?}"),
        };
        let good = Nurbs::bezier(wavy(3, 3));
        assert_eq!(places(&Nurbs::bezier(vec![])), ["/domain/control_points"]);
        assert_eq!(places(&Nurbs::bezier(wavy(3, 1))), ["/domain/control_points"]);
        let with = |change: &dyn Fn(&mut Nurbs)| {
            let mut patch = good.clone();
            change(&mut patch);
            places(&patch)
        };
        assert_eq!(
            with(&|p| {
                p.control_points[1].pop();
            }),
            ["/domain/control_points/1"]
        );
        assert_eq!(with(&|p| p.control_points[1][2].y = f64::NAN), ["/domain/control_points/1/2"]);
        assert_eq!(with(&|p| p.weights = Some(vec![vec![1.0, 0.0, 1.0]; 3])).len(), 3);
        assert_eq!(with(&|p| p.weights = Some(vec![vec![1.0; 3]; 2])), ["/domain/weights"]);
        assert_eq!(with(&|p| p.degrees[1] = 0), ["/domain/degrees/1"]);
        assert_eq!(with(&|p| p.degrees[1] = 3), ["/domain/degrees/1"]);
        assert_eq!(
            with(&|p| {
                p.knots[0].pop();
            }),
            ["/domain/knots/0"]
        );
        assert_eq!(with(&|p| p.knots[0][1] = f64::NAN), ["/domain/knots/0/1"]);
        assert_eq!(with(&|p| p.knots[0][1] = 7.0), ["/domain/knots/0/2"]);
        assert_eq!(with(&|p| p.knots[0] = vec![0.0; 6]), ["/domain/knots/0/1"]);
    }
}
