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

use super::jobs::{JobRow, Lookup};
use super::postgres::Database as Postgres;
use super::tx::AfterCommit;
use super::{Engine, Result, Store, StoreError};

const NOTIFY_INTERVAL: Duration = Duration::from_millis(20);
/// Upper bound of a payload's size. PostgreSQL takes payloads below 8000 bytes.
const PAYLOAD_BYTES: usize = 7900;
/// Line in a payload that means "a job may have become claimable".
const WORK: &str = "*";

#[derive(Debug)]
pub(super) struct Changes {
    hub: Arc<Hub>,
    poll_interval: Duration,
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
struct Hub {
    work: watch::Sender<u64>,
    jobs: Mutex<HashMap<String, Arc<Watched>>>,
}

#[derive(Debug)]
struct Watched {
    changed: Notify,
    latest: watch::Sender<Option<Arc<JobRow>>>,
}

impl Hub {
    fn jobs(&self) -> MutexGuard<'_, HashMap<String, Arc<Watched>>> {
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

/// A shared view of one job. The job is read again for as long as a view of it exists.
#[derive(Debug)]
pub struct JobWatch {
    latest: watch::Receiver<Option<Arc<JobRow>>>,
}

impl JobWatch {
    /// Returns the job as last read, or `None` if it has been deleted or has expired.
    pub fn current(&mut self) -> Option<Arc<JobRow>> {
        self.latest.borrow_and_update().clone()
    }

    /// Waits until the job differs from the last result of `current`. After the store was closed it waits for ever, so
    /// callers need a time limit.
    pub async fn changed(&mut self) {
        if self.latest.changed().await.is_err() {
            std::future::pending::<()>().await;
        }
    }

    /// Waits until the job has ended and returns it, or `None` if it was deleted or has expired.
    pub async fn ended(&mut self) -> Option<Arc<JobRow>> {
        loop {
            match self.current() {
                Some(job) if !job.status.is_final() => self.changed().await,
                other => return other,
            }
        }
    }
}

impl Store {
    /// Watches a job of `owner`, or any job if `owner` is `None`. The watch starts with the current state of the job.
    pub async fn watch(&self, id: &str, owner: Option<&str>) -> Result<std::result::Result<JobWatch, Lookup>> {
        let latest = self.subscribe(id).await?;
        let visible = match (&*latest.borrow(), owner) {
            (Some(job), Some(owner)) => job.owner.as_deref() == Some(owner),
            (Some(_), None) => true,
            (None, _) => false,
        };
        if visible { Ok(Ok(JobWatch { latest })) } else { self.get(id, owner).await.map(Err) }
    }

    /// Returns the channel on which the task of this job distributes the row. Starts the task if there is none.
    async fn subscribe(&self, id: &str) -> Result<watch::Receiver<Option<Arc<JobRow>>>> {
        let hub = &self.changes().hub;
        if let Some(watched) = hub.jobs().get(id) {
            return Ok(watched.latest.subscribe());
        }
        let found = read(self, id).await?;
        let mut jobs = hub.jobs();
        if let Some(watched) = jobs.get(id) {
            return Ok(watched.latest.subscribe());
        }
        let watched = Arc::new(Watched { changed: Notify::new(), latest: watch::Sender::new(found) });
        // The row may have changed between reading it and registering the watch.
        watched.changed.notify_one();
        let latest = watched.latest.subscribe();
        jobs.insert(id.to_owned(), Arc::clone(&watched));
        drop(jobs);
        tokio::spawn(refresh(self.clone(), id.to_owned(), watched));
        Ok(latest)
    }
}

async fn read(store: &Store, id: &str) -> Result<Option<Arc<JobRow>>> {
    Ok(match store.get(id, None).await? {
        Lookup::Found(job) => Some(Arc::from(job)),
        Lookup::Expired | Lookup::Missing => None,
    })
}

/// Reads a watched job whenever it changed, until it has no watchers.
async fn refresh(store: Store, id: String, watched: Arc<Watched>) {
    let hub = Arc::clone(&store.changes().hub);
    let poll_interval = store.changes().poll_interval;
    loop {
        tokio::select! {
            () = watched.changed.notified() => {}
            () = watched.latest.closed() => {}
            () = tokio::time::sleep(poll_interval) => {}
        }
        {
            let mut jobs = hub.jobs();
            // This check holds the lock, so that no watcher can subscribe in between.
            if watched.latest.receiver_count() == 0 {
                jobs.remove(&id);
                return;
            }
        }
        match read(&store, &id).await {
            Ok(job) => {
                watched.latest.send_if_modified(|latest| {
                    let point = |job: &Option<Arc<JobRow>>| job.as_ref().map(|job| job.event_id());
                    let changed = point(latest) != point(&job);
                    *latest = job;
                    changed
                });
            }
            Err(StoreError::Unavailable(error)) => tracing::warn!(%error, job = %id, "cannot read a watched job"),
            Err(error) => tracing::error!(%error, job = %id, "cannot read a watched job"),
        }
    }
}
