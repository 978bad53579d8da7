//! The ways in which a vertex may move, and the lines and surfaces on which it may slide.

use super::mesh_surface::MeshSurface;
use plateau_mesh::DVec3;
use plateau_mesh::error::InputError;
use std::sync::Arc;

/// The directions in which a vertex may move. There is one unknown for each direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Freedom {
    /// Not at all.
    #[default]
    Fixed,
    /// Along the area-weighted normal of its triangles: one unknown. This is for vertices inside a sheet, where sliding
    /// within the sheet hardly changes the area and would ruin the triangles.
    Normal,
    /// Across the curve through it, which runs from the first of these vertices to the second: two unknowns. This is
    /// for vertices inside a junction or a cable.
    Across([u32; 2]),
    /// On the support of this number: one unknown on a curve, two on a surface.
    On(u32),
    /// On a surface, across the edge of the film that runs from the first of these vertices to the second: one unknown.
    /// This is for an edge that slides on a surface, where sliding along the edge hardly changes the area and would
    /// ruin the triangles.
    AcrossOn {
        /// The number of the support.
        support: u32,
        /// The neighbours on the film's edge.
        beside: [u32; 2],
    },
    /// Along the direction of the group of this number, by the same distance as all other vertices of the group: one
    /// unknown for the whole group. This is for a rigid ring that is guided along its axis.
    Together(u32),
    /// Anywhere: three unknowns.
    Free,
}

impl Freedom {
    /// The number of the vertex's support.
    #[must_use]
    pub fn support(self) -> Option<u32> {
        match self {
            Self::On(support) | Self::AcrossOn { support, .. } => Some(support),
            Self::Fixed | Self::Normal | Self::Across(_) | Self::Together(_) | Self::Free => None,
        }
    }
}

/// A curve or surface on which vertices slide without friction. Directions and axes are unit vectors.
///
/// A vertex moves along the support's tangents and is then taken to the nearest point of the support. To second order
/// it moves by u + ½ II(u, u) with the support's second fundamental form II (a vector along the support's normal), so
/// the second variation of an energy with gradient g has the further part g · II(u, v).
#[derive(Clone, Debug, PartialEq)]
pub enum Support {
    /// A straight line. II = 0.
    Line {
        /// A point of the line.
        point: DVec3,
        /// Its unit direction.
        direction: DVec3,
    },
    /// A circle in the plane across `axis`. II(u, v) = -(u·v) (x - centre) / r².
    Circle {
        /// The centre.
        centre: DVec3,
        /// The unit normal of the circle's plane.
        axis: DVec3,
        /// r.
        radius: f64,
    },
    /// A plane. II = 0.
    Plane {
        /// A point of the plane.
        point: DVec3,
        /// Its unit normal.
        normal: DVec3,
    },
    /// A sphere. II(u, v) = -(u·v) (x - centre) / r².
    Sphere {
        /// The centre.
        centre: DVec3,
        /// r.
        radius: f64,
    },
    /// A round cylinder around the line through `point` along `axis`. II(u, v) = -(u⊥·v⊥) (x - point)⊥ / r², ⊥ the part
    /// across the axis.
    Cylinder {
        /// A point of the axis.
        point: DVec3,
        /// The axis's unit direction.
        axis: DVec3,
        /// r.
        radius: f64,
    },
    /// The smooth surface along a mesh ([`Support::mesh`]). II(u, v) = -(u · ∇²f v) ∇f / |∇f|² with the function f
    /// whose zero the surface is.
    Mesh {
        /// The surface, which all copies of the support share.
        surface: Arc<MeshSurface>,
        /// The place to which the surface's own coordinates are relative.
        origin: DVec3,
    },
}

impl Support {
    /// The smooth surface along a mesh, whose edges it rounds within a length of them.
    ///
    /// # Errors
    /// Those of [`MeshSurface::new`].
    pub fn mesh(vertices: &[DVec3], triangles: &[[u32; 3]], rounding: f64) -> Result<Self, InputError> {
        let (surface, origin) = MeshSurface::new(vertices, triangles, rounding)?;
        Ok(Self::Mesh { surface: Arc::new(surface), origin })
    }

