//! `/v1/jobs`: lists, shows, waits for, cancels and deletes jobs.

use super::mesh::{answer as file_answer, choose};
use super::submit::{granted_wait_s, is_idempotency_key, with_wait};
use crate::http::access::Caller;
use crate::http::entry::{
    ULID, id_parameter, json_response, prefer_parameter, problem, query_parameter, with_problems,
};
use crate::http::parameters::{checked, parameters};
use crate::http::problem::Failure;
use crate::http::state::App;
use crate::jobs::Selection;
use crate::status::{CancelReason, Status};
use crate::wire::callback::Callbacks;
use crate::wire::job::{Job, JobList};
use axum::Json;
use axum::extract::{Path, RawQuery, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use plateau_engine::components::REQUEST_WITH_KIND;
use plateau_engine::kind::Kind;
use serde_json::{Value, json};
use std::time::Duration;

pub async fn list(State(app): State<App>, caller: Caller, RawQuery(query): RawQuery) -> Result<Json<JobList>, Failure> {
    let names =
        ["status", "kind", "label", "batch", "created_after", "idempotency_key", "limit", "cursor", "statistics"];
    let [status, kind, label, batch, created_after, idempotency_key, limit, cursor, statistics] =
        parameters(query.as_deref(), names)?;
    let read_status = |name: &str| {
        Status::from_name(name).ok_or_else(|| {
            let names = Status::ALL.map(Status::name).join(", ");
            Failure::bad_query(format!("status must be a list of these names, separated by commas: {names}"))
        })
    };
    let statuses = match &status {
        Some(names) => names.split(',').map(read_status).collect::<Result<_, _>>()?,
        None => Vec::new(),
    };
    let batch = batch
        .map(|batch| checked(&batch).map_err(|_| Failure::bad_query("batch must be the identifier of a batch")))
        .transpose()?;
    let created_after_ms = created_after.map(|text| read_time(&text)).transpose()?;
    let kind = kind
        .map(|name| Kind::from_name(&name).ok_or_else(|| Failure::bad_query("kind is not a kind of job")))
        .transpose()?;
    if idempotency_key.as_deref().is_some_and(|key| !is_idempotency_key(key)) {
        return Err(Failure::bad_query("idempotency_key must be 1 to 200 printable ASCII characters without spaces"));
    }
    let limit = limit.map_or(Ok(50), |text| match text.parse() {
        Ok(limit @ 1..=200) => Ok(limit),
        _ => Err(Failure::bad_query("limit must be a whole number from 1 to 200")),
    })?;
    let cursor = cursor
        .map(|cursor| checked(&cursor).map_err(|_| Failure::bad_query("cursor must be a next_cursor of this list")))
        .transpose()?;
    let with_statistics = match statistics.as_deref() {
        None | Some("false") => false,
        Some("true") => true,
        Some(_) => return Err(Failure::bad_query("statistics must be true or false")),
    };
    let selection = Selection { statuses, kind, idempotency_key, label, batch, created_after_ms };
    Ok(Json(app.jobs.list(caller.owner(), selection, limit, cursor.as_deref(), with_statistics).await?))
}

pub fn list_entry() -> Value {
    let names = |names: Vec<&str>| json!({ "type": "string", "enum": names });
    let statuses = names(Status::ALL.iter().map(|status| status.name()).collect());
    let kinds = names(Kind::ALL.iter().map(|kind| kind.name()).collect());
    let mut status = query_parameter(
        "status",
        "Only jobs in one of these states, separated by commas.",
        json!({ "type": "array", "items": statuses, "minItems": 1 }),
    );
    status["style"] = "form".into();
    status["explode"] = false.into();
    let key = json!({ "type": "string", "minLength": 1, "maxLength": 200, "pattern": "^[!-~]+$" });
    json!({
        "operationId": "listJobs", "tags": ["jobs"], "summary": "Jobs, newest first",
        "parameters": [
            status,
            query_parameter("kind", "Only jobs of this kind.", kinds),
            query_parameter("label", "Only jobs with this label.", json!({ "type": "string" })),
            query_parameter("batch", "Only jobs of the batch with this identifier.",
                json!({ "type": "string", "pattern": ULID })),
            query_parameter("created_after", "Only jobs that were submitted after this time (RFC 3339).",
                json!({ "type": "string", "format": "date-time" })),
            query_parameter("idempotency_key", "Only jobs that were submitted with this `Idempotency-Key`.", key),
            query_parameter("limit", "Maximum number of jobs on the page. The default is 50.",
                json!({ "type": "integer", "minimum": 1, "maximum": 200 })),
            query_parameter("cursor", "`next_cursor` of the previous page.",
                json!({ "type": "string", "pattern": ULID })),
            query_parameter("statistics", "Whether each job that has succeeded has its statistics. The default is \
                false.", json!({ "type": "boolean" })),
        ],
        "responses": with_problems(json!({ "200": json_response("One page of jobs", "JobList") }),
            &[("400", "BadRequest"), ("503", "Unavailable")]),
    })
}

pub async fn get(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = &checked(&id)?;
    let wait_s = granted_wait_s(&app, &headers);
    let job = match wait_s {
        Some(wait_s) => app.jobs.wait(id, caller.owner(), Duration::from_secs(wait_s)).await?,
        None => app.jobs.get(id, caller.owner()).await?,
    };
    let mut response = Json(&job).into_response();
    if !job.status.is_final() {
        response.headers_mut().insert(header::RETRY_AFTER, HeaderValue::from_static("1"));
    }
    Ok(with_wait(response, wait_s))
}

pub fn get_entry() -> Value {
    let ok = json!({ "200": json_response("The job as it is now, or as it ended within the wait", "Job") });
    one("getJob", "The job with its status, progress, statistics and links", &[prefer_parameter()], ok)
}

/// Returns the entry of an operation on one job.
fn one(operation: &str, summary: &str, parameters: &[Value], responses: Value) -> Value {
    let parameters = [&[id_parameter("job")], parameters].concat();
    let problems = [("404", "NotFound"), ("410", "Gone"), ("503", "Unavailable")];
    json!({ "operationId": operation, "tags": ["jobs"], "summary": summary, "parameters": parameters,
        "responses": with_problems(responses, &problems) })
}

/// Reads a time in RFC 3339, as milliseconds since 1970.
fn read_time(text: &str) -> Result<i64, Failure> {
    let bad = || Failure::bad_query("created_after must be a time like 2026-01-31T12:00:00Z");
    // An unescaped plus sign of an offset arrives as a space.
    let text = text.to_ascii_uppercase().replace(' ', "+");
    let (time, offset_ms) = match text.strip_suffix('Z') {
        Some(time) => (time, 0),
        None => {
            let (time, offset) = text.len().checked_sub(6).and_then(|at| text.split_at_checked(at)).ok_or_else(bad)?;
            let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse::<i64>().ok());
            let (sign, offset) = offset.split_at_checked(1).ok_or_else(bad)?;
            let (hours, minutes) = offset.split_once(':').ok_or_else(bad)?;
            let number = |text| digits(text).flatten().ok_or_else(bad);
            let offset_ms = (number(hours)? * 60 + number(minutes)?) * 60_000;
            match sign {
                "+" => (time, offset_ms),
                "-" => (time, -offset_ms),
                _ => return Err(bad()),
            }
        }
    };
    let local = humantime::parse_rfc3339(&format!("{time}Z")).map_err(|_| bad())?;
    let since_1970 = local.duration_since(std::time::UNIX_EPOCH).unwrap_or_default();
    Ok(i64::try_from(since_1970.as_millis()).unwrap_or(i64::MAX).saturating_sub(offset_ms))
}

