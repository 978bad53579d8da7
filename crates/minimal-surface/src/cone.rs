//! Proves by a separating cone, before any film is solved, that no connected minimal surface spans some boundaries.
//!
//! **Theorem** (J. C. C. Nitsche, S. Hildebrandt; Dierkes, Hildebrandt, Sauvigny, *Minimal Surfaces*, section 6.2). Let
//! a double cone r ≤ |z| sinh τ, where τ tanh τ = 1, contain the part A of a boundary in one half and the part B in the
//! other. Then no connected minimal surface, of any genus, has this boundary. The reason is that the catenoids that
//! touch the cone sweep the space between its halves, and the surface could not touch the first of them that it meets.
//! The bound is sharp for two equal coaxial circles.

use plateau_mesh::codes::Reason;
use plateau_mesh::error::InputError;
use plateau_mesh::{DVec3, Error, Execution, Interruption, Place, polyline};

/// sinh τ, the ratio of radius to height of the cone, for the solution τ = 1.1996786402577337 of τ tanh τ = 1.
const SLOPE: f64 = 1.508_879_561_538_319_7;
/// Largest number of points of a boundary that are examined. Each examined point stands for the skipped points that
/// follow it, so the boundary is enlarged by the largest distance of a skipped point from its examined point.
const MOST_POINTS: usize = 64;
/// Largest number n of boundaries that are examined. The number is small, because each of the 2ⁿ⁻¹ - 1 ways to divide
/// the boundaries into two parts is tried.
const MOST_BOUNDARIES: usize = 6;
/// First and last step of the search for a cone, as fractions of the radius of all boundaries.
const FIRST_STEP: f64 = 0.25;
const LAST_STEP: f64 = 1e-3;
/// Largest number of rounds of the search, each of which tries eight cones.
const MOST_ROUNDS: u32 = 48;
/// A cone separates the boundaries if its halves can be drawn apart by more than this fraction of the radius. It is
/// above rounding.
const LEAST_GAP: f64 = 1e-9;

/// The examined points of a boundary. Each of its other points lies within the distance `within` of an examined point.
struct Outline {
    points: Vec<DVec3>,
    within: f64,
}

impl Outline {
    fn new(boundary: &[DVec3]) -> Self {
        let stride = boundary.len().div_ceil(MOST_POINTS).max(1);
        let points: Vec<DVec3> = boundary.iter().copied().step_by(stride).collect();
        let within =
            boundary.iter().enumerate().map(|(k, point)| point.distance(points[k / stride])).fold(0.0, f64::max);
        Self { points, within }
    }
}

/// Indices of the boundaries in the two parts that a cone separates.
pub(crate) type Parted = [Vec<usize>; 2];

/// Looks for a double cone that holds some of the boundaries in one half and the others in the other half, so that no
/// connected minimal surface spans them. Each boundary must have at least one point. Returns the two parts, or `None`
/// if no such cone is found, which proves nothing. More than six boundaries are not examined.
///
/// # Errors
/// The interruptions of `exec`.
pub(crate) fn part(boundaries: &[Vec<DVec3>], exec: &Execution) -> Result<Option<Parted>, Interruption> {
    let count = boundaries.len();
    if !(2..=MOST_BOUNDARIES).contains(&count) {
        return Ok(None);
    }
    let outlines: Vec<Outline> = boundaries.iter().map(|boundary| Outline::new(boundary)).collect();
    let all: Vec<DVec3> = outlines.iter().flat_map(|outline| outline.points.iter().copied()).collect();
    let radius = polyline::radius(&all);
    // The last boundary always stays in the second part, because exchanging the parts makes no difference.
    for first in 1..1u32 << (count - 1) {
        exec.look(all.len() as u64)?;
        let (one, other): (Vec<usize>, Vec<usize>) = (0..count).partition(|&k| first & (1 << k) != 0);
        let parts = [&one, &other].map(|part| part.iter().map(|&k| &outlines[k]).collect::<Vec<_>>());
        if widest_gap(&parts, radius) > LEAST_GAP * radius {
            return Ok(Some([one, other]));
        }
    }
    Ok(None)
}

/// The error for boundaries that a cone separates: no connected film spans them.
pub(crate) fn refusal(parted: &Parted) -> Error {
    let [one, other] = parted.each_ref().map(|part| {
        let names: Vec<String> = part.iter().map(usize::to_string).collect();
        if names.len() == 1 { format!("boundary {}", names[0]) } else { format!("boundaries {}", names.join(", ")) }
    });
    not_connected(&format!(
        "a double cone with sides of {:.1}° to its axis holds {one} in one half and {other} in the other, and no \
         connected minimal surface reaches through its apex (Nitsche, Hildebrandt)",
        libm::atan(SLOPE).to_degrees()
    ))
}

/// The error that no film connects the boundaries, with the reason.
pub(super) fn not_connected(reason: &str) -> Error {
    let detail = format!(
        "no minimal film connects the boundaries: {reason}. Ask for topology best or free, which let the film come \
         apart, or move the boundaries closer together"
    );
    let place = InputError::new(Place::field("topology"), "fixed keeps the boundaries connected");
    Error::NoResult { reason: Reason::NoConnectedFilm, detail, places: vec![place] }
}

