//! Reads the triangles of a client's binary glTF file.
//!
//! The nodes of the default scene are read with their matrices in f64, and the result is in the client's unit and axes.
//! Primitives of points and lines are left out, because the files that this crate writes have lines beside the surface.
//! Vertices with equal coordinates become one vertex, because files repeat vertices whose normals differ.
//!
//! The file is not trusted. The memory used is a small multiple of its size, because every count is compared with the
//! bytes that are there, and with the caller's limit, before anything is read. No other file is opened.

use gltf::binary::Glb;
use gltf::json::accessor::{ComponentType, Type};
use gltf::json::mesh::{Mode, Semantic};
use gltf::json::validation::Checked::Valid;
use gltf::json::{Accessor, Index, Root};
use plateau_mesh::polyline::position_key;
use plateau_mesh::{DVec3, Mesh};
use serde::Deserialize;

/// Numbers of vertices by the keys of their coordinates.
#[expect(clippy::disallowed_types, reason = "nothing reads its order, and a large file has a million keys")]
type VertexNumbers = std::collections::HashMap<[u64; 3], u32>;

use crate::units::{Unit, UpAxis};

/// Length of the header of a file, in bytes.
const HEADER_BYTES: usize = 12;
/// Largest number of nodes from a root of the scene to a mesh, so that no file can exhaust the stack.
const MOST_LEVELS: usize = 64;
/// Largest size of a file's JSON document in bytes. The next constant is the largest number of objects in it, because
/// an object of two bytes takes hundreds of bytes of memory once it is read. The data of meshes are outside of the
/// document.
const MOST_DOCUMENT_BYTES: usize = 16 << 20;
const MOST_OBJECTS: usize = 100_000;

/// Triangles of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangles {
    pub mesh: Mesh,
    /// Upper bound of the distance, in the client's unit, by which the f32 numbers of the file move a vertex.
    pub rounding: f64,
}

/// Reason for refusing a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum GlbError {
    /// The file cannot be used. The text says why, and names the place in the file's document.
    Invalid(String),
    /// The file has more vertices or triangles than the caller allows.
    TooLarge,
}

fn invalid<T>(detail: impl Into<String>) -> Result<T, GlbError> {
    Err(GlbError::Invalid(detail.into()))
}

/// Reads the triangles of a binary glTF file, in this unit and with this axis up. `most` is the largest number of
/// vertices and of triangles, counted before equal vertices become one.
///
/// # Errors
/// Returns [`GlbError::Invalid`] for a file that is not binary glTF 2.0, that needs an extension or another file, or
/// that has strips, fans, sparse accessors, numbers that are not finite, or references beyond what is there.
pub fn read(file: &[u8], unit: Unit, up: UpAxis, most: usize) -> Result<Triangles, GlbError> {
    // The gltf crate subtracts the header's length from the length that the file states. A smaller stated length is
    // therefore refused first.
    let stated = file.get(8..HEADER_BYTES).and_then(|bytes| bytes.try_into().ok()).map(u32::from_le_bytes);
    if stated.is_none_or(|stated| (stated as usize) < HEADER_BYTES) {
        return invalid("is not binary glTF");
    }
    let Glb { json, bin, .. } =
        Glb::from_slice(file).or_else(|error| invalid(format!("is not binary glTF 2.0: {error}")))?;
    if json.len() > MOST_DOCUMENT_BYTES || json.iter().filter(|&&byte| byte == b'{').count() > MOST_OBJECTS {
        return invalid(format!("has a document of more than {MOST_OBJECTS} objects or {MOST_DOCUMENT_BYTES} bytes"));
    }
    let root: Root = document(&json)?;
    let transforms: Transforms = document(&json)?;
    if let Some(extension) = root.extensions_required.first() {
        return invalid(format!("requires the extension {extension}, which is not read"));
    }
    let scene = root.scene.map_or(0, |scene| scene.value());
    let roots: Vec<usize> = match root.scenes.get(scene) {
        Some(scene) => scene.nodes.iter().map(Index::value).collect(),
        None => return invalid(format!("has no scene {scene}")),
    };
    let mut reader = Reader {
        root: &root,
        transforms: &transforms.nodes,
        bin: bin.as_deref().unwrap_or_default(),
        seen: vec![false; root.nodes.len()],
        most,
        metres: unit.metres(),
        up,
        mesh: Mesh::default(),
        vertex_of: VertexNumbers::new(),
        vertices_read: 0,
        rounding: 0.0,
    };
    for node in roots {
        reader.node(node, &Transform::IDENTITY, 0)?;
    }
    if reader.mesh.triangles.is_empty() {
        return invalid("has no triangles in its scene");
    }
    Ok(Triangles { mesh: reader.mesh, rounding: reader.rounding })
}

fn document<'a, T: Deserialize<'a>>(json: &'a [u8]) -> Result<T, GlbError> {
    serde_json::from_slice(json).or_else(|error| invalid(format!("has a document that is not glTF: {error}")))
}

