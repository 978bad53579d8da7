//! `POST /mcp`: the tools of [`http::mcp`](crate::http::mcp) by the Model Context Protocol over streamable HTTP.
//!
//! The server keeps no sessions, because every call of a tool is one request with one answer. Calls of one client may
//! therefore reach different processes on one database. GET and DELETE, which belong to sessions, are answered with 405
//! as the protocol allows.

use crate::http::access::Caller;
use crate::http::body::{self, Received};
use crate::http::mcp::{ENVELOPE_BYTES, Message, Tools};
use crate::http::problem::Failure;
use crate::http::state::App;
use axum::body::{Body, Bytes};
use axum::extract::State;
use axum::http::{HeaderMap, HeaderName, Method, Request, Uri, header};
use axum::response::Response;
use http_body_util::{BodyExt, Full};
use plateau_engine::limits::{refuse_too_many_values, refuse_too_much_as_values};
use rmcp::transport::streamable_http_server::session::never::NeverSessionManager;
use rmcp::transport::{StreamableHttpServerConfig, StreamableHttpService};
use std::sync::Arc;

const X_FORWARDED_PROTO: HeaderName = HeaderName::from_static("x-forwarded-proto");

pub async fn post(State(app): State<App>, caller: Caller, request: Request<Body>) -> Result<Response, Failure> {
    if !app.config.http.mcp {
        return Err(Failure::not_found("MCP is off on this server; the setting http.mcp turns it on"));
    }
    let (uri, mut headers) = (request.uri().clone(), request.headers().clone());
    // The library logs requests at the level debug, and logs must not contain keys.
    headers.remove(header::AUTHORIZATION);
    let mut received = body::read_json(&app, request).await?;
    refuse_too_many_values(&received.bytes, &app.config.limits.requests())?;
    // The message is parsed into JSON values.
    refuse_too_much_as_values(&received.bytes)?;
    let body = received.bytes.clone();
    let Message { text, request } = app.jobs.off_runtime(move || Message::read(&body)).await??;
    // The request keeps the share of the budget that the body had.
    let request = request.map(|request| {
        received.bytes = request.into();
        received
    });
    let tools = tools_of(&app, &caller, &uri, &headers, request);
    let mut forwarded = Request::new(Full::new(Bytes::from(text)));
    *forwarded.method_mut() = Method::POST;
    *forwarded.uri_mut() = uri;
    *forwarded.headers_mut() = headers;
    // The host and the page's origin were checked before this handler, by the rules of `http::access`. The library's
    // own list of hosts knows neither `http.hosts` nor servers on public addresses.
    let config = StreamableHttpServerConfig::default()
        .disable_allowed_hosts()
        .disable_allowed_origins()
        .with_legacy_session_mode(false)
        .with_json_response(true)
        .with_max_request_body_bytes(ENVELOPE_BYTES);
    let sessions = Arc::new(NeverSessionManager::default());
    let response = StreamableHttpService::new(move || Ok(tools.clone()), sessions, config).handle(forwarded).await;
    let is_json = response.headers().get(header::CONTENT_TYPE).is_some_and(|value| value == "application/json");
    if response.status().is_success() || is_json {
        return Ok(response.map(Body::new));
    }
    let status = response.status();
    let text = response.into_body().collect().await.map(|body| body.to_bytes()).unwrap_or_default();
    Err(Failure::of_library(status, String::from_utf8_lossy(&text).into_owned()))
}

