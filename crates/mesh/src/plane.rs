//! Plane geometry for all kinds of meshes: the frame of a loop, the flatness of its points, polygons, constrained
//! Delaunay triangulations, and point location in a triangulation.

pub mod flatness;
pub mod frame;
mod insertion_order;
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
