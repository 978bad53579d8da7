//! Health checks and metrics, for containers and monitoring.

use crate::http::entry::{plain_get, with_problems};
use crate::http::problem::Failure;
use crate::http::state::App;
use crate::jobs::Jobs;
use crate::telemetry::metric;
use axum::Json;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse, Response};
use metrics_exporter_prometheus::PrometheusHandle;
use serde_json::{Value, json};

pub async fn live() -> Json<Value> {
    Json(json!({ "status": "live" }))
}

pub fn live_entry() -> Value {
    entry("getLive", "Checks that the process answers", &[], json!({}))
}

fn entry(operation: &str, summary: &str, problems: &[(&str, &str)], more: Value) -> Value {
    let mut schema =
        json!({ "type": "object", "required": ["status"], "properties": { "status": { "type": "string" } } });
    if let (Value::Object(more), Some(properties)) = (more, schema["properties"].as_object_mut()) {
        properties.extend(more);
    }
    let ok = json!({ "description": summary, "content": { "application/json": { "schema": schema } } });
    json!({ "operationId": operation, "tags": ["operation"], "summary": summary,
        "responses": with_problems(json!({ "200": ok }), problems) })
}

/// Answers 503 while the server is shutting down and while the store does not answer. Otherwise it says how many
/// solvers were given up.
pub async fn ready(State(app): State<App>) -> Result<Json<Value>, Failure> {
    if app.jobs.is_shutting_down() {
        return Err(Failure::unavailable("the server is shutting down"));
    }
    app.jobs.check_store().await?;
    Ok(Json(json!({ "status": "ready", "unresponsive_solvers": app.jobs.unresponsive() })))
}

pub fn ready_entry() -> Value {
    let solvers = json!({ "unresponsive_solvers": { "type": "integer", "format": "int64", "minimum": 0,
        "description": "Number of solvers that did not end in time after a cancel or their deadline, and were given \
         up. They go on in threads of this process. From `jobs.unresponsive_max` on, further jobs are solved in \
         processes of their own, which are killed instead." } });
    entry("getReady", "Checks that the store answers and jobs are accepted", &[("503", "Unavailable")], solvers)
}

pub async fn metrics(State(app): State<App>) -> Result<Response, Failure> {
    render(&app.jobs, &app.metrics).await
}

pub fn metrics_entry() -> Value {
    plain_get("operation", "getMetrics", "Metrics as Prometheus text", "text/plain", &json!({ "type": "string" }))
}

/// Returns the metrics of this process and the length of the shared queue.
pub async fn render(jobs: &Jobs, handle: &PrometheusHandle) -> Result<Response, Failure> {
    metrics::gauge!(metric::QUEUE_LENGTH).set(jobs.queue_length().await? as f64);
    // The figures of this process, under the names that Prometheus uses in every program.
    metrics_process::Collector::default().collect();
    jobs.note_usage_of_children();
    Ok(([(header::CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8")], handle.render()).into_response())
}
