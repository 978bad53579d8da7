//! Examples are mutated at random and taken from body to archive. Every request must give a mesh or an error that names
//! a value. A panic or an endless solve is a defect.
//!
//! `PLATEAU_LONG=1` tries twenty times as many requests. `PLATEAU_SEED` selects other mutations.

use crate::LIMITS;
use plateau_archive::Archive;
use plateau_archive::formats::MeshFormat;
use plateau_engine::kind::Kind;
use plateau_engine::limits::Limits;
use plateau_engine::request::Request;
use plateau_engine::schema;
use plateau_engine::solved::{Signal, Unsolved};
use plateau_engine::source::no_jobs;
use plateau_mesh::random::SplitMix64;
use plateau_strict_json::json;
use plateau_strict_json::rejection::Rejection;
use serde_json::{Map, Value};
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

struct Random(SplitMix64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0.next_u64()
    }
    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }
    fn pick<'a, T>(&mut self, from: &'a [T]) -> &'a T {
        &from[self.below(from.len())]
    }
}

const NUMBERS: [f64; 26] = [
    0.0, -0.0, 1.0, -1.0, 0.5, 3.0, 2.0, 0.1, 7.0, 1e-3, -1e-9, 1e-6, 1e6, 1e7, -1e7, 1e15, 1e-12, 1e25, 1e-40, 1e-80,
    1e69, 5e-324, 1e-160, 1e-300, 1e99, 1e300,
];

/// Returns the examples with few triangles, which are quicker. Their points stay, because fewer points would be another
/// shape.
fn examples() -> Vec<Value> {
    let folder = crate::root().join("api/examples");
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let read = |file| {
        let mut value: Value = serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap();
        if value["kind"] == "minimal_surface" || value["kind"] == "tensile_structure" {
            value["resolution"] = serde_json::json!({ "triangles": 300 });
            value["max_iterations"] = serde_json::json!(40);
        }
        if value["kind"] == "uniform_mesh"
            && let Some(length) = value["edge_length"].as_f64()
        {
            value["edge_length"] = serde_json::json!(2.0 * length);
        }
        value
    };
    files.iter().map(read).collect()
}

/// Returns every polyline of the request: every array of arrays of three numbers.
fn polylines(value: &mut Value) -> Vec<&mut Vec<Value>> {
    let is_point = |value: &Value| value.as_array().is_some_and(|p| p.len() == 3 && p.iter().all(Value::is_number));
    match value {
        Value::Array(list) => {
            if list.first().is_some_and(is_point) {
                vec![list]
            } else {
                list.iter_mut().flat_map(polylines).collect()
            }
        }
        Value::Object(map) => map.values_mut().flat_map(polylines).collect(),
        _ => Vec::new(),
    }
}

/// Returns every value that is not a container.
fn leaves(value: &mut Value) -> Vec<&mut Value> {
    match value {
        Value::Array(list) => list.iter_mut().flat_map(leaves).collect(),
        Value::Object(map) => map.values_mut().flat_map(leaves).collect(),
        leaf => vec![leaf],
    }
}

fn each_coordinate(value: &mut Value, mut change: impl FnMut(usize, f64) -> f64) {
    for polyline in polylines(value) {
        for point in polyline.iter_mut().filter_map(Value::as_array_mut) {
            for (axis, coordinate) in point.iter_mut().enumerate() {
                *coordinate = serde_json::json!(change(axis, coordinate.as_f64().unwrap_or(0.0)));
            }
        }
    }
}

