//! For containers: alive, ready, metrics.

use crate::app::App;
use crate::http::problem::Failure;
use crate::telemetry::metric;
use axum::Json;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde_json::{Value, json};

pub async fn live() -> Json<Value> {
    Json(json!({ "status": "live" }))
}

/// 503 while shutting down, and while the store does not answer.
pub async fn ready(State(app): State<App>) -> Result<Json<Value>, Failure> {
    if app.jobs.is_shutting_down() {
        return Err(Failure::unavailable("the server is shutting down"));
    }
    app.jobs.check_store().await?;
    Ok(Json(json!({ "status": "ready" })))
}

pub async fn metrics(State(app): State<App>) -> Result<Response, Failure> {
    let counts = app.jobs.counts().await?;
    metrics::gauge!(metric::QUEUE_LENGTH).set(counts.queued as f64);
    Ok(([(header::CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8")], app.metrics.render()).into_response())
}
