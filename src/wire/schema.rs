//! The JSON Schemas of the Rust types, and validation of bodies against them.

use super::{FieldError, Kind, MAX_ERRORS, Rejection};
use jsonschema::error::ValidationErrorKind;
use jsonschema::{ValidationError, Validator};
use schemars::JsonSchema;
use schemars::generate::{SchemaGenerator, SchemaSettings};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

/// The component schemas of the OpenAPI document, by name.
#[must_use]
pub fn components() -> &'static Map<String, Value> {
    static COMPONENTS: LazyLock<Map<String, Value>> = LazyLock::new(|| {
        let settings = SchemaSettings::draft2020_12().with(|settings| {
            settings.definitions_path = "/components/schemas".into();
            settings.meta_schema = None;
        });
        let mut generator = settings.into_generator();
        requests(&mut generator);
        super::job::schemas(&mut generator);
        let mut components = generator.take_definitions(true);
        components.insert(BATCH.into(), super::batch::request_schema());
        for schema in components.values_mut() {
            tidy(schema);
        }
        components
    });
    &COMPONENTS
}

fn add<T: JsonSchema>(generator: &mut SchemaGenerator) {
    generator.subschema_for::<T>();
}

fn requests(generator: &mut SchemaGenerator) {
    add::<super::ruled_surface::RuledSurfaceRequest>(generator);
    add::<super::minimal_surface::MinimalSurfaceRequest>(generator);
    add::<super::uniform_mesh::UniformMeshRequest>(generator);
}

/// Formats that OpenAPI tools warn about say nothing that type, minimum and maximum do not.
fn tidy(schema: &mut Value) {
    match schema {
        Value::Object(map) => {
            if map.get("format").and_then(Value::as_str).is_some_and(|format| format.starts_with("uint")) {
                map.remove("format");
            }
            map.values_mut().for_each(tidy);
        }
        Value::Array(list) => list.iter_mut().for_each(tidy),
        _ => {}
    }
}

/// The component name of a kind's request.
#[must_use]
pub fn request_component(kind: Kind) -> &'static str {
    match kind {
        Kind::RuledSurface => "RuledSurfaceRequest",
        Kind::MinimalSurface => "MinimalSurfaceRequest",
        Kind::UniformMesh => "UniformMeshRequest",
    }
}

/// The component name of a batch's body.
pub const BATCH: &str = "BatchRequest";

/// Validates a batch's body but for what its requests hold beyond their kind: each is validated against its own schema.
///
/// # Errors
/// As [`validate`].
pub fn validate_outline(value: &Value) -> Result<(), Rejection> {
    static VALIDATOR: LazyLock<Validator> = LazyLock::new(|| {
        let mut schema = components()[BATCH].clone();
        schema["properties"]["requests"]["items"] = json!({ "type": "object", "required": ["kind"],
            "properties": { "kind": { "enum": Kind::ALL.map(Kind::name) } } });
        jsonschema::validator_for(&schema).expect("the outline of a batch is a valid schema")
    });
    let mut errors = Vec::new();
    for error in VALIDATOR.iter_errors(value) {
        collect(&error, &mut errors);
        if errors.len() > MAX_ERRORS {
            break;
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(Rejection::Invalid(errors)) }
}

fn validator(kind: Kind) -> &'static Validator {
    static VALIDATORS: LazyLock<Vec<Validator>> = LazyLock::new(|| {
        Kind::ALL
            .iter()
            .map(|&kind| {
                let schema = json!({
                    "$ref": format!("#/components/schemas/{}", request_component(kind)),
                    "components": { "schemas": components() },
                });
                jsonschema::validator_for(&schema).expect("the schema of a request type is a valid schema")
            })
            .collect()
    });
    &VALIDATORS[kind as usize]
}

/// Values of a body whose errors are gathered all at once: the validator makes every error before it hands out the
/// first, half a kilobyte each.
const VALUES_AT_ONCE: usize = 20_000;

