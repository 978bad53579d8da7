//! The history of a job's status, and the identifiers of its events.

use std::fmt;
use std::str::FromStr;

use super::tx::Row;
use super::{Result, StoreError};
use crate::status::Status;

/// Point in a job's life, written as `attempt.sequence` in server-sent events. Later points compare greater.
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

/// A change of a job's status.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StatusEvent {
    pub id: EventId,
    pub status: Status,
    pub at_ms: i64,
}

impl StatusEvent {
    pub(super) fn new(attempt: i64, sequence: i64, status: Status, at_ms: i64) -> Self {
        Self { id: EventId { attempt, sequence }, status, at_ms }
    }

    /// Returns the line that the column `history` keeps.
    pub(super) fn line(&self) -> String {
        format!("{} {} {} {}\n", self.id.attempt, self.id.sequence, self.status.name(), self.at_ms)
    }
}

/// Returns an SQL expression for the column `history` with a new last line, which records the change to `status`. The
/// line has the given attempt and the sequence number after the change.
pub(super) fn history_line(attempt: &str, status: Status) -> String {
    format!("history || {attempt} || ' ' || (sequence + 1) || ' {} ' || now_ms() || '\n'", status.name())
}

/// Returns the SQL assignments common to every end of a job. `$2` is the retention.
pub(super) fn ending(status: Status) -> String {
    format!(
        "status = '{}', sequence = sequence + 1, finished_at = now_ms(), expires_at = now_ms() + $2, \
         worker = NULL, lease_until = NULL, history = {}",
        status.name(),
        history_line("attempt", status)
    )
}

pub(super) fn read_history(text: &str) -> Result<Vec<StatusEvent>> {
    let line = |line: &str| {
        let mut words = line.split(' ');
        let number = |word: Option<&str>| word?.parse::<i64>().ok();
        let (attempt, sequence) = (number(words.next())?, number(words.next())?);
        Some(StatusEvent::new(attempt, sequence, Status::from_name(words.next()?)?, number(words.next())?))
    };
    let read = |text: &str| line(text).ok_or_else(|| StoreError::Internal(format!("unreadable history line {text:?}")));
    text.lines().map(read).collect()
}

pub(super) fn read_status(row: &Row) -> Result<Status> {
    let name: String = row.get("status")?;
    Status::from_name(&name).ok_or_else(|| StoreError::Internal(format!("unknown status {name:?}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn event_ids_are_parsed_and_sorted_by_attempt_first() {
        let id: EventId = "2.17".parse().unwrap();
        assert_eq!(id, EventId { attempt: 2, sequence: 17 });
        assert_eq!(id.to_string(), "2.17");
        assert!(id < "3.1".parse().unwrap());
        for bad in ["", "2", ".", "2.", ".1", "-1.2", "1.+2", "1.2.3", "a.b", "99999999999999999999.1"] {
            assert!(bad.parse::<EventId>().is_err(), "{bad}");
        }
    }
}