/// The transforms of a document's nodes in f64, because the types of the gltf crate keep them in f32.
#[derive(Deserialize)]
struct Transforms {
    #[serde(default)]
    nodes: Vec<NodeTransform>,
}

#[derive(Deserialize)]
struct NodeTransform {
    matrix: Option<[f64; 16]>,
    #[serde(default)]
    translation: [f64; 3],
    #[serde(default = "no_rotation")]
    rotation: [f64; 4],
    #[serde(default = "no_scale")]
    scale: [f64; 3],
}

fn no_rotation() -> [f64; 4] {
    [0.0, 0.0, 0.0, 1.0]
}

fn no_scale() -> [f64; 3] {
    [1.0; 3]
}

/// An affine map: the images of the axes, and the image of zero.
#[derive(Clone, Copy, Debug)]
struct Transform {
    axes: [DVec3; 3],
    origin: DVec3,
}

impl Transform {
    const IDENTITY: Self = Self { axes: DVec3::AXES, origin: DVec3::ZERO };

    fn of(node: &NodeTransform) -> Self {
        if let Some(m) = node.matrix {
            let column = |k: usize| DVec3::new(m[4 * k], m[4 * k + 1], m[4 * k + 2]);
            return Self { axes: [column(0), column(1), column(2)], origin: column(3) };
        }
        let [x, y, z, w] = node.rotation;
        let rotated = [
            DVec3::new(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)),
            DVec3::new(2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)),
            DVec3::new(2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)),
        ];
        let axes = [0, 1, 2].map(|k| rotated[k] * node.scale[k]);
        Self { axes, origin: DVec3::from_array(node.translation) }
    }

    fn direction(&self, v: DVec3) -> DVec3 {
        self.axes[0] * v.x + self.axes[1] * v.y + self.axes[2] * v.z
    }

    fn point(&self, p: DVec3) -> DVec3 {
        self.direction(p) + self.origin
    }

    fn after(&self, inner: &Self) -> Self {
        Self { axes: inner.axes.map(|axis| self.direction(axis)), origin: self.point(inner.origin) }
    }

    fn turns_inside_out(&self) -> bool {
        self.axes[0].cross(self.axes[1]).dot(self.axes[2]) < 0.0
    }
}

struct Reader<'a> {
    root: &'a Root,
    transforms: &'a [NodeTransform],
    bin: &'a [u8],
    seen: Vec<bool>,
    most: usize,
    metres: f64,
    up: UpAxis,
    mesh: Mesh,
    /// Number of the vertex with the coordinates of the key.
    vertex_of: VertexNumbers,
    vertices_read: usize,
    rounding: f64,
}

