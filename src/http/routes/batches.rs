//! `/v1/batches`: many requests at once, with one status and one file.

use super::mesh::{answer as file_answer, choose, describe};
use super::submit::{answer, granted_wait_s, idempotency_key, submission_entry, with_wait};
use crate::http::access::Caller;
use crate::http::body;
use crate::http::entry::{
    id_parameter, json_response, prefer_parameter, problem, query_parameter, representation, with_problems,
};
use crate::http::negotiate::none_match_hits;
use crate::http::parameters::{checked, parameters};
use crate::http::problem::Failure;
use crate::http::state::App;
use crate::jobs::submission::{Submitted, Submitter};
use crate::wire::batch::{BATCH, Batch};
use crate::wire::callback::Callbacks;
use axum::Json;
use axum::body::Body;
use axum::extract::{Path, RawQuery, State};
use axum::http::{HeaderMap, HeaderValue, Request, StatusCode, header};
use axum::response::{IntoResponse, Response};
use futures_util::TryStreamExt;
use plateau_archive::formats::MeshFormat;
use serde_json::{Value, json};
use std::time::Duration;

/// Formats of a batch's meshes, as `(name, media type)`.
pub const FORMATS: [(&str, &str); 2] = [("zip", "application/zip"), ("glb", "model/gltf-binary")];

pub async fn post(State(app): State<App>, caller: Caller, request: Request<Body>) -> Result<Response, Failure> {
    let wait_s = granted_wait_s(&app, request.headers());
    let key = idempotency_key(request.headers())?;
    // If there is an idempotency key, it may name an existing batch, so a full queue is no reason to refuse.
    if key.is_none() {
        app.jobs.check_room(caller.owner()).await?;
    }
    let received = body::read_json(&app, request).await?;
    let from = Submitter { owner: caller.owner().map(str::to_owned), idempotency_key: key };
    let submitted = app.jobs.submit_batch(received.bytes.clone(), from).await?;
    drop(received);
    let (batch, created) = match submitted {
        Submitted::Created(batch) => (batch, true),
        Submitted::Existing(batch) => (batch, false),
    };
    let batch = match wait_s {
        Some(wait_s) if !batch.status.is_final() => {
            app.jobs.wait_for_batch(&batch.id, caller.owner(), Duration::from_secs(wait_s)).await?
        }
        _ => batch,
    };
    let finished = batch.status.is_final() && (wait_s.is_some() || !created);
    let status = if finished { StatusCode::OK } else { StatusCode::ACCEPTED };
    let location = batch.links.this.clone();
    Ok(with_wait(answer(status, &location, batch), wait_s))
}

pub fn post_entry() -> Value {
    let example = json!({ "requests": [
        { "kind": "ruled_surface", "directrices": [[[0, 0, 0], [1, 0, 0.2], [2, 0, 0]], [[0, 1, 0], [2, 1, 0.5]]] },
        { "kind": "minimal_surface", "boundaries": [[[0, 0, 0], [1, 0, 0.5], [1, 1, 0], [0, 1, 0.5]]],
            "resolution": { "triangles": 200 } },
    ] });
    let examples = json!({ "mixed": { "summary": "A strip and a film", "value": example } });
    let mut post = submission_entry(BATCH, "Batch", "batch", examples);
    post["operationId"] = "postBatch".into();
    post["summary"] = "Submits many requests at once; either all are accepted or none".into();
    post["responses"]["202"]["links"] =
        json!({ "batch": { "operationId": "getBatch", "parameters": { "id": "$response.body#/id" } } });
    post
}

/// Returns the entry of an operation on one batch.
fn one(operation: &str, summary: &str, parameters: &[Value], responses: Value, problems: &[(&str, &str)]) -> Value {
    let parameters = [&[id_parameter("batch")], parameters].concat();
    let always = [("404", "NotFound"), ("410", "Gone"), ("503", "Unavailable")];
    json!({ "operationId": operation, "tags": ["batches"], "summary": summary, "parameters": parameters,
        "responses": with_problems(responses, &[&always, problems].concat()) })
}

pub async fn get(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = &checked_batch(&id)?;
    let wait_s = granted_wait_s(&app, &headers);
    let batch = match wait_s {
        Some(wait_s) => app.jobs.wait_for_batch(id, caller.owner(), Duration::from_secs(wait_s)).await?,
        None => app.jobs.batch(id, caller.owner()).await?,
    };
    let mut response = Json(&batch).into_response();
    if !batch.status.is_final() {
        response.headers_mut().insert(header::RETRY_AFTER, HeaderValue::from_static("1"));
    }
    Ok(with_wait(response, wait_s))
}

