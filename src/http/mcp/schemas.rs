//! The list of tools with their arguments and results. The tools' schemas are made from these types and from the types
//! of [`wire`](crate::wire).

use crate::wire::envelope::JobFields;
use crate::wire::job::JobSummary;
use crate::wire::objectives::{Example, ExampleSummary, Limits};
use plateau_archive::formats::MeshFormat;
use plateau_engine::kind::{Kind, Objective};
use plateau_engine::schema;
use rmcp::model::{JsonObject, Tool, ToolAnnotations};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::sync::{Arc, LazyLock};

pub const DESCRIBE: &str = "describe";
pub const SOLVE: &str = "solve";
pub const START: &str = "start";
pub const GET: &str = "get";
pub const LINK: &str = "link";

/// Arguments of a tool.
pub trait Arguments: JsonSchema + DeserializeOwned {}

impl<T: JsonSchema + DeserializeOwned> Arguments for T {}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DescribeArguments {
    /// Kind to describe with its request's schema and an example. Without it, all kinds are described in short.
    #[serde(default)]
    pub kind: Option<Kind>,
    /// Name of the example to return, from the list `examples`. The default is the shortest one of `kind`.
    #[serde(default)]
    pub example: Option<String>,
}

/// Result of `describe`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Description {
    pub kinds: Vec<KindSummary>,
    pub objectives: Vec<Objective>,
    /// Examples that `describe` returns in full by their names.
    pub examples: Vec<ExampleSummary>,
    pub limits: Limits,
    /// JSON Schema of the kind's request.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub request_schema: Option<Value>,
    /// JSON Schema of the statistics of the kind's jobs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub statistics_schema: Option<Value>,
    /// Example whose `request` can be solved as it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "example_outline")]
    pub example: Option<&'static Example>,
}

/// A kind of request.
#[derive(Debug, Serialize, JsonSchema)]
pub struct KindSummary {
    pub kind: Kind,
    pub summary: &'static str,
}

impl From<Kind> for KindSummary {
    fn from(kind: Kind) -> Self {
        Self { kind, summary: kind.summary() }
    }
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolveArguments {
    #[schemars(schema_with = "request_outline")]
    pub request: Value,
    /// Longest time to wait for the end of the job, in seconds. A longer wait than `limits.wait_max_s` of `describe` is
    /// cut to it.
    #[serde(default = "default_wait_s")]
    pub wait_s: u64,
}

/// Clients commonly give up a call after 60 s.
fn default_wait_s() -> u64 {
    45
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartArguments {
    #[schemars(schema_with = "request_outline")]
    pub request: Value,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GetArguments {
    /// Identifier of the job.
    pub id: String,
    /// Longest time to wait for the end of the job, in seconds. A longer wait than `limits.wait_max_s` of `describe` is
    /// cut to it.
    #[serde(default)]
    pub wait_s: u64,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinkArguments {
    /// Identifier of the job.
    pub id: String,
    /// Format of the mesh.
    #[serde(default = "default_format")]
    #[schemars(schema_with = "format_name")]
    pub format: String,
}

fn default_format() -> String {
    MeshFormat::Glb.name().into()
}

/// Result of `link`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Link {
    /// Address of the mesh on this server, while the server keeps the job.
    pub url: String,
    pub format: &'static str,
    pub media_type: &'static str,
    /// Whether a request to the address needs the header `Authorization: Bearer` with an API key of this server.
    pub needs_key: bool,
}

/// Schema of a request of any kind. The other fields are checked against the schema of the kind.
fn request_outline(_: &mut SchemaGenerator) -> Schema {
    json_schema!({
        "type": "object",
        "description": "The request. `describe` with its kind returns the schema of all fields.",
        "required": ["kind"],
        "properties": { "kind": { "type": "string", "enum": Kind::ALL } },
    })
}

fn example_outline(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "object", "required": ["name", "kind", "title", "request"] })
}

fn format_name(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "string", "enum": MeshFormat::ALL.map(MeshFormat::name),
        "description": "Format of the mesh." })
}

/// Returns the schema of a kind's request.
#[must_use]
pub fn request(kind: Kind) -> Value {
    let mut request = schema::request(kind);
    // A request may have the fields that concern its job.
    let mut envelope = schema::standalone::<JobFields>();
    for part in ["properties", "$defs"] {
        if let (Some(Value::Object(members)), Some(Value::Object(of_request))) =
            (envelope.remove(part), request.get_mut(part))
        {
            of_request.extend(members);
        }
    }
    Value::Object(request)
}

/// Returns the schema of a job with its statistics. The schema of the statistics is left to `describe`, because it is
/// six times as long as the rest, and clients may give the list of tools to their models.
fn job() -> JsonObject {
    let mut job = schema::standalone::<JobSummary>();
    job.insert("title".into(), "Job".into());
    job.insert("description".into(), "A job: an accepted request and its state.".into());
    job["properties"]["statistics"] = json!({
        "type": ["object", "null"],
        "description": "Null until the job has succeeded. `describe` with the job's kind returns the schema.",
    });
    job
}

/// Returns the tools.
#[must_use]
pub fn tools() -> &'static [Tool] {
    static TOOLS: LazyLock<[Tool; 5]> = LazyLock::new(|| {
        let reads = || ToolAnnotations::new().read_only(true).open_world(false);
        // A repeated request is answered with the stored result.
        let submits = || ToolAnnotations::new().read_only(false).destructive(false).idempotent(true).open_world(false);
        let tool =
            |name: &'static str, title: &str, description: &'static str, input: JsonObject, output: JsonObject| {
                Tool::new(name, description, input).with_title(title).with_raw_output_schema(Arc::new(output))
            };
        [
            tool(
                DESCRIBE,
                "Describe the kinds of requests",
                "Lists the kinds of requests, their objectives with formulas, the examples and this server's limits. \
                 With a kind it also returns the JSON Schema of the kind's request and a short example.",
                schema::standalone::<DescribeArguments>(),
                schema::standalone::<Description>(),
            )
            .with_annotations(reads()),
            tool(
                SOLVE,
                "Solve a request",
                "Submits a request and waits for the end of its job. Returns the job with its statistics and warnings, \
                 and a picture of the mesh if the job has succeeded. If the job is still running after the wait, call \
                 get with its id.",
                schema::standalone::<SolveArguments>(),
                job(),
            )
            .with_annotations(submits()),
            tool(
                START,
                "Start a job",
                "Submits a request and returns its job at once. Use it for requests that take minutes, and call get \
                 with the job's id later.",
                schema::standalone::<StartArguments>(),
                schema::standalone::<JobSummary>(),
            )
            .with_annotations(submits()),
            tool(
                GET,
                "Get a job",
                "Returns a job with its progress, statistics and warnings, and a picture of the mesh if the job has \
                 succeeded.",
                schema::standalone::<GetArguments>(),
                job(),
            )
            .with_annotations(reads()),
            tool(
                LINK,
                "Link to a mesh",
                "Returns the address of a succeeded job's mesh in a format. GLB and glTF are in metres with Y up; OBJ, \
                 PLY and STL keep the request's unit and axes.",
                schema::standalone::<LinkArguments>(),
                schema::standalone::<Link>(),
            )
            .with_annotations(reads()),
        ]
    });
    &*TOOLS
}
