//! Builds an API request from the inputs of a Hops component, and states which input each field comes from.

use super::HopsError;
use super::component::Recipe;
use super::values::{Values, nth};
use plateau_archive::units::Unit;
use plateau_engine::blocks::Block;
use plateau_engine::common::Point;
use plateau_engine::kind::{Kind, Units};
use plateau_opennurbs::Mesh;
use plateau_opennurbs::curve::Curve;
use plateau_strict_json::rejection::FieldError;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, HashMap};

/// Distance up to which the ends of a curve count as equal, as a fraction of the curve's size.
const CLOSED: f64 = 1e-9;
/// Distance up to which an anchor counts as on a boundary, as a fraction of the boundary's size. An anchor on a smooth
/// curve lies beside the polyline that approximates the curve.
const ON_BOUNDARY: f64 = 1e-3;

/// A request that has not been checked yet.
#[derive(Debug)]
pub struct UncheckedRequest {
    pub kind: Kind,
    request: Map<String, Value>,
    /// Name of the input that each field was made from, by the field's JSON Pointer.
    places: BTreeMap<String, String>,
}

/// Builds a request from the values of a component's inputs. Curves become polylines of at most `max_points` points.
///
/// # Errors
/// Returns [`HopsError::Invalid`] with a line for each input that cannot be used. The service's own checks come later.
pub fn draft(recipe: Recipe, values: &Values, max_points: usize) -> Result<UncheckedRequest, HopsError> {
    let mut maker = Maker {
        values,
        max_points,
        errors: Vec::new(),
        draft: UncheckedRequest { kind: recipe.kind, request: Map::new(), places: BTreeMap::new() },
    };
    maker.make(recipe.block);
    maker.add_options();
    maker.add_document_unit();
    if maker.errors.is_empty() { Ok(maker.draft) } else { Err(HopsError::Invalid(maker.errors)) }
}

impl UncheckedRequest {
    /// Returns the request's body.
    #[must_use]
    pub fn body(&self) -> Vec<u8> {
        // Serialization cannot fail because a JSON value has only text as keys.
        serde_json::to_vec(&self.request).unwrap_or_default()
    }

    /// Returns an error as a line of text that names the input instead of the pointer.
    #[must_use]
    pub fn line(&self, error: &FieldError) -> String {
        let FieldError { pointer, detail } = error;
        let ends = pointer.match_indices('/').map(|(at, _)| at).chain([pointer.len()]);
        let known = ends.filter_map(|end| Some((end, self.places.get(&pointer[..end])?))).next_back();
        match known {
            _ if pointer.is_empty() => detail.clone(),
            None => format!("{pointer}: {detail}"),
            Some((end, place)) if end == pointer.len() => format!("{place}: {detail}"),
            Some((end, place)) => {
                // The rest of a pointer into a curve has the indices of the point and of its coordinate.
                let rest = &pointer[end + 1..];
                let point = rest.split('/').next().unwrap_or(rest);
                match point.parse::<usize>() {
                    Ok(point) if place.ends_with(']') => format!("{place}, point {point}: {detail}"),
                    _ => format!("{place} /{rest}: {detail}"),
                }
            }
        }
    }
}

struct Maker<'a> {
    values: &'a Values,
    max_points: usize,
    errors: Vec<String>,
    draft: UncheckedRequest,
}

