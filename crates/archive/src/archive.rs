//! The stored artefact: one mesh in f64 with all data that the download formats need. The mesh of a cable net has
//! vertices and no triangles; the net is in the line sets.
//!
//! The bytes are the magic `\x89PLATEAU`, the version as a little-endian u32, [`Contents`] in the format of the library
//! postcard, and the SHA-256 of everything before it. Vertex numbers are stored as differences from the preceding
//! numbers, because most differences are small. The same contents always give the same bytes.

use plateau_mesh::polyline::LARGEST_COORDINATE;
use plateau_mesh::{DVec3, Mesh};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::units::{Unit, UpAxis};

const MAGIC: &[u8; 8] = b"\x89PLATEAU";
/// Version of the format. This program reads and writes only this version.
pub const VERSION: u32 = 1;
const HEAD_BYTES: usize = MAGIC.len() + 4;
const CHECKSUM_BYTES: usize = 32;

/// Name of the line sets of cables.
pub const CABLES: &str = "cables";
/// Name of the unsigned mean curvature of vertices.
pub const MEAN_CURVATURE: &str = "mean_curvature";
/// Name of the slack of a proven lower bound of the area: how far the bound is from being tight at a vertex, from 0 to
/// 1.
pub const LOWER_BOUND_SLACK: &str = "lower_bound_slack";

/// Name of the attribute of bridges that is 1 at a bridge that is not locally convex, and 0 at the others.
pub const CONCAVE: &str = "concave";

/// A quantity with a number for each vertex, for each triangle, or for each line of a set, such as a force.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attribute {
    /// Name of lower-case letters, digits and underscores, such as `length`.
    pub name: String,
    /// Unit of the values, made of the client's units, such as `kN` or `1/m`. Empty for plain numbers.
    pub unit: String,
    /// Low and high end of the default colour scale.
    pub range: [f64; 2],
    pub values: Vec<f64>,
}

impl Attribute {
    /// Returns an attribute whose range is from 0 to the largest value, or to 0 if no value is above 0.
    #[must_use]
    pub fn new(name: &str, unit: impl Into<String>, values: Vec<f64>) -> Self {
        let largest = values.iter().copied().fold(0.0, f64::max);
        Self { name: name.into(), unit: unit.into(), range: [0.0, largest], values }
    }

    /// Ends the range at a percentile: the smallest value that at least the fraction `share` of the values does not
    /// exceed. The range never ends below `least`. Hence neither a few large values nor the errors of a mesh determine
    /// the colours.
    #[must_use]
    pub fn ending_at_percentile(mut self, share: f64, least: f64) -> Self {
        let mut sorted = self.values.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        let rank = (share * sorted.len() as f64).ceil() as usize;
        self.range[1] = sorted.get(rank.saturating_sub(1)).copied().unwrap_or(0.0).max(least);
        self
    }
}

/// Vertices joined in order. A closed polyline does not repeat its first vertex.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Polyline {
    #[serde(with = "differences")]
    pub vertices: Vec<u32>,
    pub closed: bool,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Lines {
    Polylines(Vec<Polyline>),
    Segments(#[serde(with = "difference_groups")] Vec<[u32; 2]>),
    /// Straight lines with their own ends, which are no vertices of the mesh, in the client's unit and axes.
    Arrows(Vec<[[f64; 3]; 2]>),
}

impl Lines {
    fn count(&self) -> usize {
        match self {
            Self::Polylines(polylines) => polylines.len(),
            Self::Segments(pairs) => pairs.len(),
            Self::Arrows(ends) => ends.len(),
        }
    }
}

/// Lines along the mesh that a viewer can switch on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LineSet {
    /// Name of the set: `boundaries`, `junctions`, `directrices`, `bridges`, `members`, `cables` or `reactions`.
    pub name: String,
    /// Subset of the lines with this name, such as `lattice`. Empty if all lines with this name are in one set.
    pub group: String,
    pub lines: Lines,
    /// Attributes of the lines. JSON and PLY files have the first one only.
    pub attributes: Vec<Attribute>,
}

