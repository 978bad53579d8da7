//! glTF 2.0, as a binary file or as JSON with the buffer embedded.
//!
//! - Meshes are in metres with Y up, as glTF demands: a client's (x, y, z) with z up becomes (x, z, -y).
//! - Positions are f32 around an origin, the middle of the mesh's bounding box. Every node has the origin as its f64
//!   translation. Therefore even survey coordinates of 1e7 are exact to a ten-millionth of the mesh's size.
//!   `asset.extras.origin` is the same point in the client's unit and axes. With `Origin::Local` the nodes have no
//!   translation.
//! - The scene and the node of the surface repeat the extras, because some programs drop those of the asset.
//! - The surface is node 0. A mesh without triangles, such as a cable net, has its vertices as `POINTS` there.
//! - Every line set is a separate node (`LINES`, `LINE_STRIP`) over the same positions, so that a viewer can switch it
//!   on and off. Segments with values have separate positions and carry the value at both ends.
//! - `NORMAL` is area-weighted and has unit length everywhere. If no triangle gives a direction, it is the up axis.
//! - Where three sheets meet, each sheet has its own vertices with their own normals, after all vertices of the mesh.
//!   Where triangles have colours, a vertex between two colours is there once for each, with one normal.
//! - `_LOWER_BOUND_SLACK` is 1 - |curl A · n| of the field that proves the lower bound of the area. It is 0 where the
//!   bound is tight.
//! - `_MEAN_CURVATURE` is in 1/m. Attributes are clamped to f32.
//! - A mesh is neutral unless colours are asked for. `COLOR_0` then runs from blue at 0 through green to red,
//!   interpolated linearly between the stops of `asset.extras.color_range`, whose `max` is in the unit of the job's
//!   statistics.
//!
//! The document is built from the types of the crate gltf. They keep a node's translation in f32, so the translations
//! are put into the JSON value of the finished document.

use std::borrow::Cow;
use std::collections::BTreeMap;

use base64::Engine as _;
use gltf::binary::{Glb, Header};
use gltf::json::accessor::{Accessor, ComponentType, GenericComponentType, Type};
use gltf::json::buffer::{Buffer, Target, View};
use gltf::json::extras::RawValue;
use gltf::json::material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked::{self, Valid};
use gltf::json::{Asset, Extras, Index, Material, Node, Root};
use plateau_mesh::measure;
use plateau_mesh::{DVec3, Mesh};
use serde::Serialize;
use serde_json::{Value, json};

use super::colors::{STOPS, Scale};
use super::{Choices, Error, Origin, sheets};
use crate::archive::{Archive, Attribute, Contents, LineSet, Lines, Polyline};
use crate::units::UpAxis;

/// Smallest supported size of a mesh. Below it, f32 cannot distinguish a ten-millionth of the mesh from zero.
const MIN_EXTENT_METRES: f64 = 1e-30;

/// Linear RGB of a surface without colours, a light blue.
const NEUTRAL: [f32; 4] = [0.55, 0.68, 0.8, 1.0];
/// Base colour of a surface with colours at its vertices. glTF multiplies both.
const WHITE: [f32; 4] = [1.0; 4];

/// Writes binary glTF: one file that includes the buffer.
///
/// # Errors
/// Returns [`Error::OutOfRange`] if f32 cannot hold the positions, [`Error::TooLarge`] from 4 GiB, and
/// [`Error::NoQuantity`] if the mesh lacks the quantity by which it is to be coloured.
pub fn to_glb(archive: &Archive, choices: Choices) -> Result<Vec<u8>, Error> {
    scene(archive, choices)?.into_glb()
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
        let coordinates = GltfCoordinates::new(archive.contents(), Origin::Given)?;
        let children = scene.add(archive.contents(), &coordinates, &archive.contents().line_sets, None);
        let extras = raw(&AssetExtras::new(archive.contents(), &coordinates, None));
        let node = Node { name: Some(name.clone()), children: Some(children), extras, ..Node::default() };
        roots.push(scene.node(node, None));
    }
    let generator = parts.first().map_or("", |(_, archive)| archive.contents().generator.as_str());
    scene.finish(generator, None, title, roots, None);
    scene.into_glb()
}