    /// Whether its directions and axes are unit vectors and its radius is positive.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        match *self {
            Self::Line { direction, .. } => direction.is_normalized(),
            Self::Plane { normal, .. } => normal.is_normalized(),
            Self::Circle { axis, radius, .. } | Self::Cylinder { axis, radius, .. } => {
                axis.is_normalized() && radius > 0.0
            }
            Self::Sphere { radius, .. } => radius > 0.0,
            Self::Mesh { .. } => true,
        }
    }

    /// Number of tangents: 1 for a curve, 2 for a surface.
    #[must_use]
    pub fn dimension(&self) -> u8 {
        match self {
            Self::Line { .. } | Self::Circle { .. } => 1,
            Self::Plane { .. } | Self::Sphere { .. } | Self::Cylinder { .. } | Self::Mesh { .. } => 2,
        }
    }

    /// The point of the support that is nearest to `x`. If several are (as for the centre of a sphere), one in a fixed
    /// direction. On a mesh it differs from the nearest point by terms of third order in the distance.
    #[must_use]
    pub fn nearest(&self, x: DVec3) -> DVec3 {
        match self {
            &Self::Line { point, direction } => point + direction * (x - point).dot(direction),
            &Self::Circle { centre, axis, radius } => {
                let outward = (x - centre).reject_from_normalized(axis);
                centre + radius * outward.normalize_or(axis.any_orthonormal_vector())
            }
            &Self::Plane { point, normal } => x - normal * (x - point).dot(normal),
            &Self::Sphere { centre, radius } => centre + radius * (x - centre).normalize_or(DVec3::Z),
            &Self::Cylinder { point, axis, radius } => {
                let along = axis * (x - point).dot(axis);
                let outward = (x - point - along).normalize_or(axis.any_orthonormal_vector());
                point + along + radius * outward
            }
            Self::Mesh { surface, origin } => origin + surface.nearest(x - origin),
        }
    }

    /// Orthonormal tangents at a point of the support. For a curve only the first is used.
    #[must_use]
    pub fn tangents(&self, x: DVec3) -> [DVec3; 2] {
        let across = |normal: DVec3| <[DVec3; 2]>::from(normal.any_orthonormal_pair());
        match self {
            &Self::Line { direction, .. } => [direction, DVec3::ZERO],
            &Self::Circle { centre, axis, .. } => [axis.cross(x - centre).normalize_or_zero(), DVec3::ZERO],
            Self::Plane { .. } | Self::Sphere { .. } | Self::Mesh { .. } => across(self.normal(x)),
            &Self::Cylinder { axis, .. } => [axis, axis.cross(self.normal(x))],
        }
    }

    /// The unit normal at a point of a surface: of a sphere and a cylinder outward, of a mesh to the side from which
    /// its triangles run counter-clockwise. Zero for a curve.
    #[must_use]
    pub fn normal(&self, x: DVec3) -> DVec3 {
        match self {
            Self::Line { .. } | Self::Circle { .. } => DVec3::ZERO,
            &Self::Plane { normal, .. } => normal,
            &Self::Sphere { centre, .. } => (x - centre).normalize_or(DVec3::Z),
            &Self::Cylinder { point, axis, .. } => {
                (x - point).reject_from_normalized(axis).normalize_or(axis.any_orthonormal_vector())
            }
            Self::Mesh { surface, origin } => surface.normal(x - origin),
        }
    }

    /// II(u, v) for two tangents at `x`.
    #[must_use]
    pub fn second_fundamental_form(&self, x: DVec3, u: DVec3, v: DVec3) -> DVec3 {
        match self {
            Self::Line { .. } | Self::Plane { .. } => DVec3::ZERO,
            &Self::Circle { centre, radius, .. } | &Self::Sphere { centre, radius } => {
                (x - centre) * (-u.dot(v) / (radius * radius))
            }
            &Self::Cylinder { point, axis, radius } => {
                let across = |vector: DVec3| vector.reject_from_normalized(axis);
                across(x - point) * (-across(u).dot(across(v)) / (radius * radius))
            }
            Self::Mesh { surface, origin } => surface.second_fundamental_form(x - origin, u, v),
        }
    }

    /// The support at another place.
    #[must_use]
    pub fn moved(&self, by: DVec3) -> Self {
        let mut moved = self.clone();
        match &mut moved {
            Self::Line { point, .. } | Self::Plane { point, .. } | Self::Cylinder { point, .. } => *point += by,
            Self::Circle { centre, .. } | Self::Sphere { centre, .. } => *centre += by,
            Self::Mesh { origin, .. } => *origin += by,
        }
        moved
    }
}
