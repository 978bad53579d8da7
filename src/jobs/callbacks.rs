//! Sends a message to the callback URL of each job or batch that has ended. The store names the callbacks that are due;
//! [`webhook`](crate::webhook) sends them.
//!
//! A message says what ended and with which status. It carries no result, because the client fetches that with its key.
//! Any number of processes may send callbacks at once.

use super::view::timestamp;
use super::{Jobs, JobsError};
use crate::config::WebhooksConfig;
use crate::store::{Attempted, Busy, Callback, CallbackRow, Delivery, Subject};
use crate::telemetry::metric;
use crate::webhook::{Message, Sender, Undelivered};
use crate::wire::callback::{self, Callbacks, Outcome};
use serde_json::json;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant, SystemTime};
use tokio::sync::Semaphore;

/// Interval at which the store is asked for callbacks that are due.
const POLL: Duration = Duration::from_millis(250);
/// Number of attempts that may run at once.
const MAX_CONCURRENT: usize = 16;
/// Number of attempts that may run at once for one owner, so that an owner whose receivers are slow leaves room for
/// others.
const MAX_OF_OWNER: usize = 8;
/// Number of attempts that may run at once to one host. If the last attempt to a host failed, only one may run.
const MAX_OF_HOST: usize = 4;
/// Upper bound of the pause between two attempts.
const MAX_PAUSE: Duration = Duration::from_secs(24 * 3600);
/// Upper bound of the time for which this process sends no message to a host whose last attempts failed.
const MAX_REST: Duration = Duration::from_secs(300);

/// Attempts that run in this process, and hosts that have failed.
#[derive(Debug, Default)]
struct Traffic {
    owners: HashMap<Option<String>, usize>,
    hosts: HashMap<String, Host>,
}

#[derive(Debug, Default)]
struct Host {
    under_way: usize,
    /// Number of failed attempts since the last successful one.
    failures: u32,
    rests_until: Option<Instant>,
}

impl Traffic {
    /// Returns the owners and hosts for which no further attempt may begin now.
    fn busy(&self, now: Instant) -> Busy {
        let owners = self.owners.iter().filter(|(_, count)| **count >= MAX_OF_OWNER).map(|(owner, _)| owner.clone());
        let hosts = self.hosts.iter().filter(|(_, host)| {
            let most = if host.failures > 0 { 1 } else { MAX_OF_HOST };
            host.under_way >= most || host.rests_until.is_some_and(|until| now < until)
        });
        Busy { owners: owners.collect(), hosts: hosts.map(|(name, _)| name.clone()).collect() }
    }

    fn begin(&mut self, callback: &Callback) {
        *self.owners.entry(callback.owner.clone()).or_default() += 1;
        self.hosts.entry(callback.host.clone()).or_default().under_way += 1;
    }

    /// Notes the end of an attempt. A host that failed rests for `retry`, and twice as long after each further failure.
    fn end(&mut self, callback: &Callback, succeeded: Option<bool>, retry: Duration, now: Instant) {
        if let Some(count) = self.owners.get_mut(&callback.owner) {
            *count -= 1;
        }
        self.owners.retain(|_, count| *count > 0);
        if let Some(host) = self.hosts.get_mut(&callback.host) {
            host.under_way -= 1;
            match succeeded {
                Some(true) => (host.failures, host.rests_until) = (0, None),
                Some(false) => {
                    let rest = retry.saturating_mul(2u32.saturating_pow(host.failures)).min(MAX_REST);
                    (host.failures, host.rests_until) = (host.failures.saturating_add(1), Some(now + rest));
                }
                None => {}
            }
        }
        // A host that has rested for a long time is forgotten.
        self.hosts.retain(|_, host| host.under_way > 0 || host.rests_until.is_some_and(|until| now < until + MAX_REST));
    }
}

