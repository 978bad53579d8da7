//! `POST /v1/{kind}`: submits a request, and waits for its job if the client asks for that.

use super::mesh::{bytes_of, describe, mesh_file};
use crate::http::access::Caller;
use crate::http::body;
use crate::http::entry::{prefer_parameter, reference, with_problems};
use crate::http::negotiate::{accepted, prefer_wait_s};
use crate::http::problem::Failure;
use crate::http::resource::Resource;
use crate::http::state::App;
use crate::jobs::JobsError;
use crate::jobs::service::CancelOnDrop;
use crate::jobs::submission::{Submitted, Submitter};
use crate::wire::components::job_component;
use crate::wire::job::Job;
use crate::wire::objectives::examples as ready_requests;
use axum::Json;
use axum::body::Body;
use axum::extract::State;
use axum::http::{HeaderMap, HeaderName, HeaderValue, Request, StatusCode, header};
use axum::response::{IntoResponse, Response};
use plateau_archive::formats::{Choices, MeshFormat};
use plateau_engine::components::request_component;
use plateau_engine::kind::Kind;
use serde::Serialize;
use serde_json::{Map, Value, json};
use std::time::Duration;

pub const PREFERENCE_APPLIED: HeaderName = HeaderName::from_static("preference-applied");
const IDEMPOTENCY_KEY: HeaderName = HeaderName::from_static("idempotency-key");

/// Returns the path that accepts requests of a kind, with its handler and its entry in the API document.
pub fn resource(kind: Kind) -> Resource {
    let handler = move |State(app): State<App>, caller: Caller, request: Request<Body>| async move {
        post(&app, &caller, kind, request).await
    };
    Resource::at(kind.path()).post(handler, entry(kind))
}

async fn post(app: &App, caller: &Caller, kind: Kind, request: Request<Body>) -> Result<Response, Failure> {
    let wait_s = granted_wait_s(app, request.headers());
    let mesh_format = accepted_mesh(request.headers()).filter(|_| wait_s.is_some());
    let key = idempotency_key(request.headers())?;
    match app.jobs.check_room(caller.owner()).await {
        // The idempotency key may name an existing job, so a full queue is no reason to refuse.
        Err(JobsError::QueueFull { .. }) if key.is_some() => {}
        room => room?,
    }
    let waited_for = wait_s.is_some_and(|wait_s| wait_s > 0);
    let received = body::read_json(app, request).await?;
    let from = Submitter { owner: caller.owner().map(str::to_owned), idempotency_key: key };
    let accepted = app.jobs.submit(kind, received.bytes.clone(), from, waited_for).await?;
    drop(received);
    let (job, created) = match accepted.submitted {
        Submitted::Created(job) => (job, true),
        Submitted::Existing(job) => (job, false),
    };
    let job = match wait_s {
        Some(wait_s) if !job.status.is_final() => {
            // If the client goes away, this future is dropped during the wait, and the guard cancels the job.
            let guard = accepted.cancel_on_disconnect.then(|| app.jobs.cancel_on_drop(&job.id, caller.owner()));
            let job = app.jobs.wait(&job.id, caller.owner(), Duration::from_secs(wait_s)).await;
            guard.into_iter().for_each(CancelOnDrop::keep);
            job?
        }
        _ => job,
    };
    // A finished job is answered with 200 if the client waits or if the job already existed. A new job is answered with
    // 202 if the client does not wait.
    let finished = job.status.is_final() && (wait_s.is_some() || !created);
    let status = if finished { StatusCode::OK } else { StatusCode::ACCEPTED };
    let location = job.links.this.clone();
    let mut response = match mesh_format {
        Some(format) if finished => {
            let answered = mesh_of(app, caller, &job, format).await;
            led_to_job(answered.unwrap_or_else(IntoResponse::into_response), &job)
        }
        _ => answer(status, &location, job),
    };
    if mesh_format.is_some() {
        response.headers_mut().insert(header::VARY, HeaderValue::from_static("Accept"));
    }
    Ok(with_wait(response, wait_s))
}

/// Returns the mesh format that the client prefers to the job. Clients that accept anything get the job.
fn accepted_mesh(headers: &HeaderMap) -> Option<MeshFormat> {
    let offered = ["application/json"].into_iter().chain(MeshFormat::ALL.map(MeshFormat::media_type));
    let chosen = accepted(headers, &offered.collect::<Vec<_>>())?;
    chosen.checked_sub(1).map(|index| MeshFormat::ALL[index])
}

/// Answers with the mesh of a finished job.
async fn mesh_of(app: &App, caller: &Caller, job: &Job, format: MeshFormat) -> Result<Response, Failure> {
    if let Some(error) = &job.error {
        return Err(Failure::of_failed_job(error.clone()));
    }
    let file = mesh_file(app, caller, &job.id, format, Choices::default()).await?;
    let tag = format!("\"{}\"", file.tag);
    let whole = 0..file.length;
    let mut response = bytes_of(&file, whole);
    describe(&mut response, &tag, format.media_type(), &format!("{}.{}", job.id, format.name()));
    Ok(response)
}

/// Adds `Location` and `Link` to the answer to a submission that asked for a mesh. Both lead to the job, whether it has
/// a mesh or not.
fn led_to_job(mut response: Response, job: &Job) -> Response {
    let this = &job.links.this;
    let link = format!("<{this}>; rel=\"describedby\"");
    for (name, value) in [(header::LOCATION, this.as_str()), (header::LINK, link.as_str())] {
        if let Ok(value) = HeaderValue::from_str(value) {
            response.headers_mut().insert(name, value);
        }
    }
    response
}