/// Converts those inputs of a block that a request cannot take unchanged, such as curves.
type Use = fn(&mut Maker<'_>);

/// Conversions of the blocks that have such inputs, by the names of the blocks.
const RECIPES: [(&str, Use); 7] = [
    ("minimal-surface", |maker| maker.minimal_surface()),
    ("film-from-mesh", |maker| maker.film_from_mesh()),
    ("ruled-strip", |maker| maker.ruled_strip()),
    ("uniform-mesh", |maker| maker.uniform_mesh()),
    ("tensile-structure", |maker| maker.tensile_structure()),
    ("pneumatic-film", |maker| maker.pneumatic_film()),
    ("cable-net", |maker| maker.cable_net()),
];

impl Maker<'_> {
    /// Converts the inputs that need a recipe, and then makes a field of each input that names a field.
    fn make(&mut self, block: &Block) {
        if let Some((_, recipe)) = RECIPES.iter().find(|(name, _)| *name == block.name) {
            recipe(self);
        }
        for input in block.inputs {
            let value = self.values.value(input.name);
            // The preset of such an input is the field's default. It is left out, because a field that has no effect
            // with the other values is refused, whatever its value.
            let is_preset = input.default.is_some_and(|preset| Value::from(preset) == value);
            match input.field {
                Some(pointer) if !is_preset || pointer.matches('/').count() > 1 => {
                    self.set_at(pointer, input.name, value);
                }
                _ => {}
            }
        }
    }

    /// Sets the field at a pointer. Objects on the way to it are created if they are missing.
    fn set_at(&mut self, pointer: &'static str, input: &str, value: Value) {
        let names: Vec<&str> = pointer.split('/').skip(1).collect();
        let Some((field, above)) = names.split_last() else { return };
        let (mut object, mut place) = (&mut self.draft.request, String::new());
        for &name in above {
            place = format!("{place}/{name}");
            self.draft.places.entry(place.clone()).or_insert_with(|| input.to_owned());
            let Value::Object(below) = object.entry(name).or_insert_with(|| json!({})) else { return };
            object = below;
        }
        object.insert((*field).into(), value);
        self.place(pointer.into(), input);
    }

    fn minimal_surface(&mut self) {
        let boundaries = self.polygons("Boundaries");
        self.set_curves("boundaries", "Boundaries", &boundaries);
        self.resolution();
    }

    fn tensile_structure(&mut self) {
        let mut boundaries = self.polygons("Boundaries");
        let cables = self.cables(&mut boundaries);
        self.set_curves("boundaries", "Boundaries", &boundaries);
        self.set("cables", "Anchors", cables);
        self.resolution();
    }

    fn pneumatic_film(&mut self) {
        let boundaries = self.polygons("Boundaries");
        self.set_curves("boundaries", "Boundaries", &boundaries);
        for (field, input) in [("pressure", "Pressure"), ("volume", "Volume")] {
            if self.values.number(input) != 0.0 {
                self.set(field, input, self.values.number(input));
            }
        }
        self.resolution();
    }

    /// Joins equal points of the cables to vertices, and makes an edge of each segment.
    fn cable_net(&mut self) {
        let mut vertices: Vec<Point> = Vec::new();
        let mut numbers: HashMap<[u64; 3], u32> = HashMap::new();
        let mut number = |point: Point| {
            *numbers.entry(bits(point)).or_insert_with(|| {
                vertices.push(point);
                vertices.len() as u32 - 1
            })
        };
        let mut edges: Vec<[u32; 2]> = Vec::new();
        for line in self.sampled("Cables") {
            let line: Vec<u32> = line.into_iter().map(&mut number).collect();
            edges.extend(line.windows(2).map(|pair| [pair[0], pair[1]]));
        }
        let mut supports: Vec<u32> = Vec::new();
        for (index, &support) in self.values.points("Supports").iter().enumerate() {
            match numbers.get(&bits(support)).copied() {
                Some(vertex) if supports.contains(&vertex) => {}
                Some(vertex) => {
                    self.place(format!("/supports/{}", supports.len()), nth("Supports", index));
                    supports.push(vertex);
                }
                None => self.errors.push(format!("{}: is no point of the cables", nth("Supports", index))),
            }
        }
        let mode = self.values.text("Cable Mode");
        if matches!(mode, "force" | "length" | "force_density") {
            self.set("cables", "Cable Value", json!([{ "name": "net", mode: self.values.number("Cable Value") }]));
        } else {
            self.errors.push("Cable Mode: must be one of force, length, force_density".into());
        }
        let load = self.values.number("Load");
        if load != 0.0 {
            self.set("loads", "Load", json!([{ "force": [0.0, 0.0, -load] }]));
        }
        self.set("vertices", "Cables", json!(vertices));
        self.set("edges", "Cables", json!(edges));
        self.set("supports", "Supports", json!(supports));
    }

    /// Sets a field of the request and notes the input that the field is made from.
    fn set(&mut self, field: &str, input: &str, value: impl Into<Value>) {
        self.draft.request.insert(field.into(), value.into());
        self.place(format!("/{field}"), input);
    }

    fn place(&mut self, pointer: String, input: impl Into<String>) {
        self.draft.places.insert(pointer, input.into());
    }

    fn set_curves(&mut self, field: &str, input: &str, curves: &[Vec<Point>]) {
        self.set(field, input, json!(curves));
        for index in 0..curves.len() {
            self.place(format!("/{field}/{index}"), nth(input, index));
        }
    }

    fn resolution(&mut self) {
        let edge_length = self.values.number("Edge Length");
        let (field, input, value) = if edge_length == 0.0 {
            ("triangles", "Triangles", Value::from(self.values.integer("Triangles")))
        } else {
            ("edge_length", "Edge Length", Value::from(edge_length))
        };
        self.set("resolution", input, json!({ field: value }));
        self.place(format!("/resolution/{field}"), input);
    }

    fn film_from_mesh(&mut self) {
        let Some(mesh) = self.values.mesh("Mesh") else { return };
        let (vertices, triangles) = joined(mesh);
        match naked_edges(&triangles) {
            Ok(loops) => {
                let boundaries: Vec<Vec<Point>> =
                    loops.iter().map(|line| line.iter().map(|&vertex| vertices[vertex as usize]).collect()).collect();
                self.set("boundaries", "Mesh", json!(boundaries));
                self.set("initial_mesh", "Mesh", json!({ "vertices": vertices, "triangles": triangles }));
            }
            Err(text) => self.errors.push(format!("Mesh: {text}")),
        }
    }

    fn ruled_strip(&mut self) {
        let mut rails = self.sampled("Rails");
        let closed = !rails.is_empty() && rails.iter().all(|rail| rail.len() > 3 && self.gap(rail).is_none());
        if closed {
            rails.iter_mut().for_each(|rail| rail.truncate(rail.len() - 1));
        }
        self.set_curves("directrices", "Rails", &rails);
        self.set("closed", "Rails", closed);
        self.set("direction", "Align", if self.values.boolean("Align") { "auto" } else { "as_given" });
        let samples = self.values.integer("Samples");
        if samples != 0 {
            self.set("sampling", "Samples", json!({ "samples": samples, "by": "arc_length" }));
            self.place("/sampling/samples".into(), "Samples");
        }
    }

    fn uniform_mesh(&mut self) {
        let boundaries = self.polygons("Boundaries");
        let domain = match boundaries.as_slice() {
            [outline, holes @ ..] if !self.values.boolean("Film") => {
                self.place("/domain/polygon".into(), nth("Boundaries", 0));
                for index in 0..holes.len() {
                    self.place(format!("/domain/holes/{index}"), nth("Boundaries", index + 1));
                }
                json!({ "polygon": outline, "holes": holes })
            }
            boundaries => {
                for index in 0..boundaries.len() {
                    self.place(format!("/domain/boundaries/{index}"), nth("Boundaries", index));
                }
                json!({ "boundaries": boundaries })
            }
        };
        self.set("domain", "Boundaries", domain);
        let lengths = self.values.integer("Lengths");
        if lengths != 0 {
            self.set("optimise", "Lengths", "lengths");
            self.set("max_distinct_lengths", "Lengths", lengths);
        }
    }

    /// Returns each curve of an input as a polyline within the tolerance. A curve that cannot be used is left out and
    /// reported as an error.
    fn sampled(&mut self, input: &str) -> Vec<Vec<Point>> {
        let tolerance = self.values.number("Tolerance");
        if tolerance < 0.0 {
            self.errors.push("Tolerance: must be 0 or more".into());
            return Vec::new();
        }
        let sample = |curve: &Curve| {
            let tolerance = if tolerance == 0.0 { curve.default_tolerance() } else { tolerance };
            let points = curve.points(tolerance, self.max_points)?;
            Ok(points.into_iter().map(|point| point.to_array()).collect())
        };
        let sampled: Vec<Result<Vec<Point>, plateau_opennurbs::Defect>> =
            self.values.curves(input).iter().map(sample).collect();
        let mut curves = Vec::with_capacity(sampled.len());
        for (index, points) in sampled.into_iter().enumerate() {
            match points {
                Ok(points) => curves.push(points),
                Err(defect) => {
                    self.errors.push(format!("{}: {defect}; a larger Tolerance needs fewer", nth(input, index)));
                }
            }
        }
        curves
    }

    /// Returns closed curves without their repeated first points.
    fn polygons(&mut self, input: &str) -> Vec<Vec<Point>> {
        let mut polygons = self.sampled(input);
        for (index, polygon) in polygons.iter_mut().enumerate() {
            match self.gap(polygon) {
                None => polygon.truncate(polygon.len().saturating_sub(1)),
                Some(gap) => {
                    self.errors.push(format!("{}: must be closed, and its ends are {gap} apart", nth(input, index)));
                }
            }
        }
        polygons
    }

    /// Returns the distance between the ends of a curve, or `None` if the ends count as equal.
    fn gap(&self, points: &[Point]) -> Option<f64> {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return None };
        let gap = distance(*first, *last);
        (gap > (CLOSED * size(points)).max(self.values.document_tolerance)).then_some(gap)
    }

    /// Returns the cables between the anchors of each boundary. Anchors that are no points of a boundary yet are added
    /// to it.
    fn cables(&mut self, boundaries: &mut [Vec<Point>]) -> Vec<Value> {
        let mut anchors: Vec<Vec<usize>> = vec![Vec::new(); boundaries.len()];
        for (index, &anchor) in self.values.points("Anchors").iter().enumerate() {
            let nearest = boundaries.iter().enumerate().map(|(number, polygon)| (number, nearest(polygon, anchor)));
            let Some((number, place)) = nearest.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance)) else { continue };
            let polygon = &mut boundaries[number];
            let near = (ON_BOUNDARY * size(polygon)).max(self.values.document_tolerance);
            let near = near.max(self.values.number("Tolerance"));
            if place.distance > near {
                let text = format!("is {} away from the nearest boundary", place.distance);
                self.errors.push(format!("{}: {text}", nth("Anchors", index)));
                continue;
            }
            let ends = [place.segment, (place.segment + 1) % polygon.len()];
            let corner = ends.into_iter().filter(|&corner| distance(polygon[corner], anchor) <= near);
            let to_anchor = |corner: &usize| distance(polygon[*corner], anchor);
            let corner = corner.min_by(|a, b| to_anchor(a).total_cmp(&to_anchor(b)));
            let corner = match corner {
                Some(corner) => {
                    polygon[corner] = anchor;
                    corner
                }
                None => {
                    // The indices of all points after the new one grow by 1.
                    let new = place.segment + 1;
                    anchors[number].iter_mut().filter(|corner| **corner >= new).for_each(|corner| *corner += 1);
                    polygon.insert(new, anchor);
                    new
                }
            };
            anchors[number].push(corner);
        }
        let mut cables = Vec::new();
        for (number, corners) in anchors.iter_mut().enumerate() {
            corners.sort_unstable();
            corners.dedup();
            if corners.len() == 1 {
                self.errors.push(format!(
                    "Anchors: {} has one anchor, and a boundary with cables needs at least two",
                    nth("Boundaries", number)
                ));
            }
            for (place, &from) in corners.iter().enumerate() {
                let to = corners[(place + 1) % corners.len()];
                let index = cables.len();
                for (field, input) in [("/value", "Cable Value"), ("/mode", "Cable Mode"), ("", "Anchors")] {
                    self.place(format!("/cables/{index}{field}"), input);
                }
                cables.push(json!({
                    "name": format!("boundary {number}, edge {place}"),
                    "along": { "boundary": number, "from": from, "to": to },
                    "mode": self.values.text("Cable Mode"),
                    "value": self.values.number("Cable Value"),
                }));
            }
        }
        cables
    }

    /// Adds the fields of the input `Options`. Lists are appended to lists, and other fields replace those that are
    /// there.
    fn add_options(&mut self) {
        let text = self.values.text("Options").trim();
        let parsed = if text.is_empty() { Ok(Value::Object(Map::new())) } else { serde_json::from_str(text) };
        let Ok(Value::Object(options)) = parsed else {
            self.errors.push(r#"Options: must be a JSON object, such as {"on_unstable": "descend"}"#.into());
            return;
        };
        for (field, value) in options {
            let pointer = format!("/{field}");
            match (self.draft.request.get_mut(&field), value) {
                (Some(Value::Array(list)), Value::Array(more)) => {
                    let known = list.len();
                    list.extend(more);
                    for (index, place) in (known..list.len()).enumerate() {
                        self.draft.places.insert(format!("{pointer}/{place}"), format!("Options {pointer}/{index}"));
                    }
                }
                (_, value) => {
                    self.draft
                        .places
                        .retain(|place, _| *place != pointer && !place.starts_with(&format!("{pointer}/")));
                    self.draft.places.insert(pointer.clone(), format!("Options {pointer}"));
                    self.draft.request.insert(field, value);
                }
            }
        }
    }

    /// Sets the unit of length to that of the document, unless Options name one.
    fn add_document_unit(&mut self) {
        let has_forces = match self.draft.kind.units() {
            Units::Length => false,
            Units::LengthAndForce => true,
            Units::OfSource => return,
        };
        let units = self.draft.request.get("units");
        if units.is_some_and(|units| !has_forces || !units.is_object() || units.get("length").is_some()) {
            return;
        }
        let unit = match self.values.document_unit.as_str() {
            // The client names no unit, or the document has none.
            "" | "None" | "Unset" => return,
            "Millimeters" => Unit::Millimetre,
            "Centimeters" => Unit::Centimetre,
            "Meters" => Unit::Metre,
            "Inches" => Unit::Inch,
            "Feet" => Unit::Foot,
            other => {
                let example = if has_forces { r#"{"units": {"length": "m"}}"# } else { r#"{"units": "m"}"# };
                self.errors.push(format!(
                    "the document's unit is {other}, and must be Millimeters, Centimeters, Meters, Inches or Feet, \
                     unless Options name the unit of the numbers, such as {example}"
                ));
                return;
            }
        };
        let request = &mut self.draft.request;
        if has_forces {
            request.entry("units").or_insert_with(|| json!({}))["length"] = unit.symbol().into();
        } else {
            request.insert("units".into(), unit.symbol().into());
        }
    }
}

/// Returns a key that is the same for equal points.
fn bits(point: Point) -> [u64; 3] {
    // Adding 0 makes -0 and 0 equal.
    point.map(|coordinate| (coordinate + 0.0).to_bits())
}

fn distance(a: Point, b: Point) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Returns the diagonal of the box around points.
fn size(points: &[Point]) -> f64 {
    let extent = |k: usize| {
        let (low, high) = points
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), point| (low.min(point[k]), high.max(point[k])));
        high - low
    };
    distance([extent(0), extent(1), extent(2)], [0.0; 3])
}

