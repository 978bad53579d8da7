//! The lines and surfaces on which vertices slide without friction.
//!
//! Each kind of support is one file that implements [`Support`]; the solver knows the trait alone.
//! `docs/adding-a-support.md` shows the way to a further kind.

mod circle;
mod cylinder;
mod line;
mod mesh;
mod plane;
mod sphere;
mod torus;

pub use circle::Circle;
pub use cylinder::Cylinder;
pub use line::Line;
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
/// A vertex moves along the support's tangents and is then taken to the nearest point of the support. To second order
/// it moves by u + ½ II(u, u) with the support's second fundamental form II (a vector along the support's normal), so
/// the second variation of an energy with gradient g has the further part g · II(u, v).
pub trait Support: fmt::Debug + Send + Sync {
    /// Whether directions and axes are unit vectors and lengths such as a radius are positive.
    fn is_sound(&self) -> bool;

    /// Number of tangents: 1 for a curve, 2 for a surface.
    fn dimension(&self) -> u8;

    /// The point of the support that is nearest to `x`. If several are (as for the centre of a sphere), the support
    /// returns one in a fixed direction. Newton's method needs the point up to terms of third order in the distance.
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

    /// The support at another place.
    fn moved(&self, by: DVec3) -> Arc<dyn Support>;

    /// The area beside an edge that slides on a surface, if there is a closed form. Edges meet a support without such a
    /// form at a right angle only. The points are those of the edge in order; the form must not jump near them.
    fn area_beside(&self, _edge: &[DVec3]) -> Option<Arc<dyn AreaBeside>> {
        None
    }

    /// The bounds of a support that follows given data and has a border, such as a mesh. `None` if it has none.
    fn extent(&self) -> Option<&dyn Extent> {
        None
    }
}

/// The area on the left of an edge that slides on a surface, as seen from the side to which the surface's normal
/// points, up to a constant. It is a sum over the segments of the edge ([`Contact`](super::Contact)).
pub trait AreaBeside: fmt::Debug + Send + Sync {
    /// The part of the segment from `a` to `b`.
    fn part(&self, a: DVec3, b: DVec3) -> AreaPart;
}

/// The area beside one segment and its derivatives by the two ends.
#[derive(Clone, Copy, Debug)]
pub struct AreaPart {
    /// The area.
    pub area: f64,
    /// The derivatives by `a` and by `b`.
    pub gradient: [DVec3; 2],
    /// The second derivatives: by `a` twice, by `a` and `b`, by `b` twice.
    pub second: [DMat3; 3],
}

/// How far a support that follows given data can be relied on.
pub trait Extent {
    /// The length within which the support is near its data: vertices may start at this distance from the data, and the
    /// support goes on beyond the border of the data from there.
    fn rounding(&self) -> f64;

    /// The distance of a point from the data.
    fn distance(&self, x: DVec3) -> f64;

    /// Number of pieces of the data, such as triangles, that each step looks at near a point.
    fn pieces_near(&self, x: DVec3) -> usize;

    /// Number of all pieces of the data, on which the memory of the support depends.
    fn size(&self) -> usize;
}

/// The unit vector from an axis of unit direction `axis` through `point` to `x`; for a point of the axis a fixed one.
fn outward(x: DVec3, point: DVec3, axis: DVec3) -> DVec3 {
    (x - point).reject_from_normalized(axis).normalize_or(axis.any_orthonormal_vector())
}
