//! `GET /v1/jobs/{id}/events`: a job's events as server-sent events.

use crate::http::access::Caller;
use crate::http::entry::{id_parameter, with_problems};
use crate::http::parameters::checked;
use crate::http::problem::Failure;
use crate::http::state::App;
use crate::jobs::events::Events;
use axum::extract::{Path, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode, header};
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use futures_util::stream::{self, Stream, StreamExt};
use serde_json::{Value, json};
use std::convert::Infallible;
use std::time::Duration;

/// Time after which a client that lost the stream should reconnect.
const RETRY: Duration = Duration::from_secs(2);

/// Sends status changes and progress as they happen. `Last-Event-ID` replays missed events. A client that has seen the
/// final event gets 204.
pub async fn events(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let last = headers.get("last-event-id").filter(|value| !value.is_empty());
    let read = |value: &HeaderValue| value.to_str().ok().and_then(|text| text.parse().ok());
    let last = last.map(|value| {
        let bad = || Failure::bad_header("Last-Event-ID must be the id of an event of this stream, like 1.7");
        read(value).ok_or_else(bad)
    });
    let last = last.transpose()?;
    let Some(events) = app.jobs.events(&checked(&id)?, caller.owner(), last).await? else {
        return Ok(StatusCode::NO_CONTENT.into_response());
    };
    let keep_alive = Duration::from_millis(app.config.http.event_keep_alive_ms);
    let mut response =
        Sse::new(written(events)).keep_alive(KeepAlive::new().interval(keep_alive).text("still here")).into_response();
    let headers = response.headers_mut();
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-cache"));
    headers.insert(HeaderName::from_static("x-accel-buffering"), HeaderValue::from_static("no"));
    Ok(response)
}

/// Converts events to server-sent events. The reconnection time is sent before them, so that every stream delivers
/// bytes at once. A client that receives nothing therefore knows that a proxy buffers the stream.
fn written(events: Events) -> impl Stream<Item = Result<Event, Infallible>> {
    let opening = stream::once(async { Ok(Event::default().retry(RETRY)) });
    opening.chain(stream::unfold(events, |mut events| async move {
        let event = events.next().await?;
        Some((Ok(Event::default().id(event.id).event(event.name).data(event.data)), events))
    }))
}

pub fn events_entry() -> Value {
    let stream = json!({
        "description": "Server-sent events: `status` events, `progress` events, and one final `status` event",
        "content": { "text/event-stream": { "schema": {
            "type": "object", "description": "One event", "required": ["id", "event", "data"],
            "properties": {
                "id": { "type": "string", "description": "`attempt.sequence`" },
                "event": { "type": "string", "enum": ["status", "progress"] },
                "data": { "type": "string",
                    "description": "JSON text. For a `status` event it is the job as it was right after that change. \
                     For a `progress` event it is an object with the job's `id`, `status` and `progress`." },
                "retry": { "type": "integer", "format": "int64", "minimum": 0 },
            },
        } } },
    });
    let last = json!({ "name": "Last-Event-ID", "in": "header", "required": false,
        "description": "Identifier of the last event that the client saw, `attempt.sequence`. An empty one names no \
         event. After the final event the answer is 204.",
        "schema": { "type": "string", "pattern": r"^([0-9]{1,9}\.[0-9]{1,9})?$" } });
    let responses =
        json!({ "200": stream, "204": { "description": "The client has seen the final event, so no event follows" } });
    json!({
        "operationId": "getEvents", "tags": ["jobs"], "summary": "Progress as server-sent events",
        "parameters": [id_parameter("job"), last],
        "responses": with_problems(responses,
            &[("400", "BadRequest"), ("404", "NotFound"), ("410", "Gone"), ("503", "Unavailable")]),
    })
}