impl Reader<'_> {
    fn node(&mut self, number: usize, parent: &Transform, level: usize) -> Result<(), GlbError> {
        let (Some(node), Some(own)) = (self.root.nodes.get(number), self.transforms.get(number)) else {
            return invalid(format!("names the node {number}, which does not exist"));
        };
        if std::mem::replace(&mut self.seen[number], true) {
            return invalid(format!("has the node {number} at two places of its scene"));
        }
        if level >= MOST_LEVELS {
            return invalid(format!("has the node {number} below more than {MOST_LEVELS} others"));
        }
        let transform = parent.after(&Transform::of(own));
        if let Some(mesh) = node.mesh {
            self.mesh(mesh.value(), &transform)?;
        }
        for child in node.children.iter().flatten() {
            self.node(child.value(), &transform, level + 1)?;
        }
        Ok(())
    }

    fn mesh(&mut self, number: usize, transform: &Transform) -> Result<(), GlbError> {
        let Some(mesh) = self.root.meshes.get(number) else {
            return invalid(format!("names the mesh {number}, which does not exist"));
        };
        for (k, primitive) in mesh.primitives.iter().enumerate() {
            let place = format!("primitive {k} of mesh {number}");
            match primitive.mode {
                Valid(Mode::Triangles) => {}
                Valid(Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) => continue,
                _ => {
                    return invalid(format!("has triangles in strips or fans in {place}; only separate ones are read"));
                }
            }
            let Some(positions) = primitive.attributes.get(&Valid(Semantic::Positions)) else {
                return invalid(format!("has no positions in {place}"));
            };
            let positions = self.positions(positions.value())?;
            let corners = match primitive.indices {
                Some(indices) => self.indices(indices.value())?,
                None => (0..positions.len() as u32).collect(),
            };
            if !corners.len().is_multiple_of(3) {
                return invalid(format!("has {} corners of triangles in {place}", corners.len()));
            }
            if let Some(corner) = corners.iter().find(|&&corner| corner as usize >= positions.len()) {
                return invalid(format!("names the vertex {corner} of {} in {place}", positions.len()));
            }
            self.vertices_read += positions.len();
            if self.vertices_read.max(self.mesh.triangles.len() + corners.len() / 3) > self.most {
                return Err(GlbError::TooLarge);
            }
            self.add(&positions, &corners, transform, &place)?;
        }
        Ok(())
    }

    fn add(
        &mut self,
        positions: &[DVec3],
        corners: &[u32],
        transform: &Transform,
        place: &str,
    ) -> Result<(), GlbError> {
        let largest = positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let stretch: f64 = transform.axes.iter().map(|axis| axis.length()).sum();
        let of_numbers = f64::from(f32::EPSILON) * largest * stretch + f64::EPSILON * transform.origin.length();
        self.rounding = self.rounding.max(of_numbers / self.metres);
        let mut numbers = Vec::with_capacity(positions.len());
        for (k, &position) in positions.iter().enumerate() {
            let p = transform.point(position) / self.metres;
            let p = match self.up {
                UpAxis::Y => p,
                UpAxis::Z => DVec3::new(p.x, -p.z, p.y),
            };
            if !p.is_finite() {
                return invalid(format!("has coordinates that are not finite at vertex {k} of {place}"));
            }
            let vertices = &mut self.mesh.vertices;
            numbers.push(*self.vertex_of.entry(position_key(p)).or_insert_with(|| {
                vertices.push(p);
                vertices.len() as u32 - 1
            }));
        }
        let turned = transform.turns_inside_out();
        self.mesh.triangles.extend(corners.as_chunks::<3>().0.iter().map(|&[a, b, c]| {
            let corners = if turned { [a, c, b] } else { [a, b, c] };
            corners.map(|corner| numbers[corner as usize])
        }));
        Ok(())
    }

    fn positions(&self, accessor: usize) -> Result<Vec<DVec3>, GlbError> {
        let (component, items) = self.items(accessor, Type::Vec3)?;
        if component != ComponentType::F32 {
            return invalid(format!("has positions in accessor {accessor} that are not f32"));
        }
        let number = |item: &[u8], k: usize| {
            f64::from(f32::from_le_bytes([item[4 * k], item[4 * k + 1], item[4 * k + 2], item[4 * k + 3]]))
        };
        Ok(items.map(|item| DVec3::new(number(item, 0), number(item, 1), number(item, 2))).collect())
    }

    fn indices(&self, accessor: usize) -> Result<Vec<u32>, GlbError> {
        let (component, items) = self.items(accessor, Type::Scalar)?;
        match component {
            ComponentType::U8 => Ok(items.map(|item| item[0].into()).collect()),
            ComponentType::U16 => Ok(items.map(|item| u16::from_le_bytes([item[0], item[1]]).into()).collect()),
            ComponentType::U32 => {
                Ok(items.map(|item| u32::from_le_bytes([item[0], item[1], item[2], item[3]])).collect())
            }
            _ => invalid(format!("has indices in accessor {accessor} that are not unsigned")),
        }
    }

    /// Returns the type of the numbers of an accessor and the bytes of each of its items.
    fn items(&self, number: usize, expected: Type) -> Result<(ComponentType, impl Iterator<Item = &[u8]>), GlbError> {
        let Some(accessor) = self.root.accessors.get(number) else {
            return invalid(format!("names the accessor {number}, which does not exist"));
        };
        let Accessor { component_type: Valid(component), type_: Valid(type_), sparse: None, .. } = accessor else {
            return invalid(format!("has the accessor {number}, which is sparse or of an unknown type"));
        };
        let component = component.0;
        if *type_ != expected {
            return invalid(format!("has the accessor {number}, whose items have the wrong number of components"));
        }
        let view = accessor.buffer_view.and_then(|view| self.root.buffer_views.get(view.value()));
        let Some(view) = view else {
            return invalid(format!("has the accessor {number} without a buffer view"));
        };
        let buffer = self.root.buffers.get(view.buffer.value());
        if view.buffer.value() != 0 || buffer.is_none_or(|buffer| buffer.uri.is_some()) {
            return invalid(format!("has the accessor {number} with data outside of the file's own buffer"));
        }
        let size = component.size() * type_.multiplicity();
        let stride = view.byte_stride.map_or(size, |stride| stride.0);
        let part = |bytes: &[u8], offset: u64, length: Option<u64>| -> Option<std::ops::Range<usize>> {
            let start = usize::try_from(offset).ok()?;
            let end = match length {
                Some(length) => start.checked_add(usize::try_from(length).ok()?)?,
                None => bytes.len(),
            };
            (start <= end && end <= bytes.len()).then_some(start..end)
        };
        let offset = |offset: Option<gltf::json::validation::USize64>| offset.map_or(0, |offset| offset.0);
        let bytes = part(self.bin, offset(view.byte_offset), Some(view.byte_length.0)).map(|range| &self.bin[range]);
        let bytes = bytes.and_then(|bytes| Some(&bytes[part(bytes, offset(accessor.byte_offset), None)?]));
        let count = usize::try_from(accessor.count.0).unwrap_or(usize::MAX);
        // After the last item, the rest of the stride may be missing.
        let needed = count.saturating_sub(1).saturating_mul(stride).saturating_add(if count > 0 { size } else { 0 });
        match bytes {
            Some(bytes) if stride >= size && needed <= bytes.len() => {
                Ok((component, (0..count).map(move |k| &bytes[k * stride..k * stride + size])))
            }
            _ => invalid(format!("has the accessor {number} with more items than its buffer has bytes for")),
        }
    }
}
