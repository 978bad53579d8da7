//! Reading jobs: one, or a page of a list.

use std::fmt;
use std::str::FromStr;

use super::engine::Result;
use super::sql::{Row, Value};
use super::{Store, StoreError};

/// Where a job is in its life.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Status {
    Queued,
    Running,
    Succeeded,
    Failed,
    Cancelled,
}

impl Status {
    pub const ALL: [Self; 5] = [Self::Queued, Self::Running, Self::Succeeded, Self::Failed, Self::Cancelled];

    pub fn name(self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Succeeded => "succeeded",
            Self::Failed => "failed",
            Self::Cancelled => "cancelled",
        }
    }

    /// True if nothing changes any more.
    pub fn is_final(self) -> bool {
        !matches!(self, Self::Queued | Self::Running)
    }
}

impl fmt::Display for Status {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

impl FromStr for Status {
    type Err = StoreError;

    fn from_str(text: &str) -> Result<Self> {
        Self::ALL
            .into_iter()
            .find(|status| status.name() == text)
            .ok_or_else(|| StoreError::Internal(format!("unknown status {text:?}")))
    }
}

/// A point in a job's life, as server-sent events name it: `attempt.sequence`. Later points compare greater.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EventId {
    pub attempt: i64,
    pub sequence: i64,
}

impl fmt::Display for EventId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}.{}", self.attempt, self.sequence)
    }
}

impl FromStr for EventId {
    type Err = ();

    fn from_str(text: &str) -> std::result::Result<Self, ()> {
        let (attempt, sequence) = text.split_once('.').ok_or(())?;
        let number = |digits: &str| {
            if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
                return Err(());
            }
            digits.parse().map_err(|_| ())
        };
        Ok(Self { attempt: number(attempt)?, sequence: number(sequence)? })
    }
}

/// A change of status in a job's past.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StatusEvent {
    pub id: EventId,
    pub status: Status,
    pub at_ms: i64,
}

impl StatusEvent {
    /// As the history keeps it.
    pub(super) fn line(&self) -> String {
        format!("{} {} {} {}\n", self.id.attempt, self.id.sequence, self.status, self.at_ms)
    }
}

/// A job without its request and its mesh. `progress`, `statistics`, `warnings` and `error` are the JSON texts that
/// were put in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JobRow {
    pub id: String,
    pub kind: String,
    pub owner: Option<String>,
    pub status: Status,
    pub attempt: i64,
    pub sequence: i64,
    pub created_at_ms: i64,
    /// When the current attempt started.
    pub started_at_ms: Option<i64>,
    pub finished_at_ms: Option<i64>,
    pub expires_at_ms: Option<i64>,
    pub progress: Option<String>,
    /// The `sequence` at which `progress` was written; 0 if there is none.
    pub progress_sequence: i64,
    pub statistics: Option<String>,
    pub warnings: String,
    pub error: Option<String>,
    /// Names the artefact's bytes: equal for equal bytes only.
    pub artefact: Option<Vec<u8>>,
    /// Every change of status so far, oldest first.
    pub history: Vec<StatusEvent>,
}

/// The columns that `JobRow::read` expects, in its order.
pub(super) const COLUMNS: &str = "id, kind, owner, status, attempt, sequence, created_at, started_at, finished_at, \
     expires_at, progress, progress_sequence, statistics, warnings, error, artefact, history";

impl JobRow {
    pub(super) fn read(row: &Row) -> Result<Self> {
        let owner = row.text(2)?;
        Ok(Self {
            id: row.text(0)?,
            kind: row.text(1)?,
            owner: (!owner.is_empty()).then_some(owner),
            status: row.text(3)?.parse()?,
            attempt: row.int(4)?,
            sequence: row.int(5)?,
            created_at_ms: row.int(6)?,
            started_at_ms: row.optional_int(7)?,
            finished_at_ms: row.optional_int(8)?,
            expires_at_ms: row.optional_int(9)?,
            progress: row.optional_text(10)?,
            progress_sequence: row.int(11)?,
            statistics: row.optional_text(12)?,
            warnings: row.text(13)?,
            error: row.optional_text(14)?,
            artefact: row.optional_bytes(15)?,
            history: read_history(&row.text(16)?)?,
        })
    }

    /// The latest point of the job's life.
    pub fn event_id(&self) -> EventId {
        EventId { attempt: self.attempt, sequence: self.sequence }
    }

