//! glTF 2.0, as a binary file or as JSON with the buffer embedded.
//!
//! - Meshes are in metres with Y up, as glTF demands: a client's (x, y, z) with z up becomes (x, z, -y).
//! - Positions are f32 around an origin, the middle of the mesh's bounding box. Every node has the origin as its f64
//!   translation. Survey coordinates of 1e7 therefore keep a ten-millionth of the mesh's size. `asset.extras.origin` is
//!   the same point in the client's unit and axes. With `Origin::Local` the nodes have no translation.
//! - The scene and the node of the surface repeat the extras, because some programs drop those of the asset.
//! - The surface is node 0. A mesh without triangles, such as a cable net, has its vertices as `POINTS` there.
//! - Every line set is a separate node (`LINES`, `LINE_STRIP`) over the same positions, so that a viewer can switch it on
//!   and off. Segments with values have separate positions and carry the value at both ends.
//! - `NORMAL` is area-weighted and has unit length everywhere. If no triangle gives a direction, it is the up axis.
//! - Where three sheets meet, each sheet has its own vertices with their own normals, after all vertices of the mesh.
//! - `_LOWER_BOUND_SLACK` is 1 - |curl A · n| of the field that proves the lower bound of the area. It is 0 where the
//!   bound is tight.
//! - `_MEAN_CURVATURE` is in 1/m (clamped to f32).
//! - A mesh is neutral unless colours are asked for. `COLOR_0` then runs from blue at 0 through green to red, interpolated
//!   linearly between the stops of `asset.extras.color_range`, whose `max` is in the unit of the job's statistics.
//!
//! The document is built from JSON values, because the types of the crate gltf-json keep a node's translation in f32.

use base64::Engine as _;
use plateau_mesh::measure;
use plateau_mesh::{DVec3, Mesh};
use serde_json::{Value, json};

use super::colors::{STOPS, Scale};
use super::{Choices, Error, Origin, sheets};
use crate::archive::{Archive, Contents, LineSet, Lines, Polyline, SegmentValues};
use crate::units::UpAxis;

const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const UNSIGNED_BYTE: u32 = 5121;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
const POINTS: u32 = 0;
const LINES: u32 = 1;
const LINE_STRIP: u32 = 3;
const TRIANGLES: u32 = 4;

/// Smallest supported size of a mesh. Below it, f32 cannot distinguish a ten-millionth of the mesh from zero.
const MIN_EXTENT_METRES: f64 = 1e-30;

/// Linear RGB of a surface without colours, a light blue.
const NEUTRAL: [f64; 4] = [0.55, 0.68, 0.8, 1.0];
/// Factor of the colours at the vertices.
const WHITE: [f64; 4] = [1.0; 4];

/// Writes binary glTF: one file that includes the buffer.
///
/// # Errors
/// Returns [`Error::OutOfRange`] if f32 cannot hold the positions, [`Error::TooLarge`] from 4 GiB, and [`Error::NoQuantity`]
/// if the mesh does not have what it is to be coloured by.
pub fn to_glb(archive: &Archive, choices: Choices) -> Result<Vec<u8>, Error> {
    let (document, buffer) = document(archive, choices)?;
    binary(document, &buffer)
}

/// Writes binary glTF with several meshes in one scene, each at its own coordinates. Each mesh is a named node whose
/// children are its surface and lines, without colours. The node's `extras` are the `asset.extras` of a single file.
///
/// # Errors
/// Returns the errors of [`to_glb`].
pub fn to_glb_scene(title: &str, parts: &[(String, Archive)]) -> Result<Vec<u8>, Error> {
    let mut scene = Scene::default();
    let mut roots = Vec::with_capacity(parts.len());
    for (name, archive) in parts {
        let frame = Frame::new(archive.contents(), Origin::Given)?;
        let children = scene.add(archive.contents(), &frame, &archive.contents().line_sets, None);
        roots.push(scene.nodes.len());
        let extras = asset_extras(archive.contents(), &frame, None);
        scene.nodes.push(json!({ "name": name, "children": children, "extras": extras }));
    }
    let generator = parts.first().map_or("", |(_, archive)| archive.contents().generator.as_str());
    let asset = json!({ "version": "2.0", "generator": generator });
    let (document, buffer) = scene.document(asset, json!({ "name": title, "nodes": roots }));
    binary(document, &buffer)
}

