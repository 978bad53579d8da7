//! Logs on standard error and metrics for Prometheus.

use crate::config::{LogConfig, LogFormat};
use metrics_exporter_prometheus::{Matcher, PrometheusBuilder, PrometheusHandle};
use std::io::IsTerminal;
use tracing_subscriber::filter::Targets;
use tracing_subscriber::layer::{Layer, SubscriberExt};
use tracing_subscriber::util::SubscriberInitExt;

/// Reads the levels of the parts of the program.
///
/// # Errors
/// Fails if the text is no list of levels.
pub fn filter(config: &LogConfig) -> Result<Targets, String> {
    config.level.parse().map_err(|error| format!("log.level: {error}"))
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
    /// Counter of submissions by kind and outcome (created, repeated, rejected, queue_full).
    pub const SUBMISSIONS: &str = "plateau_submissions_total";
    /// Counter of attempts to send a message to a callback URL, by outcome (delivered, failed, given_up, unwanted).
    pub const CALLBACKS: &str = "plateau_callbacks_total";
    /// Counter of files made from results.
    pub const CONVERSIONS: &str = "plateau_conversions_total";
    /// Histogram of the seconds from claim to finish, by kind and objective.
    pub const SOLVE_SECONDS: &str = "plateau_solve_seconds";
    /// Histogram of the seconds from submission to claim, by kind.
    pub const WAIT_SECONDS: &str = "plateau_queue_wait_seconds";
    /// Gauge of the jobs that wait.
    pub const QUEUE_LENGTH: &str = "plateau_queue_length";
    /// Gauge of the jobs that run in this process.
    pub const RUNNING: &str = "plateau_jobs_running";
    /// Gauge that is always 1. Its label holds the version of the program.
    pub const BUILD_INFO: &str = "plateau_build_info";
    /// Counter of HTTP requests by method, route and status.
    pub const HTTP_REQUESTS: &str = "plateau_http_requests_total";
    /// Histogram of the seconds until the head of the response is sent, by method and route.
    pub const HTTP_SECONDS: &str = "plateau_http_request_seconds";
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
    metrics::describe_counter!(metric::SUBMISSIONS, "Submissions by kind and outcome");
    metrics::describe_counter!(metric::CALLBACKS, "Attempts to send a message to a callback URL, by outcome");
    metrics::describe_counter!(metric::CONVERSIONS, "Files made from results");
    metrics::describe_histogram!(metric::SOLVE_SECONDS, "Seconds from claim to finish");
    metrics::describe_histogram!(metric::WAIT_SECONDS, "Seconds from submission to claim");
    metrics::describe_gauge!(metric::QUEUE_LENGTH, "Jobs that wait");
    metrics::describe_gauge!(metric::RUNNING, "Jobs that run in this process");
    metrics::describe_gauge!(metric::BUILD_INFO, "Version of the program as a label; the value is always 1");
    metrics::gauge!(metric::BUILD_INFO, "version" => env!("CARGO_PKG_VERSION")).set(1.0);
    process::describe();
    metrics::describe_counter!(metric::HTTP_REQUESTS, "HTTP requests by method, route and status");
    metrics::describe_histogram!(metric::HTTP_SECONDS, "Seconds to the head of the response");
    Ok(handle)
}

/// Figures of this process, under the names that Prometheus uses in every program. They are read from procfs, so they
/// exist only on Linux.
pub mod process {
    use std::fs;

    const CPU_SECONDS: &str = "process_cpu_seconds_total";
    const RESIDENT_BYTES: &str = "process_resident_memory_bytes";
    const VIRTUAL_BYTES: &str = "process_virtual_memory_bytes";
    const OPEN_FILES: &str = "process_open_fds";
    const MAX_FILES: &str = "process_max_fds";
    const THREADS: &str = "process_threads";
    const STARTED: &str = "process_start_time_seconds";

