//! Sends a message to the callback URL of each job or batch that has ended. The store names the callbacks that are due;
//! [`webhook`](crate::webhook) sends them.
//!
//! A message says what ended and with which status. It carries no result, because the client fetches that with its key.
//! Any number of processes may send callbacks at once.

use super::{Jobs, JobsError};
use crate::config::WebhooksConfig;
use crate::store::{Callback, Subject};
use crate::telemetry::metric;
use crate::webhook::{Message, Sender, Undelivered};
use serde_json::json;
use std::sync::Arc;
use std::time::{Duration, SystemTime};
use tokio::sync::Semaphore;

/// Interval between two looks for callbacks that are due.
const POLL: Duration = Duration::from_secs(1);
/// Number of attempts that may run at once.
const MAX_CONCURRENT: usize = 8;
/// Upper bound of the pause between two attempts.
const MAX_PAUSE: Duration = Duration::from_secs(24 * 3600);

/// Sends callbacks until a shutdown is asked for. Returns at once if webhooks are off.
pub async fn run(jobs: Jobs) {
    let Some(sender) = jobs.webhooks().cloned() else { return };
    let slots = Arc::new(Semaphore::new(MAX_CONCURRENT));
    // The lease is longer than the time limit of an attempt, so an attempt ends before another process can claim its
    // callback.
    let lease = Duration::from_millis(jobs.config().webhooks.timeout_ms) + Duration::from_secs(30);
    while !jobs.is_shutting_down() {
        let Ok(slot) = slots.clone().acquire_owned().await else { return };
        match jobs.store().claim_callback(lease).await {
            Ok(Some(callback)) => {
                let (jobs, sender) = (jobs.clone(), sender.clone());
                tokio::spawn(async move {
                    attempt(&jobs, &sender, &callback).await;
                    drop(slot);
                });
                continue;
            }
            Ok(None) => {}
            Err(error) => tracing::warn!(%error, "cannot look for callbacks"),
        }
        drop(slot);
        tokio::select! {
            () = tokio::time::sleep(POLL) => {}
            () = jobs.shutdown() => {}
        }
    }
}

/// Returns the pause after attempt number `attempts`, or `None` if that attempt was the last.
fn pause(config: &WebhooksConfig, attempts: i64) -> Option<Duration> {
    let attempts = u32::try_from(attempts).unwrap_or(u32::MAX);
    let first = Duration::from_millis(config.retry_ms);
    let factor = 4u32.checked_pow(attempts.saturating_sub(1)).unwrap_or(u32::MAX);
    (attempts < config.attempts_max).then(|| first.saturating_mul(factor).min(MAX_PAUSE))
}

async fn attempt(jobs: &Jobs, sender: &Sender, callback: &Callback) {
    let store = &jobs.store();
    let (id, attempts) = (&callback.id, callback.attempts);
    let body = match body(jobs, callback).await {
        Ok(body) => body,
        // The job was removed meanwhile, or the store is unavailable. In the second case the callback is due again
        // later.
        Err(error) => {
            tracing::debug!(?error, id, "no callback");
            return;
        }
    };
    let message = Message { id, owner: callback.owner.as_deref(), body: body.as_bytes() };
    let now_s = unix_time_s();
    let (outcome, settled) = match sender.send(&callback.url, message, now_s).await {
        Ok(()) => ("delivered", store.settle_callback(callback).await),
        Err(Undelivered::Unwanted) => ("unwanted", store.settle_callback(callback).await),
        Err(Undelivered::Failed(reason)) => match pause(&jobs.config().webhooks, attempts) {
            Some(pause) => {
                tracing::info!(id, attempts, reason, next_s = pause.as_secs(), "a callback failed");
                ("failed", store.put_off_callback(callback, pause).await)
            }
            None => {
                tracing::warn!(id, attempts, reason, "a callback is given up");
                ("given_up", store.settle_callback(callback).await)
            }
        },
    };
    metrics::counter!(metric::CALLBACKS, "outcome" => outcome).increment(1);
    if let Err(error) = settled {
        tracing::warn!(%error, id, "cannot store the outcome of a callback; it will be attempted again");
    }
}

/// Returns the message with the fields of Standard Webhooks: `type`, `timestamp` (when the job or batch ended) and
/// `data`.
async fn body(jobs: &Jobs, callback: &Callback) -> Result<String, JobsError> {
    let owner = callback.owner.as_deref();
    let message = match callback.subject {
        Subject::Job => {
            let job = jobs.get(&callback.id, owner).await?;
            json!({ "type": format!("job.{}", job.status.name()), "timestamp": job.finished_at,
                "data": { "id": job.id, "kind": job.kind, "status": job.status, "links": job.links } })
        }
        Subject::Batch => {
            let batch = jobs.batch(&callback.id, owner).await?;
            json!({ "type": format!("batch.{}", batch.status.name()), "timestamp": batch.finished_at,
                "data": { "id": batch.id, "status": batch.status, "counts": batch.counts, "links": batch.links } })
        }
    };
    Ok(message.to_string())
}

/// Returns the seconds since 1970 by this process's clock.
fn unix_time_s() -> i64 {
    let since_1970 = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    i64::try_from(since_1970.as_secs()).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pauses_grow_up_to_a_day_and_end() {
        let config = WebhooksConfig { retry_ms: 5000, attempts_max: 10, ..WebhooksConfig::default() };
        let pauses: Vec<Option<u64>> = (1..=10).map(|n| pause(&config, n).map(|pause| pause.as_secs())).collect();
        let expected = [5, 20, 80, 320, 1280, 5120, 20_480, 81_920, 86_400].map(Some);
        assert_eq!((&pauses[..9], pauses[9]), (&expected[..], None));
        assert_eq!(pause(&WebhooksConfig { attempts_max: u32::MAX, ..config }, i64::MAX), None);
    }
}
