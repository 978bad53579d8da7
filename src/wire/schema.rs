//! Validation of bodies against the schemas of the API document, and schemas that stand alone.

use super::components::{BATCH, components, for_each_schema, request_component};
use super::{FieldError, Kind, MAX_ERRORS, Rejection, shapes};
use jsonschema::error::ValidationErrorKind;
use jsonschema::{ValidationError, Validator};
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

/// Returns the schema of one type with every schema that it refers to below `$defs`.
#[must_use]
pub fn standalone<T: JsonSchema>() -> Map<String, Value> {
    let generator = SchemaSettings::draft2020_12().into_generator();
    let mut schema = generator.into_root_schema_for::<T>().to_value();
    remove_unsigned_formats(&mut schema);
    match schema {
        Value::Object(schema) => schema,
        // The schema of a type without conditions is `true`.
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
    let schema = Value::Object(standalone::<T>());
    let validator = jsonschema::validator_for(&schema).expect("the schema of a type is a valid schema");
    let mut errors = Vec::new();
    if !validator.is_valid(value) {
        validator.iter_errors(value).for_each(|error| collect(&error, &mut errors));
    }
    if errors.is_empty() { deserialize(value) } else { Err(Rejection::Invalid(errors)) }
}

/// Validates a batch's body and the kind of each request. The other fields of a request are validated later against the
/// request's own schema.
///
/// # Errors
/// Returns the errors of [`validate`].
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

/// Returns the component schemas without the types of enumerations. The values have that type, and a value of another
/// type would otherwise have two errors.
fn without_types_of_enums() -> Map<String, Value> {
    let mut schemas = components().clone();
    for schema in schemas.values_mut() {
        for_each_schema(schema, &mut |schema: &mut Value| {
            if let Some(keywords) = schema.as_object_mut().filter(|keywords| keywords.contains_key("enum")) {
                keywords.remove("type");
            }
        });
    }
    schemas
}

fn validator(kind: Kind) -> &'static Validator {
    static VALIDATORS: LazyLock<Vec<Validator>> = LazyLock::new(|| {
        Kind::ALL
            .iter()
            .map(|&kind| {
                let schema = json!({
                    "$ref": format!("#/components/schemas/{}", request_component(kind)),
                    "components": { "schemas": without_types_of_enums() },
                });
                jsonschema::validator_for(&schema).expect("the schema of a request type is a valid schema")
            })
            .collect()
    });
    &VALIDATORS[kind as usize]
}

/// Number of values up to which a body is validated as a whole. The validator creates all errors, half a kilobyte each,
/// before it returns the first one, so larger bodies are validated in part.
const MAX_VALUES_AT_ONCE: usize = 20_000;

/// Validates a body against the published schema of its kind.
///
/// # Errors
/// Returns every violation with its pointer, at most [`MAX_ERRORS`] + 1. For a body with very many values, only the
/// violations of the first part that has one are returned.
pub fn validate(kind: Kind, value: &Value) -> Result<(), Rejection> {
    let validator = validator(kind);
    if validator.is_valid(value) {
        return Ok(());
    }
    let part = (count(value) > MAX_VALUES_AT_ONCE).then(|| first_invalid_part(validator, value));
    let mut errors = Vec::new();
    for error in validator.iter_errors(part.as_ref().unwrap_or(value)) {
        collect(&error, &mut errors);
        if errors.len() > MAX_ERRORS {
            break;
        }
    }
    if errors.is_empty() {
        return Ok(());
    }
    let omitted = part.is_some() && errors.len() <= MAX_ERRORS && !validator.is_valid(&mended(kind, value, &errors));
    shapes::explain(kind, value, &mut errors);
    Err(if omitted { Rejection::InvalidInPart(errors) } else { Rejection::Invalid(errors) })
}

