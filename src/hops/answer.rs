//! Builds the answer to a message of Hops, with the outputs of a component.

use super::component::{Component, Output, Source, result_type};
use crate::hops::envelope;
use crate::wire::job::Job;
use plateau_archive::archive::{Archive, CABLES, LineSet, Lines};
use plateau_archive::formats::Error;
use plateau_drawing::Pattern;
use plateau_engine::blocks::{self, Part, Type};
use plateau_engine::report::Warning;
use plateau_opennurbs::write;
use serde::Serialize;
use serde::ser::SerializeMap;
use serde_json::Value;
use serde_json::value::RawValue;
use std::collections::BTreeMap;

/// Longest list of statistics that is written line by line.
const MAX_LISTED: usize = 50;

/// A value as Hops reads it: the .NET type, and the value as JSON text.
#[derive(Clone, Debug, Serialize)]
struct Item {
    #[serde(rename = "type")]
    of: &'static str,
    data: String,
}

impl Item {
    fn new(of: Type, data: &Value) -> Self {
        Self { of: result_type(of), data: data.to_string() }
    }
}

/// An answer to a message of Hops.
#[derive(Debug, Default, Serialize)]
pub struct Answer<'a> {
    values: Vec<Tree<'a>>,
    pub errors: Vec<String>,
    pub warnings: Vec<String>,
}

/// The values of an output. They all lie in one branch.
#[derive(Debug)]
struct Tree<'a> {
    name: &'static str,
    items: Items<'a>,
}

#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Items<'a> {
    Made(Vec<Item>),
    /// JSON text of items that were made before.
    Ready(&'a RawValue),
}

impl Serialize for Tree<'_> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tree = serializer.serialize_map(Some(2))?;
        tree.serialize_entry("ParamName", self.name)?;
        tree.serialize_entry("InnerTree", &BTreeMap::from([("{0}", &self.items)]))?;
        tree.end()
    }
}

/// Geometry of a result: JSON texts of items, by the part of the result.
#[derive(Debug, Default)]
pub struct Parts<'a>(BTreeMap<&'static str, &'a RawValue>);

impl<'a> Answer<'a> {
    /// Returns an answer with errors and without outputs, for example to a message that names no component.
    #[must_use]
    pub fn of_errors(errors: Vec<String>) -> Self {
        Self { errors, ..Self::default() }
    }

    /// Returns an answer in which every output of a component is present and empty, because Hops would request the
    /// description again if an output were missing.
    #[must_use]
    pub fn refused(component: &Component, errors: Vec<String>) -> Self {
        let empty = |output: &Output| Tree { name: output.name, items: Items::Made(Vec::new()) };
        Self { values: component.outputs.iter().map(empty).collect(), errors, warnings: Vec::new() }
    }

    /// Returns the lines of a text as the only output of a component.
    #[must_use]
    pub fn of_lines(component: &Component, text: &str) -> Self {
        let line = |line: &str| Item::new(Type::Text, &plain(&line.into()).into());
        let lines = |output: &Output| Tree { name: output.name, items: Items::Made(text.lines().map(line).collect()) };
        Self { values: component.outputs.iter().map(lines).collect(), ..Self::default() }
    }