/// Searches for the double cone whose halves can be drawn apart the farthest along the axis and still hold one part
/// each. Returns the largest distance found. Negative if no cone was found whose halves hold the parts.
fn widest_gap(parts: &[Vec<&Outline>; 2], radius: f64) -> f64 {
    let means = parts.each_ref().map(|part| {
        let means = part.iter().map(|outline| polyline::mean(&outline.points)).sum::<DVec3>();
        means / part.len() as f64
    });
    let Some(axis) = (means[0] - means[1]).try_normalize() else { return -f64::INFINITY };
    let (x, y) = axis.any_orthonormal_pair();
    let middle = 0.5 * (means[0] + means[1]);
    // The cone's apex lies in the plane across the initial axis (`at[0..2]`), and its axis is tilted (`at[2..4]`).
    let gap = |at: [f64; 4]| {
        let axis = (axis + at[2] / radius * x + at[3] / radius * y).normalize();
        distance_apart(parts, middle + at[0] * x + at[1] * y, axis)
    };
    let mut best = [0.0; 4];
    let mut widest = gap(best);
    let mut step = FIRST_STEP * radius;
    for _ in 0..MOST_ROUNDS {
        if step < LAST_STEP * radius || widest > LEAST_GAP * radius {
            break;
        }
        let before = widest;
        for k in 0..4 {
            for sense in [step, -step] {
                let mut tried = best;
                tried[k] += sense;
                let found = gap(tried);
                if found > widest {
                    (best, widest) = (tried, found);
                }
            }
        }
        // The step is halved if the round gained less than a tenth of it.
        if widest - before < 0.1 * step {
            step *= 0.5;
        }
    }
    widest
}

/// The distance by which the halves of a double cone around an axis can be drawn apart. A point at the height z along
/// the axis and the distance r from it lies in the upper half if the apex is not above z - r / sinh τ.
fn distance_apart(parts: &[Vec<&Outline>; 2], origin: DVec3, axis: DVec3) -> f64 {
    let reach = |outline: &Outline, sense: f64| {
        let heights = outline.points.iter().map(|&point| {
            let from = point - origin;
            let height = from.dot(axis);
            sense * height - (from - height * axis).length() / SLOPE
        });
        // The skipped points lie within `within` of an examined point. Their heights differ from those of the examined
        // points by at most `within` times sqrt(1 + 1 / sinh² τ), the length of the gradient of z - r / sinh τ.
        heights.fold(f64::INFINITY, f64::min) - outline.within * (1.0 + SLOPE.powi(-2)).sqrt()
    };
    let least =
        |part: usize, sense: f64| parts[part].iter().map(|outline| reach(outline, sense)).fold(f64::INFINITY, f64::min);
    least(0, 1.0) + least(1, -1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn ring(radius: f64, height: f64, count: usize) -> Vec<DVec3> {
        let angle = |k: usize| TAU * k as f64 / count as f64;
        (0..count).map(|k| DVec3::new(radius * libm::cos(angle(k)), radius * libm::sin(angle(k)), height)).collect()
    }

    fn is_parted(boundaries: &[Vec<DVec3>]) -> bool {
        part(boundaries, &Execution::default()).unwrap().is_some()
    }

    #[test]
    fn the_cone_is_sharp_for_equal_coaxial_circles() {
        // The catenoid between unit circles ends at a distance of 2 / sinh τ = 1.3254868.
        let critical = 2.0 / SLOPE;
        for count in [48, 64] {
            assert!(!is_parted(&[ring(1.0, 0.0, count), ring(1.0, 0.9999 * critical, count)]));
            assert!(is_parted(&[ring(1.0, 0.0, count), ring(1.0, 1.0001 * critical, count)]));
        }
        // With many points, the distance of the skipped points counts. Here it is a tenth of the radius.
        assert!(!is_parted(&[ring(1.0, 0.0, 1000), ring(1.0, 0.9999 * critical, 1000)]));
        assert!(is_parted(&[ring(1.0, 0.0, 1000), ring(1.0, 1.2 * critical, 1000)]));
    }

    #[test]
    fn a_cone_is_found_after_a_motion_and_between_groups_of_boundaries() {
        let motion = glam::DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 1.1);
        let moved = |boundary: Vec<DVec3>| -> Vec<DVec3> {
            boundary.into_iter().map(|point| motion * point * 3.0 + DVec3::splat(40.0)).collect()
        };
        let shifted = |boundary: Vec<DVec3>| -> Vec<DVec3> {
            boundary.into_iter().map(|point| point + DVec3::new(0.2, 0.1, 0.0)).collect()
        };
        let near = [ring(1.0, 0.0, 40), shifted(ring(0.9, 0.2, 40))];
        let far = ring(0.5, 1.6, 30);
        let all: Vec<_> = near.iter().cloned().chain([far.clone()]).map(moved).collect();
        assert_eq!(part(&all, &Execution::default()).unwrap(), Some([vec![0, 1], vec![2]]));
        assert!(!is_parted(&all[..2]));
    }

    #[test]
    fn one_ring_inside_another_is_not_parted() {
        assert!(!is_parted(&[ring(1.0, 0.0, 40), ring(0.3, 0.0, 40)]));
        assert!(!is_parted(&[ring(1.0, 0.0, 40)]));
        let seven: Vec<_> = (0..7).map(|k| ring(1.0, 10.0 * f64::from(k), 12)).collect();
        assert!(!is_parted(&seven));
    }
}