/// Writes glTF as JSON text with the buffer embedded as a base64 data URI.
///
/// # Errors
/// Returns the errors of [`to_glb`].
pub fn to_gltf_json(archive: &Archive, choices: Choices) -> Result<Vec<u8>, Error> {
    let scene = scene(archive, choices)?;
    let mut uri = String::from("data:application/octet-stream;base64,");
    base64::engine::general_purpose::STANDARD.encode_string(&scene.bytes, &mut uri);
    Ok(scene.document(Some(uri)))
}

/// Conversion of client coordinates to f32 metres around the origin.
struct GltfCoordinates {
    origin: DVec3,
    metres: f64,
    up: UpAxis,
    /// Whether the nodes are translated to the origin. If not, they have no translation.
    placed: bool,
}

impl GltfCoordinates {
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
        let coordinates = Self { origin: contents.origin(), metres, up: contents.up, placed: origin != Origin::Local };
        if !coordinates.translation().is_finite() {
            return fault("it is too far from the origin");
        }
        Ok(coordinates)
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

fn scene(archive: &Archive, choices: Choices) -> Result<Scene, Error> {
    let contents = archive.contents();
    let coordinates = GltfCoordinates::new(contents, choices.origin)?;
    let line_sets = choices.line_sets(contents);
    let scale = choices.colors.map(|colors| Scale::new(colors, contents, line_sets)).transpose()?;
    let mut scene = Scene::default();
    let nodes = scene.add(contents, &coordinates, line_sets, scale.as_ref());
    let extras = AssetExtras::new(contents, &coordinates, scale.as_ref());
    // The scene repeats all extras except the list of the input's vertices, which may be as long as the mesh.
    let of_the_scene = AssetExtras { input_vertices: None, ..extras };
    scene.finish(&contents.generator, raw(&extras), &contents.title, nodes, raw(&of_the_scene));
    Ok(scene)
}

/// A file that is being built: its document and its only buffer.
#[derive(Default)]
struct Scene {
    root: Root,
    bytes: Vec<u8>,
    /// Translation of each node.
    translations: Vec<Option<DVec3>>,
}

impl Scene {
    /// Adds a surface and line sets, and returns their nodes.
    fn add(
        &mut self,
        contents: &Contents,
        coordinates: &GltfCoordinates,
        line_sets: &[LineSet],
        scale: Option<&Scale>,
    ) -> Vec<Index<Node>> {
        let by_sheet = sheets::split_by_sheet(&contents.mesh);
        let sheets = by_sheet.as_ref().map_or(&contents.mesh, |(mesh, _)| mesh);
        let at_triangles = scale.and_then(|scale| scale.quantity.at_triangles(contents));
        let by_color = at_triangles.map(|values| sheets::split_by_value(sheets, &values));
        let mesh = by_color.as_ref().map_or(sheets, |(mesh, ..)| mesh);
        let positions: Vec<[f32; 3]> = mesh.vertices.iter().map(|&vertex| coordinates.position(vertex)).collect();
        let shared = Shared { accessor: self.positions(&positions), positions: &positions };

        // Where sheets meet, each sheet has vertices of its own, which follow the vertices of the mesh. Those of
        // further colours follow these.
        let with_split_vertices = |values: &[f64]| -> Vec<f64> {
            let mut values = values.to_vec();
            let sources = by_sheet.iter().map(|(_, source)| source).chain(by_color.iter().map(|(_, source, _)| source));
            for source in sources {
                extend_by_sources(&mut values, source);
            }
            values
        };
        let mut attributes = BTreeMap::from([(Valid(Semantic::Positions), shared.accessor)]);
        if !mesh.triangles.is_empty() {
            let mut normals = normals(sheets, coordinates);
            if let Some((_, source, _)) = &by_color {
                extend_by_sources(&mut normals, source);
            }
            attributes.insert(Valid(Semantic::Normals), self.vectors(&normals));
        }
        for attribute in &contents.vertex_attributes {
            // The unit of length is the metre in glTF, so values per unit of length are per metre.
            let is_per_length = attribute.unit == format!("1/{}", contents.unit.symbol());
            let unit = if is_per_length { coordinates.metres } else { 1.0 };
            let values = with_split_vertices(&attribute.values).into_iter().map(|value| clamped(value / unit));
            attributes.insert(custom(&attribute.name), self.scalars(values));
        }
        let colored = scale.and_then(|scale| {
            let of_vertices = || Some(with_split_vertices(&scale.quantity.at_vertices(contents)?.values));
            let values = by_color.as_ref().map(|(_, _, values)| values.clone()).or_else(of_vertices)?;
            Some((scale, values))
        });
        let base_color = match colored {
            Some((scale, values)) => {
                let colors = self.colors(values.into_iter().map(|value| scale.color(value)));
                attributes.insert(Valid(Semantic::Colors(0)), colors);
                WHITE
            }
            None => NEUTRAL,
        };
        let (name, mode, indices) = if mesh.triangles.is_empty() {
            ("vertices", Mode::Points, None)
        } else {
            ("surface", Mode::Triangles, Some(self.indices(mesh.triangles.iter().flatten().copied())))
        };

        // The extras have plain values only, because Assimp 5.2 ends when it copies a node whose extras have a list or
        // an object.
        let [x, y, z] = coordinates.origin.to_array();
        let place = json!({
            "origin_x": x, "origin_y": y, "origin_z": z,
            "unit": contents.unit.symbol(), "up": contents.up.symbol(),
        });
        let material = self.material(name, base_color, true);
        let surface = primitive(mode, attributes, indices, material);
        let mut nodes = vec![self.placed_mesh(name, vec![surface], coordinates, raw(&place))];
        for set in line_sets {
            let scale = scale.and_then(|scale| Some((scale, scale.quantity.along(set)?)));
            let name = set.full_name();
            // Number of the material that is added below, after the primitives, because an empty set gets no material.
            let material = Index::new(self.root.materials.len() as u32);
            let primitives = self.line_primitives(set, material, shared, coordinates, scale);
            if primitives.is_empty() {
                continue;
            }
            self.material(&name, if scale.is_some() { WHITE } else { line_color(set) }, false);
            let units: serde_json::Map<String, Value> = set
                .attributes
                .iter()
                .map(|attribute| (custom(&attribute.name).to_string(), json!({ "unit": attribute.unit })))
                .collect();
            let extras = if units.is_empty() { None } else { raw(&units) };
            nodes.push(self.placed_mesh(&name, primitives, coordinates, extras));
        }
        nodes
    }

