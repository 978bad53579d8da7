//! The list of tools with their arguments and results. The tools' schemas are made from these types and from the types
//! of [`wire`](crate::wire).

use crate::wire::envelope::JobFields;
use crate::wire::job::JobSummary;
use crate::wire::objectives::{self, Example, ExampleSummary, Limits};
use plateau_engine::kind::{Kind, Objective};
use plateau_engine::schema;
use rmcp::model::{JsonObject, Tool, ToolAnnotations};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

pub const DESCRIBE: &str = "describe";
pub const SOLVE: &str = "solve";
pub const START: &str = "start";
pub const GET: &str = "get";
pub const CANCEL: &str = "cancel";
pub const LINK: &str = "link";

/// Arguments of a tool.
pub trait Arguments: JsonSchema + DeserializeOwned {}

impl<T: JsonSchema + DeserializeOwned> Arguments for T {}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DescribeArguments {
    /// Kind to describe with its request's members and an example. Without it, all kinds are described in short.
    #[serde(default)]
    pub kind: Option<Kind>,
    /// Name of the example to return, from the lists `examples`. The default is a short one of `kind`.
    #[serde(default)]
    pub example: Option<String>,
    /// Whether to add the objectives with their formulas, the titles of the examples and, with `kind`, the JSON Schemas
    /// of its request and statistics. They take about 10,000 tokens.
    #[serde(default)]
    pub whole: bool,
}

/// Result of `describe`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Description {
    pub kinds: Vec<KindSummary>,
    pub limits: Limits,
    /// Members of the kind's request, each with the first sentence of its description.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub members: Option<BTreeMap<String, String>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objectives: Option<Vec<Objective>>,
    /// Examples that `describe` returns in full by their names.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub examples: Option<Vec<ExampleSummary>>,
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
    /// Names of the objectives that a request may have.
    pub objectives: Vec<&'static str>,
    /// Names of the examples that `describe` returns.
    pub examples: Vec<&'static str>,
}

impl From<Kind> for KindSummary {
    fn from(kind: Kind) -> Self {
        let objectives = objectives::objectives().objectives.into_iter().filter(|objective| objective.kind == kind);
        let examples = objectives::examples().iter().filter(|example| example.kind == kind);
        Self {
            kind,
            summary: kind.summary(),
            objectives: objectives.map(|objective| objective.name).collect(),
            examples: examples.map(|example| example.name).collect(),
        }
    }
}

/// Returns the members of a kind's request, each with the first sentence of its description.
#[must_use]
pub fn members(kind: Kind) -> BTreeMap<String, String> {
    let schema = request(kind);
    let required: Vec<&str> = schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let described = |member: &Value| {
        let own = member["description"].as_str();
        let of_type = || schema.pointer(member["$ref"].as_str()?.strip_prefix('#')?)?["description"].as_str();
        let text = own.or_else(of_type).unwrap_or_default().replace('\n', " ");
        text.find(". ").map_or(text.clone(), |end| text[..=end].to_owned())
    };
    let line = |(name, member): (&String, &Value)| {
        let mark = if required.contains(&name.as_str()) { "Required. " } else { "" };
        (name.clone(), format!("{mark}{}", described(member)))
    };
    schema["properties"].as_object().into_iter().flatten().map(line).collect()
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
pub struct CancelArguments {
    /// Identifier of the job.
    pub id: String,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinkArguments {
    /// Identifier of the job.
    pub id: String,
    #[serde(default)]
    pub file: File,
    /// Format of the file: glb (the default), gltf, obj, ply, stl or json for a mesh; svg (the default), dxf, pdf or
    /// json for a pattern; csv (the default) or dxf for a schedule; json for a certificate.
    #[serde(default)]
    pub format: Option<String>,
    /// Further parameters of a pattern or a schedule as they stand in an address, such as `profile=cut&kerf=0.2` or
    /// `part=nodes`. A table needs its `part`: members, nodes, bends, cables, cable_edges, reactions or edge_reactions.
    /// GET /openapi.json describes the others at getPattern and getSchedule.
    #[serde(default)]
    pub query: Option<String>,
}

/// A file of a succeeded job. Ruled surfaces have a flat pattern, minimal surfaces with `certify` a certificate, and
/// every kind has those parts of a schedule that it has members, bends, cables or supports for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum File {
    #[default]
    Mesh,
    Pattern,
    Schedule,
    Certificate,
}

/// Result of `link`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Link {
    /// Address of the file on this server, while the server keeps the job.
    pub url: String,
    pub format: String,
    pub media_type: &'static str,
    /// Whether a request to the address needs the header `Authorization: Bearer` with an API key of this server.
    pub needs_key: bool,
}

/// Schema of a request of any kind. The other fields are checked against the schema of the kind.
fn request_outline(_: &mut SchemaGenerator) -> Schema {
    json_schema!({
        "type": "object",
        "description": "The request. `describe` with its kind returns its members and an example.",
        "required": ["kind"],
        "properties": { "kind": { "type": "string", "enum": Kind::ALL } },
    })
}

fn example_outline(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "object", "required": ["name", "kind", "title", "request"] })
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
        "description":
            "Null until the job has succeeded. `describe` with the job's kind and `whole` returns the schema.",
    });
    job
}

/// Returns the tools.
#[must_use]
pub fn tools() -> &'static [Tool] {
    static TOOLS: LazyLock<[Tool; 6]> = LazyLock::new(|| {
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
                "Lists the kinds of requests with the names of their objectives and examples, and this server's \
                 limits. With a kind it also returns the members of the kind's request and a short example. With whole \
                 it returns formulas and JSON Schemas too.",
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
                CANCEL,
                "Cancel a job",
                "Cancels a job that has not ended, and returns its state. A job that has ended stays as it is.",
                schema::standalone::<CancelArguments>(),
                schema::standalone::<JobSummary>(),
            )
            .with_annotations(
                ToolAnnotations::new().read_only(false).destructive(true).idempotent(true).open_world(false),
            ),
            tool(
                LINK,
                "Link to a file",
                "Returns the address of a file of a succeeded job: its mesh, flat pattern, schedule of parts or \
                 certificate. GLB and glTF are in metres with Y up; OBJ, PLY and STL keep the request's unit and axes.",
                schema::standalone::<LinkArguments>(),
                schema::standalone::<Link>(),
            )
            .with_annotations(reads()),
        ]
    });
    &*TOOLS
}