/// Returns the caller's tools, whose links begin with the address that the client used.
fn tools_of(app: &App, caller: &Caller, uri: &Uri, headers: &HeaderMap, request: Option<Received>) -> Tools {
    let text = |name: &HeaderName| headers.get(name).and_then(|value| value.to_str().ok());
    let secure = text(&X_FORWARDED_PROTO).is_some_and(|scheme| scheme.eq_ignore_ascii_case("https"));
    let host = uri.authority().map(|authority| authority.as_str()).or_else(|| text(&header::HOST));
    Tools::of_message(app.clone(), caller.owner(), (if secure { "https" } else { "http" }, host), request)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::auth::Keys;
    use crate::config::{AuthConfig, Config, HttpConfig};
    use crate::http::budget::Budget;
    use crate::http::open_requests::OpenRequests;
    use crate::jobs::Jobs;
    use crate::store::{Store, StoreOptions};
    use axum::http::StatusCode;
    use metrics_exporter_prometheus::PrometheusBuilder;
    use serde_json::{Value, json};
    use std::sync::mpsc::channel;
    use std::sync::{Mutex, PoisonError};
    use std::time::Duration;

    /// Returns a server in a folder, without workers.
    async fn app(folder: &std::path::Path) -> App {
        let url = format!("sqlite://{}/plateau.db", folder.display());
        let store = Store::open(&url, StoreOptions::default()).await.unwrap();
        let http = HttpConfig { mcp: true, ..HttpConfig::default() };
        let config = Arc::new(Config { http, ..Config::default() });
        App {
            jobs: Jobs::new(store, config.clone(), None).unwrap(),
            metrics: PrometheusBuilder::new().build_recorder().handle(),
            bodies: Arc::new(Budget::new(1 << 30, 100, 1 << 30)),
            seats: Arc::new(OpenRequests::new(1)),
            keys: Arc::new(Keys::load(&AuthConfig::default()).unwrap()),
            document: |_| String::new(),
            config,
        }
    }

    fn call(tool: &str, arguments: &Value) -> Value {
        json!({ "jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": { "name": tool, "arguments": arguments } })
    }

    async fn ask(app: &App, message: &Value) -> Result<(StatusCode, Value), Failure> {
        let request = Request::post("/mcp")
            .header(header::HOST, "localhost")
            .header(header::CONTENT_TYPE, "application/json")
            .header(header::ACCEPT, "application/json, text/event-stream")
            .body(Body::from(message.to_string()))
            .unwrap();
        let response = post(State(app.clone()), Caller::default(), request).await?;
        let status = response.status();
        let bytes = response.into_body().collect().await.unwrap().to_bytes();
        Ok((status, serde_json::from_slice(&bytes).unwrap()))
    }

    #[tokio::test]
    async fn a_message_waits_for_a_thread_before_it_is_parsed() {
        let folder = tempfile::tempdir().unwrap();
        let app = app(folder.path()).await;
        let (gate, closed) = channel::<()>();
        let closed = Arc::new(Mutex::new(closed));
        // More than there are threads.
        for _ in 0..64 {
            let (jobs, closed) = (app.jobs.clone(), closed.clone());
            let wait = move || closed.lock().unwrap_or_else(PoisonError::into_inner).recv();
            tokio::spawn(async move { jobs.off_runtime(wait).await });
        }
        tokio::task::yield_now().await;
        let message = call("describe", &json!({}));
        let mut asked = std::pin::pin!(ask(&app, &message));
        let waited = tokio::time::timeout(Duration::from_millis(300), &mut asked).await;
        assert!(waited.is_err(), "all threads that parse are occupied");
        drop(gate);
        assert_eq!(asked.await.unwrap().0, StatusCode::OK);
    }

    #[tokio::test]
    async fn only_the_request_of_a_call_may_be_large() {
        let folder = tempfile::tempdir().unwrap();
        let app = app(folder.path()).await;
        let long = "x".repeat(ENVELOPE_BYTES);
        let refused = [
            call("get", &json!({ "id": long })),
            call("solve", &json!({ "request": { "kind": long } })),
            call("solve", &json!({ "request": [long] })),
            json!({ "jsonrpc": "2.0", "id": 1, "method": "ping", "params": { "a": long } }),
        ];
        for message in refused {
            let failure = ask(&app, &message).await.expect_err("too large");
            assert!(failure.to_string().contains("65536 bytes beside the request"), "{failure}");
        }
        // The request is read whole, and its errors are named.
        let request = json!({ "kind": "minimal_surface", "boundaries": [[]], "label": long });
        let (status, answer) = ask(&app, &call("start", &json!({ "request": request }))).await.unwrap();
        assert_eq!(status, StatusCode::OK);
        let text = answer["result"]["content"][0]["text"].as_str().unwrap();
        assert!(text.contains("/request/label") && text.contains("/request/boundaries/0"), "{text}");
    }
}
