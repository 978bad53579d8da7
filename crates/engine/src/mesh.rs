//! A mesh as JSON, as `plateau_archive::formats::json` writes it.

use crate::common::Point;
use plateau_archive::units::{Unit, UpAxis};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A mesh in the axes and the unit of its request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    pub unit: Unit,
    pub up: UpAxis,
    /// Point that the vertices are relative to. It is zero unless the file was asked for with `origin=local`.
    pub origin: Point,
    /// The request's own points come first, in their order.
    pub vertices: Vec<Point>,
    /// Three indices of vertices for each triangle, counted from 0. A cable net has none.
    pub triangles: Vec<[u32; 3]>,
    pub attributes: MeshAttributes,
    /// Numbers for each triangle, by name. Only tensile structures have them: the stress with which the forces balance
    /// at every vertex. `stress_min` and `stress_max` are the principal stresses, a force per length in the request's
    /// units. `stress_max_x`, `stress_max_y` and `stress_max_z` are the unit vector along the largest one.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub triangle_attributes: BTreeMap<String, Vec<f64>>,
    pub lines: Vec<MeshLines>,
    /// For each polyline of the request, the vertices that its points became.
    pub input_vertices: Vec<Vec<u32>>,
}

/// Numbers at the vertices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshAttributes {
    /// Unsigned mean curvature of each vertex in 1/unit. Only minimal surfaces have it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Vec<f64>")]
    pub mean_curvature: Option<Vec<f64>>,
}

/// Lines along the mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshLines {
    /// `boundaries`, `junctions`, `directrices`, `bridges`, `members lattice`, `members rim`, `reactions`, or `cables`
    /// with the cable's name, such as `cables ridge`.
    pub name: String,
    /// Each line as the vertices along it. A closed line ends with its first vertex.
    pub paths: Vec<Vec<u32>>,
    /// Straight lines whose ends are no vertices of the mesh, such as those of `reactions`: two points each.
    pub arrows: Vec<[Point; 2]>,
    /// A number for each line, such as its length. Null if the lines have none.
    pub values: Option<LineValues>,
}

/// A number for each line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineValues {
    pub name: String,
    /// Empty for plain numbers.
    pub unit: String,
    pub values: Vec<f64>,
}
