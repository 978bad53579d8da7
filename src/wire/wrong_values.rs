//! Puts a wrong value at every place of the examples and of bodies made from the schemas, and
//! checks that the first error points to that place in plain words. The schemas are read here as
//! JSON, apart from the code that explains them, and the crate jsonschema says independently which
//! bodies are valid. The types of the requests have to refuse every wrong value without the schema.

use super::batch::{BATCH, refuse_shell};
use super::components::components;
use super::envelope::Envelope;
use super::incoming::Incoming;
use super::objectives;
use crate::config::LimitsConfig;
use plateau_engine::components::request_component;
use plateau_engine::kind::Kind;
use plateau_engine::request::Request;
use plateau_engine::schema;
use plateau_engine::source::no_jobs;
use plateau_strict_json::rejection::{FieldError, Rejection};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// A member name and a string that no schema allows. No error may contain them, except for the pointer to the member.
const UNKNOWN: &str = "zq";

/// Every form that an error's text may have. `*` stands for names, numbers and examples.
const FORMS: [&str; 28] = [
    "must be true or false",
    "must be true, false or an object",
    "must be a number",
    "must be an integer",
    "must be a string",
    "must be a list",
    "must be an object",
    "must be an object, such as *",
    "must be an object with the member *",
    "must be an object with the members *",
    "must be an object with exactly one of the members *",
    "must be an object with at least one of the members *",
    "must be a point or vector [x, y, z], such as *",
    "must be a list of points [x, y, z], such as *",
    "must be a list of polylines, which are lists of points [x, y, z], such as *",
    "must be one of *",
    "must be at least *",
    "must be at most *",
    "must be more than *",
    "must be less than *",
    "must have at least *",
    "must have at most *",
    "must have exactly *",
    "must have three coordinates [x, y, z]*",
    "is required",
    "is not a member of this object",
    "is not a member of this object; did you mean *",
    "is not a member of this object, whose members are *",
];

fn has_form(text: &str, form: &str) -> bool {
    match form.split_once('*') {
        None => text == form,
        Some((start, end)) => text.strip_prefix(start).is_some_and(|rest| rest.ends_with(end)),
    }
}

/// Returns true if a text names the only value that the schema of a field `kind` allows.
fn names_a_kind(text: &str) -> bool {
    Kind::ALL.iter().any(|kind| has_form(text, &format!("must be {}", kind.name())))
}

