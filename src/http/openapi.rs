//! The OpenAPI 3.1 document: paths from the [`router`], whose handlers bring their entries with them, and schemas from
//! the Rust types ([`wire::schema`](crate::wire::schema)).
//!
//! `api/openapi.json` is this document, committed; `plateau openapi` prints it; a test holds the two together.

use crate::http::access::is_public;
use crate::http::entry::problem;
use crate::http::router;
use crate::wire::schema;
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

/// The document as a server below the base path `base` serves it: the document's paths are relative to the base path.
#[must_use]
pub fn served_at(base: &str) -> String {
    text().replacen(SERVER, &format!(r#""url": "{base}/""#), 1)
}

/// The place of the document that names its server.
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
            { "name": "pages", "description": "For browsers" },
            { "name": "operation", "description": "For operators" },
        ],
        // A server without keys asks for none.
        "security": [{ "key": [] }, {}],
        "paths": paths(),
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

/// Every path with its operations, each with the answers that it may get before its handler is asked: the host is
/// checked, then whether a foreign page wants to change something, then the key.
fn paths() -> Value {
    let response = |name: &str| json!({ "$ref": format!("#/components/responses/{name}") });
    let mut paths = Map::new();
    for resource in router::resources(true) {
        let (path, mut item) = resource.documented();
        for (method, operation) in item.as_object_mut().into_iter().flatten() {
            let responses = &mut operation["responses"];
            responses["421"] = response("Misdirected");
            if method != "get" {
                responses["403"] = response("ForeignPage");
            }
            if is_public(path) {
                operation["security"] = json!([]);
                continue;
            }
            responses["401"] = response("Unauthorized");
            if responses.get("429").is_none() {
                responses["429"] = response("RateLimited");
            }
        }
        paths.insert(path.into(), item);
    }
    Value::Object(paths)
}

/// Status codes whose problem document is documented once for all paths.
fn problems() -> Value {
    let mut responses = Map::new();
    for (name, description) in [
        ("BadRequest", "Malformed JSON, a repeated key, or a query parameter that cannot be used"),
        ("ForeignPage", "A page of another origin sent the request, and `http.cors_origins` does not name that origin"),
        ("NotFound", "No such resource"),
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