    /// Adds a node at the origin of the coordinates with a mesh of these primitives. Both have the same name.
    fn placed_mesh(
        &mut self,
        name: &str,
        primitives: Vec<Primitive>,
        coordinates: &GltfCoordinates,
        extras: Extras,
    ) -> Index<Node> {
        let mesh =
            gltf::json::Mesh { name: Some(name.into()), primitives, weights: None, extensions: None, extras: None };
        let mesh = Some(Index::push(&mut self.root.meshes, mesh));
        let node = Node { name: Some(name.into()), mesh, extras, ..Node::default() };
        self.node(node, Some(coordinates.translation()))
    }

    fn node(&mut self, node: Node, translation: Option<DVec3>) -> Index<Node> {
        self.translations.push(translation);
        Index::push(&mut self.root.nodes, node)
    }

    fn material(&mut self, name: &str, base_color: [f32; 4], double_sided: bool) -> Index<Material> {
        let pbr_metallic_roughness = PbrMetallicRoughness {
            base_color_factor: PbrBaseColorFactor(base_color),
            metallic_factor: StrengthFactor(0.0),
            roughness_factor: StrengthFactor(0.9),
            ..PbrMetallicRoughness::default()
        };
        let name = Some(name.into());
        let material = Material { name, double_sided, pbr_metallic_roughness, ..Material::default() };
        Index::push(&mut self.root.materials, material)
    }

