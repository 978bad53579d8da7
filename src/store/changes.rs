//! Notifications of changes: wake-ups for workers, and one shared view of each watched job.
//!
//! A thousand watchers of one job cost one read per change, because they share a task that reads the row and a channel
//! that distributes it. Changes of this process arrive at once. On PostgreSQL, changes of other instances arrive by
//! LISTEN/NOTIFY. NOTIFY takes a lock that serialises commits, so it is sent apart from the writes and collects the
//! changes of `NOTIFY_INTERVAL`. A notification can be lost if a connection breaks or a writer dies before it sends it,
//! so every watched job is also read at each poll interval.

use std::collections::{BTreeSet, HashMap};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::sync::{Notify, mpsc, watch};
use tokio::task::JoinHandle;

use super::Result;
use super::engine::Engine;
use super::jobs::JobRow;
use super::postgres::Database as Postgres;
use super::tx::AfterCommit;

const NOTIFY_INTERVAL: Duration = Duration::from_millis(20);
/// Upper bound of a payload's size in bytes, because PostgreSQL accepts only payloads below 8000 bytes.
const PAYLOAD_BYTES: usize = 7900;
/// Line in a payload that means "a job may have become claimable".
const WORK: &str = "*";

#[derive(Debug)]
pub(super) struct Changes {
    pub(super) hub: Arc<Hub>,
    pub(super) poll_interval: Duration,
    /// Connection to the other instances. `None` on SQLite.
    instances: Option<Instances>,
}

#[derive(Debug)]
struct Instances {
    /// Identifiers of changed jobs to send to other instances.
    outgoing: mpsc::UnboundedSender<String>,
    notifier: JoinHandle<()>,
    /// Dropping this sender ends the listening thread.
    _listening: Sender<()>,
}

impl Drop for Instances {
    fn drop(&mut self) {
        self.notifier.abort();
    }
}

/// The watched jobs of this process, and the signal to its workers.
#[derive(Debug)]
pub(super) struct Hub {
    work: watch::Sender<u64>,
    jobs: Mutex<HashMap<String, Arc<Watched>>>,
}

#[derive(Debug)]
pub(super) struct Watched {
    pub(super) changed: Notify,
    pub(super) latest: watch::Sender<Option<Arc<JobRow>>>,
}

impl Hub {
    pub(super) fn jobs(&self) -> MutexGuard<'_, HashMap<String, Arc<Watched>>> {
        // No thread panics while it holds the lock, and the map is never half changed.
        self.jobs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn changed(&self, id: &str) {
        if id == WORK {
            self.work.send_modify(|count| *count += 1);
        } else if let Some(watched) = self.jobs().get(id) {
            watched.changed.notify_one();
        }
    }

    fn everything_may_have_changed(&self) {
        self.changed(WORK);
        for watched in self.jobs().values() {
            watched.changed.notify_one();
        }
    }
}

impl Changes {
    pub(super) fn new(engine: &Engine, poll_interval: Duration) -> Result<Self> {
        let hub = Arc::new(Hub { work: watch::Sender::new(0), jobs: Mutex::default() });
        let instances = match engine {
            Engine::Sqlite(_) => None,
            Engine::Postgres(database) => {
                let (outgoing, changes) = mpsc::unbounded_channel();
                let (listening, stopped) = channel();
                let hub = Arc::clone(&hub);
                database.listen(stopped, move |payload| match payload {
                    Some(ids) => ids.lines().for_each(|id| hub.changed(id)),
                    None => hub.everything_may_have_changed(),
                })?;
                let notifier = tokio::spawn(notify(Arc::clone(database), changes));
                Some(Instances { outgoing, notifier, _listening: listening })
            }
        };
        Ok(Self { hub, poll_interval, instances })
    }

    /// Notifies watchers and workers of this instance and of all others.
    pub(super) fn publish(&self, after_commit: &AfterCommit) {
        for id in after_commit.jobs.iter().map(String::as_str).chain(after_commit.work.then_some(WORK)) {
            self.hub.changed(id);
            if let Some(instances) = &self.instances {
                // Sending fails only while the store is being closed.
                let _ = instances.outgoing.send(id.to_owned());
            }
        }
    }

    pub(super) fn work_signal(&self) -> watch::Receiver<u64> {
        self.hub.work.subscribe()
    }
}

/// Sends changes of this instance to the others, at most once per `NOTIFY_INTERVAL`.
async fn notify(database: Arc<Postgres>, mut changes: mpsc::UnboundedReceiver<String>) {
    let mut batch = Vec::new();
    while changes.recv_many(&mut batch, usize::MAX).await > 0 {
        let ids: BTreeSet<String> = batch.drain(..).collect();
        let mut payloads = vec![String::new()];
        for id in ids {
            if payloads.last().is_none_or(|payload| payload.len() + id.len() >= PAYLOAD_BYTES) {
                payloads.push(String::new());
            }
            if let Some(payload) = payloads.last_mut() {
                payload.push_str(&id);
                payload.push('\n');
            }
        }
        for payload in payloads {
            if let Err(error) = database.notify(payload).await {
                tracing::warn!(%error, "cannot notify other instances of changes; they will find them by polling");
            }
        }
        tokio::time::sleep(NOTIFY_INTERVAL).await;
    }
}
