//! Views of watched jobs. A view is read again whenever its job has changed, once for all watchers.

use std::sync::Arc;

use tokio::sync::{Notify, watch};

use super::changes::Watched;
use super::handle::Store;
use super::jobs::{self, JobRow, Lookup};
use super::{Result, StoreError, owned};

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
        if visible { Ok(Ok(JobWatch { latest })) } else { look_up(self, id, owner).await.map(Err) }
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

async fn look_up(store: &Store, id: &str, owner: Option<&str>) -> Result<Lookup> {
    let (id, owner) = owned(id, owner);
    store.read(move |tx| jobs::get(tx, &id, owner.as_deref())).await
}

async fn read(store: &Store, id: &str) -> Result<Option<Arc<JobRow>>> {
    Ok(match look_up(store, id, None).await? {
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