    /// Returns the primitives of a line set, or none for an empty set. `scale` is a scale and the attribute that it
    /// colours.
    fn line_primitives(
        &mut self,
        set: &LineSet,
        material: Index<Material>,
        shared: Shared<'_>,
        coordinates: &GltfCoordinates,
        scale: Option<(&Scale, &Attribute)>,
    ) -> Vec<Primitive> {
        let at_shared = || BTreeMap::from([(Valid(Semantic::Positions), shared.accessor)]);
        match &set.lines {
            Lines::Polylines(polylines) => polylines
                .iter()
                .map(|line| primitive(Mode::LineStrip, at_shared(), Some(self.indices(along(line))), material))
                .collect(),
            Lines::Segments(pairs) if pairs.is_empty() => Vec::new(),
            Lines::Segments(pairs) if set.attributes.is_empty() => {
                let indices = self.indices(pairs.iter().flatten().copied());
                vec![primitive(Mode::Lines, at_shared(), Some(indices), material)]
            }
            Lines::Segments(pairs) => {
                let ends: Vec<[f32; 3]> =
                    pairs.iter().flatten().map(|&vertex| shared.positions[vertex as usize]).collect();
                vec![self.own_lines(&ends, &set.attributes, material, scale)]
            }
            Lines::Arrows(ends) if ends.is_empty() => Vec::new(),
            Lines::Arrows(ends) => {
                let ends: Vec<[f32; 3]> =
                    ends.iter().flatten().map(|&end| coordinates.position(DVec3::from_array(end))).collect();
                vec![self.own_lines(&ends, &set.attributes, material, scale)]
            }
        }
    }

    /// Returns the primitive of lines that share no positions with the surface. Each line has two positions of its own,
    /// and its values at both.
    fn own_lines(
        &mut self,
        ends: &[[f32; 3]],
        of_lines: &[Attribute],
        material: Index<Material>,
        scale: Option<(&Scale, &Attribute)>,
    ) -> Primitive {
        let mut attributes = BTreeMap::from([(Valid(Semantic::Positions), self.positions(ends))]);
        let at_ends =
            |attribute: &Attribute| -> Vec<f64> { attribute.values.iter().flat_map(|&value| [value; 2]).collect() };
        for attribute in of_lines {
            let values = at_ends(attribute).into_iter().map(clamped);
            attributes.insert(custom(&attribute.name), self.scalars(values));
        }
        if let Some((scale, attribute)) = scale {
            let colors = self.colors(at_ends(attribute).into_iter().map(|value| scale.color(value)));
            attributes.insert(Valid(Semantic::Colors(0)), colors);
        }
        primitive(Mode::Lines, attributes, None, material)
    }

    /// Appends data with its own view and accessor. Every item is a multiple of four bytes, so the data is always
    /// aligned as glTF demands.
    fn push(
        &mut self,
        data: impl Iterator<Item = [u8; 4]>,
        target: Target,
        component: ComponentType,
        type_: Type,
    ) -> Index<Accessor> {
        let offset = self.bytes.len();
        data.for_each(|word| self.bytes.extend_from_slice(&word));
        let length = self.bytes.len() - offset;
        let view = View {
            buffer: Index::new(0),
            byte_offset: Some(offset.into()),
            byte_length: length.into(),
            byte_stride: None,
            target: Some(Valid(target)),
            name: None,
            extensions: None,
            extras: None,
        };
        let accessor = Accessor {
            buffer_view: Some(Index::push(&mut self.root.buffer_views, view)),
            byte_offset: None,
            component_type: Valid(GenericComponentType(component)),
            type_: Valid(type_),
            count: (length / (component.size() * type_.multiplicity())).into(),
            normalized: false,
            min: None,
            max: None,
            sparse: None,
            name: None,
            extensions: None,
            extras: None,
        };
        Index::push(&mut self.root.accessors, accessor)
    }

