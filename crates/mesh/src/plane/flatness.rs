//! Measures how far points lie off the plane in which they should lie. Rounding coordinates, for example to
//! millimetres, moves points off a sloped plane by about the same amount. Points near their plane are therefore
//! projected onto it.

use super::frame::Frame;
use crate::DVec3;
use crate::polyline::radius;

/// Largest distance from their plane at which points are projected onto it, as a fraction of the outline's size.
/// Coordinates rounded to millimetres are off by up to about a millimetre, so that such outlines are projected if they
/// measure a metre or more.
const PROJECTED: f64 = 1e-3;

/// Points whose distance from their plane is at most this fraction of the outline's size count as exactly plane.
/// Rotating and moving a plane outline in f64 causes smaller distances.
const ROUNDING: f64 = 1e-9;

/// Additional distance that counts as rounding, in units in the last place of the largest coordinate. Multiplication by
/// a rotation matrix rounds each coordinate by up to 2.5 of these units.
const ROUNDED_PLACES: f64 = 8.0;

/// The relation of points to their plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flatness {
    /// The points lie in the plane, up to rounding.
    Plane,
    /// The points are to be projected onto the plane. Their largest distance from it is given.
    Near(f64),
    /// A point lies too far from the plane.
    Bent(Departure),
}

/// A point that lies too far from the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The number of the farthest point. Of points that are equally far, up to rounding, this is the first.
    pub point: usize,
    /// Its distance from the plane.
    pub distance: f64,
    /// The largest distance at which points are projected.
    pub limit: f64,
}

impl Departure {
    /// Returns an error message. It begins with `what`, the name of the points that should be plane.
    pub fn detail(&self, what: &str) -> String {
        format!(
            "{what}: this point is {:.6e} off the plane. Departures of at most {:.6e} (a thousandth of the size) are \
             projected",
            self.distance, self.limit
        )
    }
}

impl Flatness {
    /// Compares points with the plane of a loop. The size of the loop is the diameter of the circle around the mean of
    /// its points that contains the loop.
    pub fn of(points: impl Iterator<Item = DVec3>, outline: &[DVec3], plane: &Frame) -> Self {
        let (mut largest, mut farthest) = (0.0f64, (0, 0.0));
        for (k, point) in points.enumerate() {
            largest = largest.max(point.abs().max_element());
            let distance = plane.height(point);
            if distance > farthest.1 * (1.0 + 1e-9) {
                farthest = (k, distance);
            }
        }
        let (size, (point, distance)) = (2.0 * radius(outline), farthest);
        let limit = PROJECTED * size;
        if distance <= ROUNDING * size + ROUNDED_PLACES * (largest.next_up() - largest) {
            Self::Plane
        } else if distance <= limit {
            Self::Near(distance)
        } else {
            Self::Bent(Departure { point, distance, limit })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flatness(points: &[DVec3]) -> Flatness {
        Flatness::of(points.iter().copied(), points, &Frame::of_loop(points).unwrap())
    }

    #[test]
    fn a_thousandth_of_the_size_is_projected_and_rounding_is_not() {
        for scale in [1e-6, 1.0, 1e6] {
            // If a corner is raised, its distance from the plane through the mean is a quarter of its height, and so is
            // that of each other corner.
            let raised = |distance: f64| {
                let square = [[0.0, 0.0, 4.0 * distance], [3.0, 0.0, 0.0], [3.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
                flatness(&square.map(|corner| scale * DVec3::from(corner)))
            };
            assert_eq!(raised(0.0), Flatness::Plane);
            assert_eq!(raised(4e-9), Flatness::Plane);
            for within in [6e-9, 4.9e-3] {
                let Flatness::Near(distance) = raised(within) else { panic!("{:?}", raised(within)) };
                assert!((distance / (scale * within) - 1.0).abs() < 1e-4, "{distance}");
            }
            let Flatness::Bent(departure) = raised(5.1e-3) else { panic!("not refused") };
            assert!((departure.limit / scale - 5e-3).abs() < 1e-5 && departure.point == 0, "{departure:?}");
        }
    }

    #[test]
    fn a_projected_loop_is_plane_wherever_it_is() {
        let far = DVec3::new(1e7, -2e6, 3e7);
        let bent: Vec<DVec3> = [[0.0, 0.0, 0.001], [6.0, 0.2, 4.0], [6.1, 5.0, 4.1], [0.3, 5.2, 0.3]]
            .map(|corner| far + DVec3::from(corner))
            .to_vec();
        let plane = Frame::of_loop(&bent).unwrap();
        assert!(matches!(flatness(&bent), Flatness::Bent(_)), "{:?}", flatness(&bent));
        let projected: Vec<DVec3> = bent.iter().map(|&point| plane.foot(point)).collect();
        assert_eq!(flatness(&projected), Flatness::Plane);
    }
}
