//! Component schemas of the API document: those of `plateau_engine`, with the fields that concern the job added to each
//! request, and those of the answers.

use super::{batch, callback, envelope, glossary, job, objectives, problems};
use plateau_engine::components::{
    by_kind, only_kind, reference, request_component, rewritten, statistics_component, with_kind_component,
};
use plateau_engine::kind::Kind;
use schemars::generate::{SchemaGenerator, SchemaSettings};
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

/// Returns the component schemas of the API document by name.
#[must_use]
pub fn components() -> &'static Map<String, Value> {
    static COMPONENTS: LazyLock<Map<String, Value>> = LazyLock::new(|| {
        let mut components = plateau_engine::components::components().clone();
        add_envelope(&mut components);
        // Answers contain a field even if it is null, so the schemas list such fields as required.
        components.extend(rewritten(SchemaSettings::draft2020_12().for_serialize(), answers));
        components.insert(batch::BATCH.into(), batch::request_schema());
        components.insert(MESSAGE.into(), message_schema());
        jobs_of_each_kind(&mut components);
        glossary::describe(&mut components);
        components
    });
    &COMPONENTS
}

/// Component name of the message to a callback URL.
pub const MESSAGE: &str = "CallbackMessage";

/// Returns the schema of the message to the callback URL of a job or a batch.
fn message_schema() -> Value {
    json!({
        "type": "object",
        "description": "Message to a callback URL, with the fields of Standard Webhooks.",
        "required": ["type", "timestamp", "data"],
        "properties": {
            "type": { "type": "string", "description": "`job.` or `batch.` with the final status, such as \
             `job.succeeded`." },
            "timestamp": { "type": ["string", "null"], "description": "Time of the end (RFC 3339, UTC)." },
            "data": {
                "type": "object",
                "description": "The job or the batch, without its statistics.",
                "required": ["id", "status", "links"],
                "properties": {
                    "id": { "type": "string", "description": "Identifier of the job or the batch." },
                    "kind": { "type": "string", "enum": Kind::ALL.iter().map(|kind| kind.name()).collect::<Vec<_>>(),
                        "description": "Kind of the job's request. Absent for a batch." },
                    "status": { "$ref": "#/components/schemas/Status", "description": "Final status." },
                    "counts": { "$ref": "#/components/schemas/BatchCounts",
                        "description": "Number of the batch's jobs in each state. Absent for a job." },
                    "links": { "type": "object", "additionalProperties": { "type": "string" },
                        "description": "Addresses of the job or the batch, as `GET` of it has them." },
                },
            },
        },
    })
}

/// Adds the types of the answers to a generator.
fn answers(generator: &mut SchemaGenerator) {
    generator.subschema_for::<job::Job>();
    generator.subschema_for::<job::JobList>();
    generator.subschema_for::<batch::Batch>();
    generator.subschema_for::<callback::Callbacks>();
    generator.subschema_for::<job::Problem>();
    generator.subschema_for::<plateau_engine::mesh::Mesh>();
    generator.subschema_for::<problems::ProblemList>();
    generator.subschema_for::<objectives::ObjectiveList>();
    generator.subschema_for::<objectives::Limits>();
    generator.subschema_for::<objectives::ExampleList>();
    generator.subschema_for::<objectives::Example>();
}

/// Adds the members of the envelope to each request.
fn add_envelope(components: &mut Map<String, Value>) {
    let mut schemas = envelope::schemas();
    let Some(Value::Object(mut envelope)) = schemas.remove(envelope::COMPONENT) else { return };
    components.extend(schemas);
    let Some(Value::Object(members)) = envelope.remove("properties") else { return };
    for &kind in Kind::ALL {
        for name in [request_component(kind).into_owned(), with_kind_component(kind)] {
            if let Some(properties) = components[&name]["properties"].as_object_mut() {
                properties.extend(members.clone());
            }
        }
    }
}

/// Returns the component name of a kind's job.
#[must_use]
pub fn job_component(kind: Kind) -> String {
    format!("{}Job", kind.pascal_name())
}

/// Replaces the schema of any job by a union of one schema for each kind, so that each kind has its own statistics.
fn jobs_of_each_kind(components: &mut Map<String, Value>) {
    let Some(any) = components.remove("Job") else { return };
    for &kind in Kind::ALL {
        let mut job = any.clone();
        job["properties"]["kind"] = only_kind(kind);
        job["properties"]["statistics"] = json!({
            "description": "Null until the job has succeeded.",
            "oneOf": [reference(&statistics_component(kind)), { "type": "null" }],
        });
        components.insert(job_component(kind), job);
    }
    let description = any["description"].as_str().unwrap_or_default();
    components.insert("Job".into(), by_kind(description, job_component));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requests and answers are made separately. A name that both use must mean the same in both.
    #[test]
    fn every_name_means_one_thing() {
        let requests = plateau_engine::components::components();
        let of_answers = rewritten(SchemaSettings::draft2020_12().for_serialize(), answers);
        for (name, schema) in requests {
            assert!(of_answers.get(name).is_none_or(|other| other == schema), "{name} is two different types");
        }
        // schemars adds a number to the name of a second type with the same name.
        for name in components().keys() {
            assert!(!name.ends_with(|end: char| end.is_ascii_digit()), "{name}: give one of the types another name");
        }
    }
}
