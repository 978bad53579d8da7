//! The stored artefact: one mesh in f64 with everything that the download formats need.
//!
//! # Bytes, version 3
//! All numbers are little endian. Counts and indices are LEB128 numbers; a list of indices is its count, then each index as
//! the zigzag difference from the one before it (from 0 at first; in a list of groups, from the same place in the group
//! before). Strings and other lists carry their count first; an option is a byte 0 or 1.
//! ```text
//! magic "\x89PLATEAU" · version u32 · payload · SHA-256 of all that precedes
//! payload: generator, title: string · unit u8 · up u8
//!          vertices: list of 3 f64 · triangles: list of 3 indices
//!          mean curvature: option (least_range f64 · one f64 per vertex, count not repeated)
//!          line sets: list (name, group: string · 0: list of polylines (closed u8 · list of indices)
//!                                               | 1: list of 2 indices · option (name, unit: string · one f64 per segment))
//!          input vertices: list of lists of indices · statistics: string (JSON)
//!          pattern: 0: none | 1: list of pieces (name: string · outline: list of 2 f64 · folds: list (2 ends · angle_deg f64))
//!                   | 2: unrolled from the bridges when it is wanted
//! end of a fold: a number: 0, then 2 f64 | 1 + the difference between the index of the outline's point that it is and that of
//!          the fold before: upwards from the first point for the first end, downwards from the last for the second
//! ```
//! In version 2 a pattern was written out always. In version 1, moreover, counts and indices are u32, indices stand for
//! themselves, and an end of a fold is 2 f64. The same contents always give the same bytes. A later version reads every earlier one.

use plateau_geometry::polyline::LARGEST_COORDINATE;
use plateau_geometry::ruled_surface::strips_of;
use plateau_geometry::{DVec2, DVec3, Mesh};
use sha2::{Digest, Sha256};

use super::pattern::{self, Flat, Fold, Pattern, Piece};

const MAGIC: &[u8; 8] = b"\x89PLATEAU";
const VERSION: u32 = 3;
const CHECKSUM_BYTES: usize = 32;

/// The client's unit of length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    Millimetre,
    Centimetre,
    #[default]
    Metre,
    Inch,
    Foot,
}

impl Unit {
    const ALL: [Self; 5] = [Self::Millimetre, Self::Centimetre, Self::Metre, Self::Inch, Self::Foot];

    /// `mm`, `cm`, `m`, `in` or `ft`.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "in",
            Self::Foot => "ft",
        }
    }

    /// How many millimetres one unit is; exact.
    #[must_use]
    pub fn millimetres(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Centimetre => 10.0,
            Self::Metre => 1000.0,
            Self::Inch => 25.4,
            Self::Foot => 304.8,
        }
    }

    /// How many metres one unit is, correctly rounded.
    #[must_use]
    pub fn metres(self) -> f64 {
        match self {
            Self::Millimetre => 1e-3,
            Self::Centimetre => 1e-2,
            Self::Metre => 1.0,
            Self::Inch => 0.0254,
            Self::Foot => 0.3048,
        }
    }
}

/// Which of the client's axes points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UpAxis {
    #[default]
    Z,
    Y,
}

impl UpAxis {
    const ALL: [Self; 2] = [Self::Z, Self::Y];

    /// `z` or `y`.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Z => "z",
            Self::Y => "y",
        }
    }
}

/// The unsigned mean curvature of each vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct MeanCurvature {
    /// One per vertex, 1/unit, finite and not negative.
    pub values: Vec<f64>,
    /// The colours run over [0, max(largest value, this)], 1/unit: tolerance / R keeps rounding from looking like curvature.
    pub least_range: f64,
}

impl MeanCurvature {
    /// The upper end of the colours' range, 1/unit.
    #[must_use]
    pub fn range(&self) -> f64 {
        self.values.iter().copied().fold(self.least_range, f64::max)
    }
}

/// Vertices joined in order; a closed one does not repeat its first.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polyline {
    pub vertices: Vec<u32>,
    pub closed: bool,
}