/// Length in bytes of the longest example in the API document. Longer examples have hundreds of lines of coordinates
/// and are only at `GET /v1/examples/{name}`.
const MAX_EXAMPLE_BYTES: usize = 1200;

fn entry(kind: Kind) -> Value {
    let examples: Map<String, Value> = ready_requests()
        .iter()
        .filter(|example| example.kind == kind && example.request.to_string().len() <= MAX_EXAMPLE_BYTES)
        .map(|example| (example.name.into(), json!({ "summary": example.title, "value": example.request })))
        .collect();
    let mut post = submission_entry(&request_component(kind), &job_component(kind), "job", Value::Object(examples));
    post["operationId"] = format!("post{}", kind.pascal_name()).into();
    post["summary"] = kind.summary().into();
    post["description"] = "With `Prefer: wait` and an `Accept` that prefers a media type of `getMesh`, such as \
        `model/gltf-binary`, the answer to a job that succeeds in time is the mesh itself. `Location` and `Link` lead \
        to its job. A job without a mesh is then answered with 409, and the problem's `type` is that of the job's \
        `error`."
        .into();
    // The description of this operation says when the answer is a mesh. These strings have no format `binary`, because
    // orval reads every answer of an operation with such a string as a blob, jobs too.
    let answers = &mut post["responses"]["200"]["content"];
    for media_type in MeshFormat::ALL.map(MeshFormat::media_type) {
        answers[media_type]["schema"] = json!({ "type": "string", "contentMediaType": media_type });
    }
    answers[MeshFormat::Json.media_type()]["schema"] = reference("Mesh");
    post["responses"]["409"] = json!({ "$ref": "#/components/responses/NoMesh" });
    post["responses"]["406"] = json!({ "$ref": "#/components/responses/NotAcceptable" });
    if kind.has_source() {
        post["responses"]["404"] = json!({ "$ref": "#/components/responses/NotFound" });
        post["responses"]["410"] = json!({ "$ref": "#/components/responses/Gone" });
    }
    post["responses"]["202"]["links"] =
        json!({ "job": { "operationId": "getJob", "parameters": { "id": "$response.body#/id" } } });
    post
}

/// Returns the entry of a POST of `body` that answers with `answer`, a job or a batch. The client may wait for the end.
pub fn submission_entry(body: &str, answer: &str, resource: &str, examples: Value) -> Value {
    let location = json!({ "description": format!("Address of the {resource}."), "schema": { "type": "string" } });
    let wait = json!({ "description": "The wait that was granted.", "schema": { "type": "string" } });
    let finished = json!({
        "description": format!("The {resource} ended within the time of `Prefer: wait` (read its `status`), or this \
         idempotency key was used before with this body."),
        "headers": { "Preference-Applied": wait, "Location": location },
        "content": { "application/json": { "schema": reference(answer) } },
    });
    let accepted = json!({
        "description": format!("The {resource} is stored on disk and will be solved."),
        "headers": { "Location": location, "Retry-After": { "$ref": "#/components/headers/RetryAfter" },
            "Preference-Applied": wait },
        "content": { "application/json": { "schema": reference(answer) } },
    });
    json!({
        "tags": ["solve"],
        "parameters": [
            prefer_parameter(),
            { "name": "Idempotency-Key", "in": "header", "required": false,
              "description": format!("Printable ASCII text. The same key with the same body returns the same \
               {resource}; with another body the answer is 422."),
              "schema": { "type": "string", "minLength": 1, "maxLength": 200, "pattern": "^[!-~]+$" } },
        ],
        "requestBody": { "required": true,
            "content": { "application/json": { "schema": reference(body), "examples": examples } } },
        "responses": with_problems(json!({ "200": finished, "202": accepted }), &[
            ("400", "BadRequest"), ("408", "RequestTimeout"), ("413", "TooLarge"), ("415", "UnsupportedMediaType"),
            ("422", "Invalid"), ("429", "QueueFull"), ("503", "Unavailable"),
        ]),
    })
}

/// Answers with a job or a batch and its address.
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

/// Returns the wait that the client prefers, limited to this server's maximum.
pub fn granted_wait_s(app: &App, headers: &HeaderMap) -> Option<u64> {
    prefer_wait_s(headers).map(|wait_s| wait_s.min(app.config.http.wait_max_s))
}

/// Adds the header that names the granted wait, if the client asked for one.
pub fn with_wait(mut response: Response, wait_s: Option<u64>) -> Response {
    if let Some(value) = wait_s.and_then(|wait_s| HeaderValue::from_str(&format!("wait={wait_s}")).ok()) {
        response.headers_mut().insert(PREFERENCE_APPLIED, value);
    }
    response
}

pub fn idempotency_key(headers: &HeaderMap) -> Result<Option<String>, Failure> {
    let Some(value) = headers.get(IDEMPOTENCY_KEY) else { return Ok(None) };
    let key = value.to_str().ok().filter(|key| is_idempotency_key(key));
    key.map(|key| Some(key.to_owned())).ok_or_else(|| {
        Failure::bad_header("Idempotency-Key must be 1 to 200 printable ASCII characters without spaces")
    })
}

pub fn is_idempotency_key(key: &str) -> bool {
    (1..=200).contains(&key.len()) && key.bytes().all(|byte| byte.is_ascii_graphic())
}
