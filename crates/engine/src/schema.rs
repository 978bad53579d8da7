//! Validation of values against the schemas of the API document, and self-contained schemas of single types.

use crate::components::{REQUEST_WITH_KIND, components, request_component};
use crate::kind::Kind;
use plateau_strict_json::explain::Schemas;
use plateau_strict_json::rejection::{FieldError, Rejection};
use plateau_strict_json::strict;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};
use std::sync::LazyLock;

/// Returns the schema of one type with every schema that it refers to below `$defs`.
#[must_use]
pub fn standalone<T: JsonSchema>() -> Map<String, Value> {
    standing_alone(SchemaGenerator::into_root_schema_for::<T>)
}

/// Returns the schema of a kind's request as [`standalone`] does.
#[must_use]
pub fn request(kind: Kind) -> Map<String, Value> {
    standing_alone(kind.types().request.root)
}

/// Returns the schema of the statistics of a kind as [`standalone`] does.
#[must_use]
pub fn statistics(kind: Kind) -> Map<String, Value> {
    standing_alone(kind.types().statistics.root)
}

fn standing_alone(root: impl FnOnce(SchemaGenerator) -> Schema) -> Map<String, Value> {
    let mut schema = root(SchemaSettings::draft2020_12().into_generator()).to_value();
    remove_unsigned_formats(&mut schema);
    match schema {
        Value::Object(schema) => schema,
        // The schema of a type that accepts every value is `true`.
        _ => Map::new(),
    }
}

/// Removes unsigned-integer formats, because validators warn about them. The type, minimum and maximum already say the
/// same.
fn remove_unsigned_formats(schema: &mut Value) {
    match schema {
        Value::Object(map) => {
            if map.get("format").and_then(Value::as_str).is_some_and(|format| format.starts_with("uint")) {
                map.remove("format");
            }
            map.values_mut().for_each(remove_unsigned_formats);
        }
        Value::Array(list) => list.iter_mut().for_each(remove_unsigned_formats),
        _ => {}
    }
}

/// Reads a small value after validating it against the [standalone] schema of its type.
///
/// # Errors
/// Returns the errors of [`validate`].
pub fn read<T: JsonSchema + DeserializeOwned>(value: &Value) -> Result<T, Rejection> {
    const ROOT: &str = "";
    let mut schema = standalone::<T>();
    let mut schemas = schema.remove("$defs").and_then(|named| named.as_object().cloned()).unwrap_or_default();
    schemas.insert(ROOT.into(), schema.into());
    refuse(Schemas::new(&schemas).errors(ROOT, value))?;
    strict::deserialize(value)
}

static SCHEMAS: LazyLock<Schemas> = LazyLock::new(|| Schemas::new(components()));

/// Validates a value against a schema of the API document.
fn validate_component(component: &str, value: &Value) -> Result<(), Rejection> {
    refuse(SCHEMAS.errors(component, value))
}

/// Returns a request without the members that count as left out (see [`Schemas::without_empty`]).
pub(crate) fn without_empty(kind: Kind, request: &Value) -> Value {
    SCHEMAS.without_empty(&request_component(kind), request, kind.types().empty_lists)
}

fn refuse(errors: Vec<FieldError>) -> Result<(), Rejection> {
    if errors.is_empty() { Ok(()) } else { Err(Rejection::Invalid(errors)) }
}

/// Validates a request that names its kind.
///
/// # Errors
/// Returns the errors of [`validate`].
pub fn validate_with_kind(value: &Value) -> Result<(), Rejection> {
    validate_component(REQUEST_WITH_KIND, value)
}