/// Validates a body against the published schema of its kind.
///
/// # Errors
/// Every violation with its pointer, cut off one past [`MAX_ERRORS`]. Of a body with very many values only the first part that
/// has a violation is reported.
pub fn validate(kind: Kind, value: &Value) -> Result<(), Rejection> {
    let validator = validator(kind);
    if validator.is_valid(value) {
        return Ok(());
    }
    let part = if count(value) > VALUES_AT_ONCE { Some(first_wrong_part(validator, value)) } else { None };
    let mut errors = Vec::new();
    for error in validator.iter_errors(part.as_ref().unwrap_or(value)) {
        collect(&error, &mut errors);
        if errors.len() > MAX_ERRORS {
            break;
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(Rejection::Invalid(errors)) }
}

fn count(value: &Value) -> usize {
    1 + match value {
        Value::Array(elements) => elements.iter().map(count).sum(),
        Value::Object(fields) => fields.values().map(count).sum(),
        _ => 0,
    }
}

fn longest(value: &Value) -> usize {
    match value {
        Value::Array(elements) => elements.iter().map(longest).max().unwrap_or(0).max(elements.len()),
        Value::Object(fields) => fields.values().map(longest).max().unwrap_or(0),
        _ => 0,
    }
}

/// `value` with the first `length` elements of each of its arrays. Pointers into it are pointers into the whole.
fn prefix(value: &Value, length: usize) -> Value {
    match value {
        Value::Array(elements) => elements.iter().take(length).map(|element| prefix(element, length)).collect(),
        Value::Object(fields) => {
            Value::Object(fields.iter().map(|(name, field)| (name.clone(), prefix(field, length))).collect())
        }
        scalar => scalar.clone(),
    }
}

/// The prefix of an invalid value up to about its first violation: short enough that what it adds to a valid prefix is
/// at most about [`VALUES_AT_ONCE`] values. No schema asks for an array of more than 32 elements.
fn first_wrong_part(validator: &Validator, value: &Value) -> Value {
    let longest = longest(value);
    let (mut valid, mut wrong) = (0, 32.min(longest));
    while wrong < longest && validator.is_valid(&prefix(value, wrong)) {
        valid = wrong;
        wrong = (2 * wrong).min(longest);
    }
    let mut part = prefix(value, wrong);
    let mut values = count(&part);
    let mut values_of_valid = count(&prefix(value, valid));
    while wrong - valid > 1 && values - values_of_valid > VALUES_AT_ONCE {
        let middle = valid + (wrong - valid) / 2;
        let shorter = prefix(value, middle);
        if validator.is_valid(&shorter) {
            (valid, values_of_valid) = (middle, count(&shorter));
        } else {
            (wrong, values, part) = (middle, count(&shorter), shorter);
        }
    }
    part
}

/// Adds an error's leaves. Of a union's branches the one that came closest speaks: its first error lies deepest, so the
/// value was of that branch's type.
fn collect(error: &ValidationError<'_>, errors: &mut Vec<FieldError>) {
    if errors.len() > MAX_ERRORS {
        return;
    }
    match error.kind() {
        ValidationErrorKind::AnyOf { context } | ValidationErrorKind::OneOfNotValid { context } => {
            if let Some(names) = allowed_names(context) {
                let detail = format!("it is not one of {}", names.join(", "));
                errors.push(FieldError::new(error.instance_path().as_str(), detail));
                return;
            }
            let depth = |branch: &Vec<ValidationError<'_>>| {
                branch
                    .iter()
                    .map(|error| (type_matched(error), error.instance_path().as_str().matches('/').count()))
                    .min()
            };
            let Some(branch) = context.iter().max_by_key(|branch| depth(branch)) else { return };
            // Two branches that both fail on the type alone: naming one of them would mislead.
            let all_types = context.iter().all(|branch| branch.iter().all(|error| !type_matched(error)));
            if all_types {
                let detail = "is of a type that is not allowed here";
                errors.push(FieldError::new(error.instance_path().as_str(), detail));
            } else {
                branch.iter().for_each(|error| collect(error, errors));
            }
        }
        ValidationErrorKind::AdditionalProperties { unexpected } => {
            for name in unexpected {
                let name = name.replace('~', "~0").replace('/', "~1");
                let pointer = format!("{}/{name}", error.instance_path().as_str());
                // A long key is not echoed in full either.
                let pointer = if pointer.len() > 200 { error.instance_path().as_str().to_owned() } else { pointer };
                errors.push(FieldError::new(pointer, "is not a known field"));
                if errors.len() > MAX_ERRORS {
                    return;
                }
            }
        }
        ValidationErrorKind::Required { property } => {
            let name = property.as_str().unwrap_or_default();
            errors.push(FieldError::new(format!("{}/{name}", error.instance_path().as_str()), "is required"));
        }
        _ => {
            let detail = error.masked_with("it").to_string();
            errors.push(FieldError::new(error.instance_path().as_str(), detail));
        }
    }
}