/// Applies a random change, such as a client, a script or a person might make by mistake.
fn mutate(request: &mut Value, others: &[Value], random: &mut Random) {
    let other = random.pick(others).clone();
    let number = *random.pick(&NUMBERS);
    let axis = random.below(3);
    match random.below(16) {
        // A value is replaced by another.
        0 | 1 => {
            let mut all = leaves(request);
            let at = random.below(all.len());
            *all[at] = match random.below(6) {
                0 => Value::Null,
                1 => serde_json::json!("minimal_area"),
                2 => serde_json::json!(true),
                3 => serde_json::json!([]),
                _ => serde_json::json!(number),
            };
        }
        // A field is taken from another example.
        2 | 3 => {
            let fields: Vec<String> = other.as_object().unwrap().keys().filter(|key| *key != "kind").cloned().collect();
            let key = random.pick(&fields).clone();
            request[key.as_str()] = other[key.as_str()].clone();
        }
        4 => {
            let keys: Vec<String> = request.as_object().unwrap().keys().filter(|key| *key != "kind").cloned().collect();
            request.as_object_mut().unwrap().remove(random.pick(&keys));
        }
        // The whole shape becomes flat, tiny, huge, far away, rounded or noisy.
        5 => each_coordinate(request, |a, c| if a == axis { 0.0 } else { c }),
        6 => each_coordinate(request, |_, c| c * number),
        7 => each_coordinate(request, |a, c| if a == axis { c + number } else { c }),
        8 => each_coordinate(request, |_, c| c.round()),
        9 => each_coordinate(request, |_, c| c + (random.below(2001) as f64 / 1000.0 - 1.0) * 0.3),
        // A polyline gets a repeated point, a moved point, two swapped points or one fewer, or is reversed or cut
        // short.
        operation => {
            let mut all = polylines(request);
            if all.is_empty() {
                return;
            }
            let at = random.below(all.len());
            let line = &mut *all[at];
            if line.is_empty() {
                return;
            }
            let (a, b) = (random.below(line.len()), random.below(line.len()));
            match operation {
                10 => line.insert(a, line[b].clone()),
                11 => line[a][axis] = serde_json::json!(line[a][axis].as_f64().unwrap_or(0.0) + number),
                12 => line.swap(a, b),
                13 => {
                    line.remove(a);
                }
                14 => line.reverse(),
                _ => line.truncate(a),
            }
        }
    }
}

/// Number of times that a solver may ask for its signal before it is told that its deadline has passed.
const CHECKS_BEFORE_DEADLINE: u64 = 100;
/// Number of times that a solver may ask for its signal before it counts as hanging.
const CHECKS_UNTIL_HANGING: u64 = 10 * CHECKS_BEFORE_DEADLINE;

/// Returns whether a member at any depth is null or an empty list.
fn has_empty(value: &Value) -> bool {
    match value {
        Value::Object(members) => {
            members.values().any(|member| member.is_null() || member == &Value::Array(Vec::new()) || has_empty(member))
        }
        Value::Array(items) => items.iter().any(has_empty),
        _ => false,
    }
}

/// Checks that a request is the same whether it is read from its bytes, from a JSON value, or as a worker reads it.
fn all_ways_agree(body: &[u8], limits: &Limits) -> Result<(), String> {
    let value = json::parse(body).map_err(|rejection| format!("{rejection:?}"))?;
    let Some(kind) = value["kind"].as_str().and_then(Kind::from_name) else { return Ok(()) };
    let from_value = || Request::from_value(kind, &value, &no_jobs, limits);
    // Members that are null or an empty list are read from the value only.
    let read = Request::read(kind, body, &[], &no_jobs, limits);
    let read = if has_empty(&value) { read.or_else(|| Some((from_value().ok()?, Map::new()))) } else { read };
    match (read, from_value()) {
        (Some((one, _)), Ok(other)) => {
            schema::validate(kind, &value).map_err(|error| format!("accepted against the schema: {error:?}"))?;
            let stored = Request::read_stored(kind, &one.text, &no_jobs, limits);
            let stored = stored.map_err(|error| format!("stored: {error:?}"))?;
            let requests = [&one.request, &other.request, &stored].map(|request| format!("{request:?}"));
            let same = requests.iter().all(|request| *request == requests[0]) && one.text == other.text;
            if same { Ok(()) } else { Err("the ways of reading differ".into()) }
        }
        (None, Err(_)) => Ok(()),
        (one, other) => Err(format!("from bytes {:?}, from a value {:?}", one.map(drop), other.map(drop))),
    }
}