/// Sends callbacks until a shutdown is asked for. Returns at once if webhooks are off.
pub async fn run(jobs: Jobs) {
    let Some(sender) = jobs.webhooks().cloned() else { return };
    let slots = Arc::new(Semaphore::new(MAX_CONCURRENT));
    let traffic = Arc::new(Mutex::new(Traffic::default()));
    // The lease is longer than the time limit of an attempt, so an attempt ends before another process can claim its
    // callback.
    let config = &jobs.config().webhooks;
    let (lease, retry) =
        (Duration::from_millis(config.timeout_ms) + Duration::from_secs(30), Duration::from_millis(config.retry_ms));
    while !jobs.is_shutting_down() {
        let Ok(slot) = slots.clone().acquire_owned().await else { return };
        let busy = locked(&traffic).busy(Instant::now());
        match jobs.store().claim_callback(lease, &busy).await {
            Ok(Some(callback)) => {
                locked(&traffic).begin(&callback);
                let (jobs, sender, traffic) = (jobs.clone(), sender.clone(), traffic.clone());
                tokio::spawn(async move {
                    let succeeded = attempt(&jobs, &sender, &callback).await;
                    locked(&traffic).end(&callback, succeeded, retry, Instant::now());
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

fn locked(traffic: &Mutex<Traffic>) -> MutexGuard<'_, Traffic> {
    // No thread panics while it holds the lock.
    traffic.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns the pause after attempt number `attempts`, or `None` if that attempt was the last.
fn pause(config: &WebhooksConfig, attempts: i64) -> Option<Duration> {
    let attempts = u32::try_from(attempts).unwrap_or(u32::MAX);
    let first = Duration::from_millis(config.retry_ms);
    let factor = 4u32.checked_pow(attempts.saturating_sub(1)).unwrap_or(u32::MAX);
    (attempts < config.attempts_max).then(|| first.saturating_mul(factor).min(MAX_PAUSE))
}

/// Sends a message and stores the outcome. Returns whether the receiver answered, or `None` if nothing was sent.
async fn attempt(jobs: &Jobs, sender: &Sender, callback: &Callback) -> Option<bool> {
    let store = &jobs.store();
    let (id, attempts) = (&callback.id, callback.attempts);
    let body = match body(jobs, callback).await {
        Ok(body) => body,
        // The job was removed meanwhile, or the store is unavailable. In the second case the callback is due again
        // later.
        Err(error) => {
            tracing::debug!(?error, id, "no callback");
            return None;
        }
    };
    let message = Message { id, owner: callback.owner.as_deref(), body: body.as_bytes() };
    let now_s = unix_time_s();
    let (delivery, settled) = match sender.send(&callback.url, message, now_s).await {
        Ok(()) => (Delivery::Delivered, store.settle_callback(callback, Delivery::Delivered).await),
        Err(Undelivered::Unwanted) => (Delivery::Unwanted, store.settle_callback(callback, Delivery::Unwanted).await),
        Err(Undelivered::Failed(reason)) => match pause(&jobs.config().webhooks, attempts) {
            Some(pause) => {
                tracing::info!(id, attempts, reason, next_s = pause.as_secs(), "a callback failed");
                (Delivery::Failed, store.put_off_callback(callback, pause).await)
            }
            None => {
                tracing::warn!(id, attempts, reason, "a callback is given up");
                (Delivery::GivenUp, store.settle_callback(callback, Delivery::GivenUp).await)
            }
        },
    };
    metrics::counter!(metric::CALLBACKS, "outcome" => delivery.name()).increment(1);
    if let Err(error) = settled {
        tracing::warn!(%error, id, "cannot store the outcome of a callback; it will be attempted again");
    }
    Some(matches!(delivery, Delivery::Delivered | Delivery::Unwanted))
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

/// Returns the callback of a job or batch in the form that clients see. It says whether an attempt succeeded but not
/// why it failed, because that would tell about hosts that only this server can reach.
pub(super) fn view(row: CallbackRow) -> Callbacks {
    let seen = |attempted: &Attempted| callback::Delivery {
        attempt: attempted.number.unsigned_abs(),
        at: timestamp(attempted.at_ms),
        outcome: match attempted.delivery {
            Delivery::Delivered => Outcome::Delivered,
            Delivery::Failed => Outcome::Failed,
            Delivery::GivenUp => Outcome::GivenUp,
            Delivery::Unwanted => Outcome::Unwanted,
        },
    };
    Callbacks {
        callback_url: row.url,
        next_attempt_at: row.next_ms.filter(|at_ms| *at_ms > 0).map(timestamp),
        pending: row.next_ms.is_some(),
        deliveries: row.attempted.iter().map(seen).collect(),
    }
}

/// Returns the seconds since 1970 by this process's clock.
fn unix_time_s() -> i64 {
    let since_1970 = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    i64::try_from(since_1970.as_secs()).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn callback(owner: &str, host: &str) -> Callback {
        Callback::to(Some(owner.into()), &format!("https://{host}/hook"))
    }

    #[test]
    fn one_owner_or_host_gets_a_share_of_the_attempts() {
        let (now, mut traffic) = (Instant::now(), Traffic::default());
        for number in 0..MAX_OF_OWNER {
            assert_eq!(traffic.busy(now).owners, []);
            traffic.begin(&callback("many", &format!("host{}", number % 3)));
        }
        assert_eq!(traffic.busy(now), Busy { owners: vec![Some("many".into())], hosts: Vec::new() });
        for _ in 0..MAX_OF_HOST {
            traffic.begin(&callback("one", "one.example"));
        }
        assert_eq!(traffic.busy(now).hosts, ["one.example"]);
        traffic.end(&callback("one", "one.example"), Some(true), POLL, now);
        assert_eq!(traffic.busy(now).hosts, [""; 0]);
    }

    #[test]
    fn a_host_that_fails_rests_longer_each_time_and_then_gets_one_attempt() {
        let (start, mut traffic) = (Instant::now(), Traffic::default());
        let (retry, dead) = (Duration::from_secs(5), callback("me", "dead.example"));
        let is_busy = |traffic: &Traffic, s: u64| !traffic.busy(start + Duration::from_secs(s)).hosts.is_empty();
        for (begun_s, rest_s) in [(0, 5), (5, 10), (15, 20)] {
            assert!(!is_busy(&traffic, begun_s));
            traffic.begin(&dead);
            traffic.end(&dead, Some(false), retry, start + Duration::from_secs(begun_s));
            assert!(is_busy(&traffic, begun_s + rest_s - 1) && !is_busy(&traffic, begun_s + rest_s));
        }
        traffic.begin(&dead);
        assert!(is_busy(&traffic, 100), "one attempt at a time");
        traffic.end(&dead, Some(true), retry, start + Duration::from_secs(100));
        traffic.begin(&dead);
        assert!(!is_busy(&traffic, 100), "the host has answered");
    }

    #[test]
    fn pauses_grow_up_to_a_day_and_end() {
        let config = WebhooksConfig { retry_ms: 5000, attempts_max: 10, ..WebhooksConfig::default() };
        let pauses: Vec<Option<u64>> = (1..=10).map(|n| pause(&config, n).map(|pause| pause.as_secs())).collect();
        let expected = [5, 20, 80, 320, 1280, 5120, 20_480, 81_920, 86_400].map(Some);
        assert_eq!((&pauses[..9], pauses[9]), (&expected[..], None));
        assert_eq!(pause(&WebhooksConfig { attempts_max: u32::MAX, ..config }, i64::MAX), None);
    }
}