    fn positions(&mut self, positions: &[[f32; 3]]) -> Index<Accessor> {
        let start = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        let (min, max) = positions.iter().fold(start, |(min, max), p| {
            ([0, 1, 2].map(|axis| min[axis].min(p[axis])), [0, 1, 2].map(|axis| max[axis].max(p[axis])))
        });
        let index = self.vectors(positions);
        let accessor = &mut self.root.accessors[index.value()];
        // The bounds are written as f64, so that their text reads back as exactly the f32 values in the buffer.
        accessor.min = Some(json!(min.map(f64::from)));
        accessor.max = Some(json!(max.map(f64::from)));
        index
    }

    fn vectors(&mut self, vectors: &[[f32; 3]]) -> Index<Accessor> {
        let words = vectors.iter().flatten().map(|x| x.to_le_bytes());
        self.push(words, Target::ArrayBuffer, ComponentType::F32, Type::Vec3)
    }

    fn scalars(&mut self, values: impl Iterator<Item = f32>) -> Index<Accessor> {
        self.push(values.map(f32::to_le_bytes), Target::ArrayBuffer, ComponentType::F32, Type::Scalar)
    }

    fn colors(&mut self, colors: impl Iterator<Item = [u8; 4]>) -> Index<Accessor> {
        let index = self.push(colors, Target::ArrayBuffer, ComponentType::U8, Type::Vec4);
        self.root.accessors[index.value()].normalized = true;
        index
    }

    fn indices(&mut self, indices: impl Iterator<Item = u32>) -> Index<Accessor> {
        self.push(indices.map(u32::to_le_bytes), Target::ElementArrayBuffer, ComponentType::U32, Type::Scalar)
    }

    /// Adds the asset, the buffer and the scene.
    fn finish(&mut self, generator: &str, asset: Extras, title: &str, nodes: Vec<Index<Node>>, extras: Extras) {
        self.root.asset = Asset { generator: Some(generator.into()), extras: asset, ..Asset::default() };
        let byte_length = self.bytes.len().into();
        self.root.buffers = vec![Buffer { byte_length, uri: None, name: None, extensions: None, extras: None }];
        let scene = gltf::json::Scene { name: Some(title.into()), nodes, extras, extensions: None };
        self.root.scene = Some(Index::push(&mut self.root.scenes, scene));
    }

    /// Returns the text of the document with the translations of its nodes in f64. `uri` is the buffer as a data URI,
    /// if the buffer does not follow as a binary part.
    fn document(&self, uri: Option<String>) -> Vec<u8> {
        const WRITABLE: &str = "a document of finite numbers and string keys always has a text";
        let text = serde_json::to_vec(&self.root).expect(WRITABLE);
        // Only the nodes are read, because long statistics in the extras would take longer than a small mesh.
        let mut parts: BTreeMap<&str, &RawValue> = serde_json::from_slice(&text).expect("the text is a JSON object");
        let mut nodes = serde_json::to_value(&self.root.nodes).expect(WRITABLE);
        for (node, translation) in self.translations.iter().enumerate() {
            if let Some(translation) = translation {
                nodes[node]["translation"] = json!(translation.to_array());
            }
        }
        let nodes = raw(&nodes);
        let buffers = uri.and_then(|uri| raw(&json!([{ "byteLength": self.bytes.len(), "uri": uri }])));
        parts.extend(nodes.as_deref().map(|nodes| ("nodes", nodes)));
        parts.extend(buffers.as_deref().map(|buffers| ("buffers", buffers)));
        serde_json::to_vec(&parts).expect(WRITABLE)
    }

