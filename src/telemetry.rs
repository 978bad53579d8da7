//! Logs on standard error and metrics for Prometheus.

use crate::config::{LogConfig, LogFormat};
use metrics_exporter_prometheus::{Matcher, PrometheusBuilder, PrometheusHandle};
use std::io::IsTerminal;
use std::time::Duration;
use tracing::level_filters::LevelFilter;
use tracing_subscriber::filter::Targets;
use tracing_subscriber::layer::{Layer, SubscriberExt};
use tracing_subscriber::util::SubscriberInitExt;

/// Libraries that log the bodies of requests or the values of statements at the level debug. Logs must not contain
/// them, so these libraries never log below the level info.
const TALKATIVE: [&str; 3] = ["rmcp", "tokio_postgres", "postgres"];

/// Reads the levels of the parts of the program.
///
/// # Errors
/// Fails if the text is no list of levels.
pub fn filter(config: &LogConfig) -> Result<Targets, String> {
    let asked: Targets = config.level.parse().map_err(|error| format!("log.level: {error}"))?;
    let mut kept: Vec<(String, LevelFilter)> = asked.iter().map(|(target, level)| (target.to_owned(), level)).collect();
    for (target, level) in &mut kept {
        if TALKATIVE.iter().any(|library| is_part(target, library)) {
            *level = (*level).min(LevelFilter::INFO);
        }
    }
    let default = asked.default_level().unwrap_or(LevelFilter::OFF);
    for library in TALKATIVE {
        if !kept.iter().any(|(target, _)| target == library) {
            kept.push((library.to_owned(), default.min(LevelFilter::INFO)));
        }
    }
    Ok(Targets::new().with_targets(kept).with_default(default))
}

/// Returns true if a target is a library or a module of it.
fn is_part(target: &str, library: &str) -> bool {
    target.strip_prefix(library).is_some_and(|rest| rest.is_empty() || rest.starts_with("::"))
}

/// Sends logs to standard error, filtered and formatted as configured.
///
/// # Errors
/// Fails if the filter does not parse, or if a subscriber is already set.
pub fn init_logs(config: &LogConfig) -> Result<(), String> {
    let filter = filter(config)?;
    let layer =
        tracing_subscriber::fmt::layer().with_writer(std::io::stderr).with_ansi(std::io::stderr().is_terminal());
    let layer = match config.format {
        LogFormat::Text => layer.boxed(),
        LogFormat::Json => layer.json().flatten_event(true).boxed(),
    };
    tracing_subscriber::registry().with(layer.with_filter(filter)).try_init().map_err(|error| error.to_string())
}

/// Names of the metrics. The unit comes last, and counters end in `_total`.
pub mod metric {
    /// Counter of finished jobs by kind and final status. A cancelled job is counted by the process that cancelled it.
    pub const JOBS: &str = "plateau_jobs_total";
    /// Counter of failed jobs by kind and type of the error.
    pub const FAILURES: &str = "plateau_job_failures_total";
    /// Counter of results that the audit withheld, by kind.
    pub const AUDIT_FAILURES: &str = "plateau_audit_failures_total";
    /// Counter of submissions by kind and outcome (created, repeated, rejected, queue_full, failed).
    pub const SUBMISSIONS: &str = "plateau_submissions_total";
    /// Counter of requests with an unknown key.
    pub const AUTH_FAILURES: &str = "plateau_auth_failures_total";
    /// Counter of attempts to send a message to a callback URL, by outcome (delivered, failed, given_up, unwanted).
    pub const CALLBACKS: &str = "plateau_callbacks_total";
    /// Counter of files made from results.
    pub const CONVERSIONS: &str = "plateau_conversions_total";
    /// Histogram of the seconds from claim to finish, by kind.
    pub const SOLVE_SECONDS: &str = "plateau_solve_seconds";
    /// Histogram of the seconds from submission to claim, by kind.
    pub const WAIT_SECONDS: &str = "plateau_queue_wait_seconds";
    /// Gauge of the jobs that wait.
    pub const QUEUE_LENGTH: &str = "plateau_queue_length";
    /// Gauge of the jobs that run in this process.
    pub const RUNNING: &str = "plateau_jobs_running";
    /// Gauge of the solvers of this process that were given up because they did not answer. A solver that ends later is
    /// no longer counted.
    pub const UNRESPONSIVE: &str = "plateau_solvers_unresponsive";
    /// Gauge that is always 1. Its label holds the version of the program.
    pub const BUILD_INFO: &str = "plateau_build_info";
    /// Counter of HTTP requests by method, route and status.
    pub const HTTP_REQUESTS: &str = "plateau_http_requests_total";
    /// Histogram of the seconds until the head of the response is sent, by method and route.
    pub const HTTP_SECONDS: &str = "plateau_http_request_seconds";
}