/// Returns how a request ended, or an error if it shows a defect.
fn outcome(body: &[u8], limits: &Limits) -> Result<&'static str, String> {
    all_ways_agree(body, limits)?;
    let parsed = json::parse(body).map_err(|rejection| format!("called malformed: {rejection:?}"))?;
    let accepted = match Request::read_with_kind(&parsed, &no_jobs, limits) {
        Ok(accepted) => accepted,
        Err(Rejection::Malformed(detail)) => return Err(format!("called malformed: {detail}")),
        Err(Rejection::Invalid(errors) | Rejection::TooLarge(errors)) => {
            let document: Value = serde_json::from_slice(body).unwrap();
            if errors.is_empty() {
                return Err("refused without an error".to_owned());
            }
            for error in &errors {
                // A missing field is named below its parent.
                let parent = error.pointer.rsplit_once('/').map_or("", |(parent, _)| parent);
                if document.pointer(parent).is_none() || error.detail.is_empty() {
                    return Err(format!("{} is not a place in the request: {}", error.pointer, error.detail));
                }
            }
            return Ok("refused");
        }
    };
    let looks = Cell::new(0);
    let signal = || {
        looks.set(looks.get() + 1);
        assert!(looks.get() < CHECKS_UNTIL_HANGING, "the solver continues after its deadline");
        if looks.get() > CHECKS_BEFORE_DEADLINE { Signal::Deadline } else { Signal::Continue }
    };
    match accepted.request.solve(&signal, &|_| {}) {
        Ok(solved) => {
            let bytes = solved.archive.to_bytes().map_err(|defect| format!("its archive: {defect}"))?;
            Archive::from_bytes(&bytes).map_err(|defect| format!("its archive: {defect}"))?;
            // glTF refuses a mesh of 1e99 m, because its coordinates have 32 bits. OBJ can hold every mesh.
            let _ = MeshFormat::Glb.encode(&solved.archive);
            MeshFormat::Obj.encode(&solved.archive).map_err(|error| format!("its OBJ: {error}"))?;
            Ok("solved")
        }
        Err(Unsolved::Cancelled) => Ok("interrupted"),
        Err(Unsolved::Failed(error)) => match error.kind.trim_start_matches("/problems/") {
            kind @ ("audit-failed" | "internal" | "invalid-mesh") => Err(format!("{kind}: {}", error.detail)),
            "deadline" => Ok("interrupted"),
            "invalid-geometry" if error.errors.is_empty() => Err("refused without a reason".into()),
            "invalid-geometry" => Ok("refused by the solver"),
            kind if error.detail.is_empty() => Err(format!("{kind} without a detail")),
            _ => Ok("no result"),
        },
    }
}

/// Returns how a request ended, or the defect together with the request.
fn check(body: &[u8], limits: &Limits) -> Result<&'static str, String> {
    let shown = |defect: &str| format!("{defect}\n{}", String::from_utf8_lossy(body));
    match catch_unwind(AssertUnwindSafe(|| outcome(body, limits))) {
        Ok(outcome) => outcome.map_err(|defect| shown(&defect)),
        Err(_) => Err(shown("a panic")),
    }
}

#[test]
fn every_mutated_example_gets_a_mesh_or_an_error() {
    let limits = Limits { points: 3_000, triangles: 4_000, grid_cells: 2_000_000, iterations: 100, ..LIMITS };
    let examples = examples();
    let long = if std::env::var_os("PLATEAU_LONG").is_some() { 20 } else { 1 };
    let seed = std::env::var("PLATEAU_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(20_261_121);
    let mut random = Random(SplitMix64::new(seed));
    let mut seen = std::collections::BTreeMap::new();
    let mut defects = Vec::new();
    for _ in 0..400 * long {
        let mut request = random.pick(&examples).clone();
        for _ in 0..=random.below(3) {
            mutate(&mut request, &examples, &mut random);
        }
        match check(request.to_string().as_bytes(), &limits) {
            Ok(outcome) => *seen.entry(outcome).or_insert(0) += 1,
            Err(defect) => defects.push(defect),
        }
    }
    println!("{seen:?}");
    assert!(defects.is_empty(), "{} defects:\n{}", defects.len(), defects.join("\n"));
    assert!(seen["solved"] > 40 && seen["refused"] > 40, "too few of a kind: {seen:?}");
}
