//! The metrics of jobs that must exist before anything happens, and those of jobs that fail without a worker.

use crate::status::Status;
use crate::store::{Delivery, FailedJob};
use crate::telemetry::metric;
use crate::wire::job::JobFailure;
use plateau_engine::kind::Kind;
use plateau_engine::report::SolveError;

/// Sets the counters to 0, because an alert on a counter's increase needs its value before the first increase.
pub(crate) fn start_at_zero() {
    let kinds = || Kind::ALL.iter().map(|kind| kind.name());
    for kind in kinds() {
        metrics::counter!(metric::AUDIT_FAILURES, "kind" => kind).increment(0);
        for (failure, _) in JobFailure::ALL {
            metrics::counter!(metric::FAILURES, "kind" => kind, "type" => *failure).increment(0);
        }
    }
    for kind in kinds().chain(["batch"]) {
        for outcome in ["created", "repeated", "rejected", "queue_full", "failed"] {
            metrics::counter!(metric::SUBMISSIONS, "kind" => kind, "outcome" => outcome).increment(0);
        }
    }
    for (_, outcome) in Delivery::NAMES {
        metrics::counter!(metric::CALLBACKS, "outcome" => outcome).increment(0);
    }
    metrics::counter!(metric::AUTH_FAILURES).increment(0);
    metrics::counter!(metric::CONVERSIONS).increment(0);
    metrics::gauge!(metric::RUNNING).set(0.0);
    metrics::gauge!(metric::UNRESPONSIVE).set(0.0);
}

/// Logs and counts a job that has failed because its workers died or could not read it.
pub(crate) fn note_failed(job: &FailedJob) {
    let error: Option<SolveError> = serde_json::from_str(&job.error).ok();
    let (error_type, detail) = error.map_or_else(Default::default, |error| {
        (error.kind.rsplit('/').next().unwrap_or_default().to_owned(), error.detail)
    });
    let (kind, status) = (job.kind.clone(), Status::Failed.name());
    tracing::warn!(job_id = job.id, kind, status, error_type, detail, "ended without a worker");
    metrics::counter!(metric::FAILURES, "kind" => kind.clone(), "type" => error_type).increment(1);
    metrics::counter!(metric::JOBS, "kind" => kind, "status" => status).increment(1);
}