fn binary(mut document: Value, buffer: &[u8]) -> Result<Vec<u8>, Error> {
    document["buffers"] = json!([{ "byteLength": buffer.len() }]);
    let mut text = to_text(&document);
    text.resize(text.len().next_multiple_of(4), b' ');
    let total = 12 + 8 + text.len() + 8 + buffer.len();
    let length = |bytes: usize| u32::try_from(bytes).map_err(|_| Error::TooLarge { format: "GLB" });

    let mut glb = Vec::with_capacity(total);
    glb.extend_from_slice(b"glTF");
    glb.extend_from_slice(&2u32.to_le_bytes());
    glb.extend_from_slice(&length(total)?.to_le_bytes());
    glb.extend_from_slice(&length(text.len())?.to_le_bytes());
    glb.extend_from_slice(b"JSON");
    glb.extend_from_slice(&text);
    glb.extend_from_slice(&length(buffer.len())?.to_le_bytes());
    glb.extend_from_slice(b"BIN\0");
    glb.extend_from_slice(buffer);
    Ok(glb)
}

/// Writes glTF as JSON text with the buffer embedded as a base64 data URI.
///
/// # Errors
/// Returns the errors of [`to_glb`].
pub fn to_gltf_json(archive: &Archive, choices: Choices) -> Result<Vec<u8>, Error> {
    let (mut document, buffer) = document(archive, choices)?;
    let mut uri = String::from("data:application/octet-stream;base64,");
    base64::engine::general_purpose::STANDARD.encode_string(&buffer, &mut uri);
    document["buffers"] = json!([{ "byteLength": buffer.len(), "uri": uri }]);
    Ok(to_text(&document))
}

fn to_text(document: &Value) -> Vec<u8> {
    serde_json::to_vec(document).expect("a JSON value of finite numbers and string keys always has a text")
}

/// Conversion of client coordinates to f32 metres around the origin.
struct Frame {
    origin: DVec3,
    metres: f64,
    up: UpAxis,
    /// Whether the nodes are at the origin instead of at zero.
    placed: bool,
}

impl Frame {
    fn new(contents: &Contents, origin: Origin) -> Result<Self, Error> {
        let metres = contents.unit.metres();
        let extent = contents.extent() * metres;
        let fault = |detail| Err(Error::OutOfRange { format: "glTF", detail });
        if extent > f64::from(f32::MAX) {
            return fault("it is larger than 3e38 m");
        }
        if extent > 0.0 && extent < MIN_EXTENT_METRES {
            return fault("it is smaller than 1e-30 m");
        }
        let frame = Self { origin: contents.origin(), metres, up: contents.up, placed: origin != Origin::Local };
        if !frame.translation().is_finite() {
            return fault("it is too far from the origin");
        }
        Ok(frame)
    }

    /// Rotates a vector from the client's axes to glTF's, with y up.
    fn turn(&self, vector: DVec3) -> DVec3 {
        match self.up {
            UpAxis::Y => vector,
            UpAxis::Z => DVec3::new(vector.x, vector.z, -vector.y),
        }
    }

    fn translation(&self) -> DVec3 {
        if self.placed { self.turn(self.origin) * self.metres } else { DVec3::ZERO }
    }

    fn position(&self, vertex: DVec3) -> [f32; 3] {
        (self.turn(vertex - self.origin) * self.metres).to_array().map(|x| x as f32)
    }
}

