//! Explains errors about points and lists of points. The schema only says that an array is too short or of another type;
//! a beginner needs to see the form that was expected.

use super::components::{components, request_component};
use super::{FieldError, Kind};
use serde_json::{Value, json};

/// Detail of the error for points in place of the object that says what a uniform mesh spans.
const DOMAIN: &str =
    r#"is a list: it is an object that says what it holds, such as {"polygon": [[0, 0, 0], [4, 0, 0], [4, 3, 0]]}"#;

/// Replaces the details of errors at points and at lists of points by the expected form with an example. If a whole list
/// lacks a level of brackets, one error at the list replaces those at each of its values.
pub(super) fn explain(kind: Kind, body: &Value, errors: &mut Vec<FieldError>) {
    let mut flat: Vec<String> = Vec::new();
    for error in errors.iter_mut() {
        if kind == Kind::UniformMesh && error.pointer == "/domain" && body["domain"].is_array() {
            error.detail = DOMAIN.into();
        }
        let (Some(form), Some(given)) = (form_at(kind, &error.pointer), body.pointer(&error.pointer)) else { continue };
        if let Some(list) = too_flat(kind, body, &error.pointer) {
            if !flat.contains(&list) {
                flat.push(list);
            }
        } else if let Some(detail) = detail(form, given) {
            error.detail = detail;
        }
    }
    for list in flat {
        let at = errors.iter().position(|error| is_inside(&error.pointer, &list)).unwrap_or(errors.len());
        errors.retain(|error| !is_inside(&error.pointer, &list));
        let form = form_at(kind, &list).unwrap_or(3);
        errors.insert(
            at.min(errors.len()),
            FieldError::new(list, format!("lacks a level of brackets: it is {}", wanted(form))),
        );
    }
}

