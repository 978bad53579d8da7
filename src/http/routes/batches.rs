//! `/v1/batches`: many requests at once, one status, one file.

use super::jobs::{checked, parameters};
use super::mesh::{answer as file_answer, choose_named, describe};
use super::submit::{answer, granted_wait_s, idempotency_key, with_wait};
use crate::app::App;
use crate::export::MeshFormat;
use crate::http::auth::Caller;
use crate::http::body;
use crate::http::negotiate::none_match_hits;
use crate::http::problem::Failure;
use crate::jobs::batch::Submitted;
use crate::wire::batch::Batch;
use axum::Json;
use axum::body::Body;
use axum::extract::{Path, RawQuery, State};
use axum::http::{HeaderMap, HeaderValue, Request, StatusCode, header};
use axum::response::{IntoResponse, Response};
use futures_util::TryStreamExt;
use std::time::Duration;

/// What a batch's meshes come as: `(name, media type)`.
pub const FORMATS: [(&str, &str); 2] = [("zip", "application/zip"), ("glb", "model/gltf-binary")];

pub async fn submit(State(app): State<App>, caller: Caller, request: Request<Body>) -> Result<Response, Failure> {
    let wait_s = granted_wait_s(&app, request.headers());
    let key = idempotency_key(request.headers())?;
    // A key may name a batch that is there already, however full the queue.
    if key.is_none() {
        app.jobs.check_room(caller.owner()).await?;
    }
    let received = body::read_json(&app, request).await?;
    let owner = caller.owner().map(str::to_owned);
    let submitted = app.jobs.submit_batch(received.bytes.clone(), owner, key).await?;
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

pub async fn get(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = checked_batch(&id)?;
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

pub async fn cancel(State(app): State<App>, caller: Caller, Path(id): Path<String>) -> Result<Json<Batch>, Failure> {
    Ok(Json(app.jobs.cancel_batch(checked_batch(&id)?, caller.owner()).await?))
}

pub async fn delete(State(app): State<App>, caller: Caller, Path(id): Path<String>) -> Result<StatusCode, Failure> {
    app.jobs.delete_batch(checked_batch(&id)?, caller.owner()).await?;
    Ok(StatusCode::NO_CONTENT)
}

pub async fn meshes(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    RawQuery(query): RawQuery,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = checked_batch(&id)?;
    let [format, mesh_format] = parameters(query.as_deref(), ["format", "mesh_format"])?;
    let (name, media_type) = FORMATS[choose_named(format, &headers, &FORMATS.map(|f| f.0), &FORMATS.map(|f| f.1))?];
    let mesh_format = match mesh_format {
        None => MeshFormat::Glb,
        Some(name) => MeshFormat::from_name(&name).ok_or_else(|| {
            let names = MeshFormat::ALL.map(MeshFormat::name).join(", ");
            Failure::bad_query(format!("mesh_format must be one of: {names}"))
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
        // An archive that cannot be completed ends the connection: the client sees that it is not whole.
        let archive = meshes.archive(mesh_format)?.map_err(|error| std::io::Error::other(format!("{error:?}")));
        Response::new(Body::from_stream(archive))
    };
    describe(&mut response, &tag, media_type, &filename);
    Ok(response)
}

fn checked_batch(id: &str) -> Result<&str, Failure> {
    checked(id).map_err(|_| Failure::not_found("no such batch"))
}