/// A buffer that is being built, with its views and accessors.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Appends data with its own view and accessor, and returns the accessor's index. Every item is a multiple of four
    /// bytes, so the data is always aligned as glTF demands.
    fn push(&mut self, data: impl Iterator<Item = [u8; 4]>, target: u32, mut accessor: Value) -> usize {
        let offset = self.bytes.len();
        data.for_each(|word| self.bytes.extend_from_slice(&word));
        accessor["bufferView"] = self.views.len().into();
        self.views.push(
            json!({ "buffer": 0, "byteOffset": offset, "byteLength": self.bytes.len() - offset, "target": target }),
        );
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn positions(&mut self, positions: &[[f32; 3]]) -> usize {
        let start = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        let (min, max) = positions.iter().fold(start, |(min, max), p| {
            ([0, 1, 2].map(|axis| min[axis].min(p[axis])), [0, 1, 2].map(|axis| max[axis].max(p[axis])))
        });
        // The bounds are written as f64, so that their text reads back as exactly the f32 values in the buffer.
        let (min, max) = (min.map(f64::from), max.map(f64::from));
        let accessor =
            json!({ "componentType": FLOAT, "type": "VEC3", "count": positions.len(), "min": min, "max": max });
        self.push(positions.iter().flatten().map(|x| x.to_le_bytes()), ARRAY_BUFFER, accessor)
    }

    fn vectors(&mut self, vectors: impl ExactSizeIterator<Item = [f32; 3]>) -> usize {
        let accessor = json!({ "componentType": FLOAT, "type": "VEC3", "count": vectors.len() });
        self.push(vectors.flat_map(|v| v.map(f32::to_le_bytes)), ARRAY_BUFFER, accessor)
    }

    fn scalars(&mut self, values: impl ExactSizeIterator<Item = f32>) -> usize {
        let accessor = json!({ "componentType": FLOAT, "type": "SCALAR", "count": values.len() });
        self.push(values.map(f32::to_le_bytes), ARRAY_BUFFER, accessor)
    }

    fn colors(&mut self, colors: impl ExactSizeIterator<Item = [u8; 4]>) -> usize {
        let accessor = json!({
            "componentType": UNSIGNED_BYTE, "normalized": true, "type": "VEC4", "count": colors.len()
        });
        self.push(colors, ARRAY_BUFFER, accessor)
    }

    fn indices(&mut self, indices: impl Iterator<Item = u32>) -> usize {
        let start = self.bytes.len();
        let index = self.push(
            indices.map(u32::to_le_bytes),
            ELEMENT_ARRAY_BUFFER,
            json!({ "componentType": UNSIGNED_INT, "type": "SCALAR" }),
        );
        self.accessors[index]["count"] = ((self.bytes.len() - start) / 4).into();
        index
    }
}

/// Returns the document without `buffers`, and the buffer.
fn document(archive: &Archive, choices: Choices) -> Result<(Value, Vec<u8>), Error> {
    let contents = archive.contents();
    let frame = Frame::new(contents, choices.origin)?;
    let line_sets = choices.line_sets(contents);
    let scale = choices.colors.map(|colors| Scale::new(colors, contents, line_sets)).transpose()?;
    let mut scene = Scene::default();
    let nodes = scene.add(contents, &frame, line_sets, scale.as_ref());
    let extras = asset_extras(contents, &frame, scale.as_ref());
    // The scene has everything but the list of the input's vertices, which may be as long as the mesh.
    let mut figures = extras.clone();
    if let Some(figures) = figures.as_object_mut() {
        figures.remove("input_vertices");
    }
    let asset = json!({ "version": "2.0", "generator": contents.generator, "extras": extras });
    Ok(scene.document(asset, json!({ "name": contents.title, "nodes": nodes, "extras": figures })))
}

/// A scene that is being built.
#[derive(Default)]
struct Scene {
    nodes: Vec<Value>,
    meshes: Vec<Value>,
    materials: Vec<Value>,
    buffer: Buffer,
}

