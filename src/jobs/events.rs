//! The events of one job, for a client that follows it.

use super::{Jobs, JobsError};
use crate::status::Status;
use crate::store::{EventId, JobRow, JobWatch, StatusEvent};
use serde_json::json;
use std::collections::VecDeque;

/// Something that happened to a job.
#[derive(Clone, Debug)]
pub struct Event {
    /// `attempt.sequence`: later events have later ids.
    pub id: String,
    /// `status` or `progress`.
    pub name: &'static str,
    /// JSON. Of a `status` event: the job as it was after that change. Of a `progress` event: id, status and progress.
    pub data: String,
}

/// The events of a job, from some point on.
#[derive(Debug)]
pub struct Events {
    jobs: Jobs,
    watch: JobWatch,
    last: Option<EventId>,
    pending: VecDeque<Event>,
    /// False until the job has been looked at once.
    begun: bool,
    ended: bool,
}

impl Jobs {
    /// The events of a job after the one with the id `last`; all of them without one. `None` if the client has seen the final one.
    ///
    /// # Errors
    /// As [`Jobs::get`].
    pub async fn events(&self, id: &str, owner: Option<&str>, last: Option<&str>) -> Result<Option<Events>, JobsError> {
        let last: Option<EventId> = last.and_then(|text| text.parse().ok());
        let mut watch = self.watch(id, owner).await?;
        let nothing_follows =
            watch.current().is_some_and(|row| row.status.is_final() && row.events_since(last).next().is_none());
        if last.is_some() && nothing_follows {
            return Ok(None);
        }
        Ok(Some(Events { jobs: self.clone(), watch, last, pending: VecDeque::new(), begun: false, ended: false }))
    }
}

impl Events {
    /// The next event, as soon as there is one. `None` after the final one, once the job is gone, and when this server shuts down:
    /// the client then comes back with the last id that it has seen.
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
            let row = self.watch.current()?;
            self.queue(&row);
        }
    }

    /// Queues what happened since the last event: changes of status, and the latest progress, in the order of their ids.
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
            self.last = Some(id);
            self.pending.push_back(Event { id: id.to_string(), name, data });
        }
        self.ended = row.status.is_final();
    }
}

/// A job as it was right after a change of its status.
fn as_of(row: &JobRow, change: &StatusEvent) -> JobRow {
    let followed = row.events_since(Some(change.id)).next().is_some();
    if !followed {
        return row.clone();
    }
    // Only the last change of all can be to a final status, so this one was to `queued` or `running`.
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
        ..row.clone()
    }
}
