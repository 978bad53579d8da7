//! The mesh as JSON in the client's axes and unit, for programs that read no mesh format. Every number reads back as
//! exactly the same f64. The type `plateau_engine::mesh::Mesh` documents the form.

use plateau_mesh::DVec3;
use serde::Serialize;
use std::collections::BTreeMap;

use super::{Choices, Error};
use crate::archive::{Archive, LineSet, Lines, MEAN_CURVATURE};

#[derive(Serialize)]
struct Mesh<'a> {
    unit: &'static str,
    up: &'static str,
    /// Point that the vertices are relative to.
    origin: [f64; 3],
    vertices: Vec<[f64; 3]>,
    triangles: &'a [[u32; 3]],
    attributes: BTreeMap<&'static str, &'a [f64]>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    triangle_attributes: BTreeMap<&'a str, &'a [f64]>,
    lines: Vec<LinesOf<'a>>,
    input_vertices: &'a [Vec<u32>],
}

#[derive(Serialize)]
struct LinesOf<'a> {
    name: String,
    paths: Vec<Vec<u32>>,
    arrows: Vec<[[f64; 3]; 2]>,
    values: Option<Values<'a>>,
}

#[derive(Serialize)]
struct Values<'a> {
    name: &'a str,
    unit: &'a str,
    values: &'a [f64],
}

/// Writes the vertices and triangles in archive order, and the lines.
///
/// # Errors
/// Returns [`Error::Unwritable`], which valid archives never cause.
pub fn to_json(archive: &Archive, choices: Choices) -> Result<Vec<u8>, Error> {
    let contents = archive.contents();
    let shift = choices.shift(contents);
    // The published form has this attribute of the vertices and no other.
    let curvature = contents.at_vertices(MEAN_CURVATURE).map(|curvature| (MEAN_CURVATURE, curvature.values.as_slice()));
    let mesh = Mesh {
        unit: contents.unit.symbol(),
        up: contents.up.symbol(),
        origin: shift.to_array(),
        vertices: contents.mesh.vertices.iter().map(|&vertex| (vertex - shift).to_array()).collect(),
        triangles: &contents.mesh.triangles,
        attributes: curvature.into_iter().collect(),
        triangle_attributes: contents.triangle_attributes.iter().map(|of| (&*of.name, &*of.values)).collect(),
        lines: choices.line_sets(contents).iter().map(|set| lines_of(set, shift)).collect(),
        input_vertices: &contents.input_vertices,
    };
    serde_json::to_vec(&mesh).map_err(|_| Error::Unwritable { format: "JSON" })
}

/// Returns each line as the vertices along it, and arrows as their two ends. A closed line ends with its first vertex.
fn lines_of(set: &LineSet, shift: DVec3) -> LinesOf<'_> {
    let (paths, arrows) = match &set.lines {
        Lines::Polylines(polylines) => {
            let path = |line: &crate::Polyline| -> Vec<u32> {
                let back = line.closed.then(|| line.vertices.first().copied()).flatten();
                line.vertices.iter().copied().chain(back).collect()
            };
            (polylines.iter().map(path).collect(), Vec::new())
        }
        Lines::Segments(pairs) => (pairs.iter().map(|pair| pair.to_vec()).collect(), Vec::new()),
        Lines::Arrows(ends) => {
            let place = |end: [f64; 3]| (DVec3::from_array(end) - shift).to_array();
            (Vec::new(), ends.iter().map(|ends| ends.map(place)).collect())
        }
    };
    let values = set.attributes.first();
    let values = values.map(|known| Values { name: &known.name, unit: &known.unit, values: &known.values });
    LinesOf { name: set.full_name(), paths, arrows, values }
}