fn resolved(schema: &'static Value) -> &'static Value {
    match schema["$ref"].as_str().and_then(|reference| reference.rsplit('/').next()) {
        Some(name) => resolved(&components()[name]),
        None => schema,
    }
}

/// Returns the schemas of a union, or the schema itself.
fn branches(schema: &'static Value) -> Vec<&'static Value> {
    let schema = resolved(schema);
    match schema.get("anyOf").or(schema.get("oneOf")).and_then(Value::as_array) {
        Some(parts) => parts.iter().flat_map(branches).collect(),
        None => vec![schema],
    }
}

/// Returns the types of JSON that a schema without branches allows.
fn types(branch: &Value) -> Vec<&str> {
    match &branch["type"] {
        Value::String(one) => vec![one],
        Value::Array(list) => list.iter().filter_map(Value::as_str).collect(),
        _ => vec!["null", "boolean", "number", "string", "array", "object"],
    }
}

fn is_of_type(value: &Value, name: &str) -> bool {
    match value {
        Value::Null => name == "null",
        Value::Bool(_) => name == "boolean",
        Value::Number(number) => name == "number" || name == "integer" && !number.is_f64(),
        Value::String(_) => name == "string",
        Value::Array(_) => name == "array",
        Value::Object(_) => name == "object",
    }
}

fn allows_type(branch: &Value, value: &Value) -> bool {
    types(branch).iter().any(|name| is_of_type(value, name))
}

/// Returns the branch that a valid value satisfies.
fn branch_of(schema: &'static Value, value: &Value) -> &'static Value {
    let all = branches(schema);
    let fits = |branch: &&'static Value| {
        let kinds = branch["properties"]["kind"]["enum"].as_array();
        allows_type(branch, value) && kinds.is_none_or(|kinds| kinds.contains(&value["kind"]))
    };
    all.iter().copied().find(fits).unwrap_or_else(|| panic!("no branch for {value}"))
}

fn size(branch: &Value, keyword: &str) -> Option<usize> {
    branch[keyword].as_u64().map(|size| size as usize)
}

/// Returns values that satisfy a schema: at least one for each branch of it and of the schemas in it.
fn samples(schema: &'static Value) -> Vec<Value> {
    branches(schema)
        .into_iter()
        .flat_map(|branch| types(branch).into_iter().flat_map(|name| of_type(branch, name)))
        .collect()
}

fn of_type(branch: &'static Value, name: &str) -> Vec<Value> {
    if let Some(values) = branch["enum"].as_array() {
        return vec![values[0].clone()];
    }
    match name {
        "null" => vec![Value::Null],
        "boolean" => vec![true.into()],
        "number" | "integer" => {
            let fits = |number: &f64| {
                branch["minimum"].as_f64().is_none_or(|least| *number >= least)
                    && branch["maximum"].as_f64().is_none_or(|most| *number <= most)
            };
            let number = [1.0, 2.0, 3.0].into_iter().find(fits).expect("a number of 1, 2 and 3 fits every schema");
            vec![json!(number as u64)]
        }
        "string" => vec!["x".into()],
        "array" => {
            let count = size(branch, "minItems").unwrap_or(0).max(1);
            let items = branch.get("items").map_or_else(|| vec![json!(1)], samples);
            items.into_iter().map(|item| Value::Array(vec![item; count])).collect()
        }
        _ => objects(branch),
    }
}

fn objects(branch: &'static Value) -> Vec<Value> {
    let Some(properties) = branch["properties"].as_object() else { return vec![json!({ "any": 1 })] };
    let of_each =
        || properties.iter().flat_map(|(name, schema)| samples(schema).into_iter().map(move |value| (name, value)));
    if size(branch, "maxProperties").is_some_and(|most| most < properties.len()) {
        // A member that is null counts as left out, and the object needs one member.
        return of_each().filter(|(_, value)| !value.is_null()).map(|(name, value)| json!({ name: value })).collect();
    }
    let base: Value = properties.iter().map(|(name, schema)| (name.clone(), samples(schema).swap_remove(0))).collect();
    let varied = of_each().map(|(name, value)| {
        let mut object = base.clone();
        object[name] = value;
        object
    });
    std::iter::once(base.clone()).chain(varied).collect()
}

/// A change that makes a value invalid: the new value, and the pointer from it to the error.
type Wrong = (Value, String);

/// Returns a value of each type of JSON.
fn probes() -> [Value; 7] {
    [json!(null), json!(true), json!(7), json!(2.5), json!(UNKNOWN), json!([]), json!({})]
}

/// Returns invalid variants of a valid value.
fn wrong_values(schema: &'static Value, value: &Value) -> Vec<Wrong> {
    let mut wrong: Vec<Wrong> = Vec::new();
    let mut here = |value: Value| wrong.push((value, String::new()));
    let all = branches(schema);
    for probe in probes() {
        match all.iter().filter(|branch| allows_type(branch, &probe)).count() {
            0 => here(probe),
            1 => {}
            _ => assert!(resolved(schema).get("discriminator").is_some(), "the type does not choose a branch: {all:?}"),
        }
    }
    for names in all.iter().filter_map(|branch| branch["enum"].as_array()) {
        here(UNKNOWN.into());
        // Types that serde derives would accept the name of an enum's value as the key of an object, and the members of
        // a struct as a list. Both forms must be refused.
        if !all.iter().any(|branch| allows_type(branch, &json!({}))) {
            here(json!({ names[0].as_str().unwrap_or_default(): null }));
        }
    }
    if let Some(members) = value.as_object().filter(|_| !all.iter().any(|branch| allows_type(branch, &json!([])))) {
        here(members.values().cloned().collect());
    }
    let branch = branch_of(schema, value);
    match value {
        Value::Number(_) => {
            let bound = |keyword: &str| branch[keyword].as_f64();
            bound("minimum").into_iter().for_each(|least| here(json!(least - least.abs().max(1.0))));
            bound("maximum").into_iter().for_each(|most| here(json!(most + most.abs().max(1.0))));
            bound("exclusiveMinimum").into_iter().for_each(|least| here(json!(least)));
            bound("exclusiveMaximum").into_iter().for_each(|most| here(json!(most)));
        }
        Value::String(_) => {
            size(branch, "minLength").into_iter().for_each(|_| here("".into()));
            size(branch, "maxLength").into_iter().for_each(|most| here(UNKNOWN.repeat(most).into()));
        }
        Value::Array(list) => {
            if let Some(least) = size(branch, "minItems").filter(|&least| least > 0) {
                // An empty list counts as left out if the member is optional.
                if schema.get("x-optional").is_none() || least > 1 {
                    here(list[..least - 1].into());
                }
                if schema.get("x-optional").is_none() {
                    here(json!([]));
                }
            }
            if let (Some(most), Some(last)) = (size(branch, "maxItems").filter(|&most| most <= 200), list.last()) {
                here(vec![last.clone(); most + 1].into());
            }
        }
        Value::Object(members) => {
            let required = branch["required"].as_array().map_or(&[][..], Vec::as_slice);
            if size(branch, "minProperties").is_some_and(|least| least > 0) && required.is_empty() {
                here(json!({}));
            }
            if let (Some(most), Some(properties)) = (size(branch, "maxProperties"), branch["properties"].as_object()) {
                let more = properties.iter().take(most + 1);
                here(more.map(|(name, schema)| (name.clone(), samples(schema).swap_remove(0))).collect());
            }
            if branch["additionalProperties"] == false {
                let mut more = members.clone();
                more.insert(UNKNOWN.into(), Value::Null);
                wrong.push((more.into(), format!("/{UNKNOWN}")));
            }
            for name in required.iter().filter_map(Value::as_str) {
                let mut fewer = members.clone();
                fewer.remove(name);
                wrong.push((fewer.into(), format!("/{name}")));
            }
        }
        Value::Null | Value::Bool(_) => {}
    }
    wrong
}

/// Calls `visit` with the pointer, the schema and the value at every place of a valid value. Of the
/// elements of an array it visits the first and the last.
fn walk(schema: &'static Value, value: &Value, pointer: &str, visit: &mut impl FnMut(&str, &'static Value, &Value)) {
    visit(pointer, schema, value);
    let branch = branch_of(schema, value);
    match value {
        Value::Array(list) => {
            let ends: BTreeSet<usize> =
                [0, list.len().wrapping_sub(1)].into_iter().filter(|&k| k < list.len()).collect();
            for k in ends {
                walk(&branch["items"], &list[k], &format!("{pointer}/{k}"), visit);
            }
        }
        Value::Object(members) => {
            for (name, member) in members.iter().filter(|(name, _)| branch["properties"].get(name.as_str()).is_some()) {
                walk(&branch["properties"][name.as_str()], member, &format!("{pointer}/{name}"), visit);
            }
        }
        _ => {}
    }
}

/// Returns a value with at most four elements in each array.
fn shortened(value: &Value) -> Value {
    match value {
        Value::Array(list) => list.iter().take(4).map(shortened).collect(),
        Value::Object(members) => members.iter().map(|(name, member)| (name.clone(), shortened(member))).collect(),
        other => other.clone(),
    }
}

/// Makes the validator of the crate jsonschema for a schema of the API document.
fn reference_validator(component: &str) -> jsonschema::Validator {
    let reference = format!("#/components/schemas/{component}");
    jsonschema::validator_for(&json!({ "$ref": reference, "components": { "schemas": components() } })).unwrap()
}

/// Reads the envelope of a request, and validates the rest.
fn refused(body: &Value, validate: impl Fn(&Value) -> Result<(), Rejection>) -> Result<(), Rejection> {
    let mut rest = body.clone();
    Envelope::take(&mut rest).map(drop).and_then(|()| validate(&rest))
}

fn refused_batch(body: &Value) -> Result<(), Rejection> {
    refuse_shell(body)?;
    let requests = body["requests"].as_array().into_iter().flatten().enumerate();
    for (index, request) in requests {
        refused(request, schema::validate_with_kind)
            .map_err(|rejection| rejection.within(&format!("/requests/{index}")))?;
    }
    Ok(())
}

/// Returns true if the types and the checks of a kind, without its schema, refuse a body with an error at `place`.
fn refused_by_type(kind: Kind, body: &Value, place: &str) -> bool {
    let mut rest = body.clone();
    if Envelope::take(&mut rest).is_err() {
        return true;
    }
    match Request::without_schema(kind, &rest, &LimitsConfig::default().requests()) {
        Err(Some(Rejection::Invalid(errors))) => errors.iter().any(|error| error.pointer == place),
        Err(None) => true,
        _ => false,
    }
}

/// Checks every wrong value at every place of valid bodies. Returns the places and the number of wrong values.
fn check(
    component: &str,
    bodies: &[Value],
    validate: impl Fn(&Value) -> Result<(), Rejection>,
    refused_by_type: impl Fn(&Value, &str) -> bool,
    defects: &mut Vec<String>,
) -> (BTreeSet<String>, usize) {
    let root = &components()[component];
    let reference = reference_validator(component);
    let (mut seen, mut places, mut tried) = (BTreeSet::new(), BTreeSet::new(), 0);
    for body in bodies {
        assert!(validate(body).is_ok() && reference.is_valid(body), "{component}: {body}");
        walk(root, body, "", &mut |pointer, schema, value| {
            let branch: *const Value = branch_of(schema, value);
            if !seen.insert((pointer.to_owned(), branch)) {
                return;
            }
            places.insert(pointer.to_owned());
            let with = |value: &Value| {
                let mut changed = body.clone();
                *changed.pointer_mut(pointer).expect("a place of the body") = value.clone();
                changed
            };
            for probe in probes() {
                let changed = with(&probe);
                if validate(&changed).is_ok() != reference.is_valid(&changed) {
                    defects.push(format!("{component} {pointer}: jsonschema differs for {probe}"));
                }
            }
            for (wrong, below) in wrong_values(schema, value) {
                tried += 1;
                let changed = with(&wrong);
                let expected = format!("{pointer}{below}");
                if !refused_by_type(&changed, pointer) {
                    defects.push(format!("{component} {expected}: only the schema refuses {wrong}"));
                }
                let found = match validate(&changed) {
                    Err(Rejection::Invalid(errors)) => errors,
                    other => {
                        defects.push(format!("{component} {expected}: {other:?} for {wrong}"));
                        continue;
                    }
                };
                let FieldError { pointer: place, detail } = &found[0];
                let plain = FORMS.iter().any(|form| has_form(detail, form)) || names_a_kind(detail);
                if *place != expected || !plain || detail.contains(UNKNOWN) {
                    defects.push(format!("{component} {expected}: {place} {detail}"));
                }
            }
        });
    }
    (places, tried)
}

/// Places of the bodies of each kind that the test below must reach.
const EXPECTED: [(&str, &[&str]); 5] = [
    ("ruled_surface", &["/objective/weights/minimal_twist", "/sampling/tolerance", "/normals/0/0/2"]),
    (
        "minimal_surface",
        &[
            "/initial_mesh/vertices/0/0",
            "/initial_mesh/triangles/0/0",
            "/resolution/interior_vertices",
            "/processes/0/together/0",
            "/certify/seconds",
            "/constraints/points/0",
            "/constraints/polylines/0/1/0",
        ],
    ),
    ("uniform_mesh", &["/domain/polygon/0", "/domain/nurbs/weights/0/0", "/domain/boundaries/0/2/0"]),
    (
        "tensile_structure",
        &[
            "/cables/0/along/from",
            "/cables/0/across/1",
            "/cables/0/points/0",
            "/supports/0/on/mesh/triangles/0",
            "/supports/0/contact_angle_deg",
            "/film/direction/radial",
        ],
    ),
    ("cable_net", &["/edges/0/1", "/supports/0", "/cables/0/edges/0", "/loads/0/vertices/0", "/units/force"]),
];

#[test]
fn the_error_for_each_wrong_value_points_to_it_in_plain_words() {
    let mut defects = Vec::new();
    let mut tried = 0;
    for &kind in Kind::ALL {
        let component = &*request_component(kind);
        let bodies = valid_bodies(kind);
        let (places, count) = check(
            component,
            &bodies,
            |body| refused(body, |request| schema::validate(kind, request)),
            |body, place| refused_by_type(kind, body, place),
            &mut defects,
        );
        tried += count;
        let expected = EXPECTED.iter().filter(|(name, _)| *name == kind.name()).flat_map(|(_, places)| *places);
        let missed = expected.filter(|place| !places.contains(**place));
        defects.extend(missed.map(|place| format!("{component} {place}: is not reached")));
    }
    let example = |kind: &Kind| objectives::examples().iter().find(|example| example.kind == *kind);
    let batches: Vec<Value> = Kind::ALL
        .iter()
        .filter_map(example)
        .map(|example| json!({ "requests": [shortened(&example.request)], "callback_url": "https://example.org" }))
        .collect();
    let (places, count) = check(BATCH, &batches, refused_batch, |_, _| true, &mut defects);
    tried += count;
    assert!(places.contains("/requests/0/boundaries/0/0/2") && places.contains("/requests/0/supports/0"), "{places:?}");
    println!("{tried} wrong values");
    assert!(tried > 3_000, "{tried}");
    assert!(defects.is_empty(), "{} of {tried}:\n{}", defects.len(), defects.join("\n"));
}

/// Returns the valid bodies of a kind: its examples, shortened, and bodies made from its schema.
fn valid_bodies(kind: Kind) -> Vec<Value> {
    let examples = objectives::examples().iter().filter(|example| example.kind == kind);
    let mut bodies: Vec<Value> = examples.map(|example| shortened(&example.request)).collect();
    bodies.extend(samples(&components()[&*request_component(kind)]));
    bodies
}

#[test]
fn an_integer_may_be_written_with_a_point() {
    let mut tried = 0;
    for &kind in Kind::ALL {
        let root = &components()[&*request_component(kind)];
        for body in valid_bodies(kind) {
            walk(root, &body, "", &mut |pointer, _, value| {
                let Some(integer) = value.as_i64() else { return };
                let mut pointed = body.clone();
                *pointed.pointer_mut(pointer).expect("a place of the body") = json!(integer as f64);
                Envelope::take(&mut pointed).expect("the envelope has no integers");
                let read = Request::without_schema(kind, &pointed, &LimitsConfig::default().requests());
                assert_ne!(read, Err(None), "{}{pointer}: {integer}.0 in {body}", kind.name());
                tried += 1;
            });
        }
    }
    assert!(tried > 500, "{tried}");
}

#[test]
fn a_key_that_any_object_repeats_is_refused() {
    const HERE: &str = "@here@";
    let limits = LimitsConfig::default();
    let mut tried = 0;
    for example in objectives::examples() {
        let mut body = example.request.clone();
        body["metadata"] = json!({ "a": { "b": [] } });
        let read = |text: &str| Incoming::read(example.kind, text.as_bytes(), &no_jobs, &limits);
        read(&body.to_string()).unwrap_or_else(|error| panic!("{}: {error:?}", example.name));
        let mut objects = vec![String::new()];
        walk(&components()[&*request_component(example.kind)], &body, "", &mut |pointer, _, value| {
            if value.is_object() {
                objects.push(pointer.to_owned());
            }
        });
        objects.extend(["/metadata".into(), "/metadata/a".into()]);
        for pointer in objects {
            let mut marked = body.clone();
            let object = marked.pointer_mut(&pointer).expect("a place of the body").take();
            let Some((name, value)) = object.as_object().and_then(|members| members.iter().next()) else { continue };
            let repeated = object.to_string().replacen('{', &format!("{{{}:{value},", json!(name)), 1);
            let text = if pointer.is_empty() {
                repeated
            } else {
                *marked.pointer_mut(&pointer).expect("a place of the body") = HERE.into();
                marked.to_string().replace(&json!(HERE).to_string(), &repeated)
            };
            let refused = read(&text);
            assert!(
                matches!(&refused, Err(Rejection::Malformed(detail)) if detail.starts_with("an object repeats a key")),
                "{} {pointer}: {refused:?}",
                example.name
            );
            tried += 1;
        }
    }
    assert!(tried > 60, "{tried}");
}