impl LineSet {
    /// Returns the name and group together, such as `members lattice`.
    #[must_use]
    pub fn full_name(&self) -> String {
        if self.group.is_empty() { self.name.clone() } else { format!("{} {}", self.name, self.group) }
    }
}

/// Data of an [`Archive`]. Coordinates are in the client's unit and axes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Contents {
    /// Name and version of the program.
    pub generator: String,
    /// Description of the mesh for people, on one line.
    pub title: String,
    pub unit: Unit,
    pub up: UpAxis,
    /// The mesh. Its first vertices are the input's points in input order.
    #[serde(with = "mesh")]
    pub mesh: Mesh,
    pub vertex_attributes: Vec<Attribute>,
    /// Attributes of the triangles. Only JSON has them.
    pub triangle_attributes: Vec<Attribute>,
    pub line_sets: Vec<LineSet>,
    /// Vertices that the points of each input polyline became.
    #[serde(with = "difference_lists")]
    pub input_vertices: Vec<Vec<u32>>,
    /// Statistics of the job as JSON text, which this module does not interpret.
    pub statistics: String,
    /// True if the mesh consists of strips that can be unrolled. The line set [`BRIDGES`] then has the strips' bridges
    /// from first to last, and the mesh has their triangles in the same order, followed by those of caps.
    pub unrolls: bool,
    /// The proof of a lower bound of the area as JSON text, which this module does not interpret.
    pub proof: Option<String>,
}

/// Largest distance from zero, in extents of the mesh, at which f32 coordinates are exact enough: rounding moves a
/// vertex by at most a 100,000th of the extent.
const FAR: f64 = 168.0;

/// Returns the corners of the bounding box.
fn bounds(vertices: &[DVec3]) -> (DVec3, DVec3) {
    let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    vertices.iter().fold(empty, |(low, high), &vertex| (low.min(vertex), high.max(vertex)))
}

/// Returns the middle of the bounding box.
#[must_use]
pub fn middle(vertices: &[DVec3]) -> DVec3 {
    let (low, high) = bounds(vertices);
    0.5 * low + 0.5 * high
}

impl Contents {
    /// Returns the attribute of the vertices with this name.
    #[must_use]
    pub fn at_vertices(&self, name: &str) -> Option<&Attribute> {
        self.vertex_attributes.iter().find(|attribute| attribute.name == name)
    }

    /// Returns the largest side of the bounding box.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let (low, high) = bounds(&self.mesh.vertices);
        (high - low).max_element()
    }

    /// Returns the middle of the mesh's bounding box.
    #[must_use]
    pub fn origin(&self) -> DVec3 {
        middle(&self.mesh.vertices)
    }

    /// Returns true if the mesh is so far from zero, compared with its size, that f32 coordinates would be visibly
    /// wrong.
    #[must_use]
    pub fn is_far_from_zero(&self) -> bool {
        let (low, high) = bounds(&self.mesh.vertices);
        low.abs().max(high.abs()).max_element() > FAR * (high - low).max_element()
    }
}

/// Validated [`Contents`]: indices are in range, numbers are finite, and lists have matching lengths. The formats rely
/// on this.
#[derive(Clone, Debug, PartialEq)]
pub struct Archive(Contents);

/// Reason why contents or bytes are not an archive.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Defect {
    #[error("not a mesh archive")]
    Magic,
    #[error("the archive has version {0}, and this program reads version {VERSION}")]
    Version(u32),
    #[error("the archive is damaged: its checksum does not match")]
    Checksum,
    #[error("the archive cannot be read: {0}")]
    Bytes(String),
    #[error("no archive can hold this mesh: {0}")]
    Contents(&'static str),
}

