//! Logs on standard error and metrics for Prometheus.

use crate::config::{LogConfig, LogFormat};
use metrics_exporter_prometheus::{Matcher, PrometheusBuilder, PrometheusHandle};
use std::io::IsTerminal;
use tracing_subscriber::EnvFilter;
use tracing_subscriber::util::SubscriberInitExt;

/// Sends logs to standard error, filtered and formatted as configured.
///
/// # Errors
/// A filter that does not parse, or a subscriber that is already set.
pub fn init_logs(config: &LogConfig) -> Result<(), String> {
    let filter = EnvFilter::try_new(&config.level).map_err(|error| format!("log.level: {error}"))?;
    let builder = tracing_subscriber::fmt()
        .with_env_filter(filter)
        .with_writer(std::io::stderr)
        .with_ansi(std::io::stderr().is_terminal());
    let subscriber: Box<dyn tracing::Subscriber + Send + Sync> = match config.format {
        LogFormat::Text => Box::new(builder.finish()),
        LogFormat::Json => Box::new(builder.json().flatten_event(true).finish()),
    };
    subscriber.try_init().map_err(|error| error.to_string())
}

/// Names of the metrics. Units last; counters end in `_total`.
pub mod metric {
    /// Counter: finished jobs by kind and final status.
    pub const JOBS: &str = "plateau_jobs_total";
    /// Counter: submissions by kind and outcome (created, repeated, rejected, queue_full).
    pub const SUBMISSIONS: &str = "plateau_submissions_total";
    /// Counter: attempts to tell a callback URL, by outcome (delivered, failed, given_up, unwanted).
    pub const CALLBACKS: &str = "plateau_callbacks_total";
    /// Histogram: seconds from claim to finish, by kind and objective.
    pub const SOLVE_SECONDS: &str = "plateau_solve_seconds";
    /// Histogram: seconds from submission to claim, by kind.
    pub const WAIT_SECONDS: &str = "plateau_queue_wait_seconds";
    /// Gauge: jobs that wait.
    pub const QUEUE_LENGTH: &str = "plateau_queue_length";
    /// Gauge: jobs that run in this process.
    pub const RUNNING: &str = "plateau_jobs_running";
    /// Counter: HTTP requests by method, route and status.
    pub const HTTP_REQUESTS: &str = "plateau_http_requests_total";
    /// Histogram: seconds to the response's head, by method and route.
    pub const HTTP_SECONDS: &str = "plateau_http_request_seconds";
}

/// Installs the recorder; call once per process. The handle renders the text that `GET /metrics` serves.
///
/// # Errors
/// A recorder that is already installed.
pub fn init_metrics() -> Result<PrometheusHandle, String> {
    const BUCKETS: [f64; 16] =
        [0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 60.0, 600.0];
    let handle = PrometheusBuilder::new()
        .set_buckets_for_metric(Matcher::Suffix("_seconds".into()), &BUCKETS)
        .and_then(PrometheusBuilder::install_recorder)
        .map_err(|error| error.to_string())?;
    metrics::describe_counter!(metric::JOBS, "Finished jobs by kind and final status");
    metrics::describe_counter!(metric::SUBMISSIONS, "Submissions by kind and outcome");
    metrics::describe_counter!(metric::CALLBACKS, "Attempts to tell a callback URL, by outcome");
    metrics::describe_histogram!(metric::SOLVE_SECONDS, "Seconds from claim to finish");
    metrics::describe_histogram!(metric::WAIT_SECONDS, "Seconds from submission to claim");
    metrics::describe_gauge!(metric::QUEUE_LENGTH, "Jobs that wait");
    metrics::describe_gauge!(metric::RUNNING, "Jobs that run in this process");
    metrics::describe_counter!(metric::HTTP_REQUESTS, "HTTP requests by method, route and status");
    metrics::describe_histogram!(metric::HTTP_SECONDS, "Seconds to the head of the response");
    Ok(handle)
}
