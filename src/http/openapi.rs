//! The OpenAPI 3.1 document of the API: `/v1`, the health checks and the metrics. Its paths come
//! from the [`router`], which lists each handler of the API with its entry, and its schemas from
//! the Rust types ([`wire::components`](crate::wire::components)).
//!
//! `api/openapi.json` is the committed copy of this document. `plateau openapi` prints it, and a test compares both.

mod words;

use crate::http::access::is_public;
use crate::http::entry::{problem, reference};
use crate::http::resource::{Resource, negotiates};
use crate::http::router;
use crate::wire::components::{MESSAGE, components};
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

/// Returns the document, pretty-printed, with a final newline: the bytes of `api/openapi.json`.
#[must_use]
pub fn text() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| {
        let mut text = serde_json::to_string_pretty(&document()).expect("a JSON value can be written");
        text.push('\n');
        text
    });
    &TEXT
}

/// Returns the document as a server below the base path `base` serves it. The document's paths are relative to the base
/// path.
#[must_use]
pub fn served_at(base: &str) -> String {
    text().replacen(SERVER, &format!(r#""url": "{base}/""#), 1)
}

/// Part of the document that names its server.
const SERVER: &str = r#""url": "/""#;

fn document() -> Value {
    json!({
        "openapi": "3.1.0",
        "info": {
            "title": "Plateau",
            "version": env!("CARGO_PKG_VERSION"),
            "summary": "Form finding: minimal surfaces, optimal ruled strips, uniform meshes, tensile structures and \
             cable nets, as glTF meshes with statistics.",
            "description": "Post curves, a film with its cables, or a net to create a job. Follow the job, then fetch \
             its mesh. Lengths are in the request's unit, and angles are in degrees. A member of a request that is null \
             or an empty list counts as left out, and a member that has no effect with the others is refused. Every \
             error is a problem document (RFC 9457). Results are deterministic.",
            "license": { "name": "MIT OR Apache-2.0", "identifier": "MIT OR Apache-2.0" },
        },
        "servers": [{ "url": "/" }],
        "tags": [
            { "name": "solve", "description": "Requests that create jobs" },
            { "name": "jobs", "description": "Jobs and their meshes" },
            { "name": "batches", "description": "Many requests at once" },
            { "name": "catalogue", "description": "What this server offers" },
            { "name": "operation", "description": "Health checks and metrics for operators" },
        ],
        // The empty alternative stands for a server without keys.
        "security": [{ "key": [] }, {}],
        "paths": paths(),
        "components": {
            "securitySchemes": {
                "key": { "type": "http", "scheme": "bearer",
                    "description": "API key of this server, created with `plateau key new`." },
            },
            "schemas": components(),
            "responses": problems(),
            "headers": {
                "RequestId": { "description": "Identifier of this request in the server's logs.",
                    "schema": { "type": "string" } },
                "WwwAuthenticate": { "description": "Bearer, and the scope that the key does not have.", "schema": { "type": "string" } },
                "RateLimit": { "description": "Requests that the key has left (`r`), and seconds until it has all of a \
                 minute's again (`t`): `\"requests\";r=57;t=3`.", "schema": { "type": "string" } },
                "RateLimitPolicy": { "description": "Requests that the key may make (`q`) in a number of seconds \
                 (`w`): `\"requests\";q=60;w=60`.", "schema": { "type": "string" } },
                "RetryAfter": { "description": "Seconds to wait.",
                    "schema": { "type": "integer", "format": "int64", "minimum": 0 } },
            },
        },
    })
}

/// Returns every path with its operations. Each operation gets the errors of the checks before its handler: first the
/// host, then foreign pages that want to change something, then the key, then unknown query parameters and `Accept`.
fn paths() -> Value {
    let response = |name: &str| json!({ "$ref": format!("#/components/responses/{name}") });
    let mut paths = Map::new();
    for (path, mut item) in router::resources(true).into_iter().filter_map(Resource::documented) {
        for (method, operation) in item.as_object_mut().into_iter().flatten() {
            let negotiates = negotiates(operation);
            words::complete(operation);
            if operation["requestBody"].is_object() {
                let name = operation["operationId"].as_str().unwrap_or_default();
                operation["callbacks"] = json!({ "ended": ended(name) });
            }
            let responses = &mut operation["responses"];
            for (status, name) in [("400", "BadRequest"), ("406", "NotAcceptable")] {
                if (status == "400" || negotiates) && responses.get(status).is_none() {
                    responses[status] = response(name);
                }
            }
            responses["421"] = response("Misdirected");
            if method != "get" {
                responses["403"] = response("Forbidden");
            }
            if is_public(path) {
                operation["security"] = json!([]);
                continue;
            }
            responses["401"] = response("Unauthorized");
            responses["403"] = response("Forbidden");
            if responses.get("429").is_none() {
                responses["429"] = response("RateLimited");
            }
        }
        paths.insert(path.into(), item);
    }
    Value::Object(paths)
}

/// Returns the message that the server sends to the callback URL of a job or a batch that this operation created. It is
/// a callback of the operations and no webhook of the document, because openapi-generator writes invalid Python for a
/// webhook. Each operation contains it, with an identifier of its own, because openapi-python-client cannot read a
/// reference to a callback, and openapi-generator refuses an identifier that occurs twice.
fn ended(operation: &str) -> Value {
    let example = json!({ "type": "job.succeeded", "timestamp": "2026-11-28T12:00:00.000Z", "data": {
        "id": "01KB5Y3F7Q8M2ZC4V9XJ6T1RDA", "kind": "minimal_surface", "status": "succeeded",
        "links": { "self": "/v1/jobs/01KB5Y3F7Q8M2ZC4V9XJ6T1RDA",
            "mesh": "/v1/jobs/01KB5Y3F7Q8M2ZC4V9XJ6T1RDA/mesh" } } });
    json!({ "{$request.body#/callback_url}": { "post": {
        "operationId": format!("{operation}Ended"),
        "summary": "A job or a batch has ended",
        "description": "Sent to the `callback_url` of a request or a batch, signed as Standard Webhooks says, with the \
         headers `webhook-id`, `webhook-timestamp` and `webhook-signature`. A message may arrive twice, with one \
         `webhook-id`. Answer 2xx to receive it once, or 410 to receive none again.",
        "requestBody": { "required": true,
            "content": { "application/json": { "schema": reference(MESSAGE), "example": example } } },
        "responses": { "2XX": { "description": "The message was received." },
            "410": { "description": "No message is wanted at this address." } },
    } } })
}

/// Returns the problem documents that are documented once for all paths.
fn problems() -> Value {
    let mut responses = Map::new();
    for (name, description) in [
        ("BadRequest", "Malformed JSON, a repeated key, or an invalid query parameter"),
        ("NotFound", "The resource does not exist"),
        ("NotAcceptable", "None of the accepted media types is offered"),
        ("RequestTimeout", "The body did not arrive in time"),
        ("NoMesh", "The job has not ended, or ended without a mesh"),
        ("Gone", "The job has expired"),
        ("TooLarge", "More bytes, points, triangles or cells than this server accepts"),
        ("UnsupportedMediaType", "The body is not plain application/json"),
        ("Invalid", "The request is well-formed JSON but invalid; `errors` names each offending value"),
        ("Unsuitable", "A parameter does not suit this result; `errors` names each with its `parameter`"),
        ("Misdirected", "The request is for a host that this server does not answer to"),
        ("Failed", "A defect of the server"),
    ] {
        responses.insert(name.into(), problem(description, &[]));
    }
    let retry = ("Retry-After", "RetryAfter");
    let limited = [retry, ("RateLimit", "RateLimit"), ("RateLimit-Policy", "RateLimitPolicy")];
    responses
        .insert("QueueFull".into(), problem("The queue is full, or this key has made too many requests", &limited));
    responses.insert(
        "RateLimited".into(),
        problem("This key has made too many requests, or this address has presented too many unknown keys", &limited),
    );
    responses.insert(
        "Forbidden".into(),
        problem(
            "The key does not have the scope for this, or a page of another origin wants to change something and \
             `http.cors_origins` does not name that origin",
            &[("WWW-Authenticate", "WwwAuthenticate")],
        ),
    );
    responses.insert(
        "Unauthorized".into(),
        problem("The request has no valid key of this server", &[("WWW-Authenticate", "WwwAuthenticate")]),
    );
    responses.insert("Unavailable".into(), problem("The server cannot accept this request now", &[retry]));
    Value::Object(responses)
}
