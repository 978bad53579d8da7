//! Plane geometry that every kind of mesh is built from: the frame of a loop, how flat its points are, polygons,
//! constrained Delaunay triangulations, and the search for the triangle that holds a point.

pub mod flatness;
pub mod frame;
pub mod location;
pub mod polygon;
pub mod touching;
pub mod triangulation;

use crate::DVec2;

/// The unit vector at an angle in radians from the first axis.
#[must_use]
#[inline]
pub fn unit_vector(angle: f64) -> DVec2 {
    let (sine, cosine) = libm::sincos(angle);
    DVec2::new(cosine, sine)
}