    /// Returns the outputs of a job that has not failed. `parts` is empty until the job has succeeded.
    #[must_use]
    pub fn of_job(component: &Component, job: &Job, parts: &Parts<'a>) -> Self {
        let statistics: Value = job
            .statistics
            .as_ref()
            .and_then(|statistics| serde_json::from_str(statistics.get()).ok())
            .unwrap_or_default();
        let items = |output: &Output| match output.source {
            Source::Result(blocks::Source::Part(part)) => match parts.0.get(name(part)) {
                Some(ready) => Items::Ready(ready),
                None => Items::Made(Vec::new()),
            },
            Source::Result(blocks::Source::Statistic(pointer)) => {
                let value = statistics.pointer(pointer).filter(|value| !value.is_null());
                Items::Made(value.map(|value| Item::new(output.of, value)).into_iter().collect())
            }
            Source::Statistics => {
                let mut lines = Vec::new();
                list("", &statistics, &mut lines);
                Items::Made(lines.into_iter().map(|line| Item::new(Type::Text, &line.into())).collect())
            }
            Source::Job => Items::Made(vec![Item::new(Type::Text, &job.id.as_str().into())]),
            Source::Status => Items::Made(vec![Item::new(Type::Text, &job.status.name().into())]),
            Source::Progress => Items::Made(vec![Item::new(Type::Number, &job.progress.fraction.into())]),
            Source::Lines => Items::Made(Vec::new()),
        };
        let tree = |output: &Output| Tree { name: output.name, items: items(output) };
        // Meshes of openNURBS are in double precision, so a warning about STL files does not concern them.
        let warnings = job.warnings.iter().filter(|warning| warning.code != Warning::FAR_FROM_ZERO);
        Self {
            values: component.outputs.iter().map(tree).collect(),
            errors: Vec::new(),
            warnings: warnings.map(|warning| warning.detail.clone()).collect(),
        }
    }

    /// Returns the body of the answer.
    #[must_use]
    pub fn to_json(&self) -> Vec<u8> {
        // Serialization cannot fail because there are only lists and text.
        serde_json::to_vec(self).unwrap_or_default()
    }
}

/// Adds a line `name: value` for each number and text of the statistics. Hops does not read escapes in text, so no line
/// may have a quotation mark.
fn list(name: &str, value: &Value, lines: &mut Vec<String>) {
    let below = |part: &str| if name.is_empty() { part.to_owned() } else { format!("{name}.{part}") };
    match value {
        Value::Null => {}
        Value::Object(fields) => fields.iter().for_each(|(field, value)| list(&below(field), value, lines)),
        Value::Array(values) if values.len() > MAX_LISTED => lines.push(format!("{name}: {} values", values.len())),
        Value::Array(values) if values.iter().any(|value| value.is_object() || value.is_array()) => {
            for (index, value) in values.iter().enumerate() {
                list(&below(&index.to_string()), value, lines);
            }
        }
        Value::Array(values) => {
            let values: Vec<String> = values.iter().map(plain).collect();
            lines.push(format!("{name}: {}", values.join(", ")));
        }
        value => lines.push(format!("{name}: {}", plain(value))),
    }
}

fn plain(value: &Value) -> String {
    let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    text.chars().map(|character| if matches!(character, '"' | '\\') { '\'' } else { character }).collect()
}

/// Returns the name of a part in the file of [`geometry`].
fn name(part: Part) -> &'static str {
    match part {
        Part::Mesh => "mesh",
        Part::Area => "area",
        Part::Rulings => "rulings",
        Part::Outlines => "outlines",
        Part::Folds => "folds",
        Part::FoldAngles => "fold_angles",
        Part::Members => "members",
        Part::MemberLengths => "member_lengths",
        Part::Cables => "cables",
        Part::CableForces => "cable_forces",
        Part::Anchors => "anchors",
        Part::AnchorForces => "anchor_forces",
    }
}

const PARTS: [Part; 12] = [
    Part::Mesh,
    Part::Area,
    Part::Rulings,
    Part::Outlines,
    Part::Folds,
    Part::FoldAngles,
    Part::Members,
    Part::MemberLengths,
    Part::Cables,
    Part::CableForces,
    Part::Anchors,
    Part::AnchorForces,
];

impl<'a> Parts<'a> {
    /// Reads a file that [`geometry`] has made.
    #[must_use]
    pub fn read(file: &'a [u8]) -> Self {
        let read: BTreeMap<&str, &'a RawValue> = serde_json::from_slice(file).unwrap_or_default();
        let known = PARTS.into_iter().filter_map(|part| Some((name(part), *read.get(name(part))?)));
        Self(known.collect())
    }
}