impl Archive {
    /// Validates contents. Time is linear in their size.
    ///
    /// # Errors
    /// Returns [`Defect::Contents`] if there is no vertex, or neither a triangle nor a cable, an index is out of range,
    /// a number is not finite, lists do not match, the statistics are not JSON, or a name is invalid.
    pub fn new(contents: Contents) -> Result<Self, Defect> {
        check(&contents).map_err(Defect::Contents)?;
        Ok(Self(contents))
    }

    #[must_use]
    pub fn contents(&self) -> &Contents {
        &self.0
    }

    /// Returns the stored form, which the [module](self) describes.
    ///
    /// # Errors
    /// Returns [`Defect::Bytes`], which valid contents never cause.
    pub fn to_bytes(&self) -> Result<Vec<u8>, Defect> {
        let mesh = &self.0.mesh;
        let mut bytes = Vec::with_capacity(256 + 24 * mesh.vertices.len() + 12 * mesh.triangles.len());
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&VERSION.to_le_bytes());
        let mut bytes = postcard::to_extend(&self.0, bytes).map_err(unreadable)?;
        let checksum = Sha256::digest(&bytes);
        bytes.extend_from_slice(&checksum);
        Ok(bytes)
    }

    /// Returns the checksum at the end of a stored form: the SHA-256 of all preceding bytes. It identifies the archive.
    /// Bytes that are too short to have a checksum give zeros.
    #[must_use]
    pub fn checksum(bytes: &[u8]) -> [u8; CHECKSUM_BYTES] {
        bytes.last_chunk().copied().unwrap_or_default()
    }

    /// Reads the stored form. Any bytes are safe to read: the memory used is at most a small multiple of their length.
    ///
    /// # Errors
    /// Returns [`Defect`] if the bytes are not an archive, are damaged, have another version, or have invalid contents.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Defect> {
        if !bytes.starts_with(MAGIC) {
            return Err(Defect::Magic);
        }
        let payload_end = bytes.len().checked_sub(CHECKSUM_BYTES).filter(|&end| end >= HEAD_BYTES);
        let (body, checksum) = bytes.split_at(payload_end.ok_or(Defect::Checksum)?);
        if Sha256::digest(body).as_slice() != checksum {
            return Err(Defect::Checksum);
        }
        let version = body[MAGIC.len()..].first_chunk().map_or(0, |version| u32::from_le_bytes(*version));
        if version != VERSION {
            return Err(Defect::Version(version));
        }
        let (contents, rest) = postcard::take_from_bytes(&body[HEAD_BYTES..]).map_err(unreadable)?;
        if !rest.is_empty() {
            return Err(Defect::Bytes("there are bytes after the end".into()));
        }
        Self::new(contents)
    }
}

fn unreadable(error: postcard::Error) -> Defect {
    Defect::Bytes(error.to_string())
}

