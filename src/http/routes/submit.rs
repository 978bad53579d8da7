//! `POST /v1/{kind}`: take a request, and wait for it if the client prefers.

use crate::app::App;
use crate::http::auth::Caller;
use crate::http::body;
use crate::http::negotiate::prefer_wait_s;
use crate::http::problem::Failure;
use crate::jobs::JobsError;
use crate::jobs::queue::Submitted;
use crate::wire::Kind;
use axum::Json;
use axum::body::Body;
use axum::extract::State;
use axum::http::{HeaderMap, HeaderName, HeaderValue, Request, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use std::time::Duration;

pub const PREFERENCE_APPLIED: HeaderName = HeaderName::from_static("preference-applied");
const IDEMPOTENCY_KEY: HeaderName = HeaderName::from_static("idempotency-key");

pub async fn ruled_surface(
    State(app): State<App>,
    caller: Caller,
    request: Request<Body>,
) -> Result<Response, Failure> {
    submit(&app, &caller, Kind::RuledSurface, request).await
}

pub async fn minimal_surface(
    State(app): State<App>,
    caller: Caller,
    request: Request<Body>,
) -> Result<Response, Failure> {
    submit(&app, &caller, Kind::MinimalSurface, request).await
}

pub async fn uniform_mesh(State(app): State<App>, caller: Caller, request: Request<Body>) -> Result<Response, Failure> {
    submit(&app, &caller, Kind::UniformMesh, request).await
}

async fn submit(app: &App, caller: &Caller, kind: Kind, request: Request<Body>) -> Result<Response, Failure> {
    let wait_s = granted_wait_s(app, request.headers());
    let key = idempotency_key(request.headers())?;
    let room = app.jobs.check_room(caller.owner()).await;
    let nobody_waits = match room {
        // A key may name a job that is there already, however full the queue.
        Err(JobsError::QueueFull { .. }) if key.is_some() => false,
        room => room?,
    };
    let at_once = nobody_waits && wait_s.is_some_and(|wait_s| wait_s > 0);
    let received = body::read_json(app, request).await?;
    let owner = caller.owner().map(str::to_owned);
    let submitted = app.jobs.submit(kind, received.bytes.clone(), owner, key, at_once).await?;
    drop(received);
    let (job, created) = match submitted {
        Submitted::Created(job) => (job, true),
        Submitted::Existing(job) => (job, false),
    };
    let job = match wait_s {
        Some(wait_s) if !job.status.is_final() => {
            app.jobs.wait(&job.id, caller.owner(), Duration::from_secs(wait_s)).await?
        }
        _ => job,
    };
    // With a wait a finished job is an answer; without one a new job is a promise, whatever its state.
    let finished = job.status.is_final() && (wait_s.is_some() || !created);
    let status = if finished { StatusCode::OK } else { StatusCode::ACCEPTED };
    let location = job.links.this.clone();
    Ok(with_wait(answer(status, &location, job), wait_s))
}

/// What was taken, or what became of it, with its address.
pub fn answer(status: StatusCode, location: &str, taken: impl Serialize) -> Response {
    let location = HeaderValue::from_str(location);
    let mut response = (status, Json(taken)).into_response();
    if let Ok(location) = location {
        response.headers_mut().insert(header::LOCATION, location);
    }
    if status == StatusCode::ACCEPTED {
        response.headers_mut().insert(header::RETRY_AFTER, HeaderValue::from_static("1"));
    }
    response
}

/// The wait that a client prefers, as far as this server grants it.
pub fn granted_wait_s(app: &App, headers: &HeaderMap) -> Option<u64> {
    prefer_wait_s(headers).map(|wait_s| wait_s.min(app.config.http.wait_max_s))
}

/// Says which wait was granted, if one was asked for.
pub fn with_wait(mut response: Response, wait_s: Option<u64>) -> Response {
    if let Some(value) = wait_s.and_then(|wait_s| HeaderValue::from_str(&format!("wait={wait_s}")).ok()) {
        response.headers_mut().insert(PREFERENCE_APPLIED, value);
    }
    response
}

pub fn idempotency_key(headers: &HeaderMap) -> Result<Option<String>, Failure> {
    let Some(value) = headers.get(IDEMPOTENCY_KEY) else { return Ok(None) };
    let key = value
        .to_str()
        .ok()
        .filter(|key| (1..=200).contains(&key.len()) && key.bytes().all(|byte| byte.is_ascii_graphic()));
    key.map(|key| Some(key.to_owned())).ok_or_else(|| {
        Failure::bad_header("Idempotency-Key must be 1 to 200 printable ASCII characters without spaces")
    })
}