/// A number for each segment of a line set, such as its length or force.
#[derive(Clone, Debug, PartialEq)]
pub struct SegmentValues {
    /// Lower case letters, digits and underscores, e.g. `length`.
    pub name: String,
    /// Empty for a plain number.
    pub unit: String,
    pub values: Vec<f64>,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Lines {
    Polylines(Vec<Polyline>),
    Segments { pairs: Vec<[u32; 2]>, values: Option<SegmentValues> },
}

/// Lines along the mesh that a viewer can switch on.
#[derive(Clone, Debug, PartialEq)]
pub struct LineSet {
    /// `boundaries`, `directrices`, `bridges` or `members`.
    pub name: String,
    /// What the lines are made of, or belong to, e.g. `lattice`; empty if the name says it all.
    pub group: String,
    pub lines: Lines,
}

impl LineSet {
    /// Name and group in one, e.g. `members lattice`.
    #[must_use]
    pub fn full_name(&self) -> String {
        if self.group.is_empty() { self.name.clone() } else { format!("{} {}", self.name, self.group) }
    }
}

/// What an [`Archive`] holds. Coordinates are in the client's unit and axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contents {
    /// The program and its version.
    pub generator: String,
    /// What the mesh is, for a person; one line.
    pub title: String,
    pub unit: Unit,
    pub up: UpAxis,
    /// The input's points first, in input order.
    pub mesh: Mesh,
    pub mean_curvature: Option<MeanCurvature>,
    pub line_sets: Vec<LineSet>,
    /// For each polyline of the input: the vertex that each of its points became.
    pub input_vertices: Vec<Vec<u32>>,
    /// The job's statistics: a JSON value, carried and not looked into.
    pub statistics: String,
    pub pattern: Flat,
}

/// [`Contents`] that were found sound: indices in range, numbers finite, lists of matching length. The formats rely on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Archive(Contents);

/// Why contents or bytes are not an archive.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Defect {
    #[error("not a mesh archive")]
    Magic,
    #[error("archive version {0} is newer than this program")]
    Version(u32),
    #[error("the archive is damaged: its checksum does not match")]
    Checksum,
    #[error("the archive is damaged at byte {at}: {what}")]
    Bytes { at: usize, what: &'static str },
    #[error("no archive can hold this mesh: {0}")]
    Contents(&'static str),
}

impl Archive {
    /// # Errors
    /// [`Defect::Contents`] says what is wrong: no vertex or triangle, an index out of range, a number that is not finite, lists that do
    /// not match, statistics that are no JSON, a name that cannot be one. Linear in the size.
    pub fn new(contents: Contents) -> Result<Self, Defect> {
        check(&contents).map_err(Defect::Contents)?;
        Ok(Self(contents))
    }

    #[must_use]
    pub fn contents(&self) -> &Contents {
        &self.0
    }

    /// The stored form; see the [module](self).
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let contents = &self.0;
        let mut out =
            Writer(Vec::with_capacity(256 + 24 * contents.mesh.vertices.len() + 12 * contents.mesh.triangles.len()));
        out.0.extend_from_slice(MAGIC);
        out.u32(VERSION);
        out.string(&contents.generator);
        out.string(&contents.title);
        out.u8(contents.unit as u8);
        out.u8(contents.up as u8);
        out.list(&contents.mesh.vertices, |out, v| v.to_array().into_iter().for_each(|x| out.f64(x)));
        out.groups(&contents.mesh.triangles);
        out.option(contents.mean_curvature.as_ref(), |out, curvature| {
            out.f64(curvature.least_range);
            curvature.values.iter().for_each(|&value| out.f64(value));
        });
        out.list(&contents.line_sets, Writer::line_set);
        out.list(&contents.input_vertices, |out, vertices| out.indices(vertices));
        out.string(&contents.statistics);
        match &contents.pattern {
            Flat::None => out.u8(0),
            Flat::Kept(pattern) => {
                out.u8(1);
                out.list(&pattern.pieces, Writer::piece);
            }
            Flat::OfBridges => out.u8(2),
        }
        let checksum = Sha256::digest(&out.0);
        out.0.extend_from_slice(&checksum);
        out.0
    }

    /// The checksum at the end of a stored form: SHA-256 of all before it, so that it names the whole. Zeros for what is too
    /// short to be one.
    #[must_use]
    pub fn checksum(bytes: &[u8]) -> [u8; CHECKSUM_BYTES] {
        bytes.last_chunk().copied().unwrap_or_default()
    }

    /// Reads the stored form. Safe on any bytes: lengths are checked against what is left before memory is asked for.
    ///
    /// # Errors
    /// [`Defect`] if the bytes are not an archive, are of a later version, damaged, or hold unsound contents.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Defect> {
        if !bytes.starts_with(MAGIC) {
            return Err(Defect::Magic);
        }
        let mut input = Reader { bytes, at: MAGIC.len(), version: 0 };
        let version = input.u32()?;
        if version == 0 || version > VERSION {
            return Err(Defect::Version(version));
        }
        let payload_end = bytes.len().checked_sub(CHECKSUM_BYTES).ok_or(Defect::Checksum)?;
        let (body, checksum) = bytes.split_at(payload_end);
        if Sha256::digest(body).as_slice() != checksum {
            return Err(Defect::Checksum);
        }
        let mut input = Reader { bytes: body, at: input.at, version };
        let contents = input.contents()?;
        if input.at != body.len() {
            return Err(input.fault("bytes after the end"));
        }
        Self::new(contents)
    }
}