fn check(contents: &Contents) -> Result<(), &'static str> {
    let vertices = &contents.mesh.vertices;
    let exists = |&vertex: &u32| (vertex as usize) < vertices.len();
    let ensure = |holds: bool, defect: &'static str| if holds { Ok(()) } else { Err(defect) };
    let fits = |length: usize| u32::try_from(length).is_ok();

    let is_net = contents.line_sets.iter().any(|set| set.name == CABLES);
    let something = !contents.mesh.triangles.is_empty() || is_net;
    ensure(!vertices.is_empty() && something, "it has no triangle")?;
    ensure(fits(vertices.len()) && fits(contents.mesh.triangles.len()), "more than 2^32 vertices or triangles")?;
    ensure(vertices.iter().all(|v| v.is_finite()), "a coordinate is not finite")?;
    ensure(contents.mesh.triangles.iter().flatten().all(exists), "a triangle names a vertex that does not exist")?;
    check_attributes(&contents.vertex_attributes, vertices.len())?;
    check_attributes(&contents.triangle_attributes, contents.mesh.triangles.len())?;
    for set in &contents.line_sets {
        ensure(!set.name.is_empty(), "a line set without a name")?;
        match &set.lines {
            Lines::Polylines(polylines) => {
                ensure(polylines.iter().all(|line| line.vertices.len() >= 2), "a polyline of fewer than two vertices")?;
                ensure(
                    polylines.iter().flat_map(|line| &line.vertices).all(exists),
                    "a line names a vertex that does not exist",
                )?;
            }
            Lines::Segments(pairs) => {
                ensure(pairs.iter().flatten().all(exists), "a line names a vertex that does not exist")?;
            }
            Lines::Arrows(ends) => {
                let finite = ends.iter().flatten().flatten().all(|coordinate| coordinate.is_finite());
                ensure(finite, "an arrow's coordinate is not finite")?;
            }
        }
        check_attributes(&set.attributes, set.lines.count())?;
    }
    ensure(contents.input_vertices.iter().flatten().all(exists), "an input point's vertex does not exist")?;
    ensure(serde_json::from_str::<serde::de::IgnoredAny>(&contents.statistics).is_ok(), "the statistics are not JSON")?;
    if let Some(proof) = &contents.proof {
        ensure(serde_json::from_str::<serde::de::IgnoredAny>(proof).is_ok(), "the proof is not JSON")?;
    }
    ensure(!contents.unrolls || unrolls(contents), "the bridges are not those of the mesh's strips")
}

fn check_attributes(attributes: &[Attribute], items: usize) -> Result<(), &'static str> {
    let letters = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_';
    for (k, Attribute { name, range, values, .. }) in attributes.iter().enumerate() {
        if values.len() != items {
            return Err("the values of an attribute and what they belong to differ in number");
        } else if !values.iter().chain(range).all(|value| value.is_finite()) {
            return Err("a value of an attribute is not finite");
        } else if range[0] > range[1] {
            return Err("the range of an attribute ends below its start");
        } else if name.is_empty() || !name.bytes().all(letters) {
            return Err("the name of an attribute is not lower case");
        } else if attributes[..k].iter().any(|other| other.name == *name) {
            return Err("two attributes have the same name");
        }
    }
    Ok(())
}

/// Returns true if the mesh consists of the strips that its bridges describe. Checks only the properties on which
/// unrolling relies.
fn unrolls(contents: &Contents) -> bool {
    let Some(bridges) = bridges_of(contents) else { return false };
    let closed = is_closed(contents);
    let step = |one: [u32; 2], next: [u32; 2]| one != next && (one[0] == next[0] || one[1] == next[1]);
    let steps = |strip: &[[u32; 2]]| {
        let closes = strip.first().zip(strip.last()).is_some_and(|(&first, &last)| step(last, first));
        strip.windows(2).all(|pair| step(pair[0], pair[1])) && (!closed || closes)
    };
    let triangles = strips_of(bridges).map(|strip| strip.len() - usize::from(!closed)).sum::<usize>();
    let has_all = |count: usize| if closed { triangles <= count } else { triangles == count };
    has_all(contents.mesh.triangles.len())
        && strips_of(bridges).all(|strip| strip.len() > 1 && steps(strip))
        && contents.mesh.vertices.iter().all(|v| v.abs().max_element() <= LARGEST_COORDINATE)
}

/// Name of the line set whose bridges describe how a ruled surface unrolls.
pub const BRIDGES: &str = "bridges";
/// Name of the line set of the rails of a ruled surface.
pub const DIRECTRICES: &str = "directrices";

/// Returns true if the rails of a ruled surface are closed. Rails of one point are not among the lines, and a strip has
/// at most one of them.
#[must_use]
pub fn is_closed(contents: &Contents) -> bool {
    contents.line_sets.iter().any(|set| match &set.lines {
        Lines::Polylines(rails) => set.name == DIRECTRICES && rails.first().is_some_and(|rail| rail.closed),
        Lines::Segments(_) | Lines::Arrows(_) => false,
    })
}