/// Segment of a polygon that is nearest to a point.
struct Nearest {
    /// Index of the segment's first point.
    segment: usize,
    distance: f64,
}

fn nearest(polygon: &[Point], point: Point) -> Nearest {
    let mut best = Nearest { segment: 0, distance: f64::INFINITY };
    for (segment, &from) in polygon.iter().enumerate() {
        let to = polygon[(segment + 1) % polygon.len()];
        let along: Point = std::array::from_fn(|k| to[k] - from[k]);
        let length = along.iter().map(|part| part * part).sum::<f64>();
        let dot = (0..3).map(|k| (point[k] - from[k]) * along[k]).sum::<f64>();
        let fraction = if length > 0.0 { (dot / length).clamp(0.0, 1.0) } else { 0.0 };
        let foot: Point = std::array::from_fn(|k| from[k] + fraction * along[k]);
        let found = distance(foot, point);
        if found < best.distance {
            best = Nearest { segment, distance: found };
        }
    }
    best
}

/// Joins equal vertices of a mesh, because Rhino's meshes often have one vertex for each face. Splits quadrilaterals
/// along their shorter diagonals, and leaves out triangles that use a vertex twice and vertices of no triangle.
fn joined(mesh: &Mesh) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mut numbers: HashMap<[u64; 3], u32> = HashMap::new();
    let mut vertices = Vec::new();
    let mut number = |vertex: u32| {
        let point = mesh.vertices[vertex as usize].to_array();
        *numbers.entry(bits(point)).or_insert_with(|| {
            vertices.push(point);
            vertices.len() as u32 - 1
        })
    };
    let mut triangles = Vec::new();
    for &[a, b, c, d] in &mesh.faces {
        let position = |vertex: u32| mesh.vertices[vertex as usize];
        let triangle = [[a, b, c]];
        let halves = if position(a).distance(position(c)) <= position(b).distance(position(d)) {
            [[a, b, c], [a, c, d]]
        } else {
            [[a, b, d], [b, c, d]]
        };
        let parts: &[[u32; 3]] = if c == d { &triangle } else { &halves };
        for part in parts {
            let [a, b, c] = part.map(&mut number);
            if a != b && b != c && c != a {
                triangles.push([a, b, c]);
            }
        }
    }
    (vertices, triangles)
}

