//! Converts rows of the store into the form that clients see.

use super::JobsError;
use crate::status::Status;
use crate::store::{BatchRow, JobRow};
use crate::wire::batch::{Batch, BatchCounts, BatchJob, BatchLinks};
use crate::wire::job::{ExtraFiles, Job, JobKind, JobSummary, Links, Related};
use plateau_engine::report::{Progress, SolveError, Warning};
use serde::de::{DeserializeOwned, IgnoredAny};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::value::RawValue;
use std::time::{Duration, SystemTime};

/// Returns a job. `base` is the path that a proxy puts before the paths of this server.
pub(super) fn job(base: &str, row: &JobRow) -> Result<Job, JobsError> {
    let unreadable = |what: &str| JobsError::Internal(format!("the stored job's {what} cannot be read"));
    let status = row.status;
    let statistics = row.statistics.as_deref();
    let summary = row.summary.as_deref().or(statistics);
    let figures: Option<Figures> = read(summary).map_err(|()| unreadable("summary"))?;
    let progress: Option<Progress> = read(row.progress.as_deref()).map_err(|()| unreadable("progress"))?;
    let warnings: Vec<Warning> = read(Some(&row.warnings)).map_err(|()| unreadable("warnings"))?.unwrap_or_default();
    let metadata = read(row.metadata.as_deref()).map_err(|()| unreadable("metadata"))?;
    let mut error: Option<SolveError> = read(row.error.as_deref()).map_err(|()| unreadable("error"))?;
    if let Some(error) = &mut error {
        error.kind.insert_str(0, base);
    }
    let (progress, files) = match (status, figures) {
        (Status::Succeeded, Some(figures)) => (figures.progress(), figures.files()),
        _ => {
            let waiting = || Progress { phase: status.name().into(), ..Progress::default() };
            (progress.unwrap_or_else(waiting), ExtraFiles::default())
        }
    };
    let related =
        Related { files, request: row.has_request, batch: row.batch.as_deref(), successor: row.successor.as_deref() };
    Ok(Job {
        links: Links::of(base, &row.id, status, related),
        id: row.id.clone(),
        kind: JobKind::from_name(&row.kind),
        status,
        cancelled_because: row.cancelled_because,
        label: row.label.clone(),
        metadata,
        created_at: timestamp(row.created_at_ms),
        started_at: row.started_at_ms.map(timestamp),
        finished_at: row.finished_at_ms.map(timestamp),
        expires_at: row.expires_at_ms.map(timestamp),
        progress,
        statistics: statistics
            .map(|text| RawValue::from_string(text.to_owned()).map_err(|_| unreadable("statistics")))
            .transpose()?,
        warnings,
        error,
    })
}

/// Figures from the statistics of any kind that also appear in the final progress, tell which files the job has, or
/// give the size of its mesh. They are stored apart as the job's summary, in which `flat_pattern` and `certificate` are
/// true or absent.
#[derive(Debug, Deserialize, Serialize)]
pub(super) struct Figures {
    iterations: Option<u64>,
    objective_value: Option<f64>,
    residual: Option<f64>,
    pub(super) triangles: Option<u64>,
    #[serde(default, skip_serializing_if = "Option::is_none", serialize_with = "present")]
    flat_pattern: Option<IgnoredAny>,
    #[serde(default, skip_serializing_if = "Option::is_none", serialize_with = "present")]
    certificate: Option<IgnoredAny>,
}

fn present<S: Serializer>(_: &Option<IgnoredAny>, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_bool(true)
}

/// Returns the summary of statistics.
pub(super) fn summary_of(statistics: &str) -> String {
    // Neither step can fail, because the statistics were just written by this process, and the figures are numbers and
    // booleans.
    let figures: Option<Figures> = serde_json::from_str(statistics).ok();
    figures.and_then(|figures| serde_json::to_string(&figures).ok()).unwrap_or_else(|| "{}".into())
}

impl Figures {
    fn files(&self) -> ExtraFiles {
        ExtraFiles { pattern: self.flat_pattern.is_some(), certificate: self.certificate.is_some() }
    }