    /// Clock ticks per second in `/proc`. The number is 100 on every Linux architecture that Rust supports.
    const TICKS_PER_SECOND: f64 = 100.0;

    pub(super) fn describe() {
        metrics::describe_gauge!(CPU_SECONDS, "Processor time of this process in seconds");
        metrics::describe_gauge!(RESIDENT_BYTES, "Resident memory of this process");
        metrics::describe_gauge!(VIRTUAL_BYTES, "Virtual memory of this process");
        metrics::describe_gauge!(OPEN_FILES, "Open file descriptors of this process");
        metrics::describe_gauge!(MAX_FILES, "Limit of open file descriptors");
        metrics::describe_gauge!(THREADS, "Threads of this process");
        metrics::describe_gauge!(STARTED, "Start of this process in seconds since 1970");
    }

    /// Updates the figures. A figure that cannot be read keeps its last value.
    pub fn measure() {
        if let Some(figures) = fs::read_to_string("/proc/self/stat").ok().and_then(|stat| Stat::read(&stat)) {
            // A gauge is used because the recorder's counters hold only whole numbers.
            metrics::gauge!(CPU_SECONDS).set(figures.cpu_ticks / TICKS_PER_SECOND);
            metrics::gauge!(THREADS).set(figures.threads);
            metrics::gauge!(VIRTUAL_BYTES).set(figures.virtual_bytes);
            if let Some(booted_s) = booted_s() {
                metrics::gauge!(STARTED).set(booted_s + figures.start_ticks / TICKS_PER_SECOND);
            }
        }
        if let Some(bytes) = field("/proc/self/status", "VmRSS:") {
            // Linux gives this figure in kibibytes.
            metrics::gauge!(RESIDENT_BYTES).set(bytes * 1024.0);
        }
        if let Ok(files) = fs::read_dir("/proc/self/fd") {
            // One entry is the folder's own descriptor, which is open only while it is read.
            metrics::gauge!(OPEN_FILES).set(files.count().saturating_sub(1) as f64);
        }
        if let Some(maximum) = field("/proc/self/limits", "Max open files") {
            metrics::gauge!(MAX_FILES).set(maximum);
        }
    }

    struct Stat {
        cpu_ticks: f64,
        threads: f64,
        start_ticks: f64,
        virtual_bytes: f64,
    }

    impl Stat {
        /// Parses the fields after the program's name. The name is in parentheses and may contain blanks.
        fn read(stat: &str) -> Option<Self> {
            let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
            // The first field after the name is number 3 in proc_pid_stat(5).
            let field = |number: usize| fields.get(number - 3)?.parse::<f64>().ok();
            Some(Self {
                cpu_ticks: field(14)? + field(15)?,
                threads: field(20)?,
                start_ticks: field(22)?,
                virtual_bytes: field(23)?,
            })
        }
    }

    fn booted_s() -> Option<f64> {
        field("/proc/stat", "btime")
    }

    /// Returns the first number on the line that begins with `name`.
    fn field(path: &str, name: &str) -> Option<f64> {
        let text = fs::read_to_string(path).ok()?;
        let line = text.lines().find_map(|line| line.strip_prefix(name))?;
        line.split_whitespace().next()?.parse().ok()
    }

    #[cfg(test)]
    mod tests {
        use super::Stat;

        #[test]
        fn a_program_name_with_blanks_and_parentheses_does_not_shift_the_fields() {
            let stat = "7 (a b) c) S 1 7 7 0 -1 4194560 9 0 0 0 120 30 0 0 20 0 5 0 777 1048576 256";
            let Stat { cpu_ticks, threads, start_ticks, virtual_bytes } = Stat::read(stat).unwrap();
            assert_eq!((cpu_ticks, threads, start_ticks, virtual_bytes), (150.0, 5.0, 777.0, 1_048_576.0));
            assert!(Stat::read("7 (a").is_none());
        }
    }
}