/// Returns a value in which valid points replace those that contain the errors, without the other elements and fields that
/// contain them.
fn mended(kind: Kind, value: &Value, errors: &[FieldError]) -> Value {
    let mut rest = value.clone();
    // From the last element to the first, so that the indices of the others stay the same.
    for error in errors.iter().rev() {
        // An error at a coordinate is mended with its whole point.
        let up = error.pointer.rsplit_once('/').map_or("", |(parent, _)| parent);
        let valid = [error.pointer.as_str(), up].into_iter().find_map(|at| Some((at, shapes::valid_at(kind, at)?)));
        if let Some((at, points)) = valid {
            rest.pointer_mut(at).into_iter().for_each(|wrong| *wrong = points.clone());
            continue;
        }
        let Some((parent, name)) = error.pointer.rsplit_once('/') else { continue };
        match rest.pointer_mut(parent) {
            Some(Value::Array(elements)) => {
                if let Some(index) = name.parse().ok().filter(|&index: &usize| index < elements.len()) {
                    elements.remove(index);
                }
            }
            Some(Value::Object(fields)) => {
                fields.remove(name);
            }
            _ => {}
        }
    }
    rest
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

/// Returns `value` with the first `length` elements of each of its arrays. Pointers into the prefix are also pointers
/// into `value`.
fn prefix(value: &Value, length: usize) -> Value {
    match value {
        Value::Array(elements) => elements.iter().take(length).map(|element| prefix(element, length)).collect(),
        Value::Object(fields) => {
            Value::Object(fields.iter().map(|(name, field)| (name.clone(), prefix(field, length))).collect())
        }
        scalar => scalar.clone(),
    }
}

/// Returns a prefix of an invalid value that contains about its first violation. It has at most about
/// [`MAX_VALUES_AT_ONCE`] values more than a valid prefix. No schema requires an array of more than 32 elements.
fn first_invalid_part(validator: &Validator, value: &Value) -> Value {
    let longest = longest(value);
    let (mut valid, mut invalid) = (0, 32.min(longest));
    while invalid < longest && validator.is_valid(&prefix(value, invalid)) {
        valid = invalid;
        invalid = (2 * invalid).min(longest);
    }
    let mut part = prefix(value, invalid);
    let mut values = count(&part);
    let mut values_of_valid = count(&prefix(value, valid));
    while invalid - valid > 1 && values - values_of_valid > MAX_VALUES_AT_ONCE {
        let middle = valid + (invalid - valid) / 2;
        let shorter = prefix(value, middle);
        if validator.is_valid(&shorter) {
            (valid, values_of_valid) = (middle, count(&shorter));
        } else {
            (invalid, values, part) = (middle, count(&shorter), shorter);
        }
    }
    part
}

/// Adds the innermost errors of an error. For a union, these are the errors of the branch whose first error lies
/// deepest, because the value matched the type of that branch.
fn collect(error: &ValidationError<'_>, errors: &mut Vec<FieldError>) {
    if errors.len() > MAX_ERRORS {
        return;
    }
    match error.kind() {
        ValidationErrorKind::AnyOf { context } | ValidationErrorKind::OneOfNotValid { context } => {
            let depth = |branch: &Vec<ValidationError<'_>>| {
                branch
                    .iter()
                    .map(|error| (type_matched(error), error.instance_path().as_str().matches('/').count()))
                    .min()
            };
            let Some(branch) = context.iter().max_by_key(|branch| depth(branch)) else { return };
            // If all branches fail on the type alone, naming one of them would mislead.
            let all_types = context.iter().all(|branch| branch.iter().all(|error| !type_matched(error)));
            if all_types {
                let detail = "is of a type that is not allowed here";
                errors.push(FieldError::new(error.instance_path().as_str(), detail));
            } else {
                branch.iter().for_each(|error| collect(error, errors));
            }
        }
        ValidationErrorKind::Enum { options } => {
            let names: Vec<String> = options.as_array().into_iter().flatten().map(Value::to_string).collect();
            let detail = format!("it is not one of {}", names.join(", "));
            errors.push(FieldError::new(error.instance_path().as_str(), detail));
        }
        ValidationErrorKind::AdditionalProperties { unexpected } => {
            for name in unexpected {
                let name = name.replace('~', "~0").replace('/', "~1");
                let pointer = format!("{}/{name}", error.instance_path().as_str());
                // Long keys are not echoed in full.
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

fn type_matched(error: &ValidationError<'_>) -> bool {
    !matches!(error.kind(), ValidationErrorKind::Type { .. })
}

/// Deserializes a value that passed its schema.
///
/// # Errors
/// Returns values that passed the schema but that serde refuses, with their pointers.
pub fn deserialize<T: DeserializeOwned>(value: &Value) -> Result<T, Rejection> {
    // The path is tracked only after a failure, because tracking takes as long as reading, and failures are rare here.
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
        Rejection::Invalid(vec![FieldError::new(pointer, "does not have the form that the schema requires")])
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
    fn the_first_of_very_many_wrong_values_are_named() {
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
    fn the_error_for_an_unknown_name_lists_the_known_names() {
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
    fn the_error_for_a_point_with_very_many_coordinates_has_its_pointer() {
        let point: Vec<u32> = (0..100_000).collect();
        assert_eq!(pointers(&json!({ "directrices": [[point], [[0, 0, 0], [1, 0, 0]]] })), ["/directrices/0/0"]);
    }
}