/// Returns the boundary loops of a mesh, which consist of the edges that belong to only one triangle. A loop has the
/// direction that these triangles give to its edges.
fn naked_edges(triangles: &[[u32; 3]]) -> Result<Vec<Vec<u32>>, String> {
    let mut count: HashMap<[u32; 2], usize> = HashMap::new();
    let edges = || triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    for [from, to] in edges() {
        *count.entry([from.min(to), from.max(to)]).or_default() += 1;
    }
    // The map is ordered, so that the loops do not depend on the seed of a hash.
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for [from, to] in edges().filter(|&[from, to]| count[&[from.min(to), from.max(to)]] == 1) {
        next.entry(from).or_default().push(to);
    }
    let mut loops = Vec::new();
    while let Some((&start, _)) = next.first_key_value() {
        let mut line = vec![start];
        loop {
            let at = line[line.len() - 1];
            let Some(to) = next.get_mut(&at).and_then(Vec::pop) else {
                return Err("its faces have different orientations; unify the mesh's normals".into());
            };
            if next[&at].is_empty() {
                next.remove(&at);
            }
            if to == start {
                break;
            }
            line.push(to);
        }
        loops.push(line);
    }
    if loops.is_empty() { Err("has no naked edges, and a film needs a boundary".into()) } else { Ok(loops) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_engine::kinds::minimal_surface;
    use plateau_mesh::DVec3;

    #[test]
    fn errors_name_inputs_and_points() {
        let mut draft = UncheckedRequest { kind: minimal_surface::KIND, request: Map::new(), places: BTreeMap::new() };
        for (pointer, input) in [
            ("/boundaries", "Boundaries"),
            ("/boundaries/1", "Boundaries[1]"),
            ("/resolution", "Triangles"),
            ("/constraints", "Options /constraints"),
        ] {
            draft.places.insert(pointer.into(), input.into());
        }
        for (pointer, line) in [
            ("/boundaries", "Boundaries: wrong"),
            ("/boundaries/1", "Boundaries[1]: wrong"),
            ("/boundaries/1/5", "Boundaries[1], point 5: wrong"),
            ("/boundaries/1/5/2", "Boundaries[1], point 5: wrong"),
            ("/boundaries/0/5", "Boundaries /0/5: wrong"),
            ("/resolution/triangles", "Triangles /triangles: wrong"),
            ("/constraints/points/3", "Options /constraints /points/3: wrong"),
            ("/solver", "/solver: wrong"),
            ("", "wrong"),
        ] {
            assert_eq!(draft.line(&FieldError::new(pointer, "wrong")), line);
        }
    }

    #[test]
    fn equal_vertices_are_joined_and_quadrilaterals_split_along_their_shorter_diagonal() {
        let vertices =
            [[0.0, 0.0], [3.0, 0.0], [4.0, 1.0], [1.0, 1.0], [-0.0, 0.0], [1.0, 1.0], [0.0, 5.0], [9.0, 9.0]];
        let vertices = vertices.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        let mesh = Mesh { vertices, faces: vec![[0, 1, 2, 3], [4, 5, 6, 6], [4, 0, 5, 5]] };
        let (vertices, triangles) = joined(&mesh);
        assert_eq!(vertices.len(), 5);
        // The diagonal from (3, 0) to (1, 1) is the shorter one. The last face has no area.
        assert_eq!(triangles, [[0, 1, 2], [1, 3, 2], [0, 2, 4]]);
        assert_eq!(naked_edges(&triangles), Ok(vec![vec![0, 1, 3, 2, 4]]));
        assert!(naked_edges(&[[0, 1, 2], [0, 2, 1]]).unwrap_err().contains("no naked edges"));
        assert!(naked_edges(&[[0, 1, 2], [0, 1, 3]]).is_err());
    }
}