    /// Returns the progress of a finished job.
    fn progress(&self) -> Progress {
        Progress {
            fraction: 1.0,
            phase: "finished".into(),
            iteration: self.iterations.unwrap_or(0),
            objective_value: self.objective_value,
            residual: self.residual,
        }
    }
}

pub(super) fn read<T: DeserializeOwned>(text: Option<&str>) -> Result<Option<T>, ()> {
    text.map(|text| serde_json::from_str(text).map_err(|_| ())).transpose()
}

/// Formats milliseconds since 1970 as RFC 3339 in UTC. Times outside the years 1970 to 9999 become the nearest time
/// inside.
pub(super) fn timestamp(at_ms: i64) -> String {
    const LAST_MS: u64 = 253_402_300_799_999;
    let since_1970 = Duration::from_millis(u64::try_from(at_ms).unwrap_or(0).min(LAST_MS));
    humantime::format_rfc3339_millis(SystemTime::UNIX_EPOCH + since_1970).to_string()
}

/// Returns a job of a list. If this version cannot read the row, logs it and returns `None`.
pub(super) fn listed(base: &str, row: &JobRow) -> Option<JobSummary> {
    match job(base, row) {
        Ok(mut job) => {
            let statistics = job.statistics.take();
            Some(JobSummary { statistics, ..job.into() })
        }
        Err(error) => {
            tracing::error!(?error, id = row.id, "a stored job cannot be shown");
            None
        }
    }
}

pub(super) fn counts(row: &BatchRow) -> BatchCounts {
    BatchCounts::of(row.jobs.iter().map(|job| job.status))
}

pub(super) fn batch(base: &str, row: &BatchRow) -> Batch {
    let jobs = row.jobs.iter().map(|job| {
        let related = Related { request: job.has_request, batch: Some(&row.id), ..Related::default() };
        BatchJob {
            index: job.index.unsigned_abs(),
            id: job.id.clone(),
            kind: JobKind::from_name(&job.kind),
            status: job.status,
            links: Links::of(base, &job.id, job.status, related),
        }
    });
    let counts = counts(row);
    let finished_at_ms = row.jobs.iter().map(|job| job.finished_at_ms).max().flatten();
    Batch {
        id: row.id.clone(),
        status: counts.status(),
        created_at: timestamp(row.created_at_ms),
        finished_at: finished_at_ms.filter(|_| counts.status().is_final()).map(timestamp),
        counts,
        jobs: jobs.collect(),
        links: BatchLinks::of(base, &row.id, &counts),
    }
}

#[cfg(test)]
mod tests {
    use super::{Figures, summary_of, timestamp};

    #[test]
    fn a_summary_says_the_same_as_its_statistics() {
        let statistics = r#"{"area":2.5,"iterations":7,"residual":1e-9,"triangles":300,"flat_pattern":{"long":[1,2]}}"#;
        let summary = summary_of(statistics);
        assert_eq!(
            summary,
            r#"{"iterations":7,"objective_value":null,"residual":1e-9,"triangles":300,"flat_pattern":true}"#
        );
        let [from_statistics, from_summary]: [Figures; 2] =
            [statistics, &summary].map(|text| serde_json::from_str(text).unwrap());
        assert_eq!(from_statistics.files(), from_summary.files());
        assert_eq!(from_statistics.progress(), from_summary.progress());
        assert!(from_summary.files().pattern && !from_summary.files().certificate);
    }

    #[test]
    fn timestamps_are_rfc_3339_in_utc_and_stay_within_four_digits_of_year() {
        assert_eq!(timestamp(1_700_000_000_123), "2023-11-14T22:13:20.123Z");
        assert_eq!(timestamp(0), "1970-01-01T00:00:00.000Z");
        assert_eq!(timestamp(-1), "1970-01-01T00:00:00.000Z");
        assert_eq!(timestamp(i64::MAX), "9999-12-31T23:59:59.999Z");
    }
}