fn check(contents: &Contents) -> Result<(), &'static str> {
    let vertices = &contents.mesh.vertices;
    let exists = |&vertex: &u32| (vertex as usize) < vertices.len();
    let ensure = |holds: bool, what: &'static str| if holds { Ok(()) } else { Err(what) };
    let fits = |length: usize| u32::try_from(length).is_ok();

    ensure(!vertices.is_empty() && !contents.mesh.triangles.is_empty(), "it has no triangle")?;
    ensure(fits(vertices.len()) && fits(contents.mesh.triangles.len()), "more than 2^32 vertices or triangles")?;
    ensure(vertices.iter().all(|v| v.is_finite()), "a coordinate is not finite")?;
    ensure(contents.mesh.triangles.iter().flatten().all(exists), "a triangle names a vertex that does not exist")?;
    if let Some(curvature) = &contents.mean_curvature {
        ensure(curvature.values.len() == vertices.len(), "mean curvature and vertices differ in number")?;
        let sound = |value: f64| value.is_finite() && value >= 0.0;
        ensure(sound(curvature.least_range), "the curvature's range is negative or not finite")?;
        ensure(curvature.values.iter().all(|&value| sound(value)), "a mean curvature is negative or not finite")?;
    }
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
            Lines::Segments { pairs, values } => {
                ensure(pairs.iter().flatten().all(exists), "a line names a vertex that does not exist")?;
                if let Some(values) = values {
                    ensure(values.values.len() == pairs.len(), "segments and their values differ in number")?;
                    ensure(values.values.iter().all(|value| value.is_finite()), "a segment's value is not finite")?;
                    let letters = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_';
                    ensure(
                        !values.name.is_empty() && values.name.bytes().all(letters),
                        "a value's name is not lower case",
                    )?;
                }
            }
        }
    }
    ensure(contents.input_vertices.iter().flatten().all(exists), "an input point's vertex does not exist")?;
    ensure(serde_json::from_str::<serde::de::IgnoredAny>(&contents.statistics).is_ok(), "the statistics are not JSON")?;
    let kept: &[Piece] = match &contents.pattern {
        Flat::None => &[],
        Flat::Kept(pattern) => &pattern.pieces,
        Flat::OfBridges => {
            ensure(unrolls(contents), "the bridges are not those of the mesh's strips")?;
            &[]
        }
    };
    for piece in kept {
        ensure(piece.outline.len() >= 3, "a pattern piece of fewer than three points")?;
        let finite = piece.outline.iter().all(|p| p.is_finite())
            && piece.folds.iter().all(|f| f.ends.iter().all(|p| p.is_finite()) && f.angle_deg.abs() <= 180.0);
        ensure(finite, "a pattern's coordinate is not finite")?;
    }
    Ok(())
}

