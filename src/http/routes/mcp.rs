//! `POST /mcp`: the tools of [`http::mcp`](crate::http::mcp) by the Model Context Protocol over streamable HTTP.
//!
//! The server keeps no sessions, because every call of a tool is one request with one answer. Calls of one client may
//! therefore reach different processes on one database. GET and DELETE, which belong to sessions, are answered with 405
//! as the protocol allows.

use crate::http::access::Caller;
use crate::http::body;
use crate::http::mcp::Tools;
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
    let tools = tools_of(&app, &caller, request.uri(), request.headers());
    let (uri, mut headers) = (request.uri().clone(), request.headers().clone());
    // The library logs requests at the level debug, and logs must not contain keys.
    headers.remove(header::AUTHORIZATION);
    let received = body::read_json(&app, request).await?;
    refuse_too_many_values(&received.bytes, &app.config.limits.requests())?;
    // The library parses the message into JSON values.
    refuse_too_much_as_values(&received.bytes)?;
    let mut forwarded = Request::new(Full::new(Bytes::from_owner(received)));
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
        .with_max_request_body_bytes(app.config.limits.body_bytes);
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
fn tools_of(app: &App, caller: &Caller, uri: &Uri, headers: &HeaderMap) -> Tools {
    let text = |name: &HeaderName| headers.get(name).and_then(|value| value.to_str().ok());
    let secure = text(&X_FORWARDED_PROTO).is_some_and(|scheme| scheme.eq_ignore_ascii_case("https"));
    let host = uri.authority().map(|authority| authority.as_str()).or_else(|| text(&header::HOST));
    Tools::of_request(app.clone(), caller.owner(), if secure { "https" } else { "http" }, host)
}