pub async fn request(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = &checked(&id)?;
    let (_, media_type) = choose(None, &headers, &[("json", "application/json")])?;
    let file = app.jobs.request(id, caller.owner()).await?;
    Ok(file_answer(&headers, &file, media_type, &format!("{id}.request.json")))
}

pub fn request_entry() -> Value {
    let ok = json!({ "200": json_response("The request with its kind and every option", REQUEST_WITH_KIND) });
    one("getRequest", "The request as it was accepted, kept as long as its job", &[], ok)
}

pub async fn cancel(State(app): State<App>, caller: Caller, Path(id): Path<String>) -> Result<Json<Job>, Failure> {
    Ok(Json(app.jobs.cancel(&checked(&id)?, caller.owner(), CancelReason::Client).await?))
}

pub fn cancel_entry() -> Value {
    let ok = json!({ "200": json_response("The job", "Job") });
    one("cancelJob", "Cancels a queued or running job; a finished job stays unchanged", &[], ok)
}

pub async fn callbacks(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
) -> Result<Json<Callbacks>, Failure> {
    Ok(Json(app.jobs.callbacks(&checked(&id)?, caller.owner()).await?))
}

pub fn callbacks_entry() -> Value {
    let ok = json!({ "200": json_response("The callback and its attempts", "Callbacks") });
    one("getJobCallbacks", "What became of the message to the job's callback URL", &[], ok)
}

pub async fn send_callback_again(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
) -> Result<(StatusCode, Json<Callbacks>), Failure> {
    let callbacks = app.jobs.send_callback_again(&checked(&id)?, caller.owner()).await?;
    Ok((StatusCode::ACCEPTED, Json(callbacks)))
}

pub fn send_callback_again_entry() -> Value {
    let accepted = json!({ "202": json_response("The callback, which is sent once the job has ended", "Callbacks") });
    let mut entry = one("sendJobCallbackAgain", "Sends the message to the job's callback URL again", &[], accepted);
    entry["responses"]["409"] = problem("The request named no callback URL", &[]);
    entry
}

pub async fn delete(State(app): State<App>, caller: Caller, Path(id): Path<String>) -> Result<StatusCode, Failure> {
    app.jobs.delete(&checked(&id)?, caller.owner()).await?;
    Ok(StatusCode::NO_CONTENT)
}

pub fn delete_entry() -> Value {
    one(
        "deleteJob",
        "Cancels the job if needed, and removes it with its mesh",
        &[],
        json!({ "204": { "description": "Removed" } }),
    )
}
