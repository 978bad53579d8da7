//! The lines and surfaces on which a tensile structure slides, as a request has them.

use crate::common::{self, Point};
use plateau_equilibrium::Support;
use plateau_equilibrium::support::{Circle, Cylinder, Mesh, Plane, Sphere, StraightLine, Torus};
use plateau_mesh::DVec3;
use plateau_strict_json::bounds::{List, OneOf, Positive, given};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A line or surface to slide on, given by exactly one of its fields. Edges slide on surfaces only. Directions need no
/// unit length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
pub struct Guide {
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "LineGuide")]
    pub line: Option<LineGuide>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "CircleGuide")]
    pub circle: Option<CircleGuide>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "PlaneGuide")]
    pub plane: Option<PlaneGuide>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "SphereGuide")]
    pub sphere: Option<SphereGuide>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "CylinderGuide")]
    pub cylinder: Option<CylinderGuide>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "TorusGuide")]
    pub torus: Option<TorusGuide>,
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "MeshGuide")]
    pub mesh: Option<MeshGuide>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineGuide {
    pub point: Point,
    pub direction: Point,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CircleGuide {
    pub centre: Point,
    /// Normal of the circle's plane.
    pub axis: Point,
    pub radius: Positive,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlaneGuide {
    pub point: Point,
    pub normal: Point,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereGuide {
    pub centre: Point,
    pub radius: Positive,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CylinderGuide {
    /// A point of the axis.
    pub point: Point,
    pub axis: Point,
    pub radius: Positive,
}

/// A torus, such as a ring beam of round tube.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TorusGuide {
    pub centre: Point,
    pub axis: Point,
    /// Radius of the circle inside the tube.
    pub radius: Positive,
    /// Radius of the tube, below `radius`.
    pub tube_radius: Positive,
}

/// A smooth surface along the client's own mesh. Neighbouring triangles are oriented alike.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshGuide {
    pub vertices: List<Point, 3>,
    /// Vertex indices of each triangle, counted from 0.
    #[schemars(inner(inner(range(min = 0, max = 4_294_967_295u32))))]
    pub triangles: List<[u32; 3], 1>,
    /// Length within which the mesh's edges are rounded, because a film cannot slide over a sharp edge. For a mesh of a
    /// curved surface two to three times the length of its edges.
    pub rounding: Positive,
}

impl MeshGuide {
    /// Returns the number of vertices or of triangles, whichever is larger.
    pub(super) fn size(&self) -> usize {
        self.vertices.len().max(self.triangles.len())
    }
}

impl OneOf for Guide {
    fn given(&self) -> usize {
        let given = [
            self.line.is_some(),
            self.circle.is_some(),
            self.plane.is_some(),
            self.sphere.is_some(),
            self.cylinder.is_some(),
            self.torus.is_some(),
            self.mesh.is_some(),
        ];
        given.into_iter().filter(|given| *given).count()
    }
}

impl Guide {
    /// Converts the guide, which has exactly one member. An error consists of its place below the guide and its text.
    pub(super) fn to_geometry(&self) -> Result<Arc<dyn Support>, (String, String)> {
        let unit = |vector: Point, field: &str| {
            let error = || (field.to_owned(), "must be a vector with a length".to_owned());
            DVec3::from_array(vector).try_normalize().ok_or_else(error)
        };
        let place = DVec3::from_array;
        if let Some(LineGuide { point, direction }) = self.line {
            let direction = unit(direction, "line/direction")?;
            return Ok(Arc::new(StraightLine { point: place(point), direction }));
        }
        if let Some(CircleGuide { centre, axis, radius }) = self.circle {
            return Ok(Arc::new(Circle {
                centre: place(centre),
                axis: unit(axis, "circle/axis")?,
                radius: radius.get(),
            }));
        }
        if let Some(SphereGuide { centre, radius }) = self.sphere {
            return Ok(Arc::new(Sphere { centre: place(centre), radius: radius.get() }));
        }
        if let Some(CylinderGuide { point, axis, radius }) = self.cylinder {
            return Ok(Arc::new(Cylinder {
                point: place(point),
                axis: unit(axis, "cylinder/axis")?,
                radius: radius.get(),
            }));
        }
        if let Some(TorusGuide { centre, axis, radius, tube_radius }) = self.torus {
            if tube_radius.get() >= radius.get() {
                let detail = "must be below `radius`, because the tube would run into itself";
                return Err(("torus/tube_radius".into(), detail.into()));
            }
            return Ok(Arc::new(Torus {
                centre: place(centre),
                axis: unit(axis, "torus/axis")?,
                radius: radius.get(),
                tube_radius: tube_radius.get(),
            }));
        }
        if let Some(MeshGuide { vertices, triangles, rounding }) = &self.mesh {
            let mesh = Mesh::new(&common::points(vertices), triangles, rounding.get())
                .map_err(|error| (format!("mesh{}", error.place), error.detail))?;
            return Ok(Arc::new(mesh));
        }
        let PlaneGuide { point, normal } = self.plane.ok_or_else(|| ("plane".into(), "is required".into()))?;
        Ok(Arc::new(Plane { point: place(point), normal: unit(normal, "plane/normal")? }))
    }
}