    fn into_glb(self) -> Result<Vec<u8>, Error> {
        let text = self.document(None);
        let length = 12 + 8 + text.len().next_multiple_of(4) + 8 + self.bytes.len();
        let header = Header {
            magic: *b"glTF",
            version: 2,
            length: u32::try_from(length).map_err(|_| Error::TooLarge { format: "GLB" })?,
        };
        let glb = Glb { header, json: Cow::Owned(text), bin: Some(Cow::Owned(self.bytes)) };
        glb.to_vec().map_err(|_| Error::Unwritable { format: "GLB" })
    }
}

fn primitive(
    mode: Mode,
    attributes: BTreeMap<Checked<Semantic>, Index<Accessor>>,
    indices: Option<Index<Accessor>>,
    material: Index<Material>,
) -> Primitive {
    let (mode, material) = (Valid(mode), Some(material));
    Primitive { attributes, indices, material, mode, targets: None, extensions: None, extras: None }
}

/// Returns the semantic of an attribute that glTF does not define, such as `_MEAN_CURVATURE`.
fn custom(name: &str) -> Checked<Semantic> {
    Valid(Semantic::Extras(name.to_ascii_uppercase()))
}

fn raw(extras: &impl Serialize) -> Option<Box<RawValue>> {
    serde_json::value::to_raw_value(extras).ok()
}

/// Extras of a file's asset.
#[derive(Clone, Copy, Serialize)]
struct AssetExtras<'a> {
    title: &'a str,
    origin: [f64; 3],
    unit: &'a str,
    up: &'a str,
    statistics: &'a RawValue,
    #[serde(skip_serializing_if = "Option::is_none")]
    input_vertices: Option<&'a [Vec<u32>]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    color_range: Option<ColorRange<'a>>,
}

#[derive(Clone, Copy, Serialize)]
struct ColorRange<'a> {
    quantity: &'a str,
    unit: &'a str,
    min: f64,
    max: f64,
    stops: [[f64; 3]; STOPS.len()],
}

impl<'a> AssetExtras<'a> {
    fn new(contents: &'a Contents, coordinates: &GltfCoordinates, scale: Option<&'a Scale>) -> Self {
        Self {
            title: &contents.title,
            origin: coordinates.origin.to_array(),
            unit: contents.unit.symbol(),
            up: contents.up.symbol(),
            statistics: serde_json::from_str(&contents.statistics).expect("an archive's statistics are JSON"),
            input_vertices: Some(&contents.input_vertices),
            color_range: scale.map(|Scale { quantity, min, max, unit }| ColorRange {
                quantity: quantity.name(),
                unit,
                min: *min,
                max: *max,
                stops: STOPS,
            }),
        }
    }
}

/// Positions that the surface and the lines along it share.
#[derive(Clone, Copy)]
struct Shared<'a> {
    accessor: Index<Accessor>,
    positions: &'a [[f32; 3]],
}

/// Appends the items of the added vertices of a mesh whose vertices were split. `source` has the original of each
/// vertex.
fn extend_by_sources<T: Copy>(items: &mut Vec<T>, source: &[u32]) {
    let added: Vec<T> = source[items.len()..].iter().map(|&vertex| items[vertex as usize]).collect();
    items.extend(added);
}

fn along(line: &Polyline) -> impl Iterator<Item = u32> {
    let back = line.closed.then(|| line.vertices.first().copied()).flatten();
    line.vertices.iter().copied().chain(back)
}

fn clamped(value: f64) -> f32 {
    value.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

fn line_color(set: &LineSet) -> [f32; 4] {
    match set.name.as_str() {
        "boundaries" | "directrices" => [0.01, 0.01, 0.015, 1.0],
        "bridges" => [0.2, 0.22, 0.25, 1.0],
        _ => [0.35, 0.12, 0.02, 1.0],
    }
}

/// Returns unit vertex normals in glTF's axes. Within the sizes that [`GltfCoordinates`] accepts, no square overflows
/// or becomes zero.
fn normals(mesh: &Mesh, coordinates: &GltfCoordinates) -> Vec<[f32; 3]> {
    let mut normals = measure::vertex_normals(mesh);
    if normals.contains(&DVec3::ZERO) {
        replace_missing(mesh, &mut normals);
    }
    normals
        .into_iter()
        .map(|normal| {
            let turned = if normal == DVec3::ZERO { DVec3::Y } else { coordinates.turn(normal) };
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
