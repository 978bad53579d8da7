//! `/v1/jobs`: list, look, wait, cancel, delete, follow.

use super::submit::{granted_wait_s, with_wait};
use crate::app::App;
use crate::http::auth::Caller;
use crate::http::problem::Failure;
use crate::jobs::{EventId, Filter, JobRow, JobWatch, Jobs, StoredStatus as Stored};
use crate::wire::Kind;
use crate::wire::job::{Job, JobList, Status};
use axum::Json;
use axum::extract::{Path, RawQuery, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode, header};
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use futures_util::stream::{self, Stream};
use std::collections::VecDeque;
use std::convert::Infallible;
use std::time::Duration;

/// Job ids are ULIDs; anything else names no job, and is not worth asking the store about.
pub fn checked(id: &str) -> Result<&str, Failure> {
    let valid = id.len() == 26 && id.bytes().all(|byte| byte.is_ascii_digit() || byte.is_ascii_uppercase());
    if valid { Ok(id) } else { Err(Failure::not_found("no such job")) }
}

/// The parameters of a query, each known and at most once.
pub fn parameters<const N: usize>(query: Option<&str>, names: [&str; N]) -> Result<[Option<String>; N], Failure> {
    let mut values = [const { None }; N];
    for pair in query.unwrap_or_default().split('&').filter(|pair| !pair.is_empty()) {
        let (name, value) = pair.split_once('=').unwrap_or((pair, ""));
        let index = names
            .iter()
            .position(|known| *known == name)
            .ok_or_else(|| Failure::bad_query(format!("known parameters are: {}", names.join(", "))))?;
        if values[index].is_some() {
            return Err(Failure::bad_query(format!("{} is given twice", names[index])));
        }
        values[index] = Some(value.to_owned());
    }
    Ok(values)
}

pub async fn list(State(app): State<App>, caller: Caller, RawQuery(query): RawQuery) -> Result<Json<JobList>, Failure> {
    let [status, kind, limit, cursor] = parameters(query.as_deref(), ["status", "kind", "limit", "cursor"])?;
    let status = status
        .map(|name| Status::from_name(&name).ok_or_else(|| Failure::bad_query("status is not one of a job's states")))
        .transpose()?;
    let kind = kind
        .map(|name| Kind::from_name(&name).ok_or_else(|| Failure::bad_query("kind is not a kind of job")))
        .transpose()?;
    let limit = limit.map_or(Ok(50), |text| match text.parse() {
        Ok(limit @ 1..=200) => Ok(limit),
        _ => Err(Failure::bad_query("limit must be a whole number from 1 to 200")),
    })?;
    if cursor.as_deref().is_some_and(|cursor| checked(cursor).is_err()) {
        return Err(Failure::bad_query("cursor must be a next_cursor of this list"));
    }
    let filter = Filter {
        owner: caller.owner().map(str::to_owned),
        kind: kind.map(|kind| kind.name().into()),
        status: status.map(stored),
    };
    Ok(Json(app.jobs.list(&filter, limit, cursor.as_deref()).await?))
}

fn stored(status: Status) -> Stored {
    match status {
        Status::Queued => Stored::Queued,
        Status::Running => Stored::Running,
        Status::Succeeded => Stored::Succeeded,
        Status::Failed => Stored::Failed,
        Status::Cancelled => Stored::Cancelled,
    }
}

pub async fn get(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = checked(&id)?;
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

pub async fn cancel(State(app): State<App>, caller: Caller, Path(id): Path<String>) -> Result<Json<Job>, Failure> {
    Ok(Json(app.jobs.cancel(checked(&id)?, caller.owner()).await?))
}

pub async fn delete(State(app): State<App>, caller: Caller, Path(id): Path<String>) -> Result<StatusCode, Failure> {
    app.jobs.delete(checked(&id)?, caller.owner()).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// Status changes and progress as they come. `Last-Event-ID` replays what was missed; after the final event there is nothing left.
pub async fn events(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let last: Option<EventId> =
        headers.get("last-event-id").and_then(|value| value.to_str().ok()).and_then(|text| text.parse().ok());
    let mut watch = app.jobs.watch(checked(&id)?, caller.owner()).await?;
    let seen_to_the_end =
        watch.current().is_some_and(|row| row.status.is_final() && row.events_since(last).next().is_none());
    if last.is_some() && seen_to_the_end {
        return Ok(StatusCode::NO_CONTENT.into_response());
    }
    let keep_alive = Duration::from_millis(app.config.http.event_keep_alive_ms);
    let mut response = Sse::new(follow(app.jobs, watch, last))
        .keep_alive(KeepAlive::new().interval(keep_alive).text("still here"))
        .into_response();
    let headers = response.headers_mut();
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-cache"));
    headers.insert(HeaderName::from_static("x-accel-buffering"), HeaderValue::from_static("no"));
    Ok(response)
}

/// How soon a client that lost the stream is to come back.
const RETRY: Duration = Duration::from_secs(2);

struct Following {
    jobs: Jobs,
    watch: JobWatch,
    last: Option<EventId>,
    pending: VecDeque<Event>,
    first: bool,
    ended: bool,
}

fn follow(jobs: Jobs, watch: JobWatch, last: Option<EventId>) -> impl Stream<Item = Result<Event, Infallible>> {
    let following = Following { jobs, watch, last, pending: VecDeque::new(), first: true, ended: false };
    stream::unfold(following, |mut following| async move {
        loop {
            if let Some(event) = following.pending.pop_front() {
                return Some((Ok(event), following));
            }
            if following.ended {
                return None;
            }
            if !following.first {
                following.watch.changed().await;
            }
            // Deleted or expired: there is nothing more to say.
            let row = following.watch.current()?;
            let retry = following.first.then_some(RETRY);
            following.first = false;
            following.queue(&row, retry);
        }
    })
}

impl Following {
    /// Queues what happened since the last event: status changes, then the latest progress, in the order of their ids.
    fn queue(&mut self, row: &JobRow, retry: Option<Duration>) {
        let Ok(job) = self.jobs.view(row) else {
            self.ended = true;
            return;
        };
        let mut events: Vec<(EventId, &str, Event)> = Vec::new();
        for change in row.events_since(self.last) {
            let latest = change.status == row.status && row.events_since(Some(change.id)).next().is_none();
            // The latest change carries the whole job; earlier ones what they were.
            let data = if latest {
                serde_json::to_string(&job)
            } else {
                serde_json::to_string(
                    &serde_json::json!({ "id": row.id, "kind": row.kind, "status": change.status.name() }),
                )
            };
            events.push((change.id, "status", Event::default().data(data.unwrap_or_default())));
        }
        if !row.status.is_final()
            && let Some((id, progress)) = row.progress_since(self.last)
        {
            let data = format!(r#"{{"id":"{}","status":"{}","progress":{progress}}}"#, row.id, row.status.name());
            events.push((id, "progress", Event::default().data(data)));
        }
        events.sort_by_key(|&(id, ..)| id);
        for (id, name, event) in events {
            self.last = Some(id);
            self.pending.push_back(event.id(id.to_string()).event(name));
        }
        if let Some(retry) = retry
            && let Some(first) = self.pending.pop_front()
        {
            self.pending.push_front(first.retry(retry));
        }
        self.ended = row.status.is_final();
    }
}