/// Returns all geometry of a result as a JSON file: items by the name of the part.
///
/// # Errors
/// Returns [`Error::OutOfRange`] if a coordinate exceeds the range of f32, because meshes of openNURBS store each
/// coordinate both as f32 and as f64.
pub fn geometry(archive: &Archive) -> Result<Vec<u8>, Error> {
    let contents = archive.contents();
    let vertices = &contents.mesh.vertices;
    if vertices.iter().any(|vertex| vertex.abs().max_element() > f64::from(f32::MAX)) {
        return Err(Error::OutOfRange { format: "openNURBS", detail: "a coordinate is beyond 3e38" });
    }
    let mut parts: BTreeMap<&str, Vec<Item>> = BTreeMap::new();
    let mut add = |part: Part, of: Type, data: String| {
        parts.entry(name(part)).or_default().push(Item { of: result_type(of), data });
    };
    if !contents.mesh.triangles.is_empty() {
        add(Part::Mesh, Type::Mesh, envelope::to_json(&write::mesh(vertices, &contents.mesh.triangles)));
    }
    let corners = contents.mesh.triangles.iter().map(|&triangle| contents.mesh.corners(triangle));
    let area: f64 = corners.map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum();
    add(Part::Area, Type::Number, Value::from(area).to_string());
    for set in &contents.line_sets {
        let (lines, numbers) = match set.name.as_str() {
            "bridges" => (Part::Rulings, None),
            "members" => (Part::Members, Some(Part::MemberLengths)),
            CABLES => (Part::Cables, Some(Part::CableForces)),
            _ => continue,
        };
        let LineSet { lines: Lines::Segments(pairs), attributes, .. } = set else { continue };
        for pair in pairs {
            let ends = pair.map(|vertex| vertices[vertex as usize]);
            add(lines, Type::Curve, envelope::to_json(&write::polyline_curve(&ends)));
        }
        if let (Some(part), Some(values)) = (numbers, attributes.first()) {
            values.values.iter().for_each(|&value| add(part, Type::Number, Value::from(value).to_string()));
        }
    }
    if let Ok(pattern) = Pattern::of(contents, &[]) {
        flat_pattern(&pattern, &mut add);
    }
    let statistics: Value = serde_json::from_str(&contents.statistics).unwrap_or_default();
    for reaction in statistics["reactions"].as_array().into_iter().flatten() {
        let vertex = reaction["vertex"].as_u64().and_then(|vertex| vertices.get(usize::try_from(vertex).ok()?));
        if let (Some(vertex), Some(force)) = (vertex, reaction["force"].as_array()) {
            let numbers: Vec<f64> = force.iter().filter_map(Value::as_f64).collect();
            add(Part::Anchors, Type::Point, xyz(&vertex.to_array()));
            add(Part::AnchorForces, Type::Vector, xyz(&numbers));
        }
    }
    // Serialization cannot fail because there are only lists and text.
    Ok(serde_json::to_vec(&parts).unwrap_or_default())
}

/// Returns a point or vector as the JSON text that RhinoCommon writes.
fn xyz(numbers: &[f64]) -> String {
    let number = |k: usize| numbers.get(k).copied().unwrap_or_default();
    serde_json::json!({ "X": number(0), "Y": number(1), "Z": number(2) }).to_string()
}

fn flat_pattern(pattern: &Pattern, add: &mut impl FnMut(Part, Type, String)) {
    let sheet = pattern.sheet();
    for piece in &sheet.pieces {
        let mut outline: Vec<_> = piece.outline.iter().map(|point| point.extend(0.0)).collect();
        outline.extend(outline.first().copied());
        add(Part::Outlines, Type::Curve, envelope::to_json(&write::polyline_curve(&outline)));
        for fold in &piece.folds {
            let ends = fold.ends.map(|end| end.extend(0.0));
            add(Part::Folds, Type::Curve, envelope::to_json(&write::polyline_curve(&ends)));
            add(Part::FoldAngles, Type::Number, Value::from(fold.angle_deg).to_string());
        }
    }
}