impl Scene {
    /// Adds a surface and line sets, and returns their nodes.
    fn add(&mut self, contents: &Contents, frame: &Frame, line_sets: &[LineSet], scale: Option<&Scale>) -> Vec<usize> {
        let Self { nodes, meshes, materials, buffer } = self;
        let first_node = nodes.len();
        let split = sheets::split_by_sheet(&contents.mesh);
        let mesh = split.as_ref().map_or(&contents.mesh, |(mesh, _)| mesh);
        let positions: Vec<[f32; 3]> = mesh.vertices.iter().map(|&vertex| frame.position(vertex)).collect();
        let shared = buffer.positions(&positions);

        // Where sheets meet, each sheet has vertices of its own, which follow the vertices of the mesh.
        let with_split_vertices = |values: &[f64]| -> Vec<f64> {
            let further = split.iter().flat_map(|(_, source)| &source[values.len()..]);
            values.iter().copied().chain(further.map(|&vertex| values[vertex as usize])).collect()
        };
        let mut attributes = json!({ "POSITION": shared });
        if !mesh.triangles.is_empty() {
            attributes["NORMAL"] = buffer.vectors(normals(mesh, frame).into_iter()).into();
        }
        if let Some(curvature) = &contents.mean_curvature {
            let per_metre = |value: f64| (value / frame.metres).min(f64::from(f32::MAX)) as f32;
            let values = with_split_vertices(&curvature.values);
            attributes["_MEAN_CURVATURE"] = buffer.scalars(values.iter().map(|&value| per_metre(value))).into();
        }
        if let Some(certificate) = &contents.certificate {
            let slack = with_split_vertices(&certificate.slack);
            attributes["_LOWER_BOUND_SLACK"] = buffer.scalars(slack.iter().map(|&value| value as f32)).into();
        }
        let base_color = match scale.and_then(|scale| Some((scale, scale.quantity.at_vertices(contents)?))) {
            Some((scale, values)) => {
                let values = with_split_vertices(values);
                attributes["COLOR_0"] = buffer.colors(values.iter().map(|&value| scale.color(value))).into();
                WHITE
            }
            None => NEUTRAL,
        };
        let name = if mesh.triangles.is_empty() { "vertices" } else { "surface" };
        let mut primitive = json!({ "material": materials.len(), "mode": POINTS });
        if !mesh.triangles.is_empty() {
            primitive["indices"] = buffer.indices(mesh.triangles.iter().flatten().copied()).into();
            primitive["mode"] = TRIANGLES.into();
        }
        primitive["attributes"] = attributes;

        let translation = frame.translation().to_array();
        // Plain values only: Assimp 5.2 ends when it copies a node whose extras have a list or an object.
        let [x, y, z] = frame.origin.to_array();
        let place = json!({
            "origin_x": x, "origin_y": y, "origin_z": z,
            "unit": contents.unit.symbol(), "up": contents.up.symbol(),
        });
        nodes.push(json!({ "name": name, "mesh": meshes.len(), "translation": translation, "extras": place }));
        meshes.push(json!({ "name": name, "primitives": [primitive] }));
        materials.push(material(name, base_color, true));
        for set in line_sets {
            let scale = scale.filter(|scale| scale.quantity.along(set).is_some());
            let shared = Shared { accessor: shared, positions: &positions };
            let primitives = line_primitives(set, materials.len(), shared, frame, scale, buffer);
            if primitives.is_empty() {
                continue;
            }
            let name = set.full_name();
            let mut node = json!({ "name": name, "mesh": meshes.len(), "translation": translation });
            if let Lines::Segments { values: Some(values), .. } | Lines::Arrows { values: Some(values), .. } =
                &set.lines
            {
                node["extras"] = json!({ attribute_name(&values.name): { "unit": values.unit } });
            }
            nodes.push(node);
            meshes.push(json!({ "name": name, "primitives": primitives }));
            materials.push(material(&name, if scale.is_some() { WHITE } else { line_color(set) }, false));
        }
        (first_node..nodes.len()).collect()
    }

    fn document(self, asset: Value, scene: Value) -> (Value, Vec<u8>) {
        let document = json!({
            "asset": asset,
            "scene": 0,
            "scenes": [scene],
            "nodes": self.nodes, "meshes": self.meshes, "materials": self.materials,
            "accessors": self.buffer.accessors, "bufferViews": self.buffer.views,
        });
        (document, self.buffer.bytes)
    }
}

fn asset_extras(contents: &Contents, frame: &Frame, scale: Option<&Scale>) -> Value {
    let statistics: Value = serde_json::from_str(&contents.statistics).expect("an archive's statistics are JSON");
    let mut extras = json!({
        "title": contents.title,
        "origin": frame.origin.to_array(), "unit": contents.unit.symbol(), "up": contents.up.symbol(),
        "statistics": statistics, "input_vertices": contents.input_vertices,
    });
    if let Some(Scale { quantity, max, unit }) = scale {
        extras["color_range"] =
            json!({ "quantity": quantity.name(), "unit": unit, "min": 0.0, "max": max, "stops": STOPS });
    }
    extras
}

fn attribute_name(name: &str) -> String {
    format!("_{}", name.to_ascii_uppercase())
}

/// Positions that the surface and the lines along it share.
#[derive(Clone, Copy)]
struct Shared<'a> {
    accessor: usize,
    positions: &'a [[f32; 3]],
}

