//! Events of one job, for a client that follows it.

use super::{Jobs, JobsError};
use crate::status::{CancelReason, Status};
use crate::store::{EventId, JobRow, JobWatch, StatusEvent};
use serde_json::json;
use std::collections::VecDeque;
use std::sync::Arc;

/// A change of a job's status, or its progress.
#[derive(Clone, Debug)]
pub struct Event {
    /// Identifier of the form `attempt.sequence`. Later events have larger identifiers.
    pub id: String,
    /// `status` or `progress`.
    pub name: &'static str,
    /// JSON text. For a `status` event it is the job as it was right after that change. For a `progress` event it has
    /// the identifier, status and progress.
    pub data: String,
}

/// Stream of a job's events from a given event on.
#[derive(Debug)]
pub struct Events {
    jobs: Jobs,
    watch: JobWatch,
    last: Option<EventId>,
    /// The job as it was read last.
    row: Option<Arc<JobRow>>,
    pending: VecDeque<Event>,
    /// False until the job has been read once.
    begun: bool,
    ended: bool,
}

impl Jobs {
    /// Returns the events of a job after the one with the identifier `last`, or all events if `last` is absent. Returns
    /// `None` if the client has seen the final event.
    ///
    /// # Errors
    /// Returns the errors of [`Jobs::get`].
    pub async fn events(
        &self,
        id: &str,
        owner: Option<&str>,
        last: Option<EventId>,
    ) -> Result<Option<Events>, JobsError> {
        let mut watch = self.watch(id, owner).await?;
        let nothing_follows =
            watch.current().is_some_and(|row| row.status.is_final() && row.events_since(last).next().is_none());
        if last.is_some() && nothing_follows {
            return Ok(None);
        }
        Ok(Some(Events {
            jobs: self.clone(),
            watch,
            last,
            row: None,
            pending: VecDeque::new(),
            begun: false,
            ended: false,
        }))
    }
}

impl Events {
    /// Waits for the next event. The final event of a job that is deleted says so. Returns `None` after the final
    /// event, when a finished job has been removed, and when this server shuts down. After a shutdown the client
    /// reconnects with the last identifier that it has seen.
    pub async fn next(&mut self) -> Option<Event> {
        loop {
            if let Some(event) = self.pending.pop_front() {
                return Some(event);
            }
            if self.ended {
                return None;
            }
            if self.begun {
                tokio::select! {
                    () = self.watch.changed() => {}
                    () = self.jobs.shutdown() => return None,
                }
            }
            self.begun = true;
            match self.watch.current() {
                Some(row) => {
                    self.queue(&row);
                    self.row = Some(row);
                }
                None => {
                    let row = self.row.take()?;
                    let row = deleted(&row);
                    let job = self.jobs.view(&row).ok()?;
                    self.push(row.event_id(), "status", serde_json::to_string(&job).unwrap_or_default());
                    self.ended = true;
                }
            }
        }
    }

    /// Queues the status changes and the latest progress since the last event, in the order of their identifiers.
    fn queue(&mut self, row: &JobRow) {
        let mut events: Vec<(EventId, &str, String)> = Vec::new();
        for change in row.events_since(self.last) {
            let Ok(job) = self.jobs.view(&as_of(row, change)) else {
                self.ended = true;
                return;
            };
            events.push((change.id, "status", serde_json::to_string(&job).unwrap_or_default()));
        }
        if !row.status.is_final()
            && let Some((id, progress)) = row.progress_since(self.last)
        {
            let (id_text, status) = (json!(row.id), row.status.name());
            events.push((id, "progress", format!(r#"{{"id":{id_text},"status":"{status}","progress":{progress}}}"#)));
        }
        events.sort_by_key(|&(id, ..)| id);
        for (id, name, data) in events {
            self.push(id, name, data);
        }
        self.ended = row.status.is_final();
    }

    fn push(&mut self, id: EventId, name: &'static str, data: String) {
        self.last = Some(id);
        self.pending.push_back(Event { id: id.to_string(), name, data });
    }
}

/// Returns the job as it was right after a change of its status.
fn as_of(row: &JobRow, change: &StatusEvent) -> JobRow {
    let followed = row.events_since(Some(change.id)).next().is_some();
    if !followed {
        return row.clone();
    }
    // Only the last change can be to a final status, so this change was to `queued` or `running`.
    JobRow {
        status: change.status,
        attempt: change.id.attempt,
        sequence: change.id.sequence,
        started_at_ms: (change.status == Status::Running).then_some(change.at_ms),
        finished_at_ms: None,
        expires_at_ms: None,
        progress: None,
        progress_sequence: 0,
        statistics: None,
        warnings: "[]".into(),
        error: None,
        artefact: None,
        cancelled_because: None,
        successor: None,
        ..row.clone()
    }
}

/// Returns a job that was removed before it had ended, as its last event shows it.
fn deleted(row: &JobRow) -> JobRow {
    JobRow {
        status: Status::Cancelled,
        cancelled_because: Some(CancelReason::Deleted),
        sequence: row.sequence + 1,
        progress: None,
        ..row.clone()
    }
}