/// The values of a union all of whose branches are named values: an enumeration in which each has its description.
fn allowed_names(branches: &[Vec<ValidationError<'_>>]) -> Option<Vec<String>> {
    let mut names = Vec::new();
    for branch in branches {
        let named = branch.iter().find_map(|error| match error.kind() {
            ValidationErrorKind::Constant { expected_value } => Some(vec![expected_value.to_string()]),
            ValidationErrorKind::Enum { options } => Some(options.as_array()?.iter().map(Value::to_string).collect()),
            _ => None,
        });
        names.extend(named?);
    }
    Some(names)
}

fn type_matched(error: &ValidationError<'_>) -> bool {
    !matches!(error.kind(), ValidationErrorKind::Type { .. })
}

/// Reads a value that passed its schema.
///
/// # Errors
/// What the schema let through and serde does not, with its pointer.
pub fn deserialize<T: DeserializeOwned>(value: &Value) -> Result<T, Rejection> {
    // Keeping track of the path takes as long as reading does, and hardly anything fails here.
    if let Ok(read) = T::deserialize(value) {
        return Ok(read);
    }
    serde_path_to_error::deserialize(value).map_err(|error| {
        let pointer: String = error
            .path()
            .iter()
            .map(|segment| match segment {
                serde_path_to_error::Segment::Seq { index } => format!("/{index}"),
                serde_path_to_error::Segment::Map { key } => format!("/{}", key.replace('~', "~0").replace('/', "~1")),
                _ => String::new(),
            })
            .collect();
        Rejection::Invalid(vec![FieldError::new(pointer, "cannot be read as what the schema asks for")])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pointers(body: &Value) -> Vec<String> {
        match validate(Kind::RuledSurface, body) {
            Err(Rejection::Invalid(errors)) => errors.into_iter().map(|error| error.pointer).collect(),
            other => panic!("expected violations, got {other:?}"),
        }
    }

    #[test]
    fn of_very_many_wrong_values_the_first_are_named() {
        let many = vec![json!(["x", null, {}]); 50_000];
        let found = pointers(&json!({ "directrices": [many, [[0, 0, 0]]] }));
        assert_eq!(found.len(), MAX_ERRORS + 1);
        assert!(found.iter().all(|pointer| pointer.starts_with("/directrices/0/")), "{found:?}");
    }

    #[test]
    fn one_wrong_value_among_very_many_is_found_wherever_it_is() {
        for place in [0, 15, 16, 17, 1_000, 32_767, 32_768, 49_998, 49_999] {
            let mut points = vec![json!([0, 0, 0.5]); 50_000];
            points[place][1] = json!("x");
            let body = json!({ "directrices": [[[0, 0, 0], [1, 1, 1]], points] });
            assert_eq!(pointers(&body), [format!("/directrices/1/{place}/1")]);
        }
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_known_ones() {
        let boundary = json!([[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
        let refused = |field: &str, value: Value| match validate(
            Kind::MinimalSurface,
            &json!({ "boundaries": [boundary], field: value }),
        ) {
            Err(Rejection::Invalid(errors)) => {
                assert_eq!((errors.len(), errors[0].pointer.as_str()), (1, format!("/{field}").as_str()), "{errors:?}");
                errors[0].detail.clone()
            }
            other => panic!("expected a violation, got {other:?}"),
        };
        let meshes = r#"it is not one of "auto", "planar", "disk", "rings", "barycentres""#;
        assert_eq!(refused("initial_mesh", json!("plane")), meshes);
        let solvers = r#"it is not one of "auto", "vertex_relaxation", "pinkall_polthier", "newton""#;
        assert_eq!(refused("solver", json!("newtonian")), solvers);
        assert_eq!(refused("solver", json!(7)), solvers);
        assert!(refused("objective", json!("area")).contains(r#""minimal_area""#));
        assert!(refused("boundary_sampling", json!("fine")).contains(r#""keep""#));
        assert_eq!(refused("initial_mesh", json!(7)), meshes);
    }

    #[test]
    fn a_point_with_very_many_coordinates_is_named() {
        let point: Vec<u32> = (0..100_000).collect();
        assert_eq!(pointers(&json!({ "directrices": [[point], [[0, 0, 0], [1, 0, 0]]] })), ["/directrices/0/0"]);
    }
}