fn is_inside(pointer: &str, list: &str) -> bool {
    pointer.strip_prefix(list).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

/// Returns the pointer of the outermost list above a value that has fewer levels of arrays than it should.
fn too_flat(kind: Kind, body: &Value, pointer: &str) -> Option<String> {
    let ends = pointer.match_indices('/').map(|(at, _)| at).skip(1).chain([pointer.len()]);
    ends.map(|end| &pointer[..end])
        .find(|list| {
            let (Some(form), Some(given)) = (form_at(kind, list), body.pointer(list)) else { return false };
            form > 1 && given.is_array() && levels(given).is_some_and(|levels| levels > 0 && levels < form)
        })
        .map(str::to_owned)
}

/// Returns the number of levels of arrays around the first number of a value, or `None` if it has no number there.
fn levels(value: &Value) -> Option<usize> {
    match value {
        Value::Array(elements) => Some(1 + levels(elements.first()?)?),
        Value::Number(_) => Some(0),
        _ => None,
    }
}

/// Returns points that the schema accepts at this place: a point, a polyline or a list of polylines. Returns `None` if it
/// wants no points there.
pub(super) fn valid_at(kind: Kind, pointer: &str) -> Option<Value> {
    let polyline = json!([[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
    match form_at(kind, pointer)? {
        1 => Some(json!([0, 0, 0])),
        2 => Some(polyline),
        3 => Some(json!([polyline, polyline])),
        _ => None,
    }
}

/// Returns the number of levels of arrays that the schema wants around a number at this place: 1 for a point, 2 for a
/// polyline, 3 for a list of polylines. Returns `None` if the schema wants no points there.
fn form_at(kind: Kind, pointer: &str) -> Option<usize> {
    let mut schema = &components()[request_component(kind)];
    for part in pointer.split('/').skip(1) {
        schema = inner(resolved(schema), part)?;
    }
    let mut schema = resolved(schema);
    let point = &components()["Point"];
    let mut form = 1;
    while !std::ptr::eq(schema, point) {
        form += 1;
        schema = resolved(schema.get("items")?);
    }
    Some(form)
}

fn inner<'s>(schema: &'s Value, part: &str) -> Option<&'s Value> {
    if let Some(property) = schema.get("properties").and_then(|properties| properties.get(part)) {
        return Some(property);
    }
    if part.bytes().all(|byte| byte.is_ascii_digit()) && schema.get("items").is_some() {
        return schema.get("items");
    }
    schema.get("anyOf")?.as_array()?.iter().find_map(|branch| inner(resolved(branch), part))
}

fn resolved(schema: &Value) -> &Value {
    let name = schema.get("$ref").and_then(Value::as_str).and_then(|reference| reference.rsplit('/').next());
    name.and_then(|name| components().get(name)).unwrap_or(schema)
}

fn detail(form: usize, given: &Value) -> Option<String> {
    let wanted = wanted(form);
    match given {
        Value::Array(coordinates) if form == 1 && coordinates.iter().all(Value::is_number) => match coordinates.len() {
            3 => None,
            2 => Some(format!("has two coordinates: it is {wanted}; in the plane, z is 0")),
            count => Some(format!("has {count} coordinates: it is {wanted}")),
        },
        Value::Array(elements) if elements.is_empty() => Some(format!("is empty: it is {wanted}")),
        Value::Array(_) => None,
        Value::Object(_) => Some(format!("is an object: it is {wanted}")),
        Value::Null => None,
        _ => Some(format!("is not an array: it is {wanted}")),
    }
}

fn wanted(form: usize) -> &'static str {
    match form {
        1 => "a point [x, y, z], such as [0, 0, 1.5]",
        2 => "a list of points [x, y, z], such as [[0, 0, 0], [4, 0, 1], [4, 3, 0]]",
        _ => "a list of polylines, which are lists of points [x, y, z], such as [[[0, 0, 0], [4, 0, 1], [4, 3, 0]]]",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::{Rejection, schema};

    fn errors(kind: Kind, body: &Value) -> Vec<(String, String)> {
        match schema::validate(kind, body) {
            Err(Rejection::Invalid(errors)) => errors.into_iter().map(|error| (error.pointer, error.detail)).collect(),
            other => panic!("expected violations, got {other:?}"),
        }
    }

    #[test]
    fn a_point_in_the_plane_and_an_object_are_told_the_form_of_a_point() {
        let found = errors(
            Kind::MinimalSurface,
            &json!({ "boundaries": [[[0, 0], { "x": 1, "y": 0, "z": 0 }, "1 1 0", [1, 1, 0, 1]]] }),
        );
        let point = "it is a point [x, y, z], such as [0, 0, 1.5]";
        assert_eq!(
            found,
            [
                ("/boundaries/0/0".into(), format!("has two coordinates: {point}; in the plane, z is 0")),
                ("/boundaries/0/1".into(), format!("is an object: {point}")),
                ("/boundaries/0/2".into(), format!("is not an array: {point}")),
                ("/boundaries/0/3".into(), format!("has 4 coordinates: {point}")),
            ]
        );
    }

    #[test]
    fn a_list_that_lacks_a_level_has_one_error() {
        let points = json!([[0, 0, 0], [1, 0, 0], [1, 1, 0]]);
        for (kind, body, pointer) in [
            (Kind::MinimalSurface, json!({ "boundaries": points }), "/boundaries"),
            (Kind::RuledSurface, json!({ "directrices": points }), "/directrices"),
            (Kind::MinimalSurface, json!({ "boundaries": [0, 0, 0, 1, 0, 0] }), "/boundaries"),
            (
                Kind::MinimalSurface,
                json!({ "boundaries": [points], "constraints": { "points": [1, 2, 3] } }),
                "/constraints/points",
            ),
            (
                Kind::UniformMesh,
                json!({ "domain": { "polygon": [0, 0, 0, 1, 0, 0] }, "edge_length": 1 }),
                "/domain/polygon",
            ),
            (Kind::UniformMesh, json!({ "domain": { "boundaries": points }, "edge_length": 1 }), "/domain/boundaries"),
        ] {
            let found = errors(kind, &body);
            assert_eq!((found.len(), found[0].0.as_str()), (1, pointer), "{found:?}");
            assert!(found[0].1.starts_with("lacks a level of brackets: it is a list of "), "{found:?}");
        }
    }

    #[test]
    fn points_in_place_of_a_domain_are_told_the_form_of_a_domain() {
        for domain in [json!([[0, 0, 0], [1, 0, 0], [1, 1, 0]]), json!([])] {
            let found = errors(Kind::UniformMesh, &json!({ "domain": domain, "edge_length": 1 }));
            assert_eq!(found.len(), 1, "{found:?}");
            assert!(found[0].0 == "/domain" && found[0].1.contains(r#"such as {"polygon": [[0, 0, 0]"#), "{found:?}");
        }
    }

    #[test]
    fn other_errors_keep_their_details() {
        let found =
            errors(Kind::MinimalSurface, &json!({ "boundaries": [[[0, 0, "x"], [1, 0, 0], [1, 1, 0]]], "colour": 1 }));
        assert!(found.iter().all(|(_, detail)| !detail.contains("a list of")), "{found:?}");
        assert_eq!(errors(Kind::MinimalSurface, &json!({ "boundaries": [], "resolution": 5 })).len(), 2);
    }
}
