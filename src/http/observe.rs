//! Middleware around every route. It gives each request an identifier and a log span, counts and times the request, and
//! completes problem documents.

use crate::http::assets;
use crate::http::problem::{self, Failure};
use crate::telemetry::metric;
use axum::body::Body;
use axum::extract::{MatchedPath, Request, State};
use axum::http::{HeaderName, HeaderValue, Method, Response};
use axum::middleware::Next;
use axum::response::IntoResponse;
use futures_util::FutureExt;
use std::panic::AssertUnwindSafe;
use std::sync::Arc;
use std::time::Instant;
use tracing::Instrument;

/// Header with the identifier of the request, in requests and responses.
pub const REQUEST_ID: HeaderName = HeaderName::from_static("x-request-id");

/// Returns the client's request identifier if it is short and printable, or a new one.
fn request_id(request: &Request) -> String {
    request
        .headers()
        .get(REQUEST_ID)
        .and_then(|value| value.to_str().ok())
        .filter(|id| (1..=100).contains(&id.len()) && id.bytes().all(|byte| byte.is_ascii_graphic()))
        .map_or_else(|| ulid::Ulid::generate().to_string(), str::to_owned)
}

/// Returns the client's trace and span identifiers (W3C Trace Context, version 00), if the header has that form.
fn trace(request: &Request) -> Option<(&str, &str)> {
    let value = request.headers().get("traceparent")?.to_str().ok()?;
    let mut parts = value.split('-');
    let mut part = |length: usize| {
        let hex = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
        parts.next().filter(|text| text.len() == length && text.bytes().all(hex))
    };
    let (version, trace, span, _flags) = (part(2)?, part(32)?, part(16)?, part(2)?);
    let known = version == "00" && parts.next().is_none();
    let valid = [trace, span].iter().all(|id| id.bytes().any(|byte| byte != b'0'));
    (known && valid).then_some((trace, span))
}

/// Returns the label of a method in metrics. A client may send any word as a method, and any path.
/// Methods that no route has share one label, as unknown paths do, so that the number of time
/// series is bounded.
fn method_label(method: &Method) -> &'static str {
    match *method {
        Method::GET => "GET",
        Method::HEAD => "HEAD",
        Method::POST => "POST",
        Method::DELETE => "DELETE",
        Method::OPTIONS => "OPTIONS",
        _ => "other",
    }
}

/// Logs, counts and completes a request. `base` is the base path of this server.
pub async fn observe(State(base): State<Arc<str>>, request: Request, next: Next) -> Response<Body> {
    let started = Instant::now();
    let id = request_id(&request);
    let path = request.uri().path().to_owned();
    let method = request.method().as_str().to_owned();
    let label = method_label(request.method());
    let route = request.extensions().get::<MatchedPath>().map_or("unmatched", MatchedPath::as_str).to_owned();
    let empty = tracing::field::Empty;
    let span = tracing::info_span!(
        "request", request_id = %id, %method, %path, key = empty, trace_id = empty, parent_span_id = empty
    );
    if let Some((trace, parent)) = trace(&request) {
        span.record("trace_id", trace).record("parent_span_id", parent);
    }
    let answered = AssertUnwindSafe(next.run(request)).catch_unwind().instrument(span.clone()).await;
    let response = answered.unwrap_or_else(|_| {
        span.in_scope(|| tracing::error!("a handler panicked"));
        Failure::internal("the request hit a defect of this server").into_response()
    });
    let mut response = problem::write_problem(response, &base, &path);
    assets::protect(response.headers_mut());
    if let Ok(value) = HeaderValue::from_str(&id) {
        response.headers_mut().insert(REQUEST_ID, value);
    }
    let status = response.status().as_u16();
    let elapsed = started.elapsed();
    span.in_scope(|| tracing::info!(status, elapsed_ms = elapsed.as_secs_f64() * 1e3, "answered"));
    metrics::counter!(metric::HTTP_REQUESTS, "method" => label, "route" => route.clone(),
        "status" => status.to_string())
    .increment(1);
    metrics::histogram!(metric::HTTP_SECONDS, "method" => label, "route" => route).record(elapsed.as_secs_f64());
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_well_formed_trace_parents_are_logged() {
        let of = |value: &str| {
            let request = Request::builder().header("traceparent", value).body(Body::empty()).unwrap();
            trace(&request).map(|(trace, span)| format!("{trace} {span}"))
        };
        let (trace, span) = ("4bf92f3577b34da6a3ce929d0e0e4736", "00f067aa0ba902b7");
        assert_eq!(of(&format!("00-{trace}-{span}-01")), Some(format!("{trace} {span}")));
        for other in [
            String::new(),
            format!("00-{trace}-{span}"),
            format!("01-{trace}-{span}-01"),
            format!("00-{trace}-{span}-01-02"),
            format!("00-{}-{span}-01", trace.to_uppercase()),
            format!("00-{}-{span}-01", "0".repeat(32)),
            format!("00-{trace}-{}-01", "0".repeat(16)),
        ] {
            assert_eq!(of(&other), None, "{other}");
        }
    }
}