pub fn get_entry() -> Value {
    let ok = json!({ "200": json_response("The batch as it is now, or as it ended within the wait", "Batch") });
    one("getBatch", "The batch with its status and its jobs", &[prefer_parameter()], ok, &[])
}

pub async fn cancel(State(app): State<App>, caller: Caller, Path(id): Path<String>) -> Result<Json<Batch>, Failure> {
    Ok(Json(app.jobs.cancel_batch(&checked_batch(&id)?, caller.owner()).await?))
}

pub fn cancel_entry() -> Value {
    let ok = json!({ "200": json_response("The batch", "Batch") });
    one("cancelBatch", "Cancels every job that has not ended", &[], ok, &[])
}

pub async fn callbacks(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
) -> Result<Json<Callbacks>, Failure> {
    Ok(Json(app.jobs.batch_callbacks(&checked_batch(&id)?, caller.owner()).await?))
}

pub fn callbacks_entry() -> Value {
    let ok = json!({ "200": json_response("The callback and its attempts", "Callbacks") });
    one("getBatchCallbacks", "What became of the message to the batch's callback URL", &[], ok, &[])
}

pub async fn send_callback_again(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
) -> Result<(StatusCode, Json<Callbacks>), Failure> {
    let callbacks = app.jobs.send_batch_callback_again(&checked_batch(&id)?, caller.owner()).await?;
    Ok((StatusCode::ACCEPTED, Json(callbacks)))
}

pub fn send_callback_again_entry() -> Value {
    let accepted = json!({ "202": json_response("The callback, which is sent after the last job", "Callbacks") });
    let summary = "Sends the message to the batch's callback URL again";
    let mut entry = one("sendBatchCallbackAgain", summary, &[], accepted, &[]);
    entry["responses"]["409"] = problem("The request named no callback URL", &[]);
    entry
}

pub async fn delete(State(app): State<App>, caller: Caller, Path(id): Path<String>) -> Result<StatusCode, Failure> {
    app.jobs.delete_batch(&checked_batch(&id)?, caller.owner()).await?;
    Ok(StatusCode::NO_CONTENT)
}

pub fn delete_entry() -> Value {
    let removed = json!({ "204": { "description": "Removed" } });
    one("deleteBatch", "Cancels jobs that have not ended, and removes all jobs and meshes", &[], removed, &[])
}

pub async fn meshes(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    RawQuery(query): RawQuery,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = &checked_batch(&id)?;
    let [format, mesh_format] = parameters(query.as_deref(), ["format", "mesh_format"])?;
    let (chosen, media_type) = choose(format, &headers, &FORMATS)?;
    let (name, _) = FORMATS[chosen];
    let mesh_format = match mesh_format {
        None => MeshFormat::Glb,
        Some(name) => MeshFormat::from_name(&name).ok_or_else(|| {
            let names = MeshFormat::ALL.map(MeshFormat::name).join(", ");
            Failure::bad_query(format!("mesh_format must be one of {names}"))
        })?,
    };
    let meshes = app.jobs.batch_meshes(id, caller.owner()).await?;
    let filename = format!("{id}.{name}");
    if name == "glb" {
        return Ok(file_answer(&headers, &meshes.scene().await?, media_type, &filename));
    }
    let tag = format!("\"{}\"", meshes.tag(mesh_format.name()));
    let mut response = if none_match_hits(&headers, &tag) {
        StatusCode::NOT_MODIFIED.into_response()
    } else {
        // If the archive cannot be completed, the connection is closed early, so that the client sees that the file is
        // incomplete.
        let archive = meshes.archive(mesh_format)?.map_err(|error| std::io::Error::other(format!("{error:?}")));
        Response::new(Body::from_stream(archive))
    };
    describe(&mut response, &tag, media_type, &filename);
    Ok(response)
}

pub fn meshes_entry() -> Value {
    let description = "A ZIP with every mesh and `batch.json`, which describes the job of each request; or all meshes \
        in one GLB scene";
    let (format, responses) = representation(&FORMATS, "zip", description, &[]);
    let mesh_format = query_parameter(
        "mesh_format",
        "Format of the meshes in a ZIP. The default is `glb`. A scene is always GLB.",
        json!({ "type": "string", "enum": MeshFormat::ALL.map(MeshFormat::name) }),
    );
    let problems = [("400", "BadRequest"), ("406", "NotAcceptable"), ("409", "NoMesh"), ("422", "Invalid")];
    one("getBatchMeshes", "All meshes in one file", &[format, mesh_format], responses, &problems)
}

fn checked_batch(id: &str) -> Result<String, Failure> {
    checked(id).map_err(|_| Failure::not_found("no such batch"))
}