/// Returns the bridges of a ruled surface.
#[must_use]
pub fn bridges_of(contents: &Contents) -> Option<&[[u32; 2]]> {
    contents.line_sets.iter().find(|set| set.name == BRIDGES).and_then(|set| match &set.lines {
        Lines::Segments(pairs) => Some(pairs.as_slice()),
        Lines::Polylines(_) | Lines::Arrows(_) => None,
    })
}

/// Splits the bridges of a ruled surface into those of each strip. Neighbouring bridges of one strip share an end
/// point, and those of two strips do not.
pub fn strips_of(bridges: &[[u32; 2]]) -> impl Iterator<Item = &[[u32; 2]]> {
    bridges.chunk_by(|[p, q], [next, other]| p == next || q == other)
}

/// Serializes a mesh as its vertices and triangles.
mod mesh {
    use super::{DVec3, Mesh, difference_groups};
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    struct Triangles(#[serde(with = "difference_groups")] Vec<[u32; 3]>);

    pub(super) fn serialize<S: Serializer>(mesh: &Mesh, serializer: S) -> Result<S::Ok, S::Error> {
        let vertices: Vec<[f64; 3]> = mesh.vertices.iter().map(DVec3::to_array).collect();
        (vertices, Triangles(mesh.triangles.clone())).serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Mesh, D::Error> {
        let (vertices, Triangles(triangles)) = <(Vec<[f64; 3]>, Triangles)>::deserialize(deserializer)?;
        Ok(Mesh::new(vertices.into_iter().map(DVec3::from_array).collect(), triangles))
    }
}

/// Serializes lists of groups of vertex numbers. Each number is stored as the difference from the number at the same
/// position in the previous group.
mod difference_groups {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer, const N: usize>(
        groups: &[[u32; N]],
        serializer: S,
    ) -> Result<S::Ok, S::Error>
    where
        [i64; N]: Serialize,
    {
        let mut before = [0; N];
        serializer.collect_seq(groups.iter().map(|&group| {
            let last = std::mem::replace(&mut before, group);
            std::array::from_fn::<i64, N, _>(|k| i64::from(group[k]) - i64::from(last[k]))
        }))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>, const N: usize>(
        deserializer: D,
    ) -> Result<Vec<[u32; N]>, D::Error>
    where
        [i64; N]: Deserialize<'de>,
    {
        let mut before = [0_i64; N];
        let next = |differences: [i64; N]| {
            let mut group = [0; N];
            for k in 0..N {
                before[k] = before[k].checked_add(differences[k])?;
                group[k] = u32::try_from(before[k]).ok()?;
            }
            Some(group)
        };
        let groups: Option<_> = Vec::<[i64; N]>::deserialize(deserializer)?.into_iter().map(next).collect();
        groups.ok_or_else(|| D::Error::custom("a vertex number out of range"))
    }
}

/// Serializes lists of vertex numbers. Each number is stored as the difference from the previous one.
mod differences {
    use super::difference_groups;
    use serde::{Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(numbers: &[u32], serializer: S) -> Result<S::Ok, S::Error> {
        let groups: Vec<[u32; 1]> = numbers.iter().map(|&number| [number]).collect();
        difference_groups::serialize(&groups, serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<u32>, D::Error> {
        let groups: Vec<[u32; 1]> = difference_groups::deserialize(deserializer)?;
        Ok(groups.into_iter().flatten().collect())
    }
}

/// Serializes lists of lists of vertex numbers.
mod difference_lists {
    use super::differences;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    struct List(#[serde(with = "differences")] Vec<u32>);

    pub(super) fn serialize<S: Serializer>(lists: &[Vec<u32>], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(lists.iter().map(|list| List(list.clone())))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Vec<u32>>, D::Error> {
        Ok(Vec::<List>::deserialize(deserializer)?.into_iter().map(|List(list)| list).collect())
    }
}