/// Validates a body against the published schema of its kind.
///
/// # Errors
/// Returns every violation with its pointer, at most [`MAX_ERRORS`](plateau_strict_json::rejection::MAX_ERRORS) + 1.
pub fn validate(kind: Kind, value: &Value) -> Result<(), Rejection> {
    validate_component(&request_component(kind), value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinds::{minimal_surface, ruled_surface, tensile_structure, uniform_mesh};
    use plateau_strict_json::rejection::MAX_ERRORS;
    use serde_json::json;

    fn errors(kind: Kind, body: &Value) -> Vec<(String, String)> {
        match validate(kind, body) {
            Err(Rejection::Invalid(errors)) => errors.into_iter().map(|error| (error.pointer, error.detail)).collect(),
            other => panic!("expected violations, got {other:?}"),
        }
    }

    fn pointers(body: &Value) -> Vec<String> {
        errors(ruled_surface::KIND, body).into_iter().map(|(pointer, _)| pointer).collect()
    }

    /// A schema is compiled when a value is first compared with it. This test compiles all of them, so that none fails
    /// first in the service.
    #[test]
    fn every_schema_can_be_explained() {
        for name in components().keys() {
            // No named schema allows null.
            assert!(validate_component(name, &Value::Null).is_err(), "{name}");
        }
    }

    #[test]
    fn the_first_of_very_many_wrong_values_are_named() {
        let many = vec![json!(["x", null, {}]); 50_000];
        let found = pointers(&json!({ "directrices": [many, [[0, 0, 0]]] }));
        assert_eq!(found.len(), MAX_ERRORS + 1);
        assert_eq!(
            found[..4],
            ["/directrices/0/0/0", "/directrices/0/0/1", "/directrices/0/0/2", "/directrices/0/1/0"]
        );
    }

    #[test]
    fn one_wrong_value_among_very_many_is_found_wherever_it_is() {
        for place in [0, 25_000, 49_999] {
            let mut points = vec![json!([0, 0, 0.5]); 50_000];
            points[place][1] = json!("x");
            let body = json!({ "directrices": [[[0, 0, 0], [1, 1, 1]], points] });
            assert_eq!(pointers(&body), [format!("/directrices/1/{place}/1")]);
        }
    }

    #[test]
    fn the_error_for_an_unknown_name_lists_the_known_names() {
        let boundary = json!([[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
        let refused = |field: &str, value: Value| {
            let found = errors(minimal_surface::KIND, &json!({ "boundaries": [boundary], field: value }));
            assert_eq!((found.len(), found[0].0.as_str()), (1, format!("/{field}").as_str()), "{found:?}");
            found[0].1.clone()
        };
        let meshes = "must be one of auto, planar, disk, rings, barycentres";
        assert_eq!(refused("initial_mesh", json!("plane")), meshes);
        let or_given = format!("{meshes}, or an object with at least one of the members glb, triangles, vertices");
        assert_eq!(refused("initial_mesh", json!(7)), or_given);
        let solvers = "must be one of auto, vertex_relaxation, pinkall_polthier, newton";
        assert_eq!(refused("solver", json!("newtonian")), solvers);
        assert_eq!(refused("solver", json!(7)), solvers);
        assert_eq!(refused("units", json!("furlong")), "must be one of mm, cm, m, in, ft");
        assert!(refused("objective", json!("area")).contains("minimal_area"));
        assert!(refused("boundary_sampling", json!("fine")).contains("keep"));
    }

    #[test]
    fn the_error_for_a_point_with_very_many_coordinates_has_its_pointer() {
        let point: Vec<u32> = (0..100_000).collect();
        assert_eq!(pointers(&json!({ "directrices": [[point], [[0, 0, 0], [1, 0, 0]]] })), ["/directrices/0/0"]);
    }

    #[test]
    fn a_point_in_the_plane_and_an_object_are_told_the_form_of_a_point() {
        let found = errors(
            minimal_surface::KIND,
            &json!({ "boundaries": [[[0, 0], { "x": 1, "y": 0, "z": 0 }, "1 1 0", [1, 1, 0, 1]]] }),
        );
        let point = "must be a point or vector [x, y, z], such as [0, 0, 1.5]";
        let coordinates = "must have three coordinates [x, y, z]";
        assert_eq!(
            found,
            [
                ("/boundaries/0/0".into(), format!("{coordinates}; in the plane, z is 0")),
                ("/boundaries/0/1".into(), point.into()),
                ("/boundaries/0/2".into(), point.into()),
                ("/boundaries/0/3".into(), coordinates.into()),
            ]
        );
    }

    #[test]
    fn a_list_that_lacks_a_level_has_one_error() {
        let points = json!([[0, 0, 0], [1, 0, 0], [1, 1, 0]]);
        for (kind, body, pointer) in [
            (minimal_surface::KIND, json!({ "boundaries": points }), "/boundaries"),
            (ruled_surface::KIND, json!({ "directrices": points }), "/directrices"),
            (minimal_surface::KIND, json!({ "boundaries": [0, 0, 0, 1, 0, 0] }), "/boundaries"),
            (
                minimal_surface::KIND,
                json!({ "boundaries": [points], "constraints": { "points": [1, 2, 3] } }),
                "/constraints/points",
            ),
            (
                uniform_mesh::KIND,
                json!({ "domain": { "polygon": [0, 0, 0, 1, 0, 0] }, "edge_length": 1 }),
                "/domain/polygon",
            ),
            (uniform_mesh::KIND, json!({ "domain": { "boundaries": points }, "edge_length": 1 }), "/domain/boundaries"),
        ] {
            let found = errors(kind, &body);
            assert_eq!((found.len(), found[0].0.as_str()), (1, pointer), "{found:?}");
            assert!(found[0].1.starts_with("lacks a level of brackets: it must be a list of "), "{found:?}");
        }
    }

    #[test]
    fn a_list_with_a_level_too_many_has_one_error() {
        let points = json!([[0, 0, 0], [1, 0, 0], [1, 1, 0]]);
        for (kind, body, pointer) in [
            (minimal_surface::KIND, json!({ "boundaries": [[points]] }), "/boundaries"),
            (minimal_surface::KIND, json!({ "boundaries": [[points], [points]] }), "/boundaries"),
            (ruled_surface::KIND, json!({ "directrices": [[points, points]] }), "/directrices"),
            (uniform_mesh::KIND, json!({ "domain": { "polygon": [points] }, "edge_length": 1 }), "/domain/polygon"),
            (
                minimal_surface::KIND,
                json!({ "boundaries": [points], "constraints": { "points": [[[0, 0, 0]], [0, 0, 1]] } }),
                "/constraints/points/0",
            ),
        ] {
            let found = errors(kind, &body);
            assert_eq!((found.len(), found[0].0.as_str()), (1, pointer), "{found:?}");
            assert!(found[0].1.starts_with("has a level of brackets too many: it must be a "), "{found:?}");
        }
    }

    #[test]
    fn a_unit_without_its_force_is_told_the_form_of_both() {
        let points = json!([[0, 0, 0], [1, 0, 0], [1, 1, 0]]);
        let body = json!({ "boundaries": [points], "film": { "tension": 1 }, "units": "m" });
        let expected = r#"must be an object, such as {"force":"kN","length":"m"}"#;
        assert_eq!(errors(tensile_structure::KIND, &body), [("/units".into(), expected.into())]);
        let body = json!({ "boundaries": [points], "units": { "length": "m", "force": "kN" } });
        assert_eq!(
            errors(minimal_surface::KIND, &body),
            [("/units".into(), "must be one of mm, cm, m, in, ft".into())]
        );
    }

    #[test]
    fn points_in_place_of_a_domain_are_told_the_members_of_a_domain() {
        for domain in [json!([[0, 0, 0], [1, 0, 0], [1, 1, 0]]), json!([])] {
            let found = errors(uniform_mesh::KIND, &json!({ "domain": domain, "edge_length": 1 }));
            let members = "bezier, boundaries, holes, nurbs, polygon";
            let expected = format!("must be an object with at least one of the members {members}");
            assert_eq!(found, [("/domain".into(), expected)]);
        }
    }

    #[test]
    fn violations_of_different_members_are_reported_together() {
        let found = errors(
            minimal_surface::KIND,
            &json!({ "boundaries": [[[0, 0, "x"], [1, 0, 0]]], "colour": 1, "resolution": 5 }),
        );
        let pointers: Vec<&str> = found.iter().map(|(pointer, _)| pointer.as_str()).collect();
        assert_eq!(pointers, ["/boundaries/0", "/boundaries/0/0/2", "/colour", "/resolution"]);
    }
}
