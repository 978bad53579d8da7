//! The OpenAPI 3.1 document: paths from here, schemas from the Rust types ([`wire::schema`](crate::wire::schema)).
//!
//! `api/openapi.json` is this document, committed; `plateau openapi` prints it; a test holds the two together.

use crate::http::auth::is_public;
use crate::http::routes::batches::FORMATS;
use crate::wire::objectives::examples;
use crate::wire::{Kind, schema};
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

/// The document, pretty-printed, with a final newline: the bytes of `api/openapi.json`.
#[must_use]
pub fn text() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| {
        let mut text = serde_json::to_string_pretty(&document()).expect("a JSON value can be written");
        text.push('\n');
        text
    });
    &TEXT
}

/// The document as a server below `base` serves it: paths are relative to that.
#[must_use]
pub fn served_at(base: &str) -> String {
    text().replacen(SERVER, &format!(r#""url": "{base}/""#), 1)
}

/// Where the document says which server it is of.
const SERVER: &str = r#""url": "/""#;

fn document() -> Value {
    json!({
        "openapi": "3.1.0",
        "info": {
            "title": "Plateau",
            "version": env!("CARGO_PKG_VERSION"),
            "summary": "Form finding: minimal surfaces, optimal ruled strips and uniform meshes, as glTF meshes with statistics.",
            "description": "Post boundary polylines or directrices, get a job; follow it, then fetch its mesh. Lengths are in the \
                request's unit, angles in degrees. Every error is a problem document (RFC 9457). Results are deterministic.",
            "license": { "name": "MIT OR Apache-2.0", "identifier": "MIT OR Apache-2.0" },
        },
        "servers": [{ "url": "/" }],
        "tags": [
            { "name": "solve", "description": "Requests that become jobs" },
            { "name": "jobs", "description": "Jobs and their meshes" },
            { "name": "batches", "description": "Many requests at once" },
            { "name": "catalogue", "description": "What this server offers" },
            { "name": "operation", "description": "For those who run it" },
        ],
        // A server without keys asks for none.
        "security": [{ "key": [] }, {}],
        "paths": with_access(paths()),
        "components": {
            "securitySchemes": {
                "key": { "type": "http", "scheme": "bearer", "description": "A key of this server, as `plateau key new` makes them." },
            },
            "schemas": schema::components(),
            "responses": problems(),
            "headers": {
                "RequestId": { "description": "Names this request in the server's logs.", "schema": { "type": "string" } },
                "WwwAuthenticate": { "description": "Bearer", "schema": { "type": "string" } },
                "RetryAfter": { "description": "Seconds to wait.", "schema": { "type": "integer", "minimum": 0 } },
            },
        },
    })
}

/// Status codes whose problem document is documented once for all paths.
fn problems() -> Value {
    let mut responses = Map::new();
    for (name, description) in [
        ("BadRequest", "Malformed JSON, a repeated key, or a query parameter that cannot be used"),
        ("NotFound", "No such job or path"),
        ("NotAcceptable", "None of the accepted media types is offered"),
        ("RequestTimeout", "The body did not arrive in time"),
        ("NoMesh", "The job has not ended, or ended without a mesh"),
        ("Gone", "The job has expired"),
        ("TooLarge", "More bytes, points, triangles or cells than this server takes"),
        ("UnsupportedMediaType", "The body is not plain application/json"),
        ("Invalid", "The request is well-formed JSON but cannot be worked on; `errors` names each offending value"),
        ("Misdirected", "The request is for a host that this server does not answer to"),
        ("Failed", "A defect of the server"),
    ] {
        responses.insert(name.into(), problem(description, &[]));
    }
    let retry = ("Retry-After", "RetryAfter");
    responses
        .insert("QueueFull".into(), problem("The queue is full, or this key has made too many requests", &[retry]));
    responses.insert("RateLimited".into(), problem("This key has made too many requests", &[retry]));
    responses
        .insert("Unauthorized".into(), problem("No key of this server", &[("WWW-Authenticate", "WwwAuthenticate")]));
    responses.insert("Unavailable".into(), problem("The server cannot take this now", &[retry]));
    Value::Object(responses)
}

fn problem(description: &str, headers: &[(&str, &str)]) -> Value {
    let mut response = json!({
        "description": description,
        "content": { "application/problem+json": { "schema": reference("Problem") } },
    });
    for (name, component) in headers {
        response["headers"][name] = json!({ "$ref": format!("#/components/headers/{component}") });
    }
    response
}

fn reference(component: &str) -> Value {
    json!({ "$ref": format!("#/components/schemas/{component}") })
}

/// Adds the named problem responses to a set of responses.
fn with_problems(mut responses: Value, names: &[(&str, &str)]) -> Value {
    for (status, name) in names {
        responses[status] = json!({ "$ref": format!("#/components/responses/{name}") });
    }
    responses["500"] = json!({ "$ref": "#/components/responses/Failed" });
    responses
}

/// Adds what stands before every route: its host is checked, then its key, unless it is public.
fn with_access(mut paths: Value) -> Value {
    let response = |name: &str| json!({ "$ref": format!("#/components/responses/{name}") });
    for (path, operations) in paths.as_object_mut().into_iter().flatten() {
        let operations = operations.as_object_mut().into_iter().flatten();
        for (_, operation) in operations.filter(|(name, _)| *name != "parameters") {
            operation["responses"]["421"] = response("Misdirected");
            if is_public(path) {
                operation["security"] = json!([]);
                continue;
            }
            operation["responses"]["401"] = response("Unauthorized");
            if operation["responses"].get("429").is_none() {
                operation["responses"]["429"] = response("RateLimited");
            }
        }
    }
    paths
}

fn json_response(description: &str, component: &str) -> Value {
    json!({ "description": description, "content": { "application/json": { "schema": reference(component) } } })
}

fn paths() -> Value {
    let mut paths = Map::new();
    for kind in Kind::ALL {
        paths.insert(kind.path().into(), json!({ "post": submit(kind) }));
    }
    paths.insert("/v1/jobs".into(), json!({ "get": list() }));
    paths.insert(
        "/v1/jobs/{id}".into(),
        json!({ "parameters": [id_parameter()], "get": get_job(), "delete": delete_job() }),
    );
    paths.insert("/v1/jobs/{id}/cancel".into(), json!({ "parameters": [id_parameter()], "post": cancel() }));
    paths.insert("/v1/jobs/{id}/mesh".into(), json!({ "parameters": [id_parameter()], "get": mesh() }));
    paths.insert("/v1/jobs/{id}/pattern".into(), json!({ "parameters": [id_parameter()], "get": pattern() }));
    paths.insert("/v1/jobs/{id}/events".into(), json!({ "parameters": [id_parameter()], "get": events() }));
    batches(&mut paths);
    for (path, id, summary, component) in [
        ("/v1/objectives", "listObjectives", "What can be asked for", "ObjectiveList"),
        ("/v1/limits", "getLimits", "What one request may cost here", "Limits"),
        ("/v1/examples", "listExamples", "Ready requests", "ExampleList"),
    ] {
        let responses = with_problems(json!({ "200": json_response(summary, component) }), &[]);
        let get = json!({ "operationId": id, "tags": ["catalogue"], "summary": summary, "responses": responses });
        paths.insert(path.into(), json!({ "get": get }));
    }
    paths.insert("/v1/examples/{name}".into(), example());
    for (path, id, summary, media_type) in [
        ("/openapi.json", "getOpenApi", "This document", "application/json"),
        ("/docs", "getDocs", "A page to read and try the API, working offline", "text/html"),
        ("/metrics", "getMetrics", "Prometheus text", "text/plain"),
        ("/", "getStudio", "The studio: a page to solve and look", "text/html"),
    ] {
        let schema =
            if media_type == "application/json" { json!({ "type": "object" }) } else { json!({ "type": "string" }) };
        let response = json!({ "description": summary, "content": { media_type: { "schema": schema } } });
        let tag = if path == "/metrics" { "operation" } else { "catalogue" };
        let responses = with_problems(json!({ "200": response }), &[]);
        let get = json!({ "operationId": id, "tags": [tag], "summary": summary, "responses": responses });
        paths.insert(path.into(), json!({ "get": get }));
    }
    for (path, id, summary) in [
        ("/health/live", "getLive", "The process answers"),
        ("/health/ready", "getReady", "The store answers and jobs are taken"),
    ] {
        let schema =
            json!({ "type": "object", "required": ["status"], "properties": { "status": { "type": "string" } } });
        let ok = json!({ "description": summary, "content": { "application/json": { "schema": schema } } });
        let responses = with_problems(json!({ "200": ok }), &[("503", "Unavailable")]);
        let get = json!({ "operationId": id, "tags": ["operation"], "summary": summary, "responses": responses });
        paths.insert(path.into(), json!({ "get": get }));
    }
    Value::Object(paths)
}

fn id_parameter() -> Value {
    json!({ "name": "id", "in": "path", "required": true, "description": "The job's id",
        "schema": { "type": "string", "pattern": "^[0-9A-HJKMNP-TV-Z]{26}$" } })
}

fn prefer_parameter() -> Value {
    json!({ "name": "Prefer", "in": "header", "required": false,
        "description": "`wait=N`: wait up to N seconds for the job to end (RFC 7240). An invalid preference is ignored.",
        "schema": { "type": "string" }, "example": "wait=10" })
}

/// Longer requests (each would be hundreds of lines of coordinates) are at `GET /v1/examples/{name}` alone.
const LONGEST_EXAMPLE_BYTES: usize = 1200;

fn submit(kind: Kind) -> Value {
    let component = schema::request_component(kind);
    let (id, summary) = match kind {
        Kind::RuledSurface => ("postRuledSurface", "Directrices and an objective: the globally optimal ruled strip"),
        Kind::MinimalSurface => {
            ("postMinimalSurface", "Boundary polylines and a resolution: the minimal surface that spans them")
        }
        Kind::UniformMesh => (
            "postUniformMesh",
            "A polygon, a patch or a film and a length: a mesh with as many equal edges as possible",
        ),
    };
    let examples: Map<String, Value> = examples()
        .iter()
        .filter(|example| example.kind == kind && example.request.to_string().len() <= LONGEST_EXAMPLE_BYTES)
        .map(|example| (example.name.into(), json!({ "summary": example.title, "value": example.request })))
        .collect();
    let mut post = submission(component, "Job", Value::Object(examples));
    post["operationId"] = id.into();
    post["summary"] = summary.into();
    post["responses"]["202"]["links"] =
        json!({ "job": { "operationId": "getJob", "parameters": { "id": "$response.body#/id" } } });
    post
}

/// A POST of `body` that answers `answer`, which may be waited for.
fn submission(body: &str, answer: &str, examples: Value) -> Value {
    let what = answer.to_lowercase();
    let location = json!({ "description": format!("The {what}."), "schema": { "type": "string" } });
    let wait = json!({ "description": "The wait that was granted.", "schema": { "type": "string" } });
    let finished = json!({
        "description": format!("With `Prefer: wait`: the {what} ended in time (read its `status`); or the same idempotency key was used before with this body."),
        "headers": { "Preference-Applied": wait, "Location": location },
        "content": { "application/json": { "schema": reference(answer) } },
    });
    let accepted = json!({
        "description": format!("The {what} is on disk and will be worked on."),
        "headers": { "Location": location, "Retry-After": { "$ref": "#/components/headers/RetryAfter" }, "Preference-Applied": wait },
        "content": { "application/json": { "schema": reference(answer) } },
    });
    json!({
        "tags": ["solve"],
        "parameters": [
            prefer_parameter(),
            { "name": "Idempotency-Key", "in": "header", "required": false,
              "description": format!("The same key with the same body gives the same {what}; with another body 422. Printable ASCII."),
              "schema": { "type": "string", "minLength": 1, "maxLength": 200, "pattern": "^[!-~]+$" } },
        ],
        "requestBody": { "required": true, "content": { "application/json": { "schema": reference(body), "examples": examples } } },
        "responses": with_problems(json!({ "200": finished, "202": accepted }), &[
            ("400", "BadRequest"), ("408", "RequestTimeout"), ("413", "TooLarge"), ("415", "UnsupportedMediaType"),
            ("422", "Invalid"), ("429", "QueueFull"), ("503", "Unavailable"),
        ]),
    })
}

fn batches(paths: &mut Map<String, Value>) {
    let id = json!({ "name": "id", "in": "path", "required": true, "description": "The batch's id",
        "schema": { "type": "string", "pattern": "^[0-9A-HJKMNP-TV-Z]{26}$" } });
    let example = json!({ "requests": [
        { "kind": "ruled_surface", "directrices": [[[0, 0, 0], [1, 0, 0.2], [2, 0, 0]], [[0, 1, 0], [2, 1, 0.5]]] },
        { "kind": "minimal_surface", "boundaries": [[[0, 0, 0], [1, 0, 0.5], [1, 1, 0], [0, 1, 0.5]]], "resolution": { "triangles": 200 } },
    ] });
    let mut post =
        submission(schema::BATCH, "Batch", json!({ "mixed": { "summary": "A strip and a film", "value": example } }));
    post["operationId"] = "postBatch".into();
    post["summary"] = "Many requests at once: all are taken or none".into();
    post["responses"]["202"]["links"] =
        json!({ "batch": { "operationId": "getBatch", "parameters": { "id": "$response.body#/id" } } });
    paths.insert("/v1/batches".into(), json!({ "post": post }));
    let named = |operation: &str, summary: &str, parameters: Value, responses: Value, problems: &[(&str, &str)]| {
        let always = [("404", "NotFound"), ("410", "Gone"), ("503", "Unavailable")];
        json!({ "operationId": operation, "tags": ["batches"], "summary": summary, "parameters": parameters,
            "responses": with_problems(responses, &[&always, problems].concat()) })
    };
    let one = |description: &str| json!({ "200": json_response(description, "Batch") });
    let get = named(
        "getBatch",
        "The batch: one status, and its jobs",
        json!([prefer_parameter()]),
        one("The batch as it is now, or as it ended within the wait"),
        &[],
    );
    let removed = json!({ "204": { "description": "Removed" } });
    let delete = named("deleteBatch", "Cancels what has not ended, removes jobs and meshes", json!([]), removed, &[]);
    paths.insert("/v1/batches/{id}".into(), json!({ "parameters": [id], "get": get, "delete": delete }));
    let cancel = named("cancelBatch", "Cancels every job that has not ended", json!([]), one("The batch"), &[]);
    paths.insert("/v1/batches/{id}/cancel".into(), json!({ "parameters": [id], "post": cancel }));

    let description =
        "A ZIP of every mesh with `batch.json`, which says what became of each request; or all meshes in one GLB scene";
    let (format, responses) = representation(&FORMATS, "zip", description, &[]);
    let names = crate::export::MeshFormat::ALL.map(crate::export::MeshFormat::name);
    let mesh_format = json!({ "name": "mesh_format", "in": "query", "required": false,
        "description": "What the meshes of a ZIP come as; `glb` unless told. A scene is GLB whatever this says.", "schema": { "type": "string", "enum": names } });
    let problems = [("400", "BadRequest"), ("406", "NotAcceptable"), ("409", "NoMesh"), ("422", "Invalid")];
    let meshes = named("getBatchMeshes", "All meshes in one file", json!([format, mesh_format]), responses, &problems);
    paths.insert("/v1/batches/{id}/meshes".into(), json!({ "parameters": [id], "get": meshes }));
}

fn list() -> Value {
    let names = |names: Vec<&str>| json!({ "type": "string", "enum": names });
    let statuses = names(crate::wire::job::Status::ALL.iter().map(|status| status.name()).collect());
    let kinds = names(Kind::ALL.iter().map(|kind| kind.name()).collect());
    let query = |name: &str, description: &str, schema: Value| json!({ "name": name, "in": "query", "required": false, "description": description, "schema": schema });
    json!({
        "operationId": "listJobs", "tags": ["jobs"], "summary": "Jobs, newest first",
        "parameters": [
            query("status", "Only jobs in this state.", statuses),
            query("kind", "Only jobs of this kind.", kinds),
            query("limit", "Jobs a page; 50 unless told.", json!({ "type": "integer", "minimum": 1, "maximum": 200 })),
            query("cursor", "`next_cursor` of the page before.", json!({ "type": "string", "pattern": "^[0-9A-HJKMNP-TV-Z]{26}$" })),
        ],
        "responses": with_problems(json!({ "200": json_response("One page of jobs", "JobList") }), &[("400", "BadRequest"), ("503", "Unavailable")]),
    })
}

fn get_job() -> Value {
    json!({
        "operationId": "getJob", "tags": ["jobs"], "summary": "The job: status, progress, statistics, links",
        "parameters": [prefer_parameter()],
        "responses": with_problems(json!({ "200": json_response("The job as it is now, or as it ended within the wait", "Job") }),
            &[("404", "NotFound"), ("410", "Gone"), ("503", "Unavailable")]),
    })
}

fn delete_job() -> Value {
    json!({
        "operationId": "deleteJob", "tags": ["jobs"], "summary": "Cancels if needed, removes job and mesh",
        "responses": with_problems(json!({ "204": { "description": "Removed" } }),
            &[("404", "NotFound"), ("410", "Gone"), ("503", "Unavailable")]),
    })
}

fn cancel() -> Value {
    json!({
        "operationId": "cancelJob", "tags": ["jobs"], "summary": "Cancels a queued or running job; a finished one is unchanged",
        "responses": with_problems(json!({ "200": json_response("The job", "Job") }),
            &[("404", "NotFound"), ("410", "Gone"), ("503", "Unavailable")]),
    })
}

fn representation(
    formats: &[(&str, &str)],
    default: &str,
    description: &str,
    problems: &[(&str, &str)],
) -> (Value, Value) {
    let binary = json!({ "type": "string", "format": "binary" });
    let content: Map<String, Value> =
        formats.iter().map(|(_, media_type)| ((*media_type).to_owned(), json!({ "schema": binary }))).collect();
    let names: Vec<&str> = formats.iter().map(|(name, _)| *name).collect();
    let headers = json!({ "ETag": { "description": "Hash of these bytes.", "schema": { "type": "string" } },
        "Vary": { "description": "Accept", "schema": { "type": "string" } } });
    let parameter = json!({ "name": "format", "in": "query", "required": false,
        "description": format!("Beats `Accept`; `{default}` unless told."), "schema": { "type": "string", "enum": names } });
    let responses = with_problems(
        json!({
            "200": { "description": description, "headers": headers, "content": content },
            "206": { "description": "The range that was asked for", "headers": headers, "content": content },
            "304": { "description": "`If-None-Match` names the current entity tag" },
            "416": { "description": "The range lies outside of the file",
                "content": { "application/problem+json": { "schema": reference("Problem") } } },
        }),
        problems,
    );
    (parameter, responses)
}

fn mesh() -> Value {
    let formats: Vec<(&str, &str)> =
        crate::export::MeshFormat::ALL.iter().map(|format| (format.name(), format.media_type())).collect();
    let problems = [
        ("400", "BadRequest"),
        ("404", "NotFound"),
        ("406", "NotAcceptable"),
        ("409", "NoMesh"),
        ("410", "Gone"),
        ("422", "Invalid"),
        ("503", "Unavailable"),
    ];
    let (parameter, responses) = representation(&formats, "glb", "The mesh", &problems);
    json!({ "operationId": "getMesh", "tags": ["jobs"], "summary": "The mesh as GLB, glTF, OBJ, PLY or STL",
        "parameters": [parameter], "responses": responses })
}

fn pattern() -> Value {
    let formats: Vec<(&str, &str)> =
        crate::export::PatternFormat::ALL.iter().map(|format| (format.name(), format.media_type())).collect();
    let problems = [
        ("400", "BadRequest"),
        ("404", "NotFound"),
        ("406", "NotAcceptable"),
        ("409", "NoMesh"),
        ("410", "Gone"),
        ("503", "Unavailable"),
    ];
    let (parameter, responses) = representation(&formats, "svg", "The flat pattern, true to scale", &problems);
    json!({ "operationId": "getPattern", "tags": ["jobs"], "summary": "The flat pattern of an open ruled surface as SVG or DXF",
        "parameters": [parameter], "responses": responses })
}

fn events() -> Value {
    let stream = json!({ "description": "Server-sent events: `status`, `progress`, then one final `status`; each carries the job.",
        "content": { "text/event-stream": { "schema": {
            "type": "object", "description": "One event", "required": ["id", "event", "data"],
            "properties": {
                "id": { "type": "string", "description": "`attempt.sequence`" },
                "event": { "type": "string", "enum": ["status", "progress"] },
                "data": { "type": "string", "description": "JSON: the job, or its id, status and progress" },
                "retry": { "type": "integer", "minimum": 0 },
            },
        } } } });
    json!({
        "operationId": "getEvents", "tags": ["jobs"], "summary": "Progress as server-sent events",
        "parameters": [{ "name": "Last-Event-ID", "in": "header", "required": false,
            "description": "The last id that was seen, `attempt.sequence`; after the final one the answer is 204.", "schema": { "type": "string" } }],
        "responses": with_problems(json!({ "200": stream, "204": { "description": "Nothing follows: the final event was seen" } }),
            &[("404", "NotFound"), ("410", "Gone"), ("503", "Unavailable")]),
    })
}

fn example() -> Value {
    let names: Vec<&str> = examples().iter().map(|example| example.name).collect();
    json!({
        "parameters": [{ "name": "name", "in": "path", "required": true, "description": "The example's name", "schema": { "type": "string", "enum": names } }],
        "get": { "operationId": "getExample", "tags": ["catalogue"], "summary": "A ready request",
            "responses": with_problems(json!({ "200": json_response("The request", "Example") }), &[("404", "NotFound")]) },
    })
}