/// Interval at which the recorder empties the lists of observations of its histograms.
const UPKEEP_INTERVAL: Duration = Duration::from_secs(5);

/// Keeps the recorder's histograms small while nobody asks for the metrics. Never returns.
pub async fn keep_up(handle: PrometheusHandle) {
    keep_up_every(UPKEEP_INTERVAL, handle).await;
}

async fn keep_up_every(interval: Duration, handle: PrometheusHandle) {
    loop {
        tokio::time::sleep(interval).await;
        handle.run_upkeep();
    }
}

/// Installs the recorder. Call it once per process. The returned handle renders the text that `GET /metrics` serves.
///
/// # Errors
/// Fails if a recorder is already installed.
pub fn init_metrics() -> Result<PrometheusHandle, String> {
    const BUCKETS: [f64; 16] =
        [0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 60.0, 600.0];
    let handle = PrometheusBuilder::new()
        .set_buckets_for_metric(Matcher::Suffix("_seconds".into()), &BUCKETS)
        .and_then(PrometheusBuilder::install_recorder)
        .map_err(|error| error.to_string())?;
    metrics::describe_counter!(metric::JOBS, "Finished jobs by kind and final status");
    metrics::describe_counter!(metric::FAILURES, "Failed jobs by kind and type of the error");
    metrics::describe_counter!(metric::AUDIT_FAILURES, "Results that the audit withheld, by kind");
    metrics::describe_counter!(metric::SUBMISSIONS, "Submissions by kind and outcome");
    metrics::describe_counter!(metric::AUTH_FAILURES, "Requests with an unknown key");
    metrics::describe_counter!(metric::CALLBACKS, "Attempts to send a message to a callback URL, by outcome");
    metrics::describe_counter!(metric::CONVERSIONS, "Files made from results");
    metrics::describe_histogram!(metric::SOLVE_SECONDS, "Seconds from claim to finish");
    metrics::describe_histogram!(metric::WAIT_SECONDS, "Seconds from submission to claim");
    metrics::describe_gauge!(metric::QUEUE_LENGTH, "Jobs that wait");
    metrics::describe_gauge!(metric::RUNNING, "Jobs that run in this process");
    metrics::describe_gauge!(metric::UNRESPONSIVE, "Solvers that were given up because they did not answer");
    metrics::describe_gauge!(metric::BUILD_INFO, "Version of the program as a label; the value is always 1");
    metrics::gauge!(metric::BUILD_INFO, "version" => env!("CARGO_PKG_VERSION")).set(1.0);
    metrics_process::Collector::default().describe();
    metrics::describe_counter!(metric::HTTP_REQUESTS, "HTTP requests by method, route and status");
    metrics::describe_histogram!(metric::HTTP_SECONDS, "Seconds to the head of the response");
    Ok(handle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn histograms_that_nobody_asks_for_stay_small() {
        const TURN: Duration = Duration::from_millis(1);
        const OBSERVATIONS: usize = 10_000;
        let recorder = PrometheusBuilder::new().set_buckets(&[1.0]).unwrap().build_recorder();
        let runtime = tokio::runtime::Builder::new_current_thread().enable_time().build().unwrap();
        let used = allocation_counter::measure(|| {
            runtime.spawn(keep_up_every(TURN, recorder.handle()));
            runtime.block_on(async {
                for _ in 0..100 {
                    metrics::with_local_recorder(&recorder, || {
                        let seconds = metrics::histogram!(metric::SOLVE_SECONDS);
                        (0..OBSERVATIONS).for_each(|_| seconds.record(0.5));
                    });
                    tokio::time::sleep(2 * TURN).await;
                }
            });
        });
        // A list of all observations would take eight megabytes, because each is a number of eight bytes.
        assert!(used.bytes_max < 2 << 20, "{} bytes", used.bytes_max);
    }
}
