//! News of changes: wake-ups for workers, and one shared view of each watched job.
//!
//! A thousand watchers of one job cost one read a change, because they share a task that reads the row and a channel
//! that hands it round. Changes of this process arrive at once. On PostgreSQL those of other instances arrive by
//! LISTEN/NOTIFY: NOTIFY takes a lock that serialises commits, so it is sent apart from the writes and gathers the
//! changes of `NOTIFY_INTERVAL`; and because a notification can be lost (a connection that broke, a writer that died
//! before it sent it), every watched job is also looked at each poll interval.

use std::collections::{BTreeSet, HashMap};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use sqlx::PgPool;
use sqlx::postgres::PgListener;
use tokio::sync::{Notify, mpsc, watch};
use tokio::task::JoinHandle;

use super::engine::{Engine, Kind, Result};
use super::record::{JobRow, Lookup};
use super::{Store, StoreError};

const CHANNEL: &str = "plateau_changes";
const NOTIFY_INTERVAL: Duration = Duration::from_millis(20);
/// PostgreSQL takes payloads below 8000 bytes.
const PAYLOAD_BYTES: usize = 7900;
/// A job id that is no job: there may be work.
const WORK: &str = "*";
const RECONNECT_DELAY: Duration = Duration::from_secs(1);

#[derive(Debug)]
pub(super) struct Changes {
    hub: Arc<Hub>,
    /// Ids to tell other instances about; `None` on SQLite.
    outgoing: Option<mpsc::UnboundedSender<String>>,
    poll_interval: Duration,
    tasks: Vec<JoinHandle<()>>,
}

/// What this process watches.
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
        // Nothing panics while it is held, and a map is never half changed.
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
    pub(super) fn new(engine: &Engine, poll_interval: Duration) -> Self {
        let hub = Arc::new(Hub { work: watch::Sender::new(0), jobs: Mutex::default() });
        let (outgoing, tasks) = match &engine.kind {
            Kind::Sqlite(_) => (None, Vec::new()),
            Kind::Postgres(pool) => {
                let (outgoing, changes) = mpsc::unbounded_channel();
                let tasks = vec![
                    tokio::spawn(listen(pool.clone(), Arc::clone(&hub))),
                    tokio::spawn(notify(pool.clone(), changes)),
                ];
                (Some(outgoing), tasks)
            }
        };
        Self { hub, outgoing, poll_interval, tasks }
    }

    pub(super) fn changed(&self, id: &str) {
        self.hub.changed(id);
        if let Some(outgoing) = &self.outgoing {
            // Fails only when the store is being closed.
            let _ = outgoing.send(id.to_owned());
        }
    }

    pub(super) fn work(&self) {
        self.changed(WORK);
    }

    /// How often work has been heard of: what [`work_signal`](Self::work_signal) says.
    pub(super) fn work_so_far(&self) -> u64 {
        *self.hub.work.borrow()
    }

    pub(super) fn work_signal(&self) -> watch::Receiver<u64> {
        self.hub.work.subscribe()
    }

    pub(super) fn stop(&self) {
        for task in &self.tasks {
            task.abort();
        }
    }
}

impl Drop for Changes {
    fn drop(&mut self) {
        self.stop();
    }
}

/// Tells other instances what changed here, at most once an interval.
async fn notify(pool: PgPool, mut changes: mpsc::UnboundedReceiver<String>) {
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
            let sent = sqlx::query("SELECT pg_notify($1, $2)").bind(CHANNEL).bind(payload).execute(&pool).await;
            if let Err(error) = sent {
                tracing::warn!(%error, "telling other instances of changes; they will find out by polling");
            }
        }
        tokio::time::sleep(NOTIFY_INTERVAL).await;
    }
}

/// Hears what changed, here and elsewhere, for ever.
async fn listen(pool: PgPool, hub: Arc<Hub>) {
    loop {
        if let Err(error) = listen_once(&pool, &hub).await {
            tracing::warn!(%error, "listening for changes; polling meanwhile");
        }
        tokio::time::sleep(RECONNECT_DELAY).await;
    }
}

async fn listen_once(pool: &PgPool, hub: &Hub) -> sqlx::Result<()> {
    let mut listener = PgListener::connect_with(pool).await?;
    listener.listen(CHANNEL).await?;
    // Whatever was said before the connection stood is lost.
    hub.everything_may_have_changed();
    while let Some(notification) = listener.try_recv().await? {
        for id in notification.payload().lines() {
            hub.changed(id);
        }
    }
    Ok(())
}

/// A shared view of one job. Dropping the last one ends the reading.
#[derive(Debug)]
pub struct JobWatch {
    latest: watch::Receiver<Option<Arc<JobRow>>>,
}

impl JobWatch {
    /// The job as last read; `None` once it has been deleted or has expired.
    pub fn current(&mut self) -> Option<Arc<JobRow>> {
        self.latest.borrow_and_update().clone()
    }

    /// Waits until the job differs from what `current` last gave. Never returns an error: when nothing can change any
    /// more (the store was closed) it waits for ever, so give it a time limit.
    pub async fn changed(&mut self) {
        if self.latest.changed().await.is_err() {
            std::future::pending::<()>().await;
        }
    }

    /// Waits until the job has ended and returns it; `None` if it was deleted or has expired.
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
    /// Watches a job of `owner`'s; any if none is given. The caller gets the job as it is now together with the watch,
    /// which starts from that state.
    pub async fn watch(&self, id: &str, owner: Option<&str>) -> Result<std::result::Result<JobWatch, Lookup>> {
        let latest = self.subscribe(id).await?;
        let mine = match (&*latest.borrow(), owner) {
            (Some(job), Some(owner)) => job.owner.as_deref() == Some(owner),
            (Some(_), None) => true,
            (None, _) => false,
        };
        if mine { Ok(Ok(JobWatch { latest })) } else { self.get(id, owner).await.map(Err) }
    }

    /// The channel on which the task of this job hands round what it reads; starts the task if there is none.
    async fn subscribe(&self, id: &str) -> Result<watch::Receiver<Option<Arc<JobRow>>>> {
        let hub = &self.inner.changes.hub;
        if let Some(watched) = hub.jobs().get(id) {
            return Ok(watched.latest.subscribe());
        }
        let found = read(self, id).await?;
        let mut jobs = hub.jobs();
        if let Some(watched) = jobs.get(id) {
            return Ok(watched.latest.subscribe());
        }
        let watched = Arc::new(Watched { changed: Notify::new(), latest: watch::Sender::new(found) });
        // The row may have changed between the read and the registration.
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

/// Reads a watched job whenever it changed, until nobody watches.
async fn refresh(store: Store, id: String, watched: Arc<Watched>) {
    let hub = Arc::clone(&store.inner.changes.hub);
    let poll_interval = store.inner.changes.poll_interval;
    loop {
        tokio::select! {
            () = watched.changed.notified() => {}
            () = watched.latest.closed() => {}
            () = tokio::time::sleep(poll_interval) => {}
        }
        {
            let mut jobs = hub.jobs();
            // Under the lock, so that nobody subscribes in between.
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
            Err(StoreError::Unavailable(error)) => tracing::warn!(%error, job = %id, "reading a watched job"),
            Err(error) => tracing::error!(%error, job = %id, "reading a watched job"),
        }
    }
}
