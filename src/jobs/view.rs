//! Converts rows of the store into the form that clients see.

use super::JobsError;
use crate::status::Status;
use crate::store::{BatchRow, JobRow};
use crate::wire::Kind;
use crate::wire::batch::{Batch, BatchCounts, BatchJob, BatchLinks};
use crate::wire::job::{Files, Job, JobError, JobSummary, JobWarning, Links, Progress};
use serde::Deserialize;
use serde::de::{DeserializeOwned, IgnoredAny};
use serde_json::value::RawValue;
use std::time::{Duration, SystemTime};

/// Returns a job. `base` is the path that a proxy puts before the paths of this server.
pub(super) fn job(base: &str, row: &JobRow) -> Result<Job, JobsError> {
    let unreadable = |what: &str| JobsError::Internal(format!("the stored job's {what} cannot be read"));
    let kind = Kind::from_name(&row.kind).ok_or_else(|| unreadable("kind"))?;
    let status = row.status;
    let statistics = row.statistics.as_deref();
    let figures: Option<Figures> = read(statistics).map_err(|()| unreadable("statistics"))?;
    let progress: Option<Progress> = read(row.progress.as_deref()).map_err(|()| unreadable("progress"))?;
    let warnings: Vec<JobWarning> = read(Some(&row.warnings)).map_err(|()| unreadable("warnings"))?.unwrap_or_default();
    let metadata = read(row.metadata.as_deref()).map_err(|()| unreadable("metadata"))?;
    let mut error: Option<JobError> = read(row.error.as_deref()).map_err(|()| unreadable("error"))?;
    if let Some(error) = &mut error {
        error.kind.insert_str(0, base);
    }
    let (progress, files) = match (status, figures) {
        (Status::Succeeded, Some(figures)) => (figures.progress(), figures.files()),
        _ => {
            let waiting = || Progress { phase: status.name().into(), ..Progress::default() };
            (progress.unwrap_or_else(waiting), Files::default())
        }
    };
    Ok(Job {
        links: Links::of(base, &row.id, status, files),
        id: row.id.clone(),
        kind,
        status,
        label: row.label.clone(),
        metadata,
        created_at: timestamp(row.created_at_ms),
        started_at: row.started_at_ms.map(timestamp),
        finished_at: row.finished_at_ms.map(timestamp),
        expires_at: row.expires_at_ms.map(timestamp),
        progress,
        // Parsing cannot fail, because the same text was parsed above.
        statistics: statistics.and_then(|text| RawValue::from_string(text.to_owned()).ok()),
        warnings,
        error,
    })
}

/// Figures from the statistics of any kind that also appear in the final progress or tell which files the job has.
#[derive(Debug, Deserialize)]
struct Figures {
    iterations: Option<u64>,
    objective_value: Option<f64>,
    residual: Option<f64>,
    flat_pattern: Option<IgnoredAny>,
    certificate: Option<IgnoredAny>,
}

impl Figures {
    fn files(&self) -> Files {
        Files { pattern: self.flat_pattern.is_some(), certificate: self.certificate.is_some() }
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
fn timestamp(at_ms: i64) -> String {
    const LAST_MS: u64 = 253_402_300_799_999;
    let since_1970 = Duration::from_millis(u64::try_from(at_ms).unwrap_or(0).min(LAST_MS));
    humantime::format_rfc3339_millis(SystemTime::UNIX_EPOCH + since_1970).to_string()
}

/// Returns a job of a list, with or without its statistics. If this version cannot read the row, logs it and returns `None`.
pub(super) fn summary(base: &str, row: &JobRow, with_statistics: bool) -> Option<JobSummary> {
    match job(base, row) {
        Ok(mut job) => {
            let statistics = job.statistics.take().filter(|_| with_statistics);
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

pub(super) fn batch(base: &str, row: &BatchRow) -> Result<Batch, JobsError> {
    let jobs = row.jobs.iter().map(|job| {
        let kind = Kind::from_name(&job.kind).ok_or_else(|| JobsError::Internal("an unknown kind of job".into()))?;
        Ok(BatchJob {
            index: job.index.unsigned_abs(),
            id: job.id.clone(),
            kind,
            status: job.status,
            links: Links::of(base, &job.id, job.status, Files::default()),
        })
    });
    let counts = counts(row);
    let finished_at_ms = row.jobs.iter().map(|job| job.finished_at_ms).max().flatten();
    Ok(Batch {
        id: row.id.clone(),
        status: counts.status(),
        created_at: timestamp(row.created_at_ms),
        finished_at: finished_at_ms.filter(|_| counts.status().is_final()).map(timestamp),
        counts,
        jobs: jobs.collect::<Result<_, JobsError>>()?,
        links: BatchLinks::of(base, &row.id, &counts),
    })
}

#[cfg(test)]
mod tests {
    use super::timestamp;

    #[test]
    fn timestamps_are_rfc_3339_in_utc_and_stay_within_four_digits_of_year() {
        assert_eq!(timestamp(1_700_000_000_123), "2023-11-14T22:13:20.123Z");
        assert_eq!(timestamp(0), "1970-01-01T00:00:00.000Z");
        assert_eq!(timestamp(-1), "1970-01-01T00:00:00.000Z");
        assert_eq!(timestamp(i64::MAX), "9999-12-31T23:59:59.999Z");
    }
}
