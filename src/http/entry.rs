//! Building blocks of the handlers' entries in the API document.

use serde_json::{Value, json};

/// Returns a reference to a component schema.
pub fn reference(component: &str) -> Value {
    json!({ "$ref": format!("#/components/schemas/{component}") })
}

/// Returns a response that is a problem document.
pub fn problem(description: &str, headers: &[(&str, &str)]) -> Value {
    let mut response = json!({
        "description": description,
        "headers": { "X-Request-Id": { "$ref": "#/components/headers/RequestId" } },
        "content": { "application/problem+json": { "schema": reference("Problem") } },
    });
    for (name, component) in headers {
        response["headers"][name] = json!({ "$ref": format!("#/components/headers/{component}") });
    }
    response
}

/// Adds the named problem responses to a set of responses, and the 500 that every operation may return.
pub fn with_problems(mut responses: Value, names: &[(&str, &str)]) -> Value {
    for (status, name) in names {
        responses[status] = json!({ "$ref": format!("#/components/responses/{name}") });
    }
    responses["500"] = json!({ "$ref": "#/components/responses/Failed" });
    responses
}

/// Returns the content of a response that is a file of one of these media types.
fn file_content<'m>(media_types: impl IntoIterator<Item = &'m str>) -> Value {
    let file =
        |media_type: &str| (media_type.to_owned(), json!({ "schema": { "type": "string", "format": "binary" } }));
    Value::Object(media_types.into_iter().map(file).collect())
}

pub fn json_response(description: &str, component: &str) -> Value {
    json!({ "description": description, "content": { "application/json": { "schema": reference(component) } } })
}

/// Returns the entry of a GET without parameters that answers 200 with `schema` as `media_type`.
pub fn plain_get(tag: &str, operation: &str, summary: &str, media_type: &str, schema: &Value) -> Value {
    let ok = json!({ "description": summary, "content": { media_type: { "schema": schema } } });
    json!({ "operationId": operation, "tags": [tag], "summary": summary,
        "responses": with_problems(json!({ "200": ok }), &[]) })
}

/// Pattern of a ULID. Lower-case letters are accepted too.
pub const ULID: &str = "^[0-9A-HJKMNP-TV-Za-hjkmnp-tv-z]{26}$";

/// Returns the path parameter `id` of a job or a batch.
pub fn id_parameter(resource: &str) -> Value {
    json!({ "name": "id", "in": "path", "required": true, "description": format!("Identifier of the {resource}."),
        "schema": { "type": "string", "pattern": ULID } })
}

/// Returns a path parameter that is one of `names`.
pub fn name_parameter(parameter: &str, description: &str, names: &[&str]) -> Value {
    json!({ "name": parameter, "in": "path", "required": true, "description": description,
        "schema": { "type": "string", "enum": names } })
}

pub fn query_parameter(name: &str, description: &str, schema: Value) -> Value {
    json!({ "name": name, "in": "query", "required": false, "description": description, "schema": schema })
}

pub fn prefer_parameter() -> Value {
    json!({ "name": "Prefer", "in": "header", "required": false,
        "description": "`wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.",
        "schema": { "type": "string" }, "example": "wait=10" })
}

/// Media type under which every file can be fetched. Client generators take bytes of this type as bytes, and do not
/// know the media types of meshes.
pub const BYTES: &str = "application/octet-stream";

/// Returns the parameter `format` and the responses of a file in several formats, each given as `(name, media type)`.
pub fn representation(
    formats: &[(&str, &str)],
    default: &str,
    description: &str,
    problems: &[(&str, &str)],
) -> (Value, Value) {
    let content = file_content(formats.iter().map(|(_, media_type)| *media_type).chain([BYTES]));
    let names: Vec<&str> = formats.iter().map(|(name, _)| *name).collect();
    let headers = json!({ "ETag": { "description": "Hash of these bytes.", "schema": { "type": "string" } },
        "Vary": { "description": "Accept", "schema": { "type": "string" } } });
    let parameter = query_parameter(
        "format",
        &format!(
            "Takes precedence over `Accept`. The default is `{default}`. With `Accept: {BYTES}` the file has that type."
        ),
        json!({ "type": "string", "enum": names }),
    );
    let responses = with_problems(
        json!({
            "200": { "description": description, "headers": headers, "content": content },
            "206": { "description": "The requested range", "headers": headers, "content": content },
            "304": { "description": "`If-None-Match` names the current entity tag" },
            "416": problem("The range lies outside the file", &[]),
        }),
        problems,
    );
    (parameter, responses)
}