/// Returns the primitives of a line set, or none for an empty set. The caller adds the material. `scale` is the scale of the
/// set's own values.
fn line_primitives(
    set: &LineSet,
    material: usize,
    shared: Shared<'_>,
    frame: &Frame,
    scale: Option<&Scale>,
    buffer: &mut Buffer,
) -> Vec<Value> {
    match &set.lines {
        Lines::Polylines(polylines) => polylines
            .iter()
            .map(|line| {
                let indices = buffer.indices(along(line));
                let attributes = json!({ "POSITION": shared.accessor });
                json!({ "attributes": attributes, "indices": indices, "material": material, "mode": LINE_STRIP })
            })
            .collect(),
        Lines::Segments { pairs, .. } if pairs.is_empty() => Vec::new(),
        Lines::Segments { pairs, values: None } => {
            let indices = buffer.indices(pairs.iter().flatten().copied());
            let attributes = json!({ "POSITION": shared.accessor });
            vec![json!({ "attributes": attributes, "indices": indices, "material": material, "mode": LINES })]
        }
        Lines::Segments { pairs, values: Some(values) } => {
            let ends: Vec<[f32; 3]> = pairs.iter().flatten().map(|&vertex| shared.positions[vertex as usize]).collect();
            own_lines(&ends, Some(values), material, scale, buffer)
        }
        Lines::Arrows { ends, .. } if ends.is_empty() => Vec::new(),
        Lines::Arrows { ends, values } => {
            let ends: Vec<[f32; 3]> =
                ends.iter().flatten().map(|&end| frame.position(DVec3::from_array(end))).collect();
            own_lines(&ends, values.as_ref(), material, scale, buffer)
        }
    }
}

/// Returns the primitive of lines with their own positions, two for each line, and a value at both ends of each.
fn own_lines(
    ends: &[[f32; 3]],
    values: Option<&SegmentValues>,
    material: usize,
    scale: Option<&Scale>,
    buffer: &mut Buffer,
) -> Vec<Value> {
    let mut attributes = json!({ "POSITION": buffer.positions(ends) });
    if let Some(values) = values {
        let at_ends: Vec<f32> = values.values.iter().flat_map(|&value| [clamped(value); 2]).collect();
        attributes[attribute_name(&values.name)] = buffer.scalars(at_ends.into_iter()).into();
        if let Some(scale) = scale {
            let at_ends: Vec<[u8; 4]> = values.values.iter().flat_map(|&value| [scale.color(value); 2]).collect();
            attributes["COLOR_0"] = buffer.colors(at_ends.into_iter()).into();
        }
    }
    vec![json!({ "attributes": attributes, "material": material, "mode": LINES })]
}

fn along(line: &Polyline) -> impl Iterator<Item = u32> {
    let back = line.closed.then(|| line.vertices.first().copied()).flatten();
    line.vertices.iter().copied().chain(back)
}

fn clamped(value: f64) -> f32 {
    value.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

fn material(name: &str, base_color: [f64; 4], double_sided: bool) -> Value {
    json!({
        "name": name, "doubleSided": double_sided,
        "pbrMetallicRoughness": { "baseColorFactor": base_color, "metallicFactor": 0.0, "roughnessFactor": 0.9 },
    })
}

fn line_color(set: &LineSet) -> [f64; 4] {
    match set.name.as_str() {
        "boundaries" | "directrices" => [0.01, 0.01, 0.015, 1.0],
        "bridges" => [0.2, 0.22, 0.25, 1.0],
        _ => [0.35, 0.12, 0.02, 1.0],
    }
}

/// Returns unit vertex normals in glTF's axes. Within the sizes that [`Frame`] accepts, no square overflows or becomes
/// zero.
fn normals(mesh: &Mesh, frame: &Frame) -> Vec<[f32; 3]> {
    let mut normals = measure::vertex_normals(mesh);
    if normals.contains(&DVec3::ZERO) {
        replace_missing(mesh, &mut normals);
    }
    normals
        .into_iter()
        .map(|normal| {
            let turned = if normal == DVec3::ZERO { DVec3::Y } else { frame.turn(normal) };
            turned.to_array().map(|x| x as f32)
        })
        .collect()
}

/// Replaces zero normals, which occur where the triangles' normals cancel out (a full fold). The first triangle at the
/// vertex that has a direction gives the normal.
fn replace_missing(mesh: &Mesh, normals: &mut [DVec3]) {
    for &triangle in &mesh.triangles {
        let normal = measure::double_area_vector(mesh.corners(triangle)).normalize_or_zero();
        for vertex in triangle {
            let missing = &mut normals[vertex as usize];
            if *missing == DVec3::ZERO {
                *missing = normal;
            }
        }
    }
}