/// Whether the mesh is what its bridges say it is, as far as unrolling relies on it.
fn unrolls(contents: &Contents) -> bool {
    let Some(bridges) = pattern::bridges(contents) else { return false };
    let steps = |strip: &[[u32; 2]]| strip.windows(2).all(|pair| pair[0] != pair[1]);
    let triangles = strips_of(bridges).map(|strip| strip.len() - 1).sum::<usize>();
    triangles == contents.mesh.triangles.len()
        && strips_of(bridges).all(|strip| strip.len() > 1 && steps(strip))
        && contents.mesh.vertices.iter().all(|v| v.abs().max_element() <= LARGEST_COORDINATE)
}

struct Writer(Vec<u8>);

impl Writer {
    fn u8(&mut self, value: u8) {
        self.0.push(value);
    }

    fn u32(&mut self, value: u32) {
        self.0.extend_from_slice(&value.to_le_bytes());
    }

    fn f64(&mut self, value: f64) {
        self.0.extend_from_slice(&value.to_le_bytes());
    }

    /// LEB128: seven bits a byte, the lowest first.
    fn number(&mut self, mut value: u64) {
        while value >= 0x80 {
            self.u8(value as u8 | 0x80);
            value >>= 7;
        }
        self.u8(value as u8);
    }

    fn count(&mut self, length: usize) {
        self.number(length as u64);
    }

    fn index(&mut self, value: u32, before: u32) {
        let difference = i64::from(value) - i64::from(before);
        self.number(((difference << 1) ^ (difference >> 63)) as u64);
    }

    fn indices(&mut self, values: &[u32]) {
        self.count(values.len());
        let mut before = 0;
        for &value in values {
            self.index(value, std::mem::replace(&mut before, value));
        }
    }

    fn groups<const N: usize>(&mut self, groups: &[[u32; N]]) {
        self.count(groups.len());
        let mut before = [0; N];
        for &group in groups {
            for (value, before) in group.into_iter().zip(std::mem::replace(&mut before, group)) {
                self.index(value, before);
            }
        }
    }

    fn string(&mut self, text: &str) {
        self.count(text.len());
        self.0.extend_from_slice(text.as_bytes());
    }

    fn list<T>(&mut self, items: &[T], each: impl Fn(&mut Self, &T)) {
        self.count(items.len());
        items.iter().for_each(|item| each(self, item));
    }

    fn option<T>(&mut self, item: Option<&T>, each: impl Fn(&mut Self, &T)) {
        self.u8(u8::from(item.is_some()));
        if let Some(item) = item {
            each(self, item);
        }
    }

    fn line_set(&mut self, set: &LineSet) {
        self.string(&set.name);
        self.string(&set.group);
        match &set.lines {
            Lines::Polylines(polylines) => {
                self.u8(0);
                self.list(polylines, |out, line| {
                    out.u8(u8::from(line.closed));
                    out.indices(&line.vertices);
                });
            }
            Lines::Segments { pairs, values } => {
                self.u8(1);
                self.groups(pairs);
                self.option(values.as_ref(), |out, values| {
                    out.string(&values.name);
                    out.string(&values.unit);
                    values.values.iter().for_each(|&value| out.f64(value));
                });
            }
        }
    }

    fn piece(&mut self, piece: &Piece) {
        self.string(&piece.name);
        self.list(&piece.outline, |out, point| point.to_array().into_iter().for_each(|x| out.f64(x)));
        self.count(piece.folds.len());
        let mut passed = [0, 0];
        for fold in &piece.folds {
            for (end, point) in fold.ends.into_iter().enumerate() {
                // Folds follow one another along the outline: an end is the one before or a few points on.
                let place = |step: &usize| piece.outline.get(along(&piece.outline, end, passed[end] + step)?);
                match (0..NEAR).find(|step| place(step).is_some_and(|other| same(*other, point))) {
                    Some(step) => {
                        self.number(1 + step as u64);
                        passed[end] += step;
                    }
                    None => {
                        self.number(0);
                        point.to_array().into_iter().for_each(|x| self.f64(x));
                    }
                }
            }
            self.f64(fold.angle_deg);
        }
    }
}