    /// The status changes after `last`, oldest first; all of them without one.
    pub fn events_since(&self, last: Option<EventId>) -> impl Iterator<Item = &StatusEvent> {
        self.history.iter().filter(move |event| last.is_none_or(|last| event.id > last))
    }

    /// The latest progress if it came after `last`.
    pub fn progress_since(&self, last: Option<EventId>) -> Option<(EventId, &str)> {
        let id = EventId { attempt: self.attempt, sequence: self.progress_sequence };
        let progress = self.progress.as_deref()?;
        last.is_none_or(|last| id > last).then_some((id, progress))
    }
}

fn read_history(text: &str) -> Result<Vec<StatusEvent>> {
    text.lines()
        .map(|line| {
            let broken = || StoreError::Internal(format!("unreadable history line {line:?}"));
            let mut words = line.split(' ');
            let mut word = || words.next().ok_or_else(broken);
            let number = |text: &str| text.parse::<i64>().map_err(|_| broken());
            Ok(StatusEvent {
                id: EventId { attempt: number(word()?)?, sequence: number(word()?)? },
                status: word()?.parse()?,
                at_ms: number(word()?)?,
            })
        })
        .collect()
}

/// What became of a job id.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Lookup {
    Found(Box<JobRow>),
    /// It was there; its time has run out.
    Expired,
    /// Never there, deleted, or another owner's.
    Missing,
}

/// Which jobs a list shows; all by default.
#[derive(Debug, Clone, Default)]
pub struct Filter {
    pub owner: Option<String>,
    pub kind: Option<String>,
    pub status: Option<Status>,
    pub idempotency_key: Option<String>,
}

impl Store {
    pub async fn get(&self, id: &str, owner: Option<&str>) -> Result<Lookup> {
        let engine = &self.inner.engine;
        let text = format!("SELECT {COLUMNS} FROM jobs WHERE id = $1 AND ($2 = '' OR owner = $2)");
        let key = vec![id.into(), owner.unwrap_or_default().into()];
        if let Some(row) = engine.row(&text, key.clone()).await? {
            return Ok(Lookup::Found(Box::new(JobRow::read(&row)?)));
        }
        let gone = "SELECT 1 FROM expired_jobs WHERE id = $1 AND ($2 = '' OR owner = $2)";
        Ok(if engine.row(gone, key).await?.is_some() { Lookup::Expired } else { Lookup::Missing })
    }

    /// At most `limit` jobs, newest first, and the cursor of the next page if there is one. A cursor is the last id of
    /// the page before, so jobs that come or go between pages neither repeat nor hide others.
    pub async fn list(
        &self,
        filter: &Filter,
        limit: u32,
        cursor: Option<&str>,
    ) -> Result<(Vec<JobRow>, Option<String>)> {
        let mut values: Vec<Value> = vec![(i64::from(limit) + 1).into()];
        let mut conditions = String::new();
        let mut require = |condition: &str, value: Option<&str>| {
            if let Some(value) = value {
                values.push(value.into());
                conditions.push_str(if conditions.is_empty() { "WHERE " } else { " AND " });
                conditions.push_str(&format!("{condition} ${}", values.len()));
            }
        };
        require("owner =", filter.owner.as_deref());
        require("kind =", filter.kind.as_deref());
        require("status =", filter.status.map(Status::name));
        require("idempotency_key =", filter.idempotency_key.as_deref());
        require("id <", cursor);
        let text = format!("SELECT {COLUMNS} FROM jobs {conditions} ORDER BY id DESC LIMIT $1");
        let mut jobs =
            self.inner.engine.rows(&text, values).await?.iter().map(JobRow::read).collect::<Result<Vec<_>>>()?;
        let more = jobs.len() > limit as usize;
        jobs.truncate(limit as usize);
        let next = if more { jobs.last().map(|job| job.id.clone()) } else { None };
        Ok((jobs, next))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn event_ids_read_back_and_sort_by_attempt_first() {
        let id: EventId = "2.17".parse().unwrap();
        assert_eq!(id, EventId { attempt: 2, sequence: 17 });
        assert_eq!(id.to_string(), "2.17");
        assert!(id < "3.1".parse().unwrap());
        for bad in ["", "2", ".", "2.", ".1", "-1.2", "1.+2", "1.2.3", "a.b", "99999999999999999999.1"] {
            assert!(bad.parse::<EventId>().is_err(), "{bad}");
        }
    }
}
