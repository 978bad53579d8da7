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
    }
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

/// Validates a body against the published schema of its kind.
///
/// # Errors
/// Every violation with its pointer, cut off one past [`MAX_ERRORS`].
pub fn validate(kind: Kind, value: &Value) -> Result<(), Rejection> {
    let mut errors = Vec::new();
    for error in validator(kind).iter_errors(value) {
        collect(&error, &mut errors);
        if errors.len() > MAX_ERRORS {
            break;
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(Rejection::Invalid(errors)) }
}

/// Adds an error's leaves. Of a union's branches the one that came closest speaks: its first error lies deepest, so the
/// value was of that branch's type.
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

fn type_matched(error: &ValidationError<'_>) -> bool {
    !matches!(error.kind(), ValidationErrorKind::Type { .. })
}

/// Reads a value that passed its schema.
///
/// # Errors
/// What the schema let through and serde does not, with its pointer.
pub fn deserialize<T: DeserializeOwned>(value: &Value) -> Result<T, Rejection> {
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