/// How far on along the outline the next fold's end is looked for.
const NEAR: usize = 8;

/// The index of the point so many from the outline's first (`end` 0) or back from its last (`end` 1).
fn along(outline: &[DVec2], end: usize, passed: usize) -> Option<usize> {
    if end == 0 { Some(passed) } else { outline.len().checked_sub(passed.checked_add(1)?) }
}

/// To the bit: -0 is not 0.
fn same(one: DVec2, other: DVec2) -> bool {
    one.to_array().map(f64::to_bits) == other.to_array().map(f64::to_bits)
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    version: u32,
}

impl Reader<'_> {
    fn fault(&self, what: &'static str) -> Defect {
        Defect::Bytes { at: self.at, what }
    }

    fn take(&mut self, length: usize) -> Result<&[u8], Defect> {
        let end = self.at.checked_add(length).filter(|&end| end <= self.bytes.len());
        let end = end.ok_or_else(|| self.fault("it ends too early"))?;
        let slice = &self.bytes[self.at..end];
        self.at = end;
        Ok(slice)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], Defect> {
        Ok(self.take(N)?.try_into().expect("take gives as many bytes as asked for"))
    }

    fn u8(&mut self) -> Result<u8, Defect> {
        Ok(self.array::<1>()?[0])
    }

    fn u32(&mut self) -> Result<u32, Defect> {
        Ok(u32::from_le_bytes(self.array()?))
    }

    fn f64(&mut self) -> Result<f64, Defect> {
        Ok(f64::from_le_bytes(self.array()?))
    }

    fn flag(&mut self) -> Result<bool, Defect> {
        match self.u8()? {
            0 => Ok(false),
            1 => Ok(true),
            _ => Err(self.fault("neither yes nor no")),
        }
    }

    fn number(&mut self) -> Result<u64, Defect> {
        let mut value = 0;
        for shift in (0..63).step_by(7) {
            let byte = self.u8()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err(self.fault("a number of too many bytes"))
    }

    fn count(&mut self) -> Result<usize, Defect> {
        if self.version == 1 {
            return Ok(self.u32()? as usize);
        }
        usize::try_from(self.number()?).map_err(|_| self.fault("a list longer than the file"))
    }

    fn index(&mut self, before: u32) -> Result<u32, Defect> {
        if self.version == 1 {
            return self.u32();
        }
        let number = self.number()?;
        let difference = (number >> 1) as i64 ^ -((number & 1) as i64);
        let value = i64::from(before).checked_add(difference).and_then(|value| u32::try_from(value).ok());
        value.ok_or_else(|| self.fault("an index out of range"))
    }

    fn indices(&mut self) -> Result<Vec<u32>, Defect> {
        Ok(self.groups()?.into_iter().map(|[value]| value).collect())
    }

    fn groups<const N: usize>(&mut self) -> Result<Vec<[u32; N]>, Defect> {
        let count = self.count()?;
        let mut before = [0; N];
        let least_bytes = if self.version == 1 { 4 * N } else { N };
        self.items(count, least_bytes, |input| {
            for value in &mut before {
                *value = input.index(*value)?;
            }
            Ok(before)
        })
    }

    fn string(&mut self) -> Result<String, Defect> {
        let length = self.count()?;
        let bytes = self.take(length)?.to_vec();
        String::from_utf8(bytes).map_err(|_| self.fault("text that is not UTF-8"))
    }

    /// `count` items, each of at least `least_bytes`: what cannot be there is refused before memory is reserved.
    fn items<T>(
        &mut self,
        count: usize,
        least_bytes: usize,
        mut each: impl FnMut(&mut Self) -> Result<T, Defect>,
    ) -> Result<Vec<T>, Defect> {
        if count > (self.bytes.len() - self.at) / least_bytes {
            return Err(self.fault("a list longer than the file"));
        }
        (0..count).map(|_| each(self)).collect()
    }

    fn list<T>(&mut self, least_bytes: usize, each: impl Fn(&mut Self) -> Result<T, Defect>) -> Result<Vec<T>, Defect> {
        let count = self.count()?;
        self.items(count, least_bytes, each)
    }

    fn option<T>(&mut self, each: impl Fn(&mut Self) -> Result<T, Defect>) -> Result<Option<T>, Defect> {
        if self.flag()? { each(self).map(Some) } else { Ok(None) }
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> Result<T, Defect> {
        let index = self.u8()? as usize;
        all.get(index).copied().ok_or_else(|| self.fault("an unknown unit or axis"))
    }

    fn contents(&mut self) -> Result<Contents, Defect> {
        let generator = self.string()?;
        let title = self.string()?;
        let unit = self.one_of(&Unit::ALL)?;
        let up = self.one_of(&UpAxis::ALL)?;
        let vertices = self.list(24, |input| Ok(DVec3::new(input.f64()?, input.f64()?, input.f64()?)))?;
        let triangles = self.groups()?;
        let vertex_count = vertices.len();
        Ok(Contents {
            generator,
            title,
            unit,
            up,
            mesh: Mesh::new(vertices, triangles),
            mean_curvature: self.option(|input| {
                let least_range = input.f64()?;
                Ok(MeanCurvature { values: input.items(vertex_count, 8, Self::f64)?, least_range })
            })?,
            line_sets: self.list(4, Self::line_set)?,
            input_vertices: self.list(1, Self::indices)?,
            statistics: self.string()?,
            pattern: match self.u8()? {
                0 => Flat::None,
                1 => Flat::Kept(Pattern { pieces: self.list(3, Self::piece)? }),
                2 if self.version > 2 => Flat::OfBridges,
                _ => return Err(self.fault("unknown kind of pattern")),
            },
        })
    }

    fn line_set(&mut self) -> Result<LineSet, Defect> {
        let (name, group) = (self.string()?, self.string()?);
        let lines = match self.u8()? {
            0 => Lines::Polylines(
                self.list(2, |input| Ok(Polyline { closed: input.flag()?, vertices: input.indices()? }))?,
            ),
            1 => {
                let pairs = self.groups()?;
                let values = self.option(|input| {
                    let (name, unit) = (input.string()?, input.string()?);
                    Ok(SegmentValues { name, unit, values: input.items(pairs.len(), 8, Self::f64)? })
                })?;
                Lines::Segments { pairs, values }
            }
            _ => return Err(self.fault("unknown kind of lines")),
        };
        Ok(LineSet { name, group, lines })
    }

    fn piece(&mut self) -> Result<Piece, Defect> {
        let point = |input: &mut Self| Ok(DVec2::new(input.f64()?, input.f64()?));
        let name = self.string()?;
        let outline = self.list(16, point)?;
        let count = self.count()?;
        let mut passed = [0, 0];
        let folds = self.items(count, 10, |input| {
            let mut ends = [DVec2::ZERO; 2];
            for (end, place) in ends.iter_mut().enumerate() {
                let number = if input.version == 1 { 0 } else { input.number()? };
                *place = if number == 0 {
                    point(input)?
                } else {
                    let step = usize::try_from(number - 1).ok();
                    let on = step.and_then(|step| step.checked_add(passed[end]));
                    let found = on.and_then(|on| Some((on, *outline.get(along(&outline, end, on)?)?)));
                    let (on, point) = found.ok_or_else(|| input.fault("an end of a fold beyond the outline"))?;
                    passed[end] = on;
                    point
                };
            }
            Ok(Fold { ends, angle_deg: input.f64()? })
        })?;
        Ok(Piece { name, outline, folds })
    }
}
