//! The lines and surfaces on which vertices slide without friction.
//!
//! Each kind of support is one file that implements [`Support`]; the solver only knows this trait.
//! `docs/adding-a-support.md` shows how to add a kind.

mod circle;
mod cylinder;
mod line;
mod mesh;
mod plane;
mod sphere;
mod torus;

pub use circle::Circle;
pub use cylinder::Cylinder;
pub use line::StraightLine;
pub use mesh::Mesh;
pub use plane::Plane;
pub use sphere::Sphere;
pub use torus::Torus;

use glam::DMat3;
use plateau_mesh::DVec3;
use std::fmt;
use std::sync::Arc;

/// A curve or surface on which vertices slide without friction.
///
/// A vertex moves along the support's tangents and is then taken to the nearest point of the support. A motion u along
/// the tangents thus becomes u + ½ II(u, u) to second order, where II is the support's second fundamental form, a
/// vector along its normal. The second variation of an energy with gradient g therefore gets the additional part g ·
/// II(u, v).
pub trait Support: fmt::Debug + Send + Sync {
    /// Whether directions and axes are unit vectors and lengths such as a radius are positive.
    fn is_sound(&self) -> bool;

    /// Number of tangents: 1 for a curve, 2 for a surface.
    fn dimension(&self) -> u8;

    /// The point of the support that is nearest to `x`. If several points are nearest (all of a sphere's are to its
    /// centre), the support returns the one in a fixed direction. Newton's method needs the point up to terms of third
    /// order in the distance.
    fn nearest(&self, x: DVec3) -> DVec3;

    /// Orthonormal tangents at a point of the support. For a curve only the first is used.
    fn tangents(&self, x: DVec3) -> [DVec3; 2];

    /// The unit normal at a point of a surface, on a fixed side. Zero for a curve.
    fn normal(&self, _x: DVec3) -> DVec3 {
        DVec3::ZERO
    }

    /// II(u, v) for two tangents at a point `x` of the support. Zero for a line or a plane.
    fn second_fundamental_form(&self, _x: DVec3, _u: DVec3, _v: DVec3) -> DVec3 {
        DVec3::ZERO
    }

    /// Whether II = 0 everywhere: the support is a line or a plane.
    fn is_flat(&self) -> bool {
        false
    }

    /// This support, translated by `by`.
    fn moved(&self, by: DVec3) -> Arc<dyn Support>;

    /// The area beside an edge that slides on a surface. `None` if the support has no closed form of it; a film can
    /// meet such a support only at a right angle. `edge` lists the points of the edge in order, and the closed form
    /// must not jump near them.
    fn area_beside(&self, _edge: &[DVec3]) -> Option<Arc<dyn AreaBeside>> {
        None
    }

    /// The extent of a support that follows given data and has a border, such as a mesh. `None` for a support without a
    /// border.
    fn extent(&self) -> Option<&dyn Extent> {
        None
    }
}

/// The area on the left of an edge that slides on a surface, as seen from the side to which the surface's normal
/// points. It is determined up to a constant, as a sum over the segments of the edge
/// ([`ContactEnergy`](super::ContactEnergy)).
pub trait AreaBeside: fmt::Debug + Send + Sync {
    /// The part of the area that belongs to the segment from `a` to `b`.
    fn part(&self, a: DVec3, b: DVec3) -> AreaPart;
}

/// The area beside one segment, with its derivatives by the two ends `a` and `b` of the segment.
#[derive(Clone, Copy, Debug)]
pub struct AreaPart {
    /// The area.
    pub area: f64,
    /// The derivatives by `a` and by `b`.
    pub gradient: [DVec3; 2],
    /// The second derivatives: by `a` twice, by `a` and `b`, by `b` twice.
    pub second: [DMat3; 3],
}

/// The part of space in which a support that follows given data can be relied on.
pub trait Extent {
    /// The length within which the support follows its data. A vertex may start at most this far from the data. Beyond
    /// the border of the data the support continues without data to follow.
    fn rounding(&self) -> f64;

    /// The distance of a point from the data.
    fn distance(&self, x: DVec3) -> f64;

    /// Number of pieces of the data, such as triangles, that each step has to visit near `x`.
    fn pieces_near(&self, x: DVec3) -> usize;

    /// Number of all pieces of the data. The memory of the support grows with it.
    fn size(&self) -> usize;
}

/// The unit vector that points from an axis to `x`, at right angles to the axis. The axis runs through `point` in the
/// unit direction `axis`. For a point on the axis a fixed vector is returned.
fn outward(x: DVec3, point: DVec3, axis: DVec3) -> DVec3 {
    (x - point).reject_from_normalized(axis).normalize_or(axis.any_orthonormal_vector())
}
